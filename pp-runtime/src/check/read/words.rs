//! Words and codes of one line, each of which is taken once.

use super::language::{Address, CodeRow, has_letter};
use super::orders::Letters;
use super::text::Number;

/// How the value of a word counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counts {
    AsInForce,
    Absolute,
    Incremental,
    /// Absolute, by the shortest path.
    Shortest,
}

/// A word with a number.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word {
    pub(crate) address: Address,
    /// Axis of an axis word by its position in the chain; component of a centre or of the tool axis; otherwise 0.
    pub(crate) index: u8,
    /// Its letter, if it has no other name.
    pub(crate) letter: Option<u8>,
    pub(crate) number: Number,
    pub(crate) counts: Counts,
    /// Its column, from 0.
    pub(crate) column: usize,
}

impl Word {
    /// A word before its name is known. `column`: from 0.
    pub(super) fn new(address: Address, index: usize, number: Number, counts: Counts, column: usize) -> Self {
        Self { address, index: index as u8, letter: None, number, counts, column }
    }
}

/// A code by its row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coded {
    pub(crate) row: &'static CodeRow,
    /// Its number in tenths; 0 of a keyword.
    pub(crate) number: u32,
    /// First column and the one after the last, from 0.
    pub(crate) column: usize,
    pub(crate) end: usize,
}

/// Words that are not taken yet, and the codes.
#[derive(Debug, Default)]
pub(super) struct OpenWords {
    words: Vec<Word>,
    codes: Vec<Coded>,
    /// Calls that need a block of their own: their columns.
    pub(crate) calls: Vec<usize>,
}

impl OpenWords {
    pub(super) fn clear(&mut self) {
        self.words.clear();
        self.codes.clear();
        self.calls.clear();
    }

    /// Adds a word; `false` if it is there already.
    pub(super) fn add(&mut self, word: Word) -> bool {
        let same =
            |other: &Word| other.address == word.address && other.index == word.index && other.letter == word.letter;
        let first = !self.words.iter().any(same);
        self.words.push(word);
        first
    }

    pub(super) fn add_code(&mut self, code: Coded) {
        self.codes.push(code);
    }

    pub(super) fn codes(&self) -> &[Coded] {
        &self.codes
    }

    /// Those that are left.
    pub(super) fn left(&self) -> &[Word] {
        &self.words
    }

    /// Whether a word is left.
    pub(super) fn has(&self, address: Address) -> bool {
        self.words.iter().any(|word| word.address == address)
    }

    /// Takes a word.
    pub(super) fn take(&mut self, address: Address) -> Option<Word> {
        self.take_if(|word| word.address == address)
    }

    /// Takes the word of a letter, if it is among those that a code takes.
    pub(super) fn take_letter(&mut self, letter: u8, takes: Letters) -> Option<Word> {
        if has_letter(takes, letter) { self.take_if(|word| word.letter == Some(letter)) } else { None }
    }

    /// Takes the first word that suits.
    pub(super) fn take_if(&mut self, suits: impl Fn(&Word) -> bool) -> Option<Word> {
        let at = self.words.iter().position(suits)?;
        Some(self.words.remove(at))
    }
}
