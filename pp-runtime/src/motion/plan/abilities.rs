//! What a control can do, as far as planning has to know.

use crate::motion::options::PathNorm;

use crate::motion::place::PlaneAbility;
use crate::motion::place::TipAbility;
use crate::motion::step::CycleAbilities;

/// What a control has no code for must not be planned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Abilities {
    /// Flood coolant.
    pub flood: bool,
    /// Mist coolant.
    pub mist: bool,
    /// Coolant through the spindle.
    pub through: bool,
    /// Air.
    pub air: bool,
    /// To call or cancel a length offset may move by the length.
    pub length_call_may_move: bool,
    /// What the register of a length offset means.
    pub registers: Registers,
    /// What F counts along in a block in which a rotary axis moves.
    pub path_norm: PathNorm,
    /// Units of F in one unit of length of an inch program.
    pub feed_per_inch: f64,
    /// Cycles that it has.
    pub cycles: CycleAbilities,
    /// Registers of radii are one list for all tools.
    pub shared_radius_registers: bool,
    /// Arcs are possible in the plane square to X, to Y and to Z.
    pub arc_planes: [bool; 3],
    /// By how much the distances of the ends of an arc from its centre may differ, mm.
    pub arc_radius_tolerance_mm: f64,
    /// How it controls the tip, if it does.
    pub tip: Option<TipAbility>,
    /// How it tilts a plane, if it does.
    pub plane: Option<PlaneAbility>,
}

/// What the register of a length offset means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Registers {
    /// One list for all tools; a tool's own has its number.
    Shared,
    /// Cutting edges of each tool, from 1.
    Edges,
    /// The row of the tool; there is no choice.
    Rows,
}

impl Registers {
    /// The register of a tool, `given` or its own; `None` if it cannot be the one that is given.
    #[must_use]
    pub fn of_tool(self, number: u32, given: Option<u32>) -> Option<u32> {
        match self {
            Self::Shared => Some(given.unwrap_or(number)),
            // CL data that counts its registers like the tools knows of no edges.
            Self::Edges => Some(given.filter(|given| *given != number).unwrap_or(1)),
            Self::Rows => Some(number).filter(|number| given.is_none_or(|given| given == *number)),
        }
    }
}
