//! The mover: holds the position of the axes, computes the words of poses, and writes each motion in one or more
//! blocks. Nothing else moves the machine.
//!
//! The [`Planner`](crate::motion::plan::Planner) decides the next motion. Decided here are rounding, linearisation,
//! feed, rollover, limits, clamps, and the frame of the control.

mod link;
mod retract;

use std::io;

use crate::diag::code::plan;
use crate::kinematics::{AnyMachine, AxisKind, Pose};
use crate::motion::policy::Policy;
use crate::nalgebra::Point3;
use crate::options::{Rapid, StretchMode, ToolPosture};
use crate::program::Move;
use crate::program::Units;

use crate::motion::fault::{Fault, Planned};
use crate::motion::geometry::angle_between;
use crate::motion::place::{AxisPosition, Placer};
use crate::motion::place::{BlockEnds, Linearised, PathTolerance, RotationLaw, WholeMotion};
use crate::motion::plan::abilities::Abilities;
use crate::motion::plan::clamps::{Clamps, MovingAxes};
use crate::motion::plan::feed::{FeedMotion, Feeds, Pace};
use crate::motion::plan::output::Output;
use crate::motion::plan::position::Position;
use crate::motion::rotary::{Rollover, RotaryTarget, RotaryWords};
use crate::motion::step::{AxisWords, MAX_AXES, Sink, Step};
use crate::motion::step::{BlockReason, ReachedPosition};
use crate::shortcut::Shortcut;
use crate::tolerance::writer::{CONVERTED_NOISE, HELD_AXIS};

/// Largest move of the linear axes, in last digits of their words, that is rounding beside a rotation of more than the
/// second.
const FAINT_MOVE: i64 = 2;
const ROTATES_BESIDE: i64 = 1000;

/// Moves the machine.
pub(crate) struct Mover<'a, S> {
    policy: Policy<'a>,
    abilities: &'a Abilities,
    placer: Placer,
    feeds: Feeds,
    speller: Rollover,
    clamps: Clamps,
    /// Tolerances of feed motions.
    tolerance: PathTolerance,
    /// Motion of the rotary axes in the motion at hand.
    law: RotationLaw,
    /// Angle by which the motion at hand is bent to lead it through a pole, rad.
    bent_rad: f64,
    /// Where the tip came to rest in the cut, and the rotation of a rotary axis since, rad.
    spot: (Point3<f64>, f64),
    position: Position,
    output: Output<S>,
    /// Safety lines so far.
    restarts: u32,
    /// Guards of tilted planes so far.
    plane_guards: u32,
}

/// Motion of a feed block between its ends.
#[derive(Debug, Clone, Copy)]
struct BlockMotion {
    /// Distance of the ends of the tip path.
    length_mm: f64,
    /// Letter and angle, rad, of the rotary axis that rotates most.
    rotation: Option<(char, f64)>,
}

impl<'a, S: Sink> Mover<'a, S> {
    pub(crate) fn new(
        machine: Box<dyn AnyMachine>,
        policy: Policy<'a>,
        units: Units,
        abilities: &'a Abilities,
        output: Output<S>,
    ) -> Self {
        let placer = Placer::new(machine, policy, units);
        Self {
            feeds: Feeds::new(policy, units, placer.unit_mm(), abilities),
            speller: Rollover::new(placer.chain(), policy, placer.rotaries(), placer.scale().units_per_turn),
            clamps: Clamps::new(placer.chain(), policy, placer.rotaries()),
            tolerance: PathTolerance {
                tip_mm: policy.options.tolerance_mm,
                axis_rad: policy.options.axis_tolerance_path_rad,
            },
            law: RotationLaw::GreatCircle,
            bent_rad: 0.0,
            spot: (Point3::origin(), 0.0),
            position: Position::new(placer.zero()),
            policy,
            abilities,
            placer,
            output,
            restarts: 0,
            plane_guards: 0,
        }
    }

    /// The placer: computes words for poses.
    #[inline]
    pub(crate) fn placer(&self) -> &Placer {
        &self.placer
    }

