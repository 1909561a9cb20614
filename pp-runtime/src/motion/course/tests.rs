//! The search compared with an exhaustive search, and courses on the machines of the tests.

use nalgebra::{Point3, UnitVector3, Vector3};
use proptest::prelude::*;

use super::*;
use crate::config::Config;
use crate::kinematics::machines::{Cb, Head};
use crate::kinematics::{Limits, Machine};
use crate::motion::rotary::MAX_TURNS;
use crate::motion::tests::hand_on;
use crate::options::ToolPosture;
use crate::program::{Drilling, Feed, Hole, Move, RotaryDirection, Rotation, ToolCall, ToolMotion};

fn limits(lower: f64, upper: f64) -> Option<Limits> {
    Some(Limits { lower: lower.to_radians(), upper: upper.to_radians() })
}

fn axis(turn: f64, tilt: f64) -> UnitVector3<f64> {
    let (turn, tilt) = (turn.to_radians(), tilt.to_radians());
    UnitVector3::new_normalize(Vector3::new(tilt.sin() * turn.cos(), tilt.sin() * turn.sin(), tilt.cos()))
}

/// A motion of a random path.
#[derive(Debug, Clone, Copy)]
struct Point {
    pose: Pose,
    rapid: bool,
}

/// All changes of a course.
fn changes(mut course: Course) -> Vec<CourseChange> {
    std::iter::from_fn(|| {
        let change = course.next.take()?;
        course.next = course.changes.next();
        Some(change)
    })
    .collect()
}

fn course_of<M: Machine>(config: &Config, events: &[Event<'_>]) -> Course {
    let mut navigator = Navigator::new(Box::new(config.set_up.machine::<M>().expect("valid")), config.policy());
    hand_on::<M, _>(config, events, &mut navigator).expect("a navigator refuses nothing");
    navigator.finish()
}

fn course<M: Machine>(config: &Config, points: &[Point]) -> Course {
    let mut events = vec![Event::NewStart(NewStart::Tool(ToolCall { number: 1, ..ToolCall::default() }))];
    let feed = Some(Feed::PerMinute(100.0));
    events.extend(
        points.iter().map(|point| Event::Motion(ToolMotion::Move(Move { pose: point.pose, rapid: point.rapid, feed }))),
    );
    course_of::<M>(config, &events)
}

#[test]
fn after_gohome_the_course_continues_from_the_parked_angles() {
    let mut config = Config::default();
    config.set_up.limits.insert('C', limits(-190.0, 190.0));
    config.motion.park.insert('C', 0.0);
    let mut events = vec![Event::NewStart(NewStart::Tool(ToolCall { number: 1, ..ToolCall::default() }))];
    for event in [Some(170.0), None, Some(-172.0)] {
        let pose = |turn| Pose { tip: Point3::origin(), axis: axis(turn, 30.0) };
        let cut = |turn| Move { pose: pose(turn), rapid: false, feed: Some(Feed::PerMinute(100.0)) };
        events.push(event.map_or(Event::NewStart(NewStart::Home), |turn| Event::Motion(ToolMotion::Move(cut(turn)))));
    }
    let course = course_of::<Cb>(&config, &events);
    // C to 170, home, to -172 and not to 188; B to 30 once.
    let degrees = course.cost.travel_units as f64 / 10_f64.powi(config.formats.rotary as i32);
    assert!((degrees - (170.0 + 170.0 + 172.0 + 30.0)).abs() < 0.01, "{degrees}");
    assert_eq!(changes(course), []);
}

/// Exhaustive search: every state at the end of each motion, and every state of the same pose to which the axes may be
/// rewound before it. The paths stay away from the pole.
struct ExhaustiveSearch<'t> {
    finder: &'t StateFinder,
    points: &'t [Point],
    layers: Vec<Vec<RotaryState>>,
    least: Option<Cost>,
}

