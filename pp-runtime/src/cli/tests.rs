use std::cell::RefCell;
use std::fs;
use std::io::Seek as _;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use tempfile::TempDir;

use super::posting::Sink;
use super::*;
use crate::config::Units;
use crate::config::sample::Sample;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::Machine;
use crate::motion::machines::Cb;
use crate::post::{Account, Job, PostError, Report};
use crate::program::Location;

/// What a run leaves on the streams.
struct Outcome {
    status: Status,
    output: String,
    errors: String,
}

fn run_with(args: &[&str], input: &[u8], post: Post<'_>) -> Outcome {
    run_on::<Sample>(args, input, post)
}

/// On a machine of its own.
fn run_on<M: Machine>(args: &[&str], input: &[u8], post: Post<'_>) -> Outcome {
    let args: Vec<OsString> = ["/bin/sample_post.exe"].iter().chain(args).map(OsString::from).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &*input, output: &mut output, errors: &mut errors, terminal: false };
    let status = execute::<M>(&args, streams, post);
    let text = |bytes| String::from_utf8(bytes).expect("messages are text");
    Outcome { status, output: text(output), errors: text(errors) }
}

/// Reads the text twice, as the posting does, and writes it behind a `;`.
fn echo(
    _job: &Job<'_>,
    source: &mut Source,
    sink: &mut Sink<'_>,
    _: Option<&mut dyn Account>,
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
    Diagnostic { severity, location: Location { line, column }, length, text, help, count: 1 }
}

/// Writes one block and then finds an error in line 2.
fn stumble(
    _job: &Job<'_>,
    _source: &mut Source,
    sink: &mut Sink<'_>,
    _: Option<&mut dyn Account>,
) -> Result<Report, PostError> {
    sink.write_all(b"G0 X0\n(error)\n").map_err(PostError::Output)?;
    let error = finding(Severity::Error, 2, 6, 3, "GOTO needs 3 or 6 numbers (found 1)", Some("write X, Y and Z"));
    Ok(Report { diagnostics: vec![error], failed: true, ..Report::default() })
}

fn never(
    _job: &Job<'_>,
    _source: &mut Source,
    _sink: &mut Sink<'_>,
    _: Option<&mut dyn Account>,
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

    fn post(&self, extra: &[&str], post: Post<'_>) -> Outcome {
        let (input, output) = (self.arg("part.cls"), self.arg("part.ngc"));
        // What these tests post is no program.
        let mut args = vec!["post", &input, "-o", &output, "--no-check"];
        args.extend(extra);
        run_with(&args, b"", post)
    }
}

