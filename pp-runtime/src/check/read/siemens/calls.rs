//! Calls of a Siemens control by their lists of arguments: cycles at a point, CYCLE800, CYCLE832, MSG.

use super::super::block::{BlankPart, CycleKind, FineBore, PathSmoothing};
use super::super::frames;
use super::super::language::arguments::{ArgumentSlot, Item, SLOTS, WORKPIECE};
use super::super::language::{ArgumentRole, List};
use super::super::line::Line;
use super::super::orders::{Cycle, ModeOrder, TiltCode};
use super::super::text::same;
use super::Calls;
use crate::program::{Rotation, Units};

/// Numbers of a call by their slots.
struct CallNumbers([Option<f64>; SLOTS]);

/// An argument of a call.
enum Argument<'a> {
    Gap,
    Number(f64),
    Text(&'a [u8]),
}

impl CallNumbers {
    fn get(&self, slot: ArgumentSlot) -> Option<f64> {
        self.0[slot as usize]
    }

    /// One that the list needs.
    fn value(&self, slot: ArgumentSlot) -> f64 {
        self.get(slot).unwrap_or_default()
    }
}

/// `NAME(..)`, from the bracket on; its name begins at `start`. `false` if it is not known.
pub(super) fn call(line: &mut Line<'_>, name: &[u8], calls: &mut Calls, start: usize) -> bool {
    let Some(list) = line.language().lists.iter().find(|list| list.name.as_bytes().eq_ignore_ascii_case(name)) else {
        return false;
    };
    if list.number == WORKPIECE {
        let part = workpiece(line);
        part.into_iter().for_each(|part| line.orders.mode(ModeOrder::Blank(part)));
        return part.is_some();
    }
    // A plane and smoothing are switched in a block of their own.
    if matches!(list.number, 800 | 832) {
        line.words.calls.push(start);
    }
    line.at.skip(1);
    line.at.blanks();
    if line.at.take(b')') {
        match list.number {
            800 => line.tilt(TiltCode::Off),
            832 => line.orders.mode(ModeOrder::Smoothing(PathSmoothing::Off, None)),
            0 => {}
            _ => return false,
        }
        return true;
    }
    let numbers = arguments(line, list);
    match (list.number, &numbers) {
        (_, None) => {
            line.at.take_rest();
            line.fault(start, format!("arguments of {} that the check cannot read", list.name));
        }
        (0, _) => {}
        (800, Some(numbers)) => swivel(line, numbers),
        (832, Some(numbers)) => smooth(line, numbers),
        (number, Some(numbers)) => {
            if std::mem::replace(&mut calls.has_cycle, true) {
                line.fault(start, "two cycles in one block");
            }
            calls.cycle = cycle(line, number, numbers);
        }
    }
    true
}

/// `(,"",,"BOX",112,ZA,ZI,-80,XA,YA,XI,YI)` or `(,"",,"CYLINDER",192,ZA,ZI,ZB,XA)`.
fn workpiece(line: &mut Line<'_>) -> Option<BlankPart> {
    let rest = line.at.rest();
    let end = rest.iter().position(|byte| *byte == b')')?;
    let text = std::str::from_utf8(&rest[..end]).ok()?;
    let round = text.starts_with("(,\"\",,\"CYLINDER\",192,");
    let numbers = text.strip_prefix(if round { "(,\"\",,\"CYLINDER\",192," } else { "(,\"\",,\"BOX\",112," })?;
    let numbers: Vec<f64> = numbers.split(',').map(|number| number.parse().ok()).collect::<Option<_>>()?;
    line.at.skip(end + 1);
    match (round, &numbers[..]) {
        (true, &[top, bottom, end, diameter]) if (bottom - end).abs() <= 0.0 => {
            Some(BlankPart::cylinder(0.5 * diameter, bottom, top))
        }
        (false, &[top, bottom, _, x, y, to_x, to_y]) => {
            Some(BlankPart::Whole { lower: [x, y, bottom], upper: [to_x, to_y, top], round: false })
        }
        _ => None,
    }
}

/// The arguments up to the closing bracket, each by its role.
fn arguments(line: &mut Line<'_>, list: &List) -> Option<CallNumbers> {
    let mut numbers = CallNumbers([None; SLOTS]);
    let mut index = 0;
    loop {
        line.at.blanks();
        let argument = match line.at.peek()? {
            b',' | b')' => Argument::Gap,
            b'"' => {
                let rest = &line.at.rest()[1..];
                let end = rest.iter().position(|byte| *byte == b'"')?;
                line.at.skip(end + 2);
                Argument::Text(&rest[..end])
            }
            _ => Argument::Number(line.at.number()?.value),
        };
        let item = list.items.get(index)?;
        take(line, list, item, &argument, &mut numbers);
        index += 1;
        line.at.blanks();
        if line.at.take(b')') {
            break;
        }
        line.at.take(b',').then_some(())?;
    }
    for item in &list.items[index..] {
        take(line, list, item, &Argument::Gap, &mut numbers);
    }
    Some(numbers)
}

