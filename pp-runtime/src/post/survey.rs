//! The survey: first pass over the CL text. Collects what the header needs and what is known only at the end of the
//! text.
//!
//! Plans the course of the rotary axes in the same pass, where a machine is given. Writes nothing.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Display, Formatter};
use std::io;
use std::ops::{ControlFlow, RangeInclusive};

use nalgebra::UnitVector3;

use crate::cl::{ClEvents, FileFacts};
use crate::config::Config;
use crate::control::StepCycles;
use crate::diag::code::{config, plan};
use crate::diag::{Diagnostic, Severity, counted};
use crate::kinematics::math::{larger, smaller};
use crate::kinematics::{AnyMachine, Pose};
use crate::motion::{
    Begins, Course, ItemAction, ModeFinder, MotionIndex, Navigator, OperationStart, Policy, ProgramItem, Source, Stage,
    StretchModes, extent, hole_extent,
};
use crate::options::{Mode, OperationSettings, Operations, StretchMode};
use crate::program::{
    CutterSide, Event, Interruption, Location, MachineFunction, NewStart, Spindle, TextKind, ToolCall,
};
use crate::set_up::{FurtherSetUp, GivenTool};

use super::operations::{OperationNames, SelectedOperations};
use crate::tolerance::writer::SAME_AXIS;

/// Largest number of different tools of a program; bounds the memory and the header.
const MOST_TOOLS: usize = 1000;

/// Largest number of tool changes that are known in advance, for the next tool at a tool change; bounds the memory.
const MOST_CHANGES: usize = 10_000;

/// A tool of the program and its use.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ToolUse {
    pub(crate) call: ToolCall,
    /// Number of operations in which the tool moves.
    pub(crate) operations: u64,
    /// Lowest and highest Z of the tip, after `part_rotation`, mm.
    pub(crate) tip_z_mm: Option<(f64, f64)>,
    /// Lowest and highest corner of the box around the tip positions at feed, mm.
    pub(crate) cuts_mm: Option<[[f64; 3]; 2]>,
    /// The tool cuts without a SPINDL record after its call: speed and direction come from the configuration.
    pub(crate) spindle_assumed: bool,
}

/// Facts about the whole program.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Survey {
    pub(crate) name: Vec<u8>,
    pub(crate) file: FileFacts,
    /// Number of operations of the whole program.
    pub(crate) operations: u64,
    /// Stretches in which the tool axis is held, and in which it turns at feed.
    pub(crate) stretches: Stretches,
    /// Tools that move, in the order of their numbers.
    pub(crate) tools: Vec<ToolUse>,
    /// The spindle is left without a tool.
    pub(crate) empties_spindle: bool,
    /// Tool numbers in the order in which the tools are used.
    pub(crate) order: Vec<u32>,
    /// Tools that are called while CUTCOM requests compensation.
    pub(crate) compensated: BTreeSet<u32>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Place of the first error: from here on nothing is posted.
    pub(crate) first_error: Option<Location>,
    /// Branch and turns of the rotary axes.
    pub(crate) course: Course,
    /// In every feed motion the tool axis points down: the frame of the part is probably upside down.
    pub(crate) upside_down: bool,
    /// Further set-ups that begin.
    pub(crate) set_ups: BTreeSet<u32>,
    /// Mode of each stretch.
    pub(crate) modes: StretchModes,
    /// Settings of operations, each with the names of those that have them.
    pub(crate) settings: Vec<(OperationSettings, OperationNames)>,
    /// Names of all operations, where the configuration has settings of operations.
    pub(crate) names: OperationNames,
    /// Numbers of the operations to be posted, `None` for all; a sentence if they do not exist.
    pub(crate) selected: Option<Result<RangeInclusive<u64>, String>>,
    /// There are holes.
    pub(crate) holes: bool,
    /// There are blocks that may be skipped at the control.
    pub(crate) skips: bool,
    /// Holes in steps.
    pub(crate) step_cycles: StepCycles,
    /// First motion whose tool axis is not that of the machine with its rotary axes at zero.
    pub(crate) tilted: Option<Location>,
}

