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
12 ; KINEMATICS *
13 ; DIMENSIONS d = 150 mm
14 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
15 ; AXIS B+ rotates the table left-handed about +Y, as in ISO 841
16 ; AXIS X+ moves the tool along +X, as in ISO 841
17 ; AXIS Y+ moves the tool along +Y, as in ISO 841
18 ; AXIS Z+ moves the tool along +Z, as in ISO 841
19 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
20 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
21 ; linear limits not checked: no travel declared (X Y Z)
22 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
23 ; the entries of C and B in preset 1 must be zero
24 ; T1 DIA 20 R0 L120, 1 operation, tip Z -26 to 49.301
25 ; T2 DIA 8 R0 L95, 1 operation, tip Z -3.759 to 52.623
26 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
27 ; ASSUMED work offset preset 1
28 ; ASSUMED retract to machine coordinate 0 mm
29 ; ASSUMED approach distance 50 mm along the tool axis
30 * - TILTED_FACE
31 M129
32 PLANE RESET STAY
33 M127
34 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
35 M9
36 L Z+0 R0 FMAX M91
37 TOOL CALL 1 Z S3000
38 TOOL DEF 2
39 L Z+0 R0 FMAX M91
40 M3
41 L B+30 C+0 R0 FMAX
42 L X+71.66 Y-28 R0 FMAX
43 L Z+75.096 R0 FMAX
44 M8
45 L Z+25.096 R0 F1000
46 L X+135.66 F900
47 L Y-14
48 L X+71.66
49 L Y+0
50 L X+135.66
51 L Y+14
52 L X+71.66
53 L Y+28
54 L X+135.66
55 L Z+85.096 R0 FMAX
56 M9
57 L Z+0 R0 FMAX M91
58 M5
59 M0
60 * - TILTED_SLOT
61 M129
62 PLANE RESET STAY
63 M127
64 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
65 M9
66 L Z+0 R0 FMAX M91
67 TOOL CALL 2 Z S7000
68 TOOL DEF 1
69 L Z+0 R0 FMAX M91
70 M3
71 L B+20 C-90 R0 FMAX
72 L X+70.097 Y-30 R0 FMAX
73 L Z+65.886 R0 FMAX
74 M8
75 L Z+15.887 R0 F500
76 L Y-10 Z+14.887 F350
77 L Y-30 Z+13.887
78 L Y-10 Z+12.886
79 L Y-30 Z+11.886
80 L Y-10
81 L Y-30
82 L Z+71.887 R0 FMAX
83 M9
84 L Z+0 R0 FMAX M91
85 M5
86 M30
87 END PGM TWO_TOOLS MM
