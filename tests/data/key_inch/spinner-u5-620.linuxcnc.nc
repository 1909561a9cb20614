(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE SpinnerU5620, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.0004 for arcs and curves)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(DIMENSIONS d = 150 mm)
(AXIS C+ rotates the table left-handed about +Z, as in ISO 841)
(AXIS B+ rotates the table left-handed about +Y, as in ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Y+ moves the tool along +Y, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.0004 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [X Y Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of C and B in G54 must be zero)
(T12 DIA 0.375 R0 L4.75 H12, 1 operation, tip Z -0.2227 to 2.8269)
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
(OPERATION KEYWAY)
N1 G20 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.000394
o1000001 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]
(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)
o1000001 endif
M9
G53 G0 Z0
T12 M6
G53 G0 Z0
G43 H12
S3800 M4
G0 B3.3 C90
X-0.0904 Y1.137
Z2.8166
M7
G1 Z0.3165 F6.5
G93 X0.0264 Y1.0828 Z0.3154 B4.24 F380.601
X0.1433 Y1.0286 Z0.3166 B5.18 F380.601
X0.2601 Y0.9743 Z0.3201 B6.12 F380.601
X0.3769 Y0.9201 Z0.326 B7.06 F380.601
X0.4935 Y0.8659 Z0.3342 B8 F380.601
X0.6106 Y0.8117 Z0.3402 B8.94 F378.443
X0.7277 Y0.7575 Z0.3486 B9.88 F378.443
X0.8447 Y0.7032 Z0.3593 B10.82 F378.443
X0.9614 Y0.649 Z0.3724 B11.76 F378.443
X1.078 Y0.5948 Z0.3878 B12.7 F378.443
X1.1954 Y0.5406 Z0.4012 B13.64 F374.235
X1.3127 Y0.4864 Z0.4169 B14.58 F374.235
X1.4297 Y0.4321 Z0.435 B15.52 F374.235
X1.5465 Y0.3779 Z0.4554 B16.46 F374.235
X1.663 Y0.3237 Z0.4782 B17.4 F374.235
X1.7805 Y0.2695 Z0.4991 B18.34 F368.179
X1.8979 Y0.2153 Z0.5224 B19.28 F368.179
X2.0149 Y0.161 Z0.5481 B20.22 F368.179
X2.1316 Y0.1068 Z0.5762 B21.16 F368.179
X2.2479 Y0.0526 Z0.6066 B22.1 F368.179
X2.3656 Y-0.0016 Z0.6353 B23.04 F360.543
X2.4829 Y-0.0558 Z0.6664 B23.98 F360.543
X2.5998 Y-0.1101 Z0.7 B24.92 F360.543
X2.7163 Y-0.1643 Z0.7359 B25.86 F360.543
X2.8323 Y-0.2185 Z0.7743 B26.8 F360.543
X2.9498 Y-0.2727 Z0.8112 B27.74 F351.634
X3.0669 Y-0.3269 Z0.8505 B28.68 F351.634
X3.1835 Y-0.3812 Z0.8922 B29.62 F351.634
X3.2995 Y-0.4354 Z0.9365 B30.56 F351.634
X3.415 Y-0.4896 Z0.9832 B31.5 F351.634
X3.5322 Y-0.5438 Z1.0285 B32.44 F341.767
X3.6488 Y-0.598 Z1.0763 B33.38 F341.767
X3.7648 Y-0.6523 Z1.1267 B34.32 F341.767
X3.8801 Y-0.7065 Z1.1796 B35.26 F341.767
X3.9947 Y-0.7607 Z1.235 B36.2 F341.767
G94 Y-1.0734 F22.75
G0 Z3.985
M9
G53 G0 Z0
M5
M2
