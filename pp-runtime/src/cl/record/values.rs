//! Values that several records share (points, lists of numbers, texts, planes), and numbers as text.

use std::fmt::{self, Display, Formatter, Write as _};

use crate::cl::text::{Args, ClFault, Span, decoded, skip_blanks, trimmed, whole_number};

/// A point with or without a tool axis, in units of the file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Coordinates `x, y, z`.
    pub tip: [f64; 3],
    /// Tool axis `i, j, k`, not normalised.
    pub axis: Option<[f64; 3]>,
    /// Place of the numbers, for messages.
    pub at: Span,
}

impl Point {
    /// Reads `x,y,z[,i,j,k]`.
    #[inline]
    pub(crate) fn parse(args: &mut Args<'_>) -> Result<Point, ClFault> {
        let mut numbers = [0.0; 6];
        let found = args.numbers(&mut numbers)?;
        Point::of(numbers, found, args.all()).ok_or_else(|| args.wrong_count("3 or 6 numbers", found))
    }

    /// Point of the first `count` numbers, which must be 3 or 6.
    #[inline]
    pub(crate) fn of([x, y, z, i, j, k]: [f64; 6], count: usize, at: Span) -> Option<Point> {
        let axis = match count {
            3 => None,
            6 => Some([i, j, k]),
            _ => return None,
        };
        Some(Point { tip: [x, y, z], axis, at })
    }
}

/// Text of a record without the blanks, slash and quotes around it, in the encoding of the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Text<'a> {
    /// Bytes of the text.
    pub bytes: &'a [u8],
    /// Place in the statement.
    pub at: Span,
}

impl<'a> Text<'a> {
    /// Takes the rest of the statement as text, without blanks, one slash and a pair of quotes around it.
    pub(crate) fn rest(args: &mut Args<'a>) -> Text<'a> {
        let text = args.text();
        let mut start = args.position();
        if text.get(start) == Some(&b'/') {
            start = skip_blanks(text, start + 1);
        }
        let mut end = text.len();
        if end >= start + 2 && text[start] == b'\'' && text[end - 1] == b'\'' {
            (start, end) = (start + 1, end - 1);
        }
        args.skip_rest();
        Text { bytes: &text[start..end], at: Span { start, end } }
    }
}

/// Numbers of a record that may hold any count of numbers. They were checked when the record was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numbers<'a> {
    /// The arguments as written.
    pub bytes: &'a [u8],
    /// Place in the statement.
    pub at: Span,
}

impl<'a> Numbers<'a> {
    /// All arguments of a record; the caller checks that they are numbers.
    pub(crate) fn all(args: &Args<'a>) -> Numbers<'a> {
        let at = args.all();
        Numbers { bytes: &args.text()[at.start..at.end], at }
    }

    /// The numbers in order; commas and slashes separate them.
    pub fn values(&self) -> impl Iterator<Item = f64> + 'a {
        let pieces = self.bytes.split(|byte| matches!(byte, b',' | b'/'));
        pieces.filter_map(|piece| whole_number(trimmed(piece)))
    }

    /// The numbers as points without tool axis.
    pub fn points(&self) -> impl Iterator<Item = Point> + 'a {
        let (mut values, at) = (self.values(), self.at);
        std::iter::from_fn(move || {
            let tip = [values.next()?, values.next()?, values.next()?];
            Some(Point { tip, axis: None, at })
        })
    }
}

/// A number in the format of CL data: decimal, with a point.
pub(crate) struct ClNumber(pub(crate) f64);

impl Display for ClNumber {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let text = format!("{}", self.0);
        out.write_str(&text)?;
        if text.contains('.') { Ok(()) } else { out.write_char('.') }
    }
}

/// Numbers separated by commas, in the format of CL data.
pub(crate) struct ClNumbers<'a>(pub(crate) &'a [f64]);

impl Display for ClNumbers<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        for (index, value) in self.0.iter().enumerate() {
            if index > 0 {
                out.write_char(',')?;
            }
            ClNumber(*value).fmt(out)?;
        }
        Ok(())
    }
}

impl Display for Point {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        ClNumbers(&self.tip).fmt(out)?;
        self.axis.map_or(Ok(()), |axis| write!(out, ",{}", ClNumbers(&axis)))
    }
}

impl Display for Text<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str(&decoded(self.bytes))
    }
}

impl Display for Numbers<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        out.write_str(&String::from_utf8_lossy(self.bytes))
    }
}

/// Writes `WORD/ON` or `WORD/OFF`.
pub(crate) fn write_on_off(word: &str, on: bool, out: &mut Formatter<'_>) -> fmt::Result {
    write!(out, "{word}/{}", if on { "ON" } else { "OFF" })
}

/// First word of a table that has this value.
pub(crate) fn word_of<T: PartialEq>(table: &[(&'static str, T)], value: &T) -> &'static str {
    table.iter().find(|(_, known)| known == value).map_or("", |(word, _)| word)
}

/// Plane of two axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisPlane {
    /// XYPLAN.
    Xy,
    /// YZPLAN.
    Yz,
    /// ZXPLAN.
    Zx,
}

impl AxisPlane {
    /// Words of CL data and their planes.
    pub const WORDS: [(&'static str, AxisPlane); 3] =
        [("XYPLAN", AxisPlane::Xy), ("YZPLAN", AxisPlane::Yz), ("ZXPLAN", AxisPlane::Zx)];

    /// Unit normal of the plane.
    #[must_use]
    pub const fn normal(self) -> [f64; 3] {
        match self {
            AxisPlane::Xy => [0.0, 0.0, 1.0],
            AxisPlane::Yz => [1.0, 0.0, 0.0],
            AxisPlane::Zx => [0.0, 1.0, 0.0],
        }
    }
}
