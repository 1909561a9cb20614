//! Cutter compensation by the control (CUTCOM: G41, G42, G40).
//!
//! The control offsets the path to the left or right by the value of register D, in the plane perpendicular to Z of the
//! program (G17). The rotary axes rest, and the tool axis is that Z. Compensation begins with the first straight feed
//! motion in this plane after CUTCOM/LEFT or RIGHT, and ends with the first one after CUTCOM/OFF. Between the two only
//! such lines are allowed, and arcs that are written as arcs: a control looks ahead over these blocks, so everything
//! else is refused.
//!
//! In mirrored coordinates left and right are exchanged. The configuration states the value of D: the wear where the CL
//! data is the path of the tool centre, the radius where it is the contour. A control without such registers takes the
//! radius of the tool itself: where the path is that of the centre the tool call takes it off, or a guard stops the
//! program unless it is wear only.
//!
//! The contour of the program is offset here as well, by the radius, or by the largest wear to both sides: `offset`
//! refuses what the tool does not fit into, whatever the control would do there.

mod offset;

use std::collections::BTreeSet;

use nalgebra::Vector3;

use crate::kinematics::math;
use crate::motion::options::{ArcOutput, CutterPath, Policy, StretchMode};
use crate::program::{Arc, Compensation, CutterSide, Event, Move, ReferenceGeometry, Units};

use self::offset::Offsets;
use crate::motion::fault::{Fault, Planned};
use crate::motion::place::AxisPosition;
use crate::motion::plan::abilities::CutterRadius;
use crate::motion::plan::tool::LoadedTool;
use crate::motion::plan::{MotionAndNext, Planner};
use crate::motion::source::MotionIndex;
use crate::motion::step::{Sink, Step};
use crate::motion::tolerances::{IN_CUTTER_PLANE, SAME_AXIS};

/// Largest delta of the radius in a tool call, mm.
const LARGEST_DELTA: f64 = 99.999;

/// Last request of CUTCOM, and the state in force.
#[derive(Debug, Default)]
pub(crate) struct CutterCompensation {
    /// In force, or from the next line in the plane on.
    side: Option<CutterSide>,
    /// Side of the last CUTCOM/LEFT or RIGHT.
    last: Option<CutterSide>,
    /// Register programmed in the CL data.
    register: Option<u32>,
    state: Compensating,
    offsets: Offsets,
    units: Units,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Compensating {
    #[default]
    Off,
    /// Requested; begins with the next line in the plane.
    Begins,
    On,
    /// Ends with the next motion.
    Ends,
}

impl CutterCompensation {
    /// Off, in a program in these units.
    pub(crate) fn new(units: Units) -> Self {
        Self { units, ..Self::default() }
    }

    /// Whether compensation is neither requested nor in force.
    #[inline]
    pub(crate) fn is_idle(&self) -> bool {
        self.state == Compensating::Off
    }

    /// Tools with unknown radius that cut a contour.
    pub(crate) fn unknown_radii(&self) -> &BTreeSet<u32> {
        self.offsets.unknown()
    }

    fn in_force(&self) -> bool {
        matches!(self.state, Compensating::On | Compensating::Ends)
    }

    /// CUTCOM/LEFT, RIGHT or ON.
    fn begin(&mut self, asked: CutterSide, register: Option<u32>) -> Result<(), Fault> {
        let side = if asked == CutterSide::On {
            self.last.ok_or_else(|| Fault::new("CUTCOM/ON without a side"))?
        } else {
            asked
        };
        if self.in_force() && self.side != Some(side) {
            return Err(in_force_fault("CUTCOM requests the other side"));
        }
        let register = register.or(self.register.filter(|_| asked == CutterSide::On));
        let state = if self.in_force() { Compensating::On } else { Compensating::Begins };
        (self.side, self.last, self.register, self.state) = (Some(side), Some(side), register, state);
        Ok(())
    }

    /// CUTCOM/OFF; false if compensation was requested and has never begun.
    fn end(&mut self) -> bool {
        let began = self.state != Compensating::Begins;
        self.state = if self.in_force() { Compensating::Ends } else { Compensating::Off };
        began
    }

    /// Refuses a record that interrupts the look-ahead of the control.
    pub(crate) fn check_record(&self, event: &Event<'_>) -> Result<(), Fault> {
        let what = match event {
            Event::NewStart(start) => start.sentence(),
            Event::Interruption(interruption) => interruption.sentence(),
            Event::Reference(ReferenceGeometry::From(_)) => "FROM follows",
            Event::Reference(ReferenceGeometry::ClearancePlane(_))
            | Event::Motion(_)
            | Event::Function(_)
            | Event::Text(..) => return Ok(()),
        };
        self.check_idle(what)
    }