    /// The computation of F words.
    pub(crate) fn feeds(&self) -> &Feeds {
        &self.feeds
    }

    /// Tolerances of feed motions.
    pub(crate) fn tolerance(&self) -> PathTolerance {
        self.tolerance
    }

    /// A motion begins: from end to end of its record, or a part of a record.
    pub(crate) fn begin_motion(&mut self, whole: bool) {
        let even = whole && self.policy.options.tip.tool_posture == ToolPosture::Axes;
        self.law = if even { RotationLaw::Even } else { RotationLaw::InStep };
        self.bent_rad = 0.0;
    }

    /// The motion at hand is divided, by a change of its course.
    pub(crate) fn divide_motion(&mut self) {
        if self.law == RotationLaw::Even {
            self.law = RotationLaw::GreatCircle;
        }
    }

    /// A pose of the path at which the motion at hand is divided: where the control finds the rotary angles, the one of
    /// these rotary words.
    pub(crate) fn bend(&mut self, pose: Pose, words: &RotaryWords) -> Pose {
        let Some((axis, angle)) = self.placer.axis_where_divided(&pose, words) else { return pose };
        self.bent_rad = self.bent_rad.max(angle);
        Pose { axis, ..pose }
    }

    /// LINTOL: largest deviation of the tip from its path, mm.
    pub(crate) fn set_tip_tolerance(&mut self, tip: f64) {
        self.tolerance.tip_mm = tip;
    }

    /// Position of the machine.
    #[inline]
    pub(crate) fn position(&self) -> &Position {
        &self.position
    }

    #[inline]
    pub(crate) fn position_mut(&mut self) -> &mut Position {
        &mut self.position
    }

    /// Present place of the axes.
    #[inline]
    pub(crate) fn here(&self) -> &AxisPosition {
        self.position.place()
    }

    #[inline]
    pub(crate) fn output(&self) -> &Output<S> {
        &self.output
    }

    #[inline]
    pub(crate) fn output_mut(&mut self) -> &mut Output<S> {
        &mut self.output
    }

    /// Safety lines so far.
    pub(crate) fn restarts(&self) -> u32 {
        self.restarts
    }

    /// Sets the mode of the stretch that begins; the tool is at the machine retract.
    pub(crate) fn set_mode(&mut self, mode: StretchMode) {
        self.placer.set_mode(mode);
        self.feeds.set_mode(mode);
    }

    /// Whether the machine retract leads the tool out along its axis.
    pub(crate) fn retracts_along_tool(&self) -> bool {
        self.placer.retracts_along_tool() && !self.position.is_in_frame()
    }

    /// Sets the gauge length of the tool in the spindle, mm, if known.
    pub(crate) fn set_gauge_length(&mut self, length: Option<f64>) {
        self.placer.set_gauge_length(length);
    }

    /// Sets the position of the part zero from the reference point of the table, mm.
    pub(crate) fn set_part_origin(&mut self, origin: [f64; 3]) {
        self.placer.set_part_origin(origin.into());
    }

    /// Sets the result of a rehearsal of the same program, which decides where clamps are on.
    pub(crate) fn set_rehearsed(&mut self, rehearsed: MovingAxes) {
        self.clamps.set_rehearsed(rehearsed);
    }

    /// Result of a rehearsal: the axes that move after each approach.
    pub(crate) fn into_rehearsed(self) -> MovingAxes {
        self.clamps.into_seen()
    }

    /// FROM: before the first motion, the position from which the rotary axes count.
    pub(crate) fn count_from(&mut self, pose: &Pose) {
        let placer = &self.placer;
        self.position.count_from(|from| placer.reference(pose, from));
    }

    /// The place of a pose, reached from the present place: see [`Placer::place`]. In a plane the rotary axes stay
    /// where the tool axis is that of the plane but for the digits of CL data, whatever the course has for these
    /// digits.
    pub(crate) fn place(
        &mut self,
        pose: &Pose,
        feed: bool,
        planned: Option<RotaryTarget>,
    ) -> Result<AxisPosition, Fault> {
        let here = self.position.place();
        if self.placer.mode() == StretchMode::Plane && (feed || planned.is_none()) && self.position.is_known() {
            let distance = here.pose.axis.into_inner() - pose.axis.into_inner();
            if distance.norm_squared() <= HELD_AXIS * HELD_AXIS {
                return self.placer.shifted(pose.tip, here);
            }
        }
        self.placer.place(pose, here, feed, planned)
    }

