mod operations;
mod set_up;

use std::collections::BTreeMap;

use proptest::prelude::*;

use crate::control::{CONTROLS, LinuxCnc};
use crate::kinematics::Limits;
use crate::kinematics::Machine as _;
use crate::options::{Rapid, Retract};
use crate::program::{Coolant, Coolants, Pressure, Rotation};
use crate::set_up::Stock;

use super::sample::Sample;
use super::*;

fn read(text: &str) -> Config {
    Config::read::<Sample>(text, &LinuxCnc).unwrap_or_else(|faults| panic!("{faults:#?}"))
}

/// The faults as `line:column: text` and, if there is one, ` | help`.
fn faults(text: &str) -> Vec<String> {
    let faults = Config::read::<Sample>(text, &LinuxCnc).expect_err("the file has a fault");
    let show = |fault: crate::diag::Diagnostic| {
        let help = fault.help.map_or(String::new(), |help| format!(" | {help}"));
        format!("{}:{}: {}{help}", fault.location.line, fault.location.column, fault.text)
    };
    faults.into_iter().map(show).collect()
}

fn close(left: f64, right: f64) -> bool {
    (left - right).abs() <= 1e-12 * right.abs().max(1.0)
}

#[test]
fn the_printed_file_reads_back_as_the_default_with_the_name_of_its_control() {
    let mut config = read(&print(&Sample::default(), &LinuxCnc));
    assert_eq!(config.given, BTreeSet::from(["control.name", "units"]));
    assert_eq!(config.control.name.take().as_deref(), Some("linuxcnc"));
    config.given.clear();
    assert_eq!(config, Config::default());
}

/// Each control has its pages and parameters, with their source or a mark that none is public.
#[test]
fn the_printed_file_states_where_each_number_is_found_at_the_machine() {
    for control in CONTROLS.iter().copied() {
        let text = print(&Sample::default(), control);
        let joined = text.replace("\n# ", " ");
        let found_at = control.spellings().found_at;
        for found in found_at {
            assert!(joined.contains(&found.comment()), "{} {}: {text}", control.spellings().name, found.key);
        }
        for key in ["part_origin", "machine_zero", "tools", "dimensions", "limits", "speeds"] {
            assert_eq!(found_at.iter().filter(|found| found.key == key).count(), 1, "{key}");
        }
    }
}

#[test]
fn an_empty_file_is_the_default() {
    assert_eq!(read(""), Config::default());
}

