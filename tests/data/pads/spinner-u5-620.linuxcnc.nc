(PROGRAM PADS)
(CL FILE pads.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G57)
(PART ORIGIN X12.5 Y-8 Z40 from the reference point of the table)
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
(valid only for part origin X12.5 Y-8 Z40 from the reference point of the table; do not touch off again)
(G57 must hold X20 Y-15 Z-520)
(the entries of C and B in G57 must be zero)
(T21 bull 12 DIA 12 R1 L120.25 H21, 1 operation, tip Z -9.4 to 0.521)
(T22 DIA 12 R1 L96.5 H52, 1 operation, tip Z -3.3 to -1.375)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
(OPERATION SOUTH)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G57 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
(T21 bull 12)
T21 M6
G53 G0 Z0
G43 H21
S5200 M3
G0 B18.4 C-83.2
X55.604 Y19.898
Z17.278
M8
G1 Z13.778 F300
Y34.198 F700
Z15.778
M9
G0 Z90.778
G53 G0 Z0
G0 B36.1
X91.167 Y15.685
Z71.321
M8
Z41.321
G1 Y21.885 Z37.821 F300
Y36.185 F700
Z39.821
M9
G0 Z114.821
(OPERATION NORTH)
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G57 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
M5
T22 M6
G53 G0 Z0
G43 H52
S6100 M3
G0 B15.7 C-262.4
X34.499 Y-2.406
Z35.52
M8
G1 Z5.52 F300
Y11.894 F700
Z7.52
M9
G0 Z82.52
G53 G0 Z0
M5
G53 G0 X0 Y240
M2
