//! Reads an NC program back, block by block, as a control would that refuses everything doubtful.
//!
//! Knows the words of LinuxCNC and the order in which a control obeys them, and nothing of the writer. Each block becomes
//! one [`Step`]; what a block leaves in force is carried to the next. A program is refused where its text is untidy (a
//! `-0`, an exponent, two blanks), where a word is unknown, and where its state does not make sense: a feed motion without
//! spindle, length offset or F, a rapid in inverse time, a code that needs a block of its own and shares one.

use std::collections::BTreeMap;
use std::fmt;

/// Axis letters.
const AXES: &str = "XYZUVWABC";

/// Value of each axis word that is known, in the units of the program and in degrees.
pub type Position = BTreeMap<char, f64>;

/// A program, read to its end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Program {
    /// Comments without their brackets, and the lines they stand in.
    pub comments: Vec<(usize, String)>,
    /// What the blocks do.
    pub steps: Vec<Step>,
}

/// One block.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Line, from 1.
    pub line: usize,
    /// Block number.
    pub number: Option<u32>,
    /// What it does.
    pub action: Action,
}

/// What a block does.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// The complete state at a restart point.
    Safety(Safety),
    /// A motion.
    Motion(Motion),
    /// `T M6`.
    ToolChange(u32),
    /// `G43 H`.
    Length(u32),
    /// `o if`, `(abort, ..)` and `o endif`: the program stops unless the tool table says this length, mm.
    LengthGuard {
        /// mm.
        length: f64,
        /// mm.
        tolerance: f64,
    },
    /// `S M3` or `S M4`.
    Spindle {
        /// rev/min.
        speed: f64,
        /// M3.
        clockwise: bool,
    },
    /// `M5`.
    SpindleOff,
    /// `M7` or `M8`.
    Coolant(u32),
    /// `M9`.
    CoolantOff,
    /// `G4 P`, seconds.
    Dwell(f64),
    /// `G94` alone.
    FeedPerMinute,
    /// `M0`.
    Stop,
    /// `M1`.
    OptionalStop,
    /// `M2`.
    End,
}

/// The state that a safety line brings about.
#[derive(Debug, Clone, PartialEq)]
pub struct Safety {
    /// `G20`.
    pub inches: bool,
    /// Word of the work offset.
    pub work_offset: String,
    /// Every code of the line.
    pub codes: Vec<String>,
}

/// A motion in a straight line of the axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// `G53`: its words are machine coordinates.
    pub machine: bool,
    /// `G0`.
    pub rapid: bool,
    /// The words that stand in the block.
    pub written: Position,
    /// Every axis whose place is known behind the block; after `G53` the axes it moved are not.
    pub position: Position,
    /// The F in force; `None` for a rapid.
    pub feed: Option<Feed>,
    /// The tool in the spindle, if the program has called one.
    pub tool: Option<u32>,
    /// Lengths are inches.
    pub inches: bool,
}

/// An F word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feed {
    /// `G94`: units of length per minute.
    PerMinute(f64),
    /// `G93`: blocks per minute.
    InverseTime(f64),
}

/// Why a program is refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// Line, from 1.
    pub line: usize,
    /// The reason.
    pub why: String,
}

impl fmt::Display for Refused {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "line {}: {}", self.line, self.why)
    }
}

/// What is in force.
#[derive(Debug, Clone, Default)]
struct State {
    rapid: Option<bool>,
    inverse: Option<bool>,
    feed: Option<f64>,
    inches: Option<bool>,
    work_offset: bool,
    length: bool,
    tool: Option<u32>,
    spindle: bool,
    /// The words are those of the gauge line: no length offset is ever active.
    gauge_line: bool,
    position: Position,
    ended: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Word {
    letter: char,
    value: f64,
}

impl Program {
    /// Reads a program from its first block to its end code.
    ///
    /// # Errors
    /// [`Refused`] at the first block that a careful control would not run.
    pub fn read(text: &str) -> Result<Self, Refused> {
        Self::enter(text, None, false)
    }

    /// Reads a program from the block with this number on, as if the control had just been switched on. The tool stands
    /// in the spindle, as the operator has seen to.
    ///
    /// # Errors
    /// [`Refused`] at the first block that a careful control would not run.
    pub fn read_from(text: &str, number: u32, tool: u32) -> Result<Self, Refused> {
        Self::enter(text, Some((number, tool)), false)
    }

