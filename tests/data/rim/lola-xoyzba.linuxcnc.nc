(PROGRAM RIM)
(CL FILE rim.ncl)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.01)
(CL data of Creo, by its own evidence)
(AXIS X + moves the table against +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(AXIS B + turns the tool right-handed about +Y: word as in ISO 841)
(AXIS A + turns the tool right-handed about +X: word as in ISO 841)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(T7 D8 L84.3 H7, 1 operation, tip Z -4.2 to 54.606)
(T7 posted with L = 84.3: H7 must hold exactly this)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
T7 M6
G53 G0 Z0
G43 H7
o1 if [[ABS[#5403 - 84.3] GT 0.01] AND [ABS[[#5403 * 25.4] - 84.3] GT 0.01]]
(abort, T7 was posted with L = 84.3 mm: the tool table says something else)
o1 endif
S6500 M3
G0 A13.5222 B23.5932
X84.262 Y-50.63
Z38.29
M8
G1 X61.691 Y-37.068 Z-13.388 F500
G93 X71.821 Y-4.644 A1.6788 B26.9517 F56.5833
X65.952 Y28.814 A-10.472 B25.0283 F56.5833
X45.391 Y55.853 A-20.6291 B17.8146 F56.5833
X14.718 Y70.45 A-26.3847 B5.9485 F56.5833
X-19.234 Y69.354 A-25.9431 B-7.754 F56.5833
X-48.9 Y52.808 A-19.4574 B-19.0955 F56.5833
X-67.674 Y24.498 A-8.8895 B-25.5991 F56.5833
X-71.372 Y-9.27 A3.3521 B-26.8066 F56.5833
X-59.171 Y-40.972 A14.978 B-22.729 F56.5833
X-33.789 Y-63.547 A23.6313 B-13.4528 F56.5833
X-0.879 Y-71.966 A26.9978 B-0.3567 F56.5833
X32.226 Y-64.354 A23.9499 B12.8518 F56.5833
X58.152 Y-42.405 A15.5149 B22.3765 F56.5833
X71.124 Y-11.011 A3.9826 B26.7265 F56.5833
X68.252 Y22.837 A-8.2825 B25.7896 F56.5833
G94
G0 X96.667 Y32.344 Z45.418
M9
G53 G0 Z0
M5
M2
