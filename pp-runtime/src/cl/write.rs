//! Records as text: what [`Record`] prints is read back as the same record.
//!
//! Numbers are written with as many digits as they need and no more, in decimals. Nothing is cut into several lines, and
//! text goes out as UTF-8, so a text that was in another encoding is not the same afterwards.

use std::fmt::{self, Display, Formatter, Write as _};

use super::record::{
    AxisPlane, Circle, CircleForm, Cycle, CycleState, FeedUnit, FrameRecord, Numbers, Point, Record, Return, Text, Tool,
};
use super::vector::{cross, distance};
use crate::program::{Coolant, CutterSide, Dwell, Rotation, Spindle, Turning, Units};

/// A number as CL data has it: decimal, and with a point.
struct Number(f64);

impl Display for Number {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let text = format!("{}", self.0);
        out.write_str(&text)?;
        if text.contains('.') { Ok(()) } else { out.write_char('.') }
    }
}

/// Numbers with commas between them.
struct List<'a>(&'a [f64]);

impl Display for List<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        for (index, value) in self.0.iter().enumerate() {
            if index > 0 {
                out.write_char(',')?;
            }
            Number(*value).fmt(out)?;
        }
        Ok(())
    }
}

impl Display for Point {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        List(&self.tip).fmt(out)?;
        self.axis.map_or(Ok(()), |axis| write!(out, ",{}", List(&axis)))
    }
}

impl Display for Text<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(self.bytes))
    }
}

impl Display for Numbers<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(self.bytes))
    }
}

impl Display for Tool {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "LOADTL/{}", self.number)?;
        if let Some(length) = self.length {
            write!(out, ",LENGTH,{}", Number(length))?;
        }
        self.offset.map_or(Ok(()), |offset| write!(out, ",ADJUST,{offset}"))
    }
}

impl Display for Circle {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let radius = self.radius.unwrap_or_default();
        if let Some(angle) = self.angle {
            let (centre, axis) = (List(&self.centre), List(&self.axis));
            return write!(out, "MOVARC/{centre},{axis},{},ANGLE,{}", Number(radius), Number(angle));
        }
        write!(out, "CIRCLE/{},{}", List(&self.centre), List(&self.axis))?;
        match self.form {
            CircleForm::Six => {}
            CircleForm::Seven => write!(out, ",{}", Number(radius))?,
            // Tolerances and tool do not matter to the path.
            CircleForm::Eleven => write!(out, ",{},0.06,0.5,0.,0.", Number(radius))?,
        }
        if self.times > 1 { write!(out, ",TIMES,{}", self.times) } else { Ok(()) }
    }
}

impl Display for Cycle {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        write!(out, "CYCLE/{}", self.kind.word())?;
        for value in &self.positional[..self.positionals.min(self.positional.len())] {
            write!(out, ",{}", Number(*value))?;
        }
        for (word, value) in [
            ("FEDTO", self.fedto),
            ("DEPTH", self.depth),
            ("STEP", self.step),
            ("1STPECK", self.first_step),
            ("RAPTO", self.rapto),
            ("CLEAR", self.clear),
            ("DWELL", self.dwell),
            ("REV", self.dwell_turns),
            ("BACK", self.back),
            ("ORIENT", self.orient),
        ] {
            if let Some(value) = value {
                write!(out, ",{word},{}", Number(value))?;
            }
        }
        match self.back_to {
            Some(Return::Auto) => out.write_str(",RTRCTO,AUTO")?,
            Some(Return::Level(level)) => write!(out, ",RTRCTO,{}", Number(level))?,
            None => {}
        }
        self.feed.map_or(Ok(()), |(value, unit)| write!(out, ",{},{}", unit.word(), Number(value)))
    }
}

impl FeedUnit {
    /// The word that stands for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::PerMinute => "PERMIN",
            Self::PerRevolution => "PERREV",
            Self::MillimetresPerMinute => "MMPM",
            Self::MillimetresPerRevolution => "MMPR",
            Self::InchesPerMinute => "IPM",
            Self::InchesPerRevolution => "IPR",
        }
    }
}

/// Rows of the 3×4 matrix of a frame.
fn rows(frame: &FrameRecord) -> [f64; 12] {
    let [x, y, z] = frame.axes;
    let o = frame.origin;
    [x[0], y[0], z[0], o[0], x[1], y[1], z[1], o[1], x[2], y[2], z[2], o[2]]
}

