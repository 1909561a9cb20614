//! Fanuc 30i and its kin.

use super::super::block::{coolant, settled};
use super::super::orders::{LengthCode, Pattern};
use super::{CodeRow, Language, Means, Plane, Smoother, group, iso, sorted};

const M: &str = "Fanuc B-63944EN/02 (2004), auxiliary functions; the machine builder's list of M codes (from memory)";

const RIGID: &str = "Fanuc B-63944EN/02 (2004), rigid tapping: M29 before the cycle (from memory)";

const OWN: &[CodeRow] = &[
    CodeRow::new("G4", Means::Dwell, group::ALONE, "Fanuc B-63944EN/02 (2004), dwell").takes("PX"),
    CodeRow::new(
        "G5.1",
        Means::Smoothing(Smoother::Contour),
        group::SMOOTHING,
        "Fanuc B-63944EN/02 (2004), AI contour control (from memory)",
    )
    .needs("Q")
    .takes("R")
    .alone(),
    CodeRow::new(
        "G43.4",
        Means::Length(LengthCode::TipControl),
        group::LENGTH,
        "Fanuc A-79294E, p. 11; A-79348E, p. 16",
    )
    .needs("H")
    .takes("P"),
    CodeRow::new(
        "G43.5",
        Means::Length(LengthCode::TipVector),
        group::LENGTH,
        "Fanuc A-79294E, p. 11; A-79348E, p. 16",
    )
    .needs("H")
    .takes("PIJK"),
    CodeRow::new("G53.1", Means::Orient, group::TILT, "Fanuc B-63784EN, tool axis direction control"),
    CodeRow::new(
        "G54.1",
        Means::FurtherOffset,
        group::OFFSET,
        "Fanuc B-63944EN/02 (2004), additional workpiece coordinate systems",
    )
    .needs("P"),
    // From memory; without their option these codes raise an alarm.
    CodeRow::new(
        "G15",
        Means::Settles(settled::POLAR),
        group::POLAR,
        "Fanuc B-63944EN/02 (2004), polar coordinate command",
    ),
    CodeRow::new("G50", Means::Settles(settled::SCALING), group::SCALING, "Fanuc B-63944EN/02 (2004), scaling"),
    CodeRow::new(
        "G54.4",
        Means::Settles(settled::SETTING_ERROR),
        group::SETTING_ERROR,
        "Fanuc A-79634E, workpiece setting error compensation",
    )
    .needs("P"),
    CodeRow::new("G68.2", Means::TiltedPlane(Plane::Euler), group::TILT, "Fanuc B-63784EN, tilted working plane")
        .takes("IJK"),
    CodeRow::new("G69", Means::TiltOff, group::TILT, "Fanuc B-63784EN, tilted working plane"),
    CodeRow::new("G74", Means::Hole(Pattern::TapAfterRigid { left: true }), group::MOTION, RIGID).needs("R").takes("P"),
    CodeRow::new("G76", Means::Hole(Pattern::FineBore), group::MOTION, "Fanuc 15i operator's manual, p. 315")
        .needs("RQ")
        .takes("P"),
    CodeRow::new("G84", Means::Hole(Pattern::TapAfterRigid { left: false }), group::MOTION, RIGID)
        .needs("R")
        .takes("P"),
    CodeRow::new("M7", Means::CoolantOn(coolant::MIST), group::COOLANT, M),
    CodeRow::new("M29", Means::Rigid, group::RIGID, RIGID).needs("S").alone(),
];

const COUNT: usize = iso::ROWS.len() + iso::OF_TWO.len() + OWN.len();

static CODES: [CodeRow; COUNT] = sorted(&[iso::ROWS, iso::OF_TWO, OWN]);

pub(super) static LANGUAGE: Language = Language::new(&CODES, iso::LETTERS, iso::LINES, &[]);
