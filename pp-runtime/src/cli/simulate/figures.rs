//! A simulation as JSON.

use serde::Serialize;

use crate::diag::code::simulate;
use crate::simulate::{EPS_MM, SimulationOutcome, Size, What};

use super::against_design::{AgainstDesign, DesignFigures};

/// The figures.
#[derive(Serialize)]
pub(super) struct Figures<'a> {
    passed: bool,
    motions: u64,
    collisions: u64,
    removed_mm3: f64,
    pitch_mm: [f64; 3],
    stock_mm: [[f64; 3]; 2],
    tolerance_mm: f64,
    taking_part: &'a [String],
    assumed: &'a [String],
    not_checked: Vec<String>,
    /// Tools whose length or diameter in the tool table differs from the posted one.
    tool_table: &'a [String],
    operations: Vec<RemovalFigures>,
    tools: Vec<RemovalOfTool>,
    engagement: OverTime<'a>,
    findings: Vec<FindingFigures<'a>>,
    /// Smallest distances of bodies of the machine, fixtures, tools and stock.
    clearances: Vec<ClearanceFigures<'a>>,
    /// The comparison with the design; null: no design given.
    design: Option<DesignFigures>,
}

/// Removal of an operation with a tool; the largest rate is over about a second.
#[derive(Serialize)]
struct RemovalFigures {
    operation: u64,
    tool: u32,
    removed_mm3: f64,
    cutting_min: f64,
    largest_mm3_per_min: Option<f64>,
    largest_line: Option<u64>,
}

#[derive(Serialize)]
struct RemovalOfTool {
    tool: u32,
    removed_mm3: f64,
    cutting_min: f64,
}

/// Material removed in steps of the time of all feed motions.
#[derive(Serialize)]
struct OverTime<'a> {
    step_min: f64,
    removed_mm3: &'a [f64],
}

/// A finding. Volume and length are those of stock, the distance that of two bodies: null where they collide.
#[derive(Serialize)]
struct FindingFigures<'a> {
    code: &'static str,
    kind: &'static str,
    text: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    bodies: Option<&'a [String; 2]>,
    line: u64,
    last_line: u64,
    cl_line: u64,
    operation: u64,
    tool: u32,
    #[serde(skip_serializing_if = "Option::is_none")]
    volume_mm3: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    longest_mm: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    distance_mm: Option<Option<f64>>,
    place_mm: [f64; 3],
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    axes: &'a [(char, f64)],
}

#[derive(Serialize)]
struct ClearanceFigures<'a> {
    bodies: &'a [String; 2],
    distance_mm: f64,
    line: u64,
    cl_line: u64,
    tool: u32,
    place_mm: [f64; 3],
    axes: &'a [(char, f64)],
}

impl<'a> Figures<'a> {
    /// `sizes`: pitch, and corners of the stock.
    pub(super) fn of(
        outcome: &'a SimulationOutcome,
        against: Option<&AgainstDesign>,
        passed: bool,
        (pitch_mm, stock_mm): ([f64; 3], [[f64; 3]; 2]),
    ) -> Self {
        let engagement = &outcome.engagement;
        let operations = engagement.operations.iter().map(|((operation, tool), removal)| RemovalFigures {
            operation: *operation,
            tool: *tool,
            removed_mm3: removal.volume_mm3,
            cutting_min: removal.minutes,
            largest_mm3_per_min: removal.largest.map(|(rate, _)| rate),
            largest_line: removal.largest.map(|(_, line)| line),
        });
        let tools = engagement.of_tools().into_iter().map(|(tool, (removed_mm3, cutting_min))| RemovalOfTool {
            tool,
            removed_mm3,
            cutting_min,
        });
        let findings = outcome.found.iter().map(|found| {
            let (volume_mm3, longest_mm, distance_mm) = match found.size {
                Size::Cut { volume_mm3, longest_mm } => (Some(volume_mm3), Some(longest_mm), None),
                Size::Apart(least_mm) => (None, None, Some(least_mm)),
            };
            FindingFigures {
                code: simulate::CONTACT.name(),
                kind: found.what.name(),
                text: found.text(),
                bodies: match &found.what {
                    What::Bodies(bodies) => Some(bodies),
                    What::Stock(_) => None,
                },
                line: found.lines[0],
                last_line: found.lines[1],
                cl_line: found.cl_line,
                operation: found.operation,
                tool: found.tool,
                volume_mm3,
                longest_mm,
                distance_mm,
                place_mm: found.place_mm,
                axes: &found.axes,
            }
        });
        let clearances = outcome.clearances.iter().map(|smallest| ClearanceFigures {
            bodies: &smallest.bodies,
            distance_mm: smallest.distance_mm,
            line: smallest.line,
            cl_line: smallest.cl_line,
            tool: smallest.tool,
            place_mm: smallest.place_mm,
            axes: &smallest.axes,
        });
        Self {
            passed,
            motions: outcome.motions,
            collisions: outcome.count,
            removed_mm3: outcome.volume_mm3(),
            pitch_mm,
            stock_mm,
            tolerance_mm: outcome.deviation_mm + EPS_MM,
            taking_part: outcome.taking_part(),
            assumed: outcome.assumed(),
            not_checked: outcome.not_checked(),
            tool_table: &outcome.differences,
            operations: operations.collect(),
            tools: tools.collect(),
            engagement: OverTime { step_min: engagement.step_min, removed_mm3: &engagement.steps_mm3 },
            findings: findings.collect(),
            clearances: clearances.collect(),
            design: against.map(AgainstDesign::figures),
        }
    }
}
