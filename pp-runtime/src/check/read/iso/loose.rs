//! Words whose meaning the rest of their block decides, and what follows from the block as a whole.
//!
//! | word | beside | means |
//! |---|---|---|
//! | P, X | G4 | a dwell: seconds on LinuxCNC, milliseconds on Fanuc and Haas where it has no point |
//! | P | G54.1, G154 | number of the work offset |
//! | P, Q | G64 on LinuxCNC | largest deviation from the path, and that up to which blocks are joined |
//! | Q, R | G5.1 | smoothing on or off, and its level |
//! | P, E | G187 | level and tolerance of the smoothing |
//! | P | G43.4 on Fanuc | how the rotary axes move between two points |
//! | P | G2, G3 on LinuxCNC | revolutions of a helix |
//! | I J K | G43.5 in force | the tool axis |
//! | K | G33.1 | pitch |
//! | X Y Z I J K Q | G68.2, G268 | a tilted plane |
//! | R, Q, P | a cycle in force | reference level, step, dwell |
//! | R | G2, G3 | radius of an arc |

use super::super::block::{PathMode, Smoothing, WorkOffset};
use super::super::draft::{Code, LengthCode, TiltCode};
use super::super::frames;
use super::super::language::{PathCode, Plane, Smoother, letters};
use super::super::text::{Number, whole};
use super::{ALWAYS, Reading};

/// Words of a block that wait for its end.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Loose {
    pub(crate) p: Option<Number>,
    pub(crate) q: Option<Number>,
    pub(crate) r: Option<Number>,
    pub(crate) e: Option<Number>,
    pub(crate) x: Option<Number>,
    pub(crate) k: Option<Number>,
}

impl Reading<'_, '_> {
    /// Gives the loose words to what they belong to.
    pub(super) fn conclude(&mut self) {
        self.modal();
        self.line.account(ALWAYS, self.iso.modal | if self.iso.vectors { letters("IJK") } else { 0 });
        self.line.contradictions();
        if self.line.draft.dwells {
            self.dwell();
        }
        if self.line.draft.offset_with_p {
            self.further_offset();
        }
        if let Some(path) = self.line.draft.path {
            self.path(path);
        }
        if let Some(smoother) = self.line.draft.smooths {
            self.smooth(smoother);
        }
        self.tip_control();
        if self.line.draft.code == Some(Code::RigidTap) {
            self.line.draft.pitch = self.loose.k.map(|k| k.value);
            self.line.draft.centre_written &= 3;
        }
        if let Some(plane) = self.line.draft.plane_form {
            self.tilted(plane);
        }
        self.cycle_words();
        self.arc_words();
        self.tool_words();
    }

    /// What the motion code of the block takes stays in force with it.
    fn modal(&mut self) {
        let draft = &*self.line.draft;
        match draft.code {
            Some(Code::Cycle | Code::Clockwise | Code::CounterClockwise) => {
                self.iso.modal = draft.takes & letters("IJKPQR");
            }
            Some(_) => self.iso.modal = 0,
            None => {}
        }
        match draft.length {
            Some(LengthCode::TipVector) => self.iso.vectors = true,
            Some(LengthCode::Off | LengthCode::On | LengthCode::TipControl) => self.iso.vectors = false,
            None => {}
        }
        let moves = draft.written != 0 && !draft.machine && !draft.reference;
        if matches!(draft.code, Some(code) if code != Code::Cycle)
            || (moves && draft.hole.is_none() && self.iso.cycle.is_off())
        {
            self.iso.rigid = false;
        }
        self.iso.rigid |= draft.rigid;
    }

    fn dwell(&mut self) {
        let word = match self.loose.p.take() {
            Some(word) => Some(self.wait(word)),
            None if self.line.draft.takes & letters("X") != 0 => self.loose.x.take().map(|word| self.seconds(word)),
            None => None,
        };
        if word.is_none() {
            self.line.fault(0, "dwell without its time");
        } else if self.loose.x.is_none() {
            // X has been the time.
            let x = self.line.machine().linear()[0].map_or(0, |index| 1 << index);
            self.line.draft.written &= !x;
        }
        self.line.draft.dwell = Some(word.unwrap_or_default());
    }

    fn further_offset(&mut self) {
        match self.loose.p.take().and_then(whole) {
            Some(number) => self.line.draft.work_offset = Some(WorkOffset::Further(number)),
            None => self.line.fault(0, "work offset without its number"),
        }
    }

