//! Everything that stays in force from one block to the next.
//!
//! `None` means that the program has not set it since it was entered. Lengths count in the unit of the program, angles
//! in degrees, the spindle in rev/min.

use super::Control;
use super::axes::Axes;

/// Unit of lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Units {
    /// G21, G710, `BEGIN PGM .. MM`.
    Millimetres,
    /// G20, G700, `BEGIN PGM .. INCH`.
    Inches,
}

impl Units {
    /// Millimetres in one unit.
    #[must_use]
    pub const fn in_mm(self) -> f64 {
        match self {
            Self::Millimetres => 1.0,
            Self::Inches => 25.4,
        }
    }
}

/// Plane of arcs, cycles and cutter compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Plane {
    /// G17, tool axis Z.
    Xy,
    /// G18, tool axis Y.
    Zx,
    /// G19, tool axis X.
    Yz,
}

impl Plane {
    /// First axis, second axis and normal: a right-handed frame.
    #[must_use]
    pub const fn letters(self) -> [char; 3] {
        match self {
            Self::Xy => ['X', 'Y', 'Z'],
            Self::Zx => ['Z', 'X', 'Y'],
            Self::Yz => ['Y', 'Z', 'X'],
        }
    }
}

/// Distance mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Distance {
    /// G90.
    Absolute,
    /// G91.
    Incremental,
}

/// Feed mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedMode {
    /// G94: units of length per minute.
    PerMinute,
    /// G93: blocks per minute.
    InverseTime,
    /// G95: units of length per revolution.
    PerRevolution,
}

/// Motion mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionMode {
    /// G0, `FMAX`.
    Rapid,
    /// G1, `L`.
    Feed,
    /// G2, `DR-`.
    Clockwise,
    /// G3, `DR+`.
    CounterClockwise,
    /// G73 to G89: a hole at every position.
    Cycle,
}

/// Work offset.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WorkOffset {
    /// `G54` to `G59.3`, `G505` to `G599`: the code in tenths.
    Code(u32),
    /// Number of `G54.1 P`, `G154 P`.
    Further(u32),
    /// Row of the datum table of a Heidenhain control.
    Row(u32),
}

/// Tool length compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// G49, D0.
    Off,
    /// Register, cutting edge, or row of the tool table.
    Register(u32),
}

/// Spindle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spindle {
    /// M5.
    Off,
    /// M3.
    Clockwise,
    /// M4.
    CounterClockwise,
}

/// Coolant supplies that are on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coolant {
    /// M8.
    pub flood: bool,
    /// M7.
    pub mist: bool,
    /// M88 on Haas.
    pub through: bool,
}

/// Cutter compensation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compensation {
    /// G40, `R0`.
    Off,
    /// G41, `RL`; with the register of the radius where the block names one.
    Left(Option<u32>),
    /// G42, `RR`.
    Right(Option<u32>),
}

/// Path mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PathMode {
    /// G61, G60, G9.
    ExactStop,
    /// G64, with its tolerance where the block names one.
    Continuous(Option<f64>),
}

/// Tip control: linear words are coordinates of the tool tip while rotary axes move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TipControl {
    /// Words are axis positions.
    Off,
    /// G43.4, G234, TRAORI, M128, TCPM.
    On {
        /// Rotary positions at the start of tip control, as far as known.
        start: Axes,
        /// The tool axis is programmed as a vector.
        vectors: bool,
    },
}

/// How the tool axis moves between two points under tip control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Each rotary axis moves evenly: ORIAXES, `PATHCTRL AXIS`, P0.
    RotaryAxes,
    /// The tool axis stays in the plane of its ends: ORIVECT, `PATHCTRL VECTOR`, P1.
    Vector,
}

/// Frame in which tool vectors count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VectorFrame {
    /// ORIMKS.
    Machine,
    /// ORIWKS.
    Workpiece,
}

/// How a rotary axis reaches its word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotaryPath {
    /// M126: the shorter way.
    Shortest,
    /// M127: as the words count.
    AsProgrammed,
}

/// Return level of canned cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReturnLevel {
    /// G98.
    Initial,
    /// G99.
    Reference,
}

/// A tilted plane, as programmed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltedPlane {
    /// Rows of the matrix that takes coordinates of the plane to those of the work offset.
    pub rotation: [[f64; 3]; 3],
    /// Origin of the plane in the work offset.
    pub origin: [f64; 3],
    /// The rotary axes have been commanded to the plane.
    pub oriented: bool,
    /// Sign that chooses between two positions of the rotary axes: SEQ, _DIR; 0 without it.
    pub solution: i8,
}

/// How a cycle makes its hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CycleKind {
    /// In at feed, out at rapid.
    Drill,
    /// In and out at feed.
    Ream,
    /// In steps, out of the hole after each.
    Peck {
        /// Depth of a step.
        step: f64,
    },
    /// In steps, back by a little after each.
    ChipBreak {
        /// Depth of a step.
        step: f64,
    },
    /// A thread in step with the spindle.
    Tap {
        /// Advance per revolution, negative for a left-hand thread.
        pitch: f64,
    },
}

/// A canned cycle with its parameters; levels count along the normal of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// How the hole is made.
    pub kind: CycleKind,
    /// Level to which the tool comes down at rapid.
    pub reference: f64,
    /// Bottom of the hole.
    pub bottom: f64,
    /// Level after the hole; `None` where G98 and G99 decide.
    pub back_to: Option<f64>,
    /// Wait at the bottom, s.
    pub dwell_s: f64,
    /// Feed of its own.
    pub feed: Option<f64>,
    /// Number of the cycle and its other parameters, as one number; 0 for cycles of letters.
    pub others: u64,
}

