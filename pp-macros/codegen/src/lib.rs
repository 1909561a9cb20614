//! The engine behind `machine!`: a declaration becomes exact algebra, a closed-form inverse, a proof, and Rust.
//!
//! An ordinary library, so that it can be tested, fuzzed and read; the proc-macro crate is a doorway to [`expand`].
//! Same input, same tokens: no I/O, no counters, no clock, no environment, no hash order.

pub mod check;
mod emit;
pub mod explain;
pub mod formula;
pub mod model;
pub mod proof;
pub mod report;
pub mod solve;
pub mod symbolic;
pub mod syntax;
pub mod verify;

use proc_macro2::TokenStream;

pub use emit::Options;
use report::{Errors, Refused};

/// Expands the inside of `machine! { ... }`: the machine, or one `compile_error!` for each mistake.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    expand_with(input, Options::default())
}

/// [`expand`] with choices.
#[must_use]
pub fn expand_with(input: TokenStream, options: Options) -> TokenStream {
    generate(input, options).unwrap_or_else(|refused| refused.to_compile_error())
}

/// The pipeline: parse, check, solve, prove, emit.
///
/// # Errors
/// Every mistake of the declaration.
pub fn generate(input: TokenStream, options: Options) -> Result<TokenStream, Refused> {
    let mut errors = Errors::default();
    let declaration = syntax::parse(input, &mut errors)?;
    let (mut model, spots) = check::check(&declaration, &mut errors)?;
    let mut solved = match solve::solve(&mut model) {
        Ok(solved) => solved,
        Err(refusals) => {
            check::report(&refusals, &model, &spots, &mut errors);
            errors.propagate()?;
            unreachable!("a refusal has a message");
        }
    };
    let proofs = match proof::prove(&model, &mut solved) {
        Ok(proofs) => proofs,
        Err(claim) => {
            check::unproven(&claim, &spots, &mut errors);
            errors.propagate()?;
            unreachable!("an unproven claim has a message");
        }
    };
    let verified = verify::verify(&declaration.verify, &model, &mut solved, &mut errors);
    errors.propagate()?;
    let explanation = explain::explain(&model, &solved, proofs, &verified);
    Ok(emit::emit(&declaration, &model, &solved, &explanation, options))
}
