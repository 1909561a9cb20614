//! A statement to a typed record.
//!
//! `MAJOR[/argument,argument..]`: the word is looked up in `words`, and each record checks its arguments completely;
//! an argument that is not understood is never passed over. Text words take the rest of the statement as it is.

use super::Dialect;
use super::args::{Arg, Args, skip_blanks};
use super::fault::{Fault, Help, Span, quoted};
use super::record::{FrameRecord, Numbers, Point, Record, Text};
use super::words::{self, Use, Word, look_up};
use super::{circle, cycle, forms, spindle, tools, vector};
use crate::diag::Severity;

/// Reads one statement that is no comment. `text` is not empty; the words of `inert` are passed over, unless they are
/// read or would move what follows.
pub(super) fn parse<'a>(text: &'a [u8], inert: &[String]) -> Result<Record<'a>, Fault> {
    let word_at = major_word(text);
    let word = &text[word_at.start..word_at.end];
    let declared = || inert.iter().any(|inert| word.eq_ignore_ascii_case(inert.as_bytes()));
    let Some((name, usage)) = look_up(word) else {
        return if declared() { Ok(Record::Inert) } else { Err(unknown(text, word_at)) };
    };
    match usage {
        Use::Modelled(word) => modelled(word, name, text, word_at),
        Use::Inert => Ok(Record::Inert),
        Use::Refused(_) if declared() => Ok(Record::Inert),
        Use::Refused(reason) => Err(Fault::new(
            name,
            word_at,
            format!("{name} is refused: {reason}"),
            format!("have the CAM system leave it out, or give `--inert {name}` if it is known not to matter"),
        )),
        Use::Hazard(reason) => Err(Fault::new(
            name,
            word_at,
            format!("{name} is refused: {reason}"),
            "have the CAM system write plain motion without it",
        )),
        Use::Turning => Err(turning(word_at)),
    }
}

/// Whether a record takes whatever arguments it has, so that a line joined to it would vanish in them.
pub(super) fn takes_anything(record: &Record<'_>) -> bool {
    matches!(
        record,
        Record::Inert
            | Record::PartName(_)
            | Record::MachineName(_)
            | Record::Message(_)
            | Record::Insert(_)
            | Record::ToolPath(_)
    )
}

/// The fault of a line that the `$` of the line before joins to the record `text`, if it is a record itself.
pub(super) fn swallowed(text: &[u8], offset: usize, line: &[u8]) -> Option<Fault> {
    let start = skip_blanks(line, 0);
    let end = start + major_word(&line[start..]).end;
    let (name, Use::Modelled(_)) = look_up(&line[start..end])? else { return None };
    // Text that happens to begin with such a word goes on with another one.
    if line.get(skip_blanks(line, end)).is_some_and(|next| *next != b'/') {
        return None;
    }
    let word = major_word(text);
    // A comment has no word, only its `$$->`.
    let shown = if word.end == 0 { text.len().min(4) } else { word.end };
    let first = String::from_utf8_lossy(&text[..shown]);
    Some(Fault::new(
        "joined record",
        Span { start: offset + start, end: offset + end },
        format!("{name} begins a line that the `$` before it makes part of {first}"),
        "delete that `$`: at the end of a line it joins the next one",
    ))
}

/// Which CAM system a record gives away.
pub(super) fn dialect(text: &[u8]) -> Dialect {
    // Nearly every record is a GOTO and gives nothing away.
    if !matches!(text[0], b'T' | b'U' | b'C' | b't' | b'u' | b'c') {
        return Dialect::Generic;
    }
    let word_at = major_word(text);
    match look_up(&text[word_at.start..word_at.end]) {
        Some(("TOOL PATH", _)) => Dialect::Nx,
        Some(("UNIT" | "CSYS" | "TRNTYP" | "CSI_", _)) => Dialect::SolidWorks,
        _ => Dialect::Generic,
    }
}

