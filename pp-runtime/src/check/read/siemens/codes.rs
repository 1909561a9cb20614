//! What G and M codes mean on a Siemens control; `false` for those that are not known.
//!
//! A block may hold one code of each group.

use super::super::block::{FeedMode, Side, WorkOffset, WorkPlane, coolant};
use super::super::draft::{Code, group, set};
use super::super::line::Line;
use super::super::text::{Number, tenths, whole};
use super::Loose;
use crate::program::{Rotation, Units};

/// A G code, in tenths.
pub(super) fn g(line: &mut Line<'_>, loose: &mut Loose, number: Number, column: usize) -> bool {
    let draft = &mut *line.draft;
    let Some(code) = tenths(number) else { return false };
    let group = match code {
        0 => set(&mut draft.code, Code::Rapid, group::MOTION),
        10 => set(&mut draft.code, Code::Feed, group::MOTION),
        20 => set(&mut draft.code, Code::Clockwise, group::MOTION),
        30 => set(&mut draft.code, Code::CounterClockwise, group::MOTION),
        40 => {
            loose.dwell = true;
            group::ALONE
        }
        530 | 1530 => {
            draft.machine = true;
            group::ALONE
        }
        // Exact stop and its window, continuous path.
        90 | 600 | 6010 | 6020 | 6030 | 640 | 6410 | 6420 | 6430 | 6440 | 6450 => group::PATH,
        170 => set(&mut draft.plane, WorkPlane::Xy, group::PLANE),
        180 => set(&mut draft.plane, WorkPlane::Zx, group::PLANE),
        190 => set(&mut draft.plane, WorkPlane::Yz, group::PLANE),
        400 => set(&mut draft.side, Side::None, group::SIDE),
        410 => set(&mut draft.side, Side::Left, group::SIDE),
        420 => set(&mut draft.side, Side::Right, group::SIDE),
        5000 => set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET),
        540..=570 | 5050..=5990 if code % 10 == 0 => set(&mut draft.work_offset, WorkOffset::Code(code), group::OFFSET),
        700 | 7000 => set(&mut draft.units, Units::Inches, group::UNITS),
        710 | 7100 => set(&mut draft.units, Units::Millimetres, group::UNITS),
        900 => set(&mut draft.distances, false, group::DISTANCE),
        910 => set(&mut draft.distances, true, group::DISTANCE),
        930 => set(&mut draft.feed_mode, FeedMode::InverseTime, group::FEED),
        940 => set(&mut draft.feed_mode, FeedMode::PerMinute, group::FEED),
        950 => set(&mut draft.feed_mode, FeedMode::PerRevolution, group::FEED),
        _ => return false,
    };
    let first = draft.group(group);
    if !first {
        line.fault(column, "two G codes of one group");
    }
    true
}

/// An M code.
pub(super) fn m(line: &mut Line<'_>, number: Number, column: usize) -> bool {
    let draft = &mut *line.draft;
    let first = match whole(number).unwrap_or(u32::MAX) {
        0 => draft.stop.replace(false).is_none(),
        1 => draft.stop.replace(true).is_none(),
        2 | 17 | 30 => !std::mem::replace(&mut draft.end, true),
        3 => draft.spindle.replace(Some(Rotation::Clockwise)).is_none(),
        4 => draft.spindle.replace(Some(Rotation::CounterClockwise)).is_none(),
        5 => draft.spindle.replace(None).is_none(),
        6 => !std::mem::replace(&mut draft.change, true),
        7 => coolant(&mut draft.coolant_on, coolant::MIST),
        8 => coolant(&mut draft.coolant_on, coolant::FLOOD),
        9 => coolant(&mut draft.coolant_off, coolant::FLOOD | coolant::MIST),
        _ => return false,
    };
    if !first {
        line.fault(column, "two M codes of one group");
    }
    true
}

/// Several kinds may be switched in one block.
fn coolant(bits: &mut u8, kinds: u8) -> bool {
    *bits |= kinds;
    true
}
