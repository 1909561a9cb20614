//! Hints that are followed to the letter, as a user does on the command line, and the list of those in the sources.
//!
//! A case with a block `help` gives a message with this hint. Each `follow` block after it is a way to follow it, and
//! the program is then that of the block `means cl`: the CL data that the author meant, in plain words.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;

use serde_json::Value;
use tempfile::TempDir;
use tests::binaries::workspace;

use crate::format::{Block, Case, Kind, Run};
use crate::hints::{Hint, hints};
use crate::job::{Chosen, Job};
use crate::program::{difference, is_like, unnumbered};

/// Sources whose hints are followed: folders or files.
const SOURCES: [&str; 8] = [
    "pp-runtime/src/cl",
    "pp-runtime/src/config",
    "pp-runtime/src/control",
    "pp-runtime/src/keys",
    "pp-runtime/src/motion",
    "pp-runtime/src/options",
    "pp-runtime/src/post",
    "pp-runtime/src/set_up",
];

/// Hints that no case can follow, and why.
const NOT_FOLLOWED: [(&str, &str); 16] = [
    ("output the CL data as text (APT source, CLS)", "a scenario is text"),
    ("whether its line ends were lost", "a statement of a megabyte"),
    ("output one file for each set-up", "a file with a hundred frames"),
    ("post the operations of this file as several files", "subprograms of eight megabytes"),
    ("check the tool numbers in the CAM system; if the file", "more than a thousand tools"),
    ("post the CL data in parts", "a course whose changes fill the memory"),
    ("this is a fault of the postprocessor", "no job is known that leads to it"),
    ("retract before this point and start a new operation, or rotate", "the course of a program rewinds before it"),
    ("mill the thread", "every control that is built in has a tapping cycle"),
    ("give `[tools.N] length`", "a machine with rotary axes in the head and in the table"),
    ("measure {them} at the machine", "a machine with a dimension that has no default"),
    ("`{name} = ...`", "the same hint"),
    ("`{key} = \"\"` says that there is none", "an edit in a list, to which a case can only add"),
    ("{machine} has no rotary axis", "a machine without rotary axes"),
    ("move this axis to its positions by hand", "of `explain --proof-program`, which has no CL data"),
    ("give it in the configuration: `[limits]", "of `explain --proof-program`, which has no CL data"),
];

/// Begin of the hints that ask for nothing: they are given again.
const NOTHING: &str = "nothing needs to be done";

/// What a case fails with: line of the block, text, and the lines that the block would have.
type Found = (usize, String, Option<Vec<String>>);

/// Result of a job.
struct Posted {
    done: bool,
    /// Blocks without comments and numbers.
    blocks: Vec<String>,
    /// Texts and hints of the messages.
    messages: Vec<(String, Option<String>)>,
}

impl Posted {
    fn has_hint(&self, hint: &str) -> bool {
        self.messages.iter().any(|(_, own)| own.as_ref().is_some_and(|own| is_like(own, hint)))
    }

    fn listed(&self) -> String {
        let message =
            |(text, hint): &(String, Option<String>)| format!("{text}\n  help: {}", hint.as_deref().unwrap_or("-"));
        self.messages.iter().map(message).collect::<Vec<_>>().join("\n")
    }
}

/// Posts a job with the options as a user does, with its check.
fn posted(job: &Job<'_>, run: &Run, options: &[String]) -> Posted {
    let folder = TempDir::new().expect("a folder");
    let place = |name: &str| folder.path().join(name);
    for (name, text) in job.files() {
        fs::write(place(name), text).expect("it can be written");
    }
    let mut args: Vec<OsString> =
        [&*run.machine, "post", "--control", &run.control, "--message-format", "json", "--quiet"]
            .map(OsString::from)
            .to_vec();
    args.extend(["--config".into(), place("job.toml").into(), "-o".into(), place("part.nc").into()]);
    args.extend(options.iter().map(OsString::from));
    args.push(place("part.cls").into());
    let (done, errors) = job.run(&args);
    let of_line = |line: &str| match serde_json::from_str::<Value>(line) {
        Ok(found) => {
            let text = |key: &str| found.get(key).and_then(Value::as_str).map(str::to_owned);
            let is_note = found.get("severity").and_then(Value::as_str) == Some("note");
            (!is_note).then(|| (text("text").unwrap_or_default(), text("help")))
        }
        // What is wrong with the command line itself.
        Err(_) => Some((line.to_owned(), None)),
    };
    let messages = errors.lines().filter_map(of_line).collect();
    let program = fs::read_to_string(place("part.nc")).unwrap_or_default();
    let numbered = job.control().spellings().numbers_every_line;
    let bare = unnumbered(&program, numbered).iter().map(|line| without_comment(line)).collect::<Vec<_>>();
    Posted { done, blocks: bare.into_iter().filter(|line| !line.is_empty()).collect(), messages }
}

