//! The common language of all controls: what a code means, which word carries what, and the block that is made of them.
//!
//! A table turns the text of its control into a [`Command`]; the machine executes commands and knows no text.

use super::state::{
    Compensation, Cycle, Distance, FeedMode, Interpolation, LeftOn, MotionMode, Plane, ReturnLevel, RotaryPath,
    Spindle, TiltedPlane, Units, VectorFrame, WorkOffset,
};

/// Meaning of a code.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Meaning {
    /// Motion mode.
    Motion(MotionMode),
    /// Canned cycle that begins here: its code.
    Cycle(u32),
    /// No motion mode and no cycle: G80.
    CancelMotion,
    /// A thread in step with the spindle, in and out: G33.1.
    RigidTap,
    /// Words of this block are machine coordinates: G53, SUPA, M91.
    MachineCoordinates,
    /// Reference points: G28, G30.
    Home,
    /// A wait: G4.
    Dwell,
    /// Plane.
    Plane(Plane),
    /// Unit of lengths.
    Units(Units),
    /// Distance mode.
    Distance(Distance),
    /// Centres of arcs: absolute, or from the start of the arc.
    ArcCentres(Distance),
    /// Feed mode; F has to be programmed anew.
    FeedMode(FeedMode),
    /// Cutter compensation; the register comes with its own word.
    Compensation(Compensation),
    /// Length compensation with the register of the block.
    LengthOn,
    /// Length compensation and tip control off.
    LengthOff,
    /// Length compensation with tip control; `true`: the tool axis is a vector.
    LengthWithTipControl(bool),
    /// Work offset.
    WorkOffset(WorkOffset),
    /// Work offset by the number of the block: G54.1, G154.
    FurtherOffset,
    /// Exact stop.
    ExactStop,
    /// Continuous path, with the tolerance of the block.
    Continuous,
    /// Smoothing by the control, which changes no programmed point: G5.1, G187, CYCLE832, cycle 32.
    Smoothing,
    /// Return level of canned cycles.
    Return(ReturnLevel),
    /// The block defines a tilted plane.
    Tilt,
    /// G254, G255: the zero of the words follows the table, which turns.
    DynamicOffset(bool),
    /// The rotary axes turn to the tilted plane: G53.1, G253.
    Orient,
    /// Tilted plane off.
    TiltOff,
    /// Tilted plane off, and the rotary axes turn to zero: `PLANE RESET TURN`, `PLANE RESET MOVE`.
    TiltOffTurning,
    /// Tip control on or off, the length unchanged.
    TipControl(bool),
    /// Motion of the tool axis under tip control.
    Interpolation(Interpolation),
    /// Frame of tool vectors.
    VectorFrame(VectorFrame),
    /// How rotary axes reach their words.
    RotaryPath(RotaryPath),
    /// Spindle.
    Spindle(Spindle),
    /// Coolant supplies on.
    CoolantOn(Supply),
    /// Coolant supplies off.
    CoolantOff(Supply),
    /// The next G84 is in step with the spindle: M29.
    RigidTapping,
    /// The selected tool comes into the spindle.
    ToolChange,
    /// Program stop.
    Stop,
    /// Optional stop.
    OptionalStop,
    /// End of program.
    End,
    /// A cycle at every position from the next block on, or no longer: MCALL.
    ModalCall,
    /// The defined cycle at the position of this block: M99, a CYCLE8x without MCALL.
    Call,
    /// CC: the pole of the arcs that follow.
    Pole,
    /// What a program before may have left on is off.
    Ends(LeftOn),
    /// Codes of the shop that change no state known here.
    Idle,
}

/// Coolant supplies of one code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Supply {
    /// Flood.
    Flood,
    /// Mist.
    Mist,
    /// Through the spindle.
    Through,
    /// Flood and mist.
    FloodAndMist,
}

