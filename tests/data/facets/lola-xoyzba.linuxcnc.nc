(PROGRAM FACETS)
(CL FILE facets.aptsource)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of CATIA, recognised from the file)
(KINEMATICS *)
(AXIS X+ moves the table against +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(AXIS B+ rotates the tool right-handed about +Y, as in ISO 841)
(AXIS A+ rotates the tool right-handed about +X, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(the entries of B and A in G54 must be zero)
(T5 DIA 16 R0 L132.5 H5, 3 operations, tip Z -13.517 to 58.514)
(T5 posted with L = 132.5: H5 must hold exactly this)
(T6 DIA 6 R0 L97.25 H6, 1 operation, tip Z -4.281 to 61.011)
(T6 posted with L = 97.25: H6 must hold exactly this)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T5 M6
G53 G0 Z0
G43 H5
o1 if [[ABS[#5403 - 132.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 132.5] GT 0.01]]
(abort, T5 was posted with L = 132.5 mm: the length in the tool table differs)
o1 endif
S4500 M3
G0 A-9.2399 B26.5487
X104.067 Y28.622
Z41.198
M8
G1 X76.715 Y18.666 Z-13.545 F600
X94.968 Y25.31 Z-23.874 F850
X88.812 Y42.224
G0 X117.046 Y52.501 Z32.635
M9
G53 G0 Z0
G0 A-21.8046 B-25.4052
X-87.019 Y90.146
Z32.513
M8
G1 X-62.323 Y67.117 Z-19.485 F600
X-75.817 Y79.7 Z-31.467 F850
X-88.093 Y66.536
G0 X-113.586 Y90.308 Z22.208
M9
G53 G0 Z0
M5
M0
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
(T5 stays in the spindle)
G43 H5
o2 if [[ABS[#5403 - 132.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 132.5] GT 0.01]]
(abort, T5 was posted with L = 132.5 mm: the length in the tool table differs)
o2 endif
S4500 M3
G0 A22.6175 B8.2477
X22.844 Y-94.339
Z47.059
M8
G1 X14.634 Y-70.495 Z-9.581 F600
X21.178 Y-89.498 Z-18.529 F850
X38.197 Y-83.638
G0 X46.672 Y-108.251 Z39.938
M9
N3 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000003 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000003 endif
M9
G53 G0 Z0
M5
T6 M6
G53 G0 Z0
G43 H6
o3 if [[ABS[#5403 - 97.25] GT 0.01] AND [ABS[[#5403 * 25.4] - 97.25] GT 0.01]]
(abort, T6 was posted with L = 97.25 mm: the length in the tool table differs)
o3 endif
S9000 M3
G0 A4.2453 B-11.7678
X-45.086 Y-7.988
Z58.706
M8
G1 X-32.476 Y-3.399 Z-1.824 F600
X-52.659 Y-10.745 Z-6.586 F850
X-46.503 Y-27.659
G0 X-59.52 Y-32.397 Z55.897
M9
N4 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000004 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000004 endif
M9
G53 G0 Z0
M5
T5 M6
G53 G0 Z0
G43 H5
o4 if [[ABS[#5403 - 132.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 132.5] GT 0.01]]
(abort, T5 was posted with L = 132.5 mm: the length in the tool table differs)
o4 endif
S4200 M3
G0 A-5.8906 B-40.6489
X-143.555 Y31.262
Z15.208
M8
G1 X-103.38 Y24.899 Z-31.584 F600
X-119.779 Y27.496 Z-46.018 F850
X-122.595 Y9.718
G0 X-164.066 Y16.286 Z2.284
M9
G53 G0 Z0
M5
M2
