//! Options of the caller.

/// Parts that are generated on demand.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// Derive `serde::Serialize` and `serde::Deserialize`. A missing field has its default, an unknown one is refused.
    pub serde: bool,
}
