//! Words that are coordinates of the tip in a frame of the control, and the map from the workpiece to the words.

use std::cell::Ref;
use std::f64::consts::TAU;

use nalgebra::{Matrix3, Point3, UnitVector3, Vector3};

use crate::diag::code::plan;
use crate::kinematics::{AxisValues, Rotary};
use crate::nc::whole_units;
use crate::program::Shown;

use super::frame::{WordMap, no_plane};
use super::refusal;
use super::tilted_plane::{PlaneAbility, PoseRule, TiltedPlane, plane_across};
use super::{AxisPosition, Placer, too_large};
use crate::motion::fault::Fault;
use crate::motion::geometry::angle_between;
use crate::shortcut::Shortcut;
use crate::tolerance::writer::{AXIS_VALUE_NOISE, ORTHOGONAL_MAP};

/// Largest deviation of an axis from its chord between two points of a block that are compared with the travel.
const TRAVEL_SAMPLING_MM: f64 = 0.01;

/// Largest number of points of a block that are compared with the travel.
const MAX_TRAVEL_SAMPLES: f64 = 1000.0;

impl Placer {
    /// Words of X Y Z, not rounded, that move the tip to a point at the rotary angles of `at`, mm; `None` if the
    /// program has no such words.
    pub(crate) fn program_point(&self, tip: &Point3<f64>, at: &AxisPosition) -> Option<Vector3<f64>> {
        if let Some(map) = self.frame.map(&*self.machine, &at.axes) {
            return Some(map.words(tip));
        }
        let axes = self.machine.linear_axes(tip, &at.axes)?;
        let word = |index: usize| axes[index] + self.datum.linear_shift_mm(index);
        Some(Vector3::from(self.linear.xyz?.map(word)))
    }

    /// Positions of X Y Z in the chain, and the derivative of their words with respect to the tip at the rotary angles
    /// of `at`: one row for each word, one column for each direction of the workpiece frame. `None` if it is not
    /// orthogonal; if it is, the words keep angles and lengths of the tip path.
    pub(crate) fn orthogonal_map(&self, at: &AxisPosition) -> Option<([usize; 3], Matrix3<f64>)> {
        let letters = self.linear.xyz?;
        if !self.frame.counts_tip()
            && let Some((solved, known)) = self.known_map(at)
        {
            // A word is an axis value and a constant.
            let map = &known.map;
            if solved == letters {
                return known.orthogonal.then_some((letters, *map));
            }
            let row = |letter: usize| solved.iter().position(|index| *index == letter);
            if let [Some(x), Some(y), Some(z)] = letters.map(row) {
                return known.orthogonal.then(|| (letters, Matrix3::from_rows(&[map.row(x), map.row(y), map.row(z)])));
            }
        }
        let map = differences(|tip| self.program_point(tip, at))?;
        is_orthogonal(&map).then_some((letters, map))
    }

    /// Positions of the solved linear axes, and the derivative of their values with respect to the tip at the rotary
    /// angles of `at`.
    pub(crate) fn axis_map(&self, at: &AxisPosition) -> Option<([usize; 3], Matrix3<f64>)> {
        self.known_map(at).map(|(solved, known)| (solved, known.map))
    }

    /// [`axis_map`](Self::axis_map) with what is known about the derivative.
    #[inline(always)]
    fn known_map(&self, at: &AxisPosition) -> Option<([usize; 3], Ref<'_, AxisMap>)> {
        let solved = *self.linear.solved.first_chunk()?;
        let bits = |rotary: &Rotary| at.axes[rotary.index].to_bits();
        let axis = |axis: usize| self.rotary.axes.get(axis).map_or(0, bits);
        let angles = [axis(0), axis(1)];
        if self.last_map.borrow().as_ref().is_none_or(|known| known.angles != angles) {
            self.find_map(at, solved, angles)?;
        }
        let known = Ref::filter_map(self.last_map.borrow(), Option::as_ref).ok()?;
        Some((solved, known))
    }

