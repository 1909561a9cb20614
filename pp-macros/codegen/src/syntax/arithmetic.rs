//! Arithmetic of the declaration: `^` binds tighter than unary minus, which binds tighter than `* /`, then `+ -`.

use proc_macro2::{Literal, TokenTree};
use syn::parse::ParseStream;
use syn::{Token, token};

use super::expr::{Expr, ExprKind, Unit, decimal};
use super::source::Source;
use crate::model::to_f64;
use crate::report::Phrase;

/// Deepest nesting of an expression; hand-written ones are far below.
const DEEPEST: usize = 64;

/// Largest exponent after `^`, and largest product of nested exponents.
const LARGEST_POWER: u32 = 64;

/// Reads a sum.
pub(crate) fn expression(input: ParseStream<'_>, source: &Source) -> syn::Result<Expr> {
    sum(input, source, 0)
}

fn sum(input: ParseStream<'_>, source: &Source, depth: usize) -> syn::Result<Expr> {
    if depth > DEEPEST {
        return Err(input
            .error(format!("parentheses are nested too deeply\n\nhelp: use at most {DEEPEST} levels of parentheses")));
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
        let text = format!(
            "an exponent must be a whole number up to {LARGEST_POWER}, nested exponents multiplied\n\nhelp: write `a ^ 2`"
        );
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

/// A literal with its unit, as a suffix (`45deg`) or as the next word (`45 deg`).
fn number(input: ParseStream<'_>, source: &Source, mut phrase: Phrase, literal: &Literal) -> syn::Result<Expr> {
    let text = literal.to_string().replace('_', "");
    let wrong = |help: &str| {
        let text = format!("`{literal}` is not a valid number\n\nhelp: {help}");
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
        return wrong("write a decimal number such as 150.0, followed by `deg` or `mm` if it has a unit");
    };
    if !to_f64(&value).is_finite() {
        return wrong("it is too large: the largest number is about 1.8e308");
    }
    let mut unit = match suffix {
        "" => None,
        "deg" => Some(Unit::Degree),
        "mm" => Some(Unit::Millimetre),
        other => return wrong(&format!("unknown unit `{other}`: use `deg` or `mm`")),
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

fn binary(left: Expr, operator: char, right: Expr) -> Expr {
    let phrase = left.phrase.to(right.phrase);
    Expr { phrase, kind: ExprKind::Binary(Box::new(left), operator, Box::new(right)) }
}
