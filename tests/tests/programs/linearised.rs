//! Posted programs keep to the path of their CL data: printed words, 1000 samples of every block, the matrices of the
//! oracle.
//!
//! The number of blocks is checked too: for each motion the least number of points is found by the same search (the
//! longest piece from the start, and so on), with the *true* deviation in place of the certified bound.

use std::fmt::Write as _;
use std::io::Cursor;

use approx::abs_diff_eq;
use machines::{Dmu70e, LolaXoyzba, MultiProDesk, SpinnerU5620};
use pp_runtime::config::{Config, Mode, ToolPosture};
use pp_runtime::control::LinuxCnc;
use pp_runtime::kinematics::{AxisKind, Limits, Machine, Pose};
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
use pp_runtime::post::{Job, Report, post};
use tests::block::{deviation, deviation_from, rotated_evenly, timed_mm};
use tests::foreign::{Axes, Control, Effect, Executed, Feed, Options, run};
use tests::further::{HeadTable, NutatingHead, Trunnion};
use tests::oracle::{Oracle, angle_between, wrapped};

/// Samples of a printed block.
const POINTS: usize = 1000;
/// Samples of a block that is only tried.
const POINTS_TRIED: usize = 150;
const LENGTH: f64 = 95.0;
const PART: [f64; 3] = [22.0, -14.0, 65.0];

fn unit(vector: Vector3<f64>) -> UnitVector3<f64> {
    UnitVector3::new_normalize(vector)
}

/// Path across a hemisphere in a plane at `offset_mm` from its pole; the tool is perpendicular to the surface.
fn traverse(offset_mm: f64, steps: usize) -> Vec<Pose> {
    let radius: f64 = 45.0;
    let circle = (radius * radius - offset_mm * offset_mm).sqrt();
    let (sine, cosine) = 0.35_f64.sin_cos();
    let pose = |step: usize| {
        let angle = -1.0 + 2.0 * step as f64 / steps as f64;
        let (along, up) = (circle * angle.sin(), circle * angle.cos());
        let from_centre = Vector3::new(along * cosine - offset_mm * sine, along * sine + offset_mm * cosine, up);
        Pose { tip: Point3::from(from_centre + Vector3::new(30.0, 10.0, 0.0)), axis: unit(from_centre) }
    };
    (0..=steps).map(pose).collect()
}

/// One motion from one side of the pole to the other, at an angle of `offset_rad` from it.
fn past(offset_rad: f64) -> Vec<Pose> {
    let pose = |along: f64| {
        let axis = Vector3::new(along.sin(), offset_rad.sin() * along.cos(), offset_rad.cos() * along.cos());
        Pose { tip: Point3::new(20.0 * along, 0.0, 0.0), axis: unit(axis) }
    };
    vec![pose(-0.1), pose(0.6)]
}

/// Around a steep wall in steps of 8 degrees, the tilt of the tool growing evenly: between two points the great circle
/// is less tilted than both.
fn wall() -> Vec<Pose> {
    let pose = |step: u32| {
        let ((sine, cosine), (up, across)) =
            ((8.0 * f64::from(step)).to_radians().sin_cos(), (40.0 - 0.05 * f64::from(step)).to_radians().sin_cos());
        let axis = Vector3::new(across * cosine, across * sine, up);
        Pose { tip: Point3::new(30.0 * cosine, 30.0 * sine, 5.0), axis: unit(axis) }
    };
    (0..30).map(pose).collect()
}

/// Path outwards along the blade of an impeller; the side tilt of the tool increases.
fn swirl() -> Vec<Pose> {
    let pose = |step: usize| {
        let share = step as f64 / 24.0;
        let (sine, cosine) = (2.6 * share).sin_cos();
        let radius = 15.0 + 45.0 * share;
        let tilt = 0.35 + 0.5 * share;
        let side = Vector3::new(-sine, cosine, 0.0) * tilt.sin() + Vector3::new(cosine, sine, 0.0) * 0.2;
        let tip = Point3::new(radius * cosine, radius * sine, 30.0 - 25.0 * share * share);
        Pose { tip, axis: unit(side + Vector3::z() * tilt.cos()) }
    };
    (0..=24).map(pose).collect()
}

