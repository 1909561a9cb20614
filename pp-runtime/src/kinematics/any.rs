//! A machine as the pipeline sees it: one trait object, whatever its number of axes.
//!
//! Reader, planner, controls and check are compiled once, for `dyn AnyMachine`. A machine's binary then consists of its
//! kinematics, their wrapper, and a link. The price is an indirect call for each pose.
//!
//! The methods have the names that they have in [`Machine`], so import one of the two traits, not both: on a machine
//! whose type is known a call would be ambiguous. Methods of `dyn AnyMachine` need no import.
//!
//! ```
//! use pp_runtime::kinematics::AnyMachine;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let machines: [Box<dyn AnyMachine>; 1] = [Box::new(Trunnion::default())];
//! let letters: String = machines[0].axes().iter().map(|axis| axis.letter).collect();
//! assert_eq!(letters, "CAXYZ");
//! ```

use nalgebra::{Point3, UnitVector3, Vector3};

use super::words::PoseWords;
use super::{
    Axis, AxisKind, BlockCurves, BlockDeviation, CSource, Dimension, Explanation, Invalid, Joint, Machine, MotionBound,
    Pose, RotaryAngles, RoughDeviation, Side, Solutions, Unreachable,
};

/// Most axes that a chain can have: X Y Z U V W A B C.
pub const MAX_AXES: usize = 9;

/// Axis values in chain order, mm and rad; zero after the last axis of the chain.
pub type AxisValues = [f64; MAX_AXES];

/// The object-safe form of [`Machine`], implemented for every `Machine` and for nothing else.
///
/// Each method does what the method or constant of that name does in [`Machine`]; axis values have a fixed length. No
/// other crate can implement it: `Words` is not public.
pub trait AnyMachine: PoseWords + Send + Sync {
    /// [`Machine::NAME`].
    fn name(&self) -> &'static str;
    /// [`Machine::AXES`]; at most [`MAX_AXES`] of them.
    fn axes(&self) -> &'static [Axis];
    /// [`Machine::DIMENSIONS`].
    fn dimensions(&self) -> &'static [Dimension];
    /// [`Machine::HELD`].
    fn held(&self) -> AxisValues;
    /// [`Machine::UP`].
    fn up(&self) -> UnitVector3<f64>;
    /// [`Machine::EXPLANATION`].
    fn explanation(&self) -> &'static Explanation;
    /// [`Machine::C_SOURCE`].
    fn c_source(&self) -> CSource;

    /// A copy of the machine, with its set-up.
    fn to_boxed(&self) -> Box<dyn AnyMachine>;

    /// [`Machine::dimension`].
    ///
    /// # Panics
    /// If `index` is not below the number of dimensions.
    fn dimension(&self, index: usize) -> f64;
    /// [`Machine::set_dimension`].
    ///
    /// # Panics
    /// If `index` is not below the number of dimensions.
    fn set_dimension(&mut self, index: usize, value: f64);
    /// [`Machine::set_up`].
    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64);
    /// [`Machine::validate`].
    ///
    /// # Errors
    /// [`Invalid`] names the number or the condition.
    fn validate(&self) -> Result<(), Invalid>;
    /// [`Machine::joint`].
    ///
    /// # Panics
    /// If `index` is not below the number of axes.
    fn joint(&self, index: usize) -> Joint;
    /// [`Machine::tool_axis`].
    fn tool_axis(&self) -> UnitVector3<f64>;
    /// [`Machine::forward_kinematics`].
    fn forward_kinematics(&self, axes: &AxisValues) -> Pose;
    /// [`Machine::inverse_kinematics`].
    fn inverse_kinematics(&self, pose: &Pose, held: &AxisValues) -> Solutions<AxisValues>;
    /// [`Machine::rotary_axes`].
    fn rotary_axes(&self, axis: &UnitVector3<f64>, held: &AxisValues) -> Solutions<RotaryAngles>;
    /// Sets the linear axes of some axis values to those of [`Machine::linear_axes`]. Returns false, and changes
    /// nothing, where there are none.
    fn set_linear_axes(&self, tip: &Point3<f64>, axes: &mut AxisValues) -> bool;
    /// [`Machine::reach`].
    ///
    /// # Errors
    /// [`Unreachable`] with the reason in machine-shop words.
    fn reach(&self, axis: &UnitVector3<f64>, held: &AxisValues) -> Result<(), Unreachable>;
    /// [`Machine::motion`].
    fn motion(&self, from: &AxisValues, to: &AxisValues) -> MotionBound;
    /// Whether a rough bound of the deviation of a block is below `most`; where it is not, [`Machine::motion`].
    fn motion_within(&self, from: &AxisValues, to: &AxisValues, most: &RoughDeviation) -> BlockDeviation;
    /// [`Machine::rates`].
    fn rates(&self, axes: &AxisValues, change: &AxisValues) -> (Vector3<f64>, Vector3<f64>);
}

/// Axis values of a machine in the fixed length. A machine with more axes does not compile where it becomes an
/// [`AnyMachine`].
#[inline]
fn padded<M: Machine>(axes: &M::Axes) -> AxisValues {
    const { assert!(M::AXES.len() <= MAX_AXES, "a chain has at most nine axes: X Y Z U V W A B C") };
    let mut values = [0.0; MAX_AXES];
    values[..M::AXES.len()].copy_from_slice(&axes.as_ref()[..M::AXES.len()]);
    values
}

