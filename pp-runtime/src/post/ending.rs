//! End of a program: the end code and the lines after it. Comments about the check come before them once it is done.

use std::io::{self, Write};

use crate::control::Control;

/// Form of the end of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ProgramEnd {
    /// Lines from the end code to the end of the program.
    pub(crate) lines: usize,
    /// Every line begins with its line number, which goes up by one (Heidenhain).
    pub(crate) counted: bool,
}

impl ProgramEnd {
    /// That of the programs of a control.
    pub(crate) fn of(control: &dyn Control) -> Self {
        let codes = control.spellings();
        Self { lines: 1 + codes.closing.len(), counted: codes.numbers_every_line }
    }

    /// Byte at which the end of a text begins.
    pub(crate) fn position(self, text: &[u8]) -> usize {
        let body = text.len() - usize::from(text.last() == Some(&b'\n'));
        memchr::memrchr_iter(b'\n', &text[..body]).nth(self.lines - 1).map_or(0, |end| end + 1)
    }

    /// Writes a text with comments before its end.
    ///
    /// # Errors
    /// Those of the output.
    pub(crate) fn write_with(self, out: &mut dyn Write, text: &[u8], comments: &[Vec<u8>]) -> io::Result<()> {
        let (body, end) = text.split_at(self.position(text));
        out.write_all(body)?;
        let mut number = if self.counted { split_line_number(end).map(|(number, _)| number) } else { None };
        for comment in comments {
            write_line(out, number, comment)?;
            number = number.map(|number| number + 1);
        }
        for line in end.split_inclusive(|byte| *byte == b'\n') {
            let line = line.strip_suffix(b"\n").unwrap_or(line);
            match (number, split_line_number(line)) {
                (Some(now), Some((_, text))) => {
                    write_line(out, number, text)?;
                    number = Some(now + 1);
                }
                _ => write_line(out, None, line)?,
            }
        }
        Ok(())
    }
}

/// Writes a line, with its line number if it has one.
fn write_line(out: &mut dyn Write, number: Option<u64>, text: &[u8]) -> io::Result<()> {
    if let Some(number) = number {
        write!(out, "{number} ")?;
    }
    out.write_all(text)?;
    out.write_all(b"\n")
}

/// Line number at the start of a line, and the text after it.
fn split_line_number(line: &[u8]) -> Option<(u64, &[u8])> {
    let blank = line.iter().position(|byte| *byte == b' ')?;
    let number = str::from_utf8(&line[..blank]).ok()?.parse().ok()?;
    Some((number, &line[blank + 1..]))
}
