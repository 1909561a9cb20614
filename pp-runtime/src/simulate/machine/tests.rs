//! Distances of moving bodies against dense sampling with a distance of its own: triangle against triangle.

use nalgebra::{Isometry3, Point3, UnitQuaternion, UnitVector3, Vector3};

use super::body::{Body, Shapes};
use super::clearance::{AxesInMotion, Clearances, Meeting, MovingBlock, Share};
use super::links::MachineLinks;
use super::reach::{Ball, Levers};
use crate::kinematics::{AnyMachine, AxisKind, AxisRanges, AxisValues, Branch, Pose};
use crate::set_up::{SetUp, SolidLink};
use crate::simulate::bodies::{CentreLine, Mesh, block, chord_of, turned};
use crate::simulate::testing::{Random, machines};

/// Random motions of each machine; more by `PP_MOTIONS`.
fn rounds() -> usize {
    std::env::var("PP_MOTIONS").ok().and_then(|count| count.parse().ok()).map_or(3, |count: usize| count / 4)
}

/// A body that is not convex, with 32 triangles.
fn lump(random: &mut Random, centre: [f64; 3], size: f64) -> Mesh {
    let octahedron: [[f64; 3]; 6] =
        [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let mut points: Vec<Vector3<f64>> = octahedron.into_iter().map(Vector3::from).collect();
    let mut middles: Vec<([usize; 2], usize)> = Vec::new();
    let mut middle = |points: &mut Vec<Vector3<f64>>, a: usize, b: usize| {
        let key = [a.min(b), a.max(b)];
        if let Some((_, found)) = middles.iter().find(|(other, _)| *other == key) {
            return *found;
        }
        points.push((points[a] + points[b]).normalize());
        middles.push((key, points.len() - 1));
        points.len() - 1
    };
    let mut faces = Vec::new();
    for side in 0..8_usize {
        let [x, y, z] = [0, 1, 2].map(|axis| 2 * axis + (side >> axis & 1));
        let [a, b, c] = if side.count_ones().is_multiple_of(2) { [x, y, z] } else { [x, z, y] };
        let [ab, bc, ca] = [middle(&mut points, a, b), middle(&mut points, b, c), middle(&mut points, c, a)];
        faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]].map(|face| face.map(|index| index as u32)));
    }
    let vertices = points.into_iter().map(|direction| {
        let radius = size * (0.55 + 0.45 * random.unit());
        std::array::from_fn(|axis| centre[axis] + radius * direction[axis])
    });
    Mesh::new(vertices.collect(), faces).expect("a closed body")
}

/// Numbers instead of vectors: without optimisation a hundred thousand distances take seconds and not minutes.
type Corner = [f64; 3];
type Triangle = [Corner; 3];

fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    mesh.faces().iter().map(|face| face.map(|index| mesh.vertices()[index as usize])).collect()
}

fn minus(a: Corner, b: Corner) -> Corner {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Corner, b: Corner) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Corner, b: Corner) -> Corner {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn apart(a: Corner, b: Corner) -> f64 {
    dot(minus(a, b), minus(a, b)).sqrt()
}

/// Distance of two segments.
fn of_segments([a, b]: [Corner; 2], [c, d]: [Corner; 2]) -> f64 {
    let (u, v, w) = (minus(b, a), minus(d, c), minus(a, c));
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let determinant = uu * vv - uv * uv;
    let s = if determinant > 1e-12 * uu * vv { ((uv * vw - vv * uw) / determinant).clamp(0.0, 1.0) } else { 0.0 };
    let t = ((uv * s + vw) / vv).clamp(0.0, 1.0);
    let s = ((uv * t - uw) / uu).clamp(0.0, 1.0);
    let across = [w[0] + u[0] * s - v[0] * t, w[1] + u[1] * s - v[1] * t, w[2] + u[2] * s - v[2] * t];
    dot(across, across).sqrt()
}

/// Distance of a point from the inside of a triangle; infinite beside it.
fn from_face(point: Corner, [a, b, c]: Triangle) -> f64 {
    let normal = cross(minus(b, a), minus(c, a));
    let within = |p: Corner, q: Corner| dot(cross(minus(q, p), minus(point, p)), normal) >= 0.0;
    let inside = within(a, b) && within(b, c) && within(c, a);
    if inside { dot(minus(point, a), normal).abs() / dot(normal, normal).sqrt() } else { f64::INFINITY }
}

fn pierces([p, q]: [Corner; 2], [a, b, c]: Triangle) -> bool {
    let volume = |x: Corner, y: Corner, z: Corner, w: Corner| dot(cross(minus(y, x), minus(z, x)), minus(w, x));
    let (above, below) = (volume(a, b, c, p), volume(a, b, c, q));
    let sides = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    above * below < 0.0 && (sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0))
}

