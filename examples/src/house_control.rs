//! A control of one's own: a Fanuc as its builder delivered it, with M-codes that no other machine has.

use std::sync::LazyLock;

use pp_runtime::control::{Control, Fanuc, LineEffect, Spellings};

/// The control of the shop.
#[derive(Debug, Clone, Copy)]
pub struct House;

static CODES: LazyLock<Spellings> = LazyLock::new(|| Spellings {
    name: "house",
    title: "House control",
    // The door of the tool magazine is opened and closed by the program.
    tool_change: &["M140", "T{tool} M6", "M141", "T{next}"],
    // Flood, mist, through the spindle, air.
    coolant: [Some(["M8", "M9"]), None, Some(["M51", "M59"]), None],
    ..Fanuc.spellings().clone()
});

impl Control for House {
    fn spellings(&self) -> &'static Spellings {
        &CODES
    }

    /// All that is not here is as on a Fanuc, and the check reads programs as those of a Fanuc.
    fn base(&self) -> Option<&'static dyn Control> {
        Some(&Fanuc)
    }

    /// What the check cannot know. Without it a program with these codes is refused.
    fn effects(&self) -> &'static [(&'static str, LineEffect)] {
        &[("M140", LineEffect::None), ("M141", LineEffect::None)]
    }

    /// The option of further work offsets, `G54.1 P1`, is not installed.
    fn work_offset(&self, word: &str) -> Option<String> {
        Fanuc.work_offset(word).filter(|code| !code.contains(' '))
    }
}