/// Away from the centre line of B of the Spinner, while the tool rotates about B. In a block the tip has the second
/// derivative `w w r + 2 w x v` (r from the centre line, v along the path, w of the tool). It is along v where the
/// slope of the path is `-2 v / (w r)`: there the tip speeds up and slows down on its line, and nothing but the lag of
/// the tool axis shows it.
fn outward() -> Vec<Pose> {
    let (radius_mm, step_mm, step_rad) = (300.0, 2.0, 4_f64.to_radians());
    let down: f64 = 2.0 * step_mm / (step_rad * radius_mm);
    let along = Vector3::new((1.0 - down * down).sqrt(), 0.0, -down);
    let start = Point3::new(-PART[0], -PART[1], SpinnerU5620::default().d - PART[2]) + Vector3::x() * radius_mm;
    let pose = |step: u32| {
        let (across, up) = (0.3 + step_rad * f64::from(step)).sin_cos();
        Pose { tip: start + along * (step_mm * f64::from(step)), axis: unit(Vector3::new(across, 0.0, up)) }
    };
    (0..4).map(pose).collect()
}

/// Path around a bar, for a machine with A only.
fn around(steps: usize) -> Vec<Pose> {
    let pose = |step: usize| {
        let angle = 0.3 * step as f64;
        let axis = Vector3::new(0.0, -angle.sin(), angle.cos());
        Pose { tip: Point3::from(axis * 25.0 + Vector3::new(0.1 * step as f64, 4.0, 3.0)), axis: unit(axis) }
    };
    (0..=steps).map(pose).collect()
}

fn cl_of(poses: &[Pose]) -> String {
    let mut cl = format!("UNITS/MM\nTOOL PATH/TEST\nLOADTL/1,LENGTH,{LENGTH}\nSPINDL/RPM,5000,CLW\nFEDRAT/MMPM,900\n");
    for Pose { tip, axis } in poses {
        let (t, a) = (tip, axis);
        writeln!(cl, "GOTO/{:.6},{:.6},{:.6},{:.9},{:.9},{:.9}", t.x, t.y, t.z, a.x, a.y, a.z).expect("memory");
    }
    cl + "END-OF-PATH\nFINI\n"
}

/// Counts over the motions of a program.
#[derive(Debug, Default)]
struct Found {
    motions: usize,
    /// Inserted points.
    inserted: usize,
    /// Least number of points that would do.
    least: usize,
    /// Motions in which an axis rotates while the tip stands still: there is no path whose points could be counted.
    spots: usize,
    /// Motions with pieces of different lengths.
    graded: usize,
    /// Blocks that end at the points of the CL data.
    points: Vec<usize>,
}

fn config<M: Machine>(part_origin: [f64; 3]) -> Config {
    let mut config = Config::default();
    config.set_up.part_origin = part_origin;
    config.motion.retract.distance_mm = Some(60.0);
    for axis in M::AXES.iter().filter(|axis| axis.kind == AxisKind::Linear) {
        config.set_up.limits.insert(axis.letter, Some(Limits { lower: -9e4, upper: 9e4 }));
    }
    config
}

/// Axis values of the feed blocks, in chain order, mm and rad; the first block ends at the start of the path.
fn printed<M: Machine>(text: &str) -> Vec<Vec<f64>> {
    let feeds = straight(text).into_iter().filter(|step| step.effect == Effect::Feed);
    let values = |step: Executed| {
        let value = |axis: &pp_runtime::kinematics::Axis| {
            let word = step.state.position.get(axis.letter);
            let word = word.unwrap_or_else(|| panic!("line {}: {} is unknown", step.line, axis.letter));
            if axis.kind == AxisKind::Rotary { word.to_radians() } else { word }
        };
        M::AXES.iter().map(value).collect()
    };
    feeds.map(values).collect()
}

