//! Queue of events and warnings of the last record.

use std::collections::VecDeque;

use super::options::ReadingOptions;
use crate::cl::record::OwnStatement;
use crate::cl::text::{ClFault, Span};
use crate::program::{BlockPlace, Event, Interruption, Location, NewStart, Spline, TextKind, ToolMotion};

/// Event that a text becomes.
#[derive(Debug, Clone, Copy)]
pub(crate) enum TextUse {
    Operation,
    Insert,
    Text(TextKind),
}

/// A queued event. Its text, if any, is still in the statement; a spline, and the name of an operation that has waited,
/// are in the interpreter.
#[derive(Debug, Clone, Copy)]
pub(crate) enum QueuedEvent {
    Plain(Event<'static>),
    Text(TextUse, Span),
    /// Block of a statement of the shop, by its index in the options and its own.
    Own(usize, usize),
    Spline,
    WaitingName,
}

/// What the interpreter keeps for its events.
pub(crate) struct KeptForEvents<'a> {
    pub(crate) curve: Spline<'a>,
    pub(crate) name: &'a [u8],
}

impl QueuedEvent {
    /// The event. `text`: where the text of the event is; `kept`: what is in the interpreter.
    pub(crate) fn event<'a>(self, text: &'a [u8], options: &'a ReadingOptions, kept: KeptForEvents<'a>) -> Event<'a> {
        match self {
            Self::Plain(event) => event,
            Self::Text(used, at) => {
                let text = &text[at.start..at.end];
                match used {
                    TextUse::Operation => Event::NewStart(NewStart::Operation(text)),
                    TextUse::Insert => Event::Interruption(Interruption::Insert(text, BlockPlace::InOrder)),
                    TextUse::Text(kind) => Event::Text(kind, text),
                }
            }
            Self::Own(index, block) => {
                let own = options.given_meanings().own_at(index);
                let text = own.and_then(|own| own.blocks().get(block)).map_or(&b""[..], |block| block.as_bytes());
                Event::Interruption(match own {
                    Some(own) if own.probes() => Interruption::Probe(own.blocks()),
                    own => Interruption::Insert(text, own.map(OwnStatement::place).unwrap_or_default()),
                })
            }
            Self::Spline => Event::Motion(ToolMotion::Spline(kept.curve)),
            Self::WaitingName => Event::NewStart(NewStart::Operation(kept.name)),
        }
    }
}

/// Events, warnings and faults of the last record, in order.
#[derive(Debug, Default)]
pub(crate) struct EventQueue {
    events: VecDeque<(Location, QueuedEvent)>,
    /// With the place of those that are not of the last record.
    faults: Vec<(Option<Location>, ClFault)>,
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
        self.faults.push((None, fault.warning()));
    }

    /// Adds the fault of a record before the last one.
    pub(crate) fn refuse(&mut self, here: Location, fault: ClFault) {
        self.faults.push((Some(here), fault));
    }

    pub(crate) fn take_faults(&mut self) -> impl Iterator<Item = (Option<Location>, ClFault)> + '_ {
        self.faults.drain(..)
    }
}
