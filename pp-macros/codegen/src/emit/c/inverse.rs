//! Inverse kinematics: no, one or two solved rotary axes.

use super::branch::{RotarySolution, branch};
use super::code::{Code, named};
use super::edge::edge;
use super::shared::{REACH_TOLERANCE, SINGULAR_SINE, finite, parallel, variables};
use super::structure::axes;
use crate::emit::body::Body;
use crate::emit::inputs::inputs;
use crate::emit::inverse::{can_be_free, needs_pole_test};
use crate::model::Model;
use crate::solve::{AngleRelation, OneRotary, Orientation, Solved, TwoRotaries};
use crate::symbolic::{Id, SineCosine};

/// Largest difference of the square of a unit vector from 1.
const UNIT_SQUARED: &str = "1e-6";

/// `inverse`, and before it the function for poses at the edge of reach.
pub(super) fn inverse(model: &Model, solved: &Solved, code: &mut Code) {
    if let Orientation::Two(two) = &solved.orientation {
        code.function(
            "One solution at the pole, at the limit of reach, and within the tolerance beyond it.",
            signature("at_the_edge"),
            |code| edge(model, solved, two, code),
        );
    }
    let comment = format!(
        "Axis values {} for a pose, branch after branch in `axes`; returns the number of branches, 0 to 2. `axis` is a unit \
         vector: 0 where its square is off 1 by more than {UNIT_SQUARED}. `held` has the values of held axes, and of a \
         rotary axis that is free.",
        axes(model)
    );
    code.function(&comment, signature("inverse"), |code| {
        code.line(format!(
            "if (!(fabs(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] - 1.0) <= {UNIT_SQUARED})) return 0;"
        ));
        match &solved.orientation {
            Orientation::Fixed { deviation } => fixed(model, solved, *deviation, code),
            Orientation::One(one) => single(model, solved, one, code),
            Orientation::Two(two) => pair(model, solved, two, code),
        }
    });
}

fn signature(name: &str) -> String {
    format!(
        "int {}(const {} *m, const double tip[3], const double axis[3], const double *held, double *axes)",
        named(name),
        named("machine"),
    )
}

fn fixed(model: &Model, solved: &Solved, deviation: Id, code: &mut Code) {
    let mut body = Body::in_c(&solved.graph, &[deviation]);
    let used = body.inputs(&[deviation]);
    code.unused(&["m", "held"]);
    code.line("int count = 0;");
    code.inputs(model, &inputs(model, &used, variables()));
    within_reach(model, &mut body, deviation, code);
    branch(model, solved, &[], code);
    code.line("return count;");
}

fn single(model: &Model, solved: &Solved, one: &OneRotary, code: &mut Code) {
    let outputs = [one.deviation, one.word.sine, one.word.cosine, one.length, one.length_claim];
    let mut body = Body::in_c(&solved.graph, &outputs);
    let used = body.inputs(&outputs);
    code.unused(&["m", "held"]);
    code.line("int count = 0;");
    code.inputs(model, &inputs(model, &used, variables()));
    if solved.graph.constant_of(one.length_claim).is_none() {
        code.statements(&body.statements(&[one.length_claim]));
        code.line(format!("if (!({} > {})) return 0;", body.expression(one.length_claim), parallel()));
    }
    within_reach(model, &mut body, one.deviation, code);
    code.statements(&body.statements(&outputs));
    let (rotary, [sine, cosine, length]) =
        (one.rotary, [one.word.sine, one.word.cosine, one.length].map(|node| body.expression(node)));
    if can_be_free(solved, one) {
        code.line(format!("const int singular = !({length} >= {SINGULAR_SINE});"));
        code.line(format!("if (singular && !isfinite(held[{rotary}])) return 0;"));
        code.constant("first", format!("singular ? {}(held[{rotary}]) : {sine}", named("sin")));
        code.constant("second", format!("singular ? {}(held[{rotary}]) : {cosine}", named("cos")));
        code.constant("value", format!("singular ? held[{rotary}] : {}(first, second)", named("angle")));
    } else {
        code.constant("first", sine);
        code.constant("second", cosine);
        code.constant("value", format!("{}(first, second)", named("angle")));
    }
    let solution = RotarySolution { axis: rotary, sin_cos: ["first".into(), "second".into()], angle: "value".into() };
    branch(model, solved, &[solution], code);
    code.line("return count;");
}

/// No solution where the wanted axis is off the cone by more than the tolerance, or is not a number.
fn within_reach(model: &Model, body: &mut Body<'_>, deviation: Id, code: &mut Code) {
    code.statements(&body.statements(&[deviation]));
    let (deviation, finite) = (body.expression(deviation), finite(model));
    code.line(format!("if (!({deviation} <= {REACH_TOLERANCE}) || !{finite}) return 0;"));
}

fn pair(model: &Model, solved: &Solved, two: &TwoRotaries, code: &mut Code) {
    let guarded = [two.second.root, two.first.sine_squared, two.second.capacity];
    let words = two.branches.iter().flat_map(|branch| branch.words.map(SineCosine::nodes).concat());
    let outputs: Vec<Id> = guarded.into_iter().chain(words).collect();
    let mut body = Body::in_c(&solved.graph, &outputs);
    let used = body.inputs(&outputs);
    code.unused(&["m", "held"]);
    code.inputs(model, &inputs(model, &used, variables()));
    code.statements(&body.statements(&guarded));
    let [root, sine_squared, capacity] = guarded.map(|node| body.expression(node));
    let mut edge = format!("!({root} >= {SINGULAR_SINE})");
    if needs_pole_test(two) {
        edge.push_str(&format!(" || !({sine_squared} >= {SINGULAR_SINE} * {SINGULAR_SINE})"));
    }
    if solved.graph.constant_of(two.second.capacity).is_none() {
        edge.push_str(&format!(" || !({capacity} > {})", parallel()));
    }
    let finite = finite(model);
    code.line(format!("if ({edge} || !{finite}) return {}(m, tip, axis, held, axes);", named("at_the_edge")));
    code.statements(&body.statements(&outputs));
    code.line("int count = 0;");
    for (index, solution) in two.branches.iter().enumerate() {
        let mut rotary = Vec::new();
        for (number, &axis) in two.rotaries.iter().enumerate() {
            let letter = model.axes[axis].letter.to_ascii_lowercase();
            let (name, first) = (format!("angle_{letter}_{}", index + 1), format!("angle_{letter}_1"));
            let sin_cos = solution.words[number].nodes().map(|node| body.expression(node));
            let value = match solution.angles[number] {
                AngleRelation::Own => format!("{}({}, {})", named("angle"), sin_cos[0], sin_cos[1]),
                AngleRelation::Same => first,
                AngleRelation::Negated => format!("{}({first})", named("negated")),
                AngleRelation::HalfTurn => format!("{}({first})", named("half_turn")),
                AngleRelation::Mirrored => format!("{}({first})", named("mirrored")),
            };
            code.constant(&name, value);
            rotary.push(RotarySolution { axis, sin_cos, angle: name });
        }
        branch(model, solved, &rotary, code);
    }
    code.line("return count;");
}
