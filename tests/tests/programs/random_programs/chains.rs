//! Chains of every kind on random set-ups: three linear axes with rotary ones before, between and after them, in the
//! table, in the head and in both. Each is posted in each mode and for each control; what is posted passes its check
//! and has the motions that the foreign interpreter finds, and what is refused has a reason.
//!
//! `PP_CHAINS=N` sets the number of jobs for each chain, control and mode, `PP_CHAINS_SEED=S` the first seed.

use pp_conformance::conformance::{Fault, find_fault};

use super::cl::AxisRange;
use super::*;

/// A chain and how its jobs are posted.
struct Subject {
    kind: &'static MachineKind,
    post: fn(&Case) -> Outcome,
    /// The first fault of its kinematics in so many poses.
    fault: fn(usize) -> Option<Fault>,
}

impl Subject {
    fn of<M: Machine>(name: &'static str, axis_range: AxisRange) -> Self {
        let rotary = || M::AXES.iter().filter(|axis| axis.kind == AxisKind::Rotary);
        let kind = MachineKind {
            name,
            rotaries: rotary().map(|axis| axis.letter).collect::<Vec<char>>().leak(),
            travel: &[],
            endless: &[],
            axis_range,
            table: rotary().any(|axis| axis.side == Side::Workpiece),
            head: rotary().any(|axis| axis.side == Side::Tool),
        };
        Self { kind: Box::leak(Box::new(kind)), post: run::<M>, fault: find_fault::<M> }
    }
}

/// Declares a machine per line: `name: [chain] [points of d] [signs] [tool axes of its jobs];`.
macro_rules! chains {
    ($($name:ident: [$($chain:tt)*] [$($points:tt)*] [$($signs:tt)*] [$range:expr];)*) => {
        $(
            mod $name {
                pp_runtime::machine! {
                    pub(super) struct Chain;
                    chain: $($chain)*;
                    d = { $($points)* };
                    signs = { $($signs)* };
                }
            }
        )*

        fn subjects() -> Vec<Subject> {
            vec![$(Subject::of::<$name::Chain>(stringify!($($chain)*), $range)),*]
        }
    };
}

/// Tool axes that every machine of two perpendicular rotary axes reaches.
const TILTED: AxisRange = AxisRange::UpTo(40);

