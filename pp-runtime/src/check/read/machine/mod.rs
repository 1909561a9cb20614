//! Executes the orders of blocks: one state machine for all families of controls.
//!
//! Words become mm and rad here. The position of an axis is known only while nothing has happened that may have moved
//! it or its zero. What the user declares of a line comes last.

mod arc;
mod hole;
mod modes;
mod motion;

use hole::Canned;

use super::block::{Action, Block, State, TipControl, stated};
use super::facts::{Facts, LineForm};
use super::orders::{Act, Code, Cycle, Letters, ModeOrder, MotionOrder, Orders, Pattern, effect, fault};
use super::state::MAX_AXES;
use crate::program::Units;

/// Words that a line of words alone may have, besides those of its axes and F.
#[derive(Debug, Clone, Copy)]
pub(super) struct WordsOfMoves {
    /// Letters of I J K.
    pub(super) centre: Letters,
    /// Axis along the normal of the plane, where the line may not have its word.
    pub(super) without: Option<usize>,
}

/// One axis of the machine as the program names it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AxisName {
    /// As in the program, upper case.
    pub(crate) name: Vec<u8>,
    pub(crate) rotary: bool,
    pub(crate) rollover: Option<RolloverRule>,
}

/// The axes of the machine, and what is known of the set-up.
#[derive(Debug, Clone)]
struct Axes {
    names: Vec<AxisName>,
    /// Rotary axes: bits by position.
    rotary: u16,
    /// The set-up has rules for rotary axes beyond a revolution.
    has_rollover: bool,
    /// Positions of X Y Z.
    linear: [Option<usize>; 3],
    /// Position of the axis with a name of one letter, A to Z.
    by_letter: [Option<u8>; 26],
    /// Half a unit of a linear word, mm: how far ends of arcs are rounded.
    rounding: f64,
}

/// Modes of motions and cycles.
#[derive(Debug, Clone, Copy, Default)]
struct MotionModes {
    /// The motion code in force, and the letters that it takes.
    code: Option<Code>,
    takes: Letters,
    /// I J K are the tool axis (G43.5).
    vectors: bool,
    /// The defined cycle.
    cycle: Option<Cycle>,
    /// The cycle after each motion (MCALL).
    each_point: Option<Cycle>,
    /// The words of the canned cycle in force.
    canned: Option<Canned>,
    /// The level before it.
    initial: Option<f64>,
    /// The next thread is cut in step with the spindle (M29), and its block must come next.
    rigid: bool,
    thread_due: bool,
}

impl MotionModes {
    /// What is the same in others.
    fn and(&self, other: &Self) -> Self {
        fn same<T: PartialEq>(one: Option<T>, other: Option<T>) -> Option<T> {
            if one == other { one } else { None }
        }
        Self {
            code: same(self.code, other.code),
            takes: self.takes & other.takes,
            vectors: self.vectors && other.vectors,
            cycle: same(self.cycle, other.cycle),
            each_point: same(self.each_point, other.each_point),
            canned: same(self.canned, other.canned),
            initial: same(self.initial, other.initial),
            rigid: false,
            thread_due: false,
        }
    }
}

/// State and position of a control.
#[derive(Debug, Clone)]
pub(super) struct Interpreter {
    axes: Axes,
    facts: Facts,
    state: State,
    values: [f64; MAX_AXES],
    known: u16,
    /// Rotary axes that a tool axis has rotated, to where only the control knows: bits.
    turned: u16,
    motion: MotionModes,
    /// Bits of [`stated`], since a complete state began.
    stated: u8,
    /// Bits of [`settled`], since the last motion: those before the block that begins a complete state belong to it.
    settled: u32,
    frames: FrameBits,
}

/// Tip control, tilted plane and dynamic work offset, as bits: a line of the user may leave any of them on.
#[derive(Debug, Clone, Copy, Default)]
struct FrameBits {
    /// Those of which it is unknown whether they are on.
    unknown: u8,
    /// Those that the program has switched on.
    used: u8,
    /// Those that the program has switched on or off, the last time.
    stated: u8,
}

