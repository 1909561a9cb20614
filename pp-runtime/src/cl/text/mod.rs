//! Text of CL data: bytes to statements, and the arguments of a statement to words and numbers.
//!
//! `lexer` splits the input into statements, `line_shape` reads a line of numbers like the line before, `args` splits
//! the arguments of a statement, `number` reads decimal numbers, `encoding` letters, `fault` holds what is wrong with a
//! statement and where. No word of CL data is known here.

mod args;
mod blanks;
mod encoding;
mod fault;
mod lexer;
mod line_shape;
mod number;

pub(crate) use self::args::{Arg, Args, MajorWord, trimmed};
pub(crate) use self::blanks::{is_blank, skip_blanks};
pub(crate) use self::encoding::decoded;
pub(crate) use self::fault::{ClFault, Help, Span, quoted};
pub(crate) use self::lexer::{Beginning, LONGEST_STATEMENT, Lexer, NumberLine, PhysicalLine, Statement, StatementKind};
pub(crate) use self::number::{number_at_start, whole_number};
