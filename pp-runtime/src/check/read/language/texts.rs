//! What codes and words mean, in words of the shop: the texts of the printed table.

use super::super::block::{FeedMode, SideOfPath, settled};
use super::super::orders::{Code, LengthCode, Pattern};
use super::{Address, Means, PathCode, Plane, StatementWord};
use crate::program::{Rotation, Units};

impl Means {
    /// What it is, in words of the shop.
    pub(super) fn text(self) -> &'static str {
        match self {
            Self::Motion(Code::Rapid) => "rapid",
            Self::Motion(Code::Feed) => "straight motion at feed",
            Self::Motion(Code::Clockwise) => "arc or helix, clockwise",
            Self::Motion(Code::CounterClockwise) => "arc or helix, counter-clockwise",
            Self::Motion(Code::RigidTap) => "thread in step with the spindle, in and out",
            Self::Motion(Code::None) => "end of the canned cycle",
            Self::Motion(Code::Cycle) => "canned cycle",
            Self::Hole(Pattern::Drill) => "drilling cycle",
            Self::Hole(Pattern::Ream) => "reaming cycle, out at feed",
            Self::Hole(Pattern::Peck) => "pecking cycle, full retract after each step",
            Self::Hole(Pattern::ChipBreak) => "pecking cycle, short retract after each step",
            Self::Hole(Pattern::Tap { left: false }) => "thread, right-hand, in step with the spindle",
            Self::Hole(Pattern::Tap { left: true }) => "thread, left-hand, in step with the spindle",
            Self::Hole(Pattern::TapAfterRigid { left: false }) => "thread, right-hand; floating without M29",
            Self::Hole(Pattern::TapAfterRigid { left: true }) => "thread, left-hand; floating without M29",
            Self::Hole(Pattern::FloatingTap { left: false }) => "thread, right-hand, floating",
            Self::Hole(Pattern::FloatingTap { left: true }) => "thread, left-hand, floating",
            Self::Hole(Pattern::Bore) => "boring cycle, out with the spindle off",
            Self::Hole(Pattern::FineBore) => "boring cycle, spindle stopped at an angle, off the wall, out at rapid",
            Self::Dwell => "dwell",
            Self::Reference => "motion to the reference position through a point",
            Self::EndOfTravel => "with MB MAX: retract along the tool axis to the end of the travel",
            Self::Machine => "machine coordinates in this block",
            Self::Plane(_) => "working plane",
            Self::Units(Units::Millimetres) => "millimetres",
            Self::Units(Units::Inches) => "inches",
            Self::UnitsOfFeed(Units::Millimetres) => "millimetres, F too",
            Self::UnitsOfFeed(Units::Inches) => "inches, F too",
            Self::Distances { incremental: false } => "absolute words",
            Self::Distances { incremental: true } => "incremental words",
            Self::ArcCentres { absolute: true } => "centres of arcs are absolute",
            Self::ArcCentres { absolute: false } => "centres of arcs from the start of the arc",
            Self::FeedMode(FeedMode::PerMinute) => "feed per minute",
            Self::FeedMode(FeedMode::InverseTime) => "inverse-time feed",
            Self::FeedMode(FeedMode::PerRevolution) => "feed per revolution",
            Self::Side(SideOfPath::None) => "cutter compensation off",
            Self::Side(SideOfPath::Left) => "cutter compensation left",
            Self::Side(SideOfPath::Right) => "cutter compensation right",
            Self::Length(LengthCode::Off) => "length compensation off",
            Self::Length(LengthCode::On) => "length compensation on",
            Self::Length(LengthCode::TipControl) => "tip control with length compensation",
            Self::Length(LengthCode::TipVector) => "tip control with tool vectors",
            Self::TiltedPlane(Plane::Euler) => "tilted plane by angles about Z, X, Z",
            Self::TiltedPlane(Plane::Haas) => "tilted plane by angles about fixed axes",
            Self::DynamicOffset(true) => "dynamic work offset on: the zero of the words follows the table",
            Self::DynamicOffset(false) => "dynamic work offset off",
            Self::Orient => "rotary axes into the tilted plane",
            Self::TiltOff => "tilted plane off",
            Self::Offset => "work offset",
            Self::FurtherOffset => "further work offset",
            Self::Return { initial: true } => "cycles return to the level before them",
            Self::Return { initial: false } => "cycles return to R",
            Self::Path(PathCode::ExactPath) => "exact path",
            Self::Path(PathCode::ExactStop) => "exact stop",
            Self::Path(PathCode::Continuous | PathCode::Smoothed(_)) => "continuous path",
            Self::Path(PathCode::Window) => "exact stop of a block, or its window",
            Self::Smoothing(_) => "smoothing of the path",
            Self::Stop { optional: false } => "program stop",
            Self::Stop { optional: true } => "optional stop",
            Self::End => "end of the program",
            Self::Spindle(Some(Rotation::Clockwise)) => "spindle on, clockwise",
            Self::Spindle(Some(Rotation::CounterClockwise)) => "spindle on, counter-clockwise",
            Self::Spindle(None) => "spindle off",
            Self::SpindleAndFlood(_) => "spindle on and coolant on",
            Self::ToolChange => "tool change",
            Self::CoolantOn(_) => "coolant on",
            Self::CoolantOff(_) => "coolant off",
            Self::Rigid => "the next thread is cut in step with the spindle",
            Self::TipControl(true) => "tip control on",
            Self::TipControl(false) => "tip control off",
            Self::Interpolation { in_plane: true } => "the tool axis rotates in a plane",
            Self::Interpolation { in_plane: false } => "the rotary axes rotate evenly",
            Self::Frame { in_workpiece: true } => "tool axes count in the workpiece",
            Self::Frame { in_workpiece: false } => "tool axes count in the machine",
            Self::ShortestWay(true) => "rotary axes take the shortest path",
            Self::ShortestWay(false) => "rotary axes rotate as programmed",
            Self::CallCycle => "the defined cycle at the end of this block",
            Self::Address(address) => address.text(),
            Self::Statement(statement) => statement.text(),
            Self::Settles(bit) => match bit {
                settled::DIAMETER => "X is a radius",
                settled::CUTTING_SPEED => "S is a speed in rev/min",
                settled::SHIFT => "programmed shift, rotation, scale and mirror off",
                settled::SCALING => "scaling off",
                settled::ROTATION => "rotation of the coordinates off",
                settled::POLAR => "polar coordinates off",
                _ => "workpiece setting error compensation off",
            },
            Self::Harmless(reason) => reason,
        }
    }

    /// State that it reads, state that it changes, axes that it moves.
    pub(super) fn effect(self) -> [&'static str; 3] {
        match self {
            Self::Motion(Code::Rapid) => ["offsets, frame", "motion code, position", "written axes"],
            Self::Motion(Code::Feed) => ["F, offsets, frame", "motion code, position", "written axes"],
            Self::Motion(Code::Clockwise | Code::CounterClockwise) => {
                ["F, plane, position", "motion code, position", "written axes"]
            }
            Self::Motion(Code::RigidTap) => ["S, spindle, position", "none", "Z in and out"],
            Self::Motion(Code::None) => ["none", "motion code, cycle", "none"],
            Self::Motion(Code::Cycle) | Self::Hole(_) => {
                ["F, S, plane, G98/G99, level", "cycle, position", "written axes, Z in and out"]
            }
            Self::Dwell => ["S", "none", "none"],
            Self::Reference => ["position", "position unknown", "written axes, or all"],
            Self::EndOfTravel => ["tool call", "position unknown", "the tool axis"],
            Self::Machine => ["motion code", "position unknown", "written axes"],
            Self::Plane(_) => ["none", "plane", "none"],
            Self::Units(_) | Self::UnitsOfFeed(_) => ["none", "unit, restart point", "none"],
            Self::Distances { .. } => ["none", "absolute or incremental", "none"],
            Self::ArcCentres { .. } => ["none", "centres of arcs", "none"],
            Self::FeedMode(_) => ["none", "feed mode, F", "none"],
            Self::Side(_) => ["D", "cutter compensation", "none"],
            Self::Length(LengthCode::Off) => ["none", "length, tip control", "none: Z unknown"],
            Self::Length(_) => ["H", "length, tip control", "none: Z unknown"],
            Self::TiltedPlane(_) => ["work offset", "tilted plane", "none"],
            Self::Orient => ["tilted plane", "tilted plane", "rotary axes"],
            Self::TiltOff => ["none", "tilted plane", "none"],
            Self::DynamicOffset(_) => ["rotary positions, work offset", "dynamic work offset", "none: X Y Z unknown"],
            Self::Offset | Self::FurtherOffset => ["none", "work offset", "none"],
            Self::Return { .. } => ["none", "return level of cycles", "none"],
            Self::Path(_) => ["none", "path mode", "none"],
            Self::Smoothing(_) => ["none", "smoothing", "none"],
            Self::Stop { .. } => ["none", "position unknown", "none"],
            Self::End => ["none", "end", "none"],
            Self::Spindle(_) => ["S", "spindle", "none"],
            Self::SpindleAndFlood(_) => ["S", "spindle, coolant", "none"],
            Self::ToolChange => ["T", "tool, spindle, length, position", "by the machine"],
            Self::CoolantOn(_) | Self::CoolantOff(_) => ["none", "coolant", "none"],
            Self::Rigid => ["none", "kind of the next thread", "none"],
            Self::TipControl(_) => ["position", "tip control", "none: X Y Z unknown"],
            Self::Interpolation { .. } => ["none", "motion of the tool axis", "none"],
            Self::Frame { .. } => ["none", "frame of tool axes", "none"],
            Self::ShortestWay(_) => ["none", "path of rotary axes", "none"],
            Self::CallCycle => ["cycle, plane", "position", "Z in and out"],
            Self::Address(address) => address.effect(),
            Self::Statement(statement) => statement.effect(),
            Self::Settles(_) => ["none", "what a program before may have left", "none"],
            Self::Harmless(_) => ["none", "none", "none"],
        }
    }
}