/// A block without its comments, its number and blanks around it.
fn without_comment(line: &str) -> String {
    let mut block = String::new();
    let mut rest = line.split(';').next().unwrap_or_default();
    while let Some((before, comment)) = rest.split_once('(') {
        block += before;
        rest = comment.split_once(')').map_or("", |(_, after)| after);
    }
    block += rest;
    let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    match block.trim().strip_prefix('N').map(|number| (number, digits(number))) {
        Some((number, count)) if count > 0 => number[count..].trim().to_owned(),
        _ => block.trim().to_owned(),
    }
}

/// What is not as a case with a hint expects it.
pub(crate) fn failures(case: &Case, run: &Run, blocks: &[Block], shows: bool) -> Vec<Found> {
    let base: Vec<Block> = blocks.iter().filter(|block| matches!(block.kind, Kind::Cl | Kind::Toml)).cloned().collect();
    let job = |more: Vec<Block>| {
        let all: Vec<Block> = base.iter().cloned().chain(more).collect();
        Job::of(run, &case.settings, &all, &Chosen::new(), None)
    };
    let mut failures: Vec<Found> = Vec::new();
    let first = posted(&job(Vec::new()), run, &case.settings.options);
    let mut hints: Vec<&String> = Vec::new();
    for block in blocks {
        match block.kind {
            Kind::Error => {
                let lost =
                    block.lines.iter().filter(|text| !first.messages.iter().any(|(own, _)| own.contains(&***text)));
                let lost: Vec<_> = lost.collect();
                if !lost.is_empty() || first.done {
                    failures.push((
                        block.line,
                        format!("expected the refusal: {lost:?}\nfound:\n{}", first.listed()),
                        None,
                    ));
                }
            }
            Kind::Help => {
                let found: BTreeSet<String> = first.messages.iter().filter_map(|(_, hint)| hint.clone()).collect();
                if block.lines.is_empty() || block.lines.iter().any(|hint| !first.has_hint(hint)) {
                    let text = format!("expected: {:?}\nfound:\n{}", block.lines, first.listed());
                    failures.push((block.line, text, Some(found.into_iter().collect())));
                }
                hints.extend(&block.lines);
            }
            _ => {}
        }
    }
    let mut ways: Vec<Vec<&Block>> = Vec::new();
    let mut of_meaning: Vec<Block> = Vec::new();
    for block in blocks {
        match block.kind {
            Kind::Follow if block.is("also") && !ways.is_empty() => ways.last_mut().expect("one").push(block),
            Kind::Follow => ways.push(vec![block]),
            Kind::Means if !block.is("cl") => of_meaning.push(block.as_kind(Kind::Toml)),
            Kind::Means => {
                of_meaning.push(block.as_kind(Kind::Cl));
                let meant = posted(&job(std::mem::take(&mut of_meaning)), run, &[]);
                if !meant.done {
                    failures.push((block.line, format!("what it means is not posted:\n{}", meant.listed()), None));
                    continue;
                }
                if shows {
                    println!("{}, what it means:\n{}", case.title(), meant.blocks.join("\n"));
                }
                for way in ways.drain(..) {
                    if let Some(text) = followed(case, run, &way, &job, &hints, &meant) {
                        failures.push((way[0].line, text, None));
                    }
                }
            }
            _ => {}
        }
    }
    if let Some(way) = ways.first() {
        failures.push((way[0].line, "no block `means cl` comes after it".to_owned(), None));
    }
    failures
}

/// Why a hint that is followed does not lead to the program that the CL data means.
fn followed<'s>(
    case: &Case,
    run: &Run,
    way: &[&Block],
    job: &impl Fn(Vec<Block>) -> Job<'s>,
    hints: &[&String],
    meant: &Posted,
) -> Option<String> {
    let (options, edits): (Vec<&&Block>, Vec<&&Block>) = way.iter().partition(|block| block.is("options"));
    let of_line = |line: &String| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let given = options.iter().flat_map(|block| block.lines.iter().flat_map(of_line)).collect();
    let options = if options.is_empty() { case.settings.options.clone() } else { given };
    let kind = |block: &Block| if block.is("toml") { Kind::Toml } else { Kind::Cl };
    let followed = posted(&job(edits.iter().map(|block| block.as_kind(kind(block))).collect()), run, &options);
    if !followed.done {
        return Some(format!("it is followed, and refused:\n{}", followed.listed()));
    }
    // A way without lines is to leave the job as it is.
    let is_same = way.iter().all(|block| block.lines.is_empty() && !block.is("options"));
    let again = hints.iter().find(|hint| !is_same && !hint.starts_with(NOTHING) && followed.has_hint(hint));
    if let Some(hint) = again {
        return Some(format!("it is followed, and given again: {hint}"));
    }
    (followed.blocks != meant.blocks)
        .then(|| format!("- what it means, + what is posted:\n{}", difference(&meant.blocks, &followed.blocks)))
}

