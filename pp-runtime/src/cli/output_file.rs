//! The file of the program: its final name holds a complete program, or does not exist.
//!
//! The program is written to a temporary file in the same folder and renamed when it is complete. An incomplete program
//! goes to `OUT.rejected` instead, with the reason in its first line, and an earlier OUT is set aside as `OUT.earlier`:
//! otherwise an old program could be run in place of the one that failed, and it may have been edited by hand.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};

use super::outcome::{NamedWriter, of_file};
use super::temporary::TemporaryFile;

/// A program that is being written.
pub(crate) struct OutputFile {
    path: PathBuf,
    destination: Destination,
}

enum Destination {
    /// A temporary file, renamed at the end.
    Renamed(TemporaryFile),
    /// A device or a pipe, which cannot be replaced: written directly, as standard output is.
    Direct(File),
}

/// Result of rejecting a program.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Rejected {
    /// File of the rejected program; `None` if it went to a device.
    pub(crate) path: Option<PathBuf>,
    /// Where an earlier program under the final name was set aside.
    pub(crate) earlier: Option<PathBuf>,
}

impl OutputFile {
    /// Checks that `path` can be written, and creates the temporary file.
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => {
                return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a directory"));
            }
            Ok(metadata) if !metadata.is_file() => {
                let destination = Destination::Direct(OpenOptions::new().write(true).open(path)?);
                return Ok(Self { path: path.to_owned(), destination });
            }
            // A rename would replace a write-protected file; opening it for writing fails.
            Ok(_) => drop(OpenOptions::new().append(true).open(path)?),
            Err(_) => {}
        }
        // A symbolic link is followed: the link stays and its target is replaced.
        let is_link = fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_symlink());
        let path = match is_link {
            true => fs::canonicalize(path).map_err(|error| {
                io::Error::new(error.kind(), format!("it is a symbolic link to a file that does not exist: {error}"))
            })?,
            false => path.to_owned(),
        };
        let destination = Destination::Renamed(temporary_next_to(&path)?);
        Ok(Self { path, destination })
    }

    /// Writer of the program; its errors name the file.
    pub(crate) fn writer(&mut self) -> NamedWriter<'_> {
        let out: &mut dyn Write = match &mut self.destination {
            Destination::Renamed(file) => file,
            Destination::Direct(file) => file,
        };
        NamedWriter { path: &self.path, out }
    }

    /// Gives the program its final name. Removes a rejected program of an earlier run, and returns whether there was
    /// one; `is_rejected` recognises it by its first line.
    pub(crate) fn finish(self, is_rejected: impl Fn(&[u8]) -> bool) -> io::Result<bool> {
        let Destination::Renamed(file) = self.destination else { return Ok(false) };
        file.persist(&self.path)?;
        let rejected = rejected_path(&self.path);
        Ok(first_line(&rejected).is_ok_and(|line| is_rejected(&line)) && fs::remove_file(rejected).is_ok())
    }

    /// Removes an earlier file of the final name.
    pub(crate) fn clear(&self) -> io::Result<()> {
        if let Destination::Direct(_) = self.destination {
            return Ok(());
        }
        match fs::remove_file(&self.path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        }
    }

    /// Gives an earlier program under the final name the name `OUT.earlier`, if there is one.
    fn set_aside(&self) -> io::Result<Option<PathBuf>> {
        if let Destination::Direct(_) = self.destination {
            return Ok(None);
        }
        let earlier = with_ending(&self.path, ".earlier");
        match fs::rename(&self.path, &earlier) {
            Ok(()) => Ok(Some(earlier)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Writes the program to `OUT.rejected` with `reason` as its first line, and sets an earlier file of the final name
    /// aside.
    pub(crate) fn reject(self, reason: &[u8]) -> io::Result<Rejected> {
        let earlier = self.set_aside()?;
        let Destination::Renamed(mut file) = self.destination else { return Ok(Rejected { path: None, earlier }) };
        let path = rejected_path(&self.path);
        let mut write = || {
            let mut whole = temporary_next_to(&path)?;
            whole.write_all(reason)?;
            whole.write_all(b"\n")?;
            file.file()?.rewind()?;
            io::copy(file.file()?, &mut whole)?;
            whole.persist(&path)
        };
        match write() {
            Ok(()) => Ok(Rejected { path: Some(path), earlier }),
            Err(error) => Err(of_file(&path, error)),
        }
    }
}

/// Name of a rejected program: `OUT.rejected`.
pub(crate) fn rejected_path(path: &Path) -> PathBuf {
    with_ending(path, ".rejected")
}

fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(ending);
    name.into()
}

fn temporary_next_to(path: &Path) -> io::Result<TemporaryFile> {
    let directory = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    if !directory.is_dir() {
        let text = format!("the folder {} does not exist", directory.display());
        return Err(io::Error::new(io::ErrorKind::NotFound, text));
    }
    TemporaryFile::create(directory, path.file_name().unwrap_or_default())
}

fn first_line(path: &Path) -> io::Result<Vec<u8>> {
    let mut line = Vec::new();
    BufReader::new(File::open(path)?.take(1024)).read_until(b'\n', &mut line)?;
    Ok(line)
}