impl FrameBits {
    const TIP_CONTROL: u8 = 1;
    const PLANE: u8 = 2;
    const DYNAMIC_OFFSET: u8 = 4;

    /// The program has switched one on or off.
    fn programmed(&mut self, frame: u8, on: bool) {
        self.unknown &= !frame;
        self.used |= if on { frame } else { 0 };
        self.stated |= frame;
    }

    /// A line of the user may have switched any.
    fn lose(&mut self) {
        self.unknown = Self::TIP_CONTROL | Self::PLANE | Self::DYNAMIC_OFFSET & self.used;
        self.stated = 0;
    }

    /// A complete state has been programmed: an option that the program does not use is off.
    fn complete(&mut self) {
        self.unknown &= self.used;
    }
}

impl Axes {
    fn new(names: Vec<AxisName>, rounding: f64) -> Self {
        let position = |name: &[u8]| names.iter().position(|axis| axis.name == name);
        let rotary = names.iter().enumerate().filter(|(_, axis)| axis.rotary);
        Self {
            rotary: rotary.fold(0, |bits, (index, _)| bits | 1 << index),
            has_rollover: names.iter().any(|axis| axis.rollover.is_some()),
            linear: [b"X", b"Y", b"Z"].map(|name| position(name)),
            by_letter: std::array::from_fn(|letter| u8::try_from(position(&[b'A' + letter as u8])?).ok()),
            rounding,
            names,
        }
    }
}

impl Interpreter {
    pub(super) fn new(axes: Vec<AxisName>, facts: Facts, rounding: f64) -> Self {
        Self {
            axes: Axes::new(axes, rounding),
            facts,
            state: State::default(),
            values: [0.0; MAX_AXES],
            known: 0,
            turned: 0,
            motion: MotionModes::default(),
            stated: 0,
            settled: 0,
            frames: FrameBits::default(),
        }
    }

    pub(super) fn facts(&self) -> &Facts {
        &self.facts
    }

    /// What is in force.
    pub(super) fn state(&self) -> &State {
        &self.state
    }

    /// After blocks that were executed or not, `before` being the state before them: what is the same in both cases.
    pub(super) fn join(&mut self, before: &Self) {
        let same = (0..MAX_AXES).filter(|&index| self.values[index].to_bits() == before.values[index].to_bits());
        self.turned |= before.turned;
        self.known &= before.known & same.fold(0, |bits, index| bits | 1 << index);
        self.stated &= before.stated;
        self.settled &= before.settled;
        self.motion = self.motion.and(&before.motion);
        let (now, then) = (&mut self.state, &before.state);
        self.frames.unknown |= before.frames.unknown;
        self.frames.used |= before.frames.used;
        self.frames.stated &= before.frames.stated;
        if now.tip_control != then.tip_control {
            self.frames.unknown |= FrameBits::TIP_CONTROL;
            now.tip_control = TipControl::Off;
        }
        if now.tilt != then.tilt {
            self.frames.unknown |= FrameBits::PLANE;
            now.tilt = None;
        }
        if now.dynamic_offset != then.dynamic_offset {
            self.frames.unknown |= FrameBits::DYNAMIC_OFFSET;
            now.dynamic_offset = false;
        }
        now.join(then);
    }

    /// Axis by its position in the chain.
    pub(super) fn axis(&self, index: usize) -> &AxisName {
        &self.axes.names[index]
    }

    /// Position in the chain of an axis, by its name in the program.
    #[inline]
    pub(super) fn axis_named(&self, name: &[u8]) -> Option<usize> {
        if let [letter @ b'A'..=b'Z'] = name {
            return self.axes.by_letter[usize::from(letter - b'A')].map(usize::from);
        }
        self.axes.names.iter().position(|axis| axis.name == name)
    }

