//! Kinematics without an operating system: there and back for one pose, as firmware would do it.
//!
//! Nothing here needs `std` or allocates. A crate of its own would say `#![no_std]` and depend on
//! `pp-runtime` with `default-features = false`.

use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::machine;
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};

machine! {
    /// Rotary table on a tilting table.
    pub struct Table;
    chain: C B | X Y Z;
    d = (0, 0, 150);
}

/// Axis values for a tip on the workpiece with the tool leaning, the first branch, and the pose that they give.
///
/// `None` where the machine does not reach.
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
        // B leans by 45° and C stays at zero.
        assert!(axes[0].abs() < 1e-12 && (axes[1].to_degrees() - 45.0).abs() < 1e-12);
        assert!((pose.tip.coords - super::Vector3::new(10.0, 20.0, 30.0)).norm() < 1e-9);
    }
}
