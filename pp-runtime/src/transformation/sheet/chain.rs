//! The chain as the five-axis model of a control sees it: X, Y and Z along the coordinates, and at most two rotary
//! axes.

use nalgebra::Vector3;

use crate::config::Config;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Joint, Side, Sign, carried};

use super::super::NotExpressible;
use super::rows::XYZ;

/// Sine of an angle below which two directions are one.
const PARALLEL: f64 = 1e-12;

/// A solved rotary axis with all axes at zero.
#[derive(Debug, Clone)]
pub(super) struct RotaryAtZero {
    pub(super) letter: char,
    pub(super) side: Side,
    /// Unit vector about which the table or the head itself rotates right-handed while the word grows.
    pub(super) rotation: Vector3<f64>,
    /// A point of the centre line, mm: of a table from the part zero, of a head from the gauge line on the tool axis.
    pub(super) point: Vector3<f64>,
}

impl RotaryAtZero {
    fn new(axis: &Axis, joint: &Joint) -> Self {
        // Words count the motion of the tool relative to the workpiece: a table moves the opposite way.
        let carried = match axis.side {
            Side::Workpiece => -joint.sign,
            Side::Tool => joint.sign,
        };
        Self {
            letter: axis.letter,
            side: axis.side,
            rotation: joint.direction.into_inner() * carried,
            point: joint.point.coords,
        }
    }

    /// The coordinate axis along which the centre line runs, if it is parallel to one.
    pub(super) fn coordinate(&self) -> Option<usize> {
        coordinate(&self.rotation)
    }
}

/// The coordinate axis that is parallel to a unit vector.
pub(super) fn coordinate(vector: &Vector3<f64>) -> Option<usize> {
    (0..3).find(|&index| (0..3).all(|other| other == index || vector[other].abs() < PARALLEL))
}

/// Places of the rotary axes.
#[derive(Debug)]
pub(super) enum Arrangement {
    /// In the head, the axis next to the bed first.
    Head(RotaryAtZero, Option<RotaryAtZero>),
    /// In the table, the axis next to the bed first.
    Table(RotaryAtZero, Option<RotaryAtZero>),
    /// One in the head, one in the table.
    Mixed {
        /// The axis in the head.
        head: RotaryAtZero,
        /// The axis in the table.
        table: RotaryAtZero,
    },
}

impl Arrangement {
    /// The rotary axes of a machine.
    ///
    /// # Errors
    /// The model has no rotary axis, or not X, Y and Z as a right-handed system next to the bed, or a held axis is not
    /// at zero. `model` is the name of the transformation.
    pub(super) fn of(machine: &dyn AnyMachine, model: &str) -> Result<Self, NotExpressible> {
        held_axes_are_zero(machine)?;
        linear_axes_are_coordinates(machine, model)?;
        linear_axes_are_next_to_the_bed(machine, model)?;
        let mut head = rotary_axes(machine, Side::Tool);
        let mut table = rotary_axes(machine, Side::Workpiece);
        // The chain goes from the workpiece to the tool: of two axes in the table the second is next to the bed.
        table.reverse();
        let mut axes = head.drain(..).chain(table.drain(..));
        let (first, second) = (axes.next(), axes.next());
        match (first, second) {
            (None, _) => Err(NotExpressible(format!(
                "{} has no rotary axis that is solved for: there is nothing to compare with {model}",
                machine.name()
            ))),
            (Some(head), Some(table)) if head.side != table.side => Ok(Self::Mixed { head, table }),
            (Some(first), second) if first.side == Side::Tool => Ok(Self::Head(first, second)),
            (Some(first), second) => Ok(Self::Table(first, second)),
        }
    }

    /// The first and the second rotary axis of the transformation: next to the bed first, of a head and a table the
    /// head.
    pub(super) fn axes(&self) -> (&RotaryAtZero, Option<&RotaryAtZero>) {
        match self {
            Self::Head(first, second) | Self::Table(first, second) => (first, second.as_ref()),
            Self::Mixed { head, table } => (head, Some(table)),
        }
    }
}

