//! The languages of the controls: one table for each family, and nothing is known that is not in it.
//!
//! A row is a code or a word: its spelling, its meaning (which `execute` carries out), the modal group in which a block
//! may have one code, the address words that it takes and those that it needs, and its source. A code that is in no
//! row, a word that no code of its block takes, and a word that a code needs and that is missing are faults of the
//! block.
//!
//! Rows that LinuxCNC, Fanuc and Haas share are in `iso`. Lists of arguments (Siemens) and of Q parameters (Heidenhain)
//! are in `arguments`; they too are complete.

pub(super) mod arguments;
mod fanuc;
mod haas;
mod heidenhain;
mod iso;
mod linuxcnc;
mod means;
mod print;
mod siemens;
mod texts;

pub(super) use arguments::{ArgumentRole, List};
pub(super) use means::{Address, Means, PathCode, Plane, Smoother, StatementWord};
pub(crate) use print::table;

use super::Family;
use super::orders::{Letters, Order};

/// Groups of codes of which a block may hold one, by number.
pub(super) mod group {
    pub(in super::super) const MOTION: u32 = 0;
    pub(in super::super) const PLANE: u32 = 1;
    pub(in super::super) const DISTANCE: u32 = 2;
    pub(in super::super) const FEED: u32 = 3;
    pub(in super::super) const UNITS: u32 = 4;
    pub(in super::super) const SIDE: u32 = 5;
    pub(in super::super) const LENGTH: u32 = 6;
    pub(in super::super) const OFFSET: u32 = 7;
    pub(in super::super) const RETURN: u32 = 8;
    pub(in super::super) const PATH: u32 = 9;
    pub(in super::super) const TILT: u32 = 10;
    pub(in super::super) const ALONE: u32 = 11;
    pub(in super::super) const STOP: u32 = 12;
    pub(in super::super) const SPINDLE: u32 = 13;
    pub(in super::super) const CENTRE: u32 = 14;
    pub(in super::super) const COOLANT: u32 = 16;
    pub(in super::super) const CHANGE: u32 = 17;
    pub(in super::super) const SMOOTHING: u32 = 18;
    pub(in super::super) const RIGID: u32 = 19;
    pub(in super::super) const TIP: u32 = 20;
    pub(in super::super) const WAY: u32 = 21;
    pub(in super::super) const CALL: u32 = 22;
    pub(in super::super) const WINDOW: u32 = 23;
    pub(in super::super) const POSTURE: u32 = 24;
    pub(in super::super) const FRAME: u32 = 25;
    pub(in super::super) const DYNAMIC_OFFSET: u32 = 26;
    pub(in super::super) const SCALING: u32 = 27;
    pub(in super::super) const POLAR: u32 = 28;
    pub(in super::super) const SETTING_ERROR: u32 = 29;
    pub(in super::super) const SPINDLE_MODE: u32 = 30;
    pub(in super::super) const DIAMETER: u32 = 32;
    pub(in super::super) const ROTATION: u32 = 33;
    pub(in super::super) const SHIFT: u32 = 34;
    /// Codes of no modal group.
    pub(in super::super) const FREE: u32 = 31;
}

/// One code or word of a control.
#[derive(Debug, Clone, Copy)]
pub(super) struct CodeRow {
    /// Spelling without leading zeros; a text of several words for statements.
    pub(crate) spelling: &'static str,
    /// Letter and number of a code, for the search: letter << 24, and the number in tenths.
    key: u32,
    /// Last code of a row for several.
    last: u32,
    pub(crate) means: Means,
    /// Modal group, of which a block may have one code.
    pub(crate) group: u32,
    /// Address words that the code takes.
    pub(crate) takes: Letters,
    /// Address words that its block must have.
    pub(crate) needs: Letters,
    /// When a function acts in a block that moves, where it is not as the other functions of the control.
    pub(crate) order: Option<Order>,
    /// It needs a block of its own.
    pub(crate) alone: bool,
    /// Manual with edition and page or section, or a public post.
    source: &'static str,
}

impl CodeRow {
    /// A code or a word that takes no address words.
    const fn new(spelling: &'static str, means: Means, group: u32, source: &'static str) -> Self {
        let key = key(spelling);
        Self { spelling, key, last: key, means, group, takes: 0, needs: 0, order: None, alone: false, source }
    }

    /// A statement or a word that is no G or M code.
    const fn word(spelling: &'static str, means: Means, source: &'static str) -> Self {
        Self { key: 0, last: 0, ..Self::new("G0", means, group::FREE, source) }.spelled(spelling)
    }

    const fn spelled(self, spelling: &'static str) -> Self {
        Self { spelling, ..self }
    }

    /// When the function acts.
    const fn acts(self, order: Order) -> Self {
        Self { order: Some(order), ..self }
    }

    /// It needs a block of its own.
    const fn alone(self) -> Self {
        Self { alone: true, ..self }
    }

    /// Whether it is an M code.
    pub(crate) const fn is_miscellaneous(&self) -> bool {
        self.key >> 24 == b'M' as u32
    }

