//! Rules of the language: [`Declaration`] to [`Model`], collecting every mistake before giving up.

pub(crate) mod quantity;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;
use syn::ext::IdentExt;

use crate::model::{Axis, Dimension, Frame, Kind, LOCALS, Model, Quantity, Side};
use crate::report::{Errors, Phrase, Refused};
use crate::solve::Refusal;
use crate::symbolic::{P3, Poly, Ring, Surd};
use crate::syntax::{Assign, Base, Chain, Declaration, Direction, Limits, Offsets, Spot, Unit, Vector};
use quantity::{Fault, Names};

/// Where the chain's letters stand, for refusals of the solver.
#[derive(Debug)]
pub struct Spots {
    chain: Phrase,
    axes: Vec<Spot>,
}

/// Names that a dimension cannot have.
const RESERVED: &[&str] = &[
    "x",
    "y",
    "z",
    "i",
    "j",
    "k",
    "gauge",
    "part_x",
    "part_y",
    "part_z",
    "part_origin",
    "gauge_length",
    "sin",
    "cos",
    "asin",
    "acos",
    "atan2",
    "sqrt",
    "Rx",
    "Ry",
    "Rz",
    "deg",
    "mm",
    "free",
    "where",
    // Reserved since edition 2024.
    "gen",
];

/// Axis letters.
const LETTERS: [&str; 9] = ["X", "Y", "Z", "U", "V", "W", "A", "B", "C"];

/// Checks a declaration.
///
/// # Errors
/// Every rule that it breaks.
pub fn check(declaration: &Declaration, errors: &mut Errors) -> Result<(Model, Spots), Refused> {
    let mut ring = Ring::default();
    let frame = frame(&mut ring);
    let dimensions = dimensions(declaration, &mut ring, errors);
    let Some(chain) = &declaration.chain else {
        if !declaration.unreadable.iter().any(|field| field == "chain") {
            let name = &declaration.name;
            let phrase = Phrase::new(name.span(), name.span(), 0);
            errors.push(phrase, "the machine has no `chain`", "list its axes: `chain: C B | X Y Z;`");
        }
        errors.propagate()?;
        unreachable!("just pushed");
    };
    check_chain(chain, declaration, errors);
    let known: Vec<&str> = chain.axes.iter().map(|axis| axis.name.as_str()).collect();
    check_letters(declaration, &known, errors);
    let names = Names { dimensions: &dimensions, unreadable: &declaration.unreadable };
    let tool_axis = match &declaration.tool_axis {
        Some(direction) => unit_direction(direction, &names, &mut ring, errors),
        None => coordinate(2),
    };
    let bar = chain.bars.first().map_or(0, |(place, _)| *place);
    let mut axes = Vec::new();
    for (place, spot) in chain.axes.iter().enumerate() {
        let side = if place < bar { Side::Workpiece } else { Side::Tool };
        axes.extend(axis(spot, side, declaration, &names, &mut ring, errors));
    }
    check_offsets(declaration, &axes, errors);
    check_derives(declaration, errors);
    errors.propagate()?;
    let name = declaration.name.unraw().to_string();
    let spots = Spots { chain: chain.phrase, axes: chain.axes.clone() };
    Ok((Model { name, axes, dimensions, tool_axis, frame, ring }, spots))
}

/// Turns refusals of the solver into messages at the letters they speak of.
pub fn report(refusals: &[Refusal], model: &Model, spots: &Spots, errors: &mut Errors) {
    for refusal in refusals {
        match *refusal {
            Refusal::DependentLinears => errors.push(
                spots.chain,
                format!(
                    "the linear axes {} cannot move the tip in every direction",
                    model.letters(model.solved_linears())
                ),
                "their directions lie in one plane; give one of them another direction in `axes`",
            ),
            Refusal::CannotTilt(axis) => {
                let letter = model.axes[axis].letter;
                errors.push(
                    spots.axes[axis].phrase,
                    format!("`{letter}` turns about the tool axis, so it cannot tilt the tool"),
                    format!("put {letter} in `hold`: `hold = {{ {letter}: 0 }};`"),
                );
            }
            Refusal::SameDirection(first, second) => {
                let (first, letter) = (model.axes[first].letter, model.axes[second].letter);
                errors.push(
                    spots.axes[second].phrase,
                    format!("`{first}` and `{letter}` turn about the same direction, so the tool cannot tilt"),
                    format!("give one of them another direction in `axes`, or put {letter} in `hold`"),
                );
            }
        }
    }
}

/// A claim that the proof could not confirm: a fault of the engine, not of the declaration.
pub fn unproven(claim: &str, spots: &Spots, errors: &mut Errors) {
    errors.push(
        spots.chain,
        format!("this machine could not be proven: {claim}"),
        "this is a fault of the generator; please report the declaration",
    );
}

