//! Arcs and helices.

use proptest::prelude::*;

use super::reader::{Motion, motions};
use super::*;
use crate::motion::{ArcPlane, Circle};

/// A circle in a plane from one position to another about a centre, with the sweep angle of these positions.
fn round(plane: ArcPlane, from: Place, to: Place, centre: [i64; 2], clockwise: bool) -> Circle {
    let [first, second, square] = plane.axes();
    let (start, end) = ([from[first], from[second]], [to[first], to[second]]);
    let angle = |point: [i64; 2]| ((point[1] - centre[1]) as f64).atan2((point[0] - centre[0]) as f64);
    let turn = (angle(end) - angle(start)) * if clockwise { -1.0 } else { 1.0 };
    let turn = turn.rem_euclid(std::f64::consts::TAU);
    let sweep = if turn > 0.0 { turn } else { std::f64::consts::TAU };
    Circle {
        plane,
        chain: [0, 1, 2],
        clockwise,
        start,
        centre,
        radius: None,
        sweep_rad: sweep,
        rise: to[square] - from[square],
    }
}

/// A quarter circle, a full circle, a helix and an arc in the ZX plane, from X10 Y0 Z0 about the origin.
fn some_arcs(control: &dyn Control, options: ControlOptions, radius: Option<i64>) -> Vec<String> {
    let quarter = Circle { radius, ..round(ArcPlane::Xy, [10_000, 0, 0], [0, 10_000, 0], [0, 0], false) };
    let whole = round(ArcPlane::Xy, [0, 10_000, 0], [0, 10_000, 0], [0, 0], true);
    let helix = round(ArcPlane::Xy, [0, 10_000, 0], [10_000, 0, -2_500], [0, 0], true);
    let upright = round(ArcPlane::Zx, [10_000, 0, -2_500], [0, 0, 7_500], [-2_500, 0], false);
    let mut blocks = vec![
        Step::Restart { number: 1, changes_tool: false },
        Step::Feed { words: linear([10_000, 0, 0]), feed: per_minute(500) },
        Step::Arc { words: linear([0, 10_000, 0]), circle: &quarter, feed: FEED },
        Step::Arc { words: linear([0, 10_000, 0]), circle: &whole, feed: FEED },
        Step::Arc { words: linear([10_000, 0, -2_500]), circle: &helix, feed: FEED },
    ];
    if control.spellings().arcs.planes[1].is_some() {
        blocks.push(Step::Arc { words: linear([0, 0, 7_500]), circle: &upright, feed: FEED });
        blocks.push(Step::Machine { words: only(0b100, [0; 4]) });
    }
    let blocks = steps(control, &Layout { options, ..milling() }, &blocks);
    let first = blocks.iter().position(|line| line.contains("X10") || line.contains("X+10")).expect("the first motion");
    blocks[first..].to_vec()
}

#[test]
fn arcs_hold_the_words_of_their_plane_and_the_offset_of_the_centre() {
    let arcs = |control| some_arcs(control, ControlOptions::default(), None);
    let expected = [
        "G1 X10 Y0 Z0 F500",
        "G3 X0 Y10 I-10 J0",
        "G2 X0 Y10 I0 J-10",
        "X10 Y0 Z-2.5 I0 J-10",
        "G18 G3 X0 Z7.5 I-10 K0",
        "G17",
        "G53 G0 Z0",
    ];
    assert_eq!(arcs(&LinuxCnc), expected);
    assert_eq!(arcs(&Siemens), expected[..4]);
    assert_eq!(
        arcs(&Fanuc)[1..5],
        ["G3 X0. Y10. I-10. J0.", "G2 X0. Y10. I0. J-10.", "X10. Y0. Z-2.5 I0. J-10.", "G18 G3 X0. Z7.5 I-10. K0."]
    );
    assert_eq!(arcs(&Haas)[1], "G03 X0. Y10. I-10. J0.");
}

#[test]
fn heidenhain_writes_the_pole_and_the_angle_of_a_helix() {
    assert_eq!(
        some_arcs(&Heidenhain, ControlOptions::default(), None),
        [
            "4 L X+10 Y+0 Z+0 R0 F500",
            "5 CC X+0 Y+0",
            "6 C X+0 Y+10 DR+",
            "7 CC X+0 Y+0",
            "8 C X+0 Y+10 DR-",
            "9 CC X+0 Y+0",
            "10 CP IPA-90 IZ-2.5 DR-",
        ]
    );
}

