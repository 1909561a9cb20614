; PROGRAM without name
; CL FILE works_4axis.cls
; MACHINE MultiProDesk, CONTROL Siemens 840D, MODE auto (plane, tcp)
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X10 Y-20 Z35 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; only operations 1 to 5 of 6; the program begins with a complete restart: modal codes, tool, offset, spindle
; CL data of NX, recognised from the file
; unit of the CL data is mm, as given; the CL file states none
; 5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines
; KINEMATICS *
; AXIS A+ rotates the table right-handed about +X, opposite to ISO 841
; AXIS Y+ moves the table along +Y, opposite to ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; LINEAR WORDS under tip control are tip coordinates in a frame fixed to the table, aligned with the machine axes when its rotary axes are at zero; rotary axes move evenly
; LINEAR WORDS in planes are tip coordinates in the tilted plane, from the same zero
; MODE plane: the direction reference of the swivel data must be the rotary axis nearest the tool
; linear limits not checked: no travel declared (Y X Z)
; the entries of A in G54 must be zero
; T1 DIA 10 R0 L110 D1, 3 operations, tip Z -35.818 to 45.394
; T2 DIA 5 L130 D1, 1 operation, tip Z -8.509 to 29.729
; T3 DIA 6 L95 D1, 1 operation, tip Z -10 to 25
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
MSG("SWARF")
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
T1
M6
T3
SUPA G0 Z0 D0
D1
S4000 M3
G0 A34.3775
CYCLE800(0,"",0,57,0,0,0,34.3775,0,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[A]-34.3775)/2))>0.0009
MSG("After the plane call the axes are not at A34.3775")
M0
M30
ENDIF
G0 X-10 Y0
CYCLE800()
G0 A34.3775
TRAORI
ORIMKS ORIAXES
G54
G0 X-10 Y-31.055 Z45.394
M8
G1 Y-14.116 Z20.633 A34.3775 F300
X-9.2 Y-11.545 Z22.175 A27.502 F900
X-8.4 Y-8.807 Z23.397 A20.6265
X-7.6 Y-5.943 Z24.283 A13.751
X-6.8 Y-2.993 Z24.82 A6.8755
X-6 Y0 Z25 A0
X-5.2 Y2.993 Z24.82 A-6.8755
X-4.4 Y5.943 Z24.283 A-13.751
X-3.6 Y8.807 Z23.397 A-20.6265
X-2.8 Y11.545 Z22.175 A-27.502
X-2 Y14.116 Z20.633 A-34.3775
X-1.2 Y16.485 Z18.795 A-41.253
X-0.4 Y18.616 Z16.687 A-48.1285
X0.4 Y20.48 Z14.338 A-55.0039
X1.2 Y22.049 Z11.783 A-61.8794
X2 Y23.301 Z9.059 A-68.7549
X2.8 Y24.218 Z6.204 A-75.6304
X3.6 Y24.787 Z3.261 A-82.5059
X4.4 Y24.999 Z0.27 A-89.3814
X5.2 Y24.851 Z-2.725 A-96.2569
X6 Y24.346 Z-5.68 A-103.1324
X6.8 Y23.491 Z-8.554 A-110.0079
X7.6 Y22.298 Z-11.304 A-116.8834
X8.4 Y20.785 Z-13.893 A-123.7589
X9.2 Y18.972 Z-16.281 A-130.6344
G0 Y41.738 Z-35.818
M9
Y87.271 Z-74.891
TRAFOOF
SUPA G0 Z0 D0
MSG("THREAD")
N5 TRAFOOF
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
T3
M6
T1
SUPA G0 Z0 D0
D1
S500 M3
G0 A0
X-30 Y-20
Z25
M8
MCALL CYCLE84(25,0,4,-10,,0,3,,1,0,500,500,,1)
G0 X-30 Y-20
X30
MCALL
M9
G0 Z85
SUPA G0 Z0 D0
M5
M30
