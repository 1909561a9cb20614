//! A program compared with its CL data, block by block.
//!
//! A block that ends a feed or a rapid at the part must end on the path of the CL data, in order; several blocks may
//! share a motion, and each is compared along its path, too. The motion from one operation to the next follows from the
//! specification: out along the tool axis, the retract axis to its machine position, rotary axes alone, the other
//! linear axes, down to the approach point. The modal state is compared at each block that moves.
//!
//! [`Phase::task`] is the table of what a block has to be in each phase; `cutting` has the tasks at the part, `links`
//! those at the machine retract, `approach` the way back, `records` what acts without motion. A block that carries out
//! nothing is reported, and the place at which the program continues is looked for among the motions ahead.

mod approach;
mod clear;
mod contour;
mod cutting;
mod cycles;
mod functions;
mod hole;
mod lines;
mod links;
mod machine_move;
mod messages;
mod obligations;
mod parking;
mod phase;
mod plane_guard;
mod progress;
mod rapid;
mod records;
mod restarts;
mod retract;
mod shop_lines;
mod station;

use std::io;
use std::rc::Rc;

use clear::KeepOut;
use contour::ContourState;
use cutting::MOST_NEEDLESS;
use functions::FunctionState;
use obligations::{Duties, DutyEvent, Station};
use phase::{Phase, Task};
use progress::ClProgress;
use restarts::Restarts;
use shop_lines::ShopLines;

use super::Checked;
use super::expect::{Expect, ExpectedAction, ExpectedItem, Required};
use super::geometry::ToolPose;
use super::policy::CheckPolicy;
use super::read::{Action, ArcMove, Block, Length, MAX_AXES, PlacedLines, State, TipControl, WorkPlane};
use super::report::{ShownBlock, Tally};
use super::rules::{ModalContext, OffsetsInForce, Rules, StateFault, StateItem, chord};
use super::stream::{ExecutedBlock, Observer};
use super::travel::{Findings, Travel};
use crate::check::tolerances::BOTH;
use crate::cl::ClEvents;
use crate::diag::Code;
use crate::diag::code::check;
use crate::kinematics::AnyMachine;
use crate::program::{Location, Rotation, Units};
use crate::shortcut::Shortcut;

/// Blocks after which it is decided which of two meanings a block had: it has been seen where the program goes on.
const DECIDED: u32 = 48;

/// Largest number of readings that are kept with the best.
const MOST_OTHERS: usize = 7;

/// A program while it is compared.
///
/// A block can have two meanings: a rapid out along the tool axis is one of the CL data, or the retract before it; an
/// approach ends over the cut that it interrupted, or over the next motion. What follows decides; until then each of
/// them is a reading of its own.
pub(super) struct Checker<'a> {
    /// The reading with the fewest findings so far.
    reading: Reading<'a>,
    others: Vec<Reading<'a>>,
    /// Blocks since the last of them has begun.
    apart: u32,
    /// State after the last block that was shown to an observer.
    before: State,
}

/// One reading of a program.
#[derive(Clone)]
struct Reading<'a> {
    comparison: Comparison<'a>,
    phase: Phase,
}

/// Everything of a comparison that does not depend on the phase.
#[derive(Clone)]
struct Comparison<'a> {
    rules: Rules<'a>,
    progress: ClProgress<'a>,
    travel: Travel,
    tally: Tally,
    previous: Previous,
    setters: Setters,
    /// The block at hand has led the tool along the CL data.
    arrived: bool,
    /// The last block has been compared to its end: `previous` has its modes.
    compared: bool,
    duties: Duties,
    /// What the last cut required, if its modal state was right: so is that of the cuts after it, until a block has
    /// other words than those of a motion.
    right_state: Option<Rc<Required>>,
    functions: FunctionState,
    contour: ContourState,
    shop_lines: ShopLines,
    /// Linear axes at their parking positions: bits.
    parked: u16,
    /// Linear axes at their positions for changing or measuring a tool: bits for each [`Station`].
    at_station: [u16; Station::ALL.len()],
    /// Blocks of the shop's machine retract that have come.
    own_retract: usize,
    restarts: Restarts,
    way: BlockMeaning,
}

