//! The page of the messages, `docs/src/messages.md`: made from cases that are posted, so that each message and its
//! remedy are those of the product.
//!
//! `messages.txt` has the cases. A line `## ..` begins a group. A case ends with an empty line; its lines are
//!
//! - `cause: ..`: why it is refused, a sentence for the page;
//! - `config: ..`: a line of the configuration;
//! - `options: ..`: options of the command;
//! - `machine: ..`: the binary, if not `spinner-u5-620`;
//! - `edit: .. => ..`, `delete: ..`: text of the posted program that is replaced or deleted, everywhere (`\n` is the
//!   end of a line); the edited program is checked;
//! - `whole`: the CL data is as written, without the usual first lines;
//! - all others: the CL data.

use std::fs;

use serde_json::Value;
use tests::binaries::workspace;
use tests::environment;

use crate::{assert_none, chapter, machines};

const CASES: &str = include_str!("messages.txt");

/// First lines of the CL data of a case.
const HEAD: &str = "UNITS/MM\nLOADTL/1,LENGTH,100\nSPINDL/RPM,3000,CLW\nFEDRAT/MMPM,500\n";

const TOP: &str = "# Messages, one by one

Each message was made by posting a faulty part, or by checking a damaged program. **Bold** is the message, with the numbers of
that part; after it comes the cause, and after the arrow the remedy that is printed with it. What the message itself makes plain
has no further remedy. Not every message is here: rarer ones have the same form, and their remedy with them.
[When posting is refused](refused.md) explains how to read them; in messages as JSON each has one of the [codes](message-codes.md).
";

#[derive(Debug, Default)]
struct Case<'a> {
    line: usize,
    cause: &'a str,
    config: String,
    options: Vec<&'a str>,
    machine: Option<&'a str>,
    edits: Vec<(String, String)>,
    cl: String,
    whole: bool,
}

/// Text of an edit, with ends of lines.
fn lines_of(text: &str) -> String {
    text.replace("\\n", "\n")
}

impl<'a> Case<'a> {
    fn read(first: usize, lines: &[&'a str]) -> Self {
        let mut case = Self { line: first + 1, ..Self::default() };
        for line in lines {
            match line.split_once(": ").unwrap_or((line, "")) {
                ("cause", text) => case.cause = text,
                ("config", text) => case.config.extend([text, "\n"]),
                ("options", text) => case.options.extend(text.split(' ')),
                ("machine", text) => case.machine = Some(text),
                ("edit", text) => {
                    let (old, new) = text.split_once(" => ").expect("an edit has ` => `");
                    case.edits.push((lines_of(old), lines_of(new)));
                }
                ("delete", text) => case.edits.push((lines_of(text), String::new())),
                ("whole", "") => case.whole = true,
                _ => case.cl.extend([line, "\n"]),
            }
        }
        assert!(case.cause.ends_with('.'), "messages.txt:{}: a cause is a sentence", case.line);
        case
    }

    /// The first message of this case: text and remedy.
    fn message(&self) -> Result<(String, Option<String>), String> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = |name: &str, text: &str| {
            let path = folder.path().join(name);
            fs::write(&path, text).expect("a file can be written");
            path.to_str().expect("a path in UTF-8").to_owned()
        };
        let head = if self.whole { "" } else { HEAD };
        let cl = file("part.cls", &format!("{head}{}", self.cl));
        let config = file("part.toml", &self.config);
        let run = |arguments: &[&str]| {
            let machine = self.machine.unwrap_or("spinner-u5-620");
            machines::run(machine, &[arguments, &["--config", config.as_str()], &self.options[..]].concat())
        };
        let program = file("part.nc", "");
        let (_, mut messages) = run(&["post", &cl, "-o", &program, "--message-format", "json"]);
        if !self.edits.is_empty() {
            let mut text = fs::read_to_string(&program).expect("the program");
            for (old, new) in &self.edits {
                if !text.contains(old) {
                    return Err(format!("the program has no `{old}`:\n{text}"));
                }
                text = text.replace(old, new);
            }
            (_, messages) = run(&["check", &cl, &file("part.nc", &text), "--json"]);
        }
        let mut errors = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        let error = errors.find(|message| message["severity"] == "error");
        let error = error.ok_or_else(|| format!("nothing is refused:\n{messages}"))?;
        let text = |key: &str| error[key].as_str().map(str::to_owned);
        Ok((text("text").ok_or("a message without text")?, text("help")))
    }
}

#[test]
fn the_page_of_messages_has_what_is_printed() {
    let lines: Vec<&str> = CASES.lines().collect();
    let mut page = TOP.to_owned();
    let mut found = Vec::new();
    let mut first = 0;
    for piece in lines.split(|line| line.is_empty()) {
        let at = first;
        first += piece.len() + 1;
        match piece {
            [] => (),
            [heading] if heading.starts_with("## ") => page.extend(["\n", heading, "\n\n"]),
            _ => {
                let case = Case::read(at, piece);
                match case.message() {
                    Ok((text, help)) => {
                        let remedy = help.map(|help| format!(" → {help}")).unwrap_or_default();
                        page.push_str(&format!("- **{text}** {}{remedy}\n", case.cause));
                    }
                    Err(fault) => found.push(format!("messages.txt:{}: {fault}", case.line)),
                }
            }
        }
    }
    assert_none(&found);
    let path = workspace().join(chapter::SOURCE).join("messages.md");
    let written = fs::read_to_string(&path).unwrap_or_default();
    if environment::blesses() {
        fs::write(&path, page).expect("the page can be written");
    } else {
        assert_eq!(written, page, "PP_BLESS=1 rewrites the page: read every changed line");
    }
}
