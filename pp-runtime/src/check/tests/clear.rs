//! Rapids and the clearance geometry, where each axis moves on its own.

use super::*;

const BOX: &str = "retract.clearance = { box = [[-50, -50, -50], [50, 50, 20]] }\n";
const CYLINDER: &str = "retract.clearance = { cylinder = { radius = 60, lower = -50, upper = 20 } }\n";
const FOUND: &str = "if each axis of this rapid moves on its own, the tip may be ";

/// A cut in the middle, out above the geometry, and to the right of it; then the motions of a test.
fn data(motions: &str) -> String {
    format!(
        "UNITS/MM\nLOADTL/1,LENGTH,100.0\nFEDRAT/MMPM,300\nRAPID\nGOTO/0,0,40,0,0,1\nGOTO/0,0,10\nGOTO/10,0,10\nRAPID\n\
         GOTO/10,0,40\nRAPID\nGOTO/110,0,40\nRAPID\nGOTO/110,0,0\n{motions}"
    )
}

/// Findings about clearance geometry in a program that was posted for rapids whose axes arrive together: CL line and
/// depth, mm.
fn deep<M: Machine>(control: &str, mode: Mode, set_up: &str, data: &str) -> Vec<(String, f64)> {
    let stated = set_up.contains("linear_rapids");
    let together = if stated { set_up.to_owned() } else { format!("{set_up}control.linear_rapids = true\n") };
    let together = together.replace("linear_rapids = false", "linear_rapids = true");
    let (_, program) = posted::<M>(control, mode, &together, data).expect("it can be posted");
    let found = again::<M>(control, mode, set_up, data, &program);
    found.iter().map(|text| deep_in(text).unwrap_or_else(|| panic!("{text}\n{program}"))).collect()
}

fn deep_in(text: &str) -> Option<(String, f64)> {
    let (line, text) = text.split_once(": ")?;
    let (depth, _) = text.strip_prefix(FOUND)?.split_once(" mm deep")?;
    Some((line.to_owned(), depth.parse().expect("a number")))
}

#[test]
fn a_rapid_round_a_corner_is_found_where_its_axes_may_cut_the_corner() {
    // The straight line passes the corner of the box and the cylinder; the corner of X and Y is in the middle of both.
    let round = data("RAPID\nGOTO/0,110,0\n");
    let depth = 20.0;
    for set_up in [BOX, CYLINDER] {
        for control in ["fanuc", "haas"] {
            let found = deep::<Mill>(control, Mode::Axes, set_up, &round);
            assert!(found.len() == 1 && found[0].0 == "15", "{control}: {found:?}");
            assert!(found[0].1 > 0.95 * depth && found[0].1 <= depth, "{control}: {found:?}");
            let together = format!("{set_up}control.linear_rapids = true\n");
            assert_eq!(deep::<Mill>(control, Mode::Axes, &together, &round), [], "{control}");
            assert_eq!(deep::<Mill>(control, Mode::Axes, "", &round), [], "{control}, without geometry");
        }
        for control in ["linuxcnc", "siemens", "heidenhain"] {
            assert_eq!(deep::<Mill>(control, Mode::Axes, set_up, &round), [], "{control}");
        }
        let apart = format!("{set_up}control.linear_rapids = false\n");
        assert_eq!(deep::<Mill>("siemens", Mode::Axes, &apart, &round).len(), 1);
        // One axis after the other, or above.
        let outside = data("RAPID\nGOTO/110,110,0\nRAPID\nGOTO/0,110,0\n");
        assert_eq!(deep::<Mill>("fanuc", Mode::Axes, set_up, &outside), []);
        let above = data("RAPID\nGOTO/110,0,20\nRAPID\nGOTO/0,110,20\nRAPID\nGOTO/-110,0,40\n");
        assert_eq!(deep::<Mill>("fanuc", Mode::Axes, set_up, &above), []);
        // Straight through it, as the CL data has it.
        let through = data("RAPID\nGOTO/-110,30,5\n");
        assert_eq!(deep::<Mill>("fanuc", Mode::Axes, set_up, &through), []);
    }
}

