//! Result of a simulation: findings, volumes, and what took part.

use std::collections::BTreeMap;

use super::engagement::Engagement;
use crate::simulate::machine::SHOWN_MM;
use crate::simulate::tools::{ToolBodies, ToolBody};

/// Findings that are kept; all are counted.
const MOST_FOUND: usize = 1000;

/// Smallest clearances in the summary.
const MOST_CLEARANCES: usize = 8;

/// Blocks between two contacts that are one finding.
const SAME_FINDING: u64 = 3;

/// What meets the stock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contacting {
    /// The cutting part at feed with the spindle on: no finding.
    Cut,
    /// The cutting part at rapid.
    Rapid,
    /// The cutting part at feed with the spindle off.
    Still,
    /// The shank.
    Shank,
    /// The holder.
    Holder,
}

impl Contacting {
    /// Name, as in JSON.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Cut => "cut",
            Self::Rapid => "rapid_through_stock",
            Self::Still => "spindle_off",
            Self::Shank => "shank",
            Self::Holder => "holder",
        }
    }

    const fn text(self) -> &'static str {
        match self {
            Self::Cut => "cut",
            Self::Rapid => "rapid through the stock",
            Self::Still => "the spindle is off in the stock",
            Self::Shank => "the shank meets the stock",
            Self::Holder => "the holder meets the stock",
        }
    }
}

/// What a finding is about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum What {
    /// A part of the tool in the stock.
    Stock(Contacting),
    /// Two bodies that meet, or are nearer than the clearance.
    Bodies([String; 2]),
}

impl What {
    /// Name, as in JSON.
    pub(crate) const fn name(&self) -> &'static str {
        match self {
            Self::Stock(contacting) => contacting.name(),
            Self::Bodies(_) => "collision",
        }
    }
}

/// Size of a finding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Size {
    /// Material of the stock, and the longest part of one of its lines.
    Cut { volume_mm3: f64, longest_mm: f64 },
    /// Distance of two bodies that is certain; `None`: they meet.
    Apart(Option<f64>),
}

/// A finding: blocks that follow each other with the same contact.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FoundContact {
    pub(crate) what: What,
    /// First and last line of the program.
    pub(crate) lines: [u64; 2],
    pub(crate) cl_line: u64,
    pub(crate) operation: u64,
    pub(crate) tool: u32,
    pub(crate) size: Size,
    /// Where it is worst, from the part zero.
    pub(crate) place_mm: [f64; 3],
    /// Positions of the axes there, mm and degrees; empty where they are not stated.
    pub(crate) axes: Vec<(char, f64)>,
}

impl FoundContact {
    /// A sentence.
    pub(crate) fn text(&self) -> String {
        let [first, last] = self.lines;
        let lines = if first == last { format!("line {first}") } else { format!("lines {first} to {last}") };
        let [x, y, z] = self.place_mm;
        let what = match (&self.what, self.size) {
            (What::Stock(contacting), _) => contacting.text().to_owned(),
            (What::Bodies([one, two]), Size::Apart(Some(least_mm))) => {
                format!("{one} and {two} come within {least_mm:.2} mm of each other")
            }
            (What::Bodies([one, two]), _) => format!("{one} and {two} collide"),
        };
        let size = match self.size {
            Size::Cut { volume_mm3, longest_mm } => format!(", {volume_mm3:.1} mm\u{b3}, {longest_mm:.2} mm long"),
            Size::Apart(_) => String::new(),
        };
        let axes: Vec<String> = self.axes.iter().map(|(letter, value)| format!("{letter}{value:.3}")).collect();
        let axes = if axes.is_empty() { String::new() } else { format!(", axes at {}", axes.join(" ")) };
        format!(
            "{what}: {lines} of the program (CL line {}), tool {}{size} at X{x:.2} Y{y:.2} Z{z:.2}{axes}",
            self.cl_line, self.tool
        )
    }

    /// Whether it is worse than another one.
    fn is_worse(&self, other: &Self) -> bool {
        match (self.size, other.size) {
            (Size::Cut { longest_mm: here, .. }, Size::Cut { longest_mm: there, .. }) => here > there,
            (Size::Apart(here), Size::Apart(there)) => here.unwrap_or(-1.0) < there.unwrap_or(-1.0),
            _ => false,
        }
    }
}

/// Smallest distance of two bodies in the program.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SmallestClearance {
    pub(crate) bodies: [String; 2],
    pub(crate) distance_mm: f64,
    pub(crate) line: u64,
    pub(crate) cl_line: u64,
    pub(crate) tool: u32,
    /// From the part zero.
    pub(crate) place_mm: [f64; 3],
    pub(crate) axes: Vec<(char, f64)>,
}

