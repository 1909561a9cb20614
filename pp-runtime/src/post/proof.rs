//! The proof program: a program that shows at the machine whether the declared kinematics are right, before anything is
//! cut.
//!
//! The tip stays on one point while each rotary axis runs through its travel. Planned and written as every program is;
//! its head has how to run it and what an indicator must show. With axis positions the linear axes follow the
//! declaration: an indicator shows whether it is the machine. Under tip control the control moves them by its own data:
//! the same indicator shows whether these are the machine, and so, with both programs, whether control and declaration
//! agree.

use std::io;

use nalgebra::{Point3, Vector3};

use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::Diagnostic;
use crate::kinematics::{AnyMachine, AxisKind, Limits, Side};
use crate::motion::StretchModes;
use crate::motion::{Planner, PlanningError, ProofProgram, Sweep, rotaries_of};
use crate::options::{Mode, OperationTable};
use crate::program::ToolCall;
use crate::program::Units;

use super::Job;
use super::header::{Header, work_offset};
use super::line_map::MappedEncoder;
use super::survey::{Survey, ToolUse};

/// Largest speed of a rotary axis in a proof program, rad/min: slow enough to read the indicator.
const MAX_ROTARY_SPEED_RAD_PER_MIN: f64 = 360_f64.to_radians();

/// Cosine from which a rotary axis stands upright.
const UPRIGHT: f64 = 0.99;

/// A proof program to be written: set-up, control, tool and point.
#[derive(Clone, Copy)]
pub(crate) struct Proof<'a> {
    /// The set-up.
    pub config: &'a Config,
    /// The control that will run the program.
    pub control: &'a dyn Control,
    /// Tool in the spindle; `None`: the tool of the configuration.
    pub tool: Option<u32>,
    /// Point of the part at which the tip is held, mm; `None`: the part zero.
    pub point_mm: Option<[f64; 3]>,
}

/// Writes the proof program of a machine.
///
/// # Errors
/// A sentence that names what is missing in the set-up, or the position that cannot be reached; and what would do: a
/// point near, or less travel of the rotary axes.
pub(crate) fn prove(machine: &dyn AnyMachine, proof: &Proof<'_>) -> Result<Vec<u8>, String> {
    prove_at(machine, proof).map_err(|reason| {
        let remedy = std::iter::once(None).chain(CAPS_DEG.map(Some)).find_map(|cap| remedy(machine, proof, cap));
        remedy.map_or_else(|| reason.clone(), |remedy| format!("{reason}; {remedy} would do"))
    })
}

/// Travels of the rotary axes that are tried where a proof program cannot be written, to both sides, degrees.
const CAPS_DEG: [f64; 6] = [90.0, 60.0, 45.0, 30.0, 20.0, 10.0];

/// A point above or beside that of a proof program at which the program can be written, in words, with less travel of
/// the rotary axes where that is given, degrees.
fn remedy(machine: &dyn AnyMachine, proof: &Proof<'_>, cap_deg: Option<f64>) -> Option<String> {
    let mut config = proof.config.clone();
    let mut keys = Vec::new();
    for axis in machine.axes().iter().filter(|axis| axis.kind == AxisKind::Rotary && !axis.held) {
        let (Some(cap_deg), travel) = (cap_deg, config.set_up.limits.get(&axis.letter).copied().unwrap_or(axis.limits))
        else {
            break;
        };
        let cap = cap_deg.to_radians();
        let capped = travel.map_or(Limits { lower: -cap, upper: cap }, |travel| Limits {
            lower: travel.lower.max(-cap),
            upper: travel.upper.min(cap),
        });
        if capped.lower < capped.upper {
            let [lower, upper] = [capped.lower, capped.upper].map(|end| end.to_degrees().round());
            keys.push(format!("{} = [{lower}, {upper}]", axis.letter));
            config.set_up.limits.insert(axis.letter, Some(capped));
        }
    }
    let proof = Proof { config: &config, ..*proof };
    let from = Vector3::from(proof.point_mm.unwrap_or_default());
    let up = machine.up().into_inner();
    let aside = [Vector3::x(), Vector3::y(), Vector3::z()].into_iter().filter(|side| side.dot(&up).abs() < 0.5);
    let aside: Vec<Vector3<f64>> =
        aside.flat_map(|side| [25.0, -25.0, 50.0, -50.0, 100.0, -100.0, 200.0, -200.0].map(|mm| side * mm)).collect();
    let heights = [0.0, 25.0, 50.0, 100.0, 150.0, 200.0, 300.0, 400.0];
    let mut points = std::iter::once(Vector3::zeros())
        .chain(aside)
        .flat_map(|place| heights.map(|mm| <[f64; 3]>::from(from + place + up * mm)));
    let [x, y, z] = points.find(|point| prove_at(machine, &Proof { point_mm: Some(*point), ..proof }).is_ok())?;
    let limits = if keys.is_empty() { String::new() } else { format!("`limits = {{ {} }}` and ", keys.join(", ")) };
    Some(format!("{limits}--point {x},{y},{z}"))
}