/// Distance of two surfaces; 0 where they meet.
fn distance(one: &[Triangle], two: &[Triangle]) -> f64 {
    let ball = |triangle: &Triangle| {
        let [a, b, c] = *triangle;
        let centre = [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0);
        (centre, triangle.map(|corner| apart(corner, centre)).into_iter().fold(0.0, f64::max))
    };
    let (first, second): (Vec<_>, Vec<_>) = (one.iter().map(ball).collect(), two.iter().map(ball).collect());
    // The nearest first, so that most are never looked at.
    let mut pairs = Vec::with_capacity(one.len() * two.len());
    for (a, (ca, ra)) in one.iter().zip(&first) {
        for (b, (cb, rb)) in two.iter().zip(&second) {
            pairs.push((apart(*ca, *cb) - ra - rb, a, b));
        }
    }
    pairs.sort_unstable_by(|one, two| one.0.total_cmp(&two.0));
    let mut least = f64::INFINITY;
    for (bound, a, b) in pairs {
        if bound > least {
            break;
        }
        let edges = |[x, y, z]: Triangle| [[x, y], [y, z], [z, x]];
        for edge in edges(*a) {
            for other in edges(*b) {
                least = least.min(of_segments(edge, other));
            }
        }
        a.iter().for_each(|corner| least = least.min(from_face(*corner, *b)));
        b.iter().for_each(|corner| least = least.min(from_face(*corner, *a)));
        if edges(*a).iter().any(|edge| pierces(*edge, *b)) || edges(*b).iter().any(|edge| pierces(*edge, *a)) {
            return 0.0;
        }
    }
    least
}

fn moved(triangles: &[Triangle], place: &Isometry3<f64>) -> Vec<Triangle> {
    let moved = |corner: Corner| (place * Point3::from(corner)).coords.into();
    triangles.iter().map(|triangle| triangle.map(moved)).collect()
}

/// Largest distance of a turned body from its triangles, mm: few triangles.
const CHORD_MM: f64 = 1.0;

/// A body of a machine.
struct TestSolid {
    link: usize,
    mesh: Mesh,
    /// It is taken for a body of revolution about this line,
    axis: Option<CentreLine>,
    /// whose surface is no farther away than this, mm.
    chord_mm: f64,
}

impl TestSolid {
    fn new(link: usize, mesh: Mesh) -> Self {
        Self { link, mesh, axis: None, chord_mm: 0.0 }
    }

    /// Turned about a line.
    fn turned(link: usize, outline: &[[f64; 2]], line: &CentreLine) -> Self {
        let (vertices, faces) = turned(outline, CHORD_MM);
        let largest = outline.iter().map(|corner| corner[0]).fold(0.0, f64::max);
        let rotation = UnitQuaternion::rotation_between_axis(&Vector3::z_axis(), &line.direction).unwrap_or_default();
        let place = Isometry3::from_parts(line.point.into(), rotation);
        let axis = Some(CentreLine::z().placed(&place));
        let mesh = Mesh::new(vertices, faces).expect("a closed body").placed(&place);
        Self { link, mesh, axis, chord_mm: chord_of(largest, CHORD_MM) }
    }
}