    /// Reads a program whose words are coordinates of the gauge line, from `entry` (number and tool) or from its first
    /// block: nowhere may a length offset be active.
    ///
    /// # Errors
    /// [`Refused`] at the first block that a careful control would not run.
    pub fn of_gauge_line(text: &str, entry: Option<(u32, u32)>) -> Result<Self, Refused> {
        Self::enter(text, entry, true)
    }

    fn enter(text: &str, entry: Option<(u32, u32)>, gauge_line: bool) -> Result<Self, Refused> {
        let mut program = Self::default();
        let mut state = State { tool: entry.map(|(_, tool)| tool), gauge_line, ..State::default() };
        let mut reached = entry.is_none();
        let (mut guard, mut warned): (Option<(String, Action)>, bool) = (None, false);
        if !text.ends_with('\n') {
            return Err(Refused { line: text.lines().count(), why: "the last line does not end".to_owned() });
        }
        for (index, text) in text.split_terminator('\n').enumerate() {
            let line = index + 1;
            let refused = |why: String| Refused { line, why: format!("{why}: {text}") };
            if state.ended {
                return Err(refused("something follows the end code".to_owned()));
            }
            if let Some(comment) = comment(text).map_err(refused)? {
                if comment.starts_with("abort,") != (guard.is_some() && !warned) {
                    return Err(refused("a guard stops the program once, and nothing else does".to_owned()));
                }
                warned |= guard.is_some();
                program.comments.push((line, comment.to_owned()));
                continue;
            }
            if let Some((label, action)) = guard.take() {
                if !warned || text != format!("{label} endif") {
                    return Err(refused("a guard does not end".to_owned()));
                }
                if reached {
                    program.steps.push(Step { line: line - 2, number: None, action });
                }
                continue;
            }
            if text.starts_with('o') {
                guard = Some(length_guard(text).ok_or_else(|| refused("not a guard".to_owned()))?);
                warned = false;
                if reached && !state.length {
                    return Err(refused("a guard before the length offset".to_owned()));
                }
                continue;
            }
            let mut words = words(text).map_err(refused)?;
            let number = (words[0].letter == 'N').then(|| words.remove(0).value as u32);
            reached = reached || entry.is_some_and(|(entry, _)| number == Some(entry));
            if reached {
                let action = state.obey(&words).map_err(refused)?;
                program.steps.push(Step { line, number, action });
            }
        }
        if !state.ended {
            return Err(Refused { line: text.lines().count(), why: "there is no end code".to_owned() });
        }
        Ok(program)
    }

    /// The motions, with their lines.
    pub fn motions(&self) -> impl Iterator<Item = (usize, &Motion)> {
        self.steps.iter().filter_map(|step| match &step.action {
            Action::Motion(motion) => Some((step.line, motion)),
            _ => None,
        })
    }
}

fn comment(text: &str) -> Result<Option<&str>, String> {
    let Some(inside) = text.strip_prefix('(') else { return Ok(None) };
    let Some(inside) = inside.strip_suffix(')') else { return Err("a comment does not end".to_owned()) };
    if inside.contains(['(', ')']) || inside.bytes().any(|byte| !(0x20..=0x7e).contains(&byte)) {
        return Err("a comment holds a bracket or a byte that is not ASCII".to_owned());
    }
    if text.len() > 255 {
        return Err("a comment is too long".to_owned());
    }
    Ok(Some(inside))
}

/// The label of a guard, and what it compares.
fn length_guard(text: &str) -> Option<(String, Action)> {
    let (label, condition) = text.split_once(" if ")?;
    let compared = condition.strip_prefix("[[ABS[#5403 - ")?.split(']').next()?;
    let tolerance = condition.rsplit(" GT ").next()?.strip_suffix("]]")?;
    let whole =
        format!("[[ABS[#5403 - {compared}] GT {tolerance}] AND [ABS[[#5403 * 25.4] - {compared}] GT {tolerance}]]");
    let action = Action::LengthGuard { length: compared.parse().ok()?, tolerance: tolerance.parse().ok()? };
    (condition == whole).then(|| (label.to_owned(), action))
}

fn words(text: &str) -> Result<Vec<Word>, String> {
    if text.len() > 255 {
        return Err("the block is too long".to_owned());
    }
    text.split(' ').map(word).collect()
}

/// A letter and a number in its shortest form.
fn word(text: &str) -> Result<Word, String> {
    let mut characters = text.chars();
    let letter = characters.next().ok_or("an empty line, or a blank too many")?;
    let number = characters.as_str();
    let digits = number.strip_prefix('-').unwrap_or(number);
    let (whole, fraction) = digits.split_once('.').map_or((digits, None), |(whole, fraction)| (whole, Some(fraction)));
    let tidy = letter.is_ascii_uppercase()
        && !whole.is_empty()
        && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
        && (whole == "0" || !whole.starts_with('0'))
        && fraction.is_none_or(|fraction| !fraction.is_empty() && !fraction.ends_with('0') && !fraction.contains('.'))
        && number != "-0";
    let value = number.parse().map_err(|_| format!("`{text}` is not a word"))?;
    if tidy { Ok(Word { letter, value }) } else { Err(format!("`{text}` is not a number in its shortest form")) }
}

/// The words of one block, taken out one after the other.
struct Block<'a> {
    words: &'a [Word],
    taken: Vec<bool>,
}

