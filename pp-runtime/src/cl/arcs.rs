//! Circles: the arc from one point to the next, and a vote on the sense in which they are traversed.
//!
//! CAM systems disagree on the sign of a CIRCLE's axis, and the count of its numbers says which habit a file has. That
//! reading is checked against the feed lines in front of and behind each arc: a line that runs on tangentially decides.
//! A majority against the form's sense is an error, a single contradiction may be a genuine cusp.

use std::f64::consts::TAU;

use super::fault::{Fault, Span};
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Arc, Feed, Location};

/// How far an end may be off the radius or the plane of its circle, mm; real files stay below a tenth of it.
pub(super) const ARC_TOLERANCE_MM: f64 = 0.005;

/// Points closer than this are one point, mm.
const SAME_POINT_MM: f64 = 1e-6;

/// A chord this short may be rounding, mm: whether an arc over it is nothing or a whole turn cannot be told.
const SHORTEST_CHORD_MM: f64 = 5e-4;

/// A line is tangential within this angle; its cosine.
const TANGENTIAL: f64 = 0.999_847_695_156_391_3;

/// Shorter lines say nothing about a direction, mm.
const SHORTEST_LINE_MM: f64 = 0.01;

/// Groups of arcs that vote separately; more frames than that share the last group.
const MOST_GROUPS: usize = 64;

/// Sense of a circle about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sense {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    CounterClockwise,
}

/// A circle in the workpiece frame that waits for its end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pending {
    pub(super) centre: Point3<f64>,
    /// As in the file: about which the sense counts.
    pub(super) axis: UnitVector3<f64>,
    pub(super) sense: Sense,
    pub(super) radius: Option<f64>,
    pub(super) times: u32,
    /// Angle that the arc must have, rad.
    pub(super) angle: Option<f64>,
    pub(super) line: u64,
}

/// The arc of a circle from `start` to `end`.
pub(super) fn arc(circle: &Pending, start: &Pose, end: &Pose, feed: Option<Feed>, at: Span) -> Result<Arc, Fault> {
    let fault = |text: String| {
        let text = format!("{text} (circle of line {})", circle.line);
        Fault::new("circle", at, text, "check the arc in the CAM system, or have it write lines instead of arcs")
    };
    if (start.axis.into_inner() - end.axis.into_inner()).norm() > 1e-6 {
        return Err(fault("the tool axis changes on an arc".into()));
    }
    let normal = match circle.sense {
        Sense::CounterClockwise => circle.axis,
        Sense::Clockwise => -circle.axis,
    };
    let n = normal.into_inner();
    let flat = |point: Point3<f64>| {
        let from_centre = point - circle.centre;
        from_centre - n * from_centre.dot(&n)
    };
    let (u, v) = (flat(start.tip), flat(end.tip));
    let (first, last) = (u.norm(), v.norm());
    let off_plane = (end.tip - circle.centre).dot(&n).abs();
    if off_plane > ARC_TOLERANCE_MM {
        return Err(fault(format!("the end of an arc is {off_plane:.4} mm off the plane of its circle")));
    }
    let radius = circle.radius.unwrap_or(first);
    for (which, found) in [("start", first), ("end", last)] {
        let off = (found - radius).abs();
        if off > ARC_TOLERANCE_MM {
            return Err(fault(format!("the {which} of an arc is {off:.4} mm off its radius of {radius:.4} mm")));
        }
    }
    if first.min(last) <= ARC_TOLERANCE_MM {
        return Err(fault(format!("an arc has no radius: it begins {first:.4} mm from its centre")));
    }
    let chord = (v - u).norm();
    let swept = n.dot(&u.cross(&v)).atan2(u.dot(&v)).rem_euclid(TAU);
    // Straight along the axis leads no arc: a helix that ends over its start has gone round.
    let rise = (end.tip - start.tip).dot(&n).abs();
    let part = if chord <= SAME_POINT_MM || (chord < SHORTEST_CHORD_MM && rise > ARC_TOLERANCE_MM) {
        TAU
    } else if chord < SHORTEST_CHORD_MM && circle.angle.is_none() {
        return Err(fault(format!("the ends of an arc are {chord:.5} mm apart: it may be nothing or a whole turn")));
    } else {
        swept
    };
    if let Some(angle) = circle.angle {
        let turns = ((angle - part) / TAU).round().max(0.0);
        let whole = part + turns * TAU;
        if (whole - angle).abs() * radius > ARC_TOLERANCE_MM {
            return Err(fault(format!(
                "the end of an arc lies at {:.4} degrees, not at the {:.4} of its record",
                whole.to_degrees(),
                angle.to_degrees()
            )));
        }
        return Ok(Arc { start: *start, end: *end, centre: circle.centre, normal, angle: whole, feed });
    }
    let angle = part + f64::from(circle.times - 1) * TAU;
    Ok(Arc { start: *start, end: *end, centre: circle.centre, normal, angle, feed })
}