impl ExhaustiveSearch<'_> {
    fn sum(a: Cost, b: Cost) -> Cost {
        Cost {
            rewinds: a.rewinds + b.rewinds,
            against_preference: a.against_preference + b.against_preference,
            time_ns: a.time_ns + b.time_ns,
            travel_units: a.travel_units + b.travel_units,
        }
    }

    fn go(&mut self, index: usize, from: RotaryState, cost: Cost) {
        if self.least.is_some_and(|least| least < cost) {
            return;
        }
        let Some(point) = self.points.get(index) else {
            if self.least.is_none_or(|least| cost < least) {
                self.least = Some(cost);
            }
            return;
        };
        let turning = |a: &RotaryState, b: &RotaryState| self.finder.placer().metric().cost(&a.words, &b.words);
        let mut next = Vec::new();
        for to in &self.layers[index] {
            if index == 0 || point.rapid {
                next.push((*to, Self::sum(cost, turning(&from, to))));
                continue;
            }
            let before = &self.points[index - 1].pose;
            for start in &self.layers[index - 1] {
                let rewound = Cost { rewinds: u32::from(*start != from), ..Cost::default() };
                let cost = Self::sum(Self::sum(cost, rewound), turning(&from, start));
                let from = CutEnd { pose: before, state: start };
                let end = CutEnd { pose: &point.pose, state: to };
                if self.finder.connected(from, end, false, &mut TestedCuts::default()) {
                    next.push((*to, Self::sum(cost, turning(start, to))));
                }
            }
        }
        next.sort_by_key(|(_, cost)| *cost);
        for (to, cost) in next {
            self.go(index + 1, to, cost);
        }
    }
}

fn everything<M: Machine>(config: &Config, points: &[Point]) -> Option<Cost> {
    let placer =
        Placer::new(Box::new(config.set_up.machine::<M>().expect("valid")), config.policy(), Units::Millimetres);
    let finder = StateFinder::new(placer);
    let layers = points
        .iter()
        .map(|point| {
            let mut states = Vec::new();
            finder.states(&point.pose, &[], &mut states);
            states
        })
        .collect();
    let mut all = ExhaustiveSearch { finder: &finder, points, layers, least: None };
    all.go(0, RotaryState { branch: Branch::First, words: [0; 2] }, Cost::default());
    all.least
}

/// A path from steps: change of the two angles in degrees, and whether the step is a rapid.
fn path(start: (f64, f64), steps: &[(f64, f64, bool)]) -> Vec<Point> {
    let (mut turn, mut tilt) = start;
    let mut points = vec![Point { pose: Pose { tip: Point3::origin(), axis: axis(turn, tilt) }, rapid: false }];
    for &(around, along, rapid) in steps {
        turn += around;
        tilt = (tilt + along).clamp(8.0, 80.0);
        points.push(Point { pose: Pose { tip: Point3::origin(), axis: axis(turn, tilt) }, rapid });
    }
    points
}

