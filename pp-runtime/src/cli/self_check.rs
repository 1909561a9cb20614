//! The check of the program that is being written: read back while it is posted, in a thread of its own.
//!
//! Bytes go to the output and, in pieces over a bounded channel, to the check, which reads the CL data on its own. The
//! last lines, in which the program ends, are held back until the check has passed: a program that did not pass has no
//! end code, and one that did may state it before the end code.

use std::io::{self, Read, Seek as _, Write};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread::{self, JoinHandle};

use crate::check::{CheckError, Checked, Job, check_for};
use crate::config::Config;
use crate::control::Control;
use crate::kinematics::AnyMachine;

use super::check::findings;
use super::cl_source::ClSource;
use super::messages::{Messages, headline};

/// Bytes of a piece, and pieces in the channel at most.
const PIECE: usize = 1 << 16;
const PIECES: usize = 16;

/// A check that runs.
pub(crate) struct SelfCheck {
    sender: Option<SyncSender<Vec<u8>>>,
    piece: Vec<u8>,
    thread: JoinHandle<Result<Checked, CheckError>>,
}

impl SelfCheck {
    /// Begins to check what will be written.
    pub(crate) fn start(
        machine: &dyn AnyMachine,
        config: &Config,
        control: &'static dyn Control,
        source: &ClSource,
    ) -> io::Result<Self> {
        let (sender, receiver) = sync_channel(PIECES);
        let (machine, config, mut input) = (machine.to_boxed(), config.clone(), source.again()?);
        let body = move || {
            let job = Job { config: &config, control, units: config.cl_units };
            let mut program = PieceReader { receiver, piece: Vec::new(), at: 0 };
            check_for(&*machine, &job, &mut input, &mut program)
        };
        let thread = thread::Builder::new().name("check".to_owned()).spawn(body)?;
        Ok(Self { sender: Some(sender), piece: Vec::with_capacity(PIECE), thread })
    }

    fn take(&mut self, bytes: &[u8]) {
        self.piece.extend_from_slice(bytes);
        if self.piece.len() >= PIECE {
            self.send();
        }
    }

    /// Hands a piece over; a check that has ended early reports why when it is joined.
    fn send(&mut self) {
        let piece = std::mem::replace(&mut self.piece, Vec::with_capacity(PIECE));
        if self.sender.as_ref().is_some_and(|sender| sender.send(piece).is_err()) {
            self.sender = None;
        }
    }

    /// Waits for the check of everything that was written.
    fn finish(mut self) -> Result<Checked, CheckError> {
        self.send();
        drop(self.sender);
        self.thread.join().unwrap_or_else(|_| {
            Err(CheckError::Impossible(
                "the check of the program ended by itself: this is a fault of the program that checks".to_owned(),
            ))
        })
    }
}

/// Why the program may not be handed over, if its check has found anything; all findings are written.
pub(crate) fn against(
    checked: Option<&Checked>,
    name: &str,
    source: &mut ClSource,
    messages: &mut Messages<'_>,
) -> Option<String> {
    let checked = checked?;
    let found = findings(checked);
    let first = found.iter().min_by_key(|found| found.location)?;
    if source.rewind().is_ok() {
        messages.diagnostics(name, source, &found);
    }
    messages.note(&checked.outcome.summary());
    Some(format!("the program does not do what the CL data asks for: {}", headline(name, first)))
}

/// The pieces as a stream.
struct PieceReader {
    receiver: Receiver<Vec<u8>>,
    piece: Vec<u8>,
    at: usize,
}

impl Read for PieceReader {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.at >= self.piece.len() {
            let Ok(piece) = self.receiver.recv() else { return Ok(0) };
            (self.piece, self.at) = (piece, 0);
        }
        let count = buffer.len().min(self.piece.len() - self.at);
        buffer[..count].copy_from_slice(&self.piece[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

/// Writes to the output and to the check, where there is one.
pub(crate) struct Checking<'a> {
    out: &'a mut dyn Write,
    check: Option<SelfCheck>,
    /// Lines that the program ends with.
    lines: usize,
    /// What may be the end.
    held: Vec<u8>,
}

impl<'a> Checking<'a> {
    /// `lines`: the end code and the lines after it.
    pub(crate) fn new(out: &'a mut dyn Write, check: Option<SelfCheck>, lines: usize) -> Self {
        Self { out, check, lines, held: Vec::new() }
    }

    /// What has become of the check, once everything is written; `None` without one.
    pub(crate) fn verdict(&mut self) -> Option<Result<Checked, CheckError>> {
        self.check.take().map(SelfCheck::finish)
    }

    /// Writes what was held back.
    pub(crate) fn close(mut self) -> io::Result<()> {
        self.out.write_all(&std::mem::take(&mut self.held))?;
        self.out.flush()
    }

    /// Writes comments in the place of the end.
    pub(crate) fn close_with(self, comments: &[Vec<u8>]) -> io::Result<()> {
        let kept = self.without_end();
        self.out.write_all(&self.held[..kept])?;
        comments.iter().try_for_each(|comment| write_line(self.out, None, comment))?;
        self.out.flush()
    }

    /// Writes comments before the end; `counted`: every line has its number, one more than that of the line before.
    pub(crate) fn close_before_end(self, comments: &[Vec<u8>], counted: bool) -> io::Result<()> {
        let kept = self.without_end();
        self.out.write_all(&self.held[..kept])?;
        let mut number = if counted { numbered(&self.held[kept..]).map(|(number, _)| number) } else { None };
        for comment in comments {
            write_line(self.out, number, comment)?;
            number = number.map(|number| number + 1);
        }
        for line in self.held[kept..].split_inclusive(|byte| *byte == b'\n') {
            let line = line.strip_suffix(b"\n").unwrap_or(line);
            match (number, numbered(line)) {
                (Some(now), Some((_, text))) => {
                    write_line(self.out, number, text)?;
                    number = Some(now + 1);
                }
                _ => write_line(self.out, None, line)?,
            }
        }
        self.out.flush()
    }

    /// Number of the bytes held back that come before the end.
    fn without_end(&self) -> usize {
        let body = self.held.len() - usize::from(self.held.last() == Some(&b'\n'));
        let mut ends = memchr::memrchr_iter(b'\n', &self.held[..body]);
        ends.nth(self.lines - 1).map_or(0, |end| end + 1)
    }
}

impl Write for Checking<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if let Some(check) = self.check.as_mut() {
            check.take(bytes);
        }
        self.held.extend_from_slice(bytes);
        if self.held.len() >= PIECE {
            let kept = self.without_end();
            self.out.write_all(&self.held[..kept])?;
            self.held.drain(..kept);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

fn write_line(out: &mut dyn Write, number: Option<u64>, text: &[u8]) -> io::Result<()> {
    if let Some(number) = number {
        write!(out, "{number} ")?;
    }
    out.write_all(text)?;
    out.write_all(b"\n")
}

/// The number that a line begins with, and the text after it.
fn numbered(line: &[u8]) -> Option<(u64, &[u8])> {
    let blank = line.iter().position(|byte| *byte == b' ')?;
    let number = str::from_utf8(&line[..blank]).ok()?.parse().ok()?;
    Some((number, &line[blank + 1..]))
}
