//! Interprets records of motion: points, arcs, curves and holes.

use super::RecordInterpreter;
use crate::cl::dialect::Dialect;
use crate::cl::meaning::arc::{FileCoordinates, WaitingCircle, arc_of, is_on, tangent_circle, tlon_fault};
use crate::cl::meaning::axis::Normalised;
use crate::cl::meaning::event_queue::QueuedEvent;
use crate::cl::meaning::feed::feed_of;
use crate::cl::meaning::holes::{self, CycleContext, HoleDefinition, OF_ANOTHER_POST};
use crate::cl::meaning::votes::ArcKind;
use crate::cl::record::{
    ArcRecord, CircleForm, CircleRecord, CycleCall, CycleRecord, FeedRecord, MotionRecord, Numbers, NurbsRecord, Point,
    TangentArc,
};
use crate::cl::text::{ClFault, Span};
use crate::cl::vector::within_a_kilometre;
use crate::diag::code::cl;
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, Vector3};
use crate::program::{Arc, Event, Hole, Location, Move, NewStart, ReferenceGeometry, ToolMotion};
use crate::set_up::ClPoint;

impl RecordInterpreter {
    #[inline(always)]
    pub(crate) fn take_motion(&mut self, record: &MotionRecord<'_>, here: Location) -> Result<(), ClFault> {
        self.emit_waiting();
        if !matches!(record, MotionRecord::Home(None)) {
            self.refuse_empty_spindle();
        }
        match record {
            MotionRecord::From(point) => self.start_at(point, here),
            MotionRecord::Goto(point) => self.go_to(point, here),
            MotionRecord::Points(points) => self.go_along(points, here),
            MotionRecord::Delta(step) => self.go_by(step, here),
            MotionRecord::DeltaAlongAxis { distance, at } => self.go_along_axis(*distance, *at, here),
            MotionRecord::Home(point) => self.go_home(point.as_ref(), here),
            MotionRecord::Retract => self.retract(here),
        }
    }

    /// Pose of a point, in the workpiece frame.
    fn pose(&mut self, point: &Point, here: Location) -> Result<Pose, ClFault> {
        let (Pose { tip, axis }, normalised) = self.pose_in_file(point)?;
        let transforms = self.coordinates.transforms();
        let (tip, axis) = if transforms.none() {
            (tip, axis)
        } else {
            (self.coordinates.point(tip, point.at)?, transforms.direction(axis))
        };
        self.axis.count(normalised, here);
        Ok(Pose { tip, axis })
    }

    /// Pose of a point in the frame of the file, which is that of the workpiece where no transform is in force.
    #[inline(always)]
    fn pose_in_file(&mut self, point: &Point) -> Result<(Pose, Normalised), Box<ClFault>> {
        let unit_mm = self.units.millimetres(point.at)?;
        let tip = within_a_kilometre(Point3::from(point.tip.map(|value| value * unit_mm)), point.at)?;
        let (axis, normalised) = self.axis.at_point(point.axis, point.at)?;
        self.coordinates.set_up().check_axis(point.axis, point.at)?;
        Ok((Pose { tip, axis }, normalised))
    }

    /// Pose of the tool tip, where the CL data may program the centre of the corner radius.
    #[inline]
    fn tip(&self, pose: Pose, at: Span) -> Result<Pose, ClFault> {
        if self.options.always_tip() { Ok(pose) } else { self.tip_of_tool(pose, at) }
    }

    /// Pose of the tool tip, by the point that is set for the present tool.
    fn tip_of_tool(&self, pose: Pose, at: Span) -> Result<Pose, ClFault> {
        let number = self.tool.current().map(|tool| tool.number).or(self.options.default_tool);
        let given = number.and_then(|number| self.options.cl_point_of.get(&number)).copied();
        if given.unwrap_or(self.options.cl_point) == ClPoint::Tip {
            return Ok(pose);
        }
        let of_entry = || self.options.tools.get(&number?)?.corner_radius_mm;
        let Some(radius) = self.tool.corner_radius_mm().or_else(of_entry) else {
            let entry = number.map_or_else(|| "N".to_owned(), |number| number.to_string());
            return Err(cl::TOOL.cl_fault(
                "cl_point",
                at,
                "the CL data programs the centre of the corner radius, and the radius of this tool is unknown",
                format!("program CUTTER or TLDATA before the tool call, or give `[tools.{entry}] corner_radius`"),
            ));
        };
        Ok(Pose { tip: pose.tip - pose.axis.into_inner() * radius, axis: pose.axis })
    }