    /// Rotary axes: bits by position.
    pub(super) fn rotary(&self) -> u16 {
        self.axes.rotary
    }

    /// Positions in the chain of X Y Z.
    pub(super) fn linear(&self) -> [Option<usize>; 3] {
        self.axes.linear
    }

    /// Position of an axis, if it is known.
    pub(super) fn at(&self, index: usize) -> Option<f64> {
        (self.known & (1 << index) != 0).then_some(self.values[index])
    }

    /// Unit of lengths in force.
    pub(super) fn units(&self) -> Units {
        self.state.units.unwrap_or_default()
    }

    /// Unit of lengths in force, mm.
    pub(super) fn unit(&self) -> f64 {
        self.state.units.map_or(1.0, Units::in_mm)
    }

    /// The motion code in force, and the letters that it takes.
    pub(super) fn motion_code(&self) -> (Option<Code>, Letters) {
        (self.motion.code, self.motion.takes)
    }

    /// Whether I J K are the tool axis.
    pub(super) fn has_vectors(&self) -> bool {
        self.motion.vectors
    }

    /// Words that a line of words alone may have. `None` where such a line may do more than move axes.
    pub(super) fn words_of_moves(&self) -> Option<WordsOfMoves> {
        let MotionModes { code, takes, vectors, canned, rigid, thread_due, .. } = &self.motion;
        match code {
            _ if *rigid || *thread_due || self.frames.unknown != 0 => None,
            Some(Code::Cycle) if canned.is_some() => Some(WordsOfMoves { centre: 0, without: self.normal() }),
            Some(Code::Rapid | Code::Feed) => Some(WordsOfMoves { centre: 0, without: None }),
            Some(Code::Clockwise | Code::CounterClockwise) => {
                Some(WordsOfMoves { centre: if *vectors { 0 } else { *takes }, without: None })
            }
            _ => None,
        }
    }

    /// Moves the axes by a line of words of axes and F alone.
    pub(super) fn move_along(&mut self, motion: &MotionOrder, feed: Option<f64>, block: &mut Block) {
        (block.written, block.only_moves, block.looked_over) = (motion.axes.written, true, 1);
        (block.frame_faults, block.restart, block.early, block.goes_on) = (0, false, None, false);
        block.forget_guards();
        (block.known_before, block.stated) = (self.known, self.stated);
        self.set_feed(feed);
        block.action = self.moving(motion, block);
        self.note_motion(&block.action);
        if self.facts.stops_spindle(&block.action) {
            self.stated &= !stated::SPINDLE;
            block.stated = self.stated;
        }
        (block.values, block.known) = (self.values, self.known);
        block.state.take_moves(&self.state);
        debug_assert!(block.state == self.state, "{:?} {:?}", block.state, self.state);
    }

    /// Executes the modes of a block and its first act.
    pub(super) fn begin(&mut self, orders: &Orders, block: &mut Block) {
        block.number = orders.number;
        block.frame_faults = orders.frame_faults;
        block.only_moves = orders.only_moves();
        block.looked_over = if orders.stops_look_ahead { u8::MAX } else { u8::from(orders.speaks) };
        block.restart = orders.has(|mode| matches!(mode, ModeOrder::Restart | ModeOrder::Units(_)));
        block.forget_guards();
        (block.early, block.goes_on) = (None, false);
        self.thread(orders, block);
        if self.state.feed_mode == Some(super::block::FeedMode::InverseTime) && orders.speaks {
            self.state.feed = None;
        }
        self.set_modes(&orders.modes, block);
        if !orders.either.is_empty() {
            let before = self.state;
            self.set_modes(&orders.either, block);
            block.early = (before != self.state && !orders.acts.is_empty()).then(|| Box::new(before));
        }
        self.state_bits(orders, block);
        self.code_alone(orders, &mut block.faults);
        self.act(orders, 0, block);
    }

