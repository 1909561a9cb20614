//! The stream of executed blocks: every golden program, of all controls in all modes, is observed while it is checked.
//!
//! Axis values of a leg give its pose, by the oracle; a leg begins where the one before it has ended; each block that
//! moves is executed once; and a finding is about the block that causes it.

use std::io::Cursor;

use pp_runtime::check::read::{Action, State};
use pp_runtime::config::Mode;
use pp_runtime::kinematics::{Machine, Pose};
use pp_runtime::post;
use tests::binaries::golden_programs;
use tests::golden::Golden;
use tests::oracle::{Oracle, angle_between};
use tests::with_machine;

/// Largest distance of one tip from another that should be the same, mm: an axis value is solved for, and added up.
const SAME_TIP_MM: f64 = 1e-6;

/// Largest angle between two directions that should be the same, rad.
const SAME_AXIS_RAD: f64 = 1e-9;

/// The same in a tilted plane: the plane is programmed, and the rotary axes are rounded to a thousandth of a degree.
const PLANE_AXIS_RAD: f64 = 2e-5;

/// Largest distance of the end of an arc from its end words, mm: ends and centre are rounded to a thousandth.
const ARC_END_MM: f64 = 2e-3;

fn apart(one: &Pose, other: &Pose) -> (f64, f64) {
    ((one.tip - other.tip).norm(), angle_between(&one.axis.into_inner(), &other.axis.into_inner()))
}

fn assert_same(context: &str, one: &Pose, other: &Pose, allowed_mm: f64, allowed_rad: f64) {
    let (tip_mm, axis_rad) = apart(one, other);
    let same = tip_mm <= allowed_mm && axis_rad <= allowed_rad;
    assert!(same, "{context}: {tip_mm} mm, {axis_rad} rad apart\n{one:?}\n{other:?}");
}

/// Legs whose axis values give their pose.
fn posed<M: Machine>(golden: &Golden) -> usize {
    let config = golden.config::<M>();
    let mut machine = config.set_up.machine::<M>().expect("a valid machine");
    let mut compared = 0;
    golden.observed::<M>(&golden.program, |executed| {
        machine.set_up(executed.part_origin(), golden.length_mm(&config, executed.block.state.tool));
        let oracle = Oracle::of(&machine);
        for leg in executed.legs() {
            for share in [0.0, 0.3, 1.0] {
                let Some(values) = leg.axis_values(share) else { continue };
                let context = format!("{}, line {}, {share}", golden.name, executed.block.line);
                let tilted = executed.block.state.tilt.is_some();
                let axis_rad = if tilted { PLANE_AXIS_RAD } else { SAME_AXIS_RAD };
                let forward = oracle.forward(&values[..M::AXES.len()]);
                assert_same(&context, &forward, &leg.pose(share), SAME_TIP_MM, axis_rad);
                compared += 1;
            }
        }
    });
    compared
}

#[test]
fn axis_values_of_a_leg_give_its_pose() {
    let (mut programs, mut compared) = (0, 0);
    for path in golden_programs() {
        let golden = &Golden::read(&path);
        let count = with_machine!(&*golden.machine, posed(golden));
        assert!(count > 20, "{}: {count} poses", golden.name);
        (programs, compared) = (programs + 1, compared + count);
    }
    assert!(programs >= 110 && compared > 20_000, "{programs} programs, {compared} poses");
}

/// Whether words mean the same in two states.
fn is_one_frame(one: &State, other: &State) -> bool {
    (one.tool, one.length, one.work_offset, one.tip_control)
        == (other.tool, other.length, other.work_offset, other.tip_control)
        && one.tilt.map(|tilt| (tilt.rotation, tilt.origin)) == other.tilt.map(|tilt| (tilt.rotation, tilt.origin))
}

/// Legs that begin where the one before has ended.
fn continued<M: Machine>(golden: &Golden) -> usize {
    let mut last: Option<(Pose, State, bool)> = None;
    let mut compared = 0;
    golden.observed::<M>(&golden.program, |executed| {
        let block = executed.block;
        let elsewhere = !matches!(
            block.action,
            Action::Nothing | Action::Dwell(_) | Action::Rapid | Action::Feed | Action::Arc(_) | Action::Cycle(_)
        );
        if elsewhere || !is_one_frame(executed.before, &block.state) {
            last = None;
        }
        for leg in executed.legs() {
            if let Some((end, state, arc)) = &last
                && is_one_frame(state, &block.state)
            {
                let context = format!("{}, line {}", golden.name, block.line);
                let room = if *arc { ARC_END_MM } else { SAME_TIP_MM };
                assert_same(&context, end, &leg.pose(0.0), room, SAME_AXIS_RAD);
                compared += 1;
            }
            last = Some((leg.pose(1.0), block.state, leg.sweep() != 0.0));
        }
    });
    compared
}

