//! Where a line enters the space that a moving tool sweeps: certified, eight lines at a time.
//!
//! A [`SweptPiece`] moves the tip evenly along a straight line and turns the axis along the arc between two vectors,
//! `a(s) = (a0 + s Δa) / |a0 + s Δa|`, for `s` in \[0, 1\]. With `f` the distance function of the [`Profile`], the
//! sweep is where `g(z) = min over s of f(z, s)` is not above zero, `z` being the coordinate along the line.
//!
//! # The least distance
//! Seen from the tool a point moves by `q(s)`, and with the rate of the axis `θ' <= 2 tan(θ/2) = k`,
//!
//! ```text
//! |q''| <= 2 k (|z'| + |ΔP|) + (k² + k³) r         r: distance of the point from the tip
//! ```
//!
//! `f` is convex in the frame of the tool and changes by no more than the distance. So on an interval of `s`, of width
//! `w`, `f + c (s - s1)(s - s2)` is convex, `2 c` being that bound with `z' = 0`: tangents at both ends meet at a lower
//! bound of `f`. Of an interval that is divided, one half is followed, and the bound of the other one is kept: it
//! counts as well.
//!
//! # The step along the line
//! On the interval the tangent planes at both ends, mixed so that `s` drops out, give for every `z`
//!
//! ```text
//! g(z + t) >= low + slope t - k w |t|
//! ```
//!
//! with the slopes along `z` mixed likewise. The smallest `t` at which one of the intervals permits `g = 0` is a step
//! that never passes the sweep. It ends where `g` is below half the tolerance.
//!
//! # Between the ends
//! From both sides a line enters at `z1 (s1)` and `z2 (s2)`. Along the straight path between the two in `(s, z)` the
//! same bound limits how far `f` rises: where it might rise above the tolerance, it is evaluated, and where it does, or
//! where the search above has not come to an end, the piece is divided in the middle.

use super::profile::Profile;
use crate::kinematics::Pose;

pub(super) const LANES: usize = 8;
pub(super) type Lanes = [f64; LANES];

/// Largest angle of the axis in one piece, rad: the cubic terms above are bounds up to it.
pub(crate) const LARGEST_TURN: f64 = 0.1;

/// Difference of two axes that is rounding.
const STILL: f64 = 1e-9;

/// Divisions of an interval of `s`.
const MOST_DIVISIONS: u32 = 24;

/// Steps along a line.
const MOST_STEPS: u32 = 120;

/// Part of the least distance by which its lower bound may be below it.
const SLACK: f64 = 0.2;

/// Halvings of a piece.
const MOST_HALVINGS: u32 = 20;

/// A motion of one convex piece of a tool. The coordinates are those of the workpiece, or two across and one along a
/// line.
#[derive(Debug, Clone, Copy)]
pub struct SweptPiece {
    /// Tip at the start.
    pub(super) tip: [f64; 3],
    pub(super) travel: [f64; 3],
    /// Tool axis at the start, from the tip to the spindle. Its length is not below that of a chord's middle.
    pub(super) axis: [f64; 3],
    pub(super) turn: [f64; 3],
    /// Distance that is subtracted: the tool is larger by it.
    pub(super) grow: f64,
    /// Index of its [`Profile`].
    pub(super) profile: u32,
    /// Names it where it cuts.
    pub(super) id: u32,
    /// It removes nothing.
    pub(super) test_only: bool,
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn along(a: &[f64; 3], b: &[f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|index| a[index] + share * b[index])
}

impl SweptPiece {
    /// The motion between two poses: the tip evenly along a straight line, the axis on the arc between both, which must
    /// not be longer than `LARGEST_TURN`. `profile` is the index of its shape; `id` is stated where it cuts.
    #[must_use]
    pub fn new(from: &Pose, to: &Pose, profile: u32, id: u32) -> Self {
        let turn = to.axis.into_inner() - from.axis.into_inner();
        // Rounding is no rotation: it moves the end of a long tool by less than a nanometre.
        let turn = if turn.norm() < STILL { [0.0; 3] } else { turn.into() };
        Self {
            tip: from.tip.into(),
            travel: (to.tip - from.tip).into(),
            axis: from.axis.into_inner().into(),
            turn,
            grow: 0.0,
            profile,
            id,
            test_only: false,
        }
    }

