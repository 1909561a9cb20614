//! Boring with the spindle stopped at an angle: the blocks of each control, what is refused, and a check that finds another
//! direction, distance or angle.

use machines::SpinnerU5620;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use tests::posting::{self, bare, posted, renumbered, written};

/// Two bores and a drilled hole with one tool.
const CL: &str = "UNITS/MM
TOOL PATH/BORES,TOOL,B
LOADTL/1,LENGTH,100
SPINDL/RPM,800,CLW
RAPID
GOTO/0,0,50,0,0,1
CYCLE/BORE,FEDTO,-12,RAPTO,3,RTRCTO,20,ORIENT,0,DWELL,0.5,MMPM,60
GOTO/10,5,0
GOTO/30,5,0
CYCLE/OFF
CYCLE/DRILL,FEDTO,-2,RAPTO,3,RTRCTO,20,MMPM,90
GOTO/50,5,0
CYCLE/OFF
RAPID
GOTO/50,5,60
FINI
";

fn by_name(name: &str) -> &'static dyn Control {
    control::by_name(name).expect("a control")
}

fn config(name: &str, keys: &str) -> Config {
    let text = format!("part_origin = [0.0, 0.0, 0.0]\n{keys}");
    starting_point(by_name(name))
        .read_over(&SpinnerU5620::default(), &text)
        .unwrap_or_else(|faults| panic!("{faults:?}"))
}

fn keys(direction: &str) -> String {
    format!("mode = 'axes'\ncycles = {{ bore_retract = '{direction}' }}\n")
}

