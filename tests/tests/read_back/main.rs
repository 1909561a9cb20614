//! Posted programs, read back block by block and compared with the CL data they were made from.
//!
//! The CL data is read by `points`, the program by [`tests::foreign`], and the machine is the product of matrices of
//! [`tests::oracle`]: none of the three shares code with the postprocessor. Every block must be one of the following, and
//! every GOTO must be met in its order:
//!
//! - a retract in machine coordinates, behind it rotary axes alone, the other linear axes, the retract axis;
//! - the retract of the set-up, along the tool axis;
//! - the way in along the tool axis;
//! - a motion to the next GOTO, or a piece of it, on its line and within tolerance; the pieces take the time of the whole.

mod points;
mod set_ups;

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::kinematics::{Axis, AxisKind, Machine, Pose, Side, Solution};
use pp_runtime::nalgebra::{Matrix3, Point3, UnitVector3, Vector3};
use tests::binaries::{binary, workspace};
use tests::block::{angle_to_arc, deviation_from, distance_to_line};
use tests::foreign::state::{Length, Units};
use tests::foreign::{Axes, Control, Effect, Entry, Executed, Feed, Options, Trace, run};
use tests::oracle::{Oracle, angle_between, wrapped};

use points::{ClData, Goto};

/// The last digit of a rotary word, degrees.
const ROTARY_UNIT: f64 = 1e-4;
/// Room for the arithmetic of both sides, mm.
const NOISE: f64 = 1e-8;
/// Inserted points lie on their line within this, mm.
const ON_LINE: f64 = 1e-3;
/// A rapid that turns a rotary by more goes through the safe sequence, degrees.
const INDEX_ANGLE: f64 = 1.0;
/// Half a unit of the sixth digit, relative to the smallest number of six digits.
const SIX_DIGITS: f64 = 0.5e-5;
/// No feed block of the samples turns an axis further, degrees: near the pole a table turns fast, but half a turn would
/// be the other branch.
const LARGEST_TURN: f64 = 90.0;

/// How far a block may leave the motion of the CL data by default: mm, and degrees of the tool axis.
const TOLERANCE: (f64, f64) = (0.01, 0.1);
/// Places of a block that are looked at.
const BLOCK_POINTS: usize = 100;

/// Travel of a linear axis: letter, machine coordinate at the zero position, lowest, highest; mm.
type Travel = (char, f64, f64, f64);

/// What the configuration of a program says, stated once more in millimetres.
#[derive(Debug, Clone)]
struct SetUp {
    config: Option<&'static str>,
    part_origin: [f64; 3],
    lengths: &'static [(u32, f64)],
    approach: f64,
    /// Distance along the tool axis.
    out: Option<f64>,
    /// Machine coordinate of Z.
    retract: f64,
    travel: &'static [Travel],
    park: &'static [(char, f64)],
    counting: Counting,
    /// Posted with tolerances so wide that no point is inserted.
    coarse: bool,
}

/// How the part lies, and what words count from.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Counting {
    /// The CL data is multiplied by this.
    rotation: Matrix3<f64>,
    /// Degrees between words and values of A, B and C.
    offsets: [f64; 3],
    /// Linear words count from the table.
    from_table: bool,
    /// Linear words are those of the gauge line.
    gauge_line: bool,
}

#[rustfmt::skip]
const USUAL: Counting = Counting {
    rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
    offsets: [0.0; 3],
    from_table: false,
    gauge_line: false,
};

const PLAIN: SetUp = SetUp {
    config: None,
    part_origin: [0.0; 3],
    lengths: &[],
    approach: 50.0,
    out: None,
    retract: 0.0,
    travel: &[],
    park: &[],
    counting: USUAL,
    coarse: false,
};

const COIL: SetUp = SetUp {
    config: Some("coil/coil.toml"),
    part_origin: [35.0, 4.5, 62.0],
    lengths: &[(4, 92.3)],
    approach: 20.0,
    out: Some(25.0),
    retract: -5.0,
    travel: &[('X', -180.0, -300.0, 0.0), ('Y', -95.0, -200.0, 0.0), ('Z', -310.0, -350.0, 0.0)],
    park: &[('A', 0.0)],
    counting: USUAL,
    coarse: false,
};

const PADS: SetUp = SetUp {
    config: Some("pads/pads.toml"),
    part_origin: [12.5, -8.0, 40.0],
    lengths: &[(21, 120.25), (22, 96.5)],
    approach: 30.0,
    out: Some(75.0),
    retract: 0.0,
    travel: &[('X', 20.0, -310.0, 310.0), ('Y', -15.0, -255.0, 255.0), ('Z', -520.0, -460.0, 0.0)],
    park: &[('X', 0.0), ('Y', 240.0)],
    counting: USUAL,
    coarse: false,
};

fn data(name: &str) -> PathBuf {
    workspace().join("tests/data").join(name)
}

