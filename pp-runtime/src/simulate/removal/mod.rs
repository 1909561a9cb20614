//! Removal of material by moving tools, with certified ends.
//!
//! A [`Cutter`] is a few convex [`Profile`]s, a motion of one of them a [`SweptPiece`], and the stock a [`TriDexel`]:
//! lines in three directions, of which the swept space is removed. Every new end is within a tolerance of the true
//! sweep, on either side, however the tool turns and however closely a line grazes it: `sweep` has the mathematics.
//! `surface` makes triangles of the stock.

mod in_order;
mod profile;
mod stock;
mod surface;
mod sweep;
#[cfg(test)]
mod tests;

pub(crate) use stock::{FilledPart, Removed};
pub(crate) use surface::{EndValues, MarkedSurface};

pub use profile::{Cutter, Profile, ShapeFault};
pub use stock::{Contact, StockFault, TriDexel};
pub(crate) use sweep::LARGEST_TURN;
pub use sweep::SweptPiece;