/// A row of [`BLOCKS`].
type Row = (&'static str, &'static [&'static str], &'static [[&'static str; 2]], &'static [&'static str]);

/// Blocks of the two bores, with what another program would have in the first of them, and what begins the next hole.
const BLOCKS: &[Row] = &[
    (
        "fanuc",
        &["G98 G76 X10. Y5. Z-12. R3. Q0.2 P500 F60.", "X30."],
        &[["Q0.2", "Q0.3"], ["G76", "G86"], ["G76", "G85"], ["P500", "P600"], ["Z-12.", "Z-13."]],
        &["G80"],
    ),
    (
        "haas",
        &["G98 G76 X10. Y5. Z-12. R3. I-0.2 P0.5 F60.", "X30."],
        &[["I-0.2", "I0.2"], ["I-0.2", "J-0.2"], ["I-0.2", "I-0.3"], ["I-0.2", "Q0.2 I0.2"], ["G76", "G86"]],
        &["G80"],
    ),
    (
        "siemens",
        &["F60", "MCALL CYCLE86(20,0,3,-12,,0.5,3,-0.2,0,0,0)", "G0 X10 Y5", "X30"],
        &[
            [",3,-0.2,0,", ",3,0.2,0,"],
            [",3,-0.2,0,", ",3,0,-0.2,"],
            [",3,-0.2,0,", ",4,-0.2,0,"],
            [",0,0)", ",0,90)"],
            [",0,0)", ",1,0)"],
        ],
        &["MCALL"],
    ),
    (
        "heidenhain",
        &[
            "CYCL DEF 202 BORING ~",
            "Q200=+3 ;SET-UP CLEARANCE ~",
            "Q201=-12 ;DEPTH ~",
            "Q206=+60 ;FEED RATE FOR PLNGNG ~",
            "Q211=+0.5 ;DWELL TIME AT DEPTH ~",
            "Q208=+99999 ;RETRACTION FEED RATE ~",
            "Q203=+0 ;SURFACE COORDINATE ~",
            "Q204=+20 ;2ND SET-UP CLEARANCE ~",
            "Q214=+1 ;DISENGAGING DIRECTN ~",
            "Q336=+0 ;ANGLE OF SPINDLE",
            "L X+10 Y+5 R0 FMAX M99",
            "L X+30 R0 FMAX M99",
        ],
        &[["Q214=+1", "Q214=+3"], ["Q214=+1", "Q214=+0"], ["Q336=+0", "Q336=+90"], ["DEF 202", "DEF 201"]],
        &[],
    ),
];

#[test]
fn each_control_bores_by_its_cycle_and_the_check_finds_another_retract() {
    for &(name, blocks, others, next) in BLOCKS {
        let (control, config) = (by_name(name), config(name, &keys("-X")));
        let program = posted::<SpinnerU5620>(&config, control, CL);
        let lines = bare(&program);
        let expected = [blocks, next].concat();
        let at = lines.windows(expected.len()).position(|lines| lines == expected);
        let at = at.unwrap_or_else(|| panic!("{name}\n{program}"));
        for [was, is] in others {
            let place = (at..).find(|&place| lines[place].contains(was)).expect("the word");
            assert!(place < at + blocks.len(), "{name}: {was}");
            let other = lines[place].replace(was, is);
            let mut edited = lines.clone();
            edited[place] = &other;
            let found = posting::findings::<SpinnerU5620>(&config, control, CL, &renumbered(control, &edited));
            assert!(!found.is_empty(), "{name}: {other}");
        }
    }
}

#[test]
fn every_direction_is_written_and_compared() {
    let written = |name: &str, direction: &str| {
        let config = config(name, &keys(direction));
        (posted::<SpinnerU5620>(&config, by_name(name), CL), config)
    };
    for (name, words) in [
        ("haas", [" I0.2 ", " I-0.2 ", " J0.2 ", " J-0.2 "]),
        ("siemens", [",3,0.2,0,0,", ",3,-0.2,0,0,", ",3,0,0.2,0,", ",3,0,-0.2,0,"]),
        ("heidenhain", ["Q214=+3", "Q214=+1", "Q214=+4", "Q214=+2"]),
    ] {
        let programs = ["+X", "-X", "+Y", "-Y"].map(|direction| written(name, direction));
        for (index, (program, _)) in programs.iter().enumerate() {
            assert!(program.contains(words[index]), "{name} {}\n{program}", words[index]);
            for (other, (_, config)) in programs.iter().enumerate() {
                let found = posting::findings::<SpinnerU5620>(config, by_name(name), CL, program);
                assert_eq!(found.is_empty(), index == other, "{name} {index} {other}: {found:?}");
            }
        }
    }
    // The program of Fanuc has no direction: the header states that of the parameter.
    let (program, _) = written("fanuc", "+Y");
    let note = "(FINE BORING, THE TOOL LEAVES THE WALL ALONG +Y BY 0.2 MM, PARAMETER 5148)\n(MUST BE +Y)\n";
    assert!(program.contains(note), "{program}");
}

#[test]
fn a_spindle_that_the_cycle_leaves_off_is_on_before_the_next_hole() {
    let (control, config) = (by_name("siemens"), config("siemens", &keys("+X")));
    let program = posted::<SpinnerU5620>(&config, control, CL);
    let after = program.split_once("X30\n").expect("the second bore").1;
    let (before, _) = after.split_once("CYCLE81").expect("the drilled hole");
    assert!(before.contains("S800 M3"), "{program}");
    let without = program.replace(after, &after.replacen("S800 M3\n", "", 1));
    let found = posting::findings::<SpinnerU5620>(&config, control, CL, &without);
    assert!(found.iter().any(|text| text.contains("switched the spindle off after the cycle")), "{found:?}");
}

#[test]
fn the_angle_of_the_spindle_is_that_of_the_cl_data() {
    let cl = CL.replace("ORIENT,0", "ORIENT,90");
    for (name, words) in [("siemens", ",0,90)"), ("heidenhain", "Q336=+90 ")] {
        let config = config(name, &keys("-X"));
        let program = posted::<SpinnerU5620>(&config, by_name(name), &cl);
        assert!(program.contains(words), "{name}\n{program}");
        assert!(!posting::findings::<SpinnerU5620>(&config, by_name(name), CL, &program).is_empty(), "{name}");
    }
}

#[test]
fn a_bore_that_the_control_cannot_make_so_is_refused() {
    let turned = CL.replace("ORIENT,0", "ORIENT,90");
    let shift = "mode = 'axes'\ncycles = { bore_retract = '-X', bore_shift = 0.5 }\n";
    let without = "mode = 'axes'\n";
    let expanded = "mode = 'axes'\ncycles = { bore_retract = '-X', output = 'expanded' }\n";
    for (name, keys, cl, expected) in [
        ("linuxcnc", keys("-X").as_str(), CL, "this control has no such cycle"),
        ("fanuc", without, CL, "the direction in which the tool leaves the wall of this bore is unknown"),
        (
            "fanuc",
            &keys("-X"),
            &turned,
            "the machine stops the spindle at its own angle, and the CL data asks for 90 degrees",
        ),
        ("haas", &keys("-X"), &turned, "the machine stops the spindle at its own angle"),
        ("heidenhain", shift, CL, "this control moves the tool off the wall by 0.2 mm, not by 0.5 mm"),
        ("siemens", expanded, CL, "only a cycle of the control bores with an oriented spindle"),
        ("siemens", &keys("-X").replace("axes", "plane"), CL, "it needs `mode = \"axes\"`"),
    ] {
        let (_, report) = written::<SpinnerU5620>(&config(name, keys), by_name(name), cl).expect("it can run");
        let told: Vec<&str> = report.diagnostics.iter().map(|found| found.text.as_str()).collect();
        assert!(report.failed && told.iter().any(|text| text.contains(expected)), "{name}: {told:?}");
    }
}
