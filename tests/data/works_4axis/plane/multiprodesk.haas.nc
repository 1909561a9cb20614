%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works_4axis.cls)
(MACHINE MultiProDesk, CONTROL Haas, MODE plane)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 3 of 6, the program begins with a complete restart:)
(modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given, the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
(KINEMATICS *)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(LINEAR WORDS are tip coordinates along the axes of the machine, from the)
(zero that has moved with the table)
(linear limits not checked: no travel declared [Y X Z])
(the entries of A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 2 operations, tip Z -4.039 to 24.963)
(T2 DIA 5 L130 H2, 1 operation, tip Z -8.509 to 29.729)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
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
M09
M05
M30
%
