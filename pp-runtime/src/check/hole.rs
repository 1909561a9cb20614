//! Holes: what the CL data wants of one, level by level, and a cycle of the control beside it.
//!
//! A program may make a hole by motions or by a cycle. Motions are compared one by one; a cycle is compared as a whole:
//! where it comes down to, how deep, where it ends, in which steps, how fast, how long it waits. How far out of the hole a
//! step leads on its way is the control's affair.

use std::io::Read;

use super::chain::Placed;
use super::compare::{Checker, Phase};
use super::expect::{Item, Kind};
use super::feed::Stroke;
use super::path::{angle_between, placed};
use super::read::{Action, Block, CycleKind, CycleMove, FeedMode, MAX_AXES};
use super::report::Shown;
use crate::kinematics::Pose;
use crate::program::{Drilling, Dwell, Feed, Hole, Move, Rotation};

/// Levels closer than this are the same, mm.
const SAME_LEVEL: f64 = 1e-9;

/// Tool axes of one hole and the next, rad.
const SAME_AXIS: f64 = 1e-6;

/// Waits are written to a thousandth of a second.
const WAIT: f64 = 6e-4;

/// A pitch may be off by this share of it: 4 µm in a thread 20 mm long.
const PITCH: f64 = 2e-4;

/// More steps than this are no drilling: the planner refuses them.
const MOST_STEPS: usize = 10_000;

/// A hole that is expected.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    /// Counts holes: its motions have the same number.
    pub(super) number: u64,
    pub(super) hole: Hole,
}

/// One step of a hole by motions.
pub(super) enum Step {
    Go(Move),
    Wait(Dwell),
}

/// The motions of a hole from where the tool stands.
pub(super) fn unfolded(hole: &Hole, here: Option<&Pose>, peck_gap: f64) -> Vec<Step> {
    let (top, axis) = (hole.top.tip, hole.top.axis);
    let level = |height: f64| Pose { tip: top + axis.into_inner() * height, axis };
    let go = |pose: Pose, rapid: bool| Step::Go(Move { pose, rapid, feed: hole.feed });
    let mut steps = Vec::new();
    let same_axis = here.filter(|here| angle_between(&here.axis, &axis) <= SAME_AXIS);
    if let Some(here) = same_axis {
        let height = (here.tip - top).dot(&axis);
        let lift = hole.clearance_mm - height;
        if lift > SAME_LEVEL {
            steps.push(go(Pose { tip: here.tip + axis.into_inner() * lift, axis }, true));
        }
        let over = level(height.max(hole.clearance_mm));
        if (over.tip - here.tip).norm() > SAME_LEVEL {
            steps.push(go(over, true));
        }
    }
    steps.push(go(level(hole.clearance_mm), true));
    let (first, later) = match hole.drilling {
        Drilling::Peck { first_mm: first, later_mm: later } => (first, later),
        Drilling::ChipBreak { step_mm: step, .. } => (step, step),
        Drilling::Drill | Drilling::Ream | Drilling::Tap { .. } => (hole.depth_mm, hole.depth_mm),
    };
    let mut depth = first.min(hole.depth_mm);
    for _ in 0..MOST_STEPS {
        if depth > hole.depth_mm - SAME_LEVEL {
            depth = hole.depth_mm;
        }
        steps.push(go(level(-depth), false));
        if depth >= hole.depth_mm {
            break;
        }
        if matches!(hole.drilling, Drilling::Peck { .. }) {
            steps.push(go(level(hole.clearance_mm), true));
        }
        let back = match hole.drilling {
            Drilling::ChipBreak { retract_mm: Some(back), .. } => back,
            _ => peck_gap,
        };
        steps.push(go(level((back - depth).min(hole.clearance_mm)), true));
        depth += later;
    }
    steps.extend(hole.dwell.map(Step::Wait));
    if matches!(hole.drilling, Drilling::Ream | Drilling::Tap { .. }) {
        steps.push(go(level(hole.clearance_mm), false));
    }
    steps.push(go(level(hole.return_mm), true));
    steps
}

