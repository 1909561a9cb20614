//! Guards: lines that stop the program unless the control's tool length is the one posted, or its rotary axes are where
//! a plane needs them.
//!
//! | control | form |
//! |---|---|
//! | LinuxCNC | `o1 if [..]`, `(abort, ..)`, `o1 endif`, for a length, or for `#5210` and the rotation of the offset in force |
//! | Fanuc, Haas | `IF [ABS[#..+#..-L] GT t] THEN #3000=101 (..)` |
//! | Siemens | `IF ABS($P_TOOLL[1]-L)>t`, or `IF ABS($P_TOOLR)>t` for a radius; a message, M0, M30, `ENDIF` |
//! | | or `IF ABS(SIN(($AA_IW[B]-30)/2))+..>t` for positions, or rotation, scale and mirror of `$P_ACTFRAME` |
//! | Heidenhain | `FN 18` twice, `FN 1`, `FN 12` twice, `LBL "OFF1"`, a comment, `FN 14`, `LBL "FITS1"` |
//! | | `FN 20`, `FN 18` for each axis, `QL3 = ABS ( SIN ( ( QL1 - 30 ) / 2 ) ) + ..`, `FN 12`, a comment, `FN 14`, `LBL` |
//! | | `FN 18` of ID210 NR1, `FN 9`, a comment, `FN 14`, `LBL` |
//!
//! A guard is whole, or refused: a program whose guard lacks a line, or compares something else, does something
//! unknown.

use super::Control;
use super::axes::{Axes, is_rotary};
use super::lexer::{Content, Number, Token};
use super::trace::Effect;

/// The lines of a guard that have been read, and those that are to come.
#[derive(Debug, Default)]
pub(super) struct Guards {
    open: Option<Open>,
}

#[derive(Debug)]
struct Open {
    line: usize,
    effect: Effect,
    /// Register or tool whose length is compared, where the guard names one.
    register: Option<u32>,
    /// Lines that have to follow, the next one last.
    due: Vec<Due>,
}

#[derive(Debug, Clone, PartialEq)]
enum Due {
    /// The comment that ends a LinuxCNC program, `(abort, ...)`.
    Abort,
    Comment,
    Line(String),
    Block(u32),
    /// `FN 12: IF +QL1 LT +low GOTO LBL "OFF1"`, then the same for the higher length.
    Low,
    High(f64, String),
    /// `FN 18: SYSREAD QL1 = ID270 NR1 IDX5`, then what reads or compares more.
    Position(Vec<char>),
    /// `FN 12: IF +QL3 LT +0.0009 GOTO LBL "PLANE1"`.
    Jump,
    /// `FN 9: IF +QL1 EQU +0 GOTO LBL "OFFSET1"`.
    Unrotated,
}

/// What became of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outcome {
    /// The line is not part of a guard.
    NotAGuard,
    /// The guard goes on.
    GoesOn,
    /// The guard is complete; it began in this line.
    Complete(usize, Effect, Option<u32>),
}

/// Length with which the first line of a LinuxCNC guard compares, in the unit of the program.
#[must_use]
pub fn guarded_length(text: &str) -> Option<f64> {
    match linuxcnc(text)?.0 {
        Effect::Guard { length, .. } => Some(length),
        _ => None,
    }
}

const REFUSED: &str = "not a guard, or not a whole one";

impl Guards {
    /// Offers a line to the guard that is open, or to a new one.
    pub(super) fn line(&mut self, control: Control, line: usize, content: &Content) -> Result<Outcome, String> {
        if let Some(mut open) = self.open.take() {
            open.next(content)?;
            return Ok(self.keep(open));
        }
        let Content::Condition(text) = content else {
            let abort = matches!(content, Content::Comment(text) if text.starts_with("abort,"));
            return if control == Control::LinuxCnc && abort {
                Err(REFUSED.to_owned())
            } else {
                Ok(Outcome::NotAGuard)
            };
        };
        let begun = match control {
            Control::LinuxCnc => linuxcnc(text),
            Control::Fanuc | Control::Haas => alarm(control, text),
            Control::Siemens => siemens(text),
            Control::Heidenhain => heidenhain(text),
        };
        let (effect, due) = begun.ok_or(REFUSED)?;
        Ok(self.keep(Open { line, effect, register: register(control, text), due }))
    }

