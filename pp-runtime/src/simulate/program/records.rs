//! CL records of lines of the program that matter, found while it is executed again.

use std::collections::BTreeMap;

use super::machining::places;
use crate::check::ExecutedBlock;
use crate::view::{ExecutedMotion, ExecutedPlace, Motions};

/// Record of a line of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LineRecord {
    pub(crate) cl_line: u64,
    pub(crate) operation: u64,
    pub(crate) tool: u32,
}

/// The records of some lines, found while the program is executed again.
#[derive(Debug, Clone, Default)]
pub(crate) struct LineRecords {
    records: BTreeMap<u64, Option<LineRecord>>,
}

impl LineRecords {
    pub(crate) fn of(lines: impl Iterator<Item = u32>) -> Self {
        Self { records: lines.map(|line| (u64::from(line), None)).collect() }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    pub(crate) fn get(&self, line: u32) -> Option<LineRecord> {
        self.records.get(&u64::from(line)).copied().flatten()
    }
}

impl Motions for LineRecords {
    fn motion(&mut self, motion: &ExecutedMotion<'_>) -> ExecutedPlace {
        let ExecutedBlock { block, record, operation, .. } = motion.executed;
        if let Some(found @ None) = self.records.get_mut(&block.line) {
            *found = Some(LineRecord { cl_line: record.line, operation: *operation, tool: motion.tool() });
        }
        places(motion).last().map_or(motion.start, |(_, place)| *place)
    }

    fn unknown(&mut self) {}
}