impl<R: Read> Checker<'_, R> {
    /// A hole by a cycle of the control.
    pub(super) fn cycle(&mut self, block: &Block, cycle: &CycleMove, shown: Shown<'_>) -> std::io::Result<()> {
        self.expect.fill(2)?;
        while self.needless(0) && self.is_last_of_hole() {
            self.pass();
            self.expect.fill(2)?;
        }
        if let Some(count) = self.holes_lost(block, cycle)? {
            self.skip(count, shown);
        }
        let front = self
            .expect
            .get(0)
            .and_then(|item| Some((item.hole?, item.wanted, matches!(item.kind, Kind::Motion(m) if m.starts))));
        let ends = |checker: &Self, level: f64| checker.at_level(block, level);
        let Some((wanted, state, starts)) = front else {
            self.found(shown, "cycle, but the CL data has no hole here");
            self.here = ends(self, cycle.back_to);
            return Ok(());
        };
        if !matches!(self.phase, Phase::Path) || (starts && !self.approached) {
            self.found(shown, "cycle without an approach before it");
            self.phase = Phase::Path;
        }
        self.state_at_path(block, &state, shown);
        let hole = wanted.hole;
        let placed_at = |height: f64| {
            placed(&Pose { tip: hole.top.tip + hole.top.axis.into_inner() * height, axis: hole.top.axis })
        };
        let levels =
            [("clearance point", cycle.reference, hole.clearance_mm), ("bottom", cycle.bottom, -hole.depth_mm)];
        for (what, level, height) in levels {
            self.level_is(block, level, (&placed_at(height), height - hole.clearance_mm), what, shown);
        }
        // A thread that only goes in and out leaves the way up to a motion.
        let (back, clearance) = (placed_at(hole.return_mm), placed_at(hole.clearance_mm));
        let end = ends(self, cycle.back_to);
        let short = matches!(cycle.kind, CycleKind::Tap(_) | CycleKind::FloatingTap(_))
            && end.is_some_and(|end| self.is_at(&end, &clearance));
        let stays = short && hole.return_mm - hole.clearance_mm > SAME_LEVEL;
        let (back, above) = if stays { (clearance, 0.0) } else { (back, hole.return_mm - hole.clearance_mm) };
        self.level_is(block, cycle.back_to, (&back, above), "return point", shown);
        self.kind_is(cycle, &hole, state.spindle, shown);
        self.cycle_feed_is(block, cycle, &hole, state.spindle.map(|(speed, _)| speed), shown);
        self.cycle_wait_is(cycle, &hole, state.spindle.map(|(speed, _)| speed), shown);
        self.finish_hole(wanted.number, stays)?;
        self.led_out = (back.tip - placed_at(-hole.depth_mm).tip).dot(&back.axis);
        self.out_from = Some(back);
        self.reached = Some(back);
        self.here = end.or(Some(back));
        self.lost = false;
        Ok(())
    }

    /// How many items lie in front of the hole that a cycle makes, if that is not the next one.
    fn holes_lost(&mut self, block: &Block, cycle: &CycleMove) -> std::io::Result<Option<usize>> {
        let Some(at) = self.at_level(block, cycle.reference) else { return Ok(None) };
        let largest = self.slack.tip;
        let makes = |item: &Item| {
            item.hole.is_some_and(|Wanted { hole, .. }| {
                let axis = hole.top.axis.into_inner();
                let step = at.tip - hole.top.tip.coords;
                (step - axis * step.dot(&axis)).norm() <= largest && angle_between(&at.axis, &axis) <= self.slack.axis
            })
        };
        if self.expect.get(0).is_some_and(makes) {
            return Ok(None);
        }
        Ok(self.expect.ahead()?.iter().position(makes))
    }

    /// A cycle goes back to the level where it began: over its hole the tool comes to that level first, and down again to
    /// a thread by a motion; `false` if the block does something else.
    pub(super) fn lifts_for_cycle(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) -> bool {
        let Some(Item { wanted, hole: Some(front), kind: Kind::Motion(next), .. }) = self.expect.get(0) else {
            return false;
        };
        let (wanted, hole, next) = (*wanted, front.hole, *next);
        let cuts = !next.rapid;
        let (top, axis) = (hole.top.tip.coords, hole.top.axis.into_inner());
        let at = |height: f64| self.is_at(end, &Placed { tip: top + axis * height, axis });
        let over = self.here.is_some_and(|here| {
            let height = (here.tip - top).dot(&axis);
            height >= hole.clearance_mm - self.slack.tip
                && (here.tip - top - axis * height).norm() <= 2.0 * self.slack.tip
        });
        let asked = self.is_at(end, &next.to);
        let lifts = over && (at(hole.return_mm) && !asked || cuts && at(hole.clearance_mm));
        if lifts {
            self.state_at_path(block, &wanted, shown);
            if block.action == Action::Rapid {
                self.turned_at_part(block, shown);
            }
        }
        lifts
    }

    /// What comes next belongs to no hole, or nothing else of its hole is left.
    fn is_last_of_hole(&self) -> bool {
        let number = |index: usize| self.expect.get(index).and_then(|item| item.hole).map(|hole| hole.number);
        number(0).is_none() || number(0) != number(1)
    }

    /// Where the tool is at a level of a cycle.
    fn at_level(&self, block: &Block, level: f64) -> Option<Placed> {
        Some(self.words.place(&self.words_at(block, level)?, &block.state))
    }

    fn words_at(&self, block: &Block, level: f64) -> Option<[f64; MAX_AXES]> {
        let normal = block.state.plane?.axes()[2];
        let mut values = block.values;
        values[self.words.linear_places()[normal]?] = level;
        Some(values)
    }

    /// A level of a cycle, and how far above its clearance level it is: that is where its words say the place of the hole, and
    /// the tool axis that the rounded angles give leads elsewhere by as much as it is off.
    fn level_is(&mut self, block: &Block, level: f64, wanted: (&Placed, f64), what: &str, shown: Shown<'_>) {
        let (wanted, above) = wanted;
        let Some(values) = self.words_at(block, level) else {
            return self.found(shown, "cycle without a known working plane");
        };
        let at = self.words.place(&values, &block.state);
        let turn = angle_between(&at.axis, &wanted.axis);
        let largest = self.slack.tip + above.abs() * turn;
        let off = (at.tip - wanted.tip).norm();
        if off > largest || turn > self.axis_slack(&wanted.axis) {
            self.found(shown, &format!("{what} of the cycle is {off:.4} mm from that of the CL data"));
        }
        let outcome = &mut self.tally.outcome;
        outcome.tip_mm = outcome.tip_mm.max((at.tip - wanted.tip).norm());
        self.limits(&Block { values, ..block.clone() }, shown);
    }

    /// Whether it is made as the CL data has it.
    fn kind_is(&mut self, cycle: &CycleMove, hole: &Hole, spindle: Option<(f64, Rotation)>, shown: Shown<'_>) {
        let unit = self.slack.unit;
        let same = match (cycle.kind, hole.drilling) {
            (CycleKind::Drill, Drilling::Drill) | (CycleKind::Ream, Drilling::Ream) => true,
            // A step that is no shorter than the hole.
            (CycleKind::Drill, Drilling::Peck { first_mm: step, .. } | Drilling::ChipBreak { step_mm: step, .. }) => {
                step + unit >= hole.depth_mm
            }
            (CycleKind::Peck(step), Drilling::Peck { first_mm: first, later_mm: later }) => {
                (step - later).abs() <= unit && (step - first).abs() <= unit
            }
            (CycleKind::ChipBreak(wanted), Drilling::ChipBreak { step_mm: step, .. }) => (step - wanted).abs() <= unit,
            (CycleKind::Tap(pitch) | CycleKind::FloatingTap(pitch), Drilling::Tap { pitch_mm: stated }) => {
                let left = matches!(spindle, Some((_, Rotation::CounterClockwise)));
                let wanted = stated.or_else(|| per_turn(hole.feed, spindle.map(|(speed, _)| speed)));
                wanted.is_some_and(|wanted| (pitch.abs() - wanted).abs() <= PITCH * wanted) && (pitch < 0.0) == left
            }
            _ => false,
        };
        if !same {
            let text = format!("the cycle makes {}, expected {}", cycle.kind, made(hole));
            self.found(shown, &text);
        }
    }

    fn cycle_feed_is(&mut self, block: &Block, cycle: &CycleMove, hole: &Hole, speed: Option<f64>, shown: Shown<'_>) {
        // The pitch of a thread has been compared.
        if matches!(cycle.kind, CycleKind::Tap(_) | CycleKind::FloatingTap(_)) {
            return;
        }
        let mut state = block.state;
        if let Some(feed) = cycle.feed {
            (state.feed, state.feed_mode) = (Some(feed), Some(FeedMode::PerMinute));
        }
        let (Some(from), Some(to)) = (self.words_at(block, cycle.reference), self.words_at(block, cycle.bottom)) else {
            return;
        };
        let (from, to) = (self.words.values(&from), self.words.values(&to));
        let stroke = Stroke {
            length: hole.clearance_mm + hole.depth_mm,
            change: std::array::from_fn(|index| to[index] - from[index]),
            feed: hole.feed,
            speed,
        };
        if let Some(text) = self.law.wrong(&stroke, &state) {
            self.found(shown, &text);
        }
    }

    fn cycle_wait_is(&mut self, cycle: &CycleMove, hole: &Hole, speed: Option<f64>, shown: Shown<'_>) {
        let seconds = match (hole.dwell, speed) {
            (Some(Dwell::Seconds(seconds)), _) => seconds,
            (Some(Dwell::Revolutions(turns)), Some(speed)) => turns / speed * 60.0,
            (Some(Dwell::Revolutions(_)), None) | (None, _) => 0.0,
        };
        if (cycle.dwell - seconds).abs() > WAIT {
            self.found(shown, &format!("the cycle dwells for {} s at the bottom, expected {seconds} s", cycle.dwell));
        }
    }

    /// What belongs to the hole is done, but for a way up that is left to a motion.
    fn finish_hole(&mut self, number: u64, stays: bool) -> std::io::Result<()> {
        let belongs = |item: Option<&Item>| item.and_then(|item| item.hole).is_some_and(|hole| hole.number == number);
        loop {
            self.expect.fill(2)?;
            if !belongs(self.expect.get(0)) || (stays && !belongs(self.expect.get(1))) {
                return Ok(());
            }
            self.pass();
        }
    }
}

/// A hole of the CL data as the words of a cycle have it.
fn made(hole: &Hole) -> CycleKind {
    match hole.drilling {
        Drilling::Drill => CycleKind::Drill,
        Drilling::Ream => CycleKind::Ream,
        Drilling::Peck { later_mm: later, .. } => CycleKind::Peck(later),
        Drilling::ChipBreak { step_mm: step, .. } => CycleKind::ChipBreak(step),
        Drilling::Tap { pitch_mm: pitch } => CycleKind::Tap(pitch.unwrap_or(0.0)),
    }
}

/// mm in a turn.
fn per_turn(feed: Option<Feed>, speed: Option<f64>) -> Option<f64> {
    match feed? {
        Feed::PerRevolution(pitch) => Some(pitch),
        Feed::PerMinute(feed) => speed.map(|speed| feed / speed),
    }
}
