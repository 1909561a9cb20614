//! Controls: steps of the planner as blocks in the codes of one CNC.
//!
//! Each control is a table of codes, with methods for what no table can hold. Controls read no CL data and plan
//! nothing.
//!
//! - `dialects`: the table of each control, based on [`Spellings::ISO`] where it writes ISO blocks, and the list
//!   [`CONTROLS`].
//! - `states`: the states of each control that change the meaning of words, and how programs deal with them.
//! - [`template`]: blocks with named fields, used in tables and configurations.
//! - [`ControlOptions`]: settings of a job for its control; [`unfit`] lists those that the control does not support,
//!   [`take_out_lacking`] leaves those out that a program does without, and [`abilities`] states which functions of the
//!   control the planner may use. [`Layout`] is the part that the encoder reads.
//! - [`Encoder`]: converts steps to blocks.
//!
//! A control of one's own is a [`Control`] over one of these; its documentation has an example.
//!
//! ```
//! use pp_runtime::control::{CONTROLS, by_name};
//!
//! assert!(by_name("Siemens").is_some());
//! for control in CONTROLS {
//!     println!("{}: {}", control.spellings().name, control.spellings().title);
//! }
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod dialects;
mod encode;
mod fit;
mod foreign;
mod lacking;
mod layout;
mod mill_turn;
mod options;
mod state_values;
mod states;
pub mod template;
#[cfg(test)]
mod tests;

// Every control by name, and the types of its table.
pub use dialects::*;
pub use encode::Encoder;
pub(crate) use encode::comments;
pub use fit::{abilities, unfit, usable_modes};
pub(crate) use foreign::of_another_control;
pub use lacking::take_out_lacking;
pub use layout::{FramesUsed, Layout};
pub use mill_turn::{MillTurn, ToolSpindle};
pub use options::{
    BlockNumbers, ControlOptions, Demands, Messages, PlaneBy, ProgramBlocks, ProgramHeader, RetractMethod,
    TipControlSwitch,
};
pub(crate) use state_values::{ControlState, StepCycles};
pub(crate) use states::{ProgramUses, conditions, write_table};
