//! Distances between the bodies of machine, fixtures, stock and tool while a program is executed: certified, not
//! sampled.
//!
//! Of each pair a distance at one position of the axes is kept. It is good for all positions at which the bodies have
//! moved against each other by less (`reach`). A motion that goes farther is measured again in its middle, and divided
//! there until every part is good, or so small that the distance in it is known to [`RESOLUTION_MM`].
//!
//! Where each axis moves on its own, the position is anywhere in the box of their values, which is divided in the same
//! manner.
//!
//! The distance that is certified is the clearance of the configuration. Beyond it the smallest distance of a pair is
//! searched for to a few percent, as far as [`SHOWN_MM`].

use std::collections::BTreeMap;

use nalgebra::Point3;

use super::body::{Body, Shapes};
use super::gap::{BodyGap, gap};
use super::links::MachineLinks;
use super::reach::Levers;
use crate::kinematics::{AxisRanges, AxisValues, MAX_AXES};

/// Part of a motion within which bodies move against each other by no more than this is not divided, mm.
const RESOLUTION_MM: f64 = 0.01;

/// Part of the box of a motion whose axes arrive in any order within which bodies move by no more than this is not
/// divided, mm.
const BOX_RESOLUTION_MM: f64 = 0.5;

/// Divisions of such a box, and halvings of a motion: at most.
const MOST_CELLS: u32 = 1500;
const MOST_HALVINGS: u32 = 24;

/// Smallest distances of pairs are searched for up to here, mm.
pub(crate) const SHOWN_MM: f64 = 20.0;

/// Distance beyond what is needed up to which surfaces are compared, mm: it is good for the motions that follow.
const RESERVE_MM: f64 = 10.0;

/// Part of the smallest distance, and a length, mm, to which it is found.
const FOUND_TO: f64 = 0.05;
const FOUND_TO_MM: f64 = 0.05;

/// Smallest distance of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Smallest {
    pub(crate) distance_mm: f64,
    pub(crate) at: Occasion,
}

/// When and where something happens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Occasion {
    /// Line of the program, and record.
    pub(crate) line: u64,
    pub(crate) cl_line: u64,
    pub(crate) operation: u64,
    pub(crate) tool: u32,
    /// Coordinates of the table.
    pub(crate) place_mm: [f64; 3],
    /// Axis values of the motion, with its part and tool.
    pub(crate) axes: AxisValues,
    pub(crate) set_up: u32,
}

/// Two bodies that meet, or are nearer than the clearance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Meeting {
    /// Number of the pair.
    pub(crate) pair: usize,
    /// Lower bound of their distance, mm; `None`: they meet.
    pub(crate) least_mm: Option<f64>,
    pub(crate) at: Occasion,
}

/// Two bodies on different links.
#[derive(Debug)]
pub(crate) struct BodyPair {
    /// The one nearer to the table first.
    pub(crate) bodies: [usize; 2],
    /// Links in whose coordinates they are compared. They are at rest there (`Body::rests`), and only the axes between
    /// move them against each other.
    links: [usize; 2],
    /// Its tool, if one of them is part of a tool.
    tool: Option<u32>,
    /// One of them is the stock.
    stock: bool,
    /// Distance at some position.
    known: Option<(Levers, f64)>,
    /// One may be inside the other: the position has been lost.
    fresh: bool,
    pub(crate) smallest: Option<Smallest>,
}

/// The material left of the stock as sets of boxes, each of which contains it; `None`: as before.
pub(crate) type StockBoxes<'s> = &'s mut dyn FnMut() -> Option<Vec<Vec<[[f64; 3]; 2]>>>;

/// All bodies and their distances.
pub(crate) struct Clearances {
    links: MachineLinks,
    bodies: Vec<Body>,
    pairs: Vec<BodyPair>,
    /// Number of the stock among the bodies.
    stock: Option<usize>,
    clearance_mm: f64,
    /// Tools whose length is known.
    tools: Vec<u32>,
    /// Parts of motions that are not certified.
    pub(crate) not_certified: u64,
    /// Motions of tools whose length is unknown, by tool.
    pub(crate) unknown_length: BTreeMap<u32, u64>,
}

