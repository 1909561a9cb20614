//! Options of the caller.

/// Parts that are generated on demand.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// Derive `serde::Serialize` and `serde::Deserialize`.
    pub serde: bool,
}
