//! The page: one HTML file with its data, its style and its script.
//!
//! Its content security policy permits the script by its digest, and nothing from a network. Text is escaped, data is in
//! base64, and in JSON every `<` is written as an escape.

use std::fmt::{self, Display, Formatter};
use std::fs::File;
use std::io::{self, Read as _, Write};
use std::path::Path;
use std::thread::{self, ScopedJoinHandle};

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};

use super::head::ViewHead;
use super::sheet::JobSheet;
use super::{ViewedProgram, columns, report};

/// The script of the page, from `page/`.
const SCRIPT: &str = include_str!("../../page/dist/page.js");

/// Its style.
const STYLE: &str = include_str!("../../page/dist/page.css");

/// Rights of a document besides its script: style and pictures of its own, no address and no form.
const RIGHTS: &str = "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";

/// The element by which a document is known to be one of ours.
const GENERATOR: &str = "<meta name=\"generator\" content=\"pp-runtime\">";

/// Bytes at the begin of a document in which that element is.
const BEGIN_BYTES: u64 = 256;

/// Whether a file is a page or a set-up sheet written earlier.
pub(crate) fn is_document(path: &Path) -> bool {
    let mut begin = Vec::new();
    let read = File::open(path).and_then(|file| file.take(BEGIN_BYTES).read_to_end(&mut begin));
    read.is_ok() && memchr::memmem::find(&begin, GENERATOR.as_bytes()).is_some()
}

/// Text between tags and in attributes.
pub(crate) struct Escaped<T>(pub(crate) T);

impl<T: Display> Display for Escaped<T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.to_string().chars().try_for_each(|character| match character {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            '\'' => f.write_str("&#39;"),
            character => write!(f, "{character}"),
        })
    }
}

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

/// Begins a document. Only `script` may run in it.
pub(crate) fn begin(title: &str, style: &str, script: Option<&str>, out: &mut dyn Write) -> io::Result<()> {
    let digest = |script: &str| format!("; script-src 'sha256-{}'", BASE64_STANDARD.encode(Sha256::digest(script)));
    writeln!(
        out,
        "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">{GENERATOR}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'{}; {RIGHTS}\">\n\
         <title>{}</title>\n<style>{style}</style></head>\n<body>",
        script.map(digest).unwrap_or_default(),
        Escaped(title)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaped_text_opens_and_closes_nothing() {
        let text = Escaped("</script><img src='x' onerror=\"f(1 & 2)\">").to_string();
        assert_eq!(text, "&lt;/script&gt;&lt;img src=&#39;x&#39; onerror=&quot;f(1 &amp; 2)&quot;&gt;");
    }

    #[test]
    fn only_the_script_of_the_page_may_run() {
        let policy = |script| {
            let mut out = Vec::new();
            begin("A <b>", "", script, &mut out).expect("memory");
            let text = String::from_utf8(out).expect("UTF-8");
            assert!(text.contains("<title>A &lt;b&gt;</title>"), "{text}");
            let (_, rest) = text.split_once("content=\"default-src 'none'").expect("a policy");
            rest.split_once('"').expect("it ends").0.to_owned()
        };
        assert_eq!(policy(None), format!("; {RIGHTS}"));
        // The digest of `alert(1)` by `openssl dgst -sha256 -binary | base64`.
        let digest = "bhHHL3z2vDgxUt0W3dWQOrprscmda2Y5pLsLg4GF+pI=";
        assert_eq!(policy(Some("alert(1)")), format!("; script-src 'sha256-{digest}'; {RIGHTS}"));
    }

    #[test]
    fn script_and_style_of_the_page_end_where_their_elements_end() {
        assert!(!SCRIPT.to_ascii_lowercase().contains("</script") && !SCRIPT.contains("<!--"));
        assert!(!STYLE.to_ascii_lowercase().contains("</style"));
    }
}
