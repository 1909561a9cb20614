//! Blocks between their ends: bounds that decide instead of points.

use std::rc::Rc;

use nalgebra::{Point3, Rotation3, UnitVector3, Vector3};

use super::*;
use crate::check::expect::{Expect, ExpectedAction};
use crate::check::geometry::{ArcPath, PathShape, Segment, ToolPose, tool_pose};
use crate::check::read::{Action, ArcMove, Block, FeedMode, MAX_AXES, State, WorkPlane};
use crate::check::rules::Rules;
use crate::cl::ClEvents;
use crate::kinematics::Pose;
use crate::program::{Arc, Feed};

/// Numbers from -1 to 1 without an order.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }
}

/// Random blocks: how many are decided by their bounds, of those whose F is right, by the speed along the chord and at
/// the ends.
fn decided<M: Machine>() -> [f64; 2] {
    let (control, config) = configured::<M>("linuxcnc", Mode::Axes, "");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let rules = Rules::new(Box::new(M::default()), &policy, Units::Millimetres);
    let data = "UNITS/MM\nLOAD/TOOL,2\nFEDRAT/500,MMPM\nGOTO/0,0,0,0,0,1\n";
    let events = ClEvents::here(Cursor::new(data), policy.reading.clone());
    let mut expect = Expect::new(rules.machine(), events, &policy, rules.rounding().unit_mm);
    expect.fill(1).expect("memory");
    let required = expect
        .get(0)
        .filter(|item| matches!(item.action, ExpectedAction::Motion(_)))
        .expect("a motion")
        .required
        .clone();
    let (linear, rotary) = (rules.words().linear_bits(), rules.words().rotary_bits());
    let mut noise = Noise(7);
    let (mut right, mut decided) = (0.0, [0.0; 2]);
    for turn in 0..1000 {
        let size = 10_f64.powf(2.0 * noise.next() - 1.0);
        let mut words = [[0.0; MAX_AXES]; 2];
        let [first, last] = &mut words;
        for (index, (from, to)) in first.iter_mut().zip(last).enumerate() {
            let (place, step) = match 1 << index {
                bit if linear & bit != 0 => (200.0, size),
                bit if rotary & bit != 0 => (2.0, 0.03 * size),
                _ => (0.0, 0.0),
            };
            *from = place * noise.next();
            *to = *from + step * noise.next();
        }
        let mut block = Block { action: Action::Feed, values: words[1], ..Block::default() };
        let ends = words.map(|words| rules.pose_from(&words, &block));
        let rounding = *rules.rounding();
        let motion = ends.map(|end| {
            let axis = (end.axis + noise.vector() * 0.5 * rounding.axis_rad).normalize();
            ToolPose { tip: end.tip + noise.vector() * 0.5 * rounding.tip_mm, axis }
        });
        let segment = Segment { from: motion[0], to: motion[1], shape: PathShape::Line };
        let path = rules.path(words[0], &block);
        let ends = [&ends[0], &ends[1]];
        let bound = |enough_mm: f64| {
            rules.deviation_bound([&words[0], &words[1]], ends, [&segment.from, &segment.to], enough_mm)
        };
        let (bound, rough) = (bound(0.0), bound(f64::INFINITY));
        let measured = rules.deviation(&path, ends, &segment, 0.0).expect("it rotates");
        assert!(measured.tip_mm <= bound.tip_mm + 1e-12, "{turn}: {measured:?} {bound:?}");
        assert!(bound.tip_mm <= rough.tip_mm + 1e-12, "{turn}: {bound:?} {rough:?}");
        assert!(measured.axis_rad <= bound.axis_rad + 1e-12, "{turn}: {measured:?} {bound:?}");
        assert!(measured.tip_rate_mm <= bound.tip_rate_mm + 1e-12, "{turn}: {measured:?} {bound:?}");

        let rates = rules.rates_by_ends([&words[0], &words[1]], ends).expect("it rotates");
        let within = rates[0] - 1e-12..=rates[1] + 1e-12;
        assert!(within.contains(&measured.tip_rate_mm), "{turn}: {measured:?} {rates:?}");

        let lengths = (segment.length_between(ends.map(|end| &end.tip)), segment.length());
        let feed = Some(Feed::PerMinute(500.0));
        let stroke =
            |deviation| rules.stroke(&words[0], &block, lengths, feed, &required).with_tip_rate(deviation, &required);
        let (even, followed) = (stroke(None), stroke(Some(&measured)));
        for part in -40..=40 {
            let written = Some(500.0 / lengths.0 * (1.0 + 0.001 * f64::from(part)));
            block.state = State { feed: written, feed_mode: Some(FeedMode::InverseTime), ..State::default() };
            let fault = rules.feed_fault(&followed, &block.state, &segment, [&segment.from, &segment.to]);
            let plainly = [[0.0, bound.tip_rate_mm], rates]
                .map(|rates| rules.is_feed_plainly_right(&even, &block.state, rates, &required));
            assert!(plainly == [false; 2] || fault.is_none(), "{turn}: {written:?} {fault:?}");
            right += f64::from(u8::from(fault.is_none()));
            for (share, plainly) in decided.iter_mut().zip(plainly) {
                *share += f64::from(u8::from(plainly));
            }
        }
    }
    decided.map(|decided| decided / right)
}

