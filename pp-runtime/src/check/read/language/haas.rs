//! Haas NGC.

use super::super::block::{coolant, settled};
use super::super::orders::{LengthCode, Pattern};
use super::{CodeRow, Language, Means, Plane, Smoother, group, iso, sorted};

const G: &str = "Haas 96-8000 (mill operator's manual), G codes; haascnc.com, page of the code";
const UMC: &str = "Haas UMC manual; haascnc.com, page of the code";
const DYNAMIC: &str = "Haas UMC manual, p. 56; haascnc.com, page of G254";
const M: &str = "Haas 96-8000 (mill operator's manual), M codes; haascnc.com, page of the code";

const OWN: &[CodeRow] = &[
    CodeRow::new("G4", Means::Dwell, group::ALONE, G).needs("P"),
    // G68 and G51 are options.
    CodeRow::new("G50", Means::Settles(settled::SCALING), group::SCALING, G),
    CodeRow::new("G69", Means::Settles(settled::ROTATION), group::ROTATION, G),
    CodeRow::new("G74", Means::Hole(Pattern::Tap { left: true }), group::MOTION, G).needs("R"),
    CodeRow::new("G76", Means::Hole(Pattern::FineBore), group::MOTION, "Haas 96-8000 (mill operator's manual), p. 187")
        .needs("R")
        .takes("PIJ"),
    CodeRow::new("G84", Means::Hole(Pattern::Tap { left: false }), group::MOTION, G).needs("R"),
    CodeRow::new("G154", Means::FurtherOffset, group::OFFSET, G).needs("P"),
    CodeRow::new("G187", Means::Smoothing(Smoother::Level), group::SMOOTHING, G).takes("PE").alone(),
    CodeRow::new("G254", Means::DynamicOffset(true), group::DYNAMIC_OFFSET, DYNAMIC),
    CodeRow::new("G255", Means::DynamicOffset(false), group::DYNAMIC_OFFSET, DYNAMIC),
    CodeRow::new("G234", Means::Length(LengthCode::TipControl), group::LENGTH, UMC).needs("H"),
    CodeRow::new("G253", Means::Orient, group::TILT, UMC),
    CodeRow::new("G268", Means::TiltedPlane(Plane::Haas), group::TILT, UMC).takes("IJK").needs("Q"),
    CodeRow::new("G269", Means::TiltOff, group::TILT, UMC),
    CodeRow::new("M88", Means::CoolantOn(coolant::THROUGH), group::COOLANT, M),
    CodeRow::new("M89", Means::CoolantOff(coolant::THROUGH), group::COOLANT, M),
];

const COUNT: usize = iso::ROWS.len() + iso::OF_TWO.len() + OWN.len();

static CODES: [CodeRow; COUNT] = sorted(&[iso::ROWS, iso::OF_TWO, OWN]);

pub(super) static LANGUAGE: Language = Language::new(&CODES, iso::LETTERS, iso::LINES, &[]);
