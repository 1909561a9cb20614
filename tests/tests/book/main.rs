//! The book in `docs`, without mdBook, and the READMEs: every listing is run, read or compiled, and every link leads
//! somewhere.
//!
//! The language of a listing decides what is done with it:
//!
//! | listing | |
//! |---|---|
//! | `console` | its commands are run in the folder of the chapter, and their output is compared |
//! | any language and the name of a file, Rust as `rust,ignore` | the file: compared if the folder of the chapter or the workspace has it, else written to the folder, for a command below |
//! | `toml` | read as a configuration |
//! | `sh` | too long for this test: each line is a command of `.ci` or of the template |
//! | `rust`, `rust,no_run`, `rust,compile_fail` | compiled as documentation test of `tests/src/book.rs` |
//!
//! A listing of another kind is an error, and a picture in SVG is one that a command of its chapter writes. The folder
//! of a chapter is empty at its start but for `examples`. A line `...` in a listing means any number of lines.
//!
//! `PP_BLESS=1 cargo test --workspace --test book` writes the outputs into the chapters, without `...`: read every
//! changed line, and shorten it.

mod chapter;
mod codes;
mod folder;
mod machines;
mod messages;

use std::fs;
use std::path::{Path, PathBuf};

use chapter::{Chapter, Listing, Part, SOURCE};
use folder::Folder;
use pp_runtime::config::Config;
use pp_runtime::control::LinuxCnc;
use tests::binaries::{golden_programs, workspace};
use tests::by_name;
use tests::by_name::COMMANDS;
use tests::environment;

