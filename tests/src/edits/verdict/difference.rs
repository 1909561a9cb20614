//! Difference between two blocks.

use Difference::{Hard, Soft};

use super::{Allowed, Event, name_of};
use crate::foreign::axes::{Axes, LETTERS, is_rotary};
use crate::foreign::state::{Compensation, Cycle, CycleKind, Length, PathMode, Plane, SMOOTHING, State, TiltedPlane};
use crate::foreign::trace::{Arc, Hole};
use crate::foreign::{Effect, Feed};

/// Largest change of the tool axis in a rotation about it, near the pole: the control may choose such rotations.
const NEARLY: f64 = 1e-3;

/// Sine of the angle from the pole within which a control may rotate an axis by much for a small change of the tool
/// axis.
const NEAR_POLE: f64 = 0.05;

/// Difference between two blocks.
pub(super) enum Difference {
    Hard(String),
    Soft(String),
}

/// Whether a straight motion ends where it begins, within tolerance.
pub(super) fn is_short(event: &Event<'_>, allowed: Allowed) -> bool {
    let short = |letter| match [event.before, &event.block.state].map(|state| state.position.get(letter)) {
        [Some(from), Some(to)] => {
            (from - to).abs() <= if is_rotary(letter) { allowed.rotary_deg } else { allowed.linear }
        }
        _ => false,
    };
    matches!(event.block.effect, Effect::Rapid | Effect::Feed) && event.block.words.letters().all(short)
}

fn compared(what: &str, was: f64, is: f64, largest: f64) -> Option<Difference> {
    let off = (was - is).abs();
    let text = || format!("{what} {was} became {is}");
    if off > largest || off.is_nan() {
        Some(Hard(text()))
    } else if off > 1e-9 {
        Some(Soft(text()))
    } else {
        None
    }
}

/// The first hard difference, or the first soft one.
fn worst(differences: impl IntoIterator<Item = Option<Difference>>) -> Option<Difference> {
    let mut soft = None;
    for difference in differences.into_iter().flatten() {
        match difference {
            Hard(why) => return Some(Hard(why)),
            Soft(why) => soft = soft.or(Some(Soft(why))),
        }
    }
    soft
}

fn hard(differs: bool, what: &str) -> Option<Difference> {
    differs.then(|| Hard(what.to_owned()))
}

fn soft(differs: bool, what: &str) -> Option<Difference> {
    differs.then(|| Soft(what.to_owned()))
}

pub(super) fn difference(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let (one, other) = (&was.block.effect, &is.block.effect);
    let (old, new) = (&was.block.state, &is.block.state);
    if std::mem::discriminant(one) != std::mem::discriminant(other) {
        return Some(Hard(format!("{} became {}", name_of(one), name_of(other))));
    }
    let preselected = soft(old.selected != new.selected, "the selected tool");
    let own = match (one, other) {
        (Effect::Dwell(one), Effect::Dwell(other)) => worst([
            compared("a dwell of", *one, *other, (0.01 * one).max(0.0015)),
            hard(old.spindle != new.spindle, "the spindle in a dwell"),
        ]),
        (Effect::Guard { length, tolerance }, Effect::Guard { length: length_now, tolerance: now }) => worst([
            compared("the length of a guard,", *length, *length_now, allowed.unit),
            hard(*now > tolerance + 1e-6, "the tolerance of a guard"),
            soft(*now < tolerance - 1e-6, "a guard that is stricter"),
            hard(old.guarded != new.guarded, "the register of a guard"),
            // A guard that names its register compares the same everywhere.
            hard(
                old.guarded.is_none() && (old.tool, old.length) != (new.tool, new.length),
                "tool or length offset at a guard",
            ),
        ]),
        (Effect::PlaneGuard { axes, largest }, Effect::PlaneGuard { axes: axes_now, largest: now }) => worst([
            hard(!same_turned(axes, axes_now), "the positions of a guard"),
            hard(*now > largest + 1e-9, "the limit of a guard"),
            soft(*now < largest - 1e-9, "a guard that is stricter"),
        ]),
        (Effect::ToolChange(one), Effect::ToolChange(other)) => hard(one != other, "the tool"),
        (Effect::Shop(one), Effect::Shop(other)) => hard(one != other, "the code of the shop"),
        (Effect::End, _) => left_at_end(old, new),
        (Effect::Stop | Effect::OptionalStop | Effect::OffsetGuard, _) => None,
        _ => worst([
            effect_difference((one, old), (other, new), allowed),
            moved(was, is, allowed),
            hard(goes_over_low(is, allowed) && !goes_over_low(was, allowed), "the level over a hole"),
            state_difference(was, is, allowed),
        ]),
    };
    let skipped = hard(was.block.skippable != is.block.skippable, "a block that may be skipped");
    worst([own, preselected, skipped, shop_difference(was, is, allowed), other_state(was, is)])
}

