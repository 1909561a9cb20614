//! Siemens 840D sl and ONE.

use super::super::block::{FeedMode, SideOfPath, WorkPlane, coolant, settled};
use super::super::orders::Code;
use super::arguments::SIEMENS;
use super::group;
use super::{Address, CodeRow, Language, Means, PathCode, StatementWord, sorted};
use crate::program::{Rotation, Units};

const G: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Tables: G functions";
const M: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Auxiliary function outputs";
const FORM: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Fundamental principles of NC programming";
const JOBS: &str = "Siemens programming manual 12/2019 (6FC5398-2EP40-0BA0), Work preparation: transformations";

const OWN: &[CodeRow] = &[
    CodeRow::new("G0", Means::Motion(Code::Rapid), group::MOTION, G),
    CodeRow::new("G1", Means::Motion(Code::Feed), group::MOTION, G),
    CodeRow::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G),
    CodeRow::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G),
    CodeRow::new("G4", Means::Dwell, group::ALONE, G).takes("FS"),
    CodeRow::new("G9", Means::Path(PathCode::Window), group::PATH, G),
    CodeRow::new("G17", Means::Plane(WorkPlane::Xy), group::PLANE, G),
    CodeRow::new("G18", Means::Plane(WorkPlane::Zx), group::PLANE, G),
    CodeRow::new("G19", Means::Plane(WorkPlane::Yz), group::PLANE, G),
    CodeRow::new("G40", Means::Side(SideOfPath::None), group::SIDE, G),
    CodeRow::new("G41", Means::Side(SideOfPath::Left), group::SIDE, G),
    CodeRow::new("G42", Means::Side(SideOfPath::Right), group::SIDE, G),
    CodeRow::new("G53", Means::Machine, group::ALONE, G),
    CodeRow::new("G153", Means::Machine, group::ALONE, G),
    CodeRow::new("G54", Means::Offset, group::OFFSET, G).up_to("G57"),
    CodeRow::new("G500", Means::Offset, group::OFFSET, G),
    CodeRow::new("G505", Means::Offset, group::OFFSET, G).up_to("G599"),
    CodeRow::new("G60", Means::Path(PathCode::ExactStop), group::PATH, G),
    CodeRow::new("G64", Means::Path(PathCode::Continuous), group::PATH, G),
    CodeRow::new("G70", Means::Units(Units::Inches), group::UNITS, G),
    CodeRow::new("G71", Means::Units(Units::Millimetres), group::UNITS, G),
    CodeRow::new("G90", Means::Distances { incremental: false }, group::DISTANCE, G),
    CodeRow::new("G91", Means::Distances { incremental: true }, group::DISTANCE, G),
    CodeRow::new("G93", Means::FeedMode(FeedMode::InverseTime), group::FEED, G),
    CodeRow::new("G94", Means::FeedMode(FeedMode::PerMinute), group::FEED, G),
    CodeRow::new("G95", Means::FeedMode(FeedMode::PerRevolution), group::FEED, G),
    CodeRow::new("G601", Means::Path(PathCode::Window), group::WINDOW, G),
    CodeRow::new("G641", Means::Path(PathCode::Smoothed(641)), group::PATH, G),
    CodeRow::new("G642", Means::Path(PathCode::Smoothed(642)), group::PATH, G),
    CodeRow::new("G643", Means::Path(PathCode::Smoothed(643)), group::PATH, G),
    CodeRow::new("G644", Means::Path(PathCode::Smoothed(644)), group::PATH, G),
    CodeRow::new("G645", Means::Path(PathCode::Smoothed(645)), group::PATH, G),
    CodeRow::new("G700", Means::UnitsOfFeed(Units::Inches), group::UNITS, G),
    CodeRow::new("G710", Means::UnitsOfFeed(Units::Millimetres), group::UNITS, G),
    CodeRow::new("M0", Means::Stop { optional: false }, group::STOP, M),
    CodeRow::new("M1", Means::Stop { optional: true }, group::STOP, M),
    CodeRow::new("M2", Means::End, group::STOP, M),
    CodeRow::new("M17", Means::End, group::STOP, M),
    CodeRow::new("M30", Means::End, group::STOP, M),
    CodeRow::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    CodeRow::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    CodeRow::new("M5", Means::Spindle(None), group::SPINDLE, M),
    CodeRow::new("M6", Means::ToolChange, group::CHANGE, M),
    CodeRow::new("M7", Means::CoolantOn(coolant::MIST), group::COOLANT, M),
    CodeRow::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    CodeRow::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, M),
];

