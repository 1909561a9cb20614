//! Removal against dense sampling and known answers.

use std::f64::consts::{PI, TAU};

use nalgebra::{Point3, UnitVector3, Vector3};

use super::profile::{Cutter, Profile};
use super::stock::TriDexel;
use super::sweep::{Covered, EightLines, LANES, SweptPiece, SweptSpace};
use crate::kinematics::Pose;
use crate::simulate::bodies::Mesh;
use crate::simulate::design::TriangleSurface;
use crate::simulate::testing::{CUTTERS, EPS, Random, cut_by_two_threads, places, pose, rounds, upright};

/// A motion through about the middle of a box around zero; every third one does not turn.
fn random_motion(random: &mut Random, kind: usize) -> SweptPiece {
    let axis = random.direction();
    let turn = if kind.is_multiple_of(3) { 0.0 } else { 0.099 * random.unit() };
    let across = axis.cross(&random.direction()).normalize();
    let end = axis * turn.cos() + across * turn.sin();
    // The points on the axis at which the two ends pass.
    let at = [random.within(6.0), random.within(6.0), random.within(6.0)];
    let height = 12.0 * random.unit();
    let tip = Point3::from(at) - axis * height;
    let travel = random.direction() * (4.0 * random.unit());
    let from = Pose { tip, axis: UnitVector3::new_normalize(axis) };
    let to = Pose { tip: tip + travel, axis: UnitVector3::new_normalize(end) };
    SweptPiece::new(&from, &to, 0, 1)
}

/// Distance of a point from the tool at a share.
fn distance_at(piece: &SweptPiece, profile: &Profile, point: [f64; 3], share: f64) -> f64 {
    let (tip, axis) = piece.pose(share);
    let (tip, axis) = (Vector3::from(tip), Vector3::from(axis));
    let w = Vector3::from(point) - tip;
    let h = w.dot(&axis);
    profile.distance(w.cross(&axis).norm(), h).0
}

/// Least distance of a point from the tool on its path: the best of many places, then thirds around the best ones.
fn sampled(piece: &SweptPiece, profile: &Profile, point: [f64; 3], places: u32) -> f64 {
    let at = |share: f64| distance_at(piece, profile, point, share);
    let values: Vec<f64> = (0..=places).map(|place| at(f64::from(place) / f64::from(places))).collect();
    let mut least = f64::INFINITY;
    for (place, value) in values.iter().enumerate() {
        least = least.min(*value);
        let before = place == 0 || values[place - 1] >= *value;
        let after = place + 1 == values.len() || values[place + 1] >= *value;
        if before && after && *value < 0.2 {
            let share = |place: f64| (place / f64::from(places)).clamp(0.0, 1.0);
            let (mut low, mut high) = (share(place as f64 - 1.0), share(place as f64 + 1.0));
            for _ in 0..40 {
                let third = (high - low) / 3.0;
                if at(low + third) < at(high - third) { high -= third } else { low += third }
            }
            least = least.min(at(f64::midpoint(low, high)));
        }
    }
    least
}