fn agree<M: Machine>(config: &Config, points: &[Point]) -> Result<(), TestCaseError> {
    let course = course::<M>(config, points);
    let Some(least) = everything::<M>(config, points) else { return Ok(()) };
    prop_assert_eq!(course.cost, least);
    if let Some(greedy) = course.greedy {
        prop_assert!(greedy >= least, "pose by pose {:?} is better than {:?}", greedy, least);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, ..ProptestConfig::default() })]

    #[test]
    fn the_search_is_as_good_as_an_exhaustive_search(
        start in (-180.0..180.0_f64, 10.0..70.0_f64),
        steps in proptest::collection::vec((-80.0..80.0_f64, -15.0..15.0_f64, proptest::bool::weighted(0.15)), 1..=8),
        first in (-400.0..0.0_f64, 20.0..700.0_f64),
        second in (-120.0..0.0_f64, 10.0..200.0_f64),
        speeds in proptest::option::of((10.0..100.0_f64, 10.0..100.0_f64)),
        head in proptest::bool::ANY,
    ) {
        let mut config = Config::default();
        let (a, b) = if head { ('B', 'A') } else { ('C', 'B') };
        config.set_up.limits.insert(a, limits(first.0, first.0 + first.1));
        config.set_up.limits.insert(b, limits(second.0, second.0 + second.1));
        if let Some((one, other)) = speeds {
            config.set_up.speeds.insert(a, one);
            config.set_up.speeds.insert(b, other);
        }
        let points = path(start, &steps);
        if head { agree::<Head>(&config, &points)? } else { agree::<Cb>(&config, &points)? }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, max_shrink_iters: 12, ..ProptestConfig::default() })]

    #[test]
    fn an_axis_with_many_turns_has_the_course_of_one_whose_turns_suffice(
        start in (-180.0..180.0_f64, 10.0..70.0_f64),
        steps in proptest::collection::vec((-20.0..80.0_f64, -15.0..15.0_f64, proptest::bool::weighted(0.1)), 1..=14),
        backwards in proptest::bool::ANY,
        second in (-120.0..0.0_f64, 10.0..200.0_f64),
        timed in proptest::bool::ANY,
    ) {
        let steps: Vec<_> = steps.into_iter().map(|(around, along, rapid)| (if backwards { -around } else { around }, along, rapid)).collect();
        let points = path(start, &steps);
        let found = |turns: f64| {
            let mut config = Config::default();
            config.set_up.limits.insert('C', limits(-360.0 * turns, 360.0 * turns));
            config.set_up.limits.insert('B', limits(second.0, second.0 + second.1));
            if timed {
                config.set_up.speeds.insert('C', 60.0);
                config.set_up.speeds.insert('B', 25.0);
            }
            let course = course::<Cb>(&config, &points);
            (course.cost, changes(course))
        };
        // Four turns each way are all tried; of a hundred those near to zero, at the ends, and near the course.
        prop_assert_eq!(found(4.0), found(100.0));
    }
}

