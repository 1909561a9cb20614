//! Arcs as a control traces them: programs of random arcs, read and run in centre form, against the CL data's circle.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use proptest::prelude::*;

use super::Cuts;
use crate::config::Config;
use crate::kinematics::machines::{Ay, Cb, Head, Mirrored, Xyz};
use crate::kinematics::{AxisKind, Machine, Pose};
use crate::motion::tests::{Run, config, feed, run, spindle, tool};
use crate::nalgebra::{Point3, Rotation3, UnitVector3, Vector3};
use crate::options::{ArcForm, ArcOutput};
use crate::program::{Arc, Event, Feed, ToolMotion};
use crate::set_up::GivenTool;
use crate::tolerance::writer::WHOLE_REVOLUTIONS;

#[test]
fn an_arc_has_the_pieces_of_its_quotient_by_a_revolution() {
    let near = [
        TAU.next_down(),
        TAU,
        TAU.next_up(),
        TAU * (1.0 + 0.5 * WHOLE_REVOLUTIONS),
        TAU * (1.0 + 3.0 * WHOLE_REVOLUTIONS),
    ];
    for angle_rad in near.into_iter().chain([1e-9, 1.0, 2.0 * TAU, 3.5 * TAU]) {
        let revolutions = (angle_rad / TAU - WHOLE_REVOLUTIONS).ceil().max(1.0) as u32;
        let pieces = Cuts::of(angle_rad).map(|divisions| divisions.map(|cuts| cuts.pieces));
        assert_eq!(pieces, Some([revolutions, 2 * revolutions]), "{angle_rad}");
    }
}

/// Axis words by letter, as far as known.
type WordValues = BTreeMap<char, f64>;

fn number(line: &str, letter: char) -> Option<f64> {
    line.split(' ').find_map(|word| word.strip_prefix(letter)?.parse().ok())
}

/// Points of an arc of the control between two points, ends included; `[first, second, perpendicular]` of the plane.
fn traced(from: [f64; 3], to: [f64; 3], centre: [f64; 2], clockwise: bool) -> Vec<[f64; 3]> {
    const PLACES: usize = 100;
    let polar = |point: [f64; 3]| {
        let (x, y) = (point[0] - centre[0], point[1] - centre[1]);
        (x.hypot(y), y.atan2(x))
    };
    let ((first, begin), (last, end)) = (polar(from), polar(to));
    assert!((first - last).abs() <= 0.00127 + 1e-9, "radii of {first} and {last}: the control refuses this arc");
    let same = (from[0] - to[0]).abs() + (from[1] - to[1]).abs() < 1e-9;
    let turn = if clockwise { begin - end } else { end - begin }.rem_euclid(TAU);
    let turn = if same { TAU } else { turn } * if clockwise { -1.0 } else { 1.0 };
    let place = |index: usize| {
        let part = index as f64 / PLACES as f64;
        let (radius, angle) = (first + (last - first) * part, begin + turn * part);
        [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin(), from[2] + (to[2] - from[2]) * part]
    };
    (0..=PLACES).map(place).collect()
}

/// Centre of an arc given by its radius.
fn centre_of(from: [f64; 3], to: [f64; 3], radius: f64, clockwise: bool) -> [f64; 2] {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let chord = dx.hypot(dy);
    let height = (radius * radius - 0.25 * chord * chord).max(0.0).sqrt();
    // An arc of less than half a circle counter-clockwise has its centre on the left.
    let left = if (radius > 0.0) == clockwise { -height } else { height };
    [0.5 * (from[0] + to[0]) - left * dy / chord, 0.5 * (from[1] + to[1]) + left * dx / chord]
}

/// Axis values in chain order.
fn axes<M: Machine>(words: &WordValues) -> Option<M::Axes> {
    let mut axes = M::HELD;
    for (value, axis) in axes.as_mut().iter_mut().zip(M::AXES) {
        let word = *words.get(&axis.letter)?;
        *value = if axis.kind == AxisKind::Rotary { word.to_radians() } else { word };
    }
    Some(axes)
}

