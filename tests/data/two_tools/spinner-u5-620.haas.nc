%
O00001 (TWO_TOOLS)
(PROGRAM TWO_TOOLS)
(CL FILE two_tools.cls)
(MACHINE SpinnerU5620, CONTROL Haas, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must)
(not take the shortest path to an angle beyond 360)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table,)
(do not touch off again)
(the entries of C and B in G54 must be zero)
(T1 DIA 20 R0 L120 H1, 1 operation, tip Z -26 to 49.301)
(T2 DIA 8 R0 L95 H2, 1 operation, tip Z -3.759 to 52.623)
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
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(OPERATION TILTED_FACE)
N1 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T1 M06
T2
G49 G53 G00 Z0.
S3000 M03
G00 B30. C0.
X71.66 Y-28.
G43 H1 Z75.096
M08
G01 Z25.096 F1000.
X135.66 F900.
Y-14.
X71.66
Y0.
X135.66
Y14.
X71.66
Y28.
X135.66
G00 Z85.096
M09
G49 G53 G00 Z0.
M05
M00
G49 G53 G00 Z0.
(OPERATION TILTED_SLOT)
N2 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T2 M06
T1
G49 G53 G00 Z0.
S7000 M03
G00 B20. C-90.
X70.097 Y-30.
G43 H2 Z65.886
M08
G01 Z15.887 F500.
Y-10. Z14.887 F350.
Y-30. Z13.887
Y-10. Z12.886
Y-30. Z11.886
Y-10.
Y-30.
G00 Z71.887
M09
G49 G53 G00 Z0.
M05
M30
%
