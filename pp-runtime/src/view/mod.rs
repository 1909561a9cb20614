//! A program as people look at it: the page (`view`), the set-up sheet (`report`), and pictures.
//!
//! What is shown is the program as the check's reader understands its text, not what the planner meant: `executed`
//! collects its points while it is checked, and holds them in memory. `cl_facts` has what only the CL data states,
//! `reasons` why a line is there.
//!
//! The page is one file: `page` writes it, with the data of `head` and `columns` and the script of the folder `page/`;
//! `html` has what all documents share. `sheet` has the
//! facts that are readable without a script, in the page and in the set-up sheet (`report`), `picture` the drawings.
//! Text from outside reaches a document as escaped text only.

mod cl_facts;
mod columns;
mod drawing;
mod executed;
mod head;
mod html;
mod page;
mod picture;
mod reasons;
mod report;
mod sheet;
#[cfg(feature = "simulate")]
mod simulated;

use std::io::{self, Cursor, Read};

use nalgebra::Point3;

#[cfg(feature = "simulate")]
use crate::check::read::MAX_AXES;
use crate::check::read::TextPieces;
use crate::check::{CheckError, CheckPolicy, Checked, check_data};
use crate::cl::{ClData, FromHere};
use crate::kinematics::{AnyMachine, AxisKind};

use columns::{Column, Columns};
use executed::{Executed, ExecutedPoint};

pub(crate) use cl_facts::ClFacts;
#[cfg(feature = "simulate")]
pub(crate) use cl_facts::ClTool;
pub(crate) use drawing::drawing;
pub(crate) use executed::Collector;
#[cfg(feature = "simulate")]
pub(crate) use executed::{ExecutedMotion, ExecutedPlace, Motions};
pub(crate) use html::is_document;
pub(crate) use page::write_page;
pub(crate) use picture::path_and_axes;
pub(crate) use reasons::Reasons;
pub(crate) use report::{ReportForm, write_report};
#[cfg(feature = "simulate")]
pub(crate) use simulated::{PageBody, PageStage, Role, SimulatedLinePart, SimulatedPage, ToolPart};

/// Step of linear axes and tips, mm.
const LENGTH_STEP: f64 = 1e-5;

/// Step of rotary axes, degrees.
const ANGLE_STEP: f64 = 1e-5;

/// Step of the components of tool axes.
const DIRECTION_STEP: f64 = 1e-6;

/// Names and texts that are shown with a program.
pub(crate) struct Titles {
    /// Name of the program.
    pub(crate) program: String,
    /// Name of the CL data.
    pub(crate) cl: String,
    /// Name of the control.
    pub(crate) control: &'static str,
    /// Lines of the summary of `post`.
    pub(crate) summary: Vec<String>,
    /// Warnings about the CL data.
    pub(crate) warnings: Vec<String>,
}

/// A program as the check has executed it.
pub(crate) struct Execution {
    executed: Executed,
    pub(crate) checked: Checked,
}

impl Execution {
    /// Executes a program, and compares it with its CL data.
    ///
    /// # Errors
    /// Those of a check.
    pub(crate) fn of(
        machine: &dyn AnyMachine,
        policy: &CheckPolicy,
        cl: &mut dyn ClData,
        text: &mut dyn TextPieces,
    ) -> Result<Self, CheckError> {
        let mut collector = Collector::new(machine, policy);
        let checked = check_data(machine, policy, cl, text, Some(&mut collector))?;
        Ok(Self { executed: collector.finish(), checked })
    }
}

/// Text of a program, and the reasons of its lines.
#[derive(Clone, Copy)]
pub(crate) struct ProgramText<'a> {
    pub(crate) text: &'a [u8],
    pub(crate) reasons: &'a Reasons,
}

/// An executed program with all that is shown of it.
pub(crate) struct ViewedProgram<'a> {
    titles: Titles,
    text: &'a [u8],
    policy: &'a CheckPolicy,
    /// The machine of the set-up.
    machine: Box<dyn AnyMachine>,
    executed: Executed,
    facts: ClFacts,
    /// Text of the CL data.
    cl_text: Vec<u8>,
    checked: Checked,
    reasons: &'a Reasons,
    #[cfg(feature = "simulate")]
    simulated: Option<SimulatedPage>,
}

impl<'a> ViewedProgram<'a> {
    /// What is shown of a program. `execution`: as it was executed while it was posted; otherwise it is executed now.
    ///
    /// # Errors
    /// Those of a check.
    pub(crate) fn new(
        machine: &dyn AnyMachine,
        policy: &'a CheckPolicy,
        cl: &mut dyn Read,
        ProgramText { text, reasons }: ProgramText<'a>,
        titles: Titles,
        execution: Option<Execution>,
    ) -> Result<Self, CheckError> {
        let mut cl_text = Vec::new();
        cl.read_to_end(&mut cl_text).map_err(CheckError::Input)?;
        let facts = ClFacts::read(&*cl_text, policy.reading.clone()).map_err(CheckError::Input)?;
        let Execution { executed, checked } = match execution {
            Some(execution) => execution,
            None => {
                let mut cl = Cursor::new(&cl_text);
                let mut cl = FromHere::new(&mut cl).map_err(CheckError::Input)?;
                Execution::of(machine, policy, &mut cl, &mut &*text)?
            }
        };
        let machine =
            policy.set_up.machine_for(machine).map_err(|invalid| CheckError::Impossible(invalid.to_string()))?;
        Ok(Self {
            titles,
            text,
            policy,
            machine,
            executed,
            facts,
            cl_text,
            checked,
            reasons,
            #[cfg(feature = "simulate")]
            simulated: None,
        })
    }

    /// Whether the program does what the CL data asks for.
    pub(crate) fn passed(&self) -> bool {
        self.checked.passed()
    }

