//! Any bytes through the whole way to a program.
#![no_main]

use std::io::Cursor;

use libfuzzer_sys::fuzz_target;
use machines::SpinnerU5620;
use pp_runtime::cl::{Frames, Insert};
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use pp_runtime::post::{Job, post};
use pp_runtime::program::{Rotation, Units};

fuzz_target!(|data: &[u8]| {
    let mut config = Config::default();
    config.defaults.speed = Some(3000.0);
    config.defaults.rotation = Some(Rotation::Clockwise);
    config.defaults.tool = Some(1);
    config.retract.distance = Some(50.0);
    config.cl.insert = Insert::Write;
    config.cl.frames = Frames::Main;
    let job = Job { cl_name: "fuzz.cls", config: &config, control: &LinuxCnc, units: Some(Units::Millimetres) };
    let mut program = Vec::new();
    let report = post::<SpinnerU5620>(&job, &mut Cursor::new(data), &mut program).expect("memory is readable");
    assert!(program.is_ascii());
    assert_eq!(report.failed, !program.ends_with(b"M2\n"));
});
