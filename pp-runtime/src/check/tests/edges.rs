//! Restart points, ends, and the lines of the shop between two cuts.

use super::order::TWO_OPERATIONS;
use super::*;

const ISO: [&str; 4] = ["linuxcnc", "fanuc", "haas", "siemens"];

/// The block that begins the second operation.
fn restart(program: &str) -> &str {
    let start = program.find("\nN2 ").expect("the second operation") + 1;
    let modes = program[start..].find("G17").expect("a working plane") + start;
    let line = program[..modes].rfind('\n').expect("a line") + 1;
    program[line..].lines().next().expect("a block")
}

#[test]
fn a_mode_that_only_the_blocks_before_a_restart_point_have_is_found() {
    let set_up = "retract.distance = 20\n";
    for control in ISO {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS);
        let line = restart(&program);
        for mode in [" G17", " G90", " G94", " G40"] {
            let without = line.replace(mode, "");
            assert_ne!(without, line, "{control}: {mode}");
            let place = program.rfind(line).expect("the block");
            let edited = format!("{}{without}{}", &program[..place], &program[place + line.len()..]);
            let found = again::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS, &edited);
            assert!(
                found.iter().any(|text| text.contains("at the restart point of this operation")),
                "{found:?}\n{edited}"
            );
        }
    }
}

/// Lines for the tools, and rotary axes that go to a position for them.
const OF_TOOLS: &str = "retract.distance = 20\ncycles.measure_tool = [\"G65 P9023 A12. T{tool} H{offset}\"]\n\
                        cycles.check_tool = [\"G65 P9023 A22. T{tool}\"]\ncycles.tool_position = { A = 0.0 }\n\
                        tools = { 1 = { length = 120.0, measured = true, checked = true, start = [\"M131\"], end = [\"M133\"] }, \
                        2 = { length = 95.0, measured = true, checked = true } }\n\
                        control.effects = { M131 = \"none\", M133 = \"none\" }\n";

#[test]
fn a_line_for_a_tool_that_comes_twice_is_found() {
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, TWO_OPERATIONS);
    for line in [
        "G65 P9023 A12. T1 H1\n",
        "G65 P9023 A22. T1\n",
        "G65 P9023 A12. T2 H2\n",
        "G65 P9023 A22. T2\n",
        "M131\n",
        "M133\n",
    ] {
        let twice = program.replace(line, &line.repeat(2));
        assert_ne!(twice, program, "{line}");
        let found = again::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, TWO_OPERATIONS, &twice);
        assert!(found.iter().any(|text| text.contains("once more than it has to")), "{line}: {found:?}\n{twice}");
    }
}

#[test]
fn the_axes_go_to_the_position_for_measuring_under_the_work_offset() {
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, TWO_OPERATIONS);
    for offset in ["", " G55"] {
        let edited = program.replacen(" G54\n", &format!("{offset}\n"), 1);
        let found = again::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, TWO_OPERATIONS, &edited);
        assert!(found.iter().any(|text| text.contains("work offset is")), "{found:?}\n{edited}");
    }
}

#[test]
fn the_machine_retracts_after_a_line_of_the_shop_before_blocks_that_may_be_skipped() {
    let data = TWO_OPERATIONS.replace("TOOL PATH/SECOND", "OPSKIP/ON\nTOOL PATH/SECOND");
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, &data);
    let skip = program.find("\n/").expect("a block that may be skipped");
    let retract = program[..skip].rfind('\n').expect("the retract before it") + 1;
    let edited = format!("{}/{}", &program[..retract], &program[retract..]);
    let found = again::<OneTable>("fanuc", Mode::Axes, OF_TOOLS, &data, &edited);
    assert!(found.iter().any(|text| text.contains("retract after the line of the shop")), "{found:?}\n{edited}");
}

#[test]
fn the_tool_that_is_selected_is_the_next_one() {
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, TWO_OPERATIONS);
    for (right, wrong) in [("T1 M6\nT2\n", "T1 M6\nT3\n"), ("T2 M6\nT1\n", "T2 M6\nT3\n")] {
        assert!(program.contains(right), "{program}");
        let found = again::<Mill>("fanuc", Mode::Axes, set_up, TWO_OPERATIONS, &program.replace(right, wrong));
        assert!(found.iter().any(|text| text.contains("T3 ") && text.contains("selected")), "{found:?}");
    }
}

