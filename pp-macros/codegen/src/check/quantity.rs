//! Expressions to exact quantities: numbers, lengths, angles.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::model::{Dimension, Quantity, to_f64};
use crate::report::{Errors, Phrase};
use crate::suggest;
use crate::symbolic::{Poly, Ring, Surd, angle_sum, sin_cos_of_degrees};
use crate::syntax::{Declaration, Expr, ExprKind, Unit, Unreadable};

/// One mistake inside an expression.
#[derive(Debug)]
pub(crate) struct Fault {
    phrase: Phrase,
    text: String,
    help: String,
    /// True if the cause is reported elsewhere, so that this mistake gives no message.
    silent: bool,
}

impl Fault {
    pub(crate) fn new(phrase: Phrase, text: impl Into<String>, help: impl Into<String>) -> Self {
        Self { phrase, text: text.into(), help: help.into(), silent: false }
    }

    pub(crate) fn report(self, errors: &mut Errors) {
        if !self.silent {
            errors.push(self.phrase, self.text, self.help);
        }
    }
}

/// Dimensions that expressions may name.
pub(crate) struct DimensionNames<'a> {
    pub(crate) dimensions: &'a [Dimension],
    /// Entries that could not be read; no further message mentions them.
    pub(crate) unreadable: &'a Unreadable,
}

impl DimensionNames<'_> {
    fn find(&self, name: &str, phrase: Phrase) -> Result<Quantity, Fault> {
        if let Some(known) = self.dimensions.iter().find(|known| known.name == name) {
            return Ok(known.quantity);
        }
        let known: Vec<&str> = self.dimensions.iter().map(|known| known.name.as_str()).collect();
        let help = if known.is_empty() {
            format!("declare it: `dims = {{ {name}: 100.0 }};`")
        } else {
            suggest::or_list(name, &known, "the dimensions are")
        };
        let silent = self.unreadable.has_entry("dims", name);
        Err(Fault { silent, ..Fault::new(phrase, format!("`{name}` is not a dimension"), help) })
    }
}

/// A constant with at most one kind of unit: `-5`, `45 deg`, `3/2`.
pub(crate) fn number(expr: &Expr) -> Result<(BigRational, Option<Unit>), Fault> {
    let (value, unit) = constant(expr)?;
    match value.as_rational() {
        Some(value) if !to_f64(&value).is_finite() => Err(too_large(expr)),
        Some(value) => Ok((value, unit)),
        None => Err(Fault::new(expr.phrase, "expected a rational number", "write it in decimal digits")),
    }
}

/// The default of a dimension: a constant.
pub(crate) fn default(expr: &Expr, declaration: &Declaration) -> Result<(BigRational, Option<Unit>), Fault> {
    let name = declaration.dimensions.iter().map(|entry| entry.key.name.as_str()).find(|name| expr.mentions(name));
    match name {
        Some(name) => Err(Fault::new(
            expr.phrase,
            format!("the default of a dimension is a number, but `{expr}` depends on `{name}`"),
            format!("write the number, and `{expr}` where the length is used: `d = (0, 0, {expr});`"),
        )),
        None => number(expr),
    }
}

fn too_large(expr: &Expr) -> Fault {
    Fault::new(expr.phrase, "this number is too large", "the largest number is about 1.8e308")
}

/// A constant without a unit.
pub(crate) fn ratio(expr: &Expr) -> Result<Surd, Fault> {
    match constant(expr)? {
        (value, None) => Ok(value),
        (_, Some(_)) => Err(Fault::new(
            expr.phrase,
            "a component of a direction has no unit",
            "write plain numbers: `(0, 1, -0.5)`",
        )),
    }
}

fn constant(expr: &Expr) -> Result<(Surd, Option<Unit>), Fault> {
    let mixed = || {
        Fault::new(
            expr.phrase,
            "these units cannot be combined",
            "add and subtract equal units, multiply and divide by plain numbers",
        )
    };
    match &expr.kind {
        ExprKind::Number(value, unit) => Ok((Surd::from(value.clone()), *unit)),
        ExprKind::Name(name) => Err(Fault::new(
            expr.phrase,
            format!("`{name}` is not a number"),
            "only numbers are allowed here, such as `150.0` or `45 deg`",
        )),
        ExprKind::Neg(inner) => constant(inner).map(|(value, unit)| (-&value, unit)),
        ExprKind::Binary(left, operator, right) => {
            let ((a, a_unit), (b, b_unit)) = (constant(left)?, constant(right)?);
            match operator {
                '+' | '-' if a_unit != b_unit => Err(mixed()),
                '+' => Ok((&a + &b, a_unit)),
                '-' => Ok((&a - &b, a_unit)),
                '*' if a_unit.is_some() && b_unit.is_some() => Err(mixed()),
                '*' => Ok((&a * &b, a_unit.or(b_unit))),
                _ if b_unit.is_some() => Err(mixed()),
                _ => match b.inverse() {
                    Some(inverse) => Ok((&a * &inverse, a_unit)),
                    None => Err(Fault::new(right.phrase, "division by zero", "give a divisor that is not zero")),
                },
            }
        }
        ExprKind::Power(base, exponent) => match constant(base)? {
            (value, None) => Ok(((0..*exponent).fold(Surd::one(), |power, _| &power * &value), None)),
            _ => Err(mixed()),
        },
        ExprKind::Call(name, arguments) => {
            let fault = |text: &str| Fault::new(expr.phrase, text, "for example `sqrt(2)/2`");
            match (name.as_str(), &arguments[..]) {
                ("sqrt", [argument]) => match constant(argument)? {
                    (value, None) => value
                        .sqrt()
                        .map(|root| (root, None))
                        .ok_or_else(|| fault("`sqrt` takes a rational number that is not negative")),
                    _ => Err(mixed()),
                },
                _ => Err(fault("the only function allowed here is `sqrt` of a number")),
            }
        }
    }
}

