0 BEGIN PGM PLATE INCH
1 BLK FORM 0.1 Z X-0.125 Y-0.375 Z-0.4
2 BLK FORM 0.2 X+1.375 Y+0.625 Z+1
3 ; PROGRAM PLATE
4 ; CL FILE plate.ncl
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS in, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.001 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of Creo, recognised from the file
12 ; 1 arc, sense by form, confirmed by 1 of 1 neighbouring lines
13 ; KINEMATICS *
14 ; DIMENSIONS d = 150 mm
15 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
16 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
17 ; AXIS X+ moves the tool along +X, as in ISO 841
18 ; AXIS Y+ moves the tool along +Y, as in ISO 841
19 ; AXIS Z+ moves the tool along +Z, as in ISO 841
20 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.001 of its line at feed, the tool axis within 0.1 deg of its great circle
21 ; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
22 ; linear limits not checked: no travel declared (X Y Z)
23 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
24 ; the entries of C and B in preset 1 must be zero
25 ; T3 DIA 0.25 L4, 1 operation, tip Z -0.4 to 1
26 ; CONDITION no global program settings are active (GS)
27 ; CONDITION no preset of a pallet is added to the preset of the program
28 ; CONDITION the kinematics in force are those of this machine and head
29 ; CONDITION L and DL of the tool table are the lengths of the tools
30 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
31 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
32 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
33 ; CONDITION no cycle 32 of a program before is in force
34 ; ASSUMED work offset preset 1
35 ; ASSUMED retract to machine coordinate 0 in
36 ; ASSUMED approach distance 1.968504 in along the tool axis
37 ; ASSUMED F is in 1/10 inch/min, in cycles (Q206) as well
38 M129
39 PLANE RESET STAY
40 M127
41 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
42 FN 18: SYSREAD QL1 = ID210 NR1
43 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
44 ; a basic rotation lies over the preset
45 FN 14: ERROR = 102
46 LBL "OFFSET1"
47 M9
48 L Z+0 R0 FMAX M91
49 TOOL CALL 3 Z S3000
50 L Z+0 R0 FMAX M91
51 M3
52 L B+0 C+0 R0 FMAX
53 L X+0 Y+0.5 R0 FMAX
54 L Z+1 R0 FMAX
55 L Z-0.1 R0 F200
56 L X+1
57 CC X+1 Y+0.25
58 C X+1 Y+0 DR-
59 L X+0
60 L Y-0.25
61 L Z+1
62 CYCL DEF 203 UNIVERSAL DRILLING ~
  Q200=+0.1 ;SET-UP CLEARANCE ~
  Q201=-0.4 ;DEPTH ~
  Q206=+40 ;FEED RATE FOR PLNGNG ~
  Q202=+0.15 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=+0.5 ;2ND SET-UP CLEARANCE ~
  Q212=+0 ;DECREMENT ~
  Q213=+3 ;NR OF BREAKS ~
  Q205=+0 ;MIN. PLUNGING DEPTH ~
  Q211=+0 ;DWELL TIME AT DEPTH ~
  Q208=+99999 ;RETRACTION FEED RATE ~
  Q256=+0.0197 ;DIST FOR CHIP BRKNG
63 L X+0.25 Y+0.25 R0 FMAX M99
64 L X+0.75 R0 FMAX M99
65 L Z+1 R0 FMAX
66 L Z+3 R0 FMAX
67 L Z+0 R0 FMAX M91
68 M5
69 M30
70 END PGM PLATE INCH
