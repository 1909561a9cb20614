//! What the control believes: the one place where it stands what need not be written again.
//!
//! Words are compared as written, in whole units of their last decimal. Whatever may change the state of the control
//! behind the back of the program, a stop, a foreign block, a tool change, makes it forget.

use crate::motion::MAX_AXES;
use crate::nc::Decimal;
use crate::program::Coolant;

/// The length offset in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum LengthState {
    /// Nobody knows.
    #[default]
    Unknown,
    /// None.
    Off,
    /// This register.
    On(u32),
    /// This register is to be called with the next motion.
    Wanted(u32),
}

/// State of the control as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Belief {
    /// Words of the axes by position in the chain.
    axes: [Option<i64>; MAX_AXES],
    /// Components of the tool axis.
    vector: Option<[i64; 3]>,
    feed: Option<Decimal>,
    /// Motion code.
    pub(super) motion: &'static str,
    /// Feed mode.
    pub(super) feed_mode: &'static str,
    /// The path is not compensated.
    pub(super) centre: bool,
    pub(super) length: LengthState,
    /// Speed of the spindle, where it stands in blocks of its own.
    pub(super) speed: Option<Decimal>,
    /// Coolant that is on.
    pub(super) coolant: Option<Coolant>,
    /// The plane of arcs, by its code; empty if nobody knows.
    pub(super) plane: &'static str,
    /// The control smooths.
    pub(super) smooth: bool,
}

impl Belief {
    /// Nothing is known any more, except what nobody switches by hand.
    pub(super) fn forget(&mut self) {
        *self = Self { coolant: self.coolant, ..Self::default() };
    }

    /// An axis may stand anywhere.
    pub(super) fn forget_axis(&mut self, axis: usize) {
        self.axes[axis] = None;
    }

    /// Every axis may stand anywhere.
    pub(super) fn forget_axes(&mut self) {
        self.axes = [None; MAX_AXES];
        self.vector = None;
    }

    /// The next F has to be written.
    pub(super) fn forget_feed(&mut self) {
        self.feed = None;
    }

    #[inline]
    pub(super) fn axis_changes(&self, axis: usize, units: i64) -> bool {
        self.axes[axis] != Some(units)
    }

    /// Takes over the word of an axis.
    #[inline]
    pub(super) fn set_axis(&mut self, axis: usize, units: i64) {
        self.axes[axis] = Some(units);
    }

    /// A block would write another tool axis.
    #[inline]
    pub(super) fn vector_changes(&self, vector: Option<[i64; 3]>) -> bool {
        vector.is_some() && self.vector != vector
    }

    /// Takes over a tool axis.
    pub(super) fn set_vector(&mut self, vector: [i64; 3]) {
        self.vector = Some(vector);
    }

    /// Takes over an F; true if another was in force.
    #[inline]
    pub(super) fn set_feed(&mut self, feed: Decimal) -> bool {
        let changes = self.feed != Some(feed);
        self.feed = Some(feed);
        changes
    }

    /// Takes over a motion code; true if another was in force.
    pub(super) fn set_motion(&mut self, code: &'static str) -> bool {
        let changes = self.motion != code;
        self.motion = code;
        changes
    }

    /// Takes over a feed mode; true if another was in force.
    pub(super) fn set_feed_mode(&mut self, code: &'static str) -> bool {
        let changes = self.feed_mode != code;
        self.feed_mode = code;
        changes
    }
}
