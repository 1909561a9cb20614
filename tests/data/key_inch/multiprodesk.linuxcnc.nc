(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE MultiProDesk, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.0004)
(CL data of NX, by its own evidence)
(AXIS A + turns the table right-handed about +X: word backwards)
(AXIS Y + moves the table along +Y: word backwards)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [Y X Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again)
(the entries of A in G54 must be zero)
(T12 D0.375 R0 L4.75 H12, 1 operation, tip Z -0.2227 to 2.8269)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
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
S3800 M4
G0 A3.3
X-1.137 Y0.4304
Z2.8068
M7
G1 Z0.3067 F6.5
G93 X-0.8659 Y0.3284 Z0.2767 A8 F76.1202
X-0.5948 Y0.2203 Z0.2433 A12.7 F75.6886
X-0.3237 Y0.103 Z0.208 A17.4 F74.847
X-0.0526 Y-0.0261 Z0.1727 A22.1 F73.6357
X0.2185 Y-0.1696 Z0.14 A26.8 F72.1085
X0.4896 Y-0.3293 Z0.1129 A31.5 F70.3267
X0.7607 Y-0.5068 Z0.095 A36.2 F68.3535
G94 X1.0734 F22.75
G0 Y-0.5069 Z2.845
M9
G53 G0 Z0
M5
M2
