//! The account of a program: for each of its lines the record that it serves, why it is there, and where the machine
//! stands behind it.

use std::io::{self, Write};

use crate::control::Encoder;
use crate::kinematics::{Branch, Pose};
use crate::motion::{BlockReason, MAX_AXES, Provenance, ReachedPosition, Sink, Step};
use crate::program::Location;

/// A line of a program, and where it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Origin<'a> {
    /// Its place in the program, from 1.
    pub line: u64,
    /// The block number that stands in it.
    pub number: Option<u32>,
    /// What it is, in one word: `feed`, `rapid`, `tool`, ...; `head` and `end` for the frame of the program.
    pub step: &'static str,
    /// The record that it serves; none for the head.
    pub at: Option<Location>,
    /// Why it is there.
    pub why: BlockReason,
    /// Where the machine stands behind it, if it moves.
    pub standing: Option<ReachedPosition<'a>>,
}

/// Keeps the account of a program.
pub trait Account {
    /// Takes the next line.
    ///
    /// # Errors
    /// Those of where the account is written to.
    fn line(&mut self, origin: &Origin<'_>) -> io::Result<()>;
}

/// Where the machine stands, by value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stand {
    pose: Option<Pose>,
    branch: Branch,
    axes: [f64; MAX_AXES],
    count: usize,
    mask: u16,
}

impl Stand {
    pub(crate) fn of(standing: &ReachedPosition<'_>) -> Self {
        let count = standing.axes.len().min(MAX_AXES);
        let mut axes = [0.0; MAX_AXES];
        axes[..count].copy_from_slice(&standing.axes[..count]);
        Self { pose: standing.pose.copied(), branch: standing.branch, axes, count, mask: standing.mask }
    }

    pub(crate) fn standing(&self) -> ReachedPosition<'_> {
        let Self { ref pose, branch, ref axes, count, mask } = *self;
        ReachedPosition { pose: pose.as_ref(), branch, axes: &axes[..count], mask }
    }
}

/// Hands steps to an encoder, and what it makes of them to an account, if one is kept.
pub(crate) struct Recorded<'e, 'r, W: Write> {
    encoder: Encoder<'e, W>,
    account: Option<&'r mut dyn Account>,
    /// The record that was served last.
    at: Option<Location>,
    why: BlockReason,
}

impl<'e, 'r, W: Write> Recorded<'e, 'r, W> {
    pub(crate) fn new(mut encoder: Encoder<'e, W>, account: Option<&'r mut dyn Account>) -> Self {
        if account.is_some() {
            encoder.keep_lines();
        }
        Self { encoder, account, at: None, why: BlockReason::Head }
    }

    pub(crate) fn encoder(&mut self) -> &mut Encoder<'e, W> {
        &mut self.encoder
    }

    /// Accounts for the header, which has been written.
    pub(crate) fn account_for_head(&mut self) -> io::Result<()> {
        self.settle("head", None)
    }

    /// Accounts for what has been written after the last step.
    pub(crate) fn account_for_end(&mut self) -> io::Result<()> {
        self.settle("end", None)
    }

    /// Accounts for what has been written since the last step.
    fn settle(&mut self, step: &'static str, standing: Option<ReachedPosition<'_>>) -> io::Result<()> {
        let Some(account) = &mut self.account else { return Ok(()) };
        let (at, why) = (self.at, self.why);
        let mut lines = self.encoder.take_lines().peekable();
        while let Some(line) = lines.next() {
            // What comes before a motion is there for it, and moves nothing.
            let standing = standing.filter(|_| lines.peek().is_none());
            account.line(&Origin { line: line.line, number: line.number, step, at, why, standing })?;
        }
        Ok(())
    }
}

impl<W: Write> Sink for Recorded<'_, '_, W> {
    #[inline]
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        self.encoder.step(step, from)?;
        if self.account.is_none() {
            return Ok(());
        }
        (self.at, self.why) = (from.at, from.reason);
        self.settle(step.name(), from.reached)
    }
}
