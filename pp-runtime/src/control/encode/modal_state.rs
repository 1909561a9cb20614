//! Modal state of the control as far as it is known: what is in force need not be written again.
//!
//! Words are compared as written, in whole units of their last decimal. What may change the control without a word of the
//! program makes it unknown; [`After`] lists every such case, and [`ModalState::forget`] is the one place that knows what
//! each of them leaves.

use crate::motion::{AxisWords, CannedCycle, MAX_AXES};
use crate::nc::Decimal;
use crate::program::Coolant;

/// The length offset in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum LengthState {
    /// Not known.
    #[default]
    Unknown,
    /// None.
    Off,
    /// This register.
    On(u32),
    /// This register, to be called with the next motion.
    Pending(u32),
}

/// Events that leave part of the modal state unknown.
#[derive(Debug, Clone, Copy)]
pub(crate) enum After<'w> {
    /// A stop, a restart point, or a block that is not ours. Coolant is kept: it is not switched by hand.
    Anything,
    /// A tool change.
    ToolChange,
    /// Tip control or a tilted plane, on or off: words and F count in another frame.
    FrameChange,
    /// A rapid of these axes in machine coordinates.
    MachineRapid(&'w AxisWords),
    /// A smoothing cycle, which may bring codes of its own.
    Smoothing,
    /// The end of a modal cycle of holes, with the position of its tool axis in the chain.
    HoleCycle { z: usize },
    /// A hole of a cycle that is defined by a template: the tool axis and F are where the cycle left them.
    DefinedHole { z: usize },
    /// A block with a motion code of its own.
    OwnMotion,
}

/// Modal state as far as it is known; `None` is unknown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ModalState {
    /// Words of the axes by position in the chain.
    axes: [Option<i64>; MAX_AXES],
    /// Components of the tool axis.
    vector: Option<[i64; 3]>,
    feed: Option<Decimal>,
    /// Motion code.
    motion: Option<&'static str>,
    feed_mode: Option<&'static str>,
    /// The code of a path without compensation was written.
    no_compensation: bool,
    /// The cutter runs left of its path, or right; `None`: on it, or not known.
    side: Option<bool>,
    length: LengthState,
    /// Speed of the spindle, where it is written in blocks of its own.
    speed: Option<Decimal>,
    /// Coolant that is on.
    coolant: Option<Coolant>,
    /// Code of the plane of arcs.
    plane: Option<&'static str>,
    /// The cycle that a place calls, where its definition outlives other motions.
    cycle: Option<CannedCycle>,
    /// The control smooths.
    smooths: bool,
}

impl ModalState {
    /// Makes unknown what an event may have changed.
    pub(crate) fn forget(&mut self, after: After<'_>) {
        match after {
            After::Anything => *self = Self { coolant: self.coolant, ..Self::default() },
            After::ToolChange => {
                self.forget(After::FrameChange);
                self.length = LengthState::Unknown;
            }
            After::FrameChange => {
                self.axes = [None; MAX_AXES];
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

    /// The next block with this axis writes its word.
    pub(crate) fn forget_axis(&mut self, axis: usize) {
        self.axes[axis] = None;
    }

    /// The next block with these axes writes their words.
    pub(crate) fn forget_axes(&mut self, words: &AxisWords) {
        for (axis, known) in self.axes.iter_mut().enumerate() {
            if words.has(axis) {
                *known = None;
            }
        }
    }

    /// The next feed block writes its F.
    pub(crate) fn forget_feed(&mut self) {
        self.feed = None;
    }

    #[inline]
    pub(crate) fn axis_changes(&self, axis: usize, units: i64) -> bool {
        self.axes[axis] != Some(units)
    }

    /// Takes over the word of an axis.
    #[inline]
    pub(crate) fn set_axis(&mut self, axis: usize, units: i64) {
        self.axes[axis] = Some(units);
    }

    /// A block would write another tool axis.
    #[inline]
    pub(crate) fn vector_changes(&self, vector: Option<[i64; 3]>) -> bool {
        vector.is_some() && self.vector != vector
    }

    /// Takes over a tool axis.
    pub(crate) fn set_vector(&mut self, vector: [i64; 3]) {
        self.vector = Some(vector);
    }

    /// Takes over an F; true if it was not in force.
    #[inline]
    pub(crate) fn set_feed(&mut self, feed: Decimal) -> bool {
        self.feed.replace(feed) != Some(feed)
    }

    /// Takes over a motion code; true if it was not in force.
    pub(crate) fn set_motion(&mut self, code: &'static str) -> bool {
        self.motion.replace(code) != Some(code)
    }

    pub(crate) fn is_feed_mode(&self, code: &'static str) -> bool {
        self.feed_mode == Some(code)
    }

    /// Takes over a feed mode; true if it was not in force: F of another mode means nothing in it.
    pub(crate) fn set_feed_mode(&mut self, code: &'static str) -> bool {
        let changes = self.feed_mode.replace(code) != Some(code);
        if changes {
            self.feed = None;
        }
        changes
    }

    /// Code of the plane of arcs.
    pub(crate) fn plane(&self) -> Option<&'static str> {
        self.plane
    }

    pub(crate) fn set_plane(&mut self, code: Option<&'static str>) {
        self.plane = code;
    }

    /// Side of the path on which the cutter runs: left, or right.
    pub(crate) fn side(&self) -> Option<bool> {
        self.side
    }

    /// Takes over a side that was written, or the cancelling code.
    pub(crate) fn set_side(&mut self, side: Option<bool>) {
        self.side = side;
        self.no_compensation = side.is_none();
    }

    /// Whether the code of a path without compensation is in force.
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

    pub(crate) fn is_speed(&self, speed: Decimal) -> bool {
        self.speed == Some(speed)
    }

    pub(crate) fn set_speed(&mut self, speed: Option<Decimal>) {
        self.speed = speed;
    }

    pub(crate) fn set_coolant(&mut self, kind: Coolant) {
        self.coolant = Some(kind);
    }

    /// Coolant goes off; the kind that was on.
    pub(crate) fn take_coolant(&mut self) -> Option<Coolant> {
        self.coolant.take()
    }

    /// The cycle that a place calls.
    pub(crate) fn cycle(&self) -> Option<CannedCycle> {
        self.cycle
    }

    pub(crate) fn set_cycle(&mut self, cycle: CannedCycle) {
        self.cycle = Some(cycle);
    }

    pub(crate) fn smooths(&self) -> bool {
        self.smooths
    }

    pub(crate) fn set_smoothing(&mut self, on: bool) {
        self.smooths = on;
    }
}
