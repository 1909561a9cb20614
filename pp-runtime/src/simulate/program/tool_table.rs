//! Tools as the machine knows them: the tool table of a control as a file.
//!
//! - LinuxCNC: a line `T1 P1 Z+120.5 D10.0 ;comment` for each tool (sample configurations of LinuxCNC, `sim.tbl`).
//! - Heidenhain TOOL.T: `BEGIN TOOL .T MM`, a line of column names, one line for each tool with its values below those
//!   names; T, NAME, L, R, R2, DL, DR (TNC7 user's manual 81762x-17, "Tool table tool.t").
//! - Lines of a program, `G10 L10 P1 R120.5`: L10 is the length of offset H, L11 or L1 with R its wear, L12 the
//!   diameter and L13 its wear (Haas, "Programmable Offsets", haas.co.uk); `G10 L1 P1 Z120.5` is LinuxCNC's (macros of
//!   its gmoccapy sample).

use std::collections::BTreeMap;

use crate::set_up::SetUp;
use crate::view::ClFacts;

/// Largest difference of lengths that are the same, mm.
const SAME_MM: f64 = 0.01;

/// A tool or an offset of a table, mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct TableTool {
    pub(crate) length_mm: Option<f64>,
    pub(crate) diameter_mm: Option<f64>,
}

/// A tool table.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct MachineToolTable {
    pub(crate) tools: BTreeMap<u32, TableTool>,
    /// The numbers are those of length offsets (H), not of tools.
    pub(crate) by_offset: bool,
}

/// The reason why a text is no tool table.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {text}")]
pub(crate) struct TableFault {
    pub(crate) line: usize,
    pub(crate) text: String,
}

/// Lines with their numbers from 1, without empty ones.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().map(|(index, line)| (index + 1, line)).filter(|(_, line)| !line.trim().is_empty())
}

impl MachineToolTable {
    /// Reads a table. `unit_mm`: length of a unit where the file states none.
    ///
    /// # Errors
    /// [`TableFault`] of the first line that is none of a tool table.
    pub(crate) fn read(text: &str, unit_mm: f64) -> Result<Self, TableFault> {
        let table = match lines(text).next() {
            Some((_, first)) if first.trim_start().starts_with("BEGIN") => Self::heidenhain(text)?,
            _ => Self::words(text, unit_mm)?,
        };
        match table.tools.is_empty() {
            true => Err(TableFault { line: 1, text: "no tool is in this file".to_owned() }),
            false => Ok(table),
        }
    }

    fn heidenhain(text: &str) -> Result<Self, TableFault> {
        let mut lines = lines(text);
        let fault = |line: usize, text: &str| Err(TableFault { line, text: text.to_owned() });
        let Some((number, first)) = lines.next() else { return fault(1, "no tool is in this file") };
        let unit_mm = match first.split_whitespace().last() {
            Some("MM") => 1.0,
            Some("INCH") => 25.4,
            _ => return fault(number, "MM or INCH is expected at the end of the line BEGIN"),
        };
        let Some((number, head)) = lines.next() else { return fault(number, "the names of the columns are missing") };
        let columns = columns(head);
        let column = |name: &str| columns.iter().find(|(other, ..)| *other == name);
        let (Some(of_number), Some(of_length)) = (column("T"), column("L")) else {
            return fault(number, "the columns T and L are expected");
        };
        let mut table = Self::default();
        for (number, line) in lines.take_while(|(_, line)| !line.trim_start().starts_with("[END]")) {
            let value = |&(name, from, to): &(&str, usize, usize)| match cell(line, from, to) {
                "" => Ok(None),
                text => text
                    .parse::<f64>()
                    .map(Some)
                    .map_err(|_| TableFault { line: number, text: format!("`{text}` in column {name} is no number") }),
            };
            let optional = |name: &str| column(name).map_or(Ok(None), value);
            let Some(tool) = value(of_number)? else { continue };
            // 5.1 is another cutting edge of tool 5.
            if tool.fract() > 0.0 || tool < 1.0 {
                continue;
            }
            let sum = |first: Option<f64>, second: Option<f64>| first.map(|first| first + second.unwrap_or(0.0));
            let length = sum(value(of_length)?, optional("DL")?);
            let radius = sum(optional("R")?, optional("DR")?);
            let known = TableTool {
                length_mm: length.map(|length| length * unit_mm),
                diameter_mm: radius.map(|radius| 2.0 * radius * unit_mm),
            };
            table.tools.insert(tool as u32, known);
        }
        Ok(table)
    }

