0 BEGIN PGM TWO_TOOLS MM
1 BLK FORM 0.1 Z X-34 Y-38 Z-26
2 BLK FORM 0.2 X+65.033 Y+38 Z+6
3 ; PROGRAM TWO_TOOLS
4 ; CL FILE two_tools.cls
5 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET datum row 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; CL data of NX, recognised from the file
11 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
12 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
13 ; AXIS X+ moves the tool along +X, as in ISO 841
14 ; AXIS Y+ moves the tool along +Y, as in ISO 841
15 ; AXIS Z+ moves the tool along +Z, as in ISO 841
16 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
17 ; ROTARY WORDS are absolute and go beyond 360: M127 is in force, so the axes do not take the shortest path
18 ; linear limits not checked: no travel declared (X Y Z)
19 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
20 ; the entries of C and B in datum row 1 must be zero
21 ; T1 D20 R0 L120, 1 operation, tip Z -26 to 49.301
22 ; T2 D8 R0 L95, 1 operation, tip Z -3.759 to 52.623
23 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
24 ; ASSUMED work offset datum row 1
25 ; ASSUMED retract to machine coordinate 0 mm
26 ; ASSUMED approach distance 50 mm along the tool axis
27 * - TILTED_FACE
28 M129
29 PLANE RESET STAY
30 M127
31 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
32 M9
33 L Z+0 R0 FMAX M91
34 TOOL CALL 1 Z S3000
35 TOOL DEF 2
36 L Z+0 R0 FMAX M91
37 M3
38 L B+30 C+0 R0 FMAX
39 L X+71.66 Y-28 R0 FMAX
40 L Z+75.096 R0 FMAX
41 M8
42 L Z+25.096 R0 F1000
43 L X+135.66 F900
44 L Y-14
45 L X+71.66
46 L Y+0
47 L X+135.66
48 L Y+14
49 L X+71.66
50 L Y+28
51 L X+135.66
52 L Z+85.096 R0 FMAX
53 M9
54 L Z+0 R0 FMAX M91
55 M5
56 M0
57 * - TILTED_SLOT
58 M129
59 PLANE RESET STAY
60 M127
61 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
62 M9
63 L Z+0 R0 FMAX M91
64 TOOL CALL 2 Z S7000
65 L Z+0 R0 FMAX M91
66 M3
67 L B+20 C-90 R0 FMAX
68 L X+70.097 Y-30 R0 FMAX
69 L Z+65.886 R0 FMAX
70 M8
71 L Z+15.887 R0 F500
72 L Y-10 Z+14.887 F350
73 L Y-30 Z+13.887
74 L Y-10 Z+12.886
75 L Y-30 Z+11.886
76 L Y-10
77 L Y-30
78 L Z+71.887 R0 FMAX
79 M9
80 L Z+0 R0 FMAX M91
81 M5
82 M30
83 END PGM TWO_TOOLS MM
