//! The inverse kinematics: formulas, branches, and where they end.
//!
//! Formulas are read from the nodes of the code as polynomials and factored. They are the same functions, but not the
//! same operations: what keeps the digits near the pole stays in the code.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{at_the_table, coordinate, part, vector};
use super::page::{Section, line};
use crate::formula::{ClosedForm, Formula, Known, angle_of_one, common_number, is_readable};
use crate::model::{AxisId, Model};
use crate::solve::{AngleRelation, Orientation, Pole, Solved, Tilt, Two};
use crate::symbolic::{Graph, Id, Interpreter, Node, Operations, P3, Poly, Surd};

/// Rotary axes of both branches, then the linear axes.
pub(super) fn formulas(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    match &solved.orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => {
            section.say("Rotary axis from the tool axis (i, j, k):");
            match angle_of_one(model, solved, one) {
                Some(angle) => section.equations(&[(letter(model, one.rotary), angle)]),
                None => in_steps(model, solved, &[(one.rotary, one.word)], &mut section),
            }
        }
        Orientation::Two(two) => of_two(model, solved, two, &mut section),
    }
    section.gap();
    linear(model, solved, &mut section);
    section
}

fn letter(model: &Model, axis: AxisId) -> Formula {
    Formula::name(model.axes[axis].letter.to_string())
}

fn of_two(model: &Model, solved: &Solved, two: &Two, section: &mut Section) {
    section.say("Rotary axes from the tool axis (i, j, k):");
    let Some(closed) = ClosedForm::of_two(model, solved, two) else {
        let words = two.rotaries.into_iter().zip(two.branches[0].words).collect::<Vec<_>>();
        section.say("first branch, step by step:");
        in_steps(model, solved, &words, section);
        section.say("second branch: the same with -root for root");
        return;
    };
    section.equations(closed.named_root().as_slice());
    for (title, branch) in ["first branch:", "second branch:"].into_iter().zip(closed.branches()) {
        section.say(title);
        let equations: Vec<(Formula, Formula)> =
            two.rotaries.into_iter().map(|axis| letter(model, axis)).zip(branch).collect();
        section.equations(&equations);
    }
}

/// Angles in the order of evaluation, as the code computes them.
fn in_steps(model: &Model, solved: &Solved, words: &[(AxisId, (Id, Id))], section: &mut Section) {
    let outputs: Vec<Id> = words.iter().flat_map(|(_, (sine, cosine))| [*sine, *cosine]).collect();
    let known = steps(model, &solved.graph, &outputs, section);
    let formula = |node: Id| Formula::of_node(model, &solved.graph, node, &known);
    let angles = words.iter().map(|(axis, (sine, cosine))| {
        (letter(model, *axis), Formula::call("atan2", [formula(*sine), formula(*cosine)]))
    });
    section.equations(&angles.collect::<Vec<_>>());
}

/// One equation for everything that is named in the code or needed more than once.
fn steps(model: &Model, graph: &Graph, outputs: &[Id], section: &mut Section) -> Known {
    let mut uses: BTreeMap<Id, usize> = BTreeMap::new();
    let reachable = graph.reachable(outputs);
    for operand in reachable.iter().flat_map(|id| graph.operands(*id)) {
        *uses.entry(operand).or_default() += 1;
    }
    let mut known = Known::new();
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut equations = Vec::new();
    for id in reachable {
        let plain = matches!(graph.node(id), Node::Constant(_) | Node::Input(_) | Node::Neg(_));
        let wanted = graph.name_of(id);
        if plain || (wanted.is_none() && uses.get(&id).is_none_or(|count| *count < 2)) {
            continue;
        }
        let wanted = wanted.unwrap_or("t");
        let mut name = wanted.to_string();
        let mut number = 1;
        while !taken.insert(name.clone()) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        let name = Formula::name(name);
        equations.push((name.clone(), Formula::of_node(model, graph, id, &known)));
        known.insert(id, name);
    }
    section.equations(&equations);
    known
}

