(PROGRAM BLADE)
(CL FILE blade.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.01)
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
(T3 D10 R5 L101.5 H3, 2 operations, tip Z -6.2 to 74.3)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
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
S8200 M3
G0 B0 C35
X-32.67 Y7.738
Z74.3
M8
G1 Z14.3 F400
G93 X-15.815 Y6.007 Z12.162 B4.3 F183.5
X2.638 Y4.631 Z11.545 B9.1 F178.461
X22.233 Y4.141 Z12.969 B14.2 C37.5 F172.883
X42.583 Y3.469 Z16.799 B19.6 C41.3 F166.959
X62.018 Y1.982 Z22.731 B24.7 C47.9 F160.855
X79.834 Y-1.276 Z30.14 B29.4 C56.2 F154.709
X91.701 Y-7.069 Z35.083 B31.8 C66.6 F148.626
X93.974 Y-15.515 Z32.679 B30.2 C78.1 F142.686
X91.477 Y-26.717 Z26.749 B27.7 C91.4 F136.943
G94
G0 Z96.749
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
S7600 M3
G0 B22.3 C231.3
X65.004 Y27.132
Z67.834
M8
G1 Z7.834 F400
G93 X72.065 Y24.054 Z11.547 B24.2 C227 F164.487
X79.369 Y21.566 Z15.777 B26.1 C222.7 F164.487
X86.819 Y19.717 Z20.522 B28 C218.4 F164.487
X94.311 Y18.552 Z25.769 B29.9 C214.1 F164.487
X101.746 Y18.105 Z31.492 B31.8 C209.8 F164.487
X109.023 Y18.401 Z37.649 B33.7 C205.5 F164.487
G94 X112.39 Y26.885 Z39.894 F640
G0 Y26.886 Z109.895
M9
G53 G0 Z0
M5
M2
