//! Machine retracts of each control (`retract.method`) and home positions before the rotary axes rotate: their blocks, and a
//! check that finds them lost or changed.

use machines::{LolaXoyzba, SpinnerU5620};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::{self, Control};
use pp_runtime::kinematics::Machine;
use tests::posting::{self, bare, renumbered, without, written};

/// A tilted face, and another one with the same tool.
const CL: &str = "UNITS/MM
TOOL PATH/OP10,TOOL,T
LOADTL/1,LENGTH,100
SPINDL/RPM,2000,CLW
RAPID
GOTO/0,0,30,0.5,0,0.8660254
FEDRAT/MMPM,300
GOTO/0,0,20
GOTO/0,20,20
RAPID
GOTO/0,20,60
TOOL PATH/OP20,TOOL,T
RAPID
GOTO/5,0,30,0,0,1
GOTO/5,0,20
FEDRAT/MMPM,300
GOTO/5,20,20
RAPID
GOTO/5,20,60
FINI
";

fn config<M: Machine>(control: &dyn Control, keys: &str) -> Result<Config, String> {
    let mode = if keys.contains("mode") { "" } else { "mode = 'axes'\n" };
    let text = format!("part_origin = [0.0, 0.0, 0.0]\n{mode}{keys}");
    starting_point(control).read_over(&M::default(), &text).map_err(|faults| format!("{text}: {faults:?}"))
}

/// The program, or why there is none.
fn posted<M: Machine>(control: &'static dyn Control, keys: &str) -> Result<String, String> {
    let config = config::<M>(control, keys)?;
    let (program, report) = written::<M>(&config, control, CL).map_err(|error| error.to_string())?;
    if report.failed {
        return Err(report.diagnostics.iter().map(|found| format!("{}; {:?}\n", found.text, found.help)).collect());
    }
    let found = findings::<M>(control, keys, &program);
    assert!(found.is_empty(), "{keys}\n{program}\n{found:?}");
    Ok(program)
}

fn findings<M: Machine>(control: &'static dyn Control, keys: &str, program: &str) -> Vec<String> {
    posting::findings::<M>(&config::<M>(control, keys).expect("it was read"), control, CL, program)
}

fn by_name(name: &str) -> &'static dyn Control {
    control::by_name(name).expect("a control")
}

/// Control, its name of a retract, the blocks of it, and blocks in the place of the first that are another motion.
const METHODS: &[(&str, &str, &[&str], &[&str])] = &[
    ("linuxcnc", "G53", &["G53 G0 Z0"], &["G53 G0 Z-10", "G91 G28 Z0", "G53 G0 X0 Z0"]),
    ("linuxcnc", "G91 G28", &["G91 G28 Z0", "G90"], &["G90 G28 Z0", "G91 G28 Z1", "G91 G28 X0 Z0", "G91 G30 X0"]),
    ("fanuc", "G91 G28", &["G91 G28 Z0.", "G90"], &["G90 G28 Z0.", "G91 G28 Z1.", "G91 G28", "G53 G0 Z0."]),
    ("haas", "G91 G28", &["G91 G28 Z0.", "G90"], &["G90 G28 Z0.", "G91 G28 Z1.", "G91 G28", "G53 G00 Z0."]),
    ("siemens", "SUPA", &["SUPA G0 Z0 D0"], &["SUPA G0 Z-10 D0"]),
    ("heidenhain", "M91", &["L Z+0 R0 FMAX M91"], &["L Z-10 R0 FMAX M91", "L M140 MB MAX"]),
    ("heidenhain", "M140", &["L M140 MB MAX"], &["L M140 MB 50", "L M140 MB", "L X+0 M140 MB MAX"]),
];

/// Keys of the modes that a control has without kinematics of its own set-up.
fn modes(control: &str) -> &'static [&'static str] {
    match control {
        "linuxcnc" => &["mode = 'axes'"],
        "fanuc" => &["mode = 'axes'", "mode = 'plane'", "mode = 'tcp'\ntcp_frame = 'table_at_start'"],
        _ => &["mode = 'axes'", "mode = 'plane'", "mode = 'tcp'"],
    }
}

#[test]
fn each_control_retracts_by_the_codes_that_it_has() {
    for &(name, method, blocks, others) in METHODS {
        let control = by_name(name);
        for mode in modes(name) {
            let keys = format!("{mode}\n[retract]\ndistance = 50.0\nmethod = '{method}'\n");
            let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
            let lines = bare(&program);
            let retracts = lines.windows(blocks.len()).filter(|lines| lines == &blocks).count();
            // Tip control of Fanuc and Haas is left by G53.
            let least = if mode.contains("tcp") { 1 } else { 3 };
            assert!(retracts >= least, "{name} {method}\n{program}");
            for other in others {
                let at = lines.iter().rposition(|line| line == &blocks[0]).expect("the retract at the end");
                let mut edited = lines.clone();
                edited[at] = other;
                let found = findings::<SpinnerU5620>(control, &keys, &renumbered(control, &edited));
                assert!(!found.is_empty(), "{name} {method} {mode}: {other}\n{program}");
            }
        }
    }
}