    /// FROM.
    fn start_at(&mut self, point: &Point, here: Location) -> Result<(), ClFault> {
        let pose = self.pose(point, here)?;
        self.path.start_at(pose);
        self.votes.conclude_arc(None);
        if !self.options.from_move {
            let pose = self.tip(pose, point.at)?;
            self.emit(here, Event::Reference(ReferenceGeometry::From(pose)));
            return Ok(());
        }
        self.path.count_motion();
        let pose = self.tip(pose, point.at)?;
        self.emit(here, Event::Motion(ToolMotion::Move(Move { pose, rapid: true, feed: self.path.feed() })));
        Ok(())
    }

    /// GOTO.
    fn go_to(&mut self, point: &Point, here: Location) -> Result<(), ClFault> {
        if self.plain_goto {
            let motion = self.straight(point, here)?;
            self.emit(here, Event::Motion(ToolMotion::Move(motion)));
            return Ok(());
        }
        let pose = self.pose(point, here)?;
        self.move_to(pose, point.at, here)
    }

    /// GOTO while no arc, curve or cycle is open and no transform is in force.
    #[inline(always)]
    pub(crate) fn straight(&mut self, point: &Point, here: Location) -> Result<Move, Box<ClFault>> {
        let (pose, normalised) = self.pose_in_file(point)?;
        self.axis.count(normalised, here);
        let rapid = self.path.move_to(pose);
        Ok(Move { pose, rapid, feed: self.path.feed() })
    }

    /// Motion to a pose in the workpiece frame: the end of an arc, a hole, or a straight motion.
    #[cold]
    fn move_to(&mut self, pose: Pose, at: Span, here: Location) -> Result<(), ClFault> {
        within_a_kilometre(pose.tip, at)?;
        self.note_cut();
        if let Some(circle) = self.arc.circle() {
            let arc = self.arc_to(&circle, pose, at, here)?;
            self.emit(here, Event::Motion(ToolMotion::Arc(arc)));
            return Ok(());
        }
        if self.cycle.is_active() {
            return self.hole(pose, at, here);
        }
        self.votes.conclude_arc(self.path.line_to(pose.tip));
        let rapid = self.path.move_to(pose);
        let pose = self.tip(pose, at)?;
        self.emit(here, Event::Motion(ToolMotion::Move(Move { pose, rapid, feed: self.path.feed() })));
        self.update_plain_goto();
        Ok(())
    }

    /// Notes that the next motion cuts, unless it is a rapid. Where points may be centres, they are those of the cutter
    /// described last in rapids, too.
    #[inline(always)]
    fn note_cut(&mut self) {
        if self.tool.is_described_anew() && !(self.path.is_rapid() && self.options.always_tip()) {
            let taken = self.tool.cut(&self.options);
            self.refuse(taken.err());
        }
    }

    /// Arc on the open circle to a pose in the workpiece frame.
    #[inline(always)]
    fn arc_to(&mut self, circle: &WaitingCircle, pose: Pose, at: Span, here: Location) -> Result<Arc, ClFault> {
        self.arc.close_circle();
        let arc = self.end_circle(circle, pose, at, here);
        // After a refused arc the position is its end, too.
        self.path.set_here(pose);
        arc
    }

    /// GOTO with a list of points; after a CIRCLE the last one is the end of the arc.
    fn go_along(&mut self, points: &Numbers<'_>, here: Location) -> Result<(), ClFault> {
        let Some(circle) = self.arc.circle() else {
            return points.points().try_for_each(|point| self.go_to(&point, here));
        };
        let Some(end) = points.points().last() else { return Ok(()) };
        let circle = if circle.has_sense() { circle } else { self.with_sense(circle, points, &end, here)? };
        let passed = self.pass(&circle, points, &end, here);
        self.go_to(&end, here).and(passed)
    }

    /// The open circle with the sense that the points of a list state.
    fn with_sense(
        &mut self,
        circle: WaitingCircle,
        points: &Numbers<'_>,
        end: &Point,
        here: Location,
    ) -> Result<WaitingCircle, ClFault> {
        let start = self.path.position("CIRCLE", points.at)?;
        let end = self.pose(end, here)?;
        let tips =
            points.points().map(|point| Ok(self.pose(&point, here)?.tip)).collect::<Result<Vec<_>, ClFault>>()?;
        let circle = circle.through(tips.into_iter(), &start, &end);
        self.arc.open_circle(circle);
        Ok(circle)
    }

