//! Programs posted for the suites of edits, and their check.

use std::fs;
use std::io::{self, Cursor};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use pp_runtime::check::check;
use pp_runtime::config::{Config, Mode, Operations, TcpFrame, starting_point};
use pp_runtime::control::Control;
use pp_runtime::diag::Severity;
use pp_runtime::kinematics::Machine;
use pp_runtime::post;

use super::verdict::ToolAxis;
use super::{Allowed, Subject};
use crate::by_name;
use crate::foreign::axes::is_rotary;
use crate::foreign::{self, Axes, Options, Trace, run};
use crate::oracle::Oracle;
use crate::with_machine;

/// Input of a posted program.
#[derive(Debug, Clone)]
pub struct Case<'a> {
    /// Name for messages.
    pub name: &'a str,
    /// Name of the machine.
    pub machine: &'a str,
    /// Name of the control.
    pub control: &'a str,
    /// Mode.
    pub mode: Mode,
    /// First and last operation; all without it.
    pub operations: Option<(u64, u64)>,
    /// Configuration file.
    pub config: &'a str,
    /// CL data.
    pub cl: &'a [u8],
    /// Codes of the shop that are blocks of their own.
    pub idle: &'a [&'a str],
}

/// A posted program with what its check needs.
pub struct Posted {
    /// The program.
    pub subject: Subject,
    /// Its text.
    pub text: String,
    /// How the careful interpreter reads it, and its trace; `None` if that interpreter refuses it.
    pub careful: Option<(Options, Trace)>,
    machine: String,
    control: &'static dyn Control,
    config: Config,
    set_up: String,
    cl: Vec<u8>,
}

impl Posted {
    /// Posts a case.
    ///
    /// # Errors
    /// The reason for which it cannot be posted, or is refused by the foreign interpreter.
    ///
    /// # Panics
    /// If the control does not exist.
    pub fn of(case: &Case<'_>) -> Result<Self, String> {
        let control = by_name::control(case.control);
        let (config, text) = with_machine!(case.machine, posted(case, control))?;
        let foreign = foreign::Control::by_name(case.control).expect("a control");
        let options = Options {
            plain_numbers: config.control.point == Some(false),
            gauge_line: case.config.contains("length_mode = \"gauge\""),
            rapids_at_feed: case.config.contains("rapid = \"feed\""),
            idle: case.idle.iter().map(|code| (*code).to_owned()).collect(),
            ..Options::of(foreign)
        };
        let tool_axis: ToolAxis = with_machine!(case.machine, tool_axis_of());
        let allowed = allowed(&config, foreign, case.config, &text, tool_axis);
        let subject = Subject::new(case.name.to_owned(), &text, options, allowed).map_err(|why| why.to_string())?;
        let careful = Options {
            pointed: config.control.point == Some(true),
            untidy: false,
            careless: false,
            ..subject.options.clone()
        };
        let careful = run(&text, &careful).map(|trace| (careful, trace)).ok();
        let (machine, set_up) = (case.machine.to_owned(), case.config.to_owned());
        Ok(Self { subject, text, careful, machine, control, config, set_up, cl: case.cl.to_vec() })
    }

    /// Writes CL data, configuration, and the program before and after an edit.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn write(&self, folder: &Path, edited: &str) -> io::Result<()> {
        fs::create_dir_all(folder)?;
        fs::write(folder.join("part.cls"), &self.cl)?;
        fs::write(folder.join("part.toml"), &self.set_up)?;
        fs::write(folder.join("posted.nc"), &self.text)?;
        fs::write(folder.join("edited.nc"), edited)
    }

    /// Findings of the check in a program that should do what this one does.
    #[must_use]
    pub fn findings(&self, program: &str) -> Vec<String> {
        let found = catch_unwind(AssertUnwindSafe(|| with_machine!(&*self.machine, findings(self, program))));
        found.unwrap_or_else(|_| vec!["PANIC".to_owned()])
    }
}

