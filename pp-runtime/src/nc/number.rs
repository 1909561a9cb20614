//! Numbers in words: whole units of the last decimal, written without trailing zeros, without an exponent, and never as
//! `-0`. [`Numerals`] adds the requirements of a control: a point in every number, a sign before every number.

use crate::kinematics::math::rounded;

/// Largest number of whole units of a word: all integers up to here are exact in an `f64`.
const LARGEST: f64 = 9_007_199_254_740_992.0;

/// Smallest value that [`Decimal::significant`] writes.
const SMALLEST_SIGNIFICANT: f64 = 1e-12;

/// Largest number of its digits: the 19 decimals of the smallest value are a power of ten in 64 bits.
pub(crate) const MOST_SIGNIFICANT: u32 = 8;

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
pub(crate) fn whole_units(value: f64, per_unit: f64) -> Result<i64, Overflow> {
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
        let digits = digits.clamp(1, MOST_SIGNIFICANT);
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

    /// A whole number in which digits before the point are rounded to zero, so that those before them are below
    /// `upper`; `units`: all digits.
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

/// Room for any number and a blank: a sign, 20 digits, and a point.
pub(super) const NUMBER_ROOM: usize = 64;

/// Room for a short word, and what is written after it.
pub(super) const SHORT_ROOM: usize = 32;

/// Largest number of letters of a short word.
const SHORT_LETTERS: usize = 6;

/// Largest number of decimals of a short word.
const SHORT_DECIMALS: usize = 6;

/// Form of words that are written three digits at once: at most six letters, six digits before the point, and six
/// decimals.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShortForm {
    /// Letters and sign before a number, and before a negative one: the first in the lowest byte, their number in the
    /// three highest bits.
    prefixes: [u64; 2],
    /// Fewest units that need more than six digits before the point; 0 if no word is short.
    too_many: u64,
    /// 2^64 - 1 divided by the units in 1, without its rest.
    factor: u64,
    endings: &'static Endings,
}

impl ShortForm {
    pub(super) fn new(letters: &str, decimals: u32, numerals: Numerals) -> Self {
        let scale = SCALES.get(decimals as usize).filter(|_| letters.len() <= SHORT_LETTERS);
        let (too_many, factor) = scale.copied().unwrap_or_default();
        Self {
            prefixes: prefixes(letters, numerals.plus),
            too_many,
            factor,
            endings: &ENDINGS[usize::from(numerals.point)],
        }
    }

    /// Puts a word and a blank into the room; returns their length, or `None` if the word is not short.
    #[inline(always)]
    pub(super) fn put(&self, room: &mut [u8; SHORT_ROOM], units: i64) -> Option<usize> {
        let (mut prefix, mut magnitude) = (self.prefixes[0], units.cast_unsigned());
        // A negative number is a large one without a sign.
        if magnitude >= self.too_many {
            (prefix, magnitude) = (self.prefixes[1], magnitude.wrapping_neg());
            if magnitude >= self.too_many {
                return None;
            }
        }
        room[..8].copy_from_slice(&prefix.to_le_bytes());
        let start = (prefix >> 61) as usize;
        // The whole number, and its fraction in units of 2^-64. The factor is at most 1 too small, so the product lacks
        // at most `magnitude` of them. With `too_many` added it is too large, by at most 10^12 of them: less than a
        // millionth.
        let scaled = u128::from(magnitude) * u128::from(self.factor) + u128::from(self.too_many);
        let (whole, fraction) = ((scaled >> 64) as usize, scaled as u64);
        let at = match FIRST_DIGITS.get(whole) {
            Some(digits) => put_first_digits(room, start, *digits),
            None => put_six_digits(room, start, whole as u32)?,
        };
        let (first, fraction) = next_three_digits(fraction);
        let (last, _) = next_three_digits(fraction);
        let ending = self.endings[first];
        if last == 0 {
            room[at..at + 8].copy_from_slice(&ending.to_le_bytes());
            return Some(at + ending_length(ending));
        }
        room[at..at + 4].copy_from_slice(&all_digits(ending).to_le_bytes());
        let ending = self.endings[last];
        // Without its point.
        room[at + 4..at + 12].copy_from_slice(&(ending >> 8).to_le_bytes());
        Some(at + 3 + ending_length(ending))
    }
}

const MILLION: u64 = 1_000_000;

/// By the decimals of a short word the fewest units that need more than six digits before the point, and 2^64 - 1
/// divided by the units in 1, without its rest.
const SCALES: [(u64, u64); SHORT_DECIMALS + 1] = {
    let mut scales = [(0, 0); SHORT_DECIMALS + 1];
    let mut decimals = 0;
    while decimals <= SHORT_DECIMALS {
        let per_one = 10_u64.pow(decimals as u32);
        scales[decimals] = (MILLION * per_one, u64::MAX / per_one);
        decimals += 1;
    }
    scales
};

