(PROGRAM SHOP)
(CL FILE shop.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE auto [axes])
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z50 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.01 for arcs and curves)
(LinuxCNC has no smoothing levels: smoothing is left out, `path_tolerance` is in force)
(LinuxCNC has no program numbers: `control.program_number` is left out)
(LinuxCNC has no swivel data: `control.swivel_data` is left out)
(operation 1 FACE_ROUGH: path tolerance 0.05 mm)
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
(valid only for part origin X0 Y0 Z50 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T1 mill 12 DIA 12 L120 H1, 1 operation, tip Z -2 to 60)
(T2 drill 8 L140 H2, 1 operation, tip Z -26 to 60)
(T3 ball 6 DIA 6 R3 L110 H3, 1 operation, tip Z 19.799 to 50.912)
(CONDITION the tool table has the lengths of the tools [Z])
(CONDITION the tool table is in the unit of the machine [LINEAR_UNITS])
(CONDITION the tool table has lengths in Z alone: G43 takes its other columns as well)
(CONDITION M6 keeps the modes [REMAP], and has room where the axes are, or where it moves them [TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30])
(CONDITION S is within the limits of the spindle [MIN_, MAX_FORWARD_VELOCITY])
(CONDITION no external offset of an axis is on [HAL pins axis.*.eoffset])
(CONDITION no adaptive feed is on [M52 P0])
(CONDITION the tool is in spindle 0)
(ASSUMED retract to machine coordinate 0 mm)
(ASSUMED approach distance 50 mm along the tool axis)
(ASSUMED the control has no kinematics with tip control in force, from its start [`control.tip_control`])
(OPERATION FACE_ROUGH)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.05
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
(T1 mill 12)
T1 M6
G53 G0 Z0
G43 H1
S4000 M3
G0 B0 C0
X-40 Y-10
Z60
M8
Z2
G1 Z-2 F400
X40 F1200
Y10
X-40
G0 Z60
M9
(OPERATION DRILL)
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
M5
(T2 drill 8)
T2 M6
G53 G0 Z0
G43 H2
S2500 M3
G0 B0 C0
X20 Y0
Z60
M8
Z8
G98 G81 X20 Y0 Z-26 R1 F250
X-20
G80
G0 Z60
M9
(OPERATION FINISH_45)
N3 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000003 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000003 endif
M9
G53 G0 Z0
M5
(T3 ball 6)
T3 M6
G53 G0 Z0
G43 H3
S9000 M3
G0 B45 C0
X70.711 Y-20
Z101.289
M8
Z61.289
G1 Z58.289 F500
Y20 F1800
X71.711
Y-20
G0 Z100.289
M9
Z160.289
G53 G0 Z0
M5
M2
