//! Machines: equations of the papers, chains of every class, kinematics in C, parameters for controls that have a
//! transformation of their own.
//!
//! A suite is a module: `cargo test --workspace --test kinematics chains::` runs one.

mod c_header;
mod chains;
mod compare_sheets;
mod drawing;
mod library;
mod machines;
mod papers;
