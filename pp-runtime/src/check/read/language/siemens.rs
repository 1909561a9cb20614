//! Siemens 840D sl and ONE.

use super::super::block::{FeedMode, Side, WorkPlane, coolant, settled};
use super::super::orders::Code;
use super::arguments::SIEMENS;
use super::group;
use super::{Address, Language, Means, PathCode, Row, Statement, sorted};
use crate::program::{Rotation, Units};

const G: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Tables: G functions";
const M: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Auxiliary function outputs";
const FORM: &str = "Siemens Fundamentals 05/2017 (A5E40869423), Fundamental principles of NC programming";
const JOBS: &str = "Siemens programming manual 12/2019 (6FC5398-2EP40-0BA0), Work preparation: transformations";

const OWN: &[Row] = &[
    Row::new("G0", Means::Motion(Code::Rapid), group::MOTION, G),
    Row::new("G1", Means::Motion(Code::Feed), group::MOTION, G),
    Row::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G),
    Row::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G),
    Row::new("G4", Means::Dwell, group::ALONE, G).takes("FS"),
    Row::new("G9", Means::Path(PathCode::Window), group::PATH, G),
    Row::new("G17", Means::Plane(WorkPlane::Xy), group::PLANE, G),
    Row::new("G18", Means::Plane(WorkPlane::Zx), group::PLANE, G),
    Row::new("G19", Means::Plane(WorkPlane::Yz), group::PLANE, G),
    Row::new("G40", Means::Side(Side::None), group::SIDE, G),
    Row::new("G41", Means::Side(Side::Left), group::SIDE, G),
    Row::new("G42", Means::Side(Side::Right), group::SIDE, G),
    Row::new("G53", Means::Machine, group::ALONE, G),
    Row::new("G153", Means::Machine, group::ALONE, G),
    Row::new("G54", Means::Offset, group::OFFSET, G).up_to("G57"),
    Row::new("G500", Means::Offset, group::OFFSET, G),
    Row::new("G505", Means::Offset, group::OFFSET, G).up_to("G599"),
    Row::new("G60", Means::Path(PathCode::ExactStop), group::PATH, G),
    Row::new("G64", Means::Path(PathCode::Continuous), group::PATH, G),
    Row::new("G70", Means::Units(Units::Inches), group::UNITS, G),
    Row::new("G71", Means::Units(Units::Millimetres), group::UNITS, G),
    Row::new("G90", Means::Distances { incremental: false }, group::DISTANCE, G),
    Row::new("G91", Means::Distances { incremental: true }, group::DISTANCE, G),
    Row::new("G93", Means::FeedMode(FeedMode::InverseTime), group::FEED, G),
    Row::new("G94", Means::FeedMode(FeedMode::PerMinute), group::FEED, G),
    Row::new("G95", Means::FeedMode(FeedMode::PerRevolution), group::FEED, G),
    Row::new("G601", Means::Path(PathCode::Window), group::WINDOW, G),
    Row::new("G641", Means::Path(PathCode::Smoothed(641)), group::PATH, G),
    Row::new("G642", Means::Path(PathCode::Smoothed(642)), group::PATH, G),
    Row::new("G643", Means::Path(PathCode::Smoothed(643)), group::PATH, G),
    Row::new("G644", Means::Path(PathCode::Smoothed(644)), group::PATH, G),
    Row::new("G645", Means::Path(PathCode::Smoothed(645)), group::PATH, G),
    Row::new("G700", Means::UnitsOfFeed(Units::Inches), group::UNITS, G),
    Row::new("G710", Means::UnitsOfFeed(Units::Millimetres), group::UNITS, G),
    Row::new("M0", Means::Stop { optional: false }, group::STOP, M),
    Row::new("M1", Means::Stop { optional: true }, group::STOP, M),
    Row::new("M2", Means::End, group::STOP, M),
    Row::new("M17", Means::End, group::STOP, M),
    Row::new("M30", Means::End, group::STOP, M),
    Row::new("M3", Means::Spindle(Some(Rotation::Clockwise)), group::SPINDLE, M),
    Row::new("M4", Means::Spindle(Some(Rotation::CounterClockwise)), group::SPINDLE, M),
    Row::new("M5", Means::Spindle(None), group::SPINDLE, M),
    Row::new("M6", Means::ToolChange, group::CHANGE, M),
    Row::new("M7", Means::CoolantOn(coolant::MIST), group::COOLANT, M),
    Row::new("M8", Means::CoolantOn(coolant::FLOOD), group::COOLANT, M),
    Row::new("M9", Means::CoolantOff(coolant::FLOOD | coolant::MIST), group::COOLANT, M),
];