/// Bodies of a machine: one for each link, about where they can meet. Some of those on rotary axes are turned about
/// their centre lines.
fn solids(random: &mut Random, machine: &dyn AnyMachine, links: &MachineLinks) -> Vec<TestSolid> {
    let mut all = Vec::new();
    for (joint, axis) in machine.axes().iter().enumerate() {
        let link = links.number(SolidLink::Axis(axis.letter)).expect("a link");
        if let Some(line) = links.centre_line(joint).filter(|_| random.unit() < 0.3) {
            let along = line.direction.into_inner() * random.within(30.0);
            // As centre lines are measured.
            let aside = random.direction() * 0.002;
            let line = CentreLine { point: line.point + along + aside, ..line };
            let [foot, head] = [0, 1].map(|_| 10.0 + 30.0 * random.unit());
            let height = 5.0 + 25.0 * random.unit();
            all.push(TestSolid::turned(link, &[[0.0, 0.0], [foot, 0.0], [head, height], [0.0, height]], &line));
            continue;
        }
        let centre = match axis.kind {
            AxisKind::Rotary => [random.within(20.0), random.within(20.0), random.within(20.0)],
            AxisKind::Linear => [random.within(90.0), random.within(90.0), 90.0 + random.within(40.0)],
        };
        let size = 25.0 + 15.0 * random.unit();
        all.push(TestSolid::new(link, lump(random, centre, size)));
    }
    let frame = links.number(SolidLink::Frame).expect("a link");
    all.push(TestSolid::new(frame, lump(random, [100.0, 0.0, -60.0], 50.0)));
    all
}

/// How a motion goes.
enum Kind<'m> {
    Even,
    /// The tip on a line, the rotary axes evenly.
    Tip(&'m dyn AnyMachine),
    /// The tip on a line, the tool axis evenly.
    GreatCircle(&'m dyn AnyMachine),
}

struct TestMotion<'m> {
    ends: [AxisValues; 2],
    kind: Kind<'m>,
}

fn mix(from: &AxisValues, to: &AxisValues, share: f64) -> AxisValues {
    std::array::from_fn(|index| from[index] + share * (to[index] - from[index]))
}

impl TestMotion<'_> {
    /// Angle of the tool axis over the whole motion.
    fn angle(&self, machine: &dyn AnyMachine) -> f64 {
        let [a, b] = self.ends.map(|axes| machine.forward_kinematics(&axes).axis);
        a.cross(&b).norm().atan2(a.dot(&b))
    }
}

impl AxesInMotion for TestMotion<'_> {
    fn at(&self, share: f64, near: &AxisValues) -> AxisValues {
        let [from, to] = &self.ends;
        let mixed = mix(from, to, share);
        match self.kind {
            Kind::Even => mixed,
            Kind::Tip(machine) => {
                let tips = [from, to].map(|axes| machine.forward_kinematics(axes).tip);
                machine.linear_axes(&(tips[0] + (tips[1] - tips[0]) * share), &mixed).expect("linear axes")
            }
            Kind::GreatCircle(machine) => {
                let poses = [from, to].map(|axes| machine.forward_kinematics(axes));
                let (a, b, angle) = (poses[0].axis.into_inner(), poses[1].axis.into_inner(), self.angle(machine));
                let axis = match angle < 1e-9 {
                    true => a,
                    false => (a * ((1.0 - share) * angle).sin() + b * (share * angle).sin()) / angle.sin(),
                };
                let tip = poses[0].tip + (poses[1].tip - poses[0].tip) * share;
                let rotary = |index: &usize| machine.axes()[*index].kind == AxisKind::Rotary;
                let unwound = |mut values: AxisValues, near: &AxisValues| {
                    for index in (0..machine.axes().len()).filter(rotary) {
                        let turns = ((near[index] - values[index]) / std::f64::consts::TAU).round();
                        values[index] += turns * std::f64::consts::TAU;
                    }
                    values
                };
                let nearest = |pose: &Pose, near: &AxisValues, branch: Option<Branch>| {
                    let away = |values: &AxisValues| -> f64 {
                        let all = (0..machine.axes().len()).filter(rotary);
                        all.map(|index| (values[index] - near[index]).abs()).sum()
                    };
                    let solutions = machine.inverse_kinematics(pose, near);
                    let all = solutions.iter().filter(|solution| branch.is_none_or(|branch| solution.branch == branch));
                    all.map(|solution| (unwound(solution.axes, near), solution.branch))
                        .min_by(|a, b| away(&a.0).total_cmp(&away(&b.0)))
                };
                // Past a pole the axes swing on the branch of the start; on the other one they would jump.
                let branch = nearest(&poses[0], from, None).map(|(_, branch)| branch);
                let pose = Pose { tip, axis: UnitVector3::new_normalize(axis) };
                nearest(&pose, near, branch).map_or(*near, |(axes, _)| axes)
            }
        }
    }

    fn ranges(&self, shares: [f64; 2], [from, to]: [&AxisValues; 2]) -> Option<AxisRanges> {
        match self.kind {
            Kind::Even => Some(AxisRanges::between(from, to)),
            Kind::Tip(machine) => AxisRanges::of_tip(machine, from, to, 0.0),
            Kind::GreatCircle(machine) => {
                AxisRanges::of_great_circle(machine, from, to, self.angle(machine) * (shares[1] - shares[0]))
            }
        }
    }
}

