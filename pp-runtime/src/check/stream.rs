//! The executed program as a stream: each block with the state before and after it, the path of the axes, the record of
//! the CL data that it carries out, and the findings about it.
//!
//! Positions are axis values of the machine; [`Leg::pose`] has tip and tool axis on the workpiece. A block whose words
//! are not all known begins at a position that the observer gives ([`ExecutedBlock::legs_from`]).

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::kinematics::{AnyMachine, AxisValues, Pose};
use crate::program::Location;

#[cfg(feature = "simulate")]
use super::geometry::angle_between;
use super::geometry::{PathShape, Segment, ToolPose};
use super::policy::RetractRule;
#[cfg(feature = "simulate")]
use super::policy::TipFrame;
use super::read::{Action, ArcMove, Block, CycleKind, CycleMove, FeedMode, MAX_AXES, State, TipControl};
use super::rules::{BlockPath, Rules};
#[cfg(feature = "simulate")]
use crate::kinematics::{AxisKind, AxisRanges, Side, StepBound};

/// Receives the blocks of a program in the order in which they are executed.
pub trait Observer {
    /// A block has been executed and compared. Blocks without effect are included, comments are not.
    fn executed(&mut self, executed: &ExecutedBlock<'_>);
}

impl<F: FnMut(&ExecutedBlock<'_>)> Observer for F {
    fn executed(&mut self, executed: &ExecutedBlock<'_>) {
        self(executed);
    }
}

/// A block of a program that has been executed.
pub struct ExecutedBlock<'b> {
    /// The block with the state after it.
    pub block: &'b Block,
    /// State before it.
    pub before: &'b State,
    /// Record of the CL data that was next, or the last one.
    pub record: Location,
    /// Number of the operation of that record, from 1; 0 before the first.
    pub operation: u64,
    /// Material that this operation leaves on the design, mm.
    pub allowance_mm: f64,
    /// Number of findings about it.
    pub findings: u64,
    /// Largest deviation of the tip from the path of the CL data, mm; `None` where it is not measured.
    pub deviation_mm: Option<f64>,
    /// Words before the block, and the bits of those that are known and have the same meaning in the block.
    pub(super) from: [f64; MAX_AXES],
    pub(super) known: u16,
    pub(super) rules: &'b Rules<'b>,
}

/// A part of a block in which the axes move at feed or at rapid: an arc, or a straight line of the words.
pub struct Leg<'b> {
    /// At rapid.
    pub rapid: bool,
    /// All axes arrive together; otherwise each moves on its own, and the path between the ends is unknown.
    pub together: bool,
    block: Block,
    from: [f64; MAX_AXES],
    /// Tool axis before the leg, where the control rotates it evenly in a plane and finds the rotary axes.
    axis: Option<Vector3<f64>>,
    rules: &'b Rules<'b>,
}

