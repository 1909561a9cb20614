//! Rewinding: where no course of the rotary axes runs through, the tool leaves the part, turns, and comes back to the same
//! pose.

use super::options::Rewind;
use crate::diag::Severity;
use crate::kinematics::Machine;
use crate::program::{Location, Move};

use super::account::Why;
use super::clearance::way_out;
use super::course::{Target, Turns};
use super::fault::Fault;
use super::linearise::Tolerance;
use super::planner::{Planned, Planner, stop};
use super::step::Sink;

impl<M: Machine> Planner<'_, M> {
    /// Out along the tool axis, machine retract, rotaries, back the same way, and at feed to where the tool was.
    #[cold]
    pub(super) fn rewind(&mut self, at: Location, motion: &Move, words: Turns, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let here = self.place;
        let why = self.why_rewind();
        sink.serve(at, Why::Rewind);
        if self.policy.options.retract.rewind == Rewind::Follow {
            return self.rewind_in_place(at, motion, words, &why, sink);
        }
        let out = self.clearance.and_then(|clearance| way_out(&clearance, &here.pose.tip, &here.pose.axis));
        let Some(distance) = self.policy.options.retract.distance.or(out) else {
            return Err(fault(
                Fault::new(format_args!("here the rotary axes have to be rewound out of the part: {why}")).help(
                    "give `retract.distance` or `retract.clearance` in the configuration, or CLEARP in the CL data",
                ),
            ));
        };
        let turned =
            self.placer.place(&here.pose, &here, false, Some(Target { words, towards: None })).map_err(fault)?;
        let tip = here.pose.tip + here.pose.axis.into_inner() * distance;
        let context = |text: Fault| fault(text.context(format_args!("the retract of {distance} mm to rewind")));
        let out = self.placer.shifted(tip, &here).map_err(context)?;
        self.cancel_inverse_time(sink)?;
        if self.policy.options.retract.rewind_dry {
            self.coolant_off(sink)?;
        }
        self.rapid(&out, self.placer.linear_mask(), sink)?;
        self.clear = false;
        self.machine_retract(at, sink)?;
        let (turned, frame) = self.framed_at(turned).map_err(fault)?;
        let above = self.placer.shifted(tip, &turned).map_err(context)?;
        self.clamps.note(&here.words, &above.words);
        self.come_in(at, &above, frame, sink)?;
        self.turn_coolant(at, sink)?;
        self.clear = false;
        self.place = above;
        let pace = self.pace(motion.feed, &turned).map_err(fault)?;
        self.write_feed(at, &turned, pace, None, sink)?;
        self.place = turned;
        self.retreat.reset();
        self.statistics.rewinds += 1;
        sink.serve(at, Why::Record);
        let remark = Fault::new(format_args!("the rotary axes are rewound here, out of the part: {why}"));
        self.warnings.push(remark.at(at, Severity::Warning));
        Ok(())
    }

    /// The rotaries turn while the linear axes follow: the tip stays where it is, and the tool swings about it.
    fn rewind_in_place(
        &mut self,
        at: Location,
        motion: &Move,
        words: Turns,
        why: &str,
        sink: &mut impl Sink,
    ) -> Planned {
        let (here, target) = (self.place, Some(Target { words, towards: None }));
        let turned = self.placer.place(&here.pose, &here, false, target).map_err(|fault| stop(at, fault))?;
        self.clamps.note(&here.words, &turned.words);
        let swinging = Tolerance { axis: f64::INFINITY, ..self.tolerance };
        self.feed_in_pieces(at, motion, &turned, swinging, sink)?;
        self.place = turned;
        self.statistics.rewinds += 1;
        sink.serve(at, Why::Record);
        let remark = Fault::new(format_args!(
            "the rotary axes are rewound here with the tip in place, and the tool swings about it: {why}"
        ));
        self.warnings.push(remark.at(at, Severity::Warning));
        Ok(())
    }

    /// Limits of the rotary axes, in words.
    fn why_rewind(&self) -> String {
        let limited = self.placer.rotaries.iter().filter(|rotary| !rotary.endless());
        let limits: Vec<String> = limited
            .map(|rotary| format!("{} {}", M::AXES[rotary.index].letter, self.placer.limits_text(rotary.index)))
            .collect();
        let way = match (self.policy.options.course.greedy, self.placer.wide()) {
            (true, _) => "not planned ahead",
            (false, true) => "not avoided by the turns that were looked at",
            (false, false) => "unavoidable",
        };
        format!("{way} within {}", limits.join(", "))
    }
}
