//! A control outside the crate and blocks of the shop, through the command line: posted, checked, explained, and
//! refused where they are not declared.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use examples::house_control::House;
use machines::SpinnerU5620;
use pp_runtime::cli::{App, Status, Streams};
use pp_runtime::control::{CONTROLS, Control, Fanuc, LineEffect, Spellings};

/// Runs a command of the Spinner; status, standard output and messages.
fn run(app: &App, args: &[&str]) -> (Status, String, String) {
    let args: Vec<_> = ["spinner"].iter().chain(args).map(Into::into).collect();
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let streams = Streams { input: &mut &b""[..], output: &mut output, errors: &mut errors, terminal: false };
    let status = app.run_with::<SpinnerU5620>(&args, streams);
    let text = |bytes| String::from_utf8(bytes).expect("text");
    (status, text(output), text(errors))
}

/// Writes a file into a folder; its path.
fn written(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).expect("a file");
    path.to_str().expect("a path in UTF-8").to_owned()
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
    let file = |name: &str, text: &str| written(folder.path(), name, text);
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

        let end = file("end.toml", "[cl.words]\n\"CHUCK/OPEN\" = \"M30\"\n");
        let (status, _, messages) = post(&end);
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(messages.contains("the program ends at this block of the CL data"), "{control}: {messages}");
    }
    let (status, _, messages) = run(&app, &["post", &cl, "--quiet"]);
    assert_eq!(status, Status::Rejected);
    assert!(messages.contains("`CHUCK` is not a known word of CL data"), "{messages}");
}

/// Blocks of the shop at every place that the configuration has for them, each with a code of its own.
const PLACES: [(&str, &str); 6] = [
    ("program.start", "M461"),
    ("program.end", "M462"),
    ("control.safety", "M463"),
    ("control.tool_change", "M464"),
    ("program.operation_start", "M465"),
    ("program.operation_end", "M466"),
];

#[test]
fn a_block_of_the_shop_is_at_its_place_on_every_control_and_the_check_insists_on_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| written(folder.path(), name, text);
    let app = App::new();
    for control in CONTROLS {
        let codes = control.spellings();
        // As the control has them, with one block more. A line of the configuration is one line, and the safety blocks
        // of Heidenhain need two for the datum.
        let places = || PLACES.into_iter().filter(|(key, _)| codes.name != "heidenhain" || *key != "control.safety");
        let with = |of_control: &[&'static str], code: &'static str| [of_control, &[code]].concat();
        let keys: String = places()
            .map(|(key, code)| match key {
                "control.safety" => format!("{key} = {:?}\n", with(codes.safety, code)),
                "control.tool_change" => format!("{key} = {:?}\n", with(codes.tool_change, code)),
                "program.operation_start" => format!("{key} = [\"{code} Q{{tool}}\"]\n"),
                _ => format!("{key} = [\"{code}\"]\n"),
            })
            .collect();
        let declared = PLACES.map(|(_, code)| format!("{code} = \"none\"")).join(", ");
        // A parameter of the code is part of the declared line.
        let config = file(
            "places.toml",
            &format!("{keys}control.effects = {{ {declared}, \"M465 Q{{tool}}\" = \"position lost\" }}\n"),
        );
        let name = codes.name;
        let arguments = ["--control", name, "--config", &config];
        let (status, program, messages) = run(&app, &[&["post", &two_tools(), "--quiet"], &arguments[..]].concat());
        assert_eq!(status, Status::Done, "{name}: {messages}\n{program}");
        let order: Vec<&str> =
            program.split_whitespace().filter(|word| PLACES.iter().any(|(_, code)| code == word)).collect();
        let of_operation = ["M463", "M464", "M465", "M466"];
        let operation = &of_operation[usize::from(places().count() < PLACES.len())..];
        let expected = [&["M461"], operation, operation, &["M462"]].concat();
        assert_eq!(order, expected, "{name}:\n{program}");
        assert_eq!(program.matches("M465 Q1").count() + program.matches("M465 Q2").count(), 2, "{name}:\n{program}");

        for (key, code) in places() {
            for at in program.match_indices(code).map(|(at, _)| at) {
                let start = program[..at].rfind('\n').map_or(0, |end| end + 1);
                let end = at + program[at..].find('\n').expect("an end of line") + 1;
                let lost = file("lost.nc", &[&program[..start], &program[end..]].concat());
                let (status, _, messages) = run(&app, &[&["check", &two_tools(), &lost], &arguments[..]].concat());
                assert_eq!(status, Status::Rejected, "{name} {key}");
                let named = messages.contains(&format!("of `{key}` is missing")) && messages.contains(code);
                assert!(named, "{name} {key}: {messages}");
            }
        }
    }
}

