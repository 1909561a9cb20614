//! Posted programs on a control that is not part of this project: LinuxCNC.
//!
//! Without LinuxCNC these tests print that they are skipped, and pass; with `PP_REQUIRE_LINUXCNC=1` they fail.

mod generated;
mod interpreter;
mod job;
mod kinematics;
mod linuxcnc;
mod module;
mod sweep;
