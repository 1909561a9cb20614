//! Edits of posted programs: a harmful one is found by the check, and a harmless one is not.
//!
//! Whether an edit is harmful is decided by the foreign interpreter (`tests::edits::verdict`). The programs are the
//! golden ones, posted here, the part with every feature with options that few programs have, and random ones. An edit
//! is chosen by control, then by the state of the control, then by the line, so that rare states are met as often as
//! frequent ones.
//!
//! `PP_EDITS=20000 PP_EDITS_SEED=7 cargo test -p tests --test edits --release -- --nocapture` makes more edits;
//! `PP_EDITS_REPORT=path` writes every edit that is missed or falsely found, grouped.

mod random_programs {
    pub(crate) mod cl;
    pub(crate) mod set_up;
}

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use pp_runtime::config::Mode;
use tests::binaries::{golden_programs, workspace};
use tests::edits::{Case, Edit, Posted, Verdict, edit, restarts_differ, verdict};
use tests::foreign::{Control, Entry, Options, Refused, Trace, run};
use tests::random::Random;

use random_programs::cl::{self, AxisRange};
use random_programs::set_up::{self, BUILDER_CODES, MachineKind};

/// Edits of a test run.
const EDITS: usize = 600;

/// Random programs of a test run.
const RANDOM_PROGRAMS: usize = 40;

/// Edits that are shown where a test fails.
const SHOWN: usize = 12;

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

const CONTROLS: [&str; 5] = ["linuxcnc", "fanuc", "haas", "siemens", "heidenhain"];

fn environment_number(name: &str) -> Option<u64> {
    std::env::var(name)
        .ok()
        .map(|text| text.parse().unwrap_or_else(|_| panic!("{name} must be a number, found {text}")))
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
        Mode::Axes => (1, 5),
        Mode::Tcp => (1, 4),
        Mode::Plane => (1, 3),
    })
}

/// The golden programs, posted.
fn golden(programs: &mut Vec<Posted>) {
    for path in golden_programs() {
        let folder = path.parent().expect("a folder");
        let (folder, mode) = match folder.file_name().and_then(|name| name.to_str()) {
            Some("tcp") => (folder.parent().expect("the part"), Mode::Tcp),
            Some("plane") => (folder.parent().expect("the part"), Mode::Plane),
            _ => (folder, Mode::Axes),
        };
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
            "linuxcnc" => &[Mode::Axes, Mode::Tcp],
            _ => &[Mode::Axes, Mode::Tcp, Mode::Plane],
        };
        let mode = modes[random.below(modes.len())];
        let (config, needs) = set_up::set_up(random, kind, control, mode);
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

/// Edits of one control.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    edits: usize,
    harmful: usize,
    refused: usize,
    harmless: usize,
    undecided: usize,
    missed: usize,
    passed_refused: usize,
    falsely_found: usize,
}

/// Text without its numbers.
fn without_numbers(text: &str) -> String {
    let mut kind = String::new();
    for letter in text.chars() {
        match letter {
            '0'..='9' if kind.ends_with('#') => {}
            '0'..='9' => kind.push('#'),
            '.' | '-' if kind.ends_with('#') => {}
            letter => kind.push(letter),
        }
    }
    kind
}

struct Failure {
    class: String,
    text: String,
}

fn failure(what: &str, control: Control, posted: &Posted, edit: &Edit, why: &str, finding: &str) -> Failure {
    let reason = why.split_once(": ").map_or(why, |(_, reason)| reason);
    let reason = if what == "refused, not found" { reason.split(": ").next().unwrap_or_default() } else { reason };
    let edit = &Edit { kind: edit.kind.replace('\n', "\\n").replace(" | ", " / "), ..edit.clone() };
    let (kind, reason) = (without_numbers(reason), finding.split_once(": ").map_or("", |(_, text)| text));
    let reason = without_numbers(reason);
    Failure {
        class: format!("{what} | {} | {} | {kind}{reason}", control.name(), edit.kind),
        text: format!(
            "{}, line {}, {}\n  state: {}\n  was: {}\n  is:  {}\n  trace: {why}\n  finding: {finding}\n",
            posted.subject.name, edit.line, edit.kind, edit.class, edit.before, edit.after
        ),
    }
}

