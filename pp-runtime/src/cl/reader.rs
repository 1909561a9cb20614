//! The reader of CL data: bytes to events and diagnostics.

use std::borrow::Cow;
use std::io::{self, Read, Seek};

use super::batch::{Batch, FileFacts, More, NO_EVENT};
use super::diagnostics::Faults;
use super::dialect::Dialect;
use super::meaning::{ArcVote, Contradictions, FrameVote, QueuedEvent, ReadingOptions, RecordInterpreter, StatedFrame};
use super::record::{
    CatiaMatrix, Record, Shapes, SubprogramRecord, comment_dialect, joined_record, parse, read_comment, record_dialect,
};
use super::subprogram::{self, KeptStatement, Subprograms, call_inside};
use super::text::{Beginning, ClFault, LONGEST_STATEMENT, Lexer, Span, Statement, StatementKind, decoded};
use crate::diag::code::cl;
use crate::diag::{Diagnostic, Severity};
use crate::program::{Event, Location, ToolMotion, Units};
use crate::shortcut::Shortcut;

/// CL text that can be read more than once: a file, or bytes in memory.
pub trait ReadSeek: Read + Seek {}

impl<T: Read + Seek + ?Sized> ReadSeek for T {}

/// If the unit mm is given by the caller only and no cutter of the file reaches this diameter, the file seems to be in
/// inch: an error, or a warning if the unit is given for this file.
const SMALLEST_LARGEST_CUTTER_MM: f64 = 1.5;

/// Reads CL data and returns its events one by one.
///
/// Input: bytes of a CL file. Output: events in mm and rad in the workpiece frame, and diagnostics with line and
/// column.
pub struct ClReader<R> {
    lexer: Lexer<R>,
    shapes: Shapes,
    interpreter: RecordInterpreter,
    matrix: CatiaMatrix,
    faults: Faults,
    progress: Progress,
    records: u64,
    /// Statement that holds the text of the queued events.
    statement: Option<Statement>,
    subprograms: Subprograms,
    /// Statement of a subprogram that holds that text, where the events come from a subprogram.
    kept: Option<KeptStatement>,
    /// Text of the event that was returned last, if it is not UTF-8 in the file.
    decoded: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Progress {
    Unread,
    Reading,
    Done,
}

impl<R: Read> ClReader<R> {
    /// Returns a reader of `input`; nothing is read yet.
    pub fn new(input: R, options: ReadingOptions) -> Self {
        ClReader {
            lexer: Lexer::new(input, options.columns),
            shapes: Shapes::default(),
            interpreter: RecordInterpreter::new(options),
            matrix: CatiaMatrix::default(),
            faults: Faults::default(),
            progress: Progress::Unread,
            records: 0,
            statement: None,
            subprograms: Subprograms::default(),
            kept: None,
            decoded: String::new(),
        }
    }

    /// Returns the next event with the place of the first byte of its statement, or `None` at the end of the file.
    ///
    /// After the first error the rest of the file is read for diagnostics only and `None` is returned; see
    /// [`failed`](Self::failed).
    pub fn next_event(&mut self) -> io::Result<Option<(Location, Event<'_>)>> {
        let mut next = [NO_EVENT];
        if self.straights(&mut next) == 0 && !self.other(&mut next[0])? {
            return Ok(None);
        }
        let [(here, mut queued)] = next;
        let mut in_file = true;
        if let QueuedEvent::Text(_, at) = &mut queued
            && let Cow::Owned(text) = decoded(&self.text()[at.start..at.end])
        {
            (self.decoded, in_file) = (text, false);
            *at = Span { start: 0, end: self.decoded.len() };
        }
        let text = if in_file { self.text() } else { self.decoded.as_bytes() };
        let event = queued.event(text, self.interpreter.options(), self.interpreter.kept_for_events());
        Ok(Some((here, event)))
    }

