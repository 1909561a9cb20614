; PROGRAM without name
; CL FILE works_4axis.cls
; MACHINE MultiProDesk, CONTROL Siemens 840D, MODE plane
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X10 Y-20 Z35 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; only operations 1 to 3 of 6; the program begins with a complete restart: modal codes, tool, offset, spindle
; CL data of NX, recognised from the file
; unit of the CL data is mm, as given; the CL file states none
; 5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines
; KINEMATICS *
; AXIS A+ rotates the table right-handed about +X, opposite to ISO 841
; AXIS Y+ moves the table along +Y, opposite to ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; LINEAR WORDS are tip coordinates in the tilted plane, from the same zero
; MODE plane: the direction reference of the swivel data must be the rotary axis nearest the tool
; linear limits not checked: no travel declared (Y X Z)
; the entries of A in G54 must be zero
; T1 DIA 10 R0 L110 D1, 2 operations, tip Z -4.039 to 24.963
; T2 DIA 5 L130 D1, 1 operation, tip Z -8.509 to 29.729
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
; ASSUMED work offset G54
; ASSUMED retract to machine coordinate 0 mm
; ASSUMED approach distance 50 mm along the tool axis
MSG("ARCS")
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
S4000 M3
G0 A0
X12 Y0
Z20
M8
Z2
G2 X12 Y0 Z-0.4 I-12 J0 F200
X0 Y-12 Z-1 I-12 J0
G1 X-20 F600
G2 X-20 Y12 I0 J12
G1 X0
G3 X8 Y20 I0 J8
X8 Y20 I-8 J0
G1 Z20
M9
G0 Z80
SUPA G0 Z0 D0
M5
M1
MSG("TILTED")
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
; T1 stays in the spindle
D1
S4000 M3
G0 A-25
CYCLE800(0,"",0,57,0,0,0,-25,0,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[A]+25)/2))>0.0009
MSG("After the plane call the axes are not at A-25")
M0
M30
ENDIF
G0 X-11 Y3.717
Z29.277
M8
G1 Z-2.723 F300
X14 F700
G2 X14 Y-16.283 I0 J-10
G1 X-11
Y3.717
Z29.277
M9
G0 Z89.277
SUPA G0 Z0 D0
CYCLE800()
MSG("HOLES")
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
T2
M6
T1
SUPA G0 Z0 D0
D1
S2500 M3
G0 A-25
CYCLE800(0,"",0,57,0,0,0,-25,0,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[A]+25)/2))>0.0009
MSG("After the plane call the axes are not at A-25")
M0
M30
ENDIF
G0 X-8 Y-6.283
Z24.277
M8
F150
MCALL CYCLE81(24.277,-0.723,2,-6.723)
G0 X-8 Y-6.283
X4
MCALL
F150
MCALL CYCLE82(24.277,-0.723,2,-6.723,,0.5)
G0 X16 Y-6.283
MCALL
F150
MCALL CYCLE83(24.277,-0.723,2,-15.723,,,4,0,0,0,1,1,,,,0,0.5)
G0 X-8 Y-18.283
MCALL
F150
MCALL CYCLE83(24.277,3.277,2,-11.723,,,4,0,0,0,1,1,,,,0,0.5)
G0 X4 Y-18.283
MCALL
F150
MCALL CYCLE83(24.277,-0.723,2,-11.723,,,4,0,0,0,1,0,,,0.5,0)
G0 X16 Y-18.283
MCALL
MCALL CYCLE85(24.277,-0.723,2,-6.723,,0,80,80)
G0 X4 Y5.717
MCALL
M9
G0 Z84.277
SUPA G0 Z0 D0
CYCLE800()
M5
M0
M9
SUPA G0 Z0 D0
M5
M30