fn sample(name: &str) -> PathBuf {
    workspace().join("examples/cl").join(name)
}

fn posted(machine: &str, cl: &PathBuf, set_up: &SetUp) -> String {
    posted_with(machine, cl, set_up.config.map(data).as_deref(), set_up.coarse)
}

fn posted_with(machine: &str, cl: &PathBuf, config: Option<&Path>, coarse: bool) -> String {
    let mut command = binary(machine);
    command.arg("post").arg(cl);
    if let Some(config) = config {
        command.arg("--config").arg(config);
    }
    if coarse {
        command.args(["--tolerance", "1", "--axis-tolerance-path", "10"]);
    }
    let output = command.output().expect("the binary runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{machine} does not post {}:\n{errors}", cl.display());
    String::from_utf8(output.stdout).expect("a program is ASCII")
}

/// What must be equal between the program and the CL data.
#[derive(Debug, Default, PartialEq)]
struct Checked {
    points: usize,
    approaches: usize,
    retracts: usize,
}

/// Where in the safe sequence the tool stands.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
enum Stage {
    /// In the cut, or between two GOTOs.
    Running,
    /// The retract axis stands at its machine position.
    Away,
    /// The rotary axes have turned.
    Turned,
    /// The other linear axes have followed.
    Beside,
    /// At the approach point.
    Above,
}

/// A straight motion of the program.
struct Motion {
    /// Its words are machine coordinates.
    machine: bool,
    rapid: bool,
    written: Axes,
    /// Every known position after it.
    position: Axes,
    feed: Option<Feed>,
    inches: bool,
}

impl Motion {
    fn of(step: &Executed) -> Self {
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

/// A motion of several blocks: where it began, and how long its blocks have taken.
#[derive(Debug, Clone, Copy)]
struct UnderWay {
    tip: Point3<f64>,
    axis: Vector3<f64>,
    minutes: f64,
    /// A block of it moved the tip by less than a unit of the words: it takes the time of its turn.
    still: bool,
}

struct Reader<'a, M: Machine> {
    set_up: &'a SetUp,
    cl: &'a ClData,
    machine: M,
    oracle: Oracle,
    tool: Option<u32>,
    /// mm in the program's unit of length.
    scale: f64,
    /// What linear words are more than the axis values, in the order of the axes, mm.
    shift: Vec<f64>,
    /// The last digit of a linear word, mm.
    unit: f64,
    stage: Stage,
    next: usize,
    /// Where the tip stands in the CL data's own digits, and the words it stands at.
    place: Option<(Point3<f64>, Axes)>,
    /// The motion that is under way in several blocks.
    under_way: Option<UnderWay>,
    /// How far the last motions have led the tool out along its axis, mm.
    led_out: f64,
    parked: BTreeSet<char>,
    /// How near a word of a GOTO comes to being rounded to its neighbour, in units of its last digit.
    edge: f64,
    checked: Checked,
}

impl<'a, M: Machine> Reader<'a, M> {
    fn new(set_up: &'a SetUp, cl: &'a ClData) -> Self {
        let machine = M::default();
        let oracle = Oracle::of(&machine);
        let checked = Checked::default();
        let (scale, unit, stage, parked) = (1.0, 1e-3, Stage::Away, BTreeSet::new());
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
            place: None,
            under_way: None,
            led_out: 0.0,
            parked,
            edge: 0.5,
            checked,
        }
    }

    /// Gauge length of the tool in the spindle; zero where nobody knows it.
    fn length(&self) -> f64 {
        let tool = self.tool.expect("a tool is called before anything moves");
        let given = self.set_up.lengths.iter().find(|(number, _)| *number == tool).map(|(_, length)| *length);
        given.or_else(|| self.cl.lengths.get(&tool).copied()).unwrap_or(0.0)
    }

    fn call(&mut self, tool: u32) {
        self.tool = Some(tool);
        self.machine.set_up(Vector3::from(self.set_up.part_origin), self.length());
        self.oracle = Oracle::of(&self.machine);
        let Counting { from_table, gauge_line, .. } = self.set_up.counting;
        let mut more = Vector3::zeros();
        if from_table {
            more += Vector3::from(self.set_up.part_origin);
        }
        if gauge_line {
            more += self.machine.tool_axis().into_inner() * self.length();
        }
        // The linear axes that together move the tool by this at the zero position.
        self.shift = vec![0.0; M::AXES.len()];
        self.oracle.bring_tip_to(&Point3::from(more), &mut self.shift);
    }

    /// Degrees of an axis value for a word.
    fn angle(&self, letter: char, word: f64) -> f64 {
        word + "ABC".find(letter).map_or(0.0, |index| self.set_up.counting.offsets[index])
    }

