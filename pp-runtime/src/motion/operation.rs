//! Motions inside an operation, and what must be true before each.

use super::options::{Mode, Rapid, Transition};
use crate::diag::Severity;
use crate::kinematics::{Machine, Pose};
use crate::program::{self, Location, Move};

use super::account::{Standing, Why};
use super::course::{Change, How, Target, Turns};
use super::fault::Fault;
use super::feed::{Feeds, Pace, Stroke};
use super::linearise::{Pieces, Tolerance};
use super::place::Place;
use super::planner::{Phase, Planned, Planner, SAME_AXIS, Stop, stop};
use super::step::{Feed, MAX_AXES, Sink, Step};
use super::way::Way;

/// A deviation of the tool axis up to this is arithmetic, rad.
const NO_DEVIATION: f64 = 1e-12;

/// A rapid this much below the lowest cut is remarked on, mm.
const PLUNGE: f64 = 0.001;

impl<M: Machine> Planner<'_, M> {
    /// What must be true before the tool moves to a point of the CL data.
    #[inline]
    pub(super) fn check_state(&self, motion: &Move) -> Result<(), Fault> {
        if let Some(floor) = self.policy.options.guards.floor
            && motion.pose.tip.z < floor
        {
            let tip = motion.pose.tip.z;
            return Err(Fault::new(format_args!("the tip goes to Z {tip:.4} mm, below `floor` = {floor:.4} mm")));
        }
        if self.tool.is_none() {
            if self.placer.head() {
                return Err(Fault::new(
                    "a motion before the first tool, and this machine turns the tool about its head",
                )
                .help("call the tool first: LOADTL/1,LENGTH,120"));
            }
            if !motion.rapid {
                return Err(Fault::new("a feed motion before the first tool").help("call a tool: LOADTL/1"));
            }
        }
        if self.upside_down {
            return Err(Fault::new("every tool axis of this program points into the table")
                .help("is the frame upside down? Turn it in CAM or with `part_rotation`; `table_check = false` posts it as it is"));
        }
        if motion.rapid {
            return Ok(());
        }
        if self.spindle.is_none() {
            return Err(if self.request.off {
                Fault::new("a feed motion with the spindle off").help("give SPINDL/ON before it")
            } else {
                Fault::new("a feed motion without spindle speed or direction since the tool was called").help(
                    "give SPINDL/RPM,..,CLW behind the tool call, or speed and direction of the tool in the configuration",
                )
            });
        }
        if motion.feed.is_none() {
            return Err(Fault::new("a feed motion without feed").help("give FEDRAT before it"));
        }
        Ok(())
    }

    /// How fast a motion of the CL data runs from where the tool stands to `to`.
    #[inline]
    pub(super) fn pace(&self, feed: Option<program::Feed>, to: &Place<M::Axes>) -> Result<Pace, Fault> {
        let feed = feed.ok_or_else(|| Fault::new("a feed motion without feed"))?;
        let per_minute = Feeds::per_minute(feed, self.spindle.map(|(speed, _)| speed))?;
        let (linear, degrees) =
            if self.feeds.counts_path() { self.placer.travelled(&self.place, to) } else { (0.0, 0.0) };
        let stroke = Stroke {
            length: (to.pose.tip - self.place.pose.tip).norm(),
            turn: self.placer.rotary_travel(&self.place.words, &to.words),
            square: self.placer.square(),
            linear,
            degrees,
            least: self.placer.least_minutes(&self.place, to).unwrap_or(0.0),
        };
        self.feeds.pace(per_minute, stroke)
    }

    /// A motion inside an operation.
    #[inline]
    pub(super) fn run(&mut self, at: Location, motion: &Move, number: u64, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        self.stop_spindle(sink)?;
        self.check_state(motion).map_err(fault)?;
        let planned = self.changes(at, motion, number, sink)?;
        self.go(at, motion, planned, sink)
    }

    /// A motion inside an operation of which the course has been asked.
    #[inline]
    pub(super) fn go(&mut self, at: Location, motion: &Move, planned: Option<Target>, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        if self.tapped && !motion.rapid {
            self.tapped = false;
            self.turn_spindle(at, true, sink)?;
        }
        let place = self.placer.place(&motion.pose, &self.place, !motion.rapid, planned).map_err(fault)?;
        let before = self.place.pose;
        if motion.rapid {
            if self.policy.options.rapids.transition == Transition::Safe && self.indexes(&place)
                || self.leaves_plane(&place)
            {
                self.phase = Phase::First { at, motion: *motion, planned, operation: false };
                return Ok(());
            }
            self.watch_plunge(at, &before, &motion.pose);
            self.rapid_to(at, motion, &place, sink)?;
        } else {
            self.feed_to(at, motion, &place, sink)?;
            self.cut(&motion.pose);
        }
        self.retreat.follow(&before, &motion.pose);
        self.arrive(place);
        Ok(())
    }

    /// Does what the course says about a motion before it begins, and gives the words in which it ends if the course
    /// says these, too.
    #[inline]
    pub(super) fn changes(
        &mut self,
        at: Location,
        motion: &Move,
        number: u64,
        sink: &mut impl Sink,
    ) -> Result<Option<Target>, Stop> {
        let (from, towards, mut planned) = (self.place.pose, self.towards.take(), None);
        while let Some(Change { how, words, .. }) = self.course.change(number) {
            match how {
                How::Take => planned = Some(Target { words, towards }),
                How::Rewind => self.rewind(at, motion, words, sink)?,
                How::Turn => self.cut_to(at, motion, self.place.pose, words, sink)?,
                How::Via(part) => {
                    let Some(way) = Way::new(&from, &motion.pose) else { continue };
                    self.cut_to(at, motion, way.at(part), words, sink)?;
                }
            }
        }
        if towards.is_some() && planned.is_none() {
            return Err(stop(at, self.no_way_round(motion)));
        }
        Ok(planned)
    }

    /// ROTABL/NEXT in front of a motion that cannot follow it.
    #[cold]
    fn no_way_round(&self, motion: &Move) -> Fault {
        let air = self.phase == Phase::Start || motion.rapid;
        Fault::new(match air {
            true => "the sense that ROTABL/NEXT asks for leads out of the limits",
            false => "ROTABL/NEXT stands in front of a cut, which cannot take the long way round",
        })
        .help("leave it out, or give it in front of a rapid or of an operation")
    }

    /// A cut on the way of a motion, to a pose that the CL data does not name.
    fn cut_to(&mut self, at: Location, motion: &Move, pose: Pose, words: Turns, sink: &mut impl Sink) -> Planned {
        let place = self
            .placer
            .place(&pose, &self.place, true, Some(Target { words, towards: None }))
            .map_err(|fault| stop(at, fault))?;
        self.statistics.inserted += u64::from(place.words != self.place.words);
        sink.serve(at, Why::Course);
        self.feed_to(at, &Move { pose, ..*motion }, &place, sink)?;
        self.cut(&pose);
        self.count_deviation(&place);
        self.place = place;
        sink.serve(at, Why::Record);
        Ok(())
    }

    /// A feed motion from where the tool stands.
    #[inline]
    pub(super) fn feed_to(
        &mut self,
        at: Location,
        motion: &Move,
        place: &Place<M::Axes>,
        sink: &mut impl Sink,
    ) -> Planned {
        if self.placer.rotary_travel(&self.place.words, &place.words) > 0.0 {
            if self.leaves_plane(place) {
                return Err(stop(at, self.turns_in_plane()));
            }
            return self.feed_in_pieces(at, motion, place, self.tolerance, sink);
        }
        let pace = self.pace(motion.feed, place).map_err(|fault| stop(at, fault))?;
        self.write_feed(at, place, pace, None, sink)
    }

    /// A feed motion that turns a rotary axis: as many blocks as it takes for tip and tool axis to stay within tolerance.
    pub(super) fn feed_in_pieces(
        &mut self,
        at: Location,
        motion: &Move,
        place: &Place<M::Axes>,
        tolerance: Tolerance,
        sink: &mut impl Sink,
    ) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        let mut pieces = Pieces::new(&self.place, place, tolerance);
        let mut blocks = 0;
        while let Some(piece) = pieces.next(&self.placer).map_err(fault)? {
            self.placer.travel.check(piece.place.axes.as_ref()).map_err(fault)?;
            self.placer.check_between(&self.place, &piece.place).map_err(fault)?;
            let pace = self.pace(motion.feed, &piece.place).map_err(fault)?;
            blocks += u64::from(piece.place.words != self.place.words);
            let inserted = (piece.place.words != place.words).then_some(Why::Tolerance);
            self.write_feed(at, &piece.place, pace, inserted, sink)?;
            self.place = piece.place;
            let statistics = &mut self.statistics;
            statistics.largest_tip_bound = statistics.largest_tip_bound.max(piece.bound.tip);
            if tolerance.axis.is_finite() {
                statistics.largest_axis_bound = statistics.largest_axis_bound.max(piece.bound.axis);
            }
        }
        self.statistics.inserted += blocks.max(1) - 1;
        Ok(())
    }

    /// A rapid inside an operation, as the configuration wants it written; one that turns a rotary axis by more than the
    /// index angle is no such rapid, and no path leads to where the course turns it.
    fn rapid_to(&mut self, at: Location, motion: &Move, place: &Place<M::Axes>, sink: &mut impl Sink) -> Planned {
        self.clamps.note(&self.place.words, &place.words);
        match self.policy.options.rapids.rapid {
            _ if self.indexes(place) => {}
            Rapid::Direct => {}
            Rapid::Split => {
                let step = motion.pose.tip - self.place.pose.tip;
                let axis = motion.pose.axis.into_inner();
                let along = axis * step.dot(&axis);
                let out = step.dot(&axis) > 0.0;
                if along.norm() > self.placer.unit_mm() && (step - along).norm() > self.placer.unit_mm() {
                    let (corner, rotaries) =
                        if out { (self.place.pose.tip + along, self.place) } else { (motion.pose.tip - along, *place) };
                    let corner = self.placer.shifted(corner, &rotaries).map_err(|fault| stop(at, fault))?;
                    self.cancel_inverse_time(sink)?;
                    self.write_rapid(&corner, self.all(), Some(Why::Corner), sink)?;
                    self.place = corner;
                }
            }
            Rapid::Feed => {
                let feed = self.policy.options.rapids.rapid_feed.map(program::Feed::PerMinute);
                return self.feed_to(at, &Move { feed, ..*motion }, place, sink);
            }
        }
        self.say_turn(place).map_err(|fault| stop(at, fault))?;
        self.cancel_inverse_time(sink)?;
        self.rapid(place, self.all(), sink)
    }

    /// What a block does has to stand in it: the control would go on with rotary axes that stand elsewhere.
    fn say_turn(&self, to: &Place<M::Axes>) -> Result<(), Fault> {
        if !self.placer.hides_turn(&self.place, to, self.policy.options.axis_tolerance_path) {
            return Ok(());
        }
        let (letter, turn) = self.placer.largest_turn(&self.place.words, &to.words).unwrap_or_default();
        Err(Fault::new(format_args!(
            "here {letter} has to turn by {:.3}° while the tool axis stays, and a tool axis as a vector cannot say that",
            turn.to_degrees()
        ))
        .help("give `tcp_words = \"angles\"`"))
    }

    /// The rotaries would turn while the plane is tilted.
    pub(super) fn leaves_plane(&self, to: &Place<M::Axes>) -> bool {
        self.policy.options.mode == Mode::Plane && self.placer.rotary_travel(&self.place.words, &to.words) > 0.0
    }

    /// A cut that turns the tool axis, in mode `plane`.
    #[cold]
    fn turns_in_plane(&self) -> Fault {
        Fault::new("the tool axis turns in this cut, and mode plane holds it still")
            .help("post this program with mode tcp or axes")
    }

    /// A motion turns a rotary axis by more than the index angle.
    fn indexes(&self, to: &Place<M::Axes>) -> bool {
        self.placer.rotary_travel(&self.place.words, &to.words) > self.policy.options.rapids.index_angle + 1e-9
    }

    /// Remembers the lowest level that was cut with this tool axis in this operation.
    #[inline]
    pub(super) fn cut(&mut self, pose: &Pose) {
        match &mut self.lowest {
            Some(lowest)
                if (lowest.axis.into_inner() - pose.axis.into_inner()).norm_squared() < SAME_AXIS * SAME_AXIS =>
            {
                if (pose.tip - lowest.tip).dot(&lowest.axis) < 0.0 {
                    lowest.tip = pose.tip;
                }
            }
            lowest => *lowest = Some(*pose),
        }
    }

    /// Says once in an operation that a rapid goes deeper than anything was cut.
    pub(super) fn watch_plunge(&mut self, at: Location, from: &Pose, to: &Pose) {
        let Some(lowest) = self.lowest else { return };
        let step = to.tip - from.tip;
        let down = -step.dot(&to.axis);
        let across = (step + to.axis.into_inner() * down).norm();
        let same = (lowest.axis.into_inner() - to.axis.into_inner()).norm() < SAME_AXIS;
        let depth = -(to.tip - lowest.tip).dot(&to.axis);
        if same && down > 0.0 && across <= 1e-3 * down && depth > PLUNGE && !self.plunge_told {
            self.plunge_told = true;
            let text =
                format!("a rapid goes down along the tool to {depth:.3} mm below anything cut in this operation");
            let fault = Fault::new(text).help("check whether the material is gone there");
            self.warnings.push(fault.at(at, Severity::Warning));
        }
    }

    /// The axes whose words a block inside an operation may hold: in a tilted plane the control has turned the others.
    #[inline]
    pub(super) fn all(&self) -> u16 {
        let rotary = if self.policy.options.mode == Mode::Plane { 0 } else { self.placer.rotary_mask() };
        self.placer.linear_mask() | rotary
    }

    #[inline]
    pub(super) fn write_feed(
        &mut self,
        at: Location,
        place: &Place<M::Axes>,
        Pace { feed, minutes, slowed }: Pace,
        inserted: Option<Why>,
        sink: &mut impl Sink,
    ) -> Planned {
        if place.words != self.place.words {
            self.say_turn(place).map_err(|fault| stop(at, fault))?;
            self.clamps.note(&self.place.words, &place.words);
            self.times.cut(minutes);
            if let Some((letter, turn)) = self.placer.largest_turn(&self.place.words, &place.words) {
                self.times.turn(letter, turn / (minutes - slowed), at);
            }
            if slowed > 0.0 {
                self.times.slow(at, slowed);
            }
            self.inverse_time = matches!(feed, Feed::InverseTime(_));
            self.statistics.inverse_time += u64::from(self.inverse_time);
            let words = self.speller.spell(&self.placer.written(&self.place), self.placer.words(place, self.all()));
            sink.stand(&self.standing(place, inserted));
            sink.step(&Step::Feed { words, feed })?;
        }
        Ok(())
    }

    /// A rapid to a place; the axes that are not in the mask stand there.
    pub(super) fn rapid(&mut self, to: &Place<M::Axes>, mask: u16, sink: &mut impl Sink) -> Planned {
        self.write_rapid(to, mask, None, sink)
    }

    fn write_rapid(&mut self, to: &Place<M::Axes>, mask: u16, inserted: Option<Why>, sink: &mut impl Sink) -> Planned {
        let standing = self.standing(to, inserted);
        self.rapid_words(to, mask, &standing, sink)
    }

    /// A rapid of some axes alone.
    pub(super) fn rapid_alone(&mut self, to: &Place<M::Axes>, mask: u16, sink: &mut impl Sink) -> Planned {
        let standing = Standing { pose: None, mask, ..self.standing(to, None) };
        self.rapid_words(to, mask, &standing, sink)
    }

    /// A rapid to the words of a place in some axes.
    fn rapid_words(
        &mut self,
        to: &Place<M::Axes>,
        mask: u16,
        standing: &Standing<'_>,
        sink: &mut impl Sink,
    ) -> Planned {
        self.times.rapid(self.placer.least_minutes_of(&self.place, to, mask));
        let (start, end) = (self.placer.written(&self.place), self.placer.written(to));
        let mut from = start;
        let pieces = self.speller.pieces(&start, &end, mask);
        for piece in 1..=pieces {
            let mut words = self.placer.words(to, mask);
            for index in (0..MAX_AXES).filter(|&index| mask & (1 << index) != 0) {
                words.units[index] = start[index] + (end[index] - start[index]) * piece / pieces;
            }
            let reached = words.units;
            if piece == pieces {
                sink.stand(standing);
            }
            sink.step(&Step::Rapid { words: self.speller.spell(&from, words) })?;
            from = reached;
        }
        Ok(())
    }

    /// Inverse time never stays in force over a rapid.
    #[inline]
    pub(super) fn cancel_inverse_time(&mut self, sink: &mut impl Sink) -> Planned {
        if self.inverse_time {
            self.inverse_time = false;
            sink.step(&Step::PerMinute)?;
        }
        Ok(())
    }

    /// The machine stands at a motion of the CL data.
    #[inline]
    pub(super) fn arrive(&mut self, place: Place<M::Axes>) {
        self.statistics.motions += 1;
        self.count_deviation(&place);
        self.place = place;
        self.placed = true;
        self.there = true;
        self.clear = false;
    }

    #[inline]
    fn count_deviation(&mut self, place: &Place<M::Axes>) {
        if place.deviation > NO_DEVIATION && place.pole {
            self.statistics.near_pole += 1;
            self.statistics.largest_at_pole = self.statistics.largest_at_pole.max(place.deviation);
        } else if place.deviation > NO_DEVIATION {
            self.statistics.deviations += 1;
            self.statistics.largest_deviation = self.statistics.largest_deviation.max(place.deviation);
        }
    }

    pub(super) fn count_sequence(&mut self) {
        self.statistics.sequences += 1;
    }
}