    /// Result of the check.
    pub(crate) fn checked(&self) -> &Checked {
        &self.checked
    }

    /// Shows the simulation, too.
    #[cfg(feature = "simulate")]
    pub(crate) fn add_simulation(&mut self, simulated: SimulatedPage) {
        self.simulated = Some(simulated);
    }

    /// Set-up and tool offsets of each placement: machine coordinate of each linear axis less value and `machine_zero`,
    /// mm.
    #[cfg(feature = "simulate")]
    pub(crate) fn placements(&self) -> impl Iterator<Item = (u32, &[f64; MAX_AXES])> {
        self.executed.placements.iter().map(|placement| (placement.set_up, &placement.offsets_mm))
    }

    /// The simulation as JSON.
    #[cfg(feature = "simulate")]
    fn simulation(&self) -> Option<serde_json::Result<String>> {
        self.simulated.as_ref().map(serde_json::to_string)
    }

    /// The simulation as JSON.
    #[cfg(not(feature = "simulate"))]
    fn simulation(&self) -> Option<serde_json::Result<String>> {
        None
    }

    /// Lines of the summary, with the figures of the check and of a simulation.
    fn summary(&self) -> Vec<String> {
        let checked = self.titles.summary.iter().cloned().chain(self.checked.outcome.lines());
        #[cfg(feature = "simulate")]
        let checked = checked.chain(self.simulated.iter().flat_map(|simulated| simulated.summary.iter().cloned()));
        checked.collect()
    }

    /// The machine with its first tool.
    fn first_machine(&self) -> &dyn AnyMachine {
        self.executed.placements.first().map_or(&*self.machine, |placement| &*placement.machine)
    }

    /// Numbers of the set-ups in which the machine moves; of all where it moves in none.
    fn moving_set_ups(&self) -> impl Iterator<Item = u32> {
        let placements = &self.executed.placements;
        let moves =
            |number: u32| placements.is_empty() || placements.iter().any(|placement| placement.set_up == number);
        self.policy.set_up.clampings().map(|(number, _)| number).filter(move |number| moves(*number))
    }

    /// Position of a set-up in the list of set-ups.
    fn set_up_index(&self, number: u32) -> usize {
        self.policy.set_up.clampings().position(|(other, _)| other == number).unwrap_or(0)
    }

    /// Whether machine coordinates of an axis are known; else its values are shown.
    fn has_coordinates(&self, index: usize) -> bool {
        let axis = &self.machine.axes()[index];
        axis.kind == AxisKind::Rotary || self.policy.set_up.machine_zero.contains_key(&axis.letter)
    }

    /// Position of an axis at each point, mm and rad: machine coordinates of a linear axis, where they are known.
    fn coordinates(&self, index: usize) -> Vec<f64> {
        let axis = &self.machine.axes()[index];
        let linear = axis.kind == AxisKind::Linear && self.has_coordinates(index);
        let zero_mm = self.policy.set_up.machine_zero.get(&axis.letter).copied().unwrap_or(0.0);
        let at = |point: &ExecutedPoint| {
            let offset_mm = self.executed.placements[point.placement].offsets_mm[index];
            point.axes[index] + if linear { zero_mm + offset_mm } else { 0.0 }
        };
        self.executed.points.iter().map(at).collect()
    }

    /// Corners of the blank in the coordinates of a set-up: that of the configuration in the first, or a box around all
    /// cuts.
    fn part_corners(&self, set_up: u32, cuts: &[&ExecutedPoint]) -> Option<[Point3<f64>; 2]> {
        if let Some(stock) = self.policy.set_up.stock.filter(|_| set_up == 1) {
            return Some([stock.lower.into(), stock.upper.into()]);
        }
        let first = cuts.first()?.pose.tip;
        let corners = cuts.iter().fold([first; 2], |[low, high], point| {
            let tip = &point.pose.tip;
            [low.inf(tip), high.sup(tip)]
        });
        Some(corners)
    }

    /// The points as columns.
    fn columns(&self) -> io::Result<(Vec<Column>, String)> {
        let (points, mut columns) = (&self.executed.points, Columns::default());
        for (index, axis) in self.machine.axes().iter().enumerate() {
            let name = format!("axis.{}", axis.letter);
            match axis.kind {
                AxisKind::Linear => columns.quantised(name, LENGTH_STEP, points.iter().map(|point| point.axes[index])),
                AxisKind::Rotary => {
                    columns.quantised(name, ANGLE_STEP, points.iter().map(|point| point.axes[index].to_degrees()));
                }
            }
        }
        for (index, letter) in ["x", "y", "z"].into_iter().enumerate() {
            let values = points.iter().map(|point| point.pose.tip[index]);
            columns.quantised(format!("tip.{letter}"), LENGTH_STEP, values);
        }
        for (index, letter) in ["i", "j", "k"].into_iter().enumerate() {
            let values = points.iter().map(|point| point.pose.axis[index]);
            columns.quantised(format!("tool.{letter}"), DIRECTION_STEP, values);
        }
        columns.quantised("line", 1.0, points.iter().map(|point| point.line as f64));
        columns.quantised("cl_line", 1.0, points.iter().map(|point| point.cl_line as f64));
        columns.small("kind", points.iter().map(|point| point.kind as u8));
        columns.small("reason", points.iter().map(|point| self.reasons.of(point.line)));
        columns.indices("operation", points.iter().map(|point| point.operation));
        columns.indices("placement", points.iter().map(|point| point.placement));
        columns.floats("feed", points.iter().map(|point| Some(point.feed)));
        columns.floats("seconds", points.iter().map(|point| point.seconds));
        columns.floats("error", points.iter().map(|point| point.deviation_mm.map(|deviation| deviation * 1e3)));
        columns.encoded()
    }
}
