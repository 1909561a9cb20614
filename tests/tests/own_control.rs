//! A control outside the crate, through the command line: posted, checked, explained, and refused where it is not declared.

use std::path::{Path, PathBuf};

use examples::house_control::House;
use machines::SpinnerU5620;
use pp_runtime::cli::{App, Status, Streams};
use pp_runtime::control::{CONTROLS, Control, Fanuc, Spellings};

/// Runs a command of the Spinner; status, standard output and messages.
fn run(app: &App, args: &[&str]) -> (Status, String, String) {
    let args: Vec<_> = ["spinner"].iter().chain(args).map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    let status = app.run_with::<SpinnerU5620>(&args, streams);
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (status, text(output), text(errors))
}

fn two_tools() -> String {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/cl/two_tools.cls");
    path.to_str().expect("a path in UTF-8").to_owned()
}

#[test]
fn a_program_of_an_own_control_is_posted_and_passes_the_check() {
    let app = App::new().control(&House);
    let (status, program, messages) = run(&app, &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::Done, "{messages}");
    let lines: Vec<&str> = program.lines().collect();
    let change = lines.iter().position(|line| line.ends_with(" M6")).expect("a tool change");
    assert_eq!((lines[change - 1], lines[change + 1]), ("M140", "M141"));
    // It is the default, and can be named.
    assert_eq!(run(&app, &["post", &two_tools(), "--quiet", "--control", "house"]).1, program);
    let (status, fanuc, _) = run(&app, &["post", &two_tools(), "--quiet", "--control", "fanuc"]);
    assert_eq!(status, Status::Done);
    assert!(!fanuc.contains("M140"));
}

#[test]
fn a_statement_of_the_shop_is_its_block_on_every_control_and_the_check_insists_on_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a file");
        path.to_str().expect("a path in UTF-8").to_owned()
    };
    // Before the second tool.
    let cl = std::fs::read_to_string(two_tools()).expect("the sample");
    let second = cl.match_indices("TOOL PATH").nth(1).expect("a second operation").0;
    let cl = file("chuck.cls", &format!("{}CHUCK/OPEN\n{}", &cl[..second], &cl[second..]));
    let words = "[cl.words]\n\"CHUCK/OPEN\" = \"M468\"\n";
    let declared = file("declared.toml", &format!("{words}[control]\neffects = {{ M468 = \"none\" }}\n"));
    let undeclared = file("undeclared.toml", words);
    let app = App::new();
    for control in CONTROLS.iter().map(|control| control.spellings().name) {
        let post = |config: &str| run(&app, &["post", &cl, "--quiet", "--control", control, "--config", config]);
        let (status, program, messages) = post(&declared);
        assert_eq!(status, Status::Done, "{control}: {messages}");
        let is_block = |line: &&str| !line.contains("CHUCK") && line.split_whitespace().any(|word| word == "M468");
        assert_eq!(program.lines().filter(is_block).count(), 1, "{control}");

        let without: String = program.lines().filter(|line| !is_block(line)).map(|line| format!("{line}\n")).collect();
        let lost = file("lost.nc", &without);
        let (status, _, messages) = run(&app, &["check", &cl, &lost, "--control", control, "--config", &declared]);
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(
            messages.contains("has no block before this one") && messages.contains("CHUCK/OPEN"),
            "{control}: {messages}"
        );

        // Without a declared effect nobody knows what the code does.
        let (status, _, messages) = post(&undeclared);
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(messages.contains("declare its effect in `[control] effects`"), "{control}: {messages}");
    }
    let (status, _, messages) = run(&app, &["post", &cl, "--quiet"]);
    assert_eq!(status, Status::Rejected);
    assert!(messages.contains("`CHUCK` is not a known word of CL data"), "{messages}");
}

/// The same codes without their effects.
struct Undeclared;

impl Control for Undeclared {
    fn spellings(&self) -> &'static Spellings {
        House.spellings()
    }
    fn base(&self) -> Option<&'static dyn Control> {
        Some(&Fanuc)
    }
}

#[test]
fn a_code_that_an_own_control_does_not_declare_is_a_finding() {
    let (status, _, messages) = run(&App::new().control(&Undeclared), &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::Rejected);
    assert!(messages.contains("`M140`"), "{messages}");
}

/// No family is named.
struct Stranger;

impl Control for Stranger {
    fn spellings(&self) -> &'static Spellings {
        House.spellings()
    }
    fn work_offset(&self, word: &str) -> Option<String> {
        Fanuc.work_offset(word)
    }
}

#[test]
fn programs_of_no_family_are_not_passed() {
    let (status, _, messages) = run(&App::new().control(&Stranger), &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::NotRun);
    assert!(messages.contains("the check cannot read programs of House control"), "{messages}");
}

#[test]
fn config_and_explain_know_an_own_control() {
    let app = App::new().control(&House);
    let (status, config, _) = run(&app, &["config", "--control", "house"]);
    assert_eq!((status, config == run(&app, &["config"]).1), (Status::Done, true));
    let (status, codes, _) = run(&app, &["explain", "--codes", "--control", "house"]);
    assert_eq!((status, codes), (Status::Done, run(&app, &["explain", "--codes", "--control", "fanuc"]).1));
    let (status, _, messages) = run(&App::new(), &["config", "--control", "house"]);
    assert_eq!(status, Status::NotRun);
    assert!(messages.contains("invalid value"), "{messages}");
}

#[test]
fn a_method_that_an_own_control_changes_is_its_own() {
    assert_eq!(House.work_offset("G55").as_deref(), Some("G55"));
    assert_eq!(House.work_offset("G54.1 P3"), None);
    assert_eq!(Undeclared.work_offset("G54.1 P3"), Fanuc.work_offset("G54.1 P3"));
}