impl ExecutedBlock<'_> {
    /// Position of the part zero from the reference point of the table in the set-up of the block, mm.
    #[must_use]
    pub fn part_origin(&self) -> Vector3<f64> {
        self.rules.words().part_origin()
    }

    /// Number of the set-up.
    #[must_use]
    pub fn set_up(&self) -> u32 {
        self.rules.set_up()
    }

    /// The machine with the part and the tool of the block.
    #[must_use]
    pub fn machine(&self) -> &dyn AnyMachine {
        self.rules.machine()
    }

    /// Machine coordinate of a linear axis less its value and its `machine_zero`, mm: the share of the gauge length,
    /// and the place of the part zero in a further set-up.
    #[must_use]
    pub fn offset_mm(&self, axis: usize) -> f64 {
        self.rules.words().gauge_of(axis)
    }

    /// Axis values after the block as far as its words give them, and the bits of these axes, mm and rad.
    #[must_use]
    pub fn known_values(&self) -> (AxisValues, u16) {
        let (block, words) = (self.block, self.rules.words());
        let solved = words.linear_bits() | words.rotary_bits();
        let values = words.values(&block.values);
        let given = if block.state.has_frame() { words.rotary_bits() } else { solved };
        match words.axes(&block.values, &block.state) {
            Some(values) if block.known & solved == solved => (values, !0),
            _ => (values, block.known & given | !solved),
        }
    }

    /// Machine coordinates to which the axes of `written` move, mm and rad; `None` where they do not move to positions
    /// of the machine, or these are unknown. The reference position and the end of the travel are where the
    /// configuration has them.
    #[must_use]
    pub fn machine_values(&self) -> Option<[f64; MAX_AXES]> {
        let links = &self.rules.policy().links;
        let (retract, axes) = (self.rules.words().retract(), self.rules.axes());
        let home = |index: usize| match index == retract {
            true => Some(links.retract_mm),
            false => links.home_mm.as_ref()?.get(&axes.get(index)?.letter).copied(),
        };
        match (self.block.action, links.retract) {
            (Action::Machine, _) => Some(self.block.values),
            (Action::Reference { direct: true }, RetractRule::ReferencePosition)
            | (Action::EndOfTravel, RetractRule::AlongTool) => {
                let mut values = self.block.values;
                for index in (0..MAX_AXES).filter(|index| self.block.written & (1 << index) != 0) {
                    values[index] = home(index)?;
                }
                Some(values)
            }
            _ => None,
        }
    }

    /// Whether the position is unknown after the block although it moves no axis: a stop, a declared effect. A change
    /// of the frame of the words is none, since it leaves the rotary axes known.
    #[must_use]
    pub fn loses_position(&self) -> bool {
        let rotary = self.rules.words().rotary_bits();
        let axes = if rotary == 0 { !0 } else { rotary };
        match self.block.action {
            Action::Stop | Action::OptionalStop => true,
            Action::Nothing | Action::Dwell(_) => self.known & axes != 0 && self.block.known & axes == 0,
            _ => false,
        }
    }

    /// Tool axis in the tilted plane after the block.
    #[must_use]
    pub fn plane_axis(&self) -> Option<UnitVector3<f64>> {
        let block = self.block;
        block.state.tilt.map(|_| UnitVector3::new_normalize(self.rules.pose(block).axis))
    }

    /// The parts of the block, in order; none where nothing moves, where the start is unknown, and for machine
    /// coordinates.
    ///
    /// A cycle has its rapid over the hole and down to the clearance level, the feed to the bottom, and the way out;
    /// its pecks are the control's own.
    #[must_use]
    pub fn legs(&self) -> Vec<Leg<'_>> {
        if !self.rules.is_known(self.block, self.known & self.block.known) {
            return Vec::new();
        }
        let axis = self.rotates_in_plane().then(|| self.rules.words().place(&self.from, self.before).axis);
        self.legs_of(self.from, self.block.values, axis)
    }

    /// The parts of the block from a known position of the axes, mm and rad: it is where the axes are whose words are
    /// unknown, or counted in another frame before the block.
    #[must_use]
    pub fn legs_from(&self, position: &AxisValues) -> Vec<Leg<'_>> {
        let (block, words) = (self.block, self.rules.words());
        let Some(here) = words.words_at(position, &block.state) else { return Vec::new() };
        let or_here = |known: u16, stated: &[f64; MAX_AXES]| {
            std::array::from_fn(|index| if known & (1 << index) == 0 { here[index] } else { stated[index] })
        };
        let axis = self.rotates_in_plane().then(|| words.chain().place(position).axis);
        self.legs_of(or_here(self.known & block.known, &self.from), or_here(block.known, &block.values), axis)
    }

    /// Whether the control rotates the tool axis evenly in a plane between the ends of the block.
    fn rotates_in_plane(&self) -> bool {
        let state = &self.block.state;
        let together =
            self.block.action.is_feed() || self.block.action.is_rapid() && self.rules.rapids_are_interpolated();
        let tip_control = matches!(state.tip_control, TipControl::On { .. });
        state.vector.is_some() || together && tip_control && self.rules.policy().words.axis_in_plane
    }

    fn legs_of(&self, from: [f64; MAX_AXES], to: [f64; MAX_AXES], axis: Option<Vector3<f64>>) -> Vec<Leg<'_>> {
        let block = self.block;
        let leg = |action: Action, state: State, from: [f64; MAX_AXES], to: [f64; MAX_AXES]| Leg {
            rapid: action.is_rapid(),
            together: !action.is_rapid() || self.rules.rapids_are_interpolated(),
            block: Block { action, state, values: to, faults: Vec::new(), ..block.clone() },
            from,
            axis,
            rules: self.rules,
        };
        match block.action {
            Action::Rapid | Action::Feed | Action::Arc(_) => vec![leg(block.action, block.state, from, to)],
            Action::Cycle(cycle) => {
                let normal = block.state.plane.and_then(|plane| self.rules.words().xyz()[plane.axes()[2]]);
                let Some(normal) = normal else { return Vec::new() };
                let at = |level: f64| {
                    let mut words = to;
                    words[normal] = level;
                    words
                };
                let over = at(from[normal].max(cycle.reference));
                let (start, bottom, back) = (at(cycle.reference), at(cycle.bottom), at(cycle.back_to));
                let out = if cycle.retracts_at_feed() { Action::Feed } else { Action::Rapid };
                let legs = [
                    (Action::Rapid, from, over),
                    (Action::Rapid, over, start),
                    (Action::Feed, start, bottom),
                    (out, bottom, start),
                    (Action::Rapid, start, back),
                ];
                let state = cycle_state(&cycle, &block.state);
                let moves = |(_, from, to): &(Action, [f64; MAX_AXES], [f64; MAX_AXES])| {
                    from.iter().zip(to).any(|(from, to)| (from - to).abs() > 0.0)
                };
                legs.into_iter().filter(moves).map(|(action, from, to)| leg(action, state, from, to)).collect()
            }
            Action::Nothing
            | Action::Machine
            | Action::Reference { .. }
            | Action::EndOfTravel
            | Action::Orient
            | Action::Dwell(_)
            | Action::ToolChange
            | Action::Stop
            | Action::OptionalStop
            | Action::End => Vec::new(),
        }
    }
}