/// Smallest distance in a motion: many places, then thirds around the smallest ones.
fn sampled(motion: &TestMotion<'_>, distance: &dyn Fn(&AxisValues) -> f64) -> f64 {
    const PLACES: usize = 40;
    let mut near = motion.ends[0];
    let places: Vec<AxisValues> = (0..=PLACES)
        .map(|place| {
            near = motion.at(place as f64 / PLACES as f64, &near);
            near
        })
        .collect();
    let values: Vec<f64> = places.iter().map(distance).collect();
    let mut least = f64::INFINITY;
    for (place, value) in values.iter().enumerate() {
        least = least.min(*value);
        let lower = |other: Option<&f64>| other.is_none_or(|other| other >= value);
        let before = place.checked_sub(1).and_then(|before| values.get(before));
        if lower(before) && lower(values.get(place + 1)) && *value < 30.0 && *value > 0.0 {
            let share = |place: f64| (place / PLACES as f64).clamp(0.0, 1.0);
            let (mut low, mut high) = (share(place as f64 - 1.0), share(place as f64 + 1.0));
            for _ in 0..14 {
                let third = (high - low) / 3.0;
                let at = |share: f64| distance(&motion.at(share, &places[place]));
                if at(low + third) < at(high - third) { high -= third } else { low += third }
            }
            least = least.min(distance(&motion.at(f64::midpoint(low, high), &places[place])));
        }
    }
    least
}

struct Bodies {
    links: MachineLinks,
    meshes: Vec<(usize, Vec<Triangle>)>,
}

impl Bodies {
    fn of(links: MachineLinks, solids: &[TestSolid]) -> Self {
        Self { links, meshes: solids.iter().map(|solid| (solid.link, triangles(&solid.mesh))).collect() }
    }

    /// Distance of two bodies at a position.
    fn distance(&self, [one, two]: [usize; 2], values: &AxisValues) -> f64 {
        let (a, b) = (&self.meshes[one], &self.meshes[two]);
        distance(&a.1, &moved(&b.1, &self.links.between(a.0, b.0, values)))
    }

    /// Distance of two bodies at a position; far away a lower bound.
    fn near(&self, pair: [usize; 2], values: &AxisValues) -> f64 {
        let [a, b] = pair.map(|index| &self.meshes[index]);
        let place = self.links.between(a.0, b.0, values);
        let ball = |triangles: &[Triangle]| {
            let centre = triangles[0][0];
            let farthest = triangles.iter().flatten().map(|corner| apart(*corner, centre)).fold(0.0, f64::max);
            (Point3::from(centre), farthest)
        };
        let ((ca, ra), (cb, rb)) = (ball(&a.1), ball(&b.1));
        let between = (place * cb - ca).norm() - ra - rb;
        if between > 21.0 { between } else { self.distance(pair, values) }
    }
}

fn random_values(random: &mut Random, machine: &dyn AnyMachine, size: f64, around: &AxisValues) -> AxisValues {
    std::array::from_fn(|index| match machine.axes().get(index).map(|axis| axis.kind) {
        Some(AxisKind::Rotary) => around[index] + random.within(1.3 * size),
        Some(AxisKind::Linear) => around[index] + random.within(70.0 * size),
        None => 0.0,
    })
}

