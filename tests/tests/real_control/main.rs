//! Posted programs on a control that is not part of this project: LinuxCNC.
//!
//! Without LinuxCNC these tests print that they are skipped, and pass; with `PP_REQUIRE_LINUXCNC=1` they fail.

mod interpreter;
mod linuxcnc;
mod module;
mod real_time;
