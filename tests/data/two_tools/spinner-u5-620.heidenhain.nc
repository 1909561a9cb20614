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
26 ; CONDITION no global program settings are active (GS)
27 ; CONDITION no preset of a pallet is added to the preset of the program
28 ; CONDITION the kinematics in force are those of this machine and head
29 ; CONDITION L and DL of the tool table are the lengths of the tools
30 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
31 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
32 ; CONDITION no cycle 32 of a program before is in force
33 ; ASSUMED work offset preset 1
34 ; ASSUMED retract to machine coordinate 0 mm
35 ; ASSUMED approach distance 50 mm along the tool axis
36 * - TILTED_FACE
37 M129
38 PLANE RESET STAY
39 M127
40 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
41 FN 18: SYSREAD QL1 = ID210 NR1
42 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
43 ; a basic rotation lies over the preset
44 FN 14: ERROR = 102
45 LBL "OFFSET1"
46 M9
47 L Z+0 R0 FMAX M91
48 TOOL CALL 1 Z S3000
49 TOOL DEF 2
50 L Z+0 R0 FMAX M91
51 M3
52 L B+30 C+0 R0 FMAX
53 L X+71.66 Y-28 R0 FMAX
54 L Z+75.096 R0 FMAX
55 M8
56 L Z+25.096 R0 F1000
57 L X+135.66 F900
58 L Y-14
59 L X+71.66
60 L Y+0
61 L X+135.66
62 L Y+14
63 L X+71.66
64 L Y+28
65 L X+135.66
66 L Z+85.096 R0 FMAX
67 M9
68 L Z+0 R0 FMAX M91
69 M5
70 M0
71 * - TILTED_SLOT
72 M129
73 PLANE RESET STAY
74 M127
75 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
76 FN 18: SYSREAD QL1 = ID210 NR1
77 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
78 ; a basic rotation lies over the preset
79 FN 14: ERROR = 102
80 LBL "OFFSET2"
81 M9
82 L Z+0 R0 FMAX M91
83 TOOL CALL 2 Z S7000
84 TOOL DEF 1
85 L Z+0 R0 FMAX M91
86 M3
87 L B+20 C-90 R0 FMAX
88 L X+70.097 Y-30 R0 FMAX
89 L Z+65.886 R0 FMAX
90 M8
91 L Z+15.887 R0 F500
92 L Y-10 Z+14.887 F350
93 L Y-30 Z+13.887
94 L Y-10 Z+12.886
95 L Y-30 Z+11.886
96 L Y-10
97 L Y-30
98 L Z+71.887 R0 FMAX
99 M9
100 L Z+0 R0 FMAX M91
101 M5
102 M30
103 END PGM TWO_TOOLS MM
