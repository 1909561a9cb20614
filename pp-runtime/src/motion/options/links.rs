//! Motion between cuts: rapids, transitions, the ways to the part and away from it.

use crate::program::Clearance;

/// Motion between cuts.
#[derive(Debug, Clone, PartialEq)]
pub struct RapidOptions {
    /// How to get from one operation to the next; default [`Transition::Safe`].
    pub transition: Transition,
    /// Largest turn of a rotary axis in a rapid that does not go through the safe sequence, rad; default 1 degree.
    pub index_angle: f64,
    /// How rapids inside an operation are written; default [`Rapid::Direct`].
    pub rapid: Rapid,
    /// Feed of a rapid that is written as a feed motion, mm/min; default none.
    pub rapid_feed: Option<f64>,
    /// Speed of rotary axes in moves that only turn the tool or the table, rad/min; default 1800 degrees/min.
    pub reorient_speed: f64,
}

impl Default for RapidOptions {
    fn default() -> Self {
        Self {
            transition: Transition::Safe,
            index_angle: 1_f64.to_radians(),
            rapid: Rapid::Direct,
            rapid_feed: None,
            reorient_speed: 1800_f64.to_radians(),
        }
    }
}

/// How a rapid inside an operation is written that turns no rotary axis by more than the index angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rapid {
    /// In one block; its path is the control's affair.
    Direct,
    /// Along the tool axis and across it in blocks of their own: out first, in last.
    Split,
    /// As a feed motion, on a path that is certified.
    Feed,
}

/// How to get from one operation to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Transition {
    /// Retract, turn, approach.
    Safe,
    /// As the CL data has it.
    Direct,
}

/// How to get away from the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Retract {
    /// Machine coordinate of the retract axis, mm; default [`Retract::POSITION`].
    pub position: Option<f64>,
    /// Distance along the tool axis, mm; default none: to the clearance geometry of the CL data.
    pub distance: Option<f64>,
    /// Geometry around the part that the tool has to leave, if no distance is given; default none.
    pub clearance: Option<Clearance>,
    /// How rotary axes are rewound in a cut; default [`Rewind::Leave`].
    pub rewind: Rewind,
    /// Coolant is off while the rotary axes are rewound; default false.
    pub rewind_dry: bool,
}

/// How rotary axes are rewound where no course runs through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rewind {
    /// The tool leaves the part along its axis, the rotaries turn, and it comes back.
    Leave,
    /// The linear axes follow: the tip stays in place, and the tool swings about it.
    Follow,
}

/// How to get to the part.
#[derive(Debug, Clone, PartialEq)]
pub struct Approach {
    /// Distance of the approach point from the first tip along the tool axis, mm; default 50.
    pub distance: f64,
}

impl Default for Retract {
    fn default() -> Self {
        Self { position: None, distance: None, clearance: None, rewind: Rewind::Leave, rewind_dry: false }
    }
}

impl Retract {
    /// Machine coordinate of the retract axis where none is given, mm.
    pub const POSITION: f64 = 0.0;

    /// Machine coordinate of the retract axis, mm.
    #[must_use]
    pub fn position(&self) -> f64 {
        self.position.unwrap_or(Self::POSITION)
    }
}

impl Default for Approach {
    fn default() -> Self {
        Self { distance: 50.0 }
    }
}