/// Modal group: the part of the state that a code changes. A block may hold one code of each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// `State::motion`, `State::cycle`.
    Motion,
    /// This block alone.
    OneShot,
    /// `State::plane`.
    Plane,
    /// `State::units`.
    Units,
    /// `State::distance`.
    Distance,
    /// `State::arc_centres`.
    ArcCentres,
    /// `State::feed_mode`, `State::feed`.
    FeedMode,
    /// `State::compensation`.
    Compensation,
    /// `State::length`.
    Length,
    /// `State::work_offset`.
    WorkOffset,
    /// `State::path`.
    Path,
    /// `State::return_level`.
    Return,
    /// `State::tilt`.
    Tilt,
    /// `State::dynamic_offset`.
    DynamicOffset,
    /// `State::tip_control`.
    TipControl,
    /// `State::interpolation`.
    Interpolation,
    /// `State::vector_frame`.
    VectorFrame,
    /// `State::rotary_path`.
    RotaryPath,
    /// `State::spindle`.
    Spindle,
    /// `State::coolant`.
    Coolant,
    /// `State::tool`.
    Tool,
    /// Stops and the end of the program.
    Stop,
    /// `State::cycle` by a call.
    Call,
    /// `State::pole`.
    Pole,
    /// `State::left`.
    Left(LeftOn),
    /// No state.
    None,
}

impl Meaning {
    /// Modal group of the code.
    #[must_use]
    pub const fn group(self) -> Group {
        match self {
            Self::Motion(_) | Self::Cycle(_) | Self::CancelMotion | Self::RigidTap => Group::Motion,
            Self::MachineCoordinates | Self::Dwell | Self::Home => Group::OneShot,
            Self::Plane(_) => Group::Plane,
            Self::Units(_) => Group::Units,
            Self::Distance(_) => Group::Distance,
            Self::ArcCentres(_) => Group::ArcCentres,
            Self::FeedMode(_) => Group::FeedMode,
            Self::Compensation(_) => Group::Compensation,
            Self::LengthOn | Self::LengthOff | Self::LengthWithTipControl(_) => Group::Length,
            Self::WorkOffset(_) | Self::FurtherOffset => Group::WorkOffset,
            Self::ExactStop | Self::Continuous | Self::Smoothing => Group::Path,
            Self::Return(_) => Group::Return,
            Self::Tilt | Self::Orient | Self::TiltOff | Self::TiltOffTurning => Group::Tilt,
            Self::DynamicOffset(_) => Group::DynamicOffset,
            Self::TipControl(_) => Group::TipControl,
            Self::Interpolation(_) => Group::Interpolation,
            Self::VectorFrame(_) => Group::VectorFrame,
            Self::RotaryPath(_) => Group::RotaryPath,
            Self::Spindle(_) => Group::Spindle,
            Self::CoolantOn(_) | Self::CoolantOff(_) => Group::Coolant,
            Self::ToolChange => Group::Tool,
            Self::Stop | Self::OptionalStop | Self::End => Group::Stop,
            Self::ModalCall | Self::Call => Group::Call,
            Self::Pole => Group::Pole,
            Self::Ends(left) => Group::Left(left),
            Self::RigidTapping | Self::Idle => Group::None,
        }
    }
}

/// What a number belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Address {
    /// An axis.
    Axis(char),
    /// Centre of an arc: I, J or K.
    Centre(usize),
    /// Component of the tool vector.
    Vector(usize),
    /// Radius of an arc.
    Radius,
    /// Polar angle of an arc, degrees.
    PolarAngle,
    /// Whole revolutions of a helix besides its angle.
    Revolutions,
    /// F.
    Feed,
    /// S.
    Speed,
    /// T.
    Tool,
    /// H, or D on Siemens.
    LengthRegister,
    /// D.
    RadiusRegister,
    /// DR of a tool call.
    RadiusDelta,
    /// Number of a further work offset.
    OffsetNumber,
    /// A time, s.
    Seconds,
    /// Tolerance of the path.
    PathTolerance,
    /// Reference level of a cycle.
    Level,
    /// Step of a cycle.
    Step,
    /// Advance per revolution.
    Pitch,
    /// A number that only the control's smoothing reads; its place in [`State::smoothing`](super::State::smoothing).
    Smoothing(usize),
}

