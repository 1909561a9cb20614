//! The chain, its matrices and its forward map.

use std::collections::BTreeMap;

use super::section::{Line, Section, line};
use crate::formula::Formula;
use crate::model::{Axis, AxisId, AxisKind, Model, Side};
use crate::symbolic::{Matrix, Poly, PolyVector, Surd, Symbol, rotation};

/// Axes with their directions, centre lines and signs.
pub(crate) fn chain(model: &Model) -> Section {
    let side =
        |wanted: Side| model.letters(model.axes.iter().enumerate().filter(|(_, a)| a.side == wanted).map(|(id, _)| id));
    let mut section = Section::default();
    let chain = format!("{} | {}", side(Side::Workpiece), side(Side::Tool));
    section.words(&format!("{}: the axes from workpiece to tool; | is the machine frame", chain.trim()));
    section.gap();
    let rows: Vec<Vec<Line>> = model.axes.iter().map(|axis| row(model, axis)).collect();
    section.table(&rows);
    section.gap();
    section.line(
        line("The tool axis is ")
            .vector(&vector(model, &model.tool_axis))
            .words(" from tip to spindle, with all axes at zero."),
    );
    let has = |reversed: bool| model.axes.iter().any(|axis| axis.reversed == reversed);
    if has(false) {
        section.line(
            line("Sign +: a positive word moves the tool relative to the workpiece along the direction, ")
                .words("or right-handed about it (ISO 841)."),
        );
    }
    if has(true) {
        section
            .line(line("Sign ").both("-", "$-$").words(": a positive word moves the axis in the opposite direction."));
    }
    let rotary = |side: Side| model.axes.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == side);
    if rotary(Side::Workpiece) {
        section.words("Centre lines in the table are given from the table's reference point.");
    }
    if rotary(Side::Tool) {
        section.words("Centre lines in the head are given from the gauge line of the spindle.");
    }
    section
}

fn row(model: &Model, axis: &Axis) -> Vec<Line> {
    let side = if axis.side == Side::Workpiece { "table" } else { "spindle" };
    let verb = if axis.kind == AxisKind::Linear { "linear along " } else { "rotary about " };
    let centre = match axis.kind {
        AxisKind::Linear => Line::default(),
        AxisKind::Rotary => line("centre line through ").vector(&vector(model, &axis.point)),
    };
    let held = match &axis.held {
        None => Line::default(),
        Some(value) => {
            let unit = if axis.kind == AxisKind::Rotary { "°" } else { " mm" };
            line("held, default ").math(&Formula::Number(Surd::from(value.clone()))).words(unit)
        }
    };
    let sign = if axis.reversed { line("sign ").both("-", "$-$") } else { line("sign +") };
    vec![
        line(&axis.letter.to_string()),
        line(side),
        line(verb).vector(&vector(model, &axis.direction)),
        centre,
        sign,
        held,
    ]
}

/// Components as formulas.
pub(crate) fn vector(model: &Model, vector: &PolyVector) -> [Formula; 3] {
    vector.each_ref().map(|part| Formula::of_poly(model, &model.ring, part))
}

/// Elementary matrices and the product of all.
pub(crate) fn matrices(model: &Model) -> Section {
    let mut section = Section::default();
    let names: Vec<Formula> = model.axes.iter().map(|axis| Formula::name(format!("T_{}", axis.letter))).collect();
    for (id, axis) in model.axes.iter().enumerate() {
        match axis.kind {
            AxisKind::Linear => {
                let joint = model.joint(id).origin();
                let by = vector(model, &joint);
                section.line(line("").math(&names[id]).words(" = Trans").vector(&by));
            }
            AxisKind::Rotary => rotary(model, id, &names[id], &mut section),
        }
    }
    section.gap();
    let product = Formula::Product(names);
    let whole = Formula::name("T");
    section.line(line("").math(&whole).words(" = ").math(&product).words(", from the tool to the workpiece:"));
    section.gap();
    section.matrix(&whole, &entries(model, &model.product()), "T_");
    section
}

