//! `simulate IN.cls [OUT.nc]`: the written program cuts a stock.
//!
//! Without OUT.nc the CL data is posted to a temporary file. The program is executed by the check's reader, in one pass and in
//! memory that does not grow with its length.

mod against_design;

use std::fs::File;
use std::io::{BufReader, Seek as _};
use std::path::Path;
use std::thread;

use serde::Serialize;

use crate::check::check_observed;
use crate::kinematics::AnyMachine;
use crate::set_up::SetUp;
use crate::simulate::{Design, LineRecords, Machining, Mesh, Outcome, StockFault, ToolBodies, TriDexel};
use crate::view::{ClFacts, Collector};

use super::args::{MessageFormat, SimulateArgs};
use super::check;
use super::inputs::{open_cl_data, posting_passes, read_config, show_progress};
use super::messages::Messages;
use super::outcome::{Failure, Status, Streams, is_standard, print};
use super::posting::{PostFn, PostRun};
use super::self_check::Checking;
use against_design::{AgainstDesign, DesignFigures, Tolerances};

/// Lines of a stock along its longest side, if no pitch is given: at most.
const MOST_LINES: f64 = 400.0;

/// Name of a program that is posted for the simulation alone.
const POSTED: &str = "the posted program";

/// A simulation as JSON.
#[derive(Serialize)]
struct Figures<'a> {
    passed: bool,
    motions: u64,
    collisions: u64,
    removed_mm3: f64,
    pitch_mm: [f64; 3],
    stock_mm: [[f64; 3]; 2],
    tolerance_mm: f64,
    taking_part: &'a [String],
    assumed: &'a [String],
    not_checked: Vec<String>,
    operations: Vec<Removal>,
    findings: Vec<Finding>,
    /// The comparison with the design; null: no design given.
    design: Option<DesignFigures>,
}

#[derive(Serialize)]
struct Removal {
    operation: u64,
    tool: u32,
    removed_mm3: f64,
}

#[derive(Serialize)]
struct Finding {
    kind: &'static str,
    line: u64,
    last_line: u64,
    cl_line: u64,
    operation: u64,
    tool: u32,
    volume_mm3: f64,
    longest_mm: f64,
    place_mm: [f64; 3],
}

