//! Machines and controls by their names on the command line and in the names of golden programs.

use pp_runtime::control::{self, CONTROLS, Control};

/// The part with every feature: its modes, and the operations that can be posted in each. The fifth is a thread, which
/// no control cuts under tip control; in the fourth the tool axis rotates.
pub const WORKS: [(&str, &str); 4] = [("axes", "1..5"), ("tcp", "1..4"), ("plane", "1..3"), ("auto", "1..5")];

/// The commands of every machine.
pub const COMMANDS: [&str; 12] = [
    "post",
    "check",
    "view",
    "report",
    "simulate",
    "explain-block",
    "config",
    "explain",
    "kinematics",
    "new",
    "completions",
    "man",
];

/// Every control of the product.
pub fn controls() -> impl Iterator<Item = &'static str> {
    CONTROLS.iter().map(|control| control.spellings().name)
}

/// Controls that have tip control and a tilted plane without a configuration.
pub fn controls_with_tip_control() -> impl Iterator<Item = &'static str> {
    controls().filter(|name| *name != "linuxcnc")
}

/// Programs of the part with every feature: mode, control, operations.
pub fn works() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    WORKS.into_iter().flat_map(|(mode, operations)| {
        let has_mode = move |name: &&str| matches!(mode, "axes" | "auto") || *name != "linuxcnc";
        controls().filter(has_mode).map(move |control| (mode, control, operations))
    })
}

/// The control of this name.
///
/// # Panics
/// If there is none.
#[must_use]
pub fn control(name: &str) -> &'static dyn Control {
    control::by_name(name).unwrap_or_else(|| panic!("{name} is no control"))
}

/// Calls a generic function for the machine of this name.
#[macro_export]
macro_rules! with_machine {
    ($name:expr, $function:ident($($argument:expr),*)) => {
        match $name {
            "dmu-70e" => $function::<machines::Dmu70e>($($argument),*),
            "lola-xoyzba" => $function::<machines::LolaXoyzba>($($argument),*),
            "multiprodesk" => $function::<machines::MultiProDesk>($($argument),*),
            "spinner-u5-620" => $function::<machines::SpinnerU5620>($($argument),*),
            "head-table" => $function::<$crate::further::HeadTable>($($argument),*),
            "mill" => $function::<$crate::further::Mill>($($argument),*),
            name => panic!("{name} is no machine"),
        }
    };
}