/// Differences of what the next program, or the operator, finds.
fn left_at_end(old: &State, new: &State) -> Option<Difference> {
    let register = |state: &State| match state.length {
        Some(Length::Off) | None => None,
        length => length,
    };
    let on = |state: &State| {
        state
            .smoothing
            .is_some_and(|numbers| numbers[0] != Some(0.0) && numbers.iter().flatten().any(|number| *number > 0.0))
    };
    worst([
        hard(old.units != new.units, "the unit at the end"),
        hard(old.plane != new.plane, "the working plane at the end"),
        hard(old.distance != new.distance, "distances at the end"),
        hard(old.feed_mode != new.feed_mode, "the feed mode at the end"),
        hard(side(old) != side(new), "the compensation at the end"),
        hard(old.work_offset != new.work_offset, "the work offset at the end"),
        hard(register(old).is_none() && register(new).is_some(), "a length at the end"),
        hard(old.under_tip_control() != new.under_tip_control(), "tip control at the end"),
        hard(on(old) != on(new), "smoothing at the end"),
        soft(old != new, "the state at the end"),
    ])
}

/// Whether rotary words are the same apart from whole turns.
fn same_turned(one: &Axes, other: &Axes) -> bool {
    let apart = |letter: char| Some(((one.get(letter)? - other.get(letter)?) / 360.0).fract().abs());
    one.len() == other.len()
        && one.letters().all(|letter| apart(letter).is_some_and(|turns| turns.min(1.0 - turns) < 1e-6))
}

/// Clamps where their axis moves and in cuts, and supplies in cuts.
fn shop_difference(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let cuts = was.block.effect.cuts() || is.block.effect.cuts();
    let clamp = |index: usize| {
        let [old, new] = [was.shop.clamps[index], is.shop.clamps[index]];
        let moves = |letter: char| turns(was, letter) || turns(is, letter);
        let bound = old == Some(false) && new != old && allowed.clamped[index].is_some_and(moves);
        let loose = cuts && old == Some(true) && new != old;
        worst([
            hard(bound, "an axis moves with its clamp not released"),
            hard(loose, "a cut with an axis not clamped"),
            soft(old != new, "a clamp where it does not matter"),
        ])
    };
    let supply = |index: usize| {
        let [old, new] = [was.shop.supplies[index], is.shop.supplies[index]];
        let differs = old.unwrap_or_default() != new.unwrap_or_default();
        worst([hard(cuts && differs, "a supply of the shop"), soft(old != new, "a supply where nothing is cut")])
    };
    worst([clamp(0), clamp(1), supply(0), supply(1), supply(2)])
}

/// Whether a block moves a rotary axis, or may move it.
fn turns(event: &Event<'_>, letter: char) -> bool {
    let (before, after) = (event.before, &event.block.state);
    let place = |state: &State| match event.block.effect {
        Effect::Machine => state.machine.get(letter),
        _ => state.position.get(letter),
    };
    match event.block.effect {
        Effect::Orient => true,
        Effect::Home(_) => place(after).is_none(),
        effect if effect.moves() => {
            let tilts = after.under_tip_control() && before.vector != after.vector;
            let from = place(before).or(event.rotary.get(letter));
            tilts || event.block.words.contains(letter) && (from != place(after) || place(after).is_none())
        }
        _ => false,
    }
}

