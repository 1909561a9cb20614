//! The state in which a block moves, beside the one that it should move in.

use std::fmt::Display;
use std::io::Read;

use super::compare::{Checker, Phase};
use super::expect::Wanted;
use super::read::{Action, Block, Family, FeedMode, Length, MAX_AXES, Side, State, TipControl, WorkPlane};
use super::report::Shown;
use crate::motion::{Mode, TcpWords, ToolPosture};
use crate::program::Rotation;
use crate::set_up::LengthMode;

impl<R: Read> Checker<'_, R> {
    /// At the part, on the path of the CL data.
    pub(super) fn state_at_path(&mut self, block: &Block, wanted: &Wanted, shown: Shown<'_>) {
        if matches!(block.action, Action::Arc(_)) {
            self.arc_plane = block.state.plane;
        }
        let found = self.fault_at_path(block, wanted);
        self.say_with_tool(found, &block.state, wanted, shown);
    }

    /// What is wrong with the state at the part, but for the tool.
    pub(super) fn fault_at_path(&self, block: &Block, wanted: &Wanted) -> Option<String> {
        let state = &block.state;
        let beside = wanted.side != Side::None;
        let side = if beside && self.mirrored(block) { wanted.side.across() } else { wanted.side };
        self.everywhere(state, side)
            .or_else(|| if block.action == Action::Rapid { inverse(state) } else { None })
            .or_else(|| self.frame(state, true))
            .or_else(|| self.offsets(state, wanted, true))
            .or_else(|| if beside { self.radius(state, wanted) } else { None })
            .or_else(|| spindle(state, wanted.spindle.filter(|_| self.config.motion.lift_mm.is_none())))
            .or_else(|| coolant(state, wanted.coolant))
    }

    /// Left of the words is right of the path.
    fn mirrored(&self, block: &Block) -> bool {
        let tip = |values: &[f64; MAX_AXES]| self.words.place(values, &block.state).tip;
        let here = tip(&block.values);
        let steps = self.words.linear_places().map(|place| {
            let mut values = block.values;
            values[place?] += 1.0;
            Some(tip(&values) - here)
        });
        matches!(steps, [Some(x), Some(y), Some(z)] if x.cross(&y).dot(&z) < 0.0)
    }

    /// On the way to the approach point; `last`: down to it.
    pub(super) fn state_at_approach(&mut self, block: &Block, step: u8, shown: Shown<'_>) {
        let last = step == 3;
        let Some(wanted) = self.expect.get(0).map(|item| item.wanted) else { return };
        let state = &block.state;
        let moves_z = matches!(self.family, Family::Fanuc | Family::Haas);
        let found = self
            .everywhere(state, Side::None)
            .or_else(|| inverse(state))
            .or_else(|| self.frame(state, step > 1))
            .or_else(|| {
                // Rotary axes rotate before the work offset is selected again that a switch of tip control may cancel.
                let rotates = state.work_offset.is_none() && block.written & self.words.linear_mask == 0;
                if rotates { None } else { self.offsets(state, &wanted, last || !moves_z) }
            })
            .or_else(|| spindle(state, wanted.spindle.filter(|_| self.config.motion.lift_mm.is_none())))
            .or_else(|| if self.rewound.is_some() { None } else { coolant(state, 0) });
        self.say_with_tool(found, state, &wanted, shown);
    }

    /// Out along the tool axis.
    pub(super) fn state_at_leave(&mut self, block: &Block, dry: bool, shown: Shown<'_>) {
        let state = &block.state;
        let wanted = self.last.map(|(_, wanted)| wanted);
        let found = self
            .everywhere(state, Side::None)
            .or_else(|| inverse(state))
            .or_else(|| self.frame(state, true))
            .or_else(|| wanted.and_then(|wanted| self.offsets(state, &wanted, true)))
            .or_else(|| if dry { coolant(state, 0) } else { None });
        match wanted {
            Some(wanted) => self.say_with_tool(found, state, &wanted, shown),
            None => self.say(found, shown),
        }
    }

    /// The spindle may turn on as it did in the cut, or as a SPINDL behind it has it, or stand; behind a stop it stands.
    fn turns_on(&self, state: &State) -> Option<(f64, Rotation)> {
        state.spindle.flatten().filter(|_| !self.stopped)?;
        let cut = self.last.and_then(|(_, wanted)| wanted.spindle);
        let asked = self.expect.standing();
        if spindle(state, asked).is_none() { asked } else { cut }
    }

    /// In machine coordinates; `tilts`: a plane may be tilted yet.
    pub(super) fn state_at_retract(&mut self, block: &Block, dry: bool, tilts: bool, shown: Shown<'_>) {
        let state = &block.state;
        let tips = (state.tip_control != TipControl::Off)
            .then(|| "machine coordinates are programmed while tip control is on".to_owned());
        // Where the block itself takes the length away.
        let ends = matches!(self.family, Family::Fanuc | Family::Haas | Family::Siemens);
        let length = (ends && state.length != Some(Length::Off))
            .then(|| "machine coordinates are programmed before length compensation is switched off".to_owned());
        let turns = self.turns_on(state);
        let found = self
            .everywhere(state, Side::None)
            .or_else(|| inverse(state))
            .or(tips)
            .or_else(|| if tilts { None } else { tilted(state) })
            .or(length)
            .or_else(|| spindle(state, turns))
            .or_else(|| if dry { coolant(state, 0) } else { None });
        self.say(found, shown);
    }

    /// Rotary axes to their parking places; behind GOHOME the spindle may turn on.
    pub(super) fn state_at_park(&mut self, block: &Block, shown: Shown<'_>) {
        let state = &block.state;
        let turns = if self.parks { self.turns_on(state) } else { None };
        let found = self
            .everywhere(state, Side::None)
            .or_else(|| self.frame(state, false))
            .or_else(|| spindle(state, turns))
            .or_else(|| coolant(state, 0));
        self.say(found, shown);
    }

    /// At a stop that retracts, and at the end code.
    pub(super) fn state_at_end(&mut self, block: &Block, shown: Shown<'_>) {
        let state = &block.state;
        let found = spindle(state, None).or_else(|| coolant(state, 0)).or_else(|| tilted(state));
        self.say(found, shown);
    }

    fn say(&mut self, found: Option<String>, shown: Shown<'_>) {
        if let Some(text) = found {
            self.found(shown, &text);
        }
    }

    /// A wrong tool is told where the CL data calls the right one; what else is wrong then may follow from it.
    fn say_with_tool(&mut self, found: Option<String>, state: &State, wanted: &Wanted, shown: Shown<'_>) {
        if state.tool == wanted.tool {
            return self.say(found, shown);
        }
        let name = |tool: Option<u32>| tool.map_or("no tool".to_owned(), |number| format!("T{number}"));
        let text = format!("{} is in the spindle, expected {}", name(state.tool), name(wanted.tool));
        self.tally.found(wanted.called.unwrap_or_else(|| self.location()), shown, &text, None);
    }

    /// What holds for every block that moves.
    fn everywhere(&self, state: &State, side: Side) -> Option<String> {
        if state.units != Some(self.units) {
            return Some(format!(
                "the program is not in {}: the unit code before this block is missing or wrong",
                self.units.name()
            ));
        }
        if state.incremental != Some(false) {
            return Some("incremental mode (G91) is active, or G90 has not been programmed".to_owned());
        }
        // Heidenhain says the plane with the tool.
        let unsaid = self.family == Family::Heidenhain && state.plane.is_none() && self.phase == Phase::Unknown;
        // Behind a stop that does not retract, that of the last arc is in force as well.
        let of_arc = matches!(self.phase, Phase::Path | Phase::Unknown)
            && state.plane.is_some()
            && state.plane == self.arc_plane;
        if state.plane != Some(WorkPlane::Xy) && !unsaid && !of_arc {
            return Some("the working plane is not XY".to_owned());
        }
        if state.side.unwrap_or_default() != side {
            return Some(format!(
                "cutter compensation is {}, expected {}",
                state.side.unwrap_or_default().name(),
                side.name()
            ));
        }
        if state.shortest && self.config.motion.rotaries.wrap.is_empty() {
            return Some(
                "shortest-path rotary mode is active, but rotary words are absolute: they may go beyond 360".to_owned(),
            );
        }
        if state.feed_mode == Some(FeedMode::PerRevolution) || state.feed_mode.is_none() {
            return Some("feed mode is not per minute (G94)".to_owned());
        }
        None
    }

    /// Tip control and tilted plane; `framed`: those of the mode.
    fn frame(&self, state: &State, framed: bool) -> Option<String> {
        let tips = state.tip_control != TipControl::Off;
        let tilted = state.tilt.is_some();
        match (self.config.motion.mode, framed) {
            (Mode::Tcp, true) if !tips => Some("tip control is off, but linear words are tip coordinates".to_owned()),
            (Mode::Plane, true) if !tilted => {
                Some("no tilted plane is active, but linear words are coordinates in one".to_owned())
            }
            (Mode::Plane, true) if state.tilt.is_some_and(|tilt| !tilt.oriented) => {
                Some("a tilted plane is active, but the rotary axes have not been positioned to it".to_owned())
            }
            (mode, framed) if tips && !(framed && mode == Mode::Tcp) => {
                Some("tip control is on, but words are axis positions".to_owned())
            }
            (mode, framed) if tilted && !(framed && mode == Mode::Plane) => {
                Some("a tilted plane is active, but words are axis positions".to_owned())
            }
            (Mode::Tcp, true) => self.turning(state),
            _ => None,
        }
    }

    /// How the control turns the tool, where it can be told in more ways than one.
    fn turning(&self, state: &State) -> Option<String> {
        if self.config.control.tip_control.is_some() {
            return None;
        }
        let in_plane = self.config.motion.tip.tool_posture == ToolPosture::Plane;
        let in_workpiece = in_plane || self.config.motion.tip.tcp_words == TcpWords::Vectors;
        let chosen = matches!(self.family, Family::Siemens | Family::Heidenhain | Family::Fanuc);
        if chosen && state.in_plane != Some(in_plane) {
            let expected = if in_plane {
                "the plane through the first and the last tool axis"
            } else {
                "even motion of the rotary axes"
            };
            return Some(format!("interpolation of the tool axis: expected {expected}, which is not programmed"));
        }
        (self.family == Family::Siemens && state.in_workpiece != Some(in_workpiece)).then(|| {
            let frame = if in_workpiece { "workpiece" } else { "machine" };
            format!("tool axis: expected interpolation in the {frame} frame, which is not programmed")
        })
    }

    /// Work offset, and length compensation if asked for.
    fn offsets(&self, state: &State, wanted: &Wanted, length: bool) -> Option<String> {
        let offset = self.offsets.iter().find(|(frame, _)| *frame == wanted.frame).map(|(_, offset)| *offset);
        if state.work_offset != offset {
            return Some(format!("work offset is {}, expected {}", told(state.work_offset), told(offset)));
        }
        if !length {
            return None;
        }
        let register = match (self.config.set_up.length_mode, wanted.tool) {
            (LengthMode::Gauge, _) => Length::Off,
            (LengthMode::Tip, Some(_)) => Length::Register(wanted.register),
            (LengthMode::Tip, None) => return None,
        };
        if state.length.unwrap_or(Length::Off) != register {
            return Some(format!("length compensation is {}, expected {register}", told(state.length)));
        }
        None
    }

    /// The register of the tool's radius. A cutting edge, and a row of the tool table, hold the radius with the length.
    fn radius(&self, state: &State, wanted: &Wanted) -> Option<String> {
        let apart = matches!(self.family, Family::LinuxCnc | Family::Fanuc | Family::Haas);
        (apart && state.diameter != Some(wanted.radius)).then(|| {
            let register = state.diameter.map(|register| format!("D{register}"));
            format!("radius register is {}, expected D{}", told(register), wanted.radius)
        })
    }
}

