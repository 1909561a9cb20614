//! The course of the rotary axes, compared with an exhaustive search, for machines of every kind.
//!
//! Only the public interface is used: the branches of a pose, limits and speeds. Turns, costs and possible courses are
//! computed here independently.

use nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::config::Config;
use pp_runtime::inside::{self, Cost, Navigator, Source};
use pp_runtime::kinematics::{AxisKind, Branch, Limits, Machine, Pose};
use pp_runtime::program::{Event, Feed, Location, Move, NewStart, ToolCall, ToolMotion};
use tests::random::Random;

use machines::{Dmu70e, LolaXoyzba, SpinnerU5620};
use tests::further::{HeadTable, NutatingHead, Trunnion};

/// Units of rotary words per degree: a word counts ten thousandths of a degree.
const PER_DEGREE: f64 = 1e4;
/// One revolution, in units of rotary words.
const REVOLUTION: i64 = 3_600_000;

/// Rotation of an axis below which a cut stays on its branch, in units of rotary words.
const SAME_BRANCH: i64 = REVOLUTION / 4;

/// A branch, and the words of the two rotary axes.
type State = (Branch, [i64; 2]);

/// Limits and speeds of the two rotary axes.
struct RotaryLimits {
    /// Lower and upper limit, in units of rotary words.
    limits: [(i64, i64); 2],
    /// Rapid speeds, degrees per minute.
    speeds: Option<[f64; 2]>,
}

impl RotaryLimits {
    fn cost(&self, from: &State, to: &State) -> Cost {
        let travel = [0, 1].map(|axis| (to.1[axis] - from.1[axis]).unsigned_abs());
        let time = self.speeds.map_or(0, |speeds| {
            let minutes = |axis: usize| travel[axis] as f64 / PER_DEGREE / speeds[axis];
            let times = [0, 1].map(|axis| (minutes(axis) * 60e9).round() as u64);
            times[0].max(times[1])
        });
        Cost { time_ns: time, travel_units: travel[0] + travel[1], ..Cost::default() }
    }
}

fn sum(a: Cost, b: Cost) -> Cost {
    Cost {
        rewinds: a.rewinds + b.rewinds,
        against_preference: 0,
        time_ns: a.time_ns + b.time_ns,
        travel_units: a.travel_units + b.travel_units,
    }
}

/// Every state of a pose inside the limits.
fn states<M: Machine>(machine: &M, rotaries: [usize; 2], rotary_limits: &RotaryLimits, pose: &Pose) -> Vec<State> {
    let mut all = Vec::new();
    for solution in machine.inverse_kinematics(pose, &M::HELD).iter() {
        let word = |axis: usize| (solution.axes.as_ref()[rotaries[axis]].to_degrees() * PER_DEGREE).round() as i64;
        for a in (-5..=5).map(|turns| word(0) + turns * REVOLUTION) {
            for b in (-5..=5).map(|turns| word(1) + turns * REVOLUTION) {
                let inside = |word: i64, (lower, upper): (i64, i64)| lower <= word && word <= upper;
                if inside(a, rotary_limits.limits[0]) && inside(b, rotary_limits.limits[1]) {
                    all.push((solution.branch, [a, b]));
                }
            }
        }
    }
    all
}

/// Tries every choice recursively; abandons a course as soon as it costs as much as the best one.
fn search_exhaustively(
    rotary_limits: &RotaryLimits,
    layers: &[(Vec<State>, bool)],
    here: &State,
    before: &[State],
    cost: Cost,
    least: &mut Option<Cost>,
) {
    if least.is_some_and(|least| least <= cost) {
        return;
    }
    let Some(((states, air), rest)) = layers.split_first() else {
        *least = Some(cost);
        return;
    };
    let mut next: Vec<(Cost, State)> = Vec::new();
    for to in states {
        if *air {
            next.push((sum(cost, rotary_limits.cost(here, to)), *to));
            continue;
        }
        for start in before {
            let runs = start.0 == to.0 && (0..2).all(|axis| (to.1[axis] - start.1[axis]).abs() < SAME_BRANCH);
            if runs {
                let rewound = Cost { rewinds: u32::from(start != here), ..Cost::default() };
                let cost = sum(sum(cost, rewound), sum(rotary_limits.cost(here, start), rotary_limits.cost(start, to)));
                next.push((cost, *to));
            }
        }
    }
    next.sort_by_key(|(cost, _)| *cost);
    for (cost, to) in next {
        search_exhaustively(rotary_limits, rest, &to, states, cost, least);
    }
}

