//! The rules that a program is compared with: meaning of its words, rounding, F, modal state.
//!
//! [`Rules`] is what is given for a whole program, apart from the tool in the spindle. `words` converts words into tip
//! and tool axis, `feed` has the rules of F, `state` the modal state of a block, `fit` whether a block ends on a
//! motion, and `arc` the blocks along arcs.

mod arc;
mod feed;
mod fit;
mod state;
mod words;

use std::cell::Cell;
use std::f64::consts::{PI, TAU};

use nalgebra::{Vector1, Vector3};

use crate::check::tolerances::{AXIS_NOISE, RETRACT_ALONG_TOOL, SAME_COORDINATE, SAME_LINEAR_WORD, TIP_NOISE};
use crate::kinematics::{AnyMachine, Axis, AxisKind, Side};
use crate::program::{Feed, Units};

use super::expect::{ClMotion, Required};
use super::geometry::{Segment, ToolPose, angle_between, is_within_angle};
use super::policy::{CheckPolicy, LinearMeaning, RapidForm};
use super::read::{Block, Facts, MAX_AXES, OwnPlace, State, TipControl, WorkOffset};
pub(super) use arc::WordsAlongArc;
pub(super) use feed::{FeedLaw, Stroke};
use fit::FastestStep;
pub(super) use fit::{Arrival, BlockPath, Deviation, DeviationBound, chord, sweep};
pub(super) use state::{FrameUse, ModalContext, OffsetsInForce, StateFault, StateItem, fault_at_end, tool_name};
pub(super) use words::MachineWords;

/// Allowance for rounded words.
#[derive(Debug, Clone, Copy)]
pub(super) struct WordRounding {
    /// One unit of linear words.
    pub(crate) unit_mm: f64,
    /// One unit of rotary words.
    pub(crate) unit_rad: f64,
    /// Tip at the end of a block.
    pub(crate) tip_mm: f64,
    /// Tool axis at the end of a block.
    pub(crate) axis_rad: f64,
    /// Tool axis that is put at the pole.
    pub(crate) pole_rad: f64,
    /// Tool axis of rotary words alone.
    pub(crate) rotary_rad: f64,
    /// Added in a tilted plane, whose angles are coarser than rotary words, and whether it is.
    plane_rad: f64,
    in_plane: bool,
}

/// The rules for one program.
#[derive(Clone)]
pub(super) struct Rules<'a> {
    policy: &'a CheckPolicy,
    facts: Facts,
    machine: Box<dyn AnyMachine>,
    words: MachineWords,
    /// Number of the set-up.
    set_up: u32,
    /// Meaning of linear words since the last approach.
    meaning: LinearMeaning,
    /// Since then tip control is on, or a plane is tilted.
    framed: bool,
    law: FeedLaw,
    rounding: WordRounding,
    units: Units,
    /// States of a program before that must be ended: bits of `settled`.
    left_over: u32,
    /// States of the frames that the program has used: bits of `settled`.
    frames_used: u32,
    /// Work offset of each set-up.
    offsets: Vec<(u32, WorkOffset)>,
    /// Rotary axes with clamps: bits.
    clamps: u16,
    /// Direction of the first rotary axis.
    pole: Option<Vector3<f64>>,
    /// Largest rotation of the rotary axes at the end of a motion, with the tool where it is, rad.
    largest_rest_rad: f64,
    /// Outside tip control and planes the machine retract leads along the tool axis.
    retracts_along_tool: bool,
    /// Why the control has no dynamic work offset for this machine and set-up.
    dynamic_offset_fault: Option<&'static str>,
    /// The last even rotation: tool axis at its end, and the words there.
    even_end: Cell<Option<(Vector3<f64>, [f64; MAX_AXES])>>,
}

