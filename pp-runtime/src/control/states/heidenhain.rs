//! States of Heidenhain TNC.

use super::super::dialects::ControlFunction;
use super::StateHandling::{Compared, InWord, Noted, Set, SetWhere, Stated};
use super::StateUse::{Compensation, Every, Planes, Rotary, TipControl};
use super::{LENGTH, StateRow, state};

const MANUAL: &str = "iTNC 530 and TNC 640 user's manuals";
const M_FUNCTIONS: &str = "overview of the M functions in the manuals of the iTNC 530";

#[rustfmt::skip]
pub(super) const STATES: &[StateRow] = &[
    state("R0, RL, RR", "the path is offset from the words", InWord("R0 in each rapid; RL and RR at their contour"), Every, MANUAL),
    state("I", "a word is a distance", InWord("each word has its own I"), Every, MANUAL),
    state("FMAX", "rapid", InWord("in each rapid"), Every, MANUAL),
    state("unit", "unit of lengths and F", InWord("BEGIN PGM .. MM or INCH"), Every, MANUAL),
    state("plane", "plane of arcs and cycles", InWord("the Z of each TOOL CALL"), Every, MANUAL),
    state("cycles", "a motion makes a hole", InWord("M99 at each point; the cycle is defined before it"), Every, MANUAL),
    state("M128, TCPM", "linear words are tip coordinates", SetWhere(ControlFunction::TipControl, "M129"), Every, M_FUNCTIONS).because("without the option its code is unknown"),
    state("PLANE, cycle 19", "words count in a plane", SetWhere(ControlFunction::Planes, "PLANE RESET STAY"), Every, MANUAL).because("without the option its code is unknown"),
    state("FUNCTION TCPM", "the same; the program ends it with FUNCTION RESET TCPM", Stated("FUNCTION TCPM is off at each start, after a stop as well: M129 may not end it"), TipControl, "").because("no public page states that FUNCTION RESET TCPM may come where it is off"),
    state("M126", "direction of rotary words", Set("M126 or M127"), Rotary, M_FUNCTIONS),
    state("preset, cycles 7, 8, 10, 11 and 26", "place, direction and length of words", Set("cycle 247, which resets the others (from memory)"), Every, ""),
    state("basic rotation", "rotates the words about the zero", Compared("ID210 NR1", "no basic rotation is active"), Every, "TNC 426/430 Technical Manual, p. 7-30")
        .because("it is data of the preset that a probing cycle has set"),
    state("global program settings", "offset, mirror, rotation and feed over the program; a value of the handwheel stays", Stated("no global program settings are active (GS)"), Every, "iTNC 530 user's manual, 11.5")
        .because("no code ends them"),
    state("pallet preset", "zero of the words", Stated("no preset of a pallet is added to the preset of the program"), Every, "Technical Manual iTNC 530 HSCI, p. 1492")
        .because("it holds data of the shop"),
    state("FUNCTION MODE, kinematics", "axes that the words move", Stated("the kinematics in force are those of this machine and head"), Rotary, "").because("the builder names them"),
    state("tool table", "length of the tool", Compared(LENGTH, "L and DL of the tool table are the lengths of the tools"), Every, "TNC 426/430 Technical Manual, p. 7-30")
        .because("the length is that of the real tool"),
    state("display of rotary axes", "words of rotary axes beyond a revolution", Noted(|codes| codes.rotary_note), Rotary, M_FUNCTIONS).because("M127 is in force"),
    state("R and DR of the tool table", "offset of RL and RR", Noted(|codes| codes.radius_data[0]), Compensation, "TNC 620 user's manual 1/2022, p. 134").because("the radius is that of the real tool"),
    state("master axis of SEQ", "which of two poses the rotary axes take", Noted(|codes| codes.plane.as_ref().map_or("", |plane| plane.note)), Planes, MANUAL)
        .because("it is machine data; a guard compares the axes"),
    state("M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144, M148", "cycles, F, points and axes of motions", Stated("none of M89, M101, M103, M109, M110, M118, M120, M124, M136, M138, M144 and M148 is in force"), Every, M_FUNCTIONS)
        .because("no single code ends them, and not every control has all"),
    state("X_OFFS to W_OFFS of the preset", "place of the axes", Stated("the columns X_OFFS to W_OFFS of the preset are 0"), Every, "").because("no public manual has their numbers for FN 18"),
    state("SPA, SPB, SPC of the preset", "3-D basic rotation", Stated("the preset has no 3-D basic rotation (SPA, SPB, SPC)"), Every, "").because("no public manual has its number for FN 18"),
    state("cycle 32", "deviation from the path", Stated("no cycle 32 of a program before is in force"), Every, "").because("not every control has it"),
];
