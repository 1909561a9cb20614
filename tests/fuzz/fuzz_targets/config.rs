//! Any bytes are a configuration file with CL data after it: nothing panics, whatever the two are together.
#![no_main]

use fuzz::post_with_any_configuration;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| post_with_any_configuration(data));
