//! The mode of each stretch: axis positions, tip control or a tilted plane.
//!
//! Mode `auto` chooses in the first pass, by the feed motions and holes of a stretch; rapids do not decide.
//!
//! | the tool axis | mode |
//! |---|---|
//! | rotates at feed | tip control |
//! | is held, in an operation in which it rotates elsewhere | tip control; holes: plane |
//! | is held, in an operation with holes, arcs or CUTCOM, or with few tool axes | plane |
//! | is held, in an operation with more tool axes than `auto_planes` | tip control |
//!
//! An operation may have a mode of its own in the configuration; then nothing is chosen for it.
//!
//! Where control or machine have no tip control or no planes, the words are axis positions. No plane is called that is
//! not tilted while the rotary axes are at zero, so a vertical operation has no code of a frame.

use nalgebra::UnitVector3;

use crate::motion::geometry::angle_between;
use crate::motion::place::UsableModes;
use crate::motion::policy::Policy;
use crate::motion::source::{Begins, ItemAction, MotionIndex, ProgramItem};
use crate::options::{Mode, StretchMode};
use crate::program::{CutterSide, Event, MachineFunction};
use crate::tolerance::writer::HELD_AXIS;

/// The mode of each stretch of a program, in its order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct StretchModes {
    runs: Vec<Run>,
}

/// Stretches of one kind, one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Run {
    /// Number of the first one.
    first: u64,
    kind: StretchKind,
}

/// Kind of a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct StretchKind {
    mode: StretchMode,
    /// The tool axis rotates at feed; of rapids only, in the next stretch that cuts.
    rotates: bool,
}

impl StretchModes {
    /// One mode for the whole program, in which no tool axis is known to rotate.
    #[must_use]
    pub fn all(mode: StretchMode) -> Self {
        Self { runs: vec![Run { first: 0, kind: StretchKind { mode, rotates: false } }] }
    }

    /// Whether a stretch has this mode.
    #[must_use]
    pub fn has(&self, mode: StretchMode) -> bool {
        self.runs.iter().any(|run| run.kind.mode == mode)
    }

    /// The modes that stretches have.
    pub(crate) fn used(&self) -> impl Iterator<Item = StretchMode> {
        [StretchMode::Axes, StretchMode::Plane, StretchMode::Tcp].into_iter().filter(|mode| self.has(*mode))
    }

    /// Adds a stretch, or several of one kind.
    fn add(&mut self, first: u64, kind: StretchKind) {
        if self.runs.last().is_none_or(|last| last.kind != kind) {
            self.runs.push(Run { first, kind });
        }
    }
}

/// Follows the modes while the program is planned.
#[derive(Debug, Clone)]
pub(crate) struct ModeFollower {
    modes: StretchModes,
    /// Run of the present stretch.
    run: usize,
    /// First stretch of the next run.
    next: u64,
    /// Number of the present stretch.
    stretch: u64,
    /// In the stretch before it the tool axis rotates at feed.
    rotated_before: bool,
    /// Mode in which the machine is.
    entered: StretchMode,
}

impl ModeFollower {
    pub(crate) fn new(modes: StretchModes) -> Self {
        let mut follower =
            Self { entered: StretchMode::Axes, run: 0, next: 0, stretch: 0, rotated_before: false, modes };
        follower.entered = follower.mode();
        follower.next = follower.first_of(1);
        follower
    }

    fn first_of(&self, run: usize) -> u64 {
        self.modes.runs.get(run).map_or(u64::MAX, |run| run.first)
    }

    fn mode(&self) -> StretchMode {
        self.modes.runs.get(self.run).map_or(StretchMode::Axes, |run| run.kind.mode)
    }

    fn rotates(&self) -> bool {
        self.modes.runs.get(self.run).is_some_and(|run| run.kind.rotates)
    }

    /// Whether the tool axis rotates at feed in the present stretch and in the one before it.
    pub(crate) fn keeps_rotating(&self) -> bool {
        self.rotated_before && self.rotates()
    }

    /// The modes of all stretches.
    pub(crate) fn modes(&self) -> &StretchModes {
        &self.modes
    }

