//! Machining times: at the programmed feeds and the largest axis speeds, without acceleration.

use crate::program::Location;

/// Largest number of operations with a time of their own.
const MOST_OPERATIONS: usize = 200;

/// Largest length of an operation's name, bytes.
const NAME_LENGTH: usize = 60;

/// Time of one operation.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OperationTime {
    /// Name in the CL data; empty without one.
    pub name: Vec<u8>,
    /// Location of its beginning.
    pub at: Location,
    /// Feed motions.
    pub cutting_min: f64,
    /// Feed motions, rapids and dwells.
    pub total_min: f64,
}

/// Rotation of a rotary axis in a cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FastestRotation {
    /// Letter of the axis.
    pub letter: char,
    /// Speed of the axis.
    pub rad_per_min: f64,
    /// Location of the motion.
    pub at: Location,
}

/// Times of a program.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Times {
    /// Feed motions.
    pub cutting_min: f64,
    /// Rapids whose axes have known speeds.
    pub rapid_min: f64,
    /// Dwells.
    pub dwell_min: f64,
    /// Rapids with an axis of unknown speed; their time is not included.
    pub rapids_of_unknown_speed: u64,
    /// Blocks that are slower than programmed.
    pub slowed_blocks: u64,
    /// Time that these blocks lose together.
    pub slowed_min: f64,
    /// Location of the first of them.
    pub first_slowed: Location,
    /// Fastest rotation at the programmed feeds, before axis speeds limit it.
    pub fastest: Option<FastestRotation>,
    /// The first operations, in their order.
    pub operations: Vec<OperationTime>,
    /// Operations that are not in the list.
    pub unlisted_operations: u64,
}

impl Times {
    /// Time of the whole program, min.
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

    /// Drops operations without motion.
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

    /// Whether no rotation so far is as fast.
    #[inline]
    pub(crate) fn is_fastest(&self, rad_per_min: f64) -> bool {
        self.fastest.is_none_or(|fastest| rad_per_min > fastest.rad_per_min)
    }

    pub(crate) fn slow(&mut self, at: Location, minutes: f64) {
        if self.slowed_blocks == 0 {
            self.first_slowed = at;
        }
        self.slowed_blocks += 1;
        self.slowed_min += minutes;
    }
}