#[test]
fn a_block_may_stand_at_several_places_and_the_check_insists_on_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| written(folder.path(), name, text);
    let app = App::new();
    let places = ["start", "operation_start", "operation_end", "end"];
    let config = file(
        "places.toml",
        &format!(
            "[program]\n{}[control]\neffects = {{ M470 = \"none\" }}\n",
            places.map(|place| format!("{place} = [\"M470\"]\n")).concat()
        ),
    );
    for control in CONTROLS.iter().map(|control| control.spellings().name) {
        let arguments = ["--control", control, "--config", &config];
        let (status, program, messages) = run(&app, &[&["post", &two_tools(), "--quiet"], &arguments[..]].concat());
        assert_eq!(status, Status::Done, "{control}: {messages}\n{program}");
        let check =
            |text: &str| run(&app, &[&["check", &two_tools(), &file("edited.nc", text)], &arguments[..]].concat());
        let lines: Vec<&str> = program.split_inclusive('\n').collect();
        let of_shop: Vec<usize> =
            (0..lines.len()).filter(|&at| lines[at].split_whitespace().any(|word| word == "M470")).collect();
        assert_eq!(of_shop.len(), 1 + 2 + 2 + 1, "{control}:\n{program}");
        for &at in &of_shop {
            let (status, _, messages) = check(&[&lines[..at], &lines[at + 1..]].concat().concat());
            assert_eq!(status, Status::Rejected, "{control}, line {}", at + 1);
            assert!(
                messages.contains("`M470` of `program.") && messages.contains("is missing"),
                "{control}: {messages}"
            );
        }
        // At the part is the place of none of them.
        let cut =
            (of_shop[1]..of_shop[2]).rfind(|&at| lines[at].contains(" F") || lines[at].contains('X')).expect("a cut");
        let (status, _, messages) = check(&[&lines[..cut], &[lines[of_shop[1]]], &lines[cut..]].concat().concat());
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(messages.contains("a line of `program.start` after the first motion"), "{control}: {messages}");
    }
}

#[test]
fn no_block_of_the_shop_comes_between_operations_that_follow_each_other_at_the_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let keys = "transition = \"direct\"\nprogram.operation_end = [\"M33\"]\n";
    let config = written(folder.path(), "direct.toml", keys);
    let (status, _, messages) = run(&App::new(), &["post", &two_tools(), "--quiet", "--config", &config]);
    assert_eq!(status, Status::NotRun);
    assert!(messages.contains("remove `transition`, or `program.operation_end`"), "{messages}");
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
    assert_eq!(status, Status::Done);
    let of_base = run(&app, &["explain", "--codes", "--control", "fanuc"]).1;
    let own = codes.strip_prefix(&of_base).expect("the codes of its base come first");
    assert_eq!(own.lines().count(), House.effects().len(), "{own}");
    assert!(own.contains("M140              declared by House control with the effect \"none\"\n"), "{own}");
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

#[test]
fn a_tool_change_by_a_macro_passes_the_check_on_every_control_and_a_wrong_or_lost_tool_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| written(folder.path(), name, text);
    let app = App::new();
    for control in CONTROLS.iter().map(|control| control.spellings().name) {
        let call = match control {
            "siemens" => "L9001(",
            "heidenhain" => "M106 Q",
            "linuxcnc" => "O<change> CALL [",
            _ => "G65 P9001 T",
        };
        let closed = match control {
            "siemens" => ")",
            "linuxcnc" => "]",
            _ => "",
        };
        let line = format!("{call}{{tool}}{closed}");
        let config = file(
            "macro.toml",
            &format!(
                "[control]\ntool_change = [\"{line}\", \"M120\"]\n\
                 effects = {{ \"{line}\" = \"tool change\", M120 = \"none\" }}\n"
            ),
        );
        let arguments = ["--control", control, "--config", &config];
        let (status, program, messages) = run(&app, &[&["post", &two_tools(), "--quiet"], &arguments[..]].concat());
        assert_eq!(status, Status::Done, "{control}: {messages}\n{program}");
        let second = format!("{call}2{closed}");
        assert_eq!(program.matches(&second).count(), 1, "{control}:\n{program}");
        let check =
            |text: &str| run(&app, &[&["check", &two_tools(), &file("edited.nc", text)], &arguments[..]].concat());
        let (status, _, messages) = check(&program.replace(&second, &format!("{call}9{closed}")));
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(messages.contains("change to T9, but the CL data requires T2"), "{control}: {messages}");
        let kept: String =
            program.lines().filter(|line| !line.contains(&second)).map(|line| format!("{line}\n")).collect();
        let (status, _, messages) = check(&kept);
        assert_eq!(status, Status::Rejected, "{control}");
        assert!(messages.contains(&format!("`{line}` of `control.tool_change` is missing")), "{control}: {messages}");
        assert!(messages.contains("T1 is in the spindle, expected T2"), "{control}: {messages}");
    }
}