/// As MSYS where Z follows from X and Y, else as the comment of Creo.
fn frame(frame: &FrameRecord, out: &mut Formatter<'_>) -> fmt::Result {
    let [x, y, z] = frame.axes;
    if distance(cross(x, y), z) > 0.0 {
        return write!(out, "$$-> CSYS / {}", List(&rows(frame)));
    }
    write!(out, "MSYS/{},{},{}", List(&frame.origin), List(&x), List(&y))
}

fn spindle(spindle: Spindle, out: &mut Formatter<'_>) -> fmt::Result {
    let Spindle::On { speed, rotation } = spindle else { return out.write_str("SPINDL/OFF") };
    out.write_str("SPINDL/ON")?;
    if let Some(speed) = speed {
        write!(out, ",RPM,{}", Number(speed))?;
    }
    match rotation {
        Some(Rotation::Clockwise) => out.write_str(",CLW"),
        Some(Rotation::CounterClockwise) => out.write_str(",CCLW"),
        None => Ok(()),
    }
}

fn shift(word: &str, by: Option<&[f64]>, out: &mut Formatter<'_>) -> fmt::Result {
    match by {
        Some(by) => write!(out, "{word}/{}", List(by)),
        None => write!(out, "{word}/NOMORE"),
    }
}

fn on_off(word: &str, on: bool, out: &mut Formatter<'_>) -> fmt::Result {
    write!(out, "{word}/{}", if on { "ON" } else { "OFF" })
}

fn compensation(
    side: CutterSide,
    register: Option<u32>,
    plane: Option<AxisPlane>,
    out: &mut Formatter<'_>,
) -> fmt::Result {
    let side = match side {
        CutterSide::Off => "OFF",
        CutterSide::On => "ON",
        CutterSide::Left => "LEFT",
        CutterSide::Right => "RIGHT",
    };
    write!(out, "CUTCOM/{side}")?;
    if let Some(register) = register {
        write!(out, ",{register}")?;
    }
    let word = AxisPlane::WORDS.iter().find(|(_, known)| Some(*known) == plane).map(|(word, _)| word);
    word.map_or(Ok(()), |word| write!(out, ",{word}"))
}

