//! CL data: APT source and CLS files to machine-independent events.
//!
//! Bytes go through `lexer` (statements), `parse` and `comment` (typed [`Record`]s) and `interpret` (units and
//! modes) to the [`Event`]s of [`program`](crate::program). Memory is constant: one read buffer, one buffer for joined
//! statements, nothing allocated for a record that is understood.
//!
//! Reading never stops at a fault; all faults of a file are reported in one run, but no event is returned behind the
//! first. What is not understood is refused, never skipped: it might move the tool. The same bytes give the same events
//! and diagnostics, whatever the size of the reads, so a file may be read twice.

mod arcs;
mod args;
mod axis;
mod change;
mod circle;
mod comment;
mod cycle;
mod fault;
mod forms;
mod frame;
mod holes;
mod interpret;
mod lexer;
mod number;
mod options;
mod parse;
mod path;
pub mod record;
mod spindle;
mod spline;
mod state;
mod subprogram;
mod tools;
mod vector;
mod words;
mod write;

#[cfg(test)]
mod tests;

pub use arcs::{ArcVote, Sense};
pub use frame::Frame;
pub use holes::CycleArg;
pub use options::{ClPoint, FeedLabel, Frames, Insert, Options};
pub use record::Record;
pub use words::{list as list_words, not_inert};

use crate::diag::{Diagnostic, Severity};
use crate::program::{Event, Location, Spline, Units};
use fault::{Fault, Faults, Span};
use interpret::{Interpreter, Meant, Pending};
use lexer::{Beginning, Kind, Lexer, Statement};
use spline::Curve;
use std::io::{self, Read};
use subprogram::{Kept, Subprograms};

/// Cutters that are all smaller than this, in a file whose millimetres are only claimed, are inches.
const SMALLEST_LARGEST_CUTTER_MM: f64 = 1.5;

/// The CAM system that wrote a file, by the evidence in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dialect {
    /// No evidence (yet).
    #[default]
    Generic,
    /// Siemens NX: `TOOL PATH/`.
    Nx,
    /// CATIA: `$$*CATIA0`.
    Catia,
    /// PTC Creo: `$$->`.
    Creo,
    /// SolidWorks CAM: `UNIT/`, `CSYS/`, `TRNTYP/`, `CSI_`.
    SolidWorks,
    /// ISO 4343; no evidence tells, it must be given.
    Iso,
}

impl Dialect {
    /// Names as on the command line.
    pub const NAMES: [(&'static str, Dialect); 5] = [
        ("nx", Dialect::Nx),
        ("catia", Dialect::Catia),
        ("creo", Dialect::Creo),
        ("solidworks", Dialect::SolidWorks),
        ("iso", Dialect::Iso),
    ];

    /// For people.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Dialect::Generic => "no CAM system that is known here",
            Dialect::Nx => "NX",
            Dialect::Catia => "CATIA",
            Dialect::Creo => "Creo",
            Dialect::SolidWorks => "SolidWorks CAM",
            Dialect::Iso => "ISO 4343",
        }
    }
}

/// Reads CL data and returns its events one by one.
pub struct Reader<R> {
    lexer: Lexer<R>,
    interpreter: Interpreter,
    matrix: comment::Matrix,
    faults: Faults,
    progress: Progress,
    records: u64,
    /// The statement whose bytes the waiting events point into.
    statement: Option<Statement>,
    subprograms: Subprograms,
    /// The statement of a subprogram whose bytes the waiting events point into, instead.
    kept: Option<Kept>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Progress {
    Unread,
    Reading,
    Done,
}

impl<R: Read> Reader<R> {
    /// A reader of `input`; nothing is read yet.
    pub fn new(input: R, options: Options) -> Self {
        Reader {
            lexer: Lexer::new(input, options.columns),
            interpreter: Interpreter::new(options),
            matrix: comment::Matrix::default(),
            faults: Faults::default(),
            progress: Progress::Unread,
            records: 0,
            statement: None,
            subprograms: Subprograms::default(),
            kept: None,
        }
    }

