//! The data record of a machine: kinematic type, axis vectors and offsets.

use nalgebra::Vector3;

use crate::config::Config;

use super::super::chain::{Arrangement, machine_coordinates, opposite};

/// An offset of the data record; a component is unknown without `machine_zero`.
pub(super) type Offset = [Option<f64>; 3];

/// The data record of a machine.
pub(super) struct DataRecord {
    /// T, P or M.
    pub(super) kind: char,
    /// Type of the generic transformation.
    pub(super) generic: u32,
    pub(super) offsets: [Offset; 4],
    pub(super) axes: [Vector3<f64>; 2],
    /// Points between which the offsets count.
    pub(super) meanings: [&'static str; 4],
    /// Machine data of each offset.
    pub(super) machine_data: [Option<MachineData>; 4],
    /// Changes that leave the machine the same.
    pub(super) free: &'static str,
}

/// Number and name of three machine data.
pub(super) type MachineData = (u32, &'static str);

pub(super) const PART_OFFSET: MachineData = (24500, "TRAFO5_PART_OFFSET_1");
pub(super) const BASE_TOOL: MachineData = (24550, "TRAFO5_BASE_TOOL_1");
pub(super) const JOINT_OFFSET_PART: MachineData = (24558, "TRAFO5_JOINT_OFFSET_PART_1");
pub(super) const JOINT_OFFSET: MachineData = (24560, "TRAFO5_JOINT_OFFSET_1");

impl DataRecord {
    pub(super) fn of(arrangement: &Arrangement, config: &Config) -> Self {
        let (first, second) = arrangement.axes();
        let axes = [first.rotation, second.map_or(Vector3::zeros(), |axis| axis.rotation)];
        let zero = known(&Vector3::zeros());
        match arrangement {
            Arrangement::Head(first, second) => {
                // A single axis is the first one; only the sum of l2 and l3 counts for it.
                let second = second.as_ref().map_or(Vector3::zeros(), |axis| axis.point);
                Self {
                    kind: 'T',
                    generic: 24,
                    offsets: [known(&-first.point), known(&(first.point - second)), known(&second), zero],
                    axes,
                    meanings: [
                        "from the centre line of the first rotary axis to the gauge line: it closes the chain, I1 = -(I2 + I3)",
                        "from the centre line of the second rotary axis to that of the first",
                        "from the gauge line (tool adapter) to the centre line of the second rotary axis",
                        "no meaning for type T",
                    ],
                    machine_data: [Some(PART_OFFSET), Some(JOINT_OFFSET), Some(BASE_TOOL), None],
                    free: "I3 + b*V2, I2 - b*V2 + a*V1 and I1 - a*V1 are the same machine for any lengths a and b, because a \
                           point may be anywhere on its centre line.",
                }
            }
            Arrangement::Table(first, second) => {
                let last = second.as_ref().unwrap_or(first);
                Self {
                    kind: 'P',
                    generic: 40,
                    offsets: [
                        zero,
                        machine_coordinates(config, &first.point),
                        known(&(last.point - first.point)),
                        opposite(&machine_coordinates(config, &last.point)),
                    ],
                    axes,
                    meanings: [
                        "no meaning for type P",
                        "from the machine zero point to the centre line of the first rotary axis",
                        "from the centre line of the first rotary axis to that of the second",
                        "from the centre line of the second rotary axis back to the machine zero point: it closes the chain, \
                         I4 = -(I2 + I3)",
                    ],
                    machine_data: [None, Some(BASE_TOOL), Some(JOINT_OFFSET), Some(PART_OFFSET)],
                    free: "I2 + a*V1, I3 - a*V1 + b*V2 and I4 - b*V2 are the same machine for any lengths a and b, because a \
                           point may be anywhere on its centre line.",
                }
            }
            Arrangement::Mixed { head, table } => {
                let centre = machine_coordinates(config, &table.point);
                Self {
                    kind: 'M',
                    generic: 56,
                    offsets: [known(&-head.point), known(&head.point), centre, opposite(&centre)],
                    axes,
                    meanings: [
                        "from the centre line of the first rotary axis, in the head, to the gauge line: it closes the chain of the \
                         head, I1 = -I2",
                        "from the gauge line (tool adapter) to the centre line of the first rotary axis",
                        "from the machine zero point to the centre line of the second rotary axis, in the table",
                        "from the centre line of the second rotary axis back to the machine zero point: it closes the chain of the \
                         table, I4 = -I3",
                    ],
                    machine_data: [Some(JOINT_OFFSET), Some(BASE_TOOL), Some(JOINT_OFFSET_PART), Some(PART_OFFSET)],
                    free: "I2 + a*V1 and I1 - a*V1, I3 + b*V2 and I4 - b*V2 are the same machine for any lengths a and b, because \
                           a point may be anywhere on its centre line.",
                }
            }
        }
    }

    pub(super) fn single(&self) -> bool {
        self.axes[1] == Vector3::zeros()
    }
}

pub(super) fn known(vector: &Vector3<f64>) -> Offset {
    [0, 1, 2].map(|component| Some(vector[component]))
}
