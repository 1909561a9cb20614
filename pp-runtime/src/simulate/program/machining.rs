//! The executed program cuts the stock: motions into swept pieces, contacts into findings.
//!
//! A motion is divided until it is straight and even within [`PATH_MM`], by certified bounds. A rapid whose axes move
//! each on its own may be anywhere in the box of their values: the box is compared with the stock and removes nothing,
//! then the straight path is removed, so that one contact is one finding. At rapid, with the spindle off, and for shank
//! and holder the tool is taken smaller by [`TOUCH_MM`]: it may slide along what it has cut.

use super::outcome::{Contacting, EPS_MM, FoundContact, SimulationOutcome, Size, TOUCH_MM, What};
use super::recording::Recording;
use super::set_ups::{PartPlaces, moved};
use crate::check::read::SideOfPath;
use crate::check::{CheckPolicy, ExecutedBlock, angle_between};
use crate::kinematics::{AxisKind, Pose, StepBound};
use crate::simulate::removal::{LARGEST_TURN, SweptPiece, TriDexel};
use crate::simulate::tools::{ToolBodies, ToolBody};
use crate::view::{ExecutedMotion, ExecutedPlace};

/// Largest deviation of a piece from the executed path, mm.
pub(crate) const PATH_MM: f64 = 3e-3;

/// Pieces that are cut at once: 0.5 MB, and as much again for each family of lines.
const CHUNK: usize = 1024;

/// Halvings of a motion.
pub(super) const MOST_HALVINGS: u32 = 16;

/// Largest distance of the lines by which the box of a rapid is covered, mm, and their largest number along an axis.
const BOX_STEP_MM: f64 = 0.5;
const MOST_BOX_LINES: f64 = 24.0;

/// Largest angle between neighbouring places of a motion, rad: rotations of more are not seen from their ends.
const LARGEST_STEP_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// What a piece belongs to.
#[derive(Debug, Clone, Copy)]
struct Owner {
    what: Contacting,
    line: u64,
    cl_line: u64,
    operation: u64,
    tool: u32,
    /// Time at feed, min.
    minutes: f64,
}

/// The stock while a program is executed.
pub(crate) struct Machining<'a> {
    policy: &'a CheckPolicy,
    tools: ToolBodies,
    stock: TriDexel,
    threads: usize,
    pieces: Vec<SweptPiece>,
    owners: Vec<Owner>,
    /// Number of times that the stock has been cut or moved.
    pub(super) flushes: u64,
    places: PartPlaces,
    /// Set-up in which the stock lies.
    set_up: u32,
    recording: Option<Recording>,
    pub(super) outcome: SimulationOutcome,
}

/// What a program has left.
pub(crate) struct Machined {
    pub(crate) outcome: SimulationOutcome,
    pub(crate) stock: TriDexel,
    /// Set-up in which it lies.
    pub(crate) set_up: u32,
    pub(crate) recording: Option<Recording>,
}

impl<'a> Machining<'a> {
    pub(crate) fn new(
        policy: &'a CheckPolicy,
        tools: ToolBodies,
        stock: TriDexel,
        places: PartPlaces,
        threads: usize,
    ) -> Self {
        let outcome = SimulationOutcome::new(&tools);
        Self {
            policy,
            tools,
            stock,
            threads,
            pieces: Vec::new(),
            owners: Vec::new(),
            flushes: 0,
            places,
            set_up: 1,
            recording: None,
            outcome,
        }
    }

    /// This machining with the removal kept for a page.
    pub(crate) fn recorded(self) -> Self {
        Self { recording: Some(Recording::of(&self.stock, self.set_up)), ..self }
    }

    /// Clamps the stock as the part lies in a set-up; returns whether it is known there, and elsewhere than before.
    pub(super) fn clamp(&mut self, set_up: u32) -> bool {
        if self.set_up == set_up {
            return false;
        }
        let Some(place) = self.places.between(self.set_up, set_up) else { return false };
        self.flush();
        match moved(&self.stock, &place) {
            Ok(stock) => {
                (self.stock, self.set_up) = (stock, set_up);
                if let Some(recording) = &mut self.recording {
                    recording.clamp(set_up, |stock| moved(stock, &place).ok());
                }
                self.flushes += 1;
                true
            }
            Err(fault) => {
                // Stated once, and the motions of this set-up are counted as those of an unknown place.
                self.places.forget(set_up);
                self.outcome.leave_out(format!("set-up {set_up}: {fault}"));
                false
            }
        }
    }

