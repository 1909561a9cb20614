//! The axis values of a pose that are nearest to present ones: branch, whole revolutions and travel in one call.

use core::f64::consts::TAU;
use core::fmt;

use super::{AxisKind, Invalid, Limits, Machine, Pose, Solution, Unreachable, math};

/// Rounding of an axis value at the end of its travel, mm or rad.
const ROUNDING: f64 = 1e-9;

/// Reason why no axis values within the declared travel give a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NotNearest {
    /// The dimensions of the machine are missing, or its formulas do not hold with them ([`Machine::validate`]).
    Invalid(Invalid),
    /// No axis values at all give it.
    Unreachable(Unreachable),
    /// On each branch an axis is outside its travel.
    OutsideTravel {
        /// The first such axis of the first branch.
        axis: char,
        /// Machine coordinate of a linear axis there, mm; value of a rotary axis, rad, as near to the present one as
        /// whole revolutions permit.
        value: f64,
    },
}

impl fmt::Display for NotNearest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(reason) => reason.fmt(f),
            Self::Unreachable(reason) => reason.fmt(f),
            Self::OutsideTravel { axis: axis @ 'A'..='C', value } => {
                write!(f, "{axis} is outside its travel, at {:.4} degrees", value.to_degrees())
            }
            Self::OutsideTravel { axis, value } => {
                write!(f, "{axis} is outside its travel, at machine coordinate {value:.4} mm")
            }
        }
    }
}

impl core::error::Error for NotNearest {}

/// The solution of a pose in which the rotary axes rotate least from `now`, in sum over the axes; of equal ones the
/// first branch. Whole revolutions are added, and no solved axis leaves its declared travel. A rotary axis that is free
/// at the pole, and held axes, keep their value of `now`.
///
/// The travel of a rotary axis is in axis values, that of a linear axis in machine coordinates. `machine_zero`: machine
/// coordinate of each linear axis at axis value 0, mm, with the part of the gauge length that lies along the axis; in
/// the order of the chain, and what it has for rotary axes is not read. It is the key `machine_zero` of a configuration
/// plus that part of the length. Without it the travel of linear axes is not compared, as in a program that is posted
/// without that key.
///
/// The choice is made for one pose; a program is planned as a whole by `motion`.
///
/// ```
/// use pp_runtime::kinematics::{Machine, Pose, nearest};
/// use pp_runtime::nalgebra::{Point3, UnitVector3, Vector3};
///
/// pp_runtime::machine! {
///     /// A table that rotates about Z on a table that tilts about Y.
///     pub struct Table;
///     chain: C B | X Y Z;
///     limits = { B: -5..110, C: free };
/// }
///
/// let table = Table::default();
/// let axis = UnitVector3::new_normalize(Vector3::new(1.0, 0.0, 1.0));
/// let pose = Pose { tip: Point3::new(10.0, 0.0, 0.0), axis };
/// // C has been rotated by two revolutions and a bit.
/// let now = [725_f64.to_radians(), 0.0, 0.0, 0.0, 0.0];
/// let found = nearest(&table, &pose, &now, None)?;
/// assert!((found.axes[0].to_degrees() - 720.0).abs() < 1e-9 && (found.axes[1].to_degrees() - 45.0).abs() < 1e-9);
/// // With the part zero at machine coordinates X-480 Y-250 Z-400, and a tool of 120 mm on it.
/// let zero = [0.0, 0.0, -480.0, -250.0, -280.0];
/// assert_eq!(nearest(&table, &pose, &now, Some(&zero))?, found);
/// # Ok::<(), pp_runtime::kinematics::NotNearest>(())
/// ```
///
/// # Errors
/// [`NotNearest`]: the machine is not complete, no axis values give the pose, or none within the travel.
pub fn nearest<M: Machine>(
    machine: &M,
    pose: &Pose,
    now: &M::Axes,
    machine_zero: Option<&M::Axes>,
) -> Result<Solution<M::Axes>, NotNearest> {
    machine.validate().map_err(NotNearest::Invalid)?;
    let mut best: Option<Candidate<M::Axes>> = None;
    let mut outside = None;
    for solution in machine.inverse_kinematics(pose, now).iter() {
        match within_travel::<M>(solution, now, machine_zero) {
            Ok(candidate) => {
                if best.as_ref().is_none_or(|best| candidate.rotation < best.rotation) {
                    best = Some(candidate);
                }
            }
            Err(reason) => drop(outside.get_or_insert(reason)),
        }
    }
    match (best, outside) {
        (Some(best), _) => Ok(best.solution),
        (None, Some(outside)) => Err(outside),
        (None, None) => Err(NotNearest::Unreachable(match machine.reach(&pose.axis, now) {
            Err(reason) => reason,
            // A tip that is not finite.
            Ok(()) => Unreachable::NotFinite,
        })),
    }
}