const BLOCK: MovingBlock =
    MovingBlock { line: 1, cl_line: 1, operation: 1, tool: 0, set_up: 1, offsets_mm: [0.0; 9], apart: false };

fn body(solid: &TestSolid) -> Body {
    let (shapes, ball) = Shapes::of(solid.mesh.clone()).expect("shapes");
    Body {
        name: String::new(),
        groups: Vec::new(),
        link: solid.link,
        set_ups: Vec::new(),
        ball,
        axis: solid.axis,
        tolerance_mm: solid.chord_mm,
        shapes,
    }
}

fn clearances(machine: &dyn AnyMachine, solids: &[TestSolid], clearance_mm: f64) -> Clearances {
    let bodies = solids.iter().map(|solid| (body(solid), None));
    Clearances::new(MachineLinks::of(machine, &SetUp::default()), bodies.collect(), None, &[], clearance_mm)
}

#[test]
fn no_collision_of_a_random_motion_is_missed_and_none_is_invented() {
    let (mut found, mut clear, mut close) = (0, 0, 0);
    for (number, machine) in machines().iter().enumerate() {
        let machine = &**machine;
        let mut random = Random(11 + number as u64);
        for round in 0..rounds() {
            let links = MachineLinks::of(machine, &SetUp::default());
            let solids = solids(&mut random, machine, &links);
            let bodies = Bodies::of(links, &solids);
            let clearance_mm = if round % 2 == 0 { 0.0 } else { 2.0 };
            let mut clearances = clearances(machine, &solids, clearance_mm);
            let from = random_values(&mut random, machine, 1.0, &[0.0; 9]);
            let long = [0.02, 0.2, 0.6][round % 3];
            let to = random_values(&mut random, machine, long, &from);
            let kind = match (round + number) % 4 {
                0 | 1 => Kind::Even,
                2 => Kind::Tip(machine),
                _ => Kind::GreatCircle(machine),
            };
            let mut motion = TestMotion { ends: [from, to], kind };
            if let Kind::GreatCircle(_) = motion.kind {
                // The end is the solution nearest to the start.
                motion.ends[1] = motion.at(1.0, &from);
            }
            // As the page and the simulation divide long rotations.
            let mut places: Vec<Share> = vec![(0.0, from)];
            for part in 1..=8 {
                let share = f64::from(part) / 8.0;
                let near = places[places.len() - 1].1;
                places.push((share, motion.at(share, &near)));
            }
            let meetings = clearances.motion(BLOCK, &motion, &places, &mut || None);
            let certain = clearances.not_certified == 0;
            for (index, pair) in clearances.pairs().iter().enumerate() {
                let about = format!("machine {number}, motion {round}, bodies {:?}", pair.bodies);
                // Turned bodies are compared at any angle about their axis.
                let off = |solid: &TestSolid| solid.axis.map_or(0.0, |_| solid.chord_mm + 0.01);
                let chords: f64 = pair.bodies.iter().map(|body| off(&solids[*body])).sum();
                let least = sampled(&motion, &|values| bodies.near(pair.bodies, values));
                let meeting = meetings.iter().find(|meeting| meeting.pair == index);
                if let Some(Meeting { least_mm, at, .. }) = meeting {
                    found += 1;
                    let there = bodies.distance(pair.bodies, &at.axes);
                    assert!(there <= clearance_mm + 0.03 + 2.0 * chords, "{about}: {there} {least_mm:?}");
                } else {
                    clear += 1;
                    assert!(!certain || least > clearance_mm, "{about}: {least} was missed");
                    match pair.smallest {
                        Some(smallest) => {
                            let distance = smallest.distance_mm;
                            close += usize::from(distance < 10.0);
                            let there = bodies.distance(pair.bodies, &smallest.at.axes);
                            assert!((distance - there).abs() < 1e-4 + chords, "{about}: {distance} {there}");
                            let wanted = least.min(super::clearance::SHOWN_MM);
                            assert!(
                                !certain || distance <= wanted * 1.12 + 0.12 + chords || least > 18.0,
                                "{about}: {distance} {least}"
                            );
                        }
                        None => assert!(!certain || least > super::clearance::SHOWN_MM, "{about}: {least}"),
                    }
                }
            }
        }
    }
    assert!(found > 3 && clear > 60 && close > 1, "{found} {clear} {close}");
}

