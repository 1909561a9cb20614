//! Why a pose has no place on the machine, in a machinist's words.

use crate::kinematics::{Machine, Pose};

use super::choose::{OutOfLimits, Rotary};
use super::fault::Fault;
use super::place::Placer;
use super::step::MAX_AXES;

impl<M: Machine> Placer<M> {
    pub(crate) fn limits_text(&self, index: usize) -> String {
        self.limits[index].map_or_else(
            || "none".to_owned(),
            |limits| format!("{:.4}° to {:.4}°", limits.lower.to_degrees(), limits.upper.to_degrees()),
        )
    }

    #[cold]
    pub(crate) fn outside_limits(&self, outside: &[Option<OutOfLimits>; 2]) -> Fault {
        let mut text = String::new();
        for out in outside.iter().flatten() {
            let letter = M::AXES[out.rotary.index].letter;
            let value = out.rotary.shown(out.word, self.scale);
            if text.is_empty() {
                text = format!("{letter} would have to turn to {value}°");
            } else {
                text += &format!(", or {letter} to {value}°");
            }
            text += &format!(" (limits {})", self.limits_text(out.rotary.index));
        }
        Fault::new(text).help("turn the part on the table, or correct the limits in the configuration")
    }

    #[cold]
    pub(crate) fn jump(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], nearest: &[i64; MAX_AXES]) -> Fault {
        let outside = self.rotaries.iter().find(|rotary| !rotary.holds(nearest[rotary.index]));
        let turned = self.rotaries.iter().max_by_key(|rotary| from[rotary.index].abs_diff(to[rotary.index]));
        let (Some(limit), Some(turned)) = (outside, turned) else { return self.outside_limits(&[None; 2]) };
        let degrees = |rotary: &Rotary, words: &[i64; MAX_AXES]| rotary.shown(words[rotary.index], self.scale);
        Fault::new(format_args!(
            "{} would have to turn on to {}°, outside its limits {}; turning {} from {}° to {}° instead would swing the \
             tool in the cut",
            M::AXES[limit.index].letter,
            degrees(limit, nearest),
            self.limits_text(limit.index),
            M::AXES[turned.index].letter,
            degrees(turned, from),
            degrees(turned, to),
        ))
        .help("retract before this point and start a new operation, or turn the part on the table")
    }

    #[cold]
    pub(crate) fn unreachable(&self, pose: &Pose, held: &M::Axes) -> Fault {
        match self.machine.reach(&pose.axis, held) {
            Err(reason) => Fault::new(reason),
            Ok(()) => Fault::new(format_args!(
                "{} has no position for the tool axis ({:.7}, {:.7}, {:.7})",
                M::NAME,
                pose.axis.x,
                pose.axis.y,
                pose.axis.z
            )),
        }
    }
}
