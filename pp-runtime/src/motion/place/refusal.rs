//! Messages for poses that the machine cannot reach.

use crate::kinematics::{AxisValues, Pose};

use super::Placer;
use crate::motion::fault::Fault;
use crate::motion::rotary::{OutOfLimits, Rotary};
use crate::motion::step::MAX_AXES;

/// Limits of a rotary axis as text.
pub(crate) fn limits_text(placer: &Placer, index: usize) -> String {
    placer.limits[index].map_or_else(
        || "none".to_owned(),
        |limits| format!("{:.4}° to {:.4}°", limits.lower.to_degrees(), limits.upper.to_degrees()),
    )
}

/// The fault that an axis is outside its limits in every whole turn.
#[cold]
pub(crate) fn outside_limits(placer: &Placer, outside: &[Option<OutOfLimits>; 2]) -> Fault {
    let mut text = String::new();
    for out in outside.iter().flatten() {
        let letter = placer.chain()[out.rotary.index].letter;
        let value = out.rotary.degrees_for_display(out.word, placer.rotary.scale);
        if text.is_empty() {
            text = format!("{letter} would have to rotate to {value}°");
        } else {
            text += &format!(", or {letter} to {value}°");
        }
        text += &format!(" (limits {})", limits_text(placer, out.rotary.index));
    }
    Fault::new(text).help("rotate the part on the table (`part_rotation`), or correct the limits in the configuration")
}

/// The fault that only a swing of the tool in the cut would keep an axis inside its limits.
#[cold]
pub(crate) fn jump(placer: &Placer, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], nearest: &[i64; MAX_AXES]) -> Fault {
    let outside = placer.rotary.axes.iter().find(|rotary| !rotary.contains(nearest[rotary.index]));
    let swung = placer.rotary.axes.iter().max_by_key(|rotary| from[rotary.index].abs_diff(to[rotary.index]));
    let (Some(limit), Some(swung)) = (outside, swung) else { return outside_limits(placer, &[None; 2]) };
    let degrees =
        |rotary: &Rotary, words: &[i64; MAX_AXES]| rotary.degrees_for_display(words[rotary.index], placer.rotary.scale);
    Fault::new(format_args!(
        "{} would have to continue to {}°, outside its limits {}; rotating {} from {}° to {}° instead would swing the \
         tool in the cut",
        placer.chain()[limit.index].letter,
        degrees(limit, nearest),
        limits_text(placer, limit.index),
        placer.chain()[swung.index].letter,
        degrees(swung, from),
        degrees(swung, to),
    ))
    .help("retract before this point and start a new operation, or rotate the part on the table (`part_rotation`)")
}

/// The fault that the machine cannot reach a tool axis.
#[cold]
pub(crate) fn unreachable(placer: &Placer, pose: &Pose, held: &AxisValues) -> Fault {
    match placer.machine.reach(&pose.axis, held) {
        Err(reason) => Fault::new(reason),
        Ok(()) => Fault::new(format_args!(
            "{} cannot reach the tool axis ({:.7}, {:.7}, {:.7})",
            placer.machine().name(),
            pose.axis.x,
            pose.axis.y,
            pose.axis.z
        )),
    }
}
