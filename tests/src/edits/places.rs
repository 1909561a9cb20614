//! Programs to be edited, and the state of the control at each of their lines.

use std::collections::BTreeMap;

use crate::foreign::state::{FeedMode, MotionMode, State, TipControl};
use crate::foreign::{Control, Effect, Options, Refused, Trace, run};

use super::verdict::{Allowed, name_of};

/// A program with its trace.
#[derive(Debug, Clone)]
pub struct Subject {
    /// Name for messages.
    pub name: String,
    /// How the foreign interpreter reads it.
    pub options: Options,
    /// Deviations that are not harmful for certain.
    pub allowed: Allowed,
    /// Lines, without the numbers that every line of a Heidenhain program has.
    pub lines: Vec<String>,
    /// Trace of the whole program.
    pub trace: Trace,
    /// Index of the line with the end code.
    pub end: usize,
    /// State class of each line that may be edited, by its index.
    pub classes: BTreeMap<usize, String>,
}

impl Subject {
    /// A program as it was posted.
    ///
    /// # Errors
    /// If the foreign interpreter refuses it.
    pub fn new(name: String, text: &str, mut options: Options, allowed: Allowed) -> Result<Self, Refused> {
        options.untidy = true;
        options.careless = true;
        let trace = run(text, &options)?;
        let lines = text.lines().map(|line| unnumbered(options.control, line).to_owned()).collect();
        let mut subject = Self { name, options, allowed, lines, trace, end: 0, classes: BTreeMap::new() };
        subject.classify();
        Ok(subject)
    }

    /// Text of some lines, numbered where the control wants it.
    #[must_use]
    pub fn text(&self, lines: &[String]) -> String {
        let mut text = String::new();
        let mut number = 0;
        for line in lines.iter().flat_map(|line| line.split('\n')) {
            if self.options.control == Control::Heidenhain && !line.starts_with(' ') {
                text += &format!("{number} ");
                number += 1;
            }
            text += line;
            text.push('\n');
        }
        text
    }

    /// Classes of the lines: what a block does, in which mode, and between which blocks.
    fn classify(&mut self) {
        let Some(end) = self.trace.blocks.iter().position(|block| block.effect == Effect::End) else { return };
        let last = self.trace.blocks[end].line;
        self.end = last - 1;
        let blocks = &self.trace.blocks[..=end];
        let first = blocks.first().map_or(last, |block| block.line);
        let name = |index: Option<usize>| index.and_then(|index| blocks.get(index)).map_or("-", |b| name_of(&b.effect));
        for line in first..=last {
            let text = &self.lines[line - 1];
            let Some(index) = blocks.iter().rposition(|block| block.line <= line) else { continue };
            let block = &blocks[index];
            let here = if block.line == line { name(Some(index)).to_owned() } else { continued(text) };
            let number = |word: &&str| word.strip_prefix('N').is_some_and(|digits| digits.parse::<u32>().is_ok());
            let code = text.split([' ', '(']).find(|word| !number(word)).unwrap_or_default();
            let here = if here == "modal" { code.to_owned() } else { here };
            let class =
                format!("{} {}>{here}>{}", mode(&block.state), name(index.checked_sub(1)), name(Some(index + 1)));
            self.classes.insert(line - 1, class);
        }
    }
}

/// A line that belongs to a block that began before it, or to none.
fn continued(text: &str) -> String {
    match text.trim_start().chars().next() {
        Some('(' | ';' | '*') | None => "comment".to_owned(),
        _ if text.starts_with("  ") => format!("parameter {}", text.trim_start().split('=').next().unwrap_or_default()),
        _ => "guard".to_owned(),
    }
}

fn mode(state: &State) -> String {
    let frame = match (state.tip_control, state.tilted_plane()) {
        (Some(TipControl::On { vectors: true, .. }), _) => "vectors",
        (Some(TipControl::On { .. }), _) => "tip",
        (_, Some(_)) => "plane",
        _ if state.dynamic_offset => "moved zero",
        _ => "axes",
    };
    let mut mode = frame.to_owned();
    if state.motion == Some(MotionMode::Cycle) || state.cycle.is_some() {
        mode += "+cycle";
    }
    if state.feed_mode == Some(FeedMode::InverseTime) {
        mode += "+inverse";
    }
    if !matches!(state.compensation, None | Some(crate::foreign::state::Compensation::Off)) {
        mode += "+compensation";
    }
    mode
}

/// A line without the number that every line of a Heidenhain program has.
fn unnumbered(control: Control, line: &str) -> &str {
    match line.split_once(' ') {
        Some((number, rest))
            if control == Control::Heidenhain
                && !number.is_empty()
                && number.bytes().all(|byte| byte.is_ascii_digit()) =>
        {
            rest
        }
        _ => line,
    }
}
