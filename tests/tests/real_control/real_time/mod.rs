//! The whole control, simulated. It runs in real time, and a computer runs one at a time: these tests wait, and
//! `.ci/run` starts them beside those that compute.

mod generated;
mod job;
pub(super) mod kinematics;
mod sweep;
