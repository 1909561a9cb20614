//! Why the lines of a program are there, from the line map of a run that posts it.

use std::io;

use imara_diff::{Algorithm, Diff, Hunk, InternedInput};

use crate::post::{LineMap, LineOrigin};

/// Reason of a line that is not known: written by hand, or posted otherwise.
pub(crate) const UNKNOWN: u8 = u8::MAX;

/// Reasons by line.
#[derive(Debug, Default)]
pub(crate) struct Reasons {
    /// Names as in `post --map`, in the order of their first lines, and their sentences.
    pub(crate) names: Vec<&'static str>,
    pub(crate) texts: Vec<&'static str>,
    /// Index of the name for each line.
    lines: Vec<u8>,
}

impl LineMap for Reasons {
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()> {
        let name = origin.why.name();
        let index = self.names.iter().position(|known| *known == name).unwrap_or_else(|| {
            self.names.push(name);
            self.texts.push(origin.why.text());
            self.names.len() - 1
        });
        // Lines are mapped in order, all of them.
        self.lines.push(u8::try_from(index).unwrap_or(UNKNOWN));
        Ok(())
    }
}

impl Reasons {
    /// Index of the reason of a line, from 1.
    pub(crate) fn of(&self, line: u64) -> u8 {
        let index = usize::try_from(line).ok().and_then(|line| line.checked_sub(1));
        index.and_then(|index| self.lines.get(index)).copied().unwrap_or(UNKNOWN)
    }

    /// The reasons of the lines of another text that are equal to posted ones, in order.
    pub(crate) fn carried_over(self, posted: &[u8], given: &[u8]) -> Self {
        let mut input = InternedInput::default();
        input.update_before(lines(posted));
        input.update_after(lines(given));
        let mut reasons = vec![UNKNOWN; input.after.len()];
        let (mut posted_at, mut given_at) = (0, 0);
        let ends = (input.before.len() as u32, input.after.len() as u32);
        let end = Hunk { before: ends.0..ends.0, after: ends.1..ends.1 };
        for changed in Diff::compute(Algorithm::Histogram, &input).hunks().chain([end]) {
            for (reason, line) in reasons[given_at..changed.after.start as usize].iter_mut().zip(posted_at..) {
                *reason = self.lines.get(line).copied().unwrap_or(UNKNOWN);
            }
            (posted_at, given_at) = (changed.before.end as usize, changed.after.end as usize);
        }
        Self { lines: reasons, ..self }
    }
}

/// Lines of a program, without the blanks at their ends.
fn lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(|byte| *byte == b'\n').map(<[u8]>::trim_ascii_end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::BlockReason;

    fn posted(reasons: &[BlockReason]) -> Reasons {
        let mut map = Reasons::default();
        for (index, why) in reasons.iter().enumerate() {
            let origin = LineOrigin {
                line: index as u64 + 1,
                number: None,
                step: "feed",
                at: None,
                why: *why,
                position_after: None,
            };
            map.line(&origin).expect("memory");
        }
        map
    }

    #[test]
    fn lines_that_are_equal_keep_their_reasons_and_edited_ones_have_none() {
        use BlockReason::{Head, Record, Tolerance};
        let map = posted(&[Head, Record, Tolerance, Record]);
        assert_eq!(map.names, ["head", "record", "tolerance"]);
        assert_eq!([1, 2, 3, 4, 5].map(|line| map.of(line)), [0, 1, 2, 1, UNKNOWN]);
        // A line is changed, one is added, and line ends are those of another system.
        let edited = map.carried_over(b"(A)\nX1\nX2\nX3\n", b"(A)\r\nX1.5\r\nM1\r\nX2\r\nX3\r\n");
        assert_eq!([1, 2, 3, 4, 5].map(|line| edited.of(line)), [0, UNKNOWN, UNKNOWN, 2, 1]);
    }

    #[test]
    fn a_line_added_by_hand_that_occurs_later_as_well_takes_no_reasons_from_others() {
        use BlockReason::{Head, Record, Tolerance};
        let map = posted(&[Head, Record, Tolerance, Record, Head]);
        let edited = map.carried_over(b"(A)\nX1\nX2\nX3\nM9\n", b"(A)\nM9\nX1\nX2\nX3\nM9\n");
        assert_eq!([1, 2, 3, 4, 5, 6].map(|line| edited.of(line)), [0, UNKNOWN, 1, 2, 1, 0]);
    }

    #[test]
    fn a_line_without_a_number_has_no_reason() {
        assert_eq!(posted(&[BlockReason::Head]).of(0), UNKNOWN);
    }
}