impl<'a> Rules<'a> {
    pub(super) fn new(machine: Box<dyn AnyMachine>, policy: &'a CheckPolicy, units: Units) -> Self {
        let facts = policy.family.facts();
        let words = MachineWords::new(&*machine, policy);
        let rounding = WordRounding::new(&*machine, policy, units, words.rotary_bits().count_ones());
        // The axis that rotates at a pole.
        let first_rotary = words.rotary().next();
        let law = FeedLaw::new(&*machine, policy, units, &words, &rounding);
        Self {
            policy,
            facts,
            words,
            set_up: 1,
            law,
            rounding,
            units,
            left_over: state::left_over(policy, &facts),
            frames_used: 0,
            offsets: state::offsets(&policy.set_up, &facts),
            clamps: policy.shop.lines.iter().fold(0, |bits, line| match line.place {
                OwnPlace::Clamp { axis, .. } => bits | 1 << axis,
                _ => bits,
            }),
            largest_rest_rad: largest_rest_rad(machine.axes(), policy, first_rotary),
            pole: first_rotary.map(|index| machine.joint(index).direction.into_inner()),
            retracts_along_tool: retracts_along_tool(&*machine),
            dynamic_offset_fault: dynamic_offset_fault(&*machine, policy),
            even_end: Cell::new(None),
            meaning: policy.linear_of_all().unwrap_or(LinearMeaning::AxisPositions),
            framed: false,
            machine,
        }
    }

