//! Blocks that change the frame of the words: tip control and tilted planes, and the restart points and tool changes
//! that reset them.

use std::io;

use super::modal_state::{After, LengthState};
use super::modal_writer::ModalWriter;
use crate::control::ControlFunction;
use crate::control::dialects::Cancel;
use crate::control::layout::Layout;
use crate::control::options::BlockNumbers;
use crate::motion::PoseRule;
use crate::nc::Decimal;

/// Writes the blocks that change the frame: those of the configuration, or those of the control.
#[derive(Debug)]
pub(crate) struct FrameWriter {
    /// The program uses tip control, tilted planes, and a dynamic work offset.
    uses: [bool; 3],
    /// Functions that are listed as installed.
    functions: Option<Vec<ControlFunction>>,
    tip_control: Option<[String; 2]>,
    safety: Option<Vec<String>>,
    /// Blocks of a turning machine after the safety blocks.
    mill_turn: Vec<String>,
    tool_change: Option<Vec<String>>,
    numbers: BlockNumbers,
    /// Restart points with a tool change so far.
    tool_changes: u32,
}

impl FrameWriter {
    pub(crate) fn new(layout: &Layout) -> Self {
        Self {
            uses: [layout.frames.tip_control, layout.frames.planes, layout.frames.dynamic_offset],
            functions: layout.options.functions.clone(),
            tip_control: layout.options.tip_control_codes().cloned(),
            safety: layout.options.safety.clone(),
            mill_turn: layout.options.mill_turn_blocks().cloned().collect(),
            tool_change: layout.options.tool_change.clone(),
            numbers: layout.program.line_numbers,
            tool_changes: 0,
        }
    }

    /// Switches tip control on or off. Where the length offset switches it on, that happens with the next motion.
    pub(crate) fn tip_control(&self, on: bool, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.select_xy_plane()?;
        out.modal().forget(After::FrameChange);
        let with_length = self.tip_control.is_none() && out.codes().tip.as_ref().is_some_and(|tip| tip.off.is_empty());
        out.set_tip_control(on, with_length);
        if let Some(codes) = &self.tip_control {
            return out.block(&codes[usize::from(!on)]);
        }
        let Some(tip) = &out.codes().tip else { return Ok(()) };
        if !on {
            out.smooth(false)?;
        }
        out.fill_all(if on { tip.on } else { tip.off })?;
        out.set_offset_lost(!on && tip.may_cancel_offset);
        Ok(())
    }

    /// Tilts the plane. The control rotates the axes to it and may change modal codes.
    pub(crate) fn tilt(&self, angles: [Decimal; 3], pose: Option<bool>, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let Some(plane) = &out.codes().plane else { return Ok(()) };
        out.select_xy_plane()?;
        out.restate_offset()?;
        if plane.length_first {
            out.call_length_now()?;
        }
        out.values().plane = angles;
        out.values().pose = match (pose, plane.pose) {
            (Some(higher), _) => plane.poses[usize::from(higher)],
            // Where both poses are the same, a control that needs a word still gets one.
            (None, PoseRule::Side) => plane.poses[1],
            (None, PoseRule::Nearest | PoseRule::Sign) => "",
        };
        out.fill_all(plane.on)?;
        out.modal().forget(After::FrameChange);
        Ok(())
    }

    /// Cancels the tilted plane.
    pub(crate) fn tilt_off(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let Some(plane) = &out.codes().plane else { return Ok(()) };
        out.smooth(false)?;
        out.fill_all(plane.off)?;
        out.modal().forget(After::FrameChange);
        Ok(())
    }

    /// Switches the dynamic work offset on or off.
    pub(crate) fn dynamic_offset(&self, on: bool, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let Some(codes) = out.codes().tip.as_ref().and_then(|tip| tip.dynamic_offset) else { return Ok(()) };
        out.block(codes[usize::from(!on)])?;
        out.modal().forget(After::FrameChange);
        Ok(())
    }

    /// Writes the blocks of a restart point, the first one with this block number if it has one. `changes_tool`: a tool
    /// change follows.
    pub(crate) fn restart(&mut self, number: u32, changes_tool: bool, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.smooth(false)?;
        self.tool_changes += u32::from(changes_tool);
        match self.numbers {
            BlockNumbers::Step(_) | BlockNumbers::Restarts => out.writer_mut().number_next(number),
            BlockNumbers::ToolChanges if changes_tool => out.writer_mut().number_next(self.tool_changes),
            BlockNumbers::ToolChanges | BlockNumbers::None => {}
        }
        self.modes(out)
    }

    /// Writes the blocks of a safety line.
    pub(crate) fn modes(&mut self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        out.smooth(false)?;
        out.modal().forget(After::Anything);
        out.set_tip_control(false, false);
        out.set_offset_lost(false);
        // Blocks of the shop state the blending as the shop wants it.
        out.note_blending();
        if let Some(safety) = &self.safety {
            out.fill_all(safety)?;
            if let Some([_, off]) = self.tip_control.as_ref().filter(|[_, off]| !safety.contains(off)) {
                out.block(off)?;
            }
            return self.mill_turn.iter().try_for_each(|block| out.block(block));
        }
        let codes = out.codes();
        self.cancel(true, out)?;
        out.fill_all(codes.safety)?;
        self.reset(out)?;
        self.cancel(false, out)?;
        self.mill_turn.iter().try_for_each(|block| out.block(block))?;
        let modal = out.modal();
        modal.set_feed_mode(codes.per_minute);
        modal.set_length(LengthState::Off);
        modal.set_plane(codes.arcs.planes[2]);
        Ok(())
    }

    /// Ends functions that a program before may have left on; `usual`: those that most controls have, or the others.
    fn cancel(&self, usual: bool, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let codes = out.codes();
        let is_due = |cancel: &&Cancel| cancel.usual == usual && cancel.is_due(self.functions.as_deref());
        codes.cancels.iter().filter(is_due).try_for_each(|cancel| out.block(cancel.block))
    }

    /// Cancels the frames that the program uses, or the configuration lists, and `safety` does not cancel.
    fn reset(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        let listed = |of: ControlFunction| self.functions.as_ref().is_some_and(|listed| listed.contains(&of));
        let functions = [ControlFunction::TipControl, ControlFunction::Planes, ControlFunction::DynamicOffset];
        let [tip_control, planes, dynamic_offset] =
            std::array::from_fn(|index| self.uses[index] || listed(functions[index]));
        let codes = out.codes();
        if dynamic_offset {
            self.dynamic_offset(false, out)?;
        }
        match (&self.tip_control, &codes.tip) {
            // Whatever the program uses: kinematics of LinuxCNC may begin in tip control.
            (Some([_, off]), _) => out.block(off)?,
            (None, Some(tip)) if tip_control => out.fill_all(tip.reset)?,
            (None, _) => {}
        }
        match &codes.plane {
            Some(plane) if planes => out.fill_all(plane.reset),
            Some(_) | None => Ok(()),
        }
    }

    /// Writes the change to the tool of the values.
    pub(crate) fn tool_change(&self, out: &mut ModalWriter<'_>) -> io::Result<()> {
        match &self.tool_change {
            Some(blocks) => out.fill_all(blocks)?,
            None => {
                let codes = out.codes();
                out.fill_all(codes.tool_change)?;
                let speed = out.values().speed;
                out.modal().set_speed(speed);
            }
        }
        out.modal().forget(After::ToolChange);
        Ok(())
    }
}
