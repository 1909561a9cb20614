//! Values of entries: signs, travel, speeds, directions.

use num_bigint::BigInt;
use num_rational::BigRational;
use proc_macro2::{Delimiter, TokenTree};
use syn::parse::ParseStream;
use syn::{Token, token};

use super::arithmetic::{expression, split_unit};
use super::ast::{Base, Direction, Limits, SpannedName};
use super::entries::vector;
use super::expr::{Expr, ExprKind, Unit, decimal};
use super::source::{Source, expected, peek_mark, peeked, refused};
use crate::model::{AxisKind, Up, kind_of};
use crate::report::Phrase;

/// `+` or `-`.
pub(crate) fn sign(input: ParseStream<'_>, source: &Source, axis: &SpannedName) -> syn::Result<bool> {
    let text = "a sign is `+` or `-`";
    let letter = &axis.name;
    let help = format!("write `{letter}: -` if a positive word moves {letter} against ISO 841, else `{letter}: +`");
    let (phrase, words) = entry(input, source)?;
    let Some(phrase) = phrase else { return Err(expected(input, "`+` or `-`", help)) };
    match words.as_str() {
        "+" => return Ok(false),
        "-" => return Ok(true),
        _ => {}
    }
    let lower = words.to_lowercase();
    let word = lower.trim_start_matches(['+', '-']);
    let negative = ["minus", "negative", "reversed", "reverse", "inverted", "true"].contains(&word);
    let positive = ["plus", "positive", "normal", "false"].contains(&word);
    let minus = lower.starts_with('-') || negative;
    if !(negative || positive || ["1", "1.0", &letter.to_lowercase()].contains(&word)) {
        return Err(refused(phrase, text, help));
    }
    source.report(phrase, text, format!("write `{letter}: {}`", if minus { '-' } else { '+' }));
    Ok(minus)
}

/// Location and text of all tokens up to the next comma.
fn entry(input: ParseStream<'_>, source: &Source) -> syn::Result<(Option<Phrase>, String)> {
    let (mut phrase, mut text) = (None::<Phrase>, String::new());
    while !input.is_empty() && !input.peek(Token![,]) && !input.peek(Token![;]) {
        let (own, token) = source.take(input)?;
        phrase = Some(phrase.map_or(own, |first| first.to(own)));
        text += &token.to_string();
    }
    Ok((phrase, text))
}

/// `-5..110` or `free`.
pub(crate) fn limits(input: ParseStream<'_>, source: &Source, axis: &SpannedName) -> syn::Result<Limits> {
    let letter = &axis.name;
    if let Some(ends) = endless(input, source, letter)? {
        return Ok(ends);
    }
    if let Some(TokenTree::Group(group)) = peeked(input)
        && matches!(group.delimiter(), Delimiter::Parenthesis | Delimiter::Bracket)
        && !after_group_is_range(input)
    {
        let (phrase, _, content) = source.group(input)?;
        let lower = expression(&content, source)?;
        if content.parse::<Option<Token![..]>>()?.is_none() {
            content.parse::<Option<Token![,]>>()?;
        }
        let upper = expression(&content, source)?;
        source.report(
            phrase,
            "travel is written with two dots, without brackets",
            format!("write `{letter}: {lower}..{upper}`"),
        );
        return Ok(Limits::Range(Box::new((lower, upper))));
    }
    let both = format!("write both ends: `{letter}: -5..110`; travel without ends is `{letter}: free`");
    let as_meant = |end: Option<&Expr>| end.map_or(both.clone(), |end| both_ends(letter, end));
    if input.peek(Token![..]) {
        let (phrase, _) = source.take(input)?;
        input.parse::<Option<Token![.]>>()?;
        let upper = expression(&input.fork(), &Source::default()).ok();
        return Err(refused(phrase, format!("the travel of `{letter}` has no lower end"), as_meant(upper.as_ref())));
    }
    if peek_mark(input, '+') {
        // `+-110`
        let (phrase, _) = source.take(input)?;
        let end = expression(input, source)?;
        let text = format!("the travel of `{letter}` has two ends");
        return Err(refused(phrase.to(end.phrase), text, both_ends(letter, &end)));
    }
    let lower = expression(input, source)?;
    let dots = input.span();
    if input.peek(Token![..=]) || input.peek(Token![...]) {
        let help = "both ends belong to the travel: write `-5..110`";
        source.report(source.phrase(dots, dots), "expected `..`", help);
        // Both marks have three characters.
        for _ in 0..3 {
            input.parse::<TokenTree>()?;
        }
    } else if input.peek(Token![..]) {
        input.parse::<Token![..]>()?;
    } else if input.is_empty() || input.peek(Token![,]) {
        if let ExprKind::Binary(start, '-', end) = lower.kind {
            let help = format!("write `{letter}: {start}..{end}`");
            source.report(lower.phrase, "travel is written with two dots", help);
            return Ok(Limits::Range(Box::new((*start, *end))));
        }
        let text = format!("the travel of `{letter}` has one end only");
        return Err(refused(lower.phrase, text, both_ends(letter, &lower)));
    } else {
        let (_, between) = source.take(input)?;
        let help = match between {
            TokenTree::Ident(_) | TokenTree::Punct(_) => {
                let upper = expression(&input.fork(), source).map_or("110".into(), |upper| upper.to_string());
                format!("write `{letter}: {lower}..{upper}`")
            }
            _ => both,
        };
        return Err(syn::Error::new(dots, format!("expected `..`\n\nhelp: {help}")));
    }
    if input.is_empty() || input.peek(Token![,]) {
        let text = format!("the travel of `{letter}` has no upper end");
        return Err(refused(lower.phrase, text, both_ends(letter, &lower)));
    }
    Ok(Limits::Range(Box::new((lower, expression(input, source)?))))
}

