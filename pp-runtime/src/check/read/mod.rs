//! Programs read back: text into what each block does, and the state in which it does so.
//!
//! Written from what controls do, independent of what writes programs: no table is shared with `control`. A program is
//! read as it streams by, and nothing is allocated for a block unless something is wrong with it. What is not known is
//! a fault of its block, never passed over.
//!
//! ```
//! use pp_runtime::check::{blocks, read::Action};
//! use pp_runtime::config::Config;
//! use pp_runtime::control::Fanuc;
//! # pp_runtime::machine! {
//! #     /// A table that rotates about Z on a table that tilts about X.
//! #     pub struct Trunnion;
//! #     chain: C A | X Y Z;
//! # }
//!
//! let policy = Config::default().check_policy::<Trunnion>(&Fanuc, None)?;
//! let blocks = blocks::<Trunnion>(&policy, &b"%\nO1\nG21 G90 G94 G17 G40 G80 G49\nG0 X10.\nG1 X20.
//! F500.\nM30\n%\n"[..])?; let last_motion = blocks.iter().rfind(|block| block.written != 0).expect("an axis word");
//! assert!((last_motion.values[2] - 20.0).abs() < 1e-12); assert_eq!(last_motion.action, Action::Feed);
//! assert!(blocks.iter().all(|block| block.faults.is_empty()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod block;
mod compose;
mod declared;
mod facts;
mod flow;
mod frames;
mod heidenhain;
mod iso;
mod language;
mod line;
mod lines;
mod machine;
mod orders;
mod own;
mod siemens;
mod state;
mod text;
mod words;

#[cfg(test)]
mod tests;

use std::fmt;
use std::io::{self, Read};
use std::sync::Arc;

pub use block::{
    Action, ArcMove, Block, CycleKind, CycleMove, FeedMode, Length, SideOfPath, State, TipControl, WorkOffset,
    WorkPlane, coolant,
};
pub(crate) use block::{
    BlankPart, BlockFault, Effect, FineBore, Guard, LengthSource, OwnLine, OwnPlace, PathMode, PathSmoothing,
    RotaryGuard, set_bits, stated,
};
#[cfg(test)]
pub(crate) use block::{OwnValues, Tilt};
pub(crate) use declared::{moves, refusal};
pub(crate) use facts::{Facts, GuardSource, LeftOver, LengthRegisters, LineForm, PoseSelector, SmoothingWords};
pub(crate) use language::table;
pub(crate) use machine::{AxisName, RolloverRule};
pub(crate) use own::{Lookup, OwnText, PlacedLines, is_filled, is_read};
pub(crate) use state::MAX_AXES;
pub(in crate::check) use state::settled;

use flow::{Flow, Taken};
use heidenhain::HeidenhainLines;
use iso::Iso;
use line::Line;
use lines::{LONGEST, LineKind, Lines};
use machine::Interpreter;
use orders::{Act, MotionOrder, Orders, effect, fault};
use own::Bare;
use siemens::SiemensLines;
use words::OpenWords;

/// Number of bytes of a program that are read at once.
const PIECE: usize = 1 << 16;

/// Byte order marks, and what a text that begins with one is written in.
const MARKS: [(&[u8], &str); 3] = [(b"\xEF\xBB\xBF", "UTF-8"), (b"\xFF\xFE", "UTF-16"), (b"\xFE\xFF", "UTF-16")];

/// Whether a line begins with IF or ENDIF, after its number.
fn begins_condition(text: &[u8]) -> bool {
    let mut words = text.split(|byte| !byte.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let numbered =
        |word: &&[u8]| word.len() > 1 && matches!(word[0], b'N' | b'n') && word[1..].iter().all(u8::is_ascii_digit);
    let first = words.find(|word| !numbered(word)).unwrap_or_default();
    [&b"IF"[..], b"ELSE", b"ENDIF"].iter().any(|word| first.eq_ignore_ascii_case(word))
}

/// Kinds of programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// LinuxCNC.
    LinuxCnc,
    /// Fanuc 30i and its kin.
    Fanuc,
    /// Haas NGC.
    Haas,
    /// Siemens 840D.
    Siemens,
    /// Heidenhain conversational.
    Heidenhain,
}

impl Family {
    /// That of a control, by its name on the command line.
    #[must_use]
    pub fn of_control(name: &str) -> Option<Self> {
        Some(match name {
            "linuxcnc" => Self::LinuxCnc,
            "fanuc" => Self::Fanuc,
            "haas" => Self::Haas,
            "siemens" => Self::Siemens,
            "heidenhain" => Self::Heidenhain,
            _ => return None,
        })
    }
}

