(PROGRAM RIM)
(CL FILE rim.ncl)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.01)
(CL data of Creo, by its own evidence)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about +Y: word as in ISO 841)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again)
(the entries of C and B in G54 must be zero)
(T7 D8 L84.3 H7, 1 operation, tip Z -4.2 to 54.606)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
T7 M6
G53 G0 Z0
G43 H7
S6500 M3
G0 B27 C-31
X100.032 Y0
Z85.906
M8
G1 Z27.906 F500
G93 C-3.7 F56.5833
C23.6 F56.5833
C50.9 F56.5833
C78.2 F56.5833
C105.5 F56.5833
C132.8 F56.5833
C160.1 F56.5833
C187.4 F56.5833
C214.7 F56.5833
C242 F56.5833
C269.3 F56.5833
C296.6 F56.5833
C323.9 F56.5833
C351.2 F56.5833
C378.5 F56.5833
G94
G0 Z93.906
M9
G53 G0 Z0
M5
M2
