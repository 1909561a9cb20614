//! Controls: steps of the planner as blocks in the codes of one CNC.
//!
//! Each control is a table of codes, with methods for what no table can hold. Controls read no CL data and plan
//! nothing.
//!
//! - `dialects`: the table of each control, based on [`Spellings::ISO`] where it writes ISO blocks, and the list
//!   [`CONTROLS`].
//! - `states`: the states of each control that change the meaning of words, and how programs deal with them.
//! - [`template`]: blocks with named fields, used in tables and configurations.
//! - [`ControlOptions`]: settings of a job for its control; `unfit` lists those that the control does not support,
//!   `take_out_lacking` leaves those out that a program does without, and `abilities` states which functions of the
//!   control the planner may use. `Layout` is the part that the encoder reads.
//! - `Encoder`: converts steps to blocks.
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

pub use dialects::{
    BlankWords, CONTROLS, Control, Fanuc, Haas, Heidenhain, LengthGuard, LineEffect, LinuxCnc, PlaneGuard, RadiusGuard,
    Siemens, Spellings, by_name,
};
pub(crate) use dialects::{ControlFunction, CycleForm, LinearRapids, RetractForm, is_default_family};
pub(crate) use encode::{Encoder, comments};
pub(crate) use fit::{abilities, unfit, usable_modes};
pub(crate) use foreign::of_another_control;
pub(crate) use lacking::take_out_lacking;
pub(crate) use layout::{FramesUsed, Layout};
pub(crate) use mill_turn::ToolSpindle;
pub(crate) use options::{BlockNumbers, Demands, Messages, ProgramHeader};
pub use options::{ControlOptions, PlaneBy, TipControlSwitch};
pub(crate) use state_values::{ControlState, StepCycles};
pub(crate) use states::{ProgramUses, conditions, write_table};
#[cfg(test)]
pub(crate) use {dialects::HoleCycles, mill_turn::MillTurn, options::ProgramBlocks};
