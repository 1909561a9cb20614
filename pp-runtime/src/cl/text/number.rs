//! Reads decimal numbers of CL data, correctly rounded.
//!
//! Reads `1`, `1.`, `.5`, `-0.0`, `+2`, `1.E-3` and the Fortran exponents `1D2`, `1.0D+02`. Nothing else is a
//! number: no blanks inside, no `inf`, no `NaN`, no hexadecimal.
//!
//! Nearly every number of a real file has fewer than 16 digits, and then mantissa and power of ten are both exact in
//! binary64, so one multiplication or division rounds correctly (Clinger). The standard library reads the others.

use wide::bytemuck::cast;
use wide::{f64x2, i16x8, u8x16, u16x8};

/// Powers of ten that binary64 holds exactly.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Largest mantissa up to which every integer is exact in binary64.
const LARGEST_EXACT_MANTISSA: u64 = 1 << 53;

/// Number of decimal digits that always fit a `u64`.
const DIGITS_OF_U64: usize = 19;

/// Number of decimal digits whose mantissa is always exact in binary64.
const EXACT_DIGITS: usize = 15;

/// Bytes that [`ShortNumber::read`] may look at.
pub(crate) const SHORT_NUMBER: usize = 40;

/// Blanks, sign, digits and point of a short number: one whose point is among its first eight bytes, with fifteen
/// digits at most, and no exponent. Nearly every number of a file is short.
#[derive(Debug, Clone, Copy)]
struct NumberLayout {
    /// Index of the first digit, or of the point before it.
    first: usize,
    /// Index of the byte after the digits before the point.
    point: usize,
    decimals: usize,
    /// Index of the byte after the number.
    end: usize,
    negative: bool,
}

/// A short number.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShortNumber {
    pub(super) value: f64,
    /// Index of the byte after the number.
    pub(super) end: usize,
    /// Equal for all numbers with sign, digits and point at the same places.
    pub(super) mark: u64,
}

/// Where the digits of a short number are. Where that is known in advance, they are moved into the bytes of one integer
/// and summed there.
#[derive(Debug, Clone, Copy)]
pub(super) struct NumberShape {
    /// Index of the byte after the number.
    end: usize,
    /// The first eight digits.
    digits: DigitPlaces,
    /// Decimals after those, in bytes that follow: there the number is summed in parts.
    rest: usize,
}

/// Places of the digits of a number, of which there are eight at most.
#[derive(Debug, Clone, Copy)]
pub(super) struct DigitPlaces {
    /// Index of the first byte of the number, bits of the digits before the point in eight bytes from there on, and
    /// their rotation to their places among eight.
    at: usize,
    whole_bits: u64,
    whole_rotation: u32,
    /// Index of the first decimal, bits of the decimals in the bytes from there on, and their shift.
    decimals_at: usize,
    decimal_bits: u64,
    decimal_shift: u32,
    /// Zeros at the places of the digits.
    zeros: u64,
    /// Power of ten of the decimals; below zero with a sign.
    scale: f64,
}

impl DigitPlaces {
    /// Those of no number.
    pub(super) const NONE: Self = Self {
        at: 0,
        whole_bits: 0,
        whole_rotation: 0,
        decimals_at: 0,
        decimal_bits: 0,
        decimal_shift: 0,
        zeros: 0,
        scale: 1.0,
    };

    /// These places in a text in which the number begins at an index.
    pub(super) fn after(self, start: usize) -> Self {
        Self { at: self.at + start, decimals_at: self.decimals_at + start, ..self }
    }

    /// The digits as numbers, one in each byte, the last in the highest.
    #[inline(always)]
    fn digits<const LENGTH: usize>(&self, text: &[u8; LENGTH]) -> u64 {
        let whole = (u64_at(text, self.at) & self.whole_bits).rotate_left(self.whole_rotation);
        let decimals = (u64_at(text, self.decimals_at) & self.decimal_bits) << self.decimal_shift;
        (whole | decimals) ^ self.zeros
    }
}

