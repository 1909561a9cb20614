//! What a program commands at each motion, listened to step by step.

use std::collections::BTreeMap;
use std::io;

use pp_runtime::config::{Config, Units};
use pp_runtime::control::{self, Control};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::motion::{FeedWord, Navigator, Planner, PlanningError, Provenance, Sink, Source, Stage, Step};
use pp_runtime::program::{Event, Location};

/// What the program says so far: the words of the axes, and what the control counts them in.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Says {
    /// By position in the chain, mm and degrees.
    pub(crate) words: [f64; 9],
    /// Angles of the tilted plane, degrees.
    pub(crate) plane: Option<[f64; 3]>,
    /// The tool axis in the frame of the control.
    pub(crate) vector: Option<[f64; 3]>,
    /// Rotary words where tip control began, degrees.
    pub(crate) began: Option<[f64; 9]>,
    /// Blocks of feed, and how many of them move a rotary axis with a feed that is no inverse time.
    pub(crate) feeds: usize,
    pub(crate) turned_per_minute: usize,
    /// Words at the end of each feed block since the motion before.
    pub(crate) blocks: Vec<[f64; 9]>,
}

pub(crate) struct Listener<M: Machine> {
    pub(crate) says: Says,
    /// The record that is served, and what the program said before it and after each.
    pub(crate) line: u64,
    pub(crate) after: BTreeMap<u64, Says>,
    pub(crate) rotary: u32,
    pub(crate) machine: std::marker::PhantomData<M>,
}

impl<M: Machine> Listener<M> {
    fn new(config: &Config) -> Self {
        Self {
            says: Says::default(),
            line: 0,
            after: BTreeMap::new(),
            rotary: config.formats.rotary,
            machine: std::marker::PhantomData,
        }
    }

    /// Another record is served from here on.
    fn serve(&mut self, line: u64) {
        if line != self.line {
            self.after.insert(self.line, self.says.clone());
            self.says.blocks.clear();
            self.line = line;
        }
    }

    /// What the program said after the record of a line.
    fn said(&self, line: u64) -> Says {
        match self.after.range(..=line).next_back() {
            Some((&at, says)) if at == line => says.clone(),
            Some((_, says)) => Says { blocks: Vec::new(), ..says.clone() },
            None => Says::default(),
        }
    }

    fn take(&mut self, words: &pp_runtime::motion::AxisWords) -> bool {
        let mut turned = words.vector.is_some();
        self.says.vector = words.vector.map(|vector| vector.map(|units| units as f64 * 1e-7)).or(self.says.vector);
        for (index, axis) in M::AXES.iter().enumerate().filter(|(index, _)| words.has(*index)) {
            let per_unit = if axis.kind == AxisKind::Linear { 3 } else { self.rotary };
            let value = words.units[index] as f64 / 10_f64.powi(per_unit.cast_signed());
            turned |= axis.kind == AxisKind::Rotary && (value - self.says.words[index]).abs() > 0.0;
            self.says.words[index] = value;
        }
        turned
    }
}

impl<M: Machine> Sink for Listener<M> {
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        self.serve(from.at.map_or(0, |at| at.line));
        match step {
            Step::Feed { words, feed } => {
                let turned = self.take(words);
                self.says.blocks.push(self.says.words);
                self.says.feeds += 1;
                self.says.turned_per_minute += usize::from(turned && matches!(feed, FeedWord::PerMinute(_)));
                assert!(self.says.plane.is_none() || !turned, "no rotary turns in a tilted plane");
            }
            Step::Rapid { words } => {
                self.take(words);
            }
            Step::Machine { .. } | Step::Restart { .. } | Step::Tool { .. } => {
                let framed = self.says.plane.is_some() || self.says.began.is_some();
                let machine = matches!(step, Step::Machine { .. });
                assert!(!framed || machine && self.says.plane.is_some(), "{step:?} under tip control");
            }
            Step::TipControl { on } => {
                assert_ne!(self.says.began.is_some(), *on);
                self.says.began = on.then_some(self.says.words);
            }
            Step::Plane { angles, .. } => {
                assert_eq!(self.says.plane, None);
                self.says.plane = Some(angles.map(|angle| angle.value()));
            }
            Step::PlaneOff => {
                assert!(self.says.plane.is_some());
                self.says.plane = None;
            }
            _ => {}
        }
        Ok(())
    }
}

/// What the program says at each motion, and the first fault.
pub(crate) fn posted<M: Machine>(
    config: &Config,
    control: &dyn Control,
    events: &[Event<'_>],
) -> Result<Vec<Says>, String> {
    let machine = config.set_up.machine::<M>().expect("valid");
    let unfit = control::unfit(&M::default(), control, config.demands());
    if !unfit.is_empty() {
        return Err(unfit.join("\n"));
    }
    let mut navigator = Navigator::new(Box::new(machine.clone()), config.policy());
    hand_on::<M, _>(config, events, &mut navigator).expect("a navigator refuses nothing");
    let abilities = control::abilities(control, config.demands());
    let listener = Listener::<M>::new(config);
    let mut planner = Planner::new(Box::new(machine), config.policy(), Units::Millimetres, &abilities, false, listener)
        .with_course(navigator.finish());
    let fault = |stop: PlanningError| match stop {
        PlanningError::Fault(fault) => fault.text,
        PlanningError::Output(error) => panic!("{error}"),
    };
    hand_on::<M, _>(config, events, &mut planner).map_err(fault)?;
    let last = Location { line: events.len() as u64 + 1, column: 1 };
    planner.finish(last).map_err(fault)?;
    let listener = planner.sink();
    let moves = events.iter().zip(1..).filter(|(event, _)| matches!(event, Event::Move(_)));
    let all = moves.map(|(_, line)| listener.said(line)).collect();
    let framed = listener.says.plane.is_some() || listener.says.began.is_some();
    assert!(!framed, "the program ends with the frame off");
    Ok(all)
}

/// Hands on the items of events; the event at position `n` is in line `n + 1`.
pub(crate) fn hand_on<M: Machine, S: Stage>(
    config: &Config,
    events: &[Event<'_>],
    stage: &mut S,
) -> Result<(), S::Stop> {
    let mut source = Source::new(&M::default(), config.policy());
    for (line, event) in events.iter().enumerate() {
        source.event(Location { line: line as u64 + 1, column: 1 }, event, stage)?;
    }
    source.finish(stage)
}
