//! Holes: by a cycle of the control where it means the same, else level by level.
//!
//! However it is made, the tool goes over to a hole at its own level or at the clearance level, whichever is higher, comes
//! down along its axis, and ends at the level where the CL data wants it. A cycle is used where the tool axis is Z of the
//! program and the control has a cycle for just these steps; what it cannot say (a first step unlike the others, a stated
//! way back) is written as motions. A thread is never: spindle and feed are in step only in a cycle.

use super::options::{CycleOutput, Mode};
use crate::kinematics::{Machine, Pose};
use crate::nc::Decimal;
use crate::program::{Drilling, Dwell, Feed as Programmed, Hole, Location, Move, Rotation};

use super::account::Why;
use super::fault::Fault;
use super::feed::{Feeds, Stroke};
use super::place::Place;
use super::planner::{Phase, Planned, Planner, Stop, stop};
use super::step::{Feed, Sink, Step, Words};

/// More steps than this are no drilling.
const MOST_STEPS: u32 = 10_000;

/// Levels closer than this are the same, mm.
const SAME_LEVEL: f64 = 1e-9;

/// What a pitch may be off by its rounding, of the whole: 4 µm in a thread 20 mm long.
const PITCH: f64 = 2e-4;

/// What F of a thread may be off pitch times speed by its rounding, of the whole.
const THREAD_FEED: f64 = 1e-4;

/// Cycles of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct CycleAbilities {
    /// In and out, with a wait at the bottom or without.
    pub drill: bool,
    /// With a retreat to the clearance level after each step.
    pub peck: bool,
    /// With a short retreat after each step, as far as the control is set to.
    pub chip_break: bool,
    /// Out at feed.
    pub ream: bool,
    /// Out at feed to the clearance level, and at rapid from there to a higher one.
    pub ream_higher: bool,
    /// With spindle and feed in step.
    pub tap: bool,
    /// With a wait at the bottom of a thread.
    pub tap_dwell: bool,
    /// With a wait at the bottom of a hole in steps.
    pub steps_dwell: bool,
    /// Longest wait, milliseconds.
    pub longest_dwell: u32,
    /// It comes back to any level, wherever it began.
    pub own_return: bool,
    /// It is told how far to go back between two steps, and how near to come again.
    pub states_gap: bool,
    /// It shares out what is left for the last two steps: only whole steps are what they are.
    pub whole_steps: bool,
    /// The spindle stands behind a thread.
    pub tap_stops: bool,
    /// A thread is cut with F.
    pub tap_feed: bool,
    /// Decimals of a pitch.
    pub pitch_decimals: u32,
}

impl CycleAbilities {
    /// Of a control whose cycles are codes with X Y Z R: they begin at the level to which they go back, and their short
    /// retreats are settings of the machine.
    pub const CODES: Self = Self {
        drill: true,
        peck: true,
        chip_break: true,
        ream: true,
        ream_higher: false,
        tap: true,
        tap_dwell: false,
        steps_dwell: false,
        longest_dwell: u32::MAX,
        own_return: false,
        states_gap: false,
        whole_steps: false,
        tap_stops: false,
        tap_feed: false,
        pitch_decimals: 6,
    };
}

/// What a cycle does in a hole; lengths in whole units of linear words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleKind {
    /// In at feed, out at rapid.
    Drill,
    /// In steps, out to the clearance level after each.
    Peck {
        /// Depth of a step.
        step: i64,
        /// How near at rapid to where the last step ended.
        gap: i64,
    },
    /// In steps, a little back after each.
    ChipBreak {
        /// Depth of a step.
        step: i64,
        /// How far back.
        gap: i64,
    },
    /// In and out at feed.
    Ream,
    /// A thread.
    Tap {
        /// Units of length per turn.
        pitch: Decimal,
        /// Left-hand.
        left: bool,
        /// rev/min.
        speed: Decimal,
    },
}

/// A hole by a cycle along Z; levels are words of Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// What it does.
    pub kind: CycleKind,
    /// Where: X and Y.
    pub words: Words,
    /// Position of Z in the chain.
    pub z: usize,
    /// The top of the hole.
    pub surface: i64,
    /// Where feed begins.
    pub clearance: i64,
    /// The bottom.
    pub bottom: i64,
    /// Where the tool stands afterwards: at the clearance level, or higher where it stood before.
    pub back: i64,
    /// Wait at the bottom, seconds.
    pub dwell: Option<f64>,
    /// Units of the control's path per minute.
    pub feed: Decimal,
}

