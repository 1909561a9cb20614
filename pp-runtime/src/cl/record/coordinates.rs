//! Records of units, tool axis, frames and coordinate transforms.

use std::fmt::{self, Display, Formatter};

use super::values::{AxisPlane, ClNumber, ClNumbers, write_on_off};
use crate::cl::text::{Args, ClFault, Span, quoted};
use crate::cl::vector::{cross, distance, dot, length};
use crate::diag::code::cl;
use crate::program::Units;

/// Largest permitted deviation of the axes of a frame from right-handed perpendicular unit vectors.
const PERPENDICULAR: f64 = 1e-3;

/// What a frame is stated in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameBase {
    /// The model: MSYS of NX, CSYS and CAMERA of Creo, the matrix of CATIA.
    Model,
    /// The workpiece frame, in which the points are without it: MCSYS.
    Workpiece,
    /// The workpiece frame in the output of Autodesk: MCS. That of Surfcam is a view, and the points may not be in it.
    WorkpieceOrView,
}

/// Output frame: unit vectors of its axes, and its origin in units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameRecord {
    /// Unit vectors of X, Y and Z of the frame.
    pub axes: [[f64; 3]; 3],
    /// Origin of the frame.
    pub origin: [f64; 3],
    /// What axes and origin are stated in.
    pub base: FrameBase,
    /// Place of the numbers, for messages.
    pub at: Span,
}

impl FrameRecord {
    /// The workpiece frame itself.
    pub(crate) fn of_workpiece(at: Span) -> FrameRecord {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        FrameRecord { axes, origin: [0.0; 3], base: FrameBase::Workpiece, at }
    }

    /// Frame from its origin and its X and Y.
    fn from_two_axes([origin, x, y]: [[f64; 3]; 3], base: FrameBase, at: Span) -> FrameRecord {
        FrameRecord { axes: [x, y, cross(x, y)], origin, base, at }
    }

    /// Frame from the rows of a 3×4 matrix: the first three columns are its axes, the fourth is its origin.
    pub(crate) fn from_rows(n: &[f64; 12], at: Span) -> FrameRecord {
        let column = |i: usize| [n[i], n[4 + i], n[8 + i]];
        FrameRecord { axes: [column(0), column(1), column(2)], origin: column(3), base: FrameBase::Model, at }
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
    /// `MULTAX`, `MULTAX/ON`, `MULTAX/OFF`, `TCP/ON`, `TCP/OFF`.
    MultiAxis(bool),
    /// `TLAXIS/i,j,k`.
    ToolAxis {
        /// Not normalised.
        axis: [f64; 3],
        /// Place of the numbers, for messages.
        at: Span,
    },
    /// `MSYS/x,y,z,i1,j1,k1,i2,j2,k2`, `$$-> CSYS / ..`, `CAMERA/ ..`, `$$*CATIA0` and three rows; `MCS/`, `MCSYS/`.
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
        Err(cl::UNITS.cl_fault("unit", arg.at, format!("{} is not a known unit", quoted(arg.text)), "write MM or INCH"))
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

/// TCP: ON before and OFF after the points of a multi-axis section, beside MULTAX (script of *Mori APT*). The points
/// are those of the tip in any case.
pub(crate) fn tip_control(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    args.one_of(&[("ON", true), ("OFF", false)]).map(CoordinateRecord::MultiAxis)
}

/// TLAXIS.
pub(crate) fn tool_axis(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let axis = args.exactly()?;
    Ok(CoordinateRecord::ToolAxis { axis, at: args.all() })
}

/// MSYS, SYS.
pub(crate) fn machine_system(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let [x, y, z, i, j, k, l, m, n] = args.exactly()?;
    let vectors = [[x, y, z], [i, j, k], [l, m, n]];
    Ok(CoordinateRecord::Frame(FrameRecord::from_two_axes(vectors, FrameBase::Model, args.all())))
}

/// CSYS in a comment of Creo; CAMERA, which its G-POST format has in place of it.
pub(crate) fn matrix(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let numbers = args.exactly()?;
    Ok(CoordinateRecord::Frame(FrameRecord::from_rows(&numbers, args.all())))
}

/// MCS: axes X, Y, Z and origin of the work plane (`right`, `up`, `forward`, `workOrigin` in the script of *CAMplete
/// APT*).
pub(crate) fn work_plane(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let n: [f64; 12] = args.exactly()?;
    let [x, y, z, origin] = [0, 3, 6, 9].map(|first| [n[first], n[first + 1], n[first + 2]]);
    let frame = FrameRecord { axes: [x, y, z], origin, base: FrameBase::WorkpieceOrView, at: args.all() };
    Ok(CoordinateRecord::Frame(frame))
}

/// MCSYS: number of the work offset, origin, X and Y of the work plane (script of *Mori APT*).
pub(crate) fn numbered_work_plane(args: &mut Args<'_>) -> Result<CoordinateRecord, ClFault> {
    let at = args.all();
    args.keyword("NUM")?;
    let number = args.needed()?;
    if number.integer()? != 1 {
        return Err(cl::FRAME.cl_fault(
            args.name(),
            number.at,
            format!(
                "MCSYS with work offset {} is refused: its place on the machine is not stated",
                quoted(number.text)
            ),
            "where all MCSYS of the file have this number, write NUM,1 in each and set `work_offset`; else post the operations of \
             each number as a file of its own",
        ));
    }
    let mut vectors = [[0.0; 3]; 3];
    for (word, vector) in ["POINT", "VECTOR", "VECTOR"].into_iter().zip(&mut vectors) {
        args.keyword(word)?;
        for place in vector {
            *place = args.needed()?.number()?;
        }
    }
    Ok(CoordinateRecord::Frame(FrameRecord::from_two_axes(vectors, FrameBase::Workpiece, at)))
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
        return Err(cl::FRAME.cl_fault(
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

/// Writes a frame. One in the model is MSYS where its Z is X × Y, else the comment of Creo.
fn write_frame(frame: &FrameRecord, out: &mut Formatter<'_>) -> fmt::Result {
    let FrameRecord { axes: [x, y, z], origin, base, .. } = frame;
    let [origin, x, y, last] = [origin, x, y, z].map(|vector| ClNumbers(vector));
    match base {
        FrameBase::Model if distance(cross(frame.axes[0], frame.axes[1]), *z) > 0.0 => {
            write!(out, "$$-> CSYS / {}", ClNumbers(&frame.rows()))
        }
        FrameBase::Model => write!(out, "MSYS/{origin},{x},{y}"),
        FrameBase::Workpiece => write!(out, "MCSYS/NUM,1,POINT,{origin},VECTOR,{x},VECTOR,{y}"),
        FrameBase::WorkpieceOrView => write!(out, "MCS/{x},{y},{last},{origin}"),
    }
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
