//! `CYCLE/..`: its words as written, in any order; what they mean depends on the CAM system.

use super::args::{Arg, Args};
use super::fault::{Fault, quoted};
use super::forms::feed_unit;
use super::parse::{argument_not_yet, needed};
use super::record::{Cycle, CycleKind, CycleState, MOST_POSITIONAL, Record, Return};

/// Reads all arguments.
pub(super) fn parse<'a>(name: &'static str, args: &mut Args<'_>) -> Result<Record<'a>, Fault> {
    let at = args.all();
    let first = needed(name, args)?;
    if let Some(state) = state(first) {
        return Ok(Record::CycleState { state, at: first.at });
    }
    let kind = kind(first).ok_or_else(|| argument_not_yet(name, first))?;
    let mut cycle = Cycle::new(kind, at);
    let mut only_kind = true;
    while let Some(arg) = args.next()? {
        match self::kind(arg) {
            // NX writes DRILL,DEEP.
            Some(kind) if only_kind && cycle.kind == CycleKind::Drill => cycle.kind = kind,
            _ => word(name, &mut cycle, arg, args)?,
        }
        only_kind = false;
    }
    Ok(Record::Cycle(cycle))
}

fn state(arg: Arg<'_>) -> Option<CycleState> {
    const STATES: [(&str, CycleState); 4] =
        [("OFF", CycleState::Off), ("ON", CycleState::On), ("INIT", CycleState::Initial), ("CLEAR", CycleState::Clear)];
    STATES.iter().find(|(word, _)| arg.is(word)).map(|(_, state)| *state)
}

fn kind(arg: Arg<'_>) -> Option<CycleKind> {
    CycleKind::WORDS.iter().find(|(word, _)| arg.is(word)).map(|(_, kind)| *kind)
}

fn word(name: &'static str, cycle: &mut Cycle, arg: Arg<'_>, args: &mut Args<'_>) -> Result<(), Fault> {
    if arg.is("1STPECK") {
        return put(name, &mut cycle.first_step, arg, args);
    }
    if arg.looks_numeric() {
        let value = arg.number()?;
        let Some(place) = cycle.positional.get_mut(cycle.positionals) else {
            return Err(argument_not_yet(name, arg));
        };
        if cycle.positionals == 0 {
            cycle.depth_at = arg.at;
        }
        *place = value;
        cycle.positionals += 1;
        debug_assert!(cycle.positionals <= MOST_POSITIONAL);
        return Ok(());
    }
    if let Some(unit) = feed_unit(arg) {
        let value = needed(name, args)?.number()?;
        return match cycle.feed.replace((value, unit)) {
            None => Ok(()),
            Some(_) => Err(twice(arg)),
        };
    }
    if arg.is("FEDTO") || arg.is("DEPTH") {
        let depth = needed(name, args)?;
        if cycle.fedto.is_some() || cycle.depth.is_some() {
            return Err(twice(arg));
        }
        let place = if arg.is("FEDTO") { &mut cycle.fedto } else { &mut cycle.depth };
        *place = Some(depth.number()?);
        cycle.depth_at = depth.at;
        return Ok(());
    }
    if arg.is("RTRCTO") || arg.is("RETURN") {
        let level = needed(name, args)?;
        let level = if level.is("AUTO") { Return::Auto } else { Return::Level(level.number()?) };
        if cycle.back_to.replace(level).is_some() {
            return Err(twice(arg));
        }
        let mut ahead = args.clone();
        if ahead.next()?.is_some_and(|next| next.is("MANUAL")) {
            *args = ahead;
        }
        return Ok(());
    }
    if arg.is("DWELL") {
        let mut ahead = args.clone();
        if ahead.next()?.is_some_and(|next| next.is("REV")) {
            *args = ahead;
            return put(name, &mut cycle.dwell_turns, arg, args);
        }
        return put(name, &mut cycle.dwell, arg, args);
    }
    let place = if arg.is("RAPTO") {
        &mut cycle.rapto
    } else if arg.is("CLEAR") {
        &mut cycle.clear
    } else if arg.is("STEP") || arg.is("INCR") || arg.is("SUBPECK") {
        &mut cycle.step
    } else if arg.is("REV") {
        &mut cycle.dwell_turns
    } else if arg.is("BACK") {
        &mut cycle.back
    } else if arg.is("ORIENT") {
        &mut cycle.orient
    } else {
        return Err(argument_not_yet(name, arg));
    };
    put(name, place, arg, args)
}

/// The number behind a word.
fn put(name: &'static str, place: &mut Option<f64>, word: Arg<'_>, args: &mut Args<'_>) -> Result<(), Fault> {
    let value = needed(name, args)?.number()?;
    if place.replace(value).is_some() { Err(twice(word)) } else { Ok(()) }
}

fn twice(word: Arg<'_>) -> Fault {
    Fault::new("CYCLE", word.at, format!("{} is said twice", quoted(word.text)), "write every level of a cycle once")
}
