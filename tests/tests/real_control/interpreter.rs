//! Golden programs for LinuxCNC, run by its own interpreter: straight motions, arcs, holes and threads are those that
//! the product's reader finds.

use std::fs;
use std::path::{Path, PathBuf};
use std::slice::Iter;

use approx::abs_diff_eq;
use machines::SpinnerU5620;
use pp_runtime::check::blocks;
use pp_runtime::check::read::{Action, ArcMove, Block, CycleKind, CycleMove};
use pp_runtime::config::{Config, starting_point};
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::program::Units;
use tests::binaries::{binary, workspace};
use tests::by_name;
use tests::linuxcnc::installed;
use tests::linuxcnc::interpreter::{CanonArc, Motion, PRINTED, interpret, motions};
use tests::with_machine;

/// Numbers of motions that have been compared.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Compared {
    straight: usize,
    arcs: usize,
    holes: usize,
    /// Holes that are threads.
    threads: usize,
}

fn read<M: Machine>(program: &str, units: Units) -> Vec<Block> {
    let control = by_name::control("linuxcnc");
    let config = Config { output_units: Some(units), ..starting_point(control) };
    blocks::<M>(
        &config.check_policy::<M>(control, None).expect("the configuration suits control and machine"),
        program.as_bytes(),
    )
    .expect("it can be read")
}

/// Comparison of the motions that the interpreter finds, in order, with the blocks of the product's reader.
struct Comparison<'m, M: Machine> {
    theirs: Iter<'m, Motion>,
    /// mm per unit of the program.
    unit: f64,
    context: String,
    compared: Compared,
    machine: std::marker::PhantomData<M>,
}

impl<M: Machine> Comparison<'_, M> {
    fn next(&mut self) -> Motion {
        *self.theirs.next().unwrap_or_else(|| panic!("{}: the interpreter has no motion", self.context))
    }

    fn block(&mut self, block: &Block) {
        match block.action {
            Action::Rapid | Action::Feed | Action::Machine => {
                let feed = block.action == Action::Feed;
                let (is_feed, end) = match self.next() {
                    Motion::Traverse(end) => (false, end),
                    Motion::Feed(end) => (true, end),
                    other => panic!("{}: {other:?} is no straight motion", self.context),
                };
                assert_eq!(is_feed, feed, "{}", self.context);
                if block.action != Action::Machine {
                    self.end(block, &end, "XYZABC");
                }
                self.compared.straight += 1;
            }
            Action::Arc(ours) => {
                let Motion::Arc(arc) = self.next() else { panic!("{}: no arc", self.context) };
                self.end(block, &arc.end, "XYZABC");
                self.arc(block, &ours, &arc);
                self.compared.arcs += 1;
            }
            Action::Cycle(CycleMove { kind: CycleKind::Tap(_), bottom, .. }) => {
                let Motion::Tap([x, y, z]) = self.next() else { panic!("{}: no thread", self.context) };
                self.end(block, &[x, y, z, 0.0, 0.0, 0.0], "XY");
                self.same("the bottom of the thread", bottom / self.unit, z);
                self.compared.holes += 1;
                self.compared.threads += 1;
            }
            Action::Cycle(cycle) => {
                self.hole(block, &cycle);
                self.compared.holes += 1;
            }
            _ => {}
        }
    }

    fn same(&self, what: &str, ours: f64, theirs: f64) {
        let context = &self.context;
        let same = abs_diff_eq!(ours, theirs, epsilon = PRINTED);
        assert!(same, "{context}: {what}: reader {ours}, interpreter {theirs}");
    }

    /// Compares the end of a block, for every axis of `letters` whose position is known.
    fn end(&self, block: &Block, theirs: &[f64; 6], letters: &str) {
        let known = |index: &usize| block.known & (1 << index) != 0;
        let axes = M::AXES.iter().enumerate().filter(|(index, axis)| known(index) && letters.contains(axis.letter));
        for (index, axis) in axes {
            let place = "XYZABC".find(axis.letter).expect("one of the six");
            let ours = match axis.kind {
                AxisKind::Linear => block.values[index] / self.unit,
                AxisKind::Rotary => block.values[index].to_degrees(),
            };
            self.same(&axis.letter.to_string(), ours, theirs[place]);
        }
    }

    /// Compares plane, centre, sense and revolutions of an arc.
    fn arc(&self, block: &Block, ours: &ArcMove, theirs: &CanonArc) {
        assert_eq!(block.state.plane, Some(theirs.plane), "{}", self.context);
        let [first, second, _] = theirs.plane.axes();
        for (axis, there) in [first, second].into_iter().zip(theirs.centre) {
            self.same("the centre", ours.centre[axis] / self.unit, there);
        }
        let turns = (ours.sweep.abs() / std::f64::consts::TAU - 1e-9).ceil().copysign(ours.sweep);
        assert_eq!(turns as i32, theirs.turns, "{}: reader {ours:?}, interpreter {theirs:?}", self.context);
    }

    /// Compares the motions of one cycle: down to its bottom and no deeper, and back to its return level.
    fn hole(&mut self, block: &Block, cycle: &CycleMove) {
        let [bottom, back_to] = [cycle.bottom, cycle.back_to].map(|level| level / self.unit);
        let mut deep = false;
        for motion in self.theirs.by_ref() {
            let (Motion::Traverse(end) | Motion::Feed(end)) = *motion else {
                panic!("{}: {motion:?} in a hole", self.context)
            };
            let z = end[2];
            assert!(z >= bottom - PRINTED, "{}: Z{z} is below the bottom of the hole, Z{bottom}", self.context);
            deep |= z <= bottom + PRINTED;
            if deep && (z - back_to).abs() <= PRINTED {
                return self.end(block, &end, "XYABC");
            }
        }
        panic!("{}: the hole does not end at Z{back_to}, or is not Z{bottom} deep", self.context);
    }
}

