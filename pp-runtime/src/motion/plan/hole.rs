//! Holes, written as a cycle of the control where it moves the tool in the same way, else as single motions.
//!
//! In both forms the tool moves over the hole at its present level or at the clearance level, whichever is higher,
//! comes down along its axis, and ends at the return level of the CL data. A cycle is used where its line along Z of
//! the program stays within the tolerance of the axis of the hole and the control has a cycle with just these steps. A
//! hole that differs from all cycles (a first step unlike the others, a programmed retract between steps, several
//! plates) is written as motions. A thread never is: only a cycle synchronises spindle and feed.

use crate::diag::code::plan;
use crate::kinematics::{Pose, math};
use crate::nc::Decimal;
use crate::options::{CycleOutput, StretchMode, ThreadFeed};
use crate::program::{Drilling, Feed as Programmed, Hole, Move, Rotation, Shown, Units};

use crate::motion::fault::{Fault, Planned};
use crate::motion::place::AxisPosition;
use crate::motion::plan::feed::{FeedMotion, MOST_DECIMALS, decimals_within, feed_key};
use crate::motion::plan::{MotionAndNext, Planner, records};
use crate::motion::source::{Begins, MotionIndex, Next};
use crate::motion::step::BlockReason;
use crate::motion::step::{AxisWords, FeedWord, Sink, Step};
use crate::motion::step::{CannedCycle, CannedKind, UnusedCycles};
use crate::nalgebra::Vector3;
use crate::tolerance::writer::{
    LEAN_BY_ROUNDING, MOST_HOLE_STEPS, NO_ORIENT_ANGLE_DEG, NO_PITCH_ERROR, PITCH_ERROR, SAME_BORE_SHIFT, SAME_LEVEL,
};

/// Decimals of the angle at which the spindle stops.
const ORIENT_DECIMALS: u32 = 3;

/// Reason why a hole is not written as a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
enum NoCycle {
    /// `[cycles] output` is "expanded".
    Expanded,
    DryRun,
    TipControl,
    /// The words of the program do not keep angles and lengths.
    NotOrthogonal,
    /// Z of the program leads off the axis of the hole by so much, mm. `rounded`: by the rounding of angles.
    Leans {
        off_mm: f64,
        rounded: bool,
    },
    LevelsNotInOrder,
    LongDwell,
    NoTappingCycle,
    NoTappingDwell,
    NoBoringCycle,
    /// The control has one, and it is not used.
    Unused(UnusedCycles),
    /// The direction off the wall of a bore is that of a machine axis.
    NotMachineAxes,
    /// The control has no cycle with these steps.
    OtherSteps,
    /// The gap that is set in the control is as long as a step.
    GapOfControl,
}

impl NoCycle {
    /// The reason in words.
    fn text(self) -> String {
        match self {
            Self::Expanded => "`[cycles] output` is \"expanded\"".to_owned(),
            Self::DryRun => "a dry run writes no cycles".to_owned(),
            Self::TipControl => "there are no cycles under tip control".to_owned(),
            Self::NotOrthogonal => "the coordinates of the program are not orthogonal here".to_owned(),
            Self::Leans { off_mm, .. } => format!(
                "Z of the program leads off the axis of this hole, by {off_mm:.3} mm over its levels or on the way to it, more than `tolerance`"
            ),
            Self::LevelsNotInOrder => "the levels of the hole are not in order".to_owned(),
            Self::LongDwell => "the dwell is too long for the cycle".to_owned(),
            Self::NoTappingCycle => "this control has no tapping cycle here".to_owned(),
            Self::NoTappingDwell => "the tapping cycle of this control has no dwell at the bottom".to_owned(),
            Self::NoBoringCycle => "this control has no such cycle".to_owned(),
            Self::Unused(UnusedCycles::OtherSpindle) => {
                "it runs the master spindle, and `control.mill_turn` gives the tool another one".to_owned()
            }
            Self::Unused(UnusedCycles::AxisNames) => {
                "its words are X, Y and Z, and `control.axes` gives one of them another name".to_owned()
            }
            Self::NotMachineAxes => {
                "the direction off the wall is that of a machine axis: it needs `mode = \"axes\"` for all of its operation"
                    .to_owned()
            }
            Self::OtherSteps => "no cycle of this control moves the tool in the same way".to_owned(),
            Self::GapOfControl => "the gap in `control.states` is as long as a step".to_owned(),
        }
    }

