//! Golden programs: short parts, posted for each machine that suits them and compared byte for byte.
//!
//! `PP_BLESS=1 cargo test --workspace --test commands golden::` rewrites the programs; read every changed line before
//! it is committed. The parts and their features:
//!
//! | part | holds |
//! |---|---|
//! | `two_tools` | tool change, STOP, one tilted plane per tool (3+2) |
//! | `blade` | NX; start at the pole, simultaneous motion, OPSTOP, the same tool called twice |
//! | `facets` | CATIA; rapids that index, STOP without a tool call after it, a tool that is used again |
//! | `rim` | Creo; the table rotates past 180° and 360° |
//! | `key_inch` | inch, a left-hand spindle, mist, a tool axis that is inclined in the YZ plane only |
//! | `coil` | four axes past a full revolution, a repeated point, a set-up with limits and parking |
//! | `pocket` | NX: circles in both senses, a helix, a curve, deep holes, GOHOME |
//! | `plate` | Creo in inches: circles, a list of points, GODLTA, chip breaking |
//! | `nest` | SolidWorks CAM: full circles, two CSYS, INSERT as a comment |
//! | `mixed` | a whole job in mode `auto`: two set-ups, vertical, tilted and simultaneous operations |
//! | `shop` | one set-up file for all controls: smoothing by operation, a round blank, settings that a control lacks |
//! | `passes` | mode `auto`: one-way passes, and links between them |
//! | `works`, `works_4axis` | arcs, a helix, 3+2, every cycle, simultaneous motion, a rewind, a thread, stops; in each mode |
//! | `pads` | a set-up with tool lengths, part origin, retract along the axis, limits, parking |

use std::fs;
use std::path::{Path, PathBuf};

use tests::binaries::{binary, golden_programs, workspace};
use tests::by_name;
use tests::environment;

/// CL file, configuration, machines; paths are relative to the workspace.
type Part = (&'static str, Option<&'static str>, &'static [&'static str]);

const FIVE_AXES: &[&str] = &["dmu-70e", "lola-xoyzba", "spinner-u5-620"];

const PARTS: &[Part] = &[
    ("examples/cl/two_tools.cls", Some("tests/data/two_tools/two_tools.toml"), FIVE_AXES),
    ("tests/data/blade/blade.cls", Some("tests/data/blade/blade.toml"), FIVE_AXES),
    ("tests/data/facets/facets.aptsource", Some("tests/data/facets/facets.toml"), FIVE_AXES),
    ("tests/data/rim/rim.ncl", Some("tests/data/rim/rim.toml"), FIVE_AXES),
    (
        "tests/data/key_inch/key_inch.cls",
        Some("tests/data/key_inch/key_inch.toml"),
        &["dmu-70e", "lola-xoyzba", "multiprodesk", "spinner-u5-620"],
    ),
    ("tests/data/coil/coil.cls", Some("tests/data/coil/coil.toml"), &["multiprodesk"]),
    ("tests/data/pocket/pocket.cls", Some("tests/data/pocket/pocket.toml"), FIVE_AXES),
    ("tests/data/plate/plate.ncl", Some("tests/data/plate/plate.toml"), FIVE_AXES),
    ("tests/data/nest/nest.apt", Some("tests/data/nest/nest.toml"), FIVE_AXES),
    ("tests/data/pads/pads.cls", Some("tests/data/pads/pads.toml"), FIVE_AXES),
];

