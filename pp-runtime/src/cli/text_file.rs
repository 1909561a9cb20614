//! Text of small files: configurations, tool tables.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::outcome::Failure;

/// Largest configuration or tool table, bytes: some ten thousand tools.
const LARGEST_TEXT: u64 = 1 << 20;

/// The text of a configuration or a tool table; `what`: which of them.
pub(crate) fn read_text(path: &Path, what: &str) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(LARGEST_TEXT + 1).read_to_end(&mut bytes));
    read.map_err(|error| Failure::unreadable(path, error))?;
    if bytes.len() as u64 > LARGEST_TEXT {
        let text = format!("it is larger than {} MiB, the most for a {what}", LARGEST_TEXT >> 20);
        return Err(Failure::unreadable(path, io::Error::new(io::ErrorKind::FileTooLarge, text)));
    }
    String::from_utf8(bytes).map_err(|error| {
        let kind = io::ErrorKind::InvalidData;
        Failure::unreadable(path, io::Error::new(kind, error.utf8_error().to_string()))
    })
}