fn linear(model: &Model, solved: &Solved, section: &mut Section) {
    let mut graph = solved.graph.clone();
    let position = &solved.position;
    section.say("Linear axes from the tip (x, y, z), for any values of the rotary axes:");
    let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
    let varies = solved.graph.constant_of(position.determinant).is_none();
    let divisor = |node: Id| match *solved.graph.node(node) {
        Node::Div(above, below) if below == position.determinant => Some(above),
        Node::Mul(a, b) => [(a, b), (b, a)].into_iter().find_map(|(value, inverse)| {
            matches!(*solved.graph.node(inverse), Node::Div(_, below) if below == position.determinant).then_some(value)
        }),
        _ => None,
    };
    let mut found: Vec<(AxisId, bool, Poly)> = Vec::new();
    for (axis, node) in &position.values {
        let (minus, inner) = match *solved.graph.node(*node) {
            Node::Neg(inner) => (true, inner),
            _ => (false, *node),
        };
        if let (true, Some(above)) = (varies, divisor(inner)) {
            let value = reader.value(above);
            found.push((*axis, true, if minus { -&value } else { value }));
            reader.assume(*node, Poly::from(model.axes[*axis].word));
            let word = Poly::from(model.axes[*axis].word);
            reader.assume(inner, if minus { -&word } else { word });
        }
    }
    for (axis, node) in &position.values {
        if !found.iter().any(|(other, ..)| other == axis) {
            found.push((*axis, false, reader.value(*node)));
        }
    }
    let determinant = reader.value(position.determinant);
    let divided = found.iter().any(|(_, divided, _)| *divided);
    let mut polys = found.iter().map(|(_, _, poly)| poly).chain([&determinant]);
    let long = !polys.all(|poly| is_readable(&graph, poly));
    if long {
        let values: Vec<Id> = position.values.iter().map(|(_, node)| *node).collect();
        let known = steps(model, &solved.graph, &values, section);
        let formula = |node: Id| Formula::of_node(model, &solved.graph, node, &known);
        let equations = position.values.iter().map(|(axis, node)| (letter(model, *axis), formula(*node)));
        section.equations(&equations.collect::<Vec<_>>());
        return;
    }
    let below = Formula::name("det");
    if divided {
        let formula = Formula::of_poly(model, graph.ring(), &determinant);
        section.equations(&[(below.clone(), formula)]);
    }
    let written = |of: &dyn Fn(&Poly) -> Poly| -> Vec<(Formula, Formula)> {
        let formula = |(axis, divided, poly): &(AxisId, bool, Poly)| {
            let formula = Formula::of_poly(model, graph.ring(), &of(poly));
            let formula =
                if *divided { Formula::Quotient(Box::new(formula), Box::new(below.clone())) } else { formula };
            (letter(model, *axis), formula)
        };
        found.iter().map(formula).collect()
    };
    let (short, whole) = (written(&|poly| at_the_table(model, poly)), written(&Poly::clone));
    if short == whole {
        section.equations(&whole);
        return;
    }
    section.say("with the part origin at the table's reference point:");
    section.equations(&short);
    section.line(line("with the part origin at ").vector(&part(model)).say(":"));
    section.equations(&whole);
}

/// `α1 s2 - α2 c2` has the sign of `σ`; with one of the two identically zero that is a sine or a cosine alone.
pub(super) fn branches(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let Orientation::Two(two) = &solved.orientation else {
        section.say("one solution");
        return section;
    };
    let second = &model.axes[two.rotaries[1]];
    let name = Formula::name(second.letter.to_string());
    let alpha =
        two.second.alpha.map(|node| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring().value(poly)));
    let reversed = second.reversed;
    let mut positive = two.first_is_plus();
    let turn = |function: &str| Formula::call(function, [name.clone()]);
    let quantity = match alpha {
        [Some(factor), Some(other)] if other.abs() < 1e-12 => {
            positive = positive == ((factor > 0.0) != reversed);
            turn("sin")
        }
        [Some(other), Some(factor)] if other.abs() < 1e-12 => {
            positive = positive == (factor < 0.0);
            turn("cos")
        }
        _ => general_side(model, solved, two),
    };
    let (sign, other) = if positive { (">=", "<=") } else { ("<=", ">=") };
    for (title, sign) in [("first branch:  ", sign), ("second branch: ", other)] {
        section.line(
            line(title).math(&quantity).say(" ").both(sign, if sign == ">=" { "$\\geq$" } else { "$\\leq$" }).say(" 0"),
        );
    }
    section.line(line("Where ").math(&quantity).say(" = 0 both are one."));
    section
}

