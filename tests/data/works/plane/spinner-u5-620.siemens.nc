; PROGRAM without name
; CL FILE works.cls
; MACHINE SpinnerU5620, CONTROL Siemens 840D, MODE plane
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X10 Y-20 Z35 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; only operations 1 to 3 of 6; the program begins with a complete restart: modal codes, tool, offset, spindle
; CL data of NX, recognised from the file
; unit of the CL data is mm, as given; the CL file states none
; 5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines
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
; T1 DIA 10 R0 L110 D1, 2 operations, tip Z -7.398 to 36.793
; T2 DIA 5 L130 D1, 1 operation, tip Z -15.078 to 28.689
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
G0 B0 C0
X12 Y0
Z20
M8
Z2
G3 X12 Y0 Z-0.4 I-12 J0 F200
X0 Y12 Z-1 I-12 J0
G1 X-20 F600
G3 X-20 Y-12 I0 J-12
G1 X0
G2 X8 Y-20 I0 J-8
X8 Y-20 I-8 J0
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
G0 B25 C40.107
CYCLE800(0,"",0,57,0,0,0,-16.7205,18.8588,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[B]-25)/2))+ABS(SIN(($AA_IW[C]-40.107)/2))>0.0009
MSG("After the plane call the axes are not at B25 C40.107")
M0
M30
ENDIF
G0 X-11.355 Y-6.232
Z34.739
M8
G1 Z2.739 F300
X13.528 Y-3.816 F700
G3 X11.595 Y16.091 I-0.967 J9.953
G1 X-13.288 Y13.674
X-11.355 Y-6.232
Z34.739
M9
G0 Z94.739
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
G0 B25 C40.107
CYCLE800(0,"",0,57,0,0,0,-16.7205,18.8588,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[B]-25)/2))+ABS(SIN(($AA_IW[C]-40.107)/2))>0.0009
MSG("After the plane call the axes are not at B25 C40.107")
M0
M30
ENDIF
G0 X-9.336 Y4.011
Z29.739
M8
F150
MCALL CYCLE81(29.739,4.739,2,-1.261)
G0 X-9.336 Y4.011
X2.608 Y5.171
MCALL
F150
MCALL CYCLE82(29.739,4.739,2,-1.261,,0.5)
G0 X14.552 Y6.331
MCALL
F150
MCALL CYCLE83(29.739,4.739,2,-10.261,,,4,0,0,0,1,1,,,,0,0.5)
G0 X-10.495 Y15.955
MCALL
F150
MCALL CYCLE83(29.739,8.739,2,-6.261,,,4,0,0,0,1,1,,,,0,0.5)
G0 X1.448 Y17.115
MCALL
F150
MCALL CYCLE83(29.739,4.739,2,-6.261,,,4,0,0,0,1,0,,,0.5,0)
G0 X13.392 Y18.275
MCALL
MCALL CYCLE85(29.739,4.739,2,-1.261,,0,80,80)
G0 X3.768 Y-6.773
MCALL
M9
G0 Z89.739
SUPA G0 Z0 D0
CYCLE800()
M5
M0
M9
SUPA G0 Z0 D0
M5
M30