fn take(line: &mut Line<'_>, list: &List, item: &Item, argument: &Argument<'_>, numbers: &mut CallNumbers) {
    let expected = match (item.role, argument) {
        (ArgumentRole::Whole(slot), Argument::Number(value)) if value.fract() == 0.0 => {
            numbers.0[slot as usize] = Some(*value);
            return;
        }
        (ArgumentRole::Whole(_), _) => "a whole number".to_owned(),
        (ArgumentRole::Needs(slot) | ArgumentRole::Takes(slot), Argument::Number(value)) => {
            numbers.0[slot as usize] = Some(*value);
            return;
        }
        (ArgumentRole::Must(wanted) | ArgumentRole::May(wanted), Argument::Number(value)) if same(wanted, *value) => {
            return;
        }
        (ArgumentRole::Takes(_) | ArgumentRole::May(_) | ArgumentRole::Empty, Argument::Gap) => return,
        (ArgumentRole::Name, Argument::Text(name)) if *name == line.vocabulary().swivel_data.as_bytes() => return,
        (ArgumentRole::Text, Argument::Text(_)) => return,
        (ArgumentRole::Must(wanted) | ArgumentRole::May(wanted), _) => wanted.to_string(),
        (ArgumentRole::Needs(_) | ArgumentRole::Takes(_), _) => "a number".to_owned(),
        (ArgumentRole::Empty, _) => "no value".to_owned(),
        (ArgumentRole::Name, _) => format!("\"{}\"", line.vocabulary().swivel_data),
        (ArgumentRole::Text, _) => "a text".to_owned(),
    };
    let found = match argument {
        Argument::Gap => "missing".to_owned(),
        Argument::Number(value) => value.to_string(),
        Argument::Text(text) => format!("\"{}\"", String::from_utf8_lossy(text)),
    };
    line.fault(0, format!("{} of {} is {found}, expected {expected}", item.name, list.name));
}

/// CYCLE81 and its kin.
fn cycle(line: &mut Line<'_>, number: u32, numbers: &CallNumbers) -> Option<Cycle> {
    let surface = numbers.value(ArgumentSlot::Surface);
    let clearance = numbers.value(ArgumentSlot::Clearance);
    let bottom = match (numbers.get(ArgumentSlot::Bottom), numbers.get(ArgumentSlot::Depth)) {
        (Some(bottom), None) => bottom,
        (None, Some(depth)) if depth >= 0.0 => surface - depth,
        _ => {
            line.fault(0, "the depth of the cycle: expected DP or DPR");
            return None;
        }
    };
    if clearance < 0.0 {
        line.fault(0, format!("SDIS is {clearance}, expected 0 or more"));
    }
    let (mut feed, mut gap) = (None, None);
    let kind = match number {
        81 | 82 => CycleKind::Drill,
        83 => {
            let step = numbers.value(ArgumentSlot::Step);
            if step <= 0.0 {
                line.fault(0, format!("FDPR is {step}, expected more than 0"));
            }
            match numbers.value(ArgumentSlot::Variant) {
                1.0 => {
                    gap = numbers.get(ArgumentSlot::Gap);
                    CycleKind::Peck(step)
                }
                variant => {
                    gap = numbers.get(ArgumentSlot::OtherGap);
                    if variant != 0.0 {
                        line.fault(0, format!("VARI is {variant}, expected 0 or 1"));
                    }
                    CycleKind::ChipBreak(step)
                }
            }
        }
        84 => thread(line, numbers),
        86 => {
            sense(line, "SDIR", numbers);
            let shift = [ArgumentSlot::ShiftX, ArgumentSlot::ShiftY].map(|slot| numbers.value(slot));
            CycleKind::FineBore(FineBore::by_shift(shift, Some(numbers.value(ArgumentSlot::Angle))))
        }
        85 => {
            let (into, out) = (numbers.value(ArgumentSlot::Feed), numbers.value(ArgumentSlot::FeedOut));
            if !same(into, out) {
                line.fault(0, format!("RFF of CYCLE85 is {out}, expected {into} as FFR"));
            }
            feed = Some(into);
            CycleKind::Ream
        }
        _ => return None,
    };
    let (reference, back) = (surface + clearance, numbers.value(ArgumentSlot::Return));
    if back < reference && !same(back, reference) {
        line.fault(
            0,
            format!(
                "RTP is {back}, below the reference plane {reference}: the rapid after the cycle leads into the part"
            ),
        );
    }
    let back_to = Some(back);
    Some(Cycle { kind, reference, bottom, back_to, dwell: numbers.value(ArgumentSlot::Dwell), feed, gap })
}