impl NumberLayout {
    /// That of the number at the start of `text`, blanks before it included; `None` if it is not short, or no byte
    /// after it ends a number of a list.
    #[inline(always)]
    fn of(text: &[u8; SHORT_NUMBER]) -> Option<Self> {
        let mut first = 0;
        while text[first] == b' ' {
            first += 1;
            if first == 8 {
                return None;
            }
        }
        let negative = text[first] == b'-';
        first += usize::from(negative);
        // A short number is no longer than these.
        let bytes = u8x16::from(*text[first..].first_chunk()?);
        let numbers = bytes - u8x16::splat(b'0');
        let others = numbers.max(u8x16::splat(10)).simd_eq(numbers).to_bitmask() | 1 << 16;
        let whole = others.trailing_zeros() as usize;
        let point = first + whole;
        if point >= 8 {
            return None;
        }
        let (decimals, end) = if text[point] == b'.' {
            let end = (others & (others - 1)).trailing_zeros() as usize;
            (end - whole - 1, first + end)
        } else {
            (0, point)
        };
        // What may follow a number of a list comes before the point in the alphabet: a comma, a blank, the end of the
        // line.
        let is_short = (1..=EXACT_DIGITS).contains(&(whole + decimals)) && text[end] < b'.';
        is_short.then_some(Self { first, point, decimals, end, negative })
    }

    /// Power of ten of the decimals, below zero with a sign.
    #[inline(always)]
    fn scale(&self) -> f64 {
        let scale = POWERS_OF_TEN[self.decimals % POWERS_OF_TEN.len()];
        if self.negative { -scale } else { scale }
    }
}

impl ShortNumber {
    /// The number at the start of `text`, blanks before it included; `None` if it is not short, or no byte after it
    /// ends a number of a list.
    #[inline(always)]
    pub(super) fn read(text: &[u8; SHORT_NUMBER]) -> Option<Self> {
        let layout = NumberLayout::of(text)?;
        let NumberLayout { first, point, decimals, end, .. } = layout;
        // The last digit is to be in the highest byte.
        let digits = |from: usize, to: usize| ((u64_at(text, from) ^ ZEROS) << (8 * (7 - (to - from)) % 64)) << 8;
        let mut mantissa = value_of(digits(first, point));
        let mut from = point + 1;
        if decimals >= 8 {
            mantissa = mantissa * 100_000_000 + value_of(u64_at(text, from) ^ ZEROS);
            from += 8;
        }
        mantissa = mantissa * POWERS[decimals % 8] + value_of(digits(from, from + decimals % 8));
        let mark = (first | point << 8 | end << 16) as u64 ^ u64::from(layout.negative) << 32;
        Some(Self { value: mantissa as f64 / layout.scale(), end, mark })
    }
}

impl NumberShape {
    /// That of no number.
    pub(super) const NONE: Self = Self { end: 0, digits: DigitPlaces::NONE, rest: 0 };

    /// That of the short number at the start of `text`.
    pub(super) fn of(text: &[u8; SHORT_NUMBER]) -> Option<Self> {
        let layout = NumberLayout::of(text)?;
        let NumberLayout { first, point, decimals, end, .. } = layout;
        // Bits of the bytes from one on, below eight, up to another.
        let bits =
            |from: usize, to: usize| u64::MAX.checked_shr(8 * (8 - (to - from)) as u32).unwrap_or(0) << (8 * from);
        // The first eight digits end in the highest byte.
        let digits = point - first + decimals;
        let (together, rest) = (digits.min(8), digits.saturating_sub(8));
        Some(Self {
            end,
            digits: DigitPlaces {
                at: 0,
                whole_bits: bits(first, point),
                whole_rotation: 8 * (16 - together - first) as u32 % u64::BITS,
                decimals_at: point + 1,
                decimal_bits: bits(0, decimals - rest),
                decimal_shift: 8 * (8 - (decimals - rest)) as u32 % u64::BITS,
                zeros: ZEROS << (8 * (8 - together)),
                scale: layout.scale(),
            },
            rest,
        })
    }

    /// Index of the byte after the number.
    pub(super) fn end(&self) -> usize {
        self.end
    }

    /// The number at the start of `text`, which has this shape.
    #[inline(always)]
    pub(super) fn value(&self, text: &[u8; SHORT_NUMBER]) -> f64 {
        let first = value_of(self.digits.digits(text));
        let mantissa = if self.rest == 0 { first } else { self.with_rest(first, text) };
        mantissa as f64 / self.digits.scale
    }