/// The one call of the check.
fn findings<M: Machine>(posted: &Posted, program: &str) -> Vec<String> {
    let policy = match posted.config.check_policy::<M>(posted.control, None) {
        Ok(policy) => policy,
        Err(error) => return vec![error.to_string()],
    };
    match check::<M>(&policy, Cursor::new(&posted.cl), program.as_bytes()) {
        Ok(checked) => {
            let found = |line: u64, text: &str| format!("line {line}: {text}");
            let findings = checked.outcome.findings.iter();
            let mut findings: Vec<String> =
                findings.map(|finding| found(finding.location.line, &finding.text)).collect();
            findings.extend(checked.fault.iter().map(|fault| found(fault.location.line, &fault.text)));
            if findings.is_empty() && !checked.outcome.passed() {
                findings.push("not passed, without a finding".to_owned());
            }
            findings
        }
        Err(error) => vec![error.to_string()],
    }
}

fn posted<M: Machine>(case: &Case<'_>, control: &'static dyn Control) -> Result<(Config, String), String> {
    let config = starting_point(control).read_over(&M::default(), case.config);
    let mut config = config.map_err(|faults| faults[0].text.clone())?;
    config.motion.mode = case.mode;
    config.given.insert("part_origin");
    if let Some((first, last)) = case.operations {
        config.motion.selected = Some(Operations::Range(first, Some(last)));
    }
    if let Some(fault) = config.unfit(&M::default(), control).into_iter().next() {
        return Err(fault);
    }
    let job = post::Job { cl_name: "part.cls", config: &config, control, units: None };
    let mut program = Vec::new();
    let report = post::post::<M>(&job, &mut Cursor::new(case.cl), &mut program).map_err(|error| error.to_string())?;
    if report.failed {
        let error = report.diagnostics.iter().find(|found| found.severity == Severity::Error);
        return Err(error.map_or_else(|| "refused".to_owned(), |error| error.text.clone()));
    }
    Ok((config, String::from_utf8(program).map_err(|error| error.to_string())?))
}

/// Twice the tolerance and the rounding: before an edit an axis may be off on one side, and after it on the other.
fn allowed(config: &Config, control: foreign::Control, set_up: &str, text: &str, tool_axis: ToolAxis) -> Allowed {
    let decimals = text.split([' ', '\n']).filter(|word| word.starts_with(['X', 'Y', 'Z']));
    let decimals = decimals.filter_map(|word| Some(word.split_once('.')?.1.len())).max().unwrap_or(3).min(6);
    let unit = 10_f64.powi(-(decimals as i32));
    let inches = text.contains("G20 ") || text.contains("G700 ") || text.contains(" INCH\n");
    let in_mm = if inches { 25.4 } else { 1.0 };
    let path = set_up.lines().find_map(|line| line.strip_prefix("axis_tolerance_path = ")?.parse().ok());
    let of_operations = config.motion.operations.entries.iter().filter_map(|entry| entry.settings.tolerance_mm);
    let tolerance_mm = of_operations.fold(config.motion.tolerance_mm, f64::max);
    Allowed {
        linear: 2.0 * tolerance_mm / in_mm + 4.0 * unit,
        unit,
        rotary_deg: 2.0 * path.unwrap_or(0.1_f64) + 0.05,
        wraps: set_up.contains("[wrap]"),
        signs_turn: set_up.contains("\"sign\""),
        tool_axis: (config.motion.tip.tcp_frame != Some(TcpFrame::NotTurning)).then_some(tool_axis),
        axis_speeds: set_up.contains("[speeds]"),
        starts_continuous: matches!(
            control,
            foreign::Control::Fanuc | foreign::Control::Haas | foreign::Control::Siemens
        ),
        clamped: ["M10", "M68"]
            .map(|on| config.motion.rotaries.clamp.iter().find(|(_, codes)| codes.on == on).map(|(letter, _)| *letter)),
    }
}

fn tool_axis_of<M: Machine>() -> ToolAxis {
    tool_axis::<M>
}

/// The tool axis that rotary axes give, the linear axes at zero.
fn tool_axis<M: Machine>(axes: &Axes) -> Option<[f64; 3]> {
    let value = |letter: char| {
        if is_rotary(letter) { axes.get(letter).map(f64::to_radians) } else { Some(0.0) }
    };
    let values: Option<Vec<f64>> = M::AXES.iter().map(|axis| value(axis.letter)).collect();
    let axis = Oracle::of(&M::default()).forward(&values?).axis;
    Some([axis.x, axis.y, axis.z])
}
