//! Proof program: shows the kinematics at the machine. The tip stays on one point of the part while the rotary axes
//! sweep their travel, one after the other.
//!
//! Uses no CL data: rotary words run from end to end, and the linear axes follow as in every feed motion, certified
//! within `tolerance`. An error in chain, signs, pivots or lengths moves the tip.

use nalgebra::{Point3, UnitVector3};

use crate::diag::code::plan;
use crate::kinematics::{Pose, Rotary, Side};
use crate::program::{Event, Feed, Location, MachineFunction, Move, NewStart, Rotation, Spindle, ToolCall};

use crate::motion::fault::{Fault, ItemError, Planned, PlanningError};
use crate::motion::place::PathTolerance;
use crate::motion::plan::{MotionAndNext, Planner, records};
use crate::motion::rotary::{RotaryTarget, RotaryWords};
use crate::motion::source::Next;
use crate::motion::step::BlockReason;
use crate::motion::step::{Sink, Step};

/// Feed to the point, mm/min.
const FEED: f64 = 300.0;

/// Spindle speed of the dry run, never written, rev/min.
const SPEED: f64 = 1.0;

/// Largest rotation between two tool axes of [`ProofProgram::tool_axes`], rad.
const SIGHT: f64 = 0.01;

/// One sweep: from one stop to the next only one axis rotates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sweep {
    /// Name with the axis that rotates and the angle of the other one.
    pub name: String,
    stops: Vec<RotaryWords>,
}

/// Plans the proof program of a machine.
pub(crate) struct ProofProgram<'p, 'a, S> {
    planner: &'p mut Planner<'a, S>,
}

impl<'p, 'a, S: Sink> ProofProgram<'p, 'a, S> {
    /// Begins a proof program; the planner must not plan anything else.
    pub(crate) fn new(planner: &'p mut Planner<'a, S>) -> Self {
        Self { planner }
    }

    /// The sweeps of a machine: each rotary axis with the other at zero or as near to zero as its travel allows, and
    /// the first once more with the second at the end of its travel.
    ///
    /// # Errors
    /// [`PlanningError`] if an axis cannot be swept: its travel is unknown, or it is indexed.
    pub(crate) fn sweeps(&self) -> Result<Vec<Sweep>, PlanningError> {
        let rotaries = self.planner.mover.placer().rotaries();
        let mut rest = [0; 2];
        for (word, rotary) in rest.iter_mut().zip(rotaries) {
            *word = rotary.clamped(0);
        }
        let mut sweeps = Vec::new();
        for axis in 0..rotaries.len() {
            sweeps.push(self.sweep(axis, rest)?);
        }
        if let [_, second] = rotaries[..] {
            let ends = self.ends(second, rest[1])?;
            // A full turn ends where it began: half a turn is the farthest position.
            let far = match second.endless() {
                true => rest[1] + self.planner.mover.placer().scale().units_per_turn / 2,
                false => ends.into_iter().max_by_key(|end| (end - rest[1]).abs()).unwrap_or(rest[1]),
            };
            sweeps.push(self.sweep(0, [rest[0], far])?);
        }
        Ok(sweeps)
    }

    fn sweep(&self, axis: usize, rest: RotaryWords) -> Result<Sweep, PlanningError> {
        let rotaries = self.planner.mover.placer().rotaries();
        let letter = |axis: usize| self.planner.mover.placer().chain()[rotaries[axis].index].letter;
        let ends = self.ends(rotaries[axis], rest[axis])?;
        let shown =
            |axis: usize, word: i64| rotaries[axis].degrees_for_display(word, self.planner.mover.placer().scale());
        let from = if let [_] = ends[..] { rest[axis] } else { ends[0] };
        let last = ends[ends.len() - 1];
        let mut name = format!("{} from {} to {} degrees", letter(axis), shown(axis, from), shown(axis, last));
        if rotaries.len() == 2 {
            let other = 1 - axis;
            name += &format!(", {} at {}", letter(other), shown(other, rest[other]));
        }
        let at = |word: i64| {
            let mut words = rest;
            words[axis] = word;
            words
        };
        let stops = std::iter::once(rest).chain(ends.into_iter().map(at)).chain([rest]).collect();
        Ok(Sweep { name, stops })
    }