/// What is in force, for people.
fn told<T: Display>(value: Option<T>) -> String {
    value.map_or_else(|| "not programmed".to_owned(), |value| value.to_string())
}

fn tilted(state: &State) -> Option<String> {
    state.tilt.map(|_| "a tilted plane is still active at the retract position".to_owned())
}

/// Inverse time belongs to feed blocks.
fn inverse(state: &State) -> Option<String> {
    (state.feed_mode == Some(FeedMode::InverseTime)).then(|| "rapid while inverse-time feed (G93) is active".to_owned())
}

fn spindle(state: &State, wanted: Option<(f64, Rotation)>) -> Option<String> {
    let turns = state.spindle.flatten();
    match wanted {
        None => turns.map(|_| "spindle is on, expected off".to_owned()),
        Some((_, sense)) if turns != Some(sense) => Some(match turns {
            None => "spindle is off, expected on".to_owned(),
            Some(_) => "spindle rotates in the wrong direction".to_owned(),
        }),
        Some((speed, _)) => match state.speed {
            Some(written) if (written - speed).abs() <= 1e-6 * speed => None,
            written => Some(format!("S is {}, expected {speed}", told(written))),
        },
    }
}

fn coolant(state: &State, wanted: u8) -> Option<String> {
    match state.coolant {
        Some(bits) if bits == wanted => None,
        Some(_) if wanted == 0 => Some("coolant is on, expected off".to_owned()),
        None => Some("coolant state is unknown: neither on nor off has been programmed before this block".to_owned()),
        Some(_) => Some("coolant differs from that of the CL data (COOLNT)".to_owned()),
    }
}
