//! What a reader has to know of the configuration: names of axes, codes that the shop has brought in, offsets.

use std::io::{self, SeekFrom};

use super::read::{AxisName, Family, Vocabulary, WorkOffset, coolant};
use crate::cl::{self, ReadSeek};
use crate::config::Config;
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
    let lines = config.control.program.start.iter().chain(&config.control.program.end);
    let lines = lines.chain(setup.safety.iter().flatten()).chain(setup.tool_change.iter().flatten());
    let clamps = config.motion.rotaries.clamp.values().flat_map(|codes| [&codes.on, &codes.off]);
    let coolants = setup.coolant.iter().flatten().flatten();
    let mut known: Vec<Vec<u8>> = Vec::new();
    for line in lines.chain(clamps).chain(coolants) {
        known.push(line.trim().as_bytes().to_vec());
        known.extend(line.split_whitespace().map(|word| word.as_bytes().to_vec()));
    }
    let kinds = [coolant::FLOOD, coolant::MIST, coolant::THROUGH, coolant::AIR];
    let codes = setup.coolant.iter().zip(kinds).filter_map(|(codes, bit)| Some((codes.as_ref()?, bit)));
    let mut switches: Vec<(Vec<u8>, u8, bool)> = Vec::new();
    for ([on, off], bit) in codes {
        switches.push((on.trim().as_bytes().to_vec(), bit, true));
        // One code may switch off several kinds.
        let off = off.trim().as_bytes().to_vec();
        match switches.iter_mut().find(|(code, _, on)| *code == off && !on) {
            Some((_, bits, _)) => *bits |= bit,
            None => switches.push((off, bit, false)),
        }
    }
    let tools = config.set_up.tools.iter().filter_map(|(number, tool)| Some((tool.name.clone()?, *number)));
    Vocabulary {
        family,
        axes: machine.axes().iter().map(axis).collect(),
        known,
        coolant: switches,
        plain: setup.point == Some(false),
        tools: tools.collect(),
        rounding: 0.5 * 10_f64.powi(-(config.formats.linear(units) as i32)) * units.in_mm(),
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
