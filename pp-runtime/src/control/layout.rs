//! The data of a job that the encoder reads: axes and decimals, units, mode, and the settings for the control.

use std::collections::BTreeMap;

use super::options::Demands;
use super::options::{ControlOptions, ProgramBlocks};
use crate::kinematics::{AnyMachine, AxisKind, Side};
use crate::motion::{Abilities, StretchModes, TipStart, rotaries_of};
use crate::options::{StretchMode, TcpWords, ThreadFeed, ToolPosture, Wrap};
use crate::program::Units;

/// The data of a job that the encoder reads.
#[derive(Debug, Clone, Default)]
pub(crate) struct Layout {
    /// Letter of each axis in chain order, with the decimals of its words. In a block they come as X Y Z U V W A B C.
    pub axes: Vec<(char, u32)>,
    /// Unit of lengths.
    pub units: Units,
    /// Decimals of linear words.
    pub linear: u32,
    /// Work offset as written in the configuration.
    pub work_offset: String,
    /// Largest deviation from the path where the control blends blocks, in `units`.
    pub path_tolerance: f64,
    /// Name of the program in the CL data.
    pub name: Vec<u8>,
    /// Axes that the control moves to every angle by the shortest path.
    pub shortest_axes: Vec<char>,
    /// Frames of the control that the program uses.
    pub frames: FramesUsed,
    /// Motion of the tool axis under tip control.
    pub posture: ToolPosture,
    /// Under tip control blocks hold the tool axis as a vector instead of rotary words.
    pub vectors: bool,
    /// Threads are cut by rigid tapping (spindle angle synchronised with the feed).
    pub rigid: bool,
    /// F of a thread is its pitch (feed per revolution), where the cycle takes an F.
    pub thread_per_revolution: bool,
    /// Names of the tools, for a comment at their calls.
    pub tool_names: BTreeMap<u32, String>,
    /// Tools are called by name, where they have one.
    pub tools_by_name: bool,
    /// Blocks of the shop at the start and the end of tools, by tool number.
    pub blocks_of_tools: BTreeMap<u32, [Vec<String>; 2]>,
    /// Settings for the control.
    pub options: ControlOptions,
    /// Blocks at the start and the end of the program.
    pub program: ProgramBlocks,
}

/// Frames of the control that a program uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct FramesUsed {
    /// Stretches of the program are under tip control.
    pub tip_control: bool,
    /// It has tilted planes: for stretches, or where tip control begins.
    pub planes: bool,
    /// It has a dynamic work offset: in mode "plane", or where tip control begins.
    pub dynamic_offset: bool,
}

impl FramesUsed {
    pub(crate) fn of(machine: &dyn AnyMachine, abilities: &Abilities, modes: &StretchModes) -> Self {
        let table = rotaries_of(machine.axes(), Side::Workpiece).next().is_some();
        let start = abilities.tip.filter(|_| table && modes.has(StretchMode::Tcp)).map(|tip| tip.start);
        let tilts = modes.has(StretchMode::Plane) && !abilities.moves_zero_in_planes(machine.axes());
        let enters_by_plane = abilities.plane.is_some() && start.is_some_and(TipStart::is_over_tilted_table);
        Self {
            tip_control: modes.has(StretchMode::Tcp),
            planes: tilts || enters_by_plane,
            dynamic_offset: start == Some(TipStart::WithMotion { dynamic_offset: true })
                || modes.has(StretchMode::Plane) && !tilts,
        }
    }
}

impl Layout {
    /// The layout of a job for a machine; `abilities`: those of its control, `modes`: of the stretches of its program.
    #[must_use]
    pub(crate) fn new(
        machine: &dyn AnyMachine,
        demands: Demands<'_>,
        abilities: &Abilities,
        modes: &StretchModes,
        units: Units,
        name: &[u8],
    ) -> Self {
        let linear = demands.formats.linear(units);
        let frames = FramesUsed::of(machine, abilities, modes);
        let decimals = |kind: AxisKind| if kind == AxisKind::Linear { linear } else { demands.formats.rotary };
        Self {
            axes: machine.axes().iter().map(|axis| (axis.letter, decimals(axis.kind))).collect(),
            units,
            linear,
            work_offset: demands.set_up.work_offset.clone(),
            path_tolerance: demands.options.path_tolerance_mm / units.in_mm(),
            name: name.to_vec(),
            shortest_axes: wrapped(demands).collect(),
            frames,
            posture: demands.motion.tip.tool_posture,
            vectors: demands.motion.tip.tcp_words == TcpWords::Vectors,
            rigid: demands.motion.cycles.rigid,
            thread_per_revolution: demands.motion.cycles.thread_feed == ThreadFeed::PerRevolution,
            tool_names: named_tools(demands),
            tools_by_name: demands.options.tool_names,
            blocks_of_tools: blocks_of_tools(demands),
            options: demands.options.clone(),
            program: demands.options.program.clone(),
        }
    }
}

/// Axes that the control moves to every angle by the shortest path.
fn wrapped(demands: Demands<'_>) -> impl Iterator<Item = char> {
    let wrap = demands.motion.rotaries.wrap.iter();
    wrap.filter(|(_, wrap)| **wrap != Wrap::Sign).map(|(letter, _)| *letter)
}

/// Names of tools.
fn named_tools(demands: Demands<'_>) -> BTreeMap<u32, String> {
    let tools = demands.set_up.tools.iter();
    tools.filter_map(|(number, tool)| Some((*number, tool.name.clone()?))).collect()
}

fn blocks_of_tools(demands: Demands<'_>) -> BTreeMap<u32, [Vec<String>; 2]> {
    let tools = demands.set_up.tools.iter().filter(|(_, tool)| !tool.start.is_empty() || !tool.end.is_empty());
    tools.map(|(number, tool)| (*number, [tool.start.clone(), tool.end.clone()])).collect()
}