/// What a reader has to know of the set-up.
#[derive(Debug, Clone)]
pub(crate) struct Vocabulary {
    pub(crate) family: Family,
    /// Axes in chain order.
    pub(crate) axes: Vec<AxisName>,
    /// Lines that the configuration brings into a program.
    pub(crate) own: Vec<OwnText>,
    /// Lines and words whose effect the user has declared.
    pub(crate) effects: Vec<(Vec<u8>, Effect)>,
    /// Where both are found, once the lines have the form of a bare line.
    pub(crate) lookup: Lookup,
    /// Name of the swivel data record.
    pub(crate) swivel_data: String,
    /// Number of the spindle of the tool, where its speed has it: `S3=2000`.
    pub(crate) spindle_number: Option<u32>,
    /// A length without a decimal point counts millimetres or inches, whatever is usual on the control.
    pub(crate) plain: bool,
    /// Tools by name.
    pub(crate) tools: Vec<(String, u32)>,
    /// Tools are called by these names, otherwise by number.
    pub(crate) tools_by_name: bool,
    /// Half a unit of a linear word, mm.
    pub(crate) rounding: f64,
}

/// Text of a program, in pieces.
pub(crate) trait TextPieces {
    /// Replaces a piece by the next one. An empty one is the end.
    ///
    /// # Errors
    /// The program cannot be read.
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()>;
}

/// A text in memory, as one piece.
struct InMemory<'a>(&'a [u8]);

impl TextPieces for InMemory<'_> {
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()> {
        piece.clear();
        piece.extend_from_slice(std::mem::take(&mut self.0));
        Ok(())
    }
}

impl<R: Read> TextPieces for R {
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()> {
        piece.resize(PIECE, 0);
        let read = loop {
            match self.read(piece) {
                Err(error) if error.kind() == io::ErrorKind::Interrupted => (),
                read => break read,
            }
        };
        piece.truncate(*read.as_ref().unwrap_or(&0));
        read.map(drop)
    }
}

impl TextPieces for &mut dyn TextPieces {
    fn next_piece(&mut self, piece: &mut Vec<u8>) -> io::Result<()> {
        (**self).next_piece(piece)
    }
}

/// The lines of a form of programs, and what is remembered from one to the next.
trait LineLanguage: fmt::Debug {
    /// Reads a line that only moves axes; `false` if it is another, or may mean something else.
    fn moves(&self, _text: &[u8], _machine: &Interpreter, _moves: &mut Moves) -> bool {
        false
    }

    /// Reads a line; `false` if it is no block.
    fn line(&mut self, line: &mut Line<'_>) -> bool;

    /// Whether the line before belongs to a guard that has not ended.
    fn is_in_guard(&self) -> bool;

    /// The program has begun.
    fn begin(&mut self) {}

    /// Forgets what stays in force.
    fn forget(&mut self) {}
}

/// A line that only moves axes.
#[derive(Debug, Clone, Copy, Default)]
struct Moves {
    number: Option<u64>,
    feed: Option<f64>,
    motion: MotionOrder,
}

/// Reads a program block by block.
#[derive(Debug)]
pub(crate) struct Reader<P> {
    lines: Lines<P>,
    flow: Flow,
    /// The line with numbers in the place of its expressions.
    numbers: Vec<u8>,
    vocabulary: Arc<Vocabulary>,
    facts: Facts,
    dialect: Box<dyn LineLanguage>,
    machine: Interpreter,
    line: Vec<u8>,
    /// The line without what has a declared effect.
    blanked: Vec<u8>,
    bare: Bare,
    /// What was in force before the blocks at hand, where they may be skipped.
    before_skip: Option<Box<Interpreter>>,
    /// The shop has blocks of its own for the machine retract.
    own_retract: bool,
    words: OpenWords,
    orders: Orders,
    /// Acts of the line that have been executed.
    step: usize,
    moves: Moves,
    block: Block,
}

impl<P: TextPieces> Reader<P> {
    pub(crate) fn new(input: P, vocabulary: Vocabulary) -> Self {
        Self::with(input, Arc::new(own::prepare(vocabulary)))
    }

