//! Words and codes of a line into orders: each code takes the words of its row, the motion takes the rest, and what is
//! left is a fault at its column.
//!
//! | word | with | means |
//! |---|---|---|
//! | P, X | G4 | a dwell: seconds on LinuxCNC, milliseconds on Fanuc and Haas where it has no point |
//! | F, S | G4 on Siemens | a dwell in seconds, in revolutions of the spindle |
//! | P | G54.1, G154 | number of the work offset |
//! | P, Q | G64 on LinuxCNC | largest deviation from the path, and that up to which blocks are joined |
//! | Q, R | G5.1 | smoothing on or off, and its level |
//! | P, E | G187 | level and tolerance of the smoothing |
//! | P | G43.4 on Fanuc | how the rotary axes move between two points |
//! | H, D | G43, G41 | registers of length and radius |
//! | X Y Z I J K Q | G68.2, G268 | a tilted plane |
//! | K | G33.1 | pitch |
//! | I J K | G43.5 in force | the tool axis |
//! | R, Q, P, I, J | a canned cycle | reference level, step, dwell, shift off the wall of a bore |
//! | R, P | G2, G3 | radius of an arc, revolutions of a helix on LinuxCNC |

use std::ops::Range;

use super::block::{OwnPlace, PathMode, PathSmoothing, WorkOffset, coolant, settled};
use super::facts::LineForm;
use super::language::{Address, CodeRow, Means, PathCode, Plane, Smoother, group, has_letter};
use super::line::Line;
use super::orders::{
    Act, ArcWords, CannedWords, Code, LengthCode, Letters, ModeOrder, MotionOrder, Pattern, TiltCode, WrittenAxisWords,
};
use super::own::OwnText;
use super::text::{Number, shown, whole};
use super::words::{Coded, Counts, Word};
use super::{RolloverRule, frames};
use crate::program::{Rotation, Units};

/// Least increment of mm and degrees, and of inches.
const LEAST: f64 = 1e-3;
const LEAST_INCH: f64 = 1e-4;

/// What the codes of a block ask for, and what decides what its motion is.
#[derive(Default)]
struct Asked {
    /// Motion code, and the letters that it takes.
    code: Option<(Code, Letters)>,
    hole: Option<Pattern>,
    dwell: bool,
    reference: bool,
    machine: bool,
    end_of_travel: bool,
    /// The defined cycle is run where the block ends.
    call: bool,
    /// A plane takes the words of its angles.
    plane: bool,
}

