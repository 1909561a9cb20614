//! The programs that are edited: the golden ones, the part with every feature with options that few programs have, and
//! random ones, all posted here.

use std::fs;
use std::path::Path;

use pp_runtime::config::Mode;
use tests::binaries::{golden_programs, part_and_mode, workspace};
use tests::edits::{Case, Posted};
use tests::random::Random;

use super::{CONTROLS, RANDOM_PROGRAMS, environment_number};
use crate::random_programs::cl::{self, AxisRange};
use crate::random_programs::set_up::{self, BUILDER_CODES, MachineKind};

const KINDS: &[MachineKind] = &[
    MachineKind {
        name: "spinner",
        rotaries: &['C', 'B'],
        travel: &[('C', -200, 200), ('B', -100, 100)],
        endless: &['C'],
        axis_range: AxisRange::UpTo(90),
        table: true,
        head: false,
    },
    MachineKind {
        name: "dmu",
        rotaries: &['C', 'B'],
        travel: &[('C', -190, 270), ('B', -180, 180)],
        endless: &['C'],
        axis_range: AxisRange::UpTo(85),
        table: true,
        head: false,
    },
    MachineKind {
        name: "lola",
        rotaries: &['A', 'B'],
        travel: &[('A', -100, 100), ('B', -110, 110)],
        endless: &['A', 'B'],
        axis_range: AxisRange::UpTo(80),
        table: false,
        head: true,
    },
    MachineKind {
        name: "multiprodesk",
        rotaries: &['A'],
        travel: &[('A', -100, 100)],
        endless: &['A'],
        axis_range: AxisRange::AboutX,
        table: true,
        head: false,
    },
    MachineKind {
        name: "head_table",
        rotaries: &['C', 'B'],
        travel: &[('C', -200, 200), ('B', -100, 100)],
        endless: &['C', 'B'],
        axis_range: AxisRange::UpTo(85),
        table: true,
        head: true,
    },
    MachineKind {
        name: "mill",
        rotaries: &[],
        travel: &[],
        endless: &[],
        axis_range: AxisRange::Vertical,
        table: false,
        head: false,
    },
];

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

/// Every program; the seed chooses the random ones.
pub(crate) fn programs(seed: u64) -> Vec<Posted> {
    let edits = environment_number("PP_EDITS").unwrap_or(0) as usize;
    let mut programs = Vec::new();
    golden(&mut programs);
    with_options(&mut programs);
    random(&mut programs, RANDOM_PROGRAMS.max(edits / 20).min(600), seed << 32);
    programs
}

/// CL data and configuration of a part.
fn part(folder: &Path, name: &str, machine: &str) -> (Vec<u8>, String) {
    let config = if name == "works" && machine != "lola-xoyzba" { "table" } else { name };
    let config = fs::read_to_string(folder.join(format!("{config}.toml"))).unwrap_or_default();
    let files = fs::read_dir(folder).expect("a part").map(|entry| entry.expect("an entry").path());
    let cl = files.into_iter().find(|path| {
        path.extension().is_some_and(|extension| ["cls", "ncl", "apt", "aptsource"].iter().any(|cl| extension == *cl))
    });
    let cl = cl.unwrap_or_else(|| workspace().join(format!("examples/cl/{name}.cls")));
    (fs::read(&cl).expect("CL data"), config)
}

/// Operations of the part with every feature: no control cuts its thread under tip control, and in the fourth the tool
/// axis rotates.
fn operations(part: &str, mode: Mode) -> Option<(u64, u64)> {
    part.starts_with("works").then_some(match mode {
        Mode::Axes | Mode::Auto => (1, 5),
        Mode::Tcp => (1, 4),
        Mode::Plane => (1, 3),
    })
}

/// The golden programs, posted.
fn golden(programs: &mut Vec<Posted>) {
    for path in golden_programs() {
        let (folder, mode) = part_and_mode(&path);
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let (machine, control) = stem.split_once('.').expect("machine and control");
        let (cl, config) = part(folder, &name, machine);
        let title = format!("{name} {machine} {control} {}", mode.name());
        let operations = operations(&name, mode);
        let case = Case { name: &title, machine, control, mode, operations, config: &config, cl: &cl, idle: &[] };
        programs.push(Posted::of(&case).unwrap_or_else(|why| panic!("{title}: {why}")));
    }
}

/// Keys of both files: those before the first section together.
fn merged(config: &str, more: &str) -> String {
    let (more_keys, more_sections) = more.split_at(more.find('[').unwrap_or(more.len()));
    let sections = if config.starts_with('[') { Some(0) } else { config.find("\n[").map(|place| place + 1) };
    let (keys, sections) = config.split_at(sections.unwrap_or(config.len()));
    format!("{keys}{more_keys}{sections}\n{more_sections}")
}

/// The part with every feature, with options that golden programs do not have.
fn with_options(programs: &mut Vec<Posted>) {
    let folder = workspace().join("tests/data/works");
    for (index, more) in OPTIONS.iter().enumerate() {
        for machine in ["spinner-u5-620", "lola-xoyzba"] {
            let (cl, config) = part(&folder, "works", machine);
            for control in CONTROLS {
                for mode in [Mode::Axes, Mode::Tcp, Mode::Plane] {
                    let title = format!("works, options {index}, {machine} {control} {}", mode.name());
                    let config = merged(&config, more);
                    let operations = operations("works", mode);
                    let idle = ["M10", "M11"];
                    let case = Case {
                        name: &title,
                        machine,
                        control,
                        mode,
                        operations,
                        config: &config,
                        cl: &cl,
                        idle: &idle,
                    };
                    match Posted::of(&case) {
                        Ok(posted) => programs.push(posted),
                        Err(why) if environment_number("PP_EDITS").is_some() => println!("{title}: {why}"),
                        Err(_) => {}
                    }
                }
            }
        }
    }
}

/// Random programs, by their seeds.
fn random(programs: &mut Vec<Posted>, count: usize, first: u64) {
    let wanted = programs.len() + count;
    for seed in first.. {
        if programs.len() == wanted {
            break;
        }
        let mut random = Random::new(seed);
        let random = &mut random;
        let kind = &KINDS[random.below(KINDS.len())];
        let control = CONTROLS[random.below(CONTROLS.len())];
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