/// A length in mm: numbers, lengths of `dims`, `+ - *` of them.
pub(crate) fn length(expr: &Expr, names: &DimensionNames<'_>, ring: &Ring) -> Result<Poly, Fault> {
    let (value, power) = measured(expr, names, ring)?;
    if !value.coefficients().all(|factor| factor.to_f64().is_finite()) {
        return Err(too_large(expr));
    }
    if power <= 1 || value.is_zero() {
        return Ok(value);
    }
    Err(Fault::new(expr.phrase, "this product is an area, not a length", "multiply a length by a plain number"))
}

/// A polynomial and its power of mm. A number without a unit has power 0 and is accepted as a length.
fn measured(expr: &Expr, names: &DimensionNames<'_>, ring: &Ring) -> Result<(Poly, u32), Fault> {
    let angle = || Fault::new(expr.phrase, "expected a length, found an angle", "components of `d` are lengths in mm");
    match &expr.kind {
        ExprKind::Number(_, Some(Unit::Degree)) => Err(angle()),
        ExprKind::Number(value, unit) => Ok((Poly::from(Surd::from(value.clone())), u32::from(unit.is_some()))),
        ExprKind::Name(name) => match names.find(name, expr.phrase)? {
            Quantity::Length(symbol) => Ok((Poly::from(symbol), 1)),
            Quantity::Angle(..) => Err(angle()),
        },
        ExprKind::Neg(inner) => measured(inner, names, ring).map(|(value, power)| (-&value, power)),
        ExprKind::Binary(left, operator @ ('+' | '-'), right) => {
            let ((a, a_power), (b, b_power)) = (measured(left, names, ring)?, measured(right, names, ring)?);
            Ok((if *operator == '+' { &a + &b } else { &a - &b }, a_power.max(b_power)))
        }
        ExprKind::Binary(left, '*', right) => {
            let ((a, a_power), (b, b_power)) = (measured(left, names, ring)?, measured(right, names, ring)?);
            Ok((ring.mul(&a, &b), a_power + b_power))
        }
        ExprKind::Binary(left, _, right) => {
            let ((a, power), b) = (measured(left, names, ring)?, ratio(right)?);
            match b.inverse() {
                Some(inverse) => Ok((a.scaled(&inverse), power)),
                None => Err(Fault::new(right.phrase, "division by zero", "give a divisor that is not zero")),
            }
        }
        ExprKind::Power(..) | ExprKind::Call(..) => Ok((Poly::from(ratio(expr)?), 0)),
    }
}

/// Sine and cosine of an angle: degrees, angles of `dims`, sums and whole multiples of them.
pub(crate) fn angle(expr: &Expr, names: &DimensionNames<'_>, ring: &mut Ring) -> Result<(Poly, Poly), Fault> {
    match &expr.kind {
        ExprKind::Number(degrees, Some(Unit::Degree)) => Ok(sin_cos_of_degrees(degrees, ring)),
        ExprKind::Number(value, None) if *value == BigRational::from(BigInt::from(0)) => {
            Ok(sin_cos_of_degrees(value, ring))
        }
        ExprKind::Number(_, None) => {
            Err(Fault::new(expr.phrase, "an angle needs a unit", "add the unit, for example `45 deg`"))
        }
        ExprKind::Number(_, Some(Unit::Millimetre)) => {
            Err(Fault::new(expr.phrase, "expected an angle, found a length", "add the unit, for example `45 deg`"))
        }
        ExprKind::Name(name) => match names.find(name, expr.phrase)? {
            Quantity::Angle(sine, cosine) => Ok((Poly::from(sine), Poly::from(cosine))),
            Quantity::Length(_) => Err(Fault::new(
                expr.phrase,
                format!("expected an angle, but `{name}` is a length"),
                format!("a dimension whose default has `deg` is an angle: `dims = {{ {name}: -45 deg }};`"),
            )),
        },
        ExprKind::Neg(inner) => angle(inner, names, ring).map(|(sine, cosine)| (-&sine, cosine)),
        ExprKind::Binary(left, operator @ ('+' | '-'), right) => {
            let (a, (s, c)) = (angle(left, names, ring)?, angle(right, names, ring)?);
            let s = if *operator == '+' { s } else { -&s };
            Ok(angle_sum(&a, &(s, c), ring))
        }
        ExprKind::Binary(left, '*', right) => {
            let (factor, angle_part) = if ratio(left).is_ok() { (left, right) } else { (right, left) };
            let pair = angle(angle_part, names, ring)?;
            let times = ratio(factor).ok().and_then(|f| f.as_rational()).filter(BigRational::is_integer);
            let Some(times) = times.and_then(|times| times.to_integer().to_i32()).filter(|n| n.abs() <= 24) else {
                return Err(Fault::new(
                    factor.phrase,
                    "an angle can be multiplied only by a whole number up to 24",
                    "write `2 * alpha`",
                ));
            };
            let step = if times < 0 { (-&pair.0, pair.1) } else { pair };
            let start = (Poly::zero(), Poly::one());
            Ok((0..times.abs()).fold(start, |sum, _| angle_sum(&sum, &step, ring)))
        }
        _ => Err(Fault::new(
            expr.phrase,
            "this is not an angle",
            "write degrees or an angle of `dims`: `Rx(-45 deg)`, `Rx(alpha)`",
        )),
    }
}
