//! Rapids to positions of the machine: the machine retract, home positions, machine coordinates. Some of their blocks
//! cancel the length offset.

use std::io;

use crate::control::dialects::RetractForm;
use crate::motion::AxisWords;

use super::ModalWriter;
use crate::control::encode::modal_state::{After, LengthState};

impl ModalWriter<'_> {
    /// Writes the machine retract. Out of tip control that ends with the length offset it is always the block of
    /// machine coordinates, which ends both.
    pub(crate) fn retract(&mut self, words: &AxisWords) -> io::Result<()> {
        match self.retract {
            _ if self.tip.ends => self.machine_rapid(words),
            None => self.own_retract(),
            Some(RetractForm::AlongTool { block }) if self.modal.is_tool_called() => {
                self.retract_along_tool(block, words)
            }
            Some(RetractForm::MachineCoordinate | RetractForm::AlongTool { .. }) => self.machine_rapid(words),
            Some(form @ RetractForm::ReferencePosition { .. }) => self.reference_rapid(form, words),
        }
    }

    /// Writes the rapid of other linear axes to their home positions.
    pub(crate) fn home(&mut self, words: &AxisWords) -> io::Result<()> {
        match self.retract {
            Some(form @ RetractForm::ReferencePosition { .. }) => self.reference_rapid(form, words),
            Some(RetractForm::MachineCoordinate | RetractForm::AlongTool { .. }) | None => self.machine_rapid(words),
        }
    }

    /// Writes a rapid in machine coordinates. The motion code is unknown after it, and some controls cancel the length
    /// offset in it.
    pub(crate) fn machine_rapid(&mut self, words: &AxisWords) -> io::Result<()> {
        self.begin_retract()?;
        let length = &self.codes.length;
        if length.cancelled_by_machine_coordinates {
            if matches!(self.modal.length(), LengthState::On(_) | LengthState::Unknown) {
                self.writer.code(length.off);
            }
            self.modal.cancel_length();
        }
        let [before, after] = self.codes.machine;
        self.writer.code(before);
        self.axis_words(words, true);
        self.writer.code(after);
        self.modal.forget(After::MachineRapid(words));
        self.tip.ends = false;
        self.end()
    }

    /// Writes a rapid to the reference position: words of distances, all 0, so that the axes pass no other point.
    fn reference_rapid(&mut self, form: RetractForm, words: &AxisWords) -> io::Result<()> {
        let RetractForm::ReferencePosition { code, after, cancels_length } = form else { return Ok(()) };
        self.begin_retract()?;
        if cancels_length {
            self.modal.cancel_length();
        }
        self.writer.code(code);
        self.axis_words(&AxisWords { units: Default::default(), ..*words }, true);
        self.modal.forget(After::MachineRapid(words));
        self.end()?;
        self.block(after)
    }

    fn retract_along_tool(&mut self, block: &str, words: &AxisWords) -> io::Result<()> {
        self.begin_retract()?;
        self.modal.forget(After::MachineRapid(words));
        self.block(block)
    }

    /// Writes the blocks of the configuration; the modal state is unknown after them.
    fn own_retract(&mut self) -> io::Result<()> {
        self.begin_retract()?;
        let length = self.modal.length();
        let blocks = std::mem::take(&mut self.own_retract);
        self.fill_all(&blocks)?;
        self.own_retract = blocks;
        self.modal.forget(After::Anything);
        if let LengthState::On(register) | LengthState::Pending(register) = length {
            self.modal.set_length(LengthState::Pending(register));
        }
        Ok(())
    }

    fn begin_retract(&mut self) -> io::Result<()> {
        self.smooth(false)?;
        self.select_xy_plane()
    }
}
