//! Settings of the control that no word states (`[control.states]`), and places that an axis has left.

use super::*;

/// A hole in steps of 2 mm well below the end of the travel.
const PECK: &str = "UNITS/MM\nTOOL PATH/DEEP,TOOL,T1\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/0,0,50\n\
                    CYCLE/DEEP,DEPTH,12,STEP,2,CLEAR,3,MMPM,200\nGOTO/0,0,10\nCYCLE/OFF\nRAPID\nGOTO/0,0,50\n";

const TRAVEL: &str = "retract.distance = 20\nlimits = { Z = [-700, 0] }\nmachine_zero = { Z = -400 }\n";

#[test]
fn the_rise_of_a_peck_above_r_is_part_of_its_path() {
    let with = |rise: f64| format!("{TRAVEL}control.states = {{ \"setting 52\" = {rise:.1} }}\n");
    let (found, program) = posted::<Mill>("haas", Mode::Axes, &with(1.0), PECK).expect("it can be posted");
    assert_eq!(found, [""; 0], "{program}");
    assert!(program.contains("G83") && program.contains("setting 52 ["), "{program}");
    let found = again::<Mill>("haas", Mode::Axes, &with(400.0), PECK, &program);
    assert!(found.iter().any(|text| text.contains("limit")), "{found:?}");
}

#[test]
fn a_gap_that_is_as_long_as_a_step_makes_no_cycle() {
    for (control, key, cycle) in [("haas", "setting 22", "G83"), ("fanuc", "5115", "G83")] {
        let with = |gap: f64| format!("{TRAVEL}control.states = {{ \"{key}\" = {gap:.1} }}\n");
        let right = posted_right::<Mill>(control, Mode::Axes, &with(0.5), PECK);
        assert!(right.contains(&format!(" {cycle} X")), "{right}");
        let expanded = posted_right::<Mill>(control, Mode::Axes, &with(2.0), PECK);
        assert!(!expanded.contains(&format!(" {cycle} X")), "{expanded}");
        let found = again::<Mill>(control, Mode::Axes, &with(2.0), PECK, &right);
        assert!(found.iter().any(|text| text.contains("makes no way")), "{found:?}");
        // Where it is not given, the value that the program needs is stated.
        let unknown = posted_right::<Mill>(control, Mode::Axes, TRAVEL, PECK);
        assert!(unknown.to_lowercase().contains(&format!("assumed {key}")), "{unknown}");
    }
    let (control, mut config) = configured::<Mill>("siemens", Mode::Axes, "control.states = { \"5115\" = 0.5 }\n");
    let left_out = crate::control::take_out_lacking(control, &mut config.control, &mut config.motion.operations);
    assert!(left_out.iter().any(|text| text.contains("has no state `5115`")), "{left_out:?}");
}

#[test]
fn an_axis_that_has_left_its_parking_position_is_not_there() {
    let set_up = "retract = { distance = 20, home_on_indexing = true, x = 0, y = -50 }\npark = { Y = 200 }\n";
    let set_up = set_up.replace("x = 0, y = -50", "xy = { X = 0, Y = -50 }");
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,50\nGOHOME\n";
    let program = posted_right::<Mill>("linuxcnc", Mode::Axes, &set_up, data);
    let last = program.rfind("G53 G0 Y200\n").expect("the parking position");
    let moved = format!("{}G53 G0 X0 Y-50\n{}", &program[..last], &program[last + "G53 G0 Y200\n".len()..]);
    assert_told::<Mill>("linuxcnc", Mode::Axes, &set_up, data, &moved);
}

/// Home and parking position of an axis differ: the axis is at home before the rotary axes park, and at its parking
/// position at the end.
#[test]
fn an_axis_at_home_is_not_parked() {
    let set_up =
        "retract = { distance = 37.0, home_on_indexing = true, xy = { Y = -50.0 } }\npark = { Y = 200.0, C = 0.0 }
tools = { 1 = { length = 93.0 } }\n";
    let data = "UNITS/MM\nLOADTL/1\nFEDRAT/MMPM,300\nRAPID\nGOTO/0,8,50,0.5,0.1,0.8602325\nGOTO/10,5,0\nGOTO/20,0,0\n";
    for (control, park) in [("heidenhain", "L Y+200 R0 FMAX M91\n"), ("fanuc", "G53 G0 Y200.\n")] {
        let program = posted_right::<HeadTable>(control, Mode::Axes, set_up, data);
        let at = program.find(park).unwrap_or_else(|| panic!("{program}"));
        let without = format!("{}{}", &program[..at], &program[at + park.len()..]);
        assert_told::<HeadTable>(control, Mode::Axes, set_up, data, &without);
    }
}