/// Tips of the feed path after the block that reaches `start`, and the number of its blocks that are arcs.
fn path<M: Machine>(run: &Run, machine: &M, start: &Point3<f64>) -> (Vec<Point3<f64>>, usize) {
    let (mut words, mut code, mut plane) = (WordValues::new(), 0, 17);
    let (mut tips, mut arcs, mut begun) = (Vec::new(), 0, false);
    let tip = |words: &WordValues| axes::<M>(words).map(|axes| machine.forward_kinematics(&axes).tip);
    for line in run.lines.iter().filter(|line| !line.starts_with('(') && !line.contains("G53")) {
        for word in line.split(' ').filter_map(|word| word.strip_prefix('G')?.parse().ok()) {
            match word {
                0..=3 => code = word,
                17..=19 => plane = word,
                _ => {}
            }
        }
        if line.contains("G43") || line.contains("G4 ") {
            continue;
        }
        let before = words.clone();
        words.extend("XYZABC".chars().filter_map(|letter| Some((letter, number(line, letter)?))));
        if code >= 2 && "IJKR".chars().any(|letter| number(line, letter).is_some()) {
            let [first, second, perpendicular] = [['Y', 'Z', 'X'], ['Z', 'X', 'Y'], ['X', 'Y', 'Z']][19 - plane];
            let at = |words: &WordValues| [first, second, perpendicular].map(|letter| words[&letter]);
            let (from, to, clockwise) = (at(&before), at(&words), code == 2);
            let offset = |letter| {
                number(
                    line,
                    if letter == 'X' {
                        'I'
                    } else if letter == 'Y' {
                        'J'
                    } else {
                        'K'
                    },
                )
            };
            let centre = match number(line, 'R') {
                Some(radius) => centre_of(from, to, radius, clockwise),
                None => [from[0] + offset(first).expect("a centre"), from[1] + offset(second).expect("a centre")],
            };
            for place in traced(from, to, centre, clockwise) {
                let mut words = words.clone();
                words.extend([first, second, perpendicular].into_iter().zip(place));
                tips.extend(tip(&words).filter(|_| begun));
            }
            arcs += 1;
        } else if before != words && code == 1 {
            tips.extend(tip(&words).filter(|_| begun));
        }
        if code == 1 && tip(&words).is_some_and(|tip| (tip - start).norm() < 2e-3) && !begun {
            begun = true;
            tips.extend(tip(&words));
        }
        if begun && code == 0 {
            break;
        }
    }
    (tips, arcs)
}

/// A circle of the CL data.
#[derive(Debug, Clone, Copy)]
struct CircleCase {
    axis: UnitVector3<f64>,
    normal: UnitVector3<f64>,
    centre: Point3<f64>,
    radius: f64,
    from: f64,
    angle: f64,
    rise: f64,
}

impl CircleCase {
    fn tip(&self, part: f64) -> Point3<f64> {
        let aside = if self.normal.x.abs() < 0.9 { Vector3::x() } else { Vector3::y() };
        let u = self.normal.cross(&aside).normalize() * self.radius;
        let turned = Rotation3::from_axis_angle(&self.normal, self.from + self.angle * part) * u;
        self.centre + turned + self.normal.into_inner() * (self.rise * part)
    }

    /// Angle of a point near the circle, rad from the start, in the turn nearest to the angle before.
    fn angle_at(&self, point: &Point3<f64>, before: f64) -> f64 {
        let u = (self.tip(0.0) - self.centre) / self.radius;
        let aside = point - self.centre;
        let angle = self.normal.cross(&u).dot(&aside).atan2(u.dot(&aside));
        let step = (angle - before).rem_euclid(TAU);
        before + if step > 0.5 * TAU { step - TAU } else { step }
    }

    /// Distance of a point from the circle, near a part of it.
    fn distance(&self, point: &Point3<f64>, part: f64) -> f64 {
        let far = |part: f64| (point - self.tip(part)).norm();
        let (mut low, mut high) = ((part - 0.02).clamp(0.0, 1.0), (part + 0.02).clamp(0.0, 1.0));
        for _ in 0..30 {
            let third = (high - low) / 3.0;
            if far(low + third) < far(high - third) { high -= third } else { low += third }
        }
        far(0.5 * (low + high))
    }

    fn event(&self) -> Event<'static> {
        let pose = |part: f64| Pose { tip: self.tip(part), axis: self.axis };
        let Self { centre, normal, angle, .. } = *self;
        Event::Motion(ToolMotion::Arc(Arc {
            start: pose(0.0),
            end: pose(1.0),
            centre,
            normal,
            angle_rad: angle,
            feed: Some(Feed::PerMinute(500.0)),
        }))
    }

    fn events(&self) -> Vec<Event<'static>> {
        let axis = self.axis.into_inner().into();
        let start = self.tip(0.0);
        let before = start + self.axis.into_inner() * 5.0;
        vec![tool(1), spindle(), feed(before.into(), axis), feed(start.into(), axis), self.event()]
    }
}