/// Motions of a program; all of them must be straight.
fn straight(text: &str) -> Vec<Executed> {
    let program = run(text, &Options::of(Control::LinuxCnc)).unwrap_or_else(|refused| panic!("{refused}"));
    let motions: Vec<Executed> = program.motions().cloned().collect();
    for step in &motions {
        let is_straight = matches!(step.effect, Effect::Rapid | Effect::Feed | Effect::Machine);
        assert!(is_straight, "line {}: the motion is not straight", step.line);
    }
    motions
}

struct Checker<M: Machine> {
    machine: M,
    oracle: Oracle,
    config: Config,
}

impl<M: Machine> Checker<M> {
    fn tolerances(&self) -> (f64, f64) {
        (self.config.motion.tolerance_mm, self.config.motion.axis_tolerance_path_rad)
    }

    /// Whether a block is within the tolerances of the motion between two poses.
    fn keeps(&self, from: &[f64], to: &[f64], (start, end): (&Pose, &Pose), points: usize) -> bool {
        let off = deviation_from(&self.oracle, from, to, points, (&start.tip, &start.axis), (&end.tip, &end.axis));
        let (tip, axis) = self.tolerances();
        off.tip_mm <= tip && off.axis_rad <= axis
    }

    /// Pose on the path between two poses, at a share of it.
    fn pose_at((start, end): (&Pose, &Pose), share: f64) -> Pose {
        let normal = start.axis.cross(&end.axis);
        let angle = normal.norm().atan2(start.axis.dot(&end.axis));
        let across = normal.cross(&start.axis).try_normalize(0.0).unwrap_or_default();
        let axis = unit(start.axis.into_inner() * (share * angle).cos() + across * (share * angle).sin());
        Pose { tip: start.tip + (end.tip - start.tip) * share, axis }
    }

    /// Words of a pose: the solution nearest to the printed words there.
    fn words_at(&self, pose: &Pose, near: &[f64]) -> Vec<f64> {
        let mut held = M::HELD;
        held.as_mut().copy_from_slice(near);
        let solutions = self.machine.inverse_kinematics(pose, &held);
        let rotary = self.oracle.rotary();
        let off = |axes: &[f64]| rotary.iter().map(|&index| wrapped(axes[index] - near[index]).abs()).sum::<f64>();
        let nearest = solutions
            .iter()
            .min_by(|one, other| off(one.axes.as_ref()).total_cmp(&off(other.axes.as_ref())))
            .expect("the path can be reached");
        let mut words = nearest.axes.as_ref().to_vec();
        for &index in &rotary {
            let value = near[index] + wrapped(words[index] - near[index]);
            words[index] = ((value.to_degrees() * 1e4).round() / 1e4).to_radians();
        }
        self.oracle.bring_tip_to(&pose.tip, &mut words);
        for index in self.oracle.linear() {
            words[index] = (words[index] * 1e3).round() / 1e3;
        }
        words
    }

    /// Least number of points between the first and the last of the printed ones; `None` where an axis rotates while
    /// the tip stands still.
    fn least(&self, ends: (&Pose, &Pose), printed: &[Vec<f64>]) -> Option<usize> {
        let shares = self.shares(ends, printed)?;
        let at = |share: f64| {
            let place = shares.partition_point(|known| *known < share).clamp(1, shares.len() - 1);
            let part = (share - shares[place - 1]) / (shares[place] - shares[place - 1]);
            let near: Vec<f64> =
                printed[place - 1].iter().zip(&printed[place]).map(|(a, b)| a + (b - a) * part).collect();
            self.words_at(&Self::pose_at(ends, share), &near)
        };
        // Compared with its own part of the path, as by the bound, so that the tool does not move back on the line.
        let keeps = |from: &[f64], share: f64, to: &[f64], end: f64| {
            let (start, end) = (Self::pose_at(ends, share), Self::pose_at(ends, end));
            self.keeps(from, to, (&start, &end), POINTS_TRIED)
        };
        let end = printed.last().expect("an end");
        let (mut from, mut share, mut points) = (printed[0].clone(), 0.0, 0);
        while !keeps(&from, share, end, 1.0) {
            let (mut good, mut bad) = (share, 1.0);
            while bad - good > 0.005 * (good - share) && bad - share > 1e-7 {
                let middle = 0.5 * (good + bad);
                let kept = keeps(&from, share, &at(middle), middle);
                *(if kept { &mut good } else { &mut bad }) = middle;
            }
            if good <= share {
                return None;
            }
            (from, share, points) = (at(good), good, points + 1);
        }
        Some(points)
    }

