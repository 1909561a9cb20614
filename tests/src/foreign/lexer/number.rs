//! Numbers as they are written.

/// A number of a word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// Value.
    pub value: f64,
    /// It has a decimal point.
    pub point: bool,
}

impl Number {
    /// The number at the beginning of a text, and the rest of it. A sign, digits, one point; no exponent.
    pub(in crate::foreign) fn take(text: &str) -> Option<(Self, &str)> {
        let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
        let sign = text.len() - unsigned.len();
        let length = unsigned.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count();
        let (digits, rest) = unsigned.split_at(length);
        let points = digits.matches('.').count();
        if points > 1 || digits.len() == points {
            return None;
        }
        let value = text[..sign + length].trim_start_matches('+').parse().ok()?;
        Some((Self { value, point: points == 1 }, rest))
    }
}
