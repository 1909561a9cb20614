//! Words of a program into tip and tool axis on the workpiece.
//!
//! A word that is an axis position is the axis value plus the offsets of set-up and tool, a rotary word the axis value
//! minus its offset; tip and axis follow through the chain. Under tip control the linear words are the tip itself, in a
//! frame that is fixed to the table or to the machine. In a tilted plane they are the tip in that plane.

use nalgebra::{Matrix2, Matrix3, Matrix3x2, Vector3};

use super::super::geometry::{Chain, Swing, ToolPose};
use super::super::policy::{CheckPolicy, TipFrame};
use super::super::read::{MAX_AXES, State, TipControl, set_bits};
use super::apart;
use crate::check::tolerances::{EQUAL_TOOL_SHARE, EXCURSION};
use crate::kinematics::{AnyMachine, AxisKind};
use crate::set_up::{LengthMode, ProgramZero};

/// Newton steps of rotary axes to a near tool axis, and the distance at which they end, rad: a rotary axis whose rate
/// is the tilt, as near the pole, is known to that over the tilt.
const NEWTON_STEPS: u32 = 30;
const ROTATED_TO: f64 = 1e-14;

/// A step below which no nearer tool axis is reached, rad.
const LEAST_STEP: f64 = 1e-9;

/// Distance from a tool axis that is not reached, rad.
const UNREACHED: f64 = 0.1;

/// Largest damping. It falls with the square of the distance that is left: so an axis that hardly rotates the tool is
/// left alone while the tool has far to go, and near the pole the last steps converge all the same.
const DAMPED: f64 = 1e-8;

/// Angles at which the axes are looked at while a rotary axis rotates near the pole.
const POLE_PARTS: u32 = 16;

/// Words and axis values of one machine, set-up and tool, by position in the chain.
#[derive(Debug, Clone)]
pub(crate) struct MachineWords {
    chain: Chain,
    axes: SolvedAxes,
    /// Linear words less axis values without tool, mm.
    zero_mm: [f64; MAX_AXES],
    /// Share of the gauge length in a linear axis.
    gauge_share: [f64; MAX_AXES],
    gauge_line: bool,
    /// Rotary axis values less words, rad.
    offset_rad: [f64; MAX_AXES],
    /// Values of held axes, mm and rad.
    held: [f64; MAX_AXES],
    /// Axis values are words times the first plus the second: 1 for solved axes, 0 for the others.
    counts: [f64; MAX_AXES],
    added: [f64; MAX_AXES],
    /// Tool axis with all axes at zero.
    tool_axis: Vector3<f64>,
    gauge_length_mm: f64,
    tip_frame: TipFrame,
    /// Part zero from the reference point of the table, mm: now, and in the first set-up.
    part_origin: Vector3<f64>,
    first_origin: Vector3<f64>,
    /// Axis values of the part zero, from that of the first set-up.
    moved_mm: [f64; MAX_AXES],
    /// Linear words are measured from the reference point of the table.
    from_table: bool,
}

/// The axes that the program moves; positions in the chain, and bits of them.
#[derive(Debug, Clone)]
pub(crate) struct SolvedAxes {
    linear: Vec<usize>,
    linear_bits: u16,
    rotary_bits: u16,
    /// The linear axis that retracts.
    retract: usize,
    /// X, Y and Z.
    xyz: [Option<usize>; 3],
}

impl SolvedAxes {
    fn of(machine: &dyn AnyMachine) -> Self {
        let solved = |kind: AxisKind| {
            let axes = machine.axes().iter().enumerate().filter(move |(_, axis)| axis.kind == kind && !axis.held);
            axes.map(|(index, _)| index).collect::<Vec<usize>>()
        };
        let linear = solved(AxisKind::Linear);
        Self {
            retract: retract_axis(machine, &linear, &machine.tool_axis().into_inner()),
            linear_bits: bits(&linear),
            rotary_bits: bits(&solved(AxisKind::Rotary)),
            xyz: ['X', 'Y', 'Z'].map(|letter| machine.axes().iter().position(|axis| axis.letter == letter)),
            linear,
        }
    }
}

