0 BEGIN PGM NEST MM
1 BLK FORM 0.1 Z X+2.5 Y+12.5 Z-15
2 BLK FORM 0.2 X+85 Y+35 Z+0
3 ; PROGRAM NEST
4 ; CL FILE nest.apt
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET datum row 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.01 for arcs and curves
10 ; CL data of SolidWorks CAM, recognised from the file
11 ; 2 arcs, sense by form, not confirmed by a neighbouring line
12 ; CSYS changes 1 time: all points are read in one common frame
13 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
14 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
15 ; AXIS X+ moves the tool along +X, as in ISO 841
16 ; AXIS Y+ moves the tool along +Y, as in ISO 841
17 ; AXIS Z+ moves the tool along +Z, as in ISO 841
18 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
19 ; ROTARY WORDS are absolute and go beyond 360: M127 is in force, so the axes do not take the shortest path
20 ; linear limits not checked: no travel declared (X Y Z)
21 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
22 ; the entries of C and B in datum row 1 must be zero
23 ; T4 D10 R0 L120, 2 operations, tip Z -15 to 60
24 ; ASSUMED points of the CL data are coordinates from the part zero
25 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
26 ; ASSUMED work offset datum row 1
27 ; ASSUMED retract to machine coordinate 0 mm
28 ; ASSUMED approach distance 50 mm along the tool axis
29 ; [HOLDER=H1] 10MM END MILL
30 ; Stock Size X40. Y60. Z40.
31 M129
32 PLANE RESET STAY
33 M127
34 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
35 M9
36 L Z+0 R0 FMAX M91
37 TOOL CALL 4 Z S3000
38 L Z+0 R0 FMAX M91
39 M3
40 L B+0 C+0 R0 FMAX
41 L X+12.5 Y+20 R0 FMAX
42 L Z+25 R0 FMAX
43 M8
44 L Z+3 R0 FMAX
45 L Z-2 R0 F150.5
46 CC X+10 Y+20
47 C X+12.5 Y+20 DR+ F601.25
48 L X+10
49 L Z+60 R0 FMAX
50 L X+30 R0 FMAX
51 L Z+3 R0 FMAX
52 L Z-5 F200.05
53 L Z+3 R0 FMAX
54 L Z-4.5 R0 FMAX
55 L Z-9
56 L Z+3 R0 FMAX
57 L Z-8.5 R0 FMAX
58 L Z-12
59 L Z+25 R0 FMAX
60 M9
61 L Z+125 R0 FMAX
62 M129
63 PLANE RESET STAY
64 M127
65 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
66 M9
67 L Z+0 R0 FMAX M91
68 ; T4 stays in the spindle
69 TOOL CALL S3000
70 M3
71 L B+180 C+90 R0 FMAX
72 L X-20 Y+160 R0 FMAX
73 L Z+230 R0 FMAX
74 M8
75 L Z+195 R0 FMAX
76 L Z+188 R0 F300
77 CC X-25 Y+160
78 C X-30 Y+160 DR+
79 L Z+230
80 M9
81 L Z+330 R0 FMAX
82 L Z+0 R0 FMAX M91
83 M5
84 M30
85 END PGM NEST MM
