//! A setting fills what the CL data leaves out, and never replaces what it states: every key of the configuration is in
//! a list here.

use machines::SpinnerU5620;
use pp_runtime::cli::{self, Status, Streams};
use pp_runtime::config::starting_point;
use pp_runtime::diag::Severity;
use pp_runtime::post::PostError;
use serde_json::Value;
use tests::by_name;
use tests::posting::written;

/// Keys about which CL data states nothing: machine, control, shop, format of the program, or how it is planned.
/// `group.` is all keys of a table.
const NOT_STATED: &[&str] = &[
    // Machine, clamping and shop.
    "clamp.",
    "dimensions.",
    "floor",
    "grid.",
    "index_angle",
    "limits.",
    "machine_zero.",
    "park.",
    "part_origin",
    "part_rotation",
    "program_zero",
    "reorient_speed",
    "rotary_offset.",
    "set_ups",
    "solids.",
    "speeds.",
    "spindle_dwell",
    "spindle_max",
    "start_position.",
    "stock.",
    "table_check",
    "table_zero.",
    "work_offset",
    "wrap.",
    "length_mode",
    "length_tolerance",
    // Control and format.
    "control.",
    "formats.",
    "program.",
    "output_units",
    "units",
    "tcp_confirmed",
    "tcp_frame",
    "tcp_words",
    "plane_guard",
    "offset_guard",
    "mode",
    "auto_planes",
    "cycles.output",
    "cycles.probe",
    "cycles.check_tool",
    "cycles.measure_tool",
    "cycles.rigid",
    "cycles.thread_feed",
    "cycles.tool_position.",
    "cycles.bore_retract",
    "cycles.bore_shift",
    "compensation.largest_wear",
    // Planning.
    "approach.",
    "arcs.",
    "axis_tolerance_path",
    "course.",
    "links",
    "operations",
    "optional_stops",
    "path_tolerance",
    "rapid",
    "rapid_feed",
    "retract.",
    "singular",
    "stop_retract",
    "tolerance",
    "tool_posture",
    "transition",
    "feed.",
    "coolant.through_dwell",
    // Edits that are meant: of a program, not of CL data.
    "check.edits",
    "check.feed_factor",
    "check.speed_factor",
    // Whether and how records are carried out that have no effect of their own.
    "cl.allow_lintol",
    "cl.auxfun",
    "cl.columns",
    "cl.dialect",
    "cl.from",
    "cl.insert",
    "cl.insert_stop",
    "cl.prefun",
    "cl.trans",
    "cl_point",
    "cl.feed_label",
];

/// A setting against CL data that states something else.
struct Case {
    key: &'static str,
    config: &'static str,
    /// Records of the CL data, for which the setting is refused with this text, or which hold: their words are in the
    /// program.
    states: &'static str,
    then: Then,
}