    /// The next event with the place of its statement's first byte, or `None` at the end.
    ///
    /// After the first error the rest of the file is read for diagnostics only and `None` is returned; ask
    /// [`failed`](Self::failed) then.
    pub fn next_event(&mut self) -> io::Result<Option<(Location, Event<'_>)>> {
        let (location, pending) = loop {
            if let Some(event) = self.interpreter.queue.pop_front()
                && !self.faults.failed()
            {
                break event;
            }
            match self.progress {
                Progress::Unread => self.begin()?,
                Progress::Reading if self.subprograms.is_running() => self.run_kept(),
                Progress::Reading => match self.lexer.next()? {
                    // Nearly every statement: a point, and an event that waits for nothing.
                    Some(statement) if self.is_plain_goto(&statement) => {
                        if let Some(found) = self.read_goto(&statement) {
                            return Ok(Some(found));
                        }
                    }
                    Some(statement) => self.read(&statement),
                    None => self.finish(),
                },
                Progress::Done => return Ok(None),
            }
        };
        let text = |at: Span| match (&self.kept, &self.statement) {
            (Some(kept), _) => &self.subprograms.text(kept)[at.start..at.end],
            (None, Some(statement)) => &self.lexer.text(statement)[at.start..at.end],
            (None, None) => &[],
        };
        let event = match pending {
            Pending::Plain(event) => event,
            Pending::Text(Meant::Name, at) => Event::Name(text(at)),
            Pending::Text(Meant::MachineName, at) => Event::MachineName(text(at)),
            Pending::Text(Meant::Operation, at) => Event::Operation(text(at)),
            Pending::Text(Meant::Message, at) => Event::Message(text(at)),
            Pending::Text(Meant::Insert, at) => Event::Insert(text(at)),
            Pending::Spline => {
                let Curve { knots, points, axis, feed, .. } = &self.interpreter.complete;
                Event::Spline(Spline { knots, points, axis: *axis, feed: *feed })
            }
        };
        Ok(Some((location, event)))
    }

    /// Errors and warnings so far, in the order found. Of one kind the first 20 are kept; at the end one more says how
    /// many others there were.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        self.faults.diagnostics()
    }

    /// Whether there was an error; nothing may be posted then.
    pub fn failed(&self) -> bool {
        self.faults.failed()
    }

    /// The unit of the file as found so far, else as given.
    pub fn units(&self) -> Option<Units> {
        self.interpreter.units()
    }

    /// Whether the unit is known from the options only.
    pub fn units_are_only_given(&self) -> bool {
        self.interpreter.units_are_only_given()
    }

    /// The CAM system by the evidence so far; the first evidence decides.
    pub fn dialect(&self) -> Dialect {
        self.interpreter.dialect()
    }

    /// The workpiece frame: the first frame stated so far.
    pub fn frame(&self) -> Option<&Frame> {
        self.interpreter.workpiece.frame()
    }

    /// What the arcs read so far say about their sense.
    pub fn arcs(&self) -> ArcVote {
        self.interpreter.votes.count(self.interpreter.options.circle_sense.is_some())
    }

    /// How many frames that differ were stated so far.
    pub fn different_frames(&self) -> usize {
        self.interpreter.workpiece.different()
    }

    /// How often the CSYS of SolidWorks CAM changed so far.
    pub fn setup_changes(&self) -> u64 {
        self.interpreter.setup_changes
    }

    /// Whether the CAM system asks for inverse-time feed.
    pub fn asks_for_inverse_time(&self) -> bool {
        self.interpreter.inverse_time
    }

    /// How many frames were stated so far, equal ones included.
    pub fn frames_stated(&self) -> u64 {
        self.interpreter.workpiece.stated()
    }

    /// Statements so far, comments not counted.
    pub fn records(&self) -> u64 {
        self.records
    }

    /// Motions so far.
    pub fn motions(&self) -> u64 {
        self.interpreter.motions
    }

    /// Lines so far.
    pub fn lines(&self) -> u64 {
        self.lexer.lines()
    }

    /// Tool axes so far whose length was off by more than rounding and which were normalised.
    pub fn normalised_axes(&self) -> u64 {
        self.interpreter.normalised
    }

