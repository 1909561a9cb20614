A(PROGRAM without name)
(CL FILE stdin)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(ARCS AND CURVES left by at most 0.01)
(CL data of NX, by its own evidence)
(1 arc, sense by form only, 0 arcs confirmed)
(INSERT written as it stands: nobody has checked it)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about +Y: word as in ISO 841)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again)
(the entries of C and B in G54 must be zero)
(T1 D10 R1 L unknown H1, 1 operation, tip Z -5 to 20)
(ASSUMED the unit of the CL data, which does not state one, is mm as given with the job)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
(ASSUMED spindle of T1 from the configuration where the CL data gives none: S3000 CLW)
(ASSUMED the gauge length of T1 is unknown: its offset must hold the true one)
(OPERATION POCKET)
N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S3000 M3
G0 B0 C0
X10 Y0
Z5
G1 Z0 F250
G3 X10 Y0 Z-1.6 I-10 J0
X0 Y10 Z-2 I-10 J0
G1 X0.353 Y10.022
X0.664 Y10.082
X0.94 Y10.171
X1.188 Y10.281
X1.411 Y10.403
X1.617 Y10.527
X1.812 Y10.646
X2 Y10.75
X2.151 Y10.819
X2.304 Y10.88
X2.463 Y10.941
X2.632 Y11.01
X2.813 Y11.094
X3.008 Y11.2
X3.222 Y11.336
X3.456 Y11.51
X3.715 Y11.729
X4 Y12
Z20
G98 G83 X4 Y12 Z-5 R3 Q2 F250
G80
G0 Z70
G53 G0 Z0
M5
M2