#[test]
fn bounds_of_a_block_are_never_below_what_its_points_show_and_decide_no_f_that_they_would_refuse() {
    let shares = [decided::<Tables>(), decided::<HeadTable>(), decided::<TwoInHead>()];
    assert!(shares.iter().all(|[chord, ends]| *chord > 0.3 && *ends > 0.5), "{shares:?}");
}

/// A straight block that rotates nothing is led as its length says, whatever the chain of its axes.
#[test]
fn the_speed_of_a_tip_is_not_judged_where_nothing_rotates() {
    let (control, config) = configured::<Tables>("linuxcnc", Mode::Axes, "");
    let policy = config.check_policy::<Tables>(control, None).expect("it can be checked");
    let rules = Rules::new(Box::new(Tables::default()), &policy, Units::Millimetres);
    let before = [0.1; MAX_AXES];
    let mut after = before;
    rules.words().xyz().iter().flatten().for_each(|index| after[*index] += 5.0);
    let block = Block { action: Action::Feed, values: after, ..Block::default() };
    let ends = [before, after].map(|words| rules.pose_from(&words, &block));
    assert_eq!(rules.rates_by_ends([&before, &after], [&ends[0], &ends[1]]), None);
}

/// Random arcs with the rotary axes at rest, each as a part of a motion that is about the same arc: their deviation is
/// that of their points, and their bound is no smaller. Returns the share of those that are decided by a bound of up to
/// twice their deviation.
fn follows_arcs<M: Machine>(by_mm: f64) -> f64 {
    let (control, config) = configured::<M>("linuxcnc", Mode::Axes, "");
    let policy = config.check_policy::<M>(control, None).expect("it can be checked");
    let rules = Rules::new(Box::new(M::default()), &policy, Units::Millimetres);
    let mut noise = Noise(11);
    let (count, mut decided) = (500, 0.0);
    for turn in 0..count {
        let mut before = [0.0; MAX_AXES];
        let bits = (rules.words().linear_bits(), rules.words().rotary_bits());
        for (index, word) in before.iter_mut().enumerate() {
            let bit = 1 << index;
            *word = noise.next()
                * if bits.0 & bit != 0 {
                    100.0
                } else if bits.1 & bit != 0 {
                    2.0
                } else {
                    0.0
                };
        }
        let plane = [WorkPlane::Xy, WorkPlane::Zx, WorkPlane::Yz][turn as usize % 3];
        let [u, v, w] = plane.axes().map(|axis| rules.words().xyz()[axis].expect("it has X, Y and Z"));
        let radius = 10_f64.powf(1.5 * noise.next());
        let by_mm = by_mm.min(0.01 * radius);
        let (sine, cosine) = (3.0 * noise.next()).sin_cos();
        // One in five goes round more than once.
        let sweep = if turn % 5 == 0 { 20.0 } else { 3.0 } * noise.next();
        let (mut centre, mut values) = ([0.0; 3], before);
        centre[plane.axes()[0]] = before[u] - radius * cosine;
        centre[plane.axes()[1]] = before[v] - radius * sine;
        let (far, rise) = ((3.0 * noise.next()).sin_cos(), if turn % 2 == 0 { 0.0 } else { 5.0 * noise.next() });
        (values[u], values[v], values[w]) = (before[u] + far.0, before[v] + far.1, before[w] + rise);
        let action = Action::Arc(ArcMove { centre, sweep, by_angle: false });
        let state = State { plane: Some(plane), ..State::default() };
        let block = Block { action, values, state, ..Block::default() };
        let path = rules.path(before, &block);
        let tip = |share: f64| rules.pose_from(&path.at(share), &block);

        // The same circle from a place before the block to one behind it.
        let (start, half) = (tip(0.0), tip(0.5).tip);
        let part = 0.4 + 0.3 * noise.next();
        let along = (1.0 - part) * 0.5 * (1.0 + noise.next());
        let axis = rules.pose_from(&axis_words(before, w, 1.0), &block).tip - start.tip;
        let normal = UnitVector3::new_normalize(axis * sweep.signum());
        let climb = axis * rise;
        let middle = {
            let mut words = before;
            (words[u], words[v]) = (centre[plane.axes()[0]], centre[plane.axes()[1]]);
            rules.pose_from(&words, &block).tip
        };
        let angle = sweep.abs() / part;
        let at = |share: f64| {
            let rotation = Rotation3::from_axis_angle(&normal, (share - along) * angle);
            middle + rotation * (start.tip - middle) + climb * ((share - along) / part)
        };
        assert!((at(along + 0.5 * part) - half).norm() < 1e-9, "{turn}");
        let mut end = |share: f64| Pose {
            tip: Point3::from(at(share) + noise.vector() * by_mm),
            axis: UnitVector3::new_unchecked(start.axis),
        };
        let (from, to) = (end(0.0), end(1.0));
        let centre = Point3::from(middle + noise.vector() * by_mm);
        let round = Arc { centre, normal, start: from, end: to, angle_rad: angle, feed: None };
        let round = Rc::new(ArcPath::of(&round));
        let segment = Segment { from: tool_pose(&from), to: tool_pose(&to), shape: PathShape::Arc(Rc::clone(&round)) };

        let measured = rules.deviation(&path, [&start, &tip(1.0)], &segment, along).expect("an arc").tip_mm;
        // The first and the last of its points are so far from its ends, which are compared on their own.
        let first = (1.0 / (4.0 + 2.0 * (sweep.abs() / 0.2).floor())).min(0.02 / sweep.abs());
        let shares = (0..=1000).map(|point| first + (1.0 - 2.0 * first) * 1e-3 * f64::from(point));
        let off = |share: f64| {
            let on = tip(share).tip;
            (on - segment.tip_at(round.share_near(&on, along + part * share).clamp(0.0, 1.0))).norm()
        };
        let largest = shares.map(off).fold(0.0, f64::max);
        assert!((0.993 * largest..1.001 * largest).contains(&measured), "{turn}: {measured} {largest}");
        let bound = rules.arc_bound(&path, &round, along).map_or(f64::INFINITY, |bound| bound.tip_mm);
        assert!(bound >= largest - 1e-9, "{turn}: {bound} {largest}");
        if bound <= 2.0 * largest {
            decided += 1.0 / f64::from(count);
        }
    }
    decided
}

