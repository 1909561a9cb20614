//! Codes, names and calls of a Siemens 840D.
//!
//! D puts the length of a cutting edge in force, D0 none. `MCALL CYCLE8x(..)` makes its hole at every position that
//! follows, `MCALL` alone ends that; `CYCLE8x(..)` makes it where the tool is.

use super::super::lexer::Token;
use super::super::meaning::{Address, Command, Meaning, NumberCounting, Supply};
use super::super::state::{
    Compensation, Cycle, CycleKind, Distance, FeedMode, Interpolation, LeftOn, MotionMode, Plane, SMOOTHING, Spindle,
    State, TiltedPlane, Units, VectorFrame, WorkOffset,
};
use super::{geometry, others};

/// A code and its meaning.
type SiemensRow = (u32, Meaning);

#[rustfmt::skip]
static G: &[SiemensRow] = &[
    (0, Meaning::Motion(MotionMode::Rapid)),
    (1, Meaning::Motion(MotionMode::Feed)),
    (2, Meaning::Motion(MotionMode::Clockwise)),
    (3, Meaning::Motion(MotionMode::CounterClockwise)),
    (4, Meaning::Dwell),
    (17, Meaning::Plane(Plane::Xy)),
    (18, Meaning::Plane(Plane::Zx)),
    (19, Meaning::Plane(Plane::Yz)),
    (40, Meaning::Compensation(Compensation::Off)),
    (41, Meaning::Compensation(Compensation::Left(None))),
    (42, Meaning::Compensation(Compensation::Right(None))),
    (60, Meaning::ExactStop),
    (64, Meaning::Continuous),
    (90, Meaning::Distance(Distance::Absolute)),
    (91, Meaning::Distance(Distance::Incremental)),
    (93, Meaning::FeedMode(FeedMode::InverseTime)),
    (94, Meaning::FeedMode(FeedMode::PerMinute)),
    (95, Meaning::FeedMode(FeedMode::PerRevolution)),
    (700, Meaning::Units(Units::Inches)),
    (710, Meaning::Units(Units::Millimetres)),
];

#[rustfmt::skip]
static M: &[SiemensRow] = &[
    (0, Meaning::Stop),
    (1, Meaning::OptionalStop),
    (3, Meaning::Spindle(Spindle::Clockwise)),
    (4, Meaning::Spindle(Spindle::CounterClockwise)),
    (5, Meaning::Spindle(Spindle::Off)),
    (6, Meaning::ToolChange),
    (7, Meaning::CoolantOn(Supply::Mist)),
    (8, Meaning::CoolantOn(Supply::Flood)),
    (9, Meaning::CoolantOff(Supply::FloodAndMist)),
    (2, Meaning::End),
    (17, Meaning::End),
    (30, Meaning::End),
];

static NAMES: &[(&str, Meaning)] = &[
    ("SUPA", Meaning::MachineCoordinates),
    ("TRAORI", Meaning::TipControl(true)),
    ("TRAFOOF", Meaning::TipControl(false)),
    ("ORIAXES", Meaning::Interpolation(Interpolation::RotaryAxes)),
    ("ORIVECT", Meaning::Interpolation(Interpolation::Vector)),
    ("ORIMKS", Meaning::VectorFrame(VectorFrame::Machine)),
    ("ORIWKS", Meaning::VectorFrame(VectorFrame::Workpiece)),
    ("TRANS", Meaning::Ends(LeftOn::Shift)),
    ("MCALL", Meaning::ModalCall),
    ("RET", Meaning::End),
    ("STOPRE", Meaning::Idle),
];

/// The block that some tokens mean.
pub(super) fn command(tokens: &[Token], state: &State) -> Result<Command, String> {
    let mut command = Command::default();
    let dwell = tokens.iter().any(|token| {
        matches!(token, Token::Word { name, number, .. }
        if name == "G" && (number.value - 4.0).abs() < 1e-9)
    });
    let modal = tokens.iter().any(|token| matches!(token, Token::Name(name) if name == "MCALL"));
    // A subprogram is called in a block of its own: programming manual of the 840D sl, calls of subprograms.
    if tokens.len() > 1 + usize::from(modal) && tokens.iter().any(|token| matches!(token, Token::Call { .. })) {
        return Err("a call in a block with other words".to_owned());
    }
    for token in tokens {
        match token {
            Token::Word { name, number, .. } if name == "F" && dwell => command.word(Address::Seconds, number.value)?,
            Token::Word { name, number, counting } => word(&mut command, name, number.value, *counting)?,
            Token::Name(name) => {
                let row = NAMES.iter().find(|(known, _)| known == name);
                command.code(row.ok_or_else(|| format!("{name} is unknown"))?.1)?;
            }
            Token::Call { name, arguments } => call(&mut command, name, arguments, state, modal)?,
            Token::Number(_) => return Err("a number without a word".to_owned()),
        }
    }
    Ok(command)
}

