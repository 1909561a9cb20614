//! State of the machine and of the file: units, feeds, tools, waits, planes, and text for the control.

use super::fault::{Fault, Span};
use super::interpret::{Cutters, Interpreter, Meant};
use super::options::{FeedLabel, Insert};
use super::record::{Cutter, FeedUnit, Text, Tool};
use super::vector::{self, near};
use crate::nalgebra::{Point3, UnitVector3, Vector3};
use crate::program::{Dwell, Event, Feed, Location, Plane, ToolCall, Units};

/// Feeds below this are feeds in another unit.
const SLOWEST_FEED_MM_PER_MIN: f64 = 0.1;

/// Feeds above this are feeds per minute with another label: even a large face mill stays below a fifth of it.
const LARGEST_FEED_MM_PER_REV: f64 = 100.0;

/// Feeds above this have a wrong exponent.
const LARGEST_FEED: f64 = 1e6;

/// Cutters whose diameters differ by less are the same, mm.
const SAME_DIAMETER_MM: f64 = 1e-3;

/// Nobody waits longer on purpose, seconds.
const LONG_DELAY: f64 = 10.0;

impl Interpreter {
    /// Millimetres in one unit of the file, for the number at `at`. Missing units are reported once.
    pub(super) fn millimetres(&mut self, at: Span) -> Result<f64, Fault> {
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

    pub(super) fn take_units(&mut self, units: Units, here: Location) -> Result<(), Fault> {
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
        if self.units().is_none() {
            self.workpiece.scale(units.in_mm());
        }
        self.found_units = Some((units, here));
        if self.options.units.is_some_and(|given| given != units) {
            return Err(Fault::new(
                "units",
                Span::WHOLE,
                "the file says another unit than `--units`",
                "leave `--units` out if the file is right",
            ));
        }
        Ok(())
    }

    pub(super) fn feed_of(&mut self, value: f64, unit: FeedUnit, at: Span, unit_at: Span) -> Result<Feed, Fault> {
        let of_file = self.millimetres(at)?;
        let in_millimetres = matches!(unit, FeedUnit::MillimetresPerMinute | FeedUnit::MillimetresPerRevolution);
        let doubtful = in_millimetres && self.units() == Some(Units::Inches);
        let label = if doubtful { self.options.feed_label } else { FeedLabel::Trust };
        if label == FeedLabel::Refuse {
            return Err(Fault::new(
                "feed unit",
                unit_at,
                "a feed in mm stands in a file in inch; such labels are often wrong",
                "have the CAM system write IPM or IPR, or say what it is: `[cl] feed_label = \"trust\"` or \"file-units\"",
            ));
        }
        let millimetre = if label == FeedLabel::FileUnits { of_file } else { 1.0 };
        let inch = Units::Inches.in_mm();
        let feed = match unit {
            FeedUnit::PerMinute => Feed::PerMinute(value * of_file),
            FeedUnit::PerRevolution => Feed::PerRevolution(value * of_file),
            FeedUnit::MillimetresPerMinute => Feed::PerMinute(value * millimetre),
            FeedUnit::MillimetresPerRevolution => Feed::PerRevolution(value * millimetre),
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
            _ if !value.is_finite() || value > LARGEST_FEED => {
                Err(Fault::new("feed", at, format!("the feed {value:e} is not plausible"), "check the exponent"))
            }
            feed => Ok(feed),
        }
    }

    pub(super) fn in_millimetres(&mut self, cutter: Cutter, here: Location) -> Result<Cutter, Fault> {
        let unit = self.millimetres(Span::WHOLE)?;
        let diameter = cutter.diameter * unit;
        let corner_radius = cutter.corner_radius.map(|radius| radius * unit);
        if diameter > 0.0 {
            let cutters = self.cutters.get_or_insert(Cutters { largest_mm: 0.0, first: here });
            cutters.largest_mm = cutters.largest_mm.max(diameter);
        }
        Ok(Cutter { diameter, corner_radius })
    }

    /// A motion with a cutter that no tool record has called: another one needs a call.
    pub(super) fn compare_cutter(&mut self, at: Span) {
        if !std::mem::take(&mut self.cutter_is_new) {
            return;
        }
        let Some(cutter) = self.cutter_of_next else { return };
        let called = self.held.or(self.last_tool).and_then(|tool| tool.diameter);
        let before = self.uncalled_cutter.replace(cutter).map(|cutter| cutter.diameter).or(called);
        if let Some(before) = before
            && (before - cutter.diameter).abs() > SAME_DIAMETER_MM
        {
            let text = format!(
                "the cutter changes from {before:.3} mm to {:.3} mm, and no tool record calls it",
                cutter.diameter
            );
            let help = "the tool in the spindle goes on: give LOADTL or LOAD/TOOL in front of this motion";
            self.warnings.push(Fault::new("cutter without call", at, text, help).warning());
        }
    }

    pub(super) fn begin_operation(&mut self) {
        self.axis.begin_operation();
        self.setup = None;
        // Levels of one tool are not those of another.
        (self.cycle.definition, self.cycle.initial) = (None, None);
        // Rapids and lines of another operation say nothing about an arc.
        self.line_from = None;
        self.votes.settle(None);
    }

    pub(super) fn call_tool(&mut self, tool: &Tool, here: Location) -> Result<(), Fault> {
        let length = match tool.length {
            Some(length) => Some(length * self.millimetres(Span::WHOLE)?),
            None => None,
        };
        self.let_go();
        self.begin_operation();
        (self.cutter_is_new, self.uncalled_cutter) = (false, None);
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

    /// SET/OFSETL.
    pub(super) fn take_length_offset(&mut self, register: u32, at: Span) -> Result<(), Fault> {
        let fault = |text: &str, help: &str| Err(Fault::new("length offset", at, text, help));
        if register == 0 {
            return fault("length offset 0 would switch the length offset off", "give a register above 0");
        }
        match &mut self.held {
            Some(tool) if tool.offset.is_none_or(|offset| offset == register) => {
                tool.offset = Some(register);
                Ok(())
            }
            Some(_) => fault("two different length offsets for one tool", "give one register"),
            None if self.last_tool.is_some_and(|tool| tool.offset.unwrap_or(tool.number) == register) => Ok(()),
            None => fault(
                "the length offset changes away from the tool's call",
                "give it behind LOADTL or LOAD/TOOL: a change in the cut would move the tool",
            ),
        }
    }

    pub(super) fn delay(&mut self, dwell: Dwell, at: Span, here: Location) {
        if let Dwell::Seconds(seconds) = dwell
            && seconds > LONG_DELAY
        {
            self.warnings.push(
                Fault::new(
                    "long wait",
                    at,
                    format!("a wait of {seconds} seconds"),
                    "DELAY counts seconds: check whether turns or milliseconds were meant",
                )
                .warning(),
            );
        }
        self.emit(here, Event::Delay(dwell));
    }

    pub(super) fn take_tolerance(&mut self, value: Option<f64>, at: Span, here: Location) -> Result<(), Fault> {
        let unit = self.millimetres(at)?;
        if value.is_some_and(|value| value <= 0.0) {
            return Err(Fault::new("LINTOL", at, "a tolerance is above 0", "LINTOL/OFF takes it back"));
        }
        self.emit(here, Event::Tolerance(value.map(|value| value * unit)));
        Ok(())
    }

    pub(super) fn take_clearance(
        &mut self,
        normal: [f64; 3],
        distance: f64,
        at: Span,
        here: Location,
    ) -> Result<(), Fault> {
        let unit = self.millimetres(at)?;
        let length = vector::length(normal);
        if length < 1e-9 {
            return Err(Fault::new("CLEARP", at, "the normal of this plane is 0, 0, 0", "write CLEARP/XYPLAN,z"));
        }
        let normal = normal.map(|value| value / length);
        let distance = distance * unit / length;
        let point = near(self.changes.point(Point3::from(normal.map(|value| value * distance))), at)?;
        let normal = self.changes.direction(UnitVector3::new_normalize(Vector3::from(normal)));
        let plane = Plane { normal, distance: point.coords.dot(&normal) };
        self.clearance = Some(plane);
        self.emit(here, Event::ClearancePlane(plane));
        Ok(())
    }

    pub(super) fn insert(&mut self, text: Text<'_>, here: Location) -> Result<(), Fault> {
        let stop = text.bytes.len() >= 4
            && text.bytes[..4].eq_ignore_ascii_case(b"STOP")
            && text.bytes.get(4).is_none_or(|byte| !byte.is_ascii_alphanumeric());
        if stop && self.options.insert_stop {
            self.emit(here, Event::Stop);
            self.emit_text(here, Meant::Message, text);
            return Ok(());
        }
        if stop && self.options.insert != Insert::Refuse {
            return Err(Fault::new(
                "INSERT",
                text.at,
                "INSERT/STOP may be a stop that is needed",
                "`[cl] insert_stop = true` makes it STOP",
            ));
        }
        match self.options.insert {
            Insert::Comment => self.emit_text(here, Meant::Message, text),
            Insert::Write => {
                self.here = None;
                self.line_from = None;
                self.emit_text(here, Meant::Insert, text);
            }
            Insert::Refuse => {
                return Err(Fault::new(
                    "INSERT",
                    text.at,
                    "INSERT is refused: it writes NC text that the postprocessor cannot see into",
                    "`--insert comment` writes it as a comment, `--allow-insert` as it stands",
                ));
            }
        }
        Ok(())
    }

    pub(super) fn code(&mut self, letter: u8, number: u32, at: Span, here: Location) -> Result<(), Fault> {
        let (word, key, allowed) = match letter {
            b'M' => ("AUXFUN", "auxfun", &self.options.auxfun),
            _ => ("PREFUN", "prefun", &self.options.prefun),
        };
        if !allowed.contains(&number) {
            return Err(Fault::new(
                word,
                at,
                format!(
                    "{word} is refused: it writes {}{number}, which the postprocessor cannot see into",
                    char::from(letter)
                ),
                format!("if the control is to have it, allow it: `[cl] {key} = [{number}]`"),
            ));
        }
        self.here = None;
        self.line_from = None;
        self.emit(here, Event::Code { letter, number });
        Ok(())
    }
}
