//! Traces that differ in one place, and nearly do the same.

use super::difference::Difference::Hard;
use super::difference::{difference, is_near, is_short, is_turned_already, rotates_freely, state_difference};
use super::{Allowed, Event, Verdict};
use crate::foreign::axes::{Axes, is_rotary};
use crate::foreign::state::State;
use crate::foreign::trace::Arc;
use crate::foreign::{Effect, Executed};

/// Whether the traces nearly do the same from the first block on that differs, and why.
pub(super) fn rearranged(was: &[Event<'_>], is: &[Event<'_>], index: usize, allowed: Allowed) -> Option<Verdict> {
    let undecided = |why: &str| Some(Verdict::Undecided(why.to_owned()));
    let agrees = |one: &Event<'_>, other: &Event<'_>| !matches!(difference(one, other, allowed), Some(Hard(_)));
    let all_agree = |was: &[Event<'_>], is: &[Event<'_>]| {
        was.len() == is.len() && was.iter().zip(is).all(|(was, is)| agrees(was, is))
    };
    let both_ways = |fits: &dyn Fn(&[Event<'_>], &[Event<'_>]) -> bool| fits(was, is) || fits(is, was);
    let added = || index < is.len() && all_agree(&was[index..], &is[index + 1..]);
    let in_one_of_both = |fits: &dyn Fn(&[Event<'_>]) -> bool| {
        both_ways(&|events, other| {
            index < events.len() && fits(events) && all_agree(&events[index + 1..], &other[index..])
        })
    };
    let in_parts = |fits: &dyn Fn(&Event<'_>, &[Event<'_>]) -> bool| {
        both_ways(&|one, two| match (one.get(index), two.get(index..index + 2)) {
            (Some(whole), Some(parts)) => fits(whole, parts) && all_agree(&one[index + 1..], &two[index + 2..]),
            _ => false,
        })
    };
    if in_parts(&|whole, parts| is_split(whole, parts, allowed)) {
        return undecided("a rapid in X and Y in two blocks");
    }
    let waits = |extra: &Event<'_>| {
        matches!(
            extra.block.effect,
            Effect::Dwell(_) | Effect::Guard { .. } | Effect::PlaneGuard { .. } | Effect::OffsetGuard
        )
    };
    if is.get(index).is_some_and(waits) && added() {
        return undecided("a wait is added");
    }
    let idle = |events: &[Event<'_>]| is_idle(events, index);
    let both = || idle(was) && idle(is) && all_agree(&was[index + 1..], &is[index + 1..]);
    if both() || in_one_of_both(&idle) {
        return undecided("a wait with no cut after it");
    }
    if in_one_of_both(&|events| is_short(&events[index], allowed)) {
        return undecided("a motion within tolerance");
    }
    let waits_elsewhere = both_ways(&|one, other| {
        let Some((wait, one)) = one[index..].split_first() else { return false };
        let other = &other[index..];
        let between = other.iter().take_while(|event| is_free_of(wait, event)).count();
        between > 0
            && other.get(between).is_some_and(|event| agrees(wait, event) && agrees(event, wait))
            && one.len() >= between
            && all_agree(&one[..between], &other[..between])
            && all_agree(&one[between..], &other[between + 1..])
    });
    if waits_elsewhere {
        return undecided("a wait or a guard before or after a rapid");
    }
    if is_rotated_before(is, index) && added() {
        return undecided("a rotary axis rotates to another place before");
    }
    if in_one_of_both(&|events| rotates_freely(&events[index], allowed)) {
        return undecided("a rotation at the pole");
    }
    if is_retracted_further(is, index) && added() {
        return undecided("another axis in machine coordinates after a retract");
    }
    if in_one_of_both(&|events| is_home_without_rotation(events, index)) {
        return undecided("home positions where nothing rotates");
    }
    if in_parts(&|whole, parts| is_arc_in_parts(whole, parts, allowed)) {
        return undecided("an arc in two parts");
    }
    if let (Some(one), Some(other)) = (was.get(index..index + 2), is.get(index..index + 2))
        && are_turns_of_one_helix(one, other, allowed)
        && all_agree(&was[index + 2..], &is[index + 2..])
    {
        return undecided("turns of one helix in another order");
    }
    if in_one_of_both(&|events| is_way_out_before_stop(events, index)) {
        return undecided("a part of the retract before a stop");
    }
    if in_one_of_both(&|events| is_parked_twice(events, index)) {
        return undecided("axes park twice");
    }
    if let Some(count) = is_parked_in_another_order(was, is, index)
        && all_agree(&was[index + count..], &is[index + count..])
    {
        return undecided("axes park in another order");
    }
    let over_hole = |events: &[Event<'_>]| is_over_next_hole(events, index, allowed);
    let both_over = || over_hole(was) && over_hole(is) && all_agree(&was[index + 1..], &is[index + 1..]);
    if in_one_of_both(&over_hole) || both_over() {
        return undecided("a rapid over the next hole");
    }
    let turned = |event: &Event<'_>| is_turned_already(event, allowed) && event.block.words.letters().all(is_rotary);
    if in_one_of_both(&|events| turned(&events[index])) {
        return undecided("rotary axes to where the plane has them");
    }
    if is_extra_tool_change(is, index) {
        // The retract after it is another one.
        let retracts = is.get(index + 1).is_some_and(|event| event.block.effect == Effect::Machine);
        if added() || retracts && all_agree(&was[index..], &is[index + 2..]) {
            return undecided("a tool change before another");
        }
    }
    if is_turned_before_tip_control(was, is, index, allowed) && all_agree(&was[index + 1..], &is[index + 1..]) {
        return undecided("a rotary axis that is free under tip control");
    }
    let inner = |events: &[Event<'_>]| {
        events.get(index).is_some_and(|event| event.block.effect == Effect::Rapid)
            && on_the_line(events, index, allowed)
    };
    if inner(was) && inner(is) && all_agree(&was[index + 1..], &is[index + 1..]) {
        return undecided("a rapid to another point on its line");
    }
    if let (Some(one), Some(other)) = (was.get(index..index + 2), is.get(index..index + 2))
        && are_ends_on_one_line(one, other, allowed)
        && all_agree(&was[index + 2..], &is[index + 2..])
    {
        return undecided("two ends on one line in the other order");
    }
    if is.get(index).is_some() && is_to_and_fro(is, index, allowed) && added() {
        return undecided("a rapid to and fro on the line of another");
    }
    let moved = both_ways(&|one, other| {
        let Some((first, one)) = one[index..].split_first() else { return false };
        let other = &other[index..];
        let place = one.iter().zip(other).take_while(|(one, other)| agrees(one, other)).count();
        is_short(first, allowed)
            && other.get(place).is_some_and(|event| is_short(event, allowed))
            && all_agree(&one[place..], &other[place + 1..])
    });
    if moved {
        return undecided("a motion within tolerance, elsewhere");
    }
    if matches!(&was[index..], [end] if end.block.effect == Effect::End) && is.len() == index {
        return undecided("the end of the file ends the program");
    }
    let still = |events: &[Event<'_>]| !events.iter().any(|event| event.block.effect.moves());
    if still(&was[index..]) && still(&is[index..]) && is_of_shop(was, index, is) {
        return undecided("a code of the shop after the last motion");
    }
    // The first block that differs may come after one that lies on the same line.
    for index in [Some(index), index.checked_sub(1)].into_iter().flatten() {
        if index < was.len() && on_the_line(was, index, allowed) && all_agree(&was[index + 1..], &is[index..]) {
            return undecided("a point on a line is left out");
        }
        if index < is.len() && on_the_line(is, index, allowed) && all_agree(&was[index..], &is[index + 1..]) {
            return undecided("a point on a line is added");
        }
    }
    if all_agree(&needed(was, index, allowed), &needed(is, index, allowed)) {
        return undecided("rapids on one line, rotations at the pole and motions within tolerance");
    }
    None
}

/// Events from just before an index on, without rapids that end on the line of the next one or over the next hole,
/// rotations at the pole, and motions within tolerance.
fn needed<'a>(events: &[Event<'a>], index: usize, allowed: Allowed) -> Vec<Event<'a>> {
    let on_line = |at: usize| events[at].block.effect == Effect::Rapid && on_the_line(events, at, allowed);
    let is_needed = |&at: &usize| {
        !is_short(&events[at], allowed)
            && !on_line(at)
            && !is_over_next_hole(events, at, allowed)
            && !rotates_freely(&events[at], allowed)
    };
    (index.saturating_sub(1)..events.len()).filter(is_needed).map(|at| events[at]).collect()
}

