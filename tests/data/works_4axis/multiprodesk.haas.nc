%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works_4axis.cls)
(MACHINE MultiProDesk, CONTROL Haas, MODE axes)
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
(linear limits not checked: no travel declared [Y X Z])
(valid only for part origin X10 Y-20 Z35 from the reference point of the)
(table, do not touch off again)
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
(CONDITION setting 130 has how fast a tap comes out, 133 whether the spindle)
(is oriented before it)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G254 dynamic work)
(offset, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
(OPERATION ARCS)
N1 G21 G17 G40 G49 G80 G90 G94 G54
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
M09
G53 G00 Z0.
(T1 stays in the spindle)
S4000 M03
G00 A-25.
X-11. Y-12.949
G43 H1 Z34.45
M08
G01 Z2.45 F300.
X14. F700.
G02 X14. Y-32.949 I0. J-10.
G01 X-11.
Y-12.949
Z34.45
M09
G00 Z94.45
G49 G53 G00 Z0.
(OPERATION HOLES)
N3 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
M05
T2 M06
T1
G49 G53 G00 Z0.
S2500 M03
G00 A-25.
X-8. Y-22.949
G43 H2 Z29.45
M08
G98 G81 X-8. Y-22.949 Z-1.55 R6.45 F150.
X4.
G80
G98 G82 X16. Y-22.949 Z-1.55 R6.45 P0.5 F150.
G80
G98 G83 X-8. Y-34.949 Z-10.55 R6.45 Q4. F150.
G80
G98 G83 X4. Y-34.949 Z-6.55 R10.45 Q4. F150.
G80
G98 G73 X16. Y-34.949 Z-6.55 R6.45 Q4. F150.
G80
G98 G85 X4. Y-10.949 Z-1.55 R6.45 F80.
G80
M09
G00 Z89.45
G49 G53 G00 Z0.
M05
M00
G49 G53 G00 Z0.
(OPERATION SWARF)
N4 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T1 M06
T3
G49 G53 G00 Z0.
S4000 M03
G00 A34.377
X-10. Y16.269
G43 H1 Z37.594
M08
G01 Z7.594 F300.
G93 X-9.6 Y15.148 Z9.693 A30.939 F564.835
X-9.2 Y13.902 Z11.809 A27.502 F563.718
X-8.8 Y12.533 Z13.758 A24.064 F566.237
X-8.4 Y11.047 Z15.711 A20.626 F565.285
X-8. Y9.449 Z17.482 A17.188 F568.137
X-7.6 Y7.746 Z19.243 A13.751 F567.202
X-7.2 Y5.943 Z20.809 A10.313 F569.98
X-6.8 Y4.046 Z22.354 A6.875 F569.271
X-6.4 Y2.062 Z23.693 A3.437 F572.727
X-6. Y0. Z25. A0. F571.667
X-5.6 Y-2.135 Z26.091 A-3.438 F575.206
X-5.2 Y-4.333 Z27.142 A-6.875 F574.187
X-4.8 Y-6.589 Z27.97 A-10.313 F578.105
X-4.4 Y-8.893 Z28.751 A-13.751 F577.043
X-4. Y-11.237 Z29.302 A-17.189 F580.066
X-3.6 Y-13.611 Z29.802 A-20.626 F579.847
X-3.2 Y-16.01 Z30.068 A-24.064 F580.073
X-2.8 Y-18.422 Z30.28 A-27.502 F580.073
X-2.4 Y-20.841 Z30.258 A-30.94 F580.062
X-2. Y-23.255 Z30.18 A-34.377 F580.062
X-1.6 Y-25.659 Z29.867 A-37.815 F580.068
X-1.2 Y-28.042 Z29.501 A-41.253 F580.068
X-0.8 Y-30.397 Z28.903 A-44.691 F579.145
X-0.4 Y-32.713 Z28.254 A-48.128 F579.924
X0. Y-34.984 Z27.378 A-51.566 F575.958
X0.4 Y-37.201 Z26.457 A-55.004 F576.879
X0.8 Y-39.357 Z25.315 A-58.442 F573.527
X1.2 Y-41.442 Z24.136 A-61.879 F574.372
X1.6 Y-43.45 Z22.744 A-65.317 F570.601
X2. Y-45.374 Z21.323 A-68.755 F571.666
X2.4 Y-47.207 Z19.7 A-72.193 F568.574
X2.8 Y-48.941 Z18.061 A-75.63 F569.466
X3.2 Y-50.572 Z16.23 A-79.068 F566.557
X3.6 Y-52.093 Z14.394 A-82.506 F567.494
X4. Y-53.498 Z12.381 A-85.944 F564.668
X4.4 Y-54.782 Z10.377 A-89.381 F565.706
X4.8 Y-55.941 Z8.209 A-92.819 F563.104
X5.2 Y-56.971 Z6.066 A-96.257 F564.162
X5.6 Y-57.868 Z3.775 A-99.695 F562.122
X6. Y-58.628 Z1.525 A-103.132 F563.026
X6.4 Y-59.25 Z-0.857 A-106.57 F561.397
X6.8 Y-59.731 Z-3.182 A-110.008 F562.391
X7.067 Y-59.972 Z-4.817 A-112.3 F853.681
X7.333 Y-60.148 Z-6.419 A-114.591 F855.387
X7.6 Y-60.261 Z-7.987 A-116.883 F855.079
X7.867 Y-60.31 Z-9.639 A-119.175 F853.984
X8.133 Y-60.293 Z-11.251 A-121.467 F854.898
X8.4 Y-60.212 Z-12.822 A-123.759 F854.446
X8.667 Y-60.068 Z-14.468 A-126.051 F854.425
X8.933 Y-59.858 Z-16.066 A-128.342 F855.306
X9.2 Y-59.585 Z-17.615 A-130.634 F854.773
G94
G00 Z12.385
M09
Z72.385
G49 G53 G00 Z0.
(OPERATION THREAD)
N5 G21 G17 G40 G49 G80 G90 G94 G54
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
