//! The way out along the tool axis before a machine retract, and the rapids of the CL data that it may be taken for.
//!
//! A rapid may end where the way out does: at the clearance plane behind RETRCT, or the retract distance above the part. Where
//! the rotary axes turn for that very rapid, the block is the way out before it; the coolant tells, or what follows.

use std::io::{self, Read};

use super::chain::Placed;
use super::compare::{Checker, Phase};
use super::expect::{Item, Kind, Motion};
use super::follow::BOTH;
use super::path::angle_between;
use super::read::Block;
use super::report::Shown;
use super::sequence::{ON_LINE, SAME_AXIS};
use crate::motion::distance_to_clear;

impl<R: Read> Checker<'_, R> {
    /// The tool has to have left the part along its axis.
    pub(super) fn leaves(&mut self, rewinds: bool, shown: Shown<'_>) {
        if rewinds {
            self.rewound = self.here_on_path();
        }
        let enough = |here: Placed| match self.distance_out(&here) {
            Some(distance) => self.led_out + 2.0 * self.slack.tip >= distance,
            None => self.straight || self.led_out > ON_LINE,
        };
        // Along an axis that hardly leads to a plane the rounding of a place is a long way: the CL data has come there.
        let on_path = self.here_on_path().filter(|place| self.here.is_some_and(|here| self.is_at(&here, place)));
        if !self.here.into_iter().chain(on_path).any(enough) {
            self.found(shown, "the retract along the tool axis before this machine retract is missing or too short");
        }
    }

    /// Where the tool stands on the path of the CL data.
    pub(super) fn here_on_path(&self) -> Option<Placed> {
        let here = self.here?;
        let reached = self.reached.unwrap_or(here);
        match self.expect.get(0) {
            Some(Item { kind: Kind::Motion(motion), .. }) => Some(self.segment(motion, &here).at(self.along)),
            _ => Some(reached),
        }
    }

    /// How far out along its axis the tool has to go, from where it stood before it was led out.
    pub(super) fn distance_out(&self, here: &Placed) -> Option<f64> {
        let clearance = self.last.map_or(self.config.motion.retract.clearance, |(_, wanted)| wanted.clearance);
        let axis = nalgebra::UnitVector3::new_normalize(here.axis);
        let out = clearance.and_then(|clearance| distance_to_clear(&clearance, &here.tip.into(), &axis));
        self.config.motion.retract.distance_mm.or(out.map(|out| out + self.led_out))
    }

    /// Out along the tool axis, before the machine retract; `false` if the block is no such way.
    pub(super) fn leads_out(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) -> io::Result<bool> {
        let Some(here) = self.here.filter(|_| self.phase == Phase::Path) else { return Ok(false) };
        self.pass_needless()?;
        let Some((rest, out)) = self.way_out_to(&here, end) else { return Ok(false) };
        let rewinds = self.rewinds();
        if rewinds {
            self.rewound = self.here_on_path();
            self.rewound_out = Some(out);
        }
        self.state_at_leave(block, !rewinds || self.config.motion.retract.rewind_dry, shown);
        self.phase = Phase::Out;
        self.led_out += rest;
        Ok(true)
    }

    /// How far out along its axis the tool has yet to go, and where it is then, if that is where a block ends.
    fn way_out_to(&self, here: &Placed, end: &Placed) -> Option<(f64, Placed)> {
        let from = self.here_on_path().filter(|_| angle_between(&here.axis, &end.axis) <= SAME_AXIS)?;
        // Near the pole the tool stands at the pole, and leaves along it.
        [from.axis, here.axis].into_iter().find_map(|axis| {
            let from = Placed { tip: from.tip, axis };
            let distance = self.distance_out(&from)?;
            let rest =
                if self.config.motion.retract.distance_mm.is_some() { distance } else { distance - self.led_out };
            let out = Placed { tip: from.tip + axis * rest, axis };
            self.is_far_out(end, &out, rest).then_some((rest, out))
        })
    }

    /// The rapid ahead, if a block that ends there may be the way out before it as well.
    pub(super) fn rapid_or_way_out(&self, end: &Placed) -> Option<Item> {
        let here = self.here.filter(|_| self.phase == Phase::Path)?;
        let next = (0..).find(|index| !self.needless(*index)).and_then(|index| self.expect.get(index));
        let item = next.filter(|item| {
            matches!(item.kind, Kind::Motion(Motion { rapid: true, starts: false, to, .. }) if self.is_at(end, &to))
        })?;
        self.way_out_to(&here, end).map(|_| item.clone())
    }

    /// A rapid that has been taken for done, and was the way out before it: the tool comes back to it.
    pub(super) fn take_back(&mut self, block: &Block, end: Option<&Placed>) {
        let Some(left) = self.left.take() else { return };
        let Kind::Motion(rapid) = left.kind else { return };
        let next = match self.expect.get(0).map(|item| &item.kind) {
            Some(Kind::Motion(next)) => Some(*next),
            _ => None,
        };
        let Some(end) = end else {
            // What begins an operation begins with a complete state.
            let elsewhere = match next {
                Some(next) => next.starts && !self.restarted,
                None => !self.parks_rotary(block),
            };
            if elsewhere {
                self.expect.push_front(left);
                self.take_tool();
            } else {
                self.left = Some(left);
            }
            return;
        };
        let arrives = next.is_some_and(|next| self.is_at(end, &self.approach_point(&next)));
        if !arrives {
            self.expect.push_front(left);
            if !self.is_at(end, &self.approach_point(&rapid)) {
                self.expect.pop();
            }
        }
    }

    /// At a point so far out along a tool axis that is known to its rounding.
    pub(super) fn is_far_out(&self, end: &Placed, out: &Placed, distance: f64) -> bool {
        let slack = BOTH * self.slack.tip + distance.abs() * self.slack.axis;
        (end.tip - out.tip).norm() <= slack && angle_between(&end.axis, &out.axis) <= self.axis_slack(&out.axis)
    }
}
