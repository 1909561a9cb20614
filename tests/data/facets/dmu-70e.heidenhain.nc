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
26 ; CONDITION no global program settings are active (GS)
27 ; CONDITION no preset of a pallet is added to the preset of the program
28 ; CONDITION the kinematics in force are those of this machine and head
29 ; CONDITION L and DL of the tool table are the lengths of the tools
30 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
31 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
32 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
33 ; CONDITION no cycle 32 of a program before is in force
34 ; ASSUMED work offset preset 1
35 ; ASSUMED retract to machine coordinate 0 mm
36 ; ASSUMED approach distance 50 mm along the tool axis
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
48 TOOL CALL 5 Z S4500
49 TOOL DEF 6
50 L Z+0 R0 FMAX M91
51 M3
52 L B+40.0133 C+34.4378 R0 FMAX
53 L X+83.382 Y+12.486 R0 FMAX
54 L Z+88.929 R0 FMAX
55 M8
56 L Z+26.929 R0 F600
57 L X+104.688 Y+17.972 F850
58 L X+100.2 Y+35.403
59 L Z+90.929 R0 FMAX
60 M9
61 L Z+0 R0 FMAX M91
62 L B+47.3638 C+154.2303 R0 FMAX
63 L X+94.366 Y+22.375 R0 FMAX
64 L Z+98.236 R0 FMAX
65 M8
66 L Z+36.236 F600
67 L X+115.379 Y+28.892 F850
68 L X+110.047 Y+46.084
69 L Z+100.236 R0 FMAX
70 M9
71 L Z+0 R0 FMAX M91
72 M5
73 M0
74 M129
75 PLANE RESET STAY
76 M127
77 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
78 FN 18: SYSREAD QL1 = ID210 NR1
79 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
80 ; a basic rotation lies over the preset
81 FN 14: ERROR = 102
82 LBL "OFFSET2"
83 M9
84 L Z+0 R0 FMAX M91
85 ; T5 stays in the spindle
86 TOOL CALL S4500
87 M3
88 L B+34.1989 C+301.2722 R0 FMAX
89 L X+76.454 Y+7.304 R0 FMAX
90 L Z+83.809 R0 FMAX
91 M8
92 L Z+21.809 R0 F600
93 L X+97.951 Y+11.98 F850
94 L X+94.125 Y+29.569
95 L Z+85.809 R0 FMAX
96 M9
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
109 TOOL CALL 6 Z S9000
110 TOOL DEF 5
111 L Z+0 R0 FMAX M91
112 M3
113 L B+17.7131 C+206.2876 R0 FMAX
114 L X+43.351 Y-3.185 R0 FMAX
115 L Z+68.326 R0 FMAX
116 M8
117 L Z+6.326 R0 F600
118 L X+65.218 Y-0.776 F850
119 L X+63.247 Y+17.116
120 L Z+70.326 R0 FMAX
121 M9
122 M129
123 PLANE RESET STAY
124 M127
125 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
126 FN 18: SYSREAD QL1 = ID210 NR1
127 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET4"
128 ; a basic rotation lies over the preset
129 FN 14: ERROR = 102
130 LBL "OFFSET4"
131 M9
132 L Z+0 R0 FMAX M91
133 M5
134 TOOL CALL 5 Z S4200
135 L Z+0 R0 FMAX M91
136 M3
137 L B+59.3748 C+192.9554 R0 FMAX
138 L X+107.214 Y+34.141 R0 FMAX
139 L Z+111.999 R0 FMAX
140 M8
141 L Z+49.999 R0 F600
142 L X+127.618 Y+42.367 F850
143 L X+120.888 Y+59.061
144 L Z+113.999 R0 FMAX
145 M9
146 L Z+0 R0 FMAX M91
147 M5
148 M30
149 END PGM FACETS MM
