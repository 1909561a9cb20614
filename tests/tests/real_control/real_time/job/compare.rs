//! The way of the tool against the CL data.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

use approx::abs_diff_eq;
use nalgebra::{Point3, Vector3};
use pp_runtime::kinematics::{Pose, PoseTolerance};
use tests::block::{angle_to_arc, distance_to_line};
use tests::linuxcnc::simulation::{SERVO_PERIOD, SPINDLE_SCALE};
use tests::oracle::angle_between;

use super::super::kinematics::{AXIS, TIP, largest};
use super::cl::{Goal, Operation};
use super::run::{FEED_OVERRIDE, Line};

/// Tolerance of an arc, mm: its ends are rounded, and so are the words of its centre.
const ARC: f64 = 2.0 * TIP;

/// Distance from a corner where the control does not stop in which it is not compared, mm: it is rounded, and the chord
/// between two servo cycles cuts it.
const CORNER: f64 = 2.0 * MILLING * FEED_OVERRIDE as f64 / 100.0 * CYCLE;

/// Motion of a joint that is none, mm and degrees.
const STILL: f64 = 1e-6;

/// Servo cycles in which a spindle reverses and the tool follows it.
const REVERSAL: f64 = 4.0;

/// Feeds of the CL data, mm/min: of the drill, of the tap, and of the end mill in the faces.
const DRILLING: f64 = 200.0;
const TAPPING: f64 = 500.0;
const MILLING: f64 = 800.0;

/// Tolerance of a tool axis between two points, rad: the largest angle from the great circle that the program states.
const SWING: f64 = 0.1 / 57.295 + AXIS;

/// Radius by which the tool is offset from a compensated path, mm: that of tool 3.
const RADIUS: f64 = 5.0;

/// Points of a compensated line or arc that are compared.
const PROBES: u32 = 200;

/// Servo cycle, minutes.
const CYCLE: f64 = SERVO_PERIOD / 60.0;

/// What has been compared.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Compared {
    /// Points that the tool has reached.
    pub(super) points: usize,
    /// Straight feed motions between two points, in every servo cycle.
    pub(super) lines: usize,
    pub(super) arcs: usize,
    /// Lines and arcs with cutter compensation.
    pub(super) compensated: usize,
    pub(super) holes: usize,
    pub(super) threads: usize,
    /// Changes of the kinematics.
    pub(super) switches: usize,
}

/// Compares a program with the CL data of its operations; returns what was compared and what is wrong.
pub(super) fn compare(lines: &[Line], operations: &[Operation]) -> (Compared, Vec<String>) {
    let mut comparison = Comparison::default();
    comparison.switches(lines);
    for operation in operations {
        let of_it: Vec<&Line> = lines.iter().filter(|line| line.operation == operation.name).collect();
        comparison.operation(operation, &of_it);
    }
    (comparison.compared, comparison.faults)
}

#[derive(Default)]
struct Comparison {
    compared: Compared,
    faults: Vec<String>,
}

impl Comparison {
    /// Nothing moves while the kinematics changes.
    fn switches(&mut self, lines: &[Line]) {
        for line in lines.iter().filter(|line| line.text == "M428" || line.text == "M429") {
            self.compared.switches += 1;
            self.expect(line.moved <= STILL, || format!("line {}: {} at the switch", line.number, line.moved));
        }
    }

    fn expect(&mut self, holds: bool, message: impl FnOnce() -> String) {
        if !holds {
            self.faults.push(message());
        }
    }

    fn operation(&mut self, operation: &Operation, lines: &[&Line]) {
        // Index of the line that has reached the goal before.
        let mut at: Option<usize> = None;
        let mut goals = operation.goals.iter().enumerate().peekable();
        while let Some((index, goal)) = goals.next() {
            let from = at.map_or(0, |line| line + 1);
            match goal {
                Goal::Hole { .. } => at = self.hole(operation, goal, lines, from).or(at),
                Goal::Feed { compensated: true, .. } => {
                    while goals.next_if(|(_, goal)| goal.is_compensated()).is_some() {}
                    let end = goals.peek().map_or(operation.goals.len(), |(index, _)| *index);
                    self.compensated(operation, index..end, lines, from);
                }
                Goal::Rapid(_) | Goal::Feed { .. } => {
                    let after_compensation = index > 0 && operation.goals[index - 1].is_compensated();
                    let before = if after_compensation { &[] } else { &operation.goals[..index] };
                    at = self.point(operation, goal, before, lines, at).or(at);
                }
            }
        }
    }