/// Lines by control and state class.
type Places = BTreeMap<&'static str, BTreeMap<String, Vec<(usize, usize)>>>;

fn places(programs: &[Posted]) -> Places {
    let mut places = Places::new();
    for (program, posted) in programs.iter().enumerate() {
        let classes = places.entry(posted.subject.options.control.name()).or_default();
        for (line, class) in &posted.subject.classes {
            classes.entry(class.clone()).or_default().push((program, *line));
        }
    }
    places
}

fn chosen<'a>(programs: &'a [Posted], places: &Places, control: &str, random: &mut Random) -> (&'a Posted, Edit) {
    let classes: Vec<&Vec<(usize, usize)>> = places[control].values().collect();
    loop {
        let lines = classes[random.below(classes.len())];
        let (program, line) = lines[random.below(lines.len())];
        if let Some(edit) = edit(&programs[program].subject, line, random) {
            return (&programs[program], edit);
        }
    }
}

/// Whether the program does the same from its beginning, and not from each of its restart points.
fn is_another_restart(posted: &Posted, edit: &Edit, edited: &Result<Trace, Refused>) -> bool {
    let subject = &posted.subject;
    let Ok(edited) = edited else { return false };
    let entered = |after: bool, number: usize| {
        let trace = if after { edited } else { &subject.trace };
        let line = trace.restarts().nth(number).unwrap_or_default();
        let tool = trace.blocks.iter().rev().find(|block| block.line < line).and_then(|block| block.state.tool);
        let options = Options { entry: Some(Entry { line, tool }), ..subject.options.clone() };
        run(if after { &edit.text } else { &posted.text }, &options)
    };
    restarts_differ([&subject.trace, edited], entered, subject.allowed)
}

/// Whether a program that does the same holds what a check may find: text after a semicolon, which may begin a block, an end
/// code before the end, a code of the shop beside other words, M9 besides codes of air, a unit elsewhere.
fn is_matter_of_taste(posted: &Posted, edit: &Edit) -> bool {
    let options = &posted.subject.options;
    let semicolon = matches!(options.control, Control::Fanuc | Control::Haas) && edit.after.contains(';');
    let ends = ["M2", "M30", "M02", "RET", "M17"].iter().any(|code| edit.after.split(' ').any(|word| word == *code));
    let shop = edit
        .after
        .split(" | ")
        .any(|line| line.contains(' ') && line.split(' ').any(|word| options.idle.iter().any(|idle| idle == word)));
    let of_air = options.idle.iter().any(|idle| idle == "M83");
    let words = || edit.before.split(' ').chain(edit.after.split(' '));
    // Whether M9 also switches off air and coolant through the spindle.
    let off = of_air && words().any(|word| word == "M9" || word == "M09");
    // Where a restart point begins.
    let unit = words().any(|word| ["G20", "G21", "G700", "G710"].contains(&word));
    // A tool that is selected in a block with a motion.
    let tool = edit.after.split(" | ").any(|line| {
        let is = |letters: &str| line.split(' ').any(|word| word.starts_with(|letter| letters.contains(letter)));
        is("T") && is("XYZABC")
    });
    semicolon || ends || shop || off || unit || tool
}

/// Whether an edit concerns messages and comments alone. The foreign interpreter refuses a guard without its message.
fn is_message(edit: &Edit) -> bool {
    let message = |line: &str| line.is_empty() || line.starts_with(['(', ';', '*']) || line.starts_with("MSG(");
    let abort = edit.before.contains("(abort") || edit.after.contains("(abort");
    !abort && edit.before.split(" | ").chain(edit.after.split(" | ")).all(message)
}

