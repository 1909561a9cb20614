//! [`Formula`]: its parts, its size, its value.

use num_rational::BigRational;

use crate::model::to_f64;
use crate::symbolic::Surd;

/// An expression as people write it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Formula {
    /// An exact number.
    Number(Surd),
    /// A quantity by its name: `x`, `B`, `gauge`, `alpha`.
    Name(String),
    /// A root of unknown quantities by its name: `r`.
    Root(String),
    /// `-a`
    Neg(Box<Formula>),
    /// `a + b - c`: the difference is a `Neg` among the terms.
    Sum(Vec<Formula>),
    /// `a b c`
    Product(Vec<Formula>),
    /// `a / b`
    Quotient(Box<Formula>, Box<Formula>),
    /// `a^n`
    Power(Box<Formula>, u32),
    /// `sin`, `cos`, `sqrt`, `atan2`, `asin`, `acos` of its arguments.
    Call(String, Vec<Formula>),
    /// A fixed angle.
    Degrees(BigRational),
}

impl Formula {
    /// A whole number.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Self::Number(Surd::from(value))
    }

    /// A quantity by its name.
    #[must_use]
    pub fn name(name: impl Into<String>) -> Self {
        Self::Name(name.into())
    }

    /// A function of one argument or more.
    #[must_use]
    pub fn call(function: &str, arguments: impl IntoIterator<Item = Self>) -> Self {
        Self::Call(function.into(), arguments.into_iter().collect())
    }

    /// `-self`, without a second minus.
    #[must_use]
    pub fn negated(self) -> Self {
        match self {
            Self::Neg(inner) => *inner,
            Self::Number(number) => Self::Number(-&number),
            other => Self::Neg(Box::new(other)),
        }
    }

    /// Float value, names taken from `of`; angles in radians. `None` where a name is unknown.
    pub fn value(&self, of: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        let all = |parts: &[Self]| parts.iter().map(|part| part.value(of)).collect::<Option<Vec<f64>>>();
        Some(match self {
            Self::Number(number) => number.to_f64(),
            Self::Name(name) | Self::Root(name) => of(name)?,
            Self::Neg(inner) => -inner.value(of)?,
            Self::Sum(terms) => all(terms)?.iter().sum(),
            Self::Product(factors) => all(factors)?.iter().product(),
            Self::Quotient(above, below) => above.value(of)? / below.value(of)?,
            Self::Power(base, power) => base.value(of)?.powi((*power).cast_signed()),
            Self::Degrees(degrees) => to_f64(degrees).to_radians(),
            Self::Call(function, arguments) => match (function.as_str(), &all(arguments)?[..]) {
                ("sin", [a]) => a.sin(),
                ("cos", [a]) => a.cos(),
                ("sqrt", [a]) => a.sqrt(),
                ("asin", [a]) => a.asin(),
                ("acos", [a]) => a.acos(),
                ("atan2", [a, b]) => a.atan2(*b),
                _ => return None,
            },
        })
    }

    /// Number of names, numbers and angles in it: a measure of its length.
    #[must_use]
    pub fn size(&self) -> usize {
        match self {
            Self::Number(_) | Self::Name(_) | Self::Root(_) | Self::Degrees(_) => 1,
            Self::Neg(inner) | Self::Power(inner, _) => inner.size(),
            Self::Sum(parts) | Self::Product(parts) => parts.iter().map(Self::size).sum(),
            Self::Quotient(above, below) => above.size() + below.size(),
            Self::Call(_, arguments) => arguments.iter().map(Self::size).sum(),
        }
    }

    /// True if another formula is a part of it.
    pub(crate) fn mentions(&self, part: &Self) -> bool {
        let any = |parts: &[Self]| parts.iter().any(|inner| inner.mentions(part));
        self == part
            || match self {
                Self::Number(_) | Self::Name(_) | Self::Root(_) | Self::Degrees(_) => false,
                Self::Neg(inner) | Self::Power(inner, _) => inner.mentions(part),
                Self::Sum(parts) | Self::Product(parts) | Self::Call(_, parts) => any(parts),
                Self::Quotient(above, below) => above.mentions(part) || below.mentions(part),
            }
    }

    /// This formula with `value` in place of `part`.
    pub(crate) fn with(self, part: &Self, value: &Self) -> Self {
        if self == *part {
            return value.clone();
        }
        let one = |inner: Box<Self>| Box::new(inner.with(part, value));
        let all = |parts: Vec<Self>| parts.into_iter().map(|inner| inner.with(part, value)).collect();
        match self {
            plain @ (Self::Number(_) | Self::Name(_) | Self::Root(_) | Self::Degrees(_)) => plain,
            Self::Neg(inner) => Self::Neg(one(inner)),
            Self::Power(base, power) => Self::Power(one(base), power),
            Self::Sum(parts) => Self::Sum(all(parts)),
            Self::Product(parts) => Self::Product(all(parts)),
            Self::Call(function, parts) => Self::Call(function, all(parts)),
            Self::Quotient(above, below) => Self::Quotient(one(above), one(below)),
        }
    }
}
