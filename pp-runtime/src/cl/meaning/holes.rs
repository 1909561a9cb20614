//! Meaning of a CYCLE in each CAM system: levels along the tool axis, measured from the point of each GOTO.
//!
//! The post *Common ISO 4343 APT* of Autodesk writes `CYCLE/DRILL, depth, MMPM, feed, clearance[, RAPTO, r]` and, as
//! GOTO, the point of `onCyclePoint`, which is the bottom: its other posts write its Z after G81. Clearance is the Z of
//! the plane between the holes (`cycle.clearance`), and the feed begins r below it (`cycle.clearance - cycle.retract`).
//! A section with a tilted plane is rotated about the origin (`setRotation`), so the coordinate of a plane counts along
//! the tool axis there, too. *Generative Machining APT* of HSMWorks writes the same text with the top as point and
//! other levels, so neither is read unless it is given.
//!
//! *CAMplete APT* of Autodesk writes `CYCLE/DRILL, FEDTO, depth, MMPM, feed, CLEAR, z, RETURN, r[, RAPTO, p]` and, as
//! GOTO, the top (`cycle.stock`): r is `clearance - stock`, p `retract - stock`, absent where it is 0, and z the Z of
//! the clearance plane, which is r above the point. Earlier versions write RTRCTO for DRILL only: without a return
//! level the tool returns to the plane, and without RAPTO the feed begins there.

use crate::cl::dialect::Dialect;
use crate::cl::record::{ClCycleKind, CycleCall, FeedUnit, Return, ThreadPitch, word_of};
use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::kinematics::{Pose, math};
use crate::nalgebra::Point3;
use crate::program::{Drilling, Dwell, Feed, Gap, Gaps, Units};

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
    /// The levels depend on a plane across the tool axis (posts of Autodesk).
    pub(crate) plane: Option<ClearanceAt>,
}

/// The plane between the holes, by its coordinate along the tool axis, and what the points of its cycle are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ClearanceAt {
    plane_mm: f64,
    points: CyclePoints,
}

/// What the points of a cycle with a clearance plane are.
#[derive(Debug, Clone, Copy, PartialEq)]
enum CyclePoints {
    /// The bottoms of the holes; the feed begins so far below the plane (*Common ISO 4343 APT*).
    Bottoms { feed_begins_below_mm: f64 },
    /// Their tops; the feed begins so far above them, or at the plane, and the return level, if the record states it,
    /// must be the plane (*CAMplete APT*).
    Tops { feed_begins_mm: Option<f64>, return_mm: Option<f64> },
}

impl HoleDefinition {
    /// The hole at a point of the cycle: its top, and its definition from there. `before`: position of the tool before
    /// the cycle.
    pub(crate) fn at(
        self,
        point: Pose,
        before: Option<Point3<f64>>,
        units: Units,
        at: Span,
    ) -> Result<(Pose, HoleDefinition), ClFault> {
        /// Largest difference of a level from that of the tool, by the digits of CL data.
        const SAME_LEVEL_MM: f64 = 1e-3;
        let Some(ClearanceAt { plane_mm, points }) = self.plane else { return Ok((point, self)) };
        let along = |tip: Point3<f64>| tip.coords.dot(&point.axis);
        let tip = match points {
            CyclePoints::Bottoms { .. } => point.tip + point.axis.into_inner() * self.depth_mm,
            CyclePoints::Tops { .. } => point.tip,
        };
        let to_plane_mm = plane_mm - along(tip);
        let (clearance_mm, return_mm) = match points {
            CyclePoints::Bottoms { .. } if before.is_none_or(|before| along(before) < plane_mm - SAME_LEVEL_MM) => {
                return Err(fault(
                    at,
                    format!(
                        "the tool is below the clearance plane of this cycle, {} along its axis, before it",
                        units.length(plane_mm)
                    ),
                    format!(
                        "write a GOTO at or above that plane before the cycle, as the post of Autodesk does; {OF_ANOTHER_POST}"
                    ),
                ));
            }
            CyclePoints::Bottoms { feed_begins_below_mm } => (to_plane_mm - feed_begins_below_mm, to_plane_mm),
            CyclePoints::Tops { return_mm: Some(level), .. } if (level - to_plane_mm).abs() > 2.0 * SAME_LEVEL_MM => {
                return Err(fault(
                    at,
                    format!(
                        "this point is not the top of its hole: {} above it is {} along the tool axis, and CLEAR is {}",
                        units.length(level),
                        units.length(along(tip) + level),
                        units.length(plane_mm)
                    ),
                    format!(
                        "in \"CAMplete APT\" of Autodesk CLEAR is RETURN above the point: correct the one that is wrong; \
                         {OF_ANOTHER_POST}"
                    ),
                ));
            }
            CyclePoints::Tops { feed_begins_mm, return_mm } => {
                (feed_begins_mm.unwrap_or(to_plane_mm), return_mm.unwrap_or(to_plane_mm))
            }
        };
        if clearance_mm < 0.0 || return_mm < clearance_mm {
            return Err(fault(
                at,
                format!(
                    "the feed of this hole begins {} above its top, below it or above the clearance plane",
                    units.deviation(clearance_mm)
                ),
                format!(
                    "the tool would plunge into the part at rapid: correct the clearance plane or RAPTO; {OF_ANOTHER_POST}"
                ),
            ));
        }
        let return_level = ReturnLevel::Level(return_mm);
        Ok((Pose { tip, ..point }, HoleDefinition { clearance_mm, return_level, ..self }))
    }
}

