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
32 ; CONDITION the preset has no 3-D basic rotation (SPA, SPB, SPC)
33 ; CONDITION no cycle 32 of a program before is in force
34 ; ASSUMED points of the CL data are coordinates from the part zero
35 ; ASSUMED work offset preset 1
36 ; ASSUMED retract to machine coordinate 0 mm
37 ; ASSUMED approach distance 50 mm along the tool axis
38 ; [HOLDER=H1] 10MM END MILL
39 M129
40 PLANE RESET STAY
41 M127
42 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
43 FN 18: SYSREAD QL1 = ID210 NR1
44 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
45 ; a basic rotation lies over the preset
46 FN 14: ERROR = 102
47 LBL "OFFSET1"
48 M9
49 L Z+0 R0 FMAX M91
50 TOOL CALL 4 Z S3000
51 L Z+0 R0 FMAX M91
52 ; Stock Size X40. Y60. Z40.
53 M3
54 L B+0 C+0 R0 FMAX
55 L X+12.5 Y+20 R0 FMAX
56 L Z+25 R0 FMAX
57 M8
58 L Z+3 R0 FMAX
59 L Z-2 R0 F150.5
60 CC X+10 Y+20
61 C X+12.5 Y+20 DR+ F601.25
62 L X+10
63 L Z+60 R0 FMAX
64 L X+30 R0 FMAX
65 L Z+3 R0 FMAX
66 L Z-5 F200.05
67 L Z+3 R0 FMAX
68 L Z-4.5 R0 FMAX
69 L Z-9
70 L Z+3 R0 FMAX
71 L Z-8.5 R0 FMAX
72 L Z-12
73 L Z+25 R0 FMAX
74 M9
75 L Z+125 R0 FMAX
76 M129
77 PLANE RESET STAY
78 M127
79 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
80 FN 18: SYSREAD QL1 = ID210 NR1
81 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET2"
82 ; a basic rotation lies over the preset
83 FN 14: ERROR = 102
84 LBL "OFFSET2"
85 M9
86 L Z+0 R0 FMAX M91
87 ; T4 stays in the spindle
88 TOOL CALL S3000
89 M3
90 L B+180 C+90 R0 FMAX
91 L X-20 Y+160 R0 FMAX
92 L Z+230 R0 FMAX
93 M8
94 L Z+195 R0 FMAX
95 L Z+188 R0 F300
96 CC X-25 Y+160
97 C X-30 Y+160 DR+
98 L Z+230
99 M9
100 L Z+330 R0 FMAX
101 L Z+0 R0 FMAX M91
102 M5
103 M30
104 END PGM NEST MM
