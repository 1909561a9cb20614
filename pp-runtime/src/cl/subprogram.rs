//! DEFSUB, ENDSUB, CALSUB: statements that are kept as they are defined, and done where they are called.
//!
//! A definition does nothing by itself. The text of every statement is kept with its place, up to a bound, so that a
//! fault in it still names its own line.

use crate::program::Location;
use std::collections::BTreeMap;

/// Bytes of text that all subprograms of a file may hold together, and bytes of the list of their statements.
const MOST_BYTES: usize = 8 << 20;

/// More subprograms than this are no habit of a CAM system; it bounds the memory.
const MOST_SUBPROGRAMS: usize = 100_000;

/// One statement of a subprogram.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kept {
    start: usize,
    end: usize,
    pub(super) location: Location,
}

/// Range in the list of statements.
#[derive(Debug, Clone, Copy)]
struct Subprogram {
    first: usize,
    behind: usize,
}

/// All subprograms of a file.
#[derive(Debug, Default)]
pub(super) struct Subprograms {
    text: Vec<u8>,
    statements: Vec<Kept>,
    known: BTreeMap<u32, Subprogram>,
    /// The one that is being defined.
    open: Option<(u32, usize)>,
    /// What is still to be done of the one that is called: next statement and the one behind its last.
    running: Option<(usize, usize)>,
}

impl Subprograms {
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub(super) fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// DEFSUB; an error if it cannot be defined here.
    pub(super) fn define(&mut self, number: u32) -> Result<(), &'static str> {
        if self.open.is_some() || self.running.is_some() {
            return Err("a subprogram cannot be defined inside another one");
        }
        // Its ENDSUB belongs to it, even if it is refused.
        self.open = Some((number, self.statements.len()));
        if self.known.contains_key(&number) {
            return Err("this subprogram is defined twice");
        }
        if self.known.len() >= MOST_SUBPROGRAMS { Err("the file defines too many subprograms") } else { Ok(()) }
    }

    /// Keeps a statement; false if there is no room for it.
    pub(super) fn keep(&mut self, text: &[u8], location: Location) -> bool {
        if self.text.len() + text.len() > MOST_BYTES || self.statements.len() * size_of::<Kept>() > MOST_BYTES {
            return false;
        }
        let start = self.text.len();
        self.text.extend_from_slice(text);
        self.statements.push(Kept { start, end: self.text.len(), location });
        true
    }

    /// ENDSUB; false if nothing was begun.
    pub(super) fn end(&mut self) -> bool {
        let Some((number, first)) = self.open.take() else { return false };
        if self.known.len() < MOST_SUBPROGRAMS {
            self.known.entry(number).or_insert(Subprogram { first, behind: self.statements.len() });
        }
        true
    }

    /// CALSUB; an error if it cannot be called here.
    pub(super) fn call(&mut self, number: u32) -> Result<(), &'static str> {
        if self.running.is_some() {
            return Err("a subprogram that calls another one is not understood");
        }
        let known = self.known.get(&number).ok_or("this subprogram is not defined before it is called")?;
        self.running = Some((known.first, known.behind));
        Ok(())
    }

    /// The next statement of the subprogram that is called.
    pub(super) fn next(&mut self) -> Option<Kept> {
        let (at, behind) = self.running?;
        if at == behind {
            self.running = None;
            return None;
        }
        self.running = Some((at + 1, behind));
        Some(self.statements[at])
    }

    pub(super) fn text(&self, kept: &Kept) -> &[u8] {
        &self.text[kept.start..kept.end]
    }
}
