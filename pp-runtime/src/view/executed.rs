//! The executed program as points: ends of motions, as the check's reader understands the written text.
//!
//! A point has the axis values, tip and tool axis, and belongs to a line of the program. Arcs, tool vectors and
//! rotations are divided until a straight motion of the axes and a straight line of the tip both keep to the path
//! within the tolerance.
//!
//! The position of the machine is followed in machine coordinates. A block whose words are not all known, such as the
//! approach after a retract to a machine position, begins where the machine is. Where that is unknown, too, there is no
//! point; the next point begins a new path.

use std::f64::consts::{FRAC_PI_3, TAU};
use std::ops::Range;
use std::sync::Arc;

#[cfg(feature = "simulate")]
use crate::check::Leg;
use crate::check::read::{Action, MAX_AXES, State, TipControl};
use crate::check::{CheckPolicy, ExecutedBlock, Observer};
use crate::kinematics::{AnyMachine, Axis, AxisKind, AxisValues, Pose};
#[cfg(feature = "simulate")]
use crate::kinematics::{AxisRanges, StepBound};
use crate::set_up::SetUp;

/// Largest number of halvings of a motion: 4096 chords.
const MOST_HALVINGS: u32 = 12;

/// Largest deviation of a rapid from the straight motions that show it, mm, where the tolerance is finer.
const RAPID_MM: f64 = 0.2;

/// Points nearer to each other are one, mm: an arc ends within the rounding of its words.
const SAME_POINT_MM: f64 = 5e-3;

/// How the tool comes to a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PointKind {
    /// A path begins: nothing is known of the motion to this point.
    Start,
    /// At rapid.
    Rapid,
    /// At feed.
    Feed,
    /// The tool waits.
    Dwell,
}

impl PointKind {
    /// All kinds with their names.
    pub(crate) const NAMES: [&'static str; 4] = ["start", "rapid", "feed", "dwell"];
}

/// One point of the executed program. Lengths in mm, angles in rad.
#[derive(Debug, Clone)]
pub(crate) struct ExecutedPoint {
    pub(crate) axes: AxisValues,
    /// On the workpiece.
    pub(crate) pose: Pose,
    /// Line of the program.
    pub(crate) line: u64,
    /// Line of the CL data.
    pub(crate) cl_line: u64,
    pub(crate) kind: PointKind,
    /// Index in [`Executed::operations`].
    pub(crate) operation: usize,
    /// Index in [`Executed::placements`].
    pub(crate) placement: usize,
    /// Programmed feed of the tip, mm/min; 0 at rapid.
    pub(crate) feed: f64,
    /// Time of the motion to this point; `None` for a rapid of an axis of unknown speed.
    pub(crate) seconds: Option<f64>,
    /// Deviation of the tip from the path of the CL data, where the check measures it.
    pub(crate) deviation_mm: Option<f64>,
}

/// The machine with a tool and a clamping of the part.
#[derive(Debug, Clone)]
pub(crate) struct ExecutedPlacement {
    pub(crate) set_up: u32,
    /// 0 without a tool.
    pub(crate) tool: u32,
    pub(crate) machine: Arc<dyn AnyMachine>,
    /// Machine coordinate of each linear axis less its value and its `machine_zero`, mm.
    pub(crate) offsets_mm: [f64; MAX_AXES],
}

/// One operation as it is executed.
#[derive(Debug, Clone)]
pub(crate) struct ExecutedOperation {
    /// Number in the CL data, from 1.
    pub(crate) number: u64,
    /// Record of its first block.
    pub(crate) cl_line: u64,
    /// Tool and meaning of the linear words of its first cut.
    pub(crate) tool: u32,
    pub(crate) mode: &'static str,
    pub(crate) set_up: u32,
    pub(crate) first_point: usize,
    cuts: bool,
}

/// The executed program.
#[derive(Debug, Default)]
pub(crate) struct Executed {
    pub(crate) points: Vec<ExecutedPoint>,
    pub(crate) placements: Vec<ExecutedPlacement>,
    pub(crate) operations: Vec<ExecutedOperation>,
    /// Lines with a motion to a machine position whose start or end is unknown, in order.
    pub(crate) undrawn: Vec<u64>,
    /// In some rapids each axis moves on its own: their path is unknown, and drawn straight.
    pub(crate) rapids_apart: bool,
}

impl Executed {
    /// The points that follow each other without a gap, in order.
    pub(crate) fn paths(&self) -> impl Iterator<Item = Range<usize>> {
        let starts = self.points.iter().enumerate().skip(1).filter(|(_, point)| point.kind == PointKind::Start);
        let ends = starts.map(|(index, _)| index).chain([self.points.len()]);
        let mut begin = 0;
        ends.map(move |end| std::mem::replace(&mut begin, end)..end)
    }
}

/// A motion of the executed program.
#[cfg(feature = "simulate")]
pub(crate) struct ExecutedMotion<'m> {
    pub(crate) executed: &'m ExecutedBlock<'m>,
    /// The machine with part and tool.
    pub(crate) placement: &'m ExecutedPlacement,
    pub(crate) rapid: bool,
    /// All axes arrive together; otherwise each moves on its own.
    pub(crate) together: bool,
    pub(crate) start: ExecutedPlace,
    /// Largest angle of a rotary axis, or of an arc, rad.
    pub(crate) rotated: f64,
    at: MotionAtShares<'m>,
    bounds: &'m dyn MotionBounds,
    /// Time at feed, min, for the length of the tip path, mm.
    minutes: &'m dyn Fn(f64) -> Option<f64>,
}