#[test]
fn a_clearp_of_the_cl_data_is_geometry_as_well() {
    // Over a plane that is inclined by 45° the tip goes along it; X alone leads into it.
    let tilted = "CLEARP/0.70710678,0,0.70710678,115\n";
    let data = data(&format!("RAPID\nGOTO/110,0,60\n{tilted}RAPID\nGOTO/60,0,110\n"));
    let found = deep::<Mill>("fanuc", Mode::Axes, "", &data);
    assert!(found.is_empty(), "CLEARP is in force from the next motion on: {found:?}");
    let data = format!("{data}RAPID\nGOTO/110,0,60\n");
    let found = deep::<Mill>("fanuc", Mode::Axes, "", &data);
    assert!(found.len() == 1 && found[0].0 == "20", "{found:?}");
    assert_eq!(deep::<Mill>("siemens", Mode::Axes, "", &data), []);
}

#[test]
fn a_rotary_axis_that_swings_the_part_into_the_tip_is_found_at_every_share_of_its_rotation() {
    // The tip is where it was, above the box, and the tool is inclined: the table may rotate before X and Z have moved.
    let inclined = data("RAPID\nGOTO/110,0,40\nRAPID\nGOTO/45,0,25\nRAPID\nGOTO/45,0,25,0.5,0,0.8660254\n");
    let set_up = format!("{BOX}index_angle = 45\n");
    for (control, mode) in [("fanuc", Mode::Axes), ("haas", Mode::Axes), ("fanuc", Mode::Tcp), ("haas", Mode::Tcp)] {
        let set_up = format!("{set_up}tcp_frame = \"table_at_zero\"\n");
        let found = deep::<Tables>(control, mode, &set_up, &inclined);
        assert!(found.len() == 1 && found[0].0 == "19", "{control} {}: {found:?}", mode.name());
        let together = format!("{set_up}control.linear_rapids = true\n");
        assert_eq!(deep::<Tables>(control, mode, &together, &inclined), [], "{control} {}", mode.name());
    }
    // High above the part the table may swing as it will.
    let high = data("RAPID\nGOTO/110,0,400\nRAPID\nGOTO/45,0,400\nRAPID\nGOTO/45,0,400,0.5,0,0.8660254\n");
    assert_eq!(deep::<Tables>("fanuc", Mode::Axes, &set_up, &high), []);
}

/// Two operations: the second begins next to the geometry, below its top.
fn two_operations() -> String {
    let first = data("");
    let second = "TOOL PATH/SECOND,TOOL,T1\nLOADTL/1,LENGTH,100.0\nGOTO/0,100,0\nGOTO/0,100,-5\nRAPID\nGOTO/0,100,40\n";
    first.replace("LOADTL/1", "TOOL PATH/FIRST,TOOL,T1\nLOADTL/1") + second
}

/// Text of a program in which two blocks in a row are one.
fn joined(program: &str, first: &str, second: &str) -> String {
    let (rows, one) = (format!("{first}\n{second}"), format!("{first} {second}"));
    assert_eq!(program.matches(&rows).count(), 1, "{program}");
    program.replace(&rows, &one)
}

#[test]
fn an_approach_with_x_y_and_z_in_one_block_may_lead_through_the_geometry() {
    let set_up = format!("{BOX}approach.distance = 10\n");
    let data = two_operations();
    let program = posted_right::<Mill>("fanuc", Mode::Axes, &set_up, &data);
    let wrong = joined(&program, "X0. Y100.", "G43 H1 Z10.");
    let found = again::<Mill>("fanuc", Mode::Axes, &set_up, &data, &wrong);
    assert!(found.iter().any(|text| text.contains("order of the approach")), "{found:?}");
    assert!(found.iter().any(|text| text.contains(FOUND)), "{found:?}");
    // An approach point above the geometry is reached outside it in any order.
    let set_up = format!("{BOX}approach.distance = 30\n");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, &set_up, &data);
    let wrong = joined(&program, "X0. Y100.", "G43 H1 Z30.");
    let found = again::<Mill>("fanuc", Mode::Axes, &set_up, &data, &wrong);
    assert!(found.len() == 1 && found[0].contains("order of the approach"), "{found:?}");
}

