0 BEGIN PGM NONAME MM
1 BLK FORM 0.1 Z X-33 Y-31 Z-15
2 BLK FORM 0.2 X+19 Y+27.5 Z+20
3 ; PROGRAM without name
4 ; CL FILE pocket.cls
5 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.05 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of NX, recognised from the file
12 ; unit of the CL data is mm, as given; the CL file states none
13 ; 3 arcs, sense by form, confirmed by 3 of 3 neighbouring lines
14 ; KINEMATICS *
15 ; DIMENSIONS d = 150 mm
16 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
17 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
18 ; AXIS X+ moves the tool along +X, as in ISO 841
19 ; AXIS Y+ moves the tool along +Y, as in ISO 841
20 ; AXIS Z+ moves the tool along +Z, as in ISO 841
21 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.05 of its line at feed, the tool axis within 0.1 deg of its great circle
22 ; ROTARY WORDS are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
23 ; linear limits not checked: no travel declared (X Y Z)
24 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
25 ; the entries of C and B in preset 1 must be zero
26 ; T1 DIA 10 R0 L110, 1 operation, tip Z -2 to 20
27 ; T2 DIA 5 L130, 2 operations, tip Z -15 to 60
28 ; CONDITION no global program settings are active (GS)
29 ; CONDITION no preset of a pallet is added to the preset of the program
30 ; CONDITION the kinematics in force are those of this machine and head
31 ; CONDITION L and DL of the tool table are the lengths of the tools
32 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
33 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
34 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
35 ; CONDITION no cycle 32 of a program before is in force
36 ; ASSUMED work offset preset 1
37 ; ASSUMED retract to machine coordinate 0 mm
38 ; ASSUMED approach distance 50 mm along the tool axis
39 * - POCKET
40 M129
41 PLANE RESET STAY
42 M127
43 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
44 FN 18: SYSREAD QL1 = ID210 NR1
45 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
46 ; a basic rotation lies over the preset
47 FN 14: ERROR = 102
48 LBL "OFFSET1"
49 M9
50 L Z+0 R0 FMAX M91
51 TOOL CALL 1 Z S4000
52 TOOL DEF 2
53 L Z+0 R0 FMAX M91
54 M3
55 L B+0 C+0 R0 FMAX
56 L X+8 Y+0 R0 FMAX
57 L Z+10 R0 FMAX
58 M8
59 L Z+1 R0 FMAX
60 CC X+0 Y+0
61 CP IPA+360 IZ-2.4 DR+ R0 F200
62 CC X+0 Y+0
63 CP IPA+90 IZ-0.6 DR+
64 L X-20 Y+8 F600
65 CC X-20 Y+0
66 C X-20 Y-8 DR+
67 L X+0
68 CC X+0 Y-13
69 C X+5 Y-13 DR-
70 L Y-20
71 L X+5.081 Y-21.378
72 L X+5.315 Y-22.528
73 L X+5.688 Y-23.469
74 L X+6.185 Y-24.222
75 L X+6.794 Y-24.809
76 L X+7.5 Y-25.25
77 L X+8.727 Y-25.684
78 L X+10.188 Y-25.906
79 L X+11.93 Y-25.988
80 L X+14 Y-26
81 L Z+20
82 M9
83 L Z+70 R0 FMAX
84 * - HOLES
85 M129
86 PLANE RESET STAY
87 M127
88 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
89 FN 18: SYSREAD QL1 = ID210 NR1
90 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
91 ; a basic rotation lies over the preset
92 FN 14: ERROR = 102
93 LBL "OFFSET2"
94 M9
95 L Z+0 R0 FMAX M91
96 M5
97 TOOL CALL 2 Z S2500
98 TOOL DEF 1
99 L Z+0 R0 FMAX M91
100 M3
101 L B+0 C+0 R0 FMAX
102 L X-30 Y+15 R0 FMAX
103 L Z+20 R0 FMAX
104 M8
105 CYCL DEF 205 UNIVERSAL PECKING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-15 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+6 ;PLUNGING DEPTH ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=+20 ;2ND SET-UP CLEARANCE ~
  Q212=+0 ;DECREMENT ~
  Q205=+0 ;MIN. PLUNGING DEPTH ~
  Q258=+0.5 ;UPPER ADV STOP DIST ~
  Q259=+0.5 ;LOWER ADV STOP DIST ~
  Q257=+0 ;DEPTH FOR CHIP BRKNG ~
  Q256=+0.2 ;DIST FOR CHIP BRKNG ~
  Q211=+0 ;DWELL TIME AT DEPTH ~
  Q379=+0 ;STARTING POINT ~
  Q253=+99999 ;F PRE-POSITIONING
106 L X-30 Y+15 R0 FMAX M99
107 L X-10 R0 FMAX M99
108 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
109 L X-10 Y+25 R0 FMAX M99
110 L Z+7 R0 FMAX
111 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
112 L X+10 Y+25 R0 FMAX M99
113 CYCL DEF 9.0 DWELL TIME
114 CYCL DEF 9.1 DWELL 1.5
115 M9
116 L Z+57 R0 FMAX
117 M129
118 PLANE RESET STAY
119 M127
120 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
121 FN 18: SYSREAD QL1 = ID210 NR1
122 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
123 ; a basic rotation lies over the preset
124 FN 14: ERROR = 102
125 LBL "OFFSET3"
126 M9
127 L Z+0 R0 FMAX M91
128 ; T2 stays in the spindle
129 TOOL CALL S2500
130 M3
131 L B+0 C+0 R0 FMAX
132 L X+0 Y+0 R0 FMAX
133 L Z+110 R0 FMAX
134 M8
135 L Z+60 R0 FMAX
136 M9
137 L Z+110 R0 FMAX
138 L Z+0 R0 FMAX M91
139 M5
140 M30
141 END PGM NONAME MM
