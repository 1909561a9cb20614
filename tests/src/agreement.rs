//! Comparison of two readers of one program: the product's own and the foreign interpreter, motion by motion.
//!
//! Compared are kind, axis words, positions where both readers know them, F and feed mode, circle, hole, and the modal
//! state during the motion. The readers share no code.

use approx::{abs_diff_eq, relative_eq};
use pp_runtime::check::blocks;
use pp_runtime::check::read::{self, Action, Block, coolant};
use pp_runtime::config::Config;
use pp_runtime::control::Control;
use pp_runtime::kinematics::{AxisKind, Machine};
use pp_runtime::program::{Rotation, Units};

use crate::foreign::state::{self, Compensation, CycleKind, Length, Spindle, WorkOffset};
use crate::foreign::{Effect, Executed, Options, run};

/// Optional parts of the comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Compared {
    /// Coolant supplies that are compared, as bits.
    pub coolant: u8,
    /// Whether rotary positions are compared with their whole revolutions. The foreign interpreter has no rollover
    /// axes.
    pub revolutions: bool,
}

impl Compared {
    /// Compares everything.
    pub const ALL: Self = Self { coolant: u8::MAX, revolutions: true };
}

/// Compares the motions of a program and returns their number.
///
/// # Errors
/// First line in which the readers disagree, or that one of them refuses, with the reason.
pub fn compare<M: Machine>(
    text: &str,
    (config, control): (&Config, &dyn Control),
    options: &Options,
    compared: Compared,
) -> Result<usize, String> {
    let trace = run(text, options).map_err(|refused| refused.to_string())?;
    let inches = trace.blocks.iter().any(|block| block.state.units == Some(state::Units::Inches));
    let units = if inches { Units::Inches } else { Units::Millimetres };
    let policy = config.check_policy::<M>(control, Some(units)).map_err(|error| error.to_string())?;
    let read = blocks::<M>(&policy, text.as_bytes()).map_err(|error| error.to_string())?;
    let lines: Vec<&str> = text.lines().collect();
    let idle = |block: &Block| options.idle.iter().any(|code| lines[block.line as usize - 1].ends_with(code));
    if let Some(block) = read.iter().find(|block| !block.faults.is_empty() && !idle(block)) {
        return Err(format!("line {}: {}", block.line, block.faults[0].text));
    }
    let read: Vec<&Block> = read.iter().filter(|block| block.action.moves()).collect();
    let executed: Vec<&Executed> = trace.motions().collect();
    for (block, executed) in read.iter().zip(&executed) {
        let other = (block.line != executed.line as u64)
            .then(|| format!("the foreign interpreter has this motion in line {}", executed.line));
        if let Some(why) = other.or_else(|| difference::<M>(block, executed, compared)) {
            return Err(format!("line {}: {why}\n{block:?}\n{executed:?}", block.line));
        }
    }
    if read.len() != executed.len() {
        return Err(format!("{} motions for the check, {} for the foreign interpreter", read.len(), executed.len()));
    }
    Ok(read.len())
}

fn near(one: f64, other: f64) -> bool {
    relative_eq!(one, other, epsilon = 1e-9, max_relative = 1e-9)
}

/// Whether two angles, rad, are the same direction. The sign of `one` may be the sense of rotation and is then ignored.
fn one_direction(one: f64, other: f64) -> bool {
    let apart = |one: f64| (one - other).sin().hypot((one - other).cos() - 1.0);
    apart(one) < 1e-9 || apart(one.abs()) < 1e-9
}

fn near_or_absent(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => near(one, other),
        _ => one.is_none() && other.is_none(),
    }
}

/// Difference between a motion of the product's reader and one of the foreign interpreter; `None` if they agree.
fn difference<M: Machine>(block: &Block, executed: &Executed, compared: Compared) -> Option<String> {
    let unit = executed.state.units.map_or(1.0, state::Units::in_mm);
    let machine = executed.effect == Effect::Machine;
    for (index, axis) in M::AXES.iter().enumerate() {
        let scale = if axis.kind == AxisKind::Linear { unit } else { 1.0_f64.to_radians() };
        let written = executed.words.contains(axis.letter);
        if written != (block.written & (1 << index) != 0) && !matches!(block.action, Action::Arc(_)) {
            return Some(format!("{} is programmed for one reader only", axis.letter));
        }
        let found = if machine { executed.words.get(axis.letter) } else { executed.state.position.get(axis.letter) };
        let known = if machine { block.written } else { block.known } & (1 << index) != 0;
        let Some(found) = found.filter(|_| known) else {
            let free = !executed.effect.cuts() || axis.kind == AxisKind::Rotary && block.state.tilt.is_some();
            if (written || !free) && executed.effect != Effect::Orient {
                return Some(format!("{} is unknown", axis.letter));
            }
            continue;
        };
        let same = match axis.kind {
            AxisKind::Rotary if !compared.revolutions => one_direction(found.to_radians(), block.values[index]),
            _ => near(found * scale, block.values[index]),
        };
        if !same {
            return Some(format!("{}: {} and {}", axis.letter, found * scale, block.values[index]));
        }
    }
    motion_difference(block, executed, unit).or_else(|| state_difference(block, executed, unit, compared.coolant))
}