/// The state of a cycle: its own feed, and in a thread the feed that follows from its pitch.
fn cycle_state(cycle: &CycleMove, state: &State) -> State {
    match cycle.kind {
        CycleKind::Tap(pitch_mm) => {
            let feed = Some(pitch_mm.abs() / state.units.unwrap_or_default().in_mm());
            State { feed, feed_mode: Some(FeedMode::PerRevolution), ..*state }
        }
        _ => State { feed: cycle.feed.or(state.feed), ..*state },
    }
}

impl Leg<'_> {
    fn words(&self, share: f64) -> [f64; MAX_AXES] {
        let path: BlockPath<'_> = self.rules.path(self.from, &self.block);
        path.at(share)
    }

    /// Axis values at a share of the leg, 0 to 1, in mm and rad and in the order of the chain; `None` where the control
    /// chooses the rotary axes.
    #[must_use]
    pub fn axis_values(&self, share: f64) -> Option<AxisValues> {
        let between = share > 0.0 && share < 1.0;
        if between && self.axis.is_some() {
            None
        } else {
            self.rules.words().axes(&self.words(share), &self.block.state)
        }
    }

    /// Tip and tool axis on the workpiece at a share of the leg, mm.
    #[must_use]
    pub fn pose(&self, share: f64) -> Pose {
        let words = self.rules.words();
        let here = words.place(&self.words(share), &self.block.state);
        let pose = self.axis.map_or(here, |axis| {
            let to = ToolPose { axis: words.place(&self.block.values, &self.block.state).axis, ..here };
            Segment { from: ToolPose { axis, ..here }, to, shape: PathShape::Line }.at(share)
        });
        Pose { tip: Point3::from(pose.tip), axis: UnitVector3::new_normalize(pose.axis) }
    }

    /// Deviation of a part of the leg from the motion in step with it, between two shares and the axis values there: an
    /// upper bound.
    #[cfg(feature = "simulate")]
    #[must_use]
    pub fn step_bound(&self, machine: &dyn AnyMachine, shares: [f64; 2], [from, to]: [&AxisValues; 2]) -> StepBound {
        if let Action::Arc(arc) = self.block.action {
            // The tool axis stays; a point of a circle leaves the even chord by an eighth of its second derivative.
            let plane = self.block.state.plane.map_or([0, 1], |plane| [plane.axes()[0], plane.axes()[1]]);
            let radius = |words: &[f64; MAX_AXES]| {
                let from = plane
                    .map(|index| self.rules.words().xyz()[index].map_or(0.0, |axis| words[axis] - arc.centre[index]));
                from[0].hypot(from[1])
            };
            let (largest, angle) =
                (radius(&self.from).max(radius(&self.block.values)), arc.sweep * (shares[1] - shares[0]));
            // A spiral of rounded ends moves outwards while it rotates.
            let drift = (radius(&self.from) - radius(&self.block.values)).abs() * (shares[1] - shares[0]);
            let tip = (largest * angle * angle + 2.0 * drift * angle.abs()) / 8.0;
            return StepBound { tip, axis: 0.0 };
        }
        if self.axis.is_some() {
            // Evenly on a great circle: from the chord by no more than θ³/100.
            let [a, b] = shares.map(|share| self.pose(share).axis.into_inner());
            let angle = angle_between(&a, &b);
            return StepBound { tip: 0.0, axis: angle.powi(3) / 100.0 };
        }
        let bound = StepBound::of(machine, from, to);
        match self.block.state.tip_control {
            TipControl::On { .. } => StepBound { tip: self.tip_bound(machine, [from, to]), ..bound },
            TipControl::Off => bound,
        }
    }

    /// Deviation of the tip on the workpiece from an even motion on its chord under tip control: an upper bound, mm.
    ///
    /// The words are on a straight line of their frame. A frame that is fixed to the machine rotates on the workpiece:
    /// with `p(s) = R(s) w(s)` the second derivative is `|R'' w + 2 R' w'|`, and the deviation an eighth of it.
    #[cfg(feature = "simulate")]
    fn tip_bound(&self, machine: &dyn AnyMachine, [from, to]: [&AxisValues; 2]) -> f64 {
        if self.rules.policy().words.tip_frame != TipFrame::Machine {
            return 0.0;
        }
        let table = machine.axes().iter().enumerate().filter(|(_, axis)| axis.side == Side::Workpiece);
        let rotary: Vec<usize> =
            table.filter(|(_, axis)| axis.kind == AxisKind::Rotary).map(|(index, _)| index).collect();
        let angle: f64 = rotary.iter().map(|&index| (to[index] - from[index]).abs()).sum();
        let tips = [from, to].map(|axes| machine.forward_kinematics(axes).tip);
        let travel = (tips[1] - tips[0]).norm();
        let lever = |index: usize| {
            let unit = std::array::from_fn(|other| f64::from(other == index));
            machine.rates(from, &unit).0.norm() + travel
        };
        let lever = rotary.iter().map(|&index| lever(index)).fold(0.0, f64::max) * (1.0 + angle);
        (angle * angle * lever + 2.0 * angle * (travel + angle * lever)) / 8.0
    }

    /// Smallest and largest axis values between two shares and the axis values there; `None` where they are not found:
    /// the part is too long, or near a pole.
    #[cfg(feature = "simulate")]
    #[must_use]
    pub fn axis_ranges(
        &self,
        machine: &dyn AnyMachine,
        shares: [f64; 2],
        [from, to]: [&AxisValues; 2],
    ) -> Option<AxisRanges> {
        if self.axis.is_some() {
            let [a, b] = shares.map(|share| self.pose(share).axis.into_inner());
            return AxisRanges::of_great_circle(machine, from, to, angle_between(&a, &b));
        }
        match (self.block.action, self.block.state.tip_control) {
            (Action::Arc(_), _) | (_, TipControl::On { .. }) => {
                AxisRanges::of_tip(machine, from, to, self.step_bound(machine, shares, [from, to]).tip)
            }
            _ => Some(AxisRanges::between(from, to)),
        }
    }

    /// Time at the F in force, min; `None` at rapid and without F. `length_mm`: length of the tip path.
    #[must_use]
    pub fn minutes(&self, length_mm: f64) -> Option<f64> {
        let words = self.rules.words();
        let axes = |at: &[f64; MAX_AXES]| words.axes(at, &self.block.state).unwrap_or_else(|| words.values(at));
        let ends = [axes(&self.from), axes(&self.block.values)];
        if self.rapid { None } else { self.rules.minutes([&ends[0], &ends[1]], length_mm, &self.block.state) }
    }

    /// Angle of an arc about the normal of its plane, rad; 0 for a straight line.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        match self.block.action {
            Action::Arc(ArcMove { sweep, .. }) => sweep,
            _ => 0.0,
        }
    }
}
