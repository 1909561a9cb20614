//! What records mean in their context: units, modes, and the events they cause.
//!
//! Modal here: the units of the file, the tool axis, the feed, a RAPID that waits for its motion, the cutter that waits
//! for its tool, changes of coordinates, a circle, a curve or a cycle that is open. A tool's event is held back until the
//! next event, because Creo gives the diameter behind it. Motion is in `path`,
//! units, feeds and tools in `state`.

use std::collections::VecDeque;

use super::Dialect;
use super::arcs::{self, Votes};
use super::axis::ModalAxis;
use super::change::{Changes, Rigid, same_direction};
use super::fault::{Fault, Span};
use super::frame::{Frame, Workpiece};
use super::holes::Definition;
use super::options::{ClPoint, Options};
use super::record::{AxisPlane, Cutter, Point, Record, Text};
use super::spline::Curve;
use super::vector::near;
use crate::kinematics::Pose;
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Compensation, Event, Feed, Location, Move, Plane, ToolCall, Units};

/// What a text is for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Meant {
    Name,
    MachineName,
    Operation,
    Message,
    Insert,
}

/// An event whose text, if any, still lies in the statement; a spline lies in the interpreter.
#[derive(Debug, Clone, Copy)]
pub(super) enum Pending {
    Plain(Event<'static>),
    Text(Meant, Span),
    Spline,
}

/// Cutters seen, for the plausibility of the units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cutters {
    pub(super) largest_mm: f64,
    pub(super) first: Location,
}

/// A CYCLE, in force or suspended.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct CycleInForce {
    pub(super) active: bool,
    /// `None` in an active cycle: its record was refused.
    pub(super) definition: Option<Definition>,
    /// CYCLE/INIT (true) or CYCLE/CLEAR stood in front.
    pub(super) initial: Option<bool>,
    /// Where the tool stood when the cycle began or was resumed.
    pub(super) before: Option<Point3<f64>>,
    /// The last motion was a hole: the tool stands above the point of its record.
    pub(super) above_hole: bool,
}

/// Everything modal.
#[derive(Debug, Default)]
pub(super) struct Interpreter {
    pub(super) options: Options,
    pub(super) found_units: Option<(Units, Location)>,
    pub(super) units_missed: bool,
    found_dialect: Dialect,
    pub(super) axis: ModalAxis,
    pub(super) rapid: bool,
    pub(super) feed: Option<Feed>,
    pub(super) cutter_of_next: Option<Cutter>,
    /// Nothing has moved since that cutter was described.
    pub(super) cutter_is_new: bool,
    /// The cutter that moved last without a tool record for it.
    pub(super) uncalled_cutter: Option<Cutter>,
    pub(super) held: Option<ToolCall>,
    pub(super) held_at: Location,
    pub(super) last_tool: Option<ToolCall>,
    pub(super) workpiece: Workpiece,
    pub(super) world: bool,
    /// The tool axis of the CSYS in force.
    pub(super) setup: Option<UnitVector3<f64>>,
    pub(super) changes: Changes,
    pub(super) clearance: Option<Plane>,
    pub(super) circle: Option<arcs::Pending>,
    /// INDIRV.
    pub(super) direction: Option<Vector3<f64>>,
    /// AUTOPS, INDIRV: a TLON must follow.
    pub(super) tangent_arc_begun: bool,
    pub(super) votes: Votes,
    /// A curve that is being read.
    pub(super) curve_open: bool,
    pub(super) curve: Curve,
    /// The curve of the event that waits.
    pub(super) complete: Curve,
    pub(super) cycle: CycleInForce,
    /// The next GOTO is a straight motion and nothing else: see `path`.
    pub(super) plain: bool,
    /// Where the tool stands, in the workpiece frame.
    pub(super) here: Option<Pose>,
    /// The feed line that led there begins here.
    pub(super) line_from: Option<Point3<f64>>,
    pub(super) motions: u64,
    pub(super) normalised: u64,
    pub(super) first_normalised: Location,
    /// The CAM system asks for inverse-time feed.
    pub(super) inverse_time: bool,
    /// The CSYS stated last, and how often another one came.
    pub(super) setup_frame: Option<Frame>,
    pub(super) setup_changes: u64,
    pub(super) cutters: Option<Cutters>,
    pub(super) warnings: Vec<Fault>,
    pub(super) queue: VecDeque<(Location, Pending)>,
}

impl Interpreter {
    pub(super) fn new(options: Options) -> Self {
        let mut new = Interpreter { options, ..Self::default() };
        new.note_state();
        new
    }