fn general_side(model: &Model, solved: &Solved, two: &Two) -> Formula {
    let mut graph = solved.graph.clone();
    let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
    let second = two.rotaries[1];
    let cosine = Poly::from(model.axes[second].turn.1);
    let [first, other] = two.second.alpha.map(|node| reader.value(node));
    let side = &reader.ring().mul(&first, &model.joint_sine(second)) - &reader.ring().mul(&other, &cosine);
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

/// Where a rotary is free.
pub(super) fn singular_set(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let two = match &solved.orientation {
        Orientation::Fixed { .. } => {
            section.say("never: there is no rotary axis to solve for");
            return section;
        }
        Orientation::One(_) => {
            section.say("never");
            return section;
        }
        Orientation::Two(two) => two,
    };
    let letter = model.axes[two.rotaries[0]].letter;
    let direction = direction(model, solved, &two.tilt);
    if two.pole != Pole::Elsewhere {
        let at = match direction.as_ref().and_then(coordinate) {
            Some(("x", _)) => ", that is j = k = 0",
            Some(("y", _)) => ", that is i = k = 0",
            Some(("z", _)) => ", that is i = j = 0",
            _ => "",
        };
        let mut words = line(&format!("{letter} is free where the tool axis is parallel to it{at}"));
        if let (true, Some(direction)) = (at.is_empty(), &direction) {
            words = words.say(", along ").vector(&vector(model, direction));
        }
        section.line(words);
        section.say(&format!("There (sine of the angle between them below 1e-15) {letter} keeps the value it had."));
    } else {
        section
            .say(&format!("{letter} is free only where held values or dimensions let the tool stand parallel to it."));
    }
    section
}

/// The direction of the first rotary in the workpiece, if no held value changes it.
fn direction(model: &Model, solved: &Solved, tilt: &Tilt) -> Option<P3> {
    let parts = tilt.direction.map(|node| solved.graph.constant_of(node).cloned());
    let [x, y, z] = parts;
    let direction = [x?, y?, z?];
    // What the solver has found to be constant can be written in the model's ring.
    direction.iter().all(|part| model.ring.value(part).is_some() || part.is_zero()).then_some(direction)
}

/// Angles between tool axis and first rotary.
pub(super) fn reachable(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let value = |node: Id| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring().value(poly));
    let (rotary, tilt) = match &solved.orientation {
        Orientation::Fixed { .. } => {
            section.say("one tool axis");
            return section;
        }
        Orientation::One(one) => (one.rotary, &one.tilt),
        Orientation::Two(two) => (two.rotaries[0], &two.tilt),
    };
    let letter = model.axes[rotary].letter;
    let (Some(between), Some(tool)) = (value(tilt.between.1), value(tilt.tool.1)) else {
        section.say(&format!("an angle to the axis of {letter} that depends on dimensions or held axes"));
        return section;
    };
    let (between, tool) = (between.acos().to_degrees(), tool.acos().to_degrees());
    let (smallest, largest) = ((between - tool).abs(), 180.0 - (180.0 - between - tool).abs());
    let [smallest, largest] = [smallest, largest].map(|degrees| (degrees * 1e6).round() / 1e6);
    if smallest <= 0.0 && largest >= 180.0 {
        section.say("every tool axis, within the limits of the axes");
        return section;
    }
    let range = if largest - smallest <= 0.0 {
        format!("{smallest} degrees")
    } else {
        format!("{smallest} to {largest} degrees")
    };
    let mut words = line(&format!("{range} between the tool axis and the axis of {letter}"));
    // The same as an inequality where the axis is a coordinate direction.
    if let Some((name, turned)) = direction(model, solved, tilt).as_ref().and_then(coordinate) {
        let component = match name {
            "x" => "i",
            "y" => "j",
            _ => "k",
        };
        let cosine = |degrees: f64| {
            let value = (degrees.to_radians().cos() * 1e9).round() / 1e9 + 0.0;
            if turned { 0.0 - value } else { value }
        };
        let (most, least) = (cosine(smallest), cosine(largest));
        let (least, most) = if turned { (most, least) } else { (least, most) };
        let text = if most - least <= 0.0 {
            format!("{component} = {least}")
        } else if least <= -1.0 {
            format!("{component} <= {most}")
        } else if most >= 1.0 {
            format!("{component} >= {least}")
        } else {
            format!("{least} <= {component} <= {most}")
        };
        let latex = text.replace("<=", "\\leq").replace(">=", "\\geq");
        words = words.say(", that is ").both(&text, &format!("${latex}$"));
    }
    section.line(words);
    section
}

/// Where the linear axes degenerate.
pub(super) fn degenerate(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let letters = model.letters(model.solved_linears());
    let mut graph = solved.graph.clone();
    let node = solved.position.determinant;
    let value = Interpreter::new(&mut graph, BTreeMap::new()).value(node);
    let formula = Formula::of_poly(model, graph.ring(), &value);
    if graph.ring().value(&value).is_some() {
        section.line(line(&format!("nowhere: the determinant of {letters} is ")).math(&formula));
    } else {
        section.line(
            line(&format!("{letters} degenerate where "))
                .both(&format!("|{}|", formula.text()), &format!("$|{}|$", formula.latex()))
                .say(" < 1e-9"),
        );
    }
    section
}

/// Operations of the inverse kinematics.
pub(super) fn operations(solved: &Solved) -> Section {
    let graph = &solved.graph;
    let values: Vec<Id> = solved.position.values.iter().map(|(_, node)| *node).collect();
    let position = Operations::of(graph, &values);
    let (count, atan2) = match &solved.orientation {
        Orientation::Fixed { deviation } => (Operations::of(graph, &[*deviation]).and(position), 0),
        Orientation::One(one) => (Operations::of(graph, &[one.word.0, one.word.1, one.deviation]).and(position), 1),
        Orientation::Two(two) => {
            let nodes: Vec<Id> = two
                .branches
                .iter()
                .flat_map(|answer| answer.words.iter().flat_map(|(sine, cosine)| [*sine, *cosine]))
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
    section.say(&format!(
        "all branches: {atan2} atan2, {roots} sqrt, {}, {}, {}",
        many(divisions, "division"),
        many(products, "multiplication"),
        many(additions, "addition")
    ));
    section
}
