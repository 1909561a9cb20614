//! Where the rotaries of each operation begin, chosen with the whole operation in view.
//!
//! Pose by pose the planner takes the least turn. At the start of an operation that can be the wrong branch or turn: one
//! that runs into a limit later, in the cut. The scout follows every possible start through the operation and keeps the
//! one that stays inside the limits; among several the one that turns least. It sees the events of the first pass and
//! remembers one start for each operation.

use crate::config::{Config, Transition, Units};
use crate::diag::Diagnostic;
use crate::kinematics::{Machine, Pose};
use crate::program::{Event, Location};

use super::expand::Expander;
use super::place::{Place, Placer};
use super::starts::Starts;
use super::step::MAX_AXES;

/// More starts than this are not followed.
const MOST_CANDIDATES: usize = 24;

/// Words of the rotary axes at the start of an operation, by position in the chain.
pub(super) type Start = Option<[i64; MAX_AXES]>;

/// One way to begin an operation, and how far it leads.
#[derive(Debug, Clone, Copy)]
struct Candidate<A> {
    start: [i64; MAX_AXES],
    place: Place<A>,
    alive: bool,
    motions: u64,
    /// Turn of the first rotary in the block that leaves the pole, in units of its word.
    leaving: u64,
}

/// Follows the operations of a program.
pub struct Scout<M: Machine> {
    placer: Placer<M>,
    /// Where the rotaries stand before the operation.
    before: Place<M::Axes>,
    placed: bool,
    /// A tool has been called.
    armed: bool,
    begun: bool,
    /// The operation began at the pole and has not left it yet.
    at_pole: bool,
    candidates: Vec<Candidate<M::Axes>>,
    starts: Starts,
    expander: Expander,
}

/// What the planner will say, the scout passes over.
struct Silent;

impl From<Diagnostic> for Silent {
    fn from(_: Diagnostic) -> Self {
        Self
    }
}

impl<M: Machine> Scout<M> {
    /// A scout, where there is something to choose: a limited rotary, and operations that begin with the safe sequence.
    #[must_use]
    pub fn new(machine: M, config: &Config) -> Option<Self> {
        let placer = Placer::new(machine, config, Units::Millimetres);
        (placer.limited() && config.transition == Transition::Safe).then(|| Self {
            before: placer.zero(),
            placer,
            placed: false,
            armed: false,
            begun: true,
            at_pole: false,
            candidates: Vec::new(),
            starts: Starts::default(),
            expander: Expander::new(config),
        })
    }

    /// Follows one event.
    pub fn event(&mut self, event: &Event<'_>) {
        if let Event::Move(motion) = event
            && self.expander.passes(motion)
        {
            return self.straight(event);
        }
        let mut expander = std::mem::take(&mut self.expander);
        // An event that cannot be expanded ends the program there.
        let _: Result<(), Silent> = expander.event(Location::default(), event, &mut |_, event| {
            self.straight(event);
            Ok(())
        });
        expander.take_warnings();
        self.expander = expander;
    }

    fn straight(&mut self, event: &Event<'_>) {
        match event {
            Event::From(pose) if !self.placed => {
                self.before = self.placer.reference(pose, &self.before).unwrap_or(self.before);
            }
            Event::Tool(_) => {
                self.armed = true;
                self.close();
            }
            Event::Operation(_)
            | Event::Stop
            | Event::OptionalStop
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Home
            | Event::Insert(_)
            | Event::Code { .. } => self.close(),
            // The planner passes over these.
            Event::Move(motion) if !self.armed && motion.rapid => {
                self.before = self.placer.reference(&motion.pose, &self.before).unwrap_or(self.before);
            }
            Event::Move(motion) if self.begun => self.open(&motion.pose),
            Event::Move(motion) => self.follow(&motion.pose, !motion.rapid),
            _ => {}
        }
    }

    /// The start of each operation, in their order.
    #[must_use]
    pub fn finish(mut self) -> Starts {
        self.close();
        self.starts.read_from_start()
    }

    fn open(&mut self, pose: &Pose) {
        self.begun = false;
        self.placed = true;
        self.candidates.clear();
        // What the planner would do by itself comes first: it wins every tie.
        if let Ok(place) = self.placer.turn(pose, &self.before, false) {
            self.add(place.words, place, 0);
        }
        self.at_pole = self.placer.singular(pose, &self.before);
        for place in self.placer.every_turn(pose, &self.before) {
            self.add(place.words, place, 0);
        }
    }

