//! Blocks at the part: which motion of the CL data each serves, and how well.

use std::cmp::Ordering;
use std::io::{self, Read};

use super::chain::Placed;
use super::compare::{Checker, Phase};
use super::expect::{Item, Kind, Motion, Wanted};
use super::feed::Stroke;
use super::path::{Segment, Shape, angle_between};
use super::read::{Action, ArcMove, Block, MAX_AXES, TipControl, WorkPlane};
use super::report::Shown;
use super::steps::Done;
use crate::motion::{Rapid, Rewind, ToolPosture, Transition};
use crate::program::{Drilling, Feed, Location};

/// A motion within this angle of the tool axis leads along it, rad.
const ALONG: f64 = 1e-3;

/// Places of a block that are looked at besides its ends, and one more for each of these angles that it turns, rad.
const PLACES: f64 = 3.0;
const PLACE: f64 = 0.02;
const MOST_PLACES: f64 = 400.0;

/// A share that suits both tip and axis leaves each of them this much farther off than its own best would.
pub(super) const BOTH: f64 = std::f64::consts::SQRT_2;

/// An arc that ends where it should has gone round as often as it should if its angle is nearer to that than this, rad.
/// How far words of centre and ends let it swell is looked at along its way.
const SAME_TURN: f64 = std::f64::consts::PI;

/// The end of half a turn by its angle is off by so many times more of what rounded words may be than its start was: half a
/// unit along both axes of its plane may the pole be off the place from which start and end are equally far, these distances
/// differ by up to twice that, and three words are off by up to √3/2 units. Other angles count with the chord that they are
/// of; a whole turn ends where it began, wherever its pole is.
const POLE: f64 = 1.64;

/// Shares that differ by rounding.
const SHARE: f64 = 1e-9;

