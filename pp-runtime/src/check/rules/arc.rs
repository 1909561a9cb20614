//! Blocks along an arc in which the rotary axes rest. There tip and axis values are affine functions of the linear
//! words: what these do along a circle, those do along an ellipse. The deviation is measured at points, unless the
//! bound of one arc about another decides ([`ArcPath::farthest`]).

use std::f64::consts::PI;

use super::super::geometry::{ArcPath, RoundTip, Segment};
use super::super::read::{Action, ArcMove, MAX_AXES, State};
use super::fit::{BlockPath, Deviation, DeviationBound, off_arc};
use super::{MachineWords, Rules};

/// Largest angle of an arc between points that are compared, rad, unless there were more points than this. The distance
/// from an arc near to it has one wave or two in a turn, so that between two points it is hardly larger than at them.
/// Of arcs with the same ends it is largest in the middle: the number of points is odd.
const STEP: f64 = 0.1;
const MOST_POINTS: f64 = 3999.0;

/// Smallest number of points.
const LEAST_POINTS: f64 = 3.0;

/// Two more points are no farther than this from the ends of an arc, rad.
const FROM_ENDS: f64 = 0.02;

/// Words of a block along an arc. Those at a share `t` of its angle `a` are
/// `middle + (start - middle) cos a t + (quarter - middle) sin a t + (end - start) t`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WordsAlongArc {
    /// In the plane of the arc at its centre.
    pub(crate) middle: [f64; MAX_AXES],
    /// Those before the block.
    pub(crate) start: [f64; MAX_AXES],
    /// A quarter turn on in the positive sense.
    pub(crate) quarter: [f64; MAX_AXES],
    /// In the plane of the arc as before the block, else as after it.
    pub(crate) end: [f64; MAX_AXES],
    /// Angle of the arc, + in the positive sense, rad.
    sweep: f64,
}

/// Sine and cosine of an angle that grows in even steps.
#[derive(Debug, Clone, Copy)]
struct Turned {
    sine: f64,
    cosine: f64,
    step: (f64, f64),
}

impl Turned {
    fn new(from: f64, step: f64) -> Self {
        let (sine, cosine) = from.sin_cos();
        Self { sine, cosine, step: step.sin_cos() }
    }

    #[inline]
    fn next(&mut self) -> (f64, f64) {
        let (sine, cosine) = self.step;
        (self.sine, self.cosine) = (self.sine * cosine + self.cosine * sine, self.cosine * cosine - self.sine * sine);
        (self.sine, self.cosine)
    }
}

impl BlockPath<'_> {
    /// Words of the block, if it goes along an arc.
    pub(crate) fn arc(&self) -> Option<WordsAlongArc> {
        let Action::Arc(ArcMove { centre, sweep, .. }) = &self.block.action else { return None };
        let [u, v, _] = self.block.state.plane?.axes();
        let (first, second) = (self.xyz[u]?, self.xyz[v]?);
        let start = self.before;
        let (mut middle, mut quarter, mut end) = (start, start, self.block.values);
        (middle[first], middle[second]) = (centre[u], centre[v]);
        quarter[first] = centre[u] - (start[second] - centre[v]);
        quarter[second] = centre[v] + (start[first] - centre[u]);
        (end[first], end[second]) = (start[first], start[second]);
        Some(WordsAlongArc { middle, start, quarter, end, sweep: *sweep })
    }
}

impl RoundTip {
    /// The tip of a block along an arc whose rotary axes rest.
    fn of(words: &MachineWords, arc: &WordsAlongArc, state: &State) -> Self {
        let WordsAlongArc { middle, start, quarter, end, sweep } = arc;
        let steps = [[middle, start], [middle, quarter], [start, end]];
        let (middle, [start, quarter, rise]) = words.tip_and_shifts(middle, steps, state);
        Self { middle, start, quarter: quarter * sweep.signum(), rise, angle: sweep.abs() }
    }
}

impl Rules<'_> {
    /// Largest speeds of the axes along an arc, times its time, mm and rad: with `p` and `q` the shifts of an axis from
    /// the centre to the start and to a quarter turn after it, its speed is `q cos a - p sin a` and its share of the
    /// rise.
    pub(super) fn fastest_on_arc(&self, arc: &WordsAlongArc, state: &State) -> Option<[f64; MAX_AXES]> {
        let WordsAlongArc { middle, start, quarter, end, sweep } = arc;
        let axes = |words: &[f64; MAX_AXES]| self.words.axes(words, state);
        let (middle, start, quarter, end) = (axes(middle)?, axes(start)?, axes(quarter)?, axes(end)?);
        Some(std::array::from_fn(|index| {
            let (p, q) = (start[index] - middle[index], quarter[index] - middle[index]);
            let rise = end[index] - start[index];
            let speed = |angle: f64| (sweep * (q * angle.cos() - p * angle.sin()) + rise).abs();
            // Where the tangent is along the axis: half turns apart, both ways from the start.
            let first = (-p).atan2(q);
            let turns = (-4..=4).map(|half| first + f64::from(half) * PI);
            let within = turns.filter(|angle| angle * sweep.signum() > 0.0 && angle.abs() < sweep.abs());
            within.chain([0.0, *sweep]).map(speed).fold(0.0, f64::max)
        }))
    }

    /// [`deviation`](Self::deviation) of a block whose rotary axes rest, if it goes along an arc.
    pub(super) fn arc_deviation(
        &self,
        path: &BlockPath<'_>,
        segment: &Segment,
        arc: &ArcPath,
        along: f64,
    ) -> Option<Deviation> {
        let tip = RoundTip::of(&self.words, &path.arc()?, &path.block.state);
        let RoundTip { middle, start, quarter, rise, angle } = tip;
        let count = (LEAST_POINTS + 2.0 * (0.5 * angle / STEP).floor()).min(MOST_POINTS);
        let step = 1.0 / (count + 1.0);
        let begin = along * arc.angle();
        let distance = |share: f64, (sine, cosine): (f64, f64), (motion_sine, motion_cosine): (f64, f64)| {
            let on = middle + start * cosine + quarter * sine + rise * share;
            let near = arc.distance_near(&on, begin + angle * share, motion_sine, motion_cosine);
            near.unwrap_or_else(|| off_arc(segment, arc, &on, along + arc.share_of(angle * share)))
        };
        let first = step.min(FROM_ENDS / angle);
        let at_ends = [first, 1.0 - first]
            .map(|share| distance(share, (angle * share).sin_cos(), (begin + angle * share).sin_cos()));
        let mut tip_mm = at_ends[0].max(at_ends[1]);
        let (mut block, mut motion) = (Turned::new(0.0, angle * step), Turned::new(begin, angle * step));
        let mut point = 1.0;
        while point <= count {
            tip_mm = tip_mm.max(distance(point * step, block.next(), motion.next()));
            point += 1.0;
        }
        Some(Deviation { tip_mm, ..Deviation::default() })
    }

    /// Bound of the deviation of a block from an arc, between its ends; `None` where it rotates, goes along no arc, or
    /// along one far from this.
    pub(crate) fn arc_bound(&self, path: &BlockPath<'_>, arc: &ArcPath, along: f64) -> Option<DeviationBound> {
        if self.words.rotary_travel(&path.before, &path.block.values) > 0.0 {
            return None;
        }
        let tip = RoundTip::of(&self.words, &path.arc()?, &path.block.state);
        let tip_mm = arc.farthest(&tip, along)?;
        Some(DeviationBound { tip_mm, axis_rad: 0.0, tip_rate_mm: 0.0 })
    }
}
