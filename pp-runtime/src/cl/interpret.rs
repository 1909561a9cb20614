//! What records mean in their context: units, modes, and the events they cause.
//!
//! Modal here: the units of the file, the tool axis, the feed, a RAPID that waits for its motion, and the cutter that
//! waits for its tool. A tool's event is held back until the next event, because Creo gives the diameter behind it.

use super::Dialect;
use super::axis::ModalAxis;
use super::fault::{Fault, Span};
use super::frame::{Frame, Workpiece};
use super::record::{Cutter, FeedUnit, Point, Record, Tool};
use crate::kinematics::Pose;
use crate::nalgebra::Point3;
use crate::program::{Event, Feed, Location, Move, ToolCall, Units};

/// Feeds below this are feeds in another unit.
const SLOWEST_FEED_MM_PER_MIN: f64 = 0.1;

/// Feeds above this are feeds per minute with another label: even a large face mill stays below a fifth of it.
const LARGEST_FEED_MM_PER_REV: f64 = 100.0;

/// A kilometre: no machine goes there, and words of an NC program would overflow.
const LARGEST_COORDINATE_MM: f64 = 1e6;

/// An event whose text, if any, still lies in the statement.
#[derive(Debug, Clone, Copy)]
pub(super) enum Pending {
    Plain(Event<'static>),
    Name(Span),
    Operation(Span),
    Message(Span),
}

/// At most two events wait: a tool held back, and the one that ends the waiting.
#[derive(Debug, Default)]
pub(super) struct Queue {
    waiting: [Option<(Location, Pending)>; 2],
}

impl Queue {
    fn push(&mut self, location: Location, event: Pending) {
        let place = usize::from(self.waiting[0].is_some());
        self.waiting[place] = Some((location, event));
    }

    /// The oldest event.
    pub(super) fn pop(&mut self) -> Option<(Location, Pending)> {
        let first = self.waiting[0].take();
        self.waiting[0] = self.waiting[1].take();
        first
    }
}

/// Cutters seen, for the plausibility of the units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cutters {
    pub(super) largest_mm: f64,
    pub(super) first: Location,
}

/// Everything modal.
#[derive(Debug, Default)]
pub(super) struct Interpreter {
    given_units: Option<Units>,
    found_units: Option<(Units, Location)>,
    units_missed: bool,
    dialect: Dialect,
    axis: ModalAxis,
    rapid: bool,
    feed: Option<Feed>,
    cutter_of_next: Option<Cutter>,
    held: Option<ToolCall>,
    held_at: Location,
    last_tool: Option<ToolCall>,
    pub(super) workpiece: Workpiece,
    pub(super) motions: u64,
    pub(super) normalised: u64,
    pub(super) first_normalised: Location,
    pub(super) cutters: Option<Cutters>,
    pub(super) queue: Queue,
}

impl Interpreter {
    pub(super) fn new(given_units: Option<Units>) -> Self {
        Interpreter { given_units, ..Self::default() }
    }

    /// As found, else as given.
    pub(super) fn units(&self) -> Option<Units> {
        self.found_units.map(|(units, _)| units).or(self.given_units)
    }

    pub(super) fn units_are_only_given(&self) -> bool {
        self.found_units.is_none() && self.given_units.is_some()
    }

    pub(super) fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// The first evidence decides.
    pub(super) fn suspect(&mut self, dialect: Dialect) {
        if self.dialect == Dialect::Generic {
            self.dialect = dialect;
        }
    }

