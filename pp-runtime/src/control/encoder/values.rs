//! Values of the fields of templates.

use crate::nc::{Decimal, Numerals, write_number};

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
    pub(super) speed: Option<Decimal>,
    pub(super) seconds: Option<f64>,
    pub(super) posture: &'static str,
    pub(super) plane: [Decimal; 3],
    pub(super) pose: &'static str,
    pub(super) swivel_data: String,
    pub(super) numerals: Numerals,
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
            Field::Speed => self.speed.map(|speed| text(speed, Numerals::default())),
            Field::Seconds => self.seconds.map(|seconds| text(decimal(seconds, 3), plain)),
            Field::Posture => Some(self.posture.to_owned()),
            Field::First => Some(text(self.plane[0], self.numerals)),
            Field::Second => Some(text(self.plane[1], self.numerals)),
            Field::Third => Some(text(self.plane[2], self.numerals)),
            Field::Pose => Some(self.pose.to_owned()),
            Field::SwivelData => Some(self.swivel_data.clone()),
            Field::Milliseconds => self.seconds.map(|seconds| text(decimal(seconds * 1e3, 0), Numerals::default())),
        }
    }
}
