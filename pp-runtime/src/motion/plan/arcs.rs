//! Arcs, written as arcs of the control where possible, else as chords.
//!
//! While the rotary axes rest, the map from workpiece to program coordinates is affine. An arc is written as an arc if
//! the linear part of that map is orthogonal, if the axis of the circle is an axis of the program, and if the arc that
//! the control traces from the rounded words stays within tolerance of the arc of the CL data: see
//! `motion/geometry/circle`. More than a full circle is split into full circles and the rest; where these do not stay
//! within tolerance, into equal arcs of at most half a circle.

use std::f64::consts::{PI, TAU};

use crate::diag::code::plan;
use crate::kinematics::{Pose, math};
use crate::nalgebra::Vector3;
use crate::options::{ArcForm, ArcOutput};
use crate::program::{Arc, Move};

use crate::motion::fault::{Fault, ItemError, Planned};
use crate::motion::geometry::ArcGeometry;
use crate::motion::geometry::{ArcPlane, Circle, CircleDeviation, NominalCircle, WordGrid};
use crate::motion::place::AxisPosition;
use crate::motion::plan::Planner;
use crate::motion::plan::cutter::WrittenArc;
use crate::motion::plan::feed::FeedMotion;
use crate::motion::plan::statistics::Statistics;
use crate::motion::rotary::RotaryTarget;
use crate::motion::source::MotionIndex;
use crate::motion::step::BlockReason;
use crate::motion::step::{AxisWords, FeedWord, Sink, Step};
use crate::tolerance::writer::{ARC_END_DRIFT, LARGEST_LONG_WAY, MOST_REVOLUTIONS, ROUNDED_END, WHOLE_REVOLUTIONS};

/// Reason why an arc is not written as an arc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum NoArc {
    /// `arcs.output` is `lines`.
    Configured,
    /// It deviates from a line by less than the resolution of the words.
    Straight,
    /// A rotary axis rotates, or the coordinates of the program are not orthogonal.
    Frame,
    /// It is not parallel to a plane of the program, or the control has no arcs in that plane.
    Plane,
    /// Its radius is outside the configured range.
    Radius,
    /// Rounded words would leave the tolerance.
    Rounding,
}

impl Statistics {
    /// Counts an arc written as chords.
    fn count_chorded(&mut self, why: NoArc) {
        let count = match why {
            NoArc::Configured | NoArc::Straight => return,
            NoArc::Frame => &mut self.chorded.frame,
            NoArc::Plane => &mut self.chorded.plane,
            NoArc::Radius => &mut self.chorded.radius,
            NoArc::Rounding => &mut self.chorded.rounding,
        };
        *count += 1;
    }
}

/// Division of an arc: into full circles and the rest, or into equal arcs.
#[derive(Debug, Clone, Copy)]
struct Cuts {
    pieces: u32,
    /// Part of the arc in one piece; the last piece may be smaller.
    part: f64,
}

impl Cuts {
    /// Both divisions of an arc, the preferred one first; none for too many revolutions.
    fn of(angle_rad: f64) -> Option<[Self; 2]> {
        let revolutions = if angle_rad <= TAU { 1.0 } else { (angle_rad / TAU - WHOLE_REVOLUTIONS).ceil().max(1.0) };
        (revolutions <= MOST_REVOLUTIONS).then(|| {
            let (whole, halves) = (revolutions as u32, 2 * revolutions as u32);
            [Self { pieces: whole, part: TAU / angle_rad }, Self { pieces: halves, part: 1.0 / f64::from(halves) }]
        })
    }

    /// Part of the arc up to the end of a piece, counted from 1.
    fn end(&self, piece: u32) -> f64 {
        if piece >= self.pieces { 1.0 } else { self.part * f64::from(piece) }
    }

    /// Part of the arc in a piece.
    fn share(&self, piece: u32) -> f64 {
        self.end(piece) - self.part * f64::from(piece - 1)
    }
}

/// An arc in program coordinates.
#[derive(Debug, Clone, Copy)]
struct ArcInProgram {
    plane: ArcPlane,
    chain: [usize; 3],
    nominal: NominalCircle,
    /// Largest distance between the planes of the arc and of the program along the arc.
    lean_mm: f64,
}

