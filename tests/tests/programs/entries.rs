//! Between the machine retract and the approach point the retract axis moves alone, and last: in every golden program,
//! for every control in every mode.
//!
//! A rapid need not be straight, and its axes arrive in any order. Where the others have arrived before the retract
//! axis leaves its retract position, no order takes the tool below the approach point. The programs are executed by the
//! foreign interpreter, and their words converted to axis values by the oracle.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use nalgebra::{Matrix3, Point3, Vector3};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::kinematics::{AxisKind, Machine, Side};
use tests::binaries::{config_of, golden_programs};
use tests::by_name;
use tests::foreign::axes::{Axes, is_rotary};
use tests::foreign::state::State;
use tests::foreign::{Control, Effect, Executed, Options, run};
use tests::oracle::Oracle;
use tests::with_machine;

/// Largest motion of another axis while the retract axis moves down, mm: two units of the words, and a thousandth of a
/// degree of a plane at the distance of the part.
const TOGETHER_MM: f64 = 3e-3;

/// Counts of the entries that were compared.
#[derive(Debug, Default)]
struct Entries {
    axes: usize,
    tip: usize,
    plane: usize,
    moved_zero: usize,
}

/// A machine in its set-up, with the words of a program.
struct Converter<M: Machine> {
    machine: M,
    config: Config,
    letters: Vec<char>,
    signs: [f64; 3],
    /// Words of the rotary axes, degrees: a plane call leaves them where they are.
    rotary: Axes,
}

impl<M: Machine> Converter<M> {
    fn new(path: &Path, machine: &str, control: Control) -> Self {
        let (keys, mode) = config_of(path, machine);
        let control = by_name::control(control.name());
        let mut config = starting_point(control).read_over(&M::default(), &keys).expect("a configuration");
        config.motion.mode = mode;
        let machine = config.set_up.machine::<M>().expect("a valid machine");
        let letters: Vec<char> = M::AXES.iter().map(|axis| axis.letter).collect();
        let signs = ['X', 'Y', 'Z'].map(|letter| {
            let index = letters.iter().position(|known| *known == letter).expect("a linear axis");
            machine.joint(index).sign
        });
        Self { machine, config, letters, signs, rotary: Axes::default() }
    }

    /// Axis values of a position in the state of a block.
    fn axis_values(&mut self, state: &State, words: &dyn Fn(char) -> f64) -> Vec<f64> {
        let known = self.rotary;
        let words = &|letter: char| known.get(letter).unwrap_or_else(|| words(letter));
        let length = state.tool.and_then(|tool| self.config.set_up.tools.get(&tool)?.length_mm).unwrap_or(0.0);
        self.machine.set_up(self.config.set_up.part_origin.into(), length);
        let oracle = Oracle::of(&self.machine);
        let mut values: Vec<f64> = self
            .letters
            .iter()
            .zip(M::AXES)
            .map(|(letter, axis)| match axis.kind {
                AxisKind::Linear => words(*letter),
                AxisKind::Rotary => words(*letter) * PI / 180.0,
            })
            .collect();
        let signs = Matrix3::from_diagonal(&Vector3::from(self.signs));
        let xyz = Vector3::from(['X', 'Y', 'Z'].map(words));
        if state.under_tip_control() {
            oracle.bring_tip_to(&Point3::from(signs * xyz), &mut values);
        } else if let Some(plane) = state.tilted_plane() {
            let rotation = Matrix3::from_fn(|row, column| plane.rotation[row][column]);
            let point = rotation * xyz + Vector3::from(plane.origin);
            oracle.bring_tip_to(&Point3::from(signs * point), &mut values);
        } else if state.dynamic_offset {
            oracle.bring_tip_to(&Point3::origin(), &mut values);
            for (letter, value) in ['X', 'Y', 'Z'].into_iter().zip(xyz.iter()) {
                let index = self.letters.iter().position(|known| *known == letter).expect("a linear axis");
                values[index] += value;
            }
        }
        values
    }