    /// This motion of a tool that is larger on all sides by a distance, or smaller, mm.
    #[must_use]
    pub fn grown(self, by_mm: f64) -> Self {
        Self { grow: by_mm, ..self }
    }

    /// This motion, removing nothing.
    #[must_use]
    pub fn touching(self) -> Self {
        Self { test_only: true, ..self }
    }

    /// Whether it removes material.
    pub(crate) fn removes(&self) -> bool {
        !self.test_only
    }

    /// Its name where it cuts.
    pub(crate) fn name(&self) -> u32 {
        self.id
    }

    /// Tip and tool axis at a share, the axis of length 1.
    #[must_use]
    pub fn pose(&self, share: f64) -> ([f64; 3], [f64; 3]) {
        let axis = along(&self.axis, &self.turn, share);
        let size = dot(&axis, &axis).sqrt();
        (along(&self.tip, &self.travel, share), axis.map(|component| component / size))
    }

    /// This motion with the coordinates across a line first, and that along it last.
    pub(super) fn permuted(&self, line: usize) -> Self {
        let order = |v: &[f64; 3]| [v[(line + 1) % 3], v[(line + 2) % 3], v[line]];
        let Self { tip, travel, axis, turn, .. } = self;
        Self { tip: order(tip), travel: order(travel), axis: order(axis), turn: order(turn), ..*self }
    }

    /// One of its halves.
    fn half(&self, second: bool) -> Self {
        let from = if second { 0.5 } else { 0.0 };
        Self {
            tip: along(&self.tip, &self.travel, from),
            travel: self.travel.map(|component| 0.5 * component),
            axis: along(&self.axis, &self.turn, from),
            turn: self.turn.map(|component| 0.5 * component),
            ..*self
        }
    }

    /// Corners of a box around its sweep.
    #[must_use]
    pub fn bounds(&self, profile: &Profile) -> [[f64; 3]; 2] {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        // Between the ends a point of the axis leaves their chord by an eighth of the second derivative.
        let bulge = self.bends(profile.reach) / 4.0;
        for share in [0.0, 1.0] {
            let (tip, axis) = self.pose(share);
            for height in [profile.bottom, profile.high] {
                for index in 0..3 {
                    let centre = tip[index] + height * axis[index];
                    let across = (1.0 - axis[index] * axis[index]).max(0.0).sqrt();
                    let turned = 1.01 * dot(&self.turn, &self.turn).sqrt();
                    let extent = profile.radius * (across + turned).min(1.0) + bulge + self.grow.max(0.0) + 1e-6;
                    low[index] = low[index].min(centre - extent);
                    high[index] = high[index].max(centre + extent);
                }
            }
        }
        [low, high]
    }

    /// Largest rate of the axis, rad.
    fn rate(&self) -> f64 {
        let squared = dot(&self.turn, &self.turn);
        let least = dot(&self.axis, &self.axis).min({
            let end = along(&self.axis, &self.turn, 1.0);
            dot(&end, &end)
        });
        // |a'| <= |Δa| / least |a|; a chord is nearest to the centre in its middle.
        (squared / (least - 0.25 * squared).max(0.5)).sqrt()
    }

    /// `c`, half the bound of the second derivative, for points within a distance of the tip.
    fn bends(&self, reach: f64) -> f64 {
        let rate = self.rate();
        let travel = dot(&self.travel, &self.travel).sqrt();
        0.5 * ((rate * rate + rate * rate * rate) * reach + 2.0 * rate * travel)
    }
}

/// A piece against lines along its third coordinate.
pub(super) struct SweptSpace<'a> {
    pub(super) piece: &'a SweptPiece,
    pub(super) profile: &'a Profile,
    /// Tolerance, mm.
    pub(super) eps: f64,
    rate: f64,
    travel: f64,
    /// Squared length of the axis at the start, and what it changes by.
    squares: [f64; 3],
    turns: bool,
}

/// LaneValues of eight lines at one `s` each.
#[derive(Clone, Copy)]
struct LaneValues {
    f: Lanes,
    /// Derivative along the line.
    fz: Lanes,
    /// Derivative by `s`.
    fs: Lanes,
}