fn frame(ring: &mut Ring) -> Frame {
    Frame {
        tip: ["x", "y", "z"].map(|name| ring.symbol(name)),
        axis: ring.unit_vector(["i", "j", "k"]),
        part: ["part_x", "part_y", "part_z"].map(|name| ring.symbol(name)),
        gauge: ring.symbol("gauge"),
    }
}

fn kind_of(letter: &str) -> Option<Kind> {
    let place = LETTERS.iter().position(|known| *known == letter)?;
    Some(if place < 6 { Kind::Linear } else { Kind::Rotary })
}

fn check_chain(chain: &Chain, declaration: &Declaration, errors: &mut Errors) {
    match &chain.bars[..] {
        [_] => {}
        [] => errors.push(
            chain.phrase,
            "missing `|` in the kinematic chain",
            "list the workpiece-side axes, then `|`, then the tool-side axes: `chain: C B | X Y Z;`",
        ),
        [_, rest @ ..] => errors.push(
            rest[0].1,
            "double `|` in the kinematic chain",
            "there is one machine frame: write `|` once, between workpiece side and tool side",
        ),
    }
    let mut seen: Vec<&str> = Vec::new();
    for axis in &chain.axes {
        let name = axis.name.as_str();
        if kind_of(name).is_none() {
            errors.push(
                axis.phrase,
                format!("`{name}` is not an axis letter"),
                "linear axes are X Y Z U V W, rotary axes A B C",
            );
        } else if seen.contains(&name) {
            errors.push(
                axis.phrase,
                format!("`{name}` stands twice in the chain"),
                "every axis has a letter of its own",
            );
        }
        seen.push(name);
    }
    let held = |name: &str| declaration.hold.iter().any(|entry| entry.key.name == name);
    let solved = |kind: Kind| -> Vec<&Spot> {
        let mut solved: Vec<&Spot> = Vec::new();
        for axis in &chain.axes {
            let repeated = solved.iter().any(|known| known.name == axis.name);
            if kind_of(&axis.name) == Some(kind) && !held(&axis.name) && !repeated {
                solved.push(axis);
            }
        }
        solved
    };
    let linears = solved(Kind::Linear);
    if linears.len() < 3 {
        let found: Vec<&str> = linears.iter().map(|axis| axis.name.as_str()).collect();
        let found = if found.is_empty() { "none".into() } else { found.join(" ") };
        errors.push(
            chain.phrase,
            format!("a machine needs three solved linear axes, found {found}"),
            "add the missing letters to the chain, or take them out of `hold`",
        );
    }
    for axis in linears.iter().skip(3) {
        errors.push(
            axis.phrase,
            format!("`{}` is a fourth linear axis: three are solved for", axis.name),
            format!("put {} in `hold`: `hold = {{ {}: 0 }};`", axis.name, axis.name),
        );
    }
    for axis in solved(Kind::Rotary).iter().skip(2) {
        errors.push(
            axis.phrase,
            format!("`{}` is a third rotary axis: two tilt the tool", axis.name),
            format!("put {} in `hold`: `hold = {{ {}: 0 }};`", axis.name, axis.name),
        );
    }
}

/// Keys of the fields that speak of axes: known, and named once.
fn check_letters(declaration: &Declaration, known: &[&str], errors: &mut Errors) {
    fn check<T>(field: &str, entries: &[Assign<T>], known: &[&str], errors: &mut Errors) {
        for (place, entry) in entries.iter().enumerate() {
            let name = entry.key.name.as_str();
            if !known.contains(&name) {
                errors.push(
                    entry.key.phrase,
                    format!("`{name}` in `{field}` is not an axis of the chain"),
                    format!("the axes are {}", known.join(" ")),
                );
            } else if entries[..place].iter().any(|earlier| earlier.key.name == name) {
                errors.push(entry.key.phrase, format!("`{name}` stands twice in `{field}`"), "keep one of the two");
            }
        }
    }
    check("signs", &declaration.signs, known, errors);
    check("axes", &declaration.directions, known, errors);
    check("hold", &declaration.hold, known, errors);
    check("limits", &declaration.limits, known, errors);
    check("speeds", &declaration.speeds, known, errors);
    if let Some(Offsets::Each(entries)) = &declaration.offsets {
        check("d", entries, known, errors);
        for entry in entries.iter().filter(|entry| kind_of(&entry.key.name) == Some(Kind::Linear)) {
            errors.push(
                entry.key.phrase,
                format!("`{}` is a linear axis: it has no centre line", entry.key.name),
                "`d` gives a point on the centre line of a rotary axis",
            );
        }
    }
}

