//! Functions that the configuration selects: a program has them, and a program without them is found.

use super::*;

/// What is wrong with a configuration.
fn refused<M: Machine>(control: &str, mode: Mode, set_up: &str) -> Vec<String> {
    let (control, config) = configured::<M>(control, mode, set_up);
    control::unfit(&M::default(), control, config.demands())
}

/// One tool, four cuts of three axes.
fn cuts(record: &str) -> String {
    format!(
        "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\n{record}\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\nGOTO/0,0,0\nGOTO/20,0,0\n\
         GOTO/20,20,0\nGOTO/20,20,50\n"
    )
}

#[test]
fn the_pressure_of_coolant_through_the_spindle_is_written_where_codes_are_configured() {
    let data = cuts("COOLNT/THRU,HIGH");
    let plain = posted_right::<Mill>("haas", Mode::Axes, "", &data);
    assert!(plain.contains("\nM88\n") && plain.contains("\nM89\n"), "{plain}");
    let codes = "control.coolant = { through = [\"M88\", \"M89\"], through_high = [\"M388\", \"M89\"] }\n";
    let high = posted_right::<Mill>("haas", Mode::Axes, codes, &data);
    assert!(high.contains("\nM388\n") && high.contains("\nM89\n") && !high.contains("\nM88\n"), "{high}");
    let low = posted_right::<Mill>("haas", Mode::Axes, codes, &cuts("COOLNT/THRU,LOW"));
    assert!(low.contains("\nM88\n") && !low.contains("\nM388\n"), "{low}");
    assert_told::<Mill>("haas", Mode::Axes, codes, &data, &high.replace("M388", "M88"));
    assert_told::<Mill>("haas", Mode::Axes, codes, &cuts("COOLNT/THRU,LOW"), &low.replace("M88", "M388"));
    let same = "control.coolant = { through_high = [\"M88\", \"M89\"] }\n";
    assert!(refused::<Mill>("haas", Mode::Axes, same)[0].contains("have the code M88"));
}

#[test]
fn kinds_of_coolant_that_a_tool_needs_together_are_switched_on_and_off_together() {
    let data = cuts("COOLNT/ON");
    let codes = "control.coolant = { flood = [\"M8\", \"M9\"], through = [\"M51\", \"M59\"], through_high = [\"M52\", \"M59\"] }\n";
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        for (kind, on) in [("through", "M51"), ("through_high", "M52")] {
            let set_up = format!("{codes}tools.1.coolant = [\"{kind}\", \"flood\"]\n");
            let program = posted_right::<Mill>(control, Mode::Axes, &set_up, &data);
            let at = |code: &str| program.rfind(&format!("{code}\n")).unwrap_or_else(|| panic!("{code}: {program}"));
            assert!(at("M8") < at(on) && at(on) < at("M9") && at("M9") < at("M59"), "{control} {program}");
            for (was, is) in [(on, "M8"), ("M8", on), ("M59", "M9")] {
                let (was, is) = (format!("{was}\n"), format!("{is}\n"));
                let last = program.rfind(&was).expect("it is there");
                let changed = format!("{}{is}{}", &program[..last], &program[last + was.len()..]);
                assert_told::<Mill>(control, Mode::Axes, &set_up, &data, &changed);
            }
            // For another tool it is what the defaults say.
            let other = set_up.replace("tools.1", "tools.2");
            let program = posted_right::<Mill>(control, Mode::Axes, &other, &data);
            assert!(order::with_codes(&program, &[on]).is_empty(), "{control} {program}");
        }
    }
}

#[test]
fn a_coolant_code_that_the_configuration_replaces_is_a_finding() {
    let data = cuts("COOLNT/ON");
    let set_up = "control.coolant = { flood = [\"M181\", \"M189\"] }\n";
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, &data);
        let first_off = program.find("M189\n").unwrap_or_else(|| panic!("{program}"));
        let on = program.find("M181\n").unwrap_or_else(|| panic!("{program}"));
        assert!(first_off < on && !program.contains("M8\n") && !program.contains("M08\n"), "{control} {program}");
        let told = |changed: &str| again::<Mill>(control, Mode::Axes, set_up, &data, changed).join("\n");
        let found = told(&program.replace("M181\n", "M8\n"));
        assert!(found.contains("`M8` is no coolant code of this machine: its code is `M181`"), "{control}: {found}");
        let last = program.rfind("M189\n").expect("it is there");
        let found = told(&format!("{}M9\n{}", &program[..last], &program[last + 5..]));
        assert!(!found.is_empty(), "{control}: {program}");
        let both = "control.coolant = { flood = [\"M181\", \"M189\"], mist = [\"M182\", \"M189\"] }\n";
        let program = posted_right::<Mill>(control, Mode::Axes, both, &data);
        let found = again::<Mill>(control, Mode::Axes, both, &data, &program.replace("M189\n", "M9\n")).join("\n");
        assert!(found.contains("`M9` is no coolant code of this machine: its code is `M189`"), "{control}: {found}");
        // A code of the same spelling stays what it is.
        let same = "control.coolant = { flood = [\"M7\", \"M9\"], mist = [\"M8\", \"M9\"] }\n";
        posted_right::<Mill>(control, Mode::Axes, same, &data);
        posted_right::<Mill>(control, Mode::Axes, same, &cuts("COOLNT/MIST"));
    }
}

