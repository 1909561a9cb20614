//! Tool axes within the declared travel, compared with rotations of many rotary positions.

use pp_codegen::compile;

type Xyz = [f64; 3];

fn reachable(text: &str) -> Vec<String> {
    let tokens = format!("pub struct M; {text}").parse().expect("Rust tokens");
    compile(tokens).unwrap_or_else(|refused| panic!("{text}: {refused:?}")).explanation.reachable.text
}

#[test]
fn each_branch_has_its_cone_within_the_declared_travel() {
    let lines = reachable("chain: C B | X Y Z; limits = { B: -5..110, C: free };");
    assert_eq!(
        lines[1..],
        [
            "Within the declared travel, as angles between the tool axis and the axis of C:",
            "first branch:  C free, B 0 to 110: 0 to 110 degrees",
            "second branch: C free, B -5 to 0: 0 to 5 degrees",
        ]
    );
    // A mill-turn whose B was declared with the wrong sign: the cone shows it.
    let lines = reachable("chain: C | X Y Z B; signs = { B: - }; limits = { B: -110..0, C: free };");
    assert_eq!(lines[2], "first branch:  none: B has no travel on this branch");
    assert_eq!(lines[3], "second branch: C free, B -110 to 0: 0 to 110 degrees");
    assert_eq!(reachable("chain: C B | X Y Z;").len(), 1);
    assert_eq!(
        reachable("chain: A | X Y Z; limits = { A: -30..110 };")[1..],
        [
            "Within the declared travel, as angles between the tool axis and the axis of A:",
            "A -30 to 110: the whole range above, in these positions of A only",
        ]
    );
    // Travel of more than a revolution has parts of both branches.
    let lines = reachable("chain: C B | X Y Z; limits = { B: -200..200, C: -360..360 };");
    assert_eq!(lines[2], "first branch:  C -360 to 360, B -200 to -180 and 0 to 180: 0 to 180 degrees");
    assert_eq!(lines[3], "second branch: C -360 to 360, B -180 to 0 and 180 to 200: 0 to 180 degrees");
}

/// Inclined axes: every position within the travel has its angle in the stated range, and the ends of the range are
/// reached.
#[test]
fn cones_of_inclined_machines_are_those_of_rotated_tools() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for (text, first, second, limits, sign) in [
        (
            "chain: C B | X Y Z; axes = { B: Rx(-45 deg) * Y }; limits = { B: 0..180 };",
            [0.0, 0.0, 1.0],
            [0.0, half, -half],
            (0.0, 180.0),
            1.0,
        ),
        (
            "chain: X Y Z | C B; axes = { B: Rx(45 deg) * Y }; limits = { B: -30..100 }; signs = { B: - };",
            [0.0, 0.0, 1.0],
            [0.0, half, half],
            (-30.0, 100.0),
            -1.0,
        ),
        ("chain: X | Y Z B A; limits = { A: -40..25 };", [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], (-40.0, 25.0), 1.0),
        (
            "chain: B A | X Y Z; axes = { B: (1, 3, 0) }; limits = { A: -100..20 };",
            [0.1_f64.sqrt(), 0.9_f64.sqrt(), 0.0],
            [1.0, 0.0, 0.0],
            (-100.0, 20.0),
            1.0,
        ),
    ] {
        let stated: Vec<(f64, f64)> = reachable(text)
            .iter()
            .filter_map(|line| line.split_once(": "))
            .filter(|(title, _)| title.ends_with("branch"))
            .filter_map(|(_, line)| line.rsplit_once(": "))
            .flat_map(|(_, ranges)| {
                let ranges = ranges.trim_end_matches(" degrees");
                ranges
                    .split(" and ")
                    .filter_map(|range| {
                        let (lower, upper) = range.split_once(" to ")?;
                        Some((lower.parse().ok()?, upper.parse().ok()?))
                    })
                    .collect::<Vec<(f64, f64)>>()
            })
            .collect();
        let mut found: (f64, f64) = (180.0, 0.0);
        for step in 0..=10_000 {
            let word = limits.0 + (limits.1 - limits.0) * f64::from(step) / 10_000.0;
            let tool = rotated(second, sign * word, [0.0, 0.0, 1.0]);
            let angle = dot(first, tool).clamp(-1.0, 1.0).acos().to_degrees();
            assert!(
                stated.iter().any(|(lower, upper)| (lower - 1e-5..=upper + 1e-5).contains(&angle)),
                "{text}: {angle} not in {stated:?}"
            );
            found = (found.0.min(angle), found.1.max(angle));
        }
        let ends = stated.iter().fold((180.0_f64, 0.0_f64), |ends, range| (ends.0.min(range.0), ends.1.max(range.1)));
        assert!((ends.0 - found.0).abs() < 1e-2 && (ends.1 - found.1).abs() < 1e-2, "{text}: {stated:?}, {found:?}");
    }
}

fn dot(a: Xyz, b: Xyz) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Right-handed rotation by a quaternion.
fn rotated(about: Xyz, degrees: f64, v: Xyz) -> Xyz {
    let (s, w) = (degrees.to_radians() / 2.0).sin_cos();
    let [x, y, z] = about.map(|part| part * s);
    let t = [2.0 * (y * v[2] - z * v[1]), 2.0 * (z * v[0] - x * v[2]), 2.0 * (x * v[1] - y * v[0])];
    [
        v[0] + w * t[0] + y * t[2] - z * t[1],
        v[1] + w * t[1] + z * t[0] - x * t[2],
        v[2] + w * t[2] + x * t[1] - y * t[0],
    ]
}
