//! Cutter compensation in the plane by the control: CUTCOM.
//!
//! The control shifts the path to its left or right by what the register D holds, in the plane square to Z of the program
//! (G17), with the rotary axes still and the tool along that Z. It comes on with the first straight feed motion in this plane
//! behind CUTCOM/LEFT or RIGHT, and goes off with the one behind CUTCOM/OFF; between the two there are only such lines, and
//! arcs that the control traces itself. A control looks ahead over these blocks, so whatever else stands there is refused.
//!
//! In mirrored words left is right. What D holds is said in the configuration: wear where the CL data is the path of the
//! tool's centre, the radius where it is the contour.

use nalgebra::Vector3;

use super::options::{ArcOutput, CutterPath, Mode};
use crate::diag::Severity;
use crate::kinematics::Machine;
use crate::program::{Arc, Compensation, CutterSide, Event, Location, Move};

use super::fault::Fault;
use super::place::Place;
use super::planner::{Planned, Planner, SAME_AXIS, stop};
use super::step::{Sink, Step};

/// Points of CL data are rounded: a motion is in the plane if it leaves it by no more than this, mm, however fine the words.
const FLAT: f64 = 5e-4;

/// What CUTCOM asked for last, and what is in force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Cutter {
    /// Wanted from the next line in the plane on, or in force.
    side: Option<CutterSide>,
    /// Side of the last CUTCOM/LEFT or RIGHT.
    last: Option<CutterSide>,
    /// Register that the CL data named.
    register: Option<u32>,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum State {
    #[default]
    Off,
    /// Asked for, to begin with the next line in the plane.
    Begins,
    On,
    /// To end with the next motion.
    Ends,
}

impl Cutter {
    /// Nothing is asked for and nothing in force.
    #[inline]
    pub(super) fn idle(&self) -> bool {
        self.state == State::Off
    }

    fn in_force(&self) -> bool {
        matches!(self.state, State::On | State::Ends)
    }
}

/// What cannot stand between the line that brings compensation on and the one that ends it.
fn beside(what: &str) -> Fault {
    Fault::new(format_args!("cutter compensation is in force, and {what}"))
        .help("put CUTCOM/OFF and a straight feed motion in the plane in front of it")
}