    /// Set-up in which the stock lies.
    pub(super) fn set_up(&self) -> u32 {
        self.set_up
    }

    /// Cuts what is left to be cut.
    pub(crate) fn finish(mut self) -> Machined {
        self.flush();
        self.outcome.uncertified = self.stock.effort().uncertified;
        let Self { outcome, stock, set_up, recording, .. } = self;
        Machined { outcome, stock, set_up, recording }
    }

    /// Cuts what has been swept so far.
    pub(super) fn flush(&mut self) {
        if self.pieces.is_empty() {
            return;
        }
        self.flushes += 1;
        let contacts = self.stock.cut(&self.pieces, &self.tools.profiles, EPS_MM, self.threads);
        if let Some(recording) = &mut self.recording {
            recording.cut(&self.pieces, &self.tools.profiles, self.threads);
        }
        for (contact, owner) in contacts.iter().zip(&self.owners) {
            if owner.what == Contacting::Cut {
                let Owner { operation, tool, line, minutes, .. } = *owner;
                self.outcome.engagement.add(operation, tool, line, minutes, contact.volume());
            } else if contact.longest > 0.0 {
                self.outcome.add(FoundContact {
                    what: What::Stock(owner.what),
                    lines: [owner.line; 2],
                    cl_line: owner.cl_line,
                    operation: owner.operation,
                    tool: owner.tool,
                    size: Size::Cut { volume_mm3: contact.volume(), longest_mm: contact.longest },
                    place_mm: contact.place,
                    axes: Vec::new(),
                });
            }
        }
        self.pieces.clear();
        self.owners.clear();
    }

    /// Adds the motion of some profiles between two poses.
    fn sweep(&mut self, profiles: &[u32], [from, to]: [&Pose; 2], grow: f64, test: bool, owner: Owner) {
        for profile in profiles {
            let piece = SweptPiece::new(from, to, *profile, owner.line.min(u64::from(u32::MAX)) as u32).grown(grow);
            self.pieces.push(if test { piece.touching() } else { piece });
            self.owners.push(owner);
        }
    }

    /// A motion whose start or end is unknown.
    pub(super) fn unknown(&mut self) {
        *self.outcome.unknown.entry("whose start or end is unknown").or_default() += 1;
    }

    /// The stock as far as it has been cut.
    pub(super) fn stock(&self) -> &TriDexel {
        &self.stock
    }

    /// Sweeps the stock with the tool of a motion. `places`: positions between which nothing rotates far.
    pub(super) fn motion(&mut self, motion: &ExecutedMotion<'_>, places: &[(f64, ExecutedPlace)]) {
        let executed = motion.executed;
        self.outcome.motions += 1;
        let body = self.tools.bodies.get(&motion.tool()).filter(|body| !body.is_empty()).cloned();
        let compensated = executed.block.state.side.is_some_and(|side| side != SideOfPath::None);
        let unknown = match &body {
            _ if executed.set_up() != self.set_up => Some("in set-ups in which the place of the part is unknown"),
            None if motion.rapid => Some("at rapid without a tool of known shape"),
            None => Some("of tools without a shape"),
            Some(_) if compensated && !self.policy.shop.compensated_centre => Some("under cutter compensation"),
            Some(_) => None,
        };
        if let Some(reason) = unknown {
            *self.outcome.unknown.entry(reason).or_default() += 1;
            return;
        }
        let (Some(body), Some((_, end))) = (body, places.last()) else { return };
        let reach = self.reach(&body);
        if motion.rapid && !motion.together {
            self.boxed(motion, &body, reach, end);
        }
        if !motion.rapid {
            self.outcome.allow(executed.block.line, executed.allowance_mm);
        }
        let minutes = if motion.rapid { 0.0 } else { motion.minutes(length_mm(motion, places)).unwrap_or(0.0) };
        for pair in places.windows(2) {
            divide(motion, reach, [pair[0], pair[1]], MOST_HALVINGS, &mut |ends, deviation_mm| {
                self.part(motion, &body, ends, deviation_mm, minutes);
            });
        }
    }

