//! Words of a program into tip and tool axis on the workpiece: what the set-up and the mode did to them is undone.
//!
//! In `axes` mode a linear word is the axis value plus what `program_zero` and `length_mode` add, a rotary word the axis
//! value minus its offset; tip and axis follow through the chain. Under tip control the linear words are the tip itself, in
//! a frame that the control keeps with the table, or not. In a tilted plane they are the tip in that plane.

use nalgebra::{Matrix2, Matrix3, Matrix3x2, Vector3};

use super::chain::{Chain, Placed};
use super::path::angle_between;
use super::read::{MAX_AXES, State, TipControl};
use crate::config::Config;
use crate::kinematics::{AnyMachine, AxisKind};
use crate::motion::TcpFrame;
use crate::set_up::{LengthMode, ProgramZero};

/// Steps in which rotary axes come to a tool axis that is near, and how near they come, rad.
const NEWTON: u32 = 30;
const TURNED_TO: f64 = 1e-9;

/// What a rotary axis that turns the tool by less than a thousandth of its own turn is left alone by.
const DAMPED: f64 = 1e-8;

/// What stands between words and axis values, by position in the chain.
#[derive(Debug, Clone)]
pub(super) struct Words {
    pub(super) chain: Chain,
    /// Solved linear axes.
    pub(super) linear: Vec<usize>,
    pub(super) linear_mask: u16,
    pub(super) rotary_mask: u16,
    /// The linear axis that retracts.
    pub(super) retract: usize,
    /// What a linear word is more than the axis value without tool, mm.
    zero: [f64; MAX_AXES],
    /// What 1 mm of gauge length adds to it.
    share: [f64; MAX_AXES],
    gauge: bool,
    /// What a rotary axis value is more than its word, rad.
    offset: [f64; MAX_AXES],
    held: [f64; MAX_AXES],
    xyz: [Option<usize>; 3],
    /// Tool axis with all axes at zero.
    tool: Vector3<f64>,
    length: f64,
    pub(super) frame: TcpFrame,
}

impl Words {
    pub(super) fn new(machine: &dyn AnyMachine, config: &Config) -> Self {
        let solved = |kind: AxisKind| {
            let axes = machine.axes().iter().enumerate().filter(move |(_, axis)| axis.kind == kind && !axis.held);
            axes.map(|(index, _)| index).collect::<Vec<usize>>()
        };
        let (linear, rotary) = (solved(AxisKind::Linear), solved(AxisKind::Rotary));
        let chain = Chain::of(machine);
        let tool = machine.tool_axis().into_inner();
        let mut words = Self {
            retract: retract_axis(machine, &linear, &tool),
            linear_mask: mask(&linear),
            rotary_mask: mask(&rotary),
            zero: [0.0; MAX_AXES],
            share: [0.0; MAX_AXES],
            gauge: config.set_up.length_mode == LengthMode::Gauge,
            offset: [0.0; MAX_AXES],
            held: [0.0; MAX_AXES],
            xyz: ['X', 'Y', 'Z'].map(|letter| machine.axes().iter().position(|axis| axis.letter == letter)),
            length: 0.0,
            frame: config.motion.tip.tcp_frame.unwrap_or(TcpFrame::TableAtZero),
            linear,
            chain,
            tool,
        };
        let origin =
            if config.set_up.program_zero == ProgramZero::Table { config.set_up.part_origin } else { [0.0; 3] };
        words.zero = words.along(&origin.into());
        words.share = words.along(&tool);
        for (index, axis) in machine.axes().iter().enumerate() {
            words.offset[index] = config.set_up.rotary_offset.get(&axis.letter).copied().unwrap_or(0.0);
        }
        words.held[..machine.axes().len()].copy_from_slice(&machine.held()[..machine.axes().len()]);
        words
    }

    /// Words of the linear axes whose motion together is a vector, at the zero position.
    fn along(&self, vector: &Vector3<f64>) -> [f64; MAX_AXES] {
        let mut words = [0.0; MAX_AXES];
        if let [x, y, z] = self.linear[..] {
            for (index, value) in [x, y, z].into_iter().zip(self.chain.along([x, y, z], vector)) {
                words[index] = value;
            }
        }
        words
    }

