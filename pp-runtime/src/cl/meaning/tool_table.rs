//! All that CL data and configuration state about each tool, brought together.
//!
//! A row is a tool number with a length offset register: a tool with two registers, such as a T-slot cutter that is
//! measured at both edges, has two. What is stated twice must agree: one number for two tools would cut the second path
//! with the first tool.

use std::collections::BTreeMap;

use crate::cl::record::{CutterKind, CutterRecord};
use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::program::{Location, ToolCall, Units};

/// Largest difference of two statements of one length or diameter: two measurements of a tool agree no better.
const SAME_SIZE_MM: f64 = 0.01;

/// What the configuration states about a tool, `[tools.N]`, lengths in mm.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StatedTool {
    /// Cutting diameter.
    pub diameter_mm: Option<f64>,
    /// Corner radius.
    pub corner_radius_mm: Option<f64>,
    /// Gauge length.
    pub length_mm: Option<f64>,
    /// Length offset register.
    pub offset: Option<u32>,
    /// Diameter for which paths were made on purpose; it does not describe the tool.
    pub path_diameter_mm: Option<f64>,
    /// All that the CL data states about this number is one tool, which is described here.
    pub is_one: bool,
}

/// Place of a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum StatedAt {
    Line(u64),
    Configuration,
}

impl StatedAt {
    fn text(self, number: u32) -> String {
        match self {
            Self::Line(line) => format!("line {line}"),
            Self::Configuration => format!("`[tools.{number}]`"),
        }
    }
}

/// A value and where it was stated first.
type Stated<T> = Option<(T, StatedAt)>;

#[derive(Debug, Clone, Copy, Default)]
struct ToolRow {
    diameter_mm: Stated<f64>,
    corner_radius_mm: Stated<f64>,
    length_mm: Stated<f64>,
    kind: Stated<CutterKind>,
}

/// A cutter and the line that states it, mm.
pub(crate) type CutterAt = (CutterRecord, Location);

/// The tools of a job.
#[derive(Debug, Default)]
pub(crate) struct ToolTable {
    /// By tool number, none for what cuts without a call, and by register.
    rows: BTreeMap<(Option<u32>, u32), ToolRow>,
    /// Names by tool number, with the line of the first and whether another one has been remarked on.
    names: BTreeMap<u32, (String, u64, bool)>,
    /// Register of the last call of each tool that had one.
    registers: BTreeMap<u32, u32>,
    /// Unit of the file, for messages.
    pub(crate) units: Units,
}

/// Two statements that contradict each other, with the place of the later one.
pub(crate) type Contradiction = (Location, ClFault);

impl ToolTable {
    /// Takes a call with all that the CL data states about its tool, and completes it with what was stated before.
    pub(crate) fn take_call(
        &mut self,
        call: &mut ToolCall,
        cutter: Option<CutterAt>,
        here: Location,
        given: Option<&StatedTool>,
    ) -> Result<(), Contradiction> {
        let (number, units) = (call.number, self.units);
        let place = StatedAt::Line(here.line);
        if let Some((offset, register)) = given.and_then(|given| given.offset).zip(call.length_offset)
            && offset != register
        {
            let help = format!("delete one of the two: `offset` in `[tools.{number}]`, or the register in the CL data");
            let text = format!("tool {number} has length offset register {register} in line {}", here.line);
            return Err((here, fault(format!("{text} and {offset} in `[tools.{number}]`"), help)));
        }
        if let Some(register) = call.length_offset {
            self.registers.insert(number, register);
        }
        call.length_offset = self.registers.get(&number).copied();
        let register = call.length_offset.or(given.and_then(|given| given.offset)).unwrap_or(number);
        let row = self.row(Some(number), register, given);
        if let Some(length_mm) = call.length_mm {
            state(&mut row.length_mm, length_mm, place, given).map_err(|other| {
                let what = format!("length of {}", shown(length_mm, units));
                (here, contradiction(Some(number), &what, place, &shown(other.0, units), other.1))
            })?;
        }
        if let Some((cutter, at)) = cutter {
            take_cutter(row, &cutter, at, ShownTool { number: Some(number), units }, given)?;
        }
        call.length_mm = row.length_mm.filter(of_cl_data).map(|(length_mm, _)| length_mm);
        (call.diameter_mm, call.corner_radius_mm) = size(row);
        Ok(())
    }

    /// Takes a cutter of a tool that has been called, or that cuts without a call; completes the call.
    pub(crate) fn take_cutter(
        &mut self,
        call: Option<&mut ToolCall>,
        (cutter, at): CutterAt,
        given: Option<&StatedTool>,
    ) -> Result<(), Contradiction> {
        let (number, units) = (call.as_ref().map(|call| call.number), self.units);
        let register = call.as_ref().and_then(|call| call.length_offset).or(given.and_then(|given| given.offset));
        let row = self.row(number, register.or(number).unwrap_or(0), given);
        take_cutter(row, &cutter, at, ShownTool { number, units }, given)?;
        if let Some(call) = call {
            (call.diameter_mm, call.corner_radius_mm) = size(row);
        }
        Ok(())
    }

