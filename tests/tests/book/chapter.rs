//! A chapter as text: its listings, links and options.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use tests::binaries::workspace;

/// The list of the chapters.
pub(crate) const SUMMARY: &str = "SUMMARY.md";

/// The folder of the chapters.
pub(crate) const SOURCE: &str = "docs/src";

/// Pages beside the book that are read and tried like its chapters.
const READMES: [&str; 2] = ["README.md", "examples/cl/README.md"];

/// A chapter of the book, or a page beside it.
pub(crate) struct Chapter {
    /// Its file, from the workspace.
    pub(crate) path: PathBuf,
    lines: Vec<String>,
}

/// A listing: the lines between two fences.
pub(crate) struct Listing {
    /// First line, from 0.
    pub(crate) line: usize,
    /// First word after the fence.
    pub(crate) language: String,
    /// Second word after the fence: the file that is shown.
    pub(crate) file: Option<String>,
    pub(crate) lines: Vec<String>,
}

impl Listing {
    pub(crate) fn text(&self) -> String {
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }

    pub(crate) fn range(&self) -> Range<usize> {
        self.line..self.line + self.lines.len()
    }
}

impl Chapter {
    pub(crate) fn of(path: PathBuf, text: &str) -> Self {
        Self { path, lines: text.lines().map(str::to_owned).collect() }
    }

    pub(crate) fn read(path: PathBuf) -> Self {
        let text = fs::read_to_string(workspace().join(&path));
        let text = text.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Self::of(path, &text)
    }

    /// The chapters in the order of the summary.
    pub(crate) fn of_book() -> Vec<Self> {
        let source = Path::new(SOURCE);
        Self::read(source.join(SUMMARY)).links().map(|name| Self::read(source.join(name))).collect()
    }

    /// The chapters, and the pages beside the book.
    pub(crate) fn all() -> Vec<Self> {
        let beside = READMES.iter().map(|path| Self::read(path.into()));
        beside.chain(Self::of_book()).collect()
    }

    /// The file to which a link leads, from the workspace.
    pub(crate) fn target(&self, link: &str) -> PathBuf {
        if link.is_empty() { self.path.clone() } else { self.path.with_file_name(link) }
    }

    pub(crate) fn listings(&self) -> Vec<Listing> {
        let fences: Vec<usize> =
            (0..self.lines.len()).filter(|line| self.lines[*line].trim_start().starts_with("```")).collect();
        assert!(fences.len().is_multiple_of(2), "{}: a listing has no end", self.path.display());
        let listing = |pair: &[usize]| {
            let mut words = self.lines[pair[0]].trim_start_matches([' ', '`']).split_whitespace().map(str::to_owned);
            let language = words.next().unwrap_or_default();
            Listing {
                line: pair[0] + 1,
                language,
                file: words.next(),
                lines: self.lines[pair[0] + 1..pair[1]].to_vec(),
            }
        };
        fences.chunks(2).map(listing).collect()
    }

    /// The lines that are in no listing.
    fn prose(&self) -> impl Iterator<Item = &str> {
        let listings: Vec<_> =
            self.listings().iter().map(|listing| listing.line - 1..listing.range().end + 1).collect();
        let is_prose = move |line: &usize| !listings.iter().any(|range| range.contains(line));
        (0..self.lines.len()).filter(is_prose).map(|line| self.lines[line].as_str())
    }

    /// Targets of the links and pictures.
    pub(crate) fn links(&self) -> impl Iterator<Item = String> {
        let targets = |line: &str| -> Vec<String> {
            line.split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())).collect()
        };
        self.prose().flat_map(targets)
    }

    /// Files that mdBook includes.
    pub(crate) fn included(&self) -> impl Iterator<Item = String> {
        self.prose().filter_map(|line| Some(line.strip_prefix("{{#include ")?.strip_suffix("}}")?.to_owned()))
    }

    /// Headings as the ends of links: small letters, `-` for blanks, no punctuation.
    pub(crate) fn headings(&self) -> impl Iterator<Item = String> {
        let anchor = |line: &str| {
            let kept = |letter: &char| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter);
            line.trim_start_matches(['#', ' '])
                .to_lowercase()
                .chars()
                .filter(kept)
                .collect::<String>()
                .replace(' ', "-")
        };
        self.prose().filter(|line| line.starts_with('#')).map(anchor)
    }

    /// Options of the machines in the text: `--` and letters in code, outside listings; those of cargo are left out.
    pub(crate) fn options(&self) -> impl Iterator<Item = String> {
        let of_code = |code: &str| -> Vec<String> {
            let own = match code.split_once(" -- ") {
                Some((_, own)) => own,
                None if code.starts_with("cargo ") => "",
                None => code,
            };
            let is_option = |word: &&str| word.strip_prefix("--").is_some_and(|name| !name.is_empty());
            let letters = |word: &str| word.trim_end_matches(|end: char| !end.is_ascii_lowercase()).to_owned();
            own.split_whitespace().filter(is_option).map(letters).collect()
        };
        let of_line = move |line: &str| line.split('`').skip(1).step_by(2).flat_map(of_code).collect::<Vec<_>>();
        self.prose().flat_map(of_line)
    }

    /// Replaces lines, from the last to the first, and writes the file if it changes.
    pub(crate) fn rewrite(&mut self, outputs: Vec<(Range<usize>, String)>) {
        if outputs.is_empty() {
            return;
        }
        for (range, text) in outputs.into_iter().rev() {
            self.lines.splice(range, text.lines().map(str::to_owned));
        }
        let text: String = self.lines.iter().map(|line| format!("{line}\n")).collect();
        fs::write(workspace().join(&self.path), text).expect("a chapter can be written");
    }
}

/// Lines of an output as a chapter shows them, with `...` for lines that are left out.
pub(crate) struct Part<'a>(Vec<&'a str>);

impl<'a> Part<'a> {
    pub(crate) fn of(text: &'a str) -> Self {
        Self(text.lines().map(str::trim_end).collect())
    }

    /// Whether these are the lines of `text`.
    pub(crate) fn is_in(&self, text: &str) -> bool {
        let real: Vec<&str> = text.lines().map(str::trim_end).collect();
        let pieces: Vec<&[&str]> = self.0.split(|line| *line == "...").collect();
        let (first, last) = (pieces[0], pieces[pieces.len() - 1]);
        if pieces.len() == 1 {
            return real == first;
        }
        if real.len() < first.len() + last.len() || !real.starts_with(first) || !real.ends_with(last) {
            return false;
        }
        let mut rest = &real[first.len()..real.len() - last.len()];
        for piece in &pieces[1..pieces.len() - 1] {
            let found = (0..=rest.len()).find(|from| rest[*from..].starts_with(piece));
            let Some(from) = found else { return false };
            rest = &rest[from + piece.len()..];
        }
        true
    }
}
