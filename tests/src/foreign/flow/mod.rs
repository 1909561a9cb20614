//! Order of execution: variables, conditions, loops, jumps and subprograms of the five controls.
//!
//! The lines of a program are executed by a machine with variables and a next line. A block whose words hold values
//! becomes the block with numbers; the interpreter reads it as any other. A condition on an unknown value is handed on
//! as it is: it belongs to a guard, or is refused there.
//!
//! Unknown are variables that the program has not set, also where a control would read zero or an empty value.

mod expression;
mod statement;
mod words;

use std::collections::BTreeMap;
use std::ops::Range;

use super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use expression::{Fault, ValueReader, Variables, index, wrong};
use statement::{Call, Direction, FlowLine, Statement};

/// Most lines that are executed.
const MOST: usize = 100_000;

/// Most calls within each other.
const DEEPEST: usize = 20;

/// A program that is being executed.
pub(super) struct Flow {
    control: Control,
    /// Lines are handed on as they are where programs hold no variables.
    active: bool,
    lines: Vec<FlowLine>,
    /// Next line.
    next: usize,
    /// After the last line that has been read.
    furthest: usize,
    executed: usize,
    variables: Variables,
    frames: Vec<Frame>,
}

/// A program or subprogram that is being executed.
#[derive(Debug)]
struct Frame {
    /// First line, and the line after the call.
    start: usize,
    back: usize,
    /// Runs that are left, this one with them.
    runs: u32,
    /// Lines in which its labels are.
    body: Range<usize>,
    /// Variables at the start of each run, where it has its own.
    own: Option<BTreeMap<String, f64>>,
    /// Runs that are left of each repetition, by its line.
    left: BTreeMap<usize, u32>,
}

/// What became of a line.
enum Done {
    /// It is executed.
    Here,
    /// It is a block for the interpreter.
    Block(String),
}

impl Flow {
    pub(super) fn new(control: Control, active: bool, idle: &[String], joined: Vec<(usize, String)>) -> Self {
        let mut variables = Variables::default();
        variables.begin(BTreeMap::new());
        let mut lines = statement::lines(control, joined, &mut variables);
        // Calls of the shop's own programs.
        for line in lines
            .iter_mut()
            .filter(|line| idle.iter().any(|idle| line.code.eq_ignore_ascii_case(&idle.replace(" ", ""))))
        {
            line.statement = Statement::Block;
        }
        let mut flow =
            Self { control, active, lines, next: 0, furthest: 0, executed: 0, variables, frames: Vec::new() };
        let body = 0..flow.end_of_program(0);
        flow.frames.push(Frame { start: 0, back: 0, runs: 1, body, own: None, left: BTreeMap::new() });
        flow
    }

    /// Nothing is known any longer.
    pub(super) fn forget(&mut self) {
        self.variables.forget();
    }

    /// Goes to what follows the subprograms after the end code.
    pub(super) fn end(&mut self) {
        let rest = self.next..self.lines.len();
        let code = |at: usize| self.lines[at].code.as_str();
        let begins = |at: &usize| {
            let numbered = self.control == Haas && self.lines[*at].statement == Statement::Nothing;
            statement::program(self.control, code(*at)).is_some() || numbered || code(*at).starts_with("LBL")
        };
        if rest.clone().next().as_ref().is_some_and(begins) {
            let closes = |at: &usize| matches!(code(*at), "%") || code(*at).starts_with("END PGM");
            self.next = rest.clone().rev().find(closes).unwrap_or(rest.end);
        }
    }

    /// The next line for the interpreter with its number; all lines as they are while a guard is open.
    pub(super) fn line(&mut self, guard: bool) -> Result<Option<(usize, String)>, (usize, String)> {
        loop {
            let at = self.next;
            let Some(line) = self.lines.get(at) else { return Ok(None) };
            let number = line.number;
            self.executed += 1;
            if self.executed > MOST + self.lines.len() {
                return Err((number, "the program does not end".to_owned()));
            }
            self.next += 1;
            self.furthest = self.furthest.max(self.next);
            let conditional =
                matches!(&line.statement, Statement::If(_) | Statement::Jump(Some(_), ..) | Statement::IfThen(..));
            let raw = line.text.clone();
            if guard || !self.active {
                if self.control == Heidenhain {
                    // Its guards compute with these.
                    for name in ["QL1", "QL2", "QL3"] {
                        self.variables.set(Heidenhain, name, None);
                    }
                }
                return Ok(Some((number, raw)));
            }
            match self.execute(at) {
                Ok(Done::Here) => {}
                Ok(Done::Block(text)) => return Ok(Some((number, text))),
                Err(Fault::Unknown) if conditional => return Ok(Some((number, raw))),
                Err(fault) => return Err((number, format!("{}: {raw}", fault.text()))),
            }
        }
    }

