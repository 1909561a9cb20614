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
20 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
21 ; linear limits not checked: no travel declared (X Y Z)
22 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
23 ; the entries of C and B in preset 1 must be zero
24 ; T5 DIA 16 R0 L132.5, 3 operations, tip Z -13.517 to 58.514
25 ; T6 DIA 6 R0 L97.25, 1 operation, tip Z -4.281 to 61.011
26 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
27 ; ASSUMED work offset preset 1
28 ; ASSUMED retract to machine coordinate 0 mm
29 ; ASSUMED approach distance 50 mm along the tool axis
30 M129
31 PLANE RESET STAY
32 M127
33 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
34 M9
35 L Z+0 R0 FMAX M91
36 TOOL CALL 5 Z S4500
37 TOOL DEF 6
38 L Z+0 R0 FMAX M91
39 M3
40 L B+40.0133 C+34.4378 R0 FMAX
41 L X+83.382 Y+12.486 R0 FMAX
42 L Z+88.929 R0 FMAX
43 M8
44 L Z+26.929 R0 F600
45 L X+104.688 Y+17.972 F850
46 L X+100.2 Y+35.403
47 L Z+90.929 R0 FMAX
48 M9
49 L Z+0 R0 FMAX M91
50 L B+47.3638 C+154.2303 R0 FMAX
51 L X+94.366 Y+22.375 R0 FMAX
52 L Z+98.236 R0 FMAX
53 M8
54 L Z+36.236 F600
55 L X+115.379 Y+28.892 F850
56 L X+110.047 Y+46.084
57 L Z+100.236 R0 FMAX
58 M9
59 L Z+0 R0 FMAX M91
60 M5
61 M0
62 M129
63 PLANE RESET STAY
64 M127
65 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
66 M9
67 L Z+0 R0 FMAX M91
68 ; T5 stays in the spindle
69 TOOL CALL S4500
70 M3
71 L B+34.1989 C+301.2722 R0 FMAX
72 L X+76.454 Y+7.304 R0 FMAX
73 L Z+83.809 R0 FMAX
74 M8
75 L Z+21.809 R0 F600
76 L X+97.951 Y+11.98 F850
77 L X+94.125 Y+29.569
78 L Z+85.809 R0 FMAX
79 M9
80 M129
81 PLANE RESET STAY
82 M127
83 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
84 M9
85 L Z+0 R0 FMAX M91
86 TOOL CALL 6 Z S9000
87 TOOL DEF 5
88 L Z+0 R0 FMAX M91
89 M3
90 L B+17.7131 C+206.2876 R0 FMAX
91 L X+43.351 Y-3.185 R0 FMAX
92 L Z+68.326 R0 FMAX
93 M8
94 L Z+6.326 R0 F600
95 L X+65.218 Y-0.776 F850
96 L X+63.247 Y+17.116
97 L Z+70.326 R0 FMAX
98 M9
99 M129
100 PLANE RESET STAY
101 M127
102 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
103 M9
104 L Z+0 R0 FMAX M91
105 TOOL CALL 5 Z S4200
106 L Z+0 R0 FMAX M91
107 M3
108 L B+59.3748 C+192.9554 R0 FMAX
109 L X+107.214 Y+34.141 R0 FMAX
110 L Z+111.999 R0 FMAX
111 M8
112 L Z+49.999 R0 F600
113 L X+127.618 Y+42.367 F850
114 L X+120.888 Y+59.061
115 L Z+113.999 R0 FMAX
116 M9
117 L Z+0 R0 FMAX M91
118 M5
119 M30
120 END PGM FACETS MM
