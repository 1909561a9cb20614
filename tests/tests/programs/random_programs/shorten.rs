//! Shortening of a failing case: lines are removed as long as it fails with the same fault.

use super::{Case, Outcome, fault_kind};

/// Text of the shortest form of a case, with its fault.
pub(crate) fn shown(case: &Case) -> String {
    let (case, text, program) = shortest(case);
    let program = String::from_utf8_lossy(&program);
    let (name, set_up) = (case.name(), case.set_up.trim());
    format!("{name}\n{text}\n--- configuration\n{set_up}\n--- CL data\n{}--- program\n{program}", case.cl)
}

fn shortest(case: &Case) -> (Case, String, Vec<u8>) {
    let Outcome::Wrong(text, _) = case.run() else {
        return (case.clone(), "it does not fail when it is run again".to_owned(), Vec::new());
    };
    let kind = fault_kind(&text);
    let fails = |case: &Case| matches!(case.run(), Outcome::Wrong(text, _) if fault_kind(&text) == kind);
    let mut case = case.clone();
    loop {
        let before = case.cl.len() + case.set_up.len();
        let with = |cl: String| Case { cl, ..case.clone() };
        let cl = fewer(&case.cl, |cl| fails(&with(cl)));
        case.cl = cl;
        let with = |set_up: String| Case { set_up, ..case.clone() };
        let set_up = fewer(&case.set_up, |set_up| fails(&with(set_up)));
        case.set_up = set_up;
        if case.cl.len() + case.set_up.len() == before {
            break;
        }
    }
    match case.run() {
        Outcome::Wrong(text, program) => (case, text, program),
        other => (case, format!("{other:?}"), Vec::new()),
    }
}

/// Removes lines that do not matter from a text, in groups of decreasing size.
fn fewer(text: &str, fails: impl Fn(String) -> bool) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    let mut group = lines.len().div_ceil(2);
    while group > 0 {
        let mut at = 0;
        while at < lines.len() {
            let end = (at + group).min(lines.len());
            let rest = [&lines[..at], &lines[end..]].concat();
            if fails(format!("{}\n", rest.join("\n"))) {
                lines = rest;
            } else {
                at = end;
            }
        }
        group /= 2;
    }
    format!("{}\n", lines.join("\n"))
}
