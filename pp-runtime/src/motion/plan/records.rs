//! Records without motion: the state that each changes, and the steps that it needs.

use std::ops::RangeInclusive;

use crate::diag::code::{config, plan};
use crate::options::{OptionalStops, StretchMode, Transition};
use crate::program::{
    BlockPlace, Dwell, Event, Interruption, Location, MachineFunction, NewStart, ReferenceGeometry, RotaryDirection,
    TextKind, ToolCall, is_nc_text,
};

use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::Planner;
use crate::motion::plan::obligations::SequencePlace;
use crate::motion::plan::tool::LoadedTool;
use crate::motion::step::BlockReason;
use crate::motion::step::{Sink, Step};

/// Dwells that can be written with three decimals, s.
const DWELL: RangeInclusive<f64> = 0.001..=99_999.0;

/// Plans a record without motion; `between`: it comes between two operations and belongs to the second.
#[cold]
pub(crate) fn record<S: Sink>(planner: &mut Planner<'_, S>, event: &Event<'_>, between: bool) -> Planned {
    planner.cutter.check_record(event)?;
    Records { planner, between }.take(event)
}

/// Writes a dwell: DELAY, or that at the bottom of a hole.
pub(crate) fn delay<S: Sink>(planner: &mut Planner<'_, S>, dwell: Dwell) -> Planned {
    let seconds = planner.spindle.seconds(dwell)?;
    if seconds <= 0.0 {
        return Ok(());
    }
    if !DWELL.contains(&seconds) {
        let (low, high) = (DWELL.start(), DWELL.end());
        let fault = plan::WORD.fault(format_args!("a dwell of {seconds} s cannot be written"));
        return Err(fault.help(format_args!("give a dwell of {low} to {high} s")).into());
    }
    // The tool waits with the spindle off where SPINDL/OFF comes before.
    planner.stop_spindle()?;
    let output = planner.mover.output_mut();
    output.cancel_inverse_time()?;
    output.times_mut().wait(seconds / 60.0);
    Ok(output.step(&Step::Dwell { seconds })?)
}

/// The planner while it takes a record.
struct Records<'p, 'a, S> {
    planner: &'p mut Planner<'a, S>,
    between: bool,
}

/// Writes the blocks of the shop that wait for an approach.
pub(crate) fn come_to_approach<S: Sink>(planner: &mut Planner<'_, S>) -> Planned {
    for text in std::mem::take(&mut planner.at_approach) {
        Records { planner, between: true }.shop_block(&text, BlockPlace::AfterChange)?;
    }
    Ok(())
}

/// Writes the name of the operation that begins, which has waited for its first motion. `leaves`: the one before ends
/// with its retract, whose blocks come before the name.
pub(crate) fn come_to_name<S: Sink>(planner: &mut Planner<'_, S>, leaves: bool) -> Planned {
    let Some((at, name)) = planner.name_due.take() else { return Ok(()) };
    let now = planner.mover.output().location();
    planner.mover.output_mut().serve(at, BlockReason::Record);
    let mut records = Records { planner, between: true };
    if leaves {
        records.end_operation()?;
    }
    records.write_name(at, &name)?;
    planner.mover.output_mut().serve(now, BlockReason::Record);
    Ok(())
}

