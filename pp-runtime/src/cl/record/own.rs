//! Statements to which the user gives a meaning: words declared inert, and statements of the shop.

use super::words::{Handling, has_numbers_of_a_frame, is_word, look_up, major_word};
use crate::program::{BlockPlace, is_nc_text};

/// Word of a cycle at which a probe measures.
const PROBE_CYCLE: &str = "CYCLE/PROBE";

/// A statement of CL data and the NC blocks that are written in its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnStatement {
    /// The statement in capitals, without blanks: `CHUCK/OPEN`.
    statement: String,
    blocks: Vec<String>,
    probes: bool,
    place: BlockPlace,
    /// Its codes move nothing and change no state, though they are not the control's own.
    harmless: bool,
    /// Letter and number of the code, where it is an AUXFUN or a PREFUN.
    code: Option<(u8, u32)>,
}

impl OwnStatement {
    /// A statement, in any case and with any blanks, and its block: `CHUCK/OPEN` and `M68`.
    ///
    /// # Errors
    /// Says what is wrong with them: a word that is read, or whose statement changes the motions after it; a block that
    /// is empty or not of printable ASCII characters.
    pub fn new(statement: &str, block: &str) -> Result<Self, String> {
        Self::of(statement, &[block.to_owned()], false)
    }

    /// A statement and its blocks, one or more, or none for AUXFUN and PREFUN, which have their code: `AUXFUN/10`.
    /// `place`: where they come after the call of a tool.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn placed(statement: &str, blocks: &[String], place: BlockPlace, harmless: bool) -> Result<Self, String> {
        let own = match code_of(statement) {
            Some(_) if !blocks.is_empty() => {
                return Err(format!("`{statement}` has its code: no block takes its place, and `at` alone is read"));
            }
            Some(code) => {
                let statement = statement.to_ascii_uppercase().replace(' ', "");
                let block = format!("{}{}", char::from(code.0), code.1);
                Self { statement, blocks: vec![block], probes: false, place, harmless, code: Some(code) }
            }
            None => Self::of(statement, blocks, false)?,
        };
        Ok(Self { place, harmless, ..own })
    }

    /// A statement at which a probe measures from where the tool is, and the blocks for it: `PROBE/BORE,20`. The word
    /// may be CYCLE, with PROBE after it.
    ///
    /// # Errors
    /// Those of [`new`](Self::new), and that there is no block.
    pub fn probing(statement: &str, blocks: &[String]) -> Result<Self, String> {
        Self::of(statement, blocks, true)
    }

    fn of(statement: &str, blocks: &[String], probes: bool) -> Result<Self, String> {
        let word = &statement[..major_word(statement.as_bytes()).end];
        if !is_word(word) || !is_nc_text(statement.as_bytes()) || statement.contains('$') {
            return Err(format!("`{statement}` is not a statement of CL data"));
        }
        let capitals: String =
            statement.bytes().filter(|byte| *byte != b' ').map(|byte| byte.to_ascii_uppercase() as char).collect();
        let is_cycle = probes && (capitals == PROBE_CYCLE || capitals.starts_with(&format!("{PROBE_CYCLE},")));
        if let Some(row) = look_up(word.as_bytes()).filter(|_| !is_cycle) {
            match row.handling {
                Handling::Inert | Handling::Refused(_) => {}
                Handling::Read(_) | Handling::ReadText(_) => {
                    return Err(format!("{word} is read, so its statements have no other meaning"));
                }
                Handling::Automatic(reason) | Handling::Hazard(reason) => {
                    return Err(format!("no block takes the place of {word}: {reason}"));
                }
                Handling::Lathe => return Err(format!("no block takes the place of {word}: it belongs to turning")),
            }
        }
        if !probes && look_up(word.as_bytes()).is_none() && has_numbers_of_a_frame(statement.as_bytes()) {
            return Err(format!("no block takes the place of `{statement}`: its numbers may state a frame"));
        }
        let is_block =
            |block: &String| block.split('\n').all(|line| !line.trim().is_empty() && is_nc_text(line.as_bytes()));
        if blocks.is_empty() {
            return Err(format!("`{statement}` has no block: give it in `blocks`"));
        }
        if !blocks.iter().all(is_block) {
            return Err(
                "a block has ASCII letters, digits and signs; others are read differently by controls".to_owned()
            );
        }
        let blocks = blocks.iter().map(|block| block.trim().to_owned()).collect();
        Ok(Self { statement: capitals, blocks, probes, place: BlockPlace::InOrder, harmless: false, code: None })
    }

    /// The statement in capitals, without blanks.
    #[must_use]
    pub fn statement(&self) -> &str {
        &self.statement
    }

    /// The blocks that are written in its place, one or more.
    #[must_use]
    pub fn blocks(&self) -> &[String] {
        &self.blocks
    }

    /// Where they come after the call of a tool.
    #[must_use]
    pub fn place(&self) -> BlockPlace {
        self.place
    }

    /// Whether its codes are known to move nothing and to change no state.
    #[must_use]
    pub fn is_harmless(&self) -> bool {
        self.harmless
    }

    /// Letter and number of the code of AUXFUN or PREFUN.
    #[must_use]
    pub fn code(&self) -> Option<(u8, u32)> {
        self.code
    }

    /// Whether a probe measures there.
    #[must_use]
    pub fn probes(&self) -> bool {
        self.probes
    }

    fn is(&self, text: &[u8]) -> bool {
        let written = text.iter().filter(|byte| !byte.is_ascii_whitespace()).map(u8::to_ascii_uppercase);
        written.eq(self.statement.bytes())
    }

    fn word(&self) -> &[u8] {
        &self.statement.as_bytes()[..major_word(self.statement.as_bytes()).end]
    }
}

/// Letter and number of the code of `AUXFUN/10`, `PREFUN/10`.
fn code_of(statement: &str) -> Option<(u8, u32)> {
    let (word, number) = statement.split_once('/')?;
    let letter = match word.trim() {
        word if word.eq_ignore_ascii_case("AUXFUN") => b'M',
        word if word.eq_ignore_ascii_case("PREFUN") => b'G',
        _ => return None,
    };
    let number = number.trim();
    let is_number = number.bytes().all(|byte| byte.is_ascii_digit());
    Some((letter, number.parse().ok().filter(|_| is_number)?))
}

/// What the user says about words that are not read.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct GivenMeanings<'o> {
    /// Words that are passed over.
    pub(crate) inert: &'o [String],
    pub(crate) own: &'o [OwnStatement],
    pub(crate) probes: &'o [OwnStatement],
}

impl<'o> GivenMeanings<'o> {
    pub(crate) fn is_inert(self, word: &[u8]) -> bool {
        self.inert.iter().any(|inert| word.eq_ignore_ascii_case(inert.as_bytes()))
    }

    /// The statements of the shop.
    fn all(self) -> impl Iterator<Item = &'o OwnStatement> {
        self.own.iter().filter(|own| own.code.is_none()).chain(self.probes)
    }

    /// Index of the statement of the shop that a statement is.
    pub(crate) fn own(self, text: &[u8]) -> Option<usize> {
        self.all().position(|own| own.is(text))
    }

    /// The statement of the shop of an index.
    pub(crate) fn own_at(self, index: usize) -> Option<&'o OwnStatement> {
        self.all().nth(index)
    }

    /// The statements of the shop that begin with this word.
    pub(crate) fn beginning_with(self, word: &[u8]) -> impl Iterator<Item = &'o str> {
        self.all().filter(move |own| word.eq_ignore_ascii_case(own.word())).map(OwnStatement::statement)
    }
}
