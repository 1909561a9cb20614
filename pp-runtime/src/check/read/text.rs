//! Bytes of a line: numbers, names, blanks.

use crate::check::tolerances::{CODE_IN_TENTHS, SAME_NUMBER};

/// A number as it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Number {
    pub(crate) value: f64,
    /// It has a decimal point.
    pub(crate) point: bool,
    /// It begins with `-`.
    pub(crate) negative: bool,
}

/// A place in a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    line: &'a [u8],
    /// What comes next.
    rest: &'a [u8],
}

/// End of a line that goes on in the next one, after its mark `~`: no line holds it. The mark is blank while a line is
/// read.
pub(super) const GOES_ON: u8 = b'\n';

/// Marks of lines that go on in the next one.
const MARK: u8 = b'~';

/// Gives a line that goes on in the next one its marks back, as the program has them.
pub(super) fn put_marks_back(line: &mut [u8]) {
    for end in 1..line.len() {
        if line[end] == GOES_ON {
            line[end - 1] = MARK;
        }
    }
}

/// Puts blanks in the place of the marks of lines that go on in the next one.
pub(super) fn take_marks_away(line: &mut [u8]) {
    for end in 1..line.len() {
        if line[end] == GOES_ON && line[end - 1] == MARK {
            line[end - 1] = b' ';
        }
    }
}

/// Powers of ten that are exact.
const TENS: [f64; 20] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19];

/// More digits than this are no word of a program.
const MOST_DIGITS: usize = 18;

