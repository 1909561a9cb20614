; PROGRAM TWO_TOOLS
; CL FILE two_tools.cls
; MACHINE SpinnerU5620, CONTROL Siemens 840D, MODE axes
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z0 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; CL data of NX, recognised from the file
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; linear limits not checked: no travel declared (X Y Z)
; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
; the entries of C and B in G54 must be zero
; T1 DIA 20 R0 L120 D1, 1 operation, tip Z -26 to 49.301
; T2 DIA 8 R0 L95 D1, 1 operation, tip Z -3.759 to 52.623
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
MSG("TILTED_FACE")
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
T1
M6
T2
SUPA G0 Z0 D0
D1
S3000 M3
G0 B30 C0
X71.66 Y-28
Z75.096
M8
G1 Z25.096 F1000
X135.66 F900
Y-14
X71.66
Y0
X135.66
Y14
X71.66
Y28
X135.66
G0 Z85.096
M9
SUPA G0 Z0 D0
M5
M0
MSG("TILTED_SLOT")
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
T2
M6
T1
SUPA G0 Z0 D0
D1
S7000 M3
G0 B20 C-90
X70.097 Y-30
Z65.886
M8
G1 Z15.887 F500
Y-10 Z14.887 F350
Y-30 Z13.887
Y-10 Z12.886
Y-30 Z11.886
Y-10
Y-30
G0 Z71.887
M9
SUPA G0 Z0 D0
M5
M30