    /// How a thread or a bore is posted with a cycle all the same.
    fn help(self) -> &'static str {
        match self {
            Self::Expanded => "set `output = \"native\"` in `[cycles]`",
            Self::DryRun => "leave the operation out of the dry run: `--ops`",
            Self::TipControl => {
                "post the operation with `mode = \"plane\"`, or \"axes\" where the tool is along Z of the machine"
            }
            Self::NotOrthogonal | Self::Leans { rounded: false, .. } => {
                "post the operation with `mode = \"plane\"`, if the control has planes"
            }
            Self::Leans { rounded: true, .. } => "the angles are rounded: give `formats.rotary` more decimals",
            Self::LevelsNotInOrder => "correct depth, clearance and return of the CYCLE in CAM",
            Self::NoBoringCycle => {
                "to retract at feed, write BORE without ORIENT and its angle; else program it at the control"
            }
            Self::Unused(UnusedCycles::OtherSpindle) => {
                "where the tool is in the master spindle set `spindle = \"master\"`; else program it at the control"
            }
            Self::Unused(UnusedCycles::AxisNames) => "rename no linear axis; else program it at the control",
            Self::NotMachineAxes => "post the operation with `mode = \"axes\"`",
            Self::LongDwell | Self::NoTappingDwell => "remove the dwell from the CYCLE in CAM",
            Self::NoTappingCycle | Self::OtherSteps | Self::GapOfControl => {
                "mill the thread, or post it for a control with a tapping cycle"
            }
        }
    }
}

/// Boxes that the tip fills above a hole and in it, each as its lowest and its highest corner, mm.
pub(crate) fn hole_extent(hole: &Hole) -> [[[f64; 3]; 2]; 2] {
    let between = |low: f64, high: f64| {
        let (a, b) = (hole.level(low).tip, hole.level(high).tip);
        [a.inf(&b).into(), a.sup(&b).into()]
    };
    [between(hole.clearance_mm, hole.return_mm), between(-hole.depth_mm, 0.0)]
}

/// Depths at which the steps of a hole end, in order, mm.
fn steps(hole: &Hole, units: Units) -> Result<impl Iterator<Item = f64>, Fault> {
    let (first, later) = match hole.drilling {
        Drilling::Peck { first_mm: first, later_mm: later } => (first, later),
        Drilling::ChipBreak { step_mm: step, .. } => (step, step),
        Drilling::Drill
        | Drilling::Ream
        | Drilling::FineBore { .. }
        | Drilling::Through { .. }
        | Drilling::Tap { .. } => (hole.depth_mm, hole.depth_mm),
    };
    if (hole.depth_mm - first) / later > f64::from(MOST_HOLE_STEPS - 1) {
        let text = format!(
            "a hole {} deep in steps of {} takes more than {MOST_HOLE_STEPS} steps",
            units.length(hole.depth_mm),
            units.length(later)
        );
        return Err(plan::HOLE.fault(text).help("check the step of the cycle and its unit"));
    }
    let depth = hole.depth_mm;
    // A last step of nothing but rounding is part of the step before it.
    let reached = move |done: f64| if done > depth - SAME_LEVEL { depth } else { done };
    Ok(std::iter::successors(Some(reached(first)), move |done| (*done < depth).then(|| reached(done + later))))
}

/// Plans a hole from the present position of the tool.
#[cold]
pub(crate) fn hole<S: Sink>(planner: &mut Planner<'_, S>, hole: &Hole, index: MotionIndex) -> Planned {
    planner.cutter.check_hole()?;
    HoleRun { planner, hole }.run(index)
}

/// One hole that is being planned.
struct HoleRun<'p, 'a, S> {
    planner: &'p mut Planner<'a, S>,
    hole: &'p Hole,
}