#[test]
fn the_box_of_a_motion_whose_axes_arrive_in_any_order_is_compared_as_a_whole() {
    let (mut found, mut clear) = (0, 0);
    for (number, machine) in machines().iter().enumerate() {
        let machine = &**machine;
        let mut random = Random(71 + number as u64);
        for round in 0..rounds() {
            let links = MachineLinks::of(machine, &SetUp::default());
            let solids = solids(&mut random, machine, &links);
            let bodies = Bodies::of(links, &solids);
            let mut clearances = clearances(machine, &solids, 0.0);
            let from = random_values(&mut random, machine, 1.0, &[0.0; 9]);
            let to = random_values(&mut random, machine, 0.4, &from);
            let motion = TestMotion { ends: [from, to], kind: Kind::Even };
            let apart = MovingBlock { apart: true, ..BLOCK };
            let meetings = clearances.motion(apart, &motion, &[(0.0, from), (1.0, to)], &mut || None);
            if clearances.not_certified > 0 {
                continue;
            }
            for (index, pair) in clearances.pairs().iter().enumerate() {
                if meetings.iter().any(|meeting| meeting.pair == index) {
                    found += 1;
                    continue;
                }
                clear += 1;
                for _ in 0..20 {
                    let values = std::array::from_fn(|axis| from[axis] + random.unit() * (to[axis] - from[axis]));
                    let there = bodies.near(pair.bodies, &values);
                    assert!(there > 0.0, "machine {number}, motion {round}, bodies {:?}", pair.bodies);
                }
            }
        }
    }
    assert!(found > 3 && clear > 20, "{found} {clear}");
}

#[test]
fn bodies_move_against_each_other_by_no_more_than_their_reach() {
    let mut tightest: f64 = 0.0;
    for (number, machine) in machines().iter().enumerate() {
        let machine = &**machine;
        let links = MachineLinks::of(machine, &SetUp::default());
        let mut random = Random(31 + number as u64);
        for _ in 0..300 {
            let ends = [0, 1].map(|_| (random.unit() * (links.spindle() as f64 + 1.0)) as usize);
            let [from, to] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            let balls = [0, 1].map(|_| Ball {
                centre: Point3::from(random.direction() * 80.0 * random.unit()),
                radius: 30.0 * random.unit(),
            });
            let values = random_values(&mut random, machine, 1.0, &[0.0; 9]);
            let other = random_values(&mut random, machine, 0.3, &values);
            let levers = Levers::of(&links, [from, to], [&balls[0], &balls[1]], &values);
            let reach = levers.motion(&std::array::from_fn(|index| (other[index] - values[index]).abs()));
            // Points of both: their distance changes by no more.
            for _ in 0..20 {
                let [one, two] = [0, 1].map(|index| balls[index].centre + random.direction() * balls[index].radius);
                let apart = |values: &AxisValues| (links.between(from, to, values) * two - one).norm();
                let change = (apart(&values) - apart(&other)).abs();
                assert!(change <= reach + 1e-9, "{number}: {change} {reach}");
                tightest = tightest.max(if reach > 0.0 { change / reach } else { 0.0 });
            }
        }
    }
    assert!(tightest > 0.8, "{tightest}");
}

