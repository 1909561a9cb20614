//! Choices of the caller.

/// What else is generated.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// Derive `serde::Serialize` and `serde::Deserialize`.
    pub serde: bool,
}
