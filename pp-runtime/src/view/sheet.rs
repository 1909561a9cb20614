//! Facts about a program as lists and tables: for the summary of the page and for the set-up sheet.

use std::collections::BTreeMap;
use std::io;

use serde::Serialize;

use crate::kinematics::AxisKind;
use crate::post::duration;
use crate::set_up::{Clamping, part_angles};

use super::executed::Executed;
use super::head::{Found, Tool, ViewOperation, operations, tools};
use super::{ViewedProgram, picture};

/// The facts of a sheet; lengths in mm, angles in degrees, times in seconds.
#[derive(Debug, Serialize)]
pub(crate) struct JobSheet<'a> {
    pub(crate) program: &'a str,
    cl: &'a str,
    machine: &'a str,
    control: &'a str,
    seconds: f64,
    /// There are rapids of axes without a known speed, whose time is not in `seconds`.
    unknown_speeds: bool,
    set_ups: Vec<SheetSetUp>,
    tools: Vec<UsedTool>,
    check: Check<'a>,
    warnings: &'a [String],
    summary: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    jog_sheet: Option<&'a [&'static str]>,
}

/// Largest difference of coordinates that are printed alike, mm or degrees.
const SAME_COORDINATE: f64 = 5e-4;

/// A clamping of the part and what is done in it.
#[derive(Debug, Serialize)]
struct SheetSetUp {
    number: u32,
    work_offset: String,
    /// Its linear entries, as far as the configuration gives them, mm.
    entries_mm: BTreeMap<char, f64>,
    /// The work offset is a row of a preset table, and its entries are not machine coordinates.
    offset_rows: bool,
    part_origin: [f64; 3],
    part_rotation: [f64; 3],
    seconds: f64,
    operations: Vec<ViewOperation>,
    axes: Vec<AxisExtremes>,
}

/// Lowest and highest position of an axis.
#[derive(Debug, Serialize)]
struct AxisExtremes {
    letter: char,
    unit: &'static str,
    /// Of the machine; otherwise from the zero position, in which the tip is on the part zero.
    machine_coordinates: bool,
    lowest: f64,
    highest: f64,
    /// Of the coordinates.
    limits: Option<[f64; 2]>,
    /// The axis has limits, perhaps of coordinates that are unknown.
    has_limits: bool,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    outside_limits: bool,
}

/// A tool with its operations.
#[derive(Debug, Serialize)]
struct UsedTool {
    #[serde(flatten)]
    tool: Tool,
    operations: Vec<u64>,
}

/// Result of the check.
#[derive(Debug, Serialize)]
struct Check<'a> {
    passed: bool,
    figures: String,
    findings: Vec<Found<'a>>,
}

/// A part of a document.
pub(crate) struct DocumentSection {
    pub(crate) title: String,
    /// It begins a page when printed.
    pub(crate) page: bool,
    pub(crate) body: Vec<SectionBody>,
}

/// What a section holds.
pub(crate) enum SectionBody {
    /// A list.
    Lines(Vec<String>),
    /// A table: titles of the columns, and rows.
    Table(Vec<&'static str>, Vec<Vec<String>>),
    /// A picture: its SVG, and what it shows.
    Picture(String, String),
    /// Text whose columns are aligned.
    Aligned(Vec<String>),
}

/// A number with at most three decimals.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn or_unknown(value: Option<f64>) -> String {
    value.map_or_else(|| "unknown".to_owned(), short)
}

fn time(seconds: f64) -> String {
    duration(seconds / 60.0)
}

impl<'a> JobSheet<'a> {
    pub(crate) fn of(program: &'a ViewedProgram<'a>, jog_sheet: bool) -> Self {
        let operations = operations(program);
        let used = |tool: Tool| {
            let of_tool = operations.iter().filter(|operation| operation.tool == tool.number);
            UsedTool { operations: of_tool.map(|operation| operation.number).collect(), tool }
        };
        let outcome = &program.checked.outcome;
        let set_ups: Vec<SheetSetUp> = program
            .policy
            .set_up
            .clampings()
            .map(|(number, clamping)| set_up(program, number, &clamping, &operations))
            .collect();
        Self {
            program: &program.titles.program,
            cl: &program.titles.cl,
            machine: program.machine.name(),
            control: program.titles.control,
            seconds: set_ups.iter().map(|set_up| set_up.seconds).sum(),
            unknown_speeds: program.executed.points.iter().any(|point| point.seconds.is_none()),
            tools: tools(program).into_iter().filter(|tool| tool.number > 0).map(used).collect(),
            set_ups,
            check: Check {
                passed: program.passed(),
                figures: outcome.summary(),
                findings: outcome.findings.iter().map(Found::of).collect(),
            },
            warnings: &program.titles.warnings,
            summary: program.titles.summary.clone(),
            jog_sheet: jog_sheet.then(|| program.machine.explanation().jog_sheet.text),
        }
    }

