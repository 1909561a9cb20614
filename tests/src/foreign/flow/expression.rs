//! Values: numbers, variables, operators and functions of each control.
//!
//! Text has no blanks on ISO and Heidenhain, where they have no meaning, and is in upper case.

use std::collections::{BTreeMap, BTreeSet};

use super::super::Control::{self, Fanuc, Haas, Heidenhain, LinuxCnc, Siemens};
use super::super::lexer::Number;

/// Why a value cannot be computed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Fault {
    /// It depends on what the program does not set: a measured value, a variable of an earlier program.
    Unknown,
    /// No control would compute it.
    Wrong(String),
}

impl Fault {
    pub(super) fn text(self) -> String {
        match self {
            Self::Unknown => "the value of a variable is unknown".to_owned(),
            Self::Wrong(why) => why,
        }
    }
}

pub(super) fn wrong<T>(why: &str) -> Result<T, Fault> {
    Err(Fault::Wrong(why.to_owned()))
}

/// Values that the program has set. A variable without one is unknown.
#[derive(Debug, Default)]
pub(super) struct Variables {
    global: BTreeMap<String, f64>,
    /// Variables of each call, that of the main program first.
    local: Vec<BTreeMap<String, f64>>,
    /// Names declared with DEF, and those of them that hold whole numbers.
    pub(super) declared: BTreeSet<String>,
    pub(super) whole: BTreeSet<String>,
}

impl Variables {
    pub(super) fn begin(&mut self, local: BTreeMap<String, f64>) {
        self.local.push(local);
    }

    pub(super) fn end(&mut self) {
        self.local.pop();
    }

    /// Nothing is known any longer.
    pub(super) fn forget(&mut self) {
        self.global.clear();
        self.local.iter_mut().for_each(BTreeMap::clear);
    }

    fn table(&mut self, control: Control, name: &str) -> &mut BTreeMap<String, f64> {
        let local = self.local.last_mut().filter(|_| is_local(control, name));
        local.unwrap_or(&mut self.global)
    }

    fn get(&self, control: Control, name: &str) -> Result<f64, Fault> {
        let local = self.local.last().filter(|_| is_local(control, name));
        local.unwrap_or(&self.global).get(name).copied().ok_or(Fault::Unknown)
    }

    /// Sets a variable; `None`: its value is unknown from here on.
    pub(super) fn set(&mut self, control: Control, name: &str, value: Option<f64>) {
        let value = value.map(|value| if self.whole.contains(name) { value.round() } else { value });
        match value {
            Some(value) => self.table(control, name).insert(name.to_owned(), value),
            None => self.table(control, name).remove(name),
        };
    }
}

/// Whether each call has a variable of this name of its own.
fn is_local(control: Control, name: &str) -> bool {
    let number = name[1..].parse::<u32>();
    match control {
        LinuxCnc => number.map_or(!name.starts_with("#<_"), |number| number <= 30),
        Fanuc | Haas => number.is_ok_and(|number| number <= 33),
        Siemens => !is_arithmetic(name),
        Heidenhain => false,
    }
}

/// R parameter of Siemens.
fn is_arithmetic(name: &str) -> bool {
    name.strip_prefix('R')
        .is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()))
}

/// Binary operators, those that bind least first; of two in one row the longer one first.
fn operators(control: Control) -> &'static [&'static [&'static str]] {
    match control {
        LinuxCnc => {
            &[&["AND", "XOR", "OR"], &["EQ", "NE", "GT", "GE", "LT", "LE"], &["+", "-"], &["*", "/", "MOD"], &["**"]]
        }
        Fanuc | Haas => &[&["EQ", "NE", "GT", "GE", "LT", "LE"], &["+", "-", "XOR", "OR"], &["*", "/", "MOD", "AND"]],
        Siemens => {
            &[&["==", "<>", ">=", "<=", ">", "<"], &["OR"], &["XOR"], &["AND"], &["+", "-"], &["*", "/", "DIV", "MOD"]]
        }
        Heidenhain => &[&["+", "-"], &["*", "/"], &["^"]],
    }
}

const FUNCTIONS: &[&str] = &[
    "ATAN2", "ATAN", "ASIN", "ACOS", "SIN", "COS", "TAN", "SQRT", "SQ", "POT", "ABS", "ROUND", "FIX", "FUP", "TRUNC",
    "INT", "FRAC", "NEG", "NOT",
];

/// Reads values from the beginning of a text.
#[derive(Debug, Clone, Copy)]
pub(super) struct ValueReader<'a> {
    pub(super) control: Control,
    pub(super) text: &'a str,
    pub(super) variables: &'a Variables,
}