    /// Checks that the points of a list after a CIRCLE lie on its arc.
    fn pass(
        &mut self,
        circle: &WaitingCircle,
        points: &Numbers<'_>,
        end: &Point,
        here: Location,
    ) -> Result<(), ClFault> {
        let start = self.path.position("CIRCLE", points.at)?;
        let end = self.pose(end, here)?;
        let arc = arc_of(circle, &start, &end, self.path.feed(), points.at)?;
        for point in points.points() {
            let pose = self.pose(&point, here)?;
            if !is_on(&arc, pose.tip) {
                return Err(cl::ARC.cl_fault(
                    "circle",
                    points.at,
                    format!("a point of this list is not on its arc (circle of line {})", circle.line()),
                    "check the arc in the CAM system; `--circle-sense` sets its sense",
                ));
            }
        }
        Ok(())
    }

    /// GODLTA with three numbers.
    fn go_by(&mut self, point: &Point, here: Location) -> Result<(), ClFault> {
        let unit_mm = self.units.millimetres(point.at)?;
        let from = self.path.position("GODLTA", point.at)?;
        let pose = self.pose(&Point { tip: [0.0; 3], ..*point }, here)?;
        let step = self.coordinates.transforms().vector(Vector3::from(point.tip.map(|value| value * unit_mm)));
        self.move_to(Pose { tip: from.tip + step, axis: pose.axis }, point.at, here)
    }

    /// GODLTA with one number.
    fn go_along_axis(&mut self, distance: f64, at: Span, here: Location) -> Result<(), ClFault> {
        let unit_mm = self.units.millimetres(at)?;
        let from = self.path.position("GODLTA", at)?;
        let known = self.axis.known(at)?;
        let axis = self.coordinates.transforms().direction(known);
        self.move_to(Pose { tip: from.tip + axis.into_inner() * (distance * unit_mm), axis }, at, here)
    }

    /// GOHOME.
    fn go_home(&mut self, point: Option<&Point>, here: Location) -> Result<(), ClFault> {
        self.path.begin_home();
        self.votes.conclude_arc(None);
        let Some(point) = point else {
            self.path.forget_position();
            self.emit(here, Event::NewStart(NewStart::Home));
            return Ok(());
        };
        let pose = self.pose(point, here)?;
        self.path.count_motion();
        self.path.set_here(pose);
        let pose = self.tip(pose, point.at)?;
        self.emit(here, Event::NewStart(NewStart::SafeSequence));
        self.emit(here, Event::Motion(ToolMotion::Move(Move { pose, rapid: true, feed: self.path.feed() })));
        Ok(())
    }

    /// RETRCT.
    fn retract(&mut self, here: Location) -> Result<(), ClFault> {
        let fault = |text, help| Err(cl::POSITION.cl_fault("RETRCT", Span::WHOLE, text, help));
        let Some(plane) = self.path.clearance() else {
            return fault("RETRCT needs a clearance plane, and no CLEARP comes before it", "program CLEARP before it");
        };
        self.path.leave_hole();
        let from = self.path.position("RETRCT", Span::WHOLE)?;
        let along = from.axis.dot(&plane.normal);
        if along < 1e-3 {
            return fault(
                "RETRCT along the tool axis does not reach the clearance plane",
                "program CLEARP with a plane that the tool crosses along its axis, before this RETRCT",
            );
        }
        let distance = (plane.distance_mm - from.tip.coords.dot(&plane.normal)) / along;
        let is_above = distance <= 0.0;
        self.path.set_rapid(!is_above);
        if is_above {
            return Ok(());
        }
        self.move_to(Pose { tip: from.tip + from.axis.into_inner() * distance, ..from }, Span::WHOLE, here)
    }

    pub(crate) fn take_arc(&mut self, record: &ArcRecord, here: Location) -> Result<(), ClFault> {
        match record {
            ArcRecord::Circle(circle) => self.open_circle(circle, here)?,
            ArcRecord::Slope { height, at } => {
                let unit_mm = self.units.millimetres(*at)?;
                self.arc.set_slope(height.abs() * unit_mm);
            }
            ArcRecord::AutomaticPlane => self.arc.begin_tangent(),
            ArcRecord::Direction { vector, at } => {
                let direction = self.coordinates.transforms().vector(Vector3::from(*vector));
                self.arc.set_direction(direction, *at)?;
            }
            ArcRecord::TangentArc(arc) => self.tangent_arc(arc, here)?,
        }
        Ok(())
    }

