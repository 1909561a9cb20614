//! `SPINDL/..`: the word RPM, a number (rev/min), CLW or CCLW, ON or OFF, in any order.

use std::fmt::{self, Formatter};

use super::values::ClNumber;
use crate::cl::text::{Arg, Args, ClFault, quoted};
use crate::diag::code::cl;
use crate::program::{Rotation, Spindle};

/// Words of constant surface speed, which belongs to turning.
const SURFACE_SPEED: [&str; 3] = ["SFM", "SMM", "MAXRPM"];

/// Smallest speed that does not round to S0 in a word with the most decimals; planning knows how many the word has.
const SLOWEST_REV_PER_MIN: f64 = 5e-4;

/// Largest plausible speed; a larger one has a wrong exponent.
const FASTEST_REV_PER_MIN: f64 = 1e6;

/// The words of a SPINDL that are read so far.
#[derive(Default)]
struct SpindleWords {
    speed: Option<f64>,
    rotation: Option<Rotation>,
    rpm: bool,
    on: bool,
    off: bool,
}

impl SpindleWords {
    /// Takes one word; returns whether a word of its kind was read before.
    fn take(&mut self, arg: Arg<'_>, args: &Args<'_>) -> Result<bool, ClFault> {
        Ok(if arg.looks_numeric() {
            self.speed.replace(speed(arg)?).is_some()
        } else if arg.is("RPM") {
            std::mem::replace(&mut self.rpm, true)
        } else if arg.is("CLW") {
            self.rotation.replace(Rotation::Clockwise).is_some()
        } else if arg.is("CCLW") {
            self.rotation.replace(Rotation::CounterClockwise).is_some()
        } else if arg.is("ON") {
            std::mem::replace(&mut self.on, true)
        } else if arg.is("OFF") {
            std::mem::replace(&mut self.off, true)
        } else if SURFACE_SPEED.iter().any(|word| arg.is(word)) {
            return Err(ClFault::lathe_record(arg.at));
        } else {
            return Err(args.not_understood(arg));
        })
    }

    /// Whether OFF comes together with another word.
    fn contradicts_itself(&self) -> bool {
        self.off && (self.on || self.rpm || self.speed.is_some() || self.rotation.is_some())
    }
}

/// SPINDL.
pub(crate) fn spindle(args: &mut Args<'_>) -> Result<Spindle, ClFault> {
    let mut words = SpindleWords::default();
    let mut next = Some(args.needed()?);
    while let Some(arg) = next {
        if words.take(arg, args)? || words.contradicts_itself() {
            return Err(cl::SPINDLE.cl_fault(
                "spindle",
                arg.at,
                format!("{} contradicts an earlier word of this SPINDL", quoted(arg.text)),
                "program one speed and one sense of rotation, or OFF alone",
            ));
        }
        next = args.next()?;
    }
    if words.rpm && words.speed.is_none() {
        return Err(cl::SPINDLE.cl_fault(
            "spindle speed",
            args.all(),
            "SPINDL with RPM has no speed",
            "write SPINDL/RPM,3600,CLW",
        ));
    }
    let SpindleWords { speed, rotation, off, .. } = words;
    Ok(if off { Spindle::Off } else { Spindle::On { speed_rev_per_min: speed, rotation } })
}

/// Reads a plausible spindle speed, rev/min.
fn speed(arg: Arg<'_>) -> Result<f64, ClFault> {
    let value = arg.number()?;
    let fault = |text: String, help: &str| Err(cl::SPINDLE.cl_fault("spindle speed", arg.at, text, help));
    if value <= 0.0 {
        return fault(
            format!("the spindle speed must be above 0, found {}", quoted(arg.text)),
            "SPINDL/OFF stops the spindle; the sense of rotation is CLW or CCLW",
        );
    }
    if value < SLOWEST_REV_PER_MIN {
        return fault(
            format!("a spindle speed of {} rev/min rounds to 0", quoted(arg.text)),
            "check the speed of this tool in the CAM system",
        );
    }
    if value > FASTEST_REV_PER_MIN {
        let text = format!("a spindle speed of {} rev/min is not plausible", quoted(arg.text));
        return fault(text, "check the exponent of this number");
    }
    Ok(value)
}

pub(crate) fn write_spindle(spindle: Spindle, out: &mut Formatter<'_>) -> fmt::Result {
    let Spindle::On { speed_rev_per_min: speed, rotation } = spindle else { return out.write_str("SPINDL/OFF") };
    out.write_str("SPINDL/ON")?;
    if let Some(speed) = speed {
        write!(out, ",RPM,{}", ClNumber(speed))?;
    }
    match rotation {
        Some(Rotation::Clockwise) => out.write_str(",CLW"),
        Some(Rotation::CounterClockwise) => out.write_str(",CCLW"),
        None => Ok(()),
    }
}