impl Line<'_> {
    /// Makes orders of the words and codes of the line. `call`: the cycle defined is run where the block ends.
    pub(super) fn compose(&mut self, call: bool) {
        self.groups();
        self.alone();
        let mut asked = Asked { call, ..Asked::default() };
        for index in 0..self.words.codes().len() {
            let coded = self.words.codes()[index];
            self.needed(&coded);
            self.ask(&coded, &mut asked);
        }
        let coolant = |on: bool| {
            self.orders.has(|mode| {
                if on { matches!(mode, ModeOrder::CoolantOn(_)) } else { matches!(mode, ModeOrder::CoolantOff(_)) }
            })
        };
        if coolant(true) && coolant(false) {
            self.fault(0, "coolant is switched on and off in one block");
        }
        self.process_words();
        self.tool_words();
        self.motion(&asked);
        if asked.call {
            self.orders.late_in_either_order();
        }
        self.left();
        self.one_act();
    }

    /// A block has one code of a group.
    fn groups(&mut self) {
        for index in 0..self.words.codes().len() {
            let Coded { row, column, end, .. } = self.words.codes()[index];
            let before = &self.words.codes()[..index];
            let several = row.group == group::FREE || row.group == group::COOLANT && self.facts().several_coolant_codes;
            let is_m = CodeRow::is_miscellaneous;
            let second_m = self.facts().one_m_code && is_m(row) && before.iter().any(|other| is_m(other.row));
            if !several && before.iter().any(|other| other.row.group == row.group) {
                let text = format!("`{}` together with another code of its group", shown(self.at.between(column, end)));
                self.fault(column, text);
            }
            if second_m {
                self.fault(column, "two M codes in one block: the control executes one");
            }
        }
    }

    /// Codes and calls that need a block of their own. M29 may be in the block of its thread.
    fn alone(&mut self) {
        let codes = self.words.codes();
        let acting = codes.iter().filter(|coded| coded.row.group != group::FREE).count() + self.words.calls.len();
        let begins_hole = codes.iter().any(|coded| matches!(coded.row.means, Means::Hole(_)));
        let of_codes =
            codes.iter().filter(|coded| coded.row.alone && !(coded.row.means == Means::Rigid && begins_hole));
        let of_codes = of_codes.map(|coded| (coded.column, coded.row.takes));
        let found = of_codes.chain(self.words.calls.iter().map(|column| (*column, 0))).find(|(_, takes)| {
            let taken = |word: &Word| word.letter.is_some_and(|letter| has_letter(*takes, letter));
            acting > 1 || self.words.left().iter().any(|word| !taken(word))
        });
        if let Some((column, _)) = found {
            self.fault(column, "this needs a block of its own, and other codes or words are in its block");
        }
    }

    /// Words that a code needs.
    fn needed(&mut self, coded: &Coded) {
        for letter in ('A'..='Z').filter(|letter| has_letter(coded.row.needs, *letter as u8)) {
            if !self.words.left().iter().any(|word| word.letter == Some(letter as u8)) {
                self.fault(coded.column, format!("{letter} is missing: a code of this block needs it"));
            }
        }
    }

    /// One code.
    fn ask(&mut self, coded: &Coded, asked: &mut Asked) {
        let Coded { row, number, column, end } = *coded;
        let takes = row.takes;
        let order = row.order.unwrap_or(self.facts().functions);
        match row.means {
            Means::Motion(code) => asked.code = Some((code, takes)),
            Means::Hole(pattern) => {
                asked.hole = Some(pattern);
                asked.code = Some((Code::Cycle, takes));
            }
            Means::Dwell => {
                asked.dwell = true;
                self.dwell(takes, column);
            }
            Means::Reference => asked.reference = true,
            Means::EndOfTravel => asked.end_of_travel = true,
            Means::Machine => asked.machine = true,
            Means::Plane(plane) => self.orders.mode(ModeOrder::Plane(plane)),
            Means::Units(units) => self.orders.mode(ModeOrder::Units(units)),
            Means::UnitsOfFeed(units) => {
                self.orders.mode(ModeOrder::Units(units));
                self.orders.mode(ModeOrder::Settles(settled::FEED_UNIT));
            }
            Means::Distances { incremental } => self.orders.mode(ModeOrder::Incremental(incremental)),
            Means::ArcCentres { absolute } => self.orders.mode(ModeOrder::AbsoluteCentres(absolute)),
            Means::FeedMode(mode) => self.orders.mode(ModeOrder::FeedMode(mode)),
            Means::Side(side) => {
                if let Some(word) = self.words.take_letter(b'D', takes) {
                    let register = self.register(&word);
                    self.orders.mode(ModeOrder::RadiusRegister(register));
                }
                self.orders.mode(ModeOrder::Side(side));
            }
            Means::Length(code) => self.length_code(code, takes),
            Means::TiltedPlane(form) => {
                asked.plane = true;
                self.tilted(form, takes, column);
            }
            Means::Orient => self.tilt(TiltCode::Orient),
            Means::TiltOff => self.tilt(TiltCode::Off),
            Means::DynamicOffset(on) => self.orders.mode(ModeOrder::DynamicOffset(on)),
            Means::Offset => self.orders.mode(ModeOrder::WorkOffset(WorkOffset::Code(number))),
            Means::FurtherOffset => match self.words.take_letter(b'P', takes).and_then(|word| whole(word.number)) {
                Some(number) => self.orders.mode(ModeOrder::WorkOffset(WorkOffset::Further(number))),
                None => self.fault(column, "work offset without its number"),
            },
            Means::Return { initial } => self.orders.mode(ModeOrder::ReturnToInitial(initial)),
            Means::Path(path) => self.path(path, takes),
            Means::Smoothing(smoother) => self.smooth(smoother, takes, column),
            Means::Stop { optional } => self.orders.act(Act::Stop { optional }),
            Means::End => self.orders.act(Act::End),
            Means::Spindle(rotation) => {
                self.is_spindle_of_tool(rotation, column..end);
                self.orders.function(ModeOrder::Spindle(rotation), order);
            }
            Means::SpindleAndFlood(rotation) => {
                let kinds = self.kinds_of(coolant::FLOOD, true, number, column..end);
                self.orders.function(ModeOrder::Spindle(Some(rotation)), order);
                self.orders.function(ModeOrder::CoolantOn(kinds), order);
            }
            Means::ToolChange => {
                self.orders.mode(ModeOrder::Change);
                self.orders.act(Act::ToolChange);
            }
            Means::CoolantOn(kinds) => {
                let kinds = self.kinds_of(kinds, true, number, column..end);
                self.orders.function(ModeOrder::CoolantOn(kinds), order);
            }
            Means::CoolantOff(kinds) => {
                let kinds = self.kinds_of(kinds, false, number, column..end);
                self.orders.function(ModeOrder::CoolantOff(kinds), order);
            }
            Means::Rigid => self.orders.mode(ModeOrder::Rigid),
            Means::TipControl(on) => {
                if self.facts().tip_control_may_cancel_offset {
                    self.orders.mode(ModeOrder::CancelsOffset { off: !on });
                }
                self.orders.mode(ModeOrder::TipControl(on));
            }
            Means::Interpolation { in_plane } => self.orders.mode(ModeOrder::InPlane(in_plane)),
            Means::Frame { in_workpiece } => self.orders.mode(ModeOrder::InWorkpiece(in_workpiece)),
            Means::ShortestWay(shortest) => self.orders.mode(ModeOrder::Shortest(shortest)),
            Means::CallCycle => asked.call = true,
            Means::Settles(bit) => {
                if let Some(word) = self.words.take_letter(b'P', takes).filter(|word| word.number.value != 0.0) {
                    self.fault(word.column, "this code is known with P0 only, which ends its compensation");
                }
                self.orders.mode(ModeOrder::Settles(bit));
            }
            Means::Harmless(_) => self.orders.harmless = true,
            Means::Address(_) | Means::Statement(_) => {}
        }
    }

    /// Adds a plane, and the motion of the rotary axes to it.
    pub(super) fn tilt(&mut self, tilt: TiltCode) {
        self.orders.mode(ModeOrder::Tilt(tilt));
        if matches!(tilt, TiltCode::Orient | TiltCode::Zero | TiltCode::On { oriented: true, .. }) {
            self.orders.act(Act::Orient);
        }
    }

    /// A code of the control's own spindle is a fault where another one has the tool. `columns`: those of the code.
    fn is_spindle_of_tool(&mut self, rotation: Option<Rotation>, columns: Range<usize>) {
        let is_same = |own: &&OwnText| own.place == OwnPlace::Spindle { rotation };
        if let Some(own) = self.vocabulary().switches().find(is_same) {
            let (code, own) = (shown(self.at.between(columns.start, columns.end)), shown(&own.text));
            self.fault(
                columns.start,
                format!("`{code}` switches another spindle than that of the tool, whose code is `{own}` (`control.mill_turn`)"),
            );
        }
    }

    /// The kinds of coolant that a code of the control switches on this machine: not those that have another code in
    /// the configuration, or on a control of one's own. A code that has none is a fault. `columns`: those of the code.
    fn kinds_of(&mut self, kinds: u8, on: bool, code: u32, columns: Range<usize>) -> u8 {
        let own = self.vocabulary().switches().filter(|own| own.place == OwnPlace::Coolant);
        let (mut left, mut instead) = (kinds, None);
        for bit in (0..u8::BITS).map(|index| 1_u8 << index).filter(|bit| kinds & bit != 0) {
            let switches = |own: &&OwnText| own.coolant.is_some_and(|(bits, is_on)| bits & bit != 0 && is_on == on);
            let mut codes = own.clone().filter(switches).peekable();
            let first = codes.peek().copied();
            if first.is_some() && !codes.any(|own| is_m_code(&own.text, code)) {
                left &= !bit;
                instead = instead.or(first);
            }
        }
        if let Some(own) = instead.filter(|_| left == 0) {
            let text = shown(self.at.between(columns.start, columns.end));
            self.fault(
                columns.start,
                format!("`{text}` is no coolant code of this machine: its code is `{}`", shown(&own.text)),
            );
        }
        left
    }

    /// The number of a tool or a register.
    fn register(&mut self, word: &Word) -> u32 {
        whole(word.number).unwrap_or_else(|| {
            self.fault(word.column, "number of a tool or a register that is no whole number");
            u32::MAX
        })
    }

    /// Whether a number counts as it is written, not in least increments.
    fn counts_plainly(&self, number: Number) -> bool {
        number.point || self.vocabulary().plain || !self.facts().least_increments
    }

    /// A length or an angle as written. Without a point it counts least increments, or what a setting says.
    fn length(&mut self, word: Word, rotary: bool) -> f64 {
        let number = word.number;
        if self.counts_plainly(number) || number.value == 0.0 {
            return number.value;
        }
        self.fault(word.column, "number without a decimal point: what it counts depends on a setting of the control");
        number.value * if self.units() == Some(Units::Inches) && !rotary { LEAST_INCH } else { LEAST }
    }

    /// A time in seconds: milliseconds where a Fanuc or a Haas reads no point.
    fn seconds(&self, number: Number) -> f64 {
        let milliseconds = self.facts().least_increments && !number.point;
        if milliseconds { number.value / 1000.0 } else { number.value }
    }

    /// A P in seconds.
    fn wait(&mut self, word: &Word) -> f64 {
        if self.facts().whole_milliseconds && word.number.point {
            self.fault(word.column, "P of a dwell has no decimal point: it counts milliseconds");
        }
        self.seconds(word.number)
    }

    fn dwell(&mut self, takes: Letters, column: usize) {
        let seconds = if self.facts().form == LineForm::Keywords {
            let (time, turns) = (self.words.take(Address::Feed), self.words.take(Address::Speed));
            if let (Some(_), Some(turns)) = (time, turns) {
                self.fault(turns.column, "dwell with two times");
            }
            let speed = self.machine().state().speed;
            let of_turns = turns.zip(speed).map(|(turns, speed)| turns.number.value / speed * 60.0);
            time.map(|time| time.number.value).or(of_turns)
        } else if let Some(word) = self.words.take_letter(b'P', takes) {
            Some(self.wait(&word))
        } else {
            self.words.take_letter(b'X', takes).map(|word| self.seconds(word.number))
        };
        match seconds {
            None => self.fault(column, "dwell without its time"),
            Some(seconds) if seconds < 0.0 => self.fault(column, "dwell with a negative time"),
            Some(_) => {}
        }
        self.orders.act(Act::Dwell(seconds.unwrap_or_default()));
    }

    /// Length compensation, with its register; G43.4 and its kin, with their form.
    fn length_code(&mut self, code: LengthCode, takes: Letters) {
        let register = self.words.take_letter(b'H', takes).map(|word| self.register(&word));
        self.orders.mode(ModeOrder::Length(code, register));
        match code {
            LengthCode::Off | LengthCode::On => {
                if self.facts().length_ends_tip_control {
                    self.orders.mode(ModeOrder::TipControl(false));
                }
            }
            LengthCode::TipControl | LengthCode::TipVector => {
                self.orders.mode(ModeOrder::TipControl(true));
                // P1: the tool axis rotates in a plane. Without P a parameter decides: A-79294E, p. 11.
                if let Some(form) = self.words.take_letter(b'P', takes) {
                    match whole(form.number) {
                        Some(0) => self.orders.mode(ModeOrder::InPlane(false)),
                        Some(1) => self.orders.mode(ModeOrder::InPlane(true)),
                        _ => self.fault(form.column, "unknown form of tip control"),
                    }
                }
            }
        }
    }

    fn path(&mut self, path: PathCode, takes: Letters) {
        let unit = self.unit();
        let mut length = |letter: u8| self.words.take_letter(letter, takes).map(|word| word.number.value * unit);
        let mode = match path {
            PathCode::Window => return,
            PathCode::ExactPath => PathMode::ExactPath,
            PathCode::ExactStop => PathMode::ExactStop,
            PathCode::Continuous => PathMode::Continuous { tolerance_mm: length(b'P'), joining_mm: length(b'Q') },
            PathCode::Smoothed(code) => PathMode::Smoothed(code),
        };
        self.orders.mode(ModeOrder::Path(mode));
    }

    fn smooth(&mut self, smoother: Smoother, takes: Letters, column: usize) {
        let level = |word: Word, most: u32| whole(word.number).filter(|level| (1..=most).contains(level));
        let smoothing = match smoother {
            Smoother::Contour => match self.words.take_letter(b'Q', takes).and_then(|word| whole(word.number)) {
                Some(0) => Some(PathSmoothing::Off),
                Some(1) => {
                    let level = self.words.take_letter(b'R', takes).map(|word| level(word, 10));
                    let known = level.is_none_or(|level| level.is_some());
                    let level = level.flatten().map(|level| level as u8);
                    known.then_some(PathSmoothing::On { tolerance_mm: None, level })
                }
                _ => None,
            },
            Smoother::Level => {
                let level = self.words.take_letter(b'P', takes).map(|word| level(word, 3));
                let tolerance = self.words.take_letter(b'E', takes);
                let tolerance_mm = tolerance.map(|word| self.length(word, false) * self.unit());
                match (level, tolerance_mm) {
                    (None, None) => Some(PathSmoothing::Off),
                    (Some(None), _) => None,
                    (level, tolerance_mm) => {
                        Some(PathSmoothing::On { tolerance_mm, level: level.flatten().map(|level| level as u8) })
                    }
                }
            }
        };
        match smoothing {
            Some(smoothing) => self.orders.mode(ModeOrder::Smoothing(smoothing, None)),
            None => self.fault(column, "unknown form of smoothing"),
        }
    }

    /// G68.2 and G268: the words are those of the plane.
    fn tilted(&mut self, plane: Plane, takes: Letters, column: usize) {
        let linear = self.machine().linear();
        let origin = linear.map(|index| {
            let index = index?;
            let word = self.words.take_if(|word| word.address == Address::Axis && usize::from(word.index) == index)?;
            Some(self.length(word, false))
        });
        let angles = [b'I', b'J', b'K'].map(|letter| {
            let word = self.words.take_letter(letter, takes)?;
            Some(self.length(word, false))
        });
        let order = self.words.take_letter(b'Q', takes).and_then(|word| whole(word.number));
        let words = frames::EulerWords { angles: angles.map(Option::unwrap_or_default), order };
        let rotation = match plane {
            Plane::Euler => words.euler(),
            Plane::Haas => words.haas(),
        };
        match rotation.filter(|_| angles.iter().all(Option::is_some)) {
            Some(rotation) => {
                let origin = origin.map(Option::unwrap_or_default).into();
                self.tilt(TiltCode::On { rotation, origin, oriented: false, pose: None, rotates_table: false });
            }
            None => self.fault(column, "unknown form of tilted plane"),
        }
    }

    /// F, S, T and D of a cutting edge.
    fn process_words(&mut self) {
        if let Some(Word { number, column, .. }) = self.words.take(Address::Feed) {
            if self.facts().feed_needs_point && !self.counts_plainly(number) {
                self.fault(column, "F without a decimal point: its value depends on a setting of the control");
            }
            if number.value <= 0.0 {
                self.fault(column, "F is not above 0");
            }
            self.orders.mode(ModeOrder::Feed(number.value));
        }
        if let Some(Word { number, column, .. }) = self.words.take(Address::Speed) {
            if number.value <= 0.0 {
                self.fault(column, "S is not above 0");
            }
            self.orders.mode(ModeOrder::Speed(number.value));
        }
        if let Some(word) = self.words.take(Address::Tool) {
            let tool = self.register(&word);
            self.orders.mode(ModeOrder::Tool(tool));
        }
        if let Some(word) = self.words.take(Address::Edge) {
            let edge = self.register(&word);
            let code = if edge == 0 { LengthCode::Off } else { LengthCode::On };
            self.orders.mode(ModeOrder::Length(code, Some(edge)));
        }
    }

    /// What a tool word needs, and what may not be in its block.
    fn tool_words(&mut self) {
        let tool = self.orders.has(|mode| matches!(mode, ModeOrder::Tool(_)));
        let change = self.orders.has(|mode| *mode == ModeOrder::Change);
        if change && !tool && self.machine().state().selected.is_none() {
            self.fault(0, "tool change without a tool number: no T has been programmed");
        }
        if tool && !change && self.facts().tool_call_alone && self.words.has(Address::Axis) {
            self.fault(0, "tool call in a block with axis motion");
        }
    }

    /// What the words of axes, of an arc and of a canned cycle do.
    fn motion(&mut self, asked: &Asked) {
        if let Some((code, takes)) = asked.code {
            self.orders.mode(ModeOrder::Motion(code, takes));
            if asked.dwell {
                self.fault(0, "a motion code in a block with a dwell");
            }
            if asked.reference && !self.facts().reference_beside_motion {
                self.fault(0, "a motion code in a block with a reference motion: both take the axis words");
            }
        }
        // A statement states its motion itself.
        let stated = self
            .orders
            .find(|mode| if let ModeOrder::Motion(code, takes) = mode { Some((*code, *takes)) } else { None });
        let (code, takes) = match stated {
            Some((code, takes)) => (Some(code), takes),
            None => self.machine().motion_code(),
        };
        let is_arc = matches!(code, Some(Code::Clockwise | Code::CounterClockwise));
        let apart = asked.machine || asked.reference || asked.dwell;
        self.vector(asked);
        let canned = if code == Some(Code::Cycle) && !apart { self.canned(asked, takes) } else { None };
        let pitch = (code == Some(Code::RigidTap)).then(|| self.words.take_letter(b'K', takes)).flatten();
        let axes = if asked.dwell || self.orders.acts.len() > usize::from(self.orients()) && !asked.call {
            WrittenAxisWords::default()
        } else {
            self.axes()
        };
        let arc = if is_arc { self.arc(takes) } else { ArcWords::default() };
        if asked.reference {
            return self.orders.act(Act::Reference(axes));
        }
        if asked.end_of_travel {
            if axes.written != 0 {
                self.fault(0, "axis words together with the retract along the tool axis");
            }
            return self.orders.act(Act::EndOfTravel);
        }
        if asked.machine {
            if axes.written == 0 {
                self.fault(0, "machine coordinates without an axis word");
            } else {
                self.orders.act(Act::Machine(axes));
            }
            if asked.call {
                self.orders.act(Act::Hole);
            }
            return;
        }
        let vector = self.orders.has(|mode| matches!(mode, ModeOrder::Vector(..)));
        if vector && axes.written & self.machine().rotary() != 0 {
            self.fault(0, "rotary words together with a tool axis");
        }
        let round = arc != ArcWords::default();
        // R moves the tool to its level, and so it drills again.
        let drills = canned.is_some_and(|words| words.begins.is_some() || words.reference.is_some());
        if canned.is_some() && !drills && axes.written == 0 {
            self.fault(0, "P, Q, I or J of a cycle without R and without an axis word");
        }
        if code == Some(Code::RigidTap) && self.orders.has(|mode| matches!(mode, ModeOrder::Feed(_))) {
            self.fault(0, "F in the block of a thread whose pitch is K");
        }
        if axes.written != 0 || vector || round || drills {
            let pitch = pitch.map(|word| word.number.value);
            self.orders.act(Act::Move(MotionOrder { axes, arc, pitch, call: asked.call }));
        } else if asked.call {
            self.orders.act(Act::Hole);
        }
    }

    /// Whether its rotary axes go to a plane.
    fn orients(&self) -> bool {
        self.orders.acts.contains(&Act::Orient)
    }

    /// Components of the tool axis: A3 B3 C3, TX TY TZ, and I J K while G43.5 is in force.
    fn vector(&mut self, asked: &Asked) {
        let begins = self.orders.find(|mode| match mode {
            ModeOrder::Length(code, _) => Some(*code == LengthCode::TipVector),
            _ => None,
        });
        let is_arc = matches!(asked.code, Some((Code::Clockwise | Code::CounterClockwise, _)));
        let of_letters = begins.unwrap_or(self.machine().has_vectors()) && !is_arc && !asked.plane;
        let (mut vector, mut written) = ([0.0; 3], 0);
        while let Some(word) =
            self.words.take_if(|word| word.address == Address::Vector || of_letters && word.address == Address::Centre)
        {
            vector[usize::from(word.index)] =
                if word.address == Address::Centre { self.length(word, false) } else { word.number.value };
            written |= 1 << word.index;
        }
        if written != 0 {
            self.orders.mode(ModeOrder::Vector(vector, written));
        }
    }

    /// Words of a canned cycle, in the block that begins it or in a later one. Every block with one of its words, or
    /// with an axis word, drills.
    fn canned(&mut self, asked: &Asked, takes: Letters) -> Option<CannedWords> {
        let reference = self.words.take_letter(b'R', takes);
        let step = self.words.take_letter(b'Q', takes);
        let dwell = self.words.take_letter(b'P', takes);
        let shift = [b'I', b'J'].map(|letter| self.words.take_letter(letter, takes));
        let lengths = [reference, step].map(|word| word.map(|word| self.length(word, false)));
        let words = CannedWords {
            begins: asked.hole,
            reference: lengths[0],
            step: lengths[1],
            dwell: dwell.map(|word| {
                if word.number.value < 0.0 {
                    self.fault(word.column, "negative time");
                }
                self.wait(&word)
            }),
            shift: shift
                .iter()
                .any(Option::is_some)
                .then(|| shift.map(|word| word.map_or(0.0, |word| self.length(word, false)))),
        };
        let says = words != CannedWords::default();
        if says {
            self.orders.mode(ModeOrder::Canned(words));
        }
        says.then_some(words)
    }

    /// The words of axes.
    fn axes(&mut self) -> WrittenAxisWords {
        let mut axes = WrittenAxisWords::default();
        while let Some(word) = self.words.take(Address::Axis) {
            let (index, bit) = (usize::from(word.index), 1 << word.index);
            axes.values[index] = self.length(word, self.machine().axis(index).rotary);
            axes.written |= bit;
            match word.counts {
                Counts::AsInForce => {}
                Counts::Absolute | Counts::Shortest => axes.absolute |= bit,
                Counts::Incremental => axes.incremental |= bit,
            }
            if self.facts().form == LineForm::Keywords {
                self.direction(&word);
            }
        }
        axes
    }

    /// The direction of a rotary word of a modulo axis, which the word has to say: machine data decides it otherwise.
    fn direction(&mut self, word: &Word) {
        let axis = self.machine().axis(usize::from(word.index));
        let shortest = axis.rollover == Some(RolloverRule::Shortest);
        let value = word.number.value;
        let text = match word.counts {
            Counts::Shortest if !shortest => {
                "DC(..) for an axis that the configuration does not let roll over (`wrap`)"
            }
            Counts::Shortest if !(-180.0..360.0).contains(&value) => {
                "the value of DC(..) is outside the modulo range: from 0 up to 360, or from -180 up to 180"
            }
            Counts::AsInForce | Counts::Absolute if shortest => {
                "the axis rolls over, and machine data decides the direction to this word (MD30455): expected DC(..)"
            }
            _ => return,
        };
        self.fault(word.column, text);
    }

    /// The words of an arc.
    fn arc(&mut self, takes: Letters) -> ArcWords {
        let mut arc = ArcWords::default();
        let of_letters = self.facts().form == LineForm::Letters;
        let taken = |letter: Option<u8>| letter.is_some_and(|letter| has_letter(takes, letter));
        while let Some(word) =
            self.words.take_if(|word| word.address == Address::Centre && (!of_letters || taken(word.letter)))
        {
            arc.centre[usize::from(word.index)] = self.length(word, false);
            arc.written |= 1 << word.index;
            arc.absolute |= u8::from(word.counts == Counts::Absolute) << word.index;
        }
        let radius = self.words.take_letter(b'R', takes).or_else(|| self.words.take(Address::Radius));
        arc.radius = radius.map(|word| self.length(word, false));
        arc.sweep = self.words.take(Address::Angle).map(|word| word.number.value.to_radians());
        if let Some(word) = self.words.take_letter(b'P', takes) {
            match whole(word.number) {
                Some(turns @ 1..) => arc.turns = turns - 1,
                _ => self.fault(word.column, "revolutions of a helix that are no whole number above 0"),
            }
        }
        if let Some(word) = self.words.take(Address::Turns) {
            arc.turns = whole(word.number).unwrap_or_default();
        }
        arc
    }

    /// Words that nothing has taken.
    fn left(&mut self) {
        for index in 0..self.words.left().len() {
            let Word { address, letter, column, .. } = self.words.left()[index];
            let name = letter.map_or("this word".to_owned(), |letter| char::from(letter).to_string());
            let text = match address {
                Address::Axis => "axis words in a block with another function".to_owned(),
                Address::Centre => "I, J or K without an arc".to_owned(),
                Address::Radius | Address::Angle | Address::Turns => {
                    "radius, angle or revolutions of an arc without an arc".to_owned()
                }
                _ => format!("{name} has no meaning in this block: none of its codes takes it"),
            };
            self.fault(column, text);
        }
    }

    /// A block does one thing. A control has an order for several, which no manual states.
    fn one_act(&mut self) {
        let acts = &self.orders.acts;
        if acts.len() < 2 {
            return;
        }
        let text = if acts.contains(&Act::Orient) {
            "the rotary axes are positioned to a plane in a block with another function"
        } else if acts.contains(&Act::Hole) {
            "a cycle is called in a block with another function"
        } else if self.orders.moves_axes() {
            "axis words in a block with another function"
        } else {
            "two functions in one block, each of which needs a block of its own"
        };
        self.fault(0, text);
    }
}

/// Whether a text is an M code of this number, in tenths, with or without leading zeros.
fn is_m_code(text: &[u8], code: u32) -> bool {
    let number = std::str::from_utf8(text).ok().and_then(|text| text.strip_prefix('M')?.parse::<u32>().ok());
    number.is_some_and(|number| number.checked_mul(10) == Some(code))
}
