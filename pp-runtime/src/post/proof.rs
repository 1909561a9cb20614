//! The program that proves the kinematics at the machine, before anything is cut with it.
//!
//! Planned and written as every program is; what it is to show stands in its head.

use std::io::{self, Write};

use nalgebra::Point3;

use crate::config::Config;
use crate::control::{self, Control, Encoder, Layout};
use crate::diag::Diagnostic;
use crate::kinematics::{AnyMachine, AxisKind, Side};
use crate::motion::Mode;
use crate::motion::{Planner, PlanningError, ProofProgram, Sweep};
use crate::program::ToolCall;
use crate::program::Units;

use super::Job;
use super::header::{Header, work_offset};
use super::survey::{Survey, ToolUse};

/// Largest speed of a rotary axis in the proof, rad/min: an eye has to follow the indicator.
const SLOW: f64 = 360_f64.to_radians();

/// What is to be proven.
#[derive(Clone, Copy)]
pub struct Proof<'a> {
    /// The set-up.
    pub config: &'a Config,
    /// The control that is to read the program.
    pub control: &'a dyn Control,
    /// Tool in the spindle; that of the configuration if there is none.
    pub tool: Option<u32>,
    /// Where the tip stands in the part, mm; at the part zero if there is none.
    pub point: Option<[f64; 3]>,
}

/// Writes the proof program of a machine.
///
/// # Errors
/// A sentence about what is missing, or what cannot be reached.
pub fn prove(machine: &dyn AnyMachine, proof: &Proof<'_>) -> Result<Vec<u8>, String> {
    let given = proof.config;
    let table =
        machine.axes().iter().any(|axis| axis.kind == AxisKind::Rotary && !axis.held && axis.side == Side::Workpiece);
    if proof.point.is_none() && table && !given.is_given("part_origin") {
        return Err(
            "the tip would stand on the table, at its reference point: give `part_origin` in the configuration, \
                    or a point above the table, --point 60,0,120"
                .to_owned(),
        );
    }
    // A dry run that stays where it is: no spindle, no coolant. What is proven is the declaration of the machine, and not what
    // the control makes of tip control or a plane.
    let slow = given.motion.rapids.reorient_rad_per_min.min(SLOW);
    let mut config = given.clone();
    config.motion.lift_mm = Some(0.0);
    config.motion.mode = Mode::Axes;
    config.motion.rapids.reorient_rad_per_min = slow;
    let units = config.output_units.unwrap_or(Units::Millimetres);
    let machine = config
        .set_up
        .machine_for(machine)
        .map_err(|invalid| format!("{} cannot be built like this: {invalid}", machine.name()))?;
    let abilities = control::abilities(proof.control, config.demands());
    let mut out = Vec::new();
    let layout = Layout::new(&*machine, config.demands(), units, b"PROOF");
    let encoder = Encoder::new(proof.control, &layout, &mut out);
    let mut planner = Planner::new(machine.clone(), config.policy(), units, &abilities, false, encoder);
    let sweeps = ProofProgram::new(&mut planner).sweeps().map_err(told)?;

    let number = proof.tool.unwrap_or_else(|| usual_tool(&config));
    let point = Point3::from(proof.point.unwrap_or_default());
    let job = Job { cl_name: "", config: &config, control: proof.control, units: None };
    let survey = survey(number, &point);
    let header = Header { job: &job, survey: &survey, units, machine: &*machine, unchecked: planner.unchecked_axes() };
    head(&header, &point, &sweeps, planner.sink()).map_err(|error| told(PlanningError::Output(error)))?;
    ProofProgram::new(&mut planner).plan(number, point, &sweeps).map_err(told)?;
    let encoder = planner.sink();
    encoder.end(&[]).and_then(|()| encoder.finish()).map_err(|error| told(PlanningError::Output(error)))?;
    drop(planner);
    Ok(out)
}

/// Why there is no proof program.
fn told(stop: PlanningError) -> String {
    match stop {
        PlanningError::Output(error) => error.to_string(),
        PlanningError::Fault(Diagnostic { text, help: Some(help), .. }) => format!("{text}: {help}"),
        PlanningError::Fault(Diagnostic { text, .. }) => text,
    }
}

/// The tool of the configuration, if there is one, or the first of a magazine.
fn usual_tool(config: &Config) -> u32 {
    config.motion.defaults.tool.or_else(|| config.set_up.tools.keys().next().copied()).unwrap_or(1)
}

/// One tool that does one thing.
fn survey(number: u32, point: &Point3<f64>) -> Survey {
    let call = ToolCall { number, ..ToolCall::default() };
    let tool = ToolUse { call, operations: 1, tip: Some((point.z, point.z)), cuts: None, spindle_assumed: false };
    let mut survey = Survey::default();
    survey.tools.push(tool);
    survey
}

fn head<W: Write>(
    header: &Header<'_>,
    point: &Point3<f64>,
    sweeps: &[Sweep],
    encoder: &mut Encoder<'_, W>,
) -> io::Result<()> {
    encoder.open(None)?;
    let (config, control) = (header.job.config, header.job.control);
    let mut lines = vec![
        "PROOF OF THE KINEMATICS: nothing is cut, the spindle stands".to_owned(),
        format!("MACHINE {}, CONTROL {}, MODE axes", header.machine.name(), control.spellings().title),
        format!("UNITS {}, WORK OFFSET {}", header.units.name(), work_offset(control, config)),
        format!("PART ORIGIN {} from the table reference", header.point(config.set_up.part_origin)),
        format!("THE TIP STANDS AT {} of the part while the rotary axes turn", header.point((*point).into())),
        "WHAT MUST BE SEEN: an indicator that stands on the table and touches a ball at the tip stays still".to_owned(),
        "touch it along X, then Y, then Z of the table, and run the program for each".to_owned(),
        "a small drift means a pivot or a length that is off, a large one a sign".to_owned(),
        "before the first run: without the indicator, at low feed override, a hand at the stop".to_owned(),
    ];
    let number = |index: usize, sweep: &Sweep| format!("SWEEP {}: {}", index + 1, sweep.name);
    lines.extend(sweeps.iter().enumerate().map(|(index, sweep)| number(index, sweep)));
    let within = header.length(config.motion.tolerance_mm);
    lines.extend(
        header.machine_lines(Some(format!("WHILE A ROTARY AXIS MOVES the tip stays within {within} of its point"))),
    );
    lines.iter().try_for_each(|line| encoder.comment(line.as_bytes()))?;
    encoder.start()
}
