//! One branch of the inverse as a solution, if the linear axes have one.

use super::code::{Code, named, turn_of};
use super::functions::turns;
use crate::emit::kinematics::rotaries;
use crate::model::{AxisId, AxisKind, Model};
use crate::solve::Solved;

/// A solved rotary axis.
pub(super) struct RotarySolution {
    pub(super) axis: AxisId,
    /// Expressions of sine and cosine.
    pub(super) sin_cos: [String; 2],
    /// Expression of the angle.
    pub(super) angle: String,
}

/// Adds a solution to `axes` and counts it.
pub(super) fn branch(model: &Model, solved: &Solved, rotary: &[RotarySolution], code: &mut Code) {
    let of = |place: AxisId| rotary.iter().find(|rotary| rotary.axis == place);
    let pair = |place: AxisId| match of(place) {
        Some(RotarySolution { sin_cos: [sine, cosine], .. }) => format!("{{{sine}, {cosine}}}"),
        None => turn_of(&format!("held[{place}]")),
    };
    let pairs = rotaries(model).map(pair).collect();
    code.block("", |code| {
        turns(code, pairs);
        code.line("double solved[3] = {0.0, 0.0, 0.0};");
        code.block(format!("if ({}(m, tip, turns, held, solved))", named("position")), |code| {
            code.line(format!("double *to = axes + {} * count++;", model.axes.len()));
            for (place, axis) in model.axes.iter().enumerate() {
                let value = match (axis.held.is_some(), axis.kind) {
                    (true, _) => format!("held[{place}]"),
                    (false, AxisKind::Linear) => {
                        let index = solved.position.values.iter().position(|(known, _)| *known == place);
                        format!("solved[{}]", index.unwrap_or_default())
                    }
                    (false, AxisKind::Rotary) => of(place).map(|rotary| rotary.angle.clone()).unwrap_or_default(),
                };
                code.line(format!("to[{place}] = {value};"));
            }
        });
    });
}
