//! The standard streams, the exit status of a run, and the errors that prevent a run.

use std::io::{self, BufWriter, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use crate::diag::Code;
use crate::diag::code::run;

/// Exit status of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// Done.
    Done = 0,
    /// The CL data has errors, or a check has findings.
    Rejected = 1,
    /// The run was not possible.
    NotRun = 2,
}

/// The standard streams, or what takes their place.
pub struct Streams<'a> {
    /// Standard input.
    pub input: &'a mut dyn Read,
    /// Standard output.
    pub output: &'a mut dyn Write,
    /// Standard error.
    pub errors: &'a mut dyn Write,
    /// Standard error is a terminal: progress is shown, and messages have colours.
    pub terminal: bool,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status as u8)
    }
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
    /// Several reasons, each an error of its own.
    #[error("{}", .1.join("; "))]
    Reasons(Code, Vec<String>),
    /// The message has already been written, or nobody can read it.
    #[error("")]
    Reported,
}

/// An error of a file with its name, for errors that pass through code which does not know the file.
#[derive(Debug, thiserror::Error)]
#[error("{name}: {error}")]
struct FileError {
    name: String,
    error: io::Error,
}

/// An error in writing a file; [`Failure::unwritable`] names this file.
pub(crate) fn of_file(path: &Path, error: io::Error) -> io::Error {
    io::Error::new(error.kind(), FileError { name: path.display().to_string(), error })
}

/// A writer whose errors name its file.
pub(crate) struct NamedWriter<'a> {
    pub(crate) path: &'a Path,
    pub(crate) out: &'a mut dyn Write,
}

impl Write for NamedWriter<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes).map_err(|error| of_file(self.path, error))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush().map_err(|error| of_file(self.path, error))
    }
}

impl Failure {
    /// Class of the message.
    pub(crate) fn code(&self) -> Code {
        match self {
            Self::Unreadable(..) => run::READ,
            Self::Unwritable(..) => run::WRITE,
            Self::Changed(..) => run::READ,
            Self::Overwrites(..) => run::WRITE,
            Self::Argument(_) | Self::Reported => run::ARGUMENT,
            Self::Reasons(code, _) => *code,
        }
    }

    /// `path`: the file that is read, unless the error names one that is written.
    pub(crate) fn unreadable(path: &Path, error: io::Error) -> Self {
        match error.downcast::<FileError>() {
            Ok(FileError { name, error }) => Self::Unwritable(name, error),
            Err(error) if is_standard(path) => Self::Unreadable("standard input".to_owned(), error),
            Err(error) => Self::Unreadable(path.display().to_string(), error),
        }
    }

    /// `path`: the file, unless the error names another.
    pub(crate) fn unwritable(path: &Path, error: io::Error) -> Self {
        // The reader closed the pipe on purpose (`head`): no message.
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::Reported;
        }
        match error.downcast::<FileError>() {
            Ok(FileError { name, error }) => Self::Unwritable(name, error),
            Err(error) if is_standard(path) => Self::Unwritable("standard output".to_owned(), error),
            Err(error) => Self::Unwritable(path.display().to_string(), error),
        }
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
