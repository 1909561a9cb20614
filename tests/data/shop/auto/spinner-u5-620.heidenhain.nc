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
27 ; CONDITION L and DL of the tool table are the lengths of the tools
28 ; CONDITION none of M89, M103, M109, M110, M124, M136, M138 and M144 is in force
29 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
30 ; CONDITION cycle 32 is as the machine is delivered
31 ; ASSUMED retract to machine coordinate 0 mm
32 ; ASSUMED approach distance 50 mm along the tool axis
33 * - FACE_ROUGH
34 M129
35 PLANE RESET STAY
36 M127
37 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
38 FN 18: SYSREAD QL1 = ID210 NR1
39 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
40 ; a basic rotation lies over the preset
41 FN 14: ERROR = 102
42 LBL "OFFSET1"
43 M9
44 L Z+0 R0 FMAX M91
45 ; T1 mill 12
46 TOOL CALL 1 Z S4000
47 TOOL DEF 2
48 L Z+0 R0 FMAX M91
49 M3
50 L B+0 C+0 R0 FMAX
51 L X-40 Y-10 R0 FMAX
52 L Z+60 R0 FMAX
53 M8
54 L Z+2 R0 FMAX
55 CYCL DEF 32.0 TOLERANCE
56 CYCL DEF 32.1 T0.05
57 CYCL DEF 32.2 HSC-MODE:1
58 L Z-2 R0 F400
59 L X+40 F1200
60 L Y+10
61 L X-40
62 L Z+60 R0 FMAX
63 M9
64 * - DRILL
65 CYCL DEF 32.0 TOLERANCE
66 CYCL DEF 32.1
67 M129
68 PLANE RESET STAY
69 M127
70 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
71 FN 18: SYSREAD QL1 = ID210 NR1
72 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
73 ; a basic rotation lies over the preset
74 FN 14: ERROR = 102
75 LBL "OFFSET2"
76 M9
77 L Z+0 R0 FMAX M91
78 M5
79 ; T2 drill 8
80 TOOL CALL 2 Z S2500
81 TOOL DEF 3
82 L Z+0 R0 FMAX M91
83 M3
84 L B+0 C+0 R0 FMAX
85 L X+20 Y+0 R0 FMAX
86 L Z+60 R0 FMAX
87 M8
88 CYCL DEF 200 DRILLING ~
  Q200=+3 ;SET-UP CLEARANCE ~
  Q201=-24 ;DEPTH ~
  Q206=+250 ;FEED RATE FOR PLNGNG ~
  Q202=+24 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-2 ;SURFACE COORDINATE ~
  Q204=+10 ;2ND SET-UP CLEARANCE ~
  Q211=+0 ;DWELL TIME AT DEPTH
89 L X+20 Y+0 R0 FMAX M99
90 L X-20 R0 FMAX M99
91 L Z+60 R0 FMAX
92 M9
93 * - FINISH_45
94 M129
95 PLANE RESET STAY
96 M127
97 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
98 FN 18: SYSREAD QL1 = ID210 NR1
99 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
100 ; a basic rotation lies over the preset
101 FN 14: ERROR = 102
102 LBL "OFFSET3"
103 M9
104 L Z+0 R0 FMAX M91
105 M5
106 ; T3 ball 6
107 TOOL CALL 3 Z S9000
108 TOOL DEF 1
109 L Z+0 R0 FMAX M91
110 M3
111 L B+45 C+0 R0 FMAX
112 PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT
113 FN 20: WAIT FOR SYNC
114 FN 18: SYSREAD QL1 = ID270 NR1 IDX5
115 FN 18: SYSREAD QL2 = ID270 NR1 IDX6
116 QL3 = ABS ( SIN ( ( QL1 - 45 ) / 2 ) ) + ABS ( SIN ( ( QL2 - 0 ) / 2 ) )
117 FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"
118 ; after the plane call the axes are not at B45 C0
119 FN 14: ERROR = 101
120 LBL "PLANE1"
121 L X+0 Y-20 R0 FMAX
122 L Z+72 R0 FMAX
123 M8
124 L Z+32 R0 FMAX
125 CYCL DEF 32.0 TOLERANCE
126 CYCL DEF 32.1 T0.01
127 CYCL DEF 32.2 HSC-MODE:0
128 L Z+29 R0 F500
129 L Y+20 F1800
130 L X+1
131 L Y-20
132 L Z+71 R0 FMAX
133 M9
134 L Z+131 R0 FMAX
135 CYCL DEF 32.0 TOLERANCE
136 CYCL DEF 32.1
137 PLANE RESET STAY
138 L Z+0 R0 FMAX M91
139 M5
140 M30
141 END PGM SHOP MM
