WORKPIECE(,"",,"CYLINDER",192,0,-40,-40,100)
; PROGRAM SHOP
; CL FILE shop.cls
; MACHINE SpinnerU5620, CONTROL Siemens 840D, MODE auto (plane)
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z50 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; Siemens 840D has no program numbers: `control.program_number` is left out
; operation 1 FACE_ROUGH: smoothing rough, path tolerance 0.05 mm
; CL data of NX, recognised from the file
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; LINEAR WORDS are tip coordinates in the tilted plane, from the same zero
; MODE plane: the direction reference of the swivel data must be the rotary axis nearest the tool
; linear limits not checked: no travel declared (X Y Z)
; the entries of C and B in G54 must be zero
; T1 mill 12 DIA 12 L120 D1, 1 operation, tip Z -2 to 60
; T2 drill 8 L140 D1, 1 operation, tip Z -26 to 60
; T3 ball 6 DIA 6 R3 L110 D1, 1 operation, tip Z 19.799 to 50.912
; CONDITION no basic, external, fine or DRF offset that is not meant moves the zero
; CONDITION no offset by TOFFON or a synchronised action is on
; CONDITION no limit of G25, G26 or the setting data holds S back
; CONDITION T1 selects the tool of number 1, or of this name, and M6 changes it (MD22550 = 1), keeps the modes and has room where the rotary axes are
; CONDITION length 1 of the edges, with wear and adapter, is the length of the tools
; CONDITION swivel data and data of TRAORI are those of this machine (`kinematics --siemens`)
; CONDITION length 1 of a tool lies along Z in G17 (SD42940)
; CONDITION the control is in Siemens mode (G290)
; CONDITION X is a radius (DIAMOF)
; CONDITION the tool is in the master spindle
; CONDITION no CYCLE832 of a program before is in force
; ASSUMED retract to machine coordinate 0 mm
; ASSUMED approach distance 50 mm along the tool axis
MSG("FACE_ROUGH")
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
; T1 mill 12
T1
M6
T2
SUPA G0 Z0 D0
D1
S4000 M3
G0 B0 C0
X-40 Y-10
Z60
M8
Z2
CYCLE832(0.05,3,1)
G1 Z-2 F400
X40 F1200
Y10
X-40
G0 Z60
M9
MSG("DRILL")
CYCLE832()
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
M5
; T2 drill 8
T2
M6
T3
SUPA G0 Z0 D0
D1
S2500 M3
G0 B0 C0
X20 Y0
Z60
M8
F250
MCALL CYCLE81(8,-2,3,-26)
G0 X20 Y0
X-20
MCALL
G0 Z60
M9
MSG("FINISH_45")
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
; T3 ball 6
T3
M6
T1
SUPA G0 Z0 D0
D1
S9000 M3
G0 B45 C0
CYCLE800(0,"TABLE",0,57,0,0,0,0,45,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[B]-45)/2))+ABS(SIN(($AA_IW[C]-0)/2))>0.0009
MSG("After the plane call the axes are not at B45 C0")
M0
M30
ENDIF
G0 X0 Y-20
Z72
M8
Z32
CYCLE832(0.01,1,1)
G1 Z29 F500
Y20 F1800
X1
Y-20
G0 Z71
M9
Z131
CYCLE832()
SUPA G0 Z0 D0
CYCLE800()
M5
M30