    /// The tool reaches a point, at feed on the way that the CL data has from the points `before` it.
    fn point(
        &mut self,
        operation: &Operation,
        goal: &Goal,
        before: &[Goal],
        lines: &[&Line],
        at: Option<usize>,
    ) -> Option<usize> {
        let from = at.map_or(0, |line| line + 1);
        let pose = goal.pose();
        let Some(found) = (from..lines.len()).find(|&index| is_at(&lines[index].end, pose)) else {
            self.faults.push(format!("{}: the tool does not come to {pose:?}", operation.name));
            return None;
        };
        self.compared.points += 1;
        let (Goal::Feed { centre, .. }, [earlier @ .., last], Some(at)) = (goal, before, at) else {
            return Some(found);
        };
        let before = last.pose();
        let directly = lines[at + 1..found].iter().all(|line| line.moved <= STILL);
        if directly && lines[found].motion != "G0" {
            let way = &lines[found].way;
            let (off, tolerance) = match centre {
                None => (largest(way.iter().map(|at| distance_to_line(&at.tip, &before.tip, &pose.tip))), TIP),
                Some(centre) => {
                    let heading = earlier.last().map_or_else(Vector3::zeros, |point| direction(point.pose(), before));
                    let element = Element::new(before, pose, Some(*centre), heading);
                    (largest(way.iter().map(|at| element.distance(&at.tip, centre))), ARC)
                }
            };
            let swing = largest(way.iter().map(|at| angle_to_arc(&at.axis, &before.axis, &pose.axis)));
            let count = if centre.is_some() { &mut self.compared.arcs } else { &mut self.compared.lines };
            *count += 1;
            let name = format!("{}, line {}", operation.name, lines[found].number);
            self.expect(off <= tolerance, || format!("{name}: the tip is off its way by {off}"));
            self.expect(swing <= SWING, || format!("{name}: the tool axis is off its way by {swing}"));
        }
        Some(found)
    }

    /// The tool goes down to the bottom of a hole along its axis; returns the line that makes the hole.
    fn hole(&mut self, operation: &Operation, goal: &Goal, lines: &[&Line], from: usize) -> Option<usize> {
        let &Goal::Hole { mouth, clear, bottom, thread } = goal else { return None };
        let height = |pose: &Pose| (pose.tip - mouth.tip).dot(&mouth.axis);
        let made = (from..lines.len()).find(|&index| lines[index].way.iter().any(|at| height(at) < clear - TIP));
        let Some(made) = made else {
            self.faults.push(format!("{}: no hole at {mouth:?}", operation.name));
            return None;
        };
        let line = lines[made];
        let name = format!("{}, line {}, hole at {}", operation.name, line.number, mouth.tip);
        let inside = || line.way.iter().filter(|at| height(at) < clear - TIP);
        let off = largest(inside().map(|at| (at.tip - mouth.tip - mouth.axis.into_inner() * height(at)).norm()));
        let inclined = largest(inside().map(|at| angle_between(&at.axis, &mouth.axis)));
        let lowest = inside().map(height).fold(f64::INFINITY, f64::min);
        // The tool turns between two servo cycles; with the spindle it reverses in some.
        let in_a_cycle = f64::from(FEED_OVERRIDE) / 100.0 * DRILLING * CYCLE;
        let (above, below) = if thread { (0.0, REVERSAL * TAPPING * SPINDLE_SCALE * CYCLE) } else { (in_a_cycle, 0.0) };
        self.expect(off <= TIP, || format!("{name}: {off} off its axis"));
        self.expect(inclined <= AXIS, || format!("{name}: inclined by {inclined}"));
        self.expect(lowest <= bottom + above + TIP && lowest >= bottom - below - TIP, || {
            format!("{name}: bottom at {lowest}, not {bottom}")
        });
        self.expect((line.motion == "G33.1") == thread, || format!("{name}: {}", line.motion));
        self.compared.holes += 1;
        self.compared.threads += usize::from(thread);
        Some(made)
    }

