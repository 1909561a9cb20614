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
20 ; ROTARY WORDS are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
21 ; linear limits not checked: no travel declared (X Y Z)
22 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
23 ; the entries of C and B in preset 1 must be zero
24 ; T1 DIA 20 R0 L120, 1 operation, tip Z -26 to 49.301
25 ; T2 DIA 8 R0 L95, 1 operation, tip Z -3.759 to 52.623
26 ; ASSUMED work offset preset 1
27 ; ASSUMED retract to machine coordinate 0 mm
28 ; ASSUMED approach distance 50 mm along the tool axis
29 * - TILTED_FACE
30 M129
31 PLANE RESET STAY
32 M127
33 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
34 M9
35 L Z+0 R0 FMAX M91
36 TOOL CALL 1 Z S3000
37 TOOL DEF 2
38 L Z+0 R0 FMAX M91
39 M3
40 L B+30 C+0 R0 FMAX
41 L X+71.66 Y-28 R0 FMAX
42 L Z+75.096 R0 FMAX
43 M8
44 L Z+25.096 R0 F1000
45 L X+135.66 F900
46 L Y-14
47 L X+71.66
48 L Y+0
49 L X+135.66
50 L Y+14
51 L X+71.66
52 L Y+28
53 L X+135.66
54 L Z+85.096 R0 FMAX
55 M9
56 L Z+0 R0 FMAX M91
57 M5
58 M0
59 * - TILTED_SLOT
60 M129
61 PLANE RESET STAY
62 M127
63 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
64 M9
65 L Z+0 R0 FMAX M91
66 TOOL CALL 2 Z S7000
67 TOOL DEF 1
68 L Z+0 R0 FMAX M91
69 M3
70 L B+20 C-90 R0 FMAX
71 L X+70.097 Y-30 R0 FMAX
72 L Z+65.886 R0 FMAX
73 M8
74 L Z+15.887 R0 F500
75 L Y-10 Z+14.887 F350
76 L Y-30 Z+13.887
77 L Y-10 Z+12.886
78 L Y-30 Z+11.886
79 L Y-10
80 L Y-30
81 L Z+71.887 R0 FMAX
82 M9
83 L Z+0 R0 FMAX M91
84 M5
85 M30
86 END PGM TWO_TOOLS MM
