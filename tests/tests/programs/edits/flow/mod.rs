//! Posted programs, rewritten with variables, conditions, loops, jumps and subprograms.
//!
//! A rewritten program that does the same must pass its check, and be the same for the foreign interpreter; one that
//! the foreign interpreter finds harmful must be found by the check. The two read variables and loops independently.
//!
//! `PP_FLOW=1000 PP_FLOW_SEED=2 cargo test --workspace --test programs edits::flow -- --nocapture` makes more programs.

mod spelling;

use tests::edits::{Posted, Verdict, verdict};
use tests::environment;
use tests::foreign::state::{Compensation, Distance, MotionMode};
use tests::foreign::{Control, Effect, Executed, Trace, run};
use tests::linuxcnc::installed;
use tests::linuxcnc::interpreter::{interpret, interpret_edited};
use tests::random::Random;

use super::corpus;
use super::linuxcnc::same_calls;

/// Rewritten programs of a test run.
const PROGRAMS: usize = 300;

/// Failures that are shown.
const SHOWN: usize = 10;

/// Findings in programs that do the same, of forms that the check does not read: incremental mode, and calls of
/// Siemens, whose subprograms are files of their own. Such a program is counted as not read, also where it does harm.
const NOT_READ: [&str; 2] = ["incremental mode (G91) is active", "` is not known to the check; "];

/// How a stretch of a program is rewritten.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A number becomes a variable.
    Variable,
    /// The stretch becomes a subprogram.
    Call,
    /// The same, with a number as its argument.
    Argument,
    Loop,
    Condition,
    /// Blocks that would do harm are jumped over.
    Jump,
    /// A motion by a distance, in a loop.
    Distance,
}

const KINDS: [Kind; 7] =
    [Kind::Variable, Kind::Call, Kind::Argument, Kind::Loop, Kind::Condition, Kind::Jump, Kind::Distance];

/// Lines that replace a stretch, and a subprogram that they call.
struct Rewritten {
    lines: Vec<String>,
    subprogram: Vec<String>,
}

/// A rewritten program.
struct Program {
    text: String,
    /// The rewritten lines, for messages.
    what: String,
}

/// The motion of a line that may be rewritten, and the block before.
fn motion(posted: &Posted, line: usize) -> Option<(&Executed, &Executed)> {
    let blocks = &posted.subject.trace.blocks;
    let index = blocks.iter().position(|block| block.line == line + 1)?;
    let block = &blocks[index];
    let text = &posted.subject.lines[line];
    let plain = text.chars().all(|letter| letter.is_ascii_alphanumeric() || " .+-".contains(letter));
    let continued = posted.subject.lines.get(line + 1).is_some_and(|next| next.starts_with(' '));
    let moves = matches!(block.effect, Effect::Rapid | Effect::Feed | Effect::Arc(_));
    let free = block.state.cycle.is_none()
        && block.state.motion != Some(MotionMode::Cycle)
        && matches!(block.state.compensation, None | Some(Compensation::Off));
    let numbered = text.starts_with('N');
    (plain && moves && free && !continued && !numbered && block.state == state_of_last(blocks, index))
        .then(|| (block, &blocks[index.saturating_sub(1)]))
}

/// State after the last block of a line: a line may hold several.
fn state_of_last(blocks: &[Executed], index: usize) -> tests::foreign::State {
    let line = blocks[index].line;
    blocks.iter().rev().find(|block| block.line == line).map_or(blocks[index].state, |block| block.state)
}

/// A word with a number that may become a variable: its place in the line, its letters and its value.
fn some_word(control: Control, text: &str, random: &mut Random) -> Option<(usize, String, f64)> {
    let words: Vec<&str> = text.split(' ').collect();
    let read = |place: usize| {
        let letters = words[place].trim_end_matches(|last: char| !last.is_ascii_alphabetic());
        let number = words[place][letters.len()..].to_owned();
        let named = matches!(letters, "X" | "Y" | "Z" | "A" | "B" | "C" | "F" | "I" | "J" | "K")
            || matches!(letters, "IX" | "IY" | "IZ") && control == Control::Heidenhain;
        let pointed = !matches!(control, Control::Fanuc | Control::Haas) || number.contains('.');
        let value = number.parse().ok().filter(|_| named && pointed)?;
        Some((place, letters.to_owned(), value))
    };
    let found: Vec<_> = (0..words.len()).filter_map(read).collect();
    (!found.is_empty()).then(|| found[random.below(found.len())].clone())
}

