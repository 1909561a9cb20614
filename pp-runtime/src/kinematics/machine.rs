//! The trait of a machine, and the data that describes its axes.

use core::fmt::Debug;

use approx::AbsDiffEq;
use nalgebra::{Point3, UnitVector3, Vector3};

use super::{
    BlockCurves, CSource, Explanation, Invalid, MotionBound, RotaryAngles, Solutions, Unreachable, curves_of_joints,
    math, rates_of_joints,
};

/// Tool tip and tool axis in the workpiece frame; no spin about the tool.
///
/// With the feature `serde` as `{"tip": [x, y, z], "axis": [i, j, k]}`; an axis that is not a unit vector is refused.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Pose {
    /// Tool tip, mm.
    pub tip: Point3<f64>,
    /// Unit vector from the tip to the spindle.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "unit_vector"))]
    pub axis: UnitVector3<f64>,
}

/// Largest differences between two poses, for the macros of the crate `approx`:
/// `assert_abs_diff_eq!(a, b, epsilon = ..)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseTolerance {
    /// Distance of the tips, mm.
    pub tip_mm: f64,
    /// Angle between the tool axes, rad.
    pub axis_rad: f64,
}

impl AbsDiffEq for Pose {
    type Epsilon = PoseTolerance;

    fn default_epsilon() -> PoseTolerance {
        PoseTolerance { tip_mm: f64::EPSILON, axis_rad: f64::EPSILON }
    }

    /// A pose with NaN is equal to none.
    fn abs_diff_eq(&self, other: &Self, largest: PoseTolerance) -> bool {
        let angle = math::atan2(self.axis.cross(&other.axis).norm(), self.axis.dot(&other.axis));
        (self.tip - other.tip).norm() <= largest.tip_mm && angle <= largest.axis_rad
    }
}

/// Largest difference of the length of a tool axis from 1 where one is read: the rounding of a unit vector.
#[cfg(feature = "serde")]
const UNIT: f64 = 1e-12;

/// Reads a unit vector.
#[cfg(feature = "serde")]
fn unit_vector<'de, D: serde::Deserializer<'de>>(source: D) -> Result<UnitVector3<f64>, D::Error> {
    let vector: Vector3<f64> = serde::Deserialize::deserialize(source)?;
    let length = super::math::sqrt(vector.norm_squared());
    if (length - 1.0).abs() <= UNIT {
        Ok(UnitVector3::new_unchecked(vector))
    } else {
        Err(serde::de::Error::custom(format_args!("the length of the tool axis is {length}, and must be 1")))
    }
}

/// Kind of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisKind {
    /// X Y Z U V W; values in mm.
    Linear,
    /// A B C; values in rad.
    Rotary,
}

/// Side of the machine frame (`|` in the chain) that carries an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Between the frame and the workpiece: a table axis.
    Workpiece,
    /// Between the frame and the tool: a head or column axis.
    Tool,
}

/// Sign of an axis word. `Plus` is ISO 841: a positive word moves the tool in the positive sense relative to the
/// workpiece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// Sign of ISO 841.
    Plus,
    /// Sign opposite to ISO 841.
    Minus,
}

impl Sign {
    /// `1.0` or `-1.0`.
    #[must_use]
    pub const fn factor(self) -> f64 {
        match self {
            Self::Plus => 1.0,
            Self::Minus => -1.0,
        }
    }
}

/// Travel of an axis, inclusive; mm or rad.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Limits {
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
}

/// One axis of the chain: the data that no dimension can change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Address of the axis: X Y Z U V W A B C.
    pub letter: char,
    /// Linear or rotary.
    pub kind: AxisKind,
    /// Workpiece side or tool side of the frame.
    pub side: Side,
    /// Sign of the word.
    pub sign: Sign,
    /// Declared travel: of a rotary axis in axis values, rad; of a linear axis in machine coordinates, mm. `None` is
    /// endless (`free`). A default: configuration may change it.
    pub limits: Option<Limits>,
    /// Declared largest speed, mm/min or rad/min; `None` is unlimited. A default: configuration may change it.
    pub speed: Option<f64>,
    /// True for an axis of `hold`: an input of the inverse kinematics, not solved for.
    pub held: bool,
}