impl<'a> Cursor<'a> {
    pub(super) fn new(line: &'a [u8]) -> Self {
        Self { line, rest: line }
    }

    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// What has been taken from a column on.
    pub(super) fn read_from(&self, column: usize) -> &'a [u8] {
        &self.line[column..self.column()]
    }

    /// What is between two columns.
    pub(super) fn between(&self, from: usize, to: usize) -> &'a [u8] {
        &self.line[from..to]
    }

    /// Column that comes next, from 0.
    pub(super) fn column(&self) -> usize {
        self.line.len() - self.rest.len()
    }

    /// Goes to a column.
    pub(super) fn go_to(&mut self, column: usize) {
        self.rest = self.line.get(column..).unwrap_or_default();
    }

    /// Passes over some bytes.
    pub(super) fn skip(&mut self, count: usize) {
        self.rest = self.rest.get(count..).unwrap_or_default();
    }

    /// What comes before a column.
    pub(super) fn before(&self, column: usize) -> &'a [u8] {
        &self.line[..column.min(self.line.len())]
    }

    /// Goes to the end; what was left.
    pub(super) fn take_rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.rest)
    }

    pub(super) fn peek(&self) -> Option<u8> {
        self.rest.first().copied()
    }

    pub(super) fn blanks(&mut self) {
        while let [b' ' | b'\t' | b'\r', rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    pub(super) fn ended(&mut self) -> bool {
        self.blanks();
        self.rest.is_empty()
    }

    /// Takes a byte if it comes next.
    pub(super) fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.skip(usize::from(found));
        found
    }

    /// Takes a word if it comes next, whatever its case, and no letter or digit follows it.
    pub(super) fn word(&mut self, word: &[u8]) -> bool {
        self.blanks();
        let rest = self.rest();
        let found = rest.len() >= word.len()
            && rest[..word.len()].eq_ignore_ascii_case(word)
            && !rest.get(word.len()).is_some_and(|next| next.is_ascii_alphanumeric() || *next == b'_');
        if found {
            self.skip(word.len());
        }
        found
    }

    /// Takes a text if it comes next, whatever its case and the blanks between its bytes.
    pub(super) fn literal(&mut self, text: &[u8]) -> bool {
        let start = self.rest;
        for wanted in text {
            self.blanks();
            if !self.peek().is_some_and(|byte| byte.eq_ignore_ascii_case(wanted)) {
                self.rest = start;
                return false;
            }
            self.skip(1);
        }
        true
    }

    /// Takes words one after the other, each as [`word`](Self::word) does.
    pub(super) fn words(&mut self, words: &str) -> bool {
        let start = self.rest;
        let found = words.split(' ').all(|word| self.word(word.as_bytes()));
        if !found {
            self.rest = start;
        }
        found
    }

    /// Takes a number, and blanks before it.
    pub(super) fn spaced_number(&mut self) -> Option<Number> {
        self.blanks();
        self.number()
    }

    /// Takes the sign of a subtraction and a number without a sign: 30 of `- 30`, -20 of `+ 20`.
    pub(super) fn subtracted(&mut self) -> Option<f64> {
        self.blanks();
        let minus = self.take(b'-');
        (minus || self.take(b'+')).then_some(())?;
        self.blanks();
        self.peek().filter(|byte| byte.is_ascii_digit() || *byte == b'.')?;
        let value = self.number()?.value;
        Some(if minus { value } else { -value })
    }

    /// Takes a letter and the number after it, blanks between them or not.
    pub(super) fn letter_and_number(&mut self) -> Option<(u8, Number)> {
        let letter = self.peek().filter(u8::is_ascii_alphabetic)?;
        self.skip(1);
        self.blanks();
        Some((letter, self.number()?))
    }

    /// Takes letters, digits and underscores.
    pub(super) fn name(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_').unwrap_or(rest.len());
        self.skip(end);
        &rest[..end]
    }

    /// Takes letters only.
    pub(super) fn letters(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|byte| !byte.is_ascii_alphabetic()).unwrap_or(rest.len());
        self.skip(end);
        &rest[..end]
    }

    /// Takes a number: sign, digits, a point; no exponent, at least one digit.
    #[inline(always)]
    pub(super) fn number(&mut self) -> Option<Number> {
        let goes_on = |digits: &Digits<'_>| matches!(digits.after, [b'.'..=b'9', ..]);
        self.signed(|at, text| at.short_digits(text).filter(|digits| !goes_on(digits)).or_else(|| long_digits(text)))
    }

    /// Takes a number of no more than eight bytes after its sign, as nearly every one is. It is one if neither a digit
    /// nor a point comes next.
    #[inline(always)]
    pub(super) fn short_number(&mut self) -> Option<Number> {
        self.signed(Self::short_digits)
    }

    /// Takes a sign and the digits after it.
    #[inline(always)]
    fn signed(&mut self, digits: impl Fn(&Self, &'a [u8]) -> Option<Digits<'a>>) -> Option<Number> {
        let (negative, text) = match self.rest {
            [b'-', text @ ..] => (true, text),
            [b'+', text @ ..] => (false, text),
            text => (false, text),
        };
        let Digits { mantissa, point, decimals, after } = digits(self, text)?;
        self.rest = after;
        let value = mantissa as f64 / TENS[decimals];
        Some(Number { value: if negative { -value } else { value }, point, negative })
    }

    /// Digits and a point at the start of the rest of the line, if they are no more than eight bytes with another byte
    /// among or after them: all of them are found at once. `None` for any other text.
    #[inline(always)]
    fn short_digits(&self, text: &'a [u8]) -> Option<Digits<'a>> {
        let bytes = self.eight(text)? ^ ZEROS;
        let others = no_digits(bytes);
        if others == 0 {
            return None;
        }
        // Lengths in bits: of the digits before another byte, of the number, and of its digits.
        let whole = others.trailing_zeros() & !7;
        let point = bytes >> whole & 0xFF == u64::from(b'.' ^ b'0');
        let (digits, length, count) = if point {
            // Without the point the decimals follow the digits before it.
            let before = (1 << whole) - 1;
            let length = (others & (others - 1)).trailing_zeros() & !7;
            (bytes & before | bytes >> 8 & !before, length, length - 8)
        } else {
            (bytes, whole, whole)
        };
        let after = text.get((length / 8) as usize..)?;
        if count == 0 {
            return None;
        }
        let mantissa = value_of(digits << (64 - count)).cast_signed();
        // Seven at most, so that the compiler knows it.
        let decimals = ((count - whole) / 8) as usize & 7;
        Some(Digits { mantissa, point, decimals, after })
    }

    /// The first eight bytes of the rest of the line, the first one lowest, and zeros after its end; `None` in a
    /// shorter line.
    #[inline]
    fn eight(&self, text: &[u8]) -> Option<u64> {
        match text.first_chunk() {
            Some(bytes) => Some(u64::from_le_bytes(*bytes)),
            None => {
                let missing = 8 - text.len();
                u64::from_le_bytes(*self.line.last_chunk()?).checked_shr(8 * missing as u32)
            }
        }
    }
}

/// The digits of a number at the start of a text, byte by byte.
#[cold]
fn long_digits(text: &[u8]) -> Option<Digits<'_>> {
    let (whole, after) = digits(0, text);
    let point = matches!(after, [b'.', ..]);
    let (mantissa, after, decimals) = match after {
        [b'.', fraction @ ..] => {
            let (mantissa, after) = digits(whole, fraction);
            (mantissa, after, fraction.len() - after.len())
        }
        _ => (whole, after, 0),
    };
    let digits = text.len() - after.len() - usize::from(point);
    let is_number = (1..=MOST_DIGITS).contains(&digits) && !matches!(after, [b'.', ..]);
    is_number.then_some(Digits { mantissa, point, decimals, after })
}