/// Where eight lines enter.
#[derive(Clone, Copy)]
pub(super) struct Entries {
    /// NaN: nowhere before the end. Of an open line: nowhere before this.
    pub(super) z: Lanes,
    /// `s` at which the tool is nearest there.
    pub(super) s: Lanes,
    /// The search came to no end.
    pub(super) open: [bool; LANES],
}

/// Parts of eight lines.
#[derive(Clone, Copy)]
pub(super) struct EightLines {
    pub(super) u: Lanes,
    pub(super) v: Lanes,
    pub(super) low: Lanes,
    pub(super) high: Lanes,
    /// The lines that count.
    pub(super) live: [bool; LANES],
}

/// What a sweep covers of eight lines.
#[derive(Default)]
pub(super) struct Covered {
    /// Lane, and both ends; several of a lane are apart or overlap.
    pub(super) parts: Vec<(usize, [f64; 2])>,
    /// Lanes for which the piece was divided.
    pub(super) divided: u64,
    /// Parts that are not certified.
    pub(super) uncertified: u64,
}

impl Covered {
    /// Joins the parts of a lane that overlap, or are no more than a distance apart.
    pub(super) fn join(&mut self, apart: f64) {
        self.parts.sort_by(|a, b| (a.0, a.1[0]).partial_cmp(&(b.0, b.1[0])).unwrap_or(std::cmp::Ordering::Equal));
        let mut joined: Vec<(usize, [f64; 2])> = Vec::new();
        for (lane, part) in self.parts.drain(..) {
            match joined.last_mut() {
                Some((other, last)) if *other == lane && part[0] <= last[1] + apart => last[1] = last[1].max(part[1]),
                _ => joined.push((lane, part)),
            }
        }
        self.parts = joined;
    }
}

impl<'a> SweptSpace<'a> {
    /// `piece` with the coordinate along the lines last.
    pub(super) fn new(piece: &'a SweptPiece, profile: &'a Profile, eps: f64) -> Self {
        let SweptPiece { axis, turn, travel, .. } = piece;
        Self {
            piece,
            profile,
            eps,
            rate: piece.rate(),
            travel: dot(travel, travel).sqrt(),
            squares: [1.0 - dot(axis, axis), -2.0 * dot(axis, turn), -dot(turn, turn)],
            turns: dot(turn, turn) > 0.0,
        }
    }

    /// Half the bound of the second derivative by `s`.
    fn bends(&self, reach: f64) -> f64 {
        0.5 * ((self.rate * self.rate + self.rate * self.rate * self.rate) * reach + 2.0 * self.rate * self.travel)
    }

