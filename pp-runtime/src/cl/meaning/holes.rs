//! Meaning of a CYCLE in each CAM system: levels along the tool axis, measured from the point of each GOTO.

use crate::cl::dialect::Dialect;
use crate::cl::record::{ClCycleKind, CycleCall, FeedUnit, Return};
use crate::cl::text::{ClFault, Span};
use crate::program::{Drilling, Dwell, Feed};

/// Meaning of a number of a CYCLE that has no word before it (`[cl.cycle.TAP] args`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleArg {
    /// Depth, positive into the part.
    Depth,
    /// Clearance level.
    Clearance,
    /// Return level.
    Return,
    /// Depth of a step.
    Step,
    /// Dwell at the bottom, seconds.
    Dwell,
    /// Pitch of a thread, units of the file per revolution.
    Pitch,
    /// Feed, units of the file per minute.
    Feed,
}

impl CycleArg {
    /// Names as in configuration files.
    pub const NAMES: [(&'static str, CycleArg); 7] = [
        ("depth", CycleArg::Depth),
        ("clearance", CycleArg::Clearance),
        ("return", CycleArg::Return),
        ("step", CycleArg::Step),
        ("dwell", CycleArg::Dwell),
        ("pitch", CycleArg::Pitch),
        ("feed", CycleArg::Feed),
    ];
}

/// Return level after a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ReturnLevel {
    /// The clearance level.
    Clearance,
    /// The initial level: that of the tool before the cycle.
    Initial,
    /// This level above the top of the hole, mm.
    Level(f64),
}

/// Hole of a cycle; its levels are measured from the top of the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HoleDefinition {
    pub(crate) depth_mm: f64,
    pub(crate) clearance_mm: f64,
    pub(crate) return_level: ReturnLevel,
    pub(crate) drilling: Drilling,
    pub(crate) feed: Option<Feed>,
    pub(crate) dwell: Option<Dwell>,
}

/// State on which the meaning of a CYCLE depends besides its record.
pub(crate) struct CycleContext<'a> {
    pub(crate) dialect: Dialect,
    /// mm in one unit of the file.
    pub(crate) unit_mm: f64,
    /// CYCLE/INIT (true) or CYCLE/CLEAR (false) before the cycle.
    pub(crate) initial: Option<bool>,
    /// Meaning of the numbers without a word, as configured.
    pub(crate) args: Option<&'a [CycleArg]>,
    /// Feed of the record.
    pub(crate) feed: Option<Feed>,
}

fn fault(at: Span, text: impl Into<String>, help: &str) -> ClFault {
    ClFault::new("CYCLE", at, text, help)
}

/// Returns the record with the numbers without a word under their configured meaning, and the pitch among them.
fn named(cycle: &CycleCall, args: Option<&[CycleArg]>) -> Result<(CycleCall, Option<f64>), ClFault> {
    let mut cycle = *cycle;
    let mut pitch = None;
    if cycle.positionals == 0 {
        return Ok((cycle, pitch));
    }
    let word = cycle.kind.word();
    let Some(args) = args.filter(|args| args.len() == cycle.positionals) else {
        let text = format!(
            "CYCLE/{word} has {} numbers without a word, whose meaning depends on a table of the CAM system",
            cycle.positionals
        );
        let help =
            format!("state their meaning in the configuration: `[cl.cycle.{word}] args = [\"depth\", \"pitch\"]`");
        return Err(ClFault::new("CYCLE", cycle.at, text, help));
    };
    for (arg, value) in args.iter().zip(cycle.positional) {
        let place = match arg {
            CycleArg::Depth => &mut cycle.depth,
            CycleArg::Clearance => &mut cycle.clear,
            CycleArg::Step => &mut cycle.step,
            CycleArg::Dwell => &mut cycle.dwell_s,
            CycleArg::Pitch => &mut pitch,
            CycleArg::Return => {
                cycle.back_to = Some(Return::Level(value));
                continue;
            }
            CycleArg::Feed => {
                cycle.feed = Some((value, FeedUnit::PerMinute));
                continue;
            }
        };
        *place = Some(value);
    }
    Ok((cycle, pitch))
}

/// Returns the record with the numbers without a word under their configured meaning; its feed is read from it.
pub(crate) fn with_names(cycle: &CycleCall, args: Option<&[CycleArg]>) -> Result<CycleCall, ClFault> {
    named(cycle, args).map(|(cycle, _)| cycle)
}

