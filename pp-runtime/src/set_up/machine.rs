//! Applies a set-up to a machine: dimensions, travel and speeds for this job.

use nalgebra::{Matrix3, Vector3};

use crate::keys::printed_along;
use crate::kinematics::{AnyMachine, Axis, AxisKind, Dimension, Invalid, Limits, MAX_AXES, Machine};

use super::SetUp;

/// Travel and speeds of the axes for one job, in chain order. The planner uses these, not the declaration of the
/// machine.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisBounds {
    /// Travel in mm or rad, inclusive; `None`: endless. Limits of linear axes are machine coordinates.
    pub limits: Vec<Option<Limits>>,
    /// Largest speed in mm/min or rad/min; `None`: unlimited.
    pub speeds: Vec<Option<f64>>,
}

/// Largest difference of equal limits, mm or rad.
const SAME_LIMIT: f64 = 1e-9;

impl SetUp {
    /// Returns the machine with the dimensions and the part origin of this job. The gauge length is set at each tool.
    ///
    /// # Errors
    /// [`Invalid`] if the machine's formulas do not hold for these dimensions.
    pub fn machine<M: Machine>(&self) -> Result<M, Invalid> {
        let mut machine = M::default();
        self.apply(&mut machine)?;
        Ok(machine)
    }

    /// [`machine`](Self::machine) for a machine whose type is not known. Dimensions that the set-up does not name stay
    /// as they are in `machine`.
    ///
    /// # Errors
    /// Those of [`machine`](Self::machine).
    pub fn machine_for(&self, machine: &dyn AnyMachine) -> Result<Box<dyn AnyMachine>, Invalid> {
        let mut machine = machine.to_boxed();
        self.apply(&mut *machine)?;
        Ok(machine)
    }

    fn apply(&self, machine: &mut dyn AnyMachine) -> Result<(), Invalid> {
        for (index, dimension) in machine.dimensions().iter().enumerate() {
            if let Some(&value) = self.dimensions.get(dimension.name) {
                machine.set_dimension(index, value);
            }
        }
        machine.set_up(self.part_origin.into(), 0.0);
        machine.validate()
    }

    /// The reason why the formulas of a machine do not hold with these dimensions, and the remedy. All dimensions that
    /// are missing are named.
    pub(crate) fn refusal(&self, machine: &dyn AnyMachine, invalid: &Invalid) -> (String, String) {
        let name = machine.name();
        match invalid {
            Invalid::Required { .. } => {
                let dimensions = machine.dimensions();
                let is_missing = |dimension: &&Dimension| {
                    dimension.default.is_nan() && !self.dimensions.contains_key(dimension.name)
                };
                let missing: Vec<&str> = dimensions.iter().filter(is_missing).map(|dimension| dimension.name).collect();
                let keys = missing.iter().map(|name| format!("`dimensions.{name}`")).collect::<Vec<_>>().join(", ");
                let lines = missing.iter().map(|name| format!("`{name} = ...`")).collect::<Vec<_>>().join(", ");
                let (are, values, them) = match missing.len() {
                    1 => ("is", "its own value", "it"),
                    _ => ("are", "its own values", "them"),
                };
                let text = format!("{keys} {are} missing: each {name} has {values}");
                let help = format!(
                    "measure {them} at the machine, and write {lines} in the section `[dimensions]` of the configuration"
                );
                (text, help)
            }
            Invalid::NotFinite { .. } | Invalid::Zero { .. } => {
                let text = format!("the kinematics of {name} are invalid with these dimensions: {invalid}");
                (text, "correct the dimensions in the configuration".to_owned())
            }
        }
    }

    /// Travels of this set-up that are wider than those with which the machine is declared, one sentence each.
    pub(crate) fn wider_limits(&self, axes: &[Axis]) -> impl Iterator<Item = String> {
        axes.iter().filter_map(|axis| {
            let (declared, given) = (axis.limits?, *self.limits.get(&axis.letter)?);
            let shown = |limits: Limits| {
                let [lower, upper] = [limits.lower, limits.upper].map(|value| printed_along(axis, value));
                format!("{lower} to {upper}")
            };
            let wider = given.is_none_or(|given| {
                given.lower < declared.lower - SAME_LIMIT || given.upper > declared.upper + SAME_LIMIT
            });
            wider.then(|| {
                let (given, declared) = (given.map_or_else(|| "free".to_owned(), shown), shown(declared));
                format!(
                    "`limits` of {} are wider than declared for the machine: {given}, declared {declared}",
                    axis.letter
                )
            })
        })
    }

    /// Travel and speeds of the axes: as this set-up states them, else as the machine declares them.
    #[must_use]
    pub fn travel(&self, axes: &[Axis]) -> AxisBounds {
        AxisBounds {
            limits: axes.iter().map(|axis| self.limits.get(&axis.letter).copied().unwrap_or(axis.limits)).collect(),
            speeds: axes.iter().map(|axis| self.speeds.get(&axis.letter).copied().or(axis.speed)).collect(),
        }
    }
}

/// Components of a vector along the solved linear axes at the zero position; 0 for every other axis.
pub(crate) fn along_axes(machine: &dyn AnyMachine, vector: &Vector3<f64>) -> [f64; MAX_AXES] {
    let linear = |index: &usize| machine.axes()[*index].kind == AxisKind::Linear && !machine.axes()[*index].held;
    let solved: Vec<usize> = (0..machine.axes().len()).filter(linear).collect();
    // Columns: direction in which each axis moves the tool for a positive word.
    let column = |&index: &usize| {
        let joint = machine.joint(index);
        joint.direction.into_inner() * joint.sign
    };
    let columns: Vec<Vector3<f64>> = solved.iter().map(column).collect();
    let mut words = [0.0; MAX_AXES];
    if columns.len() == 3
        && let Some(inverse) = Matrix3::from_columns(&columns).try_inverse()
    {
        for (&index, word) in solved.iter().zip((inverse * vector).iter()) {
            words[index] = *word;
        }
    }
    words
}