/// Compares every motion of a program with its block by the product's reader, which reads `read_text`.
fn compare_texts<M: Machine>(name: &str, text: &str, read_text: &str) -> Compared {
    let units = if text.contains("UNITS in") { Units::Inches } else { Units::Millimetres };
    let calls = interpret(text, 0.0).unwrap_or_else(|errors| panic!("{name}: {errors}"));
    let theirs = motions(&calls);
    let mut comparison = Comparison::<M> {
        theirs: theirs.iter(),
        unit: units.in_mm(),
        context: String::new(),
        compared: Compared::default(),
        machine: std::marker::PhantomData,
    };
    for block in read::<M>(read_text, units).iter().filter(|block| block.written != 0) {
        comparison.context = format!("{name} line {}", block.line);
        comparison.block(block);
    }
    assert_eq!(comparison.theirs.next(), None, "{name}: a motion without a block");
    comparison.compared
}

fn compare_on(machine: &str, name: &str, text: &str) -> Compared {
    with_machine!(machine, compare_texts(name, text, text))
}

/// Every golden program for LinuxCNC, and its machine.
fn goldens() -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for part in fs::read_dir(workspace().join("tests/data")).expect("the folder of the parts") {
        for file in fs::read_dir(part.expect("a part").path()).expect("the folder of a part") {
            let path = file.expect("a file").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            found.extend(name.strip_suffix(".linuxcnc.nc").map(|machine| (path.clone(), machine.to_owned())));
        }
    }
    found.sort();
    found
}

#[test]
fn interpreter_and_reader_agree_on_every_motion_of_every_golden_program() {
    if !installed() {
        return;
    }
    let mut all = Compared::default();
    let goldens = goldens();
    for (path, machine) in &goldens {
        let text = fs::read_to_string(path).expect("a program");
        let compared = compare_on(machine, &path.display().to_string(), &text);
        all.straight += compared.straight;
        all.arcs += compared.arcs;
        all.holes += compared.holes;
        all.threads += compared.threads;
    }
    println!("{} programs: {all:?}", goldens.len());
    assert!(goldens.len() >= 31, "{} programs", goldens.len());
    assert!(all.straight > 1500 && all.arcs >= 40 && all.holes >= 20 && all.threads >= 4, "{all:?}");
}

/// A circle: its centre, start and end, mm, and its axis.
type Circle = [[f64; 3]; 4];

