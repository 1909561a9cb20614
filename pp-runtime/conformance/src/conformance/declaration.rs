//! Check of the declaration: axes, held values, dimensions and joints of a machine are consistent.

use nalgebra::Vector3;
use pp_runtime::kinematics::{AxisKind, Invalid, Side};

use super::{Fault, UNIT};
use crate::subject::Subject;

/// Checks that axes, held values, dimensions and joints of a machine are consistent.
pub(super) fn declaration(declared: &dyn Subject) -> Result<(), Fault> {
    let rule = |rule: &'static str, holds: bool| {
        let chain: String = declared.axes().iter().map(|axis| axis.letter).collect();
        if holds { Ok(()) } else { Err(Fault { rule, details: format!("machine {}, chain {chain}", declared.name()) }) }
    };
    let axes = declared.axes();
    let held = declared.default_held();
    rule("HELD has one value per axis", held.len() == axes.len())?;
    rule("the machine has a name", !declared.name().is_empty())?;
    rule(
        "exactly three linear axes are solved for",
        axes.iter().filter(|axis| axis.kind == AxisKind::Linear && !axis.held).count() == 3,
    )?;
    rule(
        "at most two rotary axes are solved for",
        axes.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held).count() <= 2,
    )?;
    rule("workpiece side comes before tool side", axes.is_sorted_by_key(|axis| axis.side == Side::Tool))?;
    rule("the tool axis is a unit vector", (declared.tool_axis().norm() - 1.0).abs() <= UNIT)?;
    for (index, axis) in axes.iter().enumerate() {
        rule("no letter is used twice", axes[..index].iter().all(|other| other.letter != axis.letter))?;
        let kind = match axis.letter {
            'A'..='C' => AxisKind::Rotary,
            'U'..='Z' => AxisKind::Linear,
            _ => return rule("an axis is one of X Y Z U V W A B C", false),
        };
        rule("A B C are rotary, X Y Z U V W are linear", axis.kind == kind)?;
        rule("HELD is zero for an axis that is solved for", axis.held || held[index].abs() <= 0.0)?;
        if let Some(limits) = axis.limits {
            rule("travel is not empty", limits.lower <= limits.upper)?;
        }
        let joint = declared.joint(index);
        rule("a joint's sign is that of its axis", (joint.sign - axis.sign.factor()).abs() <= 0.0)?;
        rule("a joint's direction is a unit vector", (joint.direction.norm() - 1.0).abs() <= UNIT)?;
        if axis.kind == AxisKind::Linear {
            rule("a linear joint is at the origin", joint.point.coords.norm() <= 0.0)?;
        }
    }
    rule("the declared dimensions are valid", declared.validate().is_ok())?;
    let mut changed = declared.copy();
    for (index, dimension) in declared.dimensions().iter().enumerate() {
        let (default, sample) = (dimension.default, declared.dimension(index));
        rule("a dimension starts at its default", default.is_nan() || (sample - default).abs() <= 0.0)?;
        changed.set_dimension(index, default);
        let required = Err(Invalid::Required { name: dimension.name });
        rule("a required dimension is named where it is missing", !default.is_nan() || changed.validate() == required)?;
        changed.set_dimension(index, 0.125);
        rule("a dimension keeps the value that is set", (changed.dimension(index) - 0.125).abs() <= 0.0)?;
        changed.set_dimension(index, f64::NAN);
        rule("a dimension that is not a number is invalid", changed.validate().is_err())?;
        changed = declared.copy();
    }
    changed.set_up(Vector3::new(0.0, f64::INFINITY, 0.0), 0.0);
    rule("an infinite part origin is invalid", changed.validate().is_err())?;
    changed.set_up(Vector3::zeros(), f64::NAN);
    rule("a gauge length that is not a number is invalid", changed.validate().is_err())
}
