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
33 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
34 ; CONDITION no cycle 32 of a program before is in force
35 ; ASSUMED work offset preset 1
36 ; ASSUMED retract to machine coordinate 0 mm
37 ; ASSUMED approach distance 50 mm along the tool axis
38 * - POCKET
39 M129
40 PLANE RESET STAY
41 M127
42 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
43 FN 18: SYSREAD QL1 = ID210 NR1
44 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
45 ; a basic rotation lies over the preset
46 FN 14: ERROR = 102
47 LBL "OFFSET1"
48 M9
49 L Z+0 R0 FMAX M91
50 TOOL CALL 1 Z S4000
51 TOOL DEF 2
52 L Z+0 R0 FMAX M91
53 M3
54 L B+0 C+0 R0 FMAX
55 L X+8 Y+0 R0 FMAX
56 L Z+10 R0 FMAX
57 M8
58 L Z+1 R0 FMAX
59 CC X+0 Y+0
60 CP IPA+360 IZ-2.4 DR+ R0 F200
61 CC X+0 Y+0
62 CP IPA+90 IZ-0.6 DR+
63 L X-20 Y+8 F600
64 CC X-20 Y+0
65 C X-20 Y-8 DR+
66 L X+0
67 CC X+0 Y-13
68 C X+5 Y-13 DR-
69 L Y-20
70 L X+5.081 Y-21.378
71 L X+5.315 Y-22.528
72 L X+5.688 Y-23.469
73 L X+6.185 Y-24.222
74 L X+6.794 Y-24.809
75 L X+7.5 Y-25.25
76 L X+8.727 Y-25.684
77 L X+10.188 Y-25.906
78 L X+11.93 Y-25.988
79 L X+14 Y-26
80 L Z+20
81 M9
82 L Z+70 R0 FMAX
83 * - HOLES
84 M129
85 PLANE RESET STAY
86 M127
87 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
88 FN 18: SYSREAD QL1 = ID210 NR1
89 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
90 ; a basic rotation lies over the preset
91 FN 14: ERROR = 102
92 LBL "OFFSET2"
93 M9
94 L Z+0 R0 FMAX M91
95 M5
96 TOOL CALL 2 Z S2500
97 TOOL DEF 1
98 L Z+0 R0 FMAX M91
99 M3
100 L B+0 C+0 R0 FMAX
101 L X-30 Y+15 R0 FMAX
102 L Z+20 R0 FMAX
103 M8
104 CYCL DEF 205 UNIVERSAL PECKING ~
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
105 L X-30 Y+15 R0 FMAX M99
106 L X-10 R0 FMAX M99
107 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
108 L X-10 Y+25 R0 FMAX M99
109 L Z+7 R0 FMAX
110 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
111 L X+10 Y+25 R0 FMAX M99
112 CYCL DEF 9.0 DWELL TIME
113 CYCL DEF 9.1 DWELL 1.5
114 M9
115 L Z+57 R0 FMAX
116 M129
117 PLANE RESET STAY
118 M127
119 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
120 FN 18: SYSREAD QL1 = ID210 NR1
121 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
122 ; a basic rotation lies over the preset
123 FN 14: ERROR = 102
124 LBL "OFFSET3"
125 M9
126 L Z+0 R0 FMAX M91
127 ; T2 stays in the spindle
128 TOOL CALL S2500
129 M3
130 L B+0 C+0 R0 FMAX
131 L X+0 Y+0 R0 FMAX
132 L Z+110 R0 FMAX
133 M8
134 L Z+60 R0 FMAX
135 M9
136 L Z+110 R0 FMAX
137 L Z+0 R0 FMAX M91
138 M5
139 M30
140 END PGM NONAME MM