chains! {
    x_yzab: [X | Y Z A B] [A: (-30, -13.5, -136.5), B: (13.5, 9.75, -15.75)] [X: +] [TILTED];
    xzyb_a: [X Z Y B | A] [B: (-16.5, -7.5, -10.5), A: (27, -12, 110.25)] [X: -] [TILTED];
    xaz_yb: [X A Z | Y B] [A: (-3, -1.5, 115.5), B: (-21, -6, -42)] [X: -] [TILTED];
    xb_zay: [X B | Z A Y] [B: (10.5, 4.5, -36.75), A: (-7.5, 0, 84)] [B: +] [TILTED];
    y_xbza: [Y | X B Z A] [B: (24, 10.5, 89.25), A: (6, 6, -68.25)] [X: -] [TILTED];
    yzba_x: [Y Z B A | X] [B: (-24, -11.25, -63), A: (19.5, 12, 57.75)] [B: -] [TILTED];
    ybx_za: [Y B X | Z A] [B: (-10.5, -5.25, 63), A: (-28.5, -9.75, -94.5)] [X: +] [TILTED];
    zx_yba: [Z X | Y B A] [B: (3, 0.75, -89.25), A: (-15, -3.75, 31.5)] [Y: -] [TILTED];
    z_yaxb: [Z | Y A X B] [A: (16.5, 6.75, 36.75), B: (-1.5, 2.25, -120.75)] [X: -] [TILTED];
    zayb_x: [Z A Y B | X] [A: (30, 12.75, -115.5), B: (12, 8.25, 5.25)] [B: +] [TILTED];
    zba_xy: [Z B A | X Y] [B: (-18, -9, 10.5), A: (25.5, -13.5, 131.25)] [Y: -] [TILTED];
    ax_bzy: [A X | B Z Y] [A: (-4.5, -3, 136.5), B: (-22.5, -7.5, -21)] [Y: -] [TILTED];
    a_zxyb: [A | Z X Y B] [A: (9, 3, -15.75), B: (-9, -1.5, 105)] [B: +] [TILTED];
    abxz_y: [A B X Z | Y] [A: (22.5, 9, 110.25), B: (4.5, 4.5, -47.25)] [A: -] [TILTED];
    bxz_ya: [B X Z | Y A] [B: (-25.5, -12.75, -42), A: (18, 10.5, 78.75)] [B: -] [TILTED];
    by_zax: [B Y | Z A X] [B: (-12, -6.75, 84), A: (-30, -11.25, -73.5)] [Y: +] [TILTED];
    b_zaxy: [B | Z A X Y] [B: (1.5, -0.75, -68.25), A: (-16.5, -5.25, 52.5)] [Z: -] [TILTED];
    bazy_x: [B A Z Y | X] [B: (15, 5.25, 57.75), A: (-3, 0.75, -99.75)] [A: -] [TILTED];
    xcy_za: [X C Y | Z A] [C: (28.5, 11.25, -94.5), A: (10.5, 6.75, 26.25)] [Y: +] [TILTED];
    yx_cza: [Y X | C Z A] [C: (-19.5, -10.5, 31.5), A: (24, 12.75, -126)] [C: -] [TILTED];
    y_czxa: [Y | C Z X A] [C: (-6, -4.5, -120.75), A: (-24, -9, 0)] [X: -] [TILTED];
    zyxc_a: [Z Y X C | A] [C: (7.5, 1.5, 5.25), A: (-10.5, -3, 126)] [C: +] [TILTED];
    zca_xy: [Z C A | X Y] [C: (21, 7.5, 131.25), A: (3, 3, -26.25)] [X: -] [TILTED];
    cx_azy: [C X | A Z Y] [C: (-27, 13.5, -21), A: (16.5, 9, 99.75)] [Y: -] [TILTED];
    c_zxya: [C | Z X Y A] [C: (-13.5, -8.25, 105), A: (30, -12.75, -52.5)] [A: +] [TILTED];
    caxz_y: [C A X Z | Y] [C: (0, -2.25, -47.25), A: (-18, -6.75, 73.5)] [C: -] [TILTED];
    xyc_bz: [X Y C | B Z] [C: (13.5, 3.75, 78.75), B: (-4.5, -0.75, -78.75)] [X: -] [TILTED];
    xc_zby: [X C | Z B Y] [C: (27, 9.75, -73.5), B: (9, 5.25, 47.25)] [X: +] [TILTED];
    y_zcxb: [Y | Z C X B] [C: (-21, -12, 52.5), B: (22.5, 11.25, -105)] [Z: -] [TILTED];
    ycbz_x: [Y C B Z | X] [C: (-7.5, -6, -99.75), B: (-25.5, -10.5, 21)] [C: -] [TILTED];
    zcx_yb: [Z C X | Y B] [C: (6, 0, 26.25), B: (-12, -4.5, -131.25)] [X: +] [TILTED];
    cx_ybz: [C X | Y B Z] [C: (19.5, 6, -126), B: (1.5, 1.5, -5.25)] [Y: -] [TILTED];
    c_yzxb: [C | Y Z X B] [C: (-28.5, 12, 0), B: (15, 7.5, 120.75)] [Z: -] [TILTED];
    czyb_x: [C Z Y B | X] [C: (-15, -9.75, 126), B: (28.5, 13.5, -31.5)] [B: +] [TILTED];
    cbz_xy: [C B Z | X Y] [C: (-1.5, -3.75, -26.25), B: (-19.5, -8.25, 94.5)] [X: -] [TILTED];
    quill: [X Y | B Z] [B: (0, 0, 300)] [B: +] [AxisRange::Vertical];
    swing: [X A Y | Z] [A: (0, 20, -60)] [A: -] [AxisRange::AboutX];
    tilting: [X Y | A Z] [A: (0, 0, 250)] [A: +] [AxisRange::AboutX];
    rotary: [A X Y | Z] [A: (0, 0, -80)] [A: -] [AxisRange::AboutX];
    turning: [X Y | C Z A] [C: (10, 0, 0), A: (0, 5, 120)] [C: +] [TILTED];
}