impl<'a> ValueReader<'a> {
    /// Takes a text off the beginning.
    pub(super) fn take(&mut self, piece: &str) -> bool {
        let rest = self.text.trim_start().strip_prefix(piece);
        self.text = rest.unwrap_or(self.text);
        rest.is_some()
    }

    fn word(&mut self, word: &str) -> bool {
        let mut other = *self;
        // A name may begin like an operator where blanks separate.
        let goes_on = |text: &str| text.starts_with(|next: char| next.is_ascii_alphanumeric() || next == '_');
        let named = self.control == Siemens && word.starts_with(|first: char| first.is_ascii_alphabetic());
        let power = word == "*" && self.text.trim_start().starts_with("**");
        let found = !power && other.take(word) && !(named && goes_on(other.text));
        if found {
            *self = other;
        }
        found
    }

    /// A value with its operators.
    pub(super) fn value(&mut self) -> Result<f64, Fault> {
        self.binary(operators(self.control))
    }

    /// A value that takes the whole text.
    pub(super) fn whole_text(mut self) -> Result<f64, Fault> {
        let value = self.value()?;
        if self.text.trim().is_empty() { Ok(value) } else { wrong("text after a value") }
    }

    fn binary(&mut self, rows: &[&[&str]]) -> Result<f64, Fault> {
        let Some((row, tighter)) = rows.split_first() else { return self.primary() };
        let mut value = self.binary(tighter)?;
        while let Some(operator) = row.iter().find(|operator| self.word(operator)) {
            let other = self.binary(tighter)?;
            value = self.apply(operator, value, other)?;
        }
        Ok(value)
    }

    fn apply(&self, operator: &str, one: f64, other: f64) -> Result<f64, Fault> {
        let truth = |holds: bool| Ok(f64::from(u8::from(holds)));
        let relation =
            matches!(operator, "EQ" | "NE" | "GT" | "GE" | "LT" | "LE" | "==" | "<>" | ">" | ">=" | "<" | "<=");
        // Controls compare with tolerances of their own.
        let tolerance = if self.control == LinuxCnc { 1e-4 } else { 1e-9 };
        let apart = (one - other).abs();
        if relation && apart > 0.0 && apart < tolerance * one.abs().max(1.0) {
            return Err(Fault::Unknown);
        }
        match operator {
            "EQ" | "==" => truth(apart == 0.0),
            "NE" | "<>" => truth(apart > 0.0),
            "GT" | ">" => truth(one > other),
            "GE" | ">=" => truth(one >= other),
            "LT" | "<" => truth(one < other),
            "LE" | "<=" => truth(one <= other),
            "AND" | "OR" | "XOR" if !matches!(self.control, Fanuc | Haas) => {
                let (one, other) = (one != 0.0, other != 0.0);
                truth(match operator {
                    "AND" => one && other,
                    "OR" => one || other,
                    _ => one != other,
                })
            }
            "AND" => Ok((index(one)? & index(other)?).into()),
            "OR" => Ok((index(one)? | index(other)?).into()),
            "XOR" => Ok((index(one)? ^ index(other)?).into()),
            "+" => Ok(one + other),
            "-" => Ok(one - other),
            "*" => Ok(one * other),
            "/" | "DIV" | "MOD" if other == 0.0 => wrong("a division by zero"),
            "/" => Ok(one / other),
            "DIV" => Ok((one / other).trunc()),
            "MOD" if self.control == LinuxCnc => Ok(one.rem_euclid(other)),
            "MOD" => Ok(one % other),
            _ => finite(one.powf(other)),
        }
    }

    fn bracketed(&mut self) -> Result<f64, Fault> {
        let (open, close) = self.brackets();
        if !self.take(open) {
            return wrong("a bracket is missing");
        }
        let value = self.value()?;
        if self.take(close) { Ok(value) } else { wrong("a bracket does not close") }
    }

    fn brackets(&self) -> (&'static str, &'static str) {
        if matches!(self.control, Siemens | Heidenhain) { ("(", ")") } else { ("[", "]") }
    }

    /// A number, a variable, a bracket or a function, with its sign.
    pub(super) fn primary(&mut self) -> Result<f64, Fault> {
        self.text = self.text.trim_start();
        if self.take("-") {
            return self.primary().map(|value| -value);
        }
        if self.take("+") {
            return self.primary();
        }
        if self.text.starts_with(self.brackets().0) {
            return self.bracketed();
        }
        if let Some((number, rest)) = Number::take(self.text) {
            self.text = rest;
            return Ok(number.value);
        }
        if let Some(function) = FUNCTIONS.iter().find(|function| self.word(function)) {
            return self.function(function);
        }
        for (name, value) in
            [("TRUE", 1.0), ("FALSE", 0.0), ("$PI", std::f64::consts::PI), ("PI", std::f64::consts::PI)]
        {
            if matches!(self.control, Siemens | Heidenhain) && self.word(name) {
                return Ok(value);
            }
        }
        let name = self.name()?;
        self.variables.get(self.control, &name)
    }