    pub(super) fn policy(&self) -> &'a CheckPolicy {
        self.policy
    }

    pub(super) fn facts(&self) -> &Facts {
        &self.facts
    }

    pub(super) fn axes(&self) -> &[Axis] {
        self.machine.axes()
    }

    pub(super) fn machine(&self) -> &dyn AnyMachine {
        &*self.machine
    }

    pub(super) fn words(&self) -> &MachineWords {
        &self.words
    }

    pub(super) fn law(&self) -> &FeedLaw {
        &self.law
    }

    pub(super) fn rounding(&self) -> &WordRounding {
        &self.rounding
    }

    /// Whether all axes of a rapid arrive together.
    pub(super) fn rapids_are_interpolated(&self) -> bool {
        self.policy.feed.rapids_interpolated.unwrap_or(self.facts.rapids_interpolated)
    }

    /// Whether the retract axis leads along the tool at any rotary angles, by the linear words of the cut.
    pub(super) fn retracts_along_tool(&self) -> bool {
        self.retracts_along_tool && !self.framed
    }

    /// Whether a motion along the tool, in the state of its block, is one of the retract axis alone.
    pub(super) fn tool_leads_along_retract(&self, state: &State) -> bool {
        self.retracts_along_tool && !is_framed(state)
    }

    /// Meaning of linear words.
    pub(super) fn meaning(&self) -> LinearMeaning {
        self.meaning
    }

    /// Takes tip control and planes of a block away from the part. They decide the meaning of linear words, where the
    /// policy does not.
    pub(super) fn follow_frame(&mut self, state: &State) {
        self.framed = is_framed(state);
        self.frames_used |= state::frame_bits(state);
        if self.policy.linear_of_all().is_none() {
            self.meaning = match state.tip_control {
                TipControl::On { .. } => LinearMeaning::TipCoordinates,
                TipControl::Off if state.has_frame() => LinearMeaning::PlaneCoordinates,
                TipControl::Off => LinearMeaning::AxisPositions,
            };
            self.law.follow(self.meaning);
            self.rounding = self.rounding.for_words(self.meaning);
        }
    }

    pub(super) fn units(&self) -> Units {
        self.units
    }

    /// Rotary axes with clamps: bits.
    pub(super) fn clamps(&self) -> u16 {
        self.clamps
    }

    /// Rotary axes that a block moves, apart from rounding, or whose words were unknown before it: bits.
    pub(super) fn moved(&self, before: &[f64; MAX_AXES], known: u16, block: &Block) -> u16 {
        self.moved_by_more(self.words.rotary(), 0.5 * self.rounding.unit_rad, (before, known, block))
    }

    /// All axes that a block moves, as [`moved`](Self::moved); rounding hides no motion of a linear one.
    pub(super) fn all_moved(&self, before: &[f64; MAX_AXES], known: u16, block: &Block) -> u16 {
        let linear = (0..MAX_AXES).filter(|index| self.words.rotary_bits() & (1 << index) == 0);
        self.moved(before, known, block) | self.moved_by_more(linear, SAME_LINEAR_WORD, (before, known, block))
    }

    fn moved_by_more(
        &self,
        axes: impl Iterator<Item = usize>,
        least: f64,
        (before, known, block): (&[f64; MAX_AXES], u16, &Block),
    ) -> u16 {
        let moved = |index: &usize| {
            let bit = 1 << index;
            block.written & bit != 0 && (known & bit == 0 || (block.values[*index] - before[*index]).abs() > least)
        };
        axes.filter(moved).fold(0, |bits, index| bits | 1 << index)
    }

    /// Puts another tool into the spindle.
    pub(super) fn set_tool(&mut self, gauge_length_mm: f64) {
        self.words.set_tool(&mut *self.machine, gauge_length_mm);
    }

    /// Clamps the part of a set-up.
    pub(super) fn set_part(&mut self, set_up: u32) {
        self.set_up = set_up;
        if let Some(part) = self.policy.set_up.clamping(set_up) {
            self.words.set_part(&mut *self.machine, part.part_origin.into());
        }
    }

    /// Number of the set-up.
    pub(super) fn set_up(&self) -> u32 {
        self.set_up
    }

    /// Time of a feed block from one position of the axes to another, as its F programs it, min; `None` without one.
    /// `length_mm`: its tip path.
    pub(super) fn minutes(&self, [from, to]: [&[f64; MAX_AXES]; 2], length_mm: f64, state: &State) -> Option<f64> {
        let change = std::array::from_fn(|index| to[index] - from[index]);
        let (longest_mm, tip_rate_mm, feed, speed_rev_per_min) = (length_mm, [0.0; 2], None, None);
        self.law.minutes(
            &Stroke {
                length_mm,
                longest_mm,
                tip_rate_mm,
                perpendicular: self.is_perpendicular(|| *to),
                change,
                uneven: None,
                feed,
                speed_rev_per_min,
            },
            state,
        )
    }

    /// Axes whose position must be known for tip and tool axis: bits.
    pub(super) fn needed(&self, block: &Block) -> u16 {
        let rotary = if block.state.vector.is_some() { 0 } else { self.words.rotary_bits() };
        self.words.linear_bits() | rotary
    }

    /// Whether tip and tool axis after a block are known.
    pub(super) fn is_known(&self, block: &Block, known: u16) -> bool {
        let needed = self.needed(block);
        known & needed == needed
    }

    /// Tip and tool axis after a block.
    pub(super) fn pose(&self, block: &Block) -> ToolPose {
        self.words.place(&block.values, &block.state)
    }

    /// Tip and tool axis of other words in the state of a block.
    pub(super) fn pose_from(&self, words: &[f64; MAX_AXES], block: &Block) -> ToolPose {
        self.words.place(words, &block.state)
    }

    /// Whether a pose is another, apart from rounding.
    pub(super) fn is_at(&self, here: &ToolPose, there: &ToolPose) -> bool {
        self.is_near(here, there, [1.0; 2])
    }

    /// Whether a pose is another within multiples of the allowances for tip and tool axis.
    pub(super) fn is_near(&self, here: &ToolPose, there: &ToolPose, [tip, axis]: [f64; 2]) -> bool {
        (here.tip - there.tip).norm() <= tip * self.rounding.tip_mm && self.is_axis_near(&here.axis, &there.axis, axis)
    }

    /// Whether a tool axis is another, within a multiple of the allowance for that: more where it may be led.
    pub(super) fn is_axis_near(&self, here: &Vector3<f64>, there: &Vector3<f64>, times: f64) -> bool {
        let WordRounding { axis_rad, pole_rad, .. } = self.rounding;
        is_within_angle(here, there, times * axis_rad)
            || is_within_angle(here, there, times * pole_rad) && self.may_be_led(there)
    }

    /// Allowance for a tool axis, rad: one near the pole or a step is put there.
    pub(super) fn axis_allowance(&self, axis: &Vector3<f64>) -> f64 {
        if self.may_be_led(axis) { self.rounding.pole_rad } else { self.rounding.axis_rad }
    }

    /// Whether a tool axis may be led to the pole, or to a step of an indexed axis.
    pub(super) fn may_be_led(&self, axis: &Vector3<f64>) -> bool {
        let tolerances = &self.policy.tolerances;
        tolerances.has_steps || self.pole.is_some_and(|pole| pole.cross(axis).norm() <= tolerances.pole_rad)
    }

    /// Largest rotation of the rotary axes at the end of a motion, with the tool where it is, rad.
    pub(super) fn largest_rest_rad(&self) -> f64 {
        self.largest_rest_rad + self.rounding.unit_rad
    }

    /// Angle between a tool axis and the nearest pole, rad; infinite without a pole.
    pub(super) fn off_pole_rad(&self, axis: &Vector3<f64>) -> f64 {
        self.pole.map_or(f64::INFINITY, |pole| angle_between(&pole, axis).min(angle_between(&-pole, axis)))
    }

    /// Whether a block rotates a rotary axis by more than the index angle.
    pub(super) fn rotates(&self, before: &[f64; MAX_AXES], known: u16, block: &Block) -> bool {
        let largest = self.policy.links.index_angle_rad + 1.5 * self.rounding.unit_rad;
        let moved = |index: usize| known & (1 << index) != 0 && (block.values[index] - before[index]).abs() > largest;
        self.words.rotary().any(moved)
    }

    /// Feed of a motion that is not a rapid of the program.
    pub(super) fn feed_of(&self, motion: &ClMotion) -> Option<Feed> {
        match motion.rapid {
            true => self.policy.links.rapid_feed_mm_per_min.map(Feed::PerMinute),
            false => motion.feed,
        }
    }

    /// The motion of a feed block from the words before it, whose tip is led evenly. `length_mm`: its tip path as
    /// rounded ends show it, and the length that it cannot exceed.
    pub(super) fn stroke(
        &self,
        before: &[f64; MAX_AXES],
        block: &Block,
        (length_mm, longest_mm): (f64, f64),
        feed: Option<Feed>,
        required: &Required,
    ) -> Stroke {
        let axes = |words: &[f64; MAX_AXES]| self.words.axes(words, &block.state);
        let follows = self.law.needs_axes() && block.state.has_frame();
        let axes = if follows { axes(before).zip(axes(&block.values)) } else { None };
        let change = match axes {
            Some((from, to)) => std::array::from_fn(|index| to[index] - from[index]),
            None => self.words.change(before, &block.values),
        };
        // Where the same coordinates of the tip are programmed again, rounding hides no motion.
        let same = |index: Option<usize>| {
            index.is_none_or(|index| (before[index] - block.values[index]).abs() < SAME_COORDINATE)
        };
        let tip = self.meaning == LinearMeaning::TipCoordinates;
        let rests = tip && length_mm < 0.5 * self.rounding.unit_mm && self.words.xyz().into_iter().all(same);
        let longest_mm = if rests { 0.0 } else { longest_mm };
        let speed_rev_per_min = required.spindle.map(|(speed, _)| speed);
        let uneven = self.uneven(before, block);
        let perpendicular = self.is_perpendicular(|| self.words.values(&block.values));
        Stroke { length_mm, longest_mm, tip_rate_mm: [0.0; 2], perpendicular, change, uneven, feed, speed_rev_per_min }
    }

    /// Whether the linear axes are perpendicular at these axis values, in general or because of the rotary ones.
    pub(super) fn is_perpendicular(&self, values: impl FnOnce() -> [f64; MAX_AXES]) -> bool {
        !self.law.needs_directions() || self.words.is_perpendicular(&values())
    }

    /// Whether F of a block that goes along a motion is right whatever the largest speed of the tip times the time of
    /// the block is between these bounds, mm; `false` where that is not decided. The tip of `stroke` is led evenly.
    #[inline(always)]
    pub(super) fn is_feed_plainly_right(
        &self,
        stroke: &Stroke,
        state: &State,
        [smallest_mm, largest_mm]: [f64; 2],
        required: &Required,
    ) -> bool {
        let least_mm = tip_rates(largest_mm, required)[0];
        let most_mm = if smallest_mm > 0.0 { tip_rates(smallest_mm, required)[1] } else { 0.0 };
        state.vector.is_none() && self.law.is_plainly_right(stroke, state, [least_mm, most_mm])
    }

    /// Largest speeds of the axes in a block along an arc, or under tip control that rotates, by the axis values at
    /// many places of the block, times its time; `None` where the axes move evenly, or the control slows down for them.
    fn uneven(&self, before: &[f64; MAX_AXES], block: &Block) -> Option<Box<[f64; MAX_AXES]>> {
        if !self.law.needs_axes() {
            return None;
        }
        if let Some(arc) = self.path(*before, block).arc() {
            return self.fastest_on_arc(&arc, &block.state).map(Box::new);
        }
        let follows = block.state.tip_control != TipControl::Off && block.state.vector.is_none();
        if !follows || self.facts.tip_control_holds_axis_speeds {
            return None;
        }
        let rotation: f64 = self.words.rotary().map(|index| (block.values[index] - before[index]).abs()).sum();
        if rotation <= 0.0 {
            return None;
        }
        let parts = (rotation / UNEVEN_PART_RAD).ceil().clamp(4.0, 512.0);
        let mut fastest = [FastestStep::<1>::default(); MAX_AXES];
        let mut last = self.words.axes(before, &block.state)?;
        for part in 1..=parts as u32 {
            let share = f64::from(part) / parts;
            let words = std::array::from_fn(|index| before[index] + share * (block.values[index] - before[index]));
            let axes = self.words.axes(&words, &block.state)?;
            for (index, fastest) in fastest.iter_mut().enumerate() {
                fastest.add(Vector1::new(axes[index] - last[index]));
            }
            last = axes;
        }
        Some(Box::new(fastest.map(|fastest| fastest.largest() * parts)))
    }

    /// What is wrong with F of a block that goes from one pose to another on a motion. With a tool vector the rotation
    /// of the rotary axes is the control's own.
    pub(super) fn feed_fault(
        &self,
        stroke: &Stroke,
        state: &State,
        segment: &Segment,
        ends: [&ToolPose; 2],
    ) -> Option<String> {
        let law = &self.law;
        if state.vector.is_none() {
            return law.wrong(stroke, state);
        }
        let rotates = segment.turn() > 0.0;
        let changes = || rotates.then(|| self.changes(ends));
        let along = || match law.needs_axes() {
            true => law.wrong_within(stroke, state, changes),
            false => law.wrong(stroke, state),
        };
        if !(rotates && law.may_be_still(stroke)) {
            return along();
        }
        let on_the_spot = law.wrong_on_the_spot(state)?;
        if law.may_move(stroke) { along().map(|_| on_the_spot) } else { Some(on_the_spot) }
    }

    /// How far the axes may move between two poses. Near a pole the control chooses how far the rotary axes rotate: by
    /// any angle that a rest at the pole may have.
    fn changes(&self, ends: [&ToolPose; 2]) -> Vec<[f64; MAX_AXES]> {
        let turn = angle_between(&ends[0].axis, &ends[1].axis);
        let far = ends.iter().all(|end| self.off_pole_rad(&end.axis) > 2.0 * turn);
        if far { self.words.changes(ends) } else { self.words.changes_near_pole(ends, self.largest_rest_rad()) }
    }

    /// Rotary axes that rotate from one tool axis to another, in each position that they may have: bits.
    pub(super) fn rotated_for(&self, from: &Vector3<f64>, to: &Vector3<f64>) -> u16 {
        self.words.rotated_for([from, to], self.policy.links.index_angle_rad + 1.5 * self.rounding.unit_rad)
    }

    /// Whether the words of the block mirror the plane of the path: left of the words is right of the path.
    fn is_mirrored(&self, block: &Block) -> bool {
        let tip = |values: &[f64; MAX_AXES]| self.words.place(values, &block.state).tip;
        let here = tip(&block.values);
        let steps = self.words.xyz().map(|index| {
            let mut values = block.values;
            values[index?] += 1.0;
            Some(tip(&values) - here)
        });
        matches!(steps, [Some(x), Some(y), Some(z)] if x.cross(&y).dot(&z) < 0.0)
    }

    /// Axis values of the linear axes other than the retract axis after a block of an approach; `None` if they depend
    /// on its position. `before`: the words before the block.
    pub(super) fn across(&self, before: &[f64; MAX_AXES], block: &Block) -> Option<[f64; MAX_AXES]> {
        self.words.across(&block.values, rotary_words(before, block), &block.state, self.rounding.plane_rad)
    }

    /// Whether a block of an approach moves the retract axis alone, but for rounding, and for that of the angles of a
    /// plane. `across`: the other axes before it.
    pub(super) fn moves_retract_axis_alone(
        &self,
        across: &[f64; MAX_AXES],
        before: &[f64; MAX_AXES],
        block: &Block,
        end: &ToolPose,
    ) -> bool {
        let allowed_mm = 2.0 * self.rounding.unit_mm + 2.0 * self.rounding.plane_rad * end.tip.norm();
        let off =
            |there: [f64; MAX_AXES]| across.iter().zip(there).map(|(at, end)| (at - end).powi(2)).sum::<f64>().sqrt();
        let same = |there: [f64; MAX_AXES]| off(there) <= allowed_mm;
        self.words.across_at(&block.values, rotary_words(before, block), &block.state).is_some_and(same)
    }

    /// Whether stretches may be under tip control.
    pub(super) fn may_have_tip_control(&self) -> bool {
        self.policy.linear_of_all().is_none_or(|meaning| meaning == LinearMeaning::TipCoordinates)
    }

    /// Whether rapids that rotate the tool would exceed the speeds of axes: under a tip control that does not hold
    /// them.
    fn rapids_exceed_speeds(&self) -> bool {
        let tip = self.meaning == LinearMeaning::TipCoordinates;
        tip && !self.facts.tip_control_holds_axis_speeds && self.law.needs_axes()
    }

    /// Form of the rapids of the CL data that rotate the tool at the part.
    pub(super) fn link_form(&self) -> RotatingRapid {
        let links = &self.policy.links;
        match links.rapid_feed_mm_per_min {
            _ if links.direct => RotatingRapid::OneRapid,
            _ if !links.follows_links => RotatingRapid::None,
            Some(_) if links.rapid == RapidForm::Feed => RotatingRapid::Feed,
            _ if self.rapids_are_interpolated() && !self.rapids_exceed_speeds() => RotatingRapid::Rapids,
            Some(_) => RotatingRapid::Feed,
            None => RotatingRapid::None,
        }
    }

    /// Whether a block may be a piece of a rapid of the CL data.
    fn may_be_in_pieces(&self, block: &Block) -> bool {
        let at_feed = block.action.is_feed();
        let form = self.link_form();
        self.policy.links.rapid == RapidForm::Feed
            || form == RotatingRapid::Feed && at_feed
            || form == RotatingRapid::Rapids && block.action.is_rapid()
    }
}