const CIRCLES: [Circle; 5] = [
    // In the plane XY, in both senses, and one of more than half a revolution.
    [[10.0, 0.0, -2.0], [20.0, 0.0, -2.0], [10.0, 10.0, -2.0], [0.0, 0.0, 1.0]],
    [[10.0, 0.0, -2.0], [10.0, 10.0, -2.0], [0.0, 0.0, -2.0], [0.0, 0.0, -1.0]],
    [[0.0, 6.0, -2.0], [0.0, 0.0, -2.0], [-6.0, 6.0, -2.0], [0.0, 0.0, 1.0]],
    // In the planes ZX and YZ.
    [[-6.0, 6.0, 8.0], [-6.0, 6.0, -2.0], [-16.0, 6.0, 8.0], [0.0, 1.0, 0.0]],
    [[-16.0, 0.0, 8.0], [-16.0, 6.0, 16.0], [-16.0, 10.0, 8.0], [-1.0, 0.0, 0.0]],
];

/// A part of arcs in all three planes.
fn arcs_in_three_planes() -> String {
    let point = |[x, y, z]: [f64; 3]| format!("GOTO/{x:.4},{y:.4},{z:.4},0.0,0.0,1.0\n");
    let mut cl = "UNITS/MM\nTOOL PATH/ARCS\nLOADTL/1\nSPINDL/RPM,4000,CLW\nFEDRAT/MMPM,200\n".to_owned();
    for [centre, from, to, axis] in CIRCLES {
        let radius = (0..3).map(|index| (from[index] - centre[index]).powi(2)).sum::<f64>().sqrt();
        let numbers: Vec<String> = centre.iter().chain(&axis).map(|number| format!("{number:.7}")).collect();
        cl += &point(from);
        cl += &format!("CIRCLE/{},{radius:.4},0.0600,0.5000,10.0000,0.0000\n", numbers.join(","));
        cl += &point(to);
    }
    cl + "END-OF-PATH\nFINI\n"
}

fn posted(machine: &str, cl: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("part.cls");
    fs::write(&path, cl).expect("a file");
    // These circles do not come from a CAM system: only this option sets their sense.
    let output = binary(machine).args(["post", "--circle-sense", "ccw"]).arg(&path).output().expect("the binary runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("ASCII")
}

#[test]
fn interpreter_and_reader_agree_on_arcs_in_every_plane() {
    if !installed() {
        return;
    }
    // Straight and mirrored words.
    for machine in ["spinner-u5-620", "multiprodesk"] {
        let text = posted(machine, &arcs_in_three_planes());
        assert!(text.contains("G18") && text.contains("G19"), "{text}");
        assert_eq!(compare_on(machine, machine, &text).arcs, CIRCLES.len(), "{text}");
    }
}

/// Message of the comparison when the reader gets a changed program.
fn difference(path: &Path, from: &str, to: &str) -> Option<String> {
    let text = fs::read_to_string(path).expect("a program");
    assert!(text.contains(from), "{} has no {from}", path.display());
    let damaged = text.replacen(from, to, 1);
    let compared = std::panic::catch_unwind(|| compare_texts::<SpinnerU5620>("damaged", &text, &damaged));
    compared.err().map(|message| message.downcast_ref::<String>().cloned().unwrap_or_default())
}

#[test]
fn every_difference_is_found() {
    if !installed() {
        return;
    }
    let blade = workspace().join("tests/data/blade/spinner-u5-620.linuxcnc.nc");
    assert_eq!(difference(&blade, "X-15.815", "X-15.815"), None);
    let message = difference(&blade, "X-15.815", "X-15.915").expect("a tenth");
    assert!(message.contains("X: reader -15.915, interpreter -15.815"), "{message}");
    let works = workspace().join("tests/data/works/spinner-u5-620.linuxcnc.nc");
    for (from, to, what) in [
        ("G3 X-20 Y-12 I0 J-12", "G2 X-20 Y-12 I0 J-12", "interpreter"),
        ("Z-0.4 I-12 J0", "Z-0.4 I-12.01 J0", "the centre: reader"),
        ("G3 X12 Y0 Z-0.4", "G3 X12 Y0 Z-0.41", "Z: reader"),
        ("G33.1 Z-10 K1", "G33.1 Z-10.1 K1", "the bottom of the thread"),
    ] {
        let message = difference(&works, from, to).unwrap_or_else(|| panic!("{to} passes"));
        assert!(message.contains(what), "{to}: {message}");
    }
}
