//! Formulas as text, as source of the macro and as LaTeX.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::expression::Formula;
use crate::symbolic::Surd;

/// Rational numbers with more binary digits than this in numerator or denominator are rounded in text and LaTeX.
const EXACT_BITS: u64 = 30;

/// Reciprocal of the rounding step: nine decimals.
const ROUNDED: f64 = 1e9;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Style {
    Text,
    Source,
    Latex,
}

/// Binding strength of a piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Factor,
    Atom,
}

struct Piece {
    text: String,
    binding: Binding,
    /// True if it ends with a function's argument without brackets.
    open: bool,
}

impl Piece {
    fn new(text: impl Into<String>, binding: Binding) -> Self {
        Self { text: text.into(), binding, open: false }
    }

    fn within(self, least: Binding) -> Self {
        if self.binding < least { Self::new(format!("({})", self.text), Binding::Atom) } else { self }
    }
}

pub(crate) fn text(formula: &Formula) -> String {
    piece(formula, Style::Text).text
}

pub(crate) fn source(formula: &Formula) -> String {
    piece(formula, Style::Source).text
}

pub(crate) fn latex(formula: &Formula) -> String {
    piece(formula, Style::Latex).text
}

fn piece(formula: &Formula, style: Style) -> Piece {
    match formula {
        Formula::Number(number) => surd(number, style),
        Formula::Name(name) | Formula::Root(name) => {
            Piece::new(if style == Style::Latex { latex_name(name) } else { name.clone() }, Binding::Atom)
        }
        Formula::Neg(inner) => {
            let inner = piece(inner, style).within(Binding::Product);
            Piece { text: format!("-{}", inner.text), binding: Binding::Sum, open: inner.open }
        }
        Formula::Sum(terms) => sum(terms, style),
        Formula::Product(factors) => product(factors, style),
        Formula::Quotient(above, below) => quotient(piece(above, style), piece(below, style), style),
        Formula::Power(base, power) => raised(base, *power, style),
        Formula::Call(function, arguments) => call(function, None, arguments, style),
        Formula::Degrees(degrees) => {
            let number = rational(degrees, style).within(Binding::Factor).text;
            Piece::new(
                match style {
                    Style::Text => format!("{number}°"),
                    Style::Source => format!("{number} deg"),
                    Style::Latex => format!("{number}^{{\\circ}}"),
                },
                if style == Style::Source { Binding::Factor } else { Binding::Atom },
            )
        }
    }
}

fn sum(terms: &[Formula], style: Style) -> Piece {
    let mut text = String::new();
    let mut open = false;
    for term in terms {
        let (minus, part) = match term {
            Formula::Neg(inner) => (true, piece(inner, style).within(Binding::Product)),
            Formula::Number(number) if leads_with_minus(number) => {
                (true, surd(&-number, style).within(Binding::Product))
            }
            other => (false, piece(other, style).within(Binding::Product)),
        };
        text += match (text.is_empty(), minus) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        text += &part.text;
        open = part.open;
    }
    match terms.len() {
        0 => Piece::new("0", Binding::Atom),
        1 => Piece { text, binding: Binding::Product, open },
        _ => Piece { text, binding: Binding::Sum, open },
    }
}

fn product(factors: &[Formula], style: Style) -> Piece {
    let mut text = String::new();
    let mut open = false;
    for factor in factors {
        let part = piece(factor, style).within(Binding::Factor);
        let function = matches!(factor, Formula::Call(name, _) if name != "sqrt")
            || matches!(factor, Formula::Power(base, _) if matches!(**base, Formula::Call(..)));
        text += match style {
            _ if text.is_empty() => "",
            Style::Source => " * ",
            Style::Text if open && !function => " · ",
            Style::Text => " ",
            Style::Latex if open && !function => "\\cdot ",
            Style::Latex if part.text.starts_with(['\\', '(']) && !part.text.starts_with("\\mathit") => "",
            Style::Latex => "\\,",
        };
        text += &part.text;
        open = part.open;
    }
    if factors.is_empty() { Piece::new("1", Binding::Atom) } else { Piece { text, binding: Binding::Product, open } }
}

fn quotient(above: Piece, below: Piece, style: Style) -> Piece {
    if style == Style::Latex {
        return Piece::new(format!("\\frac{{{}}}{{{}}}", above.text, below.text), Binding::Atom);
    }
    let above = if above.open {
        Piece::new(format!("({})", above.text), Binding::Atom)
    } else {
        above.within(Binding::Product)
    };
    let below =
        if below.open { Piece::new(format!("({})", below.text), Binding::Atom) } else { below.within(Binding::Atom) };
    let stroke = if style == Style::Source && above.text.contains(' ') { " / " } else { "/" };
    Piece::new(format!("{}{stroke}{}", above.text, below.text), Binding::Product)
}

fn raised(base: &Formula, power: u32, style: Style) -> Piece {
    let exponent = match style {
        Style::Text => superscript(power),
        Style::Source => format!("^{power}"),
        Style::Latex => format!("^{{{power}}}"),
    };
    match base {
        Formula::Call(function, arguments) if style != Style::Source && is_bare(function, arguments) => {
            call(function, Some(&exponent), arguments, style)
        }
        _ => Piece::new(format!("{}{exponent}", piece(base, style).within(Binding::Atom).text), Binding::Atom),
    }
}

/// `sin B` needs no brackets.
fn is_bare(function: &str, arguments: &[Formula]) -> bool {
    let [Formula::Name(_) | Formula::Degrees(_)] = arguments else { return false };
    function == "sin" || function == "cos"
}

