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
27 ; ASSUMED retract to machine coordinate 0 mm
28 ; ASSUMED approach distance 50 mm along the tool axis
29 * - FACE_ROUGH
30 M129
31 PLANE RESET STAY
32 M127
33 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
34 M9
35 L Z+0 R0 FMAX M91
36 ; T1 mill 12
37 TOOL CALL 1 Z S4000
38 TOOL DEF 2
39 L Z+0 R0 FMAX M91
40 M3
41 L B+0 C+0 R0 FMAX
42 L X-40 Y-10 R0 FMAX
43 L Z+60 R0 FMAX
44 M8
45 L Z+2 R0 FMAX
46 CYCL DEF 32.0 TOLERANCE
47 CYCL DEF 32.1 T0.05
48 CYCL DEF 32.2 HSC-MODE:1
49 L Z-2 R0 F400
50 L X+40 F1200
51 L Y+10
52 L X-40
53 L Z+60 R0 FMAX
54 M9
55 * - DRILL
56 CYCL DEF 32.0 TOLERANCE
57 CYCL DEF 32.1
58 M129
59 PLANE RESET STAY
60 M127
61 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
62 M9
63 L Z+0 R0 FMAX M91
64 M5
65 ; T2 drill 8
66 TOOL CALL 2 Z S2500
67 TOOL DEF 3
68 L Z+0 R0 FMAX M91
69 M3
70 L B+0 C+0 R0 FMAX
71 L X+20 Y+0 R0 FMAX
72 L Z+60 R0 FMAX
73 M8
74 CYCL DEF 200 DRILLING ~
  Q200=+3 ;SET-UP CLEARANCE ~
  Q201=-24 ;DEPTH ~
  Q206=+250 ;FEED RATE FOR PLNGNG ~
  Q202=+24 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=-2 ;SURFACE COORDINATE ~
  Q204=+10 ;2ND SET-UP CLEARANCE ~
  Q211=+0 ;DWELL TIME AT DEPTH
75 L X+20 Y+0 R0 FMAX M99
76 L X-20 R0 FMAX M99
77 L Z+60 R0 FMAX
78 M9
79 * - FINISH_45
80 M129
81 PLANE RESET STAY
82 M127
83 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
84 M9
85 L Z+0 R0 FMAX M91
86 M5
87 ; T3 ball 6
88 TOOL CALL 3 Z S9000
89 TOOL DEF 1
90 L Z+0 R0 FMAX M91
91 M3
92 L B+45 C+0 R0 FMAX
93 PLANE SPATIAL SPA+0 SPB+45 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT
94 FN 20: WAIT FOR SYNC
95 FN 18: SYSREAD QL1 = ID270 NR1 IDX5
96 FN 18: SYSREAD QL2 = ID270 NR1 IDX6
97 QL3 = ABS ( SIN ( ( QL1 - 45 ) / 2 ) ) + ABS ( SIN ( ( QL2 - 0 ) / 2 ) )
98 FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"
99 ; after the plane call the axes are not at B45 C0
100 FN 14: ERROR = 101
101 LBL "PLANE1"
102 L X+0 Y-20 R0 FMAX
103 L Z+72 R0 FMAX
104 M8
105 L Z+32 R0 FMAX
106 CYCL DEF 32.0 TOLERANCE
107 CYCL DEF 32.1 T0.01
108 CYCL DEF 32.2 HSC-MODE:0
109 L Z+29 R0 F500
110 L Y+20 F1800
111 L X+1
112 L Y-20
113 L Z+71 R0 FMAX
114 M9
115 L Z+131 R0 FMAX
116 CYCL DEF 32.0 TOLERANCE
117 CYCL DEF 32.1
118 PLANE RESET STAY
119 L Z+0 R0 FMAX M91
120 M5
121 M30
122 END PGM SHOP MM
