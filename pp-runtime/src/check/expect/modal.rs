//! Modal state of the CL data, from the specification: which tool, register, speed, sense of rotation and coolant
//! belong to a motion, where an operation begins, and what is posted.

use std::rc::Rc;

use super::super::geometry::{ArcPath, PathShape, bezier, depth_of_line, tool_pose};
use super::super::policy::{CheckPolicy, OperationSelection, StopRule};
use super::super::read::{LengthRegisters, SideOfPath, coolant};
use super::hole::{ExpectedHole, HoleStep, unfolded};
use super::operations::{self, RulesInForce};
use super::{ClMotion, ExpectedAction, ExpectedItem, ExpectedMessage, Kept, Required, RequiredSmoothing, SpindleState};
use crate::check::tolerances::{IN_CUTTER_PLANE, SAME_AXIS, SAME_POSE};
use crate::diag::code::config;
use crate::diag::{Diagnostic, Severity};
use crate::kinematics::Pose;
use crate::program::{
    Arc, BlockPlace, Clearance, Compensation, Coolant, Coolants, CutterSide, Drilling, Dwell, Event, Feed, Hole,
    Interruption, Location, MachineFunction, Move, NewStart, Pressure, ReferenceGeometry, Rotation, Spindle, Spline,
    TextKind, ToolCall, ToolMotion,
};

/// Modal state of the CL data.
pub(super) struct ClState<'a> {
    policy: &'a CheckPolicy,
    /// The machine has rotary axes in its head.
    head: bool,
    /// One unit of linear words.
    unit_mm: f64,
    /// Shared with the items that require it.
    required: Rc<Required>,
    /// Spindle and coolant may be others since the last motion.
    process_due: bool,
    spindle: SpindleRecords,
    coolant: Coolant,
    compensation: CompensationRequest,
    operation: OperationState,
    /// Name of the last operation that has one, and the record of the name where no motion has come since.
    named: (String, Option<Location>),
    /// Rules of the operation.
    rules: RulesInForce,
    /// Tolerance of the CL data (LINTOL), mm.
    stated_mm: Option<f64>,
    /// Rules that contradict each other.
    fault: Option<Diagnostic>,
    path: ClPath,
    holes: ClHoles,
    queue: ExpectedQueue,
    skipping: SkippedBlocks,
    calls: ToolCalls,
    /// Blocks of the shop that come before the approach to the next motion.
    at_approach: Vec<(Location, ExpectedAction)>,
}

/// What the program must have, until it has come.
#[derive(Debug, Default)]
struct ExpectedQueue {
    items: Kept<ExpectedItem>,
    /// Number of the last item that is no motion.
    last_other: u64,
    messages: Kept<ExpectedMessage>,
    /// Items after the call of a tool, until the name of their operation says whether it is in the program.
    unnamed: Vec<ExpectedItem>,
}

/// Where the path of the CL data is.
#[derive(Debug, Default)]
struct ClPath {
    /// Pose after the last motion.
    here: Option<Pose>,
    /// A cut would go on from `here`: no hole, and no name, tool or motion of the machine since.
    goes_on: bool,
    /// An arc needs a line to its start.
    fresh_arc: bool,
}

/// Holes of the CL data.
#[derive(Debug, Default)]
struct ClHoles {
    /// The one whose motions are being added.
    current: Option<Rc<ExpectedHole>>,
    /// Number of holes so far.
    count: u64,
}

/// Blocks that may be skipped.
#[derive(Debug, Default)]
struct SkippedBlocks {
    /// OPSKIP/ON is in force.
    on: bool,
    /// Something had moved before it since the last stop.
    worked_before: bool,
    tool_before: Option<u32>,
    /// The tool before the blocks, until a tool is called after them.
    tool_if_skipped: Option<u32>,
}

/// Calls of tools.
#[derive(Debug, Default)]
struct ToolCalls {
    /// The last tool that has been called in the selected operations.
    last: Option<u32>,
    /// The last call.
    record: Option<ToolCall>,
    /// State before the call of a tool that nothing has been carried out with.
    before: Option<Rc<Required>>,
}

/// Requests of SPINDL.
#[derive(Debug, Clone, Copy, Default)]
struct SpindleRecords {
    now: SpindleRecord,
    /// Since the end of the last operation.
    in_start: SpindleRecord,
    /// A stop or NC text has come since the last one: the spindle starts in the approach.
    held: bool,
    /// What is requested after the last motion of the selected operations.
    after_selected: Option<Option<SpindleState>>,
}

