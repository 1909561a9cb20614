//! The engine behind `machine!`: a declaration becomes exact algebra, a closed-form inverse, a proof, and Rust.
//!
//! An ordinary library, so that it can be tested, fuzzed and read; the proc-macro crate is a doorway to [`expand`].
//! Same input, same tokens: no I/O, no counters, no clock, no environment, no hash order.

pub mod check;
pub mod model;
pub mod proof;
pub mod report;
pub mod solve;
pub mod symbolic;
pub mod syntax;
