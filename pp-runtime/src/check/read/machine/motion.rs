//! Motions: where the axes of a block go, and by what action.

use std::f64::consts::TAU;

use super::super::super::policy::RolloverRule;
use super::super::block::{Action, Block, CycleKind, CycleMove, Fault, Length, MAX_AXES, TipControl, set_bits};
use super::super::draft::{Code, Draft, fault};
use super::Interpreter;
use super::arc;
use crate::check::tolerances::{ROLLOVER_NOISE, SAME_ROTARY_WORD};

impl Interpreter {
    pub(super) fn motion(&mut self, draft: &Draft, block: &mut Block) -> Action {
        // Under tip control a block may turn the tool axis alone.
        let turns = draft.vector_written != 0 && self.state.tip_control != TipControl::Off;
        if draft.reference {
            return self.reference(draft, block);
        }
        if draft.end_of_travel {
            return self.end_of_travel(draft, block);
        }
        if draft.written == 0 && !turns {
            if draft.call {
                return self.hole(&mut block.faults);
            }
            // A code or a word of the cycle alone drills where the tool is.
            if self.modal == Some(Code::Cycle) && draft.define.is_some() {
                return self.hole(&mut block.faults);
            }
            if draft.machine {
                fault(&mut block.faults, 0, "machine coordinates without an axis word");
            }
            if self.facts.motion_codes_execute {
                self.code_alone(draft, &mut block.faults);
            }
            return self.still(draft, &mut block.faults);
        }
        if draft.machine {
            return self.machine_block(draft, block);
        }
        let rotary = draft.written & self.rotary;
        if draft.vector_written != 0 && rotary != 0 {
            fault(&mut block.faults, 0, "rotary words together with a tool axis");
        }
        let Some(code) = self.modal else {
            fault(&mut block.faults, 0, "axis words, but no motion code is active");
            return Action::Nothing;
        };
        let from = (self.values, self.known);
        self.place(draft, code == Code::Cycle, &mut block.faults);
        self.left_plane(rotary, from);
        match code {
            Code::None => {
                fault(&mut block.faults, 0, "axis words, but no motion code is active");
                Action::Nothing
            }
            Code::Cycle => self.hole(&mut block.faults),
            Code::Rapid if draft.call => self.hole(&mut block.faults),
            Code::Rapid => Action::Rapid,
            _ if draft.call => {
                fault(&mut block.faults, 0, "a cycle runs at the end of this motion, which is no rapid");
                self.hole(&mut block.faults)
            }
            Code::Feed => Action::Feed,
            Code::RigidTap => self.rigid_tap(draft, from.0, &mut block.faults),
            Code::Clockwise | Code::CounterClockwise => match arc::of(draft, self, from, code == Code::Clockwise) {
                Ok(arc) => Action::Arc(arc),
                Err(text) => {
                    fault(&mut block.faults, 0, text);
                    Action::Feed
                }
            },
        }
    }

    /// A motion code without axis words where it is executed all the same.
    pub(super) fn code_alone(&self, draft: &Draft, faults: &mut Vec<Fault>) {
        match draft.code {
            Some(Code::Feed) if self.state.feed.is_none() => fault(faults, 0, "G1 while no F is in force"),
            Some(Code::Clockwise | Code::CounterClockwise) if draft.centre_written == 0 => {
                fault(faults, 0, "an arc without its words");
            }
            _ => {}
        }
    }

    /// A block without axes: only a full circle moves.
    fn still(&mut self, draft: &Draft, faults: &mut Vec<Fault>) -> Action {
        if draft.centre_written != 0
            && let Some(code @ (Code::Clockwise | Code::CounterClockwise)) = self.modal
        {
            return match arc::of(draft, self, (self.values, self.known), code == Code::Clockwise) {
                Ok(arc) => Action::Arc(arc),
                Err(text) => {
                    fault(faults, 0, text);
                    Action::Nothing
                }
            };
        }
        Action::Nothing
    }

    /// Rotary words that have moved their axes take them out of the tilted plane.
    pub(super) fn left_plane(&mut self, rotary: u16, (from, known): ([f64; MAX_AXES], u16)) {
        let Some(tilt) = &mut self.state.tilt else { return };
        let moved =
            |index: usize| known & (1 << index) == 0 || (self.values[index] - from[index]).abs() > SAME_ROTARY_WORD;
        if (0..self.axes.len()).any(|index| rotary & (1 << index) != 0 && moved(index)) {
            tilt.oriented = false;
        }
    }