static CODES: [Row; OWN.len()] = sorted(&[OWN]);

const LETTERS: &[Row] = &[
    Row::word("N", Means::Address(Address::BlockNumber), FORM),
    Row::word("G", Means::Address(Address::Code), FORM),
    Row::word("M", Means::Address(Address::Code), FORM),
    Row::word("F", Means::Address(Address::Feed), FORM),
    Row::word("S", Means::Address(Address::Speed), FORM),
    Row::word("T", Means::Address(Address::Tool), FORM),
    Row::word("D", Means::Address(Address::Edge), FORM),
    Row::word("I", Means::Address(Address::Centre), FORM),
    Row::word("J", Means::Address(Address::Centre), FORM),
    Row::word("K", Means::Address(Address::Centre), FORM),
];

const WORDS: &[Row] = &[
    Row::word("A3", Means::Address(Address::Vector), JOBS),
    Row::word("B3", Means::Address(Address::Vector), JOBS),
    Row::word("C3", Means::Address(Address::Vector), JOBS),
    Row::word("CR", Means::Address(Address::Radius), G),
    Row::word("AR", Means::Address(Address::Angle), G),
    Row::word("TURN", Means::Address(Address::Turns), G),
    Row::word("SUPA", Means::Machine, G).of(group::ALONE),
    Row::word("TRAORI", Means::TipControl(true), JOBS).of(group::TIP).alone(),
    Row::word("TRAFOOF", Means::TipControl(false), JOBS).of(group::TIP).alone(),
    Row::word("ORIAXES", Means::Interpolation { in_plane: false }, JOBS).of(group::POSTURE),
    Row::word("ORIVECT", Means::Interpolation { in_plane: true }, JOBS).of(group::POSTURE),
    Row::word("ORIMKS", Means::Frame { in_workpiece: false }, JOBS).of(group::FRAME),
    Row::word("ORIWKS", Means::Frame { in_workpiece: true }, JOBS).of(group::FRAME),
    Row::word(
        "TRANS",
        Means::Settles(settled::SHIFT),
        "Siemens programming manual 12/2019 (6FC5398-2EP40-0BA0), p. 631: it belongs to $P_PFRAME with ROT, SCALE and MIRROR; alone it \
         clears them (from memory)",
    )
    .of(group::SHIFT)
    .alone(),
    Row::word("MCALL", Means::Statement(Statement::ModalCall), JOBS).of(group::CALL).alone(),
    Row::word("RET", Means::End, JOBS).of(group::STOP),
    Row::word("STOPRE", Means::Harmless("look-ahead stops: the blocks before are executed first"), JOBS),
    Row::word(
        "IF",
        Means::Statement(Statement::Guard),
        "Siemens 6FC5397-0BP40, G2, 7.3; Work preparation: control structures",
    ),
    Row::word(
        "ENDIF",
        Means::Statement(Statement::Guard),
        "Siemens 6FC5397-0BP40, G2, 7.3; Work preparation: control structures",
    ),
    Row::word(";", Means::Statement(Statement::Comment), FORM),
    Row::word("%_N_.._MPF", Means::Statement(Statement::ProgramNumber), FORM),
    Row::word("/", Means::Statement(Statement::BlockDelete), FORM),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, LETTERS, WORDS, SIEMENS);
