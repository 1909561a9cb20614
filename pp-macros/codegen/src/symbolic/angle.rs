//! Sine and cosine of angles that are known or made of known ones.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::poly::Poly;
use super::ring::Ring;
use super::surd::exact_sin_cos;

/// Sine and cosine of a fixed angle: exact for multiples of 15°, else constants with a float value.
///
/// Rule `quarter-turn`: angles that differ by multiples of 90°, or add up to one, share their constants, so
/// `sin 123° = cos 33°` is exact.
pub fn sin_cos_of_degrees(degrees: &BigRational, ring: &mut Ring) -> (Poly, Poly) {
    if let Some((sine, cosine)) = exact_sin_cos(degrees) {
        return (Poly::from(sine), Poly::from(cosine));
    }
    let whole = |value: i64| BigRational::from(BigInt::from(value));
    let quarters = (degrees / whole(90)).floor();
    let rest = degrees - &quarters * whole(90);
    let complement = rest > whole(45);
    let base = if complement { whole(90) - rest } else { rest };
    let (mut sine, mut cosine) = {
        let (sine, cosine) = ring.fixed_sin_cos(&base);
        (Poly::from(sine), Poly::from(cosine))
    };
    if complement {
        std::mem::swap(&mut sine, &mut cosine);
    }
    let quarter = quarters.to_integer().mod_floor(&BigInt::from(4));
    for _ in 0..quarter.to_u8().unwrap_or_default() {
        (sine, cosine) = (cosine, -&sine);
    }
    (sine, cosine)
}

/// Rule `angle-sum`: sine and cosine of `a + b`, from the pairs (sine, cosine) of `a` and `b`.
#[must_use]
pub fn angle_sum(a: &(Poly, Poly), b: &(Poly, Poly), ring: &Ring) -> (Poly, Poly) {
    let sine = &ring.mul(&a.0, &b.1) + &ring.mul(&a.1, &b.0);
    let cosine = &ring.mul(&a.1, &b.1) - &ring.mul(&a.0, &b.0);
    (sine, cosine)
}