    /// Compares a place with the travel of the linear axes.
    pub(crate) fn check_travel(&mut self, place: &AxisPosition) -> Result<(), Fault> {
        self.placer.check_travel(place)
    }

    /// Moves the tip of a place, with its rotary axes.
    pub(crate) fn shift(&mut self, place: &mut AxisPosition, tip: Point3<f64>) -> Result<(), Fault> {
        self.placer.shift(place, tip)
    }

    /// The place of another tip with the rotary axes of `at`.
    pub(crate) fn shifted(&mut self, tip: Point3<f64>, at: &AxisPosition) -> Result<AxisPosition, Fault> {
        self.placer.shifted(tip, at)
    }

    /// Axes whose words a block inside an operation may have: in a plane the rotary axes stay where they are.
    #[inline]
    pub(crate) fn block_axes(&self) -> u16 {
        let rotary = if self.placer.mode() == StretchMode::Plane { 0 } else { self.placer.rotary_mask() };
        self.placer.linear_mask() | rotary
    }

    /// Whether any rotary axis rotates in a motion to a place.
    #[inline]
    pub(crate) fn rotates(&self, to: &AxisPosition) -> bool {
        self.placer.rotates(&self.here().words, &to.words)
    }

    /// Whether a motion rotates a rotary axis by more than the index angle.
    pub(crate) fn indexes(&self, to: &AxisPosition) -> bool {
        self.placer.rotary_travel(&self.here().words, &to.words)
            > self.policy.options.rapids.index_angle_rad + CONVERTED_NOISE
    }

    /// Whether rotary axes would rotate while the plane is tilted.
    #[inline]
    pub(crate) fn leaves_plane(&self, to: &AxisPosition) -> bool {
        self.placer.mode() == StretchMode::Plane && self.rotates(to)
    }

    /// Notes which axes rotate in a block to a place: their clamps must be off.
    #[inline]
    pub(crate) fn note_rotation(&mut self, to: &AxisPosition) {
        let rotates = self.placer.writes_vectors() && self.rotates(to);
        self.clamps.note(&self.position.place().words, &to.words, rotates);
    }

    /// Motion of the block to a place.
    #[inline(always)]
    fn block_to(&self, to: &AxisPosition) -> BlockMotion {
        let from = self.here();
        let rotation = self.placer.largest_rotation(&from.words, &to.words);
        BlockMotion { length_mm: (to.pose.tip - from.pose.tip).norm(), rotation }
    }

    /// F word and time of a block to a place at `rate` mm/min. `tip_rate`: as in
    /// [`MotionBound`](crate::kinematics::MotionBound) where a rotary axis rotates; else 0.
    #[inline(always)]
    fn pace(&self, rate: f64, to: &AxisPosition, block: BlockMotion, tip_rate: f64) -> Result<Pace, Fault> {
        let from = self.here();
        let (linear_mm, rotary_degrees) =
            if self.feeds.counts_path() { self.placer.path_lengths(from, to) } else { (0.0, 0.0) };
        let length_mm = if self.placer.tip_rests(from, to) { 0.0 } else { block.length_mm };
        let uneven = tip_rate > self.feeds.largest_tip_rate_mm(length_mm);
        let tip_rate_mm = if uneven { self.placer.tip_rate_mm(from, to) } else { 0.0 };
        let mut motion = FeedMotion {
            length_mm,
            tip_rate_mm,
            rotation_rad: block.rotation.map_or(0.0, |(_, angle_rad)| angle_rad),
            orthogonal: self.placer.keeps_path_length_at(to),
            linear_mm,
            rotary_degrees,
            axis_time_min: 0.0,
        };
        motion.axis_time_min = match self.holds_axis_speeds() {
            true => self.placer.least_minutes(from, to).unwrap_or(0.0),
            false => self.placer.least_minutes_at_tip(from, to, self.feeds.programmed_min(rate, motion)),
        };
        self.feeds.pace(rate, motion)
    }

