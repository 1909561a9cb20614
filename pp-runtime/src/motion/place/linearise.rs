//! Linearisation with a guarantee: blocks whose tip and tool axis are *certified* to stay within tolerance.
//!
//! CL data programs a straight tip path and a tool axis that rotates evenly in the plane of its ends; a control moves
//! every axis linearly instead. [`Linearised`] splits a motion so that
//! [`Machine::motion`](crate::kinematics::Machine::motion) certifies every piece, for the words as they are written:
//! the tolerance is reduced by their rounding.
//!
//! A motion has equal pieces, as few as certify: a control moves evenly through blocks of one length, and is slowed by
//! a remainder. Because deviations grow with the square of the length, the worst deviation of one number of pieces
//! predicts the next number to try. Points in between are *poses* of the path, inverted.
//!
//! [`RotationLaw`] selects the points in between, and whether the tool axis must be in step with the tip. Where the
//! rotary axes go evenly from end to end, as under tip control, no axis reverses that does not in the CL data; the tool
//! axis leaves its great circle, by no more than its tolerance for the whole motion. Otherwise, and where it would
//! leave it by more, the points are on the great circle.
//!
//! Where the axes rotate far more in one part of a motion than in the others, near a pole, equal pieces would be many
//! times as many as needed: more than [`MOST_TIMES`] the number of longest pieces, one after the other. There the
//! lengths are powers of two of the whole, as long as certifies, and neighbours differ by a factor of two at most.
//!
//! A piece whose tip and tool axis move by less than half a unit of the words and that does not certify is a rotation
//! on the spot: of the rotary axis whose angle is free at the pole. Its rotary values are stepped from one end to the
//! other, and the linear axes follow. A piece that does not certify although no rotary word changes by more than one
//! unit is refused.
//!
//! Nothing is allocated: a motion is a few positions on the stack, however many pieces it has.

use crate::diag::code::plan;
use crate::kinematics::math::{larger, smaller};
use crate::kinematics::{
    AxisValues, BlockDeviation, Branch, MotionBound, OutOfLimits, Pose, Rotary, RotaryAngles, RoughDeviation, Solution,
};

use super::refusal;
use super::{AxisPosition, Placer};
use crate::kinematics::math::rounded;
use crate::motion::fault::Fault;
use crate::motion::geometry::PathSegment;
use crate::motion::rotary::RotaryWords;
use crate::motion::step::MAX_AXES;
use crate::tolerance::writer::{EVEN_SHARE, LARGEST_EVEN_ROTATION, UNEVEN_NEAR_POLE, WIDEST_BLOCK};

/// Share of the tolerance from which on a piece is long enough.
const LONG_ENOUGH: f64 = 0.97;

/// Relative accuracy of the length of a longest piece.
const LENGTH_ACCURACY: f64 = 0.01;

/// Factor on the length that would use the whole tolerance, for the next try.
const AIM: f64 = 0.993;

/// Equal pieces, in numbers of the longest pieces, above which the pieces have different lengths.
const MOST_TIMES: u32 = 2;

/// Equal pieces up to this number need no comparison with the longest pieces.
const FEW: u32 = 4;

/// Largest number of pieces of one motion.
const MOST_PIECES: u32 = 100_000;

/// Largest number of tries for one piece: bisection from the whole motion to the last bit takes fewer.
const MAX_TRIES: usize = 120;

/// Largest deviation of the written motion from the motion of the CL data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PathTolerance {
    /// Deviation of the tip.
    pub(crate) tip_mm: f64,
    /// Deviation of the tool axis.
    pub(crate) axis_rad: f64,
}

/// Motion of the rotary axes between the ends of a motion of the CL data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RotationLaw {
    /// Even, where the tool axis keeps to its tolerance so.
    Even,
    /// As the tool axis rotates evenly in the plane of its ends.
    GreatCircle,
    /// On the great circle in step with the tip: the tool axis keeps to its tolerance from the programmed one where the
    /// tip is.
    InStep,
}

/// A piece with its certified deviation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CertifiedPiece {
    /// Position at its end.
    pub(crate) place: AxisPosition,
    /// Largest deviation from the motion of the CL data, rounding of the words included.
    pub(crate) bound: MotionBound,
    /// Share of the tolerance that the deviation uses; above 1 the piece does not certify.
    share: f64,
}

/// A motion that certifies in one block.
pub(crate) struct WholeMotion {
    /// As in [`MotionBound`].
    pub(crate) tip_rate: f64,
    /// Largest deviation from the motion of the CL data, rounding of the words included; `None` where it is below the
    /// largest so far.
    pub(crate) bound: Option<MotionBound>,
}

/// Deviation of a block by the rounding of its words alone.
#[derive(Clone, Copy)]
struct Rounding {
    tip_mm: f64,
    axis_rad: f64,
}