impl<S: Sink> HoleRun<'_, '_, S> {
    fn run(&mut self, index: MotionIndex) -> Planned {
        let over = self.hole.rapid_to_clearance();
        let bottom = Move { pose: self.hole.level(-self.hole.depth_mm), rapid: false, feed: self.hole.feed };
        let above = Some(self.hole.level(self.approach_level()));
        let ahead = MotionAndNext { motion: &over, next: &Next::Motion(bottom.pose), above };
        if index.begins == Begins::Nothing {
            self.reach(ahead, index)?;
        } else {
            let tooling = &self.planner.tooling;
            if tooling.current().is_none() && tooling.next().is_none() {
                self.planner.check_state(&bottom)?;
            }
            self.planner.begin(ahead, index)?;
            if self.planner.selection.is_over() {
                return Ok(());
            }
        }
        self.planner.mover.output_mut().set_reason(BlockReason::Hole);
        self.planner.check_state(&bottom)?;
        match self.cycle()? {
            Ok((cycle, place)) => self.run_cycle(&cycle, &place),
            Err(why) if matches!(self.hole.drilling, Drilling::Tap { .. }) => {
                let text = format!(
                    "tapping synchronises spindle and feed, which only a cycle of the control does: {}",
                    why.text()
                );
                Err(plan::HOLE.fault(text).help(why.help()).into())
            }
            Err(why) if matches!(self.hole.drilling, Drilling::FineBore { .. }) => {
                let text = format!("only a cycle of the control bores with an oriented spindle: {}", why.text());
                Err(plan::HOLE.fault(text).help(why.help()).into())
            }
            Err(_) => self.run_by_motions(),
        }
    }

    /// Level at which the safe sequence ends, mm above the top: the return level, and not below the approach distance.
    fn approach_level(&self) -> f64 {
        let hole = self.hole;
        hole.return_mm.max(hole.clearance_mm + self.planner.policy.options.approach.distance_mm)
    }

    /// Rotates the rotary axes for the hole, or leads the tool round the clearance geometry; one below the clearance
    /// level is lifted to it.
    fn reach(&mut self, ahead: MotionAndNext<'_>, index: MotionIndex) -> Planned {
        let over = ahead.motion;
        self.planner.stop_spindle()?;
        self.planner.check_state(over)?;
        self.planner.reach_stretch(over, index)?;
        let planned = self.planner.apply_course_changes(over, index)?;
        let place = self.planner.mover.place(&over.pose, false, planned)?;
        let strays = self.planner.may_enter_clearance(&place);
        if self.planner.mover.rotates(&place) || self.planner.modes.changes() || strays {
            return self.planner.go(ahead, planned);
        }
        let lift = self.hole.clearance_mm - self.height();
        if lift > SAME_LEVEL {
            let tip = self.planner.mover.position().pose().tip + self.hole.top.axis.into_inner() * lift;
            self.go(&Move { pose: Pose { tip, ..over.pose }, ..*over })?;
        }
        Ok(())
    }

    /// Height of the tool above the top of the hole, mm.
    fn height(&self) -> f64 {
        (self.planner.mover.position().pose().tip - self.hole.top.tip).dot(&self.hole.top.axis)
    }

    /// A motion along the hole, without rotation.
    fn go(&mut self, motion: &Move) -> Planned {
        self.planner.go(MotionAndNext::new(motion, &Next::None), None)
    }

    /// A rapid to a level of the hole.
    fn rapid_to(&mut self, height: f64) -> Planned {
        self.go(&Move { pose: self.hole.level(height), rapid: true, feed: self.hole.feed })
    }

    /// A feed motion to a level of the hole.
    fn feed_to(&mut self, height: f64) -> Planned {
        self.go(&Move { pose: self.hole.level(height), rapid: false, feed: self.hole.feed })
    }

    /// Whether the cycle of the hole is a motion from over the hole.
    fn is_motion(&self) -> bool {
        matches!(self.hole.drilling, Drilling::Tap { .. }) && self.planner.abilities.cycles.tap_is_motion
    }

    /// Leads the tool over the hole, at its height above the top, and to the clearance level.
    fn lead_over(&mut self) -> Planned {
        self.rapid_to(self.height().max(self.hole.clearance_mm))?;
        self.rapid_to(self.hole.clearance_mm)
    }