impl Block<'_> {
    fn take(&mut self, letter: char) -> Result<Option<f64>, String> {
        let mut found = None;
        for (word, taken) in self.words.iter().zip(&mut self.taken) {
            if word.letter == letter && !*taken {
                if found.is_some() {
                    return Err(format!("two {letter} words"));
                }
                *taken = true;
                found = Some(word.value);
            }
        }
        Ok(found)
    }

    fn need(&mut self, letter: char) -> Result<f64, String> {
        self.take(letter)?.ok_or_else(|| format!("{letter} is missing"))
    }

    /// Whether a code stands in the block; it is taken.
    fn code(&mut self, letter: char, value: f64) -> bool {
        let mut found = false;
        for (word, taken) in self.words.iter().zip(&mut self.taken) {
            if !*taken && word.letter == letter && (word.value - value).abs() < 1e-9 {
                *taken = true;
                found = true;
                break;
            }
        }
        found
    }

    fn end(&self) -> Result<(), String> {
        match self.words.iter().zip(&self.taken).find(|(_, taken)| !**taken) {
            Some((word, _)) => Err(format!("{}{} has no business here", word.letter, word.value)),
            None => Ok(()),
        }
    }
}

impl State {
    fn obey(&mut self, words: &[Word]) -> Result<Action, String> {
        let mut block = Block { words, taken: vec![false; words.len()] };
        let action = self.action(&mut block)?;
        block.end()?;
        Ok(action)
    }

    fn action(&mut self, block: &mut Block<'_>) -> Result<Action, String> {
        let (millimetres, inches) = (block.code('G', 21.0), block.code('G', 20.0));
        if millimetres || inches {
            return self.safety(block, inches);
        }
        for code in [0_u32, 1, 2, 5, 6, 7, 8, 9] {
            if block.code('M', f64::from(code)) {
                return self.auxiliary(code, block);
            }
        }
        for clockwise in [true, false] {
            if block.code('M', if clockwise { 3.0 } else { 4.0 }) {
                let speed = block.need('S')?;
                self.spindle = true;
                return if speed > 0.0 { Ok(Action::Spindle { speed, clockwise }) } else { Err("S0".to_owned()) };
            }
        }
        if block.code('G', 43.0) {
            if self.gauge_line {
                return Err("a length offset under words of the gauge line".to_owned());
            }
            self.length = true;
            return Ok(Action::Length(whole(block.need('H')?)?));
        }
        if block.code('G', 4.0) {
            if self.inverse != Some(false) {
                return Err("a dwell in inverse time".to_owned());
            }
            return Ok(Action::Dwell(block.need('P')?));
        }
        self.motion(block)
    }

    fn safety(&mut self, block: &mut Block<'_>, inches: bool) -> Result<Action, String> {
        let mut codes = vec![if inches { "G20" } else { "G21" }.to_owned()];
        for code in [17_u32, 40, 49, 80, 90, 94] {
            if !block.code('G', f64::from(code)) {
                return Err(format!("the safety line lacks G{code}"));
            }
            codes.push(format!("G{code}"));
        }
        if block.code('G', 64.0) {
            let tolerance = block.need('P')?;
            codes.push(format!("G64 P{tolerance}"));
        }
        let offsets = [54.0, 55.0, 56.0, 57.0, 58.0, 59.0, 59.1, 59.2, 59.3];
        let offset = offsets.into_iter().find(|&offset| block.code('G', offset)).ok_or("no work offset")?;
        let work_offset = format!("G{offset}");
        codes.push(work_offset.clone());
        let position = core::mem::take(&mut self.position);
        *self = Self {
            inverse: Some(false),
            inches: Some(inches),
            work_offset: true,
            tool: self.tool,
            spindle: self.spindle,
            gauge_line: self.gauge_line,
            // Where the length offset is gone, the program's Z is another one.
            position: position.into_iter().filter(|(letter, _)| "ABC".contains(*letter)).collect(),
            ..Self::default()
        };
        Ok(Action::Safety(Safety { inches, work_offset, codes }))
    }

