//! The structure of a machine, and its declared values.

use super::code::{Code, named};
use crate::model::{AxisKind, Dimension, Model, Quantity, to_f64};

/// The structure: set-up, and dimensions in the order of the declaration.
pub(super) fn structure(model: &Model, code: &mut Code) {
    code.line("/* Set-up and dimensions. */");
    code.line("typedef struct {");
    code.line("    double part_origin[3]; /* part zero from the table's reference point, mm */");
    code.line("    double gauge_length; /* gauge line to tool tip, mm */");
    for Dimension { name, quantity, .. } in &model.dimensions {
        let unit = match quantity {
            Quantity::Length(_) => "mm",
            Quantity::Angle(..) => "rad",
        };
        code.line(format!("    double {}; /* {unit} */", model.c_field(name)));
    }
    code.line(format!("}} {};", named("machine")));
}

/// The declared values.
pub(super) fn default(model: &Model, code: &mut Code) {
    let signature = format!("void {}({} *m)", named("default"), named("machine"));
    code.function("The declared dimensions; no part origin, no gauge length.", signature, |code| {
        code.line("m->part_origin[0] = m->part_origin[1] = m->part_origin[2] = 0.0;");
        code.line("m->gauge_length = 0.0;");
        for Dimension { name, quantity, default, .. } in &model.dimensions {
            let field = model.c_field(name);
            let Some(default) = default else {
                code.line(format!("m->{field} = NAN; /* required */"));
                continue;
            };
            let value = match quantity {
                Quantity::Length(_) => to_f64(default),
                Quantity::Angle(..) => to_f64(default).to_radians(),
            };
            code.line(format!("m->{field} = {value:?};"));
        }
    });
}

/// `X, Y, Z (mm), C, B (rad)`: the axes in chain order.
pub(super) fn axes(model: &Model) -> String {
    let one = |axis: &crate::model::Axis| {
        let unit = if axis.kind == AxisKind::Linear { "mm" } else { "rad" };
        format!("{} {unit}", axis.letter)
    };
    model.axes.iter().map(one).collect::<Vec<_>>().join(", ")
}