/// Numbers of smoothing: P Q E of G5.1 and G187, arguments of CYCLE832, T, HSC-MODE and TA of cycle 32.
pub const SMOOTHING: usize = 5;

/// A state that a program before may have left on, and that changes what words mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeftOn {
    /// X is a diameter: G7 of LinuxCNC.
    Diameter,
    /// S is a cutting speed: G96 of LinuxCNC.
    CuttingSpeed,
    /// A programmed shift, rotation, scale or mirror of Siemens.
    Shift,
    /// G51.
    Scaling,
    /// G68 of Haas.
    Rotation,
    /// G16.
    Polar,
    /// G54.4 P1.
    SettingError,
}

/// States that a program before has left on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct LeftOnes(u8);

impl LeftOnes {
    /// These.
    #[must_use]
    pub fn of(left: &[LeftOn]) -> Self {
        Self(left.iter().fold(0, |bits, left| bits | 1 << *left as u8))
    }

    /// Ends one.
    pub fn end(&mut self, left: LeftOn) {
        self.0 &= !(1 << left as u8);
    }

    /// Whether one is on.
    #[must_use]
    pub fn any(self) -> bool {
        self.0 != 0
    }
}

/// Modal state of a control.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// Unit of lengths.
    pub units: Option<Units>,
    /// Plane of arcs and cycles.
    pub plane: Option<Plane>,
    /// Distance mode.
    pub distance: Option<Distance>,
    /// Centres of arcs, where the control has both.
    pub arc_centres: Option<Distance>,
    /// Motion mode.
    pub motion: Option<MotionMode>,
    /// Feed mode.
    pub feed_mode: Option<FeedMode>,
    /// F in force, as the feed mode counts it; in inverse time that of the block alone.
    pub feed: Option<f64>,
    /// Work offset.
    pub work_offset: Option<WorkOffset>,
    /// Tool in the spindle.
    pub tool: Option<u32>,
    /// Tool selected for the next change.
    pub selected: Option<u32>,
    /// Tool length compensation.
    pub length: Option<Length>,
    /// Spindle.
    pub spindle: Option<Spindle>,
    /// A thread has stopped the spindle, and nothing has started it again.
    pub stopped_by_thread: bool,
    /// S, rev/min.
    pub speed: Option<f64>,
    /// Coolant.
    pub coolant: Option<Coolant>,
    /// Cutter compensation.
    pub compensation: Option<Compensation>,
    /// DR of the tool call; `None` after a call of a speed alone that may have reset it.
    pub radius_delta: Option<f64>,
    /// Tip control; `None` before the program has set it, and off then as far as words count.
    pub tip_control: Option<TipControl>,
    /// Motion of the tool axis under tip control.
    pub interpolation: Option<Interpolation>,
    /// Frame of tool vectors.
    pub vector_frame: Option<VectorFrame>,
    /// Tool vector in force.
    pub vector: Option<[f64; 3]>,
    /// Tilted plane; `Some(None)` after it has been switched off.
    pub tilt: Option<Option<TiltedPlane>>,
    /// The zero of the words follows the table (G254).
    pub dynamic_offset: bool,
    /// What a program before has left on.
    pub left: LeftOnes,
    /// A rotation lies over the work offset.
    pub rotated_offset: bool,
    /// Canned cycle that is defined or called modally.
    pub cycle: Option<Cycle>,
    /// Return level of canned cycles.
    pub return_level: Option<ReturnLevel>,
    /// Path mode.
    pub path: Option<PathMode>,
    /// Numbers of the control's smoothing, in places of their own for each form; `None` before the program has set it.
    pub smoothing: Option<[Option<f64>; SMOOTHING]>,
    /// How rotary axes reach their words.
    pub rotary_path: Option<RotaryPath>,
    /// TRAORI, or TRAFOOF under tip control, has been programmed after the work offset, which it may clear.
    pub offset_cleared: bool,
    /// Register or tool of the last length guard, where it names one.
    pub guarded: Option<u32>,
    /// The next G84 is in step with the spindle (M29).
    pub rigid: bool,
    /// Pole of Heidenhain arcs: X Y Z as far as programmed.
    pub pole: [Option<f64>; 3],
    /// Position of each axis in the coordinates of the program, as far as known.
    pub position: Axes,
    /// Machine coordinate of each axis, as far as known.
    pub machine: Axes,
}

impl State {
    /// What a program before may have left on a control that has nothing but what every machine has.
    #[must_use]
    pub fn left_on(control: Control) -> Self {
        let tilt = TiltedPlane {
            rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
            origin: [7.0, 0.0, 0.0],
            oriented: true,
            solution: 0,
        };
        let framed = Self {
            tip_control: Some(TipControl::On { start: Axes::default(), vectors: false }),
            tilt: Some(Some(tilt)),
            ..Self::default()
        };
        let offset = Self { compensation: Some(Compensation::Left(None)), ..Self::default() };
        match control {
            Control::LinuxCnc => Self { left: LeftOnes::of(&[LeftOn::Diameter, LeftOn::CuttingSpeed]), ..offset },
            Control::Fanuc | Control::Haas => offset,
            Control::Siemens => {
                Self { left: LeftOnes::of(&[LeftOn::Shift]), compensation: offset.compensation, ..framed }
            }
            Control::Heidenhain => framed,
        }
    }

    /// Whether words are coordinates of the tool tip.
    #[must_use]
    pub fn under_tip_control(&self) -> bool {
        matches!(self.tip_control, Some(TipControl::On { .. }))
    }

    /// Tilted plane that is on.
    #[must_use]
    pub fn tilted_plane(&self) -> Option<TiltedPlane> {
        self.tilt.flatten()
    }
}
