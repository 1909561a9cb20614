//! Lines in the order in which a control executes them: variables, conditions, loops, jumps and subprograms whose
//! values follow from numbers of the program.
//!
//! A statement is carried out here, and a block comes out with numbers in the place of its expressions. What depends on
//! a value that the program does not state (a measured length, the clock) is left to the families, which know guards
//! and refuse the rest.

mod expression;
mod statement;
mod substitute;
mod variables;

use std::io;

use super::TextPieces;
use super::facts::{Facts, LineForm};
use super::lines::{LineKind, Lines};
use statement::{FlowStatement, Label, has_label, parse};
use variables::{Value, Variable, Variables};

/// Most lines that are read again: more are taken for a loop without an end.
const MOST_AGAIN: u64 = 5_000_000;

/// Deepest nesting of loops, conditions and calls.
const DEEPEST: usize = 64;

/// What becomes of a line.
#[derive(Debug, PartialEq)]
pub(super) enum Taken {
    /// It is a block as it is.
    Block,
    /// It is a block with numbers in the place of expressions.
    Substituted,
    /// It has been carried out, or belongs to a subprogram that is executed where it is called.
    Done,
    /// It is a statement that cannot be carried out, and why.
    Refused(String),
    /// An expression of it has a value that the program does not state: it may belong to a guard.
    Unknown(String),
}

/// A construct that has begun.
#[derive(Debug)]
struct Frame {
    label: Label,
    kind: FrameKind,
    /// Place of its first line.
    place: usize,
}

#[derive(Debug)]
enum FrameKind {
    If,
    While,
    /// Its condition is at its end.
    Do,
    /// Rounds that are left.
    Repeat(u32),
    For(Variable, f64),
    /// Line to which it returns, calls that are left, and the variables of its caller.
    Call {
        back: usize,
        left: u32,
        caller: Option<Box<Variables>>,
    },
    /// Rounds of a section that are left.
    Section(u32),
}

/// Statements of a program while it is executed.
#[derive(Debug)]
pub(super) struct Flow {
    form: LineForm,
    variables: Variables,
    frames: Vec<Frame>,
    /// Labels of subprograms that have been called.
    called: Vec<Label>,
    /// The end code has come; the lines after it are those of subprograms, and whether one has begun.
    ended: bool,
    in_subprogram: bool,
}

impl Flow {
    pub(super) fn new(facts: &Facts) -> Self {
        let (form, variables) = (facts.form, Variables::new(facts));
        Self { form, variables, frames: Vec::new(), called: Vec::new(), ended: false, in_subprogram: false }
    }

    /// Whether the program has ended.
    pub(super) fn has_ended(&self) -> bool {
        self.ended
    }

    /// The program has ended.
    pub(super) fn end(&mut self) {
        self.ended = true;
    }

    /// Takes a line: carries out a statement, or puts the block with its numbers into `text`.
    pub(super) fn take<P: TextPieces>(
        &mut self,
        line: &[u8],
        kind: LineKind,
        lines: &mut Lines<P>,
        text: &mut Vec<u8>,
    ) -> io::Result<Taken> {
        if self.ended {
            return Ok(self.after_end(line));
        }
        if lines.again() > MOST_AGAIN {
            return Ok(Taken::Refused(format!("after {MOST_AGAIN} lines in jumps and rounds the program has no end")));
        }
        if self.frames.iter().all(|frame| matches!(frame.kind, FrameKind::If)) {
            lines.forget_far();
        } else if lines.are_too_many() {
            self.frames.clear();
            return Ok(Taken::Refused("a loop, a condition or a subprogram longer than the check keeps".to_owned()));
        }
        if !substitute::may_state(line, self.form) {
            return Ok(Taken::Block);
        }
        if let Some(statement) = parse(line, &self.variables) {
            if self.is_for_family(&statement) {
                return Ok(Taken::Block);
            }
            let place = lines.keep(line, kind);
            return self.execute(statement, place, lines);
        }
        text.clear();
        Ok(match substitute::numbers(line, &self.variables, text) {
            Ok(false) => Taken::Block,
            Ok(true) => Taken::Substituted,
            Err(expression) => Taken::Unknown(expression),
        })
    }

    /// After the end code the subprograms that have been called may follow: they are executed where they are called.
    fn after_end(&mut self, line: &[u8]) -> Taken {
        let begins = self.called.iter().any(|label| has_label(line, label, self.form));
        self.in_subprogram |= begins;
        let inside = self.in_subprogram;
        if parse(line, &self.variables) == Some(FlowStatement::Return) {
            self.in_subprogram = false;
        }
        if inside { Taken::Done } else { Taken::Block }
    }

