//! The first pass over the CL text: what the header needs, and what can be known only at the end.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::ops::RangeInclusive;

use nalgebra::UnitVector3;

use crate::cl::{ArcVote, ClReader, Dialect, ReadingOptions};
use crate::config::{list, nearest};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AnyMachine, Pose};
use crate::motion::{
    Begins, Course, ItemAction, MotionIndex, Navigator, Operations, Policy, ProgramItem, Source, Stage, extent,
    hole_extent,
};
use crate::program::{Event, Location, Spindle, ToolCall, Units};

/// More tools than this are not one program; it bounds the memory and the header.
const MOST_TOOLS: usize = 1000;

/// Names of operations that are remembered, and that a message lists.
const MOST_NAMES: usize = 1000;
const MOST_LISTED: usize = 10;

/// So many tool changes are known beforehand; it bounds the memory.
const MOST_CHANGES: usize = 10_000;

/// One tool of the program.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ToolUse {
    pub(crate) call: ToolCall,
    /// Operations that cut or move with it.
    pub(crate) operations: u64,
    /// Lowest and highest tip of the part as it lies, mm.
    pub(crate) tip: Option<(f64, f64)>,
    /// Lowest and highest corner of the box around the tips of its cuts, mm.
    pub(crate) cuts: Option<[[f64; 3]; 2]>,
    /// It cuts before any SPINDL/.. behind its call: speed and direction come from the configuration.
    pub(crate) spindle_assumed: bool,
}

/// What the reader has found out about a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct FileFacts {
    pub(crate) units: Option<Units>,
    pub(crate) units_only_given: bool,
    /// A frame is stated in the file.
    pub(crate) framed: bool,
    pub(crate) dialect: Dialect,
    pub(crate) arcs: ArcVote,
    /// Different frames.
    pub(crate) frames: usize,
    /// How often CSYS changes.
    pub(crate) setup_changes: u64,
    /// The CAM system asks for inverse-time feed.
    pub(crate) inverse_time: bool,
    pub(crate) lines: u64,
}

impl FileFacts {
    fn of<R: Read>(reader: &ClReader<R>) -> Self {
        Self {
            units: reader.units(),
            units_only_given: reader.units_are_only_given(),
            framed: reader.frame().is_some(),
            dialect: reader.dialect(),
            arcs: reader.arcs(),
            frames: reader.different_frames(),
            setup_changes: reader.setup_changes(),
            inverse_time: reader.asks_for_inverse_time(),
            lines: reader.lines(),
        }
    }
}

/// What the whole program says.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Survey {
    pub(crate) name: Vec<u8>,
    pub(crate) file: FileFacts,
    /// Operations of the whole program.
    pub(crate) operations: u64,
    /// Stretches of operations in which the tool axis is held, and in which it turns at feed.
    pub(crate) stretches: Stretches,
    /// Tools that move, by number.
    pub(crate) tools: Vec<ToolUse>,
    /// Tools in the order in which they come into the spindle.
    pub(crate) order: Vec<u32>,
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// Nothing may be posted from here on.
    pub(crate) first_error: Option<Location>,
    /// The course of the rotary axes.
    pub(crate) course: Course,
    /// Every tool axis of a feed motion points down: the frame of the part is probably upside down.
    pub(crate) upside_down: bool,
    /// The operations that are posted, `None` for all; a sentence if there are none, or not as many.
    pub(crate) wanted: Option<Result<RangeInclusive<u64>, String>>,
}

/// Stretches by what the tool axis does in them: a stretch is what is cut between two changes of the tool axis in the air.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stretches {
    /// The tool axis is held.
    pub held: u64,
    /// It turns at feed.
    pub turning: u64,
}

impl Stretches {
    /// For people.
    pub(crate) fn summary(self) -> String {
        let (held, turning) = (super::counted(self.held, "stretch"), super::counted(self.turning, "stretch"));
        format!("tool axis: held in {held}, turning at feed in {turning}")
    }
}