#[test]
fn every_default_of_the_printed_file_is_the_default_when_enabled() {
    let text: String = print(&Sample::default(), &LinuxCnc)
        .lines()
        .map(|line| match line.strip_prefix('#') {
            Some(setting) if !setting.is_empty() && !setting.starts_with(' ') => format!("{setting}\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    let config = read(&text);
    assert!(config.given.contains("retract.position") && config.given.contains("formats.inverse_time"));
    // Values that the machine declares, given again.
    assert_eq!(config.set_up.limits.keys().collect::<String>(), "BCXYZ");
    assert_eq!(config.set_up.limits[&'C'], None);
    let machine: Sample = config.set_up.machine().expect("the machine is valid");
    assert!(close(machine.alpha, Sample::default().alpha) && close(machine.d, 150.0));
    let mut plain = config.clone();
    plain.set_up.dimensions = BTreeMap::new();
    plain.set_up.limits = BTreeMap::new();
    plain.set_up.speeds = BTreeMap::new();
    plain.given = BTreeSet::new();
    plain.control.name = None;
    // The assumed zero, given explicitly.
    assert_eq!(plain.motion.retract.position_mm.take(), Some(Retract::POSITION_MM));
    assert_eq!(plain, Config::default());
    let (travel, declared) = (config.set_up.travel(Sample::AXES), Config::default().set_up.travel(Sample::AXES));
    for (one, other) in travel.limits.iter().zip(&declared.limits) {
        assert_eq!(one.is_some(), other.is_some());
        assert!(
            one.zip(*other).is_none_or(|(one, other)| close(one.lower, other.lower) && close(one.upper, other.upper))
        );
    }
    for (one, other) in travel.speeds.iter().zip(&declared.speeds) {
        assert_eq!(one.is_some(), other.is_some());
        assert!(one.zip(*other).is_none_or(|(one, other)| close(one, other)));
    }
}

#[test]
fn every_example_of_the_printed_file_is_accepted() {
    let printed = print(&Sample::default(), &LinuxCnc);
    let of_table = |line: &&str| line.starts_with("# e.g. table_zero = ");
    assert_eq!(printed.lines().filter(of_table).count(), 1);
    // It takes the place of `machine_zero`.
    let lines = printed.lines().filter(|line| !of_table(line));
    let text: String = lines.map(|line| format!("{}\n", line.strip_prefix("# e.g. ").unwrap_or(line))).collect();
    let config = read(&text);
    assert_eq!(config.set_up.tools[&12].name.as_deref(), Some("ball 10"));
    assert_eq!(config.set_up.tools[&12].rotation, Some(Rotation::Clockwise));
    assert_eq!(config.set_up.machine_zero.len(), 3);
    assert_eq!(config.motion.park.len(), 2);
    let operations: Vec<String> = config.motion.operations.entries.iter().map(|entry| entry.of.shown()).collect();
    assert_eq!(operations, ["[operations.3]", "[operations.\"FINISH*\"]"]);
    assert_eq!(config.motion.operations.entries[1].settings.tolerance_mm, Some(0.02));
    assert_eq!(config.motion.retract.distance_mm, Some(100.0));
    assert_eq!(config.control.program.line_numbers, crate::control::BlockNumbers::Restarts);
    assert!(!config.file_units_assumed);
}

#[test]
fn inches_and_degrees_become_millimetres_and_radians() {
    let config = read(
        "units = 'in'\npart_origin = [1, 0.5, -2]\nindex_angle = 5\nfloor = -0.25\n\
         machine_zero = { X = -10 }\npark = { B = 90 }\nspindle_max = 12000\n\
         [tools.3]\nlength = 4\n[speeds]\nX = 100\nC = 360\n[limits]\nZ = [-20, 0]\nB = \"free\"\n\
         [dimensions]\nd = 6\nalpha = 30\n",
    );
    assert!(config.set_up.part_origin.iter().zip([25.4, 12.7, -50.8]).all(|(one, other)| close(*one, other)));
    assert!(close(config.motion.rapids.index_angle_rad, 5_f64.to_radians()));
    assert_eq!(config.motion.guards.floor_mm, Some(-6.35));
    assert!(close(config.set_up.machine_zero[&'X'], -254.0));
    assert!(close(config.motion.park[&'B'], 90_f64.to_radians()));
    assert_eq!(config.motion.guards.spindle_max_rev_per_min, Some(12000.0));
    assert_eq!(config.set_up.tools[&3].length_mm, Some(101.6));
    assert!(close(config.set_up.speeds[&'X'], 2540.0));
    assert!(close(config.set_up.speeds[&'C'], std::f64::consts::TAU));
    assert_eq!(config.set_up.limits[&'Z'], Some(Limits { lower: -508.0, upper: 0.0 }));
    assert_eq!(config.set_up.limits[&'B'], None);
    assert!(
        close(config.set_up.dimensions["d"], 152.4) && close(config.set_up.dimensions["alpha"], 30_f64.to_radians())
    );
}

#[test]
fn the_unit_of_the_file_holds_for_keys_before_it_too() {
    assert_eq!(read("floor = 1\nunits = 'in'\n").motion.guards.floor_mm, Some(25.4));
}

#[test]
fn a_length_without_a_unit_is_assumed_to_be_in_millimetres_and_marked() {
    assert!(read("floor = 1\n").file_units_assumed);
    assert!(!read("units = 'mm'\nfloor = 1\n").file_units_assumed);
    assert!(!read("work_offset = 'G55'\n").file_units_assumed);
}

#[test]
fn given_keys_are_distinguished_from_assumed_ones() {
    let config = read("[retract]\nposition = 0\n");
    assert!(config.is_given("retract.position"));
    assert!(!config.is_given("approach.distance"));
}

#[test]
fn an_unknown_key_names_the_nearest_known_one() {
    assert_eq!(
        faults("[retract]\n  distnace = 3\n"),
        ["2:3: unknown key `retract.distnace`; did you mean `distance`?"]
    );
    assert_eq!(faults("part_orign = [0, 0, 0]\n"), ["1:1: unknown key `part_orign`; did you mean `part_origin`?"]);
    assert_eq!(faults("[tools.7]\nlenght = 3\n"), ["2:1: unknown key `tools.7.lenght`; did you mean `length`?"]);
    assert_eq!(faults("floor_x = -60.0\n"), ["1:1: unknown key `floor_x`; did you mean `floor`?"]);
    assert_eq!(
        faults("[tools.7]\nradius_offset_2 = 3\n"),
        ["2:1: unknown key `tools.7.radius_offset_2`; did you mean `radius_offset`?"]
    );
}

#[test]
fn a_shift_that_drives_the_bar_into_the_wall_is_refused() {
    let told = faults("[cycles]\nbore_shift = 30.0");
    assert!(told[0].contains("off the wall of a bore"), "{told:?}");
    read("[cycles]\nbore_shift = 0.3");
}

#[test]
fn an_unknown_key_without_a_near_one_lists_what_is_known() {
    assert_eq!(
        faults("[retract]\nspeed = 3\n"),
        [
            "2:1: unknown key `retract.speed` | known keys are `position`, `home_on_indexing`, `xy`, `tool_change_position`, `distance`, `clearance`, \
         `rewind`, `entry_feed`, `rewind_dry`, `method`"
        ]
    );
}

#[test]
fn a_key_below_the_wrong_header_is_reported_with_its_right_place() {
    assert_eq!(
        faults("[retract]\nposition = 0\nwork_offset = 'G55'\n"),
        ["3:1: unknown key `retract.work_offset` | `work_offset` belongs before the first [section] of the file"]
    );
}

#[test]
fn keys_of_rapids_feeds_course_and_grid_are_read() {
    let config =
        read("rapid = 'feed'\nrapid_feed = 9000\n[feed]\nkeep_speeds = false\nlargest = 5000\nshortest_block = 0.01\n");
    assert_eq!((config.motion.rapids.rapid, config.motion.rapids.rapid_feed_mm_per_min), (Rapid::Feed, Some(9000.0)));
    assert_eq!((config.motion.feed.keep_speeds, config.motion.feed.largest_mm_per_min), (false, Some(5000.0)));
    let help = "give it per minute: `rapid_feed = 10000`";
    assert_eq!(faults("rapid = 'feed'\n"), [format!("1:1: rapid = \"feed\" needs `rapid_feed` | {help}")]);
    let config = read(
        "[course]\nstart_branch = 'second'\nprefer = 'B-'\ngreedy = true\naxis_tolerance = 0.5\n[grid]\nC = 2.5\n",
    );
    assert_eq!(
        (config.motion.course.start_branch, config.motion.course.prefer),
        (Some(crate::kinematics::Branch::Second), Some(('B', false)))
    );
    assert!(
        config.motion.course.greedy
            && close(config.motion.course.axis_tolerance_rad.to_degrees(), 0.5)
            && close(config.motion.rotaries.grid[&'C'].to_degrees(), 2.5)
    );
    assert_eq!(
        faults("[course]\nprefer = 'A+'\naxis_tolerance = 9\n[grid]\nC = 7\nX = 1\n").len(),
        4,
        "an axis that is not there, an angle too wide, steps that do not divide a turn, a linear axis"
    );
}

#[test]
fn the_clearance_geometry_is_a_plane_a_box_or_a_cylinder() {
    use crate::program::Clearance;
    let read = |text: &str| read(&format!("units = 'in'\n[retract]\nclearance = {text}\n")).motion.retract.clearance;
    assert!(matches!(read("{ plane = 2 }"), Some(Clearance::Plane(plane)) if close(plane.distance_mm, 50.8)));
    assert!(
        matches!(read("{ box = [[-1, -1, -1], [1, 1, 2]] }"), Some(Clearance::Box { upper, .. }) if close(upper.z, 50.8))
    );
    let cylinder = read("{ cylinder = { radius = 1, lower = -1, upper = 2, centre = [1, 0] } }");
    assert!(matches!(cylinder, Some(Clearance::Cylinder { centre: [x, _], .. }) if close(x, 25.4)));
    for wrong in ["{}", "{ sphere = 1 }", "{ box = [[1, 1, 1], [0, 2, 2]] }", "{ cylinder = { radius = 1 } }", "3"] {
        assert_eq!(faults(&format!("[retract]\nclearance = {wrong}\n")).len(), 1, "{wrong}");
    }
}

#[test]
fn modes_frames_and_postures_are_read() {
    let text = "mode = 'tcp'\ntcp_frame = 'not_turning'\ntool_posture = 'plane'\ntcp_confirmed = true\n\
                [control]\ntip_control = ['M428', 'M429']\nswivel_data = 'TABLE'\n";
    let config = read(text);
    assert_eq!(
        (config.motion.mode, config.motion.tip.tcp_frame),
        (super::Mode::Tcp, Some(super::TcpFrame::NotTurning))
    );
    assert_eq!((config.motion.tip.tool_posture, config.motion.tip.tcp_confirmed), (super::ToolPosture::Plane, true));
    assert_eq!(config.control.tip_control_codes(), Some(&["M428".to_owned(), "M429".to_owned()]));
    assert_eq!(config.control.swivel_data.as_deref(), Some("TABLE"));
    assert_eq!(faults("mode = 'tpc'\n").len(), 1);
    assert_eq!(faults("[control]\ntip_control = ['M428']\n").len(), 1);
    let always = faults("[control]\ntip_control = 'always'\n");
    assert!(always[0].contains("no block retracts them"), "{always:?}");
}

#[test]
fn every_fault_is_reported_in_the_order_of_the_text() {
    assert_eq!(
        faults("stop_retract = 'yes'\nfloor = nan\nspindle_max = -1\n[tools.0]\n[limits]\nB = [5, -5]\n"),
        [
            "1:16: true or false is needed here, found text in quotes",
            "2:9: a finite number is needed here",
            "3:15: a number above zero is needed here",
            "4:8: `0` is not the number of a tool | tools are tables with a number from 1 to 99999: [tools.12]",
            "6:5: this travel of B is empty | the lowest value comes first",
        ]
    );
}

#[test]
fn numbers_outside_their_range_are_refused() {
    assert_eq!(faults("floor = inf\n"), ["1:9: a finite number is needed here"]);
    assert_eq!(faults("floor = 1e300\n").len(), 1);
    assert_eq!(
        faults("units = 'in'\nfloor = 5000\n"),
        ["2:9: a length of 127 m is not plausible | the unit of this file is `in`"]
    );
    let angle = "at most 1000000000 degrees are needed here";
    assert_eq!(faults("[limits]\nB = [-1e300, 1e300]\n"), [format!("2:6: {angle}"), format!("2:14: {angle}")]);
    assert_eq!(faults("[speeds]\nB = 1e10\n"), [format!("2:5: {angle}")]);
    assert_eq!(faults("part_rotation = [1e300, 0, 0]\n"), [format!("1:18: {angle}")]);
    assert_eq!(faults("[speeds]\nX = 1e-300\n"), ["2:5: at least 0.000000001 is needed here"]);
    assert_eq!(faults("[speeds]\nX = 1e300\n"), ["2:5: at most 1000000000 is needed here"]);
    assert_eq!(faults("[approach]\ndistance = -1\n"), ["2:12: a number that is not negative is needed here"]);
    assert_eq!(faults("[formats]\ninverse_time = 3\n"), ["2:16: a whole number from 6 to 8 is needed here"]);
    assert_eq!(faults("[tools.100000]\n").len(), 1);
    assert_eq!(faults("[tools.07]\n").len(), 1);
    assert_eq!(faults("[tools.7]\nlength = -3\n"), ["2:10: a number that is not negative is needed here"]);
}

#[test]
fn two_axes_have_no_name_in_common() {
    let both = |name: &str, axes: &str| format!("2:8: {axes} would both be named `{name}` on the control");
    assert_eq!(faults("[control]\naxes = { X = \"Y\" }\n"), [both("Y", "X and Y")]);
    assert_eq!(faults("[control]\naxes = { X = \"U1\", Z = \"U1\" }\n"), [both("U1", "X and Z")]);
    assert_eq!(read("[control]\naxes = { X = \"Y\", Y = \"X\" }\n").control.axes.len(), 2);
}

#[test]
fn a_letter_that_is_not_an_axis_of_the_machine_is_refused() {
    assert_eq!(faults("[limits]\nA = [0, 1]\n"), ["2:1: `A` is not an axis of Sample | its axes are C B X Y Z"]);
    assert_eq!(faults("[speeds]\nx = 1\n"), ["2:1: `x` is not an axis of Sample | its axes are C B X Y Z"]);
    assert_eq!(
        faults("machine_zero = { C = 0 }\n"),
        [
            "1:18: C is a rotary axis; `machine_zero` is for linear axes | linear axes are X Y Z; for a rotary axis use `rotary_offset`"
        ]
    );
}

#[test]
fn an_unknown_dimension_names_the_nearest() {
    assert_eq!(
        faults("[dimensions]\nalpa = 3\n"),
        ["2:1: `alpa` is not a dimension of Sample | did you mean `alpha`?"]
    );
}

#[test]
fn dimensions_for_which_the_formulas_fail_are_refused() {
    assert_eq!(
        faults("[dimensions]\nd = 0\n"),
        [
            "1:1: the kinematics of Sample are invalid with these dimensions: `d` is zero: the table has no height | correct the dimensions in the configuration"
        ]
    );
}

crate::machine! {
    /// A table whose height each machine has of its own.
    struct Individual;
    chain: C B | X Y Z;
    d = (0, 0, height);
    dims = { height: required };
}

crate::machine! {
    /// A table with two dimensions that each machine has of its own.
    struct Pair;
    chain: C B | X Y Z;
    d = (reach, 0, height);
    dims = { reach: required, height: required };
}

crate::machine! {
    /// A nutating head whose inclination must be measured.
    struct Nutating;
    chain: X Y | Z C B;
    dims = { tilt: required near 45 deg };
    axes = { B: Rx(tilt) * Y };
}

crate::machine! {
    /// A nutating head with an inclination of its own.
    struct NutatingAsDrawn;
    chain: X Y | Z C B;
    dims = { tilt: 45 deg };
    axes = { B: Rx(tilt) * Y };
}

#[test]
fn a_measured_angle_has_the_solutions_of_the_angle_that_it_is_near() {
    use crate::kinematics::Pose;
    use nalgebra::{UnitVector3, Vector3};
    let missing = Config::read::<Nutating>("", &LinuxCnc).map_err(|faults| faults[0].text.clone());
    assert_eq!(missing.err().as_deref(), Some("`dimensions.tilt` is missing: each Nutating has its own value"));
    assert!(Nutating::default().tilt.is_nan());
    let text = "[dimensions]\ntilt = 44.9\n";
    let measured = Config::read::<Nutating>(text, &LinuxCnc).expect("a configuration").set_up.machine::<Nutating>();
    let drawn = Config::read::<NutatingAsDrawn>(text, &LinuxCnc).expect("a configuration");
    let drawn = drawn.set_up.machine::<NutatingAsDrawn>().expect("valid");
    let measured = measured.expect("valid");
    let axis = UnitVector3::new_normalize(Vector3::new(0.3, -0.2, 0.8));
    let pose = Pose { tip: [10.0, 20.0, 30.0].into(), axis };
    let [ours, theirs] = [measured.inverse_kinematics(&pose, &[0.0; 5]), drawn.inverse_kinematics(&pose, &[0.0; 5])];
    assert_eq!(ours.len(), 2);
    for (ours, theirs) in ours.iter().zip(theirs.iter()) {
        assert!(ours.axes.iter().zip(&theirs.axes).all(|(ours, theirs)| close(*ours, *theirs)), "{ours:?} {theirs:?}");
    }
}

#[test]
fn all_required_dimensions_that_are_missing_are_named_at_once() {
    let of = |text: &str| Config::read::<Pair>(text, &LinuxCnc).map_err(|faults| faults[0].text.clone());
    let both = "`dimensions.reach`, `dimensions.height` are missing: each Pair has its own values";
    assert_eq!(of(""), Err(both.to_owned()));
    let one = "`dimensions.height` is missing: each Pair has its own value";
    assert_eq!(of("[dimensions]\nreach = 3\n"), Err(one.to_owned()));
    assert!(of("[dimensions]\nreach = 3\nheight = 4\n").is_ok());
}

#[test]
fn the_effects_of_lines_have_the_same_names_in_a_configuration_and_in_the_check() {
    for (name, effect) in crate::check::read::Effect::NAMES {
        let config = read(&format!("[control.effects]\n\"G65 P9001 T{{tool}}\" = \"{name}\"\n"));
        let policy = config.check_policy::<Sample>(&LinuxCnc, None).expect("it fits");
        assert_eq!(policy.shop.effects, [("G65 P9001 T{tool}".to_owned(), effect)]);
    }
}

#[test]
fn a_required_dimension_is_asked_for_by_the_name_of_its_key() {
    let faults = Config::read::<Individual>("[dimensions]\n", &LinuxCnc).expect_err("the height is missing");
    assert_eq!(faults[0].text, "`dimensions.height` is missing: each Individual has its own value");
    let help = "measure it at the machine, and write `height = ...` in the section `[dimensions]` of the configuration";
    assert_eq!(faults[0].help.as_deref(), Some(help));
    let config = Config::read::<Individual>("[dimensions]\nheight = 62.5\n", &LinuxCnc).expect("a configuration");
    assert_eq!(config.set_up.dimensions.get("height"), Some(&62.5));
    // The printed file is an example to fill in.
    let printed = print(&Individual::default(), &LinuxCnc);
    assert!(printed.contains("# e.g. height = 150.0"), "{printed}");
}

#[test]
fn dimensions_and_part_origin_reach_the_machine() {
    let machine: Sample =
        read("units = 'mm'\npart_origin = [1, 2, 3]\n[dimensions]\nd = 7\n").set_up.machine().expect("it is valid");
    assert!(close(machine.d, 7.0));
    assert_eq!(machine.part_origin.as_slice(), [1.0, 2.0, 3.0]);
}

#[test]
fn an_axis_cannot_be_parked_outside_its_travel() {
    assert_eq!(
        faults("[park]\nB = 111\n"),
        ["2:5: B cannot be there: its travel (`limits.B`) is -5.0000 to 110.0000 degrees"]
    );
    read("park = { B = 110 }\n");
    read("park = { B = 111 }\nlimits = { B = [-5, 120] }\n");
}

#[test]
fn a_work_offset_that_the_control_does_not_have_is_refused() {
    assert_eq!(read("work_offset = 'G59.3'").set_up.work_offset, "G59.3");
    assert_eq!(faults("work_offset = 'G59.4'\n").len(), 1);
    assert_eq!(faults("work_offset = 'G53'\n").len(), 1);
}

#[test]
fn a_block_of_the_program_is_one_line() {
    assert_eq!(read("[program]\nstart = ['G64 P0.01', 'M64 P1']\n").control.program.start, ["G64 P0.01", "M64 P1"]);
    assert_eq!(faults("[program]\nend = [\"M5\\nM30\"]\n").len(), 1);
}

#[test]
fn a_field_that_does_not_exist_is_found_where_the_file_is_read() {
    let config = read("[control]\ntool_change = ['T{tool} M6', 'T{next}']\nsafety = ['{units} G90 {work_offset}']\n");
    assert_eq!(config.control.tool_change.as_deref(), Some(["T{tool} M6".to_owned(), "T{next}".to_owned()].as_slice()));
    assert_eq!(
        faults("[control]\ntool_change = ['T{tol} M6']\n"),
        ["2:16: `{tol}` is not a field of this block | did you mean `{tool}`?"]
    );
    assert_eq!(faults("[program]\nstart = ['T{tool}']\n").len(), 1, "no tool has been called there");
    assert_eq!(faults("[control]\nsafety = ['G90 {units']\n").len(), 1);
}

#[test]
fn coolant_of_a_tool_is_one_kind_or_several_that_are_on_together() {
    let coolant = |value: &str| read(&format!("[tools.1]\ncoolant = {value}\n")).set_up.tools[&1].coolant;
    assert_eq!(coolant("'air'"), Some(Coolants::of(Coolant::Air)));
    let both = Coolants::of(Coolant::Flood).with(Coolant::ThroughAt(Pressure::High));
    assert_eq!(coolant("['through_high', 'flood']"), Some(both));
    assert_eq!(read("[defaults]\ncoolant = ['mist', 'air']\n").motion.defaults.coolant.kinds().count(), 2);
    for (value, expected) in [
        ("[]", "expected one or more kinds of coolant, each once"),
        ("['flood', 'flood']", "expected one or more kinds of coolant, each once"),
        ("['through', 'through_low']", "coolant through the spindle has one pressure at a time"),
    ] {
        let found = faults(&format!("[tools.1]\ncoolant = {value}\n"));
        assert!(found.len() == 1 && found[0].contains(expected), "{value}: {found:?}");
    }
    assert_eq!(faults("[tools.1]\ncoolant = ['flod']\n").len(), 1);
}

#[test]
fn a_blank_is_a_box_or_a_cylinder_about_the_part_zero() {
    let stock = |text: &str| read(&format!("[stock]\n{text}")).set_up.stock.expect("a blank");
    let round = stock("diameter = 80\nbottom = -40\ntop = 0\n");
    assert_eq!(round, Stock { lower: [-40.0, -40.0, -40.0], upper: [40.0, 40.0, 0.0], round: true });
    assert!(!stock("lower = [0, 0, 0]\nupper = [1, 1, 1]\n").round);
    for (text, expected) in [
        ("diameter = 80\n", "needs its diameter, its bottom and its top"),
        ("diameter = 80\nbottom = 0\ntop = 0\n", "`bottom` must be below `top`"),
        ("lower = [0, 0, 0]\ndiameter = 80\nbottom = -1\ntop = 0\n", "not both"),
        ("diameter = -80\nbottom = -1\ntop = 0\n", "a number above zero is needed here"),
    ] {
        let found = faults(&format!("[stock]\n{text}"));
        assert!(found.len() == 1 && found[0].contains(expected), "{text}: {found:?}");
    }
}

#[test]
fn coolant_codes_are_given_in_pairs_for_kinds_that_exist() {
    let config = read("[control]\ncoolant = { through = ['M88', 'M89'] }\n");
    assert_eq!(config.control.coolant[2], Some(["M88".to_owned(), "M89".to_owned()]));
    assert_eq!(faults("[control]\ncoolant = { air = ['M83'] }\n").len(), 1);
    assert_eq!(
        faults("[control]\ncoolant = { throgh = ['M88', 'M89'] }\n"),
        ["2:13: unknown kind of coolant `throgh` | did you mean `through`?"]
    );
}

#[test]
fn a_file_is_read_on_top_of_the_digits_of_the_control() {
    let start = crate::config::starting_point(&crate::control::Fanuc);
    let read = |text: &str| Config::read::<Sample>(text, &crate::control::Fanuc).expect("no fault");
    assert_eq!(read("").formats, start.formats);
    let config = read("[formats]\nfeed = 1\n");
    assert_eq!((config.formats.rotary, config.formats.feed, config.formats.linear_whole), (3, 1, 6));
}

#[test]
fn text_that_is_not_toml_is_reported_at_its_place() {
    let faults = faults("units = 'mm'\nfloor = \n");
    assert!(faults[0].starts_with("2:"), "{faults:?}");
}

/// Lines of a file, right and wrong.
fn any_line() -> impl Strategy<Value = String> {
    let keys = ["units", "part_origin", "floor", "park", "limits", "machine_zero", "tools", "retract", "\"é\"", "x"];
    let values = [
        "1",
        "-1e400",
        "nan",
        "true",
        "\"mm\"",
        "\"é\"",
        "[]",
        "[1, 2, 3]",
        "{ B = 1, Q = [] }",
        "{ 5 = { length = 0x5 } }",
        "1979-05-27",
    ];
    let others =
        ["[tools.5]", "[tools.000000]", "[park]", "[retract]", "[limits]", "é = ", "\u{feff}", "# é", "\r", "'", "="];
    let setting = (prop::sample::select(keys.to_vec()), prop::sample::select(values.to_vec()));
    prop_oneof![
        setting.prop_map(|(key, value)| format!("{key} = {value}")),
        prop::sample::select(others.to_vec()).prop_map(str::to_owned)
    ]
}

proptest! {
    /// Any file is read, or refused with places inside it; none causes a panic.
    #[test]
    fn any_file_is_read_or_refused(lines in proptest::collection::vec(any_line(), 0..8)) {
        let text = lines.join("\n");
        if let Err(faults) = Config::read::<Sample>(&text, &LinuxCnc) {
            prop_assert!(!faults.is_empty());
            for fault in faults {
                prop_assert!(fault.location.line >= 1 && fault.location.column >= 1 && fault.length >= 1);
                prop_assert!(fault.location.line <= text.split('\n').count() as u64);
            }
        }
    }
}

#[test]
fn numbers_that_a_word_would_round_to_nothing_or_could_not_hold_are_refused() {
    assert!(close(read("path_tolerance = 0.0001").control.path_tolerance_mm, 0.0001));
    assert_eq!(
        faults("path_tolerance = 0.00009"),
        [
            "1:18: a tolerance below 0.0001 mm could be written as 0, which removes the limit on the deviation from the path"
        ]
    );
    assert!(close(read("spindle_dwell = 0").motion.spindle_dwell_s, 0.0));
    assert!(close(read("spindle_dwell = 600").motion.spindle_dwell_s, 600.0));
    for seconds in ["0.0009", "601", "1e20"] {
        let text = "1:17: a dwell of 0, or of 0.001 to 600 seconds, is needed here";
        assert_eq!(faults(&format!("spindle_dwell = {seconds}")), [text]);
    }
}

#[test]
fn effects_of_lines_are_read_by_their_text() {
    use crate::control::LineEffect;
    let text = "[control.effects]\nM77 = \"none\"\n\"G65 P9000\" = \"state lost\"\n";
    let wanted = [("G65 P9000".to_owned(), LineEffect::StateLost), ("M77".to_owned(), LineEffect::None)];
    assert_eq!(read(text).control.effects, BTreeMap::from(wanted));
    let found = faults("[control]\neffects = { M77 = \"nothing\" }\n");
    assert!(found.len() == 1 && found[0].contains("none"), "{found:?}");
    assert_eq!(faults("[control]\neffects = { \"\" = \"none\" }\n").len(), 1);
    let change = read("[control]\neffects = { \"G65 P9001 T{tool}\" = \"tool change\" }\n").control.effects;
    assert_eq!(change["G65 P9001 T{tool}"], LineEffect::ToolChange);
    let found = faults("[control]\neffects = { \"G65 P9001\" = \"tool change\" }\n");
    assert!(found.len() == 1 && found[0].contains("has no field {tool}"), "{found:?}");
}

#[test]
fn options_of_reading_cl_data_are_read() {
    use crate::cl::record::ClCycleKind;
    use crate::cl::{CycleArg, Dialect, FeedLabel, Frames, Insert, Sense, ToolArg};
    use crate::set_up::ClPoint;
    let config = read(
        "units = \"in\"\ntolerance = 0.001\ncl_point = \"centre\"\n[defaults]\ntool = 3\npeck_gap = 0.02\nfeed = 20\n[tools.2]\n\
         cl_point = \"tip\"\n[set_ups.2]\nwork_offset = \"G55\"\n[cl]\ndialect = \"solidworks\"\ncolumns = 72\ninert = [\"aicc\", \"BREAK\"]\n\
         frames = \"main\"\ncircle_sense = \"cw\"\ninsert = \"write\"\ninsert_stop = true\nauxfun = [10, 11]\nprefun = [64]\n\
         feed_label = \"file-units\"\nfrom = \"move\"\nallow_lintol = true\ncycle.TAP.args = [\"depth\", \"pitch\"]\n\
         loadtl.args = [\"ignored\", \"offset\"]\nwords.\"chuck / open\" = \"M68\"\n",
    );
    assert!(close(config.motion.tolerance_mm, 0.0254) && close(config.motion.defaults.peck_gap_mm, 0.508));
    assert_eq!((config.motion.defaults.tool, config.motion.allow_lintol), (Some(3), true));
    let second = &config.set_up.set_ups[&2];
    assert_eq!((&second.frames[..], second.work_offset.as_deref()), (&[2][..], Some("G55")));
    assert_eq!(config.cl.set_ups[0].frames, [2]);
    let cl = &config.cl;
    assert_eq!((cl.cl_point, cl.cl_point_of.get(&2)), (ClPoint::Centre, Some(&ClPoint::Tip)));
    assert_eq!((cl.dialect, cl.columns), (Some(Dialect::SolidWorks), Some(72)));
    assert_eq!(cl.inert, ["AICC", "BREAK"]);
    assert_eq!((cl.frames, cl.circle_sense), (Some(Frames::Main), Some(Sense::Clockwise)));
    assert_eq!((cl.insert, cl.insert_stop, cl.from_move), (Insert::Write, true, true));
    assert_eq!((&cl.auxfun[..], &cl.prefun[..]), (&[10, 11][..], &[64][..]));
    let own: Vec<_> = cl.own_statements.iter().map(|own| (own.statement(), own.blocks()[0].as_str())).collect();
    assert_eq!(own, [("CHUCK/OPEN", "M68")]);
    assert_eq!(
        faults("[cl.words]\n\"chuck/open\" = \"M68\"\n\"CHUCK/OPEN\" = \"M69\"\n\"GOTO/1\" = \"M1\"\n").len(),
        2
    );
    assert_eq!(cl.feed_label, FeedLabel::FileUnits);
    assert!(close(cl.default_feed_mm_per_min.unwrap(), 508.0));
    assert_eq!(cl.tool_args, [ToolArg::Ignored, ToolArg::Offset]);
    assert_eq!(cl.cycle_args, [(ClCycleKind::Tap, vec![CycleArg::Depth, CycleArg::Pitch])]);
}

#[test]
fn words_that_move_something_cannot_be_set_inert() {
    assert_eq!(faults("[cl]\ninert = [\"LOOP\"]"), ["2:10: LOOP cannot be inert: it may repeat motion"]);
    assert_eq!(faults("[cl]\ninert = [\"goto\"]"), ["2:10: goto is read, so it cannot be inert"]);
    assert_eq!(faults("[cl]\ncycle.DRIL.args = []"), ["2:7: `DRIL` is not a kind of CYCLE"]);
    assert_eq!(faults("tolerance = 2"), ["1:13: a tolerance of 0.0001 to 1 mm is needed here"]);
    for tolerance in ["0.0009", "10.1"] {
        let text = "1:23: a tolerance of 0.001 to 10 degrees is needed here";
        assert_eq!(faults(&format!("axis_tolerance_path = {tolerance}")), [text]);
    }
    assert!(
        faults("axis_tolerance_path = 0")[0].contains("above zero")
            && faults("tolerance = -1")[0].contains("above zero")
    );
    for (text, degrees) in [("0.001", 0.001_f64), ("10", 10.0)] {
        let tolerance = read(&format!("axis_tolerance_path = {text}")).motion.axis_tolerance_path_rad;
        assert!(close(tolerance, degrees.to_radians()));
    }
    let wrong = [
        ("[set_ups.1]\nwork_offset = \"G55\"", "`1` is not the number of a further set-up"),
        ("[set_ups.2]\n", "set-up 2 has no work offset"),
        ("[set_ups.2]\nwork_offset = \"G54\"", "work offset G54 belongs to two set-ups"),
        ("[set_ups.3]\nwork_offset = \"G55\"", "where set-up 3 begins is not known"),
        ("[set_ups.2]\nwork_offset = \"G55\"\nframes = [2]\nbegins = \"A\"", "both `frames` and `begins`"),
        (
            "[set_ups.2]\nwork_offset = \"G55\"\nframes = [2]\n[set_ups.3]\nwork_offset = \"G56\"\nframes = [2]",
            "frame 2 belongs to two set-ups",
        ),
    ];
    for (text, fault) in wrong {
        let found = faults(text);
        assert!(found.len() == 1 && found[0].contains(fault), "{text}: {found:?}");
    }
}

#[test]
fn every_key_is_declared_once_and_shows_a_default_or_an_example() {
    use crate::keys::{KeyList, Printed};
    let list = KeyList::of(&Config::default(), super::read::scope(&Sample::default()));
    let mut paths = BTreeSet::new();
    for row in list.rows() {
        assert!(paths.insert(row.path), "`{}` twice", row.path);
        assert!(!matches!(&row.printed, Printed::Example(text) if text.is_empty()), "`{}` shows nothing", row.path);
    }
    assert!(paths.len() > 80, "{paths:?}");
}
