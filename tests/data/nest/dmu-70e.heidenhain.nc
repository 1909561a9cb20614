0 BEGIN PGM NEST MM
1 BLK FORM 0.1 Z X+2.5 Y+12.5 Z-14.99
2 BLK FORM 0.2 X+85 Y+35 Z-2
3 ; PROGRAM NEST
4 ; CL FILE nest.apt
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET datum row 1
7 ; PART ORIGIN X0 Y0 Z0 from the table reference
8 ; PROGRAMMED POINT tool tip
9 ; ARCS AND CURVES in chords that leave them by at most 0.01
10 ; CL data of SolidWorks CAM, by its own evidence
11 ; 2 arcs, sense by form only, 0 arcs confirmed
12 ; CSYS changes 1 time: its points stay in one common frame
13 ; AXIS C + turns the table left-handed about +Z: word as in ISO 841
14 ; AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word as in ISO 841
15 ; AXIS X + moves the tool along +X: word as in ISO 841
16 ; AXIS Y + moves the tool along +Y: word as in ISO 841
17 ; AXIS Z + moves the tool along +Z: word as in ISO 841
18 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
19 ; ROTARY WORDS are absolute and count on past 360: M127 is in force, the axes take no shorter way
20 ; linear limits not checked: no travel declared (X Y Z)
21 ; valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again
22 ; the entries of C and B in datum row 1 must be zero
23 ; T4 D10 R0 L120, 2 operations, tip Z -14.99 to 60
24 ; ASSUMED the points of the CL data count from the part zero
25 ; ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point
26 ; ASSUMED work offset datum row 1
27 ; ASSUMED retract to machine coordinate 0 mm
28 ; ASSUMED approach from 50 mm along the tool axis
29 ; [HOLDER=H1] 10MM END MILL
30 ; Stock Size X40. Y60. Z40.
31 M129
32 PLANE RESET STAY
33 M127
34 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
35 M9
36 L Z+0 R0 FMAX M91
37 TOOL CALL 4 Z S3000
38 L Z+0 R0 FMAX M91
39 M3
40 L B+0 C+0 R0 FMAX
41 L X+12.5 Y+20 R0 FMAX
42 L Z+25 R0 FMAX
43 M8
44 L Z+3 R0 FMAX
45 L Z-2 R0 F150.5
46 L X+12.462 Y+20.434 F601.25
47 L X+12.349 Y+20.855
48 L X+12.165 Y+21.25
49 L X+11.915 Y+21.607
50 L X+11.607 Y+21.915
51 L X+11.25 Y+22.165
52 L X+10.855 Y+22.349
53 L X+10.434 Y+22.462
54 L X+10 Y+22.5
55 L X+9.566 Y+22.462
56 L X+9.145 Y+22.349
57 L X+8.75 Y+22.165
58 L X+8.393 Y+21.915
59 L X+8.085 Y+21.607
60 L X+7.835 Y+21.25
61 L X+7.651 Y+20.855
62 L X+7.538 Y+20.434
63 L X+7.5 Y+20
64 L X+7.538 Y+19.566
65 L X+7.651 Y+19.145
66 L X+7.835 Y+18.75
67 L X+8.085 Y+18.393
68 L X+8.393 Y+18.085
69 L X+8.75 Y+17.835
70 L X+9.145 Y+17.651
71 L X+9.566 Y+17.538
72 L X+10 Y+17.5
73 L X+10.434 Y+17.538
74 L X+10.855 Y+17.651
75 L X+11.25 Y+17.835
76 L X+11.607 Y+18.085
77 L X+11.915 Y+18.393
78 L X+12.165 Y+18.75
79 L X+12.349 Y+19.145
80 L X+12.462 Y+19.566
81 L X+12.5 Y+20
82 L X+10
83 L Z+60 R0 FMAX
84 L X+30 R0 FMAX
85 L Z+3 R0 FMAX
86 L Z-5 F200.05
87 L Z+3 R0 FMAX
88 L Z-4.5 R0 FMAX
89 L Z-9
90 L Z+3 R0 FMAX
91 L Z-8.5 R0 FMAX
92 L Z-12
93 L Z+25 R0 FMAX
94 M9
95 L Z+125 R0 FMAX
96 M129
97 PLANE RESET STAY
98 M127
99 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
100 M9
101 L Z+0 R0 FMAX M91
102 ; T4 stays in the spindle
103 TOOL CALL S3000
104 M3
105 L B+180 C+90 R0 FMAX
106 L X-20 Y+160 R0 FMAX
107 L Z+230 R0 FMAX
108 M8
109 L Z+195 R0 FMAX
110 L Z+188 R0 F300
111 L X-20.039 Y+160.627
112 L X-20.157 Y+161.243
113 L X-20.351 Y+161.841
114 L X-20.618 Y+162.409
115 L X-20.955 Y+162.939
116 L X-21.355 Y+163.423
117 L X-21.813 Y+163.853
118 L X-22.321 Y+164.222
119 L X-22.871 Y+164.524
120 L X-23.455 Y+164.755
121 L X-24.063 Y+164.911
122 L X-24.686 Y+164.99
123 L X-25.314
124 L X-25.937 Y+164.911
125 L X-26.545 Y+164.755
126 L X-27.129 Y+164.524
127 L X-27.679 Y+164.222
128 L X-28.187 Y+163.853
129 L X-28.645 Y+163.423
130 L X-29.045 Y+162.939
131 L X-29.382 Y+162.409
132 L X-29.649 Y+161.841
133 L X-29.843 Y+161.243
134 L X-29.961 Y+160.627
135 L X-30 Y+160
136 L Z+230
137 M9
138 L Z+330 R0 FMAX
139 L Z+0 R0 FMAX M91
140 M5
141 M30
142 END PGM NEST MM
