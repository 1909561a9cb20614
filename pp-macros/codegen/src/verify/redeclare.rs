//! Single changes of the declaration with which the equations of a block follow: a sign, an offset, a direction, or the
//! order of two axes that was declared the wrong way round.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;

use super::repair::negated;
use super::{Block, MOST_REPAIR_WORK};
use crate::check::{Checked, Fault, check};
use crate::model::{Axis, AxisKind, Side, kind_of};
use crate::report::{Errors, Phrase};
use crate::solve::solve;
use crate::syntax::{Assign, Base, Declaration, Direction, Expr, ExprKind, Offsets, SpannedName, Unit, Vector, Verify};

/// A declaration with one field changed.
struct Change {
    declaration: Declaration,
    /// What is changed, or the axis whose sign or direction is not declared.
    phrase: Phrase,
    /// The field as it would be written.
    field: String,
}

/// A field, as it would be written, with which every equation follows; and the place of what it changes.
#[derive(Debug, Clone)]
pub(crate) struct Redeclared {
    pub(crate) field: String,
    pub(crate) phrase: Phrase,
}

/// For each of the `failing` blocks, the changes with which all its equations follow, and those of the `holding` blocks
/// as well; `count` equations fail.
pub(crate) fn redeclared(
    declaration: &Declaration,
    failing: &[&Verify],
    holding: &[&Verify],
    count: usize,
) -> Vec<Vec<Redeclared>> {
    let mut found = vec![Vec::new(); failing.len()];
    let changes = if failing.is_empty() { Vec::new() } else { changes(declaration, count) };
    let mut work = 0;
    let mut machines: Vec<Vec<Axis>> = Vec::new();
    for Change { declaration, phrase, field } in changes {
        let Ok(Checked { model, .. }) = check(&declaration, &mut Errors::default()) else { continue };
        if machines.iter().any(|known| is_same_chain(known, &model.axes)) {
            continue;
        }
        let product = model.product();
        let mut follows = |block: &&Verify| {
            if work > MOST_REPAIR_WORK {
                return Ok(false);
            }
            let (follows, spent) = Block::new(&model, model.ring.clone(), &product, block)?.follows();
            work += spent;
            Ok::<bool, Vec<Fault>>(follows)
        };
        let fixed: Vec<bool> = failing.iter().map(|block| follows(block).unwrap_or(false)).collect();
        if !fixed.contains(&true) || !holding.iter().all(|block| follows(block).unwrap_or(false)) {
            continue;
        }
        if solve(&model).is_err() {
            continue;
        }
        machines.push(model.axes.clone());
        for (changes, _) in found.iter_mut().zip(fixed).filter(|(_, fixed)| *fixed) {
            changes.push(Redeclared { field: field.clone(), phrase });
        }
    }
    found
}

/// True if two changes make the same chain of the same axes.
fn is_same_chain(first: &[Axis], second: &[Axis]) -> bool {
    let place = |axis: &Axis| (axis.letter, axis.side == Side::Tool, axis.reversed);
    let is_same = |(one, other): (&Axis, &Axis)| {
        place(one) == place(other) && one.direction == other.direction && one.point == other.point
    };
    first.len() == second.len() && first.iter().zip(second).all(is_same)
}

/// All changes that are tried, the likeliest first. A single equation is no reason to doubt the letter of an axis.
fn changes(declaration: &Declaration, count: usize) -> Vec<Change> {
    let mut found = Vec::new();
    let Some(chain) = &declaration.chain else { return found };
    signs(declaration, &chain.axes, &mut found);
    offsets(declaration, &mut found);
    directions(declaration, &mut found);
    if count > 1 {
        coordinates(declaration, &chain.axes, &mut found);
    }
    orders(declaration, &mut found);
    found
}

/// One axis counted in the opposite direction.
fn signs(declaration: &Declaration, axes: &[SpannedName], found: &mut Vec<Change>) {
    for axis in axes {
        let mut declaration = declaration.kinematics();
        let phrase = match declaration.signs.iter_mut().find(|entry| entry.key.name == axis.name) {
            Some(entry) => {
                entry.value = !entry.value;
                entry.key.phrase
            }
            None => {
                declaration.signs.push(Assign { key: axis.clone(), value: true });
                axis.phrase
            }
        };
        let field = entries("signs", &declaration.signs, |reversed| if *reversed { "-".into() } else { "+".into() });
        found.push(Change { declaration, phrase, field });
    }
}

/// One component of a centre line with the other sign.
fn offsets(declaration: &Declaration, found: &mut Vec<Change>) {
    let vectors = match &declaration.offsets {
        None => return,
        Some(Offsets::Common(vector)) => vec![vector],
        Some(Offsets::Each(entries)) => entries.iter().map(|entry| &entry.value).collect(),
    };
    for (place, vector) in vectors.into_iter().enumerate() {
        for (changed, phrase) in with_a_component_negated(vector) {
            let mut declaration = declaration.kinematics();
            let field = match &mut declaration.offsets {
                Some(Offsets::Common(vector)) => {
                    *vector = changed;
                    format!("d = {vector};")
                }
                Some(Offsets::Each(each)) => {
                    each[place].value = changed;
                    entries("d", each, ToString::to_string)
                }
                None => continue,
            };
            found.push(Change { declaration, phrase, field });
        }
    }
}

