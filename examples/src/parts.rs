//! The parts: a convex and a concave surface, a surface for four axes, a spiral groove, two tilted faces.
//!
//! Millimetres; the part's zero is on its top face, Z up. A pose is the tool's tip and its axis, as in CL data.
//! Every operation starts 50 mm above its first cut, goes in along the axis, and leaves along the axis.

use core::f64::consts::TAU;

use pp_runtime::kinematics::Pose;
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};

/// Above the first cut, along the tool axis.
pub const APPROACH: f64 = 50.0;
/// Out of the last cut, along the tool axis.
pub const RETRACT: f64 = 60.0;

/// A tool.
#[derive(Debug, Clone)]
pub struct Tool {
    /// Its number.
    pub number: u32,
    /// Its name.
    pub name: &'static str,
    /// Diameter.
    pub diameter: f64,
    /// Corner radius: half the diameter is a ball cutter.
    pub corner_radius: f64,
    /// Length of the cutting edge.
    pub flute_length: f64,
    /// Gauge length, stated in the file if given.
    pub gauge_length: Option<f64>,
}

/// One move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Where it ends.
    pub pose: Pose,
    /// mm/min; `None` is a rapid.
    pub feed: Option<f64>,
}

/// What one tool does in one go.
#[derive(Debug, Clone)]
pub struct Operation {
    /// Its name.
    pub name: &'static str,
    /// Its tool.
    pub tool: Tool,
    /// rev/min, clockwise.
    pub speed: f64,
    /// Its moves.
    pub moves: Vec<Move>,
}

/// A part program; the machine stops between operations.
#[derive(Debug, Clone)]
pub struct Program {
    /// Its name.
    pub name: &'static str,
    /// Its operations.
    pub operations: Vec<Operation>,
}

/// `tip` with the tool along `axis`, which need not be a unit vector.
fn pose(tip: [f64; 3], axis: Vector3<f64>) -> Pose {
    Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(axis) }
}

/// The same axis, the tip further out along it.
fn lifted(pose: &Pose, distance: f64) -> Pose {
    Pose { tip: pose.tip + pose.axis.into_inner() * distance, axis: pose.axis }
}

/// Feeds of an operation, mm/min.
struct Feeds {
    plunge: f64,
    cut: f64,
}

/// Rapid above the first pose, in, along, out.
fn pass(cut: &[Pose], feeds: &Feeds) -> Vec<Move> {
    let (Some(first), Some(last)) = (cut.first(), cut.last()) else { return Vec::new() };
    let mut moves =
        vec![Move { pose: lifted(first, APPROACH), feed: None }, Move { pose: *first, feed: Some(feeds.plunge) }];
    moves.extend(cut[1..].iter().map(|&pose| Move { pose, feed: Some(feeds.cut) }));
    moves.push(Move { pose: lifted(last, RETRACT), feed: None });
    moves
}

/// `count` values from `start` in equal steps.
fn steps(start: f64, step: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |index| start + step * f64::from(index))
}

fn ball_cutter(number: u32, diameter: f64) -> Tool {
    Tool {
        number,
        name: if diameter > 9.0 { "BALL_D12" } else { "BALL_D8" },
        diameter,
        corner_radius: diameter / 2.0,
        flute_length: 25.0,
        gauge_length: Some(120.0),
    }
}

/// Half the length of the free-form surfaces.
const HALF_LENGTH: f64 = 45.0;
/// Radii of curvature of the free-form surfaces at their middle, along X and along Y.
const RADII: [f64; 2] = [60.0, 70.0];

/// A point of `z = bend · (x²/2Rx + y²/2Ry)` with the tool along the surface normal: the ball touches with its tip.
fn on_surface(bend: f64, x: f64, y: f64) -> Pose {
    let [slope_x, slope_y] = [bend * x / RADII[0], bend * y / RADII[1]];
    pose([x, y, (slope_x * x + slope_y * y) / 2.0], Vector3::new(-slope_x, -slope_y, 1.0))
}

/// Rows along X at these `y`; at none of them zero, where the tool would pass through the vertical.
fn rows(bend: f64, ys: impl Iterator<Item = f64>, step: f64, count: u32) -> Vec<Vec<Pose>> {
    ys.map(|y| steps(-HALF_LENGTH, step, count).map(|x| on_surface(bend, x, y)).collect()).collect()
}

/// Every other row backwards, one after the other without leaving the surface.
fn zig_zag(rows: Vec<Vec<Pose>>) -> Vec<Pose> {
    let turned = rows.into_iter().enumerate().map(|(index, mut row)| {
        if index % 2 == 1 {
            row.reverse();
        }
        row
    });
    turned.flatten().collect()
}

/// A dome of 90 × 66 mm, finished with a ball cutter along the surface normal: the tool leans outwards up to 41.5°.
#[must_use]
pub fn convex() -> Program {
    let cut = zig_zag(rows(-1.0, steps(-33.0, 2.0, 34), 2.5, 37));
    let moves = pass(&cut, &Feeds { plunge: 1000.0, cut: 800.0 });
    let tool = ball_cutter(1, 12.0);
    Program { name: "CONVEX", operations: vec![Operation { name: "FINISH_DOME", tool, speed: 6000.0, moves }] }
}

