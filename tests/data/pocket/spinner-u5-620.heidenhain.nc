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
22 ; ROTARY WORDS of C are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
23 ; linear limits not checked: no travel declared (X Y Z)
24 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
25 ; the entries of C and B in preset 1 must be zero
26 ; T1 DIA 10 R0 L110, 1 operation, tip Z -2 to 20
27 ; T2 DIA 5 L130, 2 operations, tip Z -15 to 60
28 ; ASSUMED work offset preset 1
29 ; ASSUMED retract to machine coordinate 0 mm
30 ; ASSUMED approach distance 50 mm along the tool axis
31 * - POCKET
32 M129
33 PLANE RESET STAY
34 M127
35 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
36 M9
37 L Z+0 R0 FMAX M91
38 TOOL CALL 1 Z S4000
39 TOOL DEF 2
40 L Z+0 R0 FMAX M91
41 M3
42 L B+0 C+0 R0 FMAX
43 L X+8 Y+0 R0 FMAX
44 L Z+10 R0 FMAX
45 M8
46 L Z+1 R0 FMAX
47 CC X+0 Y+0
48 CP IPA+360 IZ-2.4 DR+ R0 F200
49 CC X+0 Y+0
50 CP IPA+90 IZ-0.6 DR+
51 L X-20 Y+8 F600
52 CC X-20 Y+0
53 C X-20 Y-8 DR+
54 L X+0
55 CC X+0 Y-13
56 C X+5 Y-13 DR-
57 L Y-20
58 L X+5.081 Y-21.378
59 L X+5.315 Y-22.528
60 L X+5.688 Y-23.469
61 L X+6.185 Y-24.222
62 L X+6.794 Y-24.809
63 L X+7.5 Y-25.25
64 L X+8.727 Y-25.684
65 L X+10.188 Y-25.906
66 L X+11.93 Y-25.988
67 L X+14 Y-26
68 L Z+20
69 M9
70 L Z+70 R0 FMAX
71 * - HOLES
72 M129
73 PLANE RESET STAY
74 M127
75 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
76 M9
77 L Z+0 R0 FMAX M91
78 TOOL CALL 2 Z S2500
79 TOOL DEF 1
80 L Z+0 R0 FMAX M91
81 M3
82 L B+0 C+0 R0 FMAX
83 L X-30 Y+15 R0 FMAX
84 L Z+20 R0 FMAX
85 M8
86 CYCL DEF 205 UNIVERSAL PECKING ~
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
87 L X-30 Y+15 R0 FMAX M99
88 L X-10 R0 FMAX M99
89 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
90 L X-10 Y+25 R0 FMAX M99
91 L Z+7 R0 FMAX
92 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
93 L X+10 Y+25 R0 FMAX M99
94 CYCL DEF 9.0 DWELL TIME
95 CYCL DEF 9.1 DWELL 1.5
96 M9
97 L Z+57 R0 FMAX
98 M129
99 PLANE RESET STAY
100 M127
101 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
102 M9
103 L Z+0 R0 FMAX M91
104 ; T2 stays in the spindle
105 TOOL CALL S2500
106 M3
107 L B+0 C+0 R0 FMAX
108 L X+0 Y+0 R0 FMAX
109 L Z+110 R0 FMAX
110 M8
111 L Z+60 R0 FMAX
112 M9
113 L Z+110 R0 FMAX
114 L Z+0 R0 FMAX M91
115 M5
116 M30
117 END PGM NONAME MM
