//! Words of rotary axes: which whole turn, at what cost, and how many turns a written word shows.
//!
//! Everything here counts whole units of the words, so that limits hold for what is written and turns are exact.

mod metric;
mod nearest_turn;
mod rollover;

pub use metric::Cost;
pub(crate) use metric::{RotaryMetric, RotaryTarget, RotaryWords, RotationSense};
pub(crate) use nearest_turn::{AngleScale, MAX_TURNS, OutOfLimits, Rotary, choose};
pub(crate) use rollover::Rollover;
