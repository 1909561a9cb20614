//! Coolant: request of the CL data, defaults of the configuration, and the state as written.

use std::io;

use crate::motion::options::Policy;
use crate::program::{Coolant as Kind, Pressure};

use crate::motion::fault::{Fault, Planned};
use crate::motion::plan::abilities::Abilities;
use crate::motion::plan::output::Output;
use crate::motion::plan::tool::LoadedTool;
use crate::motion::step::{Sink, Step};

/// Coolant while a program is planned.
#[derive(Debug, Clone)]
pub(crate) struct CoolantState {
    request: Kind,
    /// As written; `None` if unknown.
    written: Option<Kind>,
}

impl Default for CoolantState {
    fn default() -> Self {
        Self { request: Kind::Off, written: None }
    }
}

impl CoolantState {
    /// COOLNT. A pressure that the control has no code for is left out.
    pub(crate) fn request<S: Sink>(&mut self, kind: Kind, abilities: &Abilities, output: &mut Output<S>) {
        self.request = kind;
        let Kind::ThroughAt(pressure) = kind else { return };
        if !abilities.pressures[pressure as usize] {
            self.request = Kind::Through;
            let (word, key) = match pressure {
                Pressure::Low => ("LOW", "through_low"),
                Pressure::Medium => ("MEDIUM", "through_medium"),
                Pressure::High => ("HIGH", "through_high"),
            };
            let text = format!("coolant through the spindle is switched on without its pressure: {word} has no code");
            let help =
                format!("configure its codes for on and off: `[control] coolant = {{ {key} = [\"M..\", \"M..\"] }}`");
            output.remark(Fault::new(text).help(help));
        }
    }

    /// Forgets the state.
    pub(crate) fn forget(&mut self) {
        self.written = None;
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
        let kind = match self.request {
            Kind::On => given.and_then(|tool| tool.coolant).unwrap_or(policy.options.defaults.coolant),
            kind => kind,
        };
        let missing = match kind {
            Kind::On | Kind::Flood => (!abilities.flood).then_some("flood"),
            Kind::Mist => (!abilities.mist).then_some("mist"),
            Kind::ThroughAt(_) => None,
            Kind::Through => (!abilities.through).then_some("coolant through the spindle"),
            Kind::Air => (!abilities.air).then_some("air"),
            Kind::Off => None,
        };
        if let Some(missing) = missing {
            return Err(Fault::new(format_args!("this control has no code for {missing}"))
                .help("configure its codes for on and off: `[control] coolant = { air = [\"M83\", \"M84\"] }`")
                .into());
        }
        if kind == Kind::Off || policy.options.lift_mm.is_some() {
            return Ok(self.stop(output)?);
        }
        if self.written != Some(kind) {
            if self.written.is_some_and(|before| before != Kind::Off) {
                output.step(&Step::CoolantOff)?;
            }
            self.written = Some(kind);
            output.step(&Step::Coolant { kind })?;
        }
        Ok(())
    }

    /// Writes coolant off, unless it is off.
    pub(crate) fn stop<S: Sink>(&mut self, output: &mut Output<S>) -> io::Result<()> {
        if self.written != Some(Kind::Off) {
            self.written = Some(Kind::Off);
            output.step(&Step::CoolantOff)?;
        }
        Ok(())
    }
}