/// Coolant that has run through the spindle drains before the tool is changed.
#[test]
fn a_tool_is_changed_after_coolant_through_the_spindle_has_run_out() {
    let set_up =
        "retract.distance = 20\ncoolant.through_dwell = 2.5\ncontrol.coolant = { through = [\"M88\", \"M89\"] }\n";
    let data = "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nCOOLNT/THRU\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\n\
                GOTO/0,0,0\nGOTO/20,0,0\nCOOLNT/OFF\nGOTO/20,5,0\nTOOL PATH/B,TOOL,T2\nLOADTL/2\nSPINDL/RPM,1000,CLW\nRAPID\n\
                GOTO/0,9,50\nGOTO/0,9,2\nGOTO/20,9,2\nTOOL PATH/C,TOOL,T3\nLOADTL/3\nSPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,9,50\n\
                GOTO/0,9,2\nGOTO/20,9,2\n";
    for (control, dwell, change) in
        [("fanuc", "G4 P2500\n", "T2 M6"), ("haas", "G04 P2.5\n", "T2 M06"), ("siemens", "G4 F2.5\n", "T2\n")]
    {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, data);
        assert!(program.contains(&format!("{dwell}{change}")), "{control}: {program}");
        // The next tool has cut dry.
        assert_eq!(program.matches(dwell).count(), 1, "{control}: {program}");
        assert_told::<Mill>(control, Mode::Axes, set_up, data, &program.replace(dwell, ""));
    }
}

/// Where the CL data leads to the part, no approach of the post comes before it.
#[test]
fn an_approach_of_no_length_ends_at_the_first_point() {
    let set_up = "retract.distance = 20\napproach.distance = 0\n";
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/5,6,50,0,0.6,0.8\nRAPID\nGOTO/5,9,54\n\
                GOTO/5,0,42\nGOTO/20,0,42\n";
    for (control, mode) in [("fanuc", Mode::Axes), ("heidenhain", Mode::Plane), ("siemens", Mode::Tcp)] {
        posted_right::<Tables>(control, mode, set_up, data);
    }
    let cut = data.replace("RAPID\nGOTO/5,6,50", "GOTO/5,6,50");
    let refused = posted::<Tables>("fanuc", Mode::Axes, set_up, &cut).expect_err("a rapid would lead to a cut");
    assert!(refused[0].text.contains("is a cut"), "{}", refused[0].text);
    // A program of another post, which does that.
    let near = "retract.distance = 20\napproach.distance = 0.001\n";
    let program = posted_right::<Tables>("fanuc", Mode::Axes, near, &cut);
    let found = again::<Tables>("fanuc", Mode::Axes, set_up, &cut, &program);
    assert!(found.iter().any(|text| text.contains("the approach leads to the end of a cut")), "{found:?}");
}

/// Back to the part after a rewind at a feed of its own.
#[test]
fn the_tool_comes_back_from_a_rewind_at_its_own_feed() {
    let around: String = (0..=24).fold(String::new(), |text, step| {
        let angle = (f64::from(step) * 20.0).to_radians();
        let (x, y) = (angle.cos(), angle.sin());
        format!("{text}GOTO/{:.4},{:.4},0,{:.7},{:.7},0.8660254\n", 20.0 * x, 20.0 * y, 0.5 * x, 0.5 * y)
    });
    let data = format!(
        "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/20,0,50,0.5,0,0.8660254\n{around}"
    );
    let set_up = "retract.distance = 40\nretract.entry_feed = 900\nlimits = { C = [-200, 200] }\n";
    for control in ["fanuc", "heidenhain", "siemens"] {
        let program = posted_right::<Tables>(control, Mode::Axes, set_up, &data);
        assert!(program.contains("F900"), "{control}: {program}");
        assert_told::<Tables>(control, Mode::Axes, set_up, &data, &program.replace("F900", "F700"));
    }
}

/// Two operations; the rotary axes rotate before each.
const TWO_INDEXINGS: &str = "UNITS/MM\nMULTAX/ON\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\n\
                             GOTO/0,0,50,0.5,0,0.8660254\nGOTO/0,0,0\nGOTO/20,0,0\nTOOL PATH/B,TOOL,T2\nLOADTL/2\n\
                             SPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,9,50,0,0.5,0.8660254\nGOTO/0,9,0\nGOTO/20,9,0\n";

