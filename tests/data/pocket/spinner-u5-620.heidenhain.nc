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
13 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
14 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
15 ; AXIS X+ moves the tool along +X, as in ISO 841
16 ; AXIS Y+ moves the tool along +Y, as in ISO 841
17 ; AXIS Z+ moves the tool along +Z, as in ISO 841
18 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.05 of its line at feed, the tool axis within 0.1 deg of its great circle
19 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
20 ; linear limits not checked: no travel declared (X Y Z)
21 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
22 ; the entries of C and B in preset 1 must be zero
23 ; T1 DIA 10 R0 L110, 1 operation, tip Z -2 to 20
24 ; T2 DIA 5 L130, 2 operations, tip Z -15 to 60
25 ; ASSUMED unit of the CL data is mm, as given; the CL file states none
26 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
27 ; ASSUMED work offset preset 1
28 ; ASSUMED retract to machine coordinate 0 mm
29 ; ASSUMED approach distance 50 mm along the tool axis
30 * - POCKET
31 M129
32 PLANE RESET STAY
33 M127
34 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
35 M9
36 L Z+0 R0 FMAX M91
37 TOOL CALL 1 Z S4000
38 TOOL DEF 2
39 L Z+0 R0 FMAX M91
40 M3
41 L B+0 C+0 R0 FMAX
42 L X+8 Y+0 R0 FMAX
43 L Z+10 R0 FMAX
44 M8
45 L Z+1 R0 FMAX
46 CC X+0 Y+0
47 CP IPA+360 IZ-2.4 DR+ R0 F200
48 CC X+0 Y+0
49 CP IPA+90 IZ-0.6 DR+
50 L X-20 Y+8 F600
51 CC X-20 Y+0
52 C X-20 Y-8 DR+
53 L X+0
54 CC X+0 Y-13
55 C X+5 Y-13 DR-
56 L Y-20
57 L X+5.081 Y-21.378
58 L X+5.315 Y-22.528
59 L X+5.688 Y-23.469
60 L X+6.185 Y-24.222
61 L X+6.794 Y-24.809
62 L X+7.5 Y-25.25
63 L X+8.727 Y-25.684
64 L X+10.188 Y-25.906
65 L X+11.93 Y-25.988
66 L X+14 Y-26
67 L Z+20
68 M9
69 L Z+70 R0 FMAX
70 * - HOLES
71 M129
72 PLANE RESET STAY
73 M127
74 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
75 M9
76 L Z+0 R0 FMAX M91
77 TOOL CALL 2 Z S2500
78 TOOL DEF 1
79 L Z+0 R0 FMAX M91
80 M3
81 L B+0 C+0 R0 FMAX
82 L X-30 Y+15 R0 FMAX
83 L Z+20 R0 FMAX
84 M8
85 CYCL DEF 205 UNIVERSAL PECKING ~
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
86 L X-30 Y+15 R0 FMAX M99
87 L X-10 R0 FMAX M99
88 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
89 L X-10 Y+25 R0 FMAX M99
90 L Z+7 R0 FMAX
91 CYCL DEF 200 DRILLING ~
  Q200=+2 ;SET-UP CLEARANCE ~
  Q201=-4 ;DEPTH ~
  Q206=+150 ;FEED RATE FOR PLNGNG ~
  Q202=+4 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+5 ;SURFACE COORDINATE ~
  Q204=+2 ;2ND SET-UP CLEARANCE ~
  Q211=+0.5 ;DWELL TIME AT DEPTH
92 L X+10 Y+25 R0 FMAX M99
93 CYCL DEF 9.0 DWELL TIME
94 CYCL DEF 9.1 DWELL 1.5
95 M9
96 L Z+57 R0 FMAX
97 M129
98 PLANE RESET STAY
99 M127
100 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
101 M9
102 L Z+0 R0 FMAX M91
103 ; T2 stays in the spindle
104 TOOL CALL S2500
105 M3
106 L B+0 C+0 R0 FMAX
107 L X+0 Y+0 R0 FMAX
108 L Z+110 R0 FMAX
109 M8
110 L Z+60 R0 FMAX
111 M9
112 L Z+110 R0 FMAX
113 L Z+0 R0 FMAX M91
114 M5
115 M30
116 END PGM NONAME MM