/// States in which nothing is cut.
fn other_state(was: &Event<'_>, is: &Event<'_>) -> Option<Difference> {
    let [(spindle, coolant, speed, tool), now] =
        [was, is].map(|event| (event.before.spindle, event.before.coolant, event.before.speed, event.before.tool));
    let after = [was, is].map(|event| {
        let state = &event.block.state;
        (state.spindle, state.coolant, state.speed, state.tool)
    });
    let process = (spindle, coolant, speed, tool) != now || after[0] != after[1];
    let [frame, frame_now] = [was, is].map(|event| {
        let state = &event.block.state;
        let frame = (state.tilted_plane().is_some(), state.dynamic_offset);
        (state.plane, state.feed_mode, side(state), state.length, state.work_offset, frame)
    });
    worst([
        soft(process, "spindle or coolant where nothing is cut"),
        soft(frame != frame_now, "a mode where nothing is cut"),
    ])
}

fn effect_difference(
    (one, was): (&Effect, &State),
    (other, is): (&Effect, &State),
    allowed: Allowed,
) -> Option<Difference> {
    match (one, other) {
        (Effect::Arc(one), Effect::Arc(other)) => arc_difference(one, other, was, allowed),
        (Effect::Hole(one), Effect::Hole(other)) => hole_difference(one, other, allowed),
        (Effect::Home(one), Effect::Home(other)) => hard(one != other, "the way to the reference point"),
        // Zero and axes of the plane are in the offset.
        (Effect::Orient, Effect::Orient) => hard(was.work_offset != is.work_offset, "the work offset at a plane call"),
        _ => None,
    }
}

/// Whether the tool goes over a hole below the level from which it goes down.
fn goes_over_low(event: &Event<'_>, allowed: Allowed) -> bool {
    let Effect::Hole(hole) = event.block.effect else { return false };
    let [_, _, normal] = event.block.state.plane.unwrap_or(Plane::Xy).letters();
    let goes = |letter| match [event.before, &event.block.state].map(|state| state.position.get(letter)) {
        [Some(from), Some(to)] => (from - to).abs() > allowed.linear,
        _ => true,
    };
    let across = LETTERS.into_iter().filter(|letter| *letter != normal && !is_rotary(*letter));
    hole.over.is_some_and(|over| over < hole.cycle.reference - allowed.linear)
        && across.filter(|letter| event.block.state.position.contains(*letter)).any(goes)
}

fn arc_difference(one: &Arc, other: &Arc, state: &State, allowed: Allowed) -> Option<Difference> {
    let [first, second, _] = state.plane.unwrap_or(Plane::Xy).letters();
    let from_centre = |letter: char| {
        let index = "XYZ".find(letter).unwrap_or_default();
        state.position.get(letter).map_or(0.0, |end| end - one.centre[index])
    };
    let radius = from_centre(first).hypot(from_centre(second)).max(1e-6);
    let off_deg = (allowed.linear / radius).to_degrees().max(0.001);
    // Points of both between their common ends, in the plane.
    let point = |arc: &Arc, share: f64| {
        let [u, v] = [first, second].map(|letter| {
            let index = "XYZ".find(letter).unwrap_or_default();
            (arc.centre[index], state.position.get(letter).unwrap_or_default() - arc.centre[index])
        });
        let (sine, cosine) = (-share * arc.sweep_deg.to_radians()).sin_cos();
        [u.0 + u.1 * cosine - v.1 * sine, v.0 + u.1 * sine + v.1 * cosine]
    };
    let between = [0.25, 0.5, 0.75].into_iter().flat_map(|share| {
        let [was, is] = [one, other].map(|arc| point(arc, share));
        [0, 1].map(|index| compared("a point of an arc at", was[index], is[index], allowed.linear))
    });
    let turns = ((one.sweep_deg - other.sweep_deg) / 360.0).round();
    worst(between.chain([
        hard(turns.abs() > 0.5, "the turns of an arc"),
        soft((one.sweep_deg - other.sweep_deg).abs() > off_deg, "the sweep of an arc"),
    ]))
}

fn hole_difference(one: &Hole, other: &Hole, allowed: Allowed) -> Option<Difference> {
    let (was, is): (&Cycle, &Cycle) = (&one.cycle, &other.cycle);
    let kind = match (was.kind, is.kind) {
        (CycleKind::Peck { step: was }, CycleKind::Peck { step: is })
        | (CycleKind::ChipBreak { step: was }, CycleKind::ChipBreak { step: is }) => {
            compared("a step of", was, is, allowed.linear)
        }
        (CycleKind::Tap { pitch: was }, CycleKind::Tap { pitch: is }) => {
            compared("a pitch of", was, is, 0.002 * was.abs())
        }
        (was, is) => hard(was != is, "the kind of a hole"),
    };
    worst([
        kind,
        compared("a reference level of", was.reference, is.reference, allowed.linear),
        compared("a bottom of", was.bottom, is.bottom, allowed.linear),
        compared("a return level of", one.back_to, other.back_to, allowed.linear),
        compared("a dwell of", was.dwell_s, is.dwell_s, 0.01 * was.dwell_s),
        hard(was.others != is.others, "a parameter of a cycle"),
        hard(one.approach != other.approach, "rapid or feed to a hole"),
    ])
}

