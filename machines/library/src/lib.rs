//! Machines that people own or build, one file each, beside those of the papers in `machines`.
//!
//! A file names the source of its chain and of its travel. Where a source does not state something, the file says so: a
//! slide that may carry the table instead of the head, or the direction of a positive word, is to be compared with the
//! jog sheet of `NAME explain`. No dimension is invented: what every machine has of its own is `required`, and nothing
//! is posted until it is measured. Travel of linear axes is declared where the source states it in machine coordinates.
//!
//! This package is apart from `machines`, so that the binaries of the papers do not compile it.
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

mod bridge_mill;
mod haas_rotary;
mod haas_trunnion;
mod haas_umc;
mod integrex_i200;
mod max5;
mod oblique_y_lathe;
mod pocketnc_v2;
mod xyzab_tdr;
mod xyzac_trt;
mod xyzacb_trsrn;
mod xyzbc_trt;

pub use bridge_mill::BridgeMill;
pub use haas_rotary::HaasRotary;
pub use haas_trunnion::HaasTrunnion;
pub use haas_umc::HaasUmc;
pub use integrex_i200::IntegrexI200;
pub use max5::Max5;
pub use oblique_y_lathe::ObliqueYLathe;
pub use pocketnc_v2::PocketNcV2;
pub use xyzab_tdr::XyzabTdr;
pub use xyzac_trt::XyzacTrt;
pub use xyzacb_trsrn::XyzacbTrsrn;
pub use xyzbc_trt::XyzbcTrt;