/// Certified bounds of a motion between two shares and the axis values there.
#[cfg(feature = "simulate")]
trait MotionBounds {
    /// Deviation from the motion in step with it.
    fn step(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> StepBound;

    /// Smallest and largest axis values; `None`: not found.
    fn ranges(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> Option<AxisRanges>;
}

/// A motion of all axes together.
#[cfg(feature = "simulate")]
struct EvenAxes<'m>(&'m dyn AnyMachine);

#[cfg(feature = "simulate")]
impl MotionBounds for EvenAxes<'_> {
    fn step(&self, _shares: [f64; 2], [from, to]: [&AxisValues; 2]) -> StepBound {
        StepBound::of(self.0, from, to)
    }

    fn ranges(&self, _shares: [f64; 2], [from, to]: [&AxisValues; 2]) -> Option<AxisRanges> {
        Some(AxisRanges::between(from, to))
    }
}

/// A motion to programmed words.
#[cfg(feature = "simulate")]
struct OnLeg<'m>(&'m Leg<'m>, &'m dyn AnyMachine);

#[cfg(feature = "simulate")]
impl MotionBounds for OnLeg<'_> {
    fn step(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> StepBound {
        self.0.step_bound(self.1, shares, ends)
    }

    fn ranges(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> Option<AxisRanges> {
        self.0.axis_ranges(self.1, shares, ends)
    }
}

#[cfg(feature = "simulate")]
impl ExecutedMotion<'_> {
    /// Machine with part and tool.
    pub(crate) fn machine(&self) -> &dyn AnyMachine {
        &*self.placement.machine
    }

    /// Number of the tool; 0 without one.
    pub(crate) fn tool(&self) -> u32 {
        self.placement.tool
    }

    /// Time at feed, min, for the length of the tip path, mm; `None` at rapid, or where it is unknown.
    pub(crate) fn minutes(&self, length_mm: f64) -> Option<f64> {
        (self.minutes)(length_mm)
    }

    /// Position at a share; `near`: a position before it.
    pub(crate) fn at(&self, share: f64, near: &ExecutedPlace) -> ExecutedPlace {
        (self.at)(share, &near.axes)
    }

    /// Certified deviation between two shares from the motion in step with it.
    pub(crate) fn step_bound(&self, shares: [f64; 2], places: [&ExecutedPlace; 2]) -> StepBound {
        self.bounds.step(shares, places.map(|place| &place.axes))
    }

    /// Axis values at a share; `near`: values before it.
    pub(crate) fn axes_at(&self, share: f64, near: &AxisValues) -> AxisValues {
        (self.at)(share, near).axes
    }

    /// Certified smallest and largest axis values between two shares and the values there; `None` where the part must
    /// be divided.
    pub(crate) fn axis_ranges(&self, shares: [f64; 2], ends: [&AxisValues; 2]) -> Option<AxisRanges> {
        self.bounds.ranges(shares, ends)
    }
}

