//! The value of an expression.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::scope::Scope;
use super::value::{Angle, Inverse, Value};
use crate::check::Fault;
use crate::suggest;
use crate::symbolic::{Poly, Surd, sin_cos_of_degrees};
use crate::syntax::{Expr, ExprKind, Unit};

impl Scope<'_> {
    /// The value of an expression.
    pub(crate) fn value(&mut self, expr: &Expr) -> Result<Value, Fault> {
        match &expr.kind {
            ExprKind::Number(degrees, Some(Unit::Degree)) => {
                let (sine, cosine) = sin_cos_of_degrees(degrees, self.algebra_mut().ring_mut());
                Ok(Value::Angle(Angle { cosine, sine, inverse: None }))
            }
            ExprKind::Number(value, _) => Ok(Value::Number(Poly::from(Surd::from(value.clone())))),
            ExprKind::Name(name) => self.name(name, expr),
            ExprKind::Neg(inner) => Ok(match self.value(inner)? {
                Value::Number(value) => Value::Number(-&value),
                Value::Angle(angle) => Value::Angle(angle.negated()),
            }),
            ExprKind::Binary(left, operator, right) => self.binary(expr, left, *operator, right),
            ExprKind::Power(base, exponent) => {
                let base = self.number(base)?;
                let mut power = Poly::one();
                for _ in 0..*exponent {
                    power = self.algebra().times(&power, &base, expr)?;
                }
                Ok(Value::Number(power))
            }
            ExprKind::Call(name, arguments) => self.call(expr, name, arguments),
        }
    }

    fn binary(&mut self, expr: &Expr, left: &Expr, operator: char, right: &Expr) -> Result<Value, Fault> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        match (a, operator, b) {
            (Value::Number(a), '+', Value::Number(b)) => Ok(Value::Number(&a + &b)),
            (Value::Number(a), '-', Value::Number(b)) => Ok(Value::Number(&a - &b)),
            (Value::Number(a), '*', Value::Number(b)) => Ok(Value::Number(self.algebra().times(&a, &b, expr)?)),
            (Value::Number(a), _, Value::Number(b)) => {
                let inverse = self.algebra_mut().reciprocal(b, right)?;
                Ok(Value::Number(self.algebra().times(&a, &inverse, expr)?))
            }
            (Value::Angle(a), '+', Value::Angle(b)) => Ok(Value::Angle(self.algebra().sum(&a, &b, expr)?)),
            (Value::Angle(a), '-', Value::Angle(b)) => Ok(Value::Angle(self.algebra().sum(&a, &b.negated(), expr)?)),
            (Value::Angle(angle), '+' | '-', Value::Number(zero)) if zero.is_zero() => Ok(Value::Angle(angle)),
            (Value::Number(zero), '+', Value::Angle(angle)) if zero.is_zero() => Ok(Value::Angle(angle)),
            (Value::Number(zero), '-', Value::Angle(angle)) if zero.is_zero() => Ok(Value::Angle(angle.negated())),
            (Value::Angle(angle), '*', Value::Number(factor)) | (Value::Number(factor), '*', Value::Angle(angle)) => {
                Ok(Value::Angle(self.algebra().multiple(&angle, &factor, expr)?))
            }
            (_, '+' | '-', _) => Err(Fault::new(
                expr.phrase,
                "an angle and a number cannot be added or subtracted",
                "give the number its unit, `90 deg`, or take sin or cos of the angle",
            )),
            _ => Err(Fault::new(
                expr.phrase,
                "an angle can be added to or subtracted from an angle, or multiplied by a whole number",
                "take sin or cos of it: `x * cos(C)`",
            )),
        }
    }

    fn call(&mut self, expr: &Expr, name: &str, arguments: &[Expr]) -> Result<Value, Fault> {
        match (name, arguments) {
            ("tan", [argument]) => self.value(&tangent(expr, argument)),
            ("sin" | "cos", [argument]) if half_of(argument).is_some() => Err(half_angle(expr, name, argument)),
            ("sin" | "cos", [argument]) => {
                let angle = self.angle(argument)?;
                let part = match (name, &angle.inverse) {
                    ("sin", Some(Inverse::Sine(part))) | ("cos", Some(Inverse::Cosine(part, _))) => part.clone(),
                    ("sin", _) => self.algebra_mut().unit_part(&angle, &angle.sine, argument)?,
                    _ => self.algebra_mut().unit_part(&angle, &angle.cosine, argument)?,
                };
                Ok(Value::Number(part))
            }
            ("sqrt", [argument]) => {
                let radicand = self.number(argument)?;
                Ok(Value::Number(self.algebra_mut().root(radicand, argument)?))
            }
            ("atan2", [sine, cosine]) => {
                let (sine, cosine) = (self.number(sine)?, self.number(cosine)?);
                Ok(Value::Angle(Angle { cosine, sine, inverse: None }))
            }
            ("asin" | "acos", [argument]) => {
                let part = self.number(argument)?;
                let square = self.algebra().times(&part, &part, expr)?;
                let other = self.algebra_mut().root(&Poly::one() - &square, expr)?;
                Ok(Value::Angle(if name == "asin" {
                    Angle { cosine: other, sine: part.clone(), inverse: Some(Inverse::Sine(part)) }
                } else {
                    Angle { cosine: part.clone(), sine: other, inverse: Some(Inverse::Cosine(part, false)) }
                }))
            }
            ("sin" | "cos" | "tan" | "sqrt" | "asin" | "acos", _) => Err(Fault::new(
                expr.phrase,
                format!("`{name}` takes one argument, found {}", arguments.len()),
                format!("write `{name}(...)` of one expression"),
            )),
            ("atan2", _) => Err(Fault::new(
                expr.phrase,
                format!("`atan2` takes two arguments, found {}", arguments.len()),
                "write `atan2(sine, cosine)`",
            )),
            _ => {
                let text = format!("`{name}` is not a function of `verify`");
                Err(Fault::new(expr.phrase, text, function_meant(name, arguments)))
            }
        }
    }

    /// A number, or a message that this is an angle.
    fn number(&mut self, expr: &Expr) -> Result<Poly, Fault> {
        match self.value(expr)? {
            Value::Number(value) => Ok(value),
            Value::Angle(_) => Err(Fault::new(
                expr.phrase,
                format!("expected a number, but `{expr}` is an angle"),
                format!("take its sine or cosine: `sin({expr})`"),
            )),
        }
    }

    fn angle(&mut self, expr: &Expr) -> Result<Angle, Fault> {
        match self.value(expr)? {
            Value::Angle(angle) => Ok(angle),
            Value::Number(zero) if zero.is_zero() => Ok(Angle::zero()),
            Value::Number(_) => Err(Fault::new(
                expr.phrase,
                format!("`{expr}` is not an angle"),
                "an angle is a rotary axis, an angle of `dims`, `45 deg`, or atan2, asin, acos of numbers",
            )),
        }
    }
}

