//! Records of arcs: CIRCLE in its forms, MOVARC, ARCSLP before it, and TLON with AUTOPS and INDIRV (CATIA).

use std::fmt::{self, Display, Formatter};

use super::values::{ClNumber, ClNumbers, word_of};
use crate::cl::text::{Args, ClFault, Span, number_at_start, quoted, skip_blanks};
use crate::diag::code::cl;
use crate::program::Rotation;

/// Form of a CIRCLE by the count of its numbers. The sense in which the circle is traversed follows from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CircleForm {
    /// 4 numbers: centre and radius, across the tool axis; the sense follows from the points of the GOTO or is given
    /// (Creo).
    Four,
    /// 6 numbers: centre and axis; counter-clockwise about the axis (SolidWorks CAM).
    Six,
    /// 7 numbers: a radius after them; counter-clockwise (Creo, ISO 4343), unless a word after them states the sense.
    Seven,
    /// 11 numbers: radius, tolerances and tool; clockwise about the axis (NX).
    Eleven,
}

/// A circle, in the units of the file; the next GOTO is the end of the arc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircleRecord {
    /// Centre.
    pub centre: [f64; 3],
    /// Axis, not normalised; 0 where the record has none.
    pub axis: [f64; 3],
    /// Radius, if the form has one.
    pub radius: Option<f64>,
    /// Number after the radius in the form with 11 numbers: total tolerance (NX), or degrees of the arc (*CAMplete APT*
    /// of Autodesk).
    pub eighth: Option<f64>,
    /// Form of the record.
    pub form: CircleForm,
    /// Sense about the axis, if a word states it.
    pub sense: Option<Rotation>,
    /// TIMES,n: the arc and n - 1 full revolutions.
    pub times: u32,
    /// Angle that the arc must have (MOVARC).
    pub angle_deg: Option<f64>,
    /// Place of the numbers, for messages.
    pub at: Span,
}

/// `TLON,GOFWD/ (CIRCLE/ c,r),ON,(LINE/ c,e)`: an arc to the point `e` that begins in the direction of INDIRV.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentArc {
    /// Centre.
    pub centre: [f64; 3],
    /// Radius.
    pub radius: f64,
    /// Two points of the line. The second is the end of the arc, where the line meets the circle.
    pub line: [[f64; 3]; 2],
    /// `2,INTOF`: the second intersection along the line.
    pub second: bool,
    /// Place of the arguments, for messages.
    pub at: Span,
}

/// A record that defines an arc or its begin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ArcRecord {
    /// `CIRCLE/..` with 4, 6, 7 or 11 numbers, `CLW` or `CCLW` after 7, and `TIMES,n`;
    /// `MOVARC/x,y,z,i,j,k,r,ANGLE,degrees`; `MOVARC/CENTER,x,y,z,AXIS,i,j,k,RADIUS,r`.
    Circle(CircleRecord),
    /// `ARCSLP/h`: the next arc is a helix of this height, up or down.
    Slope {
        /// Height in units of the file.
        height: f64,
        /// Place of the number, for messages.
        at: Span,
    },
    /// `AUTOPS`: the plane of the next TLON passes through the current position.
    AutomaticPlane,
    /// `INDIRV/i,j,k`: direction in which the next TLON begins.
    Direction {
        /// Not normalised.
        vector: [f64; 3],
        /// Place of the numbers, for messages.
        at: Span,
    },
    /// `TLON,GOFWD/ ..`.
    TangentArc(TangentArc),
}

/// INDIRV.
pub(crate) fn direction(args: &mut Args<'_>) -> Result<ArcRecord, ClFault> {
    let vector = args.exactly()?;
    Ok(ArcRecord::Direction { vector, at: args.all() })
}

/// Largest number of revolutions of an arc; it bounds the number of chords. No thread has as many.
const MOST_REVOLUTIONS: u32 = 1000;

/// Largest count of numbers of a CIRCLE.
pub(crate) const CIRCLE_NUMBERS: usize = 11;

/// Count of the first of them, those that are not about the tool.
pub(super) const CIRCLE_NUMBERS_HELD: usize = 8;

impl CircleRecord {
    /// CIRCLE of `count` numbers, which must be that of a form; `numbers`: the first of them.
    pub(crate) fn of(numbers: &[f64; CIRCLE_NUMBERS_HELD], count: usize, times: u32, at: Span) -> Option<Self> {
        let form = match count {
            4 => CircleForm::Four,
            6 => CircleForm::Six,
            7 => CircleForm::Seven,
            CIRCLE_NUMBERS => CircleForm::Eleven,
            _ => return None,
        };
        let [x, y, z, i, j, k, r, eighth] = *numbers;
        let (axis, r) = if form == CircleForm::Four { ([0.0; 3], i) } else { ([i, j, k], r) };
        Some(CircleRecord {
            centre: [x, y, z],
            axis,
            radius: (form != CircleForm::Six).then_some(r),
            eighth: (form == CircleForm::Eleven).then_some(eighth),
            form,
            sense: None,
            times,
            angle_deg: None,
            at,
        })
    }
}

