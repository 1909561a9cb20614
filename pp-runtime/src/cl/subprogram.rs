//! Subprograms (DEFSUB, ENDSUB, CALSUB): statements are stored between DEFSUB and ENDSUB, and interpreted at each
//! CALSUB.
//!
//! A definition alone has no effect. Each statement is stored as text with its place in the file, so that a fault in it
//! names its own line. The stored text is bounded.

use std::collections::BTreeMap;

use super::record::SubprogramName;
use super::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::program::Location;

/// Largest size, in bytes, of the text of all subprograms of a file, and of the list of their statements.
const MOST_BYTES: usize = 8 << 20;

/// Largest number of subprograms in a file; it bounds the memory. No CAM system writes as many.
const MOST_SUBPROGRAMS: usize = 100_000;

/// One statement of a subprogram.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KeptStatement {
    start: usize,
    end: usize,
    location: Location,
}

impl KeptStatement {
    pub(crate) fn location(&self) -> Location {
        self.location
    }
}

/// Range of a subprogram in the list of statements; `after` is one past its last.
#[derive(Debug, Clone, Copy)]
struct Subprogram {
    first: usize,
    after: usize,
}

/// All subprograms of a file.
#[derive(Debug, Default)]
pub(crate) struct Subprograms {
    text: Vec<u8>,
    statements: Vec<KeptStatement>,
    known: BTreeMap<SubprogramName, Subprogram>,
    /// Name and first statement of the subprogram between its DEFSUB and ENDSUB.
    open: Option<(SubprogramName, usize)>,
    /// Next statement, and one past the last, of the subprogram that is being run.
    running: Option<(usize, usize)>,
    /// First call, and number of calls.
    calls: Option<(Location, u64)>,
}

impl Subprograms {
    pub(crate) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    pub(crate) fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// DEFSUB; refused inside another subprogram, for a name in use, and beyond [`MOST_SUBPROGRAMS`].
    pub(crate) fn define(&mut self, name: SubprogramName) -> Result<(), ClFault> {
        if self.open.is_some() || self.running.is_some() {
            let why = "DEFSUB inside a subprogram is not supported";
            return Err(fault(Span::WHOLE, why, "write ENDSUB before it: a subprogram is defined outside all others"));
        }
        // A refused DEFSUB still has its ENDSUB.
        self.open = Some((name, self.statements.len()));
        if self.known.contains_key(&name) {
            let why = "this subprogram is already defined";
            return Err(fault(Span::WHOLE, why, "give it another name, here and in each CALSUB that is meant for it"));
        }
        if self.known.len() >= MOST_SUBPROGRAMS {
            return Err(fault(Span::WHOLE, "the file defines too many subprograms", SPLIT));
        }
        Ok(())
    }

    /// Stores a statement; refused beyond [`MOST_BYTES`].
    pub(crate) fn keep(&mut self, text: &[u8], location: Location) -> Result<(), ClFault> {
        if self.text.len() + text.len() > MOST_BYTES || self.statements.len() * size_of::<KeptStatement>() > MOST_BYTES
        {
            return Err(fault(Span::WHOLE, "the subprograms of this file are too long", SPLIT));
        }
        let start = self.text.len();
        self.text.extend_from_slice(text);
        self.statements.push(KeptStatement { start, end: self.text.len(), location });
        Ok(())
    }

    /// ENDSUB; refused without a DEFSUB.
    pub(crate) fn end(&mut self) -> Result<(), ClFault> {
        let Some((name, first)) = self.open.take() else {
            let help = "write DEFSUB/name before the first record of the subprogram, or delete this ENDSUB";
            return Err(fault(Span::WHOLE, "ENDSUB without DEFSUB", help));
        };
        if self.known.len() < MOST_SUBPROGRAMS {
            self.known.entry(name).or_insert(Subprogram { first, after: self.statements.len() });
        }
        Ok(())
    }

    /// First CALSUB, and how many there were; `None` without one.
    pub(crate) fn calls(&self) -> Option<(Location, u64)> {
        self.calls
    }

    /// CALSUB; refused inside a subprogram and for a name that is not defined.
    pub(crate) fn call(&mut self, name: SubprogramName, at: Span, here: Location) -> Result<(), ClFault> {
        if self.running.is_some() {
            return Err(call_inside(at));
        }
        let known = self.known.get(&name);
        let known = known.ok_or_else(|| {
            let help = "write DEFSUB/name, the records of the subprogram and ENDSUB before CALSUB/name";
            fault(at, "no DEFSUB with this name comes before the call", help)
        })?;
        self.running = Some((known.first, known.after));
        self.calls.get_or_insert((here, 0)).1 += 1;
        Ok(())
    }

    /// Next statement of the subprogram that is being run; `None` after its last.
    pub(crate) fn next(&mut self) -> Option<KeptStatement> {
        let (at, after) = self.running?;
        if at == after {
            self.running = None;
            return None;
        }
        self.running = Some((at + 1, after));
        Some(self.statements[at])
    }

    pub(crate) fn text(&self, kept: &KeptStatement) -> &[u8] {
        &self.text[kept.start..kept.end]
    }
}

/// Remedy of a file with too many or too long subprograms.
const SPLIT: &str = "post the operations of this file as several files";

/// Fault of a CALSUB in a subprogram.
pub(crate) fn call_inside(at: Span) -> ClFault {
    let why = "CALSUB inside a subprogram is not supported";
    fault(at, why, "write the records of the other subprogram in place of this CALSUB")
}

/// Fault of a subprogram that does not end.
pub(crate) fn unfinished() -> ClFault {
    let why = "the file ends before the ENDSUB of a subprogram";
    fault(Span::WHOLE, why, "write ENDSUB after the last record of the subprogram")
}

fn fault(at: Span, why: &str, help: &str) -> ClFault {
    cl::SUBPROGRAM.cl_fault("subprogram", at, why, help)
}
