//! Edits of posted programs: a harmful one is found by the check, and a harmless one is not.
//!
//! Whether an edit is harmful is decided by the foreign interpreter (`tests::edits::verdict`). The programs are the
//! golden ones, posted here, the part with every feature with options that few programs have, and random ones. An edit
//! is chosen by control, then by the state of the control, then by the line, so that rare states are met as often as
//! frequent ones.
//!
//! `PP_EDITS=20000 PP_EDITS_SEED=7 cargo test --workspace --test programs edits:: --release -- --nocapture` makes more
//! edits, of each of the tests (`every_harmful_edit`, `every_harmful_permutation`: the order of lines alone changes);
//! `PP_EDITS_REPORT=path` writes every edit that is missed or falsely found, grouped; their files are in `path.files`.

mod corpus;
mod flow;
mod linuxcnc;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use tests::edits::{Edit, Posted, Subject, Verdict, edit, permutation, restarts_differ, verdict, without_numbers};
use tests::environment;
use tests::foreign::{Control, Entry, Options, Refused, Trace, run};
use tests::random::Random;

use corpus::programs;

/// Edits of a test run.
const EDITS: usize = 600;

/// Random programs of a test run.
const RANDOM_PROGRAMS: usize = 40;

/// Edits that are shown where a test fails.
const SHOWN: usize = 12;

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
        text: shown(posted, edit, why, finding),
    }
}

/// An edit as text.
fn shown(posted: &Posted, edit: &Edit, why: &str, finding: &str) -> String {
    let before = posted.subject.lines[edit.line.saturating_sub(8)..edit.line - 1].join(" | ");
    format!(
        "{}, line {}, {}\n  state: {}\n  before: {before}\n  was: {}\n  is:  {}\n  trace: {why}\n  finding: {finding}\n",
        posted.subject.name, edit.line, edit.kind, edit.class, edit.before, edit.after
    )
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

/// Makes an edit at a line.
type Editing = fn(&Subject, usize, &mut Random) -> Option<Edit>;

fn chosen<'a>(
    programs: &'a [Posted],
    places: &Places,
    control: &str,
    random: &mut Random,
    edit: Editing,
) -> (&'a Posted, Edit) {
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

/// Whether the careful interpreter, too, finds that the program does the same. What it refuses may be found.
fn is_harmless_for_the_careful(posted: &Posted, edit: &Edit) -> bool {
    let Some((options, trace)) = &posted.careful else { return false };
    verdict(trace, &run(&edit.text, options), posted.subject.allowed) == Verdict::Harmless
}

/// Whether a program that does the same holds what a check may find: text after a semicolon, which may begin a block,
/// an end code before the end, a code of the shop in a block with other words, M9 with codes of air, another unit or
/// datum.
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
    let unit =
        words().any(|word| ["G20", "G21", "G700", "G710"].contains(&word)) || edit.after.contains("CYCL DEF 247");
    // Smoothing of Haas without a tolerance, and the user's codes of tip control again.
    let own = words().any(|word| ["G187", "M428", "M429"].contains(&word));
    // A tool that is selected in a block with a motion.
    let tool = edit.after.split(" | ").any(|line| {
        let is = |letters: &str| line.split(' ').any(|word| word.starts_with(|letter| letters.contains(letter)));
        is("T") && (is("XYZABC") || line.contains("M29"))
    });
    // A parameter of a cycle that is left out.
    let parameter =
        options.control == Control::Heidenhain && edit.before.split(" | ").any(|line| line.starts_with("  Q"));
    // Words of a plane in another order.
    let plane = edit.before.contains("COORD ROT") && !edit.after.contains("COORD ROT");
    // A label of a guard, to which the control does not get unless it stops.
    let label = edit.before.contains("LBL \"");
    // A plane call more or less: harmless where nothing moves in it, and the check may find it.
    let begins = |text: &str| ["G68.2", "G254", "G268", "CYCLE800(0", "PLANE S"].map(|code| text.matches(code).count());
    let needless = begins(&edit.before) != begins(&edit.after);
    needless || parameter || label || plane || semicolon || ends || shop || off || unit || own || tool
}

