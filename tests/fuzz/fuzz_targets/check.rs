//! Any bytes are checked as a program against fixed CL data; the first byte selects control and mode.
#![no_main]

use std::io::Cursor;

use fuzz::{SetUp, UNITS, chosen};
use libfuzzer_sys::fuzz_target;
use machines::SpinnerU5620;
use pp_runtime::check::check;

const CL_DATA: &[u8] = include_bytes!("../../../pp-runtime/src/cl/tests/whole/nx.cls");

fuzz_target!(|data: &[u8]| {
    let Some((SetUp { control, config }, program)) = chosen(data) else { return };
    let policy = config.check_policy::<SpinnerU5620>(*control, UNITS).expect("they suit");
    let checked = check::<SpinnerU5620>(&policy, Cursor::new(&CL_DATA[1..]), program).expect("there is something to compare");
    assert!(checked.fault.is_none(), "{:?}", checked.fault);
    for found in &checked.outcome.findings {
        assert!(found.location.line >= 1, "{found:?}");
    }
});
