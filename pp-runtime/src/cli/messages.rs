//! Messages on standard error: diagnostics with the source line, notes, and errors without a place in a file.
//!
//! Writing a message never fails: if standard error is closed, the message is lost.

use std::collections::BTreeMap;
use std::io::{Read, Write};

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use serde::Serialize;

use crate::check::Finding;
use crate::diag::{Code, Diagnostic, LISTED_OF_A_KIND, Severity};
use crate::program::Location;

use super::args::MessageFormat;
use super::excerpt::{Excerpt, WIDTH, excerpts, visible};

/// Writes messages in the format of `--message-format`.
pub(crate) struct MessageWriter<'a> {
    out: &'a mut dyn Write,
    format: MessageFormat,
}

/// A message as JSON, one object per line.
#[derive(Serialize)]
struct JsonMessage<'a> {
    file: Option<&'a str>,
    line: Option<u64>,
    column: Option<u32>,
    length: Option<u32>,
    severity: &'a str,
    /// Class of an error or a warning; a note has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<&'static str>,
    text: &'a str,
    help: Option<&'a str>,
    /// Number of diagnostics or findings that the message represents.
    count: u64,
    /// Lines of the program that a finding is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    program: Option<JsonLines<'a>>,
}

/// Lines of a program as JSON.
#[derive(Serialize)]
struct JsonLines<'a> {
    file: Option<&'a str>,
    line: u64,
    last_line: u64,
    /// Text of the first block.
    block: &'a str,
}

impl<'a> MessageWriter<'a> {
    pub(crate) fn new(out: &'a mut dyn Write, format: MessageFormat) -> Self {
        Self { out, format }
    }

    /// Format in which they are written.
    pub(crate) fn format(&self) -> MessageFormat {
        self.format
    }

    /// An error of the run, without a place in a file.
    pub(crate) fn error(&mut self, code: Code, text: &str) {
        self.without_location("error", Some(code), &format!("error: {text}"), text);
    }

    /// A note without a place in a file.
    pub(crate) fn note(&mut self, text: &str) {
        self.without_location("note", None, text, text);
    }

    /// A warning without a place in a file.
    #[cfg(feature = "simulate")]
    pub(crate) fn warning(&mut self, code: Code, text: &str) {
        self.without_location("warning", Some(code), &format!("warning: {text}"), text);
    }

    fn without_location(&mut self, severity: &str, code: Option<Code>, human: &str, text: &str) {
        match self.format {
            MessageFormat::Human => self.line(human),
            MessageFormat::Json => {
                let (file, line, column, length, help) = (None, None, None, None, None);
                let (code, program) = (code.map(Code::name), None);
                self.json(&JsonMessage { file, line, column, length, severity, code, text, help, count: 1, program });
            }
        }
    }

    /// Diagnostics about the text `file`, in its order. Reads `source` to find the lines to show.
    pub(crate) fn diagnostics(&mut self, file: &str, source: &mut dyn Read, diagnostics: &[Diagnostic]) {
        let mut ordered: Vec<&Diagnostic> = diagnostics.iter().collect();
        ordered.sort_by_key(|diagnostic| diagnostic.location);
        match self.format {
            MessageFormat::Json => ordered.into_iter().for_each(|diagnostic| self.located(file, diagnostic, None)),
            MessageFormat::Human => self.human(file, source, &ordered),
        }
    }

    /// Findings in a program, in their order: by cause, the first block first. `file`: the CL data, whose lines
    /// `source` gives; `program`: file name of the program.
    pub(crate) fn findings(&mut self, file: &str, source: &mut dyn Read, program: Option<&str>, findings: &[Finding]) {
        let found: Vec<(&Finding, Diagnostic)> =
            findings.iter().map(|finding| (finding, finding.diagnostic())).collect();
        if self.format == MessageFormat::Json {
            for (finding, diagnostic) in &found {
                let Finding { line, last_line, block, .. } = finding;
                let lines = JsonLines { file: program, line: *line, last_line: *last_line, block };
                self.located(file, diagnostic, Some(lines));
            }
            return;
        }
        let places = found.iter().map(|(_, diagnostic)| (diagnostic.location, diagnostic.length));
        // If the lines cannot be read, the messages are shown without them.
        let excerpts = excerpts(source, places).unwrap_or_default();
        for (_, diagnostic) in &found {
            self.show(file, diagnostic, excerpts.get(&(diagnostic.location, diagnostic.length)));
        }
        let count: u64 = findings.iter().map(|finding| finding.count).sum();
        self.line(&format!("{file}: {count} {}", if count == 1 { "error" } else { "errors" }));
    }

    /// A diagnostic with its place as JSON.
    fn located(&mut self, file: &str, diagnostic: &Diagnostic, program: Option<JsonLines<'_>>) {
        self.json(&JsonMessage {
            file: Some(file),
            line: Some(diagnostic.location.line),
            column: Some(diagnostic.location.column),
            length: Some(diagnostic.length),
            severity: diagnostic.severity.name(),
            code: Some(diagnostic.code.name()),
            text: &diagnostic.text,
            help: diagnostic.help.as_deref(),
            count: diagnostic.count,
            program,
        });
    }