proptest! {
    #[test]
    fn the_states_of_a_pose_are_all_turns_tried_and_those_added_each_once(
        at in (-180.0..180.0_f64, 10.0..70.0_f64),
        limits_of_c in (-60.0..20.0_f64, 1.0..70.0_f64),
        limits_of_b in (-40.0..0.0_f64, 1.0..50.0_f64),
        near in proptest::collection::vec((-80_000_000_i64..80_000_000, -40_000_000_i64..40_000_000), 0..12),
        endless in proptest::bool::ANY,
    ) {
        let mut config = Config::default();
        config.set_up.limits.insert('C', limits(360.0 * limits_of_c.0, 360.0 * (limits_of_c.0 + limits_of_c.1)));
        if !endless {
            config.set_up.limits.insert('B', limits(360.0 * limits_of_b.0, 360.0 * (limits_of_b.0 + limits_of_b.1)));
        }
        let machine = config.set_up.machine::<Cb>().expect("valid");
        let finder = StateFinder::new(Placer::new(Box::new(machine), config.policy(), Units::Millimetres));
        let placer = finder.placer();
        let turn = placer.scale().units_per_turn;
        let pose = Pose { tip: Point3::origin(), axis: axis(at.0, at.1) };
        let near: Vec<RotaryWords> = near.into_iter().map(|(c, b)| [c, b]).collect();
        let [c, b] = placer.rotaries()[..] else { panic!("two rotary axes") };
        let mut expected = Vec::new();
        for solution in placer.machine().rotary_axes(&pose.axis, placer.held()).iter() {
            let [on_c, on_b] = [c.word(solution.axes[0], placer.scale()), b.word(solution.axes[1], placer.scale())];
            let mut words = std::collections::BTreeSet::new();
            for c in c.turns(on_c, turn, MAX_TURNS) {
                words.extend(b.turns(on_b, turn, MAX_TURNS).map(|b| [c, b]));
            }
            if !placer.has_many_turns() {
                for (rotary, word) in [(c, on_c), (b, on_b)] {
                    prop_assert_eq!(rotary.turns(word, turn, MAX_TURNS).count(), rotary.turns(word, turn, 1000).count());
                }
            }
            if placer.has_many_turns() {
                let ends = [[c.lower_end(), b.lower_end()], [c.upper_end(), b.upper_end()]];
                let nearest = |near: &RotaryWords| {
                    Some([c.nearest(on_c, near[0], turn).ok()?, b.nearest(on_b, near[1], turn).ok()?])
                };
                words.extend(ends.iter().chain(&near).filter_map(nearest));
            }
            let mut words: Vec<RotaryWords> = words.into_iter().collect();
            words.sort_by_key(|[c, b]| (c.abs() + b.abs(), -c, -b));
            expected.extend(words.into_iter().map(|words| RotaryState { branch: solution.branch, words }));
        }
        let mut found = Vec::new();
        finder.states(&pose, &near, &mut found);
        prop_assert_eq!(found, expected);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn a_run_that_begins_in_the_air_has_the_course_of_one_that_begins_after_a_cut(
        start in (-180.0..180.0_f64, 10.0..70.0_f64),
        steps in proptest::collection::vec((-60.0..60.0_f64, -15.0..15.0_f64, proptest::bool::weighted(0.4)), 1..=12),
        size in prop_oneof![Just(0.05), Just(0.4), Just(1.0)],
        first in prop_oneof![(-400.0..0.0_f64, 20.0..700.0_f64), (-40_000.0..-9000.0_f64, 9000.0..60_000.0_f64)],
        second in (-120.0..0.0_f64, 10.0..200.0_f64),
        timed in proptest::bool::ANY,
        greedy in proptest::bool::ANY,
    ) {
        let steps: Vec<_> = steps.into_iter().map(|(around, along, rapid)| (size * around, size * along, rapid)).collect();
        let mut config = Config::default();
        config.motion.course.greedy = greedy;
        config.set_up.limits.insert('C', limits(first.0, first.0 + first.1));
        config.set_up.limits.insert('B', limits(second.0, second.0 + second.1));
        if timed {
            config.set_up.speeds.insert('C', 60.0);
            config.set_up.speeds.insert('B', 25.0);
        }
        let course = |begins: fn(&RunStart) -> bool| course_in_runs(&config, &path(start, &steps), begins, |_| ());
        prop_assert_eq!(course(|_| true), course(|start| *start == RunStart::AfterCut));
    }
}

/// The course of a navigator that takes a run of cuts where one can begin and `begins`, and searches elsewhere; `after`
/// sees it after each motion.
fn course_in_runs(
    config: &Config,
    points: &[Point],
    begins: fn(&RunStart) -> bool,
    mut after: impl FnMut(&Navigator),
) -> (Cost, Option<Cost>, Vec<CourseChange>) {
    let mut navigator = Navigator::new(Box::new(config.set_up.machine::<Cb>().expect("valid")), config.policy());
    for (motion, point) in (0..).zip(points) {
        navigator.run_start = navigator.run_start.filter(begins);
        navigator.motion = motion;
        navigator.go(&point.pose, motion == 0 || point.rapid, motion == 0);
        after(&navigator);
    }
    let course = navigator.finish();
    (course.cost, course.greedy, changes(course))
}

#[test]
fn a_run_in_which_one_branch_needs_more_rewinds_has_the_course_of_a_search_motion_by_motion() {
    let mut random = 1_u64;
    let mut next = |range: i64| {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as i64 % range
    };
    let (mut compared, mut left_out, mut rewound, mut rewinds) = (0, 0, 0, 0);
    for run in 0..200 {
        let mut config = Config::default();
        config.motion.course.greedy = run % 5 == 0;
        // B on one side by a little more than the paths need, on the other side by less.
        let (less, more) = (-5.0 - next(20) as f64, 60.0 + next(60) as f64);
        config.set_up.limits.insert('B', if run % 2 == 0 { limits(less, more) } else { limits(-more, -less) });
        if run % 4 > 0 {
            let lower = -100.0 - next(500) as f64;
            config.set_up.limits.insert('C', limits(lower, lower + (200 + next(700)) as f64));
        }
        if run % 3 == 0 {
            config.set_up.speeds.insert('C', 60.0);
            config.set_up.speeds.insert('B', (5 + next(50)) as f64);
        }
        // In whole degrees from a quarter turn there are rewinds of equal cost.
        let (start, step) = if run % 8 < 4 { (90 * next(4), 1.0) } else { (next(360), 0.01) };
        let (mut turn, mut tilt) = (start as f64, 8.0 + next(50) as f64);
        let (mut around, mut along) = (0.0, 0.0);
        let points: Vec<Point> = (0..120)
            .map(|motion| {
                if motion % 12 == 0 {
                    // Mostly around in one sense, to and fro beside the pole.
                    around = (f64::from(next(900) as i32 - 200) / 100.0 / step).round() * step;
                    along = f64::from(next(700) as i32 - 400) / 100.0;
                }
                // Now and then the tool axis stays, or the tool is in the air.
                if next(8) > 0 {
                    (turn, tilt) = (turn + around, (tilt + along).clamp(3.0, 70.0));
                }
                let pose = Pose { tip: Point3::origin(), axis: axis(turn, tilt) };
                Point { pose, rapid: next(60) == 0 }
            })
            .collect();
        let one = course_in_runs(
            &config,
            &points,
            |_| true,
            |navigator| {
                let search = &navigator.searches[0].search;
                let is_running = navigator.run.is_some();
                compared += usize::from(is_running && search.compares_rewinds());
                left_out += usize::from(
                    navigator.run.as_ref().is_some_and(|run| search.compares_rewinds() && !run.awaits_comparison()),
                );
                rewound += usize::from(is_running && search.has_rewound());
            },
        );
        rewinds += one.0.rewinds;
        assert_eq!(one, course_in_runs(&config, &points, |_| false, |_| ()), "path {run}");
    }
    assert!(
        compared > 2000 && left_out > 500 && rewound > 1000 && rewinds > 20,
        "{compared} in runs, {left_out} not compared, {rewound} rewound, {rewinds} rewinds"
    );
}

#[test]
fn a_path_beside_a_limit_of_the_other_branch_is_one_run() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-5.0, 110.0));
    // The other branch would have B at -6: it has no state.
    let points: Vec<Point> = (0..200).map(|step| path((3.0 * f64::from(step), 6.0), &[])[0]).collect();
    let mut running = 0;
    course_in_runs(&config, &points, |_| true, |navigator| running += usize::from(navigator.run.is_some()));
    assert!(running > 190, "{running}");
}