/// Axis values of the fixed length as the machine has them.
#[inline]
pub(super) fn trimmed<M: Machine>(values: &AxisValues) -> M::Axes {
    let mut axes = M::HELD;
    axes.as_mut()[..M::AXES.len()].copy_from_slice(&values[..M::AXES.len()]);
    axes
}

/// The certified bound of a block.
#[cold]
fn full_bound(curves: BlockCurves) -> BlockDeviation {
    BlockDeviation::UpTo(curves.bound())
}

/// A linear axis that rotates with a rotary one, which is nearer to the bed: first the rotary axis. Held axes do not
/// count.
pub(crate) fn carried(axes: &[Axis]) -> Option<[&Axis; 2]> {
    let solved = |side: Side| axes.iter().filter(move |axis| !axis.held && axis.side == side);
    let (head, table): (Vec<&Axis>, Vec<&Axis>) =
        (solved(Side::Tool).collect(), solved(Side::Workpiece).rev().collect());
    [head, table].iter().find_map(|from_bed| {
        let carrier = from_bed.iter().position(|axis| axis.kind == AxisKind::Rotary)?;
        let linear = from_bed[carrier..].iter().position(|axis| axis.kind == AxisKind::Linear)?;
        Some([from_bed[carrier + linear - 1], from_bed[carrier + linear]])
    })
}

impl<M: Machine> AnyMachine for M {
    fn name(&self) -> &'static str {
        M::NAME
    }

    fn axes(&self) -> &'static [Axis] {
        M::AXES
    }

    fn dimensions(&self) -> &'static [Dimension] {
        M::DIMENSIONS
    }

    fn held(&self) -> AxisValues {
        padded::<M>(&M::HELD)
    }

    fn up(&self) -> UnitVector3<f64> {
        UnitVector3::new_normalize(Vector3::from(M::UP))
    }

    fn explanation(&self) -> &'static Explanation {
        M::EXPLANATION
    }

    fn c_source(&self) -> CSource {
        M::C_SOURCE
    }

    fn to_boxed(&self) -> Box<dyn AnyMachine> {
        Box::new(self.clone())
    }

    fn dimension(&self, index: usize) -> f64 {
        Machine::dimension(self, index)
    }

    fn set_dimension(&mut self, index: usize, value: f64) {
        Machine::set_dimension(self, index, value);
    }

    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64) {
        Machine::set_up(self, part_origin, gauge_length);
    }

    fn validate(&self) -> Result<(), Invalid> {
        Machine::validate(self)
    }

    fn joint(&self, index: usize) -> Joint {
        Machine::joint(self, index)
    }

    fn tool_axis(&self) -> UnitVector3<f64> {
        Machine::tool_axis(self)
    }

    fn forward_kinematics(&self, axes: &AxisValues) -> Pose {
        Machine::forward_kinematics(self, &trimmed::<M>(axes))
    }

    fn inverse_kinematics(&self, pose: &Pose, held: &AxisValues) -> Solutions<AxisValues> {
        Machine::inverse_kinematics(self, pose, &trimmed::<M>(held)).map(padded::<M>)
    }

    fn rotary_axes(&self, axis: &UnitVector3<f64>, held: &AxisValues) -> Solutions<RotaryAngles> {
        Machine::rotary_axes(self, axis, &trimmed::<M>(held))
    }

    fn set_linear_axes(&self, tip: &Point3<f64>, axes: &mut AxisValues) -> bool {
        let solved = Machine::linear_axes(self, tip, &trimmed::<M>(axes));
        if let Some(solved) = &solved {
            axes[..M::AXES.len()].copy_from_slice(&solved.as_ref()[..M::AXES.len()]);
        }
        solved.is_some()
    }

    fn reach(&self, axis: &UnitVector3<f64>, held: &AxisValues) -> Result<(), Unreachable> {
        Machine::reach(self, axis, &trimmed::<M>(held))
    }

    fn motion(&self, from: &AxisValues, to: &AxisValues) -> MotionBound {
        Machine::motion(self, &trimmed::<M>(from), &trimmed::<M>(to))
    }

    fn motion_within(&self, from: &AxisValues, to: &AxisValues, most: &RoughDeviation) -> BlockDeviation {
        let curves = self.curves(&trimmed::<M>(from), &trimmed::<M>(to));
        match curves.rough_bound(most) {
            Some(MotionBound { tip_rate, .. }) => BlockDeviation::Below { tip_rate },
            None => full_bound(curves),
        }
    }

    fn rates(&self, axes: &AxisValues, change: &AxisValues) -> (Vector3<f64>, Vector3<f64>) {
        Machine::rates(self, &trimmed::<M>(axes), &trimmed::<M>(change))
    }
}

impl dyn AnyMachine + '_ {
    /// [`Machine::linear_axes`].
    #[must_use]
    pub fn linear_axes(&self, tip: &Point3<f64>, axes: &AxisValues) -> Option<AxisValues> {
        let mut solved = *axes;
        self.set_linear_axes(tip, &mut solved).then_some(solved)
    }
}

impl Clone for Box<dyn AnyMachine> {
    fn clone(&self) -> Self {
        self.to_boxed()
    }
}

impl core::fmt::Debug for dyn AnyMachine {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.name())
    }
}