    /// Axis values in chain order, mm and rad; `None` while a word is unknown.
    fn values(&self, position: &Axes, scale: f64) -> Option<Vec<f64>> {
        let value = |(axis, shift): (&Axis, &f64)| {
            let word = position.get(axis.letter)?;
            let rotary = axis.kind == AxisKind::Rotary;
            Some(if rotary { self.angle(axis.letter, word).to_radians() } else { word * scale - shift })
        };
        M::AXES.iter().zip(&self.shift).map(value).collect()
    }

    fn letters(kind: AxisKind) -> Vec<char> {
        let mut letters: Vec<char> = M::AXES.iter().filter(|axis| axis.kind == kind).map(|axis| axis.letter).collect();
        letters.sort_unstable();
        letters
    }

    /// How far the linear words are from those that bring the tip to `tip` at the rotary words as they stand.
    fn words_off(&self, values: &[f64], tip: &Point3<f64>) -> f64 {
        let mut exact = values.to_vec();
        self.oracle.bring_tip_to(tip, &mut exact);
        values.iter().zip(&exact).map(|(word, exact)| (word - exact).abs()).fold(0.0, f64::max)
    }

    /// Requires words to stand at a GOTO.
    fn check_point(&mut self, line: usize, values: &[f64], position: &Axes) {
        let Some(goto) = self.cl.points.get(self.next) else { panic!("line {line} moves on behind the last GOTO") };
        let pose = self.oracle.forward(values);
        let leaning = angle_between(&pose.axis, &goto.axis).to_degrees();
        assert!(leaning <= ROTARY_UNIT, "line {line}: the tool axis of CL line {} is missed by {leaning}°", goto.line);
        let off = self.words_off(values, &goto.tip);
        assert!(off <= 0.5 * self.unit + NOISE, "line {line}: a linear word of CL line {} is {off} mm off", goto.line);
        self.edge = self.edge.min(self.distance_to_edge(values, goto));
        let linear_words = Self::letters(AxisKind::Linear).len() as f64;
        let missed = (pose.tip - goto.tip).norm();
        assert!(missed <= 0.5 * self.unit * linear_words.sqrt() + NOISE, "line {line}: the tip is {missed} mm off");
        assert_eq!(self.tool, Some(goto.tool), "line {line}: the tool of CL line {}", goto.line);
        self.place = Some((goto.tip, *position));
        self.next += 1;
        self.checked.points += 1;
    }

    /// How far the exact words of a GOTO are from the middle between two digits, in units of the last digit.
    fn distance_to_edge(&self, values: &[f64], goto: &Goto) -> f64 {
        let mut exact = values.to_vec();
        self.oracle.bring_tip_to(&goto.tip, &mut exact);
        let axis = UnitVector3::new_normalize(goto.axis);
        let mut held = M::HELD;
        held.as_mut().copy_from_slice(values);
        // Of the branches the one that was posted; what a free rotary is set to is a number of the program's own.
        let solutions = self.machine.inverse_kinematics(&Pose { tip: goto.tip, axis }, &held);
        let turn = |solution: &Solution<M::Axes>| {
            let away = solution.axes.as_ref().iter().zip(values).zip(M::AXES);
            away.filter(|(_, axis)| axis.kind == AxisKind::Rotary).map(|((a, b), _)| wrapped(a - b).abs()).sum::<f64>()
        };
        let nearest = solutions.iter().min_by(|one, other| turn(one).total_cmp(&turn(other))).expect("it was posted");
        let units = M::AXES.iter().enumerate().map(|(index, axis)| match axis.kind {
            AxisKind::Linear => exact[index] / self.unit,
            AxisKind::Rotary => nearest.axes.as_ref()[index].to_degrees() / ROTARY_UNIT,
        });
        units.map(|units| (units - units.floor() - 0.5).abs()).fold(0.5, f64::min)
    }

    /// GOTOs that repeat the one before need no block.
    fn pass_repeated(&mut self) {
        while let (Some((_, position)), Some(goto)) = (self.place, self.cl.points.get(self.next))
            && self.next > 0
            && self.cl.points[self.next - 1].operation == goto.operation
            && (self.cl.points[self.next - 1].tip - goto.tip).norm() < 1e-9
            && (self.cl.points[self.next - 1].axis - goto.axis).norm() < 1e-12
        {
            let values = self.values(&position, self.scale).expect("every word is known in the cut");
            self.check_point(0, &values, &position);
        }
    }

