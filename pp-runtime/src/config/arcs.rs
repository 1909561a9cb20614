//! `[arcs]`: which arcs are left to the control, and in which words.

use super::read::set;
use super::value::{Bound, Reader, Section};
use super::{ArcForm, ArcOutput, Config};

const OUTPUTS: [(&str, ArcOutput); 2] = [("native", ArcOutput::Native), ("lines", ArcOutput::Lines)];
const FORMS: [(&str, ArcForm); 2] = [("centre", ArcForm::Centre), ("radius", ArcForm::Radius)];

impl Config {
    pub(super) fn read_arcs(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "arcs.output") {
            set(&mut self.motion.arcs.output, r.choice(value, &OUTPUTS));
        }
        if let Some(value) = self.get(section, "arcs.form") {
            set(&mut self.motion.arcs.form, r.choice(value, &FORMS));
        }
        if let Some(value) = self.get(section, "arcs.smallest_radius") {
            set(&mut self.motion.arcs.smallest_radius, r.length(value, Bound::Positive));
        }
        if let Some(value) = self.get(section, "arcs.largest_radius") {
            set(&mut self.motion.arcs.largest_radius, r.length(value, Bound::Positive));
        }
    }
}