/// Compares what is covered of one line with samples: no point of it is farther outside than the tolerance, and no
/// other point is farther inside.
fn compare_line(piece: &SweptPiece, profile: &Profile, line: [f64; 2], places: u32, about: &str) -> (f64, f64, usize) {
    let (low, high) = (-30.0, 30.0);
    let mut lines = EightLines {
        u: [line[0]; LANES],
        v: [line[1]; LANES],
        low: [low; LANES],
        high: [high; LANES],
        live: [false; LANES],
    };
    lines.live[0] = true;
    let mut covered = Covered::default();
    SweptSpace::new(piece, profile, EPS).covered(&lines, &mut covered);
    assert_eq!(covered.uncertified, 0, "{about}");
    covered.join(EPS);
    let parts: Vec<[f64; 2]> = covered.parts.iter().map(|(_, part)| *part).collect();
    let g = |z: f64| sampled(piece, profile, [line[0], line[1], z], places);
    let (mut outside, mut inside): (f64, f64) = (0.0, 0.0);
    for [from, to] in &parts {
        // Ends, and points between them: the part must be whole.
        for share in [0.0, 0.02, 0.1, 0.25, 0.4, 0.5, 0.6, 0.75, 0.9, 0.98, 1.0] {
            outside = outside.max(g(from + share * (to - from)));
        }
    }
    let mut ends: Vec<f64> = parts.iter().flatten().copied().collect();
    ends.sort_by(f64::total_cmp);
    for end in &ends {
        // Just outside a part there must be no sweep, deeper than the tolerance.
        for beyond in [-0.003, 0.003, -0.03, 0.03] {
            let z = end + beyond;
            if parts.iter().all(|[from, to]| z < *from || z > *to) {
                inside = inside.max(-g(z));
            }
        }
    }
    if parts.is_empty() {
        for place in 0..=120 {
            inside = inside.max(-g(-15.0 + 0.25 * f64::from(place)));
        }
    }
    (outside, inside, ends.len())
}

#[test]
fn ends_on_random_lines_are_within_the_tolerance_of_the_sweep() {
    let mut random = Random(7);
    let mut ends = 0;
    for round in 0..rounds(270) {
        let cutter = CUTTERS[round % CUTTERS.len()];
        let piece = random_motion(&mut random, round / CUTTERS.len());
        for profile in cutter.pieces().expect("a tool") {
            for _ in 0..2 {
                let line = [random.within(4.0), random.within(4.0)];
                let about = format!("round {round}: {cutter:?}, {piece:?}, {line:?}");
                let (outside, inside, count) = compare_line(&piece, &profile, line, places(60), &about);
                assert!(outside <= EPS * 1.001, "{about}: {outside} mm outside");
                assert!(inside <= EPS, "{about}: {inside} mm inside");
                ends += count;
            }
        }
    }
    println!("{ends} ends");
    assert!(ends > 350, "{ends}");
}

/// Moves a line sideways until the tool comes within a distance of it, or goes so deep into it.
fn grazing(piece: &SweptPiece, profile: &Profile, line: [f64; 2], way: [f64; 2], depth: f64) -> [f64; 2] {
    let at = |by: f64| [line[0] + by * way[0], line[1] + by * way[1]];
    // The least distance of the whole line, by thirds: it is nearly convex.
    let least = |by: f64| {
        let [u, v] = at(by);
        let mut best = f64::INFINITY;
        for share in 0..=6 {
            let value = |z: f64| distance_at(piece, profile, [u, v, z], f64::from(share) / 6.0);
            let (mut low, mut high) = (-30.0, 30.0);
            for _ in 0..36 {
                let third = (high - low) / 3.0;
                if value(low + third) < value(high - third) { high -= third } else { low += third }
            }
            best = best.min(value(f64::midpoint(low, high)));
        }
        best
    };
    let (mut inside, mut outside) = (0.0, 40.0);
    for _ in 0..26 {
        let middle = f64::midpoint(inside, outside);
        if least(middle) <= -depth { inside = middle } else { outside = middle }
    }
    at(f64::midpoint(inside, outside))
}

#[test]
fn ends_on_grazing_lines_are_within_the_tolerance_of_the_sweep() {
    let mut random = Random(11);
    let mut ends = 0;
    for round in 0..rounds(270) {
        let cutter = CUTTERS[round % CUTTERS.len()];
        let piece = random_motion(&mut random, 1 + round / CUTTERS.len());
        let profile = cutter.pieces().expect("a tool")[0];
        let (tip, axis) = piece.pose(0.5);
        let inner = 0.5 * cutter.length();
        let through = [tip[0] + inner * axis[0], tip[1] + inner * axis[1]];
        let angle = TAU * random.unit();
        let depth = [0.0, 2e-4, 1e-3, 5e-3, 2e-2, -2e-4][round % 6];
        let line = grazing(&piece, &profile, through, [angle.cos(), angle.sin()], depth);
        let about = format!("round {round}: {cutter:?}, depth {depth}, {piece:?}, {line:?}");
        let (outside, inside, count) = compare_line(&piece, &profile, line, places(60), &about);
        assert!(outside <= EPS * 1.001, "{about}: {outside} mm outside");
        assert!(inside <= EPS, "{about}: {inside} mm inside");
        ends += count;
    }
    println!("{ends} ends");
    assert!(ends > 200, "{ends}");
}