impl<M: Machine> Planner<'_, M> {
    /// CUTCOM.
    pub(super) fn set_cutter(&mut self, at: Location, asked: &Compensation) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let Compensation { side, register, xy } = *asked;
        let side = match side {
            CutterSide::Off => {
                if self.cutter.state == State::Begins {
                    let fault = Fault::new("CUTCOM/OFF, and no straight feed motion in the plane came before it")
                        .help("nothing was compensated: check the side and the lead-in");
                    self.warnings.push(fault.at(at, Severity::Warning));
                }
                self.cutter.state = if self.cutter.in_force() { State::Ends } else { State::Off };
                return Ok(());
            }
            CutterSide::On => self.cutter.last.ok_or_else(|| {
                fault(Fault::new("CUTCOM/ON without a side").help("give CUTCOM/LEFT or CUTCOM/RIGHT"))
            })?,
            side => side,
        };
        self.cutter_fits(xy).map_err(fault)?;
        if self.cutter.in_force() && self.cutter.side != Some(side) {
            return Err(fault(beside("CUTCOM asks for the other side")));
        }
        let register = register.or(self.cutter.register.filter(|_| asked.side == CutterSide::On));
        let state = if self.cutter.in_force() { State::On } else { State::Begins };
        self.cutter = Cutter { side: Some(side), last: Some(side), register, state };
        Ok(())
    }

    /// Whether the configuration lets the control compensate.
    fn cutter_fits(&self, xy: bool) -> Result<(), Fault> {
        if self.policy.options.compensation.is_none() {
            return Err(Fault::new("CUTCOM asks for cutter compensation by the control").help(
                "say what D holds: `[compensation] path = \"centre\"` (wear) or `\"contour\"` (the radius); or have the \
                 CAM system leave CUTCOM out",
            ));
        }
        if self.policy.options.mode == Mode::Tcp {
            return Err(Fault::new("there is no cutter compensation in the plane under tip control")
                .help("post this program with mode axes or plane, or leave CUTCOM out"));
        }
        if !xy {
            return Err(Fault::new("cutter compensation is written for the plane of X and Y only")
                .help("leave CUTCOM out, and have the CAM system compute the path of the tool's centre"));
        }
        Ok(())
    }

    /// Refuses what a control does not look ahead over.
    pub(super) fn bears_cutter(&self, at: Location, event: &Event<'_>) -> Planned {
        if !self.cutter.in_force() {
            return Ok(());
        }
        let what = match event {
            Event::Hole(_) => "a hole follows",
            Event::Spline(_) => "a curve follows, which would be chords",
            Event::Tool(_) => "a tool is called",
            Event::Operation(_) | Event::SafeSequence => "another operation begins",
            Event::Stop | Event::OptionalStop => "the program stops",
            Event::Frame(_) => "another frame follows",
            Event::Home => "the machine goes home",
            Event::From(_) => "FROM places the tool elsewhere",
            Event::Insert(_) | Event::Code { .. } => "a block follows that the CL data gives as it stands",
            _ => return Ok(()),
        };
        Err(stop(at, beside(what)))
    }

    /// The program ends.
    pub(super) fn ends_cutter(&self, at: Location) -> Planned {
        match self.cutter.state {
            State::Off => Ok(()),
            State::Begins => Err(stop(
                at,
                Fault::new("CUTCOM asked for compensation, and no straight feed motion in the plane follows")
                    .help("leave CUTCOM out, or give it in front of the lead-in"),
            )),
            State::On | State::Ends => Err(stop(at, beside("the program ends"))),
        }
    }

    /// A motion while compensation is asked for, in force, or about to end.
    #[cold]
    pub(super) fn beside_path(&mut self, at: Location, motion: &Move, number: u64, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let from = self.place;
        let step = self.in_program(&from, motion).map_err(fault);
        let unit = self.placer.unit_mm();
        let flat = |step: &Vector3<f64>| step.z.abs() <= (0.5 * unit).max(FLAT);
        let line = |step: &Vector3<f64>| !motion.rapid && flat(step) && step.x.hypot(step.y) >= unit;
        match self.cutter.state {
            State::Off => {}
            State::Begins => {
                // Elsewhere the tool may still be led to where the line begins.
                if let Ok(step) = step.as_ref()
                    && line(step)
                {
                    self.long_enough(step.x.hypot(step.y)).map_err(fault)?;
                    self.switch_cutter(at, true, sink)?;
                } else if !motion.rapid {
                    step?;
                }
            }
            State::On if motion.rapid => return Err(fault(beside("a rapid follows"))),
            State::On => {
                if !flat(&step?) {
                    return Err(fault(beside("a motion leaves its plane")));
                }
            }
            State::Ends => {
                if !line(&step?) {
                    return Err(fault(
                        Fault::new("compensation ends in a straight feed motion in its plane, and another one follows")
                            .help("let the lead-out be a line in the plane behind CUTCOM/OFF"),
                    ));
                }
                self.switch_cutter(at, false, sink)?;
            }
        }
        let stays = self.cutter.in_force() || self.cutter.idle();
        self.run(at, motion, number, sink)?;
        if stays && self.placer.rotary_travel(&from.words, &self.place.words) > 0.0 {
            return Err(fault(beside("a rotary axis turns")));
        }
        Ok(())
    }

    /// An arc while compensation is asked for or in force.
    #[cold]
    pub(super) fn beside_arc(&mut self, at: Location, arc: &Arc, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        if self.cutter.state != State::On {
            let when = if self.cutter.state == State::Begins { "begins" } else { "ends" };
            let text = format!("compensation {when} in a straight feed motion in its plane, and an arc follows");
            return Err(fault(Fault::new(text).help("let lead-in and lead-out be lines")));
        }
        let axis = arc.end.axis.into_inner();
        let square = axis.cross(&arc.normal).norm() <= SAME_AXIS;
        let rise = (arc.end.tip - arc.start.tip).dot(&axis).abs();
        if !square || rise > 0.5 * self.placer.unit_mm() {
            return Err(fault(beside("an arc leaves its plane")));
        }
        let (before, words) = (self.statistics.chorded, self.place.words);
        self.arc(at, arc, sink)?;
        // What is so flat that its chord is it, is not counted.
        if self.statistics.chorded != before || self.policy.options.arcs.output == ArcOutput::Lines {
            return Err(fault(beside("an arc follows that would be chords")));
        }
        if self.placer.rotary_travel(&words, &self.place.words) > 0.0 {
            return Err(fault(beside("a rotary axis turns")));
        }
        Ok(())
    }

    /// A motion in the coordinates of the program, mm; the tool has to stand along its Z.
    fn in_program(&self, from: &Place<M::Axes>, motion: &Move) -> Result<Vector3<f64>, Fault> {
        let tilted = || {
            Fault::new(
                "cutter compensation works in the plane of X and Y, and the tool axis is not Z of the program here",
            )
            .help("post this program with mode plane, or leave CUTCOM out")
        };
        let (_, map) = self.placer.square_map(from).ok_or_else(tilted)?;
        let along = map * motion.pose.axis.into_inner();
        if along.z < 0.0 || along.x.hypot(along.y) > SAME_AXIS {
            return Err(tilted());
        }
        Ok(map * (motion.pose.tip - from.pose.tip))
    }

    /// Where D holds the radius, a line that is shorter leaves no way to the contour.
    fn long_enough(&self, length: f64) -> Result<(), Fault> {
        let diameter =
            self.tool.and_then(|tool| self.policy.set_up.tools.get(&tool.number)).and_then(|tool| tool.diameter);
        let radius =
            diameter.filter(|_| self.policy.options.compensation == Some(CutterPath::Contour)).map(|d| 0.5 * d);
        match radius.filter(|radius| length < *radius) {
            Some(radius) => Err(Fault::new(format_args!(
                "compensation begins in a line {length:.3} mm long, and the tool has a radius of {radius:.3} mm"
            ))
            .help("make the lead-in longer than the radius")),
            None => Ok(()),
        }
    }

    /// On or off with the next block.
    fn switch_cutter(&mut self, at: Location, on: bool, sink: &mut impl Sink) -> Planned {
        let register = self.cutter_register().map_err(|fault| stop(at, fault))?;
        let mirrored = self.placer.square_map(&self.place).is_some_and(|(_, map)| map.determinant() < 0.0);
        let left = (self.cutter.side == Some(CutterSide::Left)) != mirrored;
        sink.step(&Step::Beside { left: on.then_some(left), register })?;
        self.cutter.state = if on { State::On } else { State::Off };
        Ok(())
    }

    /// The register of the tool's radius.
    fn cutter_register(&self) -> Result<u32, Fault> {
        let number = self.tool.map(|tool| tool.number).ok_or_else(|| Fault::new("CUTCOM without a tool"))?;
        let given = self.policy.set_up.tools.get(&number).and_then(|tool| tool.radius_offset).or(self.cutter.register);
        if let Some(given) = given.filter(|given| *given != number && !self.abilities.radius_registers) {
            return Err(Fault::new(format_args!(
                "T{number} is to have the radius of register {given}, and this control takes that of the tool itself"
            ))
            .help(format_args!("leave the register out of CUTCOM and `[tools.{number}] radius_offset`")));
        }
        Ok(given.unwrap_or(number))
    }
}

#[cfg(test)]
mod tests;