impl Address {
    fn text(self) -> &'static str {
        match self {
            Self::BlockNumber => "block number",
            Self::Code => "code",
            Self::Axis => "axis word, where the machine has the axis",
            Self::Centre => "centre of an arc, angles of a plane, or tool axis",
            Self::Vector => "component of the tool axis",
            Self::Feed => "feed",
            Self::Speed => "spindle speed",
            Self::Tool => "tool",
            Self::LengthRegister => "length register",
            Self::Edge => "cutting edge: its length is in force, none with 0",
            Self::RadiusRegister => "radius register",
            Self::Parameter => "parameter of a code",
            Self::Radius => "radius of an arc",
            Self::Angle => "angle of an arc",
            Self::Turns => "further revolutions of a helix",
            Self::Sense => "sense of an arc",
            Self::Side => "cutter compensation off, left, right",
            Self::RapidFeed => "this block is a rapid",
        }
    }

    fn effect(self) -> [&'static str; 3] {
        match self {
            Self::Axis => ["motion code", "position", "the axis"],
            Self::Feed => ["feed mode", "F", "none"],
            Self::Speed => ["none", "S", "none"],
            Self::Tool => ["none", "selected tool", "none"],
            Self::Vector => ["tip control", "tool axis", "rotary axes"],
            Self::LengthRegister | Self::Edge => ["none", "length", "none"],
            Self::RadiusRegister => ["none", "radius register", "none"],
            Self::Side => ["none", "cutter compensation", "none"],
            _ => ["none", "none", "none"],
        }
    }
}