/// State on which the meaning of a CYCLE depends besides its record.
pub(crate) struct CycleContext {
    pub(crate) dialect: Dialect,
    /// mm in one unit of the file.
    pub(crate) unit_mm: f64,
    /// CYCLE/INIT (true) or CYCLE/CLEAR (false) before the cycle.
    pub(crate) initial: Option<bool>,
    /// Feed of the record.
    pub(crate) feed: Option<Feed>,
}

fn fault(at: Span, text: impl Into<String>, help: impl Into<String>) -> ClFault {
    cl::HOLE.cl_fault("CYCLE", at, text, help)
}

/// Remedy where a cycle is not as the posts of Autodesk write it.
pub(crate) const OF_ANOTHER_POST: &str = "if another post wrote the file, add `--dialect iso`, and name numbers without a word in \
                                          `[cl.cycle.DRILL]`, `args`";

/// Numbers without a word of *Common ISO 4343 APT*.
const OF_AUTODESK: [CycleArg; 2] = [CycleArg::Depth, CycleArg::Clearance];

/// Returns the record with the numbers without a word under their configured meaning. They fill what the record does
/// not state.
pub(crate) fn with_names(cycle: &CycleCall, args: Option<&[CycleArg]>, dialect: Dialect) -> Result<CycleCall, ClFault> {
    let mut cycle = *cycle;
    if cycle.positionals == 0 {
        return Ok(cycle);
    }
    let of_autodesk = (dialect == Dialect::Autodesk).then_some(&OF_AUTODESK[..]);
    let Some(args) = args.or(of_autodesk).filter(|args| args.len() == usize::from(cycle.positionals)) else {
        return Err(without_words(&cycle, dialect));
    };
    for (arg, value) in args.iter().zip(cycle.positional) {
        let stated = match arg {
            CycleArg::Depth => cycle.fedto.or(cycle.depth.replace(value)).is_some(),
            CycleArg::Clearance => cycle.clear.replace(value).is_some(),
            CycleArg::Step => cycle.step.replace(value).is_some(),
            CycleArg::Dwell => cycle.dwell.replace(Dwell::Seconds(value)).is_some(),
            CycleArg::Pitch => cycle.pitch.replace(ThreadPitch::PerRevolution(value)).is_some(),
            CycleArg::Return => cycle.back_to.replace(Return::Level(value)).is_some(),
            CycleArg::Feed => cycle.feed.replace((value, FeedUnit::PerMinute)).is_some(),
        };
        if stated {
            let (word, name) = (cycle.kind.word(), word_of(&CycleArg::NAMES, arg));
            return Err(cl::HOLE.cl_fault(
                "CYCLE",
                cycle.at,
                format!(
                    "the {name} of this cycle is stated twice: by a word, and by a number without one that `args` names"
                ),
                format!(
                    "a setting never replaces what the file states: delete the word with its number here, or that number and its \
                     \"{name}\" in `[cl.cycle.{word}]`, `args`"
                ),
            ));
        }
    }
    Ok(cycle)
}