    /// Whether no axis exceeds its speed within a block that takes as long as the axes take from one end to the other:
    /// the axes move evenly, or the control slows down by itself.
    pub(crate) fn holds_axis_speeds(&self) -> bool {
        self.placer.mode() != StretchMode::Tcp || self.abilities.tip.is_none_or(|tip| tip.holds_axis_speeds)
    }

    /// Writes a feed motion to a place at `rate` mm/min; the caller sets the position.
    #[inline]
    pub(crate) fn feed_to(&mut self, place: &AxisPosition, rate: f64) -> Planned {
        let block = self.block_to(place);
        if block.rotation.is_none() {
            return self.feed_straight(place, rate, block);
        }
        if self.leaves_plane(place) {
            return Err(rotation_in_plane_mode().into());
        }
        self.placer.check_passed_pole(self.here(), place)?;
        let axis_rad = self.tolerance.axis_rad - self.bent_rad;
        self.feed_in_step(place, rate, block, PathTolerance { axis_rad, ..self.tolerance })
    }

    /// Writes a feed motion in one block: of the linear axes, or away from the part.
    #[inline]
    pub(crate) fn feed_block(&mut self, place: &AxisPosition, rate: f64) -> Planned {
        self.feed_straight(place, rate, self.block_to(place))
    }

    #[inline]
    fn feed_straight(&mut self, place: &AxisPosition, rate: f64, block: BlockMotion) -> Planned {
        let pace = self.pace(rate, place, block, 0.0)?;
        self.write_feed(place, &pace, block, None)
    }

    /// Writes a feed motion with rotation of an axis in as many blocks as keep tip and tool axis within tolerance. The
    /// travel at its end has been compared.
    pub(crate) fn feed_in_pieces(&mut self, place: &AxisPosition, rate: f64, tolerance: PathTolerance) -> Planned {
        self.feed_in_step(place, rate, self.block_to(place), tolerance)
    }

    /// [`feed_in_pieces`](Self::feed_in_pieces) with the motion in one block, `block`.
    #[inline(always)]
    fn feed_in_step(
        &mut self,
        place: &AxisPosition,
        rate: f64,
        block: BlockMotion,
        tolerance: PathTolerance,
    ) -> Planned {
        let seen = self.output.statistics().largest_deviation(tolerance);
        let ends = BlockEnds { from: self.here(), to: place };
        let whole = || Linearised::in_one_block(&self.placer, ends, tolerance, seen, self.law);
        let whole = if Shortcut::OneBlock.is_on() { whole() } else { None };
        let Some(WholeMotion { tip_rate, bound }) = whole else {
            return self.feed_in_several(place, rate, tolerance);
        };
        if let Some(bound) = bound {
            self.output.statistics_mut().certified(&bound, tolerance);
        }
        self.note_rotation_on_spot(place, block, tolerance)?;
        self.feed_piece(place, tip_rate, rate, block, None)
    }

    /// Writes the feed motion in several blocks, where one does not certify.
    fn feed_in_several(&mut self, place: &AxisPosition, rate: f64, tolerance: PathTolerance) -> Planned {
        let mut pieces = Linearised::new(self.here(), place, tolerance, self.law);
        let mut blocks = 0;
        while let Some(piece) = pieces.next(&self.placer)? {
            blocks += u64::from(piece.place.words != self.here().words);
            let inserted = (piece.place.words != place.words).then_some(BlockReason::Tolerance);
            let block = self.block_to(&piece.place);
            self.note_rotation_on_spot(&piece.place, block, tolerance)?;
            self.placer.check_travel(&piece.place)?;
            self.feed_piece(&piece.place, piece.bound.tip_rate, rate, block, inserted)?;
            self.position.go_to(&piece.place);
            self.output.statistics_mut().certified(&piece.bound, tolerance);
        }
        self.output.statistics_mut().inserted += blocks.max(1) - 1;
        Ok(())
    }

