//! Guards that compare the length of the tool, or what lies over the work offset, each recognised as a whole.
//!
//! LinuxCNC: `o1 if [[ABS[#5403 - L] GT tol] AND [ABS[[#5403 * 25.4] - L] GT tol]]`, or `o1 if [[#5210 NE 0] OR
//! [#[5210 + 20 * #5220] NE
//! 0]]` (G92 is active, the offset in force is rotated: LinuxCNC 2.9, numbered parameters), `(abort, ..)`, `o1
//! endif`. Fanuc and Haas: `IF [ABS[#10021+#11021-L] GT tol] THEN #3000=101 (..)`, or `IF [ABS[..] LT tol] GOTO n`,
//! such an alarm, and the block `Nn`.

use super::super::block::{Guard, LengthSource};
use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::text::{Cursor, same, whole};

/// Variables of geometry and wear of a length register: first numbers, and the number of registers.
const REGISTERS: [([u32; 2], u32); 2] = [([10_000, 11_000], 999), ([2000, 2200], 200)];

/// A guard that has begun.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Guards {
    open: Option<Open>,
}

#[derive(Debug, Clone, Copy)]
enum Open {
    /// `o1 if`, and whether the abort has come.
    Condition { label: u32, guard: Compared, aborts: bool },
    /// A jump over an alarm, and whether that has come.
    Jump { target: u32, guard: Guard, alarm: bool },
}

/// What a condition compares.
#[derive(Debug, Clone, Copy)]
enum Compared {
    Length(Guard),
    /// What lies over the work offset.
    Offset,
}

impl Guards {
    /// A guard has begun.
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// A line of a guard: whether it is a block. `None` if it is a block of words.
    #[inline]
    pub(super) fn line(&mut self, line: &mut Line<'_>) -> Option<bool> {
        match line.at.rest() {
            [b'O' | b'o', ..] => Some(self.o_word(line)),
            [b'I' | b'i', b'F' | b'f', ..] => Some(self.condition(line)),
            [b'#', ..] => Some(self.alarm(line)),
            _ if self.open.is_some() => self.within(line),
            _ => None,
        }
    }

    /// Within a guard: the abort, or the block to which the jump leads.
    fn within(&mut self, line: &mut Line<'_>) -> Option<bool> {
        match (&mut self.open, line.at.rest()) {
            (Some(Open::Condition { aborts, .. }), [b'(', ..]) if !*aborts => {
                let rest = line.at.rest();
                let whole = rest.iter().position(|byte| *byte == b')') == Some(rest.trim_ascii_end().len() - 1);
                line.at.skip(1);
                if !(whole && line.at.word(b"abort") && line.at.literal(b",")) {
                    line.fault(0, "`(abort, ..)` expected in the guard");
                }
                *aborts = true;
                Some(false)
            }
            (Some(Open::Condition { .. }), _) => {
                line.fault(0, "this block is executed only under a condition");
                None
            }
            (Some(Open::Jump { target, alarm: true, .. }), [b'N' | b'n', ..]) => {
                let mut at = line.at;
                at.skip(1);
                if at.number().and_then(whole) != Some(*target) {
                    line.fault(0, format!("N{target} expected, to which the length guard jumps"));
                }
                self.open = None;
                None
            }
            (open, _) => {
                *open = None;
                line.fault(0, "the guard is not complete before this block");
                None
            }
        }
    }

    /// `o1 if [..]`, `o1 endif`.
    fn o_word(&mut self, line: &mut Line<'_>) -> bool {
        line.at.skip(1);
        let Some(label) = line.at.number().and_then(whole) else {
            line.unknown_text(0, line.at.rest());
            return false;
        };
        if line.at.word(b"if") {
            let unit = if line.facts().guard_in_mm { 1.0 } else { line.unit() };
            match offset_condition(&mut line.at).or_else(|| spindle_condition(&mut line.at, unit)) {
                Some(guard) if self.open.is_none() => self.open = Some(Open::Condition { label, guard, aborts: false }),
                _ => line.fault(line.at.column(), "unknown condition"),
            }
            return false;
        }
        // A comment without a comma orders nothing.
        let remarks = |rest: &[u8]| matches!(rest, [b';', text @ ..] if !text.contains(&b','));
        if line.at.word(b"endif") && (line.at.ended() || remarks(line.at.rest())) {
            match self.open.take() {
                Some(Open::Condition { label: opened, guard, aborts }) if opened == label => {
                    line.orders.mode(match guard {
                        Compared::Length(guard) => ModeOrder::Guard(Guard { stops: aborts, ..guard }),
                        Compared::Offset => ModeOrder::OffsetGuard,
                    });
                    if !aborts {
                        line.fault(0, "the guard does not abort the program");
                    }
                }
                _ => line.fault(0, "endif without its condition"),
            }
            return true;
        }
        line.unknown_text(0, line.at.rest());
        false
    }

