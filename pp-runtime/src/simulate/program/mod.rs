//! A written program as it is executed on the stock.
//!
//! `tools` has the tools of the program as bodies, `machining` turns its motions into pieces and contacts into findings,
//! `outcome` states them, and what did not take part; `records` finds the CL records of lines that matter.

mod machining;
mod outcome;
mod records;
mod tools;

pub(crate) use machining::{EPS_MM, Machining};
pub(crate) use outcome::Outcome;
pub(crate) use records::LineRecords;
pub(crate) use tools::ToolBodies;
