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
12 ; 3 arcs, sense by form, confirmed by 3 of 3 neighbouring lines
13 ; KINEMATICS *
14 ; DIMENSIONS d = 150 mm
15 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
16 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
17 ; AXIS X+ moves the tool along +X, as in ISO 841
18 ; AXIS Y+ moves the tool along +Y, as in ISO 841
19 ; AXIS Z+ moves the tool along +Z, as in ISO 841
20 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.05 of its line at feed, the tool axis within 0.1 deg of its great circle
21 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
22 ; linear limits not checked: no travel declared (X Y Z)
23 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
24 ; the entries of C and B in preset 1 must be zero
25 ; T1 DIA 10 R0 L110, 1 operation, tip Z -2 to 20
26 ; T2 DIA 5 L130, 2 operations, tip Z -15 to 60
27 ; ASSUMED unit of the CL data is mm, as given; the CL file states none
28 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
29 ; ASSUMED work offset preset 1
30 ; ASSUMED retract to machine coordinate 0 mm
31 ; ASSUMED approach distance 50 mm along the tool axis
32 * - POCKET
33 M129
34 PLANE RESET STAY
35 M127
36 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
37 M9
38 L Z+0 R0 FMAX M91
39 TOOL CALL 1 Z S4000
40 TOOL DEF 2
41 L Z+0 R0 FMAX M91
42 M3
43 L B+0 C+0 R0 FMAX
44 L X+8 Y+0 R0 FMAX
45 L Z+10 R0 FMAX
46 M8
47 L Z+1 R0 FMAX
48 CC X+0 Y+0
49 CP IPA+360 IZ-2.4 DR+ R0 F200
50 CC X+0 Y+0
51 CP IPA+90 IZ-0.6 DR+
52 L X-20 Y+8 F600
53 CC X-20 Y+0
54 C X-20 Y-8 DR+
55 L X+0
56 CC X+0 Y-13
57 C X+5 Y-13 DR-
58 L Y-20
59 L X+5.081 Y-21.378
60 L X+5.315 Y-22.528
61 L X+5.688 Y-23.469
62 L X+6.185 Y-24.222
63 L X+6.794 Y-24.809
64 L X+7.5 Y-25.25
65 L X+8.727 Y-25.684
66 L X+10.188 Y-25.906
67 L X+11.93 Y-25.988
68 L X+14 Y-26
69 L Z+20
70 M9
71 L Z+70 R0 FMAX
72 * - HOLES
73 M129
74 PLANE RESET STAY
75 M127
76 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
77 M9
78 L Z+0 R0 FMAX M91
79 TOOL CALL 2 Z S2500
80 TOOL DEF 1
81 L Z+0 R0 FMAX M91
82 M3
83 L B+0 C+0 R0 FMAX
84 L X-30 Y+15 R0 FMAX
85 L Z+20 R0 FMAX
86 M8
87 CYCL DEF 205 UNIVERSAL PECKING ~
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
88 L X-30 Y+15 R0 FMAX M99
89 L X-10 R0 FMAX M99
90 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
91 L X-10 Y+25 R0 FMAX M99
92 L Z+7 R0 FMAX
93 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
94 L X+10 Y+25 R0 FMAX M99
95 CYCL DEF 9.0 DWELL TIME
96 CYCL DEF 9.1 DWELL 1.5
97 M9
98 L Z+57 R0 FMAX
99 M129
100 PLANE RESET STAY
101 M127
102 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
103 M9
104 L Z+0 R0 FMAX M91
105 ; T2 stays in the spindle
106 TOOL CALL S2500
107 M3
108 L B+0 C+0 R0 FMAX
109 L X+0 Y+0 R0 FMAX
110 L Z+110 R0 FMAX
111 M8
112 L Z+60 R0 FMAX
113 M9
114 L Z+110 R0 FMAX
115 L Z+0 R0 FMAX M91
116 M5
117 M30
118 END PGM NONAME MM
