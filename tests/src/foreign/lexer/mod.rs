//! Text into tokens: one lexer a family, which knows how words look and nothing of what they mean.
//!
//! A lexer accepts what its control accepts (lower case, blanks inside a block, leading zeros); [`tidy`] refuses text
//! that a control would run and no program of ours contains.

mod heidenhain;
mod iso;
mod number;
mod siemens;
pub mod tidy;

use super::Control;
use super::meaning::NumberCounting;

pub use number::Number;

/// One line of a program, those that continue it joined.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Block number.
    pub number: Option<u32>,
    /// Rest of the line.
    pub content: Content,
}

/// What a line is.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// A comment or a message, without its marks.
    Comment(String),
    /// A mark that belongs to the file: `%`, `O0001 (NAME)`, `* - NAME`, `BLK FORM`.
    Mark(Mark),
    /// A line of a condition: its text, for the guards.
    Condition(String),
    /// A block.
    Block(Vec<Token>),
}

/// Lines that belong to the file and not to a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// `%`.
    Tape,
    /// Program number or name.
    Name,
    /// `BEGIN PGM`, with its unit; `true`: inches.
    Begin(bool),
    /// `END PGM`.
    End,
    /// A title, or the form of the blank.
    Remark,
}

/// Part of a block.
#[derive(Debug, Clone, PartialEq)]
pub enum Token {
    /// `X12`, `CR=5`, `Q200=+2`, `X=IC(5)`: the name in upper case.
    Word {
        /// Name.
        name: String,
        /// Number.
        number: Number,
        /// `AC()` and `IC()`.
        counting: NumberCounting,
    },
    /// A number alone: `TOOL CALL 1`.
    Number(Number),
    /// `SUPA`, `FMAX`, `DR+`.
    Name(String),
    /// `CYCLE81(..)`.
    Call {
        /// Name.
        name: String,
        /// Arguments; `None` where one is empty or a text.
        arguments: Vec<Option<f64>>,
    },
}

/// Reads a line.
///
/// # Errors
/// If the text is no line of a program of this control.
pub fn line(control: Control, text: &str) -> Result<Line, String> {
    if !text.is_ascii() {
        return Err("a byte that is not ASCII".to_owned());
    }
    match control {
        Control::LinuxCnc | Control::Fanuc | Control::Haas => iso::line(control, text),
        Control::Siemens => siemens::line(text),
        Control::Heidenhain => heidenhain::line(text),
    }
}

/// Lines of a program with their numbers from 1; lines of a Heidenhain program that end in `~` are joined to the next,
/// and a semicolon outside of brackets ends a block on Fanuc and Haas.
#[must_use]
pub fn joined(control: Control, text: &str) -> Vec<(usize, String)> {
    let mut lines: Vec<(usize, String)> = Vec::new();
    let mut continued = false;
    for (index, line) in text.split_terminator('\n').enumerate() {
        if matches!(control, Control::Fanuc | Control::Haas) {
            let blocks = iso::blocks(line);
            lines.extend(blocks.into_iter().map(|block| (index + 1, block.to_owned())));
            continue;
        }
        let goes_on = control == Control::Heidenhain && line.ends_with('~');
        let part = match goes_on || continued {
            true => line.strip_suffix('~').unwrap_or(line).split(';').next().unwrap_or_default().trim_end(),
            false => line,
        };
        match lines.last_mut().filter(|_| continued) {
            Some((_, whole)) => {
                whole.push(' ');
                whole.push_str(part.trim_start());
            }
            None => lines.push((index + 1, part.to_owned())),
        }
        continued = goes_on;
    }
    lines
}

/// Takes the block number off the beginning of a block.
fn take_number(tokens: &mut Vec<Token>) -> Result<Option<u32>, String> {
    match tokens.first() {
        Some(Token::Word { name, number, .. }) if name == "N" => {
            let number = super::meaning::whole(number.value)?;
            tokens.remove(0);
            Ok(Some(number))
        }
        _ => Ok(None),
    }
}