#[test]
fn clamps_are_at_the_end_as_the_program_leaves_them() {
    let set_up = "retract.distance = 20\npark = { A = 0.0 }\nclamp = { A = { on = \"M10\", off = \"M11\" } }\n";
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50,0,0.6,0.8\nGOTO/0,0,0,0,0.6,0.8\n\
                GOTO/20,0,0,0,0.6,0.8\n";
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, set_up, data);
    let end = program.rfind("M10\n").expect("the clamp after the last rotation");
    assert!(
        program[..end].rfind("A0.").is_some_and(|parked| parked > program.find("G1 ").unwrap_or_default()),
        "{program}"
    );
    let approach = program.find("M10\n").expect("the clamp of the approach");
    for (place, codes) in [(end, ""), (end, "M10\nM11\n"), (approach, "")] {
        let edited = format!("{}{codes}{}", &program[..place], &program[place + 4..]);
        let found = again::<OneTable>("fanuc", Mode::Axes, set_up, data, &edited);
        assert!(found.iter().any(|text| text.contains("clamp")), "{found:?}\n{edited}");
    }
    // It is released in the stretch before the last rapid, in which the axis does not rotate.
    let last = program.rfind("\nG0 Z").expect("the retract") + 1;
    let edited = format!("{}M11\n{}", &program[..last], &program[last..]);
    assert_told::<OneTable>("fanuc", Mode::Axes, set_up, data, &edited);
    // Without a position for parking nothing rotates at the end.
    let set_up = set_up.replace("park = { A = 0.0 }\n", "");
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, &set_up, data);
    let found = again::<OneTable>("fanuc", Mode::Axes, &set_up, data, &program.replace("M30\n", "M11\nM30\n"));
    assert!(found.iter().any(|text| text.contains("has been switched since the machine retract")), "{found:?}");
}

#[test]
fn an_offset_or_a_function_that_is_left_at_the_end_is_found() {
    let set_up = "retract.distance = 20\ntcp_frame = \"table_at_zero\"\n";
    for (control, end, codes) in [
        ("fanuc", "M30", &["G55", "G43 H1", "G41 D1", "G05.1 Q1", "G43.4 H2"][..]),
        ("haas", "M30", &["G55", "G43 H1", "G41 D1", "G187 P3 E0.01", "G234 H2"]),
        ("siemens", "M30", &["G55", "D2", "TRAORI", "CYCLE832(0.01,1,1)"]),
        ("linuxcnc", "M2", &["G55", "G43 H1", "G41.1 D5"]),
    ] {
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, TWO_OPERATIONS);
        for code in codes {
            let left = program.replace(&format!("{end}\n"), &format!("{code}\n{end}\n"));
            assert_ne!(left, program);
            assert_told::<OneTable>(control, Mode::Axes, set_up, TWO_OPERATIONS, &left);
        }
        // The machine retracts once more after a stop.
        let data = format!("{TWO_OPERATIONS}STOP\n");
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, &data);
        let stop = program.rfind("\nM0\n").or_else(|| program.rfind("\nM00\n")).expect("the stop") + 1;
        let left = format!("{}G55\n{}", &program[..stop], &program[stop..]);
        assert_told::<OneTable>(control, Mode::Axes, set_up, &data, &left);
    }
}

#[test]
fn the_rotary_axes_are_parked_first() {
    let set_up = "retract.distance = 20\npark = { A = 0.0, Y = 50.0 }\n";
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50,0,0.6,0.8\nGOTO/0,0,0,0,0.6,0.8\n\
                GOTO/20,0,0,0,0.6,0.8\n";
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, set_up, data);
    let parks = "G0 A0.\nG53 G0 Y50.\n";
    assert!(program.contains(parks), "{program}");
    let edited = program.replace(parks, "G53 G0 Y50.\nG0 A0.\n");
    let found = again::<OneTable>("fanuc", Mode::Axes, set_up, data, &edited);
    assert!(found.iter().any(|text| text.contains("parked after linear axes")), "{found:?}");
}