    /// Diagnostics as text: the first of each kind with their lines, a count of the others, and the totals.
    fn human(&mut self, file: &str, source: &mut dyn Read, ordered: &[&Diagnostic]) {
        let mut kinds: BTreeMap<String, KindCount> = BTreeMap::new();
        let mut shown = Vec::new();
        for diagnostic in ordered {
            let kind = kinds.entry(format!("{}: {}", diagnostic.severity.name(), diagnostic.kind())).or_default();
            if kind.count < LISTED_OF_A_KIND {
                shown.push(*diagnostic);
            }
            kind.count += 1;
            kind.last_line = diagnostic.location.line;
        }
        let places = shown.iter().map(|diagnostic| (diagnostic.location, diagnostic.length));
        // If the lines cannot be read, the messages are shown without them.
        let excerpts = excerpts(source, places).unwrap_or_default();
        for diagnostic in &shown {
            self.show(file, diagnostic, excerpts.get(&(diagnostic.location, diagnostic.length)));
        }
        for (text, kind) in kinds.iter().filter(|(_, kind)| kind.count > LISTED_OF_A_KIND) {
            let more = kind.count - LISTED_OF_A_KIND;
            self.line(&format!("{file}: {more} more like `{text}`, the last in line {}", kind.last_line));
        }
        let count = |severity| -> u64 {
            let found = ordered.iter().filter(|diagnostic| diagnostic.severity == severity);
            found.map(|diagnostic| diagnostic.count).sum()
        };
        let counts = [(count(Severity::Error), "error"), (count(Severity::Warning), "warning")];
        let counts: Vec<String> = counts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, name)| format!("{count} {name}{}", if *count == 1 { "" } else { "s" }))
            .collect();
        if !counts.is_empty() {
            self.line(&format!("{file}: {}", counts.join(", ")));
        }
    }

    fn show(&mut self, file: &str, diagnostic: &Diagnostic, excerpt: Option<&Excerpt>) {
        self.line(&headline(file, diagnostic));
        let help: Option<String> = diagnostic.help.as_deref().map(|help| help.chars().map(visible).collect());
        let help = help.map(|help| Level::HELP.message(help));
        let Some(Excerpt { text, indent, marked }) = excerpt else {
            let body = help.map(|help| render(Group::with_level(Level::HELP).element(help)));
            return body.into_iter().for_each(|body| self.block(&body));
        };
        let marked = &marked_as_word(text, *indent, *marked, diagnostic.length);
        let at = |character: usize| text.char_indices().nth(character).map_or(text.len(), |(byte, _)| byte);
        let level = if diagnostic.severity == Severity::Error { Level::ERROR } else { Level::WARNING };
        // No file has more lines than `usize` can count.
        let line = usize::try_from(diagnostic.location.line).unwrap_or_default();
        let snippet = Snippet::source(text.as_str())
            .line_start(line)
            .annotation(AnnotationKind::Primary.span(at(*indent)..at(indent + marked)));
        let group = Group::with_level(level).element(snippet).elements(help);
        self.block(&render(group));
    }

    /// Writes text whose characters are all visible, without blanks at the end of a line.
    fn block(&mut self, text: &str) {
        for line in text.lines() {
            let _ = writeln!(self.out, "{}", line.trim_end());
        }
    }

    fn json(&mut self, message: &JsonMessage<'_>) {
        // A structure of text and numbers always serialises.
        let _ = serde_json::to_string(message).map(|line| writeln!(self.out, "{line}"));
    }

    /// Writes a line, control characters made visible.
    fn line(&mut self, text: &str) {
        let text: String = text.chars().map(visible).collect();
        let _ = writeln!(self.out, "{text}");
    }
}

/// The source line with its mark, and the help, without colours.
fn render(group: Group<'_>) -> String {
    Renderer::plain().term_width(WIDTH + 40).render(&[group])
}

/// Number of diagnostics of one kind.
#[derive(Default)]
struct KindCount {
    count: u64,
    last_line: u64,
}

/// First line of a diagnostic: `part.cls:12:5: error: text`.
pub(crate) fn headline(file: &str, diagnostic: &Diagnostic) -> String {
    let Location { line, column } = diagnostic.location;
    format!("{file}:{line}:{column}: {}: {}", diagnostic.severity.name(), diagnostic.text)
}

/// Number of characters to mark. A diagnostic about a whole statement points at its first byte; then the word that
/// begins there is marked.
fn marked_as_word(text: &str, indent: usize, marked: usize, length: u32) -> usize {
    let mut characters = text.chars();
    if length > 1 || !characters.by_ref().take(indent).all(char::is_whitespace) {
        return marked;
    }
    let word = |character: &char| character.is_ascii_alphanumeric() || matches!(character, '-' | '_');
    characters.take_while(word).count().max(marked)
}
