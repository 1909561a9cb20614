//! The `machine!` macro; its engine is the ordinary library `pp_codegen`.
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

use proc_macro::TokenStream;

/// Declares a machine tool and generates its proven kinematics. Use it as `pp_runtime::machine!`, where its language is
/// documented.
#[proc_macro]
pub fn machine(input: TokenStream) -> TokenStream {
    let options = pp_codegen::Options { serde: cfg!(feature = "serde") };
    pp_codegen::expand_with(input.into(), options).into()
}
