//! Programs with random set-ups: orientation of the part, datum of the words, tool lengths.
//!
//! The product gets the set-up as a configuration file, the comparison as numbers: it multiplies the CL data by its own
//! matrix and solves the machine's matrices for the difference between words and axis values.

use std::fmt::Write as _;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::nalgebra::{Matrix3, Point3, Vector3};
use tests::oracle::rotation;
use tests::random::Random;

use super::{Checked, ClData, PLAIN, SetUp, WordDatum, assert_complete, check, data, points, posted_with, sample};

/// Number of set-ups for each part and machine.
const SET_UPS: u64 = 6;

/// Tool lengths, mm; those of the CL data, where it has them.
const LENGTHS: &[(u32, f64)] = &[(1, 120.0), (2, 95.0), (3, 101.5), (4, 88.25)];

/// A random set-up, and its configuration file; `largest_deg`: largest rotation of the part about X, Y and Z, degrees.
fn set_up<M: Machine>(random: &mut Random, largest_deg: [f64; 3]) -> (SetUp, String) {
    // Rounded to the digits of the file.
    let mut number = |most: f64| (random.between(-most, most) * 1e5).round() / 1e5;
    let angles = largest_deg.map(&mut number);
    let part_origin = [number(50.0), number(50.0), number(50.0)];
    let offsets = [number(90.0), number(90.0), number(180.0)];
    let (from_table, gauge_line, as_matrix) = (random.chance(0.5), random.chance(0.5), random.chance(0.3));
    let about =
        |axis: Vector3<f64>, degrees: f64| rotation(&axis, degrees.to_radians()).fixed_view::<3, 3>(0, 0).into_owned();
    let rotated: Matrix3<f64> =
        about(Vector3::z(), angles[2]) * about(Vector3::y(), angles[1]) * about(Vector3::x(), angles[0]);
    let mut text = format!("units = \"mm\"\npart_origin = {part_origin:?}\n");
    if as_matrix {
        let rows: Vec<String> =
            rotated.row_iter().map(|row| format!("[{:?}, {:?}, {:?}]", row[0], row[1], row[2])).collect();
        let _ = writeln!(text, "part_rotation = [{}]", rows.join(", "));
    } else {
        let _ = writeln!(text, "part_rotation = {angles:?}");
    }
    let _ = writeln!(text, "program_zero = \"{}\"", if from_table { "table" } else { "part" });
    let _ = writeln!(text, "length_mode = \"{}\"", if gauge_line { "gauge" } else { "tip" });
    let _ = writeln!(text, "[rotary_offset]");
    let mut used = [0.0; 3];
    for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        let index = "ABC".find(axis.letter).expect("a rotary letter");
        // An axis at its limit cannot be posted if its rounded words are beyond the limit.
        let digits = if axis.limits.is_some() { 1e4 } else { 1e5 };
        used[index] = (offsets[index] * digits).round() / digits;
        let _ = writeln!(text, "{} = {:?}", axis.letter, used[index]);
    }
    for (tool, length) in LENGTHS {
        let _ = writeln!(text, "[tools.{tool}]\nlength = {length:?}");
    }
    let datum = WordDatum { rotation: rotated, offsets_deg: used, from_table, gauge_line };
    (SetUp { part_origin, lengths: LENGTHS, datum, ..PLAIN }, text)
}

fn rotated(cl: &ClData, rotation: &Matrix3<f64>) -> ClData {
    let mut cl = cl.clone();
    for goto in &mut cl.points {
        goto.tip = Point3::from(rotation * goto.tip.coords);
        goto.axis = rotation * goto.axis;
    }
    cl
}

fn check_random_set_ups<M: Machine>(binary: &str, path: &std::path::PathBuf, seed: u64, largest_deg: [f64; 3]) {
    let mut random = Random::new(seed);
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data exists"));
    let folder = tempfile::tempdir().expect("a folder");
    for _ in 0..SET_UPS {
        let (set_up, text) = set_up::<M>(&mut random, largest_deg);
        let file = folder.path().join("set_up.toml");
        std::fs::write(&file, &text).expect("a file can be written");
        let program = posted_with(binary, path, Some(&file), false);
        let checked: Checked = check::<M>(&program, path, &rotated(&cl, &set_up.datum.rotation), &set_up);
        assert_complete(path, &checked);
    }
}

/// The part may have any orientation: its planes are cut without rotary motion.
#[test]
fn planes_are_cut_in_any_set_up() {
    let path = sample("two_tools.cls");
    check_random_set_ups::<SpinnerU5620>("spinner-u5-620", &path, 1, [20.0, 20.0, 180.0]);
    check_random_set_ups::<Dmu70e>("dmu-70e", &path, 2, [10.0, 10.0, 180.0]);
    check_random_set_ups::<LolaXoyzba>("lola-xoyzba", &path, 3, [10.0, 10.0, 10.0]);
}

/// The pole keeps its position in the part: a path that passes near it rotates the table far.
#[test]
fn simultaneous_cuts_are_made_in_any_set_up() {
    let path = data("blade/blade.cls");
    check_random_set_ups::<SpinnerU5620>("spinner-u5-620", &path, 4, [0.0, 0.0, 180.0]);
    check_random_set_ups::<Dmu70e>("dmu-70e", &path, 5, [0.0, 0.0, 180.0]);
    check_random_set_ups::<LolaXoyzba>("lola-xoyzba", &path, 6, [5.0, 5.0, 5.0]);
    check_random_set_ups::<MultiProDesk>("multiprodesk", &sample("spiral_groove.cls"), 7, [180.0, 0.0, 0.0]);
}