fn set_up(change: impl Fn(&mut Config)) -> Config {
    let mut config = config();
    config.set_up.tools.insert(1, GivenTool { length_mm: Some(100.0), ..GivenTool::default() });
    config.motion.retract.distance_mm = Some(20.0);
    change(&mut config);
    config
}

/// Posts one arc; returns the largest distance of its path from the circle, the number of arcs, and all its tips.
fn posted<M: Machine>(config: &Config, wanted: &CircleCase) -> Option<(f64, usize, Vec<Point3<f64>>)> {
    let run = run::<M>(config, &wanted.events());
    if !run.diagnostics.is_empty() {
        return None;
    }
    let mut machine = config.set_up.machine::<M>().expect("valid");
    machine.set_up(config.set_up.part_origin.into(), 100.0);
    let (tips, arcs) = path(&run, &machine, &wanted.tip(0.0));
    let (mut off, mut reached) = (0.0_f64, 0.0_f64);
    let sides = tips.windows(2).flat_map(|pair| {
        let step = pair[1] - pair[0];
        // Points of an arc are near to each other, and a point between two of them is not on the arc.
        let between = if step.norm() > 0.1 * wanted.radius { 20 } else { 1 };
        (0..=between).map(move |part| pair[0] + step * (f64::from(part) / f64::from(between)))
    });
    for tip in sides {
        reached = wanted.angle_at(&tip, reached);
        off = off.max(wanted.distance(&tip, reached / wanted.angle));
    }
    let short = wanted.radius * (wanted.angle - reached).abs() < 0.003;
    assert!(short, "the path ends at {reached} of {}: {:#?}", wanted.angle, run.lines);
    Some((off, arcs, tips))
}

fn up() -> CircleCase {
    CircleCase {
        axis: Vector3::z_axis(),
        normal: Vector3::z_axis(),
        centre: Point3::new(3.0, -4.0, 1.0),
        radius: 12.0,
        from: 0.4,
        angle: 1.9,
        rise: 0.0,
    }
}

fn arc_lines<M: Machine>(config: &Config, wanted: &CircleCase) -> Vec<String> {
    let run = run::<M>(config, &wanted.events());
    assert_eq!(run.diagnostics, []);
    let centre = |line: &&String| ["I", "J", "K", "R"].iter().any(|letter| line.contains(&format!(" {letter}")));
    run.lines.iter().filter(|line| !line.starts_with('(')).filter(centre).cloned().collect()
}

#[test]
fn arcs_are_written_as_arcs_of_their_plane() {
    assert_eq!(arc_lines::<Xyz>(&set_up(|_| {}), &up()), ["G3 X-5.948 Y-11.995 I4.673 J-11.053"].map(str::to_owned));
}

#[test]
fn full_circles_and_the_rest_are_separate_arcs() {
    let helix = CircleCase { angle: 2.25 * TAU, rise: -9.0, ..up() };
    let lines = arc_lines::<Xyz>(&set_up(|_| {}), &helix);
    let z: Vec<_> = lines.iter().map(|line| number(line, 'Z')).collect();
    assert_eq!(z, [Some(-3.0), Some(-7.0), Some(-8.0)], "{lines:#?}");
    assert_eq!(number(&lines[0], 'X'), number(&lines[1], 'X'), "{lines:#?}");
    let flat = CircleCase { angle: TAU, ..up() };
    let lines = arc_lines::<Xyz>(&set_up(|_| {}), &flat);
    assert!(lines.len() == 1 && number(&lines[0], 'X').is_some() && number(&lines[0], 'Z').is_none(), "{lines:#?}");
}

#[test]
fn mirrored_coordinates_reverse_arcs() {
    let straight = arc_lines::<Cb>(&set_up(|_| {}), &up());
    let mirrored = arc_lines::<Mirrored>(&set_up(|_| {}), &up());
    assert!(straight[0].starts_with("G3 ") && mirrored[0].starts_with("G2 "), "{straight:?} {mirrored:?}");
    assert_eq!(number(&straight[0], 'J'), number(&mirrored[0], 'J').map(|value| -value));
}

#[test]
fn a_radius_is_written_where_it_defines_the_centre() {
    let radius = set_up(|config| config.motion.arcs.form = ArcForm::Radius);
    let lines = |angle: f64| arc_lines::<Xyz>(&radius, &CircleCase { angle, ..up() });
    assert_eq!(number(&lines(1.9)[0], 'R'), Some(12.0));
    assert_eq!(number(&lines(4.0)[0], 'R'), Some(-12.0));
    for angle in [TAU, 0.5 * TAU, 0.499 * TAU] {
        assert!(number(&lines(angle)[0], 'R').is_none(), "{angle}");
    }
}