/// Result of a simulation.
#[derive(Debug, Clone, Default)]
pub(crate) struct SimulationOutcome {
    pub(crate) motions: u64,
    pub(crate) found: Vec<FoundContact>,
    /// Number of findings.
    pub(crate) count: u64,
    pub(crate) engagement: Engagement,
    /// Motions that have not been simulated, by reason.
    pub(crate) unknown: BTreeMap<&'static str, u64>,
    /// Rapids whose axes arrive in any order and rotate the tool: only their straight path is compared.
    pub(crate) rotating_rapids: u64,
    /// Operations that leave an allowance, by the first lines of their cuts: line and allowance, mm; 0 where none is
    /// left.
    allowances: Vec<(u64, f64)>,
    /// Largest deviation of the pieces from the executed path, mm.
    pub(crate) deviation_mm: f64,
    /// Lines whose ends are not certified.
    pub(crate) uncertified: u64,
    /// Smallest distances of bodies, the smallest first.
    pub(crate) clearances: Vec<SmallestClearance>,
    /// Number of pairs of bodies that are nowhere nearer than [`SHOWN_MM`].
    pub(crate) far_pairs: usize,
    /// Links of the machine without a solid.
    pub(crate) without_solids: Vec<String>,
    /// Sentences about tools that the machine knows otherwise than they were posted.
    pub(crate) differences: Vec<String>,
    /// Sentence about the file of the machined stock.
    pub(crate) saved: Option<String>,
    /// What took part.
    taking_part: Vec<String>,
    assumed: Vec<String>,
    not_checked: Vec<String>,
}

impl SimulationOutcome {
    pub(crate) fn new(tools: &ToolBodies) -> Self {
        let of = |has: &dyn Fn(&ToolBody) -> bool, part: &str| {
            let numbers: Vec<String> =
                tools.bodies.iter().filter(|(_, body)| has(body)).map(|(number, _)| number.to_string()).collect();
            match numbers.as_slice() {
                [] => None,
                [one] => Some(format!("{part} of tool {one}")),
                _ => Some(format!("{part} of tools {}", numbers.join(", "))),
            }
        };
        let parts = [
            of(&|body| !body.cutter.is_empty(), "cutting part"),
            of(&|body| !body.shank.is_empty(), "shank"),
            of(&|body| !body.holder.is_empty(), "holder"),
        ];
        Self {
            taking_part: parts.into_iter().flatten().chain(["stock".to_owned()]).collect(),
            assumed: tools.assumed.clone(),
            not_checked: tools.not_checked.clone(),
            ..Self::default()
        }
    }

    /// Names what took part besides the tools.
    pub(crate) fn take_part(&mut self, name: String) {
        if !self.taking_part.contains(&name) {
            self.taking_part.push(name);
        }
    }

    /// Takes the allowance of a cut.
    pub(super) fn allow(&mut self, line: u64, allowance_mm: f64) {
        let last = self.allowances.last().map_or(0.0, |(_, last)| *last);
        if (last - allowance_mm).abs() > 0.0 {
            self.allowances.push((line, allowance_mm));
        }
    }

    /// Material that the operation of a line leaves, mm.
    pub(crate) fn allowance_mm(&self, line: u64) -> f64 {
        let after = self.allowances.partition_point(|(first, _)| *first <= line);
        after.checked_sub(1).map_or(0.0, |index| self.allowances[index].1)
    }

    /// States an assumption.
    pub(crate) fn assume(&mut self, text: String) {
        self.assumed.push(text);
    }

    /// States what has not been checked.
    pub(crate) fn leave_out(&mut self, text: String) {
        self.not_checked.push(text);
    }

    /// Distance of a machined end from the programmed motion, mm: at most, as it is held in single precision.
    pub(crate) fn certified_mm(&self, corners: [[f64; 3]; 2]) -> f64 {
        let farthest = corners.iter().flatten().fold(0.0_f64, |farthest, value| farthest.max(value.abs()));
        self.deviation_mm + EPS_MM + farthest * 0.5 * f64::from(f32::EPSILON)
    }