fn motion_difference(block: &Block, executed: &Executed, unit: f64) -> Option<String> {
    let same = match (block.action, executed.effect) {
        (Action::Rapid, Effect::Rapid)
        | (Action::Feed, Effect::Feed)
        | (Action::Machine, Effect::Machine)
        | (Action::Orient, Effect::Orient) => true,
        (Action::Arc(one), Effect::Arc(other)) => {
            let [first, second, _] = block.state.plane.expect("a plane of arcs").axes();
            let centres = [first, second].into_iter().all(|index| near(one.centre[index], other.centre[index] * unit));
            centres && abs_diff_eq!(one.sweep.to_degrees(), other.sweep_deg, epsilon = 1e-6)
        }
        (Action::Cycle(one), Effect::Hole(other)) => {
            let kind = match (one.kind, other.cycle.kind) {
                (read::CycleKind::Drill, CycleKind::Drill) | (read::CycleKind::Ream, CycleKind::Ream) => true,
                (read::CycleKind::Peck(one), CycleKind::Peck { step })
                | (read::CycleKind::ChipBreak(one), CycleKind::ChipBreak { step }) => near(one, step * unit),
                (read::CycleKind::Tap(one) | read::CycleKind::FloatingTap(one), CycleKind::Tap { pitch }) => {
                    near(one, pitch * unit)
                }
                _ => false,
            };
            let levels = [
                (one.reference, other.cycle.reference * unit),
                (one.bottom, other.cycle.bottom * unit),
                (one.back_to, other.back_to * unit),
                (one.dwell, other.cycle.dwell_s),
            ];
            kind && levels.into_iter().all(|(one, other)| near(one, other))
                && near_or_absent(one.feed, other.cycle.feed)
        }
        _ => false,
    };
    (!same).then(|| "different motions".to_owned())
}

fn state_difference(block: &Block, executed: &Executed, unit: f64, supplies: u8) -> Option<String> {
    let (one, other) = (&block.state, &executed.state);
    let spindle = match other.spindle {
        None => true,
        Some(Spindle::Off) => one.spindle == Some(None),
        Some(Spindle::Clockwise) => one.spindle == Some(Some(Rotation::Clockwise)),
        Some(Spindle::CounterClockwise) => one.spindle == Some(Some(Rotation::CounterClockwise)),
    };
    let bits = other.coolant.map(|on| {
        let bit = |on: bool, bit: u8| if on { bit } else { 0 };
        bit(on.flood, coolant::FLOOD) | bit(on.mist, coolant::MIST) | bit(on.through, coolant::THROUGH)
    });
    let length = match other.length {
        None => one.length.is_none(),
        Some(Length::Off) => one.length == Some(read::Length::Off),
        Some(Length::Register(register)) => one.length == Some(read::Length::Register(register)),
    };
    let offset = match other.work_offset {
        // A switch of tip control may have cancelled it, and it has not been selected again.
        Some(_) if one.work_offset.is_none() && one.tip_control == read::TipControl::Off => true,
        None => one.work_offset.is_none(),
        Some(WorkOffset::Code(code)) => one.work_offset == Some(read::WorkOffset::Code(code)),
        Some(WorkOffset::Further(number)) => one.work_offset == Some(read::WorkOffset::Further(number)),
        Some(WorkOffset::Row(row)) => one.work_offset == Some(read::WorkOffset::Row(row)),
    };
    let side = match other.compensation {
        None => true,
        Some(Compensation::Off) => one.side == Some(read::SideOfPath::None),
        Some(Compensation::Left(_)) => one.side == Some(read::SideOfPath::Left),
        Some(Compensation::Right(_)) => one.side == Some(read::SideOfPath::Right),
    };
    let tilt = match (one.tilt, other.tilted_plane()) {
        (None, None) => true,
        (Some(one), Some(other)) => {
            let entries = (0..3).flat_map(|row| (0..3).map(move |column| (row, column)));
            let same = |(row, column): (usize, usize)| near(one.rotation[(row, column)], other.rotation[row][column]);
            one.oriented == other.oriented
                && entries.clone().all(same)
                && (0..3).all(|index| near(one.origin[index], other.origin[index] * unit))
        }
        _ => false,
    };
    // A feed of the cycle, or a pitch, replaces the F in force.
    let own = matches!(executed.effect, Effect::Hole(hole) if hole.cycle.feed.is_some()
        || hole.cycle.back_to.is_some() && matches!(hole.cycle.kind, CycleKind::Tap { .. }));
    let feed = !executed.effect.cuts()
        || own
        || near_or_absent(one.feed, other.feed)
            && one.feed_mode.map(|mode| format!("{mode:?}")) == other.feed_mode.map(|mode| format!("{mode:?}"));
    let tip = (one.tip_control != read::TipControl::Off) == other.under_tip_control();
    let checks = [
        (one.tool == other.tool, "tool"),
        (one.plane.map(read::WorkPlane::axes) == other.plane.map(axes_of), "plane"),
        (spindle, "spindle"),
        (near_or_absent(one.speed, other.speed), "speed"),
        (bits.is_none() || one.coolant.map(|on| on & supplies) == bits.map(|on| on & supplies), "coolant"),
        (length, "length"),
        (offset, "work offset"),
        (side, "compensation"),
        (tilt, "tilted plane"),
        (feed, "F"),
        (tip, "tip control"),
        (one.dynamic_offset == other.dynamic_offset, "dynamic work offset"),
    ];
    checks.into_iter().find(|(same, _)| !same).map(|(_, what)| format!("different {what}"))
}

/// First axis, second axis and normal of a plane, as indices into X Y Z.
fn axes_of(plane: state::Plane) -> [usize; 3] {
    plane.letters().map(|letter| "XYZ".find(letter).expect("a linear axis"))
}
