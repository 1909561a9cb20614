%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works.cls)
(MACHINE Dmu70e, CONTROL Haas, MODE auto [plane, tcp])
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 5 of 6, the program begins with a complete restart:)
(modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given, the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
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
(LINEAR WORDS under tip control are tip coordinates in a frame fixed to the)
(table, aligned with the machine axes when its rotary axes are at zero,)
(rotary axes move evenly)
(MODE tcp: G234 must move only the axes of its block, and G49 G53 straight to)
(the machine position)
(LINEAR WORDS in planes are tip coordinates along the axes of the machine,)
(from the zero that has moved with the table)
(linear limits not checked: no travel declared [X Y Z])
(the entries of C and B in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -7.398 to 36.793)
(T2 DIA 5 L130 H2, 1 operation, tip Z -15.078 to 28.689)
(T3 DIA 6 L95 H3, 1 operation, tip Z -10 to 25)
(CONDITION the offsets H hold the lengths of the tools)
(CONDITION setting 9 is the unit of the program)
(CONDITION setting 15 permits the H words of the program)
(CONDITION no mirror image is on [settings 45 to 48, 80 and 250, G101])
(CONDITION nothing lies over the work offset by G52 or G92 [setting 33])
(CONDITION the axes of a rapid arrive together [setting 335], or there is)
(room for each on its own)
(CONDITION settings 85 and 191 round corners no more than the part allows)
(CONDITION F under G234 is the speed of the tip)
(CONDITION setting 130 has how fast a tap comes out, 133 whether the spindle)
(is oriented before it)
(CONDITION the settings of the machine rotary zero point [254 to 257, or 300)
(to 305] are measured)
(CONDITION setting 108 does not rotate an axis at G28 that the program leaves)
(where it is)
(CONDITION off at the start, or not installed [`control.functions` has them)
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
(OPERATION ARCS)
N1 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
T1 M06
T2
G49 G53 G00 Z0.
S4000 M03
G00 B0. C0.
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
G255
M09
G53 G00 Z0.
(T1 stays in the spindle)
S4000 M03
G00 B35.648 C52.916
G254
G00 X-12.949 Y0.302
G43 H1 Z34.739
M08
G01 Z2.739 F300.
X9.791 Y-10.085 F700.
G03 X18.1 Y8.107 I4.154 J9.096
G01 X-4.64 Y18.494
X-12.949 Y0.302
Z34.739
M09
G00 X-12.95 Z94.739
G49 G53 G00 Z0.
G255
(OPERATION HOLES)
N3 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
T2 M06
T1
G49 G53 G00 Z0.
S2500 M03
G00 B35.648 C52.916
G254
G00 X-6.066 Y8.152
G43 H2 Z29.739
M08
G98 G81 X-6.066 Y8.152 Z-1.261 R6.739 F150.
X4.849 Y3.166
G80
G98 G82 X15.765 Y-1.82 Z-1.261 R6.739 P0.5 F150.
G80
G98 G83 X-1.08 Y19.067 Z-10.261 R6.739 Q4. F150.
G80
G98 G83 X9.835 Y14.081 Z-6.261 R10.739 Q4. F150.
G80
G98 G73 X20.75 Y9.096 Z-6.261 R6.739 Q4. F150.
G80
G98 G85 X-0.136 Y-7.749 Z-1.261 R6.739 F80.
G80
M09
G00 Z89.739
G49 G53 G00 Z0.
G255
M05
M00
G49 G53 G00 Z0.
(OPERATION SWARF)
N4 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
T1 M06
T3
G49 G53 G00 Z0.
S4000 M03
G00 B36.784 C-9.687
G254
G00 X28.414 Y6.68
G255
G00 G234 H1 X39.651 Y-16.764 Z22.013
M08
G01 X27.632 Y-11.683 Z-5. B36.784 C-9.687 F300.
X28.743 Y-7.323 B36.415 C-1.2 F900.
X29.853 Y-2.963 B36.784 C7.563
X29.621 Y1.53 B36.415 C16.05
X29.389 Y6.023 B36.784 C24.813
X27.835 Y10.245 B36.415 C33.3
X26.281 Y14.467 B36.784 C42.063
X23.545 Y18.039 B36.415 C50.55
X20.809 Y21.61 B36.784 C59.313
X17.137 Y24.209 B36.415 C67.8
X13.465 Y26.809 B36.784 C76.563
X9.187 Y28.202 B36.415 C85.05
X4.909 Y29.596 B36.784 C93.813
X0.411 Y29.658 B36.415 C102.3
X-4.088 Y29.72 B36.784 C111.063
X-8.403 Y28.446 B36.415 C119.55
X-12.717 Y27.171 B36.784 C128.313
X-16.46 Y24.674 B36.415 C136.8
X-20.203 Y22.178 B36.784 C145.563
X-23.037 Y18.684 B36.415 C154.05
X-25.871 Y15.189 B36.784 C162.813
G00 X-48.376 Y28.403 Z49.027
G49 G53 G00 Z0.
G00 B36.784 C-197.187
G254
G00 X28.414 Y6.68
G255
G00 G234 H1 X-48.376 Y28.403 Z49.027
G01 X-25.871 Y15.189 Z-5. B36.784 C-197.187 F900.
X-27.541 Y11.012 B36.415 C-188.7
X-29.211 Y6.834 B36.784 C-179.937
X-29.568 Y2.35 B36.415 C-171.45
X-29.924 Y-2.135 B36.784 C-162.687
X-28.934 Y-6.524 B36.415 C-154.2
X-27.945 Y-10.913 B36.784 C-145.437
X-25.698 Y-14.811 B36.415 C-136.95
X-23.452 Y-18.709 B36.784 C-128.187
X-20.15 Y-21.765 B36.415 C-119.7
X-16.849 Y-24.822 B36.784 C-110.937
X-12.79 Y-26.762 B36.415 C-102.45
X-8.73 Y-28.702 B36.784 C-93.687
X-4.278 Y-29.351 B36.415 C-85.2
X0.174 Y-30. B36.784 C-76.437
X4.618 Y-29.299 B36.415 C-67.95
X9.062 Y-28.599 B36.784 C-59.187
X13.099 Y-26.612 B36.415 C-50.7
X17.135 Y-24.625 B36.784 C-41.937
X20.401 Y-21.531 B36.415 C-33.45
X23.667 Y-18.436 B36.784 C-24.687
X25.868 Y-14.512 B36.415 C-16.2
X28.069 Y-10.589 B36.784 C-7.437
X29.008 Y-6.189 B36.415 C1.05
X29.947 Y-1.789 B36.784 C9.813
X29.538 Y2.692 B36.415 C18.3
X29.13 Y7.172 B36.784 C27.063
X27.412 Y11.33 B36.415 C35.55
X25.693 Y15.488 B36.784 C44.313
G00 X36.869 Y22.224 Z22.013
M09
X59.22 Y35.698 Z76.04
G49 G53 G00 Z0.
(OPERATION THREAD)
N5 G21 G17 G40 G49 G80 G90 G94 G54
G255
M09
G53 G00 Z0.
M05
T3 M06
T1
G49 G53 G00 Z0.
S500 M03
G00 B0. C0.
X-30. Y20.
G43 H3 Z25.
M08
G98 G84 X-30. Y20. Z-10. R4. F500.
X30.
G80
M09
G00 Z85.
G49 G53 G00 Z0.
M05
M30
%
