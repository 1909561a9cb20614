(PROGRAM FACETS)
(CL FILE facets.aptsource)
(MACHINE Dmu70e, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of CATIA, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T5 DIA 16 R0 L132.5 H5, 3 operations, tip Z -13.517 to 58.514)
(T6 DIA 6 R0 L97.25 H6, 1 operation, tip Z -4.281 to 61.011)
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
S4500 M3
G0 B40.0133 C34.4378
X83.382 Y12.486
Z88.929
M8
G1 Z26.929 F600
X104.688 Y17.972 F850
X100.2 Y35.403
G0 Z90.929
M9
G53 G0 Z0
G0 B47.3638 C154.2303
X94.366 Y22.375
Z98.236
M8
G1 Z36.236 F600
X115.379 Y28.892 F850
X110.047 Y46.084
G0 Z100.236
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
S4500 M3
G0 B34.1989 C301.2722
X76.454 Y7.304
Z83.809
M8
G1 Z21.809 F600
X97.951 Y11.98 F850
X94.125 Y29.569
G0 Z85.809
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
S9000 M3
G0 B17.7131 C206.2876
X43.351 Y-3.185
Z68.326
M8
G1 Z6.326 F600
X65.218 Y-0.776 F850
X63.247 Y17.116
G0 Z70.326
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
S4200 M3
G0 B59.3748 C192.9554
X107.214 Y34.141
Z111.999
M8
G1 Z49.999 F600
X127.618 Y42.367 F850
X120.888 Y59.061
G0 Z113.999
M9
G53 G0 Z0
M5
M2