/// Both ends of a block, or of the part of a path that is left.
#[derive(Clone, Copy)]
pub(crate) struct BlockEnds<'p> {
    pub(crate) from: &'p AxisPosition,
    pub(crate) to: &'p AxisPosition,
}

/// Certified deviation of a block.
struct Certificate {
    /// Largest deviation from the motion of the CL data, rounding of the words included.
    bound: MotionBound,
    /// Share of the tolerance that it uses.
    share: f64,
}

/// The pieces of one motion, one after the other.
#[derive(Debug, Clone)]
pub(crate) struct Linearised {
    tolerance: PathTolerance,
    law: RotationLaw,
    /// Position at the end of the last piece.
    from: AxisPosition,
    to: AxisPosition,
    rest: Remaining,
}

/// The rest of a motion.
#[derive(Debug, Clone, Copy)]
#[expect(clippy::large_enum_variant, reason = "one on the stack for a motion: nothing is allocated")]
enum Remaining {
    /// The whole motion, in one block if that certifies.
    Whole,
    /// The rest of the path.
    Path(CuttingPath),
    /// A rotation on the spot, and then the rest of the path, if there is one.
    Spot(SpotRotation, CuttingPath),
    /// Nothing.
    Nothing,
}

/// The motion of the CL data: a straight path with an evenly rotating tool axis.
#[derive(Debug, Clone, Copy)]
struct CuttingPath {
    segment: PathSegment,
    /// The branch of both ends; `None` if they are on different branches.
    branch: Option<Branch>,
    /// The rotary axes go evenly.
    even: Option<EvenRotation>,
    /// Smallest step of the parameter: half a unit of the words.
    resolution: f64,
    /// Parameter at the end of the last piece.
    at: f64,
    pieces: Pieces,
}

/// A motion in which the rotary axes go evenly from its start to its end.
#[derive(Debug, Clone, Copy)]
struct EvenRotation {
    /// Words of the start. The rounding of a point in between is not that of the points before it.
    start: [i64; MAX_AXES],
    /// Bound of the whole motion, whose tool axis the points in between follow.
    bound: MotionBound,
}

/// Lengths of the pieces of a path.
#[derive(Debug, Clone, Copy)]
enum Pieces {
    /// Equal, this many, of which some are done.
    Equal { count: u32, done: u32 },
    /// Powers of two of the whole; length of the last one, in the parameter.
    Graded { last: f64 },
}

/// A rotation of the rotary axes while the tool stays in place.
#[derive(Debug, Clone, Copy)]
struct SpotRotation {
    start: AxisPosition,
    target: AxisPosition,
    /// Smallest step of the parameter: no word changes by more than one unit.
    resolution: f64,
    at: f64,
    stride: f64,
}

/// The next part of a path with pieces of graded lengths.
struct GradedPart {
    /// In the parameter.
    length: f64,
    /// A part that does not certify is to be a rotation on the spot.
    piece: CertifiedPiece,
}

/// Result of a search for the longest piece.
struct LongestPiece {
    /// Parameter at the end of the piece; without a piece the smallest that was tried.
    until: f64,
    /// `None` if no piece up to `until` certifies; shorter ones are not tried.
    piece: Option<CertifiedPiece>,
}

impl Linearised {
    /// Starts the motion from one position to another.
    pub(crate) fn new(from: &AxisPosition, to: &AxisPosition, tolerance: PathTolerance, law: RotationLaw) -> Self {
        Self { tolerance, law, from: *from, to: *to, rest: Remaining::Whole }
    }

    /// The whole motion in one block, if that certifies within `allowed`. `seen`: the largest bounds so far.
    #[inline(always)]
    pub(crate) fn in_one_block(
        placer: &Placer,
        ends: BlockEnds<'_>,
        allowed: PathTolerance,
        seen: RoughDeviation,
        law: RotationLaw,
    ) -> Option<WholeMotion> {
        let BlockEnds { from, to } = ends;
        let certifier = Certifier { placer, allowed, in_step: law == RotationLaw::InStep };
        let rounding = certifier.rounding(from, to);
        let axis_left = allowed.axis_rad - rounding.axis_rad;
        let most = RoughDeviation {
            tip: smaller(seen.tip, allowed.tip_mm) - rounding.tip_mm,
            axis: smaller(seen.axis - rounding.axis_rad, axis_left),
            axis_step: smaller(seen.axis_step - rounding.axis_rad, axis_left),
        };
        match placer.machine.motion_within(&from.axes, &to.axes, &most) {
            BlockDeviation::Below { tip_rate } if certifier.is_narrow(from, to) => {
                // The tip is not ahead by more than its tolerance: the axis lags by no more than its step.
                Some(WholeMotion { tip_rate: placer.frame.tip_rate(tip_rate), bound: None })
            }
            BlockDeviation::Below { .. } => None,
            BlockDeviation::UpTo(bound) => {
                let bound = placer.frame.bound(bound);
                let Certificate { bound, share } = certifier.with_rounding(ends, bound, rounding);
                (share <= 1.0).then_some(WholeMotion { tip_rate: bound.tip_rate, bound: Some(bound) })
            }
        }
    }

