//! Straight motions: rapids and feed blocks. Length offset and cutter compensation take
//! effect in a motion and are written here too.

use std::io;

use crate::control::dialects::LengthCall;
use crate::motion::{AxisWords, FeedWord};

use super::ModalWriter;
use crate::control::encode::modal_state::LengthState;

impl ModalWriter<'_> {
    /// Writes a straight motion at feed, unless no axis word changes.
    pub(crate) fn feed(&mut self, words: &AxisWords, feed: FeedWord) -> io::Result<()> {
        let changed = self.modal.changed_axes(words);
        if !self.changes_with(words, changed) {
            return Ok(());
        }
        self.smooth(true)?;
        // The call of a length offset may make a word unknown.
        let pending = self.has_pending_length();
        self.call_length_alone(words)?;
        match feed {
            FeedWord::PerMinute(_) => self.feed_mode(self.codes.per_minute),
            FeedWord::InverseTime(_) => self.feed_mode(self.codes.inverse_time.unwrap_or_default()),
        }
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.feed, |(code, _)| code));
        self.call_length(words)?;
        self.compensation_before_words();
        self.words_of(words, if pending { self.modal.changed_axes(words) } else { changed });
        self.compensation_after_words(along.is_some());
        match feed {
            FeedWord::PerMinute(value) => self.changed_feed(value),
            FeedWord::InverseTime(value) => {
                self.feed_word(value);
                self.modal.forget_feed();
            }
        }
        self.end()
    }

    /// Writes a rapid, unless no axis word changes.
    pub(crate) fn rapid(&mut self, words: &AxisWords) -> io::Result<()> {
        if !self.any_changes(words) {
            return Ok(());
        }
        if self.tip.offset_lost && self.axes.iter().any(|axis| axis.linear && words.has(axis.index)) {
            self.restate_offset()?;
        }
        self.call_length_alone(words)?;
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.rapid, |(code, _)| code));
        self.call_length(words)?;
        self.axis_words(words, false);
        self.writer.code(along.map_or(self.codes.rapid_end, |(_, end)| end));
        self.end()
    }

    /// Codes of a motion that writes a tool axis vector: motion code, and end of a rapid; `None` if the usual ones
    /// apply.
    fn along_vector(&self, words: &AxisWords) -> Option<(&'static str, &'static str)> {
        let vectors = self.vectors.filter(|_| self.writes(self.modal.vector_changes(words.vector)))?;
        vectors.motion.map(|code| (code, vectors.rapid_end))
    }

    /// Calls a pending length offset in its own block, for controls that call it so.
    pub(crate) fn call_length_alone(&mut self, words: &AxisWords) -> io::Result<()> {
        match self.codes.length.call {
            LengthCall::Alone => self.call_length(words),
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// Calls a pending length offset, in a block before a motion or in the motion.
    fn call_length(&mut self, words: &AxisWords) -> io::Result<()> {
        let LengthState::Pending(register) = self.modal.length() else { return Ok(()) };
        match self.codes.length.call {
            LengthCall::Alone => {
                self.modal.set_length(LengthState::On(register));
                self.fill(self.codes.length.code)
            }
            LengthCall::WithZ if self.z.is_none_or(|z| words.has(z)) => {
                self.modal.set_length(LengthState::On(register));
                if let Some(z) = self.z {
                    self.modal.forget_axis(z);
                }
                self.code(self.tip.length_code.filter(|_| self.tip.is_on).unwrap_or(self.codes.length.code));
                Ok(())
            }
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// Calls a pending length offset at once, in its own block.
    pub(crate) fn call_length_now(&mut self) -> io::Result<()> {
        let LengthState::Pending(register) = self.modal.length() else { return Ok(()) };
        self.modal.set_length(LengthState::On(register));
        self.fill(self.codes.length.code)
    }

    /// Sets the length offset of the motions that follow.
    pub(crate) fn length(&mut self, register: u32) -> io::Result<()> {
        self.values.offset = Some(register);
        match self.codes.length.call {
            LengthCall::WithTool => Ok(()),
            LengthCall::WithZ => {
                self.modal.set_length(LengthState::Pending(register));
                Ok(())
            }
            LengthCall::Alone => {
                self.modal.set_length(LengthState::Pending(register));
                self.call_length_now()
            }
        }
    }

    /// Sets cutter compensation from the next feed block on: true for left, false for right, `None` for off.
    pub(crate) fn set_compensation_side(&mut self, side: Option<bool>, register: u32) {
        self.side = side;
        self.values.radius = Some(register);
    }

    /// Writes cutter compensation, where it comes before the axis words.
    fn compensation_before_words(&mut self) {
        if self.codes.no_compensation.is_empty() {
            self.changed_compensation();
        }
    }

    fn changed_compensation(&mut self) {
        if self.modal.side() != self.side {
            let index = self.side.map_or(2, |left| usize::from(!left));
            self.code(self.codes.compensation[index]);
            self.modal.set_side(self.side);
        }
    }

    /// Writes cutter compensation, where it comes after the axis words. `implied`: the motion code includes "off".
    pub(crate) fn compensation_after_words(&mut self, implied: bool) {
        if self.side.is_some() || self.modal.side().is_some() {
            return self.changed_compensation();
        }
        if !implied {
            if self.writes(!self.modal.has_no_compensation()) {
                self.writer.code(self.codes.no_compensation);
            }
            self.modal.set_no_compensation();
        }
    }
}