    fn reader<'a>(&'a self, text: &'a str) -> ValueReader<'a> {
        ValueReader { control: self.control, text, variables: &self.variables }
    }

    fn value(&self, text: &str) -> Result<f64, Fault> {
        self.reader(text).whole_text()
    }

    fn holds(&self, condition: &str) -> Result<bool, Fault> {
        if self.control == Heidenhain
            && let Some((function, condition)) = condition.split_once(':')
        {
            return self.relation(function, condition);
        }
        self.value(condition).map(|value| value != 0.0)
    }

    /// `FN 9: IF +Q1 EQU +Q3`.
    fn relation(&self, function: &str, condition: &str) -> Result<bool, Fault> {
        let mut reader = self.reader(condition);
        let one = reader.primary()?;
        let word = match function {
            "9" => "EQU",
            "10" => "NE",
            "11" => "GT",
            _ => "LT",
        };
        if !reader.take(word) {
            return wrong("another comparison than that of the function");
        }
        let other = reader.primary()?;
        if !reader.text.is_empty() {
            return wrong("text after a comparison");
        }
        let apart = (one - other).abs();
        match word {
            _ if apart > 0.0 && apart < 1e-9 => Err(Fault::Unknown),
            "EQU" => Ok(apart == 0.0),
            "NE" => Ok(apart > 0.0),
            "GT" => Ok(one > other),
            _ => Ok(one < other),
        }
    }

    fn go(&mut self, to: usize) {
        self.next = to;
    }

    fn execute(&mut self, at: usize) -> Result<Done, Fault> {
        // The machine changes while a statement is executed.
        match self.lines[at].statement.clone() {
            Statement::Block => words::block(self, at).map(Done::Block),
            // The end of the main program.
            Statement::Return(_) if self.control == Siemens && self.frames.len() == 1 => {
                Ok(Done::Block(self.lines[at].text.clone()))
            }
            statement => self.flow(at, statement).map(|()| Done::Here),
        }
    }

    fn flow(&mut self, at: usize, statement: Statement) -> Result<(), Fault> {
        match statement {
            Statement::Block | Statement::Nothing | Statement::EndIf | Statement::Loop => {}
            Statement::Set(text) => self.set(&text)?,
            Statement::Declare(text) => self.declare(&text)?,
            Statement::Function(function, name, values) => self.function(function, &name, &values)?,
            Statement::If(condition) => {
                if !self.holds(&condition)? {
                    self.other_branch(at)?;
                }
            }
            // The branch before has been executed.
            Statement::ElseIf(_) | Statement::Else => self.go(self.close(at, Pair::Branch, false)? + 1),
            Statement::While(condition) => {
                if !self.holds(&condition)? {
                    self.go(self.close(at, Pair::Loop, false)? + 1);
                }
            }
            Statement::Repeat(times) => {
                let times = index(self.value(&times)?)?;
                if times == 0 {
                    self.go(self.close(at, Pair::Loop, false)? + 1);
                }
                self.frame().left.insert(at, times);
            }
            Statement::For(variable, from, to) => {
                let from = self.value(&from)?;
                self.assign(&variable, Ok(from))?;
                if from > self.value(&to)? {
                    self.go(self.close(at, Pair::Loop, false)? + 1);
                }
            }
            Statement::EndLoop => self.end_loop(at)?,
            Statement::EndLoopIf(condition, again) => {
                if self.holds(&condition)? == again {
                    self.go(self.open(at)? + 1);
                }
            }
            Statement::Break => self.go(self.close(at, Pair::Loop, false)? + 1),
            Statement::Continue => self.go(self.close(at, Pair::Loop, false)?),
            Statement::Jump(condition, label, direction) => {
                let jumps = condition.map_or(Ok(true), |condition| self.holds(&condition))?;
                if jumps {
                    let label = self.label(&label)?;
                    self.go(self.find(at, &label, direction)?);
                }
            }
            Statement::IfThen(condition, then) => {
                if self.holds(&condition)? {
                    self.flow(at, *then)?;
                }
            }
            Statement::RunAgain(label, times) => {
                let left = *self.frame().left.entry(at).or_insert(times);
                if left == 0 {
                    self.frame().left.remove(&at);
                } else {
                    self.frame().left.insert(at, left - 1);
                    self.go(self.find(at, &label, Direction::Around)?);
                }
            }
            Statement::Call(call) => self.call(at, &call)?,
            Statement::Sub => {
                let label = self.lines[at].label.clone();
                let end = (at..self.lines.len())
                    .find(|line| self.lines[*line].statement == Statement::EndSub && self.lines[*line].label == label);
                self.go(end.map_or_else(|| wrong("a subprogram does not end"), Ok)? + 1);
            }
            Statement::EndSub => self.leave("")?,
            Statement::Return(text) => self.leave(&text)?,
        }
        Ok(())
    }