/// Where C is the main spindle, words of X must be radii, C an axis and the tool driven before anything moves, and the
/// spindle of the tool is not that of M3.
#[test]
fn a_turning_machine_states_its_modes_at_each_restart_point() {
    let turning = |spindle: &str, radius: &str| {
        format!(
            "retract.distance = 20\ncontrol.mill_turn = {{ radius = \"{radius}\", modes = [\"M200\", \"M252\"], spindle = {spindle} }}\n"
        )
    };
    for (control, set_up, on, off, others) in [
        ("fanuc", turning("[\"M203\", \"M204\", \"M205\"]", "G122.1"), "S2000\nM203\n", "M205\n", ["M3", "M5"]),
        ("siemens", turning("3", "DIAMOF"), "S3=2000\nM3=3\n", "M3=5\n", ["M3", "M5"]),
    ] {
        let program = posted_right::<OneTable>(control, Mode::Axes, &set_up, TWO_OPERATIONS);
        assert!(program.contains(on) && program.contains(off), "{program}");
        assert!(!program.contains("1006#3") && !program.contains("X is a radius"), "{program}");
        let modes = "M200\nM252\n";
        assert_eq!(program.matches(modes).count(), 2, "{program}");
        for line in [modes, if control == "fanuc" { "G122.1\n" } else { "DIAMOF\n" }] {
            let place = program.rfind(line).expect("the modes of the second restart point");
            let lost = format!("{}{}", &program[..place], &program[place + line.len()..]);
            let found = again::<OneTable>(control, Mode::Axes, &set_up, TWO_OPERATIONS, &lost);
            assert!(found.iter().any(|text| text.contains("`control.mill_turn` is missing")), "{found:?}\n{lost}");
            let after = lost[place..].find("1000\n").expect("the second speed") + place + 5;
            let late = format!("{}{line}{}", &lost[..after], &lost[after..]);
            let found = again::<OneTable>(control, Mode::Axes, &set_up, TWO_OPERATIONS, &late);
            assert!(found.iter().any(|text| text.contains("before the machine retract")), "{found:?}\n{late}");
        }
        let [of_control, stop] = others;
        for (right, wrong) in [(on.lines().last().unwrap_or_default(), of_control), (off.trim_end(), stop)] {
            let edited = program.replace(&format!("\n{right}\n"), &format!("\n{wrong}\n"));
            assert_ne!(edited, program);
            let found = again::<OneTable>(control, Mode::Axes, &set_up, TWO_OPERATIONS, &edited);
            assert!(
                found.iter().any(|text| text.contains("another spindle than that of the tool")),
                "{found:?}\n{edited}"
            );
        }
        let slow = program.replace(on, &on.replace("2000", "200"));
        assert_told::<OneTable>(control, Mode::Axes, &set_up, TWO_OPERATIONS, &slow);
    }
    // Without the key the program states what must be so.
    let plain = posted_right::<OneTable>("fanuc", Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS);
    assert!(plain.contains("1006#3"), "{plain}");
    let tap = "UNITS/MM\nLOADTL/1\nSPINDL/500,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/TAP,DEPTH,10,CLEAR,5,MMPR,1.25\nGOTO/0,0,0\nCYCLE/OFF\n\
               RAPID\nGOTO/0,0,50\n";
    let set_up = format!("cl.dialect = \"iso\"\n{}", turning("3", "parameter"));
    let refused = posted::<OneTable>("siemens", Mode::Axes, &set_up, tap).expect_err("a cycle runs the spindle of M3");
    assert!(refused.iter().any(|found| found.text.contains("tapping")), "{refused:?}");
}

/// Set-up of a shop that measures, with clamps, and a part in a tilted plane after one that is not.
const SHOP: &str = "retract.distance = 20\ncycles.measure_tool = [\"G65 P9023 A12. T{tool} H{offset}\"]\n\
                    cycles.check_tool = [\"G65 P9023 A22. T{tool}\"]\ncycles.tool_position = { A = 0.0 }\n\
                    clamp = { A = { on = \"M10\", off = \"M11\" } }\n\
                    tools = { 1 = { length = 120.0, measured = true, checked = true, start = [\"M131\"], end = [\"M133\"] }, \
                    2 = { length = 95.0 } }\ncontrol.effects = { M131 = \"none\", M133 = \"none\" }\n";