    /// Whether a statement is for the family: what a probe or a clock decides, and the end of a guard.
    fn is_for_family(&self, statement: &FlowStatement) -> bool {
        match statement {
            FlowStatement::If(value, _)
            | FlowStatement::While(value, _)
            | FlowStatement::Jump(value, _)
            | FlowStatement::Until(value, _)
            | FlowStatement::Repeat(value, _) => value.is_none(),
            FlowStatement::For(_, from, to, _) => from.is_none() || to.is_none(),
            FlowStatement::EndIf(label) => !matches!(self.innermost(label), Some(FrameKind::If)),
            _ => false,
        }
    }

    /// The innermost construct, if it has this label.
    fn innermost(&self, label: &Label) -> Option<&FrameKind> {
        self.frames.last().filter(|frame| frame.label == *label).map(|frame| &frame.kind)
    }

    fn execute<P: TextPieces>(
        &mut self,
        statement: FlowStatement,
        place: usize,
        lines: &mut Lines<P>,
    ) -> io::Result<Taken> {
        let next = place + 1;
        match statement {
            FlowStatement::Assign(assigned) => {
                for (variable, value) in assigned {
                    if variable.first().is_some_and(|first| first.is_ascii_alphabetic())
                        && self.form == LineForm::Keywords
                    {
                        self.variables.define(variable.clone());
                    }
                    if !self.variables.set(variable, value) {
                        return Ok(Taken::Refused("more variables than any program has".to_owned()));
                    }
                }
            }
            FlowStatement::If(condition, label) => {
                if condition != Some(0.0) {
                    return Ok(self.push(label, FrameKind::If, next));
                }
                // To the line after ELSE, whose end is an end of the condition, or after the end.
                return match self.find_end(lines, next, &label, true)? {
                    Some(at) => {
                        lines.go_to(at + 1);
                        let has_else = matches!(
                            lines.kept(at).and_then(|line| parse(line, &self.variables)),
                            Some(FlowStatement::Else(_))
                        );
                        Ok(if has_else { self.push(label, FrameKind::If, at + 1) } else { Taken::Done })
                    }
                    None => Ok(Taken::Refused("the end of this condition is not in the program".to_owned())),
                };
            }
            FlowStatement::Else(label) => {
                let ends = matches!(self.innermost(&label), Some(FrameKind::If));
                self.frames.pop();
                if !ends {
                    return Ok(Taken::Refused("ELSE without its condition".to_owned()));
                }
                return self.skip_to_end(lines, next, &label);
            }
            FlowStatement::EndIf(_) => _ = self.frames.pop(),
            FlowStatement::Do(label) => return Ok(self.push(label, FrameKind::Do, next)),
            FlowStatement::Until(condition, label) => {
                return Ok(self.end_of_round(&label, Some(condition == Some(0.0)), lines));
            }
            FlowStatement::While(condition, label) => {
                if matches!(self.innermost(&label), Some(FrameKind::Do)) {
                    return Ok(self.end_of_round(&label, Some(condition != Some(0.0)), lines));
                }
                if condition == Some(0.0) {
                    return self.skip_to_end(lines, next, &label);
                }
                return Ok(self.push(label, FrameKind::While, place));
            }
            FlowStatement::Repeat(times, label) => {
                let times = times.map_or(0, |times| times.max(0.0) as u32);
                if times == 0 {
                    return self.skip_to_end(lines, next, &label);
                }
                return Ok(self.push(label, FrameKind::Repeat(times - 1), next));
            }
            FlowStatement::For(variable, from, to, label) => {
                let (Some(first), Some(to)) = (from, to) else { return Ok(Taken::Block) };
                self.variables.set(variable.clone(), from);
                if first > to {
                    return self.skip_to_end(lines, next, &label);
                }
                return Ok(self.push(label, FrameKind::For(variable, to), next));
            }
            FlowStatement::EndLoop(label) => return Ok(self.end_of_round(&label, None, lines)),
            FlowStatement::Jump(condition, label) => {
                if condition != Some(0.0) {
                    return self.jump(&label, next, lines);
                }
            }
            FlowStatement::Label => {}
            FlowStatement::Sub(label) => {
                let ends = |line: &[u8], variables: &Variables| {
                    parse(line, variables) == Some(FlowStatement::EndSub(label.clone()))
                };
                match lines.find(next, |line| ends(line, &self.variables))? {
                    Some(at) => {
                        lines.pin(at);
                        lines.go_to(at + 1);
                    }
                    None => return Ok(Taken::Refused("the end of this subprogram is not in the program".to_owned())),
                }
            }
            FlowStatement::EndSub(_) | FlowStatement::Return => return Ok(self.come_back(lines)),
            FlowStatement::Call(label, times, arguments) => return self.call(label, times, arguments, next, lines),
            FlowStatement::RepeatFrom(label, times) => return self.repeat_from(label, times, place, lines),
        }
        Ok(Taken::Done)
    }

