//! Sine and cosine of two angles at once.
//!
//! `x = k π/2 + y` with a whole `k` and `|y| <= π/4`, `y` with a tail of its own. Sine and cosine of `y` are
//! polynomials with the smallest largest error (Remez), and `k` decides which of them is which, and their signs. Sums
//! and products are those of IEEE 754 without fused operations, so that every processor gives the same bits; the error
//! is below 0.8 units of the last place. Where `x` is so near to a multiple of `π/2` that more of its digits are
//! needed, or far from zero, or not finite, the functions of libm are used.

use wide::f64x2;

use super::{polynomial, splat};

/// `sin y = y - y³ p(y²)`.
pub(crate) const SINE: [f64; 6] = [
    0.166_666_666_666_666_32,
    -0.008_333_333_333_322_418,
    0.000_198_412_698_298_124_07,
    -2.755_731_369_358_042e-6,
    2.505_075_838_536_460_4e-8,
    -1.589_681_184_555_936_7e-10,
];

/// `cos y = 1 - y²/2 + y⁴ p(y²)`.
pub(crate) const COSINE: [f64; 6] = [
    0.041_666_666_666_666_6,
    -0.001_388_888_888_887_413_1,
    2.480_158_728_948_701_2e-5,
    -2.755_731_435_378_955_6e-7,
    2.087_572_347_915_438_7e-9,
    -1.135_965_885_290_197_1e-11,
];

/// Added to a number below 2^51 and subtracted from it, it leaves the nearest whole number, which is in the last bits
/// of the sum.
pub(crate) const WHOLE: f64 = 6_755_399_441_055_744.0;

/// The first 33 bits of `π/2`: its multiples up to [`MOST_QUARTERS`] are exact. And the rest, to 86 bits in all.
pub(crate) const QUARTER_TURN: f64 = f64::from_bits(0x3FF9_21FB_5440_0000);
pub(crate) const QUARTER_TURN_REST: f64 = f64::from_bits(0x3DD0_B461_1A62_6331);

/// Largest number of quarter turns that are subtracted.
pub(crate) const MOST_QUARTERS: f64 = 1e6;

/// Distance from a multiple of `π/2`, for each quarter turn, from which on 86 bits of `π/2` suffice.
pub(crate) const FAR_ENOUGH: f64 = 1.0 / 134_217_728.0;

/// Sines and cosines.
#[inline]
pub(super) fn sin_cos(x: f64x2) -> (f64x2, f64x2) {
    let shifted = x * splat(core::f64::consts::FRAC_2_PI) + splat(WHOLE);
    let k = shifted - splat(WHOLE);
    let coarse = x - k * splat(QUARTER_TURN);
    let rest = k * splat(QUARTER_TURN_REST);
    let y = coarse - rest;
    // What `y` exceeds the difference by.
    let excess = rest - (coarse - y);

    let square = y * y;
    let half = splat(0.5) * square;
    let near_one = splat(1.0) - half;
    // Zero keeps its sign.
    let sine = y - (excess * near_one + (y * square) * polynomial(square, &SINE));
    let lost = (splat(1.0) - near_one) - half;
    let cosine = near_one + (lost + ((square * square) * polynomial(square, &COSINE) + y * excess));

    let half_turns = k * splat(0.5);
    let odd = ((half_turns + splat(WHOLE)) - splat(WHOLE)).simd_ne(half_turns);
    // The second bit of `k` and of `k + 1`, as the sign of a number.
    let negated = |turns: f64x2, by: u64| {
        let sign = |bits: f64| f64::from_bits((bits.to_bits().wrapping_add(by) & 2) << 62);
        f64x2::from(turns.to_array().map(sign))
    };
    let sines = odd.bitselect(cosine, sine) ^ negated(shifted, 0);
    let cosines = odd.bitselect(sine, cosine) ^ negated(shifted, 1);

    let exact = y.abs().simd_ge(k.abs() * splat(FAR_ENOUGH)) & k.abs().simd_le(splat(MOST_QUARTERS));
    if exact.all() { (sines, cosines) } else { by_library(x, exact, sines, cosines) }
}

/// Replaces what is not exact.
#[cold]
#[inline(never)]
fn by_library(x: f64x2, exact: f64x2, sines: f64x2, cosines: f64x2) -> (f64x2, f64x2) {
    let library = x.to_array().map(libm::sincos);
    let [sine, cosine] = [library.map(|(sine, _)| sine), library.map(|(_, cosine)| cosine)].map(f64x2::from);
    (exact.bitselect(sines, sine), exact.bitselect(cosines, cosine))
}