    /// Reads the events of a batch: as many as it holds, or the rest. With the last of them come the facts about the
    /// file.
    pub(super) fn fill(&mut self, batch: &mut Batch) {
        batch.clear();
        loop {
            let straights = self.straights(batch.free_places());
            batch.take_places(straights);
            let Some(place) = batch.free_places().first_mut() else { return };
            let found = self.other(place);
            if self.add_other(found, batch) == More::No {
                return;
            }
        }
    }

    /// Adds what is no straight motion to a batch; an event is in its place there. Says whether the batch takes more.
    #[inline(never)]
    fn add_other(&self, found: io::Result<bool>, batch: &mut Batch) -> More {
        match found {
            Ok(true) => batch.take_place_with(self.text(), || self.interpreter.kept_for_events()),
            Ok(false) => batch.end(Ok(self.facts())),
            Err(error) => batch.end(Err(error)),
        }
    }

    /// The text of the queued events.
    fn text(&self) -> &[u8] {
        match (&self.kept, &self.statement) {
            (Some(kept), _) => self.subprograms.text(kept),
            (None, Some(statement)) => self.lexer.text(statement),
            (None, None) => &[],
        }
    }

    /// Takes the next statements as long as each is a GOTO on a line of its own that is a straight motion, as nearly
    /// every one is, and there are places for their events; returns their number.
    #[inline(never)]
    fn straights(&mut self, places: &mut [(Location, QueuedEvent)]) -> usize {
        // A straight motion changes nothing that this depends on.
        if !self.takes_lines() || !self.interpreter.is_straight() {
            return 0;
        }
        let mut taken = 0;
        for place in places {
            let Some((line, point)) = self.shapes.next_goto(&mut self.lexer) else { break };
            let here = self.count_line();
            match self.interpreter.straight(&point, here) {
                Ok(motion) => *place = (here, QueuedEvent::Plain(Event::Motion(ToolMotion::Move(motion)))),
                Err(fault) => {
                    self.faults.add(*fault, &self.lexer.last_line(line), &self.lexer);
                    break;
                }
            }
            taken += 1;
        }
        taken
    }

    /// Whether a record on a line of its own may be read in one pass: it is executed, and no event is queued before it.
    #[inline(always)]
    fn takes_lines(&self) -> bool {
        Shortcut::LinesOfNumbers.is_on()
            && self.progress == Progress::Reading
            && !self.interpreter.has_events()
            && !self.matrix.is_open()
            && !self.subprograms.is_open()
            && !self.subprograms.is_running()
            && !self.faults.failed()
    }

    /// Counts the record of the line read last, and returns its place. Its events have no text.
    #[inline(always)]
    fn count_line(&mut self) -> Location {
        self.records += 1;
        Location { line: self.lexer.lines(), column: 1 }
    }

    /// Notes what is wrong with a record, and its warnings.
    #[inline(never)]
    fn note_faults(&mut self, taken: Result<(), ClFault>, statement: &Statement) {
        if let Err(fault) = taken {
            self.faults.add(fault, statement, &self.lexer);
        }
        for (location, fault) in self.interpreter.take_faults() {
            match location {
                Some(location) => self.faults.add_at(fault, location, 1),
                None => self.faults.add(fault, statement, &self.lexer),
            }
        }
    }

    /// Makes the next event at its place, whatever it is. Says whether there is one.
    #[inline(never)]
    fn other(&mut self, place: &mut (Location, QueuedEvent)) -> io::Result<bool> {
        loop {
            if let Some(event) = self.interpreter.next_event()
                && !self.faults.failed()
            {
                *place = event;
                return Ok(true);
            }
            match self.progress {
                Progress::Unread => self.begin()?,
                Progress::Reading if self.subprograms.is_running() => self.run_kept(),
                Progress::Reading => self.read_next()?,
                Progress::Done => return Ok(false),
            }
        }
    }

    /// Errors and warnings so far, in the order found. The first 20 of a kind are listed; at the end of the file one
    /// more gives the number of the others.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.faults.diagnostics()
    }

    /// Whether an error was found; then nothing may be posted.
    pub fn failed(&self) -> bool {
        self.faults.failed()
    }

    /// Unit of the file: as stated in it so far, else as given in the options.
    pub fn units(&self) -> Option<Units> {
        self.interpreter.units().known()
    }

