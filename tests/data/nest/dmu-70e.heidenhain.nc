0 BEGIN PGM NEST MM
1 ; PROGRAM NEST
2 ; CL FILE nest.apt
3 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
4 ; UNITS mm, WORK OFFSET datum row 1
5 ; PART ORIGIN X0 Y0 Z0 from the table reference
6 ; PROGRAMMED POINT tool tip
7 ; ARCS AND CURVES left by at most 0.01
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
21 ; T4 D10 R0 L120, 2 operations, tip Z -15 to 60
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
44 CC X+10 Y+20
45 C X+12.5 Y+20 DR+ F601.25
46 L X+10
47 L Z+60 R0 FMAX
48 L X+30 R0 FMAX
49 L Z+3 R0 FMAX
50 L Z-5 F200.05
51 L Z+3 R0 FMAX
52 L Z-4.5 R0 FMAX
53 L Z-9
54 L Z+3 R0 FMAX
55 L Z-8.5 R0 FMAX
56 L Z-12
57 L Z+25 R0 FMAX
58 M9
59 L Z+125 R0 FMAX
60 M129
61 PLANE RESET STAY
62 M127
63 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
64 M9
65 L Z+0 R0 FMAX M91
66 ; T4 stays in the spindle
67 TOOL CALL S3000
68 M3
69 L B+180 C+90 R0 FMAX
70 L X-20 Y+160 R0 FMAX
71 L Z+230 R0 FMAX
72 M8
73 L Z+195 R0 FMAX
74 L Z+188 R0 F300
75 CC X-25 Y+160
76 C X-30 Y+160 DR+
77 L Z+230
78 M9
79 L Z+330 R0 FMAX
80 L Z+0 R0 FMAX M91
81 M5
82 M30
83 END PGM NEST MM