    /// CIRCLE, MOVARC.
    pub(crate) fn open_circle(&mut self, circle: &CircleRecord, here: Location) -> Result<(), ClFault> {
        let unit_mm = self.units.millimetres(circle.at)?;
        if self.path.take_rapid() {
            return Err(cl::ARC.cl_fault(
                "circle",
                Span::WHOLE,
                "RAPID before a circle: no control runs an arc at rapid",
                "delete that RAPID: the arc then runs at the feed of the FEDRAT before it",
            ));
        }
        let camplete = self.dialect() == Dialect::Autodesk && circle.form == CircleForm::Eleven;
        let tool_axis = self.path.position("CIRCLE", circle.at)?.axis;
        let file = FileCoordinates { unit_mm, transforms: self.coordinates.transforms() };
        let waiting = WaitingCircle::new(circle, file, tool_axis, self.options.circle_sense, camplete, here.line)?;
        self.arc.open_circle(waiting);
        Ok(())
    }

    /// The arc that a GOTO after CIRCLE or MOVARC ends.
    #[inline(always)]
    fn end_circle(&mut self, circle: &WaitingCircle, end: Pose, at: Span, here: Location) -> Result<Arc, ClFault> {
        if self.path.take_rapid() {
            return Err(cl::ARC.cl_fault(
                "circle",
                at,
                "RAPID before the end of an arc: no control runs an arc at rapid",
                "delete that RAPID: the arc then runs at the feed of the FEDRAT before it",
            ));
        }
        let start = self.path.position("CIRCLE", at)?;
        let mut arc = arc_of(circle, &start, &end, self.path.feed(), at)?;
        let line = self.path.line_before(start.tip);
        let kind = ArcKind { frame: self.coordinates.workpiece().number(), stated: circle.is_sense_stated() };
        self.votes.add_arc(&arc, circle.axis(), line, kind, here);
        self.take_tip(&mut arc, at)?;
        Ok(arc)
    }

    /// Executes an arc, which becomes that of the tool tip.
    #[inline(always)]
    fn take_tip(&mut self, arc: &mut Arc, at: Span) -> Result<(), ClFault> {
        self.path.count_motion();
        if self.options.always_tip() {
            // The points are those of the tip: a shift by zero, after which no zero has a sign.
            arc.centre += Vector3::zeros();
            return Ok(());
        }
        let start = self.tip(arc.start, at)?;
        arc.centre += start.tip - arc.start.tip;
        arc.start = start;
        arc.end = self.tip(arc.end, at)?;
        Ok(())
    }

    /// TLON of CATIA.
    fn tangent_arc(&mut self, record: &TangentArc, here: Location) -> Result<(), ClFault> {
        let at = record.at;
        let unit_mm = self.units.millimetres(at)?;
        let start = self.path.position("TLON", at)?;
        if self.path.take_rapid() {
            return Err(tlon_fault(at, "RAPID before an arc: no control runs an arc at rapid".into()));
        }
        let direction = self.arc.end_tangent(at)?;
        let file = FileCoordinates { unit_mm, transforms: self.coordinates.transforms() };
        let (circle, end) = tangent_circle(record, &start, direction, file, here.line)?;
        let mut arc = arc_of(&circle, &start, &Pose { tip: end, axis: start.axis }, self.path.feed(), at)?;
        self.votes.conclude_arc(None);
        self.path.set_here(arc.end);
        self.take_tip(&mut arc, at)?;
        self.emit(here, Event::Motion(ToolMotion::Arc(arc)));
        Ok(())
    }

    pub(crate) fn take_nurbs(&mut self, record: &NurbsRecord<'_>, here: Location) -> Result<(), ClFault> {
        match record {
            NurbsRecord::Begin => self.open_curve(here),
            NurbsRecord::Knots(knots) => {
                self.curve.check_open("KNOT", knots.at)?;
                self.curve.add_knots(knots.values());
                Ok(())
            }
            NurbsRecord::ControlPoint(point) => self.take_control_point(point),
        }
    }

    fn open_curve(&mut self, here: Location) -> Result<(), ClFault> {
        if self.path.take_rapid() {
            return Err(cl::ARC.cl_fault(
                "NURBS",
                Span::WHOLE,
                "RAPID before a curve: it needs a feed",
                "delete that RAPID: the curve then runs at the feed of the FEDRAT before it",
            ));
        }
        let start = self.path.position("NURBS", Span::WHOLE)?;
        let tip = self.tip(start, Span::WHOLE)?.tip;
        self.curve.begin(tip, start.axis, self.path.feed(), here);
        Ok(())
    }

