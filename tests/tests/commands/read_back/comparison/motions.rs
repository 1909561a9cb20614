//! Checks of one motion: approach, retract, cut, piece of a cut, machine coordinates, travel.

use approx::abs_diff_eq;
use pp_runtime::kinematics::{AxisKind, Machine, Pose, Side};
use pp_runtime::nalgebra::{Point3, Vector3};
use tests::block::{angle_to_arc, deviation, deviation_from, distance_to_line, timed_mm};
use tests::foreign::{Axes, Feed};
use tests::oracle::angle_between;

use super::super::points::Goto;
use super::{
    BLOCK_POINTS, Comparison, INDEX_ANGLE, LARGEST_ROTATION, Motion, NOISE, ON_LINE, ROTARY_UNIT, SIX_DIGITS,
    SplitMotion, Stage, TOLERANCE,
};

impl<M: Machine> Comparison<'_, M> {
    /// Checks the approach point: the first GOTO if the next is straight below it, else a point above the first GOTO.
    pub(super) fn approach(&mut self, line: usize, values: &[f64], position: &Axes) {
        let goto = &self.cl.points[self.next];
        let below = self.cl.points.get(self.next + 1).filter(|next| next.operation == goto.operation);
        let is_above = goto.rapid && below.is_some_and(|below| straight_down(goto, below));
        self.checked.approaches += 1;
        if is_above {
            self.check_point(line, values, position);
            self.stage = Stage::Cutting;
        } else {
            let above = goto.tip + goto.axis * self.set_up.approach_mm;
            self.check_inserted(line, values, &above, &goto.axis);
            self.reached = Some((above, *position));
        }
    }

    pub(super) fn check_inserted(&self, line: usize, values: &[f64], tip: &Point3<f64>, axis: &Vector3<f64>) {
        let pose = self.oracle.forward(values);
        let missed = (pose.tip - tip).norm();
        let allowed = ON_LINE.max(self.unit);
        assert!(missed <= allowed, "line {line}: the inserted point is {missed} mm off its line");
        let axis_off = angle_between(&pose.axis, axis).to_degrees();
        assert!(axis_off <= ROTARY_UNIT, "line {line}: the tool axis of the inserted point is {axis_off}° off");
    }

    /// Whether a motion is the retract along the tool axis before a machine retract; checks its distance.
    pub(super) fn is_retract_along_axis(&self, motion: &Motion, values: &[f64], then_machine: bool) -> bool {
        let (Some(distance), Some((tip, _)), true) =
            (self.set_up.retract_distance_mm, &self.reached, motion.rapid && then_machine)
        else {
            return false;
        };
        let Pose { axis, .. } = self.oracle.forward(values);
        self.check_inserted(0, values, &(tip + axis.into_inner() * distance), &axis);
        true
    }

    /// Checks a motion to the next GOTO.
    pub(super) fn go_to(&mut self, line: usize, motion: &Motion, values: &[f64]) {
        let Some((from, before)) = self.reached else { panic!("line {line}: its start is unknown") };
        let linear_only = motion.written.letters().all(|letter| !"ABC".contains(letter));
        assert!(self.stage == Stage::Cutting || linear_only, "line {line}: the approach moves a rotary axis");
        let goto = self.cl.points.get(self.next).unwrap_or_else(|| panic!("line {line}: there is no GOTO left"));
        let (rapid, feed, tip, cl_line) = (goto.rapid, goto.feed_mm_per_min, goto.tip, goto.line);
        assert_eq!(motion.rapid, rapid, "line {line}: G0 or G1 differs from CL line {cl_line}");
        let rotation = before
            .iter()
            .filter(|(letter, _)| "ABC".contains(*letter))
            .map(|(letter, word)| (motion.position.get(letter).expect("a position") - word).abs())
            .fold(0.0, f64::max);
        // A link: a rapid that rotates the tool, in blocks along its path.
        let away = || angle_between(&self.oracle.forward(values).axis, &goto.axis).to_degrees() > 2.0 * ROTARY_UNIT;
        let link = rapid && (self.split.is_some() || rotation > INDEX_ANGLE + 1e-9 || rotation > 0.0 && away());
        if !rapid || link {
            assert!(rotation <= LARGEST_ROTATION, "line {line}: a cut rotates an axis by {rotation}°");
            let written = motion.feed;
            assert!(rapid || written.is_some(), "line {line}: no F");
            let before = self.values(&before, self.scale).expect("every word is known in the cut");
            if self.piece(line, &before, values, written, rotation > 0.0) {
                let reached = self.oracle.forward(values).tip;
                self.reached = Some((reached, motion.position));
                self.retracted_mm = 0.0;
                self.stage = Stage::Cutting;
                return;
            }
            if self.split.take().is_none()
                && let Some(written) = written
            {
                let length = (tip - from).norm();
                let rate = deviation(&self.oracle, &before, values, BLOCK_POINTS).tip_rate_mm;
                check_feed(line, written, feed, self.timed_mm(length, rate), rotation, self.scale);
            }
        }
        let step = tip - from;
        let retracts = rotation == 0.0 && angle_between(&step, &self.oracle.forward(values).axis) <= 1e-3;
        self.retracted_mm = if retracts { self.retracted_mm + step.norm() } else { 0.0 };
        self.check_point(line, values, &motion.position);
        self.stage = Stage::Cutting;
        self.pass_repeated();
    }

    /// Checks a block of a motion that rotates an axis, with its feed if it is no rapid; returns whether the block ends
    /// before the GOTO.
    pub(super) fn piece(
        &mut self,
        line: usize,
        before: &[f64],
        values: &[f64],
        written: Option<Feed>,
        rotates: bool,
    ) -> bool {
        let Some((tip, _)) = self.reached else { return false };
        let begun = self.split.unwrap_or_else(|| {
            let axis = self.oracle.forward(before).axis.into_inner();
            SplitMotion { tip, axis, minutes: 0.0, still: false, uneven: false }
        });
        if !rotates && self.split.is_none() {
            return false;
        }
        if self.split.is_none() {
            self.uneven = vec![before.to_vec()];
        }
        let goto = &self.cl.points[self.next];
        let ends = ((&begun.tip, &begun.axis), (&goto.tip, &goto.axis));
        let off = deviation_from(&self.oracle, before, values, BLOCK_POINTS, ends.0, ends.1);
        let (tip_tolerance, axis_tolerance) = if self.set_up.coarse { (1.0, 10.0) } else { TOLERANCE };
        assert!(off.tip_mm <= tip_tolerance, "line {line}: the tip leaves its line by {} mm", off.tip_mm);
        assert!(off.axis_rad.to_degrees() <= axis_tolerance, "line {line}: the tool axis is {} rad off", off.axis_rad);
        let pose = self.oracle.forward(values);
        let allowance = 0.5 * self.unit * 3_f64.sqrt() + NOISE;
        let length = (pose.tip - self.oracle.forward(before).tip).norm();
        let lengths_mm = self.timed_mm(length, off.tip_rate_mm);
        // The length that was planned is that of ends that are not rounded.
        let uneven = self.timed_mm(length - 2.0 * allowance, off.tip_rate_mm).0 > length - 2.0 * allowance;
        let [exact, longest] = <[f64; 2]>::from(lengths_mm).map(|length| length / goto.feed_mm_per_min);
        let minutes = match written {
            Some(Feed::InverseTime(word)) => 1.0 / word,
            Some(Feed::PerMinute(word)) => length / (word * self.scale),
            Some(Feed::PerRevolution(_)) => panic!("line {line}: G95"),
            None => exact,
        };
        let still = length < self.unit + 2.0 * allowance;
        let noise = (2.0 * allowance + 1e-5 * length) / goto.feed_mm_per_min;
        assert!(minutes >= exact - noise, "line {line}: a piece takes {minutes} min, expected {exact}");
        let least = timed_mm(0.0, off.tip_rate_mm, self.unit) / goto.feed_mm_per_min;
        let timed = written.is_some();
        assert!(
            !timed || minutes >= least * (1.0 - SIX_DIGITS),
            "line {line}: {minutes} min, expected at least {least}"
        );
        assert!(still || minutes <= longest + noise, "line {line}: a piece takes {minutes} min, expected {exact}");
        let split = SplitMotion {
            minutes: begun.minutes + minutes,
            still: begun.still || still,
            uneven: begun.uneven || uneven,
            ..begun
        };
        let axis_off = angle_between(&pose.axis, &goto.axis).to_degrees();
        if (pose.tip - goto.tip).norm() <= 2.0 * allowance && axis_off <= 2.0 * ROTARY_UNIT {
            if self.split.is_some() {
                self.check_even_rotation(line, values);
                self.split = Some(split);
                let whole = (goto.tip - begun.tip).norm() / goto.feed_mm_per_min;
                let time_off = (split.minutes - whole).abs();
                let timed = written.is_some() && !split.still;
                assert!(
                    !timed || split.uneven && split.minutes > whole || time_off <= 2.0 * SIX_DIGITS * whole,
                    "line {line}: {split:?} for {whole} min"
                );
            }
            return false;
        }
        let missed = distance_to_line(&pose.tip, &begun.tip, &goto.tip);
        assert!(missed <= allowance, "line {line}: the inserted point is {missed} mm off its line");
        let axis_off = angle_to_arc(&pose.axis, &begun.axis, &goto.axis).to_degrees();
        if axis_off > 3.0 * ROTARY_UNIT {
            self.uneven.push(values.to_vec());
        }
        self.split = Some(split);
        true
    }

    /// Length that a block takes its time for, mm, and the largest that a bound of its speed may show: the tip is a
    /// hundredth faster than programmed at most. `rate_mm`: its largest speed times the time of the block.
    fn timed_mm(&self, length_mm: f64, rate_mm: f64) -> (f64, f64) {
        let tolerance_mm = if self.set_up.coarse { 1.0 } else { TOLERANCE.0 };
        let led = |rate_mm: f64| timed_mm(length_mm, rate_mm, self.unit);
        (led(rate_mm), if led(rate_mm) > length_mm { led(rate_mm + tolerance_mm) } else { length_mm })
    }

    /// Points off the great circle are those of an even rotation of the rotary axes from end to end.
    fn check_even_rotation(&self, line: usize, end: &[f64]) {
        let [start, points @ ..] = &self.uneven[..] else { return };
        let rotary = self.oracle.rotary();
        let change = |index: usize| end[index] - start[index];
        let Some(&widest) = rotary.iter().max_by(|a, b| change(**a).abs().total_cmp(&change(**b).abs())) else {
            return;
        };
        for point in points {
            let part = (point[widest] - start[widest]) / change(widest);
            assert!((0.0..=1.0).contains(&part), "line {line}: an axis goes beyond the end of its rotation");
            for &index in &rotary {
                let off = (point[index] - start[index] - change(index) * part).to_degrees().abs();
                assert!(off <= 2.0 * ROTARY_UNIT, "line {line}: a rotary axis is {off}° off its even rotation");
            }
        }
    }

    pub(super) fn machine_motion(&mut self, line: usize, motion: &Motion) {
        if self.stage == Stage::Cutting && self.reached.take().is_some() {
            let head = M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool);
            let expected = self.set_up.retract_distance_mm.unwrap_or(if head { 1.0 } else { 0.0 });
            assert!(
                self.retracted_mm >= expected,
                "line {line}: the tool is retracted {} mm along its axis",
                self.retracted_mm
            );
        }
        self.reached = None;
        self.retracted_mm = 0.0;
        let parking = self.next == self.cl.points.len() && self.stage == Stage::Retracted;
        for (letter, value) in motion.written.iter() {
            let value = value * self.scale;
            let parked = self.set_up.park.iter().any(|(axis, place)| *axis == letter && (place - value).abs() < 1e-9);
            let retracted = letter == 'Z' && (value - self.set_up.retract_z_mm).abs() < 1e-9;
            assert!(retracted || (parking && parked), "line {line}: {letter} goes to {value} in machine coordinates");
            self.parked.extend(parked.then_some(letter));
        }
        self.stage = Stage::Retracted;
    }

    /// Checks rotary words against the declared limits, and linear words against the travel of the set-up.
    pub(super) fn check_limits(&self, line: usize, motion: &Motion) {
        for axis in M::AXES {
            let Some(word) = motion.written.get(axis.letter) else { continue };
            if axis.kind == AxisKind::Rotary {
                if let Some(limits) = axis.limits {
                    let (low, high) = (limits.lower.to_degrees() - 1e-9, limits.upper.to_degrees() + 1e-9);
                    let inside = (low..=high).contains(&self.angle(axis.letter, word));
                    assert!(inside, "line {line}: {}{word} is beyond its limit", axis.letter);
                }
            } else if let Some((_, zero, low, high)) = self.set_up.travel.iter().find(|travel| travel.0 == axis.letter)
            {
                // The tool's length acts along Z of every machine here.
                let length = if axis.letter == 'Z' && !motion.machine { self.length() } else { 0.0 };
                let word = word * self.scale;
                let place = if motion.machine { word } else { zero + word + length };
                let inside = (low - 1e-9..=high + 1e-9).contains(&place);
                assert!(inside, "line {line}: {}{word} is machine coordinate {place}, beyond the travel", axis.letter);
            }
        }
    }
}