    fn motion(&mut self, line: usize, motion: &Motion, then_machine: bool) {
        (self.scale, self.unit) = if motion.inches { (25.4, 25.4e-4) } else { (1.0, 1e-3) };
        self.check_limits(line, motion);
        if motion.machine {
            return self.machine_motion(line, motion);
        }
        let written: Vec<char> = motion.written.letters().collect();
        let (linear, rotary) = (Self::letters(AxisKind::Linear), Self::letters(AxisKind::Rotary));
        if self.stage == Stage::Away && self.next == self.cl.points.len() {
            let parked = |word: (char, f64)| self.set_up.park.contains(&word);
            assert!(motion.rapid && motion.written.iter().all(parked), "line {line}: neither a point nor parking");
            self.parked.extend(written);
            return;
        }
        if matches!(self.stage, Stage::Away | Stage::Turned | Stage::Beside) {
            assert!(motion.rapid, "line {line}: the way to the approach point is a rapid");
        }
        match self.stage {
            Stage::Away if written.iter().all(|letter| rotary.contains(letter)) => {
                self.stage = Stage::Turned;
                return;
            }
            Stage::Turned if written.iter().all(|letter| linear.contains(letter) && *letter != 'Z') => {
                self.stage = Stage::Beside;
                return;
            }
            Stage::Turned | Stage::Beside => {
                assert_eq!(written, ['Z'], "line {line}: the retract axis comes down alone");
                self.stage = Stage::Above;
            }
            Stage::Away => panic!("line {line}: behind a retract the rotary axes turn first, alone"),
            Stage::Running | Stage::Above => {}
        }
        let values =
            self.values(&motion.position, self.scale).unwrap_or_else(|| panic!("line {line}: a word is unknown"));
        let came_down = written == ['Z'] && motion.rapid && self.place.is_none();
        if self.stage == Stage::Above && came_down {
            self.approach(line, &values, &motion.position);
        } else if self.is_way_out(motion, &values, then_machine) {
            self.checked.retracts += 1;
            self.led_out = self.set_up.out.unwrap_or(0.0);
        } else {
            self.go_to(line, motion, &values);
        }
    }

    /// The approach point: the first GOTO if the next lies straight below it, else a point above the first GOTO.
    fn approach(&mut self, line: usize, values: &[f64], position: &Axes) {
        let goto = &self.cl.points[self.next];
        let below = self.cl.points.get(self.next + 1).filter(|next| next.operation == goto.operation);
        let is_above = goto.rapid && below.is_some_and(|below| straight_down(goto, below));
        self.checked.approaches += 1;
        if is_above {
            self.check_point(line, values, position);
            self.stage = Stage::Running;
        } else {
            let above = goto.tip + goto.axis * self.set_up.approach;
            self.check_inserted(line, values, &above, &goto.axis);
            self.place = Some((above, *position));
        }
    }

    fn check_inserted(&self, line: usize, values: &[f64], tip: &Point3<f64>, axis: &Vector3<f64>) {
        let pose = self.oracle.forward(values);
        let missed = (pose.tip - tip).norm();
        let allowed = ON_LINE.max(self.unit);
        assert!(missed <= allowed, "line {line}: the inserted point is {missed} mm off its line");
        let leaning = angle_between(&pose.axis, axis).to_degrees();
        assert!(leaning <= ROTARY_UNIT, "line {line}: the tool axis of the inserted point is {leaning}° off");
    }

    /// Out along the tool axis by the distance of the set-up, before a retract of the machine.
    fn is_way_out(&self, motion: &Motion, values: &[f64], then_machine: bool) -> bool {
        let (Some(distance), Some((tip, _)), true) = (self.set_up.out, &self.place, motion.rapid && then_machine)
        else {
            return false;
        };
        let Pose { axis, .. } = self.oracle.forward(values);
        self.check_inserted(0, values, &(tip + axis.into_inner() * distance), &axis);
        true
    }

    /// A motion to the next GOTO.
    fn go_to(&mut self, line: usize, motion: &Motion, values: &[f64]) {
        let Some((from, before)) = self.place else { panic!("line {line}: nobody knows where it begins") };
        let linear_only = motion.written.letters().all(|letter| !"ABC".contains(letter));
        assert!(self.stage == Stage::Running || linear_only, "line {line}: the way in turns an axis");
        let goto = self.cl.points.get(self.next).unwrap_or_else(|| panic!("line {line}: there is no GOTO left"));
        let (rapid, feed, tip, cl_line) = (goto.rapid, goto.feed, goto.tip, goto.line);
        assert_eq!(motion.rapid, rapid, "line {line}: CL line {cl_line} wants the other of G0 and G1");
        let turn = before
            .iter()
            .filter(|(letter, _)| "ABC".contains(*letter))
            .map(|(letter, word)| (motion.position.get(letter).expect("a position") - word).abs())
            .fold(0.0, f64::max);
        if rapid {
            assert!(turn <= INDEX_ANGLE + 1e-9, "line {line}: a rapid turns an axis by {turn}° without a retract");
        } else {
            assert!(turn <= LARGEST_TURN, "line {line}: a cut turns an axis by {turn}°");
            let written = motion.feed.unwrap_or_else(|| panic!("line {line}: no F"));
            let before = self.values(&before, self.scale).expect("every word is known in the cut");
            if self.piece(line, &before, values, written, turn > 0.0) {
                let reached = self.oracle.forward(values).tip;
                self.place = Some((reached, motion.position));
                self.led_out = 0.0;
                self.stage = Stage::Running;
                return;
            }
            if self.under_way.take().is_none() {
                check_feed(line, written, feed, (tip - from).norm(), turn, self.scale);
            }
        }
        let step = tip - from;
        let leads_out = turn == 0.0 && angle_between(&step, &self.oracle.forward(values).axis) <= 1e-3;
        self.led_out = if leads_out { self.led_out + step.norm() } else { 0.0 };
        self.check_point(line, values, &motion.position);
        self.stage = Stage::Running;
        self.pass_repeated();
    }