    /// Writes the hole as single motions.
    fn run_by_motions(&mut self) -> Planned {
        let hole = self.hole;
        self.lead_over()?;
        if let Drilling::Through { gaps } = hole.drilling {
            for gap in gaps.iter() {
                self.feed_to(-gap.feed_ends_mm)?;
                self.rapid_to(-gap.feed_begins_mm)?;
            }
        }
        let mut before: Option<f64> = None;
        for done in steps(hole, self.planner.mover.placer().units())? {
            if let Some(before) = before {
                if matches!(hole.drilling, Drilling::Peck { .. }) {
                    self.rapid_to(hole.clearance_mm)?;
                }
                let back = match hole.drilling {
                    Drilling::ChipBreak { retract_mm: Some(back), .. } => back,
                    Drilling::ChipBreak { retract_mm: None, .. }
                    | Drilling::Peck { .. }
                    | Drilling::Drill
                    | Drilling::Ream
                    | Drilling::FineBore { .. }
                    | Drilling::Through { .. }
                    | Drilling::Tap { .. } => self.planner.policy.options.defaults.peck_gap_mm,
                };
                self.rapid_to((back - before).min(hole.clearance_mm))?;
            }
            self.feed_to(-done)?;
            before = Some(done);
        }
        if let Some(dwell) = hole.dwell {
            records::delay(self.planner, dwell)?;
        }
        if hole.drilling == Drilling::Ream {
            self.feed_to(hole.clearance_mm)?;
        }
        self.rapid_to(hole.return_mm)
    }

    /// The cycle of the hole and the place at its end, or the reason why there is none.
    fn cycle(&mut self) -> Result<Result<(CannedCycle, AxisPosition), NoCycle>, Fault> {
        let (hole, policy) = (self.hole, self.planner.policy);
        if policy.options.cycles.output == CycleOutput::Expanded {
            return Ok(Err(NoCycle::Expanded));
        }
        if policy.options.lift_mm.is_some() {
            return Ok(Err(NoCycle::DryRun));
        }
        if self.planner.mover.placer().mode() == StretchMode::Tcp {
            return Ok(Err(NoCycle::TipControl));
        }
        let (here, placer) = (self.planner.mover.here(), self.planner.mover.placer());
        let Some((chain, map)) = placer.orthogonal_map(here) else {
            return Ok(Err(NoCycle::NotOrthogonal));
        };
        let along = map * hole.top.axis.into_inner();
        let leans = math::hypot(along.x, along.y);
        let off_mm = leans * (hole.depth_mm + hole.clearance_mm).max(hole.return_mm - hole.clearance_mm);
        // The words show no less.
        let allowed = self.planner.mover.tolerance().tip_mm.max(0.5 * placer.unit_mm());
        if along.z < 0.0 || off_mm > allowed {
            let rounded = along.z > 0.0 && leans <= LEAN_BY_ROUNDING * placer.scale().angle(1);
            return Ok(Err(NoCycle::Leans { off_mm, rounded }));
        }
        let kind = match self.kind()? {
            Ok(kind) => kind,
            Err(why) => return Ok(Err(why)),
        };
        let mut place = *self.planner.mover.here();
        self.planner.mover.shift(&mut place, hole.level(hole.clearance_mm).tip)?;
        let (over, [x, y, z]) = (place, chain);
        // A cycle leads the tool over the hole at the level at which it is.
        let below_mm =
            (over.words[z] - self.planner.mover.here().words[z]) as f64 * self.planner.mover.placer().unit_mm();
        if below_mm > allowed && !self.is_motion() {
            return Ok(Err(NoCycle::Leans { off_mm: below_mm, rounded: false }));
        }
        let words =
            AxisWords { units: self.planner.mover.placer().written(&over), mask: 1 << x | 1 << y, vector: None };
        let bottom = self.shift_to_level(&mut place, -hole.depth_mm, z)?;
        let surface = self.shift_to_level(&mut place, 0.0, z)?;
        self.shift_to_end(&mut place, &over, map.row(2).transpose(), z)?;
        let dwell = hole.dwell.map(|dwell| self.planner.spindle.seconds(dwell)).transpose()?;
        let feed = self.feed(kind, &over)?;
        let (clearance, back) = (words.units[z], self.planner.mover.placer().written(&place)[z]);
        let cycle = CannedCycle { kind, words, z, surface, clearance, bottom, back, dwell, feed };
        Ok(self.mismatch(&cycle)?.map_or(Ok((cycle, place)), Err))
    }

    /// Moves a place to a level of the hole, and returns its word along Z.
    fn shift_to_level(&mut self, place: &mut AxisPosition, height: f64, z: usize) -> Result<i64, Fault> {
        let mover = &mut self.planner.mover;
        mover.shift(place, self.hole.level(height).tip)?;
        Ok(mover.placer().written(place)[z])
    }

