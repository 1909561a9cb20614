//! Harm of an edit: the traces of two programs, compared.
//!
//! Harmful: another motion, another state in a cut, a wait, a guard or a stop that is missing or changed. Harmless: the
//! same motions in the same states, in the same order. Between the two are deviations within tolerance and rounding,
//! and states that differ only where nothing is cut.

use crate::foreign::axes::{Axes, is_rotary};
use crate::foreign::state::{Compensation, Cycle, CycleKind, Length, PathMode, Plane, SMOOTHING, State, TiltedPlane};
use crate::foreign::trace::{Arc, Hole};
use crate::foreign::{Effect, Executed, Feed, Refused, Trace};

/// Tool axis on the workpiece for the positions of the rotary axes, degrees; `None` where one of them is unknown.
pub type ToolAxis = fn(&Axes) -> Option<[f64; 3]>;

/// What is not harmful for certain.
#[derive(Debug, Clone, Copy)]
pub struct Allowed {
    /// Linear axes, in the unit of the program.
    pub linear: f64,
    /// Rotary axes, degrees.
    pub rotary_deg: f64,
    /// Rotary axes may roll over, so that whole revolutions make no difference.
    pub wraps: bool,
    /// Where words under tip control are coordinates of the tip on the workpiece: the tool axis, which decides whether a
    /// rotary axis is free.
    pub tool_axis: Option<ToolAxis>,
    /// A control that is switched on is in continuous path mode.
    pub starts_continuous: bool,
    /// Letters of the axes with the clamp of M10 and M11, and with that of M68 and M69.
    pub clamped: [Option<char>; 2],
}

/// Harm of an edit.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// The control does something else.
    Harmful(String),
    /// The control stops, or the code is unknown.
    Refused(String),
    /// Deviations within tolerance, or other states where nothing is cut.
    Undecided(String),
    /// The control does the same.
    Harmless,
}

/// Difference between two blocks.
enum Difference {
    Hard(String),
    Soft(String),
}

use Difference::{Hard, Soft};

/// A block that does something, with the state before it.
#[derive(Clone, Copy)]
struct Event<'a> {
    before: &'a State,
    block: &'a Executed,
    shop: Shop,
    /// Words of the rotary axes that were written last.
    rotary: Axes,
}

/// Things that codes of the shop switch, `true` for on; `None` before the program has set it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Shop {
    /// The clamps of M10 and M11, and of M68 and M69.
    clamps: [Option<bool>; 2],
    /// M83 and M84, M88 and M89, M7 and M9.
    supplies: [Option<bool>; 3],
}

impl Shop {
    /// Obeys a code; `false` if it switches nothing that is known here.
    fn obey(&mut self, code: u32) -> bool {
        let (thing, on) = match code {
            10 | 11 => (&mut self.clamps[0], code == 10),
            68 | 69 => (&mut self.clamps[1], code == 68),
            83 | 84 => (&mut self.supplies[0], code == 83),
            88 | 89 => (&mut self.supplies[1], code == 88),
            7 => (&mut self.supplies[2], true),
            _ => return false,
        };
        *thing = Some(on);
        true
    }
}

/// Compares the trace of an edited program with that of the original.
#[must_use]
pub fn verdict(original: &Trace, edited: &Result<Trace, Refused>, allowed: Allowed) -> Verdict {
    let edited = match edited {
        Ok(trace) => trace,
        Err(refused) => return Verdict::Refused(refused.to_string()),
    };
    let start = State::default();
    let ((was, was_again), (is, is_again)) = (events(original, &start), events(edited, &start));
    let mut soft = (was_again != is_again).then(|| "a motion to where the axes are".to_owned());
    for (index, (one, other)) in was.iter().zip(&is).enumerate() {
        match difference(one, other, allowed) {
            Some(Hard(why)) => return removed(&was, &is, index, allowed).unwrap_or(Verdict::Harmful(at(other, &why))),
            Some(Soft(why)) => soft = soft.or_else(|| Some(at(other, &why))),
            None => {}
        }
    }
    if edited.blocks.last().map(|block| &block.effect) != original.blocks.last().map(|block| &block.effect) {
        soft = soft.or_else(|| Some("the last block".to_owned()));
    }
    if was.len() != is.len() {
        let index = was.len().min(is.len());
        let why = format!("{} actions became {}", was.len(), is.len());
        return removed(&was, &is, index, allowed).unwrap_or(Verdict::Harmful(why));
    }
    soft.map_or(Verdict::Harmless, Verdict::Undecided)
}

