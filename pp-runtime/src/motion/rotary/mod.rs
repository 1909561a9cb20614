//! Words of rotary axes: choice of the whole turn, cost of a rotation, and rollover of written words.
//!
//! All angles are whole units of the words, so that limits hold for the written values and whole turns are exact.

mod metric;
mod nearest_turn;
mod rollover;

pub use metric::Cost;
pub(crate) use metric::{RotaryMetric, RotaryTarget, RotaryWords, RotationSense};
pub(crate) use nearest_turn::{Choice, MAX_TURNS, choose};
pub(crate) use rollover::Rollover;
