//! Abilities of a control, as far as planning depends on them.

use crate::kinematics::{Axis, Side};
use crate::motion::rotaries_of;
use crate::options::PathNorm;
use crate::program::Coolants;

use crate::motion::geometry::StraightCorners;
use crate::motion::place::PlaneAbility;
use crate::motion::place::{TipAbility, TipStart};
use crate::motion::step::CycleAbilities;

/// Abilities of a control; the planner uses no function for which the control has no code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Abilities {
    /// Kinds of coolant that have codes.
    pub coolants: Coolants,
    /// Calling or cancelling a length offset may move the axis by the length.
    pub length_call_may_move: bool,
    /// Numbering of the length offset registers.
    pub registers: Registers,
    /// All axes of a rapid arrive together, so it leads along the path of a feed motion.
    pub linear_rapids: bool,
    /// Path length that F refers to in a block in which a rotary axis moves.
    pub path_norm: PathNorm,
    /// Largest F of inverse-time feed.
    pub largest_inverse_time: f64,
    /// Units of F in one unit of length of an inch program.
    pub feed_per_inch: f64,
    /// Drilling and tapping cycles.
    pub cycles: CycleAbilities,
    /// Distance above the last depth to which a peck returns at rapid, and retract that breaks the chip, where they are
    /// set in the control and known, mm.
    pub cycle_gaps_mm: [Option<f64>; 2],
    /// Radius that cutter compensation takes.
    pub cutter_radius: CutterRadius,
    /// Corners that it takes as straight on with cutter compensation.
    pub straight_corners: Option<StraightCorners>,
    /// Tools are called by their names.
    pub tools_by_name: bool,
    /// Arcs are possible in the plane perpendicular to X, to Y and to Z.
    pub arc_planes: [bool; 3],
    /// Components of the tool axis have the letters of an arc centre: there are no arcs where they are written.
    pub vectors_take_arc_words: bool,
    /// Largest difference between the distances of both ends of an arc from its centre.
    pub arc_radius_tolerance_mm: f64,
    /// A helix is programmed by its angle: it ends where its rounded centre leads.
    pub helix_by_angle: bool,
    /// Tip control, if the control has it.
    pub tip: Option<TipAbility>,
    /// Tilted planes, if the control has them.
    pub plane: Option<PlaneAbility>,
    /// In mode "plane" the zero of the words moves with the table instead, where no rotary axis is in the head.
    pub plane_by_moved_zero: bool,
    /// The machine retract leads along the tool axis, wherever that points.
    pub retracts_along_tool: bool,
    /// The length offset is in force after the machine retract, and the code that ends it may move the tool.
    pub retract_keeps_length: bool,
    /// The control takes the time of a block from its linear axes alone, however little they move.
    pub times_faint_moves: bool,
    /// A program can stop where the control has tilted a plane with the rotary axes elsewhere.
    pub guards_planes: bool,
    /// A program can stop where a rotation, a scale, a mirror or a shift lies over the work offset.
    pub guards_offset: bool,
    /// Comparisons of the control may be in blocks that are skipped.
    pub skips_guards: bool,
    /// Blocks of the shop come at the start and at the end of each operation.
    pub operation_blocks: OperationBlocks,
}

/// Places in an operation at which blocks of the shop come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OperationBlocks {
    /// They come after the tool change, before spindle and approach.
    pub at_start: bool,
    /// They come after the machine retract.
    pub at_end: bool,
    /// Those at the start, and those at the end, clamp, open or change something: the spindle stops before them.
    pub stop_spindle: [bool; 2],
}

impl Abilities {
    /// Whether X and Y may come as axis positions over the approach point of tip control.
    #[must_use]
    pub fn enters_tip_control_by_axes(&self) -> bool {
        self.tip.is_some_and(|tip| tip.start != TipStart::Alone)
    }

    /// Whether mode "plane" is possible, on a machine with these axes.
    #[must_use]
    pub fn has_planes(&self, axes: &'static [Axis]) -> bool {
        self.plane.is_some() || self.moves_zero_in_planes(axes)
    }

    /// Whether the zero of the words moves with the table in mode "plane", on a machine with these axes.
    #[must_use]
    pub fn moves_zero_in_planes(&self, axes: &'static [Axis]) -> bool {
        self.plane_by_moved_zero && rotaries_of(axes, Side::Tool).next().is_none()
    }
}

/// Radius that cutter compensation takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterRadius {
    /// That of register D; registers are one list for all tools.
    Register,
    /// That of the tool, with a delta in the tool call.
    WithDelta {
        /// The tool call has a field for the delta.
        written: bool,
    },
    /// That of the tool.
    OfTool {
        /// The program can stop where it is more than wear.
        guarded: bool,
    },
}

/// Numbering of the length offset registers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Registers {
    /// One list for all tools; by default the register has the number of the tool.
    Shared,
    /// Cutting edges of each tool, from 1.
    Edges,
    /// The row of the tool in the tool table; no other can be chosen.
    Rows,
}

impl Registers {
    /// Register of a tool: `given`, or its default; `None` if the given one is not possible.
    #[must_use]
    pub fn of_tool(self, number: u32, given: Option<u32>) -> Option<u32> {
        match self {
            Self::Shared => Some(given.unwrap_or(number)),
            // A register equal to the tool number comes from CL data without cutting edges.
            Self::Edges => Some(given.filter(|given| *given != number).unwrap_or(1)),
            Self::Rows => Some(number).filter(|number| given.is_none_or(|given| given == *number)),
        }
    }
}
