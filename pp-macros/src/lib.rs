//! The `machine!` macro; the engine behind it is the ordinary library `pp_codegen`.

use proc_macro::TokenStream;

/// Declares a machine tool and generates its proven kinematics.
#[proc_macro]
pub fn machine(input: TokenStream) -> TokenStream {
    let options = pp_codegen::Options { serde: cfg!(feature = "serde") };
    pp_codegen::expand_with(input.into(), options).into()
}