impl Cycle {
    /// Another hole of the same.
    pub(crate) fn repeats(&self, before: &Self) -> bool {
        Self { words: before.words, ..*self } == *before
    }
}

fn level(hole: &Hole, height: f64) -> Pose {
    Pose { tip: hole.top.tip + hole.top.axis.into_inner() * height, axis: hole.top.axis }
}

/// A cycle, and where the tool stands behind it.
type Found<A> = (Cycle, Place<A>);

/// Why there is no cycle.
type NoCycle = &'static str;

/// The boxes that the tip fills over a hole and in it, each its lowest and its highest corner, mm.
pub(crate) fn hole_extent(hole: &Hole) -> [[[f64; 3]; 2]; 2] {
    let between = |low: f64, high: f64| {
        let (a, b) = (level(hole, low).tip, level(hole, high).tip);
        [a.inf(&b).into(), a.sup(&b).into()]
    };
    [between(hole.clearance, hole.back_to), between(-hole.depth, 0.0)]
}

/// The depths at which the steps of a hole end, in their order.
fn steps(hole: &Hole) -> Result<impl Iterator<Item = f64>, Fault> {
    let (first, later) = match hole.drilling {
        Drilling::Peck { first, later } => (first, later),
        Drilling::ChipBreak { step, .. } => (step, step),
        Drilling::Drill | Drilling::Ream | Drilling::Tap { .. } => (hole.depth, hole.depth),
    };
    if (hole.depth - first) / later > f64::from(MOST_STEPS - 1) {
        let text = format!("a hole {} mm deep in steps of {later} mm takes more than {MOST_STEPS} steps", hole.depth);
        return Err(Fault::new(text).help("check the step of the cycle and its unit"));
    }
    let depth = hole.depth;
    // A last step of nothing but rounding is part of the one before.
    let reached = move |done: f64| if done > depth - SAME_LEVEL { depth } else { done };
    Ok(std::iter::successors(Some(reached(first)), move |done| (*done < depth).then(|| reached(done + later))))
}