/// Returns the hole that a CYCLE defines.
pub(crate) fn define(cycle: &CycleCall, context: &CycleContext<'_>) -> Result<HoleDefinition, ClFault> {
    let (cycle, pitch) = named(cycle, context.args)?;
    let unit_mm = context.unit_mm;
    let depth = depth(&cycle, context.dialect)? * unit_mm;
    let clearance = clearance(&cycle, context.dialect)? * unit_mm;
    let back = back(&cycle, context, clearance)?;
    let drilling = drilling(&cycle, context.feed, pitch, unit_mm)?;
    let dwell = match (cycle.dwell_s, cycle.dwell_rev) {
        (Some(_), Some(_)) => {
            return Err(fault(
                cycle.at,
                "this cycle has a dwell in seconds and one in revolutions",
                "program one DWELL",
            ));
        }
        (Some(value), None) | (None, Some(value)) if value < 0.0 => {
            return Err(fault(cycle.at, "DWELL must not be negative", "write DWELL,seconds"));
        }
        (Some(seconds), None) => (seconds > 0.0).then_some(Dwell::Seconds(seconds)),
        (None, Some(turns)) => (turns > 0.0).then_some(Dwell::Revolutions(turns)),
        (None, None) => None,
    };
    Ok(HoleDefinition {
        depth_mm: depth,
        clearance_mm: clearance,
        return_level: back,
        drilling,
        feed: context.feed,
        dwell,
    })
}

/// Depth below the point of the GOTO, in units of the file, above 0.
fn depth(cycle: &CycleCall, dialect: Dialect) -> Result<f64, ClFault> {
    let value = match (cycle.fedto, cycle.depth, dialect) {
        (Some(fedto), None, Dialect::Nx) => -fedto,
        (Some(fedto), None, Dialect::SolidWorks) => fedto,
        (Some(_), ..) => {
            return Err(fault(
                cycle.depth_at,
                "the sign of FEDTO depends on the CAM system, and that of this file is unknown",
                "add `--dialect nx` or `--dialect solidworks`",
            ));
        }
        (None, Some(_), Dialect::Generic) => {
            return Err(fault(
                cycle.at,
                "the meaning of the levels of a CYCLE depends on the CAM system, and that of this file is unknown",
                "add `--dialect iso`, `catia` or `creo`",
            ));
        }
        (None, Some(depth), _) => depth,
        (None, None, _) => return Err(fault(cycle.at, "this cycle has no depth", "program DEPTH or FEDTO")),
    };
    if value.abs() < f64::MIN_POSITIVE {
        return Err(fault(
            cycle.depth_at,
            "the depth of this hole is 0",
            "set the depth of the hole in the CAM system",
        ));
    }
    if value < 0.0 {
        return Err(fault(
            cycle.depth_at,
            "the sign of this depth is wrong: it leads out of the part",
            "into the part FEDTO is negative in NX, and every other depth is positive",
        ));
    }
    Ok(value)
}

/// Clearance level, in units of the file: down to it the tool moves at rapid.
fn clearance(cycle: &CycleCall, dialect: Dialect) -> Result<f64, ClFault> {
    let couplet = match dialect {
        Dialect::Nx | Dialect::SolidWorks => false,
        Dialect::Generic | Dialect::Catia | Dialect::Creo | Dialect::Iso | Dialect::Autodesk => true,
    };
    let level = match (cycle.rapto, cycle.clear) {
        (Some(rapto), None) if !couplet => rapto,
        (None, Some(clear)) => clear,
        (Some(rapto), Some(clear)) if (rapto - clear).abs() < 1e-9 => clear,
        (Some(_), Some(_)) => {
            return Err(fault(
                cycle.at,
                "RAPTO and CLEAR of this cycle differ: the clearance level is ambiguous",
                "have the CAM system output one of them",
            ));
        }
        (Some(_), None) => {
            return Err(fault(cycle.at, "RAPTO without CLEAR: the clearance level is unknown", "program CLEAR"));
        }
        (None, None) => {
            return Err(fault(cycle.at, "this cycle has no clearance level", "program RAPTO or CLEAR"));
        }
    };
    if level < 0.0 {
        return Err(fault(
            cycle.at,
            "the clearance level lies below the top of the hole",
            "the tool would plunge into the part at rapid: check RAPTO or CLEAR",
        ));
    }
    Ok(level)
}

