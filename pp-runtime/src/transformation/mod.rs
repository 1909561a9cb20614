//! Kinematics for the control, from the same declaration: tip control needs the machine's chain in the control.
//!
//! - [`c_header`]: forward and inverse kinematics as C99, for firmware, simulators and other CAM.
//! - [`linuxcnc`]: a kinematics module of LinuxCNC for this machine, with a simulated machine to try it.
//! - [`compare_sheet`]: the parameters that the transformation of a Siemens, Fanuc, Heidenhain or Haas control must
//!   hold, or a kinematics module that LinuxCNC brings, to be compared by the builder of the machine.
//!
//! The formulas of the first two are those that were proven when the machine was compiled
//! ([`CSource`](crate::kinematics::CSource)); only the frame around them is written here. The sheets are computed from
//! the joints as declared. Nothing is written to files here.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::transformation::{SheetControl, c_header, compare_sheet};
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let machine = Trunnion::default();
//! assert!(c_header(&machine, "trunnion")?.contains("int trunnion_inverse"));
//! let sheet = compare_sheet(&machine, &Config::default(), SheetControl::Siemens)?;
//! assert!(sheet.contains("TRAFO"), "{sheet}");
//! # Ok::<(), pp_runtime::transformation::NotExpressible>(())
//! ```

use crate::kinematics::AnyMachine;

mod c;
pub mod linuxcnc;
mod math;
mod sheet;

pub use c::c_header;
pub(crate) use c::{identifier, machine_identifier};
pub use sheet::{SheetControl, compare_sheet};

/// The reason why kinematics for a control cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct NotExpressible(pub(crate) String);

/// Refuses a machine whose dimensions are missing, or with which its formulas do not hold.
fn complete(machine: &dyn AnyMachine) -> Result<(), NotExpressible> {
    machine.validate().map_err(|invalid| NotExpressible(invalid.to_string()))
}
