//! Programs of set-ups that chance has made: how the part lies, what words count from, how long the tools are.
//!
//! The product is told in its configuration file, the reader in numbers: it multiplies the CL data by a matrix of its own
//! and solves the machine's matrices for what the words are more than the axis values.

use std::fmt::Write as _;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::nalgebra::{Matrix3, Point3, Vector3};
use tests::oracle::rotation;
use tests::random::Random;

use super::{Checked, ClData, Counting, PLAIN, SetUp, assert_complete, check, data, points, posted_with, sample};

/// Set-ups for each part and machine.
const SET_UPS: u64 = 6;

/// As the CL data says them, where it does.
const LENGTHS: &[(u32, f64)] = &[(1, 120.0), (2, 95.0), (3, 101.5), (4, 88.25)];

/// A set-up, and the configuration file that says it; `turns`: how far the part may be turned about X, Y and Z, degrees.
fn set_up<M: Machine>(random: &mut Random, turns: [f64; 3]) -> (SetUp, String) {
    // As many digits as the file holds.
    let mut number = |most: f64| (random.between(-most, most) * 1e5).round() / 1e5;
    let angles = turns.map(&mut number);
    let part_origin = [number(50.0), number(50.0), number(50.0)];
    let offsets = [number(90.0), number(90.0), number(180.0)];
    let (from_table, gauge_line, as_matrix) = (random.chance(0.5), random.chance(0.5), random.chance(0.3));
    let about =
        |axis: Vector3<f64>, degrees: f64| rotation(&axis, degrees.to_radians()).fixed_view::<3, 3>(0, 0).into_owned();
    let turned: Matrix3<f64> =
        about(Vector3::z(), angles[2]) * about(Vector3::y(), angles[1]) * about(Vector3::x(), angles[0]);
    let mut text = format!("units = \"mm\"\npart_origin = {part_origin:?}\n");
    if as_matrix {
        let rows: Vec<String> =
            turned.row_iter().map(|row| format!("[{:?}, {:?}, {:?}]", row[0], row[1], row[2])).collect();
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
        // An axis that stands at its limit cannot stand there if its words miss the limit.
        let digits = if axis.limits.is_some() { 1e4 } else { 1e5 };
        used[index] = (offsets[index] * digits).round() / digits;
        let _ = writeln!(text, "{} = {:?}", axis.letter, used[index]);
    }
    for (tool, length) in LENGTHS {
        let _ = writeln!(text, "[tools.{tool}]\nlength = {length:?}");
    }
    let counting = Counting { rotation: turned, offsets: used, from_table, gauge_line };
    (SetUp { part_origin, lengths: LENGTHS, counting, ..PLAIN }, text)
}

fn turned(cl: &ClData, rotation: &Matrix3<f64>) -> ClData {
    let mut cl = cl.clone();
    for goto in &mut cl.points {
        goto.tip = Point3::from(rotation * goto.tip.coords);
        goto.axis = rotation * goto.axis;
    }
    cl
}

fn any_set_up<M: Machine>(binary: &str, path: &std::path::PathBuf, seed: u64, turns: [f64; 3]) {
    let mut random = Random::new(seed);
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data is there"));
    let folder = tempfile::tempdir().expect("a folder");
    for _ in 0..SET_UPS {
        let (set_up, text) = set_up::<M>(&mut random, turns);
        let file = folder.path().join("set_up.toml");
        std::fs::write(&file, &text).expect("the folder takes files");
        let program = posted_with(binary, path, Some(&file), false);
        let checked: Checked = check::<M>(&program, path, &turned(&cl, &set_up.counting.rotation), &set_up);
        assert_complete(path, &checked);
    }
}

/// The part may lie anyhow: its planes are cut with the rotary axes still.
#[test]
fn planes_are_cut_in_any_set_up() {
    let path = sample("two_tools.cls");
    any_set_up::<SpinnerU5620>("spinner-u5-620", &path, 1, [20.0, 20.0, 180.0]);
    any_set_up::<Dmu70e>("dmu-70e", &path, 2, [10.0, 10.0, 180.0]);
    any_set_up::<LolaXoyzba>("lola-xoyzba", &path, 3, [10.0, 10.0, 10.0]);
}

/// The pole stays where it is in the part: a path that runs past it turns the table far.
#[test]
fn simultaneous_cuts_are_made_in_any_set_up() {
    let path = data("blade/blade.cls");
    any_set_up::<SpinnerU5620>("spinner-u5-620", &path, 4, [0.0, 0.0, 180.0]);
    any_set_up::<Dmu70e>("dmu-70e", &path, 5, [0.0, 0.0, 180.0]);
    any_set_up::<LolaXoyzba>("lola-xoyzba", &path, 6, [5.0, 5.0, 5.0]);
    any_set_up::<MultiProDesk>("multiprodesk", &sample("spiral_groove.cls"), 7, [180.0, 0.0, 0.0]);
}
