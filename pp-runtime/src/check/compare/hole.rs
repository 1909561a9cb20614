//! A cycle of the control, compared with the hole of the CL data as a whole: levels, kind, steps, feed and dwell.
//!
//! The retract out of the hole after each step is the control's own affair.

use super::super::expect::{ExpectedHole, SpindleState};
use super::super::geometry::{ToolPose, angle_between, tool_pose};
use super::super::read::{Block, CycleKind, CycleMove, FeedMode, FineBore, MAX_AXES};
use super::super::rules::{Rules, Stroke};
use crate::check::tolerances::{
    PITCH_ERROR, ROUNDED_CYCLE_LENGTH, ROUNDED_DWELL, ROUNDED_ORIENT_DEG, ROUNDED_PITCH, SAME_BORE_DIRECTION,
    SAME_LEVEL, SAME_NUMBER,
};
use crate::kinematics::math::hypot;
use crate::program::{Drilling, Dwell, Hole, Rotation, Shown, Units};

/// A cycle and the hole that it is to make.
pub(super) struct CycleComparison<'c> {
    pub(crate) rules: &'c Rules<'c>,
    pub(crate) block: &'c Block,
    pub(crate) cycle: &'c CycleMove,
    pub(crate) hole: &'c Hole,
    pub(crate) spindle: Option<SpindleState>,
    /// Largest distance of its line from the axis of the hole, besides the rounding of words, mm.
    pub(crate) tolerance_mm: f64,
}

/// A level of a cycle.
pub(super) struct Level {
    pub(crate) name: &'static str,
    /// Along the normal of the plane, as in the words of the program, mm.
    pub(crate) level_mm: f64,
    pub(crate) expected: ToolPose,
    /// Height above the clearance level, mm. There the words give the position of the hole; the line of the cycle leads
    /// off its axis by as much as it leans.
    pub(crate) above_mm: f64,
}

/// Words with the tool at a level of a cycle.
pub(super) fn words_at(rules: &Rules<'_>, block: &Block, level_mm: f64) -> Option<[f64; MAX_AXES]> {
    let normal = block.state.plane?.axes()[2];
    let mut values = block.values;
    values[rules.words().xyz()[normal]?] = level_mm;
    Some(values)
}

/// Tip and tool axis at a level of a cycle.
pub(super) fn pose_at(rules: &Rules<'_>, block: &Block, level_mm: f64) -> Option<ToolPose> {
    Some(rules.words().place(&words_at(rules, block, level_mm)?, &block.state))
}

/// Angle between the line that the words along the normal of the plane lead on, from one level of them to the other,
/// and the axis of a hole, rad.
pub(super) fn lean_of_words(rules: &Rules<'_>, block: &Block, levels_mm: [f64; 2], hole: &Hole) -> Option<f64> {
    let [low, high] = levels_mm.map(|level_mm| pose_at(rules, block, level_mm).map(|pose| pose.tip));
    let (line, axis) = (high? - low?, hole.top.axis.into_inner());
    Some(line.cross(&axis).norm().atan2(line.dot(&axis)))
}

/// Whether a hole is where a pose is, seen along its axis.
pub(super) fn is_over(rules: &Rules<'_>, pose: &ToolPose, expected: &ExpectedHole) -> bool {
    let hole = &expected.hole;
    let axis = hole.top.axis.into_inner();
    let step = pose.tip - hole.top.tip.coords;
    (step - axis * step.dot(&axis)).norm() <= rules.rounding().tip_mm
        && angle_between(&pose.axis, &axis) <= rules.rounding().axis_rad
}

