//! LinuxCNC.

use super::super::block::{coolant, settled};
use super::super::orders::{Code, Pattern};
use super::{CodeRow, Language, Means, PathCode, StatementWord, group, iso, sorted};

const G: &str = "LinuxCNC 2.9 G-code documentation";
const ORDERS: &str = "LinuxCNC 5c41560 (2026), interp_convert.cc, convert_comment";
const OVERVIEW: &str = "LinuxCNC 2.9 G-code overview";

const OWN: &[CodeRow] = &[
    CodeRow::new("G2", Means::Motion(Code::Clockwise), group::MOTION, G).takes("IJKRP"),
    CodeRow::new("G3", Means::Motion(Code::CounterClockwise), group::MOTION, G).takes("IJKRP"),
    CodeRow::new("G4", Means::Dwell, group::ALONE, G).needs("P"),
    CodeRow::new("G8", Means::Settles(settled::DIAMETER), group::DIAMETER, G),
    CodeRow::new("G33.1", Means::Motion(Code::RigidTap), group::MOTION, G).needs("K"),
    CodeRow::new("G59.1", Means::Offset, group::OFFSET, G),
    CodeRow::new("G59.2", Means::Offset, group::OFFSET, G),
    CodeRow::new("G59.3", Means::Offset, group::OFFSET, G),
    CodeRow::new("G61", Means::Path(PathCode::ExactPath), group::PATH, G),
    CodeRow::new("G61.1", Means::Path(PathCode::ExactStop), group::PATH, G),
    CodeRow::new("G64", Means::Path(PathCode::Continuous), group::PATH, G).takes("PQ"),
    CodeRow::new("G74", Means::Hole(Pattern::FloatingTap { left: true }), group::MOTION, G).needs("R").takes("P"),
    CodeRow::new("G84", Means::Hole(Pattern::FloatingTap { left: false }), group::MOTION, G).needs("R").takes("P"),
    CodeRow::new("G90.1", Means::ArcCentres { absolute: true }, group::CENTRE, G),
    CodeRow::new("G91.1", Means::ArcCentres { absolute: false }, group::CENTRE, G),
    CodeRow::new("G97", Means::Settles(settled::CUTTING_SPEED), group::SPINDLE_MODE, G),
    CodeRow::new("M7", Means::CoolantOn(coolant::MIST), group::COOLANT, "LinuxCNC 2.9 M-code documentation"),
];

const COUNT: usize = iso::ROWS.len() + OWN.len();

static CODES: [CodeRow; COUNT] = sorted(&[iso::ROWS, OWN]);

const LINES: &[CodeRow] = &[
    CodeRow::word("%", Means::Statement(StatementWord::ProgramMark), OVERVIEW),
    CodeRow::word("(..)", Means::Statement(StatementWord::Comment), OVERVIEW),
    CodeRow::word(";", Means::Statement(StatementWord::Comment), OVERVIEW),
    CodeRow::word("(MSG,", Means::Statement(StatementWord::Message), ORDERS),
    CodeRow::word("(DEBUG,", Means::Statement(StatementWord::Message), ORDERS),
    CodeRow::word("(PRINT,", Means::Statement(StatementWord::Message), ORDERS),
    CodeRow::word("/", Means::Statement(StatementWord::BlockDelete), OVERVIEW),
    CodeRow::word("o.. if", Means::Statement(StatementWord::Guard), "LinuxCNC 2.9 O-code documentation"),
    CodeRow::word("(abort,", Means::Statement(StatementWord::Guard), ORDERS),
    CodeRow::word("o.. endif", Means::Statement(StatementWord::Guard), "LinuxCNC 2.9 O-code documentation"),
];

pub(super) static LANGUAGE: Language = Language::new(&CODES, iso::LETTERS, LINES, &[]);