    /// The next piece; `None` after the last.
    ///
    /// # Errors
    /// If a part of the path cannot be certified, is unreachable, or is outside the limits of a rotary axis.
    pub(crate) fn next(&mut self, placer: &Placer) -> Result<Option<CertifiedPiece>, Fault> {
        let certifier = Certifier { placer, allowed: self.tolerance, in_step: self.law == RotationLaw::InStep };
        loop {
            let piece = match self.rest {
                Remaining::Nothing => return Ok(None),
                Remaining::Whole => {
                    let whole = certifier.certify(&self.from, &self.to);
                    if whole.share <= 1.0 {
                        self.rest = Remaining::Nothing;
                        return Ok(Some(whole));
                    }
                    self.rest = Remaining::Path(certifier.path(&self.from, &self.to, self.law, &whole)?);
                    continue;
                }
                Remaining::Path(path) => self.along(&certifier, path)?,
                Remaining::Spot(spot, path) => Some(self.on_spot(&certifier, spot, path)?),
            };
            if let Some(piece) = piece {
                self.from = piece.place;
                return Ok(Some(piece));
            }
        }
    }

    /// The next piece along the path; `None` if a rotation on the spot must come first.
    fn along(&mut self, certifier: &Certifier<'_>, mut path: CuttingPath) -> Result<Option<CertifiedPiece>, Fault> {
        let ends = BlockEnds { from: &self.from, to: &self.to };
        let mut piece = match path.pieces {
            Pieces::Equal { count, done } => {
                let until = f64::from(done + 1) / f64::from(count);
                let piece = certifier.certify(&self.from, &certifier.point(&path, ends, until)?);
                (path.at, path.pieces) = (until, Pieces::Equal { count, done: done + 1 });
                piece
            }
            Pieces::Graded { last } => {
                let GradedPart { length, piece } = certifier.graded(&path, ends, last)?;
                (path.at, path.pieces) = (path.at + length, Pieces::Graded { last: length });
                if piece.share > 1.0 {
                    self.rest = Remaining::Spot(certifier.spot(&self.from, &piece.place), path);
                    return Ok(None);
                }
                piece
            }
        };
        if let Some(EvenRotation { bound: MotionBound { axis, axis_step, .. }, .. }) = path.even {
            (piece.bound.axis, piece.bound.axis_step) = (axis, axis_step);
        }
        self.rest = if path.at < 1.0 { Remaining::Path(path) } else { Remaining::Nothing };
        Ok(Some(piece))
    }

    /// The next piece of a rotation on the spot.
    fn on_spot(
        &mut self,
        certifier: &Certifier<'_>,
        spot: SpotRotation,
        path: CuttingPath,
    ) -> Result<CertifiedPiece, Fault> {
        let from = self.from;
        let piece = certifier.certify(&from, &spot.target);
        if piece.share <= 1.0 {
            self.rest = if path.at < 1.0 { Remaining::Path(path) } else { Remaining::Nothing };
            return Ok(piece);
        }
        let found = longest(spot.at, spot.stride, spot.resolution, |parameter| {
            let place = certifier.rotated(&spot, parameter)?;
            Ok(certifier.certify(&from, &place))
        })?;
        let Some(piece) = found.piece else { return Err(certifier.uncertified(&from, &spot.target)) };
        let spot = SpotRotation { stride: found.until - spot.at, at: found.until, ..spot };
        self.rest = Remaining::Spot(spot, path);
        Ok(piece)
    }
}

/// Searches the longest piece that certifies, with its end between `at` and 1; the whole rest does not certify.
fn longest(
    at: f64,
    stride: f64,
    resolution: f64,
    mut piece_to: impl FnMut(f64) -> Result<CertifiedPiece, Fault>,
) -> Result<LongestPiece, Fault> {
    let (mut good, mut bad) = (at, 1.0);
    let mut best: Option<CertifiedPiece> = None;
    let mut next = at + stride;
    for count in 0..MAX_TRIES {
        let known = good - at;
        if best.is_some() && bad - good <= LENGTH_ACCURACY * known || best.is_none() && bad - at <= resolution {
            break;
        }
        let margin = 0.03 * (bad - good);
        // Every third try is a plain bisection, so that the search ends even if the predictions are poor.
        if !(next > good + margin && next < bad - margin) || count % 3 == 2 {
            next = 0.5 * (good + bad);
        }
        let piece = piece_to(next)?;
        let aim = at + (next - at) * AIM / piece.share.sqrt();
        if piece.share <= 1.0 {
            (good, best) = (next, Some(piece));
            if piece.share >= LONG_ENOUGH {
                break;
            }
        } else {
            bad = next;
        }
        next = aim;
    }
    Ok(LongestPiece { until: if best.is_some() { good } else { bad }, piece: best })
}

