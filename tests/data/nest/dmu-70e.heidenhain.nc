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
27 ; ASSUMED points of the CL data are coordinates from the part zero
28 ; ASSUMED work offset preset 1
29 ; ASSUMED retract to machine coordinate 0 mm
30 ; ASSUMED approach distance 50 mm along the tool axis
31 ; [HOLDER=H1] 10MM END MILL
32 M129
33 PLANE RESET STAY
34 M127
35 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
36 M9
37 L Z+0 R0 FMAX M91
38 TOOL CALL 4 Z S3000
39 L Z+0 R0 FMAX M91
40 ; Stock Size X40. Y60. Z40.
41 M3
42 L B+0 C+0 R0 FMAX
43 L X+12.5 Y+20 R0 FMAX
44 L Z+25 R0 FMAX
45 M8
46 L Z+3 R0 FMAX
47 L Z-2 R0 F150.5
48 CC X+10 Y+20
49 C X+12.5 Y+20 DR+ F601.25
50 L X+10
51 L Z+60 R0 FMAX
52 L X+30 R0 FMAX
53 L Z+3 R0 FMAX
54 L Z-5 F200.05
55 L Z+3 R0 FMAX
56 L Z-4.5 R0 FMAX
57 L Z-9
58 L Z+3 R0 FMAX
59 L Z-8.5 R0 FMAX
60 L Z-12
61 L Z+25 R0 FMAX
62 M9
63 L Z+125 R0 FMAX
64 M129
65 PLANE RESET STAY
66 M127
67 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
68 M9
69 L Z+0 R0 FMAX M91
70 ; T4 stays in the spindle
71 TOOL CALL S3000
72 M3
73 L B+180 C+90 R0 FMAX
74 L X-20 Y+160 R0 FMAX
75 L Z+230 R0 FMAX
76 M8
77 L Z+195 R0 FMAX
78 L Z+188 R0 F300
79 CC X-25 Y+160
80 C X-30 Y+160 DR+
81 L Z+230
82 M9
83 L Z+330 R0 FMAX
84 L Z+0 R0 FMAX M91
85 M5
86 M30
87 END PGM NEST MM
