//! `{ NAME: value, NAME: value }` and `(x, y, z)`.

use proc_macro2::{Delimiter, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

use super::arithmetic::expression;
use super::ast::{Assign, DimensionValue, SpannedName, Vector};
use super::expr::ExprKind;
use super::fields::Field;
use super::source::{Source, expected, last_token, peek_mark, peeked, peeked_word, refused};

/// Reads the entries of a field. One that cannot be read is reported and left out; the others are kept.
pub(crate) fn assigns<T>(
    input: ParseStream<'_>,
    source: &Source,
    field: Field,
    value: impl Fn(ParseStream<'_>, &SpannedName) -> syn::Result<T>,
) -> syn::Result<Vec<Assign<T>>> {
    if !matches!(peeked(input), Some(TokenTree::Group(_))) {
        return Err(expected(input, "`{`", format!("write `{}`", field.example)));
    }
    let (phrase, kind, content) = source.group(input)?;
    if kind != Delimiter::Brace {
        source.report(
            phrase,
            format!("the entries of `{}` are in braces", field.name),
            format!("write `{}`", field.example),
        );
    }
    let mut list = Vec::new();
    while !content.is_empty() {
        let mut key = None;
        match entry(&content, source, field, &mut key, &value) {
            Ok(assign) => list.push(assign),
            Err(error) => {
                source.report_error(error);
                if let Some(SpannedName { name, .. }) = key {
                    source.unreadable().add_entry(field.name, &name);
                }
                skip_entry(&content)?;
            }
        }
    }
    Ok(list)
}

/// `NAME: value` and the comma after it.
fn entry<T>(
    content: ParseStream<'_>,
    source: &Source,
    field: Field,
    key: &mut Option<SpannedName>,
    value: &impl Fn(ParseStream<'_>, &SpannedName) -> syn::Result<T>,
) -> syn::Result<Assign<T>> {
    let start = content.fork();
    let name = key.insert(entry_name(content, source, field)?).clone();
    let help = format!("for example `{}`", field.example);
    if content.parse::<Option<Token![:]>>()?.is_none() {
        if content.is_empty() || content.peek(Token![,]) {
            return Err(refused(name.phrase, format!("`{}` has no value", name.name), help));
        }
        let at = source.phrase(content.span(), content.span());
        // `B-`, as in a list of signs, has its value without any mark.
        content.parse::<Option<Token![=]>>()?;
        source.report(at, format!("expected `:` after `{}`", name.name), help);
    }
    refuse_decimal_comma(content, source)?;
    let assign = Assign { value: value(content, &name)?, key: name };
    if content.is_empty() || content.parse::<Option<Token![,]>>()?.is_some() {
        return Ok(assign);
    }
    let ahead = content.fork();
    let next_entry = ahead.parse::<TokenTree>().is_ok() && ahead.peek(Token![:]);
    if content.peek(Token![;]) {
        source.report(source.take(content)?.0, "expected `,`, found `;`", "separate the entries with commas");
    } else if let (true, Some(last)) = (next_entry, last_token(source, &start, content)) {
        source.report(last.phrase, format!("missing `,` after `{}`", last.name), "separate the entries with commas");
    } else {
        return Err(expected(content, "`,`", "separate the entries with commas"));
    }
    Ok(assign)
}

/// Refuses `150,5`: an entry begins with a name, so a number after a comma has the decimals of the one before.
fn refuse_decimal_comma(content: ParseStream<'_>, source: &Source) -> syn::Result<()> {
    let ahead = content.fork();
    let mut before = None;
    while !ahead.is_empty() && !ahead.peek(Token![,]) {
        before = ahead.parse::<TokenTree>().ok();
    }
    ahead.parse::<Option<Token![,]>>()?;
    let (Some(TokenTree::Literal(whole)), Some(TokenTree::Literal(decimals))) = (before, peeked(&ahead)) else {
        return Ok(());
    };
    let numbers = [&whole, &decimals].iter().all(|token| token.to_string().starts_with(|c: char| c.is_ascii_digit()));
    ahead.parse::<TokenTree>()?;
    // A number in the place of a name has a message of its own.
    if !numbers || ahead.peek(Token![:]) {
        return Ok(());
    }
    skip_entry(content)?;
    content.parse::<TokenTree>()?;
    let phrase = source.phrase(whole.span(), decimals.span());
    Err(refused(phrase, format!("`{whole},{decimals}` has a decimal comma"), format!("write `{whole}.{decimals}`")))
}

/// The name before the colon.
fn entry_name(content: ParseStream<'_>, source: &Source, field: Field) -> syn::Result<SpannedName> {
    let help = format!("for example `{}`", field.example);
    match peeked(content) {
        Some(TokenTree::Literal(literal)) => {
            let (phrase, _) = source.take(content)?;
            let text = literal.to_string();
            if let Some(name) = text.strip_prefix('"').and_then(|text| text.strip_suffix('"')) {
                source.report(phrase, "a name is written without quotes", format!("write `{name}`"));
                return Ok(SpannedName { name: name.into(), phrase });
            }
            Err(refused(phrase, format!("expected a name, found `{text}`"), help))
        }
        _ => source.name(content, "a name", help),
    }
}

/// Skips past the next comma.
fn skip_entry(content: ParseStream<'_>) -> syn::Result<()> {
    while !content.is_empty() && content.parse::<Option<Token![,]>>()?.is_none() {
        content.parse::<TokenTree>()?;
    }
    Ok(())
}

/// Default of a dimension.
pub(crate) fn dimension(input: ParseStream<'_>, source: &Source, name: &SpannedName) -> syn::Result<DimensionValue> {
    const NO_VALUE: [&str; 12] =
        ["unknown", "none", "None", "null", "nan", "NaN", "NAN", "_", "f64", "f32", "measured", "individual"];
    let ahead = input.fork();
    if let Ok(TokenTree::Ident(word)) = ahead.parse()
        && NO_VALUE.iter().any(|known| word == known)
        && (ahead.is_empty() || ahead.peek(Token![,]))
    {
        let help = format!("a length that each machine has of its own is `required`: write `{}: required`", name.name);
        source.report(source.take(input)?.0, format!("`{word}` is not a length"), help);
        return Ok(DimensionValue::RequiredLength);
    }
    if peeked_word(input).is_none_or(|word| word != "required") {
        return expression(input, source).map(DimensionValue::Given);
    }
    source.take(input)?;
    match peeked_word(input).as_deref() {
        Some("deg") => source.take(input).map(|_| DimensionValue::RequiredAngle(None)),
        Some("near") => {
            source.take(input)?;
            expression(input, source).map(|near| DimensionValue::RequiredAngle(Some(near)))
        }
        Some("mm") => source.take(input).map(|_| DimensionValue::RequiredLength),
        _ => Ok(DimensionValue::RequiredLength),
    }
}

/// `(x, y, z)`
pub(crate) fn vector(input: ParseStream<'_>, source: &Source) -> syn::Result<Vector> {
    if !matches!(peeked(input), Some(TokenTree::Group(_))) {
        let ahead = input.fork();
        let number = match peek_mark(input, ';') || input.is_empty() {
            true => None,
            false => expression(&ahead, &Source::default()).ok(),
        };
        return Err(match number {
            Some(value) => {
                let text = "expected three components in parentheses";
                refused(value.phrase, text, format!("write `(0, 0, {value})`"))
            }
            None => expected(input, "`(`", "write three components: `(0, 0, 150.0)`"),
        });
    }
    let (phrase, kind, content) = source.group(input)?;
    if kind != Delimiter::Parenthesis {
        source.report(phrase, "the components of a vector are in parentheses", "write `(0, 0, 150.0)`");
    }
    let mut parts = Vec::new();
    let mut missing_comma = false;
    while !content.is_empty() {
        parts.push(expression(&content, source)?);
        let comma = content.parse::<Option<Token![,]>>()?.is_some();
        if content.peek(Token![:]) {
            let at = source.phrase(content.span(), content.span());
            return Err(refused(at, "components have no names", "write three numbers: `(0, 0, 150.0)`"));
        }
        if !comma && !content.is_empty() {
            if peeked(&content).is_some_and(|token| matches!(token, TokenTree::Punct(_))) {
                return Err(expected(&content, "`,`", "separate the components with commas"));
            }
            if !missing_comma {
                let at = source.phrase(content.span(), content.span());
                source.report(at, "expected `,`", "separate the components with commas");
            }
            missing_comma = true;
        }
    }
    if parts.len() != 3 {
        let decimal_comma = parts.len() > 3 && parts.iter().all(|part| matches!(part.kind, ExprKind::Number(..)));
        let help =
            if decimal_comma { "write `(x, y, z)`; a decimal point is written `.`" } else { "write `(x, y, z)`" };
        return Err(refused(phrase, format!("a vector has three components, found {}", parts.len()), help));
    }
    Ok(Vector { phrase, parts })
}
