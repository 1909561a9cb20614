//! A machine for tests of configuration and command line. Its axes, dimensions and limits are realistic, its kinematics
//! are not.

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::kinematics::{
    Axis, AxisKind, Dimension, DimensionKind, Explanation, Invalid, Joint, Limits, Machine, Pose, Section, Side, Sign,
    Solutions, Unreachable,
};

/// Machine `C B | X Y Z`; invalid if `d` is zero.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    pub(crate) d: f64,
    pub(crate) alpha: f64,
    pub(crate) part_origin: Vector3<f64>,
}

impl Default for Sample {
    fn default() -> Self {
        Self { d: 150.0, alpha: (-45_f64).to_radians(), part_origin: Vector3::zeros() }
    }
}

const fn axis(letter: char, kind: AxisKind, limits: Option<Limits>, speed: Option<f64>) -> Axis {
    Axis { letter, kind, side: Side::Workpiece, sign: Sign::Plus, limits, speed, held: false }
}

impl Machine for Sample {
    type Axes = [f64; 5];
    const NAME: &'static str = "Sample";
    const AXES: &'static [Axis] = &[
        axis('C', AxisKind::Rotary, None, None),
        axis(
            'B',
            AxisKind::Rotary,
            Some(Limits { lower: (-5_f64).to_radians(), upper: 110_f64.to_radians() }),
            Some(3600_f64.to_radians()),
        ),
        axis('X', AxisKind::Linear, Some(Limits { lower: -310.0, upper: 310.0 }), Some(30000.0)),
        axis('Y', AxisKind::Linear, None, None),
        axis('Z', AxisKind::Linear, None, None),
    ];
    const DIMENSIONS: &'static [Dimension] = &[
        Dimension { name: "d", kind: DimensionKind::Length, default: 150.0 },
        Dimension { name: "alpha", kind: DimensionKind::Angle, default: -core::f64::consts::FRAC_PI_4 },
    ];
    const HELD: Self::Axes = [0.0; 5];
    const EXPLANATION: &'static Explanation = &Explanation {
        chain: Section { text: &["C B | X Y Z", "", "tool axis (0, 0, 1)"], latex: &["$C$ $B$ $X$ $Y$ $Z$"] },
        formulas: Section { text: &["B = atan2(√(i² + j²), k)"], latex: &[r"$B = \arccos k$"] },
        ..Explanation::EMPTY
    };

    fn dimension(&self, index: usize) -> f64 {
        [self.d, self.alpha][index]
    }

    fn set_dimension(&mut self, index: usize, value: f64) {
        *[&mut self.d, &mut self.alpha][index] = value;
    }

    fn set_up(&mut self, part_origin: Vector3<f64>, _gauge_length: f64) {
        self.part_origin = part_origin;
    }

    fn validate(&self) -> Result<(), Invalid> {
        if self.d.abs() < 1e-9 {
            return Err(Invalid::Zero { expression: "d", meaning: "the table has no height" });
        }
        Ok(())
    }

    fn joint(&self, _index: usize) -> Joint {
        Joint { direction: self.tool_axis(), point: Point3::origin(), sign: 1.0 }
    }

    fn tool_axis(&self) -> UnitVector3<f64> {
        Vector3::z_axis()
    }

    fn forward_kinematics(&self, axes: &Self::Axes) -> Pose {
        Pose { tip: Point3::new(axes[2], axes[3], axes[4]), axis: self.tool_axis() }
    }

    fn inverse_kinematics(&self, _pose: &Pose, _held: &Self::Axes) -> Solutions<Self::Axes> {
        Solutions::default()
    }

    fn linear_axes(&self, tip: &Point3<f64>, axes: &Self::Axes) -> Option<Self::Axes> {
        Some([axes[0], axes[1], tip.x, tip.y, tip.z])
    }

    fn reach(&self, _axis: &UnitVector3<f64>, _held: &Self::Axes) -> Result<(), Unreachable> {
        Ok(())
    }
}
