%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE passes.cls)
(MACHINE Dmu70e, CONTROL Haas, MODE auto [tcp])
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z50 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of NX, recognised from the file)
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
(LINEAR WORDS are tip coordinates in a frame fixed to the table, aligned with)
(the machine axes when its rotary axes are at zero, rotary axes move evenly)
(MODE tcp: G234 must move only the axes of its block, and G49 G53 straight to)
(the machine position)
(linear limits not checked: no travel declared [X Y Z])
(the entries of C and B in G54 must be zero)
(T4 ball 8 DIA 8 L130 H4, 1 operation, tip Z 3 to 23.126)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
(CONDITION F under G234 is the speed of the tip)
(CONDITION the settings of the machine rotary zero point [254 to 257, or 300)
(to 305] are measured)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(OPERATION PASSES)
N1 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
(T4 ball 8)
T4 M06
G49 G53 G00 Z0.
S8000 M03
G00 B35.648 C12.809
G254
G00 X24.452 Y5.559
G255
G00 G234 H4 X38.452 Y0. Z23.126
M08
G01 X30. Z5. B35.648 C12.809 F600.
X29.672 Y3.119 B36.92 C19.497 F1200.
X29.344 Y6.237 B38.555 C25.891
X28.375 Y9.22 B39.823 C32.564
X27.406 Y12.202 B41.475 C38.988
X25.838 Y14.918 B42.742 C45.649
X24.271 Y17.634 B44.411 C52.101
G00 X32.604 Y23.688 Z22.143
G01 X34.223 Y17.766 Z22.063 B41.677 C43.07 F8000.
X35.842 Y11.844 Z21.982 B39.725 C33.502
X37.461 Y5.922 Z21.901 B38.662 C23.648
X39.08 Y0. Z21.82 B38.555 C13.891
X30. Z4. F600.
X29.672 Y3.119 B39.823 C20.564 F1200.
X29.344 Y6.237 B41.475 C26.988
X28.375 Y9.22 B42.742 C33.649
X27.406 Y12.202 B44.411 C40.101
X25.838 Y14.918 B45.677 C46.752
X24.271 Y17.634 B47.364 C53.23
G00 X33.083 Y24.036 Z20.773
G01 X34.736 Y18.027 Z20.703 B44.555 C44.093 F8000.
X36.39 Y12.018 Z20.633 B42.575 C34.485
X38.043 Y6.009 Z20.563 B41.527 C24.66
X39.696 Y0. Z20.492 B41.475 C14.988
X30. Z3. F600.
X29.672 Y3.119 B42.742 C21.649 F1200.
X29.344 Y6.237 B44.411 C28.101
X28.375 Y9.22 B45.677 C34.752
X27.406 Y12.202 B47.364 C41.23
X25.838 Y14.918 B48.63 C47.874
X24.271 Y17.634 B50.335 C54.379
G00 X33.551 Y24.376 Z19.383
M09
X45.23 Y32.862 Z40.
G49 G53 G00 Z0.
M05
M30
%
