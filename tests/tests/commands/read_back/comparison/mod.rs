//! Comparison of the blocks of a program, one after the other, with the GOTOs that they must reach.
//!
//! No text is read here: the blocks are those that [`tests::foreign`] has executed. The CL data and the oracle alone
//! decide what a block must be, as a second opinion beside the product's `check::compare`: no mode, rule or tolerance
//! is taken from there. This file has the state of the comparison and decides the purpose of a block; `motions` checks
//! each kind of motion.

mod motions;

use std::collections::BTreeSet;

use pp_runtime::kinematics::{Axis, AxisKind, Machine, Pose, Solution};
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
use tests::foreign::state::Units;
use tests::foreign::{Axes, Effect, Executed, Feed};
use tests::oracle::{Oracle, angle_between, wrapped};

use super::given::{SetUp, WordDatum};
use super::points::{ClData, Goto};

/// The last digit of a rotary word, degrees.
const ROTARY_UNIT: f64 = 1e-4;
/// Allowance for the arithmetic of both sides, mm.
const NOISE: f64 = 1e-8;
/// Largest distance of an inserted point from its line, mm.
const ON_LINE: f64 = 1e-3;
/// Rotation in a rapid beyond which the safe sequence is required, degrees.
const INDEX_ANGLE: f64 = 1.0;
/// Half a unit of the sixth digit, relative to the smallest number of six digits.
const SIX_DIGITS: f64 = 0.5e-5;
/// Largest rotation of an axis in a feed block of the samples, degrees: near the pole a table rotates fast, but half a
/// revolution would be the other branch.
const LARGEST_ROTATION: f64 = 90.0;

/// Default tolerances of a block against the motion of the CL data: mm, and degrees of the tool axis.
const TOLERANCE: (f64, f64) = (0.01, 0.1);
/// Samples per block.
const BLOCK_POINTS: usize = 100;

/// Counts of the points, approaches and retracts that are checked.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Checked {
    pub(crate) points: usize,
    pub(crate) approaches: usize,
    pub(crate) retracts: usize,
}

/// Stage of the safe sequence.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) enum Stage {
    /// In the cut, or between two GOTOs.
    Cutting,
    /// The retract axis is at its machine position.
    Retracted,
    /// The rotary axes are at their target.
    RotaryPositioned,
    /// The other linear axes are at their target too.
    LinearPositioned,
    /// At the approach point.
    AtApproach,
}

/// A straight motion of the program.
pub(crate) struct Motion {
    /// Whether its words are machine coordinates.
    pub(crate) machine: bool,
    pub(crate) rapid: bool,
    pub(crate) written: Axes,
    /// Every known position after it.
    pub(crate) position: Axes,
    pub(crate) feed: Option<Feed>,
    pub(crate) inches: bool,
}

impl Motion {
    pub(crate) fn of(step: &Executed) -> Self {
        Self {
            machine: step.effect == Effect::Machine,
            rapid: step.effect != Effect::Feed,
            written: step.words,
            position: step.state.position,
            feed: step.feed(),
            inches: step.state.units == Some(Units::Inches),
        }
    }
}

/// A motion that is split over several blocks: pose at its start, and time of its blocks up to now.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SplitMotion {
    pub(crate) tip: Point3<f64>,
    pub(crate) axis: Vector3<f64>,
    pub(crate) minutes: f64,
    /// Whether a block of it moves the tip by less than a unit of the words: its time is that of the rotation.
    pub(crate) still: bool,
    /// Whether a block of it takes longer, because the axes lead the tip unevenly.
    pub(crate) uneven: bool,
}

pub(crate) struct Comparison<'a, M: Machine> {
    pub(crate) set_up: &'a SetUp,
    pub(crate) cl: &'a ClData,
    pub(crate) machine: M,
    pub(crate) oracle: Oracle,
    pub(crate) tool: Option<u32>,
    /// mm per unit of length of the program.
    pub(crate) scale: f64,
    /// Linear words minus axis values, in the order of the axes, mm.
    pub(crate) shift: Vec<f64>,
    /// The last digit of a linear word, mm.
    pub(crate) unit: f64,
    pub(crate) stage: Stage,
    pub(crate) next: usize,
    /// Last position of the tip in the digits of the CL data, and the words of that position.
    pub(crate) reached: Option<(Point3<f64>, Axes)>,
    /// The present motion, if it is split over several blocks.
    pub(crate) split: Option<SplitMotion>,
    /// Axis values at its start, and at its inserted points that are not on the great circle.
    pub(crate) uneven: Vec<Vec<f64>>,
    /// Distance by which the last motions have retracted the tool along its axis, mm.
    pub(crate) retracted_mm: f64,
    pub(crate) parked: BTreeSet<char>,
    /// Smallest distance of an exact word of a GOTO from the boundary between two roundings, in units of its last
    /// digit.
    pub(crate) edge: f64,
    pub(crate) checked: Checked,
}