/// Help for travel of which one end is written.
fn both_ends(letter: &str, end: &Expr) -> String {
    match &end.kind {
        ExprKind::Neg(upper) => format!("write both ends: `{letter}: {end}..{upper}`, or `{letter}: {end}..0`"),
        _ => format!("write both ends: `{letter}: -{end}..{end}`, or `{letter}: 0..{end}`"),
    }
}

/// True if two dots come after the bracket: `(1 + 2)..5`.
fn after_group_is_range(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    ahead.parse::<TokenTree>().is_ok() && !ahead.is_empty() && !ahead.peek(Token![,])
}

/// `free`, and what people write for it.
fn endless(input: ParseStream<'_>, source: &Source, letter: &str) -> syn::Result<Option<Limits>> {
    const ENDLESS: [&str; 6] = ["endless", "unlimited", "infinite", "none", "None", "continuous"];
    let help = format!("write `{letter}: free`");
    let ahead = input.fork();
    let (Some(_), words) = entry(&ahead, &Source::default())? else { return Ok(None) };
    let infinite = words.split("..").any(|end| {
        let end = end.trim_start_matches(['+', '-']);
        ["inf", "infinity", "f64::infinity"].contains(&end.to_lowercase().as_str())
    });
    if words != "free" && !infinite && !ENDLESS.contains(&words.as_str()) {
        return Ok(None);
    }
    let (Some(phrase), words) = entry(input, source)? else { return Ok(None) };
    if words != "free" {
        let one_end = words.split("..").any(|end| end.contains(|c: char| c.is_ascii_digit()) && !end.contains("f64"));
        if one_end {
            return Err(refused(
                phrase,
                format!("the travel of `{letter}` has one end only"),
                format!("give both ends as numbers, or {help}"),
            ));
        }
        source.report(phrase, "travel without ends is `free`", help);
    }
    Ok(Some(Limits::Free))
}

/// Units of speed: their unit of travel, and the factor to deg/min or mm/min.
fn speed_unit(words: &str) -> Option<(Unit, BigRational)> {
    let whole = |number: i64| BigRational::from(BigInt::from(number));
    let inch = BigRational::new(BigInt::from(127), BigInt::from(5));
    Some(match words {
        "deg/min" => (Unit::Degree, whole(1)),
        "deg/s" => (Unit::Degree, whole(60)),
        "rpm" | "rev/min" => (Unit::Degree, whole(360)),
        "mm/min" => (Unit::Millimetre, whole(1)),
        "mm/s" => (Unit::Millimetre, whole(60)),
        "m/min" => (Unit::Millimetre, whole(1000)),
        "in/min" | "ipm" => (Unit::Millimetre, inch),
        _ => return None,
    })
}

/// A number in deg/min or mm/min, or with a unit of speed.
pub(crate) fn speed(input: ParseStream<'_>, source: &Source, axis: &SpannedName) -> syn::Result<Expr> {
    let ahead = input.fork();
    let Ok(TokenTree::Literal(literal)) = ahead.parse() else { return expression(input, source) };
    let text = literal.to_string().replace('_', "");
    let (digits, suffix) = split_unit(&text);
    let (Some(value), Ok((_, words))) = (decimal(digits), entry(&ahead, &Source::default())) else {
        return expression(input, source);
    };
    let unit = format!("{suffix}{words}");
    if !unit.starts_with(|c: char| c.is_alphabetic()) {
        return expression(input, source);
    }
    let (Some(phrase), _) = entry(input, source)? else { return expression(input, source) };
    match speed_unit(&unit) {
        Some((unit, factor)) => Ok(Expr { phrase, kind: ExprKind::Number(value * factor, Some(unit)) }),
        None => {
            let rotary = kind_of(&axis.name) == Some(AxisKind::Rotary);
            let units = if rotary { "deg/min, deg/s or rpm" } else { "mm/min, mm/s, m/min or in/min" };
            let text = format!("`{unit}` is not a unit of speed");
            Err(refused(phrase, text, format!("the speed of `{}` is in {units}", axis.name)))
        }
    }
}

