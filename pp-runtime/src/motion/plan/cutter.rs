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
//!
//! Decides what a motion is to the compensation, before it is planned and after it is written; the planner acts.

mod offset;

use std::collections::BTreeSet;

use nalgebra::Vector3;

use crate::diag::code::plan;
use crate::kinematics::math;
use crate::motion::policy::Policy;
use crate::options::{CutterPath, StretchMode};
use crate::program::{Arc, Compensation, CutterSide, Event, Move, ReferenceGeometry};

use self::offset::Offsets;
use crate::motion::fault::Fault;
use crate::motion::geometry::Circle;
use crate::motion::place::{AxisPosition, Placer};
use crate::motion::plan::abilities::{Abilities, CutterRadius};
use crate::motion::plan::tool::LoadedTool;
use crate::motion::plan::tooling::Tooling;
use crate::motion::step::Step;
use crate::tolerance::writer::{IN_CUTTER_PLANE, SAME_AXIS};

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
}

/// What compensation depends on apart from the CL data.
pub(crate) struct CutterSite<'s> {
    pub(crate) policy: Policy<'s>,
    pub(crate) abilities: &'s Abilities,
    pub(crate) tooling: &'s Tooling,
    pub(crate) placer: &'s Placer,
    /// Where the tool is.
    pub(crate) here: &'s AxisPosition,
    /// The zero of the program follows the table.
    pub(crate) moves_zero: bool,
    /// Line of the CL data.
    pub(crate) line: u64,
}

/// How an arc has been written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum WrittenArc {
    /// As arcs of the control.
    Arcs,
    /// As flat as its chord, as a line.
    Chord,
    /// As chords within the tolerance.
    Chords,
}