impl<M: Machine> Planner<'_, M> {
    /// A hole, from wherever the tool stands.
    #[cold]
    pub(super) fn hole(&mut self, at: Location, hole: &Hole, sink: &mut impl Sink) -> Planned {
        let number = self.counted;
        self.counted += 1;
        let fault = |fault: Fault| stop(at, fault);
        let over = Move { pose: level(hole, hole.clearance), rapid: true, feed: hole.feed };
        let bottom = Move { pose: level(hole, -hole.depth), rapid: false, feed: hole.feed };
        if self.phase == Phase::Start {
            if self.unarmed()
                && let Err(missing) = self.check_state(&bottom)
            {
                return Err(fault(missing));
            }
            self.first(at, &over, number, sink)?;
        } else {
            self.settle(Some(&over), sink)?;
            if self.selection.over {
                return Ok(());
            }
            sink.serve(at, Why::Hole);
            self.reach_hole(at, hole, &over, number, sink)?;
        }
        self.settle(Some(&bottom), sink)?;
        if self.selection.over {
            return Ok(());
        }
        sink.serve(at, Why::Hole);
        self.check_state(&bottom).map_err(fault)?;
        match self.cycle(at, hole)? {
            Ok((cycle, back)) => self.run_cycle(at, hole, &cycle, back, sink),
            Err(why) if matches!(hole.drilling, Drilling::Tap { .. }) => {
                let text =
                    format!("a thread needs spindle and feed in step, which only a cycle of the control does: {why}");
                Err(fault(Fault::new(text).help("take the tapping out of the CL data and program it at the control")))
            }
            Err(_) => self.hole_by_motions(at, hole, sink),
        }
    }

    /// Turns the rotary axes for a hole; a tool that stands lower than its clearance level is lifted to it.
    fn reach_hole(&mut self, at: Location, hole: &Hole, over: &Move, number: u64, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        self.stop_spindle(sink)?;
        self.check_state(over).map_err(fault)?;
        let planned = self.changes(at, over, number, sink)?;
        let place = self.placer.place(&over.pose, &self.place, false, planned).map_err(fault)?;
        if self.placer.rotary_travel(&self.place.words, &place.words) > 0.0 {
            return self.go(at, over, planned, sink);
        }
        let lift = hole.clearance - self.height_over(hole);
        if lift > SAME_LEVEL {
            let tip = self.place.pose.tip + hole.top.axis.into_inner() * lift;
            return self.go(at, &Move { pose: Pose { tip, ..over.pose }, ..*over }, None, sink);
        }
        Ok(())
    }

    /// Height of the tool over the top of a hole, mm.
    fn height_over(&self, hole: &Hole) -> f64 {
        (self.place.pose.tip - hole.top.tip).dot(&hole.top.axis)
    }

    /// A rapid to a level of a hole.
    fn rapid_to_level(&mut self, at: Location, hole: &Hole, height: f64, sink: &mut impl Sink) -> Planned {
        self.go(at, &Move { pose: level(hole, height), rapid: true, feed: hole.feed }, None, sink)
    }

    /// A hole, level by level.
    fn hole_by_motions(&mut self, at: Location, hole: &Hole, sink: &mut impl Sink) -> Planned {
        let height = self.height_over(hole).max(hole.clearance);
        self.rapid_to_level(at, hole, height, sink)?;
        self.rapid_to_level(at, hole, hole.clearance, sink)?;
        let mut before: Option<f64> = None;
        for done in steps(hole).map_err(|fault| stop(at, fault))? {
            if let Some(before) = before {
                if matches!(hole.drilling, Drilling::Peck { .. }) {
                    self.rapid_to_level(at, hole, hole.clearance, sink)?;
                }
                let back = match hole.drilling {
                    Drilling::ChipBreak { back: Some(back), .. } => back,
                    _ => self.policy.options.defaults.peck_gap,
                };
                self.rapid_to_level(at, hole, (back - before).min(hole.clearance), sink)?;
            }
            let down = Move { pose: level(hole, -done), rapid: false, feed: hole.feed };
            self.go(at, &down, None, sink)?;
            before = Some(done);
        }
        if let Some(dwell) = hole.dwell {
            self.delay(at, dwell, sink)?;
        }
        if hole.drilling == Drilling::Ream {
            let out = Move { pose: level(hole, hole.clearance), rapid: false, feed: hole.feed };
            self.go(at, &out, None, sink)?;
        }
        self.rapid_to_level(at, hole, hole.back_to, sink)
    }

    /// The cycle of a hole and where it ends, or why there is none.
    fn cycle(&mut self, at: Location, hole: &Hole) -> Result<Result<Found<M::Axes>, NoCycle>, Stop> {
        let fault = |fault: Fault| stop(at, fault);
        if self.policy.options.cycles.output == CycleOutput::Expanded {
            return Ok(Err("`[cycles]` asks for motions"));
        }
        if self.policy.options.lift.is_some() {
            return Ok(Err("a dry run has no cycles"));
        }
        if self.policy.options.mode == Mode::Tcp {
            return Ok(Err("there are no cycles under tip control"));
        }
        let Some((chain, map)) = self.placer.square_map(&self.place) else {
            return Ok(Err("the program has no square coordinates here"));
        };
        let along = map * hole.top.axis.into_inner();
        let reach = hole.depth + hole.back_to.max(hole.clearance);
        if along.z < 0.0 || along.x.hypot(along.y) * reach > 0.5 * self.placer.unit_mm() {
            return Ok(Err("the tool axis is not Z of the program"));
        }
        let kind = match self.cycle_kind(hole).map_err(fault)? {
            Ok(kind) => kind,
            Err(why) => return Ok(Err(why)),
        };
        let here = self.place;
        let mut at_level = |height: f64| self.placer.shifted(level(hole, height).tip, &here).map_err(fault);
        let places = [at_level(hole.clearance)?, at_level(-hole.depth)?, at_level(hole.back_to)?];
        let surface = at_level(0.0)?;
        let surface = self.placer.written(&surface);
        let [clearance, bottom, back] = places.map(|place| self.placer.written(&place));
        let [x, y, z] = chain;
        if [x, y].iter().any(|&axis| clearance[axis] != bottom[axis]) {
            return Ok(Err("the hole is not along Z in the words of the program"));
        }
        let words = Words { units: clearance, mask: 1 << x | 1 << y, vector: None };
        let [surface, clearance, bottom, back] = [surface, clearance, bottom, back].map(|written| written[z]);
        let dwell = self.dwell_of(hole).map_err(fault)?;
        let feed = self.cycle_feed(hole, kind, &places).map_err(fault)?;
        let cycle = Cycle { kind, words, z, surface, clearance, bottom, back, dwell, feed };
        let unsaid = self.unsaid(hole, &cycle).map_err(fault)?;
        Ok(unsaid.map_or(Ok((cycle, places[2])), Err))
    }

    /// What the words of a cycle would say otherwise than the hole is.
    fn unsaid(&self, hole: &Hole, cycle: &Cycle) -> Result<Option<NoCycle>, Fault> {
        let can = self.abilities.cycles;
        if !(cycle.bottom < cycle.surface && cycle.surface <= cycle.clearance && cycle.clearance <= cycle.back) {
            return Ok(Some("its levels are not in their order"));
        }
        if cycle.dwell.is_some_and(|seconds| seconds * 1e3 > f64::from(can.longest_dwell)) {
            return Ok(Some("the wait is too long for it"));
        }
        if let CycleKind::Peck { step, gap } | CycleKind::ChipBreak { step, gap } = cycle.kind
            && can.states_gap
        {
            let depth = cycle.surface - cycle.bottom;
            let as_many = steps(hole)?.count() as i64 == (depth + step - 1) / step;
            let whole = !can.whole_steps || depth % step == 0;
            let in_hole = gap > 0 && gap <= step + cycle.clearance - cycle.surface;
            return Ok((!(as_many && whole && in_hole)).then_some("its steps are not those of this control"));
        }
        Ok(None)
    }

    /// What the control's cycle would be, or why it has none that means the same.
    fn cycle_kind(&self, hole: &Hole) -> Result<Result<CycleKind, NoCycle>, Fault> {
        let can = self.abilities.cycles;
        let higher = hole.back_to - hole.clearance > SAME_LEVEL;
        let units = |mm: f64| (mm / self.placer.unit_mm()).round() as i64;
        let no_dwell = hole.dwell.is_none();
        let steps_wait = no_dwell || can.steps_dwell;
        let usual_gap = self.policy.options.defaults.peck_gap;
        Ok(match hole.drilling {
            Drilling::Drill if can.drill => Ok(CycleKind::Drill),
            Drilling::Ream if can.ream && (can.ream_higher || !higher) => Ok(CycleKind::Ream),
            Drilling::Peck { first, later }
                if can.peck && steps_wait && units(first) == units(later) && units(later) > 0 =>
            {
                Ok(CycleKind::Peck { step: units(later), gap: units(usual_gap) })
            }
            Drilling::ChipBreak { step, back }
                if can.chip_break && steps_wait && units(step) > 0 && (can.states_gap || back.is_none()) =>
            {
                Ok(CycleKind::ChipBreak { step: units(step), gap: units(back.unwrap_or(usual_gap)) })
            }
            Drilling::Tap { .. } if !can.tap => Err("this control has none here"),
            Drilling::Tap { .. } if !no_dwell && !can.tap_dwell => {
                Err("that of this control does not wait at the bottom")
            }
            Drilling::Tap { pitch } => Ok(self.thread(hole, pitch)?),
            _ => Err("no cycle of this control does the same"),
        })
    }

    /// A thread at the speed as it is written.
    fn thread(&self, hole: &Hole, pitch: Option<f64>) -> Result<CycleKind, Fault> {
        let Some((turns, rotation)) = self.spindle else {
            return Err(Fault::new("a thread with the spindle off").help("give SPINDL/ON before it"));
        };
        let stated = match hole.feed {
            Some(Programmed::PerRevolution(pitch)) => Some(pitch),
            Some(Programmed::PerMinute(feed)) => Some(feed / turns),
            None => None,
        };
        let pitch = pitch.or(stated).filter(|pitch| *pitch > 0.0);
        let pitch = pitch.ok_or_else(|| {
            Fault::new("the pitch of this thread is not known").help("give the feed of the cycle per turn (MMPR, IPR)")
        })?;
        let too_large = |_| Fault::new("the pitch or the speed of this thread does not fit into a word");
        let exact = pitch / self.feeds.length_unit();
        let pitch = Decimal::fixed(exact, self.abilities.cycles.pitch_decimals).map_err(too_large)?;
        if (pitch.value() / exact - 1.0).abs() > PITCH {
            let fault = Fault::new(format_args!("the pitch of this thread, {exact}, has too many digits for a word"));
            return Err(fault.help("`output_units` of the drawing give a pitch that fits"));
        }
        Ok(CycleKind::Tap {
            pitch,
            left: rotation == Rotation::CounterClockwise,
            speed: Decimal::fixed(turns, self.policy.formats.speed).map_err(too_large)?,
        })
    }

    fn dwell_of(&self, hole: &Hole) -> Result<Option<f64>, Fault> {
        hole.dwell.map(|dwell| self.seconds(dwell)).transpose()
    }

    /// F of a cycle.
    fn cycle_feed(&self, hole: &Hole, kind: CycleKind, places: &[Place<M::Axes>; 3]) -> Result<Decimal, Fault> {
        let per_minute = match kind {
            CycleKind::Tap { pitch, speed, .. } => pitch.value() * self.feeds.length_unit() * speed.value(),
            _ => {
                let feed = hole.feed.ok_or_else(|| Fault::new("a hole without feed"))?;
                Feeds::per_minute(feed, self.spindle.map(|(speed, _)| speed))?
            }
        };
        let length = hole.clearance + hole.depth;
        let least = self.placer.least_minutes_of_tip(length, &places[0]);
        let stroke = Stroke { length, turn: 0.0, square: true, linear: length, degrees: 0.0, least };
        let pace = self.feeds.pace(per_minute, stroke)?;
        let Feed::PerMinute(word) = pace.feed else { return Err(Fault::new("a cycle has no feed in inverse time")) };
        if let CycleKind::Tap { .. } = kind
            && (pace.slowed > 0.0
                || self.abilities.cycles.tap_feed
                    && (self.feeds.mm_per_minute(word) / per_minute - 1.0).abs() > THREAD_FEED)
        {
            return Err(Fault::new(format_args!(
                "a thread needs a feed of {per_minute} mm/min, which cannot be written or is beyond an axis"
            ))
            .help("give another spindle speed"));
        }
        Ok(word)
    }

    /// Writes a hole by its cycle.
    fn run_cycle(
        &mut self,
        at: Location,
        hole: &Hole,
        cycle: &Cycle,
        back: Place<M::Axes>,
        sink: &mut impl Sink,
    ) -> Planned {
        let here = self.placer.written(&self.place);
        let height = self.height_over(hole).max(hole.clearance);
        self.watch_plunge(at, &level(hole, height), &level(hole, hole.clearance));
        if cycle.back != cycle.clearance && here[cycle.z] != cycle.back && !self.abilities.cycles.own_return {
            // Such a cycle goes back to where it began.
            self.rapid_to_level(at, hole, height, sink)?;
            self.rapid_to_level(at, hole, hole.back_to, sink)?;
        }
        self.cancel_inverse_time(sink)?;
        let minutes = (hole.clearance + hole.depth) / self.feeds.mm_per_minute(cycle.feed);
        let both_ways = matches!(cycle.kind, CycleKind::Ream | CycleKind::Tap { .. });
        self.times.cut(if both_ways { 2.0 * minutes } else { minutes });
        self.times.wait(cycle.dwell.unwrap_or(0.0) / 60.0);
        sink.serve(at, Why::Record);
        sink.stand(&self.standing(&back, None));
        sink.step(&Step::Cycle { cycle })?;
        self.statistics.cycles += 1;
        if let CycleKind::Tap { .. } = cycle.kind {
            self.tapped = self.abilities.cycles.tap_stops;
        }
        let bottom = level(hole, -hole.depth);
        self.cut(&bottom);
        self.retreat.reset();
        self.retreat.follow(&bottom, &back.pose);
        self.arrive(back);
        Ok(())
    }

    /// A dwell in seconds.
    pub(super) fn seconds(&self, dwell: Dwell) -> Result<f64, Fault> {
        match (dwell, self.spindle) {
            (Dwell::Seconds(seconds), _) => Ok(seconds),
            (Dwell::Revolutions(turns), Some((speed, _))) => Ok(turns / speed * 60.0),
            (Dwell::Revolutions(_), None) => {
                Err(Fault::new("a wait of some turns of the spindle, and the spindle does not turn")
                    .help("give SPINDL before it, or the wait in seconds"))
            }
        }
    }
}

#[cfg(test)]
mod tests;
