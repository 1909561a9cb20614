//! Small programs, each with edits at the machine that the check must find.

use pp_runtime::config::Mode;
use tests::edits::{Case, Posted};

const SET_UP: &str = "units = \"mm\"\npart_origin = [0, 0, 0]\nwork_offset = \"G54\"\nspindle_dwell = 1.0\n";

/// Two threads, two holes, and a cut.
const THREADS: &str = "UNITS/MM\nTOOL PATH/HOLES,TOOL,T1\nLOADTL/1\nSPINDL/RPM,500,CLW\nCOOLNT/ON\nRAPID\n\
    GOTO/0,0,50,0,0,1\nCYCLE/TAP,RAPTO,3,FEDTO,-10,MMPR,1.0\nGOTO/0,0,0\nGOTO/10,0,0\nCYCLE/OFF\n\
    CYCLE/DRILL,RAPTO,3,FEDTO,-10,MMPM,100\nGOTO/20,0,0\nGOTO/30,0,0\nCYCLE/OFF\n\
    CYCLE/TAP,RAPTO,3,FEDTO,-10,MMPR,1.0\nGOTO/40,0,0\nCYCLE/OFF\nFEDRAT/200,MMPM\nGOTO/40,0,20\n\
    RAPID\nGOTO/0,0,50\nEND-OF-PATH\nFINI\n";

/// A circle of three and a half turns.
const TURNS: &str = "UNITS/MM\nTOOL PATH/TURNS,TOOL,T1\nLOADTL/1\nSPINDL/RPM,500,CLW\nRAPID\n\
    GOTO/10,0,50,0,0,1\nRAPID\nGOTO/10,0,5\nFEDRAT/200,MMPM\nGOTO/10,0,0\n\
    CIRCLE/0,0,0,0,0,1,10,0.06,0.5,10,0,TIMES,4\nGOTO/-10,0,0\nRAPID\nGOTO/-10,0,50\nEND-OF-PATH\nFINI\n";

fn posted(control: &str, mode: Mode, more: &str, cl: &str) -> Posted {
    let (keys, sections) = more.split_at(more.find('[').unwrap_or(more.len()));
    let config = format!("{keys}{SET_UP}{sections}");
    let case = Case {
        name: control,
        machine: "spinner-u5-620",
        control,
        mode,
        operations: None,
        config: &config,
        cl: cl.as_bytes(),
        idle: &["M10", "M11", "M13", "M14", "M68", "M69"],
    };
    let posted = Posted::of(&case).unwrap_or_else(|why| panic!("{control}: {why}"));
    let findings = posted.findings(&posted.text);
    assert!(findings.is_empty(), "{control}: {findings:?}\n{}", posted.text);
    posted
}

/// The program without the numbers of Heidenhain lines.
fn unnumbered(posted: &Posted) -> String {
    posted.subject.lines.join("\n") + "\n"
}

/// Replaces a text at its `index`th place; the check must find it.
fn is_found(posted: &Posted, text: &str, index: usize, by: &str) {
    let program = unnumbered(posted);
    let (at, _) = program.match_indices(text).nth(index).unwrap_or_else(|| panic!("{text}:\n{program}"));
    let edited = format!("{}{by}{}", &program[..at], &program[at + text.len()..]);
    let edited = posted.subject.text(&[edited.trim_end().to_owned()]);
    assert!(!posted.findings(&edited).is_empty(), "not found: {text} {index} -> {by}\n{edited}");
}

/// Starts of the spindle.
fn starts(posted: &Posted) -> usize {
    posted.subject.lines.iter().filter(|line| line.ends_with(" M3") || line.ends_with(" M03") || *line == "M3").count()
}

#[test]
fn after_a_thread_that_stops_it_the_spindle_starts_before_the_next_hole_and_cut() {
    for (control, more, start) in
        [("fanuc", "", "S500 M3\nG4 P1000\n"), ("haas", "", "S500 M03\nG04 P1.\n"), ("heidenhain", "", "M3\n")]
    {
        let posted = posted(control, Mode::Axes, more, THREADS);
        assert_eq!(starts(&posted), 3, "{}", posted.text);
        for (index, _) in unnumbered(&posted).match_indices(start).enumerate().skip(1) {
            if control == "heidenhain" {
                is_found(&posted, "M3\n", index, "M5\n");
            } else {
                is_found(&posted, start, index, "");
                let (spindle, dwell) = start.split_once('\n').expect("two blocks");
                is_found(&posted, start, index, dwell);
                is_found(&posted, start, index, &format!("{spindle}\n"));
            }
        }
    }
    // These leave the spindle on, and a floating tap holder needs it on.
    for (control, more) in [("linuxcnc", ""), ("siemens", ""), ("fanuc", "[cycles]\nrigid = false\n")] {
        assert_eq!(starts(&posted(control, Mode::Axes, more, THREADS)), 1, "{control}");
    }
}

