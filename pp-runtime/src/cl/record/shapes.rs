//! Statements of a word and numbers alone, read by the shape of the last one.

use std::io::Read;

use super::Record;
use super::arc::{ArcRecord, CIRCLE_NUMBERS, CIRCLE_NUMBERS_HELD, CircleRecord};
use super::motion::MotionRecord;
use super::values::Point;
use super::words::{CIRCLE, GOTO};
use crate::cl::text::{Lexer, NumberLine, PhysicalLine, Statement};

/// Shapes of the statements of a word and numbers read last: that of the next one is probably the same.
pub(crate) struct Shapes {
    goto: NumberLine<6>,
    joined_goto: NumberLine<6>,
    circle: NumberLine<CIRCLE_NUMBERS>,
}

impl Default for Shapes {
    fn default() -> Self {
        Self {
            goto: NumberLine::new(GOTO.name),
            joined_goto: NumberLine::new(GOTO.name),
            circle: NumberLine::new(CIRCLE.name),
        }
    }
}

impl Shapes {
    /// Reads a GOTO on a line of its own: its line and point. `None`: any other line, which has not been read.
    #[inline(always)]
    pub(crate) fn next_goto<R: Read>(&mut self, lexer: &mut Lexer<R>) -> Option<(PhysicalLine, Point)> {
        lexer.next_numbers::<6, 6, _>(&mut self.goto, |found| Point::of(found.numbers, found.count, found.at))
    }

    /// Reads a GOTO, or a CIRCLE without TIMES, on a line of its own. `None`: any other line, which has not been read.
    pub(crate) fn next<R: Read>(&mut self, lexer: &mut Lexer<R>) -> Option<(PhysicalLine, Record<'static>)> {
        if let Some((line, point)) = self.next_goto(lexer) {
            return Some((line, Record::Motion(MotionRecord::Goto(point))));
        }
        let (line, circle) = lexer.next_numbers::<_, CIRCLE_NUMBERS_HELD, _>(&mut self.circle, |found| {
            CircleRecord::of(&found.numbers, found.count, 1, found.at)
        })?;
        Some((line, Record::Arc(ArcRecord::Circle(circle))))
    }

    /// The record of a GOTO that has been joined of several lines; `None` for any other statement.
    pub(crate) fn joined<R: Read>(&mut self, lexer: &Lexer<R>, statement: &Statement) -> Option<Record<'static>> {
        let point = lexer.joined_numbers::<6, 6, _>(statement, &mut self.joined_goto, |found| {
            Point::of(found.numbers, found.count, found.at)
        })?;
        Some(Record::Motion(MotionRecord::Goto(point)))
    }
}
