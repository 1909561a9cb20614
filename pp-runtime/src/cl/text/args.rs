//! The arguments of a record: words and numbers between commas.
//!
//! [`Args`] returns them from left to right, and names their major word in messages. An empty place between commas is
//! an error unless the argument has no effect, and so is an argument that the record does not take: see
//! [`Args::finish`].

use super::blanks::{is_blank, skip_blanks};
use super::fault::{ClFault, Span, quoted};
use super::number::{number_at_start, whole_number};
use crate::diag::code::cl;

/// One argument without the blanks around it; never empty.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arg<'a> {
    pub(crate) text: &'a [u8],
    pub(crate) at: Span,
}

impl Arg<'_> {
    pub(crate) fn is(self, word: &str) -> bool {
        self.text.eq_ignore_ascii_case(word.as_bytes())
    }

    /// Returns the value of this word in a table of words.
    pub(crate) fn among<T: Copy>(self, table: &[(&str, T)]) -> Option<T> {
        table.iter().find(|(word, _)| self.is(word)).map(|(_, found)| *found)
    }

    /// Whether the argument begins like a number; then it must be one.
    pub(crate) fn looks_numeric(self) -> bool {
        matches!(self.text[0], b'0'..=b'9' | b'+' | b'-' | b'.')
    }

    /// Returns the argument as a finite number.
    pub(crate) fn number(self) -> Result<f64, ClFault> {
        match whole_number(self.text) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(cl::NUMBER.cl_fault(
                "number too large",
                self.at,
                format!("{} is beyond the range of numbers", quoted(self.text)),
                "check the exponent of this number",
            )),
            None => Err(self.not_a_number()),
        }
    }

    /// Returns the argument as a whole number, 0 or more: the number of a tool or register.
    pub(crate) fn integer(self) -> Result<u32, ClFault> {
        let value = self.number()?;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // In range, and checked to be whole.
        if (0.0..=f64::from(u32::MAX)).contains(&value) && value.fract().abs() < f64::MIN_POSITIVE {
            Ok(value as u32)
        } else {
            Err(cl::NUMBER.cl_fault(
                "whole number",
                self.at,
                format!("{} must be a whole number, 0 or more", quoted(self.text)),
                "write a tool or register number without decimals: LOADTL/12",
            ))
        }
    }

    #[cold]
    fn not_a_number(self) -> ClFault {
        if self.text.contains(&b'/') {
            return cl::SYNTAX.cl_fault(
                "second slash",
                self.at,
                "this argument contains a second slash",
                "separate arguments by commas; only GOTO takes a list of points with slashes between them",
            );
        }
        if self.text.contains(&b'$') {
            return cl::SYNTAX.cl_fault(
                "stray $",
                self.at,
                format!("`$` inside a statement: {}", quoted(self.text)),
                "at the end of a line `$` continues the statement, `$$` begins a comment",
            );
        }
        let glued = number_at_start(self.text).is_some_and(|(_, used)| used > 0);
        let help = if glued {
            "a number ends at a comma: is a comma missing?"
        } else {
            "write numbers as 12, -0.5, .5 or 1.5E-3"
        };
        cl::NUMBER.cl_fault("number expected", self.at, format!("{} is not a number", quoted(self.text)), help)
    }
}

/// A major word of CL data and the forms of its arguments that are read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MajorWord {
    pub(crate) name: &'static str,
    /// Forms of the arguments, as `explain --cl` prints them after the word.
    pub(crate) forms: &'static str,
}

impl MajorWord {
    /// Help for a message: the forms that are read.
    fn help(&self) -> String {
        let Self { name, forms } = self;
        if forms.trim_start().starts_with(['/', '[']) {
            format!("accepted: {name}{forms}")
        } else {
            format!("write {name} alone: it has no arguments")
        }
    }
}

/// The arguments of a record, taken from left to right.
#[derive(Debug, Clone)]
pub(crate) struct Args<'a> {
    word: &'static MajorWord,
    text: &'a [u8],
    at: usize,
    /// A comma was read, or arguments begin: another argument must follow.
    more: bool,
    first: usize,
}

impl<'a> Args<'a> {
    /// Arguments from byte `at` of the statement on; none if only blanks follow.
    pub(crate) fn new(word: &'static MajorWord, text: &'a [u8], at: usize) -> Self {
        let at = skip_blanks(text, at.min(text.len()));
        Args { word, text, at, more: at < text.len(), first: at }
    }