/// Which of two meanings a block has.
#[derive(Debug, Clone, Copy, Default)]
struct BlockMeaning {
    /// The block at hand has been found to have two.
    two: bool,
    /// It has the second.
    other: bool,
    /// Rapids of the CL data to where the tool is are done by the next approach.
    keeps_rapids: bool,
}

impl BlockMeaning {
    /// Before another block.
    fn forget(&mut self) {
        (self.two, self.other) = (false, false);
    }
}

/// Words and modes after the last block.
#[derive(Debug, Clone, Copy, Default)]
struct Previous {
    words: [f64; MAX_AXES],
    /// Axes whose words are known: bits.
    known: u16,
    /// `words` are axis positions that have led the tool along the CL data to where it is.
    at_part: bool,
    /// Axes whose words have had the same meaning since: bits.
    same_meaning: u16,
    /// Value of the retract axis where its word has lost its meaning since.
    retract_axis: Option<f64>,
    /// It may be skipped.
    skippable: bool,
    /// It began a guard, whose text is its own.
    guards: bool,
    /// A probe has measured since the last machine retract: the tool is still in the plane of its point.
    probed: bool,
    /// A probe has measured since the last approach: the operation may go on.
    measured: bool,
    /// Chords of the arcs by their angle since the words gave the position in their plane, in diameters.
    chords: f64,
    /// Plane of the last arc of the operation.
    arc_plane: Option<WorkPlane>,
    length: Option<Length>,
    /// A tilted plane, or a zero that follows the table, is in force.
    framed: bool,
    tip_control: bool,
    process: PreviousProcess,
    tools: PreviousTools,
    /// Work offset and length at the first machine retract after the last cut or complete state, or since a line of the
    /// shop.
    offsets: Option<OffsetsInForce>,
}

/// Spindle and coolant after the last block.
#[derive(Debug, Clone, Copy, Default)]
struct PreviousProcess {
    /// One of them is known to be on.
    runs: bool,
    /// Sense of rotation of the spindle.
    rotation: Option<Rotation>,
    /// The spindle has been programmed since a complete state or a cycle that stops it.
    stated: bool,
    /// A dwell is the one after the spindle has started.
    waits: bool,
    /// The spindle, and the coolant, have been switched, and nothing has moved or waited since.
    switched: [bool; 2],
    /// The spindle has been switched on since the last motion.
    started: bool,
}

/// Tools that the program has changed to.
#[derive(Debug, Clone, Copy, Default)]
struct PreviousTools {
    /// The last one as the CL data calls it.
    current: Option<u32>,
    /// Blocks that may be skipped have begun or ended since.
    unsure: bool,
    has_changed: bool,
    first: Option<u32>,
    /// The program has selected the next tool by itself.
    prepares: bool,
}

/// The lines that have set parts of the state: a wrong value is reported there.
#[derive(Debug, Clone, Default)]
struct Setters {
    before: State,
    /// State before the last block that may have set something.
    at_block: State,
    lines: [Option<(u64, Vec<u8>)>; StateItem::ALL.len()],
}

impl Setters {
    /// Takes a block that may have set something.
    fn follow(&mut self, block: &Block, text: &[u8]) {
        let before = std::mem::replace(&mut self.before, block.state);
        self.at_block = before;
        for item in StateItem::ALL {
            if item.differs(&before, &block.state) {
                self.lines[item as usize] = Some((block.line, text.to_vec()));
            }
        }
    }

    fn line_of(&self, item: StateItem) -> Option<&(u64, Vec<u8>)> {
        self.lines[item as usize].as_ref()
    }
}

/// The block at hand.
#[derive(Clone, Copy)]
struct Current<'b> {
    block: &'b Block,
    shown: ShownBlock<'b>,
    /// The record that was next when the block began.
    at: Location,
    /// Its modes are those of the last block, which has been compared.
    same_modes: bool,
}

impl Previous {
    /// Keeps the place of the retract axis where its word loses its meaning: another frame begins, or another length.
    fn follow_frame(&mut self, rules: &Rules<'_>, before: &State, block: &Block) {
        let lost = self.known & !block.known_before & (1 << rules.words().retract()) != 0;
        if lost || before.frame() != block.state.frame() {
            self.retract_axis = self.retract_axis.or_else(|| self.value_of_retract_axis(rules, before, self.known));
        }
    }

