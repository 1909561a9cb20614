//! Meaning of a CYCLE in each CAM system: levels along the tool axis, measured from the point of each GOTO.
//!
//! The post *Common ISO 4343 APT* of Autodesk writes `CYCLE/DRILL, depth, MMPM, feed, clearance[, RAPTO, r]` and, as GOTO, the
//! point of `onCyclePoint`, which is the bottom: its other posts write its Z after G81. Clearance is the Z of the plane between
//! the holes (`cycle.clearance`), and the feed begins r below it (`cycle.clearance - cycle.retract`). *Generative Machining
//! APT* of HSMWorks writes the same text with the top as point and other levels, so neither is read unless it is given.
//!
//! *CAMplete APT* of Autodesk writes `CYCLE/DRILL, FEDTO, depth, MMPM, feed, CLEAR, z, RETURN, r[, RAPTO, p]` and, as GOTO, the
//! top (`cycle.stock`): r is `clearance - stock`, p `retract - stock`, absent where it is 0, and z the Z of the clearance plane,
//! which is r above the point.

use crate::cl::dialect::Dialect;
use crate::cl::record::{ClCycleKind, CycleCall, FeedUnit, Return};
use crate::cl::text::{ClFault, Span};
use crate::kinematics::Pose;
use crate::nalgebra::Point3;
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
    /// The points are the bottoms of the holes, and the levels are these planes.
    pub(crate) from_bottom: Option<HolePlanes>,
    /// Z of the plane that the return level must be, mm (*CAMplete APT*).
    pub(crate) returns_at_mm: Option<f64>,
}

/// Planes across Z of a cycle whose points are the bottoms of the holes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HolePlanes {
    /// Z of the plane between the holes, mm.
    pub(crate) clearance_mm: f64,
    /// Z of the plane at which the feed begins, mm.
    pub(crate) feed_begins_mm: f64,
}