impl<R: Read> Checker<'_, R> {
    /// Lets the block serve the motion ahead, passing over motions that need no block; `false` if it does not fit.
    pub(super) fn serve(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) -> io::Result<bool> {
        if let Some(back) = self.back {
            return Ok(self.serve_back(&back, block, end, shown));
        }
        if self.takes_rest(block, end) {
            return Ok(true);
        }
        loop {
            self.expect.fill(2)?;
            let Some(item) = self.expect.get(0) else { return Ok(false) };
            let (at, wanted, in_hole) = (item.at, item.wanted, item.hole.is_some());
            let motion = match item.kind {
                Kind::Motion(motion) => motion,
                Kind::Dwell(seconds) => {
                    self.found(shown, &format!("the dwell of {seconds} s before this block is missing"));
                    self.expect.pop();
                    continue;
                }
                _ => return Ok(false),
            };
            if motion.starts && !self.approached {
                return Ok(false);
            }
            let segment = self.segment(&motion, end);
            // A whole turn ends where it began, like a motion to the same place before it; so does a rapid behind a cut
            // that goes nowhere.
            let other = matches!(block.action, Action::Arc(_)) || (block.action == Action::Rapid && !motion.rapid);
            let needless = self.needs_no_block(&segment);
            // A block that goes on from the end of a motion belongs to one behind it, and so does one with another feed.
            let belongs = || self.is_at(end, &motion.to) && self.has_feed_of(block, &segment, &motion, &wanted);
            if needless && (other || !belongs()) {
                self.pass_over();
                continue;
            }
            let share = self.fits(&segment, &motion, block, end);
            let share = share.or_else(|| if in_hole { self.stops_on_way(&segment, &motion, end) } else { None });
            if let Some(share) = share {
                self.travelled(block, end, &segment, &motion, share, (at, wanted), shown);
                return Ok(true);
            }
            if motion.rapid && self.takes_step(block, &wanted, shown) {
                return Ok(true);
            }
            if !needless {
                return Ok(false);
            }
            self.pass();
        }
    }

    /// Whether a block of feed runs as fast as a motion asks for.
    fn has_feed_of(&self, block: &Block, segment: &Segment, motion: &Motion, wanted: &Wanted) -> bool {
        let stroke = || self.stroke(block, segment.length(), motion.feed, wanted);
        block.action != Action::Feed || motion.rapid || self.law.wrong(&stroke(), &block.state).is_none()
    }

    /// The motion ahead from where the last one ended.
    pub(super) fn segment(&self, motion: &Motion, end: &Placed) -> Segment {
        let from = self.reached.or(self.here).unwrap_or(*end);
        Segment { from, to: motion.to, shape: motion.shape }
    }

    /// Rounded words of its end are those in force already.
    pub(super) fn needs_no_block(&self, segment: &Segment) -> bool {
        let short = segment.length() <= 2.0 * self.slack.tip;
        let here = self.here.filter(|_| short || matches!(segment.shape, Shape::Line));
        // A point that repeats needs no block wherever the arcs before it have ended; a way that is lost is no rounding.
        let times = if short { drift(self.by_angle) } else { 1.0 };
        here.is_some_and(|here| self.is_near(&here, &segment.to, times))
    }

    /// Adds up the chords of arcs that have ended by their angle since words said where the tool is in their plane.
    pub(super) fn follow_angles(&mut self, block: &Block) {
        if let Action::Arc(ArcMove { by_angle: true, sweep, .. }) = block.action {
            self.by_angle += chord(sweep);
            return;
        }
        let Some([first, second, _]) = block.state.plane.map(WorkPlane::axes) else { return };
        let said = |axis: usize| self.words.linear_places()[axis].is_none_or(|index| block.written & (1 << index) != 0);
        if said(first) && said(second) {
            self.by_angle = 0.0;
        }
    }

    /// The motion ahead is done.
    pub(super) fn pass(&mut self) {
        if let Some(item) = self.expect.pop() {
            self.last = Some((item.at, item.wanted));
            if let Kind::Motion(motion) = item.kind {
                self.reached = Some(motion.to);
            }
        }
        self.along = 0.0;
        self.approached = false;
    }

    /// Passes over a motion that needs no block. The rotary axes may turn for a rapid all the same.
    pub(super) fn pass_over(&mut self) {
        let item = self.expect.get(0).filter(|item| matches!(item.kind, Kind::Motion(Motion { rapid: true, .. })));
        self.left = self.left.take().or_else(|| item.cloned());
        self.pass();
    }

    pub(super) fn is_at(&self, here: &Placed, there: &Placed) -> bool {
        self.is_near(here, there, 1.0)
    }

    /// At a place, but for so many times what rounded words may be off.
    fn is_near(&self, here: &Placed, there: &Placed, times: f64) -> bool {
        (here.tip - there.tip).norm() <= times * self.slack.tip
            && angle_between(&here.axis, &there.axis) <= self.axis_slack(&there.axis)
    }

    /// How far the tool may be off a tool axis: one that is nearly at the pole is put there.
    pub(super) fn axis_slack(&self, axis: &nalgebra::Vector3<f64>) -> f64 {
        let near =
            self.pole.is_some_and(|pole| pole.cross(axis).norm() <= self.config.motion.course.axis_tolerance_rad);
        if near { self.slack.pole } else { self.slack.axis }
    }

    /// The share of a motion that is done when a block ends there; `None` if it ends elsewhere.
    fn fits(&self, segment: &Segment, motion: &Motion, block: &Block, end: &Placed) -> Option<f64> {
        let past_pole = self.pole.is_some_and(|pole| {
            segment.axis_distance(&pole).min(segment.axis_distance(&-pole))
                <= self.config.motion.course.axis_tolerance_rad
        });
        let ends = if past_pole { self.slack.pole } else { self.slack.axis };
        let by_angle = match (&block.action, &segment.shape) {
            (Action::Arc(arc), Shape::Arc(round)) => {
                Some(round.share_near(&end.tip, self.along + round.share_of(arc.sweep.abs())))
            }
            _ => None,
        };
        let share = by_angle.unwrap_or_else(|| segment.share(end, self.along, self.slack.tip, self.slack.tip / ends));
        let done = (share - 1.0).abs() * segment.angle() < SAME_TURN;
        if (done || !matches!(segment.shape, Shape::Arc(_))) && self.is_at(end, &segment.to) {
            return Some(1.0);
        }
        // An arc by its angle ends where its rounded centre takes it, not at a place of the words.
        let polar = match &block.action {
            Action::Arc(ArcMove { by_angle: true, sweep, .. }) => drift(self.by_angle + chord(*sweep)),
            _ => 1.0,
        };
        if polar > 1.0 && done && (end.tip - segment.to.tip).norm() <= polar * self.slack.tip {
            return Some(1.0);
        }
        if motion.rapid && self.config.motion.rapids.rapid != Rapid::Feed {
            return self.corner(segment, end);
        }
        let swings = self.config.motion.retract.rewind == Rewind::Follow
            && !self.needs_no_block(segment)
            && self.here.is_some_and(|here| (here.tip - end.tip).norm() <= 2.0 * self.slack.tip);
        let before = swings.then_some(self.along);
        if !(self.along - SHARE..=1.0 + SHARE).contains(&share) && !self.just_before(segment, share, ends) {
            return before;
        }
        let on = segment.at(share.clamp(0.0, 1.0));
        let near = (end.tip - on.tip).norm() <= BOTH * polar * self.slack.tip
            && angle_between(&end.axis, &on.axis) <= BOTH * ends;
        if near { Some(share.clamp(self.along, 1.0)) } else { before }
    }

    /// Rounding may put an end a little before the place where the last block ended, which was put a little on by it.
    fn just_before(&self, segment: &Segment, share: f64, axis: f64) -> bool {
        let back = self.along - share;
        let over = share - 1.0;
        let (length, turn) = (segment.length(), segment.turn());
        let near = |part: f64, most: f64| part * length <= most * self.slack.tip && part * turn <= most * axis;
        near(back, 2.0 * BOTH) && near(over, 1.0)
    }

    /// A rapid that leads down to a hole may stop on its way: a cycle of the control goes back to where it began.
    fn stops_on_way(&self, segment: &Segment, motion: &Motion, end: &Placed) -> Option<f64> {
        let near = motion.rapid && segment.distance(end, 0.0) <= BOTH * self.slack.tip;
        (near && segment.axis_distance(&end.axis) <= BOTH * self.slack.axis).then_some(0.0)
    }

    /// A block that serves a motion: its state, its way, its feed.
    #[expect(clippy::too_many_arguments, reason = "both sides of one comparison")]
    fn travelled(
        &mut self,
        block: &Block,
        end: &Placed,
        segment: &Segment,
        motion: &Motion,
        share: f64,
        (at, wanted): (Location, Wanted),
        shown: Shown<'_>,
    ) {
        let on = segment.at(share);
        let outcome = &mut self.tally.outcome;
        if !motion.rapid || share >= 1.0 {
            outcome.tip_mm = outcome.tip_mm.max((end.tip - on.tip).norm());
            outcome.axis_rad = outcome.axis_rad.max(angle_between(&end.axis, &on.axis));
        }
        self.state_at_path(block, &wanted, shown);
        let feeds = block.action != Action::Rapid;
        // The way down from the approach point is a rapid if the CL data has it so.
        let approaches = motion.starts || self.approached || self.turns(block);
        let as_feed = !motion.rapid
            || (self.config.motion.rapids.rapid == Rapid::Feed && !approaches && (feeds || !self.in_thread()));
        if feeds != as_feed {
            let text = match feeds {
                true => "this motion is a rapid in the CL data and is programmed at feed",
                false => "this motion is a feed motion in the CL data and is programmed as a rapid",
            };
            self.found(shown, text);
        } else if feeds {
            self.way(block, segment, &wanted, shown);
            self.feed(block, segment, motion, share, &wanted, shown);
        } else {
            self.turned_at_part(block, shown);
        }
        self.ends_steps(block, shown);
        // The machine leaves along the axis that it has: axes of the CL data that are the same to it turn nothing.
        self.follow_out(&Placed { axis: end.axis, ..on });
        self.along = share;
        self.lost = false;
        self.restarted = false;
        self.last = Some((at, wanted));
        self.done = (share >= 1.0).then_some(Done { motion: *motion, wanted, feeds, turned: 0.0 });
        if share >= 1.0 {
            self.pass();
        } else if motion.rapid {
            self.reached = Some(*end);
        }
    }

    /// What comes next belongs to a thread, whose motions are a cycle of their own on some controls.
    fn in_thread(&self) -> bool {
        let hole = self.expect.get(0).and_then(|item| item.hole);
        hole.is_some_and(|wanted| matches!(wanted.hole.drilling, Drilling::Tap { .. }))
    }

    /// A rotary axis turns by more than the index angle.
    fn turns(&self, block: &Block) -> bool {
        let (before, known) = self.before;
        let rotary = self.words.rotary_mask & known;
        let largest = self.config.motion.rapids.index_angle_rad + 1.5 * self.slack.angle;
        (0..MAX_AXES).any(|index| rotary & (1 << index) != 0 && (block.values[index] - before[index]).abs() > largest)
    }

    /// A block turns the rotary axes, and where the tool has not been retracted a rapid must not.
    pub(super) fn turns_at_part(&self, block: &Block) -> bool {
        self.config.motion.rapids.transition == Transition::Safe && self.turns(block)
    }

    /// Says that a rapid turns the rotary axes where it must not.
    pub(super) fn turned_at_part(&mut self, block: &Block, shown: Shown<'_>) {
        if self.turns_at_part(block) {
            self.found(shown, "this rapid rotates the rotary axes near the part: the retract before it is missing");
        }
    }

    /// How far the motions lead out along the tool axis.
    fn follow_out(&mut self, to: &Placed) {
        let from = self.out_from.replace(*to).unwrap_or(*to);
        let step = to.tip - from.tip;
        let along = step.dot(&to.axis);
        let across = (step - to.axis * along).norm();
        if angle_between(&from.axis, &to.axis) > ALONG {
            self.led_out = 0.0;
        } else if along > SHARE && across <= ALONG * along {
            self.led_out += along;
        } else if along.abs() > SHARE || across > SHARE {
            self.led_out = 0.0;
        }
    }

    /// The way of a block between its ends.
    fn way(&mut self, block: &Block, segment: &Segment, wanted: &Wanted, shown: Shown<'_>) {
        let (before, known) = self.before;
        let solved = self.solved(block);
        // The control itself turns the axis evenly.
        let evenly = block.state.tip_control != TipControl::Off
            && (block.state.vector.is_some() || self.config.motion.tip.tool_posture == ToolPosture::Plane);
        if self.lost || known & solved != solved {
            return;
        }
        let evenly = evenly && block.action == Action::Feed;
        let turned = if evenly { 0.0 } else { self.words.rotary_way(&before, &block.values) };
        let straight = matches!(block.action, Action::Feed);
        if straight && turned <= 0.0 && matches!(segment.shape, Shape::Line) {
            return;
        }
        let sweep = sweep(block);
        let places = places(turned + sweep);
        let (mut tip, mut axis) = (0.0_f64, 0.0_f64);
        let mut place = 1.0;
        while place <= places {
            let share = place / (places + 1.0);
            let words = between(&before, block, share, self.words.linear_places());
            let on = self.words.place(&words, &block.state);
            tip = tip.max(match &segment.shape {
                Shape::Arc(round) if sweep > 0.0 => {
                    let gone = self.along + round.share_of(sweep * share);
                    (on.tip - segment.at(round.share_near(&on.tip, gone).clamp(0.0, 1.0)).tip).norm()
                }
                _ => segment.distance(&on, self.along),
            });
            if turned > 0.0 {
                axis = axis.max(segment.axis_distance(&on.axis));
            }
            place += 1.0;
        }
        let outcome = &mut self.tally.outcome;
        outcome.path_mm = outcome.path_mm.max(tip);
        let swings = self.config.motion.retract.rewind == Rewind::Follow;
        let largest = wanted.tolerance + self.slack.tip;
        if tip > largest {
            let text =
                format!("within this block the tip deviates from its path by {tip:.4} mm, allowed {largest:.4} mm");
            self.found(shown, &text);
        }
        let largest = self.config.motion.axis_tolerance_path_rad + self.slack.pole;
        if axis > largest && !swings {
            let (axis, largest) = (axis.to_degrees(), largest.to_degrees());
            let text = format!(
                "within this block the tool axis deviates from its even rotation by {axis:.4}°, allowed {largest:.4}°"
            );
            self.found(shown, &text);
        }
    }

    /// F of a block.
    fn feed(
        &mut self,
        block: &Block,
        segment: &Segment,
        motion: &Motion,
        share: f64,
        wanted: &Wanted,
        shown: Shown<'_>,
    ) {
        let solved = self.solved(block);
        if self.lost || self.before.1 & solved != solved {
            return;
        }
        let feed = if motion.rapid {
            self.config.motion.rapids.rapid_feed_mm_per_min.map(Feed::PerMinute)
        } else {
            motion.feed
        };
        let part = match segment.shape {
            Shape::Line => (share - self.along) * segment.length(),
            _ if matches!(block.action, Action::Arc(_)) => (share - self.along) * segment.length(),
            _ => (segment.at(share).tip - segment.at(self.along).tip).norm(),
        };
        let stroke = self.stroke(block, part, feed, wanted);
        let wrong = match block.state.vector {
            // How far the rotary axes turn is the control's to find.
            Some(_) if self.law.is_still(&stroke) && segment.turn() > 0.0 => self.law.wrong_on_the_spot(&block.state),
            Some(_) if self.law.needs_axes() => self.law.too_fast(&stroke, &block.state),
            _ => self.law.wrong(&stroke, &block.state),
        };
        if let Some(text) = wrong {
            self.found(shown, &text);
        }
    }

    /// A block that leads its tip so far, mm.
    pub(super) fn stroke(&self, block: &Block, length: f64, feed: Option<Feed>, wanted: &Wanted) -> Stroke {
        let axes = |words: &[f64; MAX_AXES]| match self.law.needs_axes() {
            true => self.words.axes(words, &block.state).unwrap_or_else(|| self.words.values(words)),
            false => self.words.values(words),
        };
        let (from, to) = (axes(&self.before.0), axes(&block.values));
        let change = std::array::from_fn(|index| to[index] - from[index]);
        Stroke { length, change, feed, speed: wanted.spindle.map(|(speed, _)| speed) }
    }

    /// The way back to where the rotary axes were rewound.
    fn serve_back(&mut self, back: &Segment, block: &Block, end: &Placed, shown: Shown<'_>) -> bool {
        if let (Action::Rapid, Some(Item { wanted, .. })) = (block.action, self.left.take())
            && self.is_at(end, &back.to)
        {
            // What looked like a rewind was the way out before a rapid, and this is the rapid.
            self.state_at_path(block, &wanted, shown);
            self.back = None;
            return true;
        }
        if block.action == Action::Rapid || !self.is_at(end, &back.to) {
            return false;
        }
        let (before, known) = self.before;
        let rotary = self.words.rotary_mask;
        if known & rotary == rotary && self.words.rotary_way(&before, &block.values) > 1.5 * self.slack.angle {
            self.found(
                shown,
                "the rotary axes rotate on the way back to the part: a rewind rotates them at the retract position \
                 only",
            );
        }
        let item = self.expect.get(0).map(|item| (item.wanted, item.kind.clone()));
        if let Some((wanted, kind)) = item {
            self.state_at_path(block, &wanted, shown);
            if let (Kind::Motion(motion), true) = (kind, known & self.solved(block) == self.solved(block)) {
                let stroke = self.stroke(block, back.length(), motion.feed, &wanted);
                if let Some(text) = self.law.wrong(&stroke, &block.state) {
                    self.found(shown, &text);
                }
            }
        }
        self.back = None;
        self.phase = Phase::Path;
        true
    }

    /// A block that serves nothing that comes next: says so, and seeks among the motions ahead where the program goes on.
    /// What lies between has been lost.
    pub(super) fn resume(&mut self, block: &Block, end: &Placed, shown: Shown<'_>) -> io::Result<()> {
        (self.back, self.steps) = (None, None);
        self.out_from = Some(*end);
        self.led_out = 0.0;
        let queue = self.expect.ahead()?;
        let goes_on = queue.iter().position(|item| matches!(&item.kind, Kind::Motion(motion) if {
            (motion.to.tip - end.tip).norm() <= self.slack.tip && angle_between(&motion.to.axis, &end.axis) <= self.slack.axis
        }));
        if let Some(count @ 1..) = goes_on {
            self.skip(count, shown);
            // Where it began is not to be judged.
            self.lost = true;
            if self.serve(block, end, shown)? {
                return Ok(());
            }
        }
        let text = self.serves_nothing(end);
        self.found(shown, &text);
        if goes_on.is_some() {
            self.pass();
        }
        self.lost = goes_on.is_none();
        Ok(())
    }

    /// Why a block does not do what comes next.
    fn serves_nothing(&self, end: &Placed) -> String {
        match self.expect.get(0).map(|item| &item.kind) {
            Some(Kind::Motion(motion)) => {
                let segment = self.segment(motion, end);
                let off = segment.distance(end, self.along);
                let turn = angle_between(&end.axis, &motion.to.axis).to_degrees();
                match off <= self.slack.tip && turn.to_radians() <= self.slack.axis {
                    true => "this block ends on the next motion of the CL data but does not follow it: wrong path, or \
                             rapid instead of feed"
                        .to_owned(),
                    false => format!(
                        "this block matches no motion of the CL data: it ends {off:.4} mm from the path of the next \
                         motion, its tool axis {turn:.4}° off"
                    ),
                }
            }
            Some(Kind::Stop { .. }) => {
                "the stop (STOP or OPSTOP) of the CL data is not in the program before this block".to_owned()
            }
            Some(Kind::Raw(_)) => "the text of INSERT is not in the program before this block".to_owned(),
            Some(Kind::Home) => "the retract of GOHOME is not in the program before this block".to_owned(),
            Some(Kind::Dwell(_)) | None => "this block matches no motion of the CL data".to_owned(),
        }
    }

    /// Passes over items that the program has no block for, and names their lines.
    pub(super) fn skip(&mut self, count: usize, shown: Shown<'_>) {
        let asked = (0..count).filter(|index| !self.needless(*index));
        let mut lines = asked.filter_map(|index| self.expect.get(index)).map(|item| item.at);
        if let Some(first) = lines.next() {
            let last = lines.next_back().unwrap_or(first);
            let which = match last.line.cmp(&first.line) {
                Ordering::Equal => format!("CL line {} has", first.line),
                Ordering::Greater => format!("CL lines {} to {} have", first.line, last.line),
                // What a subprogram asks stands where it is defined.
                Ordering::Less => format!("CL line {} and the subprogram that it calls have", first.line),
            };
            let text = format!("{which} no block before this one: missing or out of order");
            self.tally.found(first, shown, &text, None);
        }
        (0..count).for_each(|_| self.pass());
    }
}

