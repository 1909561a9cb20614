//! Tests of the command line: the files that a run leaves, and the values taken from options and configuration.

mod checked;
mod kinematics;
mod messages;
#[cfg(feature = "simulate")]
mod simulate;
mod streams;

use std::cell::RefCell;
use std::fs;
use std::io::{self, Read, Seek as _, Write};
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::cl_source::ClSource;
use super::posting::{PostFn, ProgramSink};
use super::*;
use crate::config::Config;
use crate::config::sample::Sample;
use crate::diag::code::cl;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::Machine;
use crate::post::{Job, LineMap, PostError, Report};
use crate::program::Location;
use crate::program::Units;

/// Exit status and text on the standard streams of a run.
struct Outcome {
    status: Status,
    output: String,
    errors: String,
}

fn run_with(args: &[&str], input: &[u8], post: PostFn<'_>) -> Outcome {
    run_on::<Sample>(args, input, post)
}

/// Runs the command line of machine `M`.
fn run_on<M: Machine>(args: &[&str], input: &[u8], post: PostFn<'_>) -> Outcome {
    let args: Vec<OsString> = ["/bin/sample_post.exe"].iter().chain(args).map(OsString::from).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &*input, output: &mut output, errors: &mut errors, terminal: false };
    let status = execute(&M::default(), &[], &args, streams, post);
    let text = |bytes| String::from_utf8(bytes).expect("messages are text");
    Outcome { status, output: text(output), errors: text(errors) }
}

/// Reads the text twice, as posting does, and writes it after a `;`.
fn echo(
    _job: &Job<'_>,
    source: &mut ClSource,
    sink: &mut ProgramSink<'_>,
    _: Option<&mut dyn LineMap>,
) -> Result<Report, PostError> {
    let (mut first, mut second) = (Vec::new(), Vec::new());
    source.read_to_end(&mut first).map_err(PostError::Input)?;
    source.rewind().map_err(PostError::Input)?;
    source.read_to_end(&mut second).map_err(PostError::Input)?;
    assert_eq!(first, second);
    sink.write_all(b";").and_then(|()| sink.write_all(&second)).map_err(PostError::Output)?;
    Ok(Report { assumptions: vec!["part zero is the table's reference point".to_owned()], ..Report::default() })
}

fn finding(severity: Severity, line: u64, column: u32, length: u32, text: &str, help: Option<&str>) -> Diagnostic {
    let (text, help) = (text.to_owned(), help.map(str::to_owned));
    Diagnostic { code: cl::SYNTAX, severity, location: Location { line, column }, length, text, help, count: 1 }
}

/// Writes one block and then reports an error in line 2.
fn fails_in_line_2(
    _job: &Job<'_>,
    _source: &mut ClSource,
    sink: &mut ProgramSink<'_>,
    _: Option<&mut dyn LineMap>,
) -> Result<Report, PostError> {
    sink.write_all(b"G0 X0\n(error)\n").map_err(PostError::Output)?;
    let error = finding(Severity::Error, 2, 6, 3, "GOTO needs 3 or 6 numbers (found 1)", Some("write X, Y and Z"));
    Ok(Report { diagnostics: vec![error], failed: true, ..Report::default() })
}

fn never(
    _job: &Job<'_>,
    _source: &mut ClSource,
    _sink: &mut ProgramSink<'_>,
    _: Option<&mut dyn LineMap>,
) -> Result<Report, PostError> {
    panic!("there is nothing to post")
}

/// A directory with CL data in it.
struct Shop {
    directory: TempDir,
}

impl Shop {
    fn new() -> Self {
        let shop = Self { directory: TempDir::new().expect("a temporary directory") };
        shop.write("part.cls", "PARTNO A\nGOTO/1.0\n");
        shop
    }

    fn path(&self, name: &str) -> PathBuf {
        self.directory.path().join(name)
    }

    fn arg(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).expect("the directory is writable");
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.directory.path()).expect("the directory is readable");
        let mut names: Vec<String> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn post(&self, extra: &[&str], post: PostFn<'_>) -> Outcome {
        let (input, output) = (self.arg("part.cls"), self.arg("part.ngc"));
        // The output of these tests is no program that could be checked.
        let mut args = vec!["post", &input, "-o", &output, "--no-check"];
        args.extend(extra);
        run_with(&args, b"", post)
    }
}