    /// As found, else as given.
    pub(super) fn units(&self) -> Option<Units> {
        self.found_units.map(|(units, _)| units).or(self.options.units)
    }

    pub(super) fn units_are_only_given(&self) -> bool {
        self.found_units.is_none() && self.options.units.is_some()
    }

    pub(super) fn dialect(&self) -> Dialect {
        self.options.dialect.unwrap_or(self.found_dialect)
    }

    /// The first evidence decides.
    pub(super) fn suspect(&mut self, dialect: Dialect) {
        if self.found_dialect == Dialect::Generic {
            self.found_dialect = dialect;
        }
    }

    /// Takes the record of the statement at `here`.
    pub(super) fn take(&mut self, record: &Record<'_>, here: Location) -> Result<(), Fault> {
        self.close_curve(record)?;
        self.check_open(record)?;
        let taken = self.take_open(record, here);
        self.note_state();
        taken
    }

    fn take_open(&mut self, record: &Record<'_>, here: Location) -> Result<(), Fault> {
        match *record {
            Record::Goto(point) => self.go_to(&point, here)?,
            Record::Points(points) => self.go_along(&points, here)?,
            Record::From(point) => {
                let (pose, normalised) = self.pose(&point)?;
                self.count_normalised(normalised, here);
                self.stand_at(pose);
                if self.options.from_move {
                    self.motions += 1;
                    let pose = self.tip(pose, point.at)?;
                    self.emit(here, Event::Move(Move { pose, rapid: true, feed: self.feed }));
                } else {
                    let pose = self.tip(pose, point.at)?;
                    self.emit(here, Event::From(pose));
                }
            }
            Record::Delta(point) => self.go_by(&point, here)?,
            Record::DeltaAlongAxis { distance, at } => self.go_along_axis(distance, at, here)?,
            Record::Home(point) => self.go_home(point.as_ref(), here)?,
            Record::Retract => self.retract(here)?,
            Record::Rapid => self.rapid = true,
            Record::Circle(circle) => self.open_circle(&circle, here)?,
            Record::AutomaticPlane => self.tangent_arc_begun = true,
            Record::Direction { vector, at } => {
                let vector = self.changes.vector(Vector3::from(vector));
                if vector.norm() < 1e-9 {
                    return Err(Fault::new("INDIRV", at, "INDIRV points nowhere", "it is the direction of the path"));
                }
                self.direction = Some(vector.normalize());
                self.tangent_arc_begun = true;
            }
            Record::TangentArc(arc) => self.tangent_arc(&arc, here)?,
            Record::Nurbs => self.open_curve(here)?,
            Record::Knots(knots) => self.take_knots(&knots)?,
            Record::ControlPoint(point) => self.take_control_point(&point)?,
            Record::Cycle(cycle) => self.define_cycle(&cycle)?,
            Record::CycleState { state, at } => self.switch_cycle(state, at)?,
            Record::Feed { value, unit, at, unit_at } => self.feed = Some(self.feed_of(value, unit, at, unit_at)?),
            Record::InverseTime(on) => self.inverse_time |= on,
            Record::ToolAxis { axis, at } => {
                let normalised = self.axis.state(axis, at)?;
                self.count_normalised(normalised, here);
            }
            Record::MultiAxis(on) => {
                if !on && self.dialect() == Dialect::Creo {
                    self.axis.return_to_z();
                }
            }
            Record::Units(units) => self.take_units(units, here)?,
            Record::Frame(frame) => self.take_frame(&frame, here)?,
            Record::World => self.world = true,
            Record::Setup(frame) => self.take_setup(&frame, here)?,
            Record::Origin(origin) => {
                let origin = self.shift(origin)?;
                self.changes.set_origin(origin);
            }
            Record::Translation { by, at } => {
                if self.dialect() == Dialect::Creo {
                    return Err(Fault::new(
                        "TRANS",
                        at,
                        "TRANS of Creo belongs to output in the frame of each sequence, which is not known",
                        "have Creo write its CL data in the machine coordinate system, without TRANS",
                    ));
                }
                let by = self.shift(by)?;
                self.changes.set_translation(by);
            }
            Record::Transformation { matrix, at } => {
                let unit = self.millimetres(at)?;
                let tracut = matrix.map(|matrix| Rigid::from_rows(&matrix, unit, at)).transpose()?;
                self.changes.set_tracut(tracut);
            }
            Record::ToolPath(name) => {
                self.begin_operation();
                // A cutter that found no tool belongs to the operation that ends here.
                self.cutter_of_next = None;
                self.emit_text(here, Meant::Operation, name);
            }
            Record::Tool(tool) => self.call_tool(&tool, here)?,
            Record::LengthOffset { register, at } => self.take_length_offset(register, at)?,
            Record::Cutter(cutter) if self.dialect() != Dialect::Creo => {
                self.cutter_of_next = Some(self.in_millimetres(cutter, here)?);
                self.cutter_is_new = true;
            }
            Record::Cutter(cutter) | Record::CutterOfLastTool(cutter) => {
                let cutter = self.in_millimetres(cutter, here)?;
                if let Some(tool) = self.held.as_mut().or(self.last_tool.as_mut()) {
                    tool.diameter = Some(cutter.diameter);
                    tool.corner_radius = cutter.corner_radius;
                }
            }
            Record::Preselect(number) => self.emit(here, Event::Preselect(number)),
            Record::Spindle(spindle) => self.emit(here, Event::Spindle(spindle)),
            Record::Coolant(coolant) => self.emit(here, Event::Coolant(coolant)),
            Record::Compensation { side, register, plane } => {
                let xy = plane.is_none_or(|plane| plane == AxisPlane::Xy);
                self.emit(here, Event::Compensation(Compensation { side, register, xy }));
            }
            Record::Turning(turning) => self.emit(here, Event::Turning(turning)),
            Record::Delay { dwell, at } => self.delay(dwell, at, here),
            Record::Tolerance { value, at } => self.take_tolerance(value, at, here)?,
            Record::ClearancePlane { normal, distance, at } => self.take_clearance(normal, distance, at, here)?,
            Record::OptionalStop => self.emit(here, Event::OptionalStop),
            Record::Stop => self.emit(here, Event::Stop),
            Record::PartName(text) => self.emit_text(here, Meant::Name, text),
            Record::MachineName(text) => self.emit_text(here, Meant::MachineName, text),
            Record::Message(text) => self.emit_text(here, Meant::Message, text),
            Record::Insert(text) => self.insert(text, here)?,
            Record::Code { letter, number, at } => self.code(letter, number, at, here)?,
            Record::EndOfPath
            | Record::End
            | Record::Fini
            | Record::Rewind
            | Record::Inert
            | Record::DefineSubprogram(_)
            | Record::EndSubprogram
            | Record::CallSubprogram { .. } => {}
        }
        Ok(())
    }

