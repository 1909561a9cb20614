//! Set-up of a job: position of the part, zero points, tools, and dimensions of the machine that differ from its
//! declaration.
//!
//! Data in mm, rad and mm/min that several stages read, and the table of its keys. Nothing is planned or written here.
//! An option that only one stage reads belongs to that stage.
//!
//! ```
//! use pp_runtime::config::Config;
//! use pp_runtime::control::LinuxCnc;
//! use pp_runtime::set_up::GivenTool;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let mut config = Config::default();
//! config.set_up.part_origin = [0.0, 0.0, 40.0];
//! config.set_up.tools.insert(3, GivenTool { length_mm: Some(148.32), ..GivenTool::default() });
//! // The same from a file.
//! let file = "part_origin = [0, 0, 40]\n[tools.3]\nlength = 148.32\n";
//! let read = Config::read::<Trunnion>(file, &LinuxCnc).expect("a configuration");
//! assert_eq!(read.set_up, config.set_up);
//! ```

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod keys;
mod machine;
mod part_rotation;
mod solids;

use std::collections::BTreeMap;

use nalgebra::{Rotation3, Vector3};

use crate::keys::{Blocks, Bound, LengthPoint, ListOf, Measure, OneLine, OneOf, Whole, YesNo, options};
use crate::kinematics::{AnyMachine, Limits};
use crate::program::{Coolants, Rotation, ToolCall};

pub(crate) use keys::CoolantKinds;
use keys::{
    BlankCorners, DimensionTable, LIMITS, MACHINE_ZERO, OffsetWord, ROTARY_OFFSET, SPEEDS, START_POSITION, SetUpTable,
    TABLE_ZERO, ToolsByNumber,
};
use part_rotation::PartRotation;
use solids::SolidTable;

pub(crate) use machine::{AxisBounds, along_axes};
pub(crate) use part_rotation::angles as part_angles;
pub(crate) use solids::Solids;
#[cfg(feature = "simulate")]
pub(crate) use solids::{Solid, SolidLink, SolidShape};

/// The point of the tool that the CL data programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ClPoint {
    /// The end of the tool on its axis.
    #[default]
    Tip,
    /// The centre of the corner radius, which lies above the tip by that radius.
    Centre,
}

