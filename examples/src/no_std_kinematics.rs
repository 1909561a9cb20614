//! Kinematics without an operating system, as in firmware: inverse and forward kinematics of one pose.
//!
//! Nothing here needs `std` or allocates. A separate crate would declare `#![no_std]` and depend on `pp-runtime` with
//! `default-features = false`.

use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::machine;
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};

machine! {
    /// Rotary table on a tilting table.
    pub struct Table;
    chain: C B | X Y Z;
    d = (0, 0, 150);
}

/// Axis values of the first branch for a tip and a tilted tool axis in the workpiece frame, and the pose of these
/// values.
///
/// `None` where the machine cannot reach the tool axis.
#[must_use]
pub fn there_and_back(tip: [f64; 3], leaning: [f64; 3]) -> Option<([f64; 5], Pose)> {
    let machine = Table::default();
    let pose = Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(Vector3::from(leaning)) };
    let solutions = machine.inverse_kinematics(&pose, &Table::HELD);
    let first = solutions.first()?;
    Some((first.axes, machine.forward_kinematics(&first.axes)))
}

#[cfg(test)]
mod tests {
    use super::there_and_back;

    #[test]
    fn a_pose_comes_back() {
        let (axes, pose) = there_and_back([10.0, 20.0, 30.0], [1.0, 0.0, 1.0]).expect("the table reaches it");
        // B is at 45° and C at zero.
        assert!(axes[0].abs() < 1e-12 && (axes[1].to_degrees() - 45.0).abs() < 1e-12);
        assert!((pose.tip.coords - super::Vector3::new(10.0, 20.0, 30.0)).norm() < 1e-9);
    }
}
