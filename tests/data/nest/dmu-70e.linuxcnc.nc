(PROGRAM NEST)
(CL FILE nest.apt)
(MACHINE Dmu70e, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the table reference)
(PROGRAMMED POINT tool tip)
(ARCS AND CURVES in chords that leave them by at most 0.01)
(CL data of SolidWorks CAM, by its own evidence)
(2 arcs, sense by form only, 0 arcs confirmed)
(AXIS C + turns the table left-handed about +Z: word as in ISO 841)
(AXIS B + turns the table left-handed about [0.0000, 0.7071, -0.7071]: word as in ISO 841)
(AXIS X + moves the tool along +X: word as in ISO 841)
(AXIS Y + moves the tool along +Y: word as in ISO 841)
(AXIS Z + moves the tool along +Z: word as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg)
(ROTARY WORDS are absolute and count on past 360: the axes must not be wrapped)
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the table reference; do not touch off again)
(the entries of C and B in G54 must be zero)
(T4 D10 R0 L120 H4, 1 operation, tip Z -14.99 to 60)
(ASSUMED the points of the CL data count from the part zero)
(ASSUMED part_origin 0, 0, 0: the part zero is the table's reference point)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach from 50 mm along the tool axis)
([HOLDER=H1] 10MM END MILL)
(Stock Size X40. Y60. Z40.)
N1 G21 G17 G40 G49 G80 G90 G94 G54 G64 P0.01
M9
G53 G0 Z0
T4 M6
G53 G0 Z0
G43 H4
S3000 M3
G0 B0 C90
X20 Y-12.5
Z25
M8
Z3
G1 Z-2 F150.5
X20.434 Y-12.462 F601.25
X20.855 Y-12.349
X21.25 Y-12.165
X21.607 Y-11.915
X21.915 Y-11.607
X22.165 Y-11.25
X22.349 Y-10.855
X22.462 Y-10.434
X22.5 Y-10
X22.462 Y-9.566
X22.349 Y-9.145
X22.165 Y-8.75
X21.915 Y-8.393
X21.607 Y-8.085
X21.25 Y-7.835
X20.855 Y-7.651
X20.434 Y-7.538
X20 Y-7.5
X19.566 Y-7.538
X19.145 Y-7.651
X18.75 Y-7.835
X18.393 Y-8.085
X18.085 Y-8.393
X17.835 Y-8.75
X17.651 Y-9.145
X17.538 Y-9.566
X17.5 Y-10
X17.538 Y-10.434
X17.651 Y-10.855
X17.835 Y-11.25
X18.085 Y-11.607
X18.393 Y-11.915
X18.75 Y-12.165
X19.145 Y-12.349
X19.566 Y-12.462
X20 Y-12.5
Y-10
G0 Z60
Y-30
Z3
G1 Z-5 F200.05
G0 Z3
Z-4.5
G1 Z-9
G0 Z3
Z-8.5
G1 Z-12
G0 Z25
M9
Z125
G53 G0 Z0
G0 B180
X-20 Y160
Z230
M8
Z195
G1 Z188 F300
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
X-30 Y160
Z230
M9
G0 Z330
G53 G0 Z0
M5
M2