    /// Whether the pieces of a motion are equal but for the rounding of their ends. If not, each is at most twice as
    /// long as its neighbours.
    fn are_equal(&self, ends: (&Pose, &Pose), printed: &[Vec<f64>]) -> bool {
        let Some(shares) = self.shares(ends, printed) else { return true };
        let rounding = 4e-3 / (ends.1.tip - ends.0.tip).norm();
        let lengths: Vec<f64> = shares.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mean = 1.0 / lengths.len() as f64;
        if lengths.iter().all(|length| (length - mean).abs() <= rounding) {
            return true;
        }
        for pair in lengths.windows(2) {
            let (short, long) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
            assert!(long <= 2.0 * short + 3.0 * rounding, "{}: neighbours of {short} and {long}", M::NAME);
        }
        false
    }

    /// Positions of the printed points on the path, as shares; `None` if two are at the same position.
    fn shares(&self, (start, end): (&Pose, &Pose), printed: &[Vec<f64>]) -> Option<Vec<f64>> {
        let line = end.tip - start.tip;
        let length = line.norm_squared();
        let mut shares: Vec<f64> =
            printed.iter().map(|words| (self.oracle.forward(words).tip - start.tip).dot(&line) / length).collect();
        let last = shares.len() - 1;
        (shares[0], shares[last]) = (0.0, 1.0);
        shares.windows(2).all(|pair| pair[1] - pair[0] > 2e-3 / length.sqrt()).then_some(shares)
    }

    fn check(&self, poses: &[Pose], blocks: &[Vec<f64>]) -> Found {
        let mut found = Found::default();
        let mut index = 0;
        let mut before = 0;
        for (place, words) in blocks.iter().enumerate() {
            let Some(next) = poses.get(index) else { panic!("{}: block {place} comes after the last point", M::NAME) };
            let pose = self.oracle.forward(words);
            if (pose.tip - next.tip).norm() > 1.2e-3 || (pose.axis.into_inner() - next.axis.into_inner()).norm() > 5e-6
            {
                continue;
            }
            if index > 0 {
                let ends = (&poses[index - 1], next);
                let run = &blocks[before..=place];
                for pair in run.windows(2) {
                    let off = deviation_from(
                        &self.oracle,
                        &pair[0],
                        &pair[1],
                        POINTS,
                        (&ends.0.tip, &ends.0.axis),
                        (&ends.1.tip, &ends.1.axis),
                    );
                    let (tip, axis) = self.tolerances();
                    assert!(off.tip_mm <= tip && off.axis_rad <= axis, "{}, to point {index}: {off:?}", M::NAME);
                }
                self.count(ends, run, index, &mut found);
            }
            before = place;
            index += 1;
            found.points.push(place);
        }
        assert_eq!(index, poses.len(), "{}: a block ends at every point", M::NAME);
        found
    }

    fn count(&self, ends: (&Pose, &Pose), run: &[Vec<f64>], index: usize, found: &mut Found) {
        let inserted = run.len() - 2;
        found.motions += 1;
        found.inserted += inserted;
        match self.least(ends, run) {
            Some(least) => {
                found.least += least;
                // The bound certifies shorter pieces than the true deviation would allow.
                let longest = ((1.3 * least as f64) as usize).max(least + 1) + 1;
                let times = if self.are_equal(ends, run) {
                    2
                } else {
                    found.graded += 1;
                    4
                };
                assert!(
                    inserted < times * longest,
                    "{}, to point {index}: {inserted} points, {least} would do",
                    M::NAME
                );
            }
            None => found.spots += 1,
        }
    }
}

