//! Motions: where the axes of a block go, and by what action.

use std::f64::consts::TAU;

use super::super::block::{Action, Block, BlockFault, Length, set_bits};
use super::super::orders::{ArcWords, Code, ModeOrder, MotionOrder, Orders, WrittenAxisWords, fault};
use super::{Act, Interpreter, arc};
use crate::check::read::{MAX_AXES, RolloverRule};
use crate::check::tolerances::{ROLLOVER_NOISE, SAME_ROTARY_WORD};

impl Interpreter {
    /// A motion by the motion code in force.
    pub(super) fn moving(&mut self, motion: &MotionOrder, block: &mut Block) -> Action {
        let rotary = motion.axes.written & self.axes.rotary;
        let code = match self.motion.code {
            None | Some(Code::None) if motion.axes.written != 0 => {
                fault(&mut block.faults, 0, "axis words, but no motion code is active");
                return Action::Nothing;
            }
            None | Some(Code::None) => return Action::Nothing,
            Some(code) => code,
        };
        let from = (self.values, self.known);
        let call = motion.call || self.motion.each_point.is_some() && motion.axes.written != 0;
        let is_cycle = code == Code::Cycle;
        self.place(&motion.axes, is_cycle, &mut block.faults);
        self.left_plane(rotary, from, &mut block.faults);
        if !is_cycle && self.motion.canned.is_none() {
            self.motion.rigid = false;
        }
        if call {
            if code != Code::Rapid {
                fault(&mut block.faults, 0, "a cycle runs at the end of this motion, which is no rapid");
            }
            if let Some(cycle) = self.motion.each_point {
                self.motion.cycle = Some(cycle);
            }
            return self.hole(&mut block.faults);
        }
        match code {
            Code::Cycle => self.canned_hole(&motion.axes, &mut block.faults),
            Code::Rapid => Action::Rapid,
            Code::Feed => Action::Feed,
            Code::RigidTap => self.rigid_tap(motion, from.0, &mut block.faults),
            Code::Clockwise | Code::CounterClockwise => {
                match arc::of(&motion.arc, self, from, code == Code::Clockwise) {
                    Ok(arc) => Action::Arc(arc),
                    Err(text) => {
                        fault(&mut block.faults, 0, text);
                        if motion.axes.written == 0 { Action::Nothing } else { Action::Feed }
                    }
                }
            }
            Code::None => Action::Nothing,
        }
    }

    /// A motion code without axis words, which some controls execute all the same.
    pub(super) fn code_alone(&self, orders: &Orders, faults: &mut Vec<BlockFault>) {
        let moves = orders.acts.iter().any(|act| match act {
            Act::Move(motion) => motion.axes.written != 0 || motion.arc != ArcWords::default(),
            _ => false,
        });
        if moves || !self.facts.motion_codes_execute {
            return;
        }
        match orders.find(|mode| if let ModeOrder::Motion(code, _) = mode { Some(*code) } else { None }) {
            Some(Code::Feed) if self.state.feed.is_none() => fault(faults, 0, "G1 while no F is in force"),
            Some(Code::Clockwise | Code::CounterClockwise) => fault(faults, 0, "an arc without its words"),
            _ => {}
        }
    }

    /// Rotary words that have moved their axes take them out of the tilted plane, and its zero from under the table.
    fn left_plane(&mut self, rotary: u16, (from, known): ([f64; MAX_AXES], u16), faults: &mut Vec<BlockFault>) {
        let moved =
            |index: usize| known & (1 << index) == 0 || (self.values[index] - from[index]).abs() > SAME_ROTARY_WORD;
        if (self.state.tilt.is_some() || self.state.dynamic_offset) && set_bits(rotary).any(moved) {
            self.rotates(faults);
        }
    }

    /// A rotary axis leaves the frame that was set at its angle.
    fn rotates(&mut self, faults: &mut Vec<BlockFault>) {
        if self.state.dynamic_offset {
            fault(faults, 0, "a rotary axis moves while the dynamic work offset is active");
        }
        if let Some(tilt) = &mut self.state.tilt {
            tilt.oriented = false;
        }
    }

    /// Puts the words of a block as machine coordinates, or as distances from the position, into its values.
    fn put_words(&self, words: &WrittenAxisWords, block: &mut Block) {
        let unit = self.unit();
        for index in set_bits(words.written) {
            block.values[index] = self.value(index, words, unit);
        }
        block.written = words.written;
    }

    /// Axes have left their positions in the program.
    fn lose(&mut self, written: u16, faults: &mut Vec<BlockFault>) {
        self.known &= !written;
        if written & self.axes.rotary != 0 {
            self.rotates(faults);
        }
    }

    /// To the reference position: the axes of the block through the point of their words, all axes if there is none.
    pub(super) fn reference(&mut self, words: &WrittenAxisWords, block: &mut Block) -> Action {
        self.put_words(words, block);
        let distances = self.state.incremental == Some(true);
        for index in set_bits(if distances { words.written } else { 0 }) {
            if block.values[index] != 0.0 && self.known & (1 << index) == 0 {
                fault(&mut block.faults, 0, "incremental motion from an unknown position");
            }
            block.values[index] += self.values[index];
        }
        if words.written == 0 {
            block.written = (1 << self.axes.names.len()) - 1;
        }
        self.lose(block.written, &mut block.faults);
        let z = self.axes.linear[2].map_or(0, |z| 1 << z);
        if self.facts.reference_cancels_length && block.written & z != 0 {
            self.state.length = Some(Length::Off);
        }
        let stays = set_bits(words.written).all(|index| words.values[index] == 0.0);
        let direct = words.written != 0 && distances && words.absolute & words.written == 0 && stays;
        Action::Reference { direct }
    }

