//! Modal codes: each changes its part of the state.

use super::super::Control;
use super::super::axes::{Axes, is_rotary};
use super::super::meaning::{Address, Command, Meaning, Supply, whole};
use super::super::state::{
    Compensation, FeedMode, Length, PathMode, Plane, Spindle, State, TiltedPlane, TipControl, WorkOffset,
};
use super::Machine;

impl Machine {
    /// Obeys every modal code and the words that belong to it, in the order in which a control does.
    pub(super) fn modes(&mut self, meanings: &[Meaning], command: &mut Command) -> Result<(), String> {
        let before = self.state;
        self.feeds_and_units(meanings, command)?;
        self.tool_and_spindle(meanings, command)?;
        for &meaning in meanings {
            if !self.is_at_end(meaning) {
                self.mode(meaning, command)?;
            }
        }
        self.tool_vector(command)?;
        self.forget_positions(&before, meanings);
        Ok(())
    }

    /// Obeys the codes that act at the end of their block; whether there is one.
    pub(in super::super) fn at_end(&mut self, meanings: &[Meaning]) -> bool {
        let late: Vec<Meaning> = meanings.iter().copied().filter(|meaning| self.is_at_end(*meaning)).collect();
        for meaning in &late {
            match meaning {
                Meaning::Spindle(spindle) => self.state.spindle = Some(*spindle),
                Meaning::CoolantOff(supply) => switch(&mut self.state, *supply, false),
                _ => {}
            }
        }
        !late.is_empty()
    }

    /// M5 and M9 of a Heidenhain control.
    fn is_at_end(&self, meaning: Meaning) -> bool {
        self.control == Control::Heidenhain
            && matches!(meaning, Meaning::Spindle(Spindle::Off) | Meaning::CoolantOff(_))
    }

    fn feeds_and_units(&mut self, meanings: &[Meaning], command: &mut Command) -> Result<(), String> {
        let state = &mut self.state;
        if state.feed_mode == Some(FeedMode::InverseTime) {
            // An F of inverse time holds for its own block only.
            state.feed = None;
        }
        for meaning in meanings {
            match meaning {
                Meaning::Units(units) => state.units = Some(*units),
                Meaning::FeedMode(mode) => {
                    // A complete state begins with its unit: F is not of what was before.
                    let complete = meanings.iter().any(|meaning| matches!(meaning, Meaning::Units(_)));
                    // LinuxCNC forgets F at each of these codes.
                    if state.feed_mode != Some(*mode) || complete || self.control == Control::LinuxCnc {
                        state.feed = None;
                    }
                    state.feed_mode = Some(*mode);
                }
                _ => {}
            }
        }
        if let Some(feed) = command.take(Address::Feed) {
            if feed <= 0.0 {
                return Err("F0".to_owned());
            }
            state.feed = Some(feed);
        }
        Ok(())
    }

    fn tool_and_spindle(&mut self, meanings: &[Meaning], command: &mut Command) -> Result<(), String> {
        let state = &mut self.state;
        let speed = command.take(Address::Speed);
        let called = speed.is_some();
        if let Some(speed) = speed {
            if speed <= 0.0 {
                return Err("S0".to_owned());
            }
            state.speed = Some(speed);
        }
        match command.take(Address::RadiusDelta) {
            Some(delta) => state.radius_delta = Some(delta),
            None if self.control != Control::Heidenhain => {}
            None if meanings.contains(&Meaning::ToolChange) => state.radius_delta = Some(0.0),
            None if called => state.radius_delta = state.radius_delta.filter(|delta| delta.abs() < 1e-9),
            None => {}
        }
        if let Some(tool) = command.take(Address::Tool) {
            state.selected = Some(whole(tool)?);
        }
        if meanings.contains(&Meaning::ToolChange) {
            state.tool = Some(state.selected.take().ok_or("a tool change without T")?);
            state.spindle = Some(Spindle::Off);
            state.length = None;
            state.position = Axes::default();
            state.machine = Axes::default();
        }
        Ok(())
    }

