//! Straight motions: rapids, feed blocks, rapids in machine coordinates; with them the length offset and the side of the
//! cutter, which take effect in a motion.

use std::io::{self, Write};

use crate::control::dialects::LengthCall;
use crate::motion::{AxisWords, FeedWord};

use super::ModalWriter;
use crate::control::encode::modal_state::{After, LengthState};

impl<W: Write> ModalWriter<W> {
    /// A straight motion at feed; none if nothing changes.
    pub(crate) fn feed(&mut self, words: &AxisWords, feed: FeedWord) -> io::Result<()> {
        if !self.any_changes(words) {
            return Ok(());
        }
        self.smooth(true)?;
        self.call_length_alone(words)?;
        match feed {
            FeedWord::PerMinute(_) => self.feed_mode(self.codes.per_minute),
            FeedWord::InverseTime(_) => self.feed_mode(self.codes.inverse_time.unwrap_or_default()),
        }
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.feed, |(code, _)| code));
        self.call_length(words)?;
        self.side_before_words();
        self.axis_words(words, false);
        self.side_after_words(along.is_some());
        match feed {
            FeedWord::PerMinute(value) => self.changed_feed(value),
            FeedWord::InverseTime(value) => {
                self.feed_word(value);
                self.modal.forget_feed();
            }
        }
        self.end()
    }

    /// A rapid; none if nothing changes.
    pub(crate) fn rapid(&mut self, words: &AxisWords) -> io::Result<()> {
        if !self.any_changes(words) {
            return Ok(());
        }
        self.call_length_alone(words)?;
        let along = self.along_vector(words);
        self.motion(along.map_or(self.codes.rapid, |(code, _)| code));
        self.call_length(words)?;
        self.axis_words(words, false);
        self.writer.code(along.map_or(self.codes.rapid_end, |(_, end)| end));
        self.end()
    }

    /// A rapid in machine coordinates. Not every control keeps its motion code in force, and some end the length offset.
    pub(crate) fn machine_rapid(&mut self, words: &AxisWords) -> io::Result<()> {
        self.smooth(false)?;
        self.usual_plane()?;
        let length = &self.codes.length;
        if length.machine_ends {
            if matches!(self.modal.length(), LengthState::On(_) | LengthState::Unknown) {
                self.writer.code(length.off);
            }
            self.modal.set_length(match self.modal.length() {
                LengthState::On(register) | LengthState::Pending(register) => LengthState::Pending(register),
                LengthState::Off | LengthState::Unknown => LengthState::Off,
            });
        }
        let [before, after] = self.codes.machine;
        self.writer.code(before);
        self.axis_words(words, true);
        self.writer.code(after);
        self.modal.forget(After::MachineRapid(words));
        self.end()
    }

    /// The code of a motion that writes a tool axis, and the end of a rapid of it, where these differ.
    fn along_vector(&self, words: &AxisWords) -> Option<(&'static str, &'static str)> {
        let vectors = self.vectors.filter(|_| self.writes(self.modal.vector_changes(words.vector)))?;
        vectors.motion.map(|code| (code, vectors.rapid_end))
    }

    /// Calls a pending length offset in a block of its own, where the control has it so.
    pub(crate) fn call_length_alone(&mut self, words: &AxisWords) -> io::Result<()> {
        match self.codes.length.call {
            LengthCall::Alone => self.call_length(words),
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// Calls a pending length offset, before a motion or in it.
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
                self.code(self.length_code);
                Ok(())
            }
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// Calls a pending length offset at once, whatever moves it.
    pub(crate) fn call_length_now(&mut self) -> io::Result<()> {
        let LengthState::Pending(register) = self.modal.length() else { return Ok(()) };
        self.modal.set_length(LengthState::On(register));
        self.fill(self.codes.length.code)
    }

    /// The length offset of the motions that follow.
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

    /// From the next feed block on the cutter runs left of its path, right, or on it.
    pub(crate) fn offset_path(&mut self, side: Option<bool>, register: u32) {
        self.side = side;
        self.values.radius = Some(register);
    }

    /// Left or right of the path, or on it again, where that is written before the words.
    fn side_before_words(&mut self) {
        if self.codes.no_compensation.is_empty() {
            self.changed_side();
        }
    }

    fn changed_side(&mut self) {
        if self.modal.side() != self.side {
            let index = self.side.map_or(2, |left| usize::from(!left));
            self.code(self.codes.compensation[index]);
            self.modal.set_side(self.side);
        }
    }

    /// The side of the path, where that is written after the words; `implied`: the motion code means no compensation.
    pub(crate) fn side_after_words(&mut self, implied: bool) {
        if self.side.is_some() || self.modal.side().is_some() {
            return self.changed_side();
        }
        if !implied {
            if self.writes(!self.modal.has_no_compensation()) {
                self.writer.code(self.codes.no_compensation);
            }
            self.modal.set_no_compensation();
        }
    }
}