fn prove_at(machine: &dyn AnyMachine, proof: &Proof<'_>) -> Result<Vec<u8>, String> {
    let given = proof.config;
    let table = rotaries_of(machine.axes(), Side::Workpiece).next().is_some();
    if proof.point_mm.is_none() && table && !given.is_given("part_origin") {
        return Err(
            "the tip would be on the table, at its reference point: set `part_origin` in the configuration, or give a \
                    point above the table (--point 60,0,120)"
                .to_owned(),
        );
    }
    // A dry run with a distance of 0: no spindle, no coolant. Axis positions, because the declaration of the machine is
    // to be shown; tip control where the configuration has it, because the data of the control is.
    let mode = match given.motion.mode {
        Mode::Tcp => Mode::Tcp,
        Mode::Auto | Mode::Axes | Mode::Plane => Mode::Axes,
    };
    let slow = given.motion.rapids.reorient_rad_per_min.min(MAX_ROTARY_SPEED_RAD_PER_MIN);
    let mut config = given.for_control(proof.control);
    config.motion.lift_mm = Some(0.0);
    config.motion.mode = mode;
    config.motion.operations = OperationTable::default();
    // Nothing is cut: there is no contour whose radius a guard would compare.
    config.motion.compensation = None;
    config.motion.rapids.reorient_rad_per_min = slow;
    let unfit = config.unfit(machine, proof.control);
    if !unfit.is_empty() {
        return Err(unfit.join("\n"));
    }
    let units = config.output_units.unwrap_or(Units::Millimetres);
    let machine = config
        .set_up
        .machine_for(machine)
        .map_err(|invalid| format!("the dimensions of {} are not valid: {invalid}", machine.name()))?;
    let abilities = control::abilities(proof.control, config.demands());
    let mut out = Vec::new();
    let modes = StretchModes::all(mode.of_all().unwrap_or_default());
    let layout = Layout::new(&*machine, config.demands(), &abilities, &modes, units, b"PROOF");
    let mapped = MappedEncoder::new(Encoder::new(proof.control, &layout, &mut out), None);
    let mut planner = Planner::new(machine.clone(), config.policy(), units, &abilities, false, mapped);
    let sweeps = ProofProgram::new(&mut planner).sweeps().map_err(sentence)?;

    let number = proof.tool.unwrap_or_else(|| default_tool(&config));
    let point = Point3::from(proof.point_mm.unwrap_or_default());
    let length = config.set_up.tools.get(&number).and_then(|tool| tool.length_mm);
    // The face of the table is horizontal with its axes at zero, and rotates with it.
    let (rotation, up) = (config.set_up.part_rotation, machine.up());
    let height_mm = (Vector3::from(config.set_up.part_origin) + rotation * point.coords).dot(&up);
    // A chuck, whose axis lies, has no such face.
    let face = rotaries_of(machine.axes(), Side::Workpiece)
        .next()
        .is_some_and(|first| machine.joint(first).direction.dot(&up).abs() > UPRIGHT);
    if face && height_mm <= 0.0 {
        return Err(format!(
            "the tip would be {height_mm:.1} mm above the face of the table: give a point above it (--point)"
        ));
    }
    let lowest = length.filter(|_| face).map(|length| {
        let proof = ProofProgram::new(&mut planner);
        let heights = proof.tool_axes(&sweeps).map(|axis| height_mm + length * (rotation * axis.into_inner()).dot(&up));
        heights.fold(height_mm, f64::min)
    });
    if let Some(lowest) = lowest.filter(|lowest| *lowest <= 0.0) {
        return Err(format!(
            "the gauge line of the spindle would come down to {lowest:.1} mm above the face of the table: give a higher point \
             (--point), another tool (--tool), or less travel of the tilting axis in `[limits]`"
        ));
    }
    let job = Job { cl_name: "", config: &config, control: proof.control, units: None };
    let survey = survey(number, &point, modes);
    let header = Header { job: &job, survey: &survey, units, machine: &*machine, unchecked: planner.unchecked_axes() };
    head(&header, &point, &sweeps, Clear { table, lowest }, planner.sink().encoder())
        .map_err(|error| sentence(PlanningError::Output(error)))?;
    ProofProgram::new(&mut planner).plan(number, point, &sweeps).map_err(sentence)?;
    let encoder = planner.sink().encoder();
    encoder.end(&[]).and_then(|()| encoder.finish()).map_err(|error| sentence(PlanningError::Output(error)))?;
    drop(planner);
    Ok(out)
}