/// The poses as rounded in CL data.
fn as_written(poses: &[Pose]) -> Vec<Pose> {
    let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
    let written = |pose: &Pose| Pose {
        tip: pose.tip.map(|value| rounded(value, 1e6)),
        axis: unit(pose.axis.map(|value| rounded(value, 1e9))),
    };
    poses.iter().map(written).collect()
}

fn posted<M: Machine>(config: &Config, poses: &[Pose]) -> (Report, String) {
    let job = Job { cl_name: "test.cls", config, control: &LinuxCnc, units: None };
    let mut out = Vec::new();
    let report = post::<M>(&job, &mut Cursor::new(cl_of(poses).as_bytes()), &mut out).expect("memory");
    assert!(!report.failed, "{}: {:?}", M::NAME, report.diagnostics);
    (report, String::from_utf8(out).expect("ASCII"))
}

/// How often an axis changes its direction.
fn reversals(blocks: &[&Vec<f64>], axis: usize) -> usize {
    let steps = blocks.windows(2).map(|pair| pair[1][axis] - pair[0][axis]);
    // Less than a unit of the words is rounding.
    let steps: Vec<f64> = steps.filter(|step| step.abs() > 2e-6).collect();
    steps.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
}

fn check<M: Machine>(name: &str, poses: &[Pose], limits: &[(char, f64, f64)]) -> Found {
    let poses = as_written(poses);
    let mut config = config::<M>(PART);
    for (letter, lower, upper) in limits {
        let limits = Limits { lower: lower.to_radians(), upper: upper.to_radians() };
        config.set_up.limits.insert(*letter, Some(limits));
    }
    let (report, text) = posted::<M>(&config, &poses);
    let mut machine = M::default();
    machine.set_up(Vector3::from(PART), LENGTH);
    let oracle = Oracle::of(&machine);
    let rotary = oracle.rotary();
    let blocks = printed::<M>(&text);
    let found = Checker { machine, oracle, config }.check(&poses, &blocks);
    let at_points: Vec<&Vec<f64>> = found.points.iter().map(|&place| &blocks[place]).collect();
    let from_first: Vec<&Vec<f64>> = blocks[found.points[0]..].iter().collect();
    if poses.iter().all(|pose| pose.axis.z.acos() > 0.15) {
        for axis in rotary {
            assert_eq!(reversals(&from_first, axis), reversals(&at_points, axis), "{name} {}: axis {axis}", M::NAME);
        }
    }
    assert_eq!(report.statistics.inserted as usize, found.inserted, "{name} {}", M::NAME);
    println!("{name} {}: {found:?}", M::NAME);
    found
}

macro_rules! linearised {
    ($($test:ident: $machine:ty, $path:expr, $limits:expr;)*) => {
        $(#[test]
        fn $test() {
            let found = check::<$machine>(stringify!($test), &$path, &$limits);
            assert!(found.inserted > 0 && found.spots <= 1, "{found:?}");
        })*
    };
}

/// The tilt cannot pass through zero: the table must rotate at the pole.
const ONE_SIDE: (char, f64, f64) = ('B', -1.0, 110.0);
/// The tilt can pass through zero.
const BOTH_SIDES: (char, f64, f64) = ('B', -110.0, 110.0);

