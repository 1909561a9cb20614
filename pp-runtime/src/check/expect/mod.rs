//! The CL data as a program must carry it out: one item after the other, each with the state that it requires.
//!
//! Events come from a reader of the check's own. `placement` has the part as it is mounted, `modal` the modal state of
//! the CL data: tool, register, speed, sense of rotation and coolant of each motion, where an operation begins, what is
//! posted at all; `operations` has the rules of single operations. Arcs and pieces of curves stay what they are; `hole`
//! has the motions of a hole.

mod hole;
mod modal;
mod operations;
mod placement;

use std::cell::RefCell;
use std::collections::VecDeque;
use std::io;
use std::rc::Rc;

use crate::cl::{ClData, ClEvents, ClReader, ReadingOptions};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AnyMachine, AxisKind, Side as ChainSide};
use crate::program::{Clearance, Event, Feed, Location, Rotation, Units};

use super::geometry::{PathShape, ToolPose};
use super::policy::{CheckPolicy, LinearMeaning, SmoothingLevel};
use super::read::SideOfPath;
pub(super) use hole::ExpectedHole;
use modal::ClState;
pub(super) use modal::legible;
use placement::Placement;

/// Number of items that are read ahead, so that a block can be found among them.
const AHEAD: usize = 64;

/// Speed in rev/min and sense of rotation.
pub(super) type SpindleState = (f64, Rotation);

/// The state that a motion requires.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Required {
    pub(crate) tool: Option<u32>,
    /// The record that calls the tool.
    pub(crate) called: Option<Location>,
    /// Register of the tool length.
    pub(crate) register: u32,
    pub(crate) gauge_length_mm: Option<f64>,
    /// `None`: off, or never requested.
    pub(crate) spindle: Option<SpindleState>,
    /// Spindle state that the last SPINDL requests, if that is after a motion of its operation; `None` before the
    /// first.
    requested_spindle: Option<Option<SpindleState>>,
    /// The one that it takes the place of, without a motion between them.
    requested_before: Option<SpindleState>,
    /// Bits of [`coolant`](super::read::coolant).
    pub(crate) coolant: u8,
    /// Number of the set-up.
    pub(crate) set_up: u32,
    /// Number of the operation, from 1.
    pub(crate) operation: u64,
    pub(crate) side: SideOfPath,
    /// Register of the tool radius, on controls with registers of their own for it.
    pub(crate) radius_register: u32,
    /// Radius of the tool that the path was made for, mm.
    pub(crate) radius_mm: Option<f64>,
    /// Largest deviation of chords from the path, mm.
    pub(crate) tolerance_mm: f64,
    /// Material that the operation leaves on the design, mm.
    pub(crate) allowance_mm: f64,
    /// Meaning of linear words in the operation; `None`: the program decides.
    pub(crate) linear: Option<LinearMeaning>,
    /// Smoothing in the cuts of the operation, and largest deviation where the control blends or smooths.
    pub(crate) smoothing: RequiredSmoothing,
    /// Geometry that the tool leaves before rotary axes rotate.
    pub(crate) clearance: Option<Clearance>,
}

/// Smoothing in cuts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RequiredSmoothing {
    /// `None`: off.
    pub(crate) level: Option<SmoothingLevel>,
    /// Largest deviation where the control blends or smooths, mm.
    pub(crate) blending_mm: f64,
}

/// A motion of the CL data.
#[derive(Debug, Clone)]
pub(super) struct ClMotion {
    pub(crate) to: ToolPose,
    pub(crate) shape: PathShape,
    pub(crate) rapid: bool,
    pub(crate) feed: Option<Feed>,
    /// It begins an operation: the safe sequence leads to it.
    pub(crate) starts: bool,
}

/// One item of the CL data that the program must carry out.
#[derive(Debug, Clone)]
pub(super) struct ExpectedItem {
    pub(crate) at: Location,
    pub(crate) required: Rc<Required>,
    /// The hole of the motion, which a cycle of the control may make.
    pub(crate) hole: Option<Rc<ExpectedHole>>,
    pub(crate) action: ExpectedAction,
}

impl ExpectedItem {
    /// The motion of the item, if it is one.
    pub(crate) fn motion(&self) -> Option<&ClMotion> {
        match &self.action {
            ExpectedAction::Motion(motion) => Some(motion),
            _ => None,
        }
    }
}

