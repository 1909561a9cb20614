//! Set-ups of the parts, written out a second time, in millimetres.

use std::path::PathBuf;

use pp_runtime::nalgebra::Matrix3;
use tests::binaries::workspace;

/// Travel of a linear axis: letter, machine coordinate at the zero position, lowest, highest; mm.
pub(crate) type Travel = (char, f64, f64, f64);

/// Configuration of a program, written out a second time, in millimetres.
#[derive(Debug, Clone)]
pub(crate) struct SetUp {
    pub(crate) config: Option<&'static str>,
    pub(crate) part_origin: [f64; 3],
    pub(crate) lengths: &'static [(u32, f64)],
    pub(crate) approach_mm: f64,
    /// Retract distance along the tool axis.
    pub(crate) retract_distance_mm: Option<f64>,
    /// Machine coordinate of Z after a machine retract.
    pub(crate) retract_z_mm: f64,
    pub(crate) travel: &'static [Travel],
    pub(crate) park: &'static [(char, f64)],
    pub(crate) datum: WordDatum,
    /// Whether it is posted with tolerances so wide that no point is inserted.
    pub(crate) coarse: bool,
}

/// Rotation of the part, and datum of the words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WordDatum {
    /// Rotation that is applied to the CL data.
    pub(crate) rotation: Matrix3<f64>,
    /// Values of A, B and C minus their words, degrees.
    pub(crate) offsets_deg: [f64; 3],
    /// Whether linear words are relative to the table.
    pub(crate) from_table: bool,
    /// Whether linear words are positions of the gauge line.
    pub(crate) gauge_line: bool,
}

#[rustfmt::skip]
pub(crate) const USUAL: WordDatum = WordDatum {
    rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    offsets_deg: [0.0; 3],
    from_table: false,
    gauge_line: false,
};

pub(crate) const PLAIN: SetUp = SetUp {
    config: None,
    part_origin: [0.0; 3],
    lengths: &[],
    approach_mm: 50.0,
    retract_distance_mm: None,
    retract_z_mm: 0.0,
    travel: &[],
    park: &[],
    datum: USUAL,
    coarse: false,
};

pub(crate) const COIL: SetUp = SetUp {
    config: Some("coil/coil.toml"),
    part_origin: [35.0, 4.5, 62.0],
    lengths: &[(4, 92.3)],
    approach_mm: 20.0,
    retract_distance_mm: Some(25.0),
    retract_z_mm: -5.0,
    travel: &[('X', -180.0, -300.0, 0.0), ('Y', -95.0, -200.0, 0.0), ('Z', -310.0, -350.0, 0.0)],
    park: &[('A', 0.0)],
    datum: USUAL,
    coarse: false,
};

pub(crate) const PADS: SetUp = SetUp {
    config: Some("pads/pads.toml"),
    part_origin: [12.5, -8.0, 40.0],
    lengths: &[(21, 120.25), (22, 96.5)],
    approach_mm: 30.0,
    retract_distance_mm: Some(75.0),
    retract_z_mm: 0.0,
    travel: &[('X', 20.0, -310.0, 310.0), ('Y', -15.0, -255.0, 255.0), ('Z', -520.0, -460.0, 0.0)],
    park: &[('X', 0.0), ('Y', 240.0)],
    datum: USUAL,
    coarse: false,
};

pub(crate) fn data(name: &str) -> PathBuf {
    workspace().join("tests/data").join(name)
}

pub(crate) fn sample(name: &str) -> PathBuf {
    workspace().join("examples/cl").join(name)
}
