//! Extremes of the axes within a block.
//!
//! Where the control rotates the tool axis in the plane of its ends, or is given that axis instead of angles, its
//! rotary axes are followed from their last position in small steps. At a limit of theirs another position with the
//! same tool axis is looked for, as the control does; how it gets there is not judged.

use std::f64::consts::{PI, TAU};

use super::super::geometry::{PathPoint, PathShape, Search, Segment};
use super::super::read::{PoseSelector, set_bits};
use super::super::rules::{BlockPath, WordsAlongArc};
use super::{Block, Extent, Findings, MAX_AXES, Rules, TipControl, ToolPose, Travel, Vector3, sweep};
use crate::check::tolerances::{CONTROL_CHOOSES_NEAR_POLE, POLE_ANGLE_NOISE, SAME_POSITION};
use crate::kinematics::math::{hypot, larger, smaller};

/// Largest distance between points of a block, rad: of the rotary axes, of which two may add up, and of an arc; unless
/// there were more points than this.
const ROTATION_STEP: f64 = 0.05;
const ARC_STEP: f64 = 0.2;
const MOST_STEPS: f64 = 2000.0;

/// Largest step of rotary axes that a control rotates by itself, rad, and the distance of two equal positions.
const LARGEST_ROTATION: f64 = 4.0 * ROTATION_STEP;

/// Largest step of the tool axis, in distances from the pole: a longer one might lead past it to the other position.
const STEP_PAST_POLE: f64 = 0.5;

/// Number of values of each rotary axis from which another position is looked for.
const SEEDS: u32 = 9;

impl Travel {
    /// Whether the axes stay within their limits between the ends of a block.
    pub(super) fn within(
        &mut self,
        rules: &Rules<'_>,
        (before, known): (&[f64; MAX_AXES], u16),
        block: &Block,
        findings: &mut Findings<'_>,
    ) {
        let (rotary, by_control) = (rules.words().rotary_bits(), block.state.vector.is_some());
        let stated = !by_control && block.known & rotary == rotary;
        let end = stated.then_some(block.values);
        let sweep = sweep(block);
        if block.state.tip_control == TipControl::Off && !by_control && sweep <= 0.0 {
            self.rotated = end;
            return;
        }
        if let Some(rotated) = std::mem::replace(&mut self.rotated, end) {
            self.follow(rules, &rotated, (before, known), block, sweep, findings);
        }
    }

    /// Whether linear axes that follow the rotary ones, or a path that is no line, stay within the limits. `rotated`:
    /// words before the block with the rotary axes as the control has rotated them.
    #[inline(never)]
    fn follow(
        &mut self,
        rules: &Rules<'_>,
        rotated: &[f64; MAX_AXES],
        (before, known): (&[f64; MAX_AXES], u16),
        block: &Block,
        sweep: f64,
        findings: &mut Findings<'_>,
    ) {
        let (words, by_control) = (rules.words(), block.state.vector.is_some());
        let known = known & block.known & words.linear_bits() == words.linear_bits();
        // The start of linear axes may be unknown; the rotation of the rotary ones is known.
        let from = words.with_rotary(if known { *before } else { block.values }, rotated);
        let angle = match block.state.tip_control {
            TipControl::On { .. } if !by_control => words.rotary_travel(&from, &block.values),
            _ => 0.0,
        };
        let together = !block.action.is_rapid() || rules.rapids_are_interpolated();
        if by_control || (angle > 0.0 && known && rules.policy().words.axis_in_plane && together) {
            self.in_plane(rules, block, from, angle, findings);
        } else if !known || (angle <= 0.0 && sweep <= 0.0) {
        } else if together {
            self.interpolated(rules, &rules.path(*before, block), angle, sweep, findings);
        } else {
            self.uncoordinated(rules, before, block, findings);
        }
    }

