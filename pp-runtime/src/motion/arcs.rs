//! Arcs by the control where it can say them, else by chords.
//!
//! With the rotary axes still, the map from the workpiece to the program's coordinates is affine. An arc is left to the
//! control if the linear part of that map is orthogonal, if the axis of the circle becomes an axis of the program, and if
//! what the control makes of the rounded words stays within tolerance of the arc of the CL data: see [`super::circle`].
//! More turns than one are cut into whole turns and the rest; where these cannot be said, into equal arcs of no more than
//! half a turn.

use std::f64::consts::TAU;

use super::options::{ArcForm, ArcOutput};
use crate::kinematics::{Machine, Pose};
use crate::nalgebra::Vector3;
use crate::program::{Arc, Location, Move};

use super::account::Why;
use super::arc::Round;
use super::circle::{Circle, Grid, Nominal, Off, Plane};
use super::course::Target;
use super::fault::Fault;
use super::feed::{Feeds, Stroke};
use super::place::Place;
use super::planner::{Phase, Planned, Planner, Statistics, Stop, stop};
use super::step::{Feed, Sink, Step, Words};

/// More turns than this of one record are a fault of the file.
const MOST_TURNS: f64 = 1e6;

/// How far rounding moves an end in its plane, units: half the diagonal of a square.
const ROUNDED: f64 = 0.7072;

/// Turns that are whole but for arithmetic.
const WHOLE: f64 = 1e-9;

/// Why an arc is not left to the control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NoArc {
    /// The configuration wants lines.
    Configured,
    /// It is no more than a line in the words of the program.
    Straight,
    /// A rotary axis turns, or the program's coordinates are not square.
    Frame,
    /// Its plane is none of the program's, or none in which the control has arcs.
    Plane,
    /// Its radius is outside what is configured.
    Radius,
    /// Rounded words cannot say it within tolerance.
    Rounding,
}

/// Arcs that became chords, by reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Chorded {
    /// A rotary axis turns, or the program's coordinates are not square.
    pub frame: u64,
    /// The plane is none of the program's, or none in which the control has arcs.
    pub plane: u64,
    /// The radius is outside what is configured.
    pub radius: u64,
    /// Rounded words cannot say it within tolerance.
    pub rounding: u64,
}

