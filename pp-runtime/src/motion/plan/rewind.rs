//! Rewinding, where no course of the rotary axes stays within their limits: the tool leaves the part, the axes rotate,
//! and it returns to the same pose; or the tip stays in place while they rotate.

use crate::diag::code::plan;
use crate::options::Rewind;
use crate::program::Move;

use crate::motion::fault::{Fault, ItemError, Planned};
use crate::motion::place::PathTolerance;
use crate::motion::plan::Planner;
use crate::motion::rotary::{RotaryTarget, RotaryWords};
use crate::motion::step::BlockReason;
use crate::motion::step::Sink;

/// Rewinds as configured by `retract.rewind`, before a motion.
#[cold]
pub(crate) fn rewind<S: Sink>(planner: &mut Planner<'_, S>, motion: &Move, words: RotaryWords) -> Planned {
    let why = reason(planner);
    let how = planner.policy.options.retract.rewind;
    rewind_as(planner, motion, words, how, &why)
}

/// Rotates the rotary axes out of the part where they would rotate farther at the pole, with the tool in the cut, than
/// `course.rotation_at_pole` permits. Returns whether they have.
pub(crate) fn rotate_out_of_cut<S: Sink>(
    planner: &mut Planner<'_, S>,
    motion: &Move,
    words: RotaryWords,
) -> Result<bool, ItemError> {
    let Some(most) = planner.policy.options.course.rotation_at_pole_rad else { return Ok(false) };
    let placer = planner.mover.placer();
    let turned = placer.position_at_words(&words);
    let Some((letter, angle)) = placer.largest_rotation(&planner.mover.here().words, &turned.words) else {
        return Ok(false);
    };
    if angle <= most {
        return Ok(false);
    }
    let (angle, most) = (angle.to_degrees(), most.to_degrees());
    let why =
        format!("at the pole {letter} has to rotate by {angle:.3}°, more than `course.rotation_at_pole` = {most}°");
    rewind_as(planner, motion, words, Rewind::Leave, &why)?;
    Ok(true)
}

/// Rewinds before a motion, in place or out of the part.
#[cold]
fn rewind_as<S: Sink>(
    planner: &mut Planner<'_, S>,
    motion: &Move,
    words: RotaryWords,
    how: Rewind,
    why: &str,
) -> Planned {
    planner.mover.output_mut().set_reason(BlockReason::Rewind);
    let how = match how {
        Rewind::Follow => {
            rewind_in_place(planner, motion, words)?;
            " with the tip in place (the tool swings about it)"
        }
        Rewind::Leave => {
            rewind_out_of_part(planner, motion, words, why)?;
            " out of the part"
        }
    };
    let output = planner.mover.output_mut();
    output.statistics_mut().rewinds += 1;
    output.set_reason(BlockReason::Record);
    output.remark(plan::REWIND.fault(format_args!("the rotary axes are rewound here{how}: {why}")));
    Ok(())
}

/// Out along the tool axis, machine retract, rotary axes, approach, and back along the tool axis at feed.
fn rewind_out_of_part<S: Sink>(planner: &mut Planner<'_, S>, motion: &Move, words: RotaryWords, why: &str) -> Planned {
    let here = *planner.mover.here();
    let out = planner.clearance.retract_distance_mm(&here.pose);
    let Some(distance) = planner.policy.options.retract.distance_mm.or(out) else {
        let text = format!("the rotary axes have to be rewound out of the part here: {why}");
        let help = "give `retract.distance` or `retract.clearance` in the configuration, or CLEARP in the CL data";
        return Err(plan::REWIND.fault(text).help(help).into());
    };
    let turned = planner.mover.place(&here.pose, false, Some(RotaryTarget { words, sense: None }))?;
    let tip = here.pose.tip + here.pose.axis.into_inner() * distance;
    let units = planner.mover.placer().units();
    let context = |fault: Fault| fault.context(format_args!("the retract by {} for a rewind", units.length(distance)));
    let out = planner.mover.shifted(tip, &here).map_err(context)?;
    planner.mover.output_mut().cancel_inverse_time()?;
    if planner.policy.options.retract.rewind_dry {
        planner.stop_coolant()?;
    }
    planner.mover.rapid_linear(&out)?;
    planner.mover.position_mut().forget_retract();
    planner.mover.machine_retract()?;
    let (turned, frame) = planner.mover.framed_at(turned)?;
    let above = planner.mover.shifted(tip, &turned).map_err(context)?;
    planner.mover.note_rotation(&above);
    planner.mover.approach_from_retract(&above, frame)?;
    planner.apply_coolant()?;
    planner.mover.position_mut().forget_retract();
    planner.mover.position_mut().go_to(&above);
    let entry = planner.policy.options.retract.entry_feed_mm_per_min;
    planner.mover.feed_block(&turned, entry.map_or_else(|| planner.rate(motion.feed), Ok)?)?;
    planner.mover.position_mut().go_to(&turned);
    planner.mover.position_mut().forget_lead_out();
    Ok(())
}

/// The rotary axes rotate while the linear axes follow: the tip stays in place, and the tool swings about it.
fn rewind_in_place<S: Sink>(planner: &mut Planner<'_, S>, motion: &Move, words: RotaryWords) -> Planned {
    let pose = planner.mover.position().pose();
    let turned = planner.mover.place(&pose, false, Some(RotaryTarget { words, sense: None }))?;
    planner.mover.note_rotation(&turned);
    let swinging = PathTolerance { axis_rad: f64::INFINITY, ..planner.mover.tolerance() };
    planner.mover.feed_in_pieces(&turned, planner.rate(motion.feed)?, swinging)?;
    planner.mover.position_mut().go_to(&turned);
    Ok(())
}

/// Reason for the rewind, with the limits of the rotary axes.
fn reason<S: Sink>(planner: &Planner<'_, S>) -> String {
    let placer = planner.mover.placer();
    let limited = placer.rotaries().iter().filter(|rotary| !rotary.endless());
    let limits: Vec<String> = limited
        .map(|rotary| {
            format!(
                "{} {}",
                placer.chain()[rotary.index].letter,
                crate::motion::place::limits_text(placer, rotary.index)
            )
        })
        .collect();
    let how = match (planner.policy.options.course.greedy, placer.has_many_turns()) {
        (true, _) => "not planned ahead (`course.greedy`)",
        (false, true) => "not avoided by any turn that was examined",
        (false, false) => "unavoidable",
    };
    format!("{how} within {}", limits.join(", "))
}