#[test]
fn a_tool_that_swings_away_in_the_middle_of_a_block_leaves_material_there() {
    // The flank of a long tool bulges away from a line that both ends of the block touch.
    let cutter = Cutter::Mill { radius: 5.0, corner: 0.0, taper: 0.0, length: 60.0 };
    let profile = cutter.pieces().expect("a tool")[0];
    let half = 0.045_f64;
    let at = |angle: f64| pose([0.0; 3], Vector3::new(0.0, angle.sin(), angle.cos()));
    let piece = SweptPiece::new(&at(-half), &at(half), 0, 1);
    // Along Y at the height of the end of the tool: in the middle of the block the tool is longest.
    let end = 60.0 * half.cos() + 5.0 * half.sin();
    let mut seen = 0;
    for below in [1e-4, 1e-3, 4e-3, 1e-2, 3e-2] {
        let permuted = piece.permuted(1);
        // Across are Z and X; along is Y.
        let line = [end - below, 0.3];
        let (outside, inside, ends) = compare_line(&permuted, &profile, line, 400, "swing");
        assert!(outside <= EPS && inside <= EPS, "{below}: {outside} {inside}");
        seen += usize::from(ends == 4);
    }
    assert!(seen >= 1, "no line has a gap");
}

#[test]
fn ends_of_a_stock_and_its_interior_agree_with_samples() {
    let mut random = Random(3);
    let mut ends = 0;
    for round in 0..27 {
        let cutter = CUTTERS[round % CUTTERS.len()];
        let profiles = cutter.pieces().expect("a tool");
        let mut pieces = Vec::new();
        for number in 0..4 {
            let piece = random_motion(&mut random, round + number);
            for profile in 0..profiles.len() {
                pieces.push(SweptPiece { profile: profile as u32, id: number as u32 + 1, ..piece });
            }
        }
        let mut stock = TriDexel::block([[-6.0; 3], [6.0; 3]], 0.7).expect("a stock");
        stock.cut(&pieces, &profiles, EPS, 1);
        assert_eq!(stock.effort().uncertified, 0);
        let least = |point: [f64; 3], places: u32| {
            let all = pieces.iter().map(|piece| sampled(piece, &profiles[piece.profile as usize], point, places));
            all.fold(f64::INFINITY, f64::min)
        };
        for family in 0..3 {
            let mut lines = Vec::new();
            stock.each(family, |across, spans| lines.push((across, spans.to_vec())));
            for (number, (across, spans)) in lines.iter().enumerate().filter(|(number, _)| number % 9 == round % 9) {
                let at = |along: f64| {
                    let mut point = [0.0; 3];
                    (point[family], point[(family + 1) % 3], point[(family + 2) % 3]) = (along, across[0], across[1]);
                    point
                };
                for span in spans {
                    for (end, id) in [(span.low, span.low_id), (span.high, span.high_id)] {
                        let distance = least(at(f64::from(end)), 100);
                        if id > 0 {
                            assert!(distance <= EPS, "{round}, line {number}: {distance} mm outside");
                            ends += 1;
                        }
                        assert!(distance >= -EPS, "{round}, line {number}: {distance} mm inside");
                    }
                }
                let along = -6.0 + 12.0 * random.unit();
                let distance = least(at(along), 100);
                let kept = spans.iter().any(|span| f64::from(span.low) <= along && along <= f64::from(span.high));
                assert!(
                    if kept { distance > -EPS } else { distance < EPS },
                    "{round}, line {number}: {kept} {distance}"
                );
            }
        }
    }
    assert!(ends > 500, "{ends}");
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let cutter = CUTTERS[1];
    let mut random = Random(5);
    let pieces: Vec<SweptPiece> = (0..40).map(|number| random_motion(&mut random, number)).collect();
    let result = |threads: usize| {
        let mut stock = TriDexel::block([[-6.0; 3], [6.0; 3]], 0.25).expect("a stock");
        let contacts = stock.cut(&pieces, &cutter.pieces().expect("a tool"), EPS, threads);
        let mut spans = Vec::new();
        stock.each(1, |_, found| spans.extend_from_slice(found));
        (contacts, spans)
    };
    assert_eq!(result(1), result(3));
}