    /// Executes a further act of a block, or the functions after its acts; `false` if there is none.
    pub(super) fn go_on(&mut self, orders: &Orders, step: usize, block: &mut Block) -> bool {
        if step == orders.acts.len() && orders.late.is_empty() {
            return false;
        }
        block.faults.clear();
        (block.own, block.goes_on, block.frame_faults) = (None, true, 0);
        (block.restart, block.only_moves, block.early) = (false, false, None);
        block.forget_guards();
        self.act(orders, step, block);
        true
    }

    /// Executes one act of a block; after the last one its functions, where it has no act, and its declared effects.
    fn act(&mut self, orders: &Orders, step: usize, block: &mut Block) {
        block.known_before = self.known;
        (block.action, block.written) = (Action::Nothing, 0);
        if step == orders.acts.len() {
            self.set_modes(&orders.late, block);
        }
        block.stated = self.stated;
        let mut machine_values = None;
        if let Some(act) = orders.acts.get(step) {
            block.values = self.values;
            block.action = self.carry_out(act, block);
            self.note_motion(&block.action);
            machine_values = block.action.leaves_words().then_some(block.values);
        }
        if self.frames.unknown != 0 {
            self.in_unknown_frame(block);
        }
        if self.facts.stops_spindle(&block.action) {
            self.stated &= !stated::SPINDLE;
            block.stated = self.stated;
        }
        if step + 1 >= orders.acts.len() {
            self.suffer(orders.effects, block);
            if !self.facts.motion_modal {
                self.motion.code = None;
            }
        }
        // Machine coordinates stay in the block alone.
        block.values = machine_values.unwrap_or(self.values);
        block.known = self.known;
        block.state = self.state;
    }

    /// After a motion, what was settled before it is no part of a complete state to come.
    #[inline]
    fn note_motion(&mut self, action: &Action) {
        if action.moves() {
            self.settled = 0;
        }
    }

    fn carry_out(&mut self, act: &Act, block: &mut Block) -> Action {
        match act {
            Act::ToolChange => Action::ToolChange,
            Act::Dwell(seconds) => Action::Dwell(*seconds),
            Act::Orient => Action::Orient,
            Act::Reference(words) => self.reference(words, block),
            Act::Machine(words) => self.machine_block(words, block),
            Act::EndOfTravel => self.end_of_travel(block),
            Act::Move(motion) => {
                block.written = motion.axes.written;
                self.moving(motion, block)
            }
            Act::Hole => self.hole(&mut block.faults),
            Act::Stop { optional } => {
                self.known = 0;
                if *optional { Action::OptionalStop } else { Action::Stop }
            }
            Act::End => Action::End,
        }
    }

    /// After M29 its thread comes.
    fn thread(&mut self, orders: &Orders, block: &mut Block) {
        let is_thread = |mode: &ModeOrder| matches!(mode, ModeOrder::Canned(words) if matches!(words.begins, Some(Pattern::TapAfterRigid { .. })));
        if !orders.speaks && block.faults.is_empty() {
            return;
        }
        if std::mem::take(&mut self.motion.thread_due) && !orders.has(is_thread) {
            block.faults.insert(
                block.frame_faults,
                super::block::BlockFault {
                    column: 1,
                    text: "M29 in the block before: expected its thread here, G84 or G74".to_owned(),
                },
            );
            block.frame_faults += 1;
        }
        self.motion.thread_due = orders.has(|mode| *mode == ModeOrder::Rigid) && !orders.has(is_thread);
    }

