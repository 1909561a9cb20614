//! What leads from one cut to the next: retract, tool, approach, stop and end, as the specification has them.

use std::f64::consts::TAU;
use std::io::{self, Read};

use super::chain::Placed;
use super::compare::{Checker, Phase};
use super::expect::{Item, Kind, Motion};
use super::path::{Segment, Shape, angle_between};
use super::read::{Action, Block, Family, Guard, Length, stated};
use super::report::Shown;
use crate::motion::Mode;

/// A point this near to a line lies on it, mm.
pub(super) const ON_LINE: f64 = 1e-3;

/// The same tool axis, rad.
pub(super) const SAME_AXIS: f64 = 1e-6;

/// Seconds that three decimals of a wait do not hold.
const WAIT: f64 = 6e-4;

impl<R: Read> Checker<'_, R> {
    /// INSERT and codes of the CL data: a block as it stands, whatever it says.
    pub(super) fn raw(&mut self, block: &Block, shown: Shown<'_>) -> bool {
        let mut index = 0;
        while self.needless(index) {
            index += 1;
        }
        let Some(Item { kind: Kind::Raw(text), .. }) = self.expect.get(index) else { return false };
        let numbered = shown.text.iter().position(|byte| *byte == b' ').map_or(shown.text, |at| &shown.text[at + 1..]);
        if shown.text != text.trim_ascii_end() && !(block.number.is_some() && numbered == text.trim_ascii_end()) {
            return false;
        }
        (0..=index).for_each(|_| self.pass());
        self.forget();
        true
    }

    /// An item ahead that needs no block.
    pub(super) fn needless(&self, index: usize) -> bool {
        let Some(Item { kind: Kind::Motion(motion), .. }) = self.expect.get(index) else { return false };
        self.here.is_some_and(|here| {
            !motion.starts && self.needs_no_block(&Segment { from: here, to: motion.to, shape: motion.shape })
        })
    }

    /// Nobody knows where the machine stands.
    fn forget(&mut self) {
        self.phase = Phase::Unknown;
        (self.here, self.done, self.steps) = (None, None, None);
        self.retracted = false;
        self.reached = None;
    }

    /// Passes over motions that need no block.
    pub(super) fn pass_needless(&mut self) -> io::Result<()> {
        while self.needless(0) {
            self.pass_over();
            self.expect.fill(2)?;
        }
        Ok(())
    }

    /// An approach that has begun has to end at the approach point.
    fn broken_off(&mut self, shown: Shown<'_>) {
        if matches!(self.phase, Phase::Clear(1..)) && !self.parks {
            self.found(shown, "the approach before this block does not end at an approach point");
        }
    }

    /// A block in machine coordinates.
    pub(super) fn machine_block(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        self.pass_needless()?;
        let retract = 1 << self.words.retract;
        let position = self.config.motion.retract.position_mm();
        let there = (block.values[self.words.retract] - position).abs() <= 0.6 * self.slack.unit;
        if block.written != retract || !there {
            let parked = matches!(self.phase, Phase::Clear(_)) && self.parks_linear(block);
            if parked {
                self.parked |= block.written;
            }
            if !parked {
                self.found(
                    shown,
                    &format!("motion in machine coordinates: expected the retract, which moves its axis alone to {position} mm"),
                );
            }
            return Ok(());
        }
        if let Some(text) = self.travel.check_machine(self.words.retract, block.values[self.words.retract]) {
            self.tally.outcome.outside_limits += 1;
            self.found(shown, &text);
        }
        self.broken_off(shown);
        let rewinds = self.rewinds();
        if self.phase == Phase::Path {
            self.leaves(rewinds, shown);
        }
        // Where nobody knows where the tool is, behind a stop, the operator has the coolant in hand.
        let dry = self.phase != Phase::Unknown && (!rewinds || self.config.motion.retract.rewind_dry);
        // The stop may have been in the plane.
        let stopped = self.phase == Phase::Unknown && !self.config.motion.stop_retract;
        let tilts = matches!(self.phase, Phase::Path | Phase::Out) || stopped;
        self.state_at_retract(block, dry, tilts, shown);
        self.phase = Phase::Clear(0);
        self.retracted = true;
        (self.here, self.done, self.steps) = (None, None, None);
        self.led_out = 0.0;
        self.out_from = None;
        if matches!(self.expect.get(0), Some(Item { kind: Kind::Home, .. })) {
            self.expect.pop();
            self.parks = true;
        }
        Ok(())
    }

    /// The motion ahead is a cut that goes on where the tool stands.
    pub(super) fn rewinds(&self) -> bool {
        let Some(item) = self.expect.get(0) else { return false };
        matches!(item.kind, Kind::Motion(motion) if !motion.rapid && !motion.starts)
    }

    /// A rapid from the retract position: one of the steps to the approach point.
    pub(super) fn approach(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        self.expect.fill(8)?;
        self.take_back(block, None);
        let retract = 1 << self.words.retract;
        let (rotary, linear) = (self.words.rotary_mask, self.words.linear_mask);
        // Under tip control all linear axes come down together; in a plane its own Z comes last.
        let last = match self.config.motion.mode {
            Mode::Axes => retract,
            Mode::Tcp => linear,
            Mode::Plane => self.words.linear_places()[2].map_or(retract, |z| 1 << z),
        };
        let step = match block.written {
            written if written & !rotary == 0 => 1,
            written if written & !last == 0 => 3,
            written if written & (rotary | last) == 0 => 2,
            _ => 0,
        };
        if self.expect.get(0).is_none() || (self.parks && step == 1 && self.parks_rotary(block)) {
            self.park(block, shown);
            return Ok(());
        }
        while let Some(Item { kind: Kind::Stop { .. } | Kind::Raw(_) | Kind::Home, .. }) = self.expect.get(0) {
            self.skip(1, shown);
        }
        if let Phase::Clear(before) = self.phase
            && (step == 0 || step < before)
        {
            self.found(
                shown,
                "order of the approach: expected rotary axes first, then the other linear axes, the retract axis last",
            );
        }
        self.state_at_approach(block, step, shown);
        self.stopped = false;
        self.phase = Phase::Clear(step);
        if step == 3 || step == 0 && block.written & retract != 0 {
            let solved = self.solved(block);
            if block.known & solved != solved {
                self.found(shown, "the position of an axis is unknown at the approach point");
                self.phase = Phase::Path;
                self.lost = true;
                return Ok(());
            }
            let end = self.words.place(&block.values, &block.state);
            self.stands_in_plane(block, &end, shown);
            self.arrive(block, &end, shown);
            self.here = Some(end);
        }
        Ok(())
    }

    /// In a tilted plane the rotary axes stand where the plane has them.
    fn stands_in_plane(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) {
        let Some(tilt) = block.state.tilt else { return };
        // X of the plane is where the rotary axes have it, or the part would be turned about the tool.
        let twist = self.words.twist(&block.values, &tilt.rotation);
        if twist > 2.0 * self.slack.axis {
            let twist = twist.to_degrees();
            self.found(shown, &format!("the tilted plane is rotated by {twist:.4}° against that of the rotary axes"));
        }
        let stands = self.words.chain.place(&self.words.values(&block.values)).axis;
        let off = angle_between(&stands, &end.axis);
        if off > self.axis_slack(&end.axis) {
            let off = off.to_degrees();
            self.found(shown, &format!("the rotary axes are {off:.4}° off the tilted plane"));
        } else if let Some(Item { kind: Kind::Motion(motion), .. }) = self.expect.get(0) {
            let off = angle_between(&stands, &motion.to.axis);
            let at_pole = self.axis_slack(&motion.to.axis) > self.slack.axis;
            if off > if at_pole { self.slack.pole } else { self.slack.rotary } {
                let off = off.to_degrees();
                self.found(shown, &format!("the rotary axes are {off:.4}° off the tool axis of the CL data"));
            }
        }
    }

    /// The retract axis has come down to the approach point.
    fn arrive(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) {
        self.phase = Phase::Path;
        self.parks = false;
        self.along = if self.rewound.is_some() { self.along } else { 0.0 };
        if let Some(pose) = self.rewound.take() {
            self.come_back(pose, end, shown);
            return;
        }
        while let Some(Item { kind: Kind::Dwell(_), .. }) = self.expect.get(0) {
            self.skip(1, shown);
        }
        self.take_back(block, Some(end));
        let Some(Item { kind: Kind::Motion(motion), .. }) = self.expect.get(0) else {
            self.found(shown, "approach, but the CL data has no motion here");
            return;
        };
        if motion.starts {
            self.complete_state(block, shown);
        }
        self.come_to_hole(end);
        let Some(Item { kind: Kind::Motion(motion), .. }) = self.expect.get(0) else { return };
        let motion = *motion;
        let above = self.approach_point(&motion);
        if !self.is_at(end, &above) {
            let (off, turn) = ((end.tip - above.tip).norm(), angle_between(&end.axis, &above.axis).to_degrees());
            self.found(
                shown,
                &format!("the approach ends {off:.4} mm from the approach point, the tool axis is {turn:.4}° off"),
            );
        } else {
            let outcome = &mut self.tally.outcome;
            outcome.tip_mm = outcome.tip_mm.max((end.tip - above.tip).norm());
            outcome.axis_rad = outcome.axis_rad.max(angle_between(&end.axis, &above.axis));
        }
        self.approached = true;
        self.reached = Some(above);
        self.led_out = 0.0;
        self.lost = false;
        self.arc_plane = None;
        self.out_from = Some(motion.to);
        if above == motion.to {
            self.pass();
        }
    }

    /// An approach to a hole leads straight over it: the lift from where the tool stood and the way over are not needed.
    fn come_to_hole(&mut self, end: &Placed) {
        let ahead = |index: usize| {
            let item = self.expect.get(index)?;
            let Kind::Motion(motion) = item.kind else { return None };
            Some((item.hole?.number, motion))
        };
        let Some((number, _)) = ahead(0) else { return };
        let rapids = (0..).map_while(ahead).take_while(|(hole, motion)| *hole == number && motion.rapid);
        let found =
            rapids.enumerate().find(|(index, (_, motion))| self.is_at(end, &self.approach_point_of(*index, motion)));
        if let Some((count, _)) = found {
            (0..count).for_each(|_| self.pass());
        }
    }

    /// Above the place where the rotary axes were rewound.
    fn come_back(&mut self, pose: Placed, end: &Placed, shown: Shown<'_>) {
        // Far above, the rounding of the rotary axes counts: along the tool axis as it stands.
        let mut over = [pose.axis, end.axis].map(|axis| {
            let along = (end.tip - pose.tip).dot(&axis);
            (along, Placed { tip: pose.tip + axis * along, axis })
        });
        if let Some(out) = self.rewound_out.take() {
            over[0].1 = out;
        }
        let back = over.iter().find(|(along, above)| *along >= -self.slack.tip && self.is_far_out(end, above, *along));
        let (_, above) = *back.unwrap_or(&over[0]);
        if back.is_none() || angle_between(&pose.axis, &end.axis) > self.axis_slack(&pose.axis) {
            self.found(shown, "after the rewind the tool does not return above the point that it left");
        }
        self.back = Some(Segment { from: above, to: pose, shape: Shape::Line });
        self.led_out = 0.0;
    }

    /// Above the first point by the approach distance, or that point itself where the next lies straight below it.
    pub(super) fn approach_point(&self, first: &Motion) -> Placed {
        self.approach_point_of(0, first)
    }

    /// The same for a motion that stands so far ahead.
    fn approach_point_of(&self, index: usize, first: &Motion) -> Placed {
        let next = (index + 1..).map_while(|index| self.expect.get(index)).find_map(|item| match &item.kind {
            Kind::Motion(motion) => Some((!motion.starts).then_some(motion)),
            Kind::Dwell(_) => None,
            _ => Some(None),
        });
        let below = next.flatten().is_some_and(|next| {
            let step = next.to.tip - first.to.tip;
            let along = step.dot(&first.to.axis);
            let across = (step - first.to.axis * along).norm();
            let line = matches!(next.shape, Shape::Line);
            line && along < 0.0 && across <= ON_LINE && (next.to.axis - first.to.axis).norm() <= SAME_AXIS
        });
        if first.rapid && below {
            return first.to;
        }
        Placed { tip: first.to.tip + first.to.axis * self.config.motion.approach.distance_mm, axis: first.to.axis }
    }

    /// An operation can be entered where it begins: everything has been said, and the retract stands there, too.
    fn complete_state(&mut self, block: &Block, shown: Shown<'_>) {
        let mut needed = stated::COOLANT;
        let wanted = self.expect.get(0).map(|item| item.wanted);
        if self.config.control.safety.is_none() {
            needed |= stated::OFFSET;
        }
        if wanted.is_some_and(|wanted| wanted.spindle.is_some()) {
            needed |= stated::SPINDLE;
        }
        let missing = needed & !block.stated;
        for (bit, what) in [(stated::COOLANT, "coolant"), (stated::OFFSET, "work offset"), (stated::SPINDLE, "spindle")]
        {
            if missing & bit != 0 {
                self.found(
                    shown,
                    &format!("operation starts without its {what}, which must be programmed after its restart point"),
                );
            }
        }
        if self.config.control.safety.is_none() && !self.restarted {
            self.found(shown, "operation starts without a restart point, the block that sets all modal codes");
        }
        if !self.retracted {
            self.found(shown, "operation starts without the machine retract after its restart point");
        }
    }

    /// Rotary axes at their parking places.
    fn park(&mut self, block: &Block, shown: Shown<'_>) {
        self.state_at_park(block, shown);
        self.parks = true;
        if !self.parks_rotary(block) {
            self.found(shown, "the CL data has no motion here, and this is no parking position of the configuration");
        }
    }

    /// To their places, or nearer to them: where an axis takes the short way they go there together, in steps of less than
    /// half a turn of it.
    pub(super) fn parks_rotary(&self, block: &Block) -> bool {
        let values = self.words.values(&block.values);
        let before = self.words.values(&self.before.0);
        let there = |index: usize, place: f64| apart(values[index], place) <= 0.6 * self.slack.angle;
        let known = |index: usize| self.before.1 & (1 << index) != 0;
        let nearer =
            |index: usize, place: f64| known(index) && apart(values[index], place) < apart(before[index], place);
        let moved = || self.machine.axes().iter().enumerate().filter(|(index, _)| block.written & (1 << index) != 0);
        let place = |letter: &char| self.config.motion.park.get(letter).copied();
        let in_steps = moved().any(|(index, axis)| {
            self.config.motion.rotaries.wrap.contains_key(&axis.letter)
                && place(&axis.letter).is_some_and(|place| !there(index, place) && nearer(index, place))
        });
        let parks = |(index, axis): (usize, &crate::kinematics::Axis)| {
            place(&axis.letter).is_some_and(|place| there(index, place) || in_steps && nearer(index, place))
        };
        block.written & !self.words.rotary_mask == 0 && moved().all(parks)
    }

    fn parks_linear(&self, block: &Block) -> bool {
        let at = |(index, axis): (usize, &crate::kinematics::Axis)| {
            let place = self.config.motion.park.get(&axis.letter);
            block.written & (1 << index) == 0
                || place.is_some_and(|place| (block.values[index] - place).abs() <= 0.6 * self.slack.unit)
        };
        block.written & !self.words.linear_mask == 0 && self.machine.axes().iter().enumerate().all(at)
    }

    /// A tool change.
    pub(super) fn change(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        let tool = block.state.tool;
        if self.expect.get(0).is_none_or(|item| item.wanted.tool != tool) {
            self.find_again(|item| item.wanted.tool == tool, shown)?;
        }
        if !matches!(self.phase, Phase::Clear(_)) || !self.retracted {
            self.found(shown, "tool change before the machine has retracted");
        }
        self.broken_off(shown);
        self.forget();
        Ok(())
    }

    /// Where something has been lost and the program has not been found again: it goes on where this is asked for.
    fn find_again(&mut self, is_it: impl Fn(&Item) -> bool, shown: Shown<'_>) -> io::Result<()> {
        if self.lost
            && let Some(count) = self.expect.ahead()?.iter().position(is_it)
        {
            self.skip(count, shown);
            self.lost = false;
            // What looked like a rewind was the way out.
            (self.rewound, self.back) = (None, None);
        }
        Ok(())
    }

    /// A wait.
    pub(super) fn dwell(&mut self, seconds: f64, shown: Shown<'_>) -> io::Result<()> {
        self.pass_needless()?;
        if let Some(Item { kind: Kind::Dwell(wanted), .. }) = self.expect.get(0)
            && (wanted - seconds).abs() <= WAIT
        {
            self.expect.pop();
            return Ok(());
        }
        let spindle = self.config.motion.spindle_dwell_s;
        if spindle <= 0.0 || (spindle - seconds).abs() > WAIT {
            self.found(shown, &format!("dwell of {seconds} s, which neither CL data nor configuration asks for"));
        }
        Ok(())
    }

    /// M0 and M1.
    pub(super) fn stop(&mut self, block: &Block, optional: bool, shown: Shown<'_>) -> io::Result<()> {
        self.pass_needless()?;
        let is_it = |item: &Item| matches!(item.kind, Kind::Stop { optional: wanted } if wanted == optional);
        self.find_again(is_it, shown)?;
        match self.expect.get(0) {
            Some(item) if is_it(item) => {
                self.expect.pop();
            }
            _ => self.found(shown, "stop without STOP or OPSTOP in the CL data"),
        }
        if self.config.motion.stop_retract && !matches!(self.phase, Phase::Clear(_)) {
            self.found(shown, "program stop before the machine has retracted");
        }
        if self.config.motion.stop_retract {
            self.state_at_end(block, shown);
            self.stopped = true;
        }
        self.broken_off(shown);
        self.forget();
        Ok(())
    }

    /// The end code.
    pub(super) fn end(&mut self, block: &Block, shown: Shown<'_>) -> io::Result<()> {
        self.expect.fill(1)?;
        self.pass_needless()?;
        if self.expect.get(0).is_some() {
            self.found(shown, "end code before the end of the CL data");
        }
        if !matches!(self.phase, Phase::Clear(_)) {
            self.found(shown, "end code before the machine has retracted");
        }
        self.state_at_end(block, shown);
        self.broken_off(shown);
        self.all_parked(block, shown);
        self.ended = true;
        Ok(())
    }

    /// Every axis that has a parking place stands there.
    fn all_parked(&mut self, block: &Block, shown: Shown<'_>) {
        let values = self.words.values(&block.values);
        for (index, axis) in self.machine.axes().iter().enumerate().filter(|(_, axis)| !axis.held) {
            let Some(place) = self.config.motion.park.get(&axis.letter) else { continue };
            let rotary = self.words.rotary_mask & (1 << index) != 0;
            let turned = rotary && apart(values[index], *place) <= 0.6 * self.slack.angle;
            let retracted = index == self.words.retract
                && (place - self.config.motion.retract.position_mm()).abs() < self.slack.unit;
            if !turned && !retracted && self.parked & (1 << index) == 0 {
                self.found(shown, &format!("{} is not at its parking position", axis.letter));
            }
        }
    }

    /// What moves the tool by its length on some controls stands where nothing is in the way.
    pub(super) fn length_given_up(&mut self, block: &Block, shown: Shown<'_>) {
        let before = std::mem::replace(&mut self.length, block.state.length);
        // Tip control is given up with it before the retract: the manuals have it so.
        let moves = matches!(self.family, Family::Fanuc | Family::Haas) && self.config.motion.mode != Mode::Tcp;
        let at_part = matches!(self.phase, Phase::Path | Phase::Out);
        let changed = matches!(before, Some(Length::Register(_))) && before != block.state.length;
        if moves && at_part && changed && block.action != Action::Machine {
            self.found(
                shown,
                "length compensation is switched off before the machine has retracted: the tool may move by its length",
            );
        }
    }

    /// Words count differently without the plane: it is given up where nothing is in the way. A Heidenhain gives it up before
    /// the retract, whose machine coordinates would count in it, and PLANE RESET STAY moves nothing.
    pub(super) fn plane_given_up(&mut self, block: &Block, shown: Shown<'_>) {
        let before = std::mem::replace(&mut self.tilted, block.state.tilt.is_some());
        let at_part = matches!(self.phase, Phase::Path | Phase::Out) && self.family != Family::Heidenhain;
        if before && !self.tilted && at_part {
            self.found(shown, "the tilted plane is switched off before the machine has retracted");
        }
    }

    /// A guard of a tool length; where it does not say which, it is known that there is one.
    pub(super) fn guard(&mut self, guard: Guard, shown: Shown<'_>) {
        let length = guard.length_mm;
        let wanted = self.expect.get(0).and_then(|item| item.wanted.length);
        if let Some(wanted) = wanted
            && (wanted - length).abs() > 1e-3
        {
            self.found(
                shown,
                &format!("the length guard compares with {length} mm, but the tool length is {wanted} mm"),
            );
        }
    }
}

/// How far a rotary axis is from a place, rad; without limits it may stand whole turns away.
fn apart(value: f64, place: f64) -> f64 {
    let off = value - place;
    (off - (off / TAU).round() * TAU).abs()
}
