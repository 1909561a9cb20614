//! What a control would run, and no careful programmer writes.
//!
//! - Two deeds in one block (a motion and M8, a dwell and a tool change), whose order a control decides.
//! - A feed motion without tool, spindle, length compensation, F, or with F in inverse time that is not its own.
//! - A rapid with F or in inverse time.
//! - A motion without work offset or unit, and on LinuxCNC without length compensation.
//! - A block that names the unit and not the rest of a complete modal state.
//! - On LinuxCNC a length compensation that shares a block, M3 without S, a block that does nothing.

use super::super::Control;
use super::super::axes::{Axes, is_rotary};
use super::super::meaning::{Address, Command, Meaning, Word};
use super::super::state::{Compensation, Distance, FeedMode, LeftOn, Length, Spindle};
use super::super::trace::Effect;
use super::Machine;

/// Rules for a block before it is executed.
pub(super) fn block(machine: &Machine, command: &Command) -> Result<(), String> {
    one_deed(command)?;
    if command.has(Meaning::Home) || command.has(Meaning::TiltOffTurning) {
        return Err("a motion to reference points or zero that no block states".to_owned());
    }
    let vector = command.words.iter().filter(|word| matches!(word.address, Address::Vector(_))).count();
    let begins = |meaning: &Meaning| matches!(meaning, Meaning::TipControl(true) | Meaning::LengthWithTipControl(_));
    let tips = machine.state.under_tip_control() || command.meanings.iter().any(begins);
    if vector > 0 && (vector < 3 || !tips) {
        return Err("a tool vector without all its components, or without tip control".to_owned());
    }
    let rotary = |word: &Word| matches!(word.address, Address::Axis(letter) if is_rotary(letter));
    if machine.state.vector.is_some() && tips && vector == 0 && command.words.iter().any(rotary) {
        return Err("a rotary word where the tool axis is given by its components".to_owned());
    }
    if command.has(Meaning::Orient) && command.meanings.len() + command.words.len() > 1 {
        return Err("the rotary axes turn to a plane in a block with other words".to_owned());
    }
    let on_or_off = |word: &Word| word.address == Address::Smoothing(1) && [0.0, 1.0].contains(&word.value);
    if machine.control == Control::Fanuc && command.has(Meaning::Smoothing) && !command.words.iter().any(on_or_off) {
        return Err("G5.1 without Q0 and Q1".to_owned());
    }
    let linuxcnc = machine.control == Control::LinuxCnc;
    if command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Units(_))) {
        complete(machine.control, command)?;
    }
    let on = |meaning: &Meaning| matches!(meaning, Meaning::LengthOn | Meaning::LengthWithTipControl(_));
    if machine.gauge_line && command.meanings.iter().any(on) {
        return Err("a length offset under words of the gauge line".to_owned());
    }
    if !linuxcnc {
        return Ok(());
    }
    if command.has(Meaning::LengthOn) && (command.meanings.len() > 1 || command.words.len() > 1) {
        return Err("G43 H shares its block with what has no business there".to_owned());
    }
    let starts =
        command.has(Meaning::Spindle(Spindle::Clockwise)) || command.has(Meaning::Spindle(Spindle::CounterClockwise));
    if starts && !command.words.iter().any(|word| word.address == Address::Speed) {
        return Err("S is missing".to_owned());
    }
    Ok(())
}