impl<'a, M: Machine> Comparison<'a, M> {
    pub(crate) fn new(set_up: &'a SetUp, cl: &'a ClData) -> Self {
        let machine = M::default();
        let oracle = Oracle::of(&machine);
        let checked = Checked::default();
        let (scale, unit, stage, parked) = (1.0, 1e-3, Stage::Retracted, BTreeSet::new());
        Self {
            set_up,
            cl,
            machine,
            oracle,
            tool: None,
            scale,
            shift: vec![0.0; M::AXES.len()],
            unit,
            stage,
            next: 0,
            reached: None,
            split: None,
            uneven: Vec::new(),
            retracted_mm: 0.0,
            parked,
            edge: 0.5,
            checked,
        }
    }

    /// Gauge length of the tool in the spindle, mm; zero if it is unknown.
    pub(crate) fn length(&self) -> f64 {
        let tool = self.tool.expect("a tool is called before anything moves");
        let given = self.set_up.lengths.iter().find(|(number, _)| *number == tool).map(|(_, length)| *length);
        given.or_else(|| self.cl.lengths.get(&tool).copied()).unwrap_or(0.0)
    }

    pub(crate) fn call(&mut self, tool: u32) {
        self.tool = Some(tool);
        self.machine.set_up(Vector3::from(self.set_up.part_origin), self.length());
        self.oracle = Oracle::of(&self.machine);
        let WordDatum { from_table, gauge_line, .. } = self.set_up.datum;
        let mut more = Vector3::zeros();
        if from_table {
            more += Vector3::from(self.set_up.part_origin);
        }
        if gauge_line {
            more += self.machine.tool_axis().into_inner() * self.length();
        }
        // Values of the linear axes that together move the tool by this at the zero position.
        self.shift = vec![0.0; M::AXES.len()];
        self.oracle.bring_tip_to(&Point3::from(more), &mut self.shift);
    }

    /// Axis value of a rotary word, degrees.
    pub(crate) fn angle(&self, letter: char, word: f64) -> f64 {
        word + "ABC".find(letter).map_or(0.0, |index| self.set_up.datum.offsets_deg[index])
    }

    /// Axis values in chain order, mm and rad; `None` while a word is unknown.
    pub(crate) fn values(&self, position: &Axes, scale: f64) -> Option<Vec<f64>> {
        let value = |(axis, shift): (&Axis, &f64)| {
            let word = position.get(axis.letter)?;
            let rotary = axis.kind == AxisKind::Rotary;
            Some(if rotary { self.angle(axis.letter, word).to_radians() } else { word * scale - shift })
        };
        M::AXES.iter().zip(&self.shift).map(value).collect()
    }

    pub(crate) fn letters(kind: AxisKind) -> Vec<char> {
        let mut letters: Vec<char> = M::AXES.iter().filter(|axis| axis.kind == kind).map(|axis| axis.letter).collect();
        letters.sort_unstable();
        letters
    }

    /// Largest difference of the linear words from those that bring the tip to `tip` at the given rotary words, mm.
    pub(crate) fn words_off(&self, values: &[f64], tip: &Point3<f64>) -> f64 {
        let mut exact = values.to_vec();
        self.oracle.bring_tip_to(tip, &mut exact);
        values.iter().zip(&exact).map(|(word, exact)| (word - exact).abs()).fold(0.0, f64::max)
    }

    /// Checks that words reach the next GOTO.
    pub(crate) fn check_point(&mut self, line: usize, values: &[f64], position: &Axes) {
        let Some(goto) = self.cl.points.get(self.next) else { panic!("line {line} moves on after the last GOTO") };
        let pose = self.oracle.forward(values);
        let axis_off = angle_between(&pose.axis, &goto.axis).to_degrees();
        assert!(
            axis_off <= ROTARY_UNIT,
            "line {line}: the tool axis of CL line {} is missed by {axis_off}°",
            goto.line
        );
        let off = self.words_off(values, &goto.tip);
        assert!(off <= 0.5 * self.unit + NOISE, "line {line}: a linear word of CL line {} is {off} mm off", goto.line);
        self.edge = self.edge.min(self.distance_to_edge(values, goto));
        let linear_words = Self::letters(AxisKind::Linear).len() as f64;
        let missed = (pose.tip - goto.tip).norm();
        assert!(missed <= 0.5 * self.unit * linear_words.sqrt() + NOISE, "line {line}: the tip is {missed} mm off");
        assert_eq!(self.tool, Some(goto.tool), "line {line}: the tool of CL line {}", goto.line);
        self.reached = Some((goto.tip, *position));
        self.next += 1;
        self.checked.points += 1;
    }

