//! States of controls on which the meaning of words depends: what a program before, a screen, the operator or the
//! machine builder may have left, and how programs deal with each.
//!
//! One row is one state. Of the four ways the first that is possible is taken: the word itself has the state; the
//! program sets it at each restart point; a guard of the program compares it and stops; the header and the set-up sheet
//! state it as a condition. A row of a later way has the reason why those before it are not possible. The check has
//! rows of its own, of what must be ended before a motion (`check/read/facts`), and a test compares them with these.

mod fanuc;
mod haas;
mod heidenhain;
mod linuxcnc;
mod siemens;
#[cfg(test)]
mod tests;

use std::io::{self, Write};

use super::dialects::{Control, ControlFunction, Spellings};
use super::layout::FramesUsed;
use super::options::ControlOptions;
use super::state_values::ControlState;

/// A state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StateRow {
    /// Name on the control: codes, variables, parameters, settings.
    pub(crate) name: &'static str,
    /// What it changes.
    changes: &'static str,
    by: StateHandling,
    /// Why not by a way before it.
    reason: &'static str,
    /// Manual and page, or a public post; empty where it is from memory.
    source: &'static str,
    /// Programs on which it has an effect.
    of: StateUse,
}

/// How programs deal with a state.
#[derive(Debug, Clone, Copy)]
pub(crate) enum StateHandling {
    /// The word itself has it.
    InWord(&'static str),
    /// The safety blocks set it, by this code.
    Set(&'static str),
    /// The safety blocks set it where the control has the function; elsewhere it is a condition.
    SetWhere(ControlFunction, &'static str),
    /// A guard compares it, by this; without the guard it is a condition.
    Compared(&'static str, &'static str),
    /// It is a condition, as the header states it.
    Stated(&'static str),
    /// It is a condition, unless an option has it settled.
    StatedUnless(Settled, &'static str),
    /// It is a condition that is part of a line that the header has of its own.
    Noted(fn(&Spellings) -> &'static str),
}

/// What an option may have settled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Settled {
    /// Words of X are radii.
    RadiusWords,
    /// The spindle of the tool is named.
    ToolSpindle,
    /// The axes of a rapid need not arrive together.
    LooseRapids,
    /// Whether they do is stated.
    StatedRapids,
}

impl Settled {
    fn is_by(self, options: &ControlOptions) -> bool {
        match self {
            Self::RadiusWords => options.mill_turn.as_ref().is_some_and(|mill_turn| mill_turn.radius.is_some()),
            Self::ToolSpindle => options.tool_spindle().is_some(),
            Self::LooseRapids => options.linear_rapids != Some(true),
            Self::StatedRapids => options.linear_rapids.is_some(),
        }
    }

    /// The key that leaves it open.
    const fn key(self) -> &'static str {
        match self {
            Self::RadiusWords | Self::ToolSpindle => "without `control.mill_turn`",
            Self::LooseRapids => "where `control.linear_rapids` is true",
            Self::StatedRapids => "without `control.linear_rapids`",
        }
    }
}

/// Programs on which a state has an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StateUse {
    Every,
    /// Rotary axes move.
    Rotary,
    TipControl,
    Planes,
    /// The control computes with the centres of the rotary axes: tip control, planes, a dynamic work offset.
    Kinematics,
    /// With cutter compensation.
    Compensation,
    /// With canned cycles of the control.
    Cycles,
}

/// What of a program decides which states have an effect.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ProgramUses {
    pub(crate) rotary: bool,
    pub(crate) frames: FramesUsed,
    pub(crate) compensation: bool,
    pub(crate) cycles: bool,
    /// Guards compare what lies over the work offset.
    pub(crate) offset_guard: bool,
    /// Guards compare the lengths of tools.
    pub(crate) length_guard: bool,
}

impl ProgramUses {
    fn has(&self, of: StateUse) -> bool {
        match of {
            StateUse::Every => true,
            StateUse::Rotary => self.rotary,
            StateUse::TipControl => self.frames.tip_control,
            StateUse::Planes => self.frames.planes,
            StateUse::Kinematics => self.frames != FramesUsed::default(),
            StateUse::Compensation => self.compensation,
            StateUse::Cycles => self.cycles,
        }
    }
}

const fn state(
    name: &'static str,
    changes: &'static str,
    by: StateHandling,
    of: StateUse,
    source: &'static str,
) -> StateRow {
    StateRow { name, changes, by, reason: "", source, of }
}

impl StateRow {
    /// Why the ways before are not possible.
    const fn because(self, reason: &'static str) -> Self {
        Self { reason, ..self }
    }

    /// The condition on the machine of a program, where it is one.
    fn condition(&self, codes: &Spellings, options: &ControlOptions, uses: &ProgramUses) -> Option<&'static str> {
        if !uses.has(self.of) {
            return None;
        }
        match self.by {
            StateHandling::Stated(condition) => Some(condition),
            StateHandling::StatedUnless(settled, condition) => (!settled.is_by(options)).then_some(condition),
            StateHandling::SetWhere(function, _) => (!ends(function, codes, options, uses)).then_some(self.name),
            StateHandling::Compared(LENGTH, condition) => (!uses.length_guard).then_some(condition),
            StateHandling::Compared(_, condition) => (!uses.offset_guard).then_some(condition),
            StateHandling::InWord(_) | StateHandling::Set(_) | StateHandling::Noted(_) => None,
        }
    }
}

/// Whether a program ends a function at each restart point.
fn ends(function: ControlFunction, codes: &Spellings, options: &ControlOptions, uses: &ProgramUses) -> bool {
    let functions = options.functions.as_deref();
    let used = match function {
        ControlFunction::TipControl => uses.frames.tip_control,
        ControlFunction::Planes => uses.frames.planes,
        ControlFunction::DynamicOffset => uses.frames.dynamic_offset,
        _ => false,
    };
    match codes.cancels.iter().find(|cancel| cancel.of == function) {
        Some(cancel) => cancel.is_due(functions),
        None => used || functions.is_some_and(|listed| listed.contains(&function)),
    }
}

/// What the guards of tool lengths compare.
const LENGTH: &str = "the length of the tool";

/// The states of a control.
pub(crate) fn of(family: &str) -> &'static [StateRow] {
    match family {
        "linuxcnc" => linuxcnc::STATES,
        "fanuc" => fanuc::STATES,
        "haas" => haas::STATES,
        "siemens" => siemens::STATES,
        "heidenhain" => heidenhain::STATES,
        _ => &[],
    }
}

