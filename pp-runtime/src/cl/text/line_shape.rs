//! The shape of a line of numbers, with which the lines after it are compared.
//!
//! CAM systems write numbers with fixed decimals, so that a line mostly has its digits at the places where the line
//! before had them, and the same bytes at all others. That is compared for the whole line at once, and the digits then
//! need no comparison of their own.

use super::fault::Span;
use super::number::{DigitPlaces, NumberShape, SHORT_NUMBER, two_numbers};
use crate::shortcut::Shortcut;
use wide::u8x16;

/// Longest line with a shape, with its end.
const LONGEST: usize = 128;

/// Bytes that [`LineShape::read`] may look at.
pub(super) const LINE_AND_NUMBER: usize = LONGEST + SHORT_NUMBER;

/// Bytes that are compared at once.
#[derive(Debug, Clone, Copy)]
struct Piece {
    /// A zero at the place of a digit, and every other byte of the line.
    bytes: u8x16,
    /// The largest number that bits may differ from these by: 9 for a digit, 0 for another byte, any after the line.
    largest: u8x16,
}

impl Piece {
    /// Of the bytes of a line; of the last ones there may be fewer.
    fn of(line: &[u8]) -> Self {
        let Some(bytes) = line.first_chunk() else {
            let (mut bytes, mut within) = ([0; 16], [u8::MAX; 16]);
            bytes[..line.len()].copy_from_slice(line);
            within[..line.len()].fill(0);
            let Self { bytes, largest } = Self::of(&bytes);
            return Self { bytes, largest: largest | u8x16::from(within) };
        };
        let bytes = u8x16::from(*bytes);
        let number = bytes - u8x16::splat(b'0');
        let is_digit = number.min(u8x16::splat(9)).simd_eq(number);
        let fixed = |byte| u8x16::splat(byte) & is_digit;
        Self { bytes: fixed(b'0') | bytes & !is_digit, largest: fixed(9) }
    }
}

/// Digits and other bytes of a line of numbers.
#[derive(Debug, Clone)]
pub(super) struct LineShape<const N: usize> {
    /// Number of bytes with the line end.
    length: usize,
    pieces: [Piece; LONGEST / 16],
    /// Shapes of the numbers, and where they begin; those of no numbers after `count` of them.
    numbers: [(NumberShape, usize); N],
    count: usize,
    /// Places of their first eight digits in the line.
    digits: [DigitPlaces; N],
    /// A number has more than eight digits.
    long: bool,
    /// Place of the numbers in the line.
    at: Span,
}

impl<const N: usize> LineShape<N> {
    /// That of no line.
    pub(super) const NONE: Self = Self {
        length: 0,
        pieces: [Piece { bytes: u8x16::ZERO, largest: u8x16::MAX }; LONGEST / 16],
        numbers: [(NumberShape::NONE, 0); N],
        count: 0,
        digits: [DigitPlaces::NONE; N],
        long: false,
        at: Span { start: 0, end: 0 },
    };

    /// Takes the shape of a line of `count` numbers, each a byte after the one before; `at` is their place. `text`
    /// begins with the line and goes on. A long line has none.
    #[inline(never)]
    pub(super) fn take(&mut self, text: &[u8], length: usize, count: usize, at: Span) {
        self.length = 0;
        if length > LONGEST {
            return;
        }
        self.numbers = [(NumberShape::NONE, 0); N];
        self.digits = [DigitPlaces::NONE; N];
        self.long = false;
        let mut start = at.start;
        for (number, digits) in self.numbers.iter_mut().zip(&mut self.digits).take(count) {
            let Some(shape) = text.get(start..).and_then(<[u8]>::first_chunk).and_then(NumberShape::of) else { return };
            (*number, *digits) = ((shape, start), shape.digits().after(start));
            self.long |= shape.is_long();
            start += shape.end() + 1;
        }
        let line = &text[..length];
        for (piece, line) in self.pieces.iter_mut().zip(line.chunks(16)) {
            *piece = Piece::of(line);
        }
        (self.length, self.count, self.at) = (length, count, at);
    }

    /// The first `USED` numbers of the line at the start of `text`, if it has this shape, and the number of its bytes
    /// with its end.
    #[inline(always)]
    pub(super) fn read<const USED: usize>(&self, text: &[u8; LINE_AND_NUMBER]) -> Option<(ShortNumbers<USED>, usize)> {
        if !Shortcut::LineShapes.is_on() {
            return None;
        }
        let mut beyond = u8x16::ZERO;
        for (text, piece) in text.as_chunks().0.iter().zip(&self.pieces[..self.length.div_ceil(16)]) {
            beyond |= (u8x16::from(*text) ^ piece.bytes).saturating_sub(piece.largest);
        }
        if self.length == 0 || beyond != u8x16::ZERO {
            return None;
        }
        let mut numbers = [0.0; USED];
        if self.long {
            self.set_each(&mut numbers, text)?;
        } else {
            self.set_pairs(&mut numbers, text);
        }
        Some((ShortNumbers { numbers, count: self.count, at: self.at }, self.length))
    }

    /// Sets numbers of `text`, none of which is long, two at once.
    #[inline(always)]
    fn set_pairs<const USED: usize>(&self, numbers: &mut [f64; USED], text: &[u8; LINE_AND_NUMBER]) {
        let mut index = 0;
        while index < USED && index < self.count {
            let places = [&self.digits[index.min(N - 1)], &self.digits[(index + 1).min(N - 1)]];
            let [first, second] = two_numbers(places, text);
            numbers[index] = first;
            if index + 1 < USED {
                numbers[index + 1] = second;
            }
            index += 2;
        }
    }

