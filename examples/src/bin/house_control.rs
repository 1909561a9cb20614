//! A postprocessor with a control of one's own, which is the default of `--control`.
//!
//! `cargo run -p examples --bin house_control -- post examples/cl/two_tools.cls -o two_tools.nc`

use examples::house_control::House;
use pp_runtime::{cli, machine};

machine! {
    /// A table that rotates about Z on a table that tilts about Y.
    pub struct HouseTrunnion;
    chain: C B | X Y Z;
    d = { C: (0, 0, 0), B: (0, 0, height) };
    dims = { height: 75 };
    limits = { B: -110..110, C: free };
}

fn main() -> std::process::ExitCode {
    cli::App::new().control(&House).run::<HouseTrunnion>()
}
