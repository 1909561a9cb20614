//! Standard streams that were closed when the program was started.
//!
//! Before `main` the standard library opens `/dev/null` in the place of a closed stream, so a program written to it
//! would be lost without an error. Therefore the streams are looked at before that.

use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};

static INPUT: AtomicBool = AtomicBool::new(false);
static OUTPUT: AtomicBool = AtomicBool::new(false);

/// Runs before the standard library is set up: only system calls and atomic values.
#[cfg(unix)]
#[ctor::ctor(unsafe)]
fn look() {
    let closed = |stream| rustix::io::fcntl_getfd(stream) == Err(rustix::io::Errno::BADF);
    INPUT.store(closed(rustix::stdio::stdin()), Ordering::Relaxed);
    OUTPUT.store(closed(rustix::stdio::stdout()), Ordering::Relaxed);
}

/// A stream that was closed: reading and writing are errors.
#[derive(Debug)]
pub(crate) struct ClosedStream;

fn closed() -> io::Error {
    io::Error::new(io::ErrorKind::NotConnected, "it is closed")
}

impl Read for ClosedStream {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        Err(closed())
    }
}

impl Write for ClosedStream {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(closed())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Standard input.
pub(crate) fn input() -> Box<dyn Read> {
    if INPUT.load(Ordering::Relaxed) { Box::new(ClosedStream) } else { Box::new(io::stdin()) }
}

/// Standard output.
pub(crate) fn output() -> Box<dyn Write> {
    if OUTPUT.load(Ordering::Relaxed) { Box::new(ClosedStream) } else { Box::new(io::stdout()) }
}