    /// Takes the words of a block as machine coordinates, or as distances from the position.
    fn words(&self, draft: &Draft, block: &mut Block) {
        let unit = self.unit();
        for index in (0..self.axes.len()).filter(|index| draft.written & (1 << index) != 0) {
            let value = draft.axes[index];
            block.values[index] = if self.axes[index].rotary { value.to_radians() } else { value * unit };
        }
    }

    /// To the reference position: the axes of the block through the point of their words, all axes if there is none.
    fn reference(&mut self, draft: &Draft, block: &mut Block) -> Action {
        block.values = self.values;
        self.words(draft, block);
        if self.state.incremental == Some(true) {
            for index in (0..self.axes.len()).filter(|index| draft.written & (1 << index) != 0) {
                if block.values[index] != 0.0 && self.known & (1 << index) == 0 {
                    fault(&mut block.faults, 0, "incremental motion from an unknown position");
                }
                block.values[index] += self.values[index];
            }
        }
        if draft.written == 0 {
            block.written = (1 << self.axes.len()) - 1;
        }
        self.known &= !block.written;
        if block.written & self.rotary != 0
            && let Some(tilt) = &mut self.state.tilt
        {
            tilt.oriented = false;
        }
        let z = self.linear[2].map_or(0, |z| 1 << z);
        if self.facts.reference_cancels_length && block.written & z != 0 {
            self.state.length = Some(Length::Off);
        }
        let distances = self.state.incremental == Some(true) && draft.absolute & draft.written == 0;
        let still = |index: usize| draft.written & (1 << index) == 0 || draft.axes[index] == 0.0;
        Action::Reference { direct: draft.written != 0 && distances && (0..MAX_AXES).all(still) }
    }

    /// The tool axis to the end of its travel.
    fn end_of_travel(&mut self, draft: &Draft, block: &mut Block) -> Action {
        if draft.written != 0 {
            fault(&mut block.faults, 0, "axis words together with the retract along the tool axis");
        }
        // A tool call names the axis; which tool it was may be unknown after blocks that may be skipped.
        let Some(axis) = self.normal() else {
            fault(&mut block.faults, 0, "retract along the tool axis before a tool call, which names this axis");
            return Action::Nothing;
        };
        block.values = self.values;
        block.written = 1 << axis;
        self.known &= !block.written;
        Action::EndOfTravel
    }

    fn machine_block(&mut self, draft: &Draft, block: &mut Block) -> Action {
        self.words(draft, block);
        self.known &= !draft.written;
        if draft.written & self.rotary != 0
            && let Some(tilt) = &mut self.state.tilt
        {
            tilt.oriented = false;
        }
        if self.modal != Some(Code::Rapid) {
            fault(&mut block.faults, 0, "machine coordinates in a feed motion");
        }
        if self.state.incremental == Some(true) || draft.incremental & draft.written != 0 {
            fault(&mut block.faults, 0, "machine coordinates in incremental mode");
        }
        Action::Machine
    }

    /// Where the axes stand.
    pub(super) fn position(&self) -> [f64; MAX_AXES] {
        self.values
    }

    /// Position of the axis along the normal of the plane.
    pub(super) fn normal(&self) -> Option<usize> {
        let [_, _, normal] = self.state.plane?.axes();
        self.linear[normal]
    }

    /// Puts the axes where their words say.
    pub(super) fn place(&mut self, draft: &Draft, cycle: bool, faults: &mut Vec<Fault>) {
        // In a cycle the word along the normal is the bottom of the hole.
        let bottom = if cycle { self.normal().map_or(0, |normal| 1 << normal) } else { 0 };
        let distances = draft.incremental | if self.state.incremental == Some(true) { !draft.absolute } else { 0 };
        let rolls_over = if self.has_rollover || self.state.shortest { self.rotary } else { 0 };
        let (placed, unit) = (draft.written & !bottom, self.unit());
        let relative = placed & (distances | rolls_over);
        if relative != 0 {
            self.place_relative(draft, relative, distances, faults);
        }
        for index in set_bits(placed & !relative) {
            self.values[index] = self.value(index, draft, unit);
        }
        self.known |= placed;
    }

    /// Puts the axes whose ends depend on where they are: words are distances, or the control chooses the way.
    #[inline(never)]
    fn place_relative(&mut self, draft: &Draft, relative: u16, distances: u16, faults: &mut Vec<Fault>) {
        let unit = self.unit();
        for index in set_bits(relative) {
            let (bit, value) = (1 << index, self.value(index, draft, unit));
            self.values[index] = if distances & bit != 0 {
                self.farther(index, value, faults)
            } else {
                self.turned(index, value, faults)
            };
        }
    }

