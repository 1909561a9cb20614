//! The blocks of a trace that do something.

use super::name_of;
use crate::foreign::axes::{Axes, is_rotary};
use crate::foreign::state::{Length, State};
use crate::foreign::{Effect, Executed, Trace};

/// A block that does something, with the state before it.
#[derive(Clone, Copy)]
pub(super) struct Event<'a> {
    pub before: &'a State,
    pub block: &'a Executed,
    pub shop: Shop,
    /// Words of the rotary axes that were written last.
    pub rotary: Axes,
}

/// Things that codes of the shop switch, `true` for on; `None` before the program has set it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Shop {
    /// The clamps of M10 and M11, and of M68 and M69.
    pub clamps: [Option<bool>; 2],
    /// M83 and M84, M88 and M89 (M85 on Heidenhain), M7 and M9.
    pub supplies: [Option<bool>; 3],
}

impl Shop {
    /// Obeys a code; `false` if it switches nothing that is known here.
    fn obey(&mut self, code: u32) -> bool {
        let (thing, on) = match code {
            10 | 11 => (&mut self.clamps[0], code == 10),
            68 | 69 => (&mut self.clamps[1], code == 68),
            83 | 84 => (&mut self.supplies[0], code == 83),
            85 | 88 | 89 => (&mut self.supplies[1], code == 88),
            7 => (&mut self.supplies[2], true),
            _ => return false,
        };
        *thing = Some(on);
        true
    }
}

/// Blocks that do something, and as text those that do it again, and what switches a thing of the shop.
pub(super) fn events<'a>(trace: &'a Trace, start: &'a State) -> (Vec<Event<'a>>, Vec<String>) {
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
        // With another length the axis may move (Fanuc and Haas).
        let is_register = |state: &State| matches!(state.length, Some(Length::Register(_)));
        let left = is_register(was) && before.length.is_some() && was.position.contains('Z');
        if (left || is_register(before)) && was.length != before.length && !block.effect.moves() {
            again.push(format!("{:?}", before.length));
        }
        if before.spindle != was.spindle || matches!(block.effect, Effect::Spindle(_)) {
            again.push(format!("{:?} after {} actions", before.spindle, events.len()));
        }
        match block.effect {
            Effect::Coolant { off: true } => {
                shop.supplies[2] = shop.supplies[2].map(|_| false);
            }
            Effect::Modal | Effect::Safety | Effect::Length(_) | Effect::Spindle(_) | Effect::Coolant { .. } => {}
            // What it switches is compared where it matters, in the blocks that follow.
            Effect::Shop(code) if shop.obey(code) => again.push(format!("M{code} after {} actions", events.len())),
            // The order of these and a retract does not matter.
            Effect::Shop(_) | Effect::Stop | Effect::OptionalStop | Effect::Guard { .. } | Effect::OffsetGuard => {
                if block.effect.stops() {
                    rotary = Axes::default();
                }
                let later = events.iter().rev().take_while(|last| is_later(last, &event)).count();
                again.push(format!("{} before {later} actions", name_of(&block.effect)));
                events.insert(events.len() - later, event);
            }
            Effect::Rapid if is_settled(&event) => again.push(format!("{:?} {:?}", block.words, block.state)),
            // After a stop in between the retract is repeated.
            Effect::Machine if repeats(&events, &event) => {
                again.push(format!("{:?} {:?} {:?}", block.words, before, block.state));
            }
            effect if stays(&event) => {
                let place = events.len();
                again.push(format!("{} {:?} {:?} after {place} actions", name_of(&effect), block.words, block.state));
            }
            _ => events.push(event),
        }
    }
    (events, again)
}

/// Whether an action may as well come after a stop, a guard or a code of the shop that follows it.
fn is_later(action: &Event<'_>, next: &Event<'_>) -> bool {
    // A guard that names its register compares the same before the tool change.
    let guards = matches!(next.block.effect, Effect::Guard { .. }) && next.block.state.guarded.is_some();
    let again = matches!(action.block.effect, Effect::ToolChange(tool) if action.before.tool == Some(tool));
    // At the retract a rotary axis may rotate before a stop, or a code that switches nothing that is known here.
    let retracted = action.before.position.letters().all(is_rotary);
    let rotary = !action.block.words.is_empty() && action.block.words.letters().all(is_rotary);
    let rotates = action.block.effect == Effect::Rapid && retracted && rotary;
    matches!(action.block.effect, Effect::Machine | Effect::Dwell(_))
        || rotates && (next.block.effect.stops() || matches!(next.block.effect, Effect::Shop(_)))
        || matches!(action.block.effect, Effect::Guard { .. } | Effect::OffsetGuard)
            && matches!(next.block.effect, Effect::Shop(_))
        || again && matches!(next.block.effect, Effect::Shop(_))
        || guards && matches!(action.block.effect, Effect::ToolChange(_))
}

/// Whether a rapid brings rotary axes to the words that were written last: a plane has rotated them there as well.
fn is_settled(event: &Event<'_>) -> bool {
    let position = event.block.state.position;
    let at = |letter: char| is_rotary(letter) && position.get(letter) == event.rotary.get(letter);
    let mut letters = event.block.words.letters().peekable();
    letters.peek().is_some() && letters.all(at)
}

/// Whether a motion to machine coordinates goes where the one before it went, with nothing but stops between them.
fn repeats(events: &[Event<'_>], event: &Event<'_>) -> bool {
    let still = |event: &&Event<'_>| event.block.effect.stops() || matches!(event.block.effect, Effect::Dwell(_));
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