/// Numbers without a word whose meaning is not known.
fn without_words(cycle: &CycleCall, dialect: Dialect) -> ClFault {
    let word = cycle.kind.word();
    let text = format!(
        "CYCLE/{word} has {} numbers without a word, whose meaning depends on a table of the CAM system",
        cycle.positionals
    );
    let example = match cycle.positionals {
        1 => "\"depth\"",
        2 => "\"depth\", \"clearance\"",
        _ => "\"depth\", \"clearance\", ..",
    };
    let post = if usize::from(cycle.positionals) == OF_AUTODESK.len() && dialect == Dialect::Generic {
        "if \"Common ISO 4343 APT\" of Autodesk wrote it, add `--dialect autodesk`; else add `--dialect iso` and "
    } else if dialect == Dialect::Generic {
        "add `--dialect iso` and "
    } else {
        ""
    };
    let help = format!(
        "{post}state their meaning, measured from a GOTO at the top of the hole, in the configuration: `[cl.cycle.{word}]`, \
         `args = [{example}]`, or another order of {names}",
        names = CycleArg::NAMES.map(|(name, _)| name).join(", ")
    );
    cl::HOLE.cl_fault("CYCLE", cycle.at, text, help)
}

/// Returns the hole that a CYCLE defines. Its numbers without a word have their names: see [`with_names`].
pub(crate) fn define(cycle: &CycleCall, context: &CycleContext) -> Result<HoleDefinition, ClFault> {
    let unit_mm = context.unit_mm;
    let first_depth = depth(cycle, context)?;
    let plane = match context.dialect {
        Dialect::Autodesk if cycle.positionals > 0 => Some(plane_above_bottoms(cycle, unit_mm)?),
        Dialect::Autodesk if cycle.clear.is_some() => Some(plane_above_tops(cycle, unit_mm)?),
        _ => None,
    };
    let (clearance, back) = match plane {
        Some(_) => (0.0, ReturnLevel::Clearance),
        None => {
            let clearance = clearance(cycle, context.dialect)? * unit_mm;
            (clearance, back(cycle, context, clearance)?)
        }
    };
    let (depth, gaps) = plates(cycle, first_depth, clearance, context)?;
    let drilling = drilling(cycle, context.feed, unit_mm)?;
    // The feed of a thread is its pitch; the feed in force is that of other motions.
    let feed = match drilling {
        Drilling::Tap { pitch_mm: Some(pitch_mm) } => context.feed.or(Some(Feed::PerRevolution(pitch_mm))),
        _ => context.feed,
    };
    let drilling = gaps.map_or(drilling, |gaps| Drilling::Through { gaps });
    let dwell = match cycle.dwell {
        Some(Dwell::Seconds(value) | Dwell::Revolutions(value)) if value < 0.0 => {
            return Err(fault(cycle.at, "DWELL must not be negative", "write DWELL,seconds"));
        }
        Some(Dwell::Seconds(value) | Dwell::Revolutions(value)) if value > 0.0 => cycle.dwell,
        _ => None,
    };
    Ok(HoleDefinition { depth_mm: depth, clearance_mm: clearance, return_level: back, drilling, feed, dwell, plane })
}

/// A cycle of which no word and none of its numbers is the clearance level.
fn without_clearance(cycle: &CycleCall) -> ClFault {
    let help = if cycle.positionals == 0 {
        "program RAPTO or CLEAR".to_owned()
    } else {
        let word = cycle.kind.word();
        format!("write CLEAR,level in this record, or name the number that is the level in `[cl.cycle.{word}]`, `args`")
    };
    cl::HOLE.cl_fault("CYCLE", cycle.at, "this cycle has no clearance level", help)
}