#[test]
fn the_blank_of_the_configuration_is_at_the_head_of_the_program_on_controls_with_graphics() {
    let data = cuts("COOLNT/ON");
    let cuboid = "stock = { lower = [-5, -6, -20.5], upper = [30, 31, 0] }\n";
    let round = "stock = { diameter = 81, bottom = -20.5, top = 2 }\n";
    for (control, set_up, lines) in [
        ("heidenhain", cuboid, "BLK FORM 0.1 Z X-5 Y-6 Z-20.5\n2 BLK FORM 0.2 X+30 Y+31 Z+0\n"),
        ("heidenhain", round, "BLK FORM CYLINDER Z R40.5 L22.5 DIST+2\n"),
        ("siemens", cuboid, "WORKPIECE(,\"\",,\"BOX\",112,0,-20.5,-80,-5,-6,30,31)\n"),
        ("siemens", round, "WORKPIECE(,\"\",,\"CYLINDER\",192,2,-20.5,-20.5,81)\n"),
    ] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, &data);
        assert!(program.contains(lines), "{program}");
        let found = |changed: &str| again::<Mill>(control, Mode::Axes, set_up, &data, changed).join("\n");
        let changed = lines.replace("-20.5", "-20.4").replace("L22.5", "L22.4");
        assert!(found(&program.replace(lines, &changed)).contains("differs"), "{changed}");
        let without: String = match control {
            "siemens" => program.replace(lines, ""),
            _ => posted_right::<Mill>(control, Mode::Axes, "stock = { diameter = 9, bottom = 0, top = 1 }\n", &data),
        };
        let text = found(&without);
        assert!(text.contains(if control == "siemens" { "is missing" } else { "differs" }), "{text}");
        // In inches it is written in inches.
        let inches = posted_right::<Mill>(control, Mode::Axes, &format!("output_units = \"in\"\n{set_up}"), &data);
        assert!(!inches.contains(lines), "{inches}");
    }
    // About another point it is the box around it.
    let moved = format!("program_zero = \"table\"\npart_origin = [1, 0, 10]\n{round}");
    let program = posted_right::<Mill>("heidenhain", Mode::Axes, &moved, &data);
    assert!(
        program.contains("BLK FORM 0.1 Z X-39.5 Y-40.5 Z-10.5\n") && program.contains("not about X0 Y0"),
        "{program}"
    );
    for control in ["linuxcnc", "fanuc", "haas"] {
        posted_right::<Mill>(control, Mode::Axes, round, &data);
    }
    // Without it a Siemens program has none, and one of a TNC a box around the cuts.
    assert!(!posted_right::<Mill>("siemens", Mode::Axes, "", &data).contains("WORKPIECE"));
}

/// Two operations of three axes with the same tool.
fn rough_and_finish() -> String {
    let operation = |name: &str, z: i32| {
        format!(
            "TOOL PATH/{name},TOOL,D10\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,50\nGOTO/0,0,{z}\n\
             GOTO/20,0,{z}\nGOTO/20,20,{z}\nGOTO/20,20,50\nEND-OF-PATH\n"
        )
    };
    format!("UNITS/MM\n{}{}", operation("ROUGH", 1), operation("FINISH", 0))
}

