//! Clearance geometry: the space around the part that the tool leaves in a retract, from the configuration or CLEARP.

use crate::kinematics::Pose;
use crate::program::{Clearance, ClearancePlane};

use super::distance_to_clear;

/// The clearance geometry in force.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ClearanceGeometry {
    configured: Option<Clearance>,
    in_force: Option<Clearance>,
}

impl ClearanceGeometry {
    pub(crate) fn new(configured: Option<Clearance>) -> Self {
        Self { configured, in_force: configured }
    }

    /// Whether CLEARP states another geometry.
    pub(crate) fn changes(&self, plane: ClearancePlane) -> bool {
        self.in_force != Some(Clearance::Plane(plane))
    }

    /// CLEARP.
    pub(crate) fn set_plane(&mut self, plane: ClearancePlane) {
        self.in_force = Some(Clearance::Plane(plane));
    }

    /// Another set-up: CLEARP was given in the last one and ends.
    pub(crate) fn change_set_up(&mut self) {
        self.in_force = self.configured;
    }

    /// The geometry in force.
    pub(crate) fn in_force(&self) -> Option<&Clearance> {
        self.in_force.as_ref()
    }

    /// Distance along the tool axis until the tool is outside, mm; `None` without geometry, or where the axis never
    /// leaves it.
    pub(crate) fn retract_distance_mm(&self, from: &Pose) -> Option<f64> {
        self.in_force.and_then(|clearance| distance_to_clear(&clearance, &from.tip, &from.axis))
    }
}