    /// Records the states that the block programs explicitly.
    fn state_bits(&mut self, orders: &Orders, block: &mut Block) {
        let settled = orders.all_modes().fold(0, |bits, mode| bits | mode.settles());
        self.settled |= settled;
        self.state.settled = if block.restart { self.settled } else { self.state.settled | settled };
        if block.restart {
            self.stated = 0;
        }
        let (mut modes, mut bits) = (0_u8, 0);
        for mode in orders.all_modes() {
            match mode {
                ModeOrder::Units(_) => modes |= 1,
                ModeOrder::Plane(_) => modes |= 2,
                ModeOrder::Incremental(_) => modes |= 4,
                ModeOrder::Side(_) => modes |= 8,
                ModeOrder::FeedMode(_) => modes |= 16,
                ModeOrder::Speed(_) => bits |= stated::SPEED,
                ModeOrder::Tool(_) => bits |= stated::TOOL,
                ModeOrder::Spindle(_) => bits |= stated::SPINDLE,
                ModeOrder::CoolantOn(_) | ModeOrder::CoolantOff(_) => bits |= stated::COOLANT,
                ModeOrder::Length(code, _) if *code != super::orders::LengthCode::Off => bits |= stated::LENGTH,
                ModeOrder::WorkOffset(_) => bits |= stated::OFFSET,
                _ => {}
            }
        }
        if modes == 31 {
            bits |= stated::MODES;
            if self.facts.frames_are_options {
                self.frames.complete();
            }
        }
        self.stated |= bits;
        if self.stated & stated::SPEED == 0 && orders.has(|mode| matches!(mode, ModeOrder::Spindle(Some(_)))) {
            fault(&mut block.faults, 0, "the spindle starts, and no S has been programmed since the complete state");
        }
    }

    /// Where words count is unknown, and so is every position.
    #[cold]
    fn in_unknown_frame(&mut self, block: &mut Block) {
        self.known = 0;
        if block.action.moves() && !block.action.leaves_words() {
            let text = "motion while tip control or a tilted plane may be active, after a line with the effect \"state lost\": \
                        switch both off before";
            fault(&mut block.faults, 0, text);
        }
    }

    /// The effect that the user has declared.
    fn suffer(&mut self, effects: u8, block: &mut Block) {
        if effects == 0 {
            return;
        }
        if effects & (effect::POSITION | effect::STOP | effect::STATE) != 0 {
            self.known = 0;
        }
        if effects & effect::COOLANT != 0 {
            self.state.coolant = None;
            self.stated &= !stated::COOLANT;
        }
        if effects & effect::SPINDLE != 0 {
            (self.state.spindle, self.state.speed) = (None, None);
            self.stated &= !stated::SPINDLE;
        }
        if effects & effect::MODES != 0 {
            self.lose_modes();
        }
        if effects & effect::STATE != 0 {
            let State { units, incremental, .. } = self.state;
            self.state = State { lost_at: Some(block.line), ..State::default() };
            // The unit of a program in statements is that of its first line, and each word of it has its own I.
            if self.facts.form == LineForm::Statements {
                (self.state.units, self.state.incremental) = (units, incremental);
            }
            (self.motion, self.stated, self.settled) = (MotionModes::default(), 0, 0);
            self.frames.lose();
        }
        block.stated = self.stated;
        if effects & effect::STOP != 0 && block.action == Action::Nothing {
            block.action = Action::Stop;
        }
    }

    /// Blocks that measure a tool, or look for its breakage, may have left any modes and another work offset.
    fn lose_modes(&mut self) {
        let state = &mut self.state;
        (state.work_offset, state.cancelled_offset, state.side, state.feed) = (None, None, None, None);
        (state.in_plane, state.in_workpiece, state.path_mode) = (None, None, None);
        // Words of a program in statements have the unit of its first line, and each its own I.
        if self.facts.form != LineForm::Statements {
            (state.units, state.incremental, state.plane, state.feed_mode) = (None, None, None, None);
            state.absolute_centres = None;
            state.side_unknown = true;
        }
        if self.facts.form == LineForm::Letters {
            state.length = None;
        }
        (self.motion.code, self.motion.cycle, self.motion.canned) = (None, None, None);
        (self.settled, self.state.settled) = (0, 0);
        self.stated &= !(stated::OFFSET | stated::MODES);
    }
}

/// Words of a rotary axis that the control reduces to one revolution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RolloverRule {
    /// The axis takes the shorter way.
    Shortest,
    /// The sign of the word is the direction.
    Sign,
}