impl ClPoint {
    /// Names, as in configuration files.
    pub(crate) const NAMES: [(&'static str, Self); 2] = [("tip", Self::Tip), ("centre", Self::Centre)];
}

options! {
    /// Machine, part and shop of a job. Lengths in mm, angles in rad, speeds in mm/min and rad/min.
    pub struct SetUp {
        /// Position of the part zero from the reference point of the table, along X, Y and Z of the table.
        part_origin: [f64; 3] = [0.0; 3], key("part_origin", LengthPoint);
        /// Orientation of the part on the table: the CL data is rotated by `[rx, ry, rz]` degrees about X, then Y, then
        /// Z of the table, or by a matrix given in rows. `floor`, `retract.clearance` and the tips in the header refer
        /// to the part as it lies on the table.
        part_rotation: Rotation3<f64> = Rotation3::identity(), key("part_rotation", PartRotation);
        /// Offset of rotary axes: the word in the program is the axis value minus this offset; limits hold for the axis
        /// value. The other rotary entries of the work offset must be zero.
        rotary_offset: BTreeMap<char, f64> = BTreeMap::new(), key("rotary_offset", ROTARY_OFFSET);
        /// Zero point of the linear words: the "part" zero, or the reference point of the "table".
        program_zero: ProgramZero = ProgramZero::Part, key("program_zero", OneOf(&ProgramZero::NAMES));
        /// Point of the tool to which linear words refer: the "tip", with all rotary axes at zero and the length offset
        /// active, or the "gauge" line, without length offset.
        length_mode: LengthMode = LengthMode::Tip, key("length_mode", OneOf(&LengthMode::NAMES));
        /// Work offset of the control: "G54", and "G59.1" (LinuxCNC), "G54.1 P3" (Fanuc), "G154 P3" (Haas), "G505"
        /// (Siemens) or the row of the preset table, "3" (Heidenhain; G54 to G59 are rows 1 to 6). Its zero must be
        /// where the gauge line, without tool and with the rotary axes at zero, is on the zero point of `program_zero`:
        /// for the part zero the machine coordinates of `machine_zero`. Header and set-up sheet print them for each
        /// set-up where they are known. A preset of Heidenhain is set at the machine, by touching off or probing; its
        /// zero is compared with them in the display REF, and what its row holds with a rotary table differs from them.
        work_offset: String = "G54".to_owned(), key("work_offset", OffsetWord);
        /// Machine coordinate of each linear axis with the gauge line, without tool, on the part zero and the rotary
        /// axes at zero: where a tool touches the part zero, less its length along the tool. Without it linear limits
        /// are not checked. It changes with `part_origin`; `table_zero` does not.
        machine_zero: BTreeMap<char, f64> = BTreeMap::new(), key("machine_zero", MACHINE_ZERO);
        /// The same with the gauge line on the reference point of the table: a constant of the machine, from which
        /// `machine_zero` follows for any `part_origin`. Give one of the two.
        table_zero: BTreeMap<char, f64> = BTreeMap::new(), key("table_zero", TABLE_ZERO);
        /// Position of the axes when the program begins, linear axes in machine coordinates, for `simulate` and `view`.
        /// Without it the machine is nowhere until its position is programmed.
        start_position: BTreeMap<char, f64> = BTreeMap::new(), key("start_position", START_POSITION);
        /// Set-ups after the first, by number: the part is clamped again in one program. `frames` are the frames of the
        /// CL data that belong to it, counted in the order in which they are first stated, or `begins` is the name of
        /// its first operation; without both the second set-up is the second frame. Between set-ups the axes are parked
        /// and the program stops (M0).
        set_ups: BTreeMap<u32, FurtherSetUp> = BTreeMap::new(), key("set_ups", SetUpTable);
        /// The blank as it lies on the table, for the graphics of the control (BLK FORM of Heidenhain, WORKPIECE of
        /// Siemens) and for `simulate`: the corners `lower` and `upper` of a box, or `diameter`, `bottom` and `top` of
        /// a cylinder along Z about the part zero. Without it a Heidenhain program has a box around all cuts.
        stock: Option<Stock> = None, key("stock", BlankCorners);
        /// Solids for `simulate` and `view`: an STL file (`"head.stl"`), or a table with `stl`, `box` (two corners),
        /// `cylinder` (diameter, height) or `turned` (an outline of diameters and heights), with `at`, `rotate`,
        /// `name`; several in a list. Those of `table`, `fixtures` and axes of the table side are in table coordinates,
        /// from the reference point of the table, those of `spindle` and axes of the head from the gauge line, all axes
        /// at zero. Those of the `frame` do not move, and are where they are in that position: the spindle nose at the
        /// reference point of the table. An axis has what it moves without the axes after it. `stock` and `design` are
        /// in the coordinates of the CL data. Pairs of `allow` may meet; other solids must keep the `clearance`.
        solids: Solids = Solids::default(), key("solids", SolidTable);
        /// Tools by tool number. `length` is from the gauge line to the tip; `offset` and `radius_offset` are the
        /// registers of length and radius if they are not the tool number; `speed`, `direction` and `coolant` as in
        /// `[defaults]`.
        tools: BTreeMap<u32, GivenTool> = BTreeMap::new(), key("tools", ToolsByNumber);
        /// Dimensions of the machine where they differ from its declaration.
        dimensions: BTreeMap<String, f64> = BTreeMap::new(), key("dimensions", DimensionTable);
        /// Travel of the axes where it differs from the machine's declaration: `[lowest, highest]`, or "free" for an
        /// endless axis. Linear axes in machine coordinates.
        limits: BTreeMap<char, Option<Limits>> = BTreeMap::new(), key("limits", LIMITS);
        /// Largest speeds of the axes where they differ from the machine's declaration.
        speeds: BTreeMap<char, f64> = BTreeMap::new(), key("speeds", SPEEDS);
    }
}

options! {
    /// One set-up after the first.
    pub struct FurtherSetUp {
        /// Numbers of its frames.
        frames: Vec<u32> = Vec::new(), key("frames", ListOf(Whole(2..=MOST_FRAMES)));
        /// Name of its first operation.
        begins: Option<String> = None, key("begins", OneLine, "\"OP20\"");
        /// Position of the part zero, as `part_origin`.
        part_origin: [f64; 3] = [0.0; 3], key("part_origin", LengthPoint);
        /// Orientation of the part, as `part_rotation`.
        part_rotation: Rotation3<f64> = Rotation3::identity(), key("part_rotation", PartRotation);
        /// Zero of its CL data in the coordinates of the CL data of the first set-up, for `simulate`. Without it from
        /// the frames that the CL data states.
        cl_origin: Option<[f64; 3]> = None, key("cl_origin", LengthPoint, "[0.0, 0.0, -40.0]");
        /// Orientation of its CL data there, as `part_rotation`; with `cl_origin` only.
        cl_rotation: Rotation3<f64> = Rotation3::identity(), key("cl_rotation", PartRotation);
        /// Work offset, as `work_offset`; it differs from those of the other set-ups.
        work_offset: Option<String> = None, key("work_offset", OffsetWord, "\"G55\"");
    }
}

/// The part as it is clamped in one set-up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clamping<'a> {
    /// Position of the part zero from the reference point of the table, mm.
    pub(crate) part_origin: [f64; 3],
    /// Orientation of the part on the table.
    pub(crate) part_rotation: Rotation3<f64>,
    /// Work offset of the control.
    pub(crate) work_offset: &'a str,
}

impl SetUp {
    /// The part in the set-up of a number, counted from 1; `None` if there is no such set-up.
    pub(crate) fn clamping(&self, number: u32) -> Option<Clamping<'_>> {
        if number == 1 {
            let Self { part_origin, part_rotation, work_offset, .. } = self;
            return Some(Clamping { part_origin: *part_origin, part_rotation: *part_rotation, work_offset });
        }
        let FurtherSetUp { part_origin, part_rotation, work_offset, .. } = self.set_ups.get(&number)?;
        let work_offset = work_offset.as_deref().unwrap_or(&self.work_offset);
        Some(Clamping { part_origin: *part_origin, part_rotation: *part_rotation, work_offset })
    }