    fn auxiliary(&mut self, code: u32, block: &mut Block<'_>) -> Result<Action, String> {
        match code {
            0 | 1 => {
                self.position.clear();
                self.spindle = false;
                Ok(if code == 0 { Action::Stop } else { Action::OptionalStop })
            }
            2 => {
                self.ended = true;
                Ok(Action::End)
            }
            5 => {
                self.spindle = false;
                Ok(Action::SpindleOff)
            }
            6 => {
                let tool = whole(block.need('T')?)?;
                self.tool = Some(tool);
                self.length = false;
                self.spindle = false;
                self.position.clear();
                Ok(Action::ToolChange(tool))
            }
            9 => Ok(Action::CoolantOff),
            kind => Ok(Action::Coolant(kind)),
        }
    }

    fn motion(&mut self, block: &mut Block<'_>) -> Result<Action, String> {
        let machine = block.code('G', 53.0);
        if block.code('G', 93.0) {
            self.inverse = Some(true);
        }
        let per_minute = block.code('G', 94.0);
        if per_minute {
            self.inverse = Some(false);
            self.feed = None;
        }
        let (rapid, feed) = (block.code('G', 0.0), block.code('G', 1.0));
        if rapid && feed {
            return Err("G0 and G1".to_owned());
        }
        if rapid || feed {
            self.rapid = Some(rapid);
        }
        let mut written = Position::new();
        for letter in AXES.chars() {
            if let Some(value) = block.take(letter)? {
                written.insert(letter, value);
            }
        }
        let feed_word = block.take('F')?;
        if written.is_empty() {
            let alone = per_minute && !rapid && !feed && !machine && feed_word.is_none();
            return if alone { Ok(Action::FeedPerMinute) } else { Err("a block that moves nothing".to_owned()) };
        }
        let rapid = self.rapid.ok_or("neither G0 nor G1 is in force")?;
        let inches = self.inches.ok_or("neither G20 nor G21 is in force")?;
        let inverse = self.inverse.ok_or("neither G93 nor G94 is in force")?;
        let feed = if rapid { None } else { Some(self.feed(inverse, feed_word)?) };
        if rapid && (inverse || feed_word.is_some()) {
            return Err("a rapid in inverse time or with F".to_owned());
        }
        if machine {
            if !rapid {
                return Err("G53 with feed".to_owned());
            }
            self.position.retain(|letter, _| !written.contains_key(letter));
        } else {
            if !self.work_offset || self.length == self.gauge_line {
                return Err("a motion without work offset or length offset".to_owned());
            }
            self.position.extend(&written);
        }
        let position = self.position.clone();
        Ok(Action::Motion(Motion { machine, rapid, written, position, feed, tool: self.tool, inches }))
    }

    fn feed(&mut self, inverse: bool, word: Option<f64>) -> Result<Feed, String> {
        if !self.spindle || self.tool.is_none() {
            return Err("a feed motion without tool or with the spindle off".to_owned());
        }
        if inverse {
            // An F of inverse time holds for its own block only.
            self.feed = None;
            return word.filter(|&feed| feed > 0.0).map(Feed::InverseTime).ok_or_else(|| "G93 without F".to_owned());
        }
        self.feed = word.or(self.feed);
        self.feed.filter(|&feed| feed > 0.0).map(Feed::PerMinute).ok_or_else(|| "G1 without F".to_owned())
    }
}

