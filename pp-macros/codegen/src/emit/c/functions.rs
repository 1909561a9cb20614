//! Forward kinematics, linear axes, and functions of angles.

use super::code::{Code, named, turn_of};
use super::structure::axes;
use crate::emit::body::Body;
use crate::emit::inputs::{InputVariables, inputs};
use crate::emit::kinematics::rotaries;
use crate::model::Model;
use crate::solve::Solved;
use crate::symbolic::Id;

/// Least absolute determinant of the directions of the linear axes: `pp_runtime::kinematics::SMALLEST_DETERMINANT`.
const SMALLEST_DETERMINANT: &str = "1e-9";

/// Angles in (-π, π], as `pp_runtime::kinematics::math` has them.
pub(super) fn angles(code: &mut Code) {
    let name = named("named_once");
    code.line("");
    code.line(format!("#define {} 3.14159265358979323846", named("PI")));
    let pi = named("PI");
    code.function("A half turn is always pi, never -pi.", format!("double {name}(double value)"), |code| {
        code.line(format!("return value <= -{pi} ? {pi} : value;"));
    });
    let angle = format!("double {}(double first, double second)", named("angle"));
    code.function("The angle of a sine and a cosine, times any factor above zero.", angle, |code| {
        code.line(format!("return {name}({}(first, second));", named("atan2")));
    });
    let half = format!("double {}(double value)", named("half_turn"));
    code.function("The angle half a turn away.", half, |code| {
        code.line(format!("return {name}(value > 0.0 ? value - {pi} : value + {pi});"));
    });
    let mirrored = format!("double {}(double value)", named("mirrored"));
    code.function("The angle of the same sine and the opposite cosine.", mirrored, |code| {
        code.line(format!("return {name}(value >= 0.0 ? {pi} - value : -{pi} - value);"));
    });
    let negated = format!("double {}(double value)", named("negated"));
    code.function("The angle of the same cosine and the opposite sine.", negated, |code| {
        code.line(format!("return value >= {pi} ? value : -value;"));
    });
}

/// `forward`.
pub(super) fn forward(model: &Model, solved: &Solved, code: &mut Code) {
    let outputs: Vec<Id> = solved.forward.tip.into_iter().chain(solved.forward.axis).collect();
    let mut body = Body::in_c(&solved.graph, &outputs);
    let used = body.inputs(&outputs);
    let inputs = inputs(model, &used, InputVariables { words: Some("axes"), ..InputVariables::default() });
    let comment = format!("Tip, mm, and tool axis, a unit vector from tip to spindle, of axes {}.", axes(model));
    let signature = format!(
        "void {}(const {} *m, const double *axes, double tip[3], double axis[3])",
        named("forward"),
        named("machine")
    );
    code.function(&comment, signature, |code| {
        code.unused(&["m", "axes"]);
        code.inputs(model, &inputs);
        code.statements(&body.statements(&outputs));
        for (vector, nodes) in [("tip", solved.forward.tip), ("axis", solved.forward.axis)] {
            for (index, node) in nodes.into_iter().enumerate() {
                code.line(format!("{vector}[{index}] = {};", body.expression(node)));
            }
        }
    });
}

/// `position`: the three solved linear axes from sines and cosines.
pub(super) fn position(model: &Model, solved: &Solved, code: &mut Code) {
    let values: Vec<Id> = solved.position.values.iter().map(|(_, node)| *node).collect();
    let determinant = solved.position.determinant;
    let varies = solved.graph.constant_of(determinant).is_none();
    let outputs: Vec<Id> = values.iter().copied().chain(varies.then_some(determinant)).collect();
    let mut body = Body::in_c(&solved.graph, &outputs);
    let variables =
        InputVariables { tip: Some("tip"), words: Some("held"), turns: Some("turns"), ..InputVariables::default() };
    let used = body.inputs(&outputs);
    let inputs = inputs(model, &used, variables);
    let signature = format!(
        "int {}(const {} *m, const double tip[3], const double (*turns)[2], const double *held, double solved[3])",
        named("position"),
        named("machine"),
    );
    let comment = "Linear axes from the tip and the sine and cosine of every rotary axis; 0 where they are degenerate.";
    code.function(comment, signature, |code| {
        code.unused(&["m", "turns", "held"]);
        code.inputs(model, &inputs);
        if varies {
            code.statements(&body.statements(&[determinant]));
            let determinant = body.expression(determinant);
            code.line(format!("if (!(fabs({determinant}) >= {SMALLEST_DETERMINANT})) return 0;"));
        }
        code.statements(&body.statements(&outputs));
        for (index, node) in values.iter().enumerate() {
            code.line(format!("solved[{index}] = {};", body.expression(*node)));
        }
        code.line("return 1;");
    });
}

/// `linear_axes`.
pub(super) fn linear_axes(model: &Model, solved: &Solved, code: &mut Code) {
    let signature =
        format!("int {}(const {} *m, const double tip[3], double *axes)", named("linear_axes"), named("machine"));
    let comment = "Moves the solved linear axes so that the tip is at a place while the others stay; 0, and nothing is \
                   changed, where that is not possible.";
    let linear = |place: usize| solved.position.values.iter().position(|(axis, _)| *axis == place);
    code.function(comment, signature, |code| {
        let given = (0..model.axes.len()).filter(|place| linear(*place).is_none());
        let sum: String = given.map(|place| format!(" + axes[{place}]")).collect();
        code.line(format!("if (!isfinite(tip[0] + tip[1] + tip[2]{sum})) return 0;"));
        let pairs = rotaries(model).map(|place| turn_of(&format!("axes[{place}]")));
        turns(code, pairs.collect());
        code.line("double solved[3] = {0.0, 0.0, 0.0};");
        code.line(format!("if (!{}(m, tip, turns, axes, solved)) return 0;", named("position")));
        for (index, (place, _)) in solved.position.values.iter().enumerate() {
            code.line(format!("axes[{place}] = solved[{index}];"));
        }
        code.line("return 1;");
    });
}

/// The array `turns`; C has no array of length zero.
pub(super) fn turns(code: &mut Code, mut pairs: Vec<String>) {
    if pairs.is_empty() {
        pairs.push("{0.0, 1.0}".into());
    }
    code.line(format!("const double turns[{}][2] = {{{}}};", pairs.len(), pairs.join(", ")));
}
