//! A written program as it is executed on the stock.
//!
//! `simulation` receives its motions: they move the bodies of the machine, and `machining` turns them into pieces that
//! cut the stock and contacts into findings. `engagement` has the removal over time,
//! `outcome` states the findings, and what did not take part; `records` finds the CL records of lines that matter;
//! `recording` keeps the removal for a page; `set_ups` has the place of the part in each set-up, `tool_table` the tools
//! as the machine knows them.

mod engagement;
mod machining;
mod outcome;
mod recording;
mod records;
mod set_ups;
mod simulation;
#[cfg(test)]
mod tests;
mod tool_table;

pub(crate) use machining::{Machined, Machining};
pub(crate) use outcome::{EPS_MM, SimulationOutcome, Size, What};
pub(crate) use recording::{ClampedStage, Recording, RemovedPart};
pub(crate) use records::LineRecords;
pub(crate) use set_ups::PartPlaces;
pub(crate) use simulation::Simulation;
pub(crate) use tool_table::MachineToolTable;
