//! Mathematical functions that `core` does not have.
//!
//! They give the same bits on every system: a program does not depend on the library of the system on which it was
//! posted.
//!
//! ```
//! use pp_runtime::kinematics::math;
//!
//! let (sine, cosine) = math::sin_cos(math::atan2(3.0, 4.0));
//! assert!((sine - 0.6).abs() < 1e-15 && (cosine - 0.8).abs() < 1e-15);
//! ```

pub(crate) mod arc_tangent;
pub(crate) mod sin_cos;
#[cfg(test)]
mod tests;
#[cfg(feature = "std")]
mod whole;

use wide::f64x2;

#[cfg(feature = "std")]
pub(crate) use whole::rounded;
#[cfg(feature = "std")]
pub(crate) use whole::{LARGEST_SHIFTED, rounded_below, rounded_both};

/// Square root.
#[must_use]
#[inline]
pub fn sqrt(x: f64) -> f64 {
    // Both are exact but for the last rounding.
    #[cfg(feature = "std")]
    return x.sqrt();
    #[cfg(not(feature = "std"))]
    return libm::sqrt(x);
}

/// Four-quadrant arc tangent of `y / x`, in \[-π, π\].
#[must_use]
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    arc_tangent::atan2(splat(y), splat(x)).to_array()[0]
}

/// Arc sine, in \[-π/2, π/2\]; NaN outside \[-1, 1\].
#[must_use]
#[cfg(feature = "std")]
pub(crate) fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// Logarithm to base 10.
#[must_use]
#[cfg(feature = "std")]
pub(crate) fn log10(x: f64) -> f64 {
    libm::log10(x)
}

/// Sine and cosine.
#[must_use]
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    let [turn] = turns([x]);
    turn
}

/// Sines and cosines of angles.
#[must_use]
#[inline]
pub fn turns<const N: usize>(angles: [f64; N]) -> [(f64, f64); N] {
    let mut turns = [(0.0, 0.0); N];
    // Two at a time; an odd one with itself.
    for (two, angles) in turns.chunks_mut(2).zip(angles.chunks(2)) {
        let pair = f64x2::from([angles[0], angles[angles.len() - 1]]);
        let (sines, cosines) = sin_cos::sin_cos(pair);
        for (turn, found) in two.iter_mut().zip(sines.to_array().into_iter().zip(cosines.to_array())) {
            *turn = found;
        }
    }
    turns
}

/// Angles with the given sines and cosines (any common factor above zero), in (-π, π].
///
/// `atan2` returns -π for a sine of minus zero; here a half turn is always π.
#[must_use]
#[inline]
pub fn angles<const N: usize>(turns: [(f64, f64); N]) -> [f64; N] {
    let mut angles = [0.0; N];
    for (two, turns) in angles.chunks_mut(2).zip(turns.chunks(2)) {
        let [(y1, x1), (y2, x2)] = [turns[0], turns[turns.len() - 1]];
        let found = arc_tangent::atan2(f64x2::from([y1, y2]), f64x2::from([x1, x2])).to_array();
        for (angle, found) in two.iter_mut().zip(found) {
            *angle = named_once(found);
        }
    }
    angles
}

/// An angle in \[-π, π\] as one from 0 to 2π.
#[must_use]
#[inline]
#[cfg(feature = "std")]
pub(crate) fn from_zero(angle: f64) -> f64 {
    if angle < 0.0 { angle + core::f64::consts::TAU } else { angle }
}

/// Magnitude.
#[must_use]
#[inline]
pub fn abs(x: f64) -> f64 {
    x.abs()
}

/// The larger number; `y` if one of them is NaN. One instruction, where `f64::max` has to look for NaN.
#[must_use]
#[inline]
pub(crate) fn larger(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

/// The smaller number; `y` if one of them is NaN.
#[must_use]
#[inline]
pub(crate) fn smaller(x: f64, y: f64) -> f64 {
    if x < y { x } else { y }
}

/// Length of the plane vector `(x, y)`, without protection against overflow.
#[must_use]
#[inline]
pub fn hypot(x: f64, y: f64) -> f64 {
    sqrt(x * x + y * y)
}

/// The angle with the given sine and cosine: see [`angles`].
#[must_use]
#[inline]
pub fn angle(sine: f64, cosine: f64) -> f64 {
    let [angle] = angles([(sine, cosine)]);
    angle
}

/// Replaces -π, and any value that rounds to it, by π.
#[inline]
fn named_once(angle: f64) -> f64 {
    if angle <= -core::f64::consts::PI { core::f64::consts::PI } else { angle }
}

/// The angle half a turn away, in (-π, π].
#[must_use]
#[inline]
pub fn half_turn(angle: f64) -> f64 {
    named_once(if angle > 0.0 { angle - core::f64::consts::PI } else { angle + core::f64::consts::PI })
}

/// The angle with the same sine and the opposite cosine, in (-π, π].
#[must_use]
#[inline]
pub fn mirrored(angle: f64) -> f64 {
    named_once(if angle >= 0.0 { core::f64::consts::PI - angle } else { -core::f64::consts::PI - angle })
}

/// The angle with the same cosine and the opposite sine, in (-π, π].
#[must_use]
#[inline]
pub fn negated(angle: f64) -> f64 {
    if angle >= core::f64::consts::PI { angle } else { -angle }
}

#[inline]
fn splat(value: f64) -> f64x2 {
    f64x2::splat(value)
}

/// Value of a polynomial, lowest power first.
#[inline]
fn polynomial<const N: usize>(x: f64x2, factors: &[f64; N]) -> f64x2 {
    let (lower, highest) = factors.split_at(N - 1);
    lower.iter().rev().fold(splat(highest[0]), |sum, factor| sum * x + splat(*factor))
}

/// Value of a polynomial of many powers, lowest first: even and odd ones are summed by themselves, so that the
/// processor works on both at once.
#[inline]
fn long_polynomial<const N: usize>(x: f64x2, factors: &[f64; N]) -> f64x2 {
    let square = x * x;
    let [even, odd] = [0, 1].map(|first| {
        let mut factors = factors.iter().skip(first).step_by(2).rev().map(|factor| splat(*factor));
        let highest = factors.next().unwrap_or_default();
        factors.fold(highest, |sum, factor| sum * square + factor)
    });
    even + odd * x
}