/// Words for the sense of a CIRCLE; of several words for a sense the first is written. The long words are written by
/// CAMWorks after 7 numbers with 0,0,1 as axis: of 72 arcs the 38 without a cusp at an end are tangent to the lines
/// before and after them in this sense.
const SENSES: [(&str, Rotation); 4] = [
    ("CLW", Rotation::Clockwise),
    ("CCLW", Rotation::CounterClockwise),
    ("CLOCKWISE", Rotation::Clockwise),
    ("COUNTERCLOCKWISE", Rotation::CounterClockwise),
];

/// CIRCLE: `x,y,z,i,j,k[,r[,CLW|CCLW]][,t,f,d,e][,TIMES,n]`, `x,y,z,r`.
pub(crate) fn circle(args: &mut Args<'_>) -> Result<ArcRecord, ClFault> {
    let at = args.all();
    let mut numbers = [0.0; CIRCLE_NUMBERS_HELD];
    let mut found = args.plain_numbers(&mut numbers);
    let (mut times, mut sense) = (1, None);
    while let Some(arg) = args.next()? {
        if let Some(stated) = arg.among(&SENSES) {
            if found != 7 || sense.is_some() {
                return Err(args.not_understood(arg));
            }
            sense = Some(stated);
            continue;
        }
        if arg.is("TIMES") {
            let count = args.number_after(arg)?;
            times = count.integer()?;
            if !(1..=MOST_REVOLUTIONS).contains(&times) {
                let text = format!("TIMES must be 1 to {MOST_REVOLUTIONS}, found {times}");
                return Err(cl::ARC.cl_fault(
                    "circle",
                    count.at,
                    text,
                    "TIMES,n is the arc and n - 1 full revolutions",
                ));
            }
            break;
        }
        let value = arg.number()?;
        if let Some(place) = numbers.get_mut(found) {
            *place = value;
        }
        found += 1;
    }
    let circle = CircleRecord::of(&numbers, found, times, at);
    circle.map(|circle| ArcRecord::Circle(CircleRecord { sense, ..circle })).ok_or_else(|| {
        cl::ARC.cl_fault(
            "circle",
            at,
            format!(
                "{} needs 4, 6, 7 or 11 numbers, found {found}; the sense of the arc follows from their count",
                args.name()
            ),
            "6 and 7 numbers: counter-clockwise about i, j, k; 11 numbers: clockwise; 4: centre and radius",
        )
    })
}

/// ARCSLP: height of the helix that follows. Its sign depends on height and sense in the script of *Mori APT*, which
/// the GOTO and the axis of the arc state, too.
pub(crate) fn slope(args: &mut Args<'_>) -> Result<ArcRecord, ClFault> {
    let [height] = args.exactly()?;
    Ok(ArcRecord::Slope { height, at: args.all() })
}

/// MOVARC: `x,y,z,i,j,k,r,ANGLE,degrees`; `CENTER,x,y,z,AXIS,i,j,k,RADIUS,r`, counter-clockwise about the axis (script
/// of *Mori APT*).
pub(crate) fn move_arc(args: &mut Args<'_>) -> Result<ArcRecord, ClFault> {
    let at = args.all();
    let mut numbers = [0.0; 7];
    let has_words = args.clone().next()?.is_some_and(|arg| arg.is("CENTER"));
    for (index, place) in numbers.iter_mut().enumerate() {
        match index {
            0 if has_words => args.keyword("CENTER")?,
            3 if has_words => args.keyword("AXIS")?,
            6 if has_words => args.keyword("RADIUS")?,
            _ => {}
        }
        *place = args.needed()?.number()?;
    }
    let [x, y, z, i, j, k, r] = numbers;
    let circle = CircleRecord {
        centre: [x, y, z],
        axis: [i, j, k],
        radius: Some(r),
        eighth: None,
        form: CircleForm::Seven,
        sense: None,
        times: 1,
        angle_deg: None,
        at,
    };
    if has_words {
        return Ok(ArcRecord::Circle(circle));
    }
    let word = args.needed()?;
    if !word.is("ANGLE") {
        return Err(args.not_understood(word));
    }
    let angle = args.number_after(word)?;
    let degrees = angle.number()?;
    if !(degrees > 0.0 && degrees <= 360.0 * f64::from(MOST_REVOLUTIONS)) {
        return Err(cl::ARC.cl_fault(
            "circle",
            angle.at,
            format!("the angle of an arc cannot be {} degrees", quoted(angle.text)),
            "the angle is counter-clockwise about i, j, k, above 0 degrees and at most 1000 revolutions",
        ));
    }
    Ok(ArcRecord::Circle(CircleRecord { angle_deg: Some(degrees), ..circle }))
}

