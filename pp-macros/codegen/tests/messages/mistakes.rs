//! Declarations as people get them wrong, each with all its messages.
//!
//! `mistakes.txt` has a declaration after each title, and after each of its lines the messages as comments, with the
//! words that they underline. `PP_BLESS=1` writes the comments again: read each as someone would who made that mistake.

use super::found;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/messages/mistakes.txt");

/// A title and its declaration without messages.
fn cases(text: &str) -> Vec<(&str, String)> {
    let mut cases: Vec<(&str, String)> = Vec::new();
    for line in text.lines() {
        if let Some(title) = line.strip_prefix("=== ") {
            cases.push((title, String::new()));
        } else if let Some((_, declaration)) = cases.last_mut()
            && !line.trim_start().starts_with("//")
            && !line.is_empty()
        {
            *declaration += &format!("{line}\n");
        }
    }
    cases
}

/// A declaration with its messages after the lines that they underline.
fn answered(declaration: &str) -> String {
    let messages = found(declaration);
    let mut text = String::new();
    for (index, line) in declaration.lines().enumerate() {
        text += &format!("{line}\n");
        for (message, help) in messages.iter().filter(|(message, _)| message.line == index + 1) {
            let (start, end) = message.columns;
            let end = if end == usize::MAX { line.len() } else { end };
            // `//` takes the place of the first two columns.
            let margin = if start < 2 { "//".to_string() + " " } else { format!("//{}", " ".repeat(start - 2)) };
            let mut lines = message.text.lines();
            text += &format!("{margin}{} {}\n", "^".repeat((end - start).max(1)), lines.next().unwrap_or_default());
            for more in lines {
                text += &format!("// | {more}\n");
            }
            if !help.is_empty() {
                text += &format!("// help: {help}\n");
            }
        }
    }
    text
}

#[test]
fn mistakes_of_all_kinds_have_their_messages() {
    let text = std::fs::read_to_string(FILE).expect("a file of this package");
    let cases = cases(&text);
    assert!(cases.len() >= 80, "{} mistakes", cases.len());
    let mut answers = String::new();
    for (title, declaration) in &cases {
        let answer = answered(declaration);
        assert!(answer.contains("\n//"), "{title}: accepted\n{declaration}");
        answers += &format!("=== {title}\n{answer}\n");
    }
    let answers = format!("{}\n", answers.trim_end());
    if std::env::var_os("PP_BLESS").is_some() {
        std::fs::write(FILE, answers).expect("a file of this package");
        return;
    }
    for ((found, expected), (title, _)) in answers.split("=== ").zip(text.split("=== ")).skip(1).zip(&cases) {
        assert_eq!(found, expected, "{title}");
    }
    assert_eq!(answers, text);
}