/// Bounds of the largest speed of the tip times the time of a block, mm, from that of a few points. They are followed
/// to a part of the tolerance; a bound of the speed may exceed it by more.
fn tip_rates(rate_mm: f64, required: &Required) -> [f64; 2] {
    [-0.25, 1.0].map(|share| rate_mm + share * required.tolerance_mm)
}

/// Rotation between two places at which the axis values are compared, rad.
const UNEVEN_PART_RAD: f64 = 0.01;

/// Form of a rapid of the CL data that rotates the tool at the part by more than the index angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RotatingRapid {
    /// There is none: the machine retracts.
    None,
    /// One rapid, whatever its path.
    OneRapid,
    /// Rapids whose axes arrive together, on the path of the CL data.
    Rapids,
    /// Feed motions on the path of the CL data.
    Feed,
}

/// Words with those of the rotary axes after a block; where it gives the tool axis by its components, those before it.
fn rotary_words<'w>(before: &'w [f64; MAX_AXES], block: &'w Block) -> &'w [f64; MAX_AXES] {
    if block.state.vector.is_some() { before } else { &block.values }
}

/// Distance of a rotary axis from a position, rad; without limits it may be whole revolutions away.
pub(super) fn apart(value: f64, place: f64) -> f64 {
    let off = value - place;
    (off - (off / TAU).round() * TAU).abs()
}