fn with_word(text: &str, place: usize, word: &str) -> String {
    let mut words: Vec<&str> = text.split(' ').collect();
    words[place] = word;
    words.join(" ")
}

/// One stretch, rewritten; `harm`: so that the program does something else.
fn rewritten(
    posted: &Posted,
    (start, end): (usize, usize),
    (kind, name): (Kind, usize),
    harm: bool,
    random: &mut Random,
) -> Option<Rewritten> {
    let control = posted.subject.options.control;
    let lines = &posted.subject.lines[start..end];
    let off = if harm { 1.0 } else { 0.0 };
    let times = if harm { 2 } else { 1 };
    let alone = |lines: Vec<String>| Some(Rewritten { lines, subprogram: Vec::new() });
    match kind {
        Kind::Variable => {
            let at = random.below(lines.len());
            let (place, letters, value) = some_word(control, &lines[at], random)?;
            let (set, word) = spelling::word(control, (&letters, value + off), name, random);
            let mut lines = lines.to_vec();
            lines[at] = with_word(&lines[at], place, &word);
            lines.insert(at, set);
            alone(lines)
        }
        Kind::Call => {
            let (lines, subprogram) = spelling::called(control, lines, times, name, None);
            Some(Rewritten { lines, subprogram })
        }
        Kind::Argument => {
            let at = random.below(lines.len());
            let (place, letters, value) = some_word(control, &lines[at], random)?;
            let mut lines = lines.to_vec();
            lines[at] = with_word(&lines[at], place, &spelling::argument(control, &letters));
            let (lines, subprogram) = spelling::called(control, &lines, 1, name, Some(value + off));
            Some(Rewritten { lines, subprogram })
        }
        Kind::Loop => alone(spelling::looped(control, lines, times, name, random)),
        Kind::Condition => alone(spelling::conditional(control, lines, !harm, name, random)),
        Kind::Jump if harm => alone(spelling::jumped(control, lines, name)),
        Kind::Jump => {
            let over = spelling::jumped(control, &[spelling::dead(control).to_owned()], name);
            alone([&over, lines].concat())
        }
        Kind::Distance => {
            let text = lines.first()?;
            let (block, before) = motion(posted, start)?;
            let absolute = block.state.distance == Some(Distance::Absolute) || control == Control::Heidenhain;
            let same_frame =
                before.state.tip_control == block.state.tip_control && before.state.tilt == block.state.tilt;
            let plain = !block.state.under_tip_control() && block.state.tilted_plane().is_none();
            let straight = matches!(block.effect, Effect::Rapid | Effect::Feed) && absolute && plain && same_frame;
            let axis = block.words.letters().next().filter(|axis| straight && "XYZ".contains(*axis))?;
            if block.words.letters().count() != 1 {
                return None;
            }
            let distance = block.state.position.get(axis)? - before.state.position.get(axis)?;
            let distance = (distance * 1e6).round() / 1e6;
            let place = text.find(axis).filter(|_| distance.abs() > 0.1)?;
            let length = text[place..].find(' ').unwrap_or(text.len() - place);
            let rest = (&text[..place], &text[place + length..]);
            let moved = spelling::by_distance(control, axis, distance, rest);
            let moved = spelling::looped(control, &moved, times, name, random);
            alone([&moved, &lines[1..]].concat())
        }
    }
}

/// A program with some stretches rewritten.
fn program(posted: &Posted, harm: bool, random: &mut Random) -> Option<(Program, Vec<Kind>)> {
    let subject = &posted.subject;
    let control = subject.options.control;
    let places: Vec<usize> = (0..subject.end).filter(|line| motion(posted, *line).is_some()).collect();
    if places.is_empty() {
        return None;
    }
    let mut stretches: Vec<(usize, usize)> = Vec::new();
    for _ in 0..1 + random.below(4) {
        let start = places[random.below(places.len())];
        let length = 1 + random.below(5);
        let end = (start..start + length).take_while(|line| places.contains(line)).count() + start;
        if stretches.iter().all(|(from, to)| end <= *from || start >= *to) {
            stretches.push((start, end));
        }
    }
    let harmful = random.below(stretches.len());
    let mut changes: Vec<((usize, usize), Rewritten)> = Vec::new();
    let mut kinds = Vec::new();
    for (index, stretch) in stretches.into_iter().enumerate() {
        let kind = KINDS[random.below(KINDS.len())];
        let change = rewritten(posted, stretch, (kind, index + 1), harm && index == harmful, random)?;
        kinds.push(kind);
        changes.push((stretch, change));
    }
    changes.sort_by_key(|((start, _), _)| std::cmp::Reverse(*start));
    let mut lines = subject.lines.clone();
    let what: Vec<String> = changes
        .iter()
        .rev()
        .map(|((start, end), change)| {
            let [was, is, sub] =
                [&lines[*start..*end], &change.lines, &change.subprogram].map(|lines| lines.join(" | "));
            format!("line {}: {was}\n  -> {is}\n  subprogram: {sub}", start + 1)
        })
        .collect();
    let subprograms: Vec<String> = changes.iter().flat_map(|(_, change)| change.subprogram.clone()).collect();
    // After the end code, and on LinuxCNC before the call.
    lines
        .splice(subject.end + 1..subject.end + 1, subprograms.iter().filter(|_| control != Control::LinuxCnc).cloned());
    for ((start, end), change) in changes {
        lines.splice(start..end, change.lines);
    }
    lines.splice(0..0, subprograms.into_iter().filter(|_| control == Control::LinuxCnc));
    Some((Program { text: subject.text(&lines), what: what.join("\n") }, kinds))
}

