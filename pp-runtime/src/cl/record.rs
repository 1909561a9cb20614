//! One CL record, typed, with numbers as the file has them.
//!
//! Units, modes and what a record means in its context come later, in the interpreter.

pub use super::fault::Span;
use crate::program::{Coolant, Spindle, Units};

/// A point, perhaps with a tool axis, in the units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// `x, y, z`.
    pub tip: [f64; 3],
    /// `i, j, k`, not normalised.
    pub axis: Option<[f64; 3]>,
    /// The numbers, for messages.
    pub at: Span,
}

/// Unit of a feed rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedUnit {
    /// PERMIN or no word: units of the file per minute.
    PerMinute,
    /// PERREV: units of the file per revolution.
    PerRevolution,
    /// MMPM.
    MillimetresPerMinute,
    /// MMPR.
    MillimetresPerRevolution,
    /// IPM.
    InchesPerMinute,
    /// IPR.
    InchesPerRevolution,
}

/// Size of a cutter, in the units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cutter {
    /// Diameter.
    pub diameter: f64,
    /// Corner radius, if the record gives one.
    pub corner_radius: Option<f64>,
}

/// A tool record, lengths in the units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tool {
    /// Number of the tool.
    pub number: u32,
    /// LENGTH: gauge length.
    pub length: Option<f64>,
    /// ADJUST or OSETNO: length offset register.
    pub offset: Option<u32>,
}

/// Where the output frame lies in the model: directions of its axes and its origin, in the units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameRecord {
    /// Directions of X, Y and Z of the frame.
    pub axes: [[f64; 3]; 3],
    /// Its origin.
    pub origin: [f64; 3],
    /// The numbers, for messages.
    pub at: Span,
}

/// Text of a record without blanks, slash and quotes around it, as the file encodes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Text<'a> {
    /// The bytes.
    pub bytes: &'a [u8],
    /// Where they stand.
    pub at: Span,
}

/// What one statement says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Record<'a> {
    /// `PARTNO text`, `PARTNO/text`, `PARTNO/'text'`.
    PartName(Text<'a>),
    /// `UNITS/MM`, `UNITS/INCH`, `UNITS/INCHES`, `UNIT/..`.
    Units(Units),
    /// `TOOL PATH/name,TOOL,toolname`: the name.
    ToolPath(Text<'a>),
    /// `LOADTL/n[,n..][,LENGTH,l][,OSETNO,o][,ADJUST,h]`, `LOAD/TOOL,n[,..]`.
    Tool(Tool),
    /// `SELECT/TOOL,n`, `SELCTL/n`.
    Preselect(u32),
    /// `CUTTER/d[,r[,e,f,a,b,h]]`, `TLDATA/MILL,d,r,..`, `TLDATA/DRILL[,word],d,..`: of the tool called next.
    Cutter(Cutter),
    /// `$$-> CUTTER / d`: of the tool called last.
    CutterOfLastTool(Cutter),
    /// `MULTAX`, `MULTAX/ON`, `MULTAX/OFF`.
    MultiAxis(bool),
    /// `TLAXIS/i,j,k`.
    ToolAxis {
        /// Not normalised.
        axis: [f64; 3],
        /// The numbers, for messages.
        at: Span,
    },
    /// `MSYS/x,y,z,i1,j1,k1,i2,j2,k2`, `$$-> CSYS / ..`, `$$*CATIA0` and three rows.
    Frame(FrameRecord),
    /// `FROM/x,y,z[,i,j,k]`.
    From(Point),
    /// `GOTO/x,y,z[,i,j,k]`.
    Goto(Point),
    /// `RAPID`, `FEDRAT/RAPID`.
    Rapid,
    /// `FEDRAT/n[,unit]`, `FEDRAT/unit,n`.
    Feed {
        /// As written.
        value: f64,
        /// As written.
        unit: FeedUnit,
        /// The number, for messages.
        at: Span,
        /// The unit's word; the number again if there is none.
        unit_at: Span,
    },
    /// `SPINDL/..` with RPM, CLW, CCLW, ON, OFF and a number in any order.
    Spindle(Spindle),
    /// `COOLNT/ON|OFF|FLOOD|MIST|THRU|AIR`.
    Coolant(Coolant),
    /// `OPSTOP`.
    OptionalStop,
    /// `STOP`.
    Stop,
    /// `PPRINT text`.
    Message(Text<'a>),
    /// Nothing that matters.
    Inert,
}
