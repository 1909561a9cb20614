//! Expressions of programs: numbers, variables, functions, comparisons. Angles are degrees.
//!
//! A value is known where it follows from numbers of the program. What a control, a probe or a clock gives is not.

use super::super::facts::LineForm;
use super::super::text::Cursor;
use super::variables::{Value, Variable, Variables};

/// What is understood of an expression: its value, or that it is none of the language.
type Parsed = Option<Value>;

/// Numbers that differ by less than this are equal in a comparison: LinuxCNC `TOLERANCE_EQUAL`.
const EQUAL: f64 = 1e-4;

/// An expression while it is read.
pub(super) struct Expression<'e, 'a> {
    pub(super) at: &'e mut Cursor<'a>,
    pub(super) variables: &'e Variables,
    /// Nesting, which is limited.
    depth: u8,
    /// The part that has been read last is one number, variable, function or bracket.
    single: bool,
}

type Relation = fn(f64, f64) -> bool;

/// Deepest nesting of brackets.
const DEEPEST: u8 = 32;

impl<'e, 'a> Expression<'e, 'a> {
    pub(super) fn new(at: &'e mut Cursor<'a>, variables: &'e Variables) -> Self {
        Self { at, variables, depth: 0, single: false }
    }

    /// A condition, or a number: what is true is 1.
    pub(super) fn condition(&mut self) -> Parsed {
        let mut value = self.comparison()?;
        let (mut alike, mut before) = (self.is_alike(value), None);
        loop {
            let and = self.operator(&["AND", "&&"]);
            if !and && !self.operator(&["OR", "||"]) {
                return Some(value);
            }
            let other = self.comparison()?;
            alike &= self.is_alike(other) && before.is_none_or(|before| before == and);
            before = Some(and);
            value = match (value, other) {
                (Some(one), Some(other)) if alike && and => Some(f64::from(one != 0.0 && other != 0.0)),
                (Some(one), Some(other)) if alike => Some(f64::from(one != 0.0 || other != 0.0)),
                _ => None,
            };
        }
    }

    /// Whether AND and OR make the same of the part that has been read on all controls of its form: Fanuc and Haas
    /// combine bits, before they add; LinuxCNC what is true, after it has compared.
    fn is_alike(&self, value: Value) -> bool {
        let is_logical = |value: f64| value.abs() < EQUAL || (value - 1.0).abs() < EQUAL;
        self.variables.form() != LineForm::Letters || self.single && value.is_none_or(is_logical)
    }

    fn comparison(&mut self) -> Parsed {
        let one = self.sum()?;
        let relations: [(&[&str], Relation); 6] = [
            (&["EQU", "EQ", "=="], |a, b| (a - b).abs() < EQUAL),
            (&["NE", "<>"], |a, b| (a - b).abs() >= EQUAL),
            (&["GE", ">="], |a, b| a > b - EQUAL),
            (&["LE", "<="], |a, b| a < b + EQUAL),
            (&["GT", ">"], |a, b| a >= b + EQUAL),
            (&["LT", "<"], |a, b| a <= b - EQUAL),
        ];
        let Some((_, holds)) = relations.into_iter().find(|(names, _)| self.operator(names)) else { return Some(one) };
        let other = self.sum()?;
        self.single = false;
        Some(one.zip(other).map(|(one, other)| f64::from(holds(one, other))))
    }

    fn sum(&mut self) -> Parsed {
        let mut value = self.product()?;
        loop {
            let minus = self.sign(b'-');
            if !minus && !self.sign(b'+') {
                return Some(value);
            }
            let other = self.product()?;
            self.single = false;
            value = value.zip(other).map(|(one, other)| if minus { one - other } else { one + other });
        }
    }

