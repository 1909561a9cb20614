0 BEGIN PGM FACETS MM
1 BLK FORM 0.1 Z X-44.738 Y-46.542 Z-13.517
2 BLK FORM 0.2 X+44.515 Y+38.484 Z+1.964
3 ; PROGRAM FACETS
4 ; CL FILE facets.aptsource
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of CATIA, recognised from the file
12 ; KINEMATICS *
13 ; DIMENSIONS d = 150 mm
14 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
15 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
16 ; AXIS X+ moves the tool along +X, as in ISO 841
17 ; AXIS Y+ moves the tool along +Y, as in ISO 841
18 ; AXIS Z+ moves the tool along +Z, as in ISO 841
19 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
20 ; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
21 ; linear limits not checked: no travel declared (X Y Z)
22 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
23 ; the entries of C and B in preset 1 must be zero
24 ; T5 DIA 16 R0 L132.5, 3 operations, tip Z -13.517 to 58.514
25 ; T6 DIA 6 R0 L97.25, 1 operation, tip Z -4.281 to 61.011
26 ; CONDITION L and DL of the tool table are the lengths of the tools
27 ; CONDITION none of M89, M103, M109, M110, M124, M136, M138 and M144 is in force
28 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
29 ; CONDITION cycle 32 is as the machine is delivered
30 ; ASSUMED work offset preset 1
31 ; ASSUMED retract to machine coordinate 0 mm
32 ; ASSUMED approach distance 50 mm along the tool axis
33 M129
34 PLANE RESET STAY
35 M127
36 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
37 FN 18: SYSREAD QL1 = ID210 NR1
38 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
39 ; a basic rotation lies over the preset
40 FN 14: ERROR = 102
41 LBL "OFFSET1"
42 M9
43 L Z+0 R0 FMAX M91
44 TOOL CALL 5 Z S4500
45 TOOL DEF 6
46 L Z+0 R0 FMAX M91
47 M3
48 L B+40.0133 C+34.4378 R0 FMAX
49 L X+83.382 Y+12.486 R0 FMAX
50 L Z+88.929 R0 FMAX
51 M8
52 L Z+26.929 R0 F600
53 L X+104.688 Y+17.972 F850
54 L X+100.2 Y+35.403
55 L Z+90.929 R0 FMAX
56 M9
57 L Z+0 R0 FMAX M91
58 L B+47.3638 C+154.2303 R0 FMAX
59 L X+94.366 Y+22.375 R0 FMAX
60 L Z+98.236 R0 FMAX
61 M8
62 L Z+36.236 F600
63 L X+115.379 Y+28.892 F850
64 L X+110.047 Y+46.084
65 L Z+100.236 R0 FMAX
66 M9
67 L Z+0 R0 FMAX M91
68 M5
69 M0
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
81 ; T5 stays in the spindle
82 TOOL CALL S4500
83 M3
84 L B+34.1989 C+301.2722 R0 FMAX
85 L X+76.454 Y+7.304 R0 FMAX
86 L Z+83.809 R0 FMAX
87 M8
88 L Z+21.809 R0 F600
89 L X+97.951 Y+11.98 F850
90 L X+94.125 Y+29.569
91 L Z+85.809 R0 FMAX
92 M9
93 M129
94 PLANE RESET STAY
95 M127
96 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
97 FN 18: SYSREAD QL1 = ID210 NR1
98 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
99 ; a basic rotation lies over the preset
100 FN 14: ERROR = 102
101 LBL "OFFSET3"
102 M9
103 L Z+0 R0 FMAX M91
104 M5
105 TOOL CALL 6 Z S9000
106 TOOL DEF 5
107 L Z+0 R0 FMAX M91
108 M3
109 L B+17.7131 C+206.2876 R0 FMAX
110 L X+43.351 Y-3.185 R0 FMAX
111 L Z+68.326 R0 FMAX
112 M8
113 L Z+6.326 R0 F600
114 L X+65.218 Y-0.776 F850
115 L X+63.247 Y+17.116
116 L Z+70.326 R0 FMAX
117 M9
118 M129
119 PLANE RESET STAY
120 M127
121 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
122 FN 18: SYSREAD QL1 = ID210 NR1
123 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET4"
124 ; a basic rotation lies over the preset
125 FN 14: ERROR = 102
126 LBL "OFFSET4"
127 M9
128 L Z+0 R0 FMAX M91
129 M5
130 TOOL CALL 5 Z S4200
131 L Z+0 R0 FMAX M91
132 M3
133 L B+59.3748 C+192.9554 R0 FMAX
134 L X+107.214 Y+34.141 R0 FMAX
135 L Z+111.999 R0 FMAX
136 M8
137 L Z+49.999 R0 F600
138 L X+127.618 Y+42.367 F850
139 L X+120.888 Y+59.061
140 L Z+113.999 R0 FMAX
141 M9
142 L Z+0 R0 FMAX M91
143 M5
144 M30
145 END PGM FACETS MM