#[test]
fn scallops_of_a_ball_have_the_height_of_geometry() {
    let (radius, step) = (4.0, 1.0);
    let ball = Cutter::Mill { radius, corner: radius, taper: 0.0, length: 20.0 };
    // On a plane: passes along X, the line in the middle between two of them.
    let mut stock = TriDexel::block([[-1.5, -1.5, -2.0], [1.5, 1.5, 2.0]], 0.2).expect("a stock");
    let passes: Vec<SweptPiece> = (0..8)
        .map(|pass| {
            let y = step * (f64::from(pass) - 3.5);
            SweptPiece::new(&upright([-6.0, y, 0.0]), &upright([6.0, y, 0.0]), 0, pass as u32 + 1)
        })
        .collect();
    cut_by_two_threads(&mut stock, &passes, &ball);
    let mut crest = f32::NEG_INFINITY;
    stock.each(2, |_, spans| crest = spans.iter().fold(crest, |crest, span| crest.max(span.high)));
    let height = radius - (radius * radius - step * step / 4.0).sqrt();
    assert!((f64::from(crest) - height).abs() < 2e-3, "{crest} {height}");

    // On a cylinder along X and on a sphere, the axis of the tool along the normal: passes about the X axis.
    let (surface, angle) = (20.0, 0.05_f64);
    let centre: f64 = surface + radius;
    let cusp =
        centre * (angle / 2.0).cos() - (radius * radius - (centre * (angle / 2.0).sin()).powi(2)).sqrt() - surface;
    for bend in [0.0, 1.0] {
        let corners = [[-0.3, -0.3, surface - 1.0], [0.3, 0.3, surface + 1.0]];
        let mut stock = TriDexel::block(corners, 0.12).expect("a stock");
        let mut pieces = Vec::new();
        for side in [-0.5, 0.5] {
            let (sine, cosine) = (side * angle).sin_cos();
            let at = |along: f64| {
                let normal = match bend > 0.0 {
                    true => Vector3::new(along.sin(), 0.0, along.cos()),
                    false => Vector3::z(),
                };
                let normal = Vector3::new(normal.x, -sine * normal.z, cosine * normal.z);
                let x = if bend > 0.0 { 0.0 } else { centre * along };
                let tip = Vector3::new(x, 0.0, 0.0) + normal * surface;
                pose(tip.into(), normal)
            };
            let blocks = 160;
            for block in 0..blocks {
                let share = |block: i32| 0.2 * (2.0 * f64::from(block) / f64::from(blocks) - 1.0);
                pieces.push(SweptPiece::new(&at(share(block)), &at(share(block + 1)), 0, 1));
            }
        }
        cut_by_two_threads(&mut stock, &pieces, &ball);
        let mut top = f64::NAN;
        stock.each(2, |across, spans| {
            if across[0].abs() < 1e-6 && across[1].abs() < 1e-6 {
                top = spans.last().map_or(f64::NAN, |span| f64::from(span.high));
            }
        });
        assert!((top - surface - cusp).abs() < 2e-3, "{top} {cusp}");
    }
}

