//! Cycles: CYCL DEF with its parameters, by the lists of the language.

use super::super::block::{CycleKind, FineBore, PathSmoothing, WorkOffset};
use super::super::language::arguments::{ArgumentSlot, SLOTS};
use super::super::language::{ArgumentRole, List};
use super::super::line::Line;
use super::super::orders::{Act, Cycle, ModeOrder};
use super::super::text::{Cursor, GOES_ON, same, tenths, whole};
use super::ended;

/// Progress through a cycle of several lines, which follow each other directly.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sequence {
    /// The line that must come next: the number of the cycle in tenths.
    next: Option<u32>,
}

impl Sequence {
    /// Compares a line, from what follows its number, with the one that must come.
    pub(super) fn line(&mut self, line: &mut Line<'_>) {
        let mut at = line.at;
        let part = if at.words("CYCL DEF") { at.spaced_number().and_then(tenths) } else { None };
        let part = part.filter(|part| matches!(part, 90 | 91 | 320..=322));
        let due = std::mem::take(&mut self.next);
        let first = part.filter(|part| !matches!(part, 90 | 320));
        if due.is_some() && due != part {
            line.fault(0, "the cycle before this line is not complete: its lines follow each other directly");
        } else if due != first {
            line.fault(0, "the first line of this cycle is missing before it");
        }
        at.blanks();
        self.next = match part {
            Some(90) => Some(91),
            Some(320) => Some(321),
            // Without a tolerance it is off, and has no mode.
            Some(321) if at.peek() == Some(b'T') => Some(322),
            _ => None,
        };
    }
}

/// Numbers of a cycle by their slots.
struct DefinitionNumbers([f64; SLOTS]);

impl DefinitionNumbers {
    fn get(&self, slot: ArgumentSlot) -> f64 {
        self.0[slot as usize]
    }
}

/// `CYCL DEF 200 DRILLING ~ Q200=+2 ..`, and those of several lines: `CYCL DEF 9.1 DWELL 0.5`.
pub(super) fn define(line: &mut Line<'_>) -> bool {
    let Some(number) = line.at.spaced_number() else { return false };
    let Some(tenths) = tenths(number) else { return false };
    let Some(list) = line.language().lists.iter().find(|list| list.number == tenths) else { return false };
    // The lines of a cycle have a decimal, and a cycle with parameters has none.
    if number.point != list.items.is_empty() {
        return false;
    }
    match tenths {
        90 => line.at.words("DWELL TIME") && ended(line),
        320 => line.at.word(b"TOLERANCE") && ended(line),
        91 => {
            let time = line.at.word(b"DWELL").then(|| line.at.spaced_number()).flatten();
            let Some(time) = time.filter(|time| time.value >= 0.0) else { return false };
            line.orders.act(Act::Dwell(time.value));
            ended(line)
        }
        321 => tolerance(line),
        322 => mode(line),
        _ => parameters(line, list).is_none_or(|numbers| carry_out(line, tenths, &numbers)),
    }
}

/// `32.1 T0.02`; without T smoothing is off.
fn tolerance(line: &mut Line<'_>) -> bool {
    line.at.blanks();
    let tolerance = if line.at.take(b'T') { line.at.spaced_number() } else { None };
    let unit = line.machine().unit();
    let smoothing = match tolerance {
        Some(tolerance) => PathSmoothing::On { tolerance_mm: Some(tolerance.value * unit), level: None },
        None => PathSmoothing::Off,
    };
    line.orders.mode(ModeOrder::Smoothing(smoothing, None));
    ended(line)
}

/// `32.2 HSC-MODE:1 TA0.5`.
fn mode(line: &mut Line<'_>) -> bool {
    let level = line.at.literal(b"HSC-MODE:").then(|| line.at.spaced_number()).flatten().and_then(whole);
    line.at.blanks();
    let angle = if line.at.literal(b"TA") { line.at.spaced_number() } else { None };
    let PathSmoothing::On { tolerance_mm, .. } = line.machine().state().smoothing else { return false };
    let Some(level @ 0..=1) = level else { return false };
    let angle_rad = angle.map(|angle| angle.value.to_radians());
    line.orders.mode(ModeOrder::Smoothing(PathSmoothing::On { tolerance_mm, level: Some(level as u8) }, angle_rad));
    ended(line)
}