/// Differences of the positions, of the F and of the tool vector.
fn moved(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let (old, new) = (&was.block.state, &is.block.state);
    let cuts = was.block.effect.cuts();
    let machine = was.block.effect == Effect::Machine;
    let free = is_free(was, is, allowed);
    let place = |letter: char| {
        let of = |state: &State| if machine { state.machine.get(letter) } else { state.position.get(letter) };
        let written = [was, is].map(|event| event.block.words.contains(letter));
        let largest = if is_rotary(letter) { allowed.rotary_deg } else { allowed.linear };
        let from = [was, is].map(|event| event.before.position.contains(letter));
        match (of(old), of(new)) {
            (Some(one), Some(other)) if machine && written[0] != written[1] && (one - other).abs() < 1e-9 => {
                soft(true, "another axis at machine coordinates")
            }
            (Some(one), Some(other)) => {
                let starts = cuts && from[0] && !from[1];
                if is_rotary(letter) && free {
                    return soft((one - other).abs() > 1e-9, "a rotary axis that is free at the pole");
                }
                let mirrored = allowed.signs_turn && is_rotary(letter) && (one + other).abs() <= largest;
                if mirrored && (one - other).abs() > largest {
                    return soft(true, "the direction in which a rotary axis rotates");
                }
                let whole = ((one - other) / 360.0).round();
                // A cut that begins and ends as many revolutions off is the same.
                let begins = [was, is].map(|event| event.before.position.get(letter).unwrap_or_default());
                let as_many = || !cuts || ((begins[0] - begins[1]) / 360.0 - whole).abs() < 0.5;
                let counts = is_rotary(letter) && (allowed.wraps || as_many());
                let rolled = if counts { 360.0 * whole } else { 0.0 };
                worst([
                    compared(&format!("{letter} of"), one, other + rolled, largest),
                    soft(rolled.abs() > 1.0, &format!("revolutions of {letter}")),
                    hard(starts, &format!("{letter} cuts from an unknown position")),
                ])
            }
            (Some(one), None) if !cuts && was.rotary.get(letter).is_some_and(|last| (last - one).abs() < 1e-9) => {
                soft(true, "a rotary axis that is not moved")
            }
            (Some(_), None) | (None, Some(_)) if is_rotary(letter) && free => {
                soft(true, "a rotary axis that gives the tool axis of a vector")
            }
            (Some(_), None) if cuts || written[0] => Some(Hard(format!("{letter} is unknown"))),
            (None, Some(other)) if is.rotary.get(letter) == Some(other) => {
                soft(true, "a rotary axis that is not moved")
            }
            (None, Some(_)) if written[1] && !written[0] && is_turned_already(is, allowed) => {
                soft(true, "a rotary axis to where the plane has it")
            }
            (None, Some(_)) if written[1] && !written[0] => Some(Hard(format!("{letter} moves"))),
            (None, None) => hard(written[0] != written[1], &format!("{letter} moves in one of both")),
            (one, other) => soft(one != other, &format!("{letter} is known in one of both")),
        }
    };
    let axes = [old, new].map(|state| tool_axis(state, allowed));
    let vectors = match (old.vector, new.vector) {
        (Some(was), Some(is)) if old.under_tip_control() => {
            worst([0, 1, 2].map(|index| compared("a component of", was[index], is[index], 2e-3)))
        }
        (was, is) if old.under_tip_control() && cuts && !is_near(axes) => hard(was != is, "the tool vector"),
        _ => None,
    };
    let short = is_short(was, allowed) && is_short(is, allowed);
    let travel = |letter: &char| match [was.before, old].map(|state| state.position.get(*letter)) {
        [Some(from), Some(to)] if !is_rotary(*letter) => (to - from).powi(2),
        _ => 0.0,
    };
    let length = LETTERS.iter().map(travel).sum::<f64>().sqrt();
    // Rounded ends do not show the length of a short straight motion better.
    let straight = was.block.effect == Effect::Feed && length > 0.0;
    let rounding = if straight { 6.0 * allowed.unit / length } else { 0.0 };
    // Whether the largest speeds of the axes hold it back depends on them.
    let found_by_control = allowed.axis_speeds && old.vector.is_some() && new.vector.is_some();
    let factor = if passes_pole([was.before.vector, old.vector]) { 10.0 } else { 2.0 };
    let feed = match (was.block.feed(), is.block.feed()) {
        (Some(Feed::PerMinute(was)), Some(Feed::PerMinute(is)))
        | (Some(Feed::InverseTime(was)), Some(Feed::InverseTime(is)))
        | (Some(Feed::PerRevolution(was)), Some(Feed::PerRevolution(is)))
            if !short =>
        {
            let largest = rounding.max(0.0101);
            if found_by_control && is.max(was) <= factor * is.min(was) {
                soft((was - is).abs() > largest * was, "F of a block whose rotary angles the control finds")
            } else {
                compared("F", was, is, largest * was)
            }
        }
        (Some(was), Some(is)) if short => soft(was != is, "F of a motion within tolerance"),
        (was, is) => hard(was != is, "the feed mode"),
    };
    worst(LETTERS.into_iter().map(place).chain([vectors, feed]))
}