/// Words with one of them changed.
fn axis_words(mut words: [f64; MAX_AXES], index: usize, by: f64) -> [f64; MAX_AXES] {
    words[index] += by;
    words
}

#[test]
fn the_deviation_of_an_arc_is_that_of_its_points() {
    for by_mm in [0.0005, 0.02] {
        let shares = [follows_arcs::<Tables>(by_mm), follows_arcs::<HeadTable>(by_mm), follows_arcs::<Mill>(by_mm)];
        assert!(shares.iter().all(|share| *share > 0.5), "{shares:?}");
    }
}

/// An arc with the ends of its motion and another radius is farthest off in its middle, however short it is.
#[test]
fn the_middle_of_an_arc_with_another_radius_is_seen() {
    let (control, config) = configured::<Mill>("linuxcnc", Mode::Axes, "");
    let policy = config.check_policy::<Mill>(control, None).expect("it can be checked");
    let rules = Rules::new(Box::new(Mill::default()), &policy, Units::Millimetres);
    let [x, y, _] = rules.words().xyz().map(|axis| axis.expect("it has X, Y and Z"));
    for step in 1..200 {
        let (angle, radius, other) = (0.015 * f64::from(step), 100.0, 100.5);
        let chord = 2.0 * radius * (0.5 * angle).sin();
        // Both from the origin along X, about centres below it.
        let below = |radius: f64| (radius * radius - 0.25 * chord * chord).sqrt();
        let mut values = [0.0; MAX_AXES];
        values[x] = chord;
        let sweep = -2.0 * (0.5 * chord / other).asin();
        let action = Action::Arc(ArcMove { centre: [0.5 * chord, -below(other), 0.0], sweep, by_angle: false });
        let state = State { plane: Some(WorkPlane::Xy), ..State::default() };
        let block = Block { action, values, state, ..Block::default() };
        let path = rules.path([0.0; MAX_AXES], &block);
        let pose = |words: &[f64; MAX_AXES]| rules.pose_from(words, &block);
        let (start, end) = (pose(&[0.0; MAX_AXES]), pose(&values));
        let centre = {
            let mut words = [0.0; MAX_AXES];
            (words[x], words[y]) = (0.5 * chord, -below(radius));
            Point3::from(pose(&words).tip)
        };
        let at = |pose: &ToolPose| Pose { tip: Point3::from(pose.tip), axis: UnitVector3::new_unchecked(pose.axis) };
        let normal = -Vector3::z_axis();
        let round = Arc { centre, normal, start: at(&start), end: at(&end), angle_rad: angle, feed: None };
        let shape = PathShape::Arc(Rc::new(ArcPath::of(&round)));
        let segment = Segment { from: start, to: end, shape };
        let measured = rules.deviation(&path, [&start, &end], &segment, 0.0).expect("an arc").tip_mm;
        let height = |radius: f64| radius - below(radius);
        let middle = (height(radius) - height(other)).abs();
        assert!((measured - middle).abs() < 1e-6 * middle + 1e-12, "{angle}: {measured} {middle}");
    }
}

