//! How fast the product is, as ratios of times in one run: machines differ and are noisy, their ratios hardly.
//!
//! The works of a group run in turn, many rounds, and the median of each is divided by that of the first. A group
//! begins with what it is compared with: a kernel written by hand (`kernel`), a small postprocessor that does only the
//! core of the job (`reference`), or the simplest file. Instructions are counted by `.ci/instructions`, which lists the
//! works of the kinematics (`--list`) and runs them one by one (`--run NUMBER TIMES`).

mod kernel;
mod parts;
mod reference;

use std::fs;
use std::hint::black_box;
use std::io::Cursor;
use std::time::{Duration, Instant};

use machines::SpinnerU5620;
use pp_runtime::check::check;
use pp_runtime::cli::{Status, Streams, run_with};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::control::Control;
use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::post::{Job, post};
use pp_runtime::program::Units;
use tests::by_name;
use tests::oracle::Oracle;
use tests::random::Random;

/// Number of poses of the kinematics.
const POSES: usize = 20_000;

/// Number of points of a file.
const POINTS: usize = 50_000;

/// A work, its name, and the amount of it: points, poses, records.
struct Work<'w> {
    name: &'static str,
    amount: usize,
    run: Box<dyn FnMut() + 'w>,
}

fn work<'w>(name: &'static str, amount: usize, run: impl FnMut() + 'w) -> Work<'w> {
    Work { name, amount, run: Box::new(run) }
}

/// Runs the works in turn and prints the median time of each, and its ratio to the first.
fn compare(title: &str, unit: &str, rounds: usize, mut works: Vec<Work<'_>>) {
    let mut times = vec![Vec::new(); works.len()];
    for _ in 0..rounds {
        for (work, times) in works.iter_mut().zip(&mut times) {
            let start = Instant::now();
            (work.run)();
            times.push(start.elapsed());
        }
    }
    println!("\n{title}");
    let median = |times: &mut Vec<Duration>| {
        times.sort();
        times[times.len() / 2]
    };
    let mut first = None;
    for (work, times) in works.iter().zip(&mut times) {
        let nanoseconds = median(times).as_secs_f64() * 1e9 / work.amount as f64;
        let ratio = nanoseconds / *first.get_or_insert(nanoseconds);
        println!("  {:<48} {ratio:>7.2}   {nanoseconds:>8.0} ns a {unit}", work.name);
    }
}

fn poses() -> Vec<Pose> {
    let oracle = Oracle::of(&SpinnerU5620::default());
    let mut random = Random::new(7);
    let mut pose = || {
        let angles = [random.between(-3.0, 3.0), random.between(0.02, 1.9)];
        let linear = [0; 3].map(|_| random.between(-200.0, 200.0));
        oracle.forward(&[angles[0], angles[1], linear[0], linear[1], linear[2]])
    };
    (0..POSES).map(|_| pose()).collect()
}

/// Passes the works of the kinematics to `take`, group by group.
fn kinematics(mut take: impl FnMut(&str, Vec<Work<'_>>)) {
    let (machine, poses) = (SpinnerU5620::default(), poses());
    let solved: Vec<_> =
        poses.iter().map(|pose| machine.inverse_kinematics(pose, &SpinnerU5620::HELD)[0].axes).collect();
    let (oracle, height) = (Oracle::of(&machine), machine.dimension(0));
    /// A work of all of `items`, none of which is left out because nothing uses its result.
    fn each<'w, T, R>(name: &'static str, items: &'w [T], solve: impl Fn(&T) -> R + 'w) -> Work<'w> {
        work(name, items.len(), move || {
            for item in items {
                black_box(solve(black_box(item)));
            }
        })
    }
    take(
        "inverse kinematics, C-on-B table",
        vec![
            each("by hand, both branches", &poses, |pose| kernel::both(height, pose)),
            each("generated, both branches", &poses, |pose| {
                let solutions = machine.inverse_kinematics(pose, &SpinnerU5620::HELD);
                [solutions[0].axes, solutions[1].axes]
            }),
            each("by hand, one branch", &poses, |pose| kernel::one(height, pose)),
            each("by hand, sines and cosines of the angles", &poses, |pose| kernel::trigonometric(height, pose)),
        ],
    );
    take(
        "forward kinematics, C-on-B table",
        vec![
            each("by hand", &solved, |axes| kernel::forward(height, axes)),
            each("generated", &solved, |axes| machine.forward_kinematics(axes)),
            each("product of nalgebra's matrices at run time", &solved, |axes| oracle.forward(axes)),
        ],
    );
}

/// Lists the works of the kinematics, or runs one of them this many times: for a count of its instructions.
fn list_or_run(chosen: Option<(usize, usize)>) {
    let mut number = 0;
    kinematics(|title, works| {
        for Work { name, amount, mut run } in works {
            match chosen {
                None => println!("{number}|{amount}|{title}, {name}"),
                Some((wanted, times)) if wanted == number => (0..times).for_each(|_| run()),
                Some(_) => {}
            }
            number += 1;
        }
    });
}