    #[inline(never)]
    fn find_map(&self, at: &AxisPosition, solved: [usize; 3], angles: [u64; 2]) -> Option<()> {
        let values = |tip: &Point3<f64>| {
            let axes = self.machine.linear_axes(tip, &at.axes)?;
            Some(Vector3::from(solved.map(|index| axes[index])))
        };
        let map = differences(values)?;
        let lengths = [0, 1, 2].map(|row| map.row(row).transpose().norm());
        self.last_map.replace(Some(AxisMap { angles, map, lengths, orthogonal: is_orthogonal(&map) }));
        Some(())
    }

    /// Whether a path of the tip at the rotary angles of `at` certainly keeps the linear axes within the travel that
    /// they have needed so far, and their words within their digits. `reach_mm`: no point of the path is further from
    /// `at`; `bounds`: two values between which `direction · p` is at every point `p` of the path.
    ///
    /// An axis value is the product of a row of [`axis_map`](Self::axis_map) and `p`, and a constant.
    pub(crate) fn needs_no_travel(
        &self,
        at: &AxisPosition,
        reach_mm: f64,
        bounds: impl Fn(Vector3<f64>) -> [f64; 2],
    ) -> bool {
        if !Shortcut::TravelInReach.is_on() || self.frame.counts_tip() {
            return false;
        }
        let Some((solved, known)) = self.known_map(at) else { return false };
        let AxisMap { map, lengths, .. } = &*known;
        // Nearly always the axes may move on by that distance from their rounded positions.
        let near = |row: usize| {
            let (value, aside) = (at.axes[solved[row]], lengths[row] * reach_mm + self.unit_mm());
            [value - aside, value + aside]
        };
        if self.needs_none_between(solved, [near(0), near(1), near(2)]) {
            return true;
        }
        let rows = [0, 1, 2].map(|row| map.row(row).transpose());
        let Some(here) = self.machine.linear_axes(&at.pose.tip, &at.axes) else { return false };
        let along = |row: usize| {
            let constant = here[solved[row]] - rows[row].dot(&at.pose.tip.coords);
            let [low, high] = bounds(rows[row]);
            [constant + low - AXIS_VALUE_NOISE, constant + high + AXIS_VALUE_NOISE]
        };
        self.needs_none_between(solved, [0, 1, 2].map(along))
    }

    /// Whether linear axes between two values each need no further travel. Rounding to words changes no order, so what
    /// holds for both holds for all values between them.
    fn needs_none_between(&self, solved: [usize; 3], ranges: [[f64; 2]; 3]) -> bool {
        let fits = |(index, [low, high]): (usize, [f64; 2])| {
            let furthest = (0.5 * (low + high) + self.datum.linear_shift_mm(index)).abs() + 0.5 * (high - low);
            // The unit is for the rounding of this sum.
            furthest * self.linear.scale.units_per_mm + 1.0 < self.linear.scale.most_units[index]
        };
        if !solved.into_iter().zip(ranges).all(fits) {
            return false;
        }
        let is_changed_at = |side: usize| {
            let mut end = AxisValues::default();
            for (index, range) in solved.into_iter().zip(ranges) {
                let Ok((_, written)) = self.linear.rounded(range[side], self.datum.linear_shift_mm(index)) else {
                    return true;
                };
                end[index] = written;
            }
            self.travel.is_changed_by(&end)
        };
        !(self.travel.limited() && (is_changed_at(0) || is_changed_at(1)))
    }

    /// Computes the linear axes and words of a position whose words are coordinates of the tip.
    pub(crate) fn solve_tip(&self, place: &mut AxisPosition, map: &WordMap) -> Result<(), Fault> {
        if !self.vectors {
            self.check_rotary_digits(&place.words)?;
        }
        let mut written = map.words(&place.pose.tip);
        let letters = self.frame.letters();
        for (index, value) in letters.into_iter().zip(written.iter_mut()) {
            let units = whole_units(*value, self.linear.scale.units_per_mm)
                .ok()
                .filter(|units| units.abs() < self.bounds[index]);
            let units = units.ok_or_else(|| too_large(self.chain[index].letter))?;
            place.words[index] = units;
            *value = units as f64 / self.linear.scale.units_per_mm;
        }
        let reached = map.tip(&written);
        if !self.machine.set_linear_axes(&reached, &mut place.axes) {
            return Err(refusal::unreachable(self, &place.pose, &place.axes));
        }
        place.rounding_mm = (reached - place.pose.tip).norm();
        Ok(())
    }