#[test]
fn level_and_tolerance_of_smoothing_are_those_of_the_operation() {
    let data = rough_and_finish();
    let set_up = "path_tolerance = 0.01\n[control]\nsmoothing = \"medium\"\nsmoothing_levels = [1, 5, 10]\n\
                  [operations]\n\"ROUGH\" = { smoothing = \"rough\", path_tolerance = 0.05 }\n\
                  \"FINISH\" = { smoothing = \"finish\" }\n";
    for (control, rough, finish) in [
        ("linuxcnc", "G64 P0.05", "G64 P0.01"),
        ("fanuc", "G05.1 Q1 R1", "G05.1 Q1 R10"),
        ("haas", "G187 P1 E0.05", "G187 P3 E0.01"),
        ("siemens", "CYCLE832(0.05,3,1)", "CYCLE832(0.01,1,1)"),
        ("heidenhain", "CYCL DEF 32.1 T0.05", "CYCL DEF 32.1 T0.01"),
    ] {
        let program = posted_right::<Mill>(control, Mode::Axes, set_up, &data);
        let at = |block: &str| program.find(&format!("{block}\n")).unwrap_or_else(|| panic!("{block}: {program}"));
        assert!(at(rough) < at(finish), "{program}");
        for (was, is) in [(rough, finish), (finish, rough)] {
            let changed = program.replace(&format!("{was}\n"), &format!("{is}\n"));
            assert_told::<Mill>(control, Mode::Axes, set_up, &data, &changed);
        }
        if control == "fanuc" {
            for level in ["", " R5", " R11"] {
                let changed = program.replace(&format!("{rough}\n"), &format!("G05.1 Q1{level}\n"));
                assert_told::<Mill>(control, Mode::Axes, set_up, &data, &changed);
            }
        }
        // Without a safe sequence between them the second operation has its tolerance all the same.
        let direct = format!("transition = \"direct\"\n{set_up}");
        let direct = posted_right::<Mill>(control, Mode::Axes, &direct, &data);
        assert!(direct.contains(&format!("{finish}\n")), "{control} {direct}");
    }
    let plain = set_up.replace("smoothing_levels = [1, 5, 10]\n", "");
    assert!(posted_right::<Mill>("fanuc", Mode::Axes, &plain, &data).contains("G05.1 Q1\n"));
}

#[test]
fn gohome_retracts_with_no_parking_position_on_every_control() {
    let data = format!("{}GOHOME\nGOTO/5,5,10\nGOTO/5,5,0\nGOTO/5,5,20\nGOHOME\n", cuts("COOLNT/ON"));
    for control in ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"] {
        posted_right::<Mill>(control, Mode::Axes, "", &data);
        posted_right::<Tables>(control, Mode::Axes, "", &data);
    }
}

#[test]
fn blocks_between_opskip_on_and_off_have_the_mark_of_block_skip() {
    let data = cuts("COOLNT/ON").replace("GOTO/20,0,0\n", "OPSKIP/ON\nGOTO/20,0,0\nOPSKIP/OFF\n");
    let program = posted_right::<Mill>("fanuc", Mode::Axes, "[retract]\ndistance = 20\n", &data);
    let at = program.find("X20.").expect("the cut");
    assert!(program[..at].rfind("\n/") > program[..at].rfind("\nN"), "{program}");
}

/// A blade in miniature: short blocks in which the rotary axes rotate.
fn short_blocks() -> String {
    let mut data = "UNITS/MM\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nFEDRAT/3000,MMPM\n".to_owned();
    for point in 0..12 {
        let (x, tilt) = (f64::from(point) * 0.04, (20.0 + 0.3 * f64::from(point)).to_radians());
        data += &format!("GOTO/{x:.3},0,20,{:.7},0,{:.7}\n", tilt.sin(), tilt.cos());
    }
    data
}

/// Largest F of the blocks in inverse time.
fn largest_inverse_time(program: &str) -> f64 {
    let blocks = program.split("G93").nth(1).expect("inverse time").split("G94").next().unwrap_or_default();
    let words = blocks.split_whitespace().filter_map(|word| word.strip_prefix('F')?.parse().ok());
    words.fold(0.0, f64::max)
}

