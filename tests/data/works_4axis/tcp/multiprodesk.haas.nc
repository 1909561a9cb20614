%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works_4axis.cls)
(MACHINE MultiProDesk, CONTROL Haas, MODE tcp)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X10 Y-20 Z35 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(only operations 1 to 4 of 6, the program begins with a complete restart:)
(modal codes, tool, offset, spindle)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given, the CL file states none)
(5 arcs, sense by form, confirmed by 4 of 4 neighbouring lines)
(KINEMATICS *)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must)
(not take the shortest path to an angle beyond 360)
(LINEAR WORDS are tip coordinates in a frame fixed to the table, aligned with)
(the machine axes when its rotary axes are at zero, rotary axes move evenly)
(MODE tcp: G234 must move only the axes of its block, and G49 G53 straight to)
(the machine position)
(linear limits not checked: no travel declared [Y X Z])
(the entries of A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -35.818 to 45.394)
(T2 DIA 5 L130 H2, 1 operation, tip Z -8.509 to 29.729)
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
G00 A0.
X12. Y0.
G00 G234 H1 X12. Y0. Z20.
M08
Z2. A0.
G02 X12. Y0. Z-0.4 I-12. J0. F200.
X0. Y-12. Z-1. I-12. J0.
G01 X-20. F600.
G02 X-20. Y12. I0. J12.
G01 X0.
G03 X8. Y20. I0. J8.
X8. Y20. I-8. J0.
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
G00 A-25.
G254
G00 X-11. Y3.717
G255
G00 G234 H1 X-11. Y15.742 Z24.963
M08
G01 Y2.218 Z-4.039 A-25. F300.
X14. F700.
X14.872 Y2.183 Z-4.023
X15.736 Y2.08 Z-3.975
X16.588 Y1.909 Z-3.895
X17.42 Y1.671 Z-3.784
X18.226 Y1.369 Z-3.643
X19. Y1.004 Z-3.473
X19.736 Y0.579 Z-3.275
X20.428 Y0.097 Z-3.05
X21.071 Y-0.437 Z-2.801
X21.66 Y-1.02 Z-2.529
X22.191 Y-1.647 Z-2.237
X22.66 Y-2.314 Z-1.926
X23.063 Y-3.015 Z-1.599
X23.397 Y-3.745 Z-1.258
X23.659 Y-4.5 Z-0.906
X23.848 Y-5.271 Z-0.546
X23.962 Y-6.055 Z-0.181
X24. Y-6.845 Z0.187
X23.962 Y-7.635 Z0.556
X23.848 Y-8.419 Z0.921
X23.659 Y-9.191 Z1.281
X23.397 Y-9.945 Z1.633
X23.063 Y-10.675 Z1.973
X22.66 Y-11.377 Z2.3
X22.192 Y-12.044 Z2.611
X21.66 Y-12.671 Z2.904
X21.071 Y-13.254 Z3.176
X20.428 Y-13.788 Z3.425
X19.736 Y-14.269 Z3.649
X19. Y-14.694 Z3.847
X18.226 Y-15.059 Z4.018
X17.42 Y-15.362 Z4.159
X16.588 Y-15.599 Z4.27
X15.736 Y-15.771 Z4.349
X14.872 Y-15.874 Z4.398
X14. Y-15.908 Z4.414
X-11.
Y2.218 Z-4.039
Y15.742 Z24.963
M09
G00 Y41.099 Z79.342
G49 G53 G00 Z0.
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
G00 A-25.
G254
G00 X-8. Y-6.283
G255
G00 G234 H2 X-8. Y4.566 Z24.658
M08
Y4.565 A-25.
Y-5.155 Z3.813
G01 Y-8.536 Z-3.438 F150.
G00 Y4.565 Z24.658
X4.
Y-5.155 Z3.813
G01 Y-8.536 Z-3.438
G00 Y4.565 Z24.658
X16.
Y-5.155 Z3.813
G01 Y-8.536 Z-3.438
G04 P0.5
G00 Y4.565 Z24.658
X-8. Y-6.31 Z29.729
Y-16.03 Z8.884
G01 Y-18.566 Z3.446
G00 Y-16.03 Z8.884
Y-18.355 Z3.899
G01 Y-20.257 Z-0.179
G00 Y-16.03 Z8.884
Y-20.045 Z0.274
G01 Y-21.947 Z-3.804
G00 Y-16.03 Z8.884
Y-21.736 Z-3.351
G01 Y-23.215 Z-6.523
G00 Y-6.31 Z29.729
X4.
Y-14.34 Z12.509
G01 Y-16.876 Z7.071
G00 Y-14.34 Z12.509
Y-16.664 Z7.525
G01 Y-18.566 Z3.446
G00 Y-14.34 Z12.509
Y-18.355 Z3.899
G01 Y-20.257 Z-0.179
G00 Y-14.34 Z12.509
Y-20.045 Z0.274
G01 Y-21.524 Z-2.898
G00 Y-6.31 Z29.729
X16.
Y-16.03 Z8.884
G01 Y-18.566 Z3.446
G00 Y-18.355 Z3.899
G01 Y-20.257 Z-0.179
G00 Y-20.045 Z0.274
G01 Y-21.525 Z-2.898
G00 Y-6.31 Z29.729
X4. Y15.441 Z19.586
Y5.721 Z-1.259
G01 Y2.34 Z-8.509 F80.
Y5.721 Z-1.259
G00 Y15.441 Z19.586
M09
Y40.798 Z73.965
G49 G53 G00 Z0.
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
G00 A34.377
G254
G00 X-10. Y0.
G255
G00 G234 H1 X-10. Y-31.055 Z45.394
M08
G01 Y-14.116 Z20.633 A34.377 F300.
X-9.2 Y-11.545 Z22.175 A27.502 F900.
X-8.4 Y-8.807 Z23.397 A20.626
X-7.6 Y-5.943 Z24.283 A13.751
X-6.8 Y-2.993 Z24.82 A6.875
X-6. Y0. Z25. A0.
X-5.2 Y2.993 Z24.82 A-6.875
X-4.4 Y5.943 Z24.283 A-13.751
X-3.6 Y8.807 Z23.397 A-20.626
X-2.8 Y11.545 Z22.175 A-27.502
X-2. Y14.116 Z20.633 A-34.377
X-1.2 Y16.485 Z18.795 A-41.253
X-0.4 Y18.616 Z16.687 A-48.128
X0.4 Y20.48 Z14.338 A-55.004
X1.2 Y22.049 Z11.783 A-61.879
X2. Y23.301 Z9.059 A-68.755
X2.8 Y24.218 Z6.204 A-75.63
X3.6 Y24.787 Z3.261 A-82.506
X4.4 Y24.999 Z0.27 A-89.381
X5.2 Y24.851 Z-2.725 A-96.257
X6. Y24.346 Z-5.68 A-103.132
X6.8 Y23.491 Z-8.554 A-110.008
X7.6 Y22.298 Z-11.304 A-116.883
X8.4 Y20.785 Z-13.893 A-123.759
X9.2 Y18.972 Z-16.281 A-130.634
G00 Y41.738 Z-35.818
M09
Y87.271 Z-74.891
G49 G53 G00 Z0.
M05
M30
%
