//! `[cycles]`: whether holes are left to the cycles of the control.

use super::read::set;
use super::value::{Reader, Section};
use super::{Config, CycleOutput};

const OUTPUTS: [(&str, CycleOutput); 2] = [("native", CycleOutput::Native), ("expanded", CycleOutput::Expanded)];

impl Config {
    pub(super) fn read_cycles(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "cycles.output") {
            set(&mut self.motion.cycles.output, r.choice(value, &OUTPUTS));
        }
        if let Some(value) = self.get(section, "cycles.rigid") {
            set(&mut self.motion.cycles.rigid, r.boolean(value));
        }
    }
}