/// Receives motions as they are executed.
#[cfg(feature = "simulate")]
pub(crate) trait Motions {
    /// A motion; returns its end.
    fn motion(&mut self, motion: &ExecutedMotion<'_>) -> ExecutedPlace;

    /// A motion whose start or end is unknown.
    fn unknown(&mut self);
}

/// Collects the points of a program while it is checked.
pub(crate) struct Collector<'a> {
    set_up: &'a SetUp,
    axes: &'static [Axis],
    /// Largest speeds of the axes, mm/min and rad/min.
    speeds: Vec<Option<f64>>,
    tolerance_mm: f64,
    /// Machine coordinates less `machine_zero` of linear axes, mm; values of the others. `None`: unknown.
    coordinates: [Option<f64>; MAX_AXES],
    /// Index of the placement.
    placement: usize,
    /// The last point is where the machine is.
    joined: bool,
    /// Dwells at an unknown position, s: they are times of the next point.
    waited: f64,
    executed: Executed,
    /// Receives the motions in the place of points.
    #[cfg(feature = "simulate")]
    motions: Option<&'a mut dyn Motions>,
}

/// A position on the way of a block.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExecutedPlace {
    pub(crate) axes: AxisValues,
    pub(crate) pose: Pose,
}

/// A place at a share of a motion.
#[derive(Debug, Clone, Copy)]
struct PlaceAtShare {
    /// Share of the motion up to the place, 0 to 1.
    share: f64,
    place: ExecutedPlace,
}

/// What is known of the course of a motion.
struct ExecutedCourse<'m> {
    /// Angle of an arc, rad.
    sweep: f64,
    /// All axes arrive together.
    #[cfg_attr(not(feature = "simulate"), expect(dead_code, reason = "a page shows the motion as if they did"))]
    together: bool,
    #[cfg(feature = "simulate")]
    bounds: &'m dyn MotionBounds,
    at: MotionAtShares<'m>,
}

/// Positions of a motion at shares of it, 0 to 1; the second argument has the axis values of a position before it.
type MotionAtShares<'m> = &'m dyn Fn(f64, &AxisValues) -> ExecutedPlace;

impl Observer for Collector<'_> {
    fn executed(&mut self, executed: &ExecutedBlock<'_>) {
        self.follow_operation(executed);
        if executed.loses_position() {
            self.forget(!0);
            self.joined = false;
        }
        match executed.block.action {
            Action::Nothing | Action::ToolChange | Action::Stop | Action::OptionalStop | Action::End => {}
            Action::Dwell(seconds) => self.wait(executed, seconds),
            Action::Machine | Action::Reference { .. } | Action::EndOfTravel => {
                match executed.machine_values() {
                    Some(values) => {
                        self.follow_placement(executed, false);
                        self.go_to_machine_position(executed, &values);
                    }
                    None => {
                        self.joined = false;
                        self.forget(executed.block.written);
                    }
                }
                if !self.joined {
                    self.executed.undrawn.push(executed.block.line);
                }
            }
            Action::Orient => {
                self.follow_placement(executed, false);
                self.orient(executed);
            }
            Action::Rapid | Action::Feed | Action::Arc(_) | Action::Cycle(_) => {
                self.follow_placement(executed, true);
                self.on_path(executed);
            }
        }
    }
}

