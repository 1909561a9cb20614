//! The machines of the source papers, one file each.
//!
//! A file holds the data of the machine alone: its chain, the travel of its rotary axes and `d`. Data of the set-up is
//! in the configuration.
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

mod dmu_70e;
mod lola_xoyzba;
mod multiprodesk;
mod spinner_u5_620;

pub use dmu_70e::Dmu70e;
pub use lola_xoyzba::LolaXoyzba;
pub use multiprodesk::MultiProDesk;
pub use spinner_u5_620::SpinnerU5620;
