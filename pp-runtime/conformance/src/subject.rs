//! A machine as a trait object, so that the checks are compiled once and not once per machine.

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::kinematics::{
    Axis, Dimension, Invalid, Joint, Machine, MotionBound, Pose, RotaryAngles, RoughDeviation, Solution, Unreachable,
};

/// One solution of the inverse kinematics.
pub(crate) type Found = Solution<Vec<f64>>;

/// The parts of [`Machine`] that the checks use, with axis values as slices.
pub(crate) trait Subject {
    fn name(&self) -> &'static str;
    fn axes(&self) -> &'static [Axis];
    fn dimensions(&self) -> &'static [Dimension];
    fn default_held(&self) -> Vec<f64>;
    /// The same machine, to be changed.
    fn copy(&self) -> Box<dyn Subject>;
    fn dimension(&self, index: usize) -> f64;
    fn set_dimension(&mut self, index: usize, value: f64);
    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64);
    fn validate(&self) -> Result<(), Invalid>;
    fn joint(&self, index: usize) -> Joint;
    fn tool_axis(&self) -> UnitVector3<f64>;
    fn forward(&self, axes: &[f64]) -> Pose;
    fn inverse(&self, pose: &Pose, held: &[f64]) -> Vec<Found>;
    fn rotary_axes(&self, axis: &UnitVector3<f64>, held: &[f64]) -> Vec<Solution<RotaryAngles>>;
    fn linear_axes(&self, tip: &Point3<f64>, axes: &[f64]) -> Option<Vec<f64>>;
    fn reach(&self, axis: &UnitVector3<f64>, held: &[f64]) -> Result<(), Unreachable>;
    fn motion(&self, from: &[f64], to: &[f64]) -> MotionBound;
    fn rough_motion(&self, from: &[f64], to: &[f64]) -> Option<MotionBound>;
    fn rates(&self, axes: &[f64], change: &[f64]) -> (Vector3<f64>, Vector3<f64>);
}

/// The one implementation of [`Subject`].
pub(crate) struct Erased<M>(pub(crate) M);

fn array<M: Machine>(values: &[f64]) -> M::Axes {
    let mut array = M::Axes::default();
    array.as_mut().copy_from_slice(values);
    array
}

impl<M: Machine> Subject for Erased<M> {
    fn name(&self) -> &'static str {
        M::NAME
    }
    fn axes(&self) -> &'static [Axis] {
        M::AXES
    }
    fn dimensions(&self) -> &'static [Dimension] {
        M::DIMENSIONS
    }
    fn default_held(&self) -> Vec<f64> {
        M::HELD.as_ref().to_vec()
    }
    fn copy(&self) -> Box<dyn Subject> {
        Box::new(Self(self.0.clone()))
    }
    fn dimension(&self, index: usize) -> f64 {
        self.0.dimension(index)
    }
    fn set_dimension(&mut self, index: usize, value: f64) {
        self.0.set_dimension(index, value);
    }
    fn set_up(&mut self, part_origin: Vector3<f64>, gauge_length: f64) {
        self.0.set_up(part_origin, gauge_length);
    }
    fn validate(&self) -> Result<(), Invalid> {
        self.0.validate()
    }
    fn joint(&self, index: usize) -> Joint {
        self.0.joint(index)
    }
    fn tool_axis(&self) -> UnitVector3<f64> {
        self.0.tool_axis()
    }
    fn forward(&self, axes: &[f64]) -> Pose {
        self.0.forward_kinematics(&array::<M>(axes))
    }
    fn inverse(&self, pose: &Pose, held: &[f64]) -> Vec<Found> {
        let solutions = self.0.inverse_kinematics(pose, &array::<M>(held));
        solutions
            .iter()
            .map(|solution| Found {
                axes: solution.axes.as_ref().to_vec(),
                branch: solution.branch,
                singular: solution.singular,
                deviation: solution.deviation,
            })
            .collect()
    }
    fn rotary_axes(&self, axis: &UnitVector3<f64>, held: &[f64]) -> Vec<Solution<RotaryAngles>> {
        self.0.rotary_axes(axis, &array::<M>(held)).to_vec()
    }
    fn linear_axes(&self, tip: &Point3<f64>, axes: &[f64]) -> Option<Vec<f64>> {
        self.0.linear_axes(tip, &array::<M>(axes)).map(|axes| axes.as_ref().to_vec())
    }
    fn reach(&self, axis: &UnitVector3<f64>, held: &[f64]) -> Result<(), Unreachable> {
        self.0.reach(axis, &array::<M>(held))
    }
    fn motion(&self, from: &[f64], to: &[f64]) -> MotionBound {
        self.0.motion(&array::<M>(from), &array::<M>(to))
    }
    fn rough_motion(&self, from: &[f64], to: &[f64]) -> Option<MotionBound> {
        let most = RoughDeviation { tip: f64::INFINITY, axis: f64::INFINITY, axis_step: f64::INFINITY };
        self.0.curves(&array::<M>(from), &array::<M>(to)).rough_bound(&most)
    }
    fn rates(&self, axes: &[f64], change: &[f64]) -> (Vector3<f64>, Vector3<f64>) {
        self.0.rates(&array::<M>(axes), &array::<M>(change))
    }
}
