//! Edits of a program that are meant: `[[check.edits]]`.
//!
//! A program is compared as it was posted: each edit is taken back first. Then both programs are read side by side, and
//! each difference between them must be of a permitted kind: F, S, coolant, a longer wait, an added stop, a smaller
//! peck. A modal word reaches as far as it does at the control.

use std::io;

use crate::diag::code::check;

use super::policy::{EditPolicy, EditedBlock, MeantEdit};
use super::read::{Action, Block, CycleKind, CycleMove, Family, FeedMode, Reader, State, Vocabulary};
use super::report::{Outcome, PermittedEdit};

/// A program as it was posted.
pub(super) struct PostedProgram {
    /// Its text.
    pub(crate) text: Vec<u8>,
    permitted: Vec<PermittedEdit>,
    faults: Vec<EditFault>,
}

/// What is wrong with an edit, at its line.
struct EditFault {
    line: u64,
    block: Vec<u8>,
    text: String,
}

/// Takes the edits of a program back.
pub(super) fn take_back(program: &[u8], policy: &EditPolicy, family: Family) -> PostedProgram {
    let mut lines: Vec<Vec<u8>> = program.split(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    let (mut permitted, mut faults) = (Vec::new(), Vec::new());
    for edit in &policy.edits {
        match undo(edit, &mut lines, family) {
            Ok(Some((line, block))) => permitted.push(PermittedEdit {
                line,
                block: String::from_utf8_lossy(block.trim_ascii()).into_owned(),
                old: edit.old.clone(),
                new: edit.new.clone(),
                reason: edit.reason.clone(),
            }),
            // It has not been made.
            Ok(None) => {}
            Err((line, text)) => faults.push(EditFault { line, block: Vec::new(), text }),
        }
    }
    PostedProgram { text: lines.join(&b'\n'), permitted, faults }
}

impl PostedProgram {
    /// Compares the program with what was posted, and adds the edits and what is wrong with them to the outcome of its
    /// check.
    pub(super) fn conclude(
        mut self,
        edited: &[u8],
        vocabulary: &Vocabulary,
        policy: &EditPolicy,
        outcome: &mut Outcome,
    ) -> io::Result<()> {
        let mut differences = Differences { policy, stops: false, judged: None, faults: Vec::new() };
        differences.find(edited, &self.text, vocabulary)?;
        self.faults.append(&mut differences.faults);
        for EditFault { line, block, text } in self.faults {
            outcome.add(check::EDIT, line, &block, &text);
        }
        outcome.permitted = self.permitted;
        Ok(())
    }
}

/// Number and text of a line.
type Numbered = (u64, Vec<u8>);

/// What is wrong at a line.
type AtLine = (u64, String);

/// Takes one edit back. Returns the number and the text of its line; `None` where the block is as posted.
fn undo(edit: &MeantEdit, lines: &mut [Vec<u8>], family: Family) -> Result<Option<Numbered>, AtLine> {
    let (first, last) = match edit.block {
        EditedBlock::Line(line) => {
            let index = usize::try_from(line).ok().and_then(|line| line.checked_sub(1));
            let index = index.filter(|index| *index < lines.len());
            let index = index
                .ok_or_else(|| (line, format!("the program has no line {line}, which `[[check.edits]]` names")))?;
            (index, index + 1)
        }
        EditedBlock::Number(number) => block_of(number, lines, family)?,
    };
    let named = first as u64 + 1;
    let found: Vec<(usize, usize)> =
        (first..last).flat_map(|line| places(&lines[line], edit.new.as_bytes()).map(move |at| (line, at))).collect();
    let has_old =
        !edit.old.is_empty() && (first..last).any(|line| places(&lines[line], edit.old.as_bytes()).count() > 0);
    let (line, at) = match (found.as_slice(), edit.new.is_empty()) {
        ([_, _, ..], false) => {
            return Err((named, format!("`{}` of `[[check.edits]]` is more than once in this block", edit.new)));
        }
        (_, _) if has_old && (found.is_empty() || edit.new.is_empty()) => return Ok(None),
        ([one], false) => *one,
        (_, true) => (first, lines[first].trim_ascii_end().len()),
        ([], false) if edit.old.is_empty() => return Ok(None),
        ([], false) => {
            let text = format!("neither `{}` nor `{}` of `[[check.edits]]` is in this block", edit.new, edit.old);
            return Err((named, text));
        }
    };
    let text = &mut lines[line];
    let edited = text.clone();
    match edit.new.is_empty() {
        true => {
            text.splice(at..at, [b" ", edit.old.as_bytes()].concat());
        }
        false => {
            text.splice(at..at + edit.new.len(), edit.old.bytes());
        }
    }
    if edit.old.is_empty() && is_number_alone(text) {
        // A block that was added: its number may have been given by the editor.
        match family {
            Family::Heidenhain => text.extend_from_slice(b" ;"),
            _ => text.clear(),
        }
    }
    Ok(Some((line as u64 + 1, edited)))
}

/// Places of a text in a line, where it ends with a word.
fn places<'l>(line: &'l [u8], text: &'l [u8]) -> impl Iterator<Item = usize> + 'l {
    let found = memchr::memmem::find_iter(line, text);
    found.filter(move |at| {
        let next = line.get(at + text.len());
        let begins = *at == 0 || !text[0].is_ascii_alphanumeric() || !line[at - 1].is_ascii_alphabetic();
        !text.is_empty() && begins && next.is_none_or(|next| !next.is_ascii_digit() && *next != b'.')
    })
}

/// Whether nothing is left of a line but its number.
fn is_number_alone(line: &[u8]) -> bool {
    line.trim_ascii().iter().all(|byte| byte.is_ascii_digit() || matches!(byte, b'N' | b'n'))
}

/// The first line of the block with a number, and the line after its last.
fn block_of(number: u64, lines: &[Vec<u8>], family: Family) -> Result<(usize, usize), AtLine> {
    let of_line = |line: &Vec<u8>| number_of(line, family);
    let mut found = (0..lines.len()).filter(|index| of_line(&lines[*index]) == Some(number));
    let first =
        found.next().ok_or_else(|| (1, format!("the program has no block {number}, which `[[check.edits]]` names")))?;
    if let Some(second) = found.next() {
        let text = format!(
            "lines {} and {} both have block number {number}, which `[[check.edits]]` names",
            first + 1,
            second + 1
        );
        return Err((second as u64 + 1, text));
    }
    let last = match family {
        // Lines of a cycle that goes on have no number.
        Family::Heidenhain => (first + 1..lines.len()).find(|index| of_line(&lines[*index]).is_some()),
        _ => None,
    };
    Ok((first, last.unwrap_or(first + 1)))
}

/// Block number of a line.
fn number_of(line: &[u8], family: Family) -> Option<u64> {
    let text = line.trim_ascii_start();
    let text = text.strip_prefix(b"/").unwrap_or(text).trim_ascii_start();
    let digits = match family {
        Family::Heidenhain => text,
        _ => text.strip_prefix(b"N").or_else(|| text.strip_prefix(b"n"))?,
    };
    let count = digits.iter().take_while(|byte| byte.is_ascii_digit()).count();
    std::str::from_utf8(&digits[..count]).ok()?.parse().ok()
}

/// Differences between two programs.
struct Differences<'p> {
    policy: &'p EditPolicy,
    /// A stop has been added.
    stops: bool,
    /// F and S, edited and posted, that have been judged.
    judged: Option<[Option<f64>; 4]>,
    faults: Vec<EditFault>,
}

