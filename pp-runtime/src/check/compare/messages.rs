//! Texts for the operator that the control displays: each as in the CL data, in its place among the motions.

use std::io;

use crate::diag::code::check;

use super::super::expect::legible;
use super::super::read::{Action, is_filled};
use super::phase::Phase;
use super::{Comparison, Current};

/// Text that a line displays, if it does.
fn displayed<'t>(line: &'t [u8], [before, after]: [&str; 2]) -> Option<&'t [u8]> {
    line.strip_prefix(before.as_bytes())?.strip_suffix(after.as_bytes())
}

impl Comparison<'_> {
    /// Compares the text of a line, and reports those that should have come before it.
    pub(super) fn messages(&mut self, phase: &mut Phase, current: &Current<'_>) -> io::Result<()> {
        match self.rules.facts().message.filter(|_| self.rules.policy().shop.displays_messages) {
            Some(marks) => self.compare_messages(marks, phase, current),
            None => Ok(()),
        }
    }

    /// Compares displayed texts. `marks`: before and after one.
    #[inline(never)]
    fn compare_messages(
        &mut self,
        marks: [&'static str; 2],
        phase: &mut Phase,
        current: &Current<'_>,
    ) -> io::Result<()> {
        let line = current.shown.text.trim_ascii();
        let guarded = std::mem::replace(&mut self.previous.guards, line.starts_with(b"IF "));
        if let Some(text) = displayed(line, marks).filter(|_| !guarded) {
            let text = legible(text);
            // Before its record there may be motions that need no block. A line of the shop with a field may have the
            // form of a text.
            if !self.progress.displays(&text) && {
                self.pass_needless(phase)?;
                !self.progress.displays(&text) && !self.is_of_shop(line, current)
            } {
                self.found(
                    current,
                    check::TEXT,
                    "this text is not the next one of PPRINT, or of an operation, in the CL data",
                );
            }
        }
        let ended = current.block.action == Action::End;
        while let Some(message) = self.progress.overdue_message(ended) {
            let text = String::from_utf8_lossy(&message.text);
            let text = format!("the text \"{text}\" of the CL data is not displayed before this block");
            self.tally.found(check::TEXT, message.at, current.shown, &text);
        }
        Ok(())
    }

    /// Whether a line is one of the shop.
    fn is_of_shop(&self, line: &[u8], current: &Current<'_>) -> bool {
        let policy = self.rules.policy();
        let is_tool = |called: &[u8]| {
            // In a tool change it is the tool that comes.
            let tools = [current.block.state.tool, self.tool_of_next_motion().flatten()];
            tools.into_iter().flatten().any(|number| {
                let name = policy.set_up.tools.get(&number).and_then(|tool| tool.name.as_deref());
                let names = name.map(|name| [format!("\"{name}\""), format!("=\"{name}\"")]);
                called == number.to_string().as_bytes()
                    || names.into_iter().flatten().any(|name| called == name.as_bytes())
            })
        };
        policy.shop.lines.iter().any(|own| is_filled(&own.text, line, is_tool))
    }
}
