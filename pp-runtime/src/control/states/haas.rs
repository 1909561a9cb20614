//! States of the Haas NGC.

use super::super::dialects::ControlFunction;
use super::StateHandling::{Compared, InWord, Noted, Set, SetWhere, Stated, StatedUnless};
use super::StateUse::{Compensation, Cycles, Every, Kinematics, Planes, Rotary, TipControl};
use super::{LENGTH, Settled, StateRow, state};

const CODES: &str = "mill manual 96-8000, G codes";
const SETTINGS: &str = "mill operator's manual (NGC, 2017), p. 375 to 400, settings";
const DYNAMIC: &str = "UMC manual, p. 56; haascnc.com, page of G254";
const OPTION: &str = "without the option its code raises an alarm";
const SETTING: &str = "it is a setting, which a program does not change";

#[rustfmt::skip]
pub(super) const STATES: &[StateRow] = &[
    state("G81 to G89", "a block of X and Y makes a hole", InWord("the first motion has its own G00, which ends a cycle"), Every, CODES),
    state("G98, G99", "level after a hole", InWord("in the block of each cycle"), Cycles, CODES),
    state("setting 28", "a cycle without X and Y makes a hole", InWord("X and Y in the block of each cycle"), Cycles, SETTINGS),
    state("settings 34 and 79", "F where a rotary axis moves depends on a diameter", InWord("inverse time (G93) where a rotary axis moves without tip control"), Rotary, SETTINGS),
    state("settings 77 and 162", "numbers without a point", InWord("every number has a point"), Every, SETTINGS),
    state("G20, G21", "unit of lengths", Set("G20 or G21"), Every, CODES),
    state("G18, G19", "plane of arcs, cycles and compensation", Set("G17"), Every, CODES),
    state("G41, G42", "the path is offset from the words", Set("G40"), Every, CODES),
    state("G43, G234", "Z is offset from its words, or they are tip coordinates", Set("G49"), Every, CODES),
    state("G91", "words are distances", Set("G90"), Every, CODES),
    state("G93, G95", "meaning of F", Set("G94"), Every, CODES),
    state("G54 to G59, G154", "zero of the words", Set("the code of `work_offset`"), Every, CODES),
    state("G51 scaling", "lengths of words", SetWhere(ControlFunction::Scaling, "G50"), Every, CODES).because(OPTION),
    state("G68 rotation", "direction of words", SetWhere(ControlFunction::Rotation, "G69"), Every, CODES).because(OPTION),
    state("G268 tilted plane", "words count in a plane", SetWhere(ControlFunction::Planes, "G269"), Every, "").because(OPTION),
    state("G254 dynamic work offset", "zero of the words follows the table", SetWhere(ControlFunction::DynamicOffset, "G255"), Every, DYNAMIC).because(OPTION),
    state("G187 smoothing", "deviation from the path", SetWhere(ControlFunction::Smoothing, "G187"), Every, SETTINGS).because(OPTION),
    state("tool offsets", "length of H", Compared(LENGTH, "the offsets H hold the lengths of the tools"), Every, "mill manual 96-8000, macros")
        .because("the length is that of the real tool"),
    state("setting 9", "unit of the machine: G20 and G21 raise an alarm where it differs", Stated("setting 9 is the unit of the program"), Every, SETTINGS).because(SETTING),
    state("setting 15", "H must be T", Stated("setting 15 permits the H words of the program"), Every, SETTINGS).because(SETTING),
    state("settings 45 to 48, 80, 250, G101", "mirror image of an axis", Stated("no mirror image is on (settings 45 to 48, 80 and 250, G101)"), Every, SETTINGS)
        .because("a setting has no code, and G100 needs words of axes"),
    state("setting 33, G52, G92", "zero of the words", Stated("nothing lies over the work offset by G52 or G92 (setting 33)"), Every, SETTINGS)
        .because("they hold data of the shop"),
    state("settings 40, 43 and 58", "offset of G41 and G42", Noted(|codes| codes.radius_data[0]), Compensation, SETTINGS).because(SETTING),
    state("setting 335", "axes of a rapid arrive together, or not", StatedUnless(Settled::LooseRapids, "the axes of a rapid arrive together (setting 335)"), Every, SETTINGS).because(SETTING),
    state("setting 335 off", "way of a rapid out of a tilted cut", StatedUnless(Settled::StatedRapids, "the axes of a rapid arrive together (setting 335), or there is room for each on its own"), Rotary, SETTINGS).because(SETTING),
    state("settings 85 and 191", "deviation from the path where no G187 is", Stated("settings 85 and 191 round corners no more than the part allows"), Every, SETTINGS).because(SETTING),
    state("F under G234", "speed of the tip, or of the axes", Stated("F under G234 is the speed of the tip"), TipControl, "").because("no code selects it"),
    state("setting 44", "least F at the inside of a compensated arc", Stated("setting 44 leaves F of compensated arcs as programmed"), Compensation, SETTINGS).because(SETTING),
    state("settings 130 and 133", "speed of the retract of a tap; orientation of the spindle before it", Stated("setting 130 has how fast a tap comes out, 133 whether the spindle is oriented before it"), Cycles, SETTINGS)
        .because(SETTING),
    state("settings 254 to 257, 300 to 305", "centres of the rotary axes", Stated("the settings of the machine rotary zero point (254 to 257, or 300 to 305) are measured"), Kinematics, "").because(SETTING),
    state("setting 108", "rotary axes go to zero by the shorter way at G28", Stated("setting 108 does not rotate an axis at G28 that the program leaves where it is"), Rotary, SETTINGS)
        .because(SETTING),
    state("wrap of rotary axes", "words of rotary axes beyond a revolution", Noted(|codes| codes.rotary_note), Rotary, "").because(SETTING),
    state("G234", "axes that move where it is commanded", Noted(|codes| codes.tip.as_ref().map_or("", |tip| tip.note)), TipControl, "").because("no code selects it"),
    state("pose of G253", "which of two poses the rotary axes take", Noted(|codes| codes.plane.as_ref().map_or("", |plane| plane.note)), Planes, "")
        .because("no variable with the positions is in a public manual"),
];