/// Whether the tool axis may come near Z of the workpiece, where the control may rotate an axis by half a revolution.
fn passes_pole(vectors: [Option<[f64; 3]>; 2]) -> bool {
    let [Some([a, b, _]), Some([c, d, _])] = vectors else { return false };
    // Distance of the straight line between both from the origin, in X and Y.
    let (u, v) = (c - a, d - b);
    let share = if u.hypot(v) > 0.0 { (-(a * u + b * v) / (u * u + v * v)).clamp(0.0, 1.0) } else { 0.0 };
    (a + share * u).hypot(b + share * v) < NEAR_POLE
}

/// Whether the tool axis is the same at the end of a motion and half way, although rotary axes differ, and words are
/// coordinates of the tip.
fn is_free(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> bool {
    let tips = |event: &Event<'_>| event.before.under_tip_control() && event.block.state.under_tip_control();
    let middle = |event: &Event<'_>| {
        let (from, to) = (event.before, &event.block.state);
        let mut middle = *to;
        for (letter, value) in to.position.iter().filter(|(letter, _)| is_rotary(*letter)) {
            middle.position.set(letter, (from.position.get(letter).unwrap_or(value) + value) / 2.0);
        }
        let still = is_near([from, to].map(|state| tool_axis(state, allowed)));
        if to.vector.is_some() && !still { None } else { tool_axis(&middle, allowed) }
    };
    let ends = [was, is].map(|event| tool_axis(&event.block.state, allowed));
    tips(was) && tips(is) && is_same(ends) && is_same([was, is].map(middle))
}

/// Tool axis on the workpiece: the vector, or that of the rotary axes.
fn tool_axis(state: &State, allowed: Allowed) -> Option<[f64; 3]> {
    state.vector.or_else(|| allowed.tool_axis.and_then(|axis| axis(&state.position)))
}

/// Whether a rapid brings rotary axes to where they are in the tilted plane, any other rotary axis where it suits best.
pub(super) fn is_turned_already(event: &Event<'_>, allowed: Allowed) -> bool {
    let (Some(tool_axis), Some(plane)) = (allowed.tool_axis, event.before.tilted_plane()) else { return false };
    let mut rotary = event.block.words;
    rotary.retain(is_rotary);
    if event.block.effect != Effect::Rapid || !plane.oriented || rotary.is_empty() {
        return false;
    }
    let free = ['A', 'B', 'C'].into_iter().find(|letter| {
        let mut all = rotary;
        all.extend(&Axes::from([('A', 0.0), ('B', 0.0), ('C', 0.0)]));
        !rotary.contains(*letter) && {
            let mut turned = all;
            turned.set(*letter, 90.0);
            tool_axis(&all) != tool_axis(&turned)
        }
    });
    let normal = plane.rotation.map(|row| row[2]);
    for letter in ['A', 'B', 'C'].into_iter().filter(|letter| !event.block.words.contains(*letter)) {
        rotary.set(letter, 0.0);
    }
    (0..free.map_or(1, |_| 3600)).any(|step| {
        let mut rotary = rotary;
        if let Some(free) = free {
            rotary.set(free, 0.1 * f64::from(step));
        }
        let axis = tool_axis(&rotary).unwrap_or_default();
        axis.iter().zip(&normal).all(|(one, other)| (one - other).abs() < 2e-3)
    })
}