    fn product(&mut self) -> Parsed {
        let mut value = self.power()?;
        loop {
            let modulo = self.operator(&["MOD"]);
            let times = !modulo && self.sign(b'*');
            let sign = !modulo && !times && self.sign(b'/');
            let divided = sign || !modulo && !times && self.operator(&["DIV"]);
            let whole = self.variables.form() == LineForm::Keywords;
            if !modulo && !times && !divided {
                return Some(value);
            }
            let other = self.power()?;
            self.single = false;
            // Controls differ in the sign of MOD, and some in whether DIV has decimals.
            value = value.zip(other).and_then(|(one, other)| match () {
                () if times => Some(one * other),
                () if other == 0.0 => None,
                () if sign => Some(one / other),
                () if divided => Some(one / other).filter(|quotient| !whole || quotient.fract() == 0.0),
                () => (one >= 0.0 && other > 0.0).then(|| one % other),
            });
        }
    }

    fn power(&mut self) -> Parsed {
        let value = self.signed()?;
        if !self.sign(b'^') && !self.operator(&["**"]) {
            return Some(value);
        }
        let other = self.signed()?;
        self.single = false;
        Some(value.zip(other).map(|(one, other)| one.powf(other)).filter(|value| value.is_finite()))
    }

    /// A number, a variable, a function or brackets, with a sign.
    pub(super) fn signed(&mut self) -> Parsed {
        self.at.blanks();
        let minus = self.at.take(b'-');
        if !minus {
            self.at.take(b'+');
        }
        let value = self.primary()?;
        Some(value.map(|value| if minus { -value } else { value }))
    }

    fn primary(&mut self) -> Parsed {
        self.at.blanks();
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let value = match self.at.peek()? {
            b'0'..=b'9' | b'.' => Some(Some(self.at.number()?.value)),
            b'[' | b'(' => self.brackets(),
            _ => match self.variables.read(self.at) {
                Some(variable) => Some(self.variables.value(&variable)),
                None => self.function(),
            },
        };
        self.depth -= 1;
        self.single = true;
        value
    }

    fn brackets(&mut self) -> Parsed {
        let close = if self.at.take(b'[') {
            b']'
        } else {
            self.at.take(b'(').then_some(())?;
            b')'
        };
        let value = self.condition()?;
        self.at.blanks();
        self.at.take(close).then_some(value)
    }

    fn function(&mut self) -> Parsed {
        let name = self.at.name().to_ascii_uppercase();
        let unary: fn(f64) -> f64 = match &name[..] {
            b"PI" => return Some(Some(std::f64::consts::PI)),
            b"SIN" => |x| x.to_radians().sin(),
            b"COS" => |x| x.to_radians().cos(),
            b"TAN" => |x| x.to_radians().tan(),
            b"ASIN" => |x| x.asin().to_degrees(),
            b"ACOS" => |x| x.acos().to_degrees(),
            b"ATAN" | b"ATAN2" => return self.arc_tangent(),
            b"SQRT" => f64::sqrt,
            b"SQ" | b"POT" => |x| x * x,
            b"ABS" => f64::abs,
            b"ROUND" => f64::round,
            // Of what is negative Fanuc takes FIX towards zero and FUP away from it, LinuxCNC both by their order.
            b"FIX" => |x| if x >= 0.0 || x.fract() == 0.0 { x.trunc() } else { f64::NAN },
            b"FUP" => |x| if x >= 0.0 || x.fract() == 0.0 { x.ceil() } else { f64::NAN },
            b"INT" | b"TRUNC" => f64::trunc,
            b"FRAC" => f64::fract,
            b"EXP" => f64::exp,
            b"LN" => f64::ln,
            b"NEG" => |x| -x,
            _ => return None,
        };
        let value = self.argument()?.map(unary).filter(|value| value.is_finite());
        Some(if name == b"ASIN" { self.angle(value) } else { value })
    }

    /// Brackets, or on a Heidenhain a number or a variable.
    fn argument(&mut self) -> Parsed {
        self.at.blanks();
        match self.at.peek()? {
            b'[' | b'(' => self.brackets(),
            _ if self.variables.form() == LineForm::Statements => self.signed(),
            _ => None,
        }
    }

