//! Spindle and coolant: what the CL data wants, what the configuration adds, and what has been written.

use crate::kinematics::Machine;
use crate::program::{Coolant, Location, Rotation, Spindle};

use super::fault::Fault;
use super::planner::{Phase, Planned, Planner, stop};
use super::step::{Sink, Step};

impl<M: Machine> Planner<'_, M> {
    pub(super) fn spindle(&mut self, at: Location, spindle: Spindle, sink: &mut impl Sink) -> Planned {
        self.request.take(spindle);
        if self.phase == Phase::Start {
            self.request_in_start.take(spindle);
            return Ok(());
        }
        self.turn_spindle(at, false, sink)
    }

    /// Brings the spindle to what is wanted; `again`: even if it is so already.
    pub(super) fn turn_spindle(&mut self, at: Location, again: bool, sink: &mut impl Sink) -> Planned {
        let given = self.tool.and_then(|tool| self.policy.set_up.tools.get(&tool.number));
        let wanted = self.request.resolve(given, self.policy).map_err(|fault| stop(at, fault))?;
        match wanted {
            Some((speed, rotation)) => {
                self.spindle_stop = false;
                let turning = (speed.value(), rotation);
                if self.policy.options.lift.is_some() {
                    return self.dry_spindle(again, turning, sink);
                }
                if again || self.spindle != Some(turning) {
                    let starts = again || self.spindle.is_none_or(|(_, before)| before != rotation);
                    self.spindle = Some(turning);
                    sink.step(&Step::Spindle { speed, rotation })?;
                    if starts && self.policy.options.spindle_dwell > 0.0 {
                        self.cancel_inverse_time(sink)?;
                        sink.step(&Step::Dwell { seconds: self.policy.options.spindle_dwell })?;
                    }
                }
            }
            // In the part the tool does not stand still: see `stop_spindle`.
            None => self.spindle_stop |= self.spindle.is_some(),
        }
        Ok(())
    }

    /// In a dry run the spindle turns on paper only; whoever enters here makes sure that it stands.
    fn dry_spindle(&mut self, again: bool, turning: (f64, Rotation), sink: &mut impl Sink) -> Planned {
        self.spindle = Some(turning);
        if again { Ok(sink.step(&Step::SpindleOff)?) } else { Ok(()) }
    }

    /// Stops the spindle, if that is what the CL data wanted behind its last motion.
    #[inline]
    pub(super) fn stop_spindle(&mut self, sink: &mut impl Sink) -> Planned {
        if self.spindle_stop { self.spindle_off(sink) } else { Ok(()) }
    }

    pub(super) fn spindle_off(&mut self, sink: &mut impl Sink) -> Planned {
        self.spindle_stop = false;
        self.spindle = None;
        Ok(sink.step(&Step::SpindleOff)?)
    }

    pub(super) fn set_coolant(&mut self, at: Location, coolant: Coolant, sink: &mut impl Sink) -> Planned {
        self.coolant_request = coolant;
        if self.phase == Phase::Start { Ok(()) } else { self.turn_coolant(at, sink) }
    }

    /// Brings the coolant to what is wanted.
    pub(super) fn turn_coolant(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        let tool = self.tool.and_then(|tool| self.policy.set_up.tools.get(&tool.number));
        let kind = match self.coolant_request {
            Coolant::On => tool.and_then(|tool| tool.coolant).unwrap_or(self.policy.options.defaults.coolant),
            kind => kind,
        };
        let missing = match kind {
            Coolant::On | Coolant::Flood => (!self.abilities.flood).then_some("flood"),
            Coolant::Mist => (!self.abilities.mist).then_some("mist"),
            Coolant::Through => (!self.abilities.through).then_some("coolant through the spindle"),
            Coolant::Air => (!self.abilities.air).then_some("air"),
            Coolant::Off => None,
        };
        if let Some(missing) = missing {
            return Err(stop(
                at,
                Fault::new(format_args!("this control has no code for {missing}"))
                    .help("give it its codes, on and off: `[control] coolant = { air = [\"M83\", \"M84\"] }`"),
            ));
        }
        if kind == Coolant::Off || self.policy.options.lift.is_some() {
            return self.coolant_off(sink);
        }
        if self.coolant != Some(kind) {
            if self.coolant.is_some_and(|before| before != Coolant::Off) {
                sink.step(&Step::CoolantOff)?;
            }
            self.coolant = Some(kind);
            sink.step(&Step::Coolant { kind })?;
        }
        Ok(())
    }

    pub(super) fn coolant_off(&mut self, sink: &mut impl Sink) -> Planned {
        if self.coolant != Some(Coolant::Off) {
            self.coolant = Some(Coolant::Off);
            sink.step(&Step::CoolantOff)?;
        }
        Ok(())
    }
}
