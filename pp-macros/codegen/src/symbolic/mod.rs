//! Exact algebra: numbers, polynomials, matrices, and the expression graph that becomes code.
//!
//! Two representations. [`Poly`] in the normal form of a [`Ring`] *decides*: two expressions are equal exactly if their
//! difference has remainder zero. [`Graph`] *computes*: its nodes are printed as Rust one to one, and
//! [`Interpreter`] reads the very same nodes back into polynomials, so what is proven is what runs. Nothing is ever
//! printed from a normal form: `k² → 1 - i² - j²` would lose half the digits near the pole.
//!
//! Knows nothing of machines.

mod graph;
mod interpret;
mod matrix;
mod poly;
mod ring;
mod sign;
mod surd;

pub use graph::{Graph, Id, Node, V3};
pub use interpret::Interpreter;
pub use matrix::{Matrix, P3, rotation, translation};
pub use poly::{Poly, Symbol};
pub use ring::Ring;
pub use sign::{Sign, sign_of, zeros_of};
pub use surd::{Surd, exact_sin_cos};