/// Whether a program that is harmless from its beginning is another one from a restart point.
///
/// `entered` gives the trace from the restart point with a number.
#[must_use]
pub fn restarts_differ(
    traces: [&Trace; 2],
    entered: impl Fn(bool, usize) -> Result<Trace, Refused>,
    allowed: Allowed,
) -> bool {
    let [original, edited] = traces;
    let [before, after] = [original, edited].map(|trace| trace.restarts().count());
    before != after
        || (0..before).any(|number| match entered(false, number) {
            Ok(trace) => verdict(&trace, &entered(true, number), allowed) != Verdict::Harmless,
            Err(_) => false,
        })
}

fn at(event: &Event<'_>, why: &str) -> String {
    format!("line {}: {why}", event.block.line)
}

/// Blocks that do something, and as text those that do it again, and what switches a thing of the shop.
fn events<'a>(trace: &'a Trace, start: &'a State) -> (Vec<Event<'a>>, Vec<String>) {
    let (mut events, mut again) = (Vec::<Event<'a>>::new(), Vec::new());
    let mut before = start;
    let (mut shop, mut rotary) = (Shop::default(), Axes::default());
    for block in &trace.blocks {
        let event = Event { before, block, shop, rotary };
        if matches!(block.effect, Effect::ToolChange(_) | Effect::Home(_)) {
            rotary = Axes::default();
        }
        for (letter, value) in block.state.position.iter().filter(|(letter, _)| is_rotary(*letter)) {
            if block.words.contains(letter) {
                rotary.set(letter, value);
            }
        }
        let was = before;
        before = &block.state;
        // Without the length the axis may move (Fanuc and Haas).
        if matches!((was.length, before.length), (Some(Length::Register(_)), Some(_)))
            && was.length != before.length
            && !block.effect.moves()
            && was.position.contains('Z')
        {
            again.push("G49".to_owned());
        }
        if before.spindle != was.spindle {
            again.push(format!("{:?} after {} actions", before.spindle, events.len()));
        }
        match block.effect {
            Effect::Coolant { off: true } => {
                shop.supplies[2] = shop.supplies[2].map(|_| false);
            }
            Effect::Modal | Effect::Safety | Effect::Length(_) | Effect::Spindle(_) | Effect::Coolant { .. } => {}
            // What it switches is compared where it matters, in the blocks that follow.
            Effect::Shop(code) if shop.obey(code) => again.push(format!("M{code} after {} actions", events.len())),
            Effect::Shop(code) => {
                // The order of a code and a retract does not matter.
                let later = |event: &&Event<'_>| event.block.effect == Effect::Machine;
                let later = events.iter().rev().take_while(later).count();
                again.push(format!("M{code} before {later} actions"));
                events.insert(events.len() - later, event);
            }
            Effect::Stop | Effect::OptionalStop => {
                rotary = Axes::default();
                let retract = |event: &&Event<'_>| event.block.effect == Effect::Machine;
                let later = events.iter().rev().take_while(retract).count();
                again.push(format!("a stop before {later} retracts"));
                events.insert(events.len() - later, event);
            }
            Effect::Guard { .. } => {
                // One that names its register compares the same before the tool change.
                let named = block.state.guarded.is_some();
                let retract = |event: &&Event<'_>| {
                    event.block.effect == Effect::Machine
                        || named && matches!(event.block.effect, Effect::ToolChange(_))
                };
                let later = events.iter().rev().take_while(retract).count();
                again.push(format!("a guard before {later} retracts"));
                events.insert(events.len() - later, event);
            }
            Effect::Rapid if is_settled(&event) => again.push(format!("{:?} {:?}", block.words, block.state)),
            // After a stop in between the retract is repeated.
            Effect::Machine if repeats(&events, &event) => {
                again.push(format!("{:?} {:?} {:?}", block.words, before, block.state));
            }
            effect if stays(&event) => {
                again.push(format!("{} {:?} {:?}", name(&effect), block.words, block.state));
            }
            _ => events.push(event),
        }
    }
    (events, again)
}

/// Whether a rapid brings rotary axes to the words that were written last: a plane has rotated them there as well.
fn is_settled(event: &Event<'_>) -> bool {
    let position = event.block.state.position;
    let at = |letter: char| is_rotary(letter) && position.get(letter) == event.rotary.get(letter);
    event.block.words.letters().all(at)
}

