//! Machine, fixtures, stock and tool as bodies that move against each other.
//!
//! `links` is the chain as what moves together, `body` a body with its shapes, `gap` the distance of two of them,
//! `reach` how far they can move against each other. `assembly` makes the bodies of a job, and `clearance` follows the
//! distances of all pairs through its program.

mod assembly;
mod body;
mod clearance;
mod gap;
mod links;
mod reach;
#[cfg(test)]
mod tests;

pub(crate) use assembly::{MachineSolid, clearances, stock_boxes, without_solids};
pub(crate) use clearance::{AxesInMotion, Clearances, Meeting, MovingBlock, Occasion, SHOWN_MM, Share};
pub(crate) use links::MachineLinks;
