//! The page: one HTML file with its data, its style and its script.
//!
//! Data is in base64, and in JSON every `<` is written as an escape.

use std::io::{self, Write};
use std::thread::{self, ScopedJoinHandle};

use super::head::ViewHead;
use super::html::begin;
use super::sheet::JobSheet;
use super::{ViewedProgram, columns, report};

/// The script of the page, from `page/`.
const SCRIPT: &str = include_str!("../../page/dist/page.js");

/// Its style.
const STYLE: &str = include_str!("../../page/dist/page.css");

/// Writes the page of a program.
///
/// # Errors
/// Errors of the output.
pub(crate) fn write_page(program: &ViewedProgram<'_>, out: &mut dyn Write) -> io::Result<()> {
    thread::scope(|scope| {
        // Compression takes longest; meanwhile the pictures are drawn.
        let texts = [("program-text", program.text), ("cl-text", &program.cl_text)];
        let texts = texts.map(|(id, text)| (id, scope.spawn(move || columns::packed(text))));
        let columns = scope.spawn(|| program.columns());
        let sheet = JobSheet::of(program, false);
        begin(&sheet.title(), STYLE, Some(SCRIPT), out)?;
        out.write_all(b"<main id=\"summary\">\n")?;
        report::html(&sheet.overview(program)?, out)?;
        out.write_all(b"</main>\n<div id=\"app\"></div>\n")?;
        let (list, numbers) = joined(columns)?;
        let json = serde_json::to_string(&ViewHead::of(program, list))?.replace('<', "\\u003c");
        writeln!(out, "<script type=\"application/json\" id=\"program-head\">{json}</script>")?;
        writeln!(out, "<script type=\"text/plain\" id=\"program-columns\">{numbers}</script>")?;
        if let Some(simulation) = program.simulation() {
            let json = simulation?.replace('<', "\\u003c");
            writeln!(out, "<script type=\"application/json\" id=\"simulation\">{json}</script>")?;
        }
        for (id, text) in texts {
            writeln!(out, "<script type=\"text/plain\" id=\"{id}\">{}</script>", joined(text)?)?;
        }
        writeln!(out, "<script>{SCRIPT}</script>\n</body></html>")
    })
}

/// Result of a thread.
fn joined<T>(thread: ScopedJoinHandle<'_, io::Result<T>>) -> io::Result<T> {
    thread.join().unwrap_or_else(|_| Err(io::Error::other("compression stopped unexpectedly")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn script_and_style_of_the_page_end_where_their_elements_end() {
        assert!(!SCRIPT.to_ascii_lowercase().contains("</script") && !SCRIPT.contains("<!--"));
        assert!(!STYLE.to_ascii_lowercase().contains("</style"));
    }
}
