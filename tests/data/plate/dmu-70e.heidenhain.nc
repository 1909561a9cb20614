0 BEGIN PGM PLATE INCH
1 BLK FORM 0.1 Z X-0.125 Y-0.375 Z-0.4
2 BLK FORM 0.2 X+1.375 Y+0.625 Z+1
3 ; PROGRAM PLATE
4 ; CL FILE plate.ncl
5 ; MACHINE Dmu70e, CONTROL Heidenhain TNC, MODE axes
6 ; UNITS in, WORK OFFSET preset 1
7 ; PART ORIGIN X0 Y0 Z0 from the reference point of the table
8 ; PROGRAMMED POINT tool tip
9 ; TOLERANCE 0.001 for arcs and curves
10 ; BLANK is the box around all cuts, without [stock] in the configuration
11 ; CL data of Creo, recognised from the file
12 ; 1 arc, sense by form, confirmed by 1 of 1 neighbouring lines
13 ; AXIS C+ rotates the table left-handed about +Z, as in ISO 841
14 ; AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841
15 ; AXIS X+ moves the tool along +X, as in ISO 841
16 ; AXIS Y+ moves the tool along +Y, as in ISO 841
17 ; AXIS Z+ moves the tool along +Z, as in ISO 841
18 ; WHILE A ROTARY AXIS MOVES the tip stays within 0.001 of its line at feed, the tool axis within 0.1 deg of its great circle
19 ; ROTARY WORDS are absolute and may go below 0 and beyond 360: M127 is in force, so the axes do not take the shortest path
20 ; linear limits not checked: no travel declared (X Y Z)
21 ; valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again
22 ; the entries of C and B in preset 1 must be zero
23 ; T3 DIA 0.25 L4, 1 operation, tip Z -0.4 to 1
24 ; ASSUMED part_origin 0, 0, 0: the part zero is the reference point of the table
25 ; ASSUMED work offset preset 1
26 ; ASSUMED retract to machine coordinate 0 mm
27 ; ASSUMED approach distance 50 mm along the tool axis
28 ; ASSUMED F is in 1/10 inch/min, in cycles (Q206) as well
29 M129
30 PLANE RESET STAY
31 M127
32 CYCL DEF 247 DATUM SETTING ~
  Q339=+1 ;DATUM NUMBER
33 M9
34 L Z+0 R0 FMAX M91
35 TOOL CALL 3 Z S3000
36 L Z+0 R0 FMAX M91
37 M3
38 L B+0 C+0 R0 FMAX
39 L X+0 Y+0.5 R0 FMAX
40 L Z+1 R0 FMAX
41 L Z-0.1 R0 F200
42 L X+1
43 CC X+1 Y+0.25
44 C X+1 Y+0 DR-
45 L X+0
46 L Y-0.25
47 L Z+1
48 CYCL DEF 203 UNIVERSAL DRILLING ~
  Q200=+0.1 ;SET-UP CLEARANCE ~
  Q201=-0.4 ;DEPTH ~
  Q206=+40 ;FEED RATE FOR PLNGNG ~
  Q202=+0.15 ;PLUNGING DEPTH ~
  Q210=+0 ;DWELL TIME AT TOP ~
  Q203=+0 ;SURFACE COORDINATE ~
  Q204=+0.5 ;2ND SET-UP CLEARANCE ~
  Q212=+0 ;DECREMENT ~
  Q213=+3 ;NR OF BREAKS ~
  Q205=+0 ;MIN. PLUNGING DEPTH ~
  Q211=+0 ;DWELL TIME AT DEPTH ~
  Q208=+99999 ;RETRACTION FEED RATE ~
  Q256=+0.0197 ;DIST FOR CHIP BRKNG
49 L X+0.25 Y+0.25 R0 FMAX M99
50 L X+0.75 R0 FMAX M99
51 L Z+1 R0 FMAX
52 L Z+3 R0 FMAX
53 L Z+0 R0 FMAX M91
54 M5
55 M30
56 END PGM PLATE INCH
