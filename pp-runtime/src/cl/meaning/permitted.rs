//! Table of the records that may come while an arc, a curve or a cycle is open.

use crate::cl::record::{
    ArcRecord, CoordinateRecord, CycleRecord, MachineRecord, MotionRecord, NurbsRecord, ProgramRecord, Record,
    SubprogramRecord, ToolRecord,
};

/// Places where a record may come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Permitted {
    /// The record moves the tool or begins a path, so it may not come between AUTOPS or INDIRV and their TLON.
    pub(crate) begins_motion: bool,
    /// The record may come between CIRCLE and the GOTO that ends its arc.
    pub(crate) in_arc: bool,
    /// The record is part of an open NURBS, or at least does not end it.
    pub(crate) in_curve: bool,
    /// The record may come among the points of a CYCLE.
    pub(crate) in_cycle: bool,
}

impl Permitted {
    /// Ends a curve, may not come in an arc.
    const ORDINARY: Permitted = Permitted { begins_motion: false, in_arc: false, in_curve: false, in_cycle: true };
    /// Ends a curve only.
    const WITHIN_ARC: Permitted = Permitted { in_arc: true, ..Permitted::ORDINARY };
    /// Ends a curve, may not come in an arc or a cycle.
    const ALONE: Permitted = Permitted { in_cycle: false, ..Permitted::ORDINARY };
    /// Part of a curve, may not come in an arc.
    const OF_CURVE: Permitted = Permitted { in_curve: true, ..Permitted::ORDINARY };
    /// Without effect on arcs, curves and cycles.
    const ANYWHERE: Permitted = Permitted { in_arc: true, in_curve: true, ..Permitted::ORDINARY };
    /// Motion to a point, which may end an arc or be a hole.
    pub(crate) const POINT: Permitted = Permitted { begins_motion: true, ..Permitted::WITHIN_ARC };
    /// Motion to a point, which may be a hole; may not come in an arc.
    const POINT_OF_HOLE: Permitted = Permitted { begins_motion: true, ..Permitted::ORDINARY };
    /// Motion or begin of a path; may not come in an arc or a cycle.
    pub(crate) const PATH_ALONE: Permitted = Permitted { begins_motion: true, ..Permitted::ALONE };

    #[inline]
    pub(crate) fn of(record: &Record<'_>) -> Permitted {
        match record {
            Record::Motion(record) => match record {
                MotionRecord::Goto(_) | MotionRecord::Points(_) | MotionRecord::Delta(_) => Self::POINT,
                MotionRecord::DeltaAlongAxis { .. } => Self::POINT_OF_HOLE,
                MotionRecord::Home(_) | MotionRecord::Retract => Self::PATH_ALONE,
                MotionRecord::From(_) => Self::ORDINARY,
            },
            Record::Arc(record) => match record {
                ArcRecord::Circle(_) => Self::PATH_ALONE,
                ArcRecord::TangentArc(_) => Self::ALONE,
                ArcRecord::AutomaticPlane | ArcRecord::Direction { .. } | ArcRecord::Slope { .. } => Self::ORDINARY,
            },
            Record::Nurbs(record) => match record {
                NurbsRecord::Begin => Self::PATH_ALONE,
                NurbsRecord::Knots(_) | NurbsRecord::ControlPoint(_) => Self::OF_CURVE,
            },
            Record::Cycle(CycleRecord::Define(_) | CycleRecord::Change(_) | CycleRecord::Switch { .. }) => {
                Self::ORDINARY
            }
            Record::Coordinates(record) => Self::of_coordinates(record),
            Record::Tool(record) => match record {
                ToolRecord::Call(_) => Self::ALONE,
                ToolRecord::Preselect(_) | ToolRecord::LengthOffset { .. } | ToolRecord::OffsetOf { .. } => {
                    Self::ORDINARY
                }
                ToolRecord::Cutter(_) | ToolRecord::CutterOfLastTool(_) => Self::ORDINARY,
            },
            Record::Machine(record) => Self::of_machine(record),
            Record::Program(record) => Self::of_program(record),
            Record::Subprogram(record) => match record {
                SubprogramRecord::Define(_) | SubprogramRecord::End | SubprogramRecord::Call { .. } => Self::ORDINARY,
            },
            Record::Own(..) => Self::ALONE,
            Record::Inert => Self::ANYWHERE,
        }
    }

    fn of_coordinates(record: &CoordinateRecord) -> Permitted {
        match record {
            CoordinateRecord::Frame(_) | CoordinateRecord::Setup(_) => Self::ALONE,
            CoordinateRecord::Units(_) | CoordinateRecord::World => Self::ORDINARY,
            CoordinateRecord::MultiAxis(_) | CoordinateRecord::ToolAxis { .. } => Self::ORDINARY,
            CoordinateRecord::Origin(_) | CoordinateRecord::Translation { .. } => Self::ORDINARY,
            CoordinateRecord::Transformation { .. } | CoordinateRecord::ClearancePlane { .. } => Self::ORDINARY,
        }
    }

    fn of_machine(record: &MachineRecord) -> Permitted {
        match record {
            MachineRecord::Feed(_) | MachineRecord::InverseTime(_) => Self::WITHIN_ARC,
            MachineRecord::Coolant(_) | MachineRecord::CoolantAt { .. } | MachineRecord::Tolerance { .. } => {
                Self::WITHIN_ARC
            }
            MachineRecord::Rapid | MachineRecord::Spindle(_) | MachineRecord::Compensation { .. } => Self::ORDINARY,
            MachineRecord::Delay { .. } | MachineRecord::RotaryDirection(_) => Self::ORDINARY,
            MachineRecord::CompensatedPath { .. } => Self::ANYWHERE,
        }
    }

    fn of_program(record: &ProgramRecord<'_>) -> Permitted {
        match record {
            ProgramRecord::Message(_) | ProgramRecord::BlockSkip { .. } => Self::WITHIN_ARC,
            ProgramRecord::ToolPath { .. } | ProgramRecord::Insert(_) | ProgramRecord::Code { .. } => Self::ALONE,
            ProgramRecord::Stop | ProgramRecord::OptionalStop => Self::ALONE,
            ProgramRecord::PartName(_) | ProgramRecord::MachineName(_) | ProgramRecord::EndOfPath => Self::ORDINARY,
            ProgramRecord::End | ProgramRecord::Fini | ProgramRecord::Rewind => Self::ORDINARY,
        }
    }
}
