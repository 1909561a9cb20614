//! Records of motion: FROM, GOTO, GODLTA, GOHOME, RETRCT.

use std::fmt::{self, Display, Formatter};

use super::values::{ClNumber, Numbers, Point};
use crate::cl::text::{Args, ClFault, Span};

/// A motion, or the start point of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionRecord<'a> {
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
        /// Distance in units of the file, positive away from the part.
        distance: f64,
        /// Place of the number, for messages.
        at: Span,
    },
    /// `GOHOME`, `GOHOME/x,y,z[,i,j,k]`.
    Home(Option<Point>),
    /// `RETRCT`.
    Retract,
}

/// GOTO: one point, or a list of points separated by slashes.
pub(crate) fn goto<'a>(args: &mut Args<'a>) -> Result<MotionRecord<'a>, ClFault> {
    let (all, text) = (args.all(), args.text());
    let points = &text[all.start.min(text.len())..];
    if !points.contains(&b'/') || all.start == 0 {
        return Point::parse(args).map(MotionRecord::Goto);
    }
    let mut start = all.start;
    for piece in points.split(|byte| *byte == b'/') {
        let end = start + piece.len();
        let mut one = args.part(start, end);
        let found = one.numbers(&mut [])?;
        if found != 3 {
            return Err(one.wrong_count("3 numbers between slashes", found));
        }
        start = end + 1;
    }
    args.skip_rest();
    Ok(MotionRecord::Points(Numbers::all(args)))
}

/// GODLTA.
pub(crate) fn increment<'a>(args: &mut Args<'_>) -> Result<MotionRecord<'a>, ClFault> {
    let mut ahead = args.clone();
    let first = ahead.next()?;
    let single = first.is_some() && ahead.next().is_ok_and(|second| second.is_none());
    match first {
        Some(arg) if single => {
            args.skip_rest();
            Ok(MotionRecord::DeltaAlongAxis { distance: arg.number()?, at: arg.at })
        }
        _ => Point::parse(args).map(MotionRecord::Delta),
    }
}

/// GOHOME.
pub(crate) fn home<'a>(args: &mut Args<'_>) -> Result<MotionRecord<'a>, ClFault> {
    match args.clone().next()? {
        None => Ok(MotionRecord::Home(None)),
        Some(_) => Point::parse(args).map(|point| MotionRecord::Home(Some(point))),
    }
}

impl Display for MotionRecord<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::From(point) => write!(out, "FROM/{point}"),
            Self::Goto(point) => write!(out, "GOTO/{point}"),
            Self::Points(points) => write!(out, "GOTO/{points}"),
            Self::Delta(step) => write!(out, "GODLTA/{step}"),
            Self::DeltaAlongAxis { distance, .. } => write!(out, "GODLTA/{}", ClNumber(*distance)),
            Self::Home(None) => out.write_str("GOHOME"),
            Self::Home(Some(point)) => write!(out, "GOHOME/{point}"),
            Self::Retract => out.write_str("RETRCT"),
        }
    }
}
