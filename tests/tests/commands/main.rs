//! The machines' binaries as people run them, and other programs that are started: cargo, a checker of another project.
//!
//! A suite is a module: `cargo test --workspace --test commands golden::` runs one.

mod cli;
mod config_files;
mod explain;
mod golden;
mod independent;
mod interrupted;
mod map;
mod outside;
mod proof_program;
mod read_back;
mod view;
mod virtual_machining;
