//! Reads decimal numbers of CL data, correctly rounded.
//!
//! Reads `1`, `1.`, `.5`, `-0.0`, `+2`, `1.E-3` and the Fortran exponents `1D2`, `1.0D+02`. Nothing else is a
//! number: no blanks inside, no `inf`, no `NaN`, no hexadecimal.
//!
//! Nearly every number of a real file has fewer than 16 digits, and then mantissa and power of ten are both exact in
//! binary64, so one multiplication or division rounds correctly (Clinger). The standard library reads the others.

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

/// Bytes that [`short_number`] may look at.
pub(crate) const SHORT_NUMBER: usize = 24;

/// Returns the number at the start of `text` and the count of its bytes, if it has at most six digits before its point, at
/// most seven after it, and no exponent: nearly every number of a real file. The bytes after it may be anything.
#[inline]
pub(crate) fn short_number(text: &[u8; SHORT_NUMBER]) -> Option<(f64, usize)> {
    let signed = usize::from(text[0] == b'-');
    let whole = digits_in(u64_at(text, 0) >> (8 * signed));
    // The byte after six digits and a sign has been read.
    if whole.count > 6 {
        return None;
    }
    let mut end = signed + whole.count;
    let mut fraction = Digits { digits: 0, count: 0 };
    if text[end] == b'.' {
        fraction = digits_in(u64_at(text, end + 1));
        end += 1 + fraction.count;
    }
    let count = whole.count + fraction.count;
    // After eight digits more may come.
    if count == 0 || fraction.count == 8 || matches!(text[end], b'E' | b'e' | b'D' | b'd') {
        return None;
    }
    let mantissa = if count <= 8 {
        value_of(whole.digits | fraction.digits << (8 * whole.count), count)
    } else {
        let whole = value_of(whole.digits, whole.count);
        whole * WHOLE_POWERS_OF_TEN[fraction.count] + value_of(fraction.digits, fraction.count)
    };
    let magnitude = mantissa as f64 / POWERS_OF_TEN[fraction.count];
    Some((if signed == 1 { -magnitude } else { magnitude }, end))
}

/// Powers of ten by which digits are moved before those of a fraction.
const WHOLE_POWERS_OF_TEN: [i64; 9] = [1, 10, 100, 1_000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];

/// Eight bytes from `at` on, the first in the lowest byte.
#[inline]
fn u64_at(text: &[u8; SHORT_NUMBER], at: usize) -> u64 {
    text[at..].first_chunk().map_or(0, |bytes| u64::from_le_bytes(*bytes))
}

/// Decimal digits, one in each byte, the first in the lowest; zero after them.
struct Digits {
    digits: u64,
    count: usize,
}

/// The digits with which eight bytes begin.
#[inline]
fn digits_in(bytes: u64) -> Digits {
    const HIGH_BITS: u64 = 0x8080_8080_8080_8080;
    let digits = bytes ^ 0x3030_3030_3030_3030;
    // The high bit of a byte is set where it is no digit; after the first such byte the sum may carry.
    let others = (digits.wrapping_add(0x7676_7676_7676_7676) | digits) & HIGH_BITS;
    // All bits below that of the first other byte, of which those of its own byte are left out.
    let before = (others ^ others.wrapping_sub(1)) >> 8;
    Digits { digits: digits & before, count: (others.trailing_zeros() / 8) as usize }
}

/// Value of the first `count` digits, 1 to 8: they are summed in pairs, fours and eights.
#[inline]
fn value_of(digits: u64, count: usize) -> i64 {
    const PAIRS: u64 = 0x0000_00FF_0000_00FF;
    // The last digit in the highest byte, zeros before the first.
    let digits = digits << (8 * (8 - count) % 64);
    let pairs = digits.wrapping_mul(10).wrapping_add(digits >> 8);
    let first_and_third = (pairs & PAIRS).wrapping_mul(100 + (1_000_000 << 32));
    let second_and_fourth = ((pairs >> 16) & PAIRS).wrapping_mul(1 + (10_000 << 32));
    (first_and_third.wrapping_add(second_and_fourth) >> 32).cast_signed()
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
        let (magnitude, end) = long_number(text, whole, at, (mantissa, digits, decimals))?;
        at = end;
        magnitude
    };
    Some((if sign == Some(b'-') { -magnitude } else { magnitude }, at))
}

/// Magnitude of a number with an exponent or with many digits, and its end. Its digits begin at `start` and end at `at`.
#[cold]
fn long_number(
    text: &[u8],
    start: usize,
    at: usize,
    (mantissa, digits, decimals): (u64, usize, usize),
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
    use super::{SHORT_NUMBER, number_at_start as prefix, short_number, whole_number as whole};
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

    #[test]
    fn short_numbers_are_read_as_any_number() {
        for text in [
            "0",
            "-0.0",
            "7.",
            ".5",
            "-.5",
            "999999.9999999",
            "-999999.9999999",
            "0.1234567",
            "12,",
            "1.2.3",
            "3-4",
            "1 2",
            "48.1234\r",
        ] {
            assert_eq!(short(text.as_bytes()), prefix(text.as_bytes()), "{text}");
        }
        for text in ["", "-", ".", "-.", "+1", "1234567", "0.12345678", "1E5", "1.5D2", "x", "/"] {
            assert_eq!(short(text.as_bytes()), None, "{text}");
        }
    }

    /// The number at the start of `text`, which may be shorter than the bytes that are looked at.
    fn short(text: &[u8]) -> Option<(f64, usize)> {
        let mut room = [b','; SHORT_NUMBER];
        let bytes = text.len().min(SHORT_NUMBER);
        room[..bytes].copy_from_slice(&text[..bytes]);
        short_number(&room)
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
        fn random_short_numbers_read_as_any_number(
            text in "-?[0-9]{0,7}(\\.[0-9]{0,8})?[ -~]{0,6}"
        ) {
            if let Some((value, used)) = short(text.as_bytes()) {
                let (expected, end) = prefix(text.as_bytes()).unwrap();
                prop_assert_eq!((value.to_bits(), used), (expected.to_bits(), end));
            }
        }

        #[test]
        fn numbers_of_real_files_are_short(text in "-?[0-9]{1,6}\\.[0-9]{0,7}[,\r\n$ ]") {
            prop_assert!(short(text.as_bytes()).is_some());
        }
    }
}