/// TLON: `,GOFWD/ (CIRCLE/ x,y,z,r),ON,[2,INTOF,](LINE/ x,y,z,x,y,z)`.
pub(crate) fn tangent_arc(args: &mut Args<'_>) -> Result<ArcRecord, ClFault> {
    let text = args.text();
    let mut scan = TlonScan { text, at: args.position() };
    scan.expect(",")?;
    scan.expect("GOFWD")?;
    scan.expect("/")?;
    let start = skip_blanks(text, scan.at);
    scan.expect("(")?;
    scan.expect("CIRCLE")?;
    scan.expect("/")?;
    let [x, y, z, radius] = scan.numbers()?;
    scan.expect(")")?;
    scan.expect(",")?;
    scan.expect("ON")?;
    scan.expect(",")?;
    let second = scan.accept("2");
    if second {
        scan.expect(",")?;
        scan.expect("INTOF")?;
        scan.expect(",")?;
    }
    scan.expect("(")?;
    scan.expect("LINE")?;
    scan.expect("/")?;
    let [a, b, c, d, e, f] = scan.numbers()?;
    scan.expect(")")?;
    if skip_blanks(text, scan.at) < text.len() {
        return Err(scan.unexpected("the end of the record"));
    }
    let at = Span { start, end: text.len() };
    let line = [[a, b, c], [d, e, f]];
    Ok(ArcRecord::TangentArc(TangentArc { centre: [x, y, z], radius, line, second, at }))
}

/// Position in the nested arguments of a TLON.
struct TlonScan<'t> {
    text: &'t [u8],
    at: usize,
}

impl TlonScan<'_> {
    fn accept(&mut self, token: &str) -> bool {
        let start = skip_blanks(self.text, self.at);
        let end = start + token.len();
        let found = self.text.get(start..end).is_some_and(|found| found.eq_ignore_ascii_case(token.as_bytes()));
        if found {
            self.at = end;
        }
        found
    }

    fn expect(&mut self, token: &str) -> Result<(), ClFault> {
        if self.accept(token) { Ok(()) } else { Err(self.unexpected(&format!("`{token}`"))) }
    }

    /// Numbers with commas between them.
    fn numbers<const N: usize>(&mut self) -> Result<[f64; N], ClFault> {
        let mut numbers = [0.0; N];
        for (index, place) in numbers.iter_mut().enumerate() {
            if index > 0 {
                self.expect(",")?;
            }
            let start = skip_blanks(self.text, self.at);
            match number_at_start(&self.text[start..]).filter(|(value, _)| value.is_finite()) {
                Some((value, used)) => (*place, self.at) = (value, start + used),
                None => return Err(self.unexpected("a number")),
            }
        }
        Ok(numbers)
    }

    #[cold]
    fn unexpected(&self, wanted: &str) -> ClFault {
        let start = skip_blanks(self.text, self.at).min(self.text.len().saturating_sub(1));
        cl::ARC.cl_fault(
            "TLON",
            Span { start, end: start + 1 },
            format!("TLON: expected {wanted} here"),
            "accepted: TLON,GOFWD/ (CIRCLE/ x,y,z,r),ON,[2,INTOF,](LINE/ x,y,z,x,y,z)",
        )
    }
}

impl Display for CircleRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let radius = self.radius.unwrap_or_default();
        if let Some(angle) = self.angle_deg {
            let (centre, axis) = (ClNumbers(&self.centre), ClNumbers(&self.axis));
            return write!(out, "MOVARC/{centre},{axis},{},ANGLE,{}", ClNumber(radius), ClNumber(angle));
        }
        if self.form == CircleForm::Four {
            return write!(out, "CIRCLE/{},{}", ClNumbers(&self.centre), ClNumber(radius));
        }
        write!(out, "CIRCLE/{},{}", ClNumbers(&self.centre), ClNumbers(&self.axis))?;
        match self.form {
            CircleForm::Four | CircleForm::Six => {}
            CircleForm::Seven => {
                write!(out, ",{}", ClNumber(radius))?;
                self.sense.map_or(Ok(()), |sense| write!(out, ",{}", word_of(&SENSES, &sense)))?;
            }
            // The tool has no effect on the path.
            CircleForm::Eleven => {
                write!(out, ",{},{},0.5,0.,0.", ClNumber(radius), ClNumber(self.eighth.unwrap_or_default()))?;
            }
        }
        if self.times > 1 { write!(out, ",TIMES,{}", self.times) } else { Ok(()) }
    }
}

impl Display for TangentArc {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let (centre, radius, [from, to]) = (ClNumbers(&self.centre), ClNumber(self.radius), &self.line);
        let second = if self.second { "2,INTOF," } else { "" };
        write!(out, "TLON,GOFWD/(CIRCLE/{centre},{radius}),ON,{second}(LINE/{},{})", ClNumbers(from), ClNumbers(to))
    }
}

impl Display for ArcRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Circle(circle) => circle.fmt(out),
            Self::Slope { height, .. } => write!(out, "ARCSLP/{}", ClNumber(*height)),
            Self::AutomaticPlane => out.write_str("AUTOPS"),
            Self::Direction { vector, .. } => write!(out, "INDIRV/{}", ClNumbers(vector)),
            Self::TangentArc(arc) => arc.fmt(out),
        }
    }
}
