//! Data of a tool from the configuration and the CL data, with the refusals and remarks where the two differ.

use crate::diag::code::plan;
use crate::motion::policy::Policy;
use crate::nc::Decimal;
use crate::options::Defaults;
use crate::program::{Rotation, Spindle, ToolCall};
use crate::set_up::GivenTool as Given;

use crate::motion::fault::Fault;
use crate::motion::plan::abilities::Registers;

/// The tool in the spindle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadedTool {
    /// Tool number.
    pub(crate) number: u32,
    /// Gauge length: from gauge line to tip, if known.
    pub(crate) length_mm: Option<f64>,
    /// Register of the length offset.
    pub(crate) offset: u32,
    /// Radius, as the CL data was made for, if known.
    pub(crate) radius_mm: Option<f64>,
}

/// Spindle state requested by the CL data; the configuration has the defaults.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SpindleRequest {
    /// The last SPINDL was SPINDL/OFF.
    pub(crate) off: bool,
    pub(crate) speed_rev_per_min: Option<f64>,
    pub(crate) rotation: Option<Rotation>,
}

/// Speed and sense of rotation for a tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ResolvedSpindle {
    /// As it is written.
    pub(crate) word: Decimal,
    /// As the CL data or the configuration has it.
    pub(crate) exact_rev_per_min: f64,
    pub(crate) rotation: Rotation,
}

impl LoadedTool {
    /// An empty spindle.
    pub(crate) const NONE: Self = Self { number: 0, length_mm: None, offset: 0, radius_mm: None };

    /// The tool of a record. `needed`: reason why the words depend on the length, if they do.
    pub(crate) fn resolve(
        call: &ToolCall,
        policy: Policy<'_>,
        needed: Option<&str>,
        registers: Registers,
    ) -> Result<Self, Fault> {
        let number = call.number;
        if number == 0 {
            return Ok(Self::NONE);
        }
        let given = policy.set_up.tools.get(&number);
        let length = call.length_mm.or(given.and_then(|tool| tool.length_mm));
        if let Some(why) = needed
            && length.is_none()
        {
            return Err(plan::TOOL_LENGTH
                .fault(format_args!("the gauge length of T{number} is unknown, and {why}"))
                .help(format_args!("give `[tools.{number}] length` in the configuration, or LENGTH in LOADTL")));
        }
        let offset = call.length_offset.or(given.and_then(|tool| tool.offset));
        let offset = registers.of_tool(number, offset).ok_or_else(|| {
            plan::TOOL.fault(format_args!(
                "T{number} is called with another length register, but this control takes the length from the row of the tool"
            ))
            .help(format_args!("remove the register from the CL data, or give `[tools.{number}] offset = {number}`"))
        })?;
        let diameter = call.diameter_mm.or(given.and_then(|tool| tool.diameter_mm));
        Ok(Self { number, length_mm: length, offset, radius_mm: diameter.map(|diameter| 0.5 * diameter) })
    }
}

impl SpindleRequest {
    /// Takes one SPINDL; speed or rotation that it leaves out stay as requested before.
    pub(crate) fn take(&mut self, spindle: Spindle) {
        self.off = spindle == Spindle::Off;
        if let Spindle::On { speed_rev_per_min: speed, rotation } = spindle {
            self.speed_rev_per_min = speed.or(self.speed_rev_per_min);
            self.rotation = rotation.or(self.rotation);
        }
    }

    /// Speed and sense of rotation for a tool; `None` if off is requested, or if speed or sense are unknown.
    pub(crate) fn resolve(&self, given: Option<&Given>, policy: Policy<'_>) -> Result<Option<ResolvedSpindle>, Fault> {
        let Defaults { speed_rev_per_min: speed, rotation, .. } = policy.options.defaults;
        if self.off {
            return Ok(None);
        }
        let speed = self.speed_rev_per_min.or(given.and_then(|tool| tool.speed_rev_per_min)).or(speed);
        let rotation = self.rotation.or(given.and_then(|tool| tool.rotation)).or(rotation);
        let (Some(speed), Some(rotation)) = (speed, rotation) else { return Ok(None) };
        if let Some(largest) = policy.options.guards.spindle_max_rev_per_min
            && speed > largest
        {
            let text = format!("a spindle speed of {speed} rev/min is above `spindle_max` = {largest} rev/min");
            return Err(plan::SPINDLE.fault(text));
        }
        let word = Decimal::fixed(speed, policy.formats.speed).map_err(|_| {
            plan::SPINDLE.fault(format_args!("a spindle speed of {speed} rev/min is too large for an S word"))
        })?;
        if word.value() >= 10_f64.powi(policy.formats.speed_whole as i32) {
            return Err(plan::SPINDLE
                .fault(format_args!(
                    "a spindle speed of {speed} rev/min has more digits than an S word of this control"
                ))
                .help("`[formats] speed_whole` is the number of digits before the decimal point"));
        }
        if word.units <= 0 {
            let fault =
                plan::SPINDLE.fault(format_args!("a spindle speed of {speed} rev/min is written as S0 or below"));
            return Err(if speed > 0.0 {
                fault.help("`[formats] speed` is the number of decimals of S")
            } else {
                fault
            });
        }
        if given.is_some_and(|tool| tool.left_handed) && rotation == Rotation::Clockwise {
            return Err(plan::SPINDLE
                .fault("the tool cuts counter-clockwise (`left_handed`), but the spindle rotates clockwise")
                .help("give SPINDL/..,CCLW, or correct the tool in the configuration"));
        }
        Ok(Some(ResolvedSpindle { word, exact_rev_per_min: speed, rotation }))
    }
}