/// Quantity of a dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DimensionKind {
    /// Millimetres.
    Length,
    /// Radians in the struct, degrees in configuration files.
    Angle,
}

/// A named dimension of the declaration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimension {
    /// Name of the field.
    pub name: &'static str,
    /// Length or angle.
    pub kind: DimensionKind,
    /// Declared value, mm or rad.
    pub default: f64,
}

/// One joint of the chain for the current set-up, transcribed from the declaration.
///
/// A linear joint is `Trans(sign · q · direction)`; a rotary joint is
/// `Trans(point) · Rot(direction, sign · q) · Trans(-point)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Unit direction with all axes at zero, machine frame.
    pub direction: UnitVector3<f64>,
    /// A point of the centre line in the workpiece frame of the zero position, mm; the origin for a linear joint.
    pub point: Point3<f64>,
    /// `1.0` or `-1.0`.
    pub sign: f64,
}

/// A machine tool with closed-form kinematics; implemented by [`machine!`](crate::machine).
///
/// Zero position: with all axes at zero the tool tip is on the workpiece origin. Axis values are `[f64; N]` in
/// chain order, mm and radians, held axes included.
///
/// Axis values have the length of the chain, so that the generated functions stay straight-line code. Reader, planner,
/// controls and check are compiled once for all machines: they use the object-safe form, `AnyMachine`.
pub trait Machine: Default + Clone + Send + Sync + 'static {
    /// `[f64; N]` in chain order.
    type Axes: Copy + Default + PartialEq + Debug + Send + Sync + 'static + AsRef<[f64]> + AsMut<[f64]>;

    /// Identifier of the declared struct.
    const NAME: &'static str;
    /// The axes in chain order.
    const AXES: &'static [Axis];
    /// The named dimensions in the order of `dims`.
    const DIMENSIONS: &'static [Dimension];
    /// Zeros, and the declared values of `hold`.
    const HELD: Self::Axes;
    /// Unit direction that is up at the machine, machine frame with all axes at zero.
    const UP: [f64; 3] = [0.0, 0.0, 1.0];
    /// Formulas, branches, singular set and proofs in words.
    const EXPLANATION: &'static Explanation;
    /// The same kinematics as C99, from the same formulas. Empty for a machine written by hand.
    const C_SOURCE: CSource = CSource::EMPTY;

    /// Value of a dimension, mm or rad.
    ///
    /// # Panics
    /// If `index` is not below `DIMENSIONS.len()`.
    fn dimension(&self, index: usize) -> f64;

    /// Changes a dimension, mm or rad; see [`validate`](Self::validate).
    ///
    /// # Panics
    /// If `index` is not below `DIMENSIONS.len()`.
    fn set_dimension(&mut self, index: usize, value: f64);

    /// Places the workpiece and the tool: part zero from the table's reference point (mm, table directions), and the
    /// distance from gauge line to tool tip (mm).
    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64);

    /// Checks that all numbers are finite and that the side conditions of the proofs hold.
    ///
    /// # Errors
    /// [`Invalid`] names the number or the condition.
    fn validate(&self) -> Result<(), Invalid>;

    /// Direction, centre line and sign of an axis for the current set-up, as declared.
    ///
    /// # Panics
    /// If `index` is not below `AXES.len()`.
    fn joint(&self, index: usize) -> Joint;

    /// Unit vector from tip to spindle with all axes at zero.
    fn tool_axis(&self) -> UnitVector3<f64>;

    /// Pose of the tool in the workpiece frame for axis values (mm, rad).
    fn forward_kinematics(&self, axes: &Self::Axes) -> Pose;

    /// Axis values that bring the tool to `pose`: at most two, rotary values in (-π, π], first branch first.
    ///
    /// `held` supplies the values of held axes, and of a rotary that is free at a singular pose: the solution holds
    /// that value as it was given, whole turns included. If there is no solution, [`reach`](Self::reach) gives the
    /// reason.
    fn inverse_kinematics(&self, pose: &Pose, held: &Self::Axes) -> Solutions<Self::Axes>;

    /// Angles of the solved rotary axes that give the tool the axis `axis`: those of
    /// [`inverse_kinematics`](Self::inverse_kinematics), without the linear axes, and whether or not these are
    /// degenerate.
    ///
    /// A machine written by hand may leave it out.
    fn rotary_axes(&self, axis: &UnitVector3<f64>, held: &Self::Axes) -> Solutions<RotaryAngles> {
        let pose = Pose { tip: Point3::origin(), axis: *axis };
        self.inverse_kinematics(&pose, held).map(|axes| {
            let mut angles = RotaryAngles::default();
            let solved = Self::AXES.iter().zip(axes.as_ref());
            let solved = solved.filter(|(axis, _)| axis.kind == AxisKind::Rotary && !axis.held);
            angles.iter_mut().zip(solved).for_each(|(angle, (_, value))| *angle = *value);
            angles
        })
    }

    /// Linear axes that bring the tip to `tip` while rotary and held values stay as they are in `axes`.
    ///
    /// `None` where the linear axes are degenerate, see [`SMALLEST_DETERMINANT`](super::SMALLEST_DETERMINANT).
    fn linear_axes(&self, tip: &Point3<f64>, axes: &Self::Axes) -> Option<Self::Axes>;

    /// Checks that a tool axis can be reached.
    ///
    /// # Errors
    /// [`Unreachable`], with the reason.
    fn reach(&self, axis: &UnitVector3<f64>, held: &Self::Axes) -> Result<(), Unreachable>;

    /// Certified bound of the deviation of tip and tool axis from the straight, evenly rotating motion while every axis
    /// moves linearly from `from` to `to`; never below the true deviation.
    fn motion(&self, from: &Self::Axes, to: &Self::Axes) -> MotionBound {
        self.curves(from, to).bound()
    }

    /// Derivatives of tip and tool axis in the middle of a block in which every axis moves linearly, from which
    /// [`motion`](Self::motion) is computed.
    ///
    /// [`machine!`](crate::machine) emits it specialised to the machine. A machine written by hand may leave it out:
    /// the same curves are then computed from its joints.
    fn curves(&self, from: &Self::Axes, to: &Self::Axes) -> BlockCurves {
        curves_of_joints(self, from, to)
    }

    /// First derivatives of tip (mm) and tool axis at `axes` while the axes move by `change` in a unit of time.
    ///
    /// As for [`curves`](Self::curves), a machine written by hand may leave it out.
    fn rates(&self, axes: &Self::Axes, change: &Self::Axes) -> (Vector3<f64>, Vector3<f64>) {
        rates_of_joints(self, axes, change)
    }
}