/// Whether the tip passes over a point on its way along the arc; along the normal is not looked at.
pub(super) fn is_on(arc: &Arc, point: Point3<f64>) -> bool {
    let n = arc.normal.into_inner();
    let flat = |point: Point3<f64>| {
        let from_centre = point - arc.centre;
        from_centre - n * from_centre.dot(&n)
    };
    let (u, p) = (flat(arc.start.tip), flat(point));
    let radius = u.norm();
    let angle = n.dot(&u.cross(&p)).atan2(u.dot(&p)).rem_euclid(TAU);
    // Points at the ends may lie in front of the one and behind the other by rounding.
    let rounding = ARC_TOLERANCE_MM / radius;
    (p.norm() - radius).abs() <= ARC_TOLERANCE_MM && (angle <= arc.angle + rounding || angle >= TAU - rounding)
}

/// Direction of an arc at its start and at its end.
fn tangents(arc: &Arc) -> [Vector3<f64>; 2] {
    let n = arc.normal.into_inner();
    [arc.start.tip, arc.end.tip].map(|point| n.cross(&(point - arc.centre)).normalize())
}

/// Whether a line runs along a tangent (`Some(true)`), against it, or neither.
fn vote(line: Vector3<f64>, tangent: Vector3<f64>, normal: &UnitVector3<f64>) -> Option<bool> {
    let flat = line - normal.into_inner() * line.dot(normal);
    let length = flat.norm();
    if length < SHORTEST_LINE_MM {
        return None;
    }
    let cosine = flat.dot(&tangent) / length;
    (cosine.abs() >= TANGENTIAL).then_some(cosine > 0.0)
}

/// Arcs of one frame about one direction.
#[derive(Debug, Clone, Copy)]
struct Group {
    frame: u32,
    upward: bool,
    agree: u64,
    against: u64,
    first_against: Location,
}

/// What the arcs of a file say about their sense.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ArcVote {
    /// Arcs read.
    pub arcs: u64,
    /// Arcs of which a neighbouring line confirms the sense.
    pub agree: u64,
    /// Arcs of which a neighbouring line contradicts it.
    pub against: u64,
    /// The sense was given, whatever the form.
    pub given: bool,
}

/// An arc whose line behind it is not known yet.
#[derive(Debug, Clone, Copy)]
struct Undecided {
    group: usize,
    before: Option<bool>,
    tangent: Vector3<f64>,
    normal: UnitVector3<f64>,
    location: Location,
}

/// Collects the votes.
#[derive(Debug, Default)]
pub(super) struct Votes {
    groups: Vec<Group>,
    undecided: Option<Undecided>,
    arcs: u64,
}

impl Votes {
    /// An arc; `line`: the feed line that led to it.
    pub(super) fn arc(
        &mut self,
        arc: &Arc,
        axis: &UnitVector3<f64>,
        line: Option<Vector3<f64>>,
        frame: u32,
        at: Location,
    ) {
        self.settle(None);
        self.arcs += 1;
        let largest =
            axis.iter().copied().fold(0.0_f64, |most, value| if value.abs() > most.abs() { value } else { most });
        let upward = largest > 0.0;
        let known = self.groups.iter().position(|group| group.frame == frame && group.upward == upward);
        let group = known.unwrap_or_else(|| {
            if self.groups.len() < MOST_GROUPS {
                self.groups.push(Group { frame, upward, agree: 0, against: 0, first_against: Location::default() });
            }
            self.groups.len() - 1
        });
        let [first, last] = tangents(arc);
        self.undecided = Some(Undecided {
            group,
            before: line.and_then(|line| vote(line, first, &arc.normal)),
            tangent: last,
            normal: arc.normal,
            location: at,
        });
    }

    pub(super) fn waits(&self) -> bool {
        self.undecided.is_some()
    }

    /// What follows the last arc: a feed line, or something else.
    pub(super) fn settle(&mut self, line: Option<Vector3<f64>>) {
        let Some(arc) = self.undecided.take() else { return };
        let behind = line.and_then(|line| vote(line, arc.tangent, &arc.normal));
        let group = &mut self.groups[arc.group];
        match (arc.before, behind) {
            (Some(true), None | Some(true)) | (None, Some(true)) => group.agree += 1,
            (Some(false), None | Some(false)) | (None, Some(false)) => {
                if group.against == 0 {
                    group.first_against = arc.location;
                }
                group.against += 1;
            }
            // A line that comes in along the arc and one that goes out against it: a cusp.
            (None, None) | (Some(true), Some(false)) | (Some(false), Some(true)) => {}
        }
    }

    pub(super) fn count(&self, given: bool) -> ArcVote {
        let sum = |of: fn(&Group) -> u64| self.groups.iter().map(of).sum();
        ArcVote { arcs: self.arcs, agree: sum(|group| group.agree), against: sum(|group| group.against), given }
    }

    /// Groups with contradictions: where the first is, how many arcs contradict, of how many decided ones.
    pub(super) fn contradictions(&self) -> impl Iterator<Item = (Location, u64, u64)> + '_ {
        let some = self.groups.iter().filter(|group| group.against > 0);
        some.map(|group| (group.first_against, group.against, group.agree + group.against))
    }
}
