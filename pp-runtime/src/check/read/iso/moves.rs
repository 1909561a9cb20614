//! Lines of axis words and F alone: most lines of a program.

use super::super::Vocabulary;
use super::super::block::MAX_AXES;
use super::super::draft::Draft;
use super::super::language::Address;
use super::super::machine::Interpreter;
use super::super::text::{Cursor, Number, whole};

/// Meaning of the first byte of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Blank,
    BlockNumber,
    /// A word of an axis, by its position in the chain, or [`FEED`].
    Word(u8),
    Other,
}

/// The word of F, after those of the axes.
const FEED: u8 = MAX_AXES as u8;

/// The words of such lines, for one program.
#[derive(Debug)]
pub(super) struct MoveWords {
    /// By byte.
    parts: Box<[Part; 256]>,
    /// A number without a point counts as it is written, too.
    plain: bool,
}

impl MoveWords {
    pub(super) fn new(vocabulary: &Vocabulary, machine: &Interpreter) -> Self {
        let language = vocabulary.family.language();
        let part = |byte: u8| match (byte, language.address(byte)) {
            (b' ' | b'\t' | b'\r', _) => Part::Blank,
            (_, Some(Address::BlockNumber)) => Part::BlockNumber,
            (_, Some(Address::Axis)) => {
                machine.axis_named(&[byte]).map_or(Part::Other, |index| Part::Word(index as u8))
            }
            (_, Some(Address::Feed)) => Part::Word(FEED),
            _ => Part::Other,
        };
        Self {
            parts: Box::new(std::array::from_fn(|byte| part(byte as u8))),
            plain: vocabulary.plain || !machine.facts().least_increments,
        }
    }

    /// Reads a line of axis words and F, each once and none in least increments, after a block number at most; `false` if
    /// another word comes. A function of its own, whose registers no other line needs.
    #[inline(never)]
    pub(super) fn read(&self, text: &[u8], draft: &mut Draft) -> bool {
        self.words::<true>(text, draft) || {
            draft.forget_moves();
            self.words::<false>(text, draft)
        }
    }

    /// Takes the words; `SHORT`: none has a longer number than [`Cursor::short_number`] takes, as in nearly every line. A byte
    /// that goes on with its number is no part of such a line.
    #[inline(always)]
    fn words<const SHORT: bool>(&self, text: &[u8], draft: &mut Draft) -> bool {
        let number = |at: &mut Cursor<'_>| if SHORT { at.short_number() } else { at.number() };
        let mut at = Cursor::new(text);
        if at.peek().map(|byte| self.parts[usize::from(byte)]) == Some(Part::BlockNumber) {
            at.skip(1);
            let number = number(&mut at).filter(|number| !number.point && !number.negative);
            draft.number = number.and_then(whole).map(u64::from);
            if draft.number.is_none() {
                return false;
            }
        }
        let mut written = 0_u32;
        while let Some(byte) = at.peek() {
            at.skip(1);
            let part = self.parts[usize::from(byte)];
            if part == Part::Blank {
                continue;
            }
            let Part::Word(index) = part else { return false };
            let suits = |number: &Number| written & (1 << index) == 0 && (number.point || self.plain);
            let Some(number) = number(&mut at).filter(suits) else { return false };
            written |= 1 << index;
            match draft.axes.get_mut(usize::from(index)) {
                Some(axis) => *axis = number.value,
                None if number.value > 0.0 => draft.feed = Some(number.value),
                None => return false,
            }
        }
        draft.written = written as u16 & !(1 << FEED);
        draft.written != 0
    }
}