/// The sense of rotation in a cycle is that of the spindle.
fn sense(line: &mut Line<'_>, name: &str, numbers: &CallNumbers) {
    let sense = match numbers.value(ArgumentSlot::Sense) {
        3.0 => Rotation::Clockwise,
        4.0 => Rotation::CounterClockwise,
        other => return line.fault(0, format!("{name} is {other}, expected 3 or 4")),
    };
    if line.machine().state().spindle.flatten().is_some_and(|rotates| rotates != sense) {
        line.fault(0, format!("{name} is not the sense in which the spindle rotates"));
    }
}

/// CYCLE84: the pitch in the unit of the program. Sense and speeds are those of the spindle.
fn thread(line: &mut Line<'_>, numbers: &CallNumbers) -> CycleKind {
    sense(line, "SDAC", numbers);
    let state = line.machine().state();
    let speed = numbers.value(ArgumentSlot::Speed);
    let out = numbers.value(ArgumentSlot::SpeedOut);
    let wanted = state.speed.unwrap_or(speed);
    if !same(speed, wanted) || !same(out, wanted) {
        line.fault(0, format!("SST and SST1 are {speed} and {out}, expected S of the spindle, {wanted}"));
    }
    let unit = match numbers.get(ArgumentSlot::PitchUnit) {
        None => line.machine().unit(),
        Some(1.0) => 1.0,
        Some(3.0) => Units::Inches.in_mm(),
        Some(other) => {
            line.fault(0, format!("_PITA is {other}, expected 1 (mm) or 3 (inches)"));
            1.0
        }
    };
    CycleKind::Tap(numbers.value(ArgumentSlot::Pitch) * unit / line.machine().unit())
}

/// CYCLE800 with a new plane, axis by axis.
fn swivel(line: &mut Line<'_>, numbers: &CallNumbers) {
    let angles = [ArgumentSlot::A, ArgumentSlot::B, ArgumentSlot::C].map(|slot| numbers.value(slot));
    let vector = |slots: [ArgumentSlot; 3]| nalgebra::Vector3::from(slots.map(|slot| numbers.value(slot)));
    let mode = numbers.value(ArgumentSlot::Mode);
    let rotation = if mode >= 0.0 && mode.fract() == 0.0 { frames::axis_by_axis(mode as u32, angles) } else { None };
    let Some(rotation) = rotation else {
        return line.fault(0, format!("_MODE of CYCLE800 is {mode}, expected one axis by axis: 57 or 27"));
    };
    let origin = vector([ArgumentSlot::X0, ArgumentSlot::Y0, ArgumentSlot::Z0])
        + rotation * vector([ArgumentSlot::X1, ArgumentSlot::Y1, ArgumentSlot::Z1]);
    let direction = numbers.value(ArgumentSlot::Direction);
    let pose = match direction {
        -1.0 => Some(false),
        1.0 => Some(true),
        0.0 => None,
        _ => return line.fault(0, format!("_DIR of CYCLE800 is {direction}, expected -1, 0 or 1")),
    };
    let oriented = pose.is_some();
    let tilt = TiltCode::On { rotation, origin, oriented, pose, rotates_table: false };
    line.tilt(tilt);
}

/// CYCLE832: units of the second argument are the level, tens whether the third is an angle.
fn smooth(line: &mut Line<'_>, numbers: &CallNumbers) {
    let mode = numbers.value(ArgumentSlot::Mode);
    let angle = numbers.get(ArgumentSlot::AxisTolerance);
    let level = match mode {
        0.0 => None,
        1.0 | 2.0 | 3.0 | 4.0 if angle.is_some_and(|angle| same(angle, 1.0)) => Some(mode as u8),
        1.0 | 2.0 | 3.0 | 4.0 if angle.is_none() => {
            return line
                .fault(0, "CYCLE832 without S_OTOL, its third argument: 1 where no rotary axis has a tolerance");
        }
        11.0 | 12.0 | 13.0 | 14.0 if angle.is_some() => Some(mode as u8 % 10),
        _ => return line.fault(0, format!("S_TOLM of CYCLE832 is {mode}, expected 0 to 4, or 11 to 14 with S_OTOL")),
    };
    let angle_rad = angle.filter(|_| mode > 10.0).map(f64::to_radians);
    let tolerance_mm = Some(numbers.value(ArgumentSlot::Tolerance) * line.machine().unit());
    let smoothing = match level {
        Some(_) => PathSmoothing::On { tolerance_mm, level },
        None => PathSmoothing::Off,
    };
    line.orders.mode(ModeOrder::Smoothing(smoothing, angle_rad));
}
