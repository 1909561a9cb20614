0 BEGIN PGM PLATE INCH
1 ; PROGRAM PLATE
2 ; CL FILE plate.ncl
3 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
4 ; UNITS in, WORK OFFSET datum row 1
5 ; PART ORIGIN X0 Y0 Z0 from the table reference
6 ; PROGRAMMED POINT tool tip
7 ; ARCS AND CURVES left by at most 0.001
8 ; CL data of Creo, by its own evidence
9 ; 1 arc, 1 of 1 decided arcs agree with their form
10 ; AXIS C + turns the table left-handed about +Z: word as in ISO 841
11 ; AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word as in ISO 841
12 ; AXIS X + moves the tool along +X: word as in ISO 841
13 ; AXIS Y + moves the tool along +Y: word as in ISO 841
14 ; AXIS Z + moves the tool along +Z: word as in ISO 841
15 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.001 of its line at feed, the tool axis within 0.1 deg
16 ; ROTARY WORDS are absolute and count on past 360: M127 is in force, the axes take no shorter way
17 ; linear limits not checked: no travel declared (X Y Z)
18 ; valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again
19 ; the entries of C and B in datum row 1 must be zero
20 ; T3 D0.25 L4, 1 operation, tip Z -0.4 to 1
21 ; ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point
22 ; ASSUMED work offset datum row 1
23 ; ASSUMED retract to machine coordinate 0 mm
24 ; ASSUMED approach from 50 mm along the tool axis
25 M129
26 PLANE RESET STAY
27 M127
28 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
29 M9
30 L Z+0 R0 FMAX M91
31 TOOL CALL 3 Z S3000
32 L Z+0 R0 FMAX M91
33 M3
34 L B+0 C+0 R0 FMAX
35 L X+0 Y+0.5 R0 FMAX
36 L Z+1 R0 FMAX
37 L Z-0.1 R0 F200
38 L X+1
39 CC X+1 Y+0.25
40 C X+1 Y+0 DR-
41 L X+0
42 L Y-0.25
43 L Z+1
44 L X+0.25 Y+0.25 R0 FMAX
45 L Z+0.1 R0 FMAX
46 L Z-0.15 F40
47 L Z-0.1303 R0 FMAX
48 L Z-0.3
49 L Z-0.2803 R0 FMAX
50 L Z-0.4
51 L Z+0.5 R0 FMAX
52 L X+0.75 R0 FMAX
53 L Z+0.1 R0 FMAX
54 L Z-0.15
55 L Z-0.1303 R0 FMAX
56 L Z-0.3
57 L Z-0.2803 R0 FMAX
58 L Z-0.4
59 L Z+0.5 R0 FMAX
60 L Z+1 R0 FMAX
61 L Z+3 R0 FMAX
62 L Z+0 R0 FMAX M91
63 M5
64 M30
65 END PGM PLATE INCH
