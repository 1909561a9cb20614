//! Named temporary files: removed when they are dropped, and when a signal ends the program.
//!
//! A program is renamed once it is complete, so it needs a name before. Everything else goes to files without a name
//! (`tempfile::tempfile`), which disappear with the process, however it ends.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile};

/// Named temporary files of this process. Whoever creates, renames or removes one holds the lock, so a signal finds all
/// of them, and none of another process.
static NAMED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn named() -> MutexGuard<'static, Vec<PathBuf>> {
    NAMED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A named temporary file.
pub(crate) struct TemporaryFile {
    /// `None` once it has its final name.
    file: Option<NamedTempFile>,
}

impl TemporaryFile {
    /// Creates a hidden file in a folder, with the permissions of an ordinary file (umask). `name`: the beginning of
    /// its name.
    pub(crate) fn create(folder: &Path, name: &std::ffi::OsStr) -> io::Result<Self> {
        let mut prefix = std::ffi::OsString::from(".");
        prefix.push(name);
        prefix.push(".");
        let mut options = OpenOptions::new();
        options.read(true).write(true).create_new(true);
        let mut named = named();
        let file = Builder::new().prefix(&prefix).suffix(".tmp").make_in(folder, |path| options.open(path))?;
        named.push(file.path().to_owned());
        Ok(Self { file: Some(file) })
    }

    /// The open file.
    pub(crate) fn file(&mut self) -> io::Result<&mut std::fs::File> {
        let file = self.file.as_mut().map(NamedTempFile::as_file_mut);
        file.ok_or_else(|| io::Error::other("the file has been renamed"))
    }

    /// Gives the file its final name, in the same folder, once all of it is on the disk.
    pub(crate) fn persist(mut self, path: &Path) -> io::Result<()> {
        // Reports a full disk or network share before the file is renamed.
        self.file()?.sync_all()?;
        let mut named = named();
        let Some(file) = self.file.take() else { return Ok(()) };
        let temporary = file.path().to_owned();
        let renamed = file.persist(path).map(drop);
        named.retain(|other| *other != temporary);
        // On failure the error holds the file, which is removed with it.
        renamed.map_err(|error| error.error)
    }
}

impl Write for TemporaryFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file()?.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file()?.flush()
    }
}

impl Drop for TemporaryFile {
    fn drop(&mut self) {
        let Some(file) = self.file.take() else { return };
        let mut named = named();
        let temporary = file.path().to_owned();
        drop(file);
        named.retain(|other| *other != temporary);
    }
}

/// From now on a signal that ends the program (SIGHUP, SIGINT, SIGTERM) first removes the named temporary files, and a
/// file that becomes larger than allowed (SIGXFSZ) is an error of writing. Signals that the program was started with
/// ignored (`nohup`, `&` in a script) stay so.
#[cfg(unix)]
pub(crate) fn watch_signals() -> io::Result<()> {
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;
    use std::{fs, thread};

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;
    use signal_hook::{flag, low_level};

    let ignored = ignored_signals();
    let ending = [SIGHUP, SIGINT, SIGTERM].into_iter().filter(|signal| ignored & (1 << (signal - 1)) == 0);
    let mut signals = Signals::new(ending)?;
    flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)))?;
    let body = move || {
        for signal in signals.forever() {
            // Held until the process ends: nothing is created or renamed any more.
            let named = named();
            for path in named.iter() {
                // It may have been removed by hand.
                let _ = fs::remove_file(path);
            }
            let _ = low_level::emulate_default_handler(signal);
        }
    };
    thread::Builder::new().name("signals".to_owned()).spawn(body).map(drop)
}

/// Signals end the program as the system has it.
#[cfg(not(unix))]
pub(crate) fn watch_signals() -> io::Result<()> {
    Ok(())
}

/// Bits of the signals that this process ignores, SIGHUP (1) the lowest; 0 where the system does not list them.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let bits = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    bits.and_then(|bits| u64::from_str_radix(bits.trim(), 16).ok()).unwrap_or_default()
}
