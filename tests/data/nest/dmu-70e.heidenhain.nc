0 BEGIN PGM NEST MM
1 BLK FORM 0.1 Z X+2.5 Y+12.5 Z-15
2 BLK FORM 0.2 X+85 Y+35 Z+0
3 ; PROGRAM NEST
4 ; CL FILE nest.apt
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of SolidWorks CAM, recognised from the file
12 ; 2 arcs, sense by form, not confirmed by a neighbouring line
13 ; CSYS changes 1 time: all points are read in one common frame
14 ; KINEMATICS *
15 ; DIMENSIONS d = 150 mm
16 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
17 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
18 ; AXIS X+ moves the tool along +X, as in ISO 841
19 ; AXIS Y+ moves the tool along +Y, as in ISO 841
20 ; AXIS Z+ moves the tool along +Z, as in ISO 841
21 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
22 ; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
23 ; linear limits not checked: no travel declared (X Y Z)
24 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
25 ; the entries of C and B in preset 1 must be zero
26 ; T4 DIA 10 R0 L120, 2 operations, tip Z -15 to 60
27 ; CONDITION L and DL of the tool table are the lengths of the tools
28 ; CONDITION none of M89, M103, M109, M110, M124, M136, M138 and M144 is in force
29 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
30 ; CONDITION cycle 32 is as the machine is delivered
31 ; ASSUMED points of the CL data are coordinates from the part zero
32 ; ASSUMED work offset preset 1
33 ; ASSUMED retract to machine coordinate 0 mm
34 ; ASSUMED approach distance 50 mm along the tool axis
35 ; [HOLDER=H1] 10MM END MILL
36 M129
37 PLANE RESET STAY
38 M127
39 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
40 FN 18: SYSREAD QL1 = ID210 NR1
41 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
42 ; a basic rotation lies over the preset
43 FN 14: ERROR = 102
44 LBL "OFFSET1"
45 M9
46 L Z+0 R0 FMAX M91
47 TOOL CALL 4 Z S3000
48 L Z+0 R0 FMAX M91
49 ; Stock Size X40. Y60. Z40.
50 M3
51 L B+0 C+0 R0 FMAX
52 L X+12.5 Y+20 R0 FMAX
53 L Z+25 R0 FMAX
54 M8
55 L Z+3 R0 FMAX
56 L Z-2 R0 F150.5
57 CC X+10 Y+20
58 C X+12.5 Y+20 DR+ F601.25
59 L X+10
60 L Z+60 R0 FMAX
61 L X+30 R0 FMAX
62 L Z+3 R0 FMAX
63 L Z-5 F200.05
64 L Z+3 R0 FMAX
65 L Z-4.5 R0 FMAX
66 L Z-9
67 L Z+3 R0 FMAX
68 L Z-8.5 R0 FMAX
69 L Z-12
70 L Z+25 R0 FMAX
71 M9
72 L Z+125 R0 FMAX
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
84 ; T4 stays in the spindle
85 TOOL CALL S3000
86 M3
87 L B+180 C+90 R0 FMAX
88 L X-20 Y+160 R0 FMAX
89 L Z+230 R0 FMAX
90 M8
91 L Z+195 R0 FMAX
92 L Z+188 R0 F300
93 CC X-25 Y+160
94 C X-30 Y+160 DR+
95 L Z+230
96 M9
97 L Z+330 R0 FMAX
98 L Z+0 R0 FMAX M91
99 M5
100 M30
101 END PGM NEST MM
