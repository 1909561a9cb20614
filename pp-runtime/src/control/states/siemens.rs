//! States of Siemens 840D.

use super::super::dialects::ControlFunction;
use super::StateHandling::{Compared, InWord, Noted, Set, SetWhere, Stated, StatedUnless};
use super::StateUse::{Compensation, Every, Kinematics, Planes, Rotary};
use super::{LENGTH, Settled, StateRow, state};

const GROUPS: &str = "Fundamentals 05/2017 (A5E40869423), Tables: G functions";
const FRAMES: &str = "NC programming 12/2019 (6FC5398-2EP40-0BA0), p. 631";
const DATA: &str = "it is machine data, which a program does not change";

#[rustfmt::skip]
pub(super) const STATES: &[StateRow] = &[
    state("group 1", "a block of words is a rapid, a feed motion or a thread", InWord("the first motion has its own G0"), Every, GROUPS),
    state("F of G93", "time of a block", InWord("F in each block"), Rotary, GROUPS),
    state("modulo axes (MD30310, MD30455 bit 2)", "direction of rotary words", InWord("DC(..) where `wrap` has the axis"), Rotary, "Axes and Spindles 06/2019, p. 225"),
    state("TRAORI, TRACYL, TRANSMIT", "linear words are tip coordinates, or lie on a cylinder", SetWhere(ControlFunction::TipControl, "TRAFOOF"), Every, FRAMES)
        .because("without a transformation its code may raise an alarm"),
    state("CYCLE800", "words count in a plane", SetWhere(ControlFunction::Planes, "CYCLE800()"), Every, "828D operating manual, 10.6").because("without swivel data its cycle raises an alarm"),
    state("TRANS, ROT, SCALE, MIRROR ($P_PFRAME)", "place, direction and length of words", Set("TRANS"), Every, FRAMES),
    state("G70, G71, G700, G710", "unit of lengths and F", Set("G700 or G710"), Every, GROUPS),
    state("G18, G19", "plane of arcs, cycles and compensation", Set("G17"), Every, GROUPS),
    state("G41, G42", "the path is offset from the words", Set("G40"), Every, GROUPS),
    state("G60, G641 to G645", "corners", Set("G64"), Every, GROUPS),
    state("G91", "words are distances", Set("G90"), Every, GROUPS),
    state("G93, G95, G96, G961", "meaning of F and S", Set("G94"), Every, GROUPS),
    state("G54 to G57, G505 to G599", "zero of the words", Set("the code of `work_offset`"), Every, GROUPS),
    state("D", "length of the tool", Set("D0, then the D of the tool"), Every, GROUPS),
    state("settable, basic, external and system frames", "direction and length of words", Compared("rotation, scale and mirror of $P_ACTFRAME", "no frame rotates, scales or mirrors (settable, basic, external and system frames)"), Every, FRAMES)
        .because("they hold data of the shop"),
    state("offsets of the shop", "zero of the words", Stated("no basic, external, fine or DRF offset that is not meant moves the zero"), Every, FRAMES)
        .because("they hold data of the shop"),
    state("TOFFON, $AA_OFF", "place of the axes", Stated("no offset by TOFFON or a synchronised action is on"), Every, "").because("without their options the codes raise an alarm"),
    state("RTLIOF", "axes of a rapid arrive together, or not", StatedUnless(Settled::LooseRapids, "the axes of a rapid arrive together (RTLION)"), Every, "NC programming 12/2019 (6FC5398-2EP40-0BA0), rapid traverse")
        .because("without linear interpolation of rapids in the control its code is unknown"),
    state("G25 S, G26 S", "lowest and highest speed of the spindle", Stated("no limit of G25, G26 or the setting data holds S back"), Every, "NC programming 12/2019 (6FC5398-2EP40-0BA0), programmable spindle speed limits")
        .because("they hold data of the shop"),
    state("MD22550", "T changes the tool, or selects it for M6", Stated("T1 selects the tool of number 1, or of this name, and M6 changes it (MD22550 = 1), keeps the modes and has room where the rotary axes are"), Every, "").because(DATA),
    state("tool data", "length of the edge", Compared(LENGTH, "length 1 of the edges, with wear and adapter, is the length of the tools"), Every, "Fundamentals 05/2017, system variables")
        .because("the length is that of the real tool"),
    state("MD30310", "words of rotary axes beyond a revolution", Noted(|codes| codes.rotary_note), Rotary, "Axes and Spindles 06/2019, p. 225").because(DATA),
    state("radius of the edge", "offset of G41 and G42", Noted(|codes| codes.radius_data[0]), Compensation, "System Variables 6FC5397-6AP40-3BA1, 03/2013").because("the radius is that of the real tool"),
    state("CUT2DF, CDOF, KONT, G451", "way of G41 and G42 to the contour and around its corners", Stated("CUT2D, NORM and G450 are in force, as after reset"), Compensation, "").because("machine data selects them at reset"),
    state("direction reference of CYCLE800", "which of two poses the rotary axes take", Noted(|codes| codes.plane.as_ref().map_or("", |plane| plane.note)), Planes, "828D operating manual, 10.6")
        .because("it is part of the swivel data; a guard compares the axes"),
    state("$TC_CARR, MD24100 to MD24599", "where the rotary axes are for CYCLE800 and TRAORI", Stated("swivel data and data of TRAORI are those of this machine (`kinematics --siemens`)"), Kinematics, "IM9 03/2013, p. 502").because(DATA),
    state("SD42940, SD42950", "axis of the tool length", Stated("length 1 of a tool lies along Z in G17 (SD42940)"), Every, "6FC5398-1BP10-2BA0, 8.17.4").because(DATA),
    state("G291", "codes are those of ISO", Stated("the control is in Siemens mode (G290)"), Every, "").because("without ISO mode its code may be unknown"),
    state("DIAMON", "X is a diameter", StatedUnless(Settled::RadiusWords, "X is a radius (DIAMOF)"), Every, "").because("without a transverse axis its code may raise an alarm"),
    state("SETMS", "spindle of S and M3", StatedUnless(Settled::ToolSpindle, "the tool is in the master spindle"), Every, "").because("SETMS would take a spindle that the shop has selected"),
    state("CYCLE832", "deviation from the path", Stated("no CYCLE832 of a program before is in force"), Every, "NC programming 12/2019, p. 1108").because("without its option the cycle raises an alarm"),
];