/// How many times what rounded words may be off the tool is off its path behind arcs by their angle, whose chords add up to
/// so many diameters.
pub(super) fn drift(chords: f64) -> f64 {
    1.0 + POLE * chords
}

/// Chord of an arc in diameters.
fn chord(sweep: f64) -> f64 {
    (0.5 * sweep).sin().abs()
}

/// How far an arc goes round, rad; 0 for everything else.
pub(super) fn sweep(block: &Block) -> f64 {
    if let Action::Arc(arc) = &block.action { arc.sweep.abs() } else { 0.0 }
}

/// At how many places of a block that turns so far is looked besides its ends.
pub(super) fn places(turned: f64) -> f64 {
    (PLACES + (turned / PLACE).floor()).min(MOST_PLACES)
}

/// Words at a share of a block.
pub(super) fn between(
    before: &[f64; MAX_AXES],
    block: &Block,
    share: f64,
    linear: [Option<usize>; 3],
) -> [f64; MAX_AXES] {
    let mut words: [f64; MAX_AXES] =
        std::array::from_fn(|index| before[index] + (block.values[index] - before[index]) * share);
    if let (Action::Arc(ArcMove { centre, sweep, .. }), Some(plane)) = (&block.action, block.state.plane) {
        let [u, v, _] = plane.axes();
        if let (Some(first), Some(second)) = (linear[u], linear[v]) {
            let (x, y) = (before[first] - centre[u], before[second] - centre[v]);
            let (sine, cosine) = (sweep * share).sin_cos();
            words[first] = centre[u] + x * cosine - y * sine;
            words[second] = centre[v] + x * sine + y * cosine;
        }
    }
    words
}