    /// A reader with a vocabulary whose lines can be found already.
    fn with(input: P, vocabulary: Arc<Vocabulary>) -> Self {
        let facts = vocabulary.family.facts();
        let own_retract = vocabulary.own.iter().any(|own| matches!(own.place, OwnPlace::Retract { .. }));
        let machine = Interpreter::new(vocabulary.axes.clone(), facts, vocabulary.rounding);
        let dialect: Box<dyn LineLanguage> = match facts.form {
            LineForm::Letters => Box::new(Iso::new(&vocabulary, &machine)),
            LineForm::Keywords => Box::new(SiemensLines::default()),
            LineForm::Statements => Box::new(HeidenhainLines::default()),
        };
        Self {
            lines: Lines::new(input, facts.form == LineForm::Statements),
            flow: Flow::new(&facts),
            numbers: Vec::new(),
            vocabulary,
            facts,
            dialect,
            machine,
            line: Vec::new(),
            blanked: Vec::new(),
            bare: Bare::default(),
            before_skip: None,
            own_retract,
            words: OpenWords::default(),
            orders: Orders::default(),
            step: 0,
            moves: Moves::default(),
            block: Block::default(),
        }
    }

    /// The next act of the line at hand, or else of the next line that is more than a comment; and the text of the
    /// line.
    pub(crate) fn next_block(&mut self) -> io::Result<Option<(&Block, &[u8])>> {
        self.step += 1;
        if self.step <= self.orders.acts.len() && self.machine.go_on(&self.orders, self.step, &mut self.block) {
            return Ok(Some((&self.block, &self.line)));
        }
        while let Some(is_block) = self.execute_line()? {
            if is_block {
                return Ok(Some((&self.block, &self.line)));
            }
        }
        Ok(None)
    }

    /// Reads and executes the next line; whether it is more than a comment, `None` after the last one. A function of
    /// its own, so that nothing is prepared for more lines than one.
    #[inline(never)]
    fn execute_line(&mut self) -> io::Result<Option<bool>> {
        let begins = self.lines.number() == 0;
        let Some(kind) = self.lines.next(&mut self.line)? else { return Ok(None) };
        let LineKind { number, long, joined, misnumbered } = kind;
        self.block.faults.clear();
        self.block.own = None;
        self.block.line = number;
        self.orders.clear();
        self.step = 0;
        let mark = if begins { self.byte_order_mark() } else { None };
        let marked = self.take_skip_mark();
        self.follow_skip(marked);
        if !long && self.block.faults.is_empty() && mark.is_none() && self.moves_along() {
            return Ok(Some(true));
        }
        let taken = match long || self.dialect.is_in_guard() {
            true => Taken::Block,
            false => self.flow.take(&self.line, kind, &mut self.lines, &mut self.numbers)?,
        };
        if misnumbered {
            fault(&mut self.block.faults, 0, "the line number does not follow that of the previous line");
        }
        let is_block = match taken {
            Taken::Done => false,
            Taken::Refused(why) => {
                fault(&mut self.block.faults, 0, why);
                true
            }
            Taken::Unknown(expression) => {
                let is_block = self.read_line(false);
                // A guard, and a line of the shop, may have it.
                if self.block.faults.len() > self.orders.frame_faults && self.block.own.is_none() {
                    let text = format!("the value of `{expression}` does not follow from the program");
                    self.block.faults.insert(self.orders.frame_faults, BlockFault { column: 1, text });
                }
                is_block
            }
            Taken::Block => long || self.read_line(false),
            Taken::Substituted => self.read_line(true),
        };
        if long {
            let text = format!("this line is longer than {LONGEST} bytes and has not been read");
            fault(&mut self.block.faults, 0, text);
        }
        if let Some(encoding) = mark {
            let text = format!(
                "the program begins with a byte order mark ({encoding}), which the control reads as part of the first block: \
                 save the file as plain ASCII, or without the mark"
            );
            // In front of what follows from it.
            self.block.faults.insert(0, BlockFault { column: 1, text });
        }
        let is_block = is_block || !self.block.faults.is_empty();
        if is_block {
            self.machine.begin(&self.orders, &mut self.block);
            if self.orders.acts.contains(&Act::End) {
                self.flow.end();
            }
            if joined {
                text::put_marks_back(&mut self.line);
            }
        }
        Ok(Some(is_block))
    }

    /// Executes a line that only moves axes; `false` if it is another.
    fn moves_along(&mut self) -> bool {
        if self.own_retract || self.flow.has_ended() || !self.dialect.moves(&self.line, &self.machine, &mut self.moves)
        {
            return false;
        }
        // A word of it may have a declared effect.
        self.bare.forget();
        if own::declared(&self.line, &self.vocabulary, &self.facts, &mut self.bare, &mut self.blanked).is_some() {
            return false;
        }
        self.dialect.begin();
        self.block.number = self.moves.number;
        self.machine.move_along(&self.moves.motion, self.moves.feed, &mut self.block);
        true
    }

    /// Lines read so far.
    pub(crate) fn lines(&self) -> u64 {
        self.lines.number()
    }

