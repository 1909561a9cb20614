//! Rows that LinuxCNC, Fanuc and Haas share, and address letters.

use super::super::block::{FeedMode, SideOfPath, WorkPlane, coolant};
use super::super::orders::{Code, LengthCode, Pattern};
use super::{Address, CodeRow, Means, PathCode, StatementWord, group};
use crate::program::{Rotation, Units};

/// The chapters that list these codes. A difference between the controls is in the table of the control.
const G: &str =
    "LinuxCNC 2.9 G-code documentation, Fanuc B-63944EN/02 (2004), list of G codes, Haas 96-8000 (1999), G codes";
const CYCLE: &str = "LinuxCNC 2.9 G-code documentation, canned cycles, Fanuc 15i operator's manual, p. 315, Haas 96-8000 \
                     (1999), p. 182";
const M: &str =
    "LinuxCNC 2.9 M-code documentation, Fanuc B-63944EN/02 (2004), auxiliary functions, Haas 96-8000 (1999), M codes";
const MACRO: &str = "Fanuc B-63944EN/02 (2004), custom macro, Haas 96-8000, macros";
const HOME: &str =
    "LinuxCNC 2.9 G-code documentation, G28 and G30 (all axes where none is written), Fanuc and Haas (from memory)";
const FORM: &str =
    "LinuxCNC 2.9 G-code overview, Fanuc B-63944EN/02 (2004), program configuration, Haas 96-8000 (1999), format";

/// G and M codes of the three controls.
pub(super) const ROWS: &[CodeRow] = &[
    CodeRow::new("G0", Means::Motion(Code::Rapid), group::MOTION, G),
    CodeRow::new("G1", Means::Motion(Code::Feed), group::MOTION, G),
    CodeRow::new("G17", Means::Plane(WorkPlane::Xy), group::PLANE, G),
    CodeRow::new("G18", Means::Plane(WorkPlane::Zx), group::PLANE, G),
    CodeRow::new("G19", Means::Plane(WorkPlane::Yz), group::PLANE, G),
    CodeRow::new("G20", Means::Units(Units::Inches), group::UNITS, G),
    CodeRow::new("G21", Means::Units(Units::Millimetres), group::UNITS, G),
    CodeRow::new("G28", Means::Reference, group::ALONE, HOME),
    CodeRow::new("G30", Means::Reference, group::ALONE, HOME),
    CodeRow::new("G40", Means::Side(SideOfPath::None), group::SIDE, G),
    CodeRow::new("G41", Means::Side(SideOfPath::Left), group::SIDE, G).takes("D"),
    CodeRow::new("G42", Means::Side(SideOfPath::Right), group::SIDE, G).takes("D"),
    CodeRow::new("G43", Means::Length(LengthCode::On), group::LENGTH, G).needs("H"),
    CodeRow::new("G49", Means::Length(LengthCode::Off), group::LENGTH, G),
    CodeRow::new("G53", Means::Machine, group::ALONE, G),
    CodeRow::new("G54", Means::Offset, group::OFFSET, G),
    CodeRow::new("G55", Means::Offset, group::OFFSET, G),
    CodeRow::new("G56", Means::Offset, group::OFFSET, G),
    CodeRow::new("G57", Means::Offset, group::OFFSET, G),
    CodeRow::new("G58", Means::Offset, group::OFFSET, G),
    CodeRow::new("G59", Means::Offset, group::OFFSET, G),
    CodeRow::new("G80", Means::Motion(Code::None), group::MOTION, CYCLE),
    CodeRow::new("G73", Means::Hole(Pattern::ChipBreak), group::MOTION, CYCLE).needs("RQ"),
    CodeRow::new("G81", Means::Hole(Pattern::Drill), group::MOTION, CYCLE).needs("R"),
    CodeRow::new("G82", Means::Hole(Pattern::Drill), group::MOTION, CYCLE).needs("RP"),
    CodeRow::new("G83", Means::Hole(Pattern::Peck), group::MOTION, CYCLE).needs("RQ"),
    CodeRow::new("G85", Means::Hole(Pattern::Ream), group::MOTION, CYCLE).needs("R"),
    CodeRow::new("G86", Means::Hole(Pattern::Bore), group::MOTION, CYCLE).needs("R"),
    CodeRow::new("G89", Means::Hole(Pattern::Ream), group::MOTION, CYCLE).needs("RP"),
    CodeRow::new("G90", Means::Distances { incremental: false }, group::DISTANCE, G),
    CodeRow::new("G91", Means::Distances { incremental: true }, group::DISTANCE, G),
    CodeRow::new("G93", Means::FeedMode(FeedMode::InverseTime), group::FEED, G),
    CodeRow::new("G94", Means::FeedMode(FeedMode::PerMinute), group::FEED, G),
    CodeRow::new("G95", Means::FeedMode(FeedMode::PerRevolution), group::FEED, G),
    CodeRow::new("G98", Means::Return { initial: true }, group::RETURN, CYCLE),
    CodeRow::new("G99", Means::Return { initial: false }, group::RETURN, CYCLE),
    CodeRow::new("M0", Means::Stop { optional: false }, group::STOP, M),
    CodeRow::new("M1", Means::Stop { optional: true }, group::STOP, M),
    CodeRow::new("M2", Means::End, group::STOP, M),
    CodeRow::new("M30", Means::End, group::STOP, M),
    CodeRow::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    CodeRow::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    CodeRow::new("M5", Means::Spindle(None), group::SPINDLE, M),
    CodeRow::new("M6", Means::ToolChange, group::CHANGE, M),
    CodeRow::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    CodeRow::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, M),
];

