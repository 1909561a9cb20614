; PROGRAM without name
; CL FILE passes.cls
; MACHINE Dmu70e, CONTROL Siemens 840D, MODE auto (tcp)
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z50 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; CL data of NX, recognised from the file
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; LINEAR WORDS are tip coordinates in a frame fixed to the table, aligned with the machine axes when its rotary axes are at zero; rotary axes move evenly
; linear limits not checked: no travel declared (X Y Z)
; the entries of C and B in G54 must be zero
; T4 ball 8 DIA 8 L130 D1, 1 operation, tip Z 3 to 23.126
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
; ASSUMED all axes of a rapid arrive together, as the control is delivered
MSG("PASSES")
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
; T4 ball 8
T4
M6
SUPA G0 Z0 D0
D1
S8000 M3
G0 B35.6477 C12.8086
CYCLE800(0,"",0,57,0,0,0,0,25,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[B]-35.6477)/2))+ABS(SIN(($AA_IW[C]-12.8086)/2))>0.0009
MSG("After the plane call the axes are not at B35.6477 C12.8086")
M0
M30
ENDIF
G0 X25.076 Y0
CYCLE800()
G0 B35.6477 C12.8086
TRAORI
ORIMKS ORIAXES
G54
G0 X38.452 Y0 Z23.126
M8
G1 X30 Z5 B35.6477 C12.8086 F600
X29.672 Y3.119 B36.9199 C19.4968 F1200
X29.344 Y6.237 B38.5547 C25.8912
X28.375 Y9.22 B39.8233 C32.5641
X27.406 Y12.202 B41.4755 C38.9881
X25.838 Y14.918 B42.7419 C45.6487
X24.271 Y17.634 B44.4114 C52.1006
G0 X32.604 Y23.688 Z22.143
X34.223 Y17.766 Z22.063 B41.6766 C43.0701
X35.842 Y11.844 Z21.982 B39.7245 C33.502
X37.461 Y5.922 Z21.901 B38.6615 C23.6481
X39.08 Y0 Z21.82 B38.5547 C13.8912
G1 X30 Z4 F600
X29.672 Y3.119 B39.8233 C20.5641 F1200
X29.344 Y6.237 B41.4754 C26.9881
X28.375 Y9.22 B42.7419 C33.6488
X27.406 Y12.202 B44.4113 C40.1006
X25.838 Y14.918 B45.677 C46.7518
X24.271 Y17.634 B47.3638 C53.2303
G0 X33.083 Y24.036 Z20.773
X34.736 Y18.027 Z20.703 B44.5554 C44.0928
X36.39 Y12.018 Z20.633 B42.575 C34.4853
X38.043 Y6.009 Z20.563 B41.5271 C24.6605
X39.696 Y0 Z20.492 B41.4755 C14.9881
G1 X30 Z3 F600
X29.672 Y3.119 B42.7419 C21.6487 F1200
X29.344 Y6.237 B44.4113 C28.1005
X28.375 Y9.22 B45.677 C34.7517
X27.406 Y12.202 B47.3638 C41.2303
X25.838 Y14.918 B48.6305 C47.8744
X24.271 Y17.634 B50.3345 C54.3789
G0 X33.551 Y24.376 Z19.383
M9
X45.23 Y32.862 Z40
TRAFOOF
SUPA G0 Z0 D0
M5
M30
