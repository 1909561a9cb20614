//! The first pass over the CL text: what the header needs, and what can be known only at the end.

use std::collections::BTreeMap;
use std::io::{self, Read};
use std::ops::RangeInclusive;

use nalgebra::UnitVector3;

use crate::cl::{ArcVote, Dialect, Options, Reader};
use crate::config::{Config, list, nearest};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AxisKind, Machine, Side};
use crate::motion::Operations;
use crate::motion::{Course, Expander, Navigator, extent, hole_extent};
use crate::program::{Event, Location, Spindle, ToolCall, Units};

use super::setting::Setting;

/// More tools than this are not one program; it bounds the memory and the header.
const MOST_TOOLS: usize = 1000;

/// Names of operations that are remembered, and that a message lists.
const MOST_NAMES: usize = 1000;
const MOST_LISTED: usize = 10;

/// So many tool changes are known beforehand; it bounds the memory.
const MOST_CHANGES: usize = 10_000;

/// One tool of the program.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ToolUse {
    pub(super) call: ToolCall,
    /// Operations that cut or move with it.
    pub(super) operations: u64,
    /// Lowest and highest tip of the part as it lies, mm.
    pub(super) tip: Option<(f64, f64)>,
    /// Lowest and highest corner of the box around the tips of its cuts, mm.
    pub(super) cuts: Option<[[f64; 3]; 2]>,
    /// It cuts before any SPINDL/.. behind its call: speed and direction come from the configuration.
    pub(super) spindle_assumed: bool,
}

/// What the whole file says.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Survey {
    pub(super) name: Vec<u8>,
    pub(super) units: Option<Units>,
    pub(super) units_only_given: bool,
    /// A frame is stated in the file.
    pub(super) framed: bool,
    pub(super) dialect: Dialect,
    pub(super) arcs: ArcVote,
    /// Different frames.
    pub(super) frames: usize,
    /// Operations of the whole program.
    pub(super) operations: u64,
    /// How often CSYS changes.
    pub(super) setup_changes: u64,
    /// The CAM system asks for inverse-time feed.
    pub(super) inverse_time: bool,
    pub(super) lines: u64,
    /// Tools that move, by number.
    pub(super) tools: Vec<ToolUse>,
    /// Tools in the order in which they come into the spindle.
    pub(super) order: Vec<u32>,
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Nothing may be posted from here on.
    pub(super) first_error: Option<Location>,
    /// The course of the rotary axes.
    pub(super) course: Course,
    select: Option<Operations>,
    /// The first operation of the name that was asked for.
    named: Option<u64>,
    /// Names that were seen before it.
    names: Vec<String>,
    feeds: u64,
    feeds_down: u64,
}

/// What is modal while surveying.
#[derive(Debug, Default)]
struct State {
    /// Tools called so far, and where those that have moved stand in the list.
    called_so_far: BTreeMap<u32, Option<usize>>,
    /// The first call of too many.
    too_many: Option<Location>,
    call: Option<ToolCall>,
    /// Index of the current tool, once it has moved.
    tool: Option<usize>,
    spindle: bool,
    /// An operation has begun and nothing has moved yet.
    begun: bool,
    /// A tool has been called and nothing has moved yet.
    called: bool,
    /// The coming operation bears the name that was asked for.
    named: bool,
    /// Rotary axes in the head: the machine moves without a tool, too.
    head: bool,
}

fn has_head<M: Machine>() -> bool {
    M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held && axis.side == Side::Tool)
}

/// What cannot be expanded, which the planner tells.
struct Silent;

impl From<Diagnostic> for Silent {
    fn from(_: Diagnostic) -> Self {
        Self
    }
}