    /// A stretch begins, or goes on.
    #[inline]
    pub(crate) fn reach(&mut self, stretch: u64) {
        if stretch == self.stretch {
            return;
        }
        (self.rotated_before, self.stretch) = (self.rotates(), stretch);
        while stretch >= self.next {
            self.run += 1;
            self.next = self.first_of(self.run + 1);
        }
    }

    /// Whether the stretch has another mode than the one in which the machine is.
    #[inline]
    pub(crate) fn changes(&self) -> bool {
        self.mode() != self.entered
    }

    /// The machine enters the mode of the stretch.
    pub(crate) fn enter(&mut self) -> StretchMode {
        self.entered = self.mode();
        self.entered
    }
}

/// Content of a stretch, which decides its mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Content {
    /// Rapids only.
    Rapids,
    /// Feed motions with one tool axis.
    Held,
    /// Holes.
    Holes,
    /// The tool axis rotates at feed.
    Rotating,
}

/// Chooses the modes in the first pass.
#[derive(Debug)]
pub(crate) struct ModeFinder {
    modes: StretchModes,
    /// Modes that mode `auto` chooses from.
    usable: UsableModes,
    /// Mode of operations without one of their own.
    usual: Mode,
    /// Mode of the operation that comes.
    mode_ahead: Mode,
    most_planes: usize,
    operation: OperationContent,
    /// The present stretch.
    stretch: StretchContent,
    /// Cutter compensation is requested for the operation that comes.
    compensation_ahead: bool,
}

/// A stretch and its content.
#[derive(Debug, Clone, Copy)]
struct StretchContent {
    /// Number of the stretch.
    number: u64,
    content: Content,
}

/// Content of the present operation.
#[derive(Debug, Default)]
struct OperationContent {
    /// The mode that is set for it; `None`: its content decides.
    mode: Option<StretchMode>,
    /// First stretch of each run of stretches of the same content.
    runs: Vec<StretchContent>,
    /// It has holes, arcs or cutter compensation.
    needs_plane: bool,
    /// Tool axes of the stretches in which they are held; one more than decides is enough.
    directions: Vec<UnitVector3<f64>>,
}

impl OperationContent {
    fn add(&mut self, stretch: StretchContent) {
        if self.runs.last().is_none_or(|last| last.content != stretch.content) {
            self.runs.push(stretch);
        }
    }

    fn has(&self, content: Content) -> bool {
        self.runs.iter().any(|of| of.content == content)
    }

    /// Notes the tool axis of a cut.
    #[inline(always)]
    fn note_direction(&mut self, axis: &UnitVector3<f64>, most: usize) {
        if self.directions.len() <= most {
            self.add_direction(axis);
        }
    }

    fn add_direction(&mut self, axis: &UnitVector3<f64>) {
        let known = |other: &UnitVector3<f64>| other == axis || angle_between(axis, other) <= HELD_AXIS;
        if !self.directions.iter().any(known) {
            self.directions.push(*axis);
        }
    }
}

/// Modes of the contents of one operation.
#[derive(Debug, Clone, Copy)]
struct ModesOfContents {
    rotating: StretchMode,
    held: StretchMode,
    /// Holes, and an operation without cuts.
    holes: StretchMode,
}

impl ModesOfContents {
    fn of(self, content: Content) -> StretchMode {
        match content {
            Content::Rotating => self.rotating,
            Content::Held => self.held,
            Content::Holes | Content::Rapids => self.holes,
        }
    }

    fn chosen(operation: &OperationContent, usable: &UsableModes, most_planes: usize) -> Self {
        if let Some(mode) = operation.mode {
            return Self { rotating: mode, held: mode, holes: mode };
        }
        let or_axes = |usable: bool, mode: StretchMode| if usable { mode } else { StretchMode::Axes };
        let (tip, plane) = (or_axes(usable.tip, StretchMode::Tcp), or_axes(usable.plane, StretchMode::Plane));
        let few = operation.needs_plane || operation.directions.len() <= most_planes;
        let in_plane = !operation.has(Content::Rotating) && (few || !usable.tip);
        Self { rotating: tip, held: if in_plane { plane } else { tip }, holes: plane }
    }
}