    fn begin(&mut self) -> io::Result<()> {
        let (text, help) = match self.lexer.begin()? {
            Beginning::Text => {
                self.progress = Progress::Reading;
                return Ok(());
            }
            Beginning::Binary => (
                "this is no text file: it holds NUL bytes",
                "write the CL data as text (APT source, CLS); UTF-16 text must be saved as UTF-8",
            ),
            Beginning::Empty => ("the file is empty", "check whether the CAM system wrote it completely"),
        };
        self.faults.add_about_file(Severity::Error, Location { line: 1, column: 1 }, text.into(), help);
        self.progress = Progress::Done;
        Ok(())
    }

    fn is_plain_goto(&self, statement: &Statement) -> bool {
        statement.kind == Kind::Code
            && self.interpreter.is_straight()
            && !self.matrix.is_open()
            && !self.subprograms.is_open()
            && parse::is_goto(self.lexer.text(statement))
    }

    /// A GOTO while nothing is open and nothing waits: the same as the long way, without a queue.
    fn read_goto(&mut self, statement: &Statement) -> Option<(Location, Event<'static>)> {
        self.records += 1;
        let here = self.lexer.locate(statement, 0).0;
        match parse::goto(self.lexer.text(statement)).and_then(|point| self.interpreter.straight(&point, here)) {
            Ok(motion) if !self.faults.failed() => Some((here, Event::Move(motion))),
            Ok(_) => None,
            Err(fault) if parse::is_list(&fault) => {
                self.statement = Some(*statement);
                self.kept = None;
                self.read_record(statement, here);
                None
            }
            Err(fault) => {
                self.faults.add(fault, statement, &self.lexer);
                None
            }
        }
    }

