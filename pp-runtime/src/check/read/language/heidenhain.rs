//! Heidenhain TNC 640 and iTNC 530, conversational.

use super::super::block::{FeedMode, coolant};
use super::super::orders::Order;
use super::arguments::HEIDENHAIN;
use super::group;
use super::{Address, Language, Means, Row, Statement, sorted};
use crate::program::Rotation;

const TNC: &str = "HEIDENHAIN TNC 640 user's manual (conversational)";
const M: &str = "HEIDENHAIN TNC 640 user's manual (conversational), miscellaneous functions";
const ENDS: &str = "HEIDENHAIN TNC 155 technical manual, M functions: M3, M4, M8, M13 and M14 at the beginning of their block, M5 \
                    and M9 at its end";
const Q: &str = "HEIDENHAIN TNC 640 user's manual (conversational), Q parameters";
const PLANE: &str = "HEIDENHAIN TNC 620 user's manual 10/2017, p. 540 and 554 (positioning)";
const TCPM: &str = "HEIDENHAIN TNC 620 user's manual, p. 340; TNC 640, FUNCTION TCPM";

const OWN: &[Row] = &[
    Row::new("M0", Means::Stop { optional: false }, group::STOP, M),
    Row::new("M1", Means::Stop { optional: true }, group::STOP, M),
    Row::new("M2", Means::End, group::STOP, M),
    Row::new("M30", Means::End, group::STOP, M),
    Row::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    Row::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    Row::new("M5", Means::Spindle(None), group::SPINDLE, ENDS).acts(Order::After),
    Row::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    Row::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, ENDS).acts(Order::After),
    Row::new("M13", Means::SpindleAndFlood(Rotation::Clockwise), group::SPINDLE, M),
    Row::new("M14", Means::SpindleAndFlood(Rotation::CounterClockwise), group::SPINDLE, M),
    Row::new("M91", Means::Machine, group::ALONE, M),
    Row::new("M99", Means::CallCycle, group::CALL, M),
    Row::new(
        "M140",
        Means::EndOfTravel,
        group::ALONE,
        "Autodesk's public post for the TNC, M140 MB MAX; at rapid without F",
    ),
    Row::new("M126", Means::ShortestWay(true), group::WAY, M),
    Row::new("M127", Means::ShortestWay(false), group::WAY, M),
    Row::new(
        "M137",
        Means::FeedMode(FeedMode::PerMinute),
        group::FEED,
        "HEIDENHAIN TNC 320 user's manual (340 55x-05), p. 279: cancels M136, feed per revolution",
    ),
    Row::new("M128", Means::TipControl(true), group::TIP, M),
    Row::new("M129", Means::TipControl(false), group::TIP, M),
];

static CODES: [Row; OWN.len()] = sorted(&[OWN]);

const LETTERS: &[Row] = &[Row::word("M", Means::Address(Address::Code), TNC)];

/// Statements first, in the order in which they are tried; then the words of a motion.
const WORDS: &[Row] = &[
    Row::word("L", Means::Statement(Statement::Line), TNC),
    Row::word("CC", Means::Statement(Statement::Pole), TNC),
    Row::word("C", Means::Statement(Statement::Arc), TNC),
    Row::word("CR", Means::Statement(Statement::Arc), TNC),
    Row::word("CP", Means::Statement(Statement::Arc), TNC),
    Row::word("LN", Means::Statement(Statement::Line), TNC),
    Row::word("CYCL DEF", Means::Statement(Statement::CycleDef), TNC),
    Row::word("CYCL CALL", Means::Statement(Statement::CycleCall), TNC),
    Row::word("TOOL CALL", Means::Statement(Statement::ToolCall), TNC),
    Row::word("TOOL DEF", Means::Statement(Statement::ToolDef), TNC),
    Row::word("PLANE SPATIAL", Means::Statement(Statement::PlaneSpatial), PLANE),
    Row::word("PLANE RESET", Means::Statement(Statement::PlaneReset), PLANE),
    Row::word("FUNCTION TCPM", Means::Statement(Statement::TcpmOn), TCPM),
    Row::word("FUNCTION RESET TCPM", Means::Statement(Statement::TcpmOff), TCPM),
    Row::word("FN 18:", Means::Statement(Statement::Guard), Q),
    Row::word("FN 1:", Means::Statement(Statement::Guard), Q),
    Row::word("FN 9:", Means::Statement(Statement::Guard), Q),
    Row::word("FN 12:", Means::Statement(Statement::Guard), Q),
    Row::word("FN 20:", Means::Statement(Statement::Guard), Q),
    Row::word("QL3 =", Means::Statement(Statement::Guard), Q),
    Row::word("FN 14:", Means::Statement(Statement::Guard), Q),
    Row::word("LBL", Means::Statement(Statement::Guard), Q),
    Row::word("BEGIN PGM", Means::Statement(Statement::Begin), TNC),
    Row::word("END PGM", Means::Statement(Statement::EndOfProgram), TNC),
    Row::word("BLK FORM", Means::Statement(Statement::Blank), TNC),
    Row::word("STOP", Means::Statement(Statement::Stop), TNC),
    Row::word(";", Means::Statement(Statement::Comment), TNC),
    Row::word("*", Means::Statement(Statement::Comment), TNC),
    Row::word("F", Means::Address(Address::Feed), TNC),
    Row::word("FMAX", Means::Address(Address::RapidFeed), TNC),
    Row::word("R0 RL RR", Means::Address(Address::Side), TNC),
    Row::word("DR+ DR-", Means::Address(Address::Sense), TNC),
    Row::word("R", Means::Address(Address::Radius), TNC),
    Row::word("IPA", Means::Address(Address::Angle), TNC),
    Row::word("TX", Means::Address(Address::Vector), TNC),
    Row::word("TY", Means::Address(Address::Vector), TNC),
    Row::word("TZ", Means::Address(Address::Vector), TNC),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, LETTERS, WORDS, HEIDENHAIN);