#[test]
fn a_program_has_its_final_name_when_it_is_done() {
    let shop = Shop::new();
    let outcome = shop.post(&[], &echo);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert_eq!(shop.text("part.ngc"), ";PARTNO A\nGOTO/1.0\n");
    assert_eq!(shop.names(), ["part.cls", "part.ngc"]);
    assert_eq!(outcome.output, "");
    assert!(outcome.errors.contains("assumed: part zero is the table's reference point\n"), "{}", outcome.errors);
    assert!(outcome.errors.ends_with("\ndone\n"), "{}", outcome.errors);
}

#[test]
fn the_final_name_does_not_exist_while_the_program_is_written() {
    let shop = Shop::new();
    let out = shop.path("part.ngc");
    let outcome = shop.post(&[], &|job, source, sink, line_map| {
        let report = echo(job, source, sink, line_map)?;
        sink.flush().map_err(PostError::Output)?;
        assert!(!out.exists());
        Ok(report)
    });
    assert_eq!(outcome.status, Status::Done);
    assert!(out.exists());
}

#[test]
fn an_error_in_the_cl_data_leaves_only_a_rejected_program() {
    let shop = Shop::new();
    shop.write("part.ngc", "yesterday");
    let outcome = shop.post(&[], &fails_in_line_2);
    assert_eq!(outcome.status, Status::Rejected);
    assert_eq!(shop.names(), ["part.cls", "part.ngc.earlier", "part.ngc.rejected"]);
    assert_eq!(shop.text("part.ngc.earlier"), "yesterday");
    let rejected = shop.text("part.ngc.rejected");
    let lines: Vec<&str> = rejected.lines().collect();
    assert!(lines[0].starts_with("(REJECTED ") && lines[0].ends_with("GOTO needs 3 or 6 numbers [found 1])"));
    assert!(lines[0].contains("part.cls:2:6: error: "), "{}", lines[0]);
    assert_eq!(lines[1..], ["G0 X0", "(error)"]);
    let (input, output) = (shop.arg("part.cls"), shop.arg("part.ngc"));
    assert_eq!(
        outcome.errors,
        format!(
            "{input}:2:6: error: GOTO needs 3 or 6 numbers (found 1)\n  |\n2 | GOTO/1.0\n  |      ^^^\n  |\n  = \
             help: write X, Y and Z\n{input}: 1 error\n\
             rejected: {output} was not written; the incomplete program is in {output}.rejected; \
             the earlier {output} is in {output}.earlier now\n"
        )
    );
}

#[test]
fn an_error_diagnostic_rejects_even_if_the_report_is_not_marked_as_failed() {
    let shop = Shop::new();
    let outcome = shop.post(&[], &|job, source, sink, line_map| {
        Ok(Report { failed: false, ..fails_in_line_2(job, source, sink, line_map)? })
    });
    assert_eq!(outcome.status, Status::Rejected);
    assert!(!shop.path("part.ngc").exists());
}

#[test]
fn a_warning_does_not_reject() {
    let shop = Shop::new();
    let outcome = shop.post(&[], &|job, source, sink, line_map| {
        let warning = finding(Severity::Warning, 1, 1, 6, "the name is short", None);
        Ok(Report { diagnostics: vec![warning], ..echo(job, source, sink, line_map)? })
    });
    assert_eq!(outcome.status, Status::Done);
    assert!(outcome.errors.contains("part.cls:1:1: warning: the name is short\n  |\n1 | PARTNO A\n  | ^^^^^^\n"));
    assert!(outcome.errors.ends_with("done\n"));
}

#[test]
fn a_rejected_program_of_an_earlier_run_is_removed_when_the_next_run_is_done() {
    let shop = Shop::new();
    shop.post(&[], &fails_in_line_2);
    let outcome = shop.post(&[], &echo);
    assert_eq!(shop.names(), ["part.cls", "part.ngc"]);
    assert!(outcome.errors.contains("part.ngc.rejected of an earlier run\ndone\n"), "{}", outcome.errors);
}

#[test]
fn a_file_that_is_not_ours_stays_although_it_is_called_rejected() {
    let shop = Shop::new();
    shop.write("part.ngc.rejected", "mine");
    shop.post(&[], &echo);
    assert_eq!(shop.text("part.ngc.rejected"), "mine");
}