/// Speed and sense of rotation as far as they are requested, and OFF.
#[derive(Debug, Clone, Copy, Default)]
struct SpindleRecord {
    speed_rev_per_min: Option<f64>,
    rotation: Option<Rotation>,
    off: bool,
}

impl SpindleRecord {
    /// A value that SPINDL leaves out keeps its last one.
    fn take(&mut self, spindle: Spindle) {
        self.off = spindle == Spindle::Off;
        if let Spindle::On { speed_rev_per_min, rotation } = spindle {
            self.speed_rev_per_min = speed_rev_per_min.or(self.speed_rev_per_min);
            self.rotation = rotation.or(self.rotation);
        }
    }
}

/// Requests of CUTCOM.
#[derive(Debug, Clone, Copy, Default)]
struct CompensationRequest {
    /// Begins with a line perpendicular to the tool, and ends with the next motion.
    side: SideOfPath,
    /// Last side that was programmed, for ON.
    last_side: SideOfPath,
    register: Option<u32>,
}

/// Where in its operations the CL data is.
#[derive(Debug, Clone, Copy)]
struct OperationState {
    number: u64,
    /// No motion yet.
    starts: bool,
    /// The position of the machine is known.
    position_known: bool,
    /// Nothing but names, and calls of the tool in the spindle, has come since the last motion, with a clearance
    /// geometry.
    linked: bool,
    /// Something has moved since the last stop.
    worked: bool,
    /// The last stop is that of the configuration, and nothing has come since.
    stopped: bool,
    /// A tool record is in this start.
    called: bool,
    /// The tool has changed in this start.
    changed: bool,
    /// The name of the operation that begins is the one selected.
    named: bool,
    /// The operation selected by name has been reached.
    reached: bool,
}

impl<'a> ClState<'a> {
    pub(super) fn new(policy: &'a CheckPolicy, head: bool, unit_mm: f64) -> Self {
        let required = Required {
            allowance_mm: 0.0,
            tool: None,
            called: None,
            register: 0,
            gauge_length_mm: None,
            spindle: None,
            requested_spindle: None,
            requested_before: None,
            coolant: 0,
            set_up: 1,
            operation: 0,
            side: SideOfPath::None,
            radius_register: 0,
            radius_mm: None,
            tolerance_mm: policy.tolerances.path_mm,
            linear: policy.words.linear,
            smoothing: RequiredSmoothing { level: policy.shop.smoothing, blending_mm: policy.tolerances.blending_mm },
            clearance: policy.links.clearance,
        };
        let operation = OperationState {
            number: 0,
            starts: true,
            position_known: false,
            linked: false,
            worked: false,
            stopped: false,
            called: false,
            changed: false,
            named: false,
            reached: false,
        };
        Self {
            policy,
            head,
            unit_mm,
            required: Rc::new(required),
            process_due: true,
            spindle: SpindleRecords::default(),
            coolant: Coolant::Off,
            compensation: CompensationRequest::default(),
            operation,
            named: (String::new(), None),
            rules: RulesInForce::default(),
            stated_mm: None,
            fault: None,
            path: ClPath { fresh_arc: true, ..ClPath::default() },
            holes: ClHoles::default(),
            queue: ExpectedQueue::default(),
            skipping: SkippedBlocks::default(),
            calls: ToolCalls::default(),
            at_approach: Vec::new(),
        }
    }

    /// Items of the events so far.
    pub(super) fn items(&mut self) -> &mut Kept<ExpectedItem> {
        &mut self.queue.items
    }

    /// The state of the next motions, to be changed.
    fn require(&mut self) -> &mut Required {
        Rc::make_mut(&mut self.required)
    }

    pub(super) fn event(&mut self, at: Location, event: &Event<'_>) {
        self.process_due |= !matches!(event, Event::Motion(ToolMotion::Move(_) | ToolMotion::Arc(_)));
        match *event {
            Event::Motion(ToolMotion::Move(motion)) => self.line(at, &motion),
            Event::Motion(ToolMotion::Arc(arc)) => self.arc(at, &arc),
            Event::Motion(ToolMotion::Spline(spline)) => self.spline(at, &spline),
            Event::Motion(ToolMotion::Hole(hole)) => self.hole(at, &hole),
            Event::NewStart(start) => self.new_start(at, start),
            Event::Interruption(interruption) => self.interruption(at, interruption),
            Event::Function(function) => self.function(at, function),
            Event::Reference(ReferenceGeometry::ClearancePlane(plane)) => {
                let clearance = Some(Clearance::Plane(plane));
                self.operation.linked &= self.required.clearance == clearance;
                self.require().clearance = clearance;
            }
            Event::Text(TextKind::Message, text) => self.message(at, text, false),
            // Nothing in a program follows from these.
            Event::Reference(ReferenceGeometry::From(_)) | Event::Text(TextKind::Name | TextKind::MachineName, _) => {}
        }
    }

