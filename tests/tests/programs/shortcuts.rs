//! Shortcuts off and on: program, summary and findings are the same, whichever of them are taken.
//!
//! Every golden program and random jobs are posted and checked with all shortcuts, with each one off, with all off, and
//! with each one alone. So are damaged copies of each program, which have findings. `PP_SHORTCUTS=N` sets the number of
//! random jobs.

use std::collections::BTreeMap;
use std::io::Cursor;

use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Control;
use pp_runtime::inside::{Shortcut, without};
use pp_runtime::kinematics::Machine;
use pp_runtime::post::{Job, post};
use tests::binaries::golden_programs;
use tests::by_name;
use tests::damage::damage;
use tests::environment;
use tests::golden::Golden;
use tests::random::Random;
use tests::with_machine;

use super::random_programs::Case;

/// Number of random jobs in a test run.
const JOBS: u64 = 200;

/// All that a user sees of a job.
#[derive(Debug, PartialEq)]
struct Seen {
    program: String,
    /// Summary and diagnostics of the post.
    report: Vec<String>,
    /// Summary and findings of the check, and the fault of the CL data.
    checked: Vec<String>,
    /// The same of damaged programs.
    damaged: Vec<String>,
}

/// Posts and checks a job.
fn seen<M: Machine>(config: &Config, control: &'static dyn Control, cl: &str, seed: u64) -> Seen {
    let job = Job { cl_name: "part.cls", config, control, units: None };
    let mut program = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl), &mut program).expect("memory can be written");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let checked = |program: &[u8]| -> Vec<String> {
        let checked = check::<M>(&policy, Cursor::new(cl), program).expect("it can be read");
        let findings = checked.outcome.findings.iter().map(|finding| format!("{:?}", finding.diagnostic()));
        let fault = checked.fault.iter().map(|fault| format!("{fault:?}"));
        [checked.outcome.summary()].into_iter().chain(findings).chain(fault).collect()
    };
    let mut said = report.summary();
    said.extend(report.diagnostics.iter().map(|diagnostic| format!("{diagnostic:?}")));
    Seen {
        checked: checked(&program),
        damaged: damaged(&program, seed).iter().flat_map(|program| checked(program)).collect(),
        program: String::from_utf8(program).expect("ASCII"),
        report: said,
    }
}

/// The program with a random fault, with a digit more in one of its F words, and with the spindle off at a place in its
/// middle.
fn damaged(program: &[u8], seed: u64) -> [Vec<u8>; 3] {
    let random = &mut Random::new(seed);
    let (faulty, _) = damage(program, random);
    let is_feed = |at: &usize| program[*at] == b'F' && program[*at + 1].is_ascii_digit() && program[*at - 1] == b' ';
    let feeds: Vec<usize> = (1..program.len() - 1).filter(is_feed).collect();
    let feed = feeds.get(random.below(feeds.len().max(1))).map_or(program.len(), |at| at + 1);
    let middle = program.len() / 3 + random.below(program.len() / 3);
    let line = program[middle..].iter().position(|byte| *byte == b'\n').map_or(program.len(), |end| middle + end + 1);
    let with = |at: usize, text: &[u8]| [&program[..at], text, &program[at..]].concat();
    [faulty, with(feed, b"1"), with(line, b"M5\n")]
}

/// Sets of shortcuts that are off, each with its name.
fn sets() -> impl Iterator<Item = (String, Vec<Shortcut>)> {
    let all = Shortcut::ALL;
    let off = all.iter().map(|shortcut| (format!("without {shortcut:?}"), vec![*shortcut]));
    let alone = all
        .iter()
        .map(|alone| (format!("{alone:?} alone"), all.iter().filter(|shortcut| *shortcut != alone).copied().collect()));
    off.chain(alone).chain([("without any".to_owned(), all.to_vec())])
}

/// Compares a job with every set of shortcuts, and returns the sets that differ, with the first line that does.
fn differing(see: impl Fn() -> Seen) -> Vec<String> {
    let expected = see();
    let differs = |(name, off): (String, Vec<Shortcut>)| {
        let seen = without(&off, &see);
        let lines = |seen: &Seen| {
            let program = seen.program.lines().map(str::to_owned);
            program
                .chain(seen.report.clone())
                .chain(seen.checked.clone())
                .chain(seen.damaged.clone())
                .collect::<Vec<_>>()
        };
        (seen != expected).then(|| {
            let (expected, found) = (lines(&expected), lines(&seen));
            let first = expected.iter().zip(&found).find(|(expected, found)| expected != found);
            format!("{name}: {first:?}")
        })
    };
    sets().filter_map(differs).collect()
}

