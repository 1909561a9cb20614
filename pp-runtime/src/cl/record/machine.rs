//! Records of the machine's state: rapid and feed, spindle, coolant, cutter compensation, dwell, tolerance, rotary
//! direction.

use std::fmt::{self, Display, Formatter};

use super::feed::FeedRecord;
use super::spindle::write_spindle;
use super::values::{AxisPlane, ClNumber, word_of, write_on_off};
use crate::cl::text::{Args, ClFault, Span};
use crate::diag::code::cl;
use crate::program::{Coolant, CutterSide, Dwell, Pressure, RotaryDirection, Rotation, Spindle};

/// A record that sets a state of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MachineRecord {
    /// `RAPID`, `FEDRAT/RAPID`.
    Rapid,
    /// `FEDRAT/n[,unit]`, `FEDRAT/unit,n`.
    Feed(FeedRecord),
    /// `FEDRAT/INVERS,AUTO|OFF`, `INVERSE/ON`, `INVERSE/OFF`: the CAM system asks for inverse-time feed.
    InverseTime(bool),
    /// `SPINDL/..` with RPM, CLW, CCLW, ON, OFF and a number in any order.
    Spindle(Spindle),
    /// `COOLNT/ON|OFF|FLOOD|MIST|AIR`, `COOLNT/THRU[,LOW|MEDIUM|HIGH]`.
    Coolant(Coolant),
    /// `COOLNT/ON|FLOOD|MIST,LOW|MEDIUM|HIGH`.
    CoolantAt {
        /// Kind of coolant: on, flood or mist.
        kind: Coolant,
        /// Its pressure.
        pressure: Pressure,
        /// Place of the pressure, for messages.
        at: Span,
    },
    /// `CUTCOM/LEFT|RIGHT[,n][,XYPLAN]`, `CUTCOM/ON`, `CUTCOM/OFF`.
    Compensation {
        /// Side of the path.
        side: CutterSide,
        /// Offset register (D).
        register: Option<u32>,
        /// Plane of the compensation.
        plane: Option<AxisPlane>,
    },
    /// `$$-> CUTCOM_GEOMETRY_TYPE / OUTPUT_ON_CENTER`, `.. / OUTPUT_ON_PROFILE` of Creo.
    CompensatedPath {
        /// The points of a path with CUTCOM are those of the centre of the tool; else of the contour.
        of_centre: bool,
        /// Place of the word, for messages.
        at: Span,
    },
    /// `DELAY/s`, `DELAY/n,REV`.
    Delay {
        /// Duration of the dwell.
        dwell: Dwell,
        /// Place of the number, for messages.
        at: Span,
    },
    /// `LINTOL/t`, `LINTOL/OFF`.
    Tolerance {
        /// Tolerance in units of the file; `None`: OFF.
        value: Option<f64>,
        /// Place of the argument, for messages.
        at: Span,
    },
    /// `ROTABL/SHORT`, `ROTABL/NEXT,CLW|CCLW`.
    RotaryDirection(RotaryDirection),
}

/// FEDRAT.
pub(crate) fn feed(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let first = args.needed()?;
    if first.is("RAPID") {
        return Ok(MachineRecord::Rapid);
    }
    if first.is("INVERS") {
        return args.one_of(&[("AUTO", true), ("OFF", false)]).map(MachineRecord::InverseTime);
    }
    FeedRecord::parse(first, args).map(MachineRecord::Feed)
}

/// INVERSE.
pub(crate) fn inverse_time(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    args.one_of(&[("ON", true), ("OFF", false)]).map(MachineRecord::InverseTime)
}

const COOLANTS: [(&str, Coolant); 6] = [
    ("ON", Coolant::On),
    ("OFF", Coolant::Off),
    ("FLOOD", Coolant::Flood),
    ("MIST", Coolant::Mist),
    ("THRU", Coolant::Through),
    ("AIR", Coolant::Air),
];

/// COOLNT.
pub(crate) fn coolant(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let kind = args.one_of(&COOLANTS)?;
    let Some(arg) = args.next()? else { return Ok(MachineRecord::Coolant(kind)) };
    let pressure = arg.among(&Pressure::WORDS).ok_or_else(|| args.not_understood(arg))?;
    match kind {
        Coolant::Through => Ok(MachineRecord::Coolant(Coolant::ThroughAt(pressure))),
        Coolant::On | Coolant::Flood | Coolant::Mist => Ok(MachineRecord::CoolantAt { kind, pressure, at: arg.at }),
        Coolant::Off | Coolant::Air | Coolant::ThroughAt(_) => Err(args.not_understood(arg)),
    }
}

const SIDES: [(&str, CutterSide); 4] =
    [("OFF", CutterSide::Off), ("ON", CutterSide::On), ("LEFT", CutterSide::Left), ("RIGHT", CutterSide::Right)];

