//! Events of CL data in batches: read in this thread, or ahead in a thread of their own.
//!
//! A batch borrows nothing, so that it may come from another thread: the texts of its events are kept with it. The
//! events and the order are those of [`ClReader::next_event`] either way.

use std::io::{self, Read, SeekFrom};
use std::ops::ControlFlow;
use std::panic;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{self, JoinHandle};

use super::batch::{Batch, FileFacts};
use super::meaning::ReadingOptions;
use super::reader::{ClReader, ReadSeek};
use crate::program::{Event, Location};

/// Number of batches with which a reader in another thread begins; one more is in use.
const BATCHES: usize = 8;

/// Number of used batches that go back to the reader together: it is woken once for all of them.
const HANDED_BACK: usize = BATCHES / 2;

/// What fills batches.
trait Batches {
    /// Replaces a batch that has been used by the next one.
    fn next(&mut self, batch: &mut Batch);
}

/// A reader in this thread.
struct Here<R>(ClReader<R>);

impl<R: Read> Batches for Here<R> {
    fn next(&mut self, batch: &mut Batch) {
        self.0.fill(batch);
    }
}

/// A reader in a thread of its own, which goes on while the batches before are used. Dropped early, it stops.
struct Ahead {
    filled: Option<Receiver<Batch>>,
    /// Batches that have been used.
    used: Vec<Batch>,
    empty: Option<Sender<Vec<Batch>>>,
    thread: Option<JoinHandle<()>>,
}

impl Ahead {
    fn start(input: impl Read + Send + 'static, options: ReadingOptions) -> io::Result<Self> {
        let (empty, emptied): (Sender<Vec<Batch>>, Receiver<Vec<Batch>>) = channel();
        let (full, filled): (SyncSender<Batch>, Receiver<Batch>) = sync_channel(BATCHES);
        let body = move || {
            let mut reader = ClReader::new(input, options);
            let mut free: Vec<_> = (0..BATCHES).map(|_| Batch::default()).collect();
            loop {
                let Some(mut batch) = free.pop() else {
                    match emptied.recv() {
                        Ok(used) => free = used,
                        Err(_) => return,
                    }
                    continue;
                };
                reader.fill(&mut batch);
                let is_last = batch.end.is_some();
                if full.send(batch).is_err() || is_last {
                    return;
                }
            }
        };
        let thread = thread::Builder::new().name("reader".to_owned()).spawn(body)?;
        Ok(Self {
            filled: Some(filled),
            used: Vec::with_capacity(HANDED_BACK),
            empty: Some(empty),
            thread: Some(thread),
        })
    }
}

impl Batches for Ahead {
    fn next(&mut self, batch: &mut Batch) {
        if let Some(Ok(filled)) = self.filled.as_ref().map(Receiver::recv) {
            self.used.push(std::mem::replace(batch, filled));
            if let (Some(empty), HANDED_BACK) = (&self.empty, self.used.len()) {
                let used = std::mem::replace(&mut self.used, Vec::with_capacity(HANDED_BACK));
                // After the last batch no one waits for them.
                let _ = empty.send(used);
            }
            return;
        }
        // The thread has ended although more was expected of it: it has panicked.
        match self.thread.take().map(JoinHandle::join) {
            Some(Err(panicked)) => panic::resume_unwind(panicked),
            _ => batch.end = Some(Err(io::ErrorKind::UnexpectedEof.into())),
        }
    }
}

impl Drop for Ahead {
    fn drop(&mut self) {
        (self.filled, self.empty) = (None, None);
        // It reads one batch more at most. If it has panicked after the last one that was used, nothing depends on it.
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

/// The events of CL data, one after the other.
pub(crate) struct ClEvents<'a> {
    batches: Box<dyn Batches + 'a>,
    options: ReadingOptions,
    batch: Batch,
    /// Number of events of the batch that have been used.
    used: usize,
    facts: Option<FileFacts>,
}

impl<'a> ClEvents<'a> {
    /// Reads in this thread.
    pub(crate) fn here(input: impl Read + 'a, options: ReadingOptions) -> Self {
        Self::of(Box::new(Here(ClReader::new(input, options.clone()))), options)
    }

