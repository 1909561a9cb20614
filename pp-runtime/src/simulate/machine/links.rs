//! The machine as links: what moves together, from the table to the spindle.
//!
//! Link 0 has the part, the last link the tool; joint `i` is between link `i` and link `i + 1`. The coordinates of a
//! link are those of the zero position: of the table its own, of the head those of the gauge line, which is at the
//! reference point of the table there. So axis values here count from there: the machine has no part origin and no
//! tool.

use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

use crate::kinematics::{AnyMachine, AxisKind, AxisValues, Joint, Side};
use crate::set_up::{SetUp, SolidLink};
use crate::simulate::bodies::CentreLine;

/// The links of a machine.
pub(crate) struct MachineLinks {
    joints: Vec<(char, AxisKind, Joint)>,
    /// Number of the frame.
    frame: usize,
    /// Axis values of the part zero of the first set-up.
    first_part: AxisValues,
    /// Direction from the tip to the spindle.
    pub(crate) tool_axis: Vector3<f64>,
}

impl MachineLinks {
    /// The links of a machine with the dimensions of a set-up.
    pub(crate) fn of(machine: &dyn AnyMachine, set_up: &SetUp) -> Self {
        let mut bare = machine.to_boxed();
        bare.set_up(Vector3::zeros(), 0.0);
        let axes = bare.axes();
        let first_part = bare.linear_axes(&Point3::from(set_up.part_origin), &bare.held());
        Self {
            joints: axes.iter().enumerate().map(|(index, axis)| (axis.letter, axis.kind, bare.joint(index))).collect(),
            frame: axes.iter().filter(|axis| axis.side == Side::Workpiece).count(),
            first_part: first_part.unwrap_or([0.0; 9]),
            tool_axis: bare.tool_axis().into_inner(),
        }
    }

    /// Number of the link of the tool.
    pub(crate) fn spindle(&self) -> usize {
        self.joints.len()
    }

    /// Number of a link.
    pub(crate) fn number(&self, link: SolidLink) -> Option<usize> {
        match link {
            SolidLink::Frame => Some(self.frame),
            SolidLink::Table | SolidLink::Fixture => Some(0),
            SolidLink::Spindle => Some(self.spindle()),
            SolidLink::Axis(letter) => {
                let joint = self.joints.iter().position(|joint| joint.0 == letter)?;
                Some(if joint < self.frame { joint } else { joint + 1 })
            }
        }
    }

    /// Whether an axis is a rotary axis.
    pub(crate) fn is_rotary(&self, joint: usize) -> bool {
        self.joints[joint].1 == AxisKind::Rotary
    }

    /// Centre line of an axis, in the coordinates of the links on both of its sides; `None`: it is linear.
    pub(crate) fn centre_line(&self, joint: usize) -> Option<CentreLine> {
        let Joint { point, direction, .. } = self.joints[joint].2;
        self.is_rotary(joint).then_some(CentreLine { point, direction })
    }

    /// Axis values of these links: of the words of a set-up with its part and tool. `offsets_mm`: machine coordinates
    /// of linear axes less value and `machine_zero`.
    pub(crate) fn values(&self, axes: &AxisValues, offsets_mm: &AxisValues) -> AxisValues {
        std::array::from_fn(|index| match self.joints.get(index) {
            Some((_, AxisKind::Linear, _)) => axes[index] + offsets_mm[index] + self.first_part[index],
            _ => axes[index],
        })
    }

    /// From the coordinates of each link to the same in the zero position of a set-up with its part and tool, where
    /// they are those of the part zero, mm.
    pub(crate) fn at_zero(&self, part_origin: [f64; 3], offsets_mm: &AxisValues) -> Vec<[f64; 3]> {
        let values = self.values(&[0.0; 9], offsets_mm);
        let place = |link| self.between(0, link, &values).translation.vector - Vector3::from(part_origin);
        (0..=self.joints.len()).map(|link| place(link).into()).collect()
    }

    /// Place of a link in the coordinates of one before it.
    pub(crate) fn between(&self, from: usize, to: usize, values: &AxisValues) -> Isometry3<f64> {
        (from..to).fold(Isometry3::identity(), |place, joint| place * self.step(joint, values[joint]))
    }

    fn step(&self, joint: usize, value: f64) -> Isometry3<f64> {
        let (_, kind, joint) = &self.joints[joint];
        let value = joint.sign * value;
        match kind {
            AxisKind::Linear => Translation3::from(joint.direction.into_inner() * value).into(),
            AxisKind::Rotary => {
                let rotation = UnitQuaternion::from_axis_angle(&joint.direction, value);
                let back = joint.point.coords - rotation * joint.point.coords;
                Isometry3::from_parts(Translation3::from(back), rotation)
            }
        }
    }
}