    /// Position in the frame of tip control, which may depend on the rotary angles at which tip control begins.
    pub(crate) fn in_tip_frame(&mut self, mut place: AxisPosition) -> Result<AxisPosition, Fault> {
        if !self.frame.is_set_at_angles() {
            return Ok(place);
        }
        self.frame.start(&*self.machine, &place.axes);
        self.solve_linear_in_travel(&mut place)?;
        Ok(place)
    }

    /// Position in the tilted plane whose Z is its tool axis, and that plane in the words of the control.
    pub(crate) fn tilted(
        &mut self,
        mut place: AxisPosition,
        ability: &PlaneAbility,
    ) -> Result<(AxisPosition, TiltedPlane), Fault> {
        // The rotary angles are rounded here, and the control computes its own: the plane is that of the tool axis.
        let tilt = self.frame.tilt(ability, &plane_across(&self.axis_of_plane(&place)?)).ok_or_else(no_plane)?;
        self.solve_linear_in_travel(&mut place)?;
        Ok((place, tilt))
    }

    /// Position with words in the directions of the machine, from a zero that has moved with the table.
    pub(crate) fn in_moved_zero(&mut self, mut place: AxisPosition) -> Result<AxisPosition, Fault> {
        self.frame.move_zero(&*self.machine, &place.axes);
        self.solve_linear_in_travel(&mut place)?;
        Ok(place)
    }

    /// The tool axis that a plane at a position has; refused where indexed axes cannot take it: the control would
    /// rotate them off their steps.
    pub(crate) fn axis_of_plane(&self, place: &AxisPosition) -> Result<UnitVector3<f64>, Fault> {
        let axis = place.pose.axis;
        if !self.has_indexed_axes() {
            return Ok(axis);
        }
        let off = angle_between(&self.machine.forward_kinematics(&place.axes).axis, &axis);
        // A step may be two units off, and the word of another axis is rounded.
        if off <= 4.0 * self.rotary.scale.angle(1) {
            return Ok(axis);
        }
        let degrees = Shown(off.to_degrees());
        let text = format_args!("the steps of the indexed axes are {degrees}° off the tool axis of this plane");
        Err(plan::INDEXING.fault(text).help("move the tool axis of the operation to a step in CAM"))
    }

    /// Which of the possible poses of a plane this position is, according to a rule: see [`PoseRule::choose`].
    pub(crate) fn pose_of_plane(&self, place: &AxisPosition, rule: PoseRule) -> Option<bool> {
        let rotary = self.rotary.axes.last()?;
        let last = self.rotary.axes.len() - 1;
        let within_half_a_turn = |angle: f64| angle - (angle / TAU).round() * TAU;
        let here = within_half_a_turn(place.axes[rotary.index]);
        let solutions = self.machine.rotary_axes(&place.pose.axis, &place.axes);
        let others = solutions.iter().map(|solution| within_half_a_turn(solution.axes[last]));
        // Without this pose itself, which is among them, unrounded.
        let others: Vec<f64> =
            others.filter(|other| within_half_a_turn(other - here).abs() > self.rotary.scale.angle(1)).collect();
        rule.choose(here, &others)
    }

    /// Checks the travel inside a block in which the control moves the linear axes so that the tip stays on its line.
    #[inline(always)]
    pub(crate) fn check_between(&mut self, from: &AxisPosition, to: &AxisPosition) -> Result<(), Fault> {
        if self.frame.counts_tip() && self.travel.limited() { self.check_points_between(from, to) } else { Ok(()) }
    }

