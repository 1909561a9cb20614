//! The library of the suites: conformance checks of every machine against matrices that share no code with the engine,
//! and an independent reader of programs.
//!
//! - [`oracle`]: the chain as a product of 4×4 matrices, and the machines of the source papers written out by hand.
//! - [`mod@conformance`]: the checks, for any type that implements
//!   [`Machine`](pp_runtime::kinematics::Machine); [`conformance!`] makes a test module of them.
//! - [`random`]: random numbers that are the same on every platform and in every version.
//! - [`further`]: machines of kinds that the papers do not have.
//! - [`heap`]: a counting allocator.
//! - [`block`]: largest deviation of a block of the machine from its line, sampled along the block.
//! - [`by_hand`]: machines against chains written out by hand.
//! - [`damage`]: programs with one fault.
//! - [`edits`]: edits of posted programs, and the harm that each does.
//! - [`foreign`]: an interpreter for programs of all five controls that shares no code with the postprocessor.
//! - [`agreement`]: compares the product's own reader with the foreign interpreter, on the same program.
//! - [`linuxcnc`]: a real control: its interpreter alone, and the whole control, simulated.
//! - [`golden`]: golden programs with all that their check needs.
//! - [`page`]: the data of a page, decoded, and its machine multiplied out.
//! - [`binaries`]: the machines' binaries, built and run.
//!
//! Nothing here depends on how a machine solves its equations. NaN fails a check; it never passes one.

pub mod agreement;
pub mod binaries;
pub mod block;
pub mod by_hand;
pub mod conformance;
pub mod damage;
pub mod edits;
pub mod foreign;
pub mod further;
pub mod golden;
pub mod heap;
pub mod linuxcnc;
pub mod oracle;
pub mod page;
pub mod random;
mod subject;

#[cfg(test)]
mod reference;
