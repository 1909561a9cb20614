//! Counts and largest deviations of a program, for the summary.

use crate::kinematics::math::larger;
use crate::kinematics::{MotionBound, RoughDeviation};
use crate::motion::place::PathTolerance;

/// Statistics of a program.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Statistics {
    /// Motions of the CL data that were posted.
    pub motions: u64,
    /// Motions whose tool axis is out of reach by more than rounding of arithmetic, yet within tolerance.
    pub deviations: u64,
    /// Largest of these deviations.
    pub largest_deviation_rad: f64,
    /// Safe sequences.
    pub sequences: u64,
    /// Links on the path of the CL data: rapids that rotate the tool.
    pub links: u64,
    /// Blocks in inverse time.
    pub inverse_time: u64,
    /// Blocks in which linear axes move by rounding alone beside a rotation, where the control takes the time from
    /// them.
    pub faint: u64,
    /// Motions whose tool axis was so near the pole that it was moved there, while the first rotary axis kept its
    /// angle.
    pub near_pole: u64,
    /// Largest angle by which such a tool axis was moved.
    pub largest_at_pole_rad: f64,
    /// Rewinds of the rotary axes.
    pub rewinds: u64,
    /// Blocks inserted into feed motions so that tip and tool axis stay within tolerance.
    pub inserted: u64,
    /// Holes by cycles of the control.
    pub cycles: u64,
    /// Arcs written as arcs.
    pub arcs: u64,
    /// Arcs written as chords.
    pub chorded: ChordedArcs,
    /// Largest certified distance of the tip from its straight line in feed blocks with rotation.
    pub largest_tip_bound_mm: f64,
    /// Largest certified angle of the tool axis from its great circle in these blocks.
    pub largest_axis_bound_rad: f64,
    /// Largest rotation of a rotary axis in the cut while the tip rests and the tool axis keeps to its tolerance.
    pub largest_on_spot_rad: f64,
    /// Largest certified angle of the tool axis from the programmed one, where the tip is, in these blocks.
    pub largest_lag_rad: f64,
    /// Tool whose surface is off by most through these angles; `None` if none is known to be.
    pub surface: Option<SurfaceDeviation>,
    /// Largest certified bounds of the tool in the spindle, since it was loaded.
    of_tool: RoughDeviation,
}

/// A tool and the largest angle between its axis and the programmed one, where the tip is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceDeviation {
    /// Radius of the tool.
    pub radius_mm: f64,
    /// The angle.
    pub angle_rad: f64,
}

impl SurfaceDeviation {
    /// How far a ball is off.
    #[must_use]
    pub fn off_mm(&self) -> f64 {
        self.radius_mm * self.angle_rad
    }
}

/// Arcs written as chords, by reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChordedArcs {
    /// A rotary axis rotates, or the coordinates of the program are not orthogonal.
    pub frame: u64,
    /// The arc is not parallel to a plane of the program, or the control has no arcs in that plane.
    pub plane: u64,
    /// The radius is outside the configured range.
    pub radius: u64,
    /// Rounded words would leave the tolerance.
    pub rounding: u64,
}

impl Statistics {
    /// Takes the certified bounds of a block. Without a tolerance of the tool axis this is not held to a path.
    pub(crate) fn certified(&mut self, bound: &MotionBound, tolerance: PathTolerance) {
        let of_tool = &mut self.of_tool;
        of_tool.tip = larger(bound.tip, of_tool.tip);
        self.largest_tip_bound_mm = larger(of_tool.tip, self.largest_tip_bound_mm);
        if tolerance.axis_rad.is_finite() {
            of_tool.axis = larger(bound.axis, of_tool.axis);
            of_tool.axis_step = larger(bound.lag(tolerance.tip_mm), of_tool.axis_step);
            self.largest_axis_bound_rad = larger(of_tool.axis, self.largest_axis_bound_rad);
            self.largest_lag_rad = larger(of_tool.axis_step, self.largest_lag_rad);
        }
    }

    /// Ends the work of a tool: its bounds belong to its radius.
    pub(crate) fn end_tool(&mut self, radius_mm: Option<f64>) {
        let RoughDeviation { axis, axis_step, .. } = std::mem::take(&mut self.of_tool);
        let angle_rad = larger(axis, axis_step);
        if let Some(radius_mm) = radius_mm.filter(|_| angle_rad > 0.0) {
            let this = SurfaceDeviation { radius_mm, angle_rad };
            self.surface = Some(self.surface.filter(|other| other.off_mm() >= this.off_mm()).unwrap_or(this));
        }
    }

    /// Largest certified bounds of the tool so far: what is below them changes no statistics.
    #[inline]
    pub(crate) fn largest_deviation(&self, tolerance: PathTolerance) -> RoughDeviation {
        let counted = |largest: f64| if tolerance.axis_rad.is_finite() { largest } else { f64::INFINITY };
        RoughDeviation {
            tip: self.of_tool.tip,
            axis: counted(self.of_tool.axis),
            axis_step: counted(self.of_tool.axis_step),
        }
    }

    /// Takes a rotation in the cut with the tip at rest.
    pub(crate) fn rotates_on_spot(&mut self, angle_rad: f64) {
        self.largest_on_spot_rad = self.largest_on_spot_rad.max(angle_rad);
    }

    /// Counts a place whose tool axis deviates from that of the CL data.
    pub(crate) fn deviates(&mut self, deviation_rad: f64, at_pole: bool) {
        let (count, largest) = match at_pole {
            true => (&mut self.near_pole, &mut self.largest_at_pole_rad),
            false => (&mut self.deviations, &mut self.largest_deviation_rad),
        };
        *count += 1;
        *largest = largest.max(deviation_rad);
    }
}