impl Placer {
    /// Whether a tool axis is so near to a pole that the rotary axes do not go evenly.
    fn is_near_pole(&self, pose: &Pose) -> bool {
        self.poles.axes.iter().any(|pole| pose.axis.cross(pole).norm() < UNEVEN_NEAR_POLE)
    }

    /// Whether the rotary axes go evenly in a whole motion between two poses on one branch: between their words, hence
    /// inside their limits.
    pub(crate) fn goes_evenly(&self, poses: [&Pose; 2], [start, end]: [&RotaryWords; 2]) -> bool {
        let bound = || self.machine.motion(&self.axes_of(start), &self.axes_of(end)).axis;
        self.may_go_evenly(poses, [&self.all_words(start), &self.all_words(end)])
            && self.even_rad.is_some_and(|tolerance| bound() <= EVEN_SHARE * tolerance)
    }

    /// Whether the rotary axes may go evenly between two poses, as far as the tool axis keeps to its tolerance.
    fn may_go_evenly(&self, [a, b]: [&Pose; 2], [start, end]: [&[i64; MAX_AXES]; 2]) -> bool {
        !(self.is_near_pole(a) || self.is_near_pole(b))
            && self.rotary_travel(start, end) <= LARGEST_EVEN_ROTATION
            && !self.has_indexed_axes()
    }
}

/// Certifies blocks of one machine within a tolerance.
#[derive(Clone, Copy)]
struct Certifier<'p> {
    placer: &'p Placer,
    allowed: PathTolerance,
    /// The tool axis is to be in step with the tip.
    in_step: bool,
}