    /// Moves a place to the end of the cycle, which keeps the X and Y of its position `over` the hole: it returns along
    /// Z of the program, as far as the words of the return level lead. `along`: direction of Z.
    fn shift_to_end(
        &mut self,
        place: &mut AxisPosition,
        over: &AxisPosition,
        along: Vector3<f64>,
        z: usize,
    ) -> Result<(), Fault> {
        let hole = self.hole;
        if hole.return_mm.to_bits() == hole.clearance_mm.to_bits() {
            // Its words are those over the hole, whose tip is not rounded again.
            *place = AxisPosition { rounding_mm: 0.0, ..*over };
            return Ok(());
        }
        self.shift_to_level(place, hole.return_mm, z)?;
        let pose = place.pose;
        let mover = &mut self.planner.mover;
        let lift = along * ((place.words[z] - over.words[z]) as f64 * mover.placer().unit_mm());
        let tip = mover.placer().machine().forward_kinematics(&over.axes).tip + lift;
        mover.shift(place, tip)?;
        place.pose = pose;
        Ok(())
    }

    /// Difference between a cycle as the control executes it and the hole.
    fn mismatch(&self, cycle: &CannedCycle) -> Result<Option<NoCycle>, Fault> {
        let can = self.planner.abilities.cycles;
        if !(cycle.bottom < cycle.surface && cycle.surface <= cycle.clearance && cycle.clearance <= cycle.back) {
            return Ok(Some(NoCycle::LevelsNotInOrder));
        }
        if cycle.dwell.is_some_and(|seconds| seconds * 1e3 > f64::from(can.longest_dwell_ms)) {
            return Ok(Some(NoCycle::LongDwell));
        }
        if let CannedKind::Peck { step, gap } | CannedKind::ChipBreak { step, gap } = cycle.kind
            && can.programs_gap
        {
            let depth = cycle.surface - cycle.bottom;
            let as_many =
                steps(self.hole, self.planner.mover.placer().units())?.count() as i64 == (depth + step - 1) / step;
            let in_hole = gap > 0 && gap <= step + cycle.clearance - cycle.surface;
            return Ok((!(as_many && in_hole)).then_some(NoCycle::OtherSteps));
        }
        let [peck_mm, chip_break_mm] = self.planner.abilities.cycle_gaps_mm;
        let (step, set_mm) = match cycle.kind {
            CannedKind::Peck { step, .. } => (step, peck_mm),
            CannedKind::ChipBreak { step, .. } => (step, chip_break_mm),
            CannedKind::Drill | CannedKind::Ream | CannedKind::FineBore { .. } | CannedKind::Tap { .. } => (0, None),
        };
        let step_mm = step as f64 * self.planner.mover.placer().unit_mm();
        if set_mm.is_some_and(|gap| gap >= step_mm) {
            return Ok(Some(NoCycle::GapOfControl));
        }
        Ok(None)
    }

    /// Kind of the cycle for the hole, or the reason why the control has none that moves the tool in the same way.
    fn kind(&self) -> Result<Result<CannedKind, NoCycle>, Fault> {
        let (hole, can) = (self.hole, self.planner.abilities.cycles);
        let higher = hole.return_mm - hole.clearance_mm > SAME_LEVEL;
        let units = |mm: f64| (mm / self.planner.mover.placer().unit_mm()).round() as i64;
        let no_dwell = hole.dwell.is_none();
        let steps_wait = no_dwell || can.peck_dwell;
        let usual_gap = self.planner.policy.options.defaults.peck_gap_mm;
        Ok(match hole.drilling {
            Drilling::Drill if can.drill => Ok(CannedKind::Drill),
            Drilling::Ream if can.ream && (can.ream_higher || !higher) => Ok(CannedKind::Ream),
            Drilling::Peck { first_mm: first, later_mm: later }
                if can.peck && steps_wait && units(first) == units(later) && units(later) > 0 =>
            {
                Ok(CannedKind::Peck { step: units(later), gap: units(usual_gap) })
            }
            Drilling::ChipBreak { step_mm: step, retract_mm: back }
                if can.chip_break && steps_wait && units(step) > 0 && (can.programs_gap || back.is_none()) =>
            {
                Ok(CannedKind::ChipBreak { step: units(step), gap: units(back.unwrap_or(usual_gap)) })
            }
            Drilling::Tap { .. } if !can.tap => Err(can.unused.map_or(NoCycle::NoTappingCycle, NoCycle::Unused)),
            Drilling::Tap { .. } if !no_dwell && !can.tap_dwell => Err(NoCycle::NoTappingDwell),
            Drilling::Tap { .. } => Ok(self.thread()?),
            Drilling::FineBore { orient_rad } => self.fine_bore(orient_rad)?,
            // No control feeds and moves at rapid in turn on the way down.
            Drilling::Through { .. } => Err(NoCycle::OtherSteps),
            Drilling::Drill | Drilling::Ream | Drilling::Peck { .. } | Drilling::ChipBreak { .. } => {
                Err(NoCycle::OtherSteps)
            }
        })
    }

