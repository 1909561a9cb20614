//! The CL data: a file, or a stream copied to a temporary file. It can be read several times, ahead in threads too, and
//! must not change meanwhile.

use std::fs::{self, File, Metadata};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

use indicatif::{ProgressBar, ProgressStyle};

use super::outcome::{Failure, NamedWriter, is_standard};
use crate::cl::{ClData, ClEvents, ReadingOptions};

/// Size in bytes above which a progress bar is shown on a terminal.
pub(crate) const LONG_INPUT_BYTES: u64 = 8 << 20;

/// A line longer than this is none of CL data, bytes: a stream of such a line may have no end, as a device of zeros.
const LONGEST_LINE: usize = 1 << 20;

/// A stream that fails where a line is too long.
struct LimitedLines<'s> {
    stream: &'s mut dyn Read,
    /// Bytes since the last end of a line.
    length: usize,
}

impl Read for LimitedLines<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.stream.read(buffer)?;
        for byte in &buffer[..count] {
            self.length = if matches!(byte, b'\n' | b'\r') { 0 } else { self.length + 1 };
            if self.length > LONGEST_LINE {
                return Err(io::Error::new(
                    io::ErrorKind::InvalidData,
                    "it has a line of more than 1 MiB: it is no CL data",
                ));
            }
        }
        Ok(count)
    }
}

/// CL data, open for reading.
pub(crate) struct ClSource {
    input: SharedFile,
    name: String,
    /// Path of a regular file, and its state when it was opened; none for a stream.
    watched: Option<(PathBuf, FileState)>,
}

/// A file that is open, with a read position of its own: others read the same file elsewhere.
#[derive(Clone)]
pub(crate) struct SharedFile {
    file: Arc<File>,
    position: u64,
    progress: ProgressBar,
    /// A thread of its own may read it ahead.
    ahead: bool,
}

/// Length, time of change and identity of a file; they differ after a change.
#[derive(Debug, Clone, PartialEq, Eq)]
struct FileState {
    length: u64,
    modified: Option<SystemTime>,
    identity: Option<(u64, u64)>,
}

impl FileState {
    fn of(metadata: &Metadata) -> Self {
        Self { length: metadata.len(), modified: metadata.modified().ok(), identity: identity(metadata) }
    }
}

impl ClSource {
    /// Opens a file. A pipe or device is copied to a temporary file.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let unreadable = |error| Failure::unreadable(path, error);
        let mut file = File::open(path).map_err(unreadable)?;
        let metadata = file.metadata().map_err(unreadable)?;
        if metadata.is_dir() {
            return Err(unreadable(io::Error::new(io::ErrorKind::IsADirectory, "is a directory")));
        }
        if !metadata.is_file() {
            return Self::spool(&mut file, path);
        }
        let watched = Some((path.to_owned(), FileState::of(&metadata)));
        Ok(Self::of(file, path.display().to_string(), watched))
    }

    /// Copies a stream, `-` for standard input, to a temporary file without a name.
    pub(crate) fn spool(stream: &mut dyn Read, path: &Path) -> Result<Self, Failure> {
        let folder = std::env::temp_dir();
        let mut file = tempfile::tempfile_in(&folder).map_err(|error| Failure::unwritable(&folder, error))?;
        let mut lines = LimitedLines { stream, length: 0 };
        let copied = io::copy(&mut lines, &mut NamedWriter { path: &folder, out: &mut file });
        copied.map_err(|error| Failure::unreadable(path, error))?;
        let name = if is_standard(path) { "<stdin>".to_owned() } else { path.display().to_string() };
        Ok(Self::of(file, name, None))
    }

    fn of(file: File, name: String, watched: Option<(PathBuf, FileState)>) -> Self {
        let input = SharedFile { file: Arc::new(file), position: 0, progress: ProgressBar::hidden(), ahead: false };
        Self { input, name, watched }
    }

    /// The same data once more, from its start and with a read position of its own. No progress is shown of it.
    pub(crate) fn again(&self) -> SharedFile {
        SharedFile { progress: ProgressBar::hidden(), ..self.input.at_start() }
    }

    /// Sets whether threads of their own may read the data ahead.
    pub(crate) fn read_ahead(mut self, ahead: bool) -> Self {
        self.input.ahead = ahead;
        self
    }

    /// Name of the CL data in messages.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Shows a progress bar from now on if the input is longer than a number of bytes. `passes`: how often it will be
    /// read.
    pub(crate) fn show_progress(&mut self, passes: u64, longer_than: u64) {
        let length = self.input.file.metadata().map_or(0, |metadata| metadata.len());
        if length > longer_than {
            let style = ProgressStyle::with_template("{bar:40} {percent}% {binary_bytes_per_sec} {eta} left");
            let progress = &mut self.input.progress;
            *progress = ProgressBar::new(length * passes);
            progress.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        }
    }

    /// Removes the progress bar.
    pub(crate) fn hide_progress(&mut self) {
        self.input.progress.finish_and_clear();
        self.input.progress = ProgressBar::hidden();
    }

    /// What happened to the file since it was opened; `None` if it is unchanged.
    pub(crate) fn changed_since_opened(&self) -> Option<&'static str> {
        let (path, state) = self.watched.as_ref()?;
        match fs::metadata(path) {
            Ok(now) if FileState::of(&now) == *state => None,
            Ok(_) => Some("changed while it was read"),
            Err(_) => Some("was removed while it was read"),
        }
    }
}

