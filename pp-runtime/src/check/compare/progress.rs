//! The place of a program in its CL data.

use std::cmp::Ordering;
use std::io;
use std::rc::Rc;

use super::super::expect::{ClMotion, Expect, ExpectedAction, ExpectedItem, ExpectedMessage, Required, SpindleState};
use super::super::geometry::{PathShape, Segment, ToolPose, angle_between};
use super::super::rules::{Arrival, Rules};
use crate::check::tolerances::{ON_LINE, SAME_AXIS};
use crate::diag::Diagnostic;
use crate::program::Location;

/// The place of a program in its CL data: the next item, and how much of it is done.
#[derive(Clone)]
pub(super) struct ClProgress<'a> {
    expect: Expect<'a>,
    /// End of the last motion of the CL data, or the approach point.
    reached: Option<ToolPose>,
    /// Share of the next motion that is done.
    along: f64,
    /// Record and state of the last motion.
    last: Option<(Location, Rc<Required>)>,
    /// The last block carried out nothing: the start of the next one is not judged.
    lost: bool,
    /// The approach to the next motion is done.
    approached: bool,
    /// The last hole that a cycle has made.
    made: Option<u64>,
}

impl<'a> ClProgress<'a> {
    pub(super) fn new(expect: Expect<'a>) -> Self {
        Self { expect, reached: None, along: 0.0, last: None, lost: false, approached: false, made: None }
    }

    /// Reads until `count` items are known.
    pub(super) fn fill(&mut self, count: usize) -> io::Result<()> {
        self.expect.fill(count)
    }

    /// The next item.
    pub(super) fn next(&self) -> Option<&ExpectedItem> {
        self.expect.get(0)
    }

    /// An item ahead, 0 the next.
    pub(super) fn get(&self, index: usize) -> Option<&ExpectedItem> {
        self.expect.get(index)
    }

    /// Whether there may be others than motions among the items that are known.
    pub(super) fn has_records_ahead(&self) -> bool {
        self.expect.has_others()
    }

    /// Position of the first item ahead that suits.
    pub(super) fn find(&mut self, suits: impl FnMut(&ExpectedItem) -> bool) -> io::Result<Option<usize>> {
        Ok(self.expect.ahead()?.iter().position(suits))
    }

    /// The next item, if it is a motion.
    pub(super) fn motion(&self) -> Option<&ClMotion> {
        self.next()?.motion()
    }

    /// Record of the next item, or of the last motion.
    pub(super) fn location(&self) -> Location {
        let next = self.next().map(|item| item.at);
        next.or(self.last.as_ref().map(|(at, _)| *at)).unwrap_or_default()
    }

    /// Number of the operation of the next item, or of the last motion; 0 before the first.
    pub(super) fn operation(&self) -> u64 {
        let next = self.next().map(|item| item.required.operation);
        next.or(self.last().map(|required| required.operation)).unwrap_or_default()
    }

    /// Material that the operation of the next item, or of the last motion, leaves on the design, mm.
    pub(super) fn allowance_mm(&self) -> f64 {
        let next = self.next().map(|item| item.required.allowance_mm);
        next.or(self.last().map(|required| required.allowance_mm)).unwrap_or_default()
    }

    /// State of the last motion.
    pub(super) fn last(&self) -> Option<&Required> {
        self.last.as_ref().map(|(_, required)| &**required)
    }

    pub(super) fn along(&self) -> f64 {
        self.along
    }

    pub(super) fn is_lost(&self) -> bool {
        self.lost
    }

    pub(super) fn is_approached(&self) -> bool {
        self.approached
    }

    /// A line displays this text, letters and digits only; false if the CL data has another one here.
    pub(super) fn displays(&mut self, text: &[u8]) -> bool {
        let Some(message) = self.expect.next_message() else { return false };
        let Some(rest) = message.text.strip_prefix(text).map(<[u8]>::to_vec) else { return false };
        if rest.is_empty() || message.may_be_cut {
            self.expect.pop_message();
        } else {
            message.text = rest;
        }
        true
    }

    /// A text that should have been displayed before now; `all`: at any time.
    pub(super) fn overdue_message(&mut self, all: bool) -> Option<ExpectedMessage> {
        if all { self.expect.pop_message() } else { self.expect.overdue_message() }
    }

    /// Whether the CL data has an error so far.
    pub(super) fn failed(&self) -> bool {
        self.expect.failed()
    }

    /// First error of the CL data.
    pub(super) fn fault(&self) -> Option<Diagnostic> {
        self.expect.fault()
    }

