//! Arc tangents of two quotients at once.
//!
//! The smaller of `|x|` and `|y|` is divided by the larger; a quotient above `tan π/8` by
//! `atan q = π/4 + atan (q - 1)/(q + 1)`, so that `|t| <= tan π/8` remains, whose arc tangent is a polynomial with the
//! smallest largest error (Remez). What sums and quotient have lost is added to it. Sums and products are those of IEEE
//! 754 without fused operations, so that every processor gives the same bits; the error is below 0.9 units of the last
//! place, and signs are those of IEEE 754.

use wide::f64x2;

use super::{long_polynomial, splat};

/// `atan t = t + t³ p(t²)`.
pub(crate) const ARC_TANGENT: [f64; 11] = [
    -0.333_333_333_333_332_1,
    0.199_999_999_999_558_03,
    -0.142_857_142_803_843_65,
    0.111_111_107_917_573_16,
    -0.090_908_979_747_682_76,
    0.076_920_637_931_704_76,
    -0.066_631_422_300_534_79,
    0.058_481_524_591_260_846,
    -0.050_404_355_362_543_75,
    0.038_092_108_415_942_82,
    -0.017_936_259_410_284_712,
];

pub(crate) const TAN_PI_8: f64 = 0.414_213_562_373_095;

/// `π` less the nearest `f64`.
pub(crate) const PI_REST: f64 = 1.224_646_799_147_353_2e-16;

/// A larger number may overflow in a sum.
pub(crate) const LARGEST: f64 = 1e300;

/// The first 26 bits of a number.
pub(crate) const UPPER_BITS: f64 = f64::from_bits(0xFFFF_FFFF_F800_0000);

/// Angles of the points `(x, y)`, in \\[-π, π\\].
#[inline]
pub(super) fn atan2(y: f64x2, x: f64x2) -> f64x2 {
    let sign = splat(-0.0);
    let (across, up) = (x.abs(), y.abs());
    let (small, large) = (across.fast_min(up), across.fast_max(up));
    let (steep, behind) = (up.simd_gt(across), x.simd_lt(splat(0.0)));
    let wide = small.simd_gt(splat(TAN_PI_8) * large);

    let (minus, plus) = (wide & large, wide & small);
    let (above, below) = (small - minus, large + plus);
    let t = above / below;
    let (upper_t, upper_below) = (t & splat(UPPER_BITS), below & splat(UPPER_BITS));
    let remainder = (above - upper_t * upper_below) - (upper_t * (below - upper_below) + (t - upper_t) * below);
    let lost_by_sums = (small - (above + minus)) - t * (plus - (below - large));
    let square = t * t;
    let curved = t * (square * long_polynomial(square, &ARC_TANGENT)) + (remainder + lost_by_sums) / below;

    // 0 or π/4; where it is steep, that is subtracted from π/2; where it is behind, from π.
    let (down, back) = (steep & sign, behind & sign);
    let in_octant = |quarter: f64, half: f64| ((steep & splat(half)) + ((wide & splat(quarter)) ^ down)) ^ back;
    let (octant, octant_rest) = (
        in_octant(core::f64::consts::FRAC_PI_4, core::f64::consts::FRAC_PI_2),
        in_octant(0.25 * PI_REST, 0.5 * PI_REST),
    );
    let half_turn = behind & splat(core::f64::consts::PI);
    let base = half_turn + octant;
    let base_rest = octant_rest + (behind & splat(PI_REST)) + (octant - (base - half_turn));
    let turned = down ^ back;
    let angles = (base + ((t ^ turned) + (base_rest + (curved ^ turned)))) ^ (y & sign);

    let size = across + up;
    let exact = size.simd_le(splat(LARGEST)) & size.simd_gt(splat(0.0));
    if exact.all() { angles } else { by_library(y, x, exact, angles) }
}

/// Replaces what is not exact: of the origin, infinities, and what is not a number.
#[cold]
#[inline(never)]
fn by_library(y: f64x2, x: f64x2, exact: f64x2, angles: f64x2) -> f64x2 {
    let ([y1, y2], [x1, x2]) = (y.to_array(), x.to_array());
    exact.bitselect(angles, f64x2::from([libm::atan2(y1, x1), libm::atan2(y2, x2)]))
}