    /// Smallest distance of the exact words of a GOTO from the boundary between two roundings, in units of the last
    /// digit.
    pub(crate) fn distance_to_edge(&self, values: &[f64], goto: &Goto) -> f64 {
        let mut exact = values.to_vec();
        self.oracle.bring_tip_to(&goto.tip, &mut exact);
        let axis = UnitVector3::new_normalize(goto.axis);
        let mut held = M::HELD;
        held.as_mut().copy_from_slice(values);
        // The branch that was posted; the value of a free rotary is the choice of the program.
        let solutions = self.machine.inverse_kinematics(&Pose { tip: goto.tip, axis }, &held);
        let difference = |solution: &Solution<M::Axes>| {
            let values = solution.axes.as_ref().iter().zip(values).zip(M::AXES);
            values
                .filter(|(_, axis)| axis.kind == AxisKind::Rotary)
                .map(|((a, b), _)| wrapped(a - b).abs())
                .sum::<f64>()
        };
        let nearest =
            solutions.iter().min_by(|one, other| difference(one).total_cmp(&difference(other))).expect("it was posted");
        let units = M::AXES.iter().enumerate().map(|(index, axis)| match axis.kind {
            AxisKind::Linear => exact[index] / self.unit,
            AxisKind::Rotary => nearest.axes.as_ref()[index].to_degrees() / ROTARY_UNIT,
        });
        units.map(|units| (units - units.floor() - 0.5).abs()).fold(0.5, f64::min)
    }

    /// Counts GOTOs that repeat the one before as reached: they need no block.
    pub(crate) fn pass_repeated(&mut self) {
        while let (Some((_, position)), Some(goto)) = (self.reached, self.cl.points.get(self.next))
            && self.next > 0
            && self.cl.points[self.next - 1].operation == goto.operation
            && (self.cl.points[self.next - 1].tip - goto.tip).norm() < 1e-9
            && (self.cl.points[self.next - 1].axis - goto.axis).norm() < 1e-12
        {
            let values = self.values(&position, self.scale).expect("every word is known in the cut");
            self.check_point(0, &values, &position);
        }
    }

    pub(crate) fn motion(&mut self, line: usize, motion: &Motion, then_machine: bool) {
        (self.scale, self.unit) = if motion.inches { (25.4, 25.4e-4) } else { (1.0, 1e-3) };
        self.check_limits(line, motion);
        if motion.machine {
            return self.machine_motion(line, motion);
        }
        let written: Vec<char> = motion.written.letters().collect();
        let (linear, rotary) = (Self::letters(AxisKind::Linear), Self::letters(AxisKind::Rotary));
        if self.stage == Stage::Retracted && self.next == self.cl.points.len() {
            let parked = |word: (char, f64)| self.set_up.park.contains(&word);
            assert!(motion.rapid && motion.written.iter().all(parked), "line {line}: neither a point nor parking");
            self.parked.extend(written);
            return;
        }
        if matches!(self.stage, Stage::Retracted | Stage::RotaryPositioned | Stage::LinearPositioned) {
            assert!(motion.rapid, "line {line}: the path to the approach point must be a rapid");
        }
        match self.stage {
            Stage::Retracted if written.iter().all(|letter| rotary.contains(letter)) => {
                self.stage = Stage::RotaryPositioned;
                return;
            }
            Stage::RotaryPositioned if written.iter().all(|letter| linear.contains(letter) && *letter != 'Z') => {
                self.stage = Stage::LinearPositioned;
                return;
            }
            Stage::RotaryPositioned | Stage::LinearPositioned => {
                assert_eq!(written, ['Z'], "line {line}: the retract axis must move down alone");
                self.stage = Stage::AtApproach;
            }
            Stage::Retracted => panic!("line {line}: after a retract the rotary axes must move first, alone"),
            Stage::Cutting | Stage::AtApproach => {}
        }
        let values =
            self.values(&motion.position, self.scale).unwrap_or_else(|| panic!("line {line}: a word is unknown"));
        let came_down = written == ['Z'] && motion.rapid && self.reached.is_none();
        if self.stage == Stage::AtApproach && came_down {
            self.approach(line, &values, &motion.position);
        } else if self.is_retract_along_axis(motion, &values, then_machine) {
            self.checked.retracts += 1;
            self.retracted_mm = self.set_up.retract_distance_mm.unwrap_or(0.0);
        } else {
            self.go_to(line, motion, &values);
        }
    }
}
