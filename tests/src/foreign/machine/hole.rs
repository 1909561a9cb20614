//! Holes: canned cycles of letters (G73 to G89), called cycles (MCALL, M99), and G33.1.

use super::super::axes::LETTERS;
use super::super::meaning::{Address, Command};
use super::super::state::{Cycle, CycleKind, FeedMode, MotionMode, ReturnLevel, Spindle};
use super::super::trace::{Effect, Hole};
use super::{Machine, modes};

/// Words of a canned cycle of letters, which stay in force until another motion mode.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Letters {
    /// The code; 0 for none.
    code: u32,
    reference: Option<f64>,
    bottom: Option<f64>,
    step: Option<f64>,
    dwell_s: f64,
}

impl Letters {
    /// Ends the cycle; whether one was in force.
    pub(super) fn end(&mut self) -> bool {
        std::mem::take(self).code != 0
    }
}

/// A canned cycle begins; the level before it is the initial level.
pub(super) fn begin(machine: &mut Machine, code: u32) -> Result<(), String> {
    if machine.state.motion != Some(MotionMode::Cycle) {
        let [_, _, normal] = modes::plane(&machine.state)?.letters();
        machine.initial_level = machine.state.position.get(normal);
    }
    machine.state.motion = Some(MotionMode::Cycle);
    machine.letters = Letters { code, ..Letters::default() };
    Ok(())
}

/// A block with axis words while a cycle of letters is in force: a hole at its position.
pub(super) fn of_letters(machine: &mut Machine, command: &mut Command) -> Result<Effect, String> {
    let [_, _, normal] = modes::plane(&machine.state)?.letters();
    let letters = &mut machine.letters;
    letters.reference = command.take(Address::Level).or(letters.reference);
    if matches!(letters.code, 73 | 83) {
        letters.step = command.take(Address::Step).or(letters.step);
    }
    let dwell_s = command.take(Address::Seconds);
    // G81 and G85 have no wait.
    let waits = !matches!(letters.code, 81 | 85);
    if matches!(letters.code, 82 | 89) && dwell_s.is_none() && letters.dwell_s <= 0.0 {
        return Err("G82 or G89 without P".to_owned());
    }
    if !waits && dwell_s.is_some() && machine.control == super::super::Control::LinuxCnc {
        return Err("P in a cycle without a wait".to_owned());
    }
    if waits {
        letters.dwell_s = dwell_s.unwrap_or(letters.dwell_s);
    }
    if machine.state.distance != Some(super::super::state::Distance::Absolute) {
        return Err("a canned cycle without absolute dimensions".to_owned());
    }
    letters.bottom = command.take(Address::Axis(normal)).or(letters.bottom);
    let letters = machine.letters;
    let kind = kind(machine, &letters)?;
    let (Some(reference), Some(bottom)) = (letters.reference, letters.bottom) else {
        return Err("a canned cycle without its levels".to_owned());
    };
    let cycle = Cycle { kind, reference, bottom, back_to: None, dwell_s: letters.dwell_s, feed: None, others: 0 };
    machine.state.cycle = Some(cycle);
    machine.place(command, &LETTERS)?;
    made(machine, cycle, MotionMode::Rapid)
}

fn kind(machine: &Machine, letters: &Letters) -> Result<CycleKind, String> {
    let step = || letters.step.ok_or_else(|| "a cycle in steps without Q".to_owned());
    Ok(match letters.code {
        81 | 82 => CycleKind::Drill,
        85 | 89 => CycleKind::Ream,
        83 => CycleKind::Peck { step: step()? },
        73 => CycleKind::ChipBreak { step: step()? },
        84 => CycleKind::Tap { pitch: pitch(machine)? },
        74 => CycleKind::Tap { pitch: -pitch(machine)? },
        code => return Err(format!("cycle G{code} is unknown here")),
    })
}

/// Advance per revolution that F and S make.
fn pitch(machine: &Machine) -> Result<f64, String> {
    let state = &machine.state;
    match (state.feed_mode, state.feed, state.speed) {
        (Some(FeedMode::PerRevolution), Some(feed), _) => Ok(feed),
        (Some(FeedMode::PerMinute), Some(feed), Some(speed)) => Ok(feed / speed),
        _ => Err("a thread without F and S".to_owned()),
    }
}

/// The defined cycle, at the position of the block.
pub(super) fn called(machine: &mut Machine, cycle: Option<Cycle>) -> Result<Effect, String> {
    let cycle = cycle.ok_or("a call of no cycle")?;
    let approach = machine.state.motion.unwrap_or(MotionMode::Rapid);
    made(machine, cycle, approach)
}

/// The tool is over the hole, then at the return level.
fn made(machine: &mut Machine, cycle: Cycle, approach: MotionMode) -> Result<Effect, String> {
    let [_, _, normal] = modes::plane(&machine.state)?.letters();
    let level = match (cycle.back_to, machine.state.return_level) {
        (Some(level), _) => level,
        (None, Some(ReturnLevel::Initial)) => machine.initial_level.ok_or("an initial level that is unknown")?,
        (None, Some(ReturnLevel::Reference)) => cycle.reference,
        (None, None) => return Err("neither G98 nor G99 is in force".to_owned()),
    };
    let back_to = level.max(cycle.reference);
    let over = machine.state.position.get(normal);
    machine.state.position.set(normal, back_to);
    Ok(Effect::Hole(Hole { cycle, back_to, approach, over }))
}

/// G33.1: to the bottom in step with the spindle, and back to where it began.
pub(super) fn rigid_tap(machine: &mut Machine, command: &mut Command) -> Result<Effect, String> {
    let [_, _, normal] = modes::plane(&machine.state)?.letters();
    let pitch = command.take(Address::Pitch).ok_or("a thread without its pitch")?;
    let pitch = if machine.state.spindle == Some(Spindle::CounterClockwise) { -pitch } else { pitch };
    let level = machine.state.position.get(normal).ok_or("a thread from an unknown level")?;
    let word = command.take_counted(Address::Axis(normal)).ok_or("a thread without its bottom")?;
    let bottom = machine.value_of(normal, word.value, word.counting)?;
    let kind = CycleKind::Tap { pitch };
    let cycle = Cycle { kind, reference: level, bottom, back_to: Some(level), dwell_s: 0.0, feed: None, others: 0 };
    Ok(Effect::Hole(Hole { cycle, back_to: level, approach: MotionMode::Rapid, over: Some(level) }))
}
