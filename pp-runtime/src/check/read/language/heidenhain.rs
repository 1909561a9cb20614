//! Heidenhain TNC 640 and iTNC 530, conversational.

use super::super::block::{FeedMode, coolant};
use super::super::orders::Order;
use super::arguments::HEIDENHAIN;
use super::group;
use super::{Address, CodeRow, Language, Means, StatementWord, sorted};
use crate::program::Rotation;

const TNC: &str = "HEIDENHAIN TNC 640 user's manual (conversational)";
const M: &str = "HEIDENHAIN TNC 640 user's manual (conversational), miscellaneous functions";
const ENDS: &str = "HEIDENHAIN TNC 155 technical manual, M functions: M3, M4, M8, M13 and M14 at the beginning of their block, M5 \
                    and M9 at its end";
const Q: &str = "HEIDENHAIN TNC 640 user's manual (conversational), Q parameters";
const PLANE: &str = "HEIDENHAIN TNC 620 user's manual 10/2017, p. 540 and 554 (positioning)";
const TCPM: &str = "HEIDENHAIN TNC 620 user's manual, p. 340; TNC 640, FUNCTION TCPM";

const OWN: &[CodeRow] = &[
    CodeRow::new("M0", Means::Stop { optional: false }, group::STOP, M),
    CodeRow::new("M1", Means::Stop { optional: true }, group::STOP, M),
    CodeRow::new("M2", Means::End, group::STOP, M),
    CodeRow::new("M30", Means::End, group::STOP, M),
    CodeRow::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    CodeRow::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    CodeRow::new("M5", Means::Spindle(None), group::SPINDLE, ENDS).acts(Order::After),
    CodeRow::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    CodeRow::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, ENDS).acts(Order::After),
    CodeRow::new("M13", Means::SpindleAndFlood(Rotation::Clockwise), group::SPINDLE, M),
    CodeRow::new("M14", Means::SpindleAndFlood(Rotation::CounterClockwise), group::SPINDLE, M),
    CodeRow::new("M91", Means::Machine, group::ALONE, M),
    CodeRow::new("M99", Means::CallCycle, group::CALL, M),
    CodeRow::new(
        "M140",
        Means::EndOfTravel,
        group::ALONE,
        "Autodesk's public post for the TNC, M140 MB MAX; at rapid without F",
    ),
    CodeRow::new("M126", Means::ShortestWay(true), group::WAY, M),
    CodeRow::new("M127", Means::ShortestWay(false), group::WAY, M),
    CodeRow::new(
        "M137",
        Means::FeedMode(FeedMode::PerMinute),
        group::FEED,
        "HEIDENHAIN TNC 320 user's manual (340 55x-05), p. 279: cancels M136, feed per revolution",
    ),
    CodeRow::new("M128", Means::TipControl(true), group::TIP, M),
    CodeRow::new("M129", Means::TipControl(false), group::TIP, M),
];

static CODES: [CodeRow; OWN.len()] = sorted(&[OWN]);

const LETTERS: &[CodeRow] = &[CodeRow::word("M", Means::Address(Address::Code), TNC)];

/// Statements first, in the order in which they are tried; then the words of a motion.
const WORDS: &[CodeRow] = &[
    CodeRow::word("L", Means::Statement(StatementWord::Line), TNC),
    CodeRow::word("CC", Means::Statement(StatementWord::Pole), TNC),
    CodeRow::word("C", Means::Statement(StatementWord::Arc), TNC),
    CodeRow::word("CR", Means::Statement(StatementWord::Arc), TNC),
    CodeRow::word("CP", Means::Statement(StatementWord::Arc), TNC),
    CodeRow::word("LN", Means::Statement(StatementWord::Line), TNC),
    CodeRow::word("CYCL DEF", Means::Statement(StatementWord::CycleDef), TNC),
    CodeRow::word("CYCL CALL", Means::Statement(StatementWord::CycleCall), TNC),
    CodeRow::word("TOOL CALL", Means::Statement(StatementWord::ToolCall), TNC),
    CodeRow::word("TOOL DEF", Means::Statement(StatementWord::ToolDef), TNC),
    CodeRow::word("PLANE SPATIAL", Means::Statement(StatementWord::PlaneSpatial), PLANE),
    CodeRow::word("PLANE RESET", Means::Statement(StatementWord::PlaneReset), PLANE),
    CodeRow::word("FUNCTION TCPM", Means::Statement(StatementWord::TcpmOn), TCPM),
    CodeRow::word("FUNCTION RESET TCPM", Means::Statement(StatementWord::TcpmOff), TCPM),
    CodeRow::word("FN 18:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("FN 1:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("FN 9:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("FN 12:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("FN 20:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("QL3 =", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("FN 14:", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("LBL", Means::Statement(StatementWord::Guard), Q),
    CodeRow::word("BEGIN PGM", Means::Statement(StatementWord::Begin), TNC),
    CodeRow::word("END PGM", Means::Statement(StatementWord::EndOfProgram), TNC),
    CodeRow::word("BLK FORM", Means::Statement(StatementWord::Blank), TNC),
    CodeRow::word("STOP", Means::Statement(StatementWord::Stop), TNC),
    CodeRow::word(";", Means::Statement(StatementWord::Comment), TNC),
    CodeRow::word("*", Means::Statement(StatementWord::Comment), TNC),
    CodeRow::word("F", Means::Address(Address::Feed), TNC),
    CodeRow::word("FMAX", Means::Address(Address::RapidFeed), TNC),
    CodeRow::word("R0 RL RR", Means::Address(Address::Side), TNC),
    CodeRow::word("DR+ DR-", Means::Address(Address::Sense), TNC),
    CodeRow::word("R", Means::Address(Address::Radius), TNC),
    CodeRow::word("IPA", Means::Address(Address::Angle), TNC),
    CodeRow::word("TX", Means::Address(Address::Vector), TNC),
    CodeRow::word("TY", Means::Address(Address::Vector), TNC),
    CodeRow::word("TZ", Means::Address(Address::Vector), TNC),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, LETTERS, WORDS, HEIDENHAIN);
