//! Conformance checks for every machine, written by hand or generated.
//!
//! Poses are made by the [oracle](crate::oracle) from random axis values: the tip inside a cube of 1 m, rotaries over
//! the whole revolution and, with raised probability, at 0, ±90°, ±180°, at the pole, at the rim, and 1e-3 to 1e-12 rad
//! from these angles. Part origin, gauge length and dimensions are random too.
//!
//! [`check`] runs everything and panics with the machine, the set-up and the pose; [`find_fault`] returns the fault;
//! [`conformance!`](crate::conformance!) makes a test module with one test per [`Check`].

mod blocks;
mod declaration;
mod reach;
mod setting;
mod solutions;

use core::fmt;

use pp_runtime::kinematics::Machine;

use self::blocks::Margins;
use self::declaration::declaration;
use self::setting::Setting;
use crate::oracle::Oracle;
use crate::random::Random;
use crate::subject::{Erased, Subject};

/// Largest distance between the tip reached and the given tip, mm, where the linear axes are well conditioned.
pub const POSITION: f64 = 1e-9;
/// Largest distance times the determinant, mm, where they are not.
pub const POSITION_BY_DETERMINANT: f64 = 1e-12;
/// Largest angle between the axis reached and the given axis, rad, beyond the deviation that the solution reports.
pub const AXIS: f64 = 1e-12;
/// Largest difference of a rotary value from the one that made the pose, rad, times the sine of the angle to the pole
/// or the rim, whichever is smaller.
pub const ROTARY: f64 = 1e-9;
/// Sine below which only poses are compared, not rotary values.
pub const SMALLEST_SINE: f64 = 1e-6;
/// Largest distance of forward kinematics from the matrix product, as a share of travel and arms (plus 1 mm).
pub const FORWARD_SHARE: f64 = 1e-13;
/// Largest angle between the axis of forward kinematics and that of the matrix product, rad.
pub const FORWARD_AXIS: f64 = 1e-13;
/// Largest difference of the length of an axis from 1.
pub const UNIT: f64 = 1e-14;
/// Largest difference of `rates` from the derivatives of the matrix product, as a share of linear travel plus rotation
/// times arm length.
pub const RATE_SHARE: f64 = 1e-13;
/// Largest median of bound divided by true deviation, over blocks as in a cut.
pub const MOTION_MEDIAN: f64 = 1.05;
/// Samples per block.
const BLOCK_POINTS: usize = 1000;
/// Poses of the other checks for one block of the motion check, which needs 1000 samples.
const POSES_PER_BLOCK: usize = 50;
/// Largest rotation of an axis in a block as in a cut, rad.
const CUT_ROTATION: f64 = 0.1;
/// Poses per set-up.
const POSES_PER_SET_UP: usize = 16;

/// One family of checks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Check {
    /// `AXES`, `HELD`, `DIMENSIONS`, joints and `validate` agree with each other.
    Declaration,
    /// Forward kinematics is the product of the declared joints.
    Forward,
    /// Every reachable pose is solved; every solution gives the pose back; the axis values that made the pose are among
    /// the solutions; branches come in their documented order; `linear_axes` and `reach` agree.
    Inverse,
    /// At the exact pole there is one solution, and the free rotary keeps its held value.
    Pole,
    /// Axes outside the cone are refused, those inside are not; less than `REACH_TOLERANCE` outside counts as rounding.
    Reach,
    /// NaN and infinity have no solution.
    NotFinite,
    /// `rates` are the derivatives of the product of the declared joints.
    Rates,
    /// The bound of `motion` is never below the sampled deviation of a block, and not far above it.
    Motion,
}

impl Check {
    /// All checks.
    pub const ALL: [Self; 8] = [
        Self::Declaration,
        Self::Forward,
        Self::Inverse,
        Self::Pole,
        Self::Reach,
        Self::NotFinite,
        Self::Rates,
        Self::Motion,
    ];
}

/// A rule that a machine breaks.
#[derive(Debug, Clone)]
pub struct Fault {
    /// The rule that is broken.
    pub rule: &'static str,
    /// Machine, set-up, pose and numbers.
    pub details: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.rule, self.details)
    }
}

