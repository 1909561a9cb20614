//! The pole, the limit of reach, and poses just beyond it, of two solved rotary axes.

use super::branch::{RotarySolution, branch};
use super::code::{Code, grouped, named};
use super::shared::{REACH_TOLERANCE, SINGULAR_SINE, finite, parallel, variables};
use crate::emit::body::Body;
use crate::emit::inputs::inputs;
use crate::model::Model;
use crate::solve::{Edge, Solved, TwoRotaries};
use crate::symbolic::Id;

/// Statements of the function.
pub(super) fn edge(model: &Model, solved: &Solved, two: &TwoRotaries, code: &mut Code) {
    let Edge { second, first, first_squared, reached_squared, along, .. } = two.edge;
    let wanted =
        [two.second.capacity, two.second.root_squared, two.second.height, two.second.rim, two.first.sine_squared];
    let reached =
        [second.sine, second.cosine, first.sine, first.cosine, first_squared, reached_squared, along.0, along.1];
    let outputs: Vec<Id> = wanted.into_iter().chain(reached).collect();
    let mut body = Body::in_c(&solved.graph, &outputs);
    let used = body.inputs(&outputs);
    code.unused(&["m", "held"]);
    code.inputs(model, &inputs(model, &used, variables()));
    code.statements(&body.statements(&wanted));
    let [capacity, root_squared, height, rim, sine_squared] = wanted.map(|node| body.expression(node));
    let cannot_tilt = match solved.graph.constant_of(two.second.capacity) {
        Some(_) => String::new(),
        None => format!("!({capacity} > {}) || ", parallel()),
    };
    code.line(format!("if ({cannot_tilt}!{}) return 0;", finite(model)));
    code.line(format!("const int inside = {root_squared} > 0.0;"));
    code.constant("edge_root", format!("inside ? sqrt({root_squared}) : 0.0"));
    code.constant("edge_height", format!("inside ? {height} : {height} < 0.0 ? -{} : {rim}", grouped(&rim)));
    code.statements(&body.statements(&outputs));
    let [second_sine, second_cosine, sine, cosine, first_squared, reached_squared, along, reached_along] =
        reached.map(|node| body.expression(node));
    // The distance in the plane of the first rotary axis and the wanted axis: along that axis, and across it.
    code.constant("edge_along", format!("{along} - {}", grouped(&reached_along)));
    code.constant("edge_across", format!("sqrt({sine_squared}) - sqrt({reached_squared})"));
    code.constant("deviation", "inside ? 0.0 : sqrt(edge_along * edge_along + edge_across * edge_across)");
    code.line(format!("if (!(deviation <= {REACH_TOLERANCE})) return 0;"));
    let [rotary, tilting] = two.rotaries;
    code.line(format!(
        "const int singular = !({sine_squared} >= {SINGULAR_SINE} * {SINGULAR_SINE}) || !({first_squared} > 0.0);"
    ));
    code.line(format!("if (singular && !isfinite(held[{rotary}])) return 0;"));
    code.constant("edge_norm", format!("sqrt({first_squared})"));
    code.constant("first", format!("singular ? {}(held[{rotary}]) : {} / edge_norm", named("sin"), grouped(&sine)));
    code.constant("second", format!("singular ? {}(held[{rotary}]) : {} / edge_norm", named("cos"), grouped(&cosine)));
    code.constant("value", format!("singular ? held[{rotary}] : {}(first, second)", named("angle")));
    code.line("int count = 0;");
    let solutions = [
        RotarySolution { axis: rotary, sin_cos: ["first".into(), "second".into()], angle: "value".into() },
        RotarySolution {
            axis: tilting,
            angle: format!("{}({second_sine}, {second_cosine})", named("angle")),
            sin_cos: [second_sine, second_cosine],
        },
    ];
    branch(model, solved, &solutions, code);
    code.line("return count;");
}