#[test]
fn of_equal_rewinds_in_a_run_that_from_the_turn_nearest_to_zero_is_taken() {
    let mut config = Config::default();
    config.set_up.limits.insert('C', limits(-300.0, 300.0));
    config.set_up.limits.insert('B', limits(-8.0, 120.0));
    // Near the pole C rotates back and forth about 180: 180 and -180 change places as the turn nearest to zero.
    let mut angles: Vec<(f64, f64)> = [12.0, 10.0, 9.0, 8.5, 6.0, 5.9, 5.8].map(|tilt| (180.0, tilt)).to_vec();
    angles.extend([178.0, 176.0, 175.0].map(|turn| (turn, 5.5)));
    angles.extend((0..6).map(|step| (176.0 + 2.0 * f64::from(step), 5.4 - 0.1 * f64::from(step))));
    angles.extend([(187.0, 5.0), (187.5, 5.2), (188.0, 5.4), (188.0, 5.6)]);
    // At 300 it is at its limit.
    angles.extend((0..=30).map(|step| (188.0 + 4.0 * f64::from(step), 5.8)));
    angles.extend((0..=72).map(|step| (308.0 - 4.0 * f64::from(step), 5.8)));
    let points: Vec<Point> = angles.into_iter().map(|(turn, tilt)| path((turn, tilt), &[])[0]).collect();
    let mut compared = 0;
    let one = course_in_runs(
        &config,
        &points,
        |_| true,
        |navigator| {
            compared += usize::from(navigator.run.is_some() && navigator.searches[0].search.compares_rewinds());
        },
    );
    assert!(compared > 20 && one.0.rewinds == 1, "{compared} {one:?}");
    assert_eq!(one, course_in_runs(&config, &points, |_| false, |_| ()));
}

