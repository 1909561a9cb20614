//! Sample CL data: the parts of the source papers, in the forms of NX, CATIA and Creo.
//!
//! [`parts`] holds the geometry, [`cl_writer`] the three dialects, [`designs`] the surfaces as triangles; [`files`]
//! returns the files of `examples/cl/`. `cargo run -p examples --bin generate_cl` writes these files again.
// A library returns its errors and leaves output to its caller.
#![cfg_attr(
    not(test),
    warn(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::unreachable,
        clippy::print_stdout,
        clippy::print_stderr
    )
)]

pub mod cl_writer;
pub mod designs;
pub mod house_control;
pub mod no_std_kinematics;
pub mod parts;

/// Every file of `examples/cl/`: name and text.
#[must_use]
pub fn files() -> Vec<(&'static str, String)> {
    vec![
        ("convex.cls", cl_writer::nx(&parts::convex())),
        ("concave.aptsource", cl_writer::catia(&parts::concave_one_way())),
        ("concave.ncl", cl_writer::creo(&parts::concave_zig_zag())),
        ("concave_4axis.cls", cl_writer::nx(&parts::concave_four_axes())),
        ("spiral_groove.cls", cl_writer::nx(&parts::spiral_groove())),
        ("two_tools.cls", cl_writer::nx(&parts::two_tools())),
    ]
}