fn modelled<'a>(word: Word, name: &'static str, text: &'a [u8], word_at: Span) -> Result<Record<'a>, Fault> {
    match word {
        Word::Partno => return Ok(Record::PartName(rest_as_text(text, word_at.end))),
        Word::Pprint => return Ok(Record::Message(rest_as_text(text, word_at.end))),
        Word::Insert => return Ok(Record::Insert(rest_as_text(text, word_at.end))),
        Word::ToolPath => return Ok(Record::ToolPath(operation_name(text, word_at.end))),
        Word::Tlon => return circle::tangent_arc(text, word_at.end),
        _ => {}
    }
    let mut args = arguments(name, text, word_at)?;
    let record = match word {
        Word::Goto => return goto_or_list(name, text, &mut args),
        Word::From => return point(name, &mut args).map(Record::From),
        Word::Cntrl | Word::Godlta | Word::Gohome => return motion(word, name, &mut args),
        Word::Tlaxis => {
            let axis = exactly(name, &mut args)?;
            Record::ToolAxis { axis, at: args.all() }
        }
        Word::Indirv => {
            let vector = exactly(name, &mut args)?;
            Record::Direction { vector, at: args.all() }
        }
        Word::Msys => {
            let numbers = exactly(name, &mut args)?;
            Record::Frame(frame_from_two_axes(&numbers, args.all()))
        }
        Word::Csys => {
            let numbers = exactly(name, &mut args)?;
            Record::Setup(frame_from_rows(&numbers, args.all()))
        }
        Word::Circle => Record::Circle(circle::circle(name, &mut args)?),
        Word::Movarc => Record::Circle(circle::move_arc(name, &mut args)?),
        Word::Autops => Record::AutomaticPlane,
        Word::Nurbs => Record::Nurbs,
        Word::Knot => {
            circle::some_numbers(name, &mut args)?;
            Record::Knots(numbers_of(text, args.all()))
        }
        Word::Cycle => cycle::parse(name, &mut args)?,
        Word::Origin => Record::Origin(forms::shift(name, &mut args)?),
        Word::Trans => Record::Translation { by: forms::shift(name, &mut args)?, at: args.all() },
        Word::Tracut => forms::transformation(name, &mut args)?,
        Word::Rapid => Record::Rapid,
        Word::Stop => Record::Stop,
        Word::Opstop => Record::OptionalStop,
        Word::End => Record::End,
        Word::EndOfPath => Record::EndOfPath,
        Word::Fini => Record::Fini,
        Word::Retrct => Record::Retract,
        Word::Endsub => Record::EndSubprogram,
        Word::Rewind => {
            if let Some(arg) = args.next()? {
                arg.number()?;
            }
            Record::Rewind
        }
        Word::Units => Record::Units(forms::units(name, &mut args)?),
        Word::Loadtl => Record::Tool(tools::call(name, &mut args)?),
        Word::Load => {
            keyword(name, &mut args, "TOOL")?;
            Record::Tool(tools::call(name, &mut args)?)
        }
        Word::Selctl => Record::Preselect(needed(name, &mut args)?.integer()?),
        Word::Select => {
            keyword(name, &mut args, "TOOL")?;
            Record::Preselect(needed(name, &mut args)?.integer()?)
        }
        Word::Cutter => return tools::cutter(name, &mut args).map(Record::Cutter),
        Word::Tldata => return tools::data(name, &mut args),
        Word::Multax => Record::MultiAxis(match args.next()? {
            None => true,
            Some(arg) => forms::on_or_off(name, arg)?,
        }),
        Word::Inverse => Record::InverseTime(forms::on_or_off(name, needed(name, &mut args)?)?),
        Word::Fedrat => forms::feed(name, &mut args)?,
        Word::Spindl => Record::Spindle(spindle::parse(name, &mut args)?),
        Word::Coolnt => Record::Coolant(forms::coolant(needed(name, &mut args)?)?),
        Word::Cutcom => forms::compensation(name, &mut args)?,
        Word::Delay => forms::delay(name, &mut args)?,
        Word::Lintol => {
            let arg = needed(name, &mut args)?;
            let value = if arg.is("OFF") { None } else { Some(arg.number()?) };
            Record::Tolerance { value, at: arg.at }
        }
        Word::Clearp => forms::clearance_plane(name, &mut args)?,
        Word::Rotabl => Record::Turning(forms::turning_sense(name, &mut args)?),
        Word::Auxfun => forms::code(b'M', name, &mut args)?,
        Word::Prefun => forms::code(b'G', name, &mut args)?,
        Word::Machin => return machine_name(name, text, &mut args),
        Word::Defsub => Record::DefineSubprogram(needed(name, &mut args)?.integer()?),
        Word::Calsub => {
            let arg = needed(name, &mut args)?;
            Record::CallSubprogram { number: arg.integer()?, at: arg.at }
        }
        Word::Opskip => {
            keyword(name, &mut args, "OFF")?;
            Record::Inert
        }
        Word::Mode => {
            let arg = needed(name, &mut args)?;
            if arg.is("TURN") {
                return Err(turning(arg.at));
            }
            if !arg.is("MILL") && !arg.is("ABSOL") {
                return Err(argument_not_yet(name, arg));
            }
            Record::Inert
        }
        Word::Toolno => return tools::description(args),
        Word::Trntyp => {
            keyword(name, &mut args, "WORLD")?;
            let numbers: [f64; 3] = exactly(name, &mut args)?;
            if numbers.iter().any(|value| value.abs() > 0.0) {
                return Err(Fault::new(
                    name,
                    args.all(),
                    "TRNTYP with numbers other than 0 moves the coordinates in a way that is not known",
                    "have the CAM system write its points in one common frame: TRNTYP/WORLD,0,0,0",
                ));
            }
            Record::World
        }
        Word::Set => {
            let arg = needed(name, &mut args)?;
            if arg.is("OFSETL") {
                let register = needed(name, &mut args)?;
                Record::LengthOffset { register: register.integer()?, at: register.at }
            } else if arg.is("MODE") {
                keyword(name, &mut args, "ABSOL")?;
                Record::Inert
            } else {
                return Err(argument_not_yet(name, arg));
            }
        }
        // Text words have been read above.
        Word::Partno | Word::Pprint | Word::Insert | Word::ToolPath | Word::Tlon => Record::Inert,
    };
    match args.next()? {
        None => Ok(record),
        Some(arg) => Err(argument_not_yet(name, arg)),
    }
}