    /// The tool moves a radius to the left of its path on lines and half circles; the motions in and out are not
    /// compared.
    fn compensated(&mut self, operation: &Operation, goals: Range<usize>, lines: &[&Line], from: usize) {
        let Some(line) = lines[from..].iter().find(|line| line.text.starts_with("G40")) else {
            self.faults.push(format!("{}: no end of the compensation", operation.name));
            return;
        };
        let way: Vec<Point3<f64>> = line.way.iter().map(|pose| pose.tip).collect();
        let mut heading = direction(operation.goals[goals.start - 1].pose(), operation.goals[goals.start].pose());
        let mut turn = Some(heading);
        for index in goals.start + 1..goals.end {
            let (before, goal) = (operation.goals[index - 1].pose(), operation.goals[index]);
            let Goal::Feed { to, centre, .. } = goal else { continue };
            let element = Element::new(before, &to, centre, heading);
            heading = element.heading(1.0);
            // In an inside corner the tool begins where the two offset lines meet.
            let angle = turn.take().map_or(0.0, |into| angle_between(&into, &element.heading(0.0)));
            let corner = CORNER / element.length();
            let first = if angle > 0.0 { RADIUS * (angle / 2.0).tan() / element.length() + corner } else { 0.0 };
            let last = if index + 1 == goals.end { 1.0 - corner } else { 1.0 };
            let points = (0..=PROBES).map(|probe| {
                let share = first + (last - first) * f64::from(probe) / f64::from(PROBES);
                element.point(share) + before.axis.cross(&element.heading(share)) * RADIUS
            });
            let off = largest(points.map(|point| {
                way.windows(2).map(|two| distance_to_line(&point, &two[0], &two[1])).fold(f64::INFINITY, f64::min)
            }));
            self.compared.compensated += 1;
            let name = format!("{}, line {}", operation.name, line.number);
            self.expect(off <= ARC, || format!("{name}: {off} off the compensated path"));
            let inclined = largest(line.way.iter().map(|pose| angle_between(&pose.axis, &before.axis)));
            self.expect(inclined <= AXIS, || format!("{name}: inclined by {inclined}"));
        }
    }
}

/// Whether a pose is at a point of the CL data.
fn is_at(pose: &Pose, point: &Pose) -> bool {
    abs_diff_eq!(*pose, *point, epsilon = PoseTolerance { tip_mm: TIP, axis_rad: AXIS })
}

fn direction(from: &Pose, to: &Pose) -> Vector3<f64> {
    (to.tip - from.tip).normalize()
}

/// A line, or half a circle that it continues, as the CL data has it.
struct Element {
    from: Point3<f64>,
    to: Point3<f64>,
    /// Of half a circle.
    centre: Option<Point3<f64>>,
    /// Direction at the start.
    start: Vector3<f64>,
}

impl Element {
    /// `heading`: direction at the end of the element before, with which half a circle begins.
    fn new(from: &Pose, to: &Pose, centre: Option<Point3<f64>>, heading: Vector3<f64>) -> Self {
        let start = if centre.is_some() { heading } else { direction(from, to) };
        Self { from: from.tip, to: to.tip, centre, start }
    }

    fn length(&self) -> f64 {
        let straight = (self.to - self.from).norm();
        if self.centre.is_some() { straight * FRAC_PI_2 } else { straight }
    }

    fn point(&self, share: f64) -> Point3<f64> {
        match self.centre {
            None => self.from + (self.to - self.from) * share,
            Some(centre) => {
                let (radius, (sine, cosine)) = (self.from - centre, (PI * share).sin_cos());
                centre + radius * cosine + self.start * (radius.norm() * sine)
            }
        }
    }

    fn heading(&self, share: f64) -> Vector3<f64> {
        let Some(centre) = self.centre else { return self.start };
        let (outwards, (sine, cosine)) = ((self.from - centre).normalize(), (PI * share).sin_cos());
        self.start * cosine - outwards * sine
    }

    /// Distance of a point from half a circle.
    fn distance(&self, point: &Point3<f64>, centre: &Point3<f64>) -> f64 {
        let ends = (point - self.from).norm().min((point - self.to).norm());
        let outwards = self.from - centre;
        let (first, second) = (outwards.normalize(), self.start);
        let (x, y) = ((point - centre).dot(&first), (point - centre).dot(&second));
        let on_circle = centre + (first * x + second * y) * (outwards.norm() / x.hypot(y));
        if y < 0.0 { ends } else { (point - on_circle).norm() }
    }
}

#[test]
fn an_axis_that_moves_at_a_switch_is_found() {
    let end = Pose { tip: Point3::origin(), axis: Vector3::z_axis() };
    let line = |moved| Line {
        number: 7,
        text: "M428".to_owned(),
        motion: "G0".to_owned(),
        way: Vec::new(),
        end,
        moved,
        operation: "BLADE".to_owned(),
    };
    assert_eq!(compare(&[line(0.0)], &[]).1, Vec::<String>::new());
    assert_eq!(compare(&[line(0.0), line(0.01)], &[]).1, ["line 7: 0.01 at the switch"]);
}
