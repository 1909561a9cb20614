//! The postprocessor of one machine. What differs from job to job is in `machine.toml`.

use std::process::ExitCode;

pp_runtime::machine! {
    /// A table that rotates about Z (C) on a cradle that tilts about X (A).
    pub struct {{crate_name | upper_camel_case}};
    // From the workpiece to the tool: the axis next to the workpiece comes first, `|` is the machine frame.
    chain: C A | X Y Z;
    // A point on the centre line of A, from the centre of the table top.
    d = { A: (0, tilt_y, tilt_z) };
    // Measured at the machine: `[dimensions]` in `machine.toml`.
    dims = { tilt_y: required, tilt_z: required };
    // Degrees. Travel of the linear axes is in `machine.toml`.
    limits = { A: -120..30, C: free };
}

fn main() -> ExitCode {
    pp_runtime::cli::run::<{{crate_name | upper_camel_case}}>()
}

// Forward and inverse kinematics against a product of matrices, on both branches, with these dimensions in mm.
#[cfg(test)]
pp_conformance::conformance!({{crate_name | upper_camel_case}}, kinematics, sample = { tilt_y: 0.25, tilt_z: 62.5 });
