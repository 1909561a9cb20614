//! `[course]`: how branch and turns of the rotary axes are chosen.

use crate::kinematics::{Axis, AxisKind, Branch, Machine};

use super::Config;
use super::read::set;
use super::value::{Bound, Quantity, Reader, Section};

pub(super) const START_BRANCHES: [(&str, Branch); 2] = [("first", Branch::First), ("second", Branch::Second)];

/// Largest axis tolerance, rad: wider is another path.
const LARGEST_AXIS_TOLERANCE: f64 = 5_f64.to_radians();

impl Config {
    pub(super) fn read_course<M: Machine>(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "course.start_branch") {
            self.motion.course.start_branch = r.choice(value, &START_BRANCHES);
        }
        if let Some(value) = self.get(section, "course.prefer")
            && let Some(text) = r.line(value)
        {
            self.motion.course.prefer = preference::<M>(&text);
            if self.motion.course.prefer.is_none() {
                r.fault(value.span(), format!("\"{text}\" is not known here"), Some(preferences::<M>()));
            }
        }
        if let Some(value) = self.get(section, "course.greedy") {
            set(&mut self.motion.course.greedy, r.boolean(value));
        }
        if let Some(value) = self.get(section, "course.axis_tolerance") {
            let tolerance = r.number(value, Quantity::Angle, Bound::NotNegative);
            if tolerance.is_some_and(|tolerance| tolerance > LARGEST_AXIS_TOLERANCE) {
                let text =
                    format!("an angle of at most {} degrees is needed here", LARGEST_AXIS_TOLERANCE.to_degrees());
                r.fault(value.span(), text, None);
            }
            set(&mut self.motion.course.axis_tolerance, tolerance);
        }
    }
}

fn solved_rotaries<M: Machine>() -> impl Iterator<Item = &'static Axis> {
    M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held)
}

/// `B+`: a rotary axis of the machine, and the side of zero on which operations are to begin.
pub(crate) fn preference<M: Machine>(text: &str) -> Option<(char, bool)> {
    let positive = [('+', true), ('-', false)];
    positive.into_iter().find_map(|(sign, positive)| {
        let letter = text.strip_suffix(sign)?.trim();
        solved_rotaries::<M>()
            .find(|axis| letter.eq_ignore_ascii_case(&axis.letter.to_string()))
            .map(|axis| (axis.letter, positive))
    })
}

/// What may be preferred on this machine, as a help.
pub(crate) fn preferences<M: Machine>() -> String {
    let all: Vec<String> =
        solved_rotaries::<M>().flat_map(|axis| ['+', '-'].map(|sign| format!("\"{}{sign}\"", axis.letter))).collect();
    match all.is_empty() {
        true => format!("{} has no rotary axis to choose for", M::NAME),
        false => format!("write one of {}", all.join(", ")),
    }
}
