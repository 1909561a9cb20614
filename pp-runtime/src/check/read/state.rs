//! State of a control: what is in force when a block acts.

use std::fmt;

use nalgebra::{Matrix3, Vector3};

use crate::program::{Rotation, Units};

/// What F means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedMode {
    /// mm/min.
    PerMinute,
    /// 1/min.
    InverseTime,
    /// mm per revolution.
    PerRevolution,
}

/// Plane of arcs, cycles and cutter compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkPlane {
    /// G17.
    Xy,
    /// G18.
    Zx,
    /// G19.
    Yz,
}

impl WorkPlane {
    /// First and second axis of the plane and its normal, as positions in X Y Z; right-handed.
    #[must_use]
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Self::Xy => [0, 1, 2],
            Self::Zx => [2, 0, 1],
            Self::Yz => [1, 2, 0],
        }
    }
}

/// On which side of the path the cutter runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SideOfPath {
    /// On it.
    #[default]
    None,
    /// G41.
    Left,
    /// G42.
    Right,
}

impl SideOfPath {
    /// The other side.
    #[must_use]
    pub fn across(self) -> Self {
        match self {
            Self::None => Self::None,
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }
}

impl SideOfPath {
    /// Name in messages.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::None => "off",
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// A settable offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkOffset {
    /// `G54`, `G59.1`, `G505`: the code in tenths.
    Code(u32),
    /// `G54.1 P`, `G154 P`.
    Further(u32),
    /// A row of the preset table.
    Row(u32),
}

/// Length compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// None is in force.
    Off,
    /// That of a register, of a cutting edge, or of the tool's row.
    Register(u32),
}

impl fmt::Display for WorkOffset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Code(tenths) if tenths % 10 == 0 => write!(f, "G{}", tenths / 10),
            Self::Code(tenths) => write!(f, "G{}.{}", tenths / 10, tenths % 10),
            Self::Further(number) => write!(f, "P{number} of the additional work offsets"),
            Self::Row(row) => write!(f, "row {row} of the preset table"),
        }
    }
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Off => f.write_str("off"),
            Self::Register(number) => write!(f, "register {number}"),
        }
    }
}

/// A control that keeps the tip on its path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TipControl {
    /// Words are axis positions.
    Off,
    /// Words are tip coordinates; the rotary axes stood here when it was switched on, rad.
    On {
        /// By position of the axis.
        start: [f64; MAX_AXES],
    },
}

/// A tilted plane: words count in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Plane to program coordinates.
    pub rotation: Matrix3<f64>,
    /// Where it counts from, mm.
    pub origin: Vector3<f64>,
    /// The rotary axes are in the plane: positioned to it, and no rotary word has moved them since.
    pub oriented: bool,
    /// Pose of the rotary axes that the program selects: SEQ or _DIR, `true` for plus.
    pub pose: Option<bool>,
    /// Without COORD ROT: a rotary axis that is parallel to the tool may rotate, and not the coordinates.
    pub rotates_table: bool,
}

/// Smoothing of the path by the control.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PathSmoothing {
    /// Not active.
    #[default]
    Off,
    /// G5.1 Q1, G187, CYCLE832, cycle 32.
    On {
        /// Largest deviation from the path, mm; `None` where the program does not state it.
        tolerance_mm: Option<f64>,
        /// P of G187, units of the second argument of CYCLE832, HSC-MODE.
        level: Option<u8>,
    },
}

/// Motion from block to block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathMode {
    /// G61 of LinuxCNC: the path exactly, without stops.
    ExactPath,
    /// A stop at the end of each block.
    ExactStop,
    /// G64: corners are rounded.
    Continuous {
        /// P of LinuxCNC, mm; `None`: no limit is programmed.
        tolerance_mm: Option<f64>,
        /// Q of LinuxCNC, mm: deviation up to which blocks are joined.
        joining_mm: Option<f64>,
    },
    /// G641 to G645: by the smoothing of this code.
    Smoothed(u16),
}

