//! The table of a language as text.

use std::io::{self, Write};

use super::super::Family;
use super::super::orders::Letters;
use super::arguments::{ArgumentRole, List};
use super::{CodeRow, Language, group};

/// Names of the columns.
const HEADS: [&str; 8] = ["spelling", "meaning", "reads", "changes", "moves", "takes", "group", "source"];

/// Names of the groups of which a block has one code, by their number.
const GROUPS: [(u32, &str); 33] = [
    (group::MOTION, "motion"),
    (group::PLANE, "plane"),
    (group::DISTANCE, "distance"),
    (group::FEED, "feed mode"),
    (group::UNITS, "unit"),
    (group::SIDE, "compensation"),
    (group::LENGTH, "length"),
    (group::OFFSET, "work offset"),
    (group::RETURN, "return level"),
    (group::PATH, "path mode"),
    (group::TILT, "tilted plane"),
    (group::ALONE, "not modal"),
    (group::STOP, "stop"),
    (group::SPINDLE, "spindle"),
    (group::CENTRE, "centre"),
    (group::COOLANT, "any number"),
    (group::CHANGE, "tool change"),
    (group::SMOOTHING, "smoothing"),
    (group::RIGID, "rigid"),
    (group::TIP, "tip control"),
    (group::WAY, "rotary path"),
    (group::CALL, "cycle call"),
    (group::WINDOW, "window"),
    (group::POSTURE, "posture"),
    (group::FRAME, "frame"),
    (group::DYNAMIC_OFFSET, "dynamic offset"),
    (group::SCALING, "scaling"),
    (group::POLAR, "polar coordinates"),
    (group::SETTING_ERROR, "setting error"),
    (group::SPINDLE_MODE, "meaning of S"),
    (group::DIAMETER, "diameter"),
    (group::ROTATION, "rotation"),
    (group::SHIFT, "shift"),
];

/// Name of a group; `None` where it is no modal group.
pub(super) fn group_name(group: u32) -> Option<&'static str> {
    GROUPS.iter().find(|(number, _)| *number == group).map(|(_, name)| *name)
}

/// Writes the codes and words of a family in columns, then the lists of arguments.
pub(crate) fn table(family: Family, out: &mut dyn Write) -> io::Result<()> {
    let language = family.language();
    let rows: Vec<[String; 8]> = rows(language).map(cells).collect();
    let mut widths = HEADS.map(str::len);
    for row in &rows {
        widths.iter_mut().zip(row).for_each(|(width, cell)| *width = (*width).max(cell.len()));
    }
    let line = |out: &mut dyn Write, cells: &[String; 8]| {
        let (last, first) = (&cells[7], &cells[..7]);
        first.iter().zip(widths).try_for_each(|(cell, width)| write!(out, "{cell:width$}  "))?;
        writeln!(out, "{last}")
    };
    line(out, &HEADS.map(str::to_owned))?;
    rows.iter().try_for_each(|row| line(out, row))?;
    language.lists.iter().try_for_each(|list| arguments(list, out))
}

fn rows(language: &Language) -> impl Iterator<Item = &'static CodeRow> {
    language.codes.iter().chain(language.letters).chain(language.words)
}

fn cells(row: &'static CodeRow) -> [String; 8] {
    let [reads, changes, moves] = row.means.effect().map(str::to_owned);
    let together = group_name(row.group).unwrap_or("-");
    let several = row.key != row.last;
    let spelling = match several {
        true => format!("{} .. {}{}", row.spelling, &row.spelling[..1], CodeRow::number(row.last) / 10),
        false => row.spelling.to_owned(),
    };
    [
        spelling,
        row.means.text().to_owned(),
        reads,
        changes,
        moves,
        takes(row.takes, row.needs),
        together.to_owned(),
        row.source.to_owned(),
    ]
}

/// Address words of a code; those that it needs without brackets.
fn takes(takes: Letters, needs: Letters) -> String {
    let letters = ('A'..='Z').enumerate().filter(|(index, _)| takes & (1 << index) != 0);
    let words = letters.map(|(index, letter)| match needs & (1 << index) != 0 {
        true => letter.to_string(),
        false => format!("[{letter}]"),
    });
    let words: Vec<String> = words.collect();
    if words.is_empty() { "-".to_owned() } else { words.join(" ") }
}

/// A call or a cycle with the meaning of each of its arguments.
fn arguments(list: &List, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{}: {}. {}", list.name, list.meaning, list.source)?;
    for item in list.items {
        let name = if item.number > 0 { format!("Q{} {}", item.number, item.name) } else { item.name.to_owned() };
        let meaning = match item.role {
            ArgumentRole::Must(value) => format!("must be {value}"),
            ArgumentRole::May(value) => format!("must be {value} or missing"),
            ArgumentRole::Empty => "must be missing".to_owned(),
            ArgumentRole::Name => "must be the swivel data of the configuration".to_owned(),
            ArgumentRole::Text => "text".to_owned(),
            ArgumentRole::Needs(_) => "executed".to_owned(),
            ArgumentRole::Whole(_) => "executed, a whole number".to_owned(),
            ArgumentRole::Takes(_) => "executed, may be missing".to_owned(),
        };
        writeln!(out, "    {name:40}  {meaning}")?;
    }
    Ok(())
}