pub(crate) fn run(
    machine: &dyn AnyMachine,
    args: &SimulateArgs,
    streams: &mut Streams<'_>,
    post: PostFn<'_>,
) -> Result<Status, Failure> {
    let mut messages = Messages::new(streams.errors, args.format());
    let config = read_config(machine, &args.set_up, &mut messages)?;
    let design = args.design.as_deref().map(|path| design(&config.set_up, path)).transpose()?;
    if design.is_none() && args.fails_on_gouge() {
        return Err(Failure::Argument("`--fail-on gouge` needs the design: give `--design D.stl`".to_owned()));
    }
    let (stock, chosen) = stock(&config.set_up, args.stock.as_deref(), args.pitch_mm)?;
    let mut source = open_cl_data(&args.input, streams.input)?;
    let name = source.name().to_owned();
    let unreadable = |error| Failure::Unreadable(name.clone(), error);
    let shown = args.program.as_deref().unwrap_or(Path::new(POSTED));
    let run = PostRun {
        input: &args.input,
        output: shown,
        checking: Checking::for_text(&config),
        config: &config,
        control: args.set_up.control(),
        post,
    };
    let mut program: File = match &args.program {
        Some(path) if is_standard(path) => {
            return Err(Failure::Argument("the program must be a file: it is read once the CL data is".to_owned()));
        }
        Some(path) => File::open(path).map_err(|error| Failure::unreadable(path, error))?,
        None => {
            show_progress(&mut source, streams.terminal, &args.set_up, posting_passes(&config));
            let mut file = tempfile::tempfile().map_err(|error| Failure::unwritable(shown, error))?;
            let written = run.write(machine, &mut source, &mut file, None, &mut messages)?;
            if let Err(reason) = written.summary {
                messages.note(&format!("rejected: {reason}"));
                return Ok(Status::Rejected);
            }
            file.rewind().map_err(|error| Failure::unwritable(shown, error))?;
            source.rewind().map_err(unreadable)?;
            file
        }
    };
    let policy = run.policy(machine)?;
    show_progress(&mut source, streams.terminal, &args.set_up, 2);
    let facts = ClFacts::read(&mut source, policy.reading.clone()).map_err(unreadable)?;
    source.rewind().map_err(unreadable)?;
    let tools = ToolBodies::of(&facts, &policy.set_up);
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let pitch_mm = stock.pitch();
    let stock_mm = stock.corners();
    let mut machining = Machining::new(&policy, tools, stock, threads);
    let mut follower = Collector::following(machine, &policy, &mut machining);
    let checked = check_observed(machine, &policy, &mut source, &mut BufReader::new(&program), &mut follower)
        .map_err(|error| check::failure(error, &name, shown))?;
    drop(follower);
    let (mut outcome, machined) = machining.finish();
    outcome.assume(chosen);
    let mut against = None;
    match &design {
        Some(design) => {
            let tolerances = Tolerances {
                gouge_mm: args.gouge_tolerance_mm.unwrap_or(policy.largest_path_mm()),
                rest_mm: args.rest_tolerance_mm.unwrap_or(policy.largest_path_mm()),
                design_mm: args.design_tolerance_mm,
                certified_mm: outcome.certified_mm(stock_mm),
            };
            let comparison = design.compare(&machined, tolerances.gouge_limit_mm(), tolerances.rest_limit_mm());
            let mut records = LineRecords::of(comparison.lines());
            if !records.is_empty() {
                // The program is executed again for the records of the lines that were found.
                program.rewind().map_err(|error| Failure::unreadable(shown, error))?;
                source.rewind().map_err(unreadable)?;
                let mut follower = Collector::following(machine, &policy, &mut records);
                check_observed(machine, &policy, &mut source, &mut BufReader::new(&program), &mut follower)
                    .map_err(|error| check::failure(error, &name, shown))?;
            }
            let found = AgainstDesign { comparison, records, tolerances };
            found.not_checked().into_iter().for_each(|text| outcome.leave_out(text));
            against = Some(found);
        }
        None => outcome.leave_out("gouges and rest material: no design given".to_owned()),
    }
    source.hide_progress();
    if let Some(what) = source.changed_since_opened() {
        return Err(Failure::Changed(name, what));
    }
    let written = args.program.as_deref().map(Path::to_string_lossy);
    check::report(&checked, &name, &mut source, written.as_deref(), &mut messages).map_err(unreadable)?;
    messages.note(&checked.outcome.summary());
    for found in &outcome.found {
        messages.warning(&found.text());
    }
    if outcome.count > outcome.found.len() as u64 {
        messages.warning(&format!("{} more findings", outcome.count - outcome.found.len() as u64));
    }
    if let (Some(against), Some(path)) = (&against, &args.design) {
        let triangles = design.as_ref().map_or(0, Design::triangles);
        against.warnings().iter().for_each(|text| messages.warning(text));
        against.notes(path, triangles).iter().for_each(|text| messages.note(text));
    }
    outcome.summary().iter().for_each(|line| messages.note(line));
    let collides = args.fails_on_collision() && outcome.count > 0;
    let gouges = args.fails_on_gouge() && against.as_ref().is_some_and(AgainstDesign::gouges);
    let passed = checked.fault.is_none() && checked.outcome.passed() && !collides && !gouges;
    if args.format() == MessageFormat::Json {
        let figures = figures(&outcome, against.as_ref(), passed, [pitch_mm, stock_mm[0], stock_mm[1]]);
        print(streams, |out| {
            serde_json::to_writer(&mut *out, &figures)?;
            out.write_all(b"\n")
        })?;
    }
    Ok(if passed { Status::Done } else { Status::Rejected })
}