    /// The title of a document about the program.
    pub(crate) fn title(&self) -> String {
        format!("{} on {}", self.program, self.machine)
    }

    /// The whole program: times, operations, tools, extremes, check.
    pub(crate) fn overview(&self, program: &ViewedProgram<'_>) -> io::Result<Vec<DocumentSection>> {
        let mut sections = vec![self.heading()];
        for set_up in &self.set_ups {
            let mut body = vec![SectionBody::Lines(vec![set_up.placed()]), set_up.operations(), self.tools_of(set_up)];
            body.push(set_up.extremes());
            sections.push(DocumentSection { title: set_up.title(), page: false, body });
        }
        sections.extend(self.results());
        let paths = program.moving_set_ups().map(|number| {
            Ok(SectionBody::Picture(picture::path(program, number)?, path_caption(&program.executed, number)))
        });
        let mut pictures = paths.collect::<io::Result<Vec<_>>>()?;
        pictures.push(SectionBody::Picture(picture::axes(program)?, "the axes over time, limits red".to_owned()));
        sections.push(DocumentSection { title: "Pictures".to_owned(), page: false, body: pictures });
        Ok(sections)
    }

    /// The set-up sheet: one page for each set-up, then the results.
    pub(crate) fn set_up_sheet(&self, program: &ViewedProgram<'_>, pictures: bool) -> io::Result<Vec<DocumentSection>> {
        let mut sections = vec![self.heading()];
        for (index, set_up) in self.set_ups.iter().enumerate() {
            let mut body = vec![SectionBody::Lines(vec![set_up.placed()])];
            if pictures {
                let text = "part on the table: zero red, cuts blue, centre lines of the rotary axes green".to_owned();
                body.push(SectionBody::Picture(picture::part_on_table(program, set_up.number)?, text));
            }
            body.extend([self.tools_of(set_up), set_up.operations(), set_up.extremes()]);
            sections.push(DocumentSection { title: set_up.title(), page: index > 0, body });
        }
        sections.extend(self.results());
        sections.extend(self.jog_sheet.map(|lines| DocumentSection {
            title: "Jog sheet".to_owned(),
            page: true,
            body: vec![SectionBody::Aligned(lines.iter().map(|line| (*line).to_owned()).collect())],
        }));
        Ok(sections)
    }

    fn heading(&self) -> DocumentSection {
        let without = "; rapids of axes without a speed in `speeds` are not counted";
        let lines = vec![
            format!("machine {}, control {}", self.machine, self.control),
            format!("CL data {}", self.cl),
            format!("machining time {}{}", time(self.seconds), if self.unknown_speeds { without } else { "" }),
            self.check.figures.clone(),
        ];
        DocumentSection { title: self.title(), page: false, body: vec![SectionBody::Lines(lines)] }
    }

    fn tools_of(&self, set_up: &SheetSetUp) -> SectionBody {
        let columns = vec!["tool", "name", "kind", "diameter mm", "corner mm", "gauge length mm", "operations", "time"];
        let of = |number: u32| set_up.operations.iter().filter(move |operation| operation.tool == number);
        let row = |used: &UsedTool| {
            let tool = &used.tool;
            let mut operations = of(tool.number).map(|operation| operation.number.to_string()).peekable();
            operations.peek()?;
            Some(vec![
                format!("T{}", tool.number),
                tool.name.clone(),
                tool.kind.to_owned(),
                or_unknown(tool.diameter),
                or_unknown(tool.corner_radius),
                or_unknown(tool.gauge_length),
                operations.collect::<Vec<_>>().join(", "),
                time(of(tool.number).map(|operation| operation.seconds).sum()),
            ])
        };
        SectionBody::Table(columns, self.tools.iter().filter_map(row).collect())
    }

    fn results(&self) -> Vec<DocumentSection> {
        let found = |found: &Found<'_>| {
            let help = found.help.map_or_else(String::new, |help| format!("; {help}"));
            format!("line {} (CL line {}): {}{help}", found.line, found.cl_line, found.text)
        };
        let findings = match self.check.findings.is_empty() {
            true => vec![self.check.figures.clone()],
            false => self.check.findings.iter().map(found).collect(),
        };
        let section = |title: &str, lines: Vec<String>| DocumentSection {
            title: title.to_owned(),
            page: false,
            body: vec![SectionBody::Lines(lines)],
        };
        let mut sections = vec![section("Check", findings)];
        if !self.warnings.is_empty() {
            sections.push(section("Warnings", self.warnings.to_vec()));
        }
        if !self.summary.is_empty() {
            sections.push(section("Summary", self.summary.clone()));
        }
        sections
    }
}

impl SheetSetUp {
    fn title(&self) -> String {
        format!("Set-up {}", self.number)
    }

