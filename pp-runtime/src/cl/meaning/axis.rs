//! The modal tool axis.
//!
//! A GOTO without i j k keeps the axis of the one before. Every operation starts with (0, 0, 1); an axis that was tilted
//! and is then taken for granted, by a CAM system that writes i j k only when they change, is refused instead of guessed.

use crate::cl::text::{ClFault, Span};
use crate::cl::vector;
use crate::nalgebra::{UnitVector3, Vector3};
use crate::program::Location;

/// CL data with five decimals is off by this much from length 1 by rounding alone.
const ROUNDING: f64 = 1e-5;

/// Up to this much a vector is still meant to be of length 1.
const TOLERATED: f64 = 1e-3;

/// Sine of the angle to Z above which an axis counts as tilted; a millionth is below the digits of CL data.
const TILT: f64 = 1e-6;

/// Why the axis of a GOTO without i j k is in doubt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AxisDoubt {
    None,
    /// The operation before ended tilted.
    NewOperation,
    /// MULTAX/OFF where the CAM system means (0, 0, 1) by it.
    MultaxOff,
}

/// The axis in force.
#[derive(Debug)]
pub(crate) struct ModalAxis {
    axis: UnitVector3<f64>,
    doubt: AxisDoubt,
    /// TLAXIS has stated the axis since the last motion, so an operation that begins now means it.
    stated: bool,
    /// Axes that were normalised beyond rounding.
    normalised: u64,
    first_normalised: Location,
}

impl Default for ModalAxis {
    fn default() -> Self {
        ModalAxis {
            axis: Vector3::z_axis(),
            doubt: AxisDoubt::None,
            stated: false,
            normalised: 0,
            first_normalised: Location::default(),
        }
    }
}

/// Whether an axis had to be normalised beyond rounding.
pub(crate) type Normalised = bool;

impl ModalAxis {
    /// The axis of a point with or without i j k.
    pub(crate) fn at_point(
        &mut self,
        given: Option<[f64; 3]>,
        at: Span,
    ) -> Result<(UnitVector3<f64>, Normalised), ClFault> {
        self.stated = false;
        if let Some(given) = given {
            let normalised = self.set(given, at)?;
            return Ok((self.axis, normalised));
        }
        match self.doubt {
            AxisDoubt::None => Ok((self.axis, false)),
            AxisDoubt::NewOperation => Err(ClFault::new(
                "tool axis",
                at,
                "the tool was tilted in the operation before, and this point does not say its tool axis",
                "write i, j, k with the first GOTO of every operation",
            )),
            AxisDoubt::MultaxOff => Err(ClFault::new(
                "tool axis",
                at,
                "the tool was tilted when MULTAX/OFF came, and this point does not say its tool axis",
                "write i, j, k with this GOTO, or turn the tool back before MULTAX/OFF",
            )),
        }
    }

    /// TLAXIS, and the third column of CSYS.
    pub(crate) fn state(&mut self, given: [f64; 3], at: Span, here: Location) -> Result<(), ClFault> {
        let normalised = self.set(given, at)?;
        self.stated = true;
        self.count(normalised, here);
        Ok(())
    }

    /// Counts an axis that had to be normalised.
    #[inline]
    pub(crate) fn count(&mut self, normalised: Normalised, here: Location) {
        if normalised {
            if self.normalised == 0 {
                self.first_normalised = here;
            }
            self.normalised += 1;
        }
    }

    /// Axes that were normalised beyond rounding.
    pub(crate) fn normalised(&self) -> u64 {
        self.normalised
    }

    /// Place of the first of them.
    pub(crate) fn first_normalised(&self) -> Location {
        self.first_normalised
    }

    /// The axis in force; an error if it is in doubt.
    pub(crate) fn known(&mut self, at: Span) -> Result<UnitVector3<f64>, ClFault> {
        self.at_point(None, at).map(|(axis, _)| axis)
    }

    /// TOOL PATH or a tool record.
    pub(crate) fn begin_operation(&mut self) {
        if self.stated {
            return;
        }
        if self.is_tilted() {
            self.doubt = AxisDoubt::NewOperation;
        }
        self.axis = Vector3::z_axis();
    }

    /// MULTAX/OFF where it means a return to (0, 0, 1).
    pub(crate) fn return_to_z(&mut self) {
        if self.is_tilted() {
            self.doubt = AxisDoubt::MultaxOff;
        }
        self.axis = Vector3::z_axis();
    }

    fn is_tilted(&self) -> bool {
        self.axis.z < 0.0 || self.axis.x.hypot(self.axis.y) > TILT
    }

    fn set(&mut self, given: [f64; 3], at: Span) -> Result<Normalised, ClFault> {
        let length = vector::length(given);
        let excess = (length - 1.0).abs();
        // A NaN cannot arise from finite numbers here, but an infinity can; neither passes this comparison.
        let tolerated = excess <= TOLERATED;
        if !tolerated {
            let text = if given.iter().all(|value| value.abs() < f64::MIN_POSITIVE) {
                "the tool axis is 0, 0, 0 and points nowhere".to_string()
            } else {
                format!("the tool axis has length {length:.6}, not 1")
            };
            return Err(ClFault::new(
                "tool axis",
                at,
                text,
                "i, j, k are a vector of length 1 from the tip to the spindle",
            ));
        }
        let [i, j, k] = given;
        self.axis = UnitVector3::new_unchecked(Vector3::new(i / length, j / length, k / length));
        self.doubt = AxisDoubt::None;
        Ok(excess > ROUNDING)
    }
}
