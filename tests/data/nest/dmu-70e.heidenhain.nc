0 BEGIN PGM NEST MM
1 ; PROGRAM NEST
2 ; CL FILE nest.apt
3 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
4 ; UNITS mm, WORK OFFSET datum row 1
5 ; PART ORIGIN X0 Y0 Z0 from the table reference
6 ; PROGRAMMED POINT tool tip
7 ; ARCS AND CURVES in chords that leave them by at most 0.01
8 ; CL data of SolidWorks CAM, by its own evidence
9 ; 2 arcs, sense by form only, 0 arcs confirmed
10 ; CSYS changes 1 time: its points stay in one common frame
11 ; AXIS C + turns the table left-handed about +Z: word as in ISO 841
12 ; AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word as in ISO 841
13 ; AXIS X + moves the tool along +X: word as in ISO 841
14 ; AXIS Y + moves the tool along +Y: word as in ISO 841
15 ; AXIS Z + moves the tool along +Z: word as in ISO 841
16 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
17 ; ROTARY WORDS are absolute and count on past 360: M127 is in force, the axes take no shorter way
18 ; linear limits not checked: no travel declared (X Y Z)
19 ; valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again
20 ; the entries of C and B in datum row 1 must be zero
21 ; T4 D10 R0 L120, 2 operations, tip Z -14.99 to 60
22 ; ASSUMED the points of the CL data count from the part zero
23 ; ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point
24 ; ASSUMED work offset datum row 1
25 ; ASSUMED retract to machine coordinate 0 mm
26 ; ASSUMED approach from 50 mm along the tool axis
27 ; [HOLDER=H1] 10MM END MILL
28 ; Stock Size X40. Y60. Z40.
29 M129
30 PLANE RESET STAY
31 M127
32 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
33 M9
34 L Z+0 R0 FMAX M91
35 TOOL CALL 4 Z S3000
36 L Z+0 R0 FMAX M91
37 M3
38 L B+0 C+0 R0 FMAX
39 L X+12.5 Y+20 R0 FMAX
40 L Z+25 R0 FMAX
41 M8
42 L Z+3 R0 FMAX
43 L Z-2 R0 F150.5
44 L X+12.462 Y+20.434 F601.25
45 L X+12.349 Y+20.855
46 L X+12.165 Y+21.25
47 L X+11.915 Y+21.607
48 L X+11.607 Y+21.915
49 L X+11.25 Y+22.165
50 L X+10.855 Y+22.349
51 L X+10.434 Y+22.462
52 L X+10 Y+22.5
53 L X+9.566 Y+22.462
54 L X+9.145 Y+22.349
55 L X+8.75 Y+22.165
56 L X+8.393 Y+21.915
57 L X+8.085 Y+21.607
58 L X+7.835 Y+21.25
59 L X+7.651 Y+20.855
60 L X+7.538 Y+20.434
61 L X+7.5 Y+20
62 L X+7.538 Y+19.566
63 L X+7.651 Y+19.145
64 L X+7.835 Y+18.75
65 L X+8.085 Y+18.393
66 L X+8.393 Y+18.085
67 L X+8.75 Y+17.835
68 L X+9.145 Y+17.651
69 L X+9.566 Y+17.538
70 L X+10 Y+17.5
71 L X+10.434 Y+17.538
72 L X+10.855 Y+17.651
73 L X+11.25 Y+17.835
74 L X+11.607 Y+18.085
75 L X+11.915 Y+18.393
76 L X+12.165 Y+18.75
77 L X+12.349 Y+19.145
78 L X+12.462 Y+19.566
79 L X+12.5 Y+20
80 L X+10
81 L Z+60 R0 FMAX
82 L X+30 R0 FMAX
83 L Z+3 R0 FMAX
84 L Z-5 F200.05
85 L Z+3 R0 FMAX
86 L Z-4.5 R0 FMAX
87 L Z-9
88 L Z+3 R0 FMAX
89 L Z-8.5 R0 FMAX
90 L Z-12
91 L Z+25 R0 FMAX
92 M9
93 L Z+125 R0 FMAX
94 M129
95 PLANE RESET STAY
96 M127
97 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
98 M9
99 L Z+0 R0 FMAX M91
100 ; T4 stays in the spindle
101 TOOL CALL S3000
102 M3
103 L B+180 C+90 R0 FMAX
104 L X-20 Y+160 R0 FMAX
105 L Z+230 R0 FMAX
106 M8
107 L Z+195 R0 FMAX
108 L Z+188 R0 F300
109 L X-20.039 Y+160.627
110 L X-20.157 Y+161.243
111 L X-20.351 Y+161.841
112 L X-20.618 Y+162.409
113 L X-20.955 Y+162.939
114 L X-21.355 Y+163.423
115 L X-21.813 Y+163.853
116 L X-22.321 Y+164.222
117 L X-22.871 Y+164.524
118 L X-23.455 Y+164.755
119 L X-24.063 Y+164.911
120 L X-24.686 Y+164.99
121 L X-25.314
122 L X-25.937 Y+164.911
123 L X-26.545 Y+164.755
124 L X-27.129 Y+164.524
125 L X-27.679 Y+164.222
126 L X-28.187 Y+163.853
127 L X-28.645 Y+163.423
128 L X-29.045 Y+162.939
129 L X-29.382 Y+162.409
130 L X-29.649 Y+161.841
131 L X-29.843 Y+161.243
132 L X-29.961 Y+160.627
133 L X-30 Y+160
134 L Z+230
135 M9
136 L Z+330 R0 FMAX
137 L Z+0 R0 FMAX M91
138 M5
139 M30
140 END PGM NEST MM
