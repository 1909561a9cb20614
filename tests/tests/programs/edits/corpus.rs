//! The programs that are edited: the golden ones, the part with every feature with options that few programs have, and
//! random ones, all posted here.

use pp_runtime::config::Mode;
use tests::binaries::{golden_programs, workspace};
use tests::edits::{Case, Posted};
use tests::environment;
use tests::foreign::Control;
use tests::golden::Golden;
use tests::random::Random;

use super::RANDOM_PROGRAMS;
use crate::random_programs::cl;
use crate::random_programs::set_up::{self, BUILDER_CODES, KINDS};

/// Keys that few golden programs have, with the first of them in the part with every feature.
const OPTIONS: &[&str] = &[
    "length_guard = true\nspindle_dwell = 2.0\n",
    "path_tolerance = 0.005\nspindle_dwell = 1.5\n[program]\nline_numbers = 5\n",
    "length_guard = true\n[control]\nsmoothing = \"finish\"\n",
    "[clamp]\nB = { on = \"M10\", off = \"M11\" }\n[control]\nevery_word = true\n",
    "[cycles]\nrigid = true\n[arcs]\nform = \"radius\"\n",
    "rapid = \"split\"\n[cycles]\noutput = \"expanded\"\n[control]\nsmoothing = \"rough\"\n",
    "output_units = \"in\"\nlength_guard = true\n",
];

/// Two tools that are measured and checked for breakage, with blocks that may be skipped.
const SHOP_CL: &str = "UNITS/MM\nTOOL PATH/FACE,TOOL,T1\nLOADTL/1\nSPINDL/RPM,5000,CLW\nCOOLNT/ON\nRAPID\nGOTO/0,0,50,0,0,1\n\
                       FEDRAT/MMPM,300\nGOTO/0,0,-2\nGOTO/30,0,-2\nRAPID\nGOTO/30,0,50\nTOOL PATH/SIDE,TOOL,T2\nLOADTL/2\n\
                       SPINDL/RPM,3000,CLW\nCOOLNT/ON\nRAPID\nGOTO/10,5,60,0,0.6,0.8\nFEDRAT/MMPM,400\nGOTO/10,5,-1,0,0.6,0.8\n\
                       GOTO/25,5,-1,0,0.6,0.8\nGOTO/25,15,-1,0,0,1\nRAPID\nGOTO/25,15,50\nSTOP\nTOOL PATH/AGAIN,TOOL,T2\n\
                       RAPID\nGOTO/0,10,50\nGOTO/0,10,-1\nGOTO/20,10,-1\nRAPID\nGOTO/20,10,50\nOPSKIP/ON\n\
                       TOOL PATH/SKIPPED,TOOL,T2\nRAPID\nGOTO/0,20,50\nFEDRAT/MMPM,400\nGOTO/0,20,-1\nGOTO/10,20,-1\nRAPID\n\
                       GOTO/10,20,50\nOPSKIP/OFF\nEND-OF-PATH\nFINI\n";

/// Keys of a shop, but for the lines that measure.
const SHOP_KEYS: &str = "part_origin = [0.0, 0.0, 80.0]\ntcp_frame = \"table_at_zero\"\npark = { C = 0.0, Y = 220.0 }\n\
                         optional_stops = \"tool_changes\"\n[retract]\ndistance = 60.0\n\
                         tool_change_position = { X = 0.0, Y = 250.0 }\nhome_on_indexing = true\nxy = { X = 5.0, Y = 6.0 }\n\
                         [clamp]\nB = { on = \"M10\", off = \"M11\" }\nC = { on = \"M68\", off = \"M69\" }\n[tools]\n\
                         1 = { length = 120.0, measured = true, checked = true, start = [\"M131\"], end = [\"M133\"] }\n\
                         2 = { length = 95.0, checked = true }\n[program]\nstart = [\"M77\"]\noperation_start = [\"M78\"]\n\
                         [control]\neffects = { M77=\"none\", M131=\"none\", M133=\"none\", M78=\"none\" }\n";

/// Codes and blocks of that shop.
const SHOP_BLOCKS: [&str; 20] = [
    "M10",
    "M11",
    "M68",
    "M69",
    "M77",
    "M78",
    "M131",
    "M133",
    "G65 P9023 A12. T1 H1",
    "G65 P9023 A22. T1",
    "G65 P9023 A22. T2",
    "L9023(1,1)",
    "L9023(1,2)",
    "L9023(2,2)",
    "o<measure> call [1]",
    "o<check> call [1]",
    "o<check> call [2]",
    "TCH PROBE 481 Q340=+1",
    "TCH PROBE 483 Q340=+1",
    "TCH PROBE 483 Q340=+2",
];

/// Every program; the seed chooses the random ones.
pub(crate) fn programs(seed: u64) -> Vec<Posted> {
    let edits = environment::number("PP_EDITS").unwrap_or(0) as usize;
    let mut programs = Vec::new();
    golden(&mut programs);
    with_options(&mut programs);
    of_shop(&mut programs);
    random(&mut programs, RANDOM_PROGRAMS.max(edits / 20).min(600), seed << 32);
    programs
}

