//! Writers of CL data in three dialects of APT: NX, CATIA and Creo.
//!
//! Each file states its units and tools, so that it can be posted without a configuration. Only the records that these
//! parts need are written: straight motions, one spindle speed per operation, coolant.

use pp_runtime::cl::record::{CoordinateRecord, MachineRecord, ProgramRecord, Record};
use pp_runtime::kinematics::Pose;
use pp_runtime::program::{Coolant, Spindle, Units};

use crate::parts::{Move, Operation, Program, Tool};

/// A number with a fixed number of decimals; zero has no sign.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// Numbers with a fixed number of decimals, each in a field, with a separator between them.
fn fields(values: &[f64], width: usize, decimals: usize, separator: &str) -> String {
    let texts: Vec<String> = values.iter().map(|&value| format!("{:>width$}", fixed(value, decimals))).collect();
    texts.join(separator)
}

/// Lines of text.
#[derive(Default)]
struct Lines(String);

impl Lines {
    fn push(&mut self, line: &str) {
        self.0.push_str(line);
        self.0.push('\n');
    }

    /// Adds a record whose numbers need no field.
    fn record(&mut self, record: Record<'_>) {
        self.push(&record.to_string());
    }
}

/// NX CLSF: xyz with 4 decimals, ijk with 7 and only where they change, colours of the path between the motions.
///
/// Real NX files do not state units, spindle and coolant; these do.
#[must_use]
pub fn nx(program: &Program) -> String {
    let mut lines = Lines::default();
    lines.push(&format!("PARTNO {}", program.name));
    lines.record(Record::Coordinates(CoordinateRecord::Units(Units::Millimetres)));
    for (index, operation) in program.operations.iter().enumerate() {
        if index > 0 {
            lines.record(Record::Program(ProgramRecord::Stop));
        }
        nx_operation(&mut lines, operation);
    }
    lines.0
}

fn nx_operation(lines: &mut Lines, operation: &Operation) {
    let Tool { number, name, diameter_mm, corner_radius_mm, flute_length_mm, gauge_length_mm } = &operation.tool;
    lines.push(&format!("TOOL PATH/{},TOOL,{name}", operation.name));
    lines.push(&format!(
        "TLDATA/MILL,{}",
        fields(&[*diameter_mm, *corner_radius_mm, *flute_length_mm, 0.0, 0.0], 0, 4, ",")
    ));
    let origin = fields(&[0.0; 3], 0, 4, ",");
    lines.push(&format!("MSYS/{origin},{}", fields(&[1.0, 0.0, 0.0, 0.0, 1.0, 0.0], 0, 7, ",")));
    lines.push("$$ centerline data");
    lines.push("PAINT/PATH");
    lines.push("PAINT/SPEED,10");
    match gauge_length_mm {
        Some(length) => lines.push(&format!("LOADTL/{number},LENGTH,{}", fixed(*length, 4))),
        None => lines.push(&format!("LOAD/TOOL,{number}")),
    }
    lines.push(&format!("SPINDL/RPM,{},CLW", fixed(operation.speed_rev_per_min, 0)));
    lines.record(Record::Machine(MachineRecord::Coolant(Coolant::On)));
    let (mut feed, mut axis, mut colour) = (None, String::new(), 0);
    let colours = colours(&operation.moves);
    for (step, &wanted) in operation.moves.iter().zip(&colours) {
        if colour != wanted {
            colour = wanted;
            lines.push(&format!("PAINT/COLOR,{colour}"));
        }
        match step.feed_mm_per_min {
            None => lines.record(Record::Machine(MachineRecord::Rapid)),
            Some(value) if feed != step.feed_mm_per_min => {
                feed = step.feed_mm_per_min;
                lines.push(&format!("FEDRAT/MMPM,{}", fixed(value, 4)));
            }
            Some(_) => {}
        }
        let mut record = format!("GOTO/{}", fields(step.pose.tip.coords.as_slice(), 0, 4, ","));
        let direction = fields(step.pose.axis.as_slice(), 0, 7, ",");
        if direction != axis {
            record = format!("{record},{direction}");
            axis = direction;
        }
        lines.push(&record);
    }
    lines.record(Record::Machine(MachineRecord::Spindle(Spindle::Off)));
    lines.record(Record::Machine(MachineRecord::Coolant(Coolant::Off)));
    lines.push("PAINT/SPEED,10");
    lines.push("PAINT/TOOL,NOMORE");
    lines.record(Record::Program(ProgramRecord::EndOfPath));
}