/// A solution with its revolutions.
struct Candidate<A> {
    solution: Solution<A>,
    /// Sum of the rotations of its axes from the present values, rad.
    rotation: f64,
}

/// A solution with the revolutions that bring it nearest to `now`; or the first axis outside its travel.
fn within_travel<M: Machine>(
    solution: &Solution<M::Axes>,
    now: &M::Axes,
    machine_zero: Option<&M::Axes>,
) -> Result<Candidate<M::Axes>, NotNearest> {
    let mut found = Candidate { solution: *solution, rotation: 0.0 };
    let values = found.solution.axes.as_mut().iter_mut().zip(now.as_ref()).enumerate();
    for (axis, (index, (value, now))) in M::AXES.iter().zip(values).filter(|(axis, _)| !axis.held) {
        let compared = match axis.kind {
            AxisKind::Rotary => {
                *value += TAU * revolutions(*value, *now, axis.limits.as_ref());
                found.rotation += math::abs(*value - now);
                Some(*value)
            }
            AxisKind::Linear => machine_zero.map(|zero| *value + zero.as_ref()[index]),
        };
        if let (Some(limits), Some(value)) = (&axis.limits, compared)
            && !(limits.lower - ROUNDING..=limits.upper + ROUNDING).contains(&value)
        {
            return Err(NotNearest::OutsideTravel { axis: axis.letter, value });
        }
    }
    Ok(found)
}

