(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.0004)
(CL data of NX, by its own evidence)
(AXIS X + moves the table against +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(AXIS B + turns the tool right-handed about +Y: word as in ISO 841)
(AXIS A + turns the tool right-handed about +X: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(T12 D0.375 R0 L4.75 H12, 1 operation, tip Z -0.2227 to 2.8269)
(T12 posted with L = 4.75: H12 must hold exactly this)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
(OPERATION KEYWAY)
N1 G20 G17 G40 G49 G80 G90 G94 G54 G64 P0.000394
M9
G53 G0 Z0
T12 M6
G53 G0 Z0
G43 H12
o1 if [[ABS[#5403 - 120.65] GT 0.01] AND [ABS[[#5403 * 25.4] - 120.65] GT 0.01]]
(abort, T12 was posted with L = 120.65 mm: the tool table says something else)
o1 endif
S3800 M4
G0 A-3.3 B0
X-1.137 Y0.0053
Z2.819
M7
G1 Y-0.1386 Z0.3231 F6.5
G93 X-0.8659 Y0.3744 Z0.2735 A-8 F76.1202
X-0.5948 Y0.8829 Z0.1696 A-12.7 F75.6886
X-0.3237 Y1.3843 Z0.0119 A-17.4 F74.847
X-0.0526 Y1.8763 Z-0.1988 A-22.1 F73.6357
X0.2185 Y2.3562 Z-0.4617 A-26.8 F72.1085
X0.4896 Y2.8217 Z-0.7758 A-31.5 F70.3267
X0.7607 Y3.2705 Z-1.1396 A-36.2 F68.3535
G94 X1.0734 F22.75
G0 Y4.8947 Z1.0795
M9
G53 G0 Z0
M5
M2