/// A position at which a distance is measured.
#[derive(Debug, Clone, Copy)]
struct MeasuredAt<'v> {
    /// Axis values of the program.
    axes: &'v AxisValues,
    /// Axis values of the links.
    values: &'v AxisValues,
}

/// Outcome of a measurement for a part of a motion.
enum Verdict {
    /// Nothing more is to be found in it.
    Done,
    /// To be divided.
    Open,
}

/// Axis values in a motion.
pub(crate) trait AxesInMotion {
    /// At a share; `near`: values before it.
    fn at(&self, share: f64, near: &AxisValues) -> AxisValues;

    /// Certified smallest and largest values between two shares and the values there; `None`: the part must be divided.
    fn ranges(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> Option<AxisRanges>;
}

/// The block of a motion.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MovingBlock {
    /// Line of the program, and record.
    pub(crate) line: u64,
    pub(crate) cl_line: u64,
    pub(crate) operation: u64,
    pub(crate) tool: u32,
    pub(crate) set_up: u32,
    /// Machine coordinates of linear axes less value and `machine_zero`, mm.
    pub(crate) offsets_mm: AxisValues,
    /// Each axis moves on its own.
    pub(crate) apart: bool,
}

/// A motion with what does not change in it.
struct ConstantMotion<'m> {
    block: MovingBlock,
    axes: &'m dyn AxesInMotion,
    stock: StockBoxes<'m>,
    found: Vec<Meeting>,
}

/// A share of a motion and the axis values there.
pub(crate) type Share = (f64, AxisValues);

impl Clearances {
    /// `bodies` with the tool of those that are part of one; `stock`: number of the stock among them.
    pub(crate) fn new(
        links: MachineLinks,
        bodies: Vec<(Body, Option<u32>)>,
        stock: Option<usize>,
        allow: &[[String; 2]],
        clearance_mm: f64,
    ) -> Self {
        let tools: Vec<Option<u32>> = bodies.iter().map(|(_, tool)| *tool).collect();
        let mut bodies: Vec<Body> = bodies.into_iter().map(|(body, _)| body).collect();
        let mut rests = Vec::new();
        for body in &mut bodies {
            let (at_rest, added_mm) = body.rests(&links);
            body.tolerance_mm += added_mm;
            rests.push(at_rest);
        }
        let mut pairs = Vec::new();
        for one in 0..bodies.len() {
            for two in one + 1..bodies.len() {
                let [a, b] = [&bodies[one], &bodies[two]];
                let of_tools = tools[one].is_some() && tools[two].is_some();
                let cuts = stock
                    .is_some_and(|stock| stock == one && tools[two].is_some() || stock == two && tools[one].is_some());
                if a.link == b.link || of_tools || cuts || is_allowed(allow, a, b) {
                    continue;
                }
                let [first, second] = if a.link < b.link { [one, two] } else { [two, one] };
                // Each as far towards the other one as it is at rest.
                let from = rests[first][1].min(bodies[second].link);
                pairs.push(BodyPair {
                    bodies: [first, second],
                    links: [from, rests[second][0].max(from)],
                    tool: tools[one].or(tools[two]),
                    stock: stock.is_some_and(|stock| stock == one || stock == two),
                    known: None,
                    fresh: true,
                    smallest: None,
                });
            }
        }
        let mut lengths: Vec<u32> = tools.into_iter().flatten().chain([0]).collect();
        lengths.dedup();
        Self {
            links,
            bodies,
            pairs,
            stock,
            clearance_mm,
            tools: lengths,
            not_certified: 0,
            unknown_length: BTreeMap::new(),
        }
    }

    /// The pairs that are compared.
    pub(crate) fn pairs(&self) -> &[BodyPair] {
        &self.pairs
    }

    /// Names of a pair.
    pub(crate) fn names(&self, pair: usize) -> [&str; 2] {
        self.pairs[pair].bodies.map(|body| self.bodies[body].name.as_str())
    }

