//! Expressions of the declaration, and their text.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::model::to_f64;
use crate::report::Phrase;

/// An expression and its place in the source.
#[derive(Debug, Clone)]
pub struct Expr {
    /// From its first token to its last.
    pub phrase: Phrase,
    /// Its form and its parts.
    pub kind: ExprKind,
}

/// Unit written after a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Degrees.
    Degree,
    /// Millimetres.
    Millimetre,
}

/// Kinds of expressions.
#[derive(Debug, Clone)]
pub enum ExprKind {
    /// An exact decimal number.
    Number(BigRational, Option<Unit>),
    /// A dimension.
    Name(String),
    /// `-a`
    Neg(Box<Expr>),
    /// `a + b`, `a - b`, `a * b`, `a / b`
    Binary(Box<Expr>, char, Box<Expr>),
    /// `a ^ n`
    Power(Box<Expr>, u32),
    /// `f(a, ...)`
    Call(String, Vec<Expr>),
}

impl Expr {
    /// True if the name `wanted` occurs.
    pub(crate) fn mentions(&self, wanted: &str) -> bool {
        match &self.kind {
            ExprKind::Number(..) => false,
            ExprKind::Name(name) => name == wanted,
            ExprKind::Neg(inner) | ExprKind::Power(inner, _) => inner.mentions(wanted),
            ExprKind::Binary(left, _, right) => left.mentions(wanted) || right.mentions(wanted),
            ExprKind::Call(_, arguments) => arguments.iter().any(|argument| argument.mentions(wanted)),
        }
    }

    /// All names in it, each once, in the order of their first occurrence.
    pub(crate) fn names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        self.collect_names(&mut names);
        names
    }

    fn collect_names<'a>(&'a self, names: &mut Vec<&'a str>) {
        match &self.kind {
            ExprKind::Number(..) => {}
            ExprKind::Name(name) => {
                if !names.contains(&name.as_str()) {
                    names.push(name);
                }
            }
            ExprKind::Neg(inner) | ExprKind::Power(inner, _) => inner.collect_names(names),
            ExprKind::Binary(left, _, right) => {
                left.collect_names(names);
                right.collect_names(names);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| argument.collect_names(names)),
        }
    }

    /// The expression with some parts replaced, outermost first.
    pub(crate) fn replace(&self, by: &dyn Fn(&Self) -> Option<Self>) -> Self {
        if let Some(new) = by(self) {
            return new;
        }
        let inner = |part: &Self| Box::new(part.replace(by));
        let kind = match &self.kind {
            ExprKind::Number(..) | ExprKind::Name(_) => self.kind.clone(),
            ExprKind::Neg(part) => ExprKind::Neg(inner(part)),
            ExprKind::Power(base, exponent) => ExprKind::Power(inner(base), *exponent),
            ExprKind::Binary(left, operator, right) => ExprKind::Binary(inner(left), *operator, inner(right)),
            ExprKind::Call(name, arguments) => {
                ExprKind::Call(name.clone(), arguments.iter().map(|part| part.replace(by)).collect())
            }
        };
        Self { phrase: self.phrase, kind }
    }

    /// Largest product of nested exponents.
    pub(crate) fn power(&self) -> u32 {
        match &self.kind {
            ExprKind::Number(..) | ExprKind::Name(_) => 1,
            ExprKind::Neg(inner) => inner.power(),
            ExprKind::Binary(left, _, right) => left.power().max(right.power()),
            ExprKind::Power(base, exponent) => base.power().saturating_mul((*exponent).max(1)),
            ExprKind::Call(_, arguments) => arguments.iter().map(Self::power).max().unwrap_or(1),
        }
    }
}

/// Text in the language of the macro, with necessary parentheses only.
impl std::fmt::Display for Expr {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.write(f, 0)
    }
}

impl Expr {
    /// Writes the expression, in parentheses if it binds weaker than `least`: 0 sums, 1 products, 2 unary minus,
    /// 3 powers, 4 bases of powers.
    fn write(&self, f: &mut std::fmt::Formatter<'_>, least: u8) -> std::fmt::Result {
        let strength = match &self.kind {
            ExprKind::Binary(_, '+' | '-', _) => 0,
            ExprKind::Binary(..) => 1,
            ExprKind::Neg(_) => 2,
            ExprKind::Power(..) => 3,
            ExprKind::Number(..) | ExprKind::Name(_) | ExprKind::Call(..) => 4,
        };
        if strength < least {
            f.write_str("(")?;
        }
        match &self.kind {
            ExprKind::Number(value, unit) => {
                write!(f, "{}", number_text(value))?;
                f.write_str(match unit {
                    Some(Unit::Degree) => " deg",
                    Some(Unit::Millimetre) => " mm",
                    None => "",
                })?;
            }
            ExprKind::Name(name) => f.write_str(name)?,
            ExprKind::Neg(inner) => {
                f.write_str("-")?;
                inner.write(f, 3)?;
            }
            ExprKind::Binary(left, operator, right) => {
                left.write(f, strength)?;
                write!(f, " {operator} ")?;
                right.write(f, strength + 1)?;
            }
            ExprKind::Power(base, exponent) => {
                base.write(f, 4)?;
                write!(f, "^{exponent}")?;
            }
            ExprKind::Call(name, arguments) => {
                write!(f, "{name}(")?;
                for (place, argument) in arguments.iter().enumerate() {
                    f.write_str(if place == 0 { "" } else { ", " })?;
                    argument.write(f, 0)?;
                }
                f.write_str(")")?;
            }
        }
        if strength < least { f.write_str(")") } else { Ok(()) }
    }
}

/// Decimal digits where a float is exact, a fraction otherwise.
fn number_text(value: &BigRational) -> String {
    let short = to_f64(value);
    let text = format!("{short}");
    if decimal(&text).as_ref() == Some(value) { text } else { value.to_string() }
}

/// Exact value of `12`, `12.5`, `1.5e-3`; `None` for other text and for exponents beyond 400.
pub(crate) fn decimal(text: &str) -> Option<BigRational> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let places = i32::try_from(fraction.len()).ok()?;
    let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
    let scale = exponent.checked_sub(places)?;
    if digits.is_zero() {
        return Some(BigRational::zero());
    }
    // 400 digits hold every float.
    if scale.unsigned_abs() > 400 {
        return None;
    }
    let power = BigRational::from(BigInt::from(10).pow(scale.unsigned_abs()));
    let power = if scale < 0 { BigRational::one() / power } else { power };
    Some(BigRational::from(digits) * power)
}