fn check_offsets(declaration: &Declaration, axes: &[Axis], errors: &mut Errors) {
    let Some(Offsets::Common(vector)) = &declaration.offsets else { return };
    let mut sides = axes.iter().filter(|axis| axis.kind == Kind::Rotary).map(|axis| axis.side);
    let Some(first) = sides.next() else {
        errors.push(vector.phrase, "`d` is given, but the chain has no rotary axis", "leave `d` out");
        return;
    };
    if sides.any(|side| side != first) {
        errors.push(
            vector.phrase,
            "one `d` for rotary axes on both sides of `|`",
            "the sides count from different points, the table's and the spindle's: write `d = { C: (0, 0, 0), B: (0, 0, 60) };`",
        );
    }
}

/// Traits that are generated cannot be derived again.
fn check_derives(declaration: &Declaration, errors: &mut Errors) {
    for attribute in declaration.attributes.iter().filter(|attribute| attribute.path().is_ident("derive")) {
        // What cannot be read here is for rustc to say.
        let _ = attribute.parse_nested_meta(|meta| {
            if let Some(last) = meta.path.segments.last()
                && ["Clone", "Debug", "Default"].iter().any(|name| last.ident == name)
            {
                let phrase = Phrase::new(last.ident.span(), last.ident.span(), 0);
                errors.push(phrase, format!("`{}` is implemented already", last.ident), "leave it out of `derive`");
            }
            Ok(())
        });
    }
}

fn dimensions(declaration: &Declaration, ring: &mut Ring, errors: &mut Errors) -> Vec<Dimension> {
    let mut dimensions: Vec<Dimension> = Vec::new();
    for Assign { key, value } in &declaration.dimensions {
        let name = &key.name;
        if is_reserved(name) || syn::parse_str::<syn::Ident>(name).is_err() {
            errors.push(
                key.phrase,
                format!("`{name}` cannot be the name of a dimension"),
                "it means something else in the language or in Rust; choose another, such as `pivot` or `tilt`",
            );
            continue;
        }
        if dimensions.iter().any(|known| known.name == *name) {
            errors.push(key.phrase, format!("`{name}` stands twice in `dims`"), "keep one of the two");
            continue;
        }
        let (default, unit) = match quantity::number(value) {
            Ok(found) => found,
            Err(fault) => {
                fault.report(errors);
                continue;
            }
        };
        let quantity = if unit == Some(Unit::Degree) {
            let (sine, cosine) = ring.sin_cos(format!("sin_{name}"), format!("cos_{name}"));
            Quantity::Angle(sine, cosine)
        } else {
            Quantity::Length(ring.symbol(local_name(name)))
        };
        dimensions.push(Dimension { name: name.clone(), default, quantity });
    }
    dimensions
}

/// Whether a name means something else in the language.
pub(crate) fn is_reserved(name: &str) -> bool {
    LETTERS.contains(&name) || name.starts_with("r#") || RESERVED.contains(&name)
}

/// What a length is called inside generated functions: its own name, unless that is a variable there. The ring keeps
/// all other names apart.
fn local_name(name: &str) -> String {
    if LOCALS.contains(&name) { format!("dim_{name}") } else { name.to_string() }
}

fn axis(
    spot: &Spot,
    side: Side,
    declaration: &Declaration,
    names: &Names<'_>,
    ring: &mut Ring,
    errors: &mut Errors,
) -> Option<Axis> {
    let letter = spot.name.as_str();
    let kind = kind_of(letter)?;
    let direction = match find(&declaration.directions, letter) {
        Some(entry) => unit_direction(&entry.value, names, ring, errors),
        None => coordinate(LETTERS.iter().position(|known| *known == letter)? % 3),
    };
    let point = match (&declaration.offsets, kind) {
        (Some(Offsets::Common(vector)), Kind::Rotary) => Some(vector),
        (Some(Offsets::Each(entries)), _) => find(entries, letter).map(|entry| &entry.value),
        _ => None,
    };
    let point = point.map_or_else(zeros, |vector| lengths(vector, names, ring, errors));
    let held = find(&declaration.hold, letter).and_then(|entry| axis_value(&entry.value, kind, errors));
    let limits = match find(&declaration.limits, letter).map(|entry| &entry.value) {
        Some(Limits::Range(ends)) => {
            let (lower, upper) = &**ends;
            let phrase = lower.phrase.to(upper.phrase);
            let ends = (axis_value(lower, kind, errors), axis_value(upper, kind, errors));
            if let (Some(lower), Some(upper)) = &ends
                && lower > upper
            {
                errors.push(
                    phrase,
                    format!("the travel of `{letter}` is empty"),
                    "write the smaller value first: `-5..110`",
                );
            }
            ends.0.zip(ends.1)
        }
        _ => None,
    };
    let speed = find(&declaration.speeds, letter).and_then(|entry| {
        let value = axis_value(&entry.value, kind, errors)?;
        if !value.is_positive() {
            errors.push(
                entry.value.phrase,
                format!("the speed of `{letter}` is not above zero"),
                "give deg/min for rotary and mm/min for linear axes",
            );
        }
        Some(value)
    });
    let lower = letter.to_lowercase();
    Some(Axis {
        letter: letter.chars().next()?,
        kind,
        side,
        reversed: find(&declaration.signs, letter).is_some_and(|entry| entry.value),
        direction,
        point,
        held,
        limits,
        speed,
        word: ring.symbol(format!("word_{lower}")),
        turn: ring.sin_cos(format!("sin_{lower}"), format!("cos_{lower}")),
    })
}