    /// Names of all bodies that take part, but for parts of tools.
    pub(crate) fn taking_part(&self) -> impl Iterator<Item = &str> {
        let in_pair = |index: usize| self.pairs.iter().any(|pair| pair.bodies.contains(&index));
        let of_tool = |index: usize| self.bodies[index].groups.iter().any(|group| group == TOOL);
        let taking = (0..self.bodies.len()).filter(move |index| in_pair(*index) && !of_tool(*index));
        taking.map(|index| self.bodies[index].name.as_str())
    }

    /// The stock is clamped as it is in a set-up.
    pub(crate) fn clamp_stock(&mut self, boxes: Vec<Vec<[[f64; 3]; 2]>>, set_up: u32) {
        if let Some(stock) = self.stock {
            self.set_stock(stock, boxes);
            self.bodies[stock].set_ups = vec![set_up];
            self.lose();
        }
    }

    /// The position of the machine is unknown.
    pub(crate) fn lose(&mut self) {
        self.pairs.iter_mut().for_each(|pair| pair.fresh = true);
    }

    /// Compares the bodies in a motion. `places`: positions between which nothing rotates far.
    pub(crate) fn motion(
        &mut self,
        block: MovingBlock,
        axes: &dyn AxesInMotion,
        places: &[Share],
        stock: StockBoxes<'_>,
    ) -> Vec<Meeting> {
        let MovingBlock { tool, set_up, .. } = block;
        if !self.tools.contains(&tool) {
            *self.unknown_length.entry(tool).or_default() += 1;
            self.lose();
            return Vec::new();
        }
        let there = |body: usize| {
            let set_ups = &self.bodies[body].set_ups;
            set_ups.is_empty() || set_ups.contains(&set_up)
        };
        let takes_part = |pair: &BodyPair| {
            pair.tool.is_none_or(|other| other == tool) && pair.bodies.iter().all(|body| there(*body))
        };
        let open: Vec<usize> = (0..self.pairs.len()).filter(|index| takes_part(&self.pairs[*index])).collect();
        let mut course = ConstantMotion { block, axes, stock, found: Vec::new() };
        if let ([(_, from), .., (_, to)], true) = (places, block.apart) {
            let ranges = self.moved(&course, &AxisRanges::between(from, to));
            open.into_iter().for_each(|pair| self.boxed(&mut course, pair, &ranges));
        } else {
            for ends in places.windows(2) {
                self.part(&mut course, ends[0], ends[1], open.clone(), MOST_HALVINGS);
            }
        }
        course.found
    }

    /// Axis values of the links.
    fn values(&self, course: &ConstantMotion<'_>, axes: &AxisValues) -> AxisValues {
        self.links.values(axes, &course.block.offsets_mm)
    }

    fn moved(&self, course: &ConstantMotion<'_>, ranges: &AxisRanges) -> AxisRanges {
        AxisRanges { low: self.values(course, &ranges.low), high: self.values(course, &ranges.high) }
    }

    /// Distance down to which a pair must be certified: the clearance, or that below which a smaller distance is
    /// searched for.
    fn wanted(&self, course: &ConstantMotion<'_>, pair: usize) -> f64 {
        let notable = self.pairs[pair]
            .smallest
            .map_or(SHOWN_MM, |smallest| (smallest.distance_mm * (1.0 - FOUND_TO) - FOUND_TO_MM).min(SHOWN_MM));
        if course.found(pair).is_some() { notable } else { notable.max(self.clearance_mm) }
    }

    /// Whether the known distance of a pair is enough for a part of a motion.
    fn is_clear(&self, course: &ConstantMotion<'_>, pair: usize, ranges: &AxisRanges) -> bool {
        let BodyPair { known, fresh, .. } = &self.pairs[pair];
        let wanted = self.wanted(course, pair);
        known
            .as_ref()
            .is_some_and(|(levers, least)| !fresh && least - levers.motion(&ranges.from(&levers.values)) > wanted)
    }

