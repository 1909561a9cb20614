//! States of Fanuc 30i and related controls.

use super::super::dialects::ControlFunction;
use super::StateHandling::{Compared, InWord, Noted, Set, SetWhere, Stated, StatedUnless};
use super::StateUse::{Compensation, Cycles, Every, Planes, Rotary, TipControl};
use super::{LENGTH, Settled, StateRow, state};

const CODES: &str = "B-63944EN/02 (2004), list of G codes";
const OPTION: &str = "without the option its code raises an alarm";
const PARAMETER: &str = "it is a parameter, which a program does not change";

#[rustfmt::skip]
pub(super) const STATES: &[StateRow] = &[
    state("G81 to G89", "a block of X and Y makes a hole", InWord("the first motion has its own G0, which ends a cycle"), Every, CODES),
    state("G98, G99", "level after a hole", InWord("in the block of each cycle"), Cycles, CODES),
    state("F of G93", "time of a block", InWord("F in each block"), Rotary, CODES),
    state("3401#0", "numbers without a point are least increments", InWord("every number has a point"), Every, CODES),
    state("G20, G21", "unit of lengths", Set("G20 or G21"), Every, CODES),
    state("G18, G19", "plane of arcs, cycles and compensation", Set("G17"), Every, CODES),
    state("G41, G42", "the path is offset from the words", Set("G40"), Every, CODES),
    state("G43, G43.4, G43.5", "Z is offset from its words, or they are tip coordinates", Set("G49"), Every, "B-63844EN, p. 204"),
    state("G91", "words are distances", Set("G90"), Every, CODES),
    state("G93, G95", "meaning of F", Set("G94"), Every, CODES),
    state("G54 to G59, G54.1", "zero of the words", Set("the code of `work_offset`"), Every, CODES),
    state("G51 scaling", "lengths of words", SetWhere(ControlFunction::Scaling, "G50"), Every, CODES).because(OPTION),
    state("G68, G68.2 rotation", "direction of words", SetWhere(ControlFunction::Rotation, "G69"), Every, CODES).because(OPTION),
    state("G16 polar coordinates", "words are a radius and an angle", SetWhere(ControlFunction::Polar, "G15"), Every, CODES).because(OPTION),
    state("G54.4 workpiece setting error compensation", "place and direction of the part (11200#0)", SetWhere(ControlFunction::SettingError, "G54.4 P0"), Every, "A-79634E")
        .because(OPTION),
    state("G05.1 smoothing", "deviation from the path", SetWhere(ControlFunction::Smoothing, "G05.1 Q0"), Every, CODES).because(OPTION),
    state("tool offsets", "length of H", Compared(LENGTH, "the offsets H hold the lengths of the tools"), Every, "B-63944EN/02 (2004), custom macro, system variables")
        .because("the length is that of the real tool"),
    state("1006#3", "X is a diameter", StatedUnless(Settled::RadiusWords, "words of X are radii (parameter 1006#3, DIA, is 0)"), Every, "B-62754EN/01, p. 104").because(PARAMETER),
    state("1401#1", "axes of a rapid arrive together, or not", StatedUnless(Settled::LooseRapids, "the axes of a rapid arrive together (parameter 1401#1, LRP, is 1)"), Every, "B-63944EN/02 (2004), p. 48").because(PARAMETER),
    state("1401#1 = 0", "way of a rapid out of a tilted cut", StatedUnless(Settled::StatedRapids, "the axes of a rapid arrive together (parameter 1401#1, LRP, is 1), or there is room for each on its own"), Rotary, "B-63944EN/02 (2004), p. 48").because(PARAMETER),
    state("1008#0, #1", "words of rotary axes beyond a revolution", Noted(|codes| codes.rotary_note), Rotary, "B-63534EN, p. 531").because(PARAMETER),
    state("5004#2, D", "offset of G41 and G42", Noted(|codes| codes.radius_data[0]), Compensation, "").because(PARAMETER),
    state("5148", "direction off the wall of a bore", Noted(|_| "the direction that the line FINE BORING of the header states"), Cycles, "15i operator's manual, p. 315, of 6240")
        .because(PARAMETER),
    state("5006#6", "axes that move where G43.4 is commanded", Noted(|codes| codes.tip.as_ref().map_or("", |tip| tip.note)), TipControl, "A-79348E, p. 16").because(PARAMETER),
    state("19665, 19666, 19680 to 19714", "kinds, directions and centres of the rotary axes; length of the tool holder", Stated("parameters 19665, 19666 and 19680 to 19714 are those of this machine, 19666 as H counts"), TipControl, "A-79348E, p. 72 to 83")
        .because(PARAMETER),
    state("19696#5", "frame of the words under tip control", Stated("parameter 19696#5 is that of the frame under LINEAR WORDS"), TipControl, "B-63783EN, p. 1116; A-79348E, p. 19")
        .because(PARAMETER),
    state("pose of G53.1", "which of two poses the rotary axes take", Noted(|codes| codes.plane.as_ref().map_or("", |plane| plane.note)), Planes, "B-63784EN, tool axis direction control")
        .because("positions of axes are variables by the builder's numbers"),
    state("M29, 5210, 5200#0", "G84 cuts a thread with a floating tap, or a rigid one", Stated("M29 is the code of rigid tapping (parameter 5210)"), Cycles, "").because(PARAMETER),
    state("macro of M6 (6071 to 6089)", "modes after the tool change", Stated("M6 keeps the modes of the program, and has room where the rotary axes are"), Every, "").because(PARAMETER),
    state("5001#0, #1", "axis of G43", Stated("G43 offsets Z (parameter 5001#0 = 0, #1 = 0)"), Every, "").because(PARAMETER),
    state("G51.1, MIRROR IMAGE", "direction of words", Stated("no mirror image is on (G51.1, setting MIRROR IMAGE, parameter 0012#0)"), Every, "")
        .because("G50.1 needs words of axes, and the setting has no code"),
    state("G52, G92, EXT", "zero of the words", Stated("nothing lies over the work offset by G52, G92 or EXT that is not meant"), Every, "")
        .because("they hold data of the shop, and their variables count axes by the builder's numbers"),
    state("G54.2", "zero of the words follows the table", Stated("no rotary table dynamic fixture offset is on (G54.2)"), Rotary, CODES).because(OPTION),
    state("G66", "each motion calls a macro", Stated("no modal call of a macro is on (G66)"), Every, CODES).because(OPTION),
    state("G96", "S is a cutting speed", Stated("S is rev/min (G97)"), Every, CODES).because(OPTION),
];
