; PROGRAM FACETS
; CL FILE facets.aptsource
; MACHINE Dmu70e, CONTROL Siemens 840D, MODE axes
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z0 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; CL data of CATIA, recognised from the file
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; linear limits not checked: no travel declared (X Y Z)
; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
; the entries of C and B in G54 must be zero
; T5 DIA 16 R0 L132.5 D1, 3 operations, tip Z -13.517 to 58.514
; T6 DIA 6 R0 L97.25 D1, 1 operation, tip Z -4.281 to 61.011
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
; ASSUMED retract to machine coordinate 0 mm
; ASSUMED approach distance 50 mm along the tool axis
N1 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G54
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
T5
M6
T6
SUPA G0 Z0 D0
D1
S4500 M3
G0 B40.0133 C34.4378
X83.382 Y12.486
Z88.929
M8
G1 Z26.929 F600
X104.688 Y17.972 F850
X100.2 Y35.403
G0 Z90.929
M9
SUPA G0 Z0 D0
D1
G0 B47.3638 C154.2303
X94.366 Y22.375
Z98.236
M8
G1 Z36.236 F600
X115.379 Y28.892 F850
X110.047 Y46.084
G0 Z100.236
M9
SUPA G0 Z0 D0
M5
M0
N2 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G54
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
; T5 stays in the spindle
D1
S4500 M3
G0 B34.1989 C301.2722
X76.454 Y7.304
Z83.809
M8
G1 Z21.809 F600
X97.951 Y11.98 F850
X94.125 Y29.569
G0 Z85.809
M9
N3 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G54
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
M5
T6
M6
T5
SUPA G0 Z0 D0
D1
S9000 M3
G0 B17.7131 C206.2876
X43.351 Y-3.185
Z68.326
M8
G1 Z6.326 F600
X65.218 Y-0.776 F850
X63.247 Y17.116
G0 Z70.326
M9
N4 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G54
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
M5
T5
M6
SUPA G0 Z0 D0
D1
S4200 M3
G0 B59.3748 C192.9554
X107.214 Y34.141
Z111.999
M8
G1 Z49.999 F600
X127.618 Y42.367 F850
X120.888 Y59.061
G0 Z113.999
M9
SUPA G0 Z0 D0
M5
M30