impl Survey {
    pub(super) fn take<M: Machine>(
        input: impl Read,
        options: Options,
        config: &Config,
        mut navigator: Option<Navigator<M>>,
    ) -> io::Result<Self> {
        let mut reader = Reader::new(input, options);
        let mut survey = Self { select: config.motion.operations.clone(), ..Self::default() };
        let (mut setting, mut expander) = (Setting::new(config), Expander::new(config.policy()));
        let tool_axis = &M::default().tool_axis();
        let mut state = State { begun: true, head: has_head::<M>(), ..State::default() };
        loop {
            // Looked at where it lies: to move an event costs as much as to look at it.
            let found = reader.next_event();
            let (at, event) = match &found {
                Ok(Some((at, event))) => (*at, event),
                Ok(None) => break,
                Err(_) => {
                    found?;
                    break;
                }
            };
            let turned = setting.event(event);
            let event = turned.as_ref().unwrap_or(event);
            let mut straight = |at: Location, event: &Event<'_>| -> Result<(), Silent> {
                survey.event(at, event, &mut state, tool_axis);
                Ok(())
            };
            // What cannot be expanded is the planner's to tell.
            let _ = expander.event(at, event, &mut straight);
            if let Event::Tolerance(_) = event {
                expander.take_warnings();
            }
            if let Some(navigator) = &mut navigator {
                navigator.event(event);
            }
        }
        survey.course = navigator.map_or_else(Course::default, Navigator::finish);
        survey.units = reader.units();
        survey.units_only_given = reader.units_are_only_given();
        survey.framed = reader.frame().is_some();
        survey.dialect = reader.dialect();
        survey.arcs = reader.arcs();
        survey.frames = reader.different_frames();
        survey.setup_changes = reader.setup_changes();
        survey.inverse_time = reader.asks_for_inverse_time();
        survey.lines = reader.lines();
        survey.diagnostics = reader.diagnostics().to_vec();
        survey.diagnostics.extend(state.too_many.map(|location| Diagnostic {
            severity: Severity::Error,
            location,
            length: 1,
            count: 1,
            text: format!("the CL data calls more than {MOST_TOOLS} different tools"),
            help: Some("check the tool numbers in the CAM system, or post its programs one by one".to_owned()),
        }));
        let errors = survey.diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
        survey.first_error = errors.map(|error| error.location).min();
        survey.tools.sort_by_key(|tool| tool.call.number);
        Ok(survey)
    }

    fn event(&mut self, at: Location, event: &Event<'_>, state: &mut State, tool_axis: &UnitVector3<f64>) {
        match *event {
            Event::Name(name) if self.name.is_empty() => self.name = name.to_vec(),
            Event::Operation(name) => {
                state.begun = true;
                state.named |= self.is_named(name);
            }
            _ if event.interrupts() => state.begun = true,
            Event::Tool(call) => {
                if state.called_so_far.len() < MOST_TOOLS {
                    state.called_so_far.entry(call.number).or_default();
                } else if !state.called_so_far.contains_key(&call.number) {
                    state.too_many.get_or_insert(at);
                }
                if state.call.is_none_or(|before| before.number != call.number) {
                    // A SPINDL in the same start counts for the first tool that is called there.
                    state.spindle &= state.begun && !state.called;
                }
                state.called = true;
                state.call = Some(call);
                state.tool = None;
                state.begun = true;
            }
            Event::Spindle(Spindle::On { .. }) => state.spindle = true,
            // The planner passes over these.
            Event::Move(motion) if state.begun && state.call.is_none() && motion.rapid && !state.head => {}
            Event::Move(motion) => {
                let at: [f64; 3] = motion.pose.tip.into();
                self.moved(state, !motion.rapid, [at; 2], motion.pose.axis.dot(tool_axis) < 0.0);
            }
            Event::Hole(hole) => {
                let down = hole.top.axis.dot(tool_axis) < 0.0;
                let [over, inside] = hole_extent(&hole);
                self.moved(state, false, over, down);
                self.moved(state, true, inside, down);
            }
            Event::Arc(arc) => self.moved(state, true, extent(&arc), arc.end.axis.dot(tool_axis) < 0.0),
            _ => {}
        }
    }

    /// A motion, at feed or not, of the tip between two corners; `down`: the tool points away from the table's top.
    fn moved(&mut self, state: &mut State, cuts: bool, [lowest, highest]: [[f64; 3]; 2], down: bool) {
        state.called = false;
        if state.begun {
            state.begun = false;
            self.operations += 1;
            if std::mem::take(&mut state.named) {
                self.named.get_or_insert(self.operations);
            }
            let call = state.call.filter(|_| self.selected());
            state.tool = call.and_then(|call| {
                let place = state.called_so_far.get_mut(&call.number)?;
                Some(self.tool(call, place))
            });
            if let Some(call) = state.call.filter(|call| self.order.last() != Some(&call.number))
                && self.order.len() < MOST_CHANGES
            {
                self.order.push(call.number);
            }
            if let Some(index) = state.tool {
                self.tools[index].operations += 1;
            }
        }
        if cuts {
            self.feeds += 1;
            self.feeds_down += u64::from(down);
        }
        if let Some(index) = state.tool {
            let tool = &mut self.tools[index];
            let (low, high) = tool.tip.unwrap_or((lowest[2], highest[2]));
            tool.tip = Some((low.min(lowest[2]), high.max(highest[2])));
            if cuts {
                let [lower, upper] = tool.cuts.get_or_insert([lowest, highest]);
                for index in 0..3 {
                    (lower[index], upper[index]) = (lower[index].min(lowest[index]), upper[index].max(highest[index]));
                }
            }
            tool.spindle_assumed |= cuts && !state.spindle;
        }
    }

    /// Whether an operation bears the name that was asked for.
    fn is_named(&mut self, name: &[u8]) -> bool {
        let Some(Operations::From(wanted)) = &self.select else { return false };
        let name = String::from_utf8_lossy(name).trim().to_owned();
        let found = name.eq_ignore_ascii_case(wanted.trim());
        if !found && self.names.len() < MOST_NAMES {
            self.names.push(name);
        }
        found
    }

    /// Whether the operation that has begun is posted.
    fn selected(&self) -> bool {
        match &self.select {
            None => true,
            Some(Operations::Range(first, last)) => {
                self.operations >= *first && last.is_none_or(|last| self.operations <= last)
            }
            Some(Operations::From(_)) => self.named.is_some(),
        }
    }

    /// The operations that are posted; `None` for all.
    ///
    /// # Errors
    /// A sentence if there are none, or not as many.
    pub(super) fn wanted(&self) -> Result<Option<RangeInclusive<u64>>, String> {
        match &self.select {
            None => Ok(None),
            Some(Operations::Range(first, last)) => {
                let last = last.unwrap_or(self.operations).max(*first);
                if last > self.operations {
                    let count = super::counted(self.operations, "operation");
                    return Err(format!("the CL data has {count}: there is no operation {last}"));
                }
                Ok(Some(*first..=last))
            }
            Some(Operations::From(name)) => match self.named {
                Some(first) => Ok(Some(first..=self.operations)),
                None => Err(format!("no operation of the CL data is called `{name}`: {}", self.known_names(name))),
            },
        }
    }

    fn known_names(&self, name: &str) -> String {
        let names = || self.names.iter().map(String::as_str);
        match nearest(name, names()) {
            Some(near) => format!("did you mean `{near}`?"),
            None if self.names.is_empty() => "none has a name".to_owned(),
            None => format!("its operations are {}", list(names().take(MOST_LISTED), '`')),
        }
    }

    /// The index of a tool, with what its calls say together.
    fn tool(&mut self, call: ToolCall, place: &mut Option<usize>) -> usize {
        let index = *place.get_or_insert_with(|| {
            self.tools.push(ToolUse { call, operations: 0, tip: None, cuts: None, spindle_assumed: false });
            self.tools.len() - 1
        });
        let known = &mut self.tools[index].call;
        known.length = known.length.or(call.length);
        known.offset = known.offset.or(call.offset);
        known.diameter = known.diameter.or(call.diameter);
        known.corner_radius = known.corner_radius.or(call.corner_radius);
        index
    }

    /// Every tool axis of a feed motion points down: the frame of the part is probably upside down.
    pub(super) fn upside_down(&self) -> bool {
        self.feeds > 0 && self.feeds == self.feeds_down
    }
}