    fn reach(&self, body: &ToolBody) -> f64 {
        let all = body.cutter.iter().chain(&body.shank).chain(&body.holder);
        all.map(|index| self.tools.profiles[*index as usize].reach).fold(0.0, f64::max)
    }

    /// Whether a motion within a distance of a point may meet the stock.
    fn is_near(&self, tip: &[f64; 3], distance: f64) -> bool {
        let [low, high] = self.stock.corners();
        (0..3).all(|axis| tip[axis] + distance >= low[axis] && tip[axis] - distance <= high[axis])
    }

    /// A straight part of a motion, with its deviation. `minutes`: time of the whole motion.
    fn part(
        &mut self,
        motion: &ExecutedMotion<'_>,
        body: &ToolBody,
        [from, to]: Ends<'_>,
        deviation_mm: f64,
        minutes: f64,
    ) {
        self.outcome.deviation_mm = self.outcome.deviation_mm.max(deviation_mm);
        let state = &motion.executed.block.state;
        let spins = matches!(state.spindle, Some(Some(_)));
        let what = match (motion.rapid, spins) {
            (true, _) => Contacting::Rapid,
            (false, true) => Contacting::Cut,
            (false, false) => Contacting::Still,
        };
        let minutes = minutes * (to.0 - from.0) / body.cutter.len().max(1) as f64;
        let owner = Owner { minutes, ..owner(motion, what) };
        let ends = [&from.1.pose, &to.1.pose];
        let grow = if what == Contacting::Cut { 0.0 } else { -TOUCH_MM };
        self.sweep(&body.cutter, ends, grow, false, owner);
        self.sweep(&body.shank, ends, -TOUCH_MM, false, Owner { what: Contacting::Shank, ..owner });
        self.sweep(&body.holder, ends, -TOUCH_MM, false, Owner { what: Contacting::Holder, ..owner });
        if self.pieces.len() >= CHUNK {
            self.flush();
        }
    }

    /// The box of a rapid in which each axis moves on its own.
    fn boxed(&mut self, motion: &ExecutedMotion<'_>, body: &ToolBody, reach: f64, end: &ExecutedPlace) {
        let (machine, start) = (motion.machine(), &motion.start);
        let mut ways = Vec::new();
        for (index, axis) in machine.axes().iter().enumerate() {
            let mut axes = start.axes;
            axes[index] = end.axes[index];
            if (axes[index] - start.axes[index]).abs() > 0.0 {
                if axis.kind == AxisKind::Rotary {
                    self.outcome.rotating_rapids += 1;
                    return;
                }
                ways.push(machine.forward_kinematics(&axes).tip - start.pose.tip);
            }
        }
        ways.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        let [longest, others @ ..] = ways.as_slice() else { return };
        let size: f64 = ways.iter().map(|way| way.norm()).sum();
        if others.is_empty() || !self.is_near(&start.pose.tip.into(), size + reach) {
            return;
        }
        let counts: Vec<f64> =
            others.iter().map(|way| (way.norm() / BOX_STEP_MM).ceil().clamp(1.0, MOST_BOX_LINES)).collect();
        let cells = others.iter().zip(&counts).map(|(way, count)| way.norm() / count);
        let half_diagonal = 0.5 * cells.map(|cell| cell * cell).sum::<f64>().sqrt();
        let lines: u64 = counts.iter().map(|count| *count as u64).product();
        let owner = owner(motion, Contacting::Rapid);
        for line in 0..lines {
            let mut rest = line;
            let mut from = start.pose;
            for (way, count) in others.iter().zip(&counts) {
                let at = rest % *count as u64;
                rest /= *count as u64;
                from.tip += way * ((at as f64 + 0.5) / count);
            }
            let to = Pose { tip: from.tip + longest, ..from };
            let grow = half_diagonal - TOUCH_MM;
            self.sweep(&body.cutter, [&from, &to], grow, true, owner);
            self.sweep(&body.shank, [&from, &to], grow, true, Owner { what: Contacting::Shank, ..owner });
            self.sweep(&body.holder, [&from, &to], grow, true, Owner { what: Contacting::Holder, ..owner });
        }
    }
}