    /// A block in which the control rotates the tool axis evenly in a plane, and finds the rotary axes itself.
    fn in_plane(
        &mut self,
        rules: &Rules<'_>,
        block: &Block,
        from: [f64; MAX_AXES],
        angle: f64,
        findings: &mut Findings<'_>,
    ) {
        let (words, state) = (rules.words(), &block.state);
        let pose = |axis: Vector3<f64>| ToolPose { tip: Vector3::zeros(), axis };
        let end = words.place(&block.values, state).axis;
        let rotation = Segment { from: pose(words.tool_axis_at(&from)), to: pose(end), shape: PathShape::Line };
        let path: BlockPath<'_> = rules.path(from, block);
        let off_pole = |axis: &Vector3<f64>| rules.off_pole_rad(axis).max(CONTROL_CHOOSES_NEAR_POLE);
        let at = |share: f64, near: &PathPoint| {
            let axis = rotation.at(share).axis;
            if share < 1.0 && rules.off_pole_rad(&axis) < POLE_ANGLE_NOISE && rotation.turn() > POLE_ANGLE_NOISE {
                return None;
            }
            let farther = off_pole(&axis).max(off_pole(&rotation.at(near.share).axis));
            if (share - near.share).abs() * rotation.turn() > STEP_PAST_POLE * farther {
                return None;
            }
            let here = words.with_rotary(path.at(share), &near.words);
            let here = words.rotated_to(&here, &axis, 0.0)?;
            let step = words.rotary_travel(&here, &near.words);
            let values = words.axes_with_rotary(&here, state).filter(|_| step <= LARGEST_ROTATION)?;
            Some(PathPoint { share, words: here, values })
        };
        let Some(values) = words.axes_with_rotary(&from, state) else { return };
        let (first, quiet) = (PathPoint { share: 0.0, words: from, values }, self.quiet(words));
        let mut search = Search { at, quiet: &quiet, axes: self.bits(), extent: Extent::of(&values) };
        let last = search.go(first, 1.0, step(angle.max(rotation.turn()), sweep(block)));
        let extent = search.extent;
        if last.share < 1.0 {
            return;
        }
        if state.vector.is_none() {
            // Past the pole the axes may be in the other position with the same tool axis.
            if words.rotary_travel(&last.words, &block.values) <= SAME_POSITION {
                self.judge(words, &extent, [&values, &last.values], "within this block ", findings);
            }
            return;
        }
        self.rotated = Some(last.words);
        match self.rotary_outside(&last.values).then(|| self.position_within(rules, &last.words, &end)).flatten() {
            Some(other) => self.rotated = Some(other),
            None => self.judge(words, &extent, [&values, &last.values], "within this block ", findings),
        }
    }

    /// Whether the selector of a plane call names another pose than that of these words; `higher`: SEQ+ or _DIR 1.
    ///
    /// Heidenhain: SEQ is the sign of the master axis, the one nearest the tool. Siemens: _DIR is the lower or the
    /// higher of its two values.
    pub(in super::super) fn selects_other_pose(&self, rules: &Rules<'_>, here: &[f64; MAX_AXES], higher: bool) -> bool {
        let words = rules.words();
        let Some(master) = words.rotary().last() else { return false };
        // At half a revolution it is as much on the one side as on the other.
        let principal = |angle: f64| angle - (angle / TAU).round() * TAU;
        let value = principal(words.values(here)[master]);
        if PI - value.abs() < SAME_POSITION {
            return false;
        }
        match rules.facts().pose {
            PoseSelector::Nearest => false,
            // Without a pose of this sign the control stops.
            PoseSelector::Sign => value.abs() > SAME_POSITION && (value > 0.0) != higher,
            PoseSelector::Higher => {
                let other = nearest_position(rules, here, &words.tool_axis_at(here), |there| {
                    words.rotary().any(|index| principal(there[index] - here[index]).abs() > SAME_POSITION)
                });
                let other = other.map(|other| principal(words.values(&other)[master]));
                other.is_some_and(|other| {
                    PI - other.abs() > SAME_POSITION
                        && (value - other).abs() > SAME_POSITION
                        && (value > other) != higher
                })
            }
        }
    }

