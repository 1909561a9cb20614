//! The head of the page's data: machine, tools, operations, set-ups, findings. Lengths in mm, angles in degrees, times
//! in seconds, feeds and speeds per minute.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

use serde::Serialize;

use crate::check::Finding;
use crate::kinematics::{AxisKind, Side};
use crate::set_up::GivenTool;

use super::ViewedProgram;
use super::cl_facts::ClTool;
use super::columns::Column;
use super::executed::{ExecutedOperation, ExecutedPlacement, PointKind};

/// Version of the data.
const FORMAT: u32 = 1;

/// Chords of the corner radius in the profile of a tool.
const CORNER_CHORDS: u32 = 12;

/// Steps of a number in the head: twelve significant figures suffice for 1 km in nm.
const STEPS: f64 = 1e9;

/// The head of the data.
#[derive(Debug, Serialize)]
pub(crate) struct ViewHead<'a> {
    format: u32,
    compressed: bool,
    program: &'a str,
    cl: &'a str,
    control: &'a str,
    machine: ViewMachine,
    tools: Vec<Tool>,
    operations: Vec<ViewOperation>,
    set_ups: Vec<ViewSetUp>,
    placements: Vec<ViewPlacement>,
    findings: Vec<PageFinding<'a>>,
    warnings: &'a [String],
    summary: Vec<String>,
    tolerance_mm: f64,
    path: ViewPath<'a>,
    points: usize,
    columns: Vec<Column>,
    reasons: &'a [&'static str],
    reason_texts: &'a [&'static str],
    kinds: &'a [&'static str],
    seconds: f64,
}

/// Motions that are not as they are drawn.
#[derive(Debug, Serialize)]
struct ViewPath<'a> {
    rapids_apart: bool,
    /// Lines with a motion to a machine position that is not drawn, because the machine zero is unknown.
    undrawn: &'a [u64],
}

/// The machine as a chain of joints, from the workpiece to the tool.
#[derive(Debug, Serialize)]
struct ViewMachine {
    name: &'static str,
    joints: Vec<ViewJoint>,
    tool_axis: [f64; 3],
    /// Number of joints on the side of the workpiece.
    frame_after: usize,
}

/// One joint; its point is that of the first placement.
#[derive(Debug, Serialize)]
struct ViewJoint {
    letter: char,
    rotary: bool,
    held: bool,
    direction: [f64; 3],
    point: [f64; 3],
    sign: f64,
    /// Of a linear axis in machine coordinates.
    min: Option<f64>,
    max: Option<f64>,
    speed: Option<f64>,
}

/// Points of the joints for a tool and a set-up.
#[derive(Debug, Serialize)]
struct ViewPlacement {
    set_up: usize,
    tool: u32,
    points: Vec<[f64; 3]>,
    /// Machine coordinate of each axis less its value; null where the machine zero is unknown.
    zero: Vec<Option<f64>>,
}

/// A tool that moves.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct Tool {
    pub(crate) number: u32,
    pub(crate) name: String,
    pub(crate) kind: &'static str,
    pub(crate) diameter: Option<f64>,
    pub(crate) corner_radius: Option<f64>,
    length: Option<f64>,
    flute_length: Option<f64>,
    pub(crate) gauge_length: Option<f64>,
    /// Heights above the tip and radii.
    profile: Option<Vec<[f64; 2]>>,
    first_point: usize,
    points: usize,
    pub(crate) seconds: f64,
}

/// An operation.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct ViewOperation {
    pub(crate) name: String,
    pub(crate) number: u64,
    pub(crate) tool: u32,
    /// Index in the set-ups.
    pub(crate) set_up: usize,
    pub(crate) mode: &'static str,
    first_point: usize,
    points: usize,
    pub(crate) seconds: f64,
}

/// A clamping of the part.
#[derive(Debug, Serialize)]
struct ViewSetUp {
    name: String,
    work_offset: String,
    part_origin: [f64; 3],
    first_point: usize,
}

/// A finding of the check, and where it is on the page.
#[derive(Debug, Serialize)]
struct PageFinding<'a> {
    #[serde(flatten)]
    found: Found<'a>,
    last_line: u64,
    /// Last point of its first line, or the next one.
    point: Option<usize>,
}

/// A number without the noise of sums.
fn tidy(value: f64) -> f64 {
    (value * STEPS).round() / STEPS + 0.0
}

fn vector(vector: impl Into<[f64; 3]>) -> [f64; 3] {
    vector.into().map(tidy)
}

