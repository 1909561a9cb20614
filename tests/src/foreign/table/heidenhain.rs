//! Statements of a Heidenhain conversational program.
//!
//! A statement begins with what it is (L, CC, C, CP, CR, TOOL CALL, CYCL DEF ..). FMAX, M codes and the kind of motion
//! hold for their block alone; words, F and the radius compensation stay in force. The tool axis of TOOL CALL is the
//! normal of the plane.

use super::super::lexer::{Number, Token};
use super::super::meaning::{Address, Command, Meaning, NumberCounting, Supply};
use super::super::state::{
    Compensation, Cycle, CycleKind, Interpolation, MotionMode, Plane, RotaryPath, Spindle, State, TiltedPlane,
    WorkOffset,
};
use super::{geometry, others};

#[rustfmt::skip]
static M: &[(u32, Meaning)] = &[
    (0, Meaning::Stop),
    (1, Meaning::OptionalStop),
    (2, Meaning::End),
    (3, Meaning::Spindle(Spindle::Clockwise)),
    (4, Meaning::Spindle(Spindle::CounterClockwise)),
    (5, Meaning::Spindle(Spindle::Off)),
    (8, Meaning::CoolantOn(Supply::Flood)),
    (9, Meaning::CoolantOff(Supply::FloodAndMist)),
    (30, Meaning::End),
    (91, Meaning::MachineCoordinates),
    (99, Meaning::Call),
    (126, Meaning::RotaryPath(RotaryPath::Shortest)),
    (127, Meaning::RotaryPath(RotaryPath::AsProgrammed)),
    (128, Meaning::TipControl(true)),
    (129, Meaning::TipControl(false)),
];

/// The block that some tokens mean.
pub(super) fn command(tokens: &[Token], _: &State) -> Result<Command, String> {
    let mut command = Command::default();
    let name = |index: usize| match tokens.get(index) {
        Some(Token::Name(name)) => name.as_str(),
        _ => "",
    };
    match (name(0), name(1)) {
        ("L" | "LN", _) => {
            command.code(Meaning::Motion(motion_of_line(tokens)))?;
            words(&mut command, &tokens[1..])?;
        }
        ("CC", _) => {
            command.code(Meaning::Pole)?;
            words(&mut command, &tokens[1..])?;
            if command.meanings.len() > 1 || command.words.len() > 2 {
                return Err("a pole with other codes, or with three coordinates".to_owned());
            }
        }
        ("C" | "CP" | "CR", _) => {
            command.code(Meaning::Motion(sense(tokens)?))?;
            words(&mut command, &tokens[1..])?;
            let has = |address: Address| command.words.iter().any(|word| word.address == address);
            if (has(Address::Radius), has(Address::PolarAngle)) != (name(0) == "CR", name(0) == "CP") {
                return Err("an arc with the words of another kind of arc".to_owned());
            }
            if name(0) == "CP" && ['X', 'Y'].into_iter().any(|letter| has(Address::Axis(letter))) {
                return Err("an arc with its angle and an end".to_owned());
            }
        }
        ("TOOL", "DEF") => match &tokens[2..] {
            [Token::Number(number)] => {
                super::super::meaning::whole(number.value)?;
                command.code(Meaning::Idle)?;
            }
            _ => return Err("TOOL DEF without its number".to_owned()),
        },
        ("TOOL", "CALL") => tool_call(&mut command, &tokens[2..])?,
        ("CYCL", "DEF") => cycle_definition(&mut command, &tokens[2..])?,
        ("PLANE", _) => plane(&mut command, &tokens[1..])?,
        ("FUNCTION", _) => function(&mut command, &tokens[1..])?,
        _ => {
            words(&mut command, tokens)?;
            if !command.words.is_empty()
                || command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Compensation(_)))
            {
                return Err("words without the statement that they belong to".to_owned());
            }
        }
    }
    Ok(command)
}

fn motion_of_line(tokens: &[Token]) -> MotionMode {
    let rapid = tokens.iter().any(|token| matches!(token, Token::Name(name) if name == "FMAX"));
    if rapid { MotionMode::Rapid } else { MotionMode::Feed }
}