#[test]
fn a_body_of_revolution_is_at_rest_beyond_its_own_rotary_axis() {
    let [spinner, ..] = machines();
    let links = MachineLinks::of(&*spinner, &SetUp::default());
    // C B | X Y Z: the table, the cradle, the bed.
    let [table, cradle, bed] =
        [SolidLink::Axis('C'), SolidLink::Axis('B'), SolidLink::Frame].map(|link| links.number(link));
    let [table, cradle, bed] = [table, cradle, bed].map(|link| link.expect("a link"));
    let line = links.centre_line(table).expect("a rotary axis");
    let disc = [[0.0, -30.0], [120.0, -30.0], [120.0, 0.0], [0.0, 0.0]];
    let rests = |link: usize, line: CentreLine| {
        let (at_rest, added_mm) = body(&TestSolid::turned(link, &disc, &line)).rests(&links);
        (at_rest, (added_mm * 1e6).round() / 1e6)
    };
    assert_eq!(rests(table, line), ([table, cradle], 0.0));
    assert_eq!(rests(cradle, line), ([table, cradle], 0.0));
    assert_eq!(rests(bed, line), ([bed, bed], 0.0));
    // The sense of a line does not count; what it is off does.
    assert_eq!(rests(table, CentreLine { direction: -line.direction, ..line }).0, [table, cradle]);
    let aside = |mm: f64| CentreLine { point: line.point + Vector3::x() * mm, ..line };
    assert_eq!(rests(table, aside(0.003)), ([table, cradle], 0.006));
    assert_eq!(rests(table, aside(0.1)), ([table, table], 0.0));
    let inclined = |angle: f64| UnitVector3::new_normalize(Vector3::new(angle, 0.0, 1.0));
    assert_eq!(rests(table, CentreLine { direction: inclined(1e-3), ..line }).0, [table, table]);
    assert_eq!(rests(table, CentreLine { direction: inclined(1e-5), ..line }).0, [table, cradle]);
    assert_eq!(body(&TestSolid::new(table, lump(&mut Random(3), [0.0; 3], 20.0))).rests(&links).0, [table, table]);
}

#[test]
fn a_body_inside_another_one_collides() {
    let shell = {
        // A hollow box: its inner surface faces into the hollow.
        let (mut vertices, mut faces) = block([[-50.0; 3], [50.0; 3]]);
        let (inner, inner_faces) = block([[-40.0; 3], [40.0; 3]]);
        let first = vertices.len() as u32;
        vertices.extend(inner);
        faces.extend(inner_faces.iter().map(|[a, b, c]| [first + a, first + c, first + b]));
        Mesh::new(vertices, faces).expect("a closed body")
    };
    let [spinner, ..] = machines();
    let machine: &dyn AnyMachine = &*spinner;
    let links = MachineLinks::of(machine, &SetUp::default());
    let (table, spindle) = (links.number(SolidLink::Table), links.number(SolidLink::Spindle));
    let at = |x: f64| -> AxisValues { std::array::from_fn(|index| if index == 2 { x } else { 0.0 }) };
    let mut random = Random(5);
    for (x, collides) in [(0.0, false), (45.0, true), (200.0, false)] {
        let small = lump(&mut random, [0.0; 3], 4.0);
        let solids = [(table, shell.clone()), (spindle, small)];
        let solids = solids.map(|(link, mesh)| TestSolid::new(link.expect("a link"), mesh));
        let mut clearances = clearances(machine, &solids, 0.0);
        let motion = TestMotion { ends: [at(x), at(x + 0.1)], kind: Kind::Even };
        let found = clearances.motion(BLOCK, &motion, &[(0.0, at(x)), (1.0, at(x + 0.1))], &mut || None);
        assert_eq!(found.len(), usize::from(collides), "{x}: {found:?}");
    }
}

#[test]
fn turned_outlines_and_boxes_are_closed_bodies_of_their_volume() {
    let of = |(vertices, faces): (Vec<[f64; 3]>, Vec<[u32; 3]>)| Mesh::new(vertices, faces).expect("a closed body");
    let cone = of(turned(&[[0.0, 0.0], [6.0, 0.0], [0.0, 10.0]], 1e-4));
    assert!((cone.volume() - 120.0 * std::f64::consts::PI).abs() < 1e-3 * cone.volume());
    // A ring, clockwise.
    let ring = of(turned(&[[5.0, 0.0], [5.0, 4.0], [8.0, 4.0], [8.0, 0.0]], 1e-4));
    assert!((ring.volume() - 156.0 * std::f64::consts::PI).abs() < 1e-3 * ring.volume());
    assert!((of(block([[0.0; 3], [1.0, 2.0, 3.0]])).volume() - 6.0).abs() < 1e-12);
}