    /// Whether the unit is given in the options and not stated in the file.
    pub fn units_are_only_given(&self) -> bool {
        self.interpreter.units().are_only_given()
    }

    /// CAM system, as given in the options, else as the first record or comment that identifies one.
    pub fn dialect(&self) -> Dialect {
        self.interpreter.dialect()
    }

    /// Workpiece frame: the first frame stated in the file.
    pub fn frame(&self) -> Option<&StatedFrame> {
        self.interpreter.coordinates().workpiece().frame()
    }

    /// First frame of each set-up, of those that have one.
    pub fn set_up_frames(&self) -> impl Iterator<Item = (u32, &StatedFrame)> {
        self.interpreter.coordinates().workpiece().of_set_ups()
    }

    /// Votes on the sense of the arcs read so far.
    pub fn arcs(&self) -> ArcVote {
        self.interpreter.votes().count(self.interpreter.options().circle_sense.is_some())
    }

    /// Number of different frames stated so far.
    pub fn different_frames(&self) -> usize {
        self.interpreter.coordinates().workpiece().different()
    }

    /// How the points after frames other than the first are read.
    pub fn frame_vote(&self) -> FrameVote {
        self.interpreter.coordinates().workpiece().vote()
    }

    /// Number of changes of CSYS (SolidWorks CAM) so far.
    pub fn setup_changes(&self) -> u64 {
        self.interpreter.coordinates().set_up().changes()
    }

    /// Whether the CAM system asks for inverse-time feed.
    pub fn asks_for_inverse_time(&self) -> bool {
        self.interpreter.asks_for_inverse_time()
    }

    /// Number of frames stated so far, repeated ones included.
    pub fn frames_stated(&self) -> u64 {
        self.interpreter.coordinates().workpiece().stated()
    }

    /// Number of statements so far, without comments.
    pub fn records(&self) -> u64 {
        self.records
    }

    /// Number of motions so far.
    pub fn motions(&self) -> u64 {
        self.interpreter.path().motions()
    }

    /// Number of lines so far.
    pub fn lines(&self) -> u64 {
        self.lexer.lines()
    }

    /// Number of tool axes so far that had to be normalised by more than rounding.
    pub fn normalised_axes(&self) -> u64 {
        self.interpreter.axis().normalised()
    }

    /// The facts about the file, at its end.
    pub(super) fn facts(&self) -> FileFacts {
        FileFacts {
            units: self.units(),
            units_only_given: self.units_are_only_given(),
            states_frame: self.frame().is_some(),
            dialect: self.dialect(),
            arcs: self.arcs(),
            frames: self.frame_vote(),
            setup_changes: self.setup_changes(),
            inverse_time: self.asks_for_inverse_time(),
            lines: self.lines(),
            diagnostics: self.diagnostics().to_vec(),
            failed: self.failed(),
        }
    }

    fn begin(&mut self) -> io::Result<()> {
        let (text, help) = match self.lexer.begin()? {
            Beginning::Text => {
                self.progress = Progress::Reading;
                return Ok(());
            }
            Beginning::Binary => (
                "this is not a text file: it contains NUL bytes",
                "output the CL data as text (APT source, CLS); save UTF-16 text as UTF-8",
            ),
            Beginning::Empty => ("the file is empty", "check whether the CAM system wrote it completely"),
        };
        self.faults.add_about_file(cl::FILE, Severity::Error, Location { line: 1, column: 1 }, text.into(), help);
        self.progress = Progress::Done;
        Ok(())
    }

    /// Reads the next statement, whatever it is.
    fn read_next(&mut self) -> io::Result<()> {
        if self.takes_lines()
            && let Some((line, record)) = self.shapes.next(&mut self.lexer)
        {
            let here = self.count_line();
            self.take_numbers(&record, here, &self.lexer.last_line(line));
            return Ok(());
        }
        let Some(statement) = self.lexer.next()? else {
            self.finish();
            return Ok(());
        };
        if self.takes_lines()
            && let Some(record) = self.shapes.joined(&self.lexer, &statement)
        {
            self.records += 1;
            self.take_numbers(&record, self.lexer.locate(&statement, 0).0, &statement);
            return Ok(());
        }
        self.read(&statement);
        Ok(())
    }