#[test]
fn a_turn_in_the_other_sense_among_several_is_found() {
    for (control, more, text, by) in [
        ("linuxcnc", "[control]\nevery_word = true\n", "G2 ", "G3 "),
        ("fanuc", "[control]\nevery_word = true\n", "G2 ", "G3 "),
        ("haas", "[control]\nevery_word = true\n", "G02 ", "G03 "),
        ("siemens", "[control]\nevery_word = true\n", "G2 ", "G3 "),
        ("heidenhain", "", " DR-", " DR+"),
    ] {
        let posted = posted(control, Mode::Axes, more, TURNS);
        let arcs = unnumbered(&posted).matches(text).count();
        assert!(arcs >= 4, "{control}: {arcs} arcs\n{}", posted.text);
        (0..arcs).for_each(|index| is_found(&posted, text, index, by));
    }
}

#[test]
fn the_tolerance_of_smoothing_for_rotary_axes_is_compared() {
    let more = "[control]\nsmoothing = \"finish\"\nsmoothing_angle = 0.1\n";
    let stated = posted("heidenhain", Mode::Axes, more, TURNS);
    is_found(&stated, " TA0.1", 0, " TA5");
    is_found(&stated, " TA0.1", 0, "");
    let unstated = posted("heidenhain", Mode::Axes, "[control]\nsmoothing = \"finish\"\n", TURNS);
    is_found(&unstated, "HSC-MODE:0", 0, "HSC-MODE:0 TA5");
}

#[test]
fn mcall_shares_its_block_with_nothing() {
    let posted = posted("siemens", Mode::Axes, "", THREADS);
    for by in ["F100 MCALL CYCLE", "MCALL MCALL CYCLE", "G94 MCALL CYCLE"] {
        is_found(&posted, "MCALL CYCLE", 0, by);
    }
    is_found(&posted, "MCALL\n", 0, "MCALL F100\n");
}

#[test]
fn a_hole_while_rigid_tapping_is_active_is_found() {
    let posted = posted("fanuc", Mode::Axes, "", THREADS);
    is_found(&posted, "G80\nS500 M3", 0, "S500 M3");
}

#[test]
fn an_off_code_of_one_supply_says_nothing_about_the_others() {
    let more = "[control]\ncoolant = { through = [\"M88\", \"M89\"] }\n";
    let posted = posted("fanuc", Mode::Axes, more, TURNS);
    is_found(&posted, "M9\n", 0, "M89\n");
}

/// Two tools, with a dwell between the record of the second and its first motion.
const TWO_TOOLS: &str = "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,500,CLW\nRAPID\nGOTO/0,0,50,0,0,1\n\
    FEDRAT/200,MMPM\nGOTO/0,0,0\nRAPID\nGOTO/0,0,50\nEND-OF-PATH\nTOOL PATH/B,TOOL,T2\nLOADTL/2\nDELAY/2.5\n\
    SPINDL/RPM,700,CLW\nRAPID\nGOTO/0,0,50,0,0,1\nFEDRAT/200,MMPM\nGOTO/0,0,0\nRAPID\nGOTO/0,0,50\nEND-OF-PATH\nFINI\n";

#[test]
fn a_dwell_after_the_record_of_a_tool_comes_after_its_change_and_the_start_of_the_spindle() {
    let posted = posted("fanuc", Mode::Axes, "", TWO_TOOLS);
    assert!(posted.text.contains("S700 M3\nG4 P1000\nG4 P2500\n"), "{}", posted.text);
    is_found(&posted, "G4 P2500\n", 0, "");
    // With the tool before it is another dwell.
    let early = posted.text.replace("G4 P2500\n", "").replace("T2 M6\n", "G4 P2500\nT2 M6\n");
    let findings = posted.findings(&early);
    assert!(findings.iter().any(|text| text.contains("dwell with T1 in the spindle")), "{findings:?}");
}

#[test]
fn a_tool_change_of_the_shop_may_stop_before_it() {
    let more = "[control]\ntool_change = [\"M1\", \"T{tool} M6\"]\n";
    let posted = posted("fanuc", Mode::Axes, more, TWO_TOOLS);
    assert_eq!(posted.text.matches("M1\nT").count(), 2, "{}", posted.text);
    // At the part it is a stop that nothing asks for.
    is_found(&posted, "G1 Z0. F200.\n", 1, "G1 Z0. F200.\nM1\n");
    is_found(&posted, "M1\nT2", 0, "M0\nT2");
}

