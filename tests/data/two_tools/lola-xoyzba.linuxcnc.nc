(PROGRAM TWO_TOOLS)
(CL FILE two_tools.cls)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(CL data of NX, recognised from the file)
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
(T1 DIA 20 R0 L120 H1, 1 operation, tip Z -26 to 49.301)
(T1 posted with L = 120: H1 must hold exactly this)
(T2 DIA 8 R0 L95 H2, 1 operation, tip Z -3.759 to 52.623)
(T2 posted with L = 95: H2 must hold exactly this)
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
o1 if [[ABS[#5403 - 120] GT 0.01] AND [ABS[[#5403 * 25.4] - 120] GT 0.01]]
(abort, T1 was posted with L = 120 mm: the length in the tool table differs)
o1 endif
S3000 M3
G0 A0 B30
X84.608 Y-28
Z33.224
M8
G1 X59.608 Z-10.077 F1000
X115.033 Z-42.077 F900
Y-14
X59.608 Z-10.077
Y0
X115.033 Z-42.077
Y14
X59.608 Z-10.077
Y28
X115.033 Z-42.077
G0 X145.033 Z9.885
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
o2 if [[ABS[#5403 - 95] GT 0.01] AND [ABS[[#5403 * 25.4] - 95] GT 0.01]]
(abort, T2 was posted with L = 95 mm: the length in the tool table differs)
o2 endif
S7000 M3
G0 A20 B0
X-30 Y-69.593
Z41.255
M8
G1 Y-52.492 Z-5.729 F500
X-10 Y-52.15 Z-6.669 F350
X-30 Y-51.808 Z-7.609
X-10 Y-51.466 Z-8.548
X-30 Y-51.124 Z-9.488
X-10
X-30
G0 Y-71.645 Z46.894
M9
G53 G0 Z0
M5
M2
