//! FN, labels and messages: a guard reads the length of the tool and jumps over a message and a stop.
//!
//! `FN 18: SYSREAD ..`, then `FN 12: IF +Q1 LT +0.01 GOTO LBL 5` once or more, `FN 14` or STOP, `LBL 5`.

use super::super::text::{Cursor, whole};

/// The label where the last jump of a guard leads, while that has not been reached; only messages stand before it.
#[derive(Debug, Default)]
pub(super) struct Jump {
    label: Option<Vec<u8>>,
}

impl Jump {
    /// Whether a jump leads over what stands here.
    pub(super) fn leads_on(&self) -> bool {
        self.label.is_some()
    }

    /// `FN 0` to `FN 5` and `FN 18` set parameters, `FN 9` to `FN 12` jump.
    pub(super) fn function(&mut self, at: &mut Cursor<'_>) -> bool {
        at.blanks();
        match at.number().and_then(whole) {
            Some(0..=5 | 18) => true,
            Some(9..=12) => self.begin(at),
            _ => false,
        }
    }

    /// `.. GOTO LBL 5`, `.. GOTO LBL "FITS1"`.
    fn begin(&mut self, at: &mut Cursor<'_>) -> bool {
        let rest = at.rest();
        let Some(label) = rest.windows(4).rposition(|word| word == b"LBL ") else { return false };
        self.label = Some(rest[label + 4..].trim_ascii().to_vec());
        at.take_rest();
        true
    }

    /// What a guard jumps over: other jumps, labels, messages and a stop.
    pub(super) fn over(&mut self, at: &mut Cursor<'_>) -> bool {
        if at.word(b"LBL") {
            if self.label.as_deref() == Some(at.rest().trim_ascii()) {
                self.label = None;
            }
            return true;
        }
        if at.word(b"FN") {
            at.blanks();
            return match at.number().and_then(whole) {
                Some(9..=12) => self.begin(at),
                Some(14) => true,
                _ => false,
            };
        }
        at.word(b"STOP")
    }
}
