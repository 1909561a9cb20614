//! A set-up applied to a machine: its dimensions, travel and speeds for this job.

use crate::kinematics::{AnyMachine, Axis, Invalid, Limits, Machine};

use super::SetUp;

/// Travel and speeds of the axes for one job, in chain order: the planner's own copy of what the machine declares.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisBounds {
    /// mm or rad, inclusive; `None` is endless. Linear limits are machine coordinates.
    pub limits: Vec<Option<Limits>>,
    /// mm/min or rad/min; `None` is unlimited.
    pub speeds: Vec<Option<f64>>,
}

impl SetUp {
    /// The machine with this job's dimensions and part origin; the gauge length is set at each tool.
    ///
    /// # Errors
    /// [`Invalid`] if the machine's formulas do not hold for these dimensions.
    pub fn machine<M: Machine>(&self) -> Result<M, Invalid> {
        let mut machine = M::default();
        self.apply(&mut machine)?;
        Ok(machine)
    }

    /// [`machine`](Self::machine) for a machine whose type is not known.
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

    /// Travel and speeds of the machine's axes: as declared, unless this set-up says otherwise.
    #[must_use]
    pub fn travel(&self, axes: &[Axis]) -> AxisBounds {
        AxisBounds {
            limits: axes.iter().map(|axis| self.limits.get(&axis.letter).copied().unwrap_or(axis.limits)).collect(),
            speeds: axes.iter().map(|axis| self.speeds.get(&axis.letter).copied().or(axis.speed)).collect(),
        }
    }
}
