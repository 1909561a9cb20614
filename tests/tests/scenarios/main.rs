//! Scenarios: the files of `tests/scenarios`, whose README has their format.
//!
//! `PP_SCENARIO='words of a heading'` runs the cases whose file and heading have all these words, and prints their
//! programs; `PP_BLESS=1` rewrites expected blocks and findings: read every changed line before it is committed.

mod format;
mod hints;
mod job;
mod program;
mod remedies;
mod run;

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use format::Case;
use run::Failure;
use tests::binaries::workspace;

/// The cases of all files.
fn cases() -> Vec<Case> {
    let folder = workspace().join("tests/scenarios");
    let entries = fs::read_dir(&folder).expect("the scenarios").map(|entry| entry.expect("a file").path());
    let mut files: Vec<_> = entries
        .filter(|path| path.extension().is_some_and(|extension| extension == "md") && !path.ends_with("README.md"))
        .collect();
    files.sort();
    let (cases, faults): (Vec<_>, Vec<_>) = files.iter().map(|path| format::read(path)).partition(Result::is_ok);
    let faults: Vec<String> = faults.into_iter().filter_map(Result::err).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    cases.into_iter().flatten().flatten().collect()
}

#[test]
fn every_scenario_holds() {
    let wanted = env::var("PP_SCENARIO").unwrap_or_default().to_lowercase();
    let chosen = |case: &Case| wanted.split_whitespace().all(|word| case.title().to_lowercase().contains(word));
    let cases: Vec<Case> = cases().into_iter().filter(chosen).collect();
    assert!(!cases.is_empty(), "no heading has the words `{wanted}`");
    let failures = all(&cases, !wanted.is_empty());
    if env::var_os("PP_BLESS").is_some_and(|value| value == "1") {
        bless(&failures);
    } else {
        let count = failures.len();
        let texts: Vec<String> = failures.iter().map(Failure::to_string).collect();
        assert!(failures.is_empty(), "{count} failures in {} cases:\n\n{}", cases.len(), texts.join("\n"));
    }
}

/// Failures of all cases, in their order.
fn all(cases: &[Case], shows: bool) -> Vec<Failure> {
    let (next, failures) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(2, NonZero::get) {
            scope.spawn(|| {
                while let Some((at, case)) =
                    Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|at| Some((at, cases.get(at)?)))
                {
                    let found = catch_unwind(AssertUnwindSafe(|| run::failures(case, shows)));
                    let found = found.unwrap_or_else(|_| vec![Failure::new(case, case.line, "", "a panic", None)]);
                    failures.lock().expect("no panic").extend(found.into_iter().map(|failure| (at, failure)));
                }
            });
        }
    });
    let mut failures = failures.into_inner().expect("no panic");
    failures.sort_by_key(|(at, failure)| (*at, failure.line));
    failures.into_iter().map(|(_, failure)| failure).collect()
}

/// Rewrites the blocks whose runs all have the same new lines, from the last of a file to its first.
fn bless(failures: &[Failure]) {
    let mut blocks: BTreeMap<(&Path, usize), Vec<&Failure>> = BTreeMap::new();
    for failure in failures {
        blocks.entry((&failure.file, failure.line)).or_default().push(failure);
    }
    let mut left = Vec::new();
    for ((file, line), failures) in blocks.into_iter().rev() {
        match &failures[0].blessed {
            Some(lines) if failures.iter().all(|other| other.blessed.as_ref() == Some(lines)) => {
                let text = fs::read_to_string(file).expect("it was read");
                let old: Vec<&str> = text.lines().collect();
                let end = line + old[line..].iter().position(|line| line.starts_with("```")).expect("the block ends");
                let new: Vec<&str> = lines.iter().map(String::as_str).collect();
                fs::write(file, [&old[..line], &new, &old[end..]].concat().join("\n") + "\n").expect("it is written");
                println!("{}:{line}: rewritten", file.display());
            }
            _ => left.extend(failures.iter().map(|failure| failure.to_string())),
        }
    }
    assert!(
        left.is_empty(),
        "these cannot be rewritten, or not to the same lines for all runs:\n\n{}",
        left.join("\n")
    );
}

/// Every hint of the sources has a case that follows it.
#[test]
fn every_remedy_is_followed() {
    let missing = remedies::without_case(&cases());
    assert!(missing.is_empty(), "{} hints:\n{}", missing.len(), missing.join("\n"));
}
