//! Postprocessor of a machine with an inclined slide, a nutating head and held axes.

use std::process::ExitCode;

fn main() -> ExitCode {
    pp_runtime::cli::run::<tests::further::Inclined>()
}
