//! The machined stock against the design.
//!
//! `comparison` finds gouges and rest material along the lines of the stock, `nearest` has the distance from the
//! surface of the design.

mod comparison;
mod nearest;
#[cfg(test)]
mod tests;

pub(crate) use comparison::{ComparisonLimits, Design, DesignComparison, Deviations, Origin, Region, limits_of};
pub(crate) use nearest::TriangleSurface;
