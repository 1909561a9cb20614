%
O00001 (NEST)
(PROGRAM NEST)
(CL FILE nest.apt)
(MACHINE Dmu70e, CONTROL Haas, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(ARCS AND CURVES in chords that leave them by at most 0.01)
(CL data of SolidWorks CAM, by its own evidence)
(2 arcs, sense by form only, 0 arcs confirmed)
(CSYS changes 1 time: its points stay in one common frame)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word)
(as in ISO 841)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the)
(tool axis within 0.1 deg)
(ROTARY WORDS are absolute and count on past 360: the axes must not take the)
(shortest way to an angle of another turn)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch)
(off again)
(the entries of C and B in G54 must be zero)
(T4 D10 R0 L120 H4, 2 operations, tip Z -14.99 to 60)
(ASSUMED the points of the CL data count from the part zero)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
([HOLDER=H1] 10MM END MILL)
(Stock Size X40. Y60. Z40.)
N1 G21 G17 G40 G49 G80 G90 G94 G54
M09
G53 G00 Z0.
T4 M06
G49 G53 G00 Z0.
S3000 M03
G00 B0. C0.
X12.5 Y20.
G43 H4 Z25.
M08
Z3.
G01 Z-2. F150.5
X12.462 Y20.434 F601.25
X12.349 Y20.855
X12.165 Y21.25
X11.915 Y21.607
X11.607 Y21.915
X11.25 Y22.165
X10.855 Y22.349
X10.434 Y22.462
X10. Y22.5
X9.566 Y22.462
X9.145 Y22.349
X8.75 Y22.165
X8.393 Y21.915
X8.085 Y21.607
X7.835 Y21.25
X7.651 Y20.855
X7.538 Y20.434
X7.5 Y20.
X7.538 Y19.566
X7.651 Y19.145
X7.835 Y18.75
X8.085 Y18.393
X8.393 Y18.085
X8.75 Y17.835
X9.145 Y17.651
X9.566 Y17.538
X10. Y17.5
X10.434 Y17.538
X10.855 Y17.651
X11.25 Y17.835
X11.607 Y18.085
X11.915 Y18.393
X12.165 Y18.75
X12.349 Y19.145
X12.462 Y19.566
X12.5 Y20.
X10.
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
X-20.039 Y160.627
X-20.157 Y161.243
X-20.351 Y161.841
X-20.618 Y162.409
X-20.955 Y162.939
X-21.355 Y163.423
X-21.813 Y163.853
X-22.321 Y164.222
X-22.871 Y164.524
X-23.455 Y164.755
X-24.063 Y164.911
X-24.686 Y164.99
X-25.314
X-25.937 Y164.911
X-26.545 Y164.755
X-27.129 Y164.524
X-27.679 Y164.222
X-28.187 Y163.853
X-28.645 Y163.423
X-29.045 Y162.939
X-29.382 Y162.409
X-29.649 Y161.841
X-29.843 Y161.243
X-29.961 Y160.627
X-30. Y160.
Z230.
M09
G00 Z330.
G49 G53 G00 Z0.
M05
M30
%