    fn frame(&mut self) -> &mut Frame {
        self.frames.last_mut().expect("the main program")
    }

    /// Sets a variable; it is unknown from here on where its value is.
    fn assign(&mut self, name: &str, value: Result<f64, Fault>) -> Result<(), Fault> {
        let value = match value {
            Ok(value) => Some(value),
            Err(Fault::Unknown) => None,
            Err(fault) => return Err(fault),
        };
        let system = matches!(self.control, LinuxCnc | Fanuc | Haas)
            && name[1..]
                .parse::<u32>()
                .is_ok_and(|number| number >= if self.control == LinuxCnc { 5000 } else { 1000 });
        let of_cycles = self.control == Control::Heidenhain
            && name.strip_prefix('Q').and_then(|number| number.parse::<u32>().ok()).is_some_and(|number| number >= 100);
        if system || of_cycles {
            return wrong("a variable of the control");
        }
        self.variables.set(self.control, name, value);
        Ok(())
    }

    /// `#1=5`, `R1=5 R2=R1+1`, `Q1=+5`.
    fn set(&mut self, text: &str) -> Result<(), Fault> {
        let mut rest = text.trim().to_owned();
        let mut together = Vec::new();
        while !rest.is_empty() {
            let mut reader = self.reader(&rest);
            let name = reader.name()?;
            if !reader.take("=") {
                return wrong("an assignment in a block with words");
            }
            let value = reader.value();
            let after = match value {
                Err(Fault::Unknown) if reader.text.contains('=') => return Err(Fault::Unknown),
                Err(_) => String::new(),
                Ok(_) => reader.text.trim().to_owned(),
            };
            // LinuxCNC computes all values of a line before it sets a variable.
            if self.control == LinuxCnc {
                together.push((name, value));
            } else {
                self.assign(&name, value)?;
            }
            rest = after;
        }
        together.into_iter().try_for_each(|(name, value)| self.assign(&name, value))
    }

    /// `REAL A=5, B`: 0 without a value.
    fn declare(&mut self, text: &str) -> Result<(), Fault> {
        let Some((_, names)) = text.trim().split_once(' ') else { return wrong("a declaration without a name") };
        for part in names.split(',') {
            let (name, value) = part.split_once('=').unwrap_or((part, "0"));
            let value = self.value(value);
            self.assign(name.trim(), value)?;
        }
        Ok(())
    }

    /// `FN 0` to `FN 8` of Heidenhain.
    fn function(&mut self, function: u32, name: &str, values: &str) -> Result<(), Fault> {
        let reader = self.reader(values);
        let value = function_value(function, reader);
        self.assign(name, value)
    }

    /// The first branch after a condition that does not hold.
    fn other_branch(&mut self, mut at: usize) -> Result<(), Fault> {
        loop {
            at = self.close(at, Pair::Branch, true)?;
            if let Statement::ElseIf(condition) = self.lines[at].statement.clone()
                && !self.holds(&condition)?
            {
                continue;
            }
            self.go(at + 1);
            return Ok(());
        }
    }

