//! Set-up of the part: rotates the CL data by `part_rotation` and lifts it for a dry run.
//!
//! Tips, tool axes and every other point and direction are multiplied by `part_rotation` here and nowhere else. The
//! result is in a part frame whose axes are parallel to those of the table. Positions in the configuration (`floor`,
//! `retract.clearance`) are in that frame, too; those of the CL data (CLEARP) are rotated with it. A dry run moves
//! every point outwards along its tool axis; the clearance geometry stays at the part.

use std::collections::BTreeMap;

use nalgebra::{Point3, Rotation3, UnitVector3};

use crate::kinematics::Pose;
use crate::program::{Arc, ClearancePlane, Event, Hole, Move, NewStart, ReferenceGeometry, Spline, ToolMotion};

use crate::motion::policy::Policy;

/// Rotates and lifts the events of a program.
#[derive(Debug, Clone)]
pub(crate) struct Setting {
    rotation: Rotation3<f64>,
    /// Rotation of the part in each set-up.
    rotations: BTreeMap<u32, Rotation3<f64>>,
    /// Lift of a dry run along the tool axis.
    lift_mm: f64,
    lifted: bool,
    /// Neither rotation nor lift.
    plain: bool,
    /// Control points of the curve at hand, rotated and lifted.
    points: Vec<Point3<f64>>,
}

impl Setting {
    pub(crate) fn new(policy: Policy<'_>) -> Self {
        let rotation = policy.set_up.part_rotation;
        let lift_mm = policy.options.lift_mm.unwrap_or(0.0);
        Self {
            rotation,
            rotations: policy.set_up.clampings().map(|(number, part)| (number, part.part_rotation)).collect(),
            lift_mm,
            lifted: policy.options.lift_mm.is_some(),
            plain: rotation == Rotation3::identity() && policy.options.lift_mm.is_none(),
            points: Vec::new(),
        }
    }

    /// Returns an event rotated and lifted; `None` if nothing changes.
    #[inline(always)]
    pub(crate) fn event<'s>(&'s mut self, event: &Event<'s>) -> Option<Event<'s>> {
        if let Event::NewStart(NewStart::SetUp(number)) = event {
            self.enter(*number);
        }
        if self.plain { None } else { Some(self.rotated(event)) }
    }

    /// Another set-up begins.
    #[cold]
    fn enter(&mut self, number: u32) {
        // The planner refuses a set-up that is not configured.
        self.rotation = self.rotations.get(&number).copied().unwrap_or(self.rotation);
        self.plain = self.rotation == Rotation3::identity() && !self.lifted;
    }

    #[inline(never)]
    fn rotated<'s>(&'s mut self, event: &Event<'s>) -> Event<'s> {
        match *event {
            Event::Motion(motion) => Event::Motion(match motion {
                ToolMotion::Move(motion) => ToolMotion::Move(Move { pose: self.pose(&motion.pose), ..motion }),
                ToolMotion::Arc(arc) => ToolMotion::Arc(Arc {
                    start: self.pose(&arc.start),
                    end: self.pose(&arc.end),
                    centre: self.tip(&arc.centre, &arc.start.axis),
                    normal: self.direction(&arc.normal),
                    ..arc
                }),
                ToolMotion::Spline(spline) => {
                    let mut points = std::mem::take(&mut self.points);
                    points.clear();
                    points.extend(spline.points.iter().map(|point| self.tip(point, &spline.axis)));
                    self.points = points;
                    ToolMotion::Spline(Spline { points: &self.points, axis: self.direction(&spline.axis), ..spline })
                }
                ToolMotion::Hole(hole) => ToolMotion::Hole(Hole { top: self.pose(&hole.top), ..hole }),
            }),
            Event::Reference(geometry) => Event::Reference(match geometry {
                ReferenceGeometry::From(pose) => ReferenceGeometry::From(self.pose(&pose)),
                ReferenceGeometry::ClearancePlane(plane) => {
                    ReferenceGeometry::ClearancePlane(ClearancePlane { normal: self.direction(&plane.normal), ..plane })
                }
            }),
            // These contain no point and no direction.
            Event::NewStart(_) | Event::Interruption(_) | Event::Function(_) | Event::Text(..) => *event,
        }
    }

    fn pose(&self, pose: &Pose) -> Pose {
        Pose { tip: self.tip(&pose.tip, &pose.axis), axis: self.direction(&pose.axis) }
    }

    fn tip(&self, tip: &Point3<f64>, axis: &UnitVector3<f64>) -> Point3<f64> {
        self.rotation * (tip + axis.into_inner() * self.lift_mm)
    }