impl<S: Sink> Records<'_, '_, S> {
    fn take(&mut self, event: &Event<'_>) -> Planned {
        // A probe measures within its operation, where the last motion has led it.
        let probes = matches!(event, Event::Interruption(Interruption::Probe(_)));
        if self.between && !probes {
            self.planner.end_operation()?;
        }
        match *event {
            Event::NewStart(NewStart::Operation(_) | NewStart::Tool(_)) => {}
            Event::NewStart(_) | Event::Interruption(_) | Event::Function(MachineFunction::Delay(_)) => {
                come_to_name(self.planner, true)?;
            }
            Event::Text(TextKind::Message, _) => come_to_name(self.planner, false)?,
            _ => {}
        }
        // A block of the shop has a place of its own.
        let of_shop = matches!(event, Event::Interruption(Interruption::Insert(..) | Interruption::Code { .. }));
        if event.writes_block() && !of_shop {
            self.planner.carry_out_call()?;
            if !matches!(event, Event::Text(..)) {
                self.begin_program()?;
            }
        }
        match *event {
            // Motions are items of their own.
            Event::Motion(_) => Ok(()),
            Event::NewStart(start) => self.new_start(start),
            Event::Interruption(interruption) => {
                if !of_shop {
                    self.planner.spindle.hold();
                }
                self.interruption(interruption)
            }
            Event::Function(function) => self.function(function),
            Event::Reference(geometry) => {
                match geometry {
                    ReferenceGeometry::From(pose) => self.planner.mover.count_from(&pose),
                    ReferenceGeometry::ClearancePlane(plane) => {
                        let auto = self.planner.policy.options.rapids.transition == Transition::Auto;
                        if auto && self.between && self.planner.clearance.changes(plane) {
                            come_to_name(self.planner, true)?;
                            self.leave()?;
                        }
                        self.planner.clearance.set_plane(plane);
                    }
                }
                Ok(())
            }
            Event::Text(TextKind::Name, _) => Ok(()),
            Event::Text(TextKind::MachineName, name) => {
                self.compare_machine(name);
                Ok(())
            }
            Event::Text(TextKind::Message, text) if self.between => self.announce(&Step::Message { text }),
            Event::Text(TextKind::Message, text) => {
                Ok(self.planner.mover.output_mut().step(&Step::Message { text })?)
            }
        }
    }

    fn new_start(&mut self, start: NewStart<'_>) -> Planned {
        match start {
            NewStart::Operation(name) => self.name_operation(name),
            NewStart::Tool(call) => self.call_tool(&call),
            NewStart::SetUp(number) => self.change_set_up(number),
            NewStart::SafeSequence => self.leave(),
            NewStart::Home => self.go_home(),
        }
    }

    fn interruption(&mut self, interruption: Interruption<'_>) -> Planned {
        match interruption {
            Interruption::Stop => self.stop(false, false),
            Interruption::OptionalStop if self.planner.mover.position_mut().take_stop() => Ok(()),
            Interruption::OptionalStop => self.stop(true, false),
            Interruption::BlockSkip { on } => self.planner.skip_blocks(on),
            Interruption::Probe(blocks) => self.probe(blocks),
            Interruption::Insert(text, place) => self.shop_block(text, place),
            Interruption::Code { letter, number, place } => {
                self.shop_block(format!("{}{number}", char::from(letter)).as_bytes(), place)
            }
        }
    }

    /// Nothing comes before the complete state and the retract.
    fn begin_program(&mut self) -> Planned {
        match self.planner.mover.restarts() {
            0 => Ok(self.planner.mover.machine_retract()?),
            _ => Ok(()),
        }
    }

    /// A block of the shop: at its place, or at once.
    fn shop_block(&mut self, text: &[u8], place: BlockPlace) -> Planned {
        match place {
            BlockPlace::AtApproach => {
                self.planner.at_approach.push(text.to_vec());
                return Ok(());
            }
            BlockPlace::BeforeChange => {}
            BlockPlace::InOrder => {
                self.check_place(text)?;
                self.planner.carry_out_call()?;
            }
            BlockPlace::AfterChange => self.planner.carry_out_call()?,
        }
        self.begin_program()?;
        self.planner.spindle.hold();
        self.raw(text)
    }

    /// What clamps, opens or changes something between the call of a tool and its change: the CL data does not say with
    /// which tool.
    fn check_place(&self, text: &[u8]) -> Result<(), Fault> {
        let Some(tool) = self.planner.tooling.next().filter(|_| self.planner.tooling.needs_change()) else {
            return Ok(());
        };
        let text = String::from_utf8_lossy(text);
        let words = &self.planner.policy.options.standstill;
        let Some(effect) = words.iter().filter(|word| word.is_in(&text)).find_map(|word| word.effect) else {
            return Ok(());
        };
        let fault = plan::NC_TEXT.fault(format_args!(
            "`{}` (effect \"{}\") comes between the call of T{} and the motion after it: before the tool change or after it is not \
             stated",
            text.trim(),
            effect,
            tool.number
        ));
        Err(fault.help(format_args!(
            "state it in `[cl.words]`: `{{ blocks = \"{}\", at = \"before_change\" }}`, \"after_change\" or \"at_approach\"; of \
             AUXFUN and PREFUN `\"AUXFUN/..\" = {{ at = .. }}`",
            text.trim()
        )))
    }