    fn new_start(&mut self, at: Location, start: NewStart<'_>) {
        match start {
            NewStart::Operation(name) => self.begin_operation(at, name),
            NewStart::Tool(call) => self.tool(Some(at), &call),
            NewStart::SetUp(number) => {
                self.begin_elsewhere();
                self.require().set_up = number;
                self.require().clearance = self.policy.links.clearance;
            }
            NewStart::SafeSequence => self.begin_elsewhere(),
            NewStart::Home => {
                self.path.goes_on = false;
                let called = self.operation.called;
                // The spindle goes on.
                self.begin_anew();
                self.push(at, ExpectedAction::Home { called });
            }
        }
    }

    fn interruption(&mut self, at: Location, interruption: Interruption<'_>) {
        match interruption {
            Interruption::Stop => self.interrupt(at, ExpectedAction::Stop { optional: false }),
            Interruption::OptionalStop if self.operation.stopped => self.begin_anew(),
            Interruption::OptionalStop => self.interrupt(at, ExpectedAction::Stop { optional: true }),
            Interruption::BlockSkip { on } => self.block_skip(at, on),
            Interruption::Insert(text, place) => self.raw(at, text.to_vec(), place),
            Interruption::Probe(blocks) => {
                for (index, block) in blocks.iter().enumerate() {
                    let text = block.as_bytes().to_vec();
                    self.interrupt(at, ExpectedAction::Probe { text, first: index == 0 });
                }
            }
            Interruption::Code { letter, number, place } => {
                self.raw(at, format!("{}{number}", char::from(letter)).into_bytes(), place);
            }
        }
    }

    /// A block of the shop: with the tool before a call, with that of the call, or last before the next motion.
    fn raw(&mut self, at: Location, text: Vec<u8>, place: BlockPlace) {
        let action = ExpectedAction::Raw(text);
        match (place, self.calls.before.clone()) {
            (BlockPlace::AtApproach, _) => {
                self.begin_anew();
                self.at_approach.push((at, action));
            }
            (BlockPlace::BeforeChange, Some(before)) => {
                // It belongs to the operation before.
                let called = std::mem::take(&mut self.operation.called);
                let after = std::mem::replace(&mut self.required, Rc::clone(&before));
                self.interrupt(at, action);
                (self.required, self.operation.called, self.calls.before) = (after, called, Some(before));
            }
            _ => self.interrupt(at, action),
        }
    }

    /// Blocks of the shop that wait for an approach come: before its motion, or at the end of the CL data.
    pub(super) fn come_to_approach(&mut self) {
        for (at, action) in std::mem::take(&mut self.at_approach) {
            self.spindle.held = true;
            self.push(at, action);
        }
    }

    fn function(&mut self, at: Location, function: MachineFunction) {
        match function {
            MachineFunction::Spindle(spindle) => self.request_spindle(spindle),
            MachineFunction::Coolant(coolant) => self.coolant = coolant,
            MachineFunction::Compensation(compensation) => self.compensate(compensation),
            MachineFunction::Tolerance(stated) => {
                self.stated_mm = stated;
                self.take_tolerance();
            }
            MachineFunction::Delay(dwell) => self.delay(at, dwell),
            // Nothing in a program follows from these.
            MachineFunction::RotaryDirection(_) | MachineFunction::Preselect(_) => {}
        }
    }

    fn arc(&mut self, at: Location, arc: &Arc) {
        self.call_default_tool();
        if self.path.fresh_arc {
            self.line(at, &Move { pose: arc.start, rapid: false, feed: arc.feed });
        }
        let end = Move { pose: arc.end, rapid: false, feed: arc.feed };
        self.motion(at, &end, PathShape::Arc(Rc::new(ArcPath::of(arc))));
    }

    fn spline(&mut self, at: Location, spline: &Spline<'_>) {
        self.call_default_tool();
        let to = |tip| Move { pose: Pose { tip, axis: spline.axis }, rapid: false, feed: spline.feed };
        let (Some(first), Some(last)) = (spline.points.first(), spline.points.last()) else { return };
        if self.path.fresh_arc {
            self.line(at, &to(*first));
        }
        for span in 3..spline.points.len() {
            if spline.knots[span] < spline.knots[span + 1] {
                let piece = bezier(spline.knots, spline.points, span);
                let end = if span + 1 < spline.points.len() { piece[3].into() } else { *last };
                self.motion(at, &to(end), PathShape::Cubic(Rc::new(piece)));
            }
        }
    }