impl Statistics {
    fn chorded(&mut self, why: NoArc) {
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

/// Where an arc is cut: into whole turns and the rest, or into equal arcs.
#[derive(Debug, Clone, Copy)]
struct Cuts {
    pieces: u32,
    /// Part of the arc that a piece is; the last one may be less.
    part: f64,
}

impl Cuts {
    /// Both ways to cut an arc, the one to be tried first in front; none where that is too many.
    fn of(angle: f64) -> Option<[Self; 2]> {
        let turns = (angle / TAU - WHOLE).ceil().max(1.0);
        (turns <= MOST_TURNS).then(|| {
            let (whole, halves) = (turns as u32, 2 * turns as u32);
            [Self { pieces: whole, part: TAU / angle }, Self { pieces: halves, part: 1.0 / f64::from(halves) }]
        })
    }

    /// The part of the arc at which a piece ends, counted from 1.
    fn end(&self, piece: u32) -> f64 {
        if piece >= self.pieces { 1.0 } else { self.part * f64::from(piece) }
    }

    /// The part of the arc that a piece is.
    fn share(&self, piece: u32) -> f64 {
        self.end(piece) - self.part * f64::from(piece - 1)
    }
}

/// An arc in the coordinates of the program.
#[derive(Debug, Clone, Copy)]
struct Framed {
    plane: Plane,
    chain: [usize; 3],
    nominal: Nominal,
    /// How far the plane of the arc is off that of the program, over the arc, mm.
    lean: f64,
}

impl<M: Machine> Planner<'_, M> {
    /// An arc from where the tool stands.
    #[cold]
    pub(super) fn arc(&mut self, at: Location, arc: &Arc, sink: &mut impl Sink) -> Planned {
        let number = self.counted;
        self.counted += 1;
        let fault = |fault: Fault| stop(at, fault);
        let motion = Move { pose: arc.end, rapid: false, feed: arc.feed };
        if self.phase == Phase::Start {
            // The tool has been led to where an arc begins, unless there is none.
            let missing = self.check_state(&motion).err();
            return Err(fault(missing.unwrap_or_else(|| Fault::new("nobody knows where this arc begins"))));
        }
        self.settle(None, sink)?;
        if self.selection.over {
            return Ok(());
        }
        sink.serve(at, Why::Record);
        self.stop_spindle(sink)?;
        let round = Round::new(arc);
        for part in round.extremes(Vector3::z()).chain([1.0]) {
            let pose = Pose { tip: round.tip(part), ..arc.end };
            self.check_state(&Move { pose, ..motion }).map_err(fault)?;
        }
        let planned = self.changes(at, &motion, number, sink)?;
        if std::mem::take(&mut self.tapped) {
            self.turn_spindle(at, true, sink)?;
        }
        let end = self.placer.place(&arc.end, &self.place, true, planned).map_err(fault)?;
        match self.round(at, arc, &round, &end, sink)? {
            Ok(()) => self.statistics.arcs += 1,
            Err(why) => {
                self.statistics.chorded(why);
                self.chords(at, arc, &round, planned, sink)?;
            }
        }
        for part in round.extremes(arc.end.axis.into_inner()).chain([1.0]) {
            self.cut(&Pose { tip: round.tip(part), ..arc.end });
        }
        self.retreat.reset();
        self.arrive(end);
        Ok(())
    }

    /// Writes an arc as arcs of the control; nothing is written where one of them cannot be said.
    fn round(
        &mut self,
        at: Location,
        arc: &Arc,
        round: &Round<'_>,
        end: &Place<M::Axes>,
        sink: &mut impl Sink,
    ) -> Result<Result<(), NoArc>, Stop> {
        let framed = match self.framed(arc, round, end) {
            Ok(framed) => framed,
            Err(why) => return Ok(Err(why)),
        };
        for cuts in Cuts::of(arc.angle).into_iter().flatten() {
            if self.said(at, round, &framed, cuts)? {
                self.check_travel(at, round)?;
                return self.write_pieces(at, arc, round, &framed, cuts, sink).map(Ok);
            }
        }
        Ok(Err(NoArc::Rounding))
    }

    /// The arc in the program's coordinates.
    fn framed(&self, arc: &Arc, round: &Round<'_>, end: &Place<M::Axes>) -> Result<Framed, NoArc> {
        let setup = &self.policy.options.arcs;
        if setup.output == ArcOutput::Lines {
            return Err(NoArc::Configured);
        }
        if round.radius() * (1.0 - (0.5 * arc.angle).cos()) < 0.5 * self.placer.unit_mm() && arc.angle < 1.0 {
            return Err(NoArc::Straight);
        }
        if self.placer.rotary_travel(&self.place.words, &end.words) > 0.0 {
            return Err(NoArc::Frame);
        }
        let (chain, map) = self.placer.square_map(end).ok_or(NoArc::Frame)?;
        // Mirrored coordinates turn the other way round.
        let normal = map * arc.normal.into_inner() * map.determinant().signum();
        let square = normal.iamax();
        let beside = Plane::SQUARE_TO[square].axes();
        let lean = 2.0 * round.radius() * normal[beside[0]].hypot(normal[beside[1]]);
        let plane = Plane::SQUARE_TO[square];
        if lean > self.tolerance.tip || !self.abilities.arc_planes[square] {
            return Err(NoArc::Plane);
        }
        if !(setup.smallest_radius..=setup.largest_radius).contains(&round.radius()) {
            return Err(NoArc::Radius);
        }
        let centre = self.placer.program_point(&arc.centre, end).ok_or(NoArc::Frame)?;
        let [first, second, _] = plane.axes();
        let nominal = Nominal {
            centre: [centre[first], centre[second]],
            radii: round.radii,
            clockwise: normal[square] < 0.0,
            sweep: arc.angle,
        };
        Ok(Framed { plane, chain, nominal, lean })
    }

    /// Whether all pieces can be said.
    fn said(&mut self, at: Location, round: &Round<'_>, framed: &Framed, cuts: Cuts) -> Result<bool, Stop> {
        let mut from = self.place;
        for piece in 1..=cuts.pieces {
            let to = self.piece_end(at, round, cuts.end(piece))?;
            if self.circle(framed, round, cuts.share(piece), &from, &to).is_none() {
                return Ok(false);
            }
            from = to;
        }
        Ok(true)
    }

    /// Where a part of the arc ends; the rotary axes stand as they do.
    fn piece_end(&mut self, at: Location, round: &Round<'_>, part: f64) -> Result<Place<M::Axes>, Stop> {
        self.placer.shifted(round.tip(part), &self.place).map_err(|fault| stop(at, fault))
    }

    /// The words of one piece, `share` of the arc, if they say it within tolerance.
    fn circle(
        &self,
        framed: &Framed,
        round: &Round<'_>,
        share: f64,
        from: &Place<M::Axes>,
        to: &Place<M::Axes>,
    ) -> Option<Circle> {
        let (from, to) = (self.placer.written(from), self.placer.written(to));
        let Framed { plane, chain, nominal, lean } = *framed;
        let [first, second, square] = plane.axes().map(|axis| chain[axis]);
        let (start, end) = ([from[first], from[second]], [to[first], to[second]]);
        let unit = self.placer.unit_mm();
        let grid = Grid { per_mm: 1.0 / unit, radius_tolerance: self.abilities.arc_radius_tolerance };
        let nominal = Nominal { sweep: nominal.sweep * share, ..nominal };
        let fit = nominal.fit(start, end, grid)?;
        // Height goes with the angle. Seen from the nominal centre a point leads by what the centre is off, and by as much
        // more because the ends do not, and by the rounding of these; heights are rounded themselves.
        let height = |off: Off| lean + 0.5 * unit + round.slope().abs() * (2.0 * off.centre + ROUNDED * unit);
        let within = |off: Off| off.plane.hypot(height(off)) <= self.tolerance.tip;
        if !within(fit.off)
            || self.placer.too_large([fit.centre[0] - start[0], fit.centre[1] - start[1]], [first, second])
        {
            return None;
        }
        let radius = match self.policy.options.arcs.form {
            ArcForm::Centre => None,
            ArcForm::Radius => nominal.radius(start, end, &fit, grid).filter(|(_, off)| within(*off)),
        };
        Some(Circle {
            plane,
            chain,
            clockwise: nominal.clockwise,
            start,
            centre: fit.centre,
            radius: radius.map(|(units, _)| units),
            sweep: fit.sweep,
            rise: to[square] - from[square],
        })
    }

    /// Limits of the linear axes where an arc is furthest along each of them.
    fn check_travel(&mut self, at: Location, round: &Round<'_>) -> Planned {
        let Some((_, map)) = self.placer.axis_map(&self.place) else { return Ok(()) };
        for row in 0..3 {
            for part in round.extremes(map.row(row).transpose()) {
                self.piece_end(at, round, part)?;
            }
        }
        Ok(())
    }

    fn write_pieces(
        &mut self,
        at: Location,
        arc: &Arc,
        round: &Round<'_>,
        framed: &Framed,
        cuts: Cuts,
        sink: &mut impl Sink,
    ) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let feed = arc.feed.ok_or_else(|| fault(Fault::new("a feed motion without feed")))?;
        let feed = Feeds::per_minute(feed, self.spindle.map(|(speed, _)| speed)).map_err(fault)?;
        sink.serve(at, if cuts.pieces > 1 { Why::SplitArc } else { Why::Record });
        let mask = framed.chain.iter().fold(0, |mask, axis| mask | 1 << axis);
        for piece in 1..=cuts.pieces {
            let share = cuts.share(piece);
            let length = round.length() * share;
            let least = self.placer.least_minutes_of_tip(length, &self.place);
            let stroke = Stroke { length, turn: 0.0, square: true, linear: length, degrees: 0.0, least };
            let pace = self.feeds.pace(feed, stroke).map_err(fault)?;
            let to = self.piece_end(at, round, cuts.end(piece))?;
            let circle = self.circle(framed, round, share, &self.place, &to);
            let (Some(circle), Feed::PerMinute(feed)) = (circle, pace.feed) else {
                return Err(fault(Fault::new("an arc that could be said cannot be written")));
            };
            self.times.cut(pace.minutes);
            if pace.slowed > 0.0 {
                self.times.slow(at, pace.slowed);
            }
            self.inverse_time = false;
            let words = Words { vector: None, ..self.placer.words(&to, mask) };
            sink.stand(&self.standing(&to, None));
            sink.step(&Step::Arc { words, circle: &circle, feed })?;
            self.place = to;
        }
        Ok(())
    }

    /// Writes an arc as chords that leave it by no more than the tolerance.
    fn chords(
        &mut self,
        at: Location,
        arc: &Arc,
        round: &Round<'_>,
        planned: Option<Target>,
        sink: &mut impl Sink,
    ) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        sink.serve(at, Why::Chord);
        let chords = round.chords(self.tolerance.tip).map_err(fault)?;
        for index in 1..=chords {
            let pose = Pose { tip: round.tip(f64::from(index) / f64::from(chords)), axis: arc.end.axis };
            let planned = planned.filter(|_| index == chords);
            let place = self.placer.place(&pose, &self.place, true, planned).map_err(fault)?;
            self.feed_to(at, &Move { pose, rapid: false, feed: arc.feed }, &place, sink)?;
            self.place = place;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