    /// Follows a motion that turns an axis, block by block; true if this one ends before the GOTO.
    fn piece(&mut self, line: usize, before: &[f64], values: &[f64], written: Feed, turns: bool) -> bool {
        let goto = &self.cl.points[self.next];
        let Some((tip, _)) = self.place else { return false };
        let begun = self.under_way.unwrap_or_else(|| {
            let axis = self.oracle.forward(before).axis.into_inner();
            UnderWay { tip, axis, minutes: 0.0, still: false }
        });
        if !turns && self.under_way.is_none() {
            return false;
        }
        let ends = ((&begun.tip, &begun.axis), (&goto.tip, &goto.axis));
        let off = deviation_from(&self.oracle, before, values, BLOCK_POINTS, ends.0, ends.1);
        let (tip_tolerance, axis_tolerance) = if self.set_up.coarse { (1.0, 10.0) } else { TOLERANCE };
        assert!(off.tip <= tip_tolerance, "line {line}: the tip leaves its line by {} mm", off.tip);
        assert!(off.axis.to_degrees() <= axis_tolerance, "line {line}: the tool axis is {} rad off", off.axis);
        let pose = self.oracle.forward(values);
        let room = 0.5 * self.unit * 3_f64.sqrt() + NOISE;
        let length = (pose.tip - self.oracle.forward(before).tip).norm();
        let (minutes, exact) = match written {
            Feed::InverseTime(word) => (1.0 / word, length / goto.feed),
            Feed::PerMinute(word) => (length / (word * self.scale), length / goto.feed),
            Feed::PerRevolution(_) => panic!("line {line}: G95"),
        };
        let still = length < self.unit + 2.0 * room;
        let late = (minutes - exact).abs();
        assert!(still || late <= (2.0 * room + 1e-5 * length) / goto.feed, "line {line}: a piece takes {minutes} min");
        let under_way = UnderWay { minutes: begun.minutes + minutes, still: begun.still || still, ..begun };
        let leaning = angle_between(&pose.axis, &goto.axis).to_degrees();
        if (pose.tip - goto.tip).norm() <= 2.0 * room && leaning <= 2.0 * ROTARY_UNIT {
            if self.under_way.is_some() {
                self.under_way = Some(under_way);
                let whole = (goto.tip - begun.tip).norm() / goto.feed;
                let late = (under_way.minutes - whole).abs();
                assert!(
                    under_way.still || late <= 2.0 * SIX_DIGITS * whole,
                    "line {line}: {under_way:?} for {whole} min"
                );
            }
            return false;
        }
        let missed = distance_to_line(&pose.tip, &begun.tip, &goto.tip);
        assert!(missed <= room, "line {line}: the inserted point is {missed} mm off its line");
        let leaning = angle_to_arc(&pose.axis, &begun.axis, &goto.axis).to_degrees();
        assert!(leaning <= 3.0 * ROTARY_UNIT, "line {line}: the tool axis of the inserted point is {leaning}° off");
        self.under_way = Some(under_way);
        true
    }