/// Whether a code is in the edit that the control has and the foreign interpreter has not.
fn is_another_mode(edit: &Edit) -> bool {
    const MODES: &[&str] = &[
        "G9", "G09", "G60", "G61.1", "G500", "G601", "G602", "G603", "G641", "G642", "G643", "G644", "G645", "G70",
        "G71", "G91.1", "G97",
    ];
    edit.after.split(' ').any(|word| MODES.contains(&word)) && !edit.before.split(' ').any(|word| MODES.contains(&word))
}

/// Whether an edit concerns messages and comments alone. The foreign interpreter refuses a guard without its message.
fn is_message(edit: &Edit) -> bool {
    let message = |line: &str| line.is_empty() || line.starts_with(['(', ';', '*']) || line.starts_with("MSG(");
    let abort = edit.before.contains("(abort") || edit.after.contains("(abort");
    let rest =
        |text: &str| -> Vec<String> { text.split(" | ").filter(|line| !message(line)).map(str::to_owned).collect() };
    // A message that moves across other lines of a guard, and the two codes that stop in one.
    let stop = |line: &str| message(line) || matches!(line, "M0" | "M30");
    let all_stop = edit.before.split(" | ").chain(edit.after.split(" | ")).all(stop);
    let stops = edit.after.split(" | ").any(|line| matches!(line, "M0" | "M30"));
    if !abort && (rest(&edit.before) == rest(&edit.after) || all_stop && stops) {
        return true;
    }
    !abort && edit.before.split(" | ").chain(edit.after.split(" | ")).all(message)
}

/// Whether an edit concerns texts that the control displays: they are those of PPRINT.
fn is_displayed(edit: &Edit) -> bool {
    let displays = |text: &str| text.contains("(MSG,") || text.contains("MSG(");
    displays(&edit.before) || displays(&edit.after)
}

/// Whether an edit adds, moves or removes codes of the shop alone that are declared to have no effect.
fn is_without_effect(edit: &Edit) -> bool {
    let rest = |text: &str| -> Vec<String> {
        let words = text.split([' ', '|']).filter(|word| !word.is_empty() && !["M77", "M78", "M79"].contains(word));
        words.map(str::to_owned).collect()
    };
    edit.before != edit.after && rest(&edit.before) == rest(&edit.after)
}

/// Whether the code that switches a supply of the shop off is in the block of a motion, at whose end it acts.
fn is_supply_off_with_motion(verdict: &Verdict, edit: &Edit) -> bool {
    let moves = |line: &str| {
        let words: Vec<&str> = line.split(' ').collect();
        words.iter().any(|word| matches!(*word, "M9" | "M09"))
            && words.iter().any(|word| word.starts_with(['X', 'Y', 'Z', 'I']))
    };
    let moved = || edit.after.split(" | ").any(moves) && !edit.before.split(" | ").any(moves);
    matches!(verdict, Verdict::Harmful(why) if why.ends_with("a supply of the shop")) && moved()
}

/// Whether the work offset comes after the plane that is in it.
fn is_offset_after_plane(edit: &Edit) -> bool {
    edit.before.contains("CYCLE800(") && edit.before.contains("G54")
}

/// Whether lines in another order cut the same, although they move in another way, or hold what a check may find.
fn is_another_way(verdict: &Verdict, edit: &Edit) -> bool {
    match verdict {
        // A cycle leads over its hole and down to R itself; whole turns of a helix come after a part of one; at the
        // machine retract a plane may be off before axes go where tip control begins.
        Verdict::Harmful(why) => {
            why.ends_with("became hole")
                || why.contains("a point of an arc") && edit.before.contains("CP IPA")
                || why.ends_with(": the tilted plane") && edit.before.contains("CYCLE800()")
        }
        Verdict::Harmless | Verdict::Refused(_) | Verdict::Undecided(_) => false,
    }
}

