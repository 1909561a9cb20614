//! What the CL data asks for, one item after the other, each with the state that belongs to it.
//!
//! Events come through the reader and the set-up that posting uses; what they mean for the program is worked out here
//! once more, from the specification: which tool, register, speed, sense and coolant belong to a motion, where an
//! operation begins, what is posted at all. Arcs and pieces of curves stay what they are; holes become their motions.

use std::collections::{BTreeMap, VecDeque};
use std::io::{self, Read};

use super::chain::Placed;
use super::hole::{self, Step, unfolded};
use super::path::{Round, Shape, bezier, placed};
use super::read::{Family, Side, coolant};
use crate::cl;
use crate::config::Config;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::{AnyMachine, AxisKind, Pose, Side as ChainSide};
use crate::motion::Setting;
use crate::motion::{Operations, Transition};
use crate::program::{
    Clearance, Compensation, Coolant, CutterSide, Dwell, Event, Feed, Location, Move, Rotation, Spindle, ToolCall,
};

/// Items are read ahead up to this many, so that a block can be sought among them.
const AHEAD: usize = 64;

/// Points of CL data are rounded: a line is square to the tool within this height, mm, or half a unit of coarser words.
const SQUARE: f64 = 5e-4;

/// The state that belongs to a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wanted {
    pub(super) tool: Option<u32>,
    /// Where it is called.
    pub(super) called: Option<Location>,
    /// Register of its length.
    pub(super) register: u32,
    /// Gauge length, mm.
    pub(super) length: Option<f64>,
    /// Speed and sense; `None`: it does not turn, or nobody asks for it.
    pub(super) spindle: Option<(f64, Rotation)>,
    /// Bits as the reader has them.
    pub(super) coolant: u8,
    /// Number of the frame.
    pub(super) frame: u32,
    pub(super) side: Side,
    /// Register of the tool's radius, where a control has them apart from tools.
    pub(super) radius: u32,
    /// How far chords may leave the path, mm.
    pub(super) tolerance: f64,
    /// Geometry that the tool leaves before it turns.
    pub(super) clearance: Option<Clearance>,
}

/// A motion of the CL data.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    pub(super) to: Placed,
    pub(super) shape: Shape,
    pub(super) rapid: bool,
    pub(super) feed: Option<Feed>,
    /// It begins an operation: the safe sequence leads to it.
    pub(super) starts: bool,
}

/// One thing that the CL data asks for.
#[derive(Debug, Clone)]
pub(super) struct Item {
    pub(super) at: Location,
    pub(super) wanted: Wanted,
    /// The hole that it belongs to, which a cycle of the control may make.
    pub(super) hole: Option<hole::Wanted>,
    /// What the last SPINDL before it asks for, if it stands behind a motion of its operation.
    standing: Option<(f64, Rotation)>,
    pub(super) kind: Kind,
}

/// What it is.
#[derive(Debug, Clone)]
pub(super) enum Kind {
    Motion(Motion),
    Stop {
        optional: bool,
    },
    /// Seconds.
    Dwell(f64),
    /// A block as it stands.
    Raw(Vec<u8>),
    Home,
}

/// The items of a program.
pub(super) struct Expect<'a, R> {
    reader: cl::ClReader<R>,
    setting: Setting,
    follow: Follow<'a>,
    queue: VecDeque<Item>,
    ended: bool,
}