    fn machine_motion(&mut self, line: usize, motion: &Motion) {
        if self.stage == Stage::Running && self.place.take().is_some() {
            let head = M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool);
            let wanted = self.set_up.out.unwrap_or(if head { 1.0 } else { 0.0 });
            assert!(self.led_out >= wanted, "line {line}: the tool leaves the part {} mm along its axis", self.led_out);
        }
        self.place = None;
        self.led_out = 0.0;
        let parking = self.next == self.cl.points.len() && self.stage == Stage::Away;
        for (letter, value) in motion.written.iter() {
            let value = value * self.scale;
            let parked = self.set_up.park.iter().any(|(axis, place)| *axis == letter && (place - value).abs() < 1e-9);
            let retracted = letter == 'Z' && (value - self.set_up.retract).abs() < 1e-9;
            assert!(retracted || (parking && parked), "line {line}: {letter} goes to {value} in machine coordinates");
            self.parked.extend(parked.then_some(letter));
        }
        self.stage = Stage::Away;
    }

    /// Rotary words against the declared limits, linear words against the travel of the set-up.
    fn check_limits(&self, line: usize, motion: &Motion) {
        for axis in M::AXES {
            let Some(word) = motion.written.get(axis.letter) else { continue };
            if axis.kind == AxisKind::Rotary {
                if let Some(limits) = axis.limits {
                    let (low, high) = (limits.lower.to_degrees() - 1e-9, limits.upper.to_degrees() + 1e-9);
                    let inside = (low..=high).contains(&self.angle(axis.letter, word));
                    assert!(inside, "line {line}: {}{word} is beyond its limit", axis.letter);
                }
            } else if let Some((_, zero, low, high)) = self.set_up.travel.iter().find(|travel| travel.0 == axis.letter)
            {
                // The tool's length acts along Z of every machine here.
                let length = if axis.letter == 'Z' && !motion.machine { self.length() } else { 0.0 };
                let word = word * self.scale;
                let place = if motion.machine { word } else { zero + word + length };
                let inside = (low - 1e-9..=high + 1e-9).contains(&place);
                assert!(inside, "line {line}: {}{word} is machine coordinate {place}", axis.letter);
            }
        }
    }
}

fn straight_down(first: &Goto, next: &Goto) -> bool {
    let step = next.tip - first.tip;
    let along = step.dot(&first.axis);
    let across = (step - first.axis * along).norm();
    along < 0.0 && across <= ON_LINE && (first.axis - next.axis).norm() <= 1e-6
}

/// `feed` and `length` in mm, `turn` in degrees; `scale`: mm in the program's unit.
fn check_feed(line: usize, written: Feed, feed: f64, length: f64, turn: f64, scale: f64) {
    match written {
        Feed::PerMinute(word) => {
            assert!(turn == 0.0, "line {line}: G94 in a block that turns an axis");
            assert!((word - feed / scale).abs() <= 0.5e-3 + 1e-9, "line {line}: F{word} for {feed} mm/min");
        }
        Feed::PerRevolution(_) => panic!("line {line}: G95"),
        Feed::InverseTime(word) => {
            assert!(turn > 0.0, "line {line}: G93 in a block that turns nothing");
            let exact = feed / length;
            let off = (word / exact - 1.0).abs();
            assert!(off <= SIX_DIGITS, "line {line}: F{word}, and {feed} mm/min over {length} mm is {exact}");
        }
    }
}

/// The text of a program and its CL data.
fn made<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) -> (String, ClData) {
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data is there"));
    let text = posted(name, path, set_up);
    check::<M>(&text, path, &cl, set_up);
    (text, cl)
}

/// Posts, reads back, and checks every block and every GOTO.
fn read_back<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) -> Checked {
    let text = posted(name, path, set_up);
    let cl = points::read(&std::fs::read_to_string(path).expect("the CL data is there"));
    check::<M>(&text, path, &cl, set_up)
}

fn check<M: Machine>(text: &str, path: &Path, cl: &ClData, set_up: &SetUp) -> Checked {
    let options = Options { gauge_line: set_up.counting.gauge_line, ..Options::of(Control::LinuxCnc) };
    let program = run(text, &options).unwrap_or_else(|refused| panic!("{refused}"));
    let mut reader = Reader::<M>::new(set_up, cl);
    let steps = &program.blocks;
    for (index, step) in steps.iter().enumerate() {
        match step.effect {
            Effect::ToolChange(tool) => reader.call(tool),
            Effect::Length(Length::Register(register)) => {
                let head = M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool);
                let next = steps.get(index + 1).map(|step| step.effect);
                let guarded = matches!(next, Some(Effect::Guard { length, tolerance })
                    if (length - reader.length()).abs() < 1e-9 && (tolerance - 0.01).abs() < 1e-12);
                assert_eq!(guarded, head && Some(register) == reader.tool, "line {}: the length guard", step.line);
            }
            Effect::Rapid | Effect::Feed | Effect::Machine => {
                let later = steps[index + 1..].iter().find(|step| step.effect.moves());
                let then_machine = later.is_some_and(|step| step.effect == Effect::Machine);
                reader.motion(step.line, &Motion::of(step), then_machine);
            }
            Effect::Arc(_) | Effect::Hole(_) | Effect::Orient => panic!("line {}: no straight motion", step.line),
            _ => {}
        }
    }
    assert_eq!(reader.next, cl.points.len(), "GOTOs met and GOTOs in the CL data");
    let (edge, own) = (reader.edge, path.starts_with(data("")) && set_up.counting == USUAL);
    assert!(!own || edge > 1e-4, "another platform may round a point the other way: {edge} units");
    assert!(reader.stage == Stage::Away, "the program ends in the part");
    assert_eq!(reader.parked, set_up.park.iter().map(|(letter, _)| *letter).collect());
    enter_everywhere(text, &program, cl, &options);
    reader.checked
}