#[test]
fn a_rotary_word_in_a_block_that_is_over_the_part_is_found() {
    let set_up = "retract.clearance = { box = [[-50, -50, -50], [50, 50, 150]] }\napproach.distance = 10\n";
    let data = two_operations().replace("GOTO/0,100,0\n", "GOTO/0,-70,0,0,0.5,0.8660254\n");
    let program = posted_right::<Tables>("fanuc", Mode::Axes, set_up, &data);
    let start = program.find("SECOND").expect("the second operation");
    let rotary = program[start..].lines().find(|line| line.contains('B') && line.contains(" C")).expect("B and C");
    let down = program[start..].lines().find(|line| line.starts_with("G43")).expect("the retract axis");
    let words = rotary.trim_start_matches("G0 ");
    let after = program[start..].replace(&format!("{rotary}\n"), "G0\n").replace(down, &format!("{down} {words}"));
    let wrong = format!("{}{after}", &program[..start]);
    let found = again::<Tables>("fanuc", Mode::Axes, set_up, &data, &wrong);
    assert!(found.iter().any(|text| text.contains(FOUND)), "{found:?}\n{wrong}");
}

#[test]
fn a_retract_that_ends_in_the_geometry_is_found() {
    let data = "UNITS/MM\nLOADTL/1,LENGTH,100.0\nFEDRAT/MMPM,300\nRAPID\nGOTO/0,0,40,0.5,0,0.8660254\nGOTO/0,0,10\n\
                GOTO/10,0,10\nEND-OF-PATH\n";
    for control in ["fanuc", "haas", "siemens"] {
        let program = posted_right::<HeadTable>(control, Mode::Axes, BOX, data);
        let retract = program.lines().rfind(|line| line.contains('X') && line.contains('Z')).expect("the retract");
        let short = retract.split('Z').next().expect("the words before Z");
        let rest: f64 = retract.split('Z').nth(1).and_then(|value| value.parse().ok()).expect("Z");
        let wrong = program.replace(retract, &format!("{short}Z{:.1}", rest - 5.0));
        assert_told::<HeadTable>(control, Mode::Axes, BOX, data, &wrong);
    }
}

/// What the axes could get into so is left by the safe sequence: as posted, each program passes.
#[test]
fn a_program_is_posted_so_that_no_rapid_may_get_into_the_geometry() {
    let round = data("RAPID\nGOTO/0,110,0\n");
    let above = data("RAPID\nGOTO/110,0,20\nRAPID\nGOTO/0,110,20\n");
    let sequences = |control: &str, set_up: &str, data: &str| {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, data);
        program.lines().filter(|line| line.contains("G53")).count()
    };
    for set_up in [BOX, CYLINDER] {
        for control in ["fanuc", "haas"] {
            let straight = sequences(control, set_up, &above);
            assert_eq!(sequences(control, set_up, &round), straight + 1, "{control}");
            assert_eq!(sequences(control, &format!("{set_up}control.linear_rapids = true\n"), &round), straight);
        }
    }
}

#[test]
fn the_machine_retract_leads_away_from_the_part() {
    let data = "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,350\n\
                GOTO/20,0,350,0.6,0,0.8\nRAPID\nGOTO/20,0,350\nFINI\n";
    let set_up = |zero: f64| {
        format!(
            "retract.distance = 20\ntcp_frame = \"table_at_zero\"\ntools = {{ 1 = {{ length = 100 }} }}\nmachine_zero = {{ Z = {zero:?} }}\n"
        )
    };
    for (control, mode) in [
        ("fanuc", Mode::Axes),
        ("linuxcnc", Mode::Axes),
        ("haas", Mode::Tcp),
        ("siemens", Mode::Tcp),
        ("heidenhain", Mode::Tcp),
        ("heidenhain", Mode::Axes),
    ] {
        let program = posted_right::<Tables>(control, mode, &set_up(-600.0), data);
        let refused = posted::<Tables>(control, mode, &set_up(-250.0), data).expect_err("it would come down");
        let text = "mm above the retract position Z = 0 mm (machine coordinate)";
        assert!(refused.iter().any(|fault| fault.text.contains(text)), "{control}: {refused:?}");
        let found = again::<Tables>(control, mode, &set_up(-250.0), data, &program);
        let text = "mm towards the part: Z is at machine coordinate";
        assert!(found.iter().any(|found| found.contains(text)), "{control}: {found:?}\n{program}");
    }
}