/// Programs of one control.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    /// Right for both.
    equivalent: usize,
    /// Harmful for the foreign interpreter, and found.
    harmful: usize,
    /// The foreign interpreter is not certain.
    undecided: usize,
    /// In a form that the check does not read.
    not_read: usize,
    /// A short stretch is executed twice, which the check does not find.
    retraced: usize,
    /// Of these also read by the interpreter of LinuxCNC.
    by_linuxcnc: usize,
}

/// Whether a program does the same but for points within tolerance of the straight path between their neighbours.
fn skips_points_of_path(posted: &Posted, edited: &Trace) -> bool {
    let was: Vec<&Executed> = posted.subject.trace.motions().collect();
    let is: Vec<&Executed> = edited.motions().collect();
    let same = |(was, is): (&&Executed, &&Executed)| was.state.position == is.state.position;
    let first = was.iter().zip(&is).take_while(|(was, is)| same((was, is))).count();
    let Some(next) = was.len().checked_sub(is.len()).map(|skipped| first + skipped) else { return false };
    if first == 0 || next == first || next >= was.len() || !was[next..].iter().zip(&is[first..]).all(same) {
        return false;
    }
    let point = |index: usize| ['X', 'Y', 'Z'].map(|letter| was[index].state.position.get(letter).unwrap_or(f64::NAN));
    let (from, to) = (point(first - 1), point(next));
    let minus = |one: [f64; 3], other: [f64; 3]| [one[0] - other[0], one[1] - other[1], one[2] - other[2]];
    let dot = |one: [f64; 3], other: [f64; 3]| one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    let along = minus(to, from);
    (first..next).all(|index| {
        let off = minus(point(index), from);
        let share = dot(off, along) / dot(along, along);
        let away = minus(off, along.map(|part| share * part));
        was[index].effect == Effect::Feed && dot(away, away).sqrt() <= posted.subject.allowed.linear
    })
}

/// Whether a program does the same but for motions that are executed once more.
fn retraces(posted: &Posted, edited: &Trace) -> bool {
    let positions = |trace: &Trace| trace.motions().map(|block| block.state.position).collect::<Vec<_>>();
    let (was, is) = (positions(&posted.subject.trace), positions(edited));
    let Some(more) = is.len().checked_sub(was.len()).filter(|more| *more > 0) else { return false };
    let first = was.iter().zip(&is).take_while(|(was, is)| was == is).count();
    first >= more && is[first..first + more] == is[first - more..first] && is[first + more..] == was[first..]
}

