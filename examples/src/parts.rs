//! Parts: a convex and a concave surface, a surface for four axes, a spiral groove, two tilted faces.
//!
//! Lengths are in mm; the part zero is on the top face, Z up. A pose is tool tip and tool axis, as in CL data. Every
//! operation starts 50 mm above its first cut, approaches along the tool axis, and retracts along the tool axis.

use core::f64::consts::TAU;

use pp_runtime::kinematics::Pose;
use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};

/// Distance of the start point from the first cut, along the tool axis.
pub const APPROACH_MM: f64 = 50.0;
/// Retract distance from the last cut, along the tool axis.
pub const RETRACT_MM: f64 = 60.0;

/// A tool.
#[derive(Debug, Clone)]
pub struct Tool {
    /// Tool number.
    pub number: u32,
    /// Tool name.
    pub name: &'static str,
    /// Diameter.
    pub diameter_mm: f64,
    /// Corner radius; half the diameter for a ball cutter.
    pub corner_radius_mm: f64,
    /// Length of the cutting edge.
    pub flute_length_mm: f64,
    /// Gauge length; written to the file if given.
    pub gauge_length_mm: Option<f64>,
}

/// One motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Move {
    /// Pose at its end.
    pub pose: Pose,
    /// Feed; `None` for a rapid.
    pub feed_mm_per_min: Option<f64>,
}

/// One operation: the motions of one tool from approach to retract.
#[derive(Debug, Clone)]
pub struct Operation {
    /// Name of the operation.
    pub name: &'static str,
    /// Its tool.
    pub tool: Tool,
    /// Spindle speed, clockwise.
    pub speed_rev_per_min: f64,
    /// Its motions.
    pub moves: Vec<Move>,
}

/// A part program; the machine stops between operations.
#[derive(Debug, Clone)]
pub struct Program {
    /// Name of the program.
    pub name: &'static str,
    /// Its operations.
    pub operations: Vec<Operation>,
}

/// Pose with this tip and a tool axis along `axis`, which need not be a unit vector.
fn pose(tip: [f64; 3], axis: Vector3<f64>) -> Pose {
    Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(axis) }
}

/// The pose retracted by `distance` along its tool axis.
fn lifted(pose: &Pose, distance: f64) -> Pose {
    Pose { tip: pose.tip + pose.axis.into_inner() * distance, axis: pose.axis }
}

/// Feeds of an operation.
struct Feeds {
    plunge_mm_per_min: f64,
    cut_mm_per_min: f64,
}

/// Motions of a pass: rapid above the first pose, plunge, cut, retract.
fn pass(cut: &[Pose], feeds: &Feeds) -> Vec<Move> {
    let (Some(first), Some(last)) = (cut.first(), cut.last()) else { return Vec::new() };
    let mut moves = vec![
        Move { pose: lifted(first, APPROACH_MM), feed_mm_per_min: None },
        Move { pose: *first, feed_mm_per_min: Some(feeds.plunge_mm_per_min) },
    ];
    moves.extend(cut[1..].iter().map(|&pose| Move { pose, feed_mm_per_min: Some(feeds.cut_mm_per_min) }));
    moves.push(Move { pose: lifted(last, RETRACT_MM), feed_mm_per_min: None });
    moves
}

/// `count` values from `start` in equal steps.
fn steps(start: f64, step: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..count).map(move |index| start + step * f64::from(index))
}

fn ball_cutter(number: u32, diameter_mm: f64) -> Tool {
    Tool {
        number,
        name: if diameter_mm > 9.0 { "BALL_D12" } else { "BALL_D8" },
        diameter_mm,
        corner_radius_mm: diameter_mm / 2.0,
        flute_length_mm: 25.0,
        gauge_length_mm: Some(120.0),
    }
}

/// A free-form surface `z = bend · (x²/2Rx + y²/2Ry)`.
#[derive(Debug, Clone, Copy)]
pub struct Surface {
    /// 1: concave, -1: convex.
    pub bend: f64,
    /// Radii of curvature at its middle, along X and along Y.
    pub radii_mm: [f64; 2],
    /// Half its size along X and along Y.
    pub half_mm: [f64; 2],
}

impl Surface {
    /// The dome.
    pub const CONVEX: Self = Self { bend: -1.0, radii_mm: [60.0, 70.0], half_mm: [45.0, 33.0] };
    /// The bowl.
    pub const CONCAVE: Self = Self { bend: 1.0, ..Self::CONVEX };
    /// The trough for one rotary axis.
    pub const TROUGH: Self = Self { bend: 1.0, radii_mm: [200.0, 50.0], half_mm: [40.0, 38.0] };

