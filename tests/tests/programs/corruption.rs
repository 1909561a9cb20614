//! Programs with one fault: every harmful change is reported, and nothing where the program is correct.
//!
//! Posted programs of every control and machine are damaged in one place, thousands of times: a digit, a sign, a
//! letter, a line that is lost or doubled. The effect of a damage is computed here from the blocks that the control
//! then reads and the generated kinematics, which the check does not use. Must be reported: a moving block that ends
//! elsewhere, or runs at another feed or in another state, and a hole with other levels or steps. Programs without
//! damage must pass.
//! The meaning of words under tip control and in a tilted plane is defined here a second time.

use std::fs;
use std::io::Cursor;

use nalgebra::Vector3;
use pp_runtime::check::read::{Action, ArcMove, Block, CycleKind, CycleMove, FeedMode, SideOfPath, State, TipControl};
use pp_runtime::check::{blocks, check};
use pp_runtime::config::{Config, Mode, Operations, TcpWords, starting_point};
use pp_runtime::control::Control;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::post::{self, post};
use pp_runtime::program::Units;
use tests::binaries::workspace;
use tests::block::{angle_to_arc, distance_to_line};
use tests::by_name;
use tests::damage::damage;
use tests::random::Random;
use tests::with_machine;

/// CL data of a golden program, its configuration, its machine and its control.
type Sample = (&'static str, Option<&'static str>, &'static str, &'static str);

const SAMPLES: &[Sample] = &[
    ("blade/blade.cls", None, "spinner-u5-620", "linuxcnc"),
    ("blade/blade.cls", None, "spinner-u5-620", "fanuc"),
    ("blade/blade.cls", None, "lola-xoyzba", "linuxcnc"),
    ("rim/rim.ncl", None, "dmu-70e", "siemens"),
    ("rim/rim.ncl", None, "dmu-70e", "haas"),
    ("facets/facets.aptsource", None, "dmu-70e", "heidenhain"),
    ("facets/facets.aptsource", None, "dmu-70e", "linuxcnc"),
    ("coil/coil.cls", Some("coil/coil.toml"), "multiprodesk", "fanuc"),
    ("coil/coil.cls", Some("coil/coil.toml"), "multiprodesk", "heidenhain"),
    ("key_inch/key_inch.cls", None, "lola-xoyzba", "siemens"),
    ("key_inch/key_inch.cls", None, "multiprodesk", "linuxcnc"),
    ("nest/nest.apt", Some("nest/nest.toml"), "dmu-70e", "haas"),
    ("nest/nest.apt", Some("nest/nest.toml"), "dmu-70e", "siemens"),
    ("pads/pads.cls", Some("pads/pads.toml"), "lola-xoyzba", "fanuc"),
    ("pads/pads.cls", Some("pads/pads.toml"), "lola-xoyzba", "linuxcnc"),
    ("plate/plate.ncl", Some("plate/plate.toml"), "dmu-70e", "heidenhain"),
];

/// Number of damages to each program.
const DAMAGES: usize = 200;

/// Programs of the part with every feature: number of operations, additional configuration, machine and controls. The
/// fifth operation is a thread; in the fourth the tool axis rotates.
const WORKS: &[(usize, &str, &str, &[&str])] = &[
    (5, "", "dmu-70e", &["siemens", "heidenhain"]),
    (5, "", "spinner-u5-620", &["linuxcnc", "fanuc", "haas"]),
    (4, "output_units = 'in'\n", "spinner-u5-620", &["siemens", "heidenhain", "fanuc"]),
    (4, "mode = 'tcp'\n", "spinner-u5-620", &["fanuc", "siemens", "heidenhain", "haas"]),
    (4, "mode = 'tcp'\n", "lola-xoyzba", &["fanuc", "siemens", "heidenhain", "haas"]),
    (4, "mode = 'tcp'\ntcp_words = 'vectors'\n", "dmu-70e", &["siemens", "heidenhain"]),
    (3, "mode = 'plane'\n", "dmu-70e", &["fanuc", "siemens", "heidenhain", "haas"]),
    (3, "mode = 'plane'\n", "lola-xoyzba", &["siemens", "haas"]),
];