/// What is wrong with the judgements of a program; `None` if nothing is.
fn wrong(posted: &Posted, program: &Program, harm: bool, tally: &mut Tally) -> Option<String> {
    let subject = &posted.subject;
    let edited = run(&program.text, &subject.options);
    let judged = match verdict(&subject.trace, &edited, subject.allowed) {
        Verdict::Harmful(why) if edited.as_ref().is_ok_and(|edited| skips_points_of_path(posted, edited)) => {
            Verdict::Undecided(why)
        }
        judged => judged,
    };
    let findings = posted.findings(&program.text);
    let of_form = |finding: &String| {
        let called = finding.contains("`L1") || finding.contains("`SIDE");
        NOT_READ.iter().any(|text| finding.contains(text) && (called || !text.starts_with("` is")))
    };
    let not_read = findings.iter().any(of_form);
    let wrong = match (judged, findings.first()) {
        (Verdict::Harmless, Some(_)) if !harm && not_read => {
            tally.not_read += 1;
            None
        }
        (Verdict::Harmless, Some(finding)) if !harm => Some(format!("the same, falsely found: {finding}")),
        (Verdict::Harmless, None) if !harm => {
            tally.equivalent += 1;
            None
        }
        (judged, finding) if !harm => Some(format!("rewritten, but {judged:?}; the check: {finding:?}")),
        (Verdict::Harmful(_), None) if edited.is_ok_and(|edited| retraces(posted, &edited)) => {
            tally.retraced += 1;
            None
        }
        (Verdict::Harmful(why) | Verdict::Refused(why), None) => Some(format!("{why}, not found")),
        (Verdict::Harmful(_) | Verdict::Refused(_), Some(_)) if not_read => {
            tally.not_read += 1;
            None
        }
        (Verdict::Harmful(_) | Verdict::Refused(_), Some(_)) => {
            tally.harmful += 1;
            None
        }
        _ => {
            tally.undecided += 1;
            None
        }
    };
    wrong.map(|why| format!("{}, {why}\n  {}", subject.name, program.what))
}

/// What the interpreter of LinuxCNC makes of a program, if it differs from the verdict.
fn wrong_for_linuxcnc(posted: &Posted, program: &Program, harm: bool, tally: &mut Tally) -> Option<String> {
    let original = interpret(&posted.text, 0.0).ok()?;
    tally.by_linuxcnc += 1;
    let same = match interpret_edited(&program.text, &posted.text, 0.0) {
        Ok(calls) => same_calls(&original, &calls, posted.subject.allowed),
        Err(why) => Err(why),
    };
    let judged = verdict(&posted.subject.trace, &run(&program.text, &posted.subject.options), posted.subject.allowed);
    let why = match (same, judged) {
        (Err(why), Verdict::Harmless) => format!("the same for the foreign interpreter, not for LinuxCNC: {why}"),
        (Ok(()), Verdict::Harmful(why)) if harm => format!("the same for LinuxCNC, but {why}"),
        _ => return None,
    };
    Some(format!("{}, {why}\n  {}", posted.subject.name, program.what))
}

#[test]
fn variables_loops_and_subprograms_are_read_alike() {
    let count = environment::number("PP_FLOW").map_or(PROGRAMS, |count| count as usize);
    let seed = environment::number("PP_FLOW_SEED").unwrap_or(1);
    let mut programs = Vec::new();
    corpus::random(&mut programs, (count / 4).max(60), (seed << 32) + 500_000);
    programs.retain(|posted| posted.findings(&posted.text).is_empty());
    let mut random = Random::new(seed);
    let mut tallies = [Tally::default(); 5];
    let mut failures = Vec::new();
    let third_reader = installed();
    let mut made = 0;
    for attempt in 0..count * 20 {
        if made == count {
            break;
        }
        let control = Control::ALL[made % 5];
        let of_control = |posted: &&Posted| posted.subject.options.control == control;
        let of_control: Vec<&Posted> = programs.iter().filter(of_control).collect();
        let posted = of_control[random.below(of_control.len())];
        let harm = attempt % 3 == 2;
        let Some((program, kinds)) = self::program(posted, harm, &mut random) else { continue };
        let tally = &mut tallies[made % 5];
        let mut why = wrong(posted, &program, harm, tally);
        if control == Control::LinuxCnc && third_reader && why.is_none() && tally.by_linuxcnc < count / 10 {
            why = wrong_for_linuxcnc(posted, &program, harm, tally);
        }
        failures.extend(why.map(|why| format!("{} {kinds:?} {why}", control.name())));
        made += 1;
    }
    for (control, tally) in Control::ALL.iter().zip(&tallies) {
        println!("{:10} {tally:?}", control.name());
    }
    assert!(made == count, "only {made} of {count} programs");
    let decided: usize = tallies.iter().map(|tally| tally.equivalent + tally.harmful).sum();
    let shown = if environment::number("PP_FLOW").is_some() { failures.len() } else { SHOWN };
    let shown: Vec<&str> = failures.iter().take(shown).map(String::as_str).collect();
    assert!(failures.is_empty(), "{} of {count} programs fail\n{}", failures.len(), shown.join("\n"));
    let retraced: usize = tallies.iter().map(|tally| tally.retraced).sum();
    assert!(retraced * 50 <= count, "{retraced} of {count} programs execute a stretch twice and pass");
    assert!(decided * 2 > count, "only {decided} of {count} programs are decided");
}