    fn slopes(&self, x: f64, y: f64) -> [f64; 2] {
        [self.bend * x / self.radii_mm[0], self.bend * y / self.radii_mm[1]]
    }

    /// Height at a point.
    #[must_use]
    pub fn height(&self, x: f64, y: f64) -> f64 {
        let [slope_x, slope_y] = self.slopes(x, y);
        (slope_x * x + slope_y * y) / 2.0
    }
}

/// Pose at a point of a surface, tool axis along the surface normal: the ball touches with its tip.
fn on_surface(surface: &Surface, x: f64, y: f64) -> Pose {
    let [slope_x, slope_y] = surface.slopes(x, y);
    pose([x, y, surface.height(x, y)], Vector3::new(-slope_x, -slope_y, 1.0))
}

/// Rows along X at these `y`. None of them is zero, because the tool would pass through the vertical there.
fn rows(surface: &Surface, ys: impl Iterator<Item = f64>, step: f64, count: u32) -> Vec<Vec<Pose>> {
    ys.map(|y| steps(-surface.half_mm[0], step, count).map(|x| on_surface(surface, x, y)).collect()).collect()
}

/// Rows in alternating direction, connected on the surface.
fn zig_zag(rows: Vec<Vec<Pose>>) -> Vec<Pose> {
    let turned = rows.into_iter().enumerate().map(|(index, mut row)| {
        if index % 2 == 1 {
            row.reverse();
        }
        row
    });
    turned.flatten().collect()
}

/// A dome of 90 × 66 mm, finished with a ball cutter along the surface normal: tilt up to 41.5°.
#[must_use]
pub fn convex() -> Program {
    let cut = zig_zag(rows(&Surface::CONVEX, steps(-33.0, 2.0, 34), 2.5, 37));
    let moves = pass(&cut, &Feeds { plunge_mm_per_min: 1000.0, cut_mm_per_min: 800.0 });
    let tool = ball_cutter(1, 12.0);
    Program {
        name: "CONVEX",
        operations: vec![Operation { name: "FINISH_DOME", tool, speed_rev_per_min: 6000.0, moves }],
    }
}

/// A bowl of 90 × 66 mm, the dome upside down, in one-way rows with a retract and an approach between them.
#[must_use]
pub fn concave_one_way() -> Program {
    let feeds = Feeds { plunge_mm_per_min: 1000.0, cut_mm_per_min: 700.0 };
    // Not symmetric: the path from the end of one row to the start of the next must not cross the vertical either.
    let moves =
        rows(&Surface::CONCAVE, steps(-32.0, 6.0, 12), 2.5, 37).iter().flat_map(|row| pass(row, &feeds)).collect();
    let tool = ball_cutter(2, 12.0);
    Program {
        name: "CONCAVE",
        operations: vec![Operation { name: "FINISH_BOWL", tool, speed_rev_per_min: 6000.0, moves }],
    }
}

/// The same bowl in finer rows, zig-zag.
#[must_use]
pub fn concave_zig_zag() -> Program {
    let cut = zig_zag(rows(&Surface::CONCAVE, steps(-33.0, 2.0, 34), 3.0, 31));
    let moves = pass(&cut, &Feeds { plunge_mm_per_min: 1000.0, cut_mm_per_min: 700.0 });
    let tool = ball_cutter(2, 12.0);
    Program {
        name: "CONCAVE",
        operations: vec![Operation { name: "FINISH_BOWL", tool, speed_rev_per_min: 6000.0, moves }],
    }
}

/// A trough that is also concave along X, for one rotary axis about X.
///
/// The ball touches the surface. The tool axis is perpendicular to X and as near to the surface normal as that allows,
/// so only its `j` and `k` change along a row.
#[must_use]
pub fn concave_four_axes() -> Program {
    let tool = Tool { gauge_length_mm: None, ..ball_cutter(3, 8.0) };
    let radius = tool.corner_radius_mm;
    let touch = |x: f64, y: f64| {
        let [slope_x, slope_y] = Surface::TROUGH.slopes(x, y);
        let normal = Vector3::new(-slope_x, -slope_y, 1.0).normalize();
        let axis = Vector3::new(0.0, -slope_y, 1.0).normalize();
        let contact = Vector3::new(x, y, Surface::TROUGH.height(x, y));
        pose((contact + (normal - axis) * radius).into(), axis)
    };
    let rows = steps(-40.0, 2.5, 33).map(|x| steps(-38.0, 2.0, 39).map(|y| touch(x, y)).collect()).collect();
    let moves = pass(&zig_zag(rows), &Feeds { plunge_mm_per_min: 800.0, cut_mm_per_min: 600.0 });
    Program {
        name: "CONCAVE_4AXIS",
        operations: vec![Operation { name: "FINISH_TROUGH", tool, speed_rev_per_min: 8000.0, moves }],
    }
}