/// Action of an item.
#[derive(Debug, Clone)]
pub(super) enum ExpectedAction {
    Motion(ClMotion),
    Stop {
        optional: bool,
    },
    /// The blocks after it may be skipped, or no longer.
    BlockSkip {
        on: bool,
    },
    /// `between`: before the first motion of an operation; the tool may have left the part. `spindle`: state that
    /// SPINDL has requested before it, since the last operation.
    Dwell {
        seconds: f64,
        between: bool,
        spindle: Option<SpindleState>,
    },
    /// A block that is copied from the CL data.
    Raw(Vec<u8>),
    /// A block with which a probe measures; the `first` where the last motion has ended.
    Probe {
        /// Its text.
        text: Vec<u8>,
        /// No other comes before it.
        first: bool,
    },
    Home {
        /// A tool has been called since the last motion.
        called: bool,
    },
}

/// A text that the control must display.
#[derive(Debug, Clone)]
pub(super) struct ExpectedMessage {
    pub(crate) at: Location,
    /// What is left of it, letters and digits only.
    pub(crate) text: Vec<u8>,
    /// It may end early: the name of an operation.
    pub(crate) may_be_cut: bool,
    /// Number of items before it.
    after: u64,
}

/// The items of a program, as one of its readings has taken them.
#[derive(Clone)]
pub(super) struct Expect<'a> {
    source: Rc<RefCell<ClReadings<'a>>>,
    items: VecDeque<ExpectedItem>,
    messages: VecDeque<ExpectedMessage>,
    /// Numbers of items and of messages that have been read from the source.
    read: (u64, u64),
    /// Number of the last item so far that is no motion.
    last_other: u64,
    /// The CL data has an error so far: no motion after it is known.
    failed: bool,
}

/// The CL data, for all readings of one program.
struct ClReadings<'a> {
    events: ClEvents<'a>,
    placement: Placement,
    state: ClState<'a>,
    ended: bool,
}

impl ClReadings<'_> {
    #[inline(never)]
    fn read(&mut self) -> io::Result<()> {
        let Self { events, placement, state, ended } = self;
        *ended = !events.next(|at, event| {
            let placed = placement.of(event);
            state.event(at, placed.as_ref().unwrap_or(event));
        })?;
        if *ended {
            state.come_to_approach();
        }
        Ok(())
    }

    /// Whether the CL data has an error so far.
    fn failed(&self) -> bool {
        self.events.facts().is_some_and(|facts| facts.failed) || self.state.fault().is_some()
    }
}

impl<'a> Expect<'a> {
    /// `unit_mm`: one unit of linear words.
    pub(super) fn new(machine: &dyn AnyMachine, events: ClEvents<'a>, policy: &'a CheckPolicy, unit_mm: f64) -> Self {
        let rotary = |axis: &crate::kinematics::Axis| axis.kind == AxisKind::Rotary && !axis.held;
        let head = machine.axes().iter().any(|axis| rotary(axis) && axis.side == ChainSide::Tool);
        let rotations = policy.set_up.clampings().map(|(number, part)| (number, part.part_rotation.into_inner()));
        let source = ClReadings {
            events,
            placement: Placement::new(rotations.collect(), policy.links.dry_lift_mm),
            state: ClState::new(policy, head, unit_mm),
            ended: false,
        };
        Self {
            source: Rc::new(RefCell::new(source)),
            items: VecDeque::new(),
            messages: VecDeque::new(),
            read: (0, 0),
            last_other: 0,
            failed: false,
        }
    }

    /// Reads ahead and returns the items that are known.
    pub(super) fn ahead(&mut self) -> io::Result<&VecDeque<ExpectedItem>> {
        self.fill(AHEAD)?;
        Ok(&self.items)
    }

    /// Reads until `count` items are known, or the CL data ends.
    #[inline]
    pub(super) fn fill(&mut self, count: usize) -> io::Result<()> {
        if self.items.len() < count { self.read(count) } else { Ok(()) }
    }

