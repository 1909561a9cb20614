//! Holes along tilted tool axes, with points of four decimals as CAM systems write them, on a grid of tilts: the post
//! and the check agree where the point before a cycle lies over its first hole, a cycle is used wherever its line stays
//! within the tolerance, and the return of a cycle is a retract.

use std::f64::consts::TAU;

use machine_library::HaasUmc;
use machines::{Dmu70e, LolaXoyzba};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::kinematics::Machine;
use pp_runtime::nalgebra::Vector3;
use pp_runtime::post::Report;
use tests::posting::{findings, written};

const CONTROLS: [&str; 5] = ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"];

/// LinuxCNC has no planes, and tip control only by codes of its own.
fn modes(control: &str) -> &'static [&'static str] {
    if control == "linuxcnc" { &["axes", "auto"] } else { &["axes", "plane", "tcp", "auto"] }
}

/// Tool axes: tilts up to 60° in all directions.
fn tilts(tilts: u32, azimuths: u32) -> impl Iterator<Item = Vector3<f64>> {
    (0..tilts * azimuths).map(move |index| {
        let tilt = 60.0_f64.to_radians() * f64::from(index / azimuths + 1) / f64::from(tilts);
        let azimuth = TAU * f64::from(index % azimuths) / f64::from(azimuths);
        Vector3::new(tilt.sin() * azimuth.cos(), tilt.sin() * azimuth.sin(), tilt.cos())
    })
}

/// A point as CAM systems write it.
fn point(at: Vector3<f64>) -> String {
    format!("{:.4},{:.4},{:.4}", at.x, at.y, at.z)
}

/// One operation with three holes along an axis. The point before the cycle is `height` above the first of them, and
/// `beside` mm off its axis; `cycle`: its record; `leaves`: the tool goes back there after the cycle.
fn holes(axis: Vector3<f64>, [height, beside]: [f64; 2], cycle: &str, leaves: bool) -> String {
    let across = Vector3::new(-axis.y, axis.x, 0.0).normalize();
    let along = axis.cross(&across);
    let first = Vector3::new(25.8079, 3.1459, -2.9294);
    let tops = [first, first + across * 12.0, first + across * 7.0 - along * 9.5];
    let before = first + axis * height + across * beside;
    let last = tops[2] + axis * height;
    let mut text = format!(
        "UNITS/MM\nTOOL PATH/HOLES,TOOL,D8\nMSYS/0,0,0,1,0,0,0,1,0\nLOADTL/1,ADJUST,1\nSPINDL/RPM,500,CLW\nCOOLNT/ON\nRAPID\n\
         GOTO/{},{:.7},{:.7},{:.7}\n{cycle}\n",
        point(before),
        axis.x,
        axis.y,
        axis.z
    );
    tops.into_iter().for_each(|top| text += &format!("GOTO/{}\n", point(top)));
    text += "CYCLE/OFF\n";
    if leaves {
        text += &format!("RAPID\nGOTO/{}\n", point(last));
    }
    text + "END-OF-PATH\nFINI\n"
}