    /// Whether a number of this shape has more than eight digits.
    pub(super) fn is_long(&self) -> bool {
        self.rest > 0
    }

    /// The places of the first eight digits.
    pub(super) fn digits(&self) -> DigitPlaces {
        self.digits
    }

    /// Mantissa with the decimals after the first eight digits.
    #[inline(never)]
    fn with_rest(&self, first: i64, text: &[u8; SHORT_NUMBER]) -> i64 {
        let rest = (u64_at(text, self.end - self.rest) ^ ZEROS) << (8 * (8 - self.rest));
        first * POWERS[self.rest] + value_of(rest)
    }
}

/// Powers of ten by which fewer than eight digits are moved.
const POWERS: [i64; 8] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000];

const ZEROS: u64 = 0x3030_3030_3030_3030;

/// Eight bytes from `at` on, the first in the lowest byte. The index is one of as many, a power of two, as have eight
/// bytes after them; it is larger only where there are no digits.
#[inline(always)]
fn u64_at<const LENGTH: usize>(text: &[u8; LENGTH], at: usize) -> u64 {
    let indices = const { 1 << (LENGTH - 7).ilog2() };
    text[at % indices..].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes))
}

/// Value of eight digits, one in each byte, the last in the highest. They are summed in pairs, fours and eights.
#[inline]
fn value_of(digits: u64) -> i64 {
    const PAIRS: u64 = 0x0000_00FF_0000_00FF;
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let first_and_third = (pairs & PAIRS).wrapping_mul(100 + (1_000_000 << 32));
    let second_and_fourth = ((pairs >> 16) & PAIRS).wrapping_mul(1 + (10_000 << 32));
    (first_and_third.wrapping_add(second_and_fourth) >> 32).cast_signed()
}

/// Two numbers with digits at these places of a text.
#[inline(always)]
pub(super) fn two_numbers<const LENGTH: usize>(places: [&DigitPlaces; 2], text: &[u8; LENGTH]) -> [f64; 2] {
    // The same sums as in `value_of`.
    // In the high byte of 256 · 10 + 1 times two digits is ten times the first and the second.
    let digits: u16x8 = cast(places.map(|places| places.digits(text)));
    let pairs: i16x8 = cast((digits * u16x8::splat(2561)) >> 8_u32);
    let fours = pairs.dot(i16x8::new([100, 1, 100, 1, 100, 1, 100, 1]));
    let fours = i16x8::from_i32x8_saturate(cast([fours, fours]));
    let eights = fours.dot(i16x8::new([10_000, 1, 10_000, 1, 10_000, 1, 10_000, 1]));
    (f64x2::from_i32x4_lower2(eights) / f64x2::from(places.map(|places| places.scale))).to_array()
}

/// Returns the number at the start of `text` and the count of its bytes; `None` if no number starts there.
///
/// A number too large for binary64 is returned as an infinity, which the caller must refuse.
#[inline]
pub(crate) fn number_at_start(text: &[u8]) -> Option<(f64, usize)> {
    let sign = text.first().copied();
    let whole = usize::from(matches!(sign, Some(b'-' | b'+')));
    // Wraps beyond 19 digits; a number with more is not computed from it.
    let (mut at, mut mantissa) = (whole, 0_u64);
    at += digits_of(&text[at..], &mut mantissa);
    let (mut digits, mut decimals) = (at - whole, 0);
    if text.get(at) == Some(&b'.') {
        at += 1;
        decimals = digits_of(&text[at..], &mut mantissa);
        (at, digits) = (at + decimals, digits + decimals);
    }
    if digits == 0 {
        return None;
    }
    let magnitude = if digits <= EXACT_DIGITS && !matches!(text.get(at), Some(b'E' | b'e' | b'D' | b'd')) {
        mantissa.cast_signed() as f64 / POWERS_OF_TEN[decimals]
    } else {
        let (magnitude, end) = long_number(text, whole, at, Mantissa { value: mantissa, digits, decimals })?;
        at = end;
        magnitude
    };
    Some((if sign == Some(b'-') { -magnitude } else { magnitude }, at))
}

/// Digits of a number without its exponent.
#[derive(Debug, Clone, Copy)]
struct Mantissa {
    /// The digits as a whole number; wrapped where there are more than 19.
    value: u64,
    digits: usize,
    /// Number of the digits after the decimal point.
    decimals: usize,
}

