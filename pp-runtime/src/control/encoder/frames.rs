//! What the words count from: length offset, tip control, tilted planes, machine coordinates, restart points.

use std::io::{self, Write};

use crate::motion::Mode;
use crate::motion::{PoseRule, Words};
use crate::nc::Decimal;

use super::super::LengthCall;
use super::super::belief::LengthState;
use super::super::template::fill;
use super::Encoder;

impl<W: Write> Encoder<'_, W> {
    /// Calls the length offset that waits, in front of a motion or with it.
    pub(super) fn call_length(&mut self, words: &Words) -> io::Result<()> {
        let LengthState::Wanted(register) = self.belief.length else { return Ok(()) };
        match self.codes.length.call {
            LengthCall::Alone => {
                self.belief.length = LengthState::On(register);
                self.fill(self.codes.length.code)
            }
            LengthCall::WithZ if self.z.is_none_or(|z| words.has(z)) => {
                self.belief.length = LengthState::On(register);
                if let Some(z) = self.z {
                    self.belief.forget_axis(z);
                }
                let code = fill(self.length_code(), |field| self.values.get(field)).unwrap_or_default();
                self.writer.code(&code);
                Ok(())
            }
            LengthCall::WithZ | LengthCall::WithTool => Ok(()),
        }
    }

    /// The code that calls the length offset, and with it tip control where the two go together.
    pub(super) fn length_code(&self) -> &'static str {
        let tip = self.codes.tip.as_ref().filter(|_| self.mode == Mode::Tcp && self.setup.tip_control.is_none());
        let code = tip.and_then(|tip| self.vectors.map_or(tip.with_length, |vectors| vectors.with_length));
        code.unwrap_or(self.codes.length.code)
    }

    /// Tip control on or off; where it comes with the length offset, with the next motion.
    pub(super) fn tip_control(&mut self, on: bool) -> io::Result<()> {
        self.usual_plane()?;
        self.frame_changes();
        if let Some(codes) = &self.setup.tip_control {
            let code = codes[usize::from(!on)].clone();
            return self.block(&code);
        }
        let Some(tip) = &self.codes.tip else { return Ok(()) };
        if !on {
            self.smooth(false)?;
        }
        self.fill_all(if on { tip.on } else { tip.off })?;
        if let LengthState::On(register) = self.belief.length
            && !on
            && tip.ends_length
        {
            self.belief.length = LengthState::Wanted(register);
        }
        Ok(())
    }

    /// Tilts the plane. The control turns the rotary axes to it, and its blocks may bring codes of their own.
    pub(super) fn tilt(&mut self, angles: [Decimal; 3], pose: Option<bool>) -> io::Result<()> {
        let Some(plane) = &self.codes.plane else { return Ok(()) };
        self.usual_plane()?;
        if let LengthState::Wanted(register) = self.belief.length
            && plane.length_first
        {
            self.belief.length = LengthState::On(register);
            self.fill(self.codes.length.code)?;
        }
        self.values.plane = angles;
        // Where both poses are one, a control that wants a word gets one.
        self.values.pose = match pose {
            Some(higher) => plane.poses[usize::from(higher)],
            None if plane.pose == PoseRule::Side => plane.poses[1],
            None => "",
        };
        self.fill_all(plane.on)?;
        self.frame_changes();
        Ok(())
    }

    pub(super) fn tilt_off(&mut self) -> io::Result<()> {
        let Some(plane) = &self.codes.plane else { return Ok(()) };
        self.smooth(false)?;
        self.fill_all(plane.off)?;
        self.frame_changes();
        Ok(())
    }

    /// Words mean something else from here on, F too: it may count along another path.
    fn frame_changes(&mut self) {
        self.belief.forget_axes();
        self.belief.forget_feed();
        self.belief.motion = "";
    }

    /// A rapid in machine coordinates. Not every control keeps its motion code in force, and some end the length offset.
    pub(super) fn machine(&mut self, words: &Words) -> io::Result<()> {
        self.smooth(false)?;
        self.usual_plane()?;
        let length = &self.codes.length;
        if length.machine_ends {
            if !matches!(self.belief.length, LengthState::Off | LengthState::Wanted(_)) {
                self.writer.code(length.off);
            }
            self.belief.length = match self.belief.length {
                LengthState::On(register) | LengthState::Wanted(register) => LengthState::Wanted(register),
                LengthState::Off | LengthState::Unknown => LengthState::Off,
            };
        }
        self.belief.motion = "";
        let [before, behind] = self.codes.machine;
        self.writer.code(before);
        self.axis_words(words, true);
        self.writer.code(behind);
        for axis in self.axes.iter().filter(|axis| words.has(axis.index)) {
            self.belief.forget_axis(axis.index);
        }
        self.writer.end()
    }

    pub(super) fn restart(&mut self, number: u32) -> io::Result<()> {
        self.smooth(false)?;
        self.belief.forget();
        self.writer.number_next(number);
        match self.setup.safety.take() {
            Some(safety) => {
                self.fill_all(&safety)?;
                self.setup.safety = Some(safety);
            }
            None => {
                self.fill_all(self.codes.safety)?;
                self.reset_frame()?;
                self.belief.feed_mode = self.codes.per_minute;
                self.belief.length = LengthState::Off;
                self.belief.plane = self.codes.arcs.planes[2].unwrap_or_default();
            }
        }
        Ok(())
    }

    /// What a restart point cancels besides, in a mode that uses it.
    pub(super) fn reset_frame(&mut self) -> io::Result<()> {
        match (self.mode, &self.setup.tip_control, &self.codes.tip, &self.codes.plane) {
            (Mode::Tcp, Some([_, off]), _, _) => {
                let off = off.clone();
                self.block(&off)
            }
            (Mode::Tcp, None, Some(tip), _) => self.fill_all(tip.reset),
            (Mode::Plane, _, _, Some(plane)) => self.fill_all(plane.reset),
            _ => Ok(()),
        }
    }

    pub(super) fn tool_change(&mut self) -> io::Result<()> {
        match self.setup.tool_change.take() {
            Some(blocks) => {
                self.fill_all(&blocks)?;
                self.setup.tool_change = Some(blocks);
            }
            None => {
                self.fill_all(self.codes.tool_change)?;
                self.belief.speed = self.values.speed;
            }
        }
        self.belief.forget_axes();
        self.belief.forget_feed();
        self.belief.motion = "";
        self.belief.length = LengthState::Unknown;
        Ok(())
    }
}
