; PROGRAM KEY
; CL FILE key_inch.cls
; MACHINE LolaXoyzba, CONTROL Siemens 840D, MODE axes
; UNITS in, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z0 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.0004 for arcs and curves
; CL data of NX, recognised from the file
; KINEMATICS *
; AXIS X+ moves the table against +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; AXIS B+ rotates the tool right-handed about +Y, as in ISO 841
; AXIS A+ rotates the tool right-handed about +X, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.0004 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; linear limits not checked: no travel declared (X Y Z)
; the entries of B and A in G54 must be zero
; T12 DIA 0.375 R0 L4.75 D1, 1 operation, tip Z -0.2227 to 2.8269
; T12 posted with L = 4.75: D1 must hold exactly this
; CONDITION no basic, external, fine or DRF offset that is not meant moves the zero
; CONDITION no offset by TOFFON or a synchronised action is on
; CONDITION no limit of G25, G26 or the setting data holds S back
; CONDITION T1 selects the tool of number 1, or of this name, and M6 changes it (MD22550 = 1), keeps the modes and has room where the rotary axes are
; CONDITION length 1 of the edges, with wear and adapter, is the length of the tools
; CONDITION length 1 of a tool lies along Z in G17 (SD42940)
; CONDITION the control is in Siemens mode (G290)
; CONDITION X is a radius (DIAMOF)
; CONDITION the tool is in the master spindle
; CONDITION no CYCLE832 of a program before is in force
; ASSUMED work offset G54
; ASSUMED retract to machine coordinate 0 in
; ASSUMED approach distance 1.968504 in along the tool axis
MSG("KEYWAY")
N1 TRAFOOF
CYCLE800()
TRANS
G700 G17 G40 G64 G90 G94 G54
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
T12
M6
SUPA G0 Z0 D0
D1
IF ABS($P_TOOLL[1]-4.75)>0.00039
MSG("T12 was posted with L = 4.75: the length in the tool data differs")
M0
M30
ENDIF
S3800 M4
G0 A-3.3 B0
X-1.137 Y0.0053
Z2.819
M7
G1 Y-0.1386 Z0.3231 F6.5
G93 X-1.0692 Y-0.0101 Z0.3137 A-4.475 F304.481
X-1.0015 Y0.1183 Z0.3023 A-5.65 F304.481
X-0.9337 Y0.2465 Z0.2889 A-6.825 F304.481
X-0.8659 Y0.3744 Z0.2735 A-8 F304.481
X-0.7981 Y0.502 Z0.2505 A-9.175 F302.754
X-0.7304 Y0.6293 Z0.2255 A-10.35 F302.754
X-0.6626 Y0.7563 Z0.1985 A-11.525 F302.754
X-0.5948 Y0.8829 Z0.1696 A-12.7 F302.754
X-0.527 Y1.009 Z0.1331 A-13.875 F299.388
X-0.4592 Y1.1346 Z0.0946 A-15.05 F299.388
X-0.3915 Y1.2598 Z0.0542 A-16.225 F299.388
X-0.3237 Y1.3843 Z0.0119 A-17.4 F299.388
X-0.2559 Y1.5083 Z-0.0379 A-18.575 F294.543
X-0.1881 Y1.6317 Z-0.0897 A-19.75 F294.543
X-0.1204 Y1.7543 Z-0.1433 A-20.925 F294.543
X-0.0526 Y1.8763 Z-0.1988 A-22.1 F294.543
X0.0152 Y1.9975 Z-0.2618 A-23.275 F288.434
X0.083 Y2.1179 Z-0.3266 A-24.45 F288.434
X0.1507 Y2.2375 Z-0.3933 A-25.625 F288.434
X0.2185 Y2.3562 Z-0.4617 A-26.8 F288.434
X0.2863 Y2.474 Z-0.5376 A-27.975 F281.307
X0.3541 Y2.5909 Z-0.6152 A-29.15 F281.307
X0.4218 Y2.7068 Z-0.6946 A-30.325 F281.307
X0.4896 Y2.8217 Z-0.7758 A-31.5 F281.307
X0.5574 Y2.9355 Z-0.8642 A-32.675 F273.414
X0.6252 Y3.0483 Z-0.9544 A-33.85 F273.414
X0.6929 Y3.16 Z-1.0462 A-35.025 F273.414
X0.7607 Y3.2705 Z-1.1396 A-36.2 F273.414
G94 X1.0734 F22.75
G0 Y4.8947 Z1.0795
M9
SUPA G0 Z0 D0
M5
M30