impl CycleComparison<'_> {
    /// Unit of the program.
    fn units(&self) -> Units {
        self.block.state.units.unwrap_or_default()
    }

    fn pose(&self, height: f64) -> ToolPose {
        tool_pose(&self.hole.level(height))
    }

    /// Whether the cycle leaves the way up to a motion: a thread that only goes in and out.
    pub(super) fn stays_at_clearance(&self) -> bool {
        let tap = matches!(self.cycle.kind, CycleKind::Tap(_) | CycleKind::FloatingTap(_));
        if !tap || self.hole.return_mm - self.hole.clearance_mm <= SAME_LEVEL {
            return false;
        }
        let end = pose_at(self.rules, self.block, self.cycle.back_to);
        end.is_some_and(|end| self.rules.is_at(&end, &self.pose(self.hole.clearance_mm)))
    }

    /// Levels of the cycle, and the expected pose at its end. `stays`: it leaves the way up to a motion.
    pub(super) fn levels(&self, stays: bool) -> ([Level; 3], ToolPose) {
        let (cycle, hole) = (self.cycle, self.hole);
        let end = if stays { hole.clearance_mm } else { hole.return_mm };
        let level = |name, level_mm, height| Level {
            name,
            level_mm,
            expected: self.pose(height),
            above_mm: height - hole.clearance_mm,
        };
        let levels = [
            level("clearance point", cycle.reference, hole.clearance_mm),
            level("bottom", cycle.bottom, -hole.depth_mm),
            level("return point", cycle.back_to, end),
        ];
        (levels, self.pose(end))
    }

    /// Highest level to which the cycle retracts between its steps, as far as the settings of the control are known.
    pub(super) fn highest(&self) -> Option<f64> {
        let rises =
            matches!(self.cycle.kind, CycleKind::Peck(_)).then(|| self.rules.facts().step_states.peck_rise)??;
        Some(self.cycle.reference + self.rules.policy().shop.state_mm(rises)?)
    }

    /// A gap that the control has set itself, no shorter than a step.
    fn set_gap_fault(&self) -> Option<String> {
        let states = self.rules.facts().step_states;
        let (step, name) = match self.cycle.kind {
            CycleKind::Peck(step) => (step, states.peck_gap?),
            CycleKind::ChipBreak(step) => (step, states.chip_break_gap?),
            _ => return None,
        };
        let gap = self.rules.policy().shop.state_mm(name)?;
        (gap >= step).then(|| {
            let units = self.units();
            let (gap, step) = (units.length(gap), units.length(step));
            format!("{name} of the control is {gap}: the cycle makes no way with steps of {step}")
        })
    }

    /// Length from the bottom to the end of the cycle, mm.
    pub(super) fn way_out_mm(&self, end: &ToolPose) -> f64 {
        (end.tip - self.pose(-self.hole.depth_mm).tip).dot(&end.axis)
    }

    /// Distance of a level from that of the CL data, mm, and the text of a finding if it is too large; `None` where the
    /// working plane is unknown.
    pub(super) fn compare(&self, level: &Level) -> Option<(f64, Option<String>)> {
        let at = pose_at(self.rules, self.block, level.level_mm)?;
        let expected = &level.expected;
        let step = at.tip - expected.tip;
        let along = step.dot(&expected.axis);
        let across = (step - expected.axis * along).norm();
        let above_mm = level.above_mm.abs();
        let leans_mm = if above_mm > 0.0 { (above_mm * self.lean()?).min(self.tolerance_mm) } else { 0.0 };
        // A line that leans is shorter along the axis, by the square of its angle.
        let along = (along.abs() - leans_mm * self.lean()?).max(0.0);
        let wrong = hypot(along, (across - leans_mm).max(0.0)) > self.rules.rounding().tip_mm
            || !self.rules.is_axis_near(&at.axis, &expected.axis, 1.0);
        let off = step.norm();
        let text = wrong.then(|| {
            format!("{} of the cycle is {} from that of the CL data", level.name, self.units().deviation(off))
        });
        Some((off, text))
    }

    /// Angle between the line of the cycle and the axis of the hole, rad.
    fn lean(&self) -> Option<f64> {
        lean_of_words(self.rules, self.block, [self.cycle.bottom, self.cycle.reference], self.hole)
    }

    /// What is wrong with kind, feed and dwell.
    pub(super) fn faults(&self) -> impl Iterator<Item = String> {
        let [thread, bore] = [self.thread_fault(), self.bore_fault()];
        let [gap, set_gap] = [self.gap_fault(), self.set_gap_fault()];
        [self.kind_fault(), thread, bore, gap, set_gap, self.feed_fault(), self.dwell_fault()].into_iter().flatten()
    }

    fn kind_fault(&self) -> Option<String> {
        let (unit, hole) = (self.rules.rounding().unit_mm, self.hole);
        let same = match (self.cycle.kind, hole.drilling) {
            (CycleKind::Drill, Drilling::Drill) | (CycleKind::Ream, Drilling::Ream) => true,
            // A step that is no shorter than the hole.
            (CycleKind::Drill, Drilling::Peck { first_mm: step, .. } | Drilling::ChipBreak { step_mm: step, .. }) => {
                step + unit >= hole.depth_mm
            }
            (CycleKind::Peck(step), Drilling::Peck { first_mm, later_mm }) => {
                (step - later_mm).abs() <= unit && (step - first_mm).abs() <= unit
            }
            (CycleKind::ChipBreak(step), Drilling::ChipBreak { step_mm, .. }) => (step - step_mm).abs() <= unit,
            (CycleKind::FineBore(_), Drilling::FineBore { .. }) => true,
            (CycleKind::Tap(pitch), Drilling::Tap { pitch_mm }) => self.is_pitch(pitch, pitch_mm),
            (CycleKind::FloatingTap(pitch), Drilling::Tap { pitch_mm }) => {
                !self.rules.policy().shop.rigid_tapping && self.is_pitch(pitch, pitch_mm)
            }
            _ => false,
        };
        let units = self.units();
        (!same)
            .then(|| format!("the cycle makes {}, expected {}", self.cycle.kind.text(units), self.expected_kind(units)))
    }

    /// Feed mode of a thread.
    fn thread_fault(&self) -> Option<String> {
        let active = self.block.state.feed_mode == Some(FeedMode::PerRevolution);
        let expected = self.rules.policy().shop.thread_per_revolution;
        (self.block.action.is_thread() && active != expected).then(|| match expected {
            true => "feed per revolution is not active in this thread (`cycles.thread_feed`)".to_owned(),
            false => {
                "feed per revolution is active in this thread, expected per minute (`cycles.thread_feed`)".to_owned()
            }
        })
    }

    /// Direction and distance off the wall of a bore, and the angle at which the spindle stops, as far as the program
    /// states them.
    fn bore_fault(&self) -> Option<String> {
        let (CycleKind::FineBore(bore), Drilling::FineBore { orient_rad }) = (self.cycle.kind, self.hole.drilling)
        else {
            return None;
        };
        let (shop, angle) = (&self.rules.policy().shop, orient_rad.to_degrees());
        let [x, y] = shop.bore_direction;
        if let Some(direction) = bore.direction.filter(|[a, b]| (a - x).abs() + (b - y).abs() > SAME_BORE_DIRECTION) {
            return Some(format!(
                "the tool leaves the wall of the bore along X{} Y{}, expected X{x} Y{y} (`cycles.bore_retract`)",
                direction[0], direction[1]
            ));
        }
        if let Some(shift) = bore.shift_mm
            && (shift - shop.bore_shift_mm).abs() > ROUNDED_CYCLE_LENGTH * self.rules.rounding().unit_mm
        {
            let [shift, expected] = [shift, shop.bore_shift_mm].map(|mm| self.units().length(mm));
            return Some(format!("the tool leaves the wall of the bore by {shift}, expected {expected}"));
        }
        let written = bore.angle_deg.filter(|written| (written - angle).abs() > ROUNDED_ORIENT_DEG);
        written.map(|written| format!("the spindle stops at {}°, expected {}°", Shown(written), Shown(angle)))
    }

    /// Retract that breaks the chip, and distance above the last depth.
    fn gap_fault(&self) -> Option<String> {
        let gap = self.cycle.gap?;
        let expected = match (self.cycle.kind, self.hole.drilling) {
            (CycleKind::ChipBreak(_), Drilling::ChipBreak { retract_mm: Some(retract), .. }) => retract,
            (CycleKind::ChipBreak(_) | CycleKind::Peck(_), _) => self.rules.policy().defaults.peck_gap_mm,
            _ => return None,
        };
        ((gap - expected).abs() > ROUNDED_CYCLE_LENGTH * self.rules.rounding().unit_mm).then(|| {
            let [gap, expected] = [gap, expected].map(|mm| self.units().length(mm));
            format!("the cycle returns to {gap} above the last depth, expected {expected}")
        })
    }

    /// What is wrong with the motion of the block before its cycle, over the hole: it is below the clearance level.
    /// `before`: words before the block.
    pub(super) fn over_fault(&self, before: &[f64; MAX_AXES], known: u16) -> Option<String> {
        let normal = self.rules.words().xyz()[self.block.state.plane?.axes()[2]]?;
        let across = (0..MAX_AXES)
            .filter(|index| *index != normal && self.block.written & (1 << index) != 0)
            .fold(0.0_f64, |sum, index| hypot(sum, self.block.values[index] - before[index]));
        let rounding = self.rules.rounding();
        let over = self.cycle.over?;
        let from = if known & (1 << normal) == 0 { over } else { before[normal] };
        if across <= rounding.unit_mm && (over - from).abs() <= 0.0 {
            return None;
        }
        let height = |level_mm: f64| {
            let pose = pose_at(self.rules, self.block, level_mm)?;
            Some((pose.tip - self.hole.top.tip.coords).dot(&self.hole.top.axis))
        };
        // A motion down along the axis alone comes from where the tool was.
        let lowest = if across <= rounding.unit_mm { height(over)? } else { height(over)?.min(height(from)?) };
        let below = self.hole.clearance_mm - lowest;
        // The tool axis is rounded, too, and the words across it keep the level of a plane that leans with the cycle.
        let leans_mm = (across * self.lean()?).min(self.tolerance_mm);
        (below > 2.0 * rounding.tip_mm + across * rounding.axis_rad + leans_mm).then(|| {
            let below = self.units().deviation(below);
            format!("the tool moves over this hole {below} below its clearance level")
        })
    }

    /// Whether a thread has the pitch of the CL data: off by no more than the rounding of the word that gives it, and
    /// over its length by no more than a hundredth of it.
    fn is_pitch(&self, pitch: f64, expected: Option<f64>) -> bool {
        let left = matches!(self.spindle, Some((_, Rotation::CounterClockwise)));
        let Some(expected) = expected else { return false };
        let off = (pitch.abs() - expected).abs();
        let revolutions = (self.hole.clearance_mm + self.hole.depth_mm) / expected;
        off <= ROUNDED_PITCH * self.pitch_unit() + SAME_NUMBER * expected
            && off * revolutions <= (PITCH_ERROR + SAME_NUMBER) * expected
            && (pitch < 0.0) == left
    }

    /// One unit of the word that gives a thread its pitch, mm: the pitch itself, or F per minute at the S in force.
    fn pitch_unit(&self) -> f64 {
        let (state, rules) = (&self.block.state, self.rules);
        let (units, digits) = (self.units(), rules.policy().digits);
        let by_feed = rules.facts().thread_takes_feed || matches!(self.cycle.kind, CycleKind::FloatingTap(_));
        let unit = |decimals: u32| units.in_mm() * 10_f64.powi(-(decimals as i32));
        match (by_feed && state.feed_mode != Some(FeedMode::PerRevolution), state.speed) {
            (true, Some(speed)) => unit(digits.feed(units)) / speed,
            _ => unit(digits.pitch(units)),
        }
    }

    fn feed_fault(&self) -> Option<String> {
        // The pitch of a thread has been compared.
        if matches!(self.cycle.kind, CycleKind::Tap(_) | CycleKind::FloatingTap(_)) {
            return None;
        }
        let (rules, block, hole) = (self.rules, self.block, self.hole);
        let mut state = block.state;
        if let Some(feed) = self.cycle.feed {
            (state.feed, state.feed_mode) = (Some(feed), Some(FeedMode::PerMinute));
        }
        // The axes of the machine, whatever the frame of the words.
        let axes = |level_mm: f64| rules.words().axes(&words_at(rules, block, level_mm)?, &block.state);
        let (from, to) = (axes(self.cycle.reference)?, axes(self.cycle.bottom)?);
        let length_mm = hole.clearance_mm + hole.depth_mm;
        let stroke = Stroke {
            uneven: None,
            tip_rate_mm: [0.0; 2],
            perpendicular: rules.is_perpendicular(|| to),
            length_mm,
            longest_mm: length_mm,
            change: std::array::from_fn(|index| to[index] - from[index]),
            feed: hole.feed,
            speed_rev_per_min: self.spindle.map(|(speed, _)| speed),
        };
        rules.law().wrong(&stroke, &state)
    }

    /// The hole of the CL data in the terms of a cycle.
    fn expected_kind(&self, units: Units) -> String {
        let left = matches!(self.spindle, Some((_, Rotation::CounterClockwise)));
        match self.hole.drilling {
            Drilling::Through { .. } => return "single motions through several plates".to_owned(),
            Drilling::Drill => CycleKind::Drill,
            Drilling::Ream => CycleKind::Ream,
            Drilling::Peck { later_mm, .. } => CycleKind::Peck(later_mm),
            Drilling::ChipBreak { step_mm, .. } => CycleKind::ChipBreak(step_mm),
            Drilling::FineBore { .. } => CycleKind::FineBore(FineBore::default()),
            Drilling::Tap { pitch_mm: None } => return "a thread of unknown pitch".to_owned(),
            Drilling::Tap { pitch_mm: Some(pitch) } => CycleKind::Tap(if left { -pitch } else { pitch }),
        }
        .text(units)
    }

    fn dwell_fault(&self) -> Option<String> {
        let seconds = match (self.hole.dwell, self.spindle) {
            (Some(Dwell::Seconds(seconds)), _) => seconds,
            (Some(Dwell::Revolutions(count)), Some((speed, _))) => count / speed * 60.0,
            (Some(Dwell::Revolutions(_)), None) | (None, _) => 0.0,
        };
        ((self.cycle.dwell - seconds).abs() > ROUNDED_DWELL).then(|| {
            let [found, expected] = [self.cycle.dwell, seconds].map(Shown);
            format!("the cycle dwells for {found} s at the bottom, expected {expected} s")
        })
    }
}