impl Survey {
    /// The first pass: reads the whole file, for the survey and the course alike.
    pub(crate) fn take(
        machine: &dyn AnyMachine,
        input: impl Read,
        options: ReadingOptions,
        policy: Policy<'_>,
        navigator: Option<Navigator>,
    ) -> io::Result<Self> {
        let mut reader = ClReader::new(input, options);
        let mut source = Source::new(machine, policy);
        let surveyor = Surveyor::new(policy.options.operations.clone(), machine.tool_axis());
        let mut pass = FirstPass { surveyor, navigator };
        loop {
            // Looked at where it lies: to move an event costs as much as to look at it.
            let found = reader.next_event();
            match &found {
                // What cannot be expanded is the planner's to report.
                Ok(Some((at, event))) => drop(source.event(*at, event, &mut pass)),
                Ok(None) => break,
                Err(_) => {
                    found?;
                }
            }
        }
        // The first pass refuses nothing.
        let _ = source.finish(&mut pass);
        let course = pass.navigator.map_or_else(Course::default, Navigator::finish);
        let mut survey = Self { course, file: FileFacts::of(&reader), ..pass.surveyor.finish() };
        let found = reader.diagnostics().iter().cloned();
        survey.diagnostics = found.chain(std::mem::take(&mut survey.diagnostics)).collect();
        let errors = survey.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
        survey.first_error = errors.map(|error| error.location).min();
        survey.tools.sort_by_key(|tool| tool.call.number);
        Ok(survey)
    }
}

/// Everything that sees the first pass.
struct FirstPass {
    surveyor: Surveyor,
    navigator: Option<Navigator>,
}

/// What the first pass refuses: nothing, all of it comes up again in the last.
struct Ignored;

impl From<Diagnostic> for Ignored {
    fn from(_: Diagnostic) -> Self {
        Self
    }
}

impl Stage for FirstPass {
    type Stop = Ignored;

    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Ignored> {
        self.surveyor.follow(item);
        match &mut self.navigator {
            Some(navigator) => Ok(navigator.take(item)?),
            None => Ok(()),
        }
    }
}

/// The survey while it is taken.
#[derive(Debug)]
struct Surveyor {
    survey: Survey,
    selection: WantedOperations,
    /// Tool axis with every rotary axis at zero.
    tool_axis: UnitVector3<f64>,
    /// Tools called so far, and where those that have moved are in the list.
    called_so_far: BTreeMap<u32, Option<usize>>,
    call: Option<ToolCall>,
    /// Index of the current tool, once it has moved.
    tool: Option<usize>,
    /// The spindle has been programmed for the tool.
    spindle: bool,
    /// Nothing has moved since the last operation.
    between: bool,
    /// A tool has been called and nothing has moved since.
    called: bool,
    /// The tool axis turns at feed in the stretch at hand.
    turning: bool,
    /// Feed motions, and those with the tool axis down.
    feeds: u64,
    feeds_down: u64,
}

impl Surveyor {
    fn new(select: Option<Operations>, tool_axis: UnitVector3<f64>) -> Self {
        Self {
            survey: Survey::default(),
            selection: WantedOperations { select, ..WantedOperations::default() },
            tool_axis,
            called_so_far: BTreeMap::new(),
            call: None,
            tool: None,
            spindle: false,
            between: true,
            called: false,
            turning: false,
            feeds: 0,
            feeds_down: 0,
        }
    }

    fn finish(mut self) -> Survey {
        if self.survey.operations > 0 {
            self.end_stretch();
        }
        self.survey.upside_down = self.feeds > 0 && self.feeds == self.feeds_down;
        self.survey.wanted = self.selection.wanted(self.survey.operations);
        self.survey
    }

