//! Blocks along an arc in which the rotary axes rest: there all that depends on the words follows evenly from the linear ones,
//! and goes round as these do.

use nalgebra::Vector3;

use super::super::geometry::{ArcPath, Segment};
use super::super::read::{Action, ArcMove, MAX_AXES, State};
use super::fit::{BlockPath, Deviation, DeviationBound, off_arc, points};
use super::{Rules, Words};

/// Words of a block along an arc. Those at a share `t` of its angle `a` are
/// `middle + (start - middle) cos a t + (quarter - middle) sin a t + (end - start) t`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ArcWords {
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

/// Tip in a block along an arc, at a share `t` of its angle `a`: `middle + start cos a t + quarter sin a t + rise t`, mm.
#[derive(Debug, Clone, Copy)]
struct ArcTip {
    middle: Vector3<f64>,
    start: Vector3<f64>,
    quarter: Vector3<f64>,
    rise: Vector3<f64>,
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
    pub(crate) fn arc(&self) -> Option<ArcWords> {
        let Action::Arc(ArcMove { centre, sweep, .. }) = &self.block.action else { return None };
        let [u, v, _] = self.block.state.plane?.axes();
        let (first, second) = (self.xyz[u]?, self.xyz[v]?);
        let start = self.before;
        let (mut middle, mut quarter, mut end) = (start, start, self.block.values);
        (middle[first], middle[second]) = (centre[u], centre[v]);
        quarter[first] = centre[u] - (start[second] - centre[v]);
        quarter[second] = centre[v] + (start[first] - centre[u]);
        (end[first], end[second]) = (start[first], start[second]);
        Some(ArcWords { middle, start, quarter, end, sweep: *sweep })
    }
}

impl ArcTip {
    /// `None` where a rotary axis rotates.
    fn of(words: &Words, arc: &ArcWords, state: &State) -> Option<Self> {
        let ArcWords { middle, start, quarter, end, sweep } = arc;
        if words.rotary_travel(start, end) > 0.0 {
            return None;
        }
        let tip = |at: &[f64; MAX_AXES]| words.place(at, state).tip;
        let (middle, before) = (tip(middle), tip(start));
        let rise = if start == end { Vector3::zeros() } else { tip(end) - before };
        Some(Self { middle, start: before - middle, quarter: tip(quarter) - middle, rise, sweep: *sweep })
    }

    /// Bound of its distance from a motion that goes round as it does, from a share of that on; mm.
    fn largest_distance(&self, arc: &ArcPath, along: f64) -> f64 {
        let (sense, begin) = (self.sweep.signum(), arc.angle() * along);
        let [start, ahead] = arc.radii_at(begin);
        let part = arc.share_of(self.sweep.abs());
        let (middle, climb, widened) = arc.axis_from(along, part);
        // The angle of the motion is that of the block, so that its tip is at each share no farther away than this. Where
        // the motion ends before the block, its end is farther back by the angle that is left.
        let round = (self.start - start).norm_squared() + (self.quarter - ahead * sense).norm_squared();
        let past = ((along + part - 1.0) * arc.angle()).max(0.0) * start.norm();
        (self.middle - middle).norm() + round.sqrt() + (self.rise - climb).norm() + widened + past
    }
}

impl Rules<'_> {
    /// Bounds of [`deviation`](Self::deviation) for a block along an arc whose rotary axes rest.
    pub(crate) fn arc_bound(&self, path: &BlockPath<'_>, arc: &ArcPath, along: f64) -> Option<DeviationBound> {
        let tip = ArcTip::of(&self.words, &path.arc()?, &path.block.state)?;
        Some(DeviationBound { tip_mm: tip.largest_distance(arc, along), axis_rad: 0.0, tip_rate_mm: 0.0 })
    }

    /// [`deviation`](Self::deviation) of such a block.
    pub(super) fn arc_deviation(
        &self,
        path: &BlockPath<'_>,
        (segment, arc): (&Segment, &ArcPath),
        along: f64,
    ) -> Option<Deviation> {
        let ArcTip { middle, start, quarter, rise, sweep } = ArcTip::of(&self.words, &path.arc()?, &path.block.state)?;
        let angle = sweep.abs();
        let count = points(angle);
        let step = 1.0 / (count + 1.0);
        let begin = along * arc.angle();
        let (mut block, mut motion) = (Turned::new(0.0, sweep * step), Turned::new(begin, angle * step));
        let mut found = Deviation::default();
        let mut point = 1.0;
        while point <= count {
            let share = point * step;
            let (sine, cosine) = block.next();
            let on = middle + start * cosine + quarter * sine + rise * share;
            let near = arc.distance_near(&on, begin + angle * share, motion.next());
            let off = near.unwrap_or_else(|| off_arc((segment, arc), &on, along + arc.share_of(angle * share)));
            found.tip_mm = found.tip_mm.max(off);
            point += 1.0;
        }
        Some(found)
    }
}
