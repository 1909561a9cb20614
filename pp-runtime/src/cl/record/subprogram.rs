//! Records of subprograms: DEFSUB, ENDSUB, CALSUB.

use std::fmt::{self, Display, Formatter};

use crate::cl::text::{Arg, Args, ClFault, Span};
use crate::diag::code::cl;

/// A record that defines or calls a subprogram.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SubprogramRecord {
    /// `DEFSUB/name`: the statements up to ENDSUB are executed at each call.
    Define(SubprogramName),
    /// `ENDSUB`.
    End,
    /// `CALSUB/name`.
    Call {
        /// Name of the subprogram.
        name: SubprogramName,
        /// Place of the name, for messages.
        at: Span,
    },
}

/// Largest number of bytes in the name of a subprogram.
const LONGEST_NAME: usize = 32;

/// Name of a subprogram: a number, or a word in capitals. In Creo it is the number of the NC sequence, unless the user
/// names it (*Supported CL Data Commands*).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SubprogramName {
    /// A number.
    Number(u32),
    /// A word, in capitals, with blanks after it.
    Word([u8; LONGEST_NAME]),
}

impl SubprogramName {
    fn parse(arg: Arg<'_>) -> Result<Self, ClFault> {
        if arg.looks_numeric() {
            return arg.integer().map(Self::Number);
        }
        let mut word = [b' '; LONGEST_NAME];
        let Some(place) = word.get_mut(..arg.text.len()) else {
            let text = format!("the name of a subprogram has at most {LONGEST_NAME} characters");
            return Err(cl::SUBPROGRAM.cl_fault(
                "subprogram",
                arg.at,
                text,
                "write a shorter name after DEFSUB and each CALSUB",
            ));
        };
        place.copy_from_slice(arg.text);
        word.make_ascii_uppercase();
        Ok(Self::Word(word))
    }
}

impl Display for SubprogramName {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(out, "{number}"),
            Self::Word(word) => out.write_str(String::from_utf8_lossy(word).trim_end()),
        }
    }
}

/// DEFSUB.
pub(crate) fn define(args: &mut Args<'_>) -> Result<SubprogramRecord, ClFault> {
    SubprogramName::parse(args.needed()?).map(SubprogramRecord::Define)
}

/// CALSUB.
pub(crate) fn call(args: &mut Args<'_>) -> Result<SubprogramRecord, ClFault> {
    let arg = args.needed()?;
    Ok(SubprogramRecord::Call { name: SubprogramName::parse(arg)?, at: arg.at })
}

impl Display for SubprogramRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Define(name) => write!(out, "DEFSUB/{name}"),
            Self::End => out.write_str("ENDSUB"),
            Self::Call { name, .. } => write!(out, "CALSUB/{name}"),
        }
    }
}