/// `GODLTA`, `GOHOME`, `CNTRL`: points, but not only.
fn motion<'a>(word: Word, name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let mut ahead = args.clone();
    let first = ahead.next()?;
    let single = first.is_some() && ahead.next().is_ok_and(|second| second.is_none());
    match (word, first) {
        (Word::Gohome, None) => Ok(Record::Home(None)),
        (Word::Gohome, Some(_)) => Ok(Record::Home(Some(point(name, args)?))),
        (Word::Godlta, Some(arg)) if single => Ok(Record::DeltaAlongAxis { distance: arg.number()?, at: arg.at }),
        (Word::Godlta, _) => Ok(Record::Delta(point(name, args)?)),
        _ => {
            let tip = exactly(name, args)?;
            Ok(Record::ControlPoint(Point { tip, axis: None, at: args.all() }))
        }
    }
}

/// One point, or a list of them with slashes between.
fn goto_or_list<'a>(name: &'static str, text: &'a [u8], args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let all = args.all();
    let points = &text[all.start.min(text.len())..];
    if !points.contains(&b'/') || all.start == 0 {
        return point(name, args).map(Record::Goto);
    }
    let mut start = all.start;
    for piece in points.split(|byte| *byte == b'/') {
        let end = start + piece.len();
        // The rest of the text is cut off, so that the places in messages stay right.
        let mut args = Args::new(&text[..end], start);
        let found = args.numbers(&mut [])?;
        if found != 3 {
            return Err(wrong_count(name, "3 numbers between slashes", found, &args));
        }
        start = end + 1;
    }
    Ok(Record::Points(numbers_of(text, all)))
}

