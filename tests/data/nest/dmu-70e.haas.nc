%
O00001 (NEST)
(PROGRAM NEST)
(CL FILE nest.apt)
(MACHINE Dmu70e, CONTROL Haas, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of SolidWorks CAM, recognised from the file)
(2 arcs, sense by form, not confirmed by a neighbouring line)
(CSYS changes 1 time: all points are read in one common frame)
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
(T4 DIA 10 R0 L120 H4, 2 operations, tip Z -15 to 60)
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
(ASSUMED points of the CL data are coordinates from the part zero)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
([HOLDER=H1] 10MM END MILL)
N1 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T4 M06
G49 G53 G00 Z0.
(Stock Size X40. Y60. Z40.)
S3000 M03
G00 B0. C0.
X12.5 Y20.
G43 H4 Z25.
M08
Z3.
G01 Z-2. F150.5
G03 X12.5 Y20. I-2.5 J0. F601.25
G01 X10.
G00 Z60.
X30.
Z3.
G01 Z-5. F200.05
G00 Z3.
Z-4.5
G01 Z-9.
G00 Z3.
Z-8.5
G01 Z-12.
G00 Z25.
M09
Z125.
G49 G53 G00 Z0.
N2 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
(T4 stays in the spindle)
S3000 M03
G00 B180. C90.
X-20. Y160.
G43 H4 Z230.
M08
Z195.
G01 Z188. F300.
G03 X-30. Y160. I-5. J0.
G01 Z230.
M09
G00 Z330.
G49 G53 G00 Z0.
M05
M30
%