#[test]
fn a_groove_has_the_volume_of_its_section() {
    for (cutter, section) in [
        (Cutter::Mill { radius: 2.0, corner: 0.0, taper: 0.0, length: 20.0 }, 4.0 * 3.0),
        (Cutter::Mill { radius: 2.0, corner: 2.0, taper: 0.0, length: 20.0 }, 0.5 * PI * 4.0 + 4.0 * 1.0),
    ] {
        let mut stock = TriDexel::block([[0.0, -4.0, -5.0], [6.0, 4.0, 0.0]], 0.05).expect("a stock");
        let before = stock.volumes();
        let piece = SweptPiece::new(&upright([-5.0, 0.0, -3.0]), &upright([12.0, 0.0, -3.0]), 0, 1);
        let volume = cut_by_two_threads(&mut stock, &[piece], &cutter);
        let wanted = 6.0 * section;
        assert!((volume - wanted).abs() < 1e-3 * wanted, "{volume} {wanted}");
        for (before, after) in before.iter().zip(stock.volumes()) {
            assert!((before - after - wanted).abs() < 1e-3 * wanted, "{before} {after} {wanted}");
        }
    }
}

#[test]
fn a_drilled_hole_ends_in_the_cone_of_its_point() {
    let (radius, point) = (3.0, 118.0_f64.to_radians());
    let drill = Cutter::Drill { radius, point, length: 30.0 };
    let mut stock = TriDexel::block([[-4.0, -4.0, -10.0], [4.0, 4.0, 0.0]], 0.1).expect("a stock");
    let piece = SweptPiece::new(&upright([0.0, 0.0, 5.0]), &upright([0.0, 0.0, -8.0]), 0, 1);
    let volume = cut_by_two_threads(&mut stock, &[piece], &drill);
    let height = radius / (point / 2.0).tan();
    let wanted = PI * radius * radius * (8.0 - height) + PI * radius * radius * height / 3.0;
    assert!((volume - wanted).abs() < 1e-3 * wanted, "{volume} {wanted}");
    let mut lines = 0;
    stock.each(2, |[x, y], spans| {
        let from = x.hypot(y);
        if from < radius {
            let bottom = spans.last().map_or(f64::NAN, |span| f64::from(span.high));
            assert!((bottom - (-8.0 + from / (point / 2.0).tan())).abs() < 2e-3, "{x} {y} {bottom}");
            lines += 1;
        }
    });
    assert!(lines > 2000);
}

#[test]
fn a_barrel_leaves_its_flank_on_a_wall() {
    let (radius, corner, side) = (4.0, 1.0, 40.0);
    let barrel = Cutter::Barrel { radius, corner, side, length: 20.0 };
    let mut stock = TriDexel::block([[-1.0, 0.0, -3.0], [1.0, 6.0, 18.0]], 0.25).expect("a stock");
    let piece = SweptPiece::new(&upright([-9.0, 0.0, 0.0]), &upright([9.0, 0.0, 0.0]), 0, 1);
    let pieces: Vec<SweptPiece> = (0..2).map(|profile| SweptPiece { profile, ..piece }).collect();
    cut_by_two_threads(&mut stock, &pieces, &barrel);
    // The two circles touch; that of the side is widest at its own height.
    let widest = corner + ((side - corner).powi(2) - (side - radius).powi(2)).sqrt();
    let mut lines = 0;
    stock.each(1, |[z, _], spans| {
        if z > 1.0 {
            let wall = spans.last().map_or(f64::NAN, |span| f64::from(span.low));
            let wanted = radius - side + (side * side - (z - widest).powi(2)).sqrt();
            assert!((wall - wanted).abs() < 2e-3, "{z}: {wall} {wanted}");
            lines += 1;
        }
    });
    assert!(lines > 200);
}

#[test]
fn a_touching_piece_removes_nothing() {
    let cutter = CUTTERS[0];
    let mut stock = TriDexel::block([[-6.0; 3], [6.0; 3]], 0.5).expect("a stock");
    let before = stock.volumes();
    let piece = SweptPiece::new(&upright([0.0, 0.0, 8.0]), &upright([0.0, 0.0, 5.0]), 0, 1).touching();
    let touched = cut_by_two_threads(&mut stock, &[piece], &cutter);
    assert_eq!(stock.volumes().map(f64::to_bits), before.map(f64::to_bits));
    assert!((touched - PI * 9.0).abs() < 1.5, "{touched}");
    // A smaller tool does not reach what it touches with its surface.
    let grazing = SweptPiece::new(&upright([0.0, 0.0, 8.0]), &upright([0.0, 0.0, 5.99]), 0, 1);
    assert!(cut_by_two_threads(&mut stock, &[grazing.grown(-0.02)], &cutter).abs() < 1e-12);
}