    /// Value of a word, mm or rad.
    #[inline]
    fn value(&self, index: usize, draft: &Draft, unit: f64) -> f64 {
        let word = draft.axes[index];
        if self.rotary & (1 << index) != 0 { word.to_radians() } else { word * unit }
    }

    /// Value of an axis after a word that is a distance.
    fn farther(&self, index: usize, by: f64, faults: &mut Vec<Fault>) -> f64 {
        if self.known & (1 << index) == 0 {
            fault(faults, 0, "incremental motion from an unknown position");
        }
        self.values[index] + by
    }

    /// Where a rotary axis ends whose word says `value`, on a control that chooses the way there.
    fn turned(&self, index: usize, value: f64, faults: &mut Vec<Fault>) -> f64 {
        // Where the set-up says which axes roll over, the short way is for these.
        let any = if self.state.shortest && !self.has_rollover { Some(RolloverRule::Shortest) } else { None };
        let wrap = self.axes[index].rollover.or(any);
        let Some(wrap) = wrap else { return value };
        if self.known & (1 << index) == 0 {
            // Its sign is the way there, not the place.
            return if wrap == RolloverRule::Sign { value.abs() } else { value };
        }
        let from = self.values[index];
        match wrap {
            RolloverRule::Sign => {
                let forward = (value.abs() - from).rem_euclid(TAU);
                // What is already there does not turn, whatever its rounding.
                let forward = if TAU - forward < ROLLOVER_NOISE { 0.0 } else { forward };
                // The sign is that of the word, also of -0.
                if forward < ROLLOVER_NOISE || value.is_sign_positive() { from + forward } else { from + forward - TAU }
            }
            RolloverRule::Shortest => {
                let way = (value - from + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
                if TAU / 2.0 - way.abs() < ROLLOVER_NOISE {
                    fault(faults, 0, "rotary motion of exactly 180°: the control may rotate in either direction");
                }
                from + way
            }
        }
    }

    /// The hole of the cycle that is defined, where the axes stand.
    fn hole(&mut self, faults: &mut Vec<Fault>) -> Action {
        let (Some(cycle), Some(normal)) = (self.cycle, self.normal()) else {
            fault(faults, 0, "cycle call without a cycle definition, or without a working plane");
            return Action::Nothing;
        };
        if cycle.back_to.is_none() && self.state.to_initial.is_none() {
            fault(
                faults,
                0,
                "neither G98 nor G99 has been programmed since the complete state: where the cycle returns to is unknown",
            );
        }
        let modal = if self.state.to_initial == Some(false) { Some(cycle.reference) } else { self.initial };
        let back_to = cycle.back_to.or(modal).unwrap_or_else(|| {
            fault(faults, 0, "the cycle returns to the level before it, which is unknown");
            cycle.reference
        });
        let back_to = back_to.max(cycle.reference);
        self.values[normal] = back_to;
        self.known |= 1 << normal;
        Action::Cycle(CycleMove {
            kind: cycle.kind,
            reference: cycle.reference,
            bottom: cycle.bottom,
            back_to,
            dwell: cycle.dwell,
            feed: cycle.feed,
            gap: cycle.gap,
        })
    }

    /// G33.1 to a depth along the normal; it comes back to where it began.
    fn rigid_tap(&mut self, draft: &Draft, from: [f64; MAX_AXES], faults: &mut Vec<Fault>) -> Action {
        let (Some(pitch), Some(normal)) = (draft.pitch, self.normal()) else {
            fault(faults, 0, "thread without a pitch, or without a working plane");
            return Action::Nothing;
        };
        if draft.written & !(1 << normal) != 0 {
            fault(
                faults,
                0,
                "G33.1 with a word other than that of the tool axis: the thread would be cut on the way there",
            );
        }
        let bottom = self.values[normal];
        self.values = from;
        self.modal = None;
        let back_to = from[normal];
        let left = matches!(self.state.spindle, Some(Some(crate::program::Rotation::CounterClockwise)));
        let pitch = pitch * self.unit() * if left { -1.0 } else { 1.0 };
        let kind = CycleKind::Tap(pitch);
        Action::Cycle(CycleMove { kind, reference: back_to, bottom, back_to, dwell: 0.0, feed: None, gap: None })
    }
}