impl PathMode {
    /// Q of LinuxCNC, mm.
    pub(in crate::check) fn joining_mm(self) -> Option<f64> {
        match self {
            Self::Continuous { joining_mm, .. } => joining_mm,
            Self::ExactPath | Self::ExactStop | Self::Smoothed(_) => None,
        }
    }
}

/// Coolant that is on: bits.
pub mod coolant {
    /// M8.
    pub const FLOOD: u8 = 1;
    /// M7.
    pub const MIST: u8 = 2;
    /// Through the spindle.
    pub const THROUGH: u8 = 4;
    /// Air.
    pub const AIR: u8 = 8;
    /// Through the spindle at low, medium and high pressure.
    pub const PRESSURES: [u8; 3] = [16, 32, 64];
}

/// What has been said since a complete state began: bits.
pub(crate) mod stated {
    /// Spindle on or off.
    pub(crate) const SPINDLE: u8 = 1;
    /// Coolant.
    pub(crate) const COOLANT: u8 = 2;
    /// Length compensation.
    pub(crate) const LENGTH: u8 = 4;
    /// Work offset.
    pub(crate) const OFFSET: u8 = 8;
    /// Unit, plane, feed mode, distances and sides.
    pub(crate) const MODES: u8 = 16;
    /// S.
    pub(crate) const SPEED: u8 = 32;
    /// T.
    pub(crate) const TOOL: u8 = 64;
}

/// What a program before may have left in force, and the code that ends it: bits of what the program has settled since
/// its last motion before the complete state.
pub(in crate::check) mod settled {
    /// Cutter compensation.
    pub(crate) const SIDE: u32 = 1;
    /// Length compensation.
    pub(crate) const LENGTH: u32 = 2;
    /// X is a diameter.
    pub(crate) const DIAMETER: u32 = 4;
    /// S is a cutting speed.
    pub(crate) const CUTTING_SPEED: u32 = 8;
    /// Tip control.
    pub(crate) const TIP_CONTROL: u32 = 16;
    /// A tilted plane.
    pub(crate) const PLANE: u32 = 32;
    /// The zero follows the table.
    pub(crate) const DYNAMIC_OFFSET: u32 = 64;
    /// A programmable shift, rotation, scale or mirror.
    pub(crate) const SHIFT: u32 = 128;
    /// Scaling.
    pub(crate) const SCALING: u32 = 256;
    /// Rotation of the coordinates.
    pub(crate) const ROTATION: u32 = 512;
    /// Words are polar coordinates.
    pub(crate) const POLAR: u32 = 1024;
    /// Compensation of the place of the part (workpiece setting error).
    pub(crate) const SETTING_ERROR: u32 = 2048;
    /// Smoothing of the path.
    pub(crate) const SMOOTHING: u32 = 4096;
    /// Motion from block to block.
    pub(crate) const PATH: u32 = 8192;
    /// Words are distances.
    pub(crate) const DISTANCES: u32 = 16384;
    /// Plane of arcs and cycles.
    pub(crate) const WORKING_PLANE: u32 = 32768;
    /// What F means.
    pub(crate) const FEED_MODE: u32 = 65536;
    /// Centres of arcs.
    pub(crate) const CENTRES: u32 = 131_072;
    /// Unit of F.
    pub(crate) const FEED_UNIT: u32 = 262_144;
}