impl<'a> ViewHead<'a> {
    pub(crate) fn of(program: &'a ViewedProgram<'a>, columns: Vec<Column>) -> Self {
        let executed = &program.executed;
        let seconds: f64 = executed.points.iter().filter_map(|point| point.seconds).sum();
        let placements: Vec<ViewPlacement> =
            executed.placements.iter().map(|placement| placement_of(program, placement)).collect();
        let unknown_zero = placements.iter().any(|placement| placement.zero.contains(&None));
        let undrawn = if unknown_zero { &executed.undrawn[..] } else { &[] };
        Self {
            format: FORMAT,
            compressed: true,
            program: &program.titles.program,
            cl: &program.titles.cl,
            control: program.titles.control,
            machine: machine(program),
            tools: tools(program),
            operations: operations(program),
            set_ups: set_ups(program),
            placements,
            findings: program.checked.outcome.findings.iter().map(|found| finding(program, found)).collect(),
            warnings: &program.titles.warnings,
            summary: program.summary(),
            tolerance_mm: program.policy.tolerances.path_mm,
            path: ViewPath { rapids_apart: executed.rapids_apart, undrawn },
            points: executed.points.len(),
            columns,
            reasons: &program.reasons.names,
            reason_texts: &program.reasons.texts,
            kinds: &PointKind::NAMES,
            seconds: tidy(seconds),
        }
    }
}

/// Operations in the order in which they are executed.
pub(crate) fn operations(program: &ViewedProgram<'_>) -> Vec<ViewOperation> {
    let executed = &program.executed;
    let names = program.facts.names(executed.operations.iter().map(|operation| operation.cl_line));
    let ends = executed.operations.iter().skip(1).map(|next| next.first_point).chain([executed.points.len()]);
    let operation = |((operation, name), end): ((&ExecutedOperation, String), usize)| {
        let points = &executed.points[operation.first_point..end];
        ViewOperation {
            name: if name.is_empty() { format!("operation {}", operation.number) } else { name },
            number: operation.number,
            tool: operation.tool,
            set_up: program.set_up_index(operation.set_up),
            mode: operation.mode,
            first_point: operation.first_point,
            points: points.len(),
            seconds: tidy(points.iter().filter_map(|point| point.seconds).sum()),
        }
    };
    executed.operations.iter().zip(names).zip(ends).map(operation).collect()
}

fn machine(program: &ViewedProgram<'_>) -> ViewMachine {
    let first = program.first_machine();
    let travel = program.policy.set_up.travel(first.axes());
    let joint = |index: usize| {
        let (axis, joint) = (&first.axes()[index], first.joint(index));
        let shown = |value: f64| tidy(if axis.kind == AxisKind::Rotary { value.to_degrees() } else { value });
        ViewJoint {
            letter: axis.letter,
            rotary: axis.kind == AxisKind::Rotary,
            held: axis.held,
            direction: joint.direction.into_inner().into(),
            point: vector(joint.point),
            sign: joint.sign,
            min: travel.limits[index].map(|limits| shown(limits.lower)),
            max: travel.limits[index].map(|limits| shown(limits.upper)),
            speed: travel.speeds[index].map(shown),
        }
    };
    ViewMachine {
        name: first.name(),
        joints: (0..first.axes().len()).map(joint).collect(),
        tool_axis: first.tool_axis().into_inner().into(),
        frame_after: first.axes().iter().filter(|axis| axis.side == Side::Workpiece).count(),
    }
}

fn placement_of(program: &ViewedProgram<'_>, placement: &ExecutedPlacement) -> ViewPlacement {
    let machine = &placement.machine;
    let zero = machine.axes().iter().enumerate().map(|(index, axis)| match axis.kind {
        AxisKind::Rotary => Some(0.0),
        AxisKind::Linear => {
            let zero_mm = program.policy.set_up.machine_zero.get(&axis.letter)?;
            Some(tidy(zero_mm + placement.offsets_mm[index]))
        }
    });
    ViewPlacement {
        set_up: program.set_up_index(placement.set_up),
        tool: placement.tool,
        points: (0..machine.axes().len()).map(|index| vector(machine.joint(index).point)).collect(),
        zero: zero.collect(),
    }
}