fn numbers_of(text: &[u8], at: Span) -> Numbers<'_> {
    Numbers { bytes: &text[at.start..at.end], at }
}

/// The name up to the first comma; the other arguments are the postprocessor's own.
fn machine_name<'a>(name: &'static str, text: &'a [u8], args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let arg = needed(name, args)?;
    Ok(Record::MachineName(Text { bytes: &text[arg.at.start..arg.at.end], at: arg.at }))
}

/// The first word; it may hold `-` and `_`. TOOL PATH is one word with a blank inside.
fn major_word(text: &[u8]) -> Span {
    let length = |text: &[u8]| {
        text.iter().take_while(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_')).count()
    };
    let end = length(text);
    if text[..end].eq_ignore_ascii_case(b"TOOL") {
        let next = skip_blanks(text, end);
        let path = next + length(&text[next..]);
        // One blank only: the table spells the word so.
        if next == end + 1 && text[next..path].eq_ignore_ascii_case(b"PATH") {
            return Span { start: 0, end: path };
        }
    }
    Span { start: 0, end }
}

/// What stands behind the slash; no slash and nothing else is no arguments.
pub(super) fn arguments<'a>(name: &'static str, text: &'a [u8], word_at: Span) -> Result<Args<'a>, Fault> {
    let slash = skip_blanks(text, word_at.end);
    match text.get(slash) {
        None => Ok(Args::new(text, text.len())),
        Some(b'/') => Ok(Args::new(text, slash + 1)),
        Some(_) => Err(Fault::new(
            "slash expected",
            Span { start: slash, end: text.len() },
            format!("{} stands behind {name} where a slash is expected", quoted(&text[slash..])),
            format!("write {name}/.."),
        )),
    }
}

/// Whether the record is a GOTO; [`goto`] reads it then.
pub(super) fn is_goto(text: &[u8]) -> bool {
    text.len() > GOTO.len() && text[..GOTO.len()].eq_ignore_ascii_case(GOTO) && matches!(text[GOTO.len()], b'/' | b' ')
}

/// Whether a GOTO was refused because it is a list of points.
pub(super) fn is_list(fault: &Fault) -> bool {
    fault.kind == "second slash"
}

/// Reads a GOTO with one point.
pub(super) fn goto(text: &[u8]) -> Result<Point, Fault> {
    point("GOTO", &mut arguments("GOTO", text, Span { start: 0, end: GOTO.len() })?)
}

const GOTO: &[u8] = b"GOTO";

/// Bytes of an unknown word that its message names.
const LONGEST_NAME: usize = 32;

#[inline]
fn point(name: &'static str, args: &mut Args<'_>) -> Result<Point, Fault> {
    let mut numbers = [0.0; 6];
    let found = args.numbers(&mut numbers)?;
    let [x, y, z, i, j, k] = numbers;
    let axis = match found {
        3 => None,
        6 => Some([i, j, k]),
        found => return Err(wrong_count(name, "3 or 6 numbers", found, args)),
    };
    Ok(Point { tip: [x, y, z], axis, at: args.all() })
}

/// So many numbers and nothing else.
pub(super) fn exactly<const N: usize>(name: &'static str, args: &mut Args<'_>) -> Result<[f64; N], Fault> {
    let mut numbers = [0.0; N];
    match args.numbers(&mut numbers)? {
        found if found == N => Ok(numbers),
        found => Err(wrong_count(name, &format!("{N} numbers"), found, args)),
    }
}

#[cold]
pub(super) fn wrong_count(name: &'static str, needs: &str, found: usize, args: &Args<'_>) -> Fault {
    Fault::new(
        "wrong number of arguments",
        args.all(),
        format!("{name} needs {needs}, found {found}"),
        "a line that was cut off ends in `$`; write every number, or delete those too many",
    )
}

/// MSYS gives the origin and the directions of X and Y.
fn frame_from_two_axes(n: &[f64; 9], at: Span) -> FrameRecord {
    let (x, y) = ([n[3], n[4], n[5]], [n[6], n[7], n[8]]);
    FrameRecord { axes: [x, y, vector::cross(x, y)], origin: [n[0], n[1], n[2]], at }
}

/// Rows of a 3×4 matrix: the axes stand in its first three columns, the origin in the fourth.
pub(super) fn frame_from_rows(n: &[f64; 12], at: Span) -> FrameRecord {
    let column = |i: usize| [n[i], n[4 + i], n[8 + i]];
    FrameRecord { axes: [column(0), column(1), column(2)], origin: column(3), at }
}

/// The next argument, which the record cannot do without.
pub(super) fn needed<'a>(name: &'static str, args: &mut Args<'a>) -> Result<Arg<'a>, Fault> {
    args.next()?.ok_or_else(|| {
        Fault::new(
            "argument missing",
            args.all(),
            format!("an argument of {name} is missing"),
            words::form(name).unwrap_or_else(|| format!("write {name} with all its arguments")),
        )
    })
}

/// The next argument must be this word; nothing else behind `name` is understood.
fn keyword(name: &'static str, args: &mut Args<'_>, word: &str) -> Result<(), Fault> {
    let arg = needed(name, args)?;
    if arg.is(word) { Ok(()) } else { Err(argument_not_yet(name, arg)) }
}

/// The text behind a text word, without blanks, one slash and a pair of quotes around it.
fn rest_as_text(text: &[u8], from: usize) -> Text<'_> {
    let mut start = skip_blanks(text, from);
    if text.get(start) == Some(&b'/') {
        start = skip_blanks(text, start + 1);
    }
    let mut end = text.len();
    if end >= start + 2 && text[start] == b'\'' && text[end - 1] == b'\'' {
        (start, end) = (start + 1, end - 1);
    }
    Text { bytes: &text[start..end], at: Span { start, end } }
}