/// The case of a golden program.
fn case(golden: &Golden) -> Case<'_> {
    Case {
        name: &golden.name,
        machine: &golden.machine,
        control: golden.control.spellings().name,
        mode: golden.mode,
        operations: golden.last_operation().map(|last| (1, last)),
        config: &golden.keys,
        cl: golden.cl.as_bytes(),
        idle: &[],
    }
}

/// The golden programs, posted.
fn golden(programs: &mut Vec<Posted>) {
    for path in golden_programs() {
        let golden = Golden::read(&path);
        programs.push(Posted::of(&case(&golden)).unwrap_or_else(|why| panic!("{}: {why}", golden.name)));
    }
}

/// Keys of both files: those before the first section together.
fn merged(config: &str, more: &str) -> String {
    let (more_keys, more_sections) = more.split_at(more.find('[').unwrap_or(more.len()));
    let sections = if config.starts_with('[') { Some(0) } else { config.find("\n[").map(|place| place + 1) };
    let (keys, sections) = config.split_at(sections.unwrap_or(config.len()));
    format!("{keys}{more_keys}{sections}\n{more_sections}")
}

/// Adds a case that can be posted; a long run names the others.
fn add(programs: &mut Vec<Posted>, case: &Case<'_>) {
    match Posted::of(case) {
        Ok(posted) => programs.push(posted),
        Err(why) if environment::number("PP_EDITS").is_some() => println!("{}: {why}", case.name),
        Err(_) => {}
    }
}

/// The part with every feature, with options that golden programs do not have.
fn with_options(programs: &mut Vec<Posted>) {
    for (index, more) in OPTIONS.iter().enumerate() {
        for machine in ["spinner-u5-620", "lola-xoyzba"] {
            for control in Control::ALL.map(Control::name) {
                for mode in [Mode::Axes, Mode::Tcp, Mode::Plane] {
                    let path = workspace().join(format!("tests/data/works/{machine}.linuxcnc.nc"));
                    let name = format!("works, options {index}, {machine} {control} {}", mode.name());
                    let golden = Golden { mode, name, ..Golden::read(&path) };
                    let config = merged(&golden.keys, more);
                    let case = Case { control, config: &config, idle: &["M10", "M11"], ..case(&golden) };
                    add(programs, &case);
                }
            }
        }
    }
}

/// The part of a shop that measures its tools.
fn of_shop(programs: &mut Vec<Posted>) {
    for machine in ["spinner-u5-620", "dmu-70e"] {
        for control in Control::ALL.map(Control::name) {
            let [measure, check] = match control {
                "linuxcnc" => ["o<measure> call [{tool}]", "o<check> call [{tool}]"],
                "siemens" => ["L9023({tool},1)", "L9023({tool},2)"],
                "heidenhain" => ["TCH PROBE 481 Q340=+{tool}", "TCH PROBE 483 Q340=+{tool}"],
                _ => ["G65 P9023 A12. T{tool} H{offset}", "G65 P9023 A22. T{tool}"],
            };
            let cycles = format!(
                "[cycles]\nmeasure_tool = ['{measure}']\ncheck_tool = ['{check}']\ntool_position = {{ B = 0.0, C = 0.0 }}\n"
            );
            let config = merged(SHOP_KEYS, &cycles);
            for mode in [Mode::Axes, Mode::Tcp, Mode::Plane] {
                let name = format!("shop, {machine} {control} {}", mode.name());
                let case = Case {
                    name: &name,
                    machine,
                    control,
                    mode,
                    operations: None,
                    config: &config,
                    cl: SHOP_CL.as_bytes(),
                    idle: &SHOP_BLOCKS,
                };
                add(programs, &case);
            }
        }
    }
}

/// Random programs, by their seeds.
pub(super) fn random(programs: &mut Vec<Posted>, count: usize, first: u64) {
    let wanted = programs.len() + count;
    for seed in first.. {
        if programs.len() == wanted {
            break;
        }
        let mut random = Random::new(seed);
        let random = &mut random;
        let kind = &KINDS[random.below(KINDS.len())];
        let control = Control::ALL[random.below(Control::ALL.len())].name();
        let modes: &[Mode] = match control {
            _ if kind.rotaries.is_empty() => &[Mode::Axes],
            "linuxcnc" => &[Mode::Axes, Mode::Tcp, Mode::Auto],
            _ => &[Mode::Axes, Mode::Tcp, Mode::Plane, Mode::Auto],
        };
        let mode = modes[random.below(modes.len())];
        let (config, needs) = set_up::set_up(random, &mut Random::new(!seed), kind, control, mode);
        let cl = cl::program(random, needs);
        let title = format!("random {seed} {} {control} {}", kind.name, mode.name());
        let case = Case {
            name: &title,
            machine: kind.name,
            control,
            mode,
            operations: None,
            config: &config,
            cl: cl.as_bytes(),
            idle: &BUILDER_CODES,
        };
        if let Ok(posted) = Posted::of(&case)
            && posted.subject.lines.len() < 400
        {
            programs.push(posted);
        }
    }
}
