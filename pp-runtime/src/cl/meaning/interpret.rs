//! Interprets records: updates the modal state that a record changes and queues the events that follow.
//!
//! The event of a tool call is held until the next event, because Creo gives the diameter after the call. Records of
//! motion are in `motion`, records of coordinates, tools and machine state in `state`.

mod motion;
mod state;

use super::arc::OpenArc;
use super::axis::ModalAxis;
use super::coordinates::Coordinates;
use super::cycle::CycleInForce;
use super::event_queue::{EventQueue, KeptForEvents, QueuedEvent, TextUse};
use super::frame_reading::StatedPoint;
use super::modal_tool::ModalTool;
use super::nurbs_curve::OpenCurve;
use super::options::{Insert, ReadingOptions};
use super::path_state::PathState;
use super::permitted::Permitted;
use super::tool_table::Contradiction;
use super::units::FileUnits;
use super::votes::ArcVotes;
use crate::cl::dialect::Dialect;
use crate::cl::record::{
    ArcRecord, CoordinateRecord, MachineRecord, MotionRecord, OwnStatement, Point, ProgramRecord, Record,
    SubprogramRecord, Text,
};
use crate::cl::text::{ClFault, Span, decoded};
use crate::diag::code::cl;
use crate::program::{Event, Feed, Interruption, Location, NewStart, Spindle, TextKind};

/// CUTCOM/ON and the side that it needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum CutcomOn {
    /// No side has come, and nothing is asked for.
    #[default]
    Unstated,
    /// CUTCOM/ON with this register has come before any side: *Common ISO 4343 APT* of Autodesk and HSMWorks writes
    /// CUTCOM/LEFT or RIGHT after it.
    Asked(Option<u32>),
    /// A side has come; CUTCOM/ON resumes it.
    Stated,
}

#[cold]
fn side_unstated() -> ClFault {
    cl::CUTTER_COMPENSATION.cl_fault(
        "CUTCOM",
        Span::WHOLE,
        "a motion follows CUTCOM/ON, and no CUTCOM/LEFT or RIGHT has stated the side",
        "write CUTCOM/LEFT or CUTCOM/RIGHT before this motion; without compensation delete CUTCOM/ON",
    )
}

/// Records whose events wait for the next one.
#[derive(Debug, Default)]
struct Waiting {
    /// OPSKIP/ON: with OPSKIP/OFF directly after it, it has no effect.
    skip: Option<Location>,
    /// STOP, which a change of set-up may follow: both are one stop.
    stop: Option<Location>,
    /// Name of an operation, which comes after a change of set-up.
    name: Option<Location>,
    /// The last name that has waited.
    last_name: Vec<u8>,
}

/// All modal state of the CL data, each part with its owner.
#[derive(Debug, Default)]
pub(crate) struct RecordInterpreter {
    options: ReadingOptions,
    found_dialect: Dialect,
    units: FileUnits,
    tool: ModalTool,
    axis: ModalAxis,
    coordinates: Coordinates,
    path: PathState,
    arc: OpenArc,
    votes: ArcVotes,
    curve: OpenCurve,
    cycle: CycleInForce,
    /// The CAM system asks for inverse-time feed.
    inverse_time: bool,
    /// COOLNT has stated a kind for the tool in the spindle, and has not switched it off.
    coolant_kind_is_on: bool,
    cutcom: CutcomOn,
    /// Number of motions before the last SPINDL/ON without a speed or sense of rotation.
    spindle_on_after: Option<u64>,
    /// Place of the record that has left the spindle empty.
    unloaded: Option<Location>,
    waiting: Waiting,
    /// OPSKIP is on.
    skips_blocks: bool,
    /// The next GOTO is a straight motion only: see [`update_plain_goto`](Self::update_plain_goto).
    plain_goto: bool,
    events: EventQueue,
}

impl RecordInterpreter {
    pub(crate) fn new(options: ReadingOptions) -> Self {
        let units = FileUnits::new(options.units);
        let default_feed = options.default_feed_mm_per_min.map(Feed::PerMinute);
        let mut new = RecordInterpreter { options, units, ..Self::default() };
        if let Some(feed) = default_feed {
            new.path.set_feed(feed);
        }
        new.tool.set_units(new.units.known().unwrap_or_default());
        new.update_plain_goto();
        new
    }