fn judged(posted: &Posted, edit: &Edit, tally: &mut Tally) -> Option<Failure> {
    let subject = &posted.subject;
    let control = subject.options.control;
    tally.edits += 1;
    let edited = run(&edit.text, &subject.options);
    let verdict = verdict(&subject.trace, &edited, subject.allowed);
    if matches!(verdict, Verdict::Undecided(_))
        || verdict == Verdict::Harmless && is_matter_of_taste(posted, edit)
        || matches!(verdict, Verdict::Refused(_)) && is_message(edit)
        || verdict == Verdict::Harmless && is_another_restart(posted, edit, &edited)
    {
        tally.undecided += 1;
        return None;
    }
    let findings = posted.findings(&edit.text);
    let panics = findings.iter().any(|finding| finding == "PANIC");
    if panics {
        return Some(failure("panic", control, posted, edit, &format!("{verdict:?}"), "PANIC"));
    }
    match (verdict, findings.first()) {
        (Verdict::Harmful(why), found) => {
            tally.harmful += 1;
            tally.missed += usize::from(found.is_none());
            found.is_none().then(|| failure("missed", control, posted, edit, &why, "none"))
        }
        (Verdict::Refused(why), found) => {
            tally.refused += 1;
            tally.passed_refused += usize::from(found.is_none());
            found.is_none().then(|| failure("refused, not found", control, posted, edit, &why, "none"))
        }
        (Verdict::Harmless, found) => {
            tally.harmless += 1;
            tally.falsely_found += usize::from(found.is_some());
            found.map(|found| failure("falsely found", control, posted, edit, "same", found))
        }
        (Verdict::Undecided(_), _) => None,
    }
}

/// The edits that fail, grouped by their class, the largest class first.
fn report(failures: &[Failure]) -> String {
    let mut classes: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for failure in failures {
        classes.entry(&failure.class).or_default().push(&failure.text);
    }
    let mut classes: Vec<_> = classes.into_iter().collect();
    classes.sort_by_key(|(_, texts)| std::cmp::Reverse(texts.len()));
    let mut report = String::new();
    for (class, texts) in classes {
        writeln!(report, "## {} x {class}\n", texts.len()).expect("memory");
        texts.iter().for_each(|text| writeln!(report, "{text}").expect("memory"));
    }
    report
}

#[test]
fn every_harmful_edit_is_found_and_no_harmless_one() {
    let more = environment_number("PP_EDITS");
    let edits = more.map_or(EDITS, |edits| edits as usize);
    let seed = environment_number("PP_EDITS_SEED").unwrap_or(1);
    let mut programs = Vec::new();
    golden(&mut programs);
    with_options(&mut programs);
    let count = if more.is_some() { RANDOM_PROGRAMS.max(edits / 20).min(600) } else { RANDOM_PROGRAMS };
    random(&mut programs, count, seed << 32);
    for posted in programs.iter().filter(|_| more.is_some()) {
        let findings = posted.findings(&posted.text);
        assert!(findings.is_empty(), "{}: {findings:?}", posted.subject.name);
    }
    let places = places(&programs);
    let classes: usize = places.values().map(BTreeMap::len).sum();
    println!("{} programs, {classes} states", programs.len());
    let mut random = Random::new(seed);
    let mut tallies = [Tally::default(); 5];
    let mut failures = Vec::new();
    for number in 0..edits {
        let (posted, edit) = chosen(&programs, &places, CONTROLS[number % 5], &mut random);
        failures.extend(judged(posted, &edit, &mut tallies[number % 5]));
    }
    for (control, tally) in CONTROLS.iter().zip(&tallies) {
        println!("{control:10} {tally:?}");
    }
    if let Ok(path) = std::env::var("PP_EDITS_REPORT") {
        fs::write(&path, report(&failures)).expect("the report can be written");
    }
    let decided: usize = tallies.iter().map(|tally| tally.harmful + tally.harmless).sum();
    assert!(decided > edits / 4, "only {decided} of {edits} edits are harmful or harmless for certain");
    let shown: Vec<&str> = failures.iter().take(SHOWN).map(|failure| failure.text.as_str()).collect();
    assert!(failures.is_empty(), "{} edits fail, for example\n{}", failures.len(), shown.join("\n"));
}