enum Then {
    Refused(&'static str),
    Holds(&'static str),
}

use Then::{Holds, Refused};

const CASES: &[Case] = &[
    Case {
        key: "cl_units",
        config: "cl_units = 'in'",
        states: "CUT",
        then: Refused("contradicts `--units` or `cl_units`"),
    },
    Case {
        key: "cl.frames",
        config: "cl.frames = 'first'",
        states: "MSYS/0,0,0,1,0,0,0,1,0\nCUT\nMSYS/0,0,0,0,0,-1,0,1,0\nRAPID\nGOTO/0,0,60,0,0,1\n",
        then: Refused("is contradicted by the tool axis"),
    },
    Case {
        key: "cl.circle_sense",
        config: "cl.circle_sense = 'cw'",
        states: "RAPID\nGOTO/0,0,50\nGOTO/0,0,5\nGOTO/10,0,5\nCIRCLE/10,10,5,0,0,1,10\nGOTO/20,10,5\nGOTO/20,20,5\n",
        then: Refused("contradict the sense that `--circle-sense` gives"),
    },
    Case {
        key: "cl.inert",
        config: "cl.inert = ['COOLNT']",
        states: "CUT",
        then: Refused("COOLNT is read, so it cannot be inert"),
    },
    Case { key: "cl.words", config: "cl.words = { \"COOLNT/ON\" = \"M8\" }", states: "CUT", then: Refused("COOLNT") },
    Case {
        key: "cl.loadtl.args",
        config: "cl.loadtl.args = ['length']",
        states: "LOADTL/2,100,LENGTH,120\nCUT",
        then: Refused("the gauge length of tool 2 is stated twice"),
    },
    Case { key: "defaults.feed", config: "defaults.feed = 77.0", states: "CUT", then: Holds("F500") },
    Case { key: "defaults.speed", config: "defaults.speed = 77.0", states: "CUT", then: Holds("S3000") },
    Case { key: "defaults.direction", config: "defaults.direction = 'CCLW'", states: "CUT", then: Holds("M3") },
    Case { key: "defaults.tool", config: "defaults.tool = 77", states: "CUT", then: Holds("T1") },
    Case {
        key: "defaults.coolant",
        config: "defaults.coolant = 'mist'",
        states: "COOLNT/FLOOD\nCUT",
        then: Holds("M8"),
    },
    Case {
        key: "defaults.peck_gap",
        config: "defaults.peck_gap = 0.3\ncl.dialect = 'iso'\ncycles.output = 'expanded'",
        states: "CUT\nCYCLE/BRKCHP,DEPTH,10,STEP,5,MMPM,100,CLEAR,2,BACK,1.5\nGOTO/0,0,0\nCYCLE/OFF\n",
        then: Holds("Z-3.5"),
    },
    Case {
        key: "compensation.path",
        config: "compensation.path = 'contour'",
        states: "$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER\nCUT",
        then: Refused("the path with CUTCOM is that of the centre by this record"),
    },
    Case {
        key: "length_guard",
        config: "length_guard = true",
        states: "LOADTL/2,LENGTH,120,ADJUST,7\nCUT",
        then: Refused("no block of this control compares the length of T2"),
    },
    Case { key: "tools", config: "tools.1.diameter = 12.0", states: "CUT", then: Refused("12 mm in `[tools.1]`") },
    Case { key: "tools", config: "tools.1.corner_radius = 2.0", states: "CUT", then: Refused("2 mm in `[tools.1]`") },
    Case { key: "tools", config: "tools.1.length = 90.0", states: "CUT", then: Refused("90 mm in `[tools.1]`") },
    Case {
        key: "tools",
        config: "tools.2.offset = 9",
        states: "LOADTL/2,ADJUST,7\nCUT",
        then: Refused("9 in `[tools.2]`"),
    },
    Case { key: "tools", config: "tools.1.speed = 77.0", states: "CUT", then: Holds("S3000") },
    Case { key: "tools", config: "tools.1.direction = 'CCLW'", states: "CUT", then: Holds("M3") },
    Case { key: "tools", config: "tools.1.coolant = 'mist'", states: "COOLNT/FLOOD\nCUT", then: Holds("M8") },
    Case {
        key: "cl.cycle.",
        config: "cl.dialect = 'iso'\ncl.cycle.DRILL.args = ['clearance']",
        states: "CYCLES",
        then: Refused("the clearance of this cycle is stated twice"),
    },
];

/// A cut that states everything.
const CUT: &str = "COOLNT/FLOOD\nRAPID\nGOTO/0,0,50\nGOTO/0,0,5\nGOTO/20,0,5\nRAPID\nGOTO/20,0,60\n";

/// A cycle with a number without a word beside its words.
const CYCLES: &str = "RAPID\nGOTO/0,0,50\nCYCLE/DRILL,DEPTH,10,MMPM,100,CLEAR,2,3\nGOTO/0,0,0\nCYCLE/OFF\n";

fn cl(case: &Case) -> String {
    let head = "UNITS/MM\nCUTTER/10,1\nLOADTL/1,LENGTH,100\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n";
    let record = |line: &str| match line {
        "CUT" => CUT.to_owned(),
        "CYCLES" => CYCLES.to_owned(),
        other => format!("{other}\n"),
    };
    format!("{head}{}FINI\n", case.states.lines().map(record).collect::<String>())
}

/// The program, or why there is none.
fn outcome(config: &str, cl: &str) -> Result<String, String> {
    let control = by_name::control("linuxcnc");
    let machine = SpinnerU5620::default();
    let text = format!("{config}\nmode = 'axes'\npart_origin = [0.0, 0.0, 60.0]\n");
    let config = starting_point(control).read_over(&machine, &text);
    let config =
        config.map_err(|faults| faults.iter().map(|fault| fault.text.clone()).collect::<Vec<_>>().join("\n"))?;
    match written::<SpinnerU5620>(&config, control, cl) {
        Ok((program, report)) if !report.failed => Ok(program),
        Ok((_, report)) => {
            let errors = report.diagnostics.iter().filter(|found| found.severity == Severity::Error);
            Err(errors.map(|error| error.text.clone()).collect::<Vec<_>>().join("\n"))
        }
        Err(PostError::Unfit(why)) => Err(why),
        Err(other) => Err(other.to_string()),
    }
}

#[test]
fn a_setting_never_replaces_what_the_cl_data_states() {
    for case in CASES {
        let Case { key, config, then, .. } = case;
        match (outcome(config, &cl(case)), then) {
            (Err(why), Refused(text)) => assert!(why.contains(text), "{key}, `{config}`: {why}"),
            (Ok(program), Holds(words)) => {
                let holds = program.lines().any(|line| line.split(' ').any(|word| word == *words));
                assert!(holds, "{key}, `{config}`: no {words} in\n{program}");
            }
            (Ok(program), Refused(text)) => panic!("{key}, `{config}`: not refused ({text})\n{program}"),
            (Err(why), Holds(_)) => panic!("{key}, `{config}`: {why}"),
        }
    }
}

/// Keys of the schema, those of a table by number as one.
pub(crate) fn keys_of_schema(path: &str, schema: &Value, found: &mut Vec<String>) {
    let Some(properties) = schema["properties"].as_object() else { return };
    for (name, of) in properties {
        let key = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
        if of["properties"].is_object() {
            keys_of_schema(&key, of, found);
        } else {
            found.push(key);
        }
    }
}

#[test]
fn every_key_is_in_a_list() {
    let arguments: Vec<_> = ["spinner", "config", "--schema"].iter().map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    assert_eq!(cli::run_with::<SpinnerU5620>(&arguments, streams), Status::Done);
    let schema: Value = serde_json::from_slice(&output).expect("JSON");
    let mut all = Vec::new();
    keys_of_schema("", &schema, &mut all);
    assert!(all.len() > 200, "{all:?}");
    let listed = |key: &String| {
        let is = |name: &str| key == name || name.ends_with('.') && key.starts_with(name);
        let stated = CASES.iter().any(|case| is(case.key));
        let not_stated = NOT_STATED.iter().any(|name| is(name));
        assert!(!(stated && not_stated), "`{key}` is in both lists");
        stated || not_stated
    };
    let missing: Vec<&String> = all.iter().filter(|key| !listed(key)).collect();
    assert!(missing.is_empty(), "say of each whether CL data states the same, and what then: {missing:?}");
}