/// Contours with cutter compensation, left and right.
const COMPENSATED: &str = "UNITS/MM
LOADTL/1,LENGTH,110.0
SPINDL/RPM,4000,CLW
COOLNT/ON
RAPID
GOTO/-20.0,-30.0,30.0,0.0,0.0,1.0
FEDRAT/MMPM,300.0
GOTO/-20.0,-30.0,-2.0
FEDRAT/MMPM,700.0
CUTCOM/LEFT
GOTO/-20.0,-15.0,-2.0
GOTO/14.5,-15.0,-2.0
CIRCLE/14.5,-5.0,-2.0,0.0,0.0,1.0,10.0
GOTO/24.5,-5.0,-2.0
GOTO/24.5,12.5,-2.0
CUTCOM/OFF
GOTO/24.5,30.0,-2.0
GOTO/24.5,30.0,20.0
CUTCOM/RIGHT
FEDRAT/MMPM,350.0
GOTO/0.0,30.0,20.0
GOTO/0.0,12.0,20.0
CUTCOM/OFF
FEDRAT/MMPM,800.0
GOTO/-12.0,12.0,20.0
RAPID
GOTO/-12.0,12.0,40.0
";

/// Distance beyond which poses differ, in units of the last digit: rounding accounts for half of it on each side.
const UNITS: f64 = 2.0;

/// A program to be damaged.
struct Part {
    name: String,
    data: Vec<u8>,
    set_up: Config,
    control: &'static dyn Control,
    program: Vec<u8>,
}

/// Counts of the damages to one program.
#[derive(Default)]
struct Tally {
    damages: usize,
    harmful: usize,
    reported: usize,
    missed: Vec<String>,
}

