(PROGRAM PADS)
(CL FILE pads.cls)
(MACHINE LolaXoyzba, CONTROL LinuxCNC, MODE axes)
(UNITS mm, WORK OFFSET G57)
(PART ORIGIN X12.5 Y-8 Z40 from the reference point of the table)
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
(G57 must hold X20 Y-15 Z-520)
(the entries of B and A in G57 must be zero)
(T21 bull 12 DIA 12 R1 L120.25 H21, 1 operation, tip Z -9.4 to 0.521)
(T21 posted with L = 120.25: H21 must hold exactly this)
(T22 DIA 12 R1 L96.5 H52, 1 operation, tip Z -3.3 to -1.375)
(T22 posted with L = 96.5: H52 must hold exactly this; no block of this program compares it)
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
o1 if [[ABS[#5403 - 120.25] GT 0.01] AND [ABS[[#5403 * 25.4] - 120.25] GT 0.01]]
(abort, T21 was posted with L = 120.25 mm: the length in the tool table differs)
o1 endif
S5200 M3
G0 A18.266 B2.2556
X7.995 Y-63.387
Z-5.627
M8
G1 X7.864 Y-62.29 Z-8.948 F300
X22.064 Y-60.597 F700
X22.138 Y-61.224 Z-7.05
M9
G0 X24.942 Y-84.731 Z64.116
G53 G0 Z0
G0 A35.8066 B4.9348
X10.74 Y-121.986
Z-5.421
M8
X8.647 Y-104.434 Z-29.661
G1 X14.559 Y-101.652 Z-32.489 F300
X28.758 Y-99.959 F700
X28.898 Y-101.129 Z-30.873
M9
G0 X34.13 Y-145.008 Z29.726
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
G0 A-15.5586 B-2.129
X-8.957 Y60.13
Z21.98
M8
G1 X-7.884 Y52.084 Z-6.9 F300
X-22.058 Y50.192 F700
X-22.13 Y50.729 Z-4.975
M9
G0 X-24.814 Y70.846 Z67.227
G53 G0 Z0
M5
G53 G0 X0 Y240
M2