    /// `ATAN[y]/[x]`, `ATAN2(y,x)`, `ATAN x`.
    fn arc_tangent(&mut self) -> Parsed {
        self.at.blanks();
        match self.variables.form() {
            LineForm::Letters => {
                let y = self.brackets()?;
                self.sign(b'/').then_some(())?;
                let x = self.brackets()?;
                Some(self.angle(y.zip(x).map(|(y, x)| y.atan2(x).to_degrees())))
            }
            LineForm::Keywords => {
                self.at.take(b'(').then_some(())?;
                let y = self.sum()?;
                self.sign(b',').then_some(())?;
                let x = self.sum()?;
                self.sign(b')').then_some(y.zip(x).map(|(y, x)| y.atan2(x).to_degrees()))
            }
            LineForm::Statements => Some(self.argument()?.map(|value| value.atan().to_degrees())),
        }
    }

    /// An angle of ASIN or ATAN. Fanuc counts it from 0 to 360 degrees or from -180 to 180, by parameter 6004#0 (from
    /// memory): it is known where both are one.
    fn angle(&self, degrees: Value) -> Value {
        degrees.filter(|degrees| !self.variables.by_settings() || *degrees >= 0.0)
    }

    /// Takes a sign of one byte with the blanks before it, if it comes next.
    fn sign(&mut self, sign: u8) -> bool {
        let mut at = *self.at;
        at.blanks();
        let found = !(sign == b'*' && at.rest().starts_with(b"**")) && at.take(sign);
        if found {
            *self.at = at;
        }
        found
    }

    /// Takes one of several names of an operator with the blanks before it: letters as a word, signs as they are.
    fn operator(&mut self, names: &[&str]) -> bool {
        let mut at = *self.at;
        at.blanks();
        names.iter().any(|name| {
            let letters = name.as_bytes()[0].is_ascii_alphabetic();
            let rest = at.rest();
            let here = rest.len() >= name.len() && rest[..name.len()].eq_ignore_ascii_case(name.as_bytes());
            // `GE5` is GE and 5, and `<=` is no `<`.
            let ends = match rest.get(name.len()) {
                Some(next) if letters => !next.is_ascii_alphabetic(),
                Some(next) => !matches!(next, b'=' | b'>' | b'<'),
                None => true,
            };
            if here && ends {
                at.skip(name.len());
                *self.at = at;
            }
            here && ends
        })
    }
}

impl Variables {
    /// Takes a variable if one comes next.
    pub(super) fn read(&self, at: &mut Cursor<'_>) -> Option<Variable> {
        let start = *at;
        let found = self.name(at);
        if found.is_none() {
            *at = start;
        }
        found
    }

    fn name(&self, at: &mut Cursor<'_>) -> Option<Variable> {
        match self.form() {
            LineForm::Letters => {
                at.take(b'#').then_some(())?;
                at.blanks();
                if at.take(b'<') {
                    let end = at.rest().iter().position(|byte| *byte == b'>')?;
                    let name = &at.rest()[..end];
                    at.skip(end + 1);
                    let letters = name.iter().filter(|byte| !byte.is_ascii_whitespace());
                    return Some(b"#<".iter().copied().chain(letters.map(u8::to_ascii_uppercase)).collect());
                }
                // A variable, or brackets, may give the number.
                let number = match at.peek()? {
                    b'0'..=b'9' => at.number()?.value,
                    _ => Expression::new(at, self).signed()??,
                };
                numbered(b"#", number)
            }
            LineForm::Keywords => {
                let name = at.name().to_ascii_uppercase();
                match &name[..] {
                    [b'R', digits @ ..] if !digits.is_empty() && digits.iter().all(u8::is_ascii_digit) => Some(name),
                    [b'R'] if at.peek() == Some(b'[') => {
                        at.skip(1);
                        let number = Expression::new(at, self).condition()??;
                        at.take(b']').then_some(())?;
                        numbered(b"R", number)
                    }
                    _ => self.is_defined(&name).then_some(name),
                }
            }
            LineForm::Statements => {
                let letters = at.letters();
                matches!(letters, b"Q" | b"QL" | b"QR").then_some(())?;
                at.peek().filter(u8::is_ascii_digit)?;
                numbered(letters, at.number()?.value)
            }
        }
    }
}

/// A letter and a number.
fn numbered(letters: &[u8], number: f64) -> Option<Variable> {
    let whole = number.round();
    ((number - whole).abs() < 1e-6 && (0.0..=99_999.0).contains(&whole))
        .then(|| [letters, (whole as u32).to_string().as_bytes()].concat())
}