    /// Says what is still open at the end of the file, and lets go of a tool that is held back.
    pub(super) fn finish(&mut self) -> Result<(), Fault> {
        let closed = self.close_curve(&Record::Fini);
        self.let_go();
        self.votes.settle(None);
        closed?;
        match self.circle.take() {
            Some(circle) => Err(Fault::new(
                "circle",
                Span::WHOLE,
                format!("the file ends before the GOTO that ends the arc of line {}", circle.line),
                "check whether the CAM system wrote the file completely",
            )),
            None => Ok(()),
        }
    }

    pub(super) fn let_go(&mut self) {
        if let Some(tool) = self.held.take() {
            self.last_tool = Some(tool);
            self.queue.push_back((self.held_at, Pending::Plain(Event::Tool(tool))));
        }
    }

    pub(super) fn emit(&mut self, here: Location, event: Event<'static>) {
        self.push(here, Pending::Plain(event));
    }

    pub(super) fn push(&mut self, here: Location, event: Pending) {
        if self.held.is_some() {
            self.let_go();
        }
        self.queue.push_back((here, event));
    }

    pub(super) fn emit_text(&mut self, here: Location, meant: Meant, text: Text<'_>) {
        self.push(here, Pending::Text(meant, text.at));
    }

    /// The pose of a point, in the workpiece frame.
    pub(super) fn pose(&mut self, point: &Point) -> Result<(Pose, bool), Fault> {
        let unit = self.millimetres(point.at)?;
        let tip = near(Point3::from(point.tip.map(|value| value * unit)), point.at)?;
        let (axis, normalised) = self.axis.at_point(point.axis, point.at)?;
        let pose = Pose { tip, axis };
        if let (Some(setup), Some(given)) = (self.setup, point.axis)
            && !same_direction(&setup, given)
        {
            return Err(Fault::new(
                "tool axis",
                point.at,
                "this tool axis contradicts the third column of CSYS",
                "under one CSYS the tool keeps its direction: check the set-up in the CAM system",
            ));
        }
        if self.plain {
            return Ok((pose, normalised));
        }
        let tip = near(self.changes.point(tip), point.at)?;
        Ok((Pose { tip, axis: self.changes.direction(axis) }, normalised))
    }

