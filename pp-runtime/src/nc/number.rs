//! Numbers in words: whole units of the last decimal, written without trailing zeros, without an exponent, and never as
//! `-0`. [`Numerals`] adds the requirements of a control: a point in every number, a sign before every number.

use crate::kinematics::math::rounded;

/// Largest number of whole units of a word: all integers up to here are exact in an `f64`.
const LARGEST: f64 = 9_007_199_254_740_992.0;

/// Smallest value that [`Decimal::significant`] writes: 18 decimals for six digits.
const SMALLEST_SIGNIFICANT: f64 = 1e-12;

/// A number that no word can hold: not finite, or beyond 2^53 units of its last decimal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Overflow;

/// `units` of the last of `decimals` decimals: `Decimal { units: 1250, decimals: 3 }` is 1.25.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Decimal {
    /// Whole units of the last decimal.
    pub units: i64,
    /// Decimals, at most 18.
    pub decimals: u32,
}

/// Number format of the axis and feed words of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Numerals {
    /// Whole numbers end with a point; without it the control would read least increments.
    pub point: bool,
    /// Zero and positive numbers begin with a plus.
    pub plus: bool,
}

/// A power of ten; exact up to 10^22.
#[must_use]
fn power_of_ten(exponent: u32) -> f64 {
    const EXACT: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22,
    ];
    EXACT[exponent.min(22) as usize]
}

/// The nearest whole number of units, halves away from zero; `per_unit` is the number of units in 1.
///
/// # Errors
/// [`Overflow`] for a value that is not finite or too large.
#[inline]
pub fn whole_units(value: f64, per_unit: f64) -> Result<i64, Overflow> {
    let units = value * per_unit;
    // A NaN fails the comparison, too.
    if units.abs() <= LARGEST { Ok(rounded(units)) } else { Err(Overflow) }
}

impl Decimal {
    /// `value` rounded to a fixed number of decimals.
    ///
    /// # Errors
    /// [`Overflow`] for a value that is not finite or too large.
    pub fn fixed(value: f64, decimals: u32) -> Result<Self, Overflow> {
        Ok(Self { units: whole_units(value, power_of_ten(decimals))?, decimals })
    }

    /// A value above zero rounded to `digits` significant digits; below 1e-12 it is zero.
    ///
    /// # Errors
    /// [`Overflow`] for a value that is negative, not finite or too large.
    #[inline(always)]
    pub fn significant(value: f64, digits: u32) -> Result<Self, Overflow> {
        if !(0.0..=LARGEST).contains(&value) {
            return Err(Overflow);
        }
        if value < SMALLEST_SIGNIFICANT {
            return Ok(Self::default());
        }
        let digits = digits.clamp(1, 6);
        let (lower, upper) = (power_of_ten(digits - 1), power_of_ten(digits));
        // Digits are counted from the first one that is not zero. A number with more digits before the point has no
        // decimals.
        let (mut decimals, mut scaled) = (0, value);
        // Rounded, it is below `lower`.
        while scaled < lower - 0.5 {
            decimals += 1;
            scaled = value * power_of_ten(decimals);
        }
        let units = rounded(scaled);
        let is_long = units as f64 >= upper;
        Ok(Self { units: if is_long { Self::without_last_digits(value, units, upper) } else { units }, decimals })
    }

    /// A whole number in which digits before the point are rounded to zero, so that those before them are below `upper`; `units`:
    /// all digits.
    #[cold]
    fn without_last_digits(value: f64, units: i64, upper: f64) -> i64 {
        let mut left_out = 0;
        while units as f64 / power_of_ten(left_out) >= upper {
            left_out += 1;
        }
        rounded(value / power_of_ten(left_out)) * power_of_ten(left_out) as i64
    }

    /// Value of the number.
    #[must_use]
    pub fn value(self) -> f64 {
        self.units as f64 / power_of_ten(self.decimals)
    }
}

/// Number of letters of a word for which there is room before its number.
pub(super) const LETTERS: usize = 8;

/// Room for letters, a number of at most a sign, 19 digits and a point, a blank, and what is written after them.
pub(super) const WORD_ROOM: usize = 64;

/// Form of the numbers of a word: their decimals, what a control requires, and what follows from both.
#[derive(Debug, Clone, Copy)]
pub(super) struct NumberForm {
    pub(super) decimals: u32,
    numerals: Numerals,
    /// Millionths in a unit of the last decimal.
    millionths: u64,
    /// Fewest units that need more than six digits before the point; 0 for more than six decimals.
    many: u64,
}

impl NumberForm {
    #[inline(always)]
    pub(super) fn new(decimals: u32, numerals: Numerals) -> Self {
        const POWERS: [u64; 7] = [1, 10, 100, 1000, 10_000, 100_000, MILLION];
        let (millionths, many) = match POWERS.get(decimals as usize) {
            Some(per_one) => (POWERS[6 - decimals as usize], MILLION * per_one),
            None => (0, 0),
        };
        Self { decimals, numerals, millionths, many }
    }
}