/// DR of an arc.
fn sense(tokens: &[Token]) -> Result<MotionMode, String> {
    let is = |wanted: &str| tokens.iter().any(|token| matches!(token, Token::Name(name) if name == wanted));
    match (is("DR+"), is("DR-")) {
        (true, false) => Ok(MotionMode::CounterClockwise),
        (false, true) => Ok(MotionMode::Clockwise),
        _ => Err("an arc without its sense DR".to_owned()),
    }
}

/// Axes, F, radius compensation, parameters of an arc, M codes.
fn words(command: &mut Command, tokens: &[Token]) -> Result<(), String> {
    let motion = command.meanings.iter().any(|meaning| matches!(meaning, Meaning::Motion(_)));
    let turns =
        |meaning: &Meaning| matches!(meaning, Meaning::Motion(MotionMode::Clockwise | MotionMode::CounterClockwise));
    let arc = command.meanings.iter().any(turns);
    let is_word = |wanted: &str| tokens.iter().any(|token| matches!(token, Token::Word { name, .. } if name == wanted));
    if is_word("F") && tokens.iter().any(|token| matches!(token, Token::Name(name) if name == "FMAX")) {
        return Err("F and FMAX in one block".to_owned());
    }
    for token in tokens {
        match token {
            Token::Word { name, number, counting } => word(command, name, *number, *counting)?,
            Token::Name(name) => match name.as_str() {
                "FMAX" if motion && !arc => {}
                "DR+" | "DR-" if arc => {}
                "RL" => command.code(Meaning::Compensation(Compensation::Left(None)))?,
                "RR" => command.code(Meaning::Compensation(Compensation::Right(None)))?,
                _ => return Err(format!("{name} is unknown here")),
            },
            Token::Number(_) | Token::Call { .. } => return Err("a number without a word".to_owned()),
        }
    }
    Ok(())
}

fn word(command: &mut Command, name: &str, number: Number, counting: NumberCounting) -> Result<(), String> {
    let Number { value, point } = number;
    let absolute = counting == NumberCounting::AsInForce;
    let address = match name {
        "X" | "Y" | "Z" | "U" | "V" | "W" | "A" | "B" | "C" => {
            return command.counted(Address::Axis(name.chars().next().unwrap_or_default()), value, counting);
        }
        "PA" if !absolute => return command.word(Address::PolarAngle, value),
        "TX" if absolute => Address::Vector(0),
        "TY" if absolute => Address::Vector(1),
        "TZ" if absolute => Address::Vector(2),
        "F" if absolute => Address::Feed,
        "R" if absolute && !point && value.abs() < 1e-12 => {
            return command.code(Meaning::Compensation(Compensation::Off));
        }
        "R" if absolute => Address::Radius,
        "M" if absolute => {
            let code = super::super::meaning::whole(value)?;
            let row = M.iter().find(|(known, _)| *known == code);
            return command.code(row.ok_or_else(|| format!("M{code} is unknown"))?.1);
        }
        _ => return Err(format!("{name} is unknown here")),
    };
    command.word(address, value)
}

/// `TOOL CALL 5 Z S8000 DR-6`, `TOOL CALL S8000`.
fn tool_call(command: &mut Command, tokens: &[Token]) -> Result<(), String> {
    let mut rest = tokens;
    if let [Token::Number(number), Token::Name(axis), after @ ..] = rest {
        let plane = match axis.as_str() {
            "Z" => Plane::Xy,
            "Y" => Plane::Zx,
            "X" => Plane::Yz,
            _ => return Err(format!("{axis} is no tool axis")),
        };
        command.code(Meaning::ToolChange)?;
        command.code(Meaning::Plane(plane))?;
        command.code(Meaning::LengthOn)?;
        command.word(Address::Tool, number.value)?;
        command.word(Address::LengthRegister, number.value)?;
        rest = after;
    }
    match rest {
        [Token::Word { name, number, .. }, more @ ..] if name == "S" => {
            command.code(Meaning::Idle)?;
            command.word(Address::Speed, number.value)?;
            match more {
                [] => Ok(()),
                [Token::Word { name, number, .. }] if name == "DR" => command.word(Address::RadiusDelta, number.value),
                _ => Err("TOOL CALL in a form that is unknown here".to_owned()),
            }
        }
        _ => Err("TOOL CALL in a form that is unknown here".to_owned()),
    }
}