/// What is in force; `None` where the program has not said it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// In the spindle.
    pub tool: Option<u32>,
    /// Called up for the next change.
    pub selected: Option<u32>,
    /// Length compensation.
    pub length: Option<Length>,
    /// Register of the diameter.
    pub diameter: Option<u32>,
    /// DR of the tool call, mm.
    pub radius_delta_mm: Option<f64>,
    /// Work offset.
    pub work_offset: Option<WorkOffset>,
    /// Work offset that was in force before tip control may have cancelled it.
    pub cancelled_offset: Option<WorkOffset>,
    /// Unit of lengths.
    pub units: Option<Units>,
    /// Words are distances.
    pub incremental: Option<bool>,
    /// I J K of arcs are absolute.
    pub absolute_centres: Option<bool>,
    /// Plane of arcs and cycles.
    pub plane: Option<WorkPlane>,
    /// Sense of the spindle; `Some(None)` if it stands.
    pub spindle: Option<Option<Rotation>>,
    /// S, rev/min.
    pub speed: Option<f64>,
    /// Bits of [`coolant`].
    pub coolant: Option<u8>,
    /// Cutter compensation.
    pub side: Option<SideOfPath>,
    /// Blocks that measure may have switched cutter compensation on.
    pub side_unknown: bool,
    /// What F means.
    pub feed_mode: Option<FeedMode>,
    /// F in force: units of length of the program per minute or per revolution, or 1/min.
    pub feed: Option<f64>,
    /// Tip control.
    pub tip_control: TipControl,
    /// Under tip control the tool axis turns in the plane of its ends; otherwise each rotary axis evenly.
    pub in_plane: Option<bool>,
    /// Under tip control tool axes count in the workpiece; otherwise in the machine.
    pub in_workpiece: Option<bool>,
    /// The tool axis as the program says it under tip control, in the place of angles.
    pub vector: Option<Vector3<f64>>,
    /// Tilted plane.
    pub tilt: Option<Tilt>,
    /// Dynamic work offset: the zero of the words has moved with the table.
    pub dynamic_offset: bool,
    /// G98: cycles return to the level before them; G99: to their own level. `None` where neither has been programmed
    /// since the complete state.
    pub to_initial: Option<bool>,
    /// Rotary words name the nearest such angle.
    pub shortest: bool,
    /// The program has selected the path of rotary axes (M126, M127).
    pub shortest_stated: bool,
    /// Smoothing of the path.
    pub smoothing: PathSmoothing,
    /// Largest deviation of the tool axis while smoothing is on, rad.
    pub smoothing_angle_rad: Option<f64>,
    /// Motion from block to block.
    pub path_mode: Option<PathMode>,
    /// Clamped rotary axes: bits by position.
    pub clamped: u16,
    /// Axes of which it is known whether they are clamped: bits by position.
    pub clamps_known: u16,
    /// Bits of `settled`.
    pub settled: u32,
    /// Line with the declared effect "state lost": what has not been programmed after it is unknown.
    pub lost_at: Option<u64>,
}

/// Frame in which linear words count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::check) struct WordsFrame {
    tip_control: TipControl,
    tilt: Option<Tilt>,
    dynamic_offset: bool,
}

/// Takes the values out of fields in which a state differs from another one.
macro_rules! keep_equal {
    ($other:ident; $($field:ident),*) => {
        $(if *$field != $other.$field {
            *$field = None;
        })*
    };
}

impl State {
    /// Whether cutter compensation is on.
    pub(super) fn compensates(&self) -> bool {
        self.side.is_some_and(|side| side != SideOfPath::None)
    }

    /// Takes what a block of axis words, F and S may have changed in another state that was the same before.
    pub(super) fn take_moves(&mut self, now: &Self) {
        (self.feed, self.speed) = (now.feed, now.speed);
        if let (Some(tilt), Some(now)) = (&mut self.tilt, &now.tilt) {
            tilt.oriented = now.oriented;
        }
    }