/// CUTCOM.
pub(crate) fn compensation(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let mut side = args.one_of(&SIDES)?;
    if side == CutterSide::On
        && let Some(stated) = args.clone().next()?.and_then(|arg| arg.among(&SIDES[2..]))
    {
        // Generative Machining APT of HSMWorks writes `CUTCOM/ON, LEFT, n`.
        args.next()?;
        side = stated;
    }
    let (mut register, mut plane) = (None, None);
    while side != CutterSide::Off
        && let Some(arg) = args.next()?
    {
        let known = arg.among(&AxisPlane::WORDS);
        if arg.looks_numeric() && register.is_none() {
            register = Some(arg.integer()?);
        } else if arg.is("OSETNO") && register.is_none() {
            // Script of *Mori APT*: `CUTCOM/ LEFT, XYPLAN, OSETNO, n`.
            register = Some(args.needed()?.integer()?);
        } else if known.is_some() && plane.is_none() {
            plane = known;
        } else {
            return Err(args.not_understood(arg));
        }
    }
    Ok(MachineRecord::Compensation { side, register, plane })
}

/// DELAY.
pub(crate) fn delay(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let arg = args.needed()?;
    let value = arg.number()?;
    if value < 0.0 {
        return Err(cl::VALUE.cl_fault("DELAY", arg.at, "DELAY must not be negative", "write DELAY/seconds"));
    }
    let dwell = match args.next()? {
        None => Dwell::Seconds(value),
        Some(word) if word.is("REV") => Dwell::Revolutions(value),
        Some(word) => return Err(args.not_understood(word)),
    };
    Ok(MachineRecord::Delay { dwell, at: arg.at })
}

/// LINTOL.
pub(crate) fn tolerance(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let arg = args.needed()?;
    let value = if arg.is("OFF") { None } else { Some(arg.number()?) };
    Ok(MachineRecord::Tolerance { value, at: arg.at })
}

const ROTATIONS: [(&str, Rotation); 2] = [("CLW", Rotation::Clockwise), ("CCLW", Rotation::CounterClockwise)];

/// ROTABL.
pub(crate) fn rotary_direction(args: &mut Args<'_>) -> Result<MachineRecord, ClFault> {
    let arg = args.needed()?;
    if arg.is("SHORT") {
        return Ok(MachineRecord::RotaryDirection(RotaryDirection::Shortest));
    }
    if arg.is("NEXT") {
        return args
            .one_of(&ROTATIONS)
            .map(|rotation| MachineRecord::RotaryDirection(RotaryDirection::Towards(rotation)));
    }
    // An empty place between commas is reported first.
    while args.next()?.is_some() {}
    Err(cl::FRAME.cl_fault(
        args.name(),
        args.all(),
        "this form of ROTABL is refused: points after it may be in the frame that rotates with the table, and where it rotates about \
         is not stated",
        "output the points in the frame of the part, with i, j, k in each GOTO, and no table rotations; delete this line only where \
         each GOTO after it has such i, j, k (not TLAXIS, and not 0, 0, 1); ROTABL/SHORT and ROTABL/NEXT,CLW|CCLW are read",
    ))
}

/// CLAMP with these words leaves the clamps of the rotary axes to the postprocessor (script of *Mori APT*): no effect.
pub(crate) const CLAMPS_LEFT_TO_POST: [&str; 2] = ["CLAMP/TABLE,ALL,AUTO", "CLAMP/TABLE,ALL,OFF"];

fn write_compensation(
    side: CutterSide,
    register: Option<u32>,
    plane: Option<AxisPlane>,
    out: &mut Formatter<'_>,
) -> fmt::Result {
    write!(out, "CUTCOM/{}", word_of(&SIDES, &side))?;
    if let Some(register) = register {
        write!(out, ",{register}")?;
    }
    plane.map_or(Ok(()), |plane| write!(out, ",{}", word_of(&AxisPlane::WORDS, &plane)))
}

impl Display for MachineRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rapid => out.write_str("RAPID"),
            Self::Feed(feed) => feed.fmt(out),
            Self::InverseTime(on) => write_on_off("INVERSE", *on, out),
            Self::Spindle(spindle) => write_spindle(*spindle, out),
            Self::Coolant(Coolant::ThroughAt(pressure)) => {
                write!(out, "COOLNT/THRU,{}", word_of(&Pressure::WORDS, pressure))
            }
            Self::CoolantAt { kind, pressure, .. } => {
                write!(out, "COOLNT/{},{}", word_of(&COOLANTS, kind), pressure.word())
            }
            Self::Coolant(coolant) => write!(out, "COOLNT/{}", word_of(&COOLANTS, coolant)),
            Self::Compensation { side, register, plane } => write_compensation(*side, *register, *plane, out),
            Self::CompensatedPath { of_centre, .. } => {
                let path = if *of_centre { "OUTPUT_ON_CENTER" } else { "OUTPUT_ON_PROFILE" };
                write!(out, "$$-> CUTCOM_GEOMETRY_TYPE / {path}")
            }
            Self::Delay { dwell: Dwell::Seconds(value), .. } => write!(out, "DELAY/{}", ClNumber(*value)),
            Self::Delay { dwell: Dwell::Revolutions(value), .. } => write!(out, "DELAY/{},REV", ClNumber(*value)),
            Self::Tolerance { value: Some(value), .. } => write!(out, "LINTOL/{}", ClNumber(*value)),
            Self::Tolerance { value: None, .. } => out.write_str("LINTOL/OFF"),
            Self::RotaryDirection(RotaryDirection::Shortest) => out.write_str("ROTABL/SHORT"),
            Self::RotaryDirection(RotaryDirection::Towards(rotation)) => {
                write!(out, "ROTABL/NEXT,{}", word_of(&ROTATIONS, rotation))
            }
        }
    }
}