/// The letters of a short word with the sign of its numbers, and with that of negative ones.
fn prefixes(letters: &str, plus: bool) -> [u64; 2] {
    let mut bytes = [0; 8];
    let count =
        bytes[..SHORT_LETTERS].iter_mut().zip(letters.bytes()).map(|(byte, letter)| *byte = letter).count() as u64;
    let text = u64::from_le_bytes(bytes);
    let signed = |sign: u8| text | u64::from(sign) << (8 * count) | (count + 1) << 61;
    [if plus { signed(b'+') } else { text | count << 61 }, signed(b'-')]
}

/// Of each number below 1000 its digits as text without the zeros before them, the first one in the lowest byte, and
/// how many they are, in the two highest bits.
const FIRST_DIGITS: [u32; 1000] = {
    let mut table = [0; 1000];
    let mut number = 0;
    while number < 1000 {
        let [hundreds, tens, ones] = three_digits(number);
        table[number] = u32::from_le_bytes(match number {
            0..10 => [ones, 0, 0, 1 << 6],
            10..100 => [tens, ones, 0, 2 << 6],
            _ => [hundreds, tens, ones, 3 << 6],
        });
        number += 1;
    }
    table
};

/// Of each number of thousandths a point, their digits without the zeros at the end, and a blank, the point in the
/// lowest byte; their length in the three highest bits. Without digits a blank alone, or a point and a blank.
type Endings = [u64; 1024];

/// Endings of numbers without and with a point after a whole number. Those after the first 1000 are of no number.
static ENDINGS: [Endings; 2] = [endings(false), endings(true)];

const fn endings(point: bool) -> Endings {
    let mut table = [0; 1024];
    let mut number = 0;
    while number < 1000 {
        let [tenths, hundredths, thousandths] = three_digits(number);
        let (text, length) = match (number, number % 100, number % 10) {
            (0, ..) if point => ([b'.', b' ', b' ', b' '], 2),
            (0, ..) => ([b' '; 4], 1),
            (_, 0, _) => ([b'.', tenths, b' ', b' '], 3),
            (.., 0) => ([b'.', tenths, hundredths, b' '], 4),
            _ => ([b'.', tenths, hundredths, thousandths], 5),
        };
        let [point, tenths, hundredths, thousandths] = text;
        table[number] = u64::from_le_bytes([point, tenths, hundredths, thousandths, b' ', 0, 0, length << 5]);
        number += 1;
    }
    table
}

const fn three_digits(number: usize) -> [u8; 3] {
    [b'0' + (number / 100) as u8, b'0' + (number / 10 % 10) as u8, b'0' + (number % 10) as u8]
}

#[inline(always)]
const fn ending_length(ending: u64) -> usize {
    (ending >> 61) as usize
}

/// Point and three digits of an ending with the zeros that it leaves out: all bits of a blank are in a zero and in a
/// point.
#[inline(always)]
const fn all_digits(ending: u64) -> u32 {
    ending as u32 | u32::from_le_bytes(*b".000")
}

/// The first three digits of a fraction in units of 2^-64, and the fraction after them.
#[inline(always)]
fn next_three_digits(fraction: u64) -> (usize, u64) {
    let product = u128::from(fraction) * 1000;
    ((product >> 64) as usize, product as u64)
}

/// Puts first digits at `start`; returns their end.
#[inline(always)]
fn put_first_digits(room: &mut [u8; SHORT_ROOM], start: usize, digits: u32) -> usize {
    room[start..start + 4].copy_from_slice(&digits.to_le_bytes());
    start + (digits >> 30) as usize
}

/// Puts a whole number of four to six digits at `start`; returns their end, or `None` if it has more.
#[inline(always)]
fn put_six_digits(room: &mut [u8; SHORT_ROOM], start: usize, whole: u32) -> Option<usize> {
    let at = put_first_digits(room, start, *FIRST_DIGITS.get(whole as usize / 1000)?);
    let digits = all_digits(ENDINGS[0][whole as usize % 1000]) >> 8;
    room[at..at + 4].copy_from_slice(&digits.to_le_bytes());
    Some(at + 3)
}

/// Puts any number and a blank into the room; returns their length.
pub(super) fn put_number(room: &mut [u8; NUMBER_ROOM], number: Decimal, numerals: Numerals) -> usize {
    let negative = number.units < 0;
    room[0] = if negative { b'-' } else { b'+' };
    let start = usize::from(negative || numerals.plus);
    let per_one = 10_u64.pow(number.decimals);
    let units = number.units.unsigned_abs();
    let (mut whole, mut fraction) = (units / per_one, units % per_one);
    let decimals = number.decimals as usize;
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
    let end = match decimals - zeros {
        0 => at + usize::from(numerals.point),
        written => at + 1 + written,
    };
    room[end] = b' ';
    end + 1
}

