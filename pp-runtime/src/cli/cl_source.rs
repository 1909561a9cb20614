//! The CL data: a file, or a spooled stream, that can be read twice and must not change meanwhile.

use std::fs::{self, File, Metadata};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use indicatif::{ProgressBar, ProgressStyle};
use tempfile::NamedTempFile;

/// Input above this size shows a progress bar on a terminal, bytes.
const LONG_INPUT: u64 = 8 << 20;

/// The text is read once for what needs the future, once for the program.
const PASSES: u64 = 2;

/// CL data, open for reading.
pub(crate) struct ClSource {
    file: File,
    name: String,
    /// Path and state of a regular file when it was opened; a spooled stream has none.
    watched: Option<(PathBuf, FileState)>,
    /// Where a stream is kept.
    spooled: Option<NamedTempFile>,
    progress: ProgressBar,
}

/// What a file looks like from outside; a file that changes looks different.
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
    /// Opens `path`; what is not a regular file is spooled to a temporary file.
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        let mut file = File::open(path)?;
        let metadata = file.metadata()?;
        let name = path.display().to_string();
        if metadata.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a directory"));
        }
        if !metadata.is_file() {
            return Self::spool(&mut file, name);
        }
        let watched = Some((path.to_owned(), FileState::of(&metadata)));
        Ok(Self { file, name, watched, spooled: None, progress: ProgressBar::hidden() })
    }

    /// Keeps a stream in a temporary file.
    pub(crate) fn spool(stream: &mut dyn Read, name: impl Into<String>) -> io::Result<Self> {
        let mut spooled = NamedTempFile::new()?;
        io::copy(stream, &mut spooled)?;
        let file = spooled.reopen()?;
        let spooled = Some(spooled);
        Ok(Self { file, name: name.into(), watched: None, spooled, progress: ProgressBar::hidden() })
    }

    /// The same data from its beginning, read on its own.
    pub(crate) fn again(&self) -> io::Result<File> {
        match (&self.spooled, &self.watched) {
            (Some(spooled), _) => spooled.reopen(),
            (None, Some((path, _))) => File::open(path),
            (None, None) => Err(io::Error::other("it cannot be read twice at once")),
        }
    }

    /// The name that messages use.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Shows a progress bar from here on if the input is long.
    pub(crate) fn show_progress(&mut self) {
        let length = self.file.metadata().map_or(0, |metadata| metadata.len());
        if length > LONG_INPUT {
            let style = ProgressStyle::with_template("{bar:40} {percent}% {binary_bytes_per_sec} {eta}");
            self.progress = ProgressBar::new(length * PASSES);
            self.progress.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        }
    }

    /// Takes the progress bar away.
    pub(crate) fn hide_progress(&mut self) {
        self.progress.finish_and_clear();
        self.progress = ProgressBar::hidden();
    }

    /// Says what happened to the file since it was opened, if anything did.
    pub(crate) fn disturbed(&self) -> Option<&'static str> {
        let (path, state) = self.watched.as_ref()?;
        match fs::metadata(path) {
            Ok(now) if FileState::of(&now) == *state => None,
            Ok(_) => Some("changed while it was read"),
            Err(_) => Some("vanished while it was read"),
        }
    }
}

impl Read for ClSource {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.file.read(buffer)?;
        self.progress.inc(count as u64);
        Ok(count)
    }
}

impl Seek for ClSource {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.file.seek(position)
    }
}

/// Whether two paths lead to one file, by whatever names.
pub(crate) fn same_file(one: &Path, other: &Path) -> bool {
    if let (Ok(first), Ok(second)) = (fs::metadata(one), fs::metadata(other))
        && let (Some(first), Some(second)) = (identity(&first), identity(&second))
    {
        return first == second;
    }
    matches!((place(one), place(other)), (Ok(one), Ok(other)) if one == other)
}

/// The path of a file that exists or could, by whatever name its folder is called.
fn place(path: &Path) -> io::Result<PathBuf> {
    fs::canonicalize(path).or_else(|_| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Ok(fs::canonicalize(folder)?.join(path.file_name().unwrap_or_default()))
    })
}

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