    pub(crate) fn options(&self) -> &ReadingOptions {
        &self.options
    }

    pub(crate) fn units(&self) -> &FileUnits {
        &self.units
    }

    pub(crate) fn tool(&self) -> &ModalTool {
        &self.tool
    }

    pub(crate) fn axis(&self) -> &ModalAxis {
        &self.axis
    }

    pub(crate) fn coordinates(&self) -> &Coordinates {
        &self.coordinates
    }

    pub(crate) fn path(&self) -> &PathState {
        &self.path
    }

    pub(crate) fn votes(&self) -> &ArcVotes {
        &self.votes
    }

    pub(crate) fn asks_for_inverse_time(&self) -> bool {
        self.inverse_time
    }

    /// What belongs to the event that was returned last.
    pub(crate) fn kept_for_events(&self) -> KeptForEvents<'_> {
        KeptForEvents { curve: self.curve.completed(), name: &self.waiting.last_name }
    }

    /// CAM system, as given in the options, else as identified in the file.
    pub(crate) fn dialect(&self) -> Dialect {
        self.options.dialect.unwrap_or(self.found_dialect)
    }

    /// Notes the CAM system that a record or comment identifies; the first one decides.
    pub(crate) fn note_dialect(&mut self, dialect: Dialect) {
        if self.found_dialect == Dialect::Generic {
            self.found_dialect = dialect;
        }
    }

    /// Takes the next queued event.
    #[inline]
    pub(crate) fn next_event(&mut self) -> Option<(Location, QueuedEvent)> {
        self.events.pop()
    }

    /// Takes the warnings of the last record, and faults of one before it that it shows, with their place.
    pub(crate) fn take_faults(&mut self) -> impl Iterator<Item = (Option<Location>, ClFault)> + '_ {
        self.events.take_faults()
    }

    /// Interprets the record of the statement at `here`.
    pub(crate) fn take(&mut self, record: &Record<'_>, here: Location) -> Result<(), ClFault> {
        let restates = self.is_frame_restated(record, here);
        let permitted = Permitted::of(record);
        if permitted.begins_motion && !matches!(record, Record::Arc(ArcRecord::Circle(_))) {
            self.arc.refuse_slope()?;
        }
        self.admit(permitted, restates)?;
        if self.coordinates.workpiece().is_watched() {
            self.watch(record, here)?;
        }
        let taken = self.interpret(record, here);
        self.update_plain_goto();
        taken
    }

    /// Checks that a record may come here. `restates`: it states a frame that is in force.
    #[inline(always)]
    fn admit(&mut self, permitted: Permitted, restates: bool) -> Result<(), ClFault> {
        if self.curve.is_open() && !permitted.in_curve {
            self.close_curve()?;
        }
        if permitted.begins_motion && matches!(self.cutcom, CutcomOn::Asked(_)) {
            self.cutcom = CutcomOn::Unstated;
            return Err(side_unstated());
        }
        self.arc.admit(permitted)?;
        if restates { Ok(()) } else { self.cycle.admit(permitted) }
    }

    /// Whether the record states a frame that is in force: Creo and NX write it before each operation and cycle.
    #[inline]
    fn is_frame_restated(&self, record: &Record<'_>, here: Location) -> bool {
        let Record::Coordinates(CoordinateRecord::Frame(frame) | CoordinateRecord::Setup(frame)) = record else {
            return false;
        };
        let Ok(stated) = self.stated_frame(frame, here) else { return false };
        match record {
            Record::Coordinates(CoordinateRecord::Setup(_)) => self.coordinates.is_set_up_in_force(&stated),
            _ => self.coordinates.is_frame_in_force(&stated),
        }
    }

    #[inline(always)]
    fn interpret(&mut self, record: &Record<'_>, here: Location) -> Result<(), ClFault> {
        match record {
            Record::Motion(record) => self.take_motion(record, here),
            Record::Arc(record) => self.take_arc(record, here),
            Record::Nurbs(record) => self.take_nurbs(record, here),
            Record::Cycle(record) => self.take_cycle(record),
            Record::Coordinates(record) => self.take_coordinates(record, here),
            Record::Tool(record) => self.take_tool(record, here),
            Record::Machine(record) => {
                self.note_spindle_on(record);
                self.take_machine(record, here)
            }
            Record::Program(record) => self.take_program(record, here),
            // The reader defines and calls subprograms.
            Record::Subprogram(SubprogramRecord::Define(_) | SubprogramRecord::End | SubprogramRecord::Call { .. }) => {
                Ok(())
            }
            Record::Own(_, index) => {
                self.path.forget_position();
                let own = self.options.given_meanings().own_at(*index);
                let count = own.map_or(0, |own| if own.probes() { 1 } else { own.blocks().len() });
                (0..count).for_each(|block| self.push(here, QueuedEvent::Own(*index, block)));
                Ok(())
            }
            Record::Inert => Ok(()),
        }
    }

    /// End of the file: queues a tool call that is held, and refuses an arc or curve without an end.
    pub(crate) fn finish(&mut self) -> Result<(), ClFault> {
        let closed = if self.curve.is_open() { self.close_curve() } else { Ok(()) };
        self.emit_waiting();
        self.votes.conclude_arc(None);
        closed?;
        self.arc.finish()
    }

    /// Looks at a record after a frame whose points may be in it or in the first frame.
    #[cold]
    fn watch(&mut self, record: &Record<'_>, here: Location) -> Result<(), ClFault> {
        let waits = |name| {
            let text = format!(
                "{name} comes before a point with a tool axis states in which frame the points after the frame are"
            );
            Err(cl::FRAME.cl_fault(
                "second frame",
                Span::WHOLE,
                text,
                "`--frames main` or `--frames first` gives it; or put a GOTO before",
            ))
        };
        let open = self.coordinates.workpiece().is_open();
        match record {
            Record::Motion(MotionRecord::From(point) | MotionRecord::Goto(point) | MotionRecord::Home(Some(point))) => {
                self.watch_point(point, here)
            }
            Record::Motion(MotionRecord::Points(points)) => {
                points.points().try_for_each(|point| self.watch_point(&point, here))
            }
            Record::Motion(MotionRecord::Delta(_) | MotionRecord::DeltaAlongAxis { .. }) if open => waits("GODLTA"),
            Record::Motion(MotionRecord::Retract) if open => waits("RETRCT"),
            Record::Arc(_) if open => waits("an arc"),
            Record::Nurbs(_) if open => waits("NURBS"),
            Record::Coordinates(CoordinateRecord::ClearancePlane { .. }) if open => waits("CLEARP"),
            Record::Motion(_) | Record::Nurbs(_) => {
                self.coordinates.forget_place();
                Ok(())
            }
            Record::Arc(_)
            | Record::Cycle(_)
            | Record::Coordinates(_)
            | Record::Tool(_)
            | Record::Machine(_)
            | Record::Program(_)
            | Record::Subprogram(_)
            | Record::Own(..)
            | Record::Inert => Ok(()),
        }
    }

    fn watch_point(&mut self, point: &Point, here: Location) -> Result<(), ClFault> {
        let axis = point.axis.or(self.axis.of_record());
        let point = StatedPoint { tip: point.tip, axis, rapid: self.path.is_rapid(), at: point.at, here };
        self.coordinates.take_point(&point)
    }

    /// Refuses the record that has left the spindle empty, where the tool moves after it.
    fn refuse_empty_spindle(&mut self) {
        if let Some(here) = self.unloaded.take() {
            let fault = cl::TOOL.cl_fault(
                "tool 0",
                Span::WHOLE,
                "the spindle is left without a tool (tool 0 or UNLOAD), and the tool moves after it",
                "number every tool in the CAM system, and call one before the motion; to empty the spindle, let this be the last tool of \
                 the file",
            );
            self.events.refuse(here, fault);
        }
    }

    /// Whether OPSKIP/ON, a stop, a name or a tool call waits for the records after it.
    #[inline]
    fn is_any_waiting(&self) -> bool {
        let Waiting { skip, stop, name, .. } = &self.waiting;
        self.tool.is_held() || skip.is_some() || stop.is_some() || name.is_some()
    }

    /// OPSKIP: a mark of what holds already has no effect, and neither have two with nothing between them.
    fn skip_blocks(&mut self, on: bool, here: Location) {
        if !on && self.waiting.skip.take().is_some() || on == (self.skips_blocks || self.waiting.skip.is_some()) {
            return;
        }
        if on {
            self.emit_waiting();
            self.waiting.skip = Some(here);
        } else {
            self.skips_blocks = false;
            self.emit(here, Event::Interruption(Interruption::BlockSkip { on }));
        }
    }

    /// Takes the name of an operation, which waits for the next event.
    fn take_operation_name(&mut self, here: Location, name: &Text<'_>) {
        if self.tool.is_held() || self.waiting.name.is_some() {
            self.emit_waiting();
        }
        if self.has_events() {
            // The name before, or blocks of another set-up.
            return self.emit_text(here, TextUse::Operation, name);
        }
        self.waiting.name = Some(here);
        self.waiting.last_name = decoded(name.bytes).as_bytes().to_vec();
    }

    /// Queues what waits.
    #[inline]
    fn emit_waiting(&mut self) {
        if let Some(at) = self.waiting.skip.take() {
            self.skips_blocks = true;
            self.events.push(at, QueuedEvent::Plain(Event::Interruption(Interruption::BlockSkip { on: true })));
        }
        if let Some(at) = self.waiting.stop.take() {
            self.events.push(at, QueuedEvent::Plain(Event::Interruption(Interruption::Stop)));
        }
        if let Some(at) = self.waiting.name.take() {
            self.events.push(at, QueuedEvent::WaitingName);
        }
        if let Some(((here, tool), taken)) = self.tool.take_held(&self.options) {
            self.refuse(taken.err());
            let renamed = self.tool.take_name();
            self.refuse(renamed);
            self.events.push(here, QueuedEvent::Plain(Event::NewStart(NewStart::Tool(tool))));
        }
    }

    /// Reports two statements about a tool that contradict each other.
    fn refuse(&mut self, contradiction: Option<Contradiction>) {
        if let Some((at, fault)) = contradiction {
            self.events.refuse(at, fault);
        }
    }

    fn emit(&mut self, here: Location, event: Event<'static>) {
        self.push(here, QueuedEvent::Plain(event));
    }

    fn emit_text(&mut self, here: Location, used: TextUse, text: &Text<'_>) {
        self.push(here, QueuedEvent::Text(used, text.at));
    }

    #[inline]
    fn push(&mut self, here: Location, event: QueuedEvent) {
        self.emit_waiting();
        self.events.push(here, event);
    }

    /// Whether an event is queued.
    #[inline]
    pub(crate) fn has_events(&self) -> bool {
        !self.events.is_empty()
    }

    /// Whether the next GOTO is a straight motion, where no event is queued before it.
    #[inline]
    pub(crate) fn is_straight(&self) -> bool {
        self.plain_goto && !self.is_any_waiting() && self.unloaded.is_none()
    }

    /// Notes whether a GOTO is independent of circles, curves, cycles, votes and coordinate transforms.
    #[inline]
    fn update_plain_goto(&mut self) {
        self.plain_goto = !self.arc.is_open()
            && !self.votes.has_undecided()
            && !self.curve.is_open()
            && !self.tool.is_described_anew()
            && !self.cycle.is_active()
            && !self.path.is_above_hole()
            && !matches!(self.cutcom, CutcomOn::Asked(_))
            && self.coordinates.transforms().none()
            && !self.coordinates.workpiece().is_watched()
            && self.options.always_tip();
    }

    fn take_program(&mut self, record: &ProgramRecord<'_>, here: Location) -> Result<(), ClFault> {
        match record {
            ProgramRecord::PartName(text) => self.emit_text(here, TextUse::Text(TextKind::Name), text),
            ProgramRecord::MachineName(text) => self.emit_text(here, TextUse::Text(TextKind::MachineName), text),
            ProgramRecord::ToolPath { name, tool } => {
                self.begin_operation();
                self.tool.begin_operation(*tool, here);
                if let Some(number) =
                    self.coordinates.begin_operation(decoded(name.bytes).as_bytes(), &self.options.set_ups)
                {
                    self.change_set_up(number, here);
                }
                self.take_operation_name(here, name);
            }
            ProgramRecord::Message(text) => self.emit_text(here, TextUse::Text(TextKind::Message), text),
            ProgramRecord::Insert(text) => return self.insert(text, here),
            ProgramRecord::Code { letter, number, at } => return self.code(*letter, *number, *at, here),
            ProgramRecord::OptionalStop => {
                self.remark_on_spindle("OPSTOP");
                self.emit(here, Event::Interruption(Interruption::OptionalStop));
            }
            ProgramRecord::Stop => {
                self.emit_waiting();
                self.remark_on_spindle("STOP");
                self.waiting.stop = Some(here);
            }
            ProgramRecord::BlockSkip { on } => self.skip_blocks(*on, here),
            ProgramRecord::EndOfPath | ProgramRecord::End | ProgramRecord::Fini | ProgramRecord::Rewind => {}
        }
        Ok(())
    }

    /// Notes SPINDL/ON.
    fn note_spindle_on(&mut self, record: &MachineRecord) {
        if let MachineRecord::Spindle(spindle) = record {
            let only_on = *spindle == Spindle::On { speed_rev_per_min: None, rotation: None };
            self.spindle_on_after = only_on.then(|| self.path.motions());
        }
    }

    /// STOP or OPSTOP, the `word`. A spindle that is switched on just before is remarked on: the scripts of Autodesk
    /// write SPINDL/ON for the command that stops the spindle, and SPINDL/OFF for the one that starts it.
    fn remark_on_spindle(&mut self, word: &'static str) {
        if self.spindle_on_after.take() == Some(self.path.motions()) {
            self.events.warn(cl::SPINDLE.cl_fault(
                "spindle at a stop",
                Span::WHOLE,
                format!("SPINDL/ON comes directly before {word}, where a spindle is switched off"),
                format!(
                    "the post \"Common ISO 4343 APT\" of Autodesk exchanges the two: write SPINDL/OFF before {word}, and SPINDL/ON \
                     after it; if the spindle shall be on, write SPINDL/ON after {word} only"
                ),
            ));
        }
    }

    fn begin_operation(&mut self) {
        self.axis.begin_operation();
        self.coordinates.release_axis();
        self.cycle.end_operation();
        // Motions of another operation do not vote on the sense of an arc.
        self.path.forget_line();
        self.votes.conclude_arc(None);
    }

    fn insert(&mut self, text: &Text<'_>, here: Location) -> Result<(), ClFault> {
        let stop = text.bytes.len() >= 4
            && text.bytes[..4].eq_ignore_ascii_case(b"STOP")
            && text.bytes.get(4).is_none_or(|byte| !byte.is_ascii_alphanumeric());
        if stop && self.options.insert_stop {
            self.emit(here, Event::Interruption(Interruption::Stop));
            self.emit_text(here, TextUse::Text(TextKind::Message), text);
            return Ok(());
        }
        if stop && self.options.insert != Insert::Refuse {
            return Err(cl::NC_TEXT.cl_fault(
                "INSERT",
                text.at,
                "INSERT/STOP may be a program stop that is needed",
                "`[cl] insert_stop = true` treats it as STOP",
            ));
        }
        match self.options.insert {
            Insert::Comment => self.emit_text(here, TextUse::Text(TextKind::Message), text),
            Insert::Write => {
                self.path.forget_position();
                self.emit_text(here, TextUse::Insert, text);
            }
            Insert::Refuse => {
                return Err(cl::NC_TEXT.cl_fault(
                    "INSERT",
                    text.at,
                    "INSERT is refused: the effect of its NC text on the machine is unknown",
                    "`--insert comment` outputs the text as a comment, `--allow-insert` as written",
                ));
            }
        }
        Ok(())
    }

    fn code(&mut self, letter: u8, number: u32, at: Span, here: Location) -> Result<(), ClFault> {
        let (word, key, allowed) = match letter {
            b'M' => ("AUXFUN", "auxfun", &self.options.auxfun),
            _ => ("PREFUN", "prefun", &self.options.prefun),
        };
        let stated = self.options.own_statements.iter().find(|own| own.code() == Some((letter, number)));
        if stated.is_none() && !allowed.contains(&number) {
            return Err(cl::NC_TEXT.cl_fault(
                word,
                at,
                format!("{word} is refused: the effect of {}{number} on the machine is unknown", char::from(letter)),
                format!(
                    "to output the code, allow it: `[cl] {key} = [{number}]`; if the control does not have it itself, \
                     declare its effect in `[control] effects`, too: `{letter}{number} = \"none\"`",
                    letter = char::from(letter)
                ),
            ));
        }
        self.path.forget_position();
        let place = stated.map(OwnStatement::place).unwrap_or_default();
        self.emit(here, Event::Interruption(Interruption::Code { letter, number, place }));
        Ok(())
    }
}
