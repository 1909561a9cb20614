//! Meanings of codes and words: what the interpreter executes, and what the tables print.

use super::super::block::{FeedMode, SideOfPath, WorkPlane};
use super::super::orders::{Code, LengthCode, Pattern};
use crate::program::{Rotation, Units};

/// Meaning of a code or a word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) enum Means {
    /// A motion code.
    Motion(Code),
    /// A canned cycle.
    Hole(Pattern),
    Dwell,
    Reference,
    /// The tool axis to the end of its travel.
    EndOfTravel,
    Machine,
    Plane(WorkPlane),
    Units(Units),
    /// Units of words and of F.
    UnitsOfFeed(Units),
    Distances {
        incremental: bool,
    },
    /// I J K of arcs.
    ArcCentres {
        absolute: bool,
    },
    FeedMode(FeedMode),
    Side(SideOfPath),
    Length(LengthCode),
    TiltedPlane(Plane),
    Orient,
    TiltOff,
    /// The zero of the words follows the table.
    DynamicOffset(bool),
    /// The code itself names the work offset.
    Offset,
    /// P names the work offset.
    FurtherOffset,
    Return {
        initial: bool,
    },
    Path(PathCode),
    Smoothing(Smoother),
    Stop {
        optional: bool,
    },
    End,
    Spindle(Option<Rotation>),
    SpindleAndFlood(Rotation),
    ToolChange,
    CoolantOn(u8),
    CoolantOff(u8),
    /// M29: the next thread is cut in step with the spindle.
    Rigid,
    TipControl(bool),
    Interpolation {
        in_plane: bool,
    },
    Frame {
        in_workpiece: bool,
    },
    ShortestWay(bool),
    CallCycle,
    Address(Address),
    Statement(StatementWord),
    /// It ends what a program before may have left, and changes nothing else: bit of `settled`. A word that it takes
    /// is 0.
    Settles(u32),
    /// It changes nothing, for this reason.
    Harmless(&'static str),
}

/// Address letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Address {
    /// N.
    BlockNumber,
    /// G and M.
    Code,
    Axis,
    /// I J K.
    Centre,
    /// TX TY TZ, A3 B3 C3.
    Vector,
    Feed,
    Speed,
    Tool,
    LengthRegister,
    /// D of Siemens: the cutting edge.
    Edge,
    RadiusRegister,
    /// P Q R L E: only beside codes that take them.
    Parameter,
    /// CR, R of CR.
    Radius,
    /// AR, IPA.
    Angle,
    Turns,
    /// DR.
    Sense,
    /// R0 RL RR.
    Side,
    /// FMAX.
    RapidFeed,
}

/// Statements and keywords.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum StatementWord {
    ProgramNumber,
    ProgramMark,
    Guard,
    Message,
    Comment,
    BlockDelete,
    Begin,
    EndOfProgram,
    Blank,
    Line,
    Pole,
    Arc,
    ToolCall,
    ToolDef,
    CycleDef,
    CycleCall,
    PlaneSpatial,
    PlaneReset,
    TcpmOn,
    TcpmOff,
    Stop,
    ModalCall,
}

/// How the words of a tilted plane count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Plane {
    /// G68.2.
    Euler,
    /// G268.
    Haas,
}

/// Codes of the path mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum PathCode {
    ExactPath,
    ExactStop,
    Continuous,
    /// G641 to G645.
    Smoothed(u16),
    /// A stop at the end of this block, or the window of exact stops.
    Window,
}

/// Codes of smoothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Smoother {
    /// G5.1 Q.
    Contour,
    /// G187 P E.
    Level,
}
