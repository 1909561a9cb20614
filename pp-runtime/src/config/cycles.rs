//! `[cycles]`: whether holes are left to the cycles of the control.

use super::Config;
use super::read::set;
use super::value::{Reader, Section};

/// What becomes of holes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleOutput {
    /// Cycles of the control where they mean the same, else single motions.
    Native,
    /// Single motions.
    Expanded,
}

/// Cycles of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycles {
    /// What becomes of holes; default [`CycleOutput::Native`].
    pub output: CycleOutput,
    /// Threads are cut with the spindle under control of its angle, where that has a code; default true.
    pub rigid: bool,
}

impl Default for Cycles {
    fn default() -> Self {
        Self { output: CycleOutput::Native, rigid: true }
    }
}

const OUTPUTS: [(&str, CycleOutput); 2] = [("native", CycleOutput::Native), ("expanded", CycleOutput::Expanded)];

impl Config {
    pub(super) fn read_cycles(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "cycles.output") {
            set(&mut self.cycles.output, r.choice(value, &OUTPUTS));
        }
        if let Some(value) = self.get(section, "cycles.rigid") {
            set(&mut self.cycles.rigid, r.boolean(value));
        }
    }
}
