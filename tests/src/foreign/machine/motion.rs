//! Motions: words into positions, in program or machine coordinates.

use super::super::Control;
use super::super::axes::{Axes, LETTERS, is_rotary};
use super::super::meaning::{Address, Command, Meaning, NumberCounting};
use super::super::state::{Distance, MotionMode};
use super::super::trace::Effect;
use super::{Machine, arc, hole};

impl Machine {
    /// Sets the motion mode, and moves what the block moves; `None` if it moves nothing.
    pub(super) fn motion(&mut self, written: &Command, command: &mut Command) -> Result<Option<Effect>, String> {
        let meanings = &written.meanings;
        let rigid = meanings.contains(&Meaning::RigidTap);
        self.motion_mode(meanings, command)?;
        let elsewhere = meanings.contains(&Meaning::Home) || meanings.contains(&Meaning::MachineCoordinates);
        if elsewhere && command.cycle.is_some() {
            return Err("a cycle in a block of machine coordinates".to_owned());
        }
        if meanings.contains(&Meaning::Home) {
            return self.home(command).map(Some);
        }
        if meanings.contains(&Meaning::MachineCoordinates) {
            if meanings.contains(&Meaning::Call) {
                return Err("a cycle is called at machine coordinates".to_owned());
            }
            return self.move_in_machine_coordinates(command).map(Some);
        }
        if rigid {
            return hole::rigid_tap(self, command).map(Some);
        }
        let call = meanings.contains(&Meaning::Call);
        // A cycle that is called where it is defined (Siemens), or the one defined before, at every position or at
        // this.
        let modal = self.state.cycle.filter(|_| self.control == Control::Siemens || call);
        let called = command.cycle.take().or(modal);
        let arcs = matches!(self.state.motion, Some(MotionMode::Clockwise | MotionMode::CounterClockwise));
        let round = arcs && command.words.iter().any(|word| matches!(word.address, Address::Centre(_)));
        let leans = self.state.under_tip_control()
            && written.words.iter().any(|word| matches!(word.address, Address::Vector(_)));
        let again = self.state.motion == Some(MotionMode::Cycle)
            && command.words.iter().any(|word| word.address == Address::Level);
        if !command.has_axes()
            && !again
            && !round
            && !command.words.iter().any(|word| word.address == Address::PolarAngle)
        {
            if call {
                return hole::called(self, called).map(Some);
            }
            let oriented = meanings.contains(&Meaning::Orient)
                || meanings.contains(&Meaning::TiltOffTurning)
                || meanings.contains(&Meaning::Tilt) && self.state.tilted_plane().is_some_and(|plane| plane.oriented);
            if oriented {
                // The control computes the angles.
                self.state.position = Axes::default();
                self.state.machine = Axes::default();
                return Ok(Some(Effect::Orient));
            }
            // Under tip control a block may turn the tool axis alone.
            return match self.state.motion.filter(|_| leans) {
                Some(MotionMode::Rapid) => Ok(Some(Effect::Rapid)),
                Some(MotionMode::Feed) => Ok(Some(Effect::Feed)),
                None | Some(_) => Ok(None),
            };
        }
        let mode = self.state.motion.ok_or("no motion mode is in force")?;
        let effect = match mode {
            MotionMode::Cycle => hole::of_letters(self, command)?,
            MotionMode::Clockwise | MotionMode::CounterClockwise => {
                Effect::Arc(arc::motion(self, command, mode == MotionMode::Clockwise)?)
            }
            MotionMode::Rapid | MotionMode::Feed => {
                self.place(command, &LETTERS)?;
                if mode == MotionMode::Rapid { Effect::Rapid } else { Effect::Feed }
            }
        };
        self.forget_machine();
        if call || called.is_some() && matches!(effect, Effect::Rapid | Effect::Feed) {
            return hole::called(self, called).map(Some);
        }
        Ok(Some(effect))
    }

