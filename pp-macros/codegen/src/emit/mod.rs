//! A solved and proven machine as Rust, and as C for other places. Nothing here can fail.
//!
//! Generated Rust names only `::core` and the runtime (`::pp_runtime`, or the path of the field `crate`), allocates
//! nothing and contains no loop.

mod body;
mod c;
mod inputs;
mod inverse;
mod kinematics;
mod machine;
mod motion;
mod options;

use proc_macro2::TokenStream;
use quote::quote;

use crate::check::Item;
use crate::explain::Explanation;
use crate::model::Model;
use crate::solve::Solved;
use inverse::Wanted;
pub use options::Options;

/// The struct, its private position function, and its `Machine` implementation.
pub(crate) fn emit(
    declared: &Item,
    model: &Model,
    solved: &Solved,
    explanation: &Explanation,
    options: Options,
) -> TokenStream {
    let item = machine::item(declared, model, explanation, options);
    let data = machine::data(model, explanation, &c::source(model, solved));
    let set_up = machine::set_up(model, solved);
    let forward = kinematics::forward(model, solved);
    let linear_axes = kinematics::linear_axes(model, solved);
    let joints = kinematics::joints(model, solved);
    let inverse = inverse::inverse(model, solved);
    let rotary_axes = inverse::rotary_axes(model, solved);
    let reach = inverse::reach(model, solved);
    let motion = motion::motion(model, &solved.motion);
    let (position, position_signature) = kinematics::position(model, solved);
    let edges =
        [Wanted::AllAxes, Wanted::RotaryAxes].into_iter().filter_map(|wanted| inverse::edge(model, solved, wanted));
    let (edges, edge_signatures): (Vec<_>, Vec<_>) = edges.unzip();
    let Item { name, configured, runtime, .. } = declared;
    let count = model.axes.len();
    quote! {
        #item
        #(#configured)*
        // Declared angles and directions are printed with all their digits.
        #[allow(deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
        const _: () = {
            // These names may mean something else at the declaration.
            use ::core::primitive::{f64, str, usize};
            use #runtime::{self as pp, kinematics::math};

            /// Functions that the methods of `Machine` share; in a trait, so that they cannot clash with methods of the
            /// user.
            trait Shared {
                #position_signature
                #(#edge_signatures)*
            }

            impl Shared for #name {
                #position
                #(#edges)*
            }

            #[automatically_derived]
            impl pp::kinematics::Machine for #name {
                type Axes = [f64; #count];
                #data
                #set_up
                #joints
                #forward
                #inverse
                #rotary_axes
                #linear_axes
                #reach
                #motion
            }
        };
    }
}
