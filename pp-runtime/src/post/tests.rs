//! Tests of posting, from CL text to the bytes of a program.

mod checked;
mod header;
mod operations;
mod program;
mod refusals;

use std::io::Cursor;

use super::*;
use crate::control::{BlockNumbers, LinuxCnc};
use crate::kinematics::machines::Cb;

const PART: &str = "\
PARTNO BRACKET
UNITS/MM
TOOL PATH/ROUGH,TOOL,D10
CUTTER/10.0,0.5
LOADTL/1
SPINDL/RPM,6000,CLW
COOLNT/ON
RAPID
GOTO/0,0,20,0,0,1
RAPID
GOTO/0,0,2
FEDRAT/MMPM,800
GOTO/0,0,-3
GOTO/25,0,-3
END-OF-PATH
TOOL PATH/SIDE,TOOL,D10
LOADTL/1
FEDRAT/MMPM,300
GOTO/25,0,0,0.5,0,0.8660254
GOTO/25,8,0
FINI
";

fn posted<M: Machine>(config: &Config, text: &str) -> (String, Report) {
    let mut config = config.clone();
    // Its blocks are those of the control.
    config.motion.guards.offset_guard = false;
    let config = &config;
    let job = Job { cl_name: "bracket.cls", config, control: &LinuxCnc, units: None };
    let mut out = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(text.as_bytes()), &mut out).expect("memory neither fails nor fills");
    (String::from_utf8(out).expect("ASCII"), report)
}

/// The lines without the header.
fn blocks(text: &str) -> Vec<&str> {
    text.lines().skip_while(|line| line.starts_with('(')).collect()
}