#[test]
fn the_surface_of_a_stock_is_closed_and_near_its_ends() {
    // Grooves that cross, one through the whole stock; a wall thinner than the pitch is left between two of them.
    let cutter = Cutter::Mill { radius: 2.0, corner: 0.5, taper: 0.0, length: 20.0 };
    let mut stock = TriDexel::cylinder([0.0, 0.0], 10.0, [-8.0, 0.0], 0.25).expect("a stock");
    let lines = [
        [-12.0, 1.0, -3.0, 12.0, 1.0, -3.0],
        [-12.0, -3.1, -4.0, 12.0, -3.1, -4.0],
        [0.0, -12.0, -20.0, 0.0, 12.0, -5.0],
    ];
    for [x, y, z, to_x, to_y, to_z] in lines {
        let piece = SweptPiece::new(&upright([x, y, z]), &upright([to_x, to_y, to_z]), 0, 1);
        cut_by_two_threads(&mut stock, &[piece], &cutter);
    }
    let (vertices, faces) = stock.surface();
    let mesh = Mesh::new(vertices, faces).expect("a closed body");
    let volume = stock.volumes().iter().sum::<f64>() / 3.0;
    assert!((mesh.volume() - volume).abs() < 1e-2 * volume, "{} {volume}", mesh.volume());
    let surface = TriangleSurface::new(mesh.corners_of_triangles());
    let (mut farthest, mut near, mut ends): (f64, u32, u32) = (0.0, 0, 0);
    for family in 0..3 {
        stock.each(family, |across, spans| {
            // The wall is thinner than the pitch.
            let thick = spans.iter().filter(|span| span.high - span.low > 0.3);
            for end in thick.flat_map(|span| [span.low, span.high]) {
                let mut place = [0.0; 3];
                (place[family], place[(family + 1) % 3], place[(family + 2) % 3]) =
                    (f64::from(end), across[0], across[1]);
                let distance = surface.distance(place, f64::INFINITY);
                farthest = farthest.max(distance);
                near += u32::from(distance < 0.01);
                ends += 1;
            }
        });
    }
    assert!(farthest < 0.25 && f64::from(near) > 0.7 * f64::from(ends), "{farthest} {near} {ends}");
}

#[test]
fn numbers_that_are_no_tool_or_no_stock_are_refused() {
    let fault = |cutter: Cutter| cutter.pieces().expect_err("no tool").to_string();
    let mill = |radius, corner, length| Cutter::Mill { radius, corner, taper: 0.0, length };
    assert!(fault(mill(0.0, 0.0, 10.0)).contains("radius of 0 mm"));
    assert!(fault(mill(3.0, 3.5, 10.0)).contains("corner radius of 3.5 mm"));
    assert!(fault(mill(3.0, f64::NAN, 10.0)).contains("NaN"));
    assert!(fault(mill(3.0, 3.0, 0.0)).contains("cutting length of 0 mm"));
    assert!(fault(Cutter::Drill { radius: 3.0, point: 0.0, length: 10.0 }).contains("point of 0 degrees"));
    assert!(fault(Cutter::Barrel { radius: 4.0, corner: 1.0, side: 3.0, length: 10.0 }).contains("no barrel"));
    let stock = |high: f64, pitch| TriDexel::block([[0.0; 3], [high; 3]], pitch).expect_err("no stock").to_string();
    assert!(stock(10.0, 0.0).contains("pitch of 0 mm"));
    assert!(stock(0.0, 0.1).contains("is empty"));
    assert!(stock(1e4, 0.1).contains("larger pitch"));
}
