//! One CL record, typed, with numbers as the file has them.
//!
//! Units, modes and what a record means in its context come later, in the interpreter.

pub use super::fault::Span;
use crate::program::{Coolant, CutterSide, Dwell, Spindle, Turning, Units};

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

/// Numbers of a record that may hold any count of them, checked when the record was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numbers<'a> {
    /// The arguments as they stand in the file.
    pub bytes: &'a [u8],
    /// Where they stand.
    pub at: Span,
}

impl<'a> Numbers<'a> {
    /// The numbers, in their order; commas and slashes separate them.
    pub fn values(&self) -> impl Iterator<Item = f64> + 'a {
        let pieces = self.bytes.split(|byte| matches!(byte, b',' | b'/'));
        pieces.filter_map(|piece| super::number::whole(super::args::trimmed(piece)))
    }

    /// The numbers as points.
    pub fn points(&self) -> impl Iterator<Item = Point> + 'a {
        let (mut values, at) = (self.values(), self.at);
        std::iter::from_fn(move || {
            let tip = [values.next()?, values.next()?, values.next()?];
            Some(Point { tip, axis: None, at })
        })
    }
}

/// How a CIRCLE says in which sense it is traversed: by the count of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CircleForm {
    /// 6 numbers: centre and axis; counter-clockwise about the axis (SolidWorks CAM).
    Six,
    /// 7 numbers: a radius behind them; counter-clockwise (Creo, ISO 4343).
    Seven,
    /// 11 numbers: radius, tolerances and tool; clockwise about the axis (NX).
    Eleven,
}

/// A circle, in the units of the file; the next GOTO is the end of the arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre.
    pub centre: [f64; 3],
    /// Its axis, not normalised.
    pub axis: [f64; 3],
    /// Radius, if the form has one.
    pub radius: Option<f64>,
    /// Form.
    pub form: CircleForm,
    /// TIMES,n: the arc and n - 1 full turns.
    pub times: u32,
    /// MOVARC: the angle that the arc must have, degrees.
    pub angle: Option<f64>,
    /// The numbers, for messages.
    pub at: Span,
}

/// `TLON,GOFWD/ (CIRCLE/ c,r),ON,(LINE/ c,e)`: an arc to `e`, begun in the direction of INDIRV.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentArc {
    /// Centre.
    pub centre: [f64; 3],
    /// Radius.
    pub radius: f64,
    /// A point of the line, and its end: where the line meets the circle the arc ends.
    pub line: [[f64; 3]; 2],
    /// `2,INTOF`: the second intersection along the line.
    pub second: bool,
    /// The arguments, for messages.
    pub at: Span,
}

/// What kind of hole a CYCLE makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleKind {
    /// DRILL.
    Drill,
    /// FACE: with a wait at the bottom.
    Face,
    /// CSINK.
    Csink,
    /// THRU.
    Thru,
    /// DEEP, DEEP2, and DRILL,DEEP of NX.
    Deep,
    /// BRKCHP.
    Brkchp,
    /// BORE.
    Bore,
    /// BACK.
    Back,
    /// REAM.
    Ream,
    /// TAP.
    Tap,
    /// CBORE.
    Cbore,
}

impl CycleKind {
    /// Words and kinds; the first word of a kind is the one written.
    pub const WORDS: [(&'static str, CycleKind); 12] = [
        ("DRILL", CycleKind::Drill),
        ("FACE", CycleKind::Face),
        ("CSINK", CycleKind::Csink),
        ("THRU", CycleKind::Thru),
        ("DEEP", CycleKind::Deep),
        ("DEEP2", CycleKind::Deep),
        ("BRKCHP", CycleKind::Brkchp),
        ("BORE", CycleKind::Bore),
        ("BACK", CycleKind::Back),
        ("REAM", CycleKind::Ream),
        ("TAP", CycleKind::Tap),
        ("CBORE", CycleKind::Cbore),
    ];

    /// The word that is written for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(_, kind)| *kind == self).map_or("DRILL", |(word, _)| word)
    }
}

/// Where the tool goes back to after a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Return {
    /// RTRCTO,AUTO: to the level before the cycle.
    Auto,
    /// `RTRCTO,v[,MANUAL]` or `RETURN,v`: to this level.
    Level(f64),
}

/// Most numbers without a word in front of them that a CYCLE may have.
pub const MOST_POSITIONAL: usize = 6;