    /// The line that closes the loop or the condition in which a line is, or its next branch.
    fn close(&self, at: usize, pair: Pair, branch: bool) -> Result<usize, Fault> {
        let mut depth = 0;
        for line in at + 1..self.lines.len() {
            let FlowLine { label, statement, .. } = &self.lines[line];
            if self.control != Siemens && *label != self.lines[at].label {
                continue;
            }
            let next = branch && matches!(statement, Statement::ElseIf(_) | Statement::Else);
            if depth == 0 && (next || pair.closes(statement)) {
                return Ok(line);
            }
            if pair.opens(statement) {
                depth += 1;
            } else if pair.closes(statement) {
                depth -= 1;
            }
        }
        wrong("a condition or a loop does not end")
    }

    /// The line that opens the loop that closes here.
    fn open(&self, at: usize) -> Result<usize, Fault> {
        let mut depth = 0;
        for line in (0..at).rev() {
            let other = &self.lines[line];
            if self.control != Siemens && other.label != self.lines[at].label {
                continue;
            }
            if Pair::Loop.opens(&other.statement) {
                if depth == 0 {
                    return Ok(line);
                }
                depth -= 1;
            }
            depth += usize::from(Pair::Loop.closes(&other.statement));
        }
        wrong("the end of a loop that has not begun")
    }

    fn end_loop(&mut self, at: usize) -> Result<(), Fault> {
        let open = self.open(at)?;
        match self.lines[open].statement.clone() {
            Statement::While(_) => self.go(open),
            Statement::Repeat(_) => {
                let left = self.frame().left.get(&open).copied().unwrap_or(1);
                self.frame().left.insert(open, left.saturating_sub(1));
                if left > 1 {
                    self.go(open + 1);
                }
            }
            Statement::For(variable, _, to) => {
                let next = self.value(&variable)? + 1.0;
                self.assign(&variable, Ok(next))?;
                if next <= self.value(&to)? {
                    self.go(open + 1);
                }
            }
            _ => self.go(open + 1),
        }
        Ok(())
    }

    /// Label of a jump: a value on Fanuc and Haas.
    fn label(&self, text: &str) -> Result<String, Fault> {
        match self.control {
            Fanuc | Haas => Ok(index(self.value(text)?)?.to_string()),
            _ => Ok(text.to_owned()),
        }
    }

    fn find(&self, at: usize, label: &str, direction: Direction) -> Result<usize, Fault> {
        let body = self.frames.last().expect("the main program").body.clone();
        let is = |line: &usize| {
            let line = &self.lines[*line];
            line.label.as_deref() == Some(label)
                && !Pair::Loop.opens(&line.statement)
                && !Pair::Loop.closes(&line.statement)
        };
        let forward = (at + 1..body.end).find(is);
        let backward = || (body.start..at.min(body.end)).rev().find(is);
        let first = || (body.start..at.min(body.end)).find(is);
        let found = match direction {
            Direction::Forward => forward,
            Direction::Backward => backward(),
            Direction::Around => forward.or_else(first),
        };
        found.map_or_else(|| wrong("the label of a jump is missing"), Ok)
    }

    /// Line after the program that begins before a line or in it.
    fn end_of_program(&self, start: usize) -> usize {
        let mut name = None;
        for (at, line) in self.lines.iter().enumerate().skip(start) {
            let begins = statement::program(self.control, &line.code);
            // `%_N_NAME_SPF`, then `PROC NAME`.
            let other = begins.is_some() && name.is_some() && begins != name;
            let main = self.control == Siemens && name.is_none() && begins.is_some() && at > start;
            if other || main || line.code == "%" && at > start {
                return at;
            }
            name = begins.or(name);
        }
        self.lines.len()
    }