    /// The modal group of a word.
    const fn of(self, group: u32) -> Self {
        Self { group, ..self }
    }

    /// The address words that it takes.
    const fn takes(self, words: &str) -> Self {
        Self { takes: self.takes | letters(words), ..self }
    }

    /// The address words that it takes and that its block must have.
    const fn needs(self, words: &str) -> Self {
        Self { takes: self.takes | letters(words), needs: letters(words), ..self }
    }

    /// The row is for every whole code up to this one.
    const fn up_to(self, last: &str) -> Self {
        Self { last: key(last), ..self }
    }

    /// The number of a code in tenths: 911 is G91.1.
    const fn number(code: u32) -> u32 {
        code & 0xff_ffff
    }
}

/// The language of a family.
#[derive(Debug)]
pub(super) struct Language {
    /// G and M codes in the order of their keys.
    codes: &'static [CodeRow],
    /// Address letters.
    letters: &'static [CodeRow],
    /// Address of each letter, A to Z.
    addresses: [Option<Address>; 26],
    /// Statements, keywords and words of several letters.
    pub(crate) words: &'static [CodeRow],
    /// Calls and cycles with their arguments.
    pub(crate) lists: &'static [List],
}

impl Language {
    const fn new(
        codes: &'static [CodeRow],
        letters: &'static [CodeRow],
        words: &'static [CodeRow],
        lists: &'static [List],
    ) -> Self {
        let mut addresses = [None; 26];
        let mut index = 0;
        while index < letters.len() {
            if let Means::Address(address) = letters[index].means {
                addresses[(letters[index].spelling.as_bytes()[0] - b'A') as usize] = Some(address);
            }
            index += 1;
        }
        Self { codes, letters, addresses, words, lists }
    }

    /// The row of a code, its number in tenths.
    #[inline]
    pub(super) fn code(&self, letter: u8, tenths: u32) -> Option<&'static CodeRow> {
        let wanted = u32::from(letter) << 24 | tenths;
        let row = self.codes[..self.codes.partition_point(|row| row.key <= wanted)].last()?;
        // A row of several codes is one of whole numbers.
        let among = wanted <= row.last && tenths % 10 == CodeRow::number(row.key) % 10;
        among.then_some(row)
    }

    /// Meaning of an address letter, upper case.
    #[inline]
    pub(super) fn address(&self, letter: u8) -> Option<Address> {
        *self.addresses.get(usize::from(letter.wrapping_sub(b'A')))?
    }

    /// The row of a word of several letters.
    pub(super) fn word(&self, word: &[u8]) -> Option<&'static CodeRow> {
        self.words.iter().find(|row| row.spelling.as_bytes().eq_ignore_ascii_case(word))
    }
}

impl Family {
    /// The language of the family.
    pub(super) const fn language(self) -> &'static Language {
        match self {
            Self::LinuxCnc => &linuxcnc::LANGUAGE,
            Self::Fanuc => &fanuc::LANGUAGE,
            Self::Haas => &haas::LANGUAGE,
            Self::Siemens => &siemens::LANGUAGE,
            Self::Heidenhain => &heidenhain::LANGUAGE,
        }
    }
}

/// Whether a letter is among them.
pub(super) const fn has_letter(letters: Letters, letter: u8) -> bool {
    letters & (1 << (letter - b'A')) != 0
}

/// Letters of a text as bits.
pub(super) const fn letters(text: &str) -> Letters {
    let bytes = text.as_bytes();
    let (mut index, mut bits) = (0, 0);
    while index < bytes.len() {
        bits |= 1 << (bytes[index] - b'A');
        index += 1;
    }
    bits
}

/// Key of a spelling: `G43.4` is G and 434.
const fn key(spelling: &str) -> u32 {
    let bytes = spelling.as_bytes();
    let (mut index, mut number, mut decimals) = (1, 0, 0);
    while index < bytes.len() && decimals < 2 {
        match bytes[index] {
            b'.' => {}
            digit => number = number * 10 + (digit - b'0') as u32,
        }
        decimals += if decimals > 0 || bytes[index] == b'.' { 1 } else { 0 };
        index += 1;
    }
    if decimals == 0 {
        number *= 10;
    }
    (bytes[0] as u32) << 24 | number
}

/// Rows of several tables in the order of their keys.
const fn sorted<const N: usize>(tables: &[&[CodeRow]]) -> [CodeRow; N] {
    let mut rows = [tables[0][0]; N];
    let (mut table, mut length) = (0, 0);
    while table < tables.len() {
        let mut index = 0;
        while index < tables[table].len() {
            let row = tables[table][index];
            let mut at = length;
            while at > 0 && rows[at - 1].key > row.key {
                rows[at] = rows[at - 1];
                at -= 1;
            }
            rows[at] = row;
            length += 1;
            index += 1;
        }
        table += 1;
    }
    assert!(length == N, "the number of rows");
    rows
}

#[cfg(test)]
mod tests;
