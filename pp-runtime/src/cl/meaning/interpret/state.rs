//! Interprets records of coordinates, tools and machine state.

use super::{CutcomOn, RecordInterpreter};
use crate::cl::dialect::Dialect;
use crate::cl::meaning::axis::AxisAfterOff;
use crate::cl::meaning::feed::feed_of;
use crate::cl::meaning::frame::{FrameChange, StatedFrame};
use crate::cl::meaning::tool_numbers;
use crate::cl::record::{
    AxisPlane, CoordinateRecord, CutterRecord, FrameBase, FrameRecord, MachineRecord, ToolCallRecord, ToolRecord,
};
use crate::cl::text::{ClFault, Span};
use crate::diag::code::cl;
use crate::program::{
    Compensation, Coolant, CutterSide, Dwell, Event, Interruption, Location, MachineFunction, NewStart,
    ReferenceGeometry, TextKind, ToolCall, Units,
};

/// Longest dwell that is not warned of, seconds.
const LONG_DELAY_S: f64 = 10.0;

impl RecordInterpreter {
    pub(crate) fn take_coordinates(&mut self, record: &CoordinateRecord, here: Location) -> Result<(), ClFault> {
        match *record {
            CoordinateRecord::Units(units) => self.take_units(units, here)?,
            CoordinateRecord::MultiAxis(true) => self.axis.release(),
            CoordinateRecord::MultiAxis(false) => {
                let then = match self.dialect() {
                    Dialect::Catia => AxisAfterOff::Kept,
                    Dialect::Autodesk => AxisAfterOff::Upright,
                    Dialect::Generic | Dialect::Nx | Dialect::Creo | Dialect::SolidWorks | Dialect::Iso => {
                        AxisAfterOff::Unknown
                    }
                };
                self.axis.hold(then, here);
            }
            CoordinateRecord::ToolAxis { axis, at } => self.axis.state(axis, at, here)?,
            CoordinateRecord::Frame(ref frame) => self.take_frame(frame, here)?,
            CoordinateRecord::Setup(ref frame) => self.take_set_up(frame, here)?,
            CoordinateRecord::World => self.coordinates.set_world(),
            CoordinateRecord::Origin(origin) => {
                let origin = self.in_millimetres(origin)?;
                self.coordinates.set_origin(origin);
            }
            CoordinateRecord::Translation { by, at } => self.take_translation(by, at)?,
            CoordinateRecord::Transformation { matrix, at } => {
                let unit_mm = self.units.millimetres(at)?;
                self.coordinates.set_tracut(matrix, unit_mm, at)?;
            }
            CoordinateRecord::ClearancePlane { normal, distance, at } => {
                let unit_mm = self.units.millimetres(at)?;
                let plane = self.coordinates.plane(normal, distance, unit_mm, at)?;
                self.path.set_clearance(plane);
                self.emit(here, Event::Reference(ReferenceGeometry::ClearancePlane(plane)));
            }
        }
        Ok(())
    }

    fn take_units(&mut self, units: Units, here: Location) -> Result<(), ClFault> {
        if self.units.known().is_none() {
            self.coordinates.scale_frames(units.in_mm());
        }
        self.units.take(units, here)?;
        self.tool.set_units(self.units.known().unwrap_or_default());
        Ok(())
    }

    fn in_millimetres(&mut self, lengths: Option<[f64; 3]>) -> Result<Option<[f64; 3]>, ClFault> {
        let Some(lengths) = lengths else { return Ok(None) };
        let unit_mm = self.units.millimetres(Span::WHOLE)?;
        Ok(Some(lengths.map(|value| value * unit_mm)))
    }

    fn take_translation(&mut self, by: Option<[f64; 3]>, at: Span) -> Result<(), ClFault> {
        if self.dialect() == Dialect::Creo && !self.options.trans_adds {
            return Err(cl::FRAME.cl_fault(
                "TRANS",
                at,
                "TRANS of Creo is refused: it belongs to output in the frame of each sequence, which the file does not state",
                "if its numbers are to be added to all points after it: `[cl] trans = \"add\"`; else output the points in the machine \
                 coordinate system, without TRANS: parameters COORDINATE_OUTPUT and CL_DATA_MODE of Creo",
            ));
        }
        let by = self.in_millimetres(by)?;
        self.coordinates.set_translation(by);
        Ok(())
    }