    #[inline(never)]
    fn read(&mut self, count: usize) -> io::Result<()> {
        let alone = Rc::strong_count(&self.source) == 1;
        let mut source = self.source.borrow_mut();
        while self.items.len() < count {
            if let Some(item) = source.state.items().take(&mut self.read.0, alone) {
                self.items.push_back(item);
            } else if source.ended {
                break;
            } else {
                source.read()?;
            }
        }
        while let Some(message) = source.state.messages().take(&mut self.read.1, alone) {
            self.messages.push_back(message);
        }
        self.last_other = source.state.last_other();
        self.failed = source.failed();
        Ok(())
    }

    /// Whether there may be others than motions among the items that are known.
    pub(super) fn has_others(&self) -> bool {
        self.last_other > self.done()
    }

    /// Number of items that have been taken.
    fn done(&self) -> u64 {
        self.read.0 - self.items.len() as u64
    }

    /// An item ahead, 0 the next.
    pub(super) fn get(&self, index: usize) -> Option<&ExpectedItem> {
        self.items.get(index)
    }

    pub(super) fn pop(&mut self) -> Option<ExpectedItem> {
        self.items.pop_front()
    }

    /// Spindle state that the last SPINDL before the next item requests.
    pub(super) fn requested_spindle(&self) -> Option<Option<SpindleState>> {
        match self.items.front() {
            Some(item) => item.required.requested_spindle,
            None => self.source.borrow().state.requested_after_selected(),
        }
    }

    /// Spindle state that another SPINDL before it requests.
    pub(super) fn requested_before(&self) -> Option<SpindleState> {
        self.items.front().and_then(|item| item.required.requested_before)
    }

    /// The next text that the control must display.
    pub(super) fn next_message(&mut self) -> Option<&mut ExpectedMessage> {
        self.messages.front_mut()
    }

    /// Takes the next text.
    pub(super) fn pop_message(&mut self) -> Option<ExpectedMessage> {
        self.messages.pop_front()
    }

    /// Takes the next text if an item after it is done.
    pub(super) fn overdue_message(&mut self) -> Option<ExpectedMessage> {
        let done = self.done();
        let after = self.next_message()?.after;
        if after < done { self.pop_message() } else { None }
    }

    /// The tool that the CL data has called last in the selected operations.
    pub(super) fn last_tool(&self) -> Option<u32> {
        self.source.borrow().state.last_call()
    }

    /// Whether the CL data has an error so far: no motion after it is known.
    pub(super) fn failed(&self) -> bool {
        self.failed
    }

    /// First error of the CL data.
    pub(super) fn fault(&self) -> Option<Diagnostic> {
        let source = self.source.borrow();
        let found = source.events.facts().map_or(&[][..], |facts| &facts.diagnostics);
        let errors = found.iter().filter(|found| found.severity == Severity::Error);
        errors.chain(source.state.fault()).min_by_key(|found| found.location).cloned()
    }
}

/// What the CL data requires, in order, kept until every reading of the program has taken it.
#[derive(Debug)]
struct Kept<T> {
    queue: VecDeque<T>,
    /// Number of those before the first that is kept.
    gone: u64,
}

impl<T: Clone> Kept<T> {
    fn push(&mut self, value: T) {
        self.queue.push_back(value);
    }

    /// Number of all so far.
    fn count(&self) -> u64 {
        self.gone + self.queue.len() as u64
    }

    /// The one of this number, if it is known; the number becomes that of the next. `alone`: no other reading needs it.
    #[inline]
    fn take(&mut self, number: &mut u64, alone: bool) -> Option<T> {
        if alone {
            while self.gone < *number {
                self.queue.pop_front()?;
                self.gone += 1;
            }
        }
        let found = match alone {
            true => self.queue.pop_front(),
            false => self.queue.get(usize::try_from(*number - self.gone).ok()?).cloned(),
        }?;
        self.gone += u64::from(alone);
        *number += 1;
        Some(found)
    }
}

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self { queue: VecDeque::new(), gone: 0 }
    }
}

/// Unit of the CL data, from the records before its first motion.
pub(super) fn units_of(data: &mut dyn ClData, options: &ReadingOptions) -> io::Result<Option<Units>> {
    let mut reader = ClReader::new(data.text()?, options.clone());
    let mut moved = false;
    while !moved && reader.units().is_none() {
        match reader.next_event()? {
            Some((_, event)) => moved = matches!(event, Event::Motion(_)),
            None => break,
        }
    }
    Ok(reader.units())
}