/// Options and keys that a hint names and that no case with it gives or takes away.
fn not_tried<'h>(hint: &'h Hint, cases: &[&Case]) -> Vec<&'h str> {
    let texts = |kind: Kind, word: &str| {
        let blocks = cases.iter().flat_map(|case| &case.blocks);
        let of = blocks.filter(|block| block.kind == kind && (kind == Kind::Toml || block.is(word)));
        of.map(|block| block.lines.join("\n")).collect::<Vec<_>>()
    };
    let (options, keys) = (texts(Kind::Follow, "options"), texts(Kind::Follow, "toml"));
    let (given, given_keys) =
        (cases.iter().map(|case| case.settings.options.join(" ")).collect::<Vec<_>>(), texts(Kind::Toml, ""));
    let has = |lines: &[String], text: &str| lines.iter().any(|line| line.contains(text));
    let is_tried = |text: &&str| {
        let known = text.split('{').next().unwrap_or_default().trim_end();
        if text.starts_with("--") {
            return has(&options, known) || has(&given, known) && !options.is_empty();
        }
        let Some((key, _)) = known.split_once(" =") else { return true };
        let key = key.rsplit([' ', '.', '[']).next().unwrap_or(key);
        has(&keys, key) || has(&given_keys, key) && !keys.is_empty()
    };
    hint.template.split('`').skip(1).step_by(2).filter(|text| !is_tried(text)).collect()
}

/// Hints of the sources that no case follows, and cases whose hint is not found in the sources.
pub(crate) fn without_case(cases: &[Case]) -> Vec<String> {
    // Functions that take a hint may be elsewhere.
    let all = hints(&workspace().join("pp-runtime/src"));
    let is_source = |place: &str| {
        SOURCES.iter().any(|path| place.strip_prefix(path).is_some_and(|rest| rest.starts_with(['/', ':'])))
    };
    let hints: BTreeSet<&Hint> = all.iter().filter(|hint| is_source(&hint.place)).collect();
    let mut followed: Vec<(&Case, &String)> = Vec::new();
    for case in cases {
        let has = |kind: Kind| case.blocks.iter().any(|block| block.kind == kind && block.line > case.line);
        let of_case = case.blocks.iter().filter(|block| block.kind == Kind::Help).flat_map(|block| &block.lines);
        followed.extend(of_case.filter(|_| has(Kind::Follow) && has(Kind::Means)).map(|hint| (case, hint)));
    }
    let is_excused = |hint: &Hint| NOT_FOLLOWED.iter().any(|(text, _)| hint.template.contains(text));
    let missing = hints.iter().filter(|hint| !is_excused(hint) && !followed.iter().any(|(_, text)| hint.is_of(text)));
    let missing = missing.map(|hint| {
        format!(
            "{}: no case follows the hint: {}{}",
            hint.place,
            hint.template,
            if hint.is_part { " PART" } else { "" }
        )
    });
    let half = hints.iter().filter(|hint| !hint.is_part).flat_map(|hint| {
        let of_hint: Vec<&Case> = followed.iter().filter(|(_, text)| hint.is_of(text)).map(|(case, _)| *case).collect();
        let left = if of_hint.is_empty() { Vec::new() } else { not_tried(hint, &of_hint) };
        left.into_iter()
            .map(|text| format!("{}: no case does what its hint names, `{text}`: {}", hint.place, hint.template))
            .collect::<Vec<_>>()
    });
    let idle = NOT_FOLLOWED.iter().filter(|(text, _)| !hints.iter().any(|hint| hint.template.contains(text)));
    let idle = idle.map(|(text, _)| format!("no source has the hint that is not followed: {text}"));
    let unknown = followed.iter().filter(|(_, text)| !all.iter().any(|hint| !hint.is_part && hint.is_of(text)));
    let unknown = unknown.map(|(case, text)| format!("{}: the hint is not found in the sources: {text}", case.title()));
    missing.chain(half).chain(idle).chain(unknown).collect()
}