    fn read(&mut self, statement: &Statement) {
        self.statement = Some(*statement);
        self.kept = None;
        let text = self.lexer.text(statement);
        let record = match statement.kind {
            Kind::Code => {
                self.records += 1;
                if let Err(fault) = self.matrix.abandon() {
                    self.faults.add(fault, statement, &self.lexer);
                }
                self.interpreter.suspect(parse::dialect(text));
                return self.read_record(statement, self.lexer.locate(statement, 0).0);
            }
            Kind::Comment => {
                self.interpreter.suspect(comment::dialect(text));
                let mut lines = self.lexer.joined_lines(statement);
                match lines.find_map(|(offset, line)| parse::swallowed(text, offset, line)) {
                    Some(swallowed) => Err(swallowed),
                    None => comment::read(text, &mut self.matrix),
                }
            }
            Kind::TooLong => Err(Fault::new(
                "statement too long",
                Span::WHOLE,
                format!("a statement here is longer than {} bytes", lexer::LONGEST_STATEMENT),
                "check whether this is CL data and whether its line ends were lost",
            )),
            Kind::Unfinished => Err(Fault::new(
                "unfinished statement",
                Span { start: 0, end: text.len() },
                "the file ends inside this statement, behind a `$` that continues it",
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

    /// Any statement that is no comment.
    fn read_record(&mut self, statement: &Statement, here: Location) {
        let text = self.lexer.text(statement);
        let mut lines = self.lexer.joined_lines(statement);
        let record = parse::parse(text, &self.interpreter.options.inert).and_then(|record| {
            let lost = |(offset, line)| parse::swallowed(text, offset, line);
            let lost = if parse::takes_anything(&record) { lines.find_map(lost) } else { None };
            lost.map_or(Ok(record), Err)
        });
        let taken = record.and_then(|record| match record {
            Record::EndSubprogram if self.subprograms.end() => Ok(()),
            Record::DefineSubprogram(number) => {
                self.subprograms.define(number).map_err(|why| sub_fault(Span::WHOLE, why))
            }
            _ if self.subprograms.is_open() => match self.subprograms.keep(text, here) {
                true => Ok(()),
                false => Err(sub_fault(Span::WHOLE, "the subprograms of this file are too long")),
            },
            Record::EndSubprogram => Err(sub_fault(Span::WHOLE, "ENDSUB without DEFSUB")),
            Record::CallSubprogram { number, at } => {
                let ready = self.interpreter.take(&record, here);
                ready.and_then(|()| self.subprograms.call(number).map_err(|why| sub_fault(at, why)))
            }
            record => self.interpreter.take(&record, here),
        });
        if let Err(fault) = taken {
            self.faults.add(fault, statement, &self.lexer);
        }
        for warning in self.interpreter.warnings.drain(..) {
            self.faults.add(warning, statement, &self.lexer);
        }
    }

    /// The next statement of a subprogram that is called.
    fn run_kept(&mut self) {
        let Some(kept) = self.subprograms.next() else { return };
        self.kept = Some(kept);
        let text = self.subprograms.text(&kept);
        let place = |at: Span| {
            let column = u32::try_from(at.start).unwrap_or(u32::MAX);
            let location = Location { column: kept.location.column.saturating_add(column), ..kept.location };
            (location, text.len().saturating_sub(at.start))
        };
        let taken = parse::parse(text, &self.interpreter.options.inert).and_then(|record| match record {
            Record::CallSubprogram { at, .. } => {
                Err(sub_fault(at, "a subprogram that calls another one is not understood"))
            }
            record => self.interpreter.take(&record, kept.location),
        });
        for fault in taken.err().into_iter().chain(self.interpreter.warnings.drain(..)) {
            let (location, left) = place(fault.at);
            self.faults.add_at(fault, location, left);
        }
    }

    /// What can be said only of the whole file.
    fn finish(&mut self) {
        self.progress = Progress::Done;
        let unfinished = self.interpreter.finish();
        let unfinished = unfinished.err().or_else(|| {
            let open = self.subprograms.is_open();
            open.then(|| sub_fault(Span::WHOLE, "the file ends inside a subprogram"))
        });
        if let (Some(fault), Some(statement)) = (unfinished, &self.statement) {
            self.faults.add(fault, statement, &self.lexer);
        }
        self.count_votes();
        let reading = &self.interpreter;
        if reading.normalised > 0 {
            let text = format!(
                "{} tool axes are off from length 1 by more than 0.00001 and were normalised; this is the first",
                reading.normalised
            );
            let help = "have the CAM system write i, j, k with more digits";
            self.faults.add_about_file(Severity::Warning, reading.first_normalised, text, help);
        }
        if let Some(cutters) = reading.cutters
            && reading.units_are_only_given()
            && reading.units() == Some(Units::Millimetres)
            && cutters.largest_mm < SMALLEST_LARGEST_CUTTER_MM
        {
            let text = format!("no cutter is larger than {} mm: is this file in inch?", cutters.largest_mm);
            let help = "give `--units in`; if these are millimetres, say UNITS/MM at the top of the file";
            self.faults.add_about_file(Severity::Error, cutters.first, text, help);
        }
        if reading.motions == 0 && !self.faults.failed() {
            let text = "the file holds no motion: there is no GOTO in it".into();
            let help = "check whether the tool path was generated before it was written";
            self.faults.add_about_file(Severity::Error, Location { line: 1, column: 1 }, text, help);
        }
        self.faults.conclude();
    }

    /// Compares the sense of the arcs with the lines around them.
    fn count_votes(&mut self) {
        if self.interpreter.options.circle_sense.is_some() {
            return;
        }
        for (location, against, decided) in self.interpreter.votes.contradictions() {
            let majority = 2 * against > decided;
            let severity = if majority { Severity::Error } else { Severity::Warning };
            let text = format!(
                "{against} of {decided} arcs whose neighbours decide run the other way than the form of CIRCLE says; \
                 this is the first"
            );
            let help = if majority {
                "give `--circle-sense cw` or `ccw` if the CAM system has another habit"
            } else {
                "a cusp, if the path really turns back here"
            };
            self.faults.add_about_file(severity, location, text, help);
        }
    }
}

fn sub_fault(at: Span, why: &str) -> Fault {
    Fault::new("subprogram", at, why, "DEFSUB/n stands before CALSUB/n, with ENDSUB behind the last record")
}