impl WordRounding {
    fn new(machine: &dyn AnyMachine, policy: &CheckPolicy, units: Units, rotaries: u32) -> Self {
        let decimals = |digits: u32| 10_f64.powi(-(digits as i32));
        let unit_mm = decimals(policy.digits.linear(units)) * units.in_mm();
        let unit_rad = decimals(policy.digits.rotary).to_radians();
        let rotary_rad = 0.5 * unit_rad * f64::from(rotaries) * 1.01 + AXIS_NOISE;
        let pole_rad = rotary_rad.max(rotary_rad - AXIS_NOISE + policy.tolerances.pole_rad);
        let outside = Self {
            unit_mm,
            unit_rad,
            tip_mm: 0.5 * unit_mm * corner(machine) + TIP_NOISE,
            axis_rad: rotary_rad,
            pole_rad,
            rotary_rad,
            // Three angles, half a unit each: thousandths of a degree, or coarser rotary words.
            plane_rad: 1.5 * decimals(policy.digits.rotary.min(3)).to_radians(),
            in_plane: false,
        };
        outside.for_words(policy.linear_of_all().unwrap_or(LinearMeaning::AxisPositions))
    }

    /// Largest angle between the rounded tool axis and the normal of the rounded plane, rad.
    pub(crate) fn of_plane_rad(&self) -> f64 {
        self.axis_rad + 2.0 * self.plane_rad
    }

