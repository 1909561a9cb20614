//! Arithmetic of the declaration: `^` binds tighter than unary minus, which binds tighter than `* /`, then `+ -`.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use proc_macro2::{Literal, TokenTree};
use syn::parse::ParseStream;
use syn::{Token, token};

use super::parse::Source;
use crate::model::to_f64;
use crate::report::Phrase;

/// An expression and its place in the source.
#[derive(Debug, Clone)]
pub struct Expr {
    /// From its first token to its last.
    pub phrase: Phrase,
    /// What it is.
    pub kind: ExprKind,
}

/// Unit written after a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Degrees.
    Degree,
    /// Millimetres.
    Millimetre,
}

/// Kinds of expressions.
#[derive(Debug, Clone)]
pub enum ExprKind {
    /// An exact decimal number.
    Number(BigRational, Option<Unit>),
    /// A dimension.
    Name(String),
    /// `-a`
    Neg(Box<Expr>),
    /// `a + b`, `a - b`, `a * b`, `a / b`
    Binary(Box<Expr>, char, Box<Expr>),
    /// `a ^ n`
    Power(Box<Expr>, u32),
    /// `f(a, ...)`
    Call(String, Vec<Expr>),
}

/// Deepest nesting of an expression; deeper ones come from no hand.
const DEEPEST: usize = 64;

/// Largest exponent after `^` or `e`.
const LARGEST_POWER: u32 = 64;

impl Expr {
    /// Parses a sum.
    pub(crate) fn parse(input: ParseStream<'_>, source: &Source) -> syn::Result<Self> {
        sum(input, source, 0)
    }

    /// Whether a name occurs.
    pub(crate) fn mentions(&self, wanted: &str) -> bool {
        match &self.kind {
            ExprKind::Number(..) => false,
            ExprKind::Name(name) => name == wanted,
            ExprKind::Neg(inner) | ExprKind::Power(inner, _) => inner.mentions(wanted),
            ExprKind::Binary(left, _, right) => left.mentions(wanted) || right.mentions(wanted),
            ExprKind::Call(_, arguments) => arguments.iter().any(|argument| argument.mentions(wanted)),
        }
    }

    /// The expression with some parts replaced, outermost first.
    pub(crate) fn replace(&self, by: &dyn Fn(&Self) -> Option<Self>) -> Self {
        if let Some(new) = by(self) {
            return new;
        }
        let inner = |part: &Self| Box::new(part.replace(by));
        let kind = match &self.kind {
            ExprKind::Number(..) | ExprKind::Name(_) => self.kind.clone(),
            ExprKind::Neg(part) => ExprKind::Neg(inner(part)),
            ExprKind::Power(base, exponent) => ExprKind::Power(inner(base), *exponent),
            ExprKind::Binary(left, operator, right) => ExprKind::Binary(inner(left), *operator, inner(right)),
            ExprKind::Call(name, arguments) => {
                ExprKind::Call(name.clone(), arguments.iter().map(|part| part.replace(by)).collect())
            }
        };
        Self { phrase: self.phrase, kind }
    }

    /// Largest product of nested exponents.
    fn power(&self) -> u32 {
        match &self.kind {
            ExprKind::Number(..) | ExprKind::Name(_) => 1,
            ExprKind::Neg(inner) => inner.power(),
            ExprKind::Binary(left, _, right) => left.power().max(right.power()),
            ExprKind::Power(base, exponent) => base.power().saturating_mul((*exponent).max(1)),
            ExprKind::Call(_, arguments) => arguments.iter().map(Self::power).max().unwrap_or(1),
        }
    }
}

/// As the language writes it, with the parentheses that the reading needs and no others.
impl std::fmt::Display for Expr {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.write(f, 0)
    }
}