/// Magnitude of a number with an exponent or with many digits, and its end. Its digits begin at `start` and end at
/// `at`.
#[cold]
fn long_number(
    text: &[u8],
    start: usize,
    at: usize,
    Mantissa { value: mantissa, digits, decimals }: Mantissa,
) -> Option<(f64, usize)> {
    let (mut end, mut exponent) = (at, -i64::try_from(decimals).ok()?);
    if matches!(text.get(at), Some(b'E' | b'e' | b'D' | b'd')) {
        let (power, used) = integer(&text[at + 1..])?;
        exponent = exponent.saturating_add(power);
        end = at + 1 + used;
    }
    let magnitude = match usize::try_from(exponent.unsigned_abs()) {
        Ok(power) if digits <= DIGITS_OF_U64 && mantissa < LARGEST_EXACT_MANTISSA && power < POWERS_OF_TEN.len() => {
            #[allow(clippy::cast_precision_loss)] // Below 2^53, so exact.
            let mantissa = mantissa as f64;
            if exponent < 0 { mantissa / POWERS_OF_TEN[power] } else { mantissa * POWERS_OF_TEN[power] }
        }
        _ => rounded_by_library(&text[start..end], at - start)?,
    };
    Some((magnitude, end))
}

/// Appends the digits at the start of `text` to `mantissa`; returns their count.
#[inline]
fn digits_of(text: &[u8], mantissa: &mut u64) -> usize {
    let mut count = 0;
    for byte in text {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            break;
        }
        *mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(digit));
        count += 1;
    }
    count
}

/// Returns the number in `text`; `None` if a byte does not belong to it.
pub(crate) fn whole_number(text: &[u8]) -> Option<f64> {
    number_at_start(text).filter(|&(_, used)| used == text.len()).map(|(value, _)| value)
}

