//! A sheet as text that is read on a terminal and printed on paper.

use std::fmt::Write as _;

use crate::config::Config;
use crate::kinematics::{AnyMachine, DimensionKind};

use super::chain::held_axes;
use super::rows::{Expected, Group, MACHINE_ZERO, Row, Sheet, XYZ};
use crate::transformation::c::letters;

/// Longest line.
const WIDTH: usize = 96;
/// A box to tick.
pub(super) const BOX: &str = "[ ] ";
/// Blank for the value of the machine.
const BLANK: &str = "________________";

/// The text of a sheet.
pub(super) fn print(machine: &dyn AnyMachine, config: &Config, sheet: &Sheet) -> String {
    let title = format!("Compare sheet of {}: {}", machine.name(), sheet.control);
    let mut text = format!("{title}\n{}\n\n", "=".repeat(title.chars().count()));
    paragraph(
        &mut text,
        "",
        "The expected values follow from the declaration of the machine. Enter the value that the control holds next to each. \
         This sheet is compared and signed by the builder of the machine; it is not loaded into a control.",
    );
    for line in &sheet.introduction {
        text.push('\n');
        paragraph(&mut text, "", line);
    }
    text.push_str(&facts(machine, config));
    for section in &sheet.sections {
        let _ = write!(text, "\n{}\n{}\n", section.title, "-".repeat(section.title.chars().count()));
        for group in &section.groups {
            push_group(&mut text, group);
        }
    }
    heading(&mut text, "If a value differs");
    for line in &sheet.differences {
        paragraph(&mut text, "- ", line);
    }
    heading(&mut text, "Tests at the machine");
    for (number, lines) in sheet.tests.iter().enumerate() {
        for (index, line) in lines.iter().enumerate() {
            let mark = if index == 0 { format!("{}. ", number + 1) } else { "   ".to_owned() };
            // A box to tick is outside of the words, as the number is.
            match line.strip_prefix(BOX) {
                Some(line) => paragraph(&mut text, &format!("{mark}{BOX}"), line),
                None => paragraph(&mut text, &mark, line),
            }
        }
    }
    heading(&mut text, "Sources");
    for source in &sheet.sources {
        paragraph(&mut text, "- ", source);
    }
    heading(&mut text, "Compared");
    text.push_str(
        "Machine, serial number  __________________________   Software of the control  ________________\n\
         All values agree  [ ]   Differences are explained  [ ]   Tests passed:  1 [ ]   2 [ ]   3 [ ]\n\
         Name  __________________________   Date  ________________   Signature  ______________________\n",
    );
    text
}

/// The machine and the set-up that the values are for.
fn facts(machine: &dyn AnyMachine, config: &Config) -> String {
    let mut text = format!("\nChain from workpiece to tool: {}\n", letters(machine));
    for (index, dimension) in machine.dimensions().iter().enumerate() {
        let value = machine.dimension(index);
        let _ = match dimension.kind {
            DimensionKind::Length => writeln!(text, "Dimension {}: {} mm", dimension.name, fixed(value, 4)),
            DimensionKind::Angle => {
                writeln!(text, "Dimension {}: {} deg", dimension.name, fixed(value.to_degrees(), 4))
            }
        };
    }
    for letter in held_axes(machine) {
        let _ = writeln!(text, "{letter} is not part of the transformation: the values are for {letter} at zero.");
    }
    let origin = config.set_up.part_origin;
    let assumed = if config.is_given("part_origin") { "" } else { " (assumed)" };
    let zero: Vec<String> = XYZ
        .iter()
        .filter_map(|letter| Some(format!("{letter} {}", fixed(*config.set_up.machine_zero.get(letter)?, 4))))
        .collect();
    if zero.is_empty() {
        let _ = writeln!(
            text,
            "Machine coordinates are not known: `{MACHINE_ZERO}` is not given in a set-up file (--config)."
        );
    } else {
        let facts = format!(
            "Machine coordinates {} with the gauge point (no tool) on the part zero, which is X {} Y {} Z {} from the reference \
             point of the table{assumed}, and all rotary axes at zero.",
            zero.join(" "),
            fixed(origin[0], 4),
            fixed(origin[1], 4),
            fixed(origin[2], 4)
        );
        paragraph(&mut text, "", &facts);
    }
    text.push_str("Lengths are in mm: convert them for a control that is set to inches.\n");
    text
}

fn heading(text: &mut String, title: &str) {
    let _ = write!(text, "\n{title}\n{}\n", "-".repeat(title.len()));
}

fn push_group(text: &mut String, group: &Group) {
    text.push('\n');
    paragraph(text, "", &group.meaning);
    paragraph(text, "  source: ", group.source);
    for row in &group.rows {
        push_row(text, row, group.unverified.is_some());
    }
    if let Some(reason) = &group.unverified {
        paragraph(text, "  ? ", &format!("unverified: {reason}"));
    }
}

fn push_row(text: &mut String, row: &Row, unverified: bool) {
    let (value, unit) = match &row.expected {
        Expected::Millimetres(value) => (fixed(*value, 4), "mm"),
        Expected::Degrees(value) => (fixed(*value, 4), "deg"),
        Expected::Component(value) => (fixed(*value, 7), ""),
        Expected::Code(code) => (code.clone(), ""),
        Expected::Needs(key) => (format!("needs {key}"), ""),
        Expected::Any => ("any".to_owned(), ""),
    };
    let mark = if unverified { '?' } else { ' ' };
    let line = format!("{mark} {:<15} {:<33} {value:>20} {unit:<3} {BLANK}", row.number, row.name);
    let _ = writeln!(text, "{line}");
}

/// A number with a fixed number of decimals; zero has no sign.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|letter| letter == '0' || letter == '.') => rest.to_owned(),
        _ => text,
    }
}

/// Words in lines of [`WIDTH`] characters; the first line begins with `mark`, the others with as many spaces.
fn paragraph(text: &mut String, mark: &str, words: &str) {
    let indent = " ".repeat(mark.chars().count());
    let mut line = mark.to_owned();
    let mut length = indent.len();
    let mut empty = true;
    for word in words.split_whitespace() {
        let more = word.chars().count() + usize::from(!empty);
        if !empty && length + more > WIDTH {
            let _ = writeln!(text, "{line}");
            line.clone_from(&indent);
            length = indent.len();
            empty = true;
        }
        if !empty {
            line.push(' ');
            length += 1;
        }
        line.push_str(word);
        length += word.chars().count();
        empty = false;
    }
    let _ = writeln!(text, "{line}");
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, fixed, paragraph};

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(fixed(-0.00001, 4), "0.0000");
        assert_eq!(fixed(-0.00005001, 4), "-0.0001");
        assert_eq!(fixed(-12.5, 4), "-12.5000");
    }

    #[test]
    fn words_fill_lines_up_to_the_width() {
        let mut text = String::new();
        let words = ["word"; 60].join(" ");
        paragraph(&mut text, "1. ", &words);
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("1. word"));
        assert!(lines[1..].iter().all(|line| line.starts_with("   word")));
        assert!(lines.iter().all(|line| line.len() <= WIDTH && !line.ends_with(' ')));
        // A further word would not have fitted.
        assert!(lines[..lines.len() - 1].iter().all(|line| line.len() + " word".len() > WIDTH));
        assert_eq!(text.split_whitespace().filter(|word| *word == "word").count(), 60);
    }
}