/// One direction with an angle measured the other way, a component with the other sign, or another coordinate.
fn directions(declaration: &Declaration, found: &mut Vec<Change>) {
    for (place, Assign { key, value }) in declaration.directions.iter().enumerate() {
        // The opposite direction is the opposite sign.
        for changed in other_directions(value) {
            let mut declaration = declaration.kinematics();
            declaration.directions[place].value = changed;
            let field = entries("axes", &declaration.directions, ToString::to_string);
            found.push(Change { declaration, phrase: key.phrase.to(value.phrase), field });
        }
    }
    if let Some(direction) = &declaration.tool_axis {
        let opposite = Direction { negated: !direction.negated, ..direction.clone() };
        for changed in std::iter::once(opposite).chain(other_directions(direction)) {
            let mut declaration = declaration.kinematics();
            let field = format!("tool_axis = {changed};");
            let phrase = changed.phrase;
            declaration.tool_axis = Some(changed);
            found.push(Change { declaration, phrase, field });
        }
    }
}

/// A rotary axis about another coordinate than that of its letter.
fn coordinates(declaration: &Declaration, axes: &[SpannedName], found: &mut Vec<Change>) {
    let declared = |axis: &SpannedName| declaration.directions.iter().any(|entry| entry.key.name == axis.name);
    for axis in axes.iter().filter(|axis| kind_of(&axis.name) == Some(AxisKind::Rotary) && !declared(axis)) {
        let own = ["A", "B", "C"].iter().position(|letter| *letter == axis.name);
        for coordinate in (0..3).filter(|coordinate| Some(*coordinate) != own) {
            let mut declaration = declaration.kinematics();
            let base = Base::Coordinate(coordinate);
            let value = Direction { phrase: axis.phrase, rotations: Vec::new(), negated: false, base };
            declaration.directions.push(Assign { key: axis.clone(), value });
            let field = entries("axes", &declaration.directions, ToString::to_string);
            found.push(Change { declaration, phrase: axis.phrase, field });
        }
    }
}

/// Two axes next to each other in the other order; linear axes can be listed in any order among themselves.
fn orders(declaration: &Declaration, found: &mut Vec<Change>) {
    let Some(chain) = &declaration.chain else { return };
    for place in 1..chain.axes.len() {
        let [first, second] = [&chain.axes[place - 1], &chain.axes[place]];
        if [first, second].iter().all(|axis| kind_of(&axis.name) == Some(AxisKind::Linear)) {
            continue;
        }
        let phrase = first.phrase.to(second.phrase);
        let mut declaration = declaration.kinematics();
        let Some(chain) = &mut declaration.chain else { continue };
        chain.axes.swap(place - 1, place);
        let field = chain.to_string();
        found.push(Change { declaration, phrase, field });
    }
}

/// The direction with one rotation in the opposite direction or measured from another coordinate, with another
/// coordinate, or with one component of the other sign.
fn other_directions(direction: &Direction) -> Vec<Direction> {
    let mut others = Vec::new();
    for (place, (_, angle)) in direction.rotations.iter().enumerate() {
        let opposite = negated(angle);
        let quarter = |degrees: i32, from: &Expr| {
            let degrees = ExprKind::Number(BigRational::from(BigInt::from(degrees)), Some(Unit::Degree));
            let degrees = Box::new(Expr { phrase: angle.phrase, kind: degrees });
            Expr { phrase: angle.phrase, kind: ExprKind::Binary(degrees, '-', Box::new(from.clone())) }
        };
        for changed in [quarter(90, angle), quarter(-90, angle)].into_iter().chain([opposite]).rev() {
            let mut other = direction.clone();
            other.rotations[place].1 = changed;
            others.push(other);
        }
    }
    match &direction.base {
        Base::Coordinate(own) => {
            let coordinates = (0..3).filter(|coordinate| coordinate != own);
            others.extend(coordinates.map(|other| Direction { base: Base::Coordinate(other), ..direction.clone() }));
        }
        // The sign of the only component is that of the direction.
        Base::Vector(vector) => {
            let changed = with_a_component_negated(vector);
            if changed.len() > 1 {
                let bases = changed.into_iter().map(|(vector, _)| Base::Vector(vector));
                others.extend(bases.map(|base| Direction { base, ..direction.clone() }));
            }
        }
    }
    others
}

/// The vector with the other sign of each component that is not zero, and the place of that component.
fn with_a_component_negated(vector: &Vector) -> Vec<(Vector, Phrase)> {
    let is_zero = |part: &Expr| matches!(&part.kind, ExprKind::Number(value, _) if value.is_zero());
    let places = (0..vector.parts.len()).filter(|place| !is_zero(&vector.parts[*place]));
    let changed = places.map(|place| {
        let mut changed = vector.clone();
        changed.parts[place] = negated(&vector.parts[place]);
        (changed, vector.parts[place].phrase)
    });
    changed.collect()
}

/// `signs = { B: -, C: + };`
fn entries<T>(field: &str, entries: &[Assign<T>], text: impl Fn(&T) -> String) -> String {
    let entries: Vec<String> =
        entries.iter().map(|entry| format!("{}: {}", entry.key.name, text(&entry.value))).collect();
    format!("{field} = {{ {} }};", entries.join(", "))
}
