//! Virtual machining: removal of material by moving tools, with certified ends.
//!
//! A [`Cutter`] is a few convex [`Profile`]s, a motion of one of them a [`SweptPiece`], and the stock a [`TriDexel`]: lines
//! in three directions, of which the swept space is removed. Every new end is within a tolerance of the true sweep, on either
//! side, however the tool turns and however closely a line grazes it: `sweep` has the mathematics. What lies between two lines
//! is not seen: nothing thinner than the pitch is.
//!
//! ```
//! use nalgebra::{Point3, Vector3};
//! use pp_runtime::kinematics::Pose;
//! use pp_runtime::simulate::{Cutter, SweptPiece, TriDexel};
//!
//! let ball = Cutter::Mill { radius: 3.0, corner: 3.0, taper: 0.0, length: 20.0 };
//! let mut stock = TriDexel::block([[0.0; 3], [20.0, 10.0, 5.0]], 0.25)?;
//! let at = |x: f64| Pose { tip: Point3::new(x, 5.0, 4.0), axis: Vector3::z_axis() };
//! let contacts = stock.cut(&[SweptPiece::new(&at(-5.0), &at(25.0), 0, 1)], &ball.pieces()?, 1e-3, 1);
//! // A segment of a circle, 1 mm deep.
//! assert!((contacts[0].volume() - 20.0 * 3.0975).abs() < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `simulate IN.cls` executes a written program: `tool_body` has its tools, `machining` turns its motions into pieces and
//! contacts into findings, `outcome` states them, and what did not take part. `comparison` measures the machined stock against
//! a design, with `nearest` for the distance from its surface.

mod comparison;
mod machining;
mod mesh;
mod nearest;
mod outcome;
mod profile;
mod stock;
mod sweep;
#[cfg(test)]
mod tests;
mod tool_body;

pub(crate) use comparison::{Comparison, Design, Deviations, Origin, Region, limits_of};
pub(crate) use machining::{EPS_MM, LineRecords, Machining};
pub(crate) use outcome::Outcome;
pub(crate) use tool_body::ToolBodies;

pub use mesh::{Mesh, MeshFault};
pub use profile::{Cutter, Profile, ShapeFault};
pub use stock::{Contact, Effort, Filled, StockFault, TriDexel};
pub use sweep::{LARGEST_TURN, SweptPiece};
