//! The proof of the kinematics at the machine: the tip stays on one point of the part while the rotary axes sweep their
//! travel, one after the other.
//!
//! Nothing of CL data is in it: rotary words run from end to end, and the linear axes follow as they do in every feed
//! motion, certified within `tolerance`. What a chain, a sign, a pivot or a length is off moves the tip.

use nalgebra::{Point3, UnitVector3};

use crate::kinematics::{Machine, Pose, Side};
use crate::program::{Event, Feed, Location, Move, Rotation, Spindle, ToolCall};

use super::choose::Rotary;
use super::course::{Target, Turns};
use super::fault::Fault;
use super::linearise::Tolerance;
use super::planner::{Planned, Planner, Stop, stop};
use super::step::{Sink, Step};

/// mm/min on the way to the point.
const FEED: f64 = 300.0;

/// The spindle of a dry run turns on paper only, rev/min.
const SPEED: f64 = 1.0;

/// One sweep: from one stop to the next only the named axis turns.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// What turns, and where the other axis stands.
    pub name: String,
    stops: Vec<Turns>,
}

impl<M: Machine> Planner<'_, M> {
    /// The sweeps of a machine: each rotary axis with the other at zero or as near to it as its travel allows, and the
    /// first once more with the second at the end of its travel.
    ///
    /// # Errors
    /// [`Stop`] if an axis cannot be swept: its travel is not known, or it stands on steps.
    pub fn sweeps(&self) -> Result<Vec<Sweep>, Stop> {
        let rotaries = &self.placer.rotaries;
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
            // A turn ends where it began: half of it is as far as it goes.
            let far = match second.endless() {
                true => rest[1] + self.placer.scale.turn / 2,
                false => ends.into_iter().max_by_key(|end| (end - rest[1]).abs()).unwrap_or(rest[1]),
            };
            sweeps.push(self.sweep(0, [rest[0], far])?);
        }
        Ok(sweeps)
    }

    fn sweep(&self, axis: usize, rest: Turns) -> Result<Sweep, Stop> {
        let rotaries = &self.placer.rotaries;
        let letter = |axis: usize| M::AXES[rotaries[axis].index].letter;
        let ends = self.ends(rotaries[axis], rest[axis])?;
        let shown = |axis: usize, word: i64| rotaries[axis].shown(word, self.placer.scale);
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

    /// The ends of an axis, one after the other; of an endless one a turn on.
    fn ends(&self, rotary: Rotary, rest: i64) -> Result<Vec<i64>, Stop> {
        let axis = &M::AXES[rotary.index];
        let letter = axis.letter;
        let refused = |fault: Fault| Err(stop(Location::default(), fault));
        if self.policy.options.rotaries.grid.contains_key(&letter) {
            let fault =
                Fault::new(format_args!("{letter} stands on steps and does not turn in a cut: it cannot be swept"));
            return refused(fault.help("check such an axis by hand, step by step"));
        }
        match (rotary.lower, rotary.upper) {
            (Some(lower), Some(upper)) => Ok(vec![lower, upper]),
            _ if axis.side == Side::Tool => {
                let fault = Fault::new(format_args!("the travel of {letter}, which turns the head, is not known"));
                refused(fault.help(format_args!("give it in the configuration: `[limits] {letter} = [-90, 90]`")))
            }
            _ => Ok(vec![rest + self.placer.scale.turn]),
        }
    }

    /// Plans the proof with a tool at a point of the part, mm; the end code is left to the caller.
    ///
    /// # Errors
    /// [`Stop`] if a point of it cannot be reached, or the output fails.
    pub fn prove(&mut self, tool: u32, tip: Point3<f64>, sweeps: &[Sweep], sink: &mut impl Sink) -> Planned {
        let at = Location::default();
        let fault = |fault: Fault| stop(at, fault);
        self.event(at, &Event::Tool(ToolCall { number: tool, ..ToolCall::default() }), sink)?;
        let on = Spindle::On { speed: Some(SPEED), rotation: Some(Rotation::Clockwise) };
        self.event(at, &Event::Spindle(on), sink)?;
        let Some(words) = sweeps.first().and_then(|sweep| sweep.stops.first()).copied() else {
            return Err(fault(Fault::new("this machine has no rotary axis: there is nothing to prove")));
        };
        let axis = self.axis_at(&words);
        let motion = Move { pose: Pose { tip, axis }, rapid: false, feed: Some(Feed::PerMinute(FEED)) };
        self.start(at, &motion, None, Some(Target { words, towards: None }), sink)?;
        for sweep in sweeps {
            sink.step(&Step::Operation { name: format!("SWEEP {}", sweep.name).as_bytes() })?;
            for words in &sweep.stops {
                self.sweep_to(at, &motion, words, sink)?;
            }
        }
        self.sweep_to(at, &motion, &words, sink)?;
        self.lead_out(at, sink)?;
        self.finish(at, sink)
    }

    /// The tool axis in the part with these words.
    fn axis_at(&self, words: &Turns) -> UnitVector3<f64> {
        self.placer.machine.forward_kinematics(&self.placer.standing(words).axes).axis
    }

    /// Turns to some words with the tip in place. As in a rewind the tool swings about it: its axis is not held to a path.
    fn sweep_to(&mut self, at: Location, motion: &Move, words: &Turns, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let words = self.placer.all_words(words);
        let turned = self.placer.at(&self.place.pose, &self.place, &words);
        let place = self.placer.set(turned).map_err(fault)?;
        let swinging = Tolerance { axis: f64::INFINITY, ..self.tolerance };
        self.feed_in_pieces(at, motion, &place, swinging, sink)?;
        self.place = place;
        Ok(())
    }

    /// Out along the tool axis, as far as the approach came in.
    fn lead_out(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        let Pose { tip, axis } = self.place.pose;
        let tip = tip + axis.into_inner() * self.policy.options.approach.distance;
        let out = self.placer.shifted(tip, &self.place).map_err(|fault| stop(at, fault))?;
        self.cancel_inverse_time(sink)?;
        self.rapid(&out, self.placer.linear_mask(), sink)?;
        self.retreat.follow(&self.place.pose, &out.pose);
        self.place = out;
        Ok(())
    }
}
