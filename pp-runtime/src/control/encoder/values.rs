//! Values of the fields of templates.

use crate::motion::{Cycle, CycleKind};
use crate::nc::{Decimal, Numerals, write_number};
use crate::program::Units;

use super::super::template::Field;

/// Values of the fields of templates.
#[derive(Debug, Default)]
pub(super) struct Values {
    pub(super) name: String,
    pub(super) number: String,
    pub(super) units: &'static str,
    pub(super) work_offset: String,
    pub(super) path_tolerance: String,
    pub(super) angle: Option<f64>,
    pub(super) turning: &'static str,
    pub(super) tool: Option<u32>,
    pub(super) next: Option<u32>,
    pub(super) offset: Option<u32>,
    pub(super) radius: Option<u32>,
    pub(super) speed: Option<Decimal>,
    pub(super) seconds: Option<f64>,
    pub(super) posture: &'static str,
    pub(super) plane: [Decimal; 3],
    pub(super) pose: &'static str,
    pub(super) swivel_data: String,
    pub(super) hole: Option<HoleValues>,
    pub(super) numerals: Numerals,
    /// Those of a wait: without its point it counts milliseconds, whatever the set-up says of lengths.
    pub(super) timed: Numerals,
}

/// A hole, where a cycle is defined by a template.
#[derive(Debug, Clone, Copy)]
pub(super) struct HoleValues {
    pub(super) cycle: Cycle,
    /// Decimals of its levels.
    pub(super) decimals: u32,
    pub(super) units: Units,
}

/// A number as the control writes it.
pub(super) fn text(number: Decimal, numerals: Numerals) -> String {
    let mut text = Vec::new();
    write_number(&mut text, number, numerals);
    String::from_utf8(text).unwrap_or_default()
}

impl Values {
    /// The text of a field; `None` if it has no value here.
    pub(super) fn get(&self, field: Field) -> Option<String> {
        let whole = |number: Option<u32>| number.map(|number| number.to_string());
        // What the format cannot hold was refused with the configuration or by the planner.
        let decimal = |value: f64, decimals| Decimal::fixed(value, decimals).unwrap_or_default();
        let plain = Numerals { plus: false, ..self.numerals };
        match field {
            Field::Name => Some(self.name.clone()),
            Field::Number => Some(self.number.clone()),
            Field::Units => Some(self.units.to_owned()),
            Field::WorkOffset => Some(self.work_offset.clone()),
            Field::PathTolerance => Some(self.path_tolerance.clone()),
            Field::Turning => Some(self.turning.to_owned()),
            Field::Angle => self.angle.map(|angle| text(decimal(angle, 4), plain)),
            Field::Tool => whole(self.tool),
            Field::Next => whole(self.next),
            Field::Offset => whole(self.offset),
            Field::Radius => whole(self.radius),
            Field::Speed => self.speed.map(|speed| text(speed, Numerals::default())),
            Field::Seconds => self.seconds.map(|seconds| text(decimal(seconds, 3), self.timed)),
            Field::Posture => Some(self.posture.to_owned()),
            Field::First => Some(text(self.plane[0], self.numerals)),
            Field::Second => Some(text(self.plane[1], self.numerals)),
            Field::Third => Some(text(self.plane[2], self.numerals)),
            Field::Pose => Some(self.pose.to_owned()),
            Field::SwivelData => Some(self.swivel_data.clone()),
            Field::Surface
            | Field::Clearance
            | Field::Bottom
            | Field::Depth
            | Field::Back
            | Field::Higher
            | Field::Step
            | Field::Steps
            | Field::Gap
            | Field::Feed
            | Field::Pitch
            | Field::PitchUnit
            | Field::Rotation => self.hole.as_ref().and_then(|hole| hole.get(field, self.numerals)),
            Field::Milliseconds => self.seconds.map(|seconds| text(decimal(seconds * 1e3, 0), Numerals::default())),
        }
    }
}

impl HoleValues {
    fn get(&self, field: Field, numerals: Numerals) -> Option<String> {
        let Cycle { kind, surface, clearance, bottom, back, feed, .. } = self.cycle;
        let length = |units: i64| Some(text(Decimal { units, decimals: self.decimals }, numerals));
        match (field, kind) {
            (Field::Surface, _) => length(surface),
            (Field::Clearance, _) => length(clearance - surface),
            (Field::Bottom, _) => length(bottom),
            (Field::Depth, _) => length(bottom - surface),
            (Field::Back, _) => length(back),
            (Field::Higher, _) => length(back - surface),
            (Field::Step, CycleKind::Peck { step, .. } | CycleKind::ChipBreak { step, .. }) => length(step),
            (Field::Gap, CycleKind::Peck { gap, .. } | CycleKind::ChipBreak { gap, .. }) => length(gap),
            (Field::Steps, CycleKind::Peck { step, .. } | CycleKind::ChipBreak { step, .. }) => {
                Some(((surface - bottom) as u64).div_ceil(step as u64).to_string())
            }
            // In one step.
            (Field::Step, _) => length(surface - bottom),
            (Field::Feed, _) => Some(text(feed, Numerals { plus: false, ..numerals })),
            (Field::Pitch, CycleKind::Tap { pitch, left, .. }) => {
                Some(text(Decimal { units: if left { -pitch.units } else { pitch.units }, ..pitch }, numerals))
            }
            (Field::PitchUnit, _) => Some(if self.units == Units::Inches { "3" } else { "1" }.to_owned()),
            (Field::Rotation, CycleKind::Tap { left, .. }) => Some(if left { "4" } else { "3" }.to_owned()),
            _ => None,
        }
    }
}
