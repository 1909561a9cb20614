%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works.cls)
(MACHINE LolaXoyzba, CONTROL Haas, MODE plane)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 3 of 6, the program begins with a complete restart:)
(modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given, the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
(KINEMATICS *)
(AXIS X+ moves the table against +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(AXIS B+ rotates the tool right-handed about +Y, as in ISO 841)
(AXIS A+ rotates the tool right-handed about +X, as in ISO 841)
(LINEAR WORDS are tip coordinates in the tilted plane, from the same zero)
(MODE plane: G43 H must move nothing by itself, G268 must rotate about X,)
(then Y, then Z of the work offset, and G253 must take the pose of the actual)
(axis positions)
(MODE plane: no block of this program compares the rotary axes after a plane)
(call)
(linear limits not checked: no travel declared [X Y Z])
(the entries of B and A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 2 operations, tip Z -7.398 to 36.793)
(T2 DIA 5 L130 H2, 1 operation, tip Z -15.078 to 28.689)
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
(ended]: G51 scaling, G68 rotation, G254 dynamic work offset, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
(OPERATION ARCS)
N1 G21 G17 G40 G49 G80 G90 G94 G54
G269
M09
G53 G00 Z0.
T1 M06
T2
G49 G53 G00 Z0.
S4000 M03
G00 A0. B0.
X12. Y0.
G43 H1 Z20.
M08
Z2.
G03 X12. Y0. Z-0.4 I-12. J0. F200.
X0. Y12. Z-1. I-12. J0.
G01 X-20. F600.
G03 X-20. Y-12. I0. J-12.
G01 X0.
G02 X8. Y-20. I0. J-8.
X8. Y-20. I-8. J0.
G01 Z20.
M09
G00 Z80.
G49 G53 G00 Z0.
M05
M01
G49 G53 G00 Z0.
(OPERATION TILTED)
N2 G21 G17 G40 G49 G80 G90 G94 G54
G269
M09
G53 G00 Z0.
(T1 stays in the spindle)
S4000 M03
G00 A-15.799 B19.629
G43 H1
G268 X0. Y0. Z0. I-17.612 J18.033 K-5.613 Q123
G253
G00 X-11.355 Y-6.232
Z34.739
M08
G01 Z2.739 F300.
X13.528 Y-3.816 F700.
G03 X11.595 Y16.091 I-0.967 J9.953
G01 X-13.288 Y13.674
X-11.355 Y-6.232
Z34.739
M09
G00 Z94.739
G49 G53 G00 Z0.
G269
(OPERATION HOLES)
N3 G21 G17 G40 G49 G80 G90 G94 G54
G269
M09
G53 G00 Z0.
M05
T2 M06
T1
G49 G53 G00 Z0.
S2500 M03
G00 A-15.799 B19.629
G43 H2
G268 X0. Y0. Z0. I-17.612 J18.033 K-5.613 Q123
G253
G00 X-9.336 Y4.011
Z29.739
M08
G98 G81 X-9.336 Y4.011 Z-1.261 R6.739 F150.
X2.608 Y5.171
G80
G98 G82 X14.552 Y6.331 Z-1.261 R6.739 P0.5 F150.
G80
G98 G83 X-10.496 Y15.955 Z-10.261 R6.739 Q4. F150.
G80
G98 G83 X1.448 Y17.115 Z-6.261 R10.739 Q4. F150.
G80
G98 G73 X13.392 Y18.275 Z-6.261 R6.739 Q4. F150.
G80
G98 G85 X3.768 Y-6.773 Z-1.261 R6.739 F80.
G80
M09
G00 Z89.739
G49 G53 G00 Z0.
G269
M05
M00
G49 G53 G00 Z0.
M09
M05
M30
%
