//! Spindle, coolant and dwells.

use std::io;

use crate::control::dialects::{Spellings, coolant_index};
use crate::control::layout::Layout;
use crate::nc::Decimal;
use crate::program::{Coolant, Rotation};

use super::modal_writer::ModalWriter;

/// Writes spindle, coolant and dwell blocks. Coolant codes are those of the configuration, or those of the control.
#[derive(Debug)]
pub(crate) struct SpindleCoolantWriter {
    /// As in the configuration.
    coolant: [Option<[String; 2]>; 7],
}

impl SpindleCoolantWriter {
    pub(crate) fn new(layout: &Layout) -> Self {
        Self { coolant: layout.options.coolant.clone() }
    }

    /// Switches the spindle on.
    pub(crate) fn spindle(&self, speed: Decimal, rotation: Rotation, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.changed_speed(speed)?;
        let codes = out.codes();
        out.fill(codes.rotation(rotation))
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
        let index = coolant_index(kind)?;
        let given = self.coolant[index].as_ref().map(|[on, off]| [on.as_str(), off.as_str()]);
        given.or(codes.coolant.get(index).copied().flatten())
    }

    /// Switches coolant on.
    pub(crate) fn coolant(&self, kind: Coolant, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let code = self.codes(kind, out.codes()).map_or("", |[on, _]| on);
        out.modal().set_coolant(kind);
        out.block(code)
    }

    /// Switches coolant off, with the code of the kind that is on, or with the general code if that is unknown.
    pub(crate) fn coolant_off(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let (codes, kind) = (out.codes(), out.modal().take_coolant());
        let own = kind.and_then(|kind| self.codes(kind, codes));
        out.block(own.map_or(codes.coolant_off, |[_, off]| off))
    }
}
