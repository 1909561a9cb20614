//! Records of subprograms: DEFSUB, ENDSUB, CALSUB.

use std::fmt::{self, Display, Formatter};

use crate::cl::text::{Args, ClFault, Span};

/// A record that defines or calls a subprogram.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SubprogramRecord {
    /// `DEFSUB/n`: the statements up to ENDSUB are executed at each call.
    Define(u32),
    /// `ENDSUB`.
    End,
    /// `CALSUB/n`.
    Call {
        /// Number of the subprogram.
        number: u32,
        /// Place of the number, for messages.
        at: Span,
    },
}

/// DEFSUB.
pub(crate) fn define(args: &mut Args<'_>) -> Result<SubprogramRecord, ClFault> {
    args.needed()?.integer().map(SubprogramRecord::Define)
}

/// CALSUB.
pub(crate) fn call(args: &mut Args<'_>) -> Result<SubprogramRecord, ClFault> {
    let arg = args.needed()?;
    Ok(SubprogramRecord::Call { number: arg.integer()?, at: arg.at })
}

impl Display for SubprogramRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Define(number) => write!(out, "DEFSUB/{number}"),
            Self::End => out.write_str("ENDSUB"),
            Self::Call { number, .. } => write!(out, "CALSUB/{number}"),
        }
    }
}