/// Entered at any of its numbers, a program does what it does there when it runs from the top.
fn enter_everywhere(text: &str, whole: &Trace, cl: &ClData, options: &Options) {
    let mut tool = 0;
    let mut tools = BTreeMap::new();
    for step in &whole.blocks {
        if let Some(number) = step.number {
            tools.insert(number, (tool, step.line));
        }
        if let Effect::ToolChange(called) = step.effect {
            tool = called;
        }
    }
    let mut operations: Vec<usize> = cl.points.iter().map(|goto| goto.operation).collect();
    operations.dedup();
    assert!(tools.keys().copied().eq(1..=operations.len() as u32), "an operation has no number: {tools:?}");
    for (number, (tool, line)) in tools {
        let entered = run(text, &Options { entry: Some(Entry { line, tool: Some(tool) }), ..options.clone() });
        let entered = entered.unwrap_or_else(|refused| panic!("N{number}: {refused}"));
        let after = |step: &Executed| (step.effect, step.words, step.feed());
        let expected: Vec<_> = whole.motions().filter(|step| step.line > line).map(after).collect();
        let found: Vec<_> = entered.motions().map(after).collect();
        assert_eq!(found, expected, "N{number}");
    }
}

/// Checks that as many GOTOs were met as there are lines that begin with GOTO.
fn assert_complete(path: &PathBuf, checked: &Checked) {
    let text = std::fs::read_to_string(path).expect("the CL data is there");
    let gotos = text.lines().filter(|line| line.starts_with("GOTO")).count();
    assert!(gotos > 0 && checked.points == gotos, "{} of {gotos} GOTOs were met", checked.points);
}

macro_rules! programs {
    ($($name:ident: $machine:ty, $binary:literal, $path:expr, $set_up:expr;)*) => {
        $(#[test]
        fn $name() {
            let path = $path;
            let checked = read_back::<$machine>($binary, &path, &$set_up);
            assert_complete(&path, &checked);
        })*
    };
}

