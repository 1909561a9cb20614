//! The chains of the library, multiplied out from the drawings of their sources and from nothing of the machine but its
//! dimensions.
//!
//! A rotary of the table is about a point counted from the reference point, one of the head about a point counted from
//! the gauge line. A table that rotates right-handed with a positive word, as those of LinuxCNC, is a left-handed
//! rotation of the tool.

use std::f64::consts::FRAC_1_SQRT_2;

use machine_library::{
    BridgeMill, HaasRotary, HaasTrunnion, HaasUmc, IntegrexI200, Max5, ObliqueYLathe, PocketNcV2, XyzabTdr, XyzacTrt,
    XyzacbTrsrn, XyzbcTrt,
};
use pp_runtime::nalgebra::{Matrix4, Vector3};
use tests::by_hand::compare;
use tests::oracle::{pose_of, rotation_about, translation};

const X: Vector3<f64> = Vector3::new(1.0, 0.0, 0.0);
const Y: Vector3<f64> = Vector3::new(0.0, 1.0, 0.0);
const Z: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

fn slides(x: f64, y: f64, z: f64) -> Matrix4<f64> {
    translation(&Vector3::new(x, y, z))
}

#[test]
fn tilting_tables_of_linuxcnc_carry_c() {
    compare::<XyzacTrt>("CAXYZ", |machine, &[c, a, x, y, z], part, _| {
        let tilt = Vector3::new(0.0, machine.y_offset, machine.z_offset) - part;
        pose_of(&(rotation_about(&-part, &-Z, c) * rotation_about(&tilt, &-X, a) * slides(x, y, z)), &Z)
    });
    compare::<XyzbcTrt>("CBXYZ", |machine, &[c, b, x, y, z], part, _| {
        let tilt = Vector3::new(machine.x_offset, 0.0, machine.z_offset) - part;
        pose_of(&(rotation_about(&-part, &-Z, c) * rotation_about(&tilt, &-Y, b) * slides(x, y, z)), &Z)
    });
}

#[test]
fn the_face_of_a_is_off_the_centre_line_of_b() {
    compare::<XyzabTdr>("ABXYZ", |machine, &[a, b, x, y, z], part, _| {
        let centre = -Vector3::new(machine.x_offset, 0.0, machine.z_offset) - part;
        pose_of(&(rotation_about(&-part, &X, a) * rotation_about(&centre, &Y, b) * slides(x, y, z)), &Z)
    });
}

#[test]
fn the_quill_moves_the_tool_out_of_the_fork_head() {
    compare::<BridgeMill>("YXZCBW", |machine, &[y, x, z, c, b, w], _, gauge| {
        let pivot = Z * (machine.pivot_length + gauge);
        let head = rotation_about(&pivot, &Z, c) * rotation_about(&pivot, &-Y, b) * translation(&(-Z * w));
        pose_of(&(slides(x, y, z) * head), &Z)
    });
}

#[test]
fn the_head_of_max_tilts_over_its_rotary_table() {
    compare::<Max5>("CXYZB", |machine, &[c, x, y, z, b], part, gauge| {
        let pivot = Z * (machine.pivot_length + gauge);
        pose_of(&(rotation_about(&-part, &Z, c) * slides(x, y, z) * rotation_about(&pivot, &-Y, b)), &Z)
    });
}

#[test]
fn b_of_the_nutating_head_is_inclined_between_y_and_z() {
    let inclined = (Y + Z) * FRAC_1_SQRT_2;
    compare::<XyzacbTrsrn>("XYZCB", |machine, &[x, y, z, c, b], _, gauge| {
        let to_b = Vector3::new(0.0, machine.y_pivot, machine.z_pivot + gauge);
        let to_c = to_b + Vector3::new(machine.x_offset, machine.y_offset, 0.0);
        pose_of(&(slides(x, y, z) * rotation_about(&to_c, &Z, c) * rotation_about(&to_b, &inclined, b)), &Z)
    });
}

#[test]
fn b_of_the_pocket_nc_is_on_a_and_both_centre_lines_meet() {
    compare::<PocketNcV2>("BAXYZ", |_, &[b, a, x, y, z], part, _| {
        pose_of(&(rotation_about(&-part, &-Y, b) * rotation_about(&-part, &-X, a) * slides(x, y, z)), &Z)
    });
}

#[test]
fn tables_of_haas_have_the_directions_of_iso_841() {
    compare::<HaasUmc>("CBXYZ", |machine, &[c, b, x, y, z], part, _| {
        let tilt = Vector3::new(machine.tilt_x, 0.0, machine.tilt_z) - part;
        pose_of(&(rotation_about(&-part, &Z, c) * rotation_about(&tilt, &Y, b) * slides(x, y, z)), &Z)
    });
    compare::<HaasTrunnion>("CAXYZ", |machine, &[c, a, x, y, z], part, _| {
        let tilt = Vector3::new(0.0, machine.tilt_y, machine.tilt_z) - part;
        pose_of(&(rotation_about(&-part, &Z, c) * rotation_about(&tilt, &X, a) * slides(x, y, z)), &Z)
    });
    compare::<HaasRotary>("AXYZ", |_, &[a, x, y, z], part, _| {
        pose_of(&(rotation_about(&-part, &X, a) * slides(x, y, z)), &Z)
    });
}

#[test]
fn the_milling_head_of_the_integrex_faces_the_spindle_at_b_zero_and_is_radial_at_90() {
    compare::<IntegrexI200>("CZXYB", |machine, &[c, z, x, y, b], part, gauge| {
        let pivot = Vector3::new(machine.head_x, 0.0, machine.head_z + gauge);
        pose_of(&(rotation_about(&-part, &Z, c) * slides(x, y, z) * rotation_about(&pivot, &Y, b)), &Z)
    });
}

#[test]
fn the_oblique_slide_of_the_lathe_is_inclined_towards_minus_x() {
    compare::<ObliqueYLathe>("CZXY", |machine, &[c, z, x, y], part, _| {
        let (sine, cosine) = machine.slant.sin_cos();
        pose_of(&(rotation_about(&-part, &Z, c) * slides(x - sine * y, cosine * y, z)), &X)
    });
}
