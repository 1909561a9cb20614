//! A program on its machine: each executed motion moves the bodies, and cuts the stock.

use super::machining::{Machined, Machining, places};
use super::outcome::{FoundContact, SimulationOutcome, Size, SmallestClearance, What};
use crate::check::CheckPolicy;
use crate::kinematics::{Axis, AxisKind, AxisRanges, AxisValues};
use crate::simulate::machine::{AxesInMotion, Clearances, Meeting, MovingBlock, Occasion, Share, stock_boxes};
use crate::view::{ExecutedMotion, ExecutedPlace, Motions};

/// The simulation of a program.
pub(crate) struct Simulation<'a> {
    policy: &'a CheckPolicy,
    axes: &'static [Axis],
    machining: Machining<'a>,
    clearances: Option<Clearances>,
    /// State of the stock for which boxes have been made.
    boxes_of: u64,
}

impl<'a> Simulation<'a> {
    pub(crate) fn new(
        policy: &'a CheckPolicy,
        axes: &'static [Axis],
        machining: Machining<'a>,
        clearances: Option<Clearances>,
    ) -> Self {
        Self { policy, axes, machining, clearances, boxes_of: 0 }
    }

    /// Cuts what is left to be cut.
    pub(crate) fn finish(self) -> Machined {
        let Self { policy, axes, machining, clearances, .. } = self;
        let mut machined = machining.finish();
        machined.outcome.found.sort_by_key(|found| found.lines[0]);
        if let Some(clearances) = &clearances {
            state(clearances, &mut machined.outcome, policy, axes);
        }
        machined
    }
}

/// States the distances of all pairs, and what took part.
fn state(clearances: &Clearances, outcome: &mut SimulationOutcome, policy: &CheckPolicy, axes: &[Axis]) {
    for (index, pair) in clearances.pairs().iter().enumerate() {
        let Some(smallest) = &pair.smallest else {
            outcome.far_pairs += 1;
            continue;
        };
        outcome.clearances.push(SmallestClearance {
            bodies: clearances.names(index).map(str::to_owned),
            distance_mm: smallest.distance_mm,
            line: smallest.at.line,
            cl_line: smallest.at.cl_line,
            tool: smallest.at.tool,
            place_mm: from_part(&smallest.at, policy),
            axes: positions(&smallest.at, policy, axes),
        });
    }
    outcome.clearances.sort_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
    clearances.taking_part().for_each(|name| outcome.take_part(name.to_owned()));
    for (tool, count) in &clearances.unknown_length {
        outcome.leave_out(format!("machine and fixtures in {count} motions of tool {tool}: its length is unknown"));
    }
    if clearances.not_certified > 0 {
        let text = "parts of motions in which distances of bodies are not certified";
        outcome.leave_out(format!("{} {text}", clearances.not_certified));
    }
}

/// A place of the table from the part zero of its set-up, mm.
fn from_part(at: &Occasion, policy: &CheckPolicy) -> [f64; 3] {
    let origin = policy.set_up.clamping(at.set_up).map_or([0.0; 3], |part| part.part_origin);
    std::array::from_fn(|axis| at.place_mm[axis] - origin[axis])
}

/// Positions of the axes: machine coordinates where they are known, else axis values; mm and degrees.
fn positions(at: &Occasion, policy: &CheckPolicy, axes: &[Axis]) -> Vec<(char, f64)> {
    let shown = |(axis, value): (&Axis, &f64)| match axis.kind {
        AxisKind::Rotary => (axis.letter, value.to_degrees()),
        AxisKind::Linear => (axis.letter, value + policy.set_up.machine_zero.get(&axis.letter).unwrap_or(&0.0)),
    };
    axes.iter().zip(&at.axes).filter(|(axis, _)| !axis.held).map(shown).collect()
}

/// The axis values of an executed motion.
struct AxesOf<'m>(&'m ExecutedMotion<'m>);

impl AxesInMotion for AxesOf<'_> {
    fn at(&self, share: f64, near: &AxisValues) -> AxisValues {
        self.0.axes_at(share, near)
    }

    fn ranges(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> Option<AxisRanges> {
        self.0.axis_ranges(shares, ends)
    }
}

impl Motions for Simulation<'_> {
    fn motion(&mut self, motion: &ExecutedMotion<'_>) -> ExecutedPlace {
        let places = places(motion);
        let set_up = motion.executed.set_up();
        if self.machining.clamp(set_up)
            && let Some(clearances) = &mut self.clearances
        {
            self.boxes_of = self.machining.flushes;
            clearances.clamp_stock(stock_boxes(&self.policy.set_up, set_up, self.machining.stock()), set_up);
        }
        if let Some(clearances) = &mut self.clearances {
            let (machining, boxes_of, set_up) = (&mut self.machining, &mut self.boxes_of, &self.policy.set_up);
            let mut boxes = || {
                machining.flush();
                let changed = *boxes_of != machining.flushes;
                *boxes_of = machining.flushes;
                changed.then(|| stock_boxes(set_up, machining.set_up(), machining.stock()))
            };
            let block = MovingBlock {
                line: motion.executed.block.line,
                cl_line: motion.executed.record.line,
                operation: motion.executed.operation,
                tool: motion.tool(),
                set_up: motion.executed.set_up(),
                offsets_mm: motion.placement.offsets_mm,
                apart: motion.rapid && !motion.together,
            };
            let shares: Vec<Share> = places.iter().map(|(share, place)| (*share, place.axes)).collect();
            let meetings = clearances.motion(block, &AxesOf(motion), &shares, &mut boxes);
            for Meeting { pair, least_mm, at } in meetings {
                let place_mm = from_part(&at, self.policy);
                let axes = positions(&at, self.policy, self.axes);
                self.machining.outcome.add(FoundContact {
                    what: What::Bodies(clearances.names(pair).map(str::to_owned)),
                    lines: [at.line; 2],
                    cl_line: at.cl_line,
                    operation: at.operation,
                    tool: at.tool,
                    size: Size::Apart(least_mm),
                    place_mm,
                    axes,
                });
            }
        }
        self.machining.motion(motion, &places);
        places.last().map_or(motion.start, |(_, place)| *place)
    }

    fn unknown(&mut self) {
        if let Some(clearances) = &mut self.clearances {
            clearances.lose();
        }
        self.machining.unknown();
    }
}
