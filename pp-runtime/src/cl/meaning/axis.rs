//! The modal tool axis.
//!
//! A GOTO without i, j, k keeps the tool axis in force. Every operation starts with (0, 0, 1). Some CAM systems write
//! i, j, k only when they change; a first GOTO without them, after an operation that ended with a tilted tool, is
//! refused: its tool axis would be a guess.
//!
//! MULTAX/OFF holds the tool axis: a point that tilts the tool after it contradicts it and is refused. Without i, j, k
//! the tool keeps its axis in CATIA ("the tool axis is considered as locked", *APT Formats*); it is back at (0, 0, 1)
//! in the output of Autodesk, whose post writes MULTAX/OFF before sections along Z only; elsewhere it is in doubt.

use crate::cl::text::{ClFault, Span};
use crate::cl::vector;
use crate::diag::code::cl;
use crate::kinematics::math;
use crate::nalgebra::{UnitVector3, Vector3};
use crate::program::Location;

/// Deviation from length 1 that rounding to five decimals explains.
const ROUNDING: f64 = 1e-5;

/// Largest permitted deviation from length 1.
const TOLERATED: f64 = 1e-3;

/// Sine of the angle to Z above which a tool axis is tilted. One millionth is below the digits of CL data.
const TILT: f64 = 1e-6;

/// Reason why the tool axis of a GOTO without i, j, k is in doubt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AxisDoubt {
    None,
    /// The operation before ended with a tilted tool.
    NewOperation,
    /// MULTAX/OFF after a tilt, from a CAM system of which it is not known what it means for the axis.
    MultaxOff,
}

/// Tool axis at a MULTAX/OFF that leaves a tilted tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AxisAfterOff {
    /// The tool keeps its axis.
    Kept,
    /// It is back at (0, 0, 1).
    Upright,
    /// Not known.
    Unknown,
}

/// Largest difference of a component of a tool axis from the one that MULTAX/OFF holds, by the digits of CL data.
const SAME_DIRECTION: f64 = 1e-5;

/// The tool axis in force, in the frame of the file.
#[derive(Debug)]
pub(crate) struct ModalAxis {
    axis: UnitVector3<f64>,
    doubt: AxisDoubt,
    /// TLAXIS has come since the last motion: its axis holds for an operation that begins now.
    stated: bool,
    /// A record of the operation has stated it.
    of_record: bool,
    /// MULTAX/OFF is in force: its line, and the tool axis before it.
    held: Option<(u64, UnitVector3<f64>)>,
    /// Number of axes that were normalised by more than rounding.
    normalised: u64,
    first_normalised: Location,
}

impl Default for ModalAxis {
    fn default() -> Self {
        ModalAxis {
            axis: Vector3::z_axis(),
            doubt: AxisDoubt::None,
            stated: false,
            of_record: false,
            held: None,
            normalised: 0,
            first_normalised: Location::default(),
        }
    }
}

/// Whether an axis was normalised by more than rounding.
pub(crate) type Normalised = bool;

impl ModalAxis {
    /// Tool axis of a point with or without i, j, k.
    #[inline(always)]
    pub(crate) fn at_point(
        &mut self,
        given: Option<[f64; 3]>,
        at: Span,
    ) -> Result<(UnitVector3<f64>, Normalised), Box<ClFault>> {
        self.stated = false;
        match (given, self.doubt) {
            (Some(given), _) => {
                let normalised = self.set(given, at, true)?;
                Ok((self.axis, normalised))
            }
            (None, AxisDoubt::None) => Ok((self.axis, false)),
            (None, doubt) => Err(Box::new(in_doubt(doubt, at))),
        }
    }

    /// Sets the tool axis of TLAXIS.
    pub(crate) fn state(&mut self, given: [f64; 3], at: Span, here: Location) -> Result<(), ClFault> {
        self.state_if(true, given, at, here)
    }

    /// Sets the tool axis of the third column of CSYS, which MULTAX/OFF does not hold: it is another set-up of the
    /// part.
    pub(crate) fn state_of_set_up(&mut self, given: [f64; 3], at: Span, here: Location) -> Result<(), ClFault> {
        self.state_if(false, given, at, here)
    }

    fn state_if(&mut self, permitted: bool, given: [f64; 3], at: Span, here: Location) -> Result<(), ClFault> {
        let normalised = self.set(given, at, permitted)?;
        self.stated = true;
        self.count(normalised, here);
        Ok(())
    }

    /// Counts an axis that was normalised by more than rounding.
    #[inline]
    pub(crate) fn count(&mut self, normalised: Normalised, here: Location) {
        if normalised {
            if self.normalised == 0 {
                self.first_normalised = here;
            }
            self.normalised += 1;
        }
    }

    /// The tool axis, if a record of the operation has stated it.
    pub(crate) fn of_record(&self) -> Option<[f64; 3]> {
        self.of_record.then(|| self.axis.into_inner().into())
    }