/// Whether only rotary axes rotate under tip control, and the tool axis is nearly where it was.
pub(super) fn rotates_freely(event: &Event<'_>, allowed: Allowed) -> bool {
    let axes = [event.before, &event.block.state].map(|state| allowed.tool_axis.and_then(|axis| axis(&state.position)));
    let [from, to] = [&event.before.position, &event.block.state.position];
    event.before.under_tip_control()
        && !event.block.words.is_empty()
        && event.block.words.letters().all(|letter| is_rotary(letter) || from.get(letter) == to.get(letter))
        && is_same(axes)
}

/// Whether two unit vectors are known and equal, as far as rounded words show.
pub(super) fn is_near(vectors: [Option<[f64; 3]>; 2]) -> bool {
    is_about(vectors, 1e-4)
}

/// The same, where near the pole an axis may rotate a little about the tool as well.
fn is_same(vectors: [Option<[f64; 3]>; 2]) -> bool {
    let at_pole = vectors.iter().flatten().all(|[x, y, _]| x.hypot(*y) < NEAR_POLE);
    is_about(vectors, if at_pole { NEARLY } else { 1e-4 })
}

fn is_about(vectors: [Option<[f64; 3]>; 2], largest: f64) -> bool {
    let [Some(one), Some(other)] = vectors else { return false };
    one.iter().zip(&other).all(|(one, other)| (one - other).abs() < largest)
}

/// A tool change leaves no length offset.
fn length(state: &State) -> Length {
    state.length.unwrap_or(Length::Off)
}

fn side(state: &State) -> Compensation {
    state.compensation.unwrap_or(Compensation::Off)
}

