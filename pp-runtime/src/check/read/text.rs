//! Bytes of a line: numbers, names, blanks.

/// A number as it is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Number {
    pub(crate) value: f64,
    /// A decimal point stands in it.
    pub(crate) point: bool,
    /// It begins with `-`.
    pub(crate) negative: bool,
}

/// A place in a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    line: &'a [u8],
    at: usize,
}

/// End of a line that goes on in the next one: no line holds it.
pub(super) const GOES_ON: u8 = b'\n';

/// Powers of ten that are exact.
const TENS: [f64; 20] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19];

/// More digits than this are no word of a program.
const MOST_DIGITS: usize = 18;

impl<'a> Cursor<'a> {
    pub(super) fn new(line: &'a [u8]) -> Self {
        Self { line, at: 0 }
    }

    pub(super) fn rest(&self) -> &'a [u8] {
        &self.line[self.at.min(self.line.len())..]
    }

    /// What has been taken from a column on.
    pub(super) fn read_from(&self, column: usize) -> &'a [u8] {
        &self.line[column..self.at]
    }

    /// Column that comes next, from 0.
    pub(super) fn column(&self) -> usize {
        self.at
    }

    /// Goes to a column.
    pub(super) fn go_to(&mut self, column: usize) {
        self.at = column;
    }

    /// Passes over some bytes.
    pub(super) fn skip(&mut self, count: usize) {
        self.at += count;
    }

    /// What comes before a column.
    pub(super) fn before(&self, column: usize) -> &'a [u8] {
        &self.line[..column.min(self.line.len())]
    }

    /// Goes to the end; what was left.
    pub(super) fn take_rest(&mut self) -> &'a [u8] {
        let rest = self.rest();
        self.at = self.line.len();
        rest
    }

    pub(super) fn peek(&self) -> Option<u8> {
        self.line.get(self.at).copied()
    }

    pub(super) fn blanks(&mut self) {
        while matches!(self.peek(), Some(b' ' | b'\t' | b'\r')) {
            self.at += 1;
        }
    }

    pub(super) fn ended(&mut self) -> bool {
        self.blanks();
        self.at >= self.line.len()
    }

    /// Takes a byte if it comes next.
    pub(super) fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
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
            self.at += word.len();
        }
        found
    }

    /// Takes a text if it comes next, whatever its case and the blanks between its bytes.
    pub(super) fn literal(&mut self, text: &[u8]) -> bool {
        let start = self.at;
        for wanted in text {
            self.blanks();
            if !self.peek().is_some_and(|byte| byte.eq_ignore_ascii_case(wanted)) {
                self.at = start;
                return false;
            }
            self.at += 1;
        }
        true
    }

    /// Takes words one after the other, each as [`word`](Self::word) does.
    pub(super) fn words(&mut self, words: &str) -> bool {
        let start = self.at;
        let found = words.split(' ').all(|word| self.word(word.as_bytes()));
        if !found {
            self.at = start;
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

    /// Takes a letter and the number behind it, blanks between them or not.
    pub(super) fn letter_and_number(&mut self) -> Option<(u8, Number)> {
        let letter = self.peek().filter(u8::is_ascii_alphabetic)?;
        self.at += 1;
        self.blanks();
        Some((letter, self.number()?))
    }

    /// Takes letters, digits and underscores.
    pub(super) fn name(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|byte| !byte.is_ascii_alphanumeric() && *byte != b'_').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    /// Takes letters only.
    pub(super) fn letters(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|byte| !byte.is_ascii_alphabetic()).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    /// Takes a number: sign, digits, a point; no exponent, at least one digit.
    #[inline]
    pub(super) fn number(&mut self) -> Option<Number> {
        let negative = self.line.get(self.at) == Some(&b'-');
        let first = self.at + usize::from(negative || self.line.get(self.at) == Some(&b'+'));
        let (whole, end) = self.digits(0, first);
        let point = self.line.get(end) == Some(&b'.');
        let (mantissa, end, decimals) = if point {
            let (mantissa, behind) = self.digits(whole, end + 1);
            (mantissa, behind, behind - end - 1)
        } else {
            (whole, end, 0)
        };
        let digits = end - first - usize::from(point);
        if digits == 0 || digits > MOST_DIGITS || self.line.get(end) == Some(&b'.') {
            return None;
        }
        self.at = end;
        let value = mantissa as f64 / TENS[decimals];
        Some(Number { value: if negative { -value } else { value }, point, negative })
    }

    /// Digits from a column on behind others, and the column after them; of too many the value has no meaning.
    #[inline]
    fn digits(&self, before: i64, column: usize) -> (i64, usize) {
        let (mut value, mut count) = (before, 0);
        for byte in self.line.get(column..).unwrap_or_default() {
            let digit = byte.wrapping_sub(b'0');
            if digit > 9 {
                break;
            }
            value = value.wrapping_mul(10).wrapping_add(i64::from(digit));
            count += 1;
        }
        (value, column + count)
    }
}

/// Numbers nearer than this are the same number: none is written with so many decimals.
const SAME_NUMBER: f64 = 1e-9;

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
    let exact = (number.value * 10.0 - tenths).abs() < 1e-6;
    (exact && !number.negative && tenths <= 100_000.0).then_some(tenths as u32)
}

/// Bytes as text for a message, where they stand between back quotes.
pub(super) fn shown(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(60)]).replace('`', "'")
}
