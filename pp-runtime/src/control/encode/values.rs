//! Values of template fields: data of the program, and of the tool, plane and hole that are being written.

use crate::control::template::{self, Field};
use crate::motion::{CannedCycle, CannedKind};
use crate::nc::{Decimal, Numerals, write_number};
use crate::options::BoreRetract;
use crate::program::Units;

/// Values of template fields; see [`Field`] for each.
#[derive(Debug, Default)]
pub(crate) struct Values {
    pub(crate) name: String,
    pub(crate) number: String,
    pub(crate) units: &'static str,
    pub(crate) work_offset: String,
    pub(crate) path_tolerance: String,
    pub(crate) angle_deg: Option<f64>,
    pub(crate) smoothing_level: Option<u32>,
    pub(crate) rotary_path: &'static str,
    pub(crate) tool: Option<String>,
    pub(crate) tool_number: Option<u32>,
    pub(crate) next: Option<String>,
    pub(crate) offset: Option<u32>,
    pub(crate) radius: Option<u32>,
    pub(crate) radius_delta: Option<Decimal>,
    pub(crate) speed: Option<Decimal>,
    pub(crate) seconds: Option<f64>,
    pub(crate) posture: Option<&'static str>,
    pub(crate) plane: [Decimal; 3],
    pub(crate) pose: &'static str,
    pub(crate) swivel_data: String,
    pub(crate) hole: Option<HoleValues>,
    pub(crate) numerals: Numerals,
    /// Number format of a dwell: without a point it would be in milliseconds, whatever the configuration sets for
    /// lengths.
    pub(crate) dwell_numerals: Numerals,
}

/// Values of a hole whose cycle is defined by a template.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HoleValues {
    pub(crate) cycle: CannedCycle,
    /// Decimals of its levels and distances.
    pub(crate) decimals: u32,
    pub(crate) units: Units,
}

/// A number in the number format of the control.
pub(crate) fn text(number: Decimal, numerals: Numerals) -> String {
    let mut text = Vec::new();
    write_number(&mut text, number, numerals);
    String::from_utf8(text).unwrap_or_default()
}

impl Values {
    /// The block of a template; `None` if it is left out.
    pub(crate) fn fill(&self, text: &str) -> Option<String> {
        template::fill(text, |field| self.get(field))
    }