/// Whether a rapid along the tool leads out before a stop, after which a retract leads on.
fn is_way_out_before_stop(events: &[Event<'_>], index: usize) -> bool {
    let Some((out, rest)) = events.get(index..).and_then(<[_]>::split_first) else { return false };
    let stops = rest.iter().take_while(|event| event.block.effect.stops()).count();
    let guard = |event: &&Event<'_>| event.block.effect == Effect::OffsetGuard;
    let retract =
        rest[stops..].iter().find(|event| !guard(event)).filter(|event| event.block.effect == Effect::Machine);
    let [from, to] = [&out.before.position, &out.block.state.position];
    let moved = out.block.words.letters().filter(|letter| from.get(*letter) != to.get(*letter));
    out.block.effect == Effect::Rapid
        && stops > 0
        && retract.is_some_and(|retract| retract.block.words.letters().eq(moved))
}

/// Whether axes go to machine coordinates to which they go once more after the same cut, and nothing but such motions
/// is between.
fn is_parked_twice(events: &[Event<'_>], index: usize) -> bool {
    let idle = |event: &&Event<'_>| {
        let rotates = event.block.effect == Effect::Rapid && event.block.words.letters().all(is_rotary);
        rotates || event.block.effect == Effect::Machine || !event.block.effect.moves()
    };
    let Some(event) = events.get(index).filter(|event| event.block.effect == Effect::Machine) else { return false };
    let mut others = events[index + 1..].iter().take_while(idle).chain(events[..index].iter().rev().take_while(idle));
    others.any(|other| other.block.effect == Effect::Machine && other.block.words == event.block.words)
}

/// Whether an event is a wait, and nothing is cut before the next one.
fn is_idle(events: &[Event<'_>], index: usize) -> bool {
    let before_next = |event: &&Event<'_>| {
        !matches!(event.block.effect, Effect::Dwell(_) | Effect::ToolChange(_)) && !event.block.effect.stops()
    };
    events.get(index).is_some_and(|event| matches!(event.block.effect, Effect::Dwell(_)))
        && !events[index + 1..].iter().take_while(before_next).any(|event| event.block.effect.cuts())
}

/// Whether a wait or a guard may as well come after an event: before a cut, and a guard before the length matters.
fn is_free_of(wait: &Event<'_>, event: &Event<'_>) -> bool {
    let moves = event.block.effect.moves() && !event.block.effect.cuts();
    match wait.block.effect {
        Effect::Dwell(_) => moves || matches!(event.block.effect, Effect::PlaneGuard { .. } | Effect::OffsetGuard),
        Effect::OffsetGuard => matches!(event.block.effect, Effect::Machine | Effect::ToolChange(_)),
        Effect::Guard { .. } => {
            let lengthless = matches!(event.block.effect, Effect::Orient | Effect::Machine)
                || event.block.words.letters().all(is_rotary);
            let change = matches!(event.block.effect, Effect::ToolChange(_)) && wait.block.state.guarded.is_some();
            let still = matches!(event.block.effect, Effect::Dwell(_) | Effect::Shop(_));
            moves && lengthless || change || still
        }
        _ => false,
    }
}

/// Whether a motion to machine coordinates follows another, with no motion between them.
fn is_retracted_further(events: &[Event<'_>], index: usize) -> bool {
    let retract = |event: &Event<'_>| event.block.effect == Effect::Machine;
    let before = events.get(..index).unwrap_or_default().iter().rev().find(|event| event.block.effect.moves());
    events.get(index).is_some_and(retract) && before.is_some_and(retract)
}

/// Whether linear axes go to machine coordinates after a retract, and the next motion rotates nothing.
fn is_home_without_rotation(events: &[Event<'_>], index: usize) -> bool {
    let next = events.get(index + 1..).unwrap_or_default().iter().find(|event| event.block.effect.moves());
    let rotates = |next: &Event<'_>| {
        next.block
            .words
            .letters()
            .any(|letter| is_rotary(letter) && next.rotary.get(letter) != next.block.state.position.get(letter))
    };
    is_retracted_further(events, index) && !next.is_some_and(rotates)
}

/// Whether a rapid of rotary axes follows a retract, and the next rapid has other words for them.
fn is_rotated_before(events: &[Event<'_>], index: usize) -> bool {
    let moves = |event: &&Event<'_>| event.block.effect.moves();
    let (Some(event), Some(before)) = (events.get(index), events[..index.min(events.len())].iter().rev().find(moves))
    else {
        return false;
    };
    let next = events[index + 1..].iter().find(moves);
    let rapid = |event: &Event<'_>| event.block.effect == Effect::Rapid && event.block.words.letters().all(is_rotary);
    let again =
        |next: &Event<'_>| rapid(next) && event.block.words.letters().all(|letter| next.block.words.contains(letter));
    rapid(event) && before.block.effect == Effect::Machine && next.is_some_and(again)
}

/// Whether an arc is two arcs about the same centre.
fn is_arc_in_parts(whole: &Event<'_>, parts: &[Event<'_>], allowed: Allowed) -> bool {
    let (Effect::Arc(arc), Effect::Arc(first), Effect::Arc(second)) =
        (whole.block.effect, parts[0].block.effect, parts[1].block.effect)
    else {
        return false;
    };
    are_about(&arc, &[first, second], allowed)
        && first.sweep_deg * second.sweep_deg > 0.0
        && (first.sweep_deg + second.sweep_deg - arc.sweep_deg).abs() < 1.0
        && ends_as(whole, &parts[1], allowed)
}

/// Whether arcs have the centre of another.
fn are_about(arc: &Arc, others: &[Arc], allowed: Allowed) -> bool {
    let near = |other: &Arc| arc.centre.iter().zip(&other.centre).all(|(one, two)| (one - two).abs() <= allowed.linear);
    others.iter().all(near)
}

/// Whether an arc is as another in all but its length.
fn ends_as(one: &Event<'_>, other: &Event<'_>, allowed: Allowed) -> bool {
    let same = Event { block: &Executed { effect: one.block.effect, ..*other.block }, ..*other };
    !matches!(difference(one, &same, allowed), Some(Hard(_)))
}

/// Whether two arcs about one centre are as long as two others, and end where these end.
fn are_turns_of_one_helix(was: &[Event<'_>], is: &[Event<'_>], allowed: Allowed) -> bool {
    let arcs = |events: &[Event<'_>]| match (events[0].block.effect, events[1].block.effect) {
        (Effect::Arc(first), Effect::Arc(second)) => Some([first, second]),
        _ => None,
    };
    let (Some(one), Some(other)) = (arcs(was), arcs(is)) else { return false };
    let sweep = |arcs: &[Arc; 2]| arcs[0].sweep_deg + arcs[1].sweep_deg;
    are_about(&one[0], &one, allowed)
        && are_about(&one[0], &other, allowed)
        && (sweep(&one) - sweep(&other)).abs() < 1.0
        && ends_as(&was[1], &is[1], allowed)
}

/// Whether a tool change brings the tool that is in the spindle, or is followed by another, before anything but
/// retracts.
fn is_extra_tool_change(events: &[Event<'_>], index: usize) -> bool {
    let again =
        |event: &Event<'_>| matches!(event.block.effect, Effect::ToolChange(tool) if event.before.tool == Some(tool));
    if events.get(index).is_some_and(again) {
        return true;
    }
    let mut rest = events.get(index..).unwrap_or_default().iter();
    let change = |event: &Event<'_>| matches!(event.block.effect, Effect::ToolChange(_));
    rest.next().is_some_and(change) && rest.find(|event| event.block.effect != Effect::Machine).is_some_and(change)
}

/// Whether both rapids give the rotary axes places with one tool axis, and the next motion is under tip control.
fn is_turned_before_tip_control(was: &[Event<'_>], is: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let (Some(tool_axis), Some(one), Some(other)) = (allowed.tool_axis, was.get(index), is.get(index)) else {
        return false;
    };
    let rapid = |event: &Event<'_>| event.block.effect == Effect::Rapid && event.block.words.letters().all(is_rotary);
    let tips = |events: &[Event<'_>]| events.get(index + 1).is_some_and(|next| next.before.under_tip_control());
    let axes = [one, other].map(|event| tool_axis(&event.block.state.position));
    rapid(one) && rapid(other) && tips(was) && tips(is) && is_near(axes)
}

/// Number of rapids after the last cut with a tool that bring the same axes to the same places in another order.
fn is_parked_in_another_order(was: &[Event<'_>], is: &[Event<'_>], index: usize) -> Option<usize> {
    let rapid = |event: &&Event<'_>| matches!(event.block.effect, Effect::Rapid | Effect::Machine);
    let cut = |event: &&Event<'_>| event.block.effect.cuts();
    let stop = |event: &&Event<'_>| matches!(event.block.effect, Effect::ToolChange(_)) || event.block.effect.stops();
    let parks =
        |events: &[Event<'_>]| !events[index.min(events.len())..].iter().take_while(|e| !stop(e)).any(|e| cut(&e));
    if !parks(was) || !parks(is) {
        return None;
    }
    let ends = |event: &Event<'_>| {
        let state = &event.block.state;
        let machine = event.block.effect == Effect::Machine;
        let place = if machine { state.machine } else { state.position };
        let ends: Vec<_> =
            event.block.words.letters().map(|letter| format!("{machine} {letter}{:?}", place.get(letter))).collect();
        ends.join(" ")
    };
    let runs = [was, is].map(|events| events[index.min(events.len())..].iter().take_while(rapid).count());
    (2..=runs[0].min(runs[1])).find(|count| {
        let mut sorted = [was, is].map(|events| events[index..index + count].iter().map(ends).collect::<Vec<_>>());
        sorted.iter_mut().for_each(|ends| ends.sort());
        let mut letters: Vec<char> = was[index..index + count].iter().flat_map(|e| e.block.words.letters()).collect();
        letters.sort_unstable();
        sorted[0] == sorted[1] && letters.windows(2).all(|pair| pair[0] != pair[1])
    })
}

/// Whether a rapid ends over the next hole, and the cycle alone would bring the tool there above its reference level,
/// or along the hole.
fn is_over_next_hole(events: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let Some([rapid, next]) = events.get(index..index + 2) else { return false };
    let Effect::Hole(hole) = next.block.effect else { return false };
    let is_over = |state: &State| {
        ['X', 'Y'].iter().all(|&letter| match [state, &next.block.state].map(|state| state.position.get(letter)) {
            [Some(one), Some(two)] => (one - two).abs() <= allowed.linear,
            _ => false,
        })
    };
    let least = |level: f64, state: &State| state.position.get('Z').is_some_and(|z| z >= level - allowed.linear);
    let above = |state: &State| least(hole.cycle.reference, state);
    let rises = || rapid.before.position.get('Z').is_some_and(|z| least(z, &rapid.block.state));
    matches!(rapid.block.effect, Effect::Rapid | Effect::Feed)
        && !rapid.block.words.letters().any(is_rotary)
        && is_over(&rapid.block.state)
        && (above(rapid.before) && above(&rapid.block.state) || is_over(rapid.before) && rises())
}

/// Whether one of two blocks is a code of the shop.
fn is_of_shop(one: &[Event<'_>], index: usize, two: &[Event<'_>]) -> bool {
    [one, two].iter().any(|events| events.get(index).is_some_and(|event| matches!(event.block.effect, Effect::Shop(_))))
}

/// Whether a rapid in X and Y and of rotary axes is two rapids.
fn is_split(whole: &Event<'_>, parts: &[Event<'_>], allowed: Allowed) -> bool {
    let level = |event: &Event<'_>| {
        let letters = || event.block.words.letters();
        event.block.effect == Effect::Rapid && letters().all(|letter| matches!(letter, 'X' | 'Y') || is_rotary(letter))
    };
    let ends_as = |part: &Event<'_>, letter| {
        let ends = [whole, part].map(|event| event.block.state.position.get(letter));
        matches!(ends, [Some(one), Some(two)] if (one - two).abs() <= allowed.linear)
    };
    level(whole)
        && parts.iter().all(level)
        && parts[0].block.words.letters().all(|letter| ends_as(&parts[0], letter))
        && whole.block.words.letters().all(|letter| ends_as(&parts[1], letter))
}

/// Whether two motions of one kind lead to the same two places on one line, in the other order.
fn are_ends_on_one_line(was: &[Event<'_>], is: &[Event<'_>], allowed: Allowed) -> bool {
    let [first, second] = [&was[0], &was[1]].map(|event| &event.block.state.position);
    let ends = [&is[1], &is[0]].map(|event| &event.block.state.position);
    let alike = was.iter().chain(is).all(|event| {
        matches!(event.block.effect, Effect::Rapid | Effect::Feed)
            && event.block.effect == was[0].block.effect
            && event.block.feed() == was[0].block.feed()
            && state_difference(event, &was[0], allowed).is_none()
    });
    let start = &was[0].before.position;
    let shares = [first, second].map(|end| share_on_line(start, end, first, allowed));
    alike && [first, second] == ends && shares.iter().all(Option::is_some)
}

/// Whether a rapid begins on the line of a rapid near it, and ends on that rapid; or a feed motion on one at the same
/// feed.
fn is_to_and_fro(events: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let this = &events[index];
    let [from, here] = [&this.before.position, &this.block.state.position];
    let near = index.saturating_sub(2)..(index + 4).min(events.len());
    let ends = |other: usize| {
        let event = &events[other];
        let [start, end] = [event.before.position, event.block.state.position];
        match event.block.effect {
            Effect::Rapid => (this.block.effect == Effect::Rapid).then_some((start, end)),
            Effect::Feed => {
                (this.block.effect == Effect::Feed && this.block.feed() == event.block.feed()).then_some((start, end))
            }
            // Down to the reference plane of the cycle.
            Effect::Hole(hole) => {
                let mut above = end;
                above.set('Z', start.get('Z')?);
                let mut below = end;
                below.set('Z', hole.cycle.reference);
                Some((above, below))
            }
            _ => None,
        }
    };
    matches!(this.block.effect, Effect::Rapid | Effect::Feed)
        && near.filter(|other| *other != index).filter_map(ends).any(|(start, end)| {
            let share = |at: &Axes| share_on_line(&start, at, &end, allowed);
            share(here).is_some_and(|share| (0.0..=1.0).contains(&share)) && share(from).is_some()
        })
}

/// Share of a straight motion at which a position is, before its start and beyond its end as well; `None` if it is not
/// on its line. The rotary axes need not be even.
fn share_on_line(from: &Axes, here: &Axes, to: &Axes, allowed: Allowed) -> Option<f64> {
    let mut ratio = 0.0;
    let mut longest = 0.0_f64;
    let mut moved = Vec::new();
    for letter in here.letters() {
        let [from, here, to] = [from.get(letter)?, here.get(letter)?, to.get(letter)?];
        moved.push((letter, from, here, to));
        let travel = (to - from).abs() * if is_rotary(letter) { 1e-6 } else { 1.0 };
        if travel > longest {
            longest = travel;
            ratio = (here - from) / (to - from);
        }
    }
    let is_on = |(letter, from, here, to): &(char, f64, f64, f64)| {
        let off = (from + ratio * (to - from) - here).abs();
        off <= if is_rotary(*letter) { allowed.rotary_deg } else { allowed.linear }
    };
    (longest > 0.0 && moved.iter().all(is_on)).then_some(ratio)
}

/// Whether a straight motion ends on the straight line between the positions before it and after the next motion.
fn on_the_line(events: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let Some(next) = events.get(index + 1) else { return false };
    let this = &events[index];
    let tips = [this.before, &next.block.state].iter().all(|state| state.under_tip_control());
    let axis = allowed.tool_axis.filter(|_| tips);
    let alike =
        matches!((this.block.effect, next.block.effect), (Effect::Rapid, Effect::Rapid) | (Effect::Feed, Effect::Feed));
    if !alike || this.block.feed() != next.block.feed() || state_difference(this, next, allowed).is_some() {
        return false;
    }
    let [from, here, to] = [&this.before.position, &this.block.state.position, &next.block.state.position];
    let is_between = |allowed| share_on_line(from, here, to, allowed).filter(|share| (0.0..=1.0).contains(share));
    let with_tool_axis = || {
        // Near the pole a rotary axis may be far off where the tool axis is not.
        let (tool_axis, share) = (axis?, is_between(Allowed { rotary_deg: 360.0, ..allowed })?);
        let mut even = *here;
        for (letter, from) in from.iter().filter(|(letter, _)| is_rotary(*letter)) {
            even.set(letter, from + share * (to.get(letter)? - from));
        }
        let [one, other] = [tool_axis(here)?, tool_axis(&even)?];
        let cosine: f64 = one.iter().zip(&other).map(|(one, other)| one * other).sum();
        (cosine >= allowed.rotary_deg.to_radians().cos()).then_some(())
    };
    is_between(allowed).is_some() || with_tool_axis().is_some()
}
