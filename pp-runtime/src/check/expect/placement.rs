//! The part on the table: points and directions of the CL data in the frame of the part as it is mounted.
//!
//! `p' = R·(p + lift·t)`, `n' = R·n`: `R` the rotation of the part, `t` the tool axis, `lift` that of a dry run. The
//! clearance geometry is rotated, not lifted.

use nalgebra::{Matrix3, Point3, UnitVector3};

use crate::kinematics::Pose;
use crate::program::{Arc, ClearancePlane, Event, Hole, Move, NewStart, ReferenceGeometry, Spline, ToolMotion};

/// Rotation and lift of the CL data.
#[derive(Debug)]
pub(super) struct Placement {
    /// `None`: the CL data stays as it is.
    rotation: Option<Matrix3<f64>>,
    /// Rotation of the part in each set-up.
    set_ups: Vec<(u32, Matrix3<f64>)>,
    lift_mm: f64,
    lifted: bool,
    /// Control points of the curve at hand.
    points: Vec<Point3<f64>>,
}

impl Placement {
    /// The part in its set-ups, the first one first.
    pub(super) fn new(set_ups: Vec<(u32, Matrix3<f64>)>, lift_mm: Option<f64>) -> Self {
        let rotation = set_ups.first().map_or(Matrix3::identity(), |(_, rotation)| *rotation);
        let moves = rotation != Matrix3::identity() || lift_mm.is_some();
        Self {
            rotation: moves.then_some(rotation),
            set_ups,
            lift_mm: lift_mm.unwrap_or(0.0),
            lifted: lift_mm.is_some(),
            points: Vec::new(),
        }
    }

    /// The event in the frame of the part as it is mounted; `None` if nothing changes.
    pub(super) fn of<'s>(&'s mut self, event: &Event<'s>) -> Option<Event<'s>> {
        if let Event::NewStart(NewStart::SetUp(number)) = event
            && let Some((_, rotation)) = self.set_ups.iter().find(|(set_up, _)| set_up == number)
        {
            let moves = *rotation != Matrix3::identity() || self.lifted;
            self.rotation = moves.then_some(*rotation);
        }
        let place = RotationAndLift { rotation: self.rotation?, lift_mm: self.lift_mm };
        Some(match event {
            Event::Motion(motion) => Event::Motion(match motion {
                ToolMotion::Move(motion) => ToolMotion::Move(Move { pose: place.pose(&motion.pose), ..*motion }),
                ToolMotion::Arc(arc) => ToolMotion::Arc(Arc {
                    start: place.pose(&arc.start),
                    end: place.pose(&arc.end),
                    centre: place.point(&arc.centre, &arc.start.axis),
                    normal: place.direction(&arc.normal),
                    ..*arc
                }),
                ToolMotion::Spline(curve) => {
                    self.points.clear();
                    self.points.extend(curve.points.iter().map(|point| place.point(point, &curve.axis)));
                    ToolMotion::Spline(Spline { points: &self.points, axis: place.direction(&curve.axis), ..*curve })
                }
                ToolMotion::Hole(hole) => ToolMotion::Hole(Hole { top: place.pose(&hole.top), ..*hole }),
            }),
            Event::Reference(geometry) => Event::Reference(match geometry {
                ReferenceGeometry::From(pose) => ReferenceGeometry::From(place.pose(pose)),
                ReferenceGeometry::ClearancePlane(plane) => ReferenceGeometry::ClearancePlane(ClearancePlane {
                    normal: place.direction(&plane.normal),
                    ..*plane
                }),
            }),
            Event::NewStart(_) | Event::Interruption(_) | Event::Function(_) | Event::Text(..) => return None,
        })
    }
}

/// One rotation and lift.
#[derive(Clone, Copy)]
struct RotationAndLift {
    rotation: Matrix3<f64>,
    lift_mm: f64,
}

impl RotationAndLift {
    fn direction(&self, direction: &UnitVector3<f64>) -> UnitVector3<f64> {
        UnitVector3::new_unchecked(self.rotation * direction.into_inner())
    }

    fn point(&self, point: &Point3<f64>, axis: &UnitVector3<f64>) -> Point3<f64> {
        Point3::from(self.rotation * (point.coords + axis.into_inner() * self.lift_mm))
    }

    fn pose(&self, pose: &Pose) -> Pose {
        Pose { tip: self.point(&pose.tip, &pose.axis), axis: self.direction(&pose.axis) }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    #[test]
    fn a_point_is_lifted_along_its_axis_and_then_rotated_with_the_part() {
        // X to Y, Y to -X.
        let quarter = Matrix3::new(0., -1., 0., 1., 0., 0., 0., 0., 1.);
        let mut placement = Placement::new(vec![(1, quarter)], Some(10.0));
        let pose = Pose { tip: Point3::new(1.0, 2.0, 3.0), axis: Vector3::x_axis() };
        let placed = Pose { tip: Point3::new(-2.0, 11.0, 3.0), axis: Vector3::y_axis() };
        assert_eq!(
            placement.of(&Event::Reference(ReferenceGeometry::From(pose))),
            Some(Event::Reference(ReferenceGeometry::From(placed)))
        );
        let plane =
            |normal| Event::Reference(ReferenceGeometry::ClearancePlane(ClearancePlane { normal, distance_mm: 7.0 }));
        assert_eq!(placement.of(&plane(Vector3::x_axis())), Some(plane(Vector3::y_axis())));
        assert_eq!(placement.of(&Event::NewStart(NewStart::Home)), None);
    }

    #[test]
    fn without_rotation_and_lift_the_cl_data_stays_as_it_is() {
        let pose = Pose { tip: Point3::new(1.0, 2.0, 3.0), axis: Vector3::x_axis() };
        assert_eq!(Placement::new(Vec::new(), None).of(&Event::Reference(ReferenceGeometry::From(pose))), None);
    }
}
