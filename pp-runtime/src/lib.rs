#![doc = include_str!("../README.md")]
//!
//! ## How it works
//!
//! Data flows in one direction: CL text → records → motions → axis values → blocks → text.
#![cfg_attr(not(feature = "std"), no_std)]
// A library returns its errors and leaves output to its caller.
#![cfg_attr(
    not(test),
    warn(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::print_stdout,
        clippy::print_stderr
    )
)]

// Generated code names `::pp_runtime`, also inside this crate's own tests.
extern crate self as pp_runtime;

pub use nalgebra;
#[doc = include_str!("machine.md")]
pub use pp_macros::machine;
#[cfg(feature = "serde")]
#[doc(hidden)]
pub use serde;

pub mod kinematics;

#[cfg(feature = "std")]
pub mod check;
#[cfg(feature = "std")]
pub mod cl;
#[cfg(feature = "std")]
pub mod cli;
#[cfg(feature = "std")]
pub mod config;
#[cfg(feature = "std")]
pub mod control;
#[cfg(feature = "std")]
pub mod diag;
#[cfg(feature = "std")]
#[doc(hidden)]
pub mod inside;
#[cfg(feature = "std")]
mod keys;
#[cfg(feature = "std")]
mod motion;
#[cfg(feature = "std")]
mod nc;
#[cfg(feature = "std")]
mod options;
#[cfg(feature = "std")]
pub mod post;
#[cfg(feature = "std")]
pub mod program;
#[cfg(feature = "std")]
pub mod set_up;
#[cfg(feature = "std")]
mod shortcut;
#[cfg(feature = "simulate")]
pub mod simulate;
#[cfg(feature = "std")]
mod tolerance;
#[cfg(feature = "std")]
pub mod transformation;
#[cfg(feature = "std")]
mod view;
