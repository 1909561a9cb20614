//! Records that stand between the first motion of an operation and the next: they wait with that motion, whose approach
//! depends on both.

use crate::kinematics::Pose;
use crate::program::{Coolant, Dwell, Event, Location, Spindle};

use super::fault::Fault;
use super::planner::{Planned, Stop, stop};

/// More records than this between two motions are no habit of a CAM system; it bounds the memory.
const MOST: usize = 10_000;

/// Text of so many bytes is kept while records wait.
const MOST_TEXT: usize = 1 << 20;

/// One that waits.
#[derive(Debug, Clone, Copy)]
enum Record {
    Spindle(Spindle),
    Coolant(Coolant),
    Delay(Dwell),
    From(Pose),
    /// Range in the texts.
    Message(usize, usize),
}

/// Those that wait, in their order.
#[derive(Debug, Default)]
pub(super) struct Waiting {
    records: Vec<(Location, Record)>,
    texts: Vec<u8>,
}

impl Waiting {
    /// Keeps an event, if it is one that can wait; whether it is.
    ///
    /// # Errors
    /// [`Stop`] if too many wait already.
    pub(super) fn keep(&mut self, at: Location, event: &Event<'_>) -> Result<bool, Stop> {
        let start = self.texts.len();
        let record = match *event {
            Event::Spindle(spindle) => Record::Spindle(spindle),
            Event::Coolant(coolant) => Record::Coolant(coolant),
            Event::Delay(dwell) => Record::Delay(dwell),
            Event::From(pose) => Record::From(pose),
            Event::Message(text) => Record::Message(start, start + text.len()),
            _ => return Ok(false),
        };
        if self.records.len() >= MOST || start >= MOST_TEXT {
            let fault = Fault::new("too many records stand between the first motion of an operation and the next")
                .help("the approach to a first point depends on the second: move these records behind both");
            return Err(stop(at, fault));
        }
        if let Event::Message(text) = event {
            self.texts.extend_from_slice(text);
        }
        self.records.push((at, record));
        Ok(true)
    }

    /// Gives them back as they came.
    pub(super) fn replay(&mut self, mut to: impl FnMut(Location, &Event<'_>) -> Planned) -> Planned {
        for (at, record) in self.records.drain(..) {
            let event = match record {
                Record::Spindle(spindle) => Event::Spindle(spindle),
                Record::Coolant(coolant) => Event::Coolant(coolant),
                Record::Delay(dwell) => Event::Delay(dwell),
                Record::From(pose) => Event::From(pose),
                Record::Message(start, end) => Event::Message(&self.texts[start..end]),
            };
            to(at, &event)?;
        }
        self.texts.clear();
        Ok(())
    }
}