    /// Refuses a hole.
    pub(crate) fn check_hole(&self) -> Result<(), Fault> {
        self.check_idle("a hole follows")
    }

    /// Refuses a curve.
    pub(crate) fn check_curve(&self) -> Result<(), Fault> {
        self.check_idle("a curve follows, which is written as chords")
    }

    fn check_idle(&self, what: &str) -> Result<(), Fault> {
        if self.in_force() { Err(in_force_fault(what)) } else { Ok(()) }
    }

    /// Refuses the end of the program where compensation is requested or in force.
    pub(crate) fn check_end(&self) -> Result<(), Fault> {
        match self.state {
            Compensating::Off => Ok(()),
            Compensating::Begins => {
                Err(Fault::new("CUTCOM requests compensation, but no straight feed motion in the plane follows")
                    .help("remove CUTCOM, or give it before the lead-in"))
            }
            Compensating::On | Compensating::Ends => Err(in_force_fault("the program ends")),
        }
    }
}

/// Fault: `what` comes while compensation is in force.
fn in_force_fault(what: &str) -> Fault {
    Fault::new(format_args!("cutter compensation (CUTCOM) is still active: {what}"))
        .help("program CUTCOM/OFF and a straight feed motion in the plane before this")
}

/// CUTCOM.
pub(crate) fn request<S: Sink>(planner: &mut Planner<'_, S>, asked: &Compensation) -> Planned {
    let Compensation { side, register, in_xy_plane: xy } = *asked;
    if side == CutterSide::Off {
        if !planner.cutter.end() {
            let fault = Fault::new("CUTCOM/OFF without a straight feed motion in the plane before it")
                .help("nothing was compensated: check the side and the lead-in");
            planner.mover.output_mut().remark(fault);
        }
        return Ok(());
    }
    check_set_up(planner.policy, xy)?;
    Ok(planner.cutter.begin(side, register)?)
}

/// Fault: cutter compensation under tip control.
#[cold]
fn under_tip_control() -> Fault {
    Fault::new("cutter compensation in the plane is not possible under tip control")
        .help("post this program with mode axes or plane, or remove CUTCOM")
}

/// Refuses CUTCOM where configuration, mode or plane do not allow it.
fn check_set_up(policy: Policy<'_>, xy: bool) -> Result<(), Fault> {
    if policy.options.compensation.is_none() {
        return Err(Fault::new(
            "CUTCOM requests cutter compensation by the control, but `compensation.path` is not set",
        )
        .help(
            "configure the value of D: `[compensation] path = \"centre\"` (D holds the wear) or `\"contour\"` (D \
                 holds the radius); or output CL data without CUTCOM",
        ));
    }
    if policy.options.mode_of_all() == Some(StretchMode::Tcp) {
        return Err(under_tip_control());
    }
    if !xy {
        return Err(Fault::new("cutter compensation is possible in the plane of X and Y only")
            .help("remove CUTCOM, and output the path of the tool centre in CAM"));
    }
    Ok(())
}

/// Plans a motion while compensation is requested, in force, or about to end.
#[cold]
pub(crate) fn line<S: Sink>(planner: &mut Planner<'_, S>, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
    let motion = ahead.motion;
    let from = *planner.mover.here();
    let step = in_program(planner, &from, motion);
    let unit = planner.mover.placer().unit_mm();
    // By the words, or by the CL data: coarse rotary words tilt the plane of the program.
    let along = (motion.pose.tip - from.pose.tip).dot(&motion.pose.axis);
    let flat = |step: &Vector3<f64>| math::smaller(step.z.abs(), along.abs()) <= (0.5 * unit).max(IN_CUTTER_PLANE);
    let line = |step: &Vector3<f64>| !motion.rapid && flat(step) && math::hypot(step.x, step.y) >= unit;
    let before = planner.cutter.state;
    match before {
        Compensating::Off => {}
        Compensating::Begins => {
            // Other motions may still lead the tool to the start of the line.
            if let Ok(step) = step.as_ref()
                && line(step)
            {
                switch(planner, true)?;
            } else if !motion.rapid {
                step?;
            }
        }
        Compensating::On if motion.rapid => return Err(in_force_fault("a rapid follows").into()),
        Compensating::On => {
            if !flat(&step?) {
                return Err(in_force_fault("a motion leaves its plane").into());
            }
        }
        Compensating::Ends => {
            if !line(&step?) {
                return Err(Fault::new(
                    "compensation ends with a straight feed motion in its plane, but another motion follows",
                )
                .help("give a line in the plane as lead-out after CUTCOM/OFF")
                .into());
            }
            switch(planner, false)?;
        }
    }
    let stays = planner.cutter.in_force() || planner.cutter.is_idle();
    planner.run(ahead, index)?;
    if stays && planner.mover.placer().rotates(&from.words, &planner.mover.here().words) {
        return Err(in_force_fault("a rotary axis rotates").into());
    }
    match (before, planner.cutter.state) {
        (Compensating::Begins, Compensating::On) => offset::begin(planner, &from)?,
        (Compensating::On, _) => offset::line(planner, &from)?,
        (Compensating::Ends, _) => offset::end(planner, &from)?,
        (Compensating::Off | Compensating::Begins, _) => {}
    }
    Ok(())
}

/// Plans an arc by `run` while compensation is requested or in force.
#[cold]
pub(crate) fn arc<'a, S: Sink>(
    planner: &mut Planner<'a, S>,
    arc: &Arc,
    run: impl FnOnce(&mut Planner<'a, S>) -> Planned,
) -> Planned {
    if planner.cutter.state != Compensating::On {
        let when = if planner.cutter.state == Compensating::Begins { "begins" } else { "ends" };
        let text = format!("compensation {when} with a straight feed motion in its plane, but an arc follows");
        return Err(Fault::new(text).help("give lines as lead-in and lead-out").into());
    }
    let axis = arc.end.axis.into_inner();
    let perpendicular = axis.cross(&arc.normal).norm() <= SAME_AXIS;
    let rise = (arc.end.tip - arc.start.tip).dot(&axis).abs();
    if !perpendicular || rise > 0.5 * planner.mover.placer().unit_mm() {
        return Err(in_force_fault("an arc leaves its plane").into());
    }
    let (before, from) = (planner.mover.output().statistics().chorded, *planner.mover.here());
    let elements = planner.cutter.offsets.elements();
    run(planner)?;
    // An arc as flat as its chord is not counted.
    let chorded = planner.mover.output().statistics().chorded != before;
    if chorded || planner.policy.options.arcs.output == ArcOutput::Lines {
        return Err(in_force_fault("an arc follows that is written as chords").into());
    }
    if planner.mover.placer().rotates(&from.words, &planner.mover.here().words) {
        return Err(in_force_fault("a rotary axis rotates").into());
    }
    if planner.cutter.offsets.elements() == elements && planner.mover.here().words != from.words {
        // It is its chord.
        offset::line(planner, &from)?;
    }
    Ok(())
}

/// Largest angle between the tool axis and Z of a plane by the rounding of its three angles, or of the rotary words
/// where its zero follows the table, rad.
fn plane_lean<S: Sink>(planner: &Planner<'_, S>) -> f64 {
    let decimals = match planner.mover.placer().mode() {
        StretchMode::Axes | StretchMode::Tcp => None,
        StretchMode::Plane if planner.mover.moves_zero() => Some(planner.policy.formats.rotary),
        StretchMode::Plane => planner.abilities.plane.map(|plane| plane.decimals),
    };
    decimals.map_or(0.0, |decimals| 1.5 * 10_f64.powi(-decimals.cast_signed()).to_radians())
}

/// A motion in program coordinates, mm; refused where the tool axis is not Z of the program.
fn in_program<S: Sink>(planner: &Planner<'_, S>, from: &AxisPosition, motion: &Move) -> Result<Vector3<f64>, Fault> {
    let in_plane = planner.mover.placer().mode() == StretchMode::Plane;
    let tilted = || {
        Fault::new("cutter compensation works in the plane of X and Y, but the tool axis is not Z of the program here")
            .help(match in_plane {
                // The rotary axes are off the tool axis, as those with steps are.
                true => "move the tool axis of the operation to a step in CAM",
                false => "post this program with mode plane, or remove CUTCOM",
            })
    };
    let (_, map) = planner.mover.placer().orthogonal_map(from).ok_or_else(tilted)?;
    let along = map * motion.pose.axis.into_inner();
    if along.z < 0.0 || math::hypot(along.x, along.y) > SAME_AXIS + plane_lean(planner) {
        return Err(tilted());
    }
    Ok(map * (motion.pose.tip - from.pose.tip))
}

/// Delta of the radius in a tool call: takes the radius off where the path is that of the tool centre, and the control
/// takes the radius of the tool itself.
pub(crate) fn radius_delta<S: Sink>(planner: &Planner<'_, S>, tool: &LoadedTool) -> Result<Option<f64>, Fault> {
    let (path, ability) = (planner.policy.options.compensation, planner.abilities.cutter_radius);
    let radius_mm = tool.radius_mm.filter(|_| {
        path == Some(CutterPath::Centre)
            && ability == CutterRadius::WithDelta { written: true }
            && planner.tooling.may_be_compensated(tool.number)
    });
    let Some(radius_mm) = radius_mm else { return Ok(None) };
    let units = planner.mover.placer().units();
    if radius_mm > LARGEST_DELTA {
        return Err(Fault::new(format_args!(
            "the radius of T{} is {}, and the delta in the tool call is {} at most",
            tool.number,
            units.length(radius_mm),
            units.length(LARGEST_DELTA)
        ))
        .help("output the contour in CAM, and set `[compensation] path = \"contour\"`"));
    }
    Ok(Some(-radius_mm))
}

/// Writes the guard of the tool radius, where the program needs it and the control has it.
pub(crate) fn guard<S: Sink>(planner: &mut Planner<'_, S>, tool: &LoadedTool) -> Planned {
    let options = &planner.policy.options;
    let needed = options.compensation == Some(CutterPath::Centre) && planner.tooling.may_be_compensated(tool.number);
    if needed && planner.abilities.cutter_radius == (CutterRadius::OfTool { guarded: true }) {
        let wear = options.largest_wear_mm;
        planner.mover.output_mut().guard(&Step::RadiusGuard { tool: tool.number, wear })?;
    }
    Ok(())
}

/// Refuses the path of the tool centre where the control would offset it by the whole radius.
fn check_radius<S: Sink>(planner: &Planner<'_, S>) -> Result<(), Fault> {
    if planner.policy.options.compensation != Some(CutterPath::Centre) {
        return Ok(());
    }
    let tool = planner.tooling.current();
    match planner.abilities.cutter_radius {
        CutterRadius::Register | CutterRadius::OfTool { guarded: true } => Ok(()),
        CutterRadius::WithDelta { written: true } => match tool {
            Some(tool) if tool.radius_mm.is_none() => Err(Fault::new(format_args!(
                "CUTCOM on the path of the tool centre: the radius of T{} is unknown, which the tool call must take off (DR)",
                tool.number
            ))
            .help(format_args!("give `[tools.{}] diameter`, or CUTTER in the CL data", tool.number))),
            _ => Ok(()),
        },
        CutterRadius::WithDelta { written: false } => Err(Fault::new(
            "CUTCOM on the path of the tool centre: the tool call must take the radius of the tool off (DR)",
        )
        .help("add `DR{radius_delta}` to the tool call in `control.tool_change`")),
        CutterRadius::OfTool { guarded: false } => Err(Fault::new(
            "CUTCOM on the path of the tool centre: this control would offset it by the whole radius of the tool",
        )
        .help("output the contour in CAM, and set `[compensation] path = \"contour\"`")),
    }
}

/// Switches compensation on or off with the next block.
fn switch<S: Sink>(planner: &mut Planner<'_, S>, on: bool) -> Planned {
    if on && planner.mover.placer().mode() == StretchMode::Tcp {
        return Err(under_tip_control().into());
    }
    check_radius(planner)?;
    let register = radius_register(planner)?;
    let mover = &mut planner.mover;
    let mirrored = mover.placer().orthogonal_map(mover.here()).is_some_and(|(_, map)| map.determinant() < 0.0);
    let left = (planner.cutter.side == Some(CutterSide::Left)) != mirrored;
    mover.output_mut().step(&Step::CutterCompensation { left: on.then_some(left), register })?;
    planner.cutter.state = if on { Compensating::On } else { Compensating::Off };
    if on {
        offset::select(planner, left);
    }
    Ok(())
}

/// Register of the radius of the tool.
fn radius_register<S: Sink>(planner: &Planner<'_, S>) -> Result<u32, Fault> {
    let Some(tool) = planner.tooling.current() else {
        return Err(Fault::new("CUTCOM before the first tool call"));
    };
    let number = tool.number;
    let given =
        planner.policy.set_up.tools.get(&number).and_then(|tool| tool.radius_offset).or(planner.cutter.register);
    if let Some(given) =
        given.filter(|given| *given != number && planner.abilities.cutter_radius != CutterRadius::Register)
    {
        return Err(Fault::new(format_args!(
            "T{number} is given radius register {given}, but this control takes the radius of the tool itself"
        ))
        .help(format_args!("remove the register from CUTCOM and `[tools.{number}] radius_offset`")));
    }
    Ok(given.unwrap_or(number))
}

pub(crate) use self::offset::arc_piece;

#[cfg(test)]
mod tests;