/// What is modal in the CL data, and where items go.
struct Follow<'a> {
    config: &'a Config,
    family: Family,
    /// Rotary axes in the head.
    head: bool,
    /// One unit of linear words, mm.
    unit: f64,
    wanted: Wanted,
    calls: BTreeMap<u32, ToolCall>,
    request: (Option<f64>, Option<Rotation>),
    spindle_off: bool,
    /// What the last SPINDL behind a motion of its operation asks for.
    standing: Option<(f64, Rotation)>,
    /// What SPINDL said since the operation before ended.
    in_start: ((Option<f64>, Option<Rotation>), bool),
    coolant: Coolant,
    /// Nothing has moved since the operation began.
    start: bool,
    /// Where the machine stands is known.
    there: bool,
    /// A tool record stands in this start.
    called: bool,
    changed: bool,
    here: Option<Pose>,
    /// What CUTCOM asked for: it begins with a line square to the tool, and ends with the next motion.
    side: Side,
    /// The side that it asked for last, and the register that it named with it.
    last_side: Side,
    named_radius: Option<u32>,
    operation: u64,
    /// The operation that begins bears the name that was asked for.
    named: bool,
    reached: bool,
    fresh_arc: bool,
    /// The hole that is being unfolded, and how many there were.
    hole: Option<hole::Wanted>,
    holes: u64,
    out: VecDeque<Item>,
}

impl<'a, R: Read> Expect<'a, R> {
    /// `unit`: one unit of linear words, mm.
    pub(super) fn new(
        machine: &dyn AnyMachine,
        reader: cl::ClReader<R>,
        config: &'a Config,
        family: Family,
        unit: f64,
    ) -> Self {
        let rotary = |axis: &crate::kinematics::Axis| axis.kind == AxisKind::Rotary && !axis.held;
        let head = machine.axes().iter().any(|axis| rotary(axis) && axis.side == ChainSide::Tool);
        Self {
            reader,
            setting: Setting::new(config.policy()),
            follow: Follow::new(config, family, head, unit),
            queue: VecDeque::new(),
            ended: false,
        }
    }

    /// The item that comes next, and what is known behind it.
    pub(super) fn ahead(&mut self) -> io::Result<&VecDeque<Item>> {
        while self.queue.len() < AHEAD && !self.ended {
            self.read()?;
        }
        Ok(&self.queue)
    }

    /// Whether the first `count` items are there, or all that there are.
    pub(super) fn fill(&mut self, count: usize) -> io::Result<()> {
        while self.queue.len() < count && !self.ended {
            self.read()?;
        }
        Ok(())
    }

    pub(super) fn get(&self, index: usize) -> Option<&Item> {
        self.queue.get(index)
    }

    /// Asks for an item that has been taken once more.
    pub(super) fn push_front(&mut self, item: Item) {
        self.queue.push_front(item);
    }

    pub(super) fn pop(&mut self) -> Option<Item> {
        self.queue.pop_front()
    }

    /// What the last SPINDL that is to be written asks for, before what comes next.
    pub(super) fn standing(&self) -> Option<(f64, Rotation)> {
        self.queue.front().map_or(self.follow.standing, |item| item.standing)
    }

    /// The first thing that the reader could not take.
    pub(super) fn fault(&self) -> Option<Diagnostic> {
        let errors = self.reader.diagnostics().iter().filter(|found| found.severity == Severity::Error);
        errors.min_by_key(|found| found.location).cloned()
    }

    fn read(&mut self) -> io::Result<()> {
        let Some((at, event)) = self.reader.next_event()? else {
            self.ended = true;
            return Ok(());
        };
        let turned = self.setting.event(&event);
        let event = turned.as_ref().unwrap_or(&event);
        self.follow.event(at, event);
        self.queue.append(&mut self.follow.out);
        Ok(())
    }
}

impl<'a> Follow<'a> {
    fn new(config: &'a Config, family: Family, head: bool, unit: f64) -> Self {
        let wanted = Wanted {
            tool: None,
            called: None,
            register: 0,
            length: None,
            spindle: None,
            coolant: 0,
            frame: 1,
            side: Side::None,
            radius: 0,
            tolerance: config.motion.tolerance_mm,
            clearance: config.motion.retract.clearance,
        };
        Self {
            config,
            family,
            head,
            unit,
            wanted,
            calls: BTreeMap::new(),
            request: (None, None),
            spindle_off: false,
            standing: None,
            in_start: ((None, None), false),
            coolant: Coolant::Off,
            start: true,
            there: false,
            called: false,
            changed: false,
            here: None,
            side: Side::None,
            last_side: Side::None,
            named_radius: None,
            operation: 0,
            named: false,
            reached: false,
            fresh_arc: true,
            hole: None,
            holes: 0,
            out: VecDeque::new(),
        }
    }