    /// Reads ahead in a thread of its own.
    ///
    /// # Errors
    /// The thread cannot be started.
    pub(crate) fn ahead(input: impl Read + Send + 'static, options: ReadingOptions) -> io::Result<Self> {
        Ok(Self::of(Box::new(Ahead::start(input, options.clone())?), options))
    }

    fn of(batches: Box<dyn Batches + 'a>, options: ReadingOptions) -> Self {
        Self { batches, options, batch: Batch::default(), used: 0, facts: None }
    }

    /// Hands all events and the places of their statements to a function, up to the first that it stops at; returns
    /// what it stopped with.
    #[inline(always)]
    pub(crate) fn all<T>(
        &mut self,
        mut take: impl FnMut(Location, &Event<'_>) -> ControlFlow<T>,
    ) -> io::Result<Option<T>> {
        while self.next_batch()? {
            let Self { batch, options, used, .. } = self;
            let from = std::mem::replace(used, batch.count);
            for (index, place) in batch.places[from..batch.count].iter().enumerate() {
                if let ControlFlow::Break(stopped) = batch.hand(place, options, &mut take) {
                    *used = from + index + 1;
                    return Ok(Some(stopped));
                }
            }
        }
        Ok(None)
    }

    /// Hands the next event to a function; whether there was one.
    #[inline(always)]
    pub(crate) fn next(&mut self, take: impl FnOnce(Location, &Event<'_>)) -> io::Result<bool> {
        if self.used == self.batch.count && !self.next_batch()? {
            return Ok(false);
        }
        let place = &self.batch.places[self.used];
        self.used += 1;
        self.batch.hand(place, &self.options, take);
        Ok(true)
    }

    /// Gets the next batch; whether there is another event.
    #[inline(never)]
    fn next_batch(&mut self) -> io::Result<bool> {
        while self.facts.is_none() && self.used == self.batch.count {
            match self.batch.end.take() {
                Some(end) => self.facts = Some(end?),
                None => {
                    self.batches.next(&mut self.batch);
                    self.used = 0;
                }
            }
        }
        Ok(self.facts.is_none())
    }

    /// The facts about the file, once the last event has been used.
    #[inline]
    pub(crate) fn facts(&self) -> Option<&FileFacts> {
        self.facts.as_ref()
    }

    /// The same facts, to keep.
    pub(crate) fn into_facts(self) -> Option<FileFacts> {
        self.facts
    }
}

/// CL data that each pass reads from its start.
pub(crate) trait ClData {
    /// Its text.
    ///
    /// # Errors
    /// The input cannot be read from its start.
    fn text(&mut self) -> io::Result<Box<dyn Read + '_>>;

    /// Its events.
    ///
    /// # Errors
    /// As for the text.
    fn events(&mut self, options: ReadingOptions) -> io::Result<ClEvents<'_>> {
        Ok(ClEvents::here(self.text()?, options))
    }
}

/// CL data from the place where a stream is.
pub(crate) struct FromHere<'a> {
    input: &'a mut dyn ReadSeek,
    start: u64,
}

impl<'a> FromHere<'a> {
    /// # Errors
    /// The place is not known.
    pub(crate) fn new(input: &'a mut dyn ReadSeek) -> io::Result<Self> {
        let start = input.stream_position()?;
        Ok(Self { input, start })
    }
}

impl ClData for FromHere<'_> {
    fn text(&mut self) -> io::Result<Box<dyn Read + '_>> {
        self.input.seek(SeekFrom::Start(self.start))?;
        Ok(Box::new(&mut *self.input))
    }
}

#[cfg(test)]
mod tests {
    use super::super::batch::EVENTS;
    use super::*;