    /// Boring with the spindle stopped at an angle, or the reason why there is no cycle for it.
    fn fine_bore(&self, orient_rad: f64) -> Result<Result<CannedKind, NoCycle>, Fault> {
        let options = &self.planner.policy.options.cycles;
        let Some(can) = self.planner.abilities.cycles.fine_bore else {
            let unused = self.planner.abilities.cycles.unused;
            return Ok(Err(unused.map_or(NoCycle::NoBoringCycle, NoCycle::Unused)));
        };
        if self.planner.mover.placer().mode() != StretchMode::Axes {
            return Ok(Err(NoCycle::NotMachineAxes));
        }
        let Some(direction) = options.bore_retract else {
            return Err(plan::HOLE.fault("the direction in which the tool leaves the wall of this bore is unknown").help(
                "set `cycles.bore_retract` to the direction away from the cutting edge where the spindle has stopped: \
                 \"+X\", \"-X\", \"+Y\" or \"-Y\"",
            ));
        };
        let Some((_, rotation)) = self.planner.spindle.running() else {
            return Err(plan::HOLE.fault("boring with the spindle off"));
        };
        let degrees = orient_rad.to_degrees();
        if !can.states_angle && degrees.abs() > NO_ORIENT_ANGLE_DEG {
            let text = format!(
                "the machine stops the spindle at its own angle, and the CL data asks for {} degrees",
                Shown(degrees)
            );
            return Err(plan::HOLE.fault(text).help("write ORIENT,0 and mount the tool for the angle of the machine"));
        }
        let shift_mm = options.bore_shift_mm;
        if let Some(fixed) = can.fixed_shift_um.map(|shift| f64::from(shift) * 1e-3)
            && (fixed - shift_mm).abs() > SAME_BORE_SHIFT
        {
            let text = format!(
                "this control moves the tool off the wall by {}, not by {}",
                self.planner.mover.placer().units().length(fixed),
                self.planner.mover.placer().units().length(shift_mm)
            );
            return Err(plan::HOLE.fault(text).help("leave `cycles.bore_shift` out"));
        }
        let shift = (shift_mm / self.planner.mover.placer().unit_mm()).round() as i64;
        let orient = Decimal::fixed(degrees, ORIENT_DECIMALS)
            .map_err(|_| plan::HOLE.fault("the angle at which the spindle stops is too large for a word"))?;
        Ok(Ok(CannedKind::FineBore { direction, shift, orient, left: rotation == Rotation::CounterClockwise }))
    }

    /// Pitch of the thread, mm: that of the CL data, with the speed that it has there and not with the rounded one.
    fn pitch_mm(&self) -> Result<f64, Fault> {
        let programmed = match (self.hole.drilling, self.hole.feed) {
            (Drilling::Tap { pitch_mm: Some(pitch) }, _) | (_, Some(Programmed::PerRevolution(pitch))) => Some(pitch),
            (_, Some(Programmed::PerMinute(feed))) => self.planner.spindle.exact_speed().map(|exact| feed / exact),
            (_, None) => None,
        };
        programmed.filter(|pitch| *pitch > 0.0).ok_or_else(|| plan::HOLE.fault("the pitch of this thread is unknown"))
    }

    /// The tapping cycle at the spindle speed as written.
    fn thread(&self) -> Result<CannedKind, Fault> {
        let Some((rev_per_min, rotation)) = self.planner.spindle.running() else {
            return Err(plan::HOLE.fault("tapping with the spindle off"));
        };
        let too_large = |_| plan::HOLE.fault("the pitch or the spindle speed of this thread is too large for a word");
        let (units, formats) = (self.planner.mover.placer().units(), self.planner.policy.formats);
        let pitch = Decimal::fixed(self.pitch_mm()? / units.in_mm(), formats.pitch_decimals(units));
        Ok(CannedKind::Tap {
            pitch: pitch.map_err(too_large)?,
            left: rotation == Rotation::CounterClockwise,
            speed: Decimal::fixed(rev_per_min, formats.speed).map_err(too_large)?,
        })
    }