/// Colours of the motions: retract 211, approach 186, plunge 42, cut 31.
fn colours(moves: &[Move]) -> Vec<u32> {
    moves
        .iter()
        .enumerate()
        .map(|(index, step)| {
            let before = index.checked_sub(1).and_then(|before| moves[before].feed_mm_per_min);
            match (step.feed_mm_per_min, before) {
                (None, None) => 186,
                (None, Some(_)) => 211,
                (Some(_), None) => 42,
                (Some(_), Some(_)) => 31,
            }
        })
        .collect()
}

/// Column after which CATIA breaks a long record.
const CATIA_COLUMNS: usize = 71;

/// CATIA aptsource: wide fields; a long GOTO is broken after 71 characters, even inside a number.
#[must_use]
pub fn catia(program: &Program) -> String {
    let mut lines = Lines::default();
    let rule = format!("$$ {}", "-".repeat(65));
    lines.push(&rule);
    lines.push("$$     CATIA APT VERSION 1.0");
    lines.push(&rule);
    lines.push("$$ Manufacturing Program.1");
    lines.push(&format!("$$  {}", program.name));
    lines.push("$$*CATIA0");
    lines.push("$$ Manufacturing Program.1");
    for row in [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]] {
        lines.push(&format!("$$ {}", fields(&row, 11, 5, " ")));
    }
    lines.push(&format!("PARTNO {}", program.name));
    lines.record(Record::Coordinates(CoordinateRecord::Units(Units::Millimetres)));
    for (index, operation) in program.operations.iter().enumerate() {
        if index > 0 {
            lines.record(Record::Program(ProgramRecord::Stop));
        }
        catia_operation(&mut lines, operation);
    }
    lines.record(Record::Program(ProgramRecord::Rewind));
    lines.record(Record::Program(ProgramRecord::End));
    lines.0
}

fn catia_operation(lines: &mut Lines, operation: &Operation) {
    let Tool { number, name, diameter_mm, corner_radius_mm, flute_length_mm, gauge_length_mm } = &operation.tool;
    lines.push("$$ OPERATION NAME : Tool Change");
    lines.push("$$ TOOLCHANGEBEGINNING");
    let middle = diameter_mm / 2.0 - corner_radius_mm;
    let shape = fields(&[*diameter_mm, *corner_radius_mm, middle, *corner_radius_mm, 0.0], 10, 6, ",");
    lines.push(&format!("CUTTER/{shape},$"));
    lines.push(&format!("       {}", fields(&[0.0, *flute_length_mm], 10, 6, ",")));
    lines.push(&format!("TPRINT/T{number} {name}"));
    match gauge_length_mm {
        Some(length) => lines.push(&format!("LOADTL/{number},LENGTH,{}", fields(&[*length], 11, 6, ","))),
        None => lines.push(&format!("LOADTL/{number}")),
    }
    lines.push("$$ TOOLCHANGEEND");
    lines.push(&format!("$$ OPERATION NAME : {}", operation.name));
    lines.push("MULTAX");
    lines.push(&format!("SPINDL/{},RPM,CLW", fields(&[operation.speed_rev_per_min], 10, 4, ",")));
    lines.record(Record::Machine(MachineRecord::Coolant(Coolant::On)));
    let mut feed = None;
    for step in &operation.moves {
        match step.feed_mm_per_min {
            None => lines.record(Record::Machine(MachineRecord::Rapid)),
            Some(value) if feed != step.feed_mm_per_min => {
                feed = step.feed_mm_per_min;
                lines.push(&format!("FEDRAT/{},MMPM", fields(&[value], 10, 4, ",")));
            }
            Some(_) => {}
        }
        catia_record(lines, &format!("GOTO  /{}", fields(&six(&step.pose), 11, 6, ",")));
    }
    lines.record(Record::Machine(MachineRecord::Coolant(Coolant::Off)));
    lines.record(Record::Machine(MachineRecord::Spindle(Spindle::Off)));
}

/// Adds a record, broken at the column where it is too long.
fn catia_record(lines: &mut Lines, record: &str) {
    let mut rest = record;
    while rest.len() > CATIA_COLUMNS {
        let (line, more) = rest.split_at(CATIA_COLUMNS);
        lines.push(&format!("{line}$"));
        rest = more;
    }
    lines.push(rest);
}

fn six(pose: &Pose) -> [f64; 6] {
    let (tip, axis) = (pose.tip, pose.axis);
    [tip.x, tip.y, tip.z, axis.x, axis.y, axis.z]
}

