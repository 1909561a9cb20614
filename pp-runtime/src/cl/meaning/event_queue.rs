//! Queue of events and warnings of the last record.

use std::collections::VecDeque;

use crate::cl::text::{ClFault, Span};
use crate::program::{Event, Location};

/// Kind of event that a text becomes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum TextUse {
    Name,
    MachineName,
    Operation,
    Message,
    Insert,
}

/// A queued event. Its text, if any, is still in the statement; a spline is in the interpreter.
#[derive(Debug, Clone, Copy)]
pub(crate) enum QueuedEvent {
    Plain(Event<'static>),
    Text(TextUse, Span),
    /// Block of a statement of the shop, by its index in the options.
    Own(usize),
    Spline,
}

/// Events and warnings of the last record, in order.
#[derive(Debug, Default)]
pub(crate) struct EventQueue {
    events: VecDeque<(Location, QueuedEvent)>,
    warnings: Vec<ClFault>,
}

impl EventQueue {
    #[inline]
    pub(crate) fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    #[inline]
    pub(crate) fn push(&mut self, here: Location, event: QueuedEvent) {
        self.events.push_back((here, event));
    }

    #[inline]
    pub(crate) fn pop(&mut self) -> Option<(Location, QueuedEvent)> {
        self.events.pop_front()
    }

    pub(crate) fn warn(&mut self, fault: ClFault) {
        self.warnings.push(fault.warning());
    }

    #[inline]
    pub(crate) fn has_warnings(&self) -> bool {
        !self.warnings.is_empty()
    }

    pub(crate) fn take_warnings(&mut self) -> impl Iterator<Item = ClFault> + '_ {
        self.warnings.drain(..)
    }
}
