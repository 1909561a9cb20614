//! Motion: points, arcs, curves and holes, from records to events.

use super::arcs::{self, ARC_TOLERANCE_MM, Sense};
use super::fault::{Fault, Span};
use super::holes::{self, Back, Context, Definition};
use super::interpret::{Interpreter, Pending};
use super::record::{Circle, CircleForm, Cycle, CycleState, Numbers, Point, Record, TangentArc};
use super::vector::near;
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Arc, Event, Hole, Location, Move};

/// Sine of the angle by which INDIRV may be off the tangent of its circle.
const TANGENT: f64 = 1e-2;

impl Interpreter {
    /// GOTO.
    #[inline]
    pub(super) fn go_to(&mut self, point: &Point, here: Location) -> Result<(), Fault> {
        if self.plain {
            let motion = self.straight(point, here)?;
            self.emit(here, Event::Move(motion));
            return Ok(());
        }
        let (pose, normalised) = self.pose(point)?;
        self.count_normalised(normalised, here);
        self.move_to(pose, point.at, here)
    }

    /// GOTO while nothing is open.
    #[inline]
    pub(super) fn straight(&mut self, point: &Point, here: Location) -> Result<Move, Fault> {
        let (pose, normalised) = self.pose(point)?;
        self.count_normalised(normalised, here);
        self.motions += 1;
        let rapid = std::mem::take(&mut self.rapid);
        self.line_from = if rapid { None } else { self.here.map(|pose| pose.tip) };
        self.here = Some(pose);
        Ok(Move { pose, rapid, feed: self.feed })
    }

    /// A motion to a pose in the workpiece frame, whatever is open.
    #[cold]
    fn move_to(&mut self, pose: Pose, at: Span, here: Location) -> Result<(), Fault> {
        near(pose.tip, at)?;
        self.compare_cutter(at);
        if let Some(circle) = self.circle.take() {
            let done = self.end_circle(&circle, pose, at, here);
            // What follows an arc that is refused counts from its end all the same.
            self.here = Some(pose);
            self.note_state();
            return done;
        }
        if self.cycle.active {
            return self.hole(pose, at, here);
        }
        self.motions += 1;
        self.cycle.above_hole = false;
        let rapid = std::mem::take(&mut self.rapid);
        let line = self.here.filter(|_| !rapid).map(|before| pose.tip - before.tip);
        self.votes.settle(line);
        self.line_from = if rapid { None } else { self.here.map(|pose| pose.tip) };
        self.here = Some(pose);
        let pose = self.tip(pose, at)?;
        self.emit(here, Event::Move(Move { pose, rapid, feed: self.feed }));
        self.note_state();
        Ok(())
    }

    /// A list of points; behind a CIRCLE its last one is the end of the arc.
    pub(super) fn go_along(&mut self, points: &Numbers<'_>, here: Location) -> Result<(), Fault> {
        let Some(circle) = self.circle else {
            return points.points().try_for_each(|point| self.go_to(&point, here));
        };
        let Some(end) = points.points().last() else { return Ok(()) };
        let passed = self.pass(&circle, points, &end);
        self.go_to(&end, here).and(passed)
    }

    /// The points of a list behind a CIRCLE lie on its arc, the last one at its end.
    fn pass(&mut self, circle: &arcs::Pending, points: &Numbers<'_>, end: &Point) -> Result<(), Fault> {
        let start = self.standing("CIRCLE", points.at)?;
        let (end, _) = self.pose(end)?;
        let arc = arcs::arc(circle, &start, &end, self.feed, points.at)?;
        for point in points.points() {
            let (pose, _) = self.pose(&point)?;
            if !arcs::is_on(&arc, pose.tip) {
                return Err(Fault::new(
                    "circle",
                    points.at,
                    format!("a point of this list is not on the arc that it ends (circle of line {})", circle.line),
                    "check the arc in the CAM system; `--circle-sense` says which way round it goes",
                ));
            }
        }
        Ok(())
    }

    /// Where the tool stands, for what counts from there.
    fn standing(&self, name: &'static str, at: Span) -> Result<Pose, Fault> {
        if self.cycle.above_hole {
            return Err(Fault::new(
                name,
                at,
                format!("{name} stands behind a hole: whether it counts from the hole or from above it is not known"),
                "give a GOTO in front of it",
            ));
        }
        self.here.ok_or_else(|| {
            Fault::new(
                name,
                at,
                format!("{name} counts from where the tool stands, and nothing before it says where that is"),
                "give a GOTO or FROM before it",
            )
        })
    }

    /// Where the tool is said to stand, by FROM.
    pub(super) fn stand_at(&mut self, pose: Pose) {
        self.here = Some(pose);
        self.cycle.above_hole = false;
        self.line_from = None;
        self.votes.settle(None);
    }