fn read(path: &str) -> Vec<u8> {
    let path = workspace().join("tests/data").join(path);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn text(path: &str) -> String {
    String::from_utf8(read(path)).expect("text")
}

/// A golden program.
fn golden<M: Machine>((cl, config, machine, control): &Sample) -> Part {
    let control = by_name::control(control);
    let mut set_up = starting_point(control);
    if let Some(config) = config {
        set_up = set_up.read_over(&M::default(), &text(config)).expect("a configuration");
    }
    let part = cl.split('/').next().expect("a folder");
    let program = read(&format!("{part}/{machine}.{}.nc", control.spellings().name));
    let data = read(cl);
    if data.windows(11).any(|words| words == b"UNITS/INCHE") || part == "plate" || part == "key_inch" {
        set_up.output_units = Some(Units::Inches);
    }
    Part { name: format!("{cl} {machine} {}", control.spellings().name), data, set_up, control, program }
}

/// A program posted here, of the first `operations` of the CL data.
fn posted<M: Machine>(data: &[u8], operations: usize, config: &str, control: &str) -> Part {
    let control = by_name::control(control);
    let set_up = starting_point(control).read_over(&M::default(), config);
    let set_up = set_up.unwrap_or_else(|faults| panic!("{config}: {faults:?}"));
    let output_units = Some(set_up.output_units.unwrap_or(Units::Millimetres));
    let operations = Some(Operations::Range(1, Some(operations as u64)));
    let mut set_up = set_up;
    set_up.output_units = output_units;
    set_up.motion.selected = operations;
    let mut program = Vec::new();
    let job = post::Job { cl_name: "part.cls", config: &set_up, control, units: None };
    let report = post::<M>(&job, &mut Cursor::new(data), &mut program).expect("memory can be written");
    let name = format!("{} {} {}", M::NAME, control.spellings().name, config.lines().next().unwrap_or_default());
    assert!(!report.failed, "{name}: {:?}", report.diagnostics);
    Part { name, data: data.to_vec(), set_up, control, program }
}

/// Damages a program many times, each time in one place, and counts the harmful and the reported damages.
fn damaged<M: Machine>(part: &Part, damages: usize, random: &mut Random) -> Tally {
    let policy =
        part.set_up.check_policy::<M>(part.control, None).expect("the configuration suits control and machine");
    let found = |program: &[u8]| {
        let checked = check::<M>(&policy, Cursor::new(&part.data), program).expect("it can be read");
        checked.outcome.findings
    };
    let clean = found(&part.program);
    assert!(clean.is_empty(), "{}: {clean:?}", part.name);
    let whole = blocks::<M>(&policy, &part.program[..]).expect("it can be read");
    let mut tally = Tally { damages, ..Tally::default() };
    for _ in 0..damages {
        let (damaged, what) = damage(&part.program, random);
        let read = blocks::<M>(&policy, &damaged[..]).expect("it can be read");
        let Some(harm) = harm::<M>(&part.set_up, &whole, &read) else { continue };
        tally.harmful += 1;
        if found(&damaged).is_empty() {
            tally.missed.push(format!("{}: {what}: {harm}", part.name));
        } else {
            tally.reported += 1;
        }
    }
    tally
}

/// Effect of a damage on the motion; `None` if there is none.
fn harm<M: Machine>(config: &Config, whole: &[Block], damaged: &[Block]) -> Option<String> {
    let moving = |blocks: &[Block]| {
        let mut moving: Vec<Block> = blocks.iter().filter(|block| moves(block)).cloned().collect();
        // The second of two equal blocks does not move.
        moving.dedup_by(|again, first| {
            again.action == first.action
                && again.values.iter().zip(&first.values).all(|(a, b)| (a - b).abs() < 1e-12)
                && again.known == first.known
                && state_difference(&first.state, &again.state).is_none()
        });
        moving
    };
    let (mut whole, damaged) = (moving(whole), moving(damaged));
    if whole.len() == damaged.len() + 1 {
        let same = |(was, is): (&Block, &Block)| was.values.iter().zip(&is.values).all(|(a, b)| (a - b).abs() < 1e-12);
        let lost = whole.iter().zip(&damaged).position(|pair| !same(pair));
        if let Some(lost) = lost.filter(|lost| is_redundant::<M>(config, &whole, *lost)) {
            whole.remove(lost);
        }
    }
    for (index, (was, is)) in whole.iter().zip(&damaged).enumerate() {
        let before = index.checked_sub(1);
        let around = [before.map(|before| &whole[before]), whole.get(index + 1)];
        let from = before.map(|before| [&whole[before], &damaged[before]]);
        if let Some(what) =
            pose_difference::<M>(config, was, is, around).or_else(|| path_difference::<M>(config, [was, is], from))
        {
            return Some(format!("block {index}: {what}"));
        }
    }
    (whole.len() != damaged.len()).then(|| "different number of moving blocks".to_owned())
}

/// Whether a block makes no difference: it moves by no more than rounding, or, where the control rotates the tool axis
/// evenly, it is on the path between the blocks before and after it.
fn is_redundant<M: Machine>(config: &Config, blocks: &[Block], index: usize) -> bool {
    let [Some(before), Some(block), Some(after)] = [index.wrapping_sub(1), index, index + 1].map(|at| blocks.get(at))
    else {
        return false;
    };
    let alike = [block, after].iter().all(|block| block.action == Action::Feed && block.state.vector.is_some());
    let same = state_difference(&block.state, &after.state).is_none() && block.state.feed == after.state.feed;
    let [(from, first), (tip, axis), (to, last)] = [before, block, after].map(|block| pose::<M>(config, block));
    // With M8 between two blocks only the next one has the same state; a state that is lost differs there.
    let states = [(&before.state, &block.state), (&block.state, &after.state)];
    let stays =
        block.action == before.action && states.iter().any(|(one, other)| state_difference(one, other).is_none());
    let stays = stays && (tip - from).norm() <= UNITS * 1e-3 && (axis - first).norm() <= 1e-5;
    let between = distance_to_line(&tip.into(), &from.into(), &to.into()) <= UNITS * 1e-3;
    stays || (alike && same && between && angle_to_arc(&axis, &first, &last) <= 1e-5)
}

/// Whether a block moves an axis: a block without axis words does not.
fn moves(block: &Block) -> bool {
    block.action.moves() && block.written != 0
}

fn pose_difference<M: Machine>(
    config: &Config,
    was: &Block,
    is: &Block,
    around: [Option<&Block>; 2],
) -> Option<String> {
    if std::mem::discriminant(&was.action) != std::mem::discriminant(&is.action) {
        return Some(format!("{:?} became {:?}", was.action, is.action));
    }
    // Nothing is cut in a machine retract: the spindle may be off before it.
    let mut state = is.state;
    if was.action == Action::Machine && state.spindle.flatten().is_none() {
        (state.spindle, state.speed) = (was.state.spindle, was.state.speed);
    }
    if let Some(what) = state_difference(&was.state, &state) {
        return Some(what);
    }
    let all = (1_u16 << M::AXES.len()) - 1;
    let unit = 1e-3 * config.output_units.map_or(1.0, |units| if units.in_mm() > 1.0 { 2.54 } else { 1.0 });
    if was.action == Action::Machine || was.known != all || is.known != all {
        // Rotary axes may have any position that gives the same tool axis where tool vectors are programmed, or tip
        // control follows.
        let tcp = config.motion.tip.tcp_words == TcpWords::Vectors || config.motion.mode == Mode::Tcp;
        let free = tcp && (pose::<M>(config, was).1 - pose::<M>(config, is).1).norm() < 1e-5;
        let counts = |index: &usize| !free || M::AXES.get(*index).is_none_or(|axis| axis.kind == AxisKind::Linear);
        let off = (0..was.values.len()).filter(counts).map(|index| (was.values[index] - is.values[index]).abs());
        let off = off.fold(0.0, f64::max);
        // A word of an axis that is where it was adds nothing, but to a motion in machine coordinates.
        let other_words = was.written != is.written && (was.action == Action::Machine || was.known & !is.known != 0);
        // Words of exactly so many units differ by a little more in binary.
        let moved = off > UNITS * unit + 1e-9 || other_words;
        return moved.then(|| format!("a coordinate is {off:.4} off"));
    }
    let ((tip, axis), (damaged_tip, damaged_axis)) = (pose::<M>(config, was), pose::<M>(config, is));
    // A point of an arc that has moved along it is still on the path.
    let known = |block: &&Block| block.known == all && block.action != Action::Machine;
    let near = around.map(|block| block.filter(known).map(|block| pose::<M>(config, block).0));
    let off = near.iter().flatten().map(|end| distance_to_line(&damaged_tip.into(), &tip.into(), &(*end).into()));
    if off.fold((tip - damaged_tip).norm(), f64::min) > UNITS * unit {
        return Some(format!("the tip is {:.4} mm off", (tip - damaged_tip).norm()));
    }
    let largest = 4.0 * 10_f64.powi(-(config.formats.rotary as i32)).to_radians() + 1e-5;
    // A tip that rounding has moved along the path has a tool axis that is rotated accordingly.
    let with_tip = around.iter().filter_map(|block| block.filter(known)).map(|block| {
        let (end, end_axis) = pose::<M>(config, block);
        (end_axis - axis).norm() * (UNITS * unit / (end - tip).norm().max(UNITS * unit))
    });
    let largest = largest + with_tip.fold(0.0, f64::max);
    if (axis - damaged_axis).norm() > largest {
        return Some(format!("the tool axis is {:.5} deg off", (axis - damaged_axis).norm().to_degrees()));
    }
    let length = near[0].map_or(0.0, |before| (before - tip).norm());
    let slack = 0.01_f64.max(8.0 * unit / length.max(1e-9));
    // Where a rotary axis moves, the time of a block may be that of a bound of the axis speeds within it, 1.5 % above
    // the speeds.
    let bound = if was.state.feed_mode == Some(FeedMode::InverseTime) { 0.015 } else { 0.0 };
    match (was.action, was.state.feed, is.state.feed) {
        (Action::Feed, Some(was), Some(is)) if is > was * (1.0 + slack) || is < was * (1.0 - slack.max(bound)) => {
            Some(format!("F {was} became {is}"))
        }
        (Action::Feed, was, is) if was.is_some() != is.is_some() => Some(format!("F {was:?} became {is:?}")),
        _ => None,
    }
}

/// First difference between the modal states of two blocks that changes the motion.
fn state_difference(was: &State, is: &State) -> Option<String> {
    let feeds = |state: &State| state.feed_mode == Some(FeedMode::InverseTime);
    let differences = [
        (was.tool != is.tool, "tool"),
        (was.length != is.length, "length offset"),
        (was.work_offset != is.work_offset, "work offset"),
        (was.units != is.units, "unit"),
        (was.incremental != is.incremental, "distances"),
        (was.plane != is.plane, "plane"),
        (was.spindle.flatten() != is.spindle.flatten(), "spindle"),
        (was.spindle.flatten().is_some() && was.speed != is.speed, "speed"),
        (was.coolant != is.coolant, "coolant"),
        (was.side.unwrap_or_default() != is.side.unwrap_or_default(), "side"),
        (feeds(was) != feeds(is), "feed mode"),
        ((was.tip_control == TipControl::Off) != (is.tip_control == TipControl::Off), "tip control"),
        (was.tilt.map(|tilt| tilt.oriented) != is.tilt.map(|tilt| tilt.oriented), "tilt"),
        (
            was.side.is_some_and(|side| side != SideOfPath::None) && was.diameter != is.diameter,
            "register of the radius",
        ),
    ];
    differences.iter().find(|(differs, _)| *differs).map(|(_, what)| (*what).to_owned())
}

/// Difference between the ends of a block: the sense of an arc, the hole of a cycle.
fn path_difference<M: Machine>(config: &Config, blocks: [&Block; 2], from: Option<[&Block; 2]>) -> Option<String> {
    let unit = UNITS * 1e-3 * if config.output_units == Some(Units::Inches) { 2.54 } else { 1.0 };
    match (blocks[0].action, blocks[1].action) {
        (Action::Cycle(was), Action::Cycle(is)) => {
            let feed = |cycle: &CycleMove, block: &Block| cycle.feed.or(block.state.feed).unwrap_or(0.0);
            let feeds = [feed(&was, blocks[0]), feed(&is, blocks[1])];
            hole_difference(&was, &is, unit).or_else(|| {
                let taps = matches!(was.kind, CycleKind::Tap(_));
                let off = (feeds[0] - feeds[1]).abs() > 0.01 * feeds[0] && !taps;
                off.then(|| format!("the F of a cycle, {}, became {}", feeds[0], feeds[1]))
            })
        }
        (Action::Arc(was), Action::Arc(is)) => {
            let [before, now] = from?;
            let all = (1_u16 << M::AXES.len()) - 1;
            let known = [before, now, blocks[0], blocks[1]].iter().all(|block| block.known == all);
            if !known || before.action == Action::Machine || now.action == Action::Machine {
                return None;
            }
            let middle = |from: &Block, to: &Block, arc: &ArcMove| {
                let half = middle_of_arc::<M>(from, to, arc);
                pose::<M>(config, &Block { values: half, ..to.clone() }).0
            };
            let off = (middle(before, blocks[0], &was) - middle(now, blocks[1], &is)).norm();
            // Each may deviate from the path by the tolerance.
            (off > 2.0 * config.motion.tolerance_mm + 2.0 * unit)
                .then(|| format!("the middle of an arc is {off:.4} mm off"))
        }
        _ => None,
    }
}

/// Difference between two holes: kind, steps, levels or dwell.
fn hole_difference(was: &CycleMove, is: &CycleMove, unit: f64) -> Option<String> {
    let same = match (was.kind, is.kind) {
        (CycleKind::Peck(was), CycleKind::Peck(is)) | (CycleKind::ChipBreak(was), CycleKind::ChipBreak(is)) => {
            (was - is).abs() <= unit
        }
        (CycleKind::Tap(was), CycleKind::Tap(is)) => (was - is).abs() <= 1e-3 * was.abs(),
        (was, is) => was == is,
    };
    let levels = [(was.reference, is.reference), (was.bottom, is.bottom), (was.back_to, is.back_to)];
    let moved = levels.iter().any(|(was, is)| (was - is).abs() > unit);
    (!same || moved || (was.dwell - is.dwell).abs() > 2e-3).then(|| format!("{was:?} became {is:?}"))
}

/// Axis values at the middle of an arc.
fn middle_of_arc<M: Machine>(from: &Block, to: &Block, arc: &ArcMove) -> [f64; 9] {
    let mut half: [f64; 9] = std::array::from_fn(|index| f64::midpoint(from.values[index], to.values[index]));
    let [u, v, _] = to.state.plane.expect("an arc has a plane").axes();
    let [first, second] = [u, v].map(|axis| chain_index::<M>(axis).expect("an arc has its axes"));
    let (x, y) = (from.values[first] - arc.centre[u], from.values[second] - arc.centre[v]);
    let (sine, cosine) = (arc.sweep / 2.0).sin_cos();
    half[first] = arc.centre[u] + x * cosine - y * sine;
    half[second] = arc.centre[v] + x * sine + y * cosine;
    half
}

/// Index of X, Y or Z in the chain.
fn chain_index<M: Machine>(axis: usize) -> Option<usize> {
    M::AXES.iter().position(|found| found.letter == ['X', 'Y', 'Z'][axis])
}

/// Tip and tool axis of a block. By the generated kinematics where words are axis values; under tip control the words
/// are the tip position on the workpiece with rotary axes at zero; in a tilted plane they are the tip position in that
/// plane. The tool axis is that of the rotary axes, or the programmed vector.
fn pose<M: Machine>(config: &Config, block: &Block) -> (Vector3<f64>, Vector3<f64>) {
    let mut machine = config.set_up.machine::<M>().expect("a machine");
    let length = block.state.tool.and_then(|tool| config.set_up.tools.get(&tool)).and_then(|tool| tool.length_mm);
    machine.set_up(config.set_up.part_origin.into(), length.unwrap_or(100.0));
    let mut values = M::HELD;
    for (value, word) in values.as_mut().iter_mut().zip(&block.values) {
        *value = *word;
    }
    let pose = machine.forward_kinematics(&values);
    let words = || Vector3::from([0, 1, 2].map(|axis| chain_index::<M>(axis).map_or(0.0, |index| block.values[index])));
    let axis = block.state.vector.unwrap_or_else(|| pose.axis.into_inner());
    match (block.state.tip_control, block.state.tilt) {
        (TipControl::On { .. }, _) => (words(), axis),
        (TipControl::Off, Some(tilt)) => (tilt.origin + tilt.rotation * words(), axis),
        (TipControl::Off, None) => (pose.tip.coords, pose.axis.into_inner()),
    }
}

/// Checks that every harmful damage is reported, and that enough damages are harmful.
fn all_reported(tallies: &[Tally]) {
    let sum = |count: fn(&Tally) -> usize| tallies.iter().map(count).sum::<usize>();
    let (damages, harmful, reported) = (sum(|t| t.damages), sum(|t| t.harmful), sum(|t| t.reported));
    let missed: Vec<&str> = tallies.iter().flat_map(|tally| &tally.missed).map(String::as_str).collect();
    assert!(damages >= 1000 && harmful > damages / 3, "{harmful} of {damages} are harmful: too few for a verdict");
    let missing = missed.len();
    assert!(missed.is_empty(), "{missing} of {harmful} are missed ({reported} reported):\n{}", missed.join("\n"));
}

#[test]
fn every_harmful_damage_is_reported_and_nothing_else() {
    let mut random = Random::new(20_261_121);
    let tallies: Vec<Tally> = SAMPLES
        .iter()
        .map(|sample| {
            let part = with_machine!(sample.2, golden(sample));
            with_machine!(sample.2, damaged(&part, DAMAGES, &mut random))
        })
        .collect();
    all_reported(&tallies);
}

#[test]
fn every_harmful_damage_to_cycles_threads_tip_control_and_tilted_planes_is_reported() {
    let mut random = Random::new(8);
    let mut tallies = Vec::new();
    for (operations, more_config, machine, controls) in WORKS {
        let table = if *machine == "lola-xoyzba" { "works/works.toml" } else { "works/table.toml" };
        let (data, config) = (read("works/works.cls"), more_config.to_string() + &text(table));
        for control in *controls {
            let part = with_machine!(*machine, posted(&data, *operations, &config, control));
            tallies.push(with_machine!(*machine, damaged(&part, DAMAGES / 4, &mut random)));
        }
    }
    all_reported(&tallies);
}

#[test]
fn every_harmful_damage_to_cutter_compensation_is_reported() {
    let mut random = Random::new(41);
    let config = "[compensation]\npath = 'contour'\n[retract]\ndistance = 60\n";
    let registers = "[tools]\n1 = { length = 110, radius_offset = 31 }\n";
    let mut tallies = Vec::new();
    for (machine, control) in [
        ("spinner-u5-620", "linuxcnc"),
        ("dmu-70e", "fanuc"),
        ("lola-xoyzba", "haas"),
        ("spinner-u5-620", "siemens"),
        ("lola-xoyzba", "heidenhain"),
    ] {
        let named = matches!(control, "linuxcnc" | "fanuc" | "haas");
        let config = config.to_owned() + if named { registers } else { "" };
        let part = with_machine!(machine, posted(COMPENSATED.as_bytes(), 1, &config, control));
        tallies.push(with_machine!(machine, damaged(&part, 2 * DAMAGES, &mut random)));
    }
    all_reported(&tallies);
}