fn rotary_axes(machine: &dyn AnyMachine, side: Side) -> Vec<RotaryAtZero> {
    let axes = machine.axes().iter().enumerate();
    let solved = axes.filter(|(_, axis)| axis.kind == AxisKind::Rotary && !axis.held && axis.side == side);
    solved.map(|(index, axis)| RotaryAtZero::new(axis, &machine.joint(index))).collect()
}

/// A held axis has no place in these models: they describe the machine with that axis at zero.
pub(super) fn held_axes_are_zero(machine: &dyn AnyMachine) -> Result<(), NotExpressible> {
    let held = machine.held();
    let moved = machine.axes().iter().zip(held).find(|(axis, value)| axis.held && *value != 0.0);
    moved.map_or(Ok(()), |(axis, _)| {
        Err(NotExpressible(format!(
            "{letter} is held away from zero, and the transformation of the control does not know {letter}: declare \
             `hold = {{ {letter}: 0 }}` and compare the machine with {letter} at zero",
            letter = axis.letter,
        )))
    })
}

/// Letters of the held axes.
pub(super) fn held_axes(machine: &dyn AnyMachine) -> Vec<char> {
    machine.axes().iter().filter(|axis| axis.held).map(|axis| axis.letter).collect()
}

/// X, Y and Z must move the tool along +X, +Y and +Z relative to the workpiece.
pub(super) fn linear_axes_are_coordinates(machine: &dyn AnyMachine, model: &str) -> Result<(), NotExpressible> {
    for (component, letter) in XYZ.into_iter().enumerate() {
        let axes = machine.axes().iter().enumerate();
        let found = axes.into_iter().find(|(_, axis)| axis.letter == letter && !axis.held);
        let Some((index, axis)) = found else {
            return Err(NotExpressible(format!(
                "{model}: {} has no {letter} that is solved for, and X, Y and Z are needed",
                machine.name()
            )));
        };
        if axis.sign == Sign::Minus {
            return Err(NotExpressible(format!(
                "{letter} counts against ISO 841 (`signs = {{ {letter}: - }}`), and for {model} X, Y and Z must be a right-handed \
                 system. Reverse the direction of {letter} in the control, declare it `+`, and post for that"
            )));
        }
        if machine.joint(index).direction[component] < 1.0 - PARALLEL {
            return Err(NotExpressible(format!(
                "{letter} is not parallel to its coordinate, and for {model} X, Y and Z must be perpendicular to each other: the \
                 control needs a transformation for the inclined axis first, which this sheet does not compare"
            )));
        }
    }
    Ok(())
}

/// No rotary axis may carry X, Y or Z.
fn linear_axes_are_next_to_the_bed(machine: &dyn AnyMachine, model: &str) -> Result<(), NotExpressible> {
    carried(machine.axes()).map_or(Ok(()), |[rotary, linear]| {
        Err(NotExpressible(format!(
            "{rotary} carries {linear}: {linear} rotates with {rotary}, and for {model} X, Y and Z must be next to the bed",
            rotary = rotary.letter,
            linear = linear.letter
        )))
    })
}

/// Machine coordinates of a point of the table that is given from the part zero, mm: the axis values at which the gauge
/// point is there. `None` where `machine_zero` does not have the axis.
pub(super) fn machine_coordinates(config: &Config, point: &Vector3<f64>) -> [Option<f64>; 3] {
    let zero = |component: usize| config.set_up.machine_zero.get(&XYZ[component]);
    [0, 1, 2].map(|component| Some(zero(component)? + point[component]))
}

/// The opposite vector, where it is known.
pub(super) fn opposite(vector: &[Option<f64>; 3]) -> [Option<f64>; 3] {
    vector.map(|component| component.map(|value| -value))
}

/// The coordinate along which the tool points from its tip to the spindle.
///
/// # Errors
/// It points along none, or against one.
pub(super) fn tool_coordinate(machine: &dyn AnyMachine, model: &str) -> Result<usize, NotExpressible> {
    let tool = machine.tool_axis();
    let along = coordinate(&tool).filter(|&component| tool[component] > 0.0);
    along.ok_or_else(|| {
        NotExpressible(format!(
            "with all axes at zero the tool of {} does not point along X, Y or Z from its tip to the spindle, as is \
             needed for {model}",
            machine.name()
        ))
    })
}