    /// Adds a contact: to the finding that it continues, or as a new one.
    pub(crate) fn add(&mut self, found: FoundContact) {
        let continued = self.found.iter_mut().rev().take(8).find(|last| {
            last.what == found.what
                && (last.tool, last.operation) == (found.tool, found.operation)
                && found.lines[0] <= last.lines[1] + SAME_FINDING
        });
        if let Some(last) = continued {
            last.lines[1] = last.lines[1].max(found.lines[1]);
            let worse = found.is_worse(last);
            let volume = |size: &Size| if let Size::Cut { volume_mm3, .. } = size { *volume_mm3 } else { 0.0 };
            let total = volume(&last.size) + volume(&found.size);
            if worse {
                (last.size, last.place_mm, last.axes) = (found.size, found.place_mm, found.axes);
            }
            if let Size::Cut { volume_mm3, .. } = &mut last.size {
                *volume_mm3 = total;
            }
            return;
        }
        self.count += 1;
        if self.found.len() < MOST_FOUND {
            self.found.push(found);
        }
    }

    /// Volume that was cut, mm³.
    pub(crate) fn volume_mm3(&self) -> f64 {
        self.engagement.volume_mm3()
    }

    /// What is assumed, as sentences.
    pub(crate) fn assumed(&self) -> &[String] {
        &self.assumed
    }

    /// What took part.
    pub(crate) fn taking_part(&self) -> &[String] {
        &self.taking_part
    }

    /// What has not been checked, as sentences.
    pub(crate) fn not_checked(&self) -> Vec<String> {
        let mut all = self.not_checked.clone();
        all.extend(self.unknown.iter().map(|(reason, count)| format!("{count} motions {reason}")));
        if self.rotating_rapids > 0 {
            let text =
                "rapids that rotate the tool while each axis moves on its own: only their straight path is compared";
            all.push(format!("{} {text}", self.rotating_rapids));
        }
        if self.uncertified > 0 {
            all.push(format!("{} lines of the stock whose ends are not certified", self.uncertified));
        }
        if self.engagement.is_empty() && self.count == 0 && self.motions > 0 {
            all.push("no motion meets the stock: it may be elsewhere than the part".to_owned());
        }
        if !self.without_solids.is_empty() {
            all.push(format!("collisions of {}: no solids are given", self.without_solids.join(", ")));
        }
        all
    }

    /// The result in one line.
    pub(crate) fn line(&self) -> String {
        let among = self.taking_part.join(", ");
        let collisions = if self.count == 1 { "1 collision" } else { &format!("{} collisions", self.count) };
        format!("simulated: {} motions, {collisions} among {among}", self.motions)
    }

    /// Lines of the summary.
    pub(crate) fn summary(&self) -> Vec<String> {
        let mut lines = vec![
            self.line(),
            format!(
                "removed: {:.3} cm\u{b3}; cut surfaces are within {:.4} mm of the programmed motion, contacts count from {TOUCH_MM} mm",
                self.volume_mm3() / 1e3,
                self.deviation_mm + EPS_MM
            ),
        ];
        lines.extend(self.engagement.operations.iter().map(|((operation, tool), removal)| {
            let time = if removal.minutes > 0.0 { format!(" in {:.2} min", removal.minutes) } else { String::new() };
            let largest = removal.largest.map_or(String::new(), |(rate, line)| {
                format!(", at most {:.3} cm\u{b3}/min (line {line} of the program)", rate / 1e3)
            });
            format!("operation {operation}, tool {tool}: {:.3} cm\u{b3}{time}{largest}", removal.volume_mm3 / 1e3)
        }));
        let tools = self.engagement.of_tools();
        if tools.len() > 1 && tools.len() < self.engagement.operations.len() {
            lines.extend(tools.iter().map(|(tool, (volume, minutes))| {
                format!("tool {tool}: {:.3} cm\u{b3} in {minutes:.2} min", volume / 1e3)
            }));
        }
        lines.extend(self.clearances.iter().take(MOST_CLEARANCES).map(|smallest| {
            let SmallestClearance { bodies: [one, two], distance_mm, line, cl_line, .. } = smallest;
            format!("smallest clearance: {one} and {two} {distance_mm:.2} mm, line {line} of the program (CL line {cl_line})")
        }));
        let more = self.clearances.len().saturating_sub(MOST_CLEARANCES);
        if self.far_pairs + more > 0 {
            let all = if more > 0 { format!("{more} more pairs of bodies are farther apart, ") } else { String::new() };
            lines.push(format!("{all}{} pairs of bodies are nowhere nearer than {SHOWN_MM} mm", self.far_pairs));
        }
        lines.extend(self.saved.clone());
        lines.extend(self.assumed.iter().map(|text| format!("assumed: {text}")));
        lines.extend(self.not_checked().iter().map(|text| format!("not checked: {text}")));
        lines
    }
}

/// Tolerance of the removal, mm.
pub(crate) const EPS_MM: f64 = 1e-3;

/// Depth from which a contact counts, mm.
pub(crate) const TOUCH_MM: f64 = 0.02;