#[cfg(test)]
mod tests {
    use approx::abs_diff_eq;

    use super::*;

    #[test]
    fn poses_are_compared_by_the_distance_of_their_tips_and_the_angle_between_their_axes() {
        let pose = |tip, axis: [f64; 3]| Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(axis.into()) };
        let one = pose([1.0, 2.0, 3.0], [0.0, 0.0, 1.0]);
        let same =
            |other: &Pose, tip_mm, axis_rad| abs_diff_eq!(one, other, epsilon = PoseTolerance { tip_mm, axis_rad });
        let other = pose([4.0, 6.0, 3.0], [0.0, 1.0, 1.0]);
        let angle = core::f64::consts::FRAC_PI_4;
        assert!(same(&other, 5.0 + 1e-12, angle + 1e-12) && same(&one, 0.0, 0.0));
        assert!(!same(&other, 5.0 - 1e-12, angle + 1e-12) && !same(&other, 5.0 + 1e-12, angle - 1e-12));
        assert!(!same(&pose([1.0, 2.0, 3.0], [0.0, 0.0, -1.0]), 1.0, 3.0), "the opposite direction");
        let infinite = |other: &Pose| same(other, f64::INFINITY, f64::INFINITY);
        assert!(infinite(&other));
        assert!(!infinite(&pose([1.0, f64::NAN, 3.0], [0.0, 0.0, 1.0])));
        assert!(!infinite(&pose([1.0, 2.0, 3.0], [0.0, 0.0, f64::NAN])));
    }
}
