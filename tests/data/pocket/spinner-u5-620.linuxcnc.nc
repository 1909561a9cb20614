(PROGRAM without name)
(CL FILE pocket.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.05 for arcs and curves)
(CL data of NX, recognised from the file)
(unit of the CL data is mm, as given; the CL file states none)
(3 arcs, sense by form, confirmed by 3 of 3 neighbouring lines)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.05 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T1 DIA 10 R0 L110 H1, 1 operation, tip Z -2 to 20)
(T2 DIA 5 L130 H2, 2 operations, tip Z -15 to 60)
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
(OPERATION POCKET)
N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T1 M6
G53 G0 Z0
G43 H1
S4000 M3
G0 B0 C0
X8 Y0
Z10
M8
Z1
G3 X8 Y0 Z-1.4 I-8 J0 F200
X0 Y8 Z-2 I-8 J0
G1 X-20 F600
G3 X-20 Y-8 I0 J-8
G1 X0
G2 X5 Y-13 I0 J-5
G1 Y-20
X5.081 Y-21.378
X5.315 Y-22.528
X5.688 Y-23.469
X6.185 Y-24.222
X6.794 Y-24.809
X7.5 Y-25.25
X8.727 Y-25.684
X10.188 Y-25.906
X11.93 Y-25.988
X14 Y-26
Z20
M9
G0 Z70
(OPERATION HOLES)
N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000002 endif
M9
G53 G0 Z0
M5
T2 M6
G53 G0 Z0
G43 H2
S2500 M3
G0 B0 C0
X-30 Y15
Z20
M8
G98 G83 X-30 Y15 Z-15 R2 Q6 F150
X-10
G80
G99 G82 X-10 Y25 Z-9 R-3 P0.5 F150
G80
G0 Z7
G99 G82 X10 Y25 Z1 R7 P0.5 F150
G80
G4 P1.5
M9
G0 Z57
N3 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01
o1000003 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000003 endif
M9
G53 G0 Z0
(T2 stays in the spindle)
G43 H2
S2500 M3
G0 B0 C0
X0 Y0
Z110
M8
Z60
M9
Z110
G53 G0 Z0
M5
M2