/// The words of a CYCLE as written; what they mean depends on the CAM system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Kind.
    pub kind: CycleKind,
    /// FEDTO: bottom, signed along the tool axis (NX) or positive into the part (SolidWorks CAM).
    pub fedto: Option<f64>,
    /// DEPTH: positive into the part.
    pub depth: Option<f64>,
    /// A feed with its unit.
    pub feed: Option<(f64, FeedUnit)>,
    /// RAPTO.
    pub rapto: Option<f64>,
    /// CLEAR.
    pub clear: Option<f64>,
    /// RTRCTO or RETURN.
    pub back_to: Option<Return>,
    /// STEP, INCR or SUBPECK: depth of each step.
    pub step: Option<f64>,
    /// 1STPECK: depth of the first step.
    pub first_step: Option<f64>,
    /// DWELL,n.
    pub dwell: Option<f64>,
    /// DWELL,REV,n or REV,n: the wait in turns of the spindle.
    pub dwell_turns: Option<f64>,
    /// BACK,g of BRKCHP: how far back.
    pub back: Option<f64>,
    /// ORIENT,a.
    pub orient: Option<f64>,
    /// Numbers without a word, in their order.
    pub positional: [f64; MOST_POSITIONAL],
    /// How many of them there are.
    pub positionals: usize,
    /// The arguments, for messages.
    pub at: Span,
    /// The depth, for messages.
    pub depth_at: Span,
}

impl Cycle {
    /// A cycle of this kind without any level.
    #[must_use]
    pub const fn new(kind: CycleKind, at: Span) -> Self {
        Cycle {
            kind,
            fedto: None,
            depth: None,
            feed: None,
            rapto: None,
            clear: None,
            back_to: None,
            step: None,
            first_step: None,
            dwell: None,
            dwell_turns: None,
            back: None,
            orient: None,
            positional: [0.0; MOST_POSITIONAL],
            positionals: 0,
            at,
            depth_at: at,
        }
    }
}

/// What `CYCLE/..` without a kind says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleState {
    /// OFF: the GOTOs are motions again.
    Off,
    /// ON: the last cycle is in force again.
    On,
    /// INIT: the next cycle goes back to its initial level (SolidWorks CAM).
    Initial,
    /// CLEAR: the next cycle goes back to its clearance level (SolidWorks CAM).
    Clear,
}

/// Plane of two axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisPlane {
    /// XYPLAN.
    Xy,
    /// YZPLAN.
    Yz,
    /// ZXPLAN.
    Zx,
}