/// What a line is to the compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CompensatedLine {
    /// It leads to the start of the lead-in.
    Ahead,
    /// Compensation is switched on with its block.
    LeadIn,
    Contour,
    /// Compensation is switched off with its block.
    LeadOut,
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
    /// Whether compensation is neither requested nor in force.
    #[inline]
    pub(crate) fn is_idle(&self) -> bool {
        self.state == Compensating::Off
    }

    /// CUTCOM; what is to be remarked about it.
    pub(crate) fn request(&mut self, asked: &Compensation, policy: Policy<'_>) -> Result<Option<Fault>, Fault> {
        let Compensation { side, register, in_xy_plane } = *asked;
        if side != CutterSide::Off {
            check_set_up(policy, in_xy_plane)?;
            self.begin(side, register)?;
            return Ok(None);
        }
        let ended = self.end();
        Ok((!ended).then(|| {
            plan::CUTTER_COMPENSATION
                .fault("CUTCOM/OFF without a straight feed motion in the plane before it")
                .help("nothing was compensated: check the side and the lead-in")
        }))
    }

    /// What a line is, while compensation is requested, in force, or about to end.
    pub(crate) fn line(&self, motion: &Move, site: &CutterSite<'_>) -> Result<CompensatedLine, Fault> {
        let step = site.in_program(motion);
        let unit = site.placer.unit_mm();
        // By the words, or by the CL data: coarse rotary words tilt the plane of the program.
        let along = (motion.pose.tip - site.here.pose.tip).dot(&motion.pose.axis);
        let flat = |step: &Vector3<f64>| math::smaller(step.z.abs(), along.abs()) <= (0.5 * unit).max(IN_CUTTER_PLANE);
        let is_line = |step: &Vector3<f64>| !motion.rapid && flat(step) && math::hypot(step.x, step.y) >= unit;
        match self.state {
            Compensating::Off => Ok(CompensatedLine::Ahead),
            // Other motions may still lead the tool to the start of the line.
            Compensating::Begins if step.as_ref().is_ok_and(is_line) => Ok(CompensatedLine::LeadIn),
            Compensating::Begins if motion.rapid => Ok(CompensatedLine::Ahead),
            Compensating::Begins => step.map(|_| CompensatedLine::Ahead),
            Compensating::On if motion.rapid => Err(in_force_fault("a rapid follows")),
            Compensating::On => match flat(&step?) {
                true => Ok(CompensatedLine::Contour),
                false => Err(in_force_fault("a motion leaves its plane")),
            },
            Compensating::Ends => match is_line(&step?) {
                true => Ok(CompensatedLine::LeadOut),
                false => Err(plan::CUTTER_COMPENSATION
                    .fault("compensation ends with a straight feed motion in its plane, but another motion follows")
                    .help("give a line in the plane as lead-out after CUTCOM/OFF")),
            },
        }
    }

    /// The step that switches compensation with the block of a line.
    pub(crate) fn switch(
        &mut self,
        line: CompensatedLine,
        site: &CutterSite<'_>,
    ) -> Result<Option<Step<'static>>, Fault> {
        let on = match line {
            CompensatedLine::Ahead | CompensatedLine::Contour => return Ok(None),
            CompensatedLine::LeadIn => true,
            CompensatedLine::LeadOut => false,
        };
        if on && site.placer.mode() == StretchMode::Tcp {
            return Err(under_tip_control());
        }
        site.check_radius()?;
        let register = site.radius_register(self.register)?;
        let mirrored = site.placer.orthogonal_map(site.here).is_some_and(|(_, map)| map.determinant() < 0.0);
        let left = (self.side == Some(CutterSide::Left)) != mirrored;
        self.state = if on { Compensating::On } else { Compensating::Off };
        if on {
            self.offsets.select(left, site);
        }
        Ok(Some(Step::CutterCompensation { left: on.then_some(left), register }))
    }

    /// A line has been written from a position.
    pub(crate) fn after_line(
        &mut self,
        line: CompensatedLine,
        from: &AxisPosition,
        site: &CutterSite<'_>,
    ) -> Result<(), Fault> {
        if line != CompensatedLine::Ahead {
            check_at_rest(from, site)?;
        }
        match line {
            CompensatedLine::Ahead => Ok(()),
            CompensatedLine::LeadIn => self.offsets.begin(from, site),
            CompensatedLine::Contour => self.offsets.line(from, site),
            CompensatedLine::LeadOut => self.offsets.end(from, site),
        }
    }

    /// Refuses an arc while compensation is requested or about to end, and one that leaves its plane.
    pub(crate) fn check_arc(&self, arc: &Arc, site: &CutterSite<'_>) -> Result<(), Fault> {
        if self.state != Compensating::On {
            let when = if self.state == Compensating::Begins { "begins" } else { "ends" };
            let text = format!("compensation {when} with a straight feed motion in its plane, but an arc follows");
            return Err(plan::CUTTER_COMPENSATION.fault(text).help("give lines as lead-in and lead-out"));
        }
        let axis = arc.end.axis.into_inner();
        let perpendicular = axis.cross(&arc.normal).norm() <= SAME_AXIS;
        let rise = (arc.end.tip - arc.start.tip).dot(&axis).abs();
        if !perpendicular || rise > 0.5 * site.placer.unit_mm() {
            return Err(in_force_fault("an arc leaves its plane"));
        }
        Ok(())
    }

    /// An arc, or a piece of one, is being written from where the tool is.
    pub(crate) fn arc_piece(&mut self, circle: &Circle, to: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
        if self.is_idle() { Ok(()) } else { self.offsets.arc_piece(circle, to, site) }
    }

    /// An arc has been written from a position.
    pub(crate) fn after_arc(
        &mut self,
        written: WrittenArc,
        from: &AxisPosition,
        site: &CutterSite<'_>,
    ) -> Result<(), Fault> {
        if written == WrittenArc::Chords {
            return Err(in_force_fault("an arc follows that is written as chords"));
        }
        check_at_rest(from, site)?;
        match written {
            WrittenArc::Chord if site.here.words != from.words => self.offsets.line(from, site),
            _ => Ok(()),
        }
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
            self.last.ok_or_else(|| plan::CUTTER_COMPENSATION.fault("CUTCOM/ON without a side"))?
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
            Compensating::Begins => Err(plan::CUTTER_COMPENSATION
                .fault("CUTCOM requests compensation, but no straight feed motion in the plane follows")
                .help("remove CUTCOM, or give it before the lead-in")),
            Compensating::On | Compensating::Ends => Err(in_force_fault("the program ends")),
        }
    }
}