const MILLION: u64 = 1_000_000;

/// Puts whole units of the last decimal at `start`, at most [`LETTERS`], and a blank after them; returns the index after the
/// blank.
#[inline(always)]
pub(super) fn put_number(room: &mut [u8; WORD_ROOM], start: usize, units: i64, form: &NumberForm) -> usize {
    let negative = units < 0;
    // A plus or, two codes after it, a minus.
    room[start] = b'+' + 2 * u8::from(negative);
    let start = start + usize::from(negative || form.numerals.plus);
    let units = units.unsigned_abs();
    let end = if units < form.many {
        put_short(room, start, units * form.millionths, form.numerals.point)
    } else {
        put_long(room, start, units, form.decimals, form.numerals.point)
    };
    room[end % WORD_ROOM] = b' ';
    end + 1
}

/// Of each number below 1000 how many digits are left without the zeros at the end, in the lowest byte, and its three digits as
/// text, the first one next.
const THREE_DIGITS: [u32; 1000] = {
    let mut table = [0; 1000];
    let mut number = 0;
    while number < 1000 {
        let count = 3 - (number % 10 == 0) as u8 - (number % 100 == 0) as u8 - (number == 0) as u8;
        table[number] = u32::from_le_bytes([count, digit(number / 100), digit(number / 10), digit(number)]);
        number += 1;
    }
    table
};

/// Of each number below 1000 its digits as text without the zeros before them, the first one in the lowest byte, and how many
/// they are, in the highest.
const FIRST_DIGITS: [u32; 1000] = {
    let mut table = [0; 1000];
    let mut number = 0;
    while number < 1000 {
        let (hundreds, tens, ones) = (digit(number / 100), digit(number / 10), digit(number));
        table[number] = u32::from_le_bytes(match number {
            0..10 => [ones, 0, 0, 1],
            10..100 => [tens, ones, 0, 2],
            _ => [hundreds, tens, ones, 3],
        });
        number += 1;
    }
    table
};

const fn digit(number: usize) -> u8 {
    b'0' + (number % 10) as u8
}

/// Puts a number of less than 10^12 millionths at `start`, three digits at once.
#[inline(always)]
fn put_short(room: &mut [u8; WORD_ROOM], start: usize, millionths: u64, point: bool) -> usize {
    let (whole, fraction) = ((millionths / MILLION) as u32, (millionths % MILLION) as u32);
    let count = if whole < 1000 { put_first_digits(room, start, whole) } else { put_long_whole(room, start, whole) };
    let at = (start + count) % 32;
    let [first, last] = [fraction / 1000 % 1000, fraction % 1000].map(|three| THREE_DIGITS[three as usize]);
    let text = u64::from(b'.') | u64::from(first & !0xff) | u64::from(last & !0xff) << 24;
    room[at..at + 8].copy_from_slice(&text.to_le_bytes());
    let [first, last] = [first, last].map(|digits| (digits & 0xff) as usize);
    let written = if last > 0 { 3 + last } else { first };
    at + written + usize::from(written > 0 || point)
}

/// Puts the digits of a number below 1000 at `start`; returns how many.
#[inline(always)]
fn put_first_digits(room: &mut [u8; WORD_ROOM], start: usize, number: u32) -> usize {
    let digits = FIRST_DIGITS[number as usize % 1000];
    room[start..start + 4].copy_from_slice(&digits.to_le_bytes());
    (digits >> 24) as usize
}

/// Puts a whole number of four to six digits at `start`; returns how many.
#[inline]
fn put_long_whole(room: &mut [u8; WORD_ROOM], start: usize, whole: u32) -> usize {
    let count = put_first_digits(room, start, whole / 1000);
    let (at, last) = ((start + count) % 32, THREE_DIGITS[whole as usize % 1000] >> 8);
    room[at..at + 4].copy_from_slice(&last.to_le_bytes());
    count + 3
}

/// Puts any number at `start`.
#[cold]
fn put_long(room: &mut [u8; WORD_ROOM], start: usize, units: u64, decimals: u32, point: bool) -> usize {
    let per_one = 10_u64.pow(decimals);
    let (mut whole, mut fraction) = (units / per_one, units % per_one);
    let decimals = decimals as usize;
    let at = start + whole.checked_ilog10().unwrap_or(0) as usize + 1;
    let mut digits = |from: usize, to: usize, number: &mut u64| {
        for byte in room[from..to].iter_mut().rev() {
            *byte = b'0' + (*number % 10) as u8;
            *number /= 10;
        }
    };
    digits(start, at, &mut whole);
    digits(at + 1, at + 1 + decimals, &mut fraction);
    room[at] = b'.';
    let zeros = room[at + 1..at + 1 + decimals].iter().rev().take_while(|byte| **byte == b'0').count();
    match decimals - zeros {
        0 => at + usize::from(point),
        written => at + 1 + written,
    }
}