fn call(function: &str, exponent: Option<&str>, arguments: &[Formula], style: Style) -> Piece {
    let parts: Vec<Piece> = arguments.iter().map(|argument| piece(argument, style)).collect();
    let exponent = exponent.unwrap_or_default();
    let all: Vec<&str> = parts.iter().map(|part| part.text.as_str()).collect();
    let separator = if style == Style::Latex { ",\\allowbreak " } else { ", " };
    let all = all.join(separator);
    let bare = is_bare(function, arguments);
    match (style, function) {
        (Style::Latex, "sqrt") => Piece::new(format!("\\sqrt{{{all}}}"), Binding::Atom),
        (Style::Text, "sqrt") => {
            let atom = parts.iter().all(|part| part.binding == Binding::Atom && !part.text.contains('²'));
            Piece::new(if atom { format!("√{all}") } else { format!("√({all})") }, Binding::Atom)
        }
        (Style::Text, _) if bare => {
            Piece { text: format!("{function}{exponent} {all}"), binding: Binding::Factor, open: true }
        }
        (Style::Latex, _) if bare => {
            Piece { text: format!("\\{function}{exponent} {all}"), binding: Binding::Factor, open: true }
        }
        (Style::Latex, _) => {
            let name = match function {
                "sin" => "\\sin".to_string(),
                "cos" => "\\cos".to_string(),
                "asin" => "\\arcsin".to_string(),
                "acos" => "\\arccos".to_string(),
                other => format!("\\operatorname{{{other}}}"),
            };
            Piece::new(format!("{name}({all})"), Binding::Atom)
        }
        _ => Piece::new(format!("{function}({all})"), Binding::Atom),
    }
}

fn superscript(power: u32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = power.to_string();
    digits.chars().filter_map(|digit| digit.to_digit(10)).map(|digit| DIGITS[digit as usize]).collect()
}

fn leads_with_minus(number: &Surd) -> bool {
    number.terms().all(|(_, factor)| factor.is_negative()) && !number.is_zero()
}

fn surd(number: &Surd, style: Style) -> Piece {
    if leads_with_minus(number) {
        let positive = surd(&-number, style).within(Binding::Product);
        return Piece::new(format!("-{}", positive.text), Binding::Sum);
    }
    let large = |value: &BigInt| value.bits() > EXACT_BITS;
    let parts: Vec<(BigUint, BigRational)> = number.terms().collect();
    let rounded = style != Style::Source
        && (parts.len() > 3
            || parts.iter().any(|(root, q)| root.bits() > EXACT_BITS || large(q.numer()) || large(q.denom())));
    if rounded {
        let value = number.to_f64();
        let digits = format!("{}", (value.abs() * ROUNDED).round() / ROUNDED);
        return if value < 0.0 {
            Piece::new(format!("-{digits}"), Binding::Sum)
        } else {
            Piece::new(digits, Binding::Atom)
        };
    }
    if let Some(value) = number.as_rational() {
        return rational(&value, style);
    }
    let below = parts.iter().fold(BigInt::one(), |below, (_, q)| below.lcm(q.denom()));
    let scale = BigRational::from(below.clone());
    let mut text = String::new();
    let mut binding = Binding::Atom;
    for (root, factor) in &parts {
        let whole = (factor * &scale).to_integer();
        text += match (text.is_empty(), whole.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = whole.magnitude();
        let root_text = match style {
            _ if root.is_one() => String::new(),
            Style::Text => format!("√{root}"),
            Style::Source => format!("sqrt({root})"),
            Style::Latex => format!("\\sqrt{{{root}}}"),
        };
        if root.is_one() || !size.is_one() {
            text += &size.to_string();
            if !root.is_one() {
                binding = if style == Style::Source { Binding::Product } else { Binding::Factor };
                text += if style == Style::Source { "*" } else { "" };
            }
        }
        text += &root_text;
    }
    let above = Piece::new(text, if parts.len() > 1 { Binding::Sum } else { binding });
    if below.is_one() { above } else { quotient(above, Piece::new(below.to_string(), Binding::Atom), style) }
}

fn rational(value: &BigRational, style: Style) -> Piece {
    if value.is_negative() {
        let positive = rational(&-value, style);
        return Piece::new(format!("-{}", positive.text), Binding::Sum);
    }
    if value.is_integer() {
        return Piece::new(value.numer().to_string(), Binding::Atom);
    }
    // Decimals above 1 (60.5, a length), a fraction below (1/2, a factor).
    let million = BigRational::from(BigInt::from(1_000_000));
    let scaled = value * &million;
    if scaled.is_integer() && value > &BigRational::one() {
        let digits = format!("{:0>7}", scaled.to_integer().to_string());
        let (whole, fraction) = digits.split_at(digits.len() - 6);
        return Piece::new(format!("{whole}.{}", fraction.trim_end_matches('0')), Binding::Atom);
    }
    quotient(
        Piece::new(value.numer().to_string(), Binding::Atom),
        Piece::new(value.denom().to_string(), Binding::Atom),
        style,
    )
}

/// A name in LaTeX: Greek letters by their names, subscripts after `_`, other words in one piece.
fn latex_name(name: &str) -> String {
    const GREEK: &[&str] = &[
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu",
        "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta",
        "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega",
    ];
    let word = |part: &str| {
        if GREEK.contains(&part) {
            format!("\\{part}")
        } else if part.chars().count() > 1 && part.chars().any(|character| !character.is_ascii_digit()) {
            format!("\\mathit{{{part}}}")
        } else {
            part.to_string()
        }
    };
    let parts: Vec<String> = name.split('_').filter(|part| !part.is_empty()).map(word).collect();
    match parts.split_first() {
        None => "\\_".into(),
        Some((first, [])) => first.clone(),
        Some((first, rest)) => format!("{first}_{{{}}}", rest.join("\\,")),
    }
}