    fn follow(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { motion, index, .. } => {
                let at: [f64; 3] = motion.pose.tip.into();
                self.begin(index);
                self.moved(!motion.rapid, [at; 2], &motion.pose);
            }
            ItemAction::Arc { arc, index } => {
                self.begin(index);
                self.moved(true, extent(arc), &arc.end);
            }
            ItemAction::Hole { hole, index } => {
                let [over, inside] = hole_extent(hole);
                self.begin(index);
                self.moved(false, over, &hole.top);
                self.moved(true, inside, &hole.top);
            }
            ItemAction::Record { event, between } => {
                self.record(item.at, event);
                self.between |= between;
            }
        }
    }

    fn record(&mut self, at: Location, event: &Event<'_>) {
        match *event {
            Event::Name(name) => {
                if self.survey.name.is_empty() {
                    self.survey.name = name.to_vec();
                }
            }
            Event::Operation(name) => self.selection.name(name),
            Event::Tool(call) => self.call_tool(at, call),
            Event::Spindle(Spindle::On { .. }) => self.spindle = true,
            Event::Spindle(Spindle::Off)
            | Event::MachineName(_)
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Preselect(_)
            | Event::Coolant(_)
            | Event::Compensation(_)
            | Event::From(_)
            | Event::Move(_)
            | Event::Arc(_)
            | Event::Spline(_)
            | Event::Hole(_)
            | Event::Home
            | Event::ClearancePlane(_)
            | Event::Tolerance(_)
            | Event::RotaryDirection(_)
            | Event::Delay(_)
            | Event::OptionalStop
            | Event::Stop
            | Event::Message(_)
            | Event::Insert(_)
            | Event::Code { .. } => {}
        }
    }

    fn call_tool(&mut self, at: Location, call: ToolCall) {
        if self.called_so_far.len() < MOST_TOOLS {
            self.called_so_far.entry(call.number).or_default();
        } else if !self.called_so_far.contains_key(&call.number) && self.survey.diagnostics.is_empty() {
            self.survey.diagnostics.push(too_many_tools(at));
        }
        if self.call.is_none_or(|before| before.number != call.number) {
            // A SPINDL in the same start counts for the first tool that is called there.
            self.spindle &= self.between && !self.called;
        }
        self.called = true;
        self.call = Some(call);
        self.tool = None;
    }

    /// A motion begins; it may be the first of an operation, or of a stretch.
    fn begin(&mut self, index: MotionIndex) {
        if index.stretch != self.survey.stretches.held + self.survey.stretches.turning + 1 {
            self.end_stretch();
        }
        self.turning |= index.rotates_axis;
        self.called = false;
        self.between = false;
        if index.begins != Begins::Nothing {
            self.begin_operation(index.operation);
        }
    }

    fn end_stretch(&mut self) {
        let stretches = &mut self.survey.stretches;
        match std::mem::take(&mut self.turning) {
            true => stretches.turning += 1,
            false => stretches.held += 1,
        }
    }

    fn begin_operation(&mut self, number: u64) {
        self.survey.operations = number;
        self.selection.begin(number);
        let call = self.call.filter(|_| self.selection.holds(number));
        self.tool = call.and_then(|call| {
            let place = self.called_so_far.get_mut(&call.number)?;
            Some(self.survey.tool(call, place))
        });
        let order = &mut self.survey.order;
        if let Some(call) = self.call.filter(|call| order.last() != Some(&call.number))
            && order.len() < MOST_CHANGES
        {
            order.push(call.number);
        }
        if let Some(index) = self.tool {
            self.survey.tools[index].operations += 1;
        }
    }

    /// A motion, at feed or not, of the tip between two corners.
    fn moved(&mut self, cuts: bool, [lowest, highest]: [[f64; 3]; 2], pose: &Pose) {
        if cuts {
            self.feeds += 1;
            self.feeds_down += u64::from(pose.axis.dot(&self.tool_axis) < 0.0);
        }
        if let Some(index) = self.tool {
            let tool = &mut self.survey.tools[index];
            let (low, high) = tool.tip.unwrap_or((lowest[2], highest[2]));
            tool.tip = Some((low.min(lowest[2]), high.max(highest[2])));
            if cuts {
                let [lower, upper] = tool.cuts.get_or_insert([lowest, highest]);
                for index in 0..3 {
                    (lower[index], upper[index]) = (lower[index].min(lowest[index]), upper[index].max(highest[index]));
                }
            }
            tool.spindle_assumed |= cuts && !self.spindle;
        }
    }
}