    fn function(&mut self, function: MachineFunction) -> Planned {
        match function {
            MachineFunction::Spindle(command) => {
                self.planner.spindle.request(command, self.between);
                if self.between { Ok(()) } else { self.planner.apply_spindle(false) }
            }
            MachineFunction::Coolant(kind) => {
                self.planner.request_coolant(kind);
                if self.between { Ok(()) } else { self.planner.apply_coolant() }
            }
            MachineFunction::Compensation(asked) => {
                let remark = self.planner.cutter.request(&asked, self.planner.policy)?;
                if let Some(remark) = remark {
                    self.planner.mover.output_mut().remark(remark);
                }
                Ok(())
            }
            MachineFunction::Tolerance(tolerance) => {
                self.planner.mover.set_tip_tolerance(tolerance.unwrap_or(self.planner.policy.options.tolerance_mm));
                Ok(())
            }
            MachineFunction::RotaryDirection(turning) => self.set_rotation_sense(turning),
            MachineFunction::Delay(dwell) => {
                if self.between && self.planner.spindle.is_on_requested_between() {
                    self.planner.apply_spindle(false)?;
                }
                delay(self.planner, dwell)
            }
            MachineFunction::Preselect(_) => Ok(()),
        }
    }

    /// Writes the step of a record between two operations that belongs to the second.
    fn announce(&mut self, step: &Step<'_>) -> Planned {
        let (next, now) = (self.planner.selection.next_is_written(), self.planner.selection.is_written());
        let output = self.planner.mover.output_mut();
        output.show(next);
        output.step(step)?;
        output.show(now);
        Ok(())
    }

    /// The tool leaves the part before the step of the record.
    fn leave(&mut self) -> Planned {
        self.planner.leave()?;
        self.planner.mover.output_mut().set_reason(BlockReason::Record);
        Ok(())
    }

    /// The optional stop of the configuration after an operation, unless the CL data stops there, or nothing comes
    /// after it. `other_tool`: another tool comes.
    fn stop_after_operation(&mut self, other_tool: bool) -> Planned {
        let wanted = match self.planner.policy.options.optional_stops {
            OptionalStops::None => false,
            OptionalStops::ToolChanges => other_tool,
            OptionalStops::Operations => true,
        };
        let worked = self.planner.mover.position().has_worked() && self.planner.selection.next_is_written();
        if wanted && worked { self.stop(true, true) } else { Ok(()) }
    }

    /// TOOL PATH.
    fn name_operation(&mut self, name: &[u8]) -> Planned {
        self.stop_after_operation(false)?;
        come_to_name(self.planner, true)?;
        let at = self.planner.mover.output().location();
        if !self.planner.may_stay() {
            self.end_operation()?;
        } else if self.planner.policy.options.rapids.transition == Transition::Auto {
            // Its first motion decides whether the tool leaves the part before.
            self.planner.name_due = Some((at, name.to_vec()));
            return Ok(());
        }
        self.write_name(at, name)
    }

    /// The tool leaves the part. The retract belongs to the operation before, so its blocks come before the name of the
    /// next one.
    fn end_operation(&mut self) -> Planned {
        self.leave()?;
        if self.planner.retracts_before_restart() {
            self.planner.mover.machine_retract()?;
            self.planner.mover.output_mut().set_reason(BlockReason::Record);
        }
        Ok(())
    }

    fn write_name(&mut self, at: Location, name: &[u8]) -> Planned {
        self.planner.mover.output_mut().times_mut().operation(at, name);
        self.announce(&Step::Operation { name })
    }

