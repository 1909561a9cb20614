(PROGRAM NEST)
(CL FILE nest.apt)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of SolidWorks CAM, recognised from the file)
(2 arcs, sense by form, not confirmed by a neighbouring line)
(CSYS changes 1 time: all points are read in one common frame)
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
(T4 DIA 10 R0 L120 H4, 2 operations, tip Z -15 to 60)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED points of the CL data are coordinates from the part zero)
(ASSUMED work offset G54)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
([HOLDER=H1] 10MM END MILL)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T4 M6
G53 G0 Z0
(Stock Size X40. Y60. Z40.)
G43 H4
S3000 M3
G0 B0 C0
X12.5 Y20
Z25
M8
Z3
G1 Z-2 F150.5
G3 X12.5 Y20 I-2.5 J0 F601.25
G1 X10
G0 Z60
X30
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
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
(T4 stays in the spindle)
G43 H4
S3000 M3
G0 B90 C0
X160 Y20
Z230
M8
Z195
G1 Z188 F300
G3 X160 Y30 I0 J5
G1 Z230
M9
G0 Z330
G53 G0 Z0
M5
M2