    fn mode(&mut self, meaning: Meaning, command: &mut Command) -> Result<(), String> {
        let siemens = self.control == Control::Siemens;
        let state = &mut self.state;
        match meaning {
            Meaning::Spindle(spindle) => {
                state.stopped_by_thread = false;
                if spindle != Spindle::Off && state.speed.is_none() {
                    return Err("the spindle starts without S".to_owned());
                }
                state.spindle = Some(spindle);
            }
            Meaning::CoolantOn(supply) => switch(state, supply, true),
            Meaning::CoolantOff(supply) => switch(state, supply, false),
            Meaning::Ends(left) => state.left.end(left),
            Meaning::Plane(plane) => state.plane = Some(plane),
            Meaning::Compensation(side) => {
                let written = command.take(Address::RadiusRegister).map(whole).transpose()?;
                // D stays in force on Fanuc and Haas.
                self.radius = written.or(self.radius);
                let stays = matches!(self.control, Control::Fanuc | Control::Haas) && side != Compensation::Off;
                let register = written.or(self.radius.filter(|_| stays));
                state.compensation = Some(match side {
                    Compensation::Off if register.is_some() => return Err("G40 with a register".to_owned()),
                    Compensation::Off => Compensation::Off,
                    Compensation::Left(_) => Compensation::Left(register),
                    Compensation::Right(_) => Compensation::Right(register),
                });
            }
            Meaning::LengthOff => {
                state.length = Some(Length::Off);
                if !siemens && self.control != Control::LinuxCnc && state.under_tip_control() {
                    state.tip_control = Some(TipControl::Off);
                    state.vector = None;
                }
            }
            Meaning::LengthOn => {
                // One group on Fanuc and Haas: G43 ends G43.4, G43.5 and G234.
                if matches!(self.control, Control::Fanuc | Control::Haas) && state.under_tip_control() {
                    state.tip_control = Some(TipControl::Off);
                    state.vector = None;
                }
                self.length(command)?;
            }
            Meaning::LengthWithTipControl(_) if self.control == Control::Haas && state.under_tip_control() => {
                return Err("tip control while it is on".to_owned());
            }
            Meaning::LengthWithTipControl(vectors) => {
                // On Fanuc P states it in the same block, or else a parameter of the machine decides.
                if !command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Interpolation(_))) {
                    self.state.interpolation = None;
                }
                self.length(command)?;
                self.begin_tip_control(vectors)?;
            }
            Meaning::TipControl(true) if self.control == Control::Heidenhain && state.under_tip_control() => {
                return Err("tip control while it is on".to_owned());
            }
            Meaning::TipControl(true) => {
                state.offset_cleared |= siemens;
                self.begin_tip_control(false)?;
            }
            Meaning::TipControl(false) => {
                state.offset_cleared |= siemens && state.under_tip_control();
                state.tip_control = Some(TipControl::Off);
                state.vector = None;
            }
            Meaning::WorkOffset(offset) => {
                state.work_offset = Some(offset);
                state.offset_cleared = false;
            }
            Meaning::FurtherOffset => {
                let number = command.take(Address::OffsetNumber).ok_or("a work offset without its number")?;
                state.work_offset = Some(WorkOffset::Further(whole(number)?));
                state.offset_cleared = false;
            }
            Meaning::Distance(distance) => state.distance = Some(distance),
            Meaning::ArcCentres(distance) => state.arc_centres = Some(distance),
            Meaning::ExactStop => state.path = Some(PathMode::ExactStop),
            Meaning::Continuous => state.path = Some(PathMode::Continuous(command.take(Address::PathTolerance))),
            Meaning::Return(level) => state.return_level = Some(level),
            Meaning::Tilt => state.tilt = Some(command.tilt.take()),
            Meaning::TiltOff | Meaning::TiltOffTurning => state.tilt = Some(None),
            Meaning::Smoothing => smooth(state, command),
            Meaning::DynamicOffset(true) if state.under_tip_control() || state.tilted_plane().is_some() => {
                return Err("a dynamic work offset under tip control or in a plane".to_owned());
            }
            Meaning::DynamicOffset(on) => state.dynamic_offset = on,
            Meaning::Orient => {
                let plane = state.tilted_plane().ok_or("no tilted plane to turn to")?;
                state.tilt = Some(Some(TiltedPlane { oriented: true, ..plane }));
            }
            Meaning::Interpolation(path) => state.interpolation = Some(path),
            Meaning::VectorFrame(frame) => state.vector_frame = Some(frame),
            Meaning::RotaryPath(path) => state.rotary_path = Some(path),
            Meaning::RigidTapping => state.rigid = true,
            Meaning::Pole => self.pole(command)?,
            Meaning::Motion(_)
            | Meaning::Cycle(_)
            | Meaning::CancelMotion
            | Meaning::RigidTap
            | Meaning::MachineCoordinates
            | Meaning::Home
            | Meaning::Dwell
            | Meaning::Units(_)
            | Meaning::FeedMode(_)
            | Meaning::ToolChange
            | Meaning::Stop
            | Meaning::OptionalStop
            | Meaning::End
            | Meaning::ModalCall
            | Meaning::Call
            | Meaning::Idle => {}
        }
        Ok(())
    }

    fn length(&mut self, command: &mut Command) -> Result<(), String> {
        let register = command.take(Address::LengthRegister).ok_or("a length compensation without its register")?;
        self.state.length = Some(match whole(register)? {
            0 => Length::Off,
            register => Length::Register(register),
        });
        Ok(())
    }

    fn begin_tip_control(&mut self, vectors: bool) -> Result<(), String> {
        if self.state.dynamic_offset {
            return Err("tip control while the dynamic work offset is on".to_owned());
        }
        let mut start = self.state.position;
        start.retain(is_rotary);
        self.state.tip_control = Some(TipControl::On { start, vectors });
        Ok(())
    }

    /// `CC X+.. Y+..`: the other components are no longer known.
    fn pole(&mut self, command: &mut Command) -> Result<(), String> {
        self.state.pole = [None; 3];
        for (place, letter) in self.state.pole.iter_mut().zip(['X', 'Y', 'Z']) {
            if let Some(word) = command.take_counted(Address::Axis(letter)) {
                if word.counting != super::super::meaning::NumberCounting::AsInForce {
                    return Err("a pole by its distance".to_owned());
                }
                *place = Some(word.value);
            }
        }
        Ok(())
    }

    /// Components of the tool axis in the block; a component that is not written is that of the block before.
    fn tool_vector(&mut self, command: &mut Command) -> Result<(), String> {
        let programmed =
            |command: &Command| command.words.iter().any(|word| matches!(word.address, Address::Vector(_)));
        let given = programmed(command);
        if self.careless && given {
            // Components that are left out count as zero.
            self.state.vector = Some([0.0; 3]);
        }
        for index in 0..3 {
            if let Some(value) = command.take(Address::Vector(index)) {
                self.state.vector.get_or_insert_default()[index] = value;
                if let Some(TipControl::On { vectors, .. }) = &mut self.state.tip_control {
                    *vectors = true;
                }
            }
        }
        let norm = self.state.vector.map_or(1.0, |vector| vector.iter().map(|part| part * part).sum::<f64>().sqrt());
        if given && (norm - 1.0).abs() > 0.01 { Err("a tool vector that is no unit vector".to_owned()) } else { Ok(()) }
    }

    /// Positions are unknown where the block has changed what they count from.
    fn forget_positions(&mut self, before: &State, meanings: &[Meaning]) {
        // On Siemens a length counts from the next motion on: called back before that it has moved nothing.
        if self.control == Control::Siemens
            && before.length != self.state.length
            && before.work_offset == self.state.work_offset
        {
            let back = self.called.take().filter(|(then, left)| {
                then.length == self.state.length
                    && left.position == before.position
                    && self.state.position == before.position
            });
            if let Some((then, _)) = back {
                self.state.position = then.position;
                return;
            }
        }
        let state = &mut self.state;
        // The offset that is in force already moves nothing.
        let again = self.careless && before.length == state.length && before.tip_control == state.tip_control;
        if !again && meanings.iter().any(|meaning| meaning.group() == Meaning::LengthOn.group()) {
            // The tool table of LinuxCNC may hold lengths along every linear axis.
            let all = self.control == Control::LinuxCnc;
            state.position.retain(|letter| if all { is_rotary(letter) } else { letter != 'Z' });
            self.called = Some((*before, *state));
        }
        let tips = (before.under_tip_control(), state.under_tip_control());
        // The kinematics of LinuxCNC that are active stay active.
        let active = self.careless && self.control == Control::LinuxCnc && tips == (true, true);
        let begun = tips.1 && before.tip_control != state.tip_control && !active;
        if (before.work_offset, before.units) != (state.work_offset, state.units)
            || before.tilted_plane() != state.tilted_plane()
            || before.dynamic_offset != state.dynamic_offset
            || tips.0 != tips.1
            || begun && meanings.iter().any(|meaning| matches!(meaning, Meaning::TipControl(_)))
        {
            state.position.retain(is_rotary);
        }
        if before.units != state.units {
            state.machine = Axes::default();
        }
    }
}

/// Each form has places of its own; a form without numbers switches smoothing off, or back to the setting of the
/// control.
fn smooth(state: &mut State, command: &mut Command) {
    let places = state.smoothing.get_or_insert_default();
    let mut any = false;
    for (index, place) in places.iter_mut().enumerate() {
        if let Some(number) = command.take(Address::Smoothing(index)) {
            *place = Some(number);
            any = true;
        }
    }
    if !any {
        state.smoothing = Some(Default::default());
    }
}

fn switch(state: &mut State, supply: Supply, on: bool) {
    if supply == Supply::Through && !on && state.coolant.is_none() {
        // It says nothing about flood and mist.
        return;
    }
    let coolant = state.coolant.get_or_insert_default();
    match supply {
        Supply::Flood => coolant.flood = on,
        Supply::Mist => coolant.mist = on,
        Supply::Through => coolant.through = on,
        Supply::FloodAndMist => (coolant.flood, coolant.mist) = (on, on),
    }
}

/// Plane of the state.
pub(super) fn plane(state: &State) -> Result<Plane, String> {
    state.plane.ok_or_else(|| "no plane is in force".to_owned())
}
