//! A foreign interpreter: programs of all five controls, executed block by block.
//!
//! It shares no code with the postprocessor and imports nothing of it. Each block becomes one [`Executed`] with its
//! [`Effect`] and the whole modal [`State`] after it; a program becomes a [`Trace`]. What the control, or this reader,
//! does not know is refused and never passed over.
//!
//! Layers, each of which knows only the one below:
//!
//! 1. [`lexer`]: text into tokens, a lexer a family; `lexer::tidy` refuses untidy text.
//! 2. `flow`: lines in the order in which they are executed, with numbers for variables and expressions.
//! 3. `table`: tokens into a [`Command`](meaning::Command) of the common language in [`meaning`], a table a family. A
//!    new code is a row.
//! 4. `machine`: commands into effects and state, one machine for all controls; `machine::careful` refuses what a
//!    control would execute and no careful programmer writes, such as a feed motion with the spindle off.
//! 5. [`trace`]: the result.
//!
//! Length guards take several lines and are recognised as a whole, in `guard`.
//!
//! Lengths count in the unit of the program, angles in degrees. Kinematics, travel, offsets and tool tables are unknown
//! here: positions are coordinates of the program.

pub mod axes;
mod flow;
mod guard;
pub mod lexer;
mod machine;
pub mod meaning;
pub mod state;
mod table;
pub mod trace;

#[cfg(test)]
mod tests;

pub use axes::Axes;
pub use guard::guarded_length;
pub use state::State;
pub use trace::{Effect, Executed, Feed, Refused, Trace};

use std::collections::BTreeSet;

use flow::Flow;
use guard::{Guards, Outcome};
use lexer::{Content, Mark};
use machine::Machine;

/// Controls whose programs can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// LinuxCNC.
    LinuxCnc,
    /// Fanuc 30i and its kin.
    Fanuc,
    /// Haas NGC.
    Haas,
    /// Siemens 840D.
    Siemens,
    /// Heidenhain TNC, conversational.
    Heidenhain,
}

impl Control {
    /// Every control.
    pub const ALL: [Self; 5] = [Self::LinuxCnc, Self::Fanuc, Self::Haas, Self::Siemens, Self::Heidenhain];

    /// Name on the command line and in the names of golden programs.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::LinuxCnc => "linuxcnc",
            Self::Fanuc => "fanuc",
            Self::Haas => "haas",
            Self::Siemens => "siemens",
            Self::Heidenhain => "heidenhain",
        }
    }

    /// The control of this name.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|control| control.name() == name)
    }
}

/// A line at which the program is entered, the control just switched on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Entry {
    /// Line, from 1.
    pub line: usize,
    /// Tool in the spindle, as the operator has seen to.
    pub tool: Option<u32>,
}

/// How a program is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The control.
    pub control: Control,
    /// State that was left before the program.
    pub before: State,
    /// Where the program is entered; its first block without it.
    pub entry: Option<Entry>,
    /// Words are coordinates of the gauge line: no length compensation may be active.
    pub gauge_line: bool,
    /// Nothing is cut: feed motions run with the spindle off.
    pub dry: bool,
    /// Rapids are written at feed: such a motion is no cut.
    pub rapids_at_feed: bool,
    /// Text may be untidy, as edits by hand leave it.
    pub untidy: bool,
    /// What a control executes is executed, also where no careful programmer writes it; the end code ends the reading.
    pub careless: bool,
    /// Whole lengths are written with a point on every control.
    pub pointed: bool,
    /// Fanuc and Haas read a number without a point as one with a point.
    pub plain_numbers: bool,
    /// Blocks of the shop, such as codes of clamps, that the control's table does not have; they change no state known
    /// here.
    pub idle: Vec<String>,
}

impl Options {
    /// A whole program, tidy, with length compensation and spindle.
    #[must_use]
    pub fn of(control: Control) -> Self {
        Self {
            control,
            before: State::default(),
            entry: None,
            gauge_line: false,
            dry: false,
            rapids_at_feed: false,
            untidy: false,
            careless: false,
            pointed: false,
            plain_numbers: false,
            idle: Vec::new(),
        }
    }
}

