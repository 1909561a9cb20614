(PROGRAM PLATE)
(CL FILE plate.ncl)
(MACHINE Dmu70e, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.001 for arcs and curves)
(CL data of Creo, recognised from the file)
(1 arc, sense by form, confirmed by 1 of 1 neighbouring lines)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about [0.0000, 0.7071, -0.7071], as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.001 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS of C are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T3 DIA 0.25 L4 H3, 1 operation, tip Z -0.4 to 1)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 in)
(ASSUMED approach distance 1.968504 in along the tool axis)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
N1 G20 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.000394
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T3 M6
G53 G0 Z0
G43 H3
S3000 M3
G0 B0 C0
X0 Y0.5
Z1
G1 Z-0.1 F20
X1
G2 X1 Y0 I0 J-0.25
G1 X0
Y-0.25
Z1
G0 X0.25 Y0.25
Z0.5
G98 G73 X0.25 Y0.25 Z-0.4 R0.1 Q0.15 F4
X0.75
G80
G0 Z1
Z3
G53 G0 Z0
M5
M2
