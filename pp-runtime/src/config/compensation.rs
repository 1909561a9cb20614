//! `[compensation]`: what CUTCOM asks of the control.

use super::value::{Reader, Section};
use super::{Config, CutterPath};

const PATHS: [(&str, CutterPath); 2] = [("centre", CutterPath::Centre), ("contour", CutterPath::Contour)];

impl Config {
    pub(super) fn read_compensation(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "compensation.path") {
            self.motion.compensation = r.choice(value, &PATHS);
        }
    }
}