impl Differences<'_> {
    fn find(&mut self, edited: &[u8], posted: &[u8], vocabulary: &Vocabulary) -> io::Result<()> {
        let mut edited = Reader::new(edited, vocabulary.clone());
        let mut posted = Reader::new(posted, vocabulary.clone());
        let mut last = State::default();
        let mut of_edited = edited.next_block()?;
        while let Some((new, text)) = of_edited {
            let Some((old, _)) = posted.next_block()? else {
                self.added(new, text, &last);
                of_edited = edited.next_block()?;
                continue;
            };
            let (mut new, mut text) = (new, text);
            while new.line < old.line {
                self.added(new, text, &last);
                match edited.next_block()? {
                    Some(next) => (new, text) = next,
                    None => return Ok(()),
                }
            }
            self.compare(new, old, text);
            last = old.state;
            of_edited = edited.next_block()?;
        }
        Ok(())
    }

    fn fault(&mut self, block: &Block, text: &[u8], what: &str) {
        self.faults.push(EditFault {
            line: block.line,
            block: text.to_vec(),
            text: format!("no edit of this kind is permitted: {what}"),
        });
    }

    /// A block that has no counterpart: a stop.
    fn added(&mut self, block: &Block, text: &[u8], before: &State) {
        let stops = matches!(block.action, Action::Stop | Action::OptionalStop);
        if !stops || as_posted(block.state, before) != *before || !block.faults.is_empty() {
            self.fault(block, text, "of blocks M0 and M1 alone can be added");
        }
        self.stops = true;
    }

    /// A block and the same as posted.
    fn compare(&mut self, new: &Block, old: &Block, text: &[u8]) {
        if new == old {
            return;
        }
        let mut plain = new.clone();
        plain.state = as_posted(new.state, &old.state);
        (plain.early, plain.stated, plain.only_moves) = (old.early.clone(), old.stated, old.only_moves);
        if self.stops {
            // At a stop the operator may move the axes; whoever adds one comes back.
            (plain.known, plain.known_before) = (old.known, old.known_before);
        }
        plain.action = match (&new.action, &old.action) {
            (Action::Dwell(longer), Action::Dwell(shorter)) if longer >= shorter => old.action,
            (Action::Cycle(new), Action::Cycle(old)) => Action::Cycle(CycleMove {
                dwell: if new.dwell >= old.dwell { old.dwell } else { new.dwell },
                kind: smaller_peck(new.kind, old.kind),
                feed: if self.is_slower(new.feed, old.feed) { old.feed } else { new.feed },
                ..*new
            }),
            _ => new.action,
        };
        if plain != *old {
            self.fault(new, text, "more changes than F, S, coolant, a longer wait, an added stop or a smaller peck");
            return;
        }
        let values = [new.state.feed, old.state.feed, new.state.speed, old.state.speed];
        let differs = |new: Option<f64>, old: Option<f64>| new != old;
        let (feed, speed) = (differs(values[0], values[1]), differs(values[2], values[3]));
        // The pitch of a thread that F and S make is part of its kind.
        if feed && new.action.cuts() && new.state.feed_mode == Some(FeedMode::InverseTime) {
            self.fault(new, text, "F in inverse time is no feed");
        } else if self.judged.replace(values) != Some(values) {
            if feed && !self.is_slower(values[0], values[1]) {
                self.fault(new, text, "a larger F, beyond `check.feed_factor`");
            }
            if speed && !self.is_near(values[2], values[3]) {
                self.fault(new, text, "another S, beyond `check.speed_factor`");
            }
        }
    }

    /// Whether an F is not larger than the other one, but for the stated factor.
    fn is_slower(&self, new: Option<f64>, old: Option<f64>) -> bool {
        match (new, old) {
            (Some(new), Some(old)) => new > 0.0 && new <= old * self.policy.feed_factor.unwrap_or(1.0).max(1.0),
            (new, old) => new == old,
        }
    }

    /// Whether an S is within the stated factor of the other one.
    fn is_near(&self, new: Option<f64>, old: Option<f64>) -> bool {
        let factor = self.policy.speed_factor.unwrap_or(1.0).max(1.0);
        new.zip(old).is_some_and(|(new, old)| new > 0.0 && new <= old * factor && old <= new * factor)
    }
}

/// A state with F, S and coolant of another.
fn as_posted(state: State, old: &State) -> State {
    State { feed: old.feed, speed: old.speed, coolant: old.coolant, ..state }
}

/// The kind of a hole, as posted where the edit makes its steps smaller.
fn smaller_peck(new: CycleKind, old: CycleKind) -> CycleKind {
    match (new, old) {
        (CycleKind::Peck(step), CycleKind::Peck(posted))
        | (CycleKind::ChipBreak(step), CycleKind::ChipBreak(posted))
            if step > 0.0 && step <= posted =>
        {
            old
        }
        _ => new,
    }
}