fn straight_down(first: &Goto, next: &Goto) -> bool {
    let step = next.tip - first.tip;
    let along = step.dot(&first.axis);
    let across = (step - first.axis * along).norm();
    along < 0.0 && across <= ON_LINE && (first.axis - next.axis).norm() <= 1e-6
}

/// `feed` and lengths in mm, `rotation` in degrees; `scale`: mm in the program's unit.
fn check_feed(line: usize, written: Feed, feed: f64, length: (f64, f64), rotation: f64, scale: f64) {
    match written {
        Feed::PerMinute(word) => {
            assert!(rotation == 0.0, "line {line}: G94 in a block with rotary motion");
            let same = abs_diff_eq!(word, feed / scale, epsilon = 0.5e-3 + 1e-9);
            assert!(same, "line {line}: F{word} for {feed} mm/min");
        }
        Feed::PerRevolution(_) => panic!("line {line}: G95"),
        Feed::InverseTime(word) => {
            assert!(rotation > 0.0, "line {line}: G93 in a block without rotary motion");
            let [exact, slowest] = <[f64; 2]>::from(length).map(|length| feed / length);
            let range = slowest * (1.0 - SIX_DIGITS)..=exact * (1.0 + SIX_DIGITS);
            assert!(
                range.contains(&word),
                "line {line}: F{word}, expected {exact} for {feed} mm/min over {length:?} mm"
            );
        }
    }
}
