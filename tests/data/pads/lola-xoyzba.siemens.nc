; PROGRAM PADS
; CL FILE pads.cls
; MACHINE LolaXoyzba, CONTROL Siemens 840D, MODE axes
; UNITS mm, WORK OFFSET G57
; PART ORIGIN X12.5 Y-8 Z40 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; CL data of NX, recognised from the file
; KINEMATICS *
; AXIS X+ moves the table against +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; AXIS B+ rotates the tool right-handed about +Y, as in ISO 841
; AXIS A+ rotates the tool right-handed about +X, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; G57 must hold X20 Y-15 Z-520
; the entries of B and A in G57 must be zero
; T21 bull 12 DIA 12 R1 L120.25 D1, 1 operation, tip Z -9.4 to 0.521
; T21 posted with L = 120.25: D1 must hold exactly this
; T22 DIA 12 R1 L96.5 D52, 1 operation, tip Z -3.3 to -1.375
; T22 posted with L = 96.5: D52 must hold exactly this
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
; ASSUMED retract to machine coordinate 0 mm
MSG("SOUTH")
N1 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G57
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
; T21 bull 12
T21
M6
T22
SUPA G0 Z0 D0
D1
IF ABS($P_TOOLL[1]-120.25)>0.01
MSG("T21 was posted with L = 120.25: the length in the tool data differs")
M0
M30
ENDIF
S5200 M3
G0 A18.266 B2.2556
X7.995 Y-63.387
Z-5.627
M8
G1 X7.864 Y-62.29 Z-8.948 F300
X22.064 Y-60.597 F700
X22.138 Y-61.224 Z-7.05
M9
G0 X24.942 Y-84.731 Z64.116
SUPA G0 Z0 D0
D1
G0 A35.8066 B4.9348
X10.74 Y-121.986
Z-5.421
M8
X8.647 Y-104.434 Z-29.661
G1 X14.559 Y-101.652 Z-32.489 F300
X28.758 Y-99.959 F700
X28.898 Y-101.129 Z-30.873
M9
G0 X34.13 Y-145.008 Z29.726
MSG("NORTH")
N2 TRAFOOF
CYCLE800()
TRANS
G710 G17 G40 G64 G90 G94 G57
IF (ABS($P_ACTFRAME[X,RT])+ABS($P_ACTFRAME[Y,RT])+ABS($P_ACTFRAME[Z,RT])+ABS($P_ACTFRAME[X,SC]-1)+ABS($P_ACTFRAME[Y,SC]-1)+ABS($P_ACTFRAME[Z,SC]-1)>0.0001) OR $P_ACTFRAME[X,MI] OR $P_ACTFRAME[Y,MI] OR $P_ACTFRAME[Z,MI]
MSG("A rotation, a scale or a mirror lies over the work offset")
M0
M30
ENDIF
M9
SUPA G0 Z0 D0
M5
T22
M6
T21
SUPA G0 Z0 D0
D52
IF ABS($P_TOOLL[1]-96.5)>0.01
MSG("T22 was posted with L = 96.5: the length in the tool data differs")
M0
M30
ENDIF
S6100 M3
G0 A-15.5586 B-2.129
X-8.957 Y60.13
Z21.98
M8
G1 X-7.884 Y52.084 Z-6.9 F300
X-22.058 Y50.192 F700
X-22.13 Y50.729 Z-4.975
M9
G0 X-24.814 Y70.846 Z67.227
SUPA G0 Z0 D0
M5
SUPA G0 X0 Y240 D0
M30