    fn hole(&mut self, at: Location, hole: &Hole) {
        self.call_default_tool();
        self.holes.count += 1;
        self.holes.current = Some(Rc::new(ExpectedHole { number: self.holes.count, hole: *hole }));
        let here = self.path.here.filter(|_| !self.operation.starts);
        for step in unfolded(hole, here.as_ref(), self.policy.defaults.peck_gap_mm) {
            match step {
                HoleStep::Move(motion) => self.line(at, &motion),
                HoleStep::Dwell(dwell) => self.delay(at, dwell),
            }
        }
        self.holes.current = None;
    }

    /// The optional stop after an operation for which the configuration asks; `other_tool`: another tool comes.
    fn stop_after_operation(&mut self, at: Location, other_tool: bool) {
        let wanted = match self.policy.links.optional_stops {
            StopRule::None => false,
            StopRule::ToolChanges => other_tool,
            StopRule::Operations => true,
        };
        let ends = match &self.policy.selection {
            Some(OperationSelection::Range(_, Some(last))) => self.operation.number >= *last,
            Some(OperationSelection::Range(_, None) | OperationSelection::From(_)) | None => false,
        };
        if wanted && self.operation.worked && !ends {
            self.interrupt(at, ExpectedAction::Stop { optional: true });
            self.operation.stopped = true;
        }
    }

    /// Texts that the control must display.
    pub(super) fn messages(&mut self) -> &mut Kept<ExpectedMessage> {
        &mut self.queue.messages
    }

    /// Number of the last item that is no motion; 0 before the first.
    pub(super) fn last_other(&self) -> u64 {
        self.queue.last_other
    }

    /// The last tool that has been called in the selected operations.
    pub(super) fn last_call(&self) -> Option<u32> {
        self.calls.last
    }

    /// A text that the control displays, where the configuration asks for it; before the first motion of an operation
    /// it belongs to that.
    fn message(&mut self, at: Location, text: &[u8], may_be_cut: bool) {
        self.calls.before = None;
        let operation = &self.operation;
        let (number, reached) = match operation.starts {
            true => (operation.number + 1, operation.reached || operation.named),
            false => (operation.number, operation.reached),
        };
        let text = legible(text);
        if self.policy.shop.displays_messages && !text.is_empty() && self.is_selected(number, reached) {
            self.queue.messages.push(ExpectedMessage { at, text, may_be_cut, after: self.queue.items.count() });
        }
    }

    fn begin_operation(&mut self, at: Location, name: &[u8]) {
        self.stop_after_operation(at, false);
        self.link(true);
        self.begin();
        self.path.goes_on = false;
        let name = String::from_utf8_lossy(name);
        if !self.policy.operations.is_empty() {
            self.named = (name.clone().into_owned(), Some(at));
        }
        if let Some(OperationSelection::From(selected)) = &self.policy.selection {
            self.operation.named |= name.trim().eq_ignore_ascii_case(selected.trim());
            if self.operation.named {
                for item in std::mem::take(&mut self.queue.unnamed) {
                    self.enqueue(item);
                }
            }
        }
        if self.policy.family.facts().names_are_messages {
            self.message(at, name.as_bytes(), true);
        }
    }

    fn request_spindle(&mut self, spindle: Spindle) {
        self.spindle.now.take(spindle);
        self.spindle.held = false;
        if self.operation.starts {
            self.spindle.in_start.take(spindle);
        } else {
            let state = self.spindle_state();
            let required = self.require();
            required.requested_before = required.requested_spindle.flatten();
            required.requested_spindle = Some(state);
            if self.is_selected_here() {
                self.spindle.after_selected = Some(state);
            }
        }
    }

    /// The first motion of an operation has come.
    fn forget_requests(&mut self) {
        if self.required.requested_spindle.is_some() {
            let required = self.require();
            (required.requested_spindle, required.requested_before) = (None, None);
        }
        if self.is_selected_here() {
            self.spindle.after_selected = None;
        }
    }

    /// The spindle that SPINDL requests after the last selected motion.
    pub(super) fn requested_after_selected(&self) -> Option<Option<SpindleState>> {
        self.spindle.after_selected
    }

    /// CUTCOM: ON takes the side and the register that were programmed last.
    fn compensate(&mut self, asked: Compensation) {
        let request = &mut self.compensation;
        request.side = match asked.side {
            CutterSide::Off => return request.side = SideOfPath::None,
            CutterSide::Left => SideOfPath::Left,
            CutterSide::Right => SideOfPath::Right,
            CutterSide::On => request.last_side,
        };
        request.last_side = request.side;
        request.register = asked.register.or(request.register.filter(|_| asked.side == CutterSide::On));
    }

