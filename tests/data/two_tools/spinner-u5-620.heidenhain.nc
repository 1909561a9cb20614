0 BEGIN PGM TWO_TOOLS MM
1 BLK FORM 0.1 Z X-34 Y-38 Z-26
2 BLK FORM 0.2 X+65.033 Y+38 Z+6
3 ; PROGRAM TWO_TOOLS
4 ; CL FILE two_tools.cls
5 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of NX, recognised from the file
12 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
13 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
14 ; AXIS X+ moves the tool along +X, as in ISO 841
15 ; AXIS Y+ moves the tool along +Y, as in ISO 841
16 ; AXIS Z+ moves the tool along +Z, as in ISO 841
17 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
18 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
19 ; linear limits not checked: no travel declared (X Y Z)
20 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
21 ; the entries of C and B in preset 1 must be zero
22 ; T1 DIA 20 R0 L120, 1 operation, tip Z -26 to 49.301
23 ; T2 DIA 8 R0 L95, 1 operation, tip Z -3.759 to 52.623
24 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
25 ; ASSUMED work offset preset 1
26 ; ASSUMED retract to machine coordinate 0 mm
27 ; ASSUMED approach distance 50 mm along the tool axis
28 * - TILTED_FACE
29 M129
30 PLANE RESET STAY
31 M127
32 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
33 M9
34 L Z+0 R0 FMAX M91
35 TOOL CALL 1 Z S3000
36 TOOL DEF 2
37 L Z+0 R0 FMAX M91
38 M3
39 L B+30 C+0 R0 FMAX
40 L X+71.66 Y-28 R0 FMAX
41 L Z+75.096 R0 FMAX
42 M8
43 L Z+25.096 R0 F1000
44 L X+135.66 F900
45 L Y-14
46 L X+71.66
47 L Y+0
48 L X+135.66
49 L Y+14
50 L X+71.66
51 L Y+28
52 L X+135.66
53 L Z+85.096 R0 FMAX
54 M9
55 L Z+0 R0 FMAX M91
56 M5
57 M0
58 * - TILTED_SLOT
59 M129
60 PLANE RESET STAY
61 M127
62 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
63 M9
64 L Z+0 R0 FMAX M91
65 TOOL CALL 2 Z S7000
66 TOOL DEF 1
67 L Z+0 R0 FMAX M91
68 M3
69 L B+20 C-90 R0 FMAX
70 L X+70.097 Y-30 R0 FMAX
71 L Z+65.886 R0 FMAX
72 M8
73 L Z+15.887 R0 F500
74 L Y-10 Z+14.887 F350
75 L Y-30 Z+13.887
76 L Y-10 Z+12.886
77 L Y-30 Z+11.886
78 L Y-10
79 L Y-30
80 L Z+71.887 R0 FMAX
81 M9
82 L Z+0 R0 FMAX M91
83 M5
84 M30
85 END PGM TWO_TOOLS MM