/// Fails with what was found, if anything was.
fn assert_none(found: &[String]) {
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Does with a listing what its language asks for.
fn try_listing(chapter: &Chapter, listing: &Listing, folder: &mut Folder) -> Result<(), String> {
    match (listing.language.as_str(), &listing.file) {
        ("console", None) => return folder.run(listing),
        ("rust" | "rust,no_run" | "rust,compile_fail", None) => is_compiled(chapter)?,
        ("sh", None) => is_run_elsewhere(listing)?,
        ("toml", None) => {
            let faults = |faults| format!("is no configuration: {faults}");
            Config::read::<::machines::SpinnerU5620>(&listing.text(), &LinuxCnc).map_err(faults)?;
        }
        (_, Some(_)) => (),
        (language, None) => return Err(format!("a listing `{language}` without the name of a file has no rule")),
    }
    match &listing.file {
        Some(name) => folder.file(name, listing),
        None => Ok(()),
    }
}

/// Whether the Rust of a chapter is compiled by the documentation tests.
fn is_compiled(chapter: &Chapter) -> Result<(), String> {
    let list = fs::read_to_string(workspace().join("tests/src/book.rs")).expect("the list of chapters with Rust");
    let row = format!("{}\"", chapter.path.display());
    if list.contains(&row) { Ok(()) } else { Err("this chapter is not in tests/src/book.rs".into()) }
}

/// Files whose commands are run in other ways than by this test.
const ELSEWHERE: [&str; 4] =
    [".ci/run", ".ci/packages", "pp-runtime/template/README.md", "pp-runtime/template/release.sh"];

/// Whether each line of a listing is a command of [`ELSEWHERE`].
fn is_run_elsewhere(listing: &Listing) -> Result<(), String> {
    let texts = ELSEWHERE.map(|file| fs::read_to_string(workspace().join(file)).expect("a file of the workspace"));
    match listing.lines.iter().find(|line| !texts.iter().any(|text| text.contains(line.as_str()))) {
        Some(line) => Err(format!("`{line}` is a command of none of {ELSEWHERE:?}")),
        None => Ok(()),
    }
}

/// All chapters in one test: commands are run in the current folder of the process.
#[test]
fn every_listing_is_what_its_commands_write() {
    let mut found = Vec::new();
    for mut chapter in Chapter::all() {
        let mut folder = Folder::new();
        folder.enter();
        for listing in chapter.listings() {
            if let Err(fault) = try_listing(&chapter, &listing, &mut folder) {
                found.push(format!("{}:{}: {fault}", chapter.path.display(), listing.line + 1));
            }
        }
        for picture in chapter.links().filter(|link| link.ends_with(".svg")) {
            let fault = folder.picture(&workspace().join(chapter.target(&picture))).err();
            found.extend(fault.map(|fault| format!("{}: {fault}", chapter.path.display())));
        }
        found.extend(folder.unread().map(|name| format!("{}: no command reads {name}", chapter.path.display())));
        if environment::blesses() {
            chapter.rewrite(folder.outputs());
        }
        folder::leave();
    }
    assert_none(&found);
}

/// Whether a link from a chapter leads to a file that mdBook copies: those in the folder of the chapters.
fn is_in_book(file: &str) -> bool {
    !file.starts_with("../")
}

#[test]
fn every_page_is_in_the_summary_and_every_link_leads_somewhere() {
    let mut found = Vec::new();
    let listed: Vec<PathBuf> = Chapter::of_book().into_iter().map(|chapter| chapter.path).collect();
    for entry in fs::read_dir(workspace().join(SOURCE)).expect("the chapters") {
        let name = entry.expect("an entry").file_name().into_string().expect("a name in UTF-8");
        if name.ends_with(".md") && name != chapter::SUMMARY && !listed.contains(&Path::new(SOURCE).join(&name)) {
            found.push(format!("{name} is not in the summary"));
        }
    }
    for chapter in Chapter::all() {
        let missing = chapter.included().filter(|file| !workspace().join(chapter.target(file)).exists());
        found.extend(missing.map(|file| format!("{}: no {file} to include", chapter.path.display())));
        for link in chapter.links() {
            if link.contains("://") {
                continue;
            }
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let target = chapter.target(file);
            if !workspace().join(&target).exists() {
                found.push(format!("{}: {link} leads nowhere", chapter.path.display()));
            } else if chapter.path.starts_with(SOURCE) && !is_in_book(file) {
                found.push(format!("{}: {link} is not in the book that mdBook builds", chapter.path.display()));
            } else if !heading.is_empty() && !Chapter::read(target).headings().any(|other| other == heading) {
                found.push(format!("{}: {link} is no heading", chapter.path.display()));
            }
        }
    }
    assert_none(&found);
}

#[test]
fn every_option_in_the_chapters_is_one_of_a_command() {
    let help: String = COMMANDS.iter().map(|command| machines::run("spinner-u5-620", &[command, "--help"]).1).collect();
    let mut found = Vec::new();
    for chapter in Chapter::all() {
        for option in chapter.options() {
            let is_one = |rest: &str| !rest.starts_with(|next: char| next.is_ascii_alphanumeric() || next == '-');
            if !help.split(option.as_str()).skip(1).any(is_one) {
                found.push(format!("{}: no command has {option}", chapter.path.display()));
            }
        }
    }
    assert_none(&found);
}

/// The runner itself: outputs that differ are found.
#[test]
fn a_listing_matches_its_lines_and_nothing_else() {
    let part = |shown: &str, real: &str| Part::of(shown).is_in(real);
    assert!(part("a\nb\n", "a\nb\n") && part("", "") && part("...\n", "") && part("...\n", "a\n"));
    assert!(
        part("a\n...\nd\n", "a\nb\nc\nd\n") && part("...\nb\n...\n", "a\nb\nc\n") && part("a\n...\nb\n", "a\nb\nb\n")
    );
    for (shown, real) in [
        ("a\n", ""),
        ("", "a\n"),
        ("a\n", "a\nb\n"),
        ("a\n...\nd\n", "a\nd\ne\n"),
        ("...\nb\n", "b\na\n"),
        ("a\n...\na\n", "a\n"),
        ("...\nb\n...\na\n...\n", "a\nb\n"),
    ] {
        assert!(!part(shown, real), "{shown:?} is taken for {real:?}");
    }
}

#[test]
fn a_command_or_a_listing_without_a_rule_is_an_error() {
    let mut folder = Folder::new();
    let chapter = Chapter::of(
        "none.md".into(),
        "```console\n$ milling post\n```\n```text\na\n```\n```rust\nfn a() {}\n```\n```toml\nfoo = 1\n```\n```sh\nmilling all\n```\n",
    );
    let faults: Vec<String> =
        chapter.listings().iter().filter_map(|listing| try_listing(&chapter, listing, &mut folder).err()).collect();
    let expected = [
        "`milling` is no command",
        "has no rule",
        "is not in tests/src/book.rs",
        "is no configuration",
        "is a command of none of",
    ];
    assert_eq!(faults.len(), expected.len(), "{faults:?}");
    for (fault, expected) in faults.iter().zip(expected) {
        assert!(fault.contains(expected), "{fault}");
    }
}

/// Defaults that the text of a chapter states, and the line of `config` that has them.
const DEFAULTS: &[(&str, &str, &str)] = &[
    ("docs/src/modes.md", "`auto_planes = 8`", "#auto_planes = 8"),
    ("docs/src/cl-data.md", "`cycles.bore_shift` (0.2 mm;", "#bore_shift = 0.2"),
];

#[test]
fn defaults_in_the_text_are_those_of_config() {
    let siemens = by_name::control("siemens");
    let printed = pp_runtime::config::print(&::machines::SpinnerU5620::default(), siemens);
    for (chapter, text, line) in DEFAULTS {
        let chapter_text = std::fs::read_to_string(workspace().join(chapter)).expect("a chapter");
        assert!(chapter_text.contains(text), "{chapter} has no {text}");
        assert!(printed.lines().any(|printed| printed.starts_with(line)), "`config` has no {line}");
    }
}

/// Lines of all golden programs of a control, without block numbers.
fn golden_lines(control: &str) -> Vec<String> {
    let programs =
        golden_programs().into_iter().filter(|path| path.to_string_lossy().contains(&format!(".{control}.")));
    let text: String = programs.map(|path| fs::read_to_string(path).expect("a golden program")).collect();
    assert!(!text.is_empty(), "no golden program of {control}");
    text.lines().map(|line| line.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start().to_owned()).collect()
}

/// The table of codes in the chapter about the configuration: each is in a golden program of its control.
#[test]
fn codes_of_the_table_are_in_programs_of_their_control() {
    let chapter = fs::read_to_string(workspace().join("docs/src/configuration.md")).expect("a chapter");
    let rows = chapter.lines().skip_while(|line| !line.starts_with("| | begin and end")).skip(2);
    let mut checked = 0;
    for row in rows.take_while(|line| line.starts_with('|')) {
        let mut codes = row.split('`').skip(1).step_by(2);
        let control = codes.next().expect("a control");
        let lines = golden_lines(control);
        for code in codes {
            // The words of a code, in one line of a program; numbers and what `..` stands for may be others.
            let parts: Vec<&str> = code.split(" .. ").collect();
            let found = lines.iter().any(|line| parts.iter().all(|part| line.contains(part)));
            assert!(found, "{control}: no golden program has `{code}`");
            checked += 1;
        }
    }
    assert!(checked > 25, "{checked}");
}