    /// Value of the retract axis by its word in a state; `None` where it is unknown.
    fn value_of_retract_axis(&self, rules: &Rules<'_>, state: &State, known: u16) -> Option<f64> {
        let (words, index) = (rules.words(), rules.words().retract());
        let needed = if state.has_frame() { words.linear_bits() | words.rotary_bits() } else { 1 << index };
        let is_known = known & needed == needed;
        Some(words.axes(&self.words, state).filter(|_| is_known)?[index])
    }
}

impl<'a> Checker<'a> {
    pub(super) fn new(
        machine: Box<dyn AnyMachine>,
        policy: &'a CheckPolicy,
        units: Units,
        events: ClEvents<'a>,
        lines: PlacedLines,
    ) -> Self {
        let rules = Rules::new(machine, policy, units);
        let travel = Travel::new(&rules);
        let expect = Expect::new(rules.machine(), events, policy, rules.rounding().unit_mm);
        let comparison = Comparison {
            progress: ClProgress::new(expect),
            tally: Tally::new(policy.largest_path_mm(), travel.is_limited()),
            travel,
            duties: Duties::new(policy),
            rules,
            previous: Previous::default(),
            setters: Setters::default(),
            arrived: false,
            compared: false,
            right_state: None,
            functions: FunctionState::default(),
            contour: ContourState::default(),
            shop_lines: ShopLines::new(lines, policy),
            parked: 0,
            at_station: Default::default(),
            own_retract: 0,
            restarts: Restarts::default(),
            way: BlockMeaning::default(),
        };
        let reading = Reading { comparison, phase: Phase::Unknown { stopped: false } };
        Self { reading, others: Vec::new(), apart: 0, before: State::default() }
    }

    /// Compares one block.
    pub(super) fn block(&mut self, block: &Block, text: &[u8]) -> io::Result<()> {
        match self.others.is_empty() && !self.reading.may_have_two_meanings(block) {
            true => self.reading.block(block, text),
            false => self.block_of_all(block, text),
        }
    }

    /// Compares one block in all readings.
    #[inline(never)]
    fn block_of_all(&mut self, block: &Block, text: &[u8]) -> io::Result<()> {
        let mut begun = Vec::new();
        for reading in self.readings() {
            begun.extend(reading.block_in_two_ways(block, text)?);
        }
        self.apart = if begun.is_empty() { self.apart + 1 } else { 0 };
        self.others.append(&mut begun);
        // The first of those with the fewest findings is the best so far.
        let fewest = self.others.iter().map(Reading::count).min().unwrap_or_default();
        let best = self.others.iter().position(|reading| reading.count() == fewest);
        if let Some(best) = best.filter(|_| fewest < self.reading.count()) {
            std::mem::swap(&mut self.reading, &mut self.others[best]);
        }
        if self.apart > DECIDED || self.others.len() > MOST_OTHERS {
            self.others.clear();
        }
        Ok(())
    }

    /// Compares one block and shows it to an observer.
    pub(super) fn observed(&mut self, block: &Block, text: &[u8], observer: &mut dyn Observer) -> io::Result<()> {
        let comparison = &self.reading.comparison;
        let Previous { words: from, known, .. } = comparison.previous;
        let (progress, count) = (&comparison.progress, self.reading.count());
        let (record, operation) = (progress.location(), progress.operation());
        let allowance_mm = progress.allowance_mm();
        self.readings().for_each(|reading| reading.comparison.tally.put_aside_deviations());
        self.block(block, text)?;
        let deviations = self.readings().map(|reading| reading.comparison.tally.take_deviation());
        let deviation_mm = deviations.reduce(|best, _| best).flatten();
        let comparison = &self.reading.comparison;
        let findings = comparison.tally.count().saturating_sub(count);
        observer.executed(&ExecutedBlock {
            block,
            before: &self.before,
            record,
            operation,
            allowance_mm,
            findings,
            deviation_mm,
            from,
            known: known & block.known_before,
            rules: &comparison.rules,
        });
        self.before = block.state;
        Ok(())
    }

