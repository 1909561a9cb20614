//! States of LinuxCNC.

use super::StateHandling::{Compared, InWord, Noted, Set, Stated};
use super::StateUse::{Compensation, Cycles, Every, Rotary};
use super::{LENGTH, StateRow, state};

const STOP: &str = "interp_convert.cc, convert_stop";
const CODES: &str = "LinuxCNC 2.9 G-code documentation";
const PARAMETERS: &str = "LinuxCNC 2.9 G-code overview, numbered parameters";

#[rustfmt::skip]
pub(super) const STATES: &[StateRow] = &[
    state("G81 to G89", "a block of X and Y makes a hole", InWord("the first motion has its own G0, which ends a cycle"), Every, CODES),
    state("G98, G99", "level after a hole", InWord("in the block of each cycle"), Cycles, CODES),
    state("F of G93", "time of a block", InWord("F in each block"), Rotary, CODES),
    state("G20, G21", "unit of lengths; M2 keeps it", Set("G20 or G21"), Every, STOP),
    state("G18, G19", "plane of arcs, cycles and compensation", Set("G17"), Every, STOP),
    state("G41, G42", "the path is offset from the words", Set("G40"), Every, STOP),
    state("G43", "Z is offset from its words; M2 keeps it", Set("G49"), Every, STOP),
    state("G91", "words are distances", Set("G90"), Every, STOP),
    state("G90.1", "I J K are absolute; M2 keeps it", Set("G91.1"), Every, STOP),
    state("G93, G95", "meaning of F", Set("G94"), Every, STOP),
    state("G7", "X is a diameter; M2 keeps it", Set("G8"), Every, STOP),
    state("G96", "S is a cutting speed; M2 keeps it", Set("G97"), Every, STOP),
    state("G54 to G59.3", "zero of the words", Set("the code of `work_offset`"), Every, STOP),
    state("G61, G64", "corners are rounded; M2 keeps it", Set("G64 P"), Every, STOP),
    state("kinematics with tip control", "linear words are tip coordinates, from the start of the control as well", Set("the off code of `control.tip_control`; \"none\" and \"always\" are stated in the header"), Rotary, "linuxcnc.org, switchable kinematics; configs/sim/axis/vismach/5axis"),
    state("G92, G52 (#5210)", "zero of the words; survives M2", Compared("#5210", "no G92 or G52 is active (#5210 = 0)"), Every, PARAMETERS)
        .because("G92.1 would clear what the shop has set"),
    state("R of the work offset (#5230, 20 more for each further offset)", "rotates the words about the zero", Compared("the parameter of the offset in force", "the R of the work offset is 0 (#5230 for G54)"), Every, PARAMETERS)
        .because("G10 L2 R0 would clear what a probing screen has set"),
    state("tool table", "length of H", Compared(LENGTH, "the tool table has the lengths of the tools (Z)"), Every, "LinuxCNC 2.9, tool compensation")
        .because("the length is that of the real tool"),
    state("LINEAR_UNITS", "unit of the tool table", Stated("the tool table is in the unit of the machine (LINEAR_UNITS)"), Every, "LinuxCNC 2.9, INI configuration, TRAJ section")
        .because("no parameter has the unit of the table"),
    state("X, Y and rotary columns of the tool table", "G43 moves these axes as well", Stated("the tool table has lengths in Z alone: G43 takes its other columns as well"), Every, "interp_convert.cc, convert_tool_length_offset")
        .because("the guard compares the length"),
    state("REMAP of M6, TOOL_CHANGE_POSITION, TOOL_CHANGE_QUILL_UP, TOOL_CHANGE_AT_G30", "axes that M6 moves", Stated("M6 keeps the modes (REMAP), and has room where the axes are, or where it moves them (TOOL_CHANGE_POSITION, _QUILL_UP, _AT_G30)"), Every, "LinuxCNC 2.9, INI configuration, EMCIO and RS274NGC sections")
        .because("they are entries of the INI file that no code reads"),
    state("MIN_FORWARD_VELOCITY, MAX_FORWARD_VELOCITY", "speed of the spindle", Stated("S is within the limits of the spindle (MIN_, MAX_FORWARD_VELOCITY)"), Every, "LinuxCNC 2.9, INI configuration, SPINDLE section")
        .because("they are entries of the INI file that no code reads"),
    state("external offsets", "place of the axes", Stated("no external offset of an axis is on (HAL pins axis.*.eoffset)"), Every, "linuxcnc.org, external offsets")
        .because("no parameter of a program has them"),
    state("M52", "F is scaled by a signal", Stated("no adaptive feed is on (M52 P0)"), Every, STOP)
        .because("machines that have it need it on"),
    state("WRAPPED_ROTARY", "words of rotary axes beyond a revolution", Noted(|codes| codes.rotary_note), Rotary, "linuxcnc.org, INI configuration")
        .because("it is an entry of the INI file that no code reads"),
    state("diameter in the tool table", "offset of G41 D and G42 D", Noted(|codes| codes.radius_data[0]), Compensation, "LinuxCNC handbook, nodes 85 and 86")
        .because("#5410 is that of the tool in the spindle, not of D"),
    state("spindle", "S and M3 without $ are those of spindle 0", Stated("the tool is in spindle 0"), Every, CODES)
        .because("a machine with one spindle takes no $"),
];