    fn take_control_point(&mut self, point: &Point) -> Result<(), ClFault> {
        self.curve.check_open("CNTRL", point.at)?;
        let start = self.path.position("CNTRL", point.at)?;
        let unit_mm = self.units.millimetres(point.at)?;
        let tip = within_a_kilometre(Point3::from(point.tip.map(|value| value * unit_mm)), point.at)?;
        // The tool axis is constant along a curve.
        let pose = Pose { tip: self.coordinates.point(tip, point.at)?, axis: start.axis };
        let shifted = self.tip(pose, point.at)?;
        self.curve.add_point(shifted.tip);
        self.path.set_here(pose);
        Ok(())
    }

    /// Completes a curve; the record after it ends it.
    pub(crate) fn close_curve(&mut self) -> Result<(), ClFault> {
        let closed = self.curve.close();
        self.path.forget_line();
        self.votes.conclude_arc(None);
        self.update_plain_goto();
        let at = closed?;
        self.path.count_motion();
        self.push(at, QueuedEvent::Spline);
        Ok(())
    }

    pub(crate) fn take_cycle(&mut self, record: &CycleRecord) -> Result<(), ClFault> {
        match record {
            CycleRecord::Define(cycle) => {
                let definition = self.definition_of(cycle)?;
                let before = self.path.here().map(|pose| pose.tip);
                self.cycle.begin_holes(definition, before, cycle.at)
            }
            CycleRecord::Change(_) if self.cycle.is_refused() => {
                self.cycle.resume_refused();
                Ok(())
            }
            CycleRecord::Change(change) => {
                let (was_active, cycle) = (self.cycle.is_active(), self.cycle.changed_by(change)?);
                let definition = self.definition_of(&cycle)?;
                if was_active {
                    return self.cycle.change(definition, cycle.at);
                }
                let before = self.path.here().map(|pose| pose.tip);
                self.cycle.begin_holes(definition, before, cycle.at)
            }
            CycleRecord::Switch { state, at } => {
                let before = self.path.here().map(|pose| pose.tip);
                self.cycle.switch(*state, before, *at)
            }
        }
    }

    /// The hole that a CYCLE defines. The cycle is active also where it is refused: its points are holes.
    fn definition_of(&mut self, cycle: &CycleCall) -> Result<HoleDefinition, ClFault> {
        self.cycle.begin_definition(cycle);
        self.votes.conclude_arc(None);
        let known = self.options.cycle_args.iter().find(|(kind, _)| *kind == cycle.kind);
        let args = known.map(|(_, args)| args.as_slice());
        let cycle = holes::with_names(cycle, args, self.dialect())?;
        let feed = match cycle.feed {
            Some((value, unit)) => {
                let record = FeedRecord { value, unit, at: cycle.at, unit_at: cycle.at };
                Some(feed_of(&record, &mut self.units, self.options.feed_label)?)
            }
            None => None,
        };
        let unit_mm = self.units.millimetres(cycle.at)?;
        let initial = self.cycle.take_initial();
        let context = CycleContext { dialect: self.dialect(), unit_mm, initial, feed };
        holes::define(&cycle, &context)
    }

    /// GOTO while a cycle is active.
    fn hole(&mut self, top: Pose, at: Span, here: Location) -> Result<(), ClFault> {
        self.path.begin_hole();
        // The record of the cycle was refused with a message, so its holes need none.
        let Some(cycle) = self.cycle.definition() else {
            self.path.set_here(top);
            return Ok(());
        };
        if cycle.plane.is_some() && !self.coordinates.transforms().none() {
            return Err(cl::HOLE.cl_fault(
                "CYCLE",
                at,
                "the levels of this cycle are coordinates along the tool axis, and the coordinates are transformed",
                format!(
                    "the post of Autodesk writes no ORIGIN, TRANS or TRACUT: delete the one before this cycle; {OF_ANOTHER_POST}"
                ),
            ));
        }
        let units = self.units.known().unwrap_or_default();
        let (top, cycle) = cycle.at(top, self.cycle.before(), units, at)?;
        let back_to = self.cycle.return_level(&cycle, &top, units, at)?;
        within_a_kilometre(top.tip - top.axis.into_inner() * cycle.depth_mm, at)?;
        let above = within_a_kilometre(top.tip + top.axis.into_inner() * back_to, at)?;
        self.path.end_hole(Pose { tip: above, ..top });
        let top = self.tip(top, at)?;
        let (depth, clearance) = (cycle.depth_mm, cycle.clearance_mm);
        let feed = cycle.feed.or(self.path.feed());
        self.emit(
            here,
            Event::Motion(ToolMotion::Hole(Hole {
                top,
                depth_mm: depth,
                clearance_mm: clearance,
                return_mm: back_to,
                drilling: cycle.drilling,
                feed,
                dwell: cycle.dwell,
            })),
        );
        Ok(())
    }
}