    fn add(&mut self, start: [i64; MAX_AXES], place: Place<M::Axes>, motions: u64) {
        if self.candidates.len() < MOST_CANDIDATES && self.candidates.iter().all(|known| known.start != start) {
            self.candidates.push(Candidate { start, place, alive: true, motions, leaving: 0 });
        }
    }

    fn follow(&mut self, pose: &Pose, feed: bool) {
        let leaves = self.at_pole && !self.placer.singular(pose, &self.before);
        if leaves {
            // Only now it shows which way the free rotary could have stood from the beginning.
            self.at_pole = false;
            let Some(first) = self.candidates.first().copied() else { return };
            for place in self.placer.every_turn(pose, &first.place) {
                let start = self.placer.with_first_rotary(&first.place, &place);
                self.add(start.words, Place { pose: first.place.pose, ..start }, first.motions);
            }
        }
        for candidate in self.candidates.iter_mut().filter(|candidate| candidate.alive) {
            match self.placer.turn(pose, &candidate.place, feed) {
                Ok(place) => {
                    if leaves && let Some(rotary) = self.placer.rotaries.first() {
                        candidate.leaving = candidate.place.words[rotary.index].abs_diff(place.words[rotary.index]);
                    }
                    candidate.place = place;
                    candidate.motions += 1;
                }
                Err(_) => candidate.alive = false,
            }
        }
    }

    fn close(&mut self) {
        if self.begun {
            return;
        }
        self.begun = true;
        let placer = &self.placer;
        let before = self.before.words;
        // The farthest, then the one that turns least in the block that leaves the pole (it turns before the cut instead),
        // then the one that turns least before it begins, then the first.
        let best = self.candidates.iter().enumerate().min_by_key(|(order, candidate)| {
            let turns = (candidate.leaving, placer.sum_of_turns(&before, &candidate.start));
            (!candidate.alive, u64::MAX - candidate.motions, turns, *order)
        });
        match best {
            Some((_, best)) => {
                // The words of linear axes follow from the pose.
                let linear = placer.linear_mask();
                let words = std::array::from_fn(|index| if linear & (1 << index) == 0 { best.start[index] } else { 0 });
                self.starts.push(Some(words));
                self.before = best.place;
            }
            None => self.starts.push(None),
        }
    }
}

impl<M: Machine> Placer<M> {
    /// Whether a limited rotary leaves anything to choose.
    fn limited(&self) -> bool {
        self.limited
    }

    /// Whether the tool axis leaves the first rotary free.
    fn singular(&self, pose: &Pose, from: &Place<M::Axes>) -> bool {
        self.machine.inverse_kinematics(pose, &from.axes).iter().any(|solution| solution.singular)
    }

    /// Every branch of a pose with every turn inside the limits; endless axes take the nearest turn.
    fn every_turn(&self, pose: &Pose, from: &Place<M::Axes>) -> Vec<Place<M::Axes>> {
        let mut places = Vec::new();
        for solution in self.machine.inverse_kinematics(pose, &from.axes).iter() {
            let mut all = vec![from.words];
            for rotary in &self.rotaries {
                let word = self.scale.word(solution.axes.as_ref()[rotary.index]);
                let turns = rotary.turns(word, from.words[rotary.index], self.scale.turn);
                all = all
                    .iter()
                    .flat_map(|words| {
                        turns.iter().map(|&word| {
                            let mut words = *words;
                            words[rotary.index] = word;
                            words
                        })
                    })
                    .collect();
            }
            places.extend(all.iter().map(|words| self.at(pose, from, words)));
        }
        places
    }

    /// `at` with the first rotary of `other`.
    fn with_first_rotary(&self, at: &Place<M::Axes>, other: &Place<M::Axes>) -> Place<M::Axes> {
        let mut words = at.words;
        if let Some(first) = self.rotaries.first() {
            words[first.index] = other.words[first.index];
        }
        self.at(&at.pose, at, &words)
    }

    /// How far all rotaries turn together, in units of their words.
    fn sum_of_turns(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES]) -> u64 {
        self.rotaries.iter().map(|rotary| from[rotary.index].abs_diff(to[rotary.index])).sum()
    }
}
