//! Encoding of texts: UTF-8, else Latin-1.
//!
//! CAM systems write comments and names in UTF-8 or in the code page of the computer. A text in which bytes above ASCII
//! happen to be UTF-8 is one; the code pages of Western Europe are Latin-1 in all letters.

use std::borrow::Cow;

/// A text of the file.
pub(crate) fn decoded(text: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(text) {
        Ok(text) => text.into(),
        Err(_) => text.iter().map(|byte| char::from(*byte)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::decoded;

    #[test]
    fn a_text_is_utf_8_else_latin_1() {
        assert_eq!(decoded("FRÄSEN Ж".as_bytes()), "FRÄSEN Ж");
        assert_eq!(decoded(b"FR\xC4SEN"), "FRÄSEN");
        assert_eq!(decoded(b""), "");
    }
}