    /// F of a cycle.
    fn feed(&self, kind: CannedKind, over: &AxisPosition) -> Result<Decimal, Fault> {
        let (hole, feeds) = (self.hole, self.planner.mover.feeds());
        let per_minute = match kind {
            CannedKind::Tap { speed, .. } => self.planner.thread_feed(self.pitch_mm()? * speed.value())?,
            CannedKind::Drill
            | CannedKind::Peck { .. }
            | CannedKind::ChipBreak { .. }
            | CannedKind::Ream
            | CannedKind::FineBore { .. } => {
                let feed = hole.feed.ok_or_else(|| plan::HOLE.fault("a hole without feed"))?;
                self.planner.rate(Some(feed))?
            }
        };
        let length = hole.clearance_mm + hole.depth_mm;
        let axis = hole.top.axis.into_inner();
        let along = |direction: Vector3<f64>| length * axis.dot(&direction).abs();
        let axis_time_min = self.planner.mover.placer().least_minutes_of_tip(over, along);
        let motion = FeedMotion::linear(length, axis_time_min);
        let pace = feeds.pace(per_minute, motion)?;
        let FeedWord::PerMinute(word) = pace.feed else {
            return Err(plan::HOLE.fault("a cycle cannot have a feed in inverse time"));
        };
        if let CannedKind::Tap { pitch, speed, .. } = kind {
            if pace.slowed_min > 0.0 {
                let text = format!(
                    "this thread needs a feed of {}, which an axis cannot reach, or which `[feed] largest` or \
                     `shortest_block` slows down",
                    feeds.units().feed(per_minute)
                );
                return Err(plan::HOLE.fault(text).help("lower the spindle speed of the thread"));
            }
            self.check_pitch(self.written_pitch_mm(pitch, speed, word), speed)?;
        }
        Ok(word)
    }

    /// Pitch that the control makes of the words, mm: that of its word, else that of F and S.
    fn written_pitch_mm(&self, pitch: Decimal, speed: Decimal, feed: Decimal) -> f64 {
        let feeds = self.planner.mover.feeds();
        if self.is_pitch_from_feed() {
            feeds.mm_per_minute(feed) / speed.value()
        } else {
            pitch.value() * feeds.units().in_mm()
        }
    }

    /// Whether the control derives the pitch from F per minute and S.
    fn is_pitch_from_feed(&self) -> bool {
        self.planner.abilities.cycles.tap_uses_feed
            && self.planner.policy.options.cycles.thread_feed == ThreadFeed::PerMinute
    }

    /// Error of a pitch over the length of the thread, mm.
    fn pitch_error_mm(&self, written_mm: f64) -> Result<f64, Fault> {
        let pitch_mm = self.pitch_mm()?;
        let error_mm = (written_mm - pitch_mm) * (self.hole.clearance_mm + self.hole.depth_mm) / pitch_mm;
        Ok(if error_mm.abs() > NO_PITCH_ERROR { error_mm } else { 0.0 })
    }

    /// Refuses a pitch that is rounded too much.
    fn check_pitch(&self, written_mm: f64, speed: Decimal) -> Result<(), Fault> {
        let pitch_mm = self.pitch_mm()?;
        let error_mm = self.pitch_error_mm(written_mm)?;
        if error_mm.abs() <= PITCH_ERROR * pitch_mm {
            return Ok(());
        }
        let units = self.planner.mover.placer().units();
        let length_mm = self.hole.clearance_mm + self.hole.depth_mm;
        let text = format!(
            "the pitch of this thread is {}, and that of its rounded words {}: over {} they differ by {}, more than 1 % of the \
             pitch",
            units.length(pitch_mm),
            units.length(written_mm),
            units.length(length_mm),
            units.deviation(error_mm.abs())
        );
        Err(plan::HOLE.fault(text).help(self.pitch_remedy(pitch_mm, PITCH_ERROR * pitch_mm / length_mm, speed)))
    }

