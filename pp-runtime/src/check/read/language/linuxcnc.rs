//! LinuxCNC.

use super::super::block::{coolant, settled};
use super::super::orders::Code;
use super::group;
use super::{Language, Means, PathCode, Pattern, Row, Statement, iso, sorted};

const G: &str = "LinuxCNC 2.9 G-code documentation";
const ORDERS: &str = "LinuxCNC 5c41560 (2026), interp_convert.cc, convert_comment";
const OVERVIEW: &str = "LinuxCNC 2.9 G-code overview";

const OWN: &[Row] = &[
    Row::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G).takes("IJKRP"),
    Row::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G).takes("IJKRP"),
    Row::new("G4", Means::Dwell, group::ALONE, G).needs("P"),
    Row::new("G8", Means::Settles(settled::DIAMETER), group::DIAMETER, G),
    Row::new("G33.1", Means::Motion(Code::RigidTap), group::MOTION, G).needs("K"),
    Row::new("G59.1", Means::Offset, group::OFFSET, G),
    Row::new("G59.2", Means::Offset, group::OFFSET, G),
    Row::new("G59.3", Means::Offset, group::OFFSET, G),
    Row::new("G61", Means::Path(PathCode::ExactPath), group::PATH, G),
    Row::new("G61.1", Means::Path(PathCode::ExactStop), group::PATH, G),
    Row::new("G64", Means::Path(PathCode::Continuous), group::PATH, G).takes("PQ"),
    Row::new("G74", Means::Hole(Pattern::FloatingTap { left: true }), group::MOTION, G).needs("R").takes("P"),
    Row::new("G84", Means::Hole(Pattern::FloatingTap { left: false }), group::MOTION, G).needs("R").takes("P"),
    Row::new("G90.1", Means::ArcCentres { absolute: true }, group::CENTRE, G),
    Row::new("G91.1", Means::ArcCentres { absolute: false }, group::CENTRE, G),
    Row::new("G97", Means::Settles(settled::CUTTING_SPEED), group::SPINDLE_MODE, G),
    Row::new("M7", Means::CoolantOn(coolant::MIST), group::COOLANT, "LinuxCNC 2.9 M-code documentation"),
];

const COUNT: usize = iso::ROWS.len() + OWN.len();

static CODES: [Row; COUNT] = sorted(&[iso::ROWS, OWN]);

const LINES: &[Row] = &[
    Row::word("%", Means::Statement(Statement::ProgramMark), OVERVIEW),
    Row::word("(..)", Means::Statement(Statement::Comment), OVERVIEW),
    Row::word(";", Means::Statement(Statement::Comment), OVERVIEW),
    Row::word("(MSG,", Means::Statement(Statement::Message), ORDERS),
    Row::word("(DEBUG,", Means::Statement(Statement::Message), ORDERS),
    Row::word("(PRINT,", Means::Statement(Statement::Message), ORDERS),
    Row::word("/", Means::Statement(Statement::BlockDelete), OVERVIEW),
    Row::word("o.. if", Means::Statement(Statement::Guard), "LinuxCNC 2.9 O-code documentation"),
    Row::word("(abort,", Means::Statement(Statement::Guard), ORDERS),
    Row::word("o.. endif", Means::Statement(Statement::Guard), "LinuxCNC 2.9 O-code documentation"),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, iso::LETTERS, LINES, &[]);