/// `sin(a) / cos(a)`, and for half an angle `sin(a) / (1 + cos(a))`: the tangent has the same value in every
/// revolution.
fn tangent(expr: &Expr, argument: &Expr) -> Expr {
    let with = |kind: ExprKind| Expr { phrase: expr.phrase, kind };
    let call = |name: &str, of: &Expr| with(ExprKind::Call(name.into(), vec![of.clone()]));
    let (of, divisor) = match half_of(argument) {
        Some(whole) => {
            let one = with(ExprKind::Number(BigRational::from(BigInt::from(1)), None));
            (whole, with(ExprKind::Binary(Box::new(one), '+', Box::new(call("cos", whole)))))
        }
        None => (argument, call("cos", argument)),
    };
    with(ExprKind::Binary(Box::new(call("sin", of)), '/', Box::new(divisor)))
}

/// The angle of which an expression is half: `B / 2`, `0.5 * B`.
fn half_of(expr: &Expr) -> Option<&Expr> {
    let is = |expr: &Expr, above: i32, below: i32| {
        let wanted = BigRational::new(BigInt::from(above), BigInt::from(below));
        matches!(&expr.kind, ExprKind::Number(value, None) if *value == wanted)
    };
    match &expr.kind {
        ExprKind::Binary(whole, '/', two) if is(two, 2, 1) => Some(whole),
        ExprKind::Binary(half, '*', whole) if is(half, 1, 2) => Some(whole),
        ExprKind::Binary(whole, '*', half) if is(half, 1, 2) => Some(whole),
        _ => None,
    }
}

/// The sine or cosine of half an angle.
fn half_angle(expr: &Expr, name: &str, argument: &Expr) -> Fault {
    let whole = half_of(argument).map(ToString::to_string).unwrap_or_default();
    let (sign, square) = if name == "sin" { ('-', "sin") } else { ('+', "cos") };
    Fault::new(
        expr.phrase,
        format!("the sign of `{expr}` changes from one revolution to the next"),
        format!(
            "write `(1 {sign} cos({whole})) / 2` for `{square}({argument})^2`, `sin({whole}) / 2` for the product of \
             both, or use `tan({argument})`"
        ),
    )
}

/// What a function that is not known probably means.
fn function_meant(name: &str, arguments: &[Expr]) -> String {
    const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "asin", "acos", "atan2", "sqrt"];
    let all: Vec<String> = arguments.iter().map(ToString::to_string).collect();
    let all = all.join(", ");
    let lower = name.to_lowercase();
    match (lower.as_str(), arguments) {
        ("atan" | "arctan" | "atn" | "atg" | "arctg" | "tan_inverse", [argument]) => match &argument.kind {
            ExprKind::Binary(above, '/', below) => {
                format!("a quotient loses the quadrant: write `atan2({above}, {below})`")
            }
            _ => "it loses the quadrant: write `atan2(sine, cosine)`".into(),
        },
        ("atan" | "arctan" | "arctan2" | "atan_2", [_, _]) => format!("write `atan2({all})`"),
        ("arcsin", _) => format!("write `asin({all})`"),
        ("arccos", _) => format!("write `acos({all})`"),
        ("tg", _) => format!("write `tan({all})`"),
        ("cot" | "ctg", [argument]) => format!("write `cos({argument}) / sin({argument})`"),
        ("sec", [argument]) => format!("write `1 / cos({argument})`"),
        ("csc" | "cosec", [argument]) => format!("write `1 / sin({argument})`"),
        ("sind" | "s", _) => format!("write `sin({all})`"),
        ("cosd" | "c", _) => format!("write `cos({all})`"),
        _ => {
            match FUNCTIONS.iter().find(|known| **known == lower).copied().or_else(|| suggest::nearest(name, FUNCTIONS))
            {
                Some(known) => format!("write `{known}({all})`"),
                None => "the functions are sin, cos, tan, asin, acos, atan2 and sqrt".into(),
            }
        }
    }
}
