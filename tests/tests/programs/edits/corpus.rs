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

/// Every program; the seed chooses the random ones.
pub(crate) fn programs(seed: u64) -> Vec<Posted> {
    let edits = environment::number("PP_EDITS").unwrap_or(0) as usize;
    let mut programs = Vec::new();
    golden(&mut programs);
    with_options(&mut programs);
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
                    match Posted::of(&case) {
                        Ok(posted) => programs.push(posted),
                        Err(why) if environment::number("PP_EDITS").is_some() => println!("{}: {why}", golden.name),
                        Err(_) => {}
                    }
                }
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