    /// Takes the record of the statement at `here`.
    pub(super) fn take(&mut self, record: &Record<'_>, here: Location) -> Result<(), Fault> {
        match *record {
            Record::Goto(point) => self.go_to(&point, here)?,
            Record::From(point) => {
                let (pose, normalised) = self.pose(&point)?;
                self.count_normalised(normalised, here);
                self.emit(here, Pending::Plain(Event::From(pose)));
            }
            Record::Rapid => self.rapid = true,
            Record::Feed { value, unit, at, unit_at } => self.feed = Some(self.feed_of(value, unit, at, unit_at)?),
            Record::ToolAxis { axis, at } => {
                let normalised = self.axis.state(axis, at)?;
                self.count_normalised(normalised, here);
            }
            Record::MultiAxis(on) => {
                if !on && self.dialect == Dialect::Creo {
                    self.axis.return_to_z();
                }
            }
            Record::Units(units) => self.take_units(units, here)?,
            Record::Frame(frame) => {
                let unit = self.units().map_or(1.0, Units::in_mm);
                self.workpiece.take(Frame::new(&frame, unit, here)?, frame.at)?;
            }
            Record::ToolPath(name) => {
                self.axis.begin_operation();
                // A cutter that found no tool belongs to the operation that ends here.
                self.cutter_of_next = None;
                self.emit(here, Pending::Operation(name.at));
            }
            Record::Tool(tool) => self.call_tool(&tool, here)?,
            Record::Cutter(cutter) if self.dialect != Dialect::Creo => {
                self.cutter_of_next = Some(self.in_millimetres(cutter, here)?);
            }
            Record::Cutter(cutter) | Record::CutterOfLastTool(cutter) => {
                let cutter = self.in_millimetres(cutter, here)?;
                if let Some(held) = &mut self.held {
                    held.diameter = Some(cutter.diameter);
                    held.corner_radius = cutter.corner_radius;
                }
            }
            Record::Preselect(number) => self.emit(here, Pending::Plain(Event::Preselect(number))),
            Record::Spindle(spindle) => self.emit(here, Pending::Plain(Event::Spindle(spindle))),
            Record::Coolant(coolant) => self.emit(here, Pending::Plain(Event::Coolant(coolant))),
            Record::OptionalStop => self.emit(here, Pending::Plain(Event::OptionalStop)),
            Record::Stop => self.emit(here, Pending::Plain(Event::Stop)),
            Record::PartName(text) => self.emit(here, Pending::Name(text.at)),
            Record::Message(text) => self.emit(here, Pending::Message(text.at)),
            Record::Inert => {}
        }
        Ok(())
    }

    /// GOTO.
    pub(super) fn go_to(&mut self, point: &Point, here: Location) -> Result<(), Fault> {
        let (pose, normalised) = self.pose(point)?;
        self.count_normalised(normalised, here);
        self.motions += 1;
        let rapid = std::mem::take(&mut self.rapid);
        self.emit(here, Pending::Plain(Event::Move(Move { pose, rapid, feed: self.feed })));
        Ok(())
    }

    /// Lets go of a tool that is still held back.
    pub(super) fn finish(&mut self) {
        if let Some(tool) = self.held.take() {
            self.last_tool = Some(tool);
            self.queue.push(self.held_at, Pending::Plain(Event::Tool(tool)));
        }
    }

    fn emit(&mut self, here: Location, event: Pending) {
        if self.held.is_some() {
            self.finish();
        }
        self.queue.push(here, event);
    }

    fn pose(&mut self, point: &Point) -> Result<(Pose, bool), Fault> {
        let unit = self.millimetres(point.at)?;
        let [x, y, z] = point.tip.map(|value| value * unit);
        if [x, y, z].iter().any(|value| value.abs() > LARGEST_COORDINATE_MM) {
            return Err(Fault::new(
                "coordinate",
                point.at,
                "a coordinate is more than a kilometre from the origin",
                "check the point in the CAM system, and the unit of the file",
            ));
        }
        let (axis, normalised) = self.axis.at_point(point.axis, point.at)?;
        Ok((Pose { tip: Point3::new(x, y, z), axis }, normalised))
    }

    fn count_normalised(&mut self, normalised: bool, here: Location) {
        if normalised {
            if self.normalised == 0 {
                self.first_normalised = here;
            }
            self.normalised += 1;
        }
    }

    /// Millimetres in one unit of the file, for the number at `at`. Missing units are reported once.
    fn millimetres(&mut self, at: Span) -> Result<f64, Fault> {
        match self.units() {
            Some(units) => Ok(units.in_mm()),
            None if self.units_missed => Ok(1.0),
            None => {
                self.units_missed = true;
                Err(Fault::new(
                    "units",
                    at,
                    "the file does not say its unit: no UNITS/MM, UNITS/INCH or UNIT/.. stands before this number",
                    "give `--units mm` or `--units in`, as the part is modelled",
                ))
            }
        }
    }

