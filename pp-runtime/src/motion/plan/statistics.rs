//! What is counted while a program is planned.

use crate::kinematics::MotionBound;

/// What was met on the way.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Statistics {
    /// Motions of the CL data that were posted.
    pub motions: u64,
    /// Motions whose tool axis lies outside the reachable set by more than arithmetic, yet within tolerance.
    pub deviations: u64,
    /// Largest of these deviations, rad.
    pub largest_deviation_rad: f64,
    /// Safe sequences.
    pub sequences: u64,
    /// Blocks in inverse time.
    pub inverse_time: u64,
    /// Motions so near the pole that their tool axis was put there, and the first rotary kept its value.
    pub near_pole: u64,
    /// Largest angle by which one of them was turned, rad.
    pub largest_at_pole_rad: f64,
    /// Times that the rotary axes were rewound out of the part.
    pub rewinds: u64,
    /// Blocks inserted into feed motions so that tip and tool axis stay within tolerance.
    pub inserted: u64,
    /// Holes by cycles of the control.
    pub cycles: u64,
    /// Arcs that the control traces.
    pub arcs: u64,
    /// Arcs that became chords.
    pub chorded: ChordedArcs,
    /// Largest certified distance of the tip from its straight line in feed blocks that turn an axis, mm.
    pub largest_tip_bound_mm: f64,
    /// Largest certified angle of the tool axis from its even turn in these blocks, rad.
    pub largest_axis_bound_rad: f64,
}

/// Arcs that became chords, by reason.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChordedArcs {
    /// A rotary axis turns, or the program's coordinates are not square.
    pub frame: u64,
    /// The plane is none of the program's, or none in which the control has arcs.
    pub plane: u64,
    /// The radius is outside what is configured.
    pub radius: u64,
    /// Rounded words cannot say it within tolerance.
    pub rounding: u64,
}

impl Statistics {
    /// What is certified of a block; `axis`: the tool axis is held to a path, too.
    pub(crate) fn certified(&mut self, bound: &MotionBound, axis: bool) {
        self.largest_tip_bound_mm = self.largest_tip_bound_mm.max(bound.tip);
        if axis {
            self.largest_axis_bound_rad = self.largest_axis_bound_rad.max(bound.axis);
        }
    }

    /// A place whose tool axis is this angle off that of the CL data, rad.
    pub(crate) fn deviates(&mut self, deviation: f64, at_pole: bool) {
        let (count, largest) = match at_pole {
            true => (&mut self.near_pole, &mut self.largest_at_pole_rad),
            false => (&mut self.deviations, &mut self.largest_deviation_rad),
        };
        *count += 1;
        *largest = largest.max(deviation);
    }
}