    /// Machine coordinates of the gauge line on the zero point of a set-up, by linear axis, mm: what its work offset
    /// must hold. Empty where neither `machine_zero` nor `table_zero` is given.
    #[must_use]
    pub fn work_offset_mm(&self, machine: &dyn AnyMachine, number: u32) -> BTreeMap<char, f64> {
        let Some(part) = self.clamping(number) else { return BTreeMap::new() };
        let zero = match self.program_zero {
            ProgramZero::Part => part.part_origin,
            ProgramZero::Table => [0.0; 3],
        };
        let moved = Vector3::from(zero) - Vector3::from(self.part_origin);
        let letters = machine.axes().iter().map(|axis| axis.letter).zip(along_axes(machine, &moved));
        letters.filter_map(|(letter, mm)| Some((letter, self.machine_zero.get(&letter)? + mm))).collect()
    }

    /// All set-ups with their numbers.
    pub(crate) fn clampings(&self) -> impl Iterator<Item = (u32, Clamping<'_>)> {
        let numbers = std::iter::once(1).chain(self.set_ups.keys().copied());
        numbers.filter_map(|number| Some((number, self.clamping(number)?)))
    }
}

options! {
    /// Data of one tool, in addition to the CL data. Every key defaults to unknown.
    pub struct GivenTool {
        /// Gauge length, from the gauge line to the tip, if the CL data gives none; another one in the CL data is an
        /// error.
        length_mm: Option<f64> = None, key("length", Measure::length(Bound::NotNegative), "148.32");
        /// Cutting diameter, if the CL data gives none; another one in the CL data is an error.
        diameter_mm: Option<f64> = None, key("diameter", Measure::length(Bound::Positive), "10.0");
        /// Diameter in the CL data that is that of the path, not of the tool: a CUTTER that is wider on purpose, to
        /// leave stock.
        path_diameter_mm: Option<f64> = None, key("path_diameter", Measure::length(Bound::Positive), "10.4");
        /// All that the CL data states about this tool number is one tool, with the sizes that are given here.
        one_tool: bool = false, key("one_tool", YesNo);
        /// Length offset register (H), if it is neither programmed in the CL data nor the tool number.
        offset: Option<u32> = None, key("offset", Whole(1..=LARGEST_TOOL), "12");
        /// Radius offset register (D), if it is neither programmed in CUTCOM nor the tool number.
        radius_offset: Option<u32> = None, key("radius_offset", Whole(1..=LARGEST_TOOL), "12");
        /// Name of the tool for header and comments; with `control.tool_names` its name in the tool table.
        name: Option<String> = None, key("name", OneLine, "\"ball 10\"");
        /// Left-hand tool: it cuts with counter-clockwise rotation.
        left_handed: bool = false, key("left_handed", YesNo);
        /// Spindle speed, rev/min, if the CL data programs none.
        speed_rev_per_min: Option<f64> = None, key("speed", Measure::plain(Bound::Positive), "8000");
        /// Sense of rotation, if the CL data programs none: CLW (M3) or CCLW (M4).
        rotation: Option<Rotation> = None, key("direction", OneOf(&ROTATIONS), "\"CLW\"");
        /// Coolant that COOLNT/ON means for this tool: one of "flood", "mist", "through", "air", "through_low",
        /// "through_medium" and "through_high", or several that are on together, `["flood", "through"]`.
        coolant: Option<Coolants> = None, key("coolant", CoolantKinds, "\"flood\"");
        /// Measure the tool after each change to it, with the blocks of `cycles.measure_tool`.
        measured: bool = false, key("measured", YesNo);
        /// Look for breakage of the tool when it has cut, with the blocks of `cycles.check_tool`.
        checked: bool = false, key("checked", YesNo);
        /// Blocks after each change to it, at the machine retract: chip conveyor, air. After them position, spindle,
        /// coolant and length are stated anew; they must leave G90, plane and work offset as they are.
        start: Vec<String> = Vec::new(), key("start", Blocks(OneLine), "[\"M31\"]");
        /// Blocks when it has cut, before the next tool and at the end of the program, at the machine retract with
        /// spindle and coolant off.
        end: Vec<String> = Vec::new(), key("end", Blocks(OneLine), "[\"M33\"]");
        /// Point of this tool that the CL data programs: "tip", or "centre" of the corner radius.
        cl_point: Option<ClPoint> = None, key("cl_point", OneOf(&ClPoint::NAMES), "\"tip\"");
        /// Shape of the cutting part, for `simulate`: "mill" (flat, bull or ball end, tapered too), "drill", "disc"
        /// (T-slot), "lollipop" or "barrel". Without it a tool that only makes holes is a drill, any other one a mill.
        shape: Option<ToolShape> = None, key("shape", OneOf(&ToolShape::NAMES), "\"mill\"");
        /// Corner radius, if the CL data gives none.
        corner_radius_mm: Option<f64> = None, key("corner_radius", Measure::length(Bound::NotNegative), "1.0");
        /// Angle of the point of a drill, between its two sides.
        point_angle_rad: Option<f64> = None, key("point_angle", Measure::angle(Bound::Positive), "118.0");
        /// Angle of the side of a mill from its axis.
        taper_rad: Option<f64> = None, key("taper", Measure::angle(Bound::Any), "3.0");
        /// Radius of the side of a barrel in its section.
        side_radius_mm: Option<f64> = None, key("side_radius", Measure::length(Bound::Positive), "85.0");
        /// Length of the cutting edges; of a disc its thickness.
        flute_length_mm: Option<f64> = None, key("flute_length", Measure::length(Bound::Positive), "25.0");
        /// Diameter of the shank, from the cutting edges up to the holder.
        shank_diameter_mm: Option<f64> = None, key("shank_diameter", Measure::length(Bound::Positive), "10.0");
        /// Holder as cylinders, from its lower end up to the gauge line: diameter and height of each, one after the
        /// other.
        holder_mm: Vec<f64> = Vec::new(), key("holder", ListOf(Measure::length(Bound::Positive)), "[32.0, 40.0, 63.0, 20.0]");
    }
}

