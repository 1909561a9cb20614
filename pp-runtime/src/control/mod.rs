//! How each control spells what the planner asks for: a table of spellings, and hooks where tables end.
//!
//! Controls know steps and words, nothing of CL data, and plan nothing.
//!
//! - `dialects`: the table of each control, on [`Spellings::ISO`] where it writes ISO blocks, and the list [`CONTROLS`].
//! - [`template`]: blocks with named fields, as tables and configurations hold them.
//! - [`ControlOptions`]: what a job sets; [`unfit`] and [`abilities`]: whether it fits the control, and what the planner may use;
//!   [`Layout`]: what of it the encoder reads.
//! - [`Encoder`]: steps into blocks.

mod dialects;
mod encode;
mod fit;
mod layout;
mod options;
pub mod template;
#[cfg(test)]
mod tests;

// Every control by its name, and the types of their tables.
pub use dialects::*;
pub use encode::Encoder;
pub(crate) use encode::{legible, lines_of};
pub use fit::{abilities, unfit};
pub use layout::Layout;
pub use options::{ControlOptions, Demands, ProgramBlocks, Smoothing};
