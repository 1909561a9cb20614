//! Records of curves (NX): NURBS, KNOT, CNTRL.

use std::fmt::{self, Display, Formatter};

use super::values::{Numbers, Point};
use crate::cl::text::{Args, ClFault};

/// A record of a curve that begins at the position of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NurbsRecord<'a> {
    /// `NURBS/`: begin of a curve; knots and control points follow.
    Begin,
    /// `KNOT/k,k..`.
    Knots(Numbers<'a>),
    /// `CNTRL/x,y,z`.
    ControlPoint(Point),
}

/// KNOT: one number or more.
pub(crate) fn knots<'a>(args: &mut Args<'a>) -> Result<NurbsRecord<'a>, ClFault> {
    match args.numbers(&mut [])? {
        0 => Err(args.wrong_count("at least one number", 0)),
        _ => Ok(NurbsRecord::Knots(Numbers::all(args))),
    }
}

/// CNTRL.
pub(crate) fn control_point<'a>(args: &mut Args<'_>) -> Result<NurbsRecord<'a>, ClFault> {
    let tip = args.exactly()?;
    Ok(NurbsRecord::ControlPoint(Point { tip, axis: None, at: args.all() }))
}

impl Display for NurbsRecord<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Begin => out.write_str("NURBS/"),
            Self::Knots(knots) => write!(out, "KNOT/{knots}"),
            Self::ControlPoint(point) => write!(out, "CNTRL/{point}"),
        }
    }
}