    /// The nearest position of the rotary axes within their limits with this tool axis.
    fn position_within(
        &self,
        rules: &Rules<'_>,
        from: &[f64; MAX_AXES],
        axis: &Vector3<f64>,
    ) -> Option<[f64; MAX_AXES]> {
        let within = |there: &[f64; MAX_AXES]| !self.rotary_outside(&rules.words().values(there));
        nearest_position(rules, from, axis, within)
    }

    /// A block whose axes arrive together; `angle`: largest rotation of a rotary axis, `sweep`: angle of the arc, rad.
    fn interpolated(
        &mut self,
        rules: &Rules<'_>,
        path: &BlockPath<'_>,
        angle: f64,
        sweep: f64,
        findings: &mut Findings<'_>,
    ) {
        let (words, state) = (rules.words(), &path.block.state);
        let at = |share: f64, _: &PathPoint| {
            let here = path.at(share);
            words.axes(&here, state).map(|values| PathPoint { share, words: here, values })
        };
        let Some(values) = words.axes(&path.before, state) else { return };
        let quiet = self.quiet(words);
        let rests = words.rotary_travel(&path.before, &path.block.values) <= 0.0;
        if rests
            && let Some(arc) = path.arc()
            && let Some(circle) = circle(self.bits(), &arc, &values, |at| words.axes(at, state))
            && quiet.holds(&circle, self.bits())
        {
            return;
        }
        let first = PathPoint { share: 0.0, words: path.before, values };
        let step = step(angle, sweep);
        let mut search = Search { at, quiet: &quiet, axes: self.bits(), extent: Extent::of(&values) };
        // Revolutions of a helix differ by its rise alone: the extreme is in the first or the last.
        let revolution = TAU / sweep;
        let late = if angle <= 0.0 && revolution < 0.5 {
            search.go(first, revolution, step);
            (search.at)(1.0 - revolution, &first).unwrap_or(first)
        } else {
            first
        };
        let last = search.go(late, 1.0, step);
        let extent = search.extent;
        self.judge(words, &extent, [&first.values, &last.values], "within this block ", findings);
    }
}

/// Bounds of some axes, as bits, on the whole circle of an arc, and on all of its rise, while the rotary axes rest.
/// `start`: values of the axes before the block; `at`: those with words.
fn circle(
    axes: u16,
    arc: &WordsAlongArc,
    start: &[f64; MAX_AXES],
    at: impl Fn(&[f64; MAX_AXES]) -> Option<[f64; MAX_AXES]>,
) -> Option<Extent> {
    let (middle, quarter, end) = (at(&arc.middle)?, at(&arc.quarter)?, at(&arc.end)?);
    let mut extent = Extent::of(start);
    for axis in set_bits(axes) {
        let radius = hypot(start[axis] - middle[axis], quarter[axis] - middle[axis]);
        let rise = end[axis] - start[axis];
        extent.low[axis] = middle[axis] - radius + smaller(rise, 0.0);
        extent.high[axis] = middle[axis] + radius + larger(rise, 0.0);
    }
    Some(extent)
}

/// The nearest position of the rotary axes that has this tool axis and suits.
fn nearest_position(
    rules: &Rules<'_>,
    from: &[f64; MAX_AXES],
    axis: &Vector3<f64>,
    suits: impl Fn(&[f64; MAX_AXES]) -> bool,
) -> Option<[f64; MAX_AXES]> {
    let words = rules.words();
    let mut rotary = words.rotary();
    let (first, second) = (rotary.next()?, rotary.next()?);
    let found = (0..SEEDS * SEEDS).filter_map(|seed| {
        let mut start = *from;
        start[first] += TAU * (f64::from(seed % SEEDS) / f64::from(SEEDS) - 0.5);
        start[second] += TAU * (f64::from(seed / SEEDS) / f64::from(SEEDS) - 0.5);
        words.rotated_to(&start, axis, 0.0).filter(&suits)
    });
    let distance = |there: &[f64; MAX_AXES]| words.rotary_travel(from, there);
    found.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// Step of the share in a block that rotates by `angle` and goes round by `sweep`, rad.
fn step(angle: f64, sweep: f64) -> f64 {
    1.0 / (angle / ROTATION_STEP + sweep / ARC_STEP).ceil().clamp(2.0, MOST_STEPS)
}
