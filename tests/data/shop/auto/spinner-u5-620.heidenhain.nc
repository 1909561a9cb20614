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
32 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
33 ; CONDITION no cycle 32 of a program before is in force
34 ; ASSUMED retract to machine coordinate 0 mm
35 ; ASSUMED approach distance 50 mm along the tool axis
36 * - FACE_ROUGH
37 M129
38 PLANE RESET STAY
39 M127
40 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
41 FN 18: SYSREAD QL1 = ID210 NR1
42 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
43 ; a basic rotation lies over the preset
44 FN 14: ERROR = 102
45 LBL "OFFSET1"
46 M9
47 L Z+0 R0 FMAX M91
48 ; T1 mill 12
49 TOOL CALL 1 Z S4000
50 TOOL DEF 2
51 L Z+0 R0 FMAX M91
52 M3
53 L B+0 C+0 R0 FMAX
54 L X-40 Y-10 R0 FMAX
55 L Z+60 R0 FMAX
56 M8
57 L Z+2 R0 FMAX
58 CYCL DEF 32.0 TOLERANCE
59 CYCL DEF 32.1 T0.05
60 CYCL DEF 32.2 HSC-MODE:1
61 L Z-2 R0 F400
62 L X+40 F1200
63 L Y+10
64 L X-40
65 L Z+60 R0 FMAX
66 M9
67 * - DRILL
68 CYCL DEF 32.0 TOLERANCE
69 CYCL DEF 32.1
70 M129
71 PLANE RESET STAY
72 M127
73 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
74 FN 18: SYSREAD QL1 = ID210 NR1
75 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
76 ; a basic rotation lies over the preset
77 FN 14: ERROR = 102
78 LBL "OFFSET2"
79 M9
80 L Z+0 R0 FMAX M91
81 M5
82 ; T2 drill 8
83 TOOL CALL 2 Z S2500
84 TOOL DEF 3
85 L Z+0 R0 FMAX M91
86 M3
87 L B+0 C+0 R0 FMAX
88 L X+20 Y+0 R0 FMAX
89 L Z+60 R0 FMAX
90 M8
91 CYCL DEF 200 DRILLING ~
  Q200=+3 ;SET-UP CLEARANCE ~
  Q201=-24 ;DEPTH ~
  Q206=+250 ;FEED RATE FOR PLNGNG ~
  Q202=+24 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-2 ;SURFACE COORDINATE ~
  Q204=+10 ;2ND SET-UP CLEARANCE ~
  Q211=+0 ;DWELL TIME AT DEPTH
92 L X+20 Y+0 R0 FMAX M99
93 L X-20 R0 FMAX M99
94 L Z+60 R0 FMAX
95 M9
96 * - FINISH_45
97 M129
98 PLANE RESET STAY
99 M127
100 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
101 FN 18: SYSREAD QL1 = ID210 NR1
102 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
103 ; a basic rotation lies over the preset
104 FN 14: ERROR = 102
105 LBL "OFFSET3"
106 M9
107 L Z+0 R0 FMAX M91
108 M5
109 ; T3 ball 6
110 TOOL CALL 3 Z S9000
111 TOOL DEF 1
112 L Z+0 R0 FMAX M91
113 M3
114 L B+45 C+0 R0 FMAX
115 PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT
116 FN 20: WAIT FOR SYNC
117 FN 18: SYSREAD QL1 = ID270 NR1 IDX5
118 FN 18: SYSREAD QL2 = ID270 NR1 IDX6
119 QL3 = ABS ( SIN ( ( QL1 - 45 ) / 2 ) ) + ABS ( SIN ( ( QL2 - 0 ) / 2 ) )
120 FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"
121 ; after the plane call the axes are not at B45 C0
122 FN 14: ERROR = 101
123 LBL "PLANE1"
124 L X+0 Y-20 R0 FMAX
125 L Z+72 R0 FMAX
126 M8
127 L Z+32 R0 FMAX
128 CYCL DEF 32.0 TOLERANCE
129 CYCL DEF 32.1 T0.01
130 CYCL DEF 32.2 HSC-MODE:0
131 L Z+29 R0 F500
132 L Y+20 F1800
133 L X+1
134 L Y-20
135 L Z+71 R0 FMAX
136 M9
137 L Z+131 R0 FMAX
138 CYCL DEF 32.0 TOLERANCE
139 CYCL DEF 32.1
140 PLANE RESET STAY
141 L Z+0 R0 FMAX M91
142 M5
143 M30
144 END PGM SHOP MM
