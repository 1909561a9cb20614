//! A statement to a typed record.
//!
//! `MAJOR[/argument,argument..]`: the word is looked up in `words`, and each record checks its arguments completely;
//! an argument that is not understood is never passed over. Text words take the rest of the statement as it is.

use super::Dialect;
use super::args::{Arg, Args, skip_blanks};
use super::fault::{Fault, Help, Span, quoted};
use super::record::{FeedUnit, FrameRecord, Point, Record, Text};
use super::words::{Use, Word, look_up};
use super::{spindle, tools, vector};
use crate::program::{Coolant, Units};

/// Reads one statement that is no comment. `text` is not empty.
pub(super) fn parse(text: &[u8]) -> Result<Record<'_>, Fault> {
    let word_at = major_word(text);
    let word = &text[word_at.start..word_at.end];
    let Some((name, usage)) = look_up(word) else { return Err(unknown(text, word_at)) };
    match usage {
        Use::Modelled(word) => modelled(word, name, text, word_at),
        Use::Inert => Ok(Record::Inert),
        Use::Later => Err(not_yet(name, word_at)),
        Use::Refused(reason) => Err(Fault::new(
            name,
            word_at,
            format!("{name} is refused: {reason}"),
            "have the CAM system leave it out, or delete the record if it is known not to matter",
        )),
        Use::Turning => Err(turning(word_at)),
    }
}

/// Whether a record takes whatever arguments it has, so that a line joined to it would vanish in them.
pub(super) fn takes_anything(record: &Record<'_>) -> bool {
    matches!(record, Record::Inert | Record::PartName(_) | Record::Message(_) | Record::ToolPath(_))
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
    let first = major_word(text);
    let first = String::from_utf8_lossy(&text[first.start..first.end]);
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
        Word::ToolPath => return Ok(Record::ToolPath(operation_name(text, word_at.end))),
        _ => {}
    }
    let mut args = arguments(name, text, word_at)?;
    let record = match word {
        Word::Goto => return point(name, &mut args).map(Record::Goto),
        Word::From => return point(name, &mut args).map(Record::From),
        Word::Tlaxis => {
            let mut axis = [0.0; 3];
            exactly(name, &mut args, &mut axis)?;
            Record::ToolAxis { axis, at: args.all() }
        }
        Word::Msys => {
            let mut numbers = [0.0; 9];
            exactly(name, &mut args, &mut numbers)?;
            Record::Frame(frame_from_two_axes(&numbers, args.all()))
        }
        Word::Rapid => Record::Rapid,
        Word::Stop => Record::Stop,
        Word::Opstop => Record::OptionalStop,
        Word::Units => Record::Units(units(name, &mut args)?),
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
            Some(arg) if arg.is("ON") => true,
            Some(arg) if arg.is("OFF") => false,
            Some(arg) => return Err(argument_not_yet(name, arg)),
        }),
        Word::Fedrat => feed(name, &mut args)?,
        Word::Spindl => Record::Spindle(spindle::parse(name, &mut args)?),
        Word::Coolnt => Record::Coolant(coolant(needed(name, &mut args)?)?),
        Word::Cutcom | Word::Cycle => {
            keyword(name, &mut args, "OFF")?;
            Record::Inert
        }
        Word::Toolno => return tools::description(args),
        Word::Trntyp => {
            keyword(name, &mut args, "WORLD")?;
            let mut numbers = [0.0; 3];
            exactly(name, &mut args, &mut numbers)?;
            if numbers.iter().any(|value| value.abs() > 0.0) {
                return Err(not_yet("TRNTYP with numbers other than 0", args.all()));
            }
            Record::Inert
        }
        Word::Set => {
            keyword(name, &mut args, "MODE")?;
            keyword(name, &mut args, "ABSOL")?;
            Record::Inert
        }
        // Text words have been read above.
        Word::Partno | Word::Pprint | Word::ToolPath => Record::Inert,
    };
    match args.next()? {
        None => Ok(record),
        Some(arg) => Err(argument_not_yet(name, arg)),
    }
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

/// Reads a GOTO.
pub(super) fn goto(text: &[u8]) -> Result<Point, Fault> {
    point("GOTO", &mut arguments("GOTO", text, Span { start: 0, end: GOTO.len() })?)
}

