//! The plain call.

use std::io::{Seek as _, SeekFrom};
use std::sync::LazyLock;

use super::*;
use crate::control::{CONTROLS, Spellings};

/// LinuxCNC with a code before the tool change that its family does not have, and whose effect it does not declare.
struct Undeclared;

static CODES: LazyLock<Spellings> = LazyLock::new(|| Spellings {
    name: "undeclared",
    tool_change: &["M140", "T{tool} M6"],
    ..LinuxCnc.spellings().clone()
});

impl Control for Undeclared {
    fn spellings(&self) -> &'static Spellings {
        &CODES
    }
    fn base(&self) -> Option<&'static dyn Control> {
        Some(&LinuxCnc)
    }
}

fn job<'a>(config: &'a Config, control: &'a dyn Control) -> Job<'a> {
    Job { cl_name: "bracket.cls", config, control, units: None }
}

#[test]
fn the_checked_program_is_the_posted_one() {
    let mut config = Config::default();
    config.motion.guards.offset_guard = false;
    let (text, report) = posted::<Cb>(&config, PART);
    // The CL data may begin after something else.
    let mut input = Cursor::new(format!("GARBAGE/1{PART}"));
    input.seek(SeekFrom::Start(9)).expect("in memory");
    let program = post_checked::<Cb>(&job(&config, &LinuxCnc), &mut input).expect("memory neither fails nor fills");
    assert_eq!(program.program(), Some(text.as_bytes()));
    assert_eq!(program.report, report);
    assert!(program.checked.expect("a check").outcome.blocks > 0);
}

#[test]
fn the_figures_of_the_check_come_before_the_end_where_they_are_wanted() {
    for control in CONTROLS.iter().copied() {
        let post = |keys: &str| {
            let config =
                Config::read::<Cb>(&format!("part_origin = [0.0, 0.0, 0.0]\nretract.distance = 50.0\n{keys}"), control);
            let config = config.expect("a configuration");
            let posted = post_checked::<Cb>(&job(&config, control), &mut Cursor::new(PART)).expect("it fits");
            let findings = posted.checked.as_ref().map(|checked| &checked.outcome.findings);
            assert!(posted.program().is_some(), "{:?} {findings:?}", posted.report.diagnostics);
            String::from_utf8(posted.unchecked_text().to_vec()).expect("UTF-8")
        };
        let (without, with) = (post(""), post("program.checked = true\n"));
        let lines = |text: &str| -> Vec<String> {
            text.lines().map(|line| line.trim_start_matches(char::is_numeric).to_owned()).collect()
        };
        let (without, with) = (lines(&without), lines(&with));
        let body = without.len() - ProgramEnd::of(control).lines;
        let after = with.len() - ProgramEnd::of(control).lines;
        assert_eq!((&with[..body], &with[after..]), (&without[..body], &without[body..]));
        let comment = with[body..after].concat().to_uppercase();
        assert!(comment.contains("CHECKED") && comment.contains("MOTION BLOCKS"), "{comment}");
    }
}

#[test]
fn a_program_with_findings_is_not_given_as_a_program() {
    let config = Config::default();
    let posted = post_checked::<Cb>(&job(&config, &Undeclared), &mut Cursor::new(PART)).expect("it fits");
    assert!(!posted.report.failed && posted.program().is_none());
    let findings = &posted.checked.as_ref().expect("a check").outcome.findings;
    assert!(findings[0].text.contains("M140"), "{findings:?}");
    assert!(posted.unchecked_text().windows(4).any(|word| word == b"M140"));
}

#[test]
fn cl_data_with_an_error_gives_no_program() {
    let config = Config::default();
    let text = PART.replace("COOLNT/ON", "COOLNT/OM");
    let posted = post_checked::<Cb>(&job(&config, &LinuxCnc), &mut Cursor::new(text)).expect("it fits");
    assert!(posted.report.failed && posted.checked.is_none() && posted.program().is_none());
}