#[test]
fn a_limit_inside_a_single_block_leads_to_a_rewind_at_the_limit() {
    let mut config = Config::default();
    config.set_up.limits.insert('C', limits(-180.0, 180.0));
    // From 170 to 190 degrees: at each end there is one turn only.
    let course = course::<Cb>(&config, &path((170.0, 30.0), &[(20.0, 0.0, false)]));
    assert_eq!(course.cost.rewinds, 1);
    let changes = changes(course);
    let action: Vec<CourseAction> = changes.iter().map(|change| change.action).collect();
    assert!(
        matches!(action[..], [CourseAction::SplitAt(part), CourseAction::Rewind] if (part - 0.5).abs() < 1e-4),
        "{action:?}"
    );
    assert_eq!(changes[0].words[0], 1_800_000);
    assert_eq!(changes[1].words[0], -1_800_000);
}

#[test]
fn of_equal_courses_the_first_branch_is_taken_and_the_turn_nearest_to_zero() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    // C 90 B 30 or C -90 B -30: the same travel.
    let course = course::<Cb>(&config, &path((90.0, 30.0), &[]));
    assert_eq!(changes(course), [CourseChange { motion: 0, action: CourseAction::EndWith, words: [900_000, 300_000] }]);
}

#[test]
fn a_preference_counts_less_than_a_rewind_and_more_than_travel() {
    let mut config = Config::default();
    config.motion.course.prefer = Some(('B', false));
    config.set_up.limits.insert('B', limits(-50.0, 110.0));
    let begins = |config: &Config, steps: &[(f64, f64, bool)]| {
        let course = course::<Cb>(config, &path((20.0, 30.0), steps));
        changes(course).first().map(|change| change.words[1])
    };
    assert_eq!(begins(&config, &[]), Some(-300_000));
    // With more tilt B- would reach its limit.
    assert_eq!(begins(&config, &[(0.0, 40.0, false)]), None);
    let mut second = config;
    second.motion.course.start_branch = Some(Branch::Second);
    second.motion.course.prefer = None;
    assert_eq!(begins(&second, &[]), Some(-300_000));
}

#[test]
fn a_limit_that_is_broken_between_the_ends_of_a_block_leads_to_the_other_branch_or_a_rewind() {
    let mut config = Config::default();
    config.motion.tip.tool_posture = ToolPosture::Plane;
    // Between two tilts of 109.9 degrees, 20 degrees apart, the great circle tilts by 110.18 degrees.
    let over = path((0.0, 109.9), &[]).into_iter().chain(path((20.0, 109.9), &[])).collect::<Vec<_>>();
    config.set_up.limits.insert('B', limits(-112.0, 110.0));
    let other = course::<Cb>(&config, &over);
    assert_eq!((other.cost.rewinds, changes(other)[0].words[1]), (0, -1_099_000));
    // The cut before can be made on the first branch only: the axes are rewound.
    config.set_up.limits.insert('C', limits(-170.0, 170.0));
    let longer: Vec<Point> =
        [(0.0, 50.0), (20.0, 109.9), (40.0, 109.9)].into_iter().flat_map(|at| path(at, &[])).collect();
    let rewound = course::<Cb>(&config, &longer);
    assert_eq!(rewound.cost.rewinds, 1);
    assert!(
        changes(rewound)
            .iter()
            .any(|change| change.action == CourseAction::Rewind && change.words == [-1_600_000, -1_099_000])
    );
    // Where the rotary axes go evenly they stay between the words of the ends.
    let mut even = Config::default();
    even.motion.axis_tolerance_path_rad = 0.02;
    even.set_up.limits.insert('B', limits(-112.0, 110.0));
    assert_eq!(changes(course::<Cb>(&even, &over)).first().map_or(1_099_000, |change| change.words[1]), 1_099_000);
}

#[test]
fn the_search_for_the_cost_alone_keeps_no_changes() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    let mut navigator = Navigator::new(Box::new(config.set_up.machine::<Cb>().expect("valid")), config.policy());
    for motion in 0..1500_u32 {
        let tilt = if motion % 2 == 0 { 0.1 } else { -0.1 };
        let axis = UnitVector3::new_normalize(Vector3::new(tilt, 0.0, 1.0));
        navigator.motion = u64::from(motion);
        navigator.go(&Pose { tip: Point3::origin(), axis }, motion == 0, motion == 0);
    }
    let [best, greedy] = navigator.searches.each_ref().map(|run| run.search.size());
    // Every motion changes the course: those that all courses share are packed after some thousands.
    let nodes = 1500 * 160;
    assert!((20_000..nodes).contains(&best) && greedy < 2000, "{best} {greedy}");
}