    /// Adds up the rotation of the rotary axes while the tip rests and the tool axis keeps to its tolerance, and
    /// refuses more than `course.rotation_at_pole` permits. Without a tolerance of the tool axis the tool swings, as
    /// configured.
    #[inline]
    fn note_rotation_on_spot(
        &mut self,
        to: &AxisPosition,
        block: BlockMotion,
        tolerance: PathTolerance,
    ) -> Result<(), Fault> {
        if block.length_mm <= self.placer.unit_mm() && tolerance.axis_rad.is_finite() {
            self.rotate_on_spot(to, block, tolerance)
        } else {
            Ok(())
        }
    }

    /// Adds up the rotation of a block in which the tip rests and the tool axis has a tolerance.
    #[cold]
    fn rotate_on_spot(&mut self, to: &AxisPosition, block: BlockMotion, tolerance: PathTolerance) -> Result<(), Fault> {
        if angle_between(&self.here().pose.axis, &to.pose.axis) > tolerance.axis_rad {
            return Ok(());
        }
        let near = (to.pose.tip - self.spot.0).norm() <= self.placer.unit_mm();
        let before = if near { self.spot.1 } else { 0.0 };
        let rotated = before + block.rotation.map_or(0.0, |(_, angle_rad)| angle_rad);
        self.spot = (to.pose.tip, rotated);
        self.output.statistics_mut().rotates_on_spot(rotated);
        let most = self.policy.options.course.rotation_at_pole_rad.unwrap_or(f64::INFINITY);
        if rotated <= most {
            return Ok(());
        }
        let text = format!(
            "before this point a rotary axis rotates by {:.3}° and more with the tool in the cut, `course.rotation_at_pole` is {}°",
            rotated.to_degrees(),
            most.to_degrees()
        );
        Err(plan::POLE
            .fault(text)
            .help("retract before this point and start a new operation, or keep the tool axis away from the pole"))
    }

    /// Writes a piece of a feed motion with the certified speed of its tip.
    #[inline(always)]
    fn feed_piece(
        &mut self,
        place: &AxisPosition,
        tip_rate: f64,
        rate: f64,
        block: BlockMotion,
        inserted: Option<BlockReason>,
    ) -> Planned {
        self.placer.check_between(self.position.place(), place)?;
        let pace = self.pace(rate, place, block, tip_rate)?;
        self.write_feed(place, &pace, block, inserted)
    }

    #[inline(always)]
    fn write_feed(
        &mut self,
        place: &AxisPosition,
        pace: &Pace,
        block: BlockMotion,
        inserted: Option<BlockReason>,
    ) -> Planned {
        if block.rotation.is_none() && place.words == self.here().words {
            return Ok(());
        }
        self.check_hidden_rotation(place)?;
        self.note_rotation(place);
        self.output.feed(pace, block.rotation);
        if self.abilities.times_faint_moves && block.rotation.is_some() {
            self.note_faint_move(place);
        }
        let mut step = Step::Feed { words: self.placer.words(place, self.block_axes()), feed: pace.feed };
        if let Step::Feed { words, .. } = &mut step {
            self.speller.spell(|| self.placer.written(self.position.place()), words);
        }
        let reached = self.placer.state_at(place);
        Ok(self.output.move_step(&step, reached, inserted)?)
    }

    /// Counts a block in which linear axes move by rounding beside a rotation.
    fn note_faint_move(&mut self, place: &AxisPosition) {
        let here = self.position.place();
        let (mut linear, mut rotary) = (0, 0);
        for (axis, (to, from)) in self.placer.chain().iter().zip(place.words.iter().zip(here.words)) {
            let most = if axis.kind == AxisKind::Linear { &mut linear } else { &mut rotary };
            *most = (*most).max((to - from).abs());
        }
        let is_faint = (1..=FAINT_MOVE).contains(&linear) && rotary > ROTATES_BESIDE;
        self.output.statistics_mut().faint += u64::from(is_faint);
    }

