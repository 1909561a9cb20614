//! Execution of codes: the row of a code fills the draft of its block.

use super::block::{OwnPlace, WorkOffset, coolant};
use super::draft::{Code, LengthCode, TiltCode, group};
use super::facts::Form;
use super::language::{Letters, Means, PathCode, Row};
use super::line::Line;
use super::own::OwnText;
use super::text::{Number, shown, tenths};

impl Line<'_> {
    /// A code by its letter and number, which begin at a column; `false` if the table does not have it.
    pub(super) fn code(&mut self, letter: u8, number: Number, column: usize) -> bool {
        let Some(code) = tenths(number) else { return false };
        let Some(row) = self.language().code(letter, code) else { return false };
        if letter == b'M' {
            self.m_code();
        }
        self.carry_out(row, code, column);
        true
    }

    /// Counts the M codes of a block.
    #[inline]
    fn m_code(&mut self) {
        let bit = 1 << group::MISCELLANEOUS;
        if self.facts().one_m_code && self.draft.groups & bit != 0 {
            self.fault(0, "two M codes in one block: the control executes one");
        }
        self.draft.groups |= bit;
    }

    /// Puts a row into the draft.
    pub(super) fn carry_out(&mut self, row: &'static Row, code: u32, column: usize) {
        let facts = self.facts();
        let draft = &mut *self.draft;
        draft.takes |= row.takes;
        draft.needs |= row.needs;
        let several = row.group == group::FREE || row.group == group::COOLANT && facts.several_coolant_codes;
        let first = several || draft.groups & (1 << row.group) == 0;
        draft.groups |= 1 << row.group;
        self.fill(row.means, code, column);
        if !first {
            let text = shown(self.read_from(column));
            self.fault(column, format!("`{text}` together with another code of its group"));
        }
    }

    /// The kinds of coolant that a code of the control switches on this machine: not those that have another code in the
    /// configuration, or on a control of one's own. A code that has none is a fault.
    fn kinds_of(&mut self, coolant: u8, on: bool, code: u32, column: usize) -> u8 {
        let own = self.vocabulary().own.iter().filter(|own| own.place == OwnPlace::Coolant);
        let (mut kinds, mut instead) = (coolant, None);
        for bit in (0..u8::BITS).map(|index| 1_u8 << index).filter(|bit| coolant & bit != 0) {
            let switches = |own: &&OwnText| own.coolant.is_some_and(|(bits, is_on)| bits & bit != 0 && is_on == on);
            let mut codes = own.clone().filter(switches).peekable();
            let first = codes.peek().copied();
            if first.is_some() && !codes.any(|own| is_m_code(&own.text, code)) {
                kinds &= !bit;
                instead = instead.or(first);
            }
        }
        if let Some(own) = instead.filter(|_| kinds == 0) {
            let text = shown(self.read_from(column));
            let text = format!("`{text}` is no coolant code of this machine: its code is `{}`", shown(&own.text));
            self.fault(column, text);
        }
        kinds
    }

    fn fill(&mut self, means: Means, code: u32, column: usize) {
        let facts = self.facts();
        let coolant = match means {
            Means::CoolantOn(bits) => self.kinds_of(bits, true, code, column),
            Means::CoolantOff(bits) => self.kinds_of(bits, false, code, column),
            Means::SpindleAndFlood(_) => self.kinds_of(coolant::FLOOD, true, code, column),
            _ => 0,
        };
        let draft = &mut *self.draft;
        match means {
            Means::Motion(code) => draft.code = Some(code),
            Means::Hole(pattern) => {
                draft.hole = Some(pattern);
                draft.code = Some(Code::Cycle);
            }
            Means::Dwell => draft.dwells = true,
            Means::Reference => draft.reference = true,
            Means::EndOfTravel => draft.end_of_travel = true,
            Means::Machine => draft.machine = true,
            Means::Plane(plane) => draft.plane = Some(plane),
            Means::Units(units) => draft.units = Some(units),
            Means::Distances { incremental } => draft.distances = Some(incremental),
            Means::FeedMode(mode) => draft.feed_mode = Some(mode),
            Means::Side(side) => draft.side = Some(side),
            Means::Length(length) => {
                draft.length = Some(length);
                if matches!(length, LengthCode::Off | LengthCode::On) && facts.length_ends_tip_control {
                    draft.tip_control = Some(false);
                }
            }
            Means::TiltedPlane(form) => draft.plane_form = Some(form),
            Means::Orient => draft.tilt = Some(TiltCode::Orient),
            Means::TiltOff => draft.tilt = Some(TiltCode::Off),
            Means::DynamicOffset(on) => draft.dynamic_offset = Some(on),
            Means::Offset => draft.work_offset = Some(WorkOffset::Code(code)),
            Means::FurtherOffset => draft.offset_with_p = true,
            Means::Return { initial } => draft.to_initial = Some(initial),
            Means::Path(PathCode::Window) => {}
            Means::Path(path) => draft.path = Some(path),
            Means::Smoothing(smoother) => draft.smooths = Some(smoother),
            Means::Stop { optional } => draft.stop = Some(optional),
            Means::End => draft.end = true,
            Means::Spindle(turns) => draft.spindle = Some(turns),
            Means::SpindleAndFlood(turns) => {
                draft.spindle = Some(Some(turns));
                draft.coolant_on |= coolant;
            }
            Means::ToolChange => draft.change = true,
            Means::CoolantOn(_) => draft.coolant_on |= coolant,
            Means::CoolantOff(_) => draft.coolant_off |= coolant,
            Means::Rigid => draft.rigid = true,
            Means::TipControl(on) => {
                draft.tip_control = Some(on);
                draft.offset_lost |= facts.tip_control_may_cancel_offset;
            }
            Means::Interpolation { in_plane } => draft.in_plane = Some(in_plane),
            Means::Frame { in_workpiece } => draft.in_workpiece = Some(in_workpiece),
            Means::ShortestWay(shortest) => draft.shortest = Some(shortest),
            Means::CallCycle => draft.call = true,
            Means::Address(_) | Means::Statement(_) | Means::Harmless(_) => {}
        }
    }

    /// Says which words of the block no code takes, and which a code lacks. `modal`: what codes in force take.
    pub(super) fn account(&mut self, always: Letters, modal: Letters) {
        let draft = &*self.draft;
        let idle = draft.letters & !(always | modal | draft.takes);
        let missing = draft.needs & !draft.letters;
        if idle | missing == 0 {
            return;
        }
        for letter in named(idle) {
            self.fault(0, format!("{letter} has no meaning in this block: none of its codes takes it"));
        }
        for letter in named(missing) {
            self.fault(0, format!("{letter} is missing: a code of this block needs it"));
        }
    }

    /// Says which of F and S cannot be executed.
    #[inline]
    pub(super) fn feed_and_speed(&mut self) {
        if self.draft.feed.is_some_and(|feed| feed <= 0.0) {
            self.fault(0, "F is not above 0");
        }
        if self.draft.speed.is_some_and(|speed| speed < 0.0) {
            self.fault(0, "S is negative");
        }
    }

    /// Says what contradicts itself in the block.
    pub(super) fn contradictions(&mut self) {
        self.feed_and_speed();
        let draft = &*self.draft;
        let smooths = draft.groups & (1 << group::SMOOTHING) != 0;
        let switches = self.facts().form == Form::Keywords && draft.groups & (1 << group::TIP) != 0;
        let swivels = self.facts().form == Form::Keywords && draft.groups & (1 << group::TILT) != 0;
        let found = [
            (
                swivels && !draft.is_alone(group::TILT),
                "a plane is tilted or reset in a block with other codes or words: it needs a block of its own",
            ),
            (
                smooths && !draft.is_alone(group::SMOOTHING),
                "smoothing is switched in a block with other codes or words: it needs a block of its own",
            ),
            (
                switches && !draft.is_alone(group::TIP),
                "tip control is switched in a block with other codes or words: it needs a block of its own",
            ),
            (
                draft.rigid && draft.hole.is_none() && !draft.is_alone(group::RIGID),
                "M29 in a block with other codes or words than its S and its thread",
            ),
            (draft.coolant_on != 0 && draft.coolant_off != 0, "coolant is switched on and off in one block"),
            (draft.dwells && draft.code.is_some(), "a motion code in a block with a dwell"),
            (
                draft.reference && draft.code.is_some() && !self.facts().reference_beside_motion,
                "a motion code in a block with a reference motion: both take the axis words",
            ),
        ];
        for (_, text) in found.into_iter().filter(|(wrong, _)| *wrong) {
            self.fault(0, text);
        }
    }
}

/// Whether a text is an M code of this number, in tenths, with or without leading zeros.
fn is_m_code(text: &[u8], code: u32) -> bool {
    let number = std::str::from_utf8(text).ok().and_then(|text| text.strip_prefix('M')?.parse::<u32>().ok());
    number.is_some_and(|number| number.checked_mul(10) == Some(code))
}

/// The letters of some bits.
fn named(bits: Letters) -> impl Iterator<Item = char> {
    ('A'..='Z').enumerate().filter(move |(index, _)| bits & (1 << index) != 0).map(|(_, letter)| letter)
}
