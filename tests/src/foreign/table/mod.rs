//! One table a family: tokens into the common language.

mod geometry;
mod heidenhain;
mod iso;
mod siemens;

use super::lexer::Token;
use super::meaning::Command;
use super::state::State;
use super::{Control, Options};

/// The block that some tokens mean, in the state before it.
///
/// # Errors
/// If a word or a code is unknown to the control, or to this reader.
pub(super) fn command(options: &Options, tokens: &[Token], state: &State) -> Result<Command, String> {
    match options.control {
        Control::LinuxCnc | Control::Fanuc | Control::Haas => iso::command(options, tokens, state),
        Control::Siemens => siemens::command(tokens, state),
        Control::Heidenhain => heidenhain::command(tokens, state),
    }
}