fn rotary(model: &Model, id: AxisId, name: &Formula, section: &mut Section) {
    let axis = &model.axes[id];
    let letter = axis.letter;
    let centre = Formula::name(format!("c_{letter}"));
    let word = Formula::name(letter.to_string());
    let word = if axis.reversed { word.negated() } else { word };
    let rotation_name = Formula::name(format!("R_{letter}"));
    let about = match coordinate(&axis.direction) {
        Some((name, false)) => line("").math(&Formula::name(name)),
        Some((name, true)) => line("").math(&Formula::name(name).negated()),
        None => line("").vector(&vector(model, &axis.direction)),
    };
    let moved = |by: &Formula| line("Trans(").math(by).words(")");
    section.line(
        line("")
            .math(name)
            .words(" = ")
            .append(&moved(&centre))
            .words(" ")
            .math(&rotation_name)
            .words(" ")
            .append(&moved(&centre.clone().negated()))
            .words(", ")
            .math(&centre)
            .words(" = ")
            .vector(&vector(model, &model.centre(id))),
    );
    section.line(line("").math(&rotation_name).words(" = Rot(").append(&about).words(", ").math(&word).words("):"));
    let matrix = rotation(&axis.direction, &model.joint_sine(id), &Poly::from(axis.sin_cos.1), &model.ring);
    section.gap();
    section.matrix(&rotation_name, &entries(model, &matrix), &format!("R_{letter}"));
    section.gap();
}

/// `x`, `y` or `z`, and whether the direction is its negative.
pub(crate) fn coordinate(direction: &PolyVector) -> Option<(&'static str, bool)> {
    let numbers = direction.each_ref().map(Poly::as_number);
    for (index, name) in ["x", "y", "z"].into_iter().enumerate() {
        let others = (0..3).filter(|other| *other != index).all(|other| direction[other].is_zero());
        let Some(number) = &numbers[index] else { continue };
        if others && number.is_one() {
            return Some((name, false));
        }
        if others && (-number).is_one() {
            return Some((name, true));
        }
    }
    None
}

fn entries(model: &Model, matrix: &Matrix) -> Vec<Vec<Formula>> {
    let formula = |poly: &Poly| Formula::of_poly(model, &model.ring, poly);
    matrix.0.iter().map(|row| row.iter().map(formula).collect()).collect()
}

/// An axis by its letter.
pub(crate) fn letter(model: &Model, axis: AxisId) -> Formula {
    Formula::name(model.axes[axis].letter.to_string())
}

/// Tool axis and tip.
pub(crate) fn forward(model: &Model) -> Section {
    let mut section = Section::default();
    let product = model.product();
    let axis = product.rotate(&model.tool_axis, &model.ring);
    section.equations(&named(["i", "j", "k"], vector(model, &axis)));
    section.gap();
    let tip = product.origin();
    let short = tip.each_ref().map(|part| at_the_table(model, part));
    let moved = short.iter().zip(&tip).any(|(short, whole)| short != whole);
    if moved {
        section.line(line("with the part origin at the table's reference point:"));
    }
    section.equations(&named(["x", "y", "z"], vector(model, &short)));
    if moved {
        section.gap();
        section.line(line("with the part origin at ").vector(&part(model)).words(":"));
        section.equations(&named(["x", "y", "z"], vector(model, &tip)));
    }
    section
}

pub(crate) fn named(names: [&str; 3], formulas: [Formula; 3]) -> Vec<(Formula, Formula)> {
    names.into_iter().map(Formula::name).zip(formulas).collect()
}

/// The part origin's symbols.
pub(crate) fn part(model: &Model) -> [Formula; 3] {
    model.symbols.part.map(|symbol| Formula::of_poly(model, &model.ring, &Poly::from(symbol)))
}

/// The polynomial with the part origin at the table's reference point.
pub(crate) fn at_the_table(model: &Model, poly: &Poly) -> Poly {
    let none: BTreeMap<Symbol, Poly> = model.symbols.part.into_iter().map(|symbol| (symbol, Poly::zero())).collect();
    model.ring.substitute(poly, &none)
}