    /// Arguments after the slash that follows the major word, which ends at byte `word_end`; none if the statement ends
    /// with the word.
    #[inline]
    pub(crate) fn after_slash(word: &'static MajorWord, text: &'a [u8], word_end: usize) -> Result<Self, ClFault> {
        let slash = skip_blanks(text, word_end);
        match text.get(slash) {
            None => Ok(Args::new(word, text, text.len())),
            Some(b'/') => Ok(Args::new(word, text, slash + 1)),
            Some(_) => Err(slash_expected(word, text, slash)),
        }
    }

    /// Name of the major word.
    pub(crate) fn name(&self) -> &'static str {
        self.word.name
    }

    /// Bytes of the statement up to the last argument.
    pub(crate) fn text(&self) -> &'a [u8] {
        self.text
    }

    /// Index of the byte of the statement at which the next argument begins.
    pub(crate) fn position(&self) -> usize {
        self.at
    }

    /// Arguments in the bytes `start` to `end` of the statement; messages still name places in the whole statement.
    pub(crate) fn part(&self, start: usize, end: usize) -> Args<'a> {
        Args::new(self.word, &self.text[..end], start)
    }

    /// Passes over the arguments that are left; the caller reads their bytes itself.
    pub(crate) fn skip_rest(&mut self) {
        self.more = false;
    }

    /// Refuses an argument that the record has not taken.
    pub(crate) fn finish(&mut self) -> Result<(), ClFault> {
        match self.next()? {
            None => Ok(()),
            Some(arg) => Err(self.not_understood(arg)),
        }
    }

    /// Takes the next argument; refuses the record if there is none.
    pub(crate) fn needed(&mut self) -> Result<Arg<'a>, ClFault> {
        let name = self.name();
        self.next()?.ok_or_else(|| {
            cl::SYNTAX.cl_fault(
                "argument missing",
                self.all(),
                format!("an argument of {name} is missing"),
                self.word.help(),
            )
        })
    }

    /// Takes the next argument, which must be the number that belongs to `word`.
    pub(crate) fn number_after(&mut self, word: Arg<'_>) -> Result<Arg<'a>, ClFault> {
        let found = self.next()?;
        if let Some(number) = found.filter(|arg| arg.looks_numeric()) {
            return Ok(number);
        }
        let found = found.map_or_else(String::new, |arg| format!(", {} follows", quoted(arg.text)));
        Err(cl::NUMBER.cl_fault(
            "number expected",
            word.at,
            format!("{} has no number after it{found}", quoted(word.text)),
            format!("write the word with its number: {},12", String::from_utf8_lossy(word.text)),
        ))
    }

    /// Takes the next argument, which must be this word.
    pub(crate) fn keyword(&mut self, word: &str) -> Result<(), ClFault> {
        let arg = self.needed()?;
        if arg.is(word) { Ok(()) } else { Err(self.not_understood(arg)) }
    }

    /// Takes the next argument, which must be a word of `table`, and returns its value.
    pub(crate) fn one_of<T: Copy>(&mut self, table: &[(&str, T)]) -> Result<T, ClFault> {
        let arg = self.needed()?;
        arg.among(table).ok_or_else(|| self.not_understood(arg))
    }

    /// Takes the remaining arguments, which must be exactly `N` numbers.
    pub(crate) fn exactly<const N: usize>(&mut self) -> Result<[f64; N], ClFault> {
        let mut numbers = [0.0; N];
        match self.numbers(&mut numbers)? {
            found if found == N => Ok(numbers),
            found => Err(self.wrong_count(&format!("{N} numbers"), found)),
        }
    }

    /// Fault: the record has a wrong number of arguments.
    #[cold]
    pub(crate) fn wrong_count(&self, needs: &str, found: usize) -> ClFault {
        cl::SYNTAX.cl_fault(
            "wrong number of arguments",
            self.all(),
            format!("{} needs {needs}, found {found}", self.name()),
            "check the count of numbers; a record that continues on the next line ends in `$`",
        )
    }

    /// Fault: an argument that this reader does not understand.
    pub(crate) fn not_understood(&self, arg: Arg<'_>) -> ClFault {
        cl::UNSUPPORTED.cl_fault(
            self.name(),
            arg.at,
            format!("{} with {} is not supported", self.name(), quoted(arg.text)),
            self.word.help(),
        )
    }

    /// Place of all arguments, for messages; the whole statement if there are none.
    pub(crate) fn all(&self) -> Span {
        let start = if self.first < self.text.len() { self.first } else { 0 };
        Span { start, end: self.text.len() }
    }

    /// Takes the next argument, if there is one; an empty place between commas is a fault.
    pub(crate) fn next(&mut self) -> Result<Option<Arg<'a>>, ClFault> {
        let start = skip_blanks(self.text, self.at);
        match self.next_place() {
            None => Ok(None),
            Some(None) => Err(self.empty_place(start)),
            Some(found) => Ok(found),
        }
    }

    /// Takes the next place between commas, if there is one, with its argument; an empty place has none. For arguments
    /// without effect, which may be left out.
    pub(crate) fn next_place(&mut self) -> Option<Option<Arg<'a>>> {
        if !self.more {
            return None;
        }
        let start = skip_blanks(self.text, self.at);
        let end = memchr::memchr(b',', &self.text[start..]).map_or(self.text.len(), |found| start + found);
        let trimmed = end - self.text[start..end].iter().rev().take_while(|byte| is_blank(**byte)).count();
        self.more = end < self.text.len();
        self.at = end + 1;
        let arg = Arg { text: &self.text[start..trimmed], at: Span { start, end: trimmed } };
        Some((trimmed > start).then_some(arg))
    }

    /// Takes the remaining arguments, which must be numbers without effect; a place may be empty. Returns their count.
    pub(crate) fn numbers_without_effect(&mut self) -> Result<usize, ClFault> {
        let mut count = 0;
        while let Some(place) = self.next_place() {
            if let Some(arg) = place {
                arg.number()?;
            }
            count += 1;
        }
        Ok(count)
    }

    /// Takes up to `N` numbers from the left, and returns them with their count.
    pub(crate) fn first_numbers<const N: usize>(&mut self) -> Result<([f64; N], usize), ClFault> {
        let mut numbers = [0.0; N];
        for (count, place) in numbers.iter_mut().enumerate() {
            match self.next()? {
                Some(arg) => *place = arg.number()?,
                None => return Ok((numbers, count)),
            }
        }
        Ok((numbers, N))
    }

    /// Takes all remaining arguments as numbers and returns their count. Numbers beyond the size of `into` are only
    /// checked and counted.
    pub(crate) fn numbers(&mut self, into: &mut [f64]) -> Result<usize, ClFault> {
        let mut count = self.plain_numbers(into);
        // Anything else is read for its message.
        while let Some(arg) = self.next()? {
            arg.number()?;
            count += 1;
        }
        Ok(count)
    }

    /// Takes arguments from the left as long as they are finite numbers, each in one pass, and returns their count.
    /// Numbers beyond the size of `into` are only counted.
    pub(crate) fn plain_numbers(&mut self, into: &mut [f64]) -> usize {
        let mut count = 0;
        while self.more {
            let start = skip_blanks(self.text, self.at);
            let Some((value, used)) = number_at_start(&self.text[start..]).filter(|(value, _)| value.is_finite())
            else {
                break;
            };
            let end = skip_blanks(self.text, start + used);
            match self.text.get(end) {
                Some(b',') => self.at = end + 1,
                None => self.more = false,
                Some(_) => break,
            }
            if let Some(place) = into.get_mut(count) {
                *place = value;
            }
            count += 1;
        }
        count
    }

    #[cold]
    fn empty_place(&self, at: usize) -> ClFault {
        let start = at.min(self.text.len() - 1);
        cl::SYNTAX.cl_fault(
            "empty argument",
            Span { start, end: start + 1 },
            "an argument is missing at this comma",
            "write the missing argument, or delete the comma",
        )
    }
}

#[cold]
fn slash_expected(word: &MajorWord, text: &[u8], at: usize) -> ClFault {
    let name = word.name;
    cl::SYNTAX.cl_fault(
        "slash expected",
        Span { start: at, end: text.len() },
        format!("expected a slash after {name}, found {}", quoted(&text[at..])),
        format!("write {name}/.."),
    )
}

/// Returns `piece` without the blanks around it.
pub(crate) fn trimmed(piece: &[u8]) -> &[u8] {
    let start = skip_blanks(piece, 0);
    let after = piece[start..].iter().rev().take_while(|byte| is_blank(**byte)).count();
    &piece[start..piece.len() - after]
}