/// A closed body of a file, rotated as the part is clamped: so is the CL data.
fn body(set_up: &SetUp, path: &Path, what: &str) -> Result<Mesh, Failure> {
    let mut file = File::open(path).map_err(|error| Failure::unreadable(path, error))?;
    let mesh = Mesh::read(&mut file)
        .map_err(|fault| Failure::Argument(format!("{} is no {what}: {fault}", path.display())))?;
    Ok(mesh.rotated(&set_up.part_rotation))
}

fn design(set_up: &SetUp, path: &Path) -> Result<Design, Failure> {
    body(set_up, path, "design").map(Design::new)
}

/// The stock of a file or of the configuration, and a sentence about it and its pitch.
fn stock(set_up: &SetUp, file: Option<&Path>, pitch_mm: Option<f64>) -> Result<(TriDexel, String), Failure> {
    let pitch = |[low, high]: [[f64; 3]; 2]| {
        let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        pitch_mm.unwrap_or_else(|| rounded_up(longest / MOST_LINES))
    };
    let refused = |fault: StockFault| Failure::Argument(fault.to_string());
    let (stock, pitch, what) = match (file, set_up.stock) {
        (Some(path), _) => {
            let mesh = body(set_up, path, "stock")?;
            let what =
                format!("{}, {} triangles, mm in the coordinates of the CL data", path.display(), mesh.triangles());
            let pitch = pitch(mesh.corners());
            (mesh.stock(pitch).map_err(refused)?, pitch, what)
        }
        (None, Some(blank)) => {
            let corners = [blank.lower, blank.upper];
            let pitch = pitch(corners);
            (TriDexel::block(corners, pitch).map_err(refused)?, pitch, "box of `[stock]`".to_owned())
        }
        (None, None) => {
            let text =
                "no stock: give `--stock S.stl`, or the corners of the blank, `[stock]` with `lower` and `upper`";
            return Err(Failure::Argument(text.to_owned()));
        }
    };
    let whence = if pitch_mm.is_some() { "given" } else { "chosen from the size" };
    let [low, high] = stock.corners();
    let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
    let text = format!(
        "stock: {what}, {x:.3} x {y:.3} x {z:.3} mm, pitch {pitch} mm ({whence}): nothing thinner is seen, {:.1} MB",
        stock.bytes() as f64 / 1e6
    );
    Ok((stock, text))
}

/// The next number of 1, 2, 5 and their tens.
fn rounded_up(length: f64) -> f64 {
    let ten = 10.0_f64.powf(length.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps.into_iter().map(|step| step * ten).find(|step| *step >= length * (1.0 - 1e-9)).unwrap_or(10.0 * ten)
}

/// The figures; `sizes`: pitch, and corners of the stock.
fn figures<'a>(
    outcome: &'a Outcome,
    against: Option<&AgainstDesign>,
    passed: bool,
    sizes: [[f64; 3]; 3],
) -> Figures<'a> {
    let [pitch_mm, low, high] = sizes;
    let operations = outcome.removed.iter();
    let operations = operations
        .map(|((operation, tool), volume)| Removal { operation: *operation, tool: *tool, removed_mm3: *volume })
        .collect();
    let findings = outcome.found.iter().map(|found| Finding {
        kind: found.what.name(),
        line: found.lines[0],
        last_line: found.lines[1],
        cl_line: found.cl_line,
        operation: found.operation,
        tool: found.tool,
        volume_mm3: found.volume_mm3,
        longest_mm: found.longest_mm,
        place_mm: found.place_mm,
    });
    Figures {
        passed,
        motions: outcome.motions,
        collisions: outcome.count,
        removed_mm3: outcome.volume_mm3(),
        pitch_mm,
        stock_mm: [low, high],
        tolerance_mm: outcome.deviation_mm + crate::simulate::EPS_MM,
        taking_part: outcome.taking_part(),
        assumed: outcome.assumed(),
        not_checked: outcome.not_checked(),
        operations,
        findings: findings.collect(),
        design: against.map(AgainstDesign::figures),
    }
}
