//! Lines that the configuration brings into a program at fixed places: that none of them is lost.
//!
//! They come while the tool is away from the part, so what has come since it was there is compared where it comes back,
//! and at the end code. A line about a tool is about the tool in the spindle.

use std::collections::BTreeSet;

use super::super::policy::CheckPolicy;
use super::super::read::{OwnLine, OwnPlace, PlacedLines};
use crate::set_up::GivenTool;

/// A tool and the register of its length.
type ToolAndRegister = (Option<u32>, u32);

/// The lines that have come since the tool was at the part.
#[derive(Clone)]
pub(super) struct ShopLines {
    lines: PlacedLines,
    /// Tool of the last approach at which an operation began; `None` before the first.
    last_tool: Option<ToolAndRegister>,
    /// Tools that are measured after their change, and those that are checked for breakage when they have cut.
    measured: BTreeSet<u32>,
    checked: BTreeSet<u32>,
    /// The tool of the last approach has been at the part since blocks that may be skipped have begun or ended.
    has_cut: bool,
    /// The lines at the end of its work have come before blocks that may be skipped begin or end.
    has_ended: bool,
    /// An operation has begun and not ended.
    in_operation: bool,
    /// A record has ended it since the last approach.
    has_left: bool,
}

impl ShopLines {
    pub(super) fn new(lines: PlacedLines, policy: &CheckPolicy) -> Self {
        let dry = policy.links.dry_lift_mm.is_some();
        let tools = |wanted: fn(&GivenTool) -> bool| {
            let tools = policy.set_up.tools.iter().filter(|(_, tool)| wanted(tool) && !dry);
            tools.map(|(number, _)| *number).collect()
        };
        let (measured, checked) = (tools(|tool| tool.measured), tools(|tool| tool.checked));
        Self {
            lines,
            last_tool: None,
            measured,
            checked,
            has_cut: false,
            has_ended: false,
            in_operation: false,
            has_left: false,
        }
    }

    /// Takes a line of the program that comes with this tool in the spindle. Returns what is wrong with it.
    pub(super) fn note(&mut self, text: &[u8], tool: Option<u32>) -> Option<String> {
        if self.lines.note(text, tool) {
            return Some(format!("a line of another tool in `[tools]`, but T{} is in the spindle", tool.unwrap_or(0)));
        }
        self.lines
            .comes_too_often(text)
            .then(|| "this line of the configuration comes once more than it has to".to_owned())
    }

    /// A tool is changed, or blocks that may be skipped begin or end.
    pub(super) fn next_tool(&mut self) {
        self.lines.next_tool();
    }

    /// Whether a line of the program is one of the configuration.
    pub(super) fn has(&mut self, text: &[u8]) -> bool {
        self.lines.has(text)
    }

    /// What is wrong with the values of a line about a tool. `spindle`: tool in the spindle; `next`: register of the
    /// operation that follows.
    pub(super) fn values_fault(&self, own: &OwnLine, spindle: Option<u32>, next: Option<u32>) -> Option<String> {
        let key = own.places.first()?.key()?;
        let of_next = |place: &OwnPlace| {
            matches!(place, OwnPlace::MeasureTool | OwnPlace::ToolStart { .. } | OwnPlace::OperationStart)
        };
        let last = self.last_tool.map(|(_, register)| register);
        let registers = own.places.iter().map(|place| if of_next(place) { next } else { last });
        if let (Some(tool), Some(spindle)) = (own.values.tool, spindle)
            && tool != spindle
        {
            return Some(format!("this line of `{key}` is for T{tool}, but T{spindle} is in the spindle"));
        }
        let offset = own.values.offset?;
        let mut others = registers.flatten().filter(|register| *register != offset);
        let wrong = others.clone().count() == own.places.len();
        let register = others.next().filter(|_| wrong)?;
        Some(format!("this line of `{key}` is for length register {offset}, but that of the tool is {register}"))
    }

    /// An approach has ended: what is missing before it. `starts`: an operation begins there, with this tool and
    /// register, or goes on after a probe has measured (`goes_on`).
    pub(super) fn approach(&mut self, starts: bool, goes_on: bool, (tool, register): ToolAndRegister) -> Vec<String> {
        let mut missing = self.needless(starts, tool);
        self.has_cut = true;
        let has_ended = std::mem::take(&mut self.has_ended);
        let has_left = std::mem::take(&mut self.has_left);
        if starts {
            // What has come for the end of the one is not at the start of the other.
            let open = std::mem::replace(&mut self.in_operation, true) && !goes_on || has_left;
            let before = self.last_tool.replace((tool, register)).map(|(tool, _)| tool);
            let changes = tool.is_some() && before != Some(tool);
            let measured = changes && tool.is_some_and(|tool| self.measured.contains(&tool));
            let checked = (changes || has_ended) && self.is_checked(before);
            let ends = |of| (changes || has_ended) && before == Some(Some(of));
            missing.extend(self.missing("before this operation", |place| match place {
                OwnPlace::Start => before.is_none(),
                OwnPlace::OperationEnd => open,
                OwnPlace::ToolChange => changes,
                OwnPlace::MeasureTool => measured,
                OwnPlace::CheckTool => checked,
                OwnPlace::ToolStart { tool: of } => (changes || has_ended) && tool == Some(of),
                OwnPlace::ToolEnd { tool: of } => ends(of),
                OwnPlace::Safety | OwnPlace::MillTurn | OwnPlace::OperationStart => true,
                _ => false,
            }));
            missing.extend(self.too_often("before this operation", |place| match place {
                OwnPlace::Start => before.is_none(),
                OwnPlace::OperationEnd => open,
                OwnPlace::End => false,
                _ => true,
            }));
        }
        self.lines.forget();
        missing
    }

