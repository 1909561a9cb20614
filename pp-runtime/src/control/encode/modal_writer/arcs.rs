//! Arcs and helices.

use std::io::{self, Write};

use crate::control::dialects::ArcCentre;
use crate::control::encode::modal_state::After;
use crate::motion::{AxisWords, Circle};
use crate::nc::Decimal;

use super::{Address, ModalWriter};

/// Decimals of the angle of a helix, degrees: at 10 m from its axis they are a hundredth of a word.
const POLAR_DECIMALS: u32 = 6;

/// From this angle on the ends of an arc are so near each other that its start has to be known to the digit, rad.
const NEARLY_WHOLE: f64 = 1.9 * std::f64::consts::PI;

impl<W: Write> ModalWriter<W> {
    /// The plane of the arc that follows.
    fn plane(&mut self, code: &'static str) {
        if self.writes(self.modal.plane() != Some(code)) {
            self.writer.code(code);
        }
        self.modal.set_plane(Some(code));
    }

    /// The plane perpendicular to Z, in a block of its own: a length offset may count along the normal of another one.
    pub(crate) fn usual_plane(&mut self) -> io::Result<()> {
        let usual = self.codes.arcs.planes[2].unwrap_or_default();
        if self.modal.plane().is_none_or(|plane| plane == usual) {
            return Ok(());
        }
        self.plane(usual);
        self.end()
    }

    /// An arc or a helix at feed.
    pub(crate) fn arc(&mut self, words: &AxisWords, circle: &Circle, feed: Decimal) -> io::Result<()> {
        self.smooth(true)?;
        self.call_length_alone(words)?;
        self.feed_mode(self.codes.per_minute);
        let [first, second, _] = circle.plane.axes().map(|axis| circle.chain[axis]);
        let known =
            !self.modal.axis_changes(first, circle.start[0]) && !self.modal.axis_changes(second, circle.start[1]);
        // The words of its plane are complete: one that is left out means something else on each control.
        for axis in &circle.plane.axes()[..2] {
            self.modal.forget_axis(circle.chain[*axis]);
        }
        match self.codes.arcs.centre {
            ArcCentre::Offsets => self.arc_with_offsets(words, circle),
            ArcCentre::Pole => self.arc_about_pole(words, circle, known)?,
        }
        self.side_after_words(false);
        self.changed_feed(feed);
        self.end()
    }

    /// `G17 G2 X Y Z I J`.
    fn arc_with_offsets(&mut self, words: &AxisWords, circle: &Circle) {
        let arcs = &self.codes.arcs;
        let [first, second, normal] = circle.plane.axes();
        self.plane(arcs.planes[normal].unwrap_or_default());
        self.motion(arcs.senses[usize::from(!circle.clockwise)]);
        self.axis_words(words, false);
        let decimals = self.decimals(circle.chain[first]);
        if let Some(units) = circle.radius {
            self.word(arcs.radius, Decimal { units, decimals });
            return;
        }
        let mut offsets = [(first, 0), (second, 1)];
        offsets.sort_unstable();
        for (axis, place) in offsets {
            let units = circle.centre[place] - circle.start[place];
            self.word(["I", "J", "K"][axis], Decimal { units, decimals });
        }
    }

    /// `CC X Y`, and `C X Y DR+`, `CR X Y R DR+` or `CP IPA IZ DR+`. `known`: the words in force are those of the start of
    /// the arc. After a helix, whose end is an angle, they are so only up to rounding, and a full circle by `C` might then
    /// be none at all.
    fn arc_about_pole(&mut self, words: &AxisWords, circle: &Circle, known: bool) -> io::Result<()> {
        let arcs = &self.codes.arcs;
        let [first, second, normal] = circle.plane.axes().map(|axis| circle.chain[axis]);
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
        if circle.rise == 0 && (known || circle.sweep < NEARLY_WHOLE) {
            self.writer.code("C");
            self.axis_words(words, false);
        } else {
            self.writer.code("CP");
            let degrees = if circle.clockwise { -circle.sweep } else { circle.sweep }.to_degrees();
            // At most one revolution, in six decimals.
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

/// The letters before the number of an axis.
fn word_of(axes: &[Address], index: usize) -> &str {
    axes.iter().find(|address| address.index == index).map_or("", |address| &address.word)
}
