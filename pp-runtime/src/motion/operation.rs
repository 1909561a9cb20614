//! Motions inside an operation, and what must be true before each.

use crate::config::Transition;
use crate::diag::Severity;
use crate::kinematics::{Machine, Pose};
use crate::program::{self, Location, Move};

use super::fault::Fault;
use super::feed::{Feeds, Stroke};
use super::linearise::Pieces;
use super::place::Place;
use super::planner::{Phase, Planned, Planner, SAME_AXIS, Stop, stop};
use super::step::{Feed, Sink, Step};

/// A deviation of the tool axis up to this is arithmetic, rad.
const NO_DEVIATION: f64 = 1e-12;

/// A rapid this much below the lowest cut is remarked on, mm.
const PLUNGE: f64 = 0.001;

impl<M: Machine> Planner<'_, M> {
    /// What must be true before the tool moves to a point of the CL data.
    #[inline]
    pub(super) fn check_state(&self, motion: &Move) -> Result<(), Fault> {
        if let Some(floor) = self.config.floor
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
        if motion.rapid {
            return Ok(());
        }
        if self.upside_down {
            return Err(Fault::new("every tool axis of this program points into the table")
                .help("is the frame upside down? Turn it in CAM or with `part_rotation`; `table_check = false` posts it as it is"));
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

    /// The F word of a motion of the CL data from where the tool stands to `to`.
    #[inline]
    pub(super) fn feed(&self, feed: Option<program::Feed>, to: &Place<M::Axes>) -> Result<Feed, Fault> {
        let feed = feed.ok_or_else(|| Fault::new("a feed motion without feed"))?;
        let per_minute = Feeds::per_minute(feed, self.spindle.map(|(speed, _)| speed))?;
        let stroke = Stroke {
            length: (to.pose.tip - self.place.pose.tip).norm(),
            turn: self.placer.rotary_travel(&self.place.words, &to.words),
            square: self.placer.square(),
        };
        self.feeds.word(per_minute, stroke)
    }

    /// A motion inside an operation.
    #[inline]
    pub(super) fn run(&mut self, at: Location, motion: &Move, sink: &mut impl Sink) -> Planned {
        let fault = |fault: Fault| stop(at, fault);
        self.stop_spindle(sink)?;
        self.check_state(motion).map_err(fault)?;
        let mut place = self.placer.place(&motion.pose, &self.place, !motion.rapid).map_err(fault)?;
        let before = self.place.pose;
        if motion.rapid {
            if self.config.transition == Transition::Safe
                && self.placer.rotary_travel(&self.place.words, &place.words) > self.config.index_angle + 1e-9
            {
                self.phase = Phase::First { at, motion: *motion, operation: false };
                return Ok(());
            }
            self.cancel_inverse_time(sink)?;
            self.watch_plunge(at, &motion.pose);
            sink.step(&Step::Rapid { words: self.placer.words(&place, self.all()) })?;
        } else {
            place = self.feed_to(at, motion, place, sink)?;
        }
        self.retreat.follow(&before, &motion.pose);
        self.arrive(place);
        Ok(())
    }

    /// A feed motion from where the tool stands; answers with its place, which may be on another branch.
    #[inline]
    pub(super) fn feed_to(
        &mut self,
        at: Location,
        motion: &Move,
        place: Place<M::Axes>,
        sink: &mut impl Sink,
    ) -> Result<Place<M::Axes>, Stop> {
        if self.placer.rotary_travel(&self.place.words, &place.words) > 0.0 {
            return self.feed_in_pieces(at, motion, place, sink);
        }
        let feed = self.feed(motion.feed, &place).map_err(|fault| stop(at, fault))?;
        self.write_feed(&place, feed, sink)?;
        self.cut(&motion.pose);
        Ok(place)
    }

    /// A feed motion that turns a rotary axis: as many blocks as it takes for tip and tool axis to stay within tolerance.
    fn feed_in_pieces(
        &mut self,
        at: Location,
        motion: &Move,
        place: Place<M::Axes>,
        sink: &mut impl Sink,
    ) -> Result<Place<M::Axes>, Stop> {
        let fault = |fault: Fault| stop(at, fault);
        let place = self.followable(place);
        let mut pieces = Pieces::new(&self.place, &place, self.tolerance);
        let mut blocks = 0;
        while let Some(piece) = pieces.next(&self.placer).map_err(fault)? {
            self.placer.travel.check(piece.place.axes.as_ref()).map_err(fault)?;
            let feed = self.feed(motion.feed, &piece.place).map_err(fault)?;
            blocks += u64::from(piece.place.words != self.place.words);
            self.write_feed(&piece.place, feed, sink)?;
            self.place = piece.place;
            let statistics = &mut self.statistics;
            statistics.largest_tip_bound = statistics.largest_tip_bound.max(piece.bound.tip);
            statistics.largest_axis_bound = statistics.largest_axis_bound.max(piece.bound.axis);
        }
        self.statistics.inserted += blocks.max(1) - 1;
        self.cut(&motion.pose);
        Ok(place)
    }

    /// The place itself, or that of the same pose on the branch where the tool stands: between branches there is a way
    /// only where the tool passes the pole within tolerance.
    fn followable(&self, place: Place<M::Axes>) -> Place<M::Axes> {
        let certified = |to: &Place<M::Axes>| {
            let mut pieces = Pieces::new(&self.place, to, self.tolerance);
            loop {
                match pieces.next(&self.placer) {
                    Ok(Some(_)) => {}
                    Ok(None) => return true,
                    Err(_) => return false,
                }
            }
        };
        if !self.placer.changes_branch(&self.place, &place) || certified(&place) {
            return place;
        }
        self.placer.on_branch_of(&self.place, &place).filter(certified).unwrap_or(place)
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
    pub(super) fn watch_plunge(&mut self, at: Location, to: &Pose) {
        let Some(lowest) = self.lowest else { return };
        let step = to.tip - self.place.pose.tip;
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

    #[inline]
    pub(super) fn all(&self) -> u16 {
        self.placer.linear_mask() | self.placer.rotary_mask()
    }

    #[inline]
    pub(super) fn write_feed(&mut self, place: &Place<M::Axes>, feed: Feed, sink: &mut impl Sink) -> Planned {
        if place.words != self.place.words {
            self.inverse_time = matches!(feed, Feed::InverseTime(_));
            self.statistics.inverse_time += u64::from(self.inverse_time);
            sink.step(&Step::Feed { words: self.placer.words(place, self.all()), feed })?;
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
        self.statistics.near_pole += u64::from(place.near_pole);
        if place.deviation > NO_DEVIATION {
            self.statistics.deviations += 1;
            self.statistics.largest_deviation = self.statistics.largest_deviation.max(place.deviation);
        }
        self.place = place;
        self.placed = true;
        self.there = true;
        self.clear = false;
    }

    pub(super) fn count_sequence(&mut self) {
        self.statistics.sequences += 1;
    }
}