    fn check_points_between(&mut self, from: &AxisPosition, to: &AxisPosition) -> Result<(), Fault> {
        // The deviation from the chord falls with the square of the step: it is below `TRAVEL_SAMPLING_MM` between
        // points.
        let steps = (self.machine.motion(&from.axes, &to.axes).tip / TRAVEL_SAMPLING_MM)
            .sqrt()
            .ceil()
            .clamp(1.0, MAX_TRAVEL_SAMPLES);
        let mut step = 1.0;
        while step < steps {
            let part = step / steps;
            let mut axes = from.axes;
            for (value, end) in axes.iter_mut().zip(to.axes) {
                *value += (end - *value) * part;
            }
            let tip = from.pose.tip + (to.pose.tip - from.pose.tip) * part;
            let axes =
                self.machine.linear_axes(&tip, &axes).ok_or_else(|| refusal::unreachable(self, &to.pose, &to.axes))?;
            self.travel.check(&axes)?;
            step += 1.0;
        }
        Ok(())
    }
}

/// Derivative of the linear axes with respect to the tip.
#[derive(Debug, Clone, Copy)]
pub(super) struct AxisMap {
    /// Bits of the rotary angles.
    angles: [u64; 2],
    map: Matrix3<f64>,
    /// Lengths of its rows.
    lengths: [f64; 3],
    orthogonal: bool,
}

fn is_orthogonal(map: &Matrix3<f64>) -> bool {
    let off = map.transpose() * map - Matrix3::identity();
    off.iter().all(|part| part.abs() <= ORTHOGONAL_MAP)
}