/// `order`: the order of acting records counts, also of those without effect.
fn judged(posted: &Posted, edit: &Edit, order: bool, tally: &mut Tally) -> Option<Failure> {
    let subject = &posted.subject;
    let control = subject.options.control;
    tally.edits += 1;
    let edited = run(&edit.text, &subject.options);
    let verdict = verdict(&subject.trace, &edited, subject.allowed);
    if matches!(verdict, Verdict::Undecided(_))
        || verdict == Verdict::Harmless && !is_harmless_for_the_careful(posted, edit)
        || verdict == Verdict::Harmless && (is_matter_of_taste(posted, edit) || is_displayed(edit))
        || matches!(verdict, Verdict::Refused(_)) && (is_message(edit) || is_another_mode(edit))
        || matches!(verdict, Verdict::Harmful(_)) && !order && is_without_effect(edit)
        || is_supply_off_with_motion(&verdict, edit)
        || subject.options.rapids_at_feed
            && matches!(&verdict, Verdict::Harmful(why) if why.ends_with("dwell became feed"))
        || order && is_another_way(&verdict, edit)
        || verdict == Verdict::Harmless && is_offset_after_plane(edit)
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
        // The traces begin with a control that is in no state of a program before, and where an entry with a tool that
        // stays cannot be tried, what it lacks is not in them.
        (Verdict::Harmless, Some(found))
            if found.contains("from a program before")
                || found.contains("this restart point does not end it")
                || found.contains("between the holes of rigid tapping")
                || found.contains("has no meaning in this block")
                || found.contains("rotary words where the program gives the tool axis by its components")
                || ["since the complete state", "after its restart point"].iter().any(|text| found.contains(text))
                    && edit.text.to_lowercase().contains("stays in the spindle") =>
        {
            tally.undecided += 1;
            None
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
    each_edit(edit, false);
}

#[test]
fn every_harmful_permutation_is_found_and_no_harmless_one() {
    each_edit(permutation, true);
}

fn each_edit(editing: Editing, order: bool) {
    let more = environment::number("PP_EDITS");
    let edits = more.map_or(EDITS, |edits| edits as usize);
    let seed = environment::number("PP_EDITS_SEED").unwrap_or(1);
    let programs = programs(seed);
    let mut faulty = Vec::new();
    for posted in programs.iter().filter(|_| more.is_some()) {
        let findings = posted.findings(&posted.text);
        if !findings.is_empty() {
            faulty.push(format!("{}: {findings:?}", posted.subject.name));
        }
    }
    println!("{} programs that are not edited have findings: {faulty:#?}", faulty.len());
    let programs: Vec<Posted> = programs
        .into_iter()
        .filter(|posted| !faulty.iter().any(|found| found.starts_with(&format!("{}:", posted.subject.name))))
        .collect();
    let careful = programs.iter().filter(|posted| posted.careful.is_some()).count();
    assert!(careful * 20 > programs.len() * 19, "only {careful} of {} programs are read with care", programs.len());
    let places = places(&programs);
    let classes: usize = places.values().map(BTreeMap::len).sum();
    println!("{} programs, {careful} of them read with care, {classes} states", programs.len());
    let mut random = Random::new(seed);
    let mut tallies = [Tally::default(); 5];
    let mut failures = Vec::new();
    for number in 0..edits {
        let (posted, edit) = chosen(&programs, &places, Control::ALL[number % 5].name(), &mut random, editing);
        let failure = judged(posted, &edit, order, &mut tallies[number % 5]);
        if let (Some(failure), Ok(path)) = (&failure, std::env::var("PP_EDITS_REPORT")) {
            let folder = format!("{path}.files/{}", failures.len());
            posted.write(Path::new(&folder), &edit.text).expect("the files can be written");
            println!("{folder}: {}", failure.text.lines().next().unwrap_or_default());
        }
        failures.extend(failure);
    }
    for (control, tally) in Control::ALL.iter().zip(&tallies) {
        println!("{:10} {tally:?}", control.name());
    }
    if let Ok(path) = std::env::var("PP_EDITS_REPORT") {
        fs::write(&path, report(&failures)).expect("the report can be written");
    }
    let decided: usize = tallies.iter().map(|tally| tally.harmful + tally.harmless).sum();
    assert!(decided > edits / 4, "only {decided} of {edits} edits are harmful or harmless for certain");
    // A program that is refused cuts nothing wrong: the control stops. These are counted and listed in the report.
    failures.retain(|failure| !failure.class.starts_with("refused"));
    let shown: Vec<&str> = failures.iter().take(SHOWN).map(|failure| failure.text.as_str()).collect();
    assert!(faulty.is_empty(), "programs that are not edited have findings: {faulty:#?}");
    assert!(failures.is_empty(), "{} edits fail, for example\n{}", failures.len(), shown.join("\n"));
}