/// `PLANE SPATIAL SPA+45 SPB+0 SPC+90 TURN MB MAX FMAX SEQ- COORD ROT`, `PLANE RESET STAY`.
fn plane(command: &mut Command, tokens: &[Token]) -> Result<(), String> {
    let names: Vec<&str> = tokens.iter().map(|token| if let Token::Name(name) = token { name } else { "" }).collect();
    if matches!(names[..], ["RESET", "TURN" | "MOVE", ..]) {
        return command.code(Meaning::TiltOffTurning);
    }
    if names == ["RESET", "STAY"] {
        return command.code(Meaning::TiltOff);
    }
    let mut angles = [0.0; 3];
    for ((angle, wanted), token) in angles.iter_mut().zip(["SPA", "SPB", "SPC"]).zip(tokens.iter().skip(1)) {
        match token {
            Token::Word { name, number, .. } if name == wanted => *angle = number.value,
            _ => return Err(format!("PLANE SPATIAL without {wanted}")),
        }
    }
    let solution = match names.iter().find(|name| name.starts_with("SEQ")) {
        Some(&"SEQ+") => 1,
        Some(&"SEQ-") => -1,
        Some(_) => return Err("SEQ in a form that is unknown here".to_owned()),
        None => 0,
    };
    let turn: Vec<&str> = names.iter().skip(4).copied().filter(|name| !name.starts_with("SEQ")).collect();
    if names.first() != Some(&"SPATIAL") || turn != ["TURN", "MB", "MAX", "FMAX", "COORD", "ROT"] {
        return Err("a tilted plane in a form that is unknown here".to_owned());
    }
    command.tilt = Some(TiltedPlane { rotation: geometry::fixed(angles), origin: [0.0; 3], oriented: true, solution });
    command.code(Meaning::Tilt)
}

/// `FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS`, `FUNCTION RESET TCPM`.
fn function(command: &mut Command, tokens: &[Token]) -> Result<(), String> {
    let names: Vec<&str> = tokens.iter().map(|token| if let Token::Name(name) = token { name } else { "" }).collect();
    let path = match names.as_slice() {
        ["RESET", "TCPM"] => return command.code(Meaning::TipControl(false)),
        ["TCPM", "F", "TCP", "AXIS", "POS", "PATHCTRL", path] => *path,
        _ => return Err("a FUNCTION that is unknown here".to_owned()),
    };
    command.code(Meaning::Interpolation(match path {
        "AXIS" => Interpolation::RotaryAxes,
        "VECTOR" => Interpolation::Vector,
        _ => return Err(format!("PATHCTRL {path} is unknown here")),
    }))?;
    command.code(Meaning::TipControl(true))
}