/// Three operations of two tools.
const THREE: &str = "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nCOOLNT/ON\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\n\
                     GOTO/0,0,0\nGOTO/20,0,0\nGOTO/20,0,50\nTOOL PATH/B,TOOL,T1\nRAPID\nGOTO/0,9,50,0,0.6,0.8\nGOTO/0,9,2,0,0.6,0.8\n\
                     GOTO/20,9,2,0,0.6,0.8\nGOTO/20,9,50,0,0.6,0.8\nTOOL PATH/C,TOOL,T2\nLOADTL/2\nSPINDL/RPM,1000,CLW\nRAPID\n\
                     GOTO/0,9,50,0,0,1\nGOTO/0,9,2\nGOTO/20,9,2\nGOTO/20,9,50\n";

#[test]
fn what_comes_at_the_retract_without_a_motion_for_it_is_found() {
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, SHOP, THREE);
    let tell = |before: &str, added: &str, text: &str| {
        let place = program.rfind(before).unwrap_or_else(|| panic!("{before} in\n{program}"));
        let edited = format!("{}{added}{}", &program[..place], &program[place..]);
        let found = again::<OneTable>("fanuc", Mode::Axes, SHOP, THREE, &edited);
        assert!(found.iter().any(|found| found.contains(text)), "{added}: {found:?}\n{edited}");
    };
    tell("T2 M6\n", "S500 M3\nM5\n", "the spindle has been switched on before");
    tell("M30\n", "M8\nM9\n", "the coolant has been switched on before");
    tell("G65 P9023 A22. T1", "M8\n", "coolant is on where blocks measure");
    tell("G65 P9023 A22. T1", "G05.1 Q1\n", "smoothing is on where blocks measure");
    tell("G65 P9023 A22. T1", "G55\n", "work offset is G55");
    tell("G65 P9023 A22. T1", "M11\n", "is not clamped here");
    tell("(OPERATION B)\n", "M133\n", "neither begins nor ends");
    let start = format!("program.operation_start = [\"M78\"]\n{SHOP}").replace("M131 =", "M78 = \"none\", M131 =");
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, &start, THREE);
    let edited = program.replacen("M78\n", "", 1).replacen("M131\n", "M78\nM131\n", 1);
    assert_ne!(edited, program);
    let found = again::<OneTable>("fanuc", Mode::Axes, &start, THREE, &edited);
    assert!(found.iter().any(|text| text.contains("those that start the work of its tool")), "{found:?}\n{edited}");
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, SHOP, THREE);
    tell("(OPERATION B)\n", "G65 P9023 A22. T1\n", "neither begins nor ends");
    let retract = program.rfind("G49 G53 G0 Z0.\nM5\n").expect("the last retract");
    let first = format!("{}M5\nG49 G53 G0 Z0.\n{}", &program[..retract], &program[retract + 18..]);
    let found = again::<OneTable>("fanuc", Mode::Axes, SHOP, THREE, &first);
    assert!(
        found.iter().any(|text| text.contains("the spindle is off before this machine retract")),
        "{found:?}\n{first}"
    );
}

#[test]
fn a_restart_point_has_all_that_an_entry_there_needs() {
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, SHOP, THREE);
    let change = program.find("T2 M6\n").expect("the change of the third operation") + 6;
    for (right, wrong, text) in [
        ("T2 M6\n", "M6\n", "is not called after the restart point"),
        ("M9\n", "", "the coolant is not switched off after the restart point"),
        (" G21 ", " ", "is no restart point"),
    ] {
        let place = program[..change].rfind(right).unwrap_or_else(|| panic!("{right} in\n{program}"));
        // Preselected, it is the right one in sequence.
        let edited = format!("{}{wrong}{}", &program[..place], &program[place + right.len()..]);
        let found = again::<OneTable>("fanuc", Mode::Axes, SHOP, THREE, &edited);
        assert!(found.iter().any(|found| found.contains(text)), "{right}: {found:?}\n{edited}");
    }
    // In sequence A is where it has to be.
    let program = posted_right::<OneTable>("fanuc", Mode::Axes, SHOP, TWO_OPERATIONS);
    let release = program.rfind("M11\n").expect("the release");
    let edited = format!("{}{}", &program[..release], &program[release + 4..]);
    let found = again::<OneTable>("fanuc", Mode::Axes, SHOP, TWO_OPERATIONS, &edited);
    assert!(
        found.iter().any(|text| text.contains("has not been released after the restart point")),
        "{found:?}\n{edited}"
    );
    let planes = format!("{SHOP}mode = \"plane\"\n");
    let program = posted_right::<OneTable>("fanuc", Mode::Plane, &planes, THREE);
    assert!(program.contains("G68.2"), "{program}");
    for place in program.match_indices("G69\n").map(|(place, _)| place) {
        let restart = program[..place].trim_end().lines().last().is_some_and(|line| line.starts_with('N'));
        if restart {
            let edited = format!("{}{}", &program[..place], &program[place + 4..]);
            let found = again::<OneTable>("fanuc", Mode::Plane, &planes, THREE, &edited);
            assert!(!found.is_empty(), "{edited}");
        }
    }
}