    /// The tool axis to the end of its travel.
    pub(super) fn end_of_travel(&mut self, block: &mut Block) -> Action {
        // A tool call names the axis; which tool it was may be unknown after blocks that may be skipped.
        let Some(axis) = self.normal() else {
            fault(&mut block.faults, 0, "retract along the tool axis before a tool call, which names this axis");
            return Action::Nothing;
        };
        block.written = 1 << axis;
        self.known &= !block.written;
        Action::EndOfTravel
    }

    pub(super) fn machine_block(&mut self, words: &WrittenAxisWords, block: &mut Block) -> Action {
        self.put_words(words, block);
        self.lose(words.written, &mut block.faults);
        if self.motion.code != Some(Code::Rapid) {
            fault(&mut block.faults, 0, "machine coordinates in a feed motion");
        }
        if self.state.incremental == Some(true) || words.incremental & words.written != 0 {
            fault(&mut block.faults, 0, "machine coordinates in incremental mode");
        }
        Action::Machine
    }

    /// Where the axes are.
    pub(super) fn position(&self) -> [f64; MAX_AXES] {
        self.values
    }

    /// Position of the axis along the normal of the plane.
    pub(in super::super) fn normal(&self) -> Option<usize> {
        let [_, _, normal] = self.state.plane?.axes();
        self.axes.linear[normal]
    }

    /// Puts the axes where their words say.
    fn place(&mut self, words: &WrittenAxisWords, cycle: bool, faults: &mut Vec<BlockFault>) {
        // In a canned cycle the word along the normal is the bottom of the hole.
        let bottom = if cycle { self.normal().map_or(0, |normal| 1 << normal) } else { 0 };
        let distances = self.distances(words);
        let rolls_over = if self.axes.has_rollover || self.state.shortest { self.axes.rotary } else { 0 };
        let (placed, unit) = (words.written & !bottom, self.unit());
        let relative = placed & (distances | rolls_over);
        if relative != 0 {
            self.place_relative(words, relative, distances, faults);
        }
        for index in set_bits(placed & !relative) {
            self.values[index] = self.value(index, words, unit);
        }
        self.known |= placed;
        self.turned &= !placed;
    }

    /// Words that are distances: bits.
    pub(super) fn distances(&self, words: &WrittenAxisWords) -> u16 {
        words.incremental | if self.state.incremental == Some(true) { !words.absolute } else { 0 }
    }

    /// Puts the axes whose ends depend on where they are: words are distances, or the control chooses the path.
    #[inline(never)]
    fn place_relative(
        &mut self,
        words: &WrittenAxisWords,
        relative: u16,
        distances: u16,
        faults: &mut Vec<BlockFault>,
    ) {
        let unit = self.unit();
        for index in set_bits(relative) {
            let (bit, value) = (1 << index, self.value(index, words, unit));
            self.values[index] = if distances & bit != 0 {
                self.farther(index, value, faults)
            } else {
                self.rotated(index, value, faults)
            };
        }
    }

    /// Value of a word, mm or rad.
    #[inline]
    pub(super) fn value(&self, index: usize, words: &WrittenAxisWords, unit: f64) -> f64 {
        let word = words.values[index];
        if self.axes.rotary & (1 << index) != 0 { word.to_radians() } else { word * unit }
    }

    /// Value of an axis after a word that is a distance.
    fn farther(&self, index: usize, by: f64, faults: &mut Vec<BlockFault>) -> f64 {
        if self.known & !self.turned & (1 << index) == 0 {
            fault(faults, 0, "incremental motion from an unknown position");
        }
        self.values[index] + by
    }

    /// Where a rotary axis ends whose word says `value`, on a control that chooses the path there.
    fn rotated(&self, index: usize, value: f64, faults: &mut Vec<BlockFault>) -> f64 {
        // Where the set-up says which axes roll over, the shortest path is for these.
        let any = if self.state.shortest && !self.axes.has_rollover { Some(RolloverRule::Shortest) } else { None };
        let Some(rule) = self.axis(index).rollover.or(any) else { return value };
        if self.known & !self.turned & (1 << index) == 0 {
            // Its sign is the direction, not the place.
            return if rule == RolloverRule::Sign { value.abs() } else { value };
        }
        let from = self.values[index];
        match rule {
            RolloverRule::Sign => {
                let forward = (value.abs() - from).rem_euclid(TAU);
                // An axis that is already there does not rotate, whatever its rounding.
                let forward = if TAU - forward < ROLLOVER_NOISE { 0.0 } else { forward };
                // The sign is that of the word, also of -0.
                if forward < ROLLOVER_NOISE || value.is_sign_positive() { from + forward } else { from + forward - TAU }
            }
            RolloverRule::Shortest => {
                let travel = (value - from + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
                if TAU / 2.0 - travel.abs() < ROLLOVER_NOISE {
                    fault(faults, 0, "rotary motion of exactly 180°: the control may rotate in either direction");
                }
                from + travel
            }
        }
    }
}
