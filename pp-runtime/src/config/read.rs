//! A configuration file (TOML) to [`Config`]: every key has its line here, every fault is reported at once.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use toml::de::DeTable;

use crate::cl::ClPoint;
use crate::control::template::OF_PROGRAM;
use crate::diag::Diagnostic;
use crate::kinematics::{AxisKind, Machine};
use crate::program::{Coolant, Rotation};

use super::axes::{along, read_axes, read_dimensions, read_grid, read_limits, read_machine_zero, show_limits};
use super::cl::CL_POINTS;
use super::clearance;
use super::control::{templates, work_offset};
use super::set_up;
use super::value::{Bound, Quantity, Reader, Section, Shape, Value};
use super::{Config, GivenTool, Rapid, Rewind, Transition, Units, Wrap};

const UNITS: [(&str, Units); 2] = [("mm", Units::Millimetres), ("in", Units::Inches)];
const ROTATIONS: [(&str, Rotation); 2] = [("CLW", Rotation::Clockwise), ("CCLW", Rotation::CounterClockwise)];
const COOLANTS: [(&str, Coolant); 4] =
    [("flood", Coolant::Flood), ("mist", Coolant::Mist), ("through", Coolant::Through), ("air", Coolant::Air)];
const TRANSITIONS: [(&str, Transition); 2] = [("safe", Transition::Safe), ("direct", Transition::Direct)];
const WRAPS: [(&str, Option<Wrap>); 4] =
    [("none", None), ("0..360", Some(Wrap::Positive)), ("+-180", Some(Wrap::Symmetric)), ("sign", Some(Wrap::Sign))];
const REWINDS: [(&str, Rewind); 2] = [("leave", Rewind::Leave), ("follow", Rewind::Follow)];
const RAPIDS: [(&str, Rapid); 3] = [("direct", Rapid::Direct), ("split", Rapid::Split), ("feed", Rapid::Feed)];
pub(super) const WORK_OFFSETS: [&str; 9] = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/// Smallest path tolerance, mm: in inches it is still no zero with six decimals.
const SMALLEST_PATH_TOLERANCE: f64 = 0.0001;

/// Tolerances of chords, mm: finer is beyond the words, wider is no path any more.
pub(crate) const TOLERANCE: RangeInclusive<f64> = 0.0001..=1.0;

/// Tolerances of the tool axis, degrees: finer is beyond the words, wider is no direction any more.
pub(crate) const AXIS_TOLERANCE: RangeInclusive<f64> = 0.001..=10.0;

/// A dwell at the spindle, seconds: what three decimals hold, and what nobody waits for.
const DWELL: RangeInclusive<f64> = 0.001..=600.0;

/// `[x, y, z]`.
const POINT: &str = r#"{ "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 }"#;

/// Largest number of a tool or of its offset register.
const LARGEST_TOOL: u32 = 99_999;

impl Config {
    /// Reads a configuration file for the machine `M`.
    ///
    /// # Errors
    /// Every fault of the file, in its order.
    pub fn read<M: Machine>(text: &str) -> Result<Self, Vec<Diagnostic>> {
        Self::default().read_over::<M>(text)
    }