impl<'a> Collector<'a> {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: &'a CheckPolicy) -> Self {
        let (axes, held) = (machine.axes(), machine.held());
        Self {
            set_up: &policy.set_up,
            axes,
            speeds: policy.set_up.travel(axes).speeds,
            tolerance_mm: policy.tolerances.path_mm,
            coordinates: std::array::from_fn(|index| match axes.get(index) {
                Some(axis) if !axis.held => start(axis, &policy.set_up),
                _ => Some(held[index]),
            }),
            placement: 0,
            joined: false,
            waited: 0.0,
            executed: Executed::default(),
            #[cfg(feature = "simulate")]
            motions: None,
        }
    }

    /// One that hands over the motions and keeps no point.
    #[cfg(feature = "simulate")]
    pub(crate) fn following(machine: &dyn AnyMachine, policy: &'a CheckPolicy, motions: &'a mut dyn Motions) -> Self {
        Self { motions: Some(motions), ..Self::new(machine, policy) }
    }

    /// A motion of which the start or the end is unknown.
    fn lose(&mut self) {
        self.joined = false;
        #[cfg(feature = "simulate")]
        if let Some(motions) = self.motions.as_deref_mut() {
            motions.unknown();
        }
    }

    pub(crate) fn finish(self) -> Executed {
        self.executed
    }

    fn placed(&self) -> &ExecutedPlacement {
        &self.executed.placements[self.placement]
    }

    /// Machine coordinate of an axis less its value and its `machine_zero`, mm; 0 for rotary and held axes.
    fn offset_mm(&self, index: usize) -> f64 {
        let linear = self.axes.get(index).is_some_and(|axis| axis.kind == AxisKind::Linear && !axis.held);
        if linear { self.placed().offsets_mm[index] } else { 0.0 }
    }

    /// Takes tool and part of a block. Until the tool has changed in the program, a motion to a machine position still
    /// carries the one before. `at_part`: the words of the block count with the tool.
    fn follow_placement(&mut self, executed: &ExecutedBlock<'_>, at_part: bool) {
        let (machine, tool) = (executed.machine(), executed.block.state.tool.unwrap_or(0));
        let set_up = executed.set_up();
        let is_same = |placement: &ExecutedPlacement| {
            let same = |index: usize| placement.machine.joint(index) == machine.joint(index);
            (placement.tool, placement.set_up) == (tool, set_up) && (!at_part || (0..self.axes.len()).all(same))
        };
        let placements = &self.executed.placements;
        if placements.get(self.placement).is_some_and(is_same) {
            return;
        }
        self.placement = placements.iter().position(is_same).unwrap_or(placements.len());
        self.joined = false;
        if self.placement == self.executed.placements.len() {
            let offsets_mm = std::array::from_fn(|index| executed.offset_mm(index));
            let machine = Arc::from(machine.to_boxed());
            self.executed.placements.push(ExecutedPlacement { set_up, tool, machine, offsets_mm });
        }
    }

    /// Axis values of the machine, if all are known.
    fn position(&self) -> Option<AxisValues> {
        let mut values = [0.0; MAX_AXES];
        for (index, value) in values.iter_mut().enumerate() {
            *value = self.coordinates[index]? - self.offset_mm(index);
        }
        Some(values)
    }

    fn arrive(&mut self, values: &AxisValues, known: u16) {
        for (index, value) in values.iter().enumerate().filter(|(index, _)| known & (1 << index) != 0) {
            self.coordinates[index] = Some(value + self.offset_mm(index));
        }
    }

    fn forget(&mut self, axes: u16) {
        let forgotten = self.coordinates.iter_mut().enumerate().filter(|(index, _)| axes & (1 << index) != 0);
        let moves = |index: usize| self.axes.get(index).is_some_and(|axis| !axis.held);
        forgotten.filter(|(index, _)| moves(*index)).for_each(|(_, coordinate)| *coordinate = None);
    }

    /// To words that are machine coordinates.
    fn go_to_machine_position(&mut self, executed: &ExecutedBlock<'_>, values: &[f64; MAX_AXES]) {
        let (from, block) = (self.position(), executed.block);
        for (index, axis) in self.axes.iter().enumerate().filter(|(index, _)| block.written & (1 << index) != 0) {
            let zero_mm = match axis.kind {
                AxisKind::Linear => self.set_up.machine_zero.get(&axis.letter).copied(),
                AxisKind::Rotary => Some(0.0),
            };
            self.coordinates[index] = zero_mm.map(|zero_mm| values[index] - zero_mm);
        }
        self.by_axes(executed, from);
    }

    /// The control rotates the rotary axes into a plane, or back.
    fn orient(&mut self, executed: &ExecutedBlock<'_>) {
        let from = self.position();
        let (values, known) = executed.known_values();
        let rotary = self.rotary();
        self.arrive(&values, known & rotary);
        if known & rotary != rotary {
            self.forget(rotary);
            if let (Some(from), Some(axis)) = (from, executed.plane_axis()) {
                let tip = self.placed().machine.forward_kinematics(&from).tip;
                let chosen = nearest_solution(&*self.placed().machine, &Pose { tip, axis }, &from);
                chosen.into_iter().for_each(|values| self.arrive(&values, rotary));
            }
        }
        self.by_axes(executed, from);
    }

    fn rotary_axes(&self) -> impl Iterator<Item = usize> + use<> {
        let axes = self.axes;
        (0..axes.len()).filter(move |index| axes[*index].kind == AxisKind::Rotary)
    }

    fn rotary(&self) -> u16 {
        self.rotary_axes().fold(0, |bits, index| bits | 1 << index)
    }

    /// A rapid of the axes from a position to where the machine is now.
    fn by_axes(&mut self, executed: &ExecutedBlock<'_>, from: Option<AxisValues>) {
        let (Some(from), Some(to)) = (from, self.position()) else {
            self.lose();
            return;
        };
        let machine = Arc::clone(&self.placed().machine);
        let at = |share: f64, _: &AxisValues| {
            let axes = std::array::from_fn(|index| from[index] + (to[index] - from[index]) * share);
            ExecutedPlace { axes, pose: machine.forward_kinematics(&axes) }
        };
        let first = ExecutedPlace { axes: from, pose: machine.forward_kinematics(&from) };
        let moved = (0..self.axes.len()).filter(|index| (to[*index] - from[*index]).abs() > 0.0).count();
        let course = ExecutedCourse {
            sweep: 0.0,
            together: moved < 2,
            #[cfg(feature = "simulate")]
            bounds: &EvenAxes(&*machine),
            at: &at,
        };
        self.trace(executed, PointKind::Rapid, first, &course, |_| None);
    }

    /// To words that are positions, or coordinates of the tip.
    fn on_path(&mut self, executed: &ExecutedBlock<'_>) {
        let position = self.position();
        let legs = position.map_or_else(|| executed.legs(), |position| executed.legs_from(&position));
        if legs.is_empty() {
            let (values, known) = executed.known_values();
            if executed.block.state.has_frame() {
                // The linear axes follow from all words together.
                self.forget(!self.rotary());
            }
            self.arrive(&values, known);
            self.lose();
            if let Some(axes) = self.position() {
                let place = ExecutedPlace { axes, pose: self.placed().machine.forward_kinematics(&axes) };
                self.begin_at(executed, &place);
            }
            return;
        }
        let machine = Arc::clone(&self.placed().machine);
        for leg in &legs {
            // Ends have the pose of the words; in between, and where the control chooses no angle, that of the axes.
            let at = |share: f64, near: &AxisValues| match leg.axis_values(share) {
                Some(axes) if share < 1.0 => ExecutedPlace { axes, pose: machine.forward_kinematics(&axes) },
                axes => {
                    let pose = leg.pose(share);
                    let axes = axes.or_else(|| nearest_solution(&*machine, &pose, near));
                    ExecutedPlace { axes: axes.unwrap_or(*near), pose }
                }
            };
            let start = at(0.0, &position.unwrap_or_else(|| machine.held()));
            let kind = if leg.rapid { PointKind::Rapid } else { PointKind::Feed };
            self.executed.rapids_apart |= leg.rapid && !leg.together;
            let course = ExecutedCourse {
                sweep: leg.sweep().abs(),
                together: leg.together,
                #[cfg(feature = "simulate")]
                bounds: &OnLeg(leg, &*machine),
                at: &at,
            };
            self.trace(executed, kind, start, &course, |length_mm| leg.minutes(length_mm));
        }
    }

    /// Begins a path, unless the last point is where the machine is.
    fn begin_at(&mut self, executed: &ExecutedBlock<'_>, place: &ExecutedPlace) {
        let continues = |last: &ExecutedPoint| (last.pose.tip - place.pose.tip).norm() < SAME_POINT_MM;
        if !self.joined || !self.executed.points.last().is_some_and(continues) {
            let waited = std::mem::take(&mut self.waited);
            self.push(executed, PointKind::Start, place, 0.0, Some(waited));
        }
        self.joined = true;
    }

    /// Adds the points of a motion. `minutes`: time at feed, from the length of the tip path.
    fn trace(
        &mut self,
        executed: &ExecutedBlock<'_>,
        kind: PointKind,
        start: ExecutedPlace,
        course: &ExecutedCourse<'_>,
        minutes: impl Fn(f64) -> Option<f64>,
    ) {
        let ExecutedCourse { sweep, at, .. } = *course;
        let whole = at(1.0, &start.axes);
        let turned = |index: usize| (whole.axes[index] - start.axes[index]).abs();
        let rotated = self.rotary_axes().map(turned).fold(sweep, f64::max);
        #[cfg(feature = "simulate")]
        if let Some(motions) = self.motions.as_deref_mut() {
            let placement = &self.executed.placements[self.placement];
            let (rapid, together, bounds) = (kind == PointKind::Rapid, course.together, course.bounds);
            let minutes = &minutes;
            let motion = ExecutedMotion { executed, placement, rapid, together, start, rotated, at, bounds, minutes };
            let end = motions.motion(&motion);
            self.arrive(&end.axes, !0);
            return;
        }
        self.begin_at(executed, &start);
        let tolerance_mm = if kind == PointKind::Feed { self.tolerance_mm } else { self.tolerance_mm.max(RAPID_MM) };
        let (mut places, mut before) = (Vec::new(), PlaceAtShare { share: 0.0, place: start });
        // The middle of whole revolutions is at their ends.
        let pieces = (rotated / FRAC_PI_3).ceil().max(1.0) as u32;
        for piece in 1..=pieces {
            let share = f64::from(piece) / f64::from(pieces);
            let place = if pieces == 1 { whole } else { at(share, &before.place.axes) };
            let end = PlaceAtShare { share, place };
            self.divide(at, [before, end], tolerance_mm, MOST_HALVINGS, &mut places);
            before = end;
        }
        let moves = |(from, to): (&f64, &f64)| (from - to).abs() > 0.0;
        if kind == PointKind::Rapid && !start.axes.iter().zip(&before.place.axes).any(moves) {
            return;
        }
        let tips = std::iter::once(&start).chain(places.iter().map(|end| &end.place)).map(|place| place.pose.tip);
        let lengths_mm = tips.clone().zip(tips.skip(1)).map(|(from, to)| (to - from).norm());
        let length_mm: f64 = lengths_mm.sum();
        let minutes = match kind {
            PointKind::Feed => minutes(length_mm),
            PointKind::Start | PointKind::Rapid | PointKind::Dwell => {
                self.rapid_minutes(&start.axes, &before.place.axes)
            }
        };
        let feed = match (kind, minutes) {
            (PointKind::Feed, Some(minutes)) if minutes > 0.0 => length_mm / minutes,
            _ => 0.0,
        };
        let mut share_before = 0.0;
        for PlaceAtShare { share, place } in &places {
            let seconds = minutes.map(|minutes| 60.0 * minutes * (share - share_before));
            self.push(executed, kind, place, feed, seconds);
            share_before = *share;
        }
        self.arrive(&before.place.axes, !0);
    }

    /// Divides a motion until it is straight within the tolerance, and adds the ends of the pieces.
    fn divide(
        &self,
        at: MotionAtShares<'_>,
        [from, to]: [PlaceAtShare; 2],
        tolerance_mm: f64,
        halvings: u32,
        places: &mut Vec<PlaceAtShare>,
    ) {
        let share = f64::midpoint(from.share, to.share);
        let middle = PlaceAtShare { share, place: at(share, &from.place.axes) };
        let axes: AxisValues = std::array::from_fn(|index| f64::midpoint(from.place.axes[index], to.place.axes[index]));
        let chord = nalgebra::center(&from.place.pose.tip, &to.place.pose.tip);
        let drawn = self.placed().machine.forward_kinematics(&axes).tip;
        let bends = [chord, drawn].iter().any(|tip| (tip - middle.place.pose.tip).norm() > tolerance_mm);
        if bends && halvings > 0 {
            self.divide(at, [from, middle], tolerance_mm, halvings - 1, places);
            self.divide(at, [middle, to], tolerance_mm, halvings - 1, places);
        } else {
            places.push(to);
        }
    }

    /// Time of a rapid, in which the slowest axis decides.
    fn rapid_minutes(&self, from: &AxisValues, to: &AxisValues) -> Option<f64> {
        let moved = (0..self.axes.len()).map(|index| (index, (to[index] - from[index]).abs()));
        let mut moved = moved.filter(|(_, change)| *change > 0.0);
        moved.try_fold(0.0_f64, |slowest, (index, change)| Some(slowest.max(change / self.speeds[index]?)))
    }

    fn wait(&mut self, executed: &ExecutedBlock<'_>, seconds: f64) {
        let Some(last) = self.executed.points.last().filter(|_| self.joined) else {
            self.waited += seconds;
            return;
        };
        let place = ExecutedPlace { axes: last.axes, pose: last.pose };
        self.push(executed, PointKind::Dwell, &place, 0.0, Some(seconds));
    }

    /// Adds a point. `feed`: mm/min, 0 where there is none; `seconds`: time up to it, `None` if unknown.
    fn push(
        &mut self,
        executed: &ExecutedBlock<'_>,
        kind: PointKind,
        place: &ExecutedPlace,
        feed: f64,
        seconds: Option<f64>,
    ) {
        #[cfg(feature = "simulate")]
        if self.motions.is_some() {
            return;
        }
        let operation = self.operation(executed, kind);
        self.executed.points.push(ExecutedPoint {
            axes: place.axes,
            pose: place.pose,
            line: executed.block.line,
            cl_line: executed.record.line,
            kind,
            operation,
            placement: self.placement,
            feed,
            seconds,
            deviation_mm: executed.deviation_mm.filter(|_| kind != PointKind::Start),
        });
    }

    /// Begins an operation with its first block.
    fn follow_operation(&mut self, executed: &ExecutedBlock<'_>) {
        let (number, cl_line, first_point) = (executed.operation, executed.record.line, self.executed.points.len());
        let operations = &mut self.executed.operations;
        if number > 0 && operations.last().is_none_or(|last| last.number != number) {
            let (set_up, tool) = (executed.set_up(), 0);
            operations.push(ExecutedOperation { number, cl_line, tool, mode: "", set_up, first_point, cuts: false });
        }
    }

    /// Index of the operation of a point. Its tool and its mode are those of its first cut.
    fn operation(&mut self, executed: &ExecutedBlock<'_>, kind: PointKind) -> usize {
        let state = &executed.block.state;
        let Some(operation) = self.executed.operations.last_mut() else { return 0 };
        if !operation.cuts {
            operation.cuts = kind == PointKind::Feed;
            (operation.tool, operation.mode, operation.set_up) =
                (state.tool.unwrap_or(0), mode(state), executed.set_up());
        }
        self.executed.operations.len() - 1
    }
}