    /// MSYS, Creo's CSYS comment, CATIA's matrix, MCS, MCSYS.
    fn take_frame(&mut self, record: &FrameRecord, here: Location) -> Result<(), ClFault> {
        let mut frame = self.stated_frame(record, here)?;
        if record.base != FrameBase::Model {
            self.begin_with_workpiece_frame(record, &frame, here)?;
            frame = self.coordinates.workpiece().frame().map_or(frame, |workpiece| frame.stated_in(workpiece));
        }
        match self.enter_frame(frame, record.at)? {
            FrameChange::None => {}
            FrameChange::Frame => {
                self.begin_operation();
                self.coordinates.map_frame();
                self.emit(here, Event::NewStart(NewStart::SafeSequence));
            }
            FrameChange::SetUp(number) => self.change_set_up(number, here),
        }
        Ok(())
    }

    /// A frame that is stated in the workpiece frame: that one is the first of the file, whichever is stated first.
    fn begin_with_workpiece_frame(
        &mut self,
        record: &FrameRecord,
        frame: &StatedFrame,
        here: Location,
    ) -> Result<(), ClFault> {
        let workpiece = self.stated_frame(&FrameRecord::of_workpiece(record.at), here)?;
        if frame.is_same(&workpiece) {
            return Ok(());
        }
        if record.base == FrameBase::WorkpieceOrView && self.dialect() != Dialect::Autodesk {
            return Err(cl::FRAME.cl_fault(
                "MCS",
                record.at,
                "MCS states a frame, and whether the points after it are in that frame depends on the system that wrote it",
                "if \"CAMplete APT\" or \"MANUSnc APT\" of Autodesk wrote the file, add `--dialect autodesk`; in Surfcam write all tool \
                 paths in one view, without this record",
            ));
        }
        if self.coordinates.workpiece().frame().is_none() {
            self.enter_frame(workpiece, record.at)?;
        }
        Ok(())
    }

    fn enter_frame(&mut self, frame: StatedFrame, at: Span) -> Result<FrameChange, ClFault> {
        let dialect = self.dialect();
        self.coordinates.take_frame(frame, at, &self.options, dialect)
    }

    /// Another set-up begins: the axes are parked, and the operator clamps the part. A STOP before it is the one in
    /// which he does; the name of an operation before it is that of the first one after it.
    pub(crate) fn change_set_up(&mut self, number: u32, here: Location) {
        self.waiting.stop = None;
        let name = self.waiting.name.take();
        self.begin_operation();
        self.coordinates.map_frame();
        self.path.change_frame();
        self.emit(here, Event::NewStart(NewStart::Home));
        self.emit(here, Event::Text(TextKind::Message, b"NEXT SET-UP: CLAMP THE PART AGAIN, THEN START"));
        self.emit(here, Event::Interruption(Interruption::Stop));
        self.emit(here, Event::NewStart(NewStart::SetUp(number)));
        self.waiting.name = name;
        self.emit_waiting();
    }

    /// CSYS of SolidWorks CAM.
    fn take_set_up(&mut self, record: &FrameRecord, here: Location) -> Result<(), ClFault> {
        self.coordinates.set_up().check_world(record.at)?;
        let frame = self.stated_frame(record, here)?;
        if self.coordinates.take_set_up(frame) {
            // The tool axis may change: retract from the part first.
            self.begin_operation();
            self.emit(here, Event::NewStart(NewStart::SafeSequence));
        }
        self.axis.state_of_set_up(frame.axes[2], record.at, here)?;
        self.coordinates.hold_axis(frame.axes[2]);
        Ok(())
    }