    /// The radius register of a compensation that begins: that of the tool which then is in the spindle, unless another
    /// is given.
    fn radius_register(&self) -> u32 {
        let tool = self.required.tool.unwrap_or(0);
        let given = self.policy.set_up.tools.get(&tool).and_then(|tool| tool.radius_offset);
        given.or(self.compensation.register).unwrap_or(tool)
    }

    /// Another operation begins; `same`: with the tool of the last one.
    fn link(&mut self, same: bool) {
        let operation = &mut self.operation;
        let first = !operation.starts || operation.linked;
        operation.linked = first && same && self.policy.links.over_clearance && self.required.clearance.is_some();
    }

    /// Whether the tool goes on to an operation without a retract: at rapid, with the same tool axis, over the
    /// clearance geometry.
    fn links_to(&self, motion: &Move) -> bool {
        let (Some(from), Some(clearance)) = (self.path.here, self.required.clearance) else { return false };
        let axes = from.axis.into_inner() - motion.pose.axis.into_inner();
        let depth_mm = depth_of_line(&clearance, &from.tip.coords, &motion.pose.tip.coords);
        self.operation.linked
            && motion.rapid
            && self.holes.current.is_none()
            && axes.norm() <= SAME_AXIS
            && depth_mm <= 0.0
    }

    /// The next motion begins an operation.
    fn begin(&mut self) {
        if !self.operation.starts {
            self.spindle.in_start = SpindleRecord::default();
        }
        self.operation.starts = true;
        self.path.fresh_arc = true;
    }

    /// The next motion begins an operation from an unknown position of the machine.
    fn begin_anew(&mut self) {
        self.begin();
        self.operation.position_known = false;
        self.operation.linked = false;
    }

    /// The next motion begins an operation from an unknown position, and no cut goes on from where it was.
    fn begin_elsewhere(&mut self) {
        self.path.goes_on = false;
        self.begin_anew();
    }

    /// OPSKIP.
    fn block_skip(&mut self, at: Location, on: bool) {
        let begins = on && self.is_selected_here();
        if begins == self.skipping.on || on && !begins {
            // Among operations that are not in the program it separates them all the same.
            self.spindle.held = true;
            return self.begin_anew();
        }
        self.skipping.on = begins;
        if begins {
            (self.skipping.worked_before, self.skipping.tool_before) = (self.operation.worked, self.required.tool);
        } else {
            // Skipped, a stop or a tool change among the blocks has not been.
            self.operation.worked |= self.skipping.worked_before;
            self.skipping.tool_if_skipped = self.skipping.tool_before;
        }
        self.interrupt(at, ExpectedAction::BlockSkip { on });
    }

    fn interrupt(&mut self, at: Location, action: ExpectedAction) {
        self.operation.worked &= !matches!(action, ExpectedAction::Stop { .. });
        self.spindle.held = true;
        self.begin_anew();
        self.push(at, action);
    }

    fn tool(&mut self, at: Option<Location>, call: &ToolCall) {
        if let Some(at) = at {
            let other = |tool: Option<u32>| tool != Some(call.number);
            let if_skipped = self.skipping.tool_if_skipped.take();
            self.stop_after_operation(at, other(self.required.tool) || if_skipped.is_some() && other(if_skipped));
        }
        let again = self.calls.record.replace(*call) == Some(*call);
        if again && self.policy.links.over_clearance && self.required.clearance.is_some() {
            self.link(true);
            self.path.goes_on = false;
            self.begin();
        } else {
            self.begin_elsewhere();
        }
        self.process_due = true;
        self.calls.before.get_or_insert_with(|| Rc::clone(&self.required));
        let given = self.policy.set_up.tools.get(&call.number);
        if self.required.tool != Some(call.number) {
            self.operation.stopped = false;
            self.require().called = at;
            self.spindle.now = if self.operation.called { SpindleRecord::default() } else { self.spindle.in_start };
            self.operation.changed = true;
        }
        self.operation.called = true;
        if self.is_selected(self.operation.number + 1, self.operation.reached || self.operation.named) {
            self.calls.last = Some(call.number);
        }
        self.require().tool = Some(call.number);
        let diameter_mm = call.diameter_mm.or(given.and_then(|tool| tool.diameter_mm));
        self.require().radius_mm = diameter_mm.map(|diameter| 0.5 * diameter);
        self.require().gauge_length_mm = call.length_mm.or(given.and_then(|tool| tool.length_mm));
        let offset = call.length_offset.or(given.and_then(|tool| tool.offset));
        self.require().register = match self.policy.family.facts().registers {
            LengthRegisters::Shared => offset.unwrap_or(call.number),
            // Edges count from 1 in each tool. CL data whose numbers are those of the tools means none of them.
            LengthRegisters::Edges => offset.filter(|offset| *offset != call.number).unwrap_or(1),
            LengthRegisters::Rows => call.number,
        };
    }

