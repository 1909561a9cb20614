//! `[arcs]`: which arcs are left to the control, and in which words.

use super::Config;
use super::read::set;
use super::value::{Bound, Reader, Section};

/// What becomes of arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcOutput {
    /// Arcs of the control where it can say them within tolerance, else lines.
    Native,
    /// Lines.
    Lines,
}

/// What says where the centre is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ArcForm {
    /// The centre.
    Centre,
    /// The radius, except where it says nothing: whole turns, and close to half ones.
    Radius,
}

/// Arcs of the control.
#[derive(Debug, Clone, PartialEq)]
pub struct Arcs {
    /// What becomes of them; default [`ArcOutput::Native`].
    pub output: ArcOutput,
    /// What says where the centre is; default [`ArcForm::Centre`].
    pub form: ArcForm,
    /// Smaller ones become lines, mm; default 0.01.
    pub smallest_radius: f64,
    /// Larger ones become lines, mm; default 10 000.
    pub largest_radius: f64,
}

impl Default for Arcs {
    fn default() -> Self {
        Self { output: ArcOutput::Native, form: ArcForm::Centre, smallest_radius: 0.01, largest_radius: 10_000.0 }
    }
}

const OUTPUTS: [(&str, ArcOutput); 2] = [("native", ArcOutput::Native), ("lines", ArcOutput::Lines)];
const FORMS: [(&str, ArcForm); 2] = [("centre", ArcForm::Centre), ("radius", ArcForm::Radius)];

impl Config {
    pub(super) fn read_arcs(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "arcs.output") {
            set(&mut self.arcs.output, r.choice(value, &OUTPUTS));
        }
        if let Some(value) = self.get(section, "arcs.form") {
            set(&mut self.arcs.form, r.choice(value, &FORMS));
        }
        if let Some(value) = self.get(section, "arcs.smallest_radius") {
            set(&mut self.arcs.smallest_radius, r.length(value, Bound::Positive));
        }
        if let Some(value) = self.get(section, "arcs.largest_radius") {
            set(&mut self.arcs.largest_radius, r.length(value, Bound::Positive));
        }
    }
}