    fn event(&mut self, at: Location, event: &Event<'_>) {
        match *event {
            Event::Arc(arc) => {
                self.arm();
                let motion = Move { pose: arc.start, rapid: false, feed: arc.feed };
                if self.fresh_arc {
                    self.line(at, &motion);
                }
                let end = Move { pose: arc.end, rapid: false, feed: arc.feed };
                self.motion(at, &end, Shape::Arc(Round::of(&arc)));
            }
            Event::Spline(spline) => {
                self.arm();
                let pose = |tip| Pose { tip, axis: spline.axis };
                let (Some(first), Some(last)) = (spline.points.first(), spline.points.last()) else { return };
                if self.fresh_arc {
                    self.line(at, &Move { pose: pose(*first), rapid: false, feed: spline.feed });
                }
                for span in 3..spline.points.len() {
                    if spline.knots[span] < spline.knots[span + 1] {
                        let piece = bezier(spline.knots, spline.points, span);
                        let end = if span + 1 < spline.points.len() { piece[3].into() } else { *last };
                        self.motion(
                            at,
                            &Move { pose: pose(end), rapid: false, feed: spline.feed },
                            Shape::Cubic(piece),
                        );
                    }
                }
            }
            Event::Hole(hole) => {
                self.arm();
                self.holes += 1;
                self.hole = Some(hole::Wanted { number: self.holes, hole });
                let here = self.here.filter(|_| !self.start);
                for step in unfolded(&hole, here.as_ref(), self.config.motion.defaults.peck_gap_mm) {
                    match step {
                        Step::Go(motion) => self.line(at, &motion),
                        Step::Wait(dwell) => self.delay(at, dwell),
                    }
                }
                self.hole = None;
            }
            Event::Tolerance(stated) => {
                let stated = stated
                    .filter(|stated| self.config.motion.allow_lintol || *stated <= self.config.motion.tolerance_mm);
                self.wanted.tolerance = stated.unwrap_or(self.config.motion.tolerance_mm);
            }
            Event::Move(_)
            | Event::Operation(_)
            | Event::SafeSequence
            | Event::Frame(_)
            | Event::Tool(_)
            | Event::Spindle(_)
            | Event::Coolant(_)
            | Event::Compensation(_)
            | Event::From(_)
            | Event::Name(_)
            | Event::MachineName(_)
            | Event::Preselect(_)
            | Event::Home
            | Event::ClearancePlane(_)
            | Event::RotaryDirection(_)
            | Event::Delay(_)
            | Event::OptionalStop
            | Event::Stop
            | Event::Message(_)
            | Event::Insert(_)
            | Event::Code { .. } => self.plain(at, event),
        }
    }

