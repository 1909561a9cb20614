//! Programs with one character wrong: every harm is reported, and nothing is where there is none.
//!
//! Posted programs of every control and machine are damaged in one place, thousands of times: a digit, a sign, a letter, a
//! line that is lost or stands twice. What a damage does is worked out here from the blocks that the control then reads and
//! the generated kinematics, which the check does not use: a moving block that ends elsewhere, runs at another feed or in
//! another state has to be reported. Programs without damage have to pass.

use std::fs;
use std::io::Cursor;

use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use nalgebra::Vector3;
use pp_runtime::check::read::{Action, Block, FeedMode, State, TipControl};
use pp_runtime::check::{Job, blocks, check};
use pp_runtime::config::Config;
use pp_runtime::control;
use pp_runtime::kinematics::Machine;
use tests::binaries::workspace;
use tests::block::distance_to_line;
use tests::random::Random;

/// A program, the CL data it was posted from, its configuration, its machine and control.
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

/// Damages of each program.
const DAMAGES: usize = 200;

/// Poses farther apart than this differ, units of the words: rounding may have taken half of it the other way.
const UNITS: f64 = 2.0;

/// What one sample has to say.
#[derive(Default)]
struct Tally {
    harmful: usize,
    reported: usize,
    missed: Vec<String>,
}