    pub(crate) fn stated_frame(&self, record: &FrameRecord, here: Location) -> Result<StatedFrame, ClFault> {
        StatedFrame::new(record, self.units.known().map_or(1.0, Units::in_mm), here)
    }

    pub(crate) fn take_tool(&mut self, record: &ToolRecord, here: Location) -> Result<(), ClFault> {
        match record {
            ToolRecord::Call(tool) => self.call_tool(tool, here)?,
            ToolRecord::Preselect(number) => self.emit(here, Event::Function(MachineFunction::Preselect(*number))),
            ToolRecord::Cutter(cutter) => {
                let cutter = self.cutter_in_millimetres(cutter)?;
                match self.dialect() {
                    Dialect::Creo => self.describe_last(cutter, here),
                    Dialect::Generic
                    | Dialect::Nx
                    | Dialect::Catia
                    | Dialect::SolidWorks
                    | Dialect::Iso
                    | Dialect::Autodesk => {
                        self.tool.describe_next(cutter, here);
                    }
                }
            }
            ToolRecord::CutterOfLastTool(cutter) => {
                let cutter = self.cutter_in_millimetres(cutter)?;
                self.describe_last(cutter, here);
            }
            ToolRecord::LengthOffset { register, at } => self.tool.set_length_offset(*register, *at)?,
            ToolRecord::OffsetOf { number, register } => self.tool.set_offset_of(*number, *register),
        }
        Ok(())
    }

    /// Refuses a path that is not the one of `[compensation] path`.
    fn check_compensated_path(&self, of_centre: bool, at: Span) -> Result<(), ClFault> {
        let word = |of_centre| if of_centre { "centre" } else { "contour" };
        match self.options.compensates_centre {
            Some(given) if given != of_centre => Err(cl::CUTTER_COMPENSATION.cl_fault(
                "CUTCOM",
                at,
                format!(
                    "the path with CUTCOM is that of the {} by this record, and of the {} by `[compensation] path`",
                    word(of_centre),
                    word(given)
                ),
                format!("set `[compensation] path = \"{}\"`, or change the output in Creo", word(of_centre)),
            )),
            _ => Ok(()),
        }
    }

    fn describe_last(&mut self, cutter: CutterRecord, here: Location) {
        let taken = self.tool.describe_last(cutter, here, &self.options);
        self.refuse(taken.err());
    }

    fn cutter_in_millimetres(&mut self, cutter: &CutterRecord) -> Result<CutterRecord, ClFault> {
        let unit_mm = self.units.millimetres(Span::WHOLE)?;
        let corner_radius = cutter.corner_radius.map(|radius| radius * unit_mm);
        Ok(CutterRecord { diameter: cutter.diameter * unit_mm, corner_radius, ..*cutter })
    }

    fn call_tool(&mut self, call: &ToolCallRecord, here: Location) -> Result<(), ClFault> {
        self.unloaded = (call.number == 0).then_some(here);
        if call.number == 0 {
            self.begin_operation();
            self.coolant_kind_is_on = false;
            self.emit(here, Event::NewStart(NewStart::Tool(ToolCall::default())));
            return Ok(());
        }
        let tool = &tool_numbers::with_names(call, &self.options, self.dialect())?;
        let is_given = || self.options.tools.get(&tool.number).is_some_and(|given| given.length_mm.is_some());
        if call.length.is_some() && tool.length.is_none() && !is_given() {
            self.events.warn(cl::TOOL.cl_fault(
                "length of the body",
                Span::WHOLE,
                format!(
                    "LENGTH of a LOADTL with IN is the length of the body of tool {}, not its gauge length",
                    tool.number
                ),
                "nothing needs to be done unless the machine needs the gauge length: then state it in `[tools.N]`, `length`",
            ));
        }
        let length = match tool.length {
            Some(length) => Some(length * self.units.millimetres(Span::WHOLE)?),
            None => None,
        };
        self.emit_waiting();
        self.begin_operation();
        self.coolant_kind_is_on = false;
        self.tool.call(tool, length, here);
        Ok(())
    }