#[test]
fn a_lost_retract_is_found() {
    for &(name, method, blocks, _) in METHODS {
        let control = by_name(name);
        let keys = format!("[retract]\nmethod = '{method}'\n");
        let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
        let mut shorter = without(&program, control, |rest| rest[0] == blocks[0]);
        // Up to the next motion of this kind another G90 may come.
        let moves = |line: &str| line.starts_with("G0 ") || line.starts_with("G00 ");
        shorter.extend(without(&program, control, |rest| {
            rest[0] == "G90"
                && rest.iter().find(|line| moves(line) || line.starts_with("G91")).is_some_and(|line| moves(line))
        }));
        assert!(shorter.len() >= 3, "{name} {method}");
        for edited in shorter {
            assert!(!findings::<SpinnerU5620>(control, &keys, &edited).is_empty(), "{name} {method}\n{edited}");
        }
    }
}

#[test]
fn what_a_control_does_not_have_is_refused_with_the_names_of_what_it_has() {
    for (name, method, expected) in [
        (
            "siemens",
            "G53",
            "Siemens 840D has no machine retract `G53`: `retract.method` may be \"SUPA\", or a list of blocks",
        ),
        (
            "heidenhain",
            "G91 G28",
            "has no machine retract `G91 G28`: `retract.method` may be \"M91\", \"M140\", or a list of blocks",
        ),
        (
            "fanuc",
            "M140",
            "Fanuc has no machine retract `M140`: `retract.method` may be \"G53\", \"G91 G28\", or a list of blocks",
        ),
        ("haas", "G28", "in absolute mode G28 leads through the point of its words"),
        ("linuxcnc", "clearance", "a nearer `retract.position` shortens the retract"),
    ] {
        let control = by_name(name);
        let config =
            config::<SpinnerU5620>(control, &format!("[retract]\nmethod = '{method}'\n")).expect("it can be read");
        let unfit = control::unfit(&SpinnerU5620::default(), control, config.demands()).join("\n");
        assert!(unfit.contains(expected), "{name} {method}: {unfit}");
    }
    let keys = "[retract]\nmethod = 'M140'\ndistance = 50.0\n";
    let refused = posted::<LolaXoyzba>(by_name("heidenhain"), keys).expect_err("the head tilts the tool");
    assert!(refused.contains("leads along the tool axis (M140)"), "{refused}");
}

#[test]
fn tip_control_ends_in_machine_coordinates_where_it_ends_with_the_length_offset() {
    let keys = "mode = 'tcp'\nTCP[retract]\nmethod = 'G91 G28'\ndistance = 40.0\n";
    for (name, first) in [("fanuc", "G49 G53 G0 Z0."), ("haas", "G49 G53 G00 Z0.")] {
        let control = by_name(name);
        let keys = keys.replace("TCP", if name == "fanuc" { "tcp_frame = 'table_at_zero'\n" } else { "" });
        let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
        let lines = bare(&program);
        assert_eq!(lines.iter().filter(|line| **line == first).count(), 2, "{program}");
        assert_eq!(lines.iter().filter(|line| **line == "G91 G28 Z0.").count(), 3, "{program}");
        for at in (0..lines.len()).filter(|&at| lines[at] == first) {
            let mut edited = lines.clone();
            edited[at] = "G91 G28 Z0.";
            edited.insert(at + 1, "G90");
            assert!(!findings::<SpinnerU5620>(control, &keys, &renumbered(control, &edited)).is_empty(), "{edited:?}");
        }
    }
}

#[test]
fn blocks_of_the_shop_take_the_place_of_the_retract() {
    for (name, blocks, effects) in [
        ("linuxcnc", ["G91 G30 Z0", "G90"], ""),
        ("fanuc", ["G91 G30 Z0.", "G90"], ""),
        ("haas", ["M98 P9810", "M31"], "effects = { 'M98 P9810' = 'position lost', 'M31' = 'none' }\n"),
        ("siemens", ["G75 FP=1 Z1=0", "M77"], "effects = { 'G75 FP=1 Z1=0' = 'position lost', 'M77' = 'none' }\n"),
        (
            "heidenhain",
            ["CALL PGM TNC:\\\\HOME.H", "M77"],
            "effects = { 'CALL PGM TNC:\\\\HOME.H' = 'position lost', 'M77' = 'none' }\n",
        ),
    ] {
        let control = by_name(name);
        let effects = effects.replace('\'', "\"");
        let keys = format!("[retract]\nmethod = [\"{}\", \"{}\"]\n[control]\n{effects}", blocks[0], blocks[1]);
        let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
        let blocks = blocks.map(|block| block.replace("\\\\", "\\"));
        let lines = bare(&program);
        let pairs = lines.windows(2).filter(|pair| pair[0] == blocks[0] && pair[1] == blocks[1]).count();
        assert!(pairs >= 3, "{program}");
        for block in &blocks {
            for edited in without(&program, control, |rest| rest[0] == block) {
                assert!(!findings::<SpinnerU5620>(control, &keys, &edited).is_empty(), "{block}\n{edited}");
            }
        }
        let found = findings::<SpinnerU5620>(control, &keys.replace("method", "#"), &program);
        assert!(!found.is_empty(), "{name}: without the key these blocks are no retract\n{program}");
    }
    let twice = "[retract]\nmethod = ['G90', 'G90']\n";
    let config = config::<SpinnerU5620>(by_name("fanuc"), twice).expect("it can be read");
    let unfit = control::unfit(&SpinnerU5620::default(), by_name("fanuc"), config.demands()).join("\n");
    assert!(unfit.contains("`retract.method` has the block `G90` twice"), "{unfit}");
}