/// Number of turns of the spiral groove.
pub const GROOVE_TURNS: u32 = 20;

/// Section of a groove around a bar.
#[derive(Debug, Clone, Copy)]
pub struct GrooveShape {
    /// Radius of the bar.
    pub bar_mm: f64,
    /// Radius of the lowest point of the groove.
    pub bottom_mm: f64,
    /// Radius of the ball that makes it.
    pub ball_mm: f64,
    /// Distance of its turns.
    pub pitch_mm: f64,
}

impl GrooveShape {
    /// The spiral groove.
    pub const SPIRAL: Self = Self { bar_mm: 25.0, bottom_mm: 23.0, ball_mm: 4.0, pitch_mm: 4.0 };
}

/// A groove 2 mm deep around a bar of 50 mm diameter along X: 20 turns of 4 mm pitch; the angle increases all along it.
///
/// The part zero is on the centre line of the bar. The tool plunges along its axis and cuts from there.
#[must_use]
pub fn spiral_groove() -> Program {
    const PER_TURN: u32 = 60;
    let cut: Vec<Pose> = (0..=GROOVE_TURNS * PER_TURN)
        .map(|index| {
            let turns = f64::from(index) / f64::from(PER_TURN);
            // The angle within the turn, so that every turn has the same sines.
            let (sin, cos) = (TAU * f64::from(index % PER_TURN) / f64::from(PER_TURN)).sin_cos();
            let GrooveShape { pitch_mm, bottom_mm, .. } = GrooveShape::SPIRAL;
            pose([pitch_mm * turns, bottom_mm * sin, bottom_mm * cos], Vector3::new(0.0, sin, cos))
        })
        .collect();
    let tool = Tool { gauge_length_mm: None, ..ball_cutter(4, 8.0) };
    let moves = pass(&cut, &Feeds { plunge_mm_per_min: 200.0, cut_mm_per_min: 400.0 });
    Program {
        name: "SPIRAL_GROOVE",
        operations: vec![Operation { name: "GROOVE", tool, speed_rev_per_min: 5000.0, moves }],
    }
}

/// A face tilted by 30° about Y, milled in rows, and a slot perpendicular to a face tilted by 20° about X.
///
/// Each tool keeps its tool axis (3+2); the program stops between them.
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
        diameter_mm: 20.0,
        corner_radius_mm: 0.0,
        flute_length_mm: 40.0,
        gauge_length_mm: Some(120.0),
    };

    let (sin, cos) = 20f64.to_radians().sin_cos();
    let (u, v) = (Vector3::x(), Vector3::new(0.0, cos, sin));
    // A ramp of 1 mm per pass along the slot, then one pass along its floor.
    let path = [[-30.0, 0.0], [-10.0, 1.0], [-30.0, 2.0], [-10.0, 3.0], [-30.0, 4.0], [-10.0, 4.0], [-30.0, 4.0]];
    let slot: Vec<Pose> =
        path.iter().map(|&[along, depth]| in_plane([0.0, -20.0, 0.0], u, v, [along, 0.0, depth])).collect();
    let slot_mill = Tool {
        number: 2,
        name: "MILL_D8",
        diameter_mm: 8.0,
        corner_radius_mm: 0.0,
        flute_length_mm: 20.0,
        gauge_length_mm: Some(95.0),
    };

    Program {
        name: "TWO_TOOLS",
        operations: vec![
            Operation {
                name: "TILTED_FACE",
                tool: end_mill,
                speed_rev_per_min: 3000.0,
                moves: pass(&face, &Feeds { plunge_mm_per_min: 1000.0, cut_mm_per_min: 900.0 }),
            },
            Operation {
                name: "TILTED_SLOT",
                tool: slot_mill,
                speed_rev_per_min: 7000.0,
                moves: pass(&slot, &Feeds { plunge_mm_per_min: 500.0, cut_mm_per_min: 350.0 }),
            },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::{APPROACH_MM, Move, Program, RETRACT_MM};

    fn five_axes() -> [Program; 4] {
        [super::convex(), super::concave_one_way(), super::concave_zig_zag(), super::two_tools()]
    }

    fn four_axes() -> [Program; 2] {
        [super::concave_four_axes(), super::spiral_groove()]
    }

    /// Smallest angle between the tool axis and the vertical from one motion to the next, degrees.
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
                for (outside, inside, distance) in [(above, start, APPROACH_MM), (out, end, RETRACT_MM)] {
                    assert!(outside.feed_mm_per_min.is_none() && inside.feed_mm_per_min.is_some());
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
