//! Events that borrow nothing, in batches: they may come from another thread, with the facts about the file at their
//! end.

use std::io;

use super::dialect::Dialect;
use super::meaning::{ArcVote, FrameVote, KeptForEvents, QueuedEvent, ReadingOptions, TextUse};
use super::text::{Span, decoded};
use crate::diag::Diagnostic;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Event, Feed, Location, NewStart, Spline, Units};

/// Largest number of events of a batch.
pub(super) const EVENTS: usize = 256;

/// Bytes of texts after which a batch ends.
const TEXT_BYTES: usize = 1 << 14;

/// Facts about CL data, known at its end.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct FileFacts {
    pub(crate) units: Option<Units>,
    /// The file states no unit; `units` comes from the job or the configuration.
    pub(crate) units_only_given: bool,
    /// The file states a coordinate frame.
    pub(crate) states_frame: bool,
    pub(crate) dialect: Dialect,
    pub(crate) arcs: ArcVote,
    /// How the points after frames other than the first are read.
    pub(crate) frames: FrameVote,
    /// Number of changes of CSYS.
    pub(crate) setup_changes: u64,
    /// The CL data asks for inverse-time feed.
    pub(crate) inverse_time: bool,
    /// Number of lines.
    pub(crate) lines: u64,
    /// Errors and warnings, in the order found.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// An error was found.
    pub(crate) failed: bool,
}

/// What is at a place without an event.
pub(super) const NO_EVENT: (Location, QueuedEvent) =
    (Location { line: 0, column: 0 }, QueuedEvent::Plain(Event::NewStart(NewStart::Home)));

/// Whether a batch takes another event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum More {
    Yes,
    No,
}

/// Events, one after the other, and how they end.
#[derive(Debug, Default)]
pub(super) struct Batch {
    /// The place of a text counts in `text`. A curve is the last event, and is `curve`.
    pub(super) places: Vec<(Location, QueuedEvent)>,
    /// Number of events, in the first places.
    pub(super) count: usize,
    text: Vec<u8>,
    curve: OwnedCurve,
    /// After the last event of all: the facts about the file, or why no more can be read.
    pub(super) end: Option<io::Result<FileFacts>>,
}

/// A curve that borrows nothing; without points there is none.
#[derive(Debug)]
struct OwnedCurve {
    knots: Vec<f64>,
    points: Vec<Point3<f64>>,
    axis: UnitVector3<f64>,
    feed: Option<Feed>,
}

impl Default for OwnedCurve {
    fn default() -> Self {
        Self { knots: Vec::new(), points: Vec::new(), axis: Vector3::z_axis(), feed: None }
    }
}

impl Batch {
    pub(super) fn clear(&mut self) {
        self.places.resize(EVENTS, NO_EVENT);
        self.count = 0;
        self.text.clear();
        self.curve.knots.clear();
        self.curve.points.clear();
        self.end = None;
    }

    /// Where the next events are made.
    #[inline]
    pub(super) fn free_places(&mut self) -> &mut [(Location, QueuedEvent)] {
        &mut self.places[self.count..]
    }

    /// The events at so many of the free places are the next ones.
    #[inline]
    pub(super) fn take_places(&mut self, count: usize) {
        self.count += count;
    }

    /// The event at the first free place is the next one; it may have a text, or be a curve.
    pub(super) fn take_place_with<'a>(&mut self, text: &[u8], kept: impl FnOnce() -> KeptForEvents<'a>) -> More {
        match self.places.get_mut(self.count).map(|(_, event)| event) {
            Some(QueuedEvent::Text(_, at)) => {
                let start = self.text.len();
                self.text.extend_from_slice(decoded(&text[at.start..at.end]).as_bytes());
                *at = Span { start, end: self.text.len() };
            }
            Some(QueuedEvent::Spline) => {
                let Spline { knots, points, axis, feed } = kept().curve;
                self.curve.knots.extend_from_slice(knots);
                self.curve.points.extend_from_slice(points);
                (self.curve.axis, self.curve.feed) = (axis, feed);
            }
            Some(event @ QueuedEvent::WaitingName) => {
                let start = self.text.len();
                self.text.extend_from_slice(kept().name);
                *event = QueuedEvent::Text(TextUse::Operation, Span { start, end: self.text.len() });
            }
            _ => {}
        }
        self.count += 1;
        let has_room = self.text.len() < TEXT_BYTES && self.curve.points.is_empty();
        if has_room { More::Yes } else { More::No }
    }

    /// No event follows.
    pub(super) fn end(&mut self, end: io::Result<FileFacts>) -> More {
        self.end = Some(end);
        More::No
    }

    /// Hands the event at a place to a function.
    #[inline(always)]
    pub(super) fn hand<T>(
        &self,
        (here, queued): &(Location, QueuedEvent),
        options: &ReadingOptions,
        take: impl FnOnce(Location, &Event<'_>) -> T,
    ) -> T {
        let with_text;
        let event = match queued {
            QueuedEvent::Plain(event) => event,
            _ => {
                let OwnedCurve { knots, points, axis, feed } = &self.curve;
                let curve = Spline { knots, points, axis: *axis, feed: *feed };
                with_text = queued.event(&self.text, options, KeptForEvents { curve, name: &[] });
                &with_text
            }
        };
        take(*here, event)
    }
}