    /// Whether words are fine enough for a rotary position to be compared, and the rotation of the tool axis with an
    /// axis from which on rounded angles of a plane fix that position, rad per rad. `largest_rad`: difference that a
    /// guard allows.
    pub(crate) fn fixes_rotaries(&self, largest_rad: f64) -> Option<f64> {
        (self.unit_rad <= 0.4 * largest_rad).then(|| 2.0 * self.plane_rad / largest_rad)
    }

    /// The allowance for words of a meaning.
    fn for_words(self, meaning: LinearMeaning) -> Self {
        let in_plane = meaning == LinearMeaning::PlaneCoordinates;
        if in_plane == self.in_plane {
            return self;
        }
        let added = if in_plane { self.plane_rad } else { -self.plane_rad };
        Self { axis_rad: self.axis_rad + added, pole_rad: self.pole_rad + added, in_plane, ..self }
    }
}

fn is_solved(axis: &Axis, kind: AxisKind) -> bool {
    axis.kind == kind && !axis.held
}

/// Largest distance of the corner of a box from its middle, in halves of its edges: the sum of the rounding of every
/// linear word. With a rotary axis between two linear ones these may come to be nearly parallel.
fn corner(machine: &dyn AnyMachine) -> f64 {
    let axes = machine.axes();
    let linear: Vec<usize> = (0..axes.len()).filter(|&index| is_solved(&axes[index], AxisKind::Linear)).collect();
    if let [first, .., last] = linear[..]
        && axes[first..last].iter().any(|axis| is_solved(axis, AxisKind::Rotary))
        && !feed::is_perpendicular(machine)
    {
        return linear.len() as f64;
    }
    let directions: Vec<_> = linear.iter().map(|&index| machine.joint(index).direction.into_inner()).collect();
    let signs = (0..8_u8).map(|bits| {
        let signed = directions.iter().enumerate().map(|(index, d)| if bits & (1 << index) == 0 { *d } else { -d });
        signed.sum::<Vector3<f64>>().norm()
    });
    signs.fold(0.0, f64::max)
}