    /// Axis values of X and Y after a block, if they do not depend on the position of the retract axis.
    fn across(&mut self, block: &Executed) -> Option<[f64; 2]> {
        let position = block.state.position;
        let index = ['X', 'Y'].map(|letter| self.letters.iter().position(|known| *known == letter).expect("an axis"));
        let mut at = |height: f64| {
            let word = |letter: char| if letter == 'Z' { height } else { position.get(letter).unwrap_or(f64::NAN) };
            let values = self.axis_values(&block.state, &word);
            index.map(|index| values[index])
        };
        let (low, high) = (at(0.0), at(100.0));
        // An axis of unknown position is not a number.
        low.iter().zip(high).all(|(low, high)| (low - high).abs() < TOGETHER_MM).then_some(low)
    }

    /// Axis values of X and Y at the end of a block.
    fn at_end(&mut self, block: &Executed) -> [f64; 2] {
        let position = block.state.position;
        let values = self.axis_values(&block.state, &|letter| position.get(letter).expect("a known position"));
        ['X', 'Y'].map(|letter| values[self.letters.iter().position(|known| *known == letter).expect("an axis")])
    }
}

fn compare<M: Machine>(path: &Path, machine: &str, control: Control, entries: &mut Entries) {
    let text = fs::read_to_string(path).expect("ASCII");
    let trace = run(&text, &Options::of(control)).unwrap_or_else(|refused| panic!("{}: {refused}", path.display()));
    let head = M::AXES.iter().any(|axis| axis.kind == AxisKind::Rotary && axis.side == Side::Tool && !axis.held);
    let mut converter = Converter::<M>::new(path, machine, control);
    let (mut retracted, mut across, mut offset) = (false, None, None);
    for block in &trace.blocks {
        let mut rotary = block.words;
        rotary.retain(is_rotary);
        converter.rotary.extend(&rotary);
        if *offset.get_or_insert(block.state.work_offset) != block.state.work_offset && block.effect.moves() {
            // A further set-up has another part origin.
            if block.state.work_offset.is_some() && offset != Some(None) {
                return;
            }
            offset = Some(block.state.work_offset);
        }
        entries.moved_zero += usize::from(block.state.dynamic_offset && block.effect == Effect::Rapid);
        match block.effect {
            Effect::Machine => {
                retracted = true;
                // As axis positions X and Y are where they were.
                let framed = block.state.under_tip_control() || block.state.tilted_plane().is_some();
                across = if framed { None } else { converter.across(block) };
            }
            Effect::Rapid if retracted => {
                let place = format!("{}, line {}", path.display(), block.line);
                let linear = block.words.letters().any(|letter| ['X', 'Y', 'Z'].contains(&letter));
                let rotary = block.words.letters().any(|letter| !['X', 'Y', 'Z'].contains(&letter));
                assert!(!(linear && rotary), "{place}: linear and rotary axes together");
                let tilted = block.state.tilted_plane().is_some();
                let down = linear && block.words.contains('Z');
                if linear && !down {
                    across = converter.across(block);
                    assert!(across.is_some() || head && tilted, "{place}: X and Y depend on Z, which is unknown");
                }
                if !down {
                    continue;
                }
                retracted = false;
                if head && tilted {
                    // The plane is not across the retract axis.
                    continue;
                }
                let end = converter.at_end(block);
                let before = across.unwrap_or_else(|| panic!("{place}: Z moves before X and Y"));
                let moved = before.iter().zip(end).map(|(before, end)| (before - end).abs()).fold(0.0, f64::max);
                assert!(moved < TOGETHER_MM, "{place}: X and Y move by {moved} mm while Z moves down");
                *match (block.state.under_tip_control(), tilted) {
                    (true, _) => &mut entries.tip,
                    (_, true) => &mut entries.plane,
                    _ => &mut entries.axes,
                } += 1;
            }
            _ => {}
        }
    }
}

#[test]
fn the_retract_axis_moves_alone_down_to_the_approach_point() {
    let mut entries = Entries::default();
    for path in golden_programs() {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let (machine, control) = name.split_once('.').expect("machine and control");
        let control = Control::by_name(control).expect("a control");
        with_machine!(machine, compare(&path, machine, control, &mut entries));
    }
    let Entries { axes, tip, plane, moved_zero } = entries;
    assert!(axes > 50 && tip > 50 && plane > 50 && moved_zero > 10, "{entries:?}");
}