    /// Sets numbers of `text` one by one.
    #[inline(never)]
    fn set_each(&self, numbers: &mut [f64], text: &[u8; LINE_AND_NUMBER]) -> Option<()> {
        for (number, (shape, start)) in numbers.iter_mut().zip(&self.numbers[..self.count]) {
            *number = shape.value(text[start % LONGEST..].first_chunk()?);
        }
        Some(())
    }
}

/// Numbers of a statement that has no other arguments, at most `N`.
pub(crate) struct ShortNumbers<const N: usize> {
    pub(crate) numbers: [f64; N],
    pub(crate) count: usize,
    /// Place of the numbers in the statement.
    pub(crate) at: Span,
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use crate::cl::text::lexer::{Lexer, NumberLine};

    /// What is read of each line: the bits of its numbers, and their place; `None` where the line is left to `next`.
    fn read(text: &[u8]) -> Vec<Option<(Vec<u64>, usize, usize)>> {
        let mut lexer = Lexer::new(text, None);
        lexer.begin().expect("text");
        let mut goto = NumberLine::<6>::new("GOTO");
        let mut lines = Vec::new();
        loop {
            let found = lexer.next_numbers::<6, 6, _>(&mut goto, |found| {
                let bits = found.numbers[..found.count].iter().map(|number| number.to_bits()).collect();
                Some((bits, found.at.start, found.at.end))
            });
            match found {
                Some((_, numbers)) => lines.push(Some(numbers)),
                None if lexer.next().expect("text").is_some() => lines.push(None),
                None => return lines,
            }
        }
    }

    /// Lines of the shape of `line` with other digits, and one with another byte at `at`.
    fn alike(line: &str, turns: &[u8], at: usize, byte: u8) -> Vec<Vec<u8>> {
        let turned = |by: u8| {
            line.bytes().map(move |byte| if byte.is_ascii_digit() { (byte - b'0' + by) % 10 + b'0' } else { byte })
        };
        let mut lines: Vec<Vec<u8>> = turns.iter().map(|by| turned(*by).collect()).collect();
        let last = lines.len() - 1;
        let other = &mut lines[last];
        let at = 4 + at % (other.len() - 4);
        other[at] = byte;
        lines
    }

    proptest! {
        #[test]
        fn lines_alike_are_read_as_each_alone(
            lines in proptest::collection::vec(
                ("GOTO ?/( ?-?[0-9]{1,5}\\.[0-9]{0,12},){2,6}-?[0-9]{1,4}\\.[0-9]{0,9} {0,2}",
                 proptest::collection::vec(0_u8..10, 1..6), any::<usize>(), "[-0-9.,+E:;/ A\u{7f}]"),
                1..4,
            ),
            end in prop_oneof![Just("\n"), Just("\r\n")],
        ) {
            let lines: Vec<Vec<u8>> =
                lines.iter().flat_map(|(line, turns, at, byte)| alike(line, turns, *at, byte.as_bytes()[0])).collect();
            let ended = |line: &Vec<u8>| [line, end.as_bytes()].concat();
            let together = read(&lines.iter().flat_map(ended).collect::<Vec<u8>>());
            let alone: Vec<_> = lines.iter().flat_map(|line| read(&ended(line))).collect();
            prop_assert_eq!(together, alone);
        }
    }

    proptest! {
        /// Lines of a few shapes in any order: those of two shapes that alternate, and of one in succession, are read
        /// at once.
        #[test]
        fn lines_of_several_shapes_are_read_as_each_alone(
            shapes in proptest::collection::vec(
                "GOTO ?/( ?-?[0-9]{1,5}\\.[0-9]{0,12},){2,5}-?[0-9]{1,4}\\.[0-9]{0,9} {0,2}", 2..4),
            order in proptest::collection::vec((any::<usize>(), 0_u8..10, 1_usize..5), 1..12),
            other in (any::<usize>(), "[-0-9.,+E:;/ A\u{7f}]"),
        ) {
            let mut lines = Vec::new();
            for (index, by, times) in order {
                // Two shapes alternate, with digits of their own.
                for at in 0..2 * times {
                    let line = &shapes[(index + at % 2 * (index / 7 % 2)) % shapes.len()];
                    lines.extend(alike(line, &[by + at as u8, 0], 0, b'G').into_iter().take(1));
                }
            }
            let spoilt = other.0 % lines.len();
            let at = 4 + other.0 / lines.len() % (lines[spoilt].len() - 4);
            lines[spoilt][at] = other.1.as_bytes()[0];
            let ended = |line: &Vec<u8>| [line, b"\n".as_slice()].concat();
            let together = read(&lines.iter().flat_map(ended).collect::<Vec<u8>>());
            let alone: Vec<_> = lines.iter().flat_map(|line| read(&ended(line))).collect();
            prop_assert_eq!(together, alone);
        }
    }

    #[test]
    fn a_line_is_compared_up_to_its_end_and_not_beyond() {
        let lines = "GOTO/1.5,2.5,3.5\nGOTO/2.5,3.5,4.5\nGOTO/3.5,4.5,5.5";
        for last in ["\n", ",1\n", "5\n", " \n", ""] {
            let read = read(format!("{lines}{last}").as_bytes());
            let numbers = |index: usize| {
                read[index].as_ref().map(|(bits, ..)| bits.iter().map(|bits| f64::from_bits(*bits)).collect())
            };
            assert_eq!(numbers(1), Some(vec![2.5, 3.5, 4.5]));
            let expected: Option<Vec<f64>> = match last {
                "\n" | " \n" => Some(vec![3.5, 4.5, 5.5]),
                "5\n" => Some(vec![3.5, 4.5, 5.55]),
                ",1\n" => Some(vec![3.5, 4.5, 5.5, 1.0]),
                _ => None,
            };
            assert_eq!(numbers(2), expected, "{last:?}");
        }
    }
}