impl AxisPlane {
    /// Words and planes.
    pub const WORDS: [(&'static str, AxisPlane); 3] =
        [("XYPLAN", AxisPlane::Xy), ("YZPLAN", AxisPlane::Yz), ("ZXPLAN", AxisPlane::Zx)];

    /// Direction of its normal.
    #[must_use]
    pub const fn normal(self) -> [f64; 3] {
        match self {
            AxisPlane::Xy => [0.0, 0.0, 1.0],
            AxisPlane::Yz => [1.0, 0.0, 0.0],
            AxisPlane::Zx => [0.0, 1.0, 0.0],
        }
    }
}

/// What one statement says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Record<'a> {
    /// `PARTNO text`, `PARTNO/text`, `PARTNO/'text'`.
    PartName(Text<'a>),
    /// `MACHIN/name,n[,..]`: the name.
    MachineName(Text<'a>),
    /// `UNITS/MM`, `UNITS/INCH`, `UNITS/INCHES`, `UNIT/..`.
    Units(Units),
    /// `TOOL PATH/name,TOOL,toolname`: the name.
    ToolPath(Text<'a>),
    /// `END-OF-PATH`.
    EndOfPath,
    /// `LOADTL/n[,n..][,LENGTH,l][,OSETNO,o][,ADJUST,h]`, `LOAD/TOOL,n[,..]`.
    Tool(Tool),
    /// `SELECT/TOOL,n`, `SELCTL/n`.
    Preselect(u32),
    /// `CUTTER/d[,r[,e,f,a,b,h]]`, `TLDATA/MILL,d,r,..`, `TLDATA/DRILL[,word],d,..`: of the tool called next.
    Cutter(Cutter),
    /// `$$-> CUTTER / d`: of the tool called last.
    CutterOfLastTool(Cutter),
    /// `SET/OFSETL,n`: length offset register of the tool called last.
    LengthOffset {
        /// Register.
        register: u32,
        /// The number, for messages.
        at: Span,
    },
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
    /// `CSYS/` with the 12 numbers of a 3×4 matrix by rows: its third column is the tool axis (SolidWorks CAM).
    Setup(FrameRecord),
    /// `TRNTYP/WORLD,0,0,0`: the points of all CSYS are in one frame.
    World,
    /// `ORIGIN/x,y,z`, `ORIGIN/NOMORE`, `ORIGIN/0`: subtracted from every point.
    Origin(Option<[f64; 3]>),
    /// `TRANS/x,y,z`, `TRANS/NOMORE`, `TRANS/0`: added to every point.
    Translation {
        /// As written; `None` ends it.
        by: Option<[f64; 3]>,
        /// The arguments, for messages.
        at: Span,
    },
    /// `TRACUT/` with the 12 numbers of a 3×4 matrix by rows, `TRACUT/NOMORE`, `TRACUT/0`.
    Transformation {
        /// As written; `None` ends it.
        matrix: Option<[f64; 12]>,
        /// The arguments, for messages.
        at: Span,
    },
    /// `FROM/x,y,z[,i,j,k]`.
    From(Point),
    /// `GOTO/x,y,z[,i,j,k]`.
    Goto(Point),
    /// `GOTO/x,y,z / x,y,z ..`: several points.
    Points(Numbers<'a>),
    /// `GODLTA/dx,dy,dz[,i,j,k]`.
    Delta(Point),
    /// `GODLTA/d`: along the tool axis.
    DeltaAlongAxis {
        /// Away from the part, if positive.
        distance: f64,
        /// The number, for messages.
        at: Span,
    },
    /// `GOHOME`, `GOHOME/x,y,z[,i,j,k]`.
    Home(Option<Point>),
    /// `RAPID`, `FEDRAT/RAPID`.
    Rapid,
    /// `CIRCLE/..` with 6, 7 or 11 numbers and `TIMES,n`; `MOVARC/x,y,z,i,j,k,r,ANGLE,degrees`.
    Circle(Circle),
    /// `AUTOPS`: the plane of the next TLON lies at the current position.
    AutomaticPlane,
    /// `INDIRV/i,j,k`: direction in which the next TLON begins.
    Direction {
        /// Not normalised.
        vector: [f64; 3],
        /// The numbers, for messages.
        at: Span,
    },
    /// `TLON,GOFWD/ ..`.
    TangentArc(TangentArc),
    /// `NURBS/`: knots and control points follow.
    Nurbs,
    /// `KNOT/k,k..`.
    Knots(Numbers<'a>),
    /// `CNTRL/x,y,z`.
    ControlPoint(Point),
    /// `CYCLE/kind,..`.
    Cycle(Cycle),
    /// `CYCLE/OFF`, `CYCLE/ON`, `CYCLE/INIT`, `CYCLE/CLEAR`.
    CycleState {
        /// Which.
        state: CycleState,
        /// The word, for messages.
        at: Span,
    },
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
    /// `FEDRAT/INVERS,AUTO`, `INVERSE/ON`, `INVERSE/OFF`: the CAM system asks for inverse-time feed.
    InverseTime(bool),
    /// `SPINDL/..` with RPM, CLW, CCLW, ON, OFF and a number in any order.
    Spindle(Spindle),
    /// `COOLNT/ON|OFF|FLOOD|MIST|THRU|AIR`.
    Coolant(Coolant),
    /// `CUTCOM/LEFT|RIGHT[,n][,XYPLAN]`, `CUTCOM/ON`, `CUTCOM/OFF`.
    Compensation {
        /// Side.
        side: CutterSide,
        /// Offset register.
        register: Option<u32>,
        /// Plane.
        plane: Option<AxisPlane>,
    },
    /// `DELAY/s`, `DELAY/n,REV`.
    Delay {
        /// How long.
        dwell: Dwell,
        /// The number, for messages.
        at: Span,
    },
    /// `LINTOL/t`, `LINTOL/OFF`.
    Tolerance {
        /// In units of the file; `None`: OFF.
        value: Option<f64>,
        /// The argument, for messages.
        at: Span,
    },
    /// `CLEARP/XYPLAN,d`, `CLEARP/a,b,c,d`.
    ClearancePlane {
        /// Normal, not normalised.
        normal: [f64; 3],
        /// `normal · p = distance`.
        distance: f64,
        /// The arguments, for messages.
        at: Span,
    },
    /// `RETRCT`.
    Retract,
    /// `ROTABL/SHORT`, `ROTABL/NEXT,CLW|CCLW`.
    Turning(Turning),
    /// `OPSTOP`.
    OptionalStop,
    /// `STOP`.
    Stop,
    /// `END`.
    End,
    /// `FINI`.
    Fini,
    /// `REWIND`, `REWIND/n`.
    Rewind,
    /// `PPRINT text`.
    Message(Text<'a>),
    /// `INSERT text`.
    Insert(Text<'a>),
    /// `AUXFUN/n[,NEXT|NOW]`, `PREFUN/n`.
    Code {
        /// `M` or `G`.
        letter: u8,
        /// Its number.
        number: u32,
        /// The number, for messages.
        at: Span,
    },
    /// `DEFSUB/n`: what follows up to ENDSUB is done where it is called.
    DefineSubprogram(u32),
    /// `ENDSUB`.
    EndSubprogram,
    /// `CALSUB/n`.
    CallSubprogram {
        /// Its number.
        number: u32,
        /// The number, for messages.
        at: Span,
    },
    /// Nothing that matters.
    Inert,
}