/// Operations of one tool and one tool axis over a clearance geometry; what comes between them decides.
#[test]
fn an_operation_goes_on_over_the_clearance_geometry() {
    let operations = |between: &str, first: &str| {
        format!(
            "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nCOOLNT/ON\nFEDRAT/300,MMPM\nRAPID\nGOTO/0,0,60,0,0,1\nRAPID\n\
             GOTO/0,0,2\nGOTO/0,0,-1\nGOTO/20,0,-1\nRAPID\nGOTO/20,0,60\n{between}RAPID\nGOTO/{first}\nRAPID\nGOTO/0,9,2,0,0,1\n\
             GOTO/0,9,-1\nGOTO/20,9,-1\nRAPID\nGOTO/20,9,60\n"
        )
    };
    let set_up = "retract.clearance = { plane = 50 }\n";
    let name = "END-OF-PATH\nTOOL PATH/B,TOOL,T1\n";
    let again = format!("{name}LOADTL/1\n");
    let goes_on =
        [(name, "0,9,60,0,0,1"), (&*again, "0,9,60,0,0,1"), (&*format!("{again}SPINDL/RPM,900,CLW\n"), "0,9,55,0,0,1")];
    for control in ["fanuc", "haas", "siemens", "linuxcnc", "heidenhain"] {
        for (between, first) in &goes_on {
            let data = operations(between, first);
            let program = posted_right::<Tables>(control, Mode::Axes, set_up, &data);
            let safe = posted_right::<Tables>(control, Mode::Axes, &format!("transition = \"safe\"\n{set_up}"), &data);
            let retracts =
                |program: &str| ["G53", "SUPA", "M91"].iter().map(|code| program.matches(code).count()).sum::<usize>();
            assert!(retracts(&program) < retracts(&safe), "{control}: {program}");
            // What goes on is no harm where it is asked to be safe, and the other way round it is.
            assert_told::<Tables>(control, Mode::Axes, &format!("transition = \"safe\"\n{set_up}"), &data, &program);
        }
        let blocks = "program.operation_start = [\"M77\"]\ncontrol.effects = { M77 = \"none\" }\n\
                      retract.clearance = { plane = 50 }\n";
        let stays_safe = [
            // Another tool, another axis, a point in the geometry, a stop, no geometry.
            (set_up, operations(&format!("{name}LOADTL/2\n"), "0,9,60,0,0,1")),
            (set_up, operations(name, "0,9,60,0.6,0,0.8")),
            (set_up, operations(name, "0,9,40,0,0,1")),
            (set_up, operations(&format!("STOP\n{name}"), "0,9,60,0,0,1")),
            ("retract.distance = 20\n", operations(name, "0,9,60,0,0,1")),
            (blocks, operations(name, "0,9,60,0,0,1")),
        ];
        for (set_up, data) in &stays_safe {
            let safe = format!("transition = \"safe\"\n{set_up}");
            let [auto, safe] = [set_up, &*safe].map(|set_up| posted_right::<Tables>(control, Mode::Axes, set_up, data));
            let steps = |program: &str| program.lines().filter(|line| !line.starts_with(['(', ';', '*'])).count();
            assert_eq!(steps(&auto), steps(&safe), "{control}: {auto}");
        }
    }
}

/// The lift over a hole is for a cycle; a cut by motions begins where the CL data begins it.
#[test]
fn a_lift_over_a_hole_that_no_cycle_follows_is_found() {
    let data = "UNITS/MM\nTOOL PATH/HOLES,TOOL,T1\nLOADTL/1\nSPINDL/RPM,2000,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,RAPTO,5,FEDTO,-20,RTRCTO,30,MMPM,300\n\
                GOTO/40,0,0\nGOTO/50,0,0\nCYCLE/OFF\n";
    let set_up = "cl.dialect = \"nx\"\nretract.distance = 20\ncycles.output = \"expanded\"\n";
    let program = posted_right::<Mill>("fanuc", Mode::Axes, set_up, data);
    let down = program.match_indices("Z5.\nG1 Z-20.").last().expect("the second hole").0;
    let lifted = format!("{}Z5.\nZ30.\n{}", &program[..down], &program[down + "Z5.\n".len()..]);
    assert_told::<Mill>("fanuc", Mode::Axes, set_up, data, &lifted);
}