#[test]
fn a_program_stands_under_its_name_when_it_is_done() {
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
fn nothing_stands_under_the_final_name_while_the_program_is_written() {
    let shop = Shop::new();
    let out = shop.path("part.ngc");
    let outcome = shop.post(&[], &|job, source, sink, account| {
        let report = echo(job, source, sink, account)?;
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
    let outcome = shop.post(&[], &stumble);
    assert_eq!(outcome.status, Status::Rejected);
    assert_eq!(shop.names(), ["part.cls", "part.ngc.rejected"]);
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
             rejected: {output} was not written, what could be posted stands in {output}.rejected; \
             the earlier {output} was removed\n"
        )
    );
}

#[test]
fn an_error_diagnostic_rejects_even_if_the_report_does_not_say_failed() {
    let shop = Shop::new();
    let outcome = shop
        .post(&[], &|job, source, sink, account| Ok(Report { failed: false, ..stumble(job, source, sink, account)? }));
    assert_eq!(outcome.status, Status::Rejected);
    assert!(!shop.path("part.ngc").exists());
}

#[test]
fn a_warning_does_not_reject() {
    let shop = Shop::new();
    let outcome = shop.post(&[], &|job, source, sink, account| {
        let warning = finding(Severity::Warning, 1, 1, 6, "the name is short", None);
        Ok(Report { diagnostics: vec![warning], ..echo(job, source, sink, account)? })
    });
    assert_eq!(outcome.status, Status::Done);
    assert!(outcome.errors.contains("part.cls:1:1: warning: the name is short\n  |\n1 | PARTNO A\n  | ^^^^^^\n"));
    assert!(outcome.errors.ends_with("done\n"));
}

#[test]
fn a_rejected_program_of_an_earlier_run_goes_when_the_next_run_is_done() {
    let shop = Shop::new();
    shop.post(&[], &stumble);
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

/// CL data of a small part.
const PART: &str = "UNITS/MM\nTOOL PATH/FACE,TOOL,MILL\nLOADTL/1\nSPINDL/RPM,3000,CLW\nCOOLNT/ON\nFEDRAT/MMPM,500\n\
    RAPID\nGOTO/0,0,50,0,0,1\nRAPID\nGOTO/0,0,5\nGOTO/0,0,-1\nGOTO/40,0,-1\nGOTO/40,20,-1\nRAPID\nGOTO/40,20,50\nFINI\n";

/// Posts for real, and changes the program on its way out.
fn tampered(
    from: &'static str,
    to: &'static str,
) -> impl Fn(&Job<'_>, &mut Source, &mut Sink<'_>, Option<&mut dyn Account>) -> Result<Report, PostError> {
    move |job, source, sink, _| {
        let mut program = Vec::new();
        let report = crate::post::post::<Cb>(job, source, &mut program)?;
        let text = String::from_utf8(program).expect("ASCII").replace(from, to);
        sink.write_all(text.as_bytes()).map_err(PostError::Output)?;
        Ok(report)
    }
}

/// Posts a part without `--no-check`, to a file.
fn posted(shop: &Shop, post: Post<'_>) -> Outcome {
    shop.write("part.cls", PART);
    run_on::<Cb>(&["post", &shop.arg("part.cls"), "-o", &shop.arg("part.ngc")], b"", post)
}

#[test]
fn a_program_that_passes_its_check_says_so() {
    let shop = Shop::new();
    let outcome = posted(&shop, &tampered("", ""));
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert!(
        outcome.errors.contains("\nchecked: ") && outcome.errors.contains("0 outside limits\n"),
        "{}",
        outcome.errors
    );
    assert!(shop.text("part.ngc").ends_with("M2\n"));
}

#[test]
fn a_program_that_does_not_pass_its_check_is_not_handed_over() {
    for (from, to, what) in [
        ("X40", "X41", "serves no motion"),
        ("M3", "M4", "the other way round"),
        ("F500", "F5000", "F is 5000"),
        ("M8\n", "", "coolant"),
        ("G53 G0 Z0\nG43", "G43", "without having come there by the approach"),
    ] {
        let shop = Shop::new();
        let outcome = posted(&shop, &tampered(from, to));
        assert_eq!(outcome.status, Status::Rejected, "{from} became {to}: {}", outcome.errors);
        assert!(outcome.errors.contains(what), "{from} became {to}: {}", outcome.errors);
        assert_eq!(shop.names(), ["part.cls", "part.ngc.rejected"]);
        let rejected = shop.text("part.ngc.rejected");
        assert!(
            rejected.starts_with("(REJECTED ") && rejected.ends_with("(the program ends here: do not run it)\n"),
            "{rejected}"
        );
        assert!(!rejected.contains("\nM2\n"), "{rejected}");
    }
}

#[test]
fn a_rejected_program_on_standard_output_has_no_end_code() {
    let outcome = run_on::<Cb>(&["post", "-"], PART.as_bytes(), &tampered("X40", "X41"));
    assert_eq!(outcome.status, Status::Rejected);
    assert!(outcome.output.ends_with("(the program ends here: do not run it)\n"), "{}", outcome.output);
    assert!(!outcome.output.contains("\nM2\n"));
}

#[test]
fn check_names_both_lines_and_has_its_status() {
    let shop = Shop::new();
    assert_eq!(posted(&shop, &tampered("", "")).status, Status::Done);
    let check = |extra: &[&str]| {
        let (input, program) = (shop.arg("part.cls"), shop.arg("part.ngc"));
        let mut args = vec!["check", &input, &program];
        args.extend(extra);
        run_on::<Cb>(&args, b"", &never)
    };
    assert_eq!(check(&[]).status, Status::Done);
    shop.write("part.ngc", &shop.text("part.ngc").replace("X40", "X41"));
    let outcome = check(&[]);
    assert_eq!(outcome.status, Status::Rejected);
    assert!(
        outcome.errors.contains("part.cls:12:1: error: ") && outcome.errors.contains(" of the program is `"),
        "{}",
        outcome.errors
    );
    assert!(outcome.errors.contains("GOTO/40,0,-1"), "{}", outcome.errors);
    let figures: serde_json::Value = serde_json::from_str(&check(&["--json"]).output).expect("an object");
    assert_eq!(figures["passed"], serde_json::Value::Bool(false));
    assert_eq!(
        run_with(&["check", &shop.arg("part.cls"), &shop.arg("nowhere.ngc")], b"", &never).status,
        Status::NotRun
    );
}

#[test]
fn standard_input_is_spooled_and_read_twice() {
    let outcome = run_with(&["post", "-", "--no-check"], b"GOTO/1,2,3\n", &|job, source, sink, account| {
        assert_eq!(job.cl_name, "standard input");
        echo(job, source, sink, account)
    });
    assert_eq!(outcome.status, Status::Done);
    assert_eq!(outcome.output, ";GOTO/1,2,3\n");
}

#[test]
fn a_rejected_program_on_standard_output_is_status_1() {
    let outcome = run_with(&["post", "-", "-o", "-"], b"A\nGOTO/1\n", &stumble);
    assert_eq!(outcome.status, Status::Rejected);
    assert_eq!(outcome.output, "G0 X0\n(error)\n");
    assert!(outcome.errors.contains("<stdin>:2:6: error: "), "{}", outcome.errors);
    assert!(outcome.errors.contains("must not be run"), "{}", outcome.errors);
}

#[test]
fn unreadable_cl_data_is_status_2() {
    let shop = Shop::new();
    let missing = shop.arg("missing.cls");
    let outcome = run_with(&["post", &missing], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.starts_with(&format!("error: cannot read {missing}: ")), "{}", outcome.errors);
    let directory = shop.directory.path().display().to_string();
    let outcome = run_with(&["post", &directory], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.contains("is a directory"), "{}", outcome.errors);
}

#[test]
fn an_unwritable_program_is_status_2_before_anything_is_posted() {
    let shop = Shop::new();
    let (input, output) = (shop.arg("part.cls"), shop.arg("nowhere/part.ngc"));
    let outcome = run_with(&["post", &input, "-o", &output], b"", &never);
    assert_eq!(outcome.status, Status::NotRun);
    assert!(outcome.errors.starts_with(&format!("error: cannot write {output}: ")), "{}", outcome.errors);
}

#[test]
fn a_failing_read_or_write_is_status_2_and_leaves_the_earlier_program() {
    for (error, words) in [
        (PostError::Input as fn(io::Error) -> PostError, "error: cannot read "),
        (PostError::Output as fn(io::Error) -> PostError, "error: cannot write "),
    ] {
        let shop = Shop::new();
        shop.write("part.ngc", "yesterday");
        let outcome = shop.post(&[], &|_, _, _, _| Err(error(io::Error::other("the disk is gone"))));
        assert_eq!(outcome.status, Status::NotRun);
        assert!(outcome.errors.starts_with(words) && outcome.errors.contains("the disk is gone"));
        assert_eq!(shop.names(), ["part.cls", "part.ngc"]);
        assert_eq!(shop.text("part.ngc"), "yesterday");
    }
}

/// A pipe whose other end is closed.
struct ClosedPipe;

impl Write for ClosedPipe {
    fn write(&mut self, _bytes: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::BrokenPipe.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_closed_pipe_is_status_2_without_a_message() {
    for words in [&["post", "-", "--no-check"][..], &["config"], &["explain"], &["--help"]] {
        let args: Vec<OsString> = ["sample"].iter().chain(words).map(OsString::from).collect();
        let mut errors = Vec::new();
        let streams =
            Streams { input: &mut &b"A\n"[..], output: &mut ClosedPipe, errors: &mut errors, terminal: false };
        assert_eq!(execute::<Sample>(&args, streams, &echo), Status::NotRun, "{words:?}");
        assert_eq!(String::from_utf8_lossy(&errors), "", "{words:?}");
    }
}

#[test]
fn the_program_never_replaces_a_file_that_is_read() {
    let shop = Shop::new();
    shop.write("shop.toml", "");
    shop.write("part.rejected", "A\n");
    let (part, toml) = (shop.arg("part.cls"), shop.arg("shop.toml"));
    for args in [
        vec!["post", &part, "-o", &part],
        vec!["post", &part, "-o", &toml, "--config", &toml],
        vec!["post", &shop.arg("part.rejected"), "-o", &shop.arg("part")],
        vec!["post", &part, "-o", &format!("{}/./part.cls", shop.directory.path().display())],
    ] {
        let outcome = run_with(&args, b"", &never);
        assert_eq!(outcome.status, Status::NotRun, "{args:?}");
        assert!(outcome.errors.contains(" would overwrite the "), "{}", outcome.errors);
    }
    assert_eq!(shop.text("part.cls"), "PARTNO A\nGOTO/1.0\n");
}

#[cfg(unix)]
#[test]
fn a_link_to_the_cl_data_is_the_cl_data() {
    let shop = Shop::new();
    std::os::unix::fs::symlink(shop.path("part.cls"), shop.path("soft")).expect("links work here");
    fs::hard_link(shop.path("part.cls"), shop.path("hard")).expect("links work here");
    for link in ["soft", "hard"] {
        let outcome = run_with(&["post", &shop.arg("part.cls"), "-o", &shop.arg(link)], b"", &never);
        assert_eq!(outcome.status, Status::NotRun);
    }
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link_and_its_target_is_replaced() {
    let shop = Shop::new();
    shop.write("real.ngc", "yesterday");
    std::os::unix::fs::symlink(shop.path("real.ngc"), shop.path("part.ngc")).expect("links work here");
    assert_eq!(shop.post(&[], &echo).status, Status::Done);
    assert!(fs::symlink_metadata(shop.path("part.ngc")).expect("the link is there").is_symlink());
    assert_eq!(shop.text("real.ngc"), ";PARTNO A\nGOTO/1.0\n");
}

#[cfg(unix)]
#[test]
fn a_device_is_written_and_not_replaced() {
    let shop = Shop::new();
    let outcome = run_with(&["post", &shop.arg("part.cls"), "-o", "/dev/null", "--no-check"], b"", &echo);
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
}

#[test]
fn cl_data_that_changes_or_vanishes_meanwhile_is_status_2() {
    let changes: [fn(&Path); 2] =
        [|path| fs::write(path, "GOTO/9,9,9,9\n").expect("writable"), |path| fs::remove_file(path).expect("there")];
    for (change, words) in changes.into_iter().zip(["changed while it was read", "vanished while it was read"]) {
        let shop = Shop::new();
        shop.write("part.ngc", "yesterday");
        let outcome = shop.post(&[], &|job, source, sink, account| {
            let report = echo(job, source, sink, account)?;
            change(&shop.path("part.cls"));
            Ok(report)
        });
        assert_eq!(outcome.status, Status::NotRun);
        assert!(outcome.errors.contains(words), "{}", outcome.errors);
        assert_eq!(shop.text("part.ngc"), "yesterday");
        assert!(!shop.path("part.ngc.rejected").exists());
    }
}

#[test]
fn the_command_line_goes_on_top_of_the_configuration_file() {
    let shop = Shop::new();
    shop.write("shop.toml", "cl_units = 'mm'\nwork_offset = 'G55'\n");
    let seen = RefCell::new(None);
    let flags = ["--config", &shop.arg("shop.toml"), "--units", "in", "--output-units", "mm", "--line-numbers"];
    let outcome = shop.post(&flags, &|job, source, sink, account| {
        *seen.borrow_mut() = Some((job.config.clone(), job.units));
        echo(job, source, sink, account)
    });
    assert_eq!(outcome.status, Status::Done, "{}", outcome.errors);
    let (config, units) = seen.into_inner().expect("it was posted");
    assert_eq!(config.work_offset, "G55");
    assert_eq!((config.cl_units, units), (Some(Units::Inches), Some(Units::Inches)));
    assert_eq!(config.output_units, Some(Units::Millimetres));
    assert_eq!(config.program.line_numbers, Some(Config::LINE_NUMBER_STEP));
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
fn an_assumed_unit_of_the_configuration_is_told() {
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
fn the_command_goes_by_the_name_of_its_file() {
    let outcome = run_with(&["--version"], b"", &never);
    assert!(outcome.output.starts_with("sample_post "), "{}", outcome.output);
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
fn explain_prints_what_the_machine_knows_and_no_empty_headings() {
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

#[test]
fn json_messages_are_one_object_per_line() {
    let shop = Shop::new();
    let outcome = shop.post(&["--message-format", "json"], &stumble);
    let lines: Vec<serde_json::Value> =
        outcome.errors.lines().map(|line| serde_json::from_str(line).expect("an object")).collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0]["file"], shop.arg("part.cls"));
    assert_eq!((&lines[0]["line"], &lines[0]["column"], &lines[0]["length"]), (&2.into(), &6.into(), &3.into()));
    assert_eq!(lines[0]["severity"], "error");
    assert_eq!(lines[0]["text"], "GOTO needs 3 or 6 numbers (found 1)");
    assert_eq!(lines[0]["help"], "write X, Y and Z");
    assert_eq!(lines[1]["severity"], "note");
    assert!(lines[1]["line"].is_null());
}

/// The messages for findings about `text`.
fn messages(text: &[u8], found: &[Diagnostic]) -> String {
    let mut out = Vec::new();
    Messages::new(&mut out, MessageFormat::Human).diagnostics("p.cls", &mut &*text, found);
    String::from_utf8(out).expect("messages are text")
}

#[test]
fn diagnostics_stand_in_the_order_of_the_text_and_are_counted() {
    let found = [
        finding(Severity::Warning, 3, 1, 1, "later", None),
        finding(Severity::Error, 1, 1, 1, "first", None),
        finding(Severity::Warning, 2, 1, 1, "second", None),
    ];
    assert_eq!(
        messages(b"A\nB\nC", &found),
        "p.cls:1:1: error: first\n  |\n1 | A\n  | ^\np.cls:2:1: warning: second\n  |\n2 | B\n  | ^\n\
         p.cls:3:1: warning: later\n  |\n3 | C\n  | ^\np.cls: 1 error, 2 warnings\n"
    );
}

#[test]
fn twenty_of_a_kind_are_shown_and_the_rest_is_counted() {
    let text = "GOTO/1\n".repeat(200);
    let numbered = |line: u64| format!("GOTO/{line}.5 is {line} numbers short of `X{line}`");
    let mut found: Vec<Diagnostic> =
        (1..=123).map(|line| finding(Severity::Warning, line, 1, 4, &numbered(line), None)).collect();
    found.push(finding(Severity::Error, 150, 1, 1, "another kind", None));
    let shown = messages(text.as_bytes(), &found);
    assert_eq!(shown.matches(": warning: ").count(), 20);
    assert!(shown.contains("p.cls: 103 more like `warning: GOTO/# is # numbers short of …`, the last in line 123\n"));
    assert!(shown.contains("p.cls:150:1: error: another kind\n"));
    assert!(shown.ends_with("p.cls: 1 error, 123 warnings\n"));
}

#[test]
fn what_is_only_counted_counts_in_the_summary() {
    let rest = Diagnostic { count: 980, ..finding(Severity::Error, 1, 1, 1, "980 more of this kind", None) };
    let shown = messages(b"GOTO/1\n", &[finding(Severity::Error, 1, 6, 1, "short", None), rest]);
    assert!(shown.ends_with("p.cls: 981 errors\n"), "{shown}");
}

#[test]
fn a_fault_of_a_whole_statement_marks_its_word() {
    let found = [finding(Severity::Error, 1, 3, 1, "odd", None), finding(Severity::Error, 2, 8, 1, "odd", None)];
    let shown = messages(b"  END-OF-PATH\nSPINDL/0,CLW\n", &found);
    let carets: Vec<&str> = shown.lines().filter(|line| line.contains('^')).collect();
    assert_eq!(carets, ["  |   ^^^^^^^^^^^", "  |        ^"]);
}

#[test]
fn control_characters_and_bytes_that_are_not_text_are_made_visible() {
    let found = [finding(Severity::Error, 1, 7, 2, "odd", None)];
    let shown = messages(b"\tA\x1b[\xff\xc3\xa4B\r\n", &found);
    assert_eq!(shown.lines().nth(2), Some("1 | ␉A␛[\u{fffd}äB"));
    // Two bytes in front of the column are one character: the caret stands below the one at or behind it.
    assert_eq!(shown.lines().nth(3), Some("  |       ^"));
}

#[test]
fn control_characters_in_a_message_reach_no_terminal() {
    let found = [finding(Severity::Error, 1, 1, 1, "odd \x1b[2J", None)];
    assert!(!messages(b"A", &found).contains('\x1b'));
}

#[test]
fn a_long_line_is_clipped_around_the_column() {
    let line: String = (0..5000).map(|index| char::from(b'a' + (index % 26) as u8)).collect();
    let text = format!("short\n{line}\n");
    for (column, starts, ends) in [(1, false, true), (2500, true, true), (5000, true, false)] {
        let shown = messages(text.as_bytes(), &[finding(Severity::Error, 2, column, 3, "here", None)]);
        let lines: Vec<&str> = shown.lines().collect();
        assert!(lines[2].chars().count() <= 4 + 100 + 2, "{}", lines[2]);
        assert_eq!((lines[2].starts_with("2 | …"), lines[2].ends_with('…')), (starts, ends), "{}", lines[2]);
        let caret = lines[3].find('^').expect("a caret");
        let wanted = char::from(b'a' + ((column - 1) % 26) as u8);
        assert_eq!(lines[2].chars().nth(caret), Some(wanted), "{column}");
    }
}

#[test]
fn lines_end_in_lf_crlf_or_a_lone_cr_also_across_reads() {
    /// Gives one byte at a time.
    struct Drip<'a>(&'a [u8]);
    impl Read for Drip<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            let count = usize::from(!self.0.is_empty() && !buffer.is_empty());
            buffer[..count].copy_from_slice(&self.0[..count]);
            self.0 = &self.0[count..];
            Ok(count)
        }
    }
    let text = b"one\r\ntwo\rthree\n\nfive";
    let places = || (1..=6).map(|line| (Location { line, column: 1 }, 1));
    let whole = excerpt::excerpts(&mut &text[..], places()).expect("memory is readable");
    let dripped = excerpt::excerpts(&mut Drip(text), places()).expect("memory is readable");
    assert_eq!(whole, dripped);
    let texts: Vec<&str> = whole.values().map(|excerpt| excerpt.text.as_str()).collect();
    assert_eq!(texts, ["one", "two", "three", "", "five"]);
}

#[test]
fn a_place_behind_the_end_of_the_text_is_shown_without_a_line() {
    assert_eq!(
        messages(b"A\n", &[finding(Severity::Error, 2, 1, 1, "the file ends early", None)]),
        "p.cls:2:1: error: the file ends early\np.cls: 1 error\n"
    );
}

proptest! {
    /// The caret stands below the text and the excerpt is short, whatever the bytes and wherever the place.
    #[test]
    fn any_place_in_any_text_can_be_shown(
        bytes in proptest::collection::vec(prop_oneof![any::<u8>(), Just(b'\n'), Just(b'\r'), Just(0xC3), Just(b'A')], 0..600),
        line in 0_u64..40,
        column in 0_u32..700,
        length in 0_u32..50,
    ) {
        let place = (Location { line, column }, length);
        let found = excerpt::excerpts(&mut &bytes[..], std::iter::once(place)).expect("memory is readable");
        for excerpt in found.values() {
            let count = excerpt.text.chars().count();
            prop_assert!(count <= 102, "{count}");
            prop_assert!(excerpt.indent <= count && excerpt.marked >= 1);
            prop_assert!(!excerpt.text.chars().any(char::is_control));
        }
    }
}