/// Returns an exponent with its sign and the count of its bytes. Huge exponents saturate, so that the number becomes
/// zero or infinity.
fn integer(text: &[u8]) -> Option<(i64, usize)> {
    let signed = usize::from(matches!(text.first(), Some(b'-' | b'+')));
    let digits = text[signed..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    if digits == 0 {
        return None;
    }
    let magnitude = text[signed..signed + digits]
        .iter()
        .fold(0_i64, |sum, byte| sum.saturating_mul(10).saturating_add(i64::from(byte - b'0')))
        .min(1 << 32);
    Some((if text[0] == b'-' { -magnitude } else { magnitude }, signed + digits))
}

/// Lets the standard library read `text`, an unsigned number with its exponent letter, if any, at `letter`.
#[cold]
fn rounded_by_library(text: &[u8], letter: usize) -> Option<f64> {
    let text = std::str::from_utf8(text).ok()?;
    if matches!(text.as_bytes().get(letter), Some(b'D' | b'd')) {
        // The library does not read Fortran's D; only long numbers with a D are copied.
        return format!("{}e{}", &text[..letter], &text[letter + 1..]).parse().ok();
    }
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{NumberShape, SHORT_NUMBER, ShortNumber, number_at_start as prefix, whole_number as whole};
    use proptest::prelude::*;

    #[test]
    fn every_form_of_number_in_cl_data_is_read() {
        for (text, value) in [
            ("1", 1.0),
            ("1.", 1.0),
            (".5", 0.5),
            ("-.5", -0.5),
            ("+2", 2.0),
            ("1.E-3", 1e-3),
            ("1D2", 100.0),
            ("1.0D+02", 100.0),
            ("2d-1", 0.2),
            ("00012.50", 12.5),
            ("0.0000000", 0.0),
            ("-254.9773", -254.9773),
            ("1.7976931348623157D308", f64::MAX),
        ] {
            assert_eq!(whole(text.as_bytes()).map(f64::to_bits), Some(value.to_bits()), "{text}");
        }
        assert_eq!(whole(b"-0.0").map(f64::to_bits), Some((-0.0_f64).to_bits()));
    }

    const SHORT: [&str; 20] = [
        "0",
        "-0.0",
        "7.",
        ".5",
        "-.5",
        "999999.9999999",
        "-999999.99999999",
        "0.1234567",
        "0.12345678",
        "-0.12345678901234",
        "123456.12345678",
        "12,",
        "3-4",
        "1 2",
        "48.1234\r",
        "48.12345",
        "-48.1234$",
        "   17.00000",
        "   -0.25000",
        "-34.5000000000",
    ];

    #[test]
    fn short_numbers_are_read_as_any_number() {
        for text in SHORT {
            let blanks = text.len() - text.trim_start().len();
            let expected = prefix(text.trim_start().as_bytes()).map(|(value, used)| (value, blanks + used));
            assert_eq!(read(text), expected, "{text}");
        }
        for text in
            ["", "-", ".", "-.", "+1", "123456789", "0.123456789012345", "1E5", "1.5D2", "1.2.3", "1/2", "x", "/"]
        {
            assert_eq!(read(text), None, "{text}");
        }
    }

    /// The number at the start of `text`, which may be shorter than the bytes that are looked at, and the count of its
    /// bytes. By its shape it is the same.
    fn read(text: &str) -> Option<(f64, usize)> {
        let mut room = [b','; SHORT_NUMBER];
        let bytes = text.len().min(SHORT_NUMBER);
        room[..bytes].copy_from_slice(&text.as_bytes()[..bytes]);
        let ShortNumber { value, end, .. } = ShortNumber::read(&room)?;
        let shape = NumberShape::of(&room).expect("a short number");
        assert_eq!((shape.value(&room).to_bits(), shape.end()), (value.to_bits(), end), "{text}");
        Some((value, end))
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in
            ["", "-", ".", "+.", "E5", "1E", "1E+", "NaN", "inf", "-inf", "0x10", "1_0", "--1", "1 2", "1,", "900CCLW"]
        {
            assert_eq!(whole(text.as_bytes()), None, "{text:?}");
        }
    }

    #[test]
    fn a_number_beyond_binary64_is_an_infinity() {
        assert_eq!(whole(b"1E999"), Some(f64::INFINITY));
        assert_eq!(whole(b"-1D99999999999999999999"), Some(f64::NEG_INFINITY));
        assert_eq!(whole(b"1E-999"), Some(0.0));
    }

    #[test]
    fn reading_stops_after_the_number() {
        assert_eq!(prefix(b"12.5,3"), Some((12.5, 4)));
        assert_eq!(prefix(b"900CCLW"), Some((900.0, 3)));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn random_decimals_read_as_the_standard_library_reads_them(
            text in "[-+]?([0-9]{1,25}(\\.[0-9]{0,25})?|\\.[0-9]{1,25})([eE][-+]?[0-9]{1,3})?"
        ) {
            let expected: f64 = text.parse().unwrap();
            prop_assert_eq!(whole(text.as_bytes()).map(f64::to_bits), Some(expected.to_bits()));
            let fortran = text.replace(['e', 'E'], "D");
            prop_assert_eq!(whole(fortran.as_bytes()).map(f64::to_bits), Some(expected.to_bits()));
        }

        #[test]
        fn random_short_numbers_read_as_any_number(text in " {0,3}-?[0-9]{0,7}(\\.[0-9]{0,16})?[ -~]{0,6}") {
            if let Some((value, used)) = read(&text) {
                // Blanks before a number are skipped.
                let number = text.trim_start();
                let (expected, end) = prefix(number.as_bytes()).unwrap();
                let end = text.len() - number.len() + end;
                prop_assert_eq!((value.to_bits(), used), (expected.to_bits(), end));
            }
        }

        #[test]
        fn numbers_of_one_shape_are_read_at_once(one in 1_u32..1000, other in 1_u32..1000, decimals in 0_usize..10) {
            let text = |number: u32| format!("-{}.{:0>decimals$}", 1000 + number, &"1234567890"[..decimals]);
            let room = |text: &str| {
                let mut room = [b','; SHORT_NUMBER];
                room[..text.len()].copy_from_slice(text.as_bytes());
                room
            };
            let shape = NumberShape::of(&room(&text(one))).unwrap();
            let expected = text(other).parse::<f64>().unwrap();
            prop_assert_eq!(shape.value(&room(&text(other))).to_bits(), expected.to_bits());
        }

        #[test]
        fn numbers_of_real_files_are_short(text in "-?[0-9]{1,5}\\.[0-9]{0,10}[,\r\n$ ]") {
            prop_assert!(read(&text).is_some());
        }
    }
}