/// A bowl of 90 × 66 mm, the dome upside down, in one-way rows: out, over and in again between them.
#[must_use]
pub fn concave_one_way() -> Program {
    let feeds = Feeds { plunge: 1000.0, cut: 700.0 };
    // Not symmetric: the way from the end of one row to the start of the next must not cross the vertical either.
    let moves = rows(1.0, steps(-32.0, 6.0, 12), 2.5, 37).iter().flat_map(|row| pass(row, &feeds)).collect();
    let tool = ball_cutter(2, 12.0);
    Program { name: "CONCAVE", operations: vec![Operation { name: "FINISH_BOWL", tool, speed: 6000.0, moves }] }
}

/// The same bowl in finer rows, zig-zag.
#[must_use]
pub fn concave_zig_zag() -> Program {
    let cut = zig_zag(rows(1.0, steps(-33.0, 2.0, 34), 3.0, 31));
    let moves = pass(&cut, &Feeds { plunge: 1000.0, cut: 700.0 });
    let tool = ball_cutter(2, 12.0);
    Program { name: "CONCAVE", operations: vec![Operation { name: "FINISH_BOWL", tool, speed: 6000.0, moves }] }
}

/// A trough that also sags along X, for one rotary about X.
///
/// The ball touches the surface; the tool stands square to X and as near to the surface normal as that allows, so
/// only its `j` and `k` change along a row.
#[must_use]
pub fn concave_four_axes() -> Program {
    let tool = Tool { gauge_length: None, ..ball_cutter(3, 8.0) };
    let radius = tool.corner_radius;
    let touch = |x: f64, y: f64| {
        let [slope_x, slope_y] = [x / 200.0, y / 50.0];
        let normal = Vector3::new(-slope_x, -slope_y, 1.0).normalize();
        let axis = Vector3::new(0.0, -slope_y, 1.0).normalize();
        let contact = Vector3::new(x, y, (slope_x * x + slope_y * y) / 2.0);
        pose((contact + (normal - axis) * radius).into(), axis)
    };
    let rows = steps(-40.0, 2.5, 33).map(|x| steps(-38.0, 2.0, 39).map(|y| touch(x, y)).collect()).collect();
    let moves = pass(&zig_zag(rows), &Feeds { plunge: 800.0, cut: 600.0 });
    Program { name: "CONCAVE_4AXIS", operations: vec![Operation { name: "FINISH_TROUGH", tool, speed: 8000.0, moves }] }
}

/// Turns of the spiral groove.
pub const GROOVE_TURNS: u32 = 20;

/// A groove 2 mm deep around a bar of 50 mm diameter along X: 20 turns of 4 mm pitch, the angle growing all the way.
///
/// The part's zero is on the centre line of the bar. The tool sinks in along its axis and cuts from there.
#[must_use]
pub fn spiral_groove() -> Program {
    const PER_TURN: u32 = 60;
    let cut: Vec<Pose> = (0..=GROOVE_TURNS * PER_TURN)
        .map(|index| {
            let turns = f64::from(index) / f64::from(PER_TURN);
            // The angle within the turn, so that every turn has the same sines.
            let (sin, cos) = (TAU * f64::from(index % PER_TURN) / f64::from(PER_TURN)).sin_cos();
            pose([4.0 * turns, 23.0 * sin, 23.0 * cos], Vector3::new(0.0, sin, cos))
        })
        .collect();
    let tool = Tool { gauge_length: None, ..ball_cutter(4, 8.0) };
    let moves = pass(&cut, &Feeds { plunge: 200.0, cut: 400.0 });
    Program { name: "SPIRAL_GROOVE", operations: vec![Operation { name: "GROOVE", tool, speed: 5000.0, moves }] }
}