programs! {
    spinner_cuts_every_point_of_the_dome: SpinnerU5620, "spinner-u5-620", sample("convex.cls"), PLAIN;
    dmu_cuts_every_point_of_the_dome: Dmu70e, "dmu-70e", sample("convex.cls"), PLAIN;
    lola_cuts_every_point_of_the_dome: LolaXoyzba, "lola-xoyzba", sample("convex.cls"), PLAIN;
    spinner_cuts_every_point_of_the_bowl_of_catia: SpinnerU5620, "spinner-u5-620", sample("concave.aptsource"), PLAIN;
    dmu_cuts_every_point_of_the_bowl_of_catia: Dmu70e, "dmu-70e", sample("concave.aptsource"), PLAIN;
    lola_cuts_every_point_of_the_bowl_of_catia: LolaXoyzba, "lola-xoyzba", sample("concave.aptsource"), PLAIN;
    spinner_cuts_every_point_of_the_bowl_of_creo: SpinnerU5620, "spinner-u5-620", sample("concave.ncl"), PLAIN;
    dmu_cuts_every_point_of_the_bowl_of_creo: Dmu70e, "dmu-70e", sample("concave.ncl"), PLAIN;
    lola_cuts_every_point_of_the_bowl_of_creo: LolaXoyzba, "lola-xoyzba", sample("concave.ncl"), PLAIN;
    multiprodesk_cuts_every_point_of_the_trough: MultiProDesk, "multiprodesk", sample("concave_4axis.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_groove: MultiProDesk, "multiprodesk", sample("spiral_groove.cls"), PLAIN;
    spinner_cuts_every_point_of_two_tools: SpinnerU5620, "spinner-u5-620", sample("two_tools.cls"), PLAIN;
    dmu_cuts_every_point_of_two_tools: Dmu70e, "dmu-70e", sample("two_tools.cls"), PLAIN;
    lola_cuts_every_point_of_two_tools: LolaXoyzba, "lola-xoyzba", sample("two_tools.cls"), PLAIN;

    spinner_cuts_every_point_of_the_blade: SpinnerU5620, "spinner-u5-620", data("blade/blade.cls"), PLAIN;
    dmu_cuts_every_point_of_the_blade: Dmu70e, "dmu-70e", data("blade/blade.cls"), PLAIN;
    lola_cuts_every_point_of_the_blade: LolaXoyzba, "lola-xoyzba", data("blade/blade.cls"), PLAIN;
    spinner_cuts_every_point_of_the_facets: SpinnerU5620, "spinner-u5-620", data("facets/facets.aptsource"), PLAIN;
    dmu_cuts_every_point_of_the_facets: Dmu70e, "dmu-70e", data("facets/facets.aptsource"), PLAIN;
    lola_cuts_every_point_of_the_facets: LolaXoyzba, "lola-xoyzba", data("facets/facets.aptsource"), PLAIN;
    spinner_cuts_every_point_of_the_rim: SpinnerU5620, "spinner-u5-620", data("rim/rim.ncl"), PLAIN;
    dmu_cuts_every_point_of_the_rim: Dmu70e, "dmu-70e", data("rim/rim.ncl"), PLAIN;
    lola_cuts_every_point_of_the_rim: LolaXoyzba, "lola-xoyzba", data("rim/rim.ncl"), PLAIN;
    spinner_cuts_every_point_of_the_keyway: SpinnerU5620, "spinner-u5-620", data("key_inch/key_inch.cls"), PLAIN;
    dmu_cuts_every_point_of_the_keyway: Dmu70e, "dmu-70e", data("key_inch/key_inch.cls"), PLAIN;
    lola_cuts_every_point_of_the_keyway: LolaXoyzba, "lola-xoyzba", data("key_inch/key_inch.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_keyway: MultiProDesk, "multiprodesk", data("key_inch/key_inch.cls"), PLAIN;
    multiprodesk_cuts_every_point_of_the_coil: MultiProDesk, "multiprodesk", data("coil/coil.cls"), COIL;
    spinner_cuts_every_point_of_the_pads: SpinnerU5620, "spinner-u5-620", data("pads/pads.cls"), PADS;
    dmu_cuts_every_point_of_the_pads: Dmu70e, "dmu-70e", data("pads/pads.cls"), PADS;
    lola_cuts_every_point_of_the_pads: LolaXoyzba, "lola-xoyzba", data("pads/pads.cls"), PADS;
}

#[test]
fn inserted_points_are_counted() {
    let checked = read_back::<LolaXoyzba>("lola-xoyzba", &data("pads/pads.cls"), &PADS);
    assert_eq!((checked.approaches, checked.retracts), (3, 3));
    let checked = read_back::<SpinnerU5620>("spinner-u5-620", &data("facets/facets.aptsource"), &PLAIN);
    assert_eq!((checked.approaches, checked.retracts), (5, 0));
}

/// The number behind the letter at the beginning of a word, with `change` added.
fn shifted(word: &str, change: f64) -> String {
    let (letter, number) = word.split_at(1);
    let value: f64 = number.parse().expect("a number");
    format!("{letter}{}", ((value + change) * 1e4).round() / 1e4 + 0.0)
}

/// Everything that could be wrong with a program, one slip at a time.
fn slips(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut slips = Vec::new();
    // The length guard moves nothing.
    for (index, line) in lines.iter().enumerate().filter(|(_, line)| !line.starts_with(['(', 'o'])) {
        let mut with = |line: Option<String>| {
            let all = lines.iter().enumerate();
            let all = all.filter_map(|(at, old)| if at == index { line.clone() } else { Some((*old).to_owned()) });
            slips.push(all.map(|line| line + "\n").collect::<String>());
        };
        let words: Vec<&str> = line.split(' ').collect();
        let cut = !words.contains(&"G0") && line.contains(" F");
        for (at, word) in words.iter().enumerate() {
            let change = match word.as_bytes()[0] {
                // An inserted point may be a unit off its line, a cut may not.
                b'X' | b'Y' | b'Z' => Some(if cut { 0.001 } else { 0.003 }),
                b'A' | b'B' | b'C' => Some(0.01),
                b'F' => Some(0.002),
                _ => None,
            };
            if let Some(change) = change {
                let mut words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
                words[at] = shifted(word, change);
                with(Some(words.join(" ")));
            }
        }
        // What only tidies up may be missing.
        if !["M9", "M5", "M8", "G94", "M0", "M1", "G4 P2.5"].contains(line) && *line != "G53 G0 Z0" {
            with(None);
        }
    }
    slips
}

fn every_slip_is_found<M: Machine>(name: &str, path: &PathBuf, set_up: &SetUp) {
    let (text, cl) = made::<M>(name, path, set_up);
    let slips = slips(&text);
    assert!(slips.len() > 50, "{} slips", slips.len());
    for slip in slips {
        let missed = catch_unwind(AssertUnwindSafe(|| check::<M>(&slip, path, &cl, set_up))).is_ok();
        if missed {
            let (line, (was, is)) =
                text.lines().zip(slip.lines()).enumerate().find(|(_, (was, is))| was != is).expect("a slip");
            panic!("line {}: `{was}` became `{is}`, and nobody saw it", line + 1);
        }
    }
}

#[test]
fn no_wrong_digit_and_no_missing_block_passes() {
    let coarse = |set_up: SetUp| SetUp { coarse: true, ..set_up };
    every_slip_is_found::<SpinnerU5620>("spinner-u5-620", &data("blade/blade.cls"), &coarse(PLAIN));
    every_slip_is_found::<LolaXoyzba>("lola-xoyzba", &data("pads/pads.cls"), &coarse(PADS));
}
