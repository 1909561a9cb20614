//! Arithmetic of the declaration: `^` binds tighter than unary minus, which binds tighter than `* /`, then `+ -`.

use proc_macro2::{Delimiter, Literal, TokenTree};
use syn::parse::ParseStream;
use syn::{Token, token};

use super::expr::{Expr, ExprKind, Unit, decimal};
use super::source::{Source, expected, peek_mark, peeked, peeked_word, refused};
use crate::model::to_f64;
use crate::report::Phrase;

/// Deepest nesting of an expression; hand-written ones are far below.
const DEEPEST: usize = 64;

/// Largest exponent after `^`, and largest product of nested exponents.
const LARGEST_POWER: u32 = 64;

/// Functions that may be written without parentheses before a single name, as in `sin B`.
const FUNCTIONS: [&str; 6] = ["sin", "cos", "tan", "asin", "acos", "sqrt"];

/// Units of length and angle, with the unit that they are stored in and the factor to it.
fn unit_named(name: &str) -> Option<(Unit, i64, i64)> {
    match name {
        "deg" => Some((Unit::Degree, 1, 1)),
        "mm" => Some((Unit::Millimetre, 1, 1)),
        "in" => Some((Unit::Millimetre, 127, 5)),
        _ => None,
    }
}

/// Words after a number that are meant as units, and what to write.
fn unit_meant(word: &str) -> Option<&'static str> {
    Some(match word {
        "degree" | "degrees" | "Deg" | "DEG" => "degrees are written `deg`",
        "rad" | "radians" => "angles are in degrees, written `deg`",
        "inch" | "inches" | "In" | "IN" => "inches are written `in`",
        "MM" | "Mm" | "millimetre" | "millimeter" => "millimetres are written `mm`",
        "cm" | "m" | "um" | "ft" => "lengths are in `mm` or `in`",
        "rpm" | "ipm" => "it is a unit of speed: speeds are in `speeds`",
        _ => return None,
    })
}

/// Place of an expression in the declaration.
#[derive(Clone, Copy)]
struct Place<'a> {
    source: &'a Source,
    /// Number of brackets around it.
    depth: usize,
    /// True in an equation: there two operands without a mark between them are meant as a product.
    equation: bool,
}

/// Reads a value.
pub(crate) fn expression(input: ParseStream<'_>, source: &Source) -> syn::Result<Expr> {
    sum(input, Place { source, depth: 0, equation: false })
}

/// Reads one side of an equation.
pub(crate) fn side(input: ParseStream<'_>, source: &Source) -> syn::Result<Expr> {
    sum(input, Place { source, depth: 0, equation: true })
}