/// The parameters of a cycle; each must be there once. `None` if one is wrong, which has been said.
fn parameters(line: &mut Line<'_>, list: &List) -> Option<DefinitionNumbers> {
    let mut numbers = DefinitionNumbers([0.0; SLOTS]);
    let (mut seen, mut correct) = (0_u32, true);
    // The first line has the name of the cycle, the others a parameter and a comment.
    let mut parts = line.at.take_rest().split(|byte| *byte == GOES_ON);
    let name = parts.next().unwrap_or_default();
    if name.iter().any(|byte| matches!(byte, b'=' | b';')) {
        line.fault(0, "parameters in the first line of the cycle");
        correct = false;
    }
    for part in parts {
        let mut at = Cursor::new(part);
        while !at.ended() && at.peek() != Some(b';') {
            let found = parameter(&mut at);
            let Some((number, value)) = found else {
                line.fault(0, format!("expected Q and a number, as Q200=2: `{}`", super::shown(part.trim_ascii())));
                return None;
            };
            let Some(index) = list.items.iter().position(|item| item.number == number) else {
                line.fault(0, format!("Q{number} is no parameter of {}", list.name));
                correct = false;
                continue;
            };
            correct &= seen & (1 << index) == 0;
            seen |= 1 << index;
            match list.items[index].role {
                ArgumentRole::Whole(_) if value.fract() != 0.0 => {
                    let name = list.items[index].name;
                    line.fault(0, format!("Q{number} ({name}) of {} is {value}, expected a whole number", list.name));
                    correct = false;
                }
                ArgumentRole::Whole(slot) => numbers.0[slot as usize] = value,
                ArgumentRole::Needs(slot) | ArgumentRole::Takes(slot) => numbers.0[slot as usize] = value,
                ArgumentRole::Must(wanted) if !same(wanted, value) => {
                    let name = list.items[index].name;
                    line.fault(0, format!("Q{number} ({name}) of {} is {value}, expected {wanted}", list.name));
                    correct = false;
                }
                _ => {}
            }
        }
    }
    for (_, item) in list.items.iter().enumerate().filter(|(index, _)| seen & (1 << index) == 0) {
        let text = format!(
            "Q{} ({}) of {} is missing: it would keep the value of an earlier definition",
            item.number, item.name, list.name
        );
        line.fault(0, text);
        correct = false;
    }
    if !correct && line.fault_count() == 0 {
        line.fault(0, "a parameter of the cycle occurs twice");
    }
    correct.then_some(numbers)
}

/// `Q200=+2`.
fn parameter(at: &mut Cursor<'_>) -> Option<(u32, f64)> {
    at.take(b'Q').then_some(())?;
    let number = at.number().and_then(whole)?;
    at.blanks();
    at.take(b'=').then_some(())?;
    let value = at.spaced_number()?.value;
    matches!(at.peek(), None | Some(b' ' | b'\t' | b';')).then_some((number, value))
}

fn carry_out(line: &mut Line<'_>, tenths: u32, numbers: &DefinitionNumbers) -> bool {
    if tenths == 2470 {
        let row = numbers.get(ArgumentSlot::Row);
        if row < 0.0 {
            return false;
        }
        line.orders.mode(ModeOrder::Restart);
        line.orders.mode(ModeOrder::WorkOffset(WorkOffset::Row(row as u32)));
        return true;
    }
    let hole = hole(line, tenths / 10, numbers);
    if let Some(hole) = hole {
        line.orders.mode(ModeOrder::Define(hole.in_unit(line.machine().unit())));
    }
    hole.is_some()
}

/// Cycles 200 and up that make one hole.
fn hole(line: &mut Line<'_>, number: u32, q: &DefinitionNumbers) -> Option<Cycle> {
    let surface = q.get(ArgumentSlot::Surface);
    let (depth, clearance) = (-q.get(ArgumentSlot::Depth), q.get(ArgumentSlot::Clearance));
    if depth <= 0.0 || clearance < 0.0 {
        line.fault(0, "Q201 of the cycle is not negative, or Q200 is");
    }
    for (name, slot) in [("Q202", ArgumentSlot::Step), ("Q204", ArgumentSlot::Return)] {
        if q.get(slot) < 0.0 {
            line.fault(0, format!("{name} of the cycle is negative"));
        }
    }
    let (reference, bottom) = (surface + clearance, surface - depth);
    let back_to = (surface + q.get(ArgumentSlot::Return)).max(reference);
    // Steps count from the surface.
    let step = Some(q.get(ArgumentSlot::Step)).filter(|step| *step > 0.0 && *step < depth);
    let mut gap = None;
    let kind = match number {
        200 => step.map_or(CycleKind::Drill, CycleKind::Peck),
        201 => CycleKind::Ream,
        202 => {
            let quadrant = q.get(ArgumentSlot::Quadrant);
            let direction = match quadrant {
                1.0 => [-1.0, 0.0],
                2.0 => [0.0, -1.0],
                3.0 => [1.0, 0.0],
                4.0 => [0.0, 1.0],
                _ => {
                    line.fault(0, format!("Q214 is {quadrant}, expected the direction off the wall: 1 to 4"));
                    [0.0; 2]
                }
            };
            // The control moves it by a distance of its own.
            let angle_deg = Some(q.get(ArgumentSlot::Angle));
            CycleKind::FineBore(FineBore { shift_mm: None, direction: Some(direction), angle_deg })
        }
        203 => match step {
            Some(step) => {
                let breaks = q.get(ArgumentSlot::Breaks);
                if breaks < (depth / step).ceil() - 1.0 {
                    line.fault(0, format!("Q213 is {breaks}, fewer chip breaks than the hole has steps"));
                }
                gap = Some(q.get(ArgumentSlot::OtherGap));
                CycleKind::ChipBreak(step)
            }
            None => CycleKind::Drill,
        },
        205 => {
            let (upper, lower) = (q.get(ArgumentSlot::Gap), q.get(ArgumentSlot::OtherGap));
            if !same(upper, lower) {
                line.fault(0, format!("Q259 is {lower}, expected {upper} as Q258"));
            }
            gap = step.map(|_| upper);
            step.map_or(CycleKind::Drill, CycleKind::Peck)
        }
        207 => CycleKind::Tap(q.get(ArgumentSlot::Pitch)),
        _ => return None,
    };
    let feed = (number != 207).then(|| q.get(ArgumentSlot::Feed));
    Some(Cycle { kind, reference, bottom, back_to: Some(back_to), dwell: q.get(ArgumentSlot::Dwell), feed, gap })
}
