//! Properties of the families of controls on which the comparison depends.

use super::Family;

/// Numbering of the registers that hold the length of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LengthRegisters {
    /// One table for all tools: H.
    Shared,
    /// Cutting edges of each tool, from 1: D.
    Edges,
    /// The tool's own row.
    Rows,
}

/// What the comparison has to know of a family.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Facts {
    /// Numbering of length registers.
    pub(crate) registers: LengthRegisters,
    /// Switching length compensation on or off may move the tool by its length.
    pub(crate) length_moves: bool,
    /// Length compensation is off in a block of machine coordinates.
    pub(crate) length_off_at_machine_coordinates: bool,
    /// Tool radii have registers of their own: D.
    pub(crate) radius_registers: bool,
    /// A length guard compares in mm, whatever the unit of the program.
    pub(crate) guard_in_mm: bool,
    /// F of an inch program counts tenths of an inch.
    pub(crate) feed_in_tenths_of_inch: bool,
    /// F counts the degrees of rotary axes as millimetres, and there is no inverse-time feed.
    pub(crate) feed_counts_degrees: bool,
    /// All axes of a rapid under tip control arrive together.
    pub(crate) rapids_interpolated: bool,
    /// A tilted plane is switched off before the retract in machine coordinates, and that moves nothing.
    pub(crate) plane_off_before_retract: bool,
    /// The tool call selects the working plane.
    pub(crate) plane_by_tool_call: bool,
    /// The program selects how the tool axis moves between the ends of a block under tip control.
    pub(crate) tool_axis_interpolation: bool,
    /// The program selects whether tool axes count in the workpiece or in the machine.
    pub(crate) tool_axis_frame: bool,
    /// Work offsets are rows of a table; G54 is row 1.
    pub(crate) offset_rows: bool,
}

const ISO: Facts = Facts {
    registers: LengthRegisters::Shared,
    length_moves: true,
    length_off_at_machine_coordinates: true,
    radius_registers: true,
    guard_in_mm: false,
    feed_in_tenths_of_inch: false,
    feed_counts_degrees: false,
    // Fanuc: parameter 1401#1; Haas: a setting.
    rapids_interpolated: false,
    plane_off_before_retract: false,
    plane_by_tool_call: false,
    tool_axis_interpolation: false,
    tool_axis_frame: false,
    offset_rows: false,
};

impl Family {
    /// The properties of the family.
    pub(crate) const fn facts(self) -> Facts {
        match self {
            Self::LinuxCnc => Facts {
                length_moves: false,
                length_off_at_machine_coordinates: false,
                guard_in_mm: true,
                rapids_interpolated: true,
                ..ISO
            },
            Self::Fanuc => Facts { tool_axis_interpolation: true, ..ISO },
            Self::Haas => ISO,
            // Rapids: programming manual of the Sinumerik One, RTLIOF.
            Self::Siemens => Facts {
                registers: LengthRegisters::Edges,
                length_moves: false,
                radius_registers: false,
                rapids_interpolated: true,
                tool_axis_interpolation: true,
                tool_axis_frame: true,
                ..ISO
            },
            Self::Heidenhain => Facts {
                registers: LengthRegisters::Rows,
                length_moves: false,
                length_off_at_machine_coordinates: false,
                radius_registers: false,
                guard_in_mm: true,
                feed_in_tenths_of_inch: true,
                feed_counts_degrees: true,
                rapids_interpolated: true,
                plane_off_before_retract: true,
                plane_by_tool_call: true,
                tool_axis_interpolation: true,
                offset_rows: true,
                ..ISO
            },
        }
    }
}