#[test]
fn lines_are_written_where_configured_and_where_the_radius_is_out_of_range() {
    for config in [
        set_up(|config| config.motion.arcs.output = ArcOutput::Lines),
        set_up(|config| config.motion.arcs.largest_radius_mm = 11.0),
        set_up(|config| config.motion.arcs.smallest_radius_mm = 13.0),
    ] {
        assert_eq!(arc_lines::<Xyz>(&config, &up()), Vec::<String>::new());
        let (off, arcs, _) = posted::<Xyz>(&config, &up()).expect("posted");
        assert!(off <= 0.012 && arcs == 0, "{off}");
    }
}

#[test]
fn arcs_written_as_chords_are_counted_by_reason() {
    let counted = |wanted: &CircleCase, change: fn(&mut Config)| {
        let run = run::<Head>(&set_up(change), &wanted.events());
        assert_eq!(run.diagnostics, []);
        (run.statistics.arcs, run.statistics.chorded)
    };
    let none = crate::motion::ChordedArcs::default();
    assert_eq!(counted(&up(), |_| {}), (1, none));
    let leaning = CircleCase { normal: UnitVector3::new_normalize(Vector3::new(0.0, 0.3, 1.0)), ..up() };
    assert_eq!(counted(&leaning, |_| {}), (0, crate::motion::ChordedArcs { plane: 1, ..none }));
    assert_eq!(
        counted(&up(), |config| config.motion.arcs.largest_radius_mm = 1.0),
        (0, crate::motion::ChordedArcs { radius: 1, ..none })
    );
    assert_eq!(
        counted(&up(), |config| config.formats.linear_mm = 1),
        (0, crate::motion::ChordedArcs { rounding: 1, ..none })
    );
}

#[test]
fn an_arc_that_bulges_over_a_limit_is_refused_although_its_ends_are_inside() {
    // The arc bulges in X up to 190 + 12.
    let wide = CircleCase { centre: Point3::new(190.0, 0.0, -50.0), from: -0.9 - 0.25 * TAU, angle: 1.8, ..up() };
    let zero = |config: &mut Config| config.set_up.machine_zero = BTreeMap::from([('X', 0.0)]);
    let run = run::<Xyz>(&set_up(zero), &wide.events());
    let fault = run.error();
    assert!(
        fault.text.contains("X would have to move to 202.000") && fault.location.line == 5,
        "{fault:?} {:?}",
        wide.tip(0.5)
    );
}

#[test]
fn an_arc_that_bulges_below_the_floor_is_refused() {
    // From the lowest point, and from the highest.
    for from in [0.0, 0.5 * TAU] {
        let bowl = CircleCase { normal: Vector3::y_axis(), from, angle: TAU, ..up() };
        let refused = run::<Xyz>(&set_up(|config| config.motion.guards.floor_mm = Some(-10.9)), &bowl.events());
        assert!(refused.error().text.contains("the tool tip moves to Z -11.0000"), "{:?}", refused.error());
        assert_eq!(
            run::<Xyz>(&set_up(|config| config.motion.guards.floor_mm = Some(-11.1)), &bowl.events()).diagnostics,
            []
        );
    }
}

fn unit() -> impl Strategy<Value = UnitVector3<f64>> {
    prop::array::uniform3(-1.0_f64..1.0)
        .prop_filter("a direction", |v| Vector3::from(*v).norm() > 0.2)
        .prop_map(|v| UnitVector3::new_normalize(Vector3::from(v)))
}

/// Circles about the tool axis, about an axis of the workpiece, and about any direction.
fn any_circle(axis: UnitVector3<f64>) -> impl Strategy<Value = CircleCase> {
    let normal = prop_oneof![
        4 => Just(axis),
        4 => Just(-axis),
        1 => Just(Vector3::x_axis()),
        1 => Just(-Vector3::y_axis()),
        1 => Just(Vector3::z_axis()),
        1 => unit(),
    ];
    let angle = prop_oneof![1e-7_f64..0.01, 0.01_f64..7.0, Just(TAU), Just(2.0 * TAU), 6.0_f64..TAU, 0.1_f64..15.0];
    let slope = prop_oneof![Just(0.0), -0.7_f64..0.7];
    (normal, prop::array::uniform3(-60.0_f64..60.0), 0.02_f64..40.0, 0.0_f64..TAU, angle, slope).prop_map(
        move |(normal, centre, radius, from, angle, slope)| CircleCase {
            axis,
            normal,
            centre: centre.into(),
            radius,
            from,
            angle,
            rise: slope * radius * angle,
        },
    )
}