/// Plane of a cycle of *Common ISO 4343 APT*, whose points are the bottoms.
fn plane_above_bottoms(cycle: &CycleCall, unit_mm: f64) -> Result<ClearanceAt, ClFault> {
    let Some(clear) = cycle.clear else {
        return Err(without_clearance(cycle));
    };
    if cycle.back_to.is_some() || cycle.rapto.is_some_and(|rapto| rapto < 0.0) {
        return Err(fault(
            cycle.at,
            "this cycle has a return level or a negative RAPTO, which the post of Autodesk does not write",
            format!("delete the return level, and the sign of RAPTO; {OF_ANOTHER_POST}"),
        ));
    }
    let points = CyclePoints::Bottoms { feed_begins_below_mm: cycle.rapto.unwrap_or(0.0) * unit_mm };
    Ok(ClearanceAt { plane_mm: clear * unit_mm, points })
}

/// Plane of a cycle of *CAMplete APT*, whose points are the tops.
fn plane_above_tops(cycle: &CycleCall, unit_mm: f64) -> Result<ClearanceAt, ClFault> {
    let Some(clear) = cycle.clear else {
        return Err(without_clearance(cycle));
    };
    let return_mm = match cycle.back_to {
        Some(Return::Level(level)) => Some(level * unit_mm),
        Some(Return::Auto) => return Err(auto_of_nx(cycle)),
        None => None,
    };
    // With a return level an absent RAPTO is 0.
    let feed_begins_mm = cycle.rapto.map(|rapto| rapto * unit_mm).or(return_mm.map(|_| 0.0));
    if let (Some(begins), Some(level)) = (feed_begins_mm, return_mm)
        && (begins < 0.0 || level < begins)
    {
        let text = "RAPTO of this cycle lies below the top of the hole or above RETURN";
        return Err(fault(cycle.at, text, "the tool would plunge into the part at rapid: check RAPTO and RETURN"));
    }
    Ok(ClearanceAt { plane_mm: clear * unit_mm, points: CyclePoints::Tops { feed_begins_mm, return_mm } })
}

/// Largest difference of two depths that are the same by their digits.
const SAME_DEPTH_MM: f64 = 2e-3;

/// Depth of a countersink by its diameter and the angle of its tool, units of the file (*CL Output for Holemaking
/// Cycles* of PTC).
fn depth_of_cone(cycle: &CycleCall) -> Result<Option<f64>, ClFault> {
    let (diameter, angle) = match (cycle.diameter, cycle.tool_angle_deg) {
        (None, None) => return Ok(None),
        (Some(diameter), Some(angle)) => (diameter, angle),
        (Some(_), None) | (None, Some(_)) => {
            return Err(fault(
                cycle.at,
                "DIAMET and TLANGL state the depth of a countersink together, and one of them is absent",
                "program both, or DEPTH alone",
            ));
        }
    };
    if cycle.kind != ClCycleKind::Csink {
        return Err(fault(
            cycle.at,
            format!("DIAMET and TLANGL state the depth of a countersink, which {} is not", cycle.kind.word()),
            "write CSINK with DIAMET and TLANGL, or this cycle with DEPTH",
        ));
    }
    if diameter <= 0.0 || angle <= 0.0 || angle >= 180.0 {
        return Err(fault(
            cycle.at,
            "a countersink needs a diameter above 0 and an angle between 0 and 180 degrees",
            "DIAMET is its diameter at the top of the hole, TLANGL the whole angle of the tool in degrees",
        ));
    }
    let (sine, cosine) = math::sin_cos(0.5 * angle.to_radians());
    Ok(Some(0.5 * diameter * cosine / sine))
}

