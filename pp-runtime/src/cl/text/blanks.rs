//! Blanks of CL text.

/// Whether a byte is a blank or a tab, or the Ctrl-Z with which DOS programs end a file.
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x1A)
}

/// Index of the first byte from `at` on that is not a blank.
pub(crate) fn skip_blanks(text: &[u8], mut at: usize) -> usize {
    while at < text.len() && is_blank(text[at]) {
        at += 1;
    }
    at
}