/// Tools in the order of their numbers.
pub(crate) fn tools(program: &ViewedProgram<'_>) -> Vec<Tool> {
    let executed = &program.executed;
    // First point, number of points, seconds.
    let mut used: BTreeMap<u32, (usize, usize, f64)> = BTreeMap::new();
    for (index, point) in executed.points.iter().enumerate() {
        let tool = executed.placements[point.placement].tool;
        let (_, points, seconds) = used.entry(tool).or_insert((index, 0, 0.0));
        *points += 1;
        *seconds += point.seconds.unwrap_or(0.0);
    }
    let tool = |(number, (first_point, points, seconds)): (u32, (usize, usize, f64))| {
        let given = program.policy.set_up.tools.get(&number);
        let cl = program.facts.tools.get(&number).copied().unwrap_or_default();
        let [diameter, corner_radius] = GivenTool::size_mm(given, &cl.call);
        let gauge_length = given.and_then(|given| given.length_mm).or(cl.call.length_mm);
        Tool {
            number,
            name: given.and_then(|given| given.name.clone()).unwrap_or_default(),
            kind: kind(&cl, diameter, corner_radius),
            diameter,
            corner_radius,
            length: gauge_length,
            flute_length: None,
            gauge_length,
            profile: diameter.map(|diameter| profile(diameter / 2.0, corner_radius.unwrap_or(0.0), gauge_length)),
            first_point,
            points,
            seconds: tidy(seconds),
        }
    };
    used.into_iter().map(tool).collect()
}

/// Kind of a tool, from its use and its shape.
fn kind(tool: &ClTool, diameter: Option<f64>, corner: Option<f64>) -> &'static str {
    let radius = diameter.map(|diameter| diameter / 2.0);
    match (corner, radius) {
        _ if tool.taps && !tool.mills => "tap",
        _ if tool.drills && !tool.mills => "drill",
        (Some(corner), Some(radius)) if corner >= radius && radius > 0.0 => "ball",
        (Some(corner), Some(_)) if corner > 0.0 => "bull nose",
        (Some(_), Some(_)) => "flat",
        _ => "unknown",
    }
}

/// Profile of a tool from its tip up, mm: the corner in chords, then the shank up to the gauge line, or four diameters.
fn profile(radius: f64, corner_radius: f64, gauge_length: Option<f64>) -> Vec<[f64; 2]> {
    let corner = corner_radius.min(radius);
    let flat = radius - corner;
    let mut points = vec![[0.0, 0.0]];
    if corner <= 0.0 {
        points.push([0.0, radius]);
    } else {
        points.extend((0..=CORNER_CHORDS).map(|chord| {
            let (sine, cosine) = (FRAC_PI_2 * f64::from(chord) / f64::from(CORNER_CHORDS)).sin_cos();
            [tidy(corner * (1.0 - cosine)), tidy(flat + corner * sine)]
        }));
    }
    let top = gauge_length.unwrap_or(8.0 * radius).max(corner);
    points.push([top, radius]);
    points
}

fn set_ups(program: &ViewedProgram<'_>) -> Vec<ViewSetUp> {
    let executed = &program.executed;
    let first_point = |number: u32| {
        let is_in = |placement: usize| executed.placements[placement].set_up == number;
        executed.points.iter().position(|point| is_in(point.placement)).unwrap_or(executed.points.len())
    };
    let set_up = |(number, clamping): (u32, crate::set_up::Clamping<'_>)| ViewSetUp {
        name: format!("set-up {number}"),
        work_offset: clamping.work_offset.to_owned(),
        part_origin: vector(clamping.part_origin),
        first_point: first_point(number),
    };
    program.policy.set_up.clampings().map(set_up).collect()
}

fn finding<'a>(program: &ViewedProgram<'_>, found: &'a Finding) -> PageFinding<'a> {
    let points = &program.executed.points;
    let next = points.partition_point(|point| point.line <= found.line);
    let of_line = next.checked_sub(1).filter(|last| points[*last].line == found.line);
    PageFinding {
        found: Found::of(found),
        last_line: found.last_line,
        point: of_line.or((next < points.len()).then_some(next)),
    }
}

/// A finding of the check.
#[derive(Debug, Serialize)]
pub(crate) struct Found<'a> {
    pub(crate) line: u64,
    pub(crate) cl_line: u64,
    pub(crate) text: &'a str,
    pub(crate) help: Option<&'a str>,
}

impl<'a> Found<'a> {
    pub(crate) fn of(finding: &'a Finding) -> Self {
        Self { line: finding.line, cl_line: finding.location.line, text: &finding.text, help: finding.help.as_deref() }
    }
}
