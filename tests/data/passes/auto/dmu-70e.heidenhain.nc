0 BEGIN PGM NONAME MM
1 BLK FORM 0.1 Z X+20.271 Y-4 Z+3
2 BLK FORM 0.2 X+34 Y+21.634 Z+5
3 ; PROGRAM without name
4 ; CL FILE passes.cls
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE auto (tcp)
6 ; UNITS mm, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z50 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of NX, recognised from the file
12 ; KINEMATICS *
13 ; DIMENSIONS d = 150 mm
14 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
15 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
16 ; AXIS X+ moves the tool along +X, as in ISO 841
17 ; AXIS Y+ moves the tool along +Y, as in ISO 841
18 ; AXIS Z+ moves the tool along +Z, as in ISO 841
19 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle
20 ; ROTARY WORDS of C are absolute and may go below 0 or beyond 360: M127 is in force, so the axes do not take the shortest path
21 ; LINEAR WORDS are tip coordinates in a frame fixed to the table, aligned with the machine axes when its rotary axes are at zero; rotary axes move evenly
22 ; linear limits not checked: no travel declared (X Y Z)
23 ; the entries of C and B in preset 1 must be zero
24 ; T4 ball 8 DIA 8 L130, 1 operation, tip Z 3 to 23.126
25 ; CONDITION FUNCTION TCPM is off at each start, after a stop as well: M129 may not end it
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
37 ; ASSUMED all axes of a rapid arrive together, as the control is delivered
38 * - PASSES
39 M129
40 PLANE RESET STAY
41 M127
42 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
43 FUNCTION RESET TCPM
44 FN 18: SYSREAD QL1 = ID210 NR1
45 FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"
46 ; a basic rotation lies over the preset
47 FN 14: ERROR = 102
48 LBL "OFFSET1"
49 M9
50 L Z+0 R0 FMAX M91
51 ; T4 ball 8
52 TOOL CALL 4 Z S8000
53 L Z+0 R0 FMAX M91
54 M3
55 L B+35.6477 C+12.8086 R0 FMAX
56 PLANE SPATIAL SPA+0 SPB+25 SPC+0 TURN MB MAX FMAX SEQ+ COORD ROT
57 FN 20: WAIT FOR SYNC
58 FN 18: SYSREAD QL1 = ID270 NR1 IDX5
59 FN 18: SYSREAD QL2 = ID270 NR1 IDX6
60 QL3 = ABS ( SIN ( ( QL1 - 35.6477 ) / 2 ) ) + ABS ( SIN ( ( QL2 - 12.8086 ) / 2 ) )
61 FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"
62 ; after the plane call the axes are not at B35.6477 C12.8086
63 FN 14: ERROR = 101
64 LBL "PLANE1"
65 L X+25.076 Y+0 R0 FMAX
66 PLANE RESET STAY
67 L B+35.6477 C+12.8086 R0 FMAX
68 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
69 L X+38.452 Y+0 Z+23.126 R0 FMAX
70 M8
71 L X+30 Z+5 B+35.6477 C+12.8086 R0 F600
72 L X+29.672 Y+3.119 B+36.9199 C+19.4968 F1200
73 L X+29.344 Y+6.237 B+38.5547 C+25.8912
74 L X+28.375 Y+9.22 B+39.8233 C+32.5641
75 L X+27.406 Y+12.202 B+41.4755 C+38.9881
76 L X+25.838 Y+14.918 B+42.7419 C+45.6487
77 L X+24.271 Y+17.634 B+44.4114 C+52.1006
78 L X+32.604 Y+23.688 Z+22.143 R0 FMAX
79 L X+34.223 Y+17.766 Z+22.063 B+41.6766 C+43.0701 R0 FMAX
80 L X+35.842 Y+11.844 Z+21.982 B+39.7245 C+33.502 R0 FMAX
81 L X+37.461 Y+5.922 Z+21.901 B+38.6615 C+23.6481 R0 FMAX
82 L X+39.08 Y+0 Z+21.82 B+38.5547 C+13.8912 R0 FMAX
83 L X+30 Z+4 F600
84 L X+29.672 Y+3.119 B+39.8233 C+20.5641 F1200
85 L X+29.344 Y+6.237 B+41.4754 C+26.9881
86 L X+28.375 Y+9.22 B+42.7419 C+33.6488
87 L X+27.406 Y+12.202 B+44.4113 C+40.1006
88 L X+25.838 Y+14.918 B+45.677 C+46.7518
89 L X+24.271 Y+17.634 B+47.3638 C+53.2303
90 L X+33.083 Y+24.036 Z+20.773 R0 FMAX
91 L X+34.736 Y+18.027 Z+20.703 B+44.5554 C+44.0928 R0 FMAX
92 L X+36.39 Y+12.018 Z+20.633 B+42.575 C+34.4853 R0 FMAX
93 L X+38.043 Y+6.009 Z+20.563 B+41.5271 C+24.6605 R0 FMAX
94 L X+39.696 Y+0 Z+20.492 B+41.4755 C+14.9881 R0 FMAX
95 L X+30 Z+3 F600
96 L X+29.672 Y+3.119 B+42.7419 C+21.6487 F1200
97 L X+29.344 Y+6.237 B+44.4113 C+28.1005
98 L X+28.375 Y+9.22 B+45.677 C+34.7517
99 L X+27.406 Y+12.202 B+47.3638 C+41.2303
100 L X+25.838 Y+14.918 B+48.6305 C+47.8744
101 L X+24.271 Y+17.634 B+50.3345 C+54.3789
102 L X+33.551 Y+24.376 Z+19.383 R0 FMAX
103 M9
104 L X+45.23 Y+32.862 Z+40 R0 FMAX
105 FUNCTION RESET TCPM
106 L Z+0 R0 FMAX M91
107 M5
108 M30
109 END PGM NONAME MM