/// A configuration, with further keys before its tables.
fn config<M: Machine>(control: &'static dyn Control, mode: &str, keys: &str) -> Config {
    let name = control.spellings().name;
    let frame = if name == "fanuc" { "tcp_frame = 'table_at_zero'\n" } else { "" };
    let dimensions = if M::NAME == HaasUmc::NAME { "[dimensions]\ntilt_x = 0.05\ntilt_z = 35.2\n" } else { "" };
    let text = format!(
        "mode = '{mode}'\ntcp_confirmed = true\n{frame}part_origin = [0.0, 0.0, 150.0]\n{keys}\n[tools]\n1 = {{ length = 120.0 \
         }}\n{dimensions}"
    );
    starting_point(control).read_over(&M::default(), &text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// The program and its report; it passes its check.
fn passes<M: Machine>(config: &Config, control: &'static dyn Control, cl: &str) -> (String, Report) {
    let (program, report) = written::<M>(config, control, cl).expect("it can run");
    let name = control.spellings().name;
    assert!(!report.failed, "{} {name} {}\n{cl}\n{:?}", M::NAME, config.motion.mode.name(), report.diagnostics);
    let found = findings::<M>(config, control, cl, &program);
    assert!(found.is_empty(), "{} {name} {}: {found:?}\n{cl}\n{program}", M::NAME, config.motion.mode.name());
    (program, report)
}

/// Drills on every control in every mode, in all forms of approach and return.
fn drills<M: Machine>(axes: &[Vector3<f64>]) {
    const RETURNS: [&str; 3] = ["", ",RTRCTO,AUTO", ",RTRCTO,15"];
    const BEFORE: [[f64; 2]; 4] = [[50.0, 0.0], [50.0, 10.0], [3.0, 0.0], [12.5, 0.0]];
    for name in CONTROLS {
        let control = control::by_name(name).expect("it is there");
        for (mode, shift) in modes(name).iter().zip(0..) {
            let config = config::<M>(control, mode, "[retract]\ndistance = 60.0");
            for (index, axis) in axes.iter().enumerate() {
                let before = BEFORE[(index + shift) % BEFORE.len()];
                let back = RETURNS[(index + shift) % RETURNS.len()];
                let cycle = format!("CYCLE/DRILL,RAPTO,3.0000,FEDTO,-20.0000{back},MMPM,320.0000");
                passes::<M>(&config, control, &holes(*axis, before, &cycle, index % 2 == 0));
            }
        }
    }
}

#[test]
fn drilling_from_a_point_over_the_first_hole_passes_at_every_tilt() {
    let axes: Vec<_> = tilts(8, 9).collect();
    drills::<HaasUmc>(&axes);
}

#[test]
fn on_other_kinematics_it_passes_as_well() {
    let axes: Vec<_> = tilts(4, 6).collect();
    drills::<Dmu70e>(&axes);
    drills::<LolaXoyzba>(&axes);
}

/// Tilts at which the planes of the default digits make rounded X and Y differ between the top and the bottom of a
/// hole.
#[test]
fn every_hole_of_a_tilted_plane_is_a_cycle_of_the_control() {
    let axes: Vec<_> = tilts(12, 12).collect();
    for name in ["haas", "fanuc", "siemens", "heidenhain"] {
        let control = control::by_name(name).expect("it is there");
        let config = config::<HaasUmc>(control, "plane", "[retract]\ndistance = 60.0");
        for (index, axis) in axes.iter().enumerate() {
            let cycle = match index % 2 {
                0 => "CYCLE/TAP,RAPTO,5.0000,FEDTO,-14.0000,RTRCTO,AUTO,MMPR,1.2500",
                _ => "CYCLE/DRILL,RAPTO,3.0000,FEDTO,-40.0000,RTRCTO,AUTO,MMPM,320.0000",
            };
            let (program, report) = passes::<HaasUmc>(&config, control, &holes(*axis, [50.0, 0.0], cycle, false));
            assert_eq!(report.statistics.cycles, 3, "{name} {axis:?}\n{program}");
        }
    }
}

#[test]
fn a_hole_that_a_cycle_would_drill_beyond_the_tolerance_is_written_as_motions() {
    let control = control::by_name("haas").expect("it is there");
    let cycle = "CYCLE/DRILL,RAPTO,3.0000,FEDTO,-40.0000,RTRCTO,AUTO,MMPM,320.0000";
    let cycles = |tolerance: f64, axis: Vector3<f64>| {
        let keys = format!(
            "tolerance = {tolerance:?}\ncontrol.plane_by = 'tilted_plane'\n[formats]\nrotary = 2\n[retract]\ndistance = 60.0"
        );
        let config = config::<HaasUmc>(control, "plane", &keys);
        passes::<HaasUmc>(&config, control, &holes(axis, [50.0, 0.0], cycle, false)).1.statistics.cycles
    };
    // Hundredths of a degree: a line leans by up to 5 µm over 43 mm.
    let counted = |tolerance: f64| tilts(6, 8).map(|axis| cycles(tolerance, axis)).sum::<u64>();
    let (all, some) = (counted(0.02), counted(0.001));
    assert_eq!(all, 3 * 48);
    assert!(some > 0 && some < all, "{some}");
}

#[test]
fn a_thread_that_cannot_be_a_cycle_is_refused_with_what_makes_it_one() {
    let control = control::by_name("haas").expect("it is there");
    let tap = "CYCLE/TAP,RAPTO,5.0000,FEDTO,-14.0000,RTRCTO,AUTO,MMPR,1.2500";
    let axis = Vector3::new(0.383_022_2, 0.321_393_8, 0.866_025_4);
    let cl = holes(axis, [50.0, 0.0], tap, false);
    let help = |mode: &str, keys: &str| {
        let config = config::<HaasUmc>(control, mode, &format!("{keys}\n[retract]\ndistance = 60.0"));
        let (_, report) = written::<HaasUmc>(&config, control, &cl).expect("it can run");
        assert!(report.failed, "{mode} {keys}");
        let error = report.diagnostics.last().expect("an error");
        assert!(error.text.starts_with("tapping synchronises spindle and feed"), "{error:?}");
        error.help.clone().unwrap_or_default()
    };
    assert!(
        help("plane", "tolerance = 0.001\ncontrol.plane_by = 'tilted_plane'\n[formats]\nrotary = 1")
            .contains("`formats.rotary`")
    );
    assert!(help("tcp", "").contains("`mode = \"plane\"`"));
    assert!(help("plane", "[cycles]\noutput = 'expanded'").contains("native"));
    assert_eq!(passes::<HaasUmc>(&config::<HaasUmc>(control, "plane", ""), control, &cl).1.statistics.cycles, 3);
}

#[test]
fn an_edited_bottom_or_position_of_a_tilted_cycle_is_found() {
    let control = control::by_name("haas").expect("it is there");
    let cycle = "CYCLE/DRILL,RAPTO,3.0000,FEDTO,-20.0000,RTRCTO,AUTO,MMPM,320.0000";
    let axis = Vector3::new(0.224_143_9, 0.129_409_5, 0.965_925_8);
    let cl = holes(axis, [50.0, 0.0], cycle, false);
    let config = config::<HaasUmc>(control, "plane", "[retract]\ndistance = 60.0");
    let (program, _) = passes::<HaasUmc>(&config, control, &cl);
    let line = program.lines().find(|line| line.contains("G81")).expect("a cycle").to_owned();
    for (letter, by) in [('X', 0.004), ('Y', -0.004), ('Z', 0.004), ('Z', -0.004), ('R', 0.004)] {
        let edited: Vec<String> = line
            .split(' ')
            .map(|word| match word.strip_prefix(letter) {
                Some(number) => format!("{letter}{:.3}", number.parse::<f64>().expect("a number") + by),
                None => word.to_owned(),
            })
            .collect();
        let found = findings::<HaasUmc>(&config, control, &cl, &program.replacen(&line, &edited.join(" "), 1));
        assert!(!found.is_empty(), "{letter} {by}: {line}");
    }
}

#[test]
fn the_return_of_a_cycle_is_the_retract_also_where_the_cl_data_repeats_its_point() {
    let cycle = "CYCLE/DRILL,RAPTO,3.0000,FEDTO,-20.0000,RTRCTO,AUTO,MMPM,320.0000";
    for name in CONTROLS {
        let control = control::by_name(name).expect("it is there");
        for mode in modes(name) {
            let config = config::<HaasUmc>(control, mode, "");
            for axis in tilts(4, 9) {
                passes::<HaasUmc>(&config, control, &holes(axis, [50.0, 0.0], cycle, true));
            }
        }
    }
}

/// The largest speeds are those of the axes of the machine, not of the words of a plane.
#[test]
fn speeds_of_axes_hold_back_a_hole_along_its_own_direction() {
    let cl = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/30,30,50,0.5,0,0.8660254\n\
        CYCLE/DRILL,DEPTH,10,CLEAR,3,MMPM,900\nGOTO/20,20,1\nGOTO/10,20,1\nCYCLE/OFF\nFINI\n";
    for name in ["fanuc", "haas", "siemens", "heidenhain"] {
        let control = control::by_name(name).expect("a control");
        for (speed, feed) in [("Z = 300.0", "346.4"), ("X = 300.0", "600"), ("Y = 300.0", "900")] {
            let keys = format!("retract.distance = 80.0\ncl.dialect = 'iso'\n[speeds]\n{speed}\n");
            let config = config::<LolaXoyzba>(control, "auto", &keys);
            let (program, report) = written::<LolaXoyzba>(&config, control, cl).expect("it can run");
            assert!(!report.failed, "{name} {speed}: {:?}\n{program}", report.diagnostics);
            let found = findings::<LolaXoyzba>(&config, control, cl, &program);
            assert!(found.is_empty() && program.contains(feed), "{name} {speed}: {found:?}\n{program}");
        }
    }
}