/// Control, retract, and the block of the home positions.
const HOMES: &[(&str, &str, &str)] = &[
    ("linuxcnc", "G53", "G53 G0 X-200 Y0"),
    ("linuxcnc", "G91 G28", "G91 G28 X0 Y0"),
    ("fanuc", "G53", "G53 G0 X-200. Y0."),
    ("fanuc", "G91 G28", "G91 G28 X0. Y0."),
    ("haas", "G53", "G53 G00 X-200. Y0."),
    ("siemens", "SUPA", "SUPA G0 X-200 Y0 D0"),
    ("heidenhain", "M91", "L X-200 Y+0 R0 FMAX M91"),
    ("heidenhain", "M140", "L X-200 Y+0 R0 FMAX M91"),
];

#[test]
fn x_and_y_go_home_before_the_rotary_axes_rotate() {
    for &(name, method, block) in HOMES {
        let control = by_name(name);
        let keys = format!("[retract]\nmethod = '{method}'\nhome_on_indexing = true\nxy = {{ X = -200.0 }}\n");
        let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
        let lines = bare(&program);
        let homes: Vec<usize> = (0..lines.len()).filter(|&at| lines[at] == block).collect();
        // Each operation rotates the table.
        assert_eq!(homes.len(), 2, "{name}\n{program}");
        for at in homes {
            let rotates = |line: &&&str| line.contains('B') && line.contains('C') && !line.contains(['(', ';']);
            let next = lines[at + 1..].iter().find(|line| rotates(line) || line.contains('X')).expect("a motion");
            assert!(rotates(&next), "{name}: {next}\n{program}");
            let mut shifted = lines.clone();
            let other = block.replace("X0", "X1").replace("X-200", "X-190");
            shifted[at] = &other;
            let lost = [&lines[..at], &lines[at + 1..]].concat();
            for edited in [shifted, lost] {
                let found = findings::<SpinnerU5620>(control, &keys, &renumbered(control, &edited));
                assert!(!found.is_empty(), "{name} {method}\n{edited:#?}");
            }
        }
        let plain = keys.replace("home_on_indexing = true", "home_on_indexing = false");
        assert!(!findings::<SpinnerU5620>(control, &plain, &program).is_empty(), "{name} {method}\n{program}");
    }
}

#[test]
fn x_and_y_stay_where_the_rotary_axes_do() {
    let keys = "[retract]\nhome_on_indexing = true\n";
    let control = by_name("fanuc");
    let cl = CL.replace("GOTO/5,0,30,0,0,1", "GOTO/5,0,40,0.5,0,0.8660254");
    let config = config::<SpinnerU5620>(control, keys).expect("it can be read");
    let program = posting::posted::<SpinnerU5620>(&config, control, &cl);
    assert_eq!(bare(&program).iter().filter(|line| **line == "G53 G0 X0. Y0.").count(), 1, "{program}");
}

#[test]
fn tip_control_of_the_shop_is_off_before_the_first_retract() {
    let control = by_name("linuxcnc");
    let own = "safety = ['{units} G17 G40 G49 G80 G90 G94 {work_offset} G64 P{path_tolerance}']";
    for safety in ["", own] {
        let keys =
            format!("mode = 'tcp'\n[retract]\ndistance = 50.0\n[control]\ntip_control = ['M428', 'M429']\n{safety}\n");
        let program = posted::<SpinnerU5620>(control, &keys).expect("posted");
        let lines = bare(&program);
        let off = lines.iter().position(|line| *line == "M429").expect("off");
        let retract = lines.iter().position(|line| *line == "G53 G0 Z0").expect("retract");
        assert!(off < retract, "{program}");
        let without = renumbered(control, &[&lines[..off], &lines[off + 1..]].concat());
        let after = [&lines[..off], &lines[off + 1..=retract], &["M429"], &lines[retract + 1..]].concat();
        assert!(!findings::<SpinnerU5620>(control, &keys, &without).is_empty(), "{without}");
        // Own safety lines have no mark of a restart point.
        if safety.is_empty() {
            assert!(!findings::<SpinnerU5620>(control, &keys, &renumbered(control, &after)).is_empty(), "{program}");
        }
    }
}