impl Expr {
    /// `least`: 0 sums, 1 products, 2 unary minus, 3 powers' bases.
    fn write(&self, f: &mut std::fmt::Formatter<'_>, least: u8) -> std::fmt::Result {
        let strength = match &self.kind {
            ExprKind::Binary(_, '+' | '-', _) => 0,
            ExprKind::Binary(..) => 1,
            ExprKind::Neg(_) => 2,
            ExprKind::Power(..) => 3,
            ExprKind::Number(..) | ExprKind::Name(_) | ExprKind::Call(..) => 4,
        };
        if strength < least {
            f.write_str("(")?;
        }
        match &self.kind {
            ExprKind::Number(value, unit) => {
                write!(f, "{}", number_text(value))?;
                f.write_str(match unit {
                    Some(Unit::Degree) => " deg",
                    Some(Unit::Millimetre) => " mm",
                    None => "",
                })?;
            }
            ExprKind::Name(name) => f.write_str(name)?,
            ExprKind::Neg(inner) => {
                f.write_str("-")?;
                inner.write(f, 3)?;
            }
            ExprKind::Binary(left, operator, right) => {
                left.write(f, strength)?;
                write!(f, " {operator} ")?;
                right.write(f, strength + 1)?;
            }
            ExprKind::Power(base, exponent) => {
                base.write(f, 4)?;
                write!(f, "^{exponent}")?;
            }
            ExprKind::Call(name, arguments) => {
                write!(f, "{name}(")?;
                for (place, argument) in arguments.iter().enumerate() {
                    f.write_str(if place == 0 { "" } else { ", " })?;
                    argument.write(f, 0)?;
                }
                f.write_str(")")?;
            }
        }
        if strength < least { f.write_str(")") } else { Ok(()) }
    }
}

/// Numbers are read from decimal digits; one with more digits than a float keeps its fraction.
fn number_text(value: &BigRational) -> String {
    let short = to_f64(value);
    let text = format!("{short}");
    if decimal(&text).as_ref() == Some(value) { text } else { value.to_string() }
}

fn sum(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    if depth > DEEPEST {
        return Err(input.error(format!("nested too deeply\n\nhelp: at most {DEEPEST} parentheses may be open")));
    }
    let mut left = product(input, source, depth)?;
    while input.peek(Token![+]) || input.peek(Token![-]) {
        let operator = if input.parse::<Option<Token![+]>>()?.is_some() {
            '+'
        } else {
            input.parse::<Token![-]>()?;
            '-'
        };
        left = binary(left, operator, product(input, source, depth)?);
    }
    Ok(left)
}

fn product(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    let mut left = signed(input, source, depth)?;
    while input.peek(Token![*]) || input.peek(Token![/]) {
        let operator = if input.parse::<Option<Token![*]>>()?.is_some() {
            '*'
        } else {
            input.parse::<Token![/]>()?;
            '/'
        };
        left = binary(left, operator, signed(input, source, depth)?);
    }
    Ok(left)
}

fn signed(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    let mut minus = Vec::new();
    while input.peek(Token![-]) {
        minus.push(source.take(input)?.0);
    }
    let mut value = power(input, source, depth)?;
    while let Some(phrase) = minus.pop() {
        value = Expr { phrase: phrase.to(value.phrase), kind: ExprKind::Neg(Box::new(value)) };
    }
    Ok(value)
}

fn power(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    let base = atom(input, source, depth)?;
    if !input.peek(Token![^]) {
        return Ok(base);
    }
    input.parse::<Token![^]>()?;
    let exponent = atom(input, source, depth)?;
    let whole = match &exponent.kind {
        ExprKind::Number(value, None) if value.is_integer() => u32::try_from(value.to_integer()).ok(),
        _ => None,
    };
    let Some(whole) = whole.filter(|n| n.saturating_mul(base.power()) <= LARGEST_POWER) else {
        let text = format!("an exponent is a whole number up to {LARGEST_POWER}\n\nhelp: write `a ^ 2`");
        return Err(syn::Error::new_spanned(exponent.phrase, text));
    };
    Ok(Expr { phrase: base.phrase.to(exponent.phrase), kind: ExprKind::Power(Box::new(base), whole) })
}