#[test]
fn indexed_axes_have_the_words_of_their_steps() {
    let mut config = Config::default();
    config.motion.rotaries.grid.insert('C', 2.5_f64.to_radians());
    config.motion.rotaries.grid.insert('B', 2.5_f64.to_radians());
    config.motion.course.axis_tolerance_rad = 0.2_f64.to_radians();
    // Both branches, with the digits of CL data: C 90.0001 B 30.0001 is C 90 B 30.
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    let course = course::<Cb>(&config, &path((90.0001, 30.0001), &[]));
    assert_eq!(changes(course), [CourseChange { motion: 0, action: CourseAction::EndWith, words: [900_000, 300_000] }]);
    // The step is inside the limits although the angle is not.
    config.set_up.limits.insert('B', limits(0.0, 30.0));
    let mut navigator = Navigator::new(Box::new(config.set_up.machine::<Cb>().expect("valid")), config.policy());
    navigator.go(&path((90.0001, 30.0001), &[])[0].pose, true, true);
    assert_eq!(navigator.states.iter().map(|state| state.words).collect::<Vec<_>>(), [[900_000, 300_000]]);
}

#[test]
fn where_the_tool_begins_at_the_pole_the_preference_holds_for_the_cut_that_leaves_it() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    let end = |config: &Config, steps: &[(f64, f64, bool)]| {
        let mut points = path((20.0, 0.0), &[]);
        points.extend(path((20.0, 30.0), steps).into_iter().map(|point| Point { rapid: false, ..point }));
        let course = course::<Cb>(config, &points);
        (changes(course.clone()).last().map(|change| change.words[1]), course.cost.against_preference)
    };
    // C 20 B 30 or C -160 B -30: without a preference the smaller rotation.
    assert_eq!(end(&config, &[]).0, Some(300_000));
    config.motion.course.prefer = Some(('B', false));
    assert_eq!(end(&config, &[]), (Some(-300_000), 0));
    config.motion.course.prefer = Some(('C', false));
    assert_eq!(end(&config, &[]), (Some(-300_000), 0));
    config.motion.course.prefer = None;
    config.motion.course.start_branch = Some(Branch::Second);
    assert_eq!(end(&config, &[]), (Some(-300_000), 0));
    // A rewind counts more: B ends at -50.
    config.set_up.limits.insert('B', limits(-50.0, 110.0));
    assert_eq!(end(&config, &[(0.0, 40.0, false)]).1, 1);
}

#[test]
fn a_course_of_a_hundred_thousand_motions_is_one_change_at_most() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    let points: Vec<Point> = (0..100_000).map(|step| path((f64::from(step) * 0.3, 30.0), &[])[0]).collect();
    let course = course::<Cb>(&config, &points);
    assert_eq!(course.cost.rewinds, 0);
    assert!(changes(course).len() <= 1);
}

#[test]
fn a_spiral_continues_on_an_axis_with_more_turns_than_are_tried() {
    let mut config = Config::default();
    let spiral: Vec<Point> = (0..=40 * 36).map(|step| path((f64::from(step) * 10.0, 30.0), &[])[0]).collect();
    config.set_up.limits.insert('C', limits(-99_999.0, 99_999.0));
    assert_eq!(course::<Cb>(&config, &spiral).cost.rewinds, 0);
    // The spiral needs the whole travel of the axis.
    config.set_up.limits.insert('C', limits(-7200.0, 7200.0));
    assert_eq!(course::<Cb>(&config, &spiral).cost.rewinds, 0);
    config.set_up.limits.insert('C', limits(-7200.0, 7199.0));
    assert_eq!(course::<Cb>(&config, &spiral).cost.rewinds, 1);
}