    /// Takes away what an editor may put in front of the first block; the encoding that it stands for. No control is
    /// known that reads past it: the first block is refused there, or is no program number any more.
    fn byte_order_mark(&mut self) -> Option<&'static str> {
        let (mark, encoding) = MARKS.into_iter().find(|(mark, _)| self.line.starts_with(mark))?;
        self.line.drain(..mark.len());
        Some(encoding)
    }

    /// Takes away the mark of block skip at the beginning of the line; whether there was one.
    fn take_skip_mark(&mut self) -> bool {
        let Some(at) = self.line.iter().position(|byte| !byte.is_ascii_whitespace()) else { return false };
        if self.line[at] != b'/' {
            return false;
        }
        self.line.drain(..=at);
        let text = match self.line.trim_ascii_start() {
            [] | [b';'] => "block skip without a block",
            [b'0'..=b'9', ..] if self.facts.form != LineForm::Statements => {
                "block skip with a number: the check knows the mark `/` alone"
            }
            text if self.facts.form == LineForm::Keywords && begins_condition(text) => {
                "block skip before IF or ENDIF: the control executes it whatever the switch is set to"
            }
            _ => return true,
        };
        fault(&mut self.block.faults, 0, text.to_owned());
        true
    }

    /// Blocks that may be skipped begin or end. After them is known what is the same whether they were skipped or not.
    fn follow_skip(&mut self, marked: bool) {
        if marked != self.block.skippable {
            self.change_skip(marked);
        }
    }

    /// The first line that may be skipped, or that may no longer.
    #[inline(never)]
    fn change_skip(&mut self, marked: bool) {
        let in_guard = self.dialect.is_in_guard();
        if !in_guard && self.is_comment() {
            return;
        }
        if in_guard {
            fault(&mut self.block.faults, 0, "block skip begins or ends within a guard");
        }
        self.block.skippable = marked;
        match self.before_skip.take() {
            Some(before) => {
                self.machine.join(&before);
                self.block.state = *self.machine.state();
                self.dialect.forget();
            }
            None => self.before_skip = Some(Box::new(self.machine.clone())),
        }
    }

    /// Whether the line is empty, or a comment alone that the control does not display.
    fn is_comment(&self) -> bool {
        let mut text = self.line.trim_ascii();
        if self.facts.message.is_some_and(|[before, _]| text.starts_with(before.as_bytes())) {
            return false;
        }
        if self.facts.form == LineForm::Statements {
            let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
            text = text[digits..].trim_ascii_start();
        }
        matches!(text, [] | [b';' | b'*' | b'%', ..])
            || matches!(text, [b'(', inner @ .., b')'] if !inner.contains(&b')'))
    }

    /// Reads a line into its orders; whether it is a block. `substituted`: it has numbers in the place of expressions.
    fn read_line(&mut self, substituted: bool) -> bool {
        let vocabulary = &self.vocabulary;
        // Lines and words with a declared effect are blanked out: the rest of their line is read by the table.
        self.bare.forget();
        let declared = own::declared(&self.line, vocabulary, &self.facts, &mut self.bare, &mut self.blanked);
        let text = match declared.is_some() {
            true => &self.blanked,
            false if substituted => &self.numbers,
            false => &self.line,
        };
        self.words.clear();
        let into = (&mut self.words, &mut self.orders);
        let mut line = Line::new(text, vocabulary, &self.machine, into, &mut self.block.faults);
        let in_guard = self.dialect.is_in_guard();
        let mut is_block = self.dialect.line(&mut line);
        let may_switch = !line.orders.moves_axes() && !vocabulary.own.is_empty();
        let switched = may_switch && own::switch(self.bare.text(&self.line, &self.facts), &mut line);
        // A stop may be a line of the tool change.
        let stops = line.orders.stops() && !vocabulary.own.is_empty();
        if declared.is_some() || switched || stops || line.fault_count() > 0 {
            self.block.own = own::resolve(self.bare.text(&self.line, &self.facts), &mut line, declared, switched);
        }
        if self.own_retract && self.block.own.is_none() {
            let own = own::resolve(self.bare.text(&self.line, &self.facts), &mut line, None, false);
            self.block.own = own.filter(|own| own.places.iter().any(|place| matches!(place, OwnPlace::Retract { .. })));
        }
        if in_guard && self.block.own.is_some() {
            line.lasting_fault(0, "a block of the shop in a guard: it is executed only under the condition");
        }
        is_block |= self.block.own.is_some();
        if self.orders.effects & effect::STATE != 0 {
            self.dialect.forget();
        }
        is_block
    }
}