#[test]
fn a_leg_begins_where_the_one_before_has_ended() {
    let mut compared = 0;
    for path in golden_programs() {
        let golden = &Golden::read(&path);
        let count = with_machine!(&*golden.machine, continued(golden));
        assert!(count > 5, "{}: {count} legs", golden.name);
        compared += count;
    }
    assert!(compared > 8000, "{compared} legs");
}

/// Blocks that move.
fn counted<M: Machine>(golden: &Golden) -> u64 {
    let (mut blocks, mut line) = (0, 0);
    let checked = golden.observed::<M>(&golden.program, |executed| {
        assert!(executed.block.line > line, "{}: line {} after {line}", golden.name, executed.block.line);
        line = executed.block.line;
        assert_eq!(executed.findings, 0, "{}, line {line}", golden.name);
        blocks += u64::from(executed.block.action.moves());
    });
    assert!(checked.outcome.passed(), "{}: {:?}", golden.name, checked.outcome.findings);
    assert_eq!(blocks, checked.outcome.blocks, "{}", golden.name);
    blocks
}

#[test]
fn every_block_is_executed_once_in_the_order_of_its_lines() {
    for path in golden_programs() {
        let golden = &Golden::read(&path);
        assert!(with_machine!(&*golden.machine, counted(golden)) > 0, "{}", golden.name);
    }
}

/// Moves the end of a cut off its path, and finds the block.
fn edited<M: Machine>(golden: &Golden) -> usize {
    let mut cuts = Vec::new();
    let mut last = [0.0; 9];
    golden.observed::<M>(&golden.program, |executed| {
        let block = executed.block;
        let travel = |index: &usize| (block.values[*index] - last[*index]).abs();
        let written =
            |index: &usize| block.written & (1 << index) != 0 && matches!(M::AXES[*index].letter, 'X' | 'Y' | 'Z');
        let mut axes: Vec<usize> = (0..M::AXES.len()).filter(written).collect();
        axes.sort_by(|one, other| travel(one).total_cmp(&travel(other)));
        // Off the path, and not along it.
        if let [least, .., most] = axes[..]
            && block.action == Action::Feed
            && travel(&least) < 0.7 * travel(&most)
        {
            cuts.push((block.line, M::AXES[least].letter));
        }
        last = block.values;
    });
    let lines: Vec<&str> = golden.program.lines().collect();
    let mut edits = 0;
    for (line, letter) in cuts {
        let index = line as usize - 1;
        let Some(word) = lines[index].split(' ').find(|word| word.starts_with(letter)) else { continue };
        let (letter, number) = word.split_at(1);
        let Ok(number) = number.trim_start_matches('+').parse::<f64>() else { continue };
        let plus = if word.contains('+') && number > -1.0 { "+" } else { "" };
        let off = format!("{letter}{plus}{:.3}", number + 1.3);
        let changed = lines[index].replacen(word, &off, 1);
        let program: String = lines
            .iter()
            .enumerate()
            .map(|(at, text)| if at == index { changed.clone() } else { (*text).to_owned() } + "\n")
            .collect();
        let mut found = Vec::new();
        let checked = golden.observed::<M>(&program, |executed| {
            if executed.findings > 0 {
                found.push(executed.block.line);
            }
        });
        assert!(!checked.outcome.passed(), "{}, line {line}: {changed} is not found", golden.name);
        assert_eq!(
            found.first(),
            Some(&line),
            "{}, line {line}: {changed}: {:?}",
            golden.name,
            checked.outcome.findings
        );
        edits += 1;
        if edits == 3 {
            break;
        }
    }
    edits
}

#[test]
fn a_cut_off_its_path_is_found_at_its_block() {
    let mut edits = 0;
    for path in golden_programs() {
        let golden = &Golden::read(&path);
        edits += with_machine!(&*golden.machine, edited(golden));
    }
    assert!(edits > 250, "{edits} edits");
}

#[test]
fn a_leg_begins_where_the_one_before_has_ended_where_the_tool_axis_is_a_vector() {
    let mut compared = 0;
    for path in golden_programs() {
        let mut golden = Golden::read(&path);
        let vectors = matches!(golden.control.spellings().name, "fanuc" | "siemens" | "heidenhain");
        if golden.mode != Mode::Tcp || !vectors {
            continue;
        }
        golden.keys =
            format!("tcp_words = \"vectors\"\ntool_posture = \"plane\"\ntcp_confirmed = true\n{}", golden.keys);
        let golden = &mut golden;
        with_machine!(&*golden.machine, repost(golden));
        compared += with_machine!(&*golden.machine, continued(golden));
    }
    assert!(compared > 500, "{compared} legs");
}

/// Posts the program again with the keys that it has now.
fn repost<M: Machine>(golden: &mut Golden) {
    let config = golden.config::<M>();
    let job = post::Job { cl_name: "part.cls", config: &config, control: golden.control, units: None };
    let mut program = Vec::new();
    let report = post::post::<M>(&job, &mut Cursor::new(&golden.cl), &mut program).expect("it can be written");
    assert!(!report.failed, "{}: {:?}", golden.name, report.diagnostics);
    golden.program = String::from_utf8(program).expect("ASCII");
}