/// Number of stretches by the motion of the tool axis. A stretch is the part of an operation between two changes of the
/// tool axis in the air, or its holes; those without cuts do not count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stretches {
    /// The tool axis is held.
    pub held: u64,
    /// The tool axis turns at feed.
    pub turning: u64,
    /// The tool axis turns at feed here and in the stretch before it in its operation: a link may lead from one to the
    /// other.
    pub linked: u64,
}

impl Stretches {
    /// The line of the summary.
    pub(crate) fn summary(self) -> String {
        let (held, turning) = (counted(self.held, "stretch"), counted(self.turning, "stretch"));
        format!("tool axis: held in {held}, rotating at feed in {turning}")
    }
}

/// Modes of the words of a program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct UsedModes {
    /// That of the configuration.
    pub configured: Mode,
    /// Those of the stretches, where it is chosen for each.
    pub chosen: Vec<StretchMode>,
}

impl UsedModes {
    pub(super) fn of(config: &Config, survey: &Survey) -> Self {
        let chosen = match config.motion.mode_of_all() {
            Some(_) => Vec::new(),
            None => survey.modes.used().collect(),
        };
        Self { configured: config.motion.mode, chosen }
    }
}

impl Display for UsedModes {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let chosen: Vec<&str> = self.chosen.iter().map(|mode| mode.name()).collect();
        out.write_str(self.configured.name())?;
        if chosen.is_empty() { Ok(()) } else { write!(out, " ({})", chosen.join(", ")) }
    }
}

impl Survey {
    /// Adds an error. Nothing is posted from the place of the first one.
    pub(crate) fn refuse(&mut self, error: Diagnostic) {
        let first = self.first_error.map_or(error.location, |first| first.min(error.location));
        self.first_error = Some(first);
        self.diagnostics.push(error);
    }

    /// Runs the first pass: reads the whole file once, for the survey and the course.
    pub(crate) fn take(
        machine: &dyn AnyMachine,
        mut events: ClEvents<'_>,
        policy: Policy<'_>,
        modes: ModeFinder,
        navigator: Option<Navigator>,
    ) -> io::Result<Self> {
        let mut source = Source::new(machine, policy);
        let surveyor = Surveyor::new(policy.options.selected.clone(), machine.tool_axis());
        let mut pass = FirstPass { surveyor, modes, navigator };
        // An event that cannot be expanded is reported by the planner in the last pass.
        events.all(|at, event| {
            let _ = source.event(at, event, &mut pass);
            ControlFlow::<()>::Continue(())
        })?;
        // The first pass reports no errors of the source.
        let _ = source.finish(&mut pass);
        let course = pass.navigator.map_or_else(Course::default, Navigator::finish);
        let modes = pass.modes.finish();
        let mut file = events.into_facts().unwrap_or_default();
        let found = std::mem::take(&mut file.diagnostics);
        let mut survey = Self { course, modes, file, ..pass.surveyor.finish() };
        survey.diagnostics.splice(..0, found);
        if survey.diagnostics.iter().all(|diagnostic| diagnostic.severity != Severity::Error) {
            let end = Location { line: survey.file.lines.max(1), column: 1 };
            let missing = policy.set_up.set_ups.iter().find(|(number, _)| !survey.set_ups.contains(number));
            survey.diagnostics.extend(missing.map(|(&number, set_up)| set_up_missing(number, set_up, end)));
            let unused =
                source.unused_settings().filter_map(|entry| survey.names.unused(entry, survey.operations, end));
            survey.diagnostics.extend(unused.collect::<Vec<_>>());
        }
        let errors = survey.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
        survey.first_error = errors.map(|error| error.location).min();
        survey.tools.sort_by_key(|tool| tool.call.number);
        Ok(survey)
    }
}

/// Receivers of the first pass.
struct FirstPass {
    surveyor: Surveyor,
    modes: ModeFinder,
    navigator: Option<Navigator>,
}

/// An error of the first pass, ignored: it occurs again in the last pass and is reported there.
struct Ignored;