/// Golden programs for the other controls: a table, a head, four axes, inches; the parts are those above. Heidenhain
/// and Haas have no code for the mist of `key_inch`. Heidenhain has no length registers and refuses the one of `pads`.
const OTHER_CONTROLS: &[(&str, &str, &[&str])] = &[
    ("examples/cl/two_tools.cls", "spinner-u5-620", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/blade/blade.cls", "spinner-u5-620", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/facets/facets.aptsource", "dmu-70e", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/rim/rim.ncl", "dmu-70e", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/key_inch/key_inch.cls", "lola-xoyzba", &["fanuc", "siemens"]),
    ("tests/data/plate/plate.ncl", "dmu-70e", &["heidenhain", "haas"]),
    ("tests/data/coil/coil.cls", "multiprodesk", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/pocket/pocket.cls", "spinner-u5-620", &["siemens", "heidenhain"]),
    ("tests/data/nest/nest.apt", "dmu-70e", &["fanuc", "siemens", "heidenhain", "haas"]),
    ("tests/data/pads/pads.cls", "lola-xoyzba", &["fanuc", "siemens", "haas"]),
];

/// The part with every feature, for every control in each of its modes: CL file, configuration, machine.
const WORKS: &[(&str, &str, &str)] = &[
    ("tests/data/works/works.cls", "tests/data/works/table.toml", "dmu-70e"),
    ("tests/data/works/works.cls", "tests/data/works/works.toml", "lola-xoyzba"),
    ("tests/data/works_4axis/works_4axis.cls", "tests/data/works_4axis/works_4axis.toml", "multiprodesk"),
    ("tests/data/works/works.cls", "tests/data/works/table.toml", "spinner-u5-620"),
];

/// A whole job: two set-ups, four tools, holes and threads, tilted faces with arcs and cutter compensation, a blade
/// with a rewind.
const MIXED: (&str, &str) = ("tests/data/mixed/mixed.cls", "tests/data/mixed/mixed.toml");

/// One-way passes with a rotating tool axis, linked as in the CL data.
const PASSES: (&str, &str) = ("tests/data/passes/passes.cls", "tests/data/passes/passes.toml");

/// One set-up file for all controls: smoothing by operation, a round blank, settings that a control lacks.
const SHOP: (&str, &str) = ("tests/data/shop/shop.cls", "tests/data/shop/shop.toml");

/// One golden program.
struct Golden {
    cl: &'static str,
    config: Option<&'static str>,
    machine: &'static str,
    control: &'static str,
    /// Mode, where it is not `axes`, and operations, if not all.
    mode: Option<(&'static str, &'static str)>,
}

impl Golden {
    /// `tests/data/<part>/<machine>.<control>.nc`, in a folder of the mode where that is not `axes`.
    fn path(&self) -> PathBuf {
        let part = Path::new(self.cl).file_stem().expect("a part has a name");
        let folder = workspace().join("tests/data").join(part);
        let folder = match self.mode {
            None | Some(("axes", _)) => folder,
            Some((mode, _)) => folder.join(mode),
        };
        folder.join(format!("{}.{}.nc", self.machine, self.control))
    }

    fn posted(&self) -> String {
        let mode = match self.mode {
            None => vec!["--mode", "axes"],
            Some((mode, "")) => vec!["--mode", mode],
            Some((mode, operations)) => vec!["--mode", mode, "--ops", operations],
        };
        posted_with(&mode, self.control, self.cl, self.config, self.machine)
    }
}

/// Every golden program.
fn goldens() -> Vec<Golden> {
    let linuxcnc = PARTS.iter().flat_map(|&(cl, config, machines)| {
        machines.iter().map(move |&machine| Golden { cl, config, machine, control: "linuxcnc", mode: None })
    });
    let others = OTHER_CONTROLS.iter().flat_map(|&(cl, machine, controls)| {
        let config = PARTS.iter().find(|part| part.0 == cl).expect("a part").1;
        controls.iter().map(move |&control| Golden { cl, config, machine, control, mode: None })
    });
    let works = WORKS.iter().flat_map(|&(cl, config, machine)| {
        by_name::works().map(move |(mode, control, operations)| Golden {
            cl,
            config: Some(config),
            machine,
            control,
            mode: Some((mode, operations)),
        })
    });
    let jobs = [MIXED, PASSES].into_iter().flat_map(|job| [(job, "spinner-u5-620"), (job, "dmu-70e")]);
    let jobs = jobs.chain([(SHOP, "spinner-u5-620")]);
    let auto = jobs.flat_map(|((cl, config), machine)| {
        let posted = move |control| Golden { cl, config: Some(config), machine, control, mode: Some(("auto", "")) };
        by_name::controls().map(posted)
    });
    linuxcnc.chain(others).chain(works).chain(auto).collect()
}

fn posted(cl: &str, config: Option<&str>, machine: &str) -> String {
    posted_with(&[], "linuxcnc", cl, config, machine)
}

fn posted_with(arguments: &[&str], control: &str, cl: &str, config: Option<&str>, machine: &str) -> String {
    let mut command = binary(machine);
    command.current_dir(workspace()).args(["post", cl, "--control", control]).args(arguments);
    if let Some(config) = config {
        command.args(["--config", config]);
    }
    let output = command.output().expect("the binary runs");
    assert!(output.status.success(), "{machine} {cl}:\n{}", String::from_utf8_lossy(&output.stderr));
    without_digest(&String::from_utf8(output.stdout).expect("a program is ASCII"))
}

/// A program with its line about the kinematics masked: it changes with the version.
fn without_digest(program: &str) -> String {
    let masked = |line: &str| match line.split_once("KINEMATICS ") {
        Some((before, after)) if after.to_lowercase().contains(" of pp-runtime ") => {
            let end = if after.trim_end().ends_with(')') { ")" } else { "" };
            format!("{before}KINEMATICS *{end}\n")
        }
        _ => line.to_owned(),
    };
    program.split_inclusive('\n').map(masked).collect()
}

/// First line in which two programs differ.
fn difference(golden: &str, now: &str) -> Option<String> {
    if golden == now {
        return None;
    }
    let line = golden.lines().zip(now.lines()).take_while(|(golden, now)| golden == now).count();
    let show = |text: &str| text.lines().nth(line).unwrap_or("nothing").to_owned();
    Some(format!("line {}: expected `{}`, found `{}`", line + 1, show(golden), show(now)))
}

#[test]
fn every_part_is_posted_as_before() {
    let bless = environment::blesses();
    let mut differences = Vec::new();
    for golden in goldens() {
        let (path, now) = (golden.path(), golden.posted());
        if bless {
            fs::create_dir_all(path.parent().expect("a folder")).expect("the folder of the part");
            fs::write(&path, &now).expect("the golden program is written");
        }
        let golden = fs::read_to_string(&path).unwrap_or_default();
        differences.extend(difference(&golden, &now).map(|what| format!("{}: {what}", path.display())));
    }
    assert!(differences.is_empty(), "read the changes, then PP_BLESS=1:\n{}", differences.join("\n"));
}

#[test]
fn every_golden_program_has_its_part() {
    let mut known: Vec<PathBuf> = goldens().iter().map(Golden::path).collect();
    known.sort();
    assert_eq!(golden_programs(), known);
}

#[test]
fn one_changed_byte_is_a_difference() {
    let now = posted("examples/cl/two_tools.cls", None, "spinner-u5-620");
    assert_eq!(difference(&now, &now), None);
    for index in [0, now.len() / 2, now.len() - 1] {
        let mut golden = now.clone().into_bytes();
        golden[index] ^= 1;
        let golden = String::from_utf8(golden).expect("still ASCII");
        assert!(difference(&golden, &now).is_some(), "byte {index}");
    }
}

/// The blocks of a program: comments, and guards of the work offset, are left out.
fn blocks(program: &str) -> Vec<&str> {
    program.lines().filter(|line| !line.starts_with('(') && !line.starts_with("o1000")).collect()
}

/// Compares blocks one by one; each expected block has its purpose.
fn assert_blocks(program: &str, expected: &[(&str, &str)]) {
    let blocks = blocks(program);
    for (index, (block, purpose)) in expected.iter().enumerate() {
        assert_eq!(blocks.get(index).copied(), Some(*block), "block {}: {purpose}", index + 1);
    }
    assert_eq!(blocks.len(), expected.len(), "{:?}", &blocks[expected.len().min(blocks.len())..]);
}

#[test]
fn on_a_table_the_safe_sequence_retracts_and_approaches_along_z() {
    assert_blocks(
        &posted("examples/cl/two_tools.cls", None, "spinner-u5-620"),
        &[
            ("N1 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01", "restart point: a complete state"),
            ("M9", "1: coolant off"),
            ("G53 G0 Z0", "2: the retract axis to its machine position"),
            ("T1 M6", "3: tool call"),
            ("G53 G0 Z0", "2: the change may have moved Z"),
            ("G43 H1", "3: length offset, in a block without motion"),
            ("S3000 M3", "3: spindle speed and direction"),
            ("G0 B30 C0", "4: the rotary axes alone"),
            ("X71.66 Y-28", "5: the other linear axes"),
            ("Z75.096", "6: the retract axis to the approach point, which is the first point"),
            ("M8", "7: coolant on"),
            ("G1 Z25.096 F1000", "along the tool axis into the cut, at feed"),
            ("X135.66 F900", "the face"),
            ("Y-14", "the face"),
            ("X71.66", "the face"),
            ("Y0", "the face"),
            ("X135.66", "the face"),
            ("Y14", "the face"),
            ("X71.66", "the face"),
            ("Y28", "the face"),
            ("X135.66", "the face"),
            ("G0 Z85.096", "the CL data retracts the tool along its axis"),
            ("M9", "COOLNT/OFF; SPINDL/OFF waits until the tool is out"),
            ("G53 G0 Z0", "the retract before STOP"),
            ("M5", "the spindle is off before STOP"),
            ("M0", "STOP"),
            ("N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01", "restart point: a complete state"),
            ("M9", "1: the operator may have switched the coolant on"),
            ("G53 G0 Z0", "2: the position of Z after the stop is unknown"),
            ("T2 M6", "3: tool call"),
            ("G53 G0 Z0", "2: the change may have moved Z"),
            ("G43 H2", "3: length offset"),
            ("S7000 M3", "3: spindle"),
            ("G0 B20 C-90", "4: the rotary axes alone"),
            ("X70.097 Y-30", "5: the other linear axes"),
            ("Z65.886", "6: the approach point"),
            ("M8", "7: coolant on"),
            ("G1 Z15.887 F500", "into the cut"),
            ("Y-10 Z14.887 F350", "the slot"),
            ("Y-30 Z13.887", "the slot"),
            ("Y-10 Z12.886", "the slot"),
            ("Y-30 Z11.886", "the slot"),
            ("Y-10", "the slot"),
            ("Y-30", "the slot"),
            ("G0 Z71.887", "the CL data retracts the tool along its axis"),
            ("M9", "COOLNT/OFF; SPINDL/OFF waits until the tool is out"),
            ("G53 G0 Z0", "program end: retract"),
            ("M5", "program end: spindle off"),
            ("M2", "end code"),
        ],
    );
}

#[test]
fn with_a_rotary_in_the_head_the_safe_sequence_retracts_and_approaches_along_the_tool_axis() {
    let program = posted("examples/cl/two_tools.cls", None, "lola-xoyzba");
    let blocks = blocks(&program);
    let first: Vec<&str> = blocks[9..15].to_vec();
    assert_eq!(
        first,
        [
            "G0 A0 B30",                 // 4: the rotary axes alone
            "X84.608 Y-28",              // 5: the other linear axes, to above the approach point
            "Z33.224",                   // 6: the retract axis to the approach point
            "M8",                        // 7: coolant on
            "G1 X59.608 Z-10.077 F1000", // 8: along the tool axis, 50 mm at 30°: 25 in X, 43.301 in Z
            "X115.033 Z-42.077 F900",    // the face
        ]
    );
}

#[test]
fn with_a_retract_distance_the_tool_retracts_along_its_axis_before_the_machine_retract() {
    let program = posted("tests/data/pads/pads.cls", Some("tests/data/pads/pads.toml"), "lola-xoyzba");
    let blocks = blocks(&program);
    let index = blocks.iter().position(|block| *block == "X22.138 Y-61.224 Z-7.05").expect("the last cut");
    assert_eq!(
        blocks[index + 1..index + 10],
        [
            "M9",                          // 1: coolant off
            "G0 X24.942 Y-84.731 Z64.116", // 2: 75 mm along the tool axis
            "G53 G0 Z0",                   // 2: the retract axis
            "G0 A35.8066 B4.9348",         // 4: the rotary axes alone; the operation goes on
            "X10.74 Y-121.986",            // 5: the other linear axes
            "Z-5.421",                     // 6: 30 mm above the first point; the next is not below it
            "M8",                          // 7: coolant on
            "X8.647 Y-104.434 Z-29.661",   // 8: along the tool axis, at rapid as the CL data has it
            "G1 X14.559 Y-101.652 Z-32.489 F300",
        ]
    );
}

#[test]
fn an_operation_that_begins_at_feed_is_entered_at_feed() {
    let program = posted("tests/data/pads/pads.cls", Some("tests/data/pads/pads.toml"), "spinner-u5-620");
    let blocks = blocks(&program);
    let index = blocks.iter().position(|block| block.starts_with("N2 ")).expect("the second operation");
    assert_eq!(
        blocks[index + 1..index + 13],
        [
            "M9",        // 1: a restart here has an unknown coolant state
            "G53 G0 Z0", // 2
            "M5",        // 3: the spindle stops before the tool call
            "T22 M6",
            "G53 G0 Z0",        // 2: the change may have moved Z
            "G43 H52",          // 3: the length register of the configuration
            "S6100 M3",         // 3: spindle
            "G0 B15.7 C-262.4", // 4: half a revolution, in the shorter sense
            "X34.499 Y-2.406",  // 5
            "Z35.52",           // 6: 30 mm above the first point
            "M8",               // 7
            "G1 Z5.52 F300",    // 8: the first point, at feed
        ]
    );
}

#[test]
fn the_same_tool_is_not_changed_and_a_comment_has_its_number() {
    let program = posted("tests/data/blade/blade.cls", None, "spinner-u5-620");
    let lines: Vec<&str> = program.lines().collect();
    let index = lines.iter().position(|line| *line == "M1").expect("OPSTOP");
    assert_eq!(
        lines[index + 1..index + 12],
        [
            "(OPERATION TRAILING_EDGE)",
            "N2 G21 G8 G17 G40 G49 G80 G90 G91.1 G94 G97 G54 G64 P0.01",
            "o1000002 if [[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]",
            "(abort, G92, G52 or a rotation lies over the work offset: G92.2, G10 L2 R0)",
            "o1000002 endif",
            "M9",
            "G53 G0 Z0",
            "(T3 stays in the spindle)",
            "G43 H3",
            "S7600 M3",
            "G0 B22.3 C231.3",
        ]
    );
}