const GOTO: &[u8] = b"GOTO";

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

/// Fills `numbers` completely.
pub(super) fn exactly(name: &'static str, args: &mut Args<'_>, numbers: &mut [f64]) -> Result<(), Fault> {
    match args.numbers(numbers)? {
        found if found == numbers.len() => Ok(()),
        found => Err(wrong_count(name, &format!("{} numbers", numbers.len()), found, args)),
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

fn units(name: &'static str, args: &mut Args<'_>) -> Result<Units, Fault> {
    let arg = needed(name, args)?;
    if arg.is("MM") {
        Ok(Units::Millimetres)
    } else if arg.is("INCH") || arg.is("INCHES") || arg.is("IN") {
        Ok(Units::Inches)
    } else {
        Err(Fault::new("unit", arg.at, format!("{} is not a unit known here", quoted(arg.text)), "write MM or INCH"))
    }
}

fn feed<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let first = needed(name, args)?;
    if first.is("RAPID") {
        return Ok(Record::Rapid);
    }
    let second = args.next()?;
    let (number, word) = if first.looks_numeric() {
        (first, second)
    } else if feed_unit(first).is_some() {
        (second.ok_or_else(|| wrong_count(name, "a number", 0, args))?, Some(first))
    } else {
        return Err(argument_not_yet(name, first));
    };
    let value = number.number()?;
    let unit = match word {
        None => FeedUnit::PerMinute,
        Some(word) => feed_unit(word).ok_or_else(|| argument_not_yet(name, word))?,
    };
    Ok(Record::Feed { value, unit, at: number.at, unit_at: word.map_or(number.at, |word| word.at) })
}

fn feed_unit(arg: Arg<'_>) -> Option<FeedUnit> {
    const UNITS: [(&str, FeedUnit); 6] = [
        ("MMPM", FeedUnit::MillimetresPerMinute),
        ("MMPR", FeedUnit::MillimetresPerRevolution),
        ("IPM", FeedUnit::InchesPerMinute),
        ("IPR", FeedUnit::InchesPerRevolution),
        ("PERMIN", FeedUnit::PerMinute),
        ("PERREV", FeedUnit::PerRevolution),
    ];
    UNITS.iter().find(|(word, _)| arg.is(word)).map(|(_, unit)| *unit)
}

fn coolant(arg: Arg<'_>) -> Result<Coolant, Fault> {
    const KINDS: [(&str, Coolant); 6] = [
        ("ON", Coolant::On),
        ("OFF", Coolant::Off),
        ("FLOOD", Coolant::Flood),
        ("MIST", Coolant::Mist),
        ("THRU", Coolant::Through),
        ("AIR", Coolant::Air),
    ];
    let kind = KINDS.iter().find(|(word, _)| arg.is(word)).map(|(_, kind)| *kind);
    kind.ok_or_else(|| argument_not_yet("COOLNT", arg))
}

/// The next argument, which the record cannot do without.
pub(super) fn needed<'a>(name: &'static str, args: &mut Args<'a>) -> Result<Arg<'a>, Fault> {
    args.next()?.ok_or_else(|| {
        Fault::new(
            "argument missing",
            args.all(),
            format!("an argument of {name} is missing"),
            format!("write {name} with all its arguments"),
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
    if at.start == at.end {
        at.end = text.len();
    }
    let word = &text[at.start..at.end];
    Fault {
        kind: "unknown word",
        at,
        text: format!("{} is not a word of CL data known here", quoted(word)),
        help: Help::NearestTo(String::from_utf8_lossy(&word[..word.len().min(20)]).into_owned()),
    }
}

fn not_yet(name: &'static str, at: Span) -> Fault {
    Fault::new(
        name,
        at,
        format!("{name} is not understood yet"),
        "have the CAM system write plain GOTO motion without this record; it is not ignored because it may matter",
    )
}

/// An argument that the record may legally have, but that means nothing here.
pub(super) fn argument_not_yet(name: &'static str, arg: Arg<'_>) -> Fault {
    Fault::new(
        name,
        arg.at,
        format!("{name} with {} is not understood yet", quoted(arg.text)),
        "check the spelling; if the record is right, have the CAM system leave it out",
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