impl From<Diagnostic> for Ignored {
    fn from(_: Diagnostic) -> Self {
        Self
    }
}

impl Stage for FirstPass {
    type Stop = Ignored;

    #[inline]
    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Ignored> {
        self.surveyor.follow(item);
        self.modes.follow(item);
        match &mut self.navigator {
            Some(navigator) => Ok(navigator.take(item)?),
            None => Ok(()),
        }
    }
}

/// The survey in progress.
#[derive(Debug)]
struct Surveyor {
    survey: Survey,
    selection: SelectedOperations,
    /// Tool axis in the workpiece with all rotary axes at zero.
    tool_axis: UnitVector3<f64>,
    calls: CalledTools,
    stretch: PresentStretch,
    /// In the first set-up: the blank is in its coordinates.
    first_set_up: bool,
    /// The tool axis has pointed down in every feed motion; `None` before the first.
    cuts_down: Option<bool>,
}

/// Calls of tools so far.
#[derive(Debug)]
struct CalledTools {
    /// By number; for tools that have moved their index in `survey.tools`.
    so_far: BTreeMap<u32, Option<usize>>,
    last: Option<ToolCall>,
    /// CUTCOM requests compensation.
    compensates: bool,
    /// Index of the current tool in `survey.tools`, once it has moved.
    current: Option<usize>,
    /// The spindle has been programmed for the current tool.
    spindle: bool,
    /// No motion since the end of the last operation.
    between: bool,
    /// A tool has been called and there was no motion since.
    called: bool,
}

/// The stretch that is being surveyed.
#[derive(Debug, Default)]
struct PresentStretch {
    number: u64,
    /// It has cuts.
    cuts: bool,
    /// The tool axis turns in a cut.
    turning: bool,
    /// It turns in the stretch before, in the same operation.
    turned_before: bool,
}

impl PresentStretch {
    /// Counts the stretch, which ends.
    fn end(&mut self, stretches: &mut Stretches) {
        match (std::mem::take(&mut self.cuts), std::mem::take(&mut self.turning)) {
            (true, true) => {
                stretches.turning += 1;
                stretches.linked += u64::from(std::mem::replace(&mut self.turned_before, true));
            }
            (true, false) => {
                stretches.held += 1;
                self.turned_before = false;
            }
            (false, _) => {}
        }
    }
}

impl Surveyor {
    fn new(select: Option<Operations>, tool_axis: UnitVector3<f64>) -> Self {
        Self {
            survey: Survey::default(),
            selection: SelectedOperations::of(select),
            tool_axis,
            calls: CalledTools {
                so_far: BTreeMap::new(),
                last: None,
                compensates: false,
                current: None,
                spindle: false,
                between: true,
                called: false,
            },
            stretch: PresentStretch::default(),
            first_set_up: true,
            cuts_down: None,
        }
    }

    fn finish(mut self) -> Survey {
        self.stretch.end(&mut self.survey.stretches);
        self.note_change();
        self.survey.upside_down = self.cuts_down == Some(true);
        self.survey.selected = self.selection.numbers(self.survey.operations);
        self.survey
    }

