//! FEDRAT: a feed with its unit.

use std::fmt::{self, Display, Formatter};

use super::values::{ClNumber, word_of};
use crate::cl::text::{Arg, Args, ClFault, Span};

/// Unit of a feed rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FeedUnit {
    /// PERMIN or no word: units of the file per minute.
    PerMinute,
    /// PERREV: units of the file per revolution.
    PerRevolution,
    /// MMPM.
    MillimetresPerMinute,
    /// MMPR.
    MillimetresPerRevolution,
    /// IPM.
    InchesPerMinute,
    /// IPR.
    InchesPerRevolution,
    /// FPM: feet per minute (Creo, *Supported CL Data Commands*; in its French text *pieds/mn*).
    FeetPerMinute,
    /// FPR: feet per revolution.
    FeetPerRevolution,
}

impl FeedUnit {
    /// Words of CL data and their units.
    pub const WORDS: [(&'static str, FeedUnit); 8] = [
        ("MMPM", FeedUnit::MillimetresPerMinute),
        ("MMPR", FeedUnit::MillimetresPerRevolution),
        ("IPM", FeedUnit::InchesPerMinute),
        ("IPR", FeedUnit::InchesPerRevolution),
        ("FPM", FeedUnit::FeetPerMinute),
        ("FPR", FeedUnit::FeetPerRevolution),
        ("PERMIN", FeedUnit::PerMinute),
        ("PERREV", FeedUnit::PerRevolution),
    ];

    /// The word that is written for this unit.
    #[must_use]
    pub fn word(self) -> &'static str {
        word_of(&Self::WORDS, &self)
    }
}

/// A feed as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedRecord {
    /// Value in `unit`.
    pub value: f64,
    /// Unit of the value.
    pub unit: FeedUnit,
    /// Place of the number, for messages.
    pub at: Span,
    /// Place of the word of the unit, for messages; of the number if there is no word.
    pub unit_at: Span,
}

impl FeedRecord {
    /// Reads `n[,unit]` or `unit,n`, of which the argument `first` is taken already.
    pub(crate) fn parse(first: Arg<'_>, args: &mut Args<'_>) -> Result<FeedRecord, ClFault> {
        let (number, word) = if first.looks_numeric() {
            (first, args.next()?)
        } else if first.among(&FeedUnit::WORDS).is_some() {
            (args.number_after(first)?, Some(first))
        } else {
            return Err(args.not_understood(first));
        };
        let value = number.number()?;
        let unit = match word {
            None => FeedUnit::PerMinute,
            Some(word) => word.among(&FeedUnit::WORDS).ok_or_else(|| args.not_understood(word))?,
        };
        Ok(FeedRecord { value, unit, at: number.at, unit_at: word.map_or(number.at, |word| word.at) })
    }
}

impl Display for FeedRecord {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        match self.unit {
            FeedUnit::PerMinute => write!(out, "FEDRAT/{}", ClNumber(self.value)),
            unit => write!(out, "FEDRAT/{},{}", unit.word(), ClNumber(self.value)),
        }
    }
}