    /// Calls the tool of the configuration, where the CL data calls none.
    fn call_default_tool(&mut self) {
        if self.required.tool.is_none()
            && let Some(number) = self.policy.defaults.tool
        {
            self.tool(None, &ToolCall { number, ..ToolCall::default() });
        }
    }

    fn line(&mut self, at: Location, motion: &Move) {
        self.call_default_tool();
        self.go_back(at, motion);
        let side = self.compensation.side;
        if side != self.required.side && (side == SideOfPath::None || self.is_perpendicular(motion)) {
            let register = self.radius_register();
            let required = self.require();
            (required.side, required.radius_register) = (side, register);
        }
        self.motion(at, motion, PathShape::Line);
    }

    /// A cut that was interrupted, by a stop or OPSKIP, goes on where it was: the tool comes back there first.
    fn go_back(&mut self, at: Location, motion: &Move) {
        let from = self
            .path
            .here
            .filter(|_| self.path.goes_on && self.operation.starts && !motion.rapid && self.holes.current.is_none());
        if let Some(pose) = from.filter(|from| {
            let apart = [from.tip - motion.pose.tip, from.axis.into_inner() - motion.pose.axis.into_inner()];
            apart.iter().any(|step| step.norm() > SAME_POSE)
        }) {
            self.motion(at, &Move { pose, ..*motion }, PathShape::Line);
        }
    }

    /// A feed motion perpendicular to the tool, from a known position.
    fn is_perpendicular(&self, motion: &Move) -> bool {
        let Some(here) = self.path.here.filter(|_| !self.operation.starts && !motion.rapid) else { return false };
        let step = motion.pose.tip - here.tip;
        let along = step.dot(&motion.pose.axis);
        along.abs() <= IN_CUTTER_PLANE.max(0.5 * self.unit_mm)
            && (step.norm_squared() - along * along).sqrt() >= self.unit_mm
    }

    fn motion(&mut self, at: Location, motion: &Move, shape: PathShape) {
        self.path.fresh_arc = false;
        let operation = &mut self.operation;
        // Before the first tool no length is active, and nothing moves.
        if operation.starts && self.required.tool.is_none() && motion.rapid && !self.head {
            return;
        }
        let operation = &self.operation;
        // The program begins with a selected operation: that does not go on from one before.
        let stays =
            operation.position_known && !operation.changed && self.is_selected(operation.number, operation.reached);
        let continues = stays && (self.policy.links.direct || operation.starts && self.links_to(motion));
        let starts = operation.starts && !continues;
        // A hole is one statement, which no cut goes on from.
        self.path.goes_on = self.holes.current.is_none();
        self.path.here = Some(motion.pose);
        let begins = self.operation.starts;
        if begins {
            self.start_operation(at);
        }
        self.operation.position_known = true;
        self.operation.worked = true;
        if std::mem::take(&mut self.process_due) {
            self.take_process();
        }
        if !self.at_approach.is_empty() {
            self.come_to_approach();
        }
        let to = tool_pose(&motion.pose);
        let feed = motion.feed.map(|feed| if self.in_thread() { feed } else { self.capped(feed) });
        self.push(at, ExpectedAction::Motion(ClMotion { to, shape, rapid: motion.rapid, feed, starts }));
        // A SPINDL after the operation before counts until here.
        if begins {
            self.forget_requests();
        }
    }

    /// An operation begins with its first motion.
    #[inline(never)]
    fn start_operation(&mut self, first_motion: Location) {
        let operation = &mut self.operation;
        operation.number += 1;
        operation.reached |= operation.named;
        operation.starts = false;
        operation.called = false;
        operation.changed = false;
        self.queue.unnamed.clear();
        let number = self.operation.number;
        let required = self.require();
        required.operation = number;
        self.take_rules(first_motion);
    }

    /// Takes spindle and coolant of the next motions.
    #[inline(never)]
    fn take_process(&mut self) {
        let (spindle, coolant) = (self.spindle_state(), self.coolant_bits());
        // Motions with the same requirements share them.
        if self.required.spindle != spindle || self.required.coolant != coolant {
            let required = self.require();
            (required.spindle, required.coolant) = (spindle, coolant);
        }
    }

