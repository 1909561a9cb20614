//! The safe sequence from one cut to the next, one step per block.
//!
//! 1. coolant off, inverse time cancelled;
//! 2. out along the tool axis, then the retract axis to its machine position;
//! 3. tool, length offset, spindle, dwell;
//! 4. rotary axes alone, between their clamps;
//! 5. the other linear axes, before tip control where their words under it would move the retract axis;
//! 6. the retract axis down to the approach point;
//! 7. coolant on;
//! 8. along the tool axis to the first point.
//!
//! "Out" and "in" are along the tool axis. At program start, after a tool change and after a stop the position of the
//! machine is unknown.

use crate::diag::code::plan;
use crate::kinematics::Pose;
use crate::options::Transition;
use crate::program::{Location, Move};

use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::obligations::SequencePlace;
use crate::motion::plan::selection::Opening;
use crate::motion::plan::tool::LoadedTool;
use crate::motion::plan::{MotionAndNext, Planner, records};
use crate::motion::rotary::RotaryTarget;
use crate::motion::source::Next;
use crate::motion::step::BlockReason;
use crate::motion::step::{Sink, Step, ToolRoutine};
use crate::tolerance::writer::{LEADS_OUT, LED_OUT, ON_LINE, SAME_AXIS};

impl<S: Sink> Planner<'_, S> {
    /// Step 1 and the first half of 2, if the tool is at the part.
    pub(crate) fn leave(&mut self) -> Planned {
        if !self.mover.position().is_known() {
            return Ok(());
        }
        self.mover.output_mut().set_reason(BlockReason::LeadOut);
        self.stop_coolant()?;
        self.mover.output_mut().cancel_inverse_time()?;
        let led_out = self.mover.position().led_out_mm();
        let here = *self.mover.here();
        let configured = self.policy.options.retract.distance_mm;
        let out = self.clearance.retract_distance_mm(&here.pose);
        match configured.or_else(|| out.map(|distance| distance + led_out)) {
            Some(distance) if led_out + LED_OUT < distance => {
                let (distance, what) = match configured {
                    Some(distance) => (distance, "`retract.distance` ="),
                    None => (distance - led_out, "to the clearance geometry,"),
                };
                let units = self.mover.placer().units();
                let out = self
                    .mover
                    .shifted(here.pose.tip + here.pose.axis.into_inner() * distance, &here)
                    .map_err(|fault| fault.context(format_args!("the retract {what} {}", units.length(distance))))?;
                self.mover.rapid_linear(&out)?;
                self.mover.position_mut().go_to(&out);
            }
            Some(_) => {}
            None if self.mover.retracts_along_tool() => {}
            None if led_out > LEADS_OUT => self.check_lead_out(led_out),
            None => {
                return Err(plan::RETRACT.fault(
                    "the tool has to leave the part here, but the CL data before this line does not retract it along its \
                     axis",
                )
                .help("give `retract.distance` in the configuration, or retract along the tool axis in CAM")
                .into());
            }
        }
        self.mover.position_mut().leave();
        Ok(())
    }

    /// Adds a remark where the CL data leads the tool out by less than the approach distance.
    fn check_lead_out(&mut self, led_out: f64) {
        let wanted = self.policy.options.approach.distance_mm;
        if led_out + LED_OUT < wanted {
            let units = self.mover.placer().units();
            let text = format!(
                "before this line the CL data retracts the tool by only {}, less than `approach.distance` = {}",
                units.coordinate(led_out),
                units.length(wanted)
            );
            let fault = plan::RETRACT.fault(text).help("give `retract.distance`, or retract further in CAM");
            self.mover.output_mut().remark(fault);
        }
    }

    /// Begins an operation. Returns true if it is the first that is written and not the first of the program: the state
    /// of the machine is unknown there.
    fn begin_operation(&mut self, opening: Opening) -> Result<bool, crate::motion::plan::ItemError> {
        if opening.ends {
            self.come_to(SequencePlace::SelectionEnd)?;
            self.mover.output_mut().times_mut().forget_empty();
        }
        self.mover.output_mut().show(opening.wanted);
        if opening.enters {
            self.mover.position_mut().enter();
            self.mover.output_mut().forget_hidden();
        }
        Ok(opening.enters)
    }

    /// Whether the machine retracts before the safety line: its codes must not move the tool down, or rotate it in the
    /// part.
    pub(crate) fn retracts_before_restart(&self) -> bool {
        let moves = self.abilities.length_call_may_move || self.mover.position().is_in_frame();
        moves && self.mover.restarts() > 0
    }

    /// The first motion of an operation, with the safe sequence before it.
    pub(crate) fn start(&mut self, ahead: MotionAndNext<'_>, operation: u64, planned: Option<RotaryTarget>) -> Planned {
        let opening = self.selection.begin(operation);
        let enters = self.begin_operation(opening)?;
        if self.selection.is_over() {
            return Ok(());
        }
        if self.continues() && !enters && !self.tooling.needs_change() {
            self.tooling.take_next();
            return self.start_directly(ahead, planned);
        }
        let prepared = self.mover.position().is_prepared() && self.tooling.next().is_none();
        if !prepared {
            self.restart(enters)?;
        }
        self.enter_mode()?;
        self.stop_spindle()?;
        match self.tooling.current() {
            Some(tool) => self.use_tool(tool)?,
            None => self.start_operation()?,
        }
        self.apply_spindle(!prepared)?;
        self.stop_spindle()?;
        self.spindle.note_thread(false);
        self.check_state(ahead.motion)?;
        self.tooling.note_cut();
        self.approach(ahead, planned)
    }

    /// Changes the tool that has been called, before a record that writes a block: records act in the order of the CL
    /// data.
    pub(crate) fn carry_out_call(&mut self) -> Planned {
        if self.tooling.next().is_none() || self.selection.is_over() {
            return Ok(());
        }
        let opening = self.selection.open();
        let enters = self.begin_operation(opening)?;
        let changes = enters || self.tooling.needs_change();
        if changes && !self.selection.is_over() { self.restart(enters) } else { Ok(()) }
    }

    /// Steps 1 to 3 up to the tool: the complete state, with the retract. The program can be entered here.
    fn restart(&mut self, enters: bool) -> Planned {
        let other = self.tooling.changes();
        let change = enters || self.tooling.needs_change();
        let wanted = self.tooling.take_next();
        self.leave()?;
        if other && !enters {
            self.end_tool()?;
        }
        self.mover.output_mut().set_reason(BlockReason::Start);
        if self.retracts_before_restart() && !enters {
            self.mover.machine_retract()?;
        }
        let tool = wanted.or(self.tooling.current());
        self.mover.restart(change && tool.is_some())?;
        self.mover.position_mut().forget_retract();
        // Where the program is entered here, the state of the coolant is unknown.
        self.coolant.forget();
        self.come_to(SequencePlace::CompleteState)?;
        if enters {
            self.spindle.enter();
        }
        if let Some(tool) = tool {
            self.load_tool(tool, change)?;
        }
        self.mover.position_mut().prepare();
        Ok(())
    }

    /// The blocks of the shop at the start of an operation.
    fn start_operation(&mut self) -> Planned {
        self.in_operation = true;
        if !self.abilities.operation_blocks.at_start {
            return Ok(());
        }
        if self.abilities.operation_blocks.stop_spindle[0] {
            self.spindle.stop(self.mover.output_mut())?;
        }
        self.shop_blocks(&Step::OperationBlocks { at_end: false })
    }

    /// Blocks of the shop at the machine retract, and the retract after them. They may leave every axis anywhere, and
    /// spindle and coolant on or off.
    fn shop_blocks(&mut self, blocks: &Step<'_>) -> Planned {
        self.mover.output_mut().step(blocks)?;
        self.mover.position_mut().forget_retract();
        self.mover.position_mut().forget_rotary_axes();
        self.spindle.reset();
        self.coolant.forget();
        if matches!(blocks, Step::ToolRoutine { routine: ToolRoutine::Measure | ToolRoutine::Check, .. }) {
            // Macros select modes and a work offset of their own, and not all of them set them back.
            self.restate_modes()?;
        }
        self.mover.machine_retract()
    }

    /// The blocks of a safety line again, with the coolant off.
    fn restate_modes(&mut self) -> std::io::Result<()> {
        self.mover.output_mut().restate_modes()?;
        self.stop_coolant()
    }

    /// The blocks of the shop at the end of the operation, if one has begun; the state of the machine is unknown after
    /// them.
    pub(crate) fn end_operation(&mut self) -> Planned {
        if !std::mem::take(&mut self.in_operation) || !self.abilities.operation_blocks.at_end {
            return Ok(());
        }
        self.come_to(SequencePlace::OperationEnd)?;
        if self.abilities.operation_blocks.stop_spindle[1] {
            self.spindle.stop(self.mover.output_mut())?;
        }
        self.mover.output_mut().step(&Step::OperationBlocks { at_end: true })?;
        self.spindle.reset();
        self.coolant.forget();
        self.mover.position_mut().forget();
        self.mover.output_mut().set_reason(BlockReason::Record);
        Ok(())
    }

    /// OPSKIP: the blocks from here on may be skipped, or no longer. The machine retracts before both, with the spindle
    /// off, and its state is unknown after both, so that the blocks after them are complete whether blocks were skipped
    /// or not.
    pub(crate) fn skip_blocks(&mut self, on: bool) -> Planned {
        if on == self.mover.output().is_skippable() {
            return Ok(());
        }
        if on || self.mover.output().has_skippable() {
            // Whichever tool is in the spindle afterwards, this one has been looked at.
            self.come_to(SequencePlace::BlockSkip)?;
        } else {
            let fault = plan::BLOCK_SKIP
                .fault("no motion, stop or NC text comes between OPSKIP/ON and OPSKIP/OFF: nothing is skipped");
            let help = "what other records between them set holds for the blocks after OPSKIP/OFF, whether blocks are skipped \
                        or not";
            self.mover.output_mut().remark(fault.help(help));
        }
        self.mover.output_mut().set_skippable(on)?;
        self.tooling.skip(on);
        self.coolant.forget();
        self.mover.skip_clamps();
        self.mover.position_mut().skip(on);
        self.mover.position_mut().forget();
        // Skipped or not, the machine is there.
        self.mover.position_mut().retract();
        Ok(())
    }

    /// The tool of step 3, with the blocks of the shop for it.
    fn load_tool(&mut self, tool: LoadedTool, change: bool) -> Planned {
        let before = self.tooling.current().and_then(|tool| tool.radius_mm);
        self.mover.output_mut().statistics_mut().end_tool(before);
        self.tooling.load(tool, change);
        self.mover.set_gauge_length(tool.length_mm);
        let given = self.policy.set_up.tools.get(&tool.number);
        let spindle = match tool.number {
            0 => None,
            _ => self.spindle.requested().resolve(given, self.policy)?,
        };
        let radius_delta = self.compensation().1.radius_delta(&tool)?;
        if change {
            self.come_to(SequencePlace::ToolChange)?;
        }
        self.mover.output_mut().step(&Step::Tool {
            number: tool.number,
            offset: tool.offset,
            next: self.tooling.following(tool.number, self.policy.options.preselect_first),
            speed: spindle.map(|spindle| spindle.word),
            radius_delta,
            change,
        })?;
        if change {
            // The change may leave every axis anywhere, and the spindle off.
            self.mover.position_mut().forget_retract();
            self.mover.position_mut().forget_rotary_axes();
            self.spindle.reset();
            self.mover.machine_retract()?;
            self.tool_routine(tool.number, ToolRoutine::Measure)?;
            self.tool_routine(tool.number, ToolRoutine::Start)?;
        }
        if self.tooling.take_end() && !change {
            self.tool_routine(tool.number, ToolRoutine::Start)?;
        }
        Ok(())
    }

    /// Waits until coolant has run out of the spindle, before its tool is changed.
    pub(crate) fn drain_spindle(&mut self) -> std::io::Result<()> {
        let seconds = self.policy.options.coolant.through_dwell_s;
        if self.coolant.take_drains() && seconds > 0.0 {
            let output = self.mover.output_mut();
            output.cancel_inverse_time()?;
            output.times_mut().wait(seconds / 60.0);
            output.step(&Step::Dwell { seconds })?;
        }
        Ok(())
    }

    /// The blocks of the shop at the start of an operation, the length of its tool, and its guards.
    fn use_tool(&mut self, tool: LoadedTool) -> Planned {
        self.start_operation()?;
        if self.mover.placer().gauge_line() {
            return Ok(());
        }
        self.mover.output_mut().step(&Step::Length { offset: tool.offset })?;
        let guarded = self.policy.options.guards.length_guard.unwrap_or(self.needs_gauge_length().is_some());
        let label = self.mover.restarts();
        if let Some(length) = tool.length_mm.filter(|_| guarded) {
            let (tolerance, offset, tool) = (self.policy.options.guards.length_tolerance_mm, tool.offset, tool.number);
            self.mover.output_mut().guard(&Step::LengthGuard { label, tool, offset, length, tolerance })?;
        }
        if let Some(guard) = self.compensation().1.guard(&tool) {
            self.mover.output_mut().guard(&guard)?;
        }
        Ok(())
    }

    /// Blocks of the shop for the tool that has cut, at the machine retract with spindle and coolant off.
    pub(crate) fn end_tool(&mut self) -> Planned {
        let Some(tool) = self.tooling.current().map(|tool| tool.number) else { return Ok(()) };
        let has_any = [ToolRoutine::End, ToolRoutine::Check].into_iter().any(|routine| self.has_routine(tool, routine));
        if !self.tooling.take_cut() || !has_any {
            return Ok(());
        }
        self.come_to(SequencePlace::ToolEnd)?;
        if self.abilities.retract_keeps_length {
            // It ends here, at the retract, and not where a macro has left the tool.
            self.restate_modes()?;
            self.mover.position_mut().forget_retract();
            self.mover.machine_retract()?;
        }
        self.tooling.end();
        self.tool_routine(tool, ToolRoutine::End)?;
        self.tool_routine(tool, ToolRoutine::Check)
    }

    /// Whether a tool has such blocks. In a dry run none that start the spindle.
    fn has_routine(&self, tool: u32, routine: ToolRoutine) -> bool {
        let dry = self.policy.options.lift_mm.is_some();
        self.policy.set_up.tools.get(&tool).is_some_and(|tool| match routine {
            ToolRoutine::Measure => tool.measured && !dry,
            ToolRoutine::Check => tool.checked && !dry,
            ToolRoutine::Start => !tool.start.is_empty(),
            ToolRoutine::End => !tool.end.is_empty(),
        })
    }

    /// Blocks of the shop for the tool in the spindle, if it has such.
    fn tool_routine(&mut self, tool: u32, routine: ToolRoutine) -> Planned {
        if !self.has_routine(tool, routine) {
            return Ok(());
        }
        if matches!(routine, ToolRoutine::Measure | ToolRoutine::Check) {
            self.go_to_tool_position()?;
        }
        self.shop_blocks(&Step::ToolRoutine { tool, routine })
    }

    /// Moves the axes to where a tool is measured; a remark where a rotary axis has no position there.
    fn go_to_tool_position(&mut self) -> Planned {
        let (placer, given) = (self.mover.placer(), &self.policy.options.tool_position);
        let letters = placer.rotaries().iter().map(|rotary| placer.chain()[rotary.index].letter);
        let without: Vec<String> = letters.filter(|letter| !given.contains_key(letter)).map(String::from).collect();
        if self.tooling.note_measured() && !without.is_empty() {
            let places: Vec<String> = without.iter().map(|letter| format!("{letter} = 0.0")).collect();
            let (without, places) = (without.join(" and "), places.join(", "));
            let text =
                format!("tools are measured or checked for breakage with {without} where the last cut has left them");
            let help = format_args!(
                "give `cycles.tool_position`, so that the table or the head is straight there: `{{ {places} }}`"
            );
            self.mover.output_mut().remark(plan::TOOL.fault(text).help(help));
        }
        self.mover.take_axes_to_tool_position()
    }

    /// Spindle and coolant of an operation that continues from the end of the last one: course changes may cut before
    /// its first motion.
    pub(crate) fn prepare_directly(&mut self, first: &Move) -> Planned {
        self.apply_spindle(false)?;
        self.stop_spindle()?;
        self.check_state(first)?;
        self.apply_coolant()
    }

    /// The first motion of an operation that continues from the end of the last one (`transition = "direct"`).
    fn start_directly(&mut self, ahead: MotionAndNext<'_>, planned: Option<RotaryTarget>) -> Planned {
        let first = ahead.motion;
        let place = self.mover.place(&first.pose, !first.rapid, planned)?;
        if self.mover.leaves_plane(&place) || first.rapid && self.may_enter_clearance(&place) {
            return self.index(ahead, planned);
        }
        let before = self.mover.position().pose();
        if first.rapid {
            self.mover.rapid_as_configured(first, &place)?;
        } else {
            self.mover.feed_to(&place, self.rate(first.feed)?)?;
            self.mover.position_mut().note_cut(&first.pose);
        }
        self.mover.position_mut().follow(&before, &first.pose);
        self.mover.arrive(&place);
        Ok(())
    }

    /// A rapid that rotates the table or the head.
    pub(crate) fn index(&mut self, ahead: MotionAndNext<'_>, planned: Option<RotaryTarget>) -> Planned {
        self.come_to(SequencePlace::Index)?;
        self.enter_mode()?;
        self.stop_spindle()?;
        self.approach(ahead, planned)
    }

    /// The safe sequence from the present place and back to it at feed, where a stretch of another mode begins with a
    /// cut.
    pub(crate) fn change_mode(&mut self, cut: &Move) -> Planned {
        let here = *self.mover.here();
        let words = self.mover.placer().rotary_words_of(&here.words);
        let back = Move { pose: here.pose, ..*cut };
        self.index(MotionAndNext::new(&back, &Next::None), Some(RotaryTarget { words, sense: None }))
    }

    /// Whether an operation may continue from the end of the last one.
    pub(crate) fn continues(&self) -> bool {
        self.linked && self.mover.position().is_known() && !self.modes.changes()
    }

    /// Whether the tool stays where it is at the name of an operation and at a call of the tool in the spindle: the
    /// first motion decides.
    pub(crate) fn may_stay(&self) -> bool {
        match self.policy.options.rapids.transition {
            Transition::Safe => false,
            Transition::Direct => true,
            Transition::Auto => !self.mover.placer().has_rotary_head() && self.clearance.in_force().is_some(),
        }
    }

    /// Sets the mode of the stretch that begins; the tool is at the machine retract.
    fn enter_mode(&mut self) -> Result<(), Fault> {
        let mode = self.modes.enter();
        self.mover.set_mode(mode);
        match self.usable.missing(mode) {
            Some(text) => Err(plan::MODE.fault(text)),
            None => Ok(()),
        }
    }

    /// Steps 4 to 8.
    fn approach(&mut self, ahead: MotionAndNext<'_>, planned: Option<RotaryTarget>) -> Planned {
        let first = &Move { pose: ahead.above.unwrap_or(ahead.motion.pose), ..*ahead.motion };
        if self.policy.options.approach.distance_mm <= 0.0 && !first.rapid {
            let fault =
                plan::APPROACH.fault("`approach.distance` = 0, and the motion to which this approach leads is a cut");
            return Err(fault.help("program a rapid to a point above it, or give a distance").into());
        }
        self.mover.begin_approach();
        let place = self.mover.place(&first.pose, false, planned)?;
        let (place, frame) = self.mover.framed_at(place)?;
        let distance = self.policy.options.approach.distance_mm;
        let above = if first.rapid && is_straight_down(&first.pose, ahead.next)? {
            place
        } else {
            let (Pose { tip, axis }, units) = (first.pose, self.mover.placer().units());
            self.mover.shifted(tip + axis.into_inner() * distance, &place).map_err(|fault| {
                fault.context(format_args!("the approach from `approach.distance` = {}", units.length(distance)))
            })?
        };
        self.mover.output_mut().set_reason(BlockReason::Approach);
        self.mover.approach_from_retract(&above, frame)?;
        self.mover.output_mut().statistics_mut().sequences += 1;
        self.apply_coolant()?;
        self.mover.position_mut().go_to(&above);
        self.mover.output_mut().set_reason(BlockReason::Record);
        if place.words != above.words {
            if first.rapid {
                self.mover.rapid_linear(&place)?;
            } else {
                self.mover.feed_block(&place, self.rate(first.feed)?)?;
            }
        }
        if !first.rapid {
            self.mover.position_mut().note_cut(&first.pose);
        }
        self.mover.position_mut().forget_lead_out();
        self.mover.arrive(&place);
        Ok(())
    }

    /// The end of the program up to the end code: coolant off, retract, spindle off, park.
    pub(crate) fn end(&mut self, at: Location) -> Planned {
        if !self.selection.is_over() {
            self.mover.output_mut().serve(at, BlockReason::Record);
            records::come_to_name(self, true)?;
            records::come_to_approach(self)?;
            self.skip_blocks(false)?;
        }
        if self.selection.is_over() {
            self.mover.output_mut().show(true);
            self.mover.output_mut().serve(at, BlockReason::End);
            return self.mover.park();
        }
        self.cutter.check_end()?;
        self.mover.output_mut().serve(at, BlockReason::LeadOut);
        self.come_to(SequencePlace::End)?;
        let (set_up, parks) = (&self.policy.set_up, !self.policy.options.park.is_empty());
        if parks && set_up.clampings().count() > 1 && self.mover.position().is_after_skip() {
            // The work offset in force depends on whether blocks before were skipped.
            self.restate_modes()?;
            self.mover.machine_retract()?;
        }
        if self.tooling.changes() && self.selection.next_is_written() {
            // The shop ends with another tool in the spindle.
            self.restart(false)?;
        }
        self.mover.park()
    }
}

/// Whether the next motion leads from `first` along -axis, with the same axis.
///
/// # Errors
/// If too many records come before it.
fn is_straight_down(first: &Pose, next: &Next) -> Result<bool, Fault> {
    let next = match next {
        Next::Motion(next) => next,
        Next::None => return Ok(false),
        Next::Unknown => {
            return Err(plan::APPROACH
                .fault("too many records between the first motion of an operation and the next")
                .help("the approach to the first point depends on the second: move these records after both"));
        }
    };
    let step = next.tip - first.tip;
    let along = step.dot(&first.axis);
    let across = step - first.axis.into_inner() * along;
    let turn = next.axis.into_inner() - first.axis.into_inner();
    Ok(along < 0.0 && across.norm() <= ON_LINE && turn.norm() <= SAME_AXIS)
}
