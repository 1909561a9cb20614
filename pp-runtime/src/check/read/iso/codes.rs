//! What G and M codes mean on LinuxCNC, Fanuc and Haas.
//!
//! A block may hold one code of each modal group.

use super::super::Family;
use super::super::block::{FeedMode, Side, WorkOffset, WorkPlane, coolant};
use super::super::draft::{Code, LengthCode, TiltCode, group, set};
use super::super::text::{Number, shown, tenths, whole};
use super::Reading;
use super::loose::Plane;
use crate::program::Rotation;

impl Reading<'_, '_> {
    /// A G code, in tenths: 911 is G91.1.
    pub(super) fn g(&mut self, number: Number, column: usize) {
        let family = self.line.family();
        let (linuxcnc, fanuc, haas) = (family == Family::LinuxCnc, family == Family::Fanuc, family == Family::Haas);
        let (draft, loose) = (&mut *self.line.draft, &mut self.loose);
        let Some(code) = tenths(number) else { return self.line.unknown(column) };
        let group = match code {
            0 => set(&mut draft.code, Code::Rapid, group::MOTION),
            10 => set(&mut draft.code, Code::Feed, group::MOTION),
            20 => set(&mut draft.code, Code::Clockwise, group::MOTION),
            30 => set(&mut draft.code, Code::CounterClockwise, group::MOTION),
            331 if linuxcnc => set(&mut draft.code, Code::RigidTap, group::MOTION),
            800 => set(&mut draft.code, Code::None, group::MOTION),
            730 | 740 | 760 | 810..=890 if code % 10 == 0 => {
                loose.cycle = Some(code / 10);
                set(&mut draft.code, Code::Cycle, group::MOTION)
            }
            40 => flag(&mut loose.dwell, group::ALONE),
            280 | 300 => flag(&mut draft.reference, group::ALONE),
            530 => flag(&mut draft.machine, group::ALONE),
            170 => set(&mut draft.plane, WorkPlane::Xy, group::PLANE),
            180 => set(&mut draft.plane, WorkPlane::Zx, group::PLANE),
            190 => set(&mut draft.plane, WorkPlane::Yz, group::PLANE),
            200 => set(&mut draft.units, super::Units::Inches, group::UNITS),
            210 => set(&mut draft.units, super::Units::Millimetres, group::UNITS),
            400 => set(&mut draft.side, Side::None, group::SIDE),
            410 => set(&mut draft.side, Side::Left, group::SIDE),
            420 => set(&mut draft.side, Side::Right, group::SIDE),
            430 => set(&mut draft.length, LengthCode::On, group::LENGTH),
            434 if fanuc => set(&mut draft.length, LengthCode::TipControl, group::LENGTH),
            435 if fanuc => set(&mut draft.length, LengthCode::TipVector, group::LENGTH),
            2340 if haas => set(&mut draft.length, LengthCode::TipControl, group::LENGTH),
            490 => {
                draft.tip_control = draft.tip_control.or((!linuxcnc).then_some(false));
                set(&mut draft.length, LengthCode::Off, group::LENGTH)
            }
            682 if !haas => set(&mut loose.plane, Plane::Euler, group::TILT),
            2680 if haas => set(&mut loose.plane, Plane::Haas, group::TILT),
            531 if !haas => set(&mut draft.tilt, TiltCode::Orient, group::TILT),
            2530 if haas => set(&mut draft.tilt, TiltCode::Orient, group::TILT),
            690 | 2690 => set(&mut draft.tilt, TiltCode::Off, group::TILT),
            541 | 1540 if !linuxcnc => flag(&mut loose.offset_with_p, group::OFFSET),
            540 | 550 | 560 | 570 | 580 | 590 => set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET),
            591..=593 if linuxcnc => set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET),
            610 | 611 | 640 => flag(&mut loose.smoothing, group::PATH),
            50 | 51 | 80 | 1870 if !linuxcnc => flag(&mut loose.smoothing, group::PATH),
            900 => set(&mut draft.distances, false, group::DISTANCE),
            910 => set(&mut draft.distances, true, group::DISTANCE),
            901 | 911 if linuxcnc => {
                draft.centre_absolute = if code == 901 { 7 } else { 0 };
                group::CENTRE
            }
            930 => set(&mut draft.feed_mode, FeedMode::InverseTime, group::FEED),
            940 => set(&mut draft.feed_mode, FeedMode::PerMinute, group::FEED),
            950 => set(&mut draft.feed_mode, FeedMode::PerRevolution, group::FEED),
            980 => set(&mut draft.to_initial, true, group::RETURN),
            990 => set(&mut draft.to_initial, false, group::RETURN),
            _ => return self.line.unknown(column),
        };
        self.speaks_for(group, column);
    }

    /// An M code.
    pub(super) fn m(&mut self, number: Number, column: usize) {
        let family = self.line.family();
        let (linuxcnc, fanuc, haas) = (family == Family::LinuxCnc, family == Family::Fanuc, family == Family::Haas);
        let draft = &mut *self.line.draft;
        let group = match whole(number).unwrap_or(u32::MAX) {
            0 => set(&mut draft.stop, false, group::STOP),
            1 => set(&mut draft.stop, true, group::STOP),
            2 | 30 => flag(&mut draft.end, group::STOP),
            3 => set(&mut draft.spindle, Some(Rotation::Clockwise), group::SPINDLE),
            4 => set(&mut draft.spindle, Some(Rotation::CounterClockwise), group::SPINDLE),
            5 => set(&mut draft.spindle, None, group::SPINDLE),
            6 => flag(&mut draft.change, group::FREE),
            7 if !haas => switch(&mut draft.coolant_on, coolant::MIST),
            8 => switch(&mut draft.coolant_on, coolant::FLOOD),
            9 => switch(&mut draft.coolant_off, coolant::FLOOD | coolant::MIST),
            88 if haas => switch(&mut draft.coolant_on, coolant::THROUGH),
            89 if haas => switch(&mut draft.coolant_off, coolant::THROUGH),
            code @ (13 | 14) if fanuc => {
                draft.coolant_on |= coolant::FLOOD;
                let turning = if code == 13 { Rotation::Clockwise } else { Rotation::CounterClockwise };
                set(&mut draft.spindle, Some(turning), group::SPINDLE)
            }
            // The thread that follows is in step with the spindle.
            29 if fanuc => group::FREE,
            428 if linuxcnc => set(&mut draft.tip_control, true, group::TILT),
            429 if linuxcnc => set(&mut draft.tip_control, false, group::TILT),
            _ => return self.line.unknown(column),
        };
        self.speaks_for(group, column);
    }

    /// Notes that a group has spoken, and says so if it has before.
    fn speaks_for(&mut self, group: u32, column: usize) {
        let first = self.line.draft.group(group);
        if !first && group != group::FREE && group != group::COOLANT {
            let text = shown(self.line.read_from(column));
            self.line.fault(column, format!("`{text}` together with another code of its group"));
        }
    }
}

fn flag(place: &mut bool, group: u32) -> u32 {
    *place = true;
    group
}

fn switch(bits: &mut u8, bit: u8) -> u32 {
    *bits |= bit;
    group::COOLANT
}