/// Digits after others, and the text after them; of too many the value has no meaning.
#[inline]
fn digits(before: i64, text: &[u8]) -> (i64, &[u8]) {
    let (mut value, mut rest) = (before, text);
    while let [digit @ b'0'..=b'9', after @ ..] = rest {
        value = value.wrapping_mul(10).wrapping_add(i64::from(digit - b'0'));
        rest = after;
    }
    (value, rest)
}

/// Digits of a number with its point.
#[derive(Debug, Clone, Copy)]
struct Digits<'a> {
    /// Value of the digits as a whole number.
    mantissa: i64,
    point: bool,
    decimals: usize,
    /// The text after them.
    after: &'a [u8],
}

/// Eight digits 0; the others differ from these bits by their values.
const ZEROS: u64 = 0x3030_3030_3030_3030;

/// The high bits of the bytes that are no values of digits. The first two are right if the first one is that of a
/// point.
#[inline]
fn no_digits(bytes: u64) -> u64 {
    const HIGH_BITS: u64 = 0x8080_8080_8080_8080;
    // The sum has the high bit where the byte is above 9. Only a byte with a high bit carries.
    (bytes.wrapping_add(0x7676_7676_7676_7676) | bytes) & HIGH_BITS
}

/// Value of eight digits, the first in the lowest byte: of pairs, of fours, of all.
#[inline]
fn value_of(digits: u64) -> u64 {
    let pairs = (digits * 10 + (digits >> 8)) & 0x00FF_00FF_00FF_00FF;
    let fours = (pairs * 100 + (pairs >> 16)) & 0x0000_FFFF_0000_FFFF;
    (fours * 10_000 + (fours >> 32)) & 0xFFFF_FFFF
}

/// Whether two numbers are written alike.
pub(super) fn same(one: f64, other: f64) -> bool {
    (one - other).abs() < SAME_NUMBER
}

/// A whole number that is not negative.
pub(super) fn whole(number: Number) -> Option<u32> {
    let value = number.value;
    (value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u32::MAX)).then_some(value as u32)
}

/// A code in tenths: 91.1 is 911.
pub(super) fn tenths(number: Number) -> Option<u32> {
    let tenths = (number.value * 10.0).round();
    let exact = (number.value * 10.0 - tenths).abs() < CODE_IN_TENTHS;
    (exact && !number.negative && tenths <= 100_000.0).then_some(tenths as u32)
}

/// Bytes as text for a message, where they stand between back quotes.
pub(super) fn shown(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(60)]).replace('`', "'").replace(GOES_ON as char, "~ ")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Number at the start of a text, and its end.
    fn read(text: &[u8]) -> Option<(u64, bool, bool, usize)> {
        let mut at = Cursor::new(text);
        let Number { value, point, negative } = at.number()?;
        Some((value.to_bits(), point, negative, at.column()))
    }

    /// Number at the start of a text, and its end, by the standard library.
    fn expected(text: &[u8]) -> Option<(u64, bool, bool, usize)> {
        let text = std::str::from_utf8(text).expect("ASCII");
        let rest = text.strip_prefix(['-', '+']).unwrap_or(text);
        let end = rest.find(|byte: char| !byte.is_ascii_digit() && byte != '.').unwrap_or(rest.len());
        let (number, negative) = (&rest[..end], text.starts_with('-'));
        let (digits, points) = (number.replace('.', "").len(), number.matches('.').count());
        let value: f64 = number.parse().ok().filter(|_| (1..=15).contains(&digits) && points < 2)?;
        let value = if negative { -value } else { value };
        Some((value.to_bits(), points == 1, negative, text.len() - rest.len() + end))
    }

    #[test]
    fn numbers_are_read_at_the_end_of_a_line_and_before_other_words() {
        for number in
            ["7", "-0", "+.5", "5.", "-.125", "0.0625", "12345678", "123456789", "1234.567", "-123.4567", "1234567."]
        {
            for after in ["", " ", "Y1.5", " Y-20.123 Z4.", ";", "(A)"] {
                let text = format!("{number}{after}");
                assert_eq!(read(text.as_bytes()), expected(text.as_bytes()), "{text}");
            }
        }
        for text in ["", "-", ".", "-.", "1.2.3", "12345.78.", "1..2", "X1", "1234567890123456789"] {
            assert_eq!(read(text.as_bytes()), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn any_text_of_digits_is_the_number_of_the_library(text in "[-+]?[0-9]{0,9}[.]?[0-9]{0,6}([A-Z /][0-9 ]{0,9}|[.])?") {
            prop_assert_eq!(read(text.as_bytes()), expected(text.as_bytes()), "{}", text);
        }
    }
}
