//! Rows that LinuxCNC, Fanuc and Haas share, and address letters.

use super::super::block::{FeedMode, Side, WorkPlane, coolant};
use super::super::orders::{Code, LengthCode};
use super::group;
use super::{Address, Means, PathCode, Pattern, Row, Statement};
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
pub(super) const ROWS: &[Row] = &[
    Row::new("G0", Means::Motion(Code::Rapid), group::MOTION, G),
    Row::new("G1", Means::Motion(Code::Feed), group::MOTION, G),
    Row::new("G17", Means::Plane(WorkPlane::Xy), group::PLANE, G),
    Row::new("G18", Means::Plane(WorkPlane::Zx), group::PLANE, G),
    Row::new("G19", Means::Plane(WorkPlane::Yz), group::PLANE, G),
    Row::new("G20", Means::Units(Units::Inches), group::UNITS, G),
    Row::new("G21", Means::Units(Units::Millimetres), group::UNITS, G),
    Row::new("G28", Means::Reference, group::ALONE, HOME),
    Row::new("G30", Means::Reference, group::ALONE, HOME),
    Row::new("G40", Means::Side(Side::None), group::SIDE, G),
    Row::new("G41", Means::Side(Side::Left), group::SIDE, G).takes("D"),
    Row::new("G42", Means::Side(Side::Right), group::SIDE, G).takes("D"),
    Row::new("G43", Means::Length(LengthCode::On), group::LENGTH, G).needs("H"),
    Row::new("G49", Means::Length(LengthCode::Off), group::LENGTH, G),
    Row::new("G53", Means::Machine, group::ALONE, G),
    Row::new("G54", Means::Offset, group::OFFSET, G),
    Row::new("G55", Means::Offset, group::OFFSET, G),
    Row::new("G56", Means::Offset, group::OFFSET, G),
    Row::new("G57", Means::Offset, group::OFFSET, G),
    Row::new("G58", Means::Offset, group::OFFSET, G),
    Row::new("G59", Means::Offset, group::OFFSET, G),
    Row::new("G80", Means::Motion(Code::None), group::MOTION, CYCLE),
    Row::new("G73", Means::Hole(Pattern::ChipBreak), group::MOTION, CYCLE).needs("RQ"),
    Row::new("G81", Means::Hole(Pattern::Drill), group::MOTION, CYCLE).needs("R"),
    Row::new("G82", Means::Hole(Pattern::Drill), group::MOTION, CYCLE).needs("RP"),
    Row::new("G83", Means::Hole(Pattern::Peck), group::MOTION, CYCLE).needs("RQ"),
    Row::new("G85", Means::Hole(Pattern::Ream), group::MOTION, CYCLE).needs("R"),
    Row::new("G86", Means::Hole(Pattern::Bore), group::MOTION, CYCLE).needs("R"),
    Row::new("G89", Means::Hole(Pattern::Ream), group::MOTION, CYCLE).needs("RP"),
    Row::new("G90", Means::Distances { incremental: false }, group::DISTANCE, G),
    Row::new("G91", Means::Distances { incremental: true }, group::DISTANCE, G),
    Row::new("G93", Means::FeedMode(FeedMode::InverseTime), group::FEED, G),
    Row::new("G94", Means::FeedMode(FeedMode::PerMinute), group::FEED, G),
    Row::new("G95", Means::FeedMode(FeedMode::PerRevolution), group::FEED, G),
    Row::new("G98", Means::Return { initial: true }, group::RETURN, CYCLE),
    Row::new("G99", Means::Return { initial: false }, group::RETURN, CYCLE),
    Row::new("M0", Means::Stop { optional: false }, group::STOP, M),
    Row::new("M1", Means::Stop { optional: true }, group::STOP, M),
    Row::new("M2", Means::End, group::STOP, M),
    Row::new("M30", Means::End, group::STOP, M),
    Row::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    Row::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    Row::new("M5", Means::Spindle(None), group::SPINDLE, M),
    Row::new("M6", Means::ToolChange, group::CHANGE, M),
    Row::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    Row::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, M),
];

/// Codes that Fanuc and Haas share.
pub(super) const OF_TWO: &[Row] = &[
    Row::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G).takes("IJKR"),
    Row::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G).takes("IJKR"),
    Row::new("G61", Means::Path(PathCode::ExactStop), group::PATH, G),
    Row::new("G64", Means::Path(PathCode::Continuous), group::PATH, G),
];

/// Address letters of the three controls.
pub(super) const LETTERS: &[Row] = &[
    Row::word("N", Means::Address(Address::BlockNumber), FORM),
    Row::word("G", Means::Address(Address::Code), FORM),
    Row::word("M", Means::Address(Address::Code), FORM),
    Row::word("X", Means::Address(Address::Axis), FORM),
    Row::word("Y", Means::Address(Address::Axis), FORM),
    Row::word("Z", Means::Address(Address::Axis), FORM),
    Row::word("A", Means::Address(Address::Axis), FORM),
    Row::word("B", Means::Address(Address::Axis), FORM),
    Row::word("C", Means::Address(Address::Axis), FORM),
    Row::word("U", Means::Address(Address::Axis), FORM),
    Row::word("V", Means::Address(Address::Axis), FORM),
    Row::word("W", Means::Address(Address::Axis), FORM),
    Row::word("I", Means::Address(Address::Centre), FORM),
    Row::word("J", Means::Address(Address::Centre), FORM),
    Row::word("K", Means::Address(Address::Centre), FORM),
    Row::word("F", Means::Address(Address::Feed), FORM),
    Row::word("S", Means::Address(Address::Speed), FORM),
    Row::word("T", Means::Address(Address::Tool), FORM),
    Row::word("H", Means::Address(Address::LengthRegister), FORM),
    Row::word("D", Means::Address(Address::RadiusRegister), FORM),
    Row::word("P", Means::Address(Address::Parameter), FORM),
    Row::word("Q", Means::Address(Address::Parameter), FORM),
    Row::word("R", Means::Address(Address::Parameter), FORM),
    Row::word("E", Means::Address(Address::Parameter), FORM),
];

/// Lines of Fanuc and Haas that are no blocks of words.
pub(super) const LINES: &[Row] = &[
    Row::word("%", Means::Statement(Statement::ProgramMark), FORM),
    Row::word("O", Means::Statement(Statement::ProgramNumber), FORM),
    Row::word("(..)", Means::Statement(Statement::Comment), FORM),
    Row::word("/", Means::Statement(Statement::BlockDelete), FORM),
    Row::word("IF .. THEN #3000", Means::Statement(Statement::Guard), MACRO),
    Row::word("IF .. GOTO", Means::Statement(Statement::Guard), MACRO),
];