/// Half a revolution leads to every position at a pole; between its limits the first rotary axis may have to go the
/// longer way.
fn largest_rest_rad(axes: &[Axis], policy: &CheckPolicy, first_rotary: Option<usize>) -> f64 {
    let limits = policy.set_up.travel(axes).limits;
    let limited = first_rotary.is_some_and(|index| limits[index].is_some());
    if limited { TAU } else { PI }
}

/// What a dynamic work offset does not allow for (Haas, page of G254).
fn dynamic_offset_fault(machine: &dyn AnyMachine, policy: &CheckPolicy) -> Option<&'static str> {
    let mut axes = machine.axes().iter().filter(|axis| is_solved(axis, AxisKind::Rotary));
    if axes.any(|axis| axis.side == Side::Tool) {
        return Some("the dynamic work offset (G254) does not allow for a rotary axis in the head");
    }
    let moved = policy.set_up.rotary_offset.values().any(|offset| *offset != 0.0);
    moved.then_some("the dynamic work offset (G254) needs 0 for the rotary axes in the work offset (`rotary_offset`)")
}

/// Whether linear words are coordinates of the tip, or of a tilted plane. Those under a dynamic work offset are along
/// the axes.
fn is_framed(state: &State) -> bool {
    state.tip_control != TipControl::Off || state.tilt.is_some()
}

/// Whether no rotary axis is in the head and a linear axis is parallel to the tool.
fn retracts_along_tool(machine: &dyn AnyMachine) -> bool {
    let axes = || 0..machine.axes().len();
    let head = axes().any(|index| {
        let axis = &machine.axes()[index];
        is_solved(axis, AxisKind::Rotary) && axis.side == Side::Tool
    });
    let tool = machine.tool_axis();
    let along = |index: usize| {
        is_solved(&machine.axes()[index], AxisKind::Linear)
            && machine.joint(index).direction.dot(&tool).abs() > RETRACT_ALONG_TOOL
    };
    !head && axes().any(along)
}
