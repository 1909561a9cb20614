(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.0004)
(CL data of NX, by its own evidence)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about +Y: word as in ISO 841)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again)
(the entries of C and B in G54 must be zero)
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
G0 B3.3 C90
X-0.0904 Y1.137
Z2.8166
M7
G1 Z0.3165 F6.5
G93 X0.4935 Y0.8659 Z0.3342 B8 F76.1202
X1.078 Y0.5948 Z0.3878 B12.7 F75.6886
X1.663 Y0.3237 Z0.4782 B17.4 F74.847
X2.2479 Y0.0526 Z0.6066 B22.1 F73.6357
X2.8323 Y-0.2185 Z0.7743 B26.8 F72.1085
X3.415 Y-0.4896 Z0.9832 B31.5 F70.3267
X3.9947 Y-0.7607 Z1.235 B36.2 F68.3535
G94 Y-1.0734 F22.75
G0 Z3.985
M9
G53 G0 Z0
M5
M2