/// `CYCL DEF 200 DRILLING Q200=+2 ..` and the cycles with a point in their number.
fn cycle_definition(command: &mut Command, tokens: &[Token]) -> Result<(), String> {
    let [Token::Number(Number { value: number, .. }), parameters @ ..] = tokens else {
        return Err("CYCL DEF without its number".to_owned());
    };
    let twice = |(index, token): (usize, &Token)| match token {
        Token::Word { name, .. } => {
            parameters[..index].iter().any(|other| matches!(other, Token::Word { name: other, .. } if other == name))
        }
        _ => false,
    };
    if parameters.iter().enumerate().any(twice) {
        return Err("a parameter of a cycle twice".to_owned());
    }
    let q = |wanted: u32| {
        parameters.iter().find_map(|token| match token {
            Token::Word { name, number, .. } if *name == format!("Q{wanted}") => Some(number.value),
            _ => None,
        })
    };
    match (number * 10.0).round() as u32 {
        // The title of the dwell, and the tolerance of the control.
        90 if !matches!(parameters, [Token::Name(dwell), Token::Name(time)] if dwell == "DWELL" && time == "TIME") => {
            Err("a dwell without its title".to_owned())
        }
        90 => command.code(Meaning::Idle),
        91 => match parameters {
            [Token::Name(name), Token::Number(seconds)] if name == "DWELL" => {
                command.code(Meaning::Dwell)?;
                command.word(Address::Seconds, seconds.value)
            }
            _ => Err("a dwell without its time".to_owned()),
        },
        code @ 320..=322 => {
            command.code(Meaning::Smoothing)?;
            if code == 320 && parameters.is_empty() {
                return Err("a cycle without its title".to_owned());
            }
            for token in parameters {
                match (code, token) {
                    (321, Token::Word { name, number, .. }) if name == "T" => {
                        command.word(Address::Smoothing(0), number.value)?;
                    }
                    (322, Token::Word { name, number, .. }) if name == "TA" => {
                        command.word(Address::Smoothing(2), number.value)?;
                    }
                    (322, Token::Name(name)) if name == "HSC-MODE:0" || name == "HSC-MODE:1" => {
                        let mode = if name.ends_with('1') { 1.0 } else { 0.0 };
                        command.word(Address::Smoothing(1), mode)?;
                    }
                    (320, Token::Name(name)) if name == "TOLERANCE" => {}
                    _ => return Err("a tolerance in a form that is unknown here".to_owned()),
                }
            }
            Ok(())
        }
        2470 => {
            let row = q(339).ok_or("a datum without its number")?;
            if let Some(number) = (1..1000).find(|number| *number != 339 && q(*number).is_some()) {
                return Err(format!("Q{number} is no parameter of this cycle"));
            }
            command.code(Meaning::WorkOffset(WorkOffset::Row(super::super::meaning::whole(row)?)))
        }
        code if code % 10 == 0 => {
            if let Some(number) = (1..1000).find(|number| q(*number).is_some() && !takes(code / 10, *number)) {
                return Err(format!("Q{number} is no parameter of this cycle"));
            }
            // Those that `hole` reads are compared as levels, steps and times.
            let read = [200, 201, 202, 203, 204, 206, 211, 213, 239, 257];
            let more =
                others(code / 10, (1..1000).filter(|number| !read.contains(number)).map(|number| (number, q(number))));
            let cycle = hole(code / 10, q).map(|cycle| Cycle { others: more, ..cycle });
            command.cycle = Some(cycle.ok_or_else(|| format!("cycle {number} in a form that is unknown here"))?);
            Ok(())
        }
        _ => Err(format!("cycle {number} is unknown")),
    }
}

/// Whether a cycle has a parameter (TNC 640, cycle programming).
fn takes(cycle: u32, parameter: u32) -> bool {
    let own: &[u32] = match cycle {
        200 => &[202, 206, 210, 211, 395],
        201 => &[206, 208, 211],
        203 => &[202, 205, 206, 208, 210, 211, 212, 213, 256, 395],
        205 => &[202, 205, 206, 208, 211, 212, 253, 256, 257, 258, 259, 379, 395],
        207 => &[239],
        _ => return true,
    };
    [200, 201, 203, 204].contains(&parameter) || own.contains(&parameter)
}

/// Cycles that make one hole. Q203 surface, Q201 depth with its sign, Q200 clearance, Q204 second clearance, Q202 step,
/// Q212 decrement of the step, Q213 chip breaks, Q257 depth of a chip break, Q239 pitch, Q211 dwell, Q206 feed.
fn hole(number: u32, q: impl Fn(u32) -> Option<f64>) -> Option<Cycle> {
    let (surface, depth) = (q(203)?, -q(201)?);
    let reference = surface + q(200)?;
    let step = q(202).filter(|step| *step > 0.0 && *step < depth);
    let even = q(212).is_none_or(|decrement| decrement.abs() < 1e-12);
    let positive = |number: u32| q(number).filter(|value| *value > 0.0);
    let kind = match number {
        200 => step.map_or(CycleKind::Drill, |step| CycleKind::Peck { step }),
        201 => CycleKind::Ream,
        203 if even => match (step, positive(213)) {
            // With fewer chip breaks than steps the tool comes out between them.
            (Some(step), Some(breaks)) if breaks + 1.0 >= (depth / step).ceil() => CycleKind::ChipBreak { step },
            (Some(step), _) => CycleKind::Peck { step },
            (None, _) => CycleKind::Drill,
        },
        205 if even => match (positive(257), step) {
            (Some(step), _) => CycleKind::ChipBreak { step },
            (None, Some(step)) => CycleKind::Peck { step },
            (None, None) => CycleKind::Drill,
        },
        207 => CycleKind::Tap { pitch: q(239)? },
        _ => return None,
    };
    let back_to = (surface + q(204)?).max(reference);
    let feed = if number == 207 { None } else { Some(q(206)?) };
    Some(Cycle {
        kind,
        reference,
        bottom: surface - depth,
        back_to: Some(back_to),
        dwell_s: q(211).unwrap_or(0.0),
        feed,
        others: 0,
    })
}