/// Shape of the cutting part of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToolShape {
    /// Flat, bull or ball end.
    Mill,
    /// With a point.
    Drill,
    /// A disc on a neck.
    Disc,
    /// A ball on a neck.
    Lollipop,
    /// A side of a large radius.
    Barrel,
}

impl ToolShape {
    /// Names, as in configuration files.
    pub(crate) const NAMES: [(&'static str, Self); 5] = [
        ("mill", Self::Mill),
        ("drill", Self::Drill),
        ("disc", Self::Disc),
        ("lollipop", Self::Lollipop),
        ("barrel", Self::Barrel),
    ];
}

/// Largest number of a frame, and of a set-up.
pub(crate) const MOST_FRAMES: u32 = 100;

/// Senses of rotation of the spindle, by name.
pub(crate) const ROTATIONS: [(&str, Rotation); 2] =
    [("CLW", Rotation::Clockwise), ("CCLW", Rotation::CounterClockwise)];

/// Largest number of a tool or of its offset register.
pub(crate) const LARGEST_TOOL: u32 = 99_999;

/// The blank, mm, for the graphics of the control: a box, or a cylinder along Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stock {
    /// Corner of the box, or of the box around the cylinder, with the smallest X, Y and Z.
    pub lower: [f64; 3],
    /// Corner with the largest X, Y and Z.
    pub upper: [f64; 3],
    /// It is a cylinder.
    pub round: bool,
}

/// Zero point of the linear words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProgramZero {
    /// The part zero.
    Part,
    /// The table's reference point.
    Table,
}

/// Point of the tool to which linear words refer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthMode {
    /// The tool tip, with all rotary axes at zero; the length offset is active.
    Tip,
    /// The gauge line; no length offset is active.
    Gauge,
}

impl ProgramZero {
    const NAMES: [(&'static str, Self); 2] = [("part", Self::Part), ("table", Self::Table)];
}

impl LengthMode {
    const NAMES: [(&'static str, Self); 2] = [("tip", Self::Tip), ("gauge", Self::Gauge)];
}

impl GivenTool {
    /// Diameter and corner radius of a tool, mm: those of the CL data, else those of its entry.
    pub(crate) fn size_mm(given: Option<&Self>, call: &ToolCall) -> [Option<f64>; 2] {
        let of_entry = |size: fn(&Self) -> Option<f64>| given.and_then(size);
        [
            call.diameter_mm.or(of_entry(|given| given.diameter_mm)),
            call.corner_radius_mm.or(of_entry(|given| given.corner_radius_mm)),
        ]
    }
}