/// A face tilted by 30° about Y, milled in rows, and a slot square to a face tilted by 20° about X.
///
/// Both tools stand still in their face (3+2); the machine stops between them.
#[must_use]
pub fn two_tools() -> Program {
    let in_plane = |origin: [f64; 3], u: Vector3<f64>, v: Vector3<f64>, [along, across, depth]: [f64; 3]| {
        let normal = u.cross(&v);
        let tip = Vector3::from(origin) + u * along + v * across - normal * depth;
        pose(tip.into(), normal)
    };

    let (sin, cos) = 30f64.to_radians().sin_cos();
    let (u, v) = (Vector3::new(cos, 0.0, -sin), Vector3::y());
    let mut face = Vec::new();
    for (row, across) in steps(-28.0, 14.0, 5).enumerate() {
        let ends = if row % 2 == 0 { [-12.0, 52.0] } else { [52.0, -12.0] };
        face.extend(ends.map(|along| in_plane([10.0, 0.0, 0.0], u, v, [along, across, 0.0])));
    }
    let end_mill = Tool {
        number: 1,
        name: "MILL_D20",
        diameter: 20.0,
        corner_radius: 0.0,
        flute_length: 40.0,
        gauge_length: Some(120.0),
    };

    let (sin, cos) = 20f64.to_radians().sin_cos();
    let (u, v) = (Vector3::x(), Vector3::new(0.0, cos, sin));
    // A ramp of 1 mm per length of the slot, then once along its floor.
    let path = [[-30.0, 0.0], [-10.0, 1.0], [-30.0, 2.0], [-10.0, 3.0], [-30.0, 4.0], [-10.0, 4.0], [-30.0, 4.0]];
    let slot: Vec<Pose> =
        path.iter().map(|&[along, depth]| in_plane([0.0, -20.0, 0.0], u, v, [along, 0.0, depth])).collect();
    let slot_mill = Tool {
        number: 2,
        name: "MILL_D8",
        diameter: 8.0,
        corner_radius: 0.0,
        flute_length: 20.0,
        gauge_length: Some(95.0),
    };

    Program {
        name: "TWO_TOOLS",
        operations: vec![
            Operation {
                name: "TILTED_FACE",
                tool: end_mill,
                speed: 3000.0,
                moves: pass(&face, &Feeds { plunge: 1000.0, cut: 900.0 }),
            },
            Operation {
                name: "TILTED_SLOT",
                tool: slot_mill,
                speed: 7000.0,
                moves: pass(&slot, &Feeds { plunge: 500.0, cut: 350.0 }),
            },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{APPROACH, Move, Program, RETRACT};

    fn five_axes() -> [Program; 4] {
        [super::convex(), super::concave_one_way(), super::concave_zig_zag(), super::two_tools()]
    }

    fn four_axes() -> [Program; 2] {
        [super::concave_four_axes(), super::spiral_groove()]
    }

    /// Degrees between the tool and the vertical, smallest on the way from one move to the next.
    fn smallest_tilt([from, to]: [&Move; 2]) -> f64 {
        (0..=100)
            .map(|part| {
                let share = f64::from(part) / 100.0;
                let axis = from.pose.axis.into_inner() * (1.0 - share) + to.pose.axis.into_inner() * share;
                axis.x.hypot(axis.y).atan2(axis.z).to_degrees()
            })
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn the_tool_never_comes_within_a_fifth_of_a_degree_of_vertical() {
        for program in five_axes() {
            for moves in program.operations.iter().map(|operation| &operation.moves) {
                for pair in moves.windows(2) {
                    let tilt = smallest_tilt([&pair[0], &pair[1]]);
                    assert!(tilt > 0.2 && tilt < 50.0, "{}: {tilt}°", program.name);
                }
            }
        }
    }

    #[test]
    fn head_and_inclined_table_reach_every_axis() {
        for program in five_axes() {
            for step in program.operations.iter().flat_map(|operation| &operation.moves) {
                let axis = step.pose.axis;
                assert!(axis.z > 0.0, "{}: an inclined table does not go below horizontal", program.name);
                let (a, b) = ((-axis.y).asin().to_degrees(), axis.x.atan2(axis.z).to_degrees());
                assert!(a.abs() < 45.0 && b.abs() < 45.0, "{}: A {a}° B {b}°", program.name);
            }
        }
    }

    #[test]
    fn four_axes_never_lean_along_x() {
        for program in four_axes() {
            for step in program.operations.iter().flat_map(|operation| &operation.moves) {
                assert!(step.pose.axis.x.abs() <= 0.0, "{}", program.name);
            }
        }
    }

    #[test]
    fn every_operation_goes_in_and_out_along_its_axis() {
        for program in five_axes().iter().chain(&four_axes()) {
            for operation in &program.operations {
                let [above, start, .., end, out] = &operation.moves[..] else { panic!("{} is short", operation.name) };
                for (outside, inside, distance) in [(above, start, APPROACH), (out, end, RETRACT)] {
                    assert!(outside.feed.is_none() && inside.feed.is_some());
                    let way = outside.pose.tip - inside.pose.tip;
                    assert!((way - inside.pose.axis.into_inner() * distance).norm() < 1e-9, "{}", operation.name);
                    assert!((outside.pose.axis.into_inner() - inside.pose.axis.into_inner()).norm() < 1e-15);
                }
            }
        }
    }

    #[test]
    fn the_groove_grows_by_twenty_turns() {
        let program = super::spiral_groove();
        let mut total = 0.0;
        for pair in program.operations[0].moves.windows(2) {
            let (from, to) = (pair[0].pose.axis, pair[1].pose.axis);
            let step = (from.z * to.y - from.y * to.z).atan2(from.dot(&to)).to_degrees();
            assert!((-1e-9..6.1).contains(&step), "{step}° backwards");
            total += step;
        }
        assert!((total - 360.0 * f64::from(super::GROOVE_TURNS)).abs() < 1e-6, "{total}°");
    }
}
