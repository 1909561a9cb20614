//! The job as an encoder sees it: axes and decimals, units, mode, and what the configuration sets of the control.

use super::options::Demands;
use super::options::{ControlOptions, ProgramBlocks};
use crate::kinematics::{AxisKind, Machine};
use crate::motion::{Mode, TcpWords, ToolPosture, Wrap};
use crate::program::Units;

/// The job as an encoder sees it.
#[derive(Debug, Clone, Default)]
pub struct Layout {
    /// Letters of the axes in chain order, and the decimals of their words; blocks hold them as X Y Z U V W A B C.
    pub axes: Vec<(char, u32)>,
    /// Unit of lengths.
    pub units: Units,
    /// Decimals of lengths.
    pub linear: u32,
    /// Work offset as the configuration has it.
    pub work_offset: String,
    /// How far the control may leave the path where it blends blocks, in `units`.
    pub path_tolerance: f64,
    /// Name of the program in the CL data.
    pub name: Vec<u8>,
    /// Rotary axes take the shortest path.
    pub shortest_path: bool,
    /// The coordinates of the words of a motion.
    pub mode: Mode,
    /// How the tool axis moves under tip control.
    pub posture: ToolPosture,
    /// Blocks hold the tool axis in the place of rotary words.
    pub vectors: bool,
    /// Threads are cut with the spindle under control of its angle.
    pub rigid: bool,
    /// What the configuration sets of the control.
    pub options: ControlOptions,
    /// Blocks around the program.
    pub program: ProgramBlocks,
}

impl Layout {
    /// The layout of a job for the machine `M`.
    #[must_use]
    pub fn new<M: Machine>(demands: Demands<'_>, units: Units, name: &[u8]) -> Self {
        let linear = demands.formats.linear(units);
        let decimals = |kind: AxisKind| if kind == AxisKind::Linear { linear } else { demands.formats.rotary };
        Self {
            axes: M::AXES.iter().map(|axis| (axis.letter, decimals(axis.kind))).collect(),
            units,
            linear,
            work_offset: demands.set_up.work_offset.clone(),
            path_tolerance: demands.options.path_tolerance_mm / units.in_mm(),
            name: name.to_vec(),
            shortest_path: demands.motion.rotaries.wrap.values().any(|wrap| *wrap != Wrap::Sign),
            mode: demands.motion.mode,
            posture: demands.motion.tip.tool_posture,
            vectors: demands.motion.mode == Mode::Tcp && demands.motion.tip.tcp_words == TcpWords::Vectors,
            rigid: demands.motion.cycles.rigid,
            options: demands.options.clone(),
            program: demands.options.program.clone(),
        }
    }
}
