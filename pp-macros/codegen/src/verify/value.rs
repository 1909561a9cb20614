//! Values of expressions: numbers, and angles as directions.

use crate::symbolic::Poly;

/// The value of an expression.
#[derive(Debug, Clone)]
pub(crate) enum Value {
    /// A number or a length.
    Number(Poly),
    /// An angle, as the direction (cosine, sine) times a positive factor.
    Angle(Angle),
}

/// A direction in the plane.
#[derive(Debug, Clone)]
pub(crate) struct Angle {
    pub(crate) cosine: Poly,
    pub(crate) sine: Poly,
    /// Set for `asin` and `acos`, whose other part is a root.
    pub(crate) inverse: Option<Inverse>,
}

/// An angle known by one part; the other has a known sign.
#[derive(Debug, Clone)]
pub(crate) enum Inverse {
    /// `asin(p)`: the cosine is not negative.
    Sine(Poly),
    /// `acos(p)`, and with true its negative: the sine is not negative, or not positive.
    Cosine(Poly, bool),
}

impl Angle {
    /// The angle 0.
    pub(crate) fn zero() -> Self {
        Self { cosine: Poly::one(), sine: Poly::zero(), inverse: None }
    }

    /// The opposite angle.
    pub(crate) fn negated(self) -> Self {
        let inverse = self.inverse.map(|inverse| match inverse {
            Inverse::Sine(part) => Inverse::Sine(-&part),
            Inverse::Cosine(part, negative) => Inverse::Cosine(part, !negative),
        });
        Self { sine: -&self.sine, inverse, ..self }
    }
}

/// The value as an angle: a number must be zero to be one.
pub(crate) fn zero_as_angle(value: &Value) -> Option<Angle> {
    match value {
        Value::Angle(angle) => Some(angle.clone()),
        Value::Number(number) if number.is_zero() => Some(Angle::zero()),
        Value::Number(_) => None,
    }
}