fn atom(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    if input.peek(token::Paren) {
        let (phrase, content) = source.parenthesized(input)?;
        let inner = sum(&content, source, depth + 1)?;
        if !content.is_empty() {
            return Err(content.error("expected `)`\n\nhelp: close the parenthesis"));
        }
        return Ok(Expr { phrase, kind: inner.kind });
    }
    if input.peek(Token![.]) {
        return Err(input.error("a number needs a digit before the point\n\nhelp: write 0.5 instead of .5"));
    }
    let ahead = input.fork();
    match ahead.parse::<TokenTree>() {
        Ok(TokenTree::Literal(literal)) => {
            let (phrase, _) = source.take(input)?;
            number(input, source, phrase, &literal)
        }
        Ok(TokenTree::Ident(ident)) => {
            let (phrase, _) = source.take(input)?;
            let name = ident.to_string();
            if !input.peek(token::Paren) {
                return Ok(Expr { phrase, kind: ExprKind::Name(name) });
            }
            let (end, content) = source.parenthesized(input)?;
            let mut arguments = Vec::new();
            while !content.is_empty() {
                arguments.push(sum(&content, source, depth + 1)?);
                if !content.is_empty() {
                    content.parse::<Token![,]>()?;
                }
            }
            Ok(Expr { phrase: phrase.to(end), kind: ExprKind::Call(name, arguments) })
        }
        _ => Err(input.error("expected a number or a dimension\n\nhelp: for example `150.0`, `45 deg` or `d + 10`")),
    }
}

/// A literal with its unit, glued on (`45deg`) or after it (`45 deg`).
fn number(input: ParseStream<'_>, source: &Source, mut phrase: Phrase, literal: &Literal) -> syn::Result<Expr> {
    let text = literal.to_string().replace('_', "");
    let wrong = |help: &str| {
        let text = format!("`{literal}` is not a number here\n\nhelp: {help}");
        Err(syn::Error::new_spanned(phrase, text))
    };
    if ["0x", "0X", "0b", "0o"].iter().any(|prefix| text.starts_with(prefix)) {
        return wrong("write numbers in decimal digits");
    }
    if text.len() > 400 {
        return wrong("write at most 400 digits");
    }
    let digits = text.find(|c: char| c.is_ascii_alphabetic() && !matches!(c, 'e' | 'E')).unwrap_or(text.len());
    let (digits, suffix) = text.split_at(digits);
    let Some(value) = decimal(digits) else {
        return wrong("write a decimal number such as 150.0, with `deg` or `mm` behind it if it needs a unit");
    };
    if !to_f64(&value).is_finite() {
        return wrong("it is larger than any number of the machine");
    }
    let mut unit = match suffix {
        "" => None,
        "deg" => Some(Unit::Degree),
        "mm" => Some(Unit::Millimetre),
        other => return wrong(&format!("the unit `{other}` is not known: use `deg` or `mm`")),
    };
    if unit.is_none() {
        let ahead = input.fork();
        unit = match ahead.parse::<syn::Ident>() {
            Ok(word) if word == "deg" => Some(Unit::Degree),
            Ok(word) if word == "mm" => Some(Unit::Millimetre),
            _ => None,
        };
        if unit.is_some() {
            phrase = phrase.to(source.take(input)?.0);
        }
    }
    Ok(Expr { phrase, kind: ExprKind::Number(value, unit) })
}

/// `12`, `12.5`, `1.5e-3`, exactly.
fn decimal(text: &str) -> Option<BigRational> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let places = i32::try_from(fraction.len()).ok()?;
    let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
    let scale = exponent.checked_sub(places)?;
    if digits.is_zero() {
        return Some(BigRational::zero());
    }
    // 400 digits hold every float.
    if scale.unsigned_abs() > 400 {
        return None;
    }
    let power = BigRational::from(BigInt::from(10).pow(scale.unsigned_abs()));
    let power = if scale < 0 { BigRational::one() / power } else { power };
    Some(BigRational::from(digits) * power)
}

fn binary(left: Expr, operator: char, right: Expr) -> Expr {
    let phrase = left.phrase.to(right.phrase);
    Expr { phrase, kind: ExprKind::Binary(Box::new(left), operator, Box::new(right)) }
}