/// Start of a piece of an arc.
#[derive(Clone, Copy)]
struct PieceStart<'p> {
    place: &'p AxisPosition,
    /// Distance of the tool from the start of the words of the piece, in units.
    drift: [f64; 2],
}

/// A piece of an arc in words.
struct ArcPiece {
    circle: Circle,
    /// Distance between its end and the end of its words, in units.
    drift: [f64; 2],
}

/// Whether an arc of less than a rad deviates from its chord by less than `least`.
fn is_straight(angle_rad: f64, radius: f64, least: f64) -> bool {
    // The cosine of half the angle is at most 1 - 0.97 angle²/8.
    let is_flat = || radius * (1.0 - math::sin_cos(0.5 * angle_rad).1) < least;
    angle_rad < 1.0 && radius * (0.97 / 8.0) * angle_rad * angle_rad < least && is_flat()
}

fn cannot_be_written() -> Fault {
    plan::ARC.fault("an arc within tolerance cannot be written")
}

/// Plans an arc from the present position of the tool.
#[cold]
pub(crate) fn arc<S: Sink>(planner: &mut Planner<'_, S>, arc: &Arc, index: MotionIndex) -> Planned {
    let round = ArcGeometry::new(arc);
    if planner.cutter.is_idle() {
        return ArcRun { planner, arc, round }.run(index).map(drop);
    }
    let from = *planner.mover.here();
    let (cutter, site) = planner.compensation();
    cutter.check_arc(arc, &site)?;
    let written = ArcRun { planner: &mut *planner, arc, round }.run(index)?;
    let (cutter, site) = planner.compensation();
    Ok(cutter.after_arc(written, &from, &site)?)
}

/// One arc that is being planned.
struct ArcRun<'p, 'a, 'r, S> {
    planner: &'p mut Planner<'a, S>,
    arc: &'r Arc,
    round: ArcGeometry<'r>,
}