    #[inline(always)]
    fn values<const TURNS: bool>(&self, u: &Lanes, v: &Lanes, z: &Lanes, s: &Lanes) -> LaneValues {
        let SweptPiece { tip, travel, axis, turn, grow, .. } = self.piece;
        let Profile { vertex, normals: [n0, n1], edges: [e0, e1], round, low, high, .. } = self.profile;
        let [k0, k1, k2] = self.squares;
        let (mut f, mut fz, mut fs) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let s = s[i];
            let w = [u[i] - tip[0] - s * travel[0], v[i] - tip[1] - s * travel[1], z[i] - tip[2] - s * travel[2]];
            let (a, inverse);
            if TURNS {
                // 1/√(1 - e): e stays below 0.003.
                let e = k0 + s * (k1 + s * k2);
                inverse = 1.0 + e * (0.5 + e * (0.375 + e * (0.3125 + e * 0.273_437_5)));
                a = [
                    (axis[0] + s * turn[0]) * inverse,
                    (axis[1] + s * turn[1]) * inverse,
                    (axis[2] + s * turn[2]) * inverse,
                ];
            } else {
                inverse = 1.0;
                a = *axis;
            }
            let h = w[0] * a[0] + w[1] * a[1] + w[2] * a[2];
            let r = [w[0] - h * a[0], w[1] - h * a[1], w[2] - h * a[2]];
            let rho = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt().max(1e-9);
            let (x, y) = (rho - vertex[0], h - vertex[1]);
            let d0 = x * n0[0] + y * n0[1];
            let d1 = x * n1[0] + y * n1[1];
            let at_vertex = (x * e0[0] + y * e0[1] < 0.0) & (x * e1[0] + y * e1[1] < 0.0);
            let size = (x * x + y * y).sqrt().max(1e-12);
            let by_size = 1.0 / size;
            let first = d0 > d1;
            let value = if at_vertex { size } else { if first { d0 } else { d1 } } - round;
            let gr = if at_vertex { x * by_size } else { if first { n0[0] } else { n1[0] } };
            let gh = if at_vertex { y * by_size } else { if first { n0[1] } else { n1[1] } };
            let (over, under) = (h - high, low - h);
            let above = over > value;
            let value = if above { over } else { value };
            let below = under > value;
            let value = if below { under } else { value };
            let gr = if above | below { 0.0 } else { gr };
            let gh = if below { -1.0 } else { if above { 1.0 } else { gh } };
            let along = travel[0] * a[0] + travel[1] * a[1] + travel[2] * a[2];
            let across = travel[0] * r[0] + travel[1] * r[1] + travel[2] * r[2];
            let swing = if TURNS { (turn[0] * r[0] + turn[1] * r[1] + turn[2] * r[2]) * inverse } else { 0.0 };
            let by_rho = gr / rho;
            f[i] = value - grow;
            fz[i] = by_rho * r[2] + gh * a[2];
            fs[i] = gh * (swing - along) - by_rho * (across + h * swing);
        }
        LaneValues { f, fz, fs }
    }

    /// Where lines at `u`, `v` enter the sweep, from `from` towards `to`, all in the same direction.
    pub(super) fn entries(&self, u: &Lanes, v: &Lanes, from: &Lanes, to: &Lanes, live: [bool; LANES]) -> Entries {
        if self.turns { self.enter::<true>(u, v, from, to, live) } else { self.enter::<false>(u, v, from, to, live) }
    }

    #[inline(always)]
    fn enter<const TURNS: bool>(&self, u: &Lanes, v: &Lanes, from: &Lanes, to: &Lanes, live: [bool; LANES]) -> Entries {
        let eps = self.eps * self.profile.sharpness;
        let (mut z, mut alive) = (*from, live);
        let mut entries = Entries { z: [f64::NAN; LANES], s: [0.0; LANES], open: [false; LANES] };
        // Half the bound of the second derivative.
        let mut c = [0.0; LANES];
        let mut sign = [1.0; LANES];
        for i in 0..LANES {
            sign[i] = if to[i] >= from[i] { 1.0 } else { -1.0 };
            if TURNS {
                let mut reach: f64 = 0.0;
                for share in [0.0, 1.0] {
                    let tip = along(&self.piece.tip, &self.piece.travel, share);
                    for end in [from[i], to[i]] {
                        let w = [u[i] - tip[0], v[i] - tip[1], end - tip[2]];
                        reach = reach.max(dot(&w, &w));
                    }
                }
                c[i] = self.bends(reach.sqrt());
            }
        }
        let mut steps = 0;
        while alive.contains(&true) {
            if steps == MOST_STEPS {
                for i in (0..LANES).filter(|i| alive[*i]) {
                    (entries.open[i], entries.z[i]) = (true, z[i]);
                }
                break;
            }
            steps += 1;
            // The bracket [sl, sr] with its ends, the best value, and the step that the other intervals permit.
            let (mut sl, mut sr) = ([0.0; LANES], [1.0; LANES]);
            let mut left = self.values::<TURNS>(u, v, &z, &sl);
            let mut right = self.values::<TURNS>(u, v, &z, &sr);
            let (mut best, mut at) = ([0.0; LANES], [0.0; LANES]);
            for i in 0..LANES {
                let nearer = right.f[i] < left.f[i];
                best[i] = if nearer { right.f[i] } else { left.f[i] };
                at[i] = if nearer { 1.0 } else { 0.0 };
            }
            let mut others = [f64::INFINITY; LANES];
            let (mut low, mut step, mut next) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
            let mut division = 0;
            loop {
                let mut rough = false;
                for i in 0..LANES {
                    let w = sr[i] - sl[i];
                    let (bound, reach) = self.interval::<TURNS>(
                        [left.f[i], left.fs[i], left.fz[i]],
                        [right.f[i], right.fs[i], right.fz[i]],
                        w,
                        c[i],
                        sign[i],
                    );
                    low[i] = bound;
                    step[i] = if reach < others[i] { reach } else { others[i] };
                    // Where both tangents meet, and where a parabola of both slopes is lowest.
                    let (a, b) = (left.fs[i], right.fs[i]);
                    let meets = (right.f[i] - left.f[i] - b * w) / (a - b);
                    let lowest = -a * w / (b - a);
                    let t = 0.5 * (meets + lowest);
                    let t = if t > 0.02 * w { t } else { 0.02 * w };
                    let t = if t < 0.98 * w { t } else { 0.98 * w };
                    next[i] = sl[i] + t;
                    let enough = 0.25 * eps;
                    let share = SLACK * low[i];
                    let gap = if share > enough { share } else { enough };
                    let gone = step[i] > (to[i] - z[i]) * sign[i];
                    rough |= alive[i] & (best[i] > 0.5 * eps) & (best[i] - low[i] > gap) & !gone;
                }
                if !rough || division == MOST_DIVISIONS {
                    break;
                }
                division += 1;
                let middle = self.values::<TURNS>(u, v, &z, &next);
                for i in 0..LANES {
                    let nearer = middle.f[i] < best[i];
                    best[i] = if nearer { middle.f[i] } else { best[i] };
                    at[i] = if nearer { next[i] } else { at[i] };
                    let to_right = middle.fs[i] < 0.0;
                    let middles = [middle.f[i], middle.fs[i], middle.fz[i]];
                    let reach;
                    if to_right {
                        let lefts = [left.f[i], left.fs[i], left.fz[i]];
                        (_, reach) = self.interval::<TURNS>(lefts, middles, next[i] - sl[i], c[i], sign[i]);
                        (sl[i], left.f[i], left.fs[i], left.fz[i]) = (next[i], middles[0], middles[1], middles[2]);
                    } else {
                        let rights = [right.f[i], right.fs[i], right.fz[i]];
                        (_, reach) = self.interval::<TURNS>(middles, rights, sr[i] - next[i], c[i], sign[i]);
                        (sr[i], right.f[i], right.fs[i], right.fz[i]) = (next[i], middles[0], middles[1], middles[2]);
                    }
                    others[i] = if reach < others[i] { reach } else { others[i] };
                }
            }
            for i in 0..LANES {
                let hit = alive[i] & (best[i] <= 0.5 * eps);
                let gone = step[i] > (to[i] - z[i]) * sign[i];
                let stuck = step[i].is_nan() | (step[i] < 0.02 * eps);
                let open = alive[i] & !hit & !gone & stuck;
                entries.z[i] = if hit | open { z[i] } else { entries.z[i] };
                entries.s[i] = if hit { at[i] } else { entries.s[i] };
                entries.open[i] |= open;
                alive[i] &= !(hit | gone | stuck);
                z[i] += if alive[i] { sign[i] * step[i] } else { 0.0 };
            }
        }
        entries
    }

    /// Lower bound of an interval, and how far along the line it is above zero. `left`, `right`: value, slope by `s`,
    /// slope along the line.
    #[inline(always)]
    fn interval<const TURNS: bool>(
        &self,
        left: [f64; 3],
        right: [f64; 3],
        width: f64,
        c: f64,
        sign: f64,
    ) -> (f64, f64) {
        let ([lf, ls, lz], [rf, rs, rz]) = (left, right);
        let (a, b) = if TURNS { (ls - c * width, rs + c * width) } else { (ls, rs) };
        let falls = a < 0.0;
        let rises = b > 0.0;
        let share = b / (b - a);
        let meets = lf + a * ((rf - lf - b * width) / (a - b));
        let low = if falls & rises { meets } else { if falls { rf } else { lf } };
        let slope = if falls & rises { share * lz + (1.0 - share) * rz } else { if falls { rz } else { lz } };
        let cross = if TURNS { self.rate * width } else { 0.0 };
        let fall = cross - sign * slope;
        let reach = if fall > 1e-12 { low / fall } else { if low > 0.0 { f64::INFINITY } else { 0.0 } };
        (low, reach)
    }

    /// `f` of one line at one `s`.
    fn value(&self, [u, v]: [f64; 2], z: f64, s: f64) -> f64 {
        let (tip, axis) = self.piece.pose(s);
        let w = [u - tip[0], v - tip[1], z - tip[2]];
        let h = dot(&w, &axis);
        let rho = (dot(&w, &w) - h * h).max(0.0).sqrt();
        self.profile.distance(rho, h).0 - self.piece.grow
    }

    /// Whether the sweep is whole between two entries, `(z, s)` each.
    pub(super) fn is_whole(&self, line: [f64; 2], upper: (f64, f64), lower: (f64, f64)) -> bool {
        if !self.turns {
            return true;
        }
        let allowed = 0.75 * self.eps * self.profile.sharpness;
        let ends = [upper, lower].map(|(z, s)| (z, s, self.value(line, z, s)));
        self.stays_below(line, ends[0], ends[1], allowed, 16)
    }

    fn stays_below(
        &self,
        line: [f64; 2],
        from: (f64, f64, f64),
        to: (f64, f64, f64),
        allowed: f64,
        halvings: u32,
    ) -> bool {
        let (dz, ds) = ((to.0 - from.0).abs(), (to.1 - from.1).abs());
        let reach = [from, to].map(|(z, s, _)| {
            let (tip, _) = self.piece.pose(s);
            let w = [line[0] - tip[0], line[1] - tip[1], z - tip[2]];
            dot(&w, &w).sqrt()
        });
        let reach = reach[0].max(reach[1]) + dz + self.travel * ds;
        let bend = 2.0 * self.bends(reach) * ds * ds + 2.0 * self.rate * ds * dz;
        if from.2.max(to.2) + bend / 8.0 <= allowed {
            return true;
        }
        if halvings == 0 {
            return false;
        }
        let (z, s) = (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1));
        let middle = (z, s, self.value(line, z, s));
        middle.2 <= allowed
            && self.stays_below(line, from, middle, allowed, halvings - 1)
            && self.stays_below(line, middle, to, allowed, halvings - 1)
    }

    /// The parts of lines that the sweep covers. The piece is divided where they cannot be certified at once.
    pub(super) fn covered(&self, lines: &EightLines, covered: &mut Covered) {
        self.cover(lines, MOST_HALVINGS, covered);
    }

    fn cover(&self, lines: &EightLines, halvings: u32, covered: &mut Covered) {
        let EightLines { u, v, low, high, live } = lines;
        let above = self.entries(u, v, high, low, *live);
        let mut met = [false; LANES];
        let mut again = EightLines { live: [false; LANES], ..*lines };
        for lane in 0..LANES {
            met[lane] = live[lane] && !above.z[lane].is_nan() && !above.open[lane];
            if above.open[lane] {
                (again.live[lane], again.high[lane]) = (true, above.z[lane]);
            }
        }
        if met.contains(&true) {
            let mut to = *high;
            for lane in 0..LANES {
                to[lane] = if met[lane] { above.z[lane] } else { to[lane] };
            }
            let below = self.entries(u, v, low, &to, met);
            for lane in (0..LANES).filter(|lane| met[*lane]) {
                let upper = (above.z[lane], above.s[lane]);
                // From above it is met there at the latest.
                let lower = if below.z[lane].is_nan() { upper } else { (below.z[lane], below.s[lane]) };
                if !below.open[lane] && self.is_whole([u[lane], v[lane]], upper, lower) {
                    covered.parts.push((lane, [lower.0, upper.0]));
                } else {
                    (again.live[lane], again.high[lane], again.low[lane]) = (true, upper.0, lower.0);
                    if halvings == 0 {
                        covered.parts.push((lane, [lower.0, upper.0]));
                    }
                }
            }
        }
        let count = again.live.iter().filter(|live| **live).count() as u64;
        if count == 0 {
            return;
        }
        if halvings == 0 {
            covered.uncertified += count;
            return;
        }
        if halvings == MOST_HALVINGS {
            covered.divided += count;
        }
        for second in [false, true] {
            let piece = self.piece.half(second);
            SweptSpace::new(&piece, self.profile, self.eps).cover(&again, halvings - 1, covered);
        }
    }
}