#[test]
fn f_of_inverse_time_stays_within_what_the_control_takes() {
    let set_up = "retract.distance = 50\nfeed.keep_speeds = false\n";
    let data = short_blocks();
    let haas = posted_right::<Tables>("haas", Mode::Axes, set_up, &data);
    assert!((largest_inverse_time(&haas) - 9999.99).abs() < 1e-9, "{haas}");
    let fanuc = posted_right::<Tables>("fanuc", Mode::Axes, set_up, &data);
    assert!(largest_inverse_time(&fanuc) > 50_000.0, "{fanuc}");
    for control in ["linuxcnc", "fanuc", "siemens", "haas"] {
        for largest in [777.7777, 60_000.0] {
            let set_up = format!("{set_up}feed.largest_inverse_time = {largest}\n");
            let program = posted_right::<Tables>(control, Mode::Axes, &set_up, &data);
            let found = largest_inverse_time(&program);
            assert!(found <= largest && (found > 0.999 * largest || largest > 1000.0), "{control} {found}\n{program}");
            // A block that no limit holds back must not be slower.
            let slower = program.replacen(&format!("F{found}"), &format!("F{}", found * 0.99), 1);
            assert_ne!(slower, program);
            assert_told::<Tables>(control, Mode::Axes, &set_up, &data, &slower);
        }
    }
    let other = format!("{set_up}feed.largest_inverse_time = 60000\n");
    let faster = posted_right::<Tables>("haas", Mode::Axes, &other, &data);
    assert_told::<Tables>("haas", Mode::Axes, set_up, &data, &faster);
    assert_told::<Tables>("haas", Mode::Axes, &other, &data, &haas);
    let beyond = haas.replacen("F9999.99", "F10000.", 1);
    assert_told::<Tables>("haas", Mode::Axes, set_up, &data, &beyond);
}

#[test]
fn the_word_of_the_tool_posture_is_left_out_where_it_is_an_option() {
    let data =
        "UNITS/MM\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nGOTO/0,0,20,0,0,1\nGOTO/10,0,20,0.1,0,0.9949874\n";
    let set_up = "retract.distance = 50\ntcp_frame = \"table_at_zero\"\ntcp_confirmed = true\n";
    for (vectors, code) in [("", "G43.4 H1"), ("tcp_words = \"vectors\"\n", "G43.5 H1")] {
        let written = format!("{set_up}{vectors}");
        let left_out = format!("{written}control.posture_word = false\n");
        let with = posted_right::<Tables>("fanuc", Mode::Tcp, &written, data);
        assert!(with.contains(&format!("{code} P0 X")), "{with}");
        let without = posted_right::<Tables>("fanuc", Mode::Tcp, &left_out, data);
        assert!(without.contains(&format!("{code} X")), "{without}");
        assert!(without.contains("19604#0"), "{without}");
        // The check takes what is configured, and nothing else.
        assert_told::<Tables>("fanuc", Mode::Tcp, &written, data, &without);
        assert_told::<Tables>("fanuc", Mode::Tcp, &left_out, data, &with);
        assert_told::<Tables>("fanuc", Mode::Tcp, &left_out, data, &with.replace(" P0 ", " P1 "));
    }
    // Where no setting takes its place, it is written.
    for (control, word) in [("siemens", "ORIMKS ORIAXES"), ("heidenhain", "PATHCTRL AXIS")] {
        let set_up = "retract.distance = 50\ncontrol.posture_word = false\ncontrol.swivel_data = \"T\"\n";
        let program = posted_right::<Tables>(control, Mode::Tcp, set_up, data);
        assert!(program.contains(word) && program.contains("`control.posture_word = false` is left out"), "{program}");
    }
}

/// A contour that T1, 12 mm in diameter, cuts with compensation; T2 cuts without it.
fn contour() -> &'static str {
    "UNITS/MM\nCUTTER/12\nLOADTL/1\nSPINDL/RPM,2000,CLW\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,-20,50\nGOTO/0,-20,0\nCUTCOM/LEFT\n\
     GOTO/0,0,0\nGOTO/30,0,0\nSPINDL/RPM,3000,CLW\nGOTO/40,0,0\nCUTCOM/OFF\nGOTO/40,20,0\nGOTO/40,20,50\nCUTTER/8\nLOADTL/2\n\
     SPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,0,50\nGOTO/0,0,0\nGOTO/5,0,0\nGOTO/5,0,50\n"
}

const CENTRE: &str = "compensation.path = \"centre\"\nretract.distance = 20\n";

