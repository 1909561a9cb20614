(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE Dmu70e, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.0004)
(CL data of NX, by its own evidence)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word as in ISO 841)
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
G0 B4.6675 C91.6507
X-0.1232 Y1.1339
Z2.8166
M7
G1 X-0.1231 Z0.3165 F6.5
G93 X0.4317 Y0.8983 Z0.3342 B11.3229 C94.0098 F76.1202
X1.0051 Y0.7111 Z0.3878 B17.9977 C96.3894 F75.6886
X1.5939 Y0.5744 Z0.4782 B24.7038 C98.8021 F74.847
X2.1944 Y0.4906 Z0.6066 B31.4542 C101.2614 F73.6357
X2.8028 Y0.4625 Z0.7743 B38.2634 C103.7823 F72.1085
X3.4144 Y0.4934 Z0.9832 B45.1478 C106.3813 F70.3267
X4.0239 Y0.5867 Z1.235 B52.1265 C109.0777 F68.3535
G94 X4.1261 Y0.2912 F22.75
G0 X4.1262 Z3.985
M9
G53 G0 Z0
M5
M2
