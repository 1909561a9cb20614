//! The check of the program that is being posted: it reads the program back while it is written, in a thread of its
//! own.
//!
//! The bytes go to the output and, in pieces over a bounded channel, to the check, which opens and reads the CL data on
//! its own. The last lines, with the end code, are held back until the check is done. A program with findings gets no
//! end code. In a program without findings the figures of the check may be a comment before the end code.

use std::io::{self, Write};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{self, JoinHandle};

use crate::check::policy::EditPolicy;
use crate::check::read::TextPieces;
use crate::check::{CheckError, CheckPolicy, Checked, Finding, check_data};
use crate::config::Config;
use crate::kinematics::AnyMachine;
use crate::post::ProgramEnd;
use crate::view::Execution;

use super::check::report;
use super::cl_source::ClSource;
use super::messages::{MessageWriter, headline};
use super::outcome::Failure;

/// Bytes of a piece.
const PIECE_BYTES: usize = 1 << 16;

/// Largest number of pieces in the channel.
const MOST_PIECES: usize = 16;

/// What a run that posts wants of the check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Checking {
    /// No check.
    Off,
    /// Its findings.
    Findings,
    /// Its findings, and all points that it executes.
    Points,
}

impl Checking {
    /// For the text of a program alone: the comment about the check is a part of it where the configuration wants one.
    pub(crate) fn for_text(config: &Config) -> Self {
        if config.control.program.checked { Self::Findings } else { Self::Off }
    }
}

/// Result of the check.
pub(crate) enum SelfChecked {
    Findings(Checked),
    Points(Execution),
}

impl SelfChecked {
    pub(crate) fn checked(&self) -> &Checked {
        match self {
            Self::Findings(checked) => checked,
            Self::Points(execution) => &execution.checked,
        }
    }

    /// All that was executed, where it was kept.
    pub(crate) fn execution(self) -> Option<Execution> {
        match self {
            Self::Findings(_) => None,
            Self::Points(execution) => Some(execution),
        }
    }
}

/// A running check.
pub(crate) struct SelfCheck {
    sender: Option<SyncSender<Vec<u8>>>,
    piece: Vec<u8>,
    thread: JoinHandle<Result<SelfChecked, CheckError>>,
}

impl SelfCheck {
    /// Starts the check of a program that is about to be written. `points`: all that it executes is kept.
    pub(crate) fn start(
        machine: &dyn AnyMachine,
        policy: CheckPolicy,
        source: &ClSource,
        points: bool,
    ) -> Result<Self, Failure> {
        let (sender, receiver) = sync_channel(MOST_PIECES);
        let (machine, mut input) = (machine.to_boxed(), source.again());
        // Nobody has edited it.
        let policy = CheckPolicy { edits: EditPolicy::default(), ..policy };
        let body = move || {
            let mut program = Handed(receiver);
            match points {
                false => check_data(&*machine, &policy, &mut input, &mut program, None).map(SelfChecked::Findings),
                true => Execution::of(&*machine, &policy, &mut input, &mut program).map(SelfChecked::Points),
            }
        };
        let thread = thread::Builder::new().name("check".to_owned()).spawn(body);
        let thread = thread.map_err(|error| Failure::Argument(format!("the check cannot be started: {error}")))?;
        Ok(Self { sender: Some(sender), piece: Vec::new(), thread })
    }

    fn take(&mut self, bytes: &[u8]) {
        self.piece.extend_from_slice(bytes);
        if self.piece.len() >= PIECE_BYTES {
            self.send();
        }
    }

    /// Hands a piece over. If the check has ended early, `finish` returns the reason.
    fn send(&mut self) {
        let piece = std::mem::take(&mut self.piece);
        // An empty piece would be the end.
        if !piece.is_empty() && self.sender.as_ref().is_some_and(|sender| sender.send(piece).is_err()) {
            self.sender = None;
        }
    }

    /// Hands the last piece over and waits for the result.
    fn finish(mut self) -> Result<SelfChecked, CheckError> {
        self.send();
        drop(self.sender);
        self.thread.join().unwrap_or_else(|_| {
            Err(CheckError::Impossible(
                "the check of the program stopped unexpectedly: this is a bug of the postprocessor, not an error in the \
                 CL data. `post --no-check` writes the program unchecked: simulate it before it is run"
                    .to_owned(),
            ))
        })
    }
}

/// The reason to reject a program, if its check has findings. Writes all findings as messages.
pub(crate) fn rejection(
    checked: Option<&Checked>,
    name: &str,
    source: &mut ClSource,
    messages: &mut MessageWriter<'_>,
) -> Option<String> {
    let checked = checked?;
    let findings = checked.outcome.findings.first().map(Finding::diagnostic);
    let first = checked.fault.clone().or(findings)?;
    // If the CL data cannot be read again, the reason to reject the program is still shown.
    let _ = report(checked, name, source, None, messages);
    messages.note(&checked.outcome.summary());
    Some(format!("the program differs from the CL data: {}", headline(name, &first)))
}

/// The pieces as they come.
struct Handed(Receiver<Vec<u8>>);

impl TextPieces for Handed {
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()> {
        *piece = self.0.recv().unwrap_or_default();
        Ok(())
    }
}

/// Output of a program: writes to the file or stream, and to the check if there is one.
pub(crate) struct CheckedOutput<'a> {
    out: &'a mut dyn Write,
    check: Option<SelfCheck>,
    end: ProgramEnd,
    /// Bytes held back, which may be the end.
    held: Vec<u8>,
}

impl<'a> CheckedOutput<'a> {
    pub(crate) fn new(out: &'a mut dyn Write, check: Option<SelfCheck>, end: ProgramEnd) -> Self {
        Self { out, check, end, held: Vec::new() }
    }

    /// Result of the check, once everything is written; `None` without a check.
    pub(crate) fn finish_check(&mut self) -> Option<Result<SelfChecked, CheckError>> {
        self.check.take().map(SelfCheck::finish)
    }

    /// Writes the end, which was held back.
    pub(crate) fn close(mut self) -> io::Result<()> {
        self.out.write_all(&std::mem::take(&mut self.held))?;
        self.out.flush()
    }

    /// Writes comments instead of the end.
    pub(crate) fn close_with(self, comments: &[Vec<u8>]) -> io::Result<()> {
        self.out.write_all(&self.held[..self.end.position(&self.held)])?;
        for comment in comments {
            self.out.write_all(comment)?;
            self.out.write_all(b"\n")?;
        }
        self.out.flush()
    }

    /// Writes comments before the end.
    pub(crate) fn close_before_end(self, comments: &[Vec<u8>]) -> io::Result<()> {
        self.end.write_with(self.out, &self.held, comments)?;
        self.out.flush()
    }
}

impl CheckedOutput<'_> {
    /// Holds bytes back, and writes those before the last that may be the end.
    fn hold(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.held.extend_from_slice(bytes);
        if self.held.len() >= PIECE_BYTES {
            let kept = self.end.position(&self.held);
            self.out.write_all(&self.held[..kept])?;
            self.held.drain(..kept);
        }
        Ok(())
    }
}

impl Write for CheckedOutput<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(check) = self.check.as_mut() {
            check.take(bytes);
        }
        // A piece that is long, as nearly all are, is not copied: the end may be in it, and not before it.
        match if bytes.len() >= PIECE_BYTES { self.end.position(bytes) } else { 0 } {
            0 => self.hold(bytes)?,
            end => {
                self.out.write_all(&self.held)?;
                self.out.write_all(&bytes[..end])?;
                self.held.clear();
                self.held.extend_from_slice(&bytes[end..]);
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