    /// Takes a record whose statement is a word and numbers.
    fn take_numbers(&mut self, record: &Record<'_>, here: Location, statement: &Statement) {
        (self.statement, self.kept) = (Some(*statement), None);
        let taken = self.interpreter.take(record, here);
        self.note_faults(taken, statement);
    }

    fn read(&mut self, statement: &Statement) {
        self.statement = Some(*statement);
        self.kept = None;
        let text = self.lexer.text(statement);
        let record = match statement.kind {
            StatementKind::Code => {
                self.records += 1;
                if let Err(fault) = self.matrix.abandon() {
                    self.faults.add(fault, statement, &self.lexer);
                }
                self.interpreter.note_dialect(record_dialect(text));
                return self.read_record(statement, self.lexer.locate(statement, 0).0);
            }
            StatementKind::Comment => {
                self.interpreter.note_dialect(comment_dialect(text));
                let mut lines = self.lexer.joined_lines(statement);
                match lines.find_map(|(offset, line)| joined_record(text, offset, line)) {
                    Some(swallowed) => Err(swallowed),
                    None => read_comment(text, &mut self.matrix),
                }
            }
            StatementKind::TooLong => Err(cl::SYNTAX.cl_fault(
                "statement too long",
                Span::WHOLE,
                format!("this statement is longer than {} bytes", LONGEST_STATEMENT),
                "check whether this file is CL data, and whether its line ends were lost",
            )),
            StatementKind::Unfinished => Err(cl::FILE.cl_fault(
                "unfinished statement",
                Span { start: 0, end: text.len() },
                "the file ends after the `$` that continues this statement",
                "check whether the CAM system wrote the file completely",
            )),
        };
        let taken = match &record {
            Ok(record) => self.interpreter.take(record, self.lexer.locate(statement, 0).0),
            Err(_) => Ok(()),
        };
        if let Some(fault) = record.err().or(taken.err()) {
            self.faults.add(fault, statement, &self.lexer);
        }
    }

    /// Reads a statement that is not a comment.
    fn read_record(&mut self, statement: &Statement, here: Location) {
        let text = self.lexer.text(statement);
        let mut lines = self.lexer.joined_lines(statement);
        let record = parse(text, self.interpreter.options().given_meanings()).and_then(|record| {
            let lost = |(offset, line)| joined_record(text, offset, line);
            let lost = if record.takes_anything() { lines.find_map(lost) } else { None };
            lost.map_or(Ok(record), Err)
        });
        let taken = record.and_then(|record| match record {
            Record::Subprogram(SubprogramRecord::Define(name)) => self.subprograms.define(name),
            Record::Subprogram(SubprogramRecord::End) => self.subprograms.end(),
            _ if self.subprograms.is_open() => self.subprograms.keep(text, here),
            Record::Subprogram(SubprogramRecord::Call { name, at }) => {
                self.interpreter.take(&record, here)?;
                self.subprograms.call(name, at, here)
            }
            record => self.interpreter.take(&record, here),
        });
        drop(lines);
        self.note_faults(taken, statement);
    }

    /// Runs the next statement of the subprogram that is being called.
    fn run_kept(&mut self) {
        let Some(kept) = self.subprograms.next() else { return };
        self.kept = Some(kept);
        let text = self.subprograms.text(&kept);
        let place = |at: Span| {
            let column = u32::try_from(at.start).unwrap_or(u32::MAX);
            let location = Location { column: kept.location().column.saturating_add(column), ..kept.location() };
            (location, text.len().saturating_sub(at.start))
        };
        let taken = parse(text, self.interpreter.options().given_meanings()).and_then(|record| match record {
            Record::Subprogram(SubprogramRecord::Call { at, .. }) => Err(call_inside(at)),
            record => self.interpreter.take(&record, kept.location()),
        });
        let of_record = taken.err().map(|fault| (None, fault));
        for (at, fault) in of_record.into_iter().chain(self.interpreter.take_faults()) {
            let (location, left) = at.map_or_else(|| place(fault.at), |at| (at, 1));
            self.faults.add_at(fault, location, left);
        }
    }

