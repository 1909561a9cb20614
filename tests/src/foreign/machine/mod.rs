//! One state machine for all controls: commands into effects and state.
//!
//! Order within a block: unit, feed mode, F, S, T, tool change, spindle, coolant, plane, compensation, length, offset,
//! distance mode, tilted plane, tip control, path; then the one thing that the block does. Modes are in `modes`,
//! motions in `motion`, arcs in `arc`, holes in `hole`, and `careful` refuses what a control would run and nobody
//! should.

mod arc;
mod careful;
mod hole;
mod modes;
mod motion;

use super::axes::Axes;
use super::meaning::{Address, Command, Meaning, Supply};
use super::state::{Distance, FeedMode, State, Units};
use super::trace::Effect;
use super::{Control, Options};

/// A control that executes commands.
#[derive(Debug)]
pub(super) struct Machine {
    control: Control,
    gauge_line: bool,
    dry: bool,
    careless: bool,
    /// Rapids are written at feed.
    rapids_at_feed: bool,
    /// State after the last command.
    pub(super) state: State,
    /// Position that another length has made unknown, and the state before it and after it.
    called: Option<(State, State)>,
    /// Level before the canned cycle.
    initial_level: Option<f64>,
    /// Register of the tool radius that was written last.
    radius: Option<u32>,
    /// M29 was in the block before.
    thread_due: bool,
    /// Canned cycle of letters that is in force.
    letters: hole::Letters,
}

impl Machine {
    /// A control that has just been switched on.
    pub(super) fn new(options: &Options) -> Self {
        let mut state = State { tool: options.entry.and_then(|entry| entry.tool), ..options.before };
        if options.entry.is_some() {
            // Whatever ran before.
            state = State { tool: state.tool, ..State::left_on(options.control) };
        }
        if options.control == Control::Heidenhain
            && let Some(tool) = state.tool
        {
            // The operator has called the tool, and its length with it.
            state.length = Some(super::state::Length::Register(tool));
            state.plane = Some(super::state::Plane::Xy);
        }
        Self {
            control: options.control,
            gauge_line: options.gauge_line,
            dry: options.dry,
            careless: options.careless,
            rapids_at_feed: options.rapids_at_feed,
            called: None,
            state,
            initial_level: None,
            radius: None,
            thread_due: false,
            letters: hole::Letters::default(),
        }
    }

    /// `BEGIN PGM`: the unit, and what is always in force on a Heidenhain control.
    pub(super) fn begin(&mut self, inches: bool) {
        self.state.units = Some(if inches { Units::Inches } else { Units::Millimetres });
        self.state.distance = Some(Distance::Absolute);
        self.state.feed_mode = Some(FeedMode::PerMinute);
    }

    /// A length guard.
    pub(super) fn guard(&mut self, register: Option<u32>) -> Result<(), String> {
        // LinuxCNC reads the length of the tool in the spindle, whatever is in force.
        self.state.guarded = register.or(self.state.tool.filter(|_| self.control == Control::LinuxCnc));
        careful::guard(self)
    }

    /// A guard of what lies over the work offset.
    pub(super) fn offset_guard(&self) -> Result<(), String> {
        if self.state.rotated_offset { Err("the guard stops the program".to_owned()) } else { Ok(()) }
    }

    /// Executes a block; what it does, and its axis words.
    pub(super) fn execute(&mut self, mut command: Command) -> Result<(Effect, Axes), String> {
        let mut words = Axes::default();
        for word in &command.words {
            if let Address::Axis(letter) = word.address {
                words.set(letter, word.value);
            }
        }
        let written = command.clone();
        let meanings = &written.meanings;
        if !self.careless {
            careful::block(self, &written)?;
        }
        careful::clear(self.control, &written)?;
        self.modes(meanings, &mut command)?;
        let effect = self.effect(&written, &mut command)?;
        let thread = matches!(effect, Effect::Hole(_));
        if self.careless && self.thread_due && !thread {
            return Err("a block between M29 and its thread, or M29 twice".to_owned());
        }
        self.thread_due = written.has(Meaning::RigidTapping) && !thread;
        command.finish()?;
        if effect.moves() && self.state.left.any() {
            return Err(format!("{:?} is on from a program before", self.state.left));
        }
        careful::effect(self, &written, &effect, &words)?;
        if effect.is_thread() {
            self.state.stopped_by_thread = !self.rapids_at_feed
                && match self.control {
                    Control::Fanuc => self.state.rigid,
                    Control::Haas | Control::Heidenhain => true,
                    Control::LinuxCnc | Control::Siemens => false,
                };
        }
        if !effect.moves() {
            self.at_end(meanings);
        }
        Ok((effect, words))
    }

    /// The one thing that a block does; `command` is what its modes have left of `written`.
    fn effect(&mut self, written: &Command, command: &mut Command) -> Result<Effect, String> {
        let meanings = &written.meanings;
        let stops = meanings.contains(&Meaning::Stop) || meanings.contains(&Meaning::OptionalStop);
        if meanings.contains(&Meaning::Dwell) && stops {
            // The wait comes before the stop.
            command.take(Address::Seconds).ok_or("a dwell without its time")?;
        } else if meanings.contains(&Meaning::Dwell) {
            self.motion_mode(meanings, command)?;
            let seconds = command.take(Address::Seconds).ok_or("a dwell without its time")?;
            return Ok(Effect::Dwell(seconds));
        }
        for meaning in meanings {
            match meaning {
                Meaning::End => return Ok(Effect::End),
                Meaning::Stop | Meaning::OptionalStop => {
                    // The operator may have moved any axis, and has stopped the spindle.
                    self.state.position = Axes::default();
                    self.state.machine = Axes::default();
                    self.state.spindle = None;
                    return Ok(if *meaning == Meaning::Stop { Effect::Stop } else { Effect::OptionalStop });
                }
                Meaning::ToolChange => {
                    let tool = self.state.tool.ok_or("a tool change without a tool")?;
                    return Ok(Effect::ToolChange(tool));
                }
                _ => {}
            }
        }
        if let Some(effect) = self.motion(written, command)? {
            return Ok(effect);
        }
        Ok(still(meanings, &self.state))
    }
}

/// What a block does that moves nothing.
fn still(meanings: &[Meaning], state: &State) -> Effect {
    if meanings.iter().any(|meaning| matches!(meaning, Meaning::Units(_))) {
        return Effect::Safety;
    }
    for meaning in meanings {
        match meaning {
            Meaning::Spindle(spindle) => return Effect::Spindle(*spindle),
            Meaning::CoolantOn(_) => return Effect::Coolant { off: false },
            Meaning::CoolantOff(supply) => return Effect::Coolant { off: *supply != Supply::Through },
            Meaning::LengthOn | Meaning::LengthOff => {
                if let Some(length) = state.length {
                    return Effect::Length(length);
                }
            }
            _ => {}
        }
    }
    Effect::Modal
}