    #[inline(always)]
    fn follow(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { motion, index, .. } => {
                let at: [f64; 3] = motion.pose.tip.into();
                self.begin(index);
                self.note_axis(item.at, &motion.pose);
                self.moved(!motion.rapid, [at; 2], &motion.pose);
            }
            _ => self.follow_other(item),
        }
    }

    /// Takes an item that is no straight motion.
    fn follow_other(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { .. } => {}
            ItemAction::Arc { arc, index } => {
                self.begin(index);
                self.note_axis(item.at, &arc.end);
                self.moved(true, extent(arc, self.cuts_so_far()), &arc.end);
            }
            ItemAction::Hole { hole, index } => {
                let [over, inside] = hole_extent(hole);
                self.survey.holes = true;
                self.survey.step_cycles.add(&hole.drilling);
                self.begin(index);
                self.note_axis(item.at, &hole.top);
                self.moved(false, over, &hole.top);
                self.moved(true, inside, &hole.top);
            }
            ItemAction::Operation(start) => {
                self.survey.names.add(start);
                self.note_settings(start);
            }
            ItemAction::Record { event, between } => {
                self.record(item.at, event);
                self.calls.between |= between;
            }
        }
    }

    /// Notes the settings of the operation that begins.
    fn note_settings(&mut self, start: &OperationStart<'_>) {
        let settings = start.chosen.values();
        if settings == OperationSettings::default() {
            return;
        }
        let known = &mut self.survey.settings;
        let index = known.iter().position(|(known, _)| *known == settings).unwrap_or_else(|| {
            known.push((settings, OperationNames::default()));
            known.len() - 1
        });
        known[index].1.add(start);
    }

    fn record(&mut self, at: Location, event: &Event<'_>) {
        if self.calls.called && event.writes_block() {
            self.note_change();
        }
        match *event {
            Event::Text(TextKind::Name, name) => {
                if self.survey.name.is_empty() {
                    self.survey.name = name.to_vec();
                }
            }
            Event::NewStart(NewStart::Operation(name)) => self.selection.name(name),
            Event::NewStart(NewStart::Tool(call @ ToolCall { number: 0, .. })) => {
                // A tool that was called and has not moved never comes into the spindle.
                self.survey.empties_spindle = true;
                (self.calls.last, self.calls.called, self.calls.current) = (Some(call), true, None);
            }
            Event::NewStart(NewStart::Tool(call)) => self.call_tool(at, call),
            Event::Function(MachineFunction::Spindle(Spindle::On { .. })) => self.calls.spindle = true,
            Event::Interruption(Interruption::BlockSkip { .. }) => self.survey.skips = true,
            Event::NewStart(NewStart::SetUp(number)) => {
                self.first_set_up = number == 1;
                self.survey.set_ups.insert(number);
            }
            Event::Function(MachineFunction::Compensation(asked)) => {
                self.calls.compensates = asked.side != CutterSide::Off;
                self.note_compensation();
            }
            Event::Motion(_)
            | Event::NewStart(_)
            | Event::Interruption(_)
            | Event::Function(_)
            | Event::Reference(_)
            | Event::Text(..) => {}
        }
    }

    fn call_tool(&mut self, at: Location, call: ToolCall) {
        if self.calls.so_far.len() < MOST_TOOLS {
            self.calls.so_far.entry(call.number).or_default();
        } else if !self.calls.so_far.contains_key(&call.number) && self.survey.diagnostics.is_empty() {
            self.survey.diagnostics.push(too_many_tools(at));
        }
        if self.calls.last.is_none_or(|before| before.number != call.number) {
            // A SPINDL before the first tool call of an operation counts for that tool.
            self.calls.spindle &= self.calls.between && !self.calls.called;
        }
        self.calls.called = true;
        self.calls.last = Some(call);
        self.note_compensation();
        self.calls.current = None;
    }

    /// Notes that the tool may cut with cutter compensation.
    fn note_compensation(&mut self) {
        if let Some(call) = self.calls.last.filter(|_| self.calls.compensates)
            && self.calls.so_far.contains_key(&call.number)
        {
            self.survey.compensated.insert(call.number);
        }
    }

    /// Notes the begin of a motion, which may be the first of an operation or of a stretch.
    #[inline(always)]
    fn begin(&mut self, index: MotionIndex) {
        if index.stretch != self.stretch.number {
            self.stretch.end(&mut self.survey.stretches);
            self.stretch.number = index.stretch;
        }
        self.stretch.turning |= index.rotates_axis;
        self.calls.called = false;
        self.calls.between = false;
        if index.begins != Begins::Nothing {
            self.begin_operation(index.operation);
        }
    }

    fn begin_operation(&mut self, number: u64) {
        self.survey.operations = number;
        self.stretch.turned_before = false;
        self.selection.begin(number);
        let call = self.calls.last.filter(|_| self.selection.holds(number));
        self.calls.current = call.and_then(|call| {
            let known_index = self.calls.so_far.get_mut(&call.number)?;
            Some(self.survey.tool(call, known_index))
        });
        self.note_change();
        if let Some(index) = self.calls.current {
            self.survey.tools[index].operations += 1;
        }
    }

    /// The tool that has been called last comes into the spindle.
    fn note_change(&mut self) {
        let order = &mut self.survey.order;
        if let Some(call) = self.calls.last.filter(|call| order.last() != Some(&call.number))
            && order.len() < MOST_CHANGES
        {
            order.push(call.number);
        }
    }

    #[inline(always)]
    fn note_axis(&mut self, at: Location, pose: &Pose) {
        if self.survey.tilted.is_none() && (pose.axis.into_inner() - self.tool_axis.into_inner()).norm() > SAME_AXIS {
            self.survey.tilted = Some(at);
        }
    }

    /// Box around the tip positions at feed of the current tool so far, if those of this set-up belong to it.
    fn cuts_so_far(&self) -> Option<[[f64; 3]; 2]> {
        self.survey.tools[self.calls.current?].cuts_mm.filter(|_| self.first_set_up)
    }

    /// Notes a motion of the tip within a box (lowest and highest corner, mm). `cuts`: at feed.
    #[inline(always)]
    fn moved(&mut self, cuts: bool, [lowest, highest]: [[f64; 3]; 2], pose: &Pose) {
        if cuts {
            self.stretch.cuts = true;
            if self.cuts_down != Some(false) {
                self.cuts_down = Some(pose.axis.dot(&self.tool_axis) < 0.0);
            }
        }
        if let Some(index) = self.calls.current {
            let tool = &mut self.survey.tools[index];
            let (low, high) = tool.tip_z_mm.unwrap_or((lowest[2], highest[2]));
            tool.tip_z_mm = Some((smaller(lowest[2], low), larger(highest[2], high)));
            if cuts && self.first_set_up {
                let [lower, upper] = tool.cuts_mm.get_or_insert([lowest, highest]);
                for index in 0..3 {
                    (lower[index], upper[index]) =
                        (smaller(lowest[index], lower[index]), larger(highest[index], upper[index]));
                }
            }
            tool.spindle_assumed |= cuts && !self.calls.spindle;
        }
    }
}

