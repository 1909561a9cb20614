#![doc = include_str!("../README.md")]
//!
//! The proc-macro crate only calls [`expand_with`]. Same input, same tokens: no I/O, no counters, no clock, no
//! environment, no hash order.
// A library returns its errors and leaves output to its caller.
#![cfg_attr(
    not(test),
    warn(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::print_stdout,
        clippy::print_stderr
    )
)]

pub mod check;
mod emit;
pub mod explain;
pub mod formula;
pub mod model;
pub mod proof;
pub mod report;
pub mod solve;
mod suggest;
pub mod symbolic;
pub mod syntax;
pub mod verify;

use proc_macro2::TokenStream;

use check::{Checked, Item};
pub use emit::Options;
use explain::Explanation;
use model::Model;
use report::{Errors, Refused};
use solve::Solved;
use verify::Verified;

/// Expands the inside of `machine! { ... }`: the machine, or one `compile_error!` for each mistake.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    expand_with(input, Options::default())
}

/// [`expand`] with options.
#[must_use]
pub fn expand_with(input: TokenStream, options: Options) -> TokenStream {
    generate(input, options).unwrap_or_else(|refused| refused.to_compile_error())
}

/// Everything known about a machine that compiles.
#[derive(Debug)]
pub struct Compiled {
    /// The struct as it is declared.
    pub item: Item,
    /// The machine, without syntax.
    pub model: Model,
    /// Its formulas, proven.
    pub solved: Solved,
    /// Equations of `verify` blocks, proven.
    pub verified: Vec<Verified>,
    /// The explanation for people.
    pub explanation: Explanation,
}

/// The pipeline: parse, check, solve, prove, verify, emit.
///
/// # Errors
/// Every mistake of the declaration.
pub fn generate(input: TokenStream, options: Options) -> Result<TokenStream, Refused> {
    let Compiled { item, model, solved, explanation, .. } = compile(input)?;
    Ok(emit::emit(&item, &model, &solved, &explanation, options))
}

/// The pipeline without its last step, `emit`.
///
/// # Errors
/// Every mistake of the declaration.
pub fn compile(input: TokenStream) -> Result<Compiled, Refused> {
    let mut errors = Errors::default();
    let declaration = syntax::parse(input, &mut errors)?;
    let Checked { model, item, phrases } = check::check(&declaration, &mut errors)?;
    let solved = solve::solve(&model);
    let solved = solved.map_err(|refusals| check::refused(&refusals, &model, &phrases, &mut errors))?;
    let proofs = proof::prove(&model, &solved);
    let proofs = proofs.map_err(|claim| check::unproven(&claim, &phrases, &mut errors))?;
    let verified = verify::verify(&declaration, &model, &solved, &mut errors);
    errors.propagate()?;
    let solved = verify::guarded(solved, &verified);
    let explanation = explain::explain(&model, &solved, proofs, &verified);
    Ok(Compiled { item, model, solved, verified, explanation })
}