    /// Number of axes that were normalised by more than rounding.
    pub(crate) fn normalised(&self) -> u64 {
        self.normalised
    }

    /// Place of the first of them.
    pub(crate) fn first_normalised(&self) -> Location {
        self.first_normalised
    }

    /// Returns the tool axis in force; refused if it is in doubt.
    pub(crate) fn known(&mut self, at: Span) -> Result<UnitVector3<f64>, ClFault> {
        Ok(self.at_point(None, at)?.0)
    }

    /// TOOL PATH or a tool record.
    pub(crate) fn begin_operation(&mut self) {
        if self.stated {
            return;
        }
        if self.is_tilted() {
            self.doubt = AxisDoubt::NewOperation;
        }
        (self.axis, self.of_record) = (Vector3::z_axis(), false);
    }

    /// MULTAX, MULTAX/ON: points may tilt the tool.
    pub(crate) fn release(&mut self) {
        self.held = None;
    }

    /// MULTAX/OFF.
    pub(crate) fn hold(&mut self, then: AxisAfterOff, here: Location) {
        self.held = Some((here.line, self.axis));
        if then == AxisAfterOff::Kept {
            return;
        }
        if self.is_tilted() && then == AxisAfterOff::Unknown {
            self.doubt = AxisDoubt::MultaxOff;
        }
        (self.axis, self.of_record) = (Vector3::z_axis(), false);
    }

    fn is_tilted(&self) -> bool {
        self.axis.z < 0.0 || math::hypot(self.axis.x, self.axis.y) > TILT
    }

    /// Sets the tool axis; `if_permitted`: only one that MULTAX/OFF permits.
    #[inline(always)]
    fn set(&mut self, given: [f64; 3], at: Span, if_permitted: bool) -> Result<Normalised, Box<ClFault>> {
        let length = vector::length(given);
        let excess = (length - 1.0).abs();
        // Finite numbers can overflow to infinity here, not to NaN; neither passes this comparison.
        let tolerated = excess <= TOLERATED;
        if !tolerated {
            return Err(Box::new(no_unit_vector(given, length, at)));
        }
        let axis = UnitVector3::new_unchecked(Vector3::from(given.map(|component| component / length)));
        if if_permitted && self.held.is_some() {
            self.check_held(axis, at)?;
        }
        (self.axis, self.of_record) = (axis, true);
        self.doubt = AxisDoubt::None;
        Ok(excess > ROUNDING)
    }

    /// Refuses a tool axis that the MULTAX/OFF in force does not permit. While the axis is in doubt, the point may
    /// state that it is the one before.
    #[cold]
    fn check_held(&self, axis: UnitVector3<f64>, at: Span) -> Result<(), ClFault> {
        let Some((line, before)) = self.held else { return Ok(()) };
        let is = |other: UnitVector3<f64>| (axis.into_inner() - other.into_inner()).amax() <= SAME_DIRECTION;
        if is(self.axis) || (self.doubt == AxisDoubt::MultaxOff && is(before)) {
            return Ok(());
        }
        Err(cl::TOOL_AXIS.cl_fault(
            "tool axis",
            at,
            format!("MULTAX/OFF of line {line} holds the tool axis, and this record changes it"),
            "if the points hold, delete that MULTAX/OFF; if MULTAX/OFF holds, i, j, k of the points are wrong",
        ))
    }
}

/// Fault: i, j, k are no unit vector.
#[cold]
fn no_unit_vector(given: [f64; 3], length: f64, at: Span) -> ClFault {
    let text = if given.iter().all(|value| value.abs() < f64::MIN_POSITIVE) {
        "the tool axis is 0, 0, 0 and has no direction".to_string()
    } else {
        format!("the tool axis has length {length:.6}, not 1")
    };
    cl::TOOL_AXIS.cl_fault("tool axis", at, text, "i, j, k must be a unit vector from the tip to the spindle")
}

/// Fault: a point has no tool axis, and the one in force is in doubt.
#[cold]
fn in_doubt(doubt: AxisDoubt, at: Span) -> ClFault {
    let (text, help) = match doubt {
        AxisDoubt::None | AxisDoubt::NewOperation => (
            "this point has no tool axis i, j, k, and the operation before ended with a tilted tool",
            "program i, j, k in the first GOTO of every operation",
        ),
        AxisDoubt::MultaxOff => (
            "this point has no tool axis i, j, k, and the tool was tilted at MULTAX/OFF",
            "write i, j, k in this GOTO; if the tool keeps its tilt after MULTAX/OFF, as in CATIA: `--dialect catia`; if it is along \
             Z again, as in the output of Autodesk: `--dialect autodesk`",
        ),
    };
    cl::TOOL_AXIS.cl_fault("tool axis", at, text, help)
}