/// Codes whose order in the block decides, and a cycle without its position.
pub(super) fn clear(control: Control, command: &Command) -> Result<(), String> {
    let on = command.meanings.iter().any(|meaning| matches!(meaning, Meaning::CoolantOn(_)));
    let off = command.meanings.iter().any(|meaning| matches!(meaning, Meaning::CoolantOff(_)));
    if on && off {
        return Err("coolant on and off in one block".to_owned());
    }
    let own_block = |meaning: &Meaning| match meaning {
        Meaning::ModalCall | Meaning::Ends(LeftOn::Shift) => true,
        Meaning::TipControl(_) => control != Control::Heidenhain,
        _ => false,
    };
    let process = |word: &Word| matches!(word.address, Address::Feed | Address::Speed | Address::Tool);
    let words = command.has_axes() || command.words.iter().any(process);
    let shared = words || command.meanings.len() > 1;
    let plane = control == Control::Siemens && command.has(Meaning::Tilt);
    if shared && command.meanings.iter().any(own_block) || words && plane {
        return Err("MCALL or a change of the kinematics with other words".to_owned());
    }
    if shared && command.has(Meaning::Smoothing) && control != Control::Heidenhain {
        return Err("smoothing in a block with other words".to_owned());
    }
    if command.has(Meaning::RigidTapping) && !command.words.iter().any(|word| word.address == Address::Speed) {
        return Err("M29 without its S".to_owned());
    }
    if command.has(Meaning::Home) && !command.has_axes() && command.meanings.len() > 1 {
        return Err("reference points in a block with another code".to_owned());
    }
    let cycle = command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Cycle(_)));
    let moves_or_feeds = command.has_axes() || command.words.iter().any(|word| word.address == Address::Feed);
    if command.has(Meaning::RigidTapping) && !cycle && (moves_or_feeds || command.meanings.len() > 1) {
        return Err("M29 in a block with other codes or words than its S and its thread".to_owned());
    }
    if cycle && command.has(Meaning::Continuous) {
        return Err("P of a cycle and of G64 in one block".to_owned());
    }
    if cycle && !command.has_axes() {
        return Err("a cycle without a position".to_owned());
    }
    Ok(())
}

/// At most one of: motion, dwell, tool change, spindle, coolant, stop, end.
fn one_deed(command: &Command) -> Result<(), String> {
    let deed = |meaning: &&Meaning| {
        matches!(
            meaning,
            Meaning::Dwell
                | Meaning::ToolChange
                | Meaning::Stop
                | Meaning::OptionalStop
                | Meaning::End
                | Meaning::Spindle(_)
                | Meaning::CoolantOn(_)
                | Meaning::CoolantOff(_)
        )
    };
    let deeds = command.meanings.iter().filter(deed).count();
    let pole = command.has(Meaning::Pole);
    if deeds > 1 || deeds == 1 && (command.has_axes() || command.meanings.len() > 1 && !is_tool_call(command)) {
        return Err("a code that needs a block of its own has no business in this one".to_owned());
    }
    let feed = command.words.iter().any(|word| word.address == Address::Feed);
    if feed && (deeds == 1 || pole) {
        return Err("F has no business in this block".to_owned());
    }
    Ok(())
}

/// `TOOL CALL 5 Z S8000` means several codes.
fn is_tool_call(command: &Command) -> bool {
    command.has(Meaning::ToolChange) && command.has(Meaning::Idle)
}

/// A block that names the unit is a safety line: every group that may hold something else is in it.
fn complete(control: Control, command: &Command) -> Result<(), String> {
    let common = [
        (Meaning::Plane(super::super::state::Plane::Xy), "G17"),
        (Meaning::Compensation(Compensation::Off), "G40"),
        (Meaning::Distance(Distance::Absolute), "G90"),
        (Meaning::FeedMode(FeedMode::PerMinute), "G94"),
    ];
    let iso = [(Meaning::LengthOff, "G49"), (Meaning::CancelMotion, "G80")];
    let wanted = common.iter().chain(iso.iter().filter(|_| control != Control::Siemens));
    for (meaning, code) in wanted {
        if !command.has(*meaning) {
            return Err(format!("the safety line lacks {code}"));
        }
    }
    let offset = |meaning: &Meaning| matches!(meaning, Meaning::WorkOffset(_) | Meaning::FurtherOffset);
    if !command.meanings.iter().any(offset) {
        return Err("no work offset".to_owned());
    }
    if command.has_axes() || command.words.iter().any(|word| word.address == Address::Feed) {
        return Err("a motion has no business in a safety line".to_owned());
    }
    Ok(())
}

