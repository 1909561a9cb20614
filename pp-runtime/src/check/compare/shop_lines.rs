//! Lines that the configuration brings into a program at fixed places: that none of them is lost.
//!
//! They come while the tool is away from the part, so what has come since it was there is compared where it comes back, and
//! at the end code.

use super::super::read::{OwnPlace, PlacedLines};

/// The lines that have come since the tool was at the part.
pub(super) struct ShopLines {
    lines: PlacedLines,
    /// Tool of the last approach at which an operation began; `None` before the first.
    last_tool: Option<Option<u32>>,
}

impl ShopLines {
    pub(super) fn new(lines: PlacedLines) -> Self {
        Self { lines, last_tool: None }
    }

    /// Takes a line of the program.
    pub(super) fn note(&mut self, text: &[u8]) {
        self.lines.note(text);
    }

    /// An approach has ended: what is missing before it. `starts`: an operation begins there, with this tool.
    pub(super) fn approach(&mut self, starts: bool, tool: Option<u32>) -> Vec<String> {
        let mut missing = Vec::new();
        if starts {
            let before = self.last_tool.replace(tool);
            let changes = tool.is_some() && before != Some(tool);
            missing = self.missing("before this operation", |place| match place {
                OwnPlace::Start => before.is_none(),
                OwnPlace::OperationEnd => before.is_some(),
                OwnPlace::ToolChange => changes,
                OwnPlace::Safety | OwnPlace::OperationStart => true,
                _ => false,
            });
        }
        self.lines.forget();
        missing
    }

    /// The end code: what is missing before it.
    pub(super) fn end(&mut self) -> Vec<String> {
        let began = self.last_tool.is_some();
        self.missing("before the end code", |place| match place {
            OwnPlace::End => true,
            OwnPlace::OperationEnd => began,
            _ => false,
        })
    }

    fn missing(&self, at: &str, needed: impl Fn(OwnPlace) -> bool) -> Vec<String> {
        let missing = self.lines.missing(needed);
        missing
            .into_iter()
            .map(|(place, text)| format!("`{text}` of `{}` is missing {at}", place.key().unwrap_or_default()))
            .collect()
    }
}
