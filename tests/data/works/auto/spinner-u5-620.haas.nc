%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works.cls)
(MACHINE SpinnerU5620, CONTROL Haas, MODE auto [plane, tcp])
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
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
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
(linear limits not checked: no travel declared [X Y Z])
(the entries of C and B in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -7.398 to 36.793)
(T2 DIA 5 L130 H2, 1 operation, tip Z -15.078 to 28.689)
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
G00 B0. C0.
X12. Y0.
G43 H1 Z20.
M08
Z2.
G03 X12. Y0. Z-0.4 I-12. J0. F200.
X0. Y12. Z-1. I-12. J0.
G01 X-20. F600.
G03 X-20. Y-12. I0. J-12.
G01 X0.
G02 X8. Y-20. I0. J-8.
X8. Y-20. I-8. J0.
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
G00 B25. C40.107
G254
G00 X-12.56 Y3.165
G43 H1 Z34.739
M08
G01 Z2.739 F300.
X7.312 Y-12.004 F700.
G03 X19.447 Y3.893 I6.067 J7.949
G01 X-0.425 Y19.063
X-12.56 Y3.165
Z34.739
M09
G00 Z94.739
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
G00 B25. C40.107
G254
G00 X-4.108 Y9.294
G43 H2 Z29.739
M08
G98 G81 X-4.108 Y9.294 Z-1.261 R6.739 F150.
X5.431 Y2.012
G80
G98 G82 X14.969 Y-5.269 Z-1.261 R6.739 P0.5 F150.
G80
G98 G83 X3.174 Y18.832 Z-10.261 R6.739 Q4. F150.
G80
G98 G83 X12.712 Y11.551 Z-6.261 R10.739 Q4. F150.
G80
G98 G73 X22.251 Y4.269 Z-6.261 R6.739 Q4. F150.
G80
G98 G85 X-1.851 Y-7.526 Z-1.261 R6.739 F80.
G80
M09
G00 Z89.739
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
G00 B25.783 C-22.918
G254
G00 X29.188 Y0.
G255
G00 G234 H1 X39.651 Y-16.764 Z22.013
M08
G01 X27.632 Y-11.683 Z-5. B25.783 C-22.918 F300.
X28.743 Y-7.323 B25.529 C-14.293 F900.
X29.853 Y-2.963 B25.783 C-5.668
X29.621 Y1.53 B25.529 C2.957
X29.389 Y6.023 B25.783 C11.582
X27.835 Y10.245 B25.529 C20.207
X26.281 Y14.467 B25.783 C28.832
X23.545 Y18.039 B25.529 C37.457
X20.809 Y21.61 B25.783 C46.082
X17.137 Y24.209 B25.529 C54.707
X13.465 Y26.809 B25.783 C63.332
X9.187 Y28.202 B25.529 C71.957
X4.909 Y29.596 B25.783 C80.582
X0.411 Y29.658 B25.529 C89.207
X-4.088 Y29.72 B25.783 C97.832
X-8.403 Y28.446 B25.529 C106.457
X-12.717 Y27.171 B25.783 C115.082
X-16.46 Y24.674 B25.529 C123.707
X-20.203 Y22.178 B25.783 C132.332
X-23.037 Y18.684 B25.529 C140.957
X-25.871 Y15.189 B25.783 C149.582
X-27.541 Y11.012 B25.529 C158.207
X-29.211 Y6.834 B25.783 C166.832
G00 X-54.623 Y12.78 Z49.027
G49 G53 G00 Z0.
G00 B25.783 C-193.168
G254
G00 X29.188 Y0.
G255
G00 G234 H1 X-54.623 Y12.78 Z49.027
G01 X-29.211 Y6.834 Z-5. B25.783 C-193.168 F900.
X-29.568 Y2.35 B25.529 C-184.543
X-29.924 Y-2.135 B25.783 C-175.918
X-28.934 Y-6.524 B25.529 C-167.293
X-27.945 Y-10.913 B25.783 C-158.668
X-25.698 Y-14.811 B25.529 C-150.043
X-23.452 Y-18.709 B25.783 C-141.418
X-20.15 Y-21.765 B25.529 C-132.793
X-16.849 Y-24.822 B25.783 C-124.168
X-12.79 Y-26.762 B25.529 C-115.543
X-8.73 Y-28.702 B25.783 C-106.918
X-4.278 Y-29.351 B25.529 C-98.293
X0.174 Y-30. B25.783 C-89.668
X4.618 Y-29.299 B25.529 C-81.043
X9.062 Y-28.599 B25.783 C-72.418
X13.099 Y-26.612 B25.529 C-63.793
X17.135 Y-24.625 B25.783 C-55.168
X20.401 Y-21.531 B25.529 C-46.543
X23.667 Y-18.436 B25.783 C-37.918
X25.868 Y-14.512 B25.529 C-29.293
X28.069 Y-10.589 B25.783 C-20.668
X29.008 Y-6.189 B25.529 C-12.043
X29.947 Y-1.789 B25.783 C-3.418
X29.538 Y2.692 B25.529 C5.207
X29.13 Y7.172 B25.783 C13.832
X27.412 Y11.33 B25.529 C22.457
X25.693 Y15.488 B25.783 C31.082
G00 X36.869 Y22.224 Z22.013
M09
X59.22 Y35.698 Z76.04
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
G00 B0. C0.
X-30. Y20.
G43 H3 Z25.
M08
G98 G84 X-30. Y20. Z-10. R4. F500.
X30.
G80
M09
G00 Z85.
G49 G53 G00 Z0.
M05
M30
%