/// Writes a number in the number format of a control.
pub fn write_number(out: &mut Vec<u8>, number: Decimal, numerals: Numerals) {
    let mut room = [0; WORD_ROOM];
    let end = put_number(&mut room, 0, number.units, &NumberForm::new(number.decimals, numerals));
    out.extend_from_slice(&room[..end - 1]);
}

/// Writes a number: no zeros after the last digit, no point without decimals, no `-0`.
pub fn write_decimal(out: &mut Vec<u8>, number: Decimal) {
    write_number(out, number, Numerals::default());
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn text(number: Decimal) -> String {
        let mut out = Vec::new();
        write_decimal(&mut out, number);
        String::from_utf8(out).expect("digits are ASCII")
    }

    fn fixed(value: f64, decimals: u32) -> String {
        text(Decimal::fixed(value, decimals).expect("fits"))
    }

    #[test]
    fn zeros_at_the_end_are_left_out_and_those_before_the_point_stay() {
        assert_eq!(fixed(100.0, 3), "100");
        assert_eq!(fixed(0.5, 3), "0.5");
        assert_eq!(fixed(-0.050, 3), "-0.05");
        assert_eq!(fixed(12.3456, 3), "12.346");
        assert_eq!(fixed(5000.4, 0), "5000");
    }

    #[test]
    fn a_negative_number_that_rounds_to_zero_has_no_sign() {
        assert_eq!(fixed(-0.0, 3), "0");
        assert_eq!(fixed(-0.000_49, 3), "0");
        assert_eq!(fixed(-0.000_51, 3), "-0.001");
    }

    #[test]
    fn a_control_that_needs_a_point_or_a_sign_gets_it_in_every_number() {
        let written = |units, point, plus| {
            let mut out = Vec::new();
            write_number(&mut out, Decimal { units, decimals: 3 }, Numerals { point, plus });
            String::from_utf8(out).expect("ASCII")
        };
        assert_eq!([10_000, -10_000, 0, 500].map(|units| written(units, true, false)), ["10.", "-10.", "0.", "0.5"]);
        assert_eq!([10_500, -10_500, 0].map(|units| written(units, false, true)), ["+10.5", "-10.5", "+0"]);
    }

    #[test]
    fn numbers_that_no_word_can_hold_are_refused() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, 9.1e12] {
            assert_eq!(Decimal::fixed(value, 3), Err(Overflow), "{value}");
        }
        assert_eq!(fixed(9.0e12, 3), "9000000000000");
        assert_eq!(Decimal::significant(-1.0, 6), Err(Overflow));
        assert_eq!(Decimal::significant(f64::NAN, 6), Err(Overflow));
    }

    #[test]
    fn inverse_time_has_six_digits_wherever_the_point_is() {
        let six = |value| text(Decimal::significant(value, 6).expect("fits"));
        assert_eq!(six(1.0 / 3.0), "0.333333");
        assert_eq!(six(1234.56789), "1234.57");
        assert_eq!(six(0.000_012_345_678), "0.0000123457");
        assert_eq!(six(999_999.6), "1000000");
        assert_eq!(six(0.999_999_6), "1");
        assert_eq!(six(12_345_678.0), "12345700");
        assert_eq!(six(60.0), "60");
        assert_eq!(six(1e-13), "0");
    }

    proptest! {
        #[test]
        fn written_units_read_back_as_the_same_decimal(
            units in prop_oneof![
                -2000_i64..2000,
                -10_000_000_i64..10_000_000,
                -2_000_000_000_000_i64..2_000_000_000_000,
                -LARGEST as i64..=LARGEST as i64,
            ],
            zeros in 0_u32..4,
            decimals in 0_u32..=9,
        ) {
            let units = if units.abs() < 1 << 40 { units * 10_i64.pow(zeros) } else { units };
            let written = text(Decimal { units, decimals });
            // Exact decimal arithmetic on the text itself.
            let (whole, fraction) = written.split_once('.').unwrap_or((&written, ""));
            prop_assert!(!written.ends_with('.') && written != "-0");
            prop_assert!(fraction.is_empty() || !fraction.ends_with('0'));
            prop_assert!(fraction.len() <= decimals as usize);
            let digits = format!("{whole}{fraction}{}", "0".repeat(decimals as usize - fraction.len()));
            prop_assert_eq!(digits.parse::<i64>().expect("a whole number"), units);
        }

        #[test]
        fn a_rounded_value_is_within_half_a_unit(value in -1.0e6_f64..1.0e6, decimals in 0_u32..=6) {
            let rounded = Decimal::fixed(value, decimals).expect("fits").value();
            prop_assert!((rounded - value).abs() <= 0.5 / power_of_ten(decimals) * (1.0 + 1e-9) + 1e-9 * f64::EPSILON);
        }

        #[test]
        fn six_digits_are_within_half_of_the_sixth(exponent in -11_i32..12, mantissa in 1.0_f64..10.0) {
            let value = mantissa * 10_f64.powi(exponent);
            let rounded = Decimal::significant(value, 6).expect("fits").value();
            prop_assert!((rounded - value).abs() <= value * 5.000_001e-6, "{} {}", value, rounded);
        }
    }
}