/// The linear axes go home for a rotation, and for nothing else.
#[test]
fn linear_axes_that_go_home_where_nothing_rotates_are_found() {
    let set_up = "retract = { distance = 37.0, home_on_indexing = true, xy = { X = 10.0, Y = -50.0 } }\n";
    for (control, home) in [("fanuc", "G53 G0 X10. Y-50.\n"), ("linuxcnc", "G53 G0 X10 Y-50\n")] {
        let program = posted_right::<Tables>(control, Mode::Axes, set_up, TWO_INDEXINGS);
        assert_eq!(program.matches(home).count(), 2, "{program}");
        let at = program.find("\nM5\n").expect("the spindle stops before the tool change") + 1;
        let added = format!("{}{home}{}", &program[..at], &program[at..]);
        let found = again::<Tables>(control, Mode::Axes, set_up, TWO_INDEXINGS, &added);
        assert!(found.iter().any(|text| text.contains("no rotary axis rotates")), "{found:?}\n{added}");
    }
}

/// Each operation may be entered at its complete state: then the axes are where another program has left them.
#[test]
fn an_operation_programs_the_position_of_each_axis() {
    // With the same tool and the same tool axis nothing has moved them.
    let same = TWO_INDEXINGS.replace("0,0.5,0.8660254", "0.5,0,0.8660254").replace("T2\nLOADTL/2", "T1");
    let program = posted_right::<Tables>("fanuc", Mode::Axes, "retract.distance = 37.0\n", &same);
    let last = program.rfind(" C0.\n").expect("the rotary axes");
    let without = format!("{}{}", &program[..last], &program[last + " C0.".len()..]);
    let found = again::<Tables>("fanuc", Mode::Axes, "retract.distance = 37.0\n", &same, &without);
    let text = "without the position of C, which must be programmed after its restart point";
    assert!(found.iter().any(|found| found.contains(text)), "{found:?}\n{without}");
}

/// A word that moves nothing may be in the block of the parking position.
#[test]
fn a_parking_block_may_repeat_a_word_of_a_linear_axis() {
    let set_up = "retract.distance = 37\npark = { B = 0.0, C = 0.0 }\n";
    let data = TWO_INDEXINGS;
    let program = posted_right::<Tables>("fanuc", Mode::Axes, set_up, data);
    let park = program.lines().rfind(|line| line.contains("B0.")).expect("the parking position");
    let word = program.split_whitespace().rfind(|word| word.starts_with('X')).expect("the last X");
    let repeated = program.replacen(&format!("{park}\nM30"), &format!("{park} {word}\nM30"), 1);
    assert_ne!(repeated, program, "{program}");
    assert_eq!(again::<Tables>("fanuc", Mode::Axes, set_up, data, &repeated), [""; 0]);
    let other = program.replacen(&format!("{park}\nM30"), &format!("{park} X1.\nM30"), 1);
    assert_told::<Tables>("fanuc", Mode::Axes, set_up, data, &other);
}

/// With tool vectors the control finds the rotary angles: a clamp is released for each of them, and F is no lower than
/// half a revolution at the pole asks for.
#[test]
fn with_tool_vectors_near_the_pole_clamps_and_f_are_compared() {
    let set_up = "retract.distance = 50\ntcp_frame = \"table_at_zero\"\ntcp_confirmed = true\ntcp_words = \"vectors\"\n\
                  speeds = { C = 3600.0 }\nclamp.B = { on = \"M68\", off = \"M69\" }\n";
    let data = "UNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/900,MMPM\nGOTO/0,0,20,0.0144,0.0003,0.9998963\n\
                GOTO/6,0,20,0.0002,0,0.99999998\nGOTO/12,0,20,-0.0055,0.0019,0.99998307\n\
                GOTO/18,0,20,-0.3,-0.0042,0.9539300\n";
    let program = posted_right::<Tables>("fanuc", Mode::Tcp, set_up, data);
    assert!(program.contains("F900."), "{program}");
    assert_told::<Tables>("fanuc", Mode::Tcp, set_up, data, &program.replace("F900.", "F100."));
    let last = program.lines().rfind(|line| line.contains(" K0.")).expect("a block with a tool vector");
    let clamped = program.replace(&format!("{last}\n"), &format!("M68\n{last}\n"));
    assert_told::<Tables>("fanuc", Mode::Tcp, set_up, data, &clamped);
}