    /// Reads a configuration file for the machine `M` on top of what is in here, the defaults of a control.
    ///
    /// # Errors
    /// Every fault of the file, in its order.
    pub fn read_over<M: Machine>(mut self, text: &str) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader::new(text);
        let (root, errors) = DeTable::parse_recoverable(text);
        for error in &errors {
            reader.fault(error.span().unwrap_or(0..0), error.message(), None);
        }
        if reader.has_faults() {
            return Err(reader.into_faults());
        }
        self.read_root::<M>(&mut reader, root.get_ref());
        if reader.has_faults() { Err(reader.into_faults()) } else { Ok(self) }
    }

    pub(super) fn read_root<M: Machine>(&mut self, r: &mut Reader<'_>, root: &DeTable<'_>) {
        let mut top = Section::new("", root);
        // The file's unit first: it decides what every length below means.
        let units = self.get(&mut top, "units");
        let named = units.and_then(|value| r.choice(value, &UNITS));
        set(&mut r.units, named);
        self.read_top(r, &mut top);
        let sections = [
            "defaults",
            "course",
            "retract",
            "approach",
            "arcs",
            "cycles",
            "compensation",
            "feed",
            "formats",
            "program",
            "control",
            "cl",
            "stock",
        ]
        .map(|name| (name, top.get(name)));
        let tools = top.get("tools");
        let frames = top.get("frames");
        let machine_zero = top.get("machine_zero");
        let park = top.get("park");
        let dimensions = top.get("dimensions");
        let limits = top.get("limits");
        let speeds = top.get("speeds");
        let grid = top.get("grid");
        let rotary_offset = top.get("rotary_offset");
        let clamp = top.get("clamp");
        let wrap = top.get("wrap");
        r.remember_top(&top);

        for (name, value) in sections {
            let mut section = Section::of(r, name, value);
            match name {
                "defaults" => self.read_defaults(r, &mut section),
                "retract" => self.read_retract(r, &mut section),
                "approach" => {
                    let distance = self.get(&mut section, "approach.distance");
                    set(
                        &mut self.motion.approach.distance,
                        distance.and_then(|value| r.length(value, Bound::Positive)),
                    );
                }
                "arcs" => self.read_arcs(r, &mut section),
                "cycles" => self.read_cycles(r, &mut section),
                "compensation" => self.read_compensation(r, &mut section),
                "feed" => self.read_feed(r, &mut section),
                "formats" => self.read_formats(r, &mut section),
                "control" => self.read_control::<M>(r, &mut section),
                "cl" => self.read_cl(r, &mut section),
                "course" => self.read_course::<M>(r, &mut section),
                "stock" => self.set_up.stock = set_up::stock(r, &mut section, value),
                _ => self.read_program(r, &mut section),
            }
            section.finish(r);
        }
        self.read_tools(r, tools);
        self.read_frames(r, frames);
        self.set_up.machine_zero = read_machine_zero::<M>(r, machine_zero);
        self.set_up.limits = read_limits::<M>(r, limits);
        self.motion.rotaries.grid = read_grid::<M>(r, grid);
        self.motion.rotaries.clamp = set_up::clamps::<M>(r, clamp);
        self.set_up.rotary_offset = set_up::rotary_offset::<M>(r, rotary_offset);
        self.read_wrap::<M>(r, wrap);
        self.set_up.speeds = read_axes::<M>(r, speeds)
            .into_iter()
            .filter_map(|(axis, value, _)| Some((axis.letter, along(r, axis, value, Bound::Positive)?)))
            .collect();
        self.motion.park = self.read_park::<M>(r, park);
        self.set_up.dimensions = read_dimensions::<M>(r, dimensions);
        top.finish(r);
        self.file_units_assumed = r.lengths && units.is_none();
        if !r.has_faults()
            && let Err(invalid) = self.set_up.machine::<M>()
        {
            let span = dimensions.map_or(0..0, |value| value.span());
            r.fault(span, format!("{} cannot be built like this: {invalid}", M::NAME), None);
        }
    }

    /// The value of a key, which counts as given.
    pub(super) fn get<'a>(&mut self, section: &mut Section<'a>, path: &'static str) -> Option<Value<'a>> {
        let value = section.get(path);
        if value.is_some() {
            self.given.insert(path);
        }
        value
    }

    fn read_top(&mut self, r: &mut Reader<'_>, top: &mut Section<'_>) {
        if let Some(value) = self.get(top, "cl_units") {
            self.cl_units = r.choice(value, &UNITS);
        }
        if let Some(value) = self.get(top, "output_units") {
            self.output_units = r.choice(value, &UNITS);
        }
        if let Some(value) = self.get(top, "part_origin") {
            set(&mut self.set_up.part_origin, read_point(r, value));
        }
        if let Some(value) = self.get(top, "part_rotation") {
            set(&mut self.set_up.part_rotation, set_up::part_rotation(r, value));
        }
        if let Some(value) = self.get(top, "program_zero") {
            set(&mut self.set_up.program_zero, r.choice(value, &set_up::PROGRAM_ZEROS));
        }
        if let Some(value) = self.get(top, "length_mode") {
            set(&mut self.set_up.length_mode, r.choice(value, &set_up::LENGTH_MODES));
        }
        self.read_mode(r, top);
        if let Some(value) = self.get(top, "length_guard") {
            self.motion.guards.length_guard = r.boolean(value);
        }
        if let Some(value) = self.get(top, "length_tolerance") {
            set(&mut self.motion.guards.length_tolerance, set_up::length_tolerance(r, value));
        }
        if let Some(value) = self.get(top, "work_offset") {
            set(&mut self.set_up.work_offset, work_offset(r, value));
        }
        if let Some(value) = self.get(top, "index_angle") {
            set(&mut self.motion.rapids.index_angle, r.number(value, Quantity::Angle, Bound::NotNegative));
        }
        if let Some(value) = self.get(top, "rapid") {
            set(&mut self.motion.rapids.rapid, r.choice(value, &RAPIDS));
        }
        let rapid_feed = self.get(top, "rapid_feed");
        if let Some(value) = rapid_feed {
            self.motion.rapids.rapid_feed = r.length(value, Bound::Positive);
        }
        if self.motion.rapids.rapid == Rapid::Feed && self.motion.rapids.rapid_feed.is_none() && rapid_feed.is_none() {
            r.fault(
                0..0,
                "rapid = \"feed\" needs `rapid_feed`",
                Some("give it per minute: `rapid_feed = 10000`".to_owned()),
            );
        }
        if let Some(value) = self.get(top, "transition") {
            set(&mut self.motion.rapids.transition, r.choice(value, &TRANSITIONS));
        }
        if let Some(value) = self.get(top, "reorient_speed") {
            set(&mut self.motion.rapids.reorient_speed, r.number(value, Quantity::Angle, Bound::Positive));
        }
        if let Some(value) = self.get(top, "stop_retract") {
            set(&mut self.motion.stop_retract, r.boolean(value));
        }
        if let Some(value) = self.get(top, "spindle_dwell") {
            let seconds = r.number(value, Quantity::Plain, Bound::NotNegative);
            if seconds.is_some_and(|seconds| seconds > 0.0 && !DWELL.contains(&seconds)) {
                let text = format!("a dwell of 0, or of {} to {} seconds, is needed here", DWELL.start(), DWELL.end());
                r.fault(value.span(), text, None);
            }
            set(&mut self.motion.spindle_dwell, seconds);
        }
        if let Some(value) = self.get(top, "path_tolerance") {
            let tolerance = r.length(value, Bound::Positive);
            if tolerance.is_some_and(|tolerance| tolerance < SMALLEST_PATH_TOLERANCE) {
                let text = format!(
                    "less than {SMALLEST_PATH_TOLERANCE} mm could be written as 0, which lets the control leave the \
                     path without bound"
                );
                r.fault(value.span(), text, None);
            }
            set(&mut self.control.path_tolerance, tolerance);
        }
        if let Some(value) = self.get(top, "tolerance") {
            let tolerance = r.length(value, Bound::Positive);
            if tolerance.is_some_and(|tolerance| !TOLERANCE.contains(&tolerance)) {
                let (low, high) = (TOLERANCE.start(), TOLERANCE.end());
                r.fault(value.span(), format!("a tolerance of {low} to {high} mm is needed here"), None);
            }
            set(&mut self.motion.tolerance, tolerance);
        }
        if let Some(value) = self.get(top, "axis_tolerance_path") {
            let tolerance = r.number(value, Quantity::Angle, Bound::Positive);
            if tolerance.is_some_and(|tolerance| !within(&AXIS_TOLERANCE, tolerance.to_degrees())) {
                let (low, high) = (AXIS_TOLERANCE.start(), AXIS_TOLERANCE.end());
                r.fault(value.span(), format!("a tolerance of {low} to {high} degrees is needed here"), None);
            }
            set(&mut self.motion.axis_tolerance_path, tolerance);
        }
        if let Some(value) = self.get(top, "cl_point") {
            set(&mut self.cl.cl_point, r.choice(value, &CL_POINTS));
        }
        if let Some(value) = self.get(top, "spindle_max") {
            self.motion.guards.spindle_max = r.number(value, Quantity::Plain, Bound::Positive);
        }
        if let Some(value) = self.get(top, "floor") {
            self.motion.guards.floor = r.length(value, Bound::Any);
        }
        if let Some(value) = self.get(top, "table_check") {
            set(&mut self.motion.guards.table_check, r.boolean(value));
        }
    }

    fn read_defaults(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "defaults.speed") {
            self.motion.defaults.speed = r.number(value, Quantity::Plain, Bound::Positive);
        }
        if let Some(value) = self.get(section, "defaults.direction") {
            self.motion.defaults.rotation = r.choice(value, &ROTATIONS);
        }
        if let Some(value) = self.get(section, "defaults.tool") {
            self.motion.defaults.tool = r.whole(value, 1..=LARGEST_TOOL);
        }
        if let Some(value) = self.get(section, "defaults.peck_gap") {
            set(&mut self.motion.defaults.peck_gap, r.length(value, Bound::Positive));
        }
        if let Some(value) = self.get(section, "defaults.coolant") {
            set(&mut self.motion.defaults.coolant, r.choice(value, &COOLANTS));
        }
    }

    fn read_retract(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "retract.position") {
            self.motion.retract.position = r.length(value, Bound::Any);
        }
        if let Some(value) = self.get(section, "retract.distance") {
            self.motion.retract.distance = r.length(value, Bound::Positive);
        }
        if let Some(value) = self.get(section, "retract.clearance") {
            self.motion.retract.clearance = clearance::read(r, value);
        }
        if let Some(value) = self.get(section, "retract.rewind") {
            set(&mut self.motion.retract.rewind, r.choice(value, &REWINDS));
        }
        if let Some(value) = self.get(section, "retract.rewind_dry") {
            set(&mut self.motion.retract.rewind_dry, r.boolean(value));
        }
    }

    fn read_wrap<M: Machine>(&mut self, r: &mut Reader<'_>, value: Option<Value<'_>>) {
        let limits = self.set_up.travel::<M>().limits;
        for (axis, value, span) in read_axes::<M>(r, value) {
            let index = M::AXES.iter().position(|known| known.letter == axis.letter);
            let Some(wrap) = r.choice(value, &WRAPS) else { continue };
            if axis.kind != AxisKind::Rotary || axis.held || index.is_some_and(|index| limits[index].is_some()) {
                let text = format!("{} is no endless rotary axis: it cannot roll over", axis.letter);
                r.fault(span, text, Some(format!("`[limits] {} = \"free\"` if it is endless", axis.letter)));
                continue;
            }
            self.motion.rotaries.wrap.extend(wrap.map(|wrap| (axis.letter, wrap)));
        }
    }

    fn read_feed(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "feed.keep_speeds") {
            set(&mut self.motion.feed.keep_speeds, r.boolean(value));
        }
        if let Some(value) = self.get(section, "feed.largest") {
            self.motion.feed.largest = r.length(value, Bound::Positive);
        }
        if let Some(value) = self.get(section, "feed.shortest_block") {
            set(&mut self.motion.feed.shortest_block, r.number(value, Quantity::Plain, Bound::NotNegative));
        }
    }

    fn read_formats(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        let formats = &mut self.formats;
        for (path, digits, range) in [
            ("formats.linear_mm", &mut formats.linear_mm, 0..=6),
            ("formats.linear_inch", &mut formats.linear_inch, 0..=6),
            ("formats.rotary", &mut formats.rotary, 0..=6),
            ("formats.feed", &mut formats.feed, 0..=6),
            ("formats.inverse_time", &mut formats.inverse_time, 6..=12),
            ("formats.speed", &mut formats.speed, 0..=3),
            ("formats.linear_whole", &mut formats.linear_whole, 1..=9),
            ("formats.rotary_whole", &mut formats.rotary_whole, 1..=9),
            ("formats.feed_whole", &mut formats.feed_whole, 1..=15),
            ("formats.speed_whole", &mut formats.speed_whole, 1..=9),
        ] {
            if let Some(value) = section.get(path) {
                self.given.insert(path);
                set(digits, r.whole(value, range));
            }
        }
    }

    fn read_program(&mut self, r: &mut Reader<'_>, section: &mut Section<'_>) {
        if let Some(value) = self.get(section, "program.start") {
            self.control.program.start = templates(r, value, OF_PROGRAM);
        }
        if let Some(value) = self.get(section, "program.end") {
            self.control.program.end = templates(r, value, OF_PROGRAM);
        }
        if let Some(value) = self.get(section, "program.times") {
            set(&mut self.control.program.times, r.boolean(value));
        }
        if let Some(value) = self.get(section, "program.checked") {
            set(&mut self.control.program.checked, r.boolean(value));
        }
        if let Some(value) = self.get(section, "program.line_numbers") {
            self.control.program.line_numbers = r.whole(value, 1..=1000);
        }
    }

    fn read_tools(&mut self, r: &mut Reader<'_>, tools: Option<Value<'_>>) {
        if let Some(tools) = tools {
            r.note(tools, || Shape::Numbered);
        }
        for (key, span, value) in tools.map_or_else(Vec::new, |tools| r.entries(tools)) {
            // Leading zeros would let one tool stand in two tables.
            let number = key.parse().ok().filter(|number: &u32| number.to_string() == key);
            let Some(number) = number.filter(|number| (1..=LARGEST_TOOL).contains(number)) else {
                let help = format!("tools are tables with a number from 1 to {LARGEST_TOOL}: [tools.12]");
                r.fault(span, format!("`{key}` is not the number of a tool"), Some(help));
                continue;
            };
            let (tool, cl_point) = read_tool(r, number, value);
            self.set_up.tools.insert(number, tool);
            self.cl.cl_point_of.extend(cl_point.map(|point| (number, point)));
        }
    }

    fn read_park<M: Machine>(&self, r: &mut Reader<'_>, park: Option<Value<'_>>) -> BTreeMap<char, f64> {
        let mut read = BTreeMap::new();
        for (axis, value, _) in read_axes::<M>(r, park) {
            let Some(position) = along(r, axis, value, Bound::Any) else { continue };
            let limits = self.set_up.limits.get(&axis.letter).copied().unwrap_or(axis.limits);
            // Angles come from degrees: a limit itself must pass.
            let slack = 1e-9;
            if let Some(limits) = limits
                && !(limits.lower - slack..=limits.upper + slack).contains(&position)
            {
                let travel = show_limits(axis, limits, r.units);
                let text = format!("{} cannot stand there: its travel is {travel}", axis.letter);
                r.fault(value.span(), text, None);
            }
            read.insert(axis.letter, position);
        }
        read
    }
}