#[test]
fn the_command_line_takes_precedence_over_the_configuration_file() {
    let shop = Shop::new();
    shop.write("shop.toml", "cl_units = 'mm'\nwork_offset = 'G55'\n");
    let seen = RefCell::new(None);
    let flags = ["--config", &shop.arg("shop.toml"), "--units", "in", "--output-units", "mm", "--line-numbers"];
    let outcome = shop.post(&flags, &|job, source, sink, line_map| {
        *seen.borrow_mut() = Some((job.config.clone(), job.units));
        echo(job, source, sink, line_map)
    });
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    let (config, units) = seen.into_inner().expect("it was posted");
    assert_eq!(config.set_up.work_offset, "G55");
    assert_eq!((config.cl_units, units), (Some(Units::Inches), Some(Units::Inches)));
    assert!(config.cl.units_confirmed, "the command line answers for this file");
    assert_eq!(config.output_units, Some(Units::Millimetres));
    assert_eq!(config.control.program.line_numbers, crate::control::BlockNumbers::Step(Config::LINE_NUMBER_STEP));
    assert!(config.is_given("output_units"));
}

#[test]
fn a_fault_in_the_configuration_is_shown_with_its_line_and_is_status_2() {
    let shop = Shop::new();
    shop.write("shop.toml", "[retract]\ndistnace = 3\n");
    let outcome = shop.post(&["--config", &shop.arg("shop.toml")], &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(
        outcome.errors.contains(
            "shop.toml:2:1: error: unknown key `retract.distnace`; did you mean `distance`?\n  |\n2 | distnace = 3\n  | ^^^^^^^^\n"
        ),
        "{}",
        outcome.errors
    );
    assert_eq!(shop.names(), ["part.cls", "shop.toml"]);
}

#[test]
fn an_assumed_unit_of_the_configuration_is_reported() {
    let shop = Shop::new();
    shop.write("shop.toml", "floor = -3\n");
    let outcome = shop.post(&["--config", &shop.arg("shop.toml")], &echo);
    assert!(outcome.errors.contains("assumed: lengths of the configuration file are in mm"), "{}", outcome.errors);
}

#[test]
fn bad_arguments_are_status_2_and_help_is_status_0() {
    for args in [&["post"][..], &[], &["post", "a", "--control", "abacus"]] {
        let outcome = run_with(args, b"", &never);
        assert_eq!(outcome.status, Status::NotRun, "{args:?}");
        assert_eq!(outcome.output, "");
        assert!(!outcome.errors.is_empty());
    }
    let outcome = run_with(&["post", "--help"], b"", &never);
    assert_eq!(outcome.status, Status::Done);
    assert!(outcome.output.contains("Usage: sample_post post"), "{}", outcome.output);
}

#[test]
fn help_calls_the_command_by_the_name_of_its_file() {
    let outcome = run_with(&["--version"], b"", &never);
    assert!(outcome.output.starts_with("sample_post "), "{}", outcome.output);
    assert!(outcome.output.contains(" (kinematics "), "{}", outcome.output);
    let outcome = run_with(&["--help"], b"", &never);
    assert!(outcome.output.contains("Postprocessor for Sample"), "{}", outcome.output);
}

#[test]
fn config_prints_a_file_that_post_accepts() {
    let shop = Shop::new();
    let outcome = run_with(&["config"], b"", &never);
    assert_eq!(outcome.status, Status::Done);
    shop.write("shop.toml", &outcome.output);
    assert_eq!(shop.post(&["--config", &shop.arg("shop.toml")], &echo).status, Status::Done);
}

#[test]
fn explain_prints_the_derivation_without_empty_headings() {
    let outcome = run_with(&["explain"], b"", &never);
    assert_eq!(outcome.status, Status::Done);
    assert!(outcome.output.starts_with("Sample"), "{}", outcome.output);
    assert!(outcome.output.contains("\n    C B | X Y Z\n"), "{}", outcome.output);
    assert!(!outcome.output.contains("Proven"), "{}", outcome.output);
    assert!(outcome.output.lines().all(|line| line == line.trim_end()), "{}", outcome.output);
}

#[test]
fn explain_writes_a_whole_latex_document() {
    let outcome = run_with(&["explain", "--latex"], b"", &never);
    assert_eq!(outcome.status, Status::Done);
    assert!(outcome.output.starts_with("\\documentclass"), "{}", outcome.output);
    assert!(outcome.output.contains("\n\\section*{Chain}\n\n$C$ $B$ $X$ $Y$ $Z$\n"), "{}", outcome.output);
    assert!(outcome.output.ends_with("\n\\end{document}\n"), "{}", outcome.output);
    assert!(!outcome.output.contains("Proven"), "{}", outcome.output);
}