#[test]
fn smoothing_of_siemens_always_states_its_third_argument() {
    let stated = posted("siemens", Mode::Axes, "[control]\nsmoothing = \"finish\"\n", TURNS);
    for by in ["CYCLE832(0.01,1)", "CYCLE832(0.01,1,5)", "CYCLE832(0.01,11,1)", "CYCLE832(0.01,11)"] {
        is_found(&stated, "CYCLE832(0.01,1,1)", 0, by);
    }
    let angled = posted("siemens", Mode::Axes, "[control]\nsmoothing = \"rough\"\nsmoothing_angle = 0.1\n", TURNS);
    for by in ["CYCLE832(0.01,13,5)", "CYCLE832(0.01,3,1)"] {
        is_found(&angled, "CYCLE832(0.01,13,0.1)", 0, by);
    }
}

#[test]
fn a_code_of_the_machine_builder_takes_the_place_of_the_usual_meaning_of_its_number() {
    // M13 is spindle and coolant elsewhere; a TNC has it itself, and it is refused there.
    for control in ["fanuc", "siemens"] {
        let posted = posted(control, Mode::Axes, "[clamp]\nC = { on = \"M14\", off = \"M13\" }\n", TWO_TOOLS);
        is_found(&posted, "M13\n", 0, "M14\n");
    }
}

/// An operation with the tool upright, one with it tilted.
const TWO_PLANES: &str = "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,500,CLW\nRAPID\nGOTO/5,0,50,0,0,1\n\
    FEDRAT/200,MMPM\nGOTO/5,0,0\nGOTO/15,0,0\nRAPID\nGOTO/15,0,50\nEND-OF-PATH\n\
    TOOL PATH/B,TOOL,T1\nRAPID\nGOTO/40,0,40,0.7071067812,0,0.7071067812\n\
    FEDRAT/200,MMPM\nGOTO/20,0,20\nGOTO/20,10,20\nRAPID\nGOTO/40,10,40\nEND-OF-PATH\nFINI\n";

#[test]
fn a_plane_that_is_not_tilted_is_not_called_and_a_tilted_one_is_required() {
    for (control, call, plane) in [
        ("fanuc", "G68.2 ", "G53.1\n"),
        ("haas", "\nG268 ", "\nG253\n"),
        ("siemens", "CYCLE800(0", "CYCLE800(0"),
        ("heidenhain", "PLANE SPATIAL", "PLANE SPATIAL"),
    ] {
        let posted = posted(control, Mode::Plane, "", TWO_PLANES);
        assert_eq!(posted.text.matches(call).count(), 1, "{control}:\n{}", posted.text);
        assert_eq!(posted.text.matches(plane).count(), 1, "{control}:\n{}", posted.text);
        let lines = &posted.subject.lines;
        let line =
            lines.iter().find(|line| line.contains(call.trim_start()) && !line.starts_with("(")).expect("the call");
        is_found(&posted, &format!("{line}\n"), 0, "");
        // Upright the rotary axes have to be at zero.
        let upright = lines.iter().find(|line| line.contains("B0") || line.contains("B+0")).expect("upright");
        is_found(&posted, upright, 0, &upright.replace("C0", "C30").replace("C+0", "C+30"));
        is_found(&posted, upright, 0, &upright.replace("B0", "B5").replace("B+0", "B+5"));
    }
}

/// An operation with two tilted directions: B rotates, C stays.
const TWO_TILTS: &str = "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,500,CLW\nRAPID\n\
    GOTO/40,0,40,0.7071067812,0,0.7071067812\nFEDRAT/200,MMPM\nGOTO/20,0,20\nGOTO/20,10,20\n\
    RAPID\nGOTO/40,10,40,0.7071067812,0,0.7071067812\nRAPID\nGOTO/60,0,40,0.8660254,0,0.5\nFEDRAT/200,MMPM\n\
    GOTO/20,0,16.905989\nRAPID\nGOTO/60,0,40\nEND-OF-PATH\nFINI\n";

#[test]
fn no_axis_is_clamped_where_a_plane_call_may_rotate_it() {
    let more =
        "retract.distance = 30\n[clamp]\nB = { on = \"M10\", off = \"M11\" }\nC = { on = \"M68\", off = \"M69\" }\n";
    for (control, call) in
        [("fanuc", "G53.1\n"), ("haas", "\nG253\n"), ("siemens", "CYCLE800(0"), ("heidenhain", "PLANE SPATIAL")]
    {
        let posted = posted(control, Mode::Plane, more, TWO_TILTS);
        let calls: Vec<usize> = posted.text.match_indices(call).map(|(at, _)| at).collect();
        assert_eq!(calls.len(), 2, "{control}:\n{}", posted.text);
        for at in calls {
            for (on, off) in [("M10\n", "M11\n"), ("M68\n", "M69\n")] {
                let before = &posted.text[..at];
                assert!(before.rfind(off) > before.rfind(on), "{control}: {off} before the call:\n{}", posted.text);
            }
        }
        let last = posted.text.matches("M69\n").count() - 1;
        is_found(&posted, "M69\n", last, "");
    }
}