    /// A part of a motion between two shares.
    fn part(&mut self, course: &mut ConstantMotion<'_>, from: Share, to: Share, mut open: Vec<usize>, halvings: u32) {
        let ranges = course.axes.ranges([from.0, to.0], [&from.1, &to.1]);
        let ranges = ranges.map(|ranges| self.moved(course, &ranges));
        open.retain(|pair| {
            let clear = ranges.is_some_and(|ranges| self.is_clear(course, *pair, &ranges));
            !clear && !course.meets(*pair)
        });
        if open.is_empty() {
            return;
        }
        let share = f64::midpoint(from.0, to.0);
        let middle = (share, course.axes.at(share, &from.1));
        if let Some(ranges) = ranges {
            let values = self.values(course, &middle.1);
            open.retain(|pair| {
                let verdict = self.measure(
                    course,
                    *pair,
                    MeasuredAt { axes: &middle.1, values: &values },
                    &ranges,
                    RESOLUTION_MM,
                );
                matches!(verdict, Verdict::Open)
            });
            if open.is_empty() {
                return;
            }
        }
        if halvings == 0 {
            self.not_certified += 1;
            return;
        }
        self.part(course, from, middle, open.clone(), halvings - 1);
        self.part(course, middle, to, open, halvings - 1);
    }

    /// A pair while the axes are anywhere in a box.
    fn boxed(&mut self, course: &mut ConstantMotion<'_>, pair: usize, ranges: &AxisRanges) {
        let (mut cells, mut count) = (vec![*ranges], 0);
        while let Some(cell) = cells.pop() {
            if course.meets(pair) {
                return;
            }
            if self.is_clear(course, pair, &cell) {
                continue;
            }
            count += 1;
            let values = cell.middle();
            // The axis values of the program at the middle of the box.
            let offsets = self.values(course, &[0.0; MAX_AXES]);
            let axes: AxisValues =
                std::array::from_fn(|index| values[index] - if self.is_linear(index) { offsets[index] } else { 0.0 });
            match self.measure(course, pair, MeasuredAt { axes: &axes, values: &values }, &cell, BOX_RESOLUTION_MM) {
                Verdict::Done => {}
                Verdict::Open if count > MOST_CELLS => {
                    self.not_certified += 1;
                    return;
                }
                Verdict::Open => {
                    let Some((levers, _)) = &self.pairs[pair].known else { return };
                    // Across the axis that moves the bodies most.
                    let by = cell.from(&values);
                    let alone = |axis: usize| {
                        levers.motion(&std::array::from_fn(|index| if index == axis { by[index] } else { 0.0 }))
                    };
                    let widest = (0..MAX_AXES).max_by(|a, b| alone(*a).total_cmp(&alone(*b))).unwrap_or(0);
                    let (mut first, mut second) = (cell, cell);
                    first.high[widest] = values[widest];
                    second.low[widest] = values[widest];
                    cells.extend([first, second]);
                }
            }
        }
    }

    fn is_linear(&self, axis: usize) -> bool {
        axis < self.links.spindle() && !self.links.is_rotary(axis)
    }

    /// Measures the distance of a pair at a position, for a part of a motion. `resolution`: size of a part that is not
    /// divided, mm.
    fn measure(
        &mut self,
        course: &mut ConstantMotion<'_>,
        pair: usize,
        MeasuredAt { axes, values }: MeasuredAt<'_>,
        ranges: &AxisRanges,
        resolution: f64,
    ) -> Verdict {
        let (gap, levers) = self.gap_at(course, pair, values, ranges);
        let nearer = |gap: &BodyGap| matches!(gap, BodyGap::Apart { least_mm, .. } if *least_mm > self.clearance_mm);
        let (gap, levers) = match self.pairs[pair].stock && !nearer(&gap) && self.renew_stock(course) {
            // What has been cut away cannot be met.
            true => self.gap_at(course, pair, values, ranges),
            false => (gap, levers),
        };
        let [one, _] = self.pairs[pair].links;
        let on_table = |point: Point3<f64>| self.links.between(0, one, values) * point;
        let (least, nearest) = match gap {
            BodyGap::Meets(place) => {
                course.add(pair, None, on_table(place), axes);
                return Verdict::Done;
            }
            BodyGap::Apart { least_mm, nearest } => (least_mm, nearest),
        };
        let nearest = nearest.map(|(distance, place)| (distance, on_table(place)));
        let motion = levers.motion(&ranges.from(values));
        let held = &mut self.pairs[pair];
        (held.known, held.fresh) = (Some((levers, least)), false);
        if let Some((distance_mm, place)) = nearest
            && held.smallest.is_none_or(|smallest| distance_mm < smallest.distance_mm)
        {
            held.smallest = Some(Smallest { distance_mm, at: course.occasion(place, axes) });
        }
        let place = nearest.map_or(Point3::origin(), |(_, place)| place);
        if least <= self.clearance_mm {
            course.add(pair, Some(least.max(0.0)), place, axes);
        }
        let certified = least - motion;
        let allowed = certified > self.clearance_mm || course.found(pair).is_some();
        if certified > self.wanted(course, pair) || allowed && motion <= FOUND_TO * least + FOUND_TO_MM {
            Verdict::Done
        } else if motion <= resolution {
            course.add(pair, Some(certified.max(0.0)), place, axes);
            Verdict::Done
        } else {
            Verdict::Open
        }
    }

