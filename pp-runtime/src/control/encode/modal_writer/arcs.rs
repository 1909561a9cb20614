//! Arcs and helices.

use std::io;

use crate::control::dialects::ArcCentre;
use crate::control::encode::modal_state::After;
use crate::motion::{AxisWords, Circle};
use crate::nc::Decimal;

use super::{AxisAddress, ModalWriter};

/// Decimals of the angle of a helix in degrees. At 10 m from its axis the last one is 0.2 µm.
const POLAR_DECIMALS: u32 = 6;

/// Arc angle from which start and end are so close that the exact start must be known, rad.
const NEARLY_WHOLE: f64 = 1.9 * std::f64::consts::PI;

impl ModalWriter<'_> {
    /// Writes the code of the plane of an arc, unless it is in force.
    fn plane(&mut self, code: &'static str) {
        if self.writes(self.modal.plane() != Some(code)) {
            self.writer.code(code);
        }
        self.modal.set_plane(Some(code));
    }

    /// Writes the plane perpendicular to Z in its own block, if another one is in force: a length offset may apply
    /// along the normal of the plane.
    pub(crate) fn select_xy_plane(&mut self) -> io::Result<()> {
        let usual = self.codes.arcs.planes[2].unwrap_or_default();
        if self.modal.plane().is_none_or(|plane| plane == usual) {
            return Ok(());
        }
        self.plane(usual);
        self.end()
    }

    /// Writes an arc or a helix at feed.
    pub(crate) fn arc(&mut self, words: &AxisWords, circle: &Circle, feed: Decimal) -> io::Result<()> {
        self.smooth(true)?;
        self.call_length_alone(words)?;
        self.feed_mode(self.codes.per_minute);
        match self.codes.arcs.centre {
            ArcCentre::Offsets => self.arc_with_offsets(words, circle),
            ArcCentre::Pole => self.arc_about_pole(words, circle)?,
        }
        self.compensation_after_words(false);
        self.changed_feed(feed);
        self.end()
    }

    /// Writes `G17 G2 X Y Z I J`.
    fn arc_with_offsets(&mut self, words: &AxisWords, circle: &Circle) {
        let arcs = &self.codes.arcs;
        let [first, second, normal] = circle.plane.axes();
        self.forget_plane(circle);
        self.plane(arcs.planes[normal].unwrap_or_default());
        self.motion(arcs.senses[usize::from(!circle.clockwise)]);
        self.axis_words(words, false);
        if let Some(units) = circle.radius {
            let decimals = self.decimals(circle.chain[first]);
            self.word(arcs.radius, Decimal { units, decimals });
            return;
        }
        let word = |axis: usize, place: usize| (&self.centre_words[axis], circle.centre[place] - circle.start[place]);
        let offsets = [word(first, 0), word(second, 1)];
        self.writer.words(if first < second { offsets } else { [offsets[1], offsets[0]] });
    }

    /// Makes the block of an arc write both words of its plane: controls differ in the meaning of one that is left out.
    fn forget_plane(&mut self, circle: &Circle) {
        let [first, second, _] = circle.plane.axes();
        self.modal.forget_axis(circle.chain[first]);
        self.modal.forget_axis(circle.chain[second]);
    }

    /// `CC X Y`, and `C X Y DR+`, `CR X Y R DR+` or `CP IPA IZ DR+`.
    fn arc_about_pole(&mut self, words: &AxisWords, circle: &Circle) -> io::Result<()> {
        let arcs = &self.codes.arcs;
        let [first, second, normal] = circle.plane.axes().map(|axis| circle.chain[axis]);
        // Whether the words in force are those of the start of the arc. After a helix, whose end is an angle, they are
        // so only up to rounding, and a full circle by `C` might then be none at all.
        let known = self.modal.is_axis(first, circle.start[0]) && self.modal.is_axis(second, circle.start[1]);
        self.forget_plane(circle);
        let decimals = self.decimals(first);
        let sense = arcs.senses[usize::from(!circle.clockwise)];
        self.modal.forget(After::OwnMotion);
        if let Some(units) = circle.radius.filter(|_| circle.rise == 0) {
            self.writer.code("CR");
            self.axis_words(words, false);
            self.word(arcs.radius, Decimal { units, decimals });
            self.writer.code(sense);
            return Ok(());
        }
        self.writer.code("CC");
        for (axis, units) in [first, second].into_iter().zip(circle.centre) {
            let word = word_of(&self.axes, axis);
            self.writer.word(word, Decimal { units, decimals }, self.numerals);
        }
        self.end()?;
        if circle.rise == 0 && (known || circle.sweep_rad < NEARLY_WHOLE) {
            self.writer.code("C");
            self.axis_words(words, false);
        } else {
            self.writer.code("CP");
            let degrees = if circle.clockwise { -circle.sweep_rad } else { circle.sweep_rad }.to_degrees();
            // An angle of at most one revolution fits into six decimals.
            let angle = Decimal::fixed(degrees, POLAR_DECIMALS).unwrap_or_default();
            self.word("IPA", angle);
            if circle.rise != 0 {
                let word = format!("I{}", word_of(&self.axes, normal));
                let rise = Decimal { units: circle.rise, decimals: self.decimals(normal) };
                self.word(&word, rise);
                self.modal.set_axis(normal, words.units[normal]);
            }
        }
        self.writer.code(sense);
        Ok(())
    }
}

/// Letters before the number in words of an axis.
fn word_of(axes: &[AxisAddress], index: usize) -> &str {
    axes.iter().find(|address| address.index == index).map_or("", |address| address.word.letters())
}