linearised! {
    spinner_across_the_pole: SpinnerU5620, traverse(0.0, 24), [ONE_SIDE];
    spinner_between_points_across_the_pole: SpinnerU5620, traverse(0.0, 25), [ONE_SIDE];
    spinner_through_the_pole: SpinnerU5620, traverse(0.0, 24), [BOTH_SIDES];
    spinner_near_the_pole: SpinnerU5620, traverse(0.6, 25), [BOTH_SIDES];
    spinner_farther_from_the_pole: SpinnerU5620, traverse(6.0, 24), [];
    spinner_on_the_swirl: SpinnerU5620, swirl(), [];
    spinner_around_a_steep_wall: SpinnerU5620, wall(), [];
    dmu_around_a_steep_wall: Dmu70e, wall(), [];
    trunnion_around_a_steep_wall: Trunnion, wall(), [];
    dmu_across_the_pole: Dmu70e, traverse(0.0, 24), [];
    dmu_near_the_pole: Dmu70e, traverse(0.6, 25), [];
    dmu_farther_from_the_pole: Dmu70e, traverse(6.0, 24), [];
    dmu_past_the_pole_on_one_side: Dmu70e, past(0.002), [];
    dmu_past_the_pole_on_the_other: Dmu70e, past(-0.002), [];
    dmu_on_the_swirl: Dmu70e, swirl(), [];
    lola_across_the_dome: LolaXoyzba, traverse(0.0, 25), [];
    lola_on_the_swirl: LolaXoyzba, swirl(), [];
    multiprodesk_around_the_bar: MultiProDesk, around(24), [];
    multiprodesk_forty_revolutions_around_the_bar: MultiProDesk, around(838), [];
    trunnion_across_the_pole: Trunnion, traverse(0.0, 24), [('A', -120.0, 1.0)];
    trunnion_near_the_pole: Trunnion, traverse(0.6, 25), [];
    trunnion_on_the_swirl: Trunnion, swirl(), [];
    head_table_across_the_pole: HeadTable, traverse(0.0, 25), [];
    head_table_near_the_pole: HeadTable, traverse(0.6, 25), [];
    head_table_on_the_swirl: HeadTable, swirl(), [];
    nutating_head_across_the_pole: NutatingHead, traverse(0.0, 24), [];
    nutating_head_near_the_pole: NutatingHead, traverse(0.6, 25), [];
    nutating_head_past_the_pole_on_one_side: NutatingHead, past(0.002), [('B', 0.0, 180.0), ('C', -400.0, 400.0)];
    nutating_head_past_the_pole_on_the_other: NutatingHead, past(-0.002), [('B', 0.0, 180.0), ('C', -400.0, 400.0)];
    nutating_head_on_the_swirl: NutatingHead, swirl(), [];
}

/// Axis values at both ends of each feed block, mm and degrees, and its printed time, min.
fn timed<M: Machine>(text: &str) -> Vec<(Vec<f64>, Vec<f64>, f64)> {
    let place =
        |position: &Axes| -> Option<Vec<f64>> { M::AXES.iter().map(|axis| position.get(axis.letter)).collect() };
    let mut before: Option<Vec<f64>> = None;
    let mut blocks = Vec::new();
    for step in straight(text) {
        let (line, now) = (step.line, place(&step.state.position));
        if let (Some(from), Some(to), Some(feed)) = (&before, &now, step.feed()) {
            let travel = |wanted: AxisKind| {
                let axes = M::AXES.iter().enumerate().filter(move |(_, axis)| axis.kind == wanted);
                axes.map(|(index, _)| (to[index] - from[index]).powi(2)).sum::<f64>().sqrt()
            };
            let minutes = match feed {
                Feed::InverseTime(per_minute) => 1.0 / per_minute,
                Feed::PerRevolution(_) => panic!("line {line}: G95"),
                Feed::PerMinute(feed) => {
                    assert!(travel(AxisKind::Rotary) == 0.0, "line {line}: a rotary axis moves under G94");
                    travel(AxisKind::Linear) / feed
                }
            };
            blocks.push((from.clone(), to.clone(), minutes));
        }
        before = now;
    }
    blocks
}

/// Expected time of the feed blocks of a program, min: each takes the length of its tip path at 900 mm/min, and so long
/// that the tip is nowhere faster by more than a hundredth.
fn expected_minutes<M: Machine>(config: &Config, blocks: &[(Vec<f64>, Vec<f64>, f64)]) -> f64 {
    let mut machine = M::default();
    machine.set_up(Vector3::from(PART), LENGTH);
    let oracle = Oracle::of(&machine);
    let unit_mm = 10_f64.powi(-(config.formats.linear_mm as i32));
    let counted_mm = |from: &[f64], to: &[f64]| {
        let in_radians = |(value, axis): (&f64, &pp_runtime::kinematics::Axis)| {
            if axis.kind == AxisKind::Rotary { value.to_radians() } else { *value }
        };
        let [from, to] = [from, to].map(|values| values.iter().zip(M::AXES).map(in_radians).collect::<Vec<f64>>());
        let length_mm = (oracle.forward(&to).tip - oracle.forward(&from).tip).norm();
        timed_mm(length_mm, deviation(&oracle, &from, &to, POINTS).tip_rate_mm, unit_mm)
    };
    blocks.iter().map(|(from, to, _)| counted_mm(from, to) / 900.0).sum()
}