/// A macro changes the tool.
struct Macro(&'static [(&'static str, LineEffect)]);

static BY_MACRO: LazyLock<Spellings> = LazyLock::new(|| Spellings {
    name: "macro",
    title: "Macro control",
    tool_change: &["G65 P9001 T{tool}", "M120"],
    ..Fanuc.spellings().clone()
});

impl Control for Macro {
    fn spellings(&self) -> &'static Spellings {
        &BY_MACRO
    }
    fn base(&self) -> Option<&'static dyn Control> {
        Some(&Fanuc)
    }
    fn effects(&self) -> &'static [(&'static str, LineEffect)] {
        self.0
    }
}

#[test]
fn an_own_control_declares_its_tool_change_with_the_field_of_the_tool() {
    static DECLARED: Macro = Macro(&[("G65 P9001 T{tool}", LineEffect::ToolChange), ("M120", LineEffect::None)]);
    static WITHOUT: Macro = Macro(&[("G65 P9001", LineEffect::ToolChange)]);
    let (status, program, messages) = run(&App::new().control(&DECLARED), &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::Done, "{messages}");
    assert!(program.contains("G65 P9001 T2\nM120\n"), "{program}");
    let (status, _, messages) = run(&App::new().control(&WITHOUT), &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::NotRun, "{messages}");
    assert!(messages.contains("`G65 P9001` has no field {tool}"), "{messages}");
}

/// Flood by codes of its own.
struct Wet;

static WET: LazyLock<Spellings> = LazyLock::new(|| Spellings {
    name: "wet",
    title: "Wet control",
    coolant: [Some(["M51", "M59"]), None, None, None],
    ..Fanuc.spellings().clone()
});

impl Control for Wet {
    fn spellings(&self) -> &'static Spellings {
        &WET
    }
    fn base(&self) -> Option<&'static dyn Control> {
        Some(&Fanuc)
    }
}

#[test]
fn the_coolant_codes_of_an_own_control_take_the_place_of_those_of_its_base() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str, text: &str| written(folder.path(), name, text);
    let app = App::new().control(&Wet);
    let (status, program, messages) = run(&app, &["post", &two_tools(), "--quiet"]);
    assert_eq!(status, Status::Done, "{messages}");
    assert!(program.contains("M51\n") && program.contains("M59\n"), "{program}");
    assert!(!program.contains("M8\n") && !program.contains("M9\n"), "{program}");
    let of_base = file("base.nc", &program.replace("M51\n", "M8\n").replace("M59\n", "M9\n"));
    let (status, _, messages) = run(&app, &["check", &two_tools(), &of_base]);
    assert_eq!(status, Status::Rejected, "{messages}");
    assert!(messages.contains("`M8` is no coolant code of this machine: its code is `M51`"), "{messages}");
    // A configuration takes precedence over its control.
    let config = file("wet.toml", "[control]\ncoolant = { flood = [\"M61\", \"M69\"] }\n");
    let (status, program, messages) = run(&app, &["post", &two_tools(), "--quiet", "--config", &config]);
    assert_eq!(status, Status::Done, "{messages}");
    let control = file("control.nc", &program.replace("M61\n", "M51\n").replace("M69\n", "M59\n"));
    assert_eq!(run(&app, &["check", &two_tools(), &control, "--config", &config]).0, Status::Rejected);
}