/// Tool axis of a machine at two rotary angles, degrees.
fn axis_at<M: Machine>(angles: [f64; 2]) -> UnitVector3<f64> {
    let mut axes = M::HELD;
    let rotary = M::AXES.iter().enumerate().filter(|(_, axis)| axis.kind == AxisKind::Rotary);
    for ((index, _), angle) in rotary.zip(angles) {
        axes.as_mut()[index] = angle.to_radians();
    }
    M::default().forward_kinematics(&axes).axis
}

fn any_wanted<M: Machine>() -> impl Strategy<Value = CircleCase> {
    (-90.0_f64..90.0, 0.0_f64..80.0).prop_flat_map(|(first, second)| any_circle(axis_at::<M>([first, second])))
}

/// Arcs and lines alike stay within tolerance of the circle, and both end at the same point.
fn within_tolerance<M: Machine>(wanted: &CircleCase) -> Result<usize, TestCaseError> {
    // Without limits: these tests are not about limits, nor about the travel of the safe sequence.
    let free = |config: &mut Config| {
        for axis in M::AXES {
            config.set_up.limits.insert(axis.letter, None);
        }
    };
    let config = set_up(free);
    let Some((off, arcs, tips)) = posted::<M>(&config, wanted) else { return Ok(0) };
    prop_assert!(tips.len() > 1 || wanted.radius * wanted.angle < 0.01, "{tips:?}");
    // Rounding moves the ends of lines, and the ends of arcs along them.
    prop_assert!(off <= 0.0109, "{off} with {arcs} arcs: {wanted:?}");
    for form in [ArcForm::Radius, ArcForm::Centre] {
        let lines = set_up(|config| {
            free(config);
            config.motion.arcs.form = form;
            config.motion.arcs.output = if form == ArcForm::Radius { ArcOutput::Native } else { ArcOutput::Lines };
        });
        let (off, _, other) = posted::<M>(&lines, wanted).expect("posted as before");
        prop_assert!(off <= 0.0109, "{off} {form:?}: {wanted:?}");
        let ends = [tips.last(), other.last()].map(|tip| tip.copied().unwrap_or_else(|| wanted.tip(1.0)));
        prop_assert!((ends[0] - ends[1]).norm() < 1e-9, "{ends:?}");
    }
    Ok(arcs)
}

/// Close to a full circle, the rounding of the ends moves the centre of an arc with radius by much more, and on a steep
/// helix that changes the height.
#[test]
fn a_radius_is_not_written_where_it_displaces_a_steep_helix() {
    let axis = UnitVector3::new_normalize(Vector3::new(0.797_319_3, -0.210_594_66, 0.565_625_16));
    let wanted = CircleCase {
        axis,
        normal: axis,
        centre: Point3::new(-25.628_104_398_322_82, -1.202_534_399_602_534_4, -50.025_363_532_522_17),
        radius: 37.011_357_780_175_62,
        from: 4.195_508_645_271_561,
        angle: 6.195_197_583_527_851,
        rise: -160.368_586_786_825_32,
    };
    for around in 0..40 {
        let wanted = CircleCase { from: wanted.from + f64::from(around) * 1e-4, ..wanted };
        within_tolerance::<Mirrored>(&wanted).unwrap_or_else(|failure| panic!("{failure}"));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn on_a_table_arcs_stay_within_tolerance(wanted in any_wanted::<Cb>()) {
        within_tolerance::<Cb>(&wanted)?;
    }

    #[test]
    fn on_a_head_arcs_stay_within_tolerance(wanted in any_wanted::<Head>()) {
        within_tolerance::<Head>(&wanted)?;
    }

    #[test]
    fn on_a_machine_with_mirrored_coordinates_arcs_stay_within_tolerance(wanted in any_wanted::<Mirrored>()) {
        within_tolerance::<Mirrored>(&wanted)?;
    }

    #[test]
    fn on_a_linear_axis_under_a_table_arcs_stay_within_tolerance(wanted in any_wanted::<Ay>()) {
        within_tolerance::<Ay>(&wanted)?;
    }

    #[test]
    fn clear_arcs_about_the_tool_axis_of_a_table_are_written_as_arcs(
        first in -90.0_f64..90.0,
        second in 0.0_f64..80.0,
        radius in 2.0_f64..40.0,
        angle in 0.3_f64..6.0,
        clockwise in any::<bool>(),
    ) {
        let axis = axis_at::<Cb>([first, second]);
        let wanted = CircleCase { axis, normal: if clockwise { -axis } else { axis }, radius, angle, ..up() };
        prop_assert!(within_tolerance::<Cb>(&wanted)? > 0);
    }
}