#[test]
fn a_block_of_the_shop_in_a_guard_is_found() {
    let set_up = "retract.distance = 20\nlength_guard = true\nprogram.operation_start = [\"M131\"]\ncontrol.effects = { M131 = \"none\" }\n\
                  tools = { 1 = { length = 120.0 }, 2 = { length = 95.0 } }\n";
    for (control, end) in [("siemens", "ENDIF\n"), ("linuxcnc", "endif\n")] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS);
        let line = program.rfind("M131\n").expect("the line of the shop");
        let without = format!("{}{}", &program[..line], &program[line + 5..]);
        let guard = without[..line].rfind(end).expect("a guard before it");
        let start = without[..guard].rfind('\n').expect("its line") + 1;
        let edited = format!("{}M131\n{}", &without[..start], &without[start..]);
        let found = again::<Mill>(control, Mode::Axes, set_up, TWO_OPERATIONS, &edited);
        assert!(found.iter().any(|text| text.contains("in a guard")), "{control}: {found:?}\n{edited}");
    }
}

#[test]
fn a_return_plane_in_the_part_is_found() {
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/500,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,DEPTH,10,CLEAR,3,MMPM,100\nGOTO/0,0,0\nGOTO/20,0,0\n\
                CYCLE/OFF\nRAPID\nGOTO/20,0,50\n";
    let set_up = "cl.dialect = \"iso\"\nretract.distance = 20\n";
    let program = posted_right::<Mill>("siemens", Mode::Axes, set_up, data);
    let edited = program.replace("MCALL CYCLE81(3,", "MCALL CYCLE81(-5,");
    assert_ne!(edited, program);
    let found = again::<Mill>("siemens", Mode::Axes, set_up, data, &edited);
    assert!(found.iter().any(|text| text.contains("RTP is -5")), "{found:?}\n{edited}");
}

/// Both dwells may be as long: that of the spindle is not the one in which coolant drains.
#[test]
fn coolant_drains_with_the_spindle_off() {
    let set_up = "retract.distance = 20\ncoolant.through_dwell = 2.0\nspindle_dwell = 2.0\n\
                  control.coolant = { through = [\"M88\", \"M89\"] }\n";
    let data = THREE.replace("COOLNT/ON", "COOLNT/THRU");
    posted_right::<OneTable>("fanuc", Mode::Axes, set_up, &data);
}

/// A probe measures where the last motion of its operation has led it; the operation ends after that.
#[test]
fn a_probe_measures_within_its_operation() {
    let set_up = "retract.distance = 20\nprogram.operation_end = [\"M78\"]\nprogram.operation_start = [\"M79\"]\n\
                  control.effects = { M78 = \"none\", M79 = \"none\" }\n\
                  [cycles.probe]\n\"PROBE/BORE,20\" = [\"G65 P9810 Z-5. F3000.\"]\n";
    let data = "UNITS/MM\nTOOL PATH/PROBE,TOOL,P\nLOADTL/9,LENGTH,150\nSPINDL/OFF\nRAPID\nGOTO/10,20,30,0,0,1\nRAPID\nGOTO/10,20,5\n\
                PROBE/BORE, 20\nRAPID\nGOTO/10,20,30\nTOOL PATH/CUT,TOOL,M\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/0,0,30\n\
                FEDRAT/MMPM,300\nGOTO/0,0,20\n";
    for control in ["fanuc", "haas"] {
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, data);
        let place = program.find("G65").expect("the probe");
        assert!(!program[..place].contains("M78"), "{program}");
        let end = program.find("M78\n").expect("the end of its operation");
        let lost = format!("{}{}", &program[..end], &program[end + 4..]);
        let found = again::<OneTable>(control, Mode::Axes, set_up, data, &lost);
        assert!(found.iter().any(|text| text.contains("`M78`")), "{found:?}\n{lost}");
    }
}