impl StatementWord {
    fn text(self) -> &'static str {
        match self {
            Self::ProgramNumber => "program number, before the first block only",
            Self::ProgramMark => "begins a program, and ends it where it occurs again",
            Self::Guard => "guard of a length, a radius or rotary positions, only as a complete sequence",
            Self::Message => "message or alarm, the program goes on",
            Self::Comment => "comment",
            Self::BlockDelete => "optional block, only before a block that does nothing",
            Self::Begin => "begins the program, and names the unit",
            Self::EndOfProgram => "end of the program",
            Self::Blank => "blank for the graphics",
            Self::Line => "straight motion",
            Self::Pole => "pole of arcs",
            Self::Arc => "arc or helix",
            Self::ToolCall => "tool change, or spindle speed",
            Self::ToolDef => "the next tool is prepared",
            Self::CycleDef => "defines a cycle, see the lists",
            Self::CycleCall => "calls the defined cycle",
            Self::PlaneSpatial => "tilted plane by spatial angles",
            Self::PlaneReset => "tilted plane off",
            Self::TcpmOn => "tip control on",
            Self::TcpmOff => "tip control off",
            Self::Stop => "program stop",
            Self::ModalCall => "the cycle after each motion from here on, or its end",
        }
    }

    fn effect(self) -> [&'static str; 3] {
        match self {
            Self::Guard => ["tool data, rotary positions", "none", "none"],
            Self::Begin => ["none", "unit, feed mode, compensation", "none"],
            Self::ProgramMark | Self::EndOfProgram => ["none", "end", "none"],
            Self::Line => ["F, offsets, frame", "position", "written axes"],
            Self::Arc => ["F, plane, pole, position", "position", "written axes"],
            Self::Pole => ["position", "pole", "none"],
            Self::ToolCall => ["none", "tool, length, plane, S, position", "by the machine"],
            Self::CycleDef | Self::ModalCall => ["none", "cycle", "none"],
            Self::CycleCall => ["cycle, plane", "position", "Z in and out"],
            Self::PlaneSpatial => ["work offset", "tilted plane", "rotary axes with TURN, all with MOVE"],
            Self::PlaneReset => ["none", "tilted plane", "rotary axes to 0 with TURN, all with MOVE"],
            Self::TcpmOn | Self::TcpmOff => ["position", "tip control", "none: X Y Z unknown"],
            Self::Stop => ["none", "position unknown", "none"],
            _ => ["none", "none", "none"],
        }
    }
}
