//! Virtual machining: removal of material by moving tools, with certified ends.
//!
//! A [`Cutter`] is a few convex [`Profile`]s, a motion of one of them a [`SweptPiece`], and the stock a [`TriDexel`]:
//! lines in three directions, of which the swept space is removed. Every new end is within a tolerance of the true
//! sweep, on either side, however the tool turns and however closely a line grazes it: `sweep` has the mathematics.
//! What lies between two lines is not seen: nothing thinner than the pitch is.
//!
//! Motions are those of the check's stream, as the page gets them. The result is the same with any number of threads,
//! and memory depends on the stock, not on the program. What is not given is named as assumed or not checked.
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
//! `removal` has the stock and the moving tools, `bodies` triangles, `design` the comparison of the machined stock with
//! what was wanted, `tools` the tools of a program as bodies. `simulate IN.cls` executes a written program: `program`
//! turns its motions into pieces and contacts into findings.

mod bodies;
mod design;
mod groups;
mod machine;
mod program;
mod removal;
#[cfg(test)]
mod testing;
mod tools;

pub(crate) use bodies::{Mesh, SolidBody, SolidFault};
pub(crate) use design::{
    ComparisonLimits, Design, DesignComparison, Deviations, Origin, Region, TriangleSurface, limits_of,
};
pub(crate) use machine::{MachineLinks, MachineSolid, clearances, without_solids};
pub(crate) use program::{
    ClampedStage, EPS_MM, LineRecords, MachineToolTable, Machined, Machining, PartPlaces, Recording, RemovedPart,
    Simulation, SimulationOutcome, Size, What,
};
pub(crate) use removal::{EndValues, MarkedSurface};
pub(crate) use tools::ToolBodies;

pub use removal::{Contact, Cutter, Profile, ShapeFault, StockFault, SweptPiece, TriDexel};