    /// Settings with which a pitch is off by at most a share of it.
    fn pitch_remedy(&self, pitch_mm: f64, share: f64, speed: Decimal) -> String {
        let (feeds, formats) = (self.planner.mover.feeds(), self.planner.policy.formats);
        let needed = |units: Units| decimals_within(pitch_mm / units.in_mm(), share);
        let fits = |units: Units| needed(units).is_some_and(|decimals| decimals <= formats.pitch_decimals(units));
        let units = self.planner.mover.placer().units();
        if self.is_pitch_from_feed() {
            let decimals = feeds.decimals_within(pitch_mm * speed.value(), share).unwrap_or(MOST_DECIMALS);
            let key = feed_key(units);
            if self.planner.abilities.cycles.tap_per_revolution && fits(units) {
                return format!(
                    "set `thread_feed = \"revolution\"` in `[cycles]`: F is then the pitch; or give F more decimals: `{key} = {decimals}` in `[formats]`"
                );
            }
            return format!("give F more decimals: `{key} = {decimals}` in `[formats]`");
        }
        let (other, key) = match units {
            Units::Millimetres => (Units::Inches, "pitch_mm"),
            Units::Inches => (Units::Millimetres, "pitch_inch"),
        };
        let decimals = needed(units).unwrap_or(MOST_DECIMALS);
        if fits(other) {
            let name = other.name();
            return format!(
                "set `output_units = \"{name}\"`; or give the pitch more decimals, if the control takes them: `{key} = {decimals}` in `[formats]`"
            );
        }
        format!("give the pitch more decimals, if the control takes them: `{key} = {decimals}` in `[formats]`")
    }

    /// Writes the hole by its cycle.
    fn run_cycle(&mut self, cycle: &CannedCycle, back: &AxisPosition) -> Planned {
        let hole = self.hole;
        let can = self.planner.abilities.cycles;
        let began = self.planner.mover.placer().written(self.planner.mover.here())[cycle.z];
        let height = self.height().max(hole.clearance_mm);
        let thread = matches!(cycle.kind, CannedKind::Tap { .. });
        // Whether the spindle is off after it, where the cycle switches it on by itself.
        let bore = can.fine_bore.filter(|_| matches!(cycle.kind, CannedKind::FineBore { .. }));
        let bore_stops = bore.is_some_and(|bore| bore.stops_spindle);
        if !thread && !bore_stops {
            self.planner.restart_after_thread()?;
        }
        let pitch_error_mm = match cycle.kind {
            CannedKind::Tap { pitch, speed, .. } => {
                self.pitch_error_mm(self.written_pitch_mm(pitch, speed, cycle.feed))?
            }
            _ => 0.0,
        };
        self.planner.mover.watch_plunge(&hole.level(height), &hole.level(hole.clearance_mm));
        if self.is_motion() {
            self.lead_over()?;
        } else if cycle.back != cycle.clearance && began != cycle.back && !can.returns_to_any_level {
            // Such a cycle returns to the level at which it began.
            self.rapid_to(height)?;
            self.rapid_to(hole.return_mm)?;
        }
        let mover = &mut self.planner.mover;
        let minutes = (hole.clearance_mm + hole.depth_mm) / mover.feeds().mm_per_minute(cycle.feed);
        let both_ways = matches!(cycle.kind, CannedKind::Ream | CannedKind::Tap { .. });
        let output = mover.output_mut();
        output.cancel_inverse_time()?;
        output.times_mut().cut(if both_ways { 2.0 * minutes } else { minutes });
        output.times_mut().wait(cycle.dwell.unwrap_or(0.0) / 60.0);
        output.set_reason(BlockReason::Record);
        mover.write_motion(&Step::Cycle { cycle }, back)?;
        mover.output_mut().statistics_mut().cycles += 1;
        if let (CannedKind::Tap { pitch, left, .. }, Some(tool)) = (cycle.kind, self.planner.tooling.current()) {
            mover.output_mut().threads_mut().count(tool.number, pitch, left, pitch_error_mm);
        }
        if thread || bore_stops {
            self.planner.spindle.note_thread(bore_stops || can.tap_stops_spindle);
        }
        let bottom = hole.level(-hole.depth_mm);
        let position = mover.position_mut();
        position.note_cut(&bottom);
        position.forget_lead_out();
        position.follow(&bottom, &back.pose);
        mover.arrive(back);
        Ok(())
    }
}

#[cfg(test)]
mod tests;
