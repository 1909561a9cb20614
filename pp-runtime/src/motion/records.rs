//! Records that are no motions: what each changes, and what it asks of the machine.

use std::ops::RangeInclusive;

use super::options::Transition;
use crate::diag::Severity;
use crate::kinematics::{Machine, Pose};
use crate::program::{Clearance, Dwell, Event, Location, ToolCall, Turning};

use super::account::Why;
use super::fault::Fault;
use super::planner::{Phase, Planned, Planner, Stop, stop};
use super::step::{Sink, Step};
use super::tool::{SpindleRequest, Tool};

/// A wait that three decimals hold, and that somebody may want, seconds.
const DWELL: RangeInclusive<f64> = 0.001..=99_999.0;

impl<M: Machine> Planner<'_, M> {
    /// An event that is no motion.
    #[cold]
    pub(super) fn other(&mut self, at: Location, event: &Event<'_>, sink: &mut impl Sink) -> Planned {
        sink.serve(at, Why::Record);
        if matches!(self.phase, Phase::First { .. }) && self.waiting.keep(at, event)? {
            return Ok(());
        }
        match *event {
            Event::Spindle(spindle) => self.spindle(at, spindle, sink)?,
            Event::Coolant(coolant) => self.set_coolant(at, coolant, sink)?,
            Event::From(pose) => self.from(&pose),
            Event::Message(text) if self.phase == Phase::Start => self.announce(&Step::Message { text }, sink)?,
            Event::Message(text) => sink.step(&Step::Message { text })?,
            Event::Name(_) | Event::Preselect(_) => {}
            Event::Operation(name) => {
                self.begin(at, self.policy.options.rapids.transition == Transition::Safe, sink)?;
                self.times.operation(at, name);
                self.announce(&Step::Operation { name }, sink)?;
            }
            Event::Tool(call) => {
                let tool = self.resolve(at, &call)?;
                let known = self.next_tool.or(self.tool);
                self.begin(at, true, sink)?;
                if known.is_none_or(|known| known.number != tool.number) {
                    // The speed of one tool is not the speed of another; in front of the first tool record of a start
                    // it is meant for that tool.
                    let meant = self.next_tool.is_none();
                    self.request = if meant { self.request_in_start } else { SpindleRequest::default() };
                }
                self.next_tool = Some(tool);
            }
            Event::Stop => self.stop(at, false, sink)?,
            Event::OptionalStop => self.stop(at, true, sink)?,
            Event::Delay(dwell) => self.delay(at, dwell, sink)?,
            Event::MachineName(name) => self.compare_machine(at, name),
            Event::SafeSequence => self.begin(at, true, sink)?,
            Event::Frame(number) => self.change_frame(at, number, sink)?,
            Event::Home => self.go_home(at, sink)?,
            Event::ClearancePlane(plane) => self.clearance = Some(Clearance::Plane(plane)),
            Event::Compensation(asked) => self.set_cutter(at, &asked)?,
            Event::Turning(turning) => {
                self.towards = self.placer.towards(turning);
                if self.towards.is_none() && turning != Turning::Shortest {
                    let fault = Fault::new("ROTABL/NEXT turns the table, and no rotary axis stands in the table here");
                    return Err(stop(at, fault.help("leave it out")));
                }
            }
            Event::Insert(text) => self.raw(at, text, sink)?,
            Event::Code { letter, number } => {
                let text = format!("{}{number}", char::from(letter));
                self.raw(at, text.as_bytes(), sink)?;
            }
            // Arcs and holes are motions of their own, and the expander takes curves apart.
            Event::Move(_) | Event::Arc(_) | Event::Spline(_) | Event::Hole(_) | Event::Tolerance(_) => {}
        }
        Ok(())
    }

    /// MACHIN.
    fn compare_machine(&mut self, at: Location, name: &[u8]) {
        if !name.eq_ignore_ascii_case(M::NAME.as_bytes()) {
            let name = String::from_utf8_lossy(name);
            let fault = Fault::new(format_args!("the CL data was made for the machine `{name}`, this is {}", M::NAME))
                .help("nothing in the program depends on that name");
            self.warnings.push(fault.at(at, Severity::Warning));
        }
    }

    /// DELAY, and the wait at the bottom of a hole.
    pub(super) fn delay(&mut self, at: Location, dwell: Dwell, sink: &mut impl Sink) -> Planned {
        let seconds = self.seconds(dwell).map_err(|fault| stop(at, fault))?;
        if seconds <= 0.0 {
            return Ok(());
        }
        if !DWELL.contains(&seconds) {
            let (low, high) = (DWELL.start(), DWELL.end());
            let fault = Fault::new(format_args!("a wait of {seconds} seconds cannot be written"));
            return Err(stop(at, fault.help(format_args!("between {low} and {high} seconds can be"))));
        }
        self.cancel_inverse_time(sink)?;
        self.times.wait(seconds / 60.0);
        Ok(sink.step(&Step::Dwell { seconds })?)
    }

    /// A block as it stands: where the machine is behind it, and in which state, nobody knows.
    fn raw(&mut self, at: Location, text: &[u8], sink: &mut impl Sink) -> Planned {
        if self.policy.options.lift.is_some() {
            let fault =
                Fault::new("a dry run writes no NC text of the CL data: nobody knows what it moves or switches on");
            return Err(stop(at, fault.help("`--insert comment`, or take it out")));
        }
        if text.is_empty() || !text.iter().all(|byte| (b' '..=b'~').contains(byte)) {
            let fault =
                Fault::new("INSERT is empty or holds bytes that are not ASCII, which controls read differently");
            return Err(stop(at, fault.help("write it in plain letters, digits and signs, or `--insert comment`")));
        }
        self.begin(at, true, sink)?;
        self.cancel_inverse_time(sink)?;
        if self.framed {
            self.machine_retract(at, sink)?;
        }
        sink.step(&Step::Raw { text })?;
        self.spindle = None;
        self.spindle_stop = false;
        self.coolant = None;
        self.there = false;
        self.clear = false;
        Ok(())
    }

    /// GOHOME without a point.
    fn go_home(&mut self, at: Location, sink: &mut impl Sink) -> Planned {
        if self.policy.options.park.is_empty() && self.policy.options.retract.position.is_none() {
            let fault = Fault::new("GOHOME without a point, and neither `park` nor `retract.position` is configured");
            return Err(stop(at, fault.help("give one of them, or GOHOME/x,y,z")));
        }
        self.begin(at, true, sink)?;
        self.machine_retract(at, sink)?;
        self.park(at, sink)?;
        self.there = false;
        self.clear = false;
        Ok(())
    }

    /// A frame with a work offset of its own.
    fn change_frame(&mut self, at: Location, number: u32, sink: &mut impl Sink) -> Planned {
        if self.placer.turning_table() {
            let fault = Fault::new("the part origin of another frame on a table that turns is not known");
            return Err(stop(at, fault.help("`--frames main` maps every frame into the first")));
        }
        let word = match self.policy.set_up.frames.get(&number) {
            Some(word) => word,
            None if number == 1 => &self.policy.set_up.work_offset,
            None => {
                let fault = Fault::new(format_args!("frame {number} of the CL data has no work offset"));
                return Err(stop(at, fault.help(format_args!("give it one: `[frames] \"{number}\" = \"G55\"`"))));
            }
        };
        self.begin(at, true, sink)?;
        self.there = false;
        self.clear = false;
        // It was given in the other frame.
        self.clearance = self.policy.options.retract.clearance;
        Ok(sink.step(&Step::WorkOffset { word })?)
    }

    /// The tool of a record; what is odd about a tool is said once.
    fn resolve(&mut self, at: Location, call: &ToolCall) -> Result<Tool, Stop> {
        let before = self.calls.get(&call.number).copied();
        let known = before.is_some();
        let before = before.unwrap_or_default();
        let warnings = &mut self.warnings;
        let remark = |fault: Fault| {
            if !known {
                warnings.push(fault.at(at, Severity::Warning));
            }
        };
        let (needed, registers) = (self.placer.needs_length(), self.abilities.registers);
        let tool =
            Tool::resolve(call, &before, self.policy, needed, registers, remark).map_err(|fault| stop(at, fault))?;
        let (length, offset) = (call.length.or(before.length), call.offset.or(before.offset));
        self.calls.insert(call.number, ToolCall { length, offset, ..*call });
        Ok(tool)
    }

    /// A start begins, or goes on: what was held back is written, and the tool leaves the part.
    fn begin(&mut self, at: Location, leave: bool, sink: &mut impl Sink) -> Planned {
        self.settle(None, sink)?;
        self.phase = Phase::Start;
        if leave {
            self.leave(at, sink)?;
        }
        sink.serve(at, Why::Record);
        Ok(())
    }

    fn stop(&mut self, at: Location, optional: bool, sink: &mut impl Sink) -> Planned {
        // Behind the stop the retract axis goes up from wherever the tool stands: a tilted tool is led out before.
        self.begin(at, self.policy.options.stop_retract || !self.placer.straight(), sink)?;
        if self.policy.options.stop_retract {
            self.coolant_off(sink)?;
            self.machine_retract(at, sink)?;
            self.spindle_off(sink)?;
        }
        self.stop_spindle(sink)?;
        sink.step(&Step::Stop { optional })?;
        // The operator may have done anything.
        self.spindle = None;
        self.coolant = None;
        self.there = false;
        self.clear = false;
        Ok(())
    }

    /// FROM: before the first motion it says where the rotaries count from.
    pub(super) fn from(&mut self, pose: &Pose) {
        if !self.placed
            && let Some(place) = self.placer.reference(pose, &self.place)
        {
            self.place = place;
        }
    }
}