fn word(command: &mut Command, name: &str, value: f64, counting: NumberCounting) -> Result<(), String> {
    let address = match name {
        "G" | "M" => {
            let known = meaning(if name == "G" { G } else { M }, name == "G", value);
            return command.code(known.ok_or_else(|| format!("{name}{value} has no business here: unknown"))?);
        }
        "X" | "Y" | "Z" | "U" | "V" | "W" | "A" | "B" | "C" => {
            let letter = name.chars().next().unwrap_or_default();
            return command.counted(Address::Axis(letter), value, counting);
        }
        "I" | "J" | "K" => {
            let index = "IJK".find(name).unwrap_or_default();
            return command.counted(Address::Centre(index), value, counting);
        }
        "A3" => Address::Vector(0),
        "B3" => Address::Vector(1),
        "C3" => Address::Vector(2),
        "CR" => Address::Radius,
        "TURN" => Address::Revolutions,
        "F" => Address::Feed,
        "S" => Address::Speed,
        "T" => Address::Tool,
        "D" => {
            let meaning = if value.abs() < 1e-9 { Meaning::LengthOff } else { Meaning::LengthOn };
            command.code(meaning)?;
            if meaning == Meaning::LengthOff {
                return Ok(());
            }
            Address::LengthRegister
        }
        _ => return Err(format!("{name} is unknown")),
    };
    command.word(address, value)
}

fn meaning(table: &[SiemensRow], g: bool, value: f64) -> Option<Meaning> {
    let code = super::super::meaning::whole(value).ok().filter(|_| value.is_sign_positive())?;
    if g && matches!(code, 54..=57 | 505..=599) {
        return Some(Meaning::WorkOffset(WorkOffset::Code(code * 10)));
    }
    table.iter().find(|(known, _)| *known == code).map(|(_, meaning)| *meaning)
}

fn call(
    command: &mut Command,
    name: &str,
    arguments: &[Option<f64>],
    state: &State,
    modal: bool,
) -> Result<(), String> {
    let number = |index: usize| arguments.get(index).copied().flatten();
    match name {
        "CYCLE800" if arguments.is_empty() => command.code(Meaning::TiltOff),
        "CYCLE800" => {
            command.tilt = Some(swivel(number).ok_or("CYCLE800 in a form that is unknown here")?);
            command.code(Meaning::Tilt)
        }
        "MSG" | "WORKPIECE" => command.code(Meaning::Idle),
        "CYCLE832" => {
            command.code(Meaning::Smoothing)?;
            for index in (0..SMOOTHING).filter(|_| !arguments.is_empty()) {
                // An argument that is left out counts as zero.
                command.word(Address::Smoothing(index), number(index).unwrap_or(0.0))?;
            }
            Ok(())
        }
        _ => {
            let kind = name.strip_prefix("CYCLE").ok_or_else(|| format!("{name} is unknown"))?;
            let cycle = cycle(kind, number, state);
            command.cycle = Some(cycle.ok_or_else(|| format!("{name} in a form that is unknown here"))?);
            if modal { Ok(()) } else { command.code(Meaning::Call) }
        }
    }
}

/// CYCLE800(FR, "TC", ST, MODE, X0, Y0, Z0, A, B, C, X1, Y1, Z1, DIR, FR_I): a new plane (ST 0), axis by axis.
fn swivel(number: impl Fn(usize) -> Option<f64>) -> Option<TiltedPlane> {
    let vector = |first: usize| Some([number(first)?, number(first + 1)?, number(first + 2)?]);
    let zero = |value: f64| value.abs() < 1e-9;
    let direction = number(13)?;
    if !zero(number(0)?) || !zero(number(2)?) || ![-1.0, 0.0, 1.0].iter().any(|known| zero(direction - known)) {
        return None;
    }
    let rotation = geometry::axis_by_axis(number(3)? as u32, vector(7)?)?;
    let shifted = geometry::rotated(&rotation, vector(10)?);
    let before = vector(4)?;
    let origin = [0, 1, 2].map(|index| before[index] + shifted[index]);
    Some(TiltedPlane { rotation, origin, oriented: !zero(direction), solution: direction.round() as i8 })
}

/// CYCLE81 to CYCLE85 (RTP, RFP, SDIS, DP, DPR, ..): return level, surface, clearance, bottom. A depth by DPR is
/// unknown here.
fn cycle(code: &str, number: impl Fn(usize) -> Option<f64>, state: &State) -> Option<Cycle> {
    let (back_to, surface, bottom) = (number(0)?, number(1)?, number(3)?);
    let reference = surface + number(2)?;
    let (mut dwell_s, mut feed) = (number(5).unwrap_or(0.0), None);
    let kind = match code {
        "81" if number(5).is_none() => CycleKind::Drill,
        "82" => CycleKind::Drill,
        "83" => {
            // FDEP, FDPR, DAM, DTB, DTS, FRF, VARI, AXN, MDEP, VRT, DTD: no step that grows smaller, a wait at the
            // bottom.
            if number(5).is_some() || number(7)?.abs() > 1e-9 {
                return None;
            }
            dwell_s = number(15).unwrap_or(0.0);
            let step = number(6)?;
            match number(11)? as u32 {
                0 => CycleKind::ChipBreak { step },
                1 => CycleKind::Peck { step },
                _ => return None,
            }
        }
        "84" => {
            // DTB, SDAC, MPIT, PIT, POSS, SST, SST1, AXN, PITA: PITA 1 is mm, 3 inches per revolution.
            let pitch_mm = number(8)? * if number(13).is_some_and(|unit| unit > 2.5) { 25.4 } else { 1.0 };
            CycleKind::Tap { pitch: pitch_mm / state.units?.in_mm() }
        }
        "85" => {
            feed = Some(number(6)?);
            CycleKind::Ream
        }
        _ => return None,
    };
    // Arguments from the fifth on, whose meaning depends on the cycle.
    let others = others(code.parse().ok()?, (4..20).map(|index| (index as u32, number(index))));
    Some(Cycle { kind, reference, bottom, back_to: Some(back_to), dwell_s, feed, others })
}