    fn call(&mut self, at: usize, call: &Call) -> Result<(), Fault> {
        if self.frames.len() > DEEPEST {
            return wrong("too many calls within each other");
        }
        let mut runs = match &call.times {
            Some(times) => index(self.value(times)?)?,
            None => 1,
        };
        if runs == 0 {
            return Err(Fault::Unknown);
        }
        let mut own_start = 0;
        let (start, body) = if call.inside || self.control == LinuxCnc {
            let body = self.frames.last().expect("the main program").body.clone();
            (self.begin_inside(at, call)?, body)
        } else {
            let (start, more) = self.program(&call.name)?;
            runs *= more;
            own_start = start;
            let is_head = |at: &usize| {
                let code = self.lines.get(*at).map_or("", |line| line.code.as_str());
                self.control == Siemens && (code.is_empty() && *at < self.lines.len() || code.starts_with("PROC "))
            };
            let first = (start + 1..).find(|at| !is_head(at)).unwrap_or(start);
            (first - 1, start..self.end_of_program(start))
        };
        let own = call.arguments.as_ref().map(|text| self.arguments(own_start, text)).transpose()?;
        if let Some(own) = &own {
            self.variables.begin(own.clone());
        }
        self.frames.push(Frame { start: start + 1, back: at + 1, runs, body, own, left: BTreeMap::new() });
        self.go(start + 1);
        Ok(())
    }

    /// The line of a label, or of a subprogram of LinuxCNC, which has been read before.
    fn begin_inside(&self, at: usize, call: &Call) -> Result<usize, Fault> {
        if self.control != LinuxCnc {
            return self.find(at, &self.label(&call.name)?, Direction::Around);
        }
        let found = (0..self.furthest).find(|line| {
            let line = &self.lines[*line];
            line.statement == Statement::Sub && line.label.as_deref() == Some(&call.name)
        });
        found.ok_or(Fault::Unknown)
    }

    /// First line of a program of this name, and its runs where the name holds them: `M98 P21000`.
    fn program(&self, name: &str) -> Result<(usize, u32), Fault> {
        let iso = matches!(self.control, Fanuc | Haas);
        let name = if iso { index(self.value(name)?)?.to_string() } else { name.to_owned() };
        let of = |name: &str| {
            let is = |line: &FlowLine| statement::program(self.control, &line.code).as_deref() == Some(name);
            self.lines.iter().position(is)
        };
        if let Some(start) = of(&name) {
            return Ok((start, 1));
        }
        let runs_and_name = (self.control == Fanuc && name.len() > 4).then(|| name.split_at(name.len() - 4));
        let (runs, name) = runs_and_name.ok_or(Fault::Unknown)?;
        let start = of(name.trim_start_matches('0')).ok_or(Fault::Unknown)?;
        Ok((start, runs.parse().unwrap_or(1)))
    }