/// Executes a program from its first block to its end code.
///
/// # Errors
/// [`Refused`] at the first line that this reader or a careful control would not run.
pub fn run(text: &str, options: &Options) -> Result<Trace, Refused> {
    let mut run = Run {
        options,
        machine: Machine::new(options),
        guards: Guards::default(),
        trace: Trace::default(),
        reached: options.entry.is_none(),
        ended: Ended::No,
        tapes: 0,
        parts: Parts::default(),
        skippable: BTreeSet::new(),
    };
    let last = text.lines().count();
    if !options.untidy && !text.ends_with('\n') {
        return Err(Refused { line: last, why: "the last line does not end".to_owned() });
    }
    if !options.untidy {
        for (index, line) in text.split_terminator('\n').enumerate() {
            let tidy = lexer::tidy::check(
                options.control,
                line.strip_prefix('/')
                    .unwrap_or(line)
                    .strip_suffix('~')
                    .map_or_else(|| line.trim_start_matches('/'), str::trim_end),
                options.pointed,
            );
            tidy.map_err(|why| Refused { line: index + 1, why: format!("{why}: {line}") })?;
        }
    }
    let mut joined = lexer::joined(options.control, text);
    for (line, text) in &mut joined {
        if let Some(rest) = text.strip_prefix('/') {
            run.skippable.insert(*line);
            *text = rest.trim_start().to_owned();
        }
    }
    if options.control == Control::Heidenhain {
        numbered(&joined)?;
    }
    let mut flow = Flow::new(options.control, options.untidy, &options.idle, joined);
    let mut last_line = 0;
    loop {
        let next = flow.line(run.guards.is_open()).map_err(|(line, why)| Refused { line, why })?;
        let Some((line, text)) = next else { break };
        let (reached, ended) = (run.reached, run.ended);
        if !reached && options.entry.is_some_and(|entry| line >= entry.line) {
            flow.forget();
        }
        let skippable = [last_line, line].map(|line| run.skippable.contains(&line));
        if run.guards.is_open() && skippable[0] != skippable[1] {
            return Err(Refused { line, why: format!("a part of a guard may be skipped: {text}") });
        }
        last_line = line;
        run.line(line, &text).map_err(|why| Refused { line, why: format!("{why}: {text}") })?;
        if ended == Ended::No && run.ended == Ended::Code {
            flow.end();
        }
    }
    if run.ended == Ended::No || !run.reached || run.guards.is_open() {
        return Err(Refused { line: last, why: "there is no end code".to_owned() });
    }
    Ok(run.trace)
}

/// Refuses lines of a Heidenhain program whose numbers do not follow each other.
fn numbered(lines: &[(usize, String)]) -> Result<(), Refused> {
    let mut last: Option<u32> = None;
    for (line, text) in lines {
        let refused = |why: &str| Refused { line: *line, why: format!("{why}: {text}") };
        let (number, rest) = text.trim_start().split_once(' ').ok_or_else(|| refused("a line without its number"))?;
        let number = number.parse().map_err(|_| refused("a line without its number"))?;
        if last.is_some_and(|last| number != last + 1) {
            return Err(refused("the line number does not follow that of the line before"));
        }
        last = Some(number);
        if rest.starts_with("END PGM ") {
            break;
        }
    }
    Ok(())
}

/// Progress towards the end of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ended {
    No,
    /// After the end code.
    Code,
    /// After the mark that closes the file.
    File,
}

struct Run<'a> {
    options: &'a Options,
    machine: Machine,
    guards: Guards,
    trace: Trace,
    /// The entry has been reached.
    reached: bool,
    ended: Ended,
    /// Marks `%` so far.
    tapes: u32,
    parts: Parts,
    /// Lines that may be skipped.
    skippable: BTreeSet<usize>,
}