#[test]
fn a_work_offset_that_changes_in_a_cut_is_found_though_it_comes_back() {
    for control in ISO {
        let program = posted_right::<Mill>(control, Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS);
        let feed = program.rfind("G1 ").or_else(|| program.rfind("G01 ")).expect("a cut");
        let line = program[..feed].rfind('\n').expect("its line") + 1;
        let edited = format!("{}G55\nG54\n{}", &program[..line], &program[line..]);
        let found = again::<Mill>(control, Mode::Axes, "retract.distance = 20\n", TWO_OPERATIONS, &edited);
        assert!(found.iter().any(|text| text.contains("work offset changes")), "{control}: {found:?}\n{edited}");
    }
}

/// Where each block has every word, the next one leads to the same level all the same.
#[test]
fn a_lift_to_the_level_of_the_next_hole_that_is_lost_is_found() {
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/500,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,DEPTH,10,CLEAR,3,MMPM,100\nGOTO/0,0,0\n\
                GOTO/20,0,2\nCYCLE/OFF\nRAPID\nGOTO/20,0,50\n";
    let set_up =
        "cl.dialect = \"iso\"\nretract.distance = 20\ncontrol.every_word = true\ncycles.output = \"expanded\"\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, data);
    let lift = program.find("G0 X0. Y0. Z5.\n").expect("the lift");
    let edited = format!("{}{}", &program[..lift], &program[lift + 15..]);
    let found = again::<Mill>("fanuc", Mode::Axes, set_up, data, &edited);
    assert!(!found.is_empty(), "{edited}");
}

const CONTOUR: &str = "UNITS/MM\nLOADTL/1,ADJUST,1\nSPINDL/RPM,4000,CLW\nRAPID\nGOTO/0,0,50\nRAPID\nGOTO/0,0,2\nFEDRAT/MMPM,300\n\
                       GOTO/0,0,-2\nCUTCOM/LEFT\nGOTO/0,-20,-2\nGOTO/30,-20,-2\nGOTO/30,20,-2\nGOTO/-30,20,-2\n\
                       GOTO/-30,-20,-2\nGOTO/5,-20,-2\nCUTCOM/OFF\nGOTO/5,0,-2\nRAPID\nGOTO/5,0,50\n";

/// Fanuc, 16i operator's manual, B-63664EN/02, p. 170: after two blocks without a motion the tool cuts into an inner
/// corner.
#[test]
fn blocks_that_end_the_look_ahead_of_a_contour_are_found() {
    let set_up = "retract.distance = 20\ncompensation.path = \"contour\"\ntools = { 1 = { diameter = 10.0 } }\n";
    for (control, corner, idle) in [
        ("fanuc", "X30.\n", &["X30.\n", "G90\nF300.\n", "M3\nM3\n", "Z-2.\nZ-2.\n"][..]),
        ("haas", "X30.\n", &["G90\nF300.\n"]),
        ("siemens", "X30\n", &["STOPRE\n", "CYCLE832()\n", "G90\nG17\nG94\nM3\n"]),
    ] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, CONTOUR);
        let place = program.find(corner).expect("the corner") + corner.len();
        for blocks in idle {
            let edited = format!("{}{blocks}{}", &program[..place], &program[place..]);
            let found = again::<Mill>(control, Mode::Axes, set_up, CONTOUR, &edited);
            assert!(found.iter().any(|text| text.contains("look")), "{control} {blocks}: {found:?}\n{edited}");
        }
        let edited = format!("{}(NOTE)\n", &program[..place])
            .replace("(NOTE)", if control == "siemens" { "; NOTE" } else { "(NOTE)" });
        let edited = format!("{edited}{}", &program[place..]);
        assert_eq!(
            again::<Mill>(control, Mode::Axes, set_up, CONTOUR, &edited),
            [""; 0],
            "{control}: a comment is no block"
        );
    }
    // Two functions of the CL data between two motions are as many blocks.
    let data = CONTOUR
        .replace("GOTO/30,20,-2\n", "GOTO/30,20,-2\nCOOLNT/OFF\nSPINDL/RPM,3000,CLW\n")
        .replace("RAPID\nGOTO/0,0,2", "COOLNT/ON\nRAPID\nGOTO/0,0,2");
    let (found, _) = posted::<Mill>("fanuc", Mode::Axes, set_up, &data).expect("it can be posted");
    assert!(found.iter().any(|text| text.contains("looks ahead over one")), "{found:?}");
}