    /// Text of a field; `None` if it has no value.
    fn get(&self, field: Field) -> Option<String> {
        let whole = |number: Option<u32>| number.map(|number| number.to_string());
        // The configuration or the planner has refused values that the format cannot hold.
        let decimal = |value: f64, decimals| Decimal::fixed(value, decimals).unwrap_or_default();
        let unsigned = Numerals { plus: false, ..self.numerals };
        let hole = self.hole.as_ref();
        let tapped = hole.and_then(|hole| thread(&hole.cycle));
        let bore = hole.and_then(|hole| Some((hole, bore(&hole.cycle)?)));
        let level = |units: fn(&CannedCycle) -> i64| hole.map(|hole| hole.length(units(&hole.cycle), self.numerals));
        match field {
            Field::Name => Some(self.name.clone()),
            Field::Number => Some(self.number.clone()),
            Field::Units => Some(self.units.to_owned()),
            Field::WorkOffset => Some(self.work_offset.clone()),
            Field::PathTolerance => Some(self.path_tolerance.clone()),
            Field::RotaryPath => Some(self.rotary_path.to_owned()),
            Field::Angle => self.angle_deg.map(|angle| text(decimal(angle, 4), unsigned)),
            Field::SmoothingLevel => whole(self.smoothing_level),
            Field::Tool => self.tool.clone(),
            Field::ToolNumber => whole(self.tool_number),
            Field::Next => self.next.clone(),
            Field::Offset => whole(self.offset),
            Field::Radius => whole(self.radius),
            Field::RadiusDelta => self.radius_delta.map(|delta| text(delta, self.numerals)),
            Field::Speed => self.speed.map(|speed| text(speed, Numerals::default())),
            Field::Seconds => self.seconds.map(|seconds| text(decimal(seconds, 3), self.dwell_numerals)),
            Field::Milliseconds => self.seconds.map(|seconds| text(decimal(seconds * 1e3, 0), Numerals::default())),
            Field::Posture => self.posture.map(str::to_owned),
            Field::First => Some(text(self.plane[0], self.numerals)),
            Field::Second => Some(text(self.plane[1], self.numerals)),
            Field::Third => Some(text(self.plane[2], self.numerals)),
            Field::Pose => Some(self.pose.to_owned()),
            Field::SwivelData => Some(self.swivel_data.clone()),
            Field::Surface => level(|hole| hole.surface),
            Field::Clearance => level(|hole| hole.clearance - hole.surface),
            Field::Bottom => level(|hole| hole.bottom),
            Field::Depth => level(|hole| hole.bottom - hole.surface),
            Field::Back => level(|hole| hole.back),
            Field::Higher => level(|hole| hole.back - hole.surface),
            // A hole without pecking is one step deep.
            Field::Step => level(|hole| steps(hole).map_or(hole.surface - hole.bottom, |[step, _]| step)),
            Field::Steps => hole.and_then(|hole| count(&hole.cycle)),
            Field::Gap => hole.and_then(|hole| Some(hole.length(steps(&hole.cycle)?[1], self.numerals))),
            Field::Feed => hole.map(|hole| text(hole.cycle.feed, unsigned)),
            Field::Pitch => tapped.map(|(pitch, left)| {
                text(Decimal { units: if left { -pitch.units } else { pitch.units }, ..pitch }, self.numerals)
            }),
            Field::PitchUnit => hole.map(|hole| if hole.units == Units::Inches { "3" } else { "1" }.to_owned()),
            Field::Rotation => hole
                .and_then(|hole| match hole.cycle.kind {
                    CannedKind::Tap { left, .. } | CannedKind::FineBore { left, .. } => Some(left),
                    _ => None,
                })
                .map(|left| if left { "4" } else { "3" }.to_owned()),
            Field::ShiftX => {
                bore.map(|(hole, bore)| hole.length(bore.direction.steps()[0] * bore.shift, self.numerals))
            }
            Field::ShiftY => {
                bore.map(|(hole, bore)| hole.length(bore.direction.steps()[1] * bore.shift, self.numerals))
            }
            Field::Quadrant => bore.map(|(_, bore)| quadrant(bore.direction).to_owned()),
            Field::Orient => bore.map(|(_, bore)| text(bore.orient, self.numerals)),
        }
    }
}

impl HoleValues {
    /// Text of a level or a distance along the tool axis.
    fn length(&self, units: i64, numerals: Numerals) -> String {
        text(Decimal { units, decimals: self.decimals }, numerals)
    }
}

/// Depth of a step and retract gap, where a hole is drilled in steps.
fn steps(cycle: &CannedCycle) -> Option<[i64; 2]> {
    match cycle.kind {
        CannedKind::Peck { step, gap } | CannedKind::ChipBreak { step, gap } => Some([step, gap]),
        CannedKind::Drill | CannedKind::Ream | CannedKind::FineBore { .. } | CannedKind::Tap { .. } => None,
    }
}

/// Number of steps.
fn count(cycle: &CannedCycle) -> Option<String> {
    let [step, _] = steps(cycle)?;
    Some(((cycle.surface - cycle.bottom) as u64).div_ceil(step as u64).to_string())
}

/// Pitch of a thread, and whether it is left-hand.
fn thread(cycle: &CannedCycle) -> Option<(Decimal, bool)> {
    match cycle.kind {
        CannedKind::Tap { pitch, left, .. } => Some((pitch, left)),
        CannedKind::Drill
        | CannedKind::Ream
        | CannedKind::FineBore { .. }
        | CannedKind::Peck { .. }
        | CannedKind::ChipBreak { .. } => None,
    }
}

/// Values of a bore with an oriented spindle.
struct Bore {
    direction: BoreRetract,
    shift: i64,
    orient: Decimal,
}

fn bore(cycle: &CannedCycle) -> Option<Bore> {
    match cycle.kind {
        CannedKind::FineBore { direction, shift, orient, .. } => Some(Bore { direction, shift, orient }),
        _ => None,
    }
}

fn quadrant(direction: BoreRetract) -> &'static str {
    match direction {
        BoreRetract::MinusX => "1",
        BoreRetract::MinusY => "2",
        BoreRetract::PlusX => "3",
        BoreRetract::PlusY => "4",
    }
}
