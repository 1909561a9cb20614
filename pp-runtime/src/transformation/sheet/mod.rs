//! Compare sheets: the parameters that the five-axis transformation of a control must hold for a machine.
//!
//! A sheet has each parameter with the value that follows from the declaration, or the key that is missing, next to a
//! blank for the value that the machine holds. A person compares and signs: nothing here is a file that a control
//! loads. Each parameter has its source; where no public manual settles a value, the sheet says so and names the test
//! at the machine that does. A chain that the model of the control cannot express is refused with the reason.
//!
//! One file for each control; `chain` has the chain as such models see it, `rows` the parameters, `print` the text,
//! `tests_at_machine` the tests.

mod chain;
mod fanuc;
mod haas;
mod heidenhain;
mod linuxcnc;
mod print;
mod rows;
mod siemens;
mod tests_at_machine;

use crate::config::Config;
use crate::kinematics::AnyMachine;

use super::{NotExpressible, complete};

use print::print;

/// A control with a transformation of its own, whose parameters are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SheetControl {
    /// SINUMERIK: swivel data record (CYCLE800) and machine data (TRAORI).
    Siemens,
    /// Parameters of five-axis machining (G43.4, G68.2).
    Fanuc,
    /// Kinematics table of the machine builder (M128, TCPM, PLANE).
    Heidenhain,
    /// Settings of the rotary zero point (G234, G254).
    Haas,
    /// Pins of the kinematics modules that LinuxCNC brings.
    LinuxCnc,
}

impl SheetControl {
    /// Name of the control, as in `--control`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Siemens => "siemens",
            Self::Fanuc => "fanuc",
            Self::Heidenhain => "heidenhain",
            Self::Haas => "haas",
            Self::LinuxCnc => "linuxcnc",
        }
    }
}

/// The compare sheet of a machine as text, lines of at most 96 characters.
///
/// `machine` has the dimensions and the part origin of `config`. Lengths are printed in mm with four decimals, angles
/// in degrees, unit vectors with seven decimals. A value that needs a key of `config` which is not given has the name
/// of that key in its place.
///
/// # Errors
/// The reason why the model of the control cannot express the chain.
pub fn compare_sheet(
    machine: &dyn AnyMachine,
    config: &Config,
    control: SheetControl,
) -> Result<String, NotExpressible> {
    complete(machine)?;
    let sheet = match control {
        SheetControl::Siemens => siemens::sheet(machine, config),
        SheetControl::Fanuc => fanuc::sheet(machine, config),
        SheetControl::Heidenhain => heidenhain::sheet(machine, config),
        SheetControl::Haas => haas::sheet(machine, config),
        SheetControl::LinuxCnc => linuxcnc::sheet(machine, config),
    }?;
    Ok(print(machine, config, &sheet))
}