    fn function(&mut self, name: &str) -> Result<f64, Fault> {
        let iso = !matches!(self.control, Siemens | Heidenhain);
        if name == "ATAN2" {
            let opened = self.take("(");
            let one = self.value()?;
            let comma = self.take(",");
            let other = self.value()?;
            let whole = opened && comma && self.take(")");
            return if whole { Ok(one.atan2(other).to_degrees()) } else { wrong("ATAN2 without two values") };
        }
        let value = if iso { self.bracketed()? } else { self.primary()? };
        if name == "ATAN" && iso && self.take("/") {
            let angle = value.atan2(self.primary()?).to_degrees();
            // A parameter of Fanuc decides between -90 and 270 degrees.
            return if angle < 0.0 && self.control != LinuxCnc { Err(Fault::Unknown) } else { Ok(angle) };
        }
        match name {
            "SIN" => Ok(value.to_radians().sin()),
            "COS" => Ok(value.to_radians().cos()),
            "TAN" => Ok(value.to_radians().tan()),
            "ASIN" => finite(value.asin().to_degrees()),
            "ACOS" => finite(value.acos().to_degrees()),
            "ATAN" => Ok(value.atan().to_degrees()),
            "SQRT" => finite(value.sqrt()),
            "SQ" | "POT" => Ok(value * value),
            "ABS" => Ok(value.abs()),
            "ROUND" => Ok(value.round()),
            "FIX" if self.control == LinuxCnc => Ok(value.floor()),
            "FUP" if self.control == LinuxCnc => Ok(value.ceil()),
            "FIX" | "TRUNC" | "INT" => Ok(value.trunc()),
            "FUP" => Ok(value.signum() * value.abs().ceil()),
            "FRAC" => Ok(value.fract()),
            "NEG" => Ok(-value),
            _ => Ok(f64::from(u8::from(value == 0.0))),
        }
    }

    /// The name of a variable: `#5`, `#[#1+2]`, `#<NAME>`, `R5`, `R[R1]`, a declared name, `Q5`, `QL5`.
    pub(super) fn name(&mut self) -> Result<String, Fault> {
        match self.control {
            LinuxCnc | Fanuc | Haas => {
                if !self.take("#") {
                    return wrong("not a value");
                }
                if self.control == LinuxCnc && self.text.starts_with('<') {
                    let Some((name, rest)) = self.text.split_once('>') else { return wrong("a name does not end") };
                    self.text = rest;
                    return Ok(format!("#{name}>"));
                }
                Ok(format!("#{}", index(self.primary()?)?))
            }
            Siemens => {
                if self.take("R[") {
                    let number = index(self.value()?)?;
                    return if self.take("]") { Ok(format!("R{number}")) } else { wrong("an index does not end") };
                }
                if self.text.trim_start().starts_with('$') {
                    return Err(Fault::Unknown);
                }
                let name = self.identifier();
                let known = is_arithmetic(&name) || self.variables.declared.contains(&name);
                if known { Ok(name) } else { wrong("not a value") }
            }
            Heidenhain => {
                let name = self.identifier();
                if is_parameter(&name) { Ok(name) } else { wrong("not a value") }
            }
        }
    }

    fn identifier(&mut self) -> String {
        let text = self.text.trim_start();
        let parameter = ["QL", "QR", "Q"].iter().find(|start| self.control == Heidenhain && text.starts_with(**start));
        let letters = parameter.map_or(0, |start| start.len());
        let goes_on = |next: &char| match parameter {
            Some(_) => next.is_ascii_digit(),
            None => next.is_ascii_alphanumeric() || *next == '_',
        };
        let length = letters + text[letters..].chars().take_while(goes_on).count();
        self.text = &text[length..];
        text[..length].to_owned()
    }
}

/// Q parameter of Heidenhain.
pub(super) fn is_parameter(name: &str) -> bool {
    let digits = name.strip_prefix("QL").or_else(|| name.strip_prefix("QR")).or_else(|| name.strip_prefix('Q'));
    digits.is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit()))
}

fn finite(value: f64) -> Result<f64, Fault> {
    if value.is_finite() { Ok(value) } else { wrong("a function without a value") }
}

/// A whole number that counts.
pub(super) fn index(value: f64) -> Result<u32, Fault> {
    let rounded = value.round();
    let whole = (value - rounded).abs() < 1e-9 && (0.0..=99_999_999.0).contains(&rounded);
    if whole { Ok(rounded as u32) } else { wrong("not a whole number") }
}
