//! Codes and words of LinuxCNC, Fanuc and Haas.
//!
//! | word | with | means |
//! |---|---|---|
//! | P | G4 | a dwell: s on LinuxCNC; on Fanuc and Haas ms without a point, s with one |
//! | P | G54.1, G154 | number of the work offset |
//! | P | G64 on LinuxCNC | tolerance of the path |
//! | P, Q, E | G5.1, G187, G61.1 | smoothing by the control |
//! | P | G43.4, G43.5 | how the tool axis moves between two points |
//! | I J K | G43.5 in force | tool vector |
//! | K | G33.1 | advance per revolution |
//! | X Y Z I J K Q | G68.2, G268 | tilted plane |
//! | R, Q, P | a cycle in force | reference level, step, dwell |
//! | R | else | radius of an arc |
//! | H, D | | registers of length and radius |

use super::super::lexer::{Number, Token};
use super::super::meaning::{Address, Command, Meaning, Supply, whole};
use super::super::state::{
    Compensation, Distance, FeedMode, Interpolation, LeftOn, MotionMode, Plane, ReturnLevel, Spindle, State,
    TiltedPlane, TipControl, Units, WorkOffset,
};
use super::super::{Control, Options};
use super::geometry;

use Control::{Fanuc, Haas, LinuxCnc};

const ALL: &[Control] = &[LinuxCnc, Fanuc, Haas];

