//! `SPINDL/..`: RPM, a number, CLW or CCLW, ON and OFF in any order.

use super::args::Args;
use super::fault::{Fault, quoted};
use super::parse::{argument_not_yet, needed, turning};
use crate::program::{Rotation, Spindle};

/// Words of constant surface speed: a lathe's.
const SURFACE_SPEED: [&str; 3] = ["SFM", "SMM", "MAXRPM"];

/// Speeds below this are S0 where S has no decimals, rev/min.
const SLOWEST: f64 = 0.5;

/// Speeds above this have a wrong exponent, rev/min.
const FASTEST: f64 = 1e6;

/// Reads all arguments.
pub(super) fn parse(name: &'static str, args: &mut Args<'_>) -> Result<Spindle, Fault> {
    let mut arg = needed(name, args)?;
    let mut speed = None;
    let mut rotation = None;
    let (mut on, mut off, mut rpm) = (false, false, false);
    loop {
        let repeated = if arg.looks_numeric() {
            let value = arg.number()?;
            if value <= 0.0 {
                return Err(Fault::new(
                    "spindle speed",
                    arg.at,
                    format!("the spindle speed {} is not above 0", quoted(arg.text)),
                    "SPINDL/OFF stops the spindle; the sense of rotation is CLW or CCLW",
                ));
            }
            if value < SLOWEST {
                return Err(Fault::new(
                    "spindle speed",
                    arg.at,
                    format!("a spindle speed of {value} rev/min rounds to 0"),
                    "check the speed of this tool in the CAM system",
                ));
            }
            if value > FASTEST {
                return Err(Fault::new(
                    "spindle speed",
                    arg.at,
                    format!("a spindle speed of {} rev/min is not plausible", quoted(arg.text)),
                    "check the exponent",
                ));
            }
            speed.replace(value).is_some()
        } else if arg.is("RPM") {
            std::mem::replace(&mut rpm, true)
        } else if arg.is("CLW") {
            rotation.replace(Rotation::Clockwise).is_some()
        } else if arg.is("CCLW") {
            rotation.replace(Rotation::CounterClockwise).is_some()
        } else if arg.is("ON") {
            std::mem::replace(&mut on, true)
        } else if arg.is("OFF") {
            std::mem::replace(&mut off, true)
        } else if SURFACE_SPEED.iter().any(|word| arg.is(word)) {
            return Err(turning(arg.at));
        } else {
            return Err(argument_not_yet(name, arg));
        };
        let contradicts = off && (on || rpm || speed.is_some() || rotation.is_some());
        if repeated || contradicts {
            return Err(Fault::new(
                "spindle",
                arg.at,
                format!("{} contradicts what stands before it", quoted(arg.text)),
                "write one speed and one sense of rotation, or OFF alone",
            ));
        }
        match args.next()? {
            Some(next) => arg = next,
            None => break,
        }
    }
    if rpm && speed.is_none() {
        return Err(Fault::new("spindle speed", args.all(), "RPM without a speed", "write SPINDL/RPM,3600,CLW"));
    }
    Ok(if off { Spindle::Off } else { Spindle::On { speed, rotation } })
}
