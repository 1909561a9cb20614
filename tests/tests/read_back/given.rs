//! Set-ups of the parts, stated once more in millimetres.

use std::path::PathBuf;

use pp_runtime::nalgebra::Matrix3;
use tests::binaries::workspace;

/// Travel of a linear axis: letter, machine coordinate at the zero position, lowest, highest; mm.
pub(crate) type Travel = (char, f64, f64, f64);

/// What the configuration of a program says, stated once more in millimetres.
#[derive(Debug, Clone)]
pub(crate) struct SetUp {
    pub(crate) config: Option<&'static str>,
    pub(crate) part_origin: [f64; 3],
    pub(crate) lengths: &'static [(u32, f64)],
    pub(crate) approach: f64,
    /// Distance along the tool axis.
    pub(crate) out: Option<f64>,
    /// Machine coordinate of Z.
    pub(crate) retract: f64,
    pub(crate) travel: &'static [Travel],
    pub(crate) park: &'static [(char, f64)],
    pub(crate) counting: Counting,
    /// Posted with tolerances so wide that no point is inserted.
    pub(crate) coarse: bool,
}

/// How the part lies, and what words count from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Counting {
    /// The CL data is multiplied by this.
    pub(crate) rotation: Matrix3<f64>,
    /// Degrees between words and values of A, B and C.
    pub(crate) offsets: [f64; 3],
    /// Linear words count from the table.
    pub(crate) from_table: bool,
    /// Linear words are those of the gauge line.
    pub(crate) gauge_line: bool,
}

#[rustfmt::skip]
pub(crate) const USUAL: Counting = Counting {
    rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    offsets: [0.0; 3],
    from_table: false,
    gauge_line: false,
};

pub(crate) const PLAIN: SetUp = SetUp {
    config: None,
    part_origin: [0.0; 3],
    lengths: &[],
    approach: 50.0,
    out: None,
    retract: 0.0,
    travel: &[],
    park: &[],
    counting: USUAL,
    coarse: false,
};

pub(crate) const COIL: SetUp = SetUp {
    config: Some("coil/coil.toml"),
    part_origin: [35.0, 4.5, 62.0],
    lengths: &[(4, 92.3)],
    approach: 20.0,
    out: Some(25.0),
    retract: -5.0,
    travel: &[('X', -180.0, -300.0, 0.0), ('Y', -95.0, -200.0, 0.0), ('Z', -310.0, -350.0, 0.0)],
    park: &[('A', 0.0)],
    counting: USUAL,
    coarse: false,
};

pub(crate) const PADS: SetUp = SetUp {
    config: Some("pads/pads.toml"),
    part_origin: [12.5, -8.0, 40.0],
    lengths: &[(21, 120.25), (22, 96.5)],
    approach: 30.0,
    out: Some(75.0),
    retract: 0.0,
    travel: &[('X', 20.0, -310.0, 310.0), ('Y', -15.0, -255.0, 255.0), ('Z', -520.0, -460.0, 0.0)],
    park: &[('X', 0.0), ('Y', 240.0)],
    counting: USUAL,
    coarse: false,
};

pub(crate) fn data(name: &str) -> PathBuf {
    workspace().join("tests/data").join(name)
}

pub(crate) fn sample(name: &str) -> PathBuf {
    workspace().join("examples/cl").join(name)
}