    /// Takes the rules of the operation that begins.
    fn take_rules(&mut self, first_motion: Location) {
        if self.policy.operations.is_empty() {
            return;
        }
        let (name, named_at) = &mut self.named;
        let at = named_at.take().unwrap_or(first_motion);
        self.rules = match operations::in_force(&self.policy.operations, self.operation.number, name) {
            Ok(rules) => rules,
            Err(property) => {
                self.fault.get_or_insert_with(|| contradiction(at, property));
                RulesInForce::default()
            }
        };
        self.require().linear = self.rules.linear.unwrap_or(self.policy.words.linear);
        let smoothing = RequiredSmoothing {
            level: self.rules.smoothing.unwrap_or(self.policy.shop.smoothing),
            blending_mm: self.rules.blending_mm.unwrap_or(self.policy.tolerances.blending_mm),
        };
        self.require().smoothing = smoothing;
        self.require().allowance_mm = self.rules.allowance_mm.unwrap_or(0.0);
        self.take_tolerance();
    }

    /// Tolerance of the operation, or of LINTOL.
    fn take_tolerance(&mut self) {
        let tolerances = &self.policy.tolerances;
        let largest = self.rules.path_mm.unwrap_or(tolerances.path_mm);
        let allowed = |stated: &f64| tolerances.stated_may_be_larger || *stated <= largest;
        self.require().tolerance_mm = self.stated_mm.filter(allowed).unwrap_or(largest);
    }

    /// A feed, at most the largest of the operation.
    fn capped(&self, feed: Feed) -> Feed {
        let Some(largest) = self.rules.largest_feed_mm_per_min else { return feed };
        let speed = self.required.spindle.map(|(speed, _)| speed);
        match (feed, speed) {
            (Feed::PerMinute(rate), _) => Feed::PerMinute(rate.min(largest)),
            (Feed::PerRevolution(rate), Some(speed)) if rate * speed > largest => Feed::PerMinute(largest),
            (Feed::PerRevolution(_), _) => feed,
        }
    }

    /// A hole whose motions are being added, at its feed.
    fn at_feed(&self, hole: &Rc<ExpectedHole>) -> Rc<ExpectedHole> {
        let mut expected = Rc::clone(hole);
        if let Drilling::Tap { pitch_mm: None } = expected.hole.drilling {
            // The thread is that of the CL data, whichever speed is written.
            let pitch_mm = match (expected.hole.feed, self.exact_spindle()) {
                (Some(Feed::PerRevolution(pitch)), _) => Some(pitch),
                (Some(Feed::PerMinute(feed)), Some((speed, _))) => Some(feed / speed),
                (Some(Feed::PerMinute(_)), None) | (None, _) => None,
            };
            Rc::make_mut(&mut expected).hole.drilling = Drilling::Tap { pitch_mm };
        }
        let feed = expected.hole.feed.map(|feed| if self.in_thread() { feed } else { self.capped(feed) });
        if feed != expected.hole.feed {
            Rc::make_mut(&mut expected).hole.feed = feed;
        }
        expected
    }

    /// Whether the motion is one of a thread, whose feed follows from its pitch.
    fn in_thread(&self) -> bool {
        self.holes.current.as_ref().is_some_and(|hole| matches!(hole.hole.drilling, Drilling::Tap { .. }))
    }

    /// The first rules that contradict each other.
    pub(super) fn fault(&self) -> Option<&Diagnostic> {
        self.fault.as_ref()
    }

    /// The spindle as it is written.
    fn spindle_state(&self) -> Option<SpindleState> {
        let (speed, rotation) = self.exact_spindle()?;
        let scale = 10_f64.powi(self.policy.digits.speed as i32);
        Some(((speed * scale).round() / scale, rotation))
    }

    /// The spindle as CL data and configuration have it.
    fn exact_spindle(&self) -> Option<SpindleState> {
        let request = &self.spindle.now;
        if request.off {
            return None;
        }
        let given = self.required.tool.and_then(|tool| self.policy.set_up.tools.get(&tool));
        let defaults = &self.policy.defaults;
        let speed = request.speed_rev_per_min.or(given.and_then(|tool| tool.speed_rev_per_min));
        let speed = speed.or(defaults.speed_rev_per_min)?;
        let rotation = request.rotation.or(given.and_then(|tool| tool.rotation)).or(defaults.rotation)?;
        Some((speed, rotation))
    }

    fn coolant_bits(&self) -> u8 {
        if self.policy.links.dry_lift_mm.is_some() {
            return 0;
        }
        let given = self.required.tool.and_then(|tool| self.policy.set_up.tools.get(&tool));
        let kinds = match self.coolant {
            Coolant::On => given.and_then(|tool| tool.coolant).unwrap_or(self.policy.defaults.coolant),
            kind => Coolants::of(kind),
        };
        kinds.kinds().map(|kind| self.coolant_bit(kind)).fold(0, |bits, bit| bits | bit)
    }

