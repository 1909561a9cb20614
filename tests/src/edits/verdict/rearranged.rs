//! Traces that differ in one place, and nearly do the same.

use super::difference::Difference::Hard;
use super::difference::{difference, is_near, is_short, is_turned_already, state_difference};
use super::{Allowed, Event, Verdict};
use crate::foreign::axes::is_rotary;
use crate::foreign::state::State;
use crate::foreign::trace::Arc;
use crate::foreign::{Effect, Executed};

/// Whether the traces are the same but for one block on the line between its neighbours.
pub(super) fn rearranged(was: &[Event<'_>], is: &[Event<'_>], index: usize, allowed: Allowed) -> Option<Verdict> {
    let rest_agrees = |was: &[Event<'_>], is: &[Event<'_>]| {
        let hard = |(one, other): (&Event<'_>, &Event<'_>)| matches!(difference(one, other, allowed), Some(Hard(_)));
        was.len() == is.len() && !was.iter().zip(is).any(hard)
    };
    if is_split(was, is, index, allowed) && rest_agrees(&was[index + 1..], &is[index + 2..])
        || is_split(is, was, index, allowed) && rest_agrees(&was[index + 2..], &is[index + 1..])
    {
        return Some(Verdict::Undecided("a rapid in X and Y in two blocks".to_owned()));
    }
    if let Some(extra) = is.get(index)
        && matches!(extra.block.effect, Effect::Dwell(_) | Effect::Guard { .. })
        && rest_agrees(&was[index..], &is[index + 1..])
    {
        return Some(Verdict::Undecided("a wait is added".to_owned()));
    }
    let is_idle = |events: &[Event<'_>]| {
        let before_next = |event: &&Event<'_>| {
            !matches!(event.block.effect, Effect::Dwell(_) | Effect::ToolChange(_)) && !event.block.effect.stops()
        };
        events.get(index).is_some_and(|event| matches!(event.block.effect, Effect::Dwell(_)))
            && !events[index + 1..].iter().take_while(before_next).any(|event| event.block.effect.cuts())
    };
    let idle = |events: &[Event<'_>], other: &[Event<'_>]| {
        is_idle(events) && rest_agrees(&events[index + 1..], &other[index..])
    };
    let both = is_idle(was) && is_idle(is) && rest_agrees(&was[index + 1..], &is[index + 1..]);
    if both || idle(was, is) || idle(is, was) {
        return Some(Verdict::Undecided("a wait with no cut after it".to_owned()));
    }
    let short = |events: &[Event<'_>], other: &[Event<'_>]| {
        events.get(index).is_some_and(|event| is_short(event, allowed))
            && rest_agrees(&events[index + 1..], &other[index..])
    };
    if short(was, is) || short(is, was) {
        return Some(Verdict::Undecided("a motion within tolerance".to_owned()));
    }
    let agrees = |one: &Event<'_>, other: &Event<'_>| !matches!(difference(one, other, allowed), Some(Hard(_)));
    let waits = |one: &[Event<'_>], other: &[Event<'_>]| {
        let moved = one.get(index..).and_then(<[_]>::split_first).zip(other.get(index..));
        moved.is_some_and(|((wait, one), other)| {
            let guards = matches!(wait.block.effect, Effect::Guard { .. });
            let free = |event: &&Event<'_>| {
                let lengthless = matches!(event.block.effect, Effect::Orient | Effect::Machine)
                    || event.block.words.letters().all(is_rotary);
                let change = matches!(event.block.effect, Effect::ToolChange(_)) && wait.block.state.guarded.is_some();
                let moves = event.block.effect.moves() && !event.block.effect.cuts();
                moves && (lengthless || !guards) || change && guards
            };
            let rapids = other.iter().take_while(free).count();
            (guards || matches!(wait.block.effect, Effect::Dwell(_)))
                && rapids > 0
                && other.get(rapids).is_some_and(|event| agrees(wait, event) && agrees(event, wait))
                && rest_agrees(&one[..rapids.min(one.len())], &other[..rapids])
                && rest_agrees(&one[rapids.min(one.len())..], &other[rapids + 1..])
        })
    };
    if waits(was, is) || waits(is, was) {
        return Some(Verdict::Undecided("a wait or a guard before or after a rapid".to_owned()));
    }
    if is_rotated_before(is, index) && rest_agrees(&was[index..], &is[index + 1..]) {
        return Some(Verdict::Undecided("a rotary axis rotates to another place before".to_owned()));
    }
    let free = |events: &[Event<'_>], other: &[Event<'_>]| {
        events.get(index).is_some_and(|event| rotates_freely(event, allowed))
            && rest_agrees(&events[index + 1..], &other[index..])
    };
    if free(was, is) || free(is, was) {
        return Some(Verdict::Undecided("a rotation at the pole".to_owned()));
    }
    if is_retracted_further(is, index) && rest_agrees(&was[index..], &is[index + 1..]) {
        return Some(Verdict::Undecided("another axis in machine coordinates after a retract".to_owned()));
    }
    if is_arc_in_parts(was, is, index, allowed) && rest_agrees(&was[index + 1..], &is[index + 2..])
        || is_arc_in_parts(is, was, index, allowed) && rest_agrees(&was[index + 2..], &is[index + 1..])
    {
        return Some(Verdict::Undecided("an arc in two parts".to_owned()));
    }
    if let Some(count) = is_parked_in_another_order(was, is, index)
        && rest_agrees(&was[index + count..], &is[index + count..])
    {
        return Some(Verdict::Undecided("axes park in another order".to_owned()));
    }
    let over = |events: &[Event<'_>], other: &[Event<'_>]| {
        index < events.len()
            && is_over_next_hole(events, index, allowed)
            && rest_agrees(&events[index + 1..], &other[index..])
    };
    if over(was, is) || over(is, was) {
        return Some(Verdict::Undecided("a rapid over the next hole".to_owned()));
    }
    let turned = |events: &[Event<'_>], other: &[Event<'_>]| {
        events
            .get(index)
            .is_some_and(|event| is_turned_already(event, allowed) && event.block.words.letters().all(is_rotary))
            && rest_agrees(&events[index + 1..], &other[index..])
    };
    if turned(was, is) || turned(is, was) {
        return Some(Verdict::Undecided("rotary axes to where the plane has them".to_owned()));
    }
    // The retract after it is another one.
    let retracts = usize::from(is.get(index + 1).is_some_and(|event| event.block.effect == Effect::Machine));
    if is_extra_tool_change(is, index)
        && (rest_agrees(&was[index..], &is[index + 1..]) || rest_agrees(&was[index..], &is[index + 1 + retracts..]))
    {
        return Some(Verdict::Undecided("a tool change before another".to_owned()));
    }
    if is_turned_before_tip_control(was, is, index, allowed) && rest_agrees(&was[index + 1..], &is[index + 1..]) {
        return Some(Verdict::Undecided("a rotary axis that is free under tip control".to_owned()));
    }
    let moved = |one: &[Event<'_>], other: &[Event<'_>]| {
        let Some((first, one)) = one.get(index..).and_then(<[_]>::split_first) else { return false };
        let hard = |(one, other): (&Event<'_>, &Event<'_>)| matches!(difference(one, other, allowed), Some(Hard(_)));
        let other = &other[index.min(other.len())..];
        let place = one.iter().zip(other).position(hard).unwrap_or(one.len().min(other.len()));
        is_short(first, allowed)
            && other.get(place).is_some_and(|event| is_short(event, allowed))
            && rest_agrees(&one[place..], &other[place + 1..])
    };
    if moved(was, is) || moved(is, was) {
        return Some(Verdict::Undecided("a motion within tolerance, elsewhere".to_owned()));
    }
    let ends =
        |events: &[Event<'_>]| matches!(&events[index.min(events.len())..], [end] if end.block.effect == Effect::End);
    if ends(was) && is.len() == index {
        return Some(Verdict::Undecided("the end of the file ends the program".to_owned()));
    }
    let still = |events: &[Event<'_>]| !events.iter().any(|event| event.block.effect.moves());
    if [was, is].iter().all(|events| still(&events[index.min(events.len())..])) && is_of_shop(was, index, is) {
        return Some(Verdict::Undecided("a code of the shop after the last motion".to_owned()));
    }
    // The first block that differs may come after one that lies on the same line.
    for index in [Some(index), index.checked_sub(1)].into_iter().flatten() {
        if index < was.len() && on_the_line(was, index, allowed) && rest_agrees(&was[index + 1..], &is[index..]) {
            return Some(Verdict::Undecided("a point on a line is left out".to_owned()));
        }
        if index < is.len() && on_the_line(is, index, allowed) && rest_agrees(&was[index..], &is[index + 1..]) {
            return Some(Verdict::Undecided("a point on a line is added".to_owned()));
        }
    }
    None
}

/// Whether a motion to machine coordinates follows another, with no motion between them.
fn is_retracted_further(events: &[Event<'_>], index: usize) -> bool {
    let retract = |event: &Event<'_>| event.block.effect == Effect::Machine;
    let before = events.get(..index).unwrap_or_default().iter().rev().find(|event| event.block.effect.moves());
    events.get(index).is_some_and(retract) && before.is_some_and(retract)
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

/// Whether only rotary axes rotate under tip control, and the tool axis is where it was.
fn rotates_freely(event: &Event<'_>, allowed: Allowed) -> bool {
    let axes = [event.before, &event.block.state].map(|state| allowed.tool_axis.and_then(|axis| axis(&state.position)));
    event.before.under_tip_control()
        && !event.block.words.is_empty()
        && event.block.words.letters().all(is_rotary)
        && is_near(axes)
}

/// Whether an arc of `one` is two arcs of `two` about the same centre.
fn is_arc_in_parts(one: &[Event<'_>], two: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let (Some(whole), Some(parts)) = (one.get(index), two.get(index..index + 2)) else { return false };
    let (Effect::Arc(arc), Effect::Arc(first), Effect::Arc(second)) =
        (whole.block.effect, parts[0].block.effect, parts[1].block.effect)
    else {
        return false;
    };
    let centred =
        |part: &Arc| arc.centre.iter().zip(&part.centre).all(|(one, two)| (one - two).abs() <= allowed.linear);
    let sweep = first.sweep_deg + second.sweep_deg;
    let same = Event { block: &Executed { effect: Effect::Arc(arc), ..*parts[1].block }, ..parts[1] };
    centred(&first)
        && centred(&second)
        && first.sweep_deg * second.sweep_deg > 0.0
        && (sweep - arc.sweep_deg).abs() < 1.0
        && !matches!(difference(whole, &same, allowed), Some(Hard(_)))
}

/// Whether a tool change brings the tool that is in the spindle, or is followed by another, before anything but retracts.
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
    let stop = |event: &&Event<'_>| matches!(event.block.effect, Effect::ToolChange(_));
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

/// Whether a rapid ends over the next hole, and the cycle alone would bring the tool there above its reference level.
fn is_over_next_hole(events: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let Some([rapid, next]) = events.get(index..index + 2) else { return false };
    let Effect::Hole(hole) = next.block.effect else { return false };
    let near = |letter| match [rapid, next].map(|event| event.block.state.position.get(letter)) {
        [Some(one), Some(two)] => (one - two).abs() <= allowed.linear,
        _ => false,
    };
    let above = |state: &State| state.position.get('Z').is_some_and(|z| z >= hole.cycle.reference - allowed.linear);
    matches!(rapid.block.effect, Effect::Rapid | Effect::Feed)
        && !rapid.block.words.letters().any(is_rotary)
        && near('X')
        && near('Y')
        && above(rapid.before)
        && above(&rapid.block.state)
}

/// Whether one of two blocks is a code of the shop.
fn is_of_shop(one: &[Event<'_>], index: usize, two: &[Event<'_>]) -> bool {
    [one, two].iter().any(|events| events.get(index).is_some_and(|event| matches!(event.block.effect, Effect::Shop(_))))
}

/// Whether a rapid of `one` in X and Y, or of rotary axes, is two rapids of `two`.
fn is_split(one: &[Event<'_>], two: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let (Some(whole), Some(parts)) = (one.get(index), two.get(index..index + 2)) else { return false };
    let level = |event: &Event<'_>| {
        let letters = || event.block.words.letters();
        event.block.effect == Effect::Rapid && letters().all(|letter| matches!(letter, 'X' | 'Y') || is_rotary(letter))
    };
    let ends = |letter| match [whole, &parts[1]].map(|event| event.block.state.position.get(letter)) {
        [Some(one), Some(two)] => (one - two).abs() <= allowed.linear,
        _ => false,
    };
    let part = |letter| match [whole, &parts[0]].map(|event| event.block.state.position.get(letter)) {
        [Some(one), Some(two)] => (one - two).abs() <= allowed.linear,
        _ => false,
    };
    let partly = parts[0].block.words.letters().all(part);
    partly && level(whole) && parts.iter().all(level) && whole.block.words.letters().all(ends)
}

/// Whether a straight motion ends on the straight line between the positions before it and after the next motion.
fn on_the_line(events: &[Event<'_>], index: usize, allowed: Allowed) -> bool {
    let Some(next) = events.get(index + 1) else { return false };
    let this = &events[index];
    let alike =
        matches!((this.block.effect, next.block.effect), (Effect::Rapid, Effect::Rapid) | (Effect::Feed, Effect::Feed));
    if !alike || this.block.feed() != next.block.feed() || state_difference(this, next, allowed).is_some() {
        return false;
    }
    let [from, here, to] = [&this.before.position, &this.block.state.position, &next.block.state.position];
    let mut ratio = 0.0;
    let mut longest = 0.0_f64;
    let mut moved = Vec::new();
    for letter in here.letters() {
        let [Some(from), Some(here), Some(to)] = [from, here, to].map(|axes| axes.get(letter)) else { return false };
        moved.push((letter, from, here, to));
        // The rotary axes need not be even.
        let travel = (to - from).abs() * if is_rotary(letter) { 1e-6 } else { 1.0 };
        if travel > longest {
            longest = travel;
            ratio = (here - from) / (to - from);
        }
    }
    longest > 0.0
        && (0.0..=1.0).contains(&ratio)
        && moved.iter().all(|(letter, from, here, to)| {
            let off = (from + ratio * (to - from) - here).abs();
            off <= if is_rotary(*letter) { allowed.rotary_deg } else { allowed.linear }
        })
}
