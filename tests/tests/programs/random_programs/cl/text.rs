//! Points, directions and numbers as text of the file.

use std::fmt::Write as _;

use nalgebra::Vector3;

use super::Program;

impl Program<'_> {
    /// Writes a GOTO to the position of the tool.
    pub(super) fn go(&mut self) {
        let axis = self.frame.column(2).into_owned();
        let written = self.axis.is_none_or(|last| last != axis) || self.random.chance(0.1);
        self.axis = Some(axis);
        self.point("GOTO", self.here(), written.then_some(axis));
    }

    /// Writes the tool axis as a record of its own.
    pub(super) fn state_axis(&mut self) {
        let axis = self.frame.column(2).into_owned();
        let text = self.directions(axis);
        self.line(&format!("TLAXIS/{text}"));
        self.axis = Some(axis);
    }

    /// Position of the tool in the frame of the part, mm.
    pub(super) fn here(&self) -> Vector3<f64> {
        self.origin + self.frame * self.here
    }

    pub(super) fn point(&mut self, word: &str, tip: Vector3<f64>, axis: Option<Vector3<f64>>) {
        let tip = self.coordinates(tip);
        let axis = axis.map_or(String::new(), |axis| format!(",{}", self.directions(axis)));
        self.line(&format!("{word}/{tip}{axis}"));
    }

    /// Text of a point that is given in the frame of the part.
    pub(super) fn coordinates(&self, point: Vector3<f64>) -> String {
        self.numbers(self.file.point(point), 0)
    }

    /// Text of a direction that is given in the frame of the part.
    pub(super) fn directions(&self, direction: Vector3<f64>) -> String {
        self.digits(self.file.direction(direction), self.decimals[1])
    }

    /// Text of three lengths, mm, in the unit of the file, with `more` additional decimals.
    pub(super) fn numbers(&self, point: Vector3<f64>, more: usize) -> String {
        format!("{},{},{}", self.number(point.x, more), self.number(point.y, more), self.number(point.z, more))
    }

    pub(super) fn digits(&self, direction: Vector3<f64>, digits: usize) -> String {
        let [i, j, k] = [direction.x, direction.y, direction.z].map(|part| if part.abs() < 1e-12 { 0.0 } else { part });
        format!("{i:.digits$},{j:.digits$},{k:.digits$}")
    }

    pub(super) fn length(&self, mm: f64) -> String {
        self.number(mm, 0)
    }

    pub(super) fn number(&self, mm: f64, more: usize) -> String {
        let digits = self.decimals[0] + usize::from(self.needs.inches) + more;
        let value = if self.needs.inches { mm / 25.4 } else { mm };
        format!("{value:.digits$}")
    }

    pub(super) fn some_length(&mut self, lower: f64, upper: f64) -> String {
        let mm = self.random.between(lower, upper);
        self.length(mm)
    }

    pub(super) fn line(&mut self, text: &str) {
        let _ = writeln!(self.text, "{text}");
    }

    /// A random number of at most `most` to either side of zero.
    pub(super) fn plus_minus(&mut self, most: f64) -> f64 {
        let value = self.random.between(-most, most);
        // Round numbers are frequent in CL data.
        if self.random.chance(0.3) && most > 2.0 { value.round() } else { value }
    }

    /// Keeps the tool within 80 mm of the origin of the operation, across the tool axis.
    pub(super) fn bound(&mut self) {
        self.here.x = self.here.x.clamp(-80.0, 80.0);
        self.here.y = self.here.y.clamp(-80.0, 80.0);
    }
}
