//! Any bytes are posted as CL data; the first byte selects control and mode. A posted program must pass its check.
#![no_main]

use std::io::Cursor;

use fuzz::{SetUp, UNITS, chosen};
use libfuzzer_sys::fuzz_target;
use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::post::{Job, post};

fuzz_target!(|data: &[u8]| {
    let Some((SetUp { control, config }, text)) = chosen(data) else { return };
    let job = Job { cl_name: "fuzz.cls", config, control: *control, units: UNITS };
    let mut program = Vec::new();
    let report = post::<SpinnerU5620>(&job, &mut Cursor::new(text), &mut program).expect("memory is readable");
    assert!(program.is_ascii());
    if report.failed {
        return;
    }
    let policy = config.check_policy::<SpinnerU5620>(*control, UNITS).expect("they suit");
    let checked = check::<SpinnerU5620>(&policy, Cursor::new(text), &program[..]).expect("there is something to compare");
    let found = &checked.outcome.findings;
    assert!(found.is_empty() && checked.fault.is_none(), "{found:?}\n{}", String::from_utf8_lossy(&program));
});
