; PROGRAM without name
; CL FILE works.cls
; MACHINE LolaXoyzba, CONTROL Siemens 840D, MODE auto (plane, tcp)
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X10 Y-20 Z35 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; only operations 1 to 5 of 6; the program begins with a complete restart: modal codes, tool, offset, spindle
; CL data of NX, recognised from the file
; unit of the CL data is mm, as given; the CL file states none
; 5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines
; KINEMATICS *
; AXIS X+ moves the table against +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; AXIS B+ rotates the tool right-handed about +Y, as in ISO 841
; AXIS A+ rotates the tool right-handed about +X, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; LINEAR WORDS under tip control are tip coordinates in a frame fixed to the table, aligned with the machine axes when its rotary axes are at zero; rotary axes move evenly
; LINEAR WORDS in planes are tip coordinates in the tilted plane, from the same zero
; MODE plane: the direction reference of the swivel data must be the rotary axis nearest the tool
; linear limits not checked: no travel declared (X Y Z)
; the entries of B and A in G54 must be zero
; T1 DIA 10 R0 L110 D1, 3 operations, tip Z -7.398 to 36.793
; T2 DIA 5 L130 D1, 1 operation, tip Z -15.078 to 28.689
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
G0 A0 B0
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
G0 A-15.7987 B19.6289
CYCLE800(0,"",0,57,0,0,0,-16.7205,18.8588,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[A]+15.7987)/2))+ABS(SIN(($AA_IW[B]-19.6289)/2))>0.0009
MSG("After the plane call the axes are not at A-15.7987 B19.6289")
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
G0 A-15.7987 B19.6289
CYCLE800(0,"",0,57,0,0,0,-16.7205,18.8588,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[A]+15.7987)/2))+ABS(SIN(($AA_IW[B]-19.6289)/2))>0.0009
MSG("After the plane call the axes are not at A-15.7987 B19.6289")
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
G0 A9.752 B23.9854
TRAORI
ORIMKS ORIAXES
G54
G0 X39.651 Y-16.764
Z22.013
M8
G1 X27.632 Y-11.683 Z-5 A9.752 B23.9854 F300
X29.853 Y-2.963 A2.4623 B25.6733 F900
X29.389 Y6.023 A-5.0098 B25.3244
X26.281 Y14.467 A-12.1081 B22.9369
X20.809 Y21.61 A-18.2593 B18.5241
X13.465 Y26.809 A-22.8732 B12.2328
X4.909 Y29.596 A-25.4106 B4.5197
X-4.088 Y29.72 A-25.5252 B-3.7659
X-12.717 Y27.171 A-23.2005 B-11.5726
X-20.203 Y22.178 A-18.7568 B-18.0197
X-25.871 Y15.189 A-12.7224 B-22.6148
X-29.211 Y6.834 A-5.6868 B-25.1901
X-29.924 Y-2.135 A1.7742 B-25.7262
X-27.945 Y-10.913 A9.1039 B-24.2259
X-23.452 Y-18.709 A15.7391 B-20.6872
X-16.849 Y-24.822 A21.0932 B-15.1788
X-8.73 Y-28.702 A24.5912 B-8.0018
X0.174 Y-30 A25.7826 B0.1602
X9.062 Y-28.599 A24.4971 B8.3017
X17.135 Y-24.625 A20.9182 B15.4245
X23.667 Y-18.436 A15.5038 B20.8607
X28.069 Y-10.589 A8.8312 B24.3213
X29.947 Y-1.789 A1.4861 B25.7432
X29.13 Y7.172 A-5.9688 B25.1288
X25.693 Y15.488 A-12.9767 B22.4751
G0 X36.869 Y22.224 Z22.013
M9
X59.22 Y35.698 Z76.04
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
G0 A0 B0
X-30 Y20
Z25
M8
MCALL CYCLE84(25,0,4,-10,,0,3,,1,0,500,500,,1)
G0 X-30 Y20
X30
MCALL
M9
G0 Z85
SUPA G0 Z0 D0
M5
M30