    /// Writes an arc or a cycle that ends at a place.
    pub(crate) fn write_motion(&mut self, step: &Step<'_>, place: &AxisPosition) -> io::Result<()> {
        let reached = self.placer.state_at(place);
        self.output.move_step(step, reached, None)
    }

    /// Writes a rapid inside an operation as configured by `rapid`. Always one block where a rotary axis rotates by
    /// more than the index angle: the course of such a rapid is no path that could be followed at feed.
    pub(crate) fn rapid_as_configured(&mut self, motion: &Move, place: &AxisPosition) -> Planned {
        self.note_rotation(place);
        match (self.policy.options.rapids.rapid, self.policy.options.rapids.rapid_feed_mm_per_min) {
            _ if self.indexes(place) => {}
            (Rapid::Direct, _) => {}
            (Rapid::Split, _) => self.split_rapid(motion, place)?,
            (Rapid::Feed, Some(rate)) => return self.feed_to(place, rate),
            (Rapid::Feed, None) => return Err(plan::FEED.fault("`rapid = \"feed\"` without `rapid_feed`").into()),
        }
        self.check_hidden_rotation(place)?;
        self.output.cancel_inverse_time()?;
        self.rapid(place, self.block_axes())
    }

    /// Writes the first block of a rapid in two: out along the tool axis, or across before the motion in.
    fn split_rapid(&mut self, motion: &Move, place: &AxisPosition) -> Planned {
        let here = *self.here();
        let step = motion.pose.tip - here.pose.tip;
        let out = step.dot(&motion.pose.axis) > 0.0;
        // The tool that moves out before it rotates has the axis that it has here.
        let axis = if out && self.rotates(place) { here.pose.axis } else { motion.pose.axis }.into_inner();
        let along = axis * step.dot(&axis);
        if along.norm() <= self.placer.unit_mm() || (step - along).norm() <= self.placer.unit_mm() {
            return Ok(());
        }
        let (corner, rotaries) = if out { (here.pose.tip + along, here) } else { (motion.pose.tip - along, *place) };
        let corner = self.placer.shifted(corner, &rotaries)?;
        self.output.cancel_inverse_time()?;
        let reached = self.placer.state_at(&corner);
        self.rapid_words(&corner, self.block_axes(), reached, Some(BlockReason::Corner))?;
        self.position.go_to(&corner);
        Ok(())
    }

    /// Writes a rapid to a place; axes that are not in the mask are there already.
    pub(crate) fn rapid(&mut self, to: &AxisPosition, mask: u16) -> Planned {
        self.rapid_words(to, mask, self.placer.state_at(to), None)
    }

    /// Writes a rapid of the axes in the mask; the others have not arrived.
    pub(crate) fn rapid_alone(&mut self, to: &AxisPosition, mask: u16) -> Planned {
        self.rapid_words(to, mask, ReachedPosition { pose: None, mask, ..self.placer.state_at(to) }, None)
    }

    /// Writes the words of axes again that are at a place.
    pub(crate) fn restate(&mut self, at: &AxisPosition, mask: u16) -> Planned {
        let mut words = self.placer.words(at, mask);
        self.speller.spell(|| self.placer.written(at), &mut words);
        self.rapid_partly(at, words)
    }

    /// Writes a rapid of linear axes to their positions at a place, in words of another frame; the others have not
    /// arrived.
    pub(crate) fn rapid_across(&mut self, to: &AxisPosition, words: AxisWords) -> Planned {
        self.output.times_mut().rapid(self.placer.least_minutes_of(self.position.place(), to, words.mask));
        self.rapid_partly(to, words)
    }

    /// Writes a rapid of the axes of these words; the others have not arrived.
    fn rapid_partly(&mut self, to: &AxisPosition, words: AxisWords) -> Planned {
        let reached = ReachedPosition { pose: None, mask: words.mask, ..self.placer.state_at(to) };
        Ok(self.output.move_step(&Step::Rapid { words }, reached, None)?)
    }