    /// Lines about a tool that have come since the last approach although its work has neither begun nor ended.
    fn needless(&self, starts: bool, tool: Option<u32>) -> Vec<String> {
        let before = self.last_tool.map(|(tool, _)| tool);
        let ends = |place: OwnPlace| matches!(place, OwnPlace::CheckTool | OwnPlace::ToolEnd { .. });
        let of_tool =
            |place: OwnPlace| ends(place) || matches!(place, OwnPlace::MeasureTool | OwnPlace::ToolStart { .. });
        let stays = before == Some(tool) || !starts;
        let come = match self.lines.tools() {
            0 if stays && !self.has_ended => self.lines.come_for(of_tool),
            0 | 1 if before.is_none() => self.lines.come_for(ends),
            _ => Vec::new(),
        };
        let text = |(place, text): (OwnPlace, String)| {
            format!(
                "`{text}` of `{}` comes where the work of a tool neither begins nor ends",
                place.key().unwrap_or_default()
            )
        };
        come.into_iter().map(text).collect()
    }

    /// Whether lines for the start of the work of the tool in the spindle have to come and have not.
    pub(super) fn is_tool_start_due(&self, spindle: Option<u32>) -> bool {
        let Some(number) = spindle.filter(|_| self.last_tool.map(|(tool, _)| tool) != Some(spindle)) else {
            return false;
        };
        let of_tool = |place| match place {
            OwnPlace::ToolStart { tool } => tool == number,
            OwnPlace::MeasureTool => self.measured.contains(&number),
            _ => false,
        };
        !self.lines.missing(of_tool).is_empty()
    }

    /// The machine retracts after a restart point: what is missing before it.
    pub(super) fn retract_of_start(&self) -> Vec<String> {
        self.missing("before the machine retract after the restart point", |place| place == OwnPlace::MillTurn)
    }

    /// A record that ends the operation is carried out: what is missing before it.
    pub(super) fn end_operation(&mut self) -> Vec<String> {
        match std::mem::take(&mut self.in_operation) {
            true => {
                self.has_left = true;
                self.missing("at the end of its operation", |place| place == OwnPlace::OperationEnd)
            }
            false => Vec::new(),
        }
    }

    /// What the tool that has cut lacks before a place. Whichever tool is in the spindle afterwards, it is not looked
    /// at any more.
    pub(super) fn end_tool(&mut self, before: &str) -> Vec<String> {
        let tool = self.last_tool.map(|(tool, _)| tool);
        let checked = self.is_checked(tool);
        if !std::mem::take(&mut self.has_cut) {
            return Vec::new();
        }
        self.has_ended = true;
        self.missing(before, |place| match place {
            OwnPlace::CheckTool => checked,
            OwnPlace::ToolEnd { tool: of } => tool == Some(Some(of)),
            _ => false,
        })
    }

    /// The end code: what is missing before it, and what has come too often.
    pub(super) fn end(&mut self) -> Vec<String> {
        let open = std::mem::take(&mut self.in_operation) || self.has_left;
        let tool = self.last_tool.map(|(tool, _)| tool);
        let checked = self.is_checked(tool);
        let mut wrong = self.missing("before the end code", |place| match place {
            OwnPlace::End => true,
            OwnPlace::OperationEnd => open,
            OwnPlace::CheckTool => checked,
            OwnPlace::ToolEnd { tool: of } => tool == Some(Some(of)),
            _ => false,
        });
        wrong.extend(self.too_often("before the end code", |place| match place {
            OwnPlace::Start | OwnPlace::OperationStart => tool.is_none(),
            OwnPlace::OperationEnd => open,
            _ => true,
        }));
        wrong
    }

    /// Whether blocks that measure the tool in the spindle, or look for its breakage, have not come yet and have to.
    /// `next`: tool of the next cut; `skips`: blocks that may be skipped begin or end before it.
    pub(super) fn is_measuring_due(&self, spindle: Option<u32>, next: Option<Option<u32>>, skips: bool) -> bool {
        let due = |due: OwnPlace| !self.lines.missing(|place| place == due).is_empty();
        let has_cut = self.last_tool.map(|(tool, _)| tool) == Some(spindle);
        match has_cut {
            true => (skips || next != Some(spindle)) && self.is_checked(Some(spindle)) && due(OwnPlace::CheckTool),
            false => spindle.is_some_and(|tool| self.measured.contains(&tool)) && due(OwnPlace::MeasureTool),
        }
    }

    /// Whether the blocks that look for breakage of a tool have come.
    pub(super) fn has_been_checked(&self, tool: Option<u32>) -> bool {
        self.is_checked(Some(tool)) && self.lines.missing(|place| place == OwnPlace::CheckTool).is_empty()
    }

    /// Whether a tool that has cut is checked for breakage.
    fn is_checked(&self, tool: Option<Option<u32>>) -> bool {
        tool.flatten().is_some_and(|tool| self.checked.contains(&tool))
    }

    /// What has come more often than the places at which it is due have it.
    fn too_often(&self, at: &str, due: impl Fn(OwnPlace) -> bool) -> Vec<String> {
        let lines = self.lines.too_often_for(due).into_iter();
        lines.map(|text| format!("`{text}` comes once more than it has to {at}")).collect()
    }

    fn missing(&self, at: &str, needed: impl Fn(OwnPlace) -> bool) -> Vec<String> {
        let missing = self.lines.missing(needed);
        missing
            .into_iter()
            .map(|(place, text)| format!("`{text}` of `{}` is missing {at}", place.key().unwrap_or_default()))
            .collect()
    }
}
