//! Rapids of the CL data at the part: links, which rotate the tool without a retract, and rapids in steps.

use super::super::policy::RapidForm;
use super::super::read::{Block, MAX_AXES};
use super::super::rules::{RotatingRapid, Rules};
use super::phase::RapidSteps;
use crate::kinematics::Axis;

/// Part of a rapid of the CL data that a block carries out.
#[derive(Debug, Clone, Copy)]
pub(super) struct RapidPart {
    /// A block before it has carried out another part.
    pub(crate) begun: bool,
    /// The rapid ends with it.
    pub(crate) ends: bool,
    /// It is the motion down from an approach point.
    pub(crate) approaches: bool,
    /// It belongs to a thread.
    pub(crate) in_thread: bool,
    /// It belongs to a hole.
    pub(crate) in_hole: bool,
    /// It ends with the rotary axes elsewhere than the rapid begins.
    pub(crate) rotates: bool,
}

/// Rules of a block that carries out a part of a motion at the part.
#[derive(Debug, Clone, Copy)]
pub(super) struct RapidRules {
    /// It is a feed motion.
    pub(crate) expects_feed: bool,
    /// It keeps to the path of the CL data.
    pub(crate) follows_path: bool,
    /// It is a rapid that rotates the tool, without a retract.
    pub(crate) link: bool,
    /// The rapid must be a safe sequence.
    pub(crate) lacks_retract: bool,
}

impl RapidRules {
    /// Rules of a feed motion of the CL data.
    pub(super) const CUT: Self = Self { expects_feed: true, follows_path: true, link: false, lacks_retract: false };

    /// Rules of a part of a rapid.
    pub(super) fn of(rules: &Rules<'_>, block: &Block, rapid: RapidPart) -> Self {
        let rotates = rapid.rotates;
        let at_feed = !block.action.is_rapid();
        let (form, all_at_feed) = (rules.link_form(), rules.policy().links.rapid == RapidForm::Feed);
        if rapid.approaches {
            // The approach to a hole ends above it, and its own motions begin there.
            let expects_feed = all_at_feed && rapid.in_hole && (at_feed || !rapid.in_thread);
            return Self { expects_feed, follows_path: expects_feed, link: false, lacks_retract: rotates };
        }
        let link = rapid.begun || !rapid.ends || rotates;
        let expects_feed = match form {
            // What the axes cannot follow is one rapid.
            RotatingRapid::OneRapid if rotates => all_at_feed && at_feed,
            RotatingRapid::Feed if !all_at_feed => at_feed && link,
            _ => all_at_feed && (at_feed || !rapid.in_thread),
        };
        Self {
            expects_feed,
            follows_path: at_feed || form == RotatingRapid::Rapids && link,
            link,
            lacks_retract: rotates && (form == RotatingRapid::None || form == RotatingRapid::Feed && !at_feed),
        }
    }
}

/// Largest rotation of an axis that takes the shorter way, rad.
pub(super) fn rollover_travel(rules: &Rules<'_>, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> f64 {
    let rollover = &rules.policy().words.rollover;
    let rolls = |(_, axis): &(usize, &Axis)| rollover.contains_key(&axis.letter);
    let travel = |(index, _): (usize, &Axis)| (to[index] - from[index]).abs();
    rules.axes().iter().enumerate().filter(rolls).map(travel).fold(0.0, f64::max)
}

/// Whether the last step of a rapid is between its start and some words, on the line of both, apart from one unit.
pub(super) fn is_on_line(rules: &Rules<'_>, steps: &RapidSteps, to: &[f64; MAX_AXES]) -> bool {
    let RapidSteps { start, last } = steps;
    let travel = |index: usize| to[index] - start[index];
    let farthest = rules.words().rotary().max_by(|a, b| travel(*a).abs().total_cmp(&travel(*b).abs()));
    let Some(farthest) = farthest.filter(|index| travel(*index).abs() > 0.0) else { return false };
    let share = (last[farthest] - start[farthest]) / travel(farthest);
    let rotary = rules.words().rotary_bits();
    (0.0..=1.0).contains(&share)
        && (0..MAX_AXES).all(|index| {
            let unit = if rotary & (1 << index) != 0 { rules.rounding().unit_rad } else { rules.rounding().unit_mm };
            (start[index] + share * travel(index) - last[index]).abs() <= 1.01 * unit
        })
}