    /// Begins a construct.
    fn push(&mut self, label: Label, kind: FrameKind, place: usize) -> Taken {
        if self.frames.len() >= DEEPEST {
            return Taken::Refused("loops, conditions and calls are nested too deep".to_owned());
        }
        self.frames.push(Frame { label, kind, place });
        Taken::Done
    }

    /// Place of the end of a construct that begins before a place: of its ELSE, too, if that counts.
    fn find_end<P: TextPieces>(
        &self,
        lines: &mut Lines<P>,
        from: usize,
        label: &Label,
        or_else: bool,
    ) -> io::Result<Option<usize>> {
        let mut depth = 0_usize;
        lines.find(from, |line| {
            let Some(statement) = parse(line, &self.variables) else { return false };
            let of_label = |of: &Label| of == label;
            match &statement {
                FlowStatement::If(_, of)
                | FlowStatement::While(_, of)
                | FlowStatement::Repeat(_, of)
                | FlowStatement::For(_, _, _, of) => {
                    depth += usize::from(of_label(of));
                    false
                }
                FlowStatement::Else(of) => or_else && depth == 0 && of_label(of),
                FlowStatement::EndIf(of) | FlowStatement::EndLoop(of) if of_label(of) => {
                    let ends = depth == 0;
                    depth = depth.saturating_sub(1);
                    ends
                }
                _ => false,
            }
        })
    }

    /// Goes to the line after the end of a construct.
    fn skip_to_end<P: TextPieces>(&mut self, lines: &mut Lines<P>, from: usize, label: &Label) -> io::Result<Taken> {
        Ok(match self.find_end(lines, from, label, false)? {
            Some(at) => {
                lines.go_to(at + 1);
                Taken::Done
            }
            None => Taken::Refused("the end of this loop or condition is not in the program".to_owned()),
        })
    }

    /// The end of a loop: another round, or what follows. `again`: what its condition says, if that is at its end.
    fn end_of_round<P: TextPieces>(&mut self, label: &Label, again: Option<bool>, lines: &mut Lines<P>) -> Taken {
        let Some(frame) = self.frames.last_mut().filter(|frame| frame.label == *label) else {
            return Taken::Refused("the end of a loop that has not begun".to_owned());
        };
        let place = frame.place;
        let again = match (&mut frame.kind, again) {
            (FrameKind::Do, Some(again)) => again,
            (FrameKind::While, None) => {
                self.frames.pop();
                true
            }
            (FrameKind::Repeat(left), None) => match left.checked_sub(1) {
                Some(fewer) => {
                    *left = fewer;
                    true
                }
                None => false,
            },
            (FrameKind::For(variable, to), None) => {
                let value = self.variables.value(variable).map(|value| value + 1.0);
                let again = value.is_some_and(|value| value <= *to);
                self.variables.set(variable.clone(), value);
                again
            }
            _ => {
                return Taken::Refused("the end of a loop within another construct".to_owned());
            }
        };
        if again {
            return self.lead(lines, place);
        }
        self.frames.pop();
        Taken::Done
    }

    /// Goes to a place.
    fn lead<P: TextPieces>(&mut self, lines: &mut Lines<P>, place: usize) -> Taken {
        lines.go_to(place);
        Taken::Done
    }

    /// Place of a label, looked for from a line on and then from the first that is kept.
    fn place_of<P: TextPieces>(&self, label: &Label, from: usize, lines: &mut Lines<P>) -> io::Result<Option<usize>> {
        let form = self.form;
        let after = lines.find(from, |line| has_label(line, label, form))?;
        match after {
            Some(place) => Ok(Some(place)),
            None => Ok(lines.find_kept(|line| has_label(line, label, form))),
        }
    }

