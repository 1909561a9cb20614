%
O01234 (SHOP)
(PROGRAM SHOP)
(CL FILE shop.cls)
(MACHINE SpinnerU5620, CONTROL Haas, MODE auto [plane])
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z50 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(Haas has no swivel data: `control.swivel_data` is left out)
(operation 1 FACE_ROUGH: smoothing rough, path tolerance 0.05 mm)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(LINEAR WORDS are tip coordinates along the axes of the machine, from the)
(zero that has moved with the table)
(linear limits not checked: no travel declared [X Y Z])
(the entries of C and B in G54 must be zero)
(T1 mill 12 DIA 12 L120 H1, 1 operation, tip Z -2 to 60)
(T2 drill 8 L140 H2, 1 operation, tip Z -26 to 60)
(T3 ball 6 DIA 6 R3 L110 H3, 1 operation, tip Z 19.799 to 50.912)
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
(CONDITION the settings of the machine rotary zero point [254 to 257, or 300)
(to 305] are measured)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G187 smoothing)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(OPERATION FACE_ROUGH)
N1 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
(T1 mill 12)
T1 M06
T2
G49 G53 G00 Z0.
S4000 M03
G00 B0. C0.
X-40. Y-10.
G43 H1 Z60.
M08
Z2.
G187 P1 E0.05
G01 Z-2. F400.
X40. F1200.
Y10.
X-40.
G00 Z60.
M09
G187
G49 G53 G00 Z0.
(OPERATION DRILL)
N2 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
(T2 drill 8)
T2 M06
T3
G49 G53 G00 Z0.
S2500 M03
G00 B0. C0.
X20. Y0.
G43 H2 Z60.
M08
Z8.
G98 G81 X20. Y0. Z-26. R1. F250.
X-20.
G80
G00 Z60.
M09
G49 G53 G00 Z0.
(OPERATION FINISH_45)
N3 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
(T3 ball 6)
T3 M06
T1
G49 G53 G00 Z0.
S9000 M03
G00 B45. C0.
G254
G00 X0. Y-20.
G43 H3 Z72.
M08
Z32.
G187 P3 E0.01
G01 Z29. F500.
Y20. F1800.
X1.
Y-20.
G00 Z71.
M09
Z131.
G187
G49 G53 G00 Z0.
G255
M05
M30
%
