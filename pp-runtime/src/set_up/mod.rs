//! What is true of machine, part and shop today, and what several stages read: where the part lies, what words count from,
//! which tools there are, how the machine differs from its declaration.
//!
//! Data only, in mm, rad and mm/min. Nothing here reads a file, plans or writes; whatever a single stage decides by is an
//! option of that stage.

mod machine;

use std::collections::BTreeMap;

use nalgebra::Rotation3;

use crate::kinematics::Limits;
use crate::program::{Coolant, Rotation};

pub use machine::AxisBounds;

/// Machine, part and shop of a job. Lengths in mm, angles in rad, speeds in mm/min and rad/min.
#[derive(Debug, Clone, PartialEq)]
pub struct SetUp {
    /// Part zero from the table's reference point along the table's directions, mm; default 0, 0, 0.
    pub part_origin: [f64; 3],
    /// Turns the CL data before anything else: how the part lies on the table; default not at all.
    pub part_rotation: Rotation3<f64>,
    /// The written word of a rotary axis is its value minus this, rad; default none.
    pub rotary_offset: BTreeMap<char, f64>,
    /// Where linear words count from; default [`ProgramZero::Part`].
    pub program_zero: ProgramZero,
    /// What linear words say of the tool; default [`LengthMode::Tip`].
    pub length_mode: LengthMode,
    /// The word of the work offset; default `G54`.
    pub work_offset: String,
    /// Work offsets of frames of the CL data other than the first, by number; default none.
    pub frames: BTreeMap<u32, String>,
    /// Machine coordinate of linear axes at the zero position without tool, mm; default none: linear limits unchecked.
    pub machine_zero: BTreeMap<char, f64>,
    /// Tools by number; default none.
    pub tools: BTreeMap<u32, GivenTool>,
    /// The blank as it lies on the table; default none: a box around all cuts.
    pub stock: Option<Stock>,
    /// Dimensions of the machine that differ from its declaration, mm or rad; default none.
    pub dimensions: BTreeMap<String, f64>,
    /// Travel that differs from the machine's declaration, mm or rad, `None` for an endless axis; default none.
    pub limits: BTreeMap<char, Option<Limits>>,
    /// Largest axis speeds that differ from the machine's declaration, mm/min or rad/min; default none.
    pub speeds: BTreeMap<char, f64>,
}

impl Default for SetUp {
    fn default() -> Self {
        Self {
            part_origin: [0.0; 3],
            part_rotation: Rotation3::identity(),
            rotary_offset: BTreeMap::new(),
            program_zero: ProgramZero::Part,
            length_mode: LengthMode::Tip,
            work_offset: "G54".to_owned(),
            frames: BTreeMap::new(),
            machine_zero: BTreeMap::new(),
            tools: BTreeMap::new(),
            stock: None,
            dimensions: BTreeMap::new(),
            limits: BTreeMap::new(),
            speeds: BTreeMap::new(),
        }
    }
}

impl SetUp {
    /// `[rx, ry, rz]` of `part_rotation`, degrees, to nine decimals.
    pub(crate) fn part_angles(&self) -> [f64; 3] {
        let (x, y, z) = self.part_rotation.euler_angles();
        [x, y, z].map(|angle| (angle.to_degrees() * 1e9).round() / 1e9 + 0.0)
    }
}

/// What is known about one tool besides the CL data; everything defaults to unknown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GivenTool {
    /// From gauge line to tip, mm.
    pub length: Option<f64>,
    /// Cutting diameter, mm; only compared with the CL data.
    pub diameter: Option<f64>,
    /// Length offset register (H); default: the tool's number or what the CL data says.
    pub offset: Option<u32>,
    /// Register of its radius (D); default: what CUTCOM says or the tool's number.
    pub radius_offset: Option<u32>,
    /// Spindle speed where the CL data gives none, rev/min.
    pub speed: Option<f64>,
    /// Sense of rotation where the CL data gives none.
    pub rotation: Option<Rotation>,
    /// Cuts turning counter-clockwise; default false.
    pub left_handed: bool,
    /// The kind that COOLNT/ON means for this tool.
    pub coolant: Option<Coolant>,
    /// Name for header and comments.
    pub name: Option<String>,
}

/// A box around the blank, for the pictures of a control, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stock {
    /// Its lowest corner.
    pub lower: [f64; 3],
    /// Its highest corner.
    pub upper: [f64; 3],
}

/// Where linear words count from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramZero {
    /// The part zero.
    Part,
    /// The table's reference point.
    Table,
}

/// What linear words say of the tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthMode {
    /// Where its tip is at the zero position of the rotary axes; the length offset is active.
    Tip,
    /// Where its gauge line is; no length offset is active.
    Gauge,
}
