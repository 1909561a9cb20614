(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE MultiProDesk, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.0004 for arcs and curves)
(CL data of NX, recognised from the file)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.0004 of its line at feed, the tool axis within 0.1 deg)
(ROTARY WORDS are absolute and go beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [Y X Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of A in G54 must be zero)
(T12 D0.375 R0 L4.75 H12, 1 operation, tip Z -0.2227 to 2.8269)
(ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
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
G93 X-1.0375 Y0.3932 Z0.2935 A5.0248 F207.424
X-0.938 Y0.3557 Z0.2829 A6.7496 F207.424
X-0.8659 Y0.3284 Z0.2767 A8 F286.119
X-0.7653 Y0.2887 Z0.262 A9.7446 F203.903
X-0.6652 Y0.2487 Z0.2501 A11.4799 F205.008
X-0.5948 Y0.2203 Z0.2433 A12.7 F291.555
X-0.4998 Y0.1798 Z0.2286 A14.3464 F213.667
X-0.4049 Y0.1386 Z0.2164 A15.9928 F213.667
X-0.3237 Y0.103 Z0.208 A17.4 F249.986
X-0.2303 Y0.0592 Z0.1933 A19.0192 F213.745
X-0.1369 Y0.0146 Z0.1813 A20.6383 F213.745
X-0.0526 Y-0.0261 Z0.1727 A22.1 F236.775
X0.0354 Y-0.072 Z0.1594 A23.6252 F222.214
X0.1233 Y-0.1186 Z0.1487 A25.1503 F222.214
X0.2113 Y-0.1657 Z0.1406 A26.6755 F222.214
X0.2185 Y-0.1696 Z0.14 A26.8 F2721.33
X0.305 Y-0.2199 Z0.1284 A28.3 F220.364
X0.3868 Y-0.2681 Z0.12 A29.7184 F233.021
X0.4713 Y-0.3184 Z0.1139 A31.183 F225.683
X0.4896 Y-0.3293 Z0.1129 A31.5 F1042.84
X0.5684 Y-0.3803 Z0.1046 A32.8669 F235.026
X0.6473 Y-0.4319 Z0.0989 A34.2338 F235.026
X0.7281 Y-0.4852 Z0.0956 A35.6344 F229.382
X0.7607 Y-0.5068 Z0.095 A36.2 F567.987
G94 X1.0734 F22.75
G0 Y-0.5069 Z2.845
M9
G53 G0 Z0
M5
M2
