//! Kinematics for the control, from the same declaration: tip control needs the machine's chain in the control.
//!
//! - [`c_header`]: forward and inverse kinematics as C99, for firmware, simulators and other CAM.
//! - [`linuxcnc`]: a kinematics module of LinuxCNC for this machine, with a simulated machine to try it.
//!
//! The formulas are those that were proven when the machine was compiled ([`CSource`](crate::kinematics::CSource)); only the
//! frame around them is written here. Nothing is written to files here.

mod c;
pub mod linuxcnc;

pub use c::{c_header, identifier, machine_identifier};

/// The reason why kinematics for a control cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct NotExpressible(pub(crate) String);