/// Whole revolutions that bring a value as near to `now` as the travel permits.
fn revolutions(value: f64, now: f64, limits: Option<&Limits>) -> f64 {
    let wanted = libm::round((now - value) / TAU);
    let Some(limits) = limits else { return wanted };
    let fewest = libm::ceil((limits.lower - ROUNDING - value) / TAU);
    let most = libm::floor((limits.upper + ROUNDING - value) / TAU);
    if fewest > most { wanted } else { wanted.clamp(fewest, most) }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;
    use nalgebra::Point3;

    crate::machine! {
        /// A table with travel on both sides of a revolution.
        struct Table;
        chain: C B | X Y Z;
        d = (0, 0, 50);
        limits = { B: -30..110, C: -400..300, X: -150..150 };
    }

    crate::machine! {
        /// A head whose length each machine has of its own.
        struct Head;
        chain: | X Y Z C B;
        d = { B: (0, 0, pivot) };
        dims = { pivot: required };
    }

    #[test]
    fn a_machine_without_its_dimensions_has_no_answer() {
        let pose = Pose { tip: Point3::new(1.0, 2.0, 3.0), axis: nalgebra::Vector3::z_axis() };
        let mut head = Head::default();
        assert!(matches!(nearest(&head, &pose, &Head::HELD, None), Err(NotNearest::Invalid(Invalid::Required { .. }))));
        head.pivot = 200.0;
        assert!(nearest(&head, &pose, &Head::HELD, None).is_ok());
    }

    /// All axis values of a pose: each branch, each of seven revolutions of both axes.
    fn least_by_trying(pose: &Pose, now: &[f64; 5]) -> Option<f64> {
        let mut least: Option<f64> = None;
        for solution in Table::default().inverse_kinematics(pose, now).iter() {
            for (turn_c, turn_b) in (-3..=3).flat_map(|c| (-3..=3).map(move |b| (c, b))) {
                let mut axes = solution.axes;
                axes[0] += TAU * f64::from(turn_c);
                axes[1] += TAU * f64::from(turn_b);
                let inside = Table::AXES.iter().zip(axes).all(|(axis, value)| {
                    axis.limits.is_none_or(|limits| value >= limits.lower - 1e-9 && value <= limits.upper + 1e-9)
                });
                if inside {
                    let rotation = (axes[0] - now[0]).abs() + (axes[1] - now[1]).abs();
                    least = Some(least.map_or(rotation, |least| least.min(rotation)));
                }
            }
        }
        least
    }

    #[test]
    fn no_other_branch_or_revolution_is_nearer() {
        let machine = Table::default();
        let mut state = 7_u64;
        let mut random = |lower: f64, upper: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            lower + (upper - lower) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
        };
        let (mut found, mut refused, mut second) = (0, 0, 0);
        for _ in 0..4000 {
            let values = [random(-7.0, 5.2), random(-1.5, 2.5), random(-200.0, 200.0), random(-90.0, 90.0), 0.0];
            let pose = machine.forward_kinematics(&values);
            let now = [random(-6.9, 5.2), random(-0.5, 1.9), 0.0, 0.0, 0.0];
            match (nearest(&machine, &pose, &now, Some(&[0.0; 5])), least_by_trying(&pose, &now)) {
                (Ok(solution), Some(least)) => {
                    let axes = solution.axes;
                    let rotation = (axes[0] - now[0]).abs() + (axes[1] - now[1]).abs();
                    assert!((rotation - least).abs() < 1e-9, "{rotation} is not {least} at {values:?}, {now:?}");
                    let again = machine.forward_kinematics(&axes);
                    assert!((again.tip - pose.tip).norm() < 1e-9 && (again.axis.dot(&pose.axis) - 1.0).abs() < 1e-12);
                    found += 1;
                    second += i32::from(solution.branch == crate::kinematics::Branch::Second);
                }
                (Err(NotNearest::OutsideTravel { .. }), None) => refused += 1,
                (answer, least) => panic!("{answer:?}, but {least:?}"),
            }
        }
        assert!(found > 1000 && refused > 100 && second > 50, "{found} {refused} {second}");
    }

    #[test]
    fn a_pose_out_of_reach_has_its_reason() {
        let machine = Table::default();
        let pose = Pose { tip: Point3::new(f64::NAN, 0.0, 0.0), axis: nalgebra::Vector3::z_axis() };
        assert_eq!(nearest(&machine, &pose, &[0.0; 5], None), Err(NotNearest::Unreachable(Unreachable::NotFinite)));
        let far = Pose { tip: Point3::new(400.0, 0.0, 0.0), axis: nalgebra::Vector3::z_axis() };
        // C keeps its value at the pole, so X is too short.
        assert!(matches!(
            nearest(&machine, &far, &[0.0; 5], Some(&[0.0; 5])),
            Err(NotNearest::OutsideTravel { axis: 'X', value }) if (value - 400.0).abs() < 1e-9
        ));
    }

    #[test]
    fn the_travel_of_linear_axes_is_in_machine_coordinates() {
        let machine = Table::default();
        let at = |x: f64, zero: Option<f64>| {
            let pose = Pose { tip: Point3::new(x, 0.0, 0.0), axis: nalgebra::Vector3::z_axis() };
            nearest(&machine, &pose, &[0.0; 5], zero.map(|zero| [9.0, 9.0, zero, 0.0, 0.0]).as_ref())
        };
        // X -150..150: the part zero is at machine coordinate -350.
        assert!(at(400.0, Some(-350.0)).is_ok() && at(205.0, Some(-350.0)).is_ok());
        assert!(matches!(
            at(190.0, Some(-350.0)),
            Err(NotNearest::OutsideTravel { axis: 'X', value }) if (value + 160.0).abs() < 1e-9
        ));
        // Where it is unknown the travel is not compared.
        assert!(at(400.0, None).is_ok() && at(-450.0, None).is_ok());
    }
}