    /// Takes out what differs from another state, except the frame: it is unknown which of the two is in force.
    pub(super) fn join(&mut self, other: &Self) {
        fn keep<T: PartialEq>(value: &mut Option<T>, other: &Option<T>) {
            if value != other {
                *value = None;
            }
        }
        let Self {
            tool,
            selected,
            length,
            diameter,
            radius_delta_mm,
            work_offset,
            cancelled_offset,
            units,
            incremental,
            absolute_centres,
            plane,
            spindle,
            speed,
            coolant,
            side,
            side_unknown,
            feed_mode,
            feed,
            tip_control: _,
            in_plane,
            in_workpiece,
            vector,
            tilt: _,
            dynamic_offset: _,
            to_initial,
            shortest,
            shortest_stated,
            smoothing,
            smoothing_angle_rad,
            path_mode,
            clamped,
            clamps_known,
            settled,
            lost_at,
        } = self;
        keep_equal!(other; tool, selected, length, diameter, radius_delta_mm, units, incremental, absolute_centres, plane, spindle, speed, coolant, side, feed_mode, feed, in_plane, in_workpiece, vector, to_initial, smoothing_angle_rad);
        // Cancelled in one of the two, it may be cancelled.
        *cancelled_offset = work_offset.or(*cancelled_offset);
        keep(cancelled_offset, &other.work_offset.or(other.cancelled_offset));
        keep(work_offset, &other.work_offset);
        *cancelled_offset = cancelled_offset.filter(|_| work_offset.is_none());
        *side_unknown |= other.side_unknown;
        // What is not known here is the mode after switching on.
        if *path_mode != other.path_mode {
            *path_mode = Some(PathMode::ExactPath);
        }
        *settled &= other.settled;
        *lost_at = lost_at.or(other.lost_at);
        if *shortest != other.shortest {
            (*shortest, *shortest_stated) = (false, false);
        }
        *shortest_stated &= other.shortest_stated;
        if *smoothing == PathSmoothing::Off {
            *smoothing = other.smoothing;
        }
        *clamps_known &= other.clamps_known & !(*clamped ^ other.clamped);
    }

    /// Whether the spindle is known to be on.
    pub(crate) fn spindle_is_on(&self) -> bool {
        self.spindle.flatten().is_some()
    }

    /// Whether coolant is known to be on.
    pub(crate) fn coolant_is_on(&self) -> bool {
        self.coolant.is_some_and(|on| on != 0)
    }

    /// Linear words count in a frame: the positions of the axes follow from all words together.
    pub(crate) fn has_frame(&self) -> bool {
        self.tip_control != TipControl::Off || self.tilt.is_some() || self.dynamic_offset
    }

    /// End of the text of a fault about a state that is `unknown`: the line after which it is.
    pub(in crate::check) fn since_lost(&self, unknown: bool) -> String {
        let line = self.lost_at.filter(|_| unknown);
        line.map_or_else(String::new, |line| {
            format!("; it is unknown after line {line}, whose effect is declared \"state lost\": program it again after that line")
        })
    }

    /// Frame in which linear words count.
    pub(in crate::check) fn frame(&self) -> WordsFrame {
        WordsFrame { tip_control: self.tip_control, tilt: self.tilt, dynamic_offset: self.dynamic_offset }
    }
}

impl Default for State {
    fn default() -> Self {
        Self {
            tool: None,
            selected: None,
            length: None,
            diameter: None,
            radius_delta_mm: None,
            work_offset: None,
            cancelled_offset: None,
            units: None,
            incremental: None,
            absolute_centres: None,
            plane: None,
            spindle: None,
            speed: None,
            coolant: None,
            side: None,
            side_unknown: false,
            feed_mode: None,
            feed: None,
            tip_control: TipControl::Off,
            in_plane: None,
            in_workpiece: None,
            vector: None,
            tilt: None,
            dynamic_offset: false,
            to_initial: None,
            shortest: false,
            shortest_stated: false,
            smoothing: PathSmoothing::Off,
            smoothing_angle_rad: None,
            path_mode: None,
            clamped: 0,
            clamps_known: 0,
            settled: 0,
            lost_at: None,
        }
    }
}

/// Most axes a chain can have: X Y Z U V W A B C.
pub(crate) const MAX_AXES: usize = 9;