    fn path(&mut self, path: PathCode) {
        let unit = self.line.unit();
        let [tolerance_mm, joining_mm] = if path == PathCode::Continuous && self.line.draft.takes & letters("Q") != 0 {
            [self.loose.p.take(), self.loose.q.take()].map(|word| word.map(|word| word.value * unit))
        } else {
            [None; 2]
        };
        self.line.draft.path_mode = Some(match path {
            PathCode::ExactPath => PathMode::ExactPath,
            PathCode::ExactStop | PathCode::Window => PathMode::ExactStop,
            PathCode::Continuous => PathMode::Continuous { tolerance_mm, joining_mm },
            PathCode::Smoothed(code) => PathMode::Smoothed(code),
        });
    }

    fn smooth(&mut self, smoother: Smoother) {
        let smoothing = match smoother {
            Smoother::Contour => match self.loose.q.take().and_then(whole) {
                Some(0) => Some(Smoothing::Off),
                Some(1) => {
                    let level = self.loose.r.take().map(|word| whole(word).filter(|level| (1..=10).contains(level)));
                    let known = level.is_none_or(|level| level.is_some());
                    let level = level.flatten().map(|level| level as u8);
                    known.then_some(Smoothing::On { tolerance_mm: None, level })
                }
                _ => None,
            },
            Smoother::Level => {
                let level = self.loose.p.take().map(|word| whole(word).filter(|level| (1..=3).contains(level)));
                let tolerance = self.loose.e.take().map(|word| self.length(word, false) * self.line.unit());
                match (level, tolerance) {
                    (None, None) => Some(Smoothing::Off),
                    (Some(None), _) => None,
                    (level, tolerance_mm) => {
                        Some(Smoothing::On { tolerance_mm, level: level.flatten().map(|level| level as u8) })
                    }
                }
            }
        };
        match smoothing {
            Some(smoothing) => self.line.draft.smoothing = Some(smoothing),
            None => self.line.fault(0, "unknown form of smoothing"),
        }
    }

    /// G43.4 and its kin, and what I J K are while G43.5 is in force.
    fn tip_control(&mut self) {
        let draft = &mut *self.line.draft;
        let on = matches!(draft.length, Some(LengthCode::TipControl | LengthCode::TipVector));
        let straight =
            !matches!(draft.code, Some(Code::Clockwise | Code::CounterClockwise)) && draft.plane_form.is_none();
        if self.iso.vectors && straight && draft.centre_written != 0 {
            draft.vector = draft.centre;
            draft.vector_written = draft.centre_written;
            draft.centre_written = 0;
        }
        if on && self.line.facts().tip_control_has_form {
            // P1: the tool axis rotates in a plane. Without P a parameter decides: A-79294E, p. 11.
            let form = self.loose.p.take();
            self.line.draft.in_plane = match form.map(whole) {
                None => None,
                Some(Some(0)) => Some(false),
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
        let linear = self.line.machine().linear();
        let draft = &mut *self.line.draft;
        let origin = linear.map(|place| {
            place.filter(|index| draft.written & (1 << index) != 0).map_or(0.0, |index| draft.axes[index])
        });
        let others = linear.iter().flatten().fold(draft.written, |bits, index| bits & !(1 << index));
        let all = draft.centre_written == 7;
        let order = self.loose.q.take().and_then(whole);
        let words = frames::EulerWords { angles: draft.centre, order };
        draft.written = 0;
        draft.centre_written = 0;
        let rotation = match plane {
            Plane::Euler => words.euler(),
            Plane::Haas => words.haas(),
        };
        match rotation.filter(|_| others == 0 && all) {
            Some(rotation) => {
                let (pose, rotates_table, oriented) = (None, false, false);
                draft.tilt = Some(TiltCode::On { rotation, origin: origin.into(), oriented, pose, rotates_table });
            }
            None => self.line.fault(0, "unknown form of tilted plane"),
        }
    }

    /// R, and the revolutions of a helix.
    fn arc_words(&mut self) {
        if let Some(radius) = self.loose.r.take() {
            self.line.draft.radius = Some(self.length(radius, false));
        }
        if self.line.draft.takes & letters("P") == 0 && self.iso.modal & letters("P") == 0 {
            return;
        }
        if let Some(turns) = self.loose.p.take() {
            match whole(turns) {
                Some(turns @ 1..) => self.line.draft.turns = turns - 1,
                _ => self.line.fault(0, "revolutions of a helix that are no whole number above 0"),
            }
        }
    }

    /// What a tool word needs beside it, and what may not stand there.
    fn tool_words(&mut self) {
        let (tool, change) = (self.line.draft.tool.is_some(), self.line.draft.change);
        if change && !tool && self.line.machine().state().selected.is_none() {
            self.line.fault(0, "tool change without a tool number: no T has been programmed");
        }
        if tool && !change && self.line.facts().tool_call_alone && self.line.draft.written != 0 {
            self.line.fault(0, "tool call in a block with axis motion");
        }
    }
}
