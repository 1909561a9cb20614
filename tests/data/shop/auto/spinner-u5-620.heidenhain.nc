0 BEGIN PGM SHOP MM
1 BLK FORM CYLINDER Z R50 L40 DIST+0
2 ; PROGRAM SHOP
3 ; CL FILE shop.cls
4 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE auto (plane)
5 ; UNITS mm, WORK OFFSET preset 1
6 ; PART ORIGIN X0 Y0 Z50 from the reference point of the table
7 ; PROGRAMMED POINT tool tip
8 ; TOLERANCE 0.01 for arcs and curves
9 ; Heidenhain TNC has no program numbers: `control.program_number` is left out
10 ; Heidenhain TNC has no swivel data: `control.swivel_data` is left out
11 ; operation 1 FACE_ROUGH: smoothing rough, path tolerance 0.05 mm
12 ; CL data of NX, recognised from the file
13 ; KINEMATICS *
14 ; DIMENSIONS d = 150 mm
15 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
16 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
17 ; AXIS X+ moves the tool along +X, as in ISO 841
18 ; AXIS Y+ moves the tool along +Y, as in ISO 841
19 ; AXIS Z+ moves the tool along +Z, as in ISO 841
20 ; LINEAR WORDS are tip coordinates in the tilted plane, from the same zero
21 ; MODE plane: the master axis of SEQ must be the rotary axis nearest the tool
22 ; linear limits not checked: no travel declared (X Y Z)
23 ; the entries of C and B in preset 1 must be zero
24 ; T1 mill 12 DIA 12 L120, 1 operation, tip Z -2 to 60
25 ; T2 drill 8 L140, 1 operation, tip Z -26 to 60
26 ; T3 ball 6 DIA 6 R3 L110, 1 operation, tip Z 19.799 to 50.912
27 ; CONDITION no global program settings are active (GS)
28 ; CONDITION no preset of a pallet is added to the preset of the program
29 ; CONDITION the kinematics in force are those of this machine and head
30 ; CONDITION L and DL of the tool table are the lengths of the tools
31 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
32 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
33 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
34 ; CONDITION no cycle 32 of a program before is in force
35 ; ASSUMED retract to machine coordinate 0 mm
36 ; ASSUMED approach distance 50 mm along the tool axis
37 * - FACE_ROUGH
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
49 ; T1 mill 12
50 TOOL CALL 1 Z S4000
51 TOOL DEF 2
52 L Z+0 R0 FMAX M91
53 M3
54 L B+0 C+0 R0 FMAX
55 L X-40 Y-10 R0 FMAX
56 L Z+60 R0 FMAX
57 M8
58 L Z+2 R0 FMAX
59 CYCL DEF 32.0 TOLERANCE
60 CYCL DEF 32.1 T0.05
61 CYCL DEF 32.2 HSC-MODE:1
62 L Z-2 R0 F400
63 L X+40 F1200
64 L Y+10
65 L X-40
66 L Z+60 R0 FMAX
67 M9
68 * - DRILL
69 CYCL DEF 32.0 TOLERANCE
70 CYCL DEF 32.1
71 M129
72 PLANE RESET STAY
73 M127
74 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
75 FN 18: SYSREAD QL1 = ID210 NR1
76 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
77 ; a basic rotation lies over the preset
78 FN 14: ERROR = 102
79 LBL "OFFSET2"
80 M9
81 L Z+0 R0 FMAX M91
82 M5
83 ; T2 drill 8
84 TOOL CALL 2 Z S2500
85 TOOL DEF 3
86 L Z+0 R0 FMAX M91
87 M3
88 L B+0 C+0 R0 FMAX
89 L X+20 Y+0 R0 FMAX
90 L Z+60 R0 FMAX
91 M8
92 CYCL DEF 200 DRILLING ~
  Q200=+3 ;SET-UP CLEARANCE ~
  Q201=-24 ;DEPTH ~
  Q206=+250 ;FEED RATE FOR PLNGNG ~
  Q202=+24 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-2 ;SURFACE COORDINATE ~
  Q204=+10 ;2ND SET-UP CLEARANCE ~
  Q211=+0 ;DWELL TIME AT DEPTH
93 L X+20 Y+0 R0 FMAX M99
94 L X-20 R0 FMAX M99
95 L Z+60 R0 FMAX
96 M9
97 * - FINISH_45
98 M129
99 PLANE RESET STAY
100 M127
101 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
102 FN 18: SYSREAD QL1 = ID210 NR1
103 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
104 ; a basic rotation lies over the preset
105 FN 14: ERROR = 102
106 LBL "OFFSET3"
107 M9
108 L Z+0 R0 FMAX M91
109 M5
110 ; T3 ball 6
111 TOOL CALL 3 Z S9000
112 TOOL DEF 1
113 L Z+0 R0 FMAX M91
114 M3
115 L B+45 C+0 R0 FMAX
116 PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT
117 FN 20: WAIT FOR SYNC
118 FN 18: SYSREAD QL1 = ID270 NR1 IDX5
119 FN 18: SYSREAD QL2 = ID270 NR1 IDX6
120 QL3 = ABS ( SIN ( ( QL1 - 45 ) / 2 ) ) + ABS ( SIN ( ( QL2 - 0 ) / 2 ) )
121 FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"
122 ; after the plane call the axes are not at B45 C0
123 FN 14: ERROR = 101
124 LBL "PLANE1"
125 L X+0 Y-20 R0 FMAX
126 L Z+72 R0 FMAX
127 M8
128 L Z+32 R0 FMAX
129 CYCL DEF 32.0 TOLERANCE
130 CYCL DEF 32.1 T0.01
131 CYCL DEF 32.2 HSC-MODE:0
132 L Z+29 R0 F500
133 L Y+20 F1800
134 L X+1
135 L Y-20
136 L Z+71 R0 FMAX
137 M9
138 L Z+131 R0 FMAX
139 CYCL DEF 32.0 TOLERANCE
140 CYCL DEF 32.1
141 PLANE RESET STAY
142 L Z+0 R0 FMAX M91
143 M5
144 M30
145 END PGM SHOP MM
