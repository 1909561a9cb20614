%
O00001 (PLATE)
(PROGRAM PLATE)
(CL FILE plate.ncl)
(MACHINE Dmu70e, CONTROL Haas, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.001 for arcs and curves)
(CL data of Creo, recognised from the file)
(1 arc, sense by form, confirmed by 1 of 1 neighbouring lines)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in)
(ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.001 of its line at feed,)
(the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes)
(must not take the shortest path to an angle beyond 360)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table,)
(do not touch off again)
(the entries of C and B in G54 must be zero)
(T3 DIA 0.25 L4 H3, 1 operation, tip Z -0.4 to 1)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
(CONDITION setting 130 has how fast a tap comes out, 133 whether the spindle)
(is oriented before it)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G254 dynamic work)
(offset, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 in)
(ASSUMED approach distance 1.968504 in along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
N1 G20 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T3 M06
G49 G53 G00 Z0.
S3000 M03
G00 B0. C0.
X0. Y0.5
G43 H3 Z1.
G01 Z-0.1 F20.
X1.
G02 X1. Y0. I0. J-0.25
G01 X0.
Y-0.25
Z1.
G00 X0.25 Y0.25
Z0.5
G98 G73 X0.25 Y0.25 Z-0.4 R0.1 Q0.15 F4.
X0.75
G80
G00 Z1.
Z3.
G49 G53 G00 Z0.
M05
M30
%