/// How a number counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberCounting {
    /// By the distance mode.
    AsInForce,
    /// `AC()`.
    Absolute,
    /// `IC()`, `IX`.
    Incremental,
}

/// A number and what it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    /// What it belongs to.
    pub address: Address,
    /// Value: lengths in the unit of the program, angles in degrees.
    pub value: f64,
    /// How it counts.
    pub counting: NumberCounting,
}

/// A block in the common language. Whatever is in it has to be used: a word that no code of the block takes is refused.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Command {
    /// Codes, in the order of the block.
    pub meanings: Vec<Meaning>,
    /// Words that no code has taken yet.
    pub words: Vec<Word>,
    /// Cycle that the block defines with all its levels.
    pub cycle: Option<Cycle>,
    /// Tilted plane that the block defines.
    pub tilt: Option<TiltedPlane>,
}

impl Command {
    /// Whether a code is in the block.
    #[must_use]
    pub fn has(&self, meaning: Meaning) -> bool {
        self.meanings.contains(&meaning)
    }

    /// Adds a code.
    ///
    /// # Errors
    /// If another code of its group is in the block.
    pub fn code(&mut self, meaning: Meaning) -> Result<(), String> {
        let group = meaning.group();
        let repeated = self.meanings.iter().any(|other| other.group() == group);
        if repeated && !matches!(group, Group::None | Group::Coolant) {
            return Err(format!("two codes of the group {group:?} in one block"));
        }
        self.meanings.push(meaning);
        Ok(())
    }

    /// Adds a word that counts by the distance mode.
    ///
    /// # Errors
    /// If the block has this word already.
    pub fn word(&mut self, address: Address, value: f64) -> Result<(), String> {
        self.counted(address, value, NumberCounting::AsInForce)
    }

    /// Adds a word.
    ///
    /// # Errors
    /// If the block has this word already.
    pub fn counted(&mut self, address: Address, value: f64, counting: NumberCounting) -> Result<(), String> {
        if self.words.iter().any(|word| word.address == address) {
            return Err(match address {
                Address::Axis(letter) => format!("two {letter} words in one block"),
                _ => format!("two words for {address:?} in one block"),
            });
        }
        self.words.push(Word { address, value, counting });
        Ok(())
    }

    /// Takes a word out.
    pub fn take(&mut self, address: Address) -> Option<f64> {
        self.take_counted(address).map(|word| word.value)
    }

    /// Takes a word out, with how it counts.
    pub fn take_counted(&mut self, address: Address) -> Option<Word> {
        let index = self.words.iter().position(|word| word.address == address)?;
        Some(self.words.remove(index))
    }

    /// Whether an axis word is left.
    #[must_use]
    pub fn has_axes(&self) -> bool {
        self.words.iter().any(|word| matches!(word.address, Address::Axis(_)))
    }

    /// Refuses what no code of the block has taken.
    ///
    /// # Errors
    /// If a word is left.
    pub fn finish(&self) -> Result<(), String> {
        match self.words.first() {
            Some(word) => Err(format!("the word for {:?} has no business in this block", word.address)),
            None => Ok(()),
        }
    }
}

/// A whole number of 0 to 99 999.
///
/// # Errors
/// If it is not.
pub fn whole(value: f64) -> Result<u32, String> {
    let rounded = value.round();
    if (value - rounded).abs() < 1e-9 && (0.0..=99_999.0).contains(&rounded) {
        Ok(rounded as u32)
    } else {
        Err(format!("{value} is not a whole number"))
    }
}