/// Fault: `what` comes while compensation is in force.
fn in_force_fault(what: &str) -> Fault {
    plan::CUTTER_COMPENSATION
        .fault(format_args!("cutter compensation (CUTCOM) is still active: {what}"))
        .help("program CUTCOM/OFF and a straight feed motion in the plane before this")
}

/// Fault: cutter compensation under tip control.
#[cold]
fn under_tip_control() -> Fault {
    plan::CUTTER_COMPENSATION
        .fault("cutter compensation in the plane is not possible under tip control")
        .help("post this program with mode axes or plane, or remove CUTCOM")
}

/// Refuses a rotation between a position and where the tool is.
fn check_at_rest(from: &AxisPosition, site: &CutterSite<'_>) -> Result<(), Fault> {
    match site.placer.rotates(&from.words, &site.here.words) {
        true => Err(in_force_fault("a rotary axis rotates")),
        false => Ok(()),
    }
}

/// Refuses CUTCOM where configuration, mode or plane do not allow it.
fn check_set_up(policy: Policy<'_>, xy: bool) -> Result<(), Fault> {
    if policy.options.compensation.is_none() {
        return Err(plan::CUTTER_COMPENSATION
            .fault("CUTCOM requests cutter compensation by the control, but `compensation.path` is not set")
            .help(
                "configure the value of D: `[compensation] path = \"centre\"` (D holds the wear) or `\"contour\"` (D \
                 holds the radius); or output CL data without CUTCOM",
            ));
    }
    if policy.options.mode_of_all() == Some(StretchMode::Tcp) {
        return Err(under_tip_control());
    }
    if !xy {
        return Err(plan::CUTTER_COMPENSATION
            .fault("cutter compensation is possible in the plane of X and Y only")
            .help("remove CUTCOM, and output the path of the tool centre in CAM"));
    }
    Ok(())
}