impl Display for Record<'_> {
    /// The statement, without a line end; an inert record is a comment.
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Record::PartName(text) => write!(out, "PARTNO {text}"),
            Record::MachineName(text) => write!(out, "MACHIN/{text}"),
            Record::Units(Units::Millimetres) => out.write_str("UNITS/MM"),
            Record::Units(Units::Inches) => out.write_str("UNITS/INCH"),
            Record::ToolPath(text) => write!(out, "TOOL PATH/{text},TOOL,NONE"),
            Record::EndOfPath => out.write_str("END-OF-PATH"),
            Record::Tool(tool) => tool.fmt(out),
            Record::Preselect(number) => write!(out, "SELCTL/{number}"),
            Record::Cutter(cutter) | Record::CutterOfLastTool(cutter) => {
                let last = matches!(self, Record::CutterOfLastTool(_));
                write!(out, "{}CUTTER/{}", if last { "$$-> " } else { "" }, Number(cutter.diameter))?;
                cutter.corner_radius.map_or(Ok(()), |radius| write!(out, ",{}", Number(radius)))
            }
            Record::LengthOffset { register, .. } => write!(out, "SET/OFSETL,{register}"),
            Record::MultiAxis(on) => on_off("MULTAX", *on, out),
            Record::ToolAxis { axis, .. } => write!(out, "TLAXIS/{}", List(axis)),
            Record::Frame(record) => frame(record, out),
            Record::Setup(record) => write!(out, "CSYS/{}", List(&rows(record))),
            Record::World => out.write_str("TRNTYP/WORLD,0,0,0"),
            Record::Origin(by) => shift("ORIGIN", by.as_ref().map(|by| &by[..]), out),
            Record::Translation { by, .. } => shift("TRANS", by.as_ref().map(|by| &by[..]), out),
            Record::Transformation { matrix, .. } => shift("TRACUT", matrix.as_ref().map(|matrix| &matrix[..]), out),
            Record::From(point) => write!(out, "FROM/{point}"),
            Record::Goto(point) => write!(out, "GOTO/{point}"),
            Record::Points(points) => write!(out, "GOTO/{points}"),
            Record::Delta(step) => write!(out, "GODLTA/{step}"),
            Record::DeltaAlongAxis { distance, .. } => write!(out, "GODLTA/{}", Number(*distance)),
            Record::Home(None) => out.write_str("GOHOME"),
            Record::Home(Some(point)) => write!(out, "GOHOME/{point}"),
            Record::Rapid => out.write_str("RAPID"),
            Record::Circle(circle) => circle.fmt(out),
            Record::AutomaticPlane => out.write_str("AUTOPS"),
            Record::Direction { vector, .. } => write!(out, "INDIRV/{}", List(vector)),
            Record::TangentArc(arc) => {
                let (centre, radius, [from, to]) = (List(&arc.centre), Number(arc.radius), &arc.line);
                let second = if arc.second { "2,INTOF," } else { "" };
                write!(out, "TLON,GOFWD/(CIRCLE/{centre},{radius}),ON,{second}(LINE/{},{})", List(from), List(to))
            }
            Record::Nurbs => out.write_str("NURBS/"),
            Record::Knots(knots) => write!(out, "KNOT/{knots}"),
            Record::ControlPoint(point) => write!(out, "CNTRL/{point}"),
            Record::Cycle(cycle) => cycle.fmt(out),
            Record::CycleState { state, .. } => out.write_str(match state {
                CycleState::Off => "CYCLE/OFF",
                CycleState::On => "CYCLE/ON",
                CycleState::Initial => "CYCLE/INIT",
                CycleState::Clear => "CYCLE/CLEAR",
            }),
            Record::Feed { value, unit: FeedUnit::PerMinute, .. } => write!(out, "FEDRAT/{}", Number(*value)),
            Record::Feed { value, unit, .. } => write!(out, "FEDRAT/{},{}", unit.word(), Number(*value)),
            Record::InverseTime(on) => on_off("INVERSE", *on, out),
            Record::Spindle(record) => spindle(*record, out),
            Record::Coolant(coolant) => out.write_str(match coolant {
                Coolant::On => "COOLNT/ON",
                Coolant::Flood => "COOLNT/FLOOD",
                Coolant::Mist => "COOLNT/MIST",
                Coolant::Through => "COOLNT/THRU",
                Coolant::Air => "COOLNT/AIR",
                Coolant::Off => "COOLNT/OFF",
            }),
            Record::Compensation { side, register, plane } => compensation(*side, *register, *plane, out),
            Record::Delay { dwell: Dwell::Seconds(value), .. } => write!(out, "DELAY/{}", Number(*value)),
            Record::Delay { dwell: Dwell::Revolutions(value), .. } => write!(out, "DELAY/{},REV", Number(*value)),
            Record::Tolerance { value: Some(value), .. } => write!(out, "LINTOL/{}", Number(*value)),
            Record::Tolerance { value: None, .. } => out.write_str("LINTOL/OFF"),
            Record::ClearancePlane { normal, distance, .. } => {
                write!(out, "CLEARP/{},{}", List(normal), Number(*distance))
            }
            Record::Retract => out.write_str("RETRCT"),
            Record::Turning(Turning::Shortest) => out.write_str("ROTABL/SHORT"),
            Record::Turning(Turning::Next(Rotation::Clockwise)) => out.write_str("ROTABL/NEXT,CLW"),
            Record::Turning(Turning::Next(Rotation::CounterClockwise)) => out.write_str("ROTABL/NEXT,CCLW"),
            Record::OptionalStop => out.write_str("OPSTOP"),
            Record::Stop => out.write_str("STOP"),
            Record::End => out.write_str("END"),
            Record::Fini => out.write_str("FINI"),
            Record::Rewind => out.write_str("REWIND/0"),
            Record::Message(text) => write!(out, "PPRINT {text}"),
            Record::Insert(text) => write!(out, "INSERT {text}"),
            Record::Code { letter, number, .. } => {
                write!(out, "{}/{number}", if *letter == b'M' { "AUXFUN" } else { "PREFUN" })
            }
            Record::DefineSubprogram(number) => write!(out, "DEFSUB/{number}"),
            Record::EndSubprogram => out.write_str("ENDSUB"),
            Record::CallSubprogram { number, .. } => write!(out, "CALSUB/{number}"),
            Record::Inert => out.write_str("$$"),
        }
    }
}
