//! The standard streams, the exit status of a run, and the errors that prevent a run.

use std::io::{self, BufWriter, Read, Write};
use std::path::Path;

/// Exit status of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Status {
    /// Done.
    Done = 0,
    /// The CL data has errors, or a check has findings.
    Rejected = 1,
    /// The run was not possible.
    NotRun = 2,
}

/// The standard streams.
pub(crate) struct Streams<'a> {
    pub(crate) input: &'a mut dyn Read,
    pub(crate) output: &'a mut dyn Write,
    pub(crate) errors: &'a mut dyn Write,
    /// Standard error is a terminal.
    pub(crate) terminal: bool,
}

/// The reason why a run was not possible.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    #[error("cannot read {0}: {1}")]
    Unreadable(String, io::Error),
    #[error("cannot write {0}: {1}")]
    Unwritable(String, io::Error),
    #[error("{0} {1}: post it again")]
    Changed(String, &'static str),
    #[error("{0} would overwrite {1}")]
    Overwrites(String, String),
    #[error("{0}")]
    Argument(String),
    /// The message has already been written, or nobody can read it.
    #[error("")]
    Reported,
}

impl Failure {
    pub(crate) fn unreadable(path: &Path, error: io::Error) -> Self {
        let name = if is_standard(path) { "standard input".to_owned() } else { path.display().to_string() };
        Self::Unreadable(name, error)
    }

    pub(crate) fn unwritable(path: &Path, error: io::Error) -> Self {
        // The reader closed the pipe on purpose (`head`): no message.
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::Reported;
        }
        let name = if is_standard(path) { "standard output".to_owned() } else { path.display().to_string() };
        Self::Unwritable(name, error)
    }
}

/// Writes a text to standard output.
pub(crate) fn print(
    streams: &mut Streams<'_>,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<Status, Failure> {
    let mut out = BufWriter::new(&mut *streams.output);
    write(&mut out).and_then(|()| out.flush()).map_err(|error| Failure::unwritable(Path::new("-"), error))?;
    Ok(Status::Done)
}

/// Whether a path is `-`, standard input or output.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}