    /// An event that needs no unfolding.
    fn plain(&mut self, at: Location, event: &Event<'_>) {
        match *event {
            Event::Move(motion) => self.line(at, &motion),
            Event::Operation(name) => {
                self.begin();
                if let Some(Operations::From(wanted)) = &self.config.motion.operations {
                    let name = String::from_utf8_lossy(name);
                    self.named |= name.trim().eq_ignore_ascii_case(wanted.trim());
                }
            }
            Event::Tool(call) => self.tool(Some(at), &call),
            Event::Spindle(spindle) => {
                take(&mut self.request, &mut self.spindle_off, spindle);
                if !self.start {
                    self.standing = self.spindle();
                } else {
                    take(&mut self.in_start.0, &mut self.in_start.1, spindle);
                }
            }
            Event::Coolant(coolant) => self.coolant = coolant,
            Event::Compensation(compensation) => self.compensate(compensation),
            Event::From(pose) if self.start => self.here = Some(pose),
            Event::ClearancePlane(plane) => self.wanted.clearance = Some(Clearance::Plane(plane)),
            Event::Delay(dwell) => self.delay(at, dwell),
            Event::Stop => self.interrupt(at, Kind::Stop { optional: false }),
            Event::OptionalStop => self.interrupt(at, Kind::Stop { optional: true }),
            Event::Home => self.interrupt(at, Kind::Home),
            Event::Insert(text) => self.interrupt(at, Kind::Raw(text.to_vec())),
            Event::Code { letter, number } => {
                self.interrupt(at, Kind::Raw(format!("{}{number}", char::from(letter)).into_bytes()));
            }
            Event::SafeSequence => {
                self.begin();
                self.there = false;
            }
            Event::Frame(number) => {
                self.begin();
                self.there = false;
                self.wanted.frame = number;
                self.wanted.clearance = self.config.motion.retract.clearance;
            }
            // Nothing of a program follows from these, or they have been unfolded.
            Event::From(_)
            | Event::Name(_)
            | Event::MachineName(_)
            | Event::Preselect(_)
            | Event::RotaryDirection(_)
            | Event::Message(_)
            | Event::Arc(_)
            | Event::Spline(_)
            | Event::Hole(_)
            | Event::Tolerance(_) => {}
        }
    }

    /// CUTCOM: ON takes side and register that were given last.
    fn compensate(&mut self, asked: Compensation) {
        let Compensation { side, register, .. } = asked;
        self.side = match side {
            CutterSide::Off => return self.side = Side::None,
            CutterSide::Left => Side::Left,
            CutterSide::Right => Side::Right,
            CutterSide::On => self.last_side,
        };
        self.last_side = self.side;
        self.named_radius = register.or(self.named_radius.filter(|_| side == CutterSide::On));
        let tool = self.wanted.tool.unwrap_or(0);
        let given = self.config.set_up.tools.get(&tool).and_then(|tool| tool.radius_offset);
        self.wanted.radius = given.or(self.named_radius).unwrap_or(tool);
    }

    /// What follows is a new operation.
    fn begin(&mut self) {
        if !self.start {
            self.in_start = ((None, None), false);
        }
        self.start = true;
        self.fresh_arc = true;
    }

    /// Behind it nobody knows where the machine stands.
    fn interrupt(&mut self, at: Location, kind: Kind) {
        self.begin();
        self.there = false;
        self.push(at, kind);
    }

    fn tool(&mut self, at: Option<Location>, call: &ToolCall) {
        self.begin();
        self.there = false;
        let before = self.calls.get(&call.number).copied().unwrap_or_default();
        let given = self.config.set_up.tools.get(&call.number);
        let (length, offset) = (call.length_mm.or(before.length_mm), call.length_offset.or(before.length_offset));
        self.calls.insert(call.number, ToolCall { length_mm: length, length_offset: offset, ..*call });
        if self.wanted.tool != Some(call.number) {
            self.wanted.called = at;
            (self.request, self.spindle_off) = if self.called { ((None, None), false) } else { self.in_start };
            self.changed = true;
        }
        self.called = true;
        self.wanted.tool = Some(call.number);
        self.wanted.length = given.and_then(|tool| tool.length_mm).or(length);
        let offset = given.and_then(|tool| tool.offset).or(offset);
        self.wanted.register = match self.family {
            Family::LinuxCnc | Family::Fanuc | Family::Haas => offset.unwrap_or(call.number),
            // Edges count from 1 in each tool; CL data that counts them like the tools means none of them.
            Family::Siemens => offset.filter(|offset| *offset != call.number).unwrap_or(1),
            Family::Heidenhain => call.number,
        };
    }

    /// The tool of the configuration, where the CL data calls none.
    fn arm(&mut self) {
        if self.wanted.tool.is_none()
            && let Some(number) = self.config.motion.defaults.tool
        {
            self.tool(None, &ToolCall { number, ..ToolCall::default() });
        }
    }

    fn line(&mut self, at: Location, motion: &Move) {
        self.arm();
        if self.side == Side::None || self.runs_square(motion) {
            self.wanted.side = self.side;
        }
        self.motion(at, motion, Shape::Line);
    }

