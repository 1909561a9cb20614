; PROGRAM NEST
; CL FILE nest.apt
; MACHINE Dmu70e, CONTROL Siemens 840D, MODE axes
; UNITS mm, WORK OFFSET G54
; PART ORIGIN X0 Y0 Z0 from the reference point of the table
; PROGRAMMED POINT tool tip
; TOLERANCE 0.01 for arcs and curves
; CL data of SolidWorks CAM, recognised from the file
; 2 arcs, sense by form, not confirmed by a neighbouring line
; CSYS changes 1 time: all points are read in one common frame
; KINEMATICS *
; DIMENSIONS d = 150 mm
; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
; AXIS X+ moves the tool along +X, as in ISO 841
; AXIS Y+ moves the tool along +Y, as in ISO 841
; AXIS Z+ moves the tool along +Z, as in ISO 841
; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes must not be modulo axes (MD30310 = 0)
; linear limits not checked: no travel declared (X Y Z)
; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
; the entries of C and B in G54 must be zero
; T4 DIA 10 R0 L120 D1, 2 operations, tip Z -15 to 60
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
; ASSUMED points of the CL data are coordinates from the part zero
; ASSUMED work offset G54
; ASSUMED retract to machine coordinate 0 mm
; ASSUMED approach distance 50 mm along the tool axis
; [HOLDER=H1] 10MM END MILL
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
T4
M6
SUPA G0 Z0 D0
; Stock Size X40. Y60. Z40.
D1
S3000 M3
G0 B0 C0
X12.5 Y20
Z25
M8
Z3
G1 Z-2 F150.5
G3 X12.5 Y20 I-2.5 J0 F601.25
G1 X10
G0 Z60
X30
Z3
G1 Z-5 F200.05
G0 Z3
Z-4.5
G1 Z-9
G0 Z3
Z-8.5
G1 Z-12
G0 Z25
M9
Z125
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
; T4 stays in the spindle
D1
S3000 M3
G0 B180 C90
X-20 Y160
Z230
M8
Z195
G1 Z188 F300
G3 X-30 Y160 I-5 J0
G1 Z230
M9
G0 Z330
SUPA G0 Z0 D0
M5
M30