    pub(crate) fn take_machine(&mut self, record: &MachineRecord, here: Location) -> Result<(), ClFault> {
        match *record {
            MachineRecord::Rapid => self.path.set_rapid(true),
            MachineRecord::Feed(ref feed) => {
                let feed = feed_of(feed, &mut self.units, self.options.feed_label)?;
                self.path.set_feed(feed);
            }
            MachineRecord::InverseTime(on) => self.inverse_time |= on,
            MachineRecord::Spindle(spindle) => self.emit(here, Event::Function(MachineFunction::Spindle(spindle))),
            // ON after a kind that is on changes nothing: *Mori APT* writes both.
            MachineRecord::Coolant(Coolant::On) if self.coolant_kind_is_on => {}
            MachineRecord::Coolant(coolant) => {
                self.coolant_kind_is_on = !matches!(coolant, Coolant::On | Coolant::Off);
                self.emit(here, Event::Function(MachineFunction::Coolant(coolant)));
            }
            MachineRecord::CoolantAt { kind, pressure, at } => {
                self.events.warn(cl::VALUE.cl_fault(
                    "coolant pressure",
                    at,
                    format!(
                        "coolant is switched on without its pressure, {}, which has a code for THRU only",
                        pressure.word()
                    ),
                    "nothing needs to be done if the machine has one pressure; `[control] coolant` sets another code, for all coolant \
                     of this kind",
                ));
                self.emit(here, Event::Function(MachineFunction::Coolant(kind)));
            }
            MachineRecord::Compensation { side, register, plane } => {
                let register = match (side, self.cutcom) {
                    (CutterSide::On, CutcomOn::Unstated | CutcomOn::Asked(_)) => {
                        self.cutcom = CutcomOn::Asked(register);
                        return Ok(());
                    }
                    (CutterSide::Left | CutterSide::Right, CutcomOn::Asked(asked)) => register.or(asked),
                    _ => register,
                };
                match side {
                    CutterSide::Left | CutterSide::Right => self.cutcom = CutcomOn::Stated,
                    CutterSide::Off if self.cutcom != CutcomOn::Stated => self.cutcom = CutcomOn::Unstated,
                    CutterSide::On | CutterSide::Off => {}
                }
                let xy = plane.is_none_or(|plane| plane == AxisPlane::Xy);
                self.emit(
                    here,
                    Event::Function(MachineFunction::Compensation(Compensation { side, register, in_xy_plane: xy })),
                );
            }
            MachineRecord::CompensatedPath { of_centre, at } => self.check_compensated_path(of_centre, at)?,
            MachineRecord::Delay { dwell, at } => self.delay(dwell, at, here),
            MachineRecord::Tolerance { value, at } => self.take_tolerance(value, at, here)?,
            MachineRecord::RotaryDirection(turning) => {
                self.emit(here, Event::Function(MachineFunction::RotaryDirection(turning)))
            }
        }
        Ok(())
    }

    fn delay(&mut self, dwell: Dwell, at: Span, here: Location) {
        if let Dwell::Seconds(seconds) = dwell
            && seconds > LONG_DELAY_S
        {
            self.events.warn(cl::VALUE.cl_fault(
                "long dwell",
                at,
                format!("a dwell of {seconds} seconds is unusually long"),
                "DELAY is in seconds: check whether revolutions or milliseconds are meant",
            ));
        }
        self.emit(here, Event::Function(MachineFunction::Delay(dwell)));
    }

    fn take_tolerance(&mut self, value: Option<f64>, at: Span, here: Location) -> Result<(), ClFault> {
        let unit_mm = self.units.millimetres(at)?;
        if value.is_some_and(|value| value <= 0.0) {
            return Err(cl::VALUE.cl_fault(
                "LINTOL",
                at,
                "LINTOL must be above 0",
                "LINTOL/OFF restores the configured tolerance",
            ));
        }
        self.emit(here, Event::Function(MachineFunction::Tolerance(value.map(|value| value * unit_mm))));
        Ok(())
    }
}
