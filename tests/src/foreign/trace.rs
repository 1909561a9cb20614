//! What a program does: its executed blocks, one after the other.

use std::fmt;

use super::axes::Axes;
use super::state::{Cycle, CycleKind, FeedMode, Length, MotionMode, Spindle, State};

/// An executed program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trace {
    /// Lines that define the blank for the graphics of the control.
    pub blank: Vec<String>,
    /// Comments without their marks, with their lines.
    pub comments: Vec<(usize, String)>,
    /// Blocks, in the order of execution.
    pub blocks: Vec<Executed>,
}

/// One executed block.
#[derive(Debug, Clone, PartialEq)]
pub struct Executed {
    /// Line, from 1; the first where a block takes several.
    pub line: usize,
    /// Block number.
    pub number: Option<u32>,
    /// What the block does.
    pub effect: Effect,
    /// Axis words of the block, as written.
    pub words: Axes,
    /// The program can be entered here: the first block of a complete state.
    pub restart: bool,
    /// The operator may skip it (`/`).
    pub skippable: bool,
    /// State after the block.
    pub state: State,
}

/// What a block does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Effect {
    /// Nothing but a change of modal state.
    Modal,
    /// A complete modal state begins: the safety line of a restart point.
    Safety,
    /// Tool length compensation alone.
    Length(Length),
    /// Spindle.
    Spindle(Spindle),
    /// Coolant.
    Coolant {
        /// Flood or mist is switched off, whether it was on or not.
        off: bool,
    },
    /// A tool comes into the spindle.
    ToolChange(u32),
    /// The program stops unless the control's tool length is the one posted.
    Guard {
        /// Length posted, in the unit of the program.
        length: f64,
        /// Difference allowed.
        tolerance: f64,
    },
    /// The program stops unless the sum of |sin(d/2)| is at most this: d the differences of the rotary axes from these
    /// words.
    PlaneGuard {
        /// Words.
        axes: Axes,
        /// Largest sum.
        largest: f64,
    },
    /// The program stops if a rotation, a scale, a mirror or a shift that lasts lies over the work offset.
    OffsetGuard,
    /// A wait, s.
    Dwell(f64),
    /// M0.
    Stop,
    /// M1.
    OptionalStop,
    /// M2, M30.
    End,
    /// Every axis as fast as it can.
    Rapid,
    /// All axes together at feed.
    Feed,
    /// An arc or a helix at feed.
    Arc(Arc),
    /// A hole of a canned cycle.
    Hole(Hole),
    /// A rapid to machine coordinates.
    Machine,
    /// The control turns the rotary axes to the tilted plane.
    Orient,
    /// Axes go to their reference points, all if none is named: G28, G30. They pass the position of the block.
    Home(Axes),
    /// An M code of the shop, by its number.
    Shop(u32),
}

impl Effect {
    /// Whether an axis moves.
    #[must_use]
    pub const fn moves(&self) -> bool {
        matches!(
            self,
            Self::Rapid | Self::Feed | Self::Arc(_) | Self::Hole(_) | Self::Machine | Self::Orient | Self::Home(_)
        )
    }

    /// Whether the tool cuts.
    #[must_use]
    pub const fn cuts(&self) -> bool {
        matches!(self, Self::Feed | Self::Arc(_) | Self::Hole(_))
    }

    /// Whether a thread is cut.
    #[must_use]
    pub const fn is_thread(&self) -> bool {
        matches!(self, Self::Hole(Hole { cycle: Cycle { kind: CycleKind::Tap { .. }, .. }, .. }))
    }

    /// Whether the operator has to press start again.
    #[must_use]
    pub const fn stops(&self) -> bool {
        matches!(self, Self::Stop | Self::OptionalStop)
    }
}

/// An arc or a helix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Centre in X Y Z; the component along the normal of the plane is 0.
    pub centre: [f64; 3],
    /// Angle about the normal of the plane, counter-clockwise positive, degrees.
    pub sweep_deg: f64,
}

/// A hole of a canned cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// The cycle.
    pub cycle: Cycle,
    /// Level after the hole.
    pub back_to: f64,
    /// How the tool comes over the hole.
    pub approach: MotionMode,
    /// Level at which it does, where that is known.
    pub over: Option<f64>,
}

/// An F with its mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// G94: units of length per minute.
    PerMinute(f64),
    /// G93: blocks per minute.
    InverseTime(f64),
    /// G95: units of length per revolution.
    PerRevolution(f64),
}

impl Executed {
    /// F of a block that cuts, that of its cycle before that in force; `None` for any other block, and for a thread,
    /// which follows its pitch.
    #[must_use]
    pub fn feed(&self) -> Option<Feed> {
        let feed = match self.effect {
            effect if effect.is_thread() => None,
            Effect::Hole(hole) => hole.cycle.feed.or(self.state.feed),
            _ => self.state.feed.filter(|_| self.effect.cuts()),
        }?;
        Some(match self.state.feed_mode? {
            FeedMode::PerMinute => Feed::PerMinute(feed),
            FeedMode::InverseTime => Feed::InverseTime(feed),
            FeedMode::PerRevolution => Feed::PerRevolution(feed),
        })
    }
}

impl Trace {
    /// Blocks that move an axis.
    pub fn motions(&self) -> impl Iterator<Item = &Executed> {
        self.blocks.iter().filter(|block| block.effect.moves())
    }

    /// Lines at which the program can be entered: the first block of each complete state. It has a block number, or
    /// begins with M129 where every line has a number (Heidenhain).
    pub fn restarts(&self) -> impl Iterator<Item = usize> + '_ {
        self.blocks.iter().filter(|block| block.restart).map(|block| block.line)
    }
}

/// Why a program is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// Line, from 1.
    pub line: usize,
    /// Reason, with the text of the block.
    pub why: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.why)
    }
}
