(PROGRAM KEY)
(CL FILE key_inch.cls)
(MACHINE MultiProDesk, CONTROL LinuxCNC, MODE axes)
(UNITS in, WORK OFFSET G54)
(PART ORIGIN X0 Y0 Z0 from the reference point of the table)
(PROGRAMMED POINT tool tip)
(TOLERANCE 0.0004 for arcs and curves)
(CL data of NX, recognised from the file)
(KINEMATICS *)
(AXIS A+ rotates the table right-handed about +X, opposite to ISO 841)
(AXIS Y+ moves the table along +Y, opposite to ISO 841)
(AXIS X+ moves the tool along +X, as in ISO 841)
(AXIS Z+ moves the tool along +Z, as in ISO 841)
(WHILE A ROTARY AXIS MOVES the tip stays within 0.0004 of its line at feed, the tool axis within 0.1 deg of its great circle)
(ROTARY WORDS are absolute and may go below 0 or beyond 360: the axes must not be wrapped [WRAPPED_ROTARY = 0])
(linear limits not checked: no travel declared [Y X Z])
(valid only for part origin X0 Y0 Z0 from the reference point of the table; do not touch off again)
(the entries of A in G54 must be zero)
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
G0 A3.3
X-1.137 Y0.4304
Z2.8068
M7
G1 Z0.3067 F6.5
G93 X-1.0466 Y0.3967 Z0.2946 A4.8667 F228.361
X-0.9563 Y0.3626 Z0.2846 A6.4333 F228.361
X-0.8659 Y0.3284 Z0.2767 A8 F228.361
X-0.7755 Y0.2928 Z0.2634 A9.5667 F227.066
X-0.6852 Y0.2567 Z0.2523 A11.1333 F227.066
X-0.5948 Y0.2203 Z0.2433 A12.7 F227.066
X-0.5044 Y0.1817 Z0.2293 A14.2667 F224.541
X-0.4141 Y0.1426 Z0.2175 A15.8333 F224.541
X-0.3237 Y0.103 Z0.208 A17.4 F224.541
X-0.2333 Y0.0606 Z0.1938 A18.9667 F220.907
X-0.143 Y0.0175 Z0.182 A20.5333 F220.907
X-0.0526 Y-0.0261 Z0.1727 A22.1 F220.907
X0.0152 Y-0.0614 Z0.1622 A23.275 F288.434
X0.083 Y-0.0971 Z0.1533 A24.45 F288.434
X0.1507 Y-0.1332 Z0.1459 A25.625 F288.434
X0.2185 Y-0.1696 Z0.14 A26.8 F288.434
X0.2863 Y-0.2089 Z0.1307 A27.975 F281.307
X0.3541 Y-0.2487 Z0.1231 A29.15 F281.307
X0.4218 Y-0.2888 Z0.1171 A30.325 F281.307
X0.4896 Y-0.3293 Z0.1129 A31.5 F281.307
X0.5574 Y-0.3731 Z0.1056 A32.675 F273.414
X0.6252 Y-0.4174 Z0.1002 A33.85 F273.414
X0.6929 Y-0.462 Z0.0967 A35.025 F273.414
X0.7607 Y-0.5068 Z0.095 A36.2 F273.414
G94 X1.0734 F22.75
G0 Y-0.5069 Z2.845
M9
G53 G0 Z0
M5
M2
