//! Messages for poses that the machine cannot reach.

use crate::diag::code::plan;
use crate::kinematics::{AxisValues, OutOfLimits, Pose, Rotary};

use super::Placer;
use crate::motion::fault::Fault;
use crate::motion::rotary::RotaryWords;

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
    plan::LIMITS
        .fault(text)
        .help("rotate the part on the table (`part_rotation`), or correct the limits in the configuration")
}

/// The fault that only a swing of the tool in the cut would keep an axis inside its limits.
#[cold]
pub(crate) fn jump(placer: &Placer, from: &RotaryWords, to: &RotaryWords, nearest: &RotaryWords) -> Fault {
    let axes = || placer.rotary.axes.iter().enumerate();
    let outside = axes().find(|(axis, rotary)| !rotary.contains(nearest[*axis]));
    let swung = axes().max_by_key(|(axis, _)| from[*axis].abs_diff(to[*axis]));
    let (Some(limit), Some(swung)) = (outside, swung) else { return outside_limits(placer, &[None; 2]) };
    let letter = |(_, rotary): (usize, &Rotary)| placer.chain()[rotary.index].letter;
    let degrees = |(axis, rotary): (usize, &Rotary), words: &RotaryWords| {
        rotary.degrees_for_display(words[axis], placer.rotary.scale)
    };
    plan::LIMITS.fault(format_args!(
        "{} would have to continue to {}°, outside its limits {}; rotating {} from {}° to {}° instead would swing the \
         tool in the cut",
        letter(limit),
        degrees(limit, nearest),
        limits_text(placer, limit.1.index),
        letter(swung),
        degrees(swung, from),
        degrees(swung, to),
    ))
    .help("retract before this point and start a new operation, or rotate the part on the table (`part_rotation`)")
}

/// The fault that the machine cannot reach a tool axis.
#[cold]
pub(crate) fn unreachable(placer: &Placer, pose: &Pose, held: &AxisValues) -> Fault {
    match placer.machine.reach(&pose.axis, held) {
        Err(reason) => plan::REACH.fault(reason),
        Ok(()) => plan::REACH.fault(format_args!(
            "{} cannot reach the tool axis ({:.7}, {:.7}, {:.7})",
            placer.machine().name(),
            pose.axis.x,
            pose.axis.y,
            pose.axis.z
        )),
    }
}