fn read(path: &str) -> Vec<u8> {
    let path = workspace().join("tests/data").join(path);
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn each(sample: &Sample, random: &mut Random) -> Tally {
    match sample.2 {
        "spinner-u5-620" => run::<SpinnerU5620>(sample, random),
        "dmu-70e" => run::<Dmu70e>(sample, random),
        "lola-xoyzba" => run::<LolaXoyzba>(sample, random),
        _ => run::<MultiProDesk>(sample, random),
    }
}

fn run<M: Machine>((cl, config, machine, control): &Sample, random: &mut Random) -> Tally {
    let control = control::by_name(control).expect("a control");
    let mut set_up = control::starting_point(control);
    if let Some(config) = config {
        let text = String::from_utf8(read(config)).expect("text");
        set_up = set_up.read_over::<M>(&text).expect("a configuration");
    }
    let part = cl.split('/').next().expect("a folder");
    let program = read(&format!("{part}/{machine}.{}.nc", control.spellings().name));
    let data = read(cl);
    if data.windows(11).any(|words| words == b"UNITS/INCHE") || part == "plate" || part == "key_inch" {
        set_up.output_units = Some(pp_runtime::config::Units::Inches);
    }
    let job = Job { config: &set_up, control, units: None };
    let found = |program: &[u8]| {
        let checked = check::<M>(&job, Cursor::new(&data), program).expect("it can be read");
        checked.outcome.findings
    };
    let clean = found(&program);
    assert!(clean.is_empty(), "{cl} {machine}: {clean:?}");
    let whole = blocks::<M>(&job, &program[..]).expect("it can be read");
    let mut tally = Tally::default();
    for _ in 0..DAMAGES {
        let (damaged, what) = damage(&program, random);
        let read = blocks::<M>(&job, &damaged[..]).expect("it can be read");
        let Some(harm) = harm::<M>(&set_up, &whole, &read) else { continue };
        tally.harmful += 1;
        if found(&damaged).is_empty() {
            tally.missed.push(format!("{cl} {machine} {}: {what}: {harm}", control.spellings().name));
        } else {
            tally.reported += 1;
        }
    }
    tally
}

/// A program with one thing wrong, and what.
fn damage(program: &[u8], random: &mut Random) -> (Vec<u8>, String) {
    let lines: Vec<&[u8]> = program.split_inclusive(|byte| *byte == b'\n').collect();
    let comment = |line: &[u8]| {
        let text = line.trim_ascii_start();
        text.starts_with(b"(") || text.starts_with(b";") || text.windows(2).any(|two| two == b"; ") || text.is_empty()
    };
    loop {
        let at = random.below(lines.len());
        if comment(lines[at]) {
            continue;
        }
        let mut damaged: Vec<u8> = lines[..at].concat();
        let mut line = lines[at].to_vec();
        let before = String::from_utf8_lossy(&line).trim_end().to_owned();
        match random.below(10) {
            0 => line.clear(),
            1 => line = [line.clone(), line].concat(),
            2 => {
                let place = random.below(line.len());
                if line[place] == b'\n' {
                    continue;
                }
                line.remove(place);
            }
            _ => {
                let place = random.below(line.len());
                let other = match line[place] {
                    b'0'..=b'9' => b'0' + random.below(10) as u8,
                    b'-' => b'+',
                    b'+' => b'-',
                    b'A'..=b'Z' => b'A' + random.below(26) as u8,
                    b'.' => b"0123456789"[random.below(10)],
                    b' ' => b'-',
                    _ => continue,
                };
                if other == line[place] {
                    continue;
                }
                line[place] = other;
            }
        }
        let after = String::from_utf8_lossy(&line).trim_end().to_owned();
        damaged.extend_from_slice(&line);
        damaged.extend(lines[at + 1..].concat());
        return (damaged, format!("line {} `{before}` became `{after}`", at + 1));
    }
}

/// What a damage does to the motion, if anything.
fn harm<M: Machine>(config: &Config, whole: &[Block], damaged: &[Block]) -> Option<String> {
    let moving = |blocks: &[Block]| {
        let mut moving: Vec<Block> = blocks.iter().filter(|block| moves(block)).cloned().collect();
        // What stands twice goes nowhere.
        moving.dedup_by(|again, first| {
            again.action == first.action
                && again.values.iter().zip(&first.values).all(|(a, b)| (a - b).abs() < 1e-12)
                && again.known == first.known
                && state(&first.state, &again.state).is_none()
        });
        moving
    };
    let (whole, damaged) = (moving(whole), moving(damaged));
    for (index, (was, is)) in whole.iter().zip(&damaged).enumerate() {
        let around = [index.checked_sub(1).map(|before| &whole[before]), whole.get(index + 1)];
        if let Some(what) = differs::<M>(config, was, is, around) {
            return Some(format!("block {index}: {what}"));
        }
    }
    (whole.len() != damaged.len()).then(|| "another number of moving blocks".to_owned())
}

/// A block that names the place where the axes are moves nothing.
fn moves(block: &Block) -> bool {
    block.action.moves() && block.written != 0
}

fn differs<M: Machine>(config: &Config, was: &Block, is: &Block, around: [Option<&Block>; 2]) -> Option<String> {
    if std::mem::discriminant(&was.action) != std::mem::discriminant(&is.action) {
        return Some(format!("{:?} became {:?}", was.action, is.action));
    }
    if let Some(what) = state(&was.state, &is.state) {
        return Some(what);
    }
    let all = (1_u16 << M::AXES.len()) - 1;
    let unit = 1e-3 * config.output_units.map_or(1.0, |units| if units.in_mm() > 1.0 { 2.54 } else { 1.0 });
    if was.action == Action::Machine || was.known != all || is.known != all {
        let off = was.values.iter().zip(&is.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let moved = off > UNITS * unit || was.written != is.written;
        return moved.then(|| format!("a coordinate is {off:.4} off"));
    }
    let ((tip, axis), (there, leaning)) = (pose::<M>(config, was), pose::<M>(config, is));
    // A point of an arc that has moved along it is still on the path.
    let known = |block: &&Block| block.known == all && block.action != Action::Machine;
    let near = around.map(|block| block.filter(known).map(|block| pose::<M>(config, block).0));
    let off = near.iter().flatten().map(|end| distance_to_line(&there.into(), &tip.into(), &(*end).into()));
    if off.fold((tip - there).norm(), f64::min) > UNITS * unit {
        return Some(format!("the tip is {:.4} mm off", (tip - there).norm()));
    }
    let largest = 4.0 * 10_f64.powi(-(config.formats.rotary as i32)).to_radians() + 1e-5;
    if (axis - leaning).norm() > largest {
        return Some(format!("the tool axis is {:.5} deg off", (axis - leaning).norm().to_degrees()));
    }
    let length = near[0].map_or(0.0, |before| (before - tip).norm());
    let slack = 0.01_f64.max(8.0 * unit / length.max(1e-9));
    match (was.action, was.state.feed, is.state.feed) {
        (Action::Feed, Some(was), Some(is)) if (was - is).abs() > slack * was => Some(format!("F {was} became {is}")),
        (Action::Feed, was, is) if was.is_some() != is.is_some() => Some(format!("F {was:?} became {is:?}")),
        _ => None,
    }
}

/// States that count.
fn state(was: &State, is: &State) -> Option<String> {
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
        (was.tilt.is_some() != is.tilt.is_some(), "tilt"),
    ];
    differences.iter().find(|(differs, _)| *differs).map(|(_, what)| (*what).to_owned())
}

/// Tip and tool axis of a block in mode `axes`, by the generated kinematics.
fn pose<M: Machine>(config: &Config, block: &Block) -> (Vector3<f64>, Vector3<f64>) {
    let mut machine = config.machine::<M>().expect("a machine");
    let length = block.state.tool.and_then(|tool| config.tools.get(&tool)).and_then(|tool| tool.length);
    machine.set_up(config.part_origin.into(), length.unwrap_or(100.0));
    let mut values = M::HELD;
    for (value, word) in values.as_mut().iter_mut().zip(&block.values) {
        *value = *word;
    }
    let pose = machine.forward_kinematics(&values);
    (pose.tip.coords, pose.axis.into_inner())
}

#[test]
fn every_harm_is_reported_and_nothing_else() {
    let mut random = Random::new(20_261_121);
    let (mut harmful, mut reported, mut missed) = (0, 0, Vec::new());
    for sample in SAMPLES {
        let tally = each(sample, &mut random);
        harmful += tally.harmful;
        reported += tally.reported;
        missed.extend(tally.missed);
    }
    let damages = SAMPLES.len() * DAMAGES;
    assert!(damages >= 2000 && harmful > damages / 3, "{harmful} of {damages} do harm: too few to say anything");
    assert!(
        missed.is_empty(),
        "{} of {harmful} are missed ({reported} reported):\n{}",
        missed.len(),
        missed.join("\n")
    );
}