/// Conditions that a program needs of the machine, one sentence each.
pub(crate) fn conditions(control: &dyn Control, options: &ControlOptions, uses: &ProgramUses) -> Vec<String> {
    let own_safety = options.safety.is_some();
    let mut list = Vec::new();
    let mut absent = Vec::new();
    for row in of(control.family()) {
        let Some(condition) = row.condition(control.spellings(), options, uses) else { continue };
        match row.by {
            StateHandling::SetWhere(..) => absent.push(condition),
            _ => list.push(condition.to_owned()),
        }
    }
    if !absent.is_empty() {
        list.push(format!(
            "off at the start, or not installed (`control.functions` has them ended): {}",
            absent.join(", ")
        ));
    }
    if own_safety {
        let set = of(control.family()).iter().filter_map(|row| match row.by {
            StateHandling::Set(code) if uses.has(row.of) => Some(code),
            _ => None,
        });
        let codes: Vec<&str> = set.collect();
        list.push(format!("`control.safety` of the shop sets what {} set elsewhere", codes.join(", ")));
    }
    list
}

/// Writes the states of a control as a table, and how many of them are from memory.
pub(crate) fn write_table(control: &dyn Control, out: &mut dyn Write) -> io::Result<()> {
    let rows = of(control.family());
    writeln!(
        out,
        "States of {} that change the meaning of words, and how programs deal with them",
        control.spellings().title
    )?;
    for (title, is_of) in WAYS {
        let mut of_way = rows.iter().filter(|row| is_of(&row.by)).peekable();
        if of_way.peek().is_none() {
            continue;
        }
        writeln!(out, "\n{title}")?;
        for row in of_way {
            let what = match row.by {
                StateHandling::InWord(text) | StateHandling::Set(text) | StateHandling::Stated(text) => text.to_owned(),
                StateHandling::StatedUnless(settled, text) => format!("{}: {text}", settled.key()),
                StateHandling::SetWhere(function, code) => {
                    let usual = control.spellings().cancels.iter().any(|cancel| cancel.of == function && cancel.usual);
                    let listed = match usual {
                        true => "unless `control.functions` is given without",
                        false => "where `control.functions` has",
                    };
                    format!("{code}, {listed} \"{}\"", function.name())
                }
                StateHandling::Compared(what, otherwise) => format!("{what}; without the guard: {otherwise}"),
                StateHandling::Noted(text) => text(control.spellings()).to_owned(),
            };
            writeln!(out, "  {}: {}", row.name, row.changes)?;
            writeln!(out, "      {what}")?;
            if !row.reason.is_empty() {
                writeln!(out, "      because {}", row.reason)?;
            }
            writeln!(out, "      [{}]", if row.source.is_empty() { "from memory" } else { row.source })?;
        }
    }
    let mut settings = ControlState::of(control.spellings().name).peekable();
    if settings.peek().is_some() {
        writeln!(out, "\nStated in header and sheet with the value of `[control.states]`")?;
        settings.try_for_each(|setting| writeln!(out, "  {}", setting.title()))?;
    }
    writeln!(out, "\n{} states, {} of them from memory", rows.len(), from_memory(control.family()))
}

/// A way in which programs deal with states: its title, and whether a row is one of it.
type Way = (&'static str, fn(&StateHandling) -> bool);

/// The ways, the first of which is taken that is possible.
const WAYS: [Way; 4] = [
    ("Written in the word itself", |by| matches!(by, StateHandling::InWord(_))),
    ("Set at each restart point", |by| matches!(by, StateHandling::Set(_) | StateHandling::SetWhere(..))),
    ("Compared by a guard that stops", |by| matches!(by, StateHandling::Compared(..))),
    ("Stated in header and sheet", |by| {
        matches!(by, StateHandling::Stated(_) | StateHandling::StatedUnless(..) | StateHandling::Noted(_))
    }),
];

/// Number of states of a control that are from memory, settings with a value included.
pub(crate) fn from_memory(family: &str) -> usize {
    of(family).iter().filter(|row| row.source.is_empty()).count()
        + ControlState::of(family).filter(|setting| setting.is_from_memory()).count()
}