    /// The tip of a pose that may be programmed at the centre of the corner radius.
    pub(super) fn tip(&mut self, pose: Pose, at: Span) -> Result<Pose, Fault> {
        if self.plain {
            return Ok(pose);
        }
        let tool = self.held.or(self.last_tool);
        let number = tool.map(|tool| tool.number);
        let given = number.and_then(|number| self.options.cl_point_of.get(&number)).copied();
        if given.unwrap_or(self.options.cl_point) == ClPoint::Tip {
            return Ok(pose);
        }
        let Some(radius) = tool.and_then(|tool| tool.corner_radius) else {
            return Err(Fault::new(
                "cl_point",
                at,
                "the CL data programs the centre of the corner radius, and the radius of this tool is unknown",
                "give it with CUTTER or TLDATA in front of the tool call",
            ));
        };
        Ok(Pose { tip: pose.tip - pose.axis.into_inner() * radius, axis: pose.axis })
    }

    pub(super) fn count_normalised(&mut self, normalised: bool, here: Location) {
        if normalised {
            if self.normalised == 0 {
                self.first_normalised = here;
            }
            self.normalised += 1;
        }
    }

    /// Whether the next GOTO is a motion and nothing waits in front of it.
    #[inline]
    pub(super) fn is_straight(&self) -> bool {
        self.plain && self.held.is_none() && self.queue.is_empty()
    }

    /// Whether a GOTO has nothing to do with circles, curves, cycles, votes and changes of coordinates.
    pub(super) fn note_state(&mut self) {
        self.plain = self.circle.is_none()
            && !self.curve_open
            && !self.tangent_arc_begun
            && !self.cutter_is_new
            && !self.cycle.active
            && !self.cycle.above_hole
            && !self.votes.waits()
            && self.changes.none()
            && self.options.cl_point == ClPoint::Tip
            && self.options.cl_point_of.is_empty();
    }

    fn shift(&mut self, by: Option<[f64; 3]>) -> Result<Option<[f64; 3]>, Fault> {
        match by {
            None => Ok(None),
            Some(by) => {
                let unit = self.millimetres(Span::WHOLE)?;
                Ok(Some(by.map(|value| value * unit)))
            }
        }
    }

    /// A cycle, a circle or a TLON that is open allows few records.
    fn check_open(&mut self, record: &Record<'_>) -> Result<(), Fault> {
        let fault = |kind, text: String, help: &str| Err(Fault::new(kind, Span::WHOLE, text, help));
        let moves = matches!(
            record,
            Record::Goto(_)
                | Record::Points(_)
                | Record::Delta(_)
                | Record::DeltaAlongAxis { .. }
                | Record::Home(_)
                | Record::Retract
                | Record::Circle(_)
                | Record::Nurbs
        );
        if moves && std::mem::take(&mut self.tangent_arc_begun) {
            self.direction = None;
            return fault(
                "TLON",
                "this motion stands behind AUTOPS or INDIRV, where TLON is expected".into(),
                "have the CAM system write lines instead of arcs",
            );
        }
        if let Some(circle) = &self.circle {
            let passes = matches!(
                record,
                Record::Goto(_)
                    | Record::Points(_)
                    | Record::Delta(_)
                    | Record::Feed { .. }
                    | Record::InverseTime(_)
                    | Record::Inert
                    | Record::Message(_)
                    | Record::Coolant(_)
                    | Record::Tolerance { .. }
            );
            if !passes {
                let line = circle.line;
                self.circle = None;
                return fault(
                    "circle",
                    format!("the circle of line {line} has no end: this record stands before its GOTO"),
                    "behind CIRCLE stands the GOTO that ends the arc",
                );
            }
        }
        if self.cycle.active
            && matches!(
                record,
                Record::Circle(_)
                    | Record::TangentArc(_)
                    | Record::Nurbs
                    | Record::Home(_)
                    | Record::Retract
                    | Record::Tool(_)
                    | Record::ToolPath(_)
                    | Record::Frame(_)
                    | Record::Setup(_)
                    | Record::Insert(_)
                    | Record::Code { .. }
                    | Record::Stop
                    | Record::OptionalStop
            )
        {
            self.cycle.active = false;
            return fault(
                "CYCLE",
                "this record stands under a CYCLE, where only points of holes are expected".into(),
                "end the cycle before it: CYCLE/OFF",
            );
        }
        Ok(())
    }
}
