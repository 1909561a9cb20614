//! Environment variables of the suites.

use std::env;

/// Whether expected files are written, not compared: `PP_BLESS=1`.
#[must_use]
pub fn blesses() -> bool {
    is_one("PP_BLESS")
}

/// Whether a variable is set to 1.
#[must_use]
pub fn is_one(name: &str) -> bool {
    env::var_os(name).is_some_and(|value| value == "1")
}

/// Number in a variable; `None` if it is not set.
///
/// # Panics
/// If it is set, and no number.
#[must_use]
pub fn number(name: &str) -> Option<u64> {
    let text = env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} must be a number, found {text}")))
}