    /// Whether a guard has begun and not ended.
    pub(super) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    fn keep(&mut self, open: Open) -> Outcome {
        if open.due.is_empty() {
            return Outcome::Complete(open.line, open.effect, open.register);
        }
        self.open = Some(open);
        Outcome::GoesOn
    }
}

impl Open {
    fn next(&mut self, content: &Content) -> Result<(), String> {
        let fits = match (self.due.pop(), content) {
            (Some(Due::Comment), Content::Comment(text)) => !text.is_empty(),
            (Some(Due::Line(due)), Content::Condition(text)) => *text == due,
            (Some(Due::Abort), Content::Comment(text)) => text.starts_with("abort,"),
            (Some(Due::Block(code)), Content::Block(tokens)) => is_m(tokens, code),
            (Some(Due::Low), Content::Condition(text)) => self.low(text).is_some(),
            (Some(Due::Position(read)), Content::Condition(text)) => self.position(text, read).is_some(),
            (Some(Due::Jump), Content::Condition(text)) => self.jump(text).is_some(),
            (Some(Due::Unrotated), Content::Condition(text)) => self.unrotated(text).is_some(),
            (Some(Due::High(low, label)), Content::Condition(text)) => self.high(text, low, &label).is_some(),
            _ => false,
        };
        if fits { Ok(()) } else { Err(REFUSED.to_owned()) }
    }

    /// `FN 12: IF +QL1 LT +109.99 GOTO LBL "OFF1"`.
    fn low(&mut self, text: &str) -> Option<()> {
        let (low, label) = jump(text)?;
        let label = label.strip_prefix("OFF")?;
        self.due.push(Due::High(low, label.to_owned()));
        Some(())
    }

    /// `FN 12: IF +QL1 LT +110.01 GOTO LBL "FITS1"`: the length is in the middle of both.
    fn high(&mut self, text: &str, low: f64, label: &str) -> Option<()> {
        let (high, to) = jump(text)?;
        if to.strip_prefix("FITS")? != label || high <= low {
            return None;
        }
        let round = |value: f64| (value * 1e6).round() / 1e6;
        self.effect = Effect::Guard { length: round((low + high) / 2.0), tolerance: round((high - low) / 2.0) };
        self.due = vec![
            Due::Line(format!("LBL \"FITS{label}\"")),
            Due::Line("FN 14: ERROR = 100".to_owned()),
            Due::Comment,
            Due::Line(format!("LBL \"OFF{label}\"")),
        ];
        Some(())
    }

    /// `FN 18: SYSREAD QL2 = ID270 NR1 IDX6`, or the sum of the axes that have been read.
    fn position(&mut self, text: &str, mut read: Vec<char>) -> Option<()> {
        let next = format!("FN 18: SYSREAD QL{} = ID270 NR1 IDX", read.len() + 1);
        if let Some(index) = text.strip_prefix(&next).filter(|_| read.len() < 2) {
            let letter = *ORDER.get(index.parse::<usize>().ok()?.checked_sub(1)?)?;
            (is_rotary(letter) && !read.contains(&letter)).then_some(())?;
            read.push(letter);
            self.due.push(Due::Position(read));
            return Some(());
        }
        let mut axes = Axes::default();
        let terms: Vec<&str> = text.strip_prefix("QL3 = ")?.split(" + ABS ").collect();
        (terms.len() == read.len()).then_some(())?;
        for (place, (term, letter)) in terms.iter().zip(read).enumerate() {
            let start = format!("( SIN ( ( QL{} ", place + 1);
            let compared = term.trim_start_matches("ABS ").strip_prefix(&start)?.strip_suffix(" ) / 2 ) )")?;
            axes.set(letter, subtracted(&compared.replace(' ', ""))?);
        }
        self.effect = Effect::PlaneGuard { axes, largest: f64::NAN };
        self.due.push(Due::Jump);
        Some(())
    }

    fn unrotated(&mut self, text: &str) -> Option<()> {
        let label = text.strip_prefix("FN 9: IF +QL1 EQU +0 GOTO LBL \"")?.strip_suffix('"')?;
        self.due =
            vec![Due::Line(format!("LBL \"{label}\"")), Due::Line("FN 14: ERROR = 102".to_owned()), Due::Comment];
        Some(())
    }