    /// Writes a rapid of the linear axes to a place; the caller sets the position.
    pub(crate) fn rapid_linear(&mut self, to: &AxisPosition) -> Planned {
        self.rapid(to, self.placer.linear_mask())
    }

    /// Writes a rapid of the axes in the mask, in as many blocks as the rollover of its rotary words needs.
    fn rapid_words(
        &mut self,
        to: &AxisPosition,
        mask: u16,
        reached: ReachedPosition<'_>,
        inserted: Option<BlockReason>,
    ) -> Planned {
        let (start, end) = (self.placer.written(self.position.place()), self.placer.written(to));
        // Where the rotary axes are unknown, no way to the end is the shorter one.
        let pieces = if self.position.knows_rotary_axes() { self.speller.pieces(&start, &end, mask) } else { 1 };
        self.rapid_in_steps(to, mask, reached, inserted, pieces)
    }

    /// Rotates the rotary axes alone. Where they are unknown they may be where they were, and an axis that is half a
    /// revolution from there goes in two steps.
    pub(crate) fn rotate_alone(&mut self, to: &AxisPosition, mask: u16) -> Planned {
        let (start, end) = (self.placer.written(self.position.place()), self.placer.written(to));
        let unsure = !self.position.knows_rotary_axes() && self.position.has_moved();
        if !(unsure && self.speller.is_half_turn(&start, &end, mask)) {
            return self.rapid_alone(to, mask);
        }
        let reached = ReachedPosition { pose: None, mask, ..self.placer.state_at(to) };
        self.rapid_in_steps(to, mask, reached, None, 2)
    }

    fn rapid_in_steps(
        &mut self,
        to: &AxisPosition,
        mask: u16,
        reached: ReachedPosition<'_>,
        inserted: Option<BlockReason>,
        pieces: i64,
    ) -> Planned {
        let from = self.position.place();
        self.output.times_mut().rapid(self.placer.least_minutes_of(from, to, mask));
        let (start, end) = (self.placer.written(from), self.placer.written(to));
        let mut from = start;
        for piece in 1..=pieces {
            let mut words = self.placer.words(to, mask);
            for index in (0..MAX_AXES).filter(|&index| mask & (1 << index) != 0) {
                words.units[index] = start[index] + (end[index] - start[index]) * piece / pieces;
            }
            let piece_end = words.units;
            self.speller.spell(|| from, &mut words);
            let step = Step::Rapid { words };
            if piece == pieces {
                self.output.move_step(&step, reached, inserted)?;
            } else {
                self.output.step(&step)?;
            }
            from = piece_end;
        }
        Ok(())
    }

    /// Refuses a rotation that a block with tool vectors cannot express.
    #[inline(always)]
    fn check_hidden_rotation(&self, to: &AxisPosition) -> Result<(), Fault> {
        self.placer.check_hidden_rotation(self.here(), to, self.policy.options.axis_tolerance_path_rad)
    }

    /// Adds a remark, once in an operation, where a rapid goes deeper than the lowest cut.
    pub(crate) fn watch_plunge(&mut self, from: &Pose, to: &Pose) {
        if let Some(depth) = self.position.plunges(from, to) {
            let depth = self.feeds.units().deviation(depth);
            let text =
                format!("a rapid moves down along the tool axis to {depth} below the lowest cut of this operation");
            self.output.remark(plan::DEPTH.fault(text).help("check that the material there has been removed"));
        }
    }

    /// Sets the position after a cut to a place that is not in the CL data.
    pub(crate) fn pass(&mut self, pose: &Pose, place: &AxisPosition) {
        self.position.note_cut(pose);
        self.output.count_deviation(place);
        self.position.go_to(place);
    }

    /// Sets the position after a motion of the CL data.
    pub(crate) fn arrive(&mut self, place: &AxisPosition) {
        self.output.count_motion(place);
        self.position.arrive(place);
    }
}

/// Fault: a cut that rotates the tool axis in mode `plane`.
#[cold]
fn rotation_in_plane_mode() -> Fault {
    plan::MODE
        .fault("the tool axis rotates in this cut, which mode plane cannot do")
        .help("post this program with mode tcp or axes")
}