fn of_golden<M: Machine>(golden: &Golden) -> Vec<String> {
    let config = golden.config::<M>();
    differing(|| seen::<M>(&config, golden.control, &golden.cl, 1))
}

fn of_case<M: Machine>(case: &Case, seed: u64) -> Option<Vec<String>> {
    let config = case.config::<M>().ok()?;
    Some(differing(|| seen::<M>(&config, case.control, &case.cl, seed)))
}

/// Fails with what differs, by job.
fn assert_same(differences: &BTreeMap<String, Vec<String>>) {
    assert!(differences.values().all(Vec::is_empty), "{differences:#?}");
}

/// Golden programs of one half, so that both halves run at once.
fn golden_half(half: usize) {
    let goldens = golden_programs().into_iter().skip(half).step_by(2).map(|path| Golden::read(&path));
    let compared = |golden: Golden| {
        let differences = with_machine!(&*golden.machine, of_golden(&golden));
        (!differences.is_empty()).then_some((golden.name, differences))
    };
    assert_same(&goldens.filter_map(compared).collect());
}

#[test]
fn golden_programs_are_the_same_with_and_without_shortcuts() {
    golden_half(0);
}

#[test]
fn the_other_golden_programs_are_the_same_with_and_without_shortcuts() {
    golden_half(1);
}

/// Motions whose tip would leave its line in one block, arcs within the travel of X, and an arc that leaves it between
/// its ends.
#[test]
fn motions_that_bounds_decide_are_the_same_with_and_without_shortcuts() {
    let curved = "GOTO/20,0,0,0,0,1\nGOTO/60,30,10,0.5,0,0.8660254\nGOTO/10,40,10,0,0.7071068,0.7071068\n";
    let inside = "GOTO/20,0,0,0,0,1\nCIRCLE/0,0,0,0,0,1,20\nGOTO/0,20,0\nCIRCLE/0,0,0,0,0,1,20\nGOTO/-20,0,0\n";
    let outside = "GOTO/24,-7,0,0,0,1\nCIRCLE/0,0,0,0,0,1,25\nGOTO/24,7,0\n";
    let keys = "mode = \"axes\"\npart_origin = [0.0, 0.0, 0.0]\nmachine_zero.X = 0.0\nlimits.X = [-500.0, 24.5]\n\
                cl.circle_sense = \"ccw\"\n";
    for (path, keys, is_refused) in [
        (curved, &keys.replace("24.5", "500.0"), false),
        (inside, &keys.to_owned(), false),
        (outside, &keys.to_owned(), true),
    ] {
        let cl = format!(
            "UNITS/MM\nLOADTL/1,LENGTH,100\nSPINDL/RPM,2000,CLW\nFEDRAT/MMPM,300\nRAPID\nGOTO/20,0,50,0,0,1\n{path}RAPID\n\
             GOTO/0,0,90\nFINI\n"
        );
        for control in by_name::controls().map(by_name::control) {
            let config = starting_point(control).read_over(&SpinnerU5620::default(), keys).expect("it is valid");
            let see = || seen::<SpinnerU5620>(&config, control, &cl, 3);
            let refused = see().report.iter().any(|line| line.contains("severity: Error"));
            assert_eq!(refused, is_refused, "{path}");
            assert_eq!(differing(see), Vec::<String>::new(), "{path}");
        }
    }
}

#[test]
fn random_jobs_are_the_same_with_and_without_shortcuts() {
    let count = environment::number("PP_SHORTCUTS").unwrap_or(JOBS);
    let mut differences = BTreeMap::new();
    let (mut seed, mut posted) = (540_000, 0);
    while posted < count {
        let case = Case::of(seed);
        if let Some(different) = with_machine!(case.kind.name, of_case(&case, seed)) {
            posted += 1;
            if !different.is_empty() {
                differences.insert(format!("seed {seed}, {}", case.name()), different);
            }
        }
        seed += 1;
    }
    assert_same(&differences);
}
