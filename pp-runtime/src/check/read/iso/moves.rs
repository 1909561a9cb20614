//! Lines of axis words and F alone, and of arcs whose code is in force: most lines of a program.

use super::super::language::{Address, letters};
use super::super::machine::{Interpreter, WordsOfMoves};
use super::super::orders::Letters;
use super::super::text::{Cursor, Number, whole};
use super::super::{MAX_AXES, Moves, Vocabulary};

/// Meaning of the first byte of a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum WordStart {
    Blank,
    BlockNumber,
    /// A word of an axis, by its position in the chain, [`FEED`], or one of [`CENTRE`].
    Word(u8),
    Other,
}

/// The word of F, after those of the axes.
const FEED: u8 = MAX_AXES as u8;

/// The words of I, J and K.
const CENTRE: [u8; 3] = [FEED + 1, FEED + 2, FEED + 3];

/// Bits of the words of axes.
const AXES: u32 = (1 << FEED) - 1;

/// Bits of the words that a line may have: those of the axes and F, and of I J K those among the letters.
fn permitted(centre: Letters) -> u32 {
    const WITHOUT_CENTRE: u32 = (1 << CENTRE[0]) - 1;
    let centre = (centre & letters("IJK")) >> (b'I' - b'A');
    WITHOUT_CENTRE | centre << CENTRE[0]
}

/// The words of such lines, for one program.
#[derive(Debug)]
pub(super) struct MoveWords {
    /// By byte.
    parts: Box<[WordStart; 256]>,
    /// A number without a point counts as it is written, too.
    plain: bool,
}

impl MoveWords {
    pub(super) fn new(vocabulary: &Vocabulary, machine: &Interpreter) -> Self {
        let language = vocabulary.family.language();
        let part = |byte: u8| match (byte, language.address(byte)) {
            (b' ' | b'\t' | b'\r', _) => WordStart::Blank,
            (_, Some(Address::BlockNumber)) => WordStart::BlockNumber,
            (_, Some(Address::Axis)) => {
                machine.axis_named(&[byte]).map_or(WordStart::Other, |index| WordStart::Word(index as u8))
            }
            (_, Some(Address::Feed)) => WordStart::Word(FEED),
            (b'I'..=b'K', Some(Address::Centre)) => WordStart::Word(CENTRE[usize::from(byte - b'I')]),
            _ => WordStart::Other,
        };
        Self {
            parts: Box::new(std::array::from_fn(|byte| part(byte as u8))),
            plain: vocabulary.plain || !machine.facts().least_increments,
        }
    }

    /// Reads a line of words of axes and F, each once and none in least increments, after a block number at most;
    /// `false` if another word comes, or none of an axis. A function of its own, whose registers no other line needs.
    #[inline(never)]
    pub(super) fn read(&self, text: &[u8], may_have: WordsOfMoves, moves: &mut Moves) -> bool {
        let without_normal = may_have.without.map_or(!0, |normal| !(1 << normal));
        let permitted = permitted(may_have.centre) & without_normal;
        self.words::<true>(text, permitted, moves) || self.words::<false>(text, permitted, moves)
    }

    /// Takes the words; `SHORT`: none has a longer number than [`Cursor::short_number`] takes, as in nearly every line.
    /// A byte that goes on with its number is no part of such a line.
    #[inline(always)]
    fn words<const SHORT: bool>(&self, text: &[u8], permitted: u32, moves: &mut Moves) -> bool {
        let number = |at: &mut Cursor<'_>| if SHORT { at.short_number() } else { at.number() };
        *moves = Moves::default();
        let mut at = Cursor::new(text);
        if at.peek().map(|byte| self.parts[usize::from(byte)]) == Some(WordStart::BlockNumber) {
            at.skip(1);
            let number = number(&mut at).filter(|number| !number.point && !number.negative);
            moves.number = number.and_then(whole).map(u64::from);
            if moves.number.is_none() {
                return false;
            }
        }
        // Words that may still come.
        let mut left = permitted;
        while let Some(byte) = at.peek() {
            at.skip(1);
            let part = self.parts[usize::from(byte)];
            if part == WordStart::Blank {
                continue;
            }
            let WordStart::Word(index) = part else { return false };
            let suits = |number: &Number| left & (1 << index) != 0 && (number.point || self.plain);
            let Some(number) = number(&mut at).filter(suits) else { return false };
            left &= !(1 << index);
            match (moves.motion.axes.values.get_mut(usize::from(index)), index) {
                (Some(axis), _) => *axis = number.value,
                (None, FEED) if number.value > 0.0 => moves.feed = Some(number.value),
                (None, FEED) => return false,
                (None, centre) => moves.motion.arc.centre[usize::from(centre - CENTRE[0])] = number.value,
            }
        }
        let written = permitted & !left;
        moves.motion.arc.written = (written >> CENTRE[0]) as u8;
        moves.motion.axes.written = (written & AXES) as u16;
        moves.motion.axes.written != 0
    }
}