/// Depth below the point of the GOTO, in units of the file, above 0.
fn depth(cycle: &CycleCall, context: &CycleContext) -> Result<f64, ClFault> {
    let cone = depth_of_cone(cycle)?;
    let value = match (cycle.fedto, cycle.depth.or(cone.filter(|_| cycle.fedto.is_none())), context.dialect) {
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
    if let Some(cone) = cone
        && (value - cone).abs() * context.unit_mm > SAME_DEPTH_MM
    {
        return Err(fault(
            cycle.depth_at,
            format!("this depth is {value}, and by DIAMET and TLANGL it is {cone:.4}"),
            "delete the one that is wrong: DEPTH, or DIAMET and TLANGL",
        ));
    }
    Ok(value)
}

/// Depth of the hole and, where THRU states several depths, the gaps between its plates. The numbers are the bottom of
/// the first plate, then top and bottom of each further one: feed to the bottom, rapid to CLEAR above the next top.
/// `THRU` is "for multiple plates" (*Holemaking Cycle Types* of PTC, *Drill, Web*); the order of the numbers is that of
/// files, not of a text that was read, so they must ascend. `clearance`: the clearance level, mm.
fn plates(
    cycle: &CycleCall,
    first: f64,
    clearance: f64,
    context: &CycleContext,
) -> Result<(f64, Option<Gaps>), ClFault> {
    let (unit_mm, further) = (context.unit_mm, cycle.further_depths());
    if further.is_empty() {
        return Ok((first * unit_mm, None));
    }
    if context.dialect != Dialect::Creo {
        return Err(fault(
            cycle.depth_at,
            "several numbers after DEPTH: what they mean is known of Creo only",
            "if Creo wrote this file, add `--dialect creo`; else write the motions of this hole as GOTO",
        ));
    }
    if further.len() % 2 != 0 {
        return Err(fault(
            cycle.depth_at,
            format!("THRU with {} depths: a plate is incomplete", further.len() + 1),
            "write the bottom of the first plate, then top and bottom of each further one: DEPTH,12,20,32",
        ));
    }
    let mut bottom = first;
    let mut gaps = Vec::with_capacity(further.len() / 2);
    for plate in further.chunks_exact(2) {
        if !(bottom < plate[0] && plate[0] < plate[1]) {
            return Err(fault(
                cycle.depth_at,
                "the depths of this THRU do not increase",
                "write them from the top: bottom of the first plate, then top and bottom of each further one",
            ));
        }
        let feed_begins_mm = plate[0] * unit_mm - clearance;
        gaps.push(Gap { feed_ends_mm: bottom * unit_mm, feed_begins_mm });
        bottom = plate[1];
    }
    Ok((bottom * unit_mm, Gaps::of(&gaps)))
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

fn auto_of_nx(cycle: &CycleCall) -> ClFault {
    fault(cycle.at, "RTRCTO,AUTO is supported for NX only", "program RETURN,level")
}

fn back(cycle: &CycleCall, context: &CycleContext, clearance: f64) -> Result<ReturnLevel, ClFault> {
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
        (_, Some(Return::Auto)) => return Err(auto_of_nx(cycle)),
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

/// Pitch of a thread, mm per revolution, where the record states it. Two words for it must agree.
fn pitch(cycle: &CycleCall, feed: Option<Feed>, unit_mm: f64) -> Result<Option<f64>, ClFault> {
    /// Largest relative difference of two pitches that are the same by their digits.
    const SAME_PITCH: f64 = 1e-3;
    let stated = match cycle.pitch {
        Some(ThreadPitch::PerRevolution(pitch)) => Some(pitch * unit_mm),
        Some(ThreadPitch::ThreadsPerInch(count)) if count <= 0.0 => {
            return Err(fault(cycle.at, "TPI must be above 0", "write the threads per inch: TPI,20"));
        }
        // An inch, whatever the unit of the file.
        Some(ThreadPitch::ThreadsPerInch(count)) => Some(Units::Inches.in_mm() / count),
        None => None,
    };
    match (feed, stated) {
        (Some(Feed::PerRevolution(feed)), Some(pitch)) if (pitch / feed - 1.0).abs() > SAME_PITCH => Err(fault(
            cycle.at,
            "this cycle states two pitches",
            "program one of PITCH, TPI and a feed per revolution (MMPR, IPR)",
        )),
        (Some(Feed::PerRevolution(feed)), _) => Ok(Some(feed)),
        (_, stated) => Ok(stated),
    }
}

fn drilling(cycle: &CycleCall, feed: Option<Feed>, unit_mm: f64) -> Result<Drilling, ClFault> {
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
    if cycle.pitch.is_some() && cycle.kind != ClCycleKind::Tap {
        return Err(fault(
            cycle.at,
            format!("PITCH and TPI are those of a thread, which {} does not make", cycle.kind.word()),
            "write TAP with PITCH or TPI, or this cycle without them",
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
        ClCycleKind::Tap => Drilling::Tap { pitch_mm: pitch(cycle, feed, unit_mm)? },
    })
}