    /// Positions of X Y Z, in which arcs turn.
    pub(super) fn linear_places(&self) -> [Option<usize>; 3] {
        self.xyz
    }

    /// With another tool in the spindle, mm.
    pub(super) fn set_tool(&mut self, machine: &mut dyn AnyMachine, config: &Config, length: f64) {
        machine.set_up(config.set_up.part_origin.into(), length);
        self.chain = Chain::of(machine);
        self.length = length;
    }

    /// Whether the tool in the spindle has another length.
    pub(super) fn length_differs(&self, length: f64) -> bool {
        (self.length - length).abs() > 0.0
    }

    /// Axis values for words, mm and rad.
    pub(super) fn values(&self, words: &[f64; MAX_AXES]) -> [f64; MAX_AXES] {
        let length = if self.gauge { self.length } else { 0.0 };
        std::array::from_fn(|index| {
            let bit = 1 << index;
            if self.linear_mask & bit != 0 {
                words[index] - self.zero[index] - length * self.share[index]
            } else if self.rotary_mask & bit != 0 {
                words[index] + self.offset[index]
            } else {
                self.held[index]
            }
        })
    }

    /// What the gauge length adds to the machine coordinate of a linear axis, mm.
    pub(super) fn gauge_of(&self, index: usize) -> f64 {
        self.length * self.share[index]
    }

    /// Tip and tool axis on the workpiece.
    pub(super) fn place(&self, words: &[f64; MAX_AXES], state: &State) -> Placed {
        match (&state.tip_control, &state.tilt) {
            (TipControl::Off, None) => self.chain.place(&self.values(words)),
            (TipControl::On { start }, _) => {
                let values = self.values(words);
                let tip = self.program_point(words);
                let tip = match self.frame {
                    TcpFrame::TableAtZero => tip,
                    TcpFrame::TableAtStart => self.chain.onto_workpiece(tip, &self.values(start)),
                    TcpFrame::NotTurning => self.chain.onto_workpiece(tip, &values),
                };
                let axis = match &state.vector {
                    Some(vector) => self.direction(vector, &values, start),
                    None => self.chain.place(&values).axis,
                };
                Placed { tip, axis }
            }
            (TipControl::Off, Some(tilt)) => {
                let words = self.turned(words, &tilt.rotation, &tilt.origin);
                let up = self.turned(&self.along(&self.tool), &tilt.rotation, &Vector3::zeros());
                Placed { tip: self.program_point(&words), axis: self.chain.at_zero(&up) }
            }
        }
    }

    /// A tool axis that the program names, on the workpiece.
    fn direction(&self, vector: &Vector3<f64>, values: &[f64; MAX_AXES], start: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut words = [0.0; MAX_AXES];
        if let [Some(x), Some(y), Some(z)] = self.xyz {
            (words[x], words[y], words[z]) = (vector.x, vector.y, vector.z);
        }
        let named = self.chain.at_zero(&words);
        let turned = |values: &[f64; MAX_AXES]| {
            self.chain.onto_workpiece(named, values) - self.chain.onto_workpiece(Vector3::zeros(), values)
        };
        match self.frame {
            TcpFrame::TableAtZero => named,
            TcpFrame::TableAtStart => turned(&self.values(start)),
            TcpFrame::NotTurning => turned(values),
        }
    }

    /// Axis values behind a block, whatever its words count; `None` where the control chooses the rotary axes.
    pub(super) fn axes(&self, words: &[f64; MAX_AXES], state: &State) -> Option<[f64; MAX_AXES]> {
        if state.vector.is_some() { None } else { self.axes_turned(words, state) }
    }