    /// `IF [ABS[#..-L] GT tol] THEN #3000=1 (..)`, and `IF [ABS[#..-L] LT tol] GOTO 5` over such an alarm.
    fn condition(&mut self, line: &mut Line<'_>) -> bool {
        if self.open.take().is_some() {
            line.fault(0, "the guard is not complete before this block");
        }
        let unit = line.unit();
        match register_condition(&mut line.at, unit) {
            Some((mut guard, None)) if is_alarm(line) => {
                guard.stops = true;
                line.orders.mode(ModeOrder::Guard(guard));
            }
            Some((guard, Some(target))) => self.open = Some(Open::Jump { target, guard, alarm: false }),
            _ => line.fault(
                0,
                "unknown condition: the check reads `IF [ABS[#..+#..-L] GT t] THEN #3000=n (..)` and \
                 `IF [ABS[#..-L] LT t] GOTO n` over `#3000=n (..)`",
            ),
        }
        true
    }

    /// `#3000 = 1 (TEXT)`: only a guard jumps over it.
    fn alarm(&mut self, line: &mut Line<'_>) -> bool {
        match &mut self.open {
            Some(Open::Jump { guard, alarm, .. }) if !*alarm && is_alarm(line) => {
                *alarm = true;
                line.orders.mode(ModeOrder::Guard(Guard { stops: true, ..*guard }));
            }
            _ => line.fault(0, "a variable is set or an alarm is raised without a condition"),
        }
        true
    }
}

/// `[[ABS[#5403 - L] GT tol] AND [ABS[[#5403 * 25.4] - L] GT tol]]` and nothing after it.
fn spindle_condition(at: &mut Cursor<'_>, unit: f64) -> Option<Compared> {
    let [length, tolerance] = compared(at, b"[[ABS[#5403-", b"]GT")?;
    let again = compared(at, b"]AND[ABS[[#5403*25.4]-", b"]GT")?;
    let whole =
        at.literal(b"]]") && at.ended() && same(again[0], length) && same(again[1], tolerance) && tolerance > 0.0;
    let [length_mm, tolerance_mm] = [length * unit, tolerance * unit];
    let guard = Guard { length_mm, tolerance_mm, source: LengthSource::Spindle, stops: false };
    whole.then_some(Compared::Length(guard))
}

/// `[[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]` and nothing after it; takes nothing if it is something else.
fn offset_condition(at: &mut Cursor<'_>) -> Option<Compared> {
    let start = *at;
    let whole = at.literal(b"[[#5210NE0]OR[#[5210+20*#5220]NE0]]") && at.ended();
    if !whole {
        *at = start;
    }
    whole.then_some(Compared::Offset)
}

/// Two numbers, each after a text.
fn compared(at: &mut Cursor<'_>, before: &[u8], between: &[u8]) -> Option<[f64; 2]> {
    let length = at.literal(before).then(|| at.spaced_number())??.value;
    let tolerance = at.literal(between).then(|| at.spaced_number())??.value;
    Some([length, tolerance])
}

/// `IF [ABS[#10021+#11021-L] GT tol] THEN`, or with LT and GOTO, whose target is returned.
fn register_condition(at: &mut Cursor<'_>, unit: f64) -> Option<(Guard, Option<u32>)> {
    let first = at.literal(b"IF[ABS[#").then(|| at.number())?.and_then(whole)?;
    let second = if at.literal(b"+#") { Some(at.number().and_then(whole)?) } else { None };
    let length_mm = at.literal(b"-").then(|| at.spaced_number())??.value * unit;
    let greater = at.literal(b"]GT");
    if !greater && !at.literal(b"]LT") {
        return None;
    }
    let tolerance_mm = at.spaced_number().filter(|number| number.value > 0.0)?.value * unit;
    let source = match second {
        Some(second) => LengthSource::Register(register(first, second)?),
        None => LengthSource::Variable(first),
    };
    let guard = Guard { length_mm, tolerance_mm, source, stops: false };
    if greater {
        return at.literal(b"]THEN").then_some((guard, None));
    }
    let target = at.literal(b"]GOTO").then(|| at.spaced_number())?.and_then(whole)?;
    at.ended().then_some((guard, Some(target)))
}

/// The register whose geometry and wear two variables hold.
fn register(one: u32, other: u32) -> Option<u32> {
    let (low, high) = (one.min(other), one.max(other));
    REGISTERS.iter().find_map(|([first, second], count)| {
        let register = low.checked_sub(*first).filter(|register| (1..=*count).contains(register))?;
        (high == second + register).then_some(register)
    })
}

/// `#3000 = 101 (TEXT)`: an alarm that stops.
fn is_alarm(line: &mut Line<'_>) -> bool {
    if !line.at.literal(b"#3000=") {
        return false;
    }
    let number = line.at.spaced_number().and_then(whole);
    let rest = line.at.take_rest().trim_ascii();
    let text = rest.is_empty()
        || (rest.starts_with(b"(") && rest.iter().position(|byte| *byte == b')') == Some(rest.len() - 1));
    text && number.is_some_and(|number| number > 0)
}