/// Differences of modal states: those that change where the axes go, and in cuts those of the process.
pub(super) fn state_difference(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let (old, new) = (&was.block.state, &is.block.state);
    let tip = (old.under_tip_control(), new.under_tip_control());
    let machine = was.block.effect == Effect::Machine;
    // With every rotary axis at zero the words mean the same.
    let zero = |event: &Event<'_>| {
        let places = [&event.before.position, &event.block.state.position];
        let still = |place: &Axes| {
            place
                .iter()
                .all(|(letter, value)| !is_rotary(letter) || (value / 360.0 - (value / 360.0).round()).abs() < 1e-9)
        };
        places.into_iter().all(still)
    };
    let upright = was.block.effect == Effect::Rapid && zero(was) && zero(is);
    let differs = tip.0 != tip.1;
    let tip_control = worst([
        hard(differs && !upright, "tip control"),
        soft(differs, "tip control where every rotary axis is at zero"),
    ]);
    let frame = worst([
        hard(old.units != new.units, "the unit"),
        tip_control,
        hard(!machine && tilt_differs(old.tilted_plane(), new.tilted_plane()), "the tilted plane"),
        hard(!machine && old.dynamic_offset != new.dynamic_offset, "the dynamic work offset"),
        hard(tip.0 && old.interpolation != new.interpolation, "the interpolation of the tool axis"),
        hard(tip.0 && old.vector_frame != new.vector_frame, "the frame of vectors"),
        soft(old.tip_control != new.tip_control, "the start of tip control"),
        soft(old.tilted_plane() != new.tilted_plane(), "the tilted plane by little"),
    ]);
    if machine {
        return worst([frame, soft(old.rotary_path != new.rotary_path, "shortest path where no rotary axis moves")]);
    }
    let linear = was.block.effect.cuts() || was.block.words.letters().any(|letter| !is_rotary(letter));
    // In a tilted plane the length lies along its normal.
    let across = !tip.0 && !was.block.effect.cuts();
    let levels = linear && !(across && was.block.words.letters().all(|letter| letter != 'Z'));
    let rotary = was.block.words.letters().chain(is.block.words.letters()).any(is_rotary);
    let words = worst([
        frame,
        hard(old.work_offset != new.work_offset, "the work offset"),
        hard(linear && old.offset_cleared != new.offset_cleared, "the work offset after TRAORI or TRAFOOF"),
        hard(levels && length(old) != length(new), "the length offset"),
        soft(linear && old.length != new.length, "the length offset where it does not matter"),
        hard(rotary && old.rotary_path != new.rotary_path, "shortest path"),
        soft(old.rotary_path != new.rotary_path, "shortest path where no rotary axis moves"),
        hard(linear && side(old) != side(new), "the compensation"),
        hard(
            linear && side(old) != Compensation::Off && old.radius_delta != new.radius_delta,
            "the radius of the tool",
        ),
    ]);
    if !was.block.effect.cuts() {
        let process = (old.spindle, old.coolant, old.speed) != (new.spindle, new.coolant, new.speed);
        return worst([words, soft(process, "spindle or coolant in a rapid")]);
    }
    let taps = matches!(was.block.effect, Effect::Hole(_));
    let planar = taps || matches!(was.block.effect, Effect::Arc(_)) || side(old) != Compensation::Off;
    worst([
        words,
        hard(old.tool != new.tool, "the tool"),
        hard(old.spindle != new.spindle, "the spindle"),
        hard(!taps && old.stopped_by_thread != new.stopped_by_thread, "the spindle after a thread"),
        hard(old.speed != new.speed && !(rotates_at_pole(was, allowed) && rotates_at_pole(is, allowed)), "the speed"),
        soft(old.speed != new.speed, "the speed of a rotation at the pole"),
        hard(old.coolant != new.coolant, "coolant"),
        hard(planar && old.plane != new.plane, "the plane"),
        soft(old.plane != new.plane, "the plane of a line"),
        hard(path(old) != path(new), "the path mode"),
        soft(!allowed.starts_continuous && old.path != new.path, "the path mode of a control that is switched on"),
        hard(smoothing(old).iter().zip(smoothing(new)).any(|(old, new)| (old - new).abs() > 0.0), "smoothing"),
        hard(old.rotary_path != new.rotary_path, "shortest path"),
        hard(taps && old.rigid != new.rigid, "rigid tapping"),
    ])
}

/// Whether C alone rotates the part about the tool, as far as words in a frame that does not rotate with the table
/// show.
fn rotates_at_pole(event: &Event<'_>, allowed: Allowed) -> bool {
    let (from, to) = (&event.before.position, &event.block.state.position);
    let stays = |letter: char| from.get(letter) == to.get(letter);
    let upright = |letter: char| to.get(letter).is_none_or(|angle| angle.abs() < 1e-9);
    let about_tool = event.block.state.under_tip_control()
        && allowed.tool_axis.is_none()
        && !stays('C')
        && stays('Z')
        && ['A', 'B'].into_iter().all(|letter| stays(letter) && upright(letter));
    about_tool || rotates_freely(event, allowed)
}

/// Numbers of smoothing, all zero where it is off: Q0 of G5.1, a tolerance or a kind of 0.
fn smoothing(state: &State) -> [f64; SMOOTHING] {
    let numbers = state.smoothing.unwrap_or_default().map(Option::unwrap_or_default);
    if numbers[..2].iter().all(|number| number.abs() < 1e-12) { [0.0; SMOOTHING] } else { numbers }
}

/// Continuous path without a tolerance is the state in which a control is switched on.
fn path(state: &State) -> PathMode {
    state.path.unwrap_or(PathMode::Continuous(None))
}

fn tilt_differs(was: Option<TiltedPlane>, is: Option<TiltedPlane>) -> bool {
    match (was, is) {
        (Some(was), Some(is)) => {
            let near = |one: &f64, other: &f64| (one - other).abs() < 1e-3;
            let rows = was.rotation.iter().flatten().zip(is.rotation.iter().flatten());
            !rows.into_iter().all(|(one, other)| near(one, other))
                || !was.origin.iter().zip(&is.origin).all(|(one, other)| near(one, other))
                || was.oriented != is.oriented
                // Without a word the control takes the nearest, to which the program has moved the rotary axes before.
                || was.solution != 0 && is.solution != 0 && was.solution != is.solution
        }
        (was, is) => was.is_some() != is.is_some(),
    }
}
