//! Motion in cuts: arcs, cycles, cutter compensation, feeds, and what the CL data may leave out.

use crate::program::{Coolant, Rotation};

/// What becomes of arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcOutput {
    /// Arcs of the control where it can say them within tolerance, else lines.
    Native,
    /// Lines.
    Lines,
}

/// What says where the centre is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcForm {
    /// The centre.
    Centre,
    /// The radius, except where it says nothing: whole turns, and close to half ones.
    Radius,
}

/// Arcs of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct ArcOptions {
    /// What becomes of them; default [`ArcOutput::Native`].
    pub output: ArcOutput,
    /// What says where the centre is; default [`ArcForm::Centre`].
    pub form: ArcForm,
    /// Smaller ones become lines, mm; default 0.01.
    pub smallest_radius: f64,
    /// Larger ones become lines, mm; default 10 000.
    pub largest_radius: f64,
}

impl Default for ArcOptions {
    fn default() -> Self {
        Self { output: ArcOutput::Native, form: ArcForm::Centre, smallest_radius: 0.01, largest_radius: 10_000.0 }
    }
}

/// What becomes of holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleOutput {
    /// Cycles of the control where they mean the same, else single motions.
    Native,
    /// Single motions.
    Expanded,
}

/// Cycles of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleOptions {
    /// What becomes of holes; default [`CycleOutput::Native`].
    pub output: CycleOutput,
    /// Threads are cut with the spindle under control of its angle, where that has a code; default true.
    pub rigid: bool,
}

impl Default for CycleOptions {
    fn default() -> Self {
        Self { output: CycleOutput::Native, rigid: true }
    }
}

/// What the CL data under CUTCOM is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterPath {
    /// The path of the tool's centre: the register holds wear.
    Centre,
    /// The contour: the register holds the radius.
    Contour,
}

/// What F counts along in a block in which a rotary axis moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathNorm {
    /// The linear axes; degrees where none of them moves.
    Xyz,
    /// Linear and rotary axes alike: √(Σ mm² + Σ degrees²).
    XyzDegrees,
    /// Nothing: F is 1/min.
    G93Minutes,
    /// Nothing: F is 1/s.
    G93Seconds,
}

/// What the CL data may leave out.
#[derive(Debug, Clone, PartialEq)]
pub struct Defaults {
    /// Spindle speed, rev/min; default none.
    pub speed: Option<f64>,
    /// Sense of rotation; default none.
    pub rotation: Option<Rotation>,
    /// The kind that COOLNT/ON means; default [`Coolant::Flood`]. Never `On` or `Off`.
    pub coolant: Coolant,
    /// The tool of CL data that calls none before it moves; default none.
    pub tool: Option<u32>,
    /// How far above the bottom a rapid ends in a hole that is drilled in steps, mm; default 0.5.
    pub peck_gap: f64,
}

/// How fast blocks may run.
#[derive(Debug, Clone, PartialEq)]
pub struct FeedLimits {
    /// Blocks in which an axis would be faster than it can run longer; default true.
    pub keep_speeds: bool,
    /// Largest F of the control, mm/min; default none.
    pub largest: Option<f64>,
    /// Shortest time of a block, seconds; default 0.
    pub shortest_block: f64,
}

impl Default for Defaults {
    fn default() -> Self {
        Self { speed: None, rotation: None, coolant: Coolant::Flood, tool: None, peck_gap: 0.5 }
    }
}

impl Default for FeedLimits {
    fn default() -> Self {
        Self { keep_speeds: true, largest: None, shortest_block: 0.0 }
    }
}
