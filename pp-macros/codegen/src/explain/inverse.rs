//! The inverse kinematics: formulas, branches, and the operations that they take.
//!
//! Formulas are read from the nodes of the code as polynomials and factored. They are the same functions, but not the
//! same operations: the well-conditioned form near the pole is in the code only.

use std::collections::BTreeMap;

use super::chain::letter;
use super::linear::{LinearFormulas, linear};
use super::section::{Section, line};
use super::steps::steps;
use crate::formula::{ClosedForm, Formula, angle_of_one, common_number};
use crate::model::{AxisId, Model};
use crate::solve::{AngleRelation, Orientation, Solved, TwoRotaries};
use crate::symbolic::{Id, Interpreter, Operations, SineCosine, Surd};

/// The inverse kinematics in formulas; `None` for what is too long for a line.
pub(crate) struct InverseFormulas {
    /// The only rotary axis.
    pub(crate) one: Option<Formula>,
    /// Both rotary axes, on both branches.
    pub(crate) two: Option<ClosedForm>,
    pub(crate) linear: Option<LinearFormulas>,
}

impl InverseFormulas {
    pub(crate) fn of(model: &Model, solved: &Solved) -> Self {
        let (one, two) = match &solved.orientation {
            Orientation::Fixed { .. } => (None, None),
            Orientation::One(one) => (angle_of_one(model, solved, one), None),
            Orientation::Two(two) => (None, ClosedForm::of_two(model, solved, two)),
        };
        Self { one, two, linear: LinearFormulas::of(model, solved) }
    }
}

/// Rotary axes of both branches, then the linear axes.
pub(crate) fn formulas(model: &Model, solved: &Solved, inverse: &InverseFormulas) -> Section {
    let mut section = Section::default();
    match &solved.orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => {
            section.words("Rotary axis from the tool axis (i, j, k):");
            match &inverse.one {
                Some(angle) => section.equations(&[(letter(model, one.rotary), angle.clone())]),
                None => in_steps(model, solved, &[(one.rotary, one.word)], &mut section),
            }
        }
        Orientation::Two(two) => of_two(model, solved, two, inverse.two.clone(), &mut section),
    }
    section.gap();
    linear(model, solved, inverse.linear.as_ref(), &mut section);
    section
}

fn of_two(model: &Model, solved: &Solved, two: &TwoRotaries, closed: Option<ClosedForm>, section: &mut Section) {
    section.words("Rotary axes from the tool axis (i, j, k):");
    let Some(closed) = closed else {
        let words = two.rotaries.into_iter().zip(two.branches[0].words).collect::<Vec<_>>();
        section.words("first branch, step by step:");
        in_steps(model, solved, &words, section);
        section.words("second branch: the same with -root in place of root");
        return;
    };
    section.equations(closed.named_root().as_slice());
    for (title, branch) in ["first branch:", "second branch:"].into_iter().zip(closed.branches()) {
        section.words(title);
        let equations: Vec<(Formula, Formula)> =
            two.rotaries.into_iter().map(|axis| letter(model, axis)).zip(branch).collect();
        section.equations(&equations);
    }
}

/// Angles in the order of evaluation, as the code computes them.
fn in_steps(model: &Model, solved: &Solved, words: &[(AxisId, SineCosine)], section: &mut Section) {
    let outputs: Vec<Id> = words.iter().flat_map(|(_, word)| word.nodes()).collect();
    let known = steps(model, &solved.graph, &outputs, section);
    let formula = |node: Id| Formula::of_node(model, &solved.graph, node, &known);
    let angles =
        words.iter().map(|(axis, word)| (letter(model, *axis), Formula::call("atan2", word.nodes().map(formula))));
    section.equations(&angles.collect::<Vec<_>>());
}

/// Signs that distinguish the branches: `α1 s2 - α2 c2` has the sign of `σ`. If `α1` or `α2` is identically zero, this
/// is the sign of a single cosine or sine.
pub(crate) fn branches(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let Orientation::Two(two) = &solved.orientation else {
        section.words("one solution");
        return section;
    };
    let second = &model.axes[two.rotaries[1]];
    let name = Formula::name(second.letter.to_string());
    let alpha =
        two.second.alpha.map(|node| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring().value(poly)));
    let reversed = second.reversed;
    let mut positive = two.first_is_plus();
    let of_axis = |function: &str| Formula::call(function, [name.clone()]);
    let quantity = match alpha {
        [Some(factor), Some(other)] if other.abs() < 1e-12 => {
            positive = positive == ((factor > 0.0) != reversed);
            of_axis("sin")
        }
        [Some(other), Some(factor)] if other.abs() < 1e-12 => {
            positive = positive == (factor < 0.0);
            of_axis("cos")
        }
        _ => general_side(model, solved, two),
    };
    let (sign, other) = if positive { (">=", "<=") } else { ("<=", ">=") };
    for (title, sign) in [("first branch:  ", sign), ("second branch: ", other)] {
        section.line(
            line(title)
                .math(&quantity)
                .words(" ")
                .both(sign, if sign == ">=" { "$\\geq$" } else { "$\\leq$" })
                .words(" 0"),
        );
    }
    section.line(line("Both branches coincide where ").math(&quantity).words(" = 0."));
    section
}

fn general_side(model: &Model, solved: &Solved, two: &TwoRotaries) -> Formula {
    let mut graph = solved.graph.clone();
    let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
    let side = two.side(model, &mut reader);
    let number = common_number(&side.coefficients().collect::<Vec<_>>()).inverse().unwrap_or_else(Surd::one);
    match Formula::of_poly(model, graph.ring(), &side.scaled(&number)) {
        // A square is not negative.
        Formula::Product(mut factors) => {
            factors.retain(|factor| !matches!(factor, Formula::Power(_, power) if power % 2 == 0));
            if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
        }
        other => other,
    }
}

/// Operations of the inverse kinematics.
pub(crate) fn operations(solved: &Solved) -> Section {
    let graph = &solved.graph;
    let values: Vec<Id> = solved.position.values.iter().map(|(_, node)| *node).collect();
    let position = Operations::of(graph, &values);
    let (count, atan2) = match &solved.orientation {
        Orientation::Fixed { deviation } => (Operations::of(graph, &[*deviation]).and(position), 0),
        Orientation::One(one) => {
            (Operations::of(graph, &[one.word.sine, one.word.cosine, one.deviation]).and(position), 1)
        }
        Orientation::Two(two) => {
            let nodes: Vec<Id> = two
                .branches
                .iter()
                .flat_map(|answer| answer.words.iter().flat_map(|word| word.nodes()))
                .chain([two.second.root])
                .collect();
            let own = two
                .branches
                .iter()
                .flat_map(|answer| answer.angles)
                .filter(|angle| *angle == AngleRelation::Own)
                .count();
            (Operations::of(graph, &nodes).and(position).and(position), own)
        }
    };
    let Operations { additions, products, divisions, roots } = count;
    let many = |count: usize, word: &str| format!("{count} {word}{}", if count == 1 { "" } else { "s" });
    let mut section = Section::default();
    section.words(&format!(
        "all branches: {atan2} atan2, {roots} sqrt, {}, {}, {}",
        many(divisions, "division"),
        many(products, "multiplication"),
        many(additions, "addition")
    ));
    section
}
