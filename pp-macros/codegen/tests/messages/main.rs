//! Every refusal of the language: its message, the words it underlines, its help line.
//!
//! Expectations are written inside the declaration: a comment line with `^` under the words, followed by the message.
//! The next comment lines may have further lines of the message after `|`, and its `help:`.

mod chain;
mod fields;
mod mistakes;
mod values;
mod verify;

use pp_codegen::{Options, generate};

#[derive(Debug, PartialEq, Eq)]
struct Message {
    line: usize,
    columns: (usize, usize),
    text: String,
}

/// Compares the messages of a declaration with the comments in it, in order.
#[track_caller]
fn check_errors(declaration: &str) {
    let mut expected = Vec::new();
    let mut helps = Vec::new();
    let mut code_line = 0;
    for (index, line) in declaration.lines().enumerate() {
        let Some(comment) = line.trim_start().strip_prefix("//") else {
            code_line = index + 1;
            continue;
        };
        if let Some(more) = comment.trim_start().strip_prefix("| ") {
            let last: &mut Message = expected.last_mut().expect("a message goes on");
            last.text += &format!("\n{more}");
            continue;
        }
        if let Some(help) = comment.trim_start().strip_prefix("help: ") {
            helps.push((expected.len() - 1, help.to_string()));
            continue;
        }
        let start = line.find('^').expect("a comment underlines something");
        let end = start + line[start..].chars().take_while(|c| *c == '^').count();
        let text = line[end..].trim().to_string();
        // `//^` underlines from the margin.
        let (start, end) = if start == 2 { (0, if end == 3 { 1 } else { end }) } else { (start, end) };
        expected.push(Message { line: code_line, columns: (start, end), text });
    }
    let found = found(declaration);
    let messages: Vec<&Message> = found.iter().map(|(message, _)| message).collect();
    assert_eq!(messages, expected.iter().collect::<Vec<_>>(), "in\n{declaration}");
    for (index, help) in helps {
        assert_eq!(found[index].1, help);
    }
    for (message, help) in &found {
        assert!(!help.is_empty() || message.text.starts_with("expected"), "no remedy: {message:?}");
    }
}

/// The messages of a declaration with their help lines, in order.
fn found(declaration: &str) -> Vec<(Message, String)> {
    let tokens = declaration.parse().expect("the declaration is Rust tokens");
    let errors = match generate(tokens, Options::default()) {
        Ok(_) => vec![],
        Err(refused) => refused.0,
    };
    errors
        .iter()
        .map(|error| {
            let (start, end) = (error.span().start(), error.span().end());
            let message = error.to_string();
            let (text, help) = message.split_once("\n\nhelp: ").unwrap_or((&message, ""));
            let columns = (start.column, if start.line == end.line { end.column } else { usize::MAX });
            (Message { line: start.line, columns, text: text.to_string() }, help.to_string())
        })
        .collect()
}