fn read_tool(r: &mut Reader<'_>, number: u32, value: Value<'_>) -> (GivenTool, Option<ClPoint>) {
    let mut section = Section::of(r, format!("tools.{number}"), Some(value));
    let mut tool = GivenTool::default();
    if let Some(value) = section.get("length") {
        tool.length = r.length(value, Bound::NotNegative);
    }
    if let Some(value) = section.get("diameter") {
        tool.diameter = r.length(value, Bound::Positive);
    }
    if let Some(value) = section.get("offset") {
        tool.offset = r.whole(value, 1..=LARGEST_TOOL);
    }
    if let Some(value) = section.get("radius_offset") {
        tool.radius_offset = r.whole(value, 1..=LARGEST_TOOL);
    }
    if let Some(value) = section.get("speed") {
        tool.speed = r.number(value, Quantity::Plain, Bound::Positive);
    }
    if let Some(value) = section.get("direction") {
        tool.rotation = r.choice(value, &ROTATIONS);
    }
    if let Some(value) = section.get("left_handed") {
        set(&mut tool.left_handed, r.boolean(value));
    }
    if let Some(value) = section.get("coolant") {
        tool.coolant = r.choice(value, &COOLANTS);
    }
    if let Some(value) = section.get("name") {
        tool.name = r.line(value);
    }
    let cl_point = section.get("cl_point").and_then(|value| r.choice(value, &CL_POINTS));
    section.finish(r);
    (tool, cl_point)
}

pub(super) fn read_point(r: &mut Reader<'_>, value: Value<'_>) -> Option<[f64; 3]> {
    r.note(value, || Shape::Schema(POINT));
    let numbers = r.list(value)?;
    let &[x, y, z] = numbers.as_slice() else {
        let text = format!("three numbers [x, y, z] are needed here, found {}", numbers.len());
        r.fault(value.span(), text, None);
        return None;
    };
    // All three are looked at before giving up, so that each fault is reported.
    let [x, y, z] = [x, y, z].map(|number| r.length(number, Bound::Any));
    Some([x?, y?, z?])
}

/// Replaces a default only by a value that could be read.
pub(super) fn set<T>(slot: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *slot = value;
    }
}

/// Inside a range whose ends are degrees that have been radians in between.
fn within(range: &RangeInclusive<f64>, degrees: f64) -> bool {
    (range.start() * (1.0 - 1e-12)..=range.end() * (1.0 + 1e-12)).contains(&degrees)
}