/// Whether C is between X and Y: with C at 90 degrees the two are parallel.
fn may_be_parallel(chain: &str) -> bool {
    let order: String = chain.chars().filter(|letter| matches!(letter, 'X' | 'Y' | 'C')).collect();
    matches!(&*order, "XCY" | "YCX")
}

/// Poses of each chain that are compared with the product of its matrices.
const POSES: usize = 1_000;

/// The proven kinematics of each chain are those of its declared joints: poses are found, solved or out of reach, and
/// rates and bounds are those of the matrices.
#[test]
fn the_kinematics_of_every_chain_are_the_product_of_its_matrices() {
    for subject in subjects() {
        let fault = (subject.fault)(POSES);
        assert!(
            fault.is_none(),
            "{}: {}",
            subject.kind.name,
            fault.map_or_else(String::new, |fault| fault.to_string())
        );
    }
}

/// Number of jobs for each chain, control and mode.
const JOBS: u64 = 1;

#[test]
fn every_chain_is_posted_in_each_mode_for_each_control() {
    let jobs = environment::number("PP_CHAINS").unwrap_or(JOBS);
    let first = environment::number("PP_CHAINS_SEED").unwrap_or(1);
    let (mut passed, mut wrong, mut never) = (0, Vec::new(), Vec::new());
    let mut refused: BTreeMap<String, (usize, String)> = BTreeMap::new();
    for (index, subject) in subjects().iter().enumerate() {
        let mut of_chain = 0;
        for control in control::CONTROLS {
            for mode in [Mode::Axes, Mode::Tcp, Mode::Plane, Mode::Auto] {
                for job in 0..jobs {
                    let seed = first + (index as u64 * 1_000 + job) * 1_000;
                    let case = Case::on(subject.kind, *control, mode, seed);
                    let post = || (subject.post)(&case);
                    let outcome = catch_unwind(AssertUnwindSafe(post))
                        .unwrap_or_else(|_| Outcome::Wrong("a panic".to_owned(), Vec::new()));
                    match outcome {
                        Outcome::Passed(_) => of_chain += 1,
                        Outcome::Unsuited(_) => {}
                        Outcome::Refused(reason) => {
                            let example = || (0, format!("{} seed {seed}: {reason}", case.name()));
                            refused.entry(fault_kind(&reason)).or_insert_with(example).0 += 1;
                        }
                        Outcome::Wrong(text, program) => {
                            wrong.push(format!("{} seed {seed}: {text}", case.name()));
                            if environment::number("PP_CHAINS").is_some() {
                                println!("{}\n{}\n{}", case.set_up, case.cl, String::from_utf8_lossy(&program));
                            }
                        }
                    }
                }
            }
        }
        if of_chain == 0 && !may_be_parallel(subject.kind.name) {
            never.push(subject.kind.name);
        }
        passed += of_chain;
    }
    let mut reasons: Vec<_> = refused.values().collect();
    reasons.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    reasons.iter().for_each(|(count, example)| println!("{count:5} refused, for example {example}"));
    let count = passed + wrong.len() + refused.values().map(|(count, _)| count).sum::<usize>();
    println!("{passed} of {count} are posted");
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(never.is_empty(), "never posted: {never:?}");
    assert!(2 * passed >= count, "only {passed} of {count} are posted");
}