/// Creo NCL: `WORD / a, b`, 10 decimals, continued after a comma, additional data in `$$->` comments.
#[must_use]
pub fn creo(program: &Program) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        text.push_str(&line);
        text.push('\n');
    };
    line("$$*          Pro/CLfile  Version 8.0".to_owned());
    line(format!("$$-> MFGNO / {}", program.name));
    line(format!("PARTNO / {}", program.name));
    line("UNITS / MM".to_owned());
    for (index, operation) in program.operations.iter().enumerate() {
        if index > 0 {
            line("STOP".to_owned());
        }
        let Tool { number, diameter_mm, gauge_length_mm, .. } = &operation.tool;
        line(format!("$$-> FEATNO / {}", index + 1));
        match gauge_length_mm {
            Some(length) => line(format!("LOADTL / {number}, LENGTH, {}", fixed(*length, 6))),
            None => line(format!("LOADTL / {number}")),
        }
        line(format!("$$-> CUTTER / {}", fixed(*diameter_mm, 6)));
        line(format!("$$-> CSYS / {},  $", fields(&[1.0, 0.0, 0.0, 0.0], 0, 10, ", ")));
        line(format!("            {},  $", fields(&[0.0, 1.0, 0.0, 0.0], 0, 10, ", ")));
        line(format!("            {}", fields(&[0.0, 0.0, 1.0, 0.0], 0, 10, ", ")));
        line("MULTAX / ON".to_owned());
        line(format!("SPINDL / RPM, {},  CLW", fixed(operation.speed_rev_per_min, 6)));
        line("COOLNT / ON".to_owned());
        let mut feed = None;
        for step in &operation.moves {
            match step.feed_mm_per_min {
                None => line("RAPID".to_owned()),
                Some(value) if feed != step.feed_mm_per_min => {
                    feed = step.feed_mm_per_min;
                    line(format!("FEDRAT / {},  MMPM", fixed(value, 6)));
                }
                Some(_) => {}
            }
            line(format!("GOTO / {},  $", fields(step.pose.tip.coords.as_slice(), 0, 10, ", ")));
            line(fields(step.pose.axis.as_slice(), 0, 10, ", "));
        }
        line("COOLNT / OFF".to_owned());
        line("SPINDL / OFF".to_owned());
    }
    line("$$-> END /".to_owned());
    line("FINI".to_owned());
    text
}

#[cfg(test)]
mod tests {
    use super::{catia, creo, fixed, nx};
    use crate::parts;

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(fixed(-0.000_01, 4), "0.0000");
        assert_eq!(fixed(-0.000_06, 4), "-0.0001");
    }

    #[test]
    fn nx_states_the_axis_where_it_changes_and_at_the_start_of_an_operation() {
        let text = nx(&parts::two_tools());
        let numbers: Vec<usize> =
            text.lines().filter_map(|line| line.strip_prefix("GOTO/")).map(|line| line.split(',').count()).collect();
        assert_eq!(numbers.iter().filter(|&&count| count == 6).count(), 2);
        assert!(numbers.iter().all(|count| matches!(count, 3 | 6)) && numbers.len() > 15);
    }

    #[test]
    fn catia_cuts_a_record_after_71_characters() {
        let text = catia(&parts::concave_one_way());
        let long: Vec<&str> = text.lines().filter(|line| line.ends_with('$') && line.starts_with("GOTO")).collect();
        assert!(long.len() > 400 && long.iter().all(|line| line.len() == 72));
        let joined = text.replace("$\n", "");
        let record = joined.lines().find(|line| line.starts_with("GOTO")).unwrap_or_default();
        assert_eq!(record.split(',').filter(|number| number.trim().len() >= 8).count(), 6, "{record}");
    }

    #[test]
    fn creo_continues_after_a_comma() {
        let text = creo(&parts::concave_zig_zag());
        assert!(text.lines().filter(|line| line.ends_with('$')).all(|line| line.ends_with(",  $")));
    }

    #[test]
    fn axes_are_as_unit_as_their_digits_allow() {
        for (name, text) in crate::files() {
            let text = text.replace(",  $\n", ", ").replace("$\n", "");
            for record in text.lines().filter(|line| line.starts_with("GOTO")) {
                let numbers = record.split_once('/').map_or("", |(_, numbers)| numbers).split(',');
                let values: Vec<f64> =
                    numbers.map(|number| number.trim().parse().expect("a GOTO is made of numbers")).collect();
                if let [_, _, _, i, j, k] = values[..] {
                    assert!((i.hypot(j).hypot(k) - 1.0).abs() < 1e-6, "{name}: {record}");
                } else {
                    assert_eq!(values.len(), 3, "{name}: {record}");
                }
            }
        }
    }
}