    fn jump<P: TextPieces>(&mut self, label: &Label, from: usize, lines: &mut Lines<P>) -> io::Result<Taken> {
        // A jump out of loops and conditions ends them.
        while self
            .frames
            .last()
            .is_some_and(|frame| !matches!(frame.kind, FrameKind::Call { .. } | FrameKind::Section(_)))
        {
            self.frames.pop();
        }
        Ok(match self.place_of(label, from, lines)? {
            Some(place) => self.lead(lines, place),
            None => Taken::Refused(format!(
                "the target `{}` of this jump is not in the program after its first statement",
                String::from_utf8_lossy(label)
            )),
        })
    }

    /// A subprogram of this program; a call of another is for the family.
    fn call<P: TextPieces>(
        &mut self,
        label: Label,
        times: u32,
        arguments: Option<Vec<(Variable, Value)>>,
        back: usize,
        lines: &mut Lines<P>,
    ) -> io::Result<Taken> {
        let form = self.form;
        let is_sub = |line: &[u8], variables: &Variables| match form {
            LineForm::Letters if has_label(line, &label, form) => true,
            LineForm::Letters => parse(line, variables) == Some(FlowStatement::Sub(label.clone())),
            LineForm::Keywords | LineForm::Statements => has_label(line, &label, form),
        };
        let place = match lines.find_kept(|line| is_sub(line, &self.variables)) {
            Some(place) => Some(place),
            None => lines.find(back, |line| is_sub(line, &self.variables))?,
        };
        let Some(place) = place else {
            lines.go_to(back);
            return Ok(Taken::Block);
        };
        if !self.called.contains(&label) {
            self.called.push(label.clone());
        }
        if times == 0 {
            lines.go_to(back);
            return Ok(Taken::Done);
        }
        let caller = arguments.map(|arguments| {
            let caller = self.variables.clone();
            for number in 1..=33 {
                self.variables.set(format!("#{number}").into_bytes(), None);
            }
            for (variable, value) in arguments {
                self.variables.set(variable, value);
            }
            Box::new(caller)
        });
        // A block number is that of the first block; a name is on a line of its own.
        let is_block = form == LineForm::Letters
            && !label.starts_with(b"O")
            && lines.kept(place).is_some_and(|line| parse(line, &self.variables).is_none());
        let first = place + usize::from(!is_block);
        let pushed = self.push(label, FrameKind::Call { back, left: times - 1, caller }, first);
        Ok(if pushed == Taken::Done { self.lead(lines, first) } else { pushed })
    }

    /// The end of a subprogram.
    fn come_back<P: TextPieces>(&mut self, lines: &mut Lines<P>) -> Taken {
        while let Some(frame) = self.frames.last_mut() {
            let place = frame.place;
            match &mut frame.kind {
                FrameKind::Call { back, left, caller } => {
                    if let Some(fewer) = left.checked_sub(1) {
                        *left = fewer;
                        return self.lead(lines, place);
                    }
                    let (back, caller) = (*back, caller.take());
                    self.frames.pop();
                    if let Some(caller) = caller {
                        self.variables.restore_locals(&caller);
                    }
                    return self.lead(lines, back);
                }
                _ => drop(self.frames.pop()),
            }
        }
        match self.form {
            // LBL 0 outside a subprogram is the end of a section.
            LineForm::Statements => Taken::Done,
            LineForm::Letters | LineForm::Keywords => {
                Taken::Refused("the end of a subprogram, and none has been called: the program begins again".to_owned())
            }
        }
    }

    /// `CALL LBL 1 REP 2`: the lines from the label to here, twice more.
    fn repeat_from<P: TextPieces>(
        &mut self,
        label: Label,
        times: u32,
        place: usize,
        lines: &mut Lines<P>,
    ) -> io::Result<Taken> {
        let here = |frame: &Frame| frame.place == place && matches!(frame.kind, FrameKind::Section(_));
        if !self.frames.last().is_some_and(here) {
            let pushed = self.push(label.clone(), FrameKind::Section(times), place);
            if pushed != Taken::Done {
                return Ok(pushed);
            }
        }
        let Some(Frame { kind: FrameKind::Section(left), .. }) = self.frames.last_mut() else { return Ok(Taken::Done) };
        let Some(fewer) = left.checked_sub(1) else {
            self.frames.pop();
            return Ok(Taken::Done);
        };
        *left = fewer;
        let form = self.form;
        Ok(match lines.find_kept(|line| has_label(line, &label, form)) {
            Some(start) if start < place => self.lead(lines, start + 1),
            _ => Taken::Refused("the label of this section is not before it".to_owned()),
        })
    }
}
