//! Words of a motion: axes, F, radius correction, sense of an arc, components of the tool axis, M codes.

use super::super::block::SideOfPath;
use super::super::language::Address;
use super::super::line::Line;
use super::super::orders::ModeOrder;
use super::super::words::{Counts, Word};

/// Words of a motion that are no numbers.
#[derive(Debug, Default)]
pub(super) struct Marks {
    /// FMAX.
    pub(crate) rapid: bool,
    /// DR+, counter-clockwise, or DR-.
    pub(crate) sense: Option<bool>,
}

/// Takes the words up to the end of the line or a comment; `None` where one is not known.
pub(super) fn motion(line: &mut Line<'_>) -> Option<Marks> {
    let mut marks = Marks::default();
    while !line.at.ended() && line.at.peek() != Some(b';') {
        let start = line.at.column();
        if !word(line) {
            line.at.go_to(start);
            mark(line, &mut marks)?;
        }
    }
    // FMAX holds for its block, F from its block on: together they are no motion that is known.
    (!marks.rapid || !line.words.has(Address::Feed)).then_some(marks)
}

/// M codes alone, up to the end of the line or a comment.
pub(super) fn codes(line: &mut Line<'_>) -> bool {
    while !line.at.ended() && line.at.peek() != Some(b';') {
        if line.at.peek() != Some(b'M') || !word(line) {
            return false;
        }
    }
    true
}

/// `FMAX`; `R0`, `RL`, `RR`, one of them; `DR+`, `DR-`.
fn mark(line: &mut Line<'_>, marks: &mut Marks) -> Option<()> {
    let start = line.at.column();
    if line.at.word(b"FMAX") {
        if std::mem::replace(&mut marks.rapid, true) {
            line.fault(start, "two FMAX words");
        }
        return Some(());
    }
    let sides = [(&b"R0"[..], SideOfPath::None), (b"RL", SideOfPath::Left), (b"RR", SideOfPath::Right)];
    if let Some((_, side)) = sides.into_iter().find(|(word, _)| line.at.word(word)) {
        let first = !line.orders.has(|mode| matches!(mode, ModeOrder::Side(_)));
        line.orders.mode(ModeOrder::Side(side));
        return first.then_some(());
    }
    let plus = match line.at.rest() {
        [b'D', b'R', b'+', ..] => true,
        [b'D', b'R', b'-', ..] => false,
        _ => return None,
    };
    line.at.skip(3);
    marks.sense.replace(plus).is_none().then_some(())
}

/// Letters and a number, with an `I` in front of those that are distances.
fn word(line: &mut Line<'_>) -> bool {
    let start = line.at.column();
    let leading = line.at.take(b'I');
    let letters = line.at.letters();
    let incremental = leading && !letters.is_empty();
    line.at.blanks();
    let Some(number) = line.at.number() else { return false };
    let counts = if incremental { Counts::Incremental } else { Counts::AsInForce };
    let (address, index) = match (line.axis(letters), letters) {
        (Some(index), _) => (Address::Axis, index),
        (None, b"PA") if incremental => (Address::Angle, 0),
        _ if leading => return false,
        (None, b"F") => (Address::Feed, 0),
        (None, b"TX" | b"TY" | b"TZ") => (Address::Vector, usize::from(letters[1] - b'X')),
        // R0 is the radius correction.
        (None, b"R") if number.negative || number.value > 0.0 => (Address::Radius, 0),
        (None, b"M") => {
            let known = line.code(b'M', number, start);
            // M140 has no distance but MB MAX.
            let ends_at_limit = (number.value - 140.0).abs() < 0.5;
            return known && (!ends_at_limit || line.at.words("MB MAX") && !line.words.has(Address::Feed));
        }
        (None, _) => return false,
    };
    line.word(letters, Word::new(address, index, number, counts, start));
    true
}