/// Share by which a bound of the speed of the tip may be above its largest speed, and five decimals of the linear
/// words.
const TIMED: f64 = 1e-4;

fn assert_times_add_up<M: Machine>(poses: &[Pose]) {
    let (poses, mut config) = (as_written(poses), config::<M>(PART));
    config.formats.linear_mm = 5;
    let (report, text) = posted::<M>(&config, &poses);
    let blocks = timed::<M>(&text);
    let wanted = expected_minutes::<M>(&config, &blocks);
    let cutting_min = report.times.cutting_min;
    assert!(abs_diff_eq!(cutting_min / wanted, 1.0, epsilon = TIMED), "{}: {:?}, {wanted} min", M::NAME, report.times);
    assert_eq!(report.times.slowed_blocks, 0);
    // Six digits of an F, and three decimals of an F per minute.
    let printed: f64 = blocks.iter().map(|(_, _, minutes)| minutes).sum();
    assert!(
        abs_diff_eq!(printed / wanted, 1.0, epsilon = TIMED),
        "{}: {printed} min printed, expected {wanted}",
        M::NAME
    );
}

#[test]
fn block_times_add_up_to_the_tip_path_over_the_feed() {
    assert_times_add_up::<SpinnerU5620>(&swirl());
    assert_times_add_up::<Dmu70e>(&swirl());
    assert_times_add_up::<LolaXoyzba>(&swirl());
    assert_times_add_up::<MultiProDesk>(&around(24));
    assert_times_add_up::<Trunnion>(&swirl());
    assert_times_add_up::<HeadTable>(&traverse(0.6, 25));
    assert_times_add_up::<NutatingHead>(&swirl());
}

fn assert_no_axis_is_too_fast<M: Machine>(poses: &[Pose]) {
    let (poses, mut config) = (as_written(poses), config::<M>(PART));
    config.formats.linear_mm = 5;
    for axis in M::AXES {
        let speed = if axis.kind == AxisKind::Rotary { 400_f64.to_radians() } else { 1500.0 };
        config.set_up.speeds.insert(axis.letter, speed);
    }
    let (report, text) = posted::<M>(&config, &poses);
    let blocks = timed::<M>(&text);
    let (times, wanted) = (&report.times, expected_minutes::<M>(&config, &blocks));
    assert!(times.slowed_blocks > 0 && times.slowed_min > 0.0, "{}: {times:?}", M::NAME);
    let excess = times.cutting_min - wanted;
    let same = abs_diff_eq!(excess, times.slowed_min, epsilon = TIMED * times.cutting_min);
    assert!(same, "{}: {excess} min more, {times:?}", M::NAME);
    for (from, to, minutes) in blocks {
        for (index, axis) in M::AXES.iter().enumerate() {
            let speed = (to[index] - from[index]).abs() / minutes;
            let most = if axis.kind == AxisKind::Rotary { 400.0 } else { 1500.0 };
            assert!(speed <= most * (1.0 + 1e-5), "{}: {} at {speed} of {most}", M::NAME, axis.letter);
        }
    }
    config.motion.feed.keep_speeds = false;
    assert_eq!(posted::<M>(&config, &poses).0.times.slowed_blocks, 0);
}

#[test]
fn no_axis_is_faster_than_its_speed_and_the_excess_is_reported() {
    assert_no_axis_is_too_fast::<SpinnerU5620>(&swirl());
    assert_no_axis_is_too_fast::<Dmu70e>(&swirl());
    assert_no_axis_is_too_fast::<LolaXoyzba>(&swirl());
    assert_no_axis_is_too_fast::<MultiProDesk>(&around(24));
    assert_no_axis_is_too_fast::<Trunnion>(&traverse(0.6, 25));
    assert_no_axis_is_too_fast::<NutatingHead>(&swirl());
}

