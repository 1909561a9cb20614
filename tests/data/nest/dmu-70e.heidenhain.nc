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
27 ; CONDITION no global program settings are active (GS)
28 ; CONDITION no preset of a pallet is added to the preset of the program
29 ; CONDITION the kinematics in force are those of this machine and head
30 ; CONDITION L and DL of the tool table are the lengths of the tools
31 ; CONDITION none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force
32 ; CONDITION the columns X_OFFS to W_OFFS of the preset are 0
33 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
34 ; CONDITION no cycle 32 of a program before is in force
35 ; ASSUMED points of the CL data are coordinates from the part zero
36 ; ASSUMED work offset preset 1
37 ; ASSUMED retract to machine coordinate 0 mm
38 ; ASSUMED approach distance 50 mm along the tool axis
39 ; [HOLDER=H1] 10MM END MILL
40 M129
41 PLANE RESET STAY
42 M127
43 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
44 FN 18: SYSREAD QL1 = ID210 NR1
45 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
46 ; a basic rotation lies over the preset
47 FN 14: ERROR = 102
48 LBL "OFFSET1"
49 M9
50 L Z+0 R0 FMAX M91
51 TOOL CALL 4 Z S3000
52 L Z+0 R0 FMAX M91
53 ; Stock Size X40. Y60. Z40.
54 M3
55 L B+0 C+0 R0 FMAX
56 L X+12.5 Y+20 R0 FMAX
57 L Z+25 R0 FMAX
58 M8
59 L Z+3 R0 FMAX
60 L Z-2 R0 F150.5
61 CC X+10 Y+20
62 C X+12.5 Y+20 DR+ F601.25
63 L X+10
64 L Z+60 R0 FMAX
65 L X+30 R0 FMAX
66 L Z+3 R0 FMAX
67 L Z-5 F200.05
68 L Z+3 R0 FMAX
69 L Z-4.5 R0 FMAX
70 L Z-9
71 L Z+3 R0 FMAX
72 L Z-8.5 R0 FMAX
73 L Z-12
74 L Z+25 R0 FMAX
75 M9
76 L Z+125 R0 FMAX
77 M129
78 PLANE RESET STAY
79 M127
80 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
81 FN 18: SYSREAD QL1 = ID210 NR1
82 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
83 ; a basic rotation lies over the preset
84 FN 14: ERROR = 102
85 LBL "OFFSET2"
86 M9
87 L Z+0 R0 FMAX M91
88 ; T4 stays in the spindle
89 TOOL CALL S3000
90 M3
91 L B+180 C+90 R0 FMAX
92 L X-20 Y+160 R0 FMAX
93 L Z+230 R0 FMAX
94 M8
95 L Z+195 R0 FMAX
96 L Z+188 R0 F300
97 CC X-25 Y+160
98 C X-30 Y+160 DR+
99 L Z+230
100 M9
101 L Z+330 R0 FMAX
102 L Z+0 R0 FMAX M91
103 M5
104 M30
105 END PGM NEST MM