impl MachineWords {
    pub(crate) fn new(machine: &dyn AnyMachine, policy: &CheckPolicy) -> Self {
        let set_up = &policy.set_up;
        let mut words = Self {
            axes: SolvedAxes::of(machine),
            zero_mm: [0.0; MAX_AXES],
            gauge_share: [0.0; MAX_AXES],
            gauge_line: set_up.length_mode == LengthMode::Gauge,
            offset_rad: [0.0; MAX_AXES],
            held: [0.0; MAX_AXES],
            counts: [0.0; MAX_AXES],
            added: [0.0; MAX_AXES],
            gauge_length_mm: 0.0,
            tip_frame: policy.words.tip_frame,
            part_origin: set_up.part_origin.into(),
            first_origin: set_up.part_origin.into(),
            moved_mm: [0.0; MAX_AXES],
            from_table: set_up.program_zero == ProgramZero::Table,
            chain: Chain::of(machine),
            tool_axis: machine.tool_axis().into_inner(),
        };
        let origin = if set_up.program_zero == ProgramZero::Table { set_up.part_origin } else { [0.0; 3] };
        words.zero_mm = words.along(&origin.into());
        words.gauge_share = words.along(&words.tool_axis);
        let held = machine.held();
        for (index, axis) in machine.axes().iter().enumerate() {
            words.offset_rad[index] = set_up.rotary_offset.get(&axis.letter).copied().unwrap_or(0.0);
            words.held[index] = held[index];
        }
        words.take_offsets();
        words
    }

    /// Bits of the solved linear axes.
    pub(crate) fn linear_bits(&self) -> u16 {
        self.axes.linear_bits
    }

    /// Bits of the solved rotary axes.
    pub(crate) fn rotary_bits(&self) -> u16 {
        self.axes.rotary_bits
    }

    /// Position of the linear axis that retracts.
    pub(crate) fn retract(&self) -> usize {
        self.axes.retract
    }

    /// Sense of the retract axis that leads away from the part: 1 or -1.
    pub(crate) fn outwards(&self) -> f64 {
        self.gauge_share[self.axes.retract].signum()
    }

    /// Positions of the solved rotary axes.
    pub(crate) fn rotary(&self) -> impl Iterator<Item = usize> + use<> {
        set_bits(self.axes.rotary_bits)
    }

    /// Positions of X Y Z, in which arcs lie.
    pub(crate) fn xyz(&self) -> [Option<usize>; 3] {
        self.axes.xyz
    }

    /// Words of the linear axes whose motion together is a vector, at the zero position.
    fn along(&self, vector: &Vector3<f64>) -> [f64; MAX_AXES] {
        let mut words = [0.0; MAX_AXES];
        if let [x, y, z] = self.axes.linear[..] {
            for (index, value) in [x, y, z].into_iter().zip(self.chain.along([x, y, z], vector)) {
                words[index] = value;
            }
        }
        words
    }

    /// Puts another tool into the spindle. Returns whether its length differs.
    pub(crate) fn set_tool(&mut self, machine: &mut dyn AnyMachine, gauge_length_mm: f64) -> bool {
        let differs = (self.gauge_length_mm - gauge_length_mm).abs() > 0.0;
        if differs {
            machine.set_up(self.part_origin, gauge_length_mm);
            self.chain = Chain::of(machine);
            self.gauge_length_mm = gauge_length_mm;
            self.take_offsets();
        }
        differs
    }

    /// Clamps the part with its zero at another place on the table.
    pub(crate) fn set_part(&mut self, machine: &mut dyn AnyMachine, origin: Vector3<f64>) {
        if origin == self.part_origin {
            return;
        }
        machine.set_up(origin, self.gauge_length_mm);
        self.chain = Chain::of(machine);
        self.part_origin = origin;
        if self.from_table {
            self.zero_mm = self.along(&origin);
        }
        self.moved_mm = self.along(&(origin - self.first_origin));
        self.take_offsets();
    }

    /// Position of the part zero from the reference point of the table, mm.
    pub(crate) fn part_origin(&self) -> Vector3<f64> {
        self.part_origin
    }

    /// Axis values for words, mm and rad.
    pub(crate) fn values(&self, words: &[f64; MAX_AXES]) -> [f64; MAX_AXES] {
        std::array::from_fn(|index| self.value(index, words[index]))
    }