impl CutterSite<'_> {
    /// A motion in program coordinates, mm; refused where the tool axis is not Z of the program.
    fn in_program(&self, motion: &Move) -> Result<Vector3<f64>, Fault> {
        let in_plane = self.placer.mode() == StretchMode::Plane;
        let tilted = || {
            plan::CUTTER_COMPENSATION
                .fault(
                    "cutter compensation works in the plane of X and Y, but the tool axis is not Z of the program here",
                )
                .help(match in_plane {
                    // The rotary axes are off the tool axis, as those with steps are.
                    true => "move the tool axis of the operation to a step in CAM",
                    false => "post this program with mode plane, or remove CUTCOM",
                })
        };
        let (_, map) = self.placer.orthogonal_map(self.here).ok_or_else(tilted)?;
        let along = map * motion.pose.axis.into_inner();
        if along.z < 0.0 || math::hypot(along.x, along.y) > SAME_AXIS + self.plane_lean_rad() {
            return Err(tilted());
        }
        Ok(map * (motion.pose.tip - self.here.pose.tip))
    }

    /// Largest angle between the tool axis and Z of a plane by the rounding of its three angles, or of the rotary words
    /// where its zero follows the table.
    fn plane_lean_rad(&self) -> f64 {
        let decimals = match self.placer.mode() {
            StretchMode::Axes | StretchMode::Tcp => None,
            StretchMode::Plane if self.moves_zero => Some(self.policy.formats.rotary),
            StretchMode::Plane => self.abilities.plane.map(|plane| plane.decimals),
        };
        decimals.map_or(0.0, |decimals| 1.5 * 10_f64.powi(-decimals.cast_signed()).to_radians())
    }

    /// Refuses the path of the tool centre where the control would offset it by the whole radius.
    fn check_radius(&self) -> Result<(), Fault> {
        if self.policy.options.compensation != Some(CutterPath::Centre) {
            return Ok(());
        }
        match self.abilities.cutter_radius {
            CutterRadius::Register | CutterRadius::OfTool { guarded: true } => Ok(()),
            CutterRadius::WithDelta { written: true } => match self.tooling.current() {
                Some(tool) if tool.radius_mm.is_none() => Err(plan::CUTTER_COMPENSATION.fault(format_args!(
                    "CUTCOM on the path of the tool centre: the radius of T{} is unknown, which the tool call must take off (DR)",
                    tool.number
                ))
                .help(format_args!("give `[tools.{}] diameter`, or CUTTER in the CL data", tool.number))),
                _ => Ok(()),
            },
            CutterRadius::WithDelta { written: false } => Err(plan::CUTTER_COMPENSATION.fault(
                "CUTCOM on the path of the tool centre: the tool call must take the radius of the tool off (DR)",
            )
            .help("add `DR{radius_delta}` to the tool call in `control.tool_change`")),
            CutterRadius::OfTool { guarded: false } => Err(plan::CUTTER_COMPENSATION.fault(
                "CUTCOM on the path of the tool centre: this control would offset it by the whole radius of the tool",
            )
            .help("output the contour in CAM, and set `[compensation] path = \"contour\"`")),
        }
    }

    /// Register of the radius of the tool. `programmed`: that of the CL data.
    fn radius_register(&self, programmed: Option<u32>) -> Result<u32, Fault> {
        let Some(tool) = self.tooling.current() else {
            return Err(plan::CUTTER_COMPENSATION.fault("CUTCOM before the first tool call"));
        };
        let number = tool.number;
        let given = self.policy.set_up.tools.get(&number).and_then(|tool| tool.radius_offset).or(programmed);
        if let Some(given) =
            given.filter(|given| *given != number && self.abilities.cutter_radius != CutterRadius::Register)
        {
            return Err(plan::CUTTER_COMPENSATION
                .fault(format_args!(
                    "T{number} is given radius register {given}, but this control takes the radius of the tool itself"
                ))
                .help(format_args!("remove the register from CUTCOM and `[tools.{number}] radius_offset`")));
        }
        Ok(given.unwrap_or(number))
    }

    /// Delta of the radius in a tool call: takes the radius off where the path is that of the tool centre, and the
    /// control takes the radius of the tool itself.
    pub(crate) fn radius_delta(&self, tool: &LoadedTool) -> Result<Option<f64>, Fault> {
        let delta = self.abilities.cutter_radius == CutterRadius::WithDelta { written: true };
        let Some(radius_mm) = tool.radius_mm.filter(|_| delta && self.offsets_centre(tool)) else { return Ok(None) };
        let units = self.placer.units();
        if radius_mm > LARGEST_DELTA {
            return Err(plan::CUTTER_COMPENSATION
                .fault(format_args!(
                    "the radius of T{} is {}, and the delta in the tool call is {} at most",
                    tool.number,
                    units.length(radius_mm),
                    units.length(LARGEST_DELTA)
                ))
                .help("output the contour in CAM, and set `[compensation] path = \"contour\"`"));
        }
        Ok(Some(-radius_mm))
    }

    /// The guard of the tool radius, where the program needs it and the control has it.
    pub(crate) fn guard(&self, tool: &LoadedTool) -> Option<Step<'static>> {
        let guards = self.abilities.cutter_radius == (CutterRadius::OfTool { guarded: true });
        let wear = self.policy.options.largest_wear_mm;
        (guards && self.offsets_centre(tool)).then_some(Step::RadiusGuard { tool: tool.number, wear })
    }

    /// Whether a tool may be compensated on the path of its centre.
    fn offsets_centre(&self, tool: &LoadedTool) -> bool {
        self.policy.options.compensation == Some(CutterPath::Centre) && self.tooling.may_be_compensated(tool.number)
    }
}

#[cfg(test)]
mod tests;
