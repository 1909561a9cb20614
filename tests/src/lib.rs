//! The library of the suites: the conformance checks of [`pp_conformance`], and an independent reader of programs.
//!
//! - [`further`]: machines of kinds that the papers do not have.
//! - [`by_name`]: machines and controls by their names.
//! - [`heap`]: a counting allocator.
//! - [`by_hand`]: machines against chains written out by hand.
//! - [`damage`]: programs with one fault.
//! - [`edits`]: edits of posted programs, and the harm that each does.
//! - [`foreign`]: an interpreter for programs of all five controls that shares no code with the postprocessor.
//! - [`agreement`]: compares the product's own reader with the foreign interpreter, on the same program.
//! - [`linuxcnc`]: a real control: its interpreter alone, and the whole control, simulated.
//! - [`golden`]: golden programs with all that their check needs.
//! - [`posting`]: CL data posted in memory, and compared by the check.
//! - [`page`]: the data of a page, decoded, and its machine multiplied out.
//! - [`binaries`]: the machines' binaries, built and run.
//! - [`environment`]: environment variables of the suites.
//!
//! Nothing here depends on how a machine solves its equations. NaN fails a check; it never passes one.

pub use pp_conformance::{block, conformance, oracle, random};

pub mod agreement;
pub mod binaries;
pub mod by_hand;
pub mod by_name;
pub mod damage;
pub mod edits;
pub mod environment;
pub mod foreign;
pub mod further;
pub mod golden;
pub mod heap;
pub mod linuxcnc;
pub mod page;
pub mod posting;

#[cfg(doctest)]
mod book;
#[cfg(test)]
mod reference;