    /// GODLTA with three numbers.
    pub(super) fn go_by(&mut self, point: &Point, here: Location) -> Result<(), Fault> {
        let unit = self.millimetres(point.at)?;
        let from = self.standing("GODLTA", point.at)?;
        let (pose, normalised) = self.pose(&Point { tip: [0.0; 3], ..*point })?;
        self.count_normalised(normalised, here);
        let step = self.changes.vector(Vector3::from(point.tip.map(|value| value * unit)));
        self.move_to(Pose { tip: from.tip + step, axis: pose.axis }, point.at, here)
    }

    /// GODLTA with one number.
    pub(super) fn go_along_axis(&mut self, distance: f64, at: Span, here: Location) -> Result<(), Fault> {
        let unit = self.millimetres(at)?;
        let from = self.standing("GODLTA", at)?;
        let known = self.axis.known(at)?;
        let axis = self.changes.direction(known);
        self.move_to(Pose { tip: from.tip + axis.into_inner() * (distance * unit), axis }, at, here)
    }

    /// GOHOME.
    pub(super) fn go_home(&mut self, point: Option<&Point>, here: Location) -> Result<(), Fault> {
        self.rapid = false;
        self.cycle.above_hole = false;
        self.votes.settle(None);
        self.line_from = None;
        let Some(point) = point else {
            self.here = None;
            self.emit(here, Event::Home);
            return Ok(());
        };
        let (pose, normalised) = self.pose(point)?;
        self.count_normalised(normalised, here);
        self.motions += 1;
        self.here = Some(pose);
        let pose = self.tip(pose, point.at)?;
        self.emit(here, Event::SafeSequence);
        self.emit(here, Event::Move(Move { pose, rapid: true, feed: self.feed }));
        Ok(())
    }

    /// RETRCT.
    pub(super) fn retract(&mut self, here: Location) -> Result<(), Fault> {
        let fault = |text, help| Err(Fault::new("RETRCT", Span::WHOLE, text, help));
        let Some(plane) = self.clearance else {
            return fault("RETRCT goes to the clearance plane, and there is none", "give CLEARP before it");
        };
        // The way along the tool is the same from a hole and from above it.
        self.cycle.above_hole = false;
        let from = self.standing("RETRCT", Span::WHOLE)?;
        let along = from.axis.dot(&plane.normal);
        if along < 1e-3 {
            return fault("the tool axis does not lead to the clearance plane", "check CLEARP");
        }
        let distance = (plane.distance - from.tip.coords.dot(&plane.normal)) / along;
        self.rapid = true;
        if distance <= 0.0 {
            // The tool stands above the plane already.
            self.rapid = false;
            return Ok(());
        }
        self.move_to(Pose { tip: from.tip + from.axis.into_inner() * distance, ..from }, Span::WHOLE, here)
    }

    /// CIRCLE, MOVARC.
    pub(super) fn open_circle(&mut self, circle: &Circle, here: Location) -> Result<(), Fault> {
        let unit = self.millimetres(circle.at)?;
        if std::mem::take(&mut self.rapid) {
            return Err(Fault::new(
                "circle",
                Span::WHOLE,
                "RAPID stands before a circle: no control runs an arc at rapid",
                "give the arc a feed",
            ));
        }
        self.standing("CIRCLE", circle.at)?;
        let axis = Vector3::from(circle.axis);
        let length = axis.norm();
        if (length - 1.0).abs() > 1e-3 {
            return Err(Fault::new(
                "circle",
                circle.at,
                format!("the axis of this circle has length {length:.6}, not 1"),
                "i, j, k are a vector of length 1",
            ));
        }
        let sense = match circle.form {
            CircleForm::Six | CircleForm::Seven => Sense::CounterClockwise,
            CircleForm::Eleven => Sense::Clockwise,
        };
        let centre = self.changes.point(Point3::from(circle.centre.map(|value| value * unit)));
        self.circle = Some(arcs::Pending {
            centre: near(centre, circle.at)?,
            axis: self.changes.direction(UnitVector3::new_normalize(axis)),
            sense: self.options.circle_sense.unwrap_or(sense),
            radius: circle.radius.map(|radius| radius * unit),
            times: circle.times,
            angle: circle.angle.map(f64::to_radians),
            line: here.line,
        });
        Ok(())
    }

    /// The GOTO behind a circle.
    fn end_circle(&mut self, circle: &arcs::Pending, end: Pose, at: Span, here: Location) -> Result<(), Fault> {
        if std::mem::take(&mut self.rapid) {
            return Err(Fault::new("circle", at, "RAPID stands before the end of an arc", "give the arc a feed"));
        }
        let start = self.standing("CIRCLE", at)?;
        let arc = arcs::arc(circle, &start, &end, self.feed, at)?;
        let line = self.line_from.map(|from| start.tip - from);
        let frame = self.workpiece.number();
        self.votes.arc(&arc, &circle.axis, line, frame, here);
        self.write_arc(arc, at, here)
    }

