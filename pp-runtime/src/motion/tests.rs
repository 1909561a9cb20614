//! The planner on the machines of the tests, written by the LinuxCNC table: one line is one block.

mod rotaries;
mod sequence;
mod state;
mod words;

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::config::Config;
use crate::control::{Control, Encoder, Layout, LinuxCnc};
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::machines::{Ay, Cb, Head, Xyw, Xyz};
use crate::kinematics::{AxisKind, Limits, Machine, Pose};
use crate::motion::{DiscardSteps, MovingAxes, Navigator, Planner, PlanningError, Sink, Source, Stage, Statistics};
use crate::options::{Rapid, Transition, Wrap};
use crate::program::Units;
use crate::program::{
    ClearancePlane, Compensation, Coolant, CutterSide, Dwell, Event, Feed, Interruption, Location, MachineFunction,
    Move, NewStart, Pressure, ReferenceGeometry, RotaryDirection, Rotation, Spindle, TextKind, ToolCall, ToolMotion,
};
use crate::set_up::GivenTool;

/// Result of a run.
pub(super) struct Run {
    pub(super) lines: Vec<String>,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) statistics: Statistics,
}

impl Run {
    pub(super) fn error(&self) -> &Diagnostic {
        self.diagnostics.iter().find(|found| found.severity == Severity::Error).expect("an error")
    }

    fn text(&self) -> String {
        self.lines.join("\n")
    }
}

/// Posts events for LinuxCNC; the event at position `n` is in line `n + 1`.
pub(super) fn run<M: Machine>(config: &Config, events: &[Event<'_>]) -> Run {
    let units = config.output_units.unwrap_or(Units::Millimetres);
    let layout = Layout::new(
        &M::default(),
        config.demands(),
        &crate::control::abilities(&LinuxCnc, config.demands()),
        &crate::motion::StretchModes::all(config.motion.mode.of_all().unwrap_or_default()),
        units,
        b"",
    );
    let mut out = Vec::new();
    let mut encoder = Encoder::new(&LinuxCnc, &layout, &mut out);
    let (diagnostics, statistics) = plan::<M>(&LinuxCnc, config, events, &mut encoder);
    encoder.finish().expect("memory takes everything");
    drop(encoder);
    let text = String::from_utf8(out).expect("ASCII");
    Run { lines: text.lines().map(str::to_owned).collect(), diagnostics, statistics }
}

/// Plans events for a control.
pub(super) fn plan<M: Machine>(
    control: &dyn Control,
    config: &Config,
    events: &[Event<'_>],
    sink: &mut impl Sink,
) -> (Vec<Diagnostic>, Statistics) {
    let machine = config.set_up.machine::<M>().expect("valid");
    let units = config.output_units.unwrap_or(Units::Millimetres);
    let abilities = crate::control::abilities(control, config.demands());
    let mut navigator = Navigator::new(Box::new(machine.clone()), config.policy());
    hand_on::<M, _>(config, events, &mut navigator).expect("a navigator refuses nothing");
    let course = navigator.finish();
    let policy = config.policy();
    let mut moving = MovingAxes::default();
    if !config.motion.rotaries.clamp.is_empty() {
        let mut planner = Planner::new(Box::new(machine.clone()), policy, units, &abilities, false, DiscardSteps);
        planner = planner.with_course(course.clone());
        hand_on::<M, _>(config, events, &mut planner).expect("a rehearsal");
        planner.finish(Location::default()).expect("a rehearsal");
        moving = planner.rehearsed();
    }
    let planner = Planner::new(Box::new(machine), policy, units, &abilities, false, sink).with_course(course);
    let mut planner = planner.with_clamps(moving);
    let at = Location { line: events.len() as u64, column: 1 };
    let planned = hand_on::<M, _>(config, events, &mut planner).and_then(|()| planner.finish(at));
    let mut diagnostics = planner.take_warnings();
    match planned {
        Ok(()) => {}
        Err(PlanningError::Fault(fault)) => diagnostics.push(fault),
        Err(PlanningError::Output(error)) => panic!("{error}"),
    }
    (diagnostics, planner.statistics())
}

/// Passes the items of events to a stage; the event at position `n` is in line `n + 1`.
pub(super) fn hand_on<M: Machine, S: Stage>(
    config: &Config,
    events: &[Event<'_>],
    stage: &mut S,
) -> Result<(), S::Stop> {
    let mut source = Source::new(&M::default(), config.policy());
    for (index, event) in events.iter().enumerate() {
        source.event(Location { line: index as u64 + 1, column: 1 }, event, stage)?;
    }
    source.finish(stage)
}

/// Posts events that must pass without any remark.
fn lines<M: Machine>(config: &Config, events: &[Event<'_>]) -> Vec<String> {
    let run = run::<M>(config, events);
    assert_eq!(run.diagnostics, [], "{}", run.text());
    run.lines
}

pub(super) fn pose(tip: [f64; 3], axis: [f64; 3]) -> Pose {
    Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(Vector3::from(axis)) }
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Tool axis at `C` and `B` degrees on the C-B table.
fn cb(c: f64, b: f64) -> [f64; 3] {
    let ((sin_c, cos_c), (sin_b, cos_b)) = (c.to_radians().sin_cos(), b.to_radians().sin_cos());
    [sin_b * cos_c, sin_b * sin_c, cos_b]
}

pub(super) fn rapid(tip: [f64; 3], axis: [f64; 3]) -> Event<'static> {
    Event::Motion(ToolMotion::Move(Move { pose: pose(tip, axis), rapid: true, feed: None }))
}

pub(super) fn feed(tip: [f64; 3], axis: [f64; 3]) -> Event<'static> {
    Event::Motion(ToolMotion::Move(Move { pose: pose(tip, axis), rapid: false, feed: Some(Feed::PerMinute(500.0)) }))
}

pub(super) fn tool(number: u32) -> Event<'static> {
    Event::NewStart(NewStart::Tool(ToolCall { number, ..ToolCall::default() }))
}

pub(super) fn spindle() -> Event<'static> {
    Event::Function(MachineFunction::Spindle(Spindle::On {
        speed_rev_per_min: Some(8000.0),
        rotation: Some(Rotation::Clockwise),
    }))
}

pub(super) fn config() -> Config {
    let mut config = Config::default();
    // Its blocks are those of the control.
    config.motion.guards.offset_guard = false;
    config
}

fn with_lengths(distance: Option<f64>) -> Config {
    let mut config = config();
    for number in 1..=2 {
        config.set_up.tools.insert(number, GivenTool { length_mm: Some(100.0), ..GivenTool::default() });
    }
    config.motion.retract.distance_mm = distance;
    config
}

/// Minutes of the blocks in inverse time.
fn minutes(lines: &[String]) -> f64 {
    let word = |line: &String| line.rsplit_once(" F").map(|(_, word)| word.parse::<f64>().expect("a number"));
    let mut inverse = false;
    let mut sum = 0.0;
    for line in lines {
        inverse = (inverse || line.contains("G93")) && !line.contains("G94");
        sum += if inverse { word(line).map_or(0.0, |word| 1.0 / word) } else { 0.0 };
    }
    sum
}
