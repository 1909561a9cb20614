//! Every golden program is executed by the foreign interpreter: it runs to its end, and its motions are those that the
//! product's own reader finds.
//!
//! The two readers share no code; the comparison is in [`tests::agreement`].

use std::fs;
use std::path::Path;

use pp_runtime::config::starting_point;
use pp_runtime::kinematics::Machine;
use tests::agreement::{self, Compared};
use tests::binaries::{config_of, golden_programs};
use tests::by_name;
use tests::foreign::{Control, Effect, Options, Trace, run};
use tests::with_machine;

/// Machine and control in the name of a golden program.
fn names(path: &Path) -> (String, Control) {
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let (machine, control) = name.split_once('.').expect("machine and control");
    (machine.to_owned(), Control::by_name(control).expect("a control"))
}

fn traced(path: &Path) -> (String, Trace) {
    let text = fs::read_to_string(path).expect("ASCII");
    let (_, control) = names(path);
    let trace = run(&text, &Options::of(control)).unwrap_or_else(|refused| panic!("{}: {refused}", path.display()));
    (text, trace)
}

/// Compares every motion of a program and returns their number.
fn compare<M: Machine>(path: &Path) -> usize {
    let text = fs::read_to_string(path).expect("ASCII");
    let (machine, foreign) = names(path);
    let control = by_name::control(foreign.name());
    let (config, mode) = config_of(path, &machine);
    let mut config = starting_point(control).read_over(&M::default(), &config).expect("a configuration");
    config.motion.mode = mode;
    let compared = agreement::compare::<M>(&text, (&config, control), &Options::of(foreign), Compared::ALL);
    compared.unwrap_or_else(|why| panic!("{}, {why}", path.display()))
}

#[test]
fn both_readers_find_the_same_motions_in_every_golden_program() {
    let (mut programs, mut motions) = (0, 0);
    for path in golden_programs() {
        motions += with_machine!(&*names(&path).0, compare(&path));
        programs += 1;
    }
    assert!(programs >= 110 && motions > 10_000, "{programs} programs, {motions} motions");
}

#[test]
fn a_truncated_golden_program_is_refused() {
    for path in golden_programs() {
        let (text, trace) = traced(&path);
        let end = trace.blocks.iter().rfind(|block| block.effect == Effect::End).expect("an end").line;
        let options = Options::of(names(&path).1);
        let short: String = text.split_inclusive('\n').take(end - 1).collect();
        assert!(run(&short, &options).is_err(), "{} without its end", path.display());
    }
}
