//! The conformance suite: what every machine must do, checked against matrices that share no code with the engine.
//!
//! - [`oracle`]: the chain as a product of 4×4 matrices, and the machines of the source papers written out by hand.
//! - [`mod@conformance`]: the checks, for any type that implements
//!   [`Machine`](pp_runtime::kinematics::Machine); [`conformance!`] makes a test module of them.
//! - [`random`]: the same random numbers on every platform, forever.
//! - [`further`]: machines of kinds that the papers do not have.
//! - [`heap`]: an allocator that counts.
//! - [`block`]: how far a block of the machine leaves its line, looked at everywhere.
//! - [`damage`]: programs with one character wrong.
//! - [`foreign`]: an interpreter for programs of all five controls that shares no code with the postprocessor.
//! - [`agreement`]: the same programs through the product's own reader and the foreign interpreter.
//! - [`linuxcnc`]: a real control, its interpreter alone and the whole of it, simulated.
//! - [`binaries`]: the machines' binaries, built and run.
//!
//! Nothing here knows how a machine solves its equations. NaN fails a check, it never passes one.

pub mod agreement;
pub mod binaries;
pub mod block;
pub mod conformance;
pub mod damage;
pub mod foreign;
pub mod further;
pub mod heap;
pub mod linuxcnc;
pub mod oracle;
pub mod random;
mod subject;

#[cfg(test)]
mod reference;
