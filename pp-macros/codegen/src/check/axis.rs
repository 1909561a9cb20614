//! One axis of the chain: exact direction, point of the centre line, travel limits, speed.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::quantity::{self, DimensionNames, Fault};
use crate::model::{Axis, AxisKind, LETTERS, Side, kind_of};
use crate::report::Errors;
use crate::symbolic::{Poly, PolyVector, Ring, Surd};
use crate::syntax::{Assign, Base, Declaration, Direction, Limits, Offsets, SpannedName, Unit, Vector};

/// One axis of the chain with everything declared for it; `None` if the name is not an axis letter.
pub(crate) fn axis(
    spot: &SpannedName,
    side: Side,
    declaration: &Declaration,
    names: &DimensionNames<'_>,
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
        (Some(Offsets::Common(vector)), AxisKind::Rotary) => Some(vector),
        (Some(Offsets::Each(entries)), _) => find(entries, letter).map(|entry| &entry.value),
        _ => None,
    };
    let point = point.map_or_else(zeros, |vector| lengths(vector, names, ring, errors));
    let held = find(&declaration.hold, letter).and_then(|entry| axis_value(&entry.value, letter, kind, errors));
    let limits = limits(declaration, letter, kind, errors);
    let speed = speed(declaration, letter, kind, errors);
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
        sin_cos: ring.sin_cos(format!("sin_{lower}"), format!("cos_{lower}")),
    })
}

/// Both ends of the travel; `None`: no limits.
fn limits(
    declaration: &Declaration,
    letter: &str,
    kind: AxisKind,
    errors: &mut Errors,
) -> Option<(BigRational, BigRational)> {
    match find(&declaration.limits, letter).map(|entry| &entry.value) {
        Some(Limits::Range(ends)) => {
            let (lower, upper) = &**ends;
            let phrase = lower.phrase.to(upper.phrase);
            let ends = (axis_value(lower, letter, kind, errors), axis_value(upper, letter, kind, errors));
            if let (Some(lower), Some(upper)) = &ends
                && lower > upper
            {
                errors.push(
                    phrase,
                    format!("the travel of `{letter}` is empty: its lower end is above its upper end"),
                    "write the smaller value first: `-5..110`",
                );
            }
            ends.0.zip(ends.1)
        }
        _ => None,
    }
}

fn speed(declaration: &Declaration, letter: &str, kind: AxisKind, errors: &mut Errors) -> Option<BigRational> {
    find(&declaration.speeds, letter).and_then(|entry| {
        let help = "rotary axes have deg/min, deg/s or rpm, linear axes mm/min, mm/s, m/min or in/min";
        let quantities = ["a speed of rotation", "a speed along a line"];
        let value = with_unit_of(kind, &entry.value, letter, quantities, help, errors)?;
        if !value.is_positive() {
            errors.push(
                entry.value.phrase,
                format!("the speed of `{letter}` must be above zero"),
                "give the speed in deg/min for a rotary axis, in mm/min for a linear axis",
            );
        }
        Some(value)
    })
}

fn find<'a, T>(entries: &'a [Assign<T>], letter: &str) -> Option<&'a Assign<T>> {
    entries.iter().find(|entry| entry.key.name == letter)
}

/// A constant in the unit of an axis: degrees for rotary, mm for linear.
fn axis_value(value: &crate::syntax::Expr, letter: &str, kind: AxisKind, errors: &mut Errors) -> Option<BigRational> {
    let help = "give values of rotary axes in degrees, of linear axes in mm";
    with_unit_of(kind, value, letter, ["an angle", "a length"], help, errors)
}

/// A constant in the unit of an axis, or the message that it is the quantity of the other kind of axes.
fn with_unit_of(
    kind: AxisKind,
    value: &crate::syntax::Expr,
    letter: &str,
    [of_rotary, of_linear]: [&str; 2],
    help: &str,
    errors: &mut Errors,
) -> Option<BigRational> {
    match quantity::number(value) {
        Ok((number, unit)) => {
            let wrong = match (kind, unit) {
                (AxisKind::Linear, Some(Unit::Degree)) => Some(("a linear axis", of_rotary)),
                (AxisKind::Rotary, Some(Unit::Millimetre)) => Some(("a rotary axis", of_linear)),
                _ => None,
            };
            if let Some((axis, quantity)) = wrong {
                let text = format!("`{letter}` is {axis}, but its value is {quantity}");
                errors.push(value.phrase, text, help);
            }
            Some(number)
        }
        Err(fault) => {
            fault.report(errors);
            None
        }
    }
}

fn zeros() -> PolyVector {
    std::array::from_fn(|_| Poly::zero())
}

/// The direction of a coordinate: 0, 1, 2 for X, Y, Z.
pub(crate) fn coordinate(index: usize) -> PolyVector {
    std::array::from_fn(|row| if row == index { Poly::one() } else { Poly::zero() })
}

fn lengths(vector: &Vector, names: &DimensionNames<'_>, ring: &Ring, errors: &mut Errors) -> PolyVector {
    std::array::from_fn(|index| {
        quantity::length(&vector.parts[index], names, ring).unwrap_or_else(|fault| {
            fault.report(errors);
            Poly::zero()
        })
    })
}

/// Exact unit vector of a direction.
pub(crate) fn unit_direction(
    direction: &Direction,
    names: &DimensionNames<'_>,
    ring: &mut Ring,
    errors: &mut Errors,
) -> PolyVector {
    let result = (|| -> Result<PolyVector, Fault> {
        let mut unit = match &direction.base {
            Base::Coordinate(index) => coordinate(*index),
            Base::Vector(vector) => normalised(vector, ring)?,
        };
        if direction.negated {
            unit = unit.map(|part| -&part);
        }
        // The product is a matrix product: the factor next to the vector acts first.
        for (axis, angle) in direction.rotations.iter().rev() {
            let (sine, cosine) = quantity::angle(angle, names, ring)?;
            unit = crate::symbolic::rotation(&coordinate(*axis), &sine, &cosine, ring).rotate(&unit, ring);
        }
        Ok(unit)
    })();
    result.unwrap_or_else(|fault| {
        fault.report(errors);
        coordinate(2)
    })
}

fn normalised(vector: &Vector, ring: &mut Ring) -> Result<PolyVector, Fault> {
    let mut parts: Vec<Surd> = Vec::new();
    for part in &vector.parts {
        parts.push(quantity::ratio(part)?);
    }
    // Divided by its largest component, (0.7071067811865476, 0, 0.7071067811865476) becomes (1, 0, 1).
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
            "give at least one component that is not zero",
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