    fn words(text: &str, unit_mm: f64) -> Result<Self, TableFault> {
        let mut table = Self::default();
        let mut wear: BTreeMap<u32, [f64; 2]> = BTreeMap::new();
        for (number, line) in lines(text) {
            let words = words(line).map_err(|text| TableFault { line: number, text })?;
            let Some(&(first, _)) = words.first() else { continue };
            let word = |letter: char| words.iter().find(|(other, _)| *other == letter).map(|(_, value)| *value);
            let whole = |letter: char| {
                word(letter).filter(|value| *value >= 1.0 && value.fract() < 1e-9).map(|value| value as u32)
            };
            let missing =
                |what: &str| Err(TableFault { line: number, text: format!("{what} is expected in this line") });
            match first {
                'T' => {
                    let Some(tool) = whole('T') else {
                        // T0 is an empty spindle.
                        if word('T').is_some_and(|tool| tool.abs() < 1e-9) {
                            continue;
                        }
                        return missing("the number of a tool");
                    };
                    let known = table.tools.entry(tool).or_default();
                    known.length_mm = word('Z').map(|length| length * unit_mm).or(known.length_mm);
                    known.diameter_mm = word('D').map(|diameter| diameter * unit_mm).or(known.diameter_mm);
                }
                'G' if word('G').is_some_and(|code| (code - 10.0).abs() < 1e-9) => {
                    table.by_offset = true;
                    let Some(offset) = whole('P') else { return missing("P, the number of the offset,") };
                    let known = table.tools.entry(offset).or_default();
                    let worn = wear.entry(offset).or_default();
                    match (word('L').map(|kind| kind as i64), word('Z'), word('R')) {
                        (Some(1), Some(length), _) | (Some(10), _, Some(length)) => {
                            known.length_mm = Some(length * unit_mm);
                        }
                        (Some(1 | 11), None, Some(by)) => worn[0] = by * unit_mm,
                        (Some(12), _, Some(diameter)) => known.diameter_mm = Some(diameter * unit_mm),
                        (Some(13), _, Some(by)) => worn[1] = by * unit_mm,
                        // Work offsets.
                        (Some(2 | 20), ..) => {}
                        _ => return missing("L10, L11, L12, L13 with R, or L1 with Z,"),
                    }
                }
                _ => return missing("T, or G10,"),
            }
        }
        for (offset, [length, diameter]) in wear {
            if let Some(known) = table.tools.get_mut(&offset) {
                known.length_mm = known.length_mm.map(|known| known + length);
                known.diameter_mm = known.diameter_mm.map(|known| known + diameter);
            }
        }
        table.tools.retain(|_, tool| *tool != TableTool::default());
        Ok(table)
    }
}

/// Names of columns with their first and last place.
fn columns(head: &str) -> Vec<(&str, usize, usize)> {
    let mut found: Vec<(&str, usize, usize)> = Vec::new();
    let mut at = 0;
    for name in head.split_whitespace() {
        at += head[at..].find(name).unwrap_or(0);
        if let Some(last) = found.last_mut() {
            last.2 = at;
        }
        found.push((name, at, usize::MAX));
        at += name.len();
    }
    found
}

/// Text of a line between two places.
fn cell(line: &str, from: usize, to: usize) -> &str {
    let end = to.min(line.len());
    line.get(from.min(end)..end).unwrap_or("").trim()
}

/// Letters with their numbers; comments and `%` are left out.
fn words(line: &str) -> Result<Vec<(char, f64)>, String> {
    let line = line.split([';', '(', '%']).next().unwrap_or("");
    let mut words = Vec::new();
    let mut rest = line.trim();
    while let Some(letter) = rest.chars().next() {
        let letter = letter.to_ascii_uppercase();
        if !letter.is_ascii_alphabetic() {
            return Err(format!("`{rest}` is no word"));
        }
        rest = rest[1..].trim_start();
        let end = rest.find(|mark: char| !(mark.is_ascii_digit() || "+-.".contains(mark))).unwrap_or(rest.len());
        let number = rest[..end].parse().map_err(|_| format!("{letter}{} is no number", &rest[..end]))?;
        words.push((letter, number));
        rest = rest[end..].trim_start();
    }
    Ok(words)
}