    fn write_arc(&mut self, mut arc: Arc, at: Span, here: Location) -> Result<(), Fault> {
        self.motions += 1;
        self.here = Some(arc.end);
        self.line_from = None;
        let start = self.tip(arc.start, at)?;
        arc.centre += start.tip - arc.start.tip;
        arc.start = start;
        arc.end = self.tip(arc.end, at)?;
        self.emit(here, Event::Arc(arc));
        Ok(())
    }

    /// TLON of CATIA: the plane is that of the radius to the start and of INDIRV.
    pub(super) fn tangent_arc(&mut self, record: &TangentArc, here: Location) -> Result<(), Fault> {
        let at = record.at;
        let fault = |text: String| {
            Fault::new("TLON", at, text, "have the CAM system write lines instead of arcs, or check this one")
        };
        let unit = self.millimetres(at)?;
        let start = self.standing("TLON", at)?;
        if std::mem::take(&mut self.rapid) {
            return Err(fault("RAPID stands before an arc".into()));
        }
        self.tangent_arc_begun = false;
        let Some(direction) = self.direction.take() else {
            return Err(fault("no INDIRV says in which direction this arc begins".into()));
        };
        let point = |p: [f64; 3]| near(self.changes.point(Point3::from(p.map(|value| value * unit))), at);
        let (centre, radius) = (point(record.centre)?, record.radius * unit);
        let (from, end) = (point(record.line[0])?, point(record.line[1])?);
        let off = ((end - centre).norm() - radius).abs();
        if off > ARC_TOLERANCE_MM {
            return Err(fault(format!("the end of the line is {off:.4} mm off the circle, so the end is not known")));
        }
        if record.second && (end - from).dot(&(centre - from)) > 0.0 && (end - centre).dot(&(end - from)) < 0.0 {
            return Err(fault("the end of the line is the first intersection with the circle, not the second".into()));
        }
        let arm = start.tip - centre;
        let across = direction.dot(&arm).abs() / radius.max(f64::MIN_POSITIVE);
        if across > TANGENT {
            return Err(fault("INDIRV is not tangential to the circle where the arc begins".into()));
        }
        let normal = arm.cross(&direction);
        let Some(normal) = UnitVector3::try_new(normal, 1e-9) else {
            return Err(fault("the plane of this arc is not known".into()));
        };
        let circle = arcs::Pending {
            centre,
            axis: normal,
            sense: Sense::CounterClockwise,
            radius: Some(radius),
            times: 1,
            angle: None,
            line: here.line,
        };
        let arc = arcs::arc(&circle, &start, &Pose { tip: end, axis: start.axis }, self.feed, at)?;
        self.votes.settle(None);
        self.write_arc(arc, at, here)
    }

    /// NURBS.
    pub(super) fn open_curve(&mut self, here: Location) -> Result<(), Fault> {
        if std::mem::take(&mut self.rapid) {
            return Err(Fault::new("NURBS", Span::WHOLE, "RAPID stands before a curve", "give the curve a feed"));
        }
        let start = self.standing("NURBS", Span::WHOLE)?;
        let tip = self.tip(start, Span::WHOLE)?.tip;
        self.curve.begin(tip, start.axis, self.feed, here);
        self.curve_open = true;
        Ok(())
    }

    fn curve_needed(&self, name: &'static str, at: Span) -> Result<(), Fault> {
        if self.curve_open && self.curve.has_room() {
            return Ok(());
        }
        let text = if self.curve_open {
            "this curve has more points than a curve of a tool path can have".to_string()
        } else {
            format!("{name} stands outside a NURBS")
        };
        Err(Fault::new("NURBS", at, text, "knots and control points stand behind NURBS/"))
    }

    /// KNOT.
    pub(super) fn take_knots(&mut self, knots: &Numbers<'_>) -> Result<(), Fault> {
        self.curve_needed("KNOT", knots.at)?;
        self.curve.knots.extend(knots.values());
        Ok(())
    }

    /// CNTRL.
    pub(super) fn take_control_point(&mut self, point: &Point) -> Result<(), Fault> {
        self.curve_needed("CNTRL", point.at)?;
        let start = self.standing("CNTRL", point.at)?;
        // The axis is held: only the place is of interest.
        let axis = std::mem::take(&mut self.axis);
        let pose = self.pose(point);
        self.axis = axis;
        let (pose, _) = pose?;
        let pose = Pose { axis: start.axis, ..pose };
        let shifted = self.tip(pose, point.at)?;
        self.curve.points.push(shifted.tip);
        self.here = Some(pose);
        Ok(())
    }