    /// Figures and findings, after the last line of the program.
    pub(super) fn conclude(mut self, lines: u64) -> Checked {
        self.readings().for_each(|reading| reading.end(lines));
        let best = self.others.into_iter().fold(self.reading, |best, other| match other.count() < best.count() {
            true => other,
            false => best,
        });
        let fault = best.comparison.progress.fault();
        Checked { outcome: best.comparison.tally.conclude(lines), fault }
    }

    /// All readings, the best so far first.
    fn readings(&mut self) -> impl Iterator<Item = &mut Reading<'a>> {
        std::iter::once(&mut self.reading).chain(&mut self.others)
    }
}

impl Reading<'_> {
    fn count(&self) -> u64 {
        self.comparison.tally.count()
    }

    /// The last line of the program has been read.
    fn end(&mut self, lines: u64) {
        let Self { comparison, phase } = self;
        if !matches!(phase, Phase::Ended) {
            let cut = comparison.progress.next().is_some_and(|item| matches!(item.action, ExpectedAction::Motion(_)));
            let text = match cut {
                true => "the program breaks off before the end of the CL data",
                false => "the program has no end code",
            };
            comparison.tally.found(
                check::MISSING,
                comparison.progress.location(),
                ShownBlock { line: lines, text: b"" },
                text,
            );
        }
    }

    /// Whether a block may be found to have two meanings.
    #[inline]
    fn may_have_two_meanings(&self, block: &Block) -> bool {
        let comparison = &self.comparison;
        match &self.phase {
            Phase::Cutting(_) | Phase::Leaving(_) if block.action.is_feed() => false,
            Phase::Cutting(cutting) => {
                let here = cutting.here.as_ref();
                let reaches = || {
                    let end = comparison.rules.pose(block);
                    comparison.may_reach_next(here, &end) && comparison.may_lead_out(cutting, block, &end)
                };
                comparison.rapid_is_needless(here) || comparison.rules.is_known(block, block.known) && reaches()
            }
            Phase::Leaving(leaving) => comparison.rapid_is_needless(Some(&leaving.here)),
            Phase::Retracted(retracted) => retracted.rewind.is_some() && block.action.is_rapid(),
            Phase::Unknown { .. } | Phase::Ended => false,
        }
    }

    /// Compares one block. Returns the reading in which it has its second meaning, if it has one and nothing is wrong
    /// with it.
    fn block_in_two_ways(&mut self, block: &Block, text: &[u8]) -> io::Result<Option<Self>> {
        if !self.may_have_two_meanings(block) {
            return self.block(block, text).map(|()| None);
        }
        self.comparison.way.forget();
        let mut other = self.clone();
        self.block(block, text)?;
        if !self.comparison.way.two {
            return Ok(None);
        }
        let count = other.count();
        other.comparison.way.other = true;
        other.block(block, text)?;
        other.comparison.way.forget();
        Ok((other.count() == count).then_some(other))
    }

    /// Compares one block.
    fn block(&mut self, block: &Block, text: &[u8]) -> io::Result<()> {
        let Self { comparison, phase } = self;
        comparison.progress.fill(2)?;
        let compared = std::mem::take(&mut comparison.compared);
        let same_modes = Shortcut::SameModes.is_on()
            && compared
            && block.only_moves
            && block.skippable == comparison.previous.skippable;
        let shown = ShownBlock { line: block.line, text };
        let current = Current { block, shown, at: comparison.progress.location(), same_modes };
        comparison.stop_at_fault(&current);
        if !same_modes {
            comparison.captured_state(&current);
            comparison.selected_tool(&current);
            comparison.right_state = None;
            comparison.previous.follow_frame(&comparison.rules, &comparison.setters.before, block);
            comparison.setters.follow(block, text);
        }
        comparison.block_skip(phase, &current)?;
        comparison.take_home(phase, block);
        let is_line = !block.goes_on;
        if is_line && comparison.progress.has_records_ahead() && comparison.is_raw(phase, &current) {
            *phase = comparison.forget(phase);
            return Ok(());
        }
        for fault in &block.faults {
            comparison.found(&current, check::WORD, &fault.text);
        }
        if is_line {
            comparison.messages(phase, &current)?;
        }
        if !phase.is_at_part() {
            comparison.rules.follow_frame(&block.state);
        }
        let task = phase.task(&block.action);
        if task == Task::AfterEnd {
            comparison.found(&current, check::ORDER, "block after the end code of the program");
            return Ok(());
        }
        comparison.restart_point(phase, &current);
        comparison.before_task(phase, &current);
        let own_places = block.own.as_ref().map_or(&[][..], |own| &own.places);
        let next = if let Some(index) = comparison.own_retract_block(own_places) {
            comparison.own_retract(index, phase, &current)?
        } else if block.action.moves() {
            comparison.moving(task, phase, &current)?;
            None
        } else {
            comparison.standing(task, phase, &current)?
        };
        if let Some(next) = next {
            *phase = next;
        }
        if !same_modes {
            let state = &block.state;
            comparison.previous.tip_control = state.tip_control != TipControl::Off;
            let (before, offsets) = (OffsetsInForce::of(&comparison.setters.at_block), OffsetsInForce::of(state));
            if block.own.is_some() && before != offsets || block.action == Action::ToolChange {
                comparison.previous.offsets = Some(offsets);
            }
            comparison.previous.process.runs = state.spindle_is_on() || state.coolant_is_on();
        }
        comparison.compared = true;
        Ok(())
    }
}