fn back(cycle: &CycleCall, context: &CycleContext<'_>, clearance: f64) -> Result<ReturnLevel, ClFault> {
    let back = match (context.dialect, cycle.back_to) {
        (Dialect::SolidWorks, level) => {
            let Some(initial) = context.initial else {
                return Err(fault(
                    cycle.at,
                    "the return level of this cycle is not selected: neither CYCLE/INIT nor CYCLE/CLEAR comes before it",
                    "program CYCLE/INIT (initial level) or CYCLE/CLEAR (clearance level) before the cycle",
                ));
            };
            match level {
                _ if !initial => ReturnLevel::Clearance,
                Some(Return::Level(level)) => ReturnLevel::Level(level * context.unit_mm),
                _ => return Err(fault(cycle.at, "CYCLE/INIT needs RTRCTO with a level", "program RTRCTO,level")),
            }
        }
        (_, None) => ReturnLevel::Clearance,
        (Dialect::Nx, Some(Return::Auto)) => ReturnLevel::Initial,
        (_, Some(Return::Auto)) => {
            return Err(fault(cycle.at, "RTRCTO,AUTO is supported for NX only", "program RETURN,level"));
        }
        (_, Some(Return::Level(level))) => ReturnLevel::Level(level * context.unit_mm),
    };
    match back {
        ReturnLevel::Level(level) if level < clearance => Err(fault(
            cycle.at,
            "the return level of this cycle lies below its clearance level",
            "program a return level at or above the clearance level",
        )),
        back => Ok(back),
    }
}

fn drilling(cycle: &CycleCall, feed: Option<Feed>, pitch: Option<f64>, unit_mm: f64) -> Result<Drilling, ClFault> {
    let steps = |step: Option<f64>| match step {
        Some(step) if step > 0.0 => Ok(step * unit_mm),
        Some(_) => Err(fault(cycle.at, "the step of a cycle must be above 0", "program STEP,depth")),
        None => Err(fault(cycle.at, "this cycle has no step", "program STEP, INCR or SUBPECK with a depth")),
    };
    if cycle.orient_deg.is_some() || cycle.kind == ClCycleKind::Back {
        return Err(fault(
            cycle.at,
            "this cycle stops the spindle at an angle in the hole: only a canned cycle of the control can do that",
            "have the CAM system output the motions, or retract at feed: BORE without ORIENT",
        ));
    }
    let any = cycle.back.or(cycle.first_step).or(cycle.step);
    let stray = match cycle.kind {
        ClCycleKind::Deep => cycle.back,
        ClCycleKind::Brkchp => cycle.first_step,
        ClCycleKind::Drill | ClCycleKind::Face | ClCycleKind::Csink | ClCycleKind::Thru | ClCycleKind::Cbore => any,
        ClCycleKind::Bore | ClCycleKind::Back | ClCycleKind::Ream | ClCycleKind::Tap => any,
    };
    if stray.is_some() {
        return Err(fault(
            cycle.at,
            format!("this cycle has a word that does not belong to {}", cycle.kind.word()),
            "STEP belongs to DEEP and BRKCHP, 1STPECK to DEEP, BACK to BRKCHP",
        ));
    }
    Ok(match cycle.kind {
        ClCycleKind::Drill | ClCycleKind::Face | ClCycleKind::Csink | ClCycleKind::Thru | ClCycleKind::Cbore => {
            Drilling::Drill
        }
        ClCycleKind::Bore | ClCycleKind::Ream | ClCycleKind::Back => Drilling::Ream,
        ClCycleKind::Deep => {
            let later = steps(cycle.step)?;
            let first = if cycle.first_step.is_some() { steps(cycle.first_step)? } else { later };
            Drilling::Peck { first_mm: first, later_mm: later }
        }
        ClCycleKind::Brkchp => {
            let back = if cycle.back.is_some() { Some(steps(cycle.back)?) } else { None };
            Drilling::ChipBreak { step_mm: steps(cycle.step)?, retract_mm: back }
        }
        ClCycleKind::Tap => {
            let pitch_mm = match feed {
                Some(Feed::PerRevolution(feed)) => Some(feed),
                _ => pitch.map(|pitch| pitch * unit_mm),
            };
            Drilling::Tap { pitch_mm }
        }
    })
}