/// Posts a part; returns the program.
fn posted(part: &str, config: &Config, control: &'static dyn Control, program: &mut Vec<u8>) {
    program.clear();
    let job = Job { cl_name: "part.cls", config, control, units: Some(Units::Millimetres) };
    let report = post::<SpinnerU5620>(&job, &mut Cursor::new(part), program).expect("memory takes everything");
    assert!(!report.failed, "{:?}", report.diagnostics);
}

fn pipeline() {
    let control = by_name::control("linuxcnc");
    let plain = starting_point(control);
    let limits = include_str!("../../data/blade/one_turn.toml");
    let one_turn = starting_point(control).read_over(&SpinnerU5620::default(), limits).expect("a configuration");
    let policy = plain.check_policy::<SpinnerU5620>(control, Some(Units::Millimetres)).expect("a policy");
    let (blade, plane) = (parts::blade(POINTS), parts::plane(POINTS));
    let (short, holes) = (parts::short_operations(POINTS), parts::holes(POINTS / 5));
    let arcs = parts::arcs(POINTS / 10);
    let (windows, commented) = (blade.replace('\n', "\r\n"), blade.replace('\n', "\n$$ A COMMENT BETWEEN ALL LINES\n"));
    let mut program = Vec::new();
    posted(&blade, &plain, control, &mut program);
    let post_to_memory = |part: &str, config: &Config| {
        let mut program = Vec::with_capacity(part.len());
        posted(part, config, control, &mut program);
        black_box(program);
    };
    compare(
        "whole programs, five axes, each word changes in each line",
        "point",
        11,
        vec![
            work("reference: only the core of the job", POINTS, || {
                black_box(reference::post(blade.as_bytes()));
            }),
            work("post without check", POINTS, || post_to_memory(&blade, &plain)),
            work("the check alone", POINTS, || {
                let checked =
                    check::<SpinnerU5620>(&policy, Cursor::new(&blade), &program[..]).expect("memory is read");
                assert!(checked.outcome.passed(), "{:?}", checked.outcome.findings);
            }),
            work("post, C limited to one revolution each way", POINTS, || post_to_memory(&blade, &one_turn)),
            work("post, three axes", POINTS, || post_to_memory(&plane, &plain)),
        ],
    );
    compare(
        "kinds of files, program alone",
        "record",
        11,
        vec![
            work("one operation of points", POINTS, || post_to_memory(&blade, &plain)),
            work("operations of 100 points", POINTS, || post_to_memory(&short, &plain)),
            work("holes", POINTS / 5, || post_to_memory(&holes, &plain)),
            work("lines and arcs", 2 * (POINTS / 10), || post_to_memory(&arcs, &plain)),
            work("lines end in CR LF", POINTS, || post_to_memory(&windows, &plain)),
            work("a comment after each line", POINTS, || post_to_memory(&commented, &plain)),
        ],
    );
}

/// The whole command, in files, with one thread and with as many as there are processors; its check on and off.
fn commands() {
    let folder = tempfile::tempdir().expect("a folder");
    let [input, output, other] =
        ["part.cls", "part.nc", "other.nc"].map(|name| folder.path().join(name).display().to_string());
    fs::write(&input, parts::blade(POINTS)).expect("a file");
    let post = |options: &[&str]| {
        let args = ["spinner", "post", &input, "-o", &output, "--units", "mm", "--quiet"];
        let args: Vec<_> = args.iter().chain(options).map(Into::into).collect();
        let (mut shown, mut errors) = (Vec::new(), Vec::new());
        let streams = Streams { input: &mut &b""[..], output: &mut shown, errors: &mut errors, terminal: false };
        let status = run_with::<SpinnerU5620>(&args, streams);
        assert_eq!(status, Status::Done, "{}", String::from_utf8_lossy(&errors));
    };
    compare(
        "the whole command, five axes, each word changes in each line",
        "point",
        11,
        vec![
            work("reference: only the core of the job", POINTS, || {
                let data = fs::read(&input).expect("a file");
                fs::write(&other, reference::post(&data)).expect("a file");
            }),
            work("post without check, one thread", POINTS, || post(&["--no-check", "--threads", "1"])),
            work("post without check, all threads", POINTS, || post(&["--no-check"])),
            work("post with its check, one thread that reads", POINTS, || post(&["--threads", "1"])),
            work("post with its check, all threads", POINTS, || post(&[])),
        ],
    );
}

fn main() {
    // `cargo test --benches` only builds and starts it.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let mut arguments = std::env::args().skip(1);
    let first = arguments.next();
    let mut number = || arguments.next().and_then(|text| text.parse().ok()).expect("--run NUMBER TIMES");
    match first.as_deref() {
        Some("--list") => return list_or_run(None),
        Some("--run") => return list_or_run(Some((number(), number()))),
        _ => {}
    }
    println!("ratios of median times in this run; the first of each group is 1");
    kinematics(|title, works| compare(title, "pose", 61, works));
    pipeline();
    commands();
}