    /// A tool record.
    fn call_tool(&mut self, call: &ToolCall) -> Planned {
        let tool = self.resolve(call)?;
        let (next, current) = (self.planner.tooling.next(), self.planner.tooling.current());
        let other = next.or(current).is_none_or(|known| known.number != tool.number);
        if other {
            come_to_name(self.planner, true)?;
        }
        self.stop_after_operation(other || self.planner.tooling.changes_if_skipped(tool.number))?;
        let direct = self.planner.policy.options.rapids.transition == Transition::Direct;
        if other || direct || !self.planner.may_stay() {
            self.leave()?;
        }
        // Before another tool nothing has to be put away for itself.
        if let Some(left_out) = next.filter(|next| next.number != tool.number && next.number > 0) {
            let text = format!(
                "T{} is called, and T{} before anything is written: the first stays out of the program",
                left_out.number, tool.number
            );
            self.planner.mover.output_mut().remark(plan::TOOL.fault(text));
        }
        if other {
            self.planner.spindle.change_tool();
        }
        self.planner.tooling.prepare(tool);
        Ok(())
    }

    /// The tool of a record.
    fn resolve(&mut self, call: &ToolCall) -> Result<LoadedTool, Fault> {
        let planner = &mut *self.planner;
        let named = planner.policy.set_up.tools.get(&call.number).is_some_and(|tool| tool.name.is_some());
        if planner.abilities.tools_by_name && !named && call.number > 0 {
            let fault =
                plan::TOOL.fault(format_args!("T{} has no name, and tools are called by their names", call.number));
            return Err(fault.help(format_args!("give `[tools.{}] name` in the configuration", call.number)));
        }
        let needed = planner.needs_gauge_length();
        LoadedTool::resolve(call, planner.policy, needed, planner.abilities.registers)
    }

    /// STOP and OPSTOP, and the optional stop of the configuration.
    fn stop(&mut self, optional: bool, configured: bool) -> Planned {
        let planner = &mut *self.planner;
        let retract = planner.policy.options.stop_retract;
        // After the stop the retract axis moves from the position of the tool, so a tilted tool is led out before.
        planner.come_to(if retract { SequencePlace::Stop } else { SequencePlace::StopInPlace })?;
        planner.mover.output_mut().step(&Step::Stop { optional })?;
        // The operator may have done anything, and starts with the spindle as it was.
        if retract {
            planner.spindle.enter();
        } else {
            planner.spindle.forget();
        }
        planner.coolant.forget();
        planner.mover.position_mut().stop(configured);
        Ok(())
    }

    /// MACHIN.
    fn compare_machine(&mut self, name: &[u8]) {
        let machine = self.planner.mover.placer().machine().name();
        if !name.eq_ignore_ascii_case(machine.as_bytes()) {
            let name = String::from_utf8_lossy(name);
            let text = format!("the CL data was made for the machine `{name}` and is posted for {machine}");
            let fault = plan::MACHINE.fault(text).help("MACHIN has no effect on the program");
            self.planner.mover.output_mut().remark(fault);
        }
    }

    /// ROTABL.
    fn set_rotation_sense(&mut self, turning: RotaryDirection) -> Planned {
        let towards = self.planner.mover.placer().rotation_sense(turning);
        self.planner.course.set_sense(towards);
        if towards.is_none() && turning != RotaryDirection::Shortest {
            let fault =
                plan::COURSE.fault("ROTABL/NEXT rotates the table, and this machine has no rotary axis in the table");
            return Err(fault.help("remove it").into());
        }
        Ok(())
    }