/// Codes that Fanuc and Haas share.
pub(super) const OF_TWO: &[CodeRow] = &[
    CodeRow::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G).takes("IJKR"),
    CodeRow::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G).takes("IJKR"),
    CodeRow::new("G61", Means::Path(PathCode::ExactStop), group::PATH, G),
    CodeRow::new("G64", Means::Path(PathCode::Continuous), group::PATH, G),
];

/// Address letters of the three controls.
pub(super) const LETTERS: &[CodeRow] = &[
    CodeRow::word("N", Means::Address(Address::BlockNumber), FORM),
    CodeRow::word("G", Means::Address(Address::Code), FORM),
    CodeRow::word("M", Means::Address(Address::Code), FORM),
    CodeRow::word("X", Means::Address(Address::Axis), FORM),
    CodeRow::word("Y", Means::Address(Address::Axis), FORM),
    CodeRow::word("Z", Means::Address(Address::Axis), FORM),
    CodeRow::word("A", Means::Address(Address::Axis), FORM),
    CodeRow::word("B", Means::Address(Address::Axis), FORM),
    CodeRow::word("C", Means::Address(Address::Axis), FORM),
    CodeRow::word("U", Means::Address(Address::Axis), FORM),
    CodeRow::word("V", Means::Address(Address::Axis), FORM),
    CodeRow::word("W", Means::Address(Address::Axis), FORM),
    CodeRow::word("I", Means::Address(Address::Centre), FORM),
    CodeRow::word("J", Means::Address(Address::Centre), FORM),
    CodeRow::word("K", Means::Address(Address::Centre), FORM),
    CodeRow::word("F", Means::Address(Address::Feed), FORM),
    CodeRow::word("S", Means::Address(Address::Speed), FORM),
    CodeRow::word("T", Means::Address(Address::Tool), FORM),
    CodeRow::word("H", Means::Address(Address::LengthRegister), FORM),
    CodeRow::word("D", Means::Address(Address::RadiusRegister), FORM),
    CodeRow::word("P", Means::Address(Address::Parameter), FORM),
    CodeRow::word("Q", Means::Address(Address::Parameter), FORM),
    CodeRow::word("R", Means::Address(Address::Parameter), FORM),
    CodeRow::word("E", Means::Address(Address::Parameter), FORM),
];

/// Lines of Fanuc and Haas that are no blocks of words.
pub(super) const LINES: &[CodeRow] = &[
    CodeRow::word("%", Means::Statement(StatementWord::ProgramMark), FORM),
    CodeRow::word("O", Means::Statement(StatementWord::ProgramNumber), FORM),
    CodeRow::word("(..)", Means::Statement(StatementWord::Comment), FORM),
    CodeRow::word("/", Means::Statement(StatementWord::BlockDelete), FORM),
    CodeRow::word("IF .. THEN #3000", Means::Statement(StatementWord::Guard), MACRO),
    CodeRow::word("IF .. GOTO", Means::Statement(StatementWord::Guard), MACRO),
];
