//! Arcs and helices.

use std::io::{self, Write};

use crate::motion::{Circle, Words};
use crate::nc::Decimal;

use super::super::{ArcCentre, LengthCall};
use super::Encoder;

/// Decimals of the angle of a helix, degrees: at 10 m from its axis they are a hundredth of a word.
const POLAR_DECIMALS: u32 = 6;

/// From this angle on the ends of an arc lie so near each other that the start has to be known to the digit, rad.
const NEARLY_WHOLE: f64 = 1.9 * std::f64::consts::PI;

impl<W: Write> Encoder<'_, W> {
    /// A plane of arcs that is to be in force.
    pub(super) fn plane(&mut self, code: &'static str) {
        if self.writes(self.belief.plane != code) {
            self.writer.code(code);
        }
        self.belief.plane = code;
    }

    /// The usual plane, in a block of its own: a length offset may count along the axis square to another one.
    pub(super) fn usual_plane(&mut self) -> io::Result<()> {
        let usual = self.codes.arcs.planes[2].unwrap_or_default();
        if self.belief.plane == usual || self.belief.plane.is_empty() {
            return Ok(());
        }
        self.plane(usual);
        self.writer.end()
    }

    pub(super) fn arc(&mut self, words: &Words, circle: &Circle, feed: Decimal) -> io::Result<()> {
        self.smooth(true)?;
        if self.codes.length.call == LengthCall::Alone {
            self.call_length(words)?;
        }
        self.feed_mode(self.codes.per_minute);
        let [first, second, _] = circle.plane.axes().map(|axis| circle.chain[axis]);
        let known =
            !self.belief.axis_changes(first, circle.start[0]) && !self.belief.axis_changes(second, circle.start[1]);
        // Its words are complete: what is left out of an arc means something else on each control.
        for axis in &circle.plane.axes()[..2] {
            self.belief.forget_axis(circle.chain[*axis]);
        }
        match self.codes.arcs.centre {
            ArcCentre::Offsets => self.arc_with_offsets(words, circle),
            ArcCentre::Pole => self.arc_about_pole(words, circle, known)?,
        }
        self.centre_word(false);
        self.changed_feed(feed);
        self.writer.end()
    }

    /// `G17 G2 X Y Z I J`.
    pub(super) fn arc_with_offsets(&mut self, words: &Words, circle: &Circle) {
        let arcs = &self.codes.arcs;
        let [first, second, square] = circle.plane.axes();
        self.plane(arcs.planes[square].unwrap_or_default());
        self.motion(arcs.senses[usize::from(!circle.clockwise)]);
        self.axis_words(words, false);
        let decimals = self.decimals(circle.chain[first]);
        if let Some(units) = circle.radius {
            self.writer.word(arcs.radius, Decimal { units, decimals }, self.numerals);
            return;
        }
        let mut offsets = [(first, 0), (second, 1)];
        offsets.sort_unstable();
        for (axis, place) in offsets {
            let units = circle.centre[place] - circle.start[place];
            self.writer.word(["I", "J", "K"][axis], Decimal { units, decimals }, self.numerals);
        }
    }

    /// `CC X Y`, and `C X Y DR+`, `CR X Y R DR+` or `CP IPA IZ DR+`. `known`: the axes stand where the words of the arc say
    /// that it begins; behind a helix, whose end is an angle, they stand there but for rounding, and to `C` a whole turn
    /// from there might be no turn at all.
    pub(super) fn arc_about_pole(&mut self, words: &Words, circle: &Circle, known: bool) -> io::Result<()> {
        let arcs = &self.codes.arcs;
        let [first, second, square] = circle.plane.axes().map(|axis| circle.chain[axis]);
        let decimals = self.decimals(first);
        let sense = arcs.senses[usize::from(!circle.clockwise)];
        self.belief.motion = "";
        if let Some(units) = circle.radius.filter(|_| circle.rise == 0) {
            self.writer.code("CR");
            self.axis_words(words, false);
            self.writer.word(arcs.radius, Decimal { units, decimals }, self.numerals);
            self.writer.code(sense);
            return Ok(());
        }
        self.writer.code("CC");
        for (axis, units) in [first, second].into_iter().zip(circle.centre) {
            let word = self.axes.iter().find(|address| address.index == axis).map_or("", |address| &address.word);
            self.writer.word(word, Decimal { units, decimals }, self.numerals);
        }
        self.writer.end()?;
        if circle.rise == 0 && (known || circle.sweep < NEARLY_WHOLE) {
            self.writer.code("C");
            self.axis_words(words, false);
        } else {
            self.writer.code("CP");
            let degrees = if circle.clockwise { -circle.sweep } else { circle.sweep }.to_degrees();
            // At most a turn in six decimals.
            let angle = Decimal::fixed(degrees, POLAR_DECIMALS).unwrap_or_default();
            self.writer.word("IPA", angle, self.numerals);
            if circle.rise != 0 {
                let word = self.axes.iter().find(|address| address.index == square).map_or("", |address| &address.word);
                let rise = Decimal { units: circle.rise, decimals: self.decimals(square) };
                self.writer.word(&format!("I{word}"), rise, self.numerals);
                self.belief.set_axis(square, words.units[square]);
            }
        }
        self.writer.code(sense);
        Ok(())
    }
}
