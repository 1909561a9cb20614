#![doc = include_str!("../README.md")]
//!
//! ## Modules
//!
//! - [`mod@conformance`]: the checks, for any type that implements
//!   [`Machine`](pp_runtime::kinematics::Machine); [`conformance!`] makes a test module of them.
//! - [`oracle`]: the chain as a product of 4×4 matrices, and the machines of the source papers written out by hand.
//! - [`block`]: largest deviation of a block of the machine from its line, sampled along the block.
//! - [`random`]: random numbers that are the same on every platform and in every version.
//!
//! Nothing here depends on how a machine solves its equations. NaN fails a check; it never passes one.

pub mod block;
pub mod conformance;
pub mod oracle;
pub mod random;
mod subject;