    /// Events as text, and the facts after them.
    fn all(mut events: ClEvents<'_>) -> (Vec<String>, Option<FileFacts>) {
        let mut found = Vec::new();
        let stopped = events.all(|here, event| {
            found.push(format!("{here:?} {event:?}"));
            ControlFlow::<()>::Continue(())
        });
        assert_eq!(stopped.expect("memory"), None);
        assert!(!events.next(|_, _| unreachable!("the end stays the end")).expect("memory"));
        (found, events.into_facts())
    }

    /// Points, arcs, texts and curves, more than a batch holds; then an error, if `fault`.
    fn data(fault: bool) -> String {
        let mut text = "PARTNO LONG\nUNITS/MM\nLOAD/TOOL,1\nFEDRAT/500,MMPM\nGOTO/0,0,9\n".to_owned();
        for index in 0..3 * EVENTS {
            text += &format!("GOTO/{index},0.5,{}\n", index % 7);
            if index % 97 == 0 {
                text +=
                    &format!("PPRINT POINT {index}\nCIRCLE/{index},5.5,{},0,0,1,5\nGOTO/{index},10.5,{0}\n", index % 7);
            }
            if index % 150 == 0 {
                text += "NURBS\nKNOT/1\nCNTRL/1,2,3\nCNTRL/4,5,6\nCNTRL/7,8,9\n";
            }
        }
        text + if fault { "GOTO/1,2\nGOTO/1,2,3\n" } else { "FINI\n" }
    }

    #[test]
    fn events_read_ahead_are_those_of_the_reader() {
        for fault in [false, true] {
            let data = data(fault);
            let mut reader = ClReader::new(data.as_bytes(), ReadingOptions::default());
            let mut expected = Vec::new();
            while let Some((here, event)) = reader.next_event().expect("memory") {
                expected.push(format!("{here:?} {event:?}"));
            }
            assert_eq!(reader.failed(), fault, "{:?}", reader.diagnostics());
            assert!(expected.len() > 3 * EVENTS);
            let facts = Some(reader.facts());
            let options = ReadingOptions::default();
            assert!(all(ClEvents::here(data.as_bytes(), options.clone())) == (expected.clone(), facts.clone()));
            let ahead = ClEvents::ahead(io::Cursor::new(data), options).expect("a thread");
            assert!(all(ahead) == (expected, facts));
        }
    }

    /// Input that cannot be read to its end.
    struct Broken(io::Cursor<String>);

    impl Read for Broken {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            match self.0.read(buffer)? {
                0 => Err(io::ErrorKind::PermissionDenied.into()),
                count => Ok(count),
            }
        }
    }

    #[test]
    fn an_error_of_the_input_comes_after_the_events_before_it() {
        let mut counts = Vec::new();
        for ahead in [false, true] {
            let input = Broken(io::Cursor::new(data(false)));
            let options = ReadingOptions::default();
            let mut events = match ahead {
                false => ClEvents::here(input, options),
                true => ClEvents::ahead(input, options).expect("a thread"),
            };
            let mut count = 0;
            let stopped = events.all(|_, _| {
                count += 1;
                ControlFlow::<()>::Continue(())
            });
            assert_eq!(stopped.expect_err("it ends early").kind(), io::ErrorKind::PermissionDenied);
            counts.push(count);
        }
        assert!(counts[0] > EVENTS);
        assert_eq!(counts[0], counts[1]);
    }

    #[test]
    fn who_stops_early_goes_on_where_that_was() {
        let mut events = ClEvents::ahead(io::Cursor::new(data(false)), ReadingOptions::default()).expect("a thread");
        let mut seen = 0;
        let stopped = events.all(|here, _| {
            seen += 1;
            if seen == 10 { ControlFlow::Break(here) } else { ControlFlow::Continue(()) }
        });
        let stopped = stopped.expect("memory").expect("more than ten events");
        let mut after = Location::default();
        assert!(events.next(|here, _| after = here).expect("memory"));
        assert!(after > stopped);
        // The thread still has much to read.
        drop(events);
    }
}
