//! The page of the codes, `docs/src/message-codes.md`: made from the table of the product. Each code is used.

use std::fs;
use std::path::{Path, PathBuf};

use pp_runtime::diag::Code;
use tests::binaries::workspace;
use tests::environment;

use crate::{assert_none, chapter};

const TOP: &str = "# Codes of the messages

With `--message-format json` each error, warning and finding has a `code`. It names the class of the message, and stays
when wording and numbers change: a program that acts on messages compares codes, not texts. New codes may come. In Rust it
is the field `code` of `Diagnostic` and `Finding`. [Messages, one by one](messages.md) has the texts.
";

/// The stages, in the order of the table.
const STAGES: &[(&str, &str)] = &[
    ("run", "The run: command line and files"),
    ("config", "The configuration"),
    ("control", "Control and configuration together"),
    ("cl", "Reading the CL data"),
    ("plan", "Planning for the machine"),
    ("check", "Comparing the program with its CL data"),
    ("simulate", "Simulation"),
];

fn stage(code: Code) -> (&'static str, &'static str) {
    code.name().split_once('/').expect("stage and subject")
}

fn page() -> String {
    let mut page = TOP.to_owned();
    for (name, title) in STAGES {
        page += &format!("\n## {title}\n\n| code | |\n|---|---|\n");
        for code in Code::all().iter().filter(|code| stage(**code).0 == *name) {
            page += &format!("| `{}` | {} |\n", code.name(), code.meaning());
        }
    }
    page
}

#[test]
fn the_page_of_the_codes_is_the_table_of_the_product() {
    assert!(Code::all().iter().all(|code| STAGES.iter().any(|(name, _)| *name == stage(*code).0)));
    let path = workspace().join(chapter::SOURCE).join("message-codes.md");
    if environment::blesses() {
        fs::write(path, page()).expect("it can be written");
        return;
    }
    assert!(fs::read_to_string(path).is_ok_and(|found| found == page()), "the page differs: write it with PP_BLESS=1");
}

/// Text of all Rust sources of a folder but the table of the codes.
fn sources(folder: &Path, text: &mut String) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path: PathBuf = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, text);
        } else if path.extension().is_some_and(|end| end == "rs") && !path.ends_with("diag/code.rs") {
            *text += &fs::read_to_string(&path).expect("it can be read");
        }
    }
}

#[test]
fn each_code_is_used_in_the_sources() {
    let mut text = String::new();
    sources(&workspace().join("pp-runtime/src"), &mut text);
    let used = |code: Code| {
        let (stage, subject) = stage(code);
        let name = subject.replace('-', "_").to_uppercase();
        let is_whole = |rest: &str| !rest.starts_with(|next: char| next.is_ascii_uppercase() || next == '_');
        [format!("{stage}::{name}"), format!("{stage}_code::{name}")]
            .iter()
            .any(|wanted| text.split(wanted.as_str()).skip(1).any(is_whole))
    };
    let unused = Code::all().iter().filter(|code| !used(**code)).map(|code| format!("{code} is used nowhere"));
    assert_none(&unused.collect::<Vec<_>>());
}