fn too_many_tools(location: Location) -> Diagnostic {
    Diagnostic {
        severity: Severity::Error,
        location,
        length: 1,
        count: 1,
        text: format!("the CL data calls more than {MOST_TOOLS} different tools"),
        help: Some("check the tool numbers in the CAM system, or post its programs one by one".to_owned()),
    }
}

/// Which operations are asked for, and whether they are there.
#[derive(Debug, Default)]
struct WantedOperations {
    select: Option<Operations>,
    /// The coming operation bears the name that was asked for.
    named: bool,
    /// The first operation of that name.
    first: Option<u64>,
    /// Names that were seen before it.
    names: Vec<String>,
}

impl WantedOperations {
    /// TOOL PATH.
    fn name(&mut self, name: &[u8]) {
        let Some(Operations::From(wanted)) = &self.select else { return };
        let name = String::from_utf8_lossy(name).trim().to_owned();
        let found = name.eq_ignore_ascii_case(wanted.trim());
        if !found && self.names.len() < MOST_NAMES {
            self.names.push(name);
        }
        self.named |= found;
    }

    /// The operation of this number begins.
    fn begin(&mut self, number: u64) {
        if std::mem::take(&mut self.named) {
            self.first.get_or_insert(number);
        }
    }

    /// Whether the operation that has begun is posted.
    fn holds(&self, number: u64) -> bool {
        match &self.select {
            None => true,
            Some(Operations::Range(first, last)) => number >= *first && last.is_none_or(|last| number <= last),
            Some(Operations::From(_)) => self.first.is_some(),
        }
    }

    /// The operations that are posted out of so many; `None` for all.
    fn wanted(&self, operations: u64) -> Option<Result<RangeInclusive<u64>, String>> {
        Some(match self.select.as_ref()? {
            Operations::Range(first, last) => {
                let last = last.unwrap_or(operations).max(*first);
                if last > operations {
                    let count = super::counted(operations, "operation");
                    Err(format!("the CL data has {count}: there is no operation {last}"))
                } else {
                    Ok(*first..=last)
                }
            }
            Operations::From(name) => match self.first {
                Some(first) => Ok(first..=operations),
                None => Err(format!("no operation of the CL data is called `{name}`: {}", self.known_names(name))),
            },
        })
    }

    fn known_names(&self, name: &str) -> String {
        let names = || self.names.iter().map(String::as_str);
        match nearest(name, names()) {
            Some(near) => format!("did you mean `{near}`?"),
            None if self.names.is_empty() => "none has a name".to_owned(),
            None => format!("its operations are {}", list(names().take(MOST_LISTED), '`')),
        }
    }
}

impl Survey {
    /// The index of a tool, with what its calls say together.
    fn tool(&mut self, call: ToolCall, place: &mut Option<usize>) -> usize {
        let index = *place.get_or_insert_with(|| {
            self.tools.push(ToolUse { call, operations: 0, tip: None, cuts: None, spindle_assumed: false });
            self.tools.len() - 1
        });
        let known = &mut self.tools[index].call;
        known.length_mm = known.length_mm.or(call.length_mm);
        known.length_offset = known.length_offset.or(call.length_offset);
        known.diameter_mm = known.diameter_mm.or(call.diameter_mm);
        known.corner_radius_mm = known.corner_radius_mm.or(call.corner_radius_mm);
        index
    }
}
