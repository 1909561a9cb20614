%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works_4axis.cls)
(MACHINE MultiProDesk, CONTROL Haas, MODE auto [plane, tcp])
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 5 of 6, the program begins with a complete restart:)
(modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given, the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
(KINEMATICS *)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must)
(not take the shortest path to an angle beyond 360)
(LINEAR WORDS under tip control are tip coordinates in a frame fixed to the)
(table, aligned with the machine axes when its rotary axes are at zero,)
(rotary axes move evenly)
(MODE tcp: G234 must move only the axes of its block, and G49 G53 straight to)
(the machine position)
(LINEAR WORDS in planes are tip coordinates along the axes of the machine,)
(from the zero that has moved with the table)
(linear limits not checked: no travel declared [Y X Z])
(the entries of A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -35.818 to 45.394)
(T2 DIA 5 L130 H2, 1 operation, tip Z -8.509 to 29.729)
(T3 DIA 6 L95 H3, 1 operation, tip Z -10 to 25)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
(CONDITION F under G234 is the speed of the tip)
(CONDITION setting 130 has how fast a tap comes out, 133 whether the spindle)
(is oriented before it)
(CONDITION the settings of the machine rotary zero point [254 to 257, or 300)
(to 305] are measured)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
(OPERATION ARCS)
N1 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
T1 M06
T2
G49 G53 G00 Z0.
S4000 M03
G00 A0.
X12. Y0.
G43 H1 Z20.
M08
Z2.
G02 X12. Y0. Z-0.4 I-12. J0. F200.
X0. Y-12. Z-1. I-12. J0.
G01 X-20. F600.
G02 X-20. Y12. I0. J12.
G01 X0.
G03 X8. Y20. I0. J8.
X8. Y20. I-8. J0.
G01 Z20.
M09
G00 Z80.
G49 G53 G00 Z0.
M05
M01
G49 G53 G00 Z0.
(OPERATION TILTED)
N2 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
(T1 stays in the spindle)
S4000 M03
G00 A-25.
G254
G00 X-11. Y3.717
G43 H1 Z29.277
M08
G01 Z-2.723 F300.
X14. F700.
G02 X14. Y-16.283 I0. J-10.
G01 X-11.
Y3.717
Z29.277
M09
G00 Z89.277
G49 G53 G00 Z0.
G255
(OPERATION HOLES)
N3 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
T2 M06
T1
G49 G53 G00 Z0.
S2500 M03
G00 A-25.
G254
G00 X-8. Y-6.283
G43 H2 Z24.277
M08
G98 G81 X-8. Y-6.283 Z-6.723 R1.277 F150.
X4.
G80
G98 G82 X16. Y-6.283 Z-6.723 R1.277 P0.5 F150.
G80
G98 G83 X-8. Y-18.283 Z-15.723 R1.277 Q4. F150.
G80
G98 G83 X4. Y-18.283 Z-11.723 R5.277 Q4. F150.
G80
G98 G73 X16. Y-18.283 Z-11.723 R1.277 Q4. F150.
G80
G98 G85 X4. Y5.717 Z-6.723 R1.277 F80.
G80
M09
G00 Z84.277
G49 G53 G00 Z0.
G255
M05
M00
G49 G53 G00 Z0.
(OPERATION SWARF)
N4 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
T1 M06
T3
G49 G53 G00 Z0.
S4000 M03
G00 A34.377
G254
G00 X-10. Y0.
G255
G00 G234 H1 X-10. Y-31.055 Z45.394
M08
G01 Y-14.116 Z20.633 A34.377 F300.
X-9.2 Y-11.545 Z22.175 A27.502 F900.
X-8.4 Y-8.807 Z23.397 A20.626
X-7.6 Y-5.943 Z24.283 A13.751
X-6.8 Y-2.993 Z24.82 A6.875
X-6. Y0. Z25. A0.
X-5.2 Y2.993 Z24.82 A-6.875
X-4.4 Y5.943 Z24.283 A-13.751
X-3.6 Y8.807 Z23.397 A-20.626
X-2.8 Y11.545 Z22.175 A-27.502
X-2. Y14.116 Z20.633 A-34.377
X-1.2 Y16.485 Z18.795 A-41.253
X-0.4 Y18.616 Z16.687 A-48.128
X0.4 Y20.48 Z14.338 A-55.004
X1.2 Y22.049 Z11.783 A-61.879
X2. Y23.301 Z9.059 A-68.755
X2.8 Y24.218 Z6.204 A-75.63
X3.6 Y24.787 Z3.261 A-82.506
X4.4 Y24.999 Z0.27 A-89.381
X5.2 Y24.851 Z-2.725 A-96.257
X6. Y24.346 Z-5.68 A-103.132
X6.8 Y23.491 Z-8.554 A-110.008
X7.6 Y22.298 Z-11.304 A-116.883
X8.4 Y20.785 Z-13.893 A-123.759
X9.2 Y18.972 Z-16.281 A-130.634
G00 Y41.738 Z-35.818
M09
Y87.271 Z-74.891
G49 G53 G00 Z0.
(OPERATION THREAD)
N5 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
T3 M06
T1
G49 G53 G00 Z0.
S500 M03
G00 A0.
X-30. Y-20.
G43 H3 Z25.
M08
G98 G84 X-30. Y-20. Z-10. R4. F500.
X30.
G80
M09
G00 Z85.
G49 G53 G00 Z0.
M05
M30
%
