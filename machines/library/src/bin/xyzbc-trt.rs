//! The postprocessor of one machine.

fn main() -> std::process::ExitCode {
    pp_runtime::cli::run::<machine_library::XyzbcTrt>()
}
