//! Modal state of the control as far as it is known. Words in force need not be written again.
//!
//! Words are compared as written, in whole units of their last decimal. State that may change without a word of the
//! program becomes unknown: [`After`] lists every such event, and [`ModalState::forget`] alone defines what remains
//! known after each of them.

use crate::motion::{AxisWords, CannedCycle, MAX_AXES};
use crate::nc::Decimal;
use crate::program::{Coolant, Coolants};

/// The length offset in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum LengthState {
    /// Unknown.
    #[default]
    Unknown,
    /// No length offset.
    Off,
    /// The offset of this register is in force.
    On(u32),
    /// The offset of this register is to be called with the next motion.
    Pending(u32),
}

/// Events that leave part of the modal state unknown.
#[derive(Debug, Clone, Copy)]
pub(crate) enum After<'w> {
    /// A stop, a restart point, or a block of the configuration or the CL data. Coolant stays known: it is not switched
    /// by hand.
    Anything,
    /// A tool change.
    ToolChange,
    /// Tip control or a tilted plane, on or off: words and F apply in another frame.
    FrameChange,
    /// A rapid in machine coordinates of these axes.
    MachineRapid(&'w AxisWords),
    /// A smoothing cycle, which may change modal codes.
    Smoothing,
    /// The end of a modal hole cycle; `z`: index of its tool axis in the chain.
    HoleCycle { z: usize },
    /// A hole of a cycle that is defined by a template: the cycle has changed the tool axis and F.
    DefinedHole { z: usize },
    /// A block with its own motion code.
    OwnMotion,
}

/// Modal state of the control; `None` is unknown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ModalState {
    /// Words of the axes, by index in the chain, and the bits of those that are known.
    axes: [i64; MAX_AXES],
    known_axes: u16,
    /// Components of the tool axis vector.
    vector: Option<[i64; 3]>,
    feed: Option<Decimal>,
    /// Motion code.
    motion: Option<&'static str>,
    feed_mode: Option<&'static str>,
    /// The code for a path without compensation has been written.
    no_compensation: bool,
    /// Side of cutter compensation, true for left; `None`: off or unknown.
    side: Option<bool>,
    length: LengthState,
    /// Spindle speed, where it is written in its own block.
    speed: Option<Decimal>,
    /// Kinds of coolant that are known to be on.
    coolant: Coolants,
    /// Code of the arc plane.
    plane: Option<&'static str>,
    /// Cycle that a position calls, where its definition survives other motions.
    cycle: Option<CannedCycle>,
    smoothing: SmoothingState,
    /// A tool has been called, whether blocks before were skipped or not; and so before the blocks that may be skipped.
    tool_called: bool,
    tool_called_before_skip: bool,
}

/// Smoothing of the path by the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum SmoothingState {
    #[default]
    Off,
    /// On, at this level and with this tolerance.
    On(usize, Decimal),
    /// It was on before a block that may have switched it off.
    Unknown,
}

impl SmoothingState {
    const fn forgotten(self) -> Self {
        match self {
            Self::Off => Self::Off,
            Self::On(..) | Self::Unknown => Self::Unknown,
        }
    }
}

/// Whether a code is in force. Nearly always it is the same entry of a table, and then no text is compared.
#[inline]
fn is_code(known: Option<&'static str>, code: &'static str) -> bool {
    known.is_some_and(|known| std::ptr::eq(known, code) || known == code)
}

impl ModalState {
    /// Sets to unknown all state that an event may have changed.
    pub(crate) fn forget(&mut self, after: After<'_>) {
        match after {
            After::Anything => {
                let smoothing = self.smoothing.forgotten();
                let Self { coolant, tool_called, tool_called_before_skip, .. } = *self;
                *self = Self { coolant, smoothing, tool_called, tool_called_before_skip, ..Self::default() };
            }
            After::ToolChange => {
                self.forget(After::FrameChange);
                self.length = LengthState::Unknown;
            }
            After::FrameChange => {
                self.known_axes = 0;
                self.vector = None;
                self.cycle = None;
                self.feed = None;
                self.motion = None;
            }
            After::MachineRapid(words) => {
                self.forget_axes(words);
                self.motion = None;
            }
            After::Smoothing => {
                self.motion = None;
                self.cycle = None;
            }
            After::HoleCycle { z } => {
                self.forget(After::DefinedHole { z });
                self.motion = None;
            }
            After::DefinedHole { z } => {
                self.forget_axis(z);
                self.feed = None;
            }
            After::OwnMotion => self.motion = None,
        }
    }

    /// Makes the next block with this axis write its word.
    pub(crate) fn forget_axis(&mut self, axis: usize) {
        self.known_axes &= !(1 << axis);
    }

    /// Makes the next block with these axes write their words.
    pub(crate) fn forget_axes(&mut self, words: &AxisWords) {
        self.known_axes &= !words.mask;
    }

    /// Makes the next feed block write its F.
    pub(crate) fn forget_feed(&mut self) {
        self.feed = None;
    }

