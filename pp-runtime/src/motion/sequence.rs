//! The safe sequence: how the tool gets from one cut to the next, one step per block.
//!
//! 1. coolant off, inverse time cancelled;
//! 2. out along the tool axis, then the retract axis to its machine position;
//! 3. tool, length offset, spindle, dwell;
//! 4. rotary axes alone, between their clamps;
//! 5. the other linear axes;
//! 6. the retract axis down to the approach point;
//! 7. coolant on;
//! 8. along the tool axis to the first point.
//!
//! "Out" and "in" are along the tool axis. Where the machine stands is never assumed at program start, behind a tool
//! change or behind a stop.

use super::options::{Mode, Transition};
use crate::diag::Severity;
use crate::kinematics::{AxisKind, Machine, Pose};
use crate::program::{Location, Move};

use super::account::Why;
use super::clearance::way_out;
use super::course::Target;
use super::fault::Fault;
use super::place::Place;
use super::planner::{Planned, Planner, SAME_AXIS, stop};
use super::step::{Sink, Step, Words};

/// A point this near to a line lies on it, mm.
const ON_LINE: f64 = 0.001;

/// A retreat that falls short by less than this is long enough, mm.
const ENOUGH: f64 = 1e-6;

impl<M: Machine> Planner<'_, M> {
    /// Steps 1 and the first half of 2, if the tool stands at the part.
    pub(super) fn leave(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        if !self.there {
            return Ok(());
        }
        sink.serve(at, Why::LeadOut);
        self.coolant_off(sink)?;
        self.cancel_inverse_time(sink)?;
        let led_out = self.retreat.length();
        let Pose { tip, axis } = self.place.pose;
        let out = self.clearance.and_then(|clearance| way_out(&clearance, &tip, &axis));
        match self.policy.options.retract.distance.or_else(|| out.map(|distance| distance + led_out)) {
            Some(distance) if led_out + ENOUGH < distance => {
                let (distance, what) = match self.policy.options.retract.distance {
                    Some(distance) => (distance, "`retract.distance` ="),
                    None => (distance - led_out, "to the clearance geometry,"),
                };
                let out = self
                    .placer
                    .shifted(tip + axis.into_inner() * distance, &self.place)
                    .map_err(|fault| stop(at, fault.context(format_args!("the retract {what} {distance} mm"))))?;
                self.rapid(&out, self.placer.linear_mask(), sink)?;
                self.place = out;
            }
            Some(_) => {}
            None if self.placer.straight() => {}
            None if led_out > ENOUGH => {
                let wanted = self.policy.options.approach.distance;
                if led_out + ENOUGH < wanted {
                    let text = format!(
                        "before this line the CL data leads the tool out by {led_out:.3} mm only, less than \
                         `approach.distance` = {wanted} mm"
                    );
                    let fault = Fault::new(text).help("give `retract.distance`, or retract further in CAM");
                    self.warnings.push(fault.at(at, Severity::Warning));
                }
            }
            None => {
                return Err(stop(
                    at,
                    Fault::new(
                        "the tool has to leave the part here, and the CL data before this line does not lead it out \
                         along its axis",
                    )
                    .help("give `retract.distance` in the configuration, or retract along the tool axis in CAM"),
                ));
            }
        }
        self.retreat.reset();
        self.there = false;
        Ok(())
    }

    /// The second half of step 2: the retract axis to its machine position.
    pub(super) fn machine_retract(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        if self.clear {
            return Ok(());
        }
        if self.restarts == 0 {
            self.restart(sink)?;
        }
        let words =
            self.placer.retract_words(self.policy.options.retract.position()).map_err(|fault| stop(at, fault))?;
        let off = match self.abilities.plane {
            _ if !self.framed => None,
            Some(plane) if self.policy.options.mode == Mode::Plane => Some((Step::PlaneOff, plane.ends_behind_retract)),
            _ => Some((Step::TipControl { on: false }, false)),
        };
        self.framed = false;
        if let Some((off, false)) = off {
            sink.step(&off)?;
        }
        sink.step(&Step::Machine { words })?;
        if let Some((off, true)) = off {
            sink.step(&off)?;
        }
        self.clear = true;
        Ok(())
    }

    /// The frame of what follows, where it depends on how the rotaries stand there; nothing has moved yet.
    pub(super) fn framed_at(
        &mut self,
        place: Place<M::Axes>,
    ) -> Result<(Place<M::Axes>, Option<Step<'static>>), Fault> {
        match (self.policy.options.mode, self.abilities.plane) {
            (Mode::Axes, _) | (Mode::Plane, None) => Ok((place, None)),
            (Mode::Tcp, _) => {
                let place = if self.placer.frame.is_set_anew() { self.placer.started(place)? } else { place };
                Ok((place, Some(Step::TipControl { on: true })))
            }
            (Mode::Plane, Some(ability)) => {
                let (place, tilt) = self.placer.tilted(place, &ability)?;
                let pose = self.placer.pose_of_plane(&place, ability.pose);
                Ok((place, Some(Step::Plane { angles: tilt.words, pose })))
            }
        }
    }

    fn restart(&mut self, sink: &mut impl Sink) -> Planned {
        self.restarts += 1;
        sink.step(&Step::Restart { number: self.restarts })?;
        self.clamps.forget();
        self.inverse_time = false;
        self.framed = false;
        Ok(())
    }

    /// The first motion of an operation, with everything before it.
    pub(super) fn start(
        &mut self,
        at: Location,
        first: &Move,
        next: Option<&Move>,
        planned: Option<Target>,
        sink: &mut impl Sink,
    ) -> Planned {
        let opens = self.begin_operation(at, sink)?;
        if self.selection.over {
            return Ok(());
        }
        let wanted = self.next_tool.take();
        let change = opens || wanted.is_some_and(|wanted| self.tool.is_none_or(|tool| tool.number != wanted.number));
        if self.there && self.policy.options.rapids.transition == Transition::Direct && !change {
            return self.start_directly(at, first, planned, sink);
        }
        self.leave(at, sink)?;
        sink.serve(at, Why::Start);
        if (self.abilities.length_moves || self.framed) && self.restarts > 0 && !opens {
            // What the safety line cancels must not move the tool down, or turn it in the part.
            self.machine_retract(at, sink)?;
        }
        // A complete state, the retract included: the program can be entered here.
        self.restart(sink)?;
        self.clear = false;
        // Whoever enters here has seen nothing of what came before.
        self.coolant = None;
        self.coolant_off(sink)?;
        self.machine_retract(at, sink)?;
        self.stop_spindle(sink)?;
        if let Some(tool) = wanted.or(self.tool) {
            self.tool = Some(tool);
            self.placer.set_gauge_length(tool.length);
            self.changes += usize::from(change);
            let given = self.policy.set_up.tools.get(&tool.number);
            let spindle = self.request.resolve(given, self.policy).map_err(|fault| stop(at, fault))?;
            sink.step(&Step::Tool {
                number: tool.number,
                offset: tool.offset,
                next: self.tool_after(tool.number),
                speed: spindle.map(|(speed, _)| speed),
                change,
            })?;
            if change {
                // The change may leave every axis anywhere, and the spindle still.
                self.clear = false;
                self.spindle = None;
                self.spindle_stop = false;
                self.machine_retract(at, sink)?;
            }
            if !self.placer.gauge_line() {
                sink.step(&Step::Length { offset: tool.offset })?;
                let guarded = self.policy.options.guards.length_guard.unwrap_or(self.placer.needs_length().is_some());
                if let Some(length) = tool.length.filter(|_| guarded) {
                    sink.step(&Step::LengthGuard {
                        label: self.restarts,
                        tool: tool.number,
                        offset: tool.offset,
                        length,
                        tolerance: self.policy.options.guards.length_tolerance,
                    })?;
                }
            }
        }
        self.turn_spindle(at, true, sink)?;
        self.tapped = false;
        self.check_state(first).map_err(|fault| stop(at, fault))?;
        self.approach(at, first, next, planned, sink)
    }

    /// What an operation that goes on where the last one ended wants before the tool moves: the course may have something
    /// to cut before its first motion.
    pub(super) fn prepare_directly(&mut self, at: Location, first: &Move, sink: &mut impl Sink) -> Planned {
        self.turn_spindle(at, false, sink)?;
        self.stop_spindle(sink)?;
        self.check_state(first).map_err(|fault| stop(at, fault))?;
        self.turn_coolant(at, sink)
    }

    /// An operation that goes on where the last one ended, because the configuration wants it so.
    fn start_directly(&mut self, at: Location, first: &Move, planned: Option<Target>, sink: &mut impl Sink) -> Planned {
        let place =
            self.placer.place(&first.pose, &self.place, !first.rapid, planned).map_err(|fault| stop(at, fault))?;
        if self.leaves_plane(&place) {
            return self.index(at, first, None, planned, sink);
        }
        let before = self.place.pose;
        if first.rapid {
            self.cancel_inverse_time(sink)?;
            self.clamps.note(&self.place.words, &place.words);
            self.rapid(&place, self.all(), sink)?;
        } else {
            self.feed_to(at, first, &place, sink)?;
            self.cut(&first.pose);
        }
        self.retreat.follow(&before, &first.pose);
        self.arrive(place);
        Ok(())
    }

    /// A rapid that turns the table or the head.
    pub(super) fn index(
        &mut self,
        at: Location,
        first: &Move,
        next: Option<&Move>,
        planned: Option<Target>,
        sink: &mut impl Sink,
    ) -> Planned {
        self.leave(at, sink)?;
        sink.serve(at, Why::Approach);
        self.machine_retract(at, sink)?;
        self.stop_spindle(sink)?;
        self.approach(at, first, next, planned, sink)
    }

    /// Steps 4 to 8.
    fn approach(
        &mut self,
        at: Location,
        first: &Move,
        next: Option<&Move>,
        planned: Option<Target>,
        sink: &mut impl Sink,
    ) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        self.clamps.approach();
        let place = self.placer.place(&first.pose, &self.place, false, planned).map_err(fault)?;
        let (place, frame) = self.framed_at(place).map_err(fault)?;
        let distance = self.policy.options.approach.distance;
        let above = if first.rapid && next.is_some_and(|next| straight_down(&first.pose, &next.pose)) {
            place
        } else {
            let Pose { tip, axis } = first.pose;
            self.placer
                .shifted(tip + axis.into_inner() * distance, &place)
                .map_err(|fault| stop(at, fault.context(format_args!("the approach from {distance} mm"))))?
        };
        sink.serve(at, Why::Approach);
        self.come_in(at, &above, frame, sink)?;
        self.count_sequence();
        self.turn_coolant(at, sink)?;
        self.place = above;
        sink.serve(at, Why::Record);
        if place.words != above.words {
            if first.rapid {
                self.rapid(&place, self.placer.linear_mask(), sink)?;
            } else {
                let pace = self.pace(first.feed, &place).map_err(fault)?;
                self.write_feed(at, &place, pace, None, sink)?;
            }
        }
        if !first.rapid {
            self.cut(&first.pose);
        }
        self.retreat.reset();
        self.arrive(place);
        Ok(())
    }

    /// Steps 4 to 6: from the machine retract to the approach point.
    pub(super) fn come_in(
        &mut self,
        at: Location,
        above: &Place<M::Axes>,
        frame: Option<Step<'static>>,
        sink: &mut impl Sink,
    ) -> Planned {
        let retract = self.policy.options.retract.position();
        if let Some(below) = self.placer.below_retract(above, retract)
            && below < -self.placer.unit_mm()
        {
            let axis = M::AXES[self.placer.retract_axis()].letter;
            return Err(stop(
                at,
                Fault::new(format_args!(
                    "the approach point lies {:.3} mm above the retract position: {axis} = {retract} mm (machine coordinate)",
                    -below
                ))
                .help("set the part lower, or give a smaller `approach.distance` or a higher `retract.position`"),
            ));
        }
        let (linear, rotary) = (self.placer.linear_mask(), self.placer.rotary_mask());
        self.unclamp(&above.words, sink)?;
        self.rapid_alone(above, rotary, sink)?;
        if let Some(frame) = frame {
            sink.step(&frame)?;
            self.framed = true;
            self.clear = false;
        }
        self.clamp(sink)?;
        let last = match self.policy.options.mode {
            Mode::Axes => 1 << self.placer.retract_axis(),
            // Along the tool axis of the plane.
            Mode::Plane => 1 << self.placer.frame.letters()[2],
            // The tip goes straight to the approach point, however the table is tilted.
            Mode::Tcp => linear,
        };
        self.rapid_alone(above, linear & !last, sink)?;
        self.rapid(above, last, sink)
    }

    /// The end of the program up to the end code: coolant off, retract, spindle off, park.
    pub(super) fn end(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        self.leave(at, sink)?;
        sink.serve(at, Why::End);
        self.coolant_off(sink)?;
        self.cancel_inverse_time(sink)?;
        self.machine_retract(at, sink)?;
        self.spindle_off(sink)?;
        self.park(at, sink)
    }

    pub(super) fn park(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let (turned, mask) = self.placer.parked(&self.policy.options.park, &self.place).map_err(fault)?;
        if mask != 0 {
            self.clamp_parked(mask, false, sink)?;
            self.rapid_alone(&turned, mask, sink)?;
            self.clamp_parked(mask, true, sink)?;
            // The next turn counts from here.
            self.place = turned;
            self.placed = true;
        }
        let mut others = Words::default();
        let mut last = None;
        let linear = M::AXES.iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Linear && !axis.held);
        for (index, coordinate) in
            linear.filter_map(|(index, axis)| Some((index, *self.policy.options.park.get(&axis.letter)?)))
        {
            let words = self.placer.machine_words(index, coordinate).map_err(fault)?;
            if index == self.placer.retract_axis() {
                last = Some(words);
            } else {
                others.mask |= words.mask;
                others.units[index] = words.units[index];
            }
        }
        if others.mask != 0 {
            sink.step(&Step::Machine { words: others })?;
        }
        if let Some(words) = last {
            sink.step(&Step::Machine { words })?;
        }
        Ok(())
    }
}

/// Whether `next` lies from `first` along -axis, with the same axis.
fn straight_down(first: &Pose, next: &Pose) -> bool {
    let step = next.tip - first.tip;
    let along = step.dot(&first.axis);
    let across = step - first.axis.into_inner() * along;
    let turn = next.axis.into_inner() - first.axis.into_inner();
    along < 0.0 && across.norm() <= ON_LINE && turn.norm() <= SAME_AXIS
}
