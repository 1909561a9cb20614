//! What a control that nobody here wrote makes of our programs: LinuxCNC.
//!
//! Without LinuxCNC these tests say so and pass; with `PP_REQUIRE_LINUXCNC=1` they have to run.

mod interpreter;
mod kinematics;
mod sweep;