/// The course of a motion with its certified bounds.
pub(super) trait CertifiedCourse {
    /// Position at a share; `near`: a position before it.
    fn at(&self, share: f64, near: &ExecutedPlace) -> ExecutedPlace;

    /// Deviation between two shares from the motion in step with it.
    fn step_bound(&self, shares: [f64; 2], places: [&ExecutedPlace; 2]) -> StepBound;
}

impl CertifiedCourse for ExecutedMotion<'_> {
    fn at(&self, share: f64, near: &ExecutedPlace) -> ExecutedPlace {
        Self::at(self, share, near)
    }

    fn step_bound(&self, shares: [f64; 2], places: [&ExecutedPlace; 2]) -> StepBound {
        Self::step_bound(self, shares, places)
    }
}

/// Share and place at both ends of a part.
pub(super) type Ends<'p> = [&'p (f64, ExecutedPlace); 2];

/// Divides a motion between two shares until its parts are straight and even within [`PATH_MM`] for points within
/// `reach` of the tip; `part` takes each of them with its deviation, mm.
pub(super) fn divide(
    course: &dyn CertifiedCourse,
    reach: f64,
    [from, to]: [(f64, ExecutedPlace); 2],
    halvings: u32,
    part: &mut dyn FnMut(Ends<'_>, f64),
) {
    let angle = angle_between(&from.1.pose.axis, &to.1.pose.axis);
    let bound = course.step_bound([from.0, to.0], [&from.1, &to.1]);
    let deviation_mm = bound.tip + bound.axis * reach;
    if (deviation_mm > PATH_MM || angle > 0.95 * LARGEST_TURN) && halvings > 0 {
        let share = f64::midpoint(from.0, to.0);
        let middle = (share, course.at(share, &from.1));
        divide(course, reach, [from, middle], halvings - 1, part);
        divide(course, reach, [middle, to], halvings - 1, part);
    } else {
        part([&from, &to], deviation_mm);
    }
}

fn owner(motion: &ExecutedMotion<'_>, what: Contacting) -> Owner {
    let ExecutedBlock { block, record, operation, .. } = motion.executed;
    Owner { what, line: block.line, cl_line: record.line, operation: *operation, tool: motion.tool(), minutes: 0.0 }
}

/// Length of the tip path, mm.
fn length_mm(motion: &ExecutedMotion<'_>, places: &[(f64, ExecutedPlace)]) -> f64 {
    // The chords of an arc are shorter.
    let parts = if motion.rotated > 0.02 { 8 } else { 1 };
    let of = |ends: &[(f64, ExecutedPlace)]| {
        let at = |part: u32| match part {
            0 => ends[0].1.pose.tip,
            part if part == parts => ends[1].1.pose.tip,
            part => {
                let share = ends[0].0 + (ends[1].0 - ends[0].0) * f64::from(part) / f64::from(parts);
                motion.at(share, &ends[0].1).pose.tip
            }
        };
        (0..parts).map(|part| (at(part + 1) - at(part)).norm()).sum::<f64>()
    };
    places.windows(2).map(of).sum()
}

/// Positions of a motion at shares of it, between which nothing rotates far.
pub(super) fn places(motion: &ExecutedMotion<'_>) -> Vec<(f64, ExecutedPlace)> {
    let pieces = (motion.rotated / LARGEST_STEP_RAD).ceil().max(1.0) as u32;
    let mut places = vec![(0.0, motion.start)];
    for piece in 1..=pieces {
        let (share, near) = (f64::from(piece) / f64::from(pieces), places[places.len() - 1].1);
        places.push((share, motion.at(share, &near)));
    }
    places
}
