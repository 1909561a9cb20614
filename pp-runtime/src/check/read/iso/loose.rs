//! Words whose meaning the rest of their block decides, and what follows from the block as a whole.
//!
//! | word | beside | means |
//! |---|---|---|
//! | P, X | G4 | a dwell: seconds on LinuxCNC, milliseconds on Fanuc and Haas where P has no point |
//! | P | G54.1, G154 | number of the work offset |
//! | P, Q | G64, G61, G187, G5.1 | smoothing, which is the control's own |
//! | P | G43.4 on Fanuc | how the rotary axes move between two points |
//! | P | G2, G3 | turns of a helix, also L |
//! | I J K | G43.5 in force | the tool axis |
//! | K | G33.1 | pitch |
//! | X Y Z I J K Q | G68.2, G268 | a tilted plane |
//! | R, Q, P | a cycle in force | reference level, step, dwell |
//! | R | else | radius of an arc |

use super::super::Family;
use super::super::block::WorkOffset;
use super::super::draft::{Code, LengthCode, TiltCode};
use super::super::frames;
use super::super::text::{Number, whole};
use super::Reading;

/// Words of a block that wait for its end, and codes that take some of them.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Loose {
    pub(super) p: Option<Number>,
    pub(super) q: Option<Number>,
    pub(super) r: Option<Number>,
    pub(super) l: Option<Number>,
    pub(super) x: Option<Number>,
    pub(super) k: Option<Number>,
    /// The canned cycle that begins here, as its code.
    pub(super) cycle: Option<u32>,
    pub(super) plane: Option<Plane>,
    pub(super) dwell: bool,
    pub(super) offset_with_p: bool,
    pub(super) smoothing: bool,
}

/// How the words of a tilted plane count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Plane {
    /// G68.2.
    Euler,
    /// G268.
    Haas,
}

impl Reading<'_, '_> {
    /// Gives the loose words to what they belong to.
    pub(super) fn conclude(&mut self) {
        if self.iso.guards.open() && (self.line.draft.groups != 0 || self.line.draft.written != 0) {
            self.line.fault(0, "this block is executed only under a condition");
        }
        if self.loose.dwell {
            self.dwell();
        }
        if self.loose.offset_with_p {
            self.further_offset();
        }
        if self.loose.smoothing {
            (self.loose.p, self.loose.q) = (None, None);
        }
        self.tip_control();
        if self.line.draft.code == Some(Code::RigidTap) {
            self.line.draft.pitch = self.loose.k.map(|k| k.value);
            self.line.draft.centre_written = 0;
        }
        if let Some(plane) = self.loose.plane {
            self.tilted(plane);
        }
        self.cycle_words();
        self.arc_words();
        for (word, letter) in [(self.loose.p, 'P'), (self.loose.q, 'Q'), (self.loose.l, 'L')] {
            if word.is_some() {
                self.line.fault(0, format!("{letter} has no meaning in this block"));
            }
        }
        self.tool_words();
    }

    fn dwell(&mut self) {
        let word = self.loose.p.take().or(self.loose.x.take());
        self.line.draft.written = 0;
        self.line.draft.dwell = word.map(|word| self.seconds(word));
        if word.is_none() {
            self.line.fault(0, "dwell without its time");
        }
    }

    fn further_offset(&mut self) {
        match self.loose.p.take().and_then(whole) {
            Some(number) => self.line.draft.work_offset = Some(WorkOffset::Further(number)),
            None => self.line.fault(0, "work offset without its number"),
        }
    }

    /// G43.4 and its kin, and what I J K are while G43.5 is in force.
    fn tip_control(&mut self) {
        let draft = &mut *self.line.draft;
        match draft.length {
            Some(LengthCode::TipVector) => self.iso.vectors = true,
            Some(LengthCode::Off | LengthCode::On | LengthCode::TipControl) => self.iso.vectors = false,
            None => {}
        }
        let on = matches!(draft.length, Some(LengthCode::TipControl | LengthCode::TipVector));
        if self.iso.vectors && draft.centre_written != 0 {
            draft.vector = draft.centre;
            draft.vector_written = draft.centre_written;
            draft.centre_written = 0;
        }
        if on && self.line.family() == Family::Fanuc {
            // P1: the tool axis turns in a plane.
            let form = self.loose.p.take();
            self.line.draft.in_plane = match form.map(whole) {
                None | Some(Some(0)) => Some(false),
                Some(Some(1)) => Some(true),
                Some(_) => {
                    self.line.fault(0, "unknown form of tip control");
                    None
                }
            };
        }
    }

    /// G68.2 and G268: the words are those of the plane.
    fn tilted(&mut self, plane: Plane) {
        let draft = &mut *self.line.draft;
        let origin = self.line.machine.linear.map(|place| {
            place.filter(|index| draft.written & (1 << index) != 0).map_or(0.0, |index| draft.axes[index])
        });
        let order = self.loose.q.take().and_then(whole);
        let words = frames::EulerWords { angles: draft.centre, order };
        draft.written = 0;
        draft.centre_written = 0;
        let rotation = match plane {
            Plane::Euler => words.euler(),
            Plane::Haas => words.haas(),
        };
        match rotation {
            Some(rotation) => {
                draft.tilt = Some(TiltCode::On { rotation, origin: origin.into(), oriented: false });
            }
            None => self.line.fault(0, "unknown form of tilted plane"),
        }
    }

    /// R, and the turns of a helix.
    fn arc_words(&mut self) {
        if let Some(radius) = self.loose.r.take() {
            self.line.draft.radius = Some(self.length(radius, false));
        }
        if self.line.draft.centre_written != 0
            && let Some(turns) = self.loose.p.take().or(self.loose.l.take())
        {
            self.line.draft.turns = whole(turns).unwrap_or(1).saturating_sub(1);
        }
    }

    /// What a tool word needs beside it, and what may not stand there.
    fn tool_words(&mut self) {
        let (tool, change) = (self.line.draft.tool.is_some(), self.line.draft.change);
        if change && !tool && self.line.machine.state.selected.is_none() {
            self.line.fault(0, "tool change without a tool number");
        }
        if tool && !change && self.line.family() == Family::LinuxCnc && self.line.draft.written != 0 {
            self.line.fault(0, "tool call in a block with axis motion");
        }
    }
}