/// A code in tenths, the controls that have it, and its meaning.
type Row = (u32, &'static [Control], Meaning);

#[rustfmt::skip]
static G: &[Row] = &[
    (0, ALL, Meaning::Motion(MotionMode::Rapid)),
    (10, ALL, Meaning::Motion(MotionMode::Feed)),
    (20, ALL, Meaning::Motion(MotionMode::Clockwise)),
    (30, ALL, Meaning::Motion(MotionMode::CounterClockwise)),
    (40, ALL, Meaning::Dwell),
    (51, &[Fanuc], Meaning::Smoothing),
    (80, &[LinuxCnc], Meaning::Ends(LeftOn::Diameter)),
    (150, &[Fanuc], Meaning::Ends(LeftOn::Polar)),
    (170, ALL, Meaning::Plane(Plane::Xy)),
    (180, ALL, Meaning::Plane(Plane::Zx)),
    (190, ALL, Meaning::Plane(Plane::Yz)),
    (200, ALL, Meaning::Units(Units::Inches)),
    (210, ALL, Meaning::Units(Units::Millimetres)),
    (280, ALL, Meaning::Home),
    (300, ALL, Meaning::Home),
    (331, &[LinuxCnc], Meaning::RigidTap),
    (400, ALL, Meaning::Compensation(Compensation::Off)),
    (410, ALL, Meaning::Compensation(Compensation::Left(None))),
    (420, ALL, Meaning::Compensation(Compensation::Right(None))),
    (430, ALL, Meaning::LengthOn),
    (434, &[Fanuc], Meaning::LengthWithTipControl(false)),
    (435, &[Fanuc], Meaning::LengthWithTipControl(true)),
    (490, ALL, Meaning::LengthOff),
    (500, &[Fanuc, Haas], Meaning::Ends(LeftOn::Scaling)),
    (530, ALL, Meaning::MachineCoordinates),
    (531, &[Fanuc], Meaning::Orient),
    (540, ALL, Meaning::WorkOffset(WorkOffset::Code(540))),
    (541, &[Fanuc], Meaning::FurtherOffset),
    (544, &[Fanuc], Meaning::Ends(LeftOn::SettingError)),
    (550, ALL, Meaning::WorkOffset(WorkOffset::Code(550))),
    (560, ALL, Meaning::WorkOffset(WorkOffset::Code(560))),
    (570, ALL, Meaning::WorkOffset(WorkOffset::Code(570))),
    (580, ALL, Meaning::WorkOffset(WorkOffset::Code(580))),
    (590, ALL, Meaning::WorkOffset(WorkOffset::Code(590))),
    (591, &[LinuxCnc], Meaning::WorkOffset(WorkOffset::Code(591))),
    (592, &[LinuxCnc], Meaning::WorkOffset(WorkOffset::Code(592))),
    (593, &[LinuxCnc], Meaning::WorkOffset(WorkOffset::Code(593))),
    (610, ALL, Meaning::ExactStop),
    (640, ALL, Meaning::Continuous),
    (682, &[Fanuc], Meaning::Tilt),
    (690, &[Fanuc], Meaning::TiltOff),
    (690, &[Haas], Meaning::Ends(LeftOn::Rotation)),
    (730, ALL, Meaning::Cycle(73)),
    (740, &[Fanuc, Haas], Meaning::Cycle(74)),
    (800, ALL, Meaning::CancelMotion),
    (810, ALL, Meaning::Cycle(81)),
    (820, ALL, Meaning::Cycle(82)),
    (830, ALL, Meaning::Cycle(83)),
    (840, &[Fanuc, Haas], Meaning::Cycle(84)),
    (850, ALL, Meaning::Cycle(85)),
    (890, ALL, Meaning::Cycle(89)),
    (900, ALL, Meaning::Distance(Distance::Absolute)),
    (901, &[LinuxCnc], Meaning::ArcCentres(Distance::Absolute)),
    (910, ALL, Meaning::Distance(Distance::Incremental)),
    (911, &[LinuxCnc], Meaning::ArcCentres(Distance::Incremental)),
    (930, ALL, Meaning::FeedMode(FeedMode::InverseTime)),
    (940, ALL, Meaning::FeedMode(FeedMode::PerMinute)),
    (950, ALL, Meaning::FeedMode(FeedMode::PerRevolution)),
    (970, &[LinuxCnc], Meaning::Ends(LeftOn::CuttingSpeed)),
    (980, ALL, Meaning::Return(ReturnLevel::Initial)),
    (990, ALL, Meaning::Return(ReturnLevel::Reference)),
    (1540, &[Haas], Meaning::FurtherOffset),
    (1870, &[Haas], Meaning::Smoothing),
    (2340, &[Haas], Meaning::LengthWithTipControl(false)),
    (2530, &[Haas], Meaning::Orient),
    (2540, &[Haas], Meaning::DynamicOffset(true)),
    (2550, &[Haas], Meaning::DynamicOffset(false)),
    (2680, &[Haas], Meaning::Tilt),
    (2690, &[Haas], Meaning::TiltOff),
];

#[rustfmt::skip]
static M: &[Row] = &[
    (0, ALL, Meaning::Stop),
    (10, ALL, Meaning::OptionalStop),
    (20, ALL, Meaning::End),
    (30, ALL, Meaning::Spindle(Spindle::Clockwise)),
    (40, ALL, Meaning::Spindle(Spindle::CounterClockwise)),
    (50, ALL, Meaning::Spindle(Spindle::Off)),
    (60, ALL, Meaning::ToolChange),
    (70, &[LinuxCnc, Fanuc], Meaning::CoolantOn(Supply::Mist)),
    (80, ALL, Meaning::CoolantOn(Supply::Flood)),
    (90, ALL, Meaning::CoolantOff(Supply::FloodAndMist)),
    (290, &[Fanuc], Meaning::RigidTapping),
    (300, &[Fanuc, Haas], Meaning::End),
    (880, &[Haas], Meaning::CoolantOn(Supply::Through)),
    (890, &[Haas], Meaning::CoolantOff(Supply::Through)),
    // Kinematics of the five-axis configurations of LinuxCNC: with the tip, and without.
    (4280, &[LinuxCnc], Meaning::TipControl(true)),
    (4290, &[LinuxCnc], Meaning::TipControl(false)),
];

fn meaning(table: &[Row], control: Control, number: Number) -> Option<Meaning> {
    let tenths = (number.value * 10.0).round();
    let exact = (number.value * 10.0 - tenths).abs() < 1e-6 && number.value.is_sign_positive();
    let row = table.iter().find(|(code, controls, _)| exact && *code == tenths as u32 && controls.contains(&control));
    row.map(|(_, _, meaning)| *meaning)
}

/// The block that some words mean.
pub(super) fn command(options: &Options, tokens: &[Token], state: &State) -> Result<Command, String> {
    let mut reader = Reader { options, state, command: Command::default(), letters: Vec::new() };
    for token in tokens {
        let Token::Word { name, number, .. } = token else { return Err("not a letter with a number".to_owned()) };
        reader.word(name.chars().next().unwrap_or_default(), *number)?;
    }
    reader.conclude()?;
    Ok(reader.command)
}

struct Reader<'a> {
    options: &'a Options,
    state: &'a State,
    command: Command,
    /// Words whose meaning the rest of the block decides.
    letters: Vec<(char, Number)>,
}