/// The reason why the program cannot be planned or written, as one sentence.
fn sentence(stop: PlanningError) -> String {
    match stop {
        PlanningError::Output(error) => error.to_string(),
        PlanningError::Fault(Diagnostic { text, help: Some(help), .. }) => format!("{text}: {help}"),
        PlanningError::Fault(Diagnostic { text, .. }) => text,
    }
}

/// The default tool of the configuration, else the first tool of its tool list, else 1.
fn default_tool(config: &Config) -> u32 {
    config.motion.defaults.tool.or_else(|| config.set_up.tools.keys().next().copied()).unwrap_or(1)
}

/// A survey of one tool with one operation, for the header. `point`: position of the tip in the part, mm.
fn survey(number: u32, point: &Point3<f64>, modes: StretchModes) -> Survey {
    let call = ToolCall { number, ..ToolCall::default() };
    let tool =
        ToolUse { call, operations: 1, tip_z_mm: Some((point.z, point.z)), cuts_mm: None, spindle_assumed: false };
    let mut survey = Survey { modes, ..Survey::default() };
    survey.tools.push(tool);
    survey
}

/// How far the spindle comes down to a table that rotates.
#[derive(Clone, Copy)]
struct Clear {
    /// There is such a table.
    table: bool,
    /// Lowest height of tip and gauge line above its face, mm; `None`: the length of the tool is unknown, or it has no
    /// face.
    lowest: Option<f64>,
}

/// Writes the head of the program. `point`: position of the tip in the part, mm.
fn head(
    header: &Header<'_>,
    point: &Point3<f64>,
    sweeps: &[Sweep],
    clear: Clear,
    encoder: &mut Encoder<'_>,
) -> io::Result<()> {
    encoder.open(None)?;
    let (config, control) = (header.job.config, header.job.control);
    let mode = config.motion.mode;
    let (moves, wrong): (&str, &[&str]) = match mode {
        Mode::Tcp => (
            "TIP CONTROL IS ON: the control moves the linear axes, by its own data of the machine",
            &[
                "a small movement means that a length in the control is off, a large one that a direction is",
                "the program in mode axes shows the declaration: if both pass, control and declaration agree",
            ],
        ),
        Mode::Auto | Mode::Axes | Mode::Plane => (
            "TIP CONTROL IS OFF: the program moves the linear axes, by the declaration of the machine",
            &["a small movement means that a pivot or a length is off, a large one that a sign is wrong"],
        ),
    };
    let mut lines = vec![
        "PROOF OF THE KINEMATICS: no cutting, spindle off".to_owned(),
        format!("MACHINE {}, CONTROL {}, MODE {}", header.machine.name(), control.spellings().title, mode.name()),
        moves.to_owned(),
        format!("UNITS {}, WORK OFFSET {}", header.units.name(), work_offset(control, config)),
        format!("PART ORIGIN {} from the reference point of the table", header.point(config.set_up.part_origin)),
        format!("THE TIP STAYS AT {} of the part while the rotary axes move", header.point((*point).into())),
        "EXPECTED: an indicator that is fixed to the table and touches a ball at the tip does not move".to_owned(),
        "the tip is the CENTRE of the ball: the length of the tool is that to it".to_owned(),
        "touch the ball along X, then Y, then Z of the table, and run the program once for each".to_owned(),
    ];
    lines.extend(wrong.iter().map(|line| (*line).to_owned()));
    if clear.table {
        lines.push("EMPTY TABLE: no part and no clamps but the indicator, Z up before the start".to_owned());
        lines.push(match clear.lowest {
            Some(lowest) => format!(
                "tip and gauge line come down to {} above the face of the table, with its nose lower still: the spindle must be clear there",
                header.length(lowest)
            ),
            None => "find out how far the spindle comes down to the table, or to what it has in place of a face".to_owned(),
        });
    }
    lines.push("first run: without the indicator, at low feed override, ready to press feed hold".to_owned());
    let number = |index: usize, sweep: &Sweep| format!("SWEEP {}: {}", index + 1, sweep.name);
    lines.extend(sweeps.iter().enumerate().map(|(index, sweep)| number(index, sweep)));
    let within = header.length(config.motion.tolerance_mm);
    lines.extend(
        header.machine_lines(Some(format!("WHILE A ROTARY AXIS MOVES the tip stays within {within} of its point"))),
    );
    lines.iter().try_for_each(|line| encoder.comment(line.as_bytes()))?;
    encoder.start()
}
