//! Holes of one cycle along different tool axes: the safe sequence leads from hole to hole, ends above the hole with the
//! coolant on, and every hole has its levels along its own axis.

use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, post};
use tests::posting::findings;

const CONTROLS: [&str; 5] = ["linuxcnc", "fanuc", "siemens", "heidenhain", "haas"];

/// Four directions, and a second hole on the third of them. `level`: words for the return level.
fn around(level: &str) -> String {
    format!(
        "UNITS/MM
TOOL PATH/RADIAL,TOOL,D8
MSYS/0,0,0,1,0,0,0,1,0
LOADTL/1,ADJUST,1
SPINDL/RPM,3000,CLW
COOLNT/ON
RAPID
GOTO/70,0,-20,1,0,0
CYCLE/DRILL,RAPTO,3,FEDTO,-12{level},MMPM,200
GOTO/40,0,-20,1,0,0
GOTO/0,40,-20,0,1,0
GOTO/-40,0,-20,-1,0,0
GOTO/-40,0,-30,-1,0,0
GOTO/0,-40,-20,0,-1,0
CYCLE/OFF
RAPID
GOTO/0,-100,-20,0,-1,0
END-OF-PATH
FINI
"
    )
}

fn config<M: Machine>(control: &'static dyn Control, mode: &str, approach_mm: f64) -> Config {
    let text = format!(
        "mode = '{mode}'
tcp_confirmed = true
tcp_frame = 'table_at_zero'
part_origin = [0.0, 0.0, 150.0]
[approach]
distance = {approach_mm:?}
[tools]
1 = {{ length = 120.0 }}
"
    );
    let text = if control.spellings().name == "fanuc" { text } else { text.replace("tcp_frame", "# tcp_frame") };
    starting_point(control).read_over(&M::default(), &text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

fn posted<M: Machine>(config: &Config, control: &'static dyn Control, cl: &str) -> String {
    let job = Job { cl_name: "radial.cls", config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program).expect("it can run");
    let error = report.diagnostics.into_iter().find(|found| found.severity == Severity::Error);
    assert!(error.is_none(), "{}: {error:?}", control.spellings().name);
    String::from_utf8(program).expect("ASCII")
}

/// The blocks between two rotations of the table.
fn blocks_of_second_hole(level: &str, approach_mm: f64) -> Vec<String> {
    let control = control::by_name("fanuc").expect("it is there");
    let config = config::<SpinnerU5620>(control, "axes", approach_mm);
    let program = posted::<SpinnerU5620>(&config, control, &around(level));
    let from_second = program.lines().skip_while(|line| *line != "G0 C90.");
    from_second.take_while(|line| *line != "G0 C180.").map(str::to_owned).collect()
}

fn assert_every_control_and_mode<M: Machine>() {
    for name in CONTROLS {
        let control = control::by_name(name).expect("it is there");
        // LinuxCNC has no planes, and tip control only by codes of its own.
        let modes: &[&str] = if name == "linuxcnc" { &["axes", "auto"] } else { &["axes", "plane", "tcp", "auto"] };
        for (mode, level) in modes.iter().flat_map(|mode| ["", ",RTRCTO,15", ",RTRCTO,AUTO"].map(|level| (mode, level)))
        {
            let cl = around(level);
            let config = config::<M>(control, mode, 50.0);
            let program = posted::<M>(&config, control, &cl);
            let found = findings::<M>(&config, control, &cl, &program);
            assert!(found.is_empty(), "{} {name} {mode}{level}: {found:?}\n{program}", M::NAME);
        }
    }
}

#[test]
fn radial_holes_post_and_pass_their_check_on_every_control_in_every_mode() {
    assert_every_control_and_mode::<SpinnerU5620>();
    assert_every_control_and_mode::<Dmu70e>();
    assert_every_control_and_mode::<LolaXoyzba>();
}

#[test]
fn the_tool_comes_to_the_return_level_once_with_the_coolant_on() {
    assert_eq!(
        blocks_of_second_hole(",RTRCTO,AUTO", 50.0),
        [
            "G0 C90.",
            "G43 H1 Z93.", // 50 mm above the clearance level
            "M8",
            "Z70.",                             // the return level
            "G98 G81 X20. Y0. Z28. R43. F200.", // 12 mm deep, from 3 mm above
            "G80",
            "M9",
            "G49 G53 G0 Z0.",
        ]
    );
}

#[test]
fn a_return_level_above_the_approach_distance_is_where_the_approach_ends() {
    let blocks = blocks_of_second_hole(",RTRCTO,AUTO", 20.0);
    assert_eq!(blocks[1..4], ["G43 H1 Z70.", "M8", "G98 G81 X20. Y0. Z28. R43. F200."]);
}

#[test]
fn an_approach_to_a_hole_that_returns_to_its_clearance_level_keeps_the_approach_distance() {
    let blocks = blocks_of_second_hole("", 20.0);
    assert_eq!(blocks[1..4], ["G43 H1 Z63.", "M8", "G99 G81 X20. Y0. Z28. R43. F200."]);
}

#[test]
fn an_approach_down_to_the_clearance_level_is_found() {
    let control = control::by_name("fanuc").expect("it is there");
    let (config, cl) = (config::<SpinnerU5620>(control, "axes", 50.0), around(",RTRCTO,AUTO"));
    let program = posted::<SpinnerU5620>(&config, control, &cl);
    for wrong in ["G43 H1 Z43.", "G43 H1 Z70.", "G43 H1 Z92."] {
        let found = findings::<SpinnerU5620>(&config, control, &cl, &program.replacen("G43 H1 Z93.", wrong, 1));
        assert!(found.iter().any(|text| text.starts_with("the approach ends")), "{wrong}: {found:?}");
    }
}

#[test]
fn an_operation_that_begins_with_a_hole_comes_to_it_in_the_same_way() {
    let control = control::by_name("fanuc").expect("it is there");
    let cl = around(",RTRCTO,15").replace("RAPID\nGOTO/70,0,-20,1,0,0\n", "");
    let config = config::<SpinnerU5620>(control, "axes", 20.0);
    let program = posted::<SpinnerU5620>(&config, control, &cl);
    let blocks: Vec<&str> = program.lines().skip_while(|line| !line.starts_with("G43")).take(4).collect();
    assert_eq!(blocks, ["G43 H1 Z63.", "M8", "Z55.", "G98 G81 X20. Y0. Z28. R43. F200."]);
    assert_eq!(findings::<SpinnerU5620>(&config, control, &cl, &program), Vec::<String>::new());
}