#[test]
fn a_cut_is_continuous_however_near_it_passes_the_pole() {
    let mut config = Config::default();
    config.set_up.limits.insert('B', limits(-110.0, 110.0));
    for offset in [1.1e-6, 2e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        let pose = |tilt: f64| {
            let axis = UnitVector3::new_normalize(Vector3::new(tilt.sin(), offset, tilt.cos()));
            Point { pose: Pose { tip: Point3::origin(), axis }, rapid: false }
        };
        let course = course::<Cb>(&config, &[-1.0, 1.0].map(pose));
        assert_eq!(course.cost.rewinds, 0);
        // To the start, and 180° at the pole.
        assert!(course.cost.travel_units > 1_700_000, "{offset}: {course:?}");
        assert!(course.greedy.is_some(), "{offset}");
    }
}

/// A navigator that takes each motion in both searches, where it may.
struct Searching(Navigator);

impl Stage for Searching {
    type Stop = Diagnostic;

    fn take(&mut self, item: &ProgramItem<'_>) -> Result<(), Diagnostic> {
        self.0.second_words.clear();
        self.0.take(item)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn a_motion_in_the_air_to_the_pole_of_the_last_one_changes_nothing(
        steps in proptest::collection::vec((0..16_u32, 0..5_u32, -170.0..170.0_f64), 1..=30),
        first in prop_oneof![(-400.0..0.0_f64, 20.0..700.0_f64), (10.0..100.0_f64, 20.0..700.0_f64)],
        second in prop_oneof![(-120.0..0.0_f64, 10.0..200.0_f64), (-400.0..-365.0_f64, 380.0..410.0_f64)],
        [limited, timed, greedy, zeroes, one_branch] in proptest::array::uniform5(proptest::bool::ANY),
    ) {
        let mut config = Config::default();
        config.motion.course.greedy = greedy;
        config.motion.park.insert('C', 90.0);
        config.motion.course.start_branch = one_branch.then_some(Branch::First);
        if zeroes {
            config.motion.singular = Singular::Zero;
        }
        if limited {
            config.set_up.limits.insert('C', limits(first.0, first.0 + first.1));
            config.set_up.limits.insert('B', limits(second.0, second.0 + second.1));
        }
        if timed {
            config.set_up.speeds.insert('C', 60.0);
            config.set_up.speeds.insert('B', 25.0);
        }
        let mut events = vec![Event::NewStart(NewStart::Tool(ToolCall { number: 1, ..ToolCall::default() }))];
        for (kind, next, turn) in steps {
            // Mostly along the pole.
            let axis = if kind < 3 { axis(turn, 30.0) } else { axis(0.0, 0.0) };
            let pose = Pose { tip: Point3::new(turn, 0.0, 0.0), axis };
            let feed = Some(Feed::PerMinute(100.0));
            let hole = Hole {
                top: pose,
                depth_mm: 5.0,
                clearance_mm: 2.0,
                return_mm: 2.0,
                drilling: Drilling::Drill,
                feed,
                dwell: None,
            };
            events.push(match (kind, next) {
                (3, 0) => Event::NewStart(NewStart::Home),
                (4, 0) => Event::Function(MachineFunction::RotaryDirection(RotaryDirection::Towards(Rotation::Clockwise))),
                (5, 0) => Event::NewStart(NewStart::Tool(ToolCall { number: 2, ..ToolCall::default() })),
                (_, 0 | 1) => Event::Motion(ToolMotion::Move(Move { pose, rapid: false, feed })),
                (_, 2) => Event::Motion(ToolMotion::Move(Move { pose, rapid: true, feed })),
                _ => Event::Motion(ToolMotion::Hole(hole)),
            });
        }
        let navigator = || Navigator::new(Box::new(config.set_up.machine::<Cb>().expect("valid")), config.policy());
        let (mut one, mut other) = (navigator(), Searching(navigator()));
        hand_on::<Cb, _>(&config, &events, &mut one).expect("a navigator refuses nothing");
        hand_on::<Cb, _>(&config, &events, &mut other).expect("a navigator refuses nothing");
        let course = |navigator: Navigator| {
            let course = navigator.finish();
            (course.cost, course.greedy, changes(course))
        };
        prop_assert_eq!(course(one), course(other.0));
    }
}
