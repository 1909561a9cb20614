//! Prints all keys with their defaults as a commented sample file.

use std::fmt::Write as _;

use crate::control::Control;
use crate::keys::{KeyList, KeyRow, KeyScope, Printed};
use crate::kinematics::AnyMachine;

use super::dimensions::meanings;
use super::read::scope;
use super::starting_point;

/// Largest width of a comment line, in characters.
const WIDTH: usize = 120;

/// Returns a configuration file for `machine` and `control` with every default commented out, and with the places at
/// the machine where its numbers are found.
///
/// A line that begins with `#` and a key is a default; a line that begins with `# e.g.` shows a key without default.
/// Read back unchanged the file gives the [`starting_point`] with the name of its control, so that unchanged keys stay
/// marked as assumed.
#[must_use]
pub fn print(machine: &dyn AnyMachine, control: &dyn Control) -> String {
    let scope = KeyScope { examples: control.spellings().examples, ..scope(machine) };
    let mut list = KeyList::of(&starting_point(control), scope);
    list.leave_out(control.spellings().unused_keys);
    for found in control.spellings().found_at {
        list.add_note(found.key, &found.comment());
    }
    list.add_note("dimensions", &meanings(machine));
    let mut text = format!(
        r#"# Set-up for {}, control {}. With `--config` and this file commands need no `--control`: see `name` in `[control]`.
#
# Number formats that are not set here are those of the control.
# A line that begins with `#` and a key shows a default: remove the `#` and change the value.
# A line that begins with `# e.g.` shows a key that has no default.
# A key that is not set here is marked as assumed in the summary and in the header of the program.
# Angles are in degrees, speeds per minute, lengths in the unit of this file.

# Unit of length of this file: "mm" or "in".
units = "mm"
"#,
        machine.name(),
        control.spellings().title,
    );
    // Writing to a string cannot fail.
    let _ = print_above(&mut text, list.rows());
    for section in sections(list.rows()) {
        let _ = print_section(&mut text, section, &list, control.spellings().name);
    }
    text
}

/// Sections in the order of their first keys.
fn sections(rows: &[KeyRow]) -> Vec<&'static str> {
    let mut sections = Vec::new();
    for row in rows {
        let section = match (row.path.split_once('.'), &row.printed) {
            (Some((section, _)), _) => section,
            (None, Printed::Section(entries)) if !entries.is_empty() => row.path,
            (None, Printed::Section(_) | Printed::Default(_) | Printed::Example(_)) => continue,
        };
        if !sections.contains(&section) {
            sections.push(section);
        }
    }
    sections
}

/// Prints the keys before the first section, with an empty line between tables of options.
fn print_above(out: &mut String, rows: &[KeyRow]) -> std::fmt::Result {
    let mut group = 0;
    for row in rows.iter().filter(|row| !row.path.contains('.')) {
        if matches!(row.printed, Printed::Section(_)) {
            continue;
        }
        if group != row.group {
            writeln!(out)?;
        }
        group = row.group;
        print_comment(out, &row.text)?;
        print_comment(out, &row.note)?;
        print_key(out, row.path, &row.printed)?;
    }
    Ok(())
}

/// `control`: name of the control, which is the only key that is set.
fn print_section(out: &mut String, section: &str, list: &KeyList, control: &str) -> std::fmt::Result {
    writeln!(out)?;
    let entries = list.rows().iter().find(|row| row.path == section);
    print_comment(out, entries.map_or_else(|| list.heading(section), |row| &row.text))?;
    print_comment(out, entries.map_or("", |row| &row.note))?;
    writeln!(out, "[{section}]")?;
    if let Some(Printed::Section(entries)) = entries.map(|row| &row.printed) {
        for (name, printed) in entries {
            print_key(out, name, printed)?;
        }
    }
    for row in list.rows() {
        if let Some((_, key)) = row.path.split_once('.').filter(|(head, _)| *head == section) {
            print_comment(out, &row.text)?;
            print_comment(out, &row.note)?;
            match row.path {
                "control.name" => writeln!(out, "{key} = \"{control}\"")?,
                _ => print_key(out, key, &row.printed)?,
            }
        }
    }
    Ok(())
}

fn print_key(out: &mut String, key: &str, printed: &Printed) -> std::fmt::Result {
    match printed {
        Printed::Default(value) => writeln!(out, "#{key} = {value}"),
        Printed::Example(value) => writeln!(out, "# e.g. {key} = {value}"),
        Printed::Section(_) => Ok(()),
    }
}

/// Prints text as comment lines.
fn print_comment(out: &mut String, text: &str) -> std::fmt::Result {
    let mut width = 0;
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        let length = word.chars().count() + 1;
        if width > 0 && width + length > WIDTH {
            writeln!(out)?;
            width = 0;
        }
        if width == 0 {
            write!(out, "#")?;
            width = 1;
        }
        write!(out, " {word}")?;
        width += length;
    }
    if width > 0 { writeln!(out) } else { Ok(()) }
}