    /// A feed motion square to the tool, from where it is known to stand.
    fn runs_square(&self, motion: &Move) -> bool {
        let Some(here) = self.here.filter(|_| !self.start && !motion.rapid) else { return false };
        let step = motion.pose.tip - here.tip;
        let along = step.dot(&motion.pose.axis);
        along.abs() <= SQUARE.max(0.5 * self.unit) && (step.norm_squared() - along * along).sqrt() >= self.unit
    }

    fn motion(&mut self, at: Location, motion: &Move, shape: Shape) {
        self.fresh_arc = false;
        self.here = Some(motion.pose);
        // Before the first tool no length is in force, and nothing is moved.
        if self.start && self.wanted.tool.is_none() && motion.rapid && !self.head {
            return;
        }
        let direct = self.config.motion.rapids.transition == Transition::Direct && self.there && !self.changed;
        let starts = self.start && !direct;
        if self.start {
            self.operation += 1;
            self.reached |= self.named;
            self.start = false;
            self.called = false;
            self.changed = false;
        }
        self.there = true;
        self.wanted.spindle = self.spindle();
        self.wanted.coolant = self.coolant_bits();
        let motion = Motion { to: placed(&motion.pose), shape, rapid: motion.rapid, feed: motion.feed, starts };
        self.push(at, Kind::Motion(motion));
    }

    fn spindle(&self) -> Option<(f64, Rotation)> {
        if self.spindle_off {
            return None;
        }
        let given = self.wanted.tool.and_then(|tool| self.config.set_up.tools.get(&tool));
        let defaults = &self.config.motion.defaults;
        let speed = self.request.0.or(given.and_then(|tool| tool.speed_rev_per_min)).or(defaults.speed_rev_per_min)?;
        let sense = self.request.1.or(given.and_then(|tool| tool.rotation)).or(defaults.rotation)?;
        let scale = 10_f64.powi(self.config.formats.speed as i32);
        Some(((speed * scale).round() / scale, sense))
    }

    fn coolant_bits(&self) -> u8 {
        if self.config.motion.lift_mm.is_some() {
            return 0;
        }
        let given = self.wanted.tool.and_then(|tool| self.config.set_up.tools.get(&tool));
        let kind = match self.coolant {
            Coolant::On => given.and_then(|tool| tool.coolant).unwrap_or(self.config.motion.defaults.coolant),
            kind => kind,
        };
        match kind {
            Coolant::On | Coolant::Flood => coolant::FLOOD,
            Coolant::Mist => coolant::MIST,
            Coolant::Through => coolant::THROUGH,
            Coolant::Air => coolant::AIR,
            Coolant::Off => 0,
        }
    }

    fn delay(&mut self, at: Location, dwell: Dwell) {
        let seconds = match dwell {
            Dwell::Seconds(seconds) => seconds,
            Dwell::Revolutions(turns) => self.spindle().map_or(f64::NAN, |(speed, _)| turns / speed * 60.0),
        };
        if seconds > 0.0 {
            self.push(at, Kind::Dwell(seconds));
        }
    }

    fn push(&mut self, at: Location, kind: Kind) {
        let shown = match &self.config.motion.operations {
            None => true,
            Some(Operations::Range(first, last)) => {
                let number = self.operation.max(1);
                number >= *first && last.is_none_or(|last| number <= last)
            }
            Some(Operations::From(_)) => self.reached,
        };
        if shown {
            self.out.push_back(Item { at, wanted: self.wanted, hole: self.hole, standing: self.standing, kind });
        }
    }
}

/// Takes what a SPINDL says; what it leaves out stays.
fn take(request: &mut (Option<f64>, Option<Rotation>), off: &mut bool, spindle: Spindle) {
    *off = spindle == Spindle::Off;
    if let Spindle::On { speed_rev_per_min: speed, rotation } = spindle {
        *request = (speed.or(request.0), rotation.or(request.1));
    }
}