    /// Makes the body of the stock anew if more has been cut.
    fn renew_stock(&mut self, course: &mut ConstantMotion<'_>) -> bool {
        let (Some(stock), Some(boxes)) = (self.stock, (course.stock)()) else { return false };
        self.set_stock(stock, boxes);
        true
    }

    fn set_stock(&mut self, stock: usize, boxes: Vec<Vec<[[f64; 3]; 2]>>) {
        // Nothing of it is left: the body is far below.
        let nothing = || Shapes::of_boxes(vec![vec![[[0.0, 0.0, -2e6], [1.0, 1.0, 1.0 - 2e6]]]]);
        if let Some((shapes, ball)) = Shapes::of_boxes(boxes).or_else(nothing) {
            (self.bodies[stock].shapes, self.bodies[stock].ball) = (shapes, ball);
        }
        for other in self.pairs.iter_mut().filter(|other| other.stock) {
            other.known = None;
        }
    }

    /// Distance of a pair at a position, for a part of a motion.
    fn gap_at(
        &self,
        course: &ConstantMotion<'_>,
        pair: usize,
        values: &AxisValues,
        ranges: &AxisRanges,
    ) -> (BodyGap, Levers) {
        let [one, two] = self.pairs[pair].bodies.map(|body| &self.bodies[body]);
        let [from, to] = self.pairs[pair].links;
        let levers = Levers::of(&self.links, [from, to], [&one.ball, &two.ball], values);
        let place = self.links.between(from, to, values);
        let enough = self.wanted(course, pair) + levers.motion(&ranges.from(values)) + RESERVE_MM;
        (gap(one, two, &place, enough, self.pairs[pair].fresh), levers)
    }
}

impl ConstantMotion<'_> {
    /// What has been found of a pair in this motion.
    fn found(&self, pair: usize) -> Option<&Meeting> {
        self.found.iter().find(|meeting| meeting.pair == pair)
    }

    /// Whether a pair has met in this motion.
    fn meets(&self, pair: usize) -> bool {
        self.found(pair).is_some_and(|meeting| meeting.least_mm.is_none())
    }

    fn occasion(&self, place: Point3<f64>, axes: &AxisValues) -> Occasion {
        let MovingBlock { line, cl_line, operation, tool, set_up, .. } = self.block;
        Occasion { line, cl_line, operation, tool, place_mm: place.into(), axes: *axes, set_up }
    }

    /// One finding of a pair for a motion: the worst.
    fn add(&mut self, pair: usize, least_mm: Option<f64>, place: Point3<f64>, axes: &AxisValues) {
        let meeting = Meeting { pair, least_mm, at: self.occasion(place, axes) };
        let known = self.found.iter_mut().find(|meeting| meeting.pair == pair);
        match known {
            Some(known) if known.least_mm.is_none_or(|known| least_mm.is_some_and(|least| least >= known)) => {}
            Some(known) => *known = meeting,
            None => self.found.push(meeting),
        }
    }
}

/// Name of the stock, for `allow`.
pub(crate) const STOCK: &str = "stock";

/// Group of the parts of tools.
pub(super) const TOOL: &str = "tool";

fn is_allowed(allow: &[[String; 2]], one: &Body, two: &Body) -> bool {
    let has = |body: &Body, name: &String| body.name == *name || body.groups.contains(name);
    allow.iter().any(|[a, b]| has(one, a) && has(two, b) || has(one, b) && has(two, a))
}
