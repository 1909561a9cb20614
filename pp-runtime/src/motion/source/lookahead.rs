//! Look-ahead of one motion: the approach to the first point of an operation, and to the end of a rapid that moves
//! rotary axes, depends on the point after it.
//!
//! Such a motion is held back until the next one, and the records between the two with it, so that the order of the CL
//! data is kept. A feed motion inside an operation is never held back.

use std::ops::Range;

use crate::kinematics::Pose;
use crate::program::{Arc, Event, Hole, Location, MachineFunction, Move, ReferenceGeometry, TextKind};

use crate::motion::source::operations::{Begins, MotionIndex};
use crate::motion::source::{ItemAction, LinePart, ProgramItem, Stage};

/// Most records held back after one motion; bounds the memory. No CAM system writes as many between two motions.
const MAX_RECORDS: usize = 10_000;

/// Most bytes of text held back with the records.
const MAX_TEXT_BYTES: usize = 1 << 20;

/// The motion after a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Next {
    /// A straight motion to this pose, or the rapid to this pose above a hole.
    Motion(Pose),
    /// No motion on which the approach depends.
    None,
    /// Unknown: before it come more records than are held back.
    Unknown,
}

/// A motion that is held back.
#[derive(Debug, Clone, Copy)]
struct WaitingMotion {
    at: Location,
    motion: Move,
    index: MotionIndex,
    part: LinePart,
}

/// A record that is held back.
#[derive(Debug, Clone)]
enum WaitingRecord {
    Function(MachineFunction),
    Reference(ReferenceGeometry),
    /// Its text is at this range of [`Lookahead::texts`].
    Text(TextKind, Range<usize>),
}

/// The motion that is held back, and the records after it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lookahead {
    motion: Option<WaitingMotion>,
    records: Vec<(Location, WaitingRecord, bool)>,
    texts: Vec<u8>,
}

impl Lookahead {
    /// Takes a straight motion; holds it back if its approach may depend on the next.
    #[inline]
    pub(crate) fn line<S: Stage>(
        &mut self,
        at: Location,
        motion: &Move,
        index: MotionIndex,
        part: LinePart,
        to: &mut S,
    ) -> Result<(), S::Stop> {
        if self.motion.is_some() {
            self.release(Next::Motion(motion.pose), to)?;
        }
        if index.begins != Begins::Nothing || motion.rapid {
            self.motion = Some(WaitingMotion { at, motion: *motion, index, part });
            return Ok(());
        }
        to.take(&ProgramItem { at, action: ItemAction::Line { motion, index, next: Next::None, part } })
    }

    pub(crate) fn arc<S: Stage>(
        &mut self,
        at: Location,
        arc: &Arc,
        index: MotionIndex,
        to: &mut S,
    ) -> Result<(), S::Stop> {
        self.release(Next::None, to)?;
        to.take(&ProgramItem { at, action: ItemAction::Arc { arc, index } })
    }

    pub(crate) fn hole<S: Stage>(
        &mut self,
        at: Location,
        hole: &Hole,
        index: MotionIndex,
        to: &mut S,
    ) -> Result<(), S::Stop> {
        self.release(Next::Motion(hole.level(hole.clearance_mm)), to)?;
        to.take(&ProgramItem { at, action: ItemAction::Hole { hole, index } })
    }

    /// Takes a record after which another operation begins.
    pub(crate) fn boundary<S: Stage>(&mut self, at: Location, event: &Event<'_>, to: &mut S) -> Result<(), S::Stop> {
        self.release(Next::None, to)?;
        to.take(&ProgramItem { at, action: ItemAction::Record { event, between: true } })
    }

    /// Takes a record that belongs to the motions around it, or with `between` to the next operation.
    pub(crate) fn record<S: Stage>(
        &mut self,
        at: Location,
        event: &Event<'_>,
        between: bool,
        to: &mut S,
    ) -> Result<(), S::Stop> {
        if self.motion.is_some() {
            if self.records.len() >= MAX_RECORDS || self.texts.len() >= MAX_TEXT_BYTES {
                self.release(Next::Unknown, to)?;
            } else if let Some(kept) = self.keep(event) {
                self.records.push((at, kept, between));
                return Ok(());
            } else {
                self.release(Next::None, to)?;
            }
        }
        to.take(&ProgramItem { at, action: ItemAction::Record { event, between } })
    }

    /// Whether the first motion of an operation is held back.
    pub(crate) fn awaits_second_motion(&self) -> bool {
        self.motion.is_some_and(|waiting| waiting.index.begins != Begins::Nothing)
    }

    /// Hands on the motion that is held back and its records; `next` is the motion after it.
    #[inline]
    pub(crate) fn release<S: Stage>(&mut self, next: Next, to: &mut S) -> Result<(), S::Stop> {
        match self.motion.take() {
            Some(waiting) => self.release_waiting(waiting, next, to),
            None => Ok(()),
        }
    }

    fn release_waiting<S: Stage>(&mut self, waiting: WaitingMotion, next: Next, to: &mut S) -> Result<(), S::Stop> {
        let WaitingMotion { at, ref motion, index, part } = waiting;
        to.take(&ProgramItem { at, action: ItemAction::Line { motion, index, next, part } })?;
        for (at, kept, between) in self.records.drain(..) {
            let event = match kept {
                WaitingRecord::Function(function) => Event::Function(function),
                WaitingRecord::Reference(geometry) => Event::Reference(geometry),
                WaitingRecord::Text(kind, range) => Event::Text(kind, &self.texts[range]),
            };
            to.take(&ProgramItem { at, action: ItemAction::Record { event: &event, between } })?;
        }
        self.texts.clear();
        Ok(())
    }

    /// Copies a record to hold it back; `None` for a motion and for a record that ends an operation.
    fn keep(&mut self, event: &Event<'_>) -> Option<WaitingRecord> {
        match *event {
            Event::Function(function) => Some(WaitingRecord::Function(function)),
            Event::Reference(geometry) => Some(WaitingRecord::Reference(geometry)),
            Event::Text(kind, text) => {
                let start = self.texts.len();
                self.texts.extend_from_slice(text);
                Some(WaitingRecord::Text(kind, start..self.texts.len()))
            }
            Event::Motion(_) | Event::NewStart(_) | Event::Interruption(_) => None,
        }
    }
}