    /// Takes the name of a tool; a remark if it has another one.
    pub(crate) fn take_name(&mut self, number: u32, name: String, here: Location) -> Option<Contradiction> {
        let (known, line, remarked) = self.names.entry(number).or_insert((name.clone(), here.line, false));
        if *known == name || std::mem::replace(remarked, true) {
            return None;
        }
        let text = format!("tool {number} is called {name} in line {} and {known} in line {line}", here.line);
        let help = "correct if it is one tool; two tools need two numbers";
        Some((here, cl::TOOL.cl_fault("names of a tool", Span::WHOLE, text, help).warning()))
    }

    /// Corner radius of what cuts without a call, mm.
    pub(crate) fn corner_radius_without_call(&self) -> Option<f64> {
        let mut without_call = self.rows.range(..(Some(0), 0)).map(|(_, row)| row);
        without_call.find_map(|row| size(row).1)
    }

    fn row(&mut self, number: Option<u32>, register: u32, given: Option<&StatedTool>) -> &mut ToolRow {
        self.rows.entry((number, register)).or_insert_with(|| {
            let stated = |value: Option<f64>| value.map(|value| (value, StatedAt::Configuration));
            given.map_or_else(ToolRow::default, |given| ToolRow {
                diameter_mm: stated(given.diameter_mm),
                corner_radius_mm: stated(given.corner_radius_mm),
                // The length is that of its own register.
                length_mm: stated(given.length_mm.filter(|_| given.offset.or(number) == Some(register))),
                kind: None,
            })
        })
    }
}

/// Diameter and corner radius that the CL data states.
fn size(row: &ToolRow) -> (Option<f64>, Option<f64>) {
    let of = |stated: Stated<f64>| stated.map(|(value, _)| value);
    (of(row.diameter_mm.filter(of_cl_data)), of(row.corner_radius_mm.filter(of_cl_data)))
}

fn of_cl_data(stated: &(f64, StatedAt)) -> bool {
    stated.1 != StatedAt::Configuration
}

/// Takes a value, or returns the statement that it contradicts. What is one tool by the configuration has the sizes
/// given there.
fn state(
    into: &mut Stated<f64>,
    value: f64,
    place: StatedAt,
    given: Option<&StatedTool>,
) -> Result<(), (f64, StatedAt)> {
    match *into {
        None => *into = Some((value, place)),
        Some((_, StatedAt::Configuration)) if given.is_some_and(|given| given.is_one) => {}
        Some((known, its_place)) if (known - value).abs() <= SAME_SIZE_MM => {
            if its_place == StatedAt::Configuration {
                *into = Some((value, place));
            }
        }
        Some(other) => return Err(other),
    }
    Ok(())
}

/// The tool of a message.
#[derive(Debug, Clone, Copy)]
struct ShownTool {
    /// Its number; `None`: the tool in the spindle, without a call.
    number: Option<u32>,
    /// Units of its sizes in the message.
    units: Units,
}

fn take_cutter(
    row: &mut ToolRow,
    cutter: &CutterRecord,
    at: Location,
    ShownTool { number, units }: ShownTool,
    given: Option<&StatedTool>,
) -> Result<(), Contradiction> {
    let place = StatedAt::Line(at.line);
    let path = given.and_then(|given| given.path_diameter_mm);
    if path.is_some_and(|path| (path - cutter.diameter).abs() <= SAME_SIZE_MM) {
        return Ok(());
    }
    let against = |what: String, (other, its_place): (String, StatedAt)| {
        (at, contradiction(number, &what, place, &other, its_place))
    };
    state(&mut row.diameter_mm, cutter.diameter, place, given).map_err(|(other, its_place)| {
        against(format!("diameter of {}", shown(cutter.diameter, units)), (shown(other, units), its_place))
    })?;
    if let Some(radius) = cutter.corner_radius {
        state(&mut row.corner_radius_mm, radius, place, given).map_err(|(other, its_place)| {
            against(format!("corner radius of {}", shown(radius, units)), (shown(other, units), its_place))
        })?;
    }
    if let Some(kind) = cutter.kind {
        match *row.kind.get_or_insert((kind, place)) {
            (known, _) if known == kind || given.is_some_and(|given| given.is_one) => {}
            (known, its_place) => {
                return Err(against(format!("kind, {}", kind.word()), (known.word().to_owned(), its_place)));
            }
        }
    }
    Ok(())
}

fn contradiction(number: Option<u32>, what: &str, place: StatedAt, other: &str, its_place: StatedAt) -> ClFault {
    let Some(number) = number else {
        let text =
            format!("the tool in the spindle has a {what} in {} and {other} in {}", place.text(0), its_place.text(0));
        return fault(
            text,
            "program LOADTL or LOAD/TOOL for each tool: without a call the tool in the spindle stays in use".to_owned(),
        );
    };
    let text =
        format!("tool {number} has a {what} in {} and {other} in {}", place.text(number), its_place.text(number));
    let help = format!(
        "two tools: give each a number of its own in the CAM system, and a tool call before it cuts; a CUTTER of another diameter on \
         purpose: `[tools.{number}] path_diameter`; one tool all the same: `[tools.{number}] one_tool = true` with its sizes"
    );
    fault(text, help)
}

fn fault(text: String, help: String) -> ClFault {
    cl::TOOL_NUMBER.cl_fault("one number for two tools", Span::WHOLE, text, help)
}

/// A length for messages.
fn shown(mm: f64, units: Units) -> String {
    units.length(mm).to_string()
}
