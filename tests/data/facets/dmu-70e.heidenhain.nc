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
31 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
32 ; CONDITION no cycle 32 of a program before is in force
33 ; ASSUMED work offset preset 1
34 ; ASSUMED retract to machine coordinate 0 mm
35 ; ASSUMED approach distance 50 mm along the tool axis
36 M129
37 PLANE RESET STAY
38 M127
39 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
40 FN 18: SYSREAD QL1 = ID210 NR1
41 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
42 ; a basic rotation lies over the preset
43 FN 14: ERROR = 102
44 LBL "OFFSET1"
45 M9
46 L Z+0 R0 FMAX M91
47 TOOL CALL 5 Z S4500
48 TOOL DEF 6
49 L Z+0 R0 FMAX M91
50 M3
51 L B+40.0133 C+34.4378 R0 FMAX
52 L X+83.382 Y+12.486 R0 FMAX
53 L Z+88.929 R0 FMAX
54 M8
55 L Z+26.929 R0 F600
56 L X+104.688 Y+17.972 F850
57 L X+100.2 Y+35.403
58 L Z+90.929 R0 FMAX
59 M9
60 L Z+0 R0 FMAX M91
61 L B+47.3638 C+154.2303 R0 FMAX
62 L X+94.366 Y+22.375 R0 FMAX
63 L Z+98.236 R0 FMAX
64 M8
65 L Z+36.236 F600
66 L X+115.379 Y+28.892 F850
67 L X+110.047 Y+46.084
68 L Z+100.236 R0 FMAX
69 M9
70 L Z+0 R0 FMAX M91
71 M5
72 M0
73 M129
74 PLANE RESET STAY
75 M127
76 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
77 FN 18: SYSREAD QL1 = ID210 NR1
78 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
79 ; a basic rotation lies over the preset
80 FN 14: ERROR = 102
81 LBL "OFFSET2"
82 M9
83 L Z+0 R0 FMAX M91
84 ; T5 stays in the spindle
85 TOOL CALL S4500
86 M3
87 L B+34.1989 C+301.2722 R0 FMAX
88 L X+76.454 Y+7.304 R0 FMAX
89 L Z+83.809 R0 FMAX
90 M8
91 L Z+21.809 R0 F600
92 L X+97.951 Y+11.98 F850
93 L X+94.125 Y+29.569
94 L Z+85.809 R0 FMAX
95 M9
96 M129
97 PLANE RESET STAY
98 M127
99 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
100 FN 18: SYSREAD QL1 = ID210 NR1
101 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET3"
102 ; a basic rotation lies over the preset
103 FN 14: ERROR = 102
104 LBL "OFFSET3"
105 M9
106 L Z+0 R0 FMAX M91
107 M5
108 TOOL CALL 6 Z S9000
109 TOOL DEF 5
110 L Z+0 R0 FMAX M91
111 M3
112 L B+17.7131 C+206.2876 R0 FMAX
113 L X+43.351 Y-3.185 R0 FMAX
114 L Z+68.326 R0 FMAX
115 M8
116 L Z+6.326 R0 F600
117 L X+65.218 Y-0.776 F850
118 L X+63.247 Y+17.116
119 L Z+70.326 R0 FMAX
120 M9
121 M129
122 PLANE RESET STAY
123 M127
124 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
125 FN 18: SYSREAD QL1 = ID210 NR1
126 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET4"
127 ; a basic rotation lies over the preset
128 FN 14: ERROR = 102
129 LBL "OFFSET4"
130 M9
131 L Z+0 R0 FMAX M91
132 M5
133 TOOL CALL 5 Z S4200
134 L Z+0 R0 FMAX M91
135 M3
136 L B+59.3748 C+192.9554 R0 FMAX
137 L X+107.214 Y+34.141 R0 FMAX
138 L Z+111.999 R0 FMAX
139 M8
140 L Z+49.999 R0 F600
141 L X+127.618 Y+42.367 F850
142 L X+120.888 Y+59.061
143 L Z+113.999 R0 FMAX
144 M9
145 L Z+0 R0 FMAX M91
146 M5
147 M30
148 END PGM FACETS MM
