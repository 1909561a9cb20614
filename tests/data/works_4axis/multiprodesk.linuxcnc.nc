(PROGRAM without name)
(CL FILE works_4axis.cls)
(MACHINE MultiProDesk, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 5 of 6; the program begins with a complete restart: modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given; the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
(KINEMATICS *)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [Y X Z])
(valid only for part origin X10 Y-20 Z35 from the reference point of the table; do not touch off again)
(the entries of A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -35.818 to 45.394)
(T2 DIA 5 L130 H2, 1 operation, tip Z -8.509 to 29.729)
(T3 DIA 6 L95 H3, 1 operation, tip Z -10 to 25)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
(OPERATION ARCS)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S4000 M3
G0 A0
X12 Y0
Z20
M8
Z2
G2 X12 Y0 Z-0.4 I-12 J0 F200
X0 Y-12 Z-1 I-12 J0
G1 X-20 F600
G2 X-20 Y12 I0 J12
G1 X0
G3 X8 Y20 I0 J8
X8 Y20 I-8 J0
G1 Z20
M9
G0 Z80
G53 G0 Z0
M5
M1
(OPERATION TILTED)
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
(T1 stays in the spindle)
G43 H1
S4000 M3
G0 A-25
X-11 Y-12.949
Z34.45
M8
G1 Z2.45 F300
X14 F700
G2 X14 Y-32.949 I0 J-10
G1 X-11
Y-12.949
Z34.45
M9
G0 Z94.45
(OPERATION HOLES)
N3 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000003 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000003 endif
M9
G53 G0 Z0
M5
T2 M6
G53 G0 Z0
G43 H2
S2500 M3
G0 A-25
X-8 Y-22.949
Z29.45
M8
G98 G81 X-8 Y-22.949 Z-1.55 R6.45 F150
X4
G80
G98 G82 X16 Y-22.949 Z-1.55 R6.45 P0.5 F150
G80
G98 G83 X-8 Y-34.949 Z-10.55 R6.45 Q4 F150
G80
G98 G83 X4 Y-34.949 Z-6.55 R10.45 Q4 F150
G80
G98 G73 X16 Y-34.949 Z-6.55 R6.45 Q4 F150
G80
G0 X4 Y-10.949 Z29.45
Z6.45
G1 Z-1.55 F80
Z6.45
G0 Z29.45
M9
Z89.45
G53 G0 Z0
M5
M0
(OPERATION SWARF)
N4 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000004 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000004 endif
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S4000 M3
G0 A34.3775
X-10 Y16.269
Z37.594
M8
G1 Z7.594 F300
G93 X-9.6 Y15.149 Z9.692 A30.9397 F564.566
X-9.2 Y13.902 Z11.809 A27.502 F563.853
X-8.8 Y12.533 Z13.758 A24.0642 F566.295
X-8.4 Y11.048 Z15.711 A20.6265 F565.034
X-8 Y9.45 Z17.481 A17.1887 F568.221
X-7.6 Y7.746 Z19.243 A13.751 F567.303
X-7.2 Y5.943 Z20.809 A10.3132 F570.048
X-6.8 Y4.046 Z22.354 A6.8755 F569.371
X-6.4 Y2.063 Z23.693 A3.4377 F572.45
X-6 Y0 Z25 A0 F571.765
X-5.6 Y-2.135 Z26.091 A-3.4378 F575.281
X-5.2 Y-4.334 Z27.143 A-6.8755 F574.228
X-4.8 Y-6.589 Z27.97 A-10.3133 F577.833
X-4.4 Y-8.893 Z28.751 A-13.751 F577.16
X-4 Y-11.237 Z29.302 A-17.1888 F580.066
X-3.6 Y-13.612 Z29.802 A-20.6265 F579.922
X-3.2 Y-16.01 Z30.068 A-24.0643 F580.073
X-2.8 Y-18.422 Z30.28 A-27.502 F580.073
X-2.4 Y-20.841 Z30.258 A-30.9398 F580.062
X-2 Y-23.256 Z30.18 A-34.3775 F580.062
X-1.6 Y-25.659 Z29.867 A-37.8153 F580.068
X-1.2 Y-28.042 Z29.501 A-41.253 F580.068
X-0.8 Y-30.397 Z28.903 A-44.6908 F579.225
X-0.4 Y-32.713 Z28.254 A-48.1285 F579.645
X0 Y-34.984 Z27.378 A-51.5662 F576.073
X0.4 Y-37.201 Z26.457 A-55.0039 F576.994
X0.8 Y-39.356 Z25.315 A-58.4417 F573.251
X1.2 Y-41.442 Z24.136 A-61.8794 F574.466
X1.6 Y-43.45 Z22.743 A-65.3172 F570.647
X2 Y-45.374 Z21.323 A-68.7549 F571.795
X2.4 Y-47.207 Z19.7 A-72.1927 F568.639
X2.8 Y-48.942 Z18.06 A-75.6304 F569.579
X3.2 Y-50.572 Z16.23 A-79.0682 F566.319
X3.6 Y-52.093 Z14.394 A-82.5059 F567.586
X4 Y-53.498 Z12.381 A-85.9437 F564.725
X4.4 Y-54.782 Z10.377 A-89.3814 F565.508
X4.8 Y-55.941 Z8.209 A-92.8192 F563.155
X5.2 Y-56.971 Z6.066 A-96.2569 F564.239
X5.6 Y-57.868 Z3.775 A-99.6947 F562.168
X6 Y-58.629 Z1.525 A-103.1324 F563.201
X6.4 Y-59.25 Z-0.857 A-106.5702 F561.103
X6.8 Y-59.731 Z-3.182 A-110.0079 F562.453
X7.067 Y-59.972 Z-4.817 A-112.2997 F853.762
X7.333 Y-60.148 Z-6.419 A-114.5916 F855.019
X7.6 Y-60.261 Z-7.988 A-116.8834 F855.188
X7.867 Y-60.31 Z-9.639 A-119.1752 F854.115
X8.133 Y-60.293 Z-11.251 A-121.4671 F854.933
X8.4 Y-60.212 Z-12.822 A-123.7589 F854.515
X8.667 Y-60.068 Z-14.468 A-126.0507 F854.481
X8.933 Y-59.858 Z-16.066 A-128.3426 F855.053
X9.2 Y-59.585 Z-17.615 A-130.6344 F854.829
G94
G0 Z12.385
M9
Z72.385
(OPERATION THREAD)
N5 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000005 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000005 endif
M9
G53 G0 Z0
M5
T3 M6
G53 G0 Z0
G43 H3
S500 M3
G0 A0
X-30 Y-20
Z25
M8
Z4
G33.1 Z-10 K1
G0 Z25
X30
Z4
G33.1 Z-10 K1
G0 Z25
M9
Z85
G53 G0 Z0
M5
M2