impl Comparison<'_> {
    /// A block that moves an axis; `phase` is that after it.
    fn moving(&mut self, task: Task, phase: &mut Phase, current: &Current<'_>) -> io::Result<()> {
        let block = current.block;
        self.tally.count_motion();
        (self.previous.process.switched, self.previous.process.started) = ([false; 2], false);
        if phase.is_retracted() || phase.is_unknown() {
            self.take_tool();
        }
        if let Action::Arc(_) = block.action {
            self.previous.arc_plane = block.state.plane;
        }
        let at_part = matches!(phase, Phase::Cutting(_));
        if self.rules.clamps() != 0 {
            let moved = self.rules.moved(&self.previous.words, self.previous.known, block);
            let fault = self.functions.clamps(block, moved, &self.rules, at_part);
            self.found_any(current, check::CLAMP, fault);
        }
        let linear = block.written & self.rules.words().linear_bits() != 0;
        if !block.action.leaves_words() && (linear || block.state.tip_control != TipControl::Off) {
            (self.parked, self.at_station) = (0, Default::default());
        }
        self.follow_contour(current);
        let keep_out = KeepOut::of(self, phase, block);
        let next = match (task, &mut *phase) {
            (Task::MachinePosition, phase) => self.machine_position(phase, current)?,
            (Task::Approach, Phase::Retracted(retracted)) => self.approach(retracted, current)?,
            (Task::Cycle, phase) => self.cycle(phase, current)?,
            (Task::Cut, Phase::Cutting(cutting)) => self.cut(cutting, current)?,
            (Task::Astray, phase) => self.astray(phase, current)?,
            (Task::OrientElsewhere, _) => {
                self.found(
                    current,
                    check::ORDER,
                    "the control positions the rotary axes to a tilted plane where none is expected",
                );
                None
            }
            (Task::Orient, phase) => {
                self.orient(phase, current);
                None
            }
            _ => None,
        };
        let arrives = phase.is_retracted() && matches!(next, Some(Phase::Cutting(_)));
        if let Some(next) = next {
            *phase = next;
        }
        if arrives {
            self.functions.arrive(&block.state, &self.rules);
        }
        let entered = keep_out.and_then(|keep_out| keep_out.fault(&self.rules, &self.previous, block));
        self.found_any(current, check::SEQUENCE, entered);
        self.follow_arcs(block);
        if block.action.leaves_words() {
            self.travel.machine_block(&self.rules, block);
        } else {
            let findings = Findings { tally: &mut self.tally, at: current.at, shown: current.shown };
            let before = (&self.previous.words, self.previous.known & block.known_before);
            self.travel.block(&self.rules, before, block, findings);
        }
        self.previous.words = block.values;
        if (block.known | block.written) & (1 << self.rules.words().retract()) != 0 {
            self.previous.retract_axis = None;
        }
        self.previous.at_part = std::mem::take(&mut self.arrived) && !block.state.has_frame();
        (self.previous.known, self.previous.same_meaning) = (block.known, block.known);
        Ok(())
    }

    /// A block that moves nothing.
    fn standing(&mut self, task: Task, phase: &mut Phase, current: &Current<'_>) -> io::Result<Option<Phase>> {
        self.previous.same_meaning &= current.block.known;
        self.stands_in_contour(current);
        match (task, &current.block.action) {
            (Task::ToolChange, _) => self.tool_change(phase, current).map(Some),
            (Task::Dwell, Action::Dwell(seconds)) => self.dwell(phase, *seconds, current).map(|()| None),
            (Task::Stop, action) => self.stop(phase, *action == Action::OptionalStop, current),
            (Task::End, _) => self.end(phase, current).map(Some),
            _ => Ok(None),
        }
    }

    /// Whether there is a rapid among the motions ahead that need no block from where the tool is.
    fn rapid_is_needless(&self, here: Option<&ToolPose>) -> bool {
        let mut needless = (0..MOST_NEEDLESS).take_while(|index| self.is_needless(*index, here));
        needless.any(|index| self.progress.get(index).and_then(ExpectedItem::motion).is_some_and(|motion| motion.rapid))
    }

    /// Whether a rapid may carry out a part of the next motion that needs a block.
    fn may_reach_next(&self, here: Option<&ToolPose>, end: &ToolPose) -> bool {
        let next = (0..MOST_NEEDLESS).find(|index| !self.is_needless(*index, here));
        let item = next.and_then(|index| self.progress.get(index));
        let motion = item.and_then(ExpectedItem::motion).filter(|motion| !motion.starts);
        motion.is_some_and(|motion| {
            let off_mm = || self.progress.segment(motion, here, end).distance(end, 0.0);
            motion.rapid || off_mm() <= BOTH * self.rules.rounding().tip_mm
        })
    }

    /// Whether the block at hand, which has two meanings, has the second in this reading.
    fn is_other_way(&mut self) -> bool {
        self.way.two = true;
        self.way.other
    }

    /// Stops the comparison before an error of the CL data, where fewer motions are known than the rules of a block may
    /// depend on: what follows would be findings about the consequences.
    fn stop_at_fault(&mut self, current: &Current<'_>) {
        if !self.progress.failed() {
            return;
        }
        let items = (0..).map_while(|index| self.progress.get(index));
        if items.filter(|item| matches!(item.action, ExpectedAction::Motion(_))).nth(1).is_none() {
            self.tally.stop(current.block.line);
        }
    }

    /// Adds a finding about the block at hand.
    fn found(&mut self, current: &Current<'_>, code: Code, text: &str) {
        self.tally.found(code, self.progress.location(), current.shown, text);
    }

    /// Adds a finding, if there is one.
    fn found_any(&mut self, current: &Current<'_>, code: Code, text: Option<String>) {
        if let Some(text) = text {
            self.found(current, code, &text);
        }
    }

    /// Adds findings.
    fn found_all(&mut self, current: &Current<'_>, code: Code, texts: impl IntoIterator<Item = String>) {
        texts.into_iter().for_each(|text| self.found(current, code, &text));
    }

    /// Adds a finding about its modal state.
    fn found_state(&mut self, current: &Current<'_>, fault: Option<StateFault>) {
        match fault {
            Some(StateFault { code, text, called: Some(at), .. }) => {
                self.tally.found_once(code, at, current.shown, &text)
            }
            Some(StateFault { code, text, set, .. }) => {
                let line = set.and_then(|item| self.setters.line_of(item));
                let shown = line.map_or(current.shown, |(line, text)| ShownBlock { line: *line, text });
                self.tally.found(code, self.progress.location(), shown, &text);
            }
            None => {}
        }
    }

    /// Circumstances of its modal state at the part.
    fn modal_context(&self) -> ModalContext {
        ModalContext { arc_plane: self.previous.arc_plane, ..ModalContext::default() }
    }

    /// The tool of the next motion gives the chain its length, and its set-up the part.
    fn take_tool(&mut self) {
        if let Some(item) = self.progress.next() {
            let required = &item.required;
            self.rules.set_part(required.set_up);
            self.rules.set_tool(required.gauge_length_mm.unwrap_or(0.0));
        }
    }

    /// Whether an item ahead needs no block; `here`: where the tool is.
    fn is_needless(&self, index: usize, here: Option<&ToolPose>) -> bool {
        self.progress.is_needless(index, &self.rules, here, self.previous.chords)
    }

    /// A plane, and a zero that follows the table, keep the state in which they are switched on; so does a length that
    /// is called, where its call may move an axis.
    fn captured_state(&mut self, current: &Current<'_>) {
        let (before, now) = (&self.setters.before, &current.block.state);
        let moves = self.rules.facts().length_moves && current.block.own.is_none();
        if let Some(Length::Register(register)) = now.length.filter(|_| moves && now.length != before.length) {
            let motion = (0..).map_while(|index| self.progress.get(index)).find(|item| item.motion().is_some());
            let expected = motion.map(|item| item.required.register).filter(|expected| *expected != register);
            let tool =
                motion.and_then(|item| item.required.tool).filter(|tool| now.tool.is_some_and(|now| now != *tool));
            if let Some(tool) = tool {
                let text = format!(
                    "length register {register} is called before the change to T{tool}: the call may move the tool"
                );
                self.found(current, check::TOOL, &text);
            } else if let Some(expected) = expected {
                self.found(
                    current,
                    check::TOOL,
                    &format!("length register {register} is called, expected {expected}: the call may move the tool"),
                );
            }
        }
        let (before, now) = (&self.setters.before, &current.block.state);
        let tilts = now.tilt.is_some() && now.tilt != before.tilt;
        if !tilts && (before.dynamic_offset || !now.dynamic_offset) {
            return;
        }
        let motion = (0..).map_while(|index| self.progress.get(index)).find(|item| item.motion().is_some());
        let fault = motion.and_then(|item| self.rules.fault_at_capture(current.block, &item.required));
        self.found_state(current, fault);
    }

    /// Passes motions that need no block.
    fn pass_needless(&mut self, phase: &Phase) -> io::Result<()> {
        self.pass_needless_from(phase.here())
    }

    /// Passes motions that need no block with the tool at `here`. For a rapid the rotary axes may rotate, with the
    /// machine retracted.
    fn pass_needless_from(&mut self, here: Option<&ToolPose>) -> io::Result<()> {
        while self.is_needless(0, here) {
            let is_rapid = self.progress.motion().is_some_and(|motion| motion.rapid);
            self.way.keeps_rapids = self.way.keeps_rapids || is_rapid && self.is_other_way();
            if is_rapid && self.way.keeps_rapids {
                break;
            }
            self.progress.pass();
            self.progress.fill(2)?;
        }
        Ok(())
    }

    /// Passes items for which the program has no block, and reports them.
    fn skip(&mut self, count: usize, here: Option<&ToolPose>, current: &Current<'_>) {
        let (rules, chords) = (&self.rules, self.previous.chords);
        let needless = |progress: &ClProgress<'_>, index: usize| progress.is_needless(index, rules, here, chords);
        if let Some((at, text)) = self.progress.skip(count, needless) {
            self.tally.found(check::MISSING, at, current.shown, &text);
        }
    }

    /// The phase where the position of the machine is unknown.
    fn forget(&mut self, phase: &Phase) -> Phase {
        self.duties.happens(DutyEvent::PositionLost);
        self.progress.forget_position();
        Phase::Unknown { stopped: phase.is_stopped() }
    }

    /// Adds up the chords of arcs by their angle since the words last gave the position in their plane.
    fn follow_arcs(&mut self, block: &Block) {
        if let Action::Arc(ArcMove { by_angle: true, sweep, .. }) = block.action {
            self.previous.chords += chord(sweep);
            return;
        }
        if self.previous.chords <= 0.0 {
            return;
        }
        let Some([first, second, _]) = block.state.plane.map(WorkPlane::axes) else { return };
        let xyz = self.rules.words().xyz();
        let written = |axis: usize| xyz[axis].is_none_or(|index| block.written & (1 << index) != 0);
        if written(first) && written(second) {
            self.previous.chords = 0.0;
        }
    }
}
