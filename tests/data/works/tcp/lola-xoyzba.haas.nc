%
O00001 (NONAME)
(PROGRAM without name)
(CL FILE works.cls)
(MACHINE LolaXoyzba, CONTROL Haas, MODE tcp)
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
(AXIS X+ moves the table against +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(AXIS B+ rotates the tool right-handed about +Y, as in ISO 841)
(AXIS A+ rotates the tool right-handed about +X, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must)
(not take the shortest path to an angle beyond 360)
(LINEAR WORDS are tip coordinates in a frame fixed to the table, aligned with)
(the machine axes when its rotary axes are at zero, rotary axes move evenly)
(MODE tcp: G234 must move only the axes of its block, and G49 G53 straight to)
(the machine position)
(linear limits not checked: no travel declared [X Y Z])
(the entries of B and A in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 3 operations, tip Z -7.398 to 36.793)
(T2 DIA 5 L130 H2, 1 operation, tip Z -15.078 to 28.689)
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
(ended]: G51 scaling, G68 rotation, G268 tilted plane, G254 dynamic work)
(offset, G187 smoothing)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED setting 22 [retract of G73 after each step, and distance above the)
(last depth to which G83 returns at rapid] is shorter than each step)
(ASSUMED setting 52 [distance above R to which G83 retracts after each step])
(is 0)
(OPERATION ARCS)
N1 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T1 M06
T2
G49 G53 G00 Z0.
IF [ABS[#2001 + #2201 - 110] GT 0.01] THEN #3000= 101 (T1 IS NOT 110 LONG)
S4000 M03
G00 A0. B0.
X12. Y0.
G00 G234 H1 X12. Y0. Z20.
M08
Z2. A0. B0.
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
M09
G53 G00 Z0.
(T1 stays in the spindle)
IF [ABS[#2001 + #2201 - 110] GT 0.01] THEN #3000= 101 (T1 IS NOT 110 LONG)
S4000 M03
G00 A-15.799 B19.629
X36.039 Y34.495
G00 G234 H1 X0.483 Y4.546 Z36.793
M08
G01 X-9.86 Y-4.167 Z7.791 A-15.799 B19.629 F300.
X13.687 Z-0.608 F700.
X14.504 Y-4.13 Z-0.91
X15.309 Y-4.021 Z-1.23
X16.094 Y-3.839 Z-1.564
X16.853 Y-3.586 Z-1.911
X17.582 Y-3.265 Z-2.267
X18.274 Y-2.878 Z-2.631
X18.924 Y-2.427 Z-2.998
X19.527 Y-1.916 Z-3.367
X20.079 Y-1.348 Z-3.734
X20.576 Y-0.73 Z-4.097
X21.013 Y-0.064 Z-4.453
X21.387 Y0.644 Z-4.799
X21.695 Y1.389 Z-5.133
X21.936 Y2.165 Z-5.451
X22.107 Y2.965 Z-5.753
X22.207 Y3.785 Z-6.035
X22.235 Y4.617 Z-6.295
X22.191 Y5.456 Z-6.531
X22.076 Y6.294 Z-6.742
X21.889 Y7.126 Z-6.925
X21.634 Y7.946 Z-7.08
X21.31 Y8.747 Z-7.206
X20.922 Y9.522 Z-7.3
X20.472 Y10.267 Z-7.363
X19.963 Y10.975 Z-7.394
X19.4 Y11.641
X18.786 Y12.259 Z-7.36
X18.126 Y12.827 Z-7.296
X17.426 Y13.338 Z-7.199
X16.69 Y13.789 Z-7.072
X15.924 Y14.176 Z-6.916
X15.134 Y14.497 Z-6.73
X14.327 Y14.75 Z-6.518
X13.507 Y14.932 Z-6.281
X12.682 Y15.041 Z-6.019
X11.858 Y15.078 Z-5.736
X-11.689 Z2.662
X-9.86 Y-4.167 Z7.791
X0.483 Y4.546 Z36.793
M09
G00 X19.877 Y20.881 Z91.171
G49 G53 G00 Z0.
(OPERATION HOLES)
N3 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
M05
T2 M06
T1
G49 G53 G00 Z0.
IF [ABS[#2002 + #2202 - 130] GT 0.01] THEN #3000= 101 (T2 IS NOT 130 LONG)
S2500 M03
G00 A-15.799 B19.629
X42.799 Y48.201
G00 G234 H2 X0.778 Y12.807 Z28.689
M08
Y12.806 A-15.799 B19.629
X-6.656 Y6.545 Z7.844
G01 X-9.242 Y4.366 Z0.593 F150.
G00 X0.778 Y12.806 Z28.689
X12.081 Z24.658
X4.646 Y6.545 Z3.813
G01 X2.061 Y4.366 Z-3.438
G00 X12.081 Y12.806 Z24.658
X23.384 Z20.627
X15.949 Y6.545 Z-0.218
G01 X13.363 Y4.366 Z-7.469
G04 P0.5
G00 X23.384 Y12.806 Z20.627
X-0.319 Y24.353 Z25.612
X-7.754 Y18.091 Z4.767
G01 X-9.693 Y16.458 Z-0.671
G00 X-7.754 Y18.091 Z4.767
X-9.532 Y16.594 Z-0.218
G01 X-10.986 Y15.369 Z-4.297
G00 X-7.754 Y18.091 Z4.767
X-10.824 Y15.505 Z-3.843
G01 X-12.279 Y14.28 Z-7.922
G00 X-7.754 Y18.091 Z4.767
X-12.117 Y14.416 Z-7.469
G01 X-13.249 Y13.463 Z-10.641
G00 X-0.319 Y24.353 Z25.612
X10.983 Z21.58
X4.842 Y19.18 Z4.361
G01 X2.902 Y17.547 Z-1.077
G00 X4.842 Y19.18 Z4.361
X3.064 Y17.683 Z-0.624
G01 X1.61 Y16.458 Z-4.702
G00 X4.842 Y19.18 Z4.361
X1.771 Y16.594 Z-4.249
G01 X0.317 Y15.369 Z-8.328
G00 X4.842 Y19.18 Z4.361
X0.478 Y15.505 Z-7.875
G01 X-0.653 Y14.552 Z-11.047
G00 X10.983 Y24.353 Z21.58
X22.286 Z17.549
X14.852 Y18.091 Z-3.296
G01 X12.912 Y16.458 Z-8.734
G00 X13.074 Y16.594 Z-8.28
G01 X11.619 Y15.369 Z-12.359
G00 X11.781 Y15.505 Z-11.906
G01 X10.65 Y14.552 Z-15.078
G00 X22.286 Y24.353 Z17.549
X13.178 Y1.26 Z27.735
X5.744 Y-5.002 Z6.89
G01 X3.158 Y-7.18 Z-0.361 F80.
X5.744 Y-5.002 Z6.89
G00 X13.178 Y1.26 Z27.735
M09
X32.573 Y17.595 Z82.113
G49 G53 G00 Z0.
M05
M00
G49 G53 G00 Z0.
(OPERATION SWARF)
N4 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T1 M06
T3
G49 G53 G00 Z0.
IF [ABS[#2001 + #2201 - 110] GT 0.01] THEN #3000= 101 (T1 IS NOT 110 LONG)
S4000 M03
G00 A9.752 B23.985
X83.72 Y-35.396
G00 G234 H1 X39.651 Y-16.764 Z22.013
M08
G01 X27.632 Y-11.683 Z-5. A9.752 B23.985 F300.
X29.853 Y-2.963 A2.462 B25.673 F900.
X29.389 Y6.023 A-5.01 B25.324
X26.281 Y14.467 A-12.108 B22.937
X20.809 Y21.61 A-18.259 B18.524
X13.465 Y26.809 A-22.873 B12.233
X4.909 Y29.596 A-25.411 B4.52
X-4.088 Y29.72 A-25.525 B-3.766
X-12.717 Y27.171 A-23.201 B-11.573
X-20.203 Y22.178 A-18.757 B-18.02
X-25.871 Y15.189 A-12.722 B-22.615
X-29.211 Y6.834 A-5.687 B-25.19
X-29.924 Y-2.135 A1.774 B-25.726
X-27.945 Y-10.913 A9.104 B-24.226
X-23.452 Y-18.709 A15.739 B-20.687
X-16.849 Y-24.822 A21.093 B-15.179
X-8.73 Y-28.702 A24.591 B-8.002
X0.174 Y-30. A25.783 B0.16
X9.062 Y-28.599 A24.497 B8.302
X17.135 Y-24.625 A20.918 B15.424
X23.667 Y-18.436 A15.504 B20.861
X28.069 Y-10.589 A8.831 B24.321
X29.947 Y-1.789 A1.486 B25.743
X29.13 Y7.172 A-5.969 B25.129
X25.693 Y15.488 A-12.977 B22.475
G00 X36.869 Y22.224 Z22.013
M09
X59.22 Y35.698 Z76.04
G49 G53 G00 Z0.
M05
M30
%