#[test]
fn exact_stop_in_blocks_that_may_be_skipped_is_found() {
    let data = "UNITS/MM\nTOOL PATH/A,TOOL,T\nLOADTL/1\nSPINDL/RPM,2000,CLW\nOPSKIP/ON\nRAPID\nGOTO/0,0,30,0,0,1\nFEDRAT/MMPM,300\n\
                GOTO/0,0,20\nRAPID\nGOTO/0,0,60\nOPSKIP/OFF\nTOOL PATH/B,TOOL,T\nLOADTL/1\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/5,5,30\n\
                FEDRAT/MMPM,300\nGOTO/5,5,20\nGOTO/25,5,20\nRAPID\nGOTO/5,5,60\n";
    let set_up = "retract.distance = 20\n";
    for control in ["fanuc", "haas"] {
        let program = posted_right::<OneTable>(control, Mode::Axes, set_up, data);
        let place = program.rfind("/M").expect("a block that may be skipped");
        let edited = format!("{}/G61\n{}", &program[..place], &program[place..]);
        let found = again::<OneTable>(control, Mode::Axes, set_up, data, &edited);
        assert!(found.iter().any(|text| text.contains("G61")), "{control}: {found:?}\n{edited}");
    }
}

#[test]
fn units_that_leave_out_f_are_found_on_siemens() {
    let set_up = "retract.distance = 20\n";
    let program = posted_right::<Mill>("siemens", Mode::Axes, set_up, TWO_OPERATIONS);
    let found = again::<Mill>("siemens", Mode::Axes, set_up, TWO_OPERATIONS, &program.replace("G710", "G71"));
    assert!(found.iter().any(|text| text.contains("basic unit")), "{found:?}");
}

/// An arc as flat as its chord is a line of the contour: the planner refuses what the check would find.
#[test]
fn an_arc_that_is_its_chord_is_offset_with_its_contour() {
    let data = "UNITS/MM\nTOOL PATH/A,TOOL,T4\nTLDATA/MILL,10.0,0.0,50.0,0.0,0.0\n\
                MSYS/0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0,0.0\nLOADTL/4\nSPINDL/RPM,6495,CLW\nRAPID\nGOTO/60.50366,-17.41285,57.14693,0.0,0.0,1.0\n\
                FEDRAT/MMPM,576.09506\nGOTO/60.50366,-17.41285,3.50157\nCUTCOM/LEFT\nGOTO/50.29777,-0.20218,3.50157\n\
                GOTO/61.63656,-9.09379,3.50157\n\
                CIRCLE/100.26304,-11.98046,3.50157,0.0,0.0,-1.0,38.73419,0.0600,0.5000,10.0,0.0\nGOTO/122.89526,19.45392,3.50157\n\
                GOTO/113.90129,-28.09651,3.50157,0.0,0.0,1.0\n\
                CIRCLE/113.63209,-27.96409,3.50157,0.0,0.0,1.0,0.30000,0.0600,0.5000,10.0,0.0\nGOTO/113.88447,-28.12628,3.50157\n\
                CIRCLE/137.70329,-43.88426,3.50157,0.0,0.0,-1.0,28.55959,0.0600,0.5000,10.0,0.0\nGOTO/136.52888,-72.41970,3.50157\n\
                CUTCOM/OFF\nGOTO/136.90430,-78.47149,3.50157\nGOTO/136.90430,-78.47149,60.50746\nEND-OF-PATH\n";
    let set_up = "retract.distance = 100\ncompensation.path = \"centre\"\n";
    let refused = posted::<Mill>("heidenhain", Mode::Axes, set_up, data).expect_err("the wear does not fit");
    assert!(refused.iter().any(|fault| fault.text.contains("wear")), "{refused:?}");
}