    /// Variables of a call at its start.
    fn arguments(&self, start: usize, text: &str) -> Result<BTreeMap<String, f64>, Fault> {
        let mut own = BTreeMap::new();
        let mut put = |name: String, value: Result<f64, Fault>| match value {
            Ok(value) => {
                own.insert(name, value);
                Ok(())
            }
            Err(Fault::Unknown) => Ok(()),
            Err(fault) => Err(fault),
        };
        match self.control {
            LinuxCnc => {
                let mut reader = self.reader(text);
                for number in 1..=30 {
                    let value = if reader.text.is_empty() { Ok(0.0) } else { reader.primary() };
                    if value == Err(Fault::Unknown) {
                        return Err(Fault::Unknown);
                    }
                    put(format!("#{number}"), value)?;
                }
            }
            Fanuc | Haas => {
                let mut centres = [0; 3];
                for (letter, value) in statement::letters(text) {
                    let number = match "IJK".find(letter) {
                        Some(place) => {
                            centres[place] += 1;
                            1 + place + 3 * centres[place]
                        }
                        None => match "ABCDEFGHIJKLMNOPQRSTUVWXYZ".find(letter).map(|place| LOCALS[place]) {
                            Some(number) if number > 0 => number,
                            _ => return wrong("a letter that is no argument"),
                        },
                    };
                    put(format!("#{number}"), self.value(&value))?;
                }
            }
            _ => {
                let parameters = self.parameters(start);
                let text = text.trim();
                let inside = text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).unwrap_or(text);
                let given: Vec<&str> = words::arguments(inside);
                if given.len() > parameters.len() {
                    return wrong("more arguments than parameters");
                }
                for (place, (name, default)) in parameters.iter().enumerate() {
                    let value = given.get(place).copied().filter(|value| !value.is_empty()).unwrap_or(default);
                    let whole = self.variables.whole.contains(name);
                    put(name.clone(), self.value(value).map(|value| if whole { value.round() } else { value }))?;
                }
            }
        }
        Ok(own)
    }

    /// Names of `PROC NAME(REAL A, INT B=2)` with their values where the call has none.
    fn parameters(&self, start: usize) -> Vec<(String, String)> {
        let code = |at: usize| self.lines.get(at).map_or("", |line| line.code.as_str());
        let proc = (start..start + 3).map(code).find(|code| code.starts_with("PROC ")).unwrap_or_default();
        let inside = proc.split_once('(').and_then(|(_, rest)| rest.rsplit_once(')')).map_or("", |(inside, _)| inside);
        let parameter = |part: &str| {
            let (name, value) = part.split_once('=').unwrap_or((part, "0"));
            (name.split_whitespace().last().unwrap_or_default().to_owned(), value.to_owned())
        };
        inside.split(',').filter(|part| !part.trim().is_empty()).map(parameter).collect()
    }

    /// The end of a subprogram: it runs again, or its caller goes on.
    fn leave(&mut self, text: &str) -> Result<(), Fault> {
        if self.frames.len() == 1 {
            // The end of a subprogram that has not been called.
            return if self.control == Heidenhain { Ok(()) } else { wrong("a return without a call") };
        }
        let result = if self.control == LinuxCnc && !text.is_empty() { Some(self.value(text)?) } else { None };
        let target =
            if matches!(self.control, Fanuc | Haas) && !text.is_empty() { Some(self.label(text)?) } else { None };
        let frame = self.frame();
        frame.runs -= 1;
        frame.left.clear();
        let (start, back, runs, own) = (frame.start, frame.back, frame.runs, frame.own.clone());
        if let Some(own) = own {
            self.variables.end();
            if runs > 0 {
                self.variables.begin(own);
            }
        }
        if runs > 0 {
            self.go(start);
            return Ok(());
        }
        self.frames.pop();
        self.go(back);
        if let Some(value) = result {
            self.variables.set(self.control, "#<_VALUE>", Some(value));
        }
        if let Some(label) = target {
            self.go(self.find(back - 1, &label, Direction::Around)?);
        }
        Ok(())
    }
}

/// Variables of the letters A to Z as arguments of G65; 0 where a letter is none.
const LOCALS: [usize; 26] = [1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];

fn function_value(function: u32, mut reader: ValueReader<'_>) -> Result<f64, Fault> {
    let value = match function {
        0 => reader.primary()?,
        5 => {
            reader.take("SQRT");
            reader.primary()?.sqrt()
        }
        6 => {
            reader.take("SIN");
            reader.primary()?.to_radians().sin()
        }
        7 => {
            reader.take("COS");
            reader.primary()?.to_radians().cos()
        }
        _ => {
            let operators: &[&str] = match function {
                1 => &["+"],
                2 => &["-"],
                3 => &["*"],
                4 => &["DIV", "/"],
                _ => &["LEN"],
            };
            let one = reader.primary()?;
            if !operators.iter().any(|operator| reader.take(operator)) {
                return wrong("another operator than that of the function");
            }
            let other = reader.primary()?;
            match function {
                1 => one + other,
                2 => one - other,
                3 => one * other,
                4 => one / other,
                _ => one.hypot(other),
            }
        }
    };
    if reader.text.is_empty() && value.is_finite() { Ok(value) } else { wrong("not a value of this function") }
}

/// Lines that open and close each other.
#[derive(Debug, Clone, Copy)]
enum Pair {
    Branch,
    Loop,
}

impl Pair {
    fn opens(self, statement: &Statement) -> bool {
        match self {
            Self::Branch => matches!(statement, Statement::If(_)),
            Self::Loop => {
                matches!(statement, Statement::While(_) | Statement::Loop | Statement::Repeat(_) | Statement::For(..))
            }
        }
    }

    fn closes(self, statement: &Statement) -> bool {
        match self {
            Self::Branch => *statement == Statement::EndIf,
            Self::Loop => matches!(statement, Statement::EndLoop | Statement::EndLoopIf(..)),
        }
    }
}
