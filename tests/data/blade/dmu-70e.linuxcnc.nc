(PROGRAM BLADE)
(CL FILE blade.cls)
(MACHINE Dmu70e, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(TOLERANCE not linearised: tip path between blocks is not checked)
(ARCS AND CURVES in chords that leave them by at most 0.01)
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
G93 X-16.03 Y5.409 Z12.162 B6.0825 C37.1515 F183.5
X2.261 Y4.827 Z11.545 B12.8829 C39.5644 F178.461
X21.544 Y6.878 Z12.969 B20.1339 C44.6552 F172.883
X41.344 Y10.772 Z16.799 B27.8572 C51.2466 F166.959
X60.079 Y15.512 Z22.731 B35.2128 C60.5473 F160.855
X77.372 Y19.712 Z30.14 B42.0614 C71.4093 F154.709
X89.916 Y19.346 Z35.083 B45.5902 C83.1503 F148.626
X94.675 Y10.417 Z32.679 B43.2351 C93.7536 F142.686
X95.241 Y-3.339 Z26.749 B39.5754 C105.6734 F136.943
G94
G0 X95.24 Z96.75
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
G0 B31.7427 C242.6673
X58.381 Y39.412
Z67.834
M8
G1 X58.382 Z7.834 F400
G93 X65.233 Y38.944 Z11.547 B34.4885 C239.3792 F164.487
X72.209 Y39.375 Z15.777 B37.245 C236.1023 F164.487
X79.161 Y40.741 Z20.522 B40.0133 C232.8377 F164.487
X85.933 Y43.061 Z25.769 B42.7946 C229.5867 F164.487
X92.373 Y46.338 Z31.492 B45.5902 C226.3503 F164.487
X98.33 Y50.557 Z37.649 B48.4014 C223.1301 F164.487
G94 X98.969 Y59.662 Z39.894 F640
G0 Z109.895
M9
G53 G0 Z0
M5
M2