/// A helix ends at an angle, so X and Y after it are exact only up to rounding. The end of a full circle in a `C` block
/// would be a point next to the start, or the start.
#[test]
fn after_a_helix_heidenhain_writes_a_full_circle_by_its_angle() {
    let helix = round(ArcPlane::Xy, [10_000, 0, 0], [0, 10_000, -2_500], [0, 0], false);
    let whole = round(ArcPlane::Xy, [0, 10_000, -2_500], [0, 10_000, -2_500], [0, 0], true);
    let half = round(ArcPlane::Xy, [0, 10_000, -2_500], [0, -10_000, -2_500], [0, 0], true);
    let again = round(ArcPlane::Xy, [0, -10_000, -2_500], [0, -10_000, -2_500], [0, 0], true);
    let blocks = [
        Step::Restart { number: 1, changes_tool: false },
        Step::Feed { words: linear([10_000, 0, 0]), feed: per_minute(500) },
        Step::Arc { words: linear([0, 10_000, -2_500]), circle: &helix, feed: FEED },
        Step::Arc { words: linear([0, 10_000, -2_500]), circle: &whole, feed: FEED },
        Step::Arc { words: linear([0, -10_000, -2_500]), circle: &half, feed: FEED },
        Step::Arc { words: linear([0, -10_000, -2_500]), circle: &again, feed: FEED },
    ];
    let lines = steps(&Heidenhain, &milling(), &blocks);
    let arcs: Vec<&str> = lines.iter().filter(|line| line.contains("DR")).map(|line| &line[2..]).collect();
    let arcs: Vec<&str> = arcs.iter().map(|line| line.trim_start()).collect();
    assert_eq!(arcs, ["CP IPA+90 IZ-2.5 DR+", "CP IPA-360 DR-", "C X+0 Y-10 DR-", "C X+0 Y-10 DR-"]);
}

#[test]
fn a_radius_takes_the_place_of_the_centre() {
    let quarter = |control, radius| some_arcs(control, ControlOptions::default(), Some(radius))[1].clone();
    assert_eq!(quarter(&Fanuc, 10_000), "G3 X0. Y10. R10.");
    assert_eq!(quarter(&Siemens, -10_000), "G3 X0 Y10 CR=-10");
    assert_eq!(quarter(&Heidenhain, 10_000), "5 CR X+0 Y+10 R+10 DR+");
}

/// End; centre and sense of an arc; number that selects rapid, feed or a restart point.
type Leg = (Place, Option<([i64; 2], bool)>, u8);

/// Motions of a program that begins at the origin, with arcs and full circles.
fn any_path() -> impl Strategy<Value = Vec<Leg>> {
    let place = prop::array::uniform3(-3_i64..4).prop_map(|place| place.map(|value| value * 1000));
    let centre = prop::option::weighted(0.6, (prop::array::uniform2(-4_i64..5), any::<bool>()));
    let centre = centre.prop_map(|arc| arc.map(|(at, clockwise)| (at.map(|value| value * 1000 + 500), clockwise)));
    prop::collection::vec((place, centre, 0_u8..8), 1..30)
}

proptest! {
    /// Arcs are the same with every word in every block and without, and on every control.
    #[test]
    fn arcs_are_the_same_on_every_control(path in any_path()) {
        let (mut here, mut circles) = ([0; 3], Vec::new());
        for (to, arc, _) in &path {
            circles.push(arc.map(|(centre, clockwise)| {
                // Both ends have the same distance from the centre, so that the words mean the same on every control.
                let [x, y] = [2 * centre[0] - here[0], 2 * centre[1] - here[1]];
                let end = if to[0] == here[0] { [here[0], here[1], to[2]] } else { [x, y, to[2]] };
                (end, round(ArcPlane::Xy, here, end, centre, clockwise))
            }));
            here = circles.last().and_then(|circle| circle.map(|(end, _)| end)).unwrap_or(*to);
        }
        let mut blocks = vec![Step::Restart { number: 1, changes_tool: false }, Step::Rapid { words: linear([0; 3]) }];
        for ((to, _, kind), circle) in path.iter().zip(&circles) {
            let at = circle.map_or(*to, |(end, _)| end);
            match circle {
                Some((end, circle)) => blocks.push(Step::Arc { words: linear(*end), circle, feed: FEED }),
                None => {
                    let words = linear(*to);
                    blocks.push(if kind % 2 == 0 { Step::Rapid { words } } else { Step::Feed { words, feed: per_minute(500) } });
                }
            }
            if *kind == 7 {
                blocks.extend([Step::Restart { number: 2, changes_tool: false }, Step::Rapid { words: linear(at) }]);
            }
        }
        let read: Vec<_> = CONTROLS.iter().map(|control| {
            let modal = motions(&steps(*control, &milling(), &blocks));
            let every_word = ControlOptions { every_word: true, ..ControlOptions::default() };
            let full = motions(&steps(*control, &Layout { options: every_word, ..milling() }, &blocks));
            // After a helix Heidenhain writes its end once more.
            let moving = |mut motions: Vec<Motion>| {
                motions.dedup_by(|next, before| next.4.is_none() && next.2 == before.2);
                motions
            };
            (moving(modal), moving(full))
        }).collect();
        for (index, (modal, full)) in read.iter().enumerate() {
            prop_assert_eq!(modal, full, "{}", CONTROLS[index].spellings().name);
            prop_assert_eq!(modal, &read[0].0, "{}", CONTROLS[index].spellings().name);
        }
    }
}