fn sum(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<Expr> {
    if place.depth > DEEPEST {
        let help = format!("use at most {DEEPEST} levels of parentheses");
        let message = format!("parentheses are nested too deeply\n\nhelp: {help}");
        return Err(syn::Error::new(input.span(), message));
    }
    let mut left = product(input, place)?;
    while input.peek(Token![+]) || input.peek(Token![-]) {
        let operator = if input.parse::<Option<Token![+]>>()?.is_some() {
            '+'
        } else {
            input.parse::<Token![-]>()?;
            '-'
        };
        left = binary(left, operator, product(input, place)?);
    }
    Ok(left)
}

fn product(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<Expr> {
    let mut left = signed(input, place)?;
    let mut mark_is_missing = false;
    loop {
        if input.peek(Token![*]) || input.peek(Token![/]) {
            let (phrase, token) = place.source.take(input)?;
            let operator = if token.to_string() == "*" { '*' } else { '/' };
            if operator == '*' && input.peek(Token![*]) {
                let (second, _) = place.source.take(input)?;
                return Err(refused(phrase.to(second), "`**` is not a mark of the language", "write a power as `a^2`"));
            }
            left = binary(left, operator, signed(input, place)?);
        } else if place.equation && starts_operand(input) {
            left = binary(left, '*', power(input, place)?);
            mark_is_missing = true;
        } else {
            break;
        }
    }
    if mark_is_missing {
        place.source.report(left.phrase, "a product is written with `*`", format!("write `{left}`"));
    }
    Ok(left)
}

/// True if an operand comes next, and not the next equation.
fn starts_operand(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    match ahead.parse() {
        Ok(TokenTree::Ident(word)) => word != "where" && !peek_mark(&ahead, '=') && !peek_mark(&ahead, ':'),
        Ok(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
        Ok(TokenTree::Literal(_)) => true,
        _ => false,
    }
}

fn signed(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<Expr> {
    let mut minus = Vec::new();
    while input.peek(Token![-]) {
        minus.push(place.source.take(input)?.0);
    }
    let mut value = power(input, place)?;
    while let Some(phrase) = minus.pop() {
        value = Expr { phrase: phrase.to(value.phrase), kind: ExprKind::Neg(Box::new(value)) };
    }
    Ok(value)
}

fn power(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<Expr> {
    let base = atom(input, place)?;
    if !input.peek(Token![^]) {
        return Ok(base);
    }
    input.parse::<Token![^]>()?;
    let exponent = exponent(input, place, base.power())?;
    Ok(Expr { phrase: base.phrase.to(exponent.0), kind: ExprKind::Power(Box::new(base), exponent.1) })
}

/// The whole number after `^`, on a base that has this power already.
fn exponent(input: ParseStream<'_>, place: Place<'_>, known: u32) -> syn::Result<(Phrase, u32)> {
    let exponent = atom(input, place)?;
    let whole = match &exponent.kind {
        ExprKind::Number(value, None) if value.is_integer() => u32::try_from(value.to_integer()).ok(),
        _ => None,
    };
    let Some(whole) = whole.filter(|n| n.saturating_mul(known) <= LARGEST_POWER) else {
        let text = format!("an exponent must be a whole number up to {LARGEST_POWER}, nested exponents multiplied");
        return Err(refused(exponent.phrase, text, "write `a^2`"));
    };
    Ok((exponent.phrase, whole))
}

fn atom(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<Expr> {
    let source = place.source;
    if input.peek(token::Paren) {
        let (phrase, _, content) = source.group(input)?;
        let inner = sum(&content, Place { depth: place.depth + 1, ..place })?;
        if !content.is_empty() {
            return Err(expected(&content, "`)`", "close the parenthesis"));
        }
        return Ok(Expr { phrase, kind: inner.kind });
    }
    if input.peek(Token![.]) {
        let help = "write 0.5 instead of .5";
        return Err(syn::Error::new(input.span(), format!("a number needs a digit before the point\n\nhelp: {help}")));
    }
    match peeked(input) {
        Some(TokenTree::Literal(literal)) => {
            let (phrase, _) = source.take(input)?;
            number(input, place, phrase, &literal)
        }
        Some(TokenTree::Ident(ident)) => {
            let (phrase, _) = source.take(input)?;
            let name = ident.to_string();
            if input.peek(token::Paren) {
                let (end, arguments) = arguments(input, place)?;
                return Ok(Expr { phrase: phrase.to(end), kind: ExprKind::Call(name, arguments) });
            }
            if FUNCTIONS.contains(&name.as_str()) {
                return bare_call(input, place, phrase, name);
            }
            Ok(Expr { phrase, kind: ExprKind::Name(name) })
        }
        _ => Err(expected(input, "a number or a dimension", "for example `150.0`, `45 deg` or `d + 10`")),
    }
}

fn arguments(input: ParseStream<'_>, place: Place<'_>) -> syn::Result<(Phrase, Vec<Expr>)> {
    let (end, _, content) = place.source.group(input)?;
    let mut arguments = Vec::new();
    while !content.is_empty() {
        arguments.push(sum(&content, Place { depth: place.depth + 1, ..place })?);
        if !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(&content, "`,` or `)`", "arguments are separated by commas: `atan2(j, i)`"));
        }
    }
    Ok((end, arguments))
}

/// `sin B`: a function of a single name. Powers as papers print them are refused: they can be read in two ways.
fn bare_call(input: ParseStream<'_>, place: Place<'_>, function: Phrase, name: String) -> syn::Result<Expr> {
    let source = place.source;
    let call = |argument: Expr| Expr {
        phrase: function.to(argument.phrase),
        kind: ExprKind::Call(name.clone(), vec![argument]),
    };
    // `sin^2 B`, `sin^2(B)`
    if input.peek(Token![^]) {
        input.parse::<Token![^]>()?;
        let (_, power) = exponent(input, place, 1)?;
        let argument = if input.peek(token::Paren) || peeked_word(input).is_some() {
            atom(input, place)?
        } else {
            return Err(expected(input, "`(`", format!("write `{name}(B)^{power}`")));
        };
        let call = call(argument);
        let power = Expr { phrase: call.phrase, kind: ExprKind::Power(Box::new(call), power) };
        source.report(power.phrase, "a power is written after the argument", format!("write `{power}`"));
        return Ok(power);
    }
    let argument = match peeked(input) {
        Some(TokenTree::Ident(argument)) => {
            let (phrase, _) = source.take(input)?;
            Expr { phrase, kind: ExprKind::Name(argument.to_string()) }
        }
        Some(TokenTree::Literal(literal)) => {
            let (phrase, _) = source.take(input)?;
            let argument = number(input, place, phrase, &literal)?;
            let call = call(argument);
            source.report(call.phrase, "only a single name is written without parentheses", format!("write `{call}`"));
            return Ok(call);
        }
        _ => {
            let text = format!("`{name}` needs its argument");
            return Err(refused(
                function,
                text,
                format!("write `{name}(B)`; a single name may follow without parentheses: `{name} B`"),
            ));
        }
    };
    let call = call(argument);
    if input.peek(Token![^]) {
        let ahead = input.fork();
        let power = ahead.parse::<Token![^]>().and_then(|_| exponent(&ahead, place, 1));
        let power = power.map_or(2, |(_, power)| power);
        let ExprKind::Call(_, arguments) = &call.kind else { return Ok(call) };
        let text = format!("`{name} {}^{power}` can be read in two ways", arguments[0]);
        return Err(refused(
            call.phrase,
            text,
            format!("write `{call}^{power}` or `{name}({}^{power})`", arguments[0]),
        ));
    }
    Ok(call)
}

/// The digits of a literal, and the letters after them.
pub(super) fn split_unit(text: &str) -> (&str, &str) {
    text.split_at(text.find(|c: char| c.is_ascii_alphabetic() && !matches!(c, 'e' | 'E')).unwrap_or(text.len()))
}

/// A literal with its unit, as a suffix (`45deg`) or as the next word (`45 deg`).
fn number(input: ParseStream<'_>, place: Place<'_>, mut phrase: Phrase, literal: &Literal) -> syn::Result<Expr> {
    let text = literal.to_string().replace('_', "");
    let wrong = |help: &str| Err(refused(phrase, format!("`{literal}` is not a valid number"), help));
    if ["0x", "0X", "0b", "0o"].iter().any(|prefix| text.starts_with(prefix)) {
        return wrong("write numbers in decimal digits");
    }
    if text.len() > 400 {
        return wrong("write at most 400 digits");
    }
    let (digits, suffix) = split_unit(&text);
    let Some(value) = decimal(digits) else {
        if text.starts_with('"') {
            return wrong("a number is written without quotes: `150.0`");
        }
        return wrong("write a decimal number such as 150.0, followed by `deg`, `mm` or `in` if it has a unit");
    };
    if !to_f64(&value).is_finite() {
        return wrong("it is too large: the largest number is about 1.8e308");
    }
    let mut unit = None;
    if !suffix.is_empty() {
        unit = unit_named(suffix);
        if unit.is_none() {
            if let Some(help) = unit_meant(suffix) {
                return wrong(help);
            }
            if place.equation {
                return wrong(&format!("a product is written with `*`: `{digits} * {suffix}`"));
            }
            return wrong(&format!("unknown unit `{suffix}`: use `deg`, `mm` or `in`"));
        }
    } else if let Some(word) = peeked_word(input) {
        unit = unit_named(&word);
        if unit.is_some() {
            phrase = phrase.to(place.source.take(input)?.0);
        } else if let (Some(help), false) = (unit_meant(&word), place.equation) {
            let whole = phrase.to(place.source.take(input)?.0);
            return Err(refused(whole, format!("`{word}` is not a unit of a length or an angle"), help));
        }
    }
    Ok(match unit {
        Some((unit, above, below)) => {
            let factor = num_rational::BigRational::new(above.into(), below.into());
            Expr { phrase, kind: ExprKind::Number(value * factor, Some(unit)) }
        }
        None => Expr { phrase, kind: ExprKind::Number(value, None) },
    })
}

fn binary(left: Expr, operator: char, right: Expr) -> Expr {
    let phrase = left.phrase.to(right.phrase);
    Expr { phrase, kind: ExprKind::Binary(Box::new(left), operator, Box::new(right)) }
}