    /// The tool that the CL data has called last in the selected operations.
    pub(super) fn last_tool(&self) -> Option<u32> {
        self.expect.last_tool()
    }

    /// Spindle state that another SPINDL before the last one requests.
    pub(super) fn requested_before(&self) -> Option<SpindleState> {
        self.expect.requested_before()
    }

    /// Spindle state that the last SPINDL before the next item requests.
    pub(super) fn requested_spindle(&self) -> Option<Option<SpindleState>> {
        self.expect.requested_spindle()
    }

    /// The next motion from the end of the last one; `here`: where the tool is.
    pub(super) fn segment(&self, motion: &ClMotion, here: Option<&ToolPose>, end: &ToolPose) -> Segment {
        Segment { from: *self.reached.as_ref().or(here).unwrap_or(end), to: motion.to, shape: motion.shape.clone() }
    }

    /// Where a block begins on the next motion.
    pub(super) fn arrival<'h>(&self, here: Option<&'h ToolPose>, chords: f64) -> Arrival<'h> {
        Arrival { along: self.along, here, chords }
    }

    /// Position of the tool on the path of the CL data.
    pub(super) fn on_path(&self, here: &ToolPose) -> ToolPose {
        match self.motion() {
            Some(motion) => self.segment(motion, Some(here), here).at(self.along),
            None => self.reached.unwrap_or(*here),
        }
    }

    /// Whether the next motion repeats the point and the tool axis of the last one.
    pub(super) fn repeats(&self) -> bool {
        let (Some(from), Some(item)) = (&self.reached, self.next()) else { return false };
        let ExpectedItem { action: ExpectedAction::Motion(motion), hole: None, .. } = item else { return false };
        let begins = || self.along <= 0.0 && !self.approached && !motion.rapid && !motion.starts;
        // A full circle ends where it began, too.
        let length = || Segment { from: *from, to: motion.to, shape: motion.shape.clone() }.length();
        *from == motion.to && begins() && length() <= 0.0
    }

    /// Whether the next item is a motion away from where the tool is, which needs its block.
    pub(super) fn leads_away(&self, rules: &Rules<'_>, here: Option<&ToolPose>, chords: f64) -> bool {
        let (Some(motion), Some(here)) = (self.motion(), here) else { return false };
        !rules.may_need_no_block(here, &motion.to, chords)
    }

    /// Whether an item ahead needs no block.
    pub(super) fn is_needless(&self, index: usize, rules: &Rules<'_>, here: Option<&ToolPose>, chords: f64) -> bool {
        let (Some(motion), Some(here)) = (self.get(index).and_then(ExpectedItem::motion), here) else { return false };
        !motion.starts && rules.may_need_no_block(here, &motion.to, chords) && {
            let segment = Segment { from: *here, to: motion.to, shape: motion.shape.clone() };
            rules.needs_no_block(&segment, Some(here), chords)
        }
    }

    /// Whether the next motion is a cut that continues where the tool is.
    pub(super) fn continues_cut(&self) -> bool {
        self.motion().is_some_and(|motion| !motion.rapid && !motion.starts)
    }

    /// The next item is done.
    pub(super) fn pass(&mut self) {
        if let Some(item) = self.expect.pop() {
            self.last = Some((item.at, item.required));
            if let ExpectedAction::Motion(motion) = &item.action {
                self.reached = Some(motion.to);
            }
        }
        self.along = 0.0;
        self.approached = false;
    }

    /// Takes the next item, which is no motion.
    pub(super) fn take(&mut self) {
        self.expect.pop();
    }

    /// A block has carried out the next motion up to a share. `at`, `required`: its record and state.
    pub(super) fn advance(&mut self, at: Location, required: Rc<Required>, share: f64) {
        self.along = share;
        self.last = Some((at, required));
    }

    /// Part of a rapid is done: its rest begins where the tool is.
    pub(super) fn begin_at(&mut self, pose: ToolPose) {
        self.reached = Some(pose);
    }

    /// The approach to the next motion ends here.
    pub(super) fn approach(&mut self, above: ToolPose) {
        self.approached = true;
        self.reached = Some(above);
        self.lost = false;
    }

    /// A cycle makes a hole.
    pub(super) fn make(&mut self, hole: u64) {
        self.made = Some(hole);
    }

    /// Whether the last cycle has made a hole.
    pub(super) fn is_made(&self, hole: u64) -> bool {
        self.made == Some(hole)
    }

    /// Begins the next motion anew.
    pub(super) fn restart_motion(&mut self) {
        self.along = 0.0;
    }

    pub(super) fn set_lost(&mut self, lost: bool) {
        self.lost = lost;
    }

    /// The position of the machine is unknown.
    pub(super) fn forget_position(&mut self) {
        self.reached = None;
    }

    /// Passes items for which the program has no block. Returns the text of a finding, and the record that it is about.
    pub(super) fn skip(&mut self, count: usize, needless: impl Fn(&Self, usize) -> bool) -> Option<(Location, String)> {
        let asked = (0..count).filter(|index| !needless(self, *index));
        let mut records = asked.filter_map(|index| self.get(index)).map(|item| item.at);
        let found = records.next().map(|first| {
            let last = records.next_back().unwrap_or(first);
            let which = match last.line.cmp(&first.line) {
                Ordering::Equal => format!("CL line {} has", first.line),
                Ordering::Greater => format!("CL lines {} to {} have", first.line, last.line),
                // The records of a subprogram are where it is defined.
                Ordering::Less => format!("CL line {} and the subprogram that it calls have", first.line),
            };
            (first, format!("{which} no block before this one: missing or out of order"))
        });
        (0..count).for_each(|_| self.pass());
        found
    }

    /// Point of the approach to a motion ahead: above it by the approach distance, or the point itself where the next
    /// motion leads straight down from it. A hole counts as one motion, to its clearance level; the approach to a hole
    /// itself ends above it.
    pub(super) fn approach_point(&self, index: usize, first: &ClMotion, approach_mm: f64) -> ToolPose {
        let hole = self.get(index).and_then(|item| item.hole.as_ref());
        if let Some(above) =
            hole.filter(|_| first.rapid).and_then(|expected| expected.approach_point(&first.to, approach_mm))
        {
            return above;
        }
        let next = (index + 1..).map_while(|index| self.get(index)).find_map(|item| match &item.action {
            ExpectedAction::Motion(motion) if motion.starts => Some(None),
            ExpectedAction::Motion(motion) => Some(match (&item.hole, hole) {
                (Some(next), first) if first.is_none_or(|first| first.number != next.number) => {
                    Some(next.clearance_point())
                }
                _ => matches!(motion.shape, PathShape::Line).then_some(motion.to),
            }),
            ExpectedAction::Dwell { .. } => None,
            _ => Some(None),
        });
        let below = next.flatten().is_some_and(|next| {
            let step = next.tip - first.to.tip;
            let along = step.dot(&first.to.axis);
            let across = (step - first.to.axis * along).norm();
            along < 0.0 && across <= ON_LINE && (next.axis - first.to.axis).norm() <= SAME_AXIS
        });
        if first.rapid && below {
            return first.to;
        }
        ToolPose { tip: first.to.tip + first.to.axis * approach_mm, axis: first.to.axis }
    }

    /// Why a block that ends at `end` is not the next item.
    pub(super) fn mismatch(&self, rules: &Rules<'_>, here: Option<&ToolPose>, end: &ToolPose) -> String {
        match self.next().map(|item| &item.action) {
            Some(ExpectedAction::Motion(motion)) => {
                let off = self.segment(motion, here, end).distance(end, self.along);
                let angle = angle_between(&end.axis, &motion.to.axis);
                match off <= rules.rounding().tip_mm && angle <= rules.rounding().axis_rad {
                    true => "this block ends on the next motion of the CL data but does not follow it: wrong path, or \
                             rapid instead of feed"
                        .to_owned(),
                    false => format!(
                        "this block matches no motion of the CL data: it ends {} from the path of the next motion, its tool \
                         axis {:.4}° off",
                        rules.units().deviation(off),
                        angle.to_degrees()
                    ),
                }
            }
            Some(ExpectedAction::Stop { .. }) => {
                "the stop (STOP or OPSTOP) of the CL data is not in the program before this block".to_owned()
            }
            Some(ExpectedAction::BlockSkip { on: true }) => {
                "OPSKIP/ON of the CL data: this block must be one that may be skipped (`/`)".to_owned()
            }
            Some(ExpectedAction::BlockSkip { on: false }) => {
                "OPSKIP/OFF of the CL data: this block must be one that is always executed, without `/`".to_owned()
            }
            Some(ExpectedAction::Raw(_)) => "the text of INSERT is not in the program before this block".to_owned(),
            Some(ExpectedAction::Probe { text, .. }) => {
                format!("`{}` of `cycles.probe` is missing before this block", String::from_utf8_lossy(text))
            }
            Some(ExpectedAction::Home { .. }) => {
                "the retract of GOHOME is not in the program before this block".to_owned()
            }
            Some(ExpectedAction::Dwell { .. }) | None => "this block matches no motion of the CL data".to_owned(),
        }
    }
}
