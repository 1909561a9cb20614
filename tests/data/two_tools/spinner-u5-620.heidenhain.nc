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
31 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
32 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
33 ; CONDITION no cycle 32 of a program before is in force
34 ; ASSUMED work offset preset 1
35 ; ASSUMED retract to machine coordinate 0 mm
36 ; ASSUMED approach distance 50 mm along the tool axis
37 * - TILTED_FACE
38 M129
39 PLANE RESET STAY
40 M127
41 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
42 FN 18: SYSREAD QL1 = ID210 NR1
43 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
44 ; a basic rotation lies over the preset
45 FN 14: ERROR = 102
46 LBL "OFFSET1"
47 M9
48 L Z+0 R0 FMAX M91
49 TOOL CALL 1 Z S3000
50 TOOL DEF 2
51 L Z+0 R0 FMAX M91
52 M3
53 L B+30 C+0 R0 FMAX
54 L X+71.66 Y-28 R0 FMAX
55 L Z+75.096 R0 FMAX
56 M8
57 L Z+25.096 R0 F1000
58 L X+135.66 F900
59 L Y-14
60 L X+71.66
61 L Y+0
62 L X+135.66
63 L Y+14
64 L X+71.66
65 L Y+28
66 L X+135.66
67 L Z+85.096 R0 FMAX
68 M9
69 L Z+0 R0 FMAX M91
70 M5
71 M0
72 * - TILTED_SLOT
73 M129
74 PLANE RESET STAY
75 M127
76 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
77 FN 18: SYSREAD QL1 = ID210 NR1
78 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
79 ; a basic rotation lies over the preset
80 FN 14: ERROR = 102
81 LBL "OFFSET2"
82 M9
83 L Z+0 R0 FMAX M91
84 TOOL CALL 2 Z S7000
85 TOOL DEF 1
86 L Z+0 R0 FMAX M91
87 M3
88 L B+20 C-90 R0 FMAX
89 L X+70.097 Y-30 R0 FMAX
90 L Z+65.886 R0 FMAX
91 M8
92 L Z+15.887 R0 F500
93 L Y-10 Z+14.887 F350
94 L Y-30 Z+13.887
95 L Y-10 Z+12.886
96 L Y-30 Z+11.886
97 L Y-10
98 L Y-30
99 L Z+71.887 R0 FMAX
100 M9
101 L Z+0 R0 FMAX M91
102 M5
103 M30
104 END PGM TWO_TOOLS MM