impl Certifier<'_> {
    /// One block as a piece.
    fn certify(&self, from: &AxisPosition, to: &AxisPosition) -> CertifiedPiece {
        let bound = self.placer.frame.bound(self.placer.machine.motion(&from.axes, &to.axes));
        let Certificate { bound, share } = self.with_rounding(BlockEnds { from, to }, bound, self.rounding(from, to));
        CertifiedPiece { place: *to, bound, share }
    }

    /// Certified deviation of one block, of which `bound` is that without the rounding of its words.
    fn with_rounding(
        &self,
        BlockEnds { from, to }: BlockEnds<'_>,
        mut bound: MotionBound,
        Rounding { tip_mm: tip_off, axis_rad: axis_off }: Rounding,
    ) -> Certificate {
        if bound.tip > self.allowed.tip_mm - tip_off && bound.axis <= self.allowed.axis_rad - axis_off {
            bound.tip = self.tip_by_halves(from, to, bound.tip);
        }
        let angle = if self.in_step { larger(bound.lag(self.allowed.tip_mm), bound.axis) } else { bound.axis };
        let share = larger(bound.tip / (self.allowed.tip_mm - tip_off), angle / (self.allowed.axis_rad - axis_off));
        let roomy = self.allowed.tip_mm > tip_off && self.allowed.axis_rad > axis_off;
        Certificate {
            bound: MotionBound {
                tip: bound.tip + tip_off,
                axis: bound.axis + axis_off,
                axis_step: bound.axis_step + axis_off,
                ..bound
            },
            share: if roomy && self.is_narrow(from, to) && share.is_finite() { share } else { f64::INFINITY },
        }
    }

    /// Largest deviation by the rounding of the words at both ends.
    #[inline(always)]
    fn rounding(&self, from: &AxisPosition, to: &AxisPosition) -> Rounding {
        Rounding {
            tip_mm: larger(from.rounding_mm, to.rounding_mm),
            axis_rad: larger(self.axis_off(from), self.axis_off(to)),
        }
    }

    /// Whether the tool axis rotates by so little that its great circle is sure, and no axis of the control by half a
    /// revolution.
    #[inline(always)]
    fn is_narrow(&self, from: &AxisPosition, to: &AxisPosition) -> bool {
        from.pose.axis.dot(&to.pose.axis) > WIDEST_BLOCK && !self.placer.rolls_over(from, to)
    }

    /// A bound of the deviation of the tip from its line, mm, that is smaller than `whole` if the path bends to both
    /// sides of the line: each half deviates from its own chord by no more than its certified bound, and the two chords
    /// deviate from the line by no more than the point where they meet.
    fn tip_by_halves(&self, from: &AxisPosition, to: &AxisPosition, whole: f64) -> f64 {
        let mut middle = from.axes;
        for (value, end) in middle.as_mut().iter_mut().zip(to.axes) {
            *value = 0.5 * (*value + end);
        }
        let (start, line) = (from.pose.tip, to.pose.tip - from.pose.tip);
        let along = self.placer.machine.forward_kinematics(&middle).tip - start;
        let length = line.norm_squared();
        let part = if length > 0.0 { (along.dot(&line) / length).clamp(0.0, 1.0) } else { 0.0 };
        // The ends deviate by the rounding of their words.
        let off = (along - line * part).norm() + from.rounding_mm.max(to.rounding_mm);
        if off > 0.5 * whole {
            return whole;
        }
        let halves = [(&from.axes, &middle), (&middle, &to.axes)].map(|(a, b)| self.placer.machine.motion(a, b).tip);
        whole.min(off + halves[0].max(halves[1]))
    }

    /// Largest deviation of the arc between the written tool axes from the arc between those of the poses, rad: twice
    /// the deviation of an end, since no block exceeds the angle of [`WIDEST_BLOCK`]. A position at the pole has the
    /// pole as the axis of its pose: its distance from the programmed axis is subject to another tolerance.
    #[inline]
    fn axis_off(&self, place: &AxisPosition) -> f64 {
        let deviation = if place.at_pole { 0.0 } else { place.deviation_rad };
        self.placer.rotary.rounding_rad + 2.0 * deviation
    }

    /// The path between two positions; `whole` is that motion as one piece.
    #[cold]
    fn path(
        &self,
        from: &AxisPosition,
        to: &AxisPosition,
        law: RotationLaw,
        whole: &CertifiedPiece,
    ) -> Result<CuttingPath, Fault> {
        let rounding = self.placer.largest_rounding();
        if rounding >= self.allowed.tip_mm {
            return Err(plan::TOLERANCE.fault(format_args!(
                "the linear words are too coarse for a tolerance of {} while a rotary axis moves: their rounding alone moves \
                 the tip by up to {}",
                self.placer.units().length(self.allowed.tip_mm),
                self.placer.units().length(rounding)
            ))
            .help("increase `tolerance`, or give more decimals: `linear_mm` or `linear_inch` in [formats]"));
        }
        let rounding = self.placer.rotary.rounding_rad;
        if rounding >= self.allowed.axis_rad {
            return Err(plan::TOLERANCE.fault(format_args!(
                "the rotary words are too coarse for a tolerance of {:.4}° of the tool axis: their rounding alone rotates it by \
                 up to {:.4}°",
                self.allowed.axis_rad.to_degrees(),
                rounding.to_degrees()
            ))
            .help("increase `axis_tolerance_path`, or give more decimals: `rotary` in [formats]"));
        }
        let Some(segment) = PathSegment::new(&from.pose, &to.pose) else {
            return Err(plan::TOOL_AXIS
                .fault("the tool axis rotates by 180° in one motion: the direction of the rotation is undefined")
                .help("program a point in between"));
        };
        let half_unit = |unit: f64, extent: f64| if extent > 0.0 { 0.5 * unit / extent } else { 1.0 };
        let resolution = half_unit(self.placer.unit_mm(), segment.length())
            .min(half_unit(self.placer.rotary.scale.angle(1), segment.angle()))
            .min(1.0);
        // At the pole both branches are the same.
        let branch = match (from.at_pole, to.at_pole) {
            (true, false) => Some(to.branch),
            (false, true) => Some(from.branch),
            _ => (from.branch == to.branch).then_some(from.branch),
        };
        let even = law == RotationLaw::Even
            && branch.is_some()
            && self.placer.may_go_evenly([&from.pose, &to.pose], [&from.words, &to.words]);
        let even = (even && whole.bound.axis <= self.allowed.axis_rad)
            .then_some(EvenRotation { start: from.words, bound: whole.bound });
        let path = CuttingPath { segment, branch, even, resolution, at: 0.0, pieces: Pieces::Graded { last: 1.0 } };
        Ok(CuttingPath { pieces: self.pieces(&path, BlockEnds { from, to }, whole.share)?, ..path })
    }

    /// The lengths of the pieces of a path.
    #[cold]
    fn pieces(&self, path: &CuttingPath, ends: BlockEnds<'_>, share: f64) -> Result<Pieces, Fault> {
        let predicted =
            |count: u32, share: f64| (f64::from(count) * share.sqrt()).ceil().min(f64::from(MOST_PIECES)) as u32;
        let (mut count, mut most) = (if share.is_finite() { predicted(1, share).max(2) } else { 2 }, None);
        // The largest number that is known to be too small.
        let mut too_few = 1;
        let mut equal = None;
        while equal.is_none_or(|enough| count < enough) && count > too_few {
            if count > FEW {
                let most = match most {
                    Some(most) => most,
                    None => *most.insert(self.least(path, ends)?.map_or(0, |least| least.saturating_mul(MOST_TIMES))),
                };
                if count > most {
                    // Fewer may still certify.
                    if most <= too_few {
                        break;
                    }
                    count = most;
                }
            }
            let worst = self.worst_of_equal(path, ends, count)?;
            if worst <= 1.0 {
                equal = Some(count);
                count = predicted(count, worst).max(too_few + 1).min(count - 1);
            } else {
                too_few = count;
                let next = if worst.is_finite() { predicted(count, worst) } else { count.saturating_mul(2) };
                count = equal.map_or(next.max(count + 1), |enough: u32| next.clamp(count + 1, enough));
            }
        }
        Ok(equal.map_or(Pieces::Graded { last: 1.0 }, |count| Pieces::Equal { count, done: 0 }))
    }

    /// Largest share of the tolerance that one of `count` equal pieces uses.
    fn worst_of_equal(
        &self,
        path: &CuttingPath,
        BlockEnds { from, to }: BlockEnds<'_>,
        count: u32,
    ) -> Result<f64, Fault> {
        let (mut last, mut path, mut worst) = (*from, *path, 0.0_f64);
        for done in 1..=count {
            let until = f64::from(done) / f64::from(count);
            let place = self.point(&path, BlockEnds { from: &last, to }, until)?;
            worst = worst.max(self.certify(&last, &place).share);
            if worst.is_infinite() {
                break;
            }
            (last, path.at) = (place, until);
        }
        Ok(worst)
    }

    /// Number of the longest pieces, one after the other; `None` if one does not certify however short it is.
    fn least(&self, path: &CuttingPath, BlockEnds { from, to }: BlockEnds<'_>) -> Result<Option<u32>, Fault> {
        let (mut last, mut path, mut stride) = (*from, *path, 0.5);
        for count in 1..MOST_PIECES {
            if path.at > 0.0 && self.certify(&last, to).share <= 1.0 {
                return Ok(Some(count));
            }
            let found = longest(path.at, stride, path.resolution, |parameter| {
                let place = self.between(&path, BlockEnds { from: &last, to }, parameter)?;
                Ok(self.certify(&last, &place))
            })?;
            let Some(piece) = found.piece else { return Ok(None) };
            (last, stride, path.at) = (piece.place, found.until - path.at, found.until);
        }
        Ok(None)
    }

    /// The next piece of graded lengths, or a part that is to be a rotation on the spot.
    fn graded(&self, path: &CuttingPath, ends: BlockEnds<'_>, last: f64) -> Result<GradedPart, Fault> {
        let BlockEnds { from, to } = ends;
        let mut length = (2.0 * last).min(1.0);
        loop {
            let fits = path.at + length <= 1.0 && (path.at / length).fract() == 0.0;
            if fits {
                let piece = self.certify(from, &self.point(path, ends, path.at + length)?);
                let shortest = length <= path.resolution;
                let after = BlockEnds { from: &piece.place, to };
                if shortest || piece.share <= 1.0 && self.grades(path, after, path.at + length, 0.5 * length)? {
                    return Ok(GradedPart { length, piece });
                }
            }
            length *= 0.5;
        }
    }

    /// Whether a piece of this length may begin at a parameter, and the pieces after it need not be shorter by more
    /// than a factor of two from one to the next.
    fn grades(&self, path: &CuttingPath, ends: BlockEnds<'_>, at: f64, length: f64) -> Result<bool, Fault> {
        let BlockEnds { from, to } = ends;
        if at >= 1.0 || length <= path.resolution {
            return Ok(true);
        }
        let path = CuttingPath { at, ..*path };
        let place = self.point(&path, ends, at + length)?;
        Ok(self.certify(from, &place).share <= 1.0
            && self.grades(&path, BlockEnds { from: &place, to }, at + length, 0.5 * length)?)
    }

    /// Position at a parameter of the path, which may be its end.
    fn point(&self, path: &CuttingPath, ends: BlockEnds<'_>, parameter: f64) -> Result<AxisPosition, Fault> {
        if parameter < 1.0 { self.between(path, ends, parameter) } else { Ok(*ends.to) }
    }

    /// Rotary words of a solution, in the turn nearest to the axis values `near`.
    fn nearest_words(&self, solution: &Solution<RotaryAngles>, near: &AxisValues) -> [i64; MAX_AXES] {
        let mut words = [0; MAX_AXES];
        for (rotary, angle) in self.placer.rotary.axes.iter().zip(solution.axes) {
            let word = rotary.word(angle, self.placer.rotary.scale);
            let wanted = rotary.word(near.as_ref()[rotary.index], self.placer.rotary.scale);
            let turns = (wanted - word + self.placer.rotary.scale.units_per_turn / 2)
                .div_euclid(self.placer.rotary.scale.units_per_turn);
            words[rotary.index] = word + turns * self.placer.rotary.scale.units_per_turn;
        }
        words
    }

    /// Position of a pose of the path: on the common branch of the ends, or else nearest to the interpolation between
    /// them.
    fn between(
        &self,
        path: &CuttingPath,
        BlockEnds { from, to }: BlockEnds<'_>,
        parameter: f64,
    ) -> Result<AxisPosition, Fault> {
        let pose = path.segment.at(parameter);
        if let Some(EvenRotation { start, .. }) = &path.even {
            return self.evenly(from, &self.words_between(start, &to.words, parameter), &pose);
        }
        let share = (parameter - path.at) / (1.0 - path.at);
        let mut guess = from.axes;
        for (value, end) in guess.as_mut().iter_mut().zip(to.axes) {
            *value += (end - *value) * share;
        }
        let solutions = self.placer.machine.rotary_axes(&pose.axis, &guess);
        let travel = |solution: &&Solution<RotaryAngles>| {
            let words = self.nearest_words(solution, &guess);
            let guessed = |rotary: &Rotary| rotary.word(guess.as_ref()[rotary.index], self.placer.rotary.scale);
            self.placer.rotary.axes.iter().map(|rotary| words[rotary.index].abs_diff(guessed(rotary))).sum::<u64>()
        };
        let wanted = path.branch.filter(|_| solutions.len() > 1);
        let chosen = match wanted {
            Some(branch) => solutions.iter().find(|solution| solution.branch == branch),
            None => solutions.iter().min_by_key(travel),
        };
        let in_between = |fault: Fault| fault.context("between the last point and this one");
        let Some(solution) = chosen else { return Err(in_between(refusal::unreachable(self.placer, &pose, &guess))) };
        // Whole turns are chosen near the middle of the ends, wherever near the pole most of the rotation takes place.
        let mut middle = from.axes;
        for (value, end) in middle.as_mut().iter_mut().zip(to.axes) {
            *value = 0.5 * (*value + end);
        }
        self.nearest_turn(&pose, from, solution, &middle).map_err(in_between)
    }

    /// Words whose rotary ones are at a share of the rotation from some words to others.
    fn words_between(&self, from: &[i64; MAX_AXES], to: &[i64; MAX_AXES], share: f64) -> [i64; MAX_AXES] {
        let mut words = *from;
        for rotary in &self.placer.rotary.axes {
            let change = (to[rotary.index] - words[rotary.index]) as f64;
            words[rotary.index] += rounded(change * share);
        }
        words
    }

    /// Position with these rotary words, of an even rotation, and with the tip of a pose.
    fn evenly(&self, from: &AxisPosition, words: &[i64; MAX_AXES], pose: &Pose) -> Result<AxisPosition, Fault> {
        let mut place = self.placer.position_at(pose, from, words);
        place.pose.axis = self.placer.machine.forward_kinematics(&place.axes).axis;
        place.deviation_rad = 0.0;
        self.placer.solved(place)
    }

    /// Position of a solution, in the turn nearest to the axis values `near`.
    fn nearest_turn(
        &self,
        pose: &Pose,
        from: &AxisPosition,
        solution: &Solution<RotaryAngles>,
        near: &AxisValues,
    ) -> Result<AxisPosition, Fault> {
        let words = self.nearest_words(solution, near);
        for rotary in &self.placer.rotary.axes {
            let word = words[rotary.index];
            if !rotary.contains(word) {
                return Err(refusal::outside_limits(self.placer, &[Some(OutOfLimits { rotary: *rotary, word }), None]));
            }
        }
        let mut place = self.placer.position_at(pose, from, &words);
        place.deviation_rad = solution.deviation;
        place.branch = solution.branch;
        self.placer.hold_indexed(&mut place, from, self.allowed)?;
        self.placer.solved(place)
    }

    fn spot(&self, start: &AxisPosition, target: &AxisPosition) -> SpotRotation {
        let largest =
            self.placer.rotary.axes.iter().map(|rotary| target.words[rotary.index].abs_diff(start.words[rotary.index]));
        let units = largest.max().unwrap_or(0).max(1);
        SpotRotation { start: *start, target: *target, resolution: 1.0 / units as f64, at: 0.0, stride: 0.5 }
    }

    /// Position at a parameter of a rotation on the spot.
    fn rotated(&self, spot: &SpotRotation, parameter: f64) -> Result<AxisPosition, Fault> {
        let words = self.words_between(&spot.start.words, &spot.target.words, parameter);
        let tip = spot.start.pose.tip + (spot.target.pose.tip - spot.start.pose.tip) * parameter;
        let pose = Pose { tip, axis: spot.target.pose.axis };
        let mut place = self.placer.position_at(&pose, &spot.start, &words);
        let reached = self.placer.machine.forward_kinematics(&place.axes).axis;
        place.deviation_rad = (reached.into_inner() - pose.axis.into_inner()).norm();
        self.placer.solved(place)
    }

    /// The fault that a rotation on the spot does not certify.
    #[cold]
    fn uncertified(&self, from: &AxisPosition, to: &AxisPosition) -> Fault {
        let rotated = self
            .placer
            .rotary
            .axes
            .iter()
            .max_by_key(|rotary| from.words[rotary.index].abs_diff(to.words[rotary.index]));
        let index = rotated.map_or(0, |rotary| rotary.index);
        let shown = |place: &AxisPosition| {
            rotated.map_or(0.0, |rotary| rotary.degrees_for_display(place.words[index], self.placer.rotary.scale))
        };
        plan::POLE.fault(format_args!(
            "before this point {} would have to rotate from {}° to {}° on the spot, which moves the tool axis or the tip \
             out of tolerance ({}, {:.4}°)",
            self.placer.chain()[index].letter,
            shown(from),
            shown(to),
            self.placer.units().length(self.allowed.tip_mm),
            self.allowed.axis_rad.to_degrees(),
        ))
        .help("retract before this point and start a new operation, or keep the tool axis away from the pole")
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;
    use crate::config::Config;
    use crate::kinematics::machines::Cb;
    use crate::program::Units;

    const TOLERANCE: PathTolerance = PathTolerance { tip_mm: 0.01, axis_rad: 0.001_745 };

    fn placer() -> Placer {
        let config = Config::default();
        Placer::new(Box::new(config.set_up.machine::<Cb>().expect("valid")), config.policy(), Units::Millimetres)
    }

    /// Position at rotary angles in degrees.
    fn place(placer: &Placer, tip: [f64; 3], c: f64, b: f64) -> AxisPosition {
        let mut place = placer.zero();
        place.words[0] = placer.scale().word(c.to_radians());
        place.words[1] = placer.scale().word(b.to_radians());
        let axes = [c.to_radians(), b.to_radians(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let axis = placer.machine.forward_kinematics(&axes).axis;
        let words = place.words;
        placer.solved(placer.position_at(&Pose { tip: Point3::from(tip), axis }, &place, &words)).expect("a place")
    }

    fn pieces(placer: &Placer, from: &AxisPosition, to: &AxisPosition) -> Result<Vec<CertifiedPiece>, Fault> {
        let mut pieces = Linearised::new(from, to, TOLERANCE, RotationLaw::GreatCircle);
        let mut list = Vec::new();
        while let Some(piece) = pieces.next(placer)? {
            list.push(piece);
        }
        Ok(list)
    }

    #[test]
    fn a_free_axis_rotates_at_the_pole_in_steps_of_its_value() {
        let placer = placer();
        let tip = [40.0, 10.0, 3.0];
        let (from, to) = (place(&placer, tip, 0.0, 0.0), place(&placer, tip, 90.0, 0.0));
        let pieces = pieces(&placer, &from, &to).expect("certified");
        // Chords of a quarter circle of radius √(40² + 10²) within 0.01 mm less rounding.
        assert!((36..40).contains(&pieces.len()), "{}", pieces.len());
        let mut last = from;
        for piece in &pieces {
            assert!(piece.bound.tip <= TOLERANCE.tip_mm && piece.bound.axis <= TOLERANCE.axis_rad);
            assert!(piece.place.words[0] > last.words[0] && piece.place.words[1] == 0);
            let tip = placer.machine.forward_kinematics(&piece.place.axes).tip;
            assert!((tip - to.pose.tip).norm() <= piece.place.rounding_mm + 1e-12);
            last = piece.place;
        }
        assert_eq!(last, to);
    }

    #[test]
    fn a_revolution_away_from_the_pole_is_no_rotation_on_the_spot() {
        let placer = placer();
        let tip = [40.0, 10.0, 3.0];
        let (from, to) = (place(&placer, tip, 0.0, 20.0), place(&placer, tip, 360.0, 20.0));
        let fault = pieces(&placer, &from, &to).expect_err("the tool axis would go round");
        let text = fault.at(crate::program::Location::default(), crate::diag::Severity::Error).text;
        assert!(text.contains("to 360° on the spot"), "{text}");
    }

    #[test]
    fn points_in_between_are_poses_of_the_path() {
        let placer = placer();
        let (from, to) = (place(&placer, [0.0; 3], 0.0, 30.0), place(&placer, [30.0, 40.0, 0.0], 60.0, 50.0));
        let line = to.pose.tip - from.pose.tip;
        let normal = from.pose.axis.cross(&to.pose.axis).normalize();
        let mut before = -1.0;
        for piece in pieces(&placer, &from, &to).expect("certified") {
            let pose = placer.machine.forward_kinematics(&piece.place.axes);
            let along = (pose.tip - from.pose.tip).dot(&line) / line.norm_squared();
            assert!((from.pose.tip + line * along - pose.tip).norm() < 0.001);
            assert!(pose.axis.dot(&normal).abs() < 3e-6);
            let rotated = from.pose.axis.angle(&pose.axis) / from.pose.axis.angle(&to.pose.axis);
            assert!((rotated - along).abs() < 1e-4, "the axis rotates evenly: {rotated} at {along}");
            assert!(along > before);
            before = along;
        }
    }
}