static CODES: [CodeRow; OWN.len()] = sorted(&[OWN]);

const LETTERS: &[CodeRow] = &[
    CodeRow::word("N", Means::Address(Address::BlockNumber), FORM),
    CodeRow::word("G", Means::Address(Address::Code), FORM),
    CodeRow::word("M", Means::Address(Address::Code), FORM),
    CodeRow::word("F", Means::Address(Address::Feed), FORM),
    CodeRow::word("S", Means::Address(Address::Speed), FORM),
    CodeRow::word("T", Means::Address(Address::Tool), FORM),
    CodeRow::word("D", Means::Address(Address::Edge), FORM),
    CodeRow::word("I", Means::Address(Address::Centre), FORM),
    CodeRow::word("J", Means::Address(Address::Centre), FORM),
    CodeRow::word("K", Means::Address(Address::Centre), FORM),
];

const WORDS: &[CodeRow] = &[
    CodeRow::word("A3", Means::Address(Address::Vector), JOBS),
    CodeRow::word("B3", Means::Address(Address::Vector), JOBS),
    CodeRow::word("C3", Means::Address(Address::Vector), JOBS),
    CodeRow::word("CR", Means::Address(Address::Radius), G),
    CodeRow::word("AR", Means::Address(Address::Angle), G),
    CodeRow::word("TURN", Means::Address(Address::Turns), G),
    CodeRow::word("SUPA", Means::Machine, G).of(group::ALONE),
    CodeRow::word("TRAORI", Means::TipControl(true), JOBS).of(group::TIP).alone(),
    CodeRow::word("TRAFOOF", Means::TipControl(false), JOBS).of(group::TIP).alone(),
    CodeRow::word("ORIAXES", Means::Interpolation { in_plane: false }, JOBS).of(group::POSTURE),
    CodeRow::word("ORIVECT", Means::Interpolation { in_plane: true }, JOBS).of(group::POSTURE),
    CodeRow::word("ORIMKS", Means::Frame { in_workpiece: false }, JOBS).of(group::FRAME),
    CodeRow::word("ORIWKS", Means::Frame { in_workpiece: true }, JOBS).of(group::FRAME),
    CodeRow::word(
        "TRANS",
        Means::Settles(settled::SHIFT),
        "Siemens programming manual 12/2019 (6FC5398-2EP40-0BA0), p. 631: it belongs to $P_PFRAME with ROT, SCALE and MIRROR; alone it \
         clears them (from memory)",
    )
    .of(group::SHIFT)
    .alone(),
    CodeRow::word("MCALL", Means::Statement(StatementWord::ModalCall), JOBS).of(group::CALL).alone(),
    CodeRow::word("RET", Means::End, JOBS).of(group::STOP),
    CodeRow::word("STOPRE", Means::Harmless("look-ahead stops: the blocks before are executed first"), JOBS),
    CodeRow::word(
        "IF",
        Means::Statement(StatementWord::Guard),
        "Siemens 6FC5397-0BP40, G2, 7.3; Work preparation: control structures",
    ),
    CodeRow::word(
        "ENDIF",
        Means::Statement(StatementWord::Guard),
        "Siemens 6FC5397-0BP40, G2, 7.3; Work preparation: control structures",
    ),
    CodeRow::word(";", Means::Statement(StatementWord::Comment), FORM),
    CodeRow::word("%_N_.._MPF", Means::Statement(StatementWord::ProgramNumber), FORM),
    CodeRow::word("/", Means::Statement(StatementWord::BlockDelete), FORM),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, LETTERS, WORDS, SIEMENS);