    fn coolant_bit(&self, kind: Coolant) -> u8 {
        match kind {
            Coolant::On | Coolant::Flood => coolant::FLOOD,
            Coolant::Mist => coolant::MIST,
            Coolant::Through => coolant::THROUGH,
            // A pressure without codes is left out.
            Coolant::ThroughAt(pressure) => {
                let bit = match pressure {
                    Pressure::Low => coolant::PRESSURES[0],
                    Pressure::Medium => coolant::PRESSURES[1],
                    Pressure::High => coolant::PRESSURES[2],
                };
                let codes = &self.policy.shop.lines;
                if codes.iter().any(|line| line.coolant == Some((bit, true))) { bit } else { coolant::THROUGH }
            }
            Coolant::Air => coolant::AIR,
            Coolant::Off => 0,
        }
    }

    fn delay(&mut self, at: Location, dwell: Dwell) {
        let seconds = match dwell {
            Dwell::Seconds(seconds) => seconds,
            Dwell::Revolutions(count) => self.spindle_state().map_or(f64::NAN, |(speed, _)| count / speed * 60.0),
        };
        self.calls.before = None;
        if seconds > 0.0 {
            let SpindleRecord { speed_rev_per_min, rotation, off } = self.spindle.in_start;
            let is_on = self.operation.starts
                && !off
                && !self.spindle.held
                && (speed_rev_per_min.is_some() || rotation.is_some());
            let spindle = self.spindle_state().filter(|_| is_on);
            self.push(at, ExpectedAction::Dwell { seconds, between: self.operation.starts, spindle });
        }
    }

    /// Whether an operation is in the program; `reached`: the one selected by name, or after it.
    fn is_selected(&self, number: u64, reached: bool) -> bool {
        match &self.policy.selection {
            None => true,
            Some(OperationSelection::Range(first, last)) => {
                let number = number.max(1);
                number >= *first && last.is_none_or(|last| number <= last)
            }
            Some(OperationSelection::From(_)) => reached,
        }
    }

    /// Whether a record is in the program. Records after the call of a tool belong to the operation that comes.
    #[inline(always)]
    fn is_selected_here(&self) -> bool {
        let OperationState { number, starts, called, reached, named, .. } = self.operation;
        self.is_selected(number + u64::from(starts && called), reached || starts && called && named)
    }

    #[inline(always)]
    fn push(&mut self, at: Location, action: ExpectedAction) {
        if !matches!(action, ExpectedAction::BlockSkip { .. }) {
            self.calls.before = None;
        }
        self.operation.stopped = false;
        let selected = self.is_selected_here();
        let waits = !selected
            && self.operation.starts
            && self.operation.called
            && matches!(self.policy.selection, Some(OperationSelection::From(_)));
        if selected || waits {
            let item = ExpectedItem {
                at,
                required: Rc::clone(&self.required),
                hole: self.holes.current.as_ref().map(|hole| self.at_feed(hole)),
                action,
            };
            if waits { self.queue.unnamed.push(item) } else { self.enqueue(item) }
        }
    }

    #[inline(always)]
    fn enqueue(&mut self, item: ExpectedItem) {
        let is_motion = matches!(item.action, ExpectedAction::Motion(_));
        self.queue.items.push(item);
        if !is_motion {
            self.queue.last_other = self.queue.items.count();
        }
    }
}

/// The fault that two rules of the same kind differ.
fn contradiction(location: Location, property: &str) -> Diagnostic {
    Diagnostic {
        code: config::OPERATION,
        severity: Severity::Error,
        location,
        length: 1,
        count: 1,
        text: format!("entries of `[operations]` have different values of `{property}` for this operation"),
        help: Some("give this operation an entry by its number".to_owned()),
    }
}

/// Letters and digits of a text in capitals: what is left of it in the characters of any control.
pub(crate) fn legible(text: &[u8]) -> Vec<u8> {
    let in_ascii = |letter: char| match letter {
        '°' => "DEG",
        'µ' | 'μ' => "U",
        'Ä' | 'ä' => "AE",
        'Ö' | 'ö' => "OE",
        'Ü' | 'ü' => "UE",
        other => deunicode::deunicode_char(other).unwrap_or_default(),
    };
    let text: String = String::from_utf8_lossy(text).chars().map(in_ascii).collect();
    text.bytes().filter(u8::is_ascii_alphanumeric).map(|byte| byte.to_ascii_uppercase()).collect()
}