impl MachineToolTable {
    /// Gives the tools of a set-up the lengths that they have at the machine; returns sentences about those that differ
    /// from what was posted, and about tools that are not in the table.
    pub(crate) fn apply(&self, set_up: &mut SetUp, facts: &ClFacts) -> Vec<String> {
        let mut sentences = Vec::new();
        for (number, tool) in &facts.tools {
            let given = set_up.tools.entry(*number).or_default();
            let offset = given.offset.or(tool.call.length_offset).unwrap_or(*number);
            let entry = if self.by_offset { offset } else { *number };
            let posted = given.length_mm.or(tool.call.length_mm);
            let Some(TableTool { length_mm: Some(length_mm), diameter_mm }) = self.tools.get(&entry).copied() else {
                sentences.push(format!("tool {number} has no length in the tool table: its posted length counts"));
                continue;
            };
            match posted {
                Some(posted) if (posted - length_mm).abs() > SAME_MM => sentences.push(format!(
                    "tool {number} is {length_mm:.3} mm long in the tool table, posted with {posted:.3} mm: the simulation has \
                     {length_mm:.3} mm"
                )),
                Some(_) => {}
                None => sentences.push(format!("tool {number} is {length_mm:.3} mm long in the tool table")),
            }
            let diameter = tool.call.diameter_mm.or(given.diameter_mm);
            if let (Some(table), Some(posted)) = (diameter_mm, diameter)
                && (table - posted).abs() > SAME_MM
            {
                let text = format!(
                    "tool {number} has a diameter of {table:.3} mm in the tool table, posted with {posted:.3} mm"
                );
                sentences.push(format!("{text}: the simulation has {posted:.3} mm"));
            }
            given.length_mm = Some(length_mm);
        }
        sentences
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> MachineToolTable {
        MachineToolTable::read(text, 1.0).expect("a tool table")
    }

    fn tool(length_mm: f64, diameter_mm: f64) -> TableTool {
        TableTool { length_mm: Some(length_mm), diameter_mm: Some(diameter_mm) }
    }

    #[test]
    fn the_tables_of_three_kinds_have_lengths_and_diameters() {
        let linuxcnc = read("; tools\nT1 P1 D10.0 Z+120.5 ;mill\nT2 P7 D 8 Z-1\nT0 P0\n\n");
        assert_eq!(linuxcnc.tools, BTreeMap::from([(1, tool(120.5, 10.0)), (2, tool(-1.0, 8.0))]));
        assert!(!linuxcnc.by_offset);
        let inches = MachineToolTable::read("T3 P3 D0.5 Z4\n", 25.4).expect("a tool table");
        assert_eq!(inches.tools[&3], tool(101.6, 12.7));
        let heidenhain = read(
            "BEGIN TOOL      .T MM\n\
             T       NAME            L          R          R2        DL      DR\n\
             0       NULL            0          0          0         0       0\n\
             1       MILL_D10        +120.5     +5         +0        -0.1    +0.05\n\
             1.1     MILL_D10_2      +100       +5         +0        +0      +0\n\
             12                      +80        +4         +4\n\
             [END]\n",
        );
        assert_eq!(heidenhain.tools, BTreeMap::from([(1, tool(120.4, 10.1)), (12, tool(80.0, 8.0))]));
        let offsets = read("%\nG90 G10 L10 P1 R120.5 (mill)\n".replace("G90 ", "").as_str());
        assert_eq!(offsets.tools[&1].length_mm, Some(120.5));
        let offsets = read("G10 L10 P1 R120.\nG10 L11 P1 R-0.05\nG10 L12 P1 R10\nG10 L2 P1 X0\nG10L1P2Z80.5\n");
        assert!(offsets.by_offset);
        assert_eq!(offsets.tools[&1], tool(119.95, 10.0));
        assert_eq!(offsets.tools[&2].length_mm, Some(80.5));
    }

    #[test]
    fn a_text_that_is_no_tool_table_is_refused_at_its_line() {
        let fault = |text: &str| MachineToolTable::read(text, 1.0).expect_err("no table").to_string();
        assert_eq!(fault("T1 Z1\nX0 Y0\n"), "line 2: T, or G10, is expected in this line");
        assert_eq!(fault("T1 Z1..2\n"), "line 1: Z1..2 is no number");
        assert_eq!(fault("G10 L10 R5\n"), "line 1: P, the number of the offset, is expected in this line");
        assert_eq!(fault("BEGIN TOOL .T MM\nT NAME\n"), "line 2: the columns T and L are expected");
        assert!(fault("BEGIN TOOL .T MM\nT   L\n1   abc\n").contains("`abc` in column L is no number"));
        assert_eq!(fault(";\n"), "line 1: no tool is in this file");
    }
}