impl<S: Sink> ArcRun<'_, '_, '_, S> {
    fn run(&mut self, index: MotionIndex) -> Result<WrittenArc, ItemError> {
        let arc = self.arc;
        let motion = Move { pose: arc.end, rapid: false, feed: arc.feed };
        self.planner.stop_spindle()?;
        if self.planner.has_floor() {
            for part in self.round.extremes(Vector3::z()) {
                let pose = Pose { tip: self.round.tip(part), ..arc.end };
                self.planner.check_state(&Move { pose, ..motion })?;
            }
        }
        self.planner.check_state(&motion)?;
        self.check_meant()?;
        self.planner.reach_stretch(&motion, index)?;
        let planned = self.planner.apply_course_changes(&motion, index)?;
        self.planner.restart_after_thread()?;
        let end = self.planner.mover.place(&arc.end, true, planned)?;
        let written = match self.trace(&end)? {
            Ok(()) => {
                self.statistics().arcs += 1;
                WrittenArc::Arcs
            }
            Err(why) => {
                self.statistics().count_chorded(why);
                self.write_chords(planned)?;
                if why == NoArc::Straight { WrittenArc::Chord } else { WrittenArc::Chords }
            }
        };
        let position = self.planner.mover.position_mut();
        for part in self.round.extremes(arc.end.axis.into_inner()) {
            position.note_cut(&Pose { tip: self.round.tip(part), ..arc.end });
        }
        position.note_cut(&arc.end);
        position.forget_lead_out();
        self.planner.mover.arrive(&end);
        Ok(written)
    }

    /// Refuses the long way round a circle that no machine holds: nearly always the sense of a flat arc is wrong. Where
    /// the travel is known, that decides.
    fn check_meant(&self) -> Result<(), Fault> {
        let radius = self.round.radius();
        if self.arc.angle_rad <= PI || radius <= LARGEST_LONG_WAY || self.planner.mover.placer().travel_is_known() {
            return Ok(());
        }
        let degrees = self.arc.angle_rad.to_degrees();
        Err(plan::ARC
            .fault(format_args!(
                "this arc goes {degrees:.3} degrees round a circle with a radius of {}",
                self.planner.mover.placer().units().length(radius)
            ))
            .help("check its sense: `--circle-sense`; if the machine holds the circle, state its travel in `[limits]`"))
    }

    fn statistics(&mut self) -> &mut Statistics {
        self.planner.mover.output_mut().statistics_mut()
    }

    /// Writes the arc as arcs of the control; writes nothing if one of them would leave the tolerance.
    fn trace(&mut self, end: &AxisPosition) -> Result<Result<(), NoArc>, ItemError> {
        let in_program = match self.in_program(end) {
            Ok(in_program) => in_program,
            Err(why) => return Ok(Err(why)),
        };
        let end = &self.piece_end(1.0)?;
        let Some(divisions) = Cuts::of(self.arc.angle_rad) else { return Ok(Err(NoArc::Rounding)) };
        for cuts in divisions {
            if let Some(last) = self.last_piece(&in_program, cuts, end)? {
                self.check_travel()?;
                return self.write_pieces(&in_program, cuts, &last, end).map(Ok);
            }
        }
        Ok(Err(NoArc::Rounding))
    }

    /// The arc in program coordinates.
    fn in_program(&self, end: &AxisPosition) -> Result<ArcInProgram, NoArc> {
        let (arc, round) = (self.arc, &self.round);
        let (setup, placer) = (&self.planner.policy.options.arcs, self.planner.mover.placer());
        if setup.output == ArcOutput::Lines {
            return Err(NoArc::Configured);
        }
        if is_straight(arc.angle_rad, round.radius(), 0.5 * placer.unit_mm()) {
            return Err(NoArc::Straight);
        }
        if self.planner.mover.rotates(end) {
            return Err(NoArc::Frame);
        }
        let (chain, map) = placer.orthogonal_map(end).ok_or(NoArc::Frame)?;
        // Mirrored coordinates reverse the sense of rotation.
        let normal = map * arc.normal.into_inner() * map.determinant().signum();
        let perpendicular = normal.iamax();
        let plane = ArcPlane::PERPENDICULAR_TO[perpendicular];
        let in_plane = plane.axes();
        let lean_mm = 2.0 * round.radius() * math::hypot(normal[in_plane[0]], normal[in_plane[1]]);
        if lean_mm > self.planner.mover.tolerance().tip_mm || !self.planner.has_arcs(perpendicular) {
            return Err(NoArc::Plane);
        }
        if !(setup.smallest_radius_mm..=setup.largest_radius_mm).contains(&round.radius()) {
            return Err(NoArc::Radius);
        }
        let centre = placer.program_point(&arc.centre, end).ok_or(NoArc::Frame)?;
        let [first, second, _] = plane.axes();
        let nominal = NominalCircle {
            centre_mm: [centre[first], centre[second]],
            radii_mm: round.radii_mm,
            clockwise: normal[perpendicular] < 0.0,
            sweep_rad: arc.angle_rad,
        };
        Ok(ArcInProgram { plane, chain, nominal, lean_mm })
    }

    /// The last piece, if all stay within tolerance: nearly every arc has no other. `end`: its end.
    fn last_piece(
        &mut self,
        in_program: &ArcInProgram,
        cuts: Cuts,
        end: &AxisPosition,
    ) -> Result<Option<ArcPiece>, Fault> {
        let mut before: Option<(AxisPosition, [f64; 2])> = None;
        for number in 1..cuts.pieces {
            let to = self.piece_end(cuts.end(number))?;
            let piece = self.piece(in_program, cuts.share(number), self.end_of(before.as_ref()), &to);
            let Some(ArcPiece { drift, .. }) = piece else { return Ok(None) };
            before = Some((to, drift));
        }
        let last = self.piece(in_program, cuts.share(cuts.pieces), self.end_of(before.as_ref()), end);
        Ok(last.filter(|last| math::hypot(last.drift[0], last.drift[1]) <= ARC_END_DRIFT))
    }

    /// Start of a piece: the end of the one before it, or the present place.
    fn end_of<'s>(&'s self, before: Option<&'s (AxisPosition, [f64; 2])>) -> PieceStart<'s> {
        let here = || PieceStart { place: self.planner.mover.here(), drift: self.start_drift() };
        before.map_or_else(here, |(place, drift)| PieceStart { place, drift: *drift })
    }

    /// Distance of the tool from its words, after an arc by its angle.
    fn start_drift(&self) -> [f64; 2] {
        let here = self.planner.mover.placer().written(self.planner.mover.here());
        self.planner.arc_end.filter(|(words, _)| *words == here).map_or([0.0; 2], |(_, drift)| drift)
    }

    /// A piece, `share` of the arc, if it stays within tolerance.
    fn piece(
        &self,
        in_program: &ArcInProgram,
        share: f64,
        from: PieceStart<'_>,
        to: &AxisPosition,
    ) -> Option<ArcPiece> {
        let circle = self.circle(in_program, share, from, to)?;
        Some(ArcPiece { drift: self.drift(&circle, from.drift, to), circle })
    }

    /// Distance between the end of a piece and the end of its words, in units.
    fn drift(&self, circle: &Circle, before: [f64; 2], to: &AxisPosition) -> [f64; 2] {
        if circle.rise == 0 || !self.planner.abilities.helix_by_angle {
            return [0.0; 2];
        }
        let (to, [first, second, _]) = (self.planner.mover.placer().written(to), circle.plane.axes());
        circle.drift(before, [to[circle.chain[first]], to[circle.chain[second]]])
    }

    /// The place at a part of the arc, with the rotary axes at their present angles.
    fn piece_end(&mut self, part: f64) -> Result<AxisPosition, Fault> {
        let here = *self.planner.mover.here();
        self.planner.mover.shifted(self.round.tip(part), &here)
    }

    /// The words of one piece, `share` of the arc, if they stay within tolerance.
    fn circle(&self, in_program: &ArcInProgram, share: f64, from: PieceStart<'_>, to: &AxisPosition) -> Option<Circle> {
        let (placer, tolerance) = (self.planner.mover.placer(), self.planner.mover.tolerance().tip_mm);
        let PieceStart { place: from, drift } = from;
        let (from, to) = (placer.written(from), placer.written(to));
        let ArcInProgram { plane, chain, nominal, lean_mm } = *in_program;
        let [first, second, perpendicular] = plane.axes().map(|axis| chain[axis]);
        let (start, end) = ([from[first], from[second]], [to[first], to[second]]);
        let unit = placer.unit_mm();
        let grid =
            WordGrid { units_per_mm: 1.0 / unit, radius_tolerance_mm: self.planner.abilities.arc_radius_tolerance_mm };
        let nominal = NominalCircle { sweep_rad: nominal.sweep_rad * share, ..nominal };
        let fit = nominal.fit(start, end, grid)?;
        // The height is proportional to the angle. Seen from the nominal centre, a point leads by the displacement of
        // the centre, by as much again because the ends do not lead, and by their rounding; heights are rounded, too.
        let height = |deviation: CircleDeviation| {
            lean_mm + 0.5 * unit + self.round.slope().abs() * (2.0 * deviation.centre_mm + ROUNDED_END * unit)
        };
        let drifted = unit * math::hypot(drift[0], drift[1]);
        let within =
            |deviation: CircleDeviation| math::hypot(deviation.plane_mm, height(deviation)) + drifted <= tolerance;
        let fits = within(fit.largest_deviation) || within(nominal.deviation([start, end], &fit, grid));
        if !fits || placer.too_large([fit.centre[0] - start[0], fit.centre[1] - start[1]], [first, second]) {
            return None;
        }
        let radius = match self.planner.policy.options.arcs.form {
            ArcForm::Centre => None,
            // Its centre follows from its start.
            ArcForm::Radius if drifted > 0.0 => None,
            ArcForm::Radius => nominal.radius(start, end, &fit, grid).filter(|(_, deviation)| within(*deviation)),
        };
        Some(Circle {
            plane,
            chain,
            clockwise: nominal.clockwise,
            start,
            centre: fit.centre,
            radius: radius.map(|(units, _)| units),
            sweep_rad: fit.sweep_rad,
            rise: to[perpendicular] - from[perpendicular],
        })
    }

    /// Checks the limits of each linear axis at the extremes of the arc along it.
    fn check_travel(&mut self) -> Result<(), Fault> {
        let (round, placer, here) = (self.round, self.planner.mover.placer(), self.planner.mover.here());
        let reach_mm = round.diameter_mm() + (here.pose.tip - self.arc.start.tip).norm();
        if placer.needs_no_travel(here, reach_mm, |direction| round.bounds(direction)) {
            return Ok(());
        }
        let Some((_, map)) = placer.axis_map(here) else { return Ok(()) };
        for row in 0..3 {
            for part in round.extremes(map.row(row).transpose()) {
                self.piece_end(part)?;
            }
        }
        Ok(())
    }

    /// Writes the pieces of the arc. `last`: the last of them; `end`: its end.
    fn write_pieces(&mut self, in_program: &ArcInProgram, cuts: Cuts, last: &ArcPiece, end: &AxisPosition) -> Planned {
        let rate = self.planner.rate(self.arc.feed)?;
        self.planner.mover.output_mut().set_reason(if cuts.pieces > 1 {
            BlockReason::SplitArc
        } else {
            BlockReason::Record
        });
        let mut drift = self.start_drift();
        for number in 1..cuts.pieces {
            let (share, to) = (cuts.share(number), self.piece_end(cuts.end(number))?);
            let piece = self.piece(in_program, share, PieceStart { place: self.planner.mover.here(), drift }, &to);
            let piece = piece.ok_or_else(cannot_be_written)?;
            self.write_piece(&piece.circle, &to, share, drift, rate)?;
            self.planner.mover.position_mut().go_to(&to);
            drift = piece.drift;
        }
        self.write_piece(&last.circle, end, cuts.share(cuts.pieces), drift, rate)?;
        self.planner.arc_end = Some((self.planner.mover.placer().written(end), last.drift));
        Ok(())
    }

    /// Writes a piece, `share` of the arc, at `rate` mm/min with the words of the axes of its chain. `drift`: distance
    /// of its start from the start of its words, in units.
    fn write_piece(&mut self, circle: &Circle, to: &AxisPosition, share: f64, drift: [f64; 2], rate: f64) -> Planned {
        let length = self.round.length() * share;
        let mover = &mut self.planner.mover;
        let placer = mover.placer();
        let (_, map) = placer.orthogonal_map(to).ok_or_else(cannot_be_written)?;
        let (words, [first, second, _]) = (placer.written(to), circle.plane.axes());
        let end = [words[circle.chain[first]], words[circle.chain[second]]];
        let along = |direction: Vector3<f64>| placer.unit_mm() * circle.fastest_along(&(map * direction), drift, end);
        let axis_time_min = placer.least_minutes_of_tip(mover.here(), along);
        let pace = mover.feeds().pace(rate, FeedMotion::linear(length, axis_time_min))?;
        let FeedWord::PerMinute(feed) = pace.feed else { return Err(cannot_be_written().into()) };
        mover.output_mut().feed(&pace, None);
        let mask = circle.chain.iter().fold(0, |mask, axis| mask | 1 << axis);
        let words = AxisWords { vector: None, ..mover.placer().words(to, mask) };
        mover.write_motion(&Step::Arc { words, circle, feed }, to)?;
        let (cutter, site) = self.planner.compensation();
        Ok(cutter.arc_piece(circle, to, &site)?)
    }

    /// Writes the arc as chords within the tolerance.
    fn write_chords(&mut self, planned: Option<RotaryTarget>) -> Planned {
        self.planner.mover.output_mut().set_reason(BlockReason::Chord);
        let chords = self.round.chords(self.planner.mover.tolerance().tip_mm)?;
        for index in 1..=chords {
            let tip = self.round.tip(f64::from(index) / f64::from(chords));
            let pose = Pose { tip, axis: self.arc.end.axis };
            let place = self.planner.mover.place(&pose, true, planned.filter(|_| index == chords))?;
            let rate = self.planner.rate(self.arc.feed)?;
            self.planner.mover.feed_to(&place, rate)?;
            self.planner.mover.position_mut().go_to(&place);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