/// Whether a motion to machine coordinates goes where the one before it went, with nothing but stops between them.
fn repeats(events: &[Event<'_>], event: &Event<'_>) -> bool {
    let still =
        |event: &&Event<'_>| matches!(event.block.effect, Effect::Stop | Effect::OptionalStop | Effect::Dwell(_));
    events.iter().rev().find(|event| !still(event)).is_some_and(|last| {
        let place = |letter| last.block.state.machine.get(letter) == event.block.state.machine.get(letter);
        last.block.effect == Effect::Machine
            && last.block.words.letters().eq(event.block.words.letters())
            && event.block.words.letters().all(place)
    })
}

/// Whether a motion ends where it begins.
fn stays(event: &Event<'_>) -> bool {
    let (before, after) = (event.before, &event.block.state);
    let places = match event.block.effect {
        Effect::Rapid | Effect::Feed => [before.position, after.position],
        Effect::Machine => [before.machine, after.machine],
        Effect::Orient => {
            let rotary = |axes: &Axes| axes.letters().any(is_rotary);
            return before.tilted_plane() == after.tilted_plane()
                && before.tilted_plane().is_some_and(|plane| plane.oriented)
                && !rotary(&before.position);
        }
        _ => return false,
    };
    let same = |letter| match places.map(|place| place.get(letter)) {
        [Some(from), Some(to)] => (from - to).abs() < 1e-9,
        _ => false,
    };
    if event.block.effect == Effect::Machine {
        return event.block.words.letters().all(same);
    }
    let frame = |state: &State| (state.work_offset, state.length, state.units, state.under_tip_control());
    event.block.words.letters().all(same)
        && before.vector == after.vector
        && frame(before) == frame(after)
        && before.tilted_plane() == after.tilted_plane()
        && before.compensation == after.compensation
}

/// Whether the traces are the same but for one block on the line between its neighbours.
fn removed(was: &[Event<'_>], is: &[Event<'_>], index: usize, allowed: Allowed) -> Option<Verdict> {
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
    let short = |events: &[Event<'_>], other: &[Event<'_>]| {
        events.get(index).is_some_and(|event| is_short(event, allowed))
            && rest_agrees(&events[index + 1..], &other[index..])
    };
    if short(was, is) || short(is, was) {
        return Some(Verdict::Undecided("a motion within tolerance".to_owned()));
    }
    if let Some(count) = is_parked_in_another_order(was, is, index)
        && rest_agrees(&was[index + count..], &is[index + count..])
    {
        return Some(Verdict::Undecided("axes park in another order".to_owned()));
    }
    if is_stop_at_retract(was, is, index) && rest_agrees(&was[index + 2..], &is[index + 2..]) {
        return Some(Verdict::Undecided("a stop before or after a retract".to_owned()));
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
    if is_extra_tool_change(is, index) && rest_agrees(&was[index..], &is[index + 1..]) {
        return Some(Verdict::Undecided("a tool change before another".to_owned()));
    }
    if is_turned_before_tip_control(was, is, index, allowed) && rest_agrees(&was[index + 1..], &is[index + 1..]) {
        return Some(Verdict::Undecided("a rotary axis that is free under tip control".to_owned()));
    }
    let swapped = |one: &[Event<'_>], other: &[Event<'_>]| {
        one.get(index).is_some_and(|event| is_short(event, allowed))
            && other.get(index + 1).is_some_and(|event| is_short(event, allowed))
            && rest_agrees(&one[index + 1..=index + 1], &other[index..=index])
            && rest_agrees(&one[index + 2..], &other[index + 2..])
    };
    if was.len() > index + 1 && is.len() > index + 1 && (swapped(was, is) || swapped(is, was)) {
        return Some(Verdict::Undecided("a motion within tolerance, in another order".to_owned()));
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

/// Whether a tool change is followed by another, before anything but retracts.
fn is_extra_tool_change(events: &[Event<'_>], index: usize) -> bool {
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
    let near = match [one, other].map(|event| tool_axis(&event.block.state.position)) {
        [Some(one), Some(other)] => one.iter().zip(&other).all(|(one, other)| (one - other).abs() < 1e-6),
        _ => false,
    };
    rapid(one) && rapid(other) && tips(was) && tips(is) && near
}

/// Whether a stop comes before or after a motion to machine coordinates.
fn is_stop_at_retract(was: &[Event<'_>], is: &[Event<'_>], index: usize) -> bool {
    let kinds = |events: &[Event<'_>]| {
        events.get(index..index + 2).map(|pair| [0, 1].map(|at| std::mem::discriminant(&pair[at].block.effect)))
    };
    let stops = |event: Option<&Event<'_>>| {
        event.is_some_and(|event| matches!(event.block.effect, Effect::Stop | Effect::OptionalStop | Effect::Machine))
    };
    match (kinds(was), kinds(is)) {
        (Some([one, two]), Some([three, four])) => {
            one == four && two == three && one != two && stops(was.get(index)) && stops(was.get(index + 1))
        }
        _ => false,
    }
}

/// Whether a rapid brings rotary axes to where they are in the tilted plane, any other rotary axis where it suits best.
fn is_turned_already(event: &Event<'_>, allowed: Allowed) -> bool {
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

/// Whether a straight motion ends where it begins, within tolerance.
fn is_short(event: &Event<'_>, allowed: Allowed) -> bool {
    let short = |letter| match [event.before, &event.block.state].map(|state| state.position.get(letter)) {
        [Some(from), Some(to)] => {
            (from - to).abs() <= if is_rotary(letter) { allowed.rotary_deg } else { allowed.linear }
        }
        _ => false,
    };
    matches!(event.block.effect, Effect::Rapid | Effect::Feed) && event.block.words.letters().all(short)
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
        event.block.effect == Effect::Rapid
            && (letters().all(|letter| matches!(letter, 'X' | 'Y')) || letters().all(is_rotary))
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
        if (to - from).abs() > longest {
            longest = (to - from).abs();
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

fn name(effect: &Effect) -> &'static str {
    super::places::name_of(effect)
}

fn difference(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let (one, other) = (&was.block.effect, &is.block.effect);
    let (old, new) = (&was.block.state, &is.block.state);
    if std::mem::discriminant(one) != std::mem::discriminant(other) {
        return Some(Hard(format!("{} became {}", name(one), name(other))));
    }
    let preselected = soft(old.selected != new.selected, "the selected tool");
    let own = match (one, other) {
        (Effect::Dwell(one), Effect::Dwell(other)) => worst([
            compared("a dwell of", *one, *other, (0.01 * one).max(0.0015)),
            hard(old.spindle != new.spindle, "the spindle in a dwell"),
        ]),
        (Effect::Guard { length, tolerance }, Effect::Guard { length: length_now, tolerance: now }) => worst([
            compared("the length of a guard,", *length, *length_now, 1e-6),
            hard(*now > tolerance + 1e-6, "the tolerance of a guard"),
            soft(*now < tolerance - 1e-6, "a guard that is stricter"),
            hard(old.guarded != new.guarded, "the register of a guard"),
            // A guard that names its register compares the same everywhere.
            hard(
                old.guarded.is_none() && (old.tool, old.length) != (new.tool, new.length),
                "tool or length offset at a guard",
            ),
        ]),
        (Effect::ToolChange(one), Effect::ToolChange(other)) => hard(one != other, "the tool"),
        (Effect::Shop(one), Effect::Shop(other)) => hard(one != other, "the code of the shop"),
        (Effect::Stop | Effect::OptionalStop | Effect::End, _) => None,
        _ => worst([
            effect_difference(one, other, old, allowed),
            moved(was, is, allowed),
            state_difference(was, is, allowed),
        ]),
    };
    worst([own, preselected, shop_difference(was, is, allowed), other_state(was, is)])
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
        (state.plane, state.feed_mode, side(state), state.length, state.work_offset, state.tilted_plane().is_some())
    });
    worst([
        soft(process, "spindle or coolant where nothing is cut"),
        soft(frame != frame_now, "a mode where nothing is cut"),
    ])
}

fn effect_difference(one: &Effect, other: &Effect, state: &State, allowed: Allowed) -> Option<Difference> {
    match (one, other) {
        (Effect::Arc(one), Effect::Arc(other)) => arc_difference(one, other, state, allowed),
        (Effect::Hole(one), Effect::Hole(other)) => hole_difference(one, other, allowed),
        (Effect::Home(one), Effect::Home(other)) => hard(one != other, "the way to the reference point"),
        _ => None,
    }
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
    let letters: Vec<char> = crate::foreign::axes::LETTERS.to_vec();
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
                let whole = ((one - other) / 360.0).round();
                let rolled = if allowed.wraps && is_rotary(letter) { 360.0 * whole } else { 0.0 };
                worst([
                    compared(&format!("{letter} of"), one, other + rolled, largest),
                    soft(rolled.abs() > 1.0, &format!("revolutions of {letter}")),
                    hard(starts, &format!("{letter} cuts from an unknown position")),
                ])
            }
            (Some(one), None) if !cuts && was.rotary.get(letter).is_some_and(|last| (last - one).abs() < 1e-9) => {
                soft(true, "a rotary axis that is not moved")
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
    let vectors = match (old.vector, new.vector) {
        (Some(was), Some(is)) if old.under_tip_control() => {
            worst([0, 1, 2].map(|index| compared("a component of", was[index], is[index], 2e-3)))
        }
        (was, is) if old.under_tip_control() && cuts => hard(was != is, "the tool vector"),
        _ => None,
    };
    let short = is_short(was, allowed) && is_short(is, allowed);
    let feed = match (was.block.feed(), is.block.feed()) {
        (Some(Feed::PerMinute(was)), Some(Feed::PerMinute(is)))
        | (Some(Feed::InverseTime(was)), Some(Feed::InverseTime(is)))
        | (Some(Feed::PerRevolution(was)), Some(Feed::PerRevolution(is)))
            if !short =>
        {
            compared("F", was, is, 0.0101 * was)
        }
        (Some(was), Some(is)) if short => soft(was != is, "F of a motion within tolerance"),
        (was, is) => hard(was != is, "the feed mode"),
    };
    worst(letters.into_iter().map(place).chain([vectors, feed]))
}

/// Whether the tool axis is the same at the end of a motion and half way, although rotary axes differ, and words are
/// coordinates of the tip.
fn is_free(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> bool {
    let Some(tool_axis) = allowed.tool_axis else { return false };
    let tips = |event: &Event<'_>| event.before.under_tip_control() && event.block.state.under_tip_control();
    let middle = |event: &Event<'_>| {
        let (from, to) = (&event.before.position, &event.block.state.position);
        let mut middle = *to;
        for (letter, value) in to.iter().filter(|(letter, _)| is_rotary(*letter)) {
            middle.set(letter, (from.get(letter).unwrap_or(value) + value) / 2.0);
        }
        middle
    };
    let near = |places: [Axes; 2]| match places.map(|place| tool_axis(&place)) {
        [Some(one), Some(other)] => one.iter().zip(&other).all(|(one, other)| (one - other).abs() < 1e-6),
        _ => false,
    };
    tips(was)
        && tips(is)
        && near([was.block.state.position, is.block.state.position])
        && near([middle(was), middle(is)])
}

fn side(state: &State) -> Compensation {
    state.compensation.unwrap_or(Compensation::Off)
}

/// Differences of modal states: those that change where the axes go, and in cuts those of the process.
fn state_difference(was: &Event<'_>, is: &Event<'_>, allowed: Allowed) -> Option<Difference> {
    let (old, new) = (&was.block.state, &is.block.state);
    let tip = (old.under_tip_control(), new.under_tip_control());
    let machine = was.block.effect == Effect::Machine;
    let frame = worst([
        hard(old.units != new.units, "the unit"),
        hard(tip.0 != tip.1, "tip control"),
        hard(!machine && tilt_differs(old.tilted_plane(), new.tilted_plane()), "the tilted plane"),
        hard(tip.0 && old.interpolation != new.interpolation, "the interpolation of the tool axis"),
        hard(tip.0 && old.vector_frame != new.vector_frame, "the frame of vectors"),
        soft(old.tip_control != new.tip_control, "the start of tip control"),
        soft(old.tilted_plane() != new.tilted_plane(), "the tilted plane by little"),
    ]);
    if machine {
        return frame;
    }
    let linear = was.block.effect.cuts() || was.block.words.letters().any(|letter| !is_rotary(letter));
    let across = !tip.0 && old.tilted_plane().is_none() && !was.block.effect.cuts();
    let levels = linear && !(across && was.block.words.letters().all(|letter| letter != 'Z'));
    let rotary = was.block.words.letters().chain(is.block.words.letters()).any(is_rotary);
    let words = worst([
        frame,
        hard(old.work_offset != new.work_offset, "the work offset"),
        hard(old.offset_cleared != new.offset_cleared, "the work offset after TRAORI"),
        hard(levels && old.length != new.length, "the length offset"),
        soft(linear && old.length != new.length, "the length offset of X and Y"),
        hard(rotary && old.rotary_path != new.rotary_path, "shortest path"),
        soft(old.rotary_path != new.rotary_path, "shortest path where no rotary axis moves"),
        hard(linear && side(old) != side(new), "the compensation"),
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
        hard(old.speed != new.speed, "the speed"),
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
                || (was.oriented, was.solution) != (is.oriented, is.solution)
        }
        (was, is) => was.is_some() != is.is_some(),
    }
}
