//! State that a program commands at each motion, recorded step by step.

use std::collections::BTreeMap;
use std::io;

use pp_runtime::config::Config;
use pp_runtime::control::Control;
use pp_runtime::inside::{
    self, AxisWords, FeedWord, Navigator, Planner, PlanningError, Provenance, Sink, Source, Stage, Step,
};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::program::{Event, Location, ToolMotion, Units};

/// Words of the axes in force, and the frame in which the control interprets them.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct ProgramState {
    /// Words by index in the chain, mm and degrees.
    pub(crate) words: [f64; 9],
    /// Angles of the tilted plane, degrees.
    pub(crate) plane: Option<[f64; 3]>,
    /// The tool axis in the frame of the control.
    pub(crate) vector: Option<[f64; 3]>,
    /// Words at the start of tip control, mm and degrees; `None` without tip control.
    pub(crate) start: Option<[f64; 9]>,
    /// The zero of the words has moved with the table.
    pub(crate) moved_zero: bool,
    /// Number of feed blocks.
    pub(crate) feeds: usize,
    /// Number of feed blocks that move a rotary axis with a feed per minute.
    pub(crate) rotary_per_minute: usize,
    /// Words at the end of each feed block since the last motion of the CL data.
    pub(crate) blocks: Vec<[f64; 9]>,
}

impl ProgramState {
    /// Whether the words count in a tilted plane, or from a zero that has moved with the table.
    fn is_in_plane(&self) -> bool {
        self.plane.is_some() || self.moved_zero
    }
}

pub(crate) struct Listener<M: Machine> {
    pub(crate) state: ProgramState,
    /// Line of the present CL record.
    pub(crate) line: u64,
    /// State of the program after each record, by line.
    pub(crate) after: BTreeMap<u64, ProgramState>,
    /// Decimals of rotary words.
    pub(crate) rotary: u32,
    pub(crate) machine: std::marker::PhantomData<M>,
}

impl<M: Machine> Listener<M> {
    fn new(config: &Config) -> Self {
        Self {
            state: ProgramState::default(),
            line: 0,
            after: BTreeMap::new(),
            rotary: config.formats.rotary,
            machine: std::marker::PhantomData,
        }
    }

    /// Begins the record of a line, if it is another one.
    fn begin_record(&mut self, line: u64) {
        if line != self.line {
            self.after.insert(self.line, self.state.clone());
            self.state.blocks.clear();
            self.line = line;
        }
    }

    /// State of the program after the record of a line.
    fn state_after(&self, line: u64) -> ProgramState {
        match self.after.range(..=line).next_back() {
            Some((&at, state)) if at == line => state.clone(),
            Some((_, state)) => ProgramState { blocks: Vec::new(), ..state.clone() },
            None => ProgramState::default(),
        }
    }

    fn take(&mut self, words: &AxisWords) -> bool {
        let mut rotated = words.vector.is_some();
        self.state.vector = words.vector.map(|vector| vector.map(|units| units as f64 * 1e-7)).or(self.state.vector);
        for (index, axis) in M::AXES.iter().enumerate().filter(|(index, _)| words.has(*index)) {
            let per_unit = if axis.kind == AxisKind::Linear { 3 } else { self.rotary };
            let value = words.units[index] as f64 / 10_f64.powi(per_unit.cast_signed());
            rotated |= axis.kind == AxisKind::Rotary && (value - self.state.words[index]).abs() > 0.0;
            self.state.words[index] = value;
        }
        rotated
    }
}

impl<M: Machine> Sink for Listener<M> {
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        self.begin_record(from.at.map_or(0, |at| at.line));
        match step {
            Step::Feed { words, feed } => {
                let rotated = self.take(words);
                self.state.blocks.push(self.state.words);
                self.state.feeds += 1;
                self.state.rotary_per_minute += usize::from(rotated && matches!(feed, FeedWord::PerMinute(_)));
                assert!(!self.state.is_in_plane() || !rotated, "no rotary axis moves in a plane");
            }
            Step::Rapid { words } => {
                let rotated = self.take(words);
                assert!(!self.state.moved_zero || !rotated, "no rotary axis moves while the zero follows the table");
            }
            Step::Machine { .. }
            | Step::Retract { .. }
            | Step::Home { .. }
            | Step::Restart { .. }
            | Step::Tool { .. } => {
                let framed = self.state.is_in_plane() || self.state.start.is_some();
                let machine = matches!(step, Step::Machine { .. } | Step::Retract { .. });
                assert!(!framed || machine && self.state.is_in_plane(), "{step:?} under tip control");
            }
            Step::TipControl { on } => {
                assert_ne!(self.state.start.is_some(), *on);
                self.state.start = on.then_some(self.state.words);
            }
            Step::Plane { angles, .. } => {
                assert_eq!(self.state.plane, None);
                self.state.plane = Some(angles.map(|angle| angle.value()));
            }
            Step::DynamicOffset { on } => {
                assert!(self.state.plane.is_none() && self.state.start.is_none() && self.state.moved_zero != *on);
                self.state.moved_zero = *on;
            }
            Step::PlaneOff => {
                assert!(self.state.plane.is_some());
                self.state.plane = None;
            }
            _ => {}
        }
        Ok(())
    }
}

/// State of the program at each motion of the CL data.
///
/// # Errors
/// The first fault.
pub(crate) fn posted<M: Machine>(
    config: &Config,
    control: &dyn Control,
    events: &[Event<'_>],
) -> Result<Vec<ProgramState>, String> {
    let machine = config.set_up.machine::<M>().expect("valid");
    let unfit = config.unfit(&M::default(), control);
    if !unfit.is_empty() {
        return Err(unfit.join("\n"));
    }
    let mut navigator = Navigator::new(Box::new(machine.clone()), inside::policy(config));
    send_events::<M, _>(config, events, &mut navigator).expect("a navigator refuses nothing");
    let abilities = inside::abilities(control, config);
    let listener = Listener::<M>::new(config);
    let mut planner =
        Planner::new(Box::new(machine), inside::policy(config), Units::Millimetres, &abilities, false, listener)
            .with_course(navigator.finish());
    let fault = |stop: PlanningError| match stop {
        PlanningError::Fault(fault) => fault.text,
        PlanningError::Output(error) => panic!("{error}"),
    };
    send_events::<M, _>(config, events, &mut planner).map_err(fault)?;
    let last = Location { line: events.len() as u64 + 1, column: 1 };
    planner.finish(last).map_err(fault)?;
    let listener = planner.sink();
    let moves = events.iter().zip(1..).filter(|(event, _)| matches!(event, Event::Motion(ToolMotion::Move(_))));
    let all = moves.map(|(_, line)| listener.state_after(line)).collect();
    let framed = listener.state.is_in_plane() || listener.state.start.is_some();
    assert!(!framed, "the program ends with the frame off");
    Ok(all)
}

/// Sends the items of events to a stage; the event at index `n` is in line `n + 1`.
pub(crate) fn send_events<M: Machine, S: Stage>(
    config: &Config,
    events: &[Event<'_>],
    stage: &mut S,
) -> Result<(), S::Stop> {
    let mut source = Source::new(&M::default(), inside::policy(config));
    for (line, event) in events.iter().enumerate() {
        source.event(Location { line: line as u64 + 1, column: 1 }, event, stage)?;
    }
    source.finish(stage)
}
