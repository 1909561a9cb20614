//! Arguments of single words: states, feeds, waits, planes and changes of coordinates.

use super::args::{Arg, Args};
use super::fault::{Fault, quoted};
use super::parse::{argument_not_yet, exactly, needed, wrong_count};
use super::record::{AxisPlane, FeedUnit, Record};
use crate::program::{Coolant, CutterSide, Dwell, Rotation, Turning, Units};

/// `x,y,z`, or `NOMORE` or `0` for none.
pub(super) fn shift(name: &'static str, args: &mut Args<'_>) -> Result<Option<[f64; 3]>, Fault> {
    if is_cancel(args)? { Ok(None) } else { exactly(name, args).map(Some) }
}

pub(super) fn transformation<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let at = args.all();
    if is_cancel(args)? {
        return Ok(Record::Transformation { matrix: None, at });
    }
    Ok(Record::Transformation { matrix: Some(exactly(name, args)?), at })
}

/// `NOMORE` or a single 0; takes it if so.
fn is_cancel(args: &mut Args<'_>) -> Result<bool, Fault> {
    let mut ahead = args.clone();
    let Some(first) = ahead.next()? else { return Ok(false) };
    let none = first.is("NOMORE") || (first.looks_numeric() && first.number()?.abs() < f64::MIN_POSITIVE);
    let cancels = none && ahead.next()?.is_none();
    if cancels {
        *args = ahead;
    }
    Ok(cancels)
}

pub(super) fn on_or_off(name: &'static str, arg: Arg<'_>) -> Result<bool, Fault> {
    if arg.is("ON") {
        Ok(true)
    } else if arg.is("OFF") {
        Ok(false)
    } else {
        Err(argument_not_yet(name, arg))
    }
}

pub(super) fn compensation<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    const SIDES: [(&str, CutterSide); 4] =
        [("OFF", CutterSide::Off), ("ON", CutterSide::On), ("LEFT", CutterSide::Left), ("RIGHT", CutterSide::Right)];
    let first = needed(name, args)?;
    let found = SIDES.iter().find(|(word, _)| first.is(word)).map(|(_, side)| *side);
    let side = found.ok_or_else(|| argument_not_yet(name, first))?;
    let (mut register, mut plane) = (None, None);
    while side != CutterSide::Off
        && let Some(arg) = args.next()?
    {
        let known = AxisPlane::WORDS.iter().find(|(word, _)| arg.is(word)).map(|(_, plane)| *plane);
        if arg.looks_numeric() && register.is_none() {
            register = Some(arg.integer()?);
        } else if known.is_some() && plane.is_none() {
            plane = known;
        } else {
            return Err(argument_not_yet(name, arg));
        }
    }
    Ok(Record::Compensation { side, register, plane })
}

pub(super) fn delay<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let arg = needed(name, args)?;
    let value = arg.number()?;
    if value < 0.0 {
        return Err(Fault::new("DELAY", arg.at, "a wait is not negative", "write DELAY/seconds"));
    }
    let dwell = match args.next()? {
        None => Dwell::Seconds(value),
        Some(word) if word.is("REV") => Dwell::Revolutions(value),
        Some(word) => return Err(argument_not_yet(name, word)),
    };
    Ok(Record::Delay { dwell, at: arg.at })
}

pub(super) fn clearance_plane<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let at = args.all();
    let first = needed(name, args)?;
    if let Some((_, plane)) = AxisPlane::WORDS.iter().find(|(word, _)| first.is(word)) {
        let distance = needed(name, args)?.number()?;
        return Ok(Record::ClearancePlane { normal: plane.normal(), distance, at });
    }
    let mut numbers = [first.number()?, 0.0, 0.0, 0.0];
    for place in &mut numbers[1..] {
        *place = needed(name, args)?.number()?;
    }
    let [a, b, c, distance] = numbers;
    Ok(Record::ClearancePlane { normal: [a, b, c], distance, at })
}

pub(super) fn turning_sense(name: &'static str, args: &mut Args<'_>) -> Result<Turning, Fault> {
    let arg = needed(name, args)?;
    if arg.is("SHORT") {
        return Ok(Turning::Shortest);
    }
    if arg.is("NEXT") {
        let sense = needed(name, args)?;
        if sense.is("CLW") {
            return Ok(Turning::Next(Rotation::Clockwise));
        }
        if sense.is("CCLW") {
            return Ok(Turning::Next(Rotation::CounterClockwise));
        }
        return Err(argument_not_yet(name, sense));
    }
    // An empty place is the nearer fault.
    while args.next()?.is_some() {}
    Err(Fault::new(
        name,
        args.all(),
        "ROTABL moves the table itself, which the postprocessor does from the tool axis",
        "have the CAM system give the tool axis with i, j, k; ROTABL/SHORT and ROTABL/NEXT,CLW are read",
    ))
}

pub(super) fn code<'a>(letter: u8, name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let arg = needed(name, args)?;
    let number = arg.integer()?;
    if let Some(when) = args.next()?
        && !when.is("NOW")
        && !when.is("NEXT")
    {
        return Err(argument_not_yet(name, when));
    }
    Ok(Record::Code { letter, number, at: arg.at })
}

pub(super) fn units(name: &'static str, args: &mut Args<'_>) -> Result<Units, Fault> {
    let arg = needed(name, args)?;
    if arg.is("MM") {
        Ok(Units::Millimetres)
    } else if arg.is("INCH") || arg.is("INCHES") || arg.is("IN") {
        Ok(Units::Inches)
    } else {
        Err(Fault::new("unit", arg.at, format!("{} is not a unit known here", quoted(arg.text)), "write MM or INCH"))
    }
}

pub(super) fn feed<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let first = needed(name, args)?;
    if first.is("RAPID") {
        return Ok(Record::Rapid);
    }
    if first.is("INVERS") {
        let how = needed(name, args)?;
        return if how.is("AUTO") { Ok(Record::InverseTime(true)) } else { Err(argument_not_yet(name, how)) };
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

pub(super) fn feed_unit(arg: Arg<'_>) -> Option<FeedUnit> {
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

pub(super) fn coolant(arg: Arg<'_>) -> Result<Coolant, Fault> {
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
