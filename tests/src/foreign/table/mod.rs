//! One table a family: tokens into the common language.

mod geometry;
mod heidenhain;
mod iso;
mod siemens;

use super::lexer::Token;
use super::meaning::Command;
use super::state::State;
use super::{Control, Options};

/// Number of a cycle and its parameters by number, as one number (FNV-1a).
fn others(cycle: u32, parameters: impl Iterator<Item = (u32, Option<f64>)>) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64 ^ u64::from(cycle);
    for (index, value) in parameters.filter_map(|(index, value)| Some((index, value?))) {
        for part in [u64::from(index), (value + 0.0).to_bits()] {
            hash = (hash ^ part).wrapping_mul(0x0100_0000_01b3).rotate_left(23);
        }
    }
    hash
}

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