    /// Makes the checks that need the whole file.
    fn finish(&mut self) {
        self.progress = Progress::Done;
        let unfinished = self.interpreter.finish();
        let fault = unfinished.err().or_else(|| self.subprograms.is_open().then(subprogram::unfinished));
        if let (Some(fault), Some(statement)) = (fault, &self.statement) {
            self.faults.add(fault, statement, &self.lexer);
        }
        if let Some(statement) = self.statement {
            self.note_faults(Ok(()), &statement);
        }
        self.count_votes();
        let unconfirmed: Vec<_> = self.interpreter.coordinates().workpiece().unconfirmed().collect();
        for (location, fault) in unconfirmed {
            self.faults.add_at(fault, location, 1);
        }
        let reading = &self.interpreter;
        let normalised = reading.axis().normalised();
        if normalised > 0 {
            let text = format!(
                "{normalised} tool axes differ from length 1 by more than 0.00001 and were normalised; this is the first"
            );
            let help = "nothing needs to be done if their directions are right; with more digits of i, j, k the warning is absent";
            self.faults.add_about_file(cl::TOOL_AXIS, Severity::Warning, reading.axis().first_normalised(), text, help);
        }
        if let Some((first, calls)) = self.subprograms.calls() {
            let text = format!(
                "calls of subprograms (CALSUB): {calls}; their records are written in full at each call, since the program has no \
                 subprograms of the control; this is the first"
            );
            let help = "nothing needs to be done: each call is planned and checked where it is, with its own tool axis and state";
            self.faults.add_about_file(cl::SUBPROGRAM, Severity::Warning, first, text, help);
        }
        if let Some((largest_mm, first)) = reading.tool().largest_cutter()
            && reading.units().are_only_given()
            && reading.units().known() == Some(Units::Millimetres)
            && largest_mm < SMALLEST_LARGEST_CUTTER_MM
        {
            let text = format!(
                "the largest cutter has a diameter of {}: is this file in inch?",
                Units::Millimetres.length(largest_mm)
            );
            let (severity, help) = match reading.options().units_confirmed {
                true => (
                    Severity::Warning,
                    "if it is, post it with `--units in`; it is read in mm, as given by `--units mm`",
                ),
                false => (Severity::Error, "add `--units in`, or `--units mm` if its cutters are as small as that"),
            };
            self.faults.add_about_file(cl::UNITS, severity, first, text, help);
        }
        if reading.path().motions() == 0 && !self.faults.failed() {
            let text = "the file contains no motion: no GOTO was found".into();
            let help = "check whether the tool path was generated in the CAM system before it was output";
            self.faults.add_about_file(cl::FILE, Severity::Error, Location { line: 1, column: 1 }, text, help);
        }
        self.faults.conclude();
    }

    /// Reports arcs whose sense, by their form or as given, contradicts the feed lines before and after them.
    fn count_votes(&mut self) {
        let given = self.interpreter.options().circle_sense.is_some();
        for Contradictions { first, against, decided, is_sense_wrong } in self.interpreter.votes().contradictions() {
            let severity = if is_sense_wrong { Severity::Error } else { Severity::Warning };
            let sense = if given { "the sense that `--circle-sense` gives" } else { "the sense of their CIRCLE" };
            let text = format!(
                "{against} of {decided} arcs with a tangent line before or after them contradict {sense}; this is the first"
            );
            let help = match (is_sense_wrong, given) {
                (true, true) => "leave out `--circle-sense` and `[cl] circle_sense`, or give the other sense",
                (true, false) => "if the CAM system uses the other sense, add `--circle-sense cw` or `ccw`",
                (false, _) => "correct if the path reverses here in a cusp; else check the arc in the CAM system",
            };
            self.faults.add_about_file(cl::ARC, severity, first, text, help);
        }
    }
}
