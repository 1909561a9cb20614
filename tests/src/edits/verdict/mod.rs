//! Harm of an edit: the traces of two programs, compared.
//!
//! Harmful: another motion, another state in a cut, a wait, a guard or a stop that is missing or changed. Harmless: the
//! same motions in the same states, in the same order. Between the two are deviations within tolerance and rounding,
//! and states that differ only where nothing is cut.

mod difference;
mod events;
mod rearranged;

use crate::foreign::axes::Axes;
use crate::foreign::state::State;
use crate::foreign::{Effect, Refused, Trace};
use difference::Difference::{Hard, Soft};
use difference::difference;
use events::{Event, events};
use rearranged::rearranged;

/// Tool axis on the workpiece for the positions of the rotary axes, degrees; `None` where one of them is unknown.
pub type ToolAxis = fn(&Axes) -> Option<[f64; 3]>;

/// What is not harmful for certain.
#[derive(Debug, Clone, Copy)]
pub struct Allowed {
    /// Linear axes, in the unit of the program.
    pub linear: f64,
    /// One unit of linear words.
    pub unit: f64,
    /// Rotary axes, degrees.
    pub rotary_deg: f64,
    /// Rotary axes may roll over, so that whole revolutions make no difference.
    pub wraps: bool,
    /// The sign of a rotary word may be the direction of its rotation.
    pub signs_turn: bool,
    /// Where words under tip control are coordinates of the tip on the workpiece: the tool axis, which decides whether
    /// a rotary axis is free.
    pub tool_axis: Option<ToolAxis>,
    /// Largest speeds of axes hold back F.
    pub axis_speeds: bool,
    /// A control that is switched on is in continuous path mode.
    pub starts_continuous: bool,
    /// Letters of the axes with the clamp of M10 and M11, and with that of M68 and M69.
    pub clamped: [Option<char>; 2],
}

/// Harm of an edit.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The control does something else.
    Harmful(String),
    /// The control stops, or the code is unknown.
    Refused(String),
    /// Deviations within tolerance, or other states where nothing is cut.
    Undecided(String),
    /// The control does the same.
    Harmless,
}

/// Compares the trace of an edited program with that of the original.
#[must_use]
pub fn verdict(original: &Trace, edited: &Result<Trace, Refused>, allowed: Allowed) -> Verdict {
    let edited = match edited {
        Ok(trace) => trace,
        Err(refused) => return Verdict::Refused(refused.to_string()),
    };
    let start = State::default();
    let ((was, was_again), (is, is_again)) = (events(original, &start), events(edited, &start));
    let mut soft = (was_again != is_again).then(|| "a motion to where the axes are".to_owned());
    for (index, (one, other)) in was.iter().zip(&is).enumerate() {
        match difference(one, other, allowed) {
            Some(Hard(why)) => {
                return rearranged(&was, &is, index, allowed).unwrap_or(Verdict::Harmful(at(other, &why)));
            }
            Some(Soft(why)) => soft = soft.or_else(|| Some(at(other, &why))),
            None => {}
        }
    }
    let skippable = |trace: &Trace| trace.blocks.iter().map(|block| block.skippable).collect::<Vec<_>>();
    let skips = [original, edited].iter().any(|trace| trace.blocks.iter().any(|block| block.skippable));
    if skips && skippable(original) != skippable(edited) {
        soft = soft.or_else(|| Some("a block without effect that may be skipped".to_owned()));
    }
    if edited.blank != original.blank {
        soft = soft.or_else(|| Some("the blank of the graphics".to_owned()));
    }
    if edited.blocks.last().map(|block| &block.effect) != original.blocks.last().map(|block| &block.effect) {
        soft = soft.or_else(|| Some("the last block".to_owned()));
    }
    if was.len() != is.len() {
        let index = was.len().min(is.len());
        let why = format!("{} actions became {}", was.len(), is.len());
        return rearranged(&was, &is, index, allowed).unwrap_or(Verdict::Harmful(why));
    }
    soft.map_or(Verdict::Harmless, Verdict::Undecided)
}

/// Whether a program that is harmless from its beginning is another one from a restart point.
///
/// `entered` gives the trace from the restart point with a number.
#[must_use]
pub fn restarts_differ(
    traces: [&Trace; 2],
    entered: impl Fn(bool, usize) -> Result<Trace, Refused>,
    allowed: Allowed,
) -> bool {
    let [original, edited] = traces;
    let [before, after] = [original, edited].map(|trace| trace.restarts().count());
    before != after
        || (0..before).any(|number| match entered(false, number) {
            Ok(trace) => verdict(&trace, &entered(true, number), allowed) != Verdict::Harmless,
            Err(_) => false,
        })
}

fn at(event: &Event<'_>, why: &str) -> String {
    format!("line {}: {why}", event.block.line)
}

/// Name of what a block does.
#[must_use]
pub fn name_of(effect: &Effect) -> &'static str {
    match effect {
        Effect::Modal => "modal",
        Effect::Safety => "safety",
        Effect::Length(_) => "length",
        Effect::Spindle(_) => "spindle",
        Effect::Coolant { .. } => "coolant",
        Effect::ToolChange(_) => "tool",
        Effect::Guard { .. } => "guard",
        Effect::PlaneGuard { .. } => "plane guard",
        Effect::OffsetGuard => "offset guard",
        Effect::Dwell(_) => "dwell",
        Effect::Stop => "stop",
        Effect::OptionalStop => "optional stop",
        Effect::End => "end",
        Effect::Rapid => "rapid",
        Effect::Feed => "feed",
        Effect::Arc(_) => "arc",
        Effect::Hole(_) => "hole",
        Effect::Machine => "machine",
        Effect::Orient => "orient",
        Effect::Home(_) => "home",
        Effect::Shop(_) => "shop",
    }
}
