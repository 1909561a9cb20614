//! A machine in a few lines, and its postprocessor.
//!
//! `cargo run -p examples --bin quickstart -- post examples/cl/convex.cls -o convex.nc`

use pp_runtime::machine;

machine! {
    /// A trunnion table on a small machining centre: A tilts, and C rotates on it.
    pub struct Trunnion;
    chain: C A | X Y Z;
    d = { C: (0, 0, 0), A: (0, 0, height) };
    dims = { height: 60.5 };
    limits = { A: -120..30, C: free, X: -310..310 };
}

fn main() -> std::process::ExitCode {
    pp_runtime::cli::run::<Trunnion>()
}