/// Machine coordinate of an axis less `machine_zero` when the program begins; of a rotary axis its value.
fn start(axis: &Axis, set_up: &SetUp) -> Option<f64> {
    let position = set_up.start_position.get(&axis.letter)?;
    match axis.kind {
        AxisKind::Linear => Some(position - set_up.machine_zero.get(&axis.letter)?),
        AxisKind::Rotary => Some(*position),
    }
}

/// Mode of the words in a state, as the configuration names it.
fn mode(state: &State) -> &'static str {
    match (&state.tip_control, &state.tilt) {
        (TipControl::On { .. }, _) => "tcp",
        (TipControl::Off, Some(_)) => "plane",
        (TipControl::Off, None) => "axes",
    }
}

/// The solution for a pose that rotates the rotary axes least from a position; whole revolutions are added.
fn nearest_solution(machine: &dyn AnyMachine, pose: &Pose, near: &AxisValues) -> Option<AxisValues> {
    let rotary: Vec<usize> =
        (0..machine.axes().len()).filter(|index| machine.axes()[*index].kind == AxisKind::Rotary).collect();
    let unwound = |mut values: AxisValues| {
        for &index in rotary.iter().filter(|index| !machine.axes()[**index].held) {
            values[index] += ((near[index] - values[index]) / TAU).round() * TAU;
        }
        values
    };
    let rotation = |values: &AxisValues| rotary.iter().map(|&index| (values[index] - near[index]).abs()).sum::<f64>();
    let solutions = machine.inverse_kinematics(pose, near);
    solutions.iter().map(|solution| unwound(solution.axes)).min_by(|a, b| rotation(a).total_cmp(&rotation(b)))
}
