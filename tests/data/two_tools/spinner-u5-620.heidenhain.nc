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
26 ; CONDITION L and DL of the tool table are the lengths of the tools
27 ; CONDITION none of M89, M103, M109, M110, M124, M136, M138 and M144 is in force
28 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
29 ; CONDITION cycle 32 is as the machine is delivered
30 ; ASSUMED work offset preset 1
31 ; ASSUMED retract to machine coordinate 0 mm
32 ; ASSUMED approach distance 50 mm along the tool axis
33 * - TILTED_FACE
34 M129
35 PLANE RESET STAY
36 M127
37 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
38 FN 18: SYSREAD QL1 = ID210 NR1
39 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
40 ; a basic rotation lies over the preset
41 FN 14: ERROR = 102
42 LBL "OFFSET1"
43 M9
44 L Z+0 R0 FMAX M91
45 TOOL CALL 1 Z S3000
46 TOOL DEF 2
47 L Z+0 R0 FMAX M91
48 M3
49 L B+30 C+0 R0 FMAX
50 L X+71.66 Y-28 R0 FMAX
51 L Z+75.096 R0 FMAX
52 M8
53 L Z+25.096 R0 F1000
54 L X+135.66 F900
55 L Y-14
56 L X+71.66
57 L Y+0
58 L X+135.66
59 L Y+14
60 L X+71.66
61 L Y+28
62 L X+135.66
63 L Z+85.096 R0 FMAX
64 M9
65 L Z+0 R0 FMAX M91
66 M5
67 M0
68 * - TILTED_SLOT
69 M129
70 PLANE RESET STAY
71 M127
72 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
73 FN 18: SYSREAD QL1 = ID210 NR1
74 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
75 ; a basic rotation lies over the preset
76 FN 14: ERROR = 102
77 LBL "OFFSET2"
78 M9
79 L Z+0 R0 FMAX M91
80 TOOL CALL 2 Z S7000
81 TOOL DEF 1
82 L Z+0 R0 FMAX M91
83 M3
84 L B+20 C-90 R0 FMAX
85 L X+70.097 Y-30 R0 FMAX
86 L Z+65.886 R0 FMAX
87 M8
88 L Z+15.887 R0 F500
89 L Y-10 Z+14.887 F350
90 L Y-30 Z+13.887
91 L Y-10 Z+12.886
92 L Y-30 Z+11.886
93 L Y-10
94 L Y-30
95 L Z+71.887 R0 FMAX
96 M9
97 L Z+0 R0 FMAX M91
98 M5
99 M30
100 END PGM TWO_TOOLS MM
