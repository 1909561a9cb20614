//! Coolant: request of the CL data, defaults of the configuration, and the state as written.

use std::io;

use crate::diag::code::plan;
use crate::motion::policy::Policy;
use crate::program::{Coolant, Coolants};

use crate::motion::fault::Planned;
use crate::motion::plan::abilities::Abilities;
use crate::motion::plan::output::Output;
use crate::motion::plan::tool::LoadedTool;
use crate::motion::step::{Sink, Step};

/// Coolant while a program is planned.
#[derive(Debug, Clone)]
pub(crate) struct CoolantState {
    request: Coolant,
    /// As written; `None` if unknown.
    written: Option<Coolants>,
    /// Coolant through the spindle has been on since the last tool change.
    drains: bool,
}

impl Default for CoolantState {
    fn default() -> Self {
        Self { request: Coolant::Off, written: None, drains: false }
    }
}

impl CoolantState {
    /// COOLNT. A pressure that the control has no code for is left out.
    pub(crate) fn request<S: Sink>(&mut self, kind: Coolant, abilities: &Abilities, output: &mut Output<S>) {
        self.request = without_pressure(kind, abilities, output);
    }

    /// Forgets the state.
    pub(crate) fn forget(&mut self) {
        self.written = None;
    }

    /// Whether coolant through the spindle has been on since the last call.
    pub(crate) fn take_drains(&mut self) -> bool {
        std::mem::take(&mut self.drains)
    }

    /// Whether coolant is known to be on.
    pub(crate) fn is_on(&self) -> bool {
        self.written.is_some_and(|kinds| !kinds.is_empty())
    }

    /// Writes the requested state, unless it is in force.
    pub(crate) fn apply<S: Sink>(
        &mut self,
        tool: Option<LoadedTool>,
        policy: Policy<'_>,
        abilities: &Abilities,
        output: &mut Output<S>,
    ) -> Planned {
        let given = tool.and_then(|tool| policy.set_up.tools.get(&tool.number));
        let kinds: Coolants = match self.request {
            Coolant::On => {
                let kinds = given.and_then(|tool| tool.coolant).unwrap_or(policy.options.defaults.coolant);
                kinds.kinds().map(|kind| without_pressure(kind, abilities, output)).collect()
            }
            kind => Coolants::of(kind),
        };
        if let Some(missing) = kinds.kinds().find(|kind| !abilities.coolants.has(*kind)) {
            let (name, key) = match missing {
                Coolant::Mist => ("mist", "mist"),
                Coolant::Through | Coolant::ThroughAt(_) => ("coolant through the spindle", "through"),
                Coolant::Air => ("air", "air"),
                Coolant::On | Coolant::Off | Coolant::Flood => ("flood", "flood"),
            };
            let asks =
                if self.request == Coolant::On { "`coolant` of the tool, or of `[defaults]`," } else { "COOLNT" };
            return Err(plan::COOLANT.fault(format_args!("{asks} asks for {name}, for which this control has no code"))
                .help(format_args!(
                    "configure the codes of the machine builder for on and off: `[control] coolant = {{ {key} = [\"M..\", \
                     \"M..\"] }}`"
                ))
                .into());
        }
        if kinds.is_empty() || policy.options.lift_mm.is_some() {
            return Ok(self.stop(output)?);
        }
        if self.written != Some(kinds) {
            if self.written.is_some_and(|before| !before.is_empty()) {
                output.step(&Step::CoolantOff)?;
            }
            self.written = Some(kinds);
            self.drains |= kinds.kinds().any(|kind| matches!(kind, Coolant::Through | Coolant::ThroughAt(_)));
            for kind in kinds.kinds() {
                output.step(&Step::Coolant { kind })?;
            }
        }
        Ok(())
    }

    /// Writes coolant off, unless it is off.
    pub(crate) fn stop<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        if !self.written.is_some_and(Coolants::is_empty) {
            self.written = Some(Coolants::default());
            output.step(&Step::CoolantOff)?;
        }
        Ok(())
    }
}

/// A kind of coolant without the pressure that the control has no code for, with a remark.
fn without_pressure<S: Sink>(kind: Coolant, abilities: &Abilities, output: &mut Output<S>) -> Coolant {
    let Coolant::ThroughAt(pressure) = kind else { return kind };
    if abilities.coolants.has(kind) {
        return kind;
    }
    let word = pressure.word();
    let text = format!("coolant through the spindle is switched on without its pressure: {word} has no code");
    let help = format!(
        "configure its codes for on and off: `[control] coolant = {{ through_{} = [\"M..\", \"M..\"] }}`",
        word.to_lowercase()
    );
    output.remark(plan::COOLANT.fault(text).help(help));
    Coolant::Through
}
