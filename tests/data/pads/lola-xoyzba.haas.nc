%
O00001 (PADS)
(PROGRAM PADS)
(CL FILE pads.cls)
(MACHINE LolaXoyzba, CONTROL Haas, MODE axes)
(UNITS mm, WORK OFFSET G57)
(PART ORIGIN X12.5 Y-8 Z40 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(AXIS X+ moves the table against +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(AXIS B+ rotates the tool right-handed about +Y, as in ISO 841)
(AXIS A+ rotates the tool right-handed about +X, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must)
(not take the shortest path to an angle beyond 360)
(G57 must hold X20 Y-15 Z-520)
(the entries of B and A in G57 must be zero)
(T21 bull 12 DIA 12 R1 L120.25 H21, 1 operation, tip Z -9.4 to 0.521)
(T21 posted with L = 120.25: H21 must hold exactly this)
(T22 DIA 12 R1 L96.5 H52, 1 operation, tip Z -3.3 to -1.375)
(T22 posted with L = 96.5: H52 must hold exactly this)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G254 dynamic work)
(offset, G187 smoothing)
(ASSUMED retract to machine coordinate 0 mm)
(OPERATION SOUTH)
N1 G21 G17 G40 G49 G80 G90 G94 G57
M09
G53 G00 Z0.
(T21 bull 12)
T21 M06
T22
G49 G53 G00 Z0.
IF [ABS[#2021 + #2221 - 120.25] GT 0.01] THEN #3000= 101 (T21 IS NOT 120.25 LONG)
S5200 M03
G00 A18.266 B2.256
X7.996 Y-63.387
G43 H21 Z-5.627
M08
G01 X7.865 Y-62.29 Z-8.948 F300.
X22.064 Y-60.597 F700.
X22.139 Y-61.224 Z-7.05
M09
G00 X24.942 Y-84.731 Z64.116
G49 G53 G00 Z0.
G00 A35.807 B4.935
X10.74 Y-121.986
G43 H21 Z-5.422
M08
X8.647 Y-104.435 Z-29.662
G01 X14.559 Y-101.653 Z-32.49 F300.
X28.759 Y-99.96 F700.
X28.898 Y-101.13 Z-30.874
M09
G00 X34.131 Y-145.009 Z29.726
G49 G53 G00 Z0.
(OPERATION NORTH)
N2 G21 G17 G40 G49 G80 G90 G94 G57
M09
G53 G00 Z0.
M05
T22 M06
T21
G49 G53 G00 Z0.
IF [ABS[#2052 + #2252 - 96.5] GT 0.01] THEN #3000= 101 (T22 IS NOT 96.5 LONG)
S6100 M03
G00 A-15.559 B-2.129
X-8.957 Y60.131
G43 H52 Z21.98
M08
G01 X-7.884 Y52.084 Z-6.9 F300.
X-22.058 Y50.193 F700.
X-22.13 Y50.729 Z-4.975
M09
G00 X-24.814 Y70.846 Z67.227
G49 G53 G00 Z0.
M05
G53 G00 X0. Y240.
M30
%