impl ClData for ClSource {
    fn text(&mut self) -> io::Result<Box<dyn Read + '_>> {
        self.input.text()
    }

    fn events(&mut self, options: ReadingOptions) -> io::Result<ClEvents<'_>> {
        self.input.events(options)
    }
}

impl SharedFile {
    /// The same file, read from its start.
    fn at_start(&self) -> Self {
        Self { position: 0, ..self.clone() }
    }
}

impl ClData for SharedFile {
    fn text(&mut self) -> io::Result<Box<dyn Read + '_>> {
        Ok(Box::new(self.at_start()))
    }

    fn events(&mut self, options: ReadingOptions) -> io::Result<ClEvents<'_>> {
        // Without another thread the events are the same.
        if self.ahead
            && let Ok(events) = ClEvents::ahead(self.at_start(), options.clone())
        {
            return Ok(events);
        }
        Ok(ClEvents::here(self.at_start(), options))
    }
}

impl Read for ClSource {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.input.read(buffer)
    }
}

impl Seek for ClSource {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.input.seek(position)
    }
}

impl Read for SharedFile {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        #[cfg(unix)]
        let count = std::os::unix::fs::FileExt::read_at(&*self.file, buffer, self.position)?;
        #[cfg(windows)]
        let count = std::os::windows::fs::FileExt::seek_read(&*self.file, buffer, self.position)?;
        self.position += count as u64;
        self.progress.inc(count as u64);
        Ok(count)
    }
}

impl Seek for SharedFile {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        let place = match position {
            SeekFrom::Start(place) => Some(place),
            SeekFrom::Current(by) => self.position.checked_add_signed(by),
            SeekFrom::End(by) => self.file.metadata()?.len().checked_add_signed(by),
        };
        self.position = place.ok_or(io::ErrorKind::InvalidInput)?;
        Ok(self.position)
    }
}

/// Whether two paths lead to the same file, also through links.
pub(crate) fn same_file(one: &Path, other: &Path) -> bool {
    if let (Ok(first), Ok(second)) = (fs::metadata(one), fs::metadata(other))
        && let (Some(first), Some(second)) = (identity(&first), identity(&second))
    {
        return first == second;
    }
    matches!((canonical(one), canonical(other)), (Ok(one), Ok(other)) if one == other)
}

/// Canonical path of a file; if the file does not exist, its name in the canonical path of its folder.
fn canonical(path: &Path) -> io::Result<PathBuf> {
    fs::canonicalize(path).or_else(|_| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Ok(fs::canonicalize(folder)?.join(path.file_name().unwrap_or_default()))
    })
}

/// Device and inode number of a file, on systems that have them.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "other systems have no such numbers")]
fn identity(metadata: &Metadata) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    Some((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn identity(_metadata: &Metadata) -> Option<(u64, u64)> {
    None
}
