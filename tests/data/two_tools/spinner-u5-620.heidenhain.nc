0 BEGIN PGM TWO_TOOLS MM
1 ; PROGRAM TWO_TOOLS
2 ; CL FILE two_tools.cls
3 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE axes
4 ; UNITS mm, WORK OFFSET datum row 1
5 ; PART ORIGIN X0 Y0 Z0 from the table reference
6 ; PROGRAMMED POINT tool tip
7 ; ARCS AND CURVES left by at most 0.01
8 ; CL data of NX, by its own evidence
9 ; AXIS C + turns the table left-handed about +Z: word as in ISO 841
10 ; AXIS B + turns the table left-handed about +Y: word as in ISO 841
11 ; AXIS X + moves the tool along +X: word as in ISO 841
12 ; AXIS Y + moves the tool along +Y: word as in ISO 841
13 ; AXIS Z + moves the tool along +Z: word as in ISO 841
14 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
15 ; ROTARY WORDS are absolute and count on past 360: M127 is in force, the axes take no shorter way
16 ; linear limits not checked: no travel declared (X Y Z)
17 ; valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again
18 ; the entries of C and B in datum row 1 must be zero
19 ; T1 D20 R0 L120, 1 operation, tip Z -26 to 49.301
20 ; T2 D8 R0 L95, 1 operation, tip Z -3.759 to 52.623
21 ; ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point
22 ; ASSUMED work offset datum row 1
23 ; ASSUMED retract to machine coordinate 0 mm
24 ; ASSUMED approach from 50 mm along the tool axis
25 * - TILTED_FACE
26 M129
27 PLANE RESET STAY
28 M127
29 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
30 M9
31 L Z+0 R0 FMAX M91
32 TOOL CALL 1 Z S3000
33 TOOL DEF 2
34 L Z+0 R0 FMAX M91
35 M3
36 L B+30 C+0 R0 FMAX
37 L X+71.66 Y-28 R0 FMAX
38 L Z+75.096 R0 FMAX
39 M8
40 L Z+25.096 R0 F1000
41 L X+135.66 F900
42 L Y-14
43 L X+71.66
44 L Y+0
45 L X+135.66
46 L Y+14
47 L X+71.66
48 L Y+28
49 L X+135.66
50 L Z+85.096 R0 FMAX
51 M9
52 L Z+0 R0 FMAX M91
53 M5
54 M0
55 * - TILTED_SLOT
56 M129
57 PLANE RESET STAY
58 M127
59 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
60 M9
61 L Z+0 R0 FMAX M91
62 TOOL CALL 2 Z S7000
63 L Z+0 R0 FMAX M91
64 M3
65 L B+20 C-90 R0 FMAX
66 L X+70.097 Y-30 R0 FMAX
67 L Z+65.886 R0 FMAX
68 M8
69 L Z+15.887 R0 F500
70 L Y-10 Z+14.887 F350
71 L Y-30 Z+13.887
72 L Y-10 Z+12.886
73 L Y-30 Z+11.886
74 L Y-10
75 L Y-30
76 L Z+71.887 R0 FMAX
77 M9
78 L Z+0 R0 FMAX M91
79 M5
80 M30
81 END PGM TWO_TOOLS MM
