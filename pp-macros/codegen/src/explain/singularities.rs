//! Limits of the inverse kinematics: free rotaries, unreachable tool axes, degenerate linear axes.

use std::collections::BTreeMap;

use super::chain::{coordinate, vector};
use super::section::{Section, line};
use super::travel::within_travel;
use crate::formula::Formula;
use crate::model::Model;
use crate::solve::{Orientation, Pole, Solved, Tilt};
use crate::symbolic::{Id, Interpreter, PolyVector};

/// Tool axes at which a rotary is free.
pub(crate) fn singular_set(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let two = match &solved.orientation {
        Orientation::Fixed { .. } => {
            section.words("never: there is no rotary axis to solve for");
            return section;
        }
        Orientation::One(_) => {
            section.words("never");
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
        let mut text_line = line(&format!("{letter} is free where the tool axis is parallel to it{at}"));
        if let (true, Some(direction)) = (at.is_empty(), &direction) {
            text_line = text_line.words(", along ").vector(&vector(model, direction));
        }
        section.line(text_line);
        section
            .words(&format!("There (sine of the angle between them below 1e-15) {letter} keeps its previous value."));
    } else {
        section.words(&format!(
            "{letter} is free only where held values or dimensions make the tool axis parallel to it."
        ));
    }
    section
}

/// The direction of the first rotary in the workpiece, if no held value changes it.
fn direction(model: &Model, solved: &Solved, tilt: &Tilt) -> Option<PolyVector> {
    let parts = tilt.direction.map(|node| solved.graph.constant_of(node).cloned());
    let [x, y, z] = parts;
    let direction = [x?, y?, z?];
    // Directions that the solver found to be constant can be written in the model's ring.
    direction.iter().all(|part| model.ring.value(part).is_some() || part.is_zero()).then_some(direction)
}

/// Angles between tool axis and first rotary.
pub(crate) fn reachable(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    cone(model, solved, &mut section);
    within_travel(model, solved, &mut section);
    section
}

/// The angles between tool axis and first rotary for any rotary angles.
fn cone(model: &Model, solved: &Solved, section: &mut Section) {
    let value = |node: Id| solved.graph.constant_of(node).and_then(|poly| solved.graph.ring().value(poly));
    let (rotary, tilt) = match &solved.orientation {
        Orientation::Fixed { .. } => {
            section.words("a single tool axis: there is no rotary axis to solve for");
            return;
        }
        Orientation::One(one) => (one.rotary, &one.tilt),
        Orientation::Two(two) => (two.rotaries[0], &two.tilt),
    };
    let letter = model.axes[rotary].letter;
    let (Some(between), Some(tool)) = (value(tilt.between.cosine), value(tilt.tool.cosine)) else {
        section.words(&format!("angles to the axis of {letter} in a range that depends on dimensions or held axes"));
        return;
    };
    let (between, tool) = (between.acos().to_degrees(), tool.acos().to_degrees());
    let (smallest, largest) = ((between - tool).abs(), 180.0 - (180.0 - between - tool).abs());
    let [smallest, largest] = [smallest, largest].map(|degrees| (degrees * 1e6).round() / 1e6);
    if smallest <= 0.0 && largest >= 180.0 {
        section.words("every tool axis, within the limits of the axes");
        return;
    }
    let range = if largest - smallest <= 0.0 {
        format!("{smallest} degrees")
    } else {
        format!("{smallest} to {largest} degrees")
    };
    let mut text_line = line(&format!("{range} between the tool axis and the axis of {letter}"));
    if let Some((name, turned)) = direction(model, solved, tilt).as_ref().and_then(coordinate) {
        let text = inequality(name, turned, smallest, largest);
        let latex = text.replace("<=", "\\leq").replace(">=", "\\geq");
        text_line = text_line.words(", that is ").both(&text, &format!("${latex}$"));
    }
    section.line(text_line);
}

/// A range of angles to a coordinate direction, or to its opposite, as an inequality of `i`, `j` or `k`.
fn inequality(coordinate: &str, turned: bool, smallest: f64, largest: f64) -> String {
    let component = match coordinate {
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
    if most - least <= 0.0 {
        format!("{component} = {least}")
    } else if least <= -1.0 {
        format!("{component} <= {most}")
    } else if most >= 1.0 {
        format!("{component} >= {least}")
    } else {
        format!("{least} <= {component} <= {most}")
    }
}

/// Rotary angles at which the linear axes degenerate.
pub(crate) fn degenerate(model: &Model, solved: &Solved) -> Section {
    let mut section = Section::default();
    let letters = model.letters(model.solved_linears());
    let mut graph = solved.graph.clone();
    let node = solved.position.determinant;
    let value = Interpreter::new(&mut graph, BTreeMap::new()).value(node);
    let formula = Formula::of_poly(model, graph.ring(), &value);
    if graph.ring().value(&value).is_some() {
        section.line(
            line(&format!("none: in every position the determinant of the directions of {letters} is ")).math(&formula),
        );
    } else {
        section.line(
            line(&format!("where the determinant of the directions of {letters} is near zero: "))
                .both(&format!("|{}|", formula.text()), &format!("$|{}|$", formula.latex()))
                .words(" < 1e-9"),
        );
    }
    section
}
