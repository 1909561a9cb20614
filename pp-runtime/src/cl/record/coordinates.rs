//! Records of units, tool axis, frames and coordinate transforms.

use std::fmt::{self, Display, Formatter};

use super::values::{AxisPlane, ClNumber, ClNumbers, write_on_off};
use crate::cl::text::{Args, ClFault, Span, quoted};
use crate::cl::vector::{cross, distance, dot, length};
use crate::program::Units;

/// Largest permitted deviation of the axes of a frame from right-handed perpendicular unit vectors.
const PERPENDICULAR: f64 = 1e-3;

/// Output frame in the model: unit vectors of its axes, and its origin in units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameRecord {
    /// Unit vectors of X, Y and Z of the frame.
    pub axes: [[f64; 3]; 3],
    /// Origin of the frame.
    pub origin: [f64; 3],
    /// Place of the numbers, for messages.
    pub at: Span,
}

impl FrameRecord {
    /// Frame from its origin and its X and Y, as in MSYS.
    fn from_two_axes(n: &[f64; 9], at: Span) -> FrameRecord {
        let (x, y) = ([n[3], n[4], n[5]], [n[6], n[7], n[8]]);
        FrameRecord { axes: [x, y, cross(x, y)], origin: [n[0], n[1], n[2]], at }
    }

    /// Frame from the rows of a 3×4 matrix: the first three columns are its axes, the fourth is its origin.
    pub(crate) fn from_rows(n: &[f64; 12], at: Span) -> FrameRecord {
        let column = |i: usize| [n[i], n[4 + i], n[8 + i]];
        FrameRecord { axes: [column(0), column(1), column(2)], origin: column(3), at }
    }

    /// Whether the axes are perpendicular, right-handed unit vectors.
    pub(crate) fn is_rigid(&self) -> bool {
        let [x, y, z] = self.axes;
        let unit_length = self.axes.iter().all(|axis| (length(*axis) - 1.0).abs() <= PERPENDICULAR);
        unit_length && dot(x, y).abs() <= PERPENDICULAR && distance(cross(x, y), z) <= PERPENDICULAR
    }

    /// Rows of the 3×4 matrix of the frame.
    fn rows(&self) -> [f64; 12] {
        let [x, y, z] = self.axes;
        let o = self.origin;
        [x[0], y[0], z[0], o[0], x[1], y[1], z[1], o[1], x[2], y[2], z[2], o[2]]
    }
}

/// A record on which the meaning of the following coordinates depends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CoordinateRecord {
    /// `UNITS/MM`, `UNITS/INCH`, `UNITS/INCHES`, `UNIT/..`.
    Units(Units),
    /// `MULTAX`, `MULTAX/ON`, `MULTAX/OFF`.
    MultiAxis(bool),
    /// `TLAXIS/i,j,k`.
    ToolAxis {
        /// Not normalised.
        axis: [f64; 3],
        /// Place of the numbers, for messages.
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
        /// Translation in units of the file; `None` ends it.
        by: Option<[f64; 3]>,
        /// Place of the arguments, for messages.
        at: Span,
    },
    /// `TRACUT/` with the 12 numbers of a 3×4 matrix by rows, `TRACUT/NOMORE`, `TRACUT/0`.
    Transformation {
        /// Matrix, its translation in units of the file; `None` ends it.
        matrix: Option<[f64; 12]>,
        /// Place of the arguments, for messages.
        at: Span,
    },
    /// `CLEARP/XYPLAN,d`, `CLEARP/a,b,c,d`.
    ClearancePlane {
        /// Normal, not normalised.
        normal: [f64; 3],
        /// `normal · p = distance`.
        distance: f64,
        /// Place of the arguments, for messages.
        at: Span,
    },
}

/// UNITS, UNIT.
pub(crate) fn units(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let arg = args.needed()?;
    if arg.is("MM") {
        Ok(CoordinateRecord::Units(Units::Millimetres))
    } else if arg.is("INCH") || arg.is("INCHES") || arg.is("IN") {
        Ok(CoordinateRecord::Units(Units::Inches))
    } else {
        Err(ClFault::new("unit", arg.at, format!("{} is not a known unit", quoted(arg.text)), "write MM or INCH"))
    }
}

/// MULTAX. Without arguments it means ON.
pub(crate) fn multi_axis(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let on = match args.clone().next()? {
        None => true,
        Some(_) => args.one_of(&[("ON", true), ("OFF", false)])?,
    };
    Ok(CoordinateRecord::MultiAxis(on))
}

/// TLAXIS.
pub(crate) fn tool_axis(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let axis = args.exactly()?;
    Ok(CoordinateRecord::ToolAxis { axis, at: args.all() })
}