/// The error that a set-up of the configuration does not begin: its frames would count as those of the first.
fn set_up_missing(number: u32, set_up: &FurtherSetUp, location: Location) -> Diagnostic {
    let begins = match &set_up.begins {
        Some(name) => format!("no operation is called `{name}`"),
        None => "the CL data does not state its frames".to_owned(),
    };
    Diagnostic {
        code: config::SET_UP,
        severity: Severity::Error,
        location,
        length: 1,
        count: 1,
        text: format!("set-up {number} of the configuration does not begin: {begins}"),
        help: Some("correct `begins` or `frames`, or remove the set-up".to_owned()),
    }
}

fn too_many_tools(location: Location) -> Diagnostic {
    Diagnostic {
        code: plan::TOOL,
        severity: Severity::Error,
        location,
        length: 1,
        count: 1,
        text: format!("the CL data calls more than {MOST_TOOLS} different tools"),
        help: Some("check the tool numbers in the CAM system; if the file holds several programs, post each from a file of its own".to_owned()),
    }
}

impl ToolUse {
    /// Radius of the tool, from the configuration or the CL data, mm.
    pub(super) fn radius_mm(&self, config: &Config) -> Option<f64> {
        let [diameter, _] = GivenTool::size_mm(config.set_up.tools.get(&self.call.number), &self.call);
        diameter.map(|diameter| diameter / 2.0)
    }
}

impl Survey {
    /// Index of a tool in `tools`; adds it if it is new, and completes it with the data of this call.
    fn tool(&mut self, call: ToolCall, known_index: &mut Option<usize>) -> usize {
        let index = *known_index.get_or_insert_with(|| {
            self.tools.push(ToolUse { call, operations: 0, tip_z_mm: None, cuts_mm: None, spindle_assumed: false });
            self.tools.len() - 1
        });
        let known = &mut self.tools[index].call;
        *known = call.completed_by(known);
        index
    }
}
