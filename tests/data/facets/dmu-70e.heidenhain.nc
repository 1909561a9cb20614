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
12 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
13 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
14 ; AXIS X+ moves the tool along +X, as in ISO 841
15 ; AXIS Y+ moves the tool along +Y, as in ISO 841
16 ; AXIS Z+ moves the tool along +Z, as in ISO 841
17 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
18 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
19 ; linear limits not checked: no travel declared (X Y Z)
20 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
21 ; the entries of C and B in preset 1 must be zero
22 ; T5 DIA 16 R0 L132.5, 3 operations, tip Z -13.517 to 58.514
23 ; T6 DIA 6 R0 L97.25, 1 operation, tip Z -4.281 to 61.011
24 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
25 ; ASSUMED work offset preset 1
26 ; ASSUMED retract to machine coordinate 0 mm
27 ; ASSUMED approach distance 50 mm along the tool axis
28 M129
29 PLANE RESET STAY
30 M127
31 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
32 M9
33 L Z+0 R0 FMAX M91
34 TOOL CALL 5 Z S4500
35 TOOL DEF 6
36 L Z+0 R0 FMAX M91
37 M3
38 L B+40.0133 C+34.4378 R0 FMAX
39 L X+83.382 Y+12.486 R0 FMAX
40 L Z+88.929 R0 FMAX
41 M8
42 L Z+26.929 R0 F600
43 L X+104.688 Y+17.972 F850
44 L X+100.2 Y+35.403
45 L Z+90.929 R0 FMAX
46 M9
47 L Z+0 R0 FMAX M91
48 L B+47.3638 C+154.2303 R0 FMAX
49 L X+94.366 Y+22.375 R0 FMAX
50 L Z+98.236 R0 FMAX
51 M8
52 L Z+36.236 F600
53 L X+115.379 Y+28.892 F850
54 L X+110.047 Y+46.084
55 L Z+100.236 R0 FMAX
56 M9
57 L Z+0 R0 FMAX M91
58 M5
59 M0
60 M129
61 PLANE RESET STAY
62 M127
63 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
64 M9
65 L Z+0 R0 FMAX M91
66 ; T5 stays in the spindle
67 TOOL CALL S4500
68 M3
69 L B+34.1989 C+301.2722 R0 FMAX
70 L X+76.454 Y+7.304 R0 FMAX
71 L Z+83.809 R0 FMAX
72 M8
73 L Z+21.809 R0 F600
74 L X+97.951 Y+11.98 F850
75 L X+94.125 Y+29.569
76 L Z+85.809 R0 FMAX
77 M9
78 M129
79 PLANE RESET STAY
80 M127
81 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
82 M9
83 L Z+0 R0 FMAX M91
84 TOOL CALL 6 Z S9000
85 TOOL DEF 5
86 L Z+0 R0 FMAX M91
87 M3
88 L B+17.7131 C+206.2876 R0 FMAX
89 L X+43.351 Y-3.185 R0 FMAX
90 L Z+68.326 R0 FMAX
91 M8
92 L Z+6.326 R0 F600
93 L X+65.218 Y-0.776 F850
94 L X+63.247 Y+17.116
95 L Z+70.326 R0 FMAX
96 M9
97 M129
98 PLANE RESET STAY
99 M127
100 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
101 M9
102 L Z+0 R0 FMAX M91
103 TOOL CALL 5 Z S4200
104 L Z+0 R0 FMAX M91
105 M3
106 L B+59.3748 C+192.9554 R0 FMAX
107 L X+107.214 Y+34.141 R0 FMAX
108 L Z+111.999 R0 FMAX
109 M8
110 L Z+49.999 R0 F600
111 L X+127.618 Y+42.367 F850
112 L X+120.888 Y+59.061
113 L Z+113.999 R0 FMAX
114 M9
115 L Z+0 R0 FMAX M91
116 M5
117 M30
118 END PGM FACETS MM