    fn jump(&mut self, text: &str) -> Option<()> {
        let (largest, label) = text.strip_prefix("FN 12: IF +QL3 LT ")?.split_once(" GOTO LBL \"")?;
        let Effect::PlaneGuard { largest: allowed, .. } = &mut self.effect else { return None };
        *allowed = number(largest)?;
        let label = label.strip_suffix('"')?;
        self.due =
            vec![Due::Line(format!("LBL \"{label}\"")), Due::Line("FN 14: ERROR = 101".to_owned()), Due::Comment];
        Some(())
    }
}

/// Axes in the order in which the control numbers them.
const ORDER: [char; 9] = ['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'];

/// 30 of `-30`, -20 of `+20`.
fn subtracted(text: &str) -> Option<f64> {
    let sign = if text.starts_with('-') { 1.0 } else { -1.0 };
    let digits = text.strip_prefix(['-', '+'])?;
    digits.starts_with(|first: char| first.is_ascii_digit()).then(|| number(digits))?.map(|value| sign * value)
}

/// `ABS(SIN(($AA_IW[B]-30)/2))+ABS(SIN(($AA_IW[C]+20)/2))>0.0009`.
fn positions(text: &str) -> Option<Effect> {
    let (sum, largest) = text.split_once('>')?;
    let mut axes = Axes::default();
    for term in sum.split("+ABS(") {
        let term = term.trim_start_matches("ABS(").strip_prefix("SIN(($AA_IW[")?.strip_suffix(")/2))")?;
        let (name, compared) = term.split_once(']')?;
        let letter = name.chars().next().filter(|letter| is_rotary(*letter))?;
        let whole = name[1..].bytes().all(|digit| digit.is_ascii_digit()) && !axes.contains(letter);
        axes.set(letter, whole.then(|| subtracted(compared))??);
    }
    Some(Effect::PlaneGuard { axes, largest: number(largest)? })
}

/// Register of the length in `#10001` (Fanuc), `#2001` (Haas), or the tool of `ID50 NR1 IDX1`.
fn register(control: Control, text: &str) -> Option<u32> {
    match control {
        Control::Fanuc | Control::Haas => {
            let digits = text.split_once('#')?.1;
            digits[..digits.find(|digit: char| !digit.is_ascii_digit())?].parse().ok()
        }
        Control::Heidenhain => text.rsplit_once("IDX")?.1.parse().ok(),
        Control::LinuxCnc | Control::Siemens => None,
    }
}

fn is_m(tokens: &[Token], code: u32) -> bool {
    matches!(tokens, [Token::Word { name, number, .. }] if name == "M" && (number.value - f64::from(code)).abs() < 1e-9)
}

fn number(text: &str) -> Option<f64> {
    Number::take(text).filter(|(_, rest)| rest.is_empty()).map(|(number, _)| number.value)
}

fn linuxcnc(text: &str) -> Option<(Effect, Vec<Due>)> {
    let (label, condition) = text.split_once(" if ")?;
    label.strip_prefix('o')?.parse::<u32>().ok()?;
    if condition == "[[#5210 NE 0] OR [#[5210 + 20 * #5220] NE 0]]" {
        return Some((Effect::OffsetGuard, vec![Due::Line(format!("{label} endif")), Due::Abort]));
    }
    let compared = condition.strip_prefix("[[ABS[#5403 - ")?.split(']').next()?;
    let allowed = condition.rsplit(" GT ").next()?.strip_suffix("]]")?;
    let whole = format!("[[ABS[#5403 - {compared}] GT {allowed}] AND [ABS[[#5403 * 25.4] - {compared}] GT {allowed}]]");
    let effect = Effect::Guard { length: number(compared)?, tolerance: number(allowed)? };
    (condition == whole).then(|| (effect, vec![Due::Line(format!("{label} endif")), Due::Abort]))
}