    /// Change of the axis values from words to others, mm and rad.
    pub(crate) fn change(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> [f64; MAX_AXES] {
        std::array::from_fn(|index| self.counts[index] * (to[index] - from[index]))
    }

    /// Takes tool and part into the axis values of words.
    fn take_offsets(&mut self) {
        let length = if self.gauge_line { self.gauge_length_mm } else { 0.0 };
        for index in 0..MAX_AXES {
            let bit = 1 << index;
            (self.counts[index], self.added[index]) = if self.axes.linear_bits & bit != 0 {
                (1.0, -self.zero_mm[index] - length * self.gauge_share[index])
            } else if self.axes.rotary_bits & bit != 0 {
                (1.0, self.offset_rad[index])
            } else {
                (0.0, self.held[index])
            };
        }
    }

    /// Machine coordinate of a linear axis less its value and `machine_zero`, mm: the share of the gauge length, and
    /// the place of the part zero in a further set-up.
    pub(crate) fn gauge_of(&self, index: usize) -> f64 {
        self.gauge_length_mm * self.gauge_share[index] + self.moved_mm[index]
    }

    /// Whether the tool in the spindle has a known length.
    pub(crate) fn is_length_known(&self) -> bool {
        self.gauge_length_mm > 0.0
    }

    /// Tip and tool axis on the workpiece.
    pub(crate) fn place(&self, words: &[f64; MAX_AXES], state: &State) -> ToolPose {
        if state.has_frame() { self.place_in_frame(words, state) } else { self.chain.place(&self.values(words)) }
    }

    /// Tip of words, and its displacement from each of three words to others; the rotary axes are at the same values in
    /// all of them.
    pub(crate) fn tip_and_shifts(
        &self,
        words: &[f64; MAX_AXES],
        steps: [[&[f64; MAX_AXES]; 2]; 3],
        state: &State,
    ) -> (Vector3<f64>, [Vector3<f64>; 3]) {
        if state.has_frame() {
            let tip = |words: &[f64; MAX_AXES]| self.place(words, state).tip;
            return (tip(words), steps.map(|[from, to]| tip(to) - tip(from)));
        }
        self.chain.tip_and_shifts(&self.values(words), &steps.map(|[from, to]| self.change(from, to)))
    }

    /// Pose of words where the linear ones count in a frame.
    #[inline(never)]
    fn place_in_frame(&self, words: &[f64; MAX_AXES], state: &State) -> ToolPose {
        match (&state.tip_control, &state.tilt) {
            (TipControl::Off, None) => {
                // Without a place for the zero nothing is at its place.
                let values = self.with_moved_zero(words).unwrap_or([f64::NAN; MAX_AXES]);
                self.chain.place(&values)
            }
            (TipControl::On { start }, _) => {
                let values = self.values(words);
                let tip = self.program_point(words);
                let tip = match self.tip_frame {
                    TipFrame::TableAtZero => tip,
                    TipFrame::TableAtStart => self.chain.onto_workpiece(tip, &self.values(start)),
                    TipFrame::Machine => self.chain.onto_workpiece(tip, &values),
                };
                let axis = match &state.vector {
                    Some(vector) => self.direction(vector, &values, start),
                    None => self.chain.place(&values).axis,
                };
                ToolPose { tip, axis }
            }
            (TipControl::Off, Some(tilt)) => {
                let words = self.out_of_plane(words, &tilt.rotation, &tilt.origin);
                let up = self.out_of_plane(&self.along(&self.tool_axis), &tilt.rotation, &Vector3::zeros());
                ToolPose { tip: self.program_point(&words), axis: self.chain.at_zero(&up) }
            }
        }
    }

    /// Tool axis of programmed components, on the workpiece.
    fn direction(&self, vector: &Vector3<f64>, values: &[f64; MAX_AXES], start: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut words = [0.0; MAX_AXES];
        if let [Some(x), Some(y), Some(z)] = self.axes.xyz {
            (words[x], words[y], words[z]) = (vector.x, vector.y, vector.z);
        }
        let named = self.chain.at_zero(&words);
        let on_workpiece = |values: &[f64; MAX_AXES]| {
            self.chain.onto_workpiece(named, values) - self.chain.onto_workpiece(Vector3::zeros(), values)
        };
        match self.tip_frame {
            TipFrame::TableAtZero => named,
            TipFrame::TableAtStart => on_workpiece(&self.values(start)),
            TipFrame::Machine => on_workpiece(values),
        }
    }

    /// Axis values after a block, whatever the meaning of its words; `None` where the control chooses the rotary axes.
    pub(crate) fn axes(&self, words: &[f64; MAX_AXES], state: &State) -> Option<[f64; MAX_AXES]> {
        if state.vector.is_some() { None } else { self.axes_with_rotary(words, state) }
    }

    /// Whether the linear axes lead the tip in perpendicular directions with the rotary axes at these axis values.
    pub(crate) fn is_perpendicular(&self, values: &[f64; MAX_AXES]) -> bool {
        // No control applies F along U, V, W in a block that moves one of X, Y, Z.
        self.xyz().iter().all(Option::is_some) && self.chain.is_perpendicular(values, set_bits(self.linear_bits()))
    }

    /// Axis values after a block, with the rotary words that the control has chosen.
    pub(crate) fn axes_with_rotary(&self, words: &[f64; MAX_AXES], state: &State) -> Option<[f64; MAX_AXES]> {
        let values = self.values(words);
        match (&state.tip_control, &state.tilt) {
            (TipControl::Off, None) if state.dynamic_offset => self.with_moved_zero(words),
            (TipControl::Off, None) => Some(values),
            _ => self.axes_at(self.place(words, state).tip, values),
        }
    }

    /// Words that have these axis values in a state; `None` where the linear axes are not solvable.
    pub(crate) fn words_at(&self, values: &[f64; MAX_AXES], state: &State) -> Option<[f64; MAX_AXES]> {
        let mut words = *values;
        for index in self.rotary() {
            words[index] = values[index] - self.offset_rad[index];
        }
        let linear = self.linear_three()?;
        linear.iter().for_each(|&index| words[index] = 0.0);
        let at = |words: &[f64; MAX_AXES]| {
            let values = self.axes_with_rotary(words, state)?;
            Some(Vector3::from(linear.map(|index| values[index])))
        };
        let zero = at(&words)?;
        let column = |index: usize| {
            let mut moved = words;
            moved[index] = 1.0;
            Some(at(&moved)? - zero)
        };
        let columns = [column(linear[0])?, column(linear[1])?, column(linear[2])?];
        let off = Vector3::from(linear.map(|index| values[index])) - zero;
        let solved = Matrix3::from_columns(&columns).try_inverse()? * off;
        linear.iter().zip(solved.iter()).for_each(|(&index, value)| words[index] = *value);
        Some(words)
    }

    /// Axis values of words that count from a zero that has moved with the table.
    fn with_moved_zero(&self, words: &[f64; MAX_AXES]) -> Option<[f64; MAX_AXES]> {
        let mut values = self.axes_at(self.program_point(&[0.0; MAX_AXES]), self.values(words))?;
        for &index in &self.axes.linear {
            values[index] += words[index];
        }
        Some(values)
    }

    /// Axis values that put the tip at a point of the workpiece, with the rotary axes of others.
    fn axes_at(&self, tip: Vector3<f64>, mut values: [f64; MAX_AXES]) -> Option<[f64; MAX_AXES]> {
        let [x, y, z] = self.linear_three()?;
        for index in [x, y, z] {
            values[index] = 0.0;
        }
        let from = self.chain.place(&values).tip;
        let column = |index: usize| {
            let mut moved = values;
            moved[index] = 1.0;
            self.chain.place(&moved).tip - from
        };
        let solved = Matrix3::from_columns(&[column(x), column(y), column(z)]).try_inverse()? * (tip - from);
        (values[x], values[y], values[z]) = (solved.x, solved.y, solved.z);
        Some(values)
    }

    /// How far the axes may move from one pose to another, for each position that was found; the poses are nearer to
    /// each other than to a pole.
    pub(crate) fn changes(&self, [from, to]: [&ToolPose; 2]) -> Vec<[f64; MAX_AXES]> {
        let change = |start: [f64; MAX_AXES]| {
            let end = self.rotated_to(&start, &to.axis, 0.0)?;
            let [start, end] =
                [(start, from), (end, to)].map(|(words, pose)| self.axes_at(pose.tip, self.values(&words)));
            let (start, end) = (start?, end?);
            Some(std::array::from_fn(|index| EXCURSION * (end[index] - start[index])))
        };
        self.positions(&from.axis).filter_map(change).collect()
    }

    /// Largest motion of the axes near a pole, where the first rotary axis may rotate by up to `largest_rad`, and the
    /// other one may go through the pole.
    pub(crate) fn changes_near_pole(&self, [from, to]: [&ToolPose; 2], largest_rad: f64) -> Vec<[f64; MAX_AXES]> {
        let Some(first) = self.rotary().next() else { return Vec::new() };
        let ends: Vec<_> = self.positions(&to.axis).collect();
        let starts = self.positions(&from.axis);
        let pairs = starts.flat_map(|start| ends.iter().map(move |end| (start, *end)));
        let rotated = pairs.flat_map(|(start, end)| {
            (0..=POLE_PARTS).flat_map(move |part| {
                let by_rad = largest_rad * (2.0 * f64::from(part) / f64::from(POLE_PARTS) - 1.0);
                let (mut to, mut from) = (end, start);
                (to[first], from[first]) = (start[first] + by_rad, end[first] - by_rad);
                // At the pole itself the control chooses the start, or the end.
                [(start, to), (from, end)]
            })
        });
        let change = |(start, end): ([f64; MAX_AXES], [f64; MAX_AXES])| {
            let [before, after] =
                [(start, from), (end, to)].map(|(words, pose)| self.axes_at(pose.tip, self.values(&words)));
            let (before, after) = (before?, after?);
            let factor = |index: usize| if index == first { 1.0 } else { EXCURSION };
            Some(std::array::from_fn(|index| factor(index) * (after[index] - before[index])))
        };
        rotated.filter_map(change).collect()
    }

    /// Rotary axes that rotate by more than an angle from one tool axis to another, in each position that was found:
    /// bits.
    pub(crate) fn rotated_for(&self, [from, to]: [&Vector3<f64>; 2], largest_rad: f64) -> u16 {
        let rotated = |start: [f64; MAX_AXES]| {
            let end = self.rotated_to(&start, to, 0.0)?;
            // The way found may have whole revolutions too many.
            let rotates = |index: &usize| apart(end[*index], start[*index]) > largest_rad;
            Some(self.rotary().filter(rotates).fold(0, |bits, index| bits | 1 << index))
        };
        self.positions(from).filter_map(rotated).reduce(|all, bits| all & bits).unwrap_or(0)
    }

    /// Words whose rotary axes give the tool this axis, found from an angle in each quadrant of the two: each position
    /// is found from one of them, some more than once.
    fn positions(&self, axis: &Vector3<f64>) -> impl Iterator<Item = [f64; MAX_AXES]> {
        let found = |seed: [f64; 2]| {
            let mut words = [0.0; MAX_AXES];
            self.rotary().zip(seed).for_each(|(index, value)| words[index] = value);
            self.rotated_to(&words, axis, 0.0)
        };
        let seeds = [0.6, -0.9, 2.2, -2.5].into_iter().flat_map(|one| [0.6, -0.6, 2.2, -2.2].map(|other| [one, other]));
        seeds.filter_map(found)
    }

    fn linear_three(&self) -> Option<[usize; 3]> {
        self.axes.linear[..].try_into().ok()
    }

    /// Axis values of the linear axes other than the retract axis after a block; the others are 0.
    pub(crate) fn across_at(
        &self,
        words: &[f64; MAX_AXES],
        rotary: &[f64; MAX_AXES],
        state: &State,
    ) -> Option<[f64; MAX_AXES]> {
        let values = self.axes_with_rotary(&self.with_rotary(*words, rotary), state)?;
        let counts = |index: usize| index != self.axes.retract && self.axes.linear_bits & (1 << index) != 0;
        Some(std::array::from_fn(|index| if counts(index) { values[index] } else { 0.0 }))
    }

    /// Axis values of the linear axes other than the retract axis after a block, if they do not depend on the word of
    /// that axis; the others are 0. `rotary`: words of the rotary axes.
    pub(crate) fn across(
        &self,
        words: &[f64; MAX_AXES],
        rotary: &[f64; MAX_AXES],
        state: &State,
        allowed_rad: f64,
    ) -> Option<[f64; MAX_AXES]> {
        let at = |height: f64| {
            let mut words = *words;
            words[self.axes.retract] = height;
            self.across_at(&words, rotary, state)
        };
        let (low, high) = (at(0.0)?, at(1.0)?);
        let steady = low.iter().zip(&high).all(|(low, high)| (low - high).abs() <= allowed_rad);
        steady.then_some(low)
    }

    /// Words with the rotary ones of others.
    pub(crate) fn with_rotary(&self, words: [f64; MAX_AXES], rotary: &[f64; MAX_AXES]) -> [f64; MAX_AXES] {
        std::array::from_fn(
            |index| if self.axes.rotary_bits & (1 << index) == 0 { words[index] } else { rotary[index] },
        )
    }

    /// Largest rotation of a rotary axis between words, rad.
    pub(crate) fn rotary_travel(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> f64 {
        self.rotary().map(|index| (to[index] - from[index]).abs()).fold(0.0, f64::max)
    }

    /// The chain with the part and the tool at hand.
    pub(crate) fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Value of one axis for its word, mm or rad.
    pub(crate) fn value(&self, index: usize, word: f64) -> f64 {
        self.counts[index] * word + self.added[index]
    }

    /// Bounds of a straight motion of words that are axis positions.
    #[inline(always)]
    pub(crate) fn swing(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> Swing {
        self.chain.swing(&self.values(to), &self.change(from, to))
    }

    /// Speed of the tip at the end of a straight motion of words that are axis positions, mm in the whole of it.
    pub(crate) fn last_speed(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> Vector3<f64> {
        self.chain.speed(&self.values(to), &self.change(from, to))
    }

    /// Tool axis on the workpiece of known rotary words.
    pub(crate) fn tool_axis_at(&self, words: &[f64; MAX_AXES]) -> Vector3<f64> {
        self.chain.place(&self.values(words)).axis
    }

    /// Words nearest to `words` whose rotary axes give the tool this axis on the workpiece.
    ///
    /// Newton's method with the smallest step (normal equations, damped by at most [`DAMPED`]): at the pole, where a
    /// rotary axis does not rotate the tool, that axis is left alone. A step below `last_step_rad` is the last: the
    /// error after it is of the order of its square. `None` if it does not converge.
    pub(crate) fn rotated_to(
        &self,
        words: &[f64; MAX_AXES],
        axis: &Vector3<f64>,
        last_step_rad: f64,
    ) -> Option<[f64; MAX_AXES]> {
        let mut words = *words;
        for _ in 0..NEWTON_STEPS {
            let (current, rates) = self.chain.axis_rates(&self.values(&words));
            let off = axis - current;
            if off.norm() < ROTATED_TO {
                return Some(words);
            }
            let mut rotary = self.rotary();
            let (first, second) = (rotary.next()?, rotary.next());
            let columns = [rates[first], second.map_or(Vector3::zeros(), |second| rates[second])];
            let jacobian = Matrix3x2::from_columns(&columns);
            let damping = DAMPED.min(off.norm_squared());
            let normal = jacobian.tr_mul(&jacobian) + Matrix2::identity() * damping;
            let step = normal.try_inverse()? * jacobian.tr_mul(&off);
            words[first] += step.x;
            if let Some(second) = second {
                words[second] += step.y;
            }
            if step.norm() < LEAST_STEP {
                // One rotary axis may not reach the axis: this is the nearest.
                return (off.norm() < UNREACHED).then_some(words);
            }
            if step.norm() < last_step_rad {
                return Some(words);
            }
        }
        None
    }

    /// Words in a tilted plane as words outside it.
    fn out_of_plane(&self, words: &[f64; MAX_AXES], rotation: &Matrix3<f64>, origin: &Vector3<f64>) -> [f64; MAX_AXES] {
        let mut outside = *words;
        if let [Some(x), Some(y), Some(z)] = self.axes.xyz {
            let point = origin + rotation * Vector3::new(words[x], words[y], words[z]);
            (outside[x], outside[y], outside[z]) = (point.x, point.y, point.z);
        }
        outside
    }

    /// Point of linear words, workpiece frame, mm.
    fn program_point(&self, words: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut values = [0.0; MAX_AXES];
        for &index in &self.axes.linear {
            values[index] = words[index] - self.zero_mm[index];
        }
        self.chain.at_zero(&values)
    }
}

fn bits(axes: &[usize]) -> u16 {
    axes.iter().fold(0, |bits, index| bits | 1 << index)
}

/// The linear axis most along the tool; of two alike the one nearer the tool.
fn retract_axis(machine: &dyn AnyMachine, linear: &[usize], tool: &Vector3<f64>) -> usize {
    let share = |index: &usize| (machine.joint(*index).direction.dot(tool).abs() / EQUAL_TOOL_SHARE).round();
    linear.iter().copied().max_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0)
}
