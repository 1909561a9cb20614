J0 BEGIN PGM NONAME MM
1 BLK FORM 0.1 Z X-15 Y-15 Z-5
2 BLK FORM 0.2 X+15 Y+17 Z+20
3 ; PROGRAM without name
4 ; CL FILE stdin
5 ; MACHINE SpinnerU5620, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS mm, WORK OFFSET datum row 1
7 ; PART ORIGIN X0 Y0 Z0 from the table reference
8 ; PROGRAMMED POINT tool tip
9 ; ARCS AND CURVES left by at most 0.01
10 ; CL data of NX, by its own evidence
11 ; 1 arc, sense by form only, 0 arcs confirmed
12 ; INSERT written as it stands: nobody has checked it
13 ; AXIS C + turns the table left-handed about +Z: word as in ISO 841
14 ; AXIS B + turns the table left-handed about +Y: word as in ISO 841
15 ; AXIS X + moves the tool along +X: word as in ISO 841
16 ; AXIS Y + moves the tool along +Y: word as in ISO 841
17 ; AXIS Z + moves the tool along +Z: word as in ISO 841
18 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg
19 ; ROTARY WORDS are absolute and count on past 360: M127 is in force, so the axes do not take the shortest path
20 ; linear limits not checked: no travel declared (X Y Z)
21 ; valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again
22 ; the entries of C and B in datum row 1 must be zero
23 ; T1 D10 R1 L unknown, 1 operation, tip Z -5 to 20
24 ; ASSUMED the unit of the CL data, which does not state one, is mm as given with the job
25 ; ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point
26 ; ASSUMED work offset datum row 1
27 ; ASSUMED retract to machine coordinate 0 mm
28 ; ASSUMED approach from 50 mm along the tool axis
29 ; ASSUMED spindle of T1 from the configuration where the CL data gives none: S3000 CLW
30 ; ASSUMED the gauge length of T1 is unknown: its offset must hold the true one
31 * - POCKET
32 M129
33 PLANE RESET STAY
34 M127
35 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
36 M9
37 L Z+0 R0 FMAX M91
38 TOOL CALL 1 Z S3000
39 L Z+0 R0 FMAX M91
40 M3
41 L B+0 C+0 R0 FMAX
42 L X+10 Y+0 R0 FMAX
43 L Z+5 R0 FMAX
44 L Z+0 R0 F250
45 CC X+0 Y+0
46 CP IPA+360 IZ-1.6 DR+
47 CC X+0 Y+0
48 CP IPA+90 IZ-0.4 DR+
49 L X+0.353 Y+10.022
50 L X+0.664 Y+10.082
51 L X+0.94 Y+10.171
52 L X+1.188 Y+10.281
53 L X+1.411 Y+10.403
54 L X+1.617 Y+10.527
55 L X+1.812 Y+10.646
56 L X+2 Y+10.75
57 L X+2.151 Y+10.819
58 L X+2.304 Y+10.88
59 L X+2.463 Y+10.941
60 L X+2.632 Y+11.01
61 L X+2.813 Y+11.094
62 L X+3.008 Y+11.2
63 L X+3.222 Y+11.336
64 L X+3.456 Y+11.51
65 L X+3.715 Y+11.729
66 L X+4 Y+12
67 L Z+20
68 CYCL DEF 205 UNIVERSAL PECKING ~
  Q200=+3 ;SET-UP CLEARANCE ~
  Q201=-5 ;DEPTH ~
  Q206=+250 ;FEED RATE FOR PLNGNG ~
  Q202=+2 ;PLUNGING DEPTH ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=+20 ;2ND SET-UP CLEARANCE ~
  Q212=+0 ;DECREMENT ~
  Q205=+0 ;MIN. PLUNGING DEPTH ~
  Q258=+0.5 ;UPPER ADV STOP DIST ~
  Q259=+0.5 ;LOWER ADV STOP DIST ~
  Q257=+0 ;DEPTH FOR CHIP BRKNG ~
  Q256=+0.2 ;DIST FOR CHIP BRKNG ~
  Q211=+0 ;DWELL TIME AT DEPTH ~
  Q379=+0 ;STARTING POINT ~
  Q253=+99999 ;F PRE-POSITIONING
69 L X+4 Y+12 R0 FMAX M99
70 L Z+70 R0 FMAX
71 L Z+0 R0 FMAX M91
72 M5
73 M30
74 END PGM NONAME MM