/// Largest angle, rad, of a tool axis of a program from the programmed one: that of the even rotation where the tip is,
/// or within `tip_mm` of there along its line. Of several motions near the tip the most favourable counts.
fn largest_lag<M: Machine>(config: &Config, poses: &[Pose], text: &str, tip_mm: f64) -> f64 {
    let oracle = Oracle::of(
        &config
            .set_up
            .machine::<M>()
            .map(|mut machine| {
                machine.set_up(Vector3::from(config.set_up.part_origin), LENGTH);
                machine
            })
            .expect("valid"),
    );
    let lag = |tip: &Point3<f64>, axis: &Vector3<f64>, ends: &[Pose]| {
        let (line, rotated) = (ends[1].tip - ends[0].tip, ends[0].axis.angle(&ends[1].axis));
        let length = line.norm();
        let share = ((tip - ends[0].tip).dot(&line) / (length * length)).clamp(0.0, 1.0);
        if (ends[0].tip + line * share - tip).norm() > tip_mm {
            return f64::INFINITY;
        }
        let programmed = rotated_evenly(&ends[0].axis, &ends[1].axis, share);
        angle_between(axis, &programmed) - rotated * tip_mm / length
    };
    let blocks = printed::<M>(text);
    let mut largest = 0.0_f64;
    for pair in blocks.windows(2) {
        for point in 0..=200 {
            let share = f64::from(point) / 200.0;
            let values: Vec<f64> = pair[0].iter().zip(&pair[1]).map(|(from, to)| from + (to - from) * share).collect();
            let pose = oracle.forward(&values);
            let least = poses.windows(2).map(|ends| lag(&pose.tip, &pose.axis, ends)).fold(f64::INFINITY, f64::min);
            assert!(least.is_finite(), "{}: the tip is off its path", M::NAME);
            largest = largest.max(least);
        }
    }
    largest
}

/// Lag of a path on a machine with even rotary axes, and in step with the tip, degrees: measured, and stated by the
/// summary.
fn lags<M: Machine>(poses: &[Pose]) -> [[f64; 2]; 2] {
    let poses = as_written(poses);
    [ToolPosture::Axes, ToolPosture::Plane].map(|posture| {
        let mut config = config::<M>(PART);
        config.set_up.limits.insert('B', Some(Limits { lower: -1.9, upper: 1.9 }));
        config.motion.tip.tool_posture = posture;
        config.motion.mode = Mode::Axes;
        let (report, text) = posted::<M>(&config, &poses);
        let rounding = 0.002;
        let measured = largest_lag::<M>(&config, &poses, &text, config.motion.tolerance_mm + rounding);
        [measured, report.statistics.largest_lag_rad].map(f64::to_degrees)
    })
}

#[test]
fn a_tool_axis_in_step_keeps_to_its_tolerance_and_any_lag_is_stated() {
    let tolerance = Config::default().motion.axis_tolerance_path_rad.to_degrees();
    // One motion of 70 degrees, along a great circle that no rotary axis follows alone.
    let wide = [[0.3, -0.5, 0.8], [0.7, 0.6, 0.4]].map(|axis| unit(Vector3::from(axis)));
    let wide: Vec<Pose> = [[0.0; 3], [60.0, 10.0, -5.0]]
        .into_iter()
        .zip(wide)
        .map(|(tip, axis)| Pose { tip: tip.into(), axis })
        .collect();
    for poses in [wall(), swirl(), outward(), traverse(3.0, 12), past(0.01), wide] {
        for [even, in_step] in [lags::<SpinnerU5620>(&poses), lags::<Dmu70e>(&poses), lags::<HeadTable>(&poses)] {
            assert!(even[0] <= even[1] + 1e-4 && in_step[0] <= in_step[1] + 1e-4, "{even:?} {in_step:?}");
            assert!(in_step[0] <= tolerance && in_step[1] <= tolerance, "{in_step:?}");
        }
    }
}