/// Whether a block of LinuxCNC may move nothing: it selects a tool, or holds codes alone, none of which waits for a
/// motion.
fn is_mode(command: &Command) -> bool {
    let waits = |meaning: &Meaning| {
        matches!(meaning, Meaning::Motion(_) | Meaning::Cycle(_) | Meaning::FeedMode(FeedMode::InverseTime))
    };
    let words = command
        .words
        .iter()
        .all(|word| matches!(word.address, Address::Tool | Address::PathTolerance | Address::RadiusRegister));
    words && !command.meanings.iter().any(waits)
}

/// A guard of LinuxCNC reads the length that is in force.
pub(super) fn guard(machine: &Machine) -> Result<(), String> {
    match machine.state.length {
        Some(Length::Register(_)) => Ok(()),
        _ if machine.control != Control::LinuxCnc || machine.careless => Ok(()),
        _ => Err("a guard before the length offset".to_owned()),
    }
}

/// Rules for what a block has done.
pub(super) fn effect(machine: &Machine, command: &Command, effect: &Effect, words: &Axes) -> Result<(), String> {
    let state = &machine.state;
    if machine.careless {
        return if effect.cuts() { programmed(machine, effect) } else { Ok(()) };
    }
    if *effect == Effect::Modal && machine.control == Control::LinuxCnc && !is_mode(command) {
        return Err("a block that moves nothing".to_owned());
    }
    let feed = command.words.iter().any(|word| word.address == Address::Feed);
    if feed && matches!(effect, Effect::Rapid | Effect::Machine) {
        return Err("a rapid in inverse time or with F".to_owned());
    }
    if matches!(effect, Effect::Dwell(_)) && state.feed_mode == Some(FeedMode::InverseTime) {
        return Err("a dwell in inverse time".to_owned());
    }
    if matches!(effect, Effect::Machine | Effect::Rapid) && state.feed_mode == Some(FeedMode::InverseTime) {
        return Err("a rapid in inverse time".to_owned());
    }
    if state.rigid && effect.moves() && !matches!(effect, Effect::Hole(_)) {
        return Err("a motion between M29 and its thread".to_owned());
    }
    if !effect.moves() || matches!(effect, Effect::Orient) {
        return Ok(());
    }
    if state.units.is_none() {
        return Err("neither inches nor millimetres are in force".to_owned());
    }
    if *effect == Effect::Machine {
        return Ok(());
    }
    let length = matches!(state.length, Some(Length::Register(_))) != machine.gauge_line;
    let needs_length = effect.cuts() || machine.control == Control::LinuxCnc || words.contains('Z');
    if state.work_offset.is_none() || needs_length && !length {
        return Err("a motion without work offset or length offset".to_owned());
    }
    if effect.cuts() { cut(machine, effect) } else { Ok(()) }
}

fn cut(machine: &Machine, effect: &Effect) -> Result<(), String> {
    let state = &machine.state;
    let turns = matches!(state.spindle, Some(Spindle::Clockwise | Spindle::CounterClockwise));
    let stopped = !turns || state.stopped_by_thread && !effect.is_thread();
    if state.tool.is_none() || stopped && !machine.dry {
        return Err("a feed motion without tool or with the spindle off".to_owned());
    }
    programmed(machine, effect)
}

/// A cut without F, which every control refuses.
fn programmed(machine: &Machine, effect: &Effect) -> Result<(), String> {
    let state = &machine.state;
    let own = match effect {
        Effect::Hole(hole) => hole.cycle.feed.is_some() || effect.is_thread(),
        _ => false,
    };
    if state.feed.is_none() && !own {
        let inverse = state.feed_mode == Some(FeedMode::InverseTime);
        return Err(if inverse { "G93 without F" } else { "G1 without F" }.to_owned());
    }
    if state.feed_mode.is_none() {
        return Err("neither G93 nor G94 is in force".to_owned());
    }
    if matches!(effect, Effect::Hole(_)) && state.feed_mode == Some(FeedMode::InverseTime) {
        return Err("a cycle in inverse time".to_owned());
    }
    Ok(())
}
