; PROGRAM without name
; CL FILE pocket.cls
; MACHINE SpinnerU5620, CONTROL Siemens 840D, MODE axes
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z0 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.05 for arcs and curves
; CL data of NX, recognised from the file
; unit of the CL data is mm, as given; the CL file states none
; 3 arcs, sense by form, confirmed by 3 of 3 neighbouring lines
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.05 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; linear limits not checked: no travel declared (X Y Z)
; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
; the entries of C and B in G54 must be zero
; T1 DIA 10 R0 L110 D1, 1 operation, tip Z -2 to 20
; T2 DIA 5 L130 D1, 2 operations, tip Z -15 to 60
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
MSG("POCKET")
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
X8 Y0
Z10
M8
Z1
G3 X8 Y0 Z-1.4 I-8 J0 F200
X0 Y8 Z-2 I-8 J0
G1 X-20 F600
G3 X-20 Y-8 I0 J-8
G1 X0
G2 X5 Y-13 I0 J-5
G1 Y-20
X5.081 Y-21.378
X5.315 Y-22.528
X5.688 Y-23.469
X6.185 Y-24.222
X6.794 Y-24.809
X7.5 Y-25.25
X8.727 Y-25.684
X10.188 Y-25.906
X11.93 Y-25.988
X14 Y-26
Z20
M9
G0 Z70
MSG("HOLES")
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
T2
M6
T1
SUPA G0 Z0 D0
D1
S2500 M3
G0 B0 C0
X-30 Y15
Z20
M8
F150
MCALL CYCLE83(20,0,2,-15,,,6,0,0,0,1,1,,,,0,0.5)
G0 X-30 Y15
X-10
MCALL
F150
MCALL CYCLE82(-3,-5,2,-9,,0.5)
G0 X-10 Y25
MCALL
G0 Z7
F150
MCALL CYCLE82(7,5,2,1,,0.5)
G0 X10 Y25
MCALL
G4 F1.5
M9
G0 Z57
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
; T2 stays in the spindle
D1
S2500 M3
G0 B0 C0
X0 Y0
Z110
M8
Z60
M9
Z110
SUPA G0 Z0 D0
M5
M30
