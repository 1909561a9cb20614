(PROGRAM TWO_TOOLS)
(CL FILE two_tools.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.01 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T1 DIA 20 R0 L120 H1, 1 operation, tip Z -26 to 49.301)
(T2 DIA 8 R0 L95 H2, 1 operation, tip Z -3.759 to 52.623)
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
(OPERATION TILTED_FACE)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S3000 M3
G0 B30 C0
X71.66 Y-28
Z75.096
M8
G1 Z25.096 F1000
X135.66 F900
Y-14
X71.66
Y0
X135.66
Y14
X71.66
Y28
X135.66
G0 Z85.096
M9
G53 G0 Z0
M5
M0
(OPERATION TILTED_SLOT)
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
T2 M6
G53 G0 Z0
G43 H2
S7000 M3
G0 B20 C-90
X70.097 Y-30
Z65.886
M8
G1 Z15.887 F500
Y-10 Z14.887 F350
Y-30 Z13.887
Y-10 Z12.886
Y-30 Z11.886
Y-10
Y-30
G0 Z71.887
M9
G53 G0 Z0
M5
M2