/// MSYS, SYS.
pub(crate) fn machine_system(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let numbers = args.exactly()?;
    Ok(CoordinateRecord::Frame(FrameRecord::from_two_axes(&numbers, args.all())))
}

/// CSYS of SolidWorks CAM.
pub(crate) fn setup(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let numbers = args.exactly()?;
    Ok(CoordinateRecord::Setup(FrameRecord::from_rows(&numbers, args.all())))
}

/// TRNTYP.
pub(crate) fn world(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    args.keyword("WORLD")?;
    let numbers: [f64; 3] = args.exactly()?;
    if numbers.iter().any(|value| value.abs() > 0.0) {
        return Err(ClFault::new(
            args.name(),
            args.all(),
            "TRNTYP with numbers other than 0 is refused: its effect on the coordinates is not known",
            "if all points of the file are in one common frame, write TRNTYP/WORLD,0,0,0; else post each set-up as a file of its own",
        ));
    }
    Ok(CoordinateRecord::World)
}

/// ORIGIN.
pub(crate) fn origin(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    unless_cancelled(args).map(CoordinateRecord::Origin)
}

/// TRANS.
pub(crate) fn translation(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let by = unless_cancelled(args)?;
    Ok(CoordinateRecord::Translation { by, at: args.all() })
}

/// TRACUT.
pub(crate) fn transformation(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let matrix = unless_cancelled(args)?;
    Ok(CoordinateRecord::Transformation { matrix, at: args.all() })
}

/// CLEARP.
pub(crate) fn clearance_plane(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let at = args.all();
    let first = args.needed()?;
    if let Some(plane) = first.among(&AxisPlane::WORDS) {
        let distance = args.needed()?.number()?;
        return Ok(CoordinateRecord::ClearancePlane { normal: plane.normal(), distance, at });
    }
    let mut numbers = [first.number()?, 0.0, 0.0, 0.0];
    for place in &mut numbers[1..] {
        *place = args.needed()?.number()?;
    }
    let [a, b, c, distance] = numbers;
    Ok(CoordinateRecord::ClearancePlane { normal: [a, b, c], distance, at })
}

/// Reads `N` numbers, or `NOMORE` or a single `0`, which means `None`.
fn unless_cancelled<const N: usize>(args: &mut Args<'_>) -> Result<Option<[f64; N]>, ClFault> {
    let mut ahead = args.clone();
    if let Some(first) = ahead.next()? {
        let none = first.is("NOMORE") || (first.looks_numeric() && first.number()?.abs() < f64::MIN_POSITIVE);
        if none && ahead.next()?.is_none() {
            *args = ahead;
            return Ok(None);
        }
    }
    args.exactly().map(Some)
}

/// Writes a frame as MSYS where its Z is X × Y, else as the comment of Creo.
fn write_frame(frame: &FrameRecord, out: &mut Formatter<'_>) -> fmt::Result {
    let [x, y, z] = frame.axes;
    if distance(cross(x, y), z) > 0.0 {
        return write!(out, "$$-> CSYS / {}", ClNumbers(&frame.rows()));
    }
    write!(out, "MSYS/{},{},{}", ClNumbers(&frame.origin), ClNumbers(&x), ClNumbers(&y))
}

fn write_change(word: &str, by: Option<&[f64]>, out: &mut Formatter<'_>) -> fmt::Result {
    match by {
        Some(by) => write!(out, "{word}/{}", ClNumbers(by)),
        None => write!(out, "{word}/NOMORE"),
    }
}

impl Display for CoordinateRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Units(Units::Millimetres) => out.write_str("UNITS/MM"),
            Self::Units(Units::Inches) => out.write_str("UNITS/INCH"),
            Self::MultiAxis(on) => write_on_off("MULTAX", *on, out),
            Self::ToolAxis { axis, .. } => write!(out, "TLAXIS/{}", ClNumbers(axis)),
            Self::Frame(frame) => write_frame(frame, out),
            Self::Setup(frame) => write!(out, "CSYS/{}", ClNumbers(&frame.rows())),
            Self::World => out.write_str("TRNTYP/WORLD,0,0,0"),
            Self::Origin(by) => write_change("ORIGIN", by.as_ref().map(|by| &by[..]), out),
            Self::Translation { by, .. } => write_change("TRANS", by.as_ref().map(|by| &by[..]), out),
            Self::Transformation { matrix, .. } => {
                write_change("TRACUT", matrix.as_ref().map(|matrix| &matrix[..]), out)
            }
            Self::ClearancePlane { normal, distance, .. } => {
                write!(out, "CLEARP/{},{}", ClNumbers(normal), ClNumber(*distance))
            }
        }
    }
}