impl Reader<'_> {
    fn word(&mut self, letter: char, number: Number) -> Result<(), String> {
        let control = self.options.control;
        match letter {
            'G' | 'M' => {
                let table = if letter == 'G' { G } else { M };
                let meaning = meaning(table, control, number)
                    .ok_or_else(|| format!("{letter}{} has no business in this program: unknown", number.value))?;
                self.command.code(meaning)
            }
            // A sequence number in the middle.
            'N' if self.options.careless && control != LinuxCnc => Ok(()),
            'S' => self.command.word(Address::Speed, number.value),
            'T' => self.command.word(Address::Tool, number.value),
            'H' => self.command.word(Address::LengthRegister, number.value),
            'D' => self.command.word(Address::RadiusRegister, number.value),
            'F' if control == Haas && !number.point && !self.options.plain_numbers => {
                Err("an F without a decimal point counts as a setting of the control says".to_owned())
            }
            'F' => self.command.word(Address::Feed, number.value),
            'X' | 'Y' | 'Z' | 'U' | 'V' | 'W' | 'A' | 'B' | 'C' | 'I' | 'J' | 'K' | 'P' | 'Q' | 'R' | 'E' => {
                if self.letters.iter().any(|(other, _)| *other == letter) {
                    return Err(format!("two {letter} words in one block"));
                }
                self.letters.push((letter, number));
                Ok(())
            }
            _ => Err(format!("the letter {letter} has no business in this program")),
        }
    }

    fn take(&mut self, letter: char) -> Option<Number> {
        let index = self.letters.iter().position(|(other, _)| *other == letter)?;
        Some(self.letters.remove(index).1)
    }

    /// A length or an angle. Where Fanuc and Haas read no point, a setting says what it counts.
    fn length(&self, number: Number) -> Result<f64, String> {
        let plain = number.point || self.options.plain_numbers || self.options.control == LinuxCnc;
        let known = plain || number.value.abs() <= 0.0;
        known.then_some(number.value).ok_or_else(|| "a number without a point".to_owned())
    }

    fn seconds(&self, number: Number) -> f64 {
        if number.point || self.options.control == LinuxCnc { number.value } else { number.value / 1000.0 }
    }

    /// Gives every letter to the code that it belongs to.
    fn conclude(&mut self) -> Result<(), String> {
        if self.command.has(Meaning::Dwell) {
            let time = self.take('P').ok_or("a dwell without its time")?;
            self.command.word(Address::Seconds, self.seconds(time))?;
        }
        if self.command.has(Meaning::Ends(LeftOn::SettingError)) {
            let off = self.take('P').is_some_and(|number| number.value.abs() < 1e-9);
            off.then_some(()).ok_or("a compensation of the place of the part")?;
        }
        if self.command.has(Meaning::FurtherOffset) {
            let number = self.take('P').ok_or("a work offset without its number")?;
            self.command.word(Address::OffsetNumber, number.value)?;
        }
        if self.command.has(Meaning::Continuous)
            && self.options.control == LinuxCnc
            && let Some(tolerance) = self.take('P')
        {
            self.command.word(Address::PathTolerance, tolerance.value)?;
        }
        if self.command.has(Meaning::Smoothing) {
            for (index, letter) in ['P', 'Q', 'E'].into_iter().enumerate() {
                if let Some(number) = self.take(letter) {
                    self.command.word(Address::Smoothing(index), number.value)?;
                }
            }
        }
        if self.command.has(Meaning::Tilt) {
            self.tilted_plane()?;
        }
        self.tip_control()?;
        if self.command.has(Meaning::RigidTap) {
            let pitch = self.take('K').ok_or("K is missing")?;
            self.command.word(Address::Pitch, pitch.value)?;
        }
        self.cycle()?;
        let control = self.options.control;
        let arcs = matches!(self.state.motion, Some(MotionMode::Clockwise | MotionMode::CounterClockwise))
            || self.command.meanings.iter().any(|meaning| meaning.group() == Meaning::CancelMotion.group());
        for (letter, number) in std::mem::take(&mut self.letters) {
            let value = self.length(number)?;
            let address = match letter {
                'I' => Address::Centre(0),
                'J' => Address::Centre(1),
                'K' => Address::Centre(2),
                // Alone it moves nothing.
                'R' if self.options.careless && control != LinuxCnc && !self.command.has_axes() && !arcs => continue,
                'R' => Address::Radius,
                'P' | 'Q' | 'E' => return Err(format!("{letter} has no business in this block")),
                axis => Address::Axis(axis),
            };
            self.command.word(address, value)?;
        }
        Ok(())
    }

    fn tilted_plane(&mut self) -> Result<(), String> {
        let mut numbers = [0.0; 6];
        for (value, letter) in numbers.iter_mut().zip(['X', 'Y', 'Z', 'I', 'J', 'K']) {
            let number = self.take(letter).ok_or_else(|| format!("a tilted plane without {letter}"))?;
            *value = self.length(number)?;
        }
        let [x, y, z, i, j, k] = numbers;
        let rotation = match (self.options.control, self.take('Q').map(|order| order.value)) {
            (Fanuc, None) => geometry::euler([i, j, k]),
            (Haas, Some(order)) if (order - 123.0).abs() < 1e-9 => geometry::fixed([i, j, k]),
            _ => return Err("a tilted plane in a form that is unknown here".to_owned()),
        };
        self.command.tilt = Some(TiltedPlane { rotation, origin: [x, y, z], oriented: false, solution: 0 });
        Ok(())
    }

    fn tip_control(&mut self) -> Result<(), String> {
        let begins = self.command.meanings.iter().find_map(|meaning| match meaning {
            Meaning::LengthWithTipControl(vectors) => Some(*vectors),
            _ => None,
        });
        if begins.is_some() && self.options.control == Fanuc {
            match self.take('P').map(|number| whole(number.value)).transpose()? {
                // A parameter of the machine decides.
                None => {}
                Some(0) => self.command.code(Meaning::Interpolation(Interpolation::RotaryAxes))?,
                Some(1) => self.command.code(Meaning::Interpolation(Interpolation::Vector))?,
                Some(_) => return Err("a form of tip control that is unknown here".to_owned()),
            }
        }
        let ends = self.command.has(Meaning::LengthOff) || self.command.has(Meaning::LengthOn);
        let vectors = matches!(self.state.tip_control, Some(TipControl::On { vectors: true, .. })) && !ends;
        if begins.unwrap_or(vectors) {
            for (index, letter) in ['I', 'J', 'K'].into_iter().enumerate() {
                if let Some(number) = self.take(letter) {
                    self.command.word(Address::Vector(index), number.value)?;
                }
            }
        }
        Ok(())
    }

    /// R, Q and P of a cycle that begins here or is in force.
    fn cycle(&mut self) -> Result<(), String> {
        let begins = self.command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Cycle(_)));
        let ends = self.command.meanings.iter().any(|meaning| meaning.group() == Meaning::CancelMotion.group());
        if !begins && (ends || self.state.motion != Some(MotionMode::Cycle)) {
            return Ok(());
        }
        if let Some(level) = self.take('R') {
            self.command.word(Address::Level, self.length(level)?)?;
        }
        if let Some(step) = self.take('Q') {
            self.command.word(Address::Step, self.length(step)?)?;
        }
        if let Some(time) = self.take('P') {
            self.command.word(Address::Seconds, self.seconds(time))?;
        }
        Ok(())
    }
}
