//! Words that are coordinates of the tip in a frame of the control, and the map from the workpiece to the words.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Point3, UnitVector3, Vector3};

use crate::nc::whole_units;

use super::frame::{WordMap, no_plane};
use super::refusal;
use super::tilted_plane::{PlaneAbility, PoseRule, TiltedPlane, plane_across};
use super::{AxisPosition, Placer, too_large};
use crate::motion::fault::Fault;
use crate::motion::geometry::angle_between;
use crate::motion::rotary::Rotary;

/// Largest deviation of a map from an orthogonal one: rounding of the arithmetic of angles.
const ORTHOGONAL: f64 = 1e-9;

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
    /// of `at`: one row for each word, one column for each direction of the workpiece frame.
    pub(crate) fn program_map(&self, at: &AxisPosition) -> Option<([usize; 3], Matrix3<f64>)> {
        let letters = self.linear.xyz?;
        if !self.frame.counts_tip()
            && let Some((solved, map)) = self.axis_map(at)
            && let [Some(x), Some(y), Some(z)] = letters.map(|letter| solved.iter().position(|index| *index == letter))
        {
            // A word is an axis value and a constant.
            return Some((letters, Matrix3::from_rows(&[map.row(x), map.row(y), map.row(z)])));
        }
        Some((letters, differences(|tip| self.program_point(tip, at))?))
    }

    /// The same as [`Placer::program_map`], if it is orthogonal: the words keep angles and lengths of the tip path.
    pub(crate) fn orthogonal_map(&self, at: &AxisPosition) -> Option<([usize; 3], Matrix3<f64>)> {
        self.program_map(at).filter(|(_, map)| {
            let off = map.transpose() * map - Matrix3::identity();
            off.iter().all(|part| part.abs() <= ORTHOGONAL)
        })
    }

    /// Positions of the solved linear axes, and the derivative of their values with respect to the tip at the rotary
    /// angles of `at`.
    pub(crate) fn axis_map(&self, at: &AxisPosition) -> Option<([usize; 3], Matrix3<f64>)> {
        let solved = *self.linear.solved.first_chunk()?;
        let bits = |rotary: &Rotary| at.axes[rotary.index].to_bits();
        let angles = std::array::from_fn(|axis| self.rotary.axes.get(axis).map_or(0, bits));
        if let Some((_, map)) = self.last_map.get().filter(|(known, _)| *known == angles) {
            return Some((solved, map));
        }
        let values = |tip: &Point3<f64>| {
            let axes = self.machine.linear_axes(tip, &at.axes)?;
            Some(Vector3::from(solved.map(|index| axes[index])))
        };
        let map = differences(values)?;
        self.last_map.set(Some((angles, map)));
        Some((solved, map))
    }

    /// Computes the linear axes and words of a position whose words are coordinates of the tip.
    pub(crate) fn solve_tip(&self, place: &mut AxisPosition, map: &WordMap) -> Result<(), Fault> {
        let mut written = map.words(&place.pose.tip);
        let letters = self.frame.letters();
        for (index, value) in letters.into_iter().zip(written.iter_mut()) {
            let units =
                whole_units(*value, self.linear.units_per_mm).ok().filter(|units| units.abs() < self.bounds[index]);
            let units = units.ok_or_else(|| too_large(self.chain[index].letter))?;
            place.words[index] = units;
            *value = units as f64 / self.linear.units_per_mm;
        }
        let reached = map.tip(&written);
        let axes = self.machine.linear_axes(&reached, &place.axes);
        place.axes = axes.ok_or_else(|| refusal::unreachable(self, &place.pose, &place.axes))?;
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

    /// The tool axis that a plane at a position has; refused where indexed axes cannot take it: the control would rotate them
    /// off their steps.
    pub(crate) fn axis_of_plane(&self, place: &AxisPosition) -> Result<UnitVector3<f64>, Fault> {
        let axis = place.pose.axis;
        if !self.has_indexed_axes() {
            return Ok(axis);
        }
        let off = angle_between(&self.machine.forward_kinematics(&place.axes).axis, &axis);
        if off <= 2.0 * self.rotary.scale.angle(1) {
            return Ok(axis);
        }
        let degrees = off.to_degrees();
        let text = format_args!("the steps of the indexed axes are {degrees:.4}° off the tool axis of this plane");
        Err(Fault::new(text)
            .help("move the tool axis of the operation to a step in CAM, or post it with `mode = \"axes\"`"))
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
    pub(crate) fn check_between(&mut self, from: &AxisPosition, to: &AxisPosition) -> Result<(), Fault> {
        if !self.frame.counts_tip() || !self.travel.limited() {
            return Ok(());
        }
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

/// Derivative of an affine map.
fn differences(map: impl Fn(&Point3<f64>) -> Option<Vector3<f64>>) -> Option<Matrix3<f64>> {
    // With a wide step the error is only the rounding of the arithmetic.
    const STEP_MM: f64 = 1024.0;
    let origin = map(&Point3::origin())?;
    let column = |direction: Vector3<f64>| Some((map(&Point3::from(direction * STEP_MM))? - origin) / STEP_MM);
    Some(Matrix3::from_columns(&[column(Vector3::x())?, column(Vector3::y())?, column(Vector3::z())?]))
}
