//! What a program of any control does, block by block, and in which state: a reader of letters and numbers that knows of
//! each control no more than what its blocks look like.

use std::collections::BTreeMap;

/// What is in force while a block moves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// Tool in the spindle.
    pub tool: Option<u32>,
    /// Tool that the next change brings.
    pub next: Option<u32>,
    /// Length offset; 0 is none.
    pub register: Option<u32>,
    /// Code of the spindle: 3, 4 or 5.
    pub spindle: Option<u32>,
    /// rev/min.
    pub speed: Option<f64>,
    /// Code of the coolant.
    pub coolant: Option<u32>,
    /// Word of the work offset, with the number behind it.
    pub offset: Option<String>,
    /// F counts blocks per minute.
    pub inverse: Option<bool>,
    /// A rapid.
    pub rapid: Option<bool>,
    /// F, of a feed motion.
    pub feed: Option<f64>,
    /// Where the axes stand, in the units of the program and in degrees.
    pub at: BTreeMap<char, f64>,
}

/// A block that moves.
#[derive(Debug, Clone, PartialEq)]
pub struct Moved {
    /// Line, from 0.
    pub line: usize,
    /// Its words are machine coordinates.
    pub machine: bool,
    /// Its words.
    pub words: BTreeMap<char, f64>,
    /// What is in force, the block obeyed.
    pub state: State,
}

/// Lines that are no blocks of a motion or a state, by how they begin.
const PASSED: [&str; 14] = ["(", ";", "*", "%", "O", "o", "FN", "LBL", "IF", "ENDIF", "MSG", "BEGIN", "END", "BLK"];

/// The text of a line without its number, the comment behind it and the separator of names and numbers.
#[must_use]
pub fn stripped(line: &str) -> &str {
    let text = match line.split_once(' ') {
        Some((number, rest)) if number.trim_start_matches('N').parse::<u32>().is_ok() => rest,
        _ => line,
    };
    text.split(';').next().unwrap_or(text).trim()
}

/// The lines at which a program can be entered: the first of its safety blocks.
#[must_use]
pub fn restarts(program: &str) -> Vec<usize> {
    let entered = |(_, line): &(usize, &str)| {
        line.starts_with('N') && line[1..].split(' ').next().is_some_and(|number| number.parse::<u32>().is_ok())
            || stripped(line) == "M129" && !line.starts_with('M')
    };
    program.lines().enumerate().filter(entered).map(|(line, _)| line).collect()
}

/// Every block that moves from a line on, where this is in force.
#[must_use]
pub fn moved(program: &str, from: usize, mut state: State) -> Vec<Moved> {
    let mut all = Vec::new();
    let mut guarded = false;
    for (line, text) in program.lines().enumerate().skip(from) {
        let text = stripped(text);
        // What stands inside a guard is not meant to happen.
        guarded = (guarded || text.starts_with("IF ABS")) && text != "ENDIF";
        if guarded || text.is_empty() || PASSED.iter().any(|passed| text.starts_with(passed)) {
            continue;
        }
        if let Some((machine, words)) = state.obey(text) {
            all.push(Moved { line, machine, words, state: state.clone() });
            if machine {
                state.at.retain(|letter, _| !all.last().is_some_and(|last| last.words.contains_key(letter)));
            }
        }
    }
    all
}

impl State {
    /// Obeys a block; the words of a motion, and whether they are machine coordinates.
    fn obey(&mut self, text: &str) -> Option<(bool, BTreeMap<char, f64>)> {
        if let Some(row) = text.strip_prefix("Q339=+") {
            self.offset = row.split(' ').next().map(str::to_owned);
            return None;
        }
        if text.starts_with("CYCL") || text.starts_with("PLANE") || text.starts_with("TOOL DEF") {
            return None;
        }
        if let Some(call) = text.strip_prefix("TOOL CALL ") {
            let tool = call.split(' ').next().and_then(|tool| tool.parse().ok());
            (self.tool, self.register) = (tool.or(self.tool), tool.or(self.register));
            self.speed = call.split('S').nth(1).and_then(|speed| speed.parse().ok());
            return None;
        }
        let tokens: Vec<&str> = text.split(' ').collect();
        let dwell = tokens[0] == "G4" || tokens[0] == "G04";
        let (mut machine, mut words) = (false, BTreeMap::new());
        for (index, token) in tokens.iter().enumerate().filter(|_| !dwell) {
            let Some((letter, number)) = token.chars().next().zip(token.get(1..)) else { continue };
            let Ok(number) = number.parse::<f64>() else { continue };
            match letter {
                'G' => self.code(number, tokens.get(index + 1), &mut machine),
                'M' if (number - 91.0).abs() < 0.5 => machine = true,
                'M' => self.auxiliary(number as u32),
                'H' | 'D' => self.register = Some(number as u32),
                'T' => self.next = Some(number as u32),
                'S' => self.speed = Some(number),
                'F' => self.feed = Some(number),
                'A' | 'B' | 'C' | 'X' | 'Y' | 'Z' => drop(words.insert(letter, number)),
                _ => {}
            }
        }
        machine |= tokens.contains(&"SUPA");
        if tokens[0] == "L" {
            (self.rapid, self.inverse) = (Some(tokens.contains(&"FMAX")), Some(false));
        }
        if words.is_empty() {
            return None;
        }
        if !machine {
            self.at.extend(&words);
        }
        Some((machine, words))
    }

    fn code(&mut self, number: f64, next: Option<&&str>, machine: &mut bool) {
        let tenths = (number * 10.0).round() as u32;
        match tenths {
            0 | 10 => self.rapid = Some(tenths == 0),
            490 => self.register = Some(0),
            530 => *machine = true,
            540..=593 | 5050..=5990 | 1540 => {
                let row = next.filter(|next| next.starts_with('P') && (tenths == 541 || tenths == 1540));
                self.offset = Some(format!("{tenths}{}", row.map_or("", |row| row)));
            }
            930 | 940 => self.inverse = Some(tenths == 930),
            _ => {}
        }
    }

    fn auxiliary(&mut self, code: u32) {
        match code {
            3..=5 => self.spindle = Some(code),
            6 => self.tool = self.next,
            7 | 8 | 9 | 88 | 89 => self.coolant = Some(code),
            _ => {}
        }
    }
}