/// The two registers that hold geometry and wear of one length: #10001 and #11001 on Fanuc, #2001 and #2201 on Haas.
fn alarm(control: Control, text: &str) -> Option<(Effect, Vec<Due>)> {
    let spaced = text.strip_prefix("IF [ABS[#")?;
    let (condition, alarm) = spaced.split_once("] THEN #3000=")?;
    let (sum, allowed) = condition.split_once("] GT ")?;
    let sum = sum.replace(' ', "");
    let (first, rest) = sum.split_once("+#")?;
    let (second, compared) = rest.split_once('-')?;
    let (first, second): (u32, u32) = (first.parse().ok()?, second.parse().ok()?);
    let (base, more) = if control == Control::Fanuc { (10_000, 1000) } else { (2000, 200) };
    let one_register = first > base && first < base + more && second == first + more;
    let message = alarm.trim_start().strip_prefix("101 (")?.strip_suffix(')')?;
    let effect = Effect::Guard { length: number(compared)?, tolerance: number(allowed)? };
    (one_register && !message.contains(['(', ')'])).then(|| (effect, Vec::new()))
}

fn siemens(text: &str) -> Option<(Effect, Vec<Due>)> {
    let effect = if text.strip_prefix("IF ").is_some_and(is_frame) {
        Effect::OffsetGuard
    } else if let Some(positions) = text.strip_prefix("IF ").and_then(positions) {
        positions
    } else if let Some(allowed) = text.strip_prefix("IF ABS($P_TOOLR)>") {
        // A radius that is compared with nothing.
        Effect::Guard { length: 0.0, tolerance: number(allowed)? }
    } else {
        let (compared, allowed) = text.strip_prefix("IF ABS($P_TOOLL[1]-")?.split_once(")>")?;
        Effect::Guard { length: number(compared)?, tolerance: number(allowed)? }
    };
    let due = vec![Due::Line("ENDIF".to_owned()), Due::Block(30), Due::Block(0), Due::Comment];
    Some((effect, due))
}

/// `(ABS($P_ACTFRAME[X,RT])+..+ABS($P_ACTFRAME[Z,SC]-1)>t) OR $P_ACTFRAME[X,MI] OR ..`: nine components of the chain of
/// all frames.
fn is_frame(text: &str) -> bool {
    let Some((sum, mirrors)) = text.strip_prefix('(').and_then(|text| text.split_once(") OR ")) else { return false };
    let Some((terms, largest)) = sum.split_once('>') else { return false };
    let axes = ["X", "Y", "Z"];
    let wanted = axes.map(|axis| format!("ABS($P_ACTFRAME[{axis},RT])"));
    let scales = axes.map(|axis| format!("ABS($P_ACTFRAME[{axis},SC]-1)"));
    let mirrored = axes.map(|axis| format!("$P_ACTFRAME[{axis},MI]"));
    terms.split('+').eq(wanted.iter().chain(&scales).map(String::as_str))
        && mirrors.split(" OR ").eq(mirrored.iter().map(String::as_str))
        && number(largest).is_some_and(|largest| largest > 0.0 && largest < 2e-3)
}

/// `FN 18: SYSREAD QL1 = ID50 NR1 IDX5` reads the length of tool 5; its wear and their sum follow.
fn heidenhain(text: &str) -> Option<(Effect, Vec<Due>)> {
    if text == "FN 20: WAIT FOR SYNC" {
        return Some((Effect::Modal, vec![Due::Position(Vec::new())]));
    }
    if text == "FN 18: SYSREAD QL1 = ID210 NR1" {
        return Some((Effect::OffsetGuard, vec![Due::Unrotated]));
    }
    // Either may be read first.
    let [length, wear] = ["FN 18: SYSREAD QL1 = ID50 NR1 IDX", "FN 18: SYSREAD QL2 = ID50 NR4 IDX"];
    let (tool, other) = match (text.strip_prefix(length), text.strip_prefix(wear)) {
        (Some(tool), _) => (tool, wear),
        (_, Some(tool)) => (tool, length),
        _ => return None,
    };
    let tool: u32 = tool.parse().ok()?;
    let wear = format!("{other}{tool}");
    let due = vec![Due::Low, Due::Line("FN 1: QL1 = +QL1 + +QL2".to_owned()), Due::Line(wear)];
    Some((Effect::Modal, due))
}

/// The number and the label of `FN 12: IF +QL1 LT +109.99 GOTO LBL "OFF1"`.
fn jump(text: &str) -> Option<(f64, &str)> {
    let (compared, label) = text.strip_prefix("FN 12: IF +QL1 LT ")?.split_once(" GOTO LBL \"")?;
    Some((number(compared)?, label.strip_suffix('"')?))
}