/// Writes a number in the number format of a control.
pub(crate) fn write_number(out: &mut Vec<u8>, number: Decimal, numerals: Numerals) {
    let mut room = [0; NUMBER_ROOM];
    let length = put_number(&mut room, number, numerals);
    out.extend_from_slice(&room[..length - 1]);
}

/// Writes a number: no zeros after the last digit, no point without decimals, no `-0`.
pub(crate) fn write_decimal(out: &mut Vec<u8>, number: Decimal) {
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
        let eight = |value| text(Decimal::significant(value, MOST_SIGNIFICANT).expect("fits"));
        assert_eq!((eight(1.0 / 3.0), eight(1_234.567_890_123)), ("0.33333333".to_owned(), "1234.5679".to_owned()));
        assert_eq!((eight(1e-12), eight(1_234_567_890.0)), ("0.000000000001".to_owned(), "1234567900".to_owned()));
    }

    const NUMERALS: [Numerals; 4] = [
        Numerals { point: false, plus: false },
        Numerals { point: true, plus: false },
        Numerals { point: false, plus: true },
        Numerals { point: true, plus: true },
    ];

    /// A word with these decimals as a short one, in every number format, equals letters and a number of any length.
    fn short_words_are_as_long_ones(units: i64, decimals: u32) {
        for (letters, numerals) in
            ["", "X", "C12=", "ABCDEF"].into_iter().flat_map(|text| NUMERALS.map(|how| (text, how)))
        {
            let mut short = [b'#'; SHORT_ROOM];
            let length = ShortForm::new(letters, decimals, numerals).put(&mut short, units);
            assert_eq!(length.is_some(), units.unsigned_abs() < MILLION * 10_u64.pow(decimals), "{units} {decimals}");
            let mut room = [0; NUMBER_ROOM];
            let end = put_number(&mut room, Decimal { units, decimals }, numerals);
            let expected = [letters.as_bytes(), &room[..end]].concat();
            if let Some(length) = length {
                assert_eq!(short[..length], expected, "{units} {decimals} {numerals:?}");
            }
        }
    }

    #[test]
    fn a_short_word_is_written_as_a_long_one_up_to_the_ends_of_its_range() {
        for decimals in 0..=SHORT_DECIMALS as u32 {
            let per_one = 10_i64.pow(decimals);
            for end in [0, per_one, 10 * per_one, 100 * per_one, 1000 * per_one, MILLION as i64 * per_one] {
                for units in end - 1100..end + 1100 {
                    short_words_are_as_long_ones(units, decimals);
                    short_words_are_as_long_ones(-units, decimals);
                }
            }
        }
    }

    #[test]
    fn words_with_more_letters_or_decimals_are_not_short() {
        let is_short = |letters: &str, decimals, units| {
            ShortForm::new(letters, decimals, Numerals::default()).put(&mut [0; SHORT_ROOM], units).is_some()
        };
        assert!(is_short("ABCDEF", 6, 0) && !is_short("ABCDEFG", 6, 0) && !is_short("X", 7, 0));
        assert!(!is_short("X", 3, i64::MIN) && !is_short("X", 3, i64::MAX));
    }

    proptest! {
        #[test]
        fn a_short_word_is_written_as_a_long_one(
            units in prop_oneof![
                -1_000_000_000_000_i64..1_000_000_000_000,
                -1_000_000_000_i64..1_000_000_000,
                -1_000_000_i64..1_000_000,
            ],
            zeros in 0_u32..6,
            decimals in 0..=SHORT_DECIMALS as u32,
        ) {
            short_words_are_as_long_ones(units, decimals);
            let rounded = units / 10_i64.pow(zeros) * 10_i64.pow(zeros);
            short_words_are_as_long_ones(rounded, decimals);
        }

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
            // The number of units is a product of binary64, and so is the value that it stands for: each may be half of
            // its last bit off.
            let arithmetic = value.abs() * f64::EPSILON;
            prop_assert!((rounded - value).abs() <= 0.5 / power_of_ten(decimals) * (1.0 + 1e-9) + arithmetic);
        }

        #[test]
        fn six_digits_are_within_half_of_the_sixth(exponent in -11_i32..12, mantissa in 1.0_f64..10.0) {
            let value = mantissa * 10_f64.powi(exponent);
            let rounded = Decimal::significant(value, 6).expect("fits").value();
            prop_assert!((rounded - value).abs() <= value * 5.000_001e-6, "{} {}", value, rounded);
        }
    }
}