/// `/name,TOOL,toolname`: names may hold commas, so the last `,TOOL,` ends the name.
fn operation_name(text: &[u8], from: usize) -> Text<'_> {
    const TOOL: &[u8] = b",TOOL,";
    let mut name = rest_as_text(text, from);
    if let Some(length) = name.bytes.windows(TOOL.len()).rposition(|bytes| bytes.eq_ignore_ascii_case(TOOL)) {
        name.bytes = &name.bytes[..length];
        name.at.end = name.at.start + length;
    }
    name
}

fn unknown(text: &[u8], mut at: Span) -> Fault {
    let named = at.start..at.end.min(at.start + LONGEST_NAME);
    if at.start == at.end {
        at.end = text.len();
    }
    let word = &text[at.start..at.end];
    Fault {
        kind: "unknown word",
        at,
        text: format!("{} is not a word of CL data known here", quoted(word)),
        help: Help::NearestTo(String::from_utf8_lossy(&text[named]).into_owned()),
        severity: Severity::Error,
    }
}

/// An argument that the record may legally have, but that means nothing here.
pub(super) fn argument_not_yet(name: &'static str, arg: Arg<'_>) -> Fault {
    Fault::new(
        name,
        arg.at,
        format!("{name} with {} is not understood yet", quoted(arg.text)),
        words::form(name).unwrap_or_else(|| "check the spelling; `explain --cl` lists the forms that are read".into()),
    )
}

/// A lathe's record.
pub(super) fn turning(at: Span) -> Fault {
    Fault::new(
        "turning",
        at,
        "this is a turning file: records of a lathe are not understood",
        "post it for a lathe; only milling is understood here",
    )
}