/// Parts of the old cycles of Heidenhain: 9.0 is followed by 9.1, and 9.1 follows 9.0.
#[derive(Debug, Default)]
struct Parts {
    /// Cycle and part of the block before.
    last: Option<(u32, u32)>,
    /// The mode of a tolerance must come next: 32.2.
    mode_due: bool,
}

impl Parts {
    fn next(&mut self, text: &str) -> Result<(), String> {
        let part = text.split_once("CYCL DEF ").and_then(|(_, rest)| {
            let (cycle, part) = rest.split(' ').next()?.split_once('.')?;
            Some((cycle.parse().ok()?, part.parse().ok()?))
        });
        let before = self.last;
        self.last = part;
        if part == Some((32, 2)) {
            self.mode_due = false;
        } else if part == Some((32, 1)) {
            self.mode_due = text.contains("32.1 T");
        }
        let follows = match part {
            Some((cycle, number)) if number > 0 => before == Some((cycle, number - 1)),
            // A tolerance has its mode after it.
            _ => !matches!(before, Some((_, 0))) && !std::mem::take(&mut self.mode_due),
        };
        if follows { Ok(()) } else { Err("a cycle without all its parts".to_owned()) }
    }
}

impl Run<'_> {
    fn line(&mut self, line: usize, text: &str) -> Result<(), String> {
        if self.options.careless && self.ended != Ended::No {
            return Ok(());
        }
        let control = self.options.control;
        let lexer::Line { number, content } = lexer::line(control, text)?;
        let closing = matches!(content, Content::Mark(Mark::Tape | Mark::End));
        if self.ended != Ended::No && !(self.ended == Ended::Code && closing) {
            return Err("something follows the end code".to_owned());
        }
        self.reached |= self.options.entry.is_some_and(|entry| line >= entry.line);
        if ["BLK FORM ", "WORKPIECE("].iter().any(|blank| text.contains(blank)) {
            self.trace.blank.push(text.to_owned());
        }
        if control == Control::LinuxCnc && text.starts_with('o') && self.reached && self.is_block_of_the_shop(text) {
            self.calls_the_shop(line);
            return Ok(());
        }
        match self.guards.line(control, line, &content)? {
            Outcome::NotAGuard => {}
            Outcome::GoesOn => {
                if let Content::Comment(text) = content {
                    self.trace.comments.push((line, text));
                }
                return Ok(());
            }
            Outcome::Complete(line, effect, register) => {
                if self.reached {
                    match effect {
                        Effect::Guard { .. } => self.machine.guard(register)?,
                        Effect::OffsetGuard => self.machine.offset_guard()?,
                        _ => {}
                    }
                    self.push(line, None, effect, Axes::default(), false);
                }
                return Ok(());
            }
        }
        match content {
            Content::Comment(text) => {
                if self.options.careless && control == Control::Heidenhain && self.reached {
                    self.parts.next("")?;
                }
                self.trace.comments.push((line, text));
            }
            Content::Mark(mark) => {
                if self.options.careless && mark == Mark::Remark && self.reached {
                    self.parts.next("")?;
                }
                self.mark(mark)?;
            }
            Content::Block(_) if control == Control::LinuxCnc && text.to_ascii_lowercase().contains("(abort,") => {
                return Err("the program stops here (abort)".to_owned());
            }
            Content::Block(tokens) if self.reached => {
                let numbered = |token: &lexer::Token| matches!(token, lexer::Token::Word { name, .. } if name == "N");
                if number.is_some() && tokens.iter().any(numbered) {
                    return Err("two block numbers".to_owned());
                }
                if self.options.careless && control == Control::Heidenhain {
                    self.parts.next(text)?;
                }
                let command = match table::command(self.options, &tokens, &self.machine.state) {
                    Err(_) if self.is_block_of_the_shop(text) => {
                        self.calls_the_shop(line);
                        return Ok(());
                    }
                    Err(why) => {
                        let rest = self.without_codes_of_the_shop(line, tokens);
                        let rest = rest.filter(|rest| rest.is_empty() || self.options.careless).ok_or(why)?;
                        if rest.is_empty() {
                            return Ok(());
                        }
                        table::command(self.options, &rest, &self.machine.state)?
                    }
                    command => command?,
                };
                let meanings = command.meanings.clone();
                let (effect, words) = self.machine.execute(command)?;
                let restart = match control {
                    Control::Heidenhain => text.ends_with(" M129"),
                    _ => number.is_some(),
                };
                self.push(line, number, effect, words, restart);
                if effect.moves() && self.machine.at_end(&meanings) {
                    self.push(line, None, Effect::Modal, Axes::default(), false);
                }
                if effect == Effect::End {
                    self.ended = Ended::Code;
                }
            }
            Content::Block(_) => {}
            Content::Condition(_) => return Err("a condition outside a guard".to_owned()),
        }
        Ok(())
    }

    /// Whether a block, its number aside, is one of the shop's and no M code.
    fn is_block_of_the_shop(&self, text: &str) -> bool {
        let unnumbered = match text.split_once(' ') {
            Some((number, rest)) if number.trim_start_matches('N').parse::<u32>().is_ok() => rest,
            _ => text,
        };
        self.options.idle.iter().any(|idle| idle == unnumbered && (idle.contains(' ') || !idle.starts_with('M')))
    }

    /// A program of the shop measures: it leaves the axes and the modes anywhere.
    fn calls_the_shop(&mut self, line: usize) {
        let State { tool, selected, spindle, speed, units, distance, feed_mode, .. } = self.machine.state;
        let heidenhain = self.options.control == Control::Heidenhain;
        let (distance, feed_mode) = (distance.filter(|_| heidenhain), feed_mode.filter(|_| heidenhain));
        self.machine.state = State { tool, selected, spindle, speed, units, distance, feed_mode, ..State::default() };
        self.push(line, None, Effect::Shop(u32::MAX), Axes::default(), false);
    }

    /// The tokens of a block but for the codes of the shop, which are executed; `None` if it has none.
    fn without_codes_of_the_shop(&mut self, line: usize, tokens: Vec<lexer::Token>) -> Option<Vec<lexer::Token>> {
        let code = |token: &lexer::Token| match token {
            lexer::Token::Word { name, number, .. } if name == "M" => {
                let code = meaning::whole(number.value).ok()?;
                self.options.idle.contains(&format!("M{code}")).then_some(code)
            }
            _ => None,
        };
        // A statement of Heidenhain ends in its M codes.
        if self.options.control == Control::Heidenhain && tokens.len() > 1 && code(&tokens[0]).is_some() {
            return None;
        }
        let codes: Vec<u32> = tokens.iter().filter_map(code).collect();
        let rest: Vec<lexer::Token> = tokens.iter().filter(|token| code(token).is_none()).cloned().collect();
        if codes.is_empty() || !rest.is_empty() && !self.options.careless {
            return None;
        }
        for code in codes {
            self.push(line, None, Effect::Shop(code), Axes::default(), false);
        }
        Some(rest)
    }

    fn mark(&mut self, mark: Mark) -> Result<(), String> {
        let begun = !self.trace.blocks.is_empty();
        match mark {
            Mark::Tape | Mark::Name | Mark::Begin(_) if self.ended == Ended::No && (begun || self.tapes > 1) => {
                return Err("the program ends, or another one begins".to_owned());
            }
            // The file begins and ends with this mark.
            Mark::Tape if self.ended == Ended::Code => self.ended = Ended::File,
            Mark::End => self.ended = Ended::File,
            Mark::Begin(inches) => self.machine.begin(inches),
            Mark::Tape => self.tapes += 1,
            Mark::Name | Mark::Remark => {}
        }
        Ok(())
    }

    fn push(&mut self, line: usize, number: Option<u32>, effect: Effect, words: Axes, restart: bool) {
        let skippable = self.skippable.contains(&line);
        self.trace.blocks.push(Executed { line, number, effect, words, restart, skippable, state: self.machine.state });
    }
}