    fn direction(&self, direction: &UnitVector3<f64>) -> UnitVector3<f64> {
        self.rotation * direction
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::config::Config;
    use crate::program::Drilling;

    fn pose(tip: [f64; 3], axis: [f64; 3]) -> Pose {
        Pose { tip: Point3::from(tip), axis: UnitVector3::new_normalize(Vector3::from(axis)) }
    }

    /// A rotation that takes X to Y, Y to Z and Z to X.
    fn setting() -> Setting {
        let rotation = Rotation3::from_matrix_unchecked(nalgebra::Matrix3::new(0., 0., 1., 1., 0., 0., 0., 1., 0.));
        let mut config = Config::default();
        config.set_up.part_rotation = rotation;
        Setting::new(config.policy())
    }

    #[test]
    fn every_point_and_direction_of_an_event_is_rotated() {
        let (here, there) = (pose([1., 2., 3.], [0., 0., 1.]), pose([3., 1., 2.], [1., 0., 0.]));
        let motion = |pose| Event::Motion(ToolMotion::Move(Move { pose, rapid: false, feed: None }));
        assert_eq!(setting().event(&motion(here)), Some(motion(there)));
        assert_eq!(
            setting().event(&Event::Reference(ReferenceGeometry::From(here))),
            Some(Event::Reference(ReferenceGeometry::From(there)))
        );
        let arc = |pose: Pose, centre: [f64; 3], normal| {
            let (centre, angle) = (Point3::from(centre), 1.0);
            Event::Motion(ToolMotion::Arc(Arc { start: pose, end: pose, centre, normal, angle_rad: angle, feed: None }))
        };
        let rotated = arc(there, [6., 4., 5.], Vector3::y_axis());
        assert_eq!(setting().event(&arc(here, [4., 5., 6.], Vector3::x_axis())), Some(rotated));
        let hole = |top| {
            let drilling = Drilling::Drill;
            let (depth, clearance, back_to) = (5.0, 1.0, 2.0);
            Event::Motion(ToolMotion::Hole(Hole {
                top,
                depth_mm: depth,
                clearance_mm: clearance,
                return_mm: back_to,
                drilling,
                feed: None,
                dwell: None,
            }))
        };
        assert_eq!(setting().event(&hole(here)), Some(hole(there)));
        let plane =
            |normal| Event::Reference(ReferenceGeometry::ClearancePlane(ClearancePlane { normal, distance_mm: 7.0 }));
        assert_eq!(setting().event(&plane(Vector3::z_axis())), Some(plane(Vector3::x_axis())));
        let (before, after) = ([here.tip], [there.tip]);
        let curve =
            |points, axis| Event::Motion(ToolMotion::Spline(Spline { knots: &[0.0], points, axis, feed: None }));
        assert_eq!(setting().event(&curve(&before, here.axis)), Some(curve(&after, there.axis)));
    }

    #[test]
    fn without_a_set_up_the_cl_data_stays_as_it_is() {
        let from = Event::Reference(ReferenceGeometry::From(pose([1., 2., 3.], [0., 0., 1.])));
        assert_eq!(Setting::new(Config::default().policy()).event(&from), None);
    }

    #[test]
    fn a_dry_run_moves_every_point_along_the_tool_axis() {
        let lifted = |event| {
            let mut config = Config::default();
            config.motion.lift_mm = Some(50.0);
            Setting::new(config.policy()).event(&event) == Some(event)
        };
        let axis = [0.6, 0.0, 0.8];
        let (here, there) = (pose([1., 2., 3.], axis), pose([31., 2., 43.], axis));
        let mut config = Config::default();
        config.motion.lift_mm = Some(50.0);
        let mut setting = Setting::new(config.policy());
        let motion = |pose| Event::Motion(ToolMotion::Move(Move { pose, rapid: true, feed: None }));
        assert_eq!(setting.event(&motion(here)), Some(motion(there)));
        let (before, after) = ([here.tip; 2], [there.tip; 2]);
        let curve =
            |points, axis| Event::Motion(ToolMotion::Spline(Spline { knots: &[0.0], points, axis, feed: None }));
        assert_eq!(setting.event(&curve(&before, here.axis)), Some(curve(&after, here.axis)));
        let arc = |pose: Pose, centre| {
            let normal = Vector3::z_axis();
            Event::Motion(ToolMotion::Arc(Arc { start: pose, end: pose, centre, normal, angle_rad: 1.0, feed: None }))
        };
        assert_eq!(setting.event(&arc(here, Point3::origin())), Some(arc(there, Point3::new(30., 0., 40.))));
        let plane = ClearancePlane { normal: Vector3::z_axis(), distance_mm: 7.0 };
        assert!(lifted(Event::Reference(ReferenceGeometry::ClearancePlane(plane))), "the geometry stays");
    }
}