    /// The same where the rotary words are those that the control has chosen.
    pub(super) fn axes_turned(&self, words: &[f64; MAX_AXES], state: &State) -> Option<[f64; MAX_AXES]> {
        let mut values = self.values(words);
        if state.tip_control == TipControl::Off && state.tilt.is_none() {
            return Some(values);
        }
        let [x, y, z] = self.linear_three()?;
        let tip = self.place(words, state).tip;
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

    fn linear_three(&self) -> Option<[usize; 3]> {
        self.linear[..].try_into().ok()
    }

    /// Words with the rotary ones of others.
    pub(super) fn with_rotary(&self, words: [f64; MAX_AXES], rotary: &[f64; MAX_AXES]) -> [f64; MAX_AXES] {
        std::array::from_fn(|index| if self.rotary_mask & (1 << index) == 0 { words[index] } else { rotary[index] })
    }

    /// Largest turn of a rotary axis between words, rad.
    pub(super) fn rotary_way(&self, from: &[f64; MAX_AXES], to: &[f64; MAX_AXES]) -> f64 {
        let turned = |index: &usize| self.rotary_mask & (1 << index) != 0;
        (0..MAX_AXES).filter(turned).map(|index| (to[index] - from[index]).abs()).fold(0.0, f64::max)
    }

    /// Tool axis on the workpiece where the rotary words are known.
    pub(super) fn tool_axis(&self, words: &[f64; MAX_AXES]) -> Vector3<f64> {
        self.chain.place(&self.values(words)).axis
    }

    /// Words whose rotary axes bring the tool to an axis of the workpiece, as near as may be to where they stand.
    ///
    /// Newton's method with the smallest step that does it (normal equations, damped by [`DAMPED`]): near the pole, where a
    /// rotary axis turns the tool by next to nothing, that axis is left alone. `None` if it does not come there.
    pub(super) fn turned_to(&self, words: &[f64; MAX_AXES], axis: &Vector3<f64>) -> Option<[f64; MAX_AXES]> {
        let mut words = *words;
        for _ in 0..NEWTON {
            let (stands, rates) = self.chain.axis_rates(&self.values(&words));
            let off = axis - stands;
            if off.norm() < TURNED_TO {
                return Some(words);
            }
            let mut turning = (0..MAX_AXES).filter(|index| self.rotary_mask & (1 << index) != 0);
            let (first, second) = (turning.next()?, turning.next());
            let columns = [rates[first], second.map_or(Vector3::zeros(), |second| rates[second])];
            let jacobian = Matrix3x2::from_columns(&columns);
            let normal = jacobian.tr_mul(&jacobian) + Matrix2::identity() * DAMPED;
            let step = normal.try_inverse()? * jacobian.tr_mul(&off);
            words[first] += step.x;
            if let Some(second) = second {
                words[second] += step.y;
            }
        }
        None
    }

    /// How far the axes of a plane are turned against those that the rotary axes give the linear words, rad.
    pub(super) fn twist(&self, words: &[f64; MAX_AXES], rotation: &Matrix3<f64>) -> f64 {
        let stands = self.chain.rotation(&self.values(words));
        let off = self.xyz.iter().flatten().map(|index| {
            let mut unit = [0.0; MAX_AXES];
            unit[*index] = 1.0;
            let tilted = self.chain.at_zero(&self.turned(&unit, rotation, &Vector3::zeros()));
            angle_between(&(stands * self.chain.at_zero(&unit)), &tilted)
        });
        off.fold(0.0, f64::max)
    }

    /// Words of a plane as words of the program.
    fn turned(&self, words: &[f64; MAX_AXES], rotation: &Matrix3<f64>, origin: &Vector3<f64>) -> [f64; MAX_AXES] {
        let mut turned = *words;
        if let [Some(x), Some(y), Some(z)] = self.xyz {
            let point = origin + rotation * Vector3::new(words[x], words[y], words[z]);
            (turned[x], turned[y], turned[z]) = (point.x, point.y, point.z);
        }
        turned
    }

    /// The point that linear words name, workpiece frame, mm.
    fn program_point(&self, words: &[f64; MAX_AXES]) -> Vector3<f64> {
        let mut values = [0.0; MAX_AXES];
        for &index in &self.linear {
            values[index] = words[index] - self.zero[index];
        }
        self.chain.at_zero(&values)
    }
}

fn mask(axes: &[usize]) -> u16 {
    axes.iter().fold(0, |mask, index| mask | 1 << index)
}

/// The linear axis most along the tool; of two alike the one nearer the tool.
fn retract_axis(machine: &dyn AnyMachine, linear: &[usize], tool: &Vector3<f64>) -> usize {
    let share = |index: &usize| (machine.joint(*index).direction.dot(tool).abs() * 1e9).round();
    linear.iter().copied().max_by(|a, b| share(a).total_cmp(&share(b))).unwrap_or(0)
}
