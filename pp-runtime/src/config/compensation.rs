//! `[compensation]`: what CUTCOM asks of the control.

use super::Config;
use super::value::{Reader, Section};

/// What the CL data under CUTCOM is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CutterPath {
    /// The path of the tool's centre: the register holds wear.
    Centre,
    /// The contour: the register holds the radius.
    Contour,
}

const PATHS: [(&str, CutterPath); 2] = [("centre", CutterPath::Centre), ("contour", CutterPath::Contour)];

impl Config {
    pub(super) fn read_compensation(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "compensation.path") {
            self.compensation = r.choice(value, &PATHS);
        }
    }
}