/// `Rx(a) * Ry(b) * Z`, or a vector.
pub(crate) fn direction(input: ParseStream<'_>, source: &Source) -> syn::Result<Direction> {
    const FORM: &str =
        "write X, Y, Z or a vector, with rotations Rx(...), Ry(...), Rz(...) before it: `Rx(-45 deg) * Y`";
    let mut rotations = Vec::new();
    let mut start: Option<Phrase> = None;
    loop {
        let mut negated = false;
        if input.peek(Token![-]) {
            let (phrase, _) = source.take(input)?;
            start.get_or_insert(phrase);
            negated = true;
        }
        if input.peek(token::Paren) || input.peek(token::Bracket) {
            let base = vector(input, source)?;
            let phrase = start.map_or(base.phrase, |start| start.to(base.phrase));
            return Ok(Direction { phrase, rotations, negated, base: Base::Vector(base) });
        }
        if let Some(TokenTree::Literal(literal)) = peeked(input) {
            let text = literal.to_string();
            if let Some(inner) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
                let (phrase, _) = source.take(input)?;
                return Err(refused(phrase, "a direction is written without quotes", format!("write `{inner}`")));
            }
            let value = expression(input, source)?;
            let unit = if matches!(value.kind, ExprKind::Number(_, Some(_))) { "" } else { " deg" };
            let help = format!(
                "write the direction that is rotated as well: `Rx({value}{unit}) * Y`, or a vector `(0, 1, -0.5)`"
            );
            return Err(refused(value.phrase, format!("`{value}` is not a direction"), help));
        }
        let help = "write a rotated coordinate axis such as `Rx(-45 deg) * Y`, or a vector `(0, 1, -0.5)`";
        let word = source.name(input, "a direction", help)?;
        let start = *start.get_or_insert(word.phrase);
        let letter = one_of(&word, ["X", "Y", "Z"], !input.peek(token::Paren), source);
        if let Some(coordinate) = letter {
            if peek_mark(input, '*') {
                let help = "the direction comes last, after its rotations: `Rx(-45 deg) * Y`";
                return Err(refused(word.phrase, format!("`{}` is rotated by what comes before it", word.name), help));
            }
            let base = Base::Coordinate(coordinate);
            return Ok(Direction { phrase: start.to(word.phrase), rotations, negated, base });
        }
        let rotation = one_of(&word, ["Rx", "Ry", "Rz"], true, source);
        let (Some(rotation), false) = (rotation, negated) else {
            return Err(refused(word.phrase, format!("`{}` is not a direction", word.name), FORM));
        };
        if !input.peek(token::Paren) {
            return Err(expected(input, "`(`", format!("write `{}(45 deg) * Y`", word.name)));
        }
        let (_, _, content) = source.group(input)?;
        rotations.push((rotation, expression(&content, source)?));
        if !content.is_empty() {
            return Err(expected(&content, "`)`", "a rotation has one angle: `Rx(45 deg) * Y`"));
        }
        if !input.peek(Token![*]) {
            return Err(expected(
                input,
                "`*`",
                format!("write the direction that is rotated: `{}(...) * Y`", word.name),
            ));
        }
        input.parse::<Token![*]>()?;
    }
}

/// The place of a word among three; another letter case is reported.
fn one_of(word: &SpannedName, names: [&str; 3], lenient: bool, source: &Source) -> Option<usize> {
    let place = names.iter().position(|name| word.name.eq_ignore_ascii_case(name))?;
    if word.name != names[place] {
        if !lenient {
            return None;
        }
        source.report(word.phrase, format!("`{}` is not a direction", word.name), format!("write `{}`", names[place]));
    }
    Some(place)
}

/// `Y`, or `-Y`.
pub(crate) fn up(input: ParseStream<'_>, source: &Source) -> syn::Result<Up> {
    let help = "write the coordinate direction that is up at the machine: `up = Y;`, or `up = -Y;`";
    let negated = input.parse::<Option<Token![-]>>()?.is_some();
    let word = source.name(input, "X, Y or Z", help)?;
    match one_of(&word, ["X", "Y", "Z"], true, source) {
        Some(coordinate) => Ok(Up { coordinate, negated }),
        None => Err(refused(word.phrase, format!("`{}` is not X, Y or Z", word.name), help)),
    }
}
