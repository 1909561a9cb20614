(PROGRAM BLADE)
(CL FILE blade.cls)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.01)
(CL data of NX, by its own evidence)
(AXIS X + moves the table against +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(AXIS B + turns the tool right-handed about +Y: word as in ISO 841)
(AXIS A + turns the tool right-handed about +X: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(T3 D10 R5 L101.5 H3, 2 operations, tip Z -6.2 to 74.3)
(T3 posted with L = 101.5: H3 must hold exactly this)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
(OPERATION LEADING_EDGE)
N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
T3 M6
G53 G0 Z0
G43 H3
o1 if [[ABS[#5403 - 101.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 101.5] GT 0.01]]
(abort, T3 was posted with L = 101.5 mm: the tool table says something else)
o1 endif
S8200 M3
G0 A0 B0
X-31.2 Y-12.4
Z74.3
M8
G1 Z14.3 F400
G93 X-18.596 Y-5.688 Z13.45 A-2.4648 B3.5245 F183.5
X-5.31 Y1.936 Z11.592 A-5.2048 B7.4749 F178.461
X7.663 Y11.1 Z8.601 A-8.5883 B11.3512 F172.883
X19.859 Y22.064 Z4.351 A-12.7912 B14.9767 F166.959
X29.085 Y35.145 Z-0.826 A-18.0621 B17.1378 F160.855
X34.738 Y49.597 Z-6.686 A-24.0751 B17.4039 F154.709
X34.632 Y62.23 Z-11.226 A-28.9218 B13.8334 F148.626
X30.288 Y68.487 Z-12.444 A-29.4859 B6.8435 F142.686
X24.977 Y71.514 Z-13.281 A-27.691 B-0.7349 F136.943
G94
G0 X24.182 Y104.043 Z48.697
M9
G53 G0 Z0
M5
M1
(OPERATION TRAILING_EDGE)
N2 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
(T3 stays in the spindle)
G43 H3
o2 if [[ABS[#5403 - 101.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 101.5] GT 0.01]]
(abort, T3 was posted with L = 101.5 mm: the tool table says something else)
o2 endif
S7600 M3
G0 A17.2259 B-14.3825
X-21.016 Y-69.626
Z41.722
M8
G1 X-6.781 Y-51.858 Z-13.791 F400
G93 X-16.906 Y-53.4 Z-14.747 A17.4455 B-17.0404 F164.487
X-27.177 Y-54.422 Z-15.804 A17.3585 B-19.8004 F164.487
X-37.534 Y-54.908 Z-16.962 A16.9544 B-22.6214 F164.487
X-47.917 Y-54.846 Z-18.218 A16.2287 B-25.4617 F164.487
X-58.263 Y-54.231 Z-19.571 A15.1818 B-28.2819 F164.487
X-68.511 Y-53.065 Z-21.019 A13.8197 B-31.0458 F164.487
G94 Y-62.465 F640
G0 X-103.567 Y-79.186 Z37.218
M9
G53 G0 Z0
M5
M2