#[test]
fn a_tnc_takes_the_radius_of_the_tool_off_in_the_tool_call_where_the_path_is_that_of_the_centre() {
    let (control, mode) = ("heidenhain", Mode::Axes);
    let program = posted_right::<Mill>(control, mode, CENTRE, contour());
    assert!(program.contains("TOOL CALL 1 Z S2000 DR-6\n"), "{program}");
    assert!(program.contains("TOOL CALL S3000 DR-6\n"), "{program}");
    assert!(program.contains("TOOL CALL 2 Z S1000\n"), "{program}");
    for (was, is) in
        [("S2000 DR-6", "S2000"), ("S2000 DR-6", "S2000 DR-4"), ("S2000 DR-6", "S2000 DR+6"), ("S3000 DR-6", "S3000")]
    {
        assert_told::<Mill>(control, mode, CENTRE, contour(), &program.replace(was, is));
    }
    let inches = format!("{CENTRE}output_units = \"in\"\n");
    assert!(posted_right::<Mill>(control, mode, &inches, contour()).contains(" DR-0.2362\n"));
    // Without a radius in the CL data that of the configuration.
    let unknown = contour().replace("CUTTER/12\n", "");
    let found = posted::<Mill>(control, mode, CENTRE, &unknown).expect_err("no radius");
    assert!(found[0].text.contains("the radius of T1 is unknown"), "{found:?}");
    let given = format!("{CENTRE}tools.1.diameter = 10\n");
    assert!(posted_right::<Mill>(control, mode, &given, &unknown).contains("S2000 DR-5\n"));
    // Where D is the radius the tool call has no delta.
    let radius = CENTRE.replace("centre", "contour");
    let plain = posted_right::<Mill>(control, mode, &radius, contour());
    assert!(plain.contains("TOOL CALL 1 Z S2000\n"), "{plain}");
    assert_told::<Mill>(control, mode, &radius, contour(), &plain.replace("Z S2000", "Z S2000 DR-6"));
    // Blocks of the shop have the field, or the path of the centre is refused.
    let own = format!("{CENTRE}control.tool_change = [\"TOOL CALL {{tool}} Z S{{speed}}\"]\n");
    let found = posted::<Mill>(control, mode, &own, contour()).expect_err("no field for the delta");
    assert!(found[0].help.as_ref().is_some_and(|help| help.contains("{radius_delta}")), "{found:?}");
    let own = own.replace("S{speed}", "S{speed} DR{radius_delta}");
    assert!(posted_right::<Mill>(control, mode, &own, contour()).contains("TOOL CALL 1 Z S2000 DR-6\n"));
}

#[test]
fn a_siemens_stops_where_the_radius_of_the_edge_is_more_than_wear_and_the_path_is_that_of_the_centre() {
    let (control, mode) = ("siemens", Mode::Axes);
    let program = posted_right::<Mill>(control, mode, CENTRE, contour());
    let guard = "IF ABS($P_TOOLR)>0.5\n";
    assert_eq!(program.matches(guard).count(), 1, "{program}");
    let begin = program.find(guard).expect("the guard");
    let end = begin + program[begin..].find("ENDIF\n").expect("its end") + "ENDIF\n".len();
    let without = format!("{}{}", &program[..begin], &program[end..]);
    let wider = program.replace(guard, "IF ABS($P_TOOLR)>0.6\n");
    let silent = program.replacen("M0\nM30\nENDIF", "ENDIF", 1);
    for changed in [&without, &wider, &silent] {
        assert_told::<Mill>(control, mode, CENTRE, contour(), changed);
    }
    let wear = format!("{CENTRE}compensation.largest_wear = 0.1\n");
    assert_told::<Mill>(control, mode, &wear, contour(), &program);
    assert!(posted_right::<Mill>(control, mode, &wear, contour()).contains("$P_TOOLR)>0.1\n"));
    let radius = CENTRE.replace("centre", "contour");
    assert!(!posted_right::<Mill>(control, mode, &radius, contour()).contains("$P_TOOLR"));
    // With D0 no radius is taken.
    let gauge =
        format!("{CENTRE}length_mode = \"gauge\"\ntools = {{ 1 = {{ length = 100 }}, 2 = {{ length = 90 }} }}\n");
    assert!(!posted_right::<Mill>(control, mode, &gauge, contour()).contains("$P_TOOLR"));
}

/// LinuxCNC refuses the level after a hole under cutter compensation.
#[test]
fn a_linuxcnc_sets_no_level_after_a_hole_while_cutter_compensation_is_on() {
    let set_up = CENTRE.replace("centre", "contour");
    let program = posted_right::<Mill>("linuxcnc", Mode::Axes, &set_up, contour());
    for code in ["G98", "G99"] {
        let added = program.replacen("\nX30", &format!("\n{code} X30"), 1);
        let found = again::<Mill>("linuxcnc", Mode::Axes, &set_up, contour(), &added);
        assert!(found.iter().any(|text| text.contains("the control refuses it")), "{found:?}\n{added}");
    }
}

