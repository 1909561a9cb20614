//! Dialects: one file per control, with its table of codes and the methods for what no table can hold.
//!
//! A control that writes ISO blocks starts from [`Spellings::ISO`] and states its differences, with manual and page. A
//! new control of this crate also needs its `mod` line and its line in [`CONTROLS`] in this file; one outside of it is
//! given to `cli::App`.

mod control;
mod fanuc;
mod functions;
mod haas;
mod heidenhain;
mod iso;
mod linuxcnc;
mod siemens;
mod spellings;

pub use control::{BlankWords, Control, LengthGuard, PlaneGuard, RadiusGuard};
pub(crate) use functions::ControlFunction;
pub use functions::LineEffect;
#[cfg(test)]
pub(crate) use spellings::HoleCycles;
pub use spellings::Spellings;
pub(crate) use spellings::{
    ArcCentre, Cancel, CycleCodes, CycleDefinitions, CycleForm, LengthCall, LinearRapids, MachineRetract, MessageStyle,
    RetractForm, STANDARD_M, ThreadCodes, TipControlCodes, ToolAxisWords,
};

/// Declares the list of controls and the public name of each.
macro_rules! controls {
    ($($file:ident::$control:ident,)*) => {
        $(pub use $file::$control;)*

        /// Every control, the default first.
        pub const CONTROLS: &[&dyn Control] = &[$(&$control),*];
    };
}

controls! {
    linuxcnc::LinuxCnc,
    fanuc::Fanuc,
    siemens::Siemens,
    heidenhain::Heidenhain,
    haas::Haas,
}

/// Whether the language of a control is that of the default of the command line, for which a first program without a
/// set-up file is posted.
#[must_use]
pub(crate) fn is_default_family(control: &dyn Control) -> bool {
    CONTROLS.first().is_some_and(|default| default.spellings().name == control.family())
}

/// The control with this name of the command line; upper or lower case.
#[must_use]
pub fn by_name(name: &str) -> Option<&'static dyn Control> {
    CONTROLS.iter().copied().find(|control| control.spellings().name.eq_ignore_ascii_case(name))
}