    /// Whether the word of an axis is in force.
    pub(crate) fn is_axis(&self, axis: usize, units: i64) -> bool {
        self.known_axes & (1 << axis) != 0 && self.axes[axis] == units
    }

    /// Bits of the axes whose words are not in force.
    #[inline]
    pub(crate) fn changed_axes(&self, words: &AxisWords) -> u16 {
        let differs = |axis: usize| u16::from(self.axes[axis] != words.units[axis]) << axis;
        let differing = (0..MAX_AXES).fold(0, |axes, axis| axes | differs(axis));
        (differing | !self.known_axes) & words.mask
    }

    /// Enters the word of an axis.
    pub(crate) fn set_axis(&mut self, axis: usize, units: i64) {
        self.axes[axis] = units;
        self.known_axes |= 1 << axis;
    }

    /// Enters the words of these axes.
    #[inline]
    pub(crate) fn set_axes(&mut self, words: &AxisWords, axes: u16) {
        (0..MAX_AXES).filter(|axis| axes & (1 << axis) != 0).for_each(|axis| self.set_axis(axis, words.units[axis]));
    }

    /// Whether a tool axis vector differs from the one in force.
    #[inline]
    pub(crate) fn vector_changes(&self, vector: Option<[i64; 3]>) -> bool {
        vector.is_some() && self.vector != vector
    }

    /// Enters a tool axis vector.
    pub(crate) fn set_vector(&mut self, vector: [i64; 3]) {
        self.vector = Some(vector);
    }

    /// Enters an F; returns true if it was not in force.
    #[inline]
    pub(crate) fn set_feed(&mut self, feed: Decimal) -> bool {
        self.feed.replace(feed) != Some(feed)
    }

    /// Enters a motion code; returns true if it was not in force.
    pub(crate) fn set_motion(&mut self, code: &'static str) -> bool {
        !is_code(self.motion.replace(code), code)
    }

    pub(crate) fn is_feed_mode(&self, code: &'static str) -> bool {
        is_code(self.feed_mode, code)
    }

    /// Enters a feed mode; returns true if it was not in force. F of another feed mode is then unknown.
    pub(crate) fn set_feed_mode(&mut self, code: &'static str) -> bool {
        let changes = !is_code(self.feed_mode.replace(code), code);
        if changes {
            self.feed = None;
        }
        changes
    }

    /// Code of the arc plane.
    pub(crate) fn plane(&self) -> Option<&'static str> {
        self.plane
    }

    pub(crate) fn set_plane(&mut self, code: Option<&'static str>) {
        self.plane = code;
    }

    /// Side of cutter compensation, true for left; `None`: off or unknown.
    pub(crate) fn side(&self) -> Option<bool> {
        self.side
    }

    /// Enters the side that was written; `None` for the code that cancels compensation.
    pub(crate) fn set_side(&mut self, side: Option<bool>) {
        self.side = side;
        self.no_compensation = side.is_none();
    }

    /// Whether the code for a path without compensation is in force.
    pub(crate) fn has_no_compensation(&self) -> bool {
        self.no_compensation
    }

    pub(crate) fn set_no_compensation(&mut self) {
        self.no_compensation = true;
    }

    pub(crate) fn length(&self) -> LengthState {
        self.length
    }

    pub(crate) fn set_length(&mut self, length: LengthState) {
        self.length = length;
    }

    /// A motion to a position of the machine has cancelled the length offset; the next motion calls it again.
    pub(crate) fn cancel_length(&mut self) {
        self.length = match self.length {
            LengthState::On(register) | LengthState::Pending(register) => LengthState::Pending(register),
            LengthState::Off | LengthState::Unknown => LengthState::Off,
        };
    }

    pub(crate) fn is_speed(&self, speed: Decimal) -> bool {
        self.speed == Some(speed)
    }

    pub(crate) fn set_speed(&mut self, speed: Option<Decimal>) {
        self.speed = speed;
    }

    pub(crate) fn add_coolant(&mut self, kind: Coolant) {
        self.coolant = self.coolant.with(kind);
    }

    /// Enters that coolant is off; returns the kinds that were on.
    pub(crate) fn take_coolants(&mut self) -> Coolants {
        std::mem::take(&mut self.coolant)
    }

    /// Cycle that a position calls.
    pub(crate) fn cycle(&self) -> Option<CannedCycle> {
        self.cycle
    }

    pub(crate) fn set_cycle(&mut self, cycle: CannedCycle) {
        self.cycle = Some(cycle);
    }

    #[inline]
    pub(crate) fn smoothing(&self) -> SmoothingState {
        self.smoothing
    }

    pub(crate) fn is_tool_called(&self) -> bool {
        self.tool_called
    }

    pub(crate) fn call_tool(&mut self) {
        self.tool_called = true;
    }

    /// Blocks that may be skipped begin, or end.
    pub(crate) fn skip(&mut self, on: bool) {
        if on {
            self.tool_called_before_skip = self.tool_called;
        } else {
            self.tool_called = self.tool_called_before_skip;
        }
    }

    pub(crate) fn set_smoothing(&mut self, smoothing: SmoothingState) {
        self.smoothing = smoothing;
    }
}