    pub(super) fn motion_mode(&mut self, meanings: &[Meaning], command: &mut Command) -> Result<(), String> {
        for meaning in meanings {
            match meaning {
                Meaning::Motion(mode) => {
                    self.state.motion = Some(*mode);
                    self.end_cycle_of_letters();
                }
                Meaning::CancelMotion | Meaning::RigidTap => {
                    self.state.motion = None;
                    self.end_cycle_of_letters();
                }
                Meaning::Cycle(code) => hole::begin(self, *code)?,
                Meaning::ModalCall => self.state.cycle = command.cycle.take(),
                _ => {}
            }
        }
        if command.cycle.is_some() && !meanings.contains(&Meaning::Call) {
            self.state.cycle = command.cycle.take();
        }
        Ok(())
    }

    fn end_cycle_of_letters(&mut self) {
        if self.letters.end() {
            self.state.cycle = None;
            self.state.rigid = false;
        }
    }

    /// Takes the words of some axes and puts the axes there.
    pub(super) fn place(&mut self, command: &mut Command, letters: &[char]) -> Result<(), String> {
        for &letter in letters {
            if let Some(word) = command.take_counted(Address::Axis(letter)) {
                let value = self.value_of(letter, word.value, word.counting)?;
                self.state.position.set(letter, value);
            }
        }
        Ok(())
    }

    /// Position that a word means.
    pub(super) fn value_of(&self, letter: char, value: f64, counting: NumberCounting) -> Result<f64, String> {
        let incremental = match counting {
            NumberCounting::Absolute => false,
            NumberCounting::Incremental => true,
            NumberCounting::AsInForce => match self.state.distance {
                Some(distance) => distance == Distance::Incremental,
                None => return Err("neither absolute nor incremental dimensions are in force".to_owned()),
            },
        };
        if !incremental {
            return Ok(value);
        }
        let from = self.state.position.get(letter);
        from.map(|from| from + value).ok_or_else(|| format!("{letter} moves by a distance from an unknown position"))
    }

    /// G28, G30: the named axes pass the position of the block and go to their reference points; without a name, all
    /// do.
    fn home(&mut self, command: &mut Command) -> Result<Effect, String> {
        let mut passed = Axes::default();
        for letter in LETTERS {
            if let Some(word) = command.take_counted(Address::Axis(letter)) {
                passed.set(letter, self.value_of(letter, word.value, word.counting)?);
            }
        }
        self.state.position.retain(|letter| !passed.is_empty() && !passed.contains(letter));
        self.state.machine.retain(|letter| !passed.is_empty() && !passed.contains(letter));
        Ok(Effect::Home(passed))
    }

    fn move_in_machine_coordinates(&mut self, command: &mut Command) -> Result<Effect, String> {
        if self.state.motion != Some(MotionMode::Rapid) {
            return Err("G53 with feed: machine coordinates are reached at rapid".to_owned());
        }
        if self.state.distance == Some(Distance::Incremental) {
            return Err("machine coordinates by their distance".to_owned());
        }
        let mut moved = Axes::default();
        for letter in LETTERS {
            if let Some(word) = command.take_counted(Address::Axis(letter)) {
                if word.counting == NumberCounting::Incremental {
                    return Err("machine coordinates by their distance".to_owned());
                }
                moved.set(letter, word.value);
            }
        }
        if moved.is_empty() {
            return Err("machine coordinates of no axis: a block that moves nothing".to_owned());
        }
        self.state.machine.extend(&moved);
        self.state.position.retain(|letter| !moved.contains(letter));
        Ok(Effect::Machine)
    }

    /// After a motion in program coordinates the machine coordinates of linear axes are unknown, and those of rotary
    /// axes that have a position.
    fn forget_machine(&mut self) {
        let position = self.state.position;
        self.state.machine.retain(|letter| !position.contains(letter));
        let moved_zero = self.state.dynamic_offset;
        if self.state.under_tip_control() || self.state.tilted_plane().is_some() || moved_zero {
            self.state.machine.retain(is_rotary);
        }
    }
}