fn find<'a, T>(entries: &'a [Assign<T>], letter: &str) -> Option<&'a Assign<T>> {
    entries.iter().find(|entry| entry.key.name == letter)
}

/// A constant in the unit of an axis: degrees for rotary, mm for linear.
fn axis_value(value: &crate::syntax::Expr, kind: Kind, errors: &mut Errors) -> Option<BigRational> {
    match quantity::number(value) {
        Ok((number, unit)) => {
            let wrong = match (kind, unit) {
                (Kind::Linear, Some(Unit::Degree)) => Some("an angle for a linear axis"),
                (Kind::Rotary, Some(Unit::Millimetre)) => Some("a length for a rotary axis"),
                _ => None,
            };
            if let Some(wrong) = wrong {
                errors.push(value.phrase, wrong, "rotary axes count in degrees, linear axes in mm");
            }
            Some(number)
        }
        Err(fault) => {
            fault.report(errors);
            None
        }
    }
}

fn zeros() -> P3 {
    std::array::from_fn(|_| Poly::zero())
}

fn coordinate(index: usize) -> P3 {
    std::array::from_fn(|row| if row == index { Poly::one() } else { Poly::zero() })
}

fn lengths(vector: &Vector, names: &Names<'_>, ring: &Ring, errors: &mut Errors) -> P3 {
    std::array::from_fn(|index| {
        quantity::length(&vector.parts[index], names, ring).unwrap_or_else(|fault| {
            fault.report(errors);
            Poly::zero()
        })
    })
}

/// The unit vector of a direction, exactly.
fn unit_direction(direction: &Direction, names: &Names<'_>, ring: &mut Ring, errors: &mut Errors) -> P3 {
    let result = (|| -> Result<P3, Fault> {
        let mut unit = match &direction.base {
            Base::Coordinate(index) => coordinate(*index),
            Base::Vector(vector) => normalised(vector, ring)?,
        };
        if direction.negated {
            unit = unit.map(|part| -&part);
        }
        // The product is a matrix product: the factor next to the vector acts first.
        for (axis, angle) in direction.turns.iter().rev() {
            let (sine, cosine) = quantity::angle(angle, names, ring)?;
            unit = crate::symbolic::rotation(&coordinate(*axis), &sine, &cosine, ring).turn(&unit, ring);
        }
        Ok(unit)
    })();
    result.unwrap_or_else(|fault| {
        fault.report(errors);
        coordinate(2)
    })
}

fn normalised(vector: &Vector, ring: &mut Ring) -> Result<P3, Fault> {
    let mut parts: Vec<Surd> = Vec::new();
    for part in &vector.parts {
        parts.push(quantity::ratio(part)?);
    }
    // Without the common factor (0.7071067811865476, 0, 0.7071067811865476) is (1, 0, 1).
    let rationals: Option<Vec<BigRational>> = parts.iter().map(Surd::as_rational).collect();
    if let Some(rationals) = rationals {
        let largest = rationals.iter().map(BigRational::abs).max().unwrap_or_else(|| BigInt::from(0).into());
        if largest.is_positive() {
            parts = rationals.iter().map(|part| Surd::from(part / &largest)).collect();
        }
    }
    let squared = parts.iter().fold(Surd::zero(), |sum, part| &sum + &(part * part));
    if squared.is_zero() {
        return Err(Fault::new(
            vector.phrase,
            "the vector (0, 0, 0) has no direction",
            "give one component that is not zero",
        ));
    }
    let inverse = match squared.sqrt().and_then(|length| length.inverse()) {
        Some(inverse) => Poly::from(inverse),
        None => {
            let length = Poly::from(ring.root("length", Poly::from(squared.clone())));
            let square_inverse = squared.inverse().unwrap_or_else(Surd::one);
            length.scaled(&square_inverse)
        }
    };
    Ok(std::array::from_fn(|index| inverse.scaled(&parts[index])))
}
