//! Programs in memory: posted, read back, damaged and checked on all machines, controls and modes.
//!
//! A suite is a module: `cargo test --workspace --test programs edits::` runs one. Nothing here runs another program,
//! except the LinuxCNC interpreter in `edits` and `contours`.

mod architecture;
mod attacks;
mod auto;
mod block_skip;
mod check_memory;
mod contours;
mod corruption;
mod course;
mod edits;
mod entries;
mod eyes;
mod faces;
mod findings;
mod foreign;
mod house;
mod inches;
mod linearised;
mod links;
mod mixed_job;
mod modes;
mod moved_zero;
mod near_limits;
mod near_poles;
mod new_folder;
mod no_alloc;
mod numbers;
mod operations;
mod options;
mod own_control;
mod plane_guards;
mod random_programs;
mod records;
mod restart;
mod set_ups;
mod settings;
#[cfg(debug_assertions)]
mod shortcuts;
mod states;
mod stream;
mod threads;
mod tilted_holes;

use tests::heap::Counting;

/// Counts for each test alone, since each runs in a thread of its own.
#[global_allocator]
static ALLOCATOR: Counting = Counting;