#[test]
fn tools_are_called_by_their_names_where_the_control_can() {
    let data = contour().replace("CUTCOM/LEFT\n", "").replace("CUTCOM/OFF\n", "");
    let set_up = "tools = { 1 = { name = \"MILL_D12\" }, 2 = { name = \"MILL_D8\" } }\nretract.distance = 20\n";
    let named = format!("{set_up}control.tool_names = true\ncontrol.preselect = true\n");
    for (control, by_name, by_number, other) in [
        ("siemens", "T=\"MILL_D12\"\n", "T1\n", "T=\"MILL_D8\"\n"),
        ("heidenhain", "TOOL CALL \"MILL_D12\" Z S2000\n", "TOOL CALL 1 Z S2000\n", "TOOL CALL \"MILL_D8\" Z S2000\n"),
    ] {
        let plain = posted_right::<Mill>(control, Mode::Axes, set_up, &data);
        assert!(plain.contains(by_number) && !plain.contains(by_name), "{plain}");
        let program = posted_right::<Mill>(control, Mode::Axes, &named, &data);
        assert!(program.contains(by_name), "{program}");
        let next = if control == "siemens" { "\nT=\"MILL_D8\"\n" } else { "TOOL DEF \"MILL_D8\"\n" };
        assert!(program.contains(next), "{program}");
        // The check takes what is configured, and nothing else.
        assert_told::<Mill>(control, Mode::Axes, &named, &data, &program.replacen(by_name, by_number, 1));
        assert_told::<Mill>(control, Mode::Axes, &named, &data, &program.replacen(by_name, other, 1));
        assert_told::<Mill>(
            control,
            Mode::Axes,
            &named,
            &data,
            &program.replacen(by_name, &by_name.replace("D12", "D13"), 1),
        );
        assert_told::<Mill>(control, Mode::Axes, set_up, &data, &program);
        // A tool without a name, a name twice, a name that the control does not take.
        let one = named.replace(", 2 = { name = \"MILL_D8\" }", "");
        let found = posted::<Mill>(control, Mode::Axes, &one, &data).expect_err("T2 has no name");
        assert!(found[0].text.contains("T2 has no name"), "{found:?}");
        let twice = named.replace("MILL_D8", "MILL_D12");
        assert!(refused::<Mill>(control, Mode::Axes, &twice)[0].contains("the same name"));
        let odd = named.replace("MILL_D8", "MILL 'D8'");
        assert_eq!(refused::<Mill>(control, Mode::Axes, &odd).is_empty(), control == "siemens");
        let own = format!(
            "{named}control.tool_change = [\"{}\"]\n",
            match control {
                "siemens" => "T{tool} M6",
                _ => "TOOL CALL {tool} Z S{speed}",
            }
        );
        assert!(posted_right::<Mill>(control, Mode::Axes, &own, &data).contains("\"MILL_D12\" "));
    }
    for (control, call) in [("linuxcnc", "T1 M6\n"), ("fanuc", "T1 M6\n"), ("haas", "T1 M06\n")] {
        assert!(posted_right::<Mill>(control, Mode::Axes, &named, &data).contains(call), "{control}");
    }
    // The guard reads a row of the tool table by its number.
    let guarded = format!("{named}length_guard = true\ntools.1.length = 100\n")
        .replace("tools = { 1 = { name = \"MILL_D12\" }", "tools = { 1 = { name = \"MILL_D12\", length = 100 }")
        .replace("2 = { name = \"MILL_D8\" }", "2 = { name = \"MILL_D8\", length = 90 }")
        .replace("tools.1.length = 100\n", "");
    assert!(refused::<Mill>("heidenhain", Mode::Axes, &guarded)[0].contains("length_guard"));
    posted_right::<Mill>("siemens", Mode::Axes, &guarded, &data);
}

#[test]
fn tip_control_by_codes_of_the_shop_is_off_at_each_restart_point_whatever_the_program_uses() {
    let data = cuts("COOLNT/ON");
    for (control, codes, off) in [
        ("linuxcnc", "\"M428\", \"M429\"", "M429"),
        ("heidenhain", "\"M176\", \"M177\"", "M177"),
        ("siemens", "\"TRAORI(2)\", \"M177\"", "M177"),
    ] {
        let set_up = format!("control.tip_control = [{codes}]\n");
        let program = posted_right::<Mill>(control, Mode::Axes, &set_up, &data);
        let line = program.lines().find(|line| line.ends_with(off)).unwrap_or_else(|| panic!("{control}: {program}"));
        assert_told::<Mill>(control, Mode::Axes, &set_up, &data, &program.replace(&format!("{line}\n"), ""));
    }
}