impl ModeFinder {
    /// Chooses among the usable modes, unless the policy has one mode for all stretches. An operation may have its own.
    #[must_use]
    pub(crate) fn new(policy: Policy<'_>, usable: &UsableModes) -> Self {
        Self {
            modes: StretchModes::default(),
            usable: usable.clone(),
            usual: policy.options.mode,
            mode_ahead: policy.options.mode,
            most_planes: policy.options.auto_planes as usize,
            operation: OperationContent::default(),
            stretch: StretchContent { number: 0, content: Content::Rapids },
            compensation_ahead: false,
        }
    }

    /// Takes the next item.
    #[inline(always)]
    pub(crate) fn follow(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { motion, index, .. } => {
                self.begin(index);
                if !motion.rapid {
                    self.cut(&motion.pose.axis, if index.rotates_axis { Content::Rotating } else { Content::Held });
                }
            }
            _ => self.follow_other(item),
        }
    }

    /// Takes an item that is no straight motion.
    fn follow_other(&mut self, item: &ProgramItem<'_>) {
        match item.action {
            ItemAction::Line { .. } => {}
            ItemAction::Arc { arc, index } => {
                self.begin(index);
                self.cut(&arc.end.axis, Content::Held);
                self.operation.needs_plane = true;
            }
            ItemAction::Hole { hole, index } => {
                self.begin(index);
                self.cut(&hole.top.axis, Content::Holes);
                self.operation.needs_plane = true;
            }
            ItemAction::Operation(start) => {
                self.mode_ahead = start.chosen.mode.map_or(self.usual, |mode| mode.value);
            }
            ItemAction::Record { event: Event::Function(MachineFunction::Compensation(compensation)), between } => {
                let on = compensation.side != CutterSide::Off;
                self.operation.needs_plane |= on && !between;
                self.compensation_ahead |= on && between;
            }
            ItemAction::Record { .. } => {}
        }
    }

    /// Notes the begin of a motion, which may be the first of a stretch or of an operation.
    #[inline(always)]
    fn begin(&mut self, index: MotionIndex) {
        if index.stretch != self.stretch.number {
            self.begin_stretch(index);
        }
    }

    fn begin_stretch(&mut self, index: MotionIndex) {
        let begun = StretchContent { number: index.stretch, content: Content::Rapids };
        let ended = std::mem::replace(&mut self.stretch, begun);
        if ended.number > 0 {
            self.operation.add(ended);
        }
        if index.begins != Begins::Nothing {
            self.end_operation();
            self.operation.needs_plane = std::mem::take(&mut self.compensation_ahead);
            self.operation.mode = self.mode_ahead.of_all();
        }
    }

    #[inline(always)]
    fn cut(&mut self, axis: &UnitVector3<f64>, content: Content) {
        self.stretch.content = match (self.stretch.content, content) {
            (Content::Rotating, _) => Content::Rotating,
            (_, content) => content,
        };
        self.operation.note_direction(axis, self.most_planes);
    }

    /// Chooses the modes of the stretches of the operation that has ended.
    fn end_operation(&mut self) {
        let operation = std::mem::take(&mut self.operation);
        let modes = ModesOfContents::chosen(&operation, &self.usable, self.most_planes);
        let kind = |content: Content| {
            (content != Content::Rapids)
                .then(|| StretchKind { mode: modes.of(content), rotates: content == Content::Rotating })
        };
        // Rapids are of the kind of the cuts after them, or else of those before.
        let without_cuts = StretchKind { mode: modes.of(Content::Rapids), rotates: false };
        let last = operation.runs.iter().rev().find_map(|of| kind(of.content)).unwrap_or(without_cuts);
        for (index, first) in operation.runs.iter().enumerate() {
            let chosen = operation.runs[index..].iter().find_map(|of| kind(of.content)).unwrap_or(last);
            self.modes.add(first.number, chosen);
        }
    }

    /// The modes of all stretches.
    #[must_use]
    pub(crate) fn finish(mut self) -> StretchModes {
        self.operation.add(self.stretch);
        self.end_operation();
        self.modes
    }
}