/// Compares random short paths on one machine; returns how many had a course, and how many of these needed a rewind.
fn compare<M: Machine>(seed: u64, paths: usize) -> (usize, usize) {
    let mut random = Random::new(seed);
    let mut rotaries =
        (0..M::AXES.len()).filter(|&index| M::AXES[index].kind == AxisKind::Rotary && !M::AXES[index].held);
    let rotaries = [rotaries.next().expect("a rotary"), rotaries.next().expect("another")];
    let letters = rotaries.map(|index| M::AXES[index].letter);
    let (mut with_course, mut rewound) = (0, 0);
    for path in 0..paths {
        let mut config = Config::default();
        let limits = [0, 1].map(|axis| {
            let lower = random.between(if axis == 0 { -400.0 } else { -190.0 }, 0.0);
            let upper = lower + if axis == 0 { random.between(200.0, 600.0) } else { random.between(60.0, 380.0) };
            config
                .set_up
                .limits
                .insert(letters[axis], Some(Limits { lower: lower.to_radians(), upper: upper.to_radians() }));
            ((lower * PER_DEGREE).ceil() as i64, (upper * PER_DEGREE).floor() as i64)
        });
        let speeds = random.chance(0.5).then(|| [0, 1].map(|_| random.between(500.0, 5000.0)));
        for (letter, speed) in letters.into_iter().zip(speeds.into_iter().flatten()) {
            config.set_up.speeds.insert(letter, speed.to_radians());
        }
        let rotary_limits = RotaryLimits { limits, speeds };
        let machine = config.set_up.machine::<M>().expect("valid");
        let mut navigator = Navigator::new(Box::new(machine.clone()), inside::policy(&config));
        let mut source = Source::new(&M::default(), inside::policy(&config));
        let mut follow = |event| source.event(Location::default(), &event, &mut navigator).expect("nothing is refused");
        follow(Event::NewStart(NewStart::Tool(ToolCall { number: 1, ..ToolCall::default() })));

        // The axis rotates in one sense, so that limits are reached.
        let sense = random.sign();
        let (mut azimuth, mut tilt) = (random.between(-180.0, 180.0_f64), random.between(15.0, 70.0_f64));
        let mut layers = Vec::new();
        for point in 0..2 + random.below(8) {
            let (around, up) = (azimuth.to_radians(), tilt.to_radians());
            let axis = Vector3::new(up.sin() * around.cos(), up.sin() * around.sin(), up.cos());
            let pose = Pose { tip: Point3::origin(), axis: UnitVector3::new_normalize(axis) };
            let rapid = point > 0 && random.chance(0.15);
            follow(Event::Motion(ToolMotion::Move(Move { pose, rapid, feed: Some(Feed::PerMinute(100.0)) })));
            layers.push((states(&machine, rotaries, &rotary_limits, &pose), point == 0 || rapid));
            azimuth += sense * random.between(-15.0, 75.0);
            tilt = (tilt + random.between(-12.0, 12.0)).clamp(15.0, 80.0);
        }
        source.finish(&mut navigator).expect("nothing is refused");
        let course = navigator.finish();
        let mut least = None;
        let start = (Branch::First, [0; 2]);
        search_exhaustively(&rotary_limits, &layers, &start, &[], Cost::default(), &mut least);
        let Some(least) = least else { continue };
        assert_eq!(course.cost, least, "{} path {path}, {layers:?}", M::NAME);
        assert!(course.greedy.is_none_or(|greedy| greedy >= least), "{} path {path}", M::NAME);
        with_course += 1;
        rewound += usize::from(least.rewinds > 0);
    }
    (with_course, rewound)
}

#[test]
fn no_choice_of_branches_and_turns_is_better() {
    let counts = [
        compare::<SpinnerU5620>(1, 150),
        compare::<Dmu70e>(2, 150),
        compare::<LolaXoyzba>(3, 150),
        compare::<Trunnion>(4, 150),
        compare::<HeadTable>(5, 150),
        compare::<NutatingHead>(6, 150),
    ];
    let (with_course, rewound) = counts.iter().fold((0, 0), |sum, count| (sum.0 + count.0, sum.1 + count.1));
    assert!(with_course > 250 && rewound > 40, "{counts:?}: too few paths with a course or a rewind");
}
