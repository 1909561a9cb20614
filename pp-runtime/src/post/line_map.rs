//! The line map of a program: for each of its lines the CL record that it comes from, why it was written, and the
//! position of the machine after it.

use std::io;

use crate::control::Encoder;
use crate::kinematics::{Branch, Pose};
use crate::motion::{BlockReason, MAX_AXES, Provenance, ReachedPosition, Sink, Step};
use crate::program::Location;

/// A line of a program and its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LineOrigin<'a> {
    /// Line number in the program, from 1.
    pub line: u64,
    /// Block number written in the line.
    pub number: Option<u32>,
    /// Kind of the line in one word: `feed`, `rapid`, `tool`, ...; `head` and `end` for the first and the last lines.
    pub step: &'static str,
    /// CL record that the line comes from; none for the head.
    pub at: Option<Location>,
    /// Why the line was written.
    pub why: BlockReason,
    /// Position of the machine after the line, if the line moves an axis.
    pub position_after: Option<ReachedPosition<'a>>,
}

/// Receives the origin of every line of a program, in order.
pub(crate) trait LineMap {
    /// Takes the next line.
    ///
    /// # Errors
    /// Those of the output that the map is written to.
    fn line(&mut self, origin: &LineOrigin<'_>) -> io::Result<()>;
}

/// Copy of a machine position that borrows nothing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OwnedPosition {
    pose: Option<Pose>,
    branch: Branch,
    /// Axis values in chain order, mm and rad.
    axes: [f64; MAX_AXES],
    count: usize,
    mask: u16,
}

impl OwnedPosition {
    pub(crate) fn of(position: &ReachedPosition<'_>) -> Self {
        let count = position.axes.len().min(MAX_AXES);
        let mut axes = [0.0; MAX_AXES];
        axes[..count].copy_from_slice(&position.axes[..count]);
        Self { pose: position.pose.copied(), branch: position.branch, axes, count, mask: position.mask }
    }

    pub(crate) fn borrowed(&self) -> ReachedPosition<'_> {
        let Self { ref pose, branch, ref axes, count, mask } = *self;
        ReachedPosition { pose: pose.as_ref(), branch, axes: &axes[..count], mask }
    }
}

/// Hands steps to an encoder and, where a line map is wanted, the origin of each line written to that map.
pub(crate) struct MappedEncoder<'e, 'r> {
    encoder: Encoder<'e>,
    line_map: Option<&'r mut dyn LineMap>,
    /// CL record of the last step.
    at: Option<Location>,
    why: BlockReason,
}

impl<'e, 'r> MappedEncoder<'e, 'r> {
    pub(crate) fn new(mut encoder: Encoder<'e>, line_map: Option<&'r mut dyn LineMap>) -> Self {
        if line_map.is_some() {
            encoder.keep_lines();
        }
        Self { encoder, line_map, at: None, why: BlockReason::Head }
    }

    pub(crate) fn encoder(&mut self) -> &mut Encoder<'e> {
        &mut self.encoder
    }

    /// Maps the lines of the header, after it has been written.
    pub(crate) fn map_head(&mut self) -> io::Result<()> {
        self.map_lines("head", None)
    }

    /// Maps the lines written after the last step.
    pub(crate) fn map_end(&mut self) -> io::Result<()> {
        self.map_lines("end", None)
    }

    /// Maps the lines written since the last call.
    fn map_lines(&mut self, step: &'static str, position_after: Option<ReachedPosition<'_>>) -> io::Result<()> {
        let Some(line_map) = &mut self.line_map else { return Ok(()) };
        let (at, why) = (self.at, self.why);
        let mut lines = self.encoder.take_lines().peekable();
        while let Some(line) = lines.next() {
            // Only the last line of a step moves the machine; those before it prepare the motion.
            let position_after = position_after.filter(|_| lines.peek().is_none());
            line_map.line(&LineOrigin { line: line.line, number: line.number, step, at, why, position_after })?;
        }
        Ok(())
    }
}

impl Sink for MappedEncoder<'_, '_> {
    #[inline]
    fn step(&mut self, step: &Step<'_>, from: &Provenance<'_>) -> io::Result<()> {
        self.encoder.step(step, from)?;
        if self.line_map.is_none() {
            return Ok(());
        }
        (self.at, self.why) = (from.at, from.reason);
        self.map_lines(step.name(), from.reached)
    }
}