    /// Writes a block of the CL data unchanged; after it position and state of the machine are unknown.
    fn raw(&mut self, text: &[u8]) -> Planned {
        if self.planner.policy.options.lift_mm.is_some() && self.planner.selection.is_written() {
            let fault = plan::NC_TEXT
                .fault("a dry run writes no NC text of the CL data: it could move an axis or start the spindle");
            return Err(fault
                .help("remove the record; for INSERT, `--insert comment` writes a comment instead")
                .into());
        }
        if !is_nc_text(text) {
            let fault = plan::NC_TEXT
                .fault("INSERT is empty or contains characters that are not ASCII, which controls read differently");
            let help = "use ASCII letters, digits and signs only, or `--insert comment`";
            return Err(fault.help(help).into());
        }
        self.leave()?;
        let planner = &mut *self.planner;
        planner.mover.output_mut().cancel_inverse_time()?;
        let words = String::from_utf8_lossy(text);
        let mut words_of_it = planner.policy.options.standstill.iter().filter(|word| word.is_in(&words));
        let stands = words_of_it.next();
        if stands.is_some_and(|word| word.effect.is_none()) {
            let text = format!(
                "`{}` is declared \"none\", and its statement in `[cl.words]` does not confirm it",
                words.trim()
            );
            let help = "written at the machine retract with the spindle off; if it moves nothing, confirm it there: `harmless = true`";
            planner.mover.output_mut().remark(plan::NC_TEXT.fault(text).help(help));
        }
        if stands.is_some() {
            planner.come_to(SequencePlace::Standstill)?;
        } else if planner.mover.position().is_in_frame() {
            planner.mover.machine_retract()?;
        }
        planner.mover.output_mut().step(&Step::Raw { text })?;
        planner.spindle.reset();
        planner.coolant.forget();
        planner.mover.position_mut().forget();
        Ok(())
    }

    /// Blocks with which a probe measures from where the tool is; after them position and state of the machine are
    /// unknown.
    fn probe(&mut self, blocks: &[String]) -> Planned {
        let planner = &mut *self.planner;
        let fault = |text: &str, help: &str| Err(plan::PROBE.fault(text).help(help).into());
        if planner.policy.options.lift_mm.is_some() && planner.selection.is_written() {
            return fault("a dry run does not probe: it would measure where nothing is", "post it without the dry run");
        }
        if !planner.mover.position().is_known() {
            return fault(
                "a probe measures here, and no motion leads to its point",
                "program RAPID and GOTO before it",
            );
        }
        if planner.mover.placer().mode() == StretchMode::Tcp {
            return fault(
                "macros of a probe do not run under tip control",
                "set `mode = \"axes\"` or \"plane\" for its operation in `[operations]`",
            );
        }
        if planner.spindle.running().is_some() {
            return fault("the spindle is on where a probe measures", "give SPINDL/OFF before the motion to its point");
        }
        if planner.coolant.is_on() {
            return fault("the coolant is on where a probe measures", "give COOLNT/OFF before the motion to its point");
        }
        planner.mover.output_mut().cancel_inverse_time()?;
        planner.mover.output_mut().step(&Step::Probe { blocks })?;
        planner.spindle.reset();
        planner.coolant.forget();
        planner.mover.position_mut().forget();
        Ok(())
    }

    /// GOHOME without a point: the machine retract, then the parking position where one is configured.
    fn go_home(&mut self) -> Planned {
        self.planner.come_to(SequencePlace::Home)?;
        let placer = self.planner.mover.placer();
        let parks = self.planner.policy.options.park.contains_key(&placer.chain()[placer.retract_axis()].letter);
        let position = self.planner.mover.position_mut();
        position.forget();
        if !parks {
            position.retract();
            position.park();
        }
        Ok(())
    }

    /// Another set-up: the part has another origin and another work offset. Its rotation is that of the source.
    fn change_set_up(&mut self, number: u32) -> Planned {
        let Some(part) = self.planner.policy.set_up.clamping(number) else {
            return Err(config::SET_UP.fault(format_args!("set-up {number} is not configured")).into());
        };
        self.planner.mover.set_part_origin(part.part_origin);
        let word = part.work_offset;
        self.leave()?;
        self.planner.mover.position_mut().forget();
        // CLEARP was given in the other set-up.
        self.planner.clearance.change_set_up();
        Ok(self.planner.mover.output_mut().step(&Step::WorkOffset { word })?)
    }
}