    fn placed(&self) -> String {
        let [x, y, z] = self.part_origin.map(short);
        let origin = format!("part zero at X{x} Y{y} Z{z} mm from the reference point of the table");
        let rotated = self.part_rotation.iter().any(|angle| angle.abs() > 0.0);
        let [a, b, c] = self.part_rotation.map(short);
        let rotation = if rotated { format!(", rotated by {a}°, {b}°, {c}° about X, Y, Z") } else { String::new() };
        let entries: String = self.entries_mm.iter().map(|(letter, mm)| format!(" {letter}{}", short(*mm))).collect();
        let entries = match self.offset_rows {
            _ if entries.is_empty() => entries,
            false => format!(" must hold{entries} mm"),
            true => format!(" must have its zero at{entries} mm in the display REF, gauge line, rotary axes at zero"),
        };
        format!("work offset {}{entries}; {origin}{rotation}", self.work_offset)
    }

    fn operations(&self) -> SectionBody {
        let row = |operation: &ViewOperation| {
            vec![
                operation.number.to_string(),
                operation.name.clone(),
                format!("T{}", operation.tool),
                operation.mode.to_owned(),
                time(operation.seconds),
            ]
        };
        SectionBody::Table(vec!["operation", "name", "tool", "mode", "time"], self.operations.iter().map(row).collect())
    }

    fn extremes(&self) -> SectionBody {
        let row = |axis: &AxisExtremes| {
            let limits = match axis.limits {
                Some([lower, upper]) => {
                    let mark = if axis.outside_limits { ": OUTSIDE" } else { "" };
                    format!("{} to {}{mark}", short(lower), short(upper))
                }
                None if axis.has_limits => "machine coordinates, not comparable without `machine_zero`".to_owned(),
                None => "none".to_owned(),
            };
            let counted = if axis.machine_coordinates { "machine" } else { "from the zero position" };
            vec![
                format!("{} {}", axis.letter, axis.unit),
                short(axis.lowest),
                short(axis.highest),
                limits,
                counted.to_owned(),
            ]
        };
        SectionBody::Table(
            vec!["axis", "lowest", "highest", "limits", "coordinates"],
            self.axes.iter().map(row).collect(),
        )
    }
}

/// What the picture of the path in a set-up shows.
fn path_caption(executed: &Executed, set_up: u32) -> String {
    let text = format!("the path in set-up {set_up} in three views: feed blue, rapid orange");
    match executed.rapids_apart {
        true => format!("{text}; in rapids each axis moves on its own: their path is not the line drawn"),
        false => text,
    }
}

fn set_up(
    program: &ViewedProgram<'_>,
    number: u32,
    clamping: &Clamping<'_>,
    operations: &[ViewOperation],
) -> SheetSetUp {
    let (executed, axes) = (&program.executed, program.machine.axes());
    let index = program.set_up_index(number);
    let operations: Vec<ViewOperation> =
        operations.iter().filter(|operation| operation.set_up == index).cloned().collect();
    let limits = program.policy.set_up.travel(axes).limits;
    let extremes = |index: usize| {
        let axis = &axes[index];
        let rotary = axis.kind == AxisKind::Rotary;
        let shown = |value: f64| if rotary { value.to_degrees() } else { value };
        let coordinates = program.coordinates(index);
        let here = executed.points.iter().zip(coordinates);
        let here = here.filter(|(point, _)| executed.placements[point.placement].set_up == number);
        let (lowest, highest) =
            here.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, value)| (low.min(value), high.max(value)));
        let limits_here = limits[index]
            .filter(|_| program.has_coordinates(index))
            .map(|limits| [limits.lower, limits.upper].map(shown));
        let outside = |[lower, upper]: [f64; 2]| {
            shown(lowest) < lower - SAME_COORDINATE || shown(highest) > upper + SAME_COORDINATE
        };
        (lowest <= highest).then(|| AxisExtremes {
            letter: axis.letter,
            unit: if rotary { "°" } else { "mm" },
            machine_coordinates: program.has_coordinates(index),
            has_limits: limits[index].is_some(),
            lowest: shown(lowest),
            highest: shown(highest),
            limits: limits_here,
            outside_limits: limits_here.is_some_and(outside),
        })
    };
    let set_up = &program.policy.set_up;
    SheetSetUp {
        number,
        work_offset: clamping.work_offset.to_owned(),
        entries_mm: set_up.work_offset_mm(&*program.machine, number),
        offset_rows: program.policy.family.facts().offset_rows,
        part_origin: clamping.part_origin,
        part_rotation: part_angles(&clamping.part_rotation),
        seconds: operations.iter().map(|operation| operation.seconds).sum(),
        operations,
        axes: (0..axes.len()).filter(|index| !axes[*index].held).filter_map(extremes).collect(),
    }
}