    fn take_units(&mut self, units: Units, here: Location) -> Result<(), Fault> {
        if let Some((before, line)) = self.found_units {
            if before != units {
                return Err(Fault::new(
                    "units",
                    Span::WHOLE,
                    format!("the unit changes in the middle of the file; line {} says another one", line.line),
                    "write the whole file in one unit",
                ));
            }
            return Ok(());
        }
        self.found_units = Some((units, here));
        if self.given_units.is_some_and(|given| given != units) {
            return Err(Fault::new(
                "units",
                Span::WHOLE,
                "the file says another unit than `--units`",
                "leave `--units` out if the file is right",
            ));
        }
        Ok(())
    }

    fn feed_of(&mut self, value: f64, unit: FeedUnit, at: Span, unit_at: Span) -> Result<Feed, Fault> {
        let of_file = self.millimetres(at)?;
        let in_millimetres = matches!(unit, FeedUnit::MillimetresPerMinute | FeedUnit::MillimetresPerRevolution);
        if in_millimetres && self.units() == Some(Units::Inches) {
            return Err(Fault::new(
                "feed unit",
                unit_at,
                "a feed in mm stands in a file in inch; such labels are often wrong",
                "have the CAM system write IPM or IPR, or leave the unit of the feed out",
            ));
        }
        let inch = Units::Inches.in_mm();
        let feed = match unit {
            FeedUnit::PerMinute => Feed::PerMinute(value * of_file),
            FeedUnit::PerRevolution => Feed::PerRevolution(value * of_file),
            FeedUnit::MillimetresPerMinute => Feed::PerMinute(value),
            FeedUnit::MillimetresPerRevolution => Feed::PerRevolution(value),
            FeedUnit::InchesPerMinute => Feed::PerMinute(value * inch),
            FeedUnit::InchesPerRevolution => Feed::PerRevolution(value * inch),
        };
        match feed {
            _ if value <= 0.0 => Err(Fault::new(
                "feed",
                at,
                format!("the feed {value} is not above 0"),
                "set a feed for every cutting move in the CAM system",
            )),
            Feed::PerMinute(speed) if speed < SLOWEST_FEED_MM_PER_MIN => Err(Fault::new(
                "feed",
                at,
                format!("a feed of {speed:.4} mm/min is not plausible"),
                "check the unit of the file and of the feed",
            )),
            Feed::PerRevolution(feed) if feed > LARGEST_FEED_MM_PER_REV => Err(Fault::new(
                "feed",
                at,
                format!("a feed of {feed} mm per revolution is not plausible"),
                "check the unit of the feed: IPM, MMPM and PERMIN count per minute",
            )),
            _ if !value.is_finite() || value > LARGEST_COORDINATE_MM => {
                Err(Fault::new("feed", at, format!("the feed {value} is not plausible"), "check the exponent"))
            }
            feed => Ok(feed),
        }
    }

    fn in_millimetres(&mut self, cutter: Cutter, here: Location) -> Result<Cutter, Fault> {
        let unit = self.millimetres(Span::WHOLE)?;
        let diameter = cutter.diameter * unit;
        let corner_radius = cutter.corner_radius.map(|radius| radius * unit);
        if diameter > 0.0 {
            let cutters = self.cutters.get_or_insert(Cutters { largest_mm: 0.0, first: here });
            cutters.largest_mm = cutters.largest_mm.max(diameter);
        }
        Ok(Cutter { diameter, corner_radius })
    }

    fn call_tool(&mut self, tool: &Tool, here: Location) -> Result<(), Fault> {
        let length = match tool.length {
            Some(length) => Some(length * self.millimetres(Span::WHOLE)?),
            None => None,
        };
        self.finish();
        self.axis.begin_operation();
        let mut call = ToolCall { number: tool.number, length, offset: tool.offset, ..ToolCall::default() };
        if let Some(cutter) = self.cutter_of_next.take() {
            call.diameter = Some(cutter.diameter);
            call.corner_radius = cutter.corner_radius;
        } else if let Some(same) = self.last_tool.filter(|last| last.number == tool.number) {
            // CATIA calls a tool again for each operation and describes it once.
            (call.diameter, call.corner_radius) = (same.diameter, same.corner_radius);
        }
        self.held = Some(call);
        self.held_at = here;
        Ok(())
    }
}
