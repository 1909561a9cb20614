//! Spindle, coolant and dwells.

use std::io;

use crate::control::dialects::Spellings;
use crate::control::layout::Layout;
use crate::control::mill_turn::ToolSpindle;
use crate::nc::Decimal;
use crate::program::{Coolant, Rotation};

use super::modal_writer::ModalWriter;

/// Writes spindle, coolant and dwell blocks. Coolant codes are those of the configuration, or those of the control.
#[derive(Debug)]
pub(crate) struct SpindleCoolantWriter {
    /// As in the configuration.
    coolant: [Option<[String; 2]>; 7],
    /// Spindle of the tool, where it is not that of the control.
    tool_spindle: Option<ToolSpindleBlocks>,
}

/// Blocks of a spindle.
#[derive(Debug)]
struct ToolSpindleBlocks {
    speed: String,
    /// Clockwise, counter-clockwise, off.
    switches: [String; 3],
}

impl SpindleCoolantWriter {
    pub(crate) fn new(layout: &Layout) -> Self {
        let blocks = |spindle: &ToolSpindle| {
            Some(ToolSpindleBlocks { speed: spindle.speed_block()?, switches: spindle.switches()? })
        };
        Self { coolant: layout.options.coolant.clone(), tool_spindle: layout.options.tool_spindle().and_then(blocks) }
    }

    /// Switches the spindle on.
    pub(crate) fn spindle(&self, speed: Decimal, rotation: Rotation, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.changed_speed(speed)?;
        if let Some(ToolSpindleBlocks { speed, switches: [clockwise, counter_clockwise, _] }) = &self.tool_spindle {
            out.fill(speed)?;
            return out.block(if rotation == Rotation::Clockwise { clockwise } else { counter_clockwise });
        }
        let codes = out.codes();
        out.fill(codes.rotation(rotation))
    }

    /// Switches the spindle off.
    pub(crate) fn spindle_off(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        match &self.tool_spindle {
            Some(ToolSpindleBlocks { switches: [_, _, off], .. }) => out.block(off),
            None => {
                let codes = out.codes();
                out.block(codes.spindle_off)
            }
        }
    }

    /// Writes a dwell, in several blocks if it is too long for one; each in whole milliseconds, as it is written.
    pub(crate) fn dwell(&self, seconds: f64, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let codes = out.codes();
        let mut rest = (seconds * 1e3).round() as u32;
        while rest > 0 {
            let piece = rest.min(codes.longest_dwell);
            out.values().seconds = Some(f64::from(piece) / 1e3);
            out.fill_all(codes.dwell)?;
            rest -= piece;
        }
        Ok(())
    }

    /// On and off codes of a kind of coolant.
    fn codes(&self, kind: Coolant, codes: &'static Spellings) -> Option<[&str; 2]> {
        let index = kind.index()?;
        let given = self.coolant[index].as_ref().map(|[on, off]| [on.as_str(), off.as_str()]);
        given.or(codes.coolant.get(index).copied().flatten())
    }

    /// Switches coolant on.
    pub(crate) fn coolant(&self, kind: Coolant, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let code = self.codes(kind, out.codes()).map_or("", |[on, _]| on);
        out.modal().add_coolant(kind);
        out.block(code)
    }

    /// Switches coolant off, with the code of each kind that is on. Where none is known to be on, those of flood and
    /// mist, which may be on; the general code of the control where it has neither. A code that several kinds have is
    /// written once.
    pub(crate) fn coolant_off(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let (codes, mut on) = (out.codes(), out.modal().take_coolants());
        if on.is_empty() {
            on = [Coolant::Flood, Coolant::Mist].into_iter().collect();
        }
        let mut written: Vec<&str> = Vec::new();
        for code in on.kinds().filter_map(|kind| self.codes(kind, codes)).map(|[_, off]| off) {
            if !written.contains(&code) {
                written.push(code);
            }
        }
        if written.is_empty() {
            written.push(codes.coolant_off);
        }
        written.into_iter().try_for_each(|code| out.block(code))
    }
}