    /// The tool axes of the sweeps in the part, at most 0.01 rad from each other.
    pub(crate) fn tool_axes<'s>(&'s self, sweeps: &'s [Sweep]) -> impl Iterator<Item = UnitVector3<f64>> + 's {
        let placer = self.planner.mover.placer();
        let step = placer.scale().angle(1);
        sweeps.iter().flat_map(|sweep| sweep.stops.windows(2)).flat_map(move |pair| {
            let [from, to] = [pair[0], pair[1]];
            let largest = (0..2).map(|axis| (to[axis] - from[axis]).abs()).max().unwrap_or(0);
            let count = ((largest as f64 * step / SIGHT).ceil() as i64).max(1);
            (0..=count).map(move |index| {
                placer.axis_at(&std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * index / count))
            })
        })
    }

    /// Ends of the sweep of an axis; for an endless axis, and one of more than a full turn, one full turn from rest.
    fn ends(&self, rotary: Rotary, rest: i64) -> Result<Vec<i64>, PlanningError> {
        let placer = self.planner.mover.placer();
        let (axis, turn) = (&placer.chain()[rotary.index], placer.scale().units_per_turn);
        let letter = axis.letter;
        let refused = |fault: Fault| Err(ItemError::from(fault).at(Location::default()));
        if self.planner.policy.options.rotaries.grid.contains_key(&letter) {
            let fault = plan::INDEXING
                .fault(format_args!("{letter} is indexed and does not rotate in a cut: it cannot be swept"));
            return refused(fault.help(
                "move this axis to its positions by hand at the machine, and compare its direction with the jog sheet",
            ));
        }
        match (rotary.lower, rotary.upper) {
            // More than a full turn shows nothing new.
            (Some(lower), Some(upper)) if upper - lower > turn => {
                let end = if rest + turn <= upper { rest + turn } else { rest - turn };
                Ok(vec![end])
            }
            (Some(lower), Some(upper)) => Ok(vec![lower, upper]),
            _ if axis.side == Side::Tool => {
                let fault =
                    plan::LIMITS.fault(format_args!("the travel of {letter}, a rotary axis of the head, is unknown"));
                refused(fault.help(format_args!("give it in the configuration: `[limits] {letter} = [-90, 90]`")))
            }
            _ => Ok(vec![rest + turn]),
        }
    }

    /// Plans the proof with a tool at a point of the part, mm; the caller writes the end code.
    ///
    /// # Errors
    /// [`PlanningError`] if a point of it cannot be reached, or the output fails.
    pub(crate) fn plan(&mut self, tool: u32, tip: Point3<f64>, sweeps: &[Sweep]) -> Result<(), PlanningError> {
        let at = Location::default();
        self.planner.mover.output_mut().serve(at, BlockReason::Record);
        self.plan_all(tool, tip, sweeps).map_err(|halt| halt.at(at))?;
        self.planner.finish(at)
    }

    fn plan_all(&mut self, tool: u32, tip: Point3<f64>, sweeps: &[Sweep]) -> Planned {
        let planner = &mut *self.planner;
        records::record(
            planner,
            &Event::NewStart(NewStart::Tool(ToolCall { number: tool, ..ToolCall::default() })),
            true,
        )?;
        let on = Spindle::On { speed_rev_per_min: Some(SPEED), rotation: Some(Rotation::Clockwise) };
        records::record(planner, &Event::Function(MachineFunction::Spindle(on)), true)?;
        let Some(words) = sweeps.first().and_then(|sweep| sweep.stops.first()).copied() else {
            return Err(plan::REACH.fault("this machine has no rotary axis: there is nothing to prove").into());
        };
        let axis = planner.mover.placer().axis_at(&words);
        let motion = Move { pose: Pose { tip, axis }, rapid: false, feed: Some(Feed::PerMinute(FEED)) };
        let target = RotaryTarget { words, sense: None };
        planner.start(MotionAndNext::new(&motion, &Next::None), 1, Some(target))?;
        for sweep in sweeps {
            let name = format!("SWEEP {}", sweep.name);
            self.planner.mover.output_mut().step(&Step::Operation { name: name.as_bytes() })?;
            for words in &sweep.stops {
                self.sweep_to(words)?;
            }
        }
        self.sweep_to(&words)?;
        self.lead_out()
    }

    /// Rotates to some words with the tip in place, an axis that rolls over by a quarter turn at a time: by the shorter
    /// way it goes less than half a turn.
    fn sweep_to(&mut self, words: &RotaryWords) -> Planned {
        let placer = self.planner.mover.placer();
        let (from, quarter) =
            (placer.rotary_words_of(&self.planner.mover.here().words), placer.scale().units_per_turn / 4);
        let rolling = (0..placer.rotaries().len()).filter(|&axis| placer.rolls(placer.rotaries()[axis].index));
        let quarters = rolling.map(|axis| (words[axis] - from[axis]).abs() / quarter).max().unwrap_or(0).max(1);
        for done in 1..=quarters {
            self.rotate_to(&std::array::from_fn(|axis| from[axis] + (words[axis] - from[axis]) * done / quarters))?;
        }
        Ok(())
    }

    /// Rotates to some words with the tip in place. As in a rewind, the tool axis is not held to a path.
    fn rotate_to(&mut self, words: &RotaryWords) -> Planned {
        let mover = &mut self.planner.mover;
        let place = mover.placer().with_rotary_words(&mover.position().pose(), mover.here(), words)?;
        mover.check_travel(&place)?;
        let swinging = PathTolerance { axis_rad: f64::INFINITY, ..mover.tolerance() };
        mover.feed_in_pieces(&place, FEED, swinging)?;
        mover.position_mut().go_to(&place);
        Ok(())
    }

    /// Out along the tool axis, as far as the approach came in.
    fn lead_out(&mut self) -> Planned {
        let distance = self.planner.policy.options.approach.distance_mm;
        let mover = &mut self.planner.mover;
        let here = *mover.here();
        let Pose { tip, axis } = here.pose;
        let out = mover.shifted(tip + axis.into_inner() * distance, &here)?;
        mover.output_mut().cancel_inverse_time()?;
        mover.rapid_linear(&out)?;
        mover.position_mut().follow(&here.pose, &out.pose);
        mover.position_mut().go_to(&out);
        Ok(())
    }
}