/// Derivative of an affine map.
fn differences(map: impl Fn(&Point3<f64>) -> Option<Vector3<f64>>) -> Option<Matrix3<f64>> {
    // With a wide step the error is only the rounding of the arithmetic.
    const STEP_MM: f64 = 1024.0;
    let origin = map(&Point3::origin())?;
    let column = |direction: Vector3<f64>| Some((map(&Point3::from(direction * STEP_MM))? - origin) / STEP_MM);
    Some(Matrix3::from_columns(&[column(Vector3::x())?, column(Vector3::y())?, column(Vector3::z())?]))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use proptest::prelude::*;

    use super::*;
    use crate::config::Config;
    use crate::kinematics::machines::{Ay, Cb, Head, Mirrored};
    use crate::kinematics::{Limits, Machine, Pose};
    use crate::motion::geometry::ArcGeometry;
    use crate::options::{StretchMode, TcpFrame, Wrap};
    use crate::program::{Arc, Units};

    /// A placer with the travel of its linear axes limited, and with a machine zero where `zero`.
    fn placer<M: Machine>(travel_mm: f64, zero: bool) -> Placer {
        let mut config = Config::default();
        for letter in ['X', 'Y', 'Z'] {
            config.set_up.limits.insert(letter, Some(Limits { lower: -0.5 * travel_mm, upper: 0.5 * travel_mm }));
            if zero {
                config.set_up.machine_zero.insert(letter, 1.0);
            }
        }
        let machine = Box::new(config.set_up.machine::<M>().expect("valid"));
        let mut placer = Placer::new(machine, config.policy(), Units::Millimetres);
        placer.set_gauge_length(Some(100.0));
        placer
    }

    /// Whether the arcs need no travel, after the points of those before; where one does not, no point of it changes
    /// the travel.
    fn certified<M: Machine>(arcs: &[Arc], travel_mm: f64, zero: bool) -> Result<usize, TestCaseError> {
        let mut placer = placer::<M>(travel_mm, zero);
        let mut certified = 0;
        for arc in arcs {
            let Ok(start) = placer.shifted(arc.start.tip, &placer.zero()) else { break };
            let round = ArcGeometry::new(arc);
            let certain = placer.needs_no_travel(&start, round.diameter_mm(), |direction| round.bounds(direction));
            certified += usize::from(certain);
            let before = placer.travel.clone();
            let (_, map) = placer.axis_map(&start).expect("a map");
            let extremes = (0..3).flat_map(|row| round.extremes(map.row(row).transpose()));
            for part in extremes.chain((0..=100).map(|step| f64::from(step) / 100.0)) {
                let reached = placer.shifted(round.tip(part), &start);
                if certain {
                    prop_assert!(reached.is_ok());
                    prop_assert_eq!(&placer.travel, &before);
                }
            }
        }
        Ok(certified)
    }

    fn helix(centre: Point3<f64>, normal: [f64; 3], [radius, from, angle, rise]: [f64; 4]) -> Arc {
        let normal = UnitVector3::new_normalize(Vector3::from(normal));
        let aside = normal.cross(&Vector3::new(0.3, 0.7, -0.4)).normalize() * radius;
        let at = |angle: f64| centre + nalgebra::Rotation3::from_axis_angle(&normal, angle) * aside;
        let pose = |tip: Point3<f64>| Pose { tip, axis: Vector3::z_axis() };
        let end = at(from + angle) + normal.into_inner() * rise;
        Arc { start: pose(at(from)), end: pose(end), centre, normal, angle_rad: angle, feed: None }
    }

    /// Compares the map to words with the differences of words, at several rotary angles.
    fn compare_word_maps<M: Machine>() {
        let placer = placer::<M>(1e4, true);
        for (first, second) in [(0.0, 0.0), (0.3, 0.0), (-0.2, 1.1)] {
            let mut at = placer.zero();
            for (rotary, angle) in placer.rotary.axes.iter().zip([first, second]) {
                at.axes[rotary.index] = angle;
            }
            let (letters, map) = placer.orthogonal_map(&at).expect("an orthogonal map");
            assert_eq!(Some(letters), placer.linear.xyz);
            let expected = differences(|tip| placer.program_point(tip, &at)).expect("a map");
            assert!((map - expected).amax() < 1e-12, "{map} {expected}");
        }
    }

    #[test]
    fn the_map_to_words_is_that_of_their_differences() {
        compare_word_maps::<Cb>();
        compare_word_maps::<Head>();
        compare_word_maps::<Ay>();
        compare_word_maps::<Mirrored>();
    }

    #[test]
    fn an_arc_made_again_needs_no_travel() {
        let arc = helix(Point3::new(1.0, 2.0, 3.0), [0.0, 0.0, 1.0], [10.0, 0.3, TAU, 0.0]);
        assert_eq!(certified::<Cb>(&[arc; 3], 500.0, false).ok(), Some(2));
        assert_eq!(certified::<Cb>(&[arc; 3], 500.0, true).ok(), Some(3));
        assert_eq!(certified::<Cb>(&[arc; 3], 15.0, false).ok(), Some(0));
    }

    #[test]
    fn an_arc_that_may_need_more_digits_than_its_words_have_is_not_certain() {
        let mut config = Config::default();
        config.set_up.limits.extend(['X', 'Y', 'Z'].map(|letter| (letter, None)));
        let machine = Box::new(config.set_up.machine::<Cb>().expect("valid"));
        let mut placer = Placer::new(machine, config.policy(), Units::Millimetres);
        let most = 10_f64.powi(config.formats.linear_whole as i32);
        for (x, expected) in [(most - 100.0, true), (most - 10.0, false), (100.0 - most, true), (10.0 - most, false)] {
            let arc = helix(Point3::new(x, 2.0, 3.0), [0.0, 0.0, 1.0], [20.0, 0.0, TAU, 0.0]);
            let start = [0.0, PI].map(|angle| ArcGeometry::new(&arc).tip(angle / TAU)).into_iter();
            let start = start.min_by(|a, b| a.x.abs().total_cmp(&b.x.abs())).expect("two points");
            let start = placer.shifted(start, &placer.zero()).expect("within the digits");
            let round = ArcGeometry::new(&arc);
            let certain = placer.needs_no_travel(&start, round.diameter_mm(), |direction| round.bounds(direction));
            assert_eq!(certain, expected, "{x}");
        }
    }

    /// Whether the C of a position may be that many degrees, in words that have three digits before the point.
    fn may_be(c_deg: f64, mode: StretchMode, change: impl Fn(&mut Config)) -> bool {
        let mut config = Config::default();
        config.formats.rotary_whole = 3;
        change(&mut config);
        let machine = Box::new(config.set_up.machine::<Cb>().expect("valid"));
        let mut placer = Placer::new(machine, config.policy(), Units::Millimetres);
        placer.set_mode(mode);
        let words = [placer.scale().word(c_deg.to_radians()), 0];
        let pose = Pose { tip: Point3::new(1.0, 2.0, 3.0), axis: Vector3::z_axis() };
        placer.with_rotary_words(&pose, &placer.zero(), &words).is_ok()
    }

    #[test]
    fn a_written_rotary_word_has_no_more_digits_than_it_may() {
        for mode in [StretchMode::Axes, StretchMode::Tcp] {
            for turning in [TcpFrame::TableAtZero, TcpFrame::NotTurning] {
                let frame = |config: &mut Config| config.motion.tip.tcp_frame = Some(turning);
                for (c_deg, expected) in [(999.9, true), (-999.9, true), (1000.0, false), (-1000.0, false)] {
                    assert_eq!(may_be(c_deg, mode, frame), expected, "{mode:?} {turning:?} {c_deg}");
                    // Within one revolution it has three.
                    let wrapped = |config: &mut Config| {
                        frame(config);
                        config.motion.rotaries.wrap.insert('C', Wrap::Positive);
                    };
                    assert!(may_be(c_deg, mode, wrapped), "{mode:?} {turning:?} {c_deg}");
                }
                // The zero of the words is at 90° of the axis.
                let offset = |config: &mut Config| {
                    frame(config);
                    config.set_up.rotary_offset.insert('C', FRAC_PI_2);
                };
                for (c_deg, expected) in [(1089.9, true), (-909.9, true), (1090.0, false), (-910.0, false)] {
                    assert_eq!(may_be(c_deg, mode, offset), expected, "{mode:?} {turning:?} {c_deg}");
                }
            }
        }
    }

    proptest! {
        /// A position with the same tool axis is the present one with another tip, to the last bit.
        #[test]
        fn a_position_with_the_same_tool_axis_is_the_present_one_with_another_tip(
            axis in prop::array::uniform3(-0.4_f64..0.4),
            tips in prop::array::uniform2(prop::array::uniform3(-50.0_f64..50.0)),
            change in prop::sample::select(vec![0.0_f64, 0.0, 1e-7, 0.1]),
        ) {
            let [start, end] = tips.map(Point3::from);
            let tilted = |x: f64| UnitVector3::new_normalize(Vector3::new(x, axis[1], 1.0));
            let (first, then) = (tilted(axis[0]), tilted(axis[0] + change));
            let mut placer = placer::<Cb>(500.0, false);
            let here = placer.place(&Pose { tip: start, axis: first }, &placer.zero(), false, None).expect("a place");
            let here = placer.place(&Pose { tip: start, axis: first }, &here, true, None).expect("a place");
            // Near the pole a cut may not change the tool axis.
            let Ok(to) = placer.place(&Pose { tip: end, axis: then }, &here, true, None) else { return Ok(()) };
            if first == then {
                prop_assert_eq!(placer.shifted(end, &here).ok(), Some(to));
            }
        }

        /// No point of an arc that is said to need no travel changes it.
        #[test]
        fn an_arc_that_needs_no_travel_has_no_point_that_does(
            circles in prop::collection::vec(
                (
                    prop::array::uniform3(-5.0_f64..5.0),
                    prop::sample::select(vec![[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.6, 0.0, 0.8], [1.0, 1.0, 1.0]]),
                    prop::sample::select(vec![1.0_f64, 2.5, 10.0]),
                    0.0_f64..TAU,
                    prop::sample::select(vec![0.1_f64, 3.0, TAU, 15.0]),
                    prop::sample::select(vec![0.0_f64, 0.0, 1.0, -2.0]),
                ),
                1..10,
            ),
            travel in 15.0_f64..40.0,
            zero: bool,
        ) {
            let arcs = circles.into_iter().map(|(centre, normal, radius, from, angle, rise)| {
                helix(Point3::from(centre), normal, [radius, from, angle, rise])
            });
            let arcs: Vec<Arc> = arcs.collect();
            certified::<Cb>(&arcs, travel, zero)?;
            certified::<Head>(&arcs, travel, zero)?;
            certified::<Ay>(&arcs, travel, zero)?;
            certified::<Mirrored>(&arcs, travel, zero)?;
        }
    }
}
