//! How long a program takes: at the programmed feeds and the largest axis speeds, without acceleration.

use crate::program::Location;

/// Operations whose times are kept one by one.
const MOST_OPERATIONS: usize = 200;

/// Bytes of an operation's name that are kept.
const NAME_LENGTH: usize = 60;

/// The time of one operation, minutes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OperationTime {
    /// As the CL data names it; empty if it does not.
    pub name: Vec<u8>,
    /// Where it begins.
    pub at: Location,
    /// Feed motions.
    pub cutting_min: f64,
    /// Everything.
    pub total_min: f64,
}

/// A turn of a rotary axis in the cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastestRotation {
    /// The axis.
    pub letter: char,
    /// rad/min.
    pub rad_per_min: f64,
    /// Where.
    pub at: Location,
}

/// Times of a program, minutes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Times {
    /// Feed motions.
    pub cutting_min: f64,
    /// Rapids whose axes have known speeds.
    pub rapid_min: f64,
    /// Waits.
    pub dwell_min: f64,
    /// Rapids with an axis whose speed is not known: they count nothing.
    pub rapids_of_unknown_speed: u64,
    /// Blocks that are slower than programmed.
    pub slowed_blocks: u64,
    /// By how much all of them together.
    pub slowed_min: f64,
    /// Where the first of them is.
    pub first_slowed: Location,
    /// The fastest turn that the CL data asks for, before axis speeds slow it down.
    pub fastest: Option<FastestRotation>,
    /// The first operations, in their order.
    pub operations: Vec<OperationTime>,
    /// Operations that are not in the list.
    pub unlisted_operations: u64,
}

impl Times {
    /// Everything together.
    #[must_use]
    pub fn total_min(&self) -> f64 {
        self.cutting_min + self.rapid_min + self.dwell_min
    }

    pub(crate) fn operation(&mut self, at: Location, name: &[u8]) {
        if self.operations.len() >= MOST_OPERATIONS {
            self.unlisted_operations += 1;
            return;
        }
        let name = name[..name.len().min(NAME_LENGTH)].to_vec();
        self.operations.push(OperationTime { name, at, ..OperationTime::default() });
    }

    /// Drops everything but the operation that has begun.
    pub(crate) fn keep_last_operation(&mut self) {
        let last = self.operations.pop();
        *self = Self { operations: last.into_iter().collect(), ..Self::default() };
    }

    /// Drops operations in which nothing has happened.
    pub(crate) fn forget_empty(&mut self) {
        self.operations.retain(|operation| operation.total_min > 0.0);
    }

    #[inline]
    fn add(&mut self, minutes: f64, cutting: bool) {
        if self.unlisted_operations > 0 {
            return;
        }
        if let Some(operation) = self.operations.last_mut() {
            operation.total_min += minutes;
            operation.cutting_min += if cutting { minutes } else { 0.0 };
        }
    }

    #[inline]
    pub(crate) fn cut(&mut self, minutes: f64) {
        self.cutting_min += minutes;
        self.add(minutes, true);
    }

    #[inline]
    pub(crate) fn rapid(&mut self, minutes: Option<f64>) {
        match minutes {
            Some(minutes) => {
                self.rapid_min += minutes;
                self.add(minutes, false);
            }
            None => self.rapids_of_unknown_speed += 1,
        }
    }

    pub(crate) fn wait(&mut self, minutes: f64) {
        self.dwell_min += minutes;
        self.add(minutes, false);
    }

    #[inline]
    pub(crate) fn rotate(&mut self, letter: char, rad_per_min: f64, at: Location) {
        if self.fastest.is_none_or(|fastest| rad_per_min > fastest.rad_per_min) {
            self.fastest = Some(FastestRotation { letter, rad_per_min, at });
        }
    }

    pub(crate) fn slow(&mut self, at: Location, minutes: f64) {
        if self.slowed_blocks == 0 {
            self.first_slowed = at;
        }
        self.slowed_blocks += 1;
        self.slowed_min += minutes;
    }
}
