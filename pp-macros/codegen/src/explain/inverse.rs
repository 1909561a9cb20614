//! The inverse kinematics: formulas, branches, and where they end.
//!
//! Formulas are read from the nodes of the code as polynomials and factored. They are the same functions, but not the
//! same operations: what keeps the digits near the pole stays in the code.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{at_the_table, coordinate, part, vector};
use super::page::{Section, line};
use crate::emit::Count;
use crate::formula::{Formula, Known, common_number};
use crate::model::{AxisId, Model};
use crate::solve::{Angle, Orientation, Solved, Tilt, Two};
use crate::symbolic::{Graph, Id, Interpreter, Node, P3, Poly, Surd, Symbol};

/// Polynomials with more terms than this are shown step by step, as they are computed.
const LONGEST: usize = 60;

/// Roots with at most this much under them are written in place.
const SHORT: usize = 2;

/// Rotary axes of both branches, then the linear axes.
pub(super) fn formulas(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    match &solved.orientation {
        Orientation::Fixed { .. } => {}
        Orientation::One(one) => {
            section.say("Rotary axis from the tool axis (i, j, k):");
            let mut graph = solved.graph.clone();
            let word = stripped(&graph, one.word, one.inverse);
            match angle(&mut graph, word, None).filter(is_readable) {
                Some(parts) => section.equations(&[(letter(model, one.rotary), atan2(model, &graph, &parts))]),
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

fn is_readable(parts: &[Poly; 2]) -> bool {
    parts.iter().all(|part| part.coefficients().count() <= LONGEST)
}

/// Whether a reciprocal of what is no number is in it.
fn is_divided(graph: &Graph, poly: &Poly) -> bool {
    let unknown = |symbol: Symbol| graph.ring.value(&Poly::from(symbol)).is_none();
    let mut symbols = poly.terms().flat_map(|(powers, _)| powers).map(|(symbol, _)| *symbol);
    symbols.any(|symbol| graph.ring.divisor(symbol).is_some() && unknown(symbol))
}

/// A node without a sign and without a positive factor or divisor.
type Signed = (bool, Id);

/// Sine and cosine without the factor, or divisor, that both have.
fn stripped(graph: &Graph, (sine, cosine): (Id, Id), common: Id) -> [Signed; 2] {
    let without = |id: Id| {
        let (minus, inner) = match *graph.node(id) {
            Node::Neg(inner) => (true, inner),
            _ => (false, id),
        };
        match *graph.node(inner) {
            Node::Mul(a, b) if b == common => Some((minus, a)),
            Node::Mul(a, b) if a == common => Some((minus, b)),
            Node::Div(a, b) if b == common => Some((minus, a)),
            _ if graph.is_zero(inner) => Some((minus, inner)),
            _ => None,
        }
    };
    match (without(sine), without(cosine)) {
        (Some(sine), Some(cosine)) => [sine, cosine],
        _ => [(false, sine), (false, cosine)],
    }
}

/// The arguments of an `atan2`, without a common number; `None` if something is divided by what is no number.
fn angle(graph: &mut Graph, word: [Signed; 2], root: Option<(Id, &Poly)>) -> Option<[Poly; 2]> {
    let mut reader = Interpreter::new(graph, BTreeMap::new());
    if let Some((root, square)) = root {
        reader.assume_square(root, square.clone());
    }
    let parts = word.map(|(minus, node)| {
        let value = reader.value(node);
        if minus { -&value } else { value }
    });
    if parts.iter().any(|part| is_divided(graph, part)) {
        return None;
    }
    // Terms without the root get plain numbers first.
    let rooted = |powers: &[(Symbol, u32)]| powers.iter().any(|(symbol, _)| graph.ring.name(*symbol) == "r");
    let terms: Vec<_> = parts.iter().flat_map(Poly::terms).collect();
    let all: Vec<&Surd> = terms.iter().map(|(_, factor)| *factor).collect();
    let plain: Vec<&Surd> = terms.iter().filter(|(powers, _)| !rooted(powers)).map(|(_, factor)| *factor).collect();
    let number = common_number(if plain.is_empty() { &all } else { &plain });
    let inverse = number.inverse().unwrap_or_else(Surd::one);
    Some(parts.map(|part| part.scaled(&inverse)))
}

fn atan2(model: &Model, graph: &Graph, [sine, cosine]: &[Poly; 2]) -> Formula {
    Formula::call("atan2", [sine, cosine].map(|part| Formula::of_poly(model, &graph.ring, part)))
}

fn of_two(model: &Model, solved: &Solved, two: &Two, section: &mut Section) {
    section.say("Rotary axes from the tool axis (i, j, k):");
    let Some(Closed { radicand, branches }) = closed(model, solved, two) else {
        let words = two.rotaries.into_iter().zip(two.answers[0].words).collect::<Vec<_>>();
        section.say("first branch, step by step:");
        in_steps(model, solved, &words, section);
        section.say("second branch: the same with -root for root");
        return;
    };
    let short = radicand.size() <= SHORT;
    let root = Formula::call("sqrt", [radicand]);
    let branches = branches.map(|branch| branch.map(|formula| if short { replaced(formula, &root) } else { formula }));
    if branches.iter().flatten().any(mentions_root) {
        section.equations(&[(Formula::name("r"), root)]);
    }
    for (title, branch) in ["first branch:", "second branch:"].into_iter().zip(branches) {
        section.say(title);
        let equations: Vec<(Formula, Formula)> =
            two.rotaries.into_iter().map(|axis| letter(model, axis)).zip(branch).collect();
        section.equations(&equations);
    }
}

/// Both angles of both branches, over the root `r` of one radicand.
struct Closed {
    radicand: Formula,
    branches: [[Formula; 2]; 2],
}

/// `None` if they are too long to be read in one line.
fn closed(model: &Model, solved: &Solved, two: &Two) -> Option<Closed> {
    let mut graph = solved.graph.clone();
    // r² = D - w², whatever way the code takes to it.
    let square = {
        let mut reader = Interpreter::new(&mut graph, BTreeMap::new());
        let (capacity, height) = (reader.value(two.capacity), reader.value(two.height));
        let square = reader.ring().mul(&height, &height);
        &capacity - &square
    };
    let mut formula = |word: (Id, Id), common: Id| {
        let word = stripped(&graph, word, common);
        let parts = angle(&mut graph, word, Some((two.root, &square))).filter(is_readable)?;
        Some(atan2(model, &graph, &parts))
    };
    let [first, second] = two
        .answers
        .map(|answer| Some([formula(answer.words[0], two.inverse)?, formula(answer.words[1], two.capacity)?]));
    Some(Closed { branches: [first?, second?], radicand: Formula::of_poly(model, &graph.ring, &square) })
}

/// `T = atan2(...)` of the first branch for each solved rotary axis, where that is no longer than a line.
pub(crate) fn first_branch(model: &Model, solved: &Solved) -> Vec<(AxisId, Formula)> {
    match &solved.orientation {
        Orientation::Fixed { .. } => Vec::new(),
        Orientation::One(one) => {
            let mut graph = solved.graph.clone();
            let word = stripped(&graph, one.word, one.inverse);
            let parts = angle(&mut graph, word, None).filter(is_readable);
            parts.map(|parts| (one.rotary, atan2(model, &graph, &parts))).into_iter().collect()
        }
        Orientation::Two(two) => {
            let Some(Closed { radicand, branches: [first, _] }) = closed(model, solved, two) else { return Vec::new() };
            let root = Formula::call("sqrt", [radicand]);
            two.rotaries.into_iter().zip(first.map(|formula| replaced(formula, &root))).collect()
        }
    }
}

/// The root in place of its name.
fn replaced(formula: Formula, root: &Formula) -> Formula {
    let all = |parts: Vec<Formula>| parts.into_iter().map(|part| replaced(part, root)).collect();
    match formula {
        Formula::Name(name) if name == "r" => root.clone(),
        Formula::Neg(inner) => Formula::Neg(Box::new(replaced(*inner, root))),
        Formula::Sum(parts) => Formula::Sum(all(parts)),
        Formula::Product(parts) => Formula::Product(all(parts)),
        // An angle may be called r.
        Formula::Call(function, parts) if function != "sin" && function != "cos" => Formula::Call(function, all(parts)),
        Formula::Quotient(above, below) => {
            Formula::Quotient(Box::new(replaced(*above, root)), Box::new(replaced(*below, root)))
        }
        other => other,
    }
}

fn mentions_root(formula: &Formula) -> bool {
    match formula {
        Formula::Name(name) => name == "r",
        Formula::Number(_) | Formula::Degrees(_) => false,
        Formula::Call(function, _) if function == "sin" || function == "cos" => false,
        Formula::Neg(inner) | Formula::Power(inner, _) => mentions_root(inner),
        Formula::Sum(parts) | Formula::Product(parts) | Formula::Call(_, parts) => parts.iter().any(mentions_root),
        Formula::Quotient(above, below) => mentions_root(above) || mentions_root(below),
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
    let long = polys.any(|poly| poly.coefficients().count() > LONGEST || is_divided(&graph, poly));
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
        let formula = Formula::of_poly(model, &graph.ring, &determinant);
        section.equations(&[(below.clone(), formula)]);
    }
    let written = |of: &dyn Fn(&Poly) -> Poly| -> Vec<(Formula, Formula)> {
        let formula = |(axis, divided, poly): &(AxisId, bool, Poly)| {
            let formula = Formula::of_poly(model, &graph.ring, &of(poly));
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
    let alpha = two.alpha.map(|node| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring.value(poly)));
    let reversed = second.reversed;
    let mut positive = two.first_is_plus;
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
    let [first, other] = two.alpha.map(|node| reader.value(node));
    let side = &reader.ring().mul(&first, &model.joint_sine(second)) - &reader.ring().mul(&other, &cosine);
    let number = common_number(&side.coefficients().collect::<Vec<_>>()).inverse().unwrap_or_else(Surd::one);
    match Formula::of_poly(model, &graph.ring, &side.scaled(&number)) {
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
    if two.has_pole {
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
    let value = |node: Id| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring.value(poly));
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
    let formula = Formula::of_poly(model, &graph.ring, &value);
    if graph.ring.value(&value).is_some() {
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
    let position = Count::of(graph, &values);
    let (count, atan2) = match &solved.orientation {
        Orientation::Fixed { deviation } => (Count::of(graph, &[*deviation]).and(position), 0),
        Orientation::One(one) => (Count::of(graph, &[one.word.0, one.word.1, one.deviation]).and(position), 1),
        Orientation::Two(two) => {
            let nodes: Vec<Id> = two
                .answers
                .iter()
                .flat_map(|answer| answer.words.iter().flat_map(|(sine, cosine)| [*sine, *cosine]))
                .chain([two.root])
                .collect();
            let own = two.answers.iter().flat_map(|answer| answer.angles).filter(|angle| *angle == Angle::Own).count();
            (Count::of(graph, &nodes).and(position).and(position), own)
        }
    };
    let Count { additions, products, divisions, roots } = count;
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
