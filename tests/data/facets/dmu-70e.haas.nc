%
O00001 (FACETS)
(PROGRAM FACETS)
(CL FILE facets.aptsource)
(MACHINE Dmu70e, CONTROL Haas, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of CATIA, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in)
(ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes)
(must not take the shortest path to an angle beyond 360)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table,)
(do not touch off again)
(the entries of C and B in G54 must be zero)
(T5 DIA 16 R0 L132.5 H5, 3 operations, tip Z -13.517 to 58.514)
(T6 DIA 6 R0 L97.25 H6, 1 operation, tip Z -4.281 to 61.011)
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
N1 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T5 M06
T6
G49 G53 G00 Z0.
S4500 M03
G00 B40.013 C34.438
X83.382 Y12.486
G43 H5 Z88.929
M08
G01 Z26.929 F600.
X104.687 Y17.971 F850.
X100.199 Y35.403
G00 X100.2 Y35.402 Z90.929
M09
G49 G53 G00 Z0.
G00 B47.364 C154.23
X94.366 Y22.375
G43 H5 Z98.237
M08
G01 X94.367 Z36.237 F600.
X115.379 Y28.892 F850.
X110.047 Y46.084
G00 Z100.237
M09
G49 G53 G00 Z0.
M05
M00
G49 G53 G00 Z0.
N2 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
(T5 stays in the spindle)
S4500 M03
G00 B34.199 C301.272
X76.454 Y7.304
G43 H5 Z83.809
M08
G01 Z21.809 F600.
X97.951 Y11.98 F850.
X94.125 Y29.569
G00 Z85.809
M09
G49 G53 G00 Z0.
N3 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
M05
T6 M06
T5
G49 G53 G00 Z0.
S9000 M03
G00 B17.713 C206.288
X43.35 Y-3.185
G43 H6 Z68.326
M08
G01 Z6.326 F600.
X65.218 Y-0.776 F850.
X63.247 Y17.116
G00 Z70.326
M09
G49 G53 G00 Z0.
N4 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
M05
T5 M06
G49 G53 G00 Z0.
S4200 M03
G00 B59.375 C192.955
X107.214 Y34.142
G43 H5 Z112.
M08
G01 Z50. F600.
X127.618 Y42.367 F850.
X120.888 Y59.062
G00 Z114.
M09
G49 G53 G00 Z0.
M05
M30
%