fn whole(value: f64) -> Result<u32, String> {
    let rounded = value.round();
    if (value - rounded).abs() < 1e-9 && (0.0..=99_999.0).contains(&rounded) {
        Ok(rounded as u32)
    } else {
        Err(format!("{value} is not a whole number"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const START: &str = "G21 G17 G40 G49 G80 G90 G94 G54\nT1 M6\nG43 H1\nS100 M3\n";

    fn motions(blocks: &str) -> Vec<Motion> {
        let program = Program::read(&format!("{START}{blocks}\nM2\n")).unwrap_or_else(|refused| panic!("{refused}"));
        program.motions().map(|(_, motion)| motion.clone()).collect()
    }

    fn refusal(blocks: &str) -> String {
        match Program::read(&format!("{START}{blocks}\nM2\n")) {
            Ok(_) => panic!("{blocks:?} is accepted"),
            Err(refused) => refused.why,
        }
    }

    #[test]
    fn words_stay_in_force_until_they_change() {
        let read = motions("G0 X1 Y2 B3\nG1 X-0.5 F10\nY4\nG93 B5 F7");
        assert_eq!(read[2].position, Position::from([('X', -0.5), ('Y', 4.0), ('B', 3.0)]));
        assert_eq!(read[2].written, Position::from([('Y', 4.0)]));
        assert_eq!(read[2].feed, Some(Feed::PerMinute(10.0)));
        assert_eq!(read[3].feed, Some(Feed::InverseTime(7.0)));
        assert_eq!((read[0].rapid, read[3].rapid, read[3].tool), (true, false, Some(1)));
    }

    #[test]
    fn machine_coordinates_say_nothing_about_the_program() {
        let read = motions("G0 X1 Z2\nG53 G0 Z0\nX3");
        assert_eq!(read[1].position, Position::from([('X', 1.0)]));
        assert_eq!(read[2].position, Position::from([('X', 3.0)]));
    }

    #[test]
    fn untidy_text_is_refused() {
        for block in
            ["G0  X1", "G0 X1 ", " G0 X1", "G0 X-0", "G0 X1e3", "G0 X1.", "G0 X.5", "G0 X01", "G0 X1.50", "G0 x1"]
        {
            refusal(block);
        }
        refusal("(A (B) C)");
        refusal("(A");
        refusal("");
    }

    #[test]
    fn a_state_that_makes_no_sense_is_refused() {
        assert!(refusal("G1 X1").contains("G1 without F"));
        assert!(refusal("G93 G1 X1").contains("G93 without F"));
        assert!(refusal("G1 X1 F5\nG93 X2").contains("G93 without F"));
        assert!(refusal("G93 G1 X1 F5\nG94 X2").contains("G1 without F"));
        assert!(refusal("G93 G0 X1").contains("inverse time"));
        assert!(refusal("M5\nG1 X1 F5").contains("spindle off"));
        assert!(refusal("M0\nG1 X1 F5").contains("spindle off"));
        assert!(refusal("T2 M6\nG0 X1").contains("length offset"));
        assert!(refusal("G53 G1 X1 F5").contains("G53 with feed"));
        assert!(refusal("G0 X1 X2").contains("two X"));
        assert!(refusal("G0 X1 M8").contains("no business"));
        assert!(refusal("G0 X0\nG2 X1").contains("no business"));
        assert!(refusal("M2").contains("follows the end"));
        assert!(Program::read(START).is_err());
    }

    #[test]
    fn words_of_the_gauge_line_are_read_without_length_offset_only() {
        let without = START.replace("G43 H1\n", "") + "G0 X1\nM2\n";
        assert_eq!(Program::of_gauge_line(&without, None).expect("no offset").motions().count(), 1);
        assert!(Program::read(&without).is_err());
        assert!(Program::of_gauge_line(&format!("{START}G0 X1\nM2\n"), None).is_err());
    }

    #[test]
    fn a_guard_is_whole_or_refused() {
        let lines =
            ["o1 if [[ABS[#5403 - 9.5] GT 0.01] AND [ABS[[#5403 * 25.4] - 9.5] GT 0.01]]", "(abort, no)", "o1 endif"];
        let read = |lines: &[&str]| Program::read(&format!("{START}{}\nM2\n", lines.join("\n")));
        let program = read(&lines).expect("a guard");
        let guard = Action::LengthGuard { length: 9.5, tolerance: 0.01 };
        assert!(program.steps.iter().any(|step| step.action == guard));
        for left_out in 0..3 {
            let mut lines = lines.to_vec();
            lines.remove(left_out);
            assert!(read(&lines).is_err(), "{lines:?}");
        }
        assert!(read(&[&lines[0].replace("25.4] - 9.5", "25.4] - 9.4"), lines[1], lines[2]]).is_err());
    }

    #[test]
    fn a_program_can_be_entered_at_a_number_only_where_the_state_is_complete() {
        let start = START.replace("G21", "N1 G21");
        let complete = format!("{start}G0 X1 Z9\nN2 G21 G17 G40 G49 G80 G90 G94 G54\nG43 H1\nS9 M3\nG0 X2 Z9\nM2\n");
        assert_eq!(Program::read_from(&complete, 2, 1).expect("complete").motions().count(), 1);
        let incomplete = complete.replace("G43 H1\nS9", "S9");
        assert!(Program::read_from(&incomplete, 2, 1).is_err());
        assert!(Program::read_from(&complete, 7, 1).is_err());
    }
}