impl HoleDefinition {
    /// The hole at a point of the cycle: its top, and its definition from there. `before`: position of the tool before the
    /// cycle.
    pub(crate) fn at(
        self,
        point: Pose,
        before: Option<Point3<f64>>,
        at: Span,
    ) -> Result<(Pose, HoleDefinition), ClFault> {
        /// Largest difference of a level from that of the tool, by the digits of CL data.
        const SAME_LEVEL_MM: f64 = 1e-3;
        if let (Some(plane), ReturnLevel::Level(level)) = (self.returns_at_mm, self.return_level)
            && (point.tip.z + level - plane).abs() > 2.0 * SAME_LEVEL_MM
        {
            return Err(fault(
                at,
                format!(
                    "this point is not the top of its hole: {level} above it is Z {}, and CLEAR is {plane}",
                    point.tip.z + level
                ),
                "does `dialect = \"autodesk\"` hold for this file? In its CAMplete post CLEAR is RETURN above the point",
            ));
        }
        let Some(planes) = self.from_bottom else { return Ok((point, self)) };
        if point.axis.z < 1.0 - f64::EPSILON {
            return Err(fault(
                at,
                "the levels of this cycle are planes across Z, and the tool is tilted",
                "their place along a tilted tool is not known; post the holes of this operation as single motions",
            ));
        }
        let top = point.tip + point.axis.into_inner() * self.depth_mm;
        let (clearance_mm, return_mm) = (planes.feed_begins_mm - top.z, planes.clearance_mm - top.z);
        if before.is_none_or(|before| before.z < planes.clearance_mm - SAME_LEVEL_MM) {
            return Err(fault(
                at,
                format!("the tool is below the clearance plane of this cycle, Z {}, before it", planes.clearance_mm),
                "the post of Autodesk moves there first: does `dialect = \"autodesk\"` hold for this file?",
            ));
        }
        if clearance_mm < 0.0 || return_mm < clearance_mm {
            return Err(fault(
                at,
                format!(
                    "the feed of this hole begins {clearance_mm:.4} mm above its top, below it or above the clearance plane"
                ),
                "the tool would plunge into the part at rapid: does `dialect = \"autodesk\"` hold for this file?",
            ));
        }
        let return_level = ReturnLevel::Level(return_mm);
        Ok((Pose { tip: top, ..point }, HoleDefinition { clearance_mm, return_level, ..self }))
    }
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

/// Numbers without a word of *Common ISO 4343 APT*.
const OF_AUTODESK: [CycleArg; 2] = [CycleArg::Depth, CycleArg::Clearance];

/// Returns the record with the numbers without a word under their configured meaning, and the pitch among them.
fn named(cycle: &CycleCall, args: Option<&[CycleArg]>, dialect: Dialect) -> Result<(CycleCall, Option<f64>), ClFault> {
    let mut cycle = *cycle;
    let mut pitch = None;
    if cycle.positionals == 0 {
        return Ok((cycle, pitch));
    }
    let word = cycle.kind.word();
    let of_autodesk = (dialect == Dialect::Autodesk).then_some(&OF_AUTODESK[..]);
    let Some(args) = args.or(of_autodesk).filter(|args| args.len() == cycle.positionals) else {
        let text = format!(
            "CYCLE/{word} has {} numbers without a word, whose meaning depends on a table of the CAM system",
            cycle.positionals
        );
        let example = match cycle.positionals {
            1 => "\"depth\"",
            2 => "\"depth\", \"clearance\"",
            _ => "\"depth\", \"clearance\", ..",
        };
        let post = if cycle.positionals == OF_AUTODESK.len() && dialect == Dialect::Generic {
            "if \"Common ISO 4343 APT\" of Autodesk wrote it, add `--dialect autodesk`; else "
        } else {
            ""
        };
        let help = format!(
            "{post}state their meaning, measured from a GOTO at the top of the hole, in the configuration: `[cl.cycle.{word}]`, \
             `args = [{example}]`, or another order of {names}",
            names = CycleArg::NAMES.map(|(name, _)| name).join(", ")
        );
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
pub(crate) fn with_names(cycle: &CycleCall, args: Option<&[CycleArg]>, dialect: Dialect) -> Result<CycleCall, ClFault> {
    named(cycle, args, dialect).map(|(cycle, _)| cycle)
}

/// Returns the hole that a CYCLE defines.
pub(crate) fn define(cycle: &CycleCall, context: &CycleContext<'_>) -> Result<HoleDefinition, ClFault> {
    let (cycle, pitch) = named(cycle, context.args, context.dialect)?;
    let unit_mm = context.unit_mm;
    let depth = depth(&cycle, context.dialect)? * unit_mm;
    let camplete = context.dialect == Dialect::Autodesk && cycle.positionals == 0;
    let from_bottom = match context.dialect {
        Dialect::Autodesk if !camplete => Some(planes(&cycle, unit_mm)?),
        _ => None,
    };
    let (clearance, back) = match (&cycle, from_bottom) {
        (_, Some(_)) => (0.0, ReturnLevel::Clearance),
        (CycleCall { clear: Some(_), back_to: Some(Return::Level(level)), rapto, .. }, None) if camplete => {
            let clearance = rapto.unwrap_or(0.0);
            if clearance < 0.0 || *level < clearance {
                let text = "RAPTO of this cycle lies below the top of the hole or above RETURN";
                return Err(fault(
                    cycle.at,
                    text,
                    "the tool would plunge into the part at rapid: check RAPTO and RETURN",
                ));
            }
            (clearance * unit_mm, ReturnLevel::Level(level * unit_mm))
        }
        (_, None) => {
            let clearance = clearance(&cycle, context.dialect)? * unit_mm;
            (clearance, back(&cycle, context, clearance)?)
        }
    };
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
        from_bottom,
        returns_at_mm: cycle.clear.filter(|_| camplete).map(|clear| clear * unit_mm),
    })
}

/// A cycle of which no word and none of its numbers is the clearance level.
fn without_clearance(cycle: &CycleCall) -> ClFault {
    let help = if cycle.positionals == 0 {
        "program RAPTO or CLEAR".to_owned()
    } else {
        let word = cycle.kind.word();
        format!("write CLEAR,level in this record, or name the number that is the level in `[cl.cycle.{word}]`, `args`")
    };
    ClFault::new("CYCLE", cycle.at, "this cycle has no clearance level", help)
}

/// Planes of a cycle of Autodesk.
fn planes(cycle: &CycleCall, unit_mm: f64) -> Result<HolePlanes, ClFault> {
    let Some(clear) = cycle.clear else {
        return Err(without_clearance(cycle));
    };
    if cycle.back_to.is_some() || cycle.rapto.is_some_and(|rapto| rapto < 0.0) {
        return Err(fault(
            cycle.at,
            "this cycle has a return level or a negative RAPTO, which the post of Autodesk does not write",
            "does `dialect = \"autodesk\"` hold for this file?",
        ));
    }
    let below = cycle.rapto.unwrap_or(0.0);
    Ok(HolePlanes { clearance_mm: clear * unit_mm, feed_begins_mm: (clear - below) * unit_mm })
}

/// Depth below the point of the GOTO, in units of the file, above 0.
fn depth(cycle: &CycleCall, dialect: Dialect) -> Result<f64, ClFault> {
    let value = match (cycle.fedto, cycle.depth, dialect) {
        (Some(fedto), None, Dialect::Nx) => -fedto,
        (Some(fedto), None, Dialect::SolidWorks | Dialect::Autodesk) => fedto,
        (Some(_), ..) => {
            return Err(fault(
                cycle.depth_at,
                "the sign of FEDTO depends on the CAM system, and that of this file is unknown",
                "add `--dialect nx` (negative is into the part), `--dialect solidworks` or `autodesk` (positive)",
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
            "write the depth in this record, or set it in the CAM system and output the file again",
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
                "delete the one that is not the level above the hole at which the feed begins",
            ));
        }
        (Some(_), None) => {
            return Err(fault(cycle.at, "RAPTO without CLEAR: the clearance level is unknown", "program CLEAR"));
        }
        (None, None) => return Err(without_clearance(cycle)),
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
    if cycle.kind == ClCycleKind::Back {
        return Err(fault(
            cycle.at,
            "back boring leads the tool off the centre through the hole: its CL data does not state how wide that is",
            "write the motions themselves as GOTO, or program this cycle at the control",
        ));
    }
    if cycle.orient_deg.is_some() && cycle.kind != ClCycleKind::Bore {
        return Err(fault(
            cycle.at,
            format!("ORIENT stops the spindle at an angle, which does not belong to {}", cycle.kind.word()),
            "write BORE with ORIENT, or this cycle without it",
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
        ClCycleKind::Bore => match cycle.orient_deg {
            Some(orient) => Drilling::FineBore { orient_rad: orient.to_radians() },
            None => Drilling::Ream,
        },
        ClCycleKind::Ream | ClCycleKind::Back => Drilling::Ream,
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
