; PROGRAM without name
; CL FILE passes.cls
; MACHINE SpinnerU5620, CONTROL Siemens 840D, MODE auto (tcp)
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z50 from the reference point of the table
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
G0 B25 C0
CYCLE800(0,"",0,57,0,0,0,0,25,0,0,0,0,1,0)
IF ABS(SIN(($AA_IW[B]-25)/2))+ABS(SIN(($AA_IW[C]-0)/2))>0.0009
MSG("After the plane call the axes are not at B25 C0")
M0
M30
ENDIF
G0 X25.076 Y0
CYCLE800()
G0 B25 C0
TRAORI
ORIMKS ORIAXES
G54
G0 X38.452 Y0 Z23.126
M8
G1 X30 Z5 B25 C0 F600
X29.672 Y3.119 B25.8764 C6.2155 F1200
X29.344 Y6.237 B27 C12
X28.375 Y9.22 B27.8699 C18.1977
X27.406 Y12.202 B29 C24
X25.838 Y14.918 B29.8641 C30.1821
X24.271 Y17.634 B31 C36
G0 X32.604 Y23.688 Z22.143
X34.223 Y17.766 Z22.063 B29.1374 C28.0061
X35.842 Y11.844 Z21.982 B27.8022 C19.1727
X37.461 Y5.922 Z21.901 B27.0733 C9.717
X39.08 Y0 Z21.82 B27 C0
G1 X30 Z4 F600
X29.672 Y3.119 B27.8698 C6.1977 F1200
X29.344 Y6.237 B29 C12.0001
X28.375 Y9.22 B29.864 C18.1821
X27.406 Y12.202 B31 C24
X25.838 Y14.918 B31.8588 C30.1682
X24.271 Y17.634 B33 C36
G0 X33.083 Y24.036 Z20.773
X34.736 Y18.027 Z20.703 B31.0979 C27.9373
X36.39 Y12.018 Z20.633 B29.7503 C19.0818
X38.043 Y6.009 Z20.563 B29.0353 C9.6529
X39.696 Y0 Z20.492 B29 C0
G1 X30 Z3 F600
X29.672 Y3.119 B29.864 C6.182 F1200
X29.344 Y6.237 B31 C12
X28.375 Y9.22 B31.8588 C18.1682
X27.406 Y12.202 B33 C24
X25.838 Y14.918 B33.8543 C30.1559
X24.271 Y17.634 B35 C36
G0 X33.551 Y24.376 Z19.383
M9
X45.23 Y32.862 Z40
TRAFOOF
SUPA G0 Z0 D0
M5
M30
