//! Rounding to whole numbers.

use wide::f64x2;

/// 2^52 + 2^51: the sum with a smaller number than 2^51 has no bits after the point, and its lowest bits are those of
/// the nearest whole number.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// 2^51.
pub(crate) const LARGEST_SHIFTED: f64 = 2_251_799_813_685_248.0;

/// The nearest whole number, halves away from zero; the nearest `i64` to a value beyond them, and 0 for NaN.
///
/// Where the processor has no instruction for it, `f64::round` is a call.
#[inline]
#[must_use]
pub(crate) fn rounded(value: f64) -> i64 {
    // One test for both, unlike `rounded_below`: it spares an instruction or two for each number of a program.
    let shifted = value + SHIFT;
    let rest = value - (shifted - SHIFT);
    if value.abs() < LARGEST_SHIFTED && rest.abs() < 0.5 { integer(shifted) } else { rounded_in_steps(value) }
}

/// The nearest whole number to each of two; `None` if one of them is a half or [`LARGEST_SHIFTED`] at least.
#[inline(always)]
pub(crate) fn rounded_both(values: f64x2) -> Option<f64x2> {
    let whole = (values + f64x2::splat(SHIFT)) - f64x2::splat(SHIFT);
    let is_near = (values - whole).abs().simd_lt(f64x2::splat(0.5));
    let is_small = values.abs().simd_lt(f64x2::splat(LARGEST_SHIFTED));
    (is_near & is_small).all().then_some(whole)
}

/// The integer whose sum with [`SHIFT`] this is.
#[inline(always)]
fn integer(shifted: f64) -> i64 {
    shifted.to_bits().wrapping_sub(SHIFT.to_bits()).cast_signed()
}

/// [`rounded`] of a value below `most`, which is [`LARGEST_SHIFTED`] at most; `None` for any other, and for NaN.
#[inline(always)]
pub(crate) fn rounded_below(value: f64, most: f64) -> Option<i64> {
    let shifted = value + SHIFT;
    let rest = value - (shifted - SHIFT);
    if value.abs() < most {
        return Some(if rest.abs() < 0.5 { integer(shifted) } else { rounded_in_steps(value) });
    }
    None
}

/// [`rounded`] of any number, also of a half or a large one.
#[cold]
fn rounded_in_steps(value: f64) -> i64 {
    let whole = value as i64;
    // Exact: both have the same sign and magnitude.
    let rest = value - whole as f64;
    whole.saturating_add(i64::from(rest >= 0.5)).saturating_sub(i64::from(rest <= -0.5))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn whole_numbers_are_the_nearest(value in prop_oneof![-1e19..1e19_f64, -1e6..1e6_f64, -3.0..3.0_f64]) {
            prop_assert_eq!(rounded(value), value.round() as i64);
        }

        #[test]
        fn halves_and_their_neighbours_are_rounded_away_from_zero(whole in -(1_i64 << 52)..1 << 52) {
            let half = whole as f64 + 0.5;
            for value in [half, half.next_up(), half.next_down(), -half] {
                prop_assert_eq!(rounded(value), value.round() as i64, "{}", value);
                let below = rounded_below(value, LARGEST_SHIFTED);
                prop_assert_eq!(below, (value.abs() < LARGEST_SHIFTED).then(|| rounded(value)), "{}", value);
            }
        }
    }
}