    /// The record behind a curve completes it.
    pub(super) fn close_curve(&mut self, record: &Record<'_>) -> Result<(), Fault> {
        if !self.curve_open || matches!(record, Record::Knots(_) | Record::ControlPoint(_) | Record::Inert) {
            return Ok(());
        }
        self.curve_open = false;
        self.line_from = None;
        self.votes.settle(None);
        self.note_state();
        if let Err(why) = self.curve.complete() {
            return Err(Fault::new(
                "NURBS",
                Span::WHOLE,
                format!("the curve of line {} is not understood: {why}", self.curve.at.line),
                "have the CAM system write lines instead of curves",
            ));
        }
        self.motions += 1;
        std::mem::swap(&mut self.curve, &mut self.complete);
        let at = self.complete.at;
        self.push(at, Pending::Spline);
        Ok(())
    }

    /// CYCLE with a kind.
    pub(super) fn define_cycle(&mut self, cycle: &Cycle) -> Result<(), Fault> {
        self.cycle.active = true;
        self.cycle.definition = None;
        self.votes.settle(None);
        let args = self.options.cycle_args.iter().find(|(kind, _)| *kind == cycle.kind).map(|(_, args)| args.clone());
        let named = holes::with_names(cycle, args.as_deref())?;
        let feed = match named.feed {
            Some((value, unit)) => Some(self.feed_of(value, unit, cycle.at, cycle.at)?),
            None => None,
        };
        let unit = self.millimetres(cycle.at)?;
        let context =
            Context { dialect: self.dialect(), unit, initial: self.cycle.initial.take(), args: args.as_deref(), feed };
        let definition = holes::define(cycle, &context)?;
        self.begin_holes(definition, cycle.at)
    }

    /// Holes follow; the level before them is that of the tool now.
    fn begin_holes(&mut self, definition: Definition, at: Span) -> Result<(), Fault> {
        self.cycle.active = true;
        self.cycle.before = self.here.map(|pose| pose.tip);
        if definition.back == Back::Initial && self.here.is_none() {
            return Err(Fault::new(
                "CYCLE",
                at,
                "RTRCTO,AUTO goes back to the level before the cycle, and nothing says where the tool stands",
                "give a GOTO before the cycle",
            ));
        }
        self.cycle.definition = Some(definition);
        Ok(())
    }

    /// CYCLE/OFF, ON, INIT, CLEAR.
    pub(super) fn switch_cycle(&mut self, state: CycleState, at: Span) -> Result<(), Fault> {
        match state {
            CycleState::Off => self.cycle.active = false,
            CycleState::Initial => self.cycle.initial = Some(true),
            CycleState::Clear => self.cycle.initial = Some(false),
            CycleState::On => {
                let Some(definition) = self.cycle.definition else {
                    let text = "CYCLE/ON without a cycle before it in this operation";
                    return Err(Fault::new("CYCLE", at, text, "define the cycle first"));
                };
                return self.begin_holes(definition, at);
            }
        }
        Ok(())
    }

    /// A point under a cycle.
    fn hole(&mut self, top: Pose, at: Span, here: Location) -> Result<(), Fault> {
        self.rapid = false;
        self.motions += 1;
        self.line_from = None;
        // The record was refused: so are its holes, silently.
        let Some(cycle) = self.cycle.definition else {
            self.here = Some(top);
            return Ok(());
        };
        let back_to = match cycle.back {
            Back::Clearance => cycle.clearance,
            Back::Level(level) => level,
            Back::Initial => {
                let before = self.cycle.before.unwrap_or(top.tip);
                let level = (before - top.tip).dot(&top.axis);
                if level < cycle.clearance - ARC_TOLERANCE_MM {
                    return Err(Fault::new(
                        "CYCLE",
                        at,
                        format!(
                            "the level before the cycle lies {level:.4} mm above this hole, below its clearance level"
                        ),
                        "retract further before the cycle, or give a return level",
                    ));
                }
                level.max(cycle.clearance)
            }
        };
        near(top.tip - top.axis.into_inner() * cycle.depth, at)?;
        self.here = Some(Pose { tip: near(top.tip + top.axis.into_inner() * back_to, at)?, ..top });
        self.cycle.above_hole = true;
        let top = self.tip(top, at)?;
        let (depth, clearance) = (cycle.depth, cycle.clearance);
        let feed = cycle.feed.or(self.feed);
        self.emit(
            here,
            Event::Hole(Hole { top, depth, clearance, back_to, drilling: cycle.drilling, feed, dwell: cycle.dwell }),
        );
        Ok(())
    }
}