/// Makes a test module `$name` for a machine: one test per [`Check`](crate::conformance::Check), with `$poses` random
/// poses each (default 2000).
///
/// A machine with `required` dimensions needs a sample of them, in mm and rad:
/// `conformance!(Trunnion, kinematics, sample = { height: 120.5 });`.
///
/// In `src` it needs `#[cfg(test)]`: a dev-dependency is there for tests only. In `tests/` a module with the name of
/// the crate hides the crate, so `$name` is another one.
#[macro_export]
macro_rules! conformance {
    ($machine:ty, $name:ident $(, sample = $sample:tt)?) => {
        $crate::conformance!($machine, $name, 2000 $(, sample = $sample)?);
    };
    ($machine:ty, $name:ident, $poses:expr) => {
        $crate::conformance!($machine, $name, $poses, sample = {});
    };
    ($machine:ty, $name:ident, $poses:expr, sample = { $($dimension:ident: $value:expr),* $(,)? }) => {
        mod $name {
            #[allow(unused_imports)]
            use super::*;
            use $crate::conformance::Check;

            #[allow(unused_mut)]
            fn sample() -> $machine {
                let mut machine = <$machine>::default();
                $(machine.$dimension = $value;)*
                machine
            }

            fn run(check: Check) {
                $crate::conformance::run(sample, check, $poses);
            }

            #[test]
            fn declaration_is_consistent() {
                run(Check::Declaration);
            }
            #[test]
            fn forward_kinematics_is_the_matrix_product() {
                run(Check::Forward);
            }
            #[test]
            fn every_reachable_pose_is_solved_and_its_axis_values_found() {
                run(Check::Inverse);
            }
            #[test]
            fn the_free_rotary_keeps_its_held_value_at_the_pole() {
                run(Check::Pole);
            }
            #[test]
            fn axes_are_refused_where_the_machine_cannot_reach() {
                run(Check::Reach);
            }
            #[test]
            fn nan_and_infinity_have_no_solution() {
                run(Check::NotFinite);
            }
            #[test]
            fn rates_are_the_derivatives_of_the_matrix_product() {
                run(Check::Rates);
            }
            #[test]
            fn no_block_deviates_more_than_the_bound_of_motion() {
                run(Check::Motion);
            }
        }
    };
}

/// Runs all checks of a machine whose dimensions have defaults, with `poses` random poses each.
///
/// # Panics
/// With the first [`Fault`].
pub fn check<M: Machine>(poses: usize) {
    for check in Check::ALL {
        run(M::default, check, poses);
    }
}

/// Runs one check with `poses` random poses. `sample` is the machine with a value for each `required` dimension: as
/// `default` makes it, if it has none.
///
/// # Panics
/// With the first [`Fault`].
pub fn run<M: Machine>(sample: fn() -> M, check: Check, poses: usize) {
    if let Err(fault) = perform(&Erased(sample()), check, poses) {
        panic!("{fault}");
    }
}

/// The first fault of a machine whose dimensions have defaults, if it has one.
#[must_use]
pub fn find_fault<M: Machine>(poses: usize) -> Option<Fault> {
    Check::ALL.into_iter().find_map(|check| perform(&Erased(M::default()), check, poses).err())
}

fn perform(declared: &dyn Subject, check: Check, poses: usize) -> Result<(), Fault> {
    let dimensions = declared.dimensions().iter().enumerate();
    let missing: Vec<String> = dimensions
        .filter(|(index, _)| declared.dimension(*index).is_nan())
        .map(|(_, dimension)| format!("{}: 100.0", dimension.name))
        .collect();
    if !missing.is_empty() {
        return Err(Fault {
            rule: "every `required` dimension has a value",
            details: format!(
                "machine {}: give a sample of its dimensions, in mm and rad, such as `sample = {{ {} }}`, as the last argument of \
                 `conformance!`",
                declared.name(),
                missing.join(", ")
            ),
        });
    }
    if check == Check::Declaration {
        return declaration(declared);
    }
    let poses = if check == Check::Motion { poses.div_ceil(POSES_PER_BLOCK) } else { poses };
    let mut margins = Margins::default();
    // Every chain has its own random numbers.
    let letters =
        declared.axes().iter().fold(check as u64, |seed, axis| seed * 131 + u64::from(u32::from(axis.letter)));
    let mut random = Random::new(letters);
    let mut done = 0;
    let mut attempts = 0;
    while done < poses {
        let setting = Setting::draw(declared, attempts == 0, &mut random);
        attempts += 1;
        for _ in 0..POSES_PER_SET_UP.min(poses - done) {
            match check {
                Check::Declaration => {}
                Check::Forward => setting.forward(&mut random)?,
                Check::Inverse => setting.inverse(&mut random)?,
                Check::Pole => setting.pole(&mut random)?,
                Check::Reach => setting.reach(&mut random)?,
                Check::NotFinite => setting.not_finite(&mut random)?,
                Check::Rates => setting.rates(&mut random)?,
                Check::Motion => setting.motion(&mut random, &mut margins)?,
            }
            done += 1;
        }
    }
    margins.check(declared)
}

/// Whether an error exceeds its tolerance; NaN always does.
fn exceeds(error: f64, allowed: f64) -> bool {
    error > allowed || error.is_nan()
}

fn position_tolerance(determinant: f64) -> f64 {
    POSITION.max(POSITION_BY_DETERMINANT / determinant)
}

fn oracle_of(machine: &dyn Subject) -> Oracle {
    let joints = (0..machine.axes().len()).map(|index| machine.joint(index)).collect();
    Oracle::new(machine.axes(), joints, machine.tool_axis())
}

/// `σ` of the first branch: decided at the default dimensions and held values, then fixed.
fn first_branch(declared: &dyn Subject, current: &Oracle) -> Option<f64> {
    let default = oracle_of(declared);
    let held = declared.default_held();
    let (at_default, now) = (default.rotaries(&held)?, current.rotaries(&held)?);
    let sign = default.sign(*default.rotary().get(1)?);
    let (alpha1, alpha2) = (at_default.cosine_part(), at_default.sine_part());
    if alpha1.abs() > 1e-9 {
        Some(alpha1.signum() * sign)
    } else if now.cosine_part().abs() < 1e-9 {
        Some(-alpha2.signum())
    } else {
        // Zero at the defaults only: the machine decides which rule applies.
        None
    }
}
