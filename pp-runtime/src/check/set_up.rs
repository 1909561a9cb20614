//! What a reader has to know of the configuration: names of axes, codes that the shop has brought in, offsets.

use std::io::{self, SeekFrom};

use super::read::{AxisName, Effect, Family, OwnPlace, OwnText, Vocabulary, WorkOffset, coolant};
use crate::cl::{self, ReadSeek};
use crate::config::Config;
use crate::control::LineEffect;
use crate::kinematics::{AnyMachine, AxisKind};
use crate::program::Event;
use crate::program::Units;

/// Unit of the CL data, from what stands in front of its first motion; the data is read from the same place again.
pub(super) fn units_of(input: &mut dyn ReadSeek, options: &cl::ReadingOptions) -> io::Result<Option<Units>> {
    let start = input.stream_position()?;
    let mut reader = cl::ClReader::new(&mut *input, options.clone());
    let mut moved = false;
    while !moved && reader.units().is_none() {
        match reader.next_event()? {
            Some((_, event)) => moved = matches!(event, Event::Move(_) | Event::Arc(_) | Event::Hole(_)),
            None => break,
        }
    }
    let units = reader.units();
    drop(reader);
    input.seek(SeekFrom::Start(start))?;
    Ok(units)
}

/// Names and codes of a program.
pub(super) fn vocabulary(machine: &dyn AnyMachine, family: Family, config: &Config, units: Units) -> Vocabulary {
    let axis = |axis: &crate::kinematics::Axis| AxisName {
        name: config.control.axes.get(&axis.letter).map_or_else(|| axis.letter.to_string(), String::clone).into_bytes(),
        rotary: axis.kind == AxisKind::Rotary,
        wrap: config.motion.rotaries.wrap.get(&axis.letter).copied(),
    };
    let setup = &config.control;
    let tools = config.set_up.tools.iter().filter_map(|(number, tool)| Some((tool.name.clone()?, *number)));
    Vocabulary {
        family,
        axes: machine.axes().iter().map(axis).collect(),
        own: own_lines(machine, config),
        effects: setup.effects.iter().map(|(text, effect)| (text.clone().into_bytes(), declared(*effect))).collect(),
        swivel_data: setup.swivel_data.clone().unwrap_or_default(),
        plain: setup.point == Some(false),
        tools: tools.collect(),
        rounding: 0.5 * 10_f64.powi(-(config.formats.linear(units) as i32)) * units.in_mm(),
    }
}

/// The lines that the configuration brings into a program.
fn own_lines(machine: &dyn AnyMachine, config: &Config) -> Vec<OwnText> {
    let control = &config.control;
    let mut own = Vec::new();
    let mut put = |text: &str, place: OwnPlace, coolant: Option<(u8, bool)>| {
        own.push(OwnText { text: text.trim().as_bytes().to_vec(), place, coolant });
    };
    control.program.start.iter().for_each(|line| put(line, OwnPlace::Start, None));
    control.program.end.iter().for_each(|line| put(line, OwnPlace::End, None));
    control.safety.iter().flatten().for_each(|line| put(line, OwnPlace::Safety, None));
    control.tool_change.iter().flatten().for_each(|line| put(line, OwnPlace::ToolChange, None));
    for (letter, codes) in &config.motion.rotaries.clamp {
        if let Some(axis) = machine.axes().iter().position(|axis| axis.letter == *letter) {
            put(&codes.on, OwnPlace::Clamp { axis, on: true }, None);
            put(&codes.off, OwnPlace::Clamp { axis, on: false }, None);
        }
    }
    let kinds = [coolant::FLOOD, coolant::MIST, coolant::THROUGH, coolant::AIR];
    for (codes, bit) in control.coolant.iter().zip(kinds) {
        if let Some([on, off]) = codes {
            put(on, OwnPlace::Coolant, Some((bit, true)));
            put(off, OwnPlace::Coolant, Some((bit, false)));
        }
    }
    if let Some([on, off]) = &control.tip_control {
        put(on, OwnPlace::TipControl { on: true }, None);
        put(off, OwnPlace::TipControl { on: false }, None);
    }
    config.cl.auxfun.iter().for_each(|code| put(&format!("M{code}"), OwnPlace::Insert, None));
    config.cl.prefun.iter().for_each(|code| put(&format!("G{code}"), OwnPlace::Insert, None));
    own
}

fn declared(effect: LineEffect) -> Effect {
    match effect {
        LineEffect::None => Effect::None,
        LineEffect::Coolant => Effect::Coolant,
        LineEffect::Spindle => Effect::Spindle,
        LineEffect::Stop => Effect::Stop,
        LineEffect::PositionLost => Effect::PositionLost,
        LineEffect::StateLost => Effect::StateLost,
        LineEffect::Measures => Effect::Measures,
    }
}

/// The work offset of each frame.
pub(super) fn offsets(config: &Config, family: Family) -> Vec<(u32, WorkOffset)> {
    let first = std::iter::once((1, &config.set_up.work_offset)).filter(|_| !config.set_up.frames.contains_key(&1));
    let frames = first.chain(config.set_up.frames.iter().map(|(number, word)| (*number, word)));
    frames.filter_map(|(number, word)| Some((number, offset(word, family)?))).collect()
}

/// `G54`, `G59.1`, `G505`, `G54.1 P3`, `G154 P2`; on Heidenhain the row, G54 being row 1.
fn offset(word: &str, family: Family) -> Option<WorkOffset> {
    let word = word.trim();
    if family == Family::Heidenhain {
        let row = match word.strip_prefix('G') {
            Some(code) => code.parse::<u32>().ok()?.checked_sub(53)?,
            None => word.parse().ok()?,
        };
        return Some(WorkOffset::Row(row));
    }
    if let Some(further) = word.strip_prefix("G54.1 P").or(word.strip_prefix("G154 P")) {
        return further.parse().ok().map(WorkOffset::Further);
    }
    let code: f64 = word.strip_prefix('G')?.parse().ok()?;
    Some(WorkOffset::Code((code * 10.0).round() as u32))
}
